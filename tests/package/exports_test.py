#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The shared library exports names of its own and no others: exports_test.py NM LIBRARY."""
import subprocess
import sys
import unittest

AT_MOST = 930


def exported(library):
    lines = subprocess.run([NM, "-D", "-C", "--defined-only", library], capture_output=True, text=True, check=True).stdout
    return [line.split(" ", 2)[2] for line in lines.splitlines()]


class Exports(unittest.TestCase):
    def test_names_of_others_stay_inside(self):
        names = exported(LIBRARY)
        foreign = [name for name in names if "orispline::" not in name.split("(")[0]]
        self.assertEqual(foreign, [])
        self.assertTrue(any("make_curve" in name for name in names))
        self.assertLess(len(names), AT_MOST)


if __name__ == "__main__":
    NM, LIBRARY = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
