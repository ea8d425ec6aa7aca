# SPDX-License-Identifier: Apache-2.0
"""Many curves on the same times, beside each of them alone."""
import pickle

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation


@pytest.fixture
def figure():
    """Times and (n, m, 4) rotations of thirty keys of five joints."""
    dice = np.random.default_rng(11)
    times = np.cumsum(dice.uniform(0.3, 1.2, 30))
    q = np.cumsum(dice.normal(scale=0.25, size=(30, 5, 4)), axis=0) + [0, 0, 0, 2]
    return times, q / np.linalg.norm(q, axis=2, keepdims=True)


RATES = ("angular_velocity", "angular_acceleration", "angular_jerk")


@pytest.mark.parametrize("method", ["auto", "timed-c2", "slerp", "squad-timed", "rotation-spline"])
def test_each_joint_is_its_own_curve_bit_for_bit(figure, method):
    times, rotations = figure
    stack = ori.CurveStack(times, rotations, method)
    alone = [ori.Curve(times, rotations[:, joint], method) for joint in range(5)]
    t = np.random.default_rng(1).uniform(times[0] - 1, times[-1] + 1, 6000)
    for name in ("__call__", *RATES):
        for asked in (t, np.sort(t), t[:6].reshape(2, 3), t[0], float(t[1]), times):
            wanted = np.stack([np.asarray(getattr(curve, name)(asked)) for curve in alone], axis=-2)
            assert np.array_equal(getattr(stack, name)(asked), wanted), name
    world = np.stack([curve.angular_jerk(t, frame="world") for curve in alone], axis=-2)
    assert np.array_equal(stack.angular_jerk(t, frame="world"), world)
    assert len(stack) == 5 and repr(stack[3]) == repr(alone[3])
    assert stack([]).shape == (0, 5, 4)


def test_samples_threads_outputs_and_single_precision(figure):
    stack = ori.CurveStack(*figure)
    samples = stack.sample(rate=200, derivatives=2, frame="world")
    k = len(samples)
    assert samples.orientations.shape == (k, 5, 4) and samples.angular_accelerations.shape == (k, 5, 3)
    assert samples.angular_jerks is None
    out = [np.empty((k, 5, width)) for width in (4, 3, 3)]
    assert stack.sample(rate=200, derivatives=2, frame="world", out=out).angular_accelerations is out[2]
    assert np.array_equal(out[0], samples.orientations) and np.array_equal(out[2], samples.angular_accelerations)
    one = stack[2].sample(rate=200, derivatives=2, frame="world")
    assert np.array_equal(samples.times, one.times)
    assert np.array_equal(samples.orientations[:, 2], one.orientations)
    assert np.array_equal(samples.angular_accelerations[:, 2], one.angular_accelerations)
    assert np.array_equal(stack(samples.times, threads=3), samples.orientations)
    assert np.array_equal(stack.sample(count=7).times, stack[0].sample(count=7).times)
    out = np.empty((k, 5, 4))
    assert stack(samples.times, out=out) is out and np.array_equal(out, samples.orientations)
    single = stack(samples.times, dtype="float32")
    assert single.dtype == np.float32 and np.allclose(single, out, atol=1e-6)
    again = pickle.loads(pickle.dumps(stack, 5))
    assert np.array_equal(again(samples.times), out) and repr(again) == repr(stack)
    for wrong in (dict(out=np.empty((k, 4))), dict(out=np.empty((k, 5, 4), "f4")), dict(dtype="int32")):
        with pytest.raises(ori.ArgumentError):
            stack(samples.times, **wrong)


def test_samples_say_what_they_are_and_become_tables(figure, tmp_path):
    pytest.importorskip("pandas"), pytest.importorskip("pyarrow")
    stack = ori.CurveStack(*figure)
    samples = stack.sample(rate="30000/1001", derivatives=1, frame="world")
    assert samples.frame == "world" and samples.epoch == 0
    frame, table = samples.to_pandas(), samples.to_arrow()
    assert list(frame.columns) == table.column_names == ["joint", "t", "qw", "qx", "qy", "qz", "wx_world", "wy_world", "wz_world"]
    assert len(frame) == 5 * len(samples) and frame["joint"].tolist() == np.repeat(range(5), len(samples)).tolist()
    for joint in (0, 3, -1):
        one = stack[joint].sample(rate="30000/1001", derivatives=1, frame="world")
        mine = samples.joint(joint)
        assert np.array_equal(mine.orientations, one.orientations) and np.array_equal(mine.angular_velocities, one.angular_velocities)
        rows = frame[frame["joint"] == joint % 5].drop(columns="joint").reset_index(drop=True)
        assert rows.equals(one.to_pandas()) and mine.frame == "world" and mine.angular_jerks is None
        mine.write(tmp_path / "mine.csv")
        one.write(tmp_path / "wanted.csv")
        assert (tmp_path / "mine.csv").read_bytes() == (tmp_path / "wanted.csv").read_bytes()
    with pytest.raises(ori.ArgumentError, match=r"found samples of 5 joints, wanted those of one, such as of samples.joint\(0\)"):
        samples.write(tmp_path / "all.csv")
    with pytest.raises(ori.ArgumentError, match="joint: found 5, wanted a whole number from -5 to 4"):
        samples.joint(5)
    with pytest.raises(ori.ArgumentError, match="joint: found samples of one curve"):
        stack[0].sample(count=3).joint(0)
    assert list(tmp_path.glob("all*")) == []


def test_samples_of_stacks_are_tables_of_tracks(figure):
    tables = pytest.importorskip("orispline.tables")
    samples = ori.CurveStack(*figure).sample(count=20)
    found = tables.resample(samples.to_arrow(), by="joint", rate=10).read_all().to_pandas()
    one = ori.Curve(samples.times, samples.orientations[:, 2]).sample(rate=10)
    assert np.array_equal(found[found["joint"] == 2][["qx", "qy", "qz", "qw"]].to_numpy(), one.orientations)


def test_joints_are_taken_by_their_numbers(figure):
    stack = ori.CurveStack(*figure)
    assert repr(stack[np.int64(-1)]) == repr(stack[4]) and len(list(stack)) == 5
    with pytest.raises(IndexError, match="joint: found 5, wanted one of 5 joints"):
        stack[5]
    with pytest.raises(TypeError, match="joint: found 'hand' of type str, wanted the number of a joint"):
        stack["hand"]


def test_forms_of_keys(figure):
    from scipy.spatial.transform import Rotation
    times, rotations = figure
    stack, t = ori.CurveStack(times, rotations), np.linspace(2, 9, 20)
    first = ori.CurveStack(times, rotations[..., [3, 0, 1, 2]], scalar_first=True)
    assert np.array_equal(first(t), stack(t)[..., [3, 0, 1, 2]])
    assert np.array_equal(first.sample(times=t).orientations, first(t))
    matrices = Rotation.from_quat(rotations.reshape(-1, 4)).as_matrix().reshape(30, 5, 3, 3)
    assert np.abs(np.sum(ori.CurveStack(times, matrices)(t) * stack(t), axis=-1)).min() > 1 - 1e-14
    dates = np.datetime64("2026-01-01") + np.round(times * 1e9).astype("timedelta64[ns]")
    dated = ori.CurveStack(dates, rotations)
    assert dated.domain == (dates[0], dates[-1]) and dated(dates[3]).shape == (5, 4)
    assert np.array_equal(stack.times, times) and np.abs(np.abs(stack.rotations) - np.abs(rotations)).max() < 1e-15
    kept = ori.CurveStack(times, rotations, "timed-c2", extrapolate="rate", ends="rest", tension=0.3)
    assert kept.method == kept[1].method and np.abs(kept.angular_velocity(times[-1] + 1)).max() < 1e-15
    assert repr(stack).startswith("CurveStack('auto', 5 joints, 30 keys, ")


def test_the_joint_that_fails_is_named(figure):
    times, rotations = figure
    for place, value, error, message in (((7, 3), [0, 0, 0, 0], ori.DataError, "joint 3: key 7"),
                                         ((2, 4), [np.nan, 0, 0, 1], ori.DataError, "joint 4: key 2")):
        bad = rotations.copy()
        bad[place] = value
        with pytest.raises(error, match=message) as found:
            ori.CurveStack(times, bad)
        assert found.value.joint == place[1] and found.value.key == place[0]
    with pytest.raises(ori.ArgumentError, match="joint 0: .*unknown method"):
        ori.CurveStack(times, rotations, "none")


@pytest.mark.parametrize("shape", [(30, 4), (30, 5, 3), (30, 5, 4, 1), (30, 0, 4), (4,)])
def test_other_shapes_are_refused(figure, shape):
    with pytest.raises(ori.ArgumentError, match="rotations: found the shape"):
        ori.CurveStack(figure[0], np.ones(shape))


def test_other_lengths_times_and_questions_are_refused(figure):
    times, rotations = figure
    with pytest.raises(ori.DataError, match="wanted one row for each of the 29 times"):
        ori.CurveStack(times[:-1], rotations)
    with pytest.raises(ori.ArgumentError, match="real numbers"):
        ori.CurveStack(times, rotations.astype(complex))
    strict = ori.CurveStack(times, rotations, extrapolate="error")
    far = np.full(5000, times[3])
    far[4321] = times[-1] + 1
    with pytest.raises(ori.ArgumentError, match="is outside the curve, wanted") as found:
        strict(far)
    assert found.value.time_index == 4321
    with pytest.raises(ori.ArgumentError, match="frame"):
        strict.angular_velocity(times, frame="sky")
    with pytest.raises(ori.ArgumentError, match="one of rate"):
        strict.sample()


@pytest.fixture
def tracks():
    """Pairs of times and rotations, of 2 to 31 keys."""
    dice, made = np.random.default_rng(12), []
    for count in (2, 31, 5, 12):
        q = np.cumsum(dice.normal(scale=0.25, size=(count, 4)), axis=0) + [0, 0, 0, 2]
        made.append((dice.uniform(-3, 3) + np.cumsum(dice.uniform(0.3, 1.2, count)), q / np.linalg.norm(q, axis=1, keepdims=True)))
    return made


LINEAR = ("position", "velocity", "acceleration")


@pytest.mark.parametrize("extrapolate", ["hold", "nan", "rate"])
def test_tracks_with_clocks_of_their_own_are_their_curves_bit_for_bit(tracks, extrapolate):
    keys = [ori.Keys(t, q, positions=q[:, :3]) for t, q in tracks]
    stack = ori.CurveStack(keys, extrapolate=extrapolate)
    alone = [ori.Curve(one, extrapolate=extrapolate) for one in keys]
    dice = np.random.default_rng(2)
    each = dice.uniform(-4, 20, (4, 300))
    for name in ("__call__", *RATES, *LINEAR):
        wanted = np.stack([getattr(curve, name)(row) for curve, row in zip(alone, each)])
        found = getattr(stack, name)(each)
        assert found.shape[:2] == (4, 300) and np.array_equal(found, wanted, equal_nan=True), name
        assert np.array_equal(getattr(stack, name)(each, threads=3), wanted, equal_nan=True)
        for asked in (each[0], float(each[0, 0])):
            wanted = np.stack([np.asarray(getattr(curve, name)(asked)) for curve in alone], axis=-2)
            assert np.array_equal(getattr(stack, name)(asked), wanted, equal_nan=True)
    world = np.stack([curve.angular_jerk(row, frame="world") for curve, row in zip(alone, each)])
    assert np.array_equal(stack.angular_jerk(each, frame="world"), world, equal_nan=True)
    samples = stack.sample(rate=20, derivatives=1)
    assert samples.times[0] == stack.domain[0] == min(t[0] for t, _ in tracks) and samples.velocities.shape == (len(samples), 4, 3)
    again = pickle.loads(pickle.dumps(stack))
    assert np.array_equal(again(each), stack(each), equal_nan=True) and repr(again) == repr(stack)
    assert repr(stack).startswith("CurveStack('auto', 4 tracks, 2 to 31 keys, ")
    assert [len(times) for times in stack.times] == [2, 31, 5, 12] and stack.rotations[1].shape == (31, 4)


def test_tracks_are_pairs_keys_or_curves_with_dates_and_gaps(tracks):
    start = np.datetime64("2026-11-28T10:00:00", "us")
    dated = [(start + (1e6 * t).astype("m8[us]"), q) for t, q in tracks]
    stack = ori.CurveStack([dated[0], ori.Keys(*dated[1]), ori.Curve(*dated[2], extrapolate="nan"), ori.Keys(*dated[3], gap=1.0)], extrapolate="nan")
    alone = [ori.Curve(*dated[0], extrapolate="nan"), ori.Curve(*dated[1], extrapolate="nan"), ori.Curve(*dated[2], extrapolate="nan"),
             ori.Curve(*dated[3], gap=1.0, extrapolate="nan")]
    asked = start + (1e6 * np.random.default_rng(3).uniform(-2, 8, 50)).astype("m8[us]")
    wanted = np.stack([curve(asked) for curve in alone], axis=1)
    assert np.isnan(wanted[:, 3]).any() and not np.isnan(wanted[:, 3]).all()
    assert np.array_equal(stack(asked), wanted, equal_nan=True)
    assert np.array_equal(stack(np.tile(asked, (4, 1))), wanted.swapaxes(0, 1), equal_nan=True)
    samples = stack.sample(times=asked[:3], derivatives=2)
    assert np.array_equal(samples.orientations, wanted[:3], equal_nan=True) and np.array_equal(samples.times, asked[:3])
    assert stack.domain[0] == min(t[0] for t, _ in dated)


def test_tracks_may_jump(tracks):
    q = tracks[1][1][:4]
    stack = ori.CurveStack([([0, 1, 1, 2], q), ([0, 3], q[:2])], method="slerp", jumps=True)
    assert np.allclose(stack(1.0)[0], q[2], rtol=0, atol=1e-15) and stack[0].keys == ori.Keys([0, 1, 1, 2], q, jumps=True)


def test_an_array_of_rotations_of_scipy_is_a_stack(figure):
    times, rotations = figure
    try:
        stacked = Rotation.from_quat(rotations)
    except ValueError:
        pytest.skip("SciPy has rotations of more dimensions from 1.17 on")
    assert np.allclose(ori.CurveStack(times, stacked)(3.0), ori.CurveStack(times, rotations)(3.0))


def test_bad_tracks_are_named(tracks):
    falling = (np.array([0.0, 2.0, 1.0]), tracks[1][1][:3])
    with pytest.raises(ori.DataError, match="track 1: key 2: time 1 comes after 2, wanted strictly increasing times") as raised:
        ori.CurveStack([tracks[0], falling])
    assert (raised.value.joint, raised.value.key) == (1, 2)
    dated = (np.array([0, 1], "M8[s]"), tracks[0][1])
    for wrong, message in (([], "tracks: found none"), ([tracks[0], dated], "track 1: found times that are dates, wanted numbers"),
                           ([tracks[0], ori.Keys(np.array([0, 1000]), tracks[0][1], time_unit="ms")], "track 1: found times in ms, wanted s"),
                           ([tracks[0], ori.Keys(*tracks[1], scalar_first=True)], "track 1: found another order of quaternions"),
                           ([tracks[0], ori.Curve(*tracks[1], extrapolate="nan")], "track 1: found extrapolate='nan', wanted 'hold'")):
        with pytest.raises(ori.ArgumentError, match=message):
            ori.CurveStack(wrong)
    keys, curve = ori.Keys(*tracks[0]), ori.Curve(*tracks[0], extrapolate="nan")
    for made, more, which in (([keys], {"euler": "ZYX"}, "Keys"), ([keys, curve], {"gap": 1}, "Keys"), ([curve], {"normalize": True}, "Keys"),
                              ([curve], {"method": "slerp"}, "Curves"), ([curve], {"tension": [0.1, 0.2]}, "Curves"),
                              ([curve], {"extrapolate": "error"}, "Curves")):
        with pytest.raises(ori.ArgumentError, match=f"{next(iter(more))}: found it beside {which}, which have their own, wanted it where"):
            ori.CurveStack(made, **more)
    assert ori.CurveStack([curve], extrapolate="nan").method == "auto" and ori.CurveStack([keys], method="slerp").method == "slerp"
    with pytest.raises(TypeError, match="track 0: |wanted a pair"):
        ori.CurveStack([5])
    with pytest.raises(TypeError, match="in the place of both a list of tracks"):
        ori.CurveStack(tracks[0][0])
    with pytest.raises(ori.ArgumentError, match="positions: found it beside tracks"):
        ori.CurveStack(tracks, positions=[[[0, 0, 0]]])
    stack = ori.CurveStack(tracks)
    with pytest.raises(ori.ArgumentError, match=r"t: found the shape \(3, 2\), wanted times for all tracks, \(m,\), or a row for each of them, \(4, m\)"):
        stack(np.zeros((3, 2)))
    with pytest.raises(ori.ArgumentError, match="no positions"):
        stack.position(0.0)
    strict = ori.CurveStack(tracks, extrapolate="error")
    with pytest.raises(ori.ArgumentError, match="time 1: track 1: time -99 is outside"):
        strict(np.array([[t[0], t[0] + 0.1] if k != 1 else [t[0], -99.0] for k, (t, _) in enumerate(tracks)]))
