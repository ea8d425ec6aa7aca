# SPDX-License-Identifier: Apache-2.0
"""What SciPy finds: Euler angles, the motions of its RotationSpline, monotone angles, and the tensions of least energy."""
import itertools
import sys

import numpy as np
import scipy
from golden.exact import rows_of
from scipy.interpolate import PchipInterpolator
from scipy.optimize import least_squares, root
from scipy.spatial.transform import Rotation, RotationSpline

# ---------------------------------------------------------------- Euler angles

EULER_SEED, PER_ORDER = 20180101, 5


def orders():
    for case in ("XYZ", "xyz"):
        for a, b, c in itertools.product(case, repeat=3):
            if b not in (a, c):
                yield a + b + c


def euler(_):
    """Euler angles and their quaternions in all 24 orders, as SciPy computes them.

    Upper case: about the axes of the body; lower case: about those of the world, which is SciPy's convention too.
    """
    random = np.random.default_rng(EULER_SEED)
    lines = [f"# Made by tools/make_euler_data.py (SciPy {scipy.__version__}, seed {EULER_SEED}): angles [rad] in the order of "
             "their turns.\n", "order,e1,e2,e3,qw,qx,qy,qz\n"]
    for order in orders():
        for _ in range(PER_ORDER):
            x, y, z, w = Rotation.random(random_state=random).as_quat()
            angles = Rotation.from_quat([x, y, z, w]).as_euler(order)
            numbers = [float(number) for number in (*angles, w, x, y, z)]
            lines.append(order + "," + ",".join(map(repr, numbers)) + "\n")
    return {"tests/data/euler.csv": "".join(lines)}


# ---------------------------------------------------------------- PchipInterpolator

PCHIP_SEED, PCHIP_SHARES = 19801984, (0.0, 0.15, 0.5, 0.85)
PCHIP_KEYS = {  # times and angles [rad], no step of half a turn
    "two": ([0.0, 0.4], [0.3, -1.2]),
    "steady": ([0.0, 0.1, 1.1, 1.3, 4.0], [0.0, 0.05, 0.55, 0.65, 2.0]),
    "hold": ([0.0, 1.0, 2.0, 3.0], [0.0, np.radians(0.05), np.radians(90.05), np.radians(91.0)]),
    "rest": ([0.0, 1.0, 1.5, 2.5], [0.2, 1.1, 1.1, 2.9]),
    "back": ([0.0, 0.7, 1.0, 2.0, 2.2], [0.0, 2.5, 1.0, 1.5, -1.0]),
    "end of three times the mean": ([0.0, 1.0, 1.1, 2.0], [0.0, 0.2, -1.5, -2.0]),
    "end at rest": ([0.0, 1.0, 1.1, 2.0], [0.0, 0.1, 2.5, 2.6]),
}


def pchip(_):
    """Angles about one axis by SciPy's PchipInterpolator."""
    random = np.random.default_rng(PCHIP_SEED)
    cases = dict(PCHIP_KEYS)
    for k in range(12):
        count = 3 + k
        cases[f"random {k}"] = (np.cumsum(np.exp(random.uniform(-3, 3, count))), np.cumsum(random.uniform(-3.1, 3.1, count)))
    lines = [f"# Made by tools/make_golden.py pchip (SciPy {scipy.__version__}, seed {PCHIP_SEED}): angles [rad] with their derivatives in\n"
             "# time by PchipInterpolator; at keys those of the segment to the right, at the last one of that to the left.\n",
             "case,is_key,t,angle,rate,acceleration,jerk\n"]
    for name, (times, angles) in cases.items():
        curve = PchipInterpolator(times, angles)
        places = [(t, share == 0) for a, b in itertools.pairwise(times) for share in PCHIP_SHARES for t in [a + share * (b - a)]]
        for t, is_key in [*places, (times[-1], True)]:
            lines.append(",".join([name, str(int(is_key)), repr(float(t)), *(repr(float(curve(t, order))) for order in range(4))]) + "\n")
    return {"tests/data/scipy_pchip.csv": "".join(lines)}


# ---------------------------------------------------------------- RotationSpline

SPLINE_SEED = 20030112
KEYS = 8
EVEN_TIMES = np.arange(KEYS, dtype=float)
UNEVEN_TIMES = np.array([0.0, 0.5, 1.5, 1.75, 3.0, 3.2, 4.4, 6.0])
INSTANTS = np.concatenate([[0.0], (np.arange(13) + 0.5) / 13, [1.0]])  # shares of the time; no inner key
LARGEST_KINK = 1e-11  # of the angular acceleration at a key, relative


class SettledSpline(RotationSpline):
    TOL = 1e-14
    MAX_ITER = 1000


def smooth(times):
    """A tumbling motion sampled at the times."""
    angles = np.stack([0.6 * times, 0.5 * np.sin(0.9 * times), 0.4 * np.cos(0.7 * times)], axis=1)
    return Rotation.from_euler("ZYX", angles)


def walk(random, smallest_step, largest_step):
    """Steps of random size [rad] about random axes."""
    keys = [Rotation.random(random_state=random)]
    for size in np.linspace(smallest_step, largest_step, KEYS - 1):
        axis = random.normal(size=3)
        keys.append(keys[-1] * Rotation.from_rotvec(size * axis / np.linalg.norm(axis)))
    return Rotation.concatenate(keys)


def demand_settled(name, spline, times):
    before, after = (spline(np.nextafter(times[1:-1], side), 2) for side in (-np.inf, np.inf))
    kink = np.abs(after - before).max() / np.abs(after).max()
    if not kink < LARGEST_KINK:
        sys.exit(f"{name}: the angular acceleration jumps by {kink}, wanted less than {LARGEST_KINK}")


def lines(name, times, keys):
    spline = SettledSpline(times, keys)
    demand_settled(name, spline, times)
    for t, (x, y, z, w) in zip(times, keys.as_quat()):
        yield ",".join([name, "key", *(repr(float(number)) for number in (t, w, x, y, z)), *[""] * 6])
    for t in times[0] + (times[-1] - times[0]) * INSTANTS:
        x, y, z, w = spline(t).as_quat()
        numbers = (t, w, x, y, z, *spline(t, 1), *spline(t, 2))
        yield ",".join([name, "motion", *(repr(float(number)) for number in numbers)])


def rotation_spline(_):
    """Three tracks and the motions of SciPy's RotationSpline through them.

    SciPy stops at a change of 1e-9 or after 10 rounds; here it goes on until the rates settle.
    """
    random = np.random.default_rng(SPLINE_SEED)
    tracks = {"smooth": (EVEN_TIMES, smooth(EVEN_TIMES)), "uneven": (UNEVEN_TIMES, walk(random, 0.3, 1.2)),
              "large_steps": (EVEN_TIMES, walk(random, 1.0, 2.5))}
    text = [f"# Made by tools/make_scipy_data.py (SciPy {scipy.__version__}, RotationSpline with TOL "
            f"{SettledSpline.TOL}, seed {SPLINE_SEED}): rates in the body frame [rad/s].",
            "track,kind,t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az"]
    for name, (times, keys) in tracks.items():
        text.extend(lines(name, times, keys))
    return {"tests/data/scipy_rotation_spline.csv": "\n".join(text) + "\n"}


# ---------------------------------------------------------------- the tensions of least energy

HEAD = """# Made by tools/make_tuned_golden.py from the reference's curves, by SciPy's least squares.
# before is the energy with the parameters of the column initial, after the least one: the integral of |alpha|^2 [rad^2/s^3],
# or that of |J alpha + omega x J omega|^2 [N^2 m^2 s] for the principal moments of inertia J.
family,sequence,objective,inertia,free,initial,before,after
"""
SEQUENCES = ("msmooth6", "mrand6", "mnonuni6")
INERTIA = (1.0, 2.0, 2.5)
NODES = 24
SHARES, WEIGHTS = (0.5 * (x + shift) for x, shift in zip(np.polynomial.legendre.leggauss(NODES), (1.0, 0.0), strict=True))


def cases():
    """Family, sequence, objective, the parameters that are free."""
    for family in ("quintic", "sextic", "timed-c2"):
        for sequence in SEQUENCES:
            yield family, sequence, "torque", ("tension", "tension2") if family == "timed-c2" else ("tension",)
    for family, free, sequences in (("nu-exact", ("nu",), SEQUENCES), ("beta-through", ("beta2",), SEQUENCES[:2])):
        for sequence in sequences:
            for objective in ("acceleration", "torque"):
                yield family, sequence, objective, free


def keys_of(sequence, rq):
    rows = [row for row in rows_of("keys.csv") if row["sequence"] == sequence]
    times = [rq.F(float(row["t"])) for row in rows]
    keys = [rq.qunit(tuple(rq.F(float(row[c])) for c in ("qw", "qx", "qy", "qz"))) for row in rows]
    return rq.sign_continuous(keys), times


class Curves:
    """A family's curve through keys as a function of its parameters, {name: one per key}."""

    def __init__(self, family, keys, times, rq, rm):
        self.family, self.keys, self.times, self.rq, self.rm = family, keys, times, rq, rm
        kind = {"quintic": "tan", "sextic": "sextic", "timed-c2": "c2"}.get(family)
        self.tensions = kind and rm.TensionFamily(kind, keys, times)
        self.initial = {"quintic": {"tension": 0.5}, "sextic": {"tension": 1 / 12}, "timed-c2": {"tension": 0.5, "tension2": 1.0},
                        "nu-exact": {"nu": 0.5}}.get(family, {"beta1": 1.0, "beta2": 0.0})

    def may_vary(self, name, key):
        return 0 < key < len(self.keys) - 1 or name not in ("nu", "tension2")

    def segments(self, parameters):
        """Their spans, and the body rates at the nodes (nodes, 3)."""
        rq, rm, n = self.rq, self.rm, len(self.keys)
        values = {name: [rq.F(float(x)) for x in list_] for name, list_ in parameters.items()}
        if self.tensions:
            per_key = list(zip(*(values[name] for name in self.initial), strict=True))
            for i in range(n - 1):
                yield product_rates(*self.tensions.seg(i, per_key[i], per_key[i + 1]))
        elif self.family == "nu-exact":
            keys = np.array([[float(x) for x in q] for q in self.keys])
            steps = np.diff(np.array([float(t) for t in self.times]))
            rates = rates_of(keys, steps, np.array([float(x) for x in values["nu"]]))
            yield from zip(steps, *slerp_segments(keys, steps, rates, SHARES), strict=True)
        else:
            betas = {name: [list_[0], *list_, list_[-1]] for name, list_ in values.items()}
            points = rq.beta_interp_points(self.keys, betas["beta1"], betas["beta2"], tol=rq.mpf("1e-20"))[0]
            for segment in rq.beta_spline(points, betas["beta1"], betas["beta2"], self.times).segs:
                yield product_rates(segment.h, segment.ds, segment.polys)

    def residuals(self, parameters, objective):
        all_ = []
        for h, omega, alpha in self.segments(parameters):
            value = alpha if objective == "acceleration" else INERTIA * alpha + np.cross(omega, INERTIA * omega)
            all_.append(np.sqrt(h * WEIGHTS)[:, None] * value)
        return np.concatenate(all_).ravel()


def product_rates(h, half_increments, polynomials):
    """Of the product of exp(b_k(s) d_k): each factor turns the rates of those before it."""
    h, omega, alpha = float(h), np.zeros((NODES, 3)), np.zeros((NODES, 3))
    for half, coefficients in zip(half_increments, polynomials, strict=True):
        axis, b = 2 * np.array([float(x) for x in half]), np.polynomial.Polynomial([float(c) for c in coefficients])
        back = Rotation.from_rotvec(-b(SHARES)[:, None] * axis)
        first, second = (b.deriv(k)(SHARES)[:, None] / h**k * axis for k in (1, 2))
        omega = back.apply(omega)
        alpha = back.apply(alpha) + np.cross(omega, first) + second
        omega = omega + first
    return h, omega, alpha


def series(*values):
    """Coefficients of 1, x, x² of a number that depends on x, at every node."""
    return np.array(np.broadcast_arrays(*values), dtype=float)


def times(a, b):
    return np.array([a[0] * b[0], a[0] * b[1] + a[1] * b[0], a[0] * b[2] + a[1] * b[1] + a[2] * b[0]])


def of(f, a):
    """f(a) from f, f' and f'' at the value of a."""
    value, first, second = f(a[0])
    return np.array([value, first * a[1], first * a[2] + second * a[1] ** 2 / 2])


def product(p, q):
    """Of quaternions (4, 3, nodes)."""
    w = times(p[0], q[0]) - sum(times(p[i], q[i]) for i in (1, 2, 3))
    v = [times(p[0], q[i]) + times(p[i], q[0]) + times(p[i % 3 + 1], q[(i + 1) % 3 + 1]) - times(p[(i + 1) % 3 + 1], q[i % 3 + 1])
         for i in (1, 2, 3)]
    return np.array([w, *v])


def conjugate(q):
    return q * np.array([1, -1, -1, -1])[:, None, None]


def slerp(a, b, share):
    """a (a⁻¹ b)^share by the angle of the quaternion, as series."""
    turn = product(conjugate(a), b)
    sine = of(lambda x: (np.sqrt(x), 0.5 / np.sqrt(x), -0.25 / x**1.5), sum(times(turn[i], turn[i]) for i in (1, 2, 3)))
    angle = of(lambda x: (np.arcsin(x), 1 / np.sqrt(1 - x**2), x / (1 - x**2) ** 1.5), sine)
    angle = np.where(turn[0][0] > 0, angle, series(np.pi + 0 * sine[0], 0, 0) - angle)
    part = times(angle, share)
    ratio = times(of(lambda x: (np.sin(x), np.cos(x), -np.sin(x)), part), of(lambda x: (1 / x, -1 / x**2, 2 / x**3), sine))
    cosine = of(lambda x: (np.cos(x), -np.sin(x), -np.cos(x)), part)
    return product(a, np.array([cosine, *(times(ratio, turn[i]) for i in (1, 2, 3))]))


def slerp_rates(h, start, end, leaving, arriving, share):
    """Of cubics by de Casteljau's algorithm with slerps, whose handles are a third of the rates: one per row."""
    def still(q):
        return np.array([series(x, 0, 0) for x in q.T])

    def handle(q, rate):
        moved = (Rotation.from_quat(q[:, [1, 2, 3, 0]]) * Rotation.from_rotvec(rate * h[:, None] / 3)).as_quat()[:, [3, 0, 1, 2]]
        return still(np.where(np.sum(moved * q, axis=1, keepdims=True) > 0, moved, -moved))

    share = series(share, 1 / h, 0)
    points = [still(start), handle(start, leaving), handle(end, -arriving), still(end)]
    while len(points) > 1:
        points = [slerp(a, b, share) for a, b in zip(points, points[1:])]
    q = points[0]
    rate = np.array([q[:, 1], 2 * q[:, 2], 0 * q[:, 2]]).transpose(1, 0, 2)
    body = 2 * product(conjugate(q), rate)[1:]
    return body[:, 0].T, body[:, 1].T


def slerp_segments(keys, steps, rates, shares):
    """ω and α at these shares of every segment (segments, shares, 3)."""
    each = np.repeat(np.arange(len(steps)), len(shares))
    omega, alpha = slerp_rates(steps[each], keys[each], keys[each + 1], rates[each], rates[each + 1], np.tile(shares, len(steps)))
    return omega.reshape(len(steps), len(shares), 3), alpha.reshape(len(steps), len(shares), 3)


def rates_of(keys, steps, nu):
    """Those of nu-exact: no acceleration at the ends, at inner keys a jump of ν times the rate."""
    n = len(keys)
    turns = [Rotation.from_quat(keys[i][[1, 2, 3, 0]]).inv() * Rotation.from_quat(keys[i + 1][[1, 2, 3, 0]]) for i in range(n - 1)]
    mean = np.array([turn.as_rotvec() / h for turn, h in zip(turns, steps, strict=True)])
    first = np.array([mean[0], *(0.5 * (mean[:-1] + mean[1:])), mean[-1]])

    def missing(x):
        rates = x.reshape(n, 3)
        ends = slerp_segments(keys, steps, rates, np.array([0.0, 1.0]))[1]
        inner = [ends[i][0] - ends[i - 1][1] - nu[i] * rates[i] for i in range(1, n - 1)]
        return np.concatenate([ends[0][0], *inner, ends[-1][1]])

    found = root(missing, first.ravel(), method="hybr", options={"xtol": 1e-14})
    assert np.abs(found.fun).max() < 1e-9, found
    return found.x.reshape(n, 3)


def solved(case, rq, rm):
    family, sequence, objective, free = case
    curves = Curves(family, *keys_of(sequence, rq), rq, rm)
    count = len(curves.keys)
    start = {name: [value] * count for name, value in curves.initial.items()}
    places = [(name, key) for name in free for key in range(count) if curves.may_vary(name, key)]

    def parameters(x):
        named = {name: list(values) for name, values in start.items()}
        for (name, key), value in zip(places, x, strict=True):
            named[name][key] = float(value)
        return named

    first = np.array([start[name][key] for name, key in places])
    found = least_squares(lambda x: curves.residuals(parameters(x), objective), first, jac="3-point", x_scale=1.0, ftol=1e-14,
                          xtol=1e-10, gtol=1e-12, max_nfev=60)
    before = float(np.sum(curves.residuals(start, objective) ** 2))
    initial = ";".join(f"{name}={value!r}" for name, value in curves.initial.items())
    moments = " ".join(map(repr, INERTIA)) if objective == "torque" else ""
    print(case, before, 2 * found.cost, found.nfev, found.optimality, file=sys.stderr, flush=True)
    return f"{family},{sequence},{objective},{moments},{' '.join(free)},{initial},{before:.13g},{2 * found.cost:.13g}"


def tuned(source):
    """The tensions of least energy, through sequences of keys.csv.

    Another way than the library's: curves of the reference (refquat.py and refmethods.py) with 25 digits, rates and quadrature of its
    own, and SciPy's least squares with differences of the residuals. Energies agree to 1e-11 of themselves.
    """
    sys.path.insert(0, str(source))
    import refmethods
    import refquat
    refquat.mp.dps = 25
    lines = [solved(case, refquat, refmethods) for case in cases()]
    return {"tests/data/golden/tuned.csv": HEAD + "\n".join(lines) + "\n"}
