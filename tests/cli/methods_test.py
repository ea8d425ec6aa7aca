#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The list of methods, the help and the version."""
import json
import math
import re

from command import HINT, SUCCESS, CommandTest, main

FIELDS = ["name", "title", "source", "interpolates", "continuity_uniform", "continuity_uneven",
          "keeps_constant_rate_uniform", "keeps_constant_rate_uneven", "support_keys", "min_keys", "closes",
          "parameters", "ends"]


class Methods(CommandTest):
    def setUp(self):
        super().setUp()
        self.methods = {method["name"]: method for method in json.loads(self.output_of("methods --json"))}

    def test_every_method_has_every_field_in_order(self):
        for method in self.methods.values():
            self.assertEqual(list(method), FIELDS)
            for parameter in method["parameters"]:
                self.assertEqual(list(parameter), ["name", "default", "min", "max", "per_key"])

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

    def test_every_method_samples_at_its_defaults(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n" + "".join(
            f"{t},{math.cos(0.3 * t)},{math.sin(0.3 * t)},0,0\n" for t in (0, 1, 1.5, 2, 4, 4.5, 5)))
        for name in self.methods:
            self.assertEqual(self.output_of(f"sample keys.csv --count 9 --method {name}").count("\n"), 10)

    def test_eighteen_methods_are_listed(self):
        self.assertEqual(len(self.methods), 18)

    def test_the_local_four_key_methods_and_no_others_can_be_closed(self):
        closing = {name for name, method in self.methods.items() if method["closes"]}
        self.assertEqual(closing, {"quintic", "sextic", "timed-c1", "timed-c2", "timed-c3", "timed-sextic",
                                   "xing-quartic", "xing-quintic", "family"})


class Help(CommandTest):
    def test_every_command_has_help_with_examples(self):
        for command in ("", "sample", "convert", "inspect", "methods", "reproduce", "completion"):
            with self.subTest(command):
                done = self.run_command(f"{command} --help")
                self.assertEqual((done.returncode, done.stderr), (SUCCESS, ""))
                self.assertIn("Usage: orispline", done.stdout)
                self.assertRegex(done.stdout, rf"Examples:\n.*orispline {command}")

    def test_the_hint_after_a_bad_usage_is_true(self):
        for words in re.findall("'(.*?)'", HINT):
            self.assertIn("Usage:", self.output_of(words.replace("orispline ", "")))

    def test_the_version_is_three_numbers(self):
        self.assertRegex(self.output_of("--version"), r"^orispline \d+\.\d+\.\d+\n$")


if __name__ == "__main__":
    main()
