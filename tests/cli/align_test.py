#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline align: a recording brought onto another one of the same motion, alone and before compare and sample."""
import csv
import io
import json
import math
import os
import pathlib
import random
import unittest

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, CommandTest, main, table_of

RECORDINGS = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "")).parent / "cases/recordings"
NAMES = ("qw", "qx", "qy", "qz", "px", "py", "pz")
WORLD, BODY = (0.5, -0.5, 0.5, 0.5), (0.8, 0.0, 0.6, 0.0)  # w, x, y, z
LATE, SCALE, SHIFT = 0.31, 2.5, (10.0, -4.0, 1.5)


def product(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return (a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w)


def conjugate(q):
    return (q[0], -q[1], -q[2], -q[3])


def turned(q, v):
    return product(product(q, (0.0, *v)), conjugate(q))[1:]


def rotation(v):
    """Of a rotation vector."""
    angle = math.hypot(*v)
    sine = math.sin(angle / 2) / angle if angle else 0.5
    return (math.cos(angle / 2), *(sine * x for x in v))


def angle_between(p, q):
    """In degrees."""
    return math.degrees(2 * math.asin(min(1.0, math.hypot(*product(conjugate(p), q)[1:]))))


def motion(t):
    """A body that turns about changing axes and goes round a room."""
    q = product(rotation((0.9 * math.sin(1.1 * t), 0.7 * math.sin(1.7 * t + 0.4), 1.2 * math.sin(0.6 * t))),
                rotation((0.5 * math.cos(2.3 * t), 0.0, 0.3 * math.sin(3.1 * t))))
    return q, (2 * math.sin(0.7 * t), 1.5 * math.cos(0.9 * t) + 0.3 * t, 0.5 * math.sin(1.9 * t))


def moved(q, p):
    """As another system has them, which the alignment takes back: R' = W R Bᵀ, p' = s W p + d."""
    return (product(product(conjugate(WORLD), q), BODY),
            tuple(x / SCALE for x in turned(conjugate(WORLD), [a - b for a, b in zip(p, SHIFT)])))


def table(rows, *, positions=True):
    lines = [",".join(repr(float(x)) for x in (t, *q, *(p if positions else ()))) for t, q, p in rows]
    return "\n".join([",".join(("t", *NAMES[:7 if positions else 4])), *lines]) + "\n"


def recordings(*, count=400, rate=40, noise=0.0, wild=0.0):
    """The moved one and the fixed one, as tables, whose samples lie beside each other's."""
    dice = random.Random(4)

    def noisy(q):
        size = 1.5 if dice.random() < wild else noise
        return product(q, rotation([dice.gauss(0, size) for _ in range(3)]))

    fixed = [(i / rate, *motion(i / rate)) for i in range(count)]
    there = [(t + 0.3 / rate, *motion(t + 0.3 / rate)) for t, _, _ in fixed]
    late = [(t + LATE, *moved(q, p)) for t, q, p in there]
    return table([(t, noisy(q), p) for t, q, p in late]), table([(t, noisy(q), p) for t, q, p in fixed])


def rows_in(text):
    return [{name: float(cell) for name, cell in row.items()} for row in csv.DictReader(io.StringIO("\n".join(table_of(text))))]


class Align(CommandTest):
    def setUp(self):
        super().setUp()
        a, b = recordings()
        self.write("a.csv", a)
        self.write("b.csv", b)

    def written(self):
        return {path.name for path in self.folder.iterdir()} - {"a.csv", "b.csv", "keys.csv"}

    def assert_on_the_motion(self, text, angle=2e-3, length=2e-4):
        rows = rows_in(text)
        self.assertEqual(len(rows), 400)
        for row in rows[5:-5]:  # a smooth motion is less sure of its ends
            q, p = motion(row["t"])
            self.assertLess(angle_between(q, [row[name] for name in NAMES[:4]]), angle)
            self.assertLess(math.dist(p, [row[name] for name in NAMES[4:]]), length)

    def test_both_rotations_the_offset_the_scale_and_the_place_are_found(self):
        found = json.loads(self.output_of("align a.csv b.csv --json"))
        self.assertLess(angle_between(WORLD, list(found["world"].values())), 1e-3)
        self.assertLess(angle_between(BODY, list(found["body"].values())), 1e-3)
        self.assertAlmostEqual(found["offset_s"], LATE, delta=1e-5)
        self.assertAlmostEqual(found["scale"], SCALE, delta=1e-4)
        self.assertLess(math.dist(found["translation_m"], SHIFT), 1e-3)
        self.assertEqual((found["input"], found["reference"], found["samples"], found["reference_samples"]), ("a.csv", "b.csv", 400, 400))
        self.assertEqual((found["open"], found["warnings"]), ([], []))
        self.assertGreater(found["compared"], 380)
        self.assertLess(len(found["rejected"]), 10)  # at the ends, where a smooth motion is not as near as elsewhere
        for result in next(task for task in json.loads(self.output_of("tasks --json")) if task["task"] == "align")["results"]:
            self.assertIn(result["name"], found)
        self.assertEqual(self.written(), set())

    def test_what_is_written_lies_beside_the_reference(self):
        said = self.run_command("align a.csv b.csv -o out.csv")
        self.assertEqual((said.returncode, said.stdout), (0, ""))
        self.assert_on_the_motion(self.read("out.csv"))
        for line in ("400 samples from a.csv onto 400 samples from b.csv", "offset ", "world ", "body ", "left ", "scale ",
                     "translation ", "rejected ", "keys written to out.csv"):
            self.assertIn(line, said.stderr)
        again = json.loads(self.output_of("align a.csv b.csv -o again.csv --json"))
        self.assertEqual(self.read("again.csv"), self.read("out.csv"))
        self.assertEqual(again["output"], "again.csv")
        self.assertEqual(self.run_command("align a.csv b.csv -o quiet.csv --quiet").stderr, "")
        left = json.loads(self.output_of("align out.csv b.csv --json"))
        self.assertAlmostEqual(left["offset_s"], 0, delta=1e-6)
        self.assertAlmostEqual(left["scale"], 1, delta=1e-5)

    def test_without_an_output_what_was_found_is_printed(self):
        printed = self.output_of("align a.csv b.csv").splitlines()
        self.assertRegex(printed[1], r"^offset +0\.3[01]\d* s ± \S+ s$")
        self.assertRegex(printed[2], r"^world +qw 0\.\d+  qx -0\.\d+  qy 0\.\d+  qz 0\.\d+, a turn of 120° ± \S+°, \S+°, \S+°$")
        self.assertEqual(self.output_of("align - b.csv", input=(self.folder / "a.csv").read_text("utf-8")).splitlines()[1:], printed[1:])

    def test_a_tenth_of_wild_rows_does_no_harm(self):
        for name, text in zip(("a.csv", "b.csv"), recordings(noise=0.005, wild=0.1)):
            self.write(name, text)
        found = json.loads(self.output_of("align a.csv b.csv --json"))
        self.assertLess(angle_between(WORLD, list(found["world"].values())), 0.3)
        self.assertLess(angle_between(BODY, list(found["body"].values())), 0.3)
        self.assertAlmostEqual(found["offset_s"], LATE, delta=2e-3)
        self.assertGreater(len(found["rejected"]), 20)
        self.assertIn("line", found["rejected"][0])

    def test_only_what_is_asked_for_is_looked_for(self):
        found = json.loads(self.output_of(f"align a.csv b.csv --offset {LATE} --no-scale --no-translation --json"))
        self.assertEqual((found["offset_s"], found["offset_sigma_s"], found["scale"], found["translation_m"]), (LATE, 0, 1, [0, 0, 0]))
        self.assertLess(angle_between(WORLD, list(found["world"].values())), 1)
        self.assertGreater(found["position_rms_m"], 1)
        done = self.run_command("align a.csv b.csv --no-body-turn -o out.csv")
        self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
        self.assertIn("wanted two recordings of one motion", done.stderr)

    def test_an_offset_may_be_negative_none_or_have_its_unit(self):
        for offset, seconds in (("-0.31", -0.31), ("0", 0), ("-0.31s", -0.31)):
            found = json.loads(self.output_of(["align", "b.csv", "a.csv", "--offset", offset, "--json"]))
            self.assertEqual(found["offset_s"], seconds)

    def test_a_motion_that_lies_beside_another_at_several_offsets_is_told_of(self):
        period = 2 * math.pi / 1.7
        rows = [(i / 50, rotation((0.4 * math.sin(1.7 * i / 50), 0.3 * math.cos(1.7 * i / 50), 0.2 * math.sin(3.4 * i / 50))), (0, 0, 0))
                for i in range(700)]
        self.write("again_and_again.csv", table(rows, positions=False))
        self.write("a_part.csv", table([row for row in rows if 4 <= row[0] < 9], positions=False))
        done = self.run_command("align again_and_again.csv a_part.csv --json")
        warning, = json.loads(done.stdout)["warnings"]
        self.assertEqual(warning["code"], "ambiguous_offset")
        self.assertAlmostEqual(warning["apart_s"] / period, round(warning["apart_s"] / period), delta=0.01)
        self.assertIn("s away fits about as well: the motion is short or repeats itself, wanted a longer one, or --offset where it is known",
                      done.stderr)
        known = json.loads(self.output_of("align again_and_again.csv a_part.csv --offset 0 --json"))
        self.assertEqual(known["warnings"], [])

    def test_turns_about_one_axis_are_said_not_to_tell_all(self):
        rows = [(i / 50, rotation((0, 0, 1.5 * math.sin(i / 50))), (0, 0, 0)) for i in range(500)]
        self.write("z.csv", table(rows, positions=False))
        done = self.run_command("align z.csv z.csv --json")
        found = json.loads(done.stdout)
        self.assertEqual([warning["code"] for warning in found["warnings"]], ["open_alignment", "ambiguous_offset"])
        self.assertAlmostEqual(found["warnings"][1]["apart_s"], math.pi, delta=0.01)  # half a period later all turns the other way round
        self.assertIn("do not tell apart: a turn of the world about (0, 0, ", done.stderr)
        one, = found["open"]
        self.assertAlmostEqual(abs(one["world"][2]), math.sqrt(0.5), delta=0.01)

    @unittest.skipUnless(RECORDINGS.is_dir(), f"no {RECORDINGS}")
    def test_an_estimate_in_other_axes_and_late_is_compared_where_it_belongs(self):
        estimate, truth = (RECORDINGS / name for name in ("39_est.csv", "39_ref.csv"))
        words = ["compare", str(estimate), "--reference", str(truth), "--methods", "auto", "--json"]
        self.assertAlmostEqual(json.loads(self.output_of(words))[0]["rms_deg"], 100.1, delta=0.1)
        self.assertLess(json.loads(self.output_of([*words, "--align"]))[0]["rms_deg"], 1e-6)
        self.assertIn("200 samples aligned, 0.08", self.output_of([*words[:-1], "--align"]))
        words = ["sample", str(estimate), "--rate", "20", "--truth", str(truth), "-o", "out.csv", "--json"]
        self.assertAlmostEqual(json.loads(self.output_of(words))["truth"]["distance_rms_deg"], 100.1, delta=0.1)
        self.assertIsNone(json.loads(self.output_of(words))["truth"]["alignment"])
        aligned = json.loads(self.output_of([*words, "--align"]))["truth"]
        self.assertLess(aligned["distance_rms_deg"], 1e-6)
        self.assertAlmostEqual(aligned["alignment"]["offset_s"], -0.08, delta=1e-6)
        self.output_of(["align", str(estimate), str(truth), "-o", "there.csv", "--quiet"])
        for row, wanted in zip(rows_in(self.read("there.csv")), rows_in(truth.read_text("utf-8"))[0:]):
            self.assertAlmostEqual(row["t"], wanted["t"], delta=1e-6)
            self.assertLess(angle_between([row[name] for name in NAMES[:4]], [wanted[name] for name in NAMES[:4]]), 1e-5)


class Refused(CommandTest):
    def setUp(self):
        super().setUp()
        for name, text in zip(("a.csv", "b.csv"), recordings()):
            self.write(name, text)

    def assert_refused(self, arguments, code, message):
        before = {path.name for path in self.folder.iterdir()}
        self.assert_fails(arguments, code, message)
        self.assertEqual({path.name for path in self.folder.iterdir()}, before)

    def test_offsets_that_cannot_be(self):
        apart = "found recordings from 0.3175 to 10.2925 s and from 0 to 9.975 s, of which fewer than 8 samples lie side by side with it"
        for offset, message in (("soon", "found 'soon', wanted a number"), ("nan", "found 'nan', wanted a number"),
                                ("5000", f"{apart}, wanted an offset that brings them together, or none"),
                                ("-10.2", f"{apart}, wanted an offset that brings them together, or none")):
            with self.subTest(offset):
                self.assert_refused(f"align a.csv b.csv --offset={offset} -o out.csv", BAD_USAGE, f"--offset: {message}")

    def test_recordings_of_other_motions(self):
        rows = [(i / 40, rotation((3 * math.sin(0.37 * i / 40), 2 * i / 40, math.cos(i / 8))), (0, 0, 0)) for i in range(400)]
        self.write("other.csv", table(rows, positions=False))
        done = self.run_command("align other.csv b.csv -o out.csv")
        self.assertEqual((done.returncode, done.stdout, len(done.stderr.splitlines())), (BAD_DATA, "", 1))
        self.assertRegex(done.stderr, r"^orispline: half of the orientations stay farther than \S+° apart however they are turned and "
                                      r"delayed, wanted two recordings of one motion$")
        self.assertFalse((self.folder / "out.csv").exists())

    def test_too_few_rows(self):
        self.write("few.csv", "".join(line + "\n" for line in self.read("a.csv").splitlines()[:8]))
        for arguments in ("few.csv b.csv", "b.csv few.csv"):
            self.assert_refused(f"align {arguments} -o out.csv", BAD_DATA, "few.csv: found 7 orientations, wanted 8 at least")

    def test_files_that_are_not_there_or_named_twice(self):
        self.assert_refused("align a.csv none.csv -o out.csv", BAD_ACCESS, "none.csv: cannot open: No such file or directory")
        self.assert_refused("align none.csv b.csv", BAD_ACCESS, "none.csv: cannot open: No such file or directory")
        self.assert_refused("align - -", BAD_USAGE, "found '-' for INPUT and for REFERENCE, wanted it for one at most")
        self.assert_refused("align a.csv b.csv -o b.csv", BAD_USAGE, "-o: found 'b.csv', wanted another file than REFERENCE, which would be lost")
        self.assert_refused("align a.csv b.csv -o a.csv", BAD_USAGE, "-o: found 'a.csv', wanted another file than INPUT, which would be lost")

    def test_options_of_an_output_without_one(self):
        self.assert_refused("align a.csv b.csv --quiet", BAD_USAGE, "--quiet: found no -o, wanted -o FILE for the aligned recording")
        self.assert_refused("align a.csv b.csv --output-format tum", BAD_USAGE,
                            "--output-format: found no -o, wanted -o FILE for the aligned recording")

    def test_align_of_other_commands_wants_something_to_align_with(self):
        self.assert_refused("compare a.csv --align", BAD_USAGE,
                            "--align: found no recording to align the keys with, wanted --reference as well")
        self.assert_refused("sample a.csv --rate 10 --align -o out.csv", BAD_USAGE, "--align: found no --truth, wanted one to align")
        self.write("few.csv", "".join(line + "\n" for line in self.read("a.csv").splitlines()[:8]))
        few = "few.csv: found 7 orientations, wanted 8 at least"
        self.assert_refused("compare a.csv --reference few.csv --align --report out.html", BAD_DATA, few)
        self.assert_refused("sample a.csv --rate 10 --truth few.csv --align -o out.csv", BAD_DATA, few)


if __name__ == "__main__":
    main()
