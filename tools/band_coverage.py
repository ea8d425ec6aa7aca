#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How often the band of `smooth --sigma` holds the truth: the table of docs/smooth.md.

Adds noise to recordings, which are taken for the truth, smooths them, and counts components of the turn to the truth
within 1.645 standard deviations, which nine in ten normal values are. Needs the recordings, by default beside the
checkout.

    tools/band_coverage.py COMMAND [--data FOLDER] [--seeds N]
"""
import argparse
import csv
import pathlib
import subprocess
import tempfile

from noisy_recordings import NOISES, RECORDINGS, recording, with_noise
from rotations import conjugate, times

ROOT = pathlib.Path(__file__).resolve().parent.parent
WITHIN = 1.6448536269514722  # standard deviations
ROWS = {"nothing stated": "", "`--noise`": "--noise {}deg", "`--penalty jerk`": "--penalty jerk", "`--no-adapt`": "--no-adapt"}


def components(found, wanted):
    """Of the small turn from one orientation to the other [rad], body frame."""
    w, *v = times(conjugate(found), wanted)
    return [2 * x if w > 0 else -2 * x for x in v]


def held(command, clean, noise, seed, options, folder):
    """For each axis, the share of the samples within."""
    with_noise(clean, noise, seed).write(folder / "noisy.csv")
    subprocess.run([command, "smooth", "noisy.csv", "--sigma", *options.format(noise).split(), "--quiet", "-o", "smooth.csv"],
                   cwd=folder, check=True)
    with open(folder / "smooth.csv", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    counts = [0, 0, 0]
    for row, wanted in zip(rows, clean.orientations, strict=True):
        turn = components(tuple(float(row[c]) for c in ("qw", "qx", "qy", "qz")), wanted)
        for axis, name in enumerate(("sigma_x", "sigma_y", "sigma_z")):
            counts[axis] += abs(turn[axis]) <= WITHIN * float(row[name])
    return [count / len(rows) for count in counts]


def cell(command, clean, noise, seeds, options, folder):
    shares = [held(command, clean, noise, seed, options, folder) for seed in range(seeds)]
    return " ".join(f"{100 * sum(axis) / seeds:.0f}" for axis in zip(*shares))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("--data", type=pathlib.Path, default=ROOT.parent / "shared" / "data")
    parser.add_argument("--seeds", type=int, default=1)
    options = parser.parse_args()
    print("| | " + " | ".join(RECORDINGS) + " |\n|" + "---|" * (len(RECORDINGS) + 1))
    clean = {name: recording(name, options.data) for name in RECORDINGS}
    with tempfile.TemporaryDirectory() as folder:
        for title, words in ROWS.items():
            cells = (" / ".join(cell(options.command.resolve(), clean[name], noise, options.seeds, words, pathlib.Path(folder))
                                for noise in NOISES) for name in RECORDINGS)
            print(f"| {title} | " + " | ".join(cells) + " |", flush=True)


main()
