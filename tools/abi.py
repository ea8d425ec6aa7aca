#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The binary interface of the shared libraries, as abidw of libabigail writes it.

abi.py write DEB FOLDER: of the build of the Debian packages in DEB (build/deb), into FOLDER, a file for each library, named after its shared object.
abi.py compare DEB: with those in packaging/abi that have the same name, which a release has written. It ends with 1 where a program that was built
against such a library would no longer work. Names may come.
"""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FOLDER = "packaging/abi"  # of what releases have written
KEPT = ROOT / FOLDER
FORM = ("--no-corpus-path", "--no-comp-dir-path", "--no-show-locs", "--no-architecture", "--drop-private-types", "--drop-undefined-syms",
        "--exported-interfaces-only", "--type-id-style", "hash")
# What others define is theirs to keep; with it the file would be fifty times as long.
OF_OTHERS = """[suppress_type]
name_regexp = ^(Eigen|std|tl|fmt|nlohmann|__gnu_cxx)::
drop = yes
[suppress_function]
symbol_name_not_regexp = orispline
drop = yes
"""


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
    with tempfile.NamedTemporaryFile("w", suffix=".ini") as others:
        others.write(OF_OTHERS)
        others.flush()
        for name, library in libraries(deb).items():
            written.append(folder / f"{name}.abi")
            subprocess.run(["abidw", *FORM, "--suppressions", others.name, "--headers-dir", headers, "--out-file", written[-1], library], check=True)
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
            same = subprocess.run(["abidiff", "--no-added-syms", kept, now], check=False).returncode == 0  # of a struct that grew its status says only "changed"
            works = works and same
            print(f"{now.name}: {'what was there is as it was' if same else 'programs that use it would have to be compiled anew'}")
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
