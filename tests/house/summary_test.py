#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/summary.py on a small run: its groups, and every way in which a test says that it skipped something."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SUMMARY = pathlib.Path(__file__).resolve().parents[1] / "summary.py"
RUN = """<?xml version="1.0"?>
<testsuite name="run">
  <testcase name="math_tests.So3.Exp" time="1.5" status="run"><system-out>[       OK ] So3.Exp</system-out></testcase>
  <testcase name="io_test" time="2" status="run"><system-out>[ RUN      ] OutputFile.IsKept
/tests/io/output_file_test.cpp:12: Skipped
root may write everywhere

[  SKIPPED ] OutputFile.IsKept (0 ms)</system-out></testcase>
  <testcase name="cli.npy" time="3" status="run"><system-out>skipped: Arrays.test_numpy_reads_it: no numpy</system-out></testcase>
  <testcase name="scenes.three" time="4" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/>
    <system-out>skipped: the registry of npm cannot be reached</system-out></testcase>
  <testcase name="page.report.page" time="5" status="notrun"><skipped message="SKIP_RETURN_CODE=77"/>
    <system-out>page: skipped, Chromium is not here</system-out></testcase>
  <testcase name="python.tests" time="7" status="run"><system-out>SKIPPED [2] tests/python/test_view.py:9: no Chromium here</system-out></testcase>
  <testcase name="site.build" time="8" status="notrun"><skipped message="SKIP_REGULAR_EXPRESSION_MATCHED"/>
    <system-out>site: skipped: found no doxygen</system-out></testcase>
  <testcase name="package.headers" time="6" status="notrun"><skipped message="Unable to find executable"/></testcase>
</testsuite>
"""
SAID = """Time of the tests, added up [s]:
  library, C++          3.5 in 2 tests
  package               6.0 in 1 tests
  command               7.0 in 2 tests
  pages and studio      5.0 in 1 tests
  Python                7.0 in 1 tests
  house and site        8.0 in 1 tests
Skipped: 7
  io_test: root may write everywhere
  cli.npy: Arrays.test_numpy_reads_it: no numpy
  scenes.three: the registry of npm cannot be reached
  page.report.page: page: skipped, Chromium is not here
  python.tests: tests/python/test_view.py:9: no Chromium here
  site.build: site: skipped: found no doxygen
  package.headers: Unable to find executable
"""


class Summary(unittest.TestCase):
    def test_tells_times_by_group_and_every_skip_with_its_reason(self):
        with tempfile.NamedTemporaryFile("w", suffix=".xml") as run:
            run.write(RUN)
            run.flush()
            done = subprocess.run([sys.executable, SUMMARY, run.name], capture_output=True, text=True, check=True)
        self.assertEqual(done.stdout, SAID)


if __name__ == "__main__":
    unittest.main()
