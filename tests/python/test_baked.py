# SPDX-License-Identifier: Apache-2.0
"""Baked curves: their tolerance, their rates, and storing them."""
import copy
import pickle
import subprocess
import sys

import numpy as np
import orispline as ori
import pytest
from conftest import product
from scipy.spatial.transform import Rotation


@pytest.fixture
def curve(keys):
    return ori.Curve(*keys, "squad")


def inside(curve, count=4000):
    return np.random.default_rng(7).uniform(*curve.domain, count)


def off(baked, curve, t):
    """Twice the distance in R⁴: what the tolerance bounds."""
    return 2 * np.linalg.norm(baked(t).astype(float) - curve(t), axis=-1).max()


@pytest.mark.parametrize("method", ["auto", "slerp", "squad", "timed-c2", "global-c2", "circular"])
def test_orientations_are_within_the_tolerance(keys, method):
    curve = ori.Curve(*keys, method)
    t = inside(curve)
    for tolerance in (1e-4, 1e-8, 1e-12):
        baked = curve.bake(tolerance)
        assert off(baked, curve, t) <= tolerance and baked.largest_difference <= tolerance / 2
        assert baked.domain == curve.domain and baked.dtype == np.float64 and baked(t).dtype == np.float64
    single = curve.bake(1e-5, dtype="float32")
    assert off(single, curve, t) <= 1e-5 and single(t).dtype == np.float32
    assert single.nbytes / len(single) < baked.nbytes / len(baked) / 2


def test_fewer_pieces_are_worse_and_smaller(curve):
    rough, fine = curve.bake(1e-4), curve.bake(1e-11)
    assert len(curve.times) - 1 <= len(rough) < len(fine) and rough.nbytes < fine.nbytes
    assert repr(fine).startswith("BakedCurve(0.337039 … 38.6922 s, float64, ")


def test_rates_are_the_derivatives_of_its_orientations(curve):
    baked, h = curve.bake(1e-10), 1e-5
    ends = baked._core.parts[0]
    t = inside(curve, 300)
    t = t[np.abs(t[:, None] - ends).min(axis=1) > 10 * h]
    step = np.array([product(p * [-1, -1, -1, 1], q) for p, q in zip(baked(t - h), baked(t + h))])
    assert np.allclose(step[:, :3] / h, baked.angular_velocity(t), atol=1e-6)
    for rate, derivative in (("angular_velocity", "angular_acceleration"), ("angular_acceleration", "angular_jerk")):
        for frame in ("body", "world"):
            at = getattr(baked, rate)
            difference = (at(t + h, frame=frame) - at(t - h, frame=frame)) / (2 * h)
            wanted = getattr(baked, derivative)(t, frame=frame)
            assert np.allclose(difference, wanted, atol=1e-5 * np.abs(wanted).max()), (rate, frame)
    turned = Rotation.from_quat(baked(t)).apply(baked.angular_velocity(t))
    assert np.allclose(baked.angular_velocity(t, frame="world"), turned, atol=1e-12)
    assert np.allclose(baked.angular_velocity(t), curve.angular_velocity(t), atol=1e-7)
    assert np.allclose(baked.rotation(t).as_quat(), baked(t) / np.linalg.norm(baked(t), axis=1, keepdims=True), atol=1e-15)


def test_shapes_and_orders_of_times(curve):
    baked = curve.bake(1e-9)
    t = inside(curve, 6000)
    for at, width in ((baked, 4), (baked.angular_velocity, 3), (baked.angular_jerk, 3)):
        rows = at(t)
        assert rows.shape == (6000, width) and np.array_equal(at(t.reshape(2, 30, 100)), rows.reshape(2, 30, 100, width))
        assert np.array_equal(at(np.sort(t)), rows[np.argsort(t)])
        assert np.array_equal(at(float(t[5])), rows[5]) and at([]).shape == (0, width)
        out = np.empty_like(rows)
        assert at(t, out=out) is out and np.array_equal(out, rows)
    world = baked.angular_acceleration(t, frame="world")
    assert np.array_equal(baked.angular_acceleration(t[5000], frame="world"), world[5000])


def test_outside_it_is_at_rest(curve):
    baked = curve.bake(1e-9)
    first, last = baked.domain
    assert np.array_equal(baked([first - 1, last + 1]), baked([first, last]))
    assert not baked.angular_velocity([first - 1, last + 1]).any()
    assert np.isnan(baked(np.nan)).all()


@pytest.mark.parametrize("dtype", ["float64", "float32"])
def test_it_is_stored_with_all_its_bits(keys, tmp_path, dtype):
    baked = ori.Curve(*keys).bake(1e-6, dtype=dtype)
    path = tmp_path / "motion.pickle"
    path.write_bytes(pickle.dumps(baked, protocol=5))
    program = ("import pickle, sys, numpy; baked = pickle.load(open(sys.argv[1], 'rb')); "
               "numpy.save(sys.argv[2], baked.angular_jerk(numpy.linspace(0, 40, 999))); print(repr(baked))")
    words = [sys.executable, "-c", program, path, tmp_path / "jerk.npy"]
    told = subprocess.run(words, check=True, capture_output=True, encoding="utf-8")
    assert np.array_equal(np.load(tmp_path / "jerk.npy"), baked.angular_jerk(np.linspace(0, 40, 999)))
    assert told.stdout.strip() == repr(baked)
    for again in (copy.deepcopy(baked), pickle.loads(pickle.dumps(baked))):
        t = np.linspace(-1, 41, 1000)
        assert np.array_equal(again(t), baked(t)) and again.largest_difference == baked.largest_difference


def test_it_takes_times_and_gives_orders_as_its_curve(keys):
    times, rotations = keys
    dates = np.datetime64("2026-11-22T12:00") + (times * 1e9).astype("timedelta64[ns]")
    curve = ori.Curve(dates, rotations[:, [3, 0, 1, 2]], scalar_first=True)
    baked = pickle.loads(pickle.dumps(curve.bake(1e-10)))
    assert baked.domain == curve.domain and np.allclose(baked(dates), curve(dates), atol=1e-10)
    assert np.allclose(baked.rotation(dates).as_quat(), curve.rotation(dates).as_quat(), atol=1e-10)
    out = np.empty((40, 4))
    assert baked(dates, out=out) is out and np.array_equal(out, baked(dates))
    with pytest.raises(ori.ArgumentError, match="as the times of the keys are"):
        baked(1.0)


def test_one_key_is_one_piece():
    baked = ori.Curve([5.0], [[0, 0, 0.6, 0.8]]).bake(1e-9)
    assert len(baked) == 1 and np.array_equal(baked([4, 6]), [[0, 0, 0.6, 0.8]] * 2)
    assert np.array_equal(pickle.loads(pickle.dumps(baked))(5.0), [0, 0, 0.6, 0.8])


CURVE = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
BAKED = CURVE.bake(1e-6)
PARTS = BAKED.__reduce__()


def restored(**others):
    names = ("ends", "coefficients", "scales", "largest_difference", "clock", "scalar_first")
    return PARTS[0](*{**dict(zip(names, PARTS[1])), **others}.values())


BAD = [
    ("tolerance 0", lambda: CURVE.bake(0), ori.ArgumentError, "wanted a number from 1e-13 on"),
    ("tolerance NaN", lambda: CURVE.bake(np.nan), ori.ArgumentError, "wanted a number from 1e-13 on"),
    ("tolerance of float32", lambda: CURVE.bake(1e-9, dtype="float32"), ori.ArgumentError, "wanted a number from 1e-06 on"),
    ("tolerance as text", lambda: CURVE.bake("fine"), ori.ArgumentError, "tolerance: found 'fine', wanted a number of radians"),
    ("tolerances", lambda: CURVE.bake([1e-6, 1e-7]), ori.ArgumentError, "tolerance: found [1e-06, 1e-07]"),
    ("dtype", lambda: CURVE.bake(1e-6, dtype=int), ori.ArgumentError, "dtype: found int64, wanted float64 or float32"),
    ("frame", lambda: BAKED.angular_velocity(1.0, frame="camera"), ori.ArgumentError, "frame: found 'camera'"),
    ("short out", lambda: BAKED([1.0], out=np.empty((2, 4))), ori.ArgumentError, "out: found an array (2, 4)"),
    ("text", lambda: BAKED("now"), ori.ArgumentError, "wanted real numbers"),
    ("made by hand", lambda: ori.BakedCurve(), TypeError, "wanted curve.bake(tolerance)"),
    ("ends that fall", lambda: restored(ends=PARTS[1][0][::-1].copy()), ori.DataError, "ends of pieces that do not increase"),
    ("ends that are missing", lambda: restored(ends=PARTS[1][0][:-1].copy()), ori.DataError, "pieces, wanted"),
    ("scales that are missing", lambda: restored(scales=PARTS[1][2][1:].copy()), ori.DataError, "pieces without their times"),
    ("broken pieces", lambda: restored(coefficients=PARTS[1][1] * np.nan), ori.DataError, "not finite"),
    ("pieces of no orientations", lambda: restored(coefficients=PARTS[1][1] * 1e300), ori.DataError, "found no orientations on all of it"),
]


@pytest.mark.parametrize(("ask", "error", "text"), [case[1:] for case in BAD], ids=[case[0] for case in BAD])
def test_bad_input(ask, error, text):
    with pytest.raises(error) as found:
        ask()
    assert text in str(found.value) and "\n" not in str(found.value)


def test_a_tolerance_that_cannot_be_reached_names_the_key():
    curve = ori.Curve([0.0, 1.0, 1.0 + 1e-9, 2.0, 3.0], Rotation.random(5, random_state=3), "timed-c2")
    with pytest.raises(ori.ArgumentError, match="ask for a much larger tolerance, or a curve that turns less there") as found:
        curve.bake(1e-6)
    assert found.value.key == 0


def test_a_tolerance_that_is_missed_names_one_that_is_kept():
    near = [0.0, 1.0, 1.0000001, 2.0, 3.0], [[0, 0, 0, 1], [0.8, 0, 0, 0.6], [0, 0.8, 0, 0.6], [0, 0, 1, 0], [0, 0, 0, 1]]
    curve = ori.Curve(*near, "rational")
    with pytest.raises(ori.ArgumentError, match=" rad or more, which all of the curve keeps to") as found:
        curve.bake(1e-6, dtype="float32")
    offered = float(str(found.value).split("ask for ")[1].split()[0])
    assert offered > 1e-6 and 2 * curve.bake(offered, dtype="float32").largest_difference <= offered
