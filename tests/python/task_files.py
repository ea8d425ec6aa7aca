# SPDX-License-Identifier: Apache-2.0
"""Files of keys as the tests of tasks take them, and what the command says of them."""
import csv
import json
import pathlib
import subprocess

import numpy as np
import orispline as ori

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
COMMAND = pathlib.Path(ori.__file__).parent / "bin/orispline"
GROUPS = {"positions": "px py pz", "angular_velocities": "wx wy wz", "angular_accelerations": "ax ay az"}


def columns_of(path):
    """The columns of a table, by name."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return {name: np.array([float(row[name]) for row in rows]) for name in rows[0]}


def group(columns, names):
    return np.column_stack([columns[name] for name in names.split()])


def keys_in(path, *with_rates):
    """The keys of a file, with positions and those rates."""
    columns = columns_of(path)
    wanted = [name for name in ("positions", *with_rates) if GROUPS[name].split()[0] in columns]
    return ori.Keys(columns["t"], group(columns, "qx qy qz qw"),
                    **{name: group(columns, GROUPS[name]) for name in wanted})


def run(*words):
    """What the command prints, and what it says besides."""
    done = subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True, check=True)
    return done.stdout, done.stderr


def json_of(*words):
    return json.loads(run(*words, "--json")[0])


def noisy_file(path, samples=300, outliers=()):
    """A recording at 100 Hz with noise of 0.5° per axis, as a file."""
    dice = np.random.default_rng(7)
    t = np.arange(samples) / 100
    half = np.column_stack([0.3 * np.sin(2 * t), 0.4 * np.sin(3 * t), 0.2 * t]) + dice.normal(size=(samples, 3)) * 0.0044
    half[list(outliers)] += 0.3
    angle = np.linalg.norm(half, axis=1, keepdims=True)
    q = np.column_stack([np.cos(angle), half * np.sinc(angle / np.pi)])
    with open(path, "w", encoding="utf-8") as file:
        file.write("t,qw,qx,qy,qz\n")
        for row in np.column_stack([t, q]):
            file.write(",".join(repr(float(x)) for x in row) + "\n")
    return path
