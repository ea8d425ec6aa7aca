# SPDX-License-Identifier: Apache-2.0
"""The twins of SciPy's interpolators, with SciPy as the oracle."""
import copy
import functools
import operator
import pickle

import numpy as np
import orispline as ori
import pytest
import scipy.spatial.transform as theirs
from scipy.spatial.transform import Rotation


def keys_of(count, seed=1):
    """Uneven times, and rotations that turn by some tenths of a radian from key to key."""
    dice = np.random.default_rng(seed)
    times = np.cumsum(dice.uniform(0.5, 1.5, count))
    turn = Rotation.identity()
    quaternions = []
    for step in Rotation.from_rotvec(dice.normal(scale=0.3, size=(count, 3))):
        turn = turn * step
        quaternions.append(turn.as_quat())
    return times, Rotation.from_quat(quaternions)


def apart(a, b):
    """The angle between rotations [rad]; NaN where one is NaN."""
    p, q = np.atleast_2d(a.as_quat()), np.atleast_2d(b.as_quat())
    return 2 * np.minimum(np.linalg.norm(p - q, axis=1), np.linalg.norm(p + q, axis=1))


@pytest.mark.parametrize("count", [10, 1_000, 10_000])
def test_the_spline_has_scipys_numbers(count):
    times, rotations = keys_of(count)
    mine, his = ori.RotationSpline(times, rotations), theirs.RotationSpline(times, rotations)
    inside = np.random.default_rng(2).uniform(times[0], times[-1], 3 * count)
    for t in (inside, times, np.sort(inside)):
        assert apart(mine(t), his(t)).max() < 1e-9
        assert np.abs(mine(t, 1) - his(t, 1)).max() < 1e-9
        # SciPy has the acceleration of the segment before a key at the key as well as behind it: it is continuous
        assert np.abs(mine(t, 2) - his(t, 2)).max() < 1e-8


@pytest.mark.parametrize("seed", range(8))
@pytest.mark.parametrize("scale", [0.7, 1.0])
def test_the_spline_has_the_numbers_that_scipys_iteration_goes_to(scale, seed, monkeypatch):
    """Steps of a radian: ten rounds, SciPy's own limit, are not enough for most curves."""
    dice = np.random.default_rng(seed)
    times = np.cumsum(dice.uniform(0.5, 1.5, 20))
    turns = Rotation.from_rotvec(dice.normal(scale=scale, size=(20, 3)))
    rotations = Rotation.from_quat([functools.reduce(operator.mul, turns[:k + 1]).as_quat() for k in range(20)])
    mine, t = ori.RotationSpline(times, rotations), np.linspace(times[0], times[-1], 400)
    early = apart(mine(t), theirs.RotationSpline(times, rotations)(t)).max()
    monkeypatch.setattr(theirs.RotationSpline, "MAX_ITER", 2000)
    his = theirs.RotationSpline(times, rotations)
    late = apart(mine(t), his(t)).max()
    assert late < 1e-9 and late <= early
    assert np.abs(mine(t, 1) - his(t, 1)).max() < 1e-8


@pytest.mark.parametrize("count", [10, 1_000, 10_000])
def test_slerp_has_scipys_numbers(count):
    times, rotations = keys_of(count, seed=3)
    mine, his = ori.Slerp(times, rotations), theirs.Slerp(times, rotations)
    t = np.random.default_rng(4).uniform(times[0], times[-1], 3 * count)
    for asked in (t, times, times[-1]):
        assert apart(mine(asked), his(asked)).max() < 1e-12


@pytest.mark.parametrize("count", [2, 3, 12])
def test_outside_the_spline_scipys_cubic_goes_on(count):
    times, rotations = keys_of(count, seed=5)
    mine, his = ori.RotationSpline(times, rotations), theirs.RotationSpline(times, rotations)
    t = np.concatenate([times[0] - np.array([2.0, 0.7, 1e-9]), times[[0, -1]], times[-1] + np.array([1e-9, 0.4, 2.5])])
    assert apart(mine(t), his(t)).max() < 1e-9
    assert np.abs(mine(t, 1) - his(t, 1)).max() < 1e-9 * np.abs(his(t, 1)).max()
    assert np.abs(mine(t, 2) - his(t, 2)).max() < 1e-8 * max(1, np.abs(his(t, 2)).max())
    step = 1e-4
    jerk = (his(t + step, 2) - his(t - step, 2)) / (2 * step)
    smooth = [0, 1, 6, 7]  # no key within a step
    assert np.abs(mine(t, 3) - jerk)[smooth].max() < 1e-5 * max(1, np.abs(jerk).max())


@pytest.mark.parametrize("name", ["RotationSpline", "Slerp"])
def test_shapes_and_attributes_are_scipys(name):
    times, rotations = keys_of(7, seed=6)
    mine, his = getattr(ori, name)(list(times), rotations), getattr(theirs, name)(list(times), rotations)
    assert np.array_equal(mine.times, his.times) and isinstance(mine.times, np.ndarray)
    assert np.array_equal(mine.rotations.as_quat(), his.rotations.as_quat())
    for t in (float(times[2]), times[2], np.array(times[2]), [times[2]], times[1:4], []):
        if np.shape(t) == (0,):
            assert mine(t).as_quat().shape == (0, 4)
        else:
            assert mine(t).single == his(t).single and mine(t).as_quat().shape == his(t).as_quat().shape
    assert type(mine(times)) is Rotation
    assert mine(2, 1).shape == (3,) and mine([2, 3], 3).shape == (2, 3) and mine([2, 3], order=2).shape == (2, 3)
    again = pickle.loads(pickle.dumps(mine, 5)), copy.deepcopy(mine)
    assert all(np.array_equal(other(times).as_quat(), mine(times).as_quat()) for other in again)
    assert not mine.times.flags.writeable
    times[0] = -1e9  # the twin has its own
    assert mine.times[0] == his.times[0]


SINGLE = Rotation.from_rotvec([0, 0, 1])
FOUR = Rotation.from_rotvec(np.diag([0, 1, 1.5, 0.3])[:, :3])


@pytest.mark.parametrize("name", ["RotationSpline", "Slerp"])
@pytest.mark.parametrize("times, rotations", [
    ([1], SINGLE), ([1], FOUR[:1]), ([0, 1, 2], FOUR), ([[0, 1, 2, 3]], FOUR), (0, FOUR), ([0, 1, 1, 2], FOUR),
    ([0, 2, 1, 3], FOUR), ([], FOUR)])
def test_bad_keys_raise_what_scipy_raises(name, times, rotations):
    with pytest.raises(ValueError):
        getattr(theirs, name)(times, rotations)
    with pytest.raises(ValueError) as found:
        getattr(ori, name)(times, rotations)
    assert isinstance(found.value, ori.Error) and "wanted" in str(found.value)


@pytest.mark.parametrize("rotations", [FOUR.as_quat(), FOUR.as_matrix(), None])
def test_other_things_than_rotations_are_type_errors(rotations):
    with pytest.raises(TypeError):
        theirs.Slerp([0, 1, 2, 3], rotations)
    for twin in (ori.Slerp, ori.RotationSpline):
        with pytest.raises(TypeError, match="wanted a SciPy Rotation"):
            twin([0, 1, 2, 3], rotations)


def test_bad_questions_raise_what_scipy_raises():
    his, mine = theirs.RotationSpline([0, 1, 2, 3], FOUR), ori.RotationSpline([0, 1, 2, 3], FOUR)
    for ask in (lambda spline: spline(1, 4), lambda spline: spline(1, -1), lambda spline: spline([[1]])):
        for spline in (his, mine):
            with pytest.raises(ValueError):
                ask(spline)
    slerps = theirs.Slerp([0, 1, 2, 3], FOUR), ori.Slerp([0, 1, 2, 3], FOUR)
    for t in (-1e-9, 3.001, [1, 5], [[1]]):
        for slerp in slerps:
            with pytest.raises(ValueError):
                slerp(t)
    with pytest.raises(ori.ArgumentError, match="time 5 is outside the curve, wanted 0 to 3") as found:
        slerps[1]([1, 5])
    assert found.value.time_index == 1


@pytest.mark.parametrize("twin", [ori.RotationSpline, ori.Slerp])
def test_nan_in_nan_out(twin):
    curve = twin([0, 1, 2, 3], FOUR)
    q = curve([0.5, np.nan, 2.5]).as_quat()
    assert np.isnan(q).all(axis=1).tolist() == [False, True, False] and not np.isnan(q[[0, 2]]).any()
    assert np.isnan(curve(np.nan).as_quat()).all()
    for order in (1, 2, 3):
        assert np.isnan(curve([np.nan, 1], order)).any(axis=1).tolist() == [True, False]


def test_beyond_scipy():
    times, rotations = keys_of(9, seed=7)
    rate = np.array([0.1, -0.2, 0.3])
    clamped = ori.RotationSpline(times, rotations, start_rate=rate, ends=("clamped", "natural"))
    assert np.abs(clamped(times[0], 1) - rate).max() < 1e-12 and np.abs(clamped(times[-1], 2)).max() < 1e-9
    both = ori.RotationSpline(times, rotations, start_rate=rate, end_rate=-rate)
    assert np.abs(both(times[-1], 1) + rate).max() < 1e-12
    far = times[-1] + 3
    end = rotations[-1]
    kept = ori.RotationSpline(times, rotations, extrapolate="rate")
    assert apart(kept(far), end * Rotation.from_rotvec(3 * kept(times[-1], 1))).max() < 1e-12
    assert np.abs(kept(far, 1) - kept(times[-1], 1)).max() < 1e-14 and not kept(far, 2).any()
    held = ori.Slerp(times, rotations, extrapolate="hold")
    assert apart(held(far), end).max() < 1e-15 and not held(far, 1).any()
    assert np.isnan(ori.Slerp(times, rotations, extrapolate="nan")(far).as_quat()).all()
    on = ori.Slerp(times, rotations, extrapolate="segment")
    assert apart(on(far), end * Rotation.from_rotvec(3 * on(times[-1], 1))).max() < 1e-12
    with pytest.raises(ori.ArgumentError, match="extrapolate: found 'far'"):
        ori.Slerp(times, rotations, extrapolate="far")
    with pytest.raises(ori.ArgumentError, match="ends"):
        ori.RotationSpline(times, rotations, ends="repeat")


def test_an_epoch_of_today_costs_no_digits():
    times, rotations = keys_of(50, seed=8)
    times = np.round(times, 3) + 1.7e9
    mine, his = ori.RotationSpline(times, rotations), theirs.RotationSpline(times, rotations)
    t = times[:-1] + 0.25
    assert apart(mine(t), his(t)).max() < 1e-9 and np.abs(mine(t, 1) - his(t, 1)).max() < 1e-9
