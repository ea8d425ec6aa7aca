# SPDX-License-Identifier: Apache-2.0
"""Curves whose keys arrive one by one, beside the curves through all of them."""
import copy
import pickle
import threading

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation

LOCAL = [method["name"] for method in ori.methods() if method["is_local"]]
RATES = ("angular_velocity", "angular_acceleration", "angular_jerk")
PATH = ("position", "velocity", "acceleration")


def filled(curve, keys, positions=None):
    for i, (t, q) in enumerate(zip(*keys)):
        curve.append(t, q, None if positions is None else positions[i])
    return curve


@pytest.mark.parametrize("method", LOCAL)
def test_what_is_final_has_the_bits_of_the_curve_through_all_keys(keys, method):
    times, rotations = keys[0][:37], keys[1][:37]  # a number that bezier takes
    positions = np.cumsum(rotations[:, :3], axis=0)
    whole = ori.Curve(times, rotations, method, positions=positions)
    online = ori.OnlineCurve(method, capacity=100)
    dice, checked = np.random.default_rng(1), 0
    for i in range(37):
        online.append(times[i], rotations[i], positions[i])
        assert len(online) == i + 1
        if i == 36:
            online.finish()
        first, last = online.available
        if last > first:
            t = dice.uniform(first, last, (4, 5))
            assert np.array_equal(online(t), whole(t)), (method, i)
            checked += 1
            for x in (t[0, 0], first):
                motion, wanted = online.motion(x), whole.motion(x)
                for name in ("orientation", *RATES, *PATH):
                    assert np.array_equal(getattr(motion, name), getattr(wanted, name)), (method, i, name)
    assert checked > 5 and online.available == whole.domain
    assert np.array_equal(online(times[-1] + 1), whole(times[-1] + 1))


def test_a_segment_is_final_when_the_keys_behind_it_are_here(keys):
    times, rotations = keys
    for method, behind in (("slerp", 0), ("timed-c2", 1), ("auto", 3)):
        online = ori.OnlineCurve(method)
        assert online.look_ahead == behind and online.available is None and len(online) == 0
        for i in range(12):
            online.append(times[i], rotations[i])
        assert online.available == (times[0], times[11 - behind])
        before = online(times[5] + 0.05)
        for i in range(12, 20):
            online.append(times[i], rotations[i])
        assert np.array_equal(online(times[5] + 0.05), before)


def test_the_newest_stay_available(keys):
    online = filled(ori.OnlineCurve("timed-c2", capacity=5), keys)
    assert online.available == (keys[0][-6], keys[0][-2])
    assert np.array_equal(online(0.0), online(online.available[0]))  # held
    assert not online.motion(0.0).angular_velocity.any()


def test_without_keys_and_at_nan_all_is_nan(keys):
    online = ori.OnlineCurve()
    assert np.isnan(online([0.0, 1.0])).all() and np.isnan(online.motion(0.0).angular_jerk).all()
    assert online.motion(0.0).position is None
    filled(online, keys)
    assert np.isnan(online([np.nan, 2.0])).all(axis=1).tolist() == [True, False]
    online.reset()
    assert len(online) == 0 and online.available is None and np.isnan(online(1.0)).all()
    filled(online, keys)
    assert online.available == (keys[0][0], keys[0][-2])


def test_shapes_orders_and_kinds(keys):
    times, rotations = keys
    online = filled(ori.OnlineCurve("timed-c2"), keys)
    first = filled(ori.OnlineCurve("timed-c2", scalar_first=True), (times, rotations[:, [3, 0, 1, 2]]))
    t = np.random.default_rng(2).uniform(*online.available, (2, 3))
    assert online(t).shape == (2, 3, 4) and online(5.0).shape == (4,) and online([]).shape == (0, 4)
    assert np.array_equal(first(t), online(t)[..., [3, 0, 1, 2]])
    assert np.array_equal(first.motion(5.0).orientation, online(5.0)[[3, 0, 1, 2]])
    for given in (Rotation.from_quat(rotations), Rotation.from_quat(rotations).as_matrix()):
        other = ori.OnlineCurve("timed-c2")
        for x, q in zip(times, given):
            other.append(x, q)
        assert np.abs(np.sum(other(t) * online(t), axis=-1)).min() > 1 - 1e-14


def test_calendars_and_counted_times(keys):
    nanoseconds = np.round((keys[0] - keys[0][0]) * 1e9).astype(np.int64)
    dates = np.datetime64("2026-11-23T12:00:00.000000001") + nanoseconds.astype("timedelta64[ns]")
    dated, counted = ori.OnlineCurve("timed-c2"), ori.OnlineCurve("timed-c2", time_unit="ns")
    whole = ori.Curve(dates, keys[1], "timed-c2")
    for i, q in enumerate(keys[1]):
        dated.append(dates[i], q)
        counted.append(nanoseconds[i] + 1_700_000_000_000_000_000, q)
    assert dated.available == (dates[0], dates[-2])
    t = dates[2:9] + np.timedelta64(50, "ms")
    assert np.array_equal(dated(t), whole(t))
    assert np.array_equal(counted(nanoseconds[2:9] + 1_700_000_000_050_000_000), whole(t))
    with pytest.raises(ori.ArgumentError, match="as the times of the keys are"):
        dated(1.0)
    with pytest.raises(ori.ArgumentError, match="as the times of the keys are"):
        dated.append(99.0, keys[1][0])


def test_settings_ends_and_what_comes_with_the_keys(keys):
    times, rotations = keys
    clamped = ori.OnlineCurve("timed-c2", start_rate=[0.1, 0.2, 0.3], ends=("clamped", "rest"), tension=0.7)
    filled(clamped, keys).finish()
    whole = ori.Curve(times, rotations, "timed-c2", start_rate=[0.1, 0.2, 0.3], ends=("clamped", "rest"), tension=0.7)
    t = np.random.default_rng(3).uniform(*whole.domain, 50)
    assert np.array_equal(clamped(t), whole(t))
    tension = np.linspace(0.2, 0.8, 40)
    each = ori.OnlineCurve("timed-c2", tension=None)
    for x, q, value in zip(times, rotations, tension):
        each.append(x, q, tension=value)
    each.finish()
    assert np.array_equal(each(t), ori.Curve(times, rotations, "timed-c2", tension=tension)(t))
    rates = np.random.default_rng(4).normal(scale=0.3, size=(40, 3))
    hermite = ori.OnlineCurve("hermite-c1")
    for x, q, w in zip(times, rotations, rates):
        hermite.append(x, q, angular_velocity=w)
    hermite.finish()
    assert np.array_equal(hermite(t), ori.Curve(times, rotations, "hermite-c1", angular_velocities=rates)(t))


def test_a_bad_key_is_named_and_leaves_the_curve_as_it_was(keys):
    times, rotations = keys
    online = filled(ori.OnlineCurve("timed-c2"), (times[:6], rotations[:6]))
    before, available = online(times[2] + 0.05), online.available
    for t, q in ((times[5], rotations[6]), (np.nan, rotations[6]), (times[6], [0, 0, 0, 2]), (times[6], [0, 0, 0, np.nan])):
        with pytest.raises(ori.DataError) as found:
            online.append(t, q)
        assert found.value.key == 6
    for wrong in (lambda: online.append(times[6:8], rotations[6]), lambda: online.append(times[6], rotations[6][:3]),
                  lambda: online.append(times[6], rotations[6], [1, 2]), lambda: online.motion([1, 2]),
                  lambda: online.append(times[6], rotations[6], tension=0.4)):
        with pytest.raises(ori.Error):
            wrong()
    with pytest.raises(ori.Error):
        online.append(times[6], rotations[6], [1.0, 2.0, 3.0])  # the others have no position
    assert len(online) == 6 and online.available == available
    assert np.array_equal(online(times[2] + 0.05), before)
    online.append(times[6], rotations[6])
    online.finish()
    with pytest.raises(ori.ArgumentError, match="finished"):
        online.append(times[7], rotations[7])
    with pytest.raises(ori.DataError, match="no keys"):
        ori.OnlineCurve().finish()


@pytest.mark.parametrize("arguments, message", [
    (dict(method="global-c2"), "has no online curve"), (dict(method="nothing"), "nothing"), (dict(capacity=1), "capacity"),
    (dict(capacity=10**7), "capacity"), (dict(capacity=2.5), "capacity"), (dict(capacity=-1), "capacity"),
    (dict(tension=[1, 2]), "tension"), (dict(bend=1), "bend"), (dict(ends="handle"), "handle"), (dict(signs="any"), "signs")])
def test_what_cannot_be_is_refused(arguments, message):
    with pytest.raises(ori.ArgumentError, match=message):
        ori.OnlineCurve(**arguments)


def test_it_cannot_be_copied(keys):
    online = filled(ori.OnlineCurve(), keys)
    for attempt in (lambda: pickle.dumps(online), lambda: copy.copy(online)):
        with pytest.raises(TypeError, match="cannot be pickled or copied"):
            attempt()


def test_threads_may_append_and_ask_at_the_same_time():
    online, seen, stop = ori.OnlineCurve("timed-c2", capacity=16), [], threading.Event()
    half = 0.01
    step = Rotation.from_rotvec([0, 0, 2 * half])

    def ask():
        while not stop.is_set():
            available = online.available
            if available is None:
                continue
            q = online(np.linspace(*available, 50))
            w = online.motion(available[1]).angular_velocity
            seen.append((np.abs(np.linalg.norm(q, axis=1) - 1).max(), w[2]))

    threads = [threading.Thread(target=ask) for _ in range(4)]
    for thread in threads:
        thread.start()
    try:
        turn = Rotation.identity()
        for i in range(4000):
            online.append(0.1 * i, turn)
            turn = turn * step
    finally:
        stop.set()
        for thread in threads:
            thread.join()
    assert len(online) == 4000 and len(seen) > 10
    assert max(norm for norm, _ in seen) < 1e-12
    assert all(w == 0 or abs(w - 0.2) < 0.11 for _, w in seen)  # at the start the end rule is felt
