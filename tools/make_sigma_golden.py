#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Standard deviations of smoothed nodes from the inverse of the whole normal matrix, with 60 digits by mpmath.

Reads tests/data/golden/smooth_cases.csv and smooth_nodes.csv and writes smooth_sigmas.csv beside them. Nothing of the
library's own way is in it: the penalty is summed at Gauss points of the interpolating polynomial instead of by moments,
rates come from Jr(y) dy itself, and derivatives are differences in 60 digits.

    tools/make_sigma_golden.py [--check]
"""
import csv
import pathlib
import sys

from mpmath import atan2, cos, eye, inverse, matrix, mp, mpf, sin, sqrt, zeros

ROOT = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "golden"
NAMES = "sigma_x,sigma_y,sigma_z,sigma_wx,sigma_wy,sigma_wz"
mp.dps = 60
STEP = mpf(10) ** -20


def rows_of(name):
    with open(ROOT / name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def numbers(row, *names):
    return [mpf(float(row[name])) for name in names]


def product(a, b):
    w, x, y, z = a
    s, i, j, k = b
    return [w * s - x * i - y * j - z * k, w * i + x * s + y * k - z * j, w * j - x * k + y * s + z * i,
            w * k + x * j - y * i + z * s]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def turn(v):
    angle = sqrt(sum(x * x for x in v))
    return [mpf(1), *(x / 2 for x in v)] if angle == 0 else [cos(angle / 2), *(x / angle * sin(angle / 2) for x in v)]


def rotation_vector(q):
    if q[0] < 0:
        q = [-x for x in q]
    length = sqrt(sum(x * x for x in q[1:]))
    return [x * (2 * atan2(length, q[0]) / length if length else mpf(2)) for x in q[1:]]


def cross(v):
    return matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def right_jacobian(v):
    angle = sqrt(sum(x * x for x in v))
    if angle < mpf(10) ** -15:
        return eye(3) - cross(v) / 2 + cross(v) ** 2 / 6
    return eye(3) - cross(v) * ((1 - cos(angle)) / angle**2) + cross(v) ** 2 * ((angle - sin(angle)) / angle**3)


def chart_rates(y, rates, order):
    """Derivatives of the rotation vector y that give the body rates ω [and α]."""
    jacobian = right_jacobian(y)
    first = inverse(jacobian) * matrix(rates[:3])
    if order == 2:
        return [first]
    moved = [right_jacobian([y[k] + sign * STEP * first[k] for k in range(3)]) for sign in (1, -1)]
    change = (moved[0] - moved[1]) / (2 * STEP)
    return [first, inverse(jacobian) * (matrix(rates[3:]) - change * first)]


def falling(n, k):
    result = mpf(1)
    for i in range(k):
        result *= n - i
    return result


def roots_of_legendre(order):
    return [(-1 / sqrt(mpf(3)), mpf(1)), (1 / sqrt(mpf(3)), mpf(1))] if order == 2 else \
        [(-sqrt(mpf(3) / 5), mpf(5) / 9), (mpf(0), mpf(8) / 9), (sqrt(mpf(3) / 5), mpf(5) / 9)]


def polynomial_rows(order, h):
    """From the value and derivatives at both ends to √weight times the derivative of that order at Gauss points."""
    n = 2 * order
    ends = matrix([[falling(j, k) * u ** max(j - k, 0) if j >= k else 0 for j in range(n)] for u in (mpf(0), h) for k in range(order)])
    high = matrix([[sqrt(w * h / 2) * falling(j, order) * (h * (1 + x) / 2) ** (j - order) if j >= order else 0 for j in range(n)]
                   for x, w in roots_of_legendre(order)])
    return high * inverse(ends)


def segment_residual(before, after, order, rows):
    """Of two nodes (quaternion, rates)."""
    step = rotation_vector(product(conjugate(before[0]), after[0]))
    values = []
    for sign, (_, rates) in ((-1, before), (1, after)):
        y = [sign * x / 2 for x in step]
        values += [matrix(y), *chart_rates(y, rates, order)]
    return [sum(rows[r, c] * values[c][k] for c in range(2 * order)) for r in range(order) for k in range(3)]


def moved(node, column, size):
    q, rates = node
    if column < 3:
        return product(q, turn([size if k == column else mpf(0) for k in range(3)])), rates
    return q, [x + (size if k == column - 3 else 0) for k, x in enumerate(rates)]


def normal_matrix(case, nodes):
    order, strength, bias = int(case["order"]), mpf(float(case["lambda"])), case["bias"] == "1"
    m, n = 3 * order, len(nodes)
    states = [(numbers(row, "found_qw", "found_qx", "found_qy", "found_qz"), numbers(row, *("wx", "wy", "wz", "ax", "ay", "az")[:m - 3]))
              for row in nodes]
    states = [([x / sqrt(sum(y * y for y in q)) for x in q], rates) for q, rates in states]
    size = m * n + (3 if bias else 0)
    total = zeros(size, size)
    for i, row in enumerate(nodes):
        weight, gyro_weight, threshold = *numbers(row, "weight", "gyro_weight"), mpf(float(case["threshold"]))
        sample = numbers(row, "qw", "qx", "qy", "qz")
        square = weight * sum(x * x for x in rotation_vector(product(conjugate(states[i][0]), sample)))
        if case["loss"] == "tukey":
            weight *= max(mpf(0), 1 - square / threshold**2) ** 2
        for k in range(3):
            total[m * i + k, m * i + k] += weight
            total[m * i + 3 + k, m * i + 3 + k] += gyro_weight
            if bias:
                total[m * n + k, m * n + k] += gyro_weight
                total[m * n + k, m * i + 3 + k] -= gyro_weight
                total[m * i + 3 + k, m * n + k] -= gyro_weight
    for i in range(n - 1):
        rows = polynomial_rows(order, mpf(float(nodes[i + 1]["t"])) - mpf(float(nodes[i]["t"])))
        jacobian = zeros(m, 2 * m)
        for column in range(2 * m):
            pairs = [[moved(states[i], column, s * STEP), states[i + 1]] if column < m else
                     [states[i], moved(states[i + 1], column - m, s * STEP)] for s in (1, -1)]
            there, back = (segment_residual(*pair, order, rows) for pair in pairs)
            for r in range(m):
                jacobian[r, column] = (there[r] - back[r]) / (2 * STEP)
        block = jacobian.T * jacobian * strength
        for a in range(2 * m):
            for b in range(2 * m):
                total[m * i + a, m * i + b] += block[a, b]
    return total, m


def table():
    yield "# One standard deviation along the axes of the body [rad], [rad/s]: the inverse of the whole normal matrix."
    yield f"case,node,{NAMES}"
    all_nodes = rows_of("smooth_nodes.csv")
    for case in rows_of("smooth_cases.csv"):
        nodes = [row for row in all_nodes if row["case"] == case["case"]]
        total, m = normal_matrix(case, nodes)
        covariance = inverse(total)
        for i in range(len(nodes)):
            sigmas = [float(sqrt(covariance[m * i + k, m * i + k])) for k in range(6)]
            yield f"{case['case']},{i}," + ",".join(map(repr, sigmas))


def main():
    text = "\n".join(table()) + "\n"
    path = ROOT / "smooth_sigmas.csv"
    if "--check" not in sys.argv[1:]:
        path.write_text(text, "utf-8")
    elif path.read_text("utf-8") != text:
        sys.exit(f"{path} is not what this gives")


main()
