#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline retime`: that limits hold everywhere, that the slowing is the least one, what is refused."""
import json
import math
import pathlib

from command import BAD_DATA, BAD_USAGE, CommandTest, main, rows_of

ROBOT = pathlib.Path(__file__).resolve().parents[2] / "examples/data/robot_keys.csv"


def peaks(rows):
    """Largest angular velocity and acceleration [deg/s, deg/s²] of samples without positions."""
    return [math.degrees(max(math.hypot(*row[k:k + 3]) for row in rows)) for k in (5, 8)]


class Retime(CommandTest):
    def setUp(self):
        super().setUp()
        robot = [line.split(",")[:5] for line in ROBOT.read_text("utf-8").splitlines() if not line.startswith("#")]
        self.write("robot.csv", "".join(",".join(row) + "\n" for row in robot))

    def retimed(self, arguments):
        return json.loads(self.output_of(f"retime {arguments} -o slow.csv --json"))

    def sampled(self, method="auto"):
        return rows_of(self.output_of(f"sample slow.csv --method {method} --count 40001 --derivatives 2"))

    def test_a_geodesic_is_slowed_by_its_rate(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.7071067811865476,0,0,0.7071067811865476\n")
        report = self.retimed("keys.csv --max-rate 45deg/s")
        self.assertAlmostEqual(report["stretch"], 2, delta=2e-4)
        self.assertGreaterEqual(report["stretch"], 2)
        self.assertLessEqual(report["rate_bound_deg_s"], 45)

    def test_limits_hold_everywhere_and_are_reached(self):
        for extra in ("", "--per-interval"):
            report = self.retimed(f"robot.csv --max-rate 90deg/s --max-acceleration 200deg/s2 {extra}")
            rate, acceleration = peaks(self.sampled())
            self.assertLessEqual(rate, report["rate_bound_deg_s"])
            self.assertLessEqual(acceleration, report["acceleration_bound_deg_s2"])
            self.assertLessEqual(report["rate_bound_deg_s"], 90)
            self.assertLessEqual(report["acceleration_bound_deg_s2"], 200)
            self.assertGreater(acceleration, 200 * (1 - 3e-3))

    def test_intervals_by_themselves_need_less_time(self):
        limits = "robot.csv --max-rate 90deg/s --max-acceleration 200deg/s2"
        self.assertLess(self.retimed(limits + " --per-interval")["stretch"], 0.8 * self.retimed(limits)["stretch"])

    def test_torque_of_a_ball_is_its_acceleration(self):
        by_torque = self.retimed("robot.csv --max-torque 6Nm --inertia=2,2,2 --method timed-c2")
        by_acceleration = self.retimed("robot.csv --max-acceleration 3rad/s2 --method timed-c2")
        self.assertAlmostEqual(by_torque["stretch"], by_acceleration["stretch"], delta=1e-3)

    def test_a_motion_within_the_limits_stays_as_it_is(self):
        report = self.retimed("keys.csv --max-rate 1000deg/s")
        self.assertEqual(report["stretch"], 1)
        self.assertEqual([row[0] for row in rows_of(self.read("slow.csv"))], [0, 1, 3])

    def test_refused(self):
        self.assert_fails("retime keys.csv", BAD_USAGE,
                          "found no limit, wanted --max-rate, --max-acceleration or --max-torque")
        self.assert_fails("retime keys.csv --max-rate=-1deg/s", BAD_USAGE,
                          "--max-rate: found '-1deg/s', wanted a number greater than 0 with its unit, deg/s or rad/s, such as "
                          "1deg/s")
        self.assert_fails("retime keys.csv --max-torque 1Nm", BAD_USAGE,
                          "--max-torque: wanted --inertia JX,JY,JZ as well")
        self.assert_fails("retime keys.csv --max-acceleration 1deg/s2 --method slerp", BAD_USAGE,
                          "slerp: its angular velocity jumps at keys, which no slowing brings within a limit of "
                          "acceleration or torque, wanted a method that is C1, such as auto")
        self.assert_fails("retime keys.csv --max-rate 1deg/s --method global-c2", BAD_USAGE,
                          "global-c2: no bounds are known for the segments of this method, wanted one of polynomials, "
                          "such as auto or timed-c2")
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assert_fails("retime one.csv --max-rate 1deg/s", BAD_DATA,
                          "one.csv: found 1 key, wanted 2 at least: one key does not move")


if __name__ == "__main__":
    main()
