#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `orispline inspect` finds, against figures that follow from the keys by hand."""
import json
import math
import re
import shutil

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, EXPECTED, KEYS, SUCCESS, CommandTest, main, with_pages

TIMED = ("timed-c1", "timed-c2", "timed-c3", "timed-sextic")


def turning_keys(spacings):
    """Keys that nutate: a turn about z on top of a growing tilt about x."""
    lines, t = ["t,qw,qx,qy,qz"], 0.0
    for i, spacing in enumerate([0.0, *spacings]):
        t += spacing
        c, s, k, r = math.cos(0.2 * i), math.sin(0.2 * i), math.cos(0.1 * i * i), math.sin(0.1 * i * i)
        lines.append(f"{t!r},{c * k!r},{s * k!r},{-s * r!r},{c * r!r}")
    return "\n".join(lines) + "\n"


class Report(CommandTest):
    def report_of(self, arguments, **options):
        return json.loads(self.output_of(f"inspect {arguments} --json", **options))

    def test_the_page_for_people_is_the_stored_one(self):
        shutil.copy(EXPECTED / "keys.csv", self.folder / "keys.csv")
        page = self.output_of("inspect keys.csv --method slerp")
        page = re.sub("largest error [0-9.e-]+", "largest error ROUNDING", page)
        self.assertEqual(page, (EXPECTED / "inspect.txt").read_text("utf-8"))

    def test_span_spacing_and_steps(self):
        report = self.report_of("keys.csv")
        self.assertEqual((report["file"], report["format"], report["keys"]), ("keys.csv", "csv", 3))
        self.assertEqual((report["start_s"], report["end_s"], report["span_s"]), ("0", "3", 3))
        self.assertEqual([report[f"spacing_{name}_s"] for name in ("min", "median", "max")], [1, 1.5, 2])
        self.assertEqual([report[f"spacing_max_after_{name}"] for name in ("key", "line", "time_s")], [1, 3, "1"])
        self.assertAlmostEqual(report["step_median_deg"], 45, delta=1e-12)
        self.assertAlmostEqual(report["step_max_deg"], 45, delta=1e-12)
        self.assertIsNone(report["defect"])
        self.assertEqual(report["methods"], [])

    def test_times_keep_every_digit(self):
        shutil.copy(EXPECTED / "keys.csv", self.folder / "keys.csv")
        report = self.report_of("keys.csv")
        self.assertEqual((report["start_s"], report["end_s"], report["span_s"]),
                         ("1311868163.8697", "1311868166.8697", 3))

    def test_one_key_has_no_spacing(self):
        report = self.report_of("-", input="t,qw,qx,qy,qz\n5,1,0,0,0\n")
        self.assertEqual((report["keys"], report["span_s"]), (1, 0))
        self.assertNotIn("spacing_min_s", report)

    def test_faults_are_counted_instead_of_refused(self):
        self.write("bad.csv",
                   "t,qw,qx,qy,qz\n0,1,0,0,0\n2,-1,0,0,0\n1,0.9999,0,0,0\n1,1,0,0,0\n3,nan,0,0,0\n4,3,0,0,0\n")
        report = self.report_of("bad.csv --method timed-c2")
        self.assertEqual(report["keys"], 4)
        self.assertEqual((report["duplicate_times"], report["invalid_rows"]), (1, 1))
        self.assertGreater(report["out_of_order_rows"], 0)
        self.assertEqual(report["sign_flips"], 2)  # there and back
        self.assertEqual((report["non_unit_keys"], report["wrong_norm_keys"], report["norm_error_max"]), (2, 1, 2))
        self.assertEqual(report["defect"], self.run_command("sample bad.csv --rate 1").stderr[len("orispline: "):-1])
        self.assertEqual(len(report["methods"]), 1)

    def test_a_wrong_norm_alone_is_a_defect_too(self):
        report = self.report_of("-", input="t,qw,qx,qy,qz\n0,1,0,0,0\n1,2,0,0,0\n")
        self.assertEqual(report["defect"], "-:3: key 1: the quaternion has norm 2, wanted 1 within 0.02 "
                                           "(--normalise takes any norm but 0)")

    def test_steps_near_a_half_turn_are_named(self):
        report = self.report_of("-", input="t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,0,1,0,0\n")
        self.assertEqual((report["near_180_steps"], report["near_180_after_keys"]), (1, [1]))


@with_pages
class Pages(CommandTest):
    def shown(self, arguments, **options):
        """What the page of a file of keys has; standard output is as without it."""
        self.assertEqual(self.output_of(f"inspect {arguments} --report page.html", **options),
                         self.output_of(f"inspect {arguments}", **options))
        return self.page("page.html")

    def test_the_curve_of_the_usual_method_is_shown(self):
        page = self.shown("keys.csv")
        self.assertEqual((page["title"], page["command"], page["notes"]),
                         ("keys.csv: auto, 3 keys", "orispline inspect keys.csv --report page.html", []))
        self.assertEqual(page["keys"]["t"], [0, 1, 3])
        self.write("for.csv", "# orispline: method=timed-c3\n" + KEYS)
        self.assertEqual([method["name"] for method in self.shown("for.csv")["methods"]], ["timed-c3"])

    def test_the_methods_that_are_named_are_shown(self):
        page = self.shown("keys.csv --method slerp,auto --method quintic:tension=0.5 --json")
        self.assertEqual([method["name"] for method in page["methods"]], ["slerp", "auto", "quintic"])
        self.assertEqual(page["title"], "keys.csv: 3 methods, 3 keys")
        self.assertAlmostEqual(page["methods"][0]["measures"]["peak_rate_rad_s"], math.pi / 4, delta=1e-6)

    def test_faults_are_told_on_the_page_too(self):
        page = self.shown("-", input="t,qw,qx,qy,qz\n0,1,0,0,0\n1,2,0,0,0\n")
        self.assertEqual(page["notes"], ["Warning: the keys were mended for this page; other commands say: -:3: key 1: the "
                                         "quaternion has norm 2, wanted 1 within 0.02 (--normalise takes any norm but 0)."])
        self.write("no.csv", "# orispline: method=no-such\n" + KEYS)
        method, = self.shown("no.csv")["methods"]
        self.assertIn("no-such", method["failure"])

    def test_one_key_is_shown(self):
        page = self.shown("-", input="t,qw,qx,qy,qz\n5,1,0,0,0\n")
        self.assertEqual((len(page["keys"]["t"]), page["methods"][0]["failure"]), (1, ""))

    def test_the_page_is_another_file_and_an_older_one_stays_where_something_fails(self):
        self.assert_fails("inspect keys.csv --report ./keys.csv", BAD_USAGE,
                          "--report: found './keys.csv', wanted another file than INPUT")
        self.assert_fails("inspect keys.csv --report -", BAD_USAGE, "--report: found '-', wanted the name of a file")
        done = self.run_command("inspect keys.csv --report nowhere/page.html")
        self.assertEqual((done.returncode, done.stdout), (BAD_ACCESS, ""))
        self.write("old.html", "old")
        self.write("bad.csv", "t,qw,qx,qy,qz\n0,0,0,0,0\n")
        for arguments, code in (("bad.csv", BAD_DATA), ("keys.csv --method no-such", BAD_USAGE), ("nowhere.csv", BAD_ACCESS)):
            done = self.run_command(f"inspect {arguments} --report old.html")
            self.assertEqual((done.returncode, self.read("old.html")), (code, "old"), arguments)
        self.assertEqual([path.name for path in self.folder.iterdir() if "part" in path.name], [])


class Continuity(CommandTest):
    def methods_of(self, arguments, keys):
        done = self.run_command(f"inspect - --json {arguments}", input=keys)
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        return json.loads(done.stdout)["methods"]

    def test_slerp_jumps_by_the_difference_of_its_rates(self):
        jump, = self.methods_of("--method slerp", KEYS)
        self.assertAlmostEqual(jump["angular_velocity_jump_max_rad_s"], math.pi / 8, delta=1e-14)
        self.assertAlmostEqual(jump["angular_velocity_max_rad_s"], math.pi / 4, delta=1e-14)
        self.assertAlmostEqual(jump["angular_velocity_jump_max_relative"], 0.5, delta=1e-14)
        self.assertEqual((jump["angular_velocity_jump_max_key"], jump["continuity_order"]), (1, 0))

    def test_methods_come_as_lists_and_repeatedly(self):
        methods = self.methods_of("--method slerp,quintic --method timed-c2", KEYS)
        self.assertEqual([method["method"] for method in methods], ["slerp", "quintic", "timed-c2"])

    def test_a_text_with_commas_is_one_method_where_it_can_be(self):
        first, second = "quintic:tension=0.3,0.7,0.2", "quintic:tension=0.5,0.7,0.2"
        methods = self.methods_of(f"--method {first} --method slerp,auto --method {second}", KEYS)
        self.assertEqual([method["method"] for method in methods], [first, "slerp", "auto", second])
        one, = self.methods_of("--method timed-c2:ends=natural,rest", KEYS)
        self.assertEqual(one["method"], "timed-c2")
        text = self.output_of(f"inspect - --method {first} --method {second}", input=KEYS)
        for label in (first, second):
            self.assertRegex(text, f"\n{label}\n +C0 ")
            self.assertRegex(text, f"\n{label}\n +G3 ")

    def test_timed_methods_do_not_jump_at_spacing_ratios_of_ten(self):
        keys = turning_keys([1, 0.1, 1, 1, 0.1, 0.1, 1, 0.1])
        for method in self.methods_of("--method " + ",".join(TIMED), keys):
            with self.subTest(method["method"]):
                jump = method["angular_velocity_jump_max_rad_s"] / method["angular_velocity_max_rad_s"]
                self.assertLess(jump, 1e-12)
                self.assertLess(method["angular_velocity_jump_max_relative"], 1e-9)
                self.assertEqual(method["continuity_order"], {"timed-c1": 1, "timed-c2": 2}.get(method["method"], 3))

    def test_quintic_and_sextic_jump_at_uneven_keys(self):
        # At the middle key both have half the sum of the increments over the spacing on either side.
        middle = math.pi / 4
        for method in self.methods_of("--method quintic,sextic", KEYS):
            with self.subTest(method["method"]):
                self.assertAlmostEqual(method["angular_velocity_jump_max_rad_s"], middle - middle / 2, delta=1e-13)

    def test_quintic_is_g2_and_sextic_g3_where_their_speed_jumps(self):
        keys = turning_keys([1, 0.1, 1, 1, 0.1, 0.1, 1, 0.1])
        methods = self.methods_of("--method slerp,squad,quintic,sextic", keys)
        self.assertEqual([method["continuity_order"] for method in methods], [0, 0, 0, 0])
        self.assertEqual([method["shape_order"] for method in methods], [0, 1, 2, 3])
        self.assertLess(methods[2]["curvature_jump_max_per_rad"], 1e-9)
        self.assertGreater(methods[1]["curvature_jump_max_relative"], 1e-3)
        text = self.output_of("inspect - --method quintic", input=keys)
        self.assertRegex(text, r"\nquintic +C0 .*\n(.*\n)*quintic +G2 ")

    def test_the_shape_is_undefined_where_the_body_stands_still(self):
        keys = turning_keys([1] * 6).splitlines()
        keys.insert(4, "2.5," + keys[3].split(",", 1)[1])  # the third key once more
        given = "\n".join(keys) + "\n"
        method, = self.methods_of("--method auto --set hold=1", given)
        self.assertEqual((method["shape_order"], method["shape_order_in_motion"], method["rests_at_keys"]), (None, 2, 2))
        self.assertIn("\nauto stands still beside key 2 (line 4, 2 s) and 1 more: its shape is undefined there; at the other keys it is G2\n",
                      self.output_of("inspect - --method auto --set hold=1", input=given))

    def test_a_curve_that_winds_beside_a_rest_jumps_nowhere(self):
        keys = "t,qw,qx,qy,qz\n0,1,0,0,0\n60,1,0,0,0\n61,0.8,0,0,0.6\n"
        for method in self.methods_of("--method log-parabola,circular,barry-goldman,squad-timed", keys):
            with self.subTest(method["method"]):
                self.assertEqual(method["orientation_jump_max_deg"], 0)
                self.assertNotIn("orientation_jump_max_after_key", method)
                self.assertEqual(method["continuity_order"], {"squad-timed": 0}.get(method["method"], 2))  # its handle winds
                samples = self.output_of(f"sample - -o - --rate 100 --method {method['method']}", input=keys)
                rows = [[float(cell) for cell in row.split(",")[1:5]] for row in samples.splitlines()[1:]]
                farthest = max(math.dist(before, after) for before, after in zip(rows, rows[1:]))
                self.assertLess(farthest, 0.01)  # of the quaternion, at up to 1.3 rad/s

    def test_quintic_and_sextic_are_smooth_at_even_keys(self):
        keys = turning_keys([0.5] * 8)
        self.assertEqual([m["continuity_order"] for m in self.methods_of("--method quintic,sextic", keys)], [2, 3])


if __name__ == "__main__":
    main()
