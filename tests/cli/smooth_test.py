#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline smooth: what it writes, that 'sample' reads it, and what it refuses."""
import json
import math
import random

from command import BAD_DATA, BAD_USAGE, CommandTest, main, rows_of, table_of, with_pages


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


def with_gyro(count, rates, conjugate=1):
    """Turns about z, then about x at 50 Hz, with rates of them: rates(a, b, a', b')."""
    lines = ["t,qw,qx,qy,qz,wx,wy,wz"]
    for i in range(count):
        t = i / 50
        a, b = 3 * math.sin(t), math.sin(1.3 * t)
        (c, s), (d, e) = ((math.cos(x / 2), math.sin(x / 2)) for x in (a, b))
        q = (c * d, *(conjugate * x for x in (c * e, s * e, s * d)))
        w = rates(a, b, 3 * math.cos(t), 1.3 * math.cos(1.3 * t))
        lines.append(",".join(repr(x) for x in (t, *q, *w)))
    return "\n".join(lines) + "\n"


def moving(count, noise, outliers=()):
    """The recording beside a path (sin t, cos 2t, 0.3 t) at 50 Hz with noise of `noise` metres per axis; outliers are 1 m off."""
    dice = random.Random(4)
    lines = recording(count, 0.01).splitlines()
    rows = [lines[0] + ",px,py,pz"]
    for i, line in enumerate(lines[1:]):
        path = (math.sin(i / 50) + (1 if i in outliers else 0), math.cos(i / 25), 0.3 * i / 50)
        rows.append(line + "," + ",".join(repr(x + dice.gauss(0, noise)) for x in path))
    return "\n".join(rows) + "\n"


def of_the_body(a, b, da, db):
    return db, da * math.sin(b), da * math.cos(b)


def of_the_world(a, b, da, db):
    return db * math.cos(a), db * math.sin(a), da


class Smooth(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("noisy.csv", recording(400, 0.02, {100, 250}))

    def test_the_end_is_a_sample_too_where_it_is_asked_for(self):
        self.write("keys.csv", with_gyro(40, lambda a, b, da, db: (0, 0, 0)))
        last = lambda arguments: self.output_of(f"smooth keys.csv --loss l2 {arguments}").splitlines()[-1].split(",")[0]
        self.assertEqual([last("--rate 7"), last("--rate 7 --include-end")], ["0.7142857142857143", "0.78"])
        self.assert_fails("smooth keys.csv --include-end", BAD_USAGE, "--include-end: wanted --rate as well")

    def test_writes_keys_with_rates_near_the_truth_and_names_the_outliers(self):
        summary = json.loads(self.output_of("smooth noisy.csv --json -o smooth.csv"))
        self.assertEqual([place["line"] for place in summary["rejected"]], [102, 252])
        self.assertEqual(summary["criterion"], "gcv")
        text = self.read("smooth.csv")
        self.assertTrue(text.startswith("# orispline: method=hermite-c2\nt,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n0,"))
        rows = rows_of(text)
        self.assertEqual(len(rows), 400)
        for row in rows[20:-20]:
            self.assertAlmostEqual(2 * math.atan2(row[4], row[1]), math.sin(row[0]), delta=0.02)
            self.assertAlmostEqual(row[7], math.cos(row[0]), delta=0.1)

    def test_samples_are_those_of_hermite_c2_through_the_keys(self):
        self.output_of("smooth noisy.csv --noise 1deg -o smooth.csv")
        samples = self.output_of("smooth noisy.csv --noise 1deg --rate 130")
        self.assertEqual(samples, self.output_of("sample smooth.csv --method hermite-c2 --rate 130"))

    def test_a_cutoff_out_of_range_is_told_as_a_cutoff(self):
        done = self.run_command("smooth noisy.csv --cutoff 1e-300 -o a.csv")
        self.assertEqual(done.returncode, BAD_USAGE)
        self.assertIn("--cutoff: its smoothing time 1/(2 pi f) is out of range: found 1.59155e+299 s", done.stderr)

    def test_cutoff_and_smoothing_time_are_two_words_for_one_thing(self):
        self.output_of("smooth noisy.csv --smoothing-time 0.1 -o a.csv")
        self.output_of(f"smooth noisy.csv --cutoff {1 / (0.2 * math.pi)!r} -o b.csv")
        for a, b in zip(rows_of(self.read("a.csv")), rows_of(self.read("b.csv")), strict=True):
            for x, y in zip(a, b):
                self.assertAlmostEqual(x, y, delta=1e-9)

    @with_pages
    def test_the_report_shows_the_smoothed_curve_beside_the_recording(self):
        arguments = "smooth noisy.csv -o smooth.csv --json --report out.html"
        summary = json.loads(self.output_of(arguments))
        page = self.page("out.html")
        self.assertEqual(page["command"], "orispline " + arguments)
        self.assertIn("400 samples, 2 rejected", page["title"])
        smoothed, as_read = page["methods"]
        self.assertEqual((smoothed["name"], as_read["name"]), ("smoothed", "as read"))
        rows, wanted = rows_of(self.read("smooth.csv")), rows_of(self.read("noisy.csv"))
        angles = [math.degrees(2 * math.acos(min(1, abs(sum(a * b for a, b in zip(row[1:5], want[1:5]))))))
                  for row, want in zip(rows, wanted, strict=True)]
        self.assertAlmostEqual(smoothed["measures"]["max_deg"], max(angles), delta=1e-5)
        self.assertAlmostEqual(smoothed["measures"]["rms_deg"], math.sqrt(sum(a * a for a in angles) / 400), delta=1e-5)
        rejected = [place["key"] for place in summary["rejected"]]
        counted = [a for i, a in enumerate(angles) if i not in rejected]
        self.assertAlmostEqual(smoothed["measures"]["rms_accepted_deg"], math.sqrt(sum(a * a for a in counted) / 398),
                               delta=1e-5)
        self.assertEqual(page["marks"]["t"], [100 / 50, 250 / 50])
        for mark, key in zip(page["marks"]["error_deg"], rejected, strict=True):
            self.assertAlmostEqual(mark, angles[key], delta=1e-4)
        self.assertEqual(smoothed["samples"]["error_t"], [row[0] for i, row in enumerate(rows) if i not in rejected])
        self.assertAlmostEqual(max(smoothed["samples"]["error_deg"]), max(counted), delta=1e-5)
        self.assertEqual(as_read["samples"]["error_deg"], [])
        self.assertGreater(as_read["measures"]["peak_rate_rad_s"], 10 * smoothed["measures"]["peak_rate_rad_s"])
        self.assertAlmostEqual(smoothed["measures"]["peak_rate_rad_s"], max(math.hypot(*row[5:8]) for row in rows), delta=0.01)
        self.assertEqual(page["keys"]["t"], [row[0] for row in rows])

    @with_pages
    def test_the_report_has_nothing_in_gaps(self):
        lines = recording(400, 0.02).splitlines()
        self.write("gap.csv", "\n".join(lines[:151] + lines[251:253] + lines[301:]) + "\n")  # 3 s to 6 s but 2 samples
        summary = json.loads(self.output_of("smooth gap.csv --gap 0.5 --loss l2 -o smooth.csv --json --report out.html"))
        self.assertEqual((len(summary["stretches"]), len(summary["samples_in_short_stretches"])), (2, 2))
        page = self.page("out.html")
        self.assertTrue(any("The gaps leave 2 stretches" in note for note in page["notes"]))
        for method in page["methods"]:
            samples = method["samples"]
            for i, t in enumerate(samples["t"]):
                for values in (samples["q"][4 * i:4 * i + 4], samples["w"][3 * i:3 * i + 3]):
                    self.assertEqual(None in values, 2.98 + 1e-6 < t < 6 - 1e-6, t)
        in_gap = [e for t, e in zip(page["methods"][0]["samples"]["error_t"], page["methods"][0]["samples"]["error_deg"])
                  if 2.98 < t < 6]
        self.assertEqual(in_gap, [None])
        of_all = "compare smooth.csv --reference smooth.csv --methods hermite-c2 --json"
        whole, kept = (json.loads(self.output_of(words))[0] for words in (f"{of_all} --ignore-recipe", of_all))
        parts = 0.0
        rows = table_of(self.read("smooth.csv"))
        for name, part in (("a.csv", rows[:151]), ("b.csv", rows[:1] + rows[151:])):
            self.write(name, "\n".join(part) + "\n")
            measures = json.loads(self.output_of(f"compare {name} --reference {name} --methods hermite-c2 --json"))[0]
            parts += measures["energy"]
        self.assertAlmostEqual(page["methods"][0]["measures"]["energy"], parts, delta=1e-4 * parts)
        self.assertGreater(whole["energy"], 1.05 * parts)
        self.assertAlmostEqual(kept["energy"], parts, delta=1e-9 * parts)

    @with_pages
    def test_the_report_of_very_many_samples_stays_small(self):
        self.write("long.csv", recording(6000, 0.02, set(range(50, 6000, 100))))
        self.output_of("smooth long.csv --smoothing-time 0.1 --quiet -o smooth.csv --report out.html")
        page = self.page("out.html")
        self.assertEqual(len(page["keys"]["t"]), 2000)
        self.assertTrue(any("Of the 6000 keys 2000 are shown" in note for note in page["notes"]))
        for method in page["methods"]:
            self.assertLessEqual(len(method["samples"]["t"]), 5000)
        self.assertLessEqual(len(page["methods"][0]["samples"]["error_t"]), 2000)
        self.assertLess((self.folder / "out.html").stat().st_size, 2_500_000)

    @with_pages
    def test_reports_are_written_as_by_compare(self):
        self.write("two.csv", recording(2, 0.0))
        self.assert_writes_reports_as_compare("smooth noisy.csv --quiet", "smooth two.csv")

    def test_the_summary_says_how_free_and_how_near_the_curve_is_and_every_warning(self):
        self.write("run.csv", recording(400, 0.02, range(100, 105)))
        done = self.run_command("smooth run.csv --smoothing-time 0.1 --loss tukey -o out.csv --json")
        summary = json.loads(done.stdout)
        self.assertIn("samples in a row do not count", done.stderr)
        self.assertRegex(done.stderr, r"\n.*\d+ of 400 samples \(\d.* %\) are rejected as outliers; if they are motion, set --loss "
                                      r"to l2, which keeps every sample")
        self.assertLess(summary["accepted_rms_distance_rad"], summary["rms_distance_rad"])
        self.assertLess(summary["accepted_largest_distance_rad"], summary["largest_distance_rad"])
        done = self.run_command("smooth noisy.csv -o out.csv")
        self.assertRegex(done.stdout + done.stderr, r"\nfreedom         \S+ effective parameters of 1200\n")
        self.assertRegex(done.stdout + done.stderr, r"\ndistance        RMS \S+°, largest \S+° from the samples; "
                                                    r"\S+° and \S+° without the rejected ones\n")

    def test_tukey_that_gives_up_motion_is_told(self):
        self.write("run.csv", recording(400, 0.02, range(100, 105)))
        for loss, warned in (("tukey", True), ("robust", False)):
            done = self.run_command(f"smooth run.csv --smoothing-time 0.1 --loss {loss} -o out.csv --quiet")
            self.assertEqual("samples in a row do not count, which is rather motion than outliers" in done.stderr, warned)

    def test_a_gyro_in_another_frame_is_refused_with_the_option_that_mends_it(self):
        smoothed = "smooth gyro.csv --gyro --noise 0.1deg -o out.csv --quiet "
        world = "--columns wx_world=wx,wy_world=wy,wz_world=wz"
        for rates, conjugate, said, cure in (
                (of_the_world, 1, "they agree as rates in the frame of the world: --columns wx_world=…", world),
                (of_the_body, -1, "they agree if the orientations turn the other way round: give --conjugate", "--conjugate"),
                (of_the_world, -1, "they agree with all signs reversed", "--conjugate " + world)):
            self.write("gyro.csv", with_gyro(300, rates, conjugate))
            done = self.run_command(smoothed)
            self.assertEqual(done.returncode, BAD_DATA)
            self.assertIn(said, done.stderr)
            self.output_of(smoothed + cure)

    def test_positions_are_smoothed_and_their_outliers_named(self):
        self.write("poses.csv", moving(400, 0.02, {100, 250}))
        summary = json.loads(self.output_of("smooth poses.csv --json -o smooth.csv"))
        self.assertEqual([place["line"] for place in summary["rejected_positions"]], [102, 252])
        self.assertEqual(summary["rejected"], [])
        self.assertEqual(summary["position_criterion"], "gcv")
        self.assertAlmostEqual(summary["position_noise_m"], 0.02, delta=0.002)
        self.assertAlmostEqual(summary["position_cutoff_hz"] * summary["position_smoothing_time_s"], 0.5 / math.pi, delta=1e-12)
        rows, samples = rows_of(self.read("smooth.csv")), rows_of(self.read("poses.csv"))
        apart = [math.dist(row[5:8], sample[5:8]) for row, sample in zip(rows, samples, strict=True)]
        self.assertAlmostEqual(summary["position_largest_distance_m"], max(apart), delta=1e-12)
        self.assertAlmostEqual(summary["position_rms_distance_m"], math.sqrt(sum(d * d for d in apart) / 400), delta=1e-12)
        off = [math.dist(row[5:8], (math.sin(row[0]), math.cos(2 * row[0]), 0.3 * row[0])) for row in rows]
        self.assertLess(math.sqrt(sum(d * d for d in off) / 400), 0.02)  # 0.035 before, and 0.08 with the outliers
        done = self.run_command("smooth poses.csv -o smooth.csv")
        text = done.stdout + done.stderr
        self.assertRegex(text, r"\npositions       smoothing time \S+ s \(cut-off \S+ Hz\), by generalised cross-validation\n"
                               r"  noise         \S+ m per axis in the residuals; \S+ m between neighbours\n"
                               r"  distance      RMS \S+ m, largest \S+ m from the samples; \S+ m and \S+ m without the rejected ones\n"
                               r"  rejected      2: line 102 \(2 s\), line 252 \(5 s\)\n")

    def test_samples_pass_the_smoothed_positions(self):
        self.write("poses.csv", moving(200, 0.02))
        self.output_of("smooth poses.csv -o keys.csv")
        keys = {row[0]: row[5:8] for row in rows_of(self.read("keys.csv"))}
        for row in rows_of(self.output_of("smooth poses.csv --rate 50")):
            self.assertLess(math.dist(row[5:8], keys[row[0]]), 1e-12)

    def test_positions_take_their_own_noise_and_the_same_smoothing_time(self):
        self.write("poses.csv", moving(300, 0.02))
        found = json.loads(self.output_of("smooth poses.csv --position-noise 2cm --json -o out.csv"))
        self.assertEqual((found["position_criterion"], found["criterion"]), ("ubre", "gcv"))
        found = json.loads(self.output_of("smooth poses.csv --cutoff 2 --json -o out.csv"))
        self.assertEqual((found["position_cutoff_hz"], found["position_criterion"]), (found["cutoff_hz"], None))
        found = json.loads(self.output_of("smooth poses.csv --position-noise 2cm --smoothing-time 0.1 --json -o out.csv"))
        self.assertAlmostEqual(found["smoothing_time_s"], 0.1, delta=1e-15)
        self.assertEqual(found["position_criterion"], "ubre")
        found = json.loads(self.output_of("smooth noisy.csv --json -o out.csv"))
        self.assertEqual((found["position_noise_m"], found["rejected_positions"]), (None, None))
        self.assert_fails("smooth noisy.csv --position-noise 2cm", BAD_DATA,
                          "noisy.csv: found no positions, wanted px,py,pz for --position-noise")

    def test_positions_without_noise_stay(self):
        lines = moving(200, 0.0).splitlines()
        self.write("exact.csv", "\n".join(lines) + "\n")
        self.write("still.csv", "\n".join([lines[0]] + [",".join(line.split(",")[:5]) + ",1.5,-2,0" for line in lines[1:]]) + "\n")
        for name in ("exact.csv", "still.csv"):
            done = self.run_command(f"smooth {name} -o out.csv")
            self.assertIn("\npositions       as they were, for hardly any noise was found beside their motion\n", done.stdout + done.stderr)
            self.assertEqual([row[5:8] for row in rows_of(self.read("out.csv"))], [row[5:8] for row in rows_of(self.read(name))])

    def test_refusals(self):
        self.assert_fails("smooth noisy.csv --noise 0deg", BAD_USAGE,
                          "--noise: found '0deg', wanted a number greater than 0 with its unit, deg, rad, mrad or arcsec, such as 1deg")
        self.assert_fails("smooth noisy.csv --noise 1deg --smoothing-time 1", BAD_USAGE,
                          "found several of --noise, --smoothing-time and --cutoff, wanted one: each says how smooth")
        self.assert_fails("smooth noisy.csv --gap 0.01", BAD_USAGE,
                          "--gap: found 0.01 s, wanted more than the median interval of 0.02 s")
        self.assert_fails("smooth noisy.csv --gyro --gyro-noise 0.1deg", BAD_USAGE,
                          "--gyro-noise: found '0.1deg', wanted a number greater than 0 with its unit, deg/s, rad/s, mrad/s or arcsec/s, "
                          "such as 1deg/s")
        self.assert_fails("smooth noisy.csv --gyro-noise 0.1deg/s", BAD_USAGE, "--gyro-noise: wanted --gyro as well")
        self.assert_fails("smooth noisy.csv --gyro --gap 1", BAD_USAGE, "--gap: wanted no --gyro, which bridges gaps")
        self.assert_fails("smooth noisy.csv --noise 40deg", BAD_USAGE,
                          "--noise: found 0.698132 rad, wanted 1e-07 to 0.5 rad")
        self.assert_fails("smooth noisy.csv --gyro", BAD_DATA,
                          "noisy.csv: found no angular velocities of the body, wanted wx,wy,wz of the gyro")
        self.write("two.csv", recording(2, 0.0))
        self.assert_fails("smooth two.csv -o out.csv", BAD_DATA, "two.csv: found 2 samples, wanted at least 3 to smooth")
        self.assertFalse((self.folder / "out.csv").exists())


main()
