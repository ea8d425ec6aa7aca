# SPDX-License-Identifier: Apache-2.0
"""Splines whose equations are solved at once in exact or nearly exact numbers: the method `rational`, and smoothing splines of positions."""
import decimal
import fractions
import math
import random

from golden.exact import AROUND, CASES, CASES_NOTE, MOTION, NEAREST, SIDES, aligned, case_row, dot, doubles, product, segment_times, sequences, signed, solved

START_RATE, END_RATE = [-0.46, -0.127, 0.307], [0.272, 0.572, -0.411]
ENDS = {"msmooth6": ("natural", "clamped", "rest", "loop"), "mrand6": ("natural", "clamped", "loop"),
        "mnonuni6": ("natural", "clamped", "rest", "loop"), "mratio10": ("natural", "clamped"), "mcoax": ("natural", "loop"),
        "mthree": ("natural", "rest", "loop"), "mrepeated": ("natural",), "mtiny": ("natural",), "smooth5": ("natural", "clamped"),
        "nonuni5": ("natural", "rest"), "nonuni_ratio10": ("natural",), "random12": ("natural", "loop"), "wild8": ("natural",),
        "nearpi": ("natural",)}
D = decimal.Decimal
decimal.getcontext().prec = 60
ZERO, ONE = D(0), D(1)


class RationalSpline:
    """Of joints in R⁴: on segment i the cubic with the second derivatives m_i and m_{i+1} at its ends."""

    def __init__(self, times, joints, ends, rates, sign):
        self.times, self.joints = times, joints
        self.steps = [b - a for a, b in zip(times, times[1:])]
        last = len(joints) - 1
        rows = []
        for i in range(1, last):  # the first derivatives agree
            for axis in range(4):
                rows.append(self.difference(self.slope(i, axis, 0), self.slope(i - 1, axis, 1)))
        if ends == "loop":
            for axis in range(4):
                arriving = [sign * x for x in self.slope(last - 1, axis, 1)]
                rows.append(self.difference(self.slope(0, axis, 0), arriving))
                rows.append(self.row({(last, axis): ONE, (0, axis): -sign}, ZERO))
        else:
            for joint, segment, end, rate in ((0, 0, 0, rates[0]), (last, last - 1, 1, rates[1])):
                rows += self.natural(joint, segment, end) if ends == "natural" else self.given(joint, segment, end, rate)
        values = [x for x, in solved([row[:-1] for row in rows], [row[-1:] for row in rows])]
        self.bends = [values[4 * i:4 * i + 4] for i in range(last + 1)]

    def row(self, terms, wanted):
        row = [ZERO] * (4 * len(self.joints)) + [wanted]
        for (joint, axis), factor in terms.items():
            row[4 * joint + axis] = factor
        return row

    def slope(self, segment, axis, end):
        """The first derivative at an end of a segment: its terms in the unknowns, and last what does not depend on them."""
        h = self.steps[segment]
        here, there = (-h / 3, -h / 6) if end == 0 else (h / 6, h / 3)
        secant = (self.joints[segment + 1][axis] - self.joints[segment][axis]) / h
        return self.row({(segment, axis): here, (segment + 1, axis): there}, secant)

    @staticmethod
    def difference(a, b):
        return [x - y for x, y in zip(a[:-1], b[:-1])] + [b[-1] - a[-1]]

    def given(self, joint, segment, end, rate):
        wanted = product(self.joints[joint], [ZERO] + [x / 2 for x in rate])
        slopes = (self.slope(segment, axis, end) for axis in range(4))
        return [slope[:-1] + [value - slope[-1]] for slope, value in zip(slopes, wanted)]

    def natural(self, joint, segment, end):
        """|s| does not change, and s̈ has nothing beside the key: of its four components three equations are chosen."""
        key = self.joints[joint]
        slopes = [self.slope(segment, axis, end) for axis in range(4)]
        along = [dot(key, column) for column in zip(*slopes)]
        largest = max(range(4), key=lambda axis: abs(key[axis]))
        beside = [self.row({(joint, axis): key[largest], (joint, largest): -key[axis]}, ZERO) for axis in range(4) if axis != largest]
        return [along[:-1] + [-along[-1]]] + beside

    def series(self, segment, t):
        """The Taylor coefficients of s at t, up to order 3, component by component."""
        h, a, b = self.steps[segment], self.bends[segment], self.bends[segment + 1]
        y = t - self.times[segment]
        result = []
        for p, q, m, n in zip(self.joints[segment], self.joints[segment + 1], a, b):
            slope, third = (q - p) / h - h * (2 * m + n) / 6, (n - m) / h
            result.append([p + y * (slope + y * (m / 2 + y * third / 6)), slope + y * (m + y * third / 2), (m + y * third) / 2, third / 6])
        return result


def times_series(a, b):
    return [sum((a[i] * b[k - i] for i in range(k + 1)), ZERO) for k in range(4)]


def motion(series):
    """q, ω, α, jerk of s/|s|: by the power series of 1/|s|, then of 2 q̄ q̇."""
    square = [sum(column, ZERO) for column in zip(*(times_series(c, c) for c in series))]
    norm = [square[0].sqrt()]
    for k in range(1, 4):
        norm.append((square[k] - sum((norm[i] * norm[k - i] for i in range(1, k)), ZERO)) / (2 * norm[0]))
    per_norm = [1 / norm[0]]
    for k in range(1, 4):
        per_norm.append(-sum((norm[i] * per_norm[k - i] for i in range(1, k + 1)), ZERO) / norm[0])
    q = [times_series(c, per_norm) for c in series]
    orders = [[component[k] for component in q] for k in range(4)]
    conjugates = [[w, -x, -y, -z] for w, x, y, z in orders]
    rates = []
    for k in range(3):  # the coefficient of t^k in 2 q̄ q̇
        rates.append([sum((2 * (i + 1) * product(conjugates[k - i], orders[i + 1])[axis] for i in range(k + 1)), ZERO) for axis in (1, 2, 3)])
    return orders[0], rates[0], rates[1], [2 * x for x in rates[2]]


def rational(_):
    """The method `rational` with 60 digits, through sequences of keys.csv.

    Another way than the library's: the spline's second derivatives are the unknowns, in one dense system with the rules of both ends,
    and the rates come from power series of the normalised quaternion, not from formulas for ω, α and the jerk. Every double is written
    by repr, so it reads back exactly.
    """
    cases, rows = [], []
    given = sequences(D)
    for sequence, all_ends in ENDS.items():
        for ends in all_ends:
            number, times, keys = len(cases), list(given[sequence][0]), aligned(given[sequence][1])
            sign, period = ONE, None
            if ends == "loop":
                sign = -ONE if dot(keys[-1], keys[0]) < 0 else ONE
                period = D(float(times[-1] - times[0] + D("0.75")))
                times.append(times[0] + period)
                keys.append(signed(sign, keys[0]))
            rates = ([[D(x) for x in START_RATE], [D(x) for x in END_RATE]] if ends == "clamped" else [[ZERO] * 3] * 2)
            spline = RationalSpline(times, keys, ends, rates, sign)
            least = min(dot(s, s).sqrt() for i, h in enumerate(spline.steps) for k in range(101)
                        for s in [[c[0] for c in spline.series(i, times[i] + h * k / 100)]])
            given_rates = [" ".join(doubles(rate)) for rate in (START_RATE, END_RATE)] if ends == "clamped" else ("", "")
            cases.append(case_row(number, "rational", sequence, ends, given_rates, period, [f"{float(least):.3g}"]))
            for i in range(len(spline.steps)):
                for t, side in segment_times(times[i], times[i + 1], D):
                    rows.append(",".join([str(number), str(i), repr(float(t)), side, *doubles(*motion(spline.series(i, t)))]))
    head = "# Made by tools/make_rational_golden.py.\n" + AROUND + NEAREST
    case_head = CASES_NOTE + "# least_norm is the least |s| that was found on a fine grid.\n" + CASES + ",least_norm\n"
    return {"tests/data/golden/rational_cases.csv": head + case_head + "\n".join(cases) + "\n",
            "tests/data/golden/rational.csv": head + SIDES + "case,segment,t,side," + MOTION + "\n".join(rows) + "\n"}


# ---------------------------------------------------------------- smoothing splines of positions

Fraction = fractions.Fraction


def divided_differences(times, order):
    """One row for every order + 1 times in a row."""
    table = []
    for i in range(len(times) - order):
        row = [Fraction(0)] * len(times)
        for j in range(i, i + order + 1):
            row[j] = 1 / math.prod((times[j] - times[k] for k in range(i, i + order + 1) if k != j), start=Fraction(1))
        table.append(row)
    return table


def polynomial_product(a, b):
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
            power = polynomial_product(power, [times[j], Fraction(-1)])
        for k, x in enumerate(power):
            total[k] += row[j] * x / math.factorial(order - 1)
    return total


def integral(polynomial, a, b):
    return sum(x * (b ** (k + 1) - a ** (k + 1)) / (k + 1) for k, x in enumerate(polynomial))


def gram(times, differences, order):
    size = len(differences)
    kernels = [[kernel(times, row, order, s) for s in range(len(times) - 1)] for row in differences]
    def inner(i, j):
        return sum(integral(polynomial_product(kernels[i][s], kernels[j][s]), times[s], times[s + 1])
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


def positions(_):
    """Smoothing splines of positions in exact arithmetic, for the tests of smoothing.

    Another way than the library's, from the definition: of all functions with the values f at the times, the one of least
    ∫ (f^(p))² has d' G⁻¹ d of it, d the divided differences of order p, G the Gram matrix of the B-splines that are their Peano
    kernels. So the smoothing spline has the values f = y - λ W⁻¹ D' (G + λ D W⁻¹ D')⁻¹ D y, here in fractions, dense. Its penalty and
    the trace of the hat matrix are made in the same way. Every double is written by repr, so it reads back exactly.
    """
    lines = ["# Positions of smoothing splines, by tools/make_spline_golden.py: dense, in exact fractions. order 2: cubic, 3: quintic.\n"
             "# The minimum of sum weight |p - found|^2 + lambda integral |f^(order)|^2 dt, with that integral and the trace of the hat matrix.\n"
             "case,order,lambda,penalty,trace,t,weight,px,py,pz,found_px,found_py,found_pz\n"]
    for number, (order, lam, times, weights, points) in enumerate(cases()):
        found, penalty, trace = spline(times, weights, points, order, lam)
        for t, w, p, f in zip(times, weights, points, found, strict=True):
            lines.append(f"{number},{order}," + ",".join(doubles([lam, penalty, trace, t, w], p, f)) + "\n")
    return {"tests/data/golden/position_splines.csv": "".join(lines)}
