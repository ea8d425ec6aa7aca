#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The table of docs/smooth.md anew: noise of several sizes on recordings, smoothed by the command, against the recording.

Needs the recordings of README in --data (by default ../shared/data beside the checkout) and numpy.

    tools/smoothing_table.py COMMAND [--data FOLDER] [--seeds N]
"""
import argparse
import csv
import pathlib
import subprocess
import tempfile

import numpy

ROOT = pathlib.Path(__file__).resolve().parent.parent
COUNT = 1500
RECORDINGS = {
    "BROAD": ("imu/broad_06_undisturbed_fast_rotation_A_40s.csv", "t_s opt_qw opt_qx opt_qy opt_qz", "gyr_{}_rad_s", 1.0),
    "PX4": ("flight/px4_quad_sample_attitude.csv", "t_s qw qx qy qz", "w{}_body_rad_s", 1.0),
    "MRO": ("spacecraft/mro_ck_sliced_-74000.csv", "sclk_ticks q0_w q1 q2 q3", None, 1 / 256),
}
WAYS = {"GCV": "--loss l2", "noise stated": "--loss l2 --noise {}deg", "robust": "", "jerk, GCV": "--loss l2 --penalty jerk",
        "gyro": "--loss l2 --noise {}deg --gyro --gyro-noise {}deg"}
GYRO_NOISE = {"BROAD": 5.1, "PX4": 0.05}


def product(a, b):
    w, v, u, s = a[:, :1], a[:, 1:], b[:, :1], b[:, 1:]
    return numpy.hstack([w * u - (v * s).sum(1, keepdims=True), w * s + u * v + numpy.cross(v, s)])


def exponential(v):
    angle = numpy.linalg.norm(v, axis=1, keepdims=True)
    return numpy.hstack([numpy.cos(angle / 2), v * numpy.sinc(angle / 2 / numpy.pi) / 2])


def angles(a, b):
    d = product(a * [1, -1, -1, -1], b)
    return 2 * numpy.arctan2(numpy.linalg.norm(d[:, 1:], axis=1), abs(d[:, 0]))


def recording(name, data):
    path, columns, rates, unit = RECORDINGS[name]
    names = columns.split() + ([rates.format(axis) for axis in "xyz"] if rates else [])
    with open(data / path, encoding="utf-8") as file:
        rows = numpy.array([[float(row[n] or "nan") for n in names] for row in csv.DictReader(file)])
    rows = rows[:: 3 if name == "BROAD" else 1]
    rows = rows[numpy.isfinite(rows).all(axis=1)]
    rows[:, 0] = (rows[:, 0] - rows[0, 0]) * unit
    rows[:, 1:5] /= numpy.linalg.norm(rows[:, 1:5], axis=1, keepdims=True)
    if name == "MRO":  # world to body
        rows[:, 2:5] *= -1
    if name != "PX4":
        return rows[:COUNT]
    travelled = numpy.concatenate([[0], numpy.cumsum(angles(rows[:-1, 1:5], rows[1:, 1:5]))])
    first = numpy.argmax(travelled[COUNT - 1:] - travelled[: len(rows) - COUNT + 1])
    return rows[first: first + COUNT]


def error(command, way, clean, noise, seed, folder):
    noisy = clean.copy()
    turn = numpy.random.default_rng(seed).normal(size=(len(clean), 3)) * numpy.radians(noise)
    noisy[:, 1:5] = product(clean[:, 1:5], exponential(turn))
    head = "t,qw,qx,qy,qz" + (",wx,wy,wz" if clean.shape[1] > 5 else "")
    numpy.savetxt(folder / "noisy.csv", noisy, "%.17g", ",", header=head, comments="")
    subprocess.run([command, "smooth", "noisy.csv", *way.split(), "--quiet", "-o", "smooth.csv"], cwd=folder, check=True)
    found = numpy.loadtxt(folder / "smooth.csv", delimiter=",", skiprows=1)
    return numpy.degrees(numpy.sqrt(numpy.mean(angles(found[:, 1:5], clean[:, 1:5]) ** 2)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("--data", type=pathlib.Path, default=ROOT.parent / "shared" / "data")
    parser.add_argument("--seeds", type=int, default=3)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for name in RECORDINGS:
            clean = recording(name, options.data)
            for title, way in WAYS.items():
                if "gyro" in way and name not in GYRO_NOISE:
                    continue
                cells = []
                for noise in (0.2, 1, 3):
                    words = way.format(noise, GYRO_NOISE.get(name))
                    errors = [error(options.command.resolve(), words, clean, noise, seed, pathlib.Path(folder))
                              for seed in range(options.seeds)]
                    cells.append(f"{numpy.mean(errors):.3g}")
                print(f"{name:6} {title:13} {' / '.join(cells)}", flush=True)


main()
