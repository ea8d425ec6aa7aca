# SPDX-License-Identifier: Apache-2.0
"""Parts of the recordings that lie beside the project, with noise added: the same samples on every machine."""
import csv
import math
import random

from motions.rotations import conjugate, times, unit

COUNT = 1500  # samples of each
BROAD_STEP = 3  # of its rows, 95 Hz
# Name -> file, columns of time and quaternion, columns of the gyro, seconds per unit of time.
RECORDINGS = {
    "BROAD": ("imu/broad_06_undisturbed_fast_rotation_A_40s.csv", "t_s opt_qw opt_qx opt_qy opt_qz", "gyr_{}_rad_s", 1.0),
    "PX4": ("flight/px4_quad_sample_attitude.csv", "t_s qw qx qy qz", "w{}_body_rad_s", 1.0),
    "MRO": ("spacecraft/mro_ck_sliced_-74000.csv", "sclk_ticks q0_w q1 q2 q3", None, 1 / 256),
}
GYRO_NOISE = {"BROAD": 5.1, "PX4": 0.05}  # deg/s per axis
NOISES = (0.2, 1.0, 3.0)  # deg per axis
# Way of smoothing that the reference knows too -> options of the command.
WAYS = {"gcv": "--loss l2 --no-adapt", "noise": "--loss l2 --no-adapt --noise {noise}deg",
        "jerk": "--loss l2 --no-adapt --penalty jerk",
        "gyro": "--loss l2 --noise {noise}deg --gyro --gyro-noise {gyro}deg/s --gyro-offset 0"}


def options_of(way, name, noise):
    return WAYS[way].format(noise=noise, gyro=GYRO_NOISE.get(name)).split()


class Motion:
    """Times [s], orientations (w, x, y, z) body to world, and body rates [rad/s] or None."""

    def __init__(self, times_s, orientations, rates):
        self.times, self.orientations, self.rates = times_s, orientations, rates

    def write(self, path):
        columns = [[t] for t in self.times], self.orientations, self.rates or [()] * len(self.times)
        with open(path, "w", encoding="utf-8") as file:
            file.write("t,qw,qx,qy,qz" + (",wx,wy,wz\n" if self.rates else "\n"))
            for parts in zip(*columns):
                file.write(",".join(repr(value) for part in parts for value in part) + "\n")


def rotation(vector):
    angle = math.sqrt(sum(x * x for x in vector))
    scale = math.sin(angle / 2) / angle if angle > 0 else 0.5
    return (math.cos(angle / 2), *(x * scale for x in vector))


def angle(a, b):
    w, *v = times(conjugate(a), b)
    return 2 * math.atan2(math.sqrt(sum(x * x for x in v)), abs(w))


def rms_degrees(found, wanted):
    return math.degrees(math.sqrt(sum(angle(a, b) ** 2 for a, b in zip(found, wanted, strict=True)) / len(wanted)))


def most_active(orientations):
    """Where the run of COUNT samples that travels farthest begins."""
    travelled = [0.0]
    for a, b in zip(orientations, orientations[1:]):
        travelled.append(travelled[-1] + angle(a, b))
    return max(range(len(orientations) - COUNT + 1), key=lambda i: travelled[i + COUNT - 1] - travelled[i])


def recording(name, data):
    path, columns, rates, second = RECORDINGS[name]
    names = columns.split() + ([rates.format(axis) for axis in "xyz"] if rates else [])
    with open(data / path, encoding="utf-8") as file:
        rows = [[float(row[n] or "nan") for n in names] for row in csv.DictReader(file)]
    if name == "BROAD":
        rows = rows[::BROAD_STEP]
    rows = [row for row in rows if all(map(math.isfinite, row))]
    orientations = [unit(tuple(row[1:5])) for row in rows]
    if name == "MRO":  # it states world to body
        orientations = [conjugate(q) for q in orientations]
    first = most_active(orientations) if name == "PX4" else 0
    part = slice(first, first + COUNT)
    return Motion([(row[0] - rows[first][0]) * second for row in rows[part]], orientations[part],
                  [tuple(row[5:]) for row in rows[part]] if rates else None)


def with_noise(motion, degrees, seed, outliers=0.0):
    """Noise of that σ per axis in the body frame; a share of `outliers` turns by 20° more."""
    dice = random.Random(seed)
    sigma = math.radians(degrees)

    def disturbed(q):
        q = times(q, rotation([dice.gauss(0, sigma) for _ in range(3)]))
        if not outliers or dice.random() >= outliers:
            return q
        axis = unit([dice.gauss(0, 1) for _ in range(3)])
        return times(q, rotation([math.radians(20) * x for x in axis]))

    return Motion(motion.times, [disturbed(q) for q in motion.orientations], motion.rates)
