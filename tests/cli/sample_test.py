#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `orispline sample` writes, and where."""
import json
import math
import resource
import shutil
import signal
import subprocess

from command import BAD_ACCESS, BAD_DATA, COMMAND, EXPECTED, KEYS, CommandTest, main, rows_of


class StoredOutputs(CommandTest):
    def setUp(self):
        super().setUp()
        shutil.copy(EXPECTED / "keys.csv", self.folder / "keys.csv")

    def test_all_rates_in_the_body_frame(self):
        text = self.output_of("sample keys.csv --method slerp --rate 2 --derivatives 3")
        self.assert_same_table(text, (EXPECTED / "slerp.csv").read_text("utf-8"))

    def test_angular_velocity_in_the_world_frame(self):
        text = self.output_of("sample keys.csv --method slerp --count 7 --derivatives 1 --frame world")
        self.assert_same_table(text, (EXPECTED / "slerp_world.csv").read_text("utf-8"))

    def test_tum_by_the_extension_of_the_output(self):
        self.assertEqual(self.output_of("sample keys.csv --method slerp --rate 2 -o motion.tum"), "")
        self.assert_same_table(self.read("motion.tum"), (EXPECTED / "slerp.tum").read_text("utf-8"), separator=" ")

    def test_tum_by_option(self):
        text = self.output_of("sample keys.csv --method slerp --rate 2 --output-format tum")
        self.assert_same_table(text, (EXPECTED / "slerp.tum").read_text("utf-8"), separator=" ")

    def test_a_tum_file_read_back_is_resampled_alike(self):
        text = self.output_of("sample - --input-format tum --method slerp --rate 2 --derivatives 3",
                              input=(EXPECTED / "slerp.tum").read_text("utf-8"))
        self.assert_same_table(text, (EXPECTED / "slerp.csv").read_text("utf-8"))


class Columns(CommandTest):
    def header_of(self, arguments):
        return self.output_of(f"sample keys.csv --count 2 {arguments}").splitlines()[0]

    def test_two_orders_are_the_default(self):
        self.assertEqual(self.header_of(""), "t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az")

    def test_no_rates(self):
        self.assertEqual(self.header_of("--derivatives 0"), "t,qw,qx,qy,qz")

    def test_world_rates_say_so(self):
        self.assertEqual(self.header_of("--derivatives 3 --frame world"),
                         "t,qw,qx,qy,qz,wx_world,wy_world,wz_world,ax_world,ay_world,az_world,"
                         "jx_world,jy_world,jz_world")

    def test_positions_bring_their_own_rates_after_the_angular_ones(self):
        self.write("keys.csv", "t,qw,qx,qy,qz,px,py,pz\n0,1,0,0,0,0,0,0\n2,1,0,0,0,4,-2,1\n")
        rates = ",wx,wy,wz", ",ax,ay,az", ",jx,jy,jz"
        for order, tail in enumerate(("", ",vx,vy,vz", ",vx,vy,vz,apx,apy,apz", ",vx,vy,vz,apx,apy,apz")):
            text = self.output_of(f"sample keys.csv --count 3 --derivatives {order}")
            self.assertEqual(text.splitlines()[0], "t,qw,qx,qy,qz,px,py,pz" + "".join(rates[:order]) + tail)
        # ends continue naturally: a straight line at constant speed
        for row in rows_of(self.output_of("sample keys.csv --count 5 --derivatives 2 --frame world")):
            for number, want in zip(row[14:], (2, -1, 0.5, 0, 0, 0), strict=True):
                self.assertAlmostEqual(number, want, delta=1e-14)

    def test_euroc_by_option(self):
        shutil.copy(EXPECTED / "keys.csv", self.folder / "keys.csv")
        text = self.output_of("sample keys.csv --method slerp --rate 2 --output-format euroc")
        self.assert_same_table(text, (EXPECTED / "slerp_euroc.csv").read_text("utf-8"))
        again = self.output_of("sample - --method slerp --rate 2 --output-format euroc", input=text)
        self.assert_same_table(again, text)

    def test_a_curve_that_begins_after_the_first_key_is_sampled_where_it_is(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(0.2 * t)},0,{math.sin(0.2 * t)},0\n" for t in (10, 11, 12.5, 13, 15)))
        done = self.run_command("sample keys.csv --method beta --count 3 --derivatives 0 -o out.csv")
        self.assertEqual([line.split(",")[0] for line in self.read("out.csv").splitlines()[1:]], ["11", "12", "13"])
        self.assertNotIn("hold", done.stderr)

    def test_tum_without_positions_has_zeros(self):
        cells = self.output_of("sample keys.csv --count 1 --output-format tum").split()
        self.assertEqual(cells[:4], ["0", "0", "0", "0"])
        for cell, wanted in zip(cells[4:], [0, 0, 0, 1], strict=True):
            self.assertAlmostEqual(float(cell), wanted, delta=1e-15)


class Times(CommandTest):
    def times_of(self, arguments):
        lines = self.output_of(f"sample keys.csv --derivatives 0 {arguments}").splitlines()
        return [line.split(",")[0] for line in lines[1:]]

    def test_rate_goes_up_to_the_end(self):
        self.assertEqual(self.times_of("--rate 0.4"), ["0", "2.5"])

    def test_rate_includes_an_end_that_rounding_hides(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0.1,1,0,0,0\n0.4,1,0,0,0\n")
        self.assertEqual(self.times_of("--rate 10"), ["0.1", "0.2", "0.3", "0.4"])

    def test_count_includes_both_ends(self):
        self.assertEqual(self.times_of("--count 4"), ["0", "1", "2", "3"])

    def test_count_of_one_is_the_start(self):
        self.assertEqual(self.times_of("--count 1 --from 2"), ["2"])

    def test_a_times_file_may_have_any_order_and_a_header(self):
        self.write("times.csv", "t\n2.5\n0.25\n3\n")
        self.assertEqual(self.times_of("--times times.csv"), ["2.5", "0.25", "3"])

    def test_from_and_to_are_in_the_time_of_the_file(self):
        self.write("keys.csv", KEYS.replace("\n0,", "\n1311868163.8697,").replace("\n1,0", "\n1311868164.8697,0")
                   .replace("\n3,", "\n1311868166.8697,"))
        self.assertEqual(self.times_of("--rate 10 --from 1311868163.9 --to 1311868164.1"),
                         ["1311868163.9", "1311868164", "1311868164.1"])

    def test_one_key_has_one_time(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n5,1,0,0,0\n")
        self.assertEqual(self.times_of("--rate 100"), ["5"])

    def test_outside_the_keys_the_end_is_held_at_rest(self):
        rows = rows_of(self.output_of("sample keys.csv --rate 1 --from -1 --to 4 --derivatives 1"))
        self.assertEqual([row[0] for row in rows], [-1, 0, 1, 2, 3, 4])
        for found, key in zip(rows[0][1:5], [1, 0, 0, 0], strict=True):
            self.assertAlmostEqual(found, key, delta=1e-15)
        self.assertEqual(rows[0][5:], [0, 0, 0])
        self.assertEqual(rows[5][1:5], rows[4][1:5])
        self.assertEqual(rows[5][5:], [0, 0, 0])

    def test_times_within_the_keys_pass_with_extrapolate_error(self):
        self.assertEqual(len(self.times_of("--rate 1 --extrapolate error")), 4)


class Shape(CommandTest):
    def rates_of(self, arguments):
        method = "" if "--method" in arguments else "--method timed-c2"
        text = self.output_of(f"sample keys.csv --count 4 --derivatives 1 {method} {arguments}")
        return [row[7] for row in rows_of(text)]

    def test_auto_is_the_default_method(self):
        plain = self.output_of("sample keys.csv --rate 10")
        self.assertEqual(plain, self.output_of("sample keys.csv --rate 10 --method auto"))
        self.assertNotEqual(plain, self.output_of("sample keys.csv --rate 10 --method timed-c2"))

    def test_a_steady_turn_stays_steady_between_uneven_keys(self):
        rows = ["t,qw,qx,qy,qz"] + [f"{t},{math.cos(t / 4)},{math.sin(t / 4)},0,0" for t in (0, 1, 4, 4.5, 6)]
        self.write("steady.csv", "\n".join(rows))
        for row in rows_of(self.output_of("sample steady.csv --rate 10")):
            self.assertAlmostEqual(row[5], 0.5, delta=1e-13)
            self.assertLess(max(map(abs, row[6:])), 1e-12)

    def test_tension_scales_the_rate_at_a_key(self):
        plain, tense = self.rates_of(""), self.rates_of("--tension=-0.1")
        self.assertAlmostEqual(tense[1], -0.2 * plain[1], delta=1e-13)

    def test_tension_may_stand_after_a_blank_and_per_key(self):
        self.assertEqual(self.rates_of("--tension -0.1,-0.1,-0.1"), self.rates_of("--set tension=-0.1"))

    def test_set_may_stand_several_times(self):
        self.assertEqual(self.rates_of("--set tension=0.5 --set tension2=1,1,1"), self.rates_of(""))

    def test_a_rate_means_a_clamped_end(self):
        rates = self.rates_of("--start-rate=0,0,-0.5 --end-rate=0,0,0.25")
        self.assertAlmostEqual(rates[0], -0.5, delta=1e-13)
        self.assertAlmostEqual(rates[3], 0.25, delta=1e-13)

    def test_a_rate_in_the_text_of_a_method_may_be_none(self):
        self.assertEqual(self.rates_of("--method timed-c2:ends=clamped:start_rate=0,0,0:end_rate=0,0,1"),
                         self.rates_of("--start-rate=0,0,0 --end-rate=0,0,1"))

    def test_each_end_may_have_its_rule(self):
        rates = self.rates_of("--ends rest,clamped --end-rate=0,0,1")
        self.assertAlmostEqual(rates[0], 0, delta=1e-13)
        self.assertAlmostEqual(rates[3], 1, delta=1e-13)

    def test_every_order_of_rates_is_the_derivative_of_the_one_below(self):
        self.write("keys.csv", KEYS)
        h = 1e-4
        self.write("times.txt", f"{0.7 - h}\n0.7\n{0.7 + h}\n")
        before, here, after = rows_of(self.output_of("sample keys.csv --times times.txt --method timed-c3 --derivatives 3"))
        for order in (1, 2):  # columns t,q,w,a,j
            for axis in range(3):
                below, at = 5 + 3 * (order - 1) + axis, 5 + 3 * order + axis
                self.assertAlmostEqual((after[below] - before[below]) / (2 * h), here[at], delta=1e-5 * max(1, abs(here[at])))
        self.assertGreater(max(map(abs, here[11:14])), 1e-3)
        for order in (0, 1, 2):
            fewer = rows_of(self.output_of(f"sample keys.csv --times times.txt --method timed-c3 --derivatives {order}"))[1]
            self.assertEqual(len(fewer), 5 + 3 * order)
            self.assertLess(max(abs(found - wanted) for found, wanted in zip(fewer, here)), 1e-12)

    def test_a_column_of_the_file_sets_a_parameter(self):
        lines = KEYS.splitlines()
        self.write("keys.csv", "\n".join([lines[0] + ",tension"] + [line + ",-0.1" for line in lines[1:]]))
        with_column = self.rates_of("")
        self.assertEqual(self.rates_of("--tension 0.3"), self.rates_of("--set tension=0.3,0.3,0.3"))
        self.write("keys.csv", KEYS)
        self.assertEqual(with_column, self.rates_of("--tension=-0.1"))

    def test_every_method_passes_through_the_keys_without_a_change_of_sign(self):
        self.write("keys.csv", KEYS.replace(f"{math.cos(math.pi / 8)},0,0,", f"{-math.cos(math.pi / 8)},0,0,-"))
        methods = [method for method in json.loads(self.output_of("methods --json"))
                   if method["interpolates"] and method["min_keys"] <= 3]
        self.assertGreaterEqual(len(methods), 31)
        for method in methods:
            with self.subTest(method["name"]):
                rows = rows_of(self.output_of(f"sample keys.csv --method {method['name']} --rate 20"))
                self.assertAlmostEqual(rows[20][1], math.cos(math.pi / 8), delta=1e-12)
                self.assertAlmostEqual(rows[20][4], math.sin(math.pi / 8), delta=1e-12)
                for a, b in zip(rows, rows[1:]):
                    self.assertGreater(sum(x * y for x, y in zip(a[1:5], b[1:5])), 0.9)

    def test_signs_as_given_go_the_long_way(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,0,0,-1\n2,-1,0,0,0\n3,0,0,0,1\n")
        self.assertAlmostEqual(self.rates_of("--method slerp --signs as-given")[0], -math.pi, delta=1e-12)


class Destinations(CommandTest):
    def test_only_data_goes_to_standard_output(self):
        done = self.run_command("sample keys.csv --count 2 --derivatives 0")
        self.assertEqual(done.stdout.count("\n"), 3)
        self.assertEqual(done.stderr,
                         "3 keys from keys.csv, 0 to 3 s\n2 samples with auto written to standard output\n")

    def test_quiet_says_nothing(self):
        self.assertEqual(self.run_command("sample keys.csv --count 2 --quiet -o out.csv").stderr, "")

    def test_a_file_takes_the_samples(self):
        self.assertEqual(self.output_of("sample keys.csv --count 2 -o out.csv"), "")
        self.assertEqual(self.read("out.csv"), self.output_of("sample keys.csv --count 2"))

    def test_standard_input_is_read(self):
        self.assertEqual(self.output_of("sample - --count 2", input=KEYS), self.output_of("sample keys.csv --count 2"))

    def test_json_is_one_document_with_the_summary(self):
        report = json.loads(self.output_of("sample keys.csv --rate 1 --to 5 --truth keys.csv --json -o out.csv"))
        self.assertEqual((report["keys"], report["samples"], report["held_samples"]), (3, 6, 2))
        self.assertEqual((report["start_s"], report["end_s"]), ("0", "3"))
        self.assertEqual(report["truth"]["compared"], 3)
        self.assertLess(report["truth"]["distance_max_deg"], 1e-12)

    def test_truth_is_compared_at_its_own_times(self):
        self.write("truth.csv", "t,qw,qx,qy,qz\n-1,1,0,0,0\n"
                   f"0,{math.cos(0.01)},0,0,{math.sin(0.01)}\n{KEYS.split()[-1]}\n")
        done = self.run_command("sample keys.csv --count 2 --truth truth.csv -o out.csv")
        self.assertIn("distance to truth.csv: RMS 0.8103°, mean 0.573°, largest 1.146° at 0 s; "
                      "2 orientations compared\n", done.stderr)

    def test_repairs_are_counted(self):
        self.write("keys.csv", KEYS + "3,1,0,0,0\n2,1,0,0,0\n4,nan,0,0,0\n")
        done = self.run_command("sample keys.csv --count 2 --sort --drop-duplicates --drop-invalid")
        self.assertEqual(done.returncode, 0)
        self.assertIn("dropped 1 row of duplicate time; dropped 1 row without valid numbers; sorted 1 row\n",
                      done.stderr)


class Failures(CommandTest):
    def assert_untouched(self, arguments, code, **options):
        self.write("out.csv", "precious")
        done = self.run_command(arguments, **options)
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        self.assertEqual(self.read("out.csv"), "precious")
        self.assertEqual([path.name for path in self.folder.iterdir() if "part" in path.name], [])

    def test_bad_keys_leave_the_output_untouched(self):
        self.write("keys.csv", KEYS + "3,1,0,0,0\n")
        self.assert_untouched("sample keys.csv --rate 10 -o out.csv", BAD_DATA)

    def test_stray_times_leave_the_output_untouched(self):
        self.write("times.csv", "1\n7\n")
        self.assert_untouched("sample keys.csv --times times.csv --extrapolate error -o out.csv", BAD_DATA)

    def test_a_bad_truth_leaves_the_output_untouched(self):
        self.assert_untouched("sample keys.csv --rate 10 --truth none.csv -o out.csv", BAD_ACCESS)

    def test_a_full_disk_leaves_the_output_untouched(self):
        def small_files():
            signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
            resource.setrlimit(resource.RLIMIT_FSIZE, (65536, 65536))

        self.assert_untouched("sample keys.csv --rate 10000 -o out.csv", BAD_ACCESS, preexec_fn=small_files,
                              restore_signals=False)

    def test_a_reader_that_stops_early_causes_no_complaint(self):
        with subprocess.Popen([COMMAND, "sample", "keys.csv", "--rate", "100000"], cwd=self.folder,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE) as process:
            process.stdout.readline()
            process.stdout.close()
            self.assertEqual(process.stderr.read(), b"")


if __name__ == "__main__":
    main()
