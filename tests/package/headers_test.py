#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Each of these installed headers can be included alone, and twice: headers_test.py FOLDER HEADERS COMPILER OPTIONS...

FOLDER is where they are installed, HEADERS a pattern such as orispline/**/*.hpp. Eigen's headers, which take most of the
time, are read once by GCC; what a header needs of the others it has to include.
"""
import concurrent.futures
import os
import pathlib
import subprocess
import sys
import tempfile

WARNINGS = ["-Wall", "-Wextra", "-Wconversion", "-Wsign-conversion", "-Wshadow", "-Wpedantic", "-Werror"]


def main():
    folder, pattern, compiler, *options = sys.argv[1:]
    folder = pathlib.Path(folder)
    command = [compiler, "-std=c++20", "-DEIGEN_MAX_ALIGN_BYTES=16", "-I", folder, *options]
    headers = sorted(path.relative_to(folder).as_posix() for path in folder.glob(pattern))
    assert headers, f"no {pattern} in {folder}"
    with tempfile.TemporaryDirectory() as made:
        if "clang" not in compiler:
            first = pathlib.Path(made, "first.hpp")
            first.write_text("#include <Eigen/Geometry>\n", "utf-8")
            subprocess.run([*command, *WARNINGS, "-x", "c++-header", first, "-o", f"{first}.gch"], check=True)
            command += ["-include", first]

        def fault(header):
            text = f"#include <{header}>\n" * 2
            run = subprocess.run([*command, *WARNINGS, "-fsyntax-only", "-x", "c++", "-"], input=text, capture_output=True, text=True)
            return f"{header}:\n{run.stderr}" if run.returncode else ""

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            faults = [f for f in pool.map(fault, headers) if f]
    print(f"{len(headers)} installed headers")
    sys.exit("\n".join(faults) or 0)


main()
