#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A program in C finds the installed library by pkg-config, is compiled without a warning, and prints what is expected:
c_program_test.py PREFIX LIBRARY_FOLDER COMPILER PROGRAM EXPECTED.

The tree is moved first, for it may lie anywhere.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

STRICT = ["-x", "c", "-std=c11", "-Wall", "-Wextra", "-pedantic", "-Werror"]


def main():
    prefix, libraries, compiler, program, expected = sys.argv[1:]
    with tempfile.TemporaryDirectory() as made:
        moved = pathlib.Path(made, "elsewhere")
        for folder in ("include", libraries):
            shutil.copytree(pathlib.Path(prefix, folder), moved / folder, symlinks=True, ignore=shutil.ignore_patterns("*.a"))
        environment = os.environ | {"PKG_CONFIG_PATH": str(moved / libraries / "pkgconfig"), "LD_LIBRARY_PATH": str(moved / libraries)}
        options = subprocess.run(["pkg-config", "--cflags", "--libs", "orispline_c"], env=environment, capture_output=True,
                                 text=True, check=True).stdout.split()
        binary = moved / "program"
        subprocess.run([compiler, *STRICT, program, "-x", "none", *options, "-o", binary], check=True)
        found = subprocess.run([binary], env=environment, capture_output=True, text=True, check=True).stdout
    if found != pathlib.Path(expected).read_text("utf-8"):
        sys.exit(f"found\n{found}wanted\n{pathlib.Path(expected).read_text('utf-8')}")


main()
