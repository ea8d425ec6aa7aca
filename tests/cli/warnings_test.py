#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Curves that are made, but are not what the method's name promises: one line on standard error."""
import json
import math
import pathlib

from command import SUCCESS, CommandTest, main

ROOT = pathlib.Path(__file__).resolve().parents[2]


class Warnings(CommandTest):
    def warnings_of(self, turn, method):
        """On a turn about z within 1 s and rest for 10 s: squad-timed's handle turns by 10/2 * 10/11 of it."""
        self.write("rest.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n" + "".join(
            f"{t},{math.cos(turn / 2)},0,0,{math.sin(turn / 2)}\n" for t in (1, 11)))
        done = self.run_command(f"sample rest.csv --method {method} --count 2 --quiet")
        self.assertEqual((done.returncode, done.stdout.count("\n")), (SUCCESS, 3))
        # Where it moves in the rest, and turns in it much farther than the keys, which it does.
        return "".join(line for line in done.stderr.splitlines(True) if "moves in 1 rest" not in line and "the curve of" not in line)

    def test_a_handle_that_turns_a_full_turn_is_named(self):
        self.assertEqual(self.warnings_of(1.4, "squad-timed"),
                         "orispline: warning: rest.csv:3: key 1: a handle of squad-timed turns by 364.6 degrees, wanted "
                         "less than a full turn: the angular velocity may jump there; take timed-c1, which has no such "
                         "limit\n")

    def test_a_narrower_one_is_not(self):
        for turn, method in ((1.37, "squad-timed"), (1.4, "tcb"), (3.0, "timed-c1")):
            with self.subTest(method):
                self.assertEqual(self.warnings_of(turn, method), "")

    def test_a_curve_that_turns_much_farther_than_its_keys_is_named(self):
        """Between two keys that one wrong time brings 0.02 s beside a third."""
        camera = (ROOT / "examples/data/camera_keys.csv").read_text()
        self.write("camera.csv", camera.replace("\n3.88,", "\n5.62,"))
        for line in ("sample camera.csv --rate 2 -o out.csv", "inspect camera.csv --method auto"):
            with self.subTest(line):
                self.assertIn("warning: camera.csv:10: key 4: between the keys at 3.36 s and 5.62 s the curve of auto turns by 633.7 degrees, where "
                              "the keys turn by 23.19: the keys at 5.62 s and 5.64 s are too near in time", self.run_command(line).stderr)
        for method in ("slerp", "squad"):
            self.assertEqual(self.run_command(f"sample camera.csv --method {method} --rate 2 -o out.csv --quiet").stderr, "")
        self.write("whole.csv", camera)
        self.assertEqual(self.run_command("sample whole.csv --rate 2 -o out.csv --quiet").stderr, "")

    def test_a_curve_that_swings_away_from_its_keys_is_named(self):
        angles = zip((0, 1.2, 2, 2.4, 2.6, 3.4), (math.radians(x) for x in (0, 10, 0, 0.05, 30, 30.05)))
        self.write("arm.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},{math.cos(x / 2)},0,{math.sin(x / 2)},0\n" for t, x in angles))
        for line in ("sample arm.csv --rate 2 -o out.csv", "inspect arm.csv --method auto"):
            with self.subTest(line):
                self.assertRegex(self.run_command(line).stderr, r"warning: arm.csv:6: key 4: between the keys at 2.6 s and 3.4 s the curve of auto swings "
                                 r"2\d\.\d+ degrees away from the shortest way, where the keys are 0.05 apart; take monotone, which stays near its keys\n")
        for method in ("monotone", "slerp", "auto:rest-angle=0.1deg"):
            self.assertEqual(self.run_command(f"sample arm.csv --method {method} --rate 2 -o out.csv --quiet").stderr, "")

    def test_the_json_has_what_was_warned_of(self):
        self.write("half.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,1,0,0\n2,0,0,1,0\n")
        done = self.run_command("sample half.csv --rate 2 -o out.csv --json")
        warning, = json.loads(done.stdout)["warnings"]
        self.assertEqual((warning["code"], warning["key"], warning["steps"]), ("near_half_turn", 0, 2))
        self.assertIn(warning["message"], done.stderr)
        self.assertEqual(json.loads(self.output_of("sample keys.csv --rate 2 -o out.csv --json"))["warnings"], [])
        done = self.run_command("sample half.csv keys.csv --rate 2 --output-folder out --json --threads 2")
        self.assertEqual([len(one["warnings"]) for one in json.loads(done.stdout)], [1, 0])

    def test_what_an_output_leaves_out_has_a_code_too(self):
        rows = "".join(f"{k},{0.9 if k % 2 else 1},{0.43588989435 if k % 2 else 0},0,0,1,2,3\n" for k in range(30))
        self.write("rates.csv", "t,qw,qx,qy,qz,wx,wy,wz\n" + rows)
        for line, code in (("retime rates.csv --max-rate 1deg/s --method timed-c2 -o slow.csv", "columns_left_out"),
                           ("smooth rates.csv --noise 0.1rad --rate 2 -o smooth.tum", "rates_not_written")):
            with self.subTest(line):
                warnings = json.loads(self.output_of(f"{line} --json"))["warnings"]
                self.assertIn(code, [warning["code"] for warning in warnings])
                self.assertNotIn("", [warning["code"] for warning in warnings])


if __name__ == "__main__":
    main()
