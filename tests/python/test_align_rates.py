# SPDX-License-Identifier: Apache-2.0
"""align of gyros: two of them, or one and orientations; how it is mounted, its clock and its bias."""
import copy
import math
import pickle

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation

LATE, BIAS = 0.31, np.array([0.02, -0.01, 0.03])
MOUNT = Rotation.from_rotvec([0.2, -0.5, 0.9])  # from the axes of the gyro to those of the body
TIMES = np.arange(1500) / 50


def motion(t):
    """Orientations and rates of the body: turns about z, y and x, one after the other."""
    angles = np.column_stack([1.1 * np.sin(1.3 * t), 0.8 * np.sin(2.1 * t + 0.4), 0.9 * np.sin(1.7 * t + 1)])
    slopes = np.column_stack([1.43 * np.cos(1.3 * t), 1.68 * np.cos(2.1 * t + 0.4), 1.53 * np.cos(1.7 * t + 1)])
    rotation = Rotation.from_euler("ZYX", angles)
    _, pitch, roll = angles.T
    yaw_rate, pitch_rate, roll_rate = slopes.T
    rates = np.column_stack([roll_rate - yaw_rate * np.sin(pitch), pitch_rate * np.cos(roll) + yaw_rate * np.cos(pitch) * np.sin(roll),
                             yaw_rate * np.cos(pitch) * np.cos(roll) - pitch_rate * np.sin(roll)])
    return rotation, rates


def poses(**options):
    noise = Rotation.from_rotvec(np.random.default_rng(1).normal(0, 0.005, (len(TIMES), 3)))
    return ori.Keys(TIMES, motion(TIMES)[0] * noise, **options)


def gyro(seed=2, *, mount=MOUNT, late=LATE, bias=BIAS, times=TIMES):
    rates = mount.inv().apply(motion(times - late)[1]) + bias
    return ori.Rates(times, rates + np.random.default_rng(seed).normal(0, 0.01, rates.shape))


def at_rest(seed):
    return ori.Rates(TIMES, np.random.default_rng(seed).normal(0, 0.01, (1500, 3)))


def assert_mounted(found, *, tolerance=2e-3):
    assert abs(found.offset - LATE) < 1e-3 and found.offset_sigma < 1e-3
    assert (Rotation.from_quat(found.body) * MOUNT.inv()).magnitude() < tolerance
    assert (np.abs(found.bias - BIAS) < 5 * found.bias_sigma).all() and (found.bias_sigma < 2e-3).all()
    assert found.open == () and 0.5 < found.excess < 1.5


def test_a_gyro_beside_poses():
    found = ori.align(gyro(), poses())
    assert isinstance(found, ori.RateAlignment)
    assert_mounted(found)
    assert isinstance(found.aligned, ori.Rates) and np.allclose(found.aligned.times, TIMES - found.offset)
    left = found.aligned.rates - motion(found.aligned.times)[1]
    assert (np.abs(left.mean(axis=0)) < 2e-3).all() and left.std() < 0.012
    assert found.distance_rms > 0 and found.rate_rms is None


def test_poses_beside_a_gyro_say_the_same_the_other_way_round():
    one, other = ori.align(gyro(), poses()), ori.align(poses(), gyro())
    assert other.offset == -one.offset and np.array_equal(other.bias, one.bias)
    assert (Rotation.from_quat(other.body) * Rotation.from_quat(one.body)).magnitude() < 1e-12
    assert isinstance(other.aligned, ori.Keys) and np.allclose(other.aligned.times, TIMES + one.offset)


def test_two_gyros():
    found = ori.align(gyro(), gyro(3, mount=Rotation.identity(), late=0.0, bias=np.zeros(3)))
    assert_mounted(found)
    assert found.distance_rms is None and found.rate_rms > 0
    body = ori.align(gyro(), gyro(3, mount=MOUNT, late=0.0, bias=np.zeros(3)), body_turn=False, offset=LATE)
    assert body.offset == LATE and body.offset_sigma == 0 and np.array_equal(body.body, [0, 0, 0, 1])


def test_order_of_quaternions_clocks_and_rows_that_are_not_whole():
    rates = gyro()
    rates.rates[[3, 700]] = np.nan
    stamps = (TIMES * 1e9).round().astype(np.int64).astype("datetime64[ns]") + np.timedelta64(1_700_000_000, "s")
    found = ori.align(ori.Rates(stamps, rates.rates), poses(scalar_first=False))
    assert abs(found.offset - 1.7e9 - LATE) < 1e-3
    first = ori.align(rates, ori.Keys(TIMES, poses().rotations[:, [3, 0, 1, 2]], scalar_first=True))
    assert np.allclose(first.body[[1, 2, 3, 0]], found.body, atol=1e-12)
    back = ori.align(poses(), ori.Rates(stamps, rates.rates))
    assert back.aligned.times.dtype == stamps.dtype and abs((back.aligned.times[0] - stamps[0]) / np.timedelta64(1, "s") - LATE) < 1e-3
    wild = ori.Rates(TIMES, np.where(np.arange(1500)[:, None] == 900, 50.0, rates.rates))
    left_out = ori.align(wild, poses())
    assert left_out.rejected_moved.tolist() == [900]
    assert [row["key"] for row in left_out.as_dict()["rejected_moved"]] == [900]


def test_says_what_one_axis_leaves_open():
    about_z = np.column_stack([np.zeros((1500, 2)), motion(TIMES)[1][:, 2]])
    noise = [np.random.default_rng(seed).normal(0, 0.01, (1500, 3)) for seed in (4, 5)]
    with pytest.warns(ori.ShapeWarning, match="do not tell apart: a turn of the body about"):
        found = ori.align(ori.Rates(TIMES, about_z + noise[0]), ori.Rates(TIMES, about_z + noise[1]))
    (only,) = found.open
    assert abs(only.body[2]) / np.linalg.norm(only.body) > 0.999 and abs(only.offset) < 0.01


def test_what_is_found_can_be_shown_copied_and_kept():
    found = ori.align(gyro(), poses())
    for again in (pickle.loads(pickle.dumps(found)), copy.deepcopy(found)):
        assert again.as_dict() == found.as_dict() and np.array_equal(again.aligned.rates, found.aligned.rates)
    assert found.as_dict()["gyros"] == {"input": True, "reference": False}
    assert str(found).startswith("1500 rates of a gyro onto 1500 orientations\n") and "offset_s" in found._repr_html_()
    assert repr(found).startswith("RateAlignment(Rates(1500 rates), body=[")


@pytest.mark.parametrize("call, kind, words", [
    (lambda: ori.align(at_rest(6), at_rest(7)), ori.DataError, "found no change of the rates that stands out"),
    (lambda: ori.align(ori.Rates(TIMES, np.zeros((1500, 3))), poses()), ori.DataError, "wanted two recordings of one motion"),
    (lambda: ori.align(ori.Rates([0, 1], np.zeros((2, 3))), poses()), ori.DataError, "found 2 rates, wanted 8 at least"),
    (lambda: ori.align(gyro(), poses(), offset=100), ori.ArgumentError, "offset: found recordings of which fewer than 8 turns of 0.05 s"),
    (lambda: ori.align(gyro(), poses(), offset=math.nan), ori.ArgumentError, "offset: found nan"),
    (lambda: ori.align(ori.Rates(TIMES[::-1], gyro().rates), poses()), ori.DataError, "does not come after the one before it"),
    (lambda: ori.align(gyro(), TIMES), TypeError, "b: found ndarray, wanted Keys or Rates"),
    (lambda: ori.align(TIMES, gyro()), TypeError, "a: found ndarray, wanted Keys or Rates"),
])
def test_refuses(call, kind, words):
    with pytest.raises(kind, match=words):
        call()
