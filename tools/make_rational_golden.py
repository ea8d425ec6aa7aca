#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The method `rational` with 60 digits: tests/data/golden/rational.csv and rational_cases.csv, through sequences of keys.csv there.

Another way than the library's: the spline's second derivatives are the unknowns, in one dense system with the rules of both ends, and
the rates come from power series of the normalised quaternion, not from formulas for ω, α and the jerk. Every double is written by
repr, so it reads back exactly.

    tools/make_rational_golden.py [--check]
"""
import csv
import decimal
import pathlib

from golden_files import write_or_check

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "golden"
HEAD = ("# Made by tools/make_rational_golden.py.\n"
        "# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.\n"
        "# Every number is the double nearest to a value computed with 60 digits.\n")
CASES_NOTE = ("# A case, numbered within its family, builds `family` through `sequence` of keys.csv; columns as in cases.csv.\n"
              "# least_norm is the least |s| that was found on a fine grid.\n"
              "case,family,sequence,signs,ends,start_rate,end_rate,choices,parameters,period,key_rates,key_accelerations,"
              "key_jerks,max_halfangle,least_norm\n")
ROWS_NOTE = ("# side left is the limit at the right end of the segment, right the limit at its left end or a point inside.\n"
             "case,segment,t,side,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n")
START_RATE, END_RATE = [-0.46, -0.127, 0.307], [0.272, 0.572, -0.411]
ENDS = {"msmooth6": ("natural", "clamped", "rest", "loop"), "mrand6": ("natural", "clamped", "loop"),
        "mnonuni6": ("natural", "clamped", "rest", "loop"), "mratio10": ("natural", "clamped"), "mcoax": ("natural", "loop"),
        "mthree": ("natural", "rest", "loop"), "mrepeated": ("natural",), "mtiny": ("natural",), "smooth5": ("natural", "clamped"),
        "nonuni5": ("natural", "rest"), "nonuni_ratio10": ("natural",), "random12": ("natural", "loop"), "wild8": ("natural",),
        "nearpi": ("natural",)}
D = decimal.Decimal
decimal.getcontext().prec = 60
ZERO, ONE = D(0), D(1)


def dot(a, b):
    return sum((x * y for x, y in zip(a, b, strict=True)), ZERO)


def product(p, q):
    """Of quaternions, w first."""
    (a, b, c, d), (w, x, y, z) = p, q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]


def solved(rows):
    """Of equations that end with their right side, by elimination with the largest pivots."""
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, size):
            if rows[i][k]:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [x - factor * y for x, y in zip(rows[i], rows[k])]
    values = [ZERO] * size
    for k in reversed(range(size)):
        values[k] = (rows[k][size] - sum((rows[k][j] * values[j] for j in range(k + 1, size)), ZERO)) / rows[k][k]
    return values


class Spline:
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
        values = solved(rows)
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


def sequences():
    found = {}
    with open(FOLDER / "keys.csv", encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            key = [D(float(row[c])) for c in ("qw", "qx", "qy", "qz")]
            norm = dot(key, key).sqrt()
            found.setdefault(row["sequence"], []).append((D(float(row["t"])), [x / norm for x in key]))
    return found


def aligned(keys):
    for i in range(1, len(keys)):
        if dot(keys[i], keys[i - 1]) < 0:
            keys[i] = [-x for x in keys[i]]
    return keys


def numbers(values):
    return " ".join(repr(float(x)) for x in values)


def tables():
    cases, rows = [], []
    given = sequences()
    for sequence, all_ends in ENDS.items():
        for ends in all_ends:
            number = str(len(cases))
            times, keys = [t for t, _ in given[sequence]], aligned([list(q) for _, q in given[sequence]])
            sign, period = ONE, None
            if ends == "loop":
                sign = -ONE if dot(keys[-1], keys[0]) < 0 else ONE
                period = D(float(times[-1] - times[0] + D("0.75")))
                times.append(times[0] + period)
                keys.append([sign * x for x in keys[0]])
            rates = ([[D(x) for x in START_RATE], [D(x) for x in END_RATE]] if ends == "clamped" else [[ZERO] * 3] * 2)
            spline = Spline(times, keys, ends, rates, sign)
            least = min(dot(s, s).sqrt() for i, h in enumerate(spline.steps) for k in range(101)
                        for s in [[c[0] for c in spline.series(i, times[i] + h * k / 100)]])
            fields = [number, "rational", sequence, "shortest", "" if ends == "loop" else ends,
                      numbers(START_RATE) if ends == "clamped" else "", numbers(END_RATE) if ends == "clamped" else "", "", "",
                      repr(float(period)) if period else "", "", "", "", "0.0", f"{float(least):.3g}"]
            cases.append(",".join(fields))
            for i, h in enumerate(spline.steps):
                for share, side in ((0, "right"), ("0.25", "right"), ("0.6", "right"), (1, "left")):
                    t = times[i + 1] if share == 1 else D(float(times[i] + h * D(share)))
                    parts = motion(spline.series(i, t))
                    rows.append(",".join([number, str(i), repr(float(t)), side] + [repr(float(x)) for part in parts for x in part]))
    return {"rational_cases.csv": HEAD + CASES_NOTE + "\n".join(cases) + "\n", "rational.csv": HEAD + ROWS_NOTE + "\n".join(rows) + "\n"}


if __name__ == "__main__":
    write_or_check(FOLDER, tables())
