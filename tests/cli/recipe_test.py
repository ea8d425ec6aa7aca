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
        self.assertEqual((done.returncode, done.stderr), (0, "orispline: warning: made.csv:1: the keys are for the curve of "
                                                             "timed-c2, not of squad\n"))
        self.assertEqual(self.run_command(f"sample made.csv --method timed-c2 {QUIET} -o motion.csv").stderr, "")

    def test_every_command_on_keys_takes_the_method_of_the_file(self):
        self.made(f"tune {FLIGHT} --method quintic --ends natural")
        self.assertIn(">quintic<", self.output_of("plot made.csv"))
        self.assertEqual(json.loads(self.output_of("retime made.csv --max-rate 9deg/s -o r.csv --json"))["method"], "quintic")
        self.assertEqual(self.recipe_in("r.csv"), "# orispline: method=quintic:ends=natural")
        self.assertEqual(json.loads(self.output_of("tune made.csv -o t.csv --json"))["method"], "quintic")
        self.assertEqual(json.loads(self.output_of("inspect made.csv --json"))["for_method"], "quintic:ends=natural")
        self.assertIn("for           quintic:ends=natural, says line 1\n", self.output_of("inspect made.csv"))
        self.assertIsNone(json.loads(self.output_of("inspect made.csv --ignore-recipe --json"))["for_method"])

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
        self.assertIn("not carried over: tension, tension2\n", done.stderr)
        self.assertIn("keys.tum: the keys are for the curve of timed-c2, which is not written into the file, for a TUM file "
                      "has no columns for settings; name the method where the keys are read\n", done.stderr)

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
                ("method=nosuch", "the curve that the keys are for, 'nosuch': no method 'nosuch', wanted one of "),
                ("method=auto:tension=1", "the curve that the keys are for, 'auto:tension=1': auto: no parameter "),
                ("band=1", "found 'band=1' in the line that says which curve the keys are for, wanted method=NAME, and ")):
            self.write("bad.csv", f"# orispline: {line}\n{keys}")
            done = self.run_command("sample bad.csv --count 3")
            self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
            self.assertTrue(done.stderr.startswith("orispline: bad.csv:1: " + message), done.stderr)
            self.assertTrue(done.stderr.endswith(" (--ignore-recipe reads the keys without it)\n"), done.stderr)
            self.output_of("sample bad.csv --count 3 --ignore-recipe")


if __name__ == "__main__":
    main()
