#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Python package beside SciPy, by processor time in one process: run.py [--sizes full|quick|smoke] [--document PAGE]

It prints a table, and with PAGE fills the block of that page between its own markers.
"""
import argparse
import datetime
import os
import pathlib
import platform
import random
import statistics
import subprocess
import sys
import time

os.environ |= {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}  # one thread, as ours
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1]))
import numpy as np  # noqa: E402
import scipy  # noqa: E402
from page_block import fill_block  # noqa: E402
from questions import SIZES, questions  # noqa: E402
from ratios import machine  # noqa: E402

START, END = "<!-- python: written by benchmarks/python/run.py -->\n", "<!-- end of python -->"
IMPORT_MS = 15  # beyond NumPy, at most
IMPORT = "import numpy, time; start = time.process_time(); import orispline; print(time.process_time() - start)"


def taken(work, calls):
    """Processor time of one call [s], in this process and all its threads."""
    start = time.process_time()
    for _ in range(calls):
        work()
    return (time.process_time() - start) / calls


def measured(rows, rounds):
    """Medians of ours and theirs, row by row; in each round all are measured, in an order of its own."""
    contenders = [(row, side) for row in range(len(rows)) for side in (0, 1)]
    found = {contender: [] for contender in contenders}
    dice = random.Random(1)
    for _ in range(rounds):
        dice.shuffle(contenders)
        for row, side in contenders:
            question = rows[row]
            found[row, side].append(taken((question.ours, question.theirs)[side], question.calls[side]))
    return [tuple(statistics.median(found[row, side]) for side in (0, 1)) for row in range(len(rows))]


def shown(seconds):
    for unit, size in (("s", 1.0), ("ms", 1e-3), ("µs", 1e-6)):
        if seconds >= size:
            break
    return f"{seconds / size:.3g} {unit}"


def table(rows, medians):
    yield from ("| what | orispline | SciPy | | wanted | |", "|---|---|---|---|---|---|")
    for row, (ours, theirs) in zip(rows, medians):
        ratio = theirs / ours
        verdict = "met" if ratio >= row.wanted else "**missed**"
        yield f"| {row.title} | {shown(ours)} | {shown(theirs)} | {ratio:.3g} × | ≥ {row.wanted:g} × | {verdict} |"


def importing(rounds):
    """Milliseconds of processor time."""
    return 1e3 * statistics.median(
        float(subprocess.run([sys.executable, "-c", IMPORT], capture_output=True, text=True, check=True).stdout) for _ in range(rounds))


def text(rows, medians, samples, load, import_ms):
    versions = f"CPython {platform.python_version()}, NumPy {np.__version__}, SciPy {scipy.__version__}"
    yield f"{machine()}; {datetime.date.today().isoformat()}; {versions}; load {load:.1f} at the start and"
    yield f"{os.getloadavg()[0]:.1f} at the end, of other programs too; {samples} times where there are many. Importing orispline takes"
    yield f"{import_ms:.1f} ms beyond NumPy (wanted: {IMPORT_MS} at most)."
    yield from ("", *table(rows, medians), "")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sizes", choices=SIZES, default="full")
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    load = os.getloadavg()[0]
    rows, rounds = questions(chosen.sizes)
    medians = measured(rows, rounds)
    lines = list(text(rows, medians, SIZES[chosen.sizes][0], load, importing(rounds)))
    print("\n".join(lines))
    if chosen.document:
        fill_block(chosen.document, START, END, lines)


if __name__ == "__main__":
    main()
