# SPDX-License-Identifier: Apache-2.0
"""Comparisons are those of the command, but for times of the clock."""
import numpy as np
import orispline as ori
import pytest
from task_files import EXAMPLES, json_of, keys_in, run

CLOCK = ("build_seconds", "seconds")
TRUTH, KEYS = EXAMPLES / "flight_truth.csv", EXAMPLES / "flight_keys.csv"


def without_clock(rows):
    return [{name: value for name, value in row.items() if name not in CLOCK} for row in rows]


@pytest.mark.parametrize("words, options", [
    ("--keep-every 50", {"keep_every": 50}),
    ("--keep-every 40,90 --jitter --random 7 --methods auto,slerp,quintic:tension=0.6 --tune --sort max",
     {"keep_every": [40, 90], "jitter": True, "random": 7, "methods": ["auto", "slerp", "quintic:tension=0.6"],
      "tune": True, "sort": "max"}),
    ("--random 3 --methods squad --leave-out --no-least-energy --inertia=1,2,2.5 --sort torque",
     {"random": 3, "methods": "squad", "leave_out": True, "least_energy": False, "inertia": (1, 2, 2.5), "sort": "torque"})])
def test_table_is_that_of_the_command(words, options):
    told = json_of("compare", TRUTH, *words.split(), "--quiet")
    comparison = ori.compare(keys_in(TRUTH, "angular_velocities"), **options)
    assert [list(row) for row in comparison.table()] == [list(row) for row in told]
    assert without_clock(comparison.table()) == without_clock(told)
    assert len(comparison) == len(told)


def test_beside_a_reference_it_is_that_of_the_command():
    told = json_of("compare", KEYS, "--reference", TRUTH, "--methods", "auto,slerp,bezier", "--quiet")
    comparison = ori.compare(keys_in(KEYS), ["auto", "slerp", "bezier"], reference=keys_in(TRUTH, "angular_velocities"))
    rows = without_clock(comparison.table())
    assert [row["method"] for row in rows] == ["auto", "slerp", "bezier"]
    assert rows[:2] == without_clock(told)[:2]
    assert "3k+1" in rows[2]["error"] or "keys" in rows[2]["error"]
    assert rows[2]["rms_deg"] is None and told[2]["error"].endswith(rows[2]["error"])


def test_curves_of_rows_are_those_that_were_measured():
    comparison = ori.compare(keys_in(TRUTH), ["quintic", "slerp"], keep_every=60, tune=True)
    recording = keys_in(TRUTH)
    for row, told in enumerate(comparison.table()):
        t = recording.times[:told["samples"]]
        dots = np.abs(np.sum(comparison.curve(row)(t) * recording.rotations[:len(t)], axis=1))
        rms = np.degrees(np.sqrt(np.mean((2 * np.arccos(np.minimum(1, dots)))**2)))
        assert rms == pytest.approx(told["rms_deg"], rel=1e-4)
        assert len(comparison.keys(row)) == told["keys"]
    assert {row["method"] for row in comparison.table()} == {"quintic", "quintic:tuned", "slerp"}
    with pytest.raises(IndexError, match="row: found 3"):
        comparison.curve(3)


def test_it_prints_the_tables_of_the_command():
    told = run("compare", TRUTH, *"--keep-every 50,90 --methods auto,slerp --quiet".split())[0]
    printed = str(ori.compare(ori.read(TRUTH), ["auto", "slerp"], keep_every=[50, 90]))
    assert [line.split()[:-1] for line in printed.splitlines()] == [line.split()[:-1] for line in told.splitlines()]  # but for the time
    assert printed.startswith(f"{TRUTH.name}: every 50th sample kept, ")


def test_measures_say_what_columns_are():
    comparison = ori.compare(keys_in(TRUTH), "slerp")
    row = comparison.table()[0]
    assert list(row) == ["method", "keep_every", "keys", "samples", *(m["id"] for m in comparison.measures), "error"]
    assert next(m for m in comparison.measures if m["id"] == "rms_deg")["unit"] == "deg"


def test_a_table_is_the_callers_own():
    comparison = ori.compare(keys_in(TRUTH), "slerp")
    comparison.table()[0]["method"] = "mine"
    assert comparison.table()[0]["method"] == "slerp"


def test_frame_of_pandas_has_the_same_table():
    pandas = pytest.importorskip("pandas")
    comparison = ori.compare(keys_in(TRUTH), ["slerp", "auto"])
    frame = comparison.to_pandas()
    assert isinstance(frame, pandas.DataFrame)
    assert frame["rms_deg"].tolist() == [row["rms_deg"] for row in comparison.table()]


def test_warns_of_a_reference_that_is_no_denser():
    keys = keys_in(KEYS)
    with pytest.warns(ori.ShapeWarning, match="at the times of keys") as caught:
        ori.compare(keys, "slerp", reference=keys)
    assert caught[0].message.code == "no_reference_between_keys"
