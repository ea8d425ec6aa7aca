#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Axes and frames: what is read in others than those of the file, by every command that reads rows or a joint."""
import csv
import io
import json
import math
import pathlib
import unittest

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, HALF, main
from small_scenes import SceneTest

RECORDINGS = pathlib.Path(__file__).resolve().parents[3] / "shared" / "cases" / "recordings"
ROW = "t,qw,qx,qy,qz,px,py,pz,wx,wy,wz\n0,0.8,0.36,0.48,0,1,2,3,0.1,0.2,0.3\n"
TO_ROS = "--world-axes NED:ENU --body-axes FRD:FLU"
IN_ROS = [0.565685424949238, 0.593969696196700, -0.084852813742386, 0.565685424949238]
TABLE = [  # options, quaternion up to its sign, position, angular velocity
    (TO_ROS, IN_ROS, [2, 1, -3], [0.1, -0.2, -0.3]),
    ("--body-axes RDF:RUB", [0.36, -0.8, 0, 0.48], [1, 2, 3], [0.1, -0.2, -0.3]),
    ("--world-axes RUB:RFU", [0.311126983722081, 0.820243866176395, 0.339411254969543, 0.339411254969543], [1, -3, 2], [0.1, 0.2, 0.3]),
    ("--world-axes RUF:FLU --body-axes RUF:FLU", [0.8, 0, 0.36, -0.48], [3, -1, 2], [-0.3, 0.1, -0.2])]
RATED = "# orispline: method=hermite-c1\n" + ROW + "1,1,0,0,0,1,2,3,0.1,0.2,0.3\n"


def numbers_of(text):
    """The rows of a CSV as mappings of numbers."""
    lines = [line for line in text.splitlines() if not line.startswith("#")]
    return [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(io.StringIO("\n".join(lines)))]


class Frames(SceneTest):
    def setUp(self):
        super().setUp()
        self.write("row.csv", ROW)
        self.write("rated.csv", RATED)

    def assert_near(self, found, wanted, tolerance=1e-15):
        for one, other in zip(found, wanted, strict=True):
            self.assertAlmostEqual(one, other, delta=tolerance)

    def assert_turned(self, row, quaternion, position, rate=None):
        q = [row[name] for name in ("qw", "qx", "qy", "qz")]
        sign = math.copysign(1, sum(a * b for a, b in zip(q, quaternion)))
        self.assert_near([sign * one for one in q], quaternion)
        self.assertEqual([row[name] for name in ("px", "py", "pz")], position)
        if rate:
            self.assertEqual([row[name] for name in ("wx", "wy", "wz")], rate)

    def test_the_table_of_axes(self):
        for options, q, p, w in TABLE:
            with self.subTest(options):
                self.assert_turned(numbers_of(self.output_of(f"convert rated.csv {options}"))[0], q, p, w)
                sampled = numbers_of(self.output_of(f"sample rated.csv {options} --count 2 --derivatives 1"))[0]
                self.assert_turned(sampled, q, p)
                self.assert_near([sampled[name] for name in ("wx", "wy", "wz")], w, 1e-14)

    def test_rates_of_the_world_are_those_of_the_new_one(self):
        options = "--count 2 --derivatives 1 --frame world"
        old = numbers_of(self.output_of(f"sample rated.csv {options}"))[0]
        new = numbers_of(self.output_of(f"sample rated.csv {options} {TABLE[3][0]}"))[0]
        x, y, z = (old[f"w{axis}_world"] for axis in "xyz")
        self.assert_near([new[f"w{axis}_world"] for axis in "xyz"], [-z, x, -y], 1e-15)  # det(W) W ω

    def test_what_is_written_is_in_the_new_axes_and_is_not_turned_again(self):
        self.write("ends.csv", "# orispline: method=rotation-spline:ends=clamped:start_rate=0.1,0.2,0.3:end_rate=0,0,1\n"
                               "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.36,0.48,0\n2,0.8,0,0.6,0\n")
        self.output_of(["convert", "ends.csv", *TO_ROS.split(), "-o", "turned.csv", "--quiet"])
        self.assertIn("start_rate=0.1,-0.2,-0.3:end_rate=0,0,-1", self.read("turned.csv").splitlines()[0])
        at_once = self.output_of(f"sample ends.csv {TO_ROS} --count 9 --derivatives 2")
        again = self.output_of("sample turned.csv --count 9 --derivatives 2")
        for one, other in zip(numbers_of(at_once), numbers_of(again), strict=True):
            self.assert_near(list(one.values()), list(other.values()), 1e-13)
        back = "--world-axes ENU:NED --body-axes FLU:FRD"
        plain = self.output_of("sample ends.csv --count 9 --derivatives 2")
        for one, other in zip(numbers_of(plain), numbers_of(self.output_of(f"sample turned.csv {back} --count 9 --derivatives 2")),
                              strict=True):
            sign = math.copysign(1, one["qw"] * other["qw"])
            self.assert_near(list(one.values()), [value * (sign if name[0] == "q" else 1) for name, value in other.items()], 1e-13)

    def test_every_task_reads_by_them(self):
        rows = "\n".join(f"{t},{math.cos(a)},{math.sin(a)},0,0,{t},0,0" for t, a in ((i / 10, math.sin(i / 10) / 3) for i in range(60)))
        self.write("motion.csv", f"t,qw,qx,qy,qz,px,py,pz\n{rows}\n")
        tasks = ("smooth motion.csv -o out.csv", "reduce motion.csv --tolerance 1deg --position-tolerance 0.1 -o out.csv",
                 "retime motion.csv --max-rate 20deg/s -o out.csv", "tune motion.csv --method timed-c2 -o out.csv")
        for task in tasks:
            with self.subTest(task):
                self.output_of(f"{task} --quiet --world-axes RUB:RFU")
                ys = [row["py"] for row in numbers_of(self.read("out.csv"))]
                zs = [row["pz"] for row in numbers_of(self.read("out.csv"))]
                self.assertEqual((set(ys), set(zs)), ({0.0}, {0.0}))
                axis = [math.hypot(row["qy"], row["qz"]) for row in numbers_of(self.read("out.csv"))]
                self.assertAlmostEqual(axis[0], HALF, delta=1e-3)  # y up became z up: a quarter turn about x is in front of it
        plain = json.loads(self.output_of("compare motion.csv --keep-every 8 --methods auto --json"))
        turned = json.loads(self.output_of(f"compare motion.csv --keep-every 8 --methods auto --json {TO_ROS}"))
        self.assertAlmostEqual(plain[0]["rms_deg"], turned[0]["rms_deg"], delta=1e-9)
        self.output_of(f"inspect motion.csv {TO_ROS} --method auto")
        self.output_of(f"plot motion.csv {TO_ROS} -o plot.svg")
        self.assertIn("<svg", self.read("plot.svg"))

    def test_a_joint_is_turned_as_rows_are(self):
        for task in ("sample arm.bvh --joint Elbow --rate 5", "sample arm.bvh --joint Elbow --rate 5 --method slerp",
                     "convert arm.bvh --joint Elbow", "sample arm.bvh --joint Elbow --rate 5 --space world"):
            with self.subTest(task):
                for old, new in zip(numbers_of(self.output_of(task)), numbers_of(self.output_of(f"{task} --world-axes RUB:RFU")),
                                    strict=True):
                    self.assert_near([new["px"], new["py"], new["pz"]], [old["px"], -old["pz"], old["py"]], 1e-15)
                    w, x, y, z = (old[name] for name in ("qw", "qx", "qy", "qz"))
                    wanted = [HALF * (w - x), HALF * (x + w), HALF * (y - z), HALF * (z + y)]
                    sign = math.copysign(1, sum(a * new[n] for a, n in zip(wanted, ("qw", "qx", "qy", "qz"))))
                    self.assert_near([sign * new[name] for name in ("qw", "qx", "qy", "qz")], wanted, 1e-12)
        self.assert_fails("convert arm.bvh --world-axes RUB:RFU -o out.glb", BAD_USAGE,
                          "--world-axes: found a skeleton as a whole, wanted --joint NAME and an output of one track, such as CSV")
        self.assert_fails("convert arm.bvh --inverse-poses -o out.glb", BAD_USAGE,
                          "--inverse-poses: found a BVH file, which is no table and takes no such option")
        self.assertFalse((self.folder / "out.glb").exists())

    def test_any_rotation_on_either_side(self):
        yaw = "roll_deg=0,pitch_deg=0,yaw_deg=90"
        self.write("mount.csv", f"name,qw,qx,qy,qz\ncam0,{HALF},0,0,{HALF}\n")
        for rotation in (yaw, "mount.csv", f"qw={HALF},qx=0,qy=0,qz={HALF}", "euler=ZXZ,e1_deg=30,e2_deg=0,e3_deg=60"):
            with self.subTest(rotation):
                world = numbers_of(self.output_of(["convert", "rated.csv", "--world-rotation", rotation]))[0]
                self.assert_near([world[name] for name in ("px", "py", "pz", "wx", "wy", "wz")], [-2, 1, 3, 0.1, 0.2, 0.3])
                self.assert_near([world[name] for name in ("qw", "qx", "qy", "qz")],
                                 [0.8 * HALF, -0.12 * HALF, 0.84 * HALF, 0.8 * HALF])
                body = numbers_of(self.output_of(["convert", "rated.csv", "--body-rotation", rotation]))[0]
                self.assert_near([body[name] for name in ("px", "py", "pz", "wx", "wy", "wz")], [1, 2, 3, -0.2, 0.1, 0.3])
        both = numbers_of(self.output_of(["convert", "rated.csv", "--world-rotation", yaw, "--world-axes", "NED:ENU"]))[0]
        self.assert_near([both[name] for name in ("px", "py", "pz")], [-1, 2, -3])  # axes first

    @unittest.skipUnless(RECORDINGS.is_dir(), f"no {RECORDINGS}")
    def test_world_to_camera_poses_give_the_places_of_the_camera(self):
        first = numbers_of(self.output_of(["convert", str(RECORDINGS / "22_colmap.csv"), "--inverse-poses"]))[0]
        self.assert_near([first[name] for name in ("px", "py", "pz")], [3, 0, 1])
        kept = numbers_of(self.output_of(["convert", str(RECORDINGS / "22_colmap.csv"), "--conjugate"]))[0]
        self.assertEqual([kept["px"], kept["py"]], [-3, 1])

    def test_bad_input_is_one_line_and_writes_nothing(self):
        two = "wanted two systems of axes with a colon between them, such as"
        compass = "N or S, E or W, U or D with a compass, such as NED, or R or L, F or B, U or D without one, such as RFU"
        cases = {
            "--world-axes NED": f"--world-axes: found 'NED', {two} NED:ENU",
            "--body-axes FRD": f"--body-axes: found 'FRD', {two} FRD:FLU",
            "--world-axes NEX:ENU": f"--world-axes: found 'NEX', wanted {compass}",
            "--world-axes NFD:ENU": f"--world-axes: found 'NFD', wanted {compass}",
            "--world-axes NE:ENU": f"--world-axes: found 'NE', wanted three letters that say where +x, +y and +z point: {compass}",
            "--world-axes NSD:ENU": "--world-axes: found 'NSD', wanted no two letters along one line, as 'N' and 'S' are: "
                                    "N or S, E or W, U or D",
            "--body-axes NED:FLU": "--body-axes: found 'NED', wanted R or L, F or B, U or D for the axes of a body, such as FRD",
            "--world-axes NED:FLU": "--world-axes: found 'NED:FLU', wanted both with a compass, such as NED:ENU, or both without one, "
                                    "such as RUB:RFU; --world-rotation says how a room lies beside the compass",
            "--world-axes NED:NEU": "--world-axes: found axes of the world of which one system is right-handed and the other "
                                    "left-handed, and axes of the body that keep their hand, wanted a change on both sides or on none "
                                    "(--body-axes FROM:TO changes it there too)",
            "--body-axes RUF:FLU": "--body-axes: found axes of the body of which one system is right-handed and the other "
                                   "left-handed, and axes of the world that keep their hand, wanted a change on both sides or on none "
                                   "(--world-axes FROM:TO changes it there too)",
            "--body-rotation qw=2,qx=0,qy=0,qz=0": "--body-rotation: the quaternion has norm 2, wanted 1 within 0.02",
            "--conjugate --inverse-poses": "--inverse-poses: found --conjugate as well, which turns the orientations back, wanted one "
                                           "of them"}
        for options, message in cases.items():
            with self.subTest(options):
                self.assert_fails(f"convert row.csv {options} -o out.csv", BAD_USAGE, message)
                self.assertFalse((self.folder / "out.csv").exists())

    def test_a_file_of_a_rotation_has_one_row(self):
        self.write("two.csv", "qw,qx,qy,qz\n1,0,0,0\n1,0,0,0\n")
        self.write("mirror.csv", "r11,r12,r13,r21,r22,r23,r31,r32,r33\n1,0,0,0,1,0,0,0,-1\n")
        for name, code, message in (("two.csv", BAD_DATA, "two.csv:3: --body-rotation: found a second row of numbers, wanted one rotation"),
                                    ("mirror.csv", BAD_DATA, "mirror.csv: --body-rotation: the matrix is a reflection: its determinant "
                                                             "is -1, wanted 1"),
                                    ("none.csv", BAD_ACCESS, "none.csv: --body-rotation: cannot open: No such file or directory")):
            self.assert_fails(f"convert row.csv --body-rotation {name} -o out.csv", code, message)
        self.assertFalse((self.folder / "out.csv").exists())


if __name__ == "__main__":
    main()
