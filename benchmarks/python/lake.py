# SPDX-License-Identifier: Apache-2.0
"""Many tracks to measure with, and what a user of SciPy would write for them.

SciPy is imported where it is called: a process whose memory is measured does not load it.
"""
import multiprocessing
import os
import pathlib
import threading
import time

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

QUATERNION = ["qx", "qy", "qz", "qw"]
BAD_EVERY = 1000


def tracks(count: int, keys: int = 50, seed: int = 7) -> dict[str, np.ndarray]:
    """Columns of so many tracks in order, of about so many keys, 0.05 to 0.15 s apart; some have two keys at the same time."""
    from scipy.spatial.transform import Rotation
    dice = np.random.default_rng(seed)
    sizes = dice.integers(4 * keys // 5, 6 * keys // 5 + 1, count)
    ids = np.repeat(np.arange(count), sizes)
    starts = np.concatenate([[0], np.cumsum(sizes)[:-1]])
    steps = dice.uniform(0.05, 0.15, sizes.sum())
    steps[starts[BAD_EVERY // 2::BAD_EVERY] + keys // 2] = 0.0
    walk = np.cumsum(dice.normal(scale=0.1, size=(len(ids), 3)), axis=0)
    q = Rotation.from_rotvec(walk - walk[starts][ids]).as_quat()
    t = np.cumsum(steps)
    return {"track": ids, "t": t - t[starts][ids], **dict(zip(QUATERNION, q.T.copy()))}


def in_no_order(columns: dict[str, np.ndarray]) -> pa.Table:
    order = np.random.default_rng(1).permutation(len(columns["t"]))
    return pa.table({name: column[order] for name, column in columns.items()})


def one_track(keys: int) -> pa.Table:
    """A single one that turns about two axes, a key every 0.1 s."""
    t = np.arange(keys) * 0.1
    a, b = np.sin(0.3 * t), 0.5 * np.sin(0.7 * t)
    return pa.table({"track": np.zeros(keys, np.int64), "t": t, "qx": np.sin(a) * np.cos(b), "qy": np.cos(a) * np.sin(b),
                     "qz": np.sin(a) * np.sin(b), "qw": np.cos(a) * np.cos(b)})


def scipy_loop(columns: dict[str, np.ndarray], count: int, rate: float) -> list[tuple[np.ndarray, ...]]:
    """Even samples with ω of the first tracks that are sound, a spline for each."""
    from scipy.spatial.transform import Rotation, RotationSpline
    ends = np.searchsorted(columns["track"], np.arange(count + 1))
    q = np.column_stack([columns[name] for name in QUATERNION])
    found = []
    for first, end in zip(ends[:-1], ends[1:]):
        t = columns["t"][first:end]
        if not (np.diff(t) > 0.0).all():
            continue
        spline = RotationSpline(t, Rotation.from_quat(q[first:end]))
        at = t[0] + np.arange(int((t[-1] - t[0]) * rate) + 1) / rate
        found.append((at, spline(at).as_quat(), spline(at, 1)))
    return found


def processor_time(work) -> float:
    """Of one call, in this process and all its threads [s]."""
    start = time.process_time()
    work()
    return time.process_time() - start


def by_the_clock(work, turns: int) -> float:
    """The best of several calls [s]."""
    found = []
    for _ in range(turns):
        start = time.perf_counter()
        work()
        found.append(time.perf_counter() - start)
    return min(found)


def alone(work, *arguments):
    """What a process of its own gives: (result, the most memory that it had [MB])."""
    context = multiprocessing.get_context("spawn")
    ours, theirs = context.Pipe()
    process = context.Process(target=_reporting, args=(theirs, work, arguments))
    process.start()
    theirs.close()
    found = ours.recv()
    process.join()
    return found


def _reporting(pipe, work, arguments) -> None:
    result = work(*arguments)
    pipe.send((result, most_memory()))


def most_memory() -> float:
    """Of this process so far [MB]. `getrusage` would count what the process had that began this one."""
    status = pathlib.Path("/proc/self/status").read_text("utf-8")
    return next(int(line.split()[1]) for line in status.splitlines() if line.startswith("VmHWM:")) / 1024


def resampled_file(source: str, place: str, options: dict[str, object]) -> tuple[float, int]:
    """Parquet to Parquet: (processor time [s], rows)."""
    from orispline import tables
    start = time.process_time()
    rows = tables.write(tables.resample(source, **options), place).rows
    return time.process_time() - start, rows


def parquet(table: pa.Table, folder: pathlib.Path, name: str) -> str:
    place = folder / f"{name}.parquet"
    pq.write_table(table, place, row_group_size=1 << 17)
    return str(place)


class Watch:
    """The most memory that processes whose command has these words have [MB], while it looks."""

    def __init__(self, words: str) -> None:
        self.most, self._words, self._over = 0.0, words, threading.Event()
        self._thread = threading.Thread(target=self._look)

    def __enter__(self) -> "Watch":
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        self._over.set()
        self._thread.join()

    def _look(self) -> None:
        while not self._over.wait(0.05):
            for process in pathlib.Path("/proc").glob("[0-9]*"):
                try:
                    if self._words in (process / "cmdline").read_text():
                        pages = int((process / "statm").read_text().split()[1])
                        self.most = max(self.most, pages * os.sysconf("SC_PAGE_SIZE") / 2**20)
                except OSError:
                    continue
