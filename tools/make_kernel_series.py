#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Prints the coefficients of src/orispline/batch/kernel/trigonometry.hpp. Needs mpmath; nothing else of the project does.

Each function of u is interpolated at Chebyshev nodes of its range with 60 digits; the error in the range is printed beside it.
"""
import mpmath
from mpmath import mpf

mpmath.mp.dps = 60


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


def main():
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


if __name__ == "__main__":
    main()
