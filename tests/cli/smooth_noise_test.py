#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline smooth` where the noise changes: stated in columns, found stretch by stretch, and single rows far off under Tukey's loss.

The recordings are not part of the project: they are read where they lie beside it.
"""
import csv
import json
import os
import pathlib
import re
import sys
import unittest

from command import BAD_DATA, BAD_USAGE, CommandTest, main

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from motions.noisy_recordings import rms_degrees
from motions.rotations import DEGREE, times, turn

CASES = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data")).parent / "cases/recordings"
HALF, ALLOWED = 100, 1.15


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def orientations(path):
    return [tuple(float(row[name]) for name in ("qw", "qx", "qy", "qz")) for row in rows_of(path)]


@unittest.skipUnless(CASES.is_dir(), f"no {CASES}")
class SmoothNoise(CommandTest):
    def smoothed(self, rows, names, *options):
        """What is told of rows with these columns, and the orientations that are written."""
        self.write("rows.csv", ",".join(names) + "\n" + "".join(",".join(row[name] for name in names) + "\n" for row in rows))
        told = json.loads(self.output_of(["smooth", "rows.csv", "--json", *options, "-o", "out.csv"]))
        return told, orientations(self.folder / "out.csv")

    def assert_halves_as_if_alone(self, rows, names, found):
        truth = orientations(CASES / "32_true.csv")
        for part in (slice(0, HALF), slice(HALF, None)):
            with self.subTest(part):
                _, alone = self.smoothed(rows[part], names[:5])
                self.assertLessEqual(rms_degrees(found[part], truth[part]), ALLOWED * rms_degrees(alone, truth[part]))

    def test_columns_weigh_the_samples(self):
        rows = rows_of(CASES / "32_weights.csv")
        plain = ["t", "qw", "qx", "qy", "qz"]
        told, by_degrees = self.smoothed(rows, [*plain, "sigma_deg"])
        self.assertAlmostEqual(told["least_noise_rad"], 0.1 * DEGREE, delta=1e-9)
        self.assertAlmostEqual(told["largest_noise_rad"], 3.0 * DEGREE, delta=1e-9)
        self.assert_halves_as_if_alone(rows, plain, by_degrees)
        for row in rows:
            sigma = float(row["sigma_deg"]) * DEGREE
            row.update({"sigma": repr(sigma)} | {f"sigma_{axis}": repr(sigma) for axis in "xyz"} | {f"cov_{axis}{axis}": repr(sigma**2) for axis in "xyz"})
        for names in (["sigma"], ["sigma_x", "sigma_y", "sigma_z"], ["cov_xx", "cov_yy", "cov_zz"]):
            with self.subTest(names):
                self.assertLess(rms_degrees(self.smoothed(rows, [*plain, *names])[1], by_degrees), 1e-6)
        self.assertNotIn("sigma", self.read("out.csv").split("\n")[0] + self.read("out.csv").split("\n")[1])

    def test_bad_columns_are_refused(self):
        keys = "t,qw,qx,qy,qz,{}\n0,1,0,0,0,{}\n1,1,0,0,0,{}\n2,1,0,0,0,{}\n3,1,0,0,0,{}\n"
        for cells, message in ((("0.1", "0", "0.1", "0.1"), "keys.csv:3: key 1: sigma: found 0, wanted a finite number above 0"),
                               (("0.1", "0.1", "-2", "0.1"), "keys.csv:4: key 2: sigma: found -2, wanted a finite number above 0")):
            self.write("keys.csv", keys.format("sigma", *cells))
            self.assert_fails("smooth keys.csv -o out.csv", BAD_DATA, message)
        self.write("keys.csv", keys.format("sigma", *4 * ["0.1"]))
        self.assert_fails("smooth keys.csv --noise 1deg -o out.csv", BAD_USAGE,
                          "--noise: found the noise of every sample in the recording as well, wanted one of them")
        self.write("keys.csv", keys.format("sigma_x", *4 * ["0.1"]))
        self.assert_fails("smooth keys.csv -o out.csv", BAD_DATA, "keys.csv: found no sigma_y, wanted it beside the noise of the other axes")

    def test_noise_that_changes_is_found(self):
        rows = rows_of(CASES / "32_weights.csv")
        told, found = self.smoothed(rows, ["t", "qw", "qx", "qy", "qz"])
        self.assertAlmostEqual(told["least_noise_rad"] / DEGREE, 0.1, delta=0.02)
        self.assertAlmostEqual(told["largest_noise_rad"] / DEGREE, 3.0, delta=0.6)
        self.assert_halves_as_if_alone(rows, ["t", "qw", "qx", "qy", "qz"], found)
        self.assertIsNone(self.smoothed(rows[:HALF], ["t", "qw", "qx", "qy", "qz"])[0]["least_noise_rad"])

    def test_swapped_markers_are_told_of_with_the_option_that_leaves_them_out(self):
        path, truth = str(CASES / "11_swap.csv"), orientations(CASES / "11_true.csv")
        done = self.run_command(["smooth", path, "-o", "out.csv"])
        self.assertRegex(done.stderr, r"11_swap\.csv:302: key 300: 6 samples turn by more than 90° from the one before and are followed as motion; "
                                      r"if they are faults, as where markers were swapped, set --loss to huber\n")
        self.output_of(["smooth", path, "--loss", "huber", "-o", "out.csv"])
        self.assertLessEqual(rms_degrees(orientations(self.folder / "out.csv"), truth), 0.1)

    def test_one_row_far_off_is_one_that_tukey_rejects(self):
        rows, truth = rows_of(CASES / "41_tukey.csv"), orientations(CASES / "11_true.csv")
        names = ["t", "qw", "qx", "qy", "qz"]
        bad = HALF
        for degrees in (45, 90, 170):
            q = times(truth[bad], turn((0.0, 0.6, 0.8), degrees * DEGREE))
            rows[bad].update(zip(names[1:], map(repr, q)))
            for options in ((), ("--no-adapt",)):
                with self.subTest(degrees=degrees, options=options):
                    told, found = self.smoothed(rows, names, "--loss", "tukey", *options)
                    self.assertEqual([sample["line"] for sample in told["rejected"]], [bad + 2])
                    self.assertLessEqual(rms_degrees(found, truth[:len(found)]), 0.03)



@unittest.skipUnless((CASES.parent / "reports").is_dir(), "no reports of users")
class Flips(CommandTest):
    def test_what_the_default_follows_it_says_first(self):
        """A tag that flips by 35° to both sides in 15 % of the rows."""
        flips = str(CASES.parent / "reports/r25_flips.csv")
        self.assertRegex(self.run_command(["smooth", flips, "-o", "out.csv"]).stderr,
                         r"\Aorispline: warning: \S+: key 68: 16 samples as far as the 53 that are rejected are followed as motion; .*, set --loss to huber\n")
        self.assertNotIn("warning", self.run_command(["smooth", flips, "--loss", "huber", "-o", "out.csv"]).stderr)


class NoiseTime(CommandTest):
    WALK = str(ROOT / "examples/data/walking.bvh")

    def test_noise_that_could_be_hidden_is_told_of_and_stated_noise_in_its_place(self):
        arguments = ["smooth", self.WALK, "--joint", "RightLeg", "-o", "out.csv"]
        self.assertRegex(self.run_command(arguments).stderr, r"\n  correlated    it would stay in the motion; up to 0\.\d+° could be hidden there, if correlated over 0\.083 s\n")
        stated = self.run_command([*arguments, "--noise-time", "50ms", "--noise", "0.5deg"]).stderr
        self.assertRegex(stated, r"\nnoise           0\.5° per axis, correlated over 0\.05 s; 0\.25\d*° between neighbours\n(?!  correlated)")
        told = json.loads(self.output_of([*arguments, "--noise-time", "50ms", "--json"]))
        self.assertEqual((told["correlation_time_s"], told["hidden_noise_rad"], told["correlated_noise_rad"]), (0.05, None, told["noise_rad"]))

    def test_the_joints_of_a_clip_share_it(self):
        summary = self.run_command(["smooth", self.WALK, "--noise-time", "20ms", "-o", "out.bvh"]).stderr
        noise = re.search(r"\nnoise           (\S+°) per axis of all joints, correlated over 0\.02 s, as stated\n", summary)[1]
        self.assertEqual(set(re.findall(r" s +(\S+°) +\d+ +\S+°\n", summary)), {noise})
        self.assertNotIn("of all joints", self.run_command(["smooth", self.WALK, "-o", "out.bvh"]).stderr, "it is white")

    def test_what_contradicts_it_is_refused(self):
        for words, message in (("--noise-time 0", "--noise-time: found '0', wanted a number greater than 0, in ms, s or min, such as 1ms"),
                               ("--noise-time 1s", "--noise-time: found 1 s, wanted at most 0.6 s, a quarter of the recording, which cannot tell slower noise from motion; "
                                                   "state less, or record for longer"),
                               ("--noise-time 50ms --smoothing-time 0.1", "--noise-time: wanted no --smoothing-time as well, which is chosen by the noise"),
                               ("--noise-time 50ms --gyro", "--noise-time: wanted no --gyro, with which noise that correlates is found")):
            with self.subTest(words):
                self.assert_fails(["smooth", self.WALK, "--joint", "RightLeg", *words.split(), "-o", "none.csv"], BAD_USAGE, message)
                self.assertFalse((self.folder / "none.csv").exists())


if __name__ == "__main__":
    main()
