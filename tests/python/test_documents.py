# SPDX-License-Identifier: Apache-2.0
"""What the documents print runs as printed, and the examples print what their twins in C++ print."""
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLES = sorted((ROOT / "examples/python").glob("0*.py"))


NOT_RUN = "(not run by the tests)"


def blocks_of(document):
    text = (ROOT / document).read_text("utf-8")
    return [block for block in re.findall(r"^```python\n(.*?)^```$", text, re.MULTILINE | re.DOTALL) if NOT_RUN not in block]


@pytest.mark.parametrize("document", ["README.md", "docs/python.md"])
def test_blocks_run_one_after_the_other(document, tmp_path):
    blocks = blocks_of(document)
    assert blocks
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    done = subprocess.run([sys.executable, "-W", "error", "-c", "\n".join(blocks)], cwd=tmp_path, capture_output=True, text=True,
                          env={"MPLBACKEND": "Agg", "PATH": "/usr/bin:/bin"}, check=False)
    assert done.returncode == 0, done.stderr
    assert done.stderr == ""
    for shown in re.findall(r"^```text\n(.*?)^```$", (ROOT / document).read_text("utf-8"), re.MULTILINE | re.DOTALL):
        assert shown in done.stdout


def test_blocks_of_many_tracks_run_one_after_the_other(tmp_path):
    """Those of Spark only where there is Java; Spark has warnings of its own."""
    blocks = blocks_of("docs/scale.md")
    runs = [block for block in blocks if "spark" not in block] if shutil.which("java") is None else blocks
    assert len(runs) >= 6 and len(blocks) == len(re.findall("^```python$", (ROOT / "docs/scale.md").read_text("utf-8"), re.MULTILINE)) - 3
    done = subprocess.run([sys.executable, "-c", "\n".join(runs)], cwd=tmp_path, capture_output=True, text=True, check=False,
                          env=os.environ | {"SPARK_LOCAL_IP": "127.0.0.1", "PYSPARK_PYTHON": sys.executable})
    assert done.returncode == 0, done.stderr
    for shown in re.findall(r"^```text\n(.*?)^```$", (ROOT / "docs/scale.md").read_text("utf-8"), re.MULTILINE | re.DOTALL):
        assert shown in done.stdout


def test_readme_is_an_example():
    text = (ROOT / "examples/python/readme.py").read_text("utf-8")
    assert [text.split("\n", 2)[2]] == blocks_of("README.md")


def test_every_example_has_a_twin():
    assert [example.stem for example in EXAMPLES] == sorted(twin.stem for twin in (ROOT / "examples").glob("0[1-7]*.cpp"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.stem)
def test_examples_print_what_their_twins_print(example, tmp_path):
    done = subprocess.run([sys.executable, "-W", "error", example], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == (ROOT / "examples/expected" / f"{example.stem}.txt").read_text("utf-8")
