#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""SciPy on the same kind of keys: scipy_peer.py RESULT. Writes its times as JSON; without SciPy it writes nothing."""
import json
import os
import pathlib
import statistics
import sys
import time

os.environ |= {"OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1"}  # one thread, as the others
try:
    import numpy
    import scipy
    from scipy.spatial.transform import Rotation, RotationSpline, Slerp
except ImportError:
    sys.exit(print("scipy_peer: no SciPy here, left out"))

KEYS, SAMPLES, ROUNDS = 1000, 1_000_000, 5
FITTED = 10, 1000, 10_000  # as ours makes them


def keys(count):
    """Random axes, half angles of 0.05 to 1.2 rad, steps of 0.6 to 1.4 s."""
    dice = numpy.random.default_rng(42)
    axes = dice.normal(size=(count, 3))
    axes /= numpy.linalg.norm(axes, axis=1)[:, None]
    steps = Rotation.from_rotvec(axes * dice.uniform(0.1, 2.4, count)[:, None])
    orientations = [Rotation.identity()]
    for step in steps[1:]:
        orientations.append(orientations[-1] * step)
    return numpy.cumsum(dice.uniform(0.6, 1.4, count)), Rotation.concatenate(orientations)


def median_ns(work, items):
    taken = []
    for _ in range(ROUNDS):
        start = time.process_time()  # as the others: without the time that other programs take
        work()
        taken.append((time.process_time() - start) * 1e9 / items)
    return statistics.median(taken)


def verified(curve, times, orientations):
    """A peer that misses its own keys is not timed."""
    off = (curve(times).inv() * orientations).magnitude().max()
    if not off <= 1e-10:
        sys.exit(f"scipy_peer: {type(curve).__name__} misses its keys by {off:.3g} rad, wanted at most 1e-10: not timed")
    return curve


def fit_ns(count):
    """Nanoseconds per key of a curve through that many; short work is repeated."""
    times, orientations = keys(count)
    repeats = max(1, KEYS // count)
    return median_ns(lambda: [RotationSpline(times, orientations) for _ in range(repeats)], count * repeats)


def main():
    times, orientations = keys(KEYS)
    spline, slerp = (verified(kind(times, orientations), times, orientations) for kind in (RotationSpline, Slerp))
    at = numpy.linspace(times[0], times[-1], SAMPLES)
    result = {"version": scipy.__version__,
              "sample_ns": median_ns(lambda: spline(at).as_quat(), SAMPLES),
              "slerp_sample_ns": median_ns(lambda: slerp(at).as_quat(), SAMPLES),
              "fit_ns_per_key": {str(count): fit_ns(count) for count in FITTED}}
    pathlib.Path(sys.argv[1]).write_text(json.dumps(result) + "\n", "utf-8")


if __name__ == "__main__":
    main()
