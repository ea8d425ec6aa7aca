#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `orispline compare` measures, against figures that follow from the motion by hand."""
import csv
import io
import json
import math
import pathlib

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, SUCCESS, CommandTest, main, with_pages, without_pages
from page_data import HALF_FLOAT


def motion_about_z(angle, rate, count=41, step=0.05):
    """A recording of turns about z, with its angular velocity."""
    lines = ["t,qw,qx,qy,qz,wx,wy,wz"]
    for i in range(count):
        t = i * step
        lines.append(f"{t:.2f},{math.cos(angle(t) / 2)!r},0,0,{math.sin(angle(t) / 2)!r},0,0,{rate(t)!r}")
    return "\n".join(lines) + "\n"


class Compare(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("cubic.csv", motion_about_z(lambda t: t ** 3 / 4, lambda t: 0.75 * t * t))

    def compared(self, arguments, **options):
        return json.loads(self.output_of(f"compare {arguments} --json", **options))

    def test_a_cubic_turn_is_followed_exactly_by_auto_and_by_chords_by_slerp(self):
        auto, slerp = self.compared("cubic.csv --keep-every 10 --methods slerp,auto")
        self.assertEqual((auto["method"], slerp["method"]), ("auto", "slerp"))
        self.assertEqual((auto["keep_every"], auto["keys"], auto["samples"], auto["error"]), (10, 5, 41, None))
        self.assertLess(auto["max_deg"], 1e-10)
        self.assertLess(auto["rate_rms_rad_s"], 1e-11)
        self.assertAlmostEqual(auto["energy"], 6.0, delta=1e-10)  # the integral of (1.5 t)²
        self.assertAlmostEqual(auto["jerk_energy"], 4.5, delta=1e-9)
        self.assertAlmostEqual(auto["peak_rate_rad_s"], 3.0, delta=1e-10)
        self.assertAlmostEqual(auto["peak_rate_at_s"], 2.0, delta=1e-9)
        self.assertLessEqual(auto["peak_rate_rad_s"], auto["peak_rate_bound_rad_s"])
        self.assertLess(auto["peak_rate_bound_rad_s"], 1.001 * 3.0)
        self.assertAlmostEqual(auto["angle_travelled_deg"], math.degrees(2), delta=1e-8)
        times = [0.05 * i for i in range(41)]
        chord = [(math.floor(t / 0.5 + 1e-9) * 0.5) for t in times]
        errors = [abs((k ** 3 + (t - k) / 0.5 * ((k + 0.5) ** 3 - k ** 3) - t ** 3) / 4) for t, k in zip(times, chord)]
        self.assertAlmostEqual(slerp["rms_deg"], math.degrees(math.sqrt(sum(e * e for e in errors) / 41)), delta=1e-10)
        self.assertAlmostEqual(slerp["max_deg"], math.degrees(max(errors)), delta=1e-10)
        self.assertAlmostEqual(slerp["max_at_s"], 1.75, delta=1e-9)
        self.assertAlmostEqual(slerp["mse_rad2"], sum(e * e for e in errors) / 41, delta=1e-14)
        self.assertAlmostEqual(slerp["spherical_max_rad"], max(errors) / 2, delta=1e-12)
        self.assertEqual((slerp["continuity"], auto["continuity"]), (0, 3))

    def test_the_last_sample_counts_only_where_it_is_kept(self):
        at_7, at_20 = (self.compared(f"cubic.csv --keep-every {n} --methods slerp")[0] for n in (7, 20))
        self.assertEqual((at_7["keys"], at_7["samples"]), (6, 36))  # keys 0, 7, …, 35
        self.assertEqual((at_20["keys"], at_20["samples"]), (3, 41))

    def test_several_decimations_give_an_object_each(self):
        rows = self.compared("cubic.csv --keep-every 4,8 --keep-every 20 --methods auto,slerp")
        self.assertEqual([(row["method"], row["keep_every"]) for row in rows],
                         [(m, n) for n in (4, 8, 20) for m in ("auto", "slerp")])
        self.assertEqual(self.output_of("compare cubic.csv --keep-every 4,8 --methods auto").count("cubic.csv: every"), 2)

    def test_random_keys_depend_on_the_seed_alone(self):
        keys = {seed: self.compared(f"cubic.csv --keep-every 4 --random {seed} --methods slerp")[0]["rms_deg"]
                for seed in (1, 2, 3)}
        self.assertGreater(len(set(keys.values())), 1)
        self.assertEqual(self.compared("cubic.csv --keep-every 4 --random 3 --methods slerp")[0]["rms_deg"], keys[3])
        jittered, = self.compared("cubic.csv --keep-every 10 --jitter --methods slerp")
        even, = self.compared("cubic.csv --keep-every 10 --methods slerp")
        self.assertNotEqual(jittered["rms_deg"], even["rms_deg"])

    def test_keys_are_compared_with_a_reference_in_its_own_time(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n100.5,1,0,0,0\n101.5,0,0,0,1\n")
        self.write("truth.csv", "t,qw,qx,qy,qz\n100,1,0,0,0\n100.75,1,0,0,0\n101,1,0,0,0\n102,1,0,0,0\n")
        row, = self.compared("keys.csv --reference truth.csv --methods slerp")
        self.assertIsNone(row["keep_every"])
        self.assertEqual((row["keys"], row["samples"], row["max_at_s"]), (2, 2, 101))
        self.assertAlmostEqual(row["max_deg"], 90, delta=1e-12)
        self.assertAlmostEqual(row["rms_deg"], math.sqrt((45 ** 2 + 90 ** 2) / 2), delta=1e-12)
        self.assertNotIn("rate_rms_rad_s", row)

    def test_tensions_in_the_columns_of_the_keys_shape_the_curves(self):
        keys = "t,qw,qx,qy,qz,tension\n" + "".join(
            f"{i},{math.cos(0.1 * i * i)!r},{math.sin(0.1 * i * i)!r},0,0,{{}}\n" for i in range(4))
        self.write("loose.csv", keys.format(*["0.2"] * 4))
        self.write("plain.csv", keys.replace(",tension", "").replace(",{}", ""))
        loose, = self.compared("loose.csv --reference plain.csv --methods quintic")
        given, default = self.compared("plain.csv --reference plain.csv --methods quintic:tension=0.2,quintic --sort energy")
        if given["method"] == "quintic":
            given, default = default, given
        self.assertEqual(loose["energy"], given["energy"])
        self.assertNotEqual(loose["energy"], default["energy"])

    def test_conjugate_reads_world_to_body(self):
        conjugated = "\n".join(",".join("-" + c if i in (2, 3, 4) and c != "0" and line[0] != "t" else c
                                        for i, c in enumerate(line.split(","))) for line in self.read("cubic.csv").split("\n"))
        self.write("spice.csv", conjugated.replace("--", "").replace("wx,wy,wz", "a,b,c"))
        row, = self.compared("spice.csv --conjugate --keep-every 10 --methods slerp")
        plain, = self.compared("cubic.csv --keep-every 10 --methods slerp")
        self.assertEqual(row["rms_deg"], plain["rms_deg"])

    def test_one_failing_method_stands_in_the_table_with_its_line(self):
        three_keys = "cubic.csv --keep-every 20 --methods bezier,auto"
        good, bad = self.compared(three_keys)
        self.assertEqual((good["method"], good["error"], bad["method"]), ("auto", None, "bezier"))
        self.assertEqual((bad["rms_deg"], bad["seconds"], bad["continuity"]), (None, None, None))
        self.assertNotIn("\n", bad["error"])
        self.assertIn(bad["error"], self.output_of("compare " + three_keys))

    def test_all_methods_failing_is_an_error(self):
        done = self.run_command("compare cubic.csv --keep-every 20 --methods bezier --json")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertTrue(json.loads(done.stdout)[0]["error"])
        self.assertRegex(done.stderr, r"^orispline: none of the methods could be compared; bezier: [^\n]*\n$")

    def test_torques_of_an_inertia(self):
        row, = self.compared("cubic.csv --keep-every 10 --methods auto --inertia=1,2,3 --sort torque")
        self.assertAlmostEqual(row["torque_energy"], 9 * 6.0, delta=1e-8)
        self.assertAlmostEqual(row["peak_torque_n_m"], 3 * 3.0, delta=1e-8)
        self.assertLess(row["peak_torque_bound_n_m"], 1.001 * 9.0)
        squad, = self.compared("cubic.csv --keep-every 10 --methods squad")
        self.assertIsNone(squad["peak_rate_bound_rad_s"])

    def test_every_energy_is_told_beside_the_least_possible(self):
        self.write("plain.csv", motion_about_z(lambda t: t ** 3 / 4, lambda t: 0).replace(",wx,wy,wz", ",a,b,c"))
        slerp, auto, least = sorted(self.compared("plain.csv --keep-every 20 --methods slerp,auto,least"),
                                    key=lambda row: ["slerp", "auto", "least"].index(row["method"]))
        natural_spline = 3.375  # ∫|α|² of that through the angles 0, 0.25, 2 at 0, 1, 2 s
        self.assertAlmostEqual(least["energy"], natural_spline, delta=1e-8)
        self.assertAlmostEqual(least["times_least_energy"], 1, delta=1e-12)
        self.assertAlmostEqual(auto["times_least_energy"], auto["energy"] / natural_spline, delta=1e-8)
        self.assertIsNone(slerp["times_least_energy"])
        table = self.output_of("compare plain.csv --keep-every 20 --methods slerp,auto")
        self.assertIn("× least", table)
        row, = self.compared("plain.csv --keep-every 20 --methods auto --no-least-energy")
        self.assertIsNone(row["times_least_energy"])

    def test_sorting_puts_the_best_first_and_infinite_energies_last(self):
        energies = self.compared("cubic.csv --keep-every 10 --methods slerp,timed-c2,auto --sort energy")
        self.assertEqual(energies[-1]["method"], "slerp")
        continuity = self.compared("cubic.csv --keep-every 10 --methods slerp,timed-c1,timed-c3 --sort continuity")
        self.assertEqual([row["method"] for row in continuity][-1], "slerp")

    def test_every_energy_that_is_infinite_for_some_method_has_a_note(self):
        note = "{} is integrated inside segments only; for C0 methods the true value is infinite.\n"
        for method, inertia, noted in (("slerp", "--inertia=1,2,3", 2), ("slerp", "", 1), ("timed-c2", "--inertia=1,2,3", 0)):
            table = self.output_of(f"compare cubic.csv --keep-every 10 --methods auto,{method} {inertia}")
            for energy, some in (("∫|α|²", noted > 0), ("∫|torque|²", noted > 1)):
                self.assertEqual(note.format(energy) in table, some)

    def test_left_out_keys_estimate_the_error(self):
        row, = self.compared("cubic.csv --keep-every 20 --methods slerp --leave-out")
        self.assertAlmostEqual(row["leave_out_rms_deg"], math.degrees(1 - 0.25), delta=1e-9)  # half way to 2 rad

    def test_tuned_methods_stand_beside_untuned_ones(self):
        keys = "cubic.csv --keep-every 10 --methods slerp,timed-c2 --tune"
        energies = {row["method"]: row["energy"] for row in self.compared(keys)}
        self.assertEqual(sorted(energies), ["slerp", "timed-c2", "timed-c2:tuned"])
        self.assertLess(energies["timed-c2:tuned"], energies["timed-c2"])

    def test_csv_has_the_members_of_the_json(self):
        rows = list(csv.DictReader(io.StringIO(self.output_of("compare cubic.csv --keep-every 10 --methods auto,bezier --csv"))))
        members = self.compared("cubic.csv --keep-every 10 --methods auto,bezier")
        self.assertEqual(list(rows[0]), list(members[0]))
        self.assertEqual(float(rows[0]["rms_deg"]), members[0]["rms_deg"])

    def test_all_methods_are_the_default_on_every_8th_sample(self):
        rows = self.compared("cubic.csv")
        methods = json.loads(self.output_of("methods --json"))
        self.assertEqual(sorted(row["method"] for row in rows), sorted(method["name"] for method in methods))
        self.assertEqual({row["keep_every"] for row in rows}, {8})
        self.assertEqual(len(self.compared("cubic.csv --methods all,quintic:tension=0.3")), len(methods) + 1)

    def test_vectors_of_tensions_stand_beside_each_other(self):
        vectors = ["quintic:tension=0.3,0.7,0.2,0.9,0.4", "quintic:tension=0.3,0.7,0.2,0.9,0.5"]
        asked = "cubic.csv --keep-every 10 --methods slerp,quintic " + " ".join(f"--methods {text}" for text in vectors)
        rows = {row["method"]: row["energy"] for row in self.compared(asked)}
        self.assertEqual(sorted(rows), ["quintic", *vectors, "slerp"])
        self.assertEqual(len(set(rows.values())), 4)
        table = self.output_of("compare " + asked)
        for text in vectors:
            self.assertRegex(table, f"\n  {text}\n +C2 ")
        self.assertLessEqual(max(map(len, self.on_terminal(80, ["compare", *asked.split()]))), 80)

    def test_a_vector_has_a_number_for_each_kept_key(self):
        self.assert_fails("compare cubic.csv --keep-every 8 --methods auto --methods quintic:tension=0.3,0.7,0.2,0.9,0.4", BAD_USAGE,
                          "quintic: found 5 values of tension, wanted 1 or one per key (6); --keep-every 8 keeps 6 of the 41 samples")
        self.assert_fails("compare keys.csv --reference cubic.csv --methods quintic:tension=0.3,0.7", BAD_USAGE,
                          "quintic: found 2 values of tension, wanted 1 or one per key (3)")

    @with_pages
    def test_the_report_tells_vectors_of_tensions_apart_and_says_how_to_make_it_again(self):
        vectors = ["quintic:tension=0.3,0.7,0.2,0.9,0.4", "quintic:tension=0.5,0.7,0.2,0.9,0.4"]
        asked = f"cubic.csv --keep-every 10 --methods {vectors[0]} --methods {vectors[1]} --report out.html"
        self.output_of("compare " + asked)
        page = self.page("out.html")
        self.assertEqual(sorted(method["name"] for method in page["methods"]), vectors)
        self.assertEqual(page["command"], "orispline compare " + asked)

    @with_pages
    def test_the_report_is_one_page_with_the_curves(self):
        self.output_of("compare cubic.csv --keep-every 10,20 --methods auto,slerp --report out.html")
        page = self.page("out.html")
        self.assertEqual(page["command"], "orispline compare cubic.csv --keep-every 10,20 --methods auto,slerp --report out.html")
        self.assertEqual([method["name"] for method in page["methods"]], ["auto", "slerp"])
        self.assertEqual(len({"rms_deg", "rms_deg_1", "energy"} & {column["id"] for column in page["columns"]}), 3)
        self.assertEqual((page["methods"][0]["samples"]["torque"], page["limits"], page["marks"]), ([], {}, None))

    @with_pages
    def test_the_report_shows_auto_beside_what_was_named_and_names_files_without_folders(self):
        (self.folder / "far").mkdir()
        (self.folder / "far/cubic.csv").write_text(self.read("cubic.csv"), "utf-8")
        for methods, second in (("slerp,timed-c2,auto", "slerp"), ("all,tcb:tension=0.3", "tcb:tension=0.3")):
            self.output_of(f"compare {self.folder}/far/cubic.csv --keep-every 10 --methods {methods} --report out.html")
            page = self.page("out.html")
            self.assertEqual((page["first"], page["second"]), ("auto", second))
            self.assertEqual(page["title"], "cubic.csv: every 10th sample kept, 5 keys, 41 samples compared")
        self.output_of("compare cubic.csv --keep-every 10 --report out.html")
        self.assertIn(self.page("out.html")["second"], ("rotation-spline", "squad", "tcb"))

    def test_the_table_fits_a_terminal_of_80_columns(self):
        source = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
        arguments = ["compare", f"{source}/flight_keys.csv", "--reference", f"{source}/flight_truth.csv", "--methods",
                     "auto,squad:ends=phantom,hermite-cumulative,tcb:tension=0.25:bias=0.125"]
        lines = self.on_terminal(80, arguments)
        self.assertLessEqual(max(map(len, lines)), 80, "\n".join(lines))
        self.assertIn("RMS", lines[1])
        self.assertIn("[°]", lines[2])
        self.assertTrue(any("which --csv and --json have too:" in line for line in lines))
        wide = self.on_terminal(200, arguments)
        self.assertIn("RMS [°]  mean [°]  95 % [°]", wide[1])
        self.assertGreater(max(map(len, wide)), 80)

    def test_the_table_keeps_the_measure_that_sorts_it_and_wraps_failures(self):
        lines = self.on_terminal(80, ["compare", "cubic.csv", "--methods", "auto,bezier", "--sort", "seconds"])
        self.assertIn("time", lines[1])
        self.assertLessEqual(max(map(len, lines)), 80, "\n".join(lines))
        self.assertTrue(any(line.startswith("  bezier has no curve: cubic.csv: ") for line in lines), "\n".join(lines))

    def test_rounding_errors_are_0_in_the_table(self):
        text = self.output_of("compare keys.csv --reference keys.csv --methods slerp")
        self.assertRegex(text.splitlines()[2], r"^  slerp +C0 +0 +0 +0 +0 ")

    @with_pages
    def test_the_report_has_torques_where_the_inertia_is_known(self):
        self.output_of("compare cubic.csv --keep-every 10 --methods auto --inertia=1,2,3 --report out.html")
        method, = self.page("out.html")["methods"]
        torque, a = method["samples"]["torque"], method["samples"]["a"]
        for k in range(0, len(a), 3):  # about a principal axis
            self.assertAlmostEqual(torque[k + 2], 3 * a[k + 2], delta=9 * HALF_FLOAT)
        self.assertAlmostEqual(max(torque), 9, delta=9 * HALF_FLOAT)


class Refused(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("one.csv", "t,qw,qx,qy,qz\n5,1,0,0,0\n")
        self.write("late.csv", "t,qw,qx,qy,qz\n50,1,0,0,0\n51,1,0,0,0\n")

    def test_data_that_cannot_be_compared(self):
        self.assert_fails("compare one.csv", BAD_DATA, "one.csv: found 1 key, wanted 2 at least to compare curves")
        self.assert_fails("compare keys.csv --keep-every 3", BAD_DATA,
                          "keys.csv: --keep-every 3 leaves 1 of the 3 samples, wanted 2 keys at least")
        self.assert_fails("compare keys.csv --reference late.csv", BAD_DATA,
                          "late.csv: none of the 2 times, 50 to 51 s, lies between the keys of keys.csv, 0 to 3 s")
        self.assert_fails("compare keys.csv --reference one.csv", BAD_DATA,
                          "one.csv: found 1 key, wanted 2 at least to compare curves")

    def test_rows_out_of_order_are_sorted_where_asked_for(self):
        self.write("mixed.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n2,1,0,0,0\n1,1,0,0,0\n3,1,0,0,0\n")
        self.assert_fails("compare mixed.csv --keep-every 2", BAD_DATA,
                          "mixed.csv:4: key 2: time 1 comes after 2, wanted increasing times (--sort-rows orders the rows)")
        self.output_of("compare mixed.csv --keep-every 2 --sort-rows --methods slerp --sort max")

    def test_standard_input_is_read_once(self):
        self.output_of("compare - --keep-every 2 --methods slerp", input=self.read("keys.csv"))
        self.assert_fails("compare - --reference -", BAD_USAGE,
                          "found '-' for INPUT and --reference, wanted it for one at most", input=self.read("keys.csv"))

    def test_requests_that_make_no_sense(self):
        for arguments, message in (
                ("--keep-every 1", "--keep-every: found '1', wanted a whole number from 2 on"),
                ("--keep-every 4,x", "--keep-every: found 'x', wanted a whole number from 2 on"),
                ("--keep-every 4,4", "--keep-every: found 4 twice, wanted each number once"),
                ("--methods auto,auto", "--methods: found 'auto' twice, wanted each method once"),
                ("--methods auto:tension", "--methods: found 'tension', wanted NAME=VALUE"),
                ("--json --csv", "found --json and --csv, wanted one of them"),
                ("--report -", "--report: found '-', wanted the name of a file"),
                ("--random x", "--random: found 'x', wanted a whole number from 0 on"),
                ("--inertia=1,2", "--inertia: found '1,2', wanted three principal moments, or JXX,JYY,JZZ,JXY,JXZ,JYZ"),
                ("--inertia=1,2,-1", "--inertia: found the principal moments -1, 1, 2, wanted all of them greater than 0"),
                ("--sort torque", "--sort: found 'torque', wanted --inertia as well"),
                ("--sort peak-torque", "--sort: found 'peak-torque', wanted --inertia as well"),
                ("--keep-every 2 --sort rate", "--sort: found 'rate', wanted angular velocities as columns wx,wy,wz in keys.csv"),
                ("--keep-every 4 --reference keys.csv",
                 "found --reference and --keep-every, --jitter or --random, wanted a dense reference or samples of INPUT "
                 "for it")):
            with self.subTest(arguments):
                self.assert_fails(f"compare keys.csv {arguments}", BAD_USAGE, message)

    def test_unknown_names_are_answered_with_the_known_ones(self):
        for arguments, known in (("--methods nope", "slerp"), ("--sort nope", "rms, mean")):
            done = self.run_command(f"compare keys.csv {arguments}")
            self.assertEqual((done.returncode, done.stdout), (BAD_USAGE, ""))
            self.assertIn(known, done.stderr)
            self.assertIn("nope", done.stderr)

    @without_pages
    def test_a_build_without_pages_says_so_at_once(self):
        self.assert_fails("compare keys.csv --keep-every 2 --report out.html", BAD_USAGE,
                          "--report: orispline was built without pages, wanted a build with ORISPLINE_PAGE")

    @with_pages
    def test_a_report_that_cannot_be_written_costs_no_work(self):
        done = self.run_command("compare keys.csv --keep-every 2 --report nowhere/out.html")
        self.assertEqual((done.returncode, done.stdout), (BAD_ACCESS, ""))
        self.assertIn("nowhere/out.html", done.stderr)

    @with_pages
    def test_a_failed_run_leaves_the_old_report(self):
        self.write("out.html", "old")
        self.assert_fails("compare one.csv --report out.html", BAD_DATA,
                          "one.csv: found 1 key, wanted 2 at least to compare curves")
        self.assertEqual(self.read("out.html"), "old")


if __name__ == "__main__":
    main()
