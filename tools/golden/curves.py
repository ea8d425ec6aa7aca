# SPDX-License-Identifier: Apache-2.0
"""Curves with 60 digits by mpmath: the methods `biarcs` and `monotone`, and `squad` with given inner quaternions.

Rates come from numeric derivatives of the quaternion at a precision that leaves them exact in double. Every double is written by repr,
so it reads back exactly.
"""
import random
from math import isnan

from golden.exact import AROUND, CASES, CASES_NOTE, MOTION, NEAREST, SIDES, aligned, case_row, combined, conjugate, dot, doubles, norm, product, segment_times
from golden.exact import sequences, signed, unit
from mpmath import acos, atan2, cos, diff, mp, mpf, sin, sqrt

mp.dps = 60

# ---------------------------------------------------------------- biarcs

ENDS = {"msmooth6": ("natural", "rest", "loop"), "mrand6": ("natural", "loop"), "mnonuni6": ("natural", "rest", "loop"),
        "mratio10": ("natural",), "mthree": ("natural", "loop"), "mrepeated": ("natural",), "smooth5": ("natural",),
        "nonuni5": ("natural", "rest"), "nearpi": ("natural",)}


def step_of(p, q):
    """The rotation vector from p to q."""
    w, *v = product(conjugate(p), q)
    size = norm(v)
    return [2 * acos(w) * x / size for x in v] if size else [mpf(0)] * 3


def motion(at, t):
    """The quaternion at(t) and its body rates to order 3."""
    with mp.workdps(140):
        orders = [[diff(lambda x, k=k: at(x)[k], t, n) if n else at(t)[k] for k in range(4)] for n in range(4)]
    back = [conjugate(q) for q in orders]
    rates = [[2 * x for x in product(back[0], orders[1])], [2 * x for x in product(back[0], orders[2])],
             [2 * (x + y) for x, y in zip(product(back[1], orders[2]), product(back[0], orders[3]), strict=True)]]
    return [orders[0]] + [rate[1:] for rate in rates]


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
    size_a, size_b = norm(a), norm(b)
    if not size_a or not size_b or min(size_a / h, size_b / k) < mpf("0.001") * max(size_a / h, size_b / k):
        return None
    a, b = unit(a), unit(b)
    cosine, share_a, share_b = dot(a, b), size_a * k / h, size_b * h / k
    if cosine < cos(mp.pi * 150 / 180):
        return None
    if cosine < 0:
        share_a, share_b = min(share_a, share_b / sqrt(-cosine)), min(share_b, share_a / sqrt(-cosine))
    return unit(combined((share_a, a), (share_b, b)))


class Biarcs:
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
        return motion(lambda x: segment.at(self.way(i, x), after), t)


def three_rounds(times, keys):
    """Of a loop, of which the second one has the keys on either side that it looks at; and the period."""
    sign = -1 if dot(keys[-1], keys[0]) < 0 else 1
    period = mpf(float(times[-1] - times[0] + mpf(3) / 4))
    return ([t + k * period for k in (-1, 0, 1) for t in times] + [times[0] + 2 * period],
            [signed(s, q) for s in (sign, 1, sign) for q in keys] + [keys[0]], period)


def biarcs(_):
    """The method `biarcs` through sequences of keys.csv.

    Another way than the library's: circles by their centres and angles, both arcs run through forwards.
    """
    mp.dps = 60
    cases, rows = [], []
    given = sequences(mpf)
    for sequence, all_ends in ENDS.items():
        for ends in all_ends:
            number, times, keys = len(cases), given[sequence][0], aligned(given[sequence][1])
            first, count, period = 0, len(keys) - 1, None
            if ends == "loop":
                first = count = len(keys)
                times, keys, period = three_rounds(times, keys)
            curve = Biarcs(times, keys, ends)
            cases.append(case_row(number, "biarcs", sequence, ends, period=period))
            for i in range(count):
                for t, side in segment_times(times[first + i], times[first + i + 1], mpf):
                    rows.append(",".join([str(number), str(i), repr(float(t)), side, *doubles(*curve.motion(first + i, t, side))]))
    head = "# Made by tools/make_biarcs_golden.py.\n" + AROUND + NEAREST
    return {"tests/data/golden/biarcs_cases.csv": head + CASES_NOTE + CASES + "\n" + "\n".join(cases) + "\n",
            "tests/data/golden/biarcs.csv": head + SIDES + "case,segment,t,side," + MOTION + "\n".join(rows) + "\n"}


# ---------------------------------------------------------------- monotone

MONOTONE = {"msmooth6": (False, True), "mrand6": (False, True), "mnonuni6": (False, True), "mratio10": (False,), "mthree": (False, True),
            "mrepeated": (False,), "smooth5": (False,), "nonuni5": (False,), "nearpi": (False,)}  # sequence -> open, a loop, or both


class Cubics:
    """Cubics of the rotation vector from the middle of each step, whose rates there are those of docs/families/monotone.md."""

    def __init__(self, times, keys):
        self.times, self.keys = times, keys
        self.steps = [b - a for a, b in zip(times, times[1:])]
        self.turns = [step_of(p, q) for p, q in zip(keys, keys[1:])]
        inner = [self.rate_between(i - 1, i) for i in range(1, len(keys) - 1)]
        self.rates = [self.rate_at_end(0, 1), *inner, self.rate_at_end(-1, -2)]

    def rate_between(self, i, k):
        (a, b), (h, l) = (self.turns[i], self.turns[k]), (self.steps[i], self.steps[k])
        if not norm(a) or not norm(b):
            return [mpf(0)] * 3
        speed = 3 * (h + l) / ((2 * l + h) * h / norm(a) + (l + 2 * h) * l / norm(b))
        return combined((speed / 2, unit(a)), (speed / 2, unit(b)))

    def rate_at_end(self, i, k):
        (a, b), (h, l) = (self.turns[i], self.turns[k]), (self.steps[i], self.steps[k])
        if not norm(a):
            return a
        speed, beside = norm(a) / h, dot(unit(a), b) / l
        return combined((min(max(((2 * h + l) * speed - h * beside) / (h + l), mpf(0)), 3 * speed), unit(a)))

    def motion(self, i, t):
        middle = product(self.keys[i], exp_of([x / 4 for x in self.turns[i]]))
        ends = [step_of(middle, self.keys[k]) for k in (i, i + 1)]

        def slope(k):
            """Of the rotation vector where the body turns at the rate of the key."""
            rate = self.rates[k]
            if not norm(rate):
                return rate
            return [diff(lambda s: step_of(middle, product(self.keys[k], exp_of([s * x / 2 for x in rate])))[j] if s else ends[k - i][j], 0)
                    for j in range(3)]

        h, leaving, arriving = self.steps[i], slope(i), slope(i + 1)

        def at(time):
            u = (time - self.times[i]) / h
            psi = combined(((1 + 2 * u) * (1 - u) ** 2, ends[0]), (h * u * (1 - u) ** 2, leaving), (u * u * (3 - 2 * u), ends[1]),
                           (h * u * u * (u - 1), arriving))
            return product(middle, exp_of([x / 2 for x in psi]))

        return motion(at, t)


def monotone(_):
    """The method `monotone` through sequences of keys.csv.

    Another way than the library's: the rates are carried into the charts by numeric derivatives of the logarithm.
    """
    mp.dps = 60
    cases, rows = [], []
    given = sequences(mpf)
    for sequence, loops in MONOTONE.items():
        for is_loop in loops:
            number, times, keys = len(cases), given[sequence][0], aligned(given[sequence][1])
            first, count, period = 0, len(keys) - 1, None
            if is_loop:
                first = count = len(keys)
                times, keys, period = three_rounds(times, keys)
            curve = Cubics(times, keys)
            cases.append(case_row(number, "monotone", sequence, "", period=period))
            for i in range(count):
                for t, side in segment_times(times[first + i], times[first + i + 1], mpf):
                    rows.append(",".join([str(number), str(i), repr(float(t)), side, *doubles(*curve.motion(first + i, t))]))
    head = "# Made by tools/make_golden.py monotone.\n" + AROUND + NEAREST
    return {"tests/data/golden/monotone_cases.csv": head + CASES_NOTE + CASES + "\n" + "\n".join(cases) + "\n",
            "tests/data/golden/monotone.csv": head + SIDES + "case,segment,t,side," + MOTION + "\n".join(rows) + "\n"}


# ---------------------------------------------------------------- squad with given inner quaternions

SEED, COUNT = 39, 7
FREE_LEAVING, FREE_ARRIVING, FAR = (2, 3), (3, 5), (1, 4)  # numbers of keys


def exp_of(v):
    """exp(v) of a pure quaternion v, half the rotation vector."""
    size = norm(v)
    return [cos(size)] + [sin(size) / size * x if size else x for x in v]


def slerp(t, p, q):
    angle = acos(dot(p, q))
    return combined((sin((1 - t) * angle) / sin(angle), p), (sin(t * angle) / sin(angle), q))


def inner_keys():
    dice = random.Random(SEED)
    vector = lambda size: [mpf(size * dice.uniform(-1, 1)) for _ in range(3)]
    rows, t, q = [], 0.0, unit([mpf(dice.uniform(-1, 1)) for _ in range(4)])
    for i in range(COUNT):
        inner = [list(map(float, signed(-1 if i in FAR else 1, product(q, exp_of(vector(0.5)))))) for _ in range(2)]
        if i in FREE_LEAVING:
            inner[0] = [float("nan")] * 4
        if i in FREE_ARRIVING:
            inner[1] = [float("nan")] * 4
        rows.append((t, list(map(float, q)), *inner))
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


def inner(_):
    """`squad` with given inner quaternions.

    Another way than the library's: Shoemake's Slerp by sines, Eberly's equations (18) and (22) as they stand.
    """
    mp.dps = 60
    rows = inner_keys()
    times, q = [mpf(row[0]) for row in rows], aligned(unit([mpf(x) for x in row[1]]) for row in rows)
    inner = [[chosen(q, i) if isnan(row[side][0]) else nearer(q[i], unit([mpf(x) for x in row[side]]))
              for i, row in enumerate(rows)] for side in (2, 3)]
    lines = []
    for n in range(COUNT - 1):
        def at(t, n=n):
            u = (t - times[n]) / (times[n + 1] - times[n])
            return slerp(2 * u * (1 - u), slerp(u, q[n], q[n + 1]), slerp(u, inner[0][n], inner[1][n + 1]))
        for t, side in segment_times(times[n], times[n + 1], mpf):
            lines.append(",".join([str(n), repr(float(t)), side, *doubles(*motion(at, t))]))
    head = "# Made by tools/make_inner_golden.py.\n" + AROUND.replace(", per unit of key time", "")
    key_head = ("# An inner quaternion of nan is free. Some have the sign that is farther from their key.\n"
                "t,qw,qx,qy,qz,a_qw,a_qx,a_qy,a_qz,b_qw,b_qx,b_qy,b_qz\n")
    key_lines = [",".join(repr(x) for x in (row[0], *row[1], *row[2], *row[3])) for row in rows]
    return {"tests/data/golden/inner_keys.csv": head + key_head + "\n".join(key_lines) + "\n",
            "tests/data/golden/inner.csv": head + NEAREST + SIDES + "segment,t,side," + MOTION + "\n".join(lines) + "\n"}
