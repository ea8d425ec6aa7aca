#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline smooth --sigma: its columns, that readers take none of them for a key, its figures, and what it refuses."""
import csv
import json
import math
import random

from command import BAD_USAGE, CommandTest, main, rows_of, with_pages

NAMES = [f"sigma_{letters}{axis}" for letters in ("w", "") for axis in "xyz"]


def recording(count, noise):
    """A turn about z of sin t at 50 Hz, then one about a random vector; angles in radians."""
    dice = random.Random(1)
    lines = ["t,qw,qx,qy,qz"]
    for i in range(count):
        c, s = math.cos(0.5 * math.sin(0.02 * i)), math.sin(0.5 * math.sin(0.02 * i))
        x, y, z = (0.5 * dice.gauss(0, noise) for _ in range(3))
        w = math.sqrt(1 - x * x - y * y - z * z)
        lines.append(f"{i / 50},{c * w - s * z!r},{c * x - s * y!r},{c * y + s * x!r},{c * z + s * w!r}")
    return "\n".join(lines) + "\n"


class Sigma(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("noisy.csv", recording(300, 0.02))

    def columns(self, name):
        table = [line for line in self.read(name).splitlines() if not line.startswith("#")]
        return list(csv.DictReader(table))

    def test_keys_have_the_columns_behind_all_others_and_else_are_the_same(self):
        self.output_of("smooth noisy.csv -o plain.csv")
        summary = json.loads(self.output_of("smooth noisy.csv --sigma -o sigma.csv --json"))
        rows = self.columns("sigma.csv")
        self.assertEqual(list(rows[0])[-6:], NAMES)
        for row, plain in zip(rows_of(self.read("sigma.csv")), rows_of(self.read("plain.csv")), strict=True):
            self.assertEqual(row[:-6], plain)
        for names, member in ((NAMES[3:], "rms_sigma_rad"), (NAMES[:3], "rms_sigma_of_rates_rad_s")):
            square = sum(float(row[name]) ** 2 for row in rows for name in names) / (3 * len(rows))
            self.assertAlmostEqual(summary[member], math.sqrt(square), delta=1e-9 * summary[member])
        self.assertLess(summary["rms_sigma_rad"], summary["noise_rad"])
        self.assertIsNone(json.loads(self.output_of("smooth noisy.csv -o plain.csv --json"))["rms_sigma_rad"])

    def test_no_reader_takes_them_for_keys(self):
        self.output_of("smooth noisy.csv -o plain.csv")
        self.output_of("smooth noisy.csv --sigma -o sigma.csv")
        for arguments in ("sample {} --rate 70", "inspect {}", "inspect {} --json"):
            found, wanted = (self.output_of(arguments.format(name)).replace(name, "") for name in ("sigma.csv", "plain.csv"))
            self.assertEqual(*(text.replace(",".join(NAMES), "") for text in (found, wanted)))

    def test_the_summary_says_how_large_they_are(self):
        done = self.run_command("smooth noisy.csv --sigma -o sigma.csv")
        self.assertRegex(done.stdout + done.stderr, r"\ndeviations      RMS \S+° and \S+ °/s per axis\n")

    @with_pages
    def test_the_report_draws_them_as_bands(self):
        self.output_of("smooth noisy.csv --sigma -o sigma.csv --report out.html")
        bands = self.page("out.html")["methods"][0]["bands"]
        self.assertEqual(set(bands), {"error", "w"})
        for high, row in zip(bands["error"]["high"], self.columns("sigma.csv"), strict=True):
            angle = math.degrees(math.hypot(*(float(row[name]) for name in NAMES[3:])))
            self.assertAlmostEqual(high, angle, delta=1e-6 * angle)

    def test_refusals(self):
        self.assert_fails("smooth noisy.csv --sigma --rate 100", BAD_USAGE,
                          "--sigma: found --rate as well, wanted keys: standard deviations are those of keys")
        self.assert_fails("smooth noisy.csv --sigma -o out.tum", BAD_USAGE,
                          "--sigma: a TUM file has no columns for standard deviations, wanted a CSV file")
        self.assertFalse((self.folder / "out.tum").exists())


main()
