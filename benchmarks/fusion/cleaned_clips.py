#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Motion capture that is cleaned: cleaned_clips.py COMMAND WALK.bvh [CLIP.bvh:FIRST:COUNT]... [--seeds FIRST COUNT] [--jobs N] [--document PAGE]

`orispline smooth`, as it is and with `--keep-contacts auto`, stands beside Butterworth's filter, Savitzky and Golay's and the One-Euro filter,
where arms are swapped with and without Hampel's filter before them. Each has, in each cell, the one setting for all joints and the root that
brings all joints nearest to their true places in the world. The noise is 1° of each joint that moves and 5 mm of the root, white or correlated, with the arms swapped for 8 to 12
frames, twice in a clip, or without. WALK is the bundled walk, whose truth is the motion that it was made from; one unit of other clips is that of the CMU
library, 0.0254/0.45 m. With PAGE the table between the markers there is filled.
"""
import argparse
import concurrent.futures
import functools
import os
import pathlib
import sys
import tempfile

os.environ |= {name: "1" for name in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS")}
sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1]))
import numpy as np  # noqa: E402

import figures  # noqa: E402
from filters import FILTERS, HALF_WINDOWS, columns_of, hampel, motion_of  # noqa: E402
from on_clips import smoothed_file, sound  # noqa: E402
from page_block import fill_block  # noqa: E402

TIMES = (0.0, 0.02, 0.05, 0.1, 0.2)  # of the noise [s]; 0: white
DEGREES, METRES, SWAPS = 1.0, 0.005, 2
UNIT_OF_CMU = 0.0254 / 0.45
HEADER = ("| noise | input | best filter | `smooth` | `--keep-contacts` | slide of the truth | world over the best filter, mean and worst "
          "| the same with `--keep-contacts` |", "|---|---|---|---|---|---|---|---|")
WAYS = {"smooth": [], "--keep-contacts": ["--keep-contacts", "auto"]}


@functools.cache
def figure_of(word):
    path, *part = word.split(":")
    if pathlib.Path(path).name == "walking.bvh":
        return figures.SimulatedWalk(path)
    return figures.Figure(path, UNIT_OF_CMU, *map(int, part))


class Truth:
    """What a motion is measured by."""

    def __init__(self, figure):
        self.figure, self.rotations = figure, figure.rotations()
        self.world = figure.world(self.rotations, figure.place)
        self.standing = figures.standing(figure, self.world)
        self.sound = [sound(rotation) for rotation in self.rotations]
        self.slide = figures.slide(figure, self.world, self.standing)

    def errors(self, rotations, place):
        """Root mean squares of joints [°] and of their places in the world [mm], and the slide of feet that stand [mm/s]. Angles are without
        frames in which a marker of the clip itself is a fault."""
        world = self.figure.world(rotations, place)
        angles = np.concatenate([(a.inv() * b).magnitude()[good] for a, b, good in zip(rotations, self.rotations, self.sound)])
        away = ((world - self.world) ** 2).sum(-1)
        return np.degrees(np.sqrt((angles**2).mean())), 1e3 * np.sqrt(away.mean()), figures.slide(self.figure, world, self.standing)


def best(truth, columns, interval, method, half_windows):
    """The errors with the setting of the least error in the world."""
    function, settings = FILTERS[method]
    tried = []
    for half_window in half_windows:
        before = columns if half_window is None else hampel(columns, half_window)
        tried += [truth.errors(*motion_of(function(before, interval, setting))) for setting in settings]
    return min(tried, key=lambda errors: errors[1])


def measured(command, word, time, swaps, seed):
    """Errors by the names of what was tried."""
    figure = figure_of(word)
    truth, rng = Truth(figure), np.random.default_rng(seed)
    rotations, place = figures.disturbed(figure, rng, time, DEGREES, METRES)
    if swaps:
        rotations = figures.swapped(figure, rng, rotations, swaps)
    errors = {"truth": (0.0, 0.0, truth.slide), "input": truth.errors(rotations, place)}
    columns = columns_of(rotations, place)
    for method in FILTERS:
        errors[method] = best(truth, columns, figure.interval, method, (None,))
        if swaps:
            errors[f"Hampel, {method}"] = best(truth, columns, figure.interval, method, HALF_WINDOWS[1:])
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = figure.write_with(folder / "noisy.bvh", rotations, place)
        for way, words in WAYS.items():
            out = figures.Figure(smoothed_file(command, folder, path, words), figure.unit)
            errors[way] = truth.errors(out.rotations(), out.place)
    return errors


def row_of(name, cells):
    """Of the cells of one noise: means, and the worlds of both ways over the best filter of each cell."""
    names = list(cells[0])
    filters = [name for name in names if name not in ("truth", "input", *WAYS)]
    mean = {name: np.mean([cell[name] for cell in cells], axis=0) for name in names}
    best_filter = min(filters, key=lambda name: mean[name][1])
    worlds = [[cell[way][1] / min(cell[name][1] for name in filters) for cell in cells] for way in WAYS]
    return (f"| {name} | {text(mean['input'])} | {best_filter}: {text(mean[best_filter])} | {text(mean['smooth'])} | {text(mean['--keep-contacts'])} "
            f"| {mean['truth'][2]:.0f} | " + " | ".join(f"{np.mean(world):.2f}, {np.max(world):.2f}" for world in worlds) + " |")


def text(errors):
    return f"{errors[0]:.2f}° / {errors[1]:.1f} / {errors[2]:.0f}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("clips", nargs="+")
    parser.add_argument("--seeds", type=int, nargs=2, default=(100, 3), metavar=("FIRST", "COUNT"))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    cases = {(time, swaps): [(chosen.command.resolve(), word, time, swaps, seed)
                             for word in chosen.clips for seed in range(chosen.seeds[0], sum(chosen.seeds))]
             for time in TIMES for swaps in (0, SWAPS)}
    lines = ["", *HEADER]
    with concurrent.futures.ProcessPoolExecutor(chosen.jobs) as pool:
        for (time, swaps), calls in cases.items():
            name = (f"{1e3 * time:g} ms" if time else "white") + (", swaps" if swaps else "")
            lines.append(row_of(name, list(pool.map(measured, *zip(*calls)))))
            print(lines[-1], flush=True)
    if chosen.document:
        fill_block(chosen.document, "<!-- cleaned clips -->\n", "<!-- end of cleaned clips -->", [*lines, "", ""])


if __name__ == "__main__":
    main()
