#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline smooth --gyro` on recordings as gyros make them: faults, clocks that differ, turns to count, gaps.

The recordings are not part of the project: they are read where they lie beside it.
"""
import csv
import json
import math
import os
import pathlib
import random
import sys
import unittest

from command import BAD_DATA, BAD_USAGE, CommandTest, main

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from motions.noisy_recordings import angle, rms_degrees
from motions.rotations import conjugate, times

CASES = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data")).parent / "cases/recordings"


def rows_of(path):
    with open(path, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def vectors(rows, names):
    return [tuple(float(row[name]) for name in names.split(",")) for row in rows]


def rotation_vector(q):
    """Of the short way round."""
    sine = math.hypot(*q[1:])
    scale = math.copysign(2 * math.asin(min(1.0, sine)) / sine, q[0]) if sine > 0 else 2.0
    return [scale * x for x in q[1:]]


def orientations(path):
    return vectors(rows_of(path), "qw,qx,qy,qz")


@unittest.skipUnless(CASES.is_dir(), f"no {CASES}")
class SmoothWithGyro(CommandTest):
    def smoothed(self, name, *options):
        """The summary, and the orientations that were written."""
        done = self.run_command(["smooth", str(CASES / name), "--gyro", "--json", *options, "-o", "out.csv"])
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout), orientations(self.folder / "out.csv")

    def assert_near_truth(self, found, truth, most):
        self.assertLessEqual(rms_degrees(found, orientations(CASES / truth)[:len(found)]), most)

    def test_faults_of_a_few_rates_do_no_harm_and_are_named(self):
        clean, found = self.smoothed("40_clean.csv")
        correction, error = clean["gyro_correction_rad_s"], rms_degrees(found, orientations(CASES / "40_true.csv"))
        self.assertLess(error, 0.053)
        for name in ("40_spike3.csv", "40_zero3.csv"):
            with self.subTest(name):
                told, found = self.smoothed(name)
                self.assertLess(math.degrees(math.dist(told["gyro_correction_rad_s"], correction)), 0.01)
                self.assertEqual([sample["line"] for sample in told["rejected_gyro"]], [502, 503, 504])
                self.assert_near_truth(found, "40_true.csv", 0.054)
                self.assertTrue(told["gyro_used"])

    def test_a_late_clock_is_found_and_corrected(self):
        told, found = self.smoothed("04n_99ms.csv")
        self.assertLess(abs(told["gyro_offset_s"] - 0.099), 1e-3)
        self.assertLess(told["gyro_offset_sigma_s"], 0.2e-3)
        self.assert_near_truth(found, "04n_true.csv", 0.068)
        stated, there = self.smoothed("04n_99ms.csv", "--gyro-offset", "0.099")
        self.assertIsNone(stated["gyro_offset_sigma_s"])
        self.assert_near_truth(there, "04n_true.csv", 0.068)
        said = self.run_command(["smooth", str(CASES / "04n_99ms.csv"), "--gyro", "-o", "out.csv"]).stderr
        self.assertRegex(said, r"clock +99\.\d* ms late, σ 0\.1\d* ms: corrected")
        self.assertIn("beyond it     10 samples, to which the penalty of the jerk carries the accelerations on\n", said)

    def test_accelerations_are_carried_on_to_an_end_without_a_gyro(self):
        silent = 10  # rows behind the last rate, whose stamp is late
        truth = orientations(CASES / "04n_true.csv")
        told, found = self.smoothed("04n_99ms.csv")
        self.assertEqual(told["penalty"], "jerk")
        self.assertLessEqual(rms_degrees(found[-silent:], truth[-silent:]), 0.21)
        told, as_asked = self.smoothed("04n_99ms.csv", "--penalty", "jerk")
        self.assertLessEqual(rms_degrees(as_asked, truth), 0.067)
        told, to_zero = self.smoothed("04n_99ms.csv", "--penalty", "acceleration")
        self.assertEqual(told["penalty"], "acceleration")
        self.assertLessEqual(rms_degrees(to_zero[:-silent], truth[:-silent]), 0.075)
        self.assertLessEqual(rms_degrees(to_zero[-silent:], truth[-silent:]), 0.37)
        said = self.run_command(["smooth", str(CASES / "04n_99ms.csv"), "--gyro", "--penalty", "acceleration", "-o", "out.csv"]).stderr
        self.assertIn("beyond it     10 samples, at whose end the acceleration is zero\n", said)
        self.assertEqual(self.smoothed("04n_0ms.csv")[0]["penalty"], "jerk")
        self.assertEqual(self.smoothed("04n_99ms.csv", "--smoothing-time", "0.04")[0]["penalty"], "acceleration")

    def test_rates_come_out_right_beside_a_late_clock(self):
        truth = orientations(CASES / "04n_true.csv")
        wanted = [[w * 50 for w in rotation_vector(times(conjugate(a), b))] for a, b in zip(truth, truth[2:])]  # 0.02 s from row to row
        def rms(count):
            found = vectors(rows_of(self.folder / "out.csv"), "wx,wy,wz")[1:count + 1]
            return math.degrees(math.sqrt(sum(math.dist(a, b) ** 2 for a, b in zip(found, wanted)) / count))
        self.smoothed("04n_99ms.csv")
        self.assertLessEqual(rms(len(wanted)), 0.53)

    def test_a_clock_in_step_is_left_alone(self):
        told, found = self.smoothed("04n_0ms.csv")
        self.assertEqual(told["gyro_offset_s"], 0.0)
        self.assert_near_truth(found, "04n_true.csv", 0.0736)
        self.assertLess(rms_degrees(found, self.smoothed("04n_0ms.csv", "--gyro-offset", "0")[1]), 1e-6)

    def test_turns_between_keys_are_counted(self):
        self.smoothed("34_spinner.csv")
        rates = vectors(rows_of(self.folder / "out.csv"), "wx,wy,wz")
        for x, y, z in rates:
            self.assertLess(abs(math.degrees(z) - 90.0) + abs(x) + abs(y), 1e-6)
        text = self.read("out.csv")
        self.assertTrue(text.startswith("# orispline: method=hermite-c2 signs=as-given\n"))
        comment, header, *keys = text.splitlines()
        self.write("far.csv", "\n".join([comment, header, *keys[::3]]) + "\n")
        for name, turn in (("out.csv", 90), ("far.csv", 270)):
            with self.subTest(name):
                read = vectors(rows_of(self.folder / name), "qw,qx,qy,qz")
                steps = {round(2 * math.degrees(math.acos(sum(x * y for x, y in zip(a, b, strict=True))))) for a, b in zip(read, read[1:])}
                self.assertEqual(steps, {turn})
                self.output_of(f"sample {name} --rate 20 -o samples.csv")
                for _, _, z in vectors(rows_of(self.folder / "samples.csv"), "wx,wy,wz"):
                    self.assertLess(abs(math.degrees(z) - 90.0), 1e-6)
        text = (CASES / "34_spinner.csv").read_text("utf-8").replace("1.5707963267948966", "2.6179938779914944")
        self.write("fast.csv", text)
        done = self.run_command("smooth fast.csv --gyro -o nothing.csv")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertIn("it is undecided how often the body turned in the 3 s to the next orientation", done.stderr)
        self.assertIn("360°/3 s = 120 °/s", done.stderr)
        self.assertFalse((self.folder / "nothing.csv").exists())

    def test_rates_between_orientations_count_and_carry_on_through_gaps(self):
        for name, rms, largest in (("12_cam10_gyro100.csv", 0.025, 0.08), ("12_gyro_through.csv", 0.025, 0.08)):
            with self.subTest(name):
                _, found = self.smoothed(name)
                self.assertEqual(len(found), 800)
                self.assert_near_truth(found, "11_true.csv", rms)
                away = [math.degrees(angle(a, b)) for a, b in zip(found, orientations(CASES / "11_true.csv"), strict=True)]
                self.assertLessEqual(max(away), largest)
                times = [row["t"] for row in rows_of(CASES / name)]
                self.assertEqual([float(row["t"]) for row in rows_of(self.folder / "out.csv")], [float(t) for t in times])

    def test_a_file_of_rates_has_a_clock_of_its_own(self):
        rows = rows_of(CASES / "04n_99ms.csv")
        self.write("poses.csv", "t,qw,qx,qy,qz\n" + "".join(f"{r['t']},{r['qw']},{r['qx']},{r['qy']},{r['qz']}\n" for r in rows[::5]))
        self.write("imu.csv", "t,wx,wy,wz\n" + "".join(f"{r['t']},{r['wx']},{r['wy']},{r['wz']}\n" for r in rows))
        told = json.loads(self.output_of("smooth poses.csv --gyro-file imu.csv --json -o out.csv"))
        self.assertLess(abs(told["gyro_offset_s"] - 0.099), 1.5e-3)
        truth = dict(zip((float(r["t"]) for r in rows), orientations(CASES / "04n_true.csv"), strict=True))
        written = {float(r["t"]): (float(r["qw"]), float(r["qx"]), float(r["qy"]), float(r["qz"])) for r in rows_of(self.folder / "out.csv")}
        there = [t for t in truth if t in written]
        self.assertEqual(len(there), 400)
        self.assertLess(rms_degrees([written[t] for t in there], [truth[t] for t in there]), 0.2)
        self.write("since_boot.csv", "t,wx,wy,wz\n" + "".join(f"{float(r['t']) + 86400},{r['wx']},{r['wy']},{r['wz']}\n" for r in rows))
        there = json.loads(self.output_of("smooth poses.csv --gyro-file since_boot.csv --gyro-offset 86400.099 --json -o out.csv"))
        self.assertTrue(there["gyro_used"])
        for is_now, before in zip(there["gyro_correction_rad_s"], told["gyro_correction_rad_s"], strict=True):
            self.assertLess(abs(is_now - before), 1e-4)
        self.assert_fails("smooth poses.csv --gyro-file since_boot.csv -o nothing.csv", BAD_DATA,
                          "poses.csv: the rates of the gyro are from 86400 s to 86419.99 s and do not overlap the recording, which is from "
                          "0 s to 19.95 s, wanted --gyro-offset for a clock that differs so much, as align finds it")
        self.assert_fails("smooth poses.csv --gyro-file imu.csv --gyro-offset 30 -o nothing.csv", BAD_USAGE,
                          "--gyro-offset: found 30 s, which brings the rates to -30 s to -10.01 s, wanted them to overlap the recording, which is "
                          "from 0 s to 19.95 s")
        self.write("later.csv", "t,wx,wy,wz\n100,0,0,1\n101,0,0,1\n102,0,0,1\n")
        done = self.run_command("smooth poses.csv --gyro-file later.csv -o nothing.csv")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertRegex(done.stderr, "the rates of the gyro are from 100 s to 102 s and do not overlap the recording, which is from 0 s to 19.9")
        self.write("none.csv", "t,a,b\n0,1,2\n")
        self.assertIn("wanted the rates of the body wx, wy and wz", self.run_command("smooth poses.csv --gyro-file none.csv -o nothing.csv").stderr)
        self.assertFalse((self.folder / "nothing.csv").exists())

    def test_a_file_of_rates_is_mended_as_rows_are(self):
        rows = rows_of(CASES / "04n_0ms.csv")[:400]
        self.write("poses.csv", "t,qw,qx,qy,qz\n" + "".join(f"{r['t']},{r['qw']},{r['qx']},{r['qy']},{r['qz']}\n" for r in rows))
        rates = [f"{r['t']},{r['wx']},{r['wy']},{r['wz']}\n" for r in rows]
        self.write("imu.csv", "t,wx,wy,wz\n" + "".join(rates))
        self.output_of("smooth poses.csv --gyro-file imu.csv -o out.csv")
        wanted = self.read("out.csv")
        for name, text, remedy, message in (
                ("twice.csv", rates[:9] + rates[8:], "--drop-duplicates", "twice.csv:11: duplicate time 0.08, as in line 10, wanted "
                 "increasing times (--drop-duplicates keeps the first)"),
                ("moved.csv", rates[:7] + rates[8:] + rates[7:8], "--sort", "moved.csv:401: time 0.07 comes after 3.99, wanted "
                 "increasing times (--sort orders the rows)"),
                ("again.csv", rates + rates[100:150], "--session 1", "again.csv:402: time 1 comes after 3.99, and the rows go on from "
                 "there: a second recording begins, wanted one, or --unwrap if the clock came round (--session N|all reads one of them)")):
            with self.subTest(name):
                self.write(name, "t,wx,wy,wz\n" + "".join(text))
                self.assert_fails(f"smooth poses.csv --gyro-file {name} -o nothing.csv", BAD_DATA, message)
                self.assertFalse((self.folder / "nothing.csv").exists())
                self.output_of(f"smooth poses.csv --gyro-file {name} {remedy} -o out.csv")
                self.assertEqual(self.read("out.csv"), wanted)
        self.assert_fails("smooth poses.csv --gyro-file again.csv --sort -o nothing.csv", BAD_DATA,
                          "again.csv:402: found 2 recordings one behind the other, the second from here on, which sorting would mix; wanted "
                          "one of them, or --unwrap if the clock came round (--session N|all reads one of them)")

    def test_rows_without_an_orientation_may_come_twice(self):
        header, *rows = (CASES / "12_cam10_gyro100.csv").read_text("utf-8").splitlines()
        self.smoothed("12_cam10_gyro100.csv")
        wanted = self.read("out.csv")
        at = next(k for k, row in enumerate(rows) if row.split(",")[1] in ("", "nan"))
        self.write("twice.csv", "\n".join([header, *rows[:at + 1], *rows[at:]]) + "\n")
        done = self.run_command("smooth twice.csv --gyro -o nothing.csv")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertRegex(done.stderr, r"twice\.csv:\d+: duplicate time \S+, as in line \d+, wanted increasing times \(--drop-duplicates keeps the first\)\n")
        self.output_of("smooth twice.csv --gyro --drop-duplicates -o out.csv")
        self.assertEqual(self.read("out.csv"), wanted)

    def test_what_a_gyro_that_is_left_out_says_of_its_clock_is_no_correction(self):
        rows = rows_of(CASES / "04n_0ms.csv")[:600]
        def with_rates(name, rate):
            self.write(name, "t,qw,qx,qy,qz,wx,wy,wz\n" + "".join(
                ",".join([r["t"], r["qw"], r["qx"], r["qy"], r["qz"], *rate(r)]) + "\n" for r in rows))
        with_rates("still.csv", lambda r: ("0.5", "0.5", "0.5"))
        done = self.run_command("smooth still.csv --gyro -o out.csv")
        self.assertIn("warning: the gyro was left out", done.stderr)
        self.assertIn("clock         its offset cannot be told from this motion\n", done.stderr)
        with_rates("few.csv", lambda r: (r["wx"], r["wy"], r["wz"]) if r["t"] == rows[300]["t"] else ("", "", ""))
        self.assert_fails("smooth few.csv --gyro -o nothing.csv", BAD_DATA, "few.csv: found 1 rate of the gyro, wanted at least 3")

    def test_rows_without_an_orientation_are_sorted_too(self):
        header, *rows = (CASES / "12_gyro_through.csv").read_text("utf-8").splitlines()
        self.smoothed("12_gyro_through.csv")
        in_order = orientations(self.folder / "out.csv")
        self.write("back.csv", "\n".join([header, *rows[::-1]]) + "\n")
        self.output_of("smooth back.csv --gyro --sort -o out.csv")
        self.assertEqual(orientations(self.folder / "out.csv"), in_order)
        done = self.run_command("smooth back.csv --gyro -o nothing.csv")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertIn("--sort orders the rows", done.stderr)

    def test_positions_of_rows_without_them_lie_on_the_path(self):
        text = "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz\n"
        dice = random.Random(3)
        for row in rows_of(CASES / "12_gyro_through.csv"):
            t, posed = float(row["t"]), row["qw"] != "nan"
            place = [repr(math.sin(t) + dice.gauss(0, 0.002)), repr(t + dice.gauss(0, 0.002)), repr(dice.gauss(0, 0.002))] if posed else ["", "", ""]
            text += ",".join([row["t"], *(row[c] for c in ("qw", "qx", "qy", "qz")), *place, *(row[c] for c in ("wx", "wy", "wz"))]) + "\n"
        self.write("moving.csv", text)
        self.output_of("smooth moving.csv --gyro --sigma -o out.csv")
        written = rows_of(self.folder / "out.csv")
        self.assertEqual(len(written), 800)
        for row in written:
            t = float(row["t"])
            self.assertLess(math.dist((math.sin(t), t, 0.0), tuple(float(row[c]) for c in ("px", "py", "pz"))), 0.05)
            self.assertGreater(float(row["sigma_x"]), 0.0)

    def test_bad_offsets_are_refused(self):
        name = str(CASES / "04n_0ms.csv")
        for option, message in (("--gyro-offset 30", "--gyro-offset: found 30 s, wanted less than the duration of the recording of 19.99 s"),
                                ("--gyro-offset soon", "--gyro-offset: found 'soon', wanted a number"),
                                ("--gyro-bias none", "--gyro-bias: found 'none', wanted constant|drifting")):
            with self.subTest(option):
                done = self.run_command(["smooth", name, "--gyro", *option.split(), "-o", "out.csv"])
                self.assertNotEqual(done.returncode, 0)
                self.assertIn(message, done.stderr)
                self.assertFalse((self.folder / "out.csv").exists())
        self.assert_fails(f"smooth {name} --gyro-offset 0.1 -o out.csv", BAD_USAGE, "--gyro-offset: wanted --gyro as well")

    def test_rows_without_a_rate_are_rows_without_a_gyro(self):
        rows = rows_of(CASES / "04n_0ms.csv")
        text = "t,qw,qx,qy,qz,wx,wy,wz\n"
        for k, r in enumerate(rows):
            rate = ("", "nan", r["wz"]) if k % 50 == 7 else ("", "", "") if k % 50 == 8 else (r["wx"], r["wy"], r["wz"])
            text += ",".join([r["t"], r["qw"], r["qx"], r["qy"], r["qz"], *rate]) + "\n"
        self.write("holes.csv", text)
        self.output_of("smooth holes.csv --gyro -o out.csv")
        self.assert_near_truth(orientations(self.folder / "out.csv"), "04n_true.csv", 0.08)


if __name__ == "__main__":
    main()
