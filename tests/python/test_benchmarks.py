# SPDX-License-Identifier: Apache-2.0
"""The benchmarks with tiny sizes: contenders agree, every row is there, and only the block of Python is filled."""
import re
import subprocess
import sys

from conftest import ROOT

PAGE = ROOT / "docs/benchmarks.md"
START, END = "<!-- python: written by benchmarks/python/run.py -->\n", "<!-- end of python -->"
ROW = re.compile(r"\| .+ \| [\d.e+]+ (s|ms|µs) \| [\d.e+]+ (s|ms|µs) \| [\d.e+]+ × \| ≥ [\d.]+ × \| (met|\*\*missed\*\*) \|")


def test_the_block_of_the_page_is_filled(tmp_path):
    page = tmp_path / "benchmarks.md"
    page.write_text(PAGE.read_text("utf-8"), "utf-8")
    done = subprocess.run([sys.executable, ROOT / "benchmarks/python/run.py", "--sizes", "smoke", "--document", page],
                          capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    (before, rest), (was_before, was_rest) = (text.read_text("utf-8").split(START) for text in (page, PAGE))
    assert before == was_before and rest.split(END)[1] == was_rest.split(END)[1]
    table = [line for line in rest.split(END)[0].splitlines() if line.startswith("| ")][1:]
    assert len(table) == 29 and all(ROW.fullmatch(line) for line in table), table


def test_a_contender_that_is_wrong_is_not_timed():
    code = ("import sys; sys.path.insert(0, sys.argv[1])\nimport questions\nquestions.LARGEST_KEY_ERROR = -1.0\nquestions.Track(10, 50)")
    done = subprocess.run([sys.executable, "-c", code, ROOT / "benchmarks/python"], capture_output=True, text=True, check=False)
    assert done.returncode == 1 and done.stderr.startswith("benchmarks: auto of 10 keys at its keys is off by ")
