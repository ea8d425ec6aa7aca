# SPDX-License-Identifier: Apache-2.0
"""What the package holds, and what importing it costs."""
import doctest
import importlib.metadata
import importlib.resources
import shutil
import subprocess
import sys

import orispline as ori
import pytest


def test_importing_brings_no_optional_package():
    optional = {"scipy", "matplotlib", "pandas", "pyarrow", "duckdb", "pyspark"}
    code = f"import sys, orispline; print(sorted({optional!r} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"


def test_the_command_is_in_it():
    command = shutil.which("orispline", path=str(importlib.resources.files("orispline") / "bin"))
    assert command
    done = subprocess.run([command, "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["orispline", ori.__version__]


def test_the_files_of_the_package():
    files = {str(file) for file in importlib.metadata.files("orispline") or []}
    assert {"orispline/py.typed", "orispline/__init__.py", "orispline/_core.abi3.so"} <= files
    assert any(name.endswith("licenses/LICENSE") for name in files) and any(name.endswith("licenses/NOTICE") for name in files)


@pytest.mark.parametrize("module", ["orispline", "orispline._keys", "orispline._curve", "orispline._online", "orispline._scipy_twins",
                                    "orispline._stack"])
def test_examples_of_the_docstrings(module):
    found = doctest.testmod(sys.modules[module])
    assert found.attempted and not found.failed


def test_every_public_name_says_what_it_is():
    for name in ori.__all__:
        assert getattr(ori, name).__doc__, name
    for thing in (ori.Keys, ori.Curve, ori.CurveStack, ori.OnlineCurve, ori.RotationSpline, ori.Slerp):
        for name in dir(thing):
            assert name.startswith("_") or getattr(thing, name).__doc__, name
