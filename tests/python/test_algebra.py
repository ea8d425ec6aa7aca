# SPDX-License-Identifier: Apache-2.0
"""Curves made of curves: turned, inverted, multiplied, beside SciPy's rotations and the rules of their rates."""
import pickle

import numpy as np
import orispline as ori
import pytest
import scipy
from scipy.spatial.transform import Rotation

METHODS = [method["name"] for method in ori.methods()]
RATES = ("angular_velocity", "angular_acceleration", "angular_jerk")
R = Rotation.from_rotvec([0.4, -1.1, 0.7])


@pytest.fixture
def curve(keys):
    times, rotations = keys
    return ori.Curve(times, rotations, positions=np.cumsum(rotations[:, :3], axis=0))


@pytest.fixture
def other(keys):
    times, rotations = keys
    return ori.Curve(times[3:30] + 0.3, rotations[10:37], "timed-c3")


def inside(curve, count=200, seed=5):
    return np.random.default_rng(seed).uniform(*curve.domain, count)


def same(found, wanted, tolerance):
    assert np.abs(found - wanted).max() <= tolerance * max(1.0, np.abs(wanted).max())


def same_turns(found, wanted):
    assert np.abs((found.inv() * wanted).magnitude()).max() < 1e-11


@pytest.mark.parametrize("method", METHODS)
def test_a_turned_curve_is_the_curve_turned_whatever_its_method(keys, method):
    times, rotations = keys
    curve = ori.Curve(times, rotations, method)
    t = inside(curve)
    world, body = curve.rotated(R), curve * R
    same_turns(world.rotation(t), R * curve.rotation(t))
    same_turns(body.rotation(t), curve.rotation(t) * R)
    for name, tolerance in zip(RATES, (1e-10, 1e-9, 1e-8)):
        rates = getattr(curve, name)(t)
        same(getattr(world, name)(t), rates, tolerance)
        same(getattr(body, name)(t), R.inv().apply(rates), tolerance)
    assert world.method == curve.method and type(world) is ori.Curve


def test_what_turned_keys_carry_turns_too(keys):
    times, rotations = keys
    curve = ori.Curve(times, rotations, "timed-c2", start_rate=[0.1, 0.2, 0.3], end_rate=[1, 0, 0], positions=rotations[:, :3])
    turned = curve * R
    assert np.allclose(turned.angular_velocity(times[0]), R.inv().apply([0.1, 0.2, 0.3]))
    assert np.allclose(curve.rotated(R).position(7.0), R.apply(curve.position(7.0)))
    assert np.allclose((curve * R).position(7.0), curve.position(7.0))
    ned = curve.in_frame("NED:ENU", "FRD:FLU")
    assert np.allclose(ned.position(7.0), curve.position(7.0)[[1, 0, 2]] * [1, 1, -1])
    assert np.allclose(ned.angular_velocity(times[0]), [0.1, -0.2, -0.3])
    assert ned.keys == curve.keys.in_axes("NED:ENU", "FRD:FLU")


@pytest.mark.parametrize("method", ["auto", "timed-c2", "rational", "squad", "barry-goldman", "least"])
def test_the_inverse_has_the_rates_of_the_inverse(keys, method):
    times, rotations = keys
    curve = ori.Curve(times, rotations, method)
    inverse, t = curve.inv(), inside(curve)
    same_turns(inverse.rotation(t), curve.rotation(t).inv())
    for name in RATES:
        same(getattr(inverse, name)(t), -getattr(curve, name)(t, frame="world"), 1e-12)
    assert inverse.inv() is curve
    assert inverse.domain == curve.domain and np.array_equal(inverse.times, times)
    assert inverse.continuity() == curve.continuity()


def test_a_relative_motion_has_the_rates_of_the_difference(curve, other):
    relative = curve.relative_to(other)
    assert relative.domain == (max(curve.domain[0], other.domain[0]), min(curve.domain[1], other.domain[1]))
    t = inside(relative)
    turns = relative.rotation(t)
    same_turns(turns, other.rotation(t).inv() * curve.rotation(t))
    same(relative.angular_velocity(t), curve.angular_velocity(t) - turns.inv().apply(other.angular_velocity(t)), 1e-12)
    h = 1e-5
    t = t[np.abs(t[:, None] - relative.times).min(axis=1) > 10 * h]
    for rate, derivative in (("angular_velocity", "angular_acceleration"), ("angular_acceleration", "angular_jerk")):
        difference = (getattr(relative, rate)(t + h) - getattr(relative, rate)(t - h)) / (2 * h)
        same(difference, getattr(relative, derivative)(t), 1e-6)
    both = other.inv() * curve
    assert np.array_equal(both(t), relative(t)) and np.array_equal(both.angular_jerk(t), relative.angular_jerk(t))
    assert set(relative.times) <= {*curve.times, *other.times}


def test_a_composed_curve_does_what_a_curve_does(curve, other):
    made = (curve * other).rotated(R) * R
    t = np.sort(inside(made))
    same_turns(made.rotation(t), R * curve.rotation(t) * other.rotation(t) * R)
    samples = made.sample(times=t, derivatives=3, frame="world", threads=2)
    for name, plural in zip(RATES, ("angular_velocities", "angular_accelerations", "angular_jerks")):
        assert np.array_equal(getattr(samples, plural), getattr(made, name)(t, frame="world"))
        assert np.array_equal(getattr(made, name)(float(t[3])), getattr(made, name)(t)[3])
    assert len(made.sample(rate=10)) == int((made.domain[1] - made.domain[0]) * 10) + 1
    dense = np.linspace(*made.domain, 40_001)
    speeds = np.linalg.norm(made.angular_velocity(dense), axis=1)
    peak = made.peaks().angular_velocity
    assert speeds.max() * (1 - 1e-9) <= peak.value <= speeds.max() * (1 + 1e-3)
    assert made.angle_travelled() == pytest.approx(np.trapezoid(speeds, dense) if hasattr(np, "trapezoid") else np.trapz(speeds, dense), rel=1e-6)
    squares = np.sum(made.angular_acceleration(dense) ** 2, axis=1)
    assert made.energies().acceleration == pytest.approx(np.sum((squares[1:] + squares[:-1]) / 2) * (dense[1] - dense[0]), rel=1e-3)
    assert made.distance(t, made(t)).largest < 1e-12
    baked = made.bake(1e-8)
    assert np.abs((baked.rotation(t).inv() * made.rotation(t)).magnitude()).max() < 1e-8
    assert np.array_equal(made.inv().inv()(t), made(t))
    same_turns(made.inv().rotation(t), made.rotation(t).inv())
    assert repr(made).startswith("ComposedCurve(") and made.as_matrix(t).shape == (200, 3, 3)
    assert np.isnan(made([np.nan])).all()
    assert np.array_equal(made(made.domain[1] + 1), made(made.domain[1])) and not made.angular_velocity(made.domain[1] + 1).any()


def test_copies_and_other_processes_have_the_same_bits(curve, other):
    for made in (curve.rotated(R), curve.inv(), curve.relative_to(other), other.relative_to(curve).inv() * R):
        again = pickle.loads(pickle.dumps(made))
        t = inside(made)
        assert repr(again) == repr(made) and np.array_equal(again(t), made(t)) and np.array_equal(again.angular_jerk(t), made.angular_jerk(t))


def test_the_order_of_quaternions_and_what_is_beyond_stay(keys):
    times, rotations = keys
    wxyz = ori.Curve(times, rotations[:, [3, 0, 1, 2]], scalar_first=True, extrapolate="nan")
    plain = ori.Curve(times, rotations)
    for made, wanted in ((wxyz.rotated(R), plain.rotated(R)), (wxyz.inv(), plain.inv()), (wxyz * wxyz, plain * plain),
                         (wxyz.rotated(R.as_quat(scalar_first=True)), plain.rotated(R))):
        assert np.allclose(made(3.3), wanted(3.3)[[3, 0, 1, 2]])
        assert np.isnan(made(-100.0)).all() and not np.isnan(wanted(-100.0)).any()


def test_dates_and_epochs_of_both_are_one_time():
    start = np.datetime64("2026-11-28T10:00:00", "ns")
    q = [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
    late = ori.Curve(start + np.array([2_500, 3_500, 5_500], "m8[ms]"), q)
    early = ori.Curve(start + np.array([0, 3, 6], "m8[s]"), q)
    relative = late.relative_to(early)
    assert relative.domain == late.domain and relative.times.dtype.kind == "M"
    t = start + np.timedelta64(3_250, "ms")
    same_turns(relative.rotation(t), early.rotation(t).inv() * late.rotation(t))
    with pytest.raises(ori.ArgumentError, match="whose times are numbers and one whose times are dates"):
        late.relative_to(ori.Curve([0, 1, 2], q))
    with pytest.raises(ori.ArgumentError, match="a curve of 2026-11-28T10:00:02.5.* … 2026.* and one of 2026.*, wanted two curves with a time in common"):
        late * ori.Curve(start + np.array([100, 200, 300], "m8[s]"), q)


def test_gaps_of_either_are_gaps_of_both(keys):
    times, rotations = keys
    gapped = ori.Curve(np.where(np.arange(40) < 20, times, times + 30), rotations, gap=10)
    whole = ori.Curve(times * 2, rotations)
    middle = (times[19] + times[20] + 30) / 2
    for made in (whole.relative_to(gapped), gapped * whole, gapped.inv()):
        assert np.isnan(made(middle)).all() and not np.isnan(made(times[5])).any() and np.isnan(made.angular_jerk(middle)).all()


def test_a_curve_beside_one_with_gaps_is_not_baked(keys):
    times, rotations = keys
    gapped = ori.Curve(np.where(np.arange(40) < 20, times, times + 30), rotations, gap=10)
    with pytest.raises(ori.ArgumentError, match="found a gap from .*, wanted one curve without a break"):
        (ori.Curve(times * 2, rotations) * gapped).bake(1e-6)


def test_before_a_jump_stands_what_was_there():
    angles = np.array([0.0, 0.4, 1.4, 2.0])
    q = np.column_stack([np.zeros(4), np.zeros(4), np.sin(angles / 2), np.cos(angles / 2)])
    whole = ori.Curve([0, 1, 2], [[0, 0, 0, 1], [0.6, 0, 0, 0.8], [1, 0, 0, 0]])
    for scalar_first in (False, True):
        given = q[:, [3, 0, 1, 2]] if scalar_first else q
        curve = ori.Curve([0, 1, 1, 2], given, "slerp", jumps=True, positions=given[:, :3], scalar_first=scalar_first)
        before, after = curve.motion(1.0, side="left"), curve.motion(1.0)
        same(before.orientation, given[1], 1e-15), same(after.orientation, given[2], 1e-15)
        same(before.position, given[1, :3], 1e-15), same(after.position, given[2, :3], 1e-15)
        assert before.angular_velocity[2] == pytest.approx(0.4) and after.angular_velocity[2] == pytest.approx(0.6)
    product = (curve * whole).motion(1.0, side="left").orientation
    same_turns(Rotation.from_quat(product, scalar_first=True), Rotation.from_quat(q[1]) * whole.rotation(1.0))


def test_the_angle_between_knows_both_clocks(tmp_path):
    q = [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
    seconds, counted = ori.Curve([0, 1, 2], q, "slerp"), ori.Curve(np.array([0, 1000, 2000]), q, "slerp", time_unit="ms")
    assert ori.angle_between(counted, seconds, [0, 300, 1500]).max() < 1e-12 and ori.angle_between(seconds, counted, [0, 0.3, 1.5]).max() < 1e-12
    (tmp_path / "late.csv").write_text("t,qw,qx,qy,qz\n10.5,1,0,0,0\n11.5,0.8,0,0,0.6\n12.5,0,0,0,1\n")
    late = ori.read(tmp_path / "late.csv").curve("slerp")  # whose times count from 10.5 s, when the other one is at its end
    assert ori.angle_between(late, seconds, [0.5, 2.0]) == pytest.approx([np.pi - np.arctan(0.75), 0], abs=1e-12)


def test_the_angle_between_is_right_near_nothing_and_near_half_a_turn():
    times = [0.0, 1.0, 2.0]
    still = ori.Curve(times, [[0, 0, 0, 1]] * 3, "slerp")
    for angle in (1e-9, 1e-3, 1.0, np.pi - 1e-9):
        turned = still.rotated(Rotation.from_rotvec([0, 0, angle]))
        assert ori.angle_between(still, turned, 0.5) == pytest.approx(angle, rel=1e-12)
        assert ori.angle_between(turned, Rotation.identity(), [0.1, 1.9]) == pytest.approx(angle, rel=1e-12)
        assert ori.angle_between(turned, [0, 0, 0, 1], 0.5) == pytest.approx(angle, rel=1e-12)
    with pytest.raises(ori.ArgumentError, match="b: found 2 rotations, wanted one, or a curve"):
        ori.angle_between(still, np.eye(4)[:2], 0.5)


@pytest.mark.skipif(tuple(map(int, scipy.__version__.split(".")[:2])) < (1, 17), reason="SciPy asks the right side from 1.17 on")
def test_scipy_asks_the_right_side(curve):
    t = inside(curve)
    same_turns((R * curve).rotation(t), R * curve.rotation(t))


def test_what_is_no_rotation_is_refused(curve):
    for wrong in ([0, 0, 0, 0], np.eye(3) * 2, Rotation.identity(2), "turn"):
        with pytest.raises(ori.Error):
            curve.rotated(wrong)
    for wrong in (3, "R", [0, 0, 0, 1], np.eye(3)):
        with pytest.raises(TypeError):
            curve * wrong
        with pytest.raises(TypeError):
            wrong * curve
    with pytest.raises(TypeError, match="wanted a curve"):
        curve.relative_to([0, 0, 0, 1])
    with pytest.raises(TypeError, match="wanted it made of curves"):
        ori.ComposedCurve([0, 1], [[0, 0, 0, 1]] * 2)


def test_what_is_no_rotation_is_named_as_it_is_given(keys):
    curve = ori.Curve(*keys)
    for rotation, error, text in ((None, TypeError, "rotation: found None"), ([0, 0, 0, 0], ori.ArgumentError, "rotation: the quaternion has norm 0"),
                                  ([0, 0, 0, np.nan], ori.ArgumentError, "rotation: found qw=nan")):
        with pytest.raises(error, match=f"^{text}"):
            curve.rotated(rotation)
    for work, side in ((curve.in_frame, "world"), (lambda axes: curve.keys.in_axes(body=axes), "body")):
        with pytest.raises(TypeError, match=f"{side}: found Rotation.*, wanted letters such as 'NED:ENU'; {side}_rotation= takes a rotation") as found:
            work(Rotation.identity())
        assert "\n" not in str(found.value)


def test_arrays_are_no_curves(keys):
    curve = ori.Curve(*keys)
    for thing in (curve, curve.inv(), curve.keys, curve.sample(count=3), ori.CurveStack([curve, curve])):
        for array in (np.zeros(3), np.zeros((len(keys[0]), 2)), np.zeros(2)):
            assert (thing == array) is (array == thing) is False and thing != array
