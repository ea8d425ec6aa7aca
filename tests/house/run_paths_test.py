#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No program of ours looks for libraries in the folder where it is run: an empty entry of RPATH or RUNPATH means that one.

run_paths_test.py COMPILER PROGRAM_OR_FOLDER...
"""
import mmap
import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import unittest

PT_LOAD, PT_DYNAMIC = 1, 2
DT_STRTAB, DT_RPATH, DT_RUNPATH = 5, 15, 29


def words(order, wide, data, at, count):
    """This many numbers of the machine's word."""
    return struct.unpack_from(order + ("Q" if wide else "I") * count, data, at)


def segments(data, order, wide):
    """(type, offset, address, size in the file) of each program header."""
    (table,) = words(order, wide, data, 32 if wide else 28, 1)
    size, count = struct.unpack_from(order + "HH", data, 54 if wide else 42)
    for at in range(table, table + size * count, size):
        (kind,) = struct.unpack_from(order + "I", data, at)
        offset, address, _, file_size = words(order, wide, data, at + (8 if wide else 4), 4)
        yield kind, offset, address, file_size


def run_paths(data):
    """Every entry of RPATH and RUNPATH of the bytes of an ELF file, in order."""
    wide, order = data[4] == 2, "<" if data[5] == 1 else ">"
    parts = list(segments(data, order, wide))
    entries = []
    for _, offset, _, size in (part for part in parts if part[0] == PT_DYNAMIC):
        count = size // (16 if wide else 8)
        numbers = words(order, wide, data, offset, 2 * count)
        entries += zip(numbers[::2], numbers[1::2])
    paths = []
    for place in (value for tag, value in entries if tag in (DT_RPATH, DT_RUNPATH)):
        names = next(value for tag, value in entries if tag == DT_STRTAB)
        load = next(p for p in parts if p[0] == PT_LOAD and p[2] <= names < p[2] + p[3])
        begin = load[1] + names - load[2] + place
        paths += data[begin:data.find(b"\0", begin)].decode().split(":")
    return paths


def run_paths_of(file):
    with file.open("rb") as stream, mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ) as data:
        return run_paths(data)


def programs(place):
    """The ELF files that may be run or loaded, below a folder; without CMake's trials and programs of users, which tests
    may be linking just now."""
    files = [place] if place.is_file() else [file for file in place.rglob("*") if not {"CMakeFiles", "package"} & {*file.parts}]
    for file in files:
        if file.is_file() and not file.is_symlink() and os.access(file, os.X_OK):
            with file.open("rb") as stream:
                if stream.read(4) == b"\x7fELF":
                    yield file


class RunPaths(unittest.TestCase):
    def test_an_empty_entry_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            source, program = pathlib.Path(folder, "main.c"), pathlib.Path(folder, "program")
            source.write_text("int main(void) { return 0; }\n", "utf-8")
            subprocess.run([COMPILER, "-x", "c++", source, "-o", program, "-Wl,-rpath,/somewhere::"], check=True)
            self.assertEqual(run_paths_of(program), ["/somewhere", "", ""])

    def test_no_program_of_ours_has_one(self):
        found = [file for place in PLACES for file in programs(place)]
        self.assertTrue(found, f"wanted programs, found none below {PLACES}")
        for file in found:
            with self.subTest(program=str(file)):
                self.assertNotIn("", run_paths_of(file))


if __name__ == "__main__":
    COMPILER, PLACES = sys.argv[1], [pathlib.Path(name) for name in sys.argv[2:]]
    unittest.main(argv=sys.argv[:1])
