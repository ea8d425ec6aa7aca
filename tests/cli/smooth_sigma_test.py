#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline smooth --sigma: its columns, that readers take none of them for a key, its figures, and what it refuses."""
import csv
import json
import math
import random

from command import BAD_DATA, BAD_USAGE, CommandTest, main, rows_of, with_pages

BAND_NAMES = [f"sigma_{k}of6" for k in range(6)]
NAMES = [f"sigma_{letters}{axis}" for letters in ("w", "") for axis in "xyz"]
BEHIND = BAND_NAMES + NAMES


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
        self.assertEqual(list(rows[0])[-12:], BEHIND)
        for row, plain in zip(rows_of(self.read("sigma.csv")), rows_of(self.read("plain.csv")), strict=True):
            self.assertEqual(row[:-12], plain)
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
            self.assertEqual(*(text.replace(",".join(BEHIND), "") for text in (found, wanted)))

    def test_the_summary_says_how_large_they_are(self):
        done = self.run_command("smooth noisy.csv --sigma -o sigma.csv")
        self.assertRegex(done.stdout + done.stderr, r"\ndeviations      RMS \S+° and \S+ °/s per axis\n")

    @with_pages
    def test_the_report_draws_them_as_bands(self):
        self.output_of("smooth noisy.csv --sigma -o sigma.csv --report out.html")
        bands = self.page("out.html")["methods"][0]["bands"]
        self.assertEqual(set(bands), {"angle", "error", "w"})
        self.write("times.txt", "".join(f"{t!r}\n" for t in bands["error"]["t"]))
        rows = self.output_of("sample sigma.csv --times times.txt --band 0.9").splitlines()[1:]
        for high, low, row in zip(*(bands["error"][side] for side in ("high", "low")), rows, strict=True):
            angle = math.degrees(float(row.rpartition(",")[2]))
            self.assertAlmostEqual(high, angle, delta=1e-5 * angle)
            self.assertEqual(low, 0)
        self.assertEqual(len(bands["w"]["t"]), 300)

    def test_refusals(self):
        self.assert_fails("smooth noisy.csv --sigma --rate 100", BAD_USAGE,
                          "--sigma: found --rate as well, wanted keys, which have columns for it, or --band 0.9 for samples")
        self.assert_fails("smooth noisy.csv --sigma -o out.tum", BAD_USAGE,
                          "--sigma: a TUM file has no columns for standard deviations, wanted a CSV file")
        self.assertFalse((self.folder / "out.tum").exists())
        self.assert_fails("smooth noisy.csv --band 0.9 -o out.csv", BAD_USAGE, "--band: wanted --rate as well")
        self.assert_fails("smooth noisy.csv --rate 100 --band 1 -o out.csv", BAD_USAGE, "--band: found '1', wanted a number between 0 and 1")
        self.assert_fails("smooth noisy.csv --rate 100 --band 0.9 -o out.tum", BAD_USAGE,
                          "--band: found '0.9', wanted none for a TUM file, which has no columns for rates")

    def test_samples_have_the_band_of_the_smooth_motion(self):
        direct = self.output_of("smooth noisy.csv --rate 130 --band 0.9")
        self.output_of("smooth noisy.csv --sigma -o sigma.csv")
        self.assertEqual(self.output_of("sample sigma.csv --rate 130 --band 0.9"), direct)
        head, *rows = direct.splitlines()
        self.assertEqual(head.split(",")[-1], "band")
        plain = self.output_of("smooth noisy.csv --rate 130").splitlines()
        self.assertEqual([line.rpartition(",")[0] for line in (head, *rows)], plain)
        first = self.columns("sigma.csv")[0]
        spread = math.sqrt(sum(float(first[name]) ** 2 for name in NAMES[3:]) / 3)
        self.assertAlmostEqual(float(first["sigma_0of6"]), spread, delta=1e-12)
        self.assertAlmostEqual(float(rows[0].rpartition(",")[2]), 2.5002777108094975 * spread, delta=1e-9)  # of chi, 3 degrees
        self.assertGreater(float(self.output_of("sample sigma.csv --rate 130 --band 0.99").splitlines()[1].rpartition(",")[2]), 3.3 * spread)

    def test_the_band_is_that_of_its_curve_and_of_its_keys(self):
        self.output_of("smooth noisy.csv --sigma -o sigma.csv")
        self.output_of("smooth noisy.csv -o plain.csv")
        refused = "has no band, wanted 'measured', or keys that smooth wrote with --sigma"
        self.assert_fails("sample plain.csv --rate 50 --band 0.9", BAD_USAGE, f"--band: method 'hermite-c2' {refused}")
        other = self.run_command("sample sigma.csv --method auto --rate 50 --band 0.9")
        self.assertEqual((other.returncode, other.stdout), (BAD_USAGE, ""))
        self.assertTrue(other.stderr.endswith(f"orispline: --band: method 'auto' {refused}\n"), other.stderr)
        self.write("broken.csv", self.read("sigma.csv").replace(self.columns("sigma.csv")[2]["sigma_3of6"], "-1"))
        self.assert_fails("sample broken.csv --rate 50 --band 0.9", BAD_DATA, "broken.csv:5: key 2: sigma_3of6: found -1, wanted a finite number of at least 0")

    def test_the_band_goes_with_the_keys_when_they_are_converted(self):
        self.output_of("smooth noisy.csv --sigma -o sigma.csv")
        self.output_of("convert sigma.csv --conjugate -o turned.csv")
        self.assertEqual(list(self.columns("turned.csv")[0])[-6:], BAND_NAMES)
        self.output_of("convert sigma.csv -o same.csv")
        self.assertEqual(self.output_of("sample same.csv --rate 130 --band 0.9"), self.output_of("sample sigma.csv --rate 130 --band 0.9"))

    def test_samples_with_a_band_have_none_in_gaps(self):
        rows = recording(300, 0.02).splitlines()
        late = [f"{float(t) + 10 * (float(t) >= 3)},{rest}" for t, rest in (line.split(",", 1) for line in rows[1:])]
        self.write("two.csv", "\n".join([rows[0], *late]) + "\n")
        direct = self.output_of("smooth two.csv --gap 1 --rate 130 --band 0.9")
        self.output_of("smooth two.csv --gap 1 --sigma -o keys.csv")
        self.assertEqual(self.output_of("sample keys.csv --rate 130 --band 0.9"), direct)
        self.assertTrue(all(float(line.rpartition(",")[2]) > 0 for line in direct.splitlines()[1:]))


main()
