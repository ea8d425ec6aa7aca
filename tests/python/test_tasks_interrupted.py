# SPDX-License-Identifier: Apache-2.0
"""Signals are handled and other threads run while long work is under way. How soon Ctrl-C ends it: test_timing.py."""
import subprocess
import sys
import threading

import orispline as ori
import pytest

# The library works in a thread that is none of Python's: a thread of Python waits until that is there, and then sends the signal.
WORK = """
import os, signal, threading, time
import numpy as np, orispline as ori

def motion(count):
    t = np.arange(count) / 100
    half = np.column_stack([np.sin(2 * t), np.cos(3 * t), np.sin(t)]) * 0.4 + np.random.default_rng(1).normal(size=(count, 3)) * 0.01
    return ori.Keys(t, np.column_stack([half, np.ones(count)]), normalize=True)

def others():
    return len(os.listdir("/proc/self/task")) - threading.active_count()

def handler(number, frame):
    while_at_work.append(others() > idle)
    handled.set()
    if number == signal.SIGINT and while_at_work[-1]:
        raise KeyboardInterrupt

def send(number, over):
    while others() <= idle and not over.is_set():
        time.sleep(0)  # gives the lock back
    os.kill(os.getpid(), number)
    handled.wait()

def smoothed(keys, number):
    \"\"\"The smoothed keys, None where the signal ended that.\"\"\"
    over = threading.Event()
    handled.clear()
    sender = threading.Thread(target=send, args=(number, over))
    sender.start()
    try:
        found = ori.smooth(keys).keys
        over.set()
        sender.join()
    except KeyboardInterrupt:
        found = None
    sender.join()
    return found

ori.smooth(motion(100))
idle, handled = others(), threading.Event()
for number in (signal.SIGUSR1, signal.SIGINT):
    signal.signal(number, handler)
    count, while_at_work = 2000, [False]
    while not while_at_work[-1]:  # the work was over before the signal: with more of it
        count *= 2
        keys = motion(count)
        given = keys.rotations.copy()
        found = smoothed(keys, number)
    assert np.array_equal(keys.rotations, given)
    if number == signal.SIGINT:
        assert found is None
    else:
        assert np.array_equal(found.rotations, ori.smooth(keys).keys.rotations)
print(ori.smooth(keys[:100]))
"""


@pytest.mark.skipif(sys.platform != "linux", reason="reads /proc")
def test_a_signal_is_handled_while_the_work_is_under_way_and_ctrl_c_ends_it():
    done = subprocess.run([sys.executable, "-c", WORK], capture_output=True, text=True, check=False)
    assert done.returncode == 0 and done.stdout, done.stderr


def test_work_in_another_thread_needs_no_signals():
    keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    found = []
    worker = threading.Thread(target=lambda: found.append(ori.retime(keys, max_rate=0.5)))
    worker.start()
    worker.join()
    assert found[0].time_scale > 1
