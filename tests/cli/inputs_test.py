#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files as people have them, and what every command says of them."""
import json
import pathlib

from command import CommandTest, main, rows_of

MICROSECONDS = ("timestamp,x,y,z,qx,qy,qz,qw\n1700000000000000,1,2,3,0,0,0,1\n1700000000500000,1,2,3,0,0,0.6,0.8\n"
                "1700000001000000,1,2,3,0,0,0.8,0.6\n")
TAKEN = ("orispline: warning: clock.csv: the times are taken as microseconds, for the first one is 1700000000000000; "
         "set --time-scale if they are not\n")
COMMANDS = ("sample clock.csv --rate 2", "sample clock.csv --count 2", "convert clock.csv", "plot clock.csv",
            "tune clock.csv --method timed-c2", "retime clock.csv --max-rate 1deg/s", "smooth clock.csv --smoothing-time 1",
            "reduce clock.csv --tolerance 1deg", "inspect clock.csv", "compare clock.csv --keep-every 2 --methods slerp")


class Clocks(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("clock.csv", MICROSECONDS)

    def test_every_command_says_which_unit_it_takes(self):
        for command in COMMANDS:
            with self.subTest(command=command):
                done = self.run_command(command)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(done.stderr.count(TAKEN), 1, done.stderr)

    def test_other_files_are_read_in_the_same_way(self):
        self.output_of("convert clock.csv -o keys.csv --quiet")
        for command in ("sample keys.csv --rate 2 --truth clock.csv", "compare keys.csv --reference clock.csv --methods slerp",
                        "tune keys.csv --method timed-c2 --objective fit --reference clock.csv"):
            done = self.run_command(command)
            self.assertEqual((done.returncode, done.stderr.count(TAKEN)), (0, 1), done.stderr)

    def test_nothing_is_said_where_the_unit_is_stated(self):
        rows = MICROSECONDS.split("\n", 1)[1]
        for head, options in (("timestamp (us)", ""), ("stamp_us", ""), ("t", "--time-scale 1e-6")):
            self.write("clock.csv", f"{head},x,y,z,qx,qy,qz,qw\n{rows}")
            done = self.run_command(f"convert clock.csv {options} --quiet")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual([row[0] for row in rows_of(done.stdout)], [1700000000, 1700000000.5, 1700000001])
            self.assertEqual(rows_of(done.stdout)[0][5:], [1, 2, 3])


YAWS = "t,yaw_deg,pitch_deg,roll_deg\n"


class Turns(CommandTest):
    def test_every_command_warns_of_turns_that_euler_angles_lose(self):
        self.write("clock.csv", YAWS + "0,0,0,0\n1,350,0,0\n2,370,10,0\n3,390,20,0\n")
        warning = ("orispline: warning: clock.csv:2: key 0: 1 step of Euler angles, the first with yaw from 0° to 350°, is "
                   "turned the short way; set --signs to as-given to turn as the angles say\n")
        for command in COMMANDS:
            with self.subTest(command=command):
                done = self.run_command(command)
                self.assertEqual(done.returncode, 0, done.stderr)
                said = warning.replace("csv:2:", "csv:") if command.startswith("sample") and "--rate" in command else warning
                keeps_signs = command.startswith("convert")  # and with them the turns
                self.assertEqual(done.stderr.count(said), 0 if keeps_signs else 1, done.stderr)
        self.assertEqual(self.run_command("sample clock.csv --count 3 --signs as-given --method slerp --quiet").stderr, "")

    def test_steps_near_180_degrees_are_warned_of(self):
        self.write("half.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.6,0,0,0.8\n2,-0.8,0,0,0.6\n3,-1,0,0,0\n")
        text = ("orispline: warning: half.csv{}: key 1: 1 step to the next key turns by nearly 180°, so the motion may "
                "go the wrong way round; put a key in between, or set --signs to as-given\n")
        for options, place in (("--count 3", ":3"), ("--rate 2", "")):
            self.assertEqual(self.run_command(f"sample half.csv {options} --quiet").stderr, text.format(place))
            self.assertEqual(self.run_command(f"sample half.csv {options} --signs as-given --quiet").stderr, "")
        self.assertIn(text.format(":3"), self.run_command("retime half.csv --max-rate 100rad/s").stderr)


class FilesBesideInput(CommandTest):
    def test_truth_and_reference_may_be_any_file_of_keys(self):
        self.write("truth.csv", YAWS + "0,0,0,0\n1,45,0,0\n3,90,0,0\n")
        self.write("truth.tum", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0.3826834323650898 0.9238795325112867\n")
        for truth in ("truth.csv", "truth.tum"):
            told = self.run_command(f"sample keys.csv --count 3 -o out.csv --truth {truth}").stderr
            self.assertRegex(told, r"largest \S+e-1[4-9]°|largest 0°")
            for command in (f"compare keys.csv --reference {truth} --methods slerp",
                            f"tune keys.csv --method timed-c2 --objective fit --reference {truth}"):
                done = self.run_command(command)
                self.assertEqual(done.returncode, 0, done.stderr)

    def test_truth_and_compare_have_the_same_distance(self):
        flight = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
        for method in ("auto", "beta", "bspline", "squad"):
            sampled = json.loads(self.output_of(f"sample {flight}/flight_keys.csv --method {method} --rate 10 --json "
                                                f"--truth {flight}/flight_truth.csv -o out.csv"))["truth"]
            compared = json.loads(self.output_of(f"compare {flight}/flight_keys.csv --reference {flight}/flight_truth.csv "
                                                 f"--methods {method} --json"))[0]
            for name in ("rms", "mean", "max"):
                self.assertAlmostEqual(sampled[f"distance_{name}_deg"], compared[f"{name}_deg"], places=9, msg=method)

    def test_options_of_input_are_used_where_they_fit(self):
        self.write("euler.csv", "t,a,b,c\n0,0,0,0\n1,45,0,0\n3,90,0,0\n")
        options = "--columns e1=a,e2=b,e3=c --euler ZYX --angle-unit deg"
        for truth in ("euler.csv", "keys.csv"):
            told = self.run_command(f"sample euler.csv {options} --count 3 -o out.csv --truth {truth}")
            self.assertEqual(told.returncode, 0, told.stderr)
            self.assertRegex(told.stderr, r"RMS \S+e-1[4-9]°|RMS 0°")

    def test_conjugated_keys_have_conjugated_truths(self):
        told = self.run_command("sample keys.csv --conjugate --count 3 -o out.csv --truth keys.csv").stderr
        self.assertRegex(told, r"RMS \S+e-1[4-9]°|RMS 0°")

    def test_times_are_those_of_any_file(self):
        wanted = self.output_of("sample keys.csv --times keys.csv --quiet")
        self.assertEqual([row[0] for row in rows_of(wanted)], [0, 1, 3])
        self.write("times.tum", "0 0 0 0 0 0 0 1\n1 0 0 0 0 0 0 1\n3 0 0 0 0 0 0 1\n")
        self.write("times.csv", "frame,time (ms)\n1,0\n2,1000\n3,3000\n")
        for name in ("times.tum", "times.csv"):
            self.assertEqual(self.output_of(f"sample keys.csv --times {name} --quiet"), wanted)


if __name__ == "__main__":
    main()
