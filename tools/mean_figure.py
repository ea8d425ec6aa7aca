# SPDX-License-Identifier: Apache-2.0
"""The figure of docs/mean.md: good and bad rows with their mean and their median, and how far both go astray the more rows are bad."""
import json
import math
import random
import subprocess

from rotations import DEGREE, conjugate, norm, times, to_world, turn, unit
from sphere_view import EYE, RIGHT, UP, dot, sphere
from svg_drawing import BLUE, INK, RED, Plot, document, legend, text

TRUTH = times(turn((0.0, 0.0, 1.0), 12 * DEGREE), turn((0.0, 1.0, 0.0), -14 * DEGREE))
BAD = times(TRUTH, turn(unit((0.2, 0.5, 1.0)), 60 * DEGREE))  # where bad rows agree to be
KINDS = (("mean", RED), ("median", BLUE))
ROWS, NOISE, SHARES = 100, 2 * DEGREE, range(0, 61, 2)


class Rows:
    """Quaternions as sphere() takes keys."""

    def __init__(self, q):
        self.q = q


def noisy(q, noise, dice):
    error = tuple(dice.gauss(0.0, noise) for _ in range(3))
    return times(q, turn(unit(error), norm(error)))


def middle(command, rows, kind):
    table = "qw,qx,qy,qz\n" + "".join(",".join(map(repr, q)) + "\n" for q in rows)
    call = [command, "mean", "-", "--input-format", "csv", "--kind", kind, "--json"]
    found = json.loads(subprocess.run(call, input=table, check=True, capture_output=True, text=True).stdout)
    return tuple(found[name] for name in ("qw", "qx", "qy", "qz"))


def angle(p, q):
    return 2 * math.asin(min(1.0, norm(times(conjugate(p), q)[1:]))) / DEGREE


def rows_on_the_sphere(command, center, radius):
    dice, axis = random.Random(5), (1.0, 0.0, 0.0)
    rows = [noisy(TRUTH, 5 * DEGREE, dice) for _ in range(5)] + [noisy(BAD, 8 * DEGREE, dice) for _ in range(4)]
    parts = sphere(center, radius, [], Rows(rows), axis)
    for kind, color in KINDS:
        v = to_world(middle(command, rows, kind), axis)
        assert dot(v, EYE) > 0
        x, y = center[0] + radius * dot(v, RIGHT), center[1] - radius * dot(v, UP)
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="6" fill="none" stroke="{color}" stroke-width="3"/>')
    return parts


def mean_figure(command):
    parts = rows_on_the_sphere(command, (190, 210), 160)
    parts.append(text(190, 392, "x axis of the body: five good rows, four bad ones", color=INK))
    plot = Plot((440, 60, 390, 290), 0, SHARES[-1], 65, "distance to the truth [degrees]")
    for kind, color in KINDS:
        dice, values = random.Random(7), []
        for bad in SHARES:
            rows = [noisy(TRUTH if k >= bad else BAD, NOISE, dice) for k in range(ROWS)]
            values.append(angle(TRUTH, middle(command, rows, kind)))
        plot.curve(list(SHARES), values, color, 2)
    plot.parts += [text(plot.at(share, 0)[0], 368, f"{share} %") for share in range(0, 61, 10)]
    plot.parts.append(text(635, 392, "bad rows, all of them alike", color=INK))
    return document(860, 410, parts + plot.parts + legend(440, 20, list(KINDS)))
