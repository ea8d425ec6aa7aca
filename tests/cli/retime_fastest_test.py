#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline retime --fastest-keys`: durations that do not depend on the times that were typed."""
import json
import math
import pathlib
import random

from command import CommandTest, main

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
# By slower descents from many times. What was typed 20 to 50 times faster and slowed --per-interval took 25.3 s and 21.9 s.
MOTIONS = (("flight_keys.csv", "--method timed-c2 --ends rest --max-rate 90deg/s --max-acceleration 90deg/s2 --max-jerk 600deg/s3", 24.0),
           ("robot_keys.csv", "--max-rate 90deg/s --max-acceleration 200deg/s2", 21.86))


class FastestKeys(CommandTest):
    def write_typed_anew(self, name, factor):
        """Keys with each interval but rests times factor()."""
        lines = [line for line in (DATA / name).read_text("utf-8").splitlines() if not line.startswith("#")]
        rows = [line.split(",") for line in lines[1:]]
        times = [0.0]
        for before, row in zip(rows, rows[1:]):
            times.append(times[-1] + (float(row[0]) - float(before[0])) * (1 if row[1:8] == before[1:8] else factor()))
        self.write("typed.csv", "\n".join([",".join(lines[0].split(",")[:8])] + [
            ",".join([repr(t), *row[1:8]]) for t, row in zip(times, rows)]) + "\n")

    def test_the_times_that_were_typed_do_not_matter(self):
        uneven = random.Random(1)
        for name, limits, seconds in MOTIONS:
            for factor in (lambda: 1, lambda: 0.02, lambda: 50, lambda: 10 ** uneven.uniform(-2, 2)):
                self.write_typed_anew(name, factor)
                report = json.loads(self.output_of(f"retime typed.csv {limits} --fastest-keys -o fast.csv --json"))
                self.assertAlmostEqual(report["duration_after_s"], seconds, delta=0.01 * seconds)
                self.assertEqual(report["slowing"], "fastest-keys")
                for limit in [key for key in report if "_limit_" in key]:
                    self.assertLessEqual(report[limit.replace("_limit_", "_bound_")], report[limit])

    def test_more_inserted_keys_make_no_slower_motion_and_leave_those_given(self):
        def rows(file):
            return [line.split(",")[1:8] for line in file.read_text("utf-8").splitlines() if line[0].isdigit()]

        given = [[float(cell) for cell in row] for row in rows(DATA / "camera_keys.csv")]
        seconds = [math.inf]
        for count in (0, 1, 2):  # with one key an interval 4.151 s, with two in each 4.159 s
            told = self.run_command(f"retime {DATA / 'camera_keys.csv'} --max-rate 90deg/s --max-acceleration 200deg/s2 --max-jerk 2000deg/s3 "
                                    f"--fastest-keys --insert-keys {count} -o fast.csv --json")
            report = json.loads(told.stdout)
            made = [[float(cell) for cell in row] for row in rows(self.folder / "fast.csv")]
            self.assertEqual([row for row in made if row in given], given)
            self.assertEqual(len(made), len(given) + report["inserted"])
            self.assertLessEqual(report["inserted"], count * (len(given) - 1))
            self.assertLessEqual(report["duration_after_s"], seconds[-1])
            seconds.append(report["duration_after_s"])
        self.assertLess(seconds[-1], 0.98 * seconds[1])
        self.assertEqual(self.run_command(f"retime {DATA / 'camera_keys.csv'} --max-rate 90deg/s --insert-keys 2 -o fast.csv").stderr,
                         "orispline: --insert-keys: it makes the fastest keys faster, wanted --fastest-keys as well\n")

    def test_what_is_told(self):
        told = self.run_command(f"retime {DATA / 'robot_keys.csv'} --max-rate 90deg/s --max-acceleration 60deg/s2 --fastest-keys -o fast.csv").stderr
        self.assertIn(" s after, slowed by ", told)
        self.assertIn("acceleration: nowhere above ", told)
        self.assertIn("8 rests between equal keys, 11.1 s in all\n", told)


if __name__ == "__main__":
    main()
