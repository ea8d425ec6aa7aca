#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files of keys that say which curve they are for."""
import json
import math
import pathlib

from command import BAD_DATA, CommandTest, main, table_of

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
FLIGHT, TRUTH = DATA / "flight_keys.csv", DATA / "flight_truth.csv"
QUIET = "--quiet --rate 20"


class Recipes(CommandTest):
    def recipe_in(self, name):
        return self.read(name).splitlines()[0]

    def made(self, task):
        """Keys of a task, which say nothing on standard error."""
        done = self.run_command(f"{task} -o made.csv --quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        return self.recipe_in("made.csv")

    def assert_sampled_as(self, method):
        self.assertEqual(self.output_of(f"sample made.csv {QUIET}"),
                         self.output_of(f"sample made.csv --ignore-recipe --method {method} {QUIET}"))
        self.assertNotEqual(self.output_of(f"sample made.csv {QUIET}"),
                            self.output_of(f"sample made.csv --ignore-recipe {QUIET}"))

    def test_tuned_keys_are_sampled_with_their_method_and_tensions(self):
        recipe = self.made(f"tune {FLIGHT} --method timed-c2 --ends rest,natural")
        self.assertEqual(recipe, "# orispline: method=timed-c2:ends=rest,natural")
        self.assert_sampled_as("timed-c2 --ends rest,natural")

    def test_retimed_keys_are_sampled_with_their_method_and_its_settings(self):
        recipe = self.made(f"retime {FLIGHT} --method timed-c3 --tension=0.4 --max-rate 20deg/s")
        self.assertEqual(recipe, "# orispline: method=timed-c3:tension=0.4")
        self.assert_sampled_as("timed-c3 --tension=0.4")

    def test_smoothed_keys_are_sampled_with_their_rates(self):
        self.assertEqual(self.made(f"smooth {FLIGHT} --smoothing-time 1"), "# orispline: method=hermite-c2")
        self.assert_sampled_as("hermite-c2")

    def test_reduced_keys_keep_their_tolerance_by_the_file_alone(self):
        for method in ("slerp", "timed-c2"):
            for name in ("keys.csv", "keys.tum"):
                self.output_of(f"reduce {TRUTH} --tolerance 1deg --position-tolerance 100m --method {method} -o {name} --quiet")
                self.assertEqual(self.recipe_in(name), f"# orispline: method={method}")
                told = json.loads(self.output_of(f"sample {name} --truth {TRUTH} --count 9 -o motion.csv --json"))
                self.assertEqual((told["method"], told["method_text"]), (method, method))
                self.assertLessEqual(told["truth"]["distance_max_deg"], 1)

    def test_a_loop_stays_one(self):
        circle = [(math.cos(a / 2), math.sin(a / 2)) for a in (0, 1, 2.5, 2, 0)]
        self.write("made.csv", "# orispline: method=quintic:closed\nt,qw,qx,qy,qz\n" +
                   "".join(f"{t},{c},0,{s},0\n" for t, (c, s) in enumerate(circle)))
        self.assert_sampled_as("quintic --closed")

    def test_signs_that_mean_turns_stay_as_given(self):
        self.write("turns.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,-0.6,0,0.8,0\n2,1,0,0,0\n4,-0.8,0,0.6,0\n")
        self.assertEqual(self.made("tune turns.csv --method timed-c2 --signs as-given"),
                         "# orispline: method=timed-c2 signs=as-given")
        self.assertEqual(self.output_of(f"sample made.csv {QUIET}"),
                         self.output_of(f"sample made.csv --signs as-given {QUIET}"))
        self.assertNotEqual(self.output_of(f"sample made.csv {QUIET}"),
                            self.output_of(f"sample made.csv --signs shortest {QUIET}"))

    def test_options_win_one_by_one(self):
        self.made(f"tune {FLIGHT} --method timed-c2 --ends rest")
        shaped = self.output_of(f"sample made.csv --ends natural {QUIET}")
        self.assertEqual(shaped, self.output_of(f"sample made.csv --ignore-recipe --method timed-c2 --ends natural {QUIET}"))
        even = self.output_of(f"sample made.csv --tension=1 {QUIET}")
        self.assertEqual(even, self.output_of(
            f"sample made.csv --ignore-recipe --method timed-c2 --ends rest --tension=1 {QUIET}"))

    def test_another_method_is_told(self):
        self.made(f"tune {FLIGHT} --method timed-c2")
        done = self.run_command(f"sample made.csv --method squad {QUIET} -o motion.csv")
        self.assertEqual((done.returncode, done.stderr), (0, "orispline: warning: made.csv:1: the file says that its "
                                                             "keys are for timed-c2, and they are used for squad\n"))
        self.assertEqual(self.run_command(f"sample made.csv --method timed-c2 {QUIET} -o motion.csv").stderr, "")

    def test_every_command_on_keys_takes_the_method_of_the_file(self):
        self.made(f"tune {FLIGHT} --method quintic --ends natural")
        self.assertIn(">quintic<", self.output_of("plot made.csv"))
        self.assertEqual(json.loads(self.output_of("retime made.csv --max-rate 9deg/s -o r.csv --json"))["method"], "quintic")
        self.assertEqual(self.recipe_in("r.csv"), "# orispline: method=quintic:ends=natural")
        self.assertEqual(json.loads(self.output_of("tune made.csv -o t.csv --json"))["method"], "quintic")
        self.assertEqual(json.loads(self.output_of("inspect made.csv --json"))["for_method"], "quintic:ends=natural")
        self.assertIn("keys for      quintic:ends=natural, as line 1 says\n", self.output_of("inspect made.csv"))
        self.assertIsNone(json.loads(self.output_of("inspect made.csv --ignore-recipe --json"))["for_method"])

    def test_methods_that_do_not_fit_a_task_are_set_aside_with_a_word(self):
        self.output_of(f"reduce {TRUTH} --tolerance 1deg --position-tolerance 100m --method auto -o keys.csv --quiet")
        done = self.run_command("tune keys.csv -o tuned.csv --quiet")
        self.assertEqual((done.returncode, done.stderr), (
            0, "orispline: warning: keys.csv:1: the file says that its keys are for auto, and they are used for timed-c2\n"))
        self.made(f"smooth {FLIGHT} --smoothing-time 1")
        done = self.run_command("retime made.csv --max-rate 5deg/s -o slow.csv --quiet")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("made.csv:1: the file says that its keys are for hermite-c2, and they are used for auto\n", done.stderr)
        self.assertEqual(self.recipe_in("slow.csv"), "# orispline: method=auto")

    def test_the_same_method_in_other_words_is_the_same(self):
        self.write("keys.csv", "# orispline: method=timed-c2:ends=natural:tension=0.30\n" + self.read("keys.csv"))
        done = self.run_command(f"sample keys.csv --method timed-c2 --tension=.3 --ends natural {QUIET} -o motion.csv")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_what_only_the_keys_refuse_is_the_fault_of_the_line(self):
        keys = self.read("keys.csv")
        for method in ("timed-c2:tension=1,2", "timed-c2:period=1e-9"):
            self.write("bad.csv", f"# orispline: method={method}\n{keys}")
            for spacing in ("--count 3", "--rate 2"):
                done = self.run_command(f"sample bad.csv {spacing}")
                self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""), done.stderr)
                self.assertTrue(done.stderr.startswith("orispline: bad.csv:1: "), done.stderr)
                self.assertTrue(done.stderr.endswith(" (--ignore-recipe reads the keys without it)\n"), done.stderr)

    def test_signs_are_not_promised_by_forms_that_have_none(self):
        self.write("turns.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,-0.6,0,0.8,0\n2,1,0,0,0\n4,-0.8,0,0.6,0\n")
        self.made("tune turns.csv --method timed-c2 --signs as-given")
        for form, stated in (("matrix", False), ("euler", False), ("rotvec", True), ("quaternion", True)):
            done = self.run_command(f"convert made.csv --output-orientation {form} -o form.csv --quiet")
            self.assertEqual(done.returncode, 0)
            self.assertEqual(self.recipe_in("form.csv").startswith("# orispline: "), stated, form)
            self.assertEqual("has no signs in this form of orientations" in done.stderr, not stated, done.stderr)

    def test_rates_in_the_world_stay_with_keys_whose_curve_takes_them(self):
        self.write("world.csv", "# orispline: method=hermite-c1\nt,qw,qx,qy,qz,wx_world,wy_world,wz_world\n"
                                "0,1,0,0,0,0.1,0.2,0.3\n1,0.8,0.6,0,0,0.3,0.1,-0.2\n2,0.6,0.8,0,0,0,0.1,0\n")
        self.output_of("convert world.csv -o body.csv --quiet")
        for ours, theirs in zip(*([line.split(",") for line in self.output_of(f"sample {name} {QUIET}").splitlines()[1:]]
                                  for name in ("world.csv", "body.csv")), strict=True):
            for a, b in zip(ours, theirs, strict=True):
                self.assertAlmostEqual(float(a), float(b), delta=1e-14)

    def test_settings_with_a_value_per_key_are_columns_tuned_or_not(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.8,0.6,0,0\n2,0.6,0.8,0,0\n4,0.6,0,0.8,0\n")
        recipe = self.made("tune keys.csv --method timed-c2 --tension=0.5,0.6,0.7,0.8 --free tension2")
        self.assertEqual(recipe, "# orispline: method=timed-c2")
        self.assertEqual(table_of(self.read("made.csv"))[0], "t,qw,qx,qy,qz,tension,tension2")
        self.assertEqual([line.split(",")[5] for line in table_of(self.read("made.csv"))[1:]], ["0.5", "0.6", "0.7", "0.8"])

    def test_keys_of_any_norm_are_written_as_unit_ones(self):
        self.write("big.csv", "t,qw,qx,qy,qz\n0,3,0,0,0\n1,2.4,1.8,0,0\n2,1.8,2.4,0,0\n")
        self.made("tune big.csv --method timed-c2 --normalise")
        self.output_of("sample made.csv --rate 1")

    def test_standard_input_states_it_too(self):
        self.made(f"tune {FLIGHT} --method timed-c2")
        self.assertEqual(self.output_of(f"sample - {QUIET}", input=self.read("made.csv")),
                         self.output_of(f"sample made.csv {QUIET}"))

    def test_convert_carries_the_recipe_with_the_columns_that_it_takes(self):
        self.made(f"tune {FLIGHT} --method timed-c2")
        self.output_of("convert made.csv -o again.csv --quiet")
        self.assertEqual(self.recipe_in("again.csv"), "# orispline: method=timed-c2")
        self.assertEqual(self.output_of(f"sample again.csv {QUIET}"), self.output_of(f"sample made.csv {QUIET}"))
        done = self.run_command("convert made.csv -o keys.tum")
        self.assertNotIn("#", self.read("keys.tum"))
        self.assertIn("left out, having no place in the output: tension, tension2\n", done.stderr)
        self.assertIn("keys.tum: a TUM file has no columns for settings, so it does not say that its keys are for "
                      "timed-c2; name the method where the keys are read\n", done.stderr)

    def test_keys_that_need_an_option_to_be_read_are_written_so_that_they_do_not(self):
        rows = [line.split(",") for line in table_of(FLIGHT.read_text("utf-8"))]
        self.write("flipped.csv", "".join(",".join([r[0], r[1], *(c.removeprefix("-") if c.startswith("-") else "-" + c
                                                                  for c in r[2:5])]) + "\n" for r in rows[1:]))
        self.made("tune flipped.csv --order wxyz --conjugate --method timed-c2")
        mended = self.output_of(f"sample made.csv {QUIET}")
        self.output_of(f"convert {FLIGHT} -o straight.csv --quiet")
        self.write("straight.csv", "".join(",".join(line.split(",")[:5]) + "\n" for line in
                                           table_of(self.read("straight.csv"))))
        self.made("tune straight.csv --method timed-c2")
        self.assertEqual(mended, self.output_of(f"sample made.csv {QUIET}"))

    def test_a_recipe_that_is_not_understood_is_an_error_with_its_cure(self):
        keys = self.read("keys.csv")
        for line, message in (
                ("method=nosuch", "the file says that its keys are for 'nosuch': unknown method 'nosuch', wanted one of "),
                ("method=auto:tension=1", "the file says that its keys are for 'auto:tension=1': auto: unknown parameter "),
                ("band=1", "found 'band=1' in the comment that names the method of the keys, wanted method=NAME, and ")):
            self.write("bad.csv", f"# orispline: {line}\n{keys}")
            done = self.run_command("sample bad.csv --count 3")
            self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
            self.assertTrue(done.stderr.startswith("orispline: bad.csv:1: " + message), done.stderr)
            self.assertTrue(done.stderr.endswith(" (--ignore-recipe reads the keys without it)\n"), done.stderr)
            self.output_of("sample bad.csv --count 3 --ignore-recipe")


if __name__ == "__main__":
    main()
