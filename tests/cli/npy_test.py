#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""NumPy files: the same numbers as the CSV, to a file and to a pipe; and samples that do not depend on the threads."""
import ast
import json
import os
import shutil
import struct
import subprocess
import sys
import unittest

from command import BAD_DATA, BAD_USAGE, COMMAND, CommandTest, main, rows_of


def has_numpy(python):
    return bool(shutil.which(python)) and not subprocess.run([python, "-c", "import numpy"], capture_output=True, check=False).returncode


# This Python, or that of the package's environment.
PYTHON = next(filter(has_numpy, (sys.executable, os.environ.get("ORISPLINE_PYTHON", ""))), None)
READ = """import json, numpy, sys
array = numpy.load(sys.argv[1])
print(json.dumps([array.shape, array.dtype.str, array.flags.c_contiguous, array.tolist()]))"""

POSES = ("t,qw,qx,qy,qz,px,py,pz\n1700000000.123456789,1,0,0,0,0,0,0\n1700000001.5,0.6,0.8,0,0,4,-2,1\n"
         "1700000002,0.8,0,0.6,0,5,0,1e-9\n")


def array_of(content):
    """Shape and rows of a NumPy file, version 1.0, by NumPy Enhancement Proposal 1."""
    assert content[:8] == b"\x93NUMPY\x01\x00", content[:8]
    (length,) = struct.unpack("<H", content[8:10])
    header = ast.literal_eval(content[10:10 + length].decode("ascii"))
    assert (10 + length) % 64 == 0 and content[9 + length:10 + length] == b"\n"
    assert (header["descr"], header["fortran_order"]) == ("<f8", False), header
    rows, columns = header["shape"]
    numbers = struct.unpack(f"<{rows * columns}d", content[10 + length:])
    return (rows, columns), [list(numbers[i * columns:(i + 1) * columns]) for i in range(rows)]


class Arrays(CommandTest):
    def bytes_of(self, arguments, output):
        self.assertEqual(self.output_of(f"{arguments} -o {output}"), "")
        return (self.folder / output).read_bytes()

    def assert_same_as_csv(self, arguments, shape):
        content = self.bytes_of(arguments, "motion.npy")
        text = self.output_of(arguments.replace("--output-format npy", ""))
        self.assertEqual(array_of(content), (shape, rows_of(text)))
        self.assertEqual(len(text.splitlines()[0].split(",")), shape[1])
        return content

    def test_numbers_and_order_are_those_of_the_csv(self):
        self.assert_same_as_csv("sample keys.csv --method quintic --rate 7 --derivatives 3", (22, 14))
        self.assert_same_as_csv("sample keys.csv --method quintic --count 1", (1, 11))
        self.assert_same_as_csv("sample keys.csv --count 3 --derivatives 0 --output-orientation matrix", (3, 10))
        self.assert_same_as_csv("sample keys.csv --count 3 --output-orientation euler --frame world", (3, 10))

    def test_positions_their_rates_and_large_times(self):
        self.write("poses.csv", POSES)
        self.assert_same_as_csv("sample poses.csv --method quintic --rate 1000 --derivatives 2", (1877, 20))
        self.assert_same_as_csv("convert poses.csv", (3, 8))

    def test_the_option_wins_over_the_extension(self):
        asked = self.bytes_of("sample keys.csv --count 5 --output-format npy", "motion.csv")
        self.assertEqual(asked, self.bytes_of("sample keys.csv --count 5", "motion.NPY"))
        self.assertIn("t,qw", self.bytes_of("sample keys.csv --count 5 --output-format csv", "text.npy").decode("ascii"))

    def test_a_pipe_gets_the_same_bytes(self):
        piped = subprocess.run([COMMAND, *"sample keys.csv --count 5 --output-format npy".split()], cwd=self.folder,
                               capture_output=True, check=True).stdout
        self.assertEqual(piped, self.bytes_of("sample keys.csv --count 5", "motion.npy"))

    @unittest.skipUnless(PYTHON, "no numpy")
    def test_numpy_reads_it(self):
        content = self.assert_same_as_csv("sample keys.csv --count 1000", (1000, 11))
        done = subprocess.run([PYTHON, "-c", READ, "motion.npy"], cwd=self.folder, capture_output=True, check=True)
        self.assertEqual(json.loads(done.stdout), [[1000, 11], "<f8", True, array_of(content)[1]])

    def test_nothing_is_left_after_a_failure(self):
        self.write("times.txt", "0\n1\n9\n")
        done = self.run_command("sample keys.csv --times times.txt --extrapolate error -o motion.npy")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertEqual(sorted(path.name for path in self.folder.iterdir()), ["keys.csv", "times.txt"])

    def test_keys_are_not_read_from_it(self):
        self.bytes_of("sample keys.csv --count 5", "motion.npy")
        self.assert_fails("sample motion.npy --count 5", BAD_USAGE,
                          "motion.npy: keys are not read from NumPy files, wanted CSV, TUM, EuRoC, BVH or glTF")
        self.assert_fails("sample motion.npy --input-format npy --count 5", BAD_USAGE,
                          "--input-format: found 'npy', wanted csv|tum|euroc|bvh|gltf")


class Threads(CommandTest):
    def test_any_number_gives_the_same_file(self):
        for output in ("csv", "npy", "tum"):
            one, three = (self.folder / f"{threads}.{output}" for threads in (1, 3))
            for threads, path in ((1, one), (3, three)):
                self.output_of(f"sample keys.csv --count 120001 --threads {threads} -o {path.name}")
            self.assertEqual(one.read_bytes(), three.read_bytes())

    def test_euroc_finds_equal_nanoseconds_across_threads(self):
        stretch = 16384  # samples that a thread makes at a time
        self.write("times.txt", "\n".join(str(k / 1e4) for k in range(stretch)) + "\n1.63830000001\n")
        self.assert_fails("sample keys.csv --times times.txt --threads 2 --output-format euroc -o motion.csv", BAD_DATA,
                          "two samples fall on the nanosecond 1638300000, wanted times that differ in EuRoC")

    def test_a_number_that_cannot_be(self):
        for found in ("0", "-2", "many", "1025"):
            self.assert_fails(f"sample keys.csv --count 5 --threads={found}", BAD_USAGE,
                              f"--threads: found '{found}', wanted a whole number from 1 to 1024")


if __name__ == "__main__":
    main()
