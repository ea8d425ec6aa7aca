#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The list of methods, the help and the version."""
import json
import math
import re

from command import BAD_USAGE, EXPECTED, SUCCESS, CommandTest, main

FIELDS = ["name", "title", "source", "interpolates", "continuity_uniform", "continuity_uneven", "continuity_of_shape",
          "keeps_constant_rate_uniform", "keeps_constant_rate_uneven", "support_keys", "min_keys", "closes",
          "rate_orders", "order_with_inner_quaternions", "parameters", "choices", "ends"]


class Methods(CommandTest):
    def setUp(self):
        super().setUp()
        self.methods = {method["name"]: method for method in json.loads(self.output_of("methods --json"))}

    def test_every_method_has_every_field_in_order(self):
        for method in self.methods.values():
            self.assertEqual(list(method), FIELDS)
            for parameter in method["parameters"]:
                self.assertEqual(list(parameter), ["name", "default", "min", "max", "per_key", "ghosts", "tensor", "unit"])
            for choice in method["choices"]:
                self.assertEqual(list(choice), ["name", "default", "words"])

    def test_the_timed_quintic_is_described(self):
        method = self.methods["timed-c2"]
        self.assertEqual((method["continuity_uniform"], method["continuity_uneven"]), (2, 2))
        self.assertEqual((method["support_keys"], method["min_keys"], method["interpolates"]), (4, 2, True))
        self.assertEqual([(p["name"], p["default"], p["per_key"]) for p in method["parameters"]],
                         [("tension", 0.5, True), ("tension2", 1, True)])
        self.assertEqual(method["ends"][0], "natural")

    def test_the_default_end_comes_first(self):
        defaults = {name: self.methods[name]["ends"][:1] for name in ("slerp", "squad", "quintic")}
        self.assertEqual(defaults, {"slerp": [], "squad": ["key"], "quintic": ["repeat"]})

    def test_the_page_for_people_names_every_method(self):
        page = self.output_of("methods")
        for name, method in self.methods.items():
            self.assertRegex(page, rf"(?m)^{name} +{re.escape(method['title'])}$")

    def test_the_page_for_people_fits_a_hundred_columns(self):
        self.assertLessEqual(max(map(len, self.output_of("methods").splitlines())), 100)

    def entry_of(self, name):
        """The lines of the page about one method, as one line with single blanks."""
        page = self.output_of("methods")
        return " ".join(re.search(rf"(?m)^{name} (?:.|\n(?!\n))*", page)[0].split())

    def test_one_method_is_described_whole(self):
        for name, method in self.methods.items():
            page = " ".join(self.output_of(f"methods {name}").split())
            for word in (f"{name}: {method['title']} ", f" source {method['source']} ", f" docs/families/{name}.md ",
                         f" C{method['continuity_uneven']} ", f" It needs {method['min_keys']} keys at least"):
                self.assertIn(word, page)
            for parameter in method["parameters"]:
                values = "one, or the diagonal of a symmetric matrix" if parameter["tensor"] else "one for all keys"
                self.assertRegex(page, rf" {parameter['name']}=\S+, from \S+ to \S+, {values}")
            for choice in method["choices"]:
                self.assertIn(f" {choice['name']}={'|'.join(choice['words'])}, ", page)
            self.assertIn(" --closed" if method["closes"] else " It cannot be a loop", page)
            self.assertIn(f" {', '.join(method['ends'])}; " if method["ends"] else " no end rules", page)
            self.assertLessEqual(max(map(len, self.output_of(f"methods {name}").splitlines())), 100)
            self.assertEqual(json.loads(self.output_of(f"methods {name} --json")), [method])

    def test_the_page_of_a_method_by_heart(self):
        self.assertEqual(self.output_of("methods timed-c2"), (EXPECTED / "method.txt").read_text("utf-8"))

    def test_a_method_that_is_none_gets_one_line(self):
        self.assert_fails("methods squadd", BAD_USAGE, "unknown method 'squadd'; did you mean 'squad'?")
        self.assert_fails("methods auto slerp", BAD_USAGE,
                          "methods: found 'slerp', wanted no more words here; 'orispline help methods' lists the options")

    def test_choices_are_listed_with_their_words_the_default_first(self):
        self.assertEqual(self.methods["squad-timed"]["choices"],
                         [{"name": "variant", "default": "geier", "words": ["geier", "boyle"]}])
        self.assertIn(" settings variant=geier|boyle ", self.entry_of("squad-timed"))
        choices = {choice["name"]: choice["words"] for choice in self.methods["hermite-c2"]["choices"]}
        self.assertEqual(choices, {"stencil": ["5", "3"], "form": ["chart", "cumulative"]})

    def test_a_parameter_says_whether_keys_may_differ(self):
        self.assertIn(" settings hold=0 (one for all), rest-angle=0 (one for all) ", self.entry_of("auto"))
        self.assertIn(" settings tension=0.5, tension2=1 ", self.entry_of("timed-c2"))

    def test_global_methods_depend_on_all_keys(self):
        for name in ("global-c2", "rational", "rotation-spline", "bspline-through", "nu", "nu-exact"):
            with self.subTest(name):
                self.assertIsNone(self.methods[name]["support_keys"])
                self.assertIn(" depends on all keys", self.entry_of(name))
        self.assertIn(" depends on 8 keys", self.entry_of("auto"))

    def test_rate_columns_are_named_where_they_are_used(self):
        for name, order in (("auto", 0), ("hermite-c1", 1), ("hermite-c2", 2), ("hermite-c3", 3)):
            self.assertEqual(self.methods[name]["rate_orders"], order)
        self.assertIn(" columns wx,wy,wz[,ax,ay,az] ", self.entry_of("hermite-c2"))
        self.assertNotIn(" columns ", self.entry_of("auto"))

    def test_columns_of_inner_quaternions_are_named_where_they_are_used(self):
        taking = {name: method["order_with_inner_quaternions"] for name, method in self.methods.items()
                  if method["order_with_inner_quaternions"] is not None}
        self.assertEqual(taking, {"squad": 0})
        self.assertIn(" columns a_qw,a_qx,a_qy,a_qz, b_qw,b_qx,b_qy,b_qz ", self.entry_of("squad"))
        page = " ".join(self.output_of("methods squad").split())
        self.assertIn("It reads a_qw,a_qx,a_qy,a_qz, b_qw,b_qx,b_qy,b_qz where the file has them, and chooses the others itself. They "
                      "leave it C0 and G0, unless the rates on both sides of a key agree.", page)

    def test_every_method_samples_at_its_defaults(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(0.3 * t)},{math.sin(0.3 * t)},0,0\n" for t in (0, 1, 1.5, 2, 4, 4.5, 5)))
        for name in self.methods:
            self.assertEqual(self.output_of(f"sample keys.csv --count 9 --method {name}").count("\n"), 10)

    def test_the_local_four_key_methods_and_global_ones_can_be_closed(self):
        closing = {name for name, method in self.methods.items() if method["closes"]}
        self.assertLessEqual({"quintic", "sextic", "atbi", "timed-c1", "timed-c2", "timed-c3", "timed-sextic",
                              "xing-quartic", "xing-quintic", "uniform", "biarcs", "monotone", "global-c2", "nu-exact", "rational",
                              "rotation-spline", "bspline-through", "beta", "beta-g2", "beta-through"}, closing)
        self.assertFalse({"auto", "slerp", "squad", "bezier", "bspline", "nu"} & closing)


class Help(CommandTest):
    def test_every_command_has_help_with_examples(self):
        for command in ("", "sample", "convert", "inspect", "methods", "reproduce", "completion"):
            with self.subTest(command):
                done = self.run_command(f"{command} --help")
                self.assertEqual((done.returncode, done.stderr), (SUCCESS, ""))
                self.assertIn("Usage: orispline", done.stdout)
                self.assertRegex(done.stdout, rf"Examples:\n.*orispline {command}")

    def test_what_a_bad_usage_says_to_type_prints_help(self):
        for arguments in ("", "--bogus", "sample", "sample keys.csv --xyzzy", "inspect keys.csv more.csv"):
            said = re.findall("'(orispline help.*?)'", self.run_command(arguments).stderr)
            self.assertTrue(said, arguments)
            for words in said:
                self.assertIn("Usage:", self.output_of(words.replace("orispline ", "")))

    def test_help_of_a_command_is_its_help(self):
        for words, same in (("help", "--help"), ("help sample", "sample --help"), ("help help", "help --help")):
            self.assertEqual(self.output_of(words), self.output_of(same))
        self.assert_fails("help sampel", BAD_USAGE, "unknown command 'sampel'; did you mean 'sample'?")
        self.assert_fails("help sample convert", BAD_USAGE, "help: found 2 words, wanted one command")

    def test_the_version_is_three_numbers(self):
        self.assertRegex(self.output_of("--version"), r"^orispline \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    main()
