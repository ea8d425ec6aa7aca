#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""oldest_system.py finds the symbols of later systems and no others."""
import pathlib
import re
import unittest

import oldest_system

ROOT = pathlib.Path(__file__).resolve().parents[2]

LISTING = """
0000000000000000      DF *UND*	0000000000000000 (GLIBC_2.35) hypot
0000000000000000      DF *UND*	0000000000000000 (GLIBC_2.2.5) free
0000000000000000      DF *UND*	0000000000000000  GLIBC_2.34   __libc_start_main
0000000000000000      DF *UND*	0000000000000000 (GLIBCXX_3.4.30) _ZNSt3fooEv
0000000000000000      DF *UND*	0000000000000000 (GLIBCXX_3.4.9) _ZSt4cout
0000000000000000      DF *UND*	0000000000000000 (OTHER_9) other
0000000000000000  w   D  *UND*	0000000000000000  Base        __gmon_start__
0000000000983148 g    DO .bss	0000000000000001 (GLIBC_2.36) copied
"""


class OldestSystem(unittest.TestCase):
    def test_finds_what_is_later(self):
        found = list(oldest_system.later_symbols(LISTING))
        self.assertEqual(found, ["hypot of GLIBC_2.35", "_ZNSt3fooEv of GLIBCXX_3.4.30", "copied of GLIBC_2.36"])

    def test_wheels_are_built_on_that_system(self):
        images = re.findall(r'^manylinux-.*-image = "manylinux_(\d+)_(\d+)"$', (ROOT / "pyproject.toml").read_text("utf-8"), re.M)
        self.assertEqual({tuple(map(int, image)) for image in images}, {oldest_system.TAG})


if __name__ == "__main__":
    unittest.main()
