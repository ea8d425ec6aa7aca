#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline reduce`: what it certifies, the counts on recordings that lie beside the project, what it refuses."""
import itertools
import json
import math
import os
import pathlib
import random

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, CommandTest, main, rows_of, with_pages

SHARED = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data"))
SPACECRAFT = ["--columns", "t=sclk_ticks,qw=q0_w,qx=q1,qy=q2,qz=q3", "--time-scale", "0.00390625"]


def angle(p, q):
    """Degrees between the orientations of two rows; by the chord, which small angles survive."""
    chord = min(math.dist(p, q), math.dist(p, [-c for c in q]))
    return math.degrees(4 * math.asin(chord / 2))


def turning(count, slope_after):
    """Angles [deg] at whole seconds: 1 a second, from the middle on `slope_after` a second."""
    middle = count // 2
    return [k + (slope_after - 1) * max(0, k - middle) for k in range(count)]


def csv_of(angles):
    return "t,qw,qx,qy,qz\n" + "".join(
        f"{t},{math.cos(math.radians(a) / 2)!r},0,0,{math.sin(math.radians(a) / 2)!r}\n" for t, a in enumerate(angles))


class Reduce(CommandTest):
    def reduced(self, *arguments):
        return json.loads(self.output_of(["reduce", *arguments, "-o", "reduced.csv", "--json"]))

    def counts(self, *arguments):
        return {method["method"]: method["keys"] for method in self.reduced(*arguments)["methods"]}

    def test_a_kink_needs_three_geodesics_keys_and_their_digits_are_kept(self):
        self.write("dense.csv", csv_of(turning(41, 3)))
        report = self.reduced("dense.csv", "--tolerance", "0.01deg", "--method", "slerp")
        self.assertEqual((report["samples"], report["keys"], report["method"]), (41, 3, "slerp"))
        rows = rows_of(self.read("dense.csv"))
        self.assertEqual(rows_of(self.read("reduced.csv")), [rows[0], rows[20], rows[40]])

    def test_slerp_is_optimal_by_all_subsets(self):
        angles = [0, 2, 1, 3, 7, 6, 6.5, 2, 1, 0]
        self.write("dense.csv", csv_of(angles))

        def holds(keys):
            return all(abs(a + (b - a) * (k - i) / (j - i) - angles[k]) <= 1
                       for i, j in zip(keys, keys[1:]) for a, b in [(angles[i], angles[j])] for k in range(i, j))

        fewest = next(n + 2 for n in range(9) for inner in itertools.combinations(range(1, 9), n)
                      if holds((0, *inner, 9)))
        report = self.reduced("dense.csv", "--tolerance", "1.0000001deg", "--method", "slerp")
        self.assertEqual(report["keys"], fewest)

    def test_the_written_keys_reproduce_every_sample(self):
        angles = [20 * math.sin(0.05 * k) + 5 * math.sin(0.31 * k) for k in range(400)]
        self.write("dense.csv", csv_of(angles))
        self.write("times.txt", "".join(f"{t}\n" for t in range(400)))
        for extra in ([], ["--refit"]):
            for method in ("auto", "timed-c2", "slerp"):
                report = self.reduced("dense.csv", "--tolerance", "0.2deg", "--method", method, *extra)
                curve = rows_of(self.output_of(f"sample reduced.csv --method {method} --times times.txt"))
                largest = max(angle(a[1:5], b[1:5]) for a, b in zip(curve, rows_of(self.read("dense.csv"))))
                self.assertLess(report["keys"], 300)
                self.assertLessEqual(report["error_max_deg"], 0.2)
                self.assertAlmostEqual(report["error_max_deg"], largest, delta=1e-9)

    def test_positions_are_bounded_where_that_is_asked_for(self):
        rows = "".join(f"{t},1,0,0,0,{math.sin(0.1 * t)!r},0,0\n" for t in range(100))
        self.write("poses.csv", "t,qw,qx,qy,qz,px,py,pz\n" + rows)
        report = self.reduced("poses.csv", "--tolerance", "1deg", "--position-tolerance", "1mm")
        self.assertTrue(all(m["position_error_max_m"] <= 1e-3 for m in report["methods"]))
        self.assertGreater(report["keys"], 2)
        self.assertEqual(self.reduced("poses.csv", "--tolerance", "1deg")["keys"], 2)

    def test_the_smallest_wins_and_the_smooth_one_of_equals(self):
        self.write("dense.csv", csv_of(turning(41, 1)))
        report = self.reduced("dense.csv", "--tolerance", "0.01deg")
        self.assertEqual((report["method"], [m["keys"] for m in report["methods"]]), ("auto", [2, 2, 2]))

    def test_a_half_turn_between_samples(self):
        self.write("dense.csv", csv_of([0, 180, 360]))
        self.assertEqual(self.reduced("dense.csv", "--tolerance", "1deg", "--method", "slerp")["keys"], 3)

    def test_recordings_need_no_more_keys_than_measured_before(self):
        if not SHARED.exists():
            self.skipTest(f"no {SHARED}")
        flight = str(SHARED / "flight/px4_quad_sample_attitude.csv")
        for tolerance, timed, auto in (("0.1deg", 131, 128), ("0.5deg", 62, 63), ("1deg", 38, 41)):
            counts = self.counts(flight, "--tolerance", tolerance)
            self.assertLessEqual(counts["timed-c2"], timed)
            self.assertLessEqual(counts["auto"], auto)
        craft = [str(SHARED / "spacecraft/mro_ck_sliced_-74000.csv"), *SPACECRAFT]
        for tolerance, slerp, timed, auto in (("0.001deg", 167, 318, 381), ("0.01deg", 32, 23, 21),
                                              ("0.1deg", 10, 11, 9)):
            counts = self.counts(*craft, "--tolerance", tolerance)
            self.assertEqual(counts["slerp"], slerp)
            self.assertLessEqual(counts["timed-c2"], timed)
            self.assertLessEqual(counts["auto"], auto)

    @with_pages
    def test_the_report_shows_all_reductions_with_their_own_keys(self):
        angles = [20 * math.sin(0.05 * k) + 5 * math.sin(0.31 * k) for k in range(400)]
        self.write("dense.csv", csv_of(angles))
        report = self.reduced("dense.csv", "--tolerance", "0.2deg", "--report", "out.html")
        page = self.page("out.html")
        self.assertEqual(page["limits"], {"error": 0.2})
        self.assertEqual(page["methods"][0]["name"], report["method"])
        self.assertEqual(page["keys"]["t"], [row[0] for row in rows_of(self.read("reduced.csv"))])
        self.assertEqual({m["name"] for m in page["methods"]}, {"auto", "timed-c2", "slerp"})
        for method in page["methods"]:
            wanted, = (m for m in report["methods"] if m["method"] == method["name"])
            measures, samples = method["measures"], method["samples"]
            self.assertEqual((measures["keys"], len(method["keys"]["t"])), (wanted["keys"], wanted["keys"]))
            self.assertAlmostEqual(measures["samples_per_key"], 400 / wanted["keys"], delta=1e-4)
            self.assertAlmostEqual(measures["max_deg"], wanted["error_max_deg"], delta=1e-7)
            self.assertEqual(samples["error_t"], list(range(400)))  # at the samples, all of them
            self.assertLessEqual(max(samples["error_deg"]), 0.2)
            self.assertAlmostEqual(max(samples["error_deg"]), wanted["error_max_deg"], delta=1e-7)
            rms = math.sqrt(sum(e * e for e in samples["error_deg"]) / 400)
            self.assertAlmostEqual(measures["rms_deg"], rms, delta=1e-6)
            self.assertEqual(samples["error_t"][samples["error_deg"].index(max(samples["error_deg"]))], measures["max_at_s"])

    @with_pages
    def test_reports_are_written_as_by_compare(self):
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assert_fails("reduce keys.csv --tolerance 1deg --output-folder out --report out/keys.csv", BAD_USAGE,
                          "--report: found 'out/keys.csv', wanted another file than the output")
        self.assert_writes_reports_as_compare("reduce keys.csv --tolerance 1deg --quiet", "reduce one.csv --tolerance 1deg")

    def test_smoothing_first_certifies_the_smoothed_samples_and_states_the_raw_ones(self):
        noise = random.Random(3)
        clean = [20 * math.sin(0.03 * k) for k in range(400)]
        noisy = [a + noise.gauss(0, 0.3) for a in clean]
        noisy[100] += 25
        self.write("noisy.csv", csv_of(noisy))
        self.write("times.txt", "".join(f"{t}\n" for t in range(400)))
        plain = self.reduced("noisy.csv", "--tolerance", "0.5deg", "--method", "auto")
        report = self.reduced("noisy.csv", "--tolerance", "0.5deg", "--method", "auto", "--smooth")
        curve = [row[1:5] for row in rows_of(self.output_of("sample reduced.csv --method auto --times times.txt"))]
        as_smoothed = json.loads(self.output_of("smooth noisy.csv -o smoothed.csv --json"))
        smoothed = [row[1:5] for row in rows_of(self.read("smoothed.csv"))]
        self.assertAlmostEqual(report["error_max_deg"], max(map(angle, curve, smoothed)), delta=1e-9)
        self.assertLessEqual(report["error_max_deg"], 0.5)
        self.assertLess(report["keys"], plain["keys"] / 4)
        smoothing = report["smoothing"]
        for name in ("smoothing_time_s", "cutoff_hz", "criterion", "noise_rad", "rejected"):
            self.assertEqual(smoothing[name], as_smoothed[name])
        self.assertIn({"key": 100, "line": 102, "time_s": "100"}, smoothing["rejected"])
        rejected = [sample["key"] for sample in smoothing["rejected"]]
        raw = [angle(a, b[1:5]) for k, (a, b) in enumerate(zip(curve, rows_of(self.read("noisy.csv"))))
               if k not in rejected]
        self.assertAlmostEqual(smoothing["raw_error_max_deg"], max(raw), delta=1e-9)
        self.assertAlmostEqual(smoothing["raw_error_rms_deg"], math.hypot(*raw) / math.sqrt(len(raw)), delta=1e-9)
        self.assertNotIn("smoothing", plain)

    def test_positions_are_smoothed_first_too_and_the_raw_ones_stated(self):
        noise = random.Random(5)
        rows = [(k / 50, 20 * math.sin(0.03 * k) + noise.gauss(0, 0.3), math.sin(0.03 * k) + noise.gauss(0, 0.01)) for k in range(400)]
        lines = [f"{t!r},{math.cos(math.radians(a / 2))!r},0,0,{math.sin(math.radians(a / 2))!r},{x + (1 if t == 2 else 0)!r},{x!r},1"
                 for t, a, x in rows]
        self.write("poses.csv", "\n".join(["t,qw,qx,qy,qz,px,py,pz", *lines]) + "\n")
        self.write("times.txt", "".join(f"{t!r}\n" for t, _, _ in rows))
        arguments = ("poses.csv", "--tolerance", "0.5deg", "--position-tolerance", "1cm", "--method", "auto")
        plain, report = self.reduced(*arguments), self.reduced(*arguments, "--position-noise", "1cm")
        self.assertLess(report["keys"], plain["keys"] / 2)
        smoothing = report["smoothing"]
        self.assertEqual((smoothing["position_criterion"], smoothing["criterion"]), ("ubre", "gcv"))
        self.assertIn(100, [sample["key"] for sample in smoothing["rejected_positions"]])
        rejected = [sample["key"] for sample in smoothing["rejected_positions"]]
        curve = [row[5:8] for row in rows_of(self.output_of("sample reduced.csv --method auto --times times.txt"))]
        self.output_of("smooth poses.csv --position-noise 1cm -o smoothed.csv --quiet")
        smoothed = [row[5:8] for row in rows_of(self.read("smoothed.csv"))]
        self.assertAlmostEqual(report["position_error_max_m"], max(map(math.dist, curve, smoothed)), delta=1e-9)
        self.assertLessEqual(report["position_error_max_m"], 0.01)
        raw = [math.dist(a, b[5:8]) for k, (a, b) in enumerate(zip(curve, rows_of(self.read("poses.csv")))) if k not in rejected]
        self.assertAlmostEqual(smoothing["raw_position_error_max_m"], max(raw), delta=1e-9)
        self.assertAlmostEqual(smoothing["raw_position_error_rms_m"], math.hypot(*raw) / math.sqrt(len(raw)), delta=1e-9)
        text = self.run_command(["reduce", *arguments, "--smooth", "-o", "reduced.csv"]).stderr
        for line in ("  positions       smoothing time ", "  raw positions   "):
            self.assertIn(line, text)

    def test_what_says_how_smooth_asks_for_smoothing(self):
        noise = random.Random(4)
        self.write("noisy.csv", csv_of([20 * math.sin(0.03 * k) + noise.gauss(0, 0.3) for k in range(200)]))
        arguments = ("noisy.csv", "--tolerance", "0.5deg", "--method", "slerp")
        self.assertEqual(self.reduced(*arguments, "--noise", "0.3deg")["smoothing"]["criterion"], "ubre")
        by_time = self.reduced(*arguments, "--smoothing-time", "2")
        by_cutoff = self.reduced(*arguments, "--smooth", "--cutoff", repr(1 / (4 * math.pi)))
        self.assertEqual((by_time["smoothing"]["smoothing_time_s"], by_time["smoothing"]["criterion"]), (2, None))
        self.assertEqual(by_time["keys"], by_cutoff["keys"])
        self.assertAlmostEqual(by_cutoff["smoothing"]["smoothing_time_s"], 2, delta=1e-12)
        done = self.run_command(["reduce", *arguments, "--smooth", "-o", "reduced.csv"])
        for line in ("  smoothing time  ", "  rejected        ", "  raw samples     "):
            self.assertIn(line, done.stderr)

    def test_several_recordings_at_once_are_as_one_by_one(self):
        os.mkdir(self.folder / "tracks")
        names = ["tracks/a.csv", "b.csv", "c.tum"]
        for k, name in enumerate(names[:2]):
            self.write(name, csv_of([20 * math.sin((0.05 + 0.02 * k) * t) for t in range(200)]))
        self.output_of("convert b.csv -o c.tum")
        common = ["--tolerance", "0.3deg", "--output-folder"]
        documents = {}
        for threads in ("1", "5"):
            text = self.output_of(["reduce", *names, *common, f"keys{threads}/deep", "--threads", threads, "--json"])
            documents[threads] = json.loads(text)
        for k, name in enumerate(names):
            output = f"keys5/deep/{pathlib.Path(name).name}"
            self.assertEqual(documents["5"][k].pop("output"), output)
            del documents["1"][k]["output"]
            alone = self.output_of(["reduce", name, "--tolerance", "0.3deg", "-o", f"alone{k}.{name[-3:]}", "--json"])
            alone = json.loads(alone)
            del alone["output"]
            self.assertEqual(documents["5"][k], alone)
            self.assertEqual(self.read(output), self.read(f"alone{k}.{name[-3:]}"))
            self.assertEqual(self.read(output), self.read(output.replace("keys5", "keys1")))
        self.assertEqual(documents["1"], documents["5"])
        done = self.run_command(["reduce", *names, *common, "tum", "--output-format", "tum"])
        self.assertEqual(sorted(os.listdir(self.folder / "tum")), ["a.tum", "b.tum", "c.tum"])
        self.assertEqual([line.split(":")[0] for line in done.stderr.splitlines()],
                         ["tum/a.tum", "tum/b.tum", "orispline", "tum/c.tum"])
        self.assertIn("warning: c.tum: positions are kept but not checked", done.stderr)

    def test_one_bad_recording_is_named_and_nothing_is_written(self):
        self.write("bad.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,nan,0,0,0\n")
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        reduce = "reduce keys.csv one.csv bad.csv --tolerance 1deg"
        self.assert_fails(f"{reduce} --output-folder out --all-or-none", BAD_DATA,
                          "one.csv: found 1 sample, wanted 2 or more\n"
                          "orispline: bad.csv:3:2: key 1: found 'nan', wanted a finite number "
                          "(--drop-invalid drops such rows)\n"
                          "orispline: 2 of 3 inputs failed; nothing was written")
        self.assertEqual(list((self.folder / "out").iterdir()), [])
        self.assert_fails("reduce keys.csv --tolerance 1deg --output-folder .", BAD_USAGE,
                          "--output-folder: found ., wanted a folder without the inputs")
        self.assert_fails(["reduce", "keys.csv", "--tolerance", "1deg", "--output-folder", ""], BAD_USAGE,
                          "--output-folder: found an empty name, wanted FOLDER")
        self.assert_fails("reduce keys.csv - --tolerance 1deg --output-folder out", BAD_USAGE,
                          "--output-folder: found '-' for an input, wanted files")
        self.assert_fails("reduce keys.csv --tolerance 1deg --output-folder one.csv", BAD_ACCESS,
                          "one.csv: cannot make this folder: Not a directory")
        self.assertEqual(sorted(os.listdir(self.folder)), ["bad.csv", "keys.csv", "one.csv", "out"])

    def test_outputs_are_checked_before_the_work_and_appear_all_or_none(self):
        for name in ("a.csv", "b.csv"):
            self.write(name, csv_of(turning(41, 3)))
        (self.folder / "out/b.csv").mkdir(parents=True)
        self.write("out/a.csv", "old")
        reduce = "reduce a.csv b.csv --tolerance 1deg"
        self.assert_fails(f"{reduce} --output-folder out --all-or-none", BAD_ACCESS,
                          "out/b.csv: cannot write: Is a directory\norispline: 1 of 2 inputs failed; nothing was written")
        self.assertEqual((self.read("out/a.csv"), sorted(os.listdir(self.folder / "out"))), ("old", ["a.csv", "b.csv"]))
        # a complaint of the output comes before those of the samples
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assert_fails("reduce one.csv --tolerance 1deg -o nowhere/out.csv", BAD_ACCESS,
                          "nowhere/out.csv: cannot write: No such file or directory")
        self.assert_fails("reduce one.csv --tolerance 1deg --output-folder a.csv/deep", BAD_ACCESS,
                          "a.csv/deep: cannot make this folder: Not a directory")
        if os.geteuid() != 0:
            (self.folder / "locked").mkdir(mode=0o500)
            self.assert_fails("reduce one.csv --tolerance 1deg --output-folder locked/deep", BAD_ACCESS,
                              "locked/deep: cannot make this folder: Permission denied")

    def test_formats_that_round_times_are_refused(self):
        for output, what in ((["-o", "out.npy"], "-o: a NumPy"), (["-o", "out.csv", "--output-format", "euroc"], "-o: an EuRoC"),
                             (["--output-folder", "out", "--output-format", "npy"], "--output-folder: a NumPy")):
            self.assert_fails(["reduce", "keys.csv", "--tolerance", "1deg", *output], BAD_USAGE,
                              f"{what} file rounds times, and the tolerance may not hold with rounded times; wanted CSV "
                              f"or TUM")

    def test_refused(self):
        unit = "wanted a number greater than 0 with its unit, deg, rad, mrad or arcsec, such as 1deg"
        for text in ("0deg", "-1deg", "1", "nandeg", "1m"):
            self.assert_fails(f"reduce keys.csv --tolerance={text}", BAD_USAGE, f"--tolerance: found '{text}', {unit}")
        self.assert_fails("reduce keys.csv --tolerance 1deg --noise 1deg --cutoff 3", BAD_USAGE,
                          "found several of --noise, --smoothing-time and --cutoff, wanted one: each says how smooth")
        self.assert_fails("reduce keys.csv --tolerance 1e-13rad", BAD_USAGE,
                          "--tolerance: found 1e-13 rad, wanted 1e-12 rad at least: the rounding of orientations is not "
                          "much smaller")
        self.assert_fails("reduce keys.csv --tolerance 1deg --position-tolerance 1mm", BAD_DATA,
                          "keys.csv: found no positions, wanted columns px,py,pz for --position-tolerance")
        self.write("poses.csv", "t,qw,qx,qy,qz,px,py,pz\n0,1,0,0,0,3,0,4\n1,1,0,0,0,0,0,0\n")
        self.assert_fails("reduce poses.csv --tolerance 1deg --position-tolerance 1e-30m", BAD_USAGE,
                          "--position-tolerance: found 1e-30 m, wanted 7.1e-14 m at least: the rounding of these "
                          "positions is not much smaller")
        self.write("one.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assert_fails("reduce one.csv --tolerance 1deg", BAD_DATA,
                          "one.csv: found 1 sample, wanted 2 or more")


if __name__ == "__main__":
    main()
