#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Blending functions of one's own: --blending FILE of every command that takes a method."""
import json
import pathlib
import re

from command import BAD_USAGE, SUCCESS, CommandTest, main

ROOT = pathlib.Path(__file__).resolve().parents[2]
KEYS = ROOT / "examples/data/five_keys.csv"
FLIGHT = ROOT / "examples/data/flight_truth.csv"
QUINTIC = {"name": "mine", "title": "Tan's quintic, typed in", "parameters": {"tension": 0.5},
           "rows": [["1", "1+a/5", "1+7*a/20", "1", "1", "1"], ["0", "a/5", "9*a/20", "1-9*b/20", "1-b/5", "1"],
                    ["0", "0", "0", "-7*b/20", "-b/5", "0"]], "ends": "repeat"}


def numbers(text):
    return [list(map(float, row.split(","))) for row in text.splitlines() if row[:1] in "-0123456789"]


class Blending(CommandTest):
    def setUp(self):
        super().setUp()
        self.file = self.stated(QUINTIC)

    def stated(self, members, name="mine.json"):
        self.write(name, json.dumps(members))
        return name

    def error_of(self, arguments):
        """Standard error of a run that has to fail."""
        done = self.run_command(arguments)
        self.assertNotEqual(done.returncode, SUCCESS)
        self.assertEqual(done.stdout, "")
        return done.stderr

    def same_as_the_quintic(self, mine, quintic):
        for a, b in zip(numbers(mine), numbers(quintic), strict=True):
            for x, y in zip(a, b, strict=True):
                self.assertAlmostEqual(x, y, delta=1e-12 * max(1, abs(y)))

    def test_the_page_shows_what_methods_says(self):
        page = (ROOT / "docs/own-blending.md").read_text("utf-8")
        typed = re.search(r"<<'J'\n(.*?)\nJ\n", page, re.S)[1]
        shown = re.search(r"```text\n(mine: .*?)```", page, re.S)[1]
        self.write("page.json", typed)
        self.assertEqual(self.output_of("methods --blending page.json"), shown)
        failing = typed.replace('"1-b/5", "1"]', '"1-b/5", "0.95"]')
        self.write("failing.json", failing)
        found, = json.loads(self.output_of("methods --json --blending failing.json"))
        said = " ".join(f["sentence"] for f in found["findings"])
        for sentence in re.search(r"```text\n(It does not.*?)```", page, re.S)[1].splitlines():
            self.assertIn(sentence, said)

    def test_the_document_has_the_findings(self):
        method, = json.loads(self.output_of(f"methods --json --blending {self.file}"))
        self.assertEqual((method["name"], method["continuity_uniform"], method["continuity_uneven"],
                          method["continuity_of_shape"]), ("mine", 2, 0, 2))
        self.assertEqual([f["promise"] for f in method["findings"]][:2], ["interpolates", "continuity_uniform"])

    def test_samples_are_those_of_the_built_in_method(self):
        for settings in ("", ":tension=0.35", ":tension=0.3,0.7,-0.2,0.9,0.4", ":ends=clamped,rest:start_rate=0.1,0,0.2"):
            with self.subTest(settings):
                self.same_as_the_quintic(
                    self.output_of(f"sample {KEYS} --rate 20 --blending {self.file} --method mine{settings} -o -"),
                    self.output_of(f"sample {KEYS} --rate 20 --method quintic{settings} -o -"))

    def test_compare_ranks_it_beside_the_others(self):
        rows = {row["method"]: row for row in json.loads(self.output_of(
            f"compare {FLIGHT} --keep-every 16 --json --blending {self.file} --methods mine,quintic"))}
        for measure, value in rows["quintic"].items():
            if isinstance(value, float) and "time" not in measure and "seconds" not in measure and "jump" not in measure:
                self.assertAlmostEqual(rows["mine"][measure], value, delta=1e-9 * max(1, abs(value)), msg=measure)

    def test_inspect_plot_reduce_and_retime_take_it(self):
        inspected = json.loads(self.output_of(f"inspect {KEYS} --json --blending {self.file} --method mine"))["methods"]
        self.assertEqual((inspected[0]["continuity_order"], inspected[0]["shape_order"]), (0, 2))
        self.output_of(f"plot {KEYS} --blending {self.file} --method mine -o mine.svg")
        self.assertIn("mine", self.read("mine.svg"))
        for command in (f"reduce {FLIGHT} --tolerance 0.5deg", f"retime {KEYS} --max-rate 30deg/s"):
            with self.subTest(command):
                mine = json.loads(self.output_of(f"{command} --blending {self.file} --method mine --json -o mine.csv"))
                theirs = json.loads(self.output_of(f"{command} --method quintic --json -o theirs.csv"))
                self.assertEqual(mine["keys"], theirs["keys"])

    def test_tuned_keys_are_complete_by_themselves(self):
        self.output_of(f"tune {KEYS} --blending {self.file} --method mine -o tuned.csv")
        self.output_of(f"tune {KEYS} --method quintic -o theirs.csv")
        self.same_as_the_quintic(self.output_of("sample tuned.csv --rate 20 -o -"),
                                 self.output_of("sample theirs.csv --rate 20 -o -"))
        said = self.run_command(f"sample tuned.csv --blending {self.file} --method mine --rate 20 -o -").stderr
        self.assertNotIn("warning", said)

    def test_what_is_not_linear_in_a_parameter_is_not_tuned(self):
        self.stated({**QUINTIC, "rows": [["0", "a*a", "1"]]})
        self.assertIn("wanted a parameter in which the blending functions are linear",
                      self.error_of(f"tune {KEYS} --blending mine.json --method mine -o tuned.csv"))

    def test_a_stream_of_keys_is_sampled(self):
        self.same_as_the_quintic(
            self.output_of(f"sample - --rate 20 --blending {self.file} --method mine -o -", input=KEYS.read_text("utf-8")),
            self.output_of("sample - --rate 20 --method quintic -o -", input=KEYS.read_text("utf-8")))

    def test_corners_and_jumps_at_the_keys_are_warned_of(self):
        slack = json.loads(re.sub(r"\b([ab])(?=/)", r"(1-\1)", json.dumps(QUINTIC)))
        self.stated(slack, "slack.json")
        self.stated({"name": "jumping", "rows": [["0", "h/h_1"]], "first": 0}, "jumping.json")
        for file, method, warning, order in (
                ("slack.json", "mine", None, 0), ("slack.json", "mine:tension=1", "key 1: the body of mine rests or turns back", 2),
                ("jumping.json", "jumping", "the curve of jumping jumps by 145", -1)):
            for command in ("sample", "inspect"):
                with self.subTest(f"{command} {method}"):
                    rows = " --rate 10 -o -" if command == "sample" else ""
                    said = self.run_command(f"{command} {KEYS} --blending {file} --method {method}{rows}").stderr
                    (self.assertIn if warning else self.assertNotIn)(warning or "warning", said)
            found, = json.loads(self.output_of(f"inspect {KEYS} --json --blending {file} --method {method}"))["methods"]
            self.assertEqual(found["continuity_order"], order)

    def test_what_cannot_be_understood_is_told_with_its_place(self):
        def with_rows(rows, **members):
            return {**QUINTIC, "rows": rows, **members}
        for members, message in (
                (with_rows([["0", "c"]]), "row 1, entry 2, position 1: unknown name 'c'"),
                (with_rows([["0", "1/a"]]), "found a division by a parameter"),
                (with_rows([["0", True]]), "row 1, entry 2: found true, wanted a number or a text"),
                (with_rows([["0", "1"]], name="squad"), "found 'squad', which is a method already"),
                (with_rows([["0", "1"]], extra=1), "found the member 'extra', wanted name, title"),
                (with_rows([["0", "1"]], basis="b"), "basis: found 'b', wanted one of bernstein, power, bezier"),
                (with_rows([["0", "1"], ["0", "1"]]), "wanted 'first'"),
                (with_rows("1"), "rows: found '1', wanted a list of rows"),
                (with_rows([]), "rows: found 0, wanted 1 to 5")):
            with self.subTest(message):
                self.stated(members, "bad.json")
                error = self.error_of("methods --blending bad.json")
                self.assertIn("bad.json: ", error)
                self.assertIn(message, error)
        self.write("torn.json", '{"name": "mine",\n "rows": [[0, 1]')
        self.assertIn("torn.json:3:1:", self.error_of("methods --blending torn.json"))
        self.write("big.json", " " * 70000)
        self.assertIn("wanted fewer", self.error_of("methods --blending big.json"))
        self.assertEqual(self.run_command(f"methods x --blending {self.file}").returncode, BAD_USAGE)


if __name__ == "__main__":
    main()
