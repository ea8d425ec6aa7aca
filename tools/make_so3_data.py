#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes the tables of SO(3) functions that the math tests read: tests/data/so3.csv, so3_jets.csv, so3_series.csv.

Needs mpmath (the only script here that does; the project itself never needs it: the tables are committed).
Every number is the double nearest to a value computed with 60 digits from exact double input.
"""
import pathlib

from mpmath import atan2, bernoulli, cos, cot, factorial, mp, mpf, pi, sin, sqrt, taylor

mp.dps = 60
FOLDER = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data"
ORIGIN = f"# Made by tools/make_so3_data.py (mpmath, {mp.dps} digits): doubles nearest to the true values of exact input.\n"
AXES = [(1, 0, 0), (0, 0, -1), (1, 2, -2), (-3, 4, 12), (0.6, -0.7, 0.1)]
FACTORS = [0.0, 0.25, 0.5, 1.0, 1.75, -1.0, -0.3]


def norm(v):
    return sqrt(sum(x * x for x in v))


def exp(phi):
    angle = norm(phi) / 2
    s = sin(angle) / angle / 2 if angle else mpf(1) / 2
    return [cos(angle)] + [s * x for x in phi]


def log(q):
    s = norm(q[1:])
    return [2 * atan2(s, q[0]) * x / s if s else mpf(0) for x in q[1:]]


def doubles(values):
    return [float(x) for x in values]


def exact(values):
    return [mpf(x) for x in values]


def line(*fields):
    return ",".join(f if isinstance(f, str) else repr(f) for f in fields) + "\n"


def angles():
    tiny = [1e-300, 1e-200, 1e-154, 1e-100, 1e-20, 1e-16, 1e-12, 1e-9, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2]
    middle = [0.1, 0.5, 1.0, 1.4, 1.4454, 1.4455, 1.5, 1.99, 2.0, 2.01, 2.5, 3.0, 3.3, 4.0, 4.7, 5.5, 6.0]
    near_pi = [float(pi) + x for x in (-1e-3, -1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6, 1e-3)]
    near_2pi = [float(2 * pi) - x for x in (1e-1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15)]
    return tiny + middle + near_pi + near_2pi


def specimens():
    for angle in angles():
        for axis in AXES:
            yield doubles(mpf(angle) * x / norm(exact(axis)) for x in axis)


def quaternions():
    """Roundings of exp at the specimens, and those next to -1 that no rounded angle reaches."""
    for phi in specimens():
        yield doubles(exp(exact(phi)))
    for sine in (1e-12, 1e-17, 1e-100, 1e-300):
        for axis in AXES:
            v = doubles(mpf(sine) * x / norm(exact(axis)) for x in axis)
            yield [-1.0, *v]


def functions_table():
    out = ORIGIN + ("# exp: (x,y,z) is a rotation vector [rad], the result a quaternion. log: the inverse, of a quaternion whose norm is 1\n"
                    "# within rounding. pow: q^s. Fields that a function has not are empty.\n"
                    "function,w,x,y,z,s,result_w,result_x,result_y,result_z\n")
    for phi in specimens():
        out += line("exp", "", *phi, "", *doubles(exp(exact(phi))))
    for q in quaternions():
        out += line("log", *q, "", "", *doubles(log(exact(q))))
    for i, q in enumerate(quaternions()):
        s = FACTORS[i % len(FACTORS)]
        out += line("pow", *q, s, *doubles(exp([mpf(s) * x for x in log(exact(q))])))
    return out


def jets_table():
    """exp along a cubic curve of rotation vectors: Taylor coefficients 0 to 3 of both, either side of every threshold."""
    header = [f"{name}{k}" for k in range(4) for name in ("px", "py", "pz")]
    header += [f"{name}{k}" for k in range(4) for name in ("qw", "qx", "qy", "qz")]
    out = ORIGIN + "# The rotation vector p0 + p1 t + p2 t^2 + p3 t^3 [rad] and the quaternion exp of it, to order 3.\n"
    out += ",".join(header) + "\n"
    rates = [(0.7, -0.4, 0.9), (-0.3, 0.8, 0.25), (0.5, 0.125, -0.6)]
    for angle in (0.0, 1e-300, 1e-12, 1e-8, 1e-4, 1e-2, 0.5, 1.0, 1.43, 1.46, 1.9, 1.999, 2.001, 2.1, 3.0, 3.2, 3.99, 4.01, 4.5, 5.5):
        for axis in AXES[2:4]:
            p0 = doubles(mpf(angle) * x / norm(exact(axis)) for x in axis)
            coefficients = [exact(p0)] + [exact(r) for r in rates]

            def component(k):
                return lambda t: exp([sum(c[j] * t**n for n, c in enumerate(coefficients)) for j in range(3)])[k]

            results = [taylor(component(k), 0, 3) for k in range(4)]
            out += line(*[float(x) for c in coefficients for x in c], *[float(results[k][n]) for n in range(4) for k in range(4)])
    return out


def power_series(coefficients):
    """Taylor coefficients 0 to 3 at x of a power series."""
    def at(x):
        return [sum(c * mp.binomial(k, m) * x**(k - m) for k, c in enumerate(coefficients) if k >= m) for m in range(4)]
    return at


def series_table():
    n = 60
    entire = {"cos_sqrt": power_series([(-1)**k / factorial(2 * k) for k in range(n)]),
              "sinc_sqrt": power_series([(-1)**k / factorial(2 * k + 1) for k in range(n)]),
              "versine_ratio": power_series([(-1)**k / factorial(2 * k + 2) for k in range(n)]),
              "sine_defect_ratio": power_series([(-1)**k / factorial(2 * k + 3) for k in range(n)])}
    defect = power_series([abs(bernoulli(2 * k + 2)) / factorial(2 * k + 2) for k in range(n)])
    closed = lambda x: (1 - sqrt(x) / 2 * cot(sqrt(x) / 2)) / x  # noqa: E731
    entire["cotangent_defect_ratio"] = lambda x: defect(x) if x < 0.5 else taylor(closed, x, 3)
    below = float.fromhex("0x1.fffffffffffffp-1")
    points = [0.0, 1e-300, 1e-20, 1e-8, 1e-3, 0.1, 0.5, 0.9, 0.999, below, 1.0, 1.001, 1.1, 2.0, 3.9, 4 * below, 4.0,
              4.1, 9.0, 16 * below, 16.0, 20.0, 35.0]
    out = ORIGIN + "# Functions of x = (angle [rad])^2 with their Taylor coefficients: c_k is the k-th derivative over k!.\n"
    out += "function,x,c0,c1,c2,c3\n"
    for name, function in entire.items():
        for x in points:
            out += line(name, x, *doubles(function(mpf(x))))
    return out


if __name__ == "__main__":
    (FOLDER / "so3.csv").write_text(functions_table())
    (FOLDER / "so3_jets.csv").write_text(jets_table())
    (FOLDER / "so3_series.csv").write_text(series_table())
