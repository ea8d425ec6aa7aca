# SPDX-License-Identifier: Apache-2.0
"""The figure of docs/gyro.md: how far smoothed orientations are from the truth, with a gyro whose clock is late and without it."""
import pathlib
import random
import subprocess
import tempfile

from band_figure import distances
from rotations import DEGREE, norm, times, turn, unit
from sampled_motion import Motion
from svg_drawing import BLUE, RED, Plot, document, legend, text

NOISE, GYRO_NOISE, BIAS, LATE = 1.0 * DEGREE, 0.3 * DEGREE, 0.5 * DEGREE, 6  # [rad], [rad/s], [rad/s], rows of 10 ms
EVERY, MISSING = 5, (20.0, 23.0)  # rows between orientations; where there are none [s]


def recorded(truth, dice):
    """The rows of poses, and those of the gyro."""
    poses, rates = ["t,qw,qx,qy,qz"], ["t,wx,wy,wz"]
    for k, (t, q, rate) in enumerate(zip(truth.t, truth.q, truth.vectors("wx"))):
        error = tuple(dice.gauss(0.0, NOISE) for _ in range(3))
        if k % EVERY == 0:
            poses.append(",".join(map(repr, (t, *times(q, turn(unit(error), norm(error)))))))
        rates.append(",".join(map(repr, (t + 0.01 * LATE, *(x + BIAS + dice.gauss(0.0, GYRO_NOISE) for x in rate)))))
    return poses, rates


def smoothed(command, poses, rates):
    """At the times of the truth."""
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "poses.csv").write_text("\n".join(poses) + "\n")
        (place / "gyro.csv").write_text("\n".join(rates or []) + "\n")
        call = [command, "smooth", place / "poses.csv", "--quiet", "--rate", "100", "-o", place / "out.csv"]
        subprocess.run([*call, *(["--gyro-file", place / "gyro.csv"] if rates else [])], check=True, stderr=subprocess.DEVNULL)
        return Motion((place / "out.csv").read_text())


def gyro_figure(command, truth):
    poses, rates = recorded(truth, random.Random(2))
    gap = [row for row in poses if not (row[0].isdigit() and MISSING[0] <= float(row.split(",")[0]) <= MISSING[1])]
    parts = legend(50, 16, [("without the gyro", RED), ("with it", BLUE)])
    for top, label, rows in ((52, "distance to the truth [degrees]: orientations at 20 Hz with 1° of noise, a gyro at 100 Hz that is 60 ms late", poses),
                             (252, "the same without orientations from 20 s to 23 s", gap)):
        curves = [(distances(smoothed(command, rows, used), truth), color) for used, color in ((None, RED), (rates, BLUE))]
        highest = 1.05 * min(12.0, max(max(values) for values, _ in curves))
        plot = Plot((50, top, 780, 150), truth.t[0], truth.t[-1], highest, label)
        plot.parts += [text(plot.at(t, 0)[0], top + 166, f"{t} s") for t in range(0, 49, 8)]
        for values, color in curves:
            plot.curve(truth.t[:len(values)], [min(value, highest) for value in values], color)
        parts += plot.parts
    return document(860, 432, parts)
