#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A TUM file with positions goes through every family and back."""
import json
import math
import pathlib
import unittest

from command import CommandTest, main

DESK = pathlib.Path(__file__).resolve().parents[3] / "shared" / "data" / "trajectory" / "tum_fr2_desk_groundtruth.txt"


def camera(t):
    """A camera on a rising circle that looks ahead and nods: position, then quaternion x, y, z, w."""
    yaw, nod = 0.4 * t, 0.3 * math.sin(t)
    c, s, k, r = math.cos(yaw / 2), math.sin(yaw / 2), math.cos(nod / 2), math.sin(nod / 2)
    return (2 * math.cos(yaw), 2 * math.sin(yaw), 0.1 * t, c * r, s * r, s * k, c * k)


def tum_rows(text):
    return [[float(cell) for cell in line.split()] for line in text.splitlines()]


class Poses(CommandTest):
    def setUp(self):
        super().setUp()
        self.methods = json.loads(self.output_of("methods --json"))
        times = [round(0.5 * k + 0.1 * (k % 3), 1) for k in range(19)]  # 3k+1 keys: every method takes them
        self.keys = [(f"{1311868163 + t:.4f}", *camera(t)) for t in times]
        self.write("keys.tum", "".join(" ".join(map(str, key)) + "\n" for key in self.keys))
        self.write("times.csv", "".join(f"{key[0]}\n" for key in self.keys))

    def test_every_method_writes_what_it_reads_back(self):
        for method in self.methods:
            with self.subTest(method["name"]):
                self.output_of(f"sample keys.tum --method {method['name']} --rate 10 -o motion.tum")
                rows = tum_rows(self.read("motion.tum"))
                self.assertGreater(len(rows), 60)
                for row in rows:
                    self.assertEqual(len(row), 8)
                    self.assertAlmostEqual(math.hypot(*row[4:]), 1, delta=1e-12)
                    self.assertLess(math.hypot(row[1], row[2]), 2.2)
                self.output_of("convert motion.tum -o again.tum")
                self.assertEqual(self.read("again.tum"), self.read("motion.tum"))

    def test_interpolating_methods_give_the_poses_of_the_keys_back(self):
        for method in self.methods:
            if not method["interpolates"] or method["name"] == "bezier":  # which passes through every third key
                continue
            with self.subTest(method["name"]):
                self.output_of(f"sample keys.tum --method {method['name']} --times times.csv -o back.tum")
                for row, key in zip(tum_rows(self.read("back.tum")), self.keys, strict=True):
                    for number, want in zip(row[1:], key[1:], strict=True):
                        self.assertAlmostEqual(number, want, delta=1e-12)

    def test_velocities_are_the_derivatives_of_the_positions(self):
        for method in self.methods:
            with self.subTest(method["name"]):
                text = self.output_of(f"sample keys.tum --method {method['name']} --rate 10000 --from 1311868166.2 "
                                      "--to 1311868166.2002 --derivatives 1 --output-format csv")
                header, *lines = text.splitlines()
                place = header.split(",").index
                before, here, after = [[float(cell) for cell in line.split(",")] for line in lines]
                for axis in "xyz":
                    slope = (after[place("p" + axis)] - before[place("p" + axis)]) / 2e-4
                    self.assertAlmostEqual(here[place("v" + axis)], slope, delta=1e-6)

    @unittest.skipUnless(DESK.exists(), "the recording is not here")
    def test_a_recorded_trajectory_goes_through_every_method(self):
        lines = [line for line in DESK.read_text("utf-8").splitlines() if not line.startswith("#")][:601]
        self.write("desk.tum", "\n".join(lines) + "\n")
        for method in self.methods:
            with self.subTest(method["name"]):
                self.output_of(f"sample desk.tum --method {method['name']} --rate 200 -o smooth.tum")
                self.output_of("convert smooth.tum -o euroc.csv --output-format euroc")
                self.output_of("convert euroc.csv -o back.tum")
                for row, want in zip(tum_rows(self.read("back.tum")), tum_rows(self.read("smooth.tum")), strict=True):
                    self.assertEqual(row[1:], want[1:])

    @unittest.skipUnless(DESK.exists(), "the recording is not here")
    def test_a_whole_recording_is_converted_digit_by_digit(self):
        done = self.run_command(["convert", str(DESK), "--drop-duplicates", "-o", "desk.csv"])
        self.assertEqual(done.returncode, 0, done.stderr)
        self.output_of("convert desk.csv -o desk.tum")
        wanted, seen = [], set()
        for line in DESK.read_text("utf-8").splitlines():
            if not line.startswith("#") and line.split()[0] not in seen:
                seen.add(line.split()[0])
                wanted.append([float(cell) for cell in line.split()])
        rows = tum_rows(self.read("desk.tum"))
        self.assertEqual(len(rows), len(wanted))
        for row, want in zip(rows, wanted):
            self.assertEqual(row[:4], want[:4])
            for number, digits in zip(row[4:], want[4:]):
                self.assertAlmostEqual(number, digits, delta=1e-4)  # norms that are off by up to 9e-5 are made 1


if __name__ == "__main__":
    main()
