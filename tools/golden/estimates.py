# SPDX-License-Identifier: Apache-2.0
"""Means with their spread, and the standard deviations of smoothing, with many digits by mpmath.

Nothing of the library's own way is in them: derivatives are differences in so many digits.
"""
import random

from golden.exact import conjugate, norm, product, rows_of, unit
from mpmath import acos, atan2, cos, eye, inverse, lu_solve, matrix, mp, mpf, nstr, sin, sqrt, zeros

mp.dps = 120
STEP = mpf(10) ** -20


def turn(v):
    angle = sqrt(sum(x * x for x in v))
    return [mpf(1), *(x / 2 for x in v)] if angle == 0 else [cos(angle / 2), *(x / angle * sin(angle / 2) for x in v)]


# ---------------------------------------------------------------- means and medians

KINDS = ("mean", "median")


class Orientations:
    @staticmethod
    def point(numbers):
        return unit([mpf(x) for x in numbers])

    @staticmethod
    def moved(q, v):
        return product(q, turn(v))

    @staticmethod
    def distance(q, p):
        return 2 * acos(min(abs(sum(a * b for a, b in zip(q, p))), mpf(1)))


class Positions:
    @staticmethod
    def point(numbers):
        return [mpf(x) for x in numbers]

    @staticmethod
    def moved(p, v):
        return [a + b for a, b in zip(p, v)]

    @staticmethod
    def distance(p, q):
        return norm([a - b for a, b in zip(p, q)])


def signed(points, space):
    """With the signs of the first one, where they do not count."""
    if space is Positions:
        return points
    return [p if sum(a * b for a, b in zip(p, points[0])) > 0 else [-x for x in p] for p in points]


def cost(kind, distance):
    return distance ** 2 / 2 if kind == "mean" else distance


def axis(i, step=STEP):
    return [step if i == j else mpf(0) for j in range(3)]


def gradient(function):
    return matrix([(function(axis(i)) - function(axis(i, -STEP))) / (2 * STEP) for i in range(3)])


def hessian(function):
    found = zeros(3, 3)
    for i in range(3):
        for j in range(3):
            def at(a, b):
                return function([x + y for x, y in zip(axis(i, a * STEP), axis(j, b * STEP))])
            found[i, j] = (at(1, 1) - at(1, -1) - at(-1, 1) + at(-1, -1)) / (4 * STEP ** 2)
    return found


def least_sum(space, kind, points, weights, start):
    """The point of the least sum, by Newton's method on differences; a step is halved until the sum falls."""
    q = start

    def sum_at(v):
        there = space.moved(q, v)
        return sum(w * cost(kind, space.distance(there, p)) for w, p in zip(weights, points))

    for _ in range(200):
        g = gradient(sum_at)
        if sqrt(sum(x * x for x in g)) < mpf(10) ** -27:
            return q, hessian(sum_at)
        step = list(lu_solve(hessian(sum_at), -g))
        if sum(x * y for x, y in zip(step, g)) > 0:
            step = [-x for x in g]
        while sum_at(step) >= sum_at([0, 0, 0]):
            step = [x / 2 for x in step]
        q = space.moved(q, step)
    raise ArithmeticError(f"no rest: {kind}, {space.__name__}, {nstr(sum_at([0, 0, 0]), 5)}")


def covariances(space, kind, points, weights, q, curvature):
    """Of one sample and of the middle: sums of squares of the gradients of each sample, which are differences."""
    count = 1 / sum(w * w for w in weights)
    spread, scores = zeros(3, 3), zeros(3, 3)
    for w, p in zip(weights, points):
        way = -gradient(lambda v: cost("mean", space.distance(space.moved(q, v), p)))
        score = gradient(lambda v: cost(kind, space.distance(space.moved(q, v), p)))
        spread += w * way * way.T
        scores += w * score * score.T
    inner = inverse(curvature)
    return spread * count / (count - 1), inner * scores * inner / (count - 1)


def six(m):
    return [m[0, 0], m[1, 1], m[2, 2], m[0, 1], m[0, 2], m[1, 2]]


def samples_of(name, count, spread, weighted):
    """Rows of decimals: weights, quaternions round one of any direction, of either sign and near norm 1, positions."""
    source = random.Random(name)
    base = unit([mpf(source.gauss(0, 1)) for _ in range(4)])
    for _ in range(count):
        q = product(base, turn([mpf(source.gauss(0, spread)) for _ in range(3)]))
        sign = source.choice((-1, 1))
        numbers = [nstr(sign * x, 17) for x in q]
        position = [f"{source.gauss(3, 1):.6f}" for _ in range(3)]
        yield [str(source.randint(4, 9)) if weighted else "1", *numbers, *position]


def mean(_):
    """Means and medians of orientations and positions, with 120 digits.

    An angle is 2 acos |p·q|, gradients and Hessians of the sums are differences in 120 digits, and Newton's method goes on until they
    are 0.
    """
    mp.dps = 120
    cases = {"near": samples_of("near", 7, 0.02, False), "wide": samples_of("wide", 9, 0.45, False),
             "weights": samples_of("weights", 8, 0.3, True), "tight": samples_of("tight", 6, 1e-6, True)}
    samples = ["case,weight,qw,qx,qy,qz,px,py,pz"]
    found = ["case,kind,qw,qx,qy,qz,rms_distance,largest_distance,spread,covariance,px,py,pz,position_spread,position_covariance"]
    for name, rows in cases.items():
        rows = list(rows)
        samples += [",".join([name, *row]) for row in rows]
        numbers = [[float(x) for x in row] for row in rows]
        weights = [mpf(row[0]) for row in numbers]
        weights = [w / sum(weights) for w in weights]
        for kind in KINDS:
            cells = [name, kind]
            for space, columns in ((Orientations, slice(1, 5)), (Positions, slice(5, 8))):
                points = [space.point(row[columns]) for row in numbers]
                start = [sum(w * x for w, x in zip(weights, column)) for column in zip(*signed(points, space))]
                q, curvature = least_sum(space, kind, points, weights, unit(start) if space is Orientations else start)
                distances = [space.distance(q, p) for p in points]
                spread, covariance = covariances(space, kind, points, weights, q, curvature)
                q = [x if space is Positions or q[0] > 0 else -x for x in q]
                cells += [nstr(x, 20) for x in q]
                if space is Orientations:
                    cells += [nstr(sqrt(sum(w * d * d for w, d in zip(weights, distances))), 20), nstr(max(distances), 20)]
                cells += [" ".join(nstr(x, 20) for x in six(m)) for m in (spread, covariance)]
            found.append(",".join(cells))
    head = "# Made by tools/make_mean_golden.py with 120 digits.\n"
    return {"tests/data/golden/mean_samples.csv": head + "\n".join(samples) + "\n",
            "tests/data/golden/mean_cases.csv": head + "\n".join(found) + "\n"}


# ---------------------------------------------------------------- standard deviations of smoothing

NAMES = "sigma_x,sigma_y,sigma_z,sigma_wx,sigma_wy,sigma_wz"


def numbers(row, *names):
    return [mpf(float(row[name])) for name in names]


def rotation_vector(q):
    if q[0] < 0:
        q = [-x for x in q]
    length = norm(q[1:])
    return [x * (2 * atan2(length, q[0]) / length if length else mpf(2)) for x in q[1:]]


def cross(v):
    return matrix([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])


def right_jacobian(v):
    angle = norm(v)
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
    states = [(unit(q), rates) for q, rates in states]
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


def sigma(_):
    """Standard deviations of smoothed nodes from the inverse of the whole normal matrix, with 60 digits.

    Reads smooth_cases.csv and smooth_nodes.csv. The penalty is summed at Gauss points of the interpolating polynomial instead of by
    moments, and rates come from Jr(y) dy itself.
    """
    mp.dps = 60
    lines = ["# One standard deviation along the axes of the body [rad], [rad/s]: the inverse of the whole normal matrix.", f"case,node,{NAMES}"]
    all_nodes = rows_of("smooth_nodes.csv")
    for case in rows_of("smooth_cases.csv"):
        nodes = [row for row in all_nodes if row["case"] == case["case"]]
        total, m = normal_matrix(case, nodes)
        covariance = inverse(total)
        for i in range(len(nodes)):
            sigmas = [float(sqrt(covariance[m * i + k, m * i + k])) for k in range(6)]
            lines.append(f"{case['case']},{i}," + ",".join(map(repr, sigmas)))
    return {"tests/data/golden/smooth_sigmas.csv": "\n".join(lines) + "\n"}
