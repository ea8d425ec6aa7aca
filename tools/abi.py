#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The binary interface of the shared libraries, as abidw of libabigail writes it.

abi.py write DEB FOLDER: of the build of the Debian packages in DEB (build/deb), into FOLDER, a file for each library, named after its shared object.
abi.py compare DEB: with those in packaging/abi that have the same name, which a release has written. It ends with 1 where a program that was
built against such a library would no longer work; names that came are told.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
KEPT = ROOT / "packaging/abi"
INCOMPATIBLE, WRONG = 8, 1 | 2  # bits of abidiff's exit status
FORM = ("--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-architecture", "--drop-private-types", "--drop-undefined-syms",
        "--exported-interfaces-only", "--type-id-style", "hash")


def libraries(deb):
    """The shared libraries of the build, which still have what debuggers read; each with its name for the linker."""
    found = {}
    for path in sorted(deb.glob("orispline-*/obj-*/**/liborispline*.so.*")):
        name = re.search(r"SONAME +(\S+)", subprocess.run(["objdump", "-p", path], check=True, capture_output=True, text=True).stdout)
        if name:
            found[name[1]] = path.resolve()
    if not found:
        sys.exit(f"abi.py: found no shared library in {deb}, wanted the build of the Debian packages: run make deb")
    return found


def write(deb, folder):
    """The files, named after the libraries."""
    if not shutil.which("abidw"):
        sys.exit("abi.py: found no abidw; install the package abigail-tools")
    headers, = deb.glob("orispline-*/debian/tmp/usr/include")
    folder.mkdir(parents=True, exist_ok=True)
    written = []
    for name, library in libraries(deb).items():
        written.append(folder / f"{name}.abi")
        subprocess.run(["abidw", *FORM, "--headers-dir", headers, "--out-file", written[-1], library], check=True)
    return written


def compare(deb):
    """Whether all that were built against what is kept still work."""
    with tempfile.TemporaryDirectory() as folder:
        works = True
        for now in write(deb, pathlib.Path(folder)):
            kept = KEPT / now.name
            if not kept.is_file():
                print(f"{now.name}: none is kept, so there is nothing to compare with")
                continue
            status = subprocess.run(["abidiff", kept, now], check=False).returncode
            works = works and not status & (INCOMPATIBLE | WRONG)
            print(f"{now.name}: {'as it was' if status == 0 else 'incompatible' if status & INCOMPATIBLE else 'changed'}")
        return works


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    orders = parser.add_subparsers(dest="order", required=True)
    for order in ("write", "compare"):
        orders.add_parser(order).add_argument("deb", type=pathlib.Path)
    orders.choices["write"].add_argument("folder", type=pathlib.Path)
    options = parser.parse_args()
    if options.order == "write":
        return write(options.deb, options.folder)
    return sys.exit(0 if compare(options.deb) else 1)


if __name__ == "__main__":
    main()
