#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline retime`: rests, limits of all kinds in the units that were typed, and durations."""
import json
import math
import pathlib

from command import BAD_USAGE, CommandTest, main, rows_of, table_of, with_pages

ROBOT = pathlib.Path(__file__).resolve().parents[2] / "examples/data/robot_keys.csv"


class RestsAndLimits(CommandTest):
    def setUp(self):
        super().setUp()
        robot = [line.split(",")[:5] for line in ROBOT.read_text("utf-8").splitlines() if not line.startswith("#")]
        self.write("robot.csv", "".join(",".join(row) + "\n" for row in robot))

    def test_a_robot_stays_in_its_rests_for_as_long_as_before(self):
        limits = "--max-rate 90deg/s --max-acceleration 200deg/s2"
        given = rows_of(ROBOT.read_text("utf-8"))
        rests = [i for i in range(len(given) - 1) if given[i][1:] == given[i + 1][1:]]
        self.assertEqual(len(rests), 8)
        for extra in ("", "--per-interval"):
            report = json.loads(self.output_of(f"retime {ROBOT} {limits} {extra} -o slow.csv --json"))
            self.assertEqual(report["rests"], 8)
            slow = rows_of(self.read("slow.csv"))
            for i in rests:
                self.assertAlmostEqual(slow[i + 1][0] - slow[i][0], given[i + 1][0] - given[i][0], places=9)
                start, end = slow[i][0], slow[i + 1][0]
                samples = rows_of(self.output_of(f"sample slow.csv --count 51 --from {start} --to {end} --derivatives 1"))
                for row in samples[1:-1]:
                    self.assertLess(max(map(abs, row[8:11])), 1e-12)  # the rate
                    for a, b in zip(row[1:8], slow[i][1:8]):
                        self.assertAlmostEqual(a, b, places=9)

    def test_units_are_shown_as_they_were_typed(self):
        for limit, shown in (("--max-rate 1.5rad/s", "rate: nowhere above 1.5 rad/s (limit 1.5)"),
                             ("--max-rate 90°/s", "rate: nowhere above 90 °/s (limit 90)"),
                             ("--max-acceleration 200deg/s^2", "deg/s^2 (limit 200)"),
                             ("--max-acceleration 3rad/s²", "rad/s² (limit 3)")):
            told = self.run_command(f"retime robot.csv {limit} -o slow.csv").stderr
            self.assertIn(shown, told)
        told = self.run_command(["retime", "robot.csv", "--max-rate", "90,60,120 deg/s", "-o", "slow.csv"]).stderr
        self.assertRegex(told, r"rate about y: nowhere above \S+ deg/s \(limit 60\)")
        self.assertEqual(told.count("rate about"), 3)
        for text in ("90,60deg/s", "90", "0deg/s", "90,-1,3deg/s", "90deg"):
            self.assert_fails(f"retime robot.csv --max-rate {text}", BAD_USAGE,
                              f"--max-rate: found '{text}', wanted a number greater than 0 with its unit, deg/s, rad/s, mrad/s or "
                              "arcsec/s, such as 1deg/s, or three with commas between them, such as 1,2,3deg/s")

    def test_positions_are_limited_too(self):
        report = json.loads(self.output_of(f"retime {ROBOT} --max-speed 300mm/s --max-linear-acceleration 0.6m/s2 "
                                           "-o slow.csv --json"))
        rows = [row for times in ("--count 40001", "--times slow.csv")
                for row in rows_of(self.output_of(f"sample slow.csv {times} --derivatives 2"))]
        header = table_of(self.output_of("sample slow.csv --count 2 --derivatives 2"))[0].split(",")
        speed, acceleration = (max(math.hypot(*row[header.index(first):header.index(first) + 3]) for row in rows)
                               for first in ("vx", "apx"))
        self.assertLessEqual(speed, report["speed_bound_m_s"])
        self.assertLessEqual(report["speed_bound_m_s"], 0.3)
        self.assertLessEqual(acceleration, report["linear_acceleration_bound_m_s2"])
        self.assertLessEqual(report["linear_acceleration_bound_m_s2"], 0.6)
        self.assertGreater(max(speed / 0.3, acceleration / 0.6), 1 - 1e-3)

    @with_pages
    def test_the_report_names_limits_as_they_were_typed(self):
        self.output_of("retime robot.csv --max-rate 90,60,120deg/s --max-jerk 2000°/s^3 --report out.html -o slow.csv")
        page = self.page("out.html")
        self.assertRegex(page["title"], r"^robot\.csv within 90, 60, 120 deg/s and 2000 °/s\^3, auto: slowed uniformly by ")
        self.assertEqual([column["unit"] for column in page["columns"][:9]], ["s"] + 6 * ["deg/s"] + 2 * ["°/s^3"])

    def test_a_duration_is_met(self):
        for text, seconds in (("30s", 30), ("30", 30), ("0.5min", 30), ("20000ms", 20)):
            self.assertEqual(json.loads(self.output_of(f"retime robot.csv --duration {text} -o slow.csv --json"))["duration_after_s"], seconds)
        done = self.run_command("retime robot.csv --duration 15s --max-rate 60deg/s -o other.csv")
        self.assertEqual(done.returncode, BAD_USAGE)
        self.assertRegex(done.stderr, r"^orispline: --duration: in 15 s the motion exceeds its limits, wanted some \S+ s at "
                                      "least\n")
        self.assertFalse((self.folder / "other.csv").exists())
        told = self.run_command("retime robot.csv --duration 15s --shorten-rests 0.2s -o slow.csv").stderr
        self.assertIn("faster by", told)
        self.assertIn("8 rests between equal keys, 1.6 s in all\n", told)


if __name__ == "__main__":
    main()
