#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Orientations that are stated otherwise than by quaternions, in and out."""
import math

from command import BAD_DATA, CommandTest, main, rows_of

# A quarter turn about z, then one about the body's x: its y points up, its z along the world's x.
HALVES = "0.5,0.5,0.5,0.5"
MATRIX = "0,0,1,1,0,0,0,1,0"
ANGLE = 2 * math.pi / 3 / math.sqrt(3)


class Orientations(CommandTest):
    def quaternion_of(self, header, row, options=""):
        self.write("in.csv", f"t,{header}\n7,{row}\n")
        return rows_of(self.output_of(f"convert in.csv {options}"))[0][1:]

    def assert_turned(self, numbers, wanted=(0.5, 0.5, 0.5, 0.5)):
        self.assertEqual(len(numbers), len(wanted))
        for number, want in zip(numbers, wanted):
            self.assertAlmostEqual(number, want, delta=1e-15)

    def test_every_form_is_read(self):
        self.assert_turned(self.quaternion_of("roll_deg,pitch_deg,yaw_deg", "90,0,90"))
        self.assert_turned(self.quaternion_of("yaw_rad,pitch_rad,roll_rad", f"{math.pi / 2},0,{math.pi / 2}"))
        self.assert_turned(self.quaternion_of("roll,pitch,yaw", "90,0,90", "--angle-unit deg"))
        self.assert_turned(self.quaternion_of("e1_deg,e2_deg,e3_deg", "90,90,0", "--euler ZXY"))
        self.assert_turned(self.quaternion_of("e1_deg,e2_deg,e3_deg", "0,90,90", "--euler yxz"))
        self.assert_turned(self.quaternion_of("a_deg,b_deg,c_deg", "90,90,0",
                                              "--euler ZXZ --columns e1=a_deg,e2=b_deg,e3=c_deg"))
        self.assert_turned(self.quaternion_of("r11,r12,r13,r21,r22,r23,r31,r32,r33", MATRIX))
        self.assert_turned(self.quaternion_of("rx,ry,rz", f"{ANGLE},{ANGLE},{ANGLE}"))
        self.assert_turned(self.quaternion_of("qw,qx,qy,qz,rx,ry,rz", f"1,0,0,0,{ANGLE},{ANGLE},{ANGLE}",
                                              "--input-orientation rotvec"))

    def test_angles_without_a_unit_are_refused_with_both_ways_out(self):
        self.write("in.csv", "t,roll,pitch,yaw\n0,0,0,0\n")
        self.assert_fails("convert in.csv", BAD_DATA, "in.csv:1: 'yaw' has no unit, wanted a name such as yaw_deg or "
                                                      "yaw_rad, or the unit (--angle-unit deg|rad|mrad|arcsec)")

    def test_every_form_is_written(self):
        self.write("in.csv", f"t,qw,qx,qy,qz\n7,{HALVES}\n")
        for options, header, wanted in (
                ("--output-orientation quaternion", "qw,qx,qy,qz", (0.5, 0.5, 0.5, 0.5)),
                ("--output-orientation euler", "roll_deg,pitch_deg,yaw_deg", (90, 0, 90)),
                ("--output-angle-unit rad", "roll_rad,pitch_rad,yaw_rad", (math.pi / 2, 0, math.pi / 2)),
                ("--output-euler ZXZ", "e1_deg,e2_deg,e3_deg", (90, 90, 0)),
                ("--output-euler xyz", "e1_deg,e2_deg,e3_deg", (90, 0, 90)),
                ("--output-orientation matrix", "r11,r12,r13,r21,r22,r23,r31,r32,r33", (0, 0, 1, 1, 0, 0, 0, 1, 0)),
                ("--output-orientation rotvec", "rx,ry,rz", (ANGLE, ANGLE, ANGLE))):
            for command in ("convert in.csv", "sample in.csv --count 1 --derivatives 0"):
                with self.subTest(options, command=command):
                    text = self.output_of(f"{command} {options}")
                    self.assertEqual(text.splitlines()[0], "t," + header)
                    for number, want in zip(rows_of(text)[0][1:], wanted, strict=True):
                        self.assertAlmostEqual(number, want, delta=2e-14)

    def test_a_gimbal_lock_leaves_the_third_angle_at_zero(self):
        self.write("in.csv", "t,roll_deg,pitch_deg,yaw_deg\n7,30,90,50\n8,30,-90,50\n")
        up, down = rows_of(self.output_of("convert in.csv --output-orientation euler --no-continuous"))
        self.assertEqual((up[1:3], down[1:3]), ([0, 90], [0, -90]))
        self.assertAlmostEqual(up[3], 20, delta=1e-12)
        self.assertAlmostEqual(down[3], 80, delta=1e-12)

    def test_rates_and_positions_stand_beside_every_form(self):
        self.write("in.csv", "t,roll_deg,pitch_deg,yaw_deg,px,py,pz\n0,0,0,0,1,2,3\n1,0,0,90,1,2,4\n")
        text = self.output_of("sample in.csv --method slerp --count 2 --derivatives 1 --output-orientation euler")
        self.assertEqual(text.splitlines()[0], "t,roll_deg,pitch_deg,yaw_deg,px,py,pz,wx,wy,wz,vx,vy,vz")
        for number, want in zip(rows_of(text)[1], (1, 0, 0, 90, 1, 2, 4, 0, 0, math.pi / 2, 0, 0, 1)):
            self.assertAlmostEqual(number, want, delta=1e-13)

    def test_a_matrix_that_is_none_is_refused_by_every_command(self):
        self.write("in.csv", "t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,1,0,0,0,1,0,0,0,-1\n")
        for command in ("convert in.csv", "sample in.csv --count 1", "inspect in.csv"):
            done = self.run_command(command)
            self.assertEqual(done.returncode, BAD_DATA)
            self.assertIn("the matrix is a reflection: its determinant is -1, wanted 1", done.stderr)


if __name__ == "__main__":
    main()
