#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline smooth: what it writes, that 'sample' reads it, and what it refuses."""
import json
import math
import random

from command import BAD_DATA, BAD_USAGE, CommandTest, main, rows_of


def recording(count, noise, outliers=()):
    """A turn about z of sin t at 50 Hz, then one about a random vector; angles in radians."""
    dice = random.Random(1)
    lines = ["t,qw,qx,qy,qz"]
    for i in range(count):
        half = 0.5 * (math.sin(0.02 * i) + (0.5 if i in outliers else 0))
        c, s = math.cos(half), math.sin(half)
        x, y, z = (0.5 * dice.gauss(0, noise) for _ in range(3))
        w = math.sqrt(1 - x * x - y * y - z * z)
        lines.append(f"{i / 50},{c * w - s * z!r},{c * x - s * y!r},{c * y + s * x!r},{c * z + s * w!r}")
    return "\n".join(lines) + "\n"


class Smooth(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("noisy.csv", recording(400, 0.02, {100, 250}))

    def test_writes_keys_with_rates_near_the_truth_and_names_the_outliers(self):
        summary = json.loads(self.output_of("smooth noisy.csv --json -o smooth.csv"))
        self.assertEqual([place["line"] for place in summary["rejected"]], [102, 252])
        self.assertEqual(summary["criterion"], "gcv")
        text = self.read("smooth.csv")
        self.assertTrue(text.startswith("t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n0,"))
        rows = rows_of(text)
        self.assertEqual(len(rows), 400)
        for row in rows[20:-20]:
            self.assertAlmostEqual(2 * math.atan2(row[4], row[1]), math.sin(row[0]), delta=0.02)
            self.assertAlmostEqual(row[7], math.cos(row[0]), delta=0.1)

    def test_samples_are_those_of_hermite_c2_through_the_keys(self):
        self.output_of("smooth noisy.csv --noise 1deg -o smooth.csv")
        samples = self.output_of("smooth noisy.csv --noise 1deg --rate 130")
        wanted = self.output_of("sample smooth.csv --method hermite-c2 --rate 130")
        self.assertEqual(samples.splitlines()[0], wanted.splitlines()[0])
        for row, want in zip(rows_of(samples), rows_of(wanted), strict=True):
            for cell, want_cell in zip(row, want, strict=True):
                self.assertAlmostEqual(cell, want_cell, delta=1e-10)

    def test_cutoff_and_smoothing_time_are_two_words_for_one_thing(self):
        self.output_of("smooth noisy.csv --smoothing-time 0.1 -o a.csv")
        self.output_of(f"smooth noisy.csv --cutoff {1 / (0.2 * math.pi)!r} -o b.csv")
        for a, b in zip(rows_of(self.read("a.csv")), rows_of(self.read("b.csv")), strict=True):
            for x, y in zip(a, b):
                self.assertAlmostEqual(x, y, delta=1e-9)

    def test_refusals(self):
        self.assert_fails("smooth noisy.csv --noise 0deg", BAD_USAGE,
                          "--noise: found '0deg', wanted a number greater than 0 with its unit, deg or rad, such as 1deg")
        self.assert_fails("smooth noisy.csv --noise 1deg --smoothing-time 1", BAD_USAGE,
                          "found several of --noise, --smoothing-time and --cutoff, wanted one: each says how smooth")
        self.assert_fails("smooth noisy.csv --gap 0.01", BAD_USAGE,
                          "noisy.csv: gap: found 0.01 s, wanted more than the median interval of 0.02 s")
        self.assert_fails("smooth noisy.csv --gyro", BAD_DATA,
                          "noisy.csv: found no angular velocities, wanted those of the gyro")
        self.write("two.csv", recording(2, 0.0))
        self.assert_fails("smooth two.csv -o out.csv", BAD_DATA, "two.csv: found 2 samples, wanted at least 3 to smooth")
        self.assertFalse((self.folder / "out.csv").exists())


main()
