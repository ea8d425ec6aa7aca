# SPDX-License-Identifier: Apache-2.0
"""Functions of rotations and elementary ones with 60 digits by mpmath: tables for tests, and the constants that the library computes with."""
import math
import random

import mpmath
from golden.exact import norm
from mpmath import atan, atan2, atanh, bernoulli, cos, cot, coth, exp, factorial, floor, frexp, ldexp, log, lu_solve, matrix, mp, mpf, pi, polyval
from mpmath import sin, sqrt, taylor

mp.dps = 60

# ---------------------------------------------------------------- exp and log of rotations

ORIGIN = f"# Made by tools/make_so3_data.py (mpmath, {mp.dps} digits): doubles nearest to the true values of exact input.\n"
AXES = [(1, 0, 0), (0, 0, -1), (1, 2, -2), (-3, 4, 12), (0.6, -0.7, 0.1)]
FACTORS = [0.0, 0.25, 0.5, 1.0, 1.75, -1.0, -0.3]


def turn(phi):
    angle = norm(phi) / 2
    s = sin(angle) / angle / 2 if angle else mpf(1) / 2
    return [cos(angle)] + [s * x for x in phi]


def rotation_vector(q):
    s = norm(q[1:])
    return [2 * atan2(s, q[0]) * x / s if s else mpf(0) for x in q[1:]]


def doubles(values):
    return [float(x) for x in values]


def exact(values):
    return [mpf(x) for x in values]


def line(*fields):
    return ",".join(f if isinstance(f, str) else repr(f) for f in fields) + "\n"


def turn_angles():
    tiny = [1e-300, 1e-200, 1e-154, 1e-100, 1e-20, 1e-16, 1e-12, 1e-9, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2]
    middle = [0.1, 0.5, 1.0, 1.4, 1.4454, 1.4455, 1.5, 1.99, 2.0, 2.01, 2.5, 3.0, 3.3, 4.0, 4.7, 5.5, 6.0]
    near_pi = [float(pi) + x for x in (-1e-3, -1e-6, -1e-9, -1e-12, 0.0, 1e-12, 1e-9, 1e-6, 1e-3)]
    near_2pi = [float(2 * pi) - x for x in (1e-1, 1e-2, 1e-4, 1e-6, 1e-9, 1e-12, 1e-15)]
    return tiny + middle + near_pi + near_2pi


def specimens():
    for angle in turn_angles():
        for axis in AXES:
            yield doubles(mpf(angle) * x / norm(exact(axis)) for x in axis)


def quaternions():
    """Roundings of exp at the specimens, and those next to -1 that no rounded angle reaches."""
    for phi in specimens():
        yield doubles(turn(exact(phi)))
    for sine in (1e-12, 1e-17, 1e-100, 1e-300):
        for axis in AXES:
            v = doubles(mpf(sine) * x / norm(exact(axis)) for x in axis)
            yield [-1.0, *v]


def functions_table():
    out = ORIGIN + ("# exp: (x,y,z) is a rotation vector [rad], the result a quaternion. log: the inverse, of a quaternion whose norm is 1\n"
                    "# within rounding. pow: q^s. Fields that a function has not are empty.\n"
                    "function,w,x,y,z,s,result_w,result_x,result_y,result_z\n")
    for phi in specimens():
        out += line("exp", "", *phi, "", *doubles(turn(exact(phi))))
    for q in quaternions():
        out += line("log", *q, "", "", *doubles(rotation_vector(exact(q))))
    for i, q in enumerate(quaternions()):
        s = FACTORS[i % len(FACTORS)]
        out += line("pow", *q, s, *doubles(turn([mpf(s) * x for x in rotation_vector(exact(q))])))
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
                return lambda t: turn([sum(c[j] * t**n for n, c in enumerate(coefficients)) for j in range(3)])[k]

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


def so3(_):
    """The tables of functions of SO(3) that the tests of math read.

    Every number is the double nearest to a value computed with 60 digits from exact double input.
    """
    mp.dps = 60
    return {"tests/data/so3.csv": functions_table(), "tests/data/so3_jets.csv": jets_table(), "tests/data/so3_series.csv": series_table()}


# ---------------------------------------------------------------- elementary functions

SEED = 20240229
REDUCTION_BITS, REDUCTION_BOUND = 33, 1000.0  # bits of each part of π/2; the angle up to which they serve [rad]
PRODUCT_WORDS, TOP_EXPONENT, LEADING_ZEROS = 6, 971, 64  # the exact reduction: see elementary.cpp
ARCTANGENT_STEPS = 32


def remez(f, weight, top, count):
    """Coefficients of the polynomial P, degree count - 1, with the least largest weight·|f - P| on (0, top]."""
    mesh = [top * (1 - cos(pi * k / 1500)) / 2 for k in range(1, 1501)]
    points = [top * (1 - cos(pi * (2 * k + 1) / (2 * count + 2))) / 2 for k in range(count + 1)]
    for _ in range(12):
        a = matrix(count + 1, count + 1)
        for i, z in enumerate(points):
            for k in range(count):
                a[i, k] = z**k
            a[i, count] = (-1) ** i / weight(z)
        p = lu_solve(a, matrix([f(z) for z in points]))
        error = [weight(z) * (f(z) - polyval([p[k] for k in reversed(range(count))], z)) for z in mesh]
        runs = [[0]]
        for i in range(1, len(mesh)):
            if error[i] * error[i - 1] < 0:
                runs.append([])
            runs[-1].append(i)
        points = [mesh[max(run, key=lambda i: abs(error[i]))] for run in runs][: count + 1]
    print(f"  relative error 2^{float(log(max(abs(e) for e in error), 2)):.1f} with {count} coefficients")
    return [p[k] for k in range(count)]


def bits_below(x, count):
    """x cut to `count` bits."""
    _, exponent = frexp(x)
    return ldexp(floor(ldexp(x, count - exponent)), exponent - count)


def parts(x, bits):
    found = []
    for count in bits:
        found.append(bits_below(x, count) if count < 53 else mpf(float(x)))
        x -= found[-1]
    return found


def half_pi_parts():
    """Each part on its own grid of REDUCTION_BITS bits, the last one rounded."""
    rest, found = pi / 2, []
    for part in range(1, 3):
        grid = mpf(2) ** (1 - part * REDUCTION_BITS)
        found.append(floor(rest / grid) * grid)
        rest -= found[-1]
    return found + [rest]


def table(comment, name, values, kind="double"):
    text = [v if isinstance(v, str) else float(v).hex() for v in values]
    lines, line = [], " "
    for field in text:
        if len(line) + len(field) > 116:
            lines.append(line)
            line = " "
        line += f" {field},"
    body = "\n".join([*lines, line])
    return f"/// {comment}\ninline constexpr std::array<{kind}, {len(text)}> {name}{{\n{body}\n}};\n\n"


def pairs(comment, name, first, second):
    rows = [f"  {{{float(a).hex()}, {float(b).hex()}}}," for a, b in zip(first, second)]
    head = f"/// {comment}\ninline constexpr double {name}[{len(rows)}][2]{{\n"
    return head + "\n".join(rows) + "\n};\n\n"


def constants():
    octant = (pi / 4 + mpf(2) ** -20) ** 2
    root = sqrt
    sine = remez(lambda z: (sin(root(z)) / root(z) - 1) / z, lambda z: z / (sin(root(z)) / root(z)), octant, 6)
    cosine = remez(lambda z: (cos(root(z)) - 1 + z / 2) / z**2, lambda z: z**2 / cos(root(z)), octant, 6)
    nearest = mpf(2) / ARCTANGENT_STEPS
    arctangent = remez(lambda z: (atan(root(z)) / root(z) - 1) / z, lambda z: z, nearest**2, 5)
    third = (sqrt(2) - 1) / (sqrt(2) + 1)
    logarithm = remez(lambda z: 2 * (atanh(root(z)) / root(z) - 1) / z, lambda z: z / 2, third**2, 7)
    exponential = remez(lambda z: (root(z) * coth(root(z) / 2) - 2) / z, lambda z: z * root(z) / 2,
                        (log(2) / 2 + mpf(2) ** -20) ** 2, 5)
    steps = [atan(mpf(i) / ARCTANGENT_STEPS) for i in range(ARCTANGENT_STEPS + 1)]
    size = (LEADING_ZEROS + TOP_EXPONENT) // 32 + PRODUCT_WORDS + 1
    mp.dps = 420
    whole = int(floor(ldexp(2 / pi, 32 * size - LEADING_ZEROS)))
    mp.dps = 60
    words = [f"0x{whole >> 32 * (size - 1 - i) & 0xFFFFFFFF:08x}" for i in range(size)]
    return (
        "// SPDX-License-Identifier: Apache-2.0\n#pragma once\n\n#include <array>\n#include <cstdint>\n\n#include <orispline/base/abi.hpp>\n\n"
        "// Made by tools/make_golden.py elementary (mpmath, 60 digits): change that, not this.\n\n"
        "namespace orispline { inline namespace ORISPLINE_ABI { namespace elementary {\n\n// clang-format off\n"
        + pairs("Of sin r = r + r³ P(r²) and cos r = 1 - r²/2 + r⁴ Q(r²), |r| ≤ π/4: P and Q side by side.",
                "sine_cosine_terms", sine, cosine)
        + table("atan t = t + t³ P(t²), |t| ≤ 1/16.", "arctangent_terms", arctangent)
        + table("2 atanh s = 2 s + s³ P(s²), |s| ≤ (√2 - 1)/(√2 + 1).", "logarithm_terms", logarithm)
        + table("r coth(r/2) = 2 + r² P(r²), |r| ≤ ln(2)/2.", "exponential_terms", exponential)
        + table(f"π/2 in two parts of {REDUCTION_BITS} bits and a rest.", "half_pi_parts", half_pi_parts())
        + table("π/2 as the nearest double and the rest.", "half_pi", parts(pi / 2, [53, 53]))
        + table("π as the nearest double and the rest.", "whole_pi", parts(pi, [53, 53]))
        + table("ln 2 in a part of 41 bits and a rest.", "log_of_two", parts(log(2), [41, 53]))
        + table(f"atan(i/{ARCTANGENT_STEPS}) as the nearest double.", "arctangents", [float(a) for a in steps])
        + table("What is missing there.", "arctangent_rests", [float(a - float(a)) for a in steps])
        + table(f"Bits of 2/π, {LEADING_ZEROS} zeros before the point.", "two_over_pi", words, "std::uint32_t")
        + "// clang-format on\n}}}  // namespace orispline::elementary\n")


def beside(x, steps=2):
    """x and its neighbours among the doubles."""
    around = [float(x)]
    for end in (-math.inf, math.inf):
        y = float(x)
        for _ in range(steps):
            y = math.nextafter(y, end)
            around.append(y)
    return around


def nearest_to_zeros():
    """In every binade the double that is nearest to a multiple of π/2, by the continued fraction of their quotient."""
    for exponent in range(-52, TOP_EXPONENT, 7):
        mp.dps = 420
        quotient = ldexp(2 / pi, exponent)  # |m·quotient - k| small, m below 2^53
        numerator, before, x = 1, 0, quotient - floor(quotient)
        while numerator * (1 / x) < 2**53:
            numerator, before = int(floor(1 / x)) * numerator + before, numerator
            x = 1 / x - floor(1 / x)
        mp.dps = 60
        yield math.ldexp(numerator, exponent)


def angles(dice):
    yield from nearest_to_zeros()
    yield from (float(k * pi / 2) for k in range(1, 640) if abs(mpf(float(k * pi / 2)) - k * pi / 2) < mpf(2) ** -56)
    for k in [*range(1, 17), *(2**j + 1 for j in range(5, 19)), 509000, 509295, 600001, 2**40 + 1]:
        yield from beside(k * pi / 2, 1)
        yield from beside((k - 0.5) * pi / 2, 1)
    for x in (2.0**-27, REDUCTION_BOUND, 1e5, 8e5, pi / 4, 5e-324, 2.0**-1022, math.nextafter(math.inf, 0.0)):
        yield from (y for y in beside(x) if y < math.inf)
    yield from (10.0**k for k in range(-308, 309, 8))
    yield from (dice.uniform(0, math.pi) for _ in range(250))
    yield from (math.exp(dice.uniform(math.log(1e-9), math.log(1e6))) for _ in range(250))
    yield from (math.ldexp(dice.uniform(0.5, 1), dice.randrange(20, 1025)) for _ in range(100))


def quotients(dice):
    """Pairs y, x."""
    for i in range(0, ARCTANGENT_STEPS + 1):
        for q in {i / ARCTANGENT_STEPS, (i + 0.5) / ARCTANGENT_STEPS}:
            x = dice.uniform(0.5, 2)
            yield from ((y, x) for y in beside(q * x, 1) if y > 0)
    for scale in (2.0**-1074, 2.0**-1000, 2.0**-801, 2.0**-799, 1.0, 2.0**899, 2.0**901, 2.0**1023):
        for _ in range(6):
            yield dice.uniform(0, 1) * scale, dice.uniform(0.5, 1) * scale
    for exponent in (-1, -8, -26, -27, -29, -30, -31, -53, -54, -60, -500, -1000, -1060):
        for _ in range(6):
            yield math.ldexp(dice.uniform(0.5, 1), exponent), dice.uniform(0.5, 1)
    yield from ((1e-300, 1e10), (5e-324, 1.0), (5e-324, 1.5e308), (3e-310, 0.75), (5e-324, 5e-324), (1e-5, 1e-320))
    yield from ((dice.uniform(0, 1 / 16), 1 - dice.uniform(0, 0.5)) for _ in range(120))
    yield from ((dice.uniform(0, 1), dice.uniform(0, 1)) for _ in range(200))


def octants(dice, pairs):
    for y, x in pairs:
        y, x = (y, x) if dice.random() < 0.5 else (x, y)
        yield y * dice.choice([1, -1]), x * dice.choice([1, -1])


def positives(dice):
    for x in (0.5, 1.0, 2.0, 10.0, 2.0**-1022, 2.0**1023, math.e, sqrt(2), sqrt(0.5), 5.0, 15.0, 1 - 2.0**-20, 1 + 2.0**-20):
        yield from beside(x)
    yield from (5e-324, 1e-320, 1e-310, math.nextafter(math.inf, 0.0))
    yield from (1 + dice.choice([1, -1]) * 2.0**-k * dice.uniform(0.5, 1) for k in range(1, 53))
    yield from (dice.uniform(0.5, 2) for _ in range(150))
    yield from (math.exp(dice.uniform(-700, 700)) for _ in range(100))


def exponents(dice):
    for x in (0.0, log(2) / 2, log(2), 700.0, 2.0**-54, 2.0**-30, log(mpf(2) ** -1022), log(mpf(2) ** 1023)):
        yield from beside(x, 1)
        yield from beside(-x, 1)
    yield from (709.782712893384, -708.4, -720.0, -744.44, -745.1332191019411, 1e-300, -5e-324)
    yield from ((k + 0.5) * float(log(2)) for k in range(-40, 41, 3))
    yield from (dice.uniform(-1, 1) for _ in range(150))
    yield from (dice.uniform(-708, 709) for _ in range(150))


def row(name, x, y, value):
    nearest = float(value)
    return f"{name},{x!r},{y!r},{nearest!r},{float(value - nearest)!r}\n"


def true_values():
    dice = random.Random(SEED)
    lines = [f"# Made by tools/make_elementary.py (mpmath, 60 digits, seed {SEED}). The true value is wanted + rest.\n",
             "function,x,y,wanted,rest\n"]
    for x in angles(dice):
        mp.dps = 400
        values = sin(mpf(x)), cos(mpf(x))
        lines += [row("sin", x, 0.0, values[0]), row("cos", x, 0.0, values[1])]
    mp.dps = 60
    lines += [row("atan2", x, y, atan2(mpf(y), mpf(x))) for y, x in octants(dice, quotients(dice))]
    lines += [row("log", x, 0.0, log(mpf(x))) for x in positives(dice)]
    lines += [row("exp", x, 0.0, exp(mpf(x))) for x in exponents(dice)]
    return "".join(lines)


def elementary(_):
    """The constants of sine, cosine, arc tangent, exponential and logarithm, and the table that their tests read.

    The constants: polynomials with the least largest relative error (Remez's exchange), parts of π/2 and ln 2, arc tangents, bits of
    2/π. The table: arguments with their true values, as the nearest double and the rest.
    """
    mp.dps = 60
    return {"src/orispline/math/elementary_tables.hpp": constants(), "tests/data/elementary.csv": true_values()}


# ---------------------------------------------------------------- series of the kernels

def interpolated(function, largest, count):
    nodes = [largest / 2 * (1 + mpmath.cos(mpmath.pi * (2 * k + 1) / (2 * count))) for k in range(count)]
    powers = mpmath.matrix(count, count)
    values = mpmath.matrix(count, 1)
    for row, u in enumerate(nodes):
        for column in range(count):
            powers[row, column] = u**column
        values[row] = function(u)
    return list(mpmath.lu_solve(powers, values))


def series(offset, weight=lambda k: 1):
    """Σ (-1)^k weight(k) u^k / (2k + offset)!"""
    return lambda u: mpmath.nsum(
        lambda k: (-1) ** int(k) * weight(int(k)) * u ** int(k) / mpmath.factorial(2 * int(k) + offset), [0, 40])


def negative(function):
    return lambda u: -function(u)


def arcsine(u):
    """(asin √u / √u - 1) / u"""
    return (mpmath.asin(mpmath.sqrt(u)) / mpmath.sqrt(u) - 1) / u


def show(name, kind, function, largest, count):
    coefficients = interpolated(function, mpf(largest), count)
    grid = mpmath.linspace(mpf(10) ** -9, mpf(largest), 400)
    error = max(abs(mpmath.polyval(coefficients[::-1], u) - function(u)) for u in grid)
    suffix = "f" if kind == "float" else ""
    print(f"{kind} {name}: {{{', '.join(mpmath.nstr(c, 20) + suffix for c in coefficients)}}}  // {mpmath.nstr(error, 3)}")


def kernel(_):
    """Prints the coefficients of src/orispline/batch/kernel/trigonometry.hpp.

    Each function of u is interpolated at Chebyshev nodes of its range with 60 digits; the error in the range is printed beside it.
    """
    mp.dps = 60
    for kind, counts in (("double", ((5, 4), (7, 7))), ("float", ((3, 2), (4, 4)))):
        for name, angle, (cosine, sine) in (("narrow", 0.25, counts[0]), ("wide", 1.0, counts[1])):
            show(f"cos_{name}", kind, negative(series(2)), angle**2, cosine)
            show(f"sin_{name}", kind, negative(series(3)), angle**2, sine)
        count = 10 if kind == "double" else 6
        show("versine", kind, series(2), 4, count)
        show("sine_defect", kind, series(3), 4, count)
        show("versine_slope", kind, negative(series(4, lambda k: k + 1)), 4, count)
        show("sine_defect_slope", kind, negative(series(5, lambda k: k + 1)), 4, count)
        show("versine_curvature", kind, series(6, lambda k: (k + 1) * (k + 2)), 4, count)
        show("arcsine", kind, arcsine, mpmath.sin(mpf(1) / 2) ** 2, 13 if kind == "double" else 6)
        show("sine_defect_curvature", kind, series(7, lambda k: (k + 1) * (k + 2)), 4, count)
    return {}
