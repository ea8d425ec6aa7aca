#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Means and medians of orientations and positions, with 120 digits by mpmath: tests/data/golden/mean_samples.csv, mean_cases.csv.

Nothing of the library's own way is in it: an angle is 2 acos |p·q|, gradients and Hessians of the sums are differences
in 120 digits, and Newton's method goes on until they are 0.

    tools/make_mean_golden.py [--check]
"""
import pathlib
import random

from golden_files import write_or_check
from mpmath import acos, cos, lu_solve, inverse, matrix, mp, mpf, nstr, sin, sqrt, zeros

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "golden"
mp.dps = 120
STEP = mpf(10) ** -20
KINDS = ("mean", "median")


def product(a, b):
    w, x, y, z = a
    s, i, j, k = b
    return [w * s - x * i - y * j - z * k, w * i + x * s + y * k - z * j, w * j - x * k + y * s + z * i,
            w * k + x * j - y * i + z * s]


def turn(v):
    angle = sqrt(sum(x * x for x in v))
    return [mpf(1), *(x / 2 for x in v)] if angle == 0 else [cos(angle / 2), *(x / angle * sin(angle / 2) for x in v)]


def unit(q):
    length = sqrt(sum(x * x for x in q))
    return [x / length for x in q]


class Orientations:
    @staticmethod
    def point(numbers):
        return unit([mpf(x) for x in numbers])

    @staticmethod
    def moved(q, v):
        return product(q, turn(v))

    @staticmethod
    def distance(q, p):
        return 2 * acos(min(abs(sum(a * b for a, b in zip(q, p))), mpf(1)))


class Positions:
    @staticmethod
    def point(numbers):
        return [mpf(x) for x in numbers]

    @staticmethod
    def moved(p, v):
        return [a + b for a, b in zip(p, v)]

    @staticmethod
    def distance(p, q):
        return sqrt(sum((a - b) ** 2 for a, b in zip(p, q)))


def signed(points, space):
    """With the signs of the first one, where they do not count."""
    if space is Positions:
        return points
    return [p if sum(a * b for a, b in zip(p, points[0])) > 0 else [-x for x in p] for p in points]


def cost(kind, distance):
    return distance ** 2 / 2 if kind == "mean" else distance


def axis(i, step=STEP):
    return [step if i == j else mpf(0) for j in range(3)]


def gradient(function):
    return matrix([(function(axis(i)) - function(axis(i, -STEP))) / (2 * STEP) for i in range(3)])


def hessian(function):
    found = zeros(3, 3)
    for i in range(3):
        for j in range(3):
            def at(a, b):
                return function([x + y for x, y in zip(axis(i, a * STEP), axis(j, b * STEP))])
            found[i, j] = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * STEP ** 2)
    return found


def least(space, kind, points, weights, start):
    """The point of the least sum, by Newton's method on differences; a step is halved until the sum falls."""
    q = start

    def sum_at(v):
        there = space.moved(q, v)
        return sum(w * cost(kind, space.distance(there, p)) for w, p in zip(weights, points))

    for _ in range(200):
        g = gradient(sum_at)
        if sqrt(sum(x * x for x in g)) < mpf(10) ** -27:
            return q, hessian(sum_at)
        step = list(lu_solve(hessian(sum_at), -g))
        if sum(x * y for x, y in zip(step, g)) > 0:
            step = [-x for x in g]
        while sum_at(step) >= sum_at([0, 0, 0]):
            step = [x / 2 for x in step]
        q = space.moved(q, step)
    raise ArithmeticError(f"no rest: {kind}, {space.__name__}, {nstr(sum_at([0, 0, 0]), 5)}")


def covariances(space, kind, points, weights, q, curvature):
    """Of one sample and of the middle: sums of squares of the gradients of each sample, which are differences."""
    count = 1 / sum(w * w for w in weights)
    spread, scores = zeros(3, 3), zeros(3, 3)
    for w, p in zip(weights, points):
        way = -gradient(lambda v: cost("mean", space.distance(space.moved(q, v), p)))
        score = gradient(lambda v: cost(kind, space.distance(space.moved(q, v), p)))
        spread += w * way * way.T
        scores += w * score * score.T
    inner = inverse(curvature)
    return spread * count / (count - 1), inner * scores * inner / (count - 1)


def six(m):
    return [m[0, 0], m[1, 1], m[2, 2], m[0, 1], m[0, 2], m[1, 2]]


def samples_of(name, count, spread, weighted):
    """Rows of decimals: weights, quaternions round one of any direction, of either sign and near norm 1, positions."""
    source = random.Random(name)
    base = unit([mpf(source.gauss(0, 1)) for _ in range(4)])
    for _ in range(count):
        q = product(base, turn([mpf(source.gauss(0, spread)) for _ in range(3)]))
        sign = source.choice((-1, 1))
        numbers = [nstr(sign * x, 17) for x in q]
        position = [f"{source.gauss(3, 1):.6f}" for _ in range(3)]
        yield [str(source.randint(4, 9)) if weighted else "1", *numbers, *position]


def main():
    cases = {"near": samples_of("near", 7, 0.02, False), "wide": samples_of("wide", 9, 0.45, False),
             "weights": samples_of("weights", 8, 0.3, True), "tight": samples_of("tight", 6, 1e-6, True)}
    samples = ["case,weight,qw,qx,qy,qz,px,py,pz"]
    found = ["case,kind,qw,qx,qy,qz,rms_distance,largest_distance,spread,covariance,px,py,pz,position_spread,position_covariance"]
    for name, rows in cases.items():
        rows = list(rows)
        samples += [",".join([name, *row]) for row in rows]
        numbers = [[float(x) for x in row] for row in rows]
        weights = [mpf(row[0]) for row in numbers]
        weights = [w / sum(weights) for w in weights]
        for kind in KINDS:
            cells = [name, kind]
            for space, columns in ((Orientations, slice(1, 5)), (Positions, slice(5, 8))):
                points = [space.point(row[columns]) for row in numbers]
                start = [sum(w * x for w, x in zip(weights, column)) for column in zip(*signed(points, space))]
                q, curvature = least(space, kind, points, weights, unit(start) if space is Orientations else start)
                distances = [space.distance(q, p) for p in points]
                spread, covariance = covariances(space, kind, points, weights, q, curvature)
                q = [x if space is Positions or q[0] > 0 else -x for x in q]
                cells += [nstr(x, 20) for x in q]
                if space is Orientations:
                    cells += [nstr(sqrt(sum(w * d * d for w, d in zip(weights, distances))), 20), nstr(max(distances), 20)]
                cells += [" ".join(nstr(x, 20) for x in six(m)) for m in (spread, covariance)]
            found.append(",".join(cells))
    head = "# Made by tools/make_mean_golden.py with 120 digits.\n"
    write_or_check(FOLDER, {"mean_samples.csv": head + "\n".join(samples) + "\n", "mean_cases.csv": head + "\n".join(found) + "\n"})


if __name__ == "__main__":
    main()
