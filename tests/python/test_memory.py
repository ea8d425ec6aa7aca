# SPDX-License-Identifier: Apache-2.0
"""What curves take for each key, and that they give it back: as shares of what their numbers take, which is the same
everywhere. Memory is that of the process, in processes of their own."""
import subprocess
import sys
import tracemalloc

import numpy as np
import orispline as ori
import pytest

RESIDENT = """
import gc, os, sys
import numpy as np
import orispline as ori

def resident():
    gc.collect()
    with open("/proc/self/statm", encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE")

def keys(count):
    half = np.random.default_rng(1).uniform(-0.1, 0.1, (count, 1)).cumsum(axis=0) * [[1.0, 0.3, 0.0, 0.0]]
    quaternions = np.hstack([np.sin(half[:, :2]), np.zeros((count, 1)), np.cos(half[:, :1])])
    return np.arange(float(count)), quaternions / np.linalg.norm(quaternions, axis=1, keepdims=True)
"""
KEPT = """
times, rotations = keys(250_000)
def taken(count):
    before = resident()
    curve = ori.Curve(times[:count], rotations[:count], "{method}")
    return resident() - before
taken(100)  # what is made once
print((taken(250_000) - taken(50_000)) / (200_000 * 5 * 8))
"""
DROPPED = """
times, rotations = keys(12)
def work(count):
    for k in range(count):
        curve = ori.Curve(times, rotations, "rotation-spline" if k % 16 == 0 else ("auto", "timed-c2", "slerp")[k % 3])
        curve(3.7), curve.sample(count=5, derivatives=2), curve.angular_velocity([7.5, 2.5])
        yield curve
def taken(curves):
    before = resident()
    held = list(curves)
    return resident() - before
def left(curves):
    before = resident()
    for curve in curves:
        pass
    return resident() - before
left(work(2000))
dropped = left(work(10_000))
print(dropped / (5 * taken(work(2000))))
"""
only_on_linux = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")


def told(code):
    return float(subprocess.run([sys.executable, "-c", RESIDENT + code], capture_output=True, text=True, check=True).stdout)


@only_on_linux
@pytest.mark.parametrize("method", ["auto", "rotation-spline", "timed-c2", "slerp"])
def test_a_key_of_a_long_curve_takes_no_more_than_so_many_numbers(method):
    """Of time and quaternion, five: with what the method keeps of them at most 7.5 times as much."""
    assert told(KEPT.format(method=method)) <= 7.5


@only_on_linux
def test_curves_that_are_dropped_leave_nothing():
    """Of all that they would take if they were kept, less than a hundredth."""
    assert told(DROPPED) < 0.01


@pytest.mark.parametrize("ask", [lambda curve, t, out: curve(t, out=out[0]),
                                 lambda curve, t, out: curve.angular_velocity(t, out=out[1]),
                                 lambda curve, t, out: curve.angular_jerk(t, out=out[1], frame="world"),
                                 lambda curve, t, out: curve(t[::-1].copy(), out=out[0])], ids=["q", "rate", "jerk", "backwards"])
def test_out_allocates_nothing_that_grows(keys, ask):
    curve = ori.Curve(*keys)
    peaks = []
    for count in (1000, 1_000_000):
        t, out = np.linspace(*curve.domain, count), (np.empty((count, 4)), np.empty((count, 3)))
        extra = t.nbytes if ask.__code__.co_names.count("copy") else 0
        ask(curve, t, out)
        tracemalloc.start()
        try:
            ask(curve, t, out)
            peaks.append(tracemalloc.get_traced_memory()[1] - extra)
        finally:
            tracemalloc.stop()
    assert (peaks[1] - peaks[0]) / (1_000_000 - 1000) < 0.01, "bytes of NumPy and Python for each time"


@only_on_linux
def test_out_takes_no_memory_of_the_library_that_grows():
    code = """
import resource
curve = ori.Curve(*keys(1000))
def most(count):
    t, out = np.linspace(*curve.domain, count), np.zeros((count, 4))
    curve(t, out=out)
    rates = out.reshape(-1)[:3 * count].reshape(count, 3)
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    curve.angular_jerk(t, out=rates, frame="world"), curve(t, out=out)
    return (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) * 1024 / out.nbytes
most(100_000)
print(most(1_000_000))
"""
    assert told(code) < 1 / 32  # of what the samples take
