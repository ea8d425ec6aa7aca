# SPDX-License-Identifier: Apache-2.0
"""Simulated recordings of a body that turns: its motion, what a gyro and a tracker say of it, and the faults that they have."""
import dataclasses

import numpy as np
from scipy.spatial.transform import Rotation

DEGREE = np.pi / 180


@dataclasses.dataclass(frozen=True)
class Setting:
    """What a recording is made with, and all that a smoother which knows the noise is told."""

    span: float  # [s]
    rate: int  # of the gyro [Hz]
    turning: float  # RMS of the body's rate, per axis [°/s]
    fastest: float  # of the sines that the rate is a sum of [Hz]
    every: int  # rates from one orientation to the next
    pose_noise: float  # per axis [°]
    rate_noise: float  # of one rate, per axis [°/s]
    bias: float  # standard deviation, per axis [°/s]
    walk: float = 0.0  # of the bias, standard deviation of its change in 1 s [°/s]
    scale: float = 0.0  # standard deviation of its error
    correlation: float = 0.0  # [s] of all the noise of the orientations; 0: it is white


@dataclasses.dataclass
class Recording:
    times: np.ndarray
    truth: Rotation
    turning: np.ndarray  # the true rates [rad/s]
    gyro_times: np.ndarray
    gyro: np.ndarray  # [rad/s]
    at: np.ndarray  # the places of the orientations among the times
    poses: Rotation
    gyro_errors: np.ndarray  # but for faults [rad/s]
    pose_errors: np.ndarray  # rotation vectors in the body [rad]
    measures: np.ndarray  # which rates are measurements of the body, axis by axis
    own_clock: bool


def motion(setting, dice):
    """Times, orientations and rates: sums of sines about each axis, integrated by steps of the fourth order."""
    sines, steps = 6, 10
    frequency, phase = dice.uniform(0.05, setting.fastest, (3, sines)), dice.uniform(0.0, 2 * np.pi, (3, sines))
    amplitude = dice.normal(size=(3, sines))
    amplitude *= setting.turning * DEGREE / np.sqrt(0.5 * (amplitude**2).sum(1, keepdims=True))

    def rate(t):
        return (amplitude * np.sin(2 * np.pi * frequency * t[:, None, None] + phase)).sum(2)

    count, step = round(setting.span * setting.rate), 1.0 / (setting.rate * steps)
    middle = (np.arange(count * steps) + 0.5) * step
    early, late = (rate(middle + sign * step * np.sqrt(3) / 6) for sign in (-1, 1))
    turns = Rotation.from_rotvec(0.5 * step * (early + late) + np.sqrt(3) / 12 * step**2 * np.cross(early, late))
    product = np.vstack([Rotation.from_rotvec(dice.normal(size=3)).as_quat(), turns.as_quat()])
    reach = 1
    while reach < len(product):  # all products of turns, by doubling
        product[reach:] = (Rotation.from_quat(product[:-reach]) * Rotation.from_quat(product[reach:])).as_quat()
        reach *= 2
    times = np.arange(count + 1) / setting.rate
    return times, Rotation.from_quat(product[::steps]), rate(times)


def pose_errors(setting, interval, count, dice):
    white = dice.normal(size=(count, 3)) * setting.pose_noise * DEGREE
    if setting.correlation:
        stays = np.exp(-interval / setting.correlation)
        for k in range(1, count):
            white[k] = stays * white[k - 1] + np.sqrt(1.0 - stays**2) * white[k]
    return white


def recorded(setting, seed):
    dice = np.random.default_rng(seed)
    times, truth, turning = motion(setting, dice)
    count, interval = len(times), 1.0 / setting.rate
    bias = setting.bias * dice.normal(size=3) + setting.walk * np.sqrt(interval) * np.cumsum(dice.normal(size=(count, 3)), 0)
    errors = turning * setting.scale * dice.normal(size=3) + bias * DEGREE + dice.normal(size=(count, 3)) * setting.rate_noise * DEGREE
    at = np.arange(0, count, setting.every)
    off = pose_errors(setting, setting.every * interval, len(at), dice)
    return Recording(
        times, truth, turning, times.copy(), turning + errors, at, truth[at] * Rotation.from_rotvec(off), errors, off,
        np.ones((count, 3), bool), setting.every > 1)


def scaled(share, recording):
    recording.gyro *= 1.0 + share


def mounted(degrees, recording):
    recording.gyro = Rotation.from_euler("x", degrees, degrees=True).apply(recording.gyro)


def drifts(recording):
    recording.gyro += np.outer(recording.times / recording.times[-1], [5.0, -3.0, 2.0]) * DEGREE


def steps(recording):
    recording.gyro[len(recording.gyro) // 2 :] += np.array([3.0, -2.0, 1.0]) * DEGREE


def clock_steps(recording):
    recording.gyro_times[len(recording.gyro) // 2 :] += 0.05
    recording.own_clock = True


def clock_runs(share, recording):
    recording.gyro_times *= 1.0 + share
    recording.own_clock = True


def batches(recording):
    """Ten rates with the stamp of the last one."""
    size = 10
    last = np.minimum(np.arange(len(recording.gyro)) // size * size + size - 1, len(recording.gyro) - 1)
    recording.gyro_times = recording.times[last] + 1e-5 * (np.arange(len(last)) % size)
    recording.own_clock = True


def sticks(recording):
    first, last = (round(share * len(recording.gyro)) for share in (0.45, 0.70))
    recording.gyro[first:last] = recording.gyro[first]
    recording.measures[first + 1 : last] = False


def wraps(recording):
    """At seven tenths of the largest rate."""
    limit = 0.7 * np.abs(recording.gyro).max()
    recording.gyro = (recording.gyro + limit) % (2.0 * limit) - limit


def clips(recording):
    limit = 0.7 * np.abs(recording.gyro).max()
    recording.measures = np.abs(recording.gyro) < limit
    recording.gyro = recording.gyro.clip(-limit, limit)


def loses_axis(recording):
    recording.gyro[:, 1] = 0.0
    recording.measures[:, 1] = False


def drops_out(recording):
    """Four times half a second."""
    count = len(recording.gyro)
    for share in (0.1, 0.3, 0.5, 0.7):
        recording.measures[round(share * count) : round((share + 0.025) * count)] = False
    keeps = recording.measures.all(1)
    recording.gyro_times, recording.gyro = recording.gyro_times[keeps], recording.gyro[keeps]
    recording.own_clock = True
