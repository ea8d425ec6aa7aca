#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes tests/data/euler.csv: Euler angles and their quaternions in all 24 orders, as SciPy computes them.

Needs SciPy (the project itself never does: the table is committed). Upper case: about the axes of the body; lower case:
about those of the world, which is SciPy's convention too.
"""
import itertools
import pathlib

import numpy
import scipy
from scipy.spatial.transform import Rotation

TARGET = pathlib.Path(__file__).resolve().parent.parent / "tests" / "data" / "euler.csv"
SEED = 20180101
PER_ORDER = 5


def orders():
    for case in ("XYZ", "xyz"):
        for a, b, c in itertools.product(case, repeat=3):
            if b not in (a, c):
                yield a + b + c


def main():
    random = numpy.random.default_rng(SEED)
    lines = [f"# Made by tools/make_euler_data.py (SciPy {scipy.__version__}, seed {SEED}): angles [rad] in the order of "
             "their turns.\n", "order,e1,e2,e3,qw,qx,qy,qz\n"]
    for order in orders():
        for _ in range(PER_ORDER):
            x, y, z, w = Rotation.random(random_state=random).as_quat()
            angles = Rotation.from_quat([x, y, z, w]).as_euler(order)
            numbers = [float(number) for number in (*angles, w, x, y, z)]
            lines.append(order + "," + ",".join(map(repr, numbers)) + "\n")
    TARGET.write_text("".join(lines), "utf-8")


if __name__ == "__main__":
    main()
