# SPDX-License-Identifier: Apache-2.0
"""Vectors and quaternions (w, x, y, z) in which only +, -, *, / and square roots touch the numbers: no libm, so that
every machine computes the same bits."""

import math

PI = math.pi
DEGREE = PI / 180.0


def sine(x):
    """sin x by its Taylor series about the nearest multiple of π."""
    turns = math.floor(x / PI + 0.5)
    x -= turns * PI
    term = total = x
    for k in range(1, 12):
        term *= -x * x / (2 * k * (2 * k + 1))
        total += term
    return -total if turns % 2 else total


def cosine(x):
    return sine(x + PI / 2)


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def norm(v):
    return math.sqrt(sum(x * x for x in v))


def unit(v):
    length = norm(v)
    return tuple(x / length for x in v)


def times(p, q):
    (a, b, c, d), (w, x, y, z) = p, q
    return (a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w)


def conjugate(q):
    return (q[0], -q[1], -q[2], -q[3])


def turn(axis, angle):
    """Rotation by an angle [rad] about a unit axis."""
    s = sine(angle / 2)
    return (cosine(angle / 2), axis[0] * s, axis[1] * s, axis[2] * s)


def to_world(q, v):
    t = cross(q[1:], v)
    u = cross(q[1:], t)
    return tuple(v[i] + 2 * (q[0] * t[i] + u[i]) for i in range(3))


def to_body(q, v):
    return to_world(conjugate(q), v)


X, Y, Z = (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)


def ease(x):
    """0 before 0, 1 after 1, C2 between; with its derivative."""
    if x <= 0 or x >= 1:
        return (0.0 if x <= 0 else 1.0), 0.0
    return x * x * x * (10 + x * (6 * x - 15)), 30 * x * x * (1 - x) * (1 - x)
