#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The oldest Linux that what is shipped runs on, and what would not run there: oldest_system.py OBJDUMP FILE...

Prints the symbols that ask for a later system library; exits with 1 if there are some.
"""
import re
import subprocess
import sys

TAG = (2, 34)  # of wheels, manylinux_2_34: glibc's version, with the library of GCC 11
LATEST = {"GLIBC": TAG, "GLIBCXX": (3, 4, 29), "CXXABI": (1, 3, 13), "GCC": (7, 0, 0)}


def later_symbols(listing):
    """Of `objdump -T`: the symbols, with their versions, that are not in the libraries of that system."""
    for library, version, symbol in re.findall(rf" \(?({'|'.join(LATEST)})_([0-9.]+)\)?\s+(\S+)$", listing, re.M):
        if tuple(map(int, version.split("."))) > LATEST[library]:
            yield f"{symbol} of {library}_{version}"


def breaches(objdump, file):
    listing = subprocess.run([objdump, "-T", file], capture_output=True, text=True, check=True).stdout
    wanted = ", ".join(f"{library}_{'.'.join(map(str, version))}" for library, version in LATEST.items())
    return [f"{file}: found {symbol}, wanted at most {wanted}" for symbol in later_symbols(listing)]


if __name__ == "__main__":
    sys.exit("\n".join(breach for file in sys.argv[2:] for breach in breaches(sys.argv[1], file)) or 0)
