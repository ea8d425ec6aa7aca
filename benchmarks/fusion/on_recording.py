#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A gyro beside an optical reference to which noise was added: on_recording.py COMMAND BROAD.csv [--seeds FIRST COUNT]

Orientations ten times a second with 1° of noise per axis, the gyro as it was recorded. The clocks differ: the truth is the reference.
"""
import argparse
import pathlib
import tempfile

import numpy as np
from scipy.spatial.transform import Rotation

import command
from recordings import DEGREE, Recording


def recorded(path, seed):
    table = np.genfromtxt(path, delimiter=",", skip_header=1)
    table = table[np.isfinite(table).all(1)]
    times, truth = table[:, 0], Rotation.from_quat(table[:, [2, 3, 4, 1]])
    at = np.unique(np.searchsorted(times, np.arange(times[0], times[-1], 0.1)))
    off = np.random.default_rng(seed).normal(size=(len(at), 3)) * DEGREE
    return Recording(
        times, truth, table[:, 5:8], times, table[:, 5:8], at, truth[at] * Rotation.from_rotvec(off), np.zeros(0), off, np.ones(0), True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("recording", type=pathlib.Path)
    parser.add_argument("--seeds", type=int, nargs=2, default=(100, 10), metavar=("FIRST", "COUNT"))
    chosen = parser.parse_args()
    print("seed, error with the gyro [°], said over true error, 90 % band holds [%], error without [°]")
    rows = []
    for seed in range(chosen.seeds[0], sum(chosen.seeds)):
        with tempfile.TemporaryDirectory() as folder:
            case = chosen.command.resolve(), pathlib.Path(folder), recorded(chosen.recording, seed)
            gyro, alone = command.with_gyro(*case), command.without_gyro(*case)
        rows.append((gyro.error, gyro.said, 100 * gyro.held, alone.error))
        print(f"{seed}, {', '.join(f'{value:.3g}' for value in rows[-1])}{'' if gyro.used else ', left out'}", flush=True)
    print("mean,", ", ".join(f"{value:.3g}" for value in np.mean(rows, 0)))


if __name__ == "__main__":
    main()
