#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The core of the library uses no streams and no locales, which are the larger part of a small program of WebAssembly:
no_streams_test.py NM ARCHIVE."""
import re
import subprocess
import sys
import unittest

STREAMS = re.compile(r"std::(?:\w+::)*(?:locale|ios_base|basic_[io]{1,2}(?:string|f)?stream|basic_streambuf)\b")


class NoStreams(unittest.TestCase):
    def test_the_core_asks_for_no_streams_and_no_locales(self):
        run = subprocess.run([NM, "-C", "--undefined-only", ARCHIVE], capture_output=True, text=True, check=True)
        names = [line.split(" U ", 1)[1] for line in run.stdout.splitlines() if " U " in line]
        self.assertTrue(any("operator new" in name for name in names), "nm lists no names")
        self.assertEqual([name for name in names if STREAMS.search(name)], [])

    def test_streams_are_known_by_their_names(self):
        for name in ("std::locale::classic()", "std::__cxx11::basic_ostringstream<char>::str()", "std::__2::locale::~locale()",
                     "std::istream& std::basic_istream<char>::_M_extract<double>(double&)", "std::ios_base::Init::Init()"):
            self.assertTrue(STREAMS.search(name), name)
        self.assertFalse(STREAMS.search("std::basic_string<char>::append(char const*)"))


if __name__ == "__main__":
    NM, ARCHIVE = sys.argv.pop(1), sys.argv.pop(1)
    unittest.main()
