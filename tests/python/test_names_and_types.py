# SPDX-License-Identifier: Apache-2.0
"""Public names, their docstrings and types: as they are written down, complete, and true."""
import doctest
import importlib
import importlib.util
import inspect
import pathlib
import pkgutil
import subprocess
import sys

import orispline as ori
import pytest
from conftest import ROOT

NAMES = pathlib.Path(__file__).parent / "data/public_names.txt"
EXTRAS = [extra for extra, needed in (("tables", "pyarrow"), ("spark", "pyspark"), ("notebook", "anywidget")) if importlib.util.find_spec(needed)]
MODULES = sorted(name for _, name, _ in pkgutil.walk_packages(ori.__path__, "orispline.", onerror=lambda _: None)
                 if name != "orispline._core" and (name.split(".")[1] in EXTRAS or name.split(".")[1] not in ("tables", "spark", "notebook")))
PACKAGE = pathlib.Path(ori.__file__).parent


def members(thing):
    """What a class adds to Python's own and to other public classes."""
    bases = [base for base in thing.__mro__ if base is thing or base.__module__.startswith("orispline.") and base.__name__ not in ori.__all__]
    own = {name for base in bases for name in [*vars(base), *inspect.get_annotations(base)]}
    return sorted(name for name in own if not name.startswith("_") or name == "__call__")


def public_names():
    for name in sorted(ori.__all__):
        yield name
        if inspect.isclass(getattr(ori, name)):
            yield from (f"{name}.{member}" for member in members(getattr(ori, name)))
    for extra in EXTRAS:
        yield from (f"{extra}.{name}" for name in importlib.import_module(f"orispline.{extra}").__all__)


def test_public_names_are_those_written_down():
    """A name that goes or comes is a decision, to be written down: this file, run as a program, does it."""
    written = NAMES.read_text("utf-8").split()
    assert list(public_names()) == [name for name in written if name.split(".")[0] in {*EXTRAS, *ori.__all__}]


def test_all_that_is_public_is_told():
    visible = {name for name, thing in vars(ori).items() if not name.startswith("_") and not inspect.ismodule(thing)}
    assert visible - {"annotations", "Any", "TYPE_CHECKING"} <= set(ori.__all__)


@pytest.mark.parametrize("name", sorted(ori.__all__))
def test_every_public_name_says_what_it_is(name):
    thing = getattr(ori, name)
    assert thing.__doc__ and not thing.__doc__.startswith(f"{name}("), "wanted a docstring of its own"
    if inspect.isclass(thing):
        for member in vars(thing):
            if callable(getattr(thing, member)) and not member.startswith("_"):
                assert getattr(thing, member).__doc__, member


@pytest.mark.parametrize("extra", EXTRAS)
def test_every_function_of_tables_says_what_it_is(extra):
    module = importlib.import_module(f"orispline.{extra}")
    assert module.__doc__ and all(getattr(module, name).__doc__ for name in module.__all__)


@pytest.mark.parametrize("module", ["orispline", *MODULES])
def test_examples_of_the_docstrings(module, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    found = doctest.testmod(importlib.import_module(module), optionflags=doctest.ELLIPSIS)
    assert not found.failed
    assert found.attempted or module not in {"orispline", "orispline._keys", "orispline._curve"}


def test_the_reference_has_every_public_name():
    text = (ROOT / "bindings/python/reference/index.rst").read_text("utf-8")
    told = {line.partition(":: ")[2] for line in text.splitlines() if line.startswith(".. auto")}
    assert {f"orispline.{name}" for name in ori.__all__} | {"orispline.tables", "orispline.spark", "orispline.notebook"} == told


def test_the_stub_is_that_of_the_module():
    """Write it anew by bindings/python/build.py FOLDER PREFIX --stub."""
    spec = importlib.util.spec_from_file_location("stub", ROOT / "bindings/python/stub.py")
    maker = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(maker)
    assert (PACKAGE / "_core.pyi").read_text("utf-8") == maker.stub()


def mypy(*words):
    """The code and the text that mypy ends with; what it knows of NumPy it keeps."""
    options = ["--strict", "--config-file", ROOT / "pyproject.toml", "--cache-dir", ROOT / "build/python/mypy"]
    done = subprocess.run([sys.executable, "-m", "mypy", *options, *words], capture_output=True, text=True, check=False, cwd=NAMES.parent)
    return done.returncode, done.stdout + done.stderr


def test_types_of_the_package():
    code, text = mypy("-p", "orispline")
    assert code == 0, text


SCALAR, ARRAY = "ndarray[tuple[int], dtype[float64]]", "ndarray[tuple[Any, ...], dtype[float64]]"
STACK = "ndarray[tuple[int, int], dtype[float64]]"
TYPES = {"curve(0.5)": SCALAR, "curve(np.float64(0.5))": SCALAR, "curve(1)": SCALAR, "curve(t)": ARRAY, "curve([0.1, 0.2])": ARRAY,
         "curve.angular_velocity(0.5)": SCALAR, "curve.angular_jerk(t, 'world')": ARRAY, "curve.position(t, threads=0)": ARRAY,
         "curve(t, out=np.empty((5, 4)))": STACK, "curve.angular_velocity(t, 'body', np.empty((5, 3)))": STACK,
         "curve.angle_travelled()": "float", "curve.angle_travelled(0.5)": "float", "curve.angle_travelled(t)": ARRAY, "curve.at_angle([0.1, 0.2])": ARRAY,
         "curve.motion(0.5, 'left').angular_velocity": ARRAY, "curve.bake(1e-9)(0.5)": "ndarray[tuple[int], dtype[Any]]",
         "stack(0.5)": STACK, "stack.angular_velocity(t)": ARRAY, "online(0.5)": SCALAR, "online(t)": ARRAY,
         "spline(0.5, 1)": SCALAR, "spline(t, 2)": ARRAY, "curve.sample(rate=100).times": "ndarray[Any, Any]",
         "ori.blending('mine', [[0, 1]], basis='power').with_settings(ends='rest')": "str",
         "ori.smooth(t, t, cutoff=8).noise": "float", "ori.tune(curve.keys, 'quintic').curve": "orispline._curve.Curve",
         "ori.compare(t, t, ['auto'])": "orispline._comparison.Comparison", "ori.reduce((t, t), '1deg').keys[3]": "orispline._keys.Keys",
         "curve.sample(rate='100 Hz')[3].time": "Any", "[s.orientation for s in curve.sample(rate=9)[:3]]": f"list[{ARRAY.replace('float64', 'Any')}]",
         "curve.at(0.5)": SCALAR, "curve.at(t)": ARRAY, "ori.mean(t, t, every='1s')": "list[orispline._mean.Mean]",
         "ori.mean(t)": "orispline._mean.Mean", "ori.mean(curve.keys, every='1s')": "list[orispline._mean.Mean]",
         "ori.compare(curve.keys, [ori.read_blending('mine.json'), curve, 'auto']).curve().method": "str",
         "ori.Curve(t, t, ori.blending('mine', np.eye(2))).domain": "tuple[Any, Any]"}
USE = """
import numpy as np
import orispline as ori

t = np.linspace(0, 1, 5)


def use(curve: ori.Curve, stack: ori.CurveStack, online: ori.OnlineCurve, spline: ori.RotationSpline) -> None:
"""


MISTAKES = {"curve.sampel(rate=1)": '"Curve" has no attribute "sampel"', "curve.motion(0.5, 'before')": 'Argument 2 to "motion"',
            "curve.angular_velocity(0.5, frame='camera')": 'No overload variant of "__call__" of "Rate"',
            "ori.Curve(t, t, extrapolate='far')": '"extrapolate" to "Curve"', "ori.Keys(t, t, signs='long')": '"signs" to "Keys"',
            "ori.blending('mine', t, basis='hermite')": '"basis" to "blending"', "curve.keys.curve(3)": 'Argument 1 to "curve"',
            "ori.tune(1, 'quintic')": 'No overload variant of "__call__" of "OfKeys"', "spline(t, 4)": 'No overload variant of "__call__"'}


@pytest.fixture(scope="module")
def told(tmp_path_factory):
    """What mypy says of the expressions and of the mistakes, of each in a line of its own, with short names; then of all."""
    path = tmp_path_factory.mktemp("types") / "use.py"
    lines = [*(f"reveal_type({expression})" for expression in TYPES), *MISTAKES]
    path.write_text(USE + "".join(f"    {line}\n" for line in lines), "utf-8")
    _, text = mypy("--hide-error-context", path)
    said = text.replace("numpy.", "").replace("builtins.", "").splitlines()
    first = USE.count("\n") + 1
    return {line: [each for each in said if f"use.py:{first + k}: " in each] for k, line in enumerate(lines)}, said[-1]


@pytest.mark.parametrize("expression", TYPES)
def test_times_of_one_kind_give_results_of_one_kind(expression, told):
    line, = told[0][f"reveal_type({expression})"]
    assert line.partition("Revealed type is ")[2].strip('"') == TYPES[expression]


@pytest.mark.parametrize("mistake", MISTAKES)
def test_a_users_mistakes_are_seen_by_the_types(mistake, told):
    lines, last = told
    assert "error: " in lines[mistake][0] and MISTAKES[mistake] in lines[mistake][0]
    assert f"Found {len(MISTAKES)} errors" in last


if __name__ == "__main__":
    NAMES.write_text("\n".join(public_names()) + "\n", "utf-8")
