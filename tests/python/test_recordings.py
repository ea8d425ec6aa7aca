# SPDX-License-Identifier: Apache-2.0
"""Recordings as they come: epochs that are kept, several in a file, gaps, turns that are counted."""
import decimal

import numpy as np
import pytest

import orispline as ori

ROWS = "t,qw,qx,qy,qz\n1620000000.25,1,0,0,0\n1620000000.75,0.8,0,0,0.6\n1620000001.5,0.6,0,0,0.8\n"


@pytest.fixture
def file(tmp_path):
    def written(text, name="keys.csv"):
        path = tmp_path / name
        path.write_text(text)
        return path
    return written


def test_times_of_keys_from_a_file_remember_its_epoch(file, tmp_path):
    keys, out = ori.read(file(ROWS)), tmp_path / "out.csv"
    ori.Keys(keys.times, keys.rotations).write(out)
    assert out.read_text() == ROWS
    later = ori.Keys(keys.times[1:] + 5, keys.rotations[1:])
    assert later.epoch == decimal.Decimal("1620000000.25") and later.times.tolist() == [5.5, 6.25]
    assert type(keys.times.max()) is np.float64 and repr(keys.times) == "array([0.  , 0.5 , 1.25])"
    assert type(ori.Keys([0, 1], keys.rotations[:2]).times) is np.ndarray


def test_quaternions_of_zeros_are_dropped_with_invalid_ones():
    keys = ori.Keys([0, 1, 2], [[0, 0, 0, 1], [0, 0, 0, 0], [0, 0, 0.6, 0.8]], drop_invalid=True)
    assert keys.times.tolist() == [0, 2] and keys.repairs["invalid_dropped"] == 1


def test_one_of_several_recordings_is_read(file):
    path = file("t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,0,0\n" for t in (1, 2, 3, 1.5, 2.5, 2.75)))
    with pytest.raises(ori.DataError, match="a second recording begins"):
        ori.read(path)
    assert ori.read(path, session=2).epoch == decimal.Decimal("1.5")
    with pytest.raises(ori.ArgumentError, match="session: found 3, wanted 1 to 2"):
        ori.read(path, session=3)


def test_curves_bridge_no_gap(file, tmp_path):
    path = file("t,qw,qx,qy,qz\n" + "".join(f"{t},{np.cos(t / 2)},0,0,{np.sin(t / 2)}\n" for t in (0, 0.5, 1, 4, 4.5, 5)))
    keys = ori.read(path, gap=1)
    curve = keys.curve("slerp")
    assert np.isnan(curve([1.5, 3.9])).all() and not np.isnan(curve([0, 1, 4, 5])).any()
    curve.keys.write(tmp_path / "out.csv")
    assert np.isnan(ori.read(tmp_path / "out.csv").curve("slerp")([1.5])).all()


def test_turns_are_counted_and_run_on(file, tmp_path):
    keys = ori.read(file("t,roll_deg,pitch_deg,yaw_deg\n0,0,0,0\n40,0,0,-720\n"), signs="as-typed")
    assert keys.repairs["rows_between"] == 5
    keys.write(tmp_path / "out.csv", continuous=True)
    lines = (tmp_path / "out.csv").read_text().splitlines()
    assert lines[0] == "# orispline: signs=as-given" and float(lines[-1].split(",")[3]) == pytest.approx(-720)
