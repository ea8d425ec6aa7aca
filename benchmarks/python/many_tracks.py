#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Tables of many tracks beside a loop over SciPy, and Spark beside a job that does nothing: many_tracks.py [--sizes full|smoke] [--document PAGE]

It prints a table, and with PAGE fills the block of that page between its own markers.
"""
import argparse
import datetime
import os
import pathlib
import platform
import shutil
import sys
import tempfile
from collections.abc import Iterator
from typing import Any

os.environ |= {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1]))
import duckdb  # noqa: E402
import lake  # noqa: E402
import numpy as np  # noqa: E402
import pyarrow as pa  # noqa: E402
import scipy  # noqa: E402
from orispline import tables  # noqa: E402
from page_block import fill_block  # noqa: E402
from ratios import machine  # noqa: E402

START, END = "<!-- many tracks: written by benchmarks/python/many_tracks.py -->\n", "<!-- end of many tracks -->"
# Tracks, those of SciPy, keys of a long track here and on Spark, tracks of pandas on Spark, and of growth all keys and all tracks.
SIZES = {"full": (20_000, 500, 10_000_000, 2_000_000, 6_000, (1_000_000, 2_000_000, 4_000_000), (100, 1_000, 10_000, 100_000)),
         "smoke": (200, 20, 2_000, 0, 0, (1_000,), (10,))}
RATE, GROWTH_RATE = 100, 20  # Hz
AMONG = 5000  # tracks, beside the one that is much longer
LARGEST_DIFFERENCE = 1e-9  # between the two rotation splines [1], [rad/s]


def row(title: str, found: float, unit: str, wanted: float | None, least: bool) -> str:
    if wanted is None:
        return f"| {title} | {found:.3g} {unit} | | |"
    met = found >= wanted if least else found <= wanted
    return f"| {title} | {found:.3g} {unit} | {'≥' if least else '≤'} {wanted:g} {unit} | {'met' if met else '**missed**'} |"


def hold_equal(columns: dict[str, np.ndarray], count: int) -> None:
    """Ends the program where the tables' rotation splines are not those of SciPy."""
    few = columns["track"] < count
    reader = tables.resample(pa.table({name: column[few] for name, column in columns.items()}), rate=RATE, method="rotation-spline", errors="drop")
    ours = reader.read_all()
    theirs = lake.scipy_loop(columns, count, RATE)
    for names, k in (([*lake.QUATERNION], 1), (["wx", "wy", "wz"], 2)):
        a, b = np.column_stack([ours[name].to_numpy() for name in names]), np.concatenate([each[k] for each in theirs])
        sign = np.sign((a * b).sum(axis=1, keepdims=True)) if k == 1 else 1.0
        found = np.abs(a - sign * b).max()
        if not found <= LARGEST_DIFFERENCE:
            raise SystemExit(f"benchmarks: {names[0]} of many tracks is off by {found:.3g}, wanted at most {LARGEST_DIFFERENCE:.3g}: not timed")


def on_this_machine(columns: dict[str, np.ndarray], sizes: tuple[Any, ...], folder: pathlib.Path) -> Iterator[str]:
    """Processor time beside SciPy, and the memory of one long track."""
    count, few, long = sizes[:3]
    loop = lake.processor_time(lambda: lake.scipy_loop(columns, few, RATE)) * count / few
    table = lake.in_no_order(columns)
    source = lake.parquet(table, folder, "keys")
    yield row(f"a loop over SciPy's `RotationSpline`, the curves alone (of {few} tracks, times {count // few})", loop, "s", None, True)
    for method, wanted in (("auto", 15), ("rotation-spline", None)):
        taken = lake.processor_time(lambda method=method: _drained(tables.resample(table, rate=RATE, method=method)))
        yield row(f"columns in memory, in no order, `{method}`: {taken:.2f} s", loop / taken, "×", wanted, True)
    (taken, rows), memory = lake.alone(lake.resampled_file, source, str(folder / "motion.parquet"), {"rate": RATE})
    yield row(f"Parquet to Parquet by DuckDB, {len(columns['t'])} keys to {rows} rows: {taken:.2f} s, {memory:.0f} MB", loop / taken, "×", 8, True)
    (taken, _), memory = lake.alone(_by_polars, source, str(folder / "motion.parquet"))
    yield row(f"the same by Polars: {taken:.2f} s, {memory:.0f} MB", loop / taken, "×", None, True)
    (taken, _), memory = lake.alone(_by_pyarrow, source, str(folder / "motion.parquet"))
    yield row(f"the same by pyarrow: {taken:.2f} s, {memory:.0f} MB", loop / taken, "×", None, True)
    one = lake.one_track(long)
    for title, place, options, most in (
            ("in order, `assume_sorted=True`", lake.parquet(one, folder, "one"), {"assume_sorted": True}, 500),
            ("in no order, `memory_limit=\"300MB\"`", lake.parquet(one.take(np.random.default_rng(2).permutation(long)), folder, "mixed"),
             {"memory_limit": "300MB"}, 600)):
        _, memory = lake.alone(lake.resampled_file, place, str(folder / "long.parquet"), {"rate": 10, **options})
        yield row(f"memory for one track of {long:.0e} keys {title}", memory, "MB", most, False)


def growth(totals: tuple[int, ...], counts: tuple[int, ...], folder: pathlib.Path) -> Iterator[str]:
    """Time and memory from Parquet to Parquet: of more keys in more tracks, then of the same keys in fewer and in more tracks."""
    yield from ("", "| tracks | keys | rows | processor time | for a million keys | memory |", "|---|---|---|---|---|---|")
    for total, count in (*((total, total // 50) for total in totals), *((totals[0], count) for count in counts)):
        columns = lake.tracks(count, total // count)
        source = lake.parquet(lake.in_no_order(columns), folder, "growth")
        (taken, rows), memory = lake.alone(lake.resampled_file, source, str(folder / "grown.parquet"), {"rate": GROWTH_RATE})
        keys = len(columns["t"])
        yield f"| {count} | {keys} | {rows} | {taken:.2f} s | {taken / keys * 1e6:.2f} s | {memory:.0f} MB |"


def _drained(reader: pa.RecordBatchReader) -> None:
    for _ in reader:
        pass


def _by_polars(source: str, place: str) -> tuple[float, int]:
    import polars
    return _written(lambda: polars.read_parquet(source).to_arrow(), place)  # a stream: of a frame comes a frame, in memory


def _by_pyarrow(source: str, place: str) -> tuple[float, int]:
    import pyarrow.parquet as pq
    return _written(lambda: pq.read_table(source), place)


def _written(read, place: str) -> tuple[float, int]:
    import time
    start = time.process_time()
    rows = tables.write(tables.resample(read(), rate=RATE), place).rows
    return time.process_time() - start, rows


def on_spark(columns: dict[str, np.ndarray], sizes: tuple[Any, ...], folder: pathlib.Path) -> Iterator[str]:
    """By the clock, best of three turns, on two workers with a core each."""
    count, _, _, giant, few = sizes[:5]
    sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[2] / "tests/python"))
    from spark_cluster import MEMORY, started
    session = started()
    import orispline.spark
    keys = session.read.parquet(lake.parquet(lake.in_no_order(columns), folder, "lake"))

    def save(df) -> None:
        df.write.mode("overwrite").parquet(str(folder / "spark"))

    shuffled = keys.repartition("track").sortWithinPartitions("track", "t")
    passing, all_rows = shuffled.mapInArrow(_passing, keys.schema), orispline.spark.resample(keys, rate=RATE)
    for title, done, wanted in (("computed and nothing written", _compute, 2), ("the rows, ten times as many, written as Parquet", save, None)):
        passed = lake.by_the_clock(lambda done=done: done(passing), 3)
        ours = lake.by_the_clock(lambda done=done: done(all_rows), 3)
        yield row(f"Spark, {count} tracks, {title}: {ours:.1f} s; the batches passed through: {passed:.1f} s", ours / passed, "×", wanted, False)
    some = keys.where(keys.track < few)
    job = orispline.spark.resample(some, rate=RATE)
    ours = lake.by_the_clock(lambda: _compute(job), 3)
    theirs = lake.by_the_clock(lambda: _compute(some.groupBy("track").applyInPandas(_of_pandas, job.schema)), 3)
    yield row(f"Spark, {few} tracks: {ours:.1f} s; `applyInPandas` with `Curve`: {theirs:.1f} s", ours / theirs, "×", 0.25, False)
    yield from _skewed(session, giant, folder, save, MEMORY)
    session.stop()


def _skewed(session, giant: int, folder: pathlib.Path, save, memory: int) -> Iterator[str]:
    """One track of so many keys among others: a single worker has it, while the other one has the rest."""
    others = {name: column + (1 if name == "track" else 0) for name, column in lake.tracks(AMONG).items()}
    table = pa.concat_tables([lake.one_track(giant), pa.table(others)])
    skewed = session.read.parquet(lake.parquet(table, folder, "skewed"))
    with lake.Watch("pyspark.daemon") as python, lake.Watch("CoarseGrainedExecutorBackend") as java:
        ours = lake.by_the_clock(lambda: save(orispline.spark.resample(skewed, rate=RATE)), 1)
    passed = lake.by_the_clock(lambda: save(skewed.repartition("track").sortWithinPartitions("track", "t").mapInArrow(_passing, skewed.schema)), 1)
    title = f"Spark, one track of {giant:.0e} keys ({giant * RATE // 10:.0e} samples) among {AMONG} of 50"
    yield row(f"{title}, written as Parquet: {ours:.0f} s; the batches passed through: {passed:.0f} s", ours / passed, "×", None, False)
    yield row(f"memory of a worker meanwhile: Python {python.most:.0f} MB, Java {java.most:.0f} MB", python.most + java.most, "MB", memory, False)


def _compute(df) -> None:
    """All of its rows, which go nowhere: what is timed is the job, not the disk."""
    df.write.format("noop").mode("overwrite").save()


def _passing(batches):
    yield from batches


def _of_pandas(frame):
    """What one would write for each track without tables."""
    import orispline
    import pandas
    frame = frame.sort_values("t")
    columns = ["track", "t", "qx", "qy", "qz", "qw", "wx", "wy", "wz", "error"]
    try:
        motion = orispline.Curve(frame["t"].to_numpy(), frame[["qx", "qy", "qz", "qw"]].to_numpy()).sample(rate=100, derivatives=1)
    except orispline.Error as error:
        return pandas.DataFrame([[frame["track"].iloc[0], *[None] * 8, str(error)]], columns=columns)
    made = pandas.DataFrame(motion.orientations, columns=columns[2:6])
    made[columns[6:9]] = motion.angular_velocities
    made.insert(0, "t", motion.times)
    made.insert(0, "track", frame["track"].iloc[0])
    made["error"] = None
    return made


def text(sizes: tuple[Any, ...]) -> Iterator[str]:
    columns = lake.tracks(sizes[0])
    hold_equal(columns, sizes[1])
    load = os.getloadavg()[0]
    with tempfile.TemporaryDirectory() as folder:
        rows = list(on_this_machine(columns, sizes, pathlib.Path(folder)))
        if sizes[3] and shutil.which("java"):
            rows += on_spark(columns, sizes, pathlib.Path(folder))
        grown = list(growth(*sizes[5:], pathlib.Path(folder)))
    versions = f"CPython {platform.python_version()}, SciPy {scipy.__version__}, pyarrow {pa.__version__}, DuckDB {duckdb.__version__}"
    yield f"{machine()}; {datetime.date.today().isoformat()}; {versions}; load {load:.1f} at the start and"
    yield f"{os.getloadavg()[0]:.1f} at the end."
    yield from ("", "| what | found | wanted | |", "|---|---|---|---|", *rows, *grown, "")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", choices=SIZES, default="full")
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    lines = list(text(SIZES[chosen.sizes]))
    print("\n".join(lines))
    if chosen.document:
        fill_block(chosen.document, START, END, lines)


if __name__ == "__main__":
    main()
