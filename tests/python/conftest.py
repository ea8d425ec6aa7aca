# SPDX-License-Identifier: Apache-2.0
"""Data of the tests: golden rows of the references, and keys."""
import csv
import os
import pathlib
import sys

import numpy as np
import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
DATA = ROOT / "tests/data"
sys.path.append(str(ROOT / "tests/cli"))  # for page_data
# The jobs of Spark take seconds here: less than it takes to make Java's own code fast.
os.environ.setdefault("JDK_JAVA_OPTIONS", "-XX:TieredStopAtLevel=1 -XX:+UseSerialGC")


def wheel():
    """The wheel that is tested: what ORISPLINE_WHEEL names, else the one of `make python`; none where it is not there."""
    found = [os.environ["ORISPLINE_WHEEL"]] if "ORISPLINE_WHEEL" in os.environ else (ROOT / "build/python/dist").glob("*.whl")
    return next(map(pathlib.Path, found), None)


def rows_of(name):
    """The rows of a table below its comments, as dictionaries of texts."""
    with open(DATA / name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def row_of(file):
    """Side by side the tests of a file stay in one row, and all with Spark, which share its session."""
    return "spark" if file.startswith("test_spark") or file == "test_documents" else file


def pytest_collection_modifyitems(items):
    """Those with Spark first, since they take longest."""
    items.sort(key=lambda item: row_of(item.path.stem) != "spark")


@pytest.hookimpl(optionalhook=True)  # of pytest-xdist
def pytest_xdist_make_scheduler(config, log):
    from xdist.scheduler import LoadScopeScheduling

    class Rows(LoadScopeScheduling):
        def _split_scope(self, nodeid):
            return row_of(pathlib.PurePath(nodeid.partition("::")[0]).stem)

    config.option.loadscopereorder = False  # by their numbers of tests
    return Rows(config, log)


@pytest.fixture(scope="session")
def spark(tmp_path_factory):
    """A session of Spark, in a time zone that nothing may depend on."""
    from spark_cluster import started
    session = started(**{"spark.sql.warehouse.dir": str(tmp_path_factory.mktemp("warehouse")),
                         "spark.worker.ui.port": "0"})
    yield session
    session.stop()


@pytest.fixture
def keys():
    """Times and quaternions x, y, z, w of forty keys with uneven steps and turns up to 1.2 rad."""
    dice = np.random.default_rng(3)
    times = np.cumsum(dice.uniform(0.2, 1.8, 40))
    q = np.array([0.0, 0.0, 0.0, 1.0])
    rotations = []
    for _ in times:
        axis = dice.normal(size=3)
        half = dice.uniform(0.05, 0.6)
        step = np.append(np.sin(half) * axis / np.linalg.norm(axis), np.cos(half))
        q = product(q, step)
        rotations.append(q)
    return times, np.array(rotations)


def product(p, q):
    """Hamilton's, of x, y, z, w."""
    (a, u), (b, v) = (p[3], p[:3]), (q[3], q[:3])
    return np.append(a * v + b * u + np.cross(u, v), a * b - u @ v)
