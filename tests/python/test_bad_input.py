# SPDX-License-Identifier: Apache-2.0
"""Bad input has one line that says what was found and what was wanted, and never crashes."""
import datetime

import numpy as np
import orispline as ori
import pytest

Q = [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
T = [0, 1, 3]
SHARED = np.linspace(0, 3, 20)
READ_ONLY = np.empty((3, 4))
READ_ONLY.flags.writeable = False
KEYS = [
    ("equal times", lambda: ori.Keys([0, 1, 1], Q), ori.DataError, "duplicate time 1", 2),
    ("decreasing times", lambda: ori.Keys([0, 2, 1], Q), ori.DataError, "wanted strictly increasing times", 2),
    ("NaN", lambda: ori.Keys([0, np.nan, 1], Q), ori.DataError, "nan", 1),
    ("infinite time", lambda: ori.Keys([0, 1, np.inf], Q), ori.DataError, "inf", 2),
    ("NaT", lambda: ori.Keys(np.array(["2024-01-01", "NaT", "2024-01-03"], "datetime64[D]"), Q), ori.DataError, "found NaT", 1),
    ("integers without a unit", lambda: ori.Keys(np.array([0, 1, 2]) + 10**15, Q), ori.ArgumentError, "wanted time_unit=", None),
    ("unknown unit", lambda: ori.Keys(T, Q, time_unit="min"), ori.ArgumentError, "time_unit: found 'min', wanted one of", None),
    ("unit of floats", lambda: ori.Keys([0.0, 1.0, 3.0], Q, time_unit="ms"), ori.ArgumentError, "wanted integers", None),
    ("fewer rotations", lambda: ori.Keys(T, Q[:2]), ori.DataError, "rotations: found 2, wanted one for each of the 3 times", None),
    ("fewer positions", lambda: ori.Keys(T, Q, positions=[[0, 0, 0]]), ori.DataError, "positions: found 1, wanted one for each", None),
    ("(n, 3)", lambda: ori.Keys(T, np.zeros((3, 3))), ori.ArgumentError, "rotations: found the shape (3, 3), wanted (n, 4)", None),
    ("(4, n)", lambda: ori.Keys(T, np.zeros((4, 3))), ori.ArgumentError, "found the shape (4, 3)", None),
    ("(n, 4, 1)", lambda: ori.Keys(T, np.zeros((3, 4, 1))), ori.ArgumentError, "found the shape (3, 4, 1)", None),
    ("times in a table", lambda: ori.Keys([T], Q), ori.ArgumentError, "times: found the shape (1, 3), wanted (n,)", None),
    ("norms off", lambda: ori.Keys(T, np.multiply(Q, 1.1)), ori.DataError, "norm 1.1", 0),
    ("zero quaternion", lambda: ori.Keys(T, [*Q[:2], [0, 0, 0, 0]]), ori.DataError, "norm 0", 2),
    ("zero normalized", lambda: ori.Keys(T, [*Q[:2], [0, 0, 0, 0]], normalize=True), ori.DataError, "key 2", 2),
    ("reflection", lambda: ori.Keys([0], [np.diag([1, 1, -1.0])]), ori.DataError, "found a matrix that is no rotation", 0),
    ("complex", lambda: ori.Keys(T, np.array(Q, complex)), ori.ArgumentError, "complex128", None),
    ("objects", lambda: ori.Keys(T, np.array([[None] * 4] * 3, object)), ori.ArgumentError, "objects of type NoneType", None),
    ("strings", lambda: ori.Keys(["a", "b", "c"], Q), ori.ArgumentError, "wanted real numbers", None),
    ("no rotations", lambda: ori.Keys(T, None), ori.ArgumentError, "rotations: found an object of type NoneType", None),
    ("Euler angles", lambda: ori.Keys(T, [[0, 0, 1]] * 3), ori.ArgumentError,
     "rotations: found the shape (3, 3), wanted (n, 4) quaternions, (n, 3, 3) matrices or a SciPy Rotation", None),
    ("ragged rows", lambda: ori.Keys(T, [[0, 0, 0, 1], [0, 0, 1]]), ori.ArgumentError, "rotations: found rows of different lengths", None),
    ("masked rows", lambda: ori.Keys(T, np.ma.array(Q, mask=np.eye(3, 4))), ori.ArgumentError, "rotations: found masked values", None),
    ("norm 0 to be normalized", lambda: ori.Keys(T, [Q[0], [0] * 4, Q[2]], normalize=True), ori.DataError, "the quaternion has norm 0", 1),
    ("no keys", lambda: ori.Keys([], np.empty((0, 4))), ori.DataError, "no keys", None),
    ("no dates", lambda: ori.Keys(np.array([], "datetime64[ns]"), np.empty((0, 4))), ori.DataError, "no keys", None),
    ("signs", lambda: ori.Keys(T, Q, signs="long"), ori.ArgumentError, "signs: found 'long'", None),
    ("short setting", lambda: ori.Keys(T, Q, settings={"tension": [1]}), ori.ArgumentError, "found 1 values, wanted one per key, 3", None),
]
CURVES = [
    ("method", lambda: ori.Curve(T, Q, "quntic"), ori.ArgumentError, "did you mean 'quintic'?"),
    ("setting", lambda: ori.Curve(T, Q, "quintic", tensoin=1), ori.ArgumentError, "tensoin"),
    ("value", lambda: ori.Curve(T, Q, "quintic", tension="high"), ori.ArgumentError, "high"),
    ("values per key", lambda: ori.Curve(T, Q, "quintic", tension=[0.1, 0.2]), ori.ArgumentError, "found 2 values of tension"),
    ("table of values", lambda: ori.Curve(T, Q, "quintic", tension=[[1]]), ori.ArgumentError, "tension: found the shape (1, 1)"),
    ("ends", lambda: ori.Curve(T, Q, "timed-c2", ends="soft"), ori.ArgumentError, "soft"),
    ("rate of an end", lambda: ori.Curve(T, Q, "timed-c2", start_rate=1), ori.ArgumentError, "start_rate: found the shape ()"),
    ("extrapolate", lambda: ori.Curve(T, Q, extrapolate="far"), ori.ArgumentError, "extrapolate: found 'far'"),
    ("rate that is NaN", lambda: ori.Curve(T, Q, "timed-c2", start_rate=[0, np.nan, 0]), ori.ArgumentError,
     "start_rate: found [0.0, nan, 0.0], wanted three finite numbers"),
    ("few keys", lambda: ori.Curve(T[:2], Q[:2], "beta-g2"), ori.DataError, "beta-g2"),
]
CURVE = ori.Curve(T, Q)
DATED = ori.Curve(np.datetime64("2024-01-01", "s") + np.array(T), Q)
ASKED = [
    ("rate 0", lambda: CURVE.sample(rate=0), "rate: found 0, wanted a number of samples per second greater than 0"),
    ("rate below 0", lambda: CURVE.sample(rate=-1), "rate: found -1"),
    ("rate NaN", lambda: CURVE.sample(rate=np.nan), "rate: found nan"),
    ("rate as a word", lambda: CURVE.sample(rate="fast"), "rate: found 'fast'"),
    ("fraction of 0", lambda: CURVE.sample(rate="1/0"), "rate: found '1/0'"),
    ("too many samples", lambda: CURVE.sample(rate=1e15), "samples"),
    ("too many to hold", lambda: CURVE.sample(rate=1e10), "wanted 1e9 at most"),
    ("too large a count", lambda: CURVE.sample(count=10**15), "wanted 1e9 at most"),
    ("count 0", lambda: CURVE.sample(count=0), "count: found 0"),
    ("two grids", lambda: CURVE.sample(rate=1, count=2), "wanted one of rate, count and times"),
    ("no grid", lambda: CURVE.sample(), "wanted one of rate, count and times"),
    ("derivatives", lambda: CURVE.sample(rate=1, derivatives=4), "derivatives: found 4"),
    ("frame", lambda: CURVE.angular_velocity(1.0, frame="camera"), "frame: found 'camera', wanted 'body' or 'world'"),
    ("table of sample times", lambda: CURVE.sample(times=[[1.0]]), "times: found the shape (1, 1)"),
    ("text", lambda: CURVE("1"), "wanted real numbers"),
    ("positions", lambda: CURVE.position(1.0), "these keys have no positions"),
    ("short out", lambda: CURVE(T, out=np.empty((2, 4))), "out: found an array (2, 4)"),
    ("read-only out", lambda: CURVE(T, out=READ_ONLY), "may be written to"),
    ("strided out", lambda: CURVE(T, out=np.empty((3, 8))[:, ::2]), "C-contiguous"),
    ("out over the times", lambda: CURVE(SHARED[:3], out=SHARED[:12].reshape(3, 4)), "out: found the memory of the times"),
    ("out of samples over the times", lambda: CURVE.sample(times=SHARED[:3], out=SHARED[:12].reshape(3, 4)), "memory of the times"),
    ("out of samples over each other", lambda: CURVE.sample(times=T, derivatives=1, out=[SHARED[:12].reshape(3, 4), SHARED[11:].reshape(3, 3)]),
     "out: found arrays that share memory, wanted each apart"),
    ("too few arrays of samples", lambda: CURVE.sample(times=T, derivatives=1, out=[np.empty((3, 4))]), "out: found 1, wanted 2: an array for"),
    ("short out of samples", lambda: CURVE.sample(count=5, out=np.empty((4, 4))), "out: found an array (4, 4) of float64, wanted (5, 4)"),
    ("out of another type", lambda: CURVE(T, out=np.empty((3, 4), "float32")), "wanted (3, 4) of float64"),
    ("dtype", lambda: CURVE(T, dtype=int), "dtype: found int64, wanted float64 or float32"),
    ("no times", lambda: CURVE(None), "t: found an object of type NoneType, wanted real numbers"),
    ("objects as times", lambda: CURVE([1, None]), "t: found objects of type NoneType, int, wanted real numbers"),
    ("ragged times", lambda: CURVE([[1, 2], [3]]), "t: found rows of different lengths"),
    ("masked times", lambda: CURVE(np.ma.array(T, mask=[0, 1, 0])), "t: found masked values"),
    ("date", lambda: CURVE(datetime.datetime(2024, 1, 1)), "t: found an array of datetime64[ns], wanted numbers, as the times of the keys are"),
    ("no date", lambda: DATED([1.0]), "t: found an array of float64, wanted datetime64, as the times of the keys are"),
    ("dates with and without a zone", lambda: DATED([datetime.datetime(2024, 1, 1, tzinfo=datetime.timezone.utc), datetime.datetime(2024, 1, 1)]),
     "t: found dates with a time zone and dates without one"),
    ("start beside times", lambda: CURVE.sample(times=T, start=1), "times: found start, end or include_end beside times"),
    ("end beside times", lambda: CURVE.sample(times=T, include_end=True), "times: found start, end or include_end beside times"),
    ("1e9 on dates", lambda: DATED.sample(times=np.full(2, 10**9)), "times: found an array of int64, wanted datetime64"),
    ("date outside", lambda: DATED.keys.curve(extrapolate="error")(np.array(["2024-01-01T00:00:01", "2024-01-01T00:00:04"], "datetime64[s]")),
     "time 1: time 2024-01-01T00:00:04.000000000 is outside the curve, wanted 2024-01-01T00:00:00.000000000 to "),
    ("milliseconds outside", lambda: ori.Curve(T, Q, time_unit="ms", extrapolate="error").sample(times=[1, 4]),
     "time 1: time 4.0 is outside the curve, wanted 0.0 to 3.0"),
    ("motion of times", lambda: CURVE.motion(T), "wanted one time"),
]


@pytest.mark.parametrize(("make", "error", "text", "key"), [case[1:] for case in KEYS], ids=[case[0] for case in KEYS])
def test_keys(make, error, text, key):
    with pytest.raises(error) as found:
        make()
    assert text in str(found.value) and "\n" not in str(found.value)
    assert found.value.key == key and isinstance(found.value, (ori.Error, ValueError))


@pytest.mark.parametrize(("make", "error", "text"), [case[1:] for case in CURVES], ids=[case[0] for case in CURVES])
def test_curves(make, error, text):
    with pytest.raises(error) as found:
        make()
    assert text in str(found.value) and "\n" not in str(found.value)


@pytest.mark.parametrize(("ask", "text"), [case[1:] for case in ASKED], ids=[case[0] for case in ASKED])
def test_what_is_asked(ask, text):
    with pytest.raises(ori.ArgumentError) as found:
        ask()
    assert text in str(found.value) and "\n" not in str(found.value)


def test_one_key_is_a_constant_curve():
    curve = ori.Curve([5.0], [[0, 0, 0.6, 0.8]])
    assert np.array_equal(curve([4, 5, 6]), [[0, 0, 0.6, 0.8]] * 3) and curve.domain == (5.0, 5.0)
    assert repr(curve).startswith("Curve('auto', 1 key, 5 … 5 s")


def test_times_that_are_nan_have_nan():
    assert np.isnan(CURVE([np.nan, 1.0])).any(axis=1).tolist() == [True, False]
    assert np.isnan(CURVE(float("nan"))).all()


@pytest.mark.parametrize("times", [range(30, 0, -1), [float("nan"), *range(1, 30)]], ids=["sorted", "dropped"])
def test_a_row_is_named_as_it_was_given(times):
    rotations = np.tile([0.0, 0, 0, 1], (30, 1))
    rotations[5] *= 0.1
    with pytest.raises(ori.DataError, match="^row 5: the quaternion has norm 0.1") as found:
        ori.Keys(list(times), rotations, sort=True, drop_invalid=True)
    assert found.value.key == 5
