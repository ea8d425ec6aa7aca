#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline align of gyros: two of them, or one and orientations, by the columns of their files."""
import json
import math
import os
import pathlib
import random
import unittest

from command import BAD_DATA, BAD_USAGE, CommandTest, main, table_of

RECORDINGS = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "")).parent / "cases/recordings"
LATE = 0.31  # of the gyro [s], which is turned by 90° about z: its x is the y of the body
BIAS = (0.02, -0.01, 0.03)


def rate(t):
    """Of the body [rad/s]."""
    return (1.2 * math.sin(1.7 * t) + math.cos(4.1 * t), math.cos(2.3 * t) + 0.7 * math.sin(0.9 * t), math.sin(3.1 * t + 1))


def table(names, rows):
    return ",".join(names) + "\n" + "".join(",".join(repr(float(x)) for x in row) + "\n" for row in rows)


def gyro(rates, *, noise=0.01, seed=1, names=("t", "wx", "wy", "wz"), scale=1.0):
    dice = random.Random(seed)
    return table(names, [(t, *(scale * (w + dice.gauss(0, noise)) for w in rates(t))) for t in (i / 50 for i in range(1500))])


def mounted(t):
    x, y, z = rate(t - LATE)
    return (y + BIAS[0], -x + BIAS[1], z + BIAS[2])


class AlignRates(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("mounted.csv", gyro(mounted, seed=1))
        self.write("body.csv", gyro(rate, seed=2))

    def assert_is_mounted(self, found, sign=1):
        self.assertAlmostEqual(found["offset_s"], sign * LATE, delta=1e-3)
        self.assertAlmostEqual(found["body"]["qw"], math.sqrt(0.5), delta=1e-3)
        self.assertAlmostEqual(found["body"]["qz"], sign * math.sqrt(0.5), delta=1e-3)
        for value, sigma, true in zip(found["bias_rad_s"], found["bias_sigma_rad_s"], BIAS):
            self.assertLess(abs(value - true), 4 * sigma)
            self.assertLess(sigma, 1e-3)

    def test_finds_how_a_gyro_is_mounted_beside_another(self):
        found = json.loads(self.output_of("align mounted.csv body.csv --json"))
        self.assertEqual(found["gyros"], {"input": True, "reference": True})
        self.assertEqual((found["samples"], found["open"], found["warnings"]), (1500, [], []))
        self.assert_is_mounted(found)
        self.assertIsNone(found["distance_rms_deg"])

    def test_reads_units_and_standard_input(self):
        degrees = gyro(mounted, seed=1, names=("time", "wx_deg_s", "wy_deg_s", "wz_deg_s"), scale=180 / math.pi)
        self.assert_is_mounted(json.loads(self.output_of("align - body.csv --json", input=degrees)))
        self.assert_is_mounted(json.loads(self.output_of("align mounted.csv - --json", input=self.read("body.csv"))))

    def test_writes_the_rates_in_the_axes_and_on_the_clock_of_the_body(self):
        done = self.run_command("align mounted.csv body.csv -o there.csv")
        self.assertIn("1500 rates of a gyro from mounted.csv onto 1500 rates of a gyro from body.csv\n", done.stderr)
        self.assertIn("rates written to there.csv\n", done.stderr)
        header, *rows = self.read("there.csv").splitlines()
        self.assertEqual(header, "t,wx,wy,wz")
        squares = [sum((a - b) ** 2 for a, b in zip(w, rate(t))) for t, *w in ([float(x) for x in row.split(",")] for row in rows)]
        self.assertLess(math.sqrt(sum(squares) / 3 / len(squares)), 0.011)
        self.assert_fails("align mounted.csv body.csv -o there.csv --output-format tum", BAD_USAGE,
                          "--output-format: found INPUT of a gyro, wanted none: its rates are written as t,wx,wy,wz")

    @unittest.skipUnless(RECORDINGS.exists(), "the recordings are not at hand")
    def test_finds_the_clock_of_a_gyro_beside_poses(self):
        rows = [line.split(",") for line in (RECORDINGS / "04n_99ms.csv").read_text().splitlines()]
        self.assertEqual(rows[0], ["t", "qw", "qx", "qy", "qz", "wx", "wy", "wz"])
        self.write("poses.csv", "\n".join(",".join(row[:5]) for row in rows) + "\n")
        self.write("gyro.csv", "\n".join(",".join([row[0], *row[5:]]) for row in rows) + "\n")
        found = json.loads(self.output_of("align gyro.csv poses.csv --json"))
        self.assertAlmostEqual(found["offset_s"], 0.099, delta=1e-3)
        self.assertLess(found["offset_sigma_s"], 3e-4)
        self.assertAlmostEqual(found["body"]["qw"], 1.0, delta=1e-6)
        self.assertLess(abs(found["excess"] - 1), 0.1)
        back = json.loads(self.output_of("align poses.csv gyro.csv -o there.csv --json"))
        self.assertEqual(back["offset_s"], -found["offset_s"])
        self.assertEqual(len(table_of(self.read("there.csv"))), len(rows))

    def test_says_what_one_axis_leaves_open(self):
        self.write("one.csv", gyro(lambda t: (0.0, 0.0, rate(t)[0]), seed=3))
        self.write("other.csv", gyro(lambda t: (0.0, 0.0, rate(t)[0]), seed=4))
        done = self.run_command("align one.csv other.csv")
        self.assertIn("warning: the recordings do not tell apart: a turn of the body about (", done.stderr)
        self.assertIn("offset          ", done.stdout)

    def test_refuses_what_cannot_be_aligned(self):
        self.write("rest.csv", gyro(lambda t: (0.0, 0.0, 0.0), seed=5))
        self.write("still.csv", gyro(lambda t: (0.0, 0.0, 0.0), seed=6))
        self.assert_fails("align rest.csv still.csv", BAD_DATA,
                          "found no change of the rates that stands out of the noise, as where a body rests or turns evenly, wanted one "
                          "that turns to and fro, best about two axes or three")
        self.write("few.csv", "t,wx,wy,wz\n0,1,2,3\n1,1,2,3\n")
        self.assert_fails("align few.csv body.csv", BAD_DATA, "found 2 rates, wanted 8 at least")
        self.assert_fails("align mounted.csv body.csv --offset 100", BAD_USAGE,
                          "--offset: found recordings of which fewer than 8 turns of 0.05 s lie side by side with it, wanted an offset that brings "
                          "them together, or none")
        self.assert_fails("align - -", BAD_USAGE, "found '-' for INPUT and for REFERENCE, wanted it for one at most")


if __name__ == "__main__":
    main()
