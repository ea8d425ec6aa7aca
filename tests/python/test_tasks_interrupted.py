# SPDX-License-Identifier: Apache-2.0
"""Ctrl-C ends long work within half a second, and other threads run meanwhile."""
import signal
import subprocess
import sys
import threading
import time

import numpy as np
import orispline as ori
import pytest

MOTION = """
import sys, time, numpy as np, orispline as ori
def motion(n, noise=0.0, rate=100):
    dice = np.random.default_rng(1)
    t = np.arange(n) / rate
    half = np.column_stack([np.sin(2 * t), np.cos(3 * t), np.sin(t)]) * 0.4 + dice.normal(size=(n, 3)) * noise
    q = np.column_stack([half, np.ones(n)])
    return ori.Keys(t, q, normalize=True)
"""
TASKS = {
    "smooth": ("motion(200_000, 0.01)", "ori.smooth(keys)"),
    "smooth, tukey": ("motion(200_000, 0.01)", "ori.smooth(keys, loss='tukey')"),
    "reduce": ("motion(200_000, 0.001)", "ori.reduce(keys, 0.003, method='timed-c2', values='refit', threads=1)"),
    "reduce, slerp": ("motion(400_000, 0.001)", "ori.reduce(keys, 0.003, method='slerp')"),
    "reduce, smooth": ("motion(200_000, 0.01)", "ori.reduce(keys, 0.003, smooth=True)"),
    "reduce_tracks": ("motion(15_000, 0.001)", "ori.reduce_tracks([keys] * 4, 0.003, threads=1)"),
    "retime": ("motion(5_000, 0.01, 10)", "ori.retime(keys, max_rate=0.01, per_interval=True, method='timed-c2')"),
    "tune": ("motion(200_000, 0.05, 10)", "ori.tune(keys, 'quintic', objective='jerk')"),
    "tune, nu": ("motion(5_000, 0.05, 10)", "ori.tune(keys, 'nu', objective='jerk')"),
    "compare": ("motion(100_000, 0.01)", "ori.compare(keys, tune=True, leave_out=True, threads=1)"),
}
INTERRUPTED = """
def handler(number, frame):
    global asked
    asked = time.process_time()
    raise KeyboardInterrupt
import signal
signal.signal(signal.SIGINT, handler)
print("begun", flush=True)
try:
    {work}
except KeyboardInterrupt:
    print("interrupted", time.process_time() - asked)
else:
    print("too fast")
"""


@pytest.mark.parametrize("task", TASKS)
def test_an_interruption_ends_the_task(task):
    keys, work = TASKS[task]
    words = f"{MOTION}\nkeys = {keys}\n{INTERRUPTED.format(work=work)}"
    with subprocess.Popen([sys.executable, "-c", words], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begun\n"
        time.sleep(0.3)
        process.send_signal(signal.SIGINT)
        answer = process.stdout.read().split()
    assert answer[0] == "interrupted", answer
    assert float(answer[1]) < 0.5  # [s] of the processor, since others may work on it


def test_handlers_of_signals_run_meanwhile_without_ending_the_work():
    words = (f"{MOTION}\nimport signal\nseen = []\nsignal.signal(signal.SIGUSR1, lambda *a: seen.append(1))\n"
             "keys = motion(40_000, 0.01)\nprint('begun', flush=True)\n"
             "found = ori.smooth(keys)\nprint(len(seen), len(found.keys))\n")
    with subprocess.Popen([sys.executable, "-c", words], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begun\n"
        time.sleep(0.3)
        process.send_signal(signal.SIGUSR1)
        assert process.stdout.read() == "1 40000\n"


def test_other_threads_run_during_the_work():
    t = np.arange(20_000) / 100
    half = np.column_stack([np.sin(2 * t), np.cos(3 * t), np.sin(t)]) * 0.4
    half += np.random.default_rng(1).normal(size=half.shape) * 0.01
    keys = ori.Keys(t, np.column_stack([half, np.ones(len(t))]), normalize=True)
    counted = 0
    done = threading.Event()

    def count():
        nonlocal counted
        while not done.is_set():
            counted += 1
            time.sleep(0.001)

    counter = threading.Thread(target=count)
    counter.start()
    begin = time.perf_counter()
    ori.smooth(keys)
    took = time.perf_counter() - begin
    done.set()
    counter.join()
    assert counted > 50 * took


def test_work_in_another_thread_needs_no_signals():
    keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    found = []
    worker = threading.Thread(target=lambda: found.append(ori.retime(keys, max_rate=0.5)))
    worker.start()
    worker.join()
    assert found[0].time_scale > 1
