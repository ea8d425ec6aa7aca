# SPDX-License-Identifier: Apache-2.0
"""The figure of docs/families/measured.md: the distance of a curve to the truth, and its band."""
import math
import random

from rotations import DEGREE, conjugate, norm, times, turn, unit
from sampled_motion import sampled
from svg_drawing import BLUE, GREY, RED, Plot, document, legend, text

SHARE, NOISE = 0.9, 1.0 * DEGREE


def distances(motion, truth):
    return [2 * math.asin(min(1.0, norm(times(conjugate(p), q)[1:]))) / DEGREE for p, q in zip(motion.q, truth.q)]


def with_noise(rows):
    dice = random.Random(1)
    for t, q in rows:
        error = tuple(dice.gauss(0.0, NOISE) for _ in range(3))
        yield t, times(q, turn(unit(error), norm(error)))


def band_figure(command, truth, table):
    """`truth`: the flight; `table`: makes the text of a key file."""
    rows = list(zip(truth.t, truth.q))
    parts = legend(50, 16, [("auto", RED), ("measured", BLUE), (f"its {100 * SHARE:.0f} % band", GREY)])
    for top, label, keys in (
            (52, "distance to the truth [degrees]: a key of the flight every second", rows[::100]),
            (252, "the same with a key every tenth of a second, and 1° of noise on each axis", list(with_noise(rows[::10])))):
        measured = sampled(command, table(keys), 100, ["--method", "measured", "--band", str(SHARE)])
        band = [radius / DEGREE for radius in measured.column("band")]
        curves = [(band, GREY), (distances(sampled(command, table(keys), 100, ["--method", "auto"]), truth), RED),
                  (distances(measured, truth), BLUE)]
        plot = Plot((50, top, 780, 150), truth.t[0], truth.t[-1], 1.05 * max(max(c) for c, _ in curves), label)
        plot.parts += [text(plot.at(t, 0)[0], top + 166, f"{t} s") for t in range(0, 49, 8)]
        for values, color in curves:
            plot.curve(truth.t[:len(values)], values, color)
        parts += plot.parts
    return document(860, 432, parts)
