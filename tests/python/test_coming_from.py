# SPDX-License-Identifier: Apache-2.0
"""Every line of docs/coming-from.md: theirs beside ours, where their package is installed."""
import re
import sys
import warnings

import numpy as np
import pytest
from conftest import ROOT

sys.path[:0] = [str(ROOT / "tests/shown")]
from pages import FENCE  # noqa: E402

TEXT = (ROOT / "docs/coming-from.md").read_text("utf-8")
GIVEN, *SECTIONS = re.split(r"^## ", TEXT, flags=re.M)
ROW = re.compile(r"^\| `(?P<theirs>[^`]+)` \| `(?P<ours>[^`]+)` \| (?P<differs>.*) ?\|$", re.M)
LINES = [pytest.param(section, row, id=f"{section.split(maxsplit=1)[0]}-{number}")
         for section in SECTIONS for number, row in enumerate(ROW.finditer(section))]


def code_of(text):
    return "".join(fence["text"] for fence in FENCE.finditer(text))


def test_every_line_of_the_tables_is_found():
    lines = [line for section in SECTIONS for line in section.splitlines() if line.startswith("| `") and "| orispline |" not in line]
    assert len(lines) == len(LINES) > 35
    assert [section.split(maxsplit=1)[0] for section in SECTIONS] == [
        "SciPy", "pandas", "Polars", "pyquaternion", "quaternionic", "rowan", "splines", "transforms3d", "spatialmath"]


@pytest.mark.parametrize(("section", "row"), LINES)
def test_their_line_and_ours_give_the_same(section, row):
    for module in re.findall(r"^(?:import|from) (\w+)", code_of(section), re.M):
        pytest.importorskip(module)
    names = {}
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # theirs
        exec(code_of(GIVEN) + code_of(section), names)
        theirs, ours = (np.asarray(eval(row[side], names), float) for side in ("theirs", "ours"))
    if theirs.shape[-1:] == (4,):  # of quaternions neither sign is the right one
        theirs = theirs * np.where((theirs * ours).sum(axis=-1, keepdims=True) < 0, -1, 1)
    assert np.allclose(theirs, ours, rtol=0, atol=1e-8) is not row["differs"].startswith("**not the same**")
