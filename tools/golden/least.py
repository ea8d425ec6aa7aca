# SPDX-License-Identifier: Apache-2.0
"""The curves of least energy through some keys, by multiple shooting with SciPy.

Between keys the optimum obeys the equations of Pontryagin, which are integrated here by a Runge-Kutta method of order 8; Newton's
method on the state behind every key makes the pieces meet. So nothing is shared with the method `least`, which minimises over
piecewise polynomials.

With momenta p of the orientation, s of ω and, for the jerk, r of α, all in the body frame:

    p' = p × ω          s' = -p - 2 ((J ω) × τ + J (τ × ω)),  s = -2 J τ  →  τ           (torque; J = 1: acceleration)
    p' = p × ω          s' = -p,  r' = -s,  r = -2 jerk                                    (jerk)

p jumps at keys; the others are continuous and vanish at a free end.
"""
import concurrent.futures
import sys

import numpy
from golden.exact import FOLDER, ROOT, doubles
from scipy.integrate import solve_ivp

SEED = 19890612
INSTANTS = (0.13, 0.5, 0.77)  # shares of an interval, where motions are tabled
NUDGE = 1e-6  # for the slopes of Newton's method
SETTLED = 3e-12  # what the pieces may miss each other by, relative
INERTIA = {"none": numpy.eye(3), "diagonal": numpy.diag([1.0, 2.0, 2.5]),
           "full": numpy.array([[2.0, 0.3, -0.2], [0.3, 3.0, 0.4], [-0.2, 0.4, 2.5]])}


def product(p, q):
    w, v, x, u = p[..., :1], p[..., 1:], q[..., :1], q[..., 1:]
    return numpy.concatenate([w * x - (v * u).sum(-1, keepdims=True), w * u + x * v + numpy.cross(v, u)], axis=-1)


def conjugate(q):
    return q * numpy.array([1.0, -1.0, -1.0, -1.0])


def exp(phi):
    half = 0.5 * numpy.linalg.norm(phi, axis=-1, keepdims=True)
    return numpy.concatenate([numpy.cos(half), 0.5 * phi * numpy.sinc(half / numpy.pi)], axis=-1)


def log(q):
    sine = numpy.linalg.norm(q[..., 1:], axis=-1, keepdims=True)
    angle = 2.0 * numpy.arctan2(sine, q[..., :1])
    return numpy.where(sine > 1e-12, angle / numpy.where(sine > 1e-12, sine, 1.0), 2.0) * q[..., 1:]


class Torque:
    """State behind a key: ω, τ, p. The energy is the last entry of what is integrated."""
    size, free_ends, rate_ends = 9, (3, 4, 5), (0, 1, 2)

    def __init__(self, inertia):
        self.j, self.inverse = inertia, numpy.linalg.inv(inertia)

    def slope(self, q, z):
        omega, tau, p = z[..., 0:3], z[..., 3:6], z[..., 6:9]
        momentum = omega @ self.j
        push = p + 2.0 * (numpy.cross(momentum, tau) + numpy.cross(tau, omega) @ self.j)
        return numpy.concatenate([(tau - numpy.cross(omega, momentum)) @ self.inverse, 0.5 * push @ self.inverse,
                                  numpy.cross(p, omega)], axis=-1), tau

    def rates(self, z):
        dz, _ = self.slope(None, z)
        return z[0:3], dz[0:3]


class Jerk:
    """State behind a key: ω, α, jerk, s, p."""
    size, free_ends, rate_ends = 15, (6, 7, 8, 9, 10, 11), (0, 1, 2, 6, 7, 8)

    def slope(self, q, z):
        omega, alpha, jerk, s, p = (z[..., 3 * k:3 * k + 3] for k in range(5))
        return numpy.concatenate([alpha, jerk, 0.5 * s, -p, numpy.cross(p, omega)], axis=-1), jerk

    def rates(self, z):
        return z[0:3], z[3:6]


def flown(law, q, z, h, instants=()):
    """From orientations and states over h [s]: the same at the end and the energies; a row for each start."""
    n, m = z.shape

    def slope(_, flat):
        y = flat.reshape(n, 4 + m + 1)
        dz, force = law.slope(y[:, :4], y[:, 4:4 + m])
        spin = numpy.concatenate([numpy.zeros((n, 1)), 0.5 * y[:, 4:7]], axis=-1)
        return numpy.concatenate([product(y[:, :4], spin), dz, (force ** 2).sum(-1, keepdims=True)], axis=-1).ravel()

    start = numpy.concatenate([q, z, numpy.zeros((n, 1))], axis=-1).ravel()
    found = solve_ivp(slope, (0.0, h), start, method="DOP853", rtol=1e-13, atol=1e-14,
                      t_eval=[*(share * h for share in instants), h])
    rows = found.y.T.reshape(len(instants) + 1, n, 4 + m + 1)
    return rows[..., :4], rows[..., 4:4 + m], rows[..., -1]


class Shooting:
    """Keys with their times; `ends`: a rate for each end, or None where it is free."""

    def __init__(self, law, times, keys, ends):
        self.law, self.steps, self.ends = law, numpy.diff(times), ends
        self.increments = log(product(conjugate(keys[:-1]), keys[1:]))
        self.first = keys[0]

    def keys_at(self, share):
        keys = [self.first]
        for phi in self.increments:
            keys.append(product(keys[-1], exp(share * phi)))
        return numpy.array(keys)

    def start(self):
        states = numpy.zeros((len(self.steps), self.law.size))
        states[:, :3] = self.increments / self.steps[:, None]
        return states

    def equations(self, states, share, slopes=True):
        """What is missed, and its slopes by all states: a block of rows for each interval, and one for the ends."""
        law, keys, n, m = self.law, self.keys_at(share), len(self.steps), self.law.size
        common = m - 3  # continuous at keys
        missed = numpy.zeros(n * m)
        slope = numpy.zeros((n * m, n * m))
        row = 0
        for i in range(n):
            variants = numpy.repeat(states[i][None], m + 1 if slopes else 1, axis=0)
            nudges = NUDGE * numpy.maximum(1.0, numpy.abs(states[i]))
            if slopes:
                variants[1:] += numpy.diag(nudges)
            q, z, _ = flown(law, numpy.repeat(keys[i][None], len(variants), axis=0), variants, self.steps[i])
            off = log(product(conjugate(keys[i + 1]), q[-1]))
            parts = [off] if i + 1 == n else [off, z[-1][:, :common] - states[i + 1][:common]]
            values = numpy.concatenate(parts, axis=-1)
            k = values.shape[1]
            missed[row:row + k] = values[0]
            slope[row:row + k, i * m:(i + 1) * m] = ((values[1:] - values[0]) / nudges[:, None]).T if slopes else 0.0
            if i + 1 < n:
                slope[row + 3:row + k, (i + 1) * m:(i + 1) * m + common] -= numpy.eye(common)
            row += k
        last = z[-1]
        for which, rate in enumerate(self.ends):
            for entry in law.free_ends if rate is None else law.rate_ends:
                wanted = share * rate[entry] if rate is not None and entry < 3 else 0.0
                if which == 0:
                    missed[row] = states[0][entry] - wanted
                    slope[row, entry] = 1.0
                else:
                    missed[row] = last[0][entry] - wanted
                    slope[row, (n - 1) * m:] = (last[1:, entry] - last[0, entry]) / nudges if slopes else 0.0
                row += 1
        return missed, slope

    def solved(self, states, share, most=25):
        best = numpy.inf
        for _ in range(most):
            missed, slope = self.equations(states, share)
            size = numpy.abs(missed).max() / max(1.0, numpy.abs(states[:, :6]).max())
            if not numpy.isfinite(size) or size > 1e3:
                return None
            if size < SETTLED and not size < 0.5 * best:
                return states
            best = min(best, size)
            states = states - numpy.linalg.solve(slope, missed).reshape(states.shape)
        return states if best < 10 * SETTLED else None

    def run(self):
        """By continuation from keys whose steps are shortened."""
        states, share, advance = self.start() * 0.1, 0.0, 0.1
        before, before_share = None, 0.0
        while share < 1.0:
            following = min(1.0, share + advance)
            guess = states * following / share if share > 0.0 else states
            if before is not None:
                guess = states + (states - before) * (following - share) / (share - before_share)
            found = self.solved(guess, following)
            if found is None:
                advance *= 0.5
                if advance < 1e-4:
                    return None
                continue
            before, before_share = (states, share) if share > 0.0 else (None, 0.0)
            states, share, advance = found, following, 1.5 * advance
        return states

    def energy(self, states):
        keys = self.keys_at(1.0)
        return sum(flown(self.law, keys[i][None], states[i][None], h)[2][-1, 0] for i, h in enumerate(self.steps))

    def motions(self, states, times):
        keys = self.keys_at(1.0)
        for i, h in enumerate(self.steps):
            q, z, _ = flown(self.law, keys[i][None], states[i][None], h, INSTANTS)
            for share, orientation, state in zip(INSTANTS, q[:, 0], z[:, 0]):
                yield times[i] + share * h, orientation, *self.law.rates(state)


def read_keys(path):
    rows = [line.split(",") for line in path.read_text(encoding="utf-8").splitlines() if line and line[0] not in "#t"]
    table = numpy.array([[float(cell) for cell in row[:5]] for row in rows])
    return table[:, 0], aligned(table[:, 1:] / numpy.linalg.norm(table[:, 1:], axis=1, keepdims=True))


def aligned(keys):
    keys = keys.copy()
    for i in range(1, len(keys)):
        if keys[i] @ keys[i - 1] < 0.0:
            keys[i] *= -1.0
    return keys


def walk(random, count, step):
    """Steps of that size [rad] about random axes, the times between them by turns 1 s and 0.1 s."""
    keys = [exp(random.normal(size=3))]
    for _ in range(count - 1):
        axis = random.normal(size=3)
        keys.append(product(keys[-1], exp(step * axis / numpy.linalg.norm(axis))))
    times = numpy.concatenate([[0.0], numpy.cumsum([1.0 if i % 2 == 0 else 0.1 for i in range(count - 1)])])
    return times, aligned(numpy.array(keys))


def key_sets():
    data = ROOT / "examples" / "data"
    return {"five": read_keys(data / "five_keys.csv"), "flight": read_keys(data / "flight_keys.csv"),
            "step1": walk(numpy.random.default_rng(SEED), 6, 1.0), "step2": walk(numpy.random.default_rng(2), 4, 2.0)}


RATES = (numpy.array([0.4, -0.3, 0.2]), numpy.array([-0.1, 0.5, 0.3]))
REST = (numpy.zeros(3), numpy.zeros(3))
FREE = (None, None)
CASES = [  # keys, energy, inertia, ends
    ("five", "acceleration", "none", "natural", FREE), ("five", "acceleration", "none", "clamped", RATES),
    ("five", "acceleration", "none", "rest", REST), ("five", "torque", "diagonal", "natural", FREE),
    ("five", "torque", "full", "clamped", RATES), ("five", "jerk", "none", "natural", FREE),
    ("five", "jerk", "none", "rest", REST), ("flight", "acceleration", "none", "natural", FREE),
    ("step1", "acceleration", "none", "natural", FREE), ("step2", "acceleration", "none", "natural", FREE)]


def solved(case):
    """What both tables say of a case: its energy, and rows of its motions."""
    name, energy, inertia, _, rates = case
    times, orientations = key_sets()[name]
    problem = Shooting(Jerk() if energy == "jerk" else Torque(INERTIA[inertia]), times, orientations, rates)
    states = problem.run()
    if states is None:
        sys.exit(f"{case[:4]}: found no optimum")
    return problem.energy(states), list(problem.motions(states, times))


def key_rows(name, times, orientations):
    return [",".join([name, *doubles([t], q)]) for t, q in zip(times, orientations)]


def least(_):
    """Keys with the energies and motions of the curves through them."""
    keys, sets = ["sequence,t,qw,qx,qy,qz"], key_sets()
    for name in sets:
        keys += key_rows(name, *sets[name])
    energies, motions = ["case,sequence,energy,inertia,ends,value"], ["case,t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az"]
    with concurrent.futures.ProcessPoolExecutor() as pool:
        results = list(pool.map(solved, CASES))
    for number, ((name, energy, inertia, ends, _), (value, rows)) in enumerate(zip(CASES, results)):
        j = INERTIA[inertia]
        tensor = " ".join(doubles((j[0, 0], j[1, 1], j[2, 2], j[0, 1], j[0, 2], j[1, 2])))
        energies.append(f"{number},{name},{energy},{tensor},{ends},{float(value)!r}")
        motions += [",".join([str(number), *doubles([t], q, omega, alpha)]) for t, q, omega, alpha in rows]
    head = "# Made by tools/make_least_golden.py, by multiple shooting: see there.\n"
    return {f"tests/data/golden/least_{name}.csv": head + "\n".join(lines) + "\n"
            for name, lines in (("keys", keys), ("energies", energies), ("motions", motions))}


# ---------------------------------------------------------------- wide turns at uneven times

PIECES = 40  # of an interval, for Runge's and Kutta's method of order 4, before the end
ONE = {f"one{seed}": (1000 + seed, 6, 1.0) for seed in (1, 2, 3, 5, 6)}  # seed, keys, step [rad]
TWO = {f"two{count}0{seed}": (2000 + seed, count, 2.0)
       for count, seeds in ((4, range(1, 7)), (6, (1,))) for seed in seeds}


class QuickShooting(Shooting):
    """With all intervals and all slopes at once, in fixed steps, until `exact`."""
    exact = False

    def equations(self, states, share, slopes=True):
        if self.exact:
            return super().equations(states, share, slopes)
        n, m = states.shape
        nudges = NUDGE * numpy.maximum(1.0, numpy.abs(states))
        z = numpy.repeat(states[:, None], m + 1, axis=1)
        for i in range(n):
            z[i, 1:] += numpy.diag(nudges[i])
        keys = self.keys_at(share)
        q, z = self.flown(numpy.repeat(keys[:-1, None], m + 1, axis=1), z)
        missed, slope, row = numpy.zeros(n * m), numpy.zeros((n * m, n * m)), 0
        for i in range(n):
            off = log(product(conjugate(keys[i + 1]), q[i]))
            values = off if i + 1 == n else numpy.concatenate([off, z[i][:, :6] - states[i + 1][:6]], axis=-1)
            size = values.shape[1]
            missed[row:row + size] = values[0]
            slope[row:row + size, i * m:(i + 1) * m] = ((values[1:] - values[0]) / nudges[i][:, None]).T
            if i + 1 < n:
                slope[row + 3:row + size, (i + 1) * m:(i + 1) * m + 6] -= numpy.eye(6)
            row += size
        for entry in self.law.free_ends:
            missed[row], slope[row, entry] = states[0][entry], 1.0
            missed[row + 1] = z[-1][0, entry]
            slope[row + 1, (n - 1) * m:] = (z[-1][1:, entry] - z[-1][0, entry]) / nudges[-1]
            row += 2
        return missed, slope

    def flown(self, q, z):
        shape, h = z.shape, (self.steps / PIECES)[:, None, None]

        def slope(q, z):
            change, _ = self.law.slope(None, z.reshape(-1, shape[-1]))
            spin = numpy.concatenate([numpy.zeros((*shape[:2], 1)), 0.5 * z[..., :3]], axis=-1)
            return product(q, spin), change.reshape(shape)

        for _ in range(PIECES):
            k1 = slope(q, z)
            k2 = slope(q + 0.5 * h * k1[0], z + 0.5 * h * k1[1])
            k3 = slope(q + 0.5 * h * k2[0], z + 0.5 * h * k2[1])
            k4 = slope(q + h * k3[0], z + h * k3[1])
            q, z = (x + h / 6 * (a + 2 * b + 2 * c + d) for x, a, b, c, d in zip((q, z), k1, k2, k3, k4))
        return q / numpy.linalg.norm(q, axis=-1, keepdims=True), z


def starts():
    states = {}
    for line in (FOLDER / "least_hard_starts.csv").read_text(encoding="utf-8").splitlines():
        if line.startswith("two"):
            name, *numbers = line.split(",")
            states.setdefault(name, []).append(list(map(float, numbers)))
    return {name: numpy.array(rows) for name, rows in states.items()}


def energy(name, times, orientations):
    problem = QuickShooting(Torque(INERTIA["none"]), times, orientations, FREE)
    near = problem.run() if name in ONE else problem.solved(starts()[name], 1.0)
    problem.exact = True
    return problem.energy(problem.solved(near, 1.0))


def least_hard(_):
    """Curves of least acceleration through keys with wide turns at uneven times.

    With SciPy's DOP853 in the end. Keys with steps of 1 rad are found by continuation from short steps. With steps of 2 rad that ends
    at other curves than the best one, or nowhere: their shooting begins near a curve of `least`, whose states are rounded to five
    digits.
    """
    keys, energies = ["sequence,t,qw,qx,qy,qz"], ["sequence,value"]
    for name, (seed, count, step) in {**ONE, **TWO}.items():
        times, orientations = walk(numpy.random.default_rng(seed), count, step)
        keys += key_rows(name, times, orientations)
        energies.append(f"{name},{float(energy(name, times, orientations))!r}")
    head = "# Made by tools/make_least_hard_golden.py, by multiple shooting: see there.\n"
    return {f"tests/data/golden/least_hard_{name}.csv": head + "\n".join(lines) + "\n" for name, lines in (("keys", keys), ("energies", energies))}
