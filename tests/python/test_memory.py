# SPDX-License-Identifier: Apache-2.0
"""What curves take, and that they give it back. Memory is that of the process, in processes of their own."""
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
times, rotations = keys({keys})
small = ori.Curve(times[:100], rotations[:100], "{method}")  # what is made once
before = resident()
curve = ori.Curve(times, rotations, "{method}")
print((resident() - before) / {keys})
"""
DROPPED = """
times, rotations = keys(12)
def work(count):
    for k in range(count):
        curve = ori.Curve(times, rotations, "rotation-spline" if k % 16 == 0 else ("auto", "timed-c2", "slerp")[k % 3])
        curve(3.7), curve.sample(count=5, derivatives=2), curve.angular_velocity([7.5, 2.5])
work(2000)
before = resident()
work(100_000)
print((resident() - before) / 1e6)
"""
only_on_linux = pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")


def told(code):
    return float(subprocess.run([sys.executable, "-c", RESIDENT + code], capture_output=True, text=True, check=True).stdout)


@only_on_linux
@pytest.mark.parametrize("method", ["auto", "rotation-spline", "timed-c2", "slerp"])
def test_a_key_of_a_long_curve_takes_300_bytes_at_most(method):
    assert told(KEPT.format(keys=1_000_000, method=method)) <= 300


@only_on_linux
def test_curves_that_are_dropped_leave_nothing():
    assert told(DROPPED) < 5  # MB


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
    assert peaks[1] - peaks[0] < 10_000, "bytes of NumPy and Python"


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
    return (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / 1e3
most(100_000)
print(most(4_000_000))
"""
    assert told(code) < 4  # MB, where the samples take 128
