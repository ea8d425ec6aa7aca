#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`squad` with given inner quaternions by mpmath: tests/data/golden/inner_keys.csv and inner.csv.

Another way than the library's: Shoemake's Slerp by sines, Eberly's equations (18) and (22) as they stand, rates from numeric
derivatives of the quaternion at a precision that leaves them exact in double. Every double is written by repr, so it reads back
exactly.

    tools/make_inner_golden.py [--check]
"""
import random
from math import isnan

from golden_files import write_or_check
from make_biarcs_golden import FOLDER, combined, conjugate, dot, product, signed, step_of, unit
from mpmath import acos, cos, diff, mp, mpf, sin, sqrt

HEAD = ("# Made by tools/make_inner_golden.py.\n"
        "# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame.\n")
KEYS_NOTE = ("# An inner quaternion of nan is free. Some have the sign that is farther from their key.\n"
             "t,qw,qx,qy,qz,a_qw,a_qx,a_qy,a_qz,b_qw,b_qx,b_qy,b_qz\n")
ROWS_NOTE = ("# Every number is the double nearest to a value computed with 60 digits.\n"
             "# side left is the limit at the right end of the segment, right the limit at its left end or a point inside.\n"
             "segment,t,side,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n")
SEED, COUNT = 39, 7
FREE_LEAVING, FREE_ARRIVING, FAR = (2, 3), (3, 5), (1, 4)  # numbers of keys
mp.dps = 60


def exp_of(v):
    """exp(v) of a pure quaternion v, half the rotation vector."""
    size = sqrt(dot(v, v))
    return [cos(size)] + [sin(size) / size * x for x in v]


def slerp(t, p, q):
    angle = acos(dot(p, q))
    return combined((sin((1 - t) * angle) / sin(angle), p), (sin(t * angle) / sin(angle), q))


def doubles(values):
    """As a file has them and as a program reads them: unit again, but for rounding."""
    return [float(x) for x in values]


def keys():
    dice = random.Random(SEED)
    vector = lambda size: [mpf(size * dice.uniform(-1, 1)) for _ in range(3)]
    rows, t, q = [], 0.0, unit([mpf(dice.uniform(-1, 1)) for _ in range(4)])
    for i in range(COUNT):
        inner = [doubles(signed(-1 if i in FAR else 1, product(q, exp_of(vector(0.5))))) for _ in range(2)]
        if i in FREE_LEAVING:
            inner[0] = [float("nan")] * 4
        if i in FREE_ARRIVING:
            inner[1] = [float("nan")] * 4
        rows.append((t, doubles(q), *inner))
        t, q = t + dice.choice([0.25, 0.5, 1.0]), product(q, exp_of(vector(0.6)))
    return rows


def chosen(q, i):
    """Equation (22); at an end the key."""
    if i in (0, len(q) - 1):
        return q[i]
    away = [-(x + y) / 4 / 2 for x, y in zip(step_of(q[i], q[i + 1]), step_of(q[i], q[i - 1]), strict=True)]
    return product(q[i], exp_of(away))


def nearer(key, inner):
    return signed(-1 if dot(key, inner) < 0 else 1, inner)


def motion(at, t):
    with mp.workdps(140):
        orders = [[diff(lambda x, k=k: at(x)[k], t, n) if n else at(t)[k] for k in range(4)] for n in range(4)]
    back = [conjugate(q) for q in orders]
    rates = [[2 * x for x in product(back[0], orders[1])], [2 * x for x in product(back[0], orders[2])],
             [2 * (x + y) for x, y in zip(product(back[1], orders[2]), product(back[0], orders[3]), strict=True)]]
    return [orders[0]] + [rate[1:] for rate in rates]


def tables():
    rows = keys()
    times, q = [mpf(row[0]) for row in rows], [unit([mpf(x) for x in row[1]]) for row in rows]
    for i in range(1, COUNT):
        q[i] = nearer(q[i - 1], q[i])
    inner = [[chosen(q, i) if isnan(row[side][0]) else nearer(q[i], unit([mpf(x) for x in row[side]]))
              for i, row in enumerate(rows)] for side in (2, 3)]
    lines = []
    for n in range(COUNT - 1):
        def at(t, n=n):
            u = (t - times[n]) / (times[n + 1] - times[n])
            return slerp(2 * u * (1 - u), slerp(u, q[n], q[n + 1]), slerp(u, inner[0][n], inner[1][n + 1]))
        for share, side in ((0, "right"), ("0.25", "right"), ("0.6", "right"), (1, "left")):
            t = mpf(float(times[n] + (times[n + 1] - times[n]) * mpf(share)))
            lines.append(",".join([str(n), repr(float(t)), side] + [repr(float(x)) for part in motion(at, t) for x in part]))
    key_lines = [",".join(repr(x) for x in (row[0], *row[1], *row[2], *row[3])) for row in rows]
    return {"inner_keys.csv": HEAD + KEYS_NOTE + "\n".join(key_lines) + "\n", "inner.csv": HEAD + ROWS_NOTE + "\n".join(lines) + "\n"}


if __name__ == "__main__":
    write_or_check(FOLDER, tables())
