# SPDX-License-Identifier: Apache-2.0
"""Curves: shapes, orders, frames, bits, and SciPy beside."""
import concurrent.futures
import copy
import datetime
import fractions
import pickle
import sys
import threading
import time
import warnings

import numpy as np
import orispline as ori
import pytest
from conftest import product

QUANTITIES = ("__call__", "angular_velocity", "angular_acceleration", "angular_jerk", "position", "velocity", "acceleration")
METHODS = [method["name"] for method in ori.methods()]


@pytest.fixture
def curve(keys):
    times, rotations = keys
    return ori.Curve(times, rotations, positions=np.cumsum(rotations[:, :3], axis=0))


def inside(curve, count, seed=5):
    return np.random.default_rng(seed).uniform(*curve.domain, count)


@pytest.mark.parametrize("name", QUANTITIES)
def test_every_shape_and_order_of_times_has_the_same_rows(curve, name):
    at = getattr(curve, name)
    t = inside(curve, 24)
    rows = at(t)
    assert rows.shape == (24, 4 if name == "__call__" else 3)
    assert np.array_equal(at(t.reshape(2, 3, 4)), rows.reshape(2, 3, 4, -1))
    order = np.argsort(t)
    assert np.array_equal(at(t[order]), rows[order])
    assert np.array_equal([at(float(x)) for x in t], rows) and np.array_equal([at(x) for x in t[:3]], rows[:3])
    assert at(float(t[0])).shape == rows.shape[1:]
    assert at([]).shape == (0, rows.shape[1])
    out = np.empty_like(rows)
    assert at(t, out=out) is out and np.array_equal(out, rows)
    assert np.array_equal(at(t, threads=4), rows)
    single = at(t, dtype="float32")
    assert single.dtype == np.float32 and np.allclose(single, rows, rtol=1e-5, atol=1e-4 * np.abs(rows).max())


def test_rates_are_the_derivatives_of_the_orientation(curve):
    t, h = inside(curve, 200), 1e-5
    t = t[np.abs(t[:, None] - curve.times).min(axis=1) > 10 * h]
    before, after = curve(t - h), curve(t + h)
    step = np.array([product(p * [-1, -1, -1, 1], q) for p, q in zip(before, after)])
    assert np.allclose(step[:, :3] / h, curve.angular_velocity(t), atol=1e-6)
    for rate, derivative in (("angular_velocity", "angular_acceleration"), ("angular_acceleration", "angular_jerk"),
                             ("position", "velocity"), ("velocity", "acceleration")):
        difference = (getattr(curve, rate)(t + h) - getattr(curve, rate)(t - h)) / (2 * h)
        wanted = getattr(curve, derivative)(t)
        assert np.allclose(difference, wanted, atol=1e-5 * max(1, np.abs(wanted).max())), rate


def test_rates_in_the_world_frame(curve):
    from scipy.spatial.transform import Rotation
    t, h = inside(curve, 50), 1e-5
    t = t[np.abs(t[:, None] - curve.times).min(axis=1) > 10 * h]
    turned = Rotation.from_quat(curve(t)).apply(curve.angular_velocity(t))
    assert np.allclose(curve.angular_velocity(t, frame="world"), turned, atol=1e-12)
    for rate, derivative in (("angular_velocity", "angular_acceleration"), ("angular_acceleration", "angular_jerk")):
        difference = (getattr(curve, rate)(t + h, frame="world") - getattr(curve, rate)(t - h, frame="world")) / (2 * h)
        wanted = getattr(curve, derivative)(t, frame="world")
        assert np.allclose(difference, wanted, atol=1e-5 * np.abs(wanted).max()), rate
    samples = curve.sample(times=t, derivatives=3, frame="world")
    assert np.allclose(samples.angular_jerks, curve.angular_jerk(t, frame="world"), atol=1e-9)


def test_motion_has_all_at_one_time(curve):
    motion = curve.motion(7.25)
    assert np.array_equal(motion.orientation, curve(7.25))
    for name in QUANTITIES[1:]:
        assert np.array_equal(getattr(motion, name), getattr(curve, name)(7.25))


@pytest.mark.parametrize("scalar_first", [False, True])
@pytest.mark.parametrize("positions", [None, [[0, 0, 0], [1, 2, 3], [2, 2, 2]]])
@pytest.mark.parametrize("dtype", ["float64", "float32"])
def test_samples_fill_arrays(dtype, positions, scalar_first):
    curve = ori.Curve([0, 1, 3], [[0.1, 0.1, 0.1, 0.985], [0, 0, 0.6, 0.8], [0, 0.6, 0.8, 0]], positions=positions, normalize=True,
                      scalar_first=scalar_first)
    wanted = curve.sample(rate=7, derivatives=1, dtype=dtype)
    rows = [row for row in (wanted.orientations, wanted.angular_velocities, wanted.positions, wanted.velocities) if row is not None]
    out = [np.full_like(row, np.nan) for row in rows]
    found = curve.sample(rate=7, derivatives=1, dtype=dtype, out=out)
    assert found.orientations is out[0] and found.angular_velocities is out[1] and found.angular_jerks is None
    assert all(np.array_equal(a, b) for a, b in zip(out, rows))
    if positions is None:
        alone = np.empty_like(rows[0])
        assert curve.sample(rate=7, dtype=dtype, out=alone).orientations is alone and np.array_equal(alone, rows[0])
        assert curve.angular_velocity(0.5, "world").tolist() == curve.angular_velocity(0.5, frame="world").tolist()


def test_samples_of_a_rate_a_count_and_times(curve):
    first, last = curve.domain
    samples = curve.sample(rate=8, derivatives=2)
    assert samples.times[0] == first and samples.times[-1] <= last < samples.times[-1] + 1 / 8
    assert np.allclose(np.diff(samples.times), 1 / 8)
    assert curve.sample(rate=8, include_end=True).times[-1] == last
    assert np.allclose(samples.orientations, curve(samples.times), atol=1e-14)
    assert np.allclose(samples.angular_accelerations, curve.angular_acceleration(samples.times), atol=1e-10)
    assert samples.angular_jerks is None and samples.accelerations.shape == (len(samples), 3)
    count = curve.sample(count=5)
    assert np.allclose(count.times, np.linspace(first, last, 5)) and count.times[-1] == last
    assert np.array_equal(curve.sample(rate=fractions.Fraction(30000, 1001)).times, curve.sample(rate="30000/1001").times)
    assert np.array_equal(curve.sample(times=[3, 5]).orientations, curve([3.0, 5.0]))
    part = curve.sample(rate=4, start=2, end=4)
    assert part.times.tolist() == [2 + k / 4 for k in range(9)]
    for threads in (0, 3):
        again = curve.sample(rate=800, derivatives=3, threads=threads)
        alone = curve.sample(rate=800, derivatives=3)
        assert all(np.array_equal(getattr(again, name), getattr(alone, name))
                   for name in ("times", "orientations", "angular_velocities", "angular_jerks", "positions"))


def test_scalar_first_is_said_once(keys):
    times, rotations = keys
    plain, first = ori.Curve(times, rotations), ori.Curve(times, rotations[:, [3, 0, 1, 2]], scalar_first=True)
    t = inside(plain, 9)
    assert np.array_equal(first(t), plain(t)[:, [3, 0, 1, 2]])
    assert np.array_equal(first(2.0), plain(2.0)[[3, 0, 1, 2]])
    assert np.array_equal(first.sample(times=t).orientations, first(t))
    assert np.array_equal(first.keys.rotations, plain.keys.rotations[:, [3, 0, 1, 2]])
    out = np.empty((9, 4))
    assert first(t, out=out) is out and np.array_equal(out, first(t))


def test_matrices_and_rotations_are_the_same_keys(keys):
    from scipy.spatial.transform import Rotation
    times, quaternions = keys
    rotations = Rotation.from_quat(quaternions)
    t = np.linspace(times[0], times[-1], 50)
    wanted = ori.Curve(times, quaternions)(t)
    for given in (rotations, rotations.as_matrix()):
        curve = ori.Curve(times, given)
        assert np.abs(np.sum(curve(t) * wanted, axis=1)).min() > 1 - 1e-14
        assert np.allclose(curve.rotation(t).as_quat() * np.sign(np.sum(curve(t) * wanted, axis=1))[:, None], wanted, atol=1e-12)
    for axis in np.eye(3):  # half turns, where the scalar part is 0
        turn = Rotation.from_rotvec(np.pi * axis)
        key = ori.Keys([0, 1], np.stack([np.eye(3), turn.as_matrix()])).rotations[1]
        assert np.allclose(np.abs(key), np.abs(turn.as_quat()), atol=1e-15)


def test_datetimes_and_timestamps_are_dates():
    pandas = pytest.importorskip("pandas")
    stamps = pandas.date_range("2026-11-22T12:00:00.000000007", periods=3, freq="s")
    q = [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
    curve = ori.Curve(stamps, q)
    for same in (list(stamps), pandas.Series(stamps), stamps.to_numpy()):
        assert ori.Curve(same, q).times.tolist() == curve.times.tolist() == stamps.astype("int64").tolist()
    one = stamps[1]
    assert np.array_equal(curve(one), curve(one.to_datetime64())) and curve(one).shape == (4,)
    assert curve([one, pandas.NaT]).shape == (2, 4) and np.isnan(curve(pandas.NaT)).all()
    plain = datetime.datetime(2026, 11, 22, 12, 0, 1)
    assert np.array_equal(curve(plain), curve(np.datetime64(plain, "ns")))
    assert curve.sample(rate=4, start=plain).times[0] == np.datetime64(plain, "ns")
    assert curve.angle_travelled(one) == curve.angle_travelled(one.to_datetime64())
    assert np.array_equal(ori.Curve(stamps.tz_localize("UTC"), q).times, curve.times)


def test_calendars_are_differenced_as_integers(keys):
    times, rotations = keys
    nanoseconds = np.round(times * 1e9).astype(np.int64)
    seconds = (nanoseconds - nanoseconds[0]) / 1e9
    plain = ori.Curve(seconds, rotations)
    start = np.datetime64("2026-11-22T12:00:00.000000007")
    dates = start + (nanoseconds - nanoseconds[0]).astype("timedelta64[ns]")
    dated = ori.Curve(dates, rotations)
    asked = seconds[:-1] + 0.0625
    assert np.allclose(dated(dates[:-1] + np.timedelta64(62_500_000, "ns")), plain(asked), atol=1e-14)
    assert dated.domain == (dates[0], dates[-1]) and dated.times.dtype == "datetime64[ns]"
    assert np.array_equal(dated.times, dates)
    samples = dated.sample(rate=10, start=dates[3])
    assert samples.times[0] == dates[3] and samples.times[1] - samples.times[0] == np.timedelta64(100, "ms")
    assert np.isnan(dated(np.array(["NaT", str(dates[5])], "datetime64[ns]"))[:, 0]).tolist() == [True, False]
    ints = ori.Curve(nanoseconds + 1_700_000_000_000_000_000, rotations, time_unit="ns")
    assert np.array_equal(ints.times, nanoseconds + 1_700_000_000_000_000_000)
    assert np.array_equal(ints(ints.times), plain(seconds))
    for wrong in (lambda: dated(1.0), lambda: plain(dates), lambda: plain.sample(times=dates)):
        with pytest.raises(ori.ArgumentError, match="as the times of the keys are"):
            wrong()


def test_outside_the_curve(keys):
    first, last = keys[0][[0, -1]]
    t = [first - 1, first, last, last + 1]
    hold, error, nan = (ori.Curve(*keys, extrapolate=how) for how in ("hold", "error", "nan"))
    assert np.array_equal(hold(t)[[0, 3]], hold([first, last]))
    assert np.array_equal(hold.angular_velocity(t)[[0, 3]], np.zeros((2, 3)))
    assert np.isnan(nan(t)).any(axis=1).tolist() == [True, False, False, True]
    assert np.isnan(nan(first - 1)).all() and np.isnan(nan.sample(times=t).orientations[0]).all()
    for ask in (lambda: error(t), lambda: error(last + 1), lambda: error.sample(times=t), lambda: error.angular_jerk(t)):
        with pytest.raises(ori.ArgumentError, match="is outside the curve, wanted"):
            ask()
    with pytest.raises(ori.ArgumentError) as found:
        error([first, last, last + 1])
    assert found.value.time_index == 2


@pytest.mark.parametrize("method", METHODS)
def test_every_method_makes_a_curve_that_survives_pickling(keys, method):
    times, rotations = (np.arange(40.0) if method == "nu-exact" else keys[0], keys[1])
    if method == "bezier":
        rotations = rotations[:37]
    try:
        curve = ori.Curve(times[:len(rotations)], rotations, method)
    except ori.ConvergenceError:
        assert method == "nu-exact"
        return
    t = inside(curve, 30)
    for other in (pickle.loads(pickle.dumps(curve, 5)), copy.deepcopy(curve), curve.keys.curve(curve.method)):
        assert np.array_equal(other(t), curve(t)) and repr(other) == repr(curve)
    assert curve.info["name"] == method


def test_settings_and_ends(keys):
    t = inside(ori.Curve(*keys), 20)
    tension = np.linspace(0.1, 0.9, 40)
    assert np.array_equal(ori.Curve(*keys, "quintic", tension=0.4)(t), ori.Curve(*keys, "quintic:tension=0.4")(t))
    assert np.array_equal(ori.Curve(*keys, "quintic", tension=tension)(t),
                          ori.Curve(ori.Keys(*keys, settings={"tension": tension}), method="quintic")(t))
    assert ori.Curve(*keys, "squad-timed", variant="boyle").method == "squad-timed:variant=boyle"
    rest = ori.Curve(*keys, "timed-c2", ends=("rest", "natural"))
    assert np.allclose(rest.angular_velocity(rest.domain[0]), 0, atol=1e-14)
    clamped = ori.Curve(*keys, "timed-c2", start_rate=[0.1, 0.2, 0.3])
    assert np.allclose(clamped.angular_velocity(clamped.domain[0]), [0.1, 0.2, 0.3], atol=1e-13)
    loop = ori.Curve(*keys, "timed-c2", period=60.0)
    assert loop.domain[1] - loop.domain[0] == 60.0
    assert np.allclose(loop.angular_velocity(loop.domain[0]), loop.angular_velocity(loop.domain[1]), atol=1e-10)


def test_threads_share_a_curve_and_the_interpreter_is_free_meanwhile(keys):
    curve = ori.Curve(*keys)
    t = inside(curve, 50_000)
    wanted = curve(t)
    with concurrent.futures.ThreadPoolExecutor(8) as pool:
        assert all(np.array_equal(q, wanted) for q in pool.map(lambda _: curve(t), range(32)))
    counted, stop = [0], threading.Event()

    def count():
        while not stop.is_set():
            counted[0] += 1
            time.sleep(0)  # gives the lock back

    many = np.sort(inside(curve, 300_000))
    interval = sys.getswitchinterval()
    thread = threading.Thread(target=count)
    sys.setswitchinterval(3600)  # without the release of the lock nobody else gets a turn
    try:
        thread.start()
        before = counted[0]
        for _ in range(100):  # whenever the machine lets the other thread run
            curve(many)
            if counted[0] > before:
                break
    finally:
        stop.set()
        sys.setswitchinterval(interval)
    thread.join()
    assert counted[0] > before


def test_scipy_has_the_same_curves():
    from scipy.spatial.transform import Rotation, RotationSpline, Slerp
    dice = np.random.default_rng(8)
    times = np.cumsum(dice.uniform(0.6, 1.4, 300))
    rotations = Rotation.from_rotvec(np.cumsum(dice.normal(scale=0.5, size=(300, 3)), axis=0))
    t = np.sort(dice.uniform(times[0], times[-1], 2000))
    ours, theirs = ori.Curve(times, rotations, "rotation-spline"), RotationSpline(times, rotations)
    assert (ours.rotation(t).inv() * theirs(t)).magnitude().max() < 1e-9
    assert np.abs(ours.angular_velocity(t) - theirs(t, 1)).max() < 1e-9
    assert np.abs(ours.angular_acceleration(t) - theirs(t, 2)).max() < 1e-8
    slerp = ori.Curve(times, rotations, "slerp")
    assert (slerp.rotation(t).inv() * Slerp(times, rotations)(t)).magnitude().max() < 1e-12


def test_both_sides_of_a_jump():
    turned = lambda degrees: [0, 0, np.sin(np.radians(degrees / 2)), np.cos(np.radians(degrees / 2))]
    curve = ori.Curve([0, 1, 3], [turned(0), turned(80), turned(120)], "slerp", positions=np.zeros((3, 3)))
    left, right = curve.motion(1.0, side="left"), curve.motion(1.0)
    np.testing.assert_allclose(left.angular_velocity, [0, 0, np.radians(80)], atol=1e-14)
    np.testing.assert_allclose(right.angular_velocity, [0, 0, np.radians(20)], atol=1e-14)
    np.testing.assert_allclose(left.orientation, right.orientation, rtol=0, atol=1e-15)
    np.testing.assert_allclose(curve.motion(1.0, side="left", frame="world").angular_velocity, left.angular_velocity, atol=1e-14)
    for t in (0.0, 0.5, 3.0, -1.0, 4.0):  # nothing jumps there
        np.testing.assert_allclose(curve.motion(t, side="left").angular_velocity, curve.motion(t).angular_velocity, atol=1e-14)
    with pytest.raises(ori.ArgumentError, match="side: found 'before', wanted 'right' or 'left'"):
        curve.motion(1.0, side="before")


def about_z(angles):
    half = 0.5 * np.asarray(angles)
    return np.stack([0 * half, 0 * half, np.sin(half), np.cos(half)], axis=-1)


def test_what_is_noteworthy_about_a_curve_is_told_once_when_it_is_made():
    steady, times = about_z(0.5 * np.arange(9)), np.arange(9.0)
    near = np.where(times == 3.0, 3.98, times)
    with pytest.warns(ori.ShapeWarning) as told:
        curve = ori.Curve(near, steady)
    assert [warning.message.code for warning in told] == ["overturned_span"] and told[0].filename == __file__
    assert "the keys at 3.98 s and 4 s are too near in time" in str(told[0].message)
    assert told[0].message.numbers["turn_deg"] > 2 * told[0].message.numbers["turn_of_keys_deg"]
    with pytest.warns(ori.ShapeWarning, match="^joint 1: .*too near in time") as told:
        ori.CurveStack(near, np.stack([0 * steady + [0, 0, 0, 1], steady], axis=1))
    assert len(told) == 1
    with pytest.warns(ori.ShapeWarning) as told:
        ori.Curve([0, 1, 2, 4, 5], steady[:5], ori.blending("jumping", [["0", "h/h_1"]]))
    assert [warning.message.code for warning in told] == ["jump_at_key"]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ori.Curve(times, steady)
        ori.Curve(near, steady, "slerp")
        pickle.loads(pickle.dumps(curve))
