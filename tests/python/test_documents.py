# SPDX-License-Identifier: Apache-2.0
"""The Python of the documents runs as printed, and the examples print what their twins in C++ print."""
import importlib.util
import os
import pathlib
import re
import shutil
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).parents[2]
PROGRAMS = pathlib.Path(sys.executable).parent
os.environ.setdefault("ORISPLINE_COMMAND", str(PROGRAMS / "orispline"))
sys.path[:0] = [str(ROOT / "tests/shown")]
from given import give  # noqa: E402
from lines import run, shell_of  # noqa: E402
from pages import all_blocks, blocks, outputs_of  # noqa: E402

EXAMPLES = sorted((ROOT / "examples/python").glob("0*.py"))
NOT_RUN = re.compile(r"\(not run by the tests: .*\)")
C_LIBRARY = ROOT / "build/python/prefix/lib/liborispline_c.so.1"
OWN = "import numpy as np\nimport orispline as ori\n"
GIVEN = {  # what the blocks of a page take as the reader's own
    "README.md": "",
    "docs/align.md": OWN + "estimate, truth = ori.read('estimate.csv'), ori.read('truth.csv')\nother = estimate\n",
    "docs/c.md": "",
    "docs/coming-from.md": "",
    "docs/files.md": OWN + "import numpy\nori.read('keys.csv').curve().sample(rate=100).write('motion.npy')\n",
    "docs/mean.md": OWN + """
import pyarrow, pyarrow.parquet
import orispline.tables as tables
keys = monday = tuesday = ori.read('recording.csv')
q, w = keys.rotations, np.ones(len(keys))
columns = dict(zip(["qx", "qy", "qz", "qw"], q.T), camera=np.arange(len(q)) % 3)
pyarrow.parquet.write_table(pyarrow.table(columns), "shots.parquet")
""",
    "docs/papers.md": "",
    "docs/python.md": "",
    "docs/scale.md": "",
}
WARNS = {"docs/coming-from.md", "docs/scale.md"}  # for other libraries and Spark have warnings of their own


def runnable(page):
    """The blocks of Python of a page that run here, as one program: those of Spark only where there is Java, PGF where there is LaTeX, and
    those with the libraries of others where these are installed."""
    code = [block.text for block in blocks(page) if block.use == "python" and not NOT_RUN.search(block.text)]
    if page == "docs/coming-from.md":
        code = [text for text in code if all(map(importlib.util.find_spec, re.findall(r"^(?:import|from) (\w+)", text, re.M)))]
    if shutil.which("java") is None:
        code = [text for text in code if "spark" not in text]
    text = "\n".join(code)
    return text if shutil.which("xelatex") else re.sub(r".*\.pgf.*\n", "", text)


def test_every_page_with_python_is_run():
    assert {block.page for block in all_blocks() if block.use == "python"} == set(GIVEN)
    assert {block.page for block in all_blocks() if block.use == "python" and "not run" in block.text} == {"docs/scale.md"}


@pytest.mark.parametrize("page", GIVEN)
def test_blocks_run_one_after_the_other(page, tmp_path):
    code = GIVEN[page] + runnable(page)
    give(tmp_path, page, set(re.findall(r"[\w.-]+", code)))
    if page == "docs/c.md":
        if not C_LIBRARY.exists():
            pytest.skip(f"{C_LIBRARY} is not here")
        (tmp_path / ".local/lib").mkdir(parents=True)
        (tmp_path / ".local/lib" / C_LIBRARY.name).symlink_to(C_LIBRARY)
    made = [line for line in shell_of(page) if "--output-folder papers" in line.text]
    assert len(run(made, tmp_path, PROGRAMS)) == len(made) + 1
    done = subprocess.run([sys.executable, *([] if page in WARNS else ["-W", "error"]), "-c", code], cwd=tmp_path, capture_output=True, text=True, check=False,
                          env=os.environ | {"MPLBACKEND": "Agg", "HOME": str(tmp_path), "SPARK_LOCAL_IP": "127.0.0.1", "PYSPARK_PYTHON": sys.executable})
    assert done.returncode == 0, done.stderr
    assert done.stderr == "" or page in WARNS
    for shown in outputs_of(page, "python"):
        assert shown.text in done.stdout


def test_lines_for_tables_run(tmp_path):
    lines = [line for line in shell_of("docs/scale.md") if line.text.startswith("orispline-tables ")]
    keys = blocks("docs/scale.md")[1].text
    sensors = """
from pyarrow.parquet import write_table
write_table(pa.table({"track": [3, 3, 70], "t": [1.0, 1.5, 2.0]}), "sensors.parquet")
"""
    subprocess.run([sys.executable, "-c", keys + sensors], cwd=tmp_path, check=True)
    printed = run(lines, tmp_path, PROGRAMS)
    assert len(printed) == len(lines) + 1 >= 4, printed[-1]


def test_readme_is_an_example():
    text = (ROOT / "examples/python/readme.py").read_text("utf-8")
    assert [text.split("\n", 2)[2]] == [block.text for block in blocks("README.md") if block.use == "python"]


def test_every_example_has_a_twin():
    assert [example.stem for example in EXAMPLES] == sorted(twin.stem for twin in (ROOT / "examples").glob("0[1-7]*.cpp"))


@pytest.mark.parametrize("example", EXAMPLES, ids=lambda example: example.stem)
def test_examples_print_what_their_twins_print(example, tmp_path):
    done = subprocess.run([sys.executable, "-W", "error", example], cwd=tmp_path, capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout == (ROOT / "examples/expected" / f"{example.stem}.txt").read_text("utf-8")
