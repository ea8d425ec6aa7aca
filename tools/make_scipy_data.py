#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes tests/data/scipy_rotation_spline.csv: three tracks and the motions of SciPy's RotationSpline through them.

Needs SciPy (the project itself never does: the table is committed). SciPy stops at a change of 1e-9 or after 10 rounds;
here it goes on until the rates settle.
"""
import pathlib
import sys

import numpy
import scipy
from scipy.spatial.transform import Rotation, RotationSpline

TARGET = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "scipy_rotation_spline.csv"
SEED = 20030112
KEYS = 8
EVEN_TIMES = numpy.arange(KEYS, dtype=float)
UNEVEN_TIMES = numpy.array([0.0, 0.5, 1.5, 1.75, 3.0, 3.2, 4.4, 6.0])
INSTANTS = numpy.concatenate([[0.0], (numpy.arange(13) + 0.5) / 13, [1.0]])  # shares of the time; no inner key
LARGEST_KINK = 1e-11  # of the angular acceleration at a key, relative


class SettledSpline(RotationSpline):
    TOL = 1e-14
    MAX_ITER = 1000


def smooth(times):
    """A tumbling motion sampled at the times."""
    angles = numpy.stack([0.6 * times, 0.5 * numpy.sin(0.9 * times), 0.4 * numpy.cos(0.7 * times)], axis=1)
    return Rotation.from_euler("ZYX", angles)


def walk(random, smallest_step, largest_step):
    """Steps of random size [rad] about random axes."""
    keys = [Rotation.random(random_state=random)]
    for size in numpy.linspace(smallest_step, largest_step, KEYS - 1):
        axis = random.normal(size=3)
        keys.append(keys[-1] * Rotation.from_rotvec(size * axis / numpy.linalg.norm(axis)))
    return Rotation.concatenate(keys)


def demand_settled(name, spline, times):
    before, after = (spline(numpy.nextafter(times[1:-1], side), 2) for side in (-numpy.inf, numpy.inf))
    kink = numpy.abs(after - before).max() / numpy.abs(after).max()
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


def main():
    random = numpy.random.default_rng(SEED)
    tracks = {"smooth": (EVEN_TIMES, smooth(EVEN_TIMES)), "uneven": (UNEVEN_TIMES, walk(random, 0.3, 1.2)),
              "large_steps": (EVEN_TIMES, walk(random, 1.0, 2.5))}
    text = [f"# Made by tools/make_scipy_data.py (SciPy {scipy.__version__}, RotationSpline with TOL "
            f"{SettledSpline.TOL}, seed {SEED}): rates in the body frame [rad/s].",
            "track,kind,t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az"]
    for name, (times, keys) in tracks.items():
        text.extend(lines(name, times, keys))
    TARGET.write_text("\n".join(text) + "\n", "utf-8")


if __name__ == "__main__":
    main()
