#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline retime --constant-rate` and `--constant-speed`: even motions along the path of a curve."""
import json
import math
import pathlib

from command import BAD_USAGE, CommandTest, main, rows_of, table_of

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
MENDS = "wanted a duration in which it slows down, such as 0.5s"


class EvenMotions(CommandTest):
    def even(self, options):
        return json.loads(self.output_of(f"retime {options} -o even.csv --json"))

    def sizes(self, name):
        """Of a vector along the written curve, at 2001 times, with these."""
        text = self.output_of("sample even.csv --count 2001 --derivatives 2")
        column = table_of(text)[0].split(",").index(name)
        return [(row[0], math.hypot(*row[column:column + 3])) for row in rows_of(text)]

    def write_keys(self, *keys):
        """Turned about x by angles, at positions along x, a second apart."""
        self.write("keys.csv", "t,qw,qx,qy,qz,px,py,pz\n" + "".join(
            f"{t},{math.cos(angle / 2)!r},{math.sin(angle / 2)!r},0,0,{x},0,0\n" for t, (angle, x) in enumerate(keys)))

    def test_the_camera_turns_evenly(self):
        report = self.even(f"{DATA / 'camera_keys.csv'} --constant-rate 10deg/s")
        self.assertLessEqual(report["unevenness"], 1e-3)
        self.assertLessEqual(report["path_turn_rad"], 1e-4)
        for _, rate in self.sizes("wx"):
            self.assertAlmostEqual(math.degrees(rate), 10, delta=0.01 * 1.01)

    def test_an_ease_begins_and_ends_without_a_jump(self):
        report = self.even(f"{DATA / 'camera_keys.csv'} --constant-speed 0.5m/s --ease 2s")
        for t, speed in self.sizes("vx"):
            u = min(1.0, t / 2, (report["duration_after_s"] - t) / 2)
            self.assertAlmostEqual(speed, 0.5 * u * u * (3 - 2 * u), delta=5.1e-4)

    def test_the_path_is_kept(self):
        before = {tuple(row[1:8]) for row in rows_of((DATA / "robot_keys.csv").read_text("utf-8"))}
        report = self.even(f"{DATA / 'robot_keys.csv'} --constant-rate 30deg/s --ease 0.5s")
        self.assertEqual((report["rests"], report["method"], report["stops"]), (8, "auto", 0))
        after = rows_of(self.read("even.csv"))
        self.assertGreater(len(after), len(before))
        for pose in before:
            self.assertLess(min(math.dist(pose, row[1:8]) for row in after), 1e-8)

    def test_it_stops_where_the_path_turns_back(self):
        self.write_keys((0, 0), (1, 1), (0, 2), (1, 3))
        told = self.run_command("retime keys.csv --constant-rate 10deg/s -o even.csv")
        self.assertEqual(told.returncode, BAD_USAGE)
        self.assertRegex(told.stderr, rf"^orispline: --ease: the path stops 0\.\d+ s after its start, where an even motion would jump; {MENDS}\n")
        report = self.even("keys.csv --constant-rate 10deg/s --ease 1s")
        self.assertEqual(report["stops"], 2)
        self.assertLessEqual(report["unevenness"], 1e-3)
        self.assertLess(math.degrees(report["largest_acceleration_rad_s2"]), 15.1)

    def test_what_is_told(self):
        told = self.run_command(f"retime {DATA / 'camera_keys.csv'} --constant-rate 10deg/s --ease 1s -o even.csv").stderr
        self.assertRegex(told, r"\n10 deg/s within 0\.0\d+ %, eased for 1 s where it starts and stops\n\d+ keys on the path of auto, within "
                               r"\S+ deg and \S+ mm of it; largest rate 10\.00\d* deg/s, acceleration \S+ deg/s2\n")
        told = self.run_command(f"retime {DATA / 'camera_keys.csv'} --constant-rate 10deg/s --ease 500s -o even.csv").stderr
        self.assertRegex(told, r"warning: \d parts? between two stops, too short to get as fast as asked for with this ease; a shorter one mends that\n")

    def test_which_times_shape_the_path_is_told(self):
        self.write("circle.csv", "t,qw,qx,qy,qz,px,py,pz\n" + "".join(
            f"{t},1,0,0,0,{math.cos(i * math.pi / 4)!r},{math.sin(i * math.pi / 4)!r},0\n"
            for i, t in enumerate((0, 0.4, 1.9, 2.2, 4, 4.3, 6, 7))))
        told = self.run_command("retime circle.csv --constant-speed 0.2m/s -o even.csv").stderr
        self.assertRegex(told, r"\nthe distances between the keys shape the path, not the typed times, by which it would be \d+\.\d % longer\n")
        told = self.run_command("retime circle.csv --constant-speed 0.2m/s --path-times typed -o even.csv").stderr
        self.assertRegex(told, r"\nthe typed times shape the path, \d+\.\d % longer than by the distances between the keys\n")
        self.assertRegex(told, r"warning: the typed times make the path \d+\.\d % longer than times in proportion to the steps between the keys, "
                               r"the default, would")

    def test_refused(self):
        camera, five = DATA / "camera_keys.csv", DATA / "five_keys.csv"
        rate = "wanted a number greater than 0 with its unit, deg/s, rad/s, mrad/s or arcsec/s, such as 1deg/s"
        for text in ("0deg/s", "-1deg/s", "nandeg/s", "infdeg/s", "10"):
            self.assert_fails(f"retime {camera} --constant-rate={text}", BAD_USAGE, f"--constant-rate: found '{text}', {rate}")
        for options, message in (
                ("--constant-rate 1deg/s --constant-speed 1m/s", "--constant-rate: found --constant-speed as well, wanted one of them"),
                ("--constant-rate 1deg/s --max-rate 2deg/s", "--constant-rate: it says how fast the motion is everywhere, wanted no limits beside it"),
                ("--constant-speed 1m/s --duration 9s", "--constant-speed: the duration follows from it, wanted no --duration beside it"),
                ("--constant-speed 1m/s --per-interval", "--constant-speed: the keys' times follow from it, wanted uniform slowing"),
                ("--max-rate 1deg/s --ease 1s", "--ease: it is of an even motion, wanted --constant-rate or --constant-speed as well")):
            self.assert_fails(f"retime {camera} {options}", BAD_USAGE, message)
        self.assert_fails(f"retime {five} --constant-speed 1m/s", BAD_USAGE,
                          "--constant-speed: the keys have no positions, wanted px,py,pz as well")
        self.assert_fails(f"retime {five} --constant-rate 1deg/s --method slerp", BAD_USAGE,
                          "--constant-rate: the path has a corner 1 s after the start, where an even motion would jump; wanted "
                          "a method without corners, such as auto")
        self.write_keys((1, 0), (1, 0), (1, 0))
        self.assert_fails("retime keys.csv --constant-rate 1deg/s", BAD_USAGE,
                          "--constant-rate: no key turns from the one before it, wanted keys that do")
        self.assert_fails("retime keys.csv --constant-speed 1m/s --ease 1s", BAD_USAGE,
                          "--constant-speed: no key shifts from the one before it, wanted keys that do")
        self.write_keys((0, 0), (1, 0), (1, 1))
        self.assert_fails("retime keys.csv --constant-speed 1m/s --method slerp", BAD_USAGE,
                          "--constant-speed: from 0 s to 1 s after the start the body turns, and nothing else, which would take "
                          "no time; wanted --constant-rate")


if __name__ == "__main__":
    main()
