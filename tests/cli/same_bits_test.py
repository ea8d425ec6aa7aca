#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What commands print and write is the same to the byte where the system's library has no fused multiply-add: docs/conventions.md,
"The same bits everywhere"."""
import json
import math
import os
import pathlib
import random

from command import CommandTest, main
from small_scenes import BVH_HIERARCHY, elbow_angle, shoulder_angles

WITHOUT_FMA = os.environ | {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX2_Usable,-FMA_Usable"}  # glibc before 2.33 has the latter
EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples" / "data"


def strides():
    """The arm of small_scenes.py with two turns of its elbow, three strikes in a slow motion, and noise of 0.1° on every turn: what
    smooths each stretch by itself."""
    dice, frames = random.Random(20240229), 241
    hierarchy = BVH_HIERARCHY.replace("CHANNELS 3 Zrotation Xrotation Yrotation", "CHANNELS 2 Zrotation Xrotation")

    def strike(k):
        return 30 * math.exp(-((k % 80 - 40) / 2.5) ** 2)

    rows = ""
    for k in range(frames):
        z, x, y = shoulder_angles(k)
        turns = [z / 4 + strike(k), x / 4, y / 4 - strike(k + 3), elbow_angle(k) / 10 + strike(k + 6), x / 3]
        rows += " ".join(f"{number:.6f}" for number in (1, 2.5, 3, *(turn + dice.gauss(0, 0.1) for turn in turns))) + "\n"
    return f"{hierarchy}MOTION\nFrames: {frames}\nFrame Time: .0083333\n{rows}"


class SameBits(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("arm.bvh", strides())
        for name in ("five_keys.csv", "flight_keys.csv", "robot_keys.csv"):
            self.write(name, (EXAMPLES / name).read_text("utf-8"))

    def everything(self, arguments, environment):
        """What is printed, and the text of every file that is written, by name."""
        before = {path: path.stat().st_mtime_ns for path in self.folder.iterdir()}
        done = self.run_command(arguments, env=environment)
        self.assertEqual(done.returncode, 0, done.stderr)
        written = {path.name: path.read_bytes().decode("latin-1") for path in sorted(self.folder.iterdir())
                   if before.get(path) != path.stat().st_mtime_ns}
        return {"standard output": done.stdout, "standard error": done.stderr} | written

    def assert_same(self, *lines):
        for arguments in lines:
            with self.subTest(arguments):
                here, there = self.everything(arguments, os.environ), self.everything(arguments, WITHOUT_FMA)
                self.assertEqual(here.keys(), there.keys())
                for name, text in here.items():
                    differing = sum(a != b for a, b in zip(text.splitlines(), there[name].splitlines()))
                    self.assertTrue(text == there[name], f"{name}: {differing} lines differ")

    def test_samples_of_every_method(self):
        rows = [row for row in self.read("flight_keys.csv").splitlines(keepends=True) if not row.startswith("#")]
        self.write("keys.csv", "".join(rows[:1 + 3 * 12 + 1]))  # as many as bezier takes
        for method in json.loads(self.output_of("methods --json")):
            self.assert_same(f"sample keys.csv --method {method['name']} --rate 20 -o out.csv")

    def test_what_is_found_of_keys(self):
        self.assert_same("sample flight_keys.csv --method measured --band 0.9 --rate 20 --json -o out.csv",
                         "inspect robot_keys.csv --method timed-c2 --json",
                         "tune five_keys.csv --method timed-c2 -o out.csv",
                         "reduce flight_keys.csv --tolerance 1deg -o out.csv",
                         "reduce flight_keys.csv --tolerance 1deg --method hermite-c1 -o out.csv",
                         "retime robot_keys.csv --max-rate 90deg/s --max-acceleration 200deg/s2 -o out.csv",
                         "retime robot_keys.csv --max-rate 90deg/s --per-interval --json -o out.csv",
                         "plot five_keys.csv -o out.svg")

    def test_smoothed_recordings(self):
        self.assert_same("smooth arm.bvh --noise 0.1deg -o out.bvh", "smooth arm.bvh --penalty jerk -o out.bvh",
                         "sample arm.bvh --joint Shoulder --method stored --rate 120 -o turns.csv")
        for options in ("", "--penalty jerk", "--loss tukey", "--sigma", "--noise 0.3deg"):
            self.assert_same(f"smooth turns.csv {options} --json -o out.csv")

    def test_skeletons(self):
        self.assert_same("convert arm.bvh -o out.glb", "convert out.glb -o back.bvh", "difference arm.bvh back.bvh",
                         "reduce arm.bvh --tolerance 0.5deg --method cubicspline -o small.glb")


if __name__ == "__main__":
    main()
