# SPDX-License-Identifier: Apache-2.0
"""What the wheel holds, and what importing it brings."""
import importlib.metadata
import importlib.resources
import importlib.util
import json
import pathlib
import re
import shutil
import subprocess
import sys
import zipfile

import orispline as ori
import pytest
from conftest import ROOT, wheel

OPTIONAL = {"anywidget", "traitlets", "scipy", "matplotlib", "pandas", "pyarrow", "duckdb", "polars", "pyspark", "IPython"}


def oldest_system():
    """tests/house/oldest_system.py, where the numbers are stated."""
    spec = importlib.util.spec_from_file_location("oldest_system", ROOT / "tests/house/oldest_system.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def printed(code):
    """What another Python says."""
    return subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip()


def test_importing_brings_no_optional_package():
    assert printed(f"import sys, orispline; print(sorted({OPTIONAL!r} & set(sys.modules)))") == "[]"


def test_using_a_curve_brings_no_optional_package():
    work = "c = orispline.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]); c(0.5); c.sample(rate=9, derivatives=3); repr(c)"
    assert printed(f"import sys, orispline; {work}; print(sorted({OPTIONAL!r} & set(sys.modules)))") == "[]"


def test_the_command_is_in_it():
    command = shutil.which("orispline", path=str(importlib.resources.files("orispline") / "bin"))
    assert command
    done = subprocess.run([command, "--version"], capture_output=True, text=True, check=True)
    assert done.stdout.split() == ["orispline", ori.__version__]


def test_the_script_is_the_command():
    done = subprocess.run([sys.executable, "-c", "import orispline._command as c; c.main()", "methods", "--json"],
                          capture_output=True, text=True, check=True)
    assert [method["name"] for method in json.loads(done.stdout)] == [method["name"] for method in ori.methods()]
    entry, = importlib.metadata.entry_points(group="console_scripts", name="orispline")
    assert entry.value == "orispline._command:main"


def test_the_files_of_the_package():
    files = {str(file) for file in importlib.metadata.files("orispline") or []}
    assert {"orispline/py.typed", "orispline/look.json", "orispline/_core.pyi", "orispline/__init__.py", "orispline/_core.abi3.so"} <= files
    assert all(any(name.endswith(f"licenses/{text}") for name in files) for text in ("LICENSE", "NOTICE", "THIRD_PARTY"))


def test_what_the_examples_import_comes_with_all():
    """Importing needs names of modules, installing those of packages: here they are the same."""
    extras = [word for word in importlib.metadata.requires("orispline") if 'extra == "all"' in word or "extra == 'all'" in word]
    installed = {re.match(r"[\w-]+", word)[0] for word in extras} | {"numpy", "orispline", *sys.stdlib_module_names}
    for example in (ROOT / "examples/python").glob("*.py"):
        imported = {name.split(".")[0] for name in re.findall(r"^(?:from|import) ([\w.]+)", example.read_text("utf-8"), re.M)}
        assert imported <= installed | {path.stem for path in example.parent.glob("*.py")}, example.name


def test_the_metadata():
    about = importlib.metadata.metadata("orispline")
    assert about["Version"] == ori.__version__ and about["Requires-Python"] == ">=3.10" and about["License-Expression"] == "Apache-2.0"
    assert set(about.get_all("Provides-Extra")) == {"plot", "notebook", "tables", "spark", "all"}
    plain = [wanted for wanted in importlib.metadata.requires("orispline") if "extra ==" not in wanted]
    assert sorted(wanted.split(">")[0] for wanted in plain) == ["nanobind-backend", "numpy"]


@pytest.mark.skipif(sys.platform != "linux" or not wheel(), reason="no wheel beside the tests")
def test_the_wheel_stands_alone_and_serves_every_python():
    with zipfile.ZipFile(wheel()) as archive:
        names = archive.namelist()
        tags = archive.read(f"orispline-{ori.__version__}.dist-info/WHEEL").decode()
    beside = [name for name in names if ".libs/" in name and not name.endswith("/")]
    assert all("libmeshoptimizer" in name for name in beside), "libraries beside the module"
    assert "Tag: cp310-abi3-manylinux_2_" in tags and "-cp310-abi3-manylinux_2_" in wheel().name
    assert tuple(map(int, re.search(r"-manylinux_(\d+)_(\d+)_", wheel().name).groups())) <= oldest_system().TAG


@pytest.mark.skipif(sys.platform != "linux" or not shutil.which("objdump"), reason="no objdump")
def test_module_and_command_run_on_the_oldest_system():
    package = pathlib.Path(str(importlib.resources.files("orispline")))
    programs = [*package.glob("*.so"), package / "bin" / "orispline"]
    assert len(programs) == 2
    assert [breach for program in programs for breach in oldest_system().breaches("objdump", program)] == []
