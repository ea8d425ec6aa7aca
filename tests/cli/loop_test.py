#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Closed curves: `--closed` and `--period`."""
import json
import math

from command import BAD_DATA, SUCCESS, CommandTest, main, rows_of

TIMES = (0, 1, 1.5, 3.5, 4)
PERIOD = 5


def wobbling(angle):
    """A body that wobbles while its position goes round a circle, back where it began after 2 pi."""
    c, s = math.cos(0.3 * math.sin(angle)), math.sin(0.3 * math.sin(angle))
    k, r = math.cos(0.2 * math.cos(angle)), math.sin(0.2 * math.cos(angle))
    quaternion = (c * k, s * k, c * r, s * r)  # a turn about x, then one about the body's y
    return (*quaternion, math.cos(angle), math.sin(angle), 0)


def keys(times):
    rows = [(1000 + t, *wobbling(2 * math.pi * t / PERIOD)) for t in times]
    return "t,qw,qx,qy,qz,px,py,pz\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows)


class Loops(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("open.csv", keys(TIMES))
        self.write("closed.csv", keys((*TIMES, PERIOD)))
        self.closing = [method["name"] for method in json.loads(self.output_of("methods --json")) if method["closes"]]

    def continuity_of(self, arguments):
        return json.loads(self.output_of(f"inspect {arguments} --json"))["methods"]

    def test_a_period_is_covered_once(self):
        for arguments in ("open.csv --period 5", "closed.csv --closed"):
            rows = rows_of(self.output_of(f"sample {arguments} --method timed-c2 --rate 2"))
            self.assertEqual([row[0] for row in rows], [1000 + k / 2 for k in range(11)])

    def test_the_closing_key_and_the_period_make_the_same_curve(self):
        for method in self.closing:
            with self.subTest(method):
                by_key = self.output_of(f"sample closed.csv --closed --rate 8 --method {method}")
                by_period = self.output_of(f"sample open.csv --period 5 --rate 8 --method {method}")
                for a, b in zip(rows_of(by_key), rows_of(by_period), strict=True):
                    for x, y in zip(a, b):
                        self.assertAlmostEqual(x, y, delta=1e-11)

    def test_motion_and_position_are_continuous_across_the_seam(self):
        for method in ("timed-c2", "timed-c3"):
            rows = rows_of(self.output_of(f"sample open.csv --period 5 --count 2 --method {method}"))
            for before, after in zip(rows[1][1:], rows[0][1:]):
                self.assertAlmostEqual(before, after, delta=1e-10)

    def test_a_closing_step_of_a_rounding_error_is_worth_a_warning(self):
        for command in ("sample closed.csv --method timed-c2 --rate 1 --quiet",
                        "inspect closed.csv --method timed-c2,sextic"):
            with self.subTest(command):
                for period, warnings in (("5.0001", 1), ("5.01", 0), ("5", 0)):
                    done = self.run_command(f"{command} --period {period}")
                    self.assertEqual((done.returncode, done.stderr.count("warning: --period")), (SUCCESS, warnings))
                    self.assertEqual(done.stderr.count("\n"), warnings)

    def test_inspect_measures_the_seam_too(self):
        for method in self.continuity_of("open.csv --period 5 --method timed-c1,timed-c2,timed-c3,timed-sextic"):
            with self.subTest(method["method"]):
                self.assertEqual(method["continuity_order"], {"timed-c1": 1, "timed-c2": 2}.get(method["method"], 3))

    def test_a_jump_at_the_seam_is_seen_only_on_a_loop(self):
        self.write("three.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(a)},{math.sin(a)},0,0\n" for t, a in ((0, 0), (1, 0.5), (2, -0.1))))
        jump, = self.continuity_of("three.csv --method quintic")
        self.assertEqual(jump["angular_velocity_jump_max_relative"], 0)
        jump, = self.continuity_of("three.csv --method quintic --period 4")
        # At the seam half of both increments, (0.2 + 1.0)/2 rad, over 1 s after it and over 2 s before it.
        self.assertEqual(jump["angular_velocity_jump_max_key"], 0)
        self.assertAlmostEqual(jump["angular_velocity_jump_max_rad_s"], 0.6 / 1 - 0.6 / 2, delta=1e-13)
        self.assertEqual(jump["continuity_order"], 0)

    def test_a_loop_that_turns_once_round_returns_with_the_other_sign(self):
        self.write("turn.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{k},{math.cos(math.pi * k / 4)},0,0,{math.sin(math.pi * k / 4)}\n" for k in range(4)))
        rows = rows_of(self.output_of("sample turn.csv --method timed-c2 --period 4 --rate 10"))
        for row in rows:
            self.assertAlmostEqual(row[7], math.pi / 2, delta=1e-12)
        self.assertAlmostEqual(rows[-1][1], -1, delta=1e-14)

    def test_the_last_key_must_be_the_first_one_again(self):
        self.assert_fails("sample keys.csv --method timed-c2 --rate 1 --closed", BAD_DATA,
                          "keys.csv:4: key 2: the last key is 90 degrees from the first, wanted the first one again, or "
                          "--period for a later return")


if __name__ == "__main__":
    main()
