#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline smooth` on recordings with noise, against what the reference implementation finds on the same samples.

The recordings are not part of the project, for their licences differ: they are read where they lie beside it.
tools/measure.py smoothing --golden wrote the reference's figures.
"""
import csv
import json
import os
import pathlib
import sys
import unittest

from command import CommandTest, main

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from motions.noisy_recordings import GYRO_NOISE, NOISES, RECORDINGS, options_of, recording, rms_degrees, with_noise

DATA = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data"))
GOLDEN = ROOT / "tests" / "data" / "golden" / "smooth_recordings.csv"


@unittest.skipUnless(DATA.is_dir(), f"no {DATA}")
class SmoothRecordings(CommandTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.clean = {name: recording(name, DATA) for name in RECORDINGS}
        with open(GOLDEN, encoding="utf-8") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            cls.golden = {(row["recording"], row["way"], float(row["noise_deg"])): row for row in rows if row["seed"] == "0"}

    def smoothed(self, motion, options):
        path = self.folder / "noisy.csv"
        motion.write(path)
        self.output_of(["smooth", str(path), *options, "--quiet", "-o", str(self.folder / "smooth.csv")])
        with open(self.folder / "smooth.csv", encoding="utf-8") as file:
            rows = csv.DictReader(line for line in file if not line.startswith("#"))
            return [tuple(float(row[c]) for c in ("qw", "qx", "qy", "qz")) for row in rows]

    def test_errors_are_those_of_the_reference(self):
        self.assertEqual(len(self.golden), 3 * len(NOISES) * len(RECORDINGS) + len(GYRO_NOISE) * len(NOISES))
        for (name, way, noise), row in self.golden.items():
            with self.subTest(recording=name, way=way, noise=noise):
                clean = self.clean[name]
                options = options_of(way, name, noise)
                found = rms_degrees(self.smoothed(with_noise(clean, noise, 0), options), clean.orientations)
                wanted = float(row["error_deg"])
                if way == "gyro":  # the reference knows neither scale nor mount, and nothing of a bias that drifts
                    self.assertLess(found, (1.02 if (name, noise) == ("BROAD", 3.0) else 1.01) * wanted)
                else:
                    self.assertLess(abs(found - wanted), 1e-3 * wanted)

    def test_the_clocks_of_real_gyros_are_late(self):
        for name, late, share in (("BROAD", 0.0042, 0.75), ("PX4", 0.0019, 0.8)):
            with self.subTest(recording=name):
                clean, options = self.clean[name], options_of("gyro", name, 0.2)
                noisy, where = with_noise(clean, 0.2, 0), options.index("--gyro-offset")
                in_step = rms_degrees(self.smoothed(noisy, options), clean.orientations)
                corrected = rms_degrees(self.smoothed(noisy, options[:where]), clean.orientations)
                self.assertLess(corrected, share * in_step)
                told = json.loads(self.output_of(["smooth", str(self.folder / "noisy.csv"), *options[:where], "--json", "-o", "out.csv"]))
                self.assertLess(abs(told["gyro_offset_s"] - late), 0.0003)

    def test_outliers_cost_little(self):
        for name, clean in self.clean.items():
            with self.subTest(recording=name):
                without, outliers = (rms_degrees(self.smoothed(with_noise(clean, 1.0, 0, share), []), clean.orientations)
                                     for share in (0.0, 0.02))
                self.assertLess(outliers, 1.1 * without)


if __name__ == "__main__":
    main()
