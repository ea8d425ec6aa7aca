#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Orientations and a gyro beside the truth: run.py COMMAND [--seeds FIRST COUNT] [--tables NAME...] [--rows WORD] [--jobs N] [--document PAGE]

`orispline smooth` with a gyro and without, the filter VQF, and the least error that is possible, on simulated recordings. It prints two
tables, and with PAGE fills the blocks of that page between their markers.
"""
import argparse
import concurrent.futures
import dataclasses
import functools
import os
import pathlib
import sys
import tempfile
from collections.abc import Callable

os.environ |= {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1]))
import numpy as np  # noqa: E402
import bound  # noqa: E402
import command  # noqa: E402
import recordings as made  # noqa: E402
import vqf_peer  # noqa: E402
from page_block import fill_block  # noqa: E402

ACCURACY = made.Setting(60, 200, 20, 1.5, every=20, pose_noise=1.0, rate_noise=0.1, bias=0.5, walk=0.003, scale=0.005)
FAULTS = made.Setting(20, 100, 50, 1.2, every=1, pose_noise=0.5, rate_noise=0.3, bias=0.7)


@dataclasses.dataclass(frozen=True)
class Row:
    title: str
    setting: made.Setting
    fault: Callable | None = None
    is_missing: bool = False  # the bound is told which rates are


def correlated(seconds):
    return dataclasses.replace(FAULTS, pose_noise=1.0, correlation=seconds)


TABLES = {
    "accuracy": [Row(f"{turning} °/s", dataclasses.replace(ACCURACY, turning=turning)) for turning in (20, 80)],
    "faults": [
        Row("none", FAULTS),
        Row("scale +2 %", FAULTS, functools.partial(made.scaled, 0.02)),
        Row("scale +10 %", FAULTS, functools.partial(made.scaled, 0.1)),
        Row("mount off by 1°", FAULTS, functools.partial(made.mounted, 1.0)),
        Row("mount off by 3°", FAULTS, functools.partial(made.mounted, 3.0)),
        Row("bias drifts by 5 °/s", FAULTS, made.drifts),
        Row("bias steps by 3 °/s", FAULTS, made.steps),
        Row("clock steps by 50 ms", FAULTS, made.clock_steps),
        Row("clock 500 ppm fast", FAULTS, functools.partial(made.clock_runs, 500e-6)),
        Row("clock 100 ppm fast, 120 s", dataclasses.replace(FAULTS, span=120), functools.partial(made.clock_runs, 100e-6)),
        Row("batches of 10 stamps", FAULTS, made.batches),
        Row("counters that wrap", FAULTS, made.wraps),
        Row("stuck for 5 s", FAULTS, made.sticks, is_missing=True),
        Row("clipped at 70 %", FAULTS, made.clips, is_missing=True),
        Row("four drop-outs of 0.5 s", FAULTS, made.drops_out, is_missing=True),
        Row("one dead axis", FAULTS, made.loses_axis, is_missing=True),
        *(Row(f"orientations: 1° correlated over {seconds:g} s", correlated(seconds)) for seconds in (0.2, 1.0, 5.0)),
    ],
}
HEADER = (
    "| | bound | without a gyro | VQF | with the gyro | worst (seed) | left out | said over true error | within 0.7 to 1.4 (bound) | 90 % band holds | |",
    "|---|---|---|---|---|---|---|---|---|---|---|")
MOST = {"accuracy": (1.15, 1.5), "faults": (1.5, np.inf)}  # in the mean and at worst, over the bound


@functools.cache
def error_without_gyro(executable, setting, seed):
    """[°]; faults of a gyro do not change it."""
    with tempfile.TemporaryDirectory() as folder:
        return command.without_gyro(executable, pathlib.Path(folder), made.recorded(setting, seed)).error


def measured(row, executable, seeds):
    """Of every seed: the bound [°], and over it the errors without a gyro, of VQF and with the gyro; whether it was left out, said over true, held."""
    all_recordings = [made.recorded(row.setting, seed) for seed in seeds]
    if row.fault:
        for recording in all_recordings:
            row.fault(recording)
    least = (bound.error_of_missing if row.is_missing else bound.error)(row.setting, all_recordings)
    result = []
    with tempfile.TemporaryDirectory() as folder:
        for seed, recording, best in zip(seeds, all_recordings, least):
            gyro = command.with_gyro(executable, pathlib.Path(folder), recording)
            alone = error_without_gyro(executable, row.setting, seed)
            result.append((best, alone / best, vqf_peer.error(recording) / best, gyro.error / best, not gyro.used, gyro.said or np.nan, gyro.held))
    return np.array(result, float)


def verdict(table, means, worst, left_out, within):
    most, most_at_worst = MOST[table]
    misses = [
        text for text, is_missed in (
            (f"mean above {most}", means[3] > most), (f"worst above {most_at_worst}", worst > most_at_worst), ("lost", left_out),
            ("behind VQF", means[3] >= means[2]), ("behind none", means[3] > means[1]), ("said", within < 0.9)) if is_missed]
    return f"**missed**: {', '.join(misses)}" if misses else "met"


def share_within(said):
    return ((said >= 0.7) & (said <= 1.4)).mean()


def line(table, row, found, seeds):
    means, said = found.mean(0), found[:, 5]
    within, best_within = share_within(said), share_within(np.sqrt((found[:, 0] ** 2).mean()) / found[:, 0])
    cells = (
        row.title, f"{means[0]:.3f}°", *(f"{mean:.2f}" for mean in means[1:4]), f"{found[:, 3].max():.2f} ({seeds[found[:, 3].argmax()]})", f"{found[:, 4].sum():.0f}",
        f"{np.nanmin(said):.2f} to {np.nanmax(said):.2f}", f"{100 * within:.0f} % ({100 * best_within:.0f} %)", f"{100 * means[6]:.0f} %",
        verdict(table, means, found[:, 3].max(), found[:, 4].sum(), within))
    return f"| {' | '.join(cells)} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("--seeds", type=int, nargs=2, default=(100, 20), metavar=("FIRST", "COUNT"))
    parser.add_argument("--rows", default="", help="only those whose title has this word")
    parser.add_argument("--tables", choices=TABLES, nargs="+", default=[*TABLES])
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    seeds = range(chosen.seeds[0], sum(chosen.seeds))
    with concurrent.futures.ProcessPoolExecutor(chosen.jobs) as pool:
        asked = {
            table: [(row, pool.submit(measured, row, chosen.command.resolve(), seeds)) for row in rows if chosen.rows in row.title]
            for table, rows in TABLES.items() if table in chosen.tables}
        for table, rows in asked.items():
            print(*HEADER, sep="\n", flush=True)
            lines = []
            for row, answer in rows:
                lines.append(line(table, row, answer.result(), seeds))
                print(lines[-1], flush=True)
            if chosen.document:
                start, end = f"<!-- {table}: written by benchmarks/fusion/run.py -->\n", f"<!-- end of {table} -->"
                fill_block(chosen.document, start, end, [*HEADER, *lines, ""])


if __name__ == "__main__":
    main()
