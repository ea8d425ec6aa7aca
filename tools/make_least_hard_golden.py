#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes tests/data/golden/least_hard_*.csv: curves of least acceleration through keys with wide turns at uneven times.

By multiple shooting, as in make_least_golden.py, with SciPy's DOP853 in the end. Keys with steps of 1 rad are found by
continuation from short steps. With steps of 2 rad that ends at other curves than the best one, or nowhere: their
shooting begins near a curve of `least`, whose states are rounded to five digits.
"""
import argparse

import numpy

from make_least_golden import INERTIA, TARGET, FREE, NUDGE, Shooting, Torque, conjugate, log, product, text, walk

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
    for line in (TARGET / "least_hard_starts.csv").read_text(encoding="utf-8").splitlines():
        if line.startswith("two"):
            name, *numbers = line.split(",")
            states.setdefault(name, []).append(list(map(float, numbers)))
    return {name: numpy.array(rows) for name, rows in states.items()}


def energy(name, times, orientations):
    problem = QuickShooting(Torque(INERTIA["none"]), times, orientations, FREE)
    near = problem.run() if name in ONE else problem.solved(starts()[name], 1.0)
    problem.exact = True
    return problem.energy(problem.solved(near, 1.0))


def main():
    argparse.ArgumentParser(description=__doc__.splitlines()[0]).parse_args()
    keys, energies = ["sequence,t,qw,qx,qy,qz"], ["sequence,value"]
    for name, (seed, count, step) in {**ONE, **TWO}.items():
        times, orientations = walk(numpy.random.default_rng(seed), count, step)
        keys += [",".join([name, text(t), *map(text, q)]) for t, q in zip(times, orientations)]
        energies.append(f"{name},{text(energy(name, times, orientations))}")
    for name, lines in {"least_hard_keys.csv": keys, "least_hard_energies.csv": energies}.items():
        head = "# Made by tools/make_least_hard_golden.py, by multiple shooting: see there.\n"
        (TARGET / name).write_text(head + "\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
