#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Smoothing splines of positions in exact arithmetic, for the tests of smoothing: tests/data/golden/position_splines.csv.

Another way than the library's, from the definition: of all functions with the values f at the times, the one of least
∫ (f^(p))² has d' G⁻¹ d of it, d the divided differences of order p, G the Gram matrix of the B-splines that are their Peano
kernels. So the smoothing spline has the values f = y - λ W⁻¹ D' (G + λ D W⁻¹ D')⁻¹ D y, here in fractions, dense. Its penalty, and
the trace of the hat matrix, likewise. Every double is written by repr, so it reads back exactly.

    tools/make_spline_golden.py [--check]
"""
import fractions
import math
import pathlib
import random
import sys

PATH = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "golden" / "position_splines.csv"
NOTE = ("# Positions of smoothing splines, by tools/make_spline_golden.py: dense, in exact fractions. order 2: cubic, 3: quintic.\n"
        "# The minimum of sum weight |p - found|^2 + lambda integral |f^(order)|^2 dt, with that integral and the trace of the hat matrix.\n"
        "case,order,lambda,penalty,trace,t,weight,px,py,pz,found_px,found_py,found_pz\n")
Fraction = fractions.Fraction


def solved(matrix, sides):
    """By elimination with exact pivots."""
    rows = [list(row) + list(side) for row, side in zip(matrix, sides, strict=True)]
    size = len(rows)
    for k in range(size):
        pivot = next(i for i in range(k, size) if rows[i][k])
        rows[k], rows[pivot] = rows[pivot], rows[k]
        rows[k] = [x / rows[k][k] for x in rows[k]]
        for i in range(size):
            if i != k and rows[i][k]:
                rows[i] = [x - rows[i][k] * y for x, y in zip(rows[i], rows[k])]
    return [row[size:] for row in rows]


def divided_differences(times, order):
    """One row for every order + 1 times in a row."""
    table = []
    for i in range(len(times) - order):
        row = [Fraction(0)] * len(times)
        for j in range(i, i + order + 1):
            row[j] = 1 / math.prod((times[j] - times[k] for k in range(i, i + order + 1) if k != j), start=Fraction(1))
        table.append(row)
    return table


def product(a, b):
    result = [Fraction(0)] * (len(a) + len(b) - 1)
    for i, x in enumerate(a):
        for j, y in enumerate(b):
            result[i + j] += x * y
    return result


def kernel(times, row, order, segment):
    """The Peano kernel of a divided difference on a segment: sum of row_j (t_j - t)^(order-1) / (order-1)! over times beyond it."""
    total = [Fraction(0)] * order
    for j in range(segment + 1, len(times)):
        power = [Fraction(1)]
        for _ in range(order - 1):
            power = product(power, [times[j], Fraction(-1)])
        for k, x in enumerate(power):
            total[k] += row[j] * x / math.factorial(order - 1)
    return total


def integral(polynomial, a, b):
    return sum(x * (b ** (k + 1) - a ** (k + 1)) / (k + 1) for k, x in enumerate(polynomial))


def gram(times, differences, order):
    size = len(differences)
    kernels = [[kernel(times, row, order, s) for s in range(len(times) - 1)] for row in differences]
    def inner(i, j):
        return sum(integral(product(kernels[i][s], kernels[j][s]), times[s], times[s + 1])
                   for s in range(max(i, j), min(i, j) + order))
    return [[inner(i, j) if abs(i - j) < order else Fraction(0) for j in range(size)] for i in range(size)]


def spline(times, weights, points, order, weight_of_penalty):
    """Values, penalty and trace; a weight of 0 is taken out by hand, for its value is one of the spline through the others."""
    t, y, n = [Fraction(x) for x in times], [[Fraction(x) for x in p] for p in points], len(times)
    lam = Fraction(weight_of_penalty)
    differences = divided_differences(t, order)
    system = gram(t, differences, order)
    inverse = [1 / Fraction(w) for w in weights]
    for i, a in enumerate(differences):
        for j, b in enumerate(differences):
            system[i][j] += lam * sum(a[k] * inverse[k] * b[k] for k in range(n))
    sides = [[sum(row[k] * y[k][axis] for k in range(n)) for axis in range(3)] + row for row in differences]
    answer = solved(system, sides)
    found = [[y[k][axis] - lam * inverse[k] * sum(row[k] * x[axis] for row, x in zip(differences, answer)) for axis in range(3)]
             for k in range(n)]
    trace = n - sum(lam * inverse[k] * sum(row[k] * x[3 + k] for row, x in zip(differences, answer)) for k in range(n))
    straight = gram(t, differences, order)  # the penalty of the spline: x' G x, x the solution
    size = len(differences)
    penalty = sum(answer[i][axis] * straight[i][j] * answer[j][axis] for axis in range(3) for i in range(size) for j in range(size))
    return found, penalty, trace


def cases():
    dice = random.Random(5)
    even = [0.125 * i for i in range(20)]
    uneven, t = [], 0.0
    for _ in range(18):
        uneven.append(t)
        t += round(dice.uniform(0.01, 0.3), 3)
    for order in (2, 3):
        for times, lam in ((even, 0.01), (uneven, 3e-5), (uneven, 20.0)):
            points = [[round(math.sin(2 * t) + dice.gauss(0, 0.1), 4), round(t * t + dice.gauss(0, 0.1), 4), round(dice.gauss(5, 1), 4)]
                      for t in times]
            weights = [1.0 if times is even else round(dice.uniform(0.2, 3), 2) for _ in times]
            yield order, lam, times, weights, points


def text():
    lines = [NOTE]
    for number, (order, lam, times, weights, points) in enumerate(cases()):
        found, penalty, trace = spline(times, weights, points, order, lam)
        for row in zip(times, weights, points, found, strict=True):
            t, w, p, f = row
            numbers = [lam, penalty, trace, t, w, *p, *f]
            lines.append(f"{number},{order}," + ",".join(repr(float(x)) for x in numbers) + "\n")
    return "".join(lines)


def main():
    made = text()
    if "--check" not in sys.argv[1:]:
        PATH.write_text(made, "utf-8")
    elif PATH.read_text("utf-8") != made:
        sys.exit(f"{PATH} is not what {sys.argv[0]} makes")


main()
