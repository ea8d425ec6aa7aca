#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Inner quaternions of the keys, columns a_qw, … and b_qw, …: which are read, which are not, and what commands say about them."""
import json
import math

from command import BAD_DATA, CommandTest, main, rows_of

INNER = ["a_qw", "a_qx", "a_qy", "a_qz", "b_qw", "b_qx", "b_qy", "b_qz"]


def about_z(angle):
    return [math.cos(angle / 2), 0.0, 0.0, math.sin(angle / 2)]


def text_of(rows):
    """Rows of a time, the angle about z, and the angles of a and b; None is free."""
    lines = [",".join(["t", "qw", "qx", "qy", "qz", *INNER])]
    for t, *angles in rows:
        cells = [repr(x) for angle in angles for x in ([float("nan")] * 4 if angle is None else about_z(angle))]
        lines.append(",".join([repr(float(t)), *cells]))
    return "\n".join(lines) + "\n"


BENT = [(0, 0.0, 0.3, None), (1, 0.8, 0.5, 0.9), (2, 1.0, None, 1.6), (3, 1.9, None, 1.5)]


def angle_of(t):
    """Of the curve through BENT, whose slerps about one axis are straight lines of angles."""
    chosen = 1.0 - (0.9 - 0.2) / 4  # key 2 by (22), for the segment that leaves it
    n, inner = int(min(t, 2)), [(0.3, 0.9), (0.5, 1.6), (chosen, 1.5)]
    u, (a, b), (p, q) = t - n, inner[n], (BENT[n][1], BENT[n + 1][1])
    along, across, s = p + u * (q - p), a + u * (b - a), 2 * u * (1 - u)
    return along + s * (across - along)


class Inner(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("bent.csv", text_of(BENT))

    def assert_refuses(self, arguments, code, part):
        done = self.run_command(arguments)
        self.assertEqual((done.returncode, done.stdout), (code, ""))
        self.assertIn(part, done.stderr)

    def test_squad_goes_by_them_and_says_so(self):
        done = self.run_command("sample bent.csv --method squad --rate 10 --derivatives 1 -o out.csv")
        self.assertIn("inner quaternions taken from the keys\n", done.stderr)
        for t, *q, _, _, rate in rows_of(self.read("out.csv")):
            self.assertAlmostEqual(2 * math.atan2(q[3], q[0]), angle_of(t), delta=1e-14)
        arriving, leaving = (1.0 - 0.8) - 2 * (1.6 - 1.0), (1.9 - 1.0) - 2 * (0.9 - 0.2) / 4  # at key 2
        inspected = json.loads(self.output_of("inspect bent.csv --method squad,auto --json"))["methods"]
        self.assertEqual([method["continuity_order"] for method in inspected], [0, 2])
        self.assertAlmostEqual(inspected[0]["angular_velocity_jump_max_rad_s"], abs(arriving - leaving), delta=1e-12)

    def test_other_methods_leave_them_alone(self):
        self.write("plain.csv", "".join(",".join(line.split(",")[:5]) + "\n" for line in text_of(BENT).splitlines()))
        self.write("broken.csv", text_of(BENT).replace("nan", "x", 1))
        for method in ("squad-timed", "auto"):
            wanted = self.output_of(f"sample plain.csv --method {method} --rate 10")
            for name in ("bent.csv", "broken.csv"):
                self.assertEqual(self.output_of(f"sample {name} --method {method} --rate 10"), wanted)
        self.assert_refuses("sample broken.csv --method squad --rate 10", BAD_DATA, "broken.csv:2:10: key 0: found 'x'")

    def test_free_ones_are_chosen(self):
        free = [(t, angle, None, None) for t, angle, _, _ in BENT]
        self.write("free.csv", text_of(free))
        self.write("plain.csv", "".join(",".join(line.split(",")[:5]) + "\n" for line in text_of(free).splitlines()))
        one, two = (self.output_of(f"sample {name} --method squad --rate 30") for name in ("free.csv", "plain.csv"))
        self.assertEqual(one, two)

    def test_keys_that_are_written_for_squad_have_them(self):
        self.write("keys.csv", "# orispline: method=squad\n" + text_of(BENT))
        wanted = self.output_of("sample keys.csv --rate 30")
        self.output_of("convert keys.csv -o again.csv")
        self.assertEqual(self.read("again.csv").splitlines()[1], ",".join(["t", "qw", "qx", "qy", "qz", *INNER]))
        self.assertEqual(self.output_of("sample again.csv --rate 30"), wanted)
        self.output_of("convert keys.csv --output-conjugate -o turned.csv")
        self.assertEqual(self.output_of("sample turned.csv --conjugate --rate 30"), wanted)
        done = self.run_command("convert keys.csv -o keys.tum --json")
        self.assertIn("inner quaternions", json.loads(done.stdout)["dropped_columns"])

    def test_streams_and_pictures_take_them(self):
        one = self.output_of("sample bent.csv --method squad --rate 30")
        self.assertEqual(self.run_command("sample - --method squad --rate 30", input=text_of(BENT)).stdout, one)
        self.output_of("plot bent.csv --method squad -o plot.svg")

    def test_all_four_columns_are_there_or_none(self):
        self.write("keys.csv", "t,qw,qx,qy,qz,b_qw,b_qx\n0,1,0,0,0,1,0\n1,1,0,0,0,1,0\n")
        self.assert_fails("sample keys.csv --method squad --count 3", BAD_DATA,
                          "keys.csv:1: found b_qw, b_qx without b_qy, b_qz, wanted all four columns or none")
        self.output_of("sample keys.csv --method slerp --count 3")
        self.write("keys.csv", text_of(BENT).replace(repr(about_z(0.9)[0]), "0.3"))
        self.assert_refuses("sample keys.csv --method squad --count 3", BAD_DATA, "keys.csv:3:10: key 1: the quaternion has norm")


if __name__ == "__main__":
    main()
