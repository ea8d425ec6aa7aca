# SPDX-License-Identifier: Apache-2.0
"""Times outside a curve, in every way that can be asked for."""
import importlib.resources
import subprocess

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation

WAYS = ("hold", "error", "nan", "rate", "segment")
ANGULAR = ("angular_velocity", "angular_acceleration", "angular_jerk")
LINEAR = ("position", "velocity", "acceleration")
COMMAND = str(importlib.resources.files("orispline") / "bin" / "orispline")


def curve_of(keys, way, method="timed-c2", **more):
    times, rotations = keys
    return ori.Curve(times, rotations, method, positions=np.cumsum(rotations[:, :3], axis=0), extrapolate=way, **more)


def outside(curve, away=1.25):
    first, last = curve.domain
    return np.array([first - away, last + away]), np.array([first, last])


def test_by_rate_the_body_turns_and_moves_on_as_it_ended(keys):
    curve = curve_of(keys, "rate")
    t, ends = outside(curve)
    away = (t - ends)[:, None]
    wanted = Rotation.from_quat(curve(ends)) * Rotation.from_rotvec(away * curve.angular_velocity(ends))
    assert np.abs(curve.rotation(t).as_matrix() - wanted.as_matrix()).max() < 1e-14
    assert np.allclose(curve.angular_velocity(t), curve.angular_velocity(ends), rtol=0, atol=1e-14)
    world = Rotation.from_quat(curve(ends)).apply(curve.angular_velocity(ends))
    assert np.allclose(curve.angular_velocity(t, frame="world"), world, atol=1e-13)
    assert np.allclose(curve.position(t), curve.position(ends) + away * curve.velocity(ends), rtol=0, atol=1e-13)
    assert np.allclose(curve.velocity(t), curve.velocity(ends), rtol=0, atol=1e-13)
    for name in ("angular_acceleration", "angular_jerk", "acceleration"):
        assert not getattr(curve, name)(t).any(), name


@pytest.mark.parametrize("method", ["auto", "timed-c2", "rotation-spline", "squad-timed", "hermite-c3"])
def test_by_segment_the_rates_are_the_derivatives_outside_too(keys, method):
    curve, h = curve_of(keys, "segment", method), 1e-5
    t, ends = outside(curve, 0.1)
    before, after = curve.rotation(t - h), curve.rotation(t + h)
    assert np.allclose((before.inv() * after).as_rotvec() / (2 * h), curve.angular_velocity(t), atol=1e-6)
    for names in (ANGULAR, LINEAR):
        for rate, derivative in zip(names, names[1:]):
            difference = (getattr(curve, rate)(t + h) - getattr(curve, rate)(t - h)) / (2 * h)
            wanted = getattr(curve, derivative)(t)
            assert np.allclose(difference, wanted, atol=1e-5 * max(1, np.abs(wanted).max())), rate
    world = (curve.angular_acceleration(t + h, frame="world") - curve.angular_acceleration(t - h, frame="world")) / (2 * h)
    assert np.allclose(world, curve.angular_jerk(t, frame="world"), rtol=1e-4, atol=1e-4 * np.abs(world).max())
    near = ends + [-1e-9, 1e-9]
    assert np.allclose(curve(near), curve(ends), atol=1e-7)
    assert np.allclose(curve.angular_velocity(near), curve.angular_velocity(ends), atol=1e-5)


@pytest.mark.parametrize("way", WAYS)
def test_inside_all_ways_have_the_same_bits(keys, way):
    plain, curve = curve_of(keys, "hold"), curve_of(keys, way)
    t = np.random.default_rng(1).uniform(*plain.domain, 200)
    for name in ("__call__", *ANGULAR, *LINEAR):
        assert np.array_equal(getattr(curve, name)(t), getattr(plain, name)(t)), name
    many, wanted = (c.sample(rate=50, derivatives=3) for c in (curve, plain))
    assert np.array_equal(many.angular_jerks, wanted.angular_jerks)


@pytest.mark.parametrize("way", ["hold", "nan", "rate", "segment"])
def test_samples_scalars_threads_and_single_precision_agree(keys, way):
    curve = curve_of(keys, way)
    first, last = curve.domain
    t = np.linspace(first - 2, last + 2, 30_000)
    q, w = curve(t), curve.angular_velocity(t, frame="world")
    samples = curve.sample(times=t, derivatives=3, frame="world")
    assert np.allclose(samples.orientations, q, rtol=0, atol=1e-14, equal_nan=True)  # rates beside it cost the last bit
    assert np.array_equal(samples.angular_velocities, w, equal_nan=True)
    assert np.array_equal(samples.angular_jerks, curve.angular_jerk(t, frame="world"), equal_nan=True)
    assert np.array_equal(samples.positions, curve.position(t), equal_nan=True)
    assert np.array_equal(curve(t, threads=3), q, equal_nan=True)
    order = np.random.default_rng(2).permutation(len(t))
    assert np.array_equal(curve(t[order]), q[order], equal_nan=True)
    assert np.allclose(curve(t, dtype="float32"), q, atol=1e-6, equal_nan=True)
    for k in (0, 700, 15_000, 29_999):
        assert np.array_equal(curve(float(t[k])), q[k], equal_nan=True)
        assert np.array_equal(curve.motion(t[k], frame="world").angular_velocity, w[k], equal_nan=True)
    is_outside = (t < first) | (t > last)
    assert np.isnan(q).all(axis=1).tolist() == (is_outside if way == "nan" else np.zeros_like(is_outside)).tolist()


def test_a_scalar_has_the_bits_of_an_array(keys):
    dice = np.random.default_rng(3)
    for method in ("auto", "timed-c2", "slerp", "rotation-spline", "squad-timed", "global-c2", "quintic"):
        curve = ori.Curve(*keys, method)
        t = dice.uniform(*curve.domain, 300)
        rows = curve(t)
        assert np.array_equal([curve(float(x)) for x in t], rows), method
        assert np.array_equal([curve(x) for x in t], rows), method
        assert np.array_equal([curve([x])[0] for x in t], rows), method
        assert np.array_equal([curve(float(x)) for x in keys[0]], curve(keys[0])), method


def test_error_names_the_first_time_outside(keys):
    curve = curve_of(keys, "error")
    first, last = curve.domain
    for ask in (lambda t: curve(t), lambda t: curve.velocity(t), lambda t: curve.sample(times=t)):
        with pytest.raises(ori.ArgumentError, match="is outside the curve, wanted") as found:
            ask([first, last, last + 1, first - 1])
        assert found.value.time_index == 2
    with pytest.raises(ori.ArgumentError, match="is outside the curve, wanted"):
        curve(float(last + 1))
    assert np.isnan(curve(float("nan"))).all()


@pytest.mark.parametrize("way", ["nan", "rate", "segment"])
def test_the_command_writes_the_same(keys, tmp_path, way):
    times, rotations = keys
    table = np.column_stack([times, rotations[:, [3, 0, 1, 2]]])
    np.savetxt(tmp_path / "keys.csv", table, delimiter=",", header="t,qw,qx,qy,qz", comments="", fmt="%.17g")
    subprocess.run([COMMAND, "sample", "keys.csv", "--method", "timed-c2", "--rate", "3",
                    "--from=-0.25", "--to", "39.5", "--derivatives", "3", "--extrapolate", way, "--quiet", "-o", "out.csv"],
                   cwd=tmp_path, check=True)
    rows = np.loadtxt(tmp_path / "out.csv", delimiter=",", skiprows=1)
    t = rows[:, 0]
    curve = ori.Curve(times, rotations, "timed-c2", extrapolate=way)
    assert (rows[:, 0] < times[0]).any() and (rows[:, 0] > times[-1]).any()
    assert np.allclose(rows[:, [2, 3, 4, 1]], curve(t), atol=1e-11, equal_nan=True)
    for column, name in ((5, "angular_velocity"), (8, "angular_acceleration"), (11, "angular_jerk")):
        wanted = getattr(curve, name)(t)
        scale = max(1, np.nanmax(np.abs(wanted)))
        assert np.allclose(rows[:, column:column + 3], wanted, atol=1e-9 * scale, equal_nan=True), name
