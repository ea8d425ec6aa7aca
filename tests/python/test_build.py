# SPDX-License-Identifier: Apache-2.0
"""What build.py does besides building: the environment is made once for what it is made from, and sizes have a budget."""
import importlib.util
import zipfile

import pytest
from conftest import ROOT

pytest.importorskip("tomllib", reason="build.py: wanted Python 3.11 or later to build with")


@pytest.fixture
def build(monkeypatch, tmp_path_factory):
    """The program as a module, which notes the environments that it makes instead of asking an index for packages."""
    spec = importlib.util.spec_from_file_location("build", ROOT / "bindings/python/build.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.made = []

    def create(place, **_):
        (place / "bin").mkdir(parents=True)
        module.made.append(place.name)

    monkeypatch.setattr(module.venv, "create", create)
    monkeypatch.setattr(module.subprocess, "run", lambda *_, **__: module.subprocess.CompletedProcess([], 0))
    headers = tmp_path_factory.mktemp("headers")
    (headers / "Python.h").touch()
    monkeypatch.setattr(module.sysconfig, "get_path", lambda _: headers)
    return module


def test_it_is_kept_until_what_it_is_made_from_changes(build, tmp_path, monkeypatch):
    python = build.environment(tmp_path)
    assert build.environment(tmp_path) == python and len(build.made) == 1
    assert (tmp_path / "venv/bin").samefile(python.parent)
    with monkeypatch.context() as patch:  # a link that leads there is left alone, since programs are run by it
        patch.setattr(build.pathlib.Path, "unlink", lambda *_, **__: pytest.fail("unlinked"))
        assert build.environment(tmp_path) == python
    monkeypatch.setattr(build, "packages", lambda: ["numpy"])
    other = build.environment(tmp_path)
    assert len(set(build.made)) == 2 and not python.parent.exists() and (tmp_path / "venv/bin").samefile(other.parent)
    monkeypatch.setattr(build.sys, "version", "3.99")
    build.environment(tmp_path)
    assert len(set(build.made)) == 3 and len(list((tmp_path / "environments").iterdir())) == 1


def test_one_whose_making_was_interrupted_is_made_anew(build, tmp_path, monkeypatch):
    def interrupted(*_, **__):
        raise KeyboardInterrupt

    with monkeypatch.context() as patch:
        patch.setattr(build.subprocess, "run", interrupted)
        with pytest.raises(KeyboardInterrupt):
            build.environment(tmp_path)
    build.environment(tmp_path)
    build.environment(tmp_path)
    assert len(build.made) == 2


def test_without_an_index_it_says_so_and_leaves_none_for_complete(build, tmp_path, monkeypatch):
    monkeypatch.setattr(build.subprocess, "run", lambda *_, **__: build.subprocess.CompletedProcess([], 1))
    for _ in range(2):
        with pytest.raises(build.Missing, match="found no package index with .*numpy"):
            build.environment(tmp_path)
    assert len(build.made) == 2


def test_one_from_before_they_had_names_gives_way(build, tmp_path):
    (tmp_path / "venv/bin").mkdir(parents=True)
    python = build.environment(tmp_path)
    assert (tmp_path / "venv").is_symlink() and (tmp_path / "venv/bin").samefile(python.parent)


@pytest.mark.parametrize("part", ["wheel", "module"])
def test_a_package_above_its_budget_is_refused(part, build, tmp_path, monkeypatch, capsys):
    wheel = tmp_path / "orispline.whl"
    with zipfile.ZipFile(wheel, "w") as archive:
        archive.writestr("orispline/_core.abi3.so", bytes(4_000_000))
        archive.writestr("orispline/bin/orispline", bytes(5_000_000))
    build.report_sizes(wheel)
    most = {name: f"{size / 1e6:.2f}" for name, size in build.BUDGET.items()}
    assert capsys.readouterr().out == f"orispline.whl: wheel 9.00 MB of {most['wheel']}, module 4.00 MB of {most['module']}\n"
    monkeypatch.setitem(build.BUDGET, part, 3_999_999)
    with pytest.raises(SystemExit, match="found the package larger than its budget"):
        build.report_sizes(wheel)


def test_the_oldest_versions_are_those_that_are_stated(build, tmp_path, monkeypatch):
    wanted = []
    monkeypatch.setattr(build, "make", lambda place, packages: wanted.extend(packages))
    assert build.oldest(tmp_path, "orispline.whl") == tmp_path / "oldest/bin/python"
    assert {package.partition("==")[0] for package in wanted} >= {"numpy", "pyarrow", "duckdb", "polars", "pandas", "pytest"}
    assert all(package.endswith(".*") and ">" not in package for package in wanted)
