# SPDX-License-Identifier: Apache-2.0
"""What takes time, in seconds: it wants a machine that does nothing else, and is run by build.py FOLDER --timing alone."""
import pathlib
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

pytestmark = pytest.mark.timing

MOTION = """
import numpy as np, orispline as ori
def motion(n, noise=0.0, rate=100):
    dice = np.random.default_rng(1)
    t = np.arange(n) / rate
    half = np.column_stack([np.sin(2 * t), np.cos(3 * t), np.sin(t)]) * 0.4 + dice.normal(size=(n, 3)) * noise
    q = np.column_stack([half, np.ones(n)])
    return ori.Keys(t, q, normalize=True)
"""
TASKS = {
    "smooth": ("keys = motion(200_000, 0.01)", "ori.smooth(keys)"),
    "smooth, tukey": ("keys = motion(200_000, 0.01)", "ori.smooth(keys, loss='tukey')"),
    "reduce": ("keys = motion(200_000, 0.001)", "ori.reduce(keys, 0.003, method='timed-c2', values='refit', threads=1)"),
    "reduce, slerp": ("keys = motion(400_000, 0.001)", "ori.reduce(keys, 0.003, method='slerp')"),
    "reduce, smooth": ("keys = motion(200_000, 0.01)", "ori.reduce(keys, 0.003, smooth=True)"),
    "reduce_tracks": ("keys = motion(15_000, 0.001)", "ori.reduce_tracks([keys] * 4, 0.003, threads=1)"),
    "retime": ("keys = motion(5_000, 0.01, 10)", "ori.retime(keys, max_rate=0.01, per_interval=True, method='timed-c2')"),
    "tune": ("keys = motion(200_000, 0.05, 10)", "ori.tune(keys, 'quintic', objective='jerk')"),
    "tune, nu": ("keys = motion(5_000, 0.05, 10)", "ori.tune(keys, 'nu', objective='jerk')"),
    "compare": ("keys = motion(100_000, 0.01)", "ori.compare(keys, tune=True, leave_out=True, threads=1)"),
    # Two keys so close that a single segment takes seconds.
    "bake": ("from scipy.spatial.transform import Rotation\n"
             "curve = ori.Curve([0.0, 1.0, 1.0 + 1e-6, 2.0, 3.0], Rotation.random(5, random_state=3), 'circular')", "curve.bake(1e-6)"),
}
INTERRUPTED = """
import signal, time
def handler(number, frame):
    global asked
    asked = time.process_time()
    raise KeyboardInterrupt
signal.signal(signal.SIGINT, handler)  # also where the shell has it ignored, as behind &
print("begun", flush=True)
try:
    {work}
except KeyboardInterrupt:
    print("interrupted", time.process_time() - asked)
else:
    print("too fast")
"""


def interrupted(code, after):
    """What a program says that gets Ctrl-C so many seconds after it has begun."""
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begun\n"
        time.sleep(after)
        process.send_signal(signal.SIGINT)
        return process.pid, process.stdout.read().split()


@pytest.mark.parametrize("task", TASKS)
def test_ctrl_c_ends_a_task_within_half_a_second(task):
    given, work = TASKS[task]
    _, (word, *seconds) = interrupted(f"{MOTION}{given}\n{INTERRUPTED.format(work=work)}", 0.3)
    assert word == "interrupted"
    assert float(seconds[0]) < 0.5  # of the processor, since others may work on it


@pytest.mark.parametrize("task", ["tables.resample({keys}, rate=2000)", "tables.smooth({keys})",
                                  "tables.resample({keys}, rate=2000, assume_sorted=True)"])
def test_ctrl_c_ends_a_job_of_tables_before_four_tracks_more(tmp_path, task):
    """Of 400 tracks; whatever it is about, such as putting rows in order."""
    parquet = pytest.importorskip("pyarrow.parquet")
    pytest.importorskip("duckdb")
    from track_data import table_of
    dice = np.random.default_rng(1)
    made = {}
    for track in range(400):
        half = dice.normal(size=5000).cumsum() * 0.02
        made[track] = np.arange(5000) * 0.01, np.column_stack([np.sin(half), 0 * half, 0 * half, np.cos(half)])
    keys, few, out = (tmp_path / f"{name}.parquet" for name in ("keys", "few", "out"))
    parquet.write_table(table_of(made), keys)
    parquet.write_table(table_of({track: made[track] for track in range(4)}), few)
    few_read, all_read = (task.format(keys=repr(str(path))) for path in (few, keys))
    code = (f"import time\nfrom orispline import tables\n{few_read}.read_all()\ncost_of_few = time.process_time()\n"
            f"{INTERRUPTED.format(work=f'tables.write({all_read}, {str(out)!r})')}print(cost_of_few)")
    process, (word, seconds, cost_of_few) = interrupted(code, 1.5)
    assert word == "interrupted" and not out.exists()
    assert float(seconds) < float(cost_of_few)  # [s] of the processor, of all threads: at most 4 of 400 tracks, and an import
    assert not list(pathlib.Path("/tmp").glob(f"orispline-*/{process}*"))


def test_importing_takes_little_time():
    """At most 15 ms beyond NumPy are wanted, and measured by `make bench-python`."""
    code = "import numpy, time; start = time.process_time(); import orispline; print(time.process_time() - start)"
    said = [subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout for _ in range(3)]
    assert min(map(float, said)) < 0.1
