# SPDX-License-Identifier: Apache-2.0
"""Samples as tables of pyarrow and pandas: the columns of their CSV file."""
import csv
import decimal
import pickle
import sys

import numpy as np
import orispline as ori
import pytest

KEYS = {"times": [0, 1, 3], "rotations": [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "positions": np.eye(3)}


def columns_of(table):
    return {name: table[name].to_numpy() for name in (table.columns if hasattr(table, "iloc") else table.column_names)}


@pytest.mark.parametrize("to", ["to_arrow", "to_pandas"])
@pytest.mark.parametrize("derivatives", [0, 3])
def test_tables_have_the_columns_of_the_file(to, derivatives, tmp_path):
    pytest.importorskip(to.removeprefix("to_").replace("arrow", "pyarrow"))
    for scalar_first in (False, True):
        keys = {**KEYS, "rotations": np.roll(KEYS["rotations"], 1, axis=1)} if scalar_first else KEYS
        samples = ori.Curve(**keys, scalar_first=scalar_first).sample(rate=10, derivatives=derivatives, frame="world")
        samples.write(tmp_path / "motion.csv")
        rows = list(csv.DictReader(open(tmp_path / "motion.csv")))
        found = columns_of(getattr(samples, to)())
        assert list(found) == list(rows[0]) and len(found) == (8 if derivatives == 0 else 23)
        for name, values in found.items():
            assert np.array_equal(values, [float(row[name]) for row in rows]), name


def test_tables_of_dates_and_single_numbers():
    pandas, pyarrow = pytest.importorskip("pandas"), pytest.importorskip("pyarrow")
    dates = np.array(["2026-11-22T12:00:00.000000007", "2026-11-22T12:00:01"], "datetime64[ns]")
    samples = ori.Curve(dates, KEYS["rotations"][:2]).sample(count=3, dtype="float32")
    frame, table = samples.to_pandas(), samples.to_arrow()
    assert frame["t"].iloc[0] == pandas.Timestamp("2026-11-22T12:00:00.000000007") and frame["qw"].dtype == "float32"
    assert table.schema.field("t").type == pyarrow.timestamp("ns")
    assert frame.attrs["epoch"] == table.schema.metadata[b"epoch"].decode() and samples.epoch == decimal.Decimal(frame.attrs["epoch"])
    assert str(samples.epoch) == "1795348800.000000007"


def test_packages_that_are_missing_have_one_line(monkeypatch):
    samples = ori.Curve(**KEYS).sample(rate=1)
    for to, package in (("to_arrow", "pyarrow"), ("to_pandas", "pandas")):
        monkeypatch.setitem(sys.modules, package, None)
        with pytest.raises(ImportError, match=f"^{to}: found no {package}, wanted it installed: pip install [^\n]*$"):
            getattr(samples, to)()


def test_samples_survive_pickling_and_may_be_made_by_hand(tmp_path):
    samples = ori.Curve(**KEYS).sample(rate="30000/1001", derivatives=2, start=0.1)
    samples.write(tmp_path / "wanted.csv")
    pickle.loads(pickle.dumps(samples, 5)).write(tmp_path / "again.csv")
    assert (tmp_path / "again.csv").read_bytes() == (tmp_path / "wanted.csv").read_bytes()
    assert "\n0.13336666666666667," in (tmp_path / "wanted.csv").read_text()
    ori.Samples(np.array([0.5, 2]), np.array([[0, 0, 0, 1], [0.6, 0, 0, 0.8]])).write(tmp_path / "made.csv")
    assert (tmp_path / "made.csv").read_text() == "t,qw,qx,qy,qz\n0.5,1,0,0,0\n2,0.8,0.6,0,0\n"
    dates = np.array(["2024-01-01T00:00:00.000000001", "2024-01-01T00:00:01"], "datetime64[ns]")
    ori.Samples(dates, np.array([[0, 0, 0, 1], [0.6, 0, 0, 0.8]])).write(tmp_path / "dated.csv")
    assert [line.split(",")[0] for line in (tmp_path / "dated.csv").read_text().splitlines()[1:]] == [
        "1704067200.000000001", "1704067201"]
