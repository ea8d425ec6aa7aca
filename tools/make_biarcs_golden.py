#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The method `biarcs` with mpmath, 60 digits: tests/data/golden/biarcs.csv and biarcs_cases.csv, through sequences of keys.csv there.

Another way than the library's: circles by their centres and angles, both arcs run through forwards, rates from numeric derivatives
of the quaternion at a precision that leaves them exact in double. Every double is written by repr, so it reads back exactly.

    tools/make_biarcs_golden.py [--check]
"""
import csv
import pathlib

from golden_files import write_or_check
from mpmath import acos, atan2, cos, diff, mp, mpf, sin, sqrt

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "golden"
HEAD = ("# Made by tools/make_biarcs_golden.py.\n"
        "# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.\n"
        "# Every number is the double nearest to a value computed with 60 digits.\n")
CASES_NOTE = ("# A case, numbered within its family, builds `family` through `sequence` of keys.csv; columns as in cases.csv.\n"
              "case,family,sequence,signs,ends,start_rate,end_rate,choices,parameters,period,key_rates,key_accelerations,"
              "key_jerks,max_halfangle\n")
ROWS_NOTE = ("# side left is the limit at the right end of the segment, right the limit at its left end or a point inside.\n"
             "case,segment,t,side,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n")
ENDS = {"msmooth6": ("natural", "rest", "loop"), "mrand6": ("natural", "loop"), "mnonuni6": ("natural", "rest", "loop"),
        "mratio10": ("natural",), "mthree": ("natural", "loop"), "mrepeated": ("natural",), "smooth5": ("natural",),
        "nonuni5": ("natural", "rest"), "nearpi": ("natural",)}
mp.dps = 60


def dot(a, b):
    return sum((x * y for x, y in zip(a, b, strict=True)), mpf(0))


def combined(*terms):
    return [sum((f * v[k] for f, v in terms), mpf(0)) for k in range(len(terms[0][1]))]


def unit(v):
    return [x / sqrt(dot(v, v)) for x in v]


def product(p, q):
    (a, b, c, d), (w, x, y, z) = p, q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def step_of(p, q):
    """The rotation vector from p to q."""
    w, *v = product(conjugate(p), q)
    size = sqrt(dot(v, v))
    return [2 * acos(w) * x / size for x in v] if size else [mpf(0)] * 3


class Circle:
    """The arc from a point with a unit tangent to another point."""

    def __init__(self, start, tangent, end):
        chord = combined((1, end), (-1, start))
        ahead = dot(chord, tangent)
        self.inwards = unit(combined((1, chord), (-ahead, tangent)))
        self.tangent = tangent
        self.radius = dot(chord, chord) / (2 * dot(chord, self.inwards))
        self.centre = combined((1, start), (self.radius, self.inwards))
        self.length = self.radius * 2 * atan2(dot(chord, self.inwards), ahead)

    def at(self, way):
        angle = way / self.radius
        return combined((1, self.centre), (-self.radius * cos(angle), self.inwards), (self.radius * sin(angle), self.tangent))


class Segment:
    def __init__(self, p, t, q, u):
        self.start = p
        self.arcs = []
        if p == q:
            return
        chord, both = combined((1, q), (-1, p)), combined((1, t), (1, u))
        a, b, c = 4 - dot(both, both), 2 * dot(chord, both), -dot(chord, chord)
        reach = (-b + sqrt(b * b - 4 * a * c)) / (2 * a)
        first, third = combined((1, p), (reach, t)), combined((1, q), (-reach, u))
        joint = combined((mpf(1) / 2, first), (mpf(1) / 2, third))
        self.arcs = [Circle(p, t, joint), Circle(joint, unit(combined((1, third), (-1, first))), q)]

    @property
    def length(self):
        return sum((arc.length for arc in self.arcs), mpf(0))

    def at(self, way, after_joint):
        if not self.arcs:
            return self.start
        return self.arcs[1].at(way - self.arcs[0].length) if after_joint else self.arcs[0].at(way)


def direction_between(a, h, b, k):
    """None where the curve stops."""
    size_a, size_b = sqrt(dot(a, a)), sqrt(dot(b, b))
    if not size_a or not size_b or min(size_a / h, size_b / k) < mpf("0.001") * max(size_a / h, size_b / k):
        return None
    a, b = unit(a), unit(b)
    cosine, share_a, share_b = dot(a, b), size_a * k / h, size_b * h / k
    if cosine < cos(mp.pi * 150 / 180):
        return None
    if cosine < 0:
        share_a, share_b = min(share_a, share_b / sqrt(-cosine)), min(share_b, share_a / sqrt(-cosine))
    return unit(combined((share_a, a), (share_b, b)))


class Curve:
    def __init__(self, times, keys, ends):
        self.times = times
        self.steps = [b - a for a, b in zip(times, times[1:])]
        turns = [step_of(p, q) for p, q in zip(keys, keys[1:])]
        last = len(keys) - 1
        directions = [None] + [direction_between(turns[i - 1], self.steps[i - 1], turns[i], self.steps[i]) for i in range(1, last)] + [None]
        tangents = [d and product(q, [mpf(0), *d]) for q, d in zip(keys, directions)]
        self.segments = []
        for i in range(last):
            p, q, t, u = keys[i], keys[i + 1], tangents[i], tangents[i + 1]
            if p != q:
                chord = unit(combined((1, q), (-1, p)))

                def mirrored(v, chord=chord):
                    return combined((2 * dot(v, chord), chord), (-1, v))
                if not t and not u:
                    t, u = (product(x, [mpf(0), *unit(turns[i])]) for x in (p, q))
                t, u = t or mirrored(u), u or mirrored(t)
            self.segments.append(Segment(p, t, q, u))
        speeds = [mpf(0)] * (last + 1)
        for i in range(1, last):
            if directions[i]:
                h, k = self.steps[i - 1], self.steps[i]
                slow, fast = self.segments[i - 1].length / h, self.segments[i].length / k
                speeds[i] = 3 * (h + k) / ((2 * k + h) / slow + (k + 2 * h) / fast)
        if ends != "rest":
            speeds[0] = (3 * self.segments[0].length / self.steps[0] - speeds[1]) / 2
            speeds[last] = (3 * self.segments[-1].length / self.steps[-1] - speeds[last - 1]) / 2
        self.speeds = speeds

    def way(self, i, t):
        h, length = self.steps[i], self.segments[i].length
        s = t - self.times[i]
        a, b, secant = self.speeds[i], self.speeds[i + 1], length / h
        return s * (a + s * ((3 * secant - 2 * a - b) / h + s * (a + b - 2 * secant) / h ** 2))

    def motion(self, i, t, side):
        segment = self.segments[i]
        after = bool(segment.arcs) and (side == "left" or self.way(i, t) > segment.arcs[0].length)
        with mp.workdps(140):
            orders = [[diff(lambda x, k=k: segment.at(self.way(i, x), after)[k], t, n) if n else segment.at(self.way(i, t), after)[k]
                       for k in range(4)] for n in range(4)]
        c = [conjugate(q) for q in orders]
        rates = [[2 * x for x in product(c[0], orders[1])],
                 [2 * x for x in product(c[0], orders[2])],
                 [2 * (x + y) for x, y in zip(product(c[1], orders[2]), product(c[0], orders[3]))]]
        return [orders[0]] + [r[1:] for r in rates]


def sequences():
    found = {}
    with open(FOLDER / "keys.csv", encoding="utf-8") as file:
        for row in csv.DictReader(line for line in file if not line.startswith("#")):
            found.setdefault(row["sequence"], []).append((mpf(float(row["t"])), unit([mpf(float(row[c])) for c in ("qw", "qx", "qy", "qz")])))
    return found


def signed(sign, q):
    return [sign * x for x in q]


def tables():
    cases, rows = [], []
    given = sequences()
    for sequence, all_ends in ENDS.items():
        for ends in all_ends:
            number, times, keys = str(len(cases)), [t for t, _ in given[sequence]], [list(q) for _, q in given[sequence]]
            for i in range(1, len(keys)):
                if dot(keys[i], keys[i - 1]) < 0:
                    keys[i] = signed(-1, keys[i])
            first, count, period = 0, len(keys) - 1, None
            if ends == "loop":  # three rounds, of which the second is taken
                sign, n = (-1 if dot(keys[-1], keys[0]) < 0 else 1), len(keys)
                period = mpf(float(times[-1] - times[0] + mpf(3) / 4))
                times = [t + k * period for k in (-1, 0, 1) for t in times] + [times[0] + 2 * period]
                keys = [signed(s, q) for s in (sign, 1, sign) for q in keys] + [keys[0]]
                first, count = n, n
            curve = Curve(times, keys, ends)
            cases.append(",".join([number, "biarcs", sequence, "shortest", "" if period else ends, "", "", "", "",
                                   repr(float(period)) if period else "", "", "", "", "0.0"]))
            for i in range(count):
                j = first + i
                for share, side in ((0, "right"), ("0.25", "right"), ("0.6", "right"), (1, "left")):
                    t = times[j + 1] if share == 1 else mpf(float(times[j] + (times[j + 1] - times[j]) * mpf(share)))
                    parts = curve.motion(j, t, side)
                    rows.append(",".join([number, str(i), repr(float(t)), side] + [repr(float(x)) for part in parts for x in part]))
    return {"biarcs_cases.csv": HEAD + CASES_NOTE + "\n".join(cases) + "\n", "biarcs.csv": HEAD + ROWS_NOTE + "\n".join(rows) + "\n"}


if __name__ == "__main__":
    write_or_check(FOLDER, tables())
