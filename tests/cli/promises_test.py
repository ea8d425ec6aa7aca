#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Each line of what 0.2.0 brings, at the head of its part of the changelog, has commands here that run on the bundled data."""
import pathlib
import re
import subprocess

from command import COMMAND, CommandTest, main, with_pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROMISES = {  # whom the line is for: a command, after which words of the line stand that it is about; or the test of make test that runs it
    "Everybody": {
        "39 methods": "orispline methods",
        "C³ in time on any key times": "orispline inspect examples/data/five_keys.csv --method timed-c3",
        "exact rates": "orispline sample examples/data/five_keys.csv --method slerp --rate 50 -o all.csv",
        "one command to compare them": "orispline compare examples/data/flight_truth.csv --keep-every 400 --csv"},
    "Animators": {
        "the studio": "orispline studio examples/data/five_keys.csv -o studio.html",
        "Tensions key by key": "orispline tune examples/data/five_keys.csv --method timed-c2 -o tuned.csv",
        "smoothed": "orispline smooth examples/data/walking.bvh -o clean.bvh",
        "reduced": "orispline reduce clean.bvh --tolerance 2deg -o small.glb",
        "glTF and BVH read": "orispline convert small.glb -o back.bvh"},
    "Robotics": {
        "limits of rate, acceleration and jerk": "orispline retime examples/data/robot_keys.csv --max-rate 60deg/s --max-acceleration 200deg/s2 "
                                                 "--max-jerk 2000deg/s3 -o slow.csv",
        "poses": "orispline sample examples/data/robot_keys.csv --rate 20 -o poses.csv",
        "goals that arrive while the curve runs": "tests/online/online_curve_test.cpp"},
    "Recordings and flight logs": {
        "`smooth` with a gyro": "orispline smooth examples/data/flight_truth.csv --gyro -o smooth.csv",
        "`align`": "orispline align examples/data/flight_truth.csv smooth.csv -o aligned.csv",
        "`mean`": "orispline mean examples/data/flight_truth.csv",
        "gaps": "orispline sample examples/data/flight_keys.csv --gap 2 --rate 10 -o gaps.csv",
        "clocks": "orispline sample examples/data/flight_keys.csv --time-scale 0.001 --rate 10000 -o clock.csv",
        "axes": "orispline convert examples/data/flight_keys.csv --world-axes ENU:NED -o ned.csv"},
    "Spacecraft": {
        "times of 1.7e9 s to the last nanosecond": "orispline convert late.csv -o same.csv",
        "how certain they are": "orispline sample examples/data/flight_keys.csv --method measured --band 0.9 --rate 10 -o band.csv"},
    "C++": {"CMake and pkg-config": "tests/package/consumer", "allocates nothing": "tests/curve/allocation_test.cpp"},
    "C, and what calls C": {"the same bits": "tests/c/cases_test.cpp"},
    "Python": {"one wheel": "tests/python/test_package.py", "SciPy's words": "tests/python/test_scipy_twins.py", "tables": "tests/python/test_tables.py",
               "Spark": "tests/python/test_spark.py", "a widget": "tests/python/test_widget.py"},
    "The web": {"a player": "tests/npm/player.test.mjs", "all methods and tasks": "tests/npm/full.test.mjs", "three.js": "tests/npm/three.test.mjs"},
    "Who installs it": {"Debian packages": "tests/package/debian_test.py", "manual pages": "tests/cli/manual_test.py",
                        "completions": "orispline completion bash", "a site": "tests/site"},
}


def lines_of_0_2_0():
    """The lines of the first list of that version, by the words in bold that they begin with."""
    part = (ROOT / "CHANGELOG.md").read_text("utf-8").split("\n## 0.2.0 ")[1].split("\n### ")[0]
    return dict(re.findall(r"^- \*\*(.+?)\*\*: (.+)$", part, re.M))


class Promises(CommandTest):
    def test_each_line_has_commands_for_what_it_says(self):
        lines = lines_of_0_2_0()
        self.assertEqual(list(lines), list(PROMISES))
        for whom, promises in PROMISES.items():
            for words, command in promises.items():
                self.assertIn(words.casefold(), lines[whom].casefold())
                if command.startswith("tests/"):
                    self.assertTrue((ROOT / command).exists(), command)

    @with_pages
    def test_the_commands_run(self):
        (self.folder / "examples").symlink_to(ROOT / "examples")
        self.write("late.csv", "t,qw,qx,qy,qz\n1700000000.000000001,1,0,0,0\n1700000000.000000002,0.6,0.8,0,0\n")
        for command in (command for promises in PROMISES.values() for command in promises.values()):
            if command.startswith("orispline "):
                with self.subTest(command):
                    done = subprocess.run([COMMAND, *command.split()[1:]], cwd=self.folder, capture_output=True, text=True, check=False)
                    if "without the page of the studio" not in done.stderr:
                        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.read("same.csv").splitlines()[-1].split(",")[0], "1700000000.000000002")


if __name__ == "__main__":
    main()
