#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The benchmarks with tiny sizes: every contender agrees with its definition, and ratios.json has all its members."""
import json
import math
import pathlib
import subprocess
import sys
import unittest

RUN = pathlib.Path(__file__).resolve().parents[2] / "benchmarks" / "run.py"
NUMBERS = """vs_eigen_product vs_eigen_slerp fma_fraction write_multiple many_curves_vs_libm many_curves_float_vs_libm
random_access_ns rational_ns rational_vs_fastest setup_ns_per_key rates_ns max_error_double max_error_float auto_ns
measured_ns""".split()
PROGRAM, FOLDER = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])


class Ratios(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        subprocess.run([sys.executable, RUN, PROGRAM, FOLDER, "--sizes", "smoke"], check=True)
        cls.ratios = json.loads((FOLDER / "ratios.json").read_text("utf-8"))

    def test_every_number_is_there(self):
        for name in NUMBERS:
            with self.subTest(name):
                self.assertTrue(math.isfinite(self.ratios[name]) and self.ratios[name] > 0.0)
        self.assertIn("online_append_ns_p999", self.ratios)

    def test_the_build_is_named(self):
        self.assertIn(self.ratios["isa"], {"v2", "v3", "v4", "native"})
        self.assertIsInstance(self.ratios["contraction"], bool)
        self.assertIsInstance(self.ratios["machine"], str)

    def test_ours_is_as_exact_as_promised(self):
        self.assertLessEqual(self.ratios["max_error_double"], 1.2e-15)
        self.assertLessEqual(self.ratios["max_error_float"], 3e-7)

    def test_unknown_sizes_are_refused_in_one_line(self):
        run = subprocess.run([PROGRAM, "--sizes=huge"], capture_output=True, text=True, check=False)
        self.assertEqual((run.returncode, run.stderr),
                         (1, "orispline_bench: the sizes are 'huge', wanted full, quick or smoke\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
