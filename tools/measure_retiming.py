#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Durations within limits beside those of Ruckig, in docs/retime.md, measured.

measure_retiming.py COMMAND runs COMMAND, the built orispline, and Ruckig (`pip install ruckig`), and rewrites the lines between
`<!-- measured: tools/measure_retiming.py -->` and `<!-- end of what is measured -->`.
"""
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

import ruckig

ROOT = pathlib.Path(__file__).resolve().parents[1]
PAGE = ROOT / "docs/retime.md"
BLOCK = re.compile(r"(<!-- measured: tools/measure_retiming.py -->\n).*?(<!-- end of what is measured -->)", re.S)
ROBOT = ROOT / "examples/data/robot_keys.csv"
RATE, ACCELERATION, JERK = 90, 200, 2000  # deg/s and so on
REST = 1e-5  # rad: a smaller step is a rest
LIMITS = ["--max-rate", f"{RATE}deg/s", "--max-acceleration", f"{ACCELERATION}deg/s2", "--max-jerk", f"{JERK}deg/s3"]


def turn_by_ruckig(angle):
    """The least duration of a turn by so many radians about one axis, from rest to rest."""
    wanted = ruckig.InputParameter(1)
    wanted.target_position = [angle]
    wanted.max_velocity, wanted.max_acceleration, wanted.max_jerk = (
        [math.radians(limit)] for limit in (RATE, ACCELERATION, JERK))
    found = ruckig.Trajectory(1)
    if ruckig.Ruckig(1).calculate(wanted, found) != ruckig.Result.Working:
        sys.exit("Ruckig found no trajectory")
    return found.duration


def steps_of(path):
    """The angle and the duration of each step between keys."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    keys = [(float(row["t"]), [float(row[name]) for name in ("qw", "qx", "qy", "qz")]) for row in rows]
    for (start, p), (end, q) in zip(keys, keys[1:]):
        near = math.dist(p, q) if math.dist(p, q) < 1 else math.dist(p, [-x for x in q])
        yield 4 * math.asin(min(near / 2, 1)), end - start


def duration_by_us(command, keys, *options):
    with tempfile.TemporaryDirectory() as folder:
        return json.loads(subprocess.run([command, "retime", keys, *LIMITS, *options, "-o", f"{folder}/out.csv", "--json"],
                                         capture_output=True, check=True).stdout)["duration_after_s"]


def main(command):
    with tempfile.TemporaryDirectory() as folder:
        turn = pathlib.Path(folder) / "turn.csv"
        turn.write_text(f"t,qw,qx,qy,qz\n0,1,0,0,0\n1,{math.sqrt(0.5)!r},{math.sqrt(0.5)!r},0,0\n", "utf-8")
        ours = {method: duration_by_us(command, turn, "--method", method, "--ends", "rest")
                for method in ("timed-c2", "timed-c3")}
    steps = list(steps_of(ROBOT))
    stops = sum(turn_by_ruckig(angle) if angle > REST else duration for angle, duration in steps)
    rows = [("a quarter turn, rest to rest", f"{turn_by_ruckig(math.pi / 2):.2f} s",
             ", ".join(f"{duration:.2f} s with `{method}`" for method, duration in ours.items())),
            (f"the robot's {len(steps) + 1} keys", f"{stops:.1f} s, with a stop at every key",
             f"{duration_by_us(command, ROBOT):.1f} s uniformly, {duration_by_us(command, ROBOT, '--per-interval'):.1f} s "
             "with `--per-interval`, with stops at the rests only")]
    text = f"Within {RATE}°/s, {ACCELERATION}°/s² and {JERK}°/s³:\n\n| motion | Ruckig {ruckig.__version__} | orispline |\n|---|---|---|\n"
    text += "".join(f"| {' | '.join(row)} |\n" for row in rows)
    PAGE.write_text(BLOCK.sub(lambda found: found[1] + text + found[2], PAGE.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
