# SPDX-License-Identifier: Apache-2.0
"""Recordings as they come: epochs that are kept, several in a file, gaps, turns that are counted."""
import decimal
import importlib.resources
import pickle
import subprocess
import warnings

import numpy as np
import pytest
from page_data import data_of

import orispline as ori

COMMAND = str(importlib.resources.files("orispline") / "bin" / "orispline")
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


def test_a_clock_that_comes_round_is_counted_on(file, tmp_path):
    path = file("t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,0,0\n" for t in (604799, 604799.5, 0, 0.5)))
    assert ori.read(path, unwrap="week").times.tolist() == [0, 0.5, 1, 1.5]
    with pytest.raises(ori.ArgumentError, match="unwrap: found times from 0 to 604799.5, which never come round at"):
        ori.read(path, unwrap="int32")
    rates = file("t_us,wx,wy,wz\n16777215,0,0,1\n0,0,0,2\n", "gyro.csv")
    assert ori.read_rates(rates, unwrap="24bit*1us").times.tolist() == [0, 1e-6]
    np.save(tmp_path / "rows.npy", [[0, 1, 0, 0, 0]])
    with pytest.raises(ori.ArgumentError, match="unwrap: found it with a NumPy file"):
        ori.read(tmp_path / "rows.npy", unwrap="week")


def test_all_recordings_are_read_as_a_list(file):
    rows = (1, 2, 3, 1.5, 2.5, 2.75)
    path = file("t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,0,0\n" for t in rows))
    first, second = ori.read(path, session="all")
    assert (first == ori.read(path, session=1), second == ori.read(path, session=2)) == (True, True)
    assert [len(one) for one in ori.read(file(ROWS, "one.csv"), session="all")] == [3]
    with pytest.raises(ori.ArgumentError, match="session: found all with standard input, which can be read once only; wanted a file"):
        ori.read("-", session="all")
    array = file("", "rows.npy")
    np.save(array, [[t, 1, 0, 0, 0] for t in rows])
    assert ori.read(array, session="all") == [first, second] and ori.read(array, session=2) == second
    with pytest.raises(ori.DataError, match=r"rows.npy: found 2 recordings one behind the other, the second from row 3 on, wanted one of them \(session=N|all"):
        ori.read(array)
    with pytest.raises(ori.DataError, match="found 2 recordings"):
        ori.read(array, sort=True)
    with pytest.raises(ori.ArgumentError, match="session: found 3, wanted 1 to 2, which the file has"):
        ori.read(array, session=3)
    with pytest.raises(ori.ArgumentError, match="session: found '0', wanted the number of a recording, from 1, or all"):
        ori.read(array, session=0)


def test_numpy_files_take_the_options_of_reading_that_mean_something_there(file, tmp_path):
    q, p = [[0.8, 0.36, 0.48, 0], [0.6, 0, 0.8, 0], [1, 0, 0, 0], [0, 1, 0, 0]], [[1, 2, 3], [3, 2, 1], [0, 0, 1], [1, 1, 1]]
    table = np.column_stack([[0, 500, 1000, 5000], q, p])
    np.save(tmp_path / "keys.npy", table)
    np.savetxt(tmp_path / "keys.csv", table, delimiter=",", header="t,qw,qx,qy,qz,px,py,pz", comments="", fmt="%.17g")
    names = ["t", "qw", "qx", "qy", "qz", "px", "py", "pz"]
    for options in ({"gap": 2, "time_scale": "1/1000"}, {"no_positions": True}, {"conjugate": True, "time_scale": 0.001}, {"inverse_poses": True},
                    {"world_axes": "NED:ENU", "body_axes": "FRD:FLU"}, {"world_rotation": [0, 0, 0.6, 0.8], "gap": "4000"},
                    {"body_rotation": "roll_deg=0,pitch_deg=0,yaw_deg=90", "inverse_poses": True}, {"signs": "as-given"}):
        array, text = ori.read(tmp_path / "keys.npy", columns=names, **options), ori.read(tmp_path / "keys.csv", **{"time_scale": 1, **options})
        assert array.gap == text.gap and np.allclose(array.times, text.times, rtol=1e-15, atol=0), options
        assert np.allclose(array.rotations, text.rotations, rtol=0, atol=1e-15), options
        assert (array.positions is None) == (text.positions is None) == ("no_positions" in options)
        assert array.positions is None or np.allclose(array.positions, text.positions, rtol=0, atol=1e-14), options
    for options, message in (({"order": "wxyz"}, "order: found it with a NumPy file, which holds numbers in columns without names, wanted columns="),
                             ({"euler": "ZYX"}, r"euler: found it .* wanted Keys\(times, rotations, euler=…\) of the array of numpy.load"),
                             ({"fps": 24}, "fps: found it .* wanted time_scale, such as '1/24'"),
                             ({"joint": "hand"}, "joint: found it .* wanted it with files of text"),
                             ({"gap": -1}, "gap: found '-1', wanted a number greater than 0"),
                             ({"time_scale": "x"}, "time_scale: found 'x', wanted a number greater than 0"),
                             ({"conjugate": True, "inverse_poses": True}, "inverse_poses: found `conjugate` as well"),
                             ({"world_axes": "NEX:ENU"}, "world_axes: found 'NEX'")):
        with pytest.raises(ori.ArgumentError, match=message):
            ori.read(tmp_path / "keys.npy", columns=names, **options)


def test_keys_may_jump_where_that_is_asked_for(file, tmp_path):
    t, z = np.array([0, 10, 10, 20]), np.array([0, 0.1, 0.6, 0.6])
    q = np.column_stack([np.zeros(4), np.zeros(4), z, np.sqrt(1 - z**2)])
    path = file("t,qx,qy,qz,qw\n" + "".join(",".join(map(str, [time, *row])) + "\n" for time, row in zip(t, q)))
    with pytest.raises(ori.DataError, match="the orientation jumps there by .* \\(jumps=True cuts the motion there\\)"):
        ori.read(path)
    with pytest.raises(ori.DataError, match="duplicate time 10"):
        ori.Keys(t, q)
    np.save(tmp_path / "keys.npy", np.column_stack([t, q[:, 3], q[:, :3]]))
    for keys in (ori.read(path, jumps=True), ori.read(tmp_path / "keys.npy", jumps=True), ori.Keys(t, q, jumps=True)):
        curve = keys.curve("slerp")
        assert np.allclose(curve([0, 9.999999, 10, 20])[:, 2], z, rtol=0, atol=1e-6)
        assert pickle.loads(pickle.dumps(keys)) == keys and len(keys[1:3]) == 2
        keys.write(tmp_path / "again.csv")
        assert np.array_equal(ori.read(tmp_path / "again.csv").times, t)
        with pytest.raises(ori.ArgumentError, match="jumps: found two orientations at one time, wanted one curve"):
            ori.tune(keys, "quintic")
        assert keys[:2] + keys[2:] == keys
    with pytest.raises(ori.DataError, match="key 2: duplicate time 0, .* \\(a jump has two keys of one time, and this is a third\\)"):
        ori.Keys(t * 0, q, jumps=True)
    with pytest.raises(ori.ArgumentError, match="jumps: wanted no drop_duplicates"):
        ori.Keys(t, q, jumps=True, drop_duplicates=True)


def test_nothing_is_warned_of_a_gap():
    t, z = [0, 0.1, 0.2, 0.3, 0.7, 0.8, 0.9, 1.0], np.radians([0, 60, 120, 180, 185, 190, 195, 200]) / 2
    q = np.column_stack([0 * z, 0 * z, np.sin(z), np.cos(z)])
    with pytest.warns(ori.ShapeWarning, match="between the keys at 0.3 s and 0.7 s the curve of auto turns by"):
        ori.Curve(t, q)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ori.Curve(t, q, gap=0.2)


def test_pickles_from_before_keys_could_jump_are_read():
    keys = ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]], gap=2)
    restored, arguments = keys.__reduce__()
    *others, origin, source = arguments
    assert restored(*others, origin[:13], source) == keys


def test_arrays_have_gaps_as_files_have(tmp_path):
    t = np.array([0, 0.5, 1, 4, 4.5, 5])
    q = np.column_stack([np.zeros(6), np.zeros(6), np.sin(t / 2), np.cos(t / 2)])
    keys = ori.Keys(t, q, gap=1)
    assert keys.gap == 1 and ori.Keys(t, q).gap is None and keys != ori.Keys(t, q)
    assert keys[:4].gap == 1 and pickle.loads(pickle.dumps(keys)) == keys
    for curve in (ori.Curve(keys, method="slerp"), ori.Curve(t, q, "slerp", gap="1"), ori.CurveStack(t, q[:, None], "slerp", gap=1)):
        assert np.isnan(curve([1.5, 3.9])).all() and not np.isnan(curve([0, 1, 4, 5])).any()
    keys.write(tmp_path / "keys.csv")
    assert ori.read(tmp_path / "keys.csv").gap == 1
    dated = ori.Keys(np.datetime64("2026-01-01") + (1e9 * t).astype("timedelta64[ns]"), q, gap=1)
    assert np.isnan(dated.curve("slerp")(dated.times[2] + np.timedelta64(1, "s"))).all()
    with pytest.raises(ori.ArgumentError, match="gap: found '0', wanted a number greater than 0"):
        ori.Keys(t, q, gap=0)
    with pytest.raises(ori.ArgumentError, match="gap: found 0.1 s, wanted more than the median interval of 0.5 s"):
        ori.Curve(t, q, gap=0.1)
    with pytest.raises(TypeError, match="gap: found gap beside Keys"):
        ori.Curve(keys, gap=1)
    for whole in (lambda: keys.curve("slerp").bake(1e-6), lambda: keys.curve("slerp").leave_out(), lambda: ori.tune(keys, "quintic")):
        with pytest.raises(ori.ArgumentError, match="gap: found gaps longer than 1 s, wanted one curve through all keys"):
            whole()
    times = np.r_[np.arange(0, 3, 0.02), np.arange(5, 8, 0.02)]
    noisy = np.column_stack([np.zeros((300, 2)), np.sin(times / 2), np.cos(times / 2)]) + np.random.default_rng(1).normal(0, 0.003, (300, 4))
    smoothing = ori.smooth(ori.Keys(times, noisy, normalize=True, gap=0.5))
    assert len(smoothing.stretches) == 2 and np.isnan(smoothing.curve(4.0)).all()


def test_samples_outside_and_in_gaps_are_left_out(tmp_path):
    t = np.array([0, 0.5, 1, 4, 4.5, 5])
    q = np.column_stack([np.zeros((6, 2)), np.sin(t / 2), np.cos(t / 2)])
    curve = ori.Curve(t, q, "slerp", positions=np.eye(6, 3), gap=1, extrapolate="leave-out")
    samples = curve.sample(rate="10/3", start=-1, end=6.5, derivatives=1)
    kept = samples.times
    assert ((kept >= 0) & (kept <= 1) | (kept >= 4) & (kept <= 5)).all() and len(samples.orientations) == len(samples.positions) == len(kept) == 7
    assert not np.isnan(samples.angular_velocities).any() and np.array_equal(curve(kept), samples.orientations)
    assert curve.sample(times=[7, 4.25, -1, 0.25]).times.tolist() == [4.25, 0.25] and len(curve.sample(times=[9.0])) == 0
    assert np.isnan(curve([-1, 2, 6])).all() and pickle.loads(pickle.dumps(curve)).sample(times=[9, 1]).times.tolist() == [1]
    stack = ori.CurveStack(t, np.stack([q, q], axis=1), "slerp", gap=1, extrapolate="leave-out")
    assert stack.sample(times=[0.5, 2, 9]).orientations.shape == (1, 2, 4)
    with pytest.raises(ori.ArgumentError, match="out: found it with extrapolate='leave-out', wanted none"):
        curve.sample(times=[1.0], out=np.empty((1, 4)))
    with pytest.raises(ori.ArgumentError, match="extrapolate: found 'leave', wanted 'hold', 'error', 'nan', 'rate', 'segment' or 'leave-out'"):
        ori.Curve(t, q, extrapolate="leave")


def test_what_is_left_out_is_what_the_command_leaves_out(file, tmp_path):
    rows = (0, 0.5, 1, 4, 4.5, 5)
    keys = ori.read(file("t,qw,qx,qy,qz\n" + "".join(f"{1700000000 + t},{np.cos(t / 2)},0,0,{np.sin(t / 2)}\n" for t in rows)), gap=1)
    keys.write(tmp_path / "stated.csv")
    keys.curve("slerp", extrapolate="leave-out").sample(rate=3, start=-1, end=7).write(tmp_path / "ours.csv")
    subprocess.run([COMMAND, "sample", "stated.csv", "--method", "slerp", "--rate", "3", "--from=+-1", "--to", "+7", "--outside", "leave-out",
                    "--derivatives", "0", "--quiet", "-o", "theirs.csv"], cwd=tmp_path, check=True)
    assert (tmp_path / "ours.csv").read_text() == (tmp_path / "theirs.csv").read_text()


def test_the_page_of_a_curve_has_nothing_in_gaps(tmp_path):
    t = np.array([0, 0.5, 1, 4, 4.5, 5])
    curve = ori.Curve(t, np.column_stack([np.zeros((6, 2)), np.sin(t / 2), np.cos(t / 2)]), "slerp", gap=1)
    curve.report(tmp_path / "page.html")
    samples = data_of((tmp_path / "page.html").read_text("utf-8"))["methods"][0]["samples"]
    times, q = np.array(samples["t"]), np.array(samples["q"], float).reshape(-1, 4)
    inside = (1 + 1e-6 < times) & (times < 4 - 1e-6)
    assert inside.any() and np.isnan(q[inside]).all() and not np.isnan(q[~inside]).any()


def test_bands_of_curves_are_those_of_their_stretches():
    t = np.r_[np.arange(0, 3.05, 0.1), np.arange(5, 8.05, 0.1)]
    q = np.column_stack([np.sin(3 * t), np.cos(5 * t), np.zeros(len(t)), np.full(len(t), 2.0)])
    band = ori.Curve(t, q, "measured", normalize=True, gap=1).band([1.05, 4.0, 6.05])
    assert np.isnan(band[1]) and (band[[0, 2]] > 0).all()


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
