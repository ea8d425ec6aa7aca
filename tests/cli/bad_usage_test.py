#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Command lines that are refused: exit code 2 and one line that says what is wrong."""
import json
import os

from command import BAD_USAGE, CommandTest, main

ENDS = "natural, repeat, quadratic, cubic, clamped, rest"
COMMANDS = "sample, convert, inspect, difference, compare, align, plot, studio, clip, smooth, mean, tune, reduce, retime, bake, methods, tasks, reproduce, completion, help"

CASES = (
    ("interpolate keys.csv", f"unknown command 'interpolate', wanted one of {COMMANDS}"),
    ("resample keys.csv", "unknown command 'resample'; did you mean 'sample'?"),
    ("--bogus", "found the option '--bogus' first, wanted a command before it, such as sample; 'orispline help' lists them"),
    ("--hepl", "unknown option '--hepl'; did you mean '--help'?"),
    ("sample", "sample: INPUT is missing; 'orispline help sample' shows what to type"),
    ("reduce keys.csv", "reduce: --tolerance is missing; 'orispline help reduce' shows what to type"),
    ("sample keys.csv --rate 1 --xyzzy", "sample: unknown option '--xyzzy'; 'orispline help sample' lists them"),
    ("sample keys.csv --rate 1 --quite", "sample: unknown option '--quite'; did you mean '--quiet'?"),
    ("sample keys.csv --ratte=1", "sample: unknown option '--ratte'; did you mean '--rate'?"),
    ("sample keys.csv more.csv --rate 1",
     "found 2 inputs, 'keys.csv' and 'more.csv'; wanted one, or --output-folder FOLDER for their samples"),
    ("sample keys.csv --rate", "--rate: found nothing after it, wanted HZ"),
    ("sample keys.csv --rate 1 --rate 2", "--rate: found it more than once, wanted it once"),
    ("sample keys.csv --rate= --quiet", "--rate= wanted a value after it"),
    # times
    ("sample keys.csv", "found none of --rate, --count and --times, wanted one of them, such as --rate 100"),
    ("sample keys.csv --rate 1 --count 2", "found 2 of --rate, --count and --times, wanted one of them, such as --rate 100"),
    ("sample keys.csv --rate fast", "--rate: found 'fast', wanted a number of samples per second greater than 0"),
    ("sample keys.csv --rate 0", "--rate: found '0', wanted a number of samples per second greater than 0"),
    ("sample keys.csv --rate -5", "--rate: found '-5', wanted a number of samples per second greater than 0"),
    ("sample keys.csv --rate nan", "--rate: found 'nan', wanted a number of samples per second greater than 0"),
    ("sample keys.csv --rate 1e999", "--rate: found '1e999', wanted a number of samples per second greater than 0"),
    ("sample keys.csv --rate 1e300", "--rate: 1e+300 makes 3e+300 samples over 3 s, wanted fewer than 9e+15"),
    ("sample keys.csv --count 0", "--count: found '0', wanted a whole number from 1 on"),
    ("sample keys.csv --count 2.5", "--count: found '2.5', wanted a whole number from 1 on"),
    ("sample keys.csv --count 2 --from now", "--from: found 'now', wanted a number of seconds, a fraction such as 1/24, a "
     "frame such as 12f, or a time such as 2024-02-29T12:30:00Z"),
    ("sample keys.csv --count 2 --from 2 --to 1", "--from 2 is after --to 1"),
    ("sample keys.csv --count 2 --from 4", "--from 4 is after the end at 3, wanted --to as well"),
    ("sample keys.csv --count 2 --to=-1", "--to -1 is before the start at 0, wanted --from as well"),
    ("sample keys.csv --count 2 --from 1 --to 1", "--count: found 2 and a range that is the single time 1, wanted 1"),
    ("sample keys.csv --times keys.csv --to 2", "--times: its file says which times to sample; wanted neither --from nor --to"),
    ("sample keys.csv --rate 1 --to 4 --extrapolate error", "time 4 is outside the curve, wanted 0 to 3"),
    ("sample keys.csv --rate 1 --extrapolate bend", "--extrapolate: found 'bend', wanted hold|error|nan|rate|segment|leave-out"),
    ("sample - --times -", "found '-' for several of INPUT, --times and --truth, wanted it for one at most"),
    # the shape of the curve
    ("sample keys.csv --rate 1 --method timed-c2 --tension high",
     "--tension: found 'high', wanted numbers with commas between them"),
    ("sample keys.csv --rate 1 --method timed-c2 --tension 1,,2",
     "--tension: found '1,,2', wanted numbers with commas between them"),
    ("sample keys.csv --rate 1 --method timed-c2 --tension=-0.1,0.2",
     "timed-c2: found 2 values of tension, wanted 1 or one per key (3)"),
    ("sample keys.csv --rate 1 --method timed-c2 --tension 0,0,1000",
     "keys.csv:4: key 2: timed-c2: tension is 1000, wanted -100 to 100"),
    ("sample keys.csv --rate 1 --set tension", "--set: found 'tension', wanted NAME=VALUE"),
    ("sample keys.csv --rate 1 --set =1", "--set: found '=1', wanted NAME=VALUE"),
    ("sample keys.csv --rate 1 --set bias=1", "auto: unknown parameter 'bias', wanted one of hold, rest-angle"),
    ("sample keys.csv --rate 1 --tension 1", "auto: unknown parameter 'tension', wanted one of hold, rest-angle"),
    ("sample keys.csv --rate 1 --set hold=yes", "--set hold: found 'yes', wanted numbers with commas between them"),
    ("sample none.csv --rate 1 --method auto --set bias=left", "auto: unknown parameter 'bias', wanted one of hold, rest-angle"),
    ("sample keys.csv --rate 1 --method timed-c2 --set bias=1",
     "timed-c2: unknown parameter 'bias', wanted one of tension, tension2"),
    ("sample keys.csv --rate 1 --method timed-c2 --set tension=1 --tension 1",
     "--set tension: 'tension' is given twice, wanted it once"),
    ("sample keys.csv --rate 1 --ends natural",
     "--ends: auto has no end rules; for ends 'natural' take another method, such as timed-c2"),
    ("sample keys.csv --rate 1 --start-rate=0,0,1",
     "--start-rate: auto has no end rules; for ends 'clamped' take another method, such as timed-c2"),
    ("sample keys.csv --rate 1 --method timed-c2 --ends loose",
     f"--ends: timed-c2: unknown end rule 'loose', wanted one of {ENDS}"),
    ("sample keys.csv --rate 1 --method timed-c2 --ends rest,rest,rest",
     "--ends: found 'rest,rest,rest', wanted RULE or START,END"),
    ("sample keys.csv --rate 1 --method timed-c2 --ends clamped", "--ends clamped: found no rate for that end, wanted "
                                                                  "--start-rate as well"),
    ("sample keys.csv --rate 1 --method timed-c2 --ends clamped --start-rate=0,0,1",
     "--ends clamped: found no rate for that end, wanted --end-rate as well"),
    ("sample keys.csv --rate 1 --method timed-c2 --ends natural --end-rate=0,0,1",
     "--end-rate: a rate needs the end rule clamped, found natural"),
    ("sample keys.csv --rate 1 --method timed-c2 --start-rate=1,2",
     "--start-rate: found '1,2', wanted three numbers with commas between them"),
    ("sample keys.csv --rate 1 --method timed-c2 --tension 0 --start-rate=0,0,1",
     "keys.csv:2: key 0: a clamped end needs a non-zero tension at that key, found 0"),
    # reading
    (["sample", "", "--rate", "1"], "INPUT: found an empty name, wanted FILE or -"),
    (["sample", "keys.csv", "--rate", "1", "-o", ""], "-o: found an empty name, wanted that of a file"),
    ("inspect keys.csv --method auto,quintic:tension=0.3,0.7,0.2",
     "--method: found '0.7' between commas, wanted a method; one whose settings have commas is given by an option of its own"),
    ("compare keys.csv --methods auto,timed-c2:ends=natural,rest",
     "--methods: found 'rest' between commas, wanted a method; one whose settings have commas is given by an option of its own"),
    ("compare keys.csv --methods quintic:tension=0.3,0.7:bias=1", "quintic: unknown parameter 'bias', wanted one of tension"),
    ("plot keys.csv --method quintic:tension=0.3,0.7,slerp",
     "--method: found '0.7' between commas, wanted a method; one whose settings have commas is given by an option of its own"),
    ("inspect keys.csv --tension 1", "found options that shape a curve, but no curve; wanted --method as well"),
    ("sample keys.csv --rate 1 --signs long", "--signs: found 'long', wanted shortest|as-given|as-typed"),
    ("sample keys.csv --rate 1 --input-format json", "--input-format: found 'json', wanted csv|tum|euroc|bvh|gltf"),
    ("sample keys.csv --rate 1 --order zyxw", "--order: found 'zyxw', wanted wxyz|xyzw"),
    ("sample keys.csv --rate 1 --time-scale 0", "--time-scale: found '0', wanted a number greater than 0, or a "
     "fraction such as 30000/1001"),
    ("sample keys.csv --rate 1 --columns t", "--columns: found 't', wanted NAME=VALUE"),
    ("sample keys.csv --rate 1 --columns t=a,t=b", "--columns: 't' is given twice, wanted it once"),
    ("sample keys.csv --rate 1 --input-orientation axis",
     "--input-orientation: found 'axis', wanted quaternion|euler|matrix|rotvec"),
    ("sample keys.csv --rate 1 --euler ZZY", "--euler: found 'ZZY', wanted three axes such as ZYX (those of the body) or "
                                             "zyx (of the world), none twice in a row"),
    ("sample keys.csv --rate 1 --angle-unit grad", "--angle-unit: found 'grad', wanted deg|rad|mrad|arcsec"),
    ("sample keys.csv --rate 1 --angle-unit deg",
     "keys.csv:1: --angle-unit: found an orientation in qw, qx, qy, qz, wanted Euler angles"),
    ("convert keys.csv --input-format tum --euler ZYX",
     "keys.csv:1: --euler: found a TUM file, which has no header, wanted CSV with one"),
    # loops
    ("sample keys.csv --rate 1 --method timed-c2 --period 0",
     "--period: found '0', wanted a number of seconds greater than 0"),
    ("sample keys.csv --rate 1 --method timed-c2 --period round",
     "--period: found 'round', wanted a number of seconds greater than 0"),
    ("sample keys.csv --rate 1 --method timed-c2 --period 2",
     "the period is 2 s, wanted a finite number greater than the keys' span of 3 s"),
    ("sample keys.csv --rate 1 --method timed-c2 --ends rest --period 4",
     "timed-c2: a closed curve has no ends, found an end rule"),
    ("inspect keys.csv --closed", "found options that shape a curve, but no curve; wanted --method as well"),
    # writing
    ("sample keys.csv --rate 1 --output-format xml", "--output-format: found 'xml', wanted csv|tum|euroc|npy"),
    ("sample keys.csv --rate 1 --derivatives 4", "--derivatives: found '4', wanted 0, 1, 2 or 3"),
    ("sample keys.csv --rate 1 --derivatives 1 -o motion.tum",
     "--derivatives: found '1', wanted 0 for a TUM file, which has no columns for rates"),
    ("sample keys.csv --rate 1 --frame world --output-format tum",
     "--frame: found 'world', wanted body for a TUM file, which has no columns for rates"),
    ("sample keys.csv --rate 1 --derivatives 2 --output-format euroc",
     "--derivatives: found '2', wanted 0 for an EuRoC file, which has no columns for rates"),
    ("sample keys.csv --rate 1 --output-orientation euler -o motion.tum",
     "--output-orientation: a TUM file holds orientations as quaternions only, wanted CSV or NumPy"),
    ("convert keys.csv --output-euler ZYX --output-format euroc",
     "--output-euler: an EuRoC file holds orientations as quaternions only, wanted CSV or NumPy"),
    ("convert keys.csv --output-orientation matrix --output-angle-unit rad",
     "--output-orientation: found 'matrix', wanted euler with --output-angle-unit"),
    ("convert keys.csv --output-euler XYY", "--output-euler: found 'XYY', wanted three axes such as ZYX (those of the "
                                            "body) or zyx (of the world), none twice in a row"),
    ("sample keys.csv --rate 1 --frame moon", "--frame: found 'moon', wanted body|world"),
    ("sample keys.csv --rate 1 --json",
     "--json: the summary goes to standard output, wanted -o FILE for the samples"),
    ("convert keys.csv --json", "--json: the summary goes to standard output, wanted -o FILE for the keys"),
    # the other commands
    ("convert", "convert: INPUT is missing; 'orispline help convert' shows what to type"),
    ("convert keys.csv --threads 1", "convert: unknown option '--threads'; 'orispline help convert' lists them"),
    ("convert keys.csv --rate 1", "--rate: found an output without a skeleton, wanted a file such as walk.bvh or walk.glb"),
    ("inspect", "inspect: INPUT is missing; 'orispline help inspect' shows what to type"),
    ("compare keys.csv --sort rsm", "--sort: unknown measure 'rsm'; did you mean 'rms'?"),
    ("sample keys.csv --rate 1 --method timed-c2 --ends restt",
     "--ends: timed-c2: unknown end rule 'restt'; did you mean 'rest'?"),
    ("sample keys.csv --rate 1 --method timed-c2 --set tensoin=1",
     "timed-c2: unknown parameter 'tensoin'; did you mean 'tension'?"),
    ("reproduce tan-tabel1", "unknown experiment 'tan-tabel1'; did you mean 'tan-table1'?"),
    # clocks
    ("sample keys.csv --fps 0", "--fps: found '0', wanted a number greater than 0, or a fraction such as 30000/1001"),
    ("sample keys.csv --rate 1 --epoch now",
     "--epoch: found 'now', wanted a time of ISO 8601 such as 2024-02-29T12:30:00Z"),
    ("sample keys.csv --rate 1 --from 2024-02-30", "--from: found '2024-02-30', wanted a time of ISO 8601 such as "
                                                   "2024-02-29T12:30:00.25Z"),
    ("sample keys.csv --rate 1 --from 12f", "--from: found the frame '12f', wanted the frames per second as well (--fps N)"),
    ("sample keys.csv --count 3 --include-end", "--include-end: found --count, which includes both ends already; wanted --rate"),
    ("sample keys.csv --times t.csv --include-end",
     "--include-end: found --times, whose file says which times to sample; wanted --rate"),
    ("inspect keys.csv --method slerp --tension 1",
     "slerp: unknown parameter 'tension': this method has no parameters"),
    ("completion tcsh", "completion: found 'tcsh', wanted bash|zsh|fish"),
)


class BadUsage(CommandTest):
    def test_every_case_is_refused_in_these_words(self):
        for arguments, message in CASES:
            with self.subTest(arguments):
                self.assert_fails(arguments, BAD_USAGE, message)

    def test_a_method_that_is_not_there_is_refused_with_those_that_are(self):
        known = ", ".join(method["name"] for method in json.loads(self.output_of("methods --json")))
        for arguments in ("sample keys.csv --rate 1 --method bogus", "inspect keys.csv --method slerp,bogus"):
            with self.subTest(arguments):
                self.assert_fails(arguments, BAD_USAGE, f"unknown method 'bogus', wanted one of {known}")

    def test_a_loop_by_a_method_without_loops_is_refused_with_those_that_have_them(self):
        closing = ", ".join(m["name"] for m in json.loads(self.output_of("methods --json")) if m["closes"])
        for method, options in (("auto", "--closed"), ("slerp", "--method slerp --period 4")):
            with self.subTest(method):
                self.assert_fails(f"sample keys.csv --rate 1 {options}", BAD_USAGE,
                                  f"{method}: this method has no closed curves, wanted one of {closing}")

    def test_the_command_alone_shows_how_to_begin(self):
        done = self.run_command("")
        self.assertEqual((done.returncode, done.stdout), (BAD_USAGE, ""))
        self.assertIn("  orispline sample keys.csv --rate 100 -o motion.csv ", done.stderr)
        self.assertIn("'orispline help'", done.stderr)
        self.assertLess(done.stderr.count("\n"), 10)
        self.assertLessEqual(max(map(len, done.stderr.splitlines())), 100)


class Environment(CommandTest):
    def test_an_instruction_set_that_is_not_there_is_refused(self):
        done = self.run_command("sample keys.csv --rate 1", env=os.environ | {"ORISPLINE_ISA": "v9"})
        self.assertEqual((done.returncode, done.stdout), (BAD_USAGE, ""))
        self.assertRegex(done.stderr, r"\Aorispline: ORISPLINE_ISA: found 'v9', wanted one of [a-z0-9, ]+\n\Z")

    def test_without_a_value_it_says_nothing(self):
        self.output_of("sample keys.csv --rate 1", env=os.environ | {"ORISPLINE_ISA": ""})

    def test_every_one_that_is_offered_makes_the_same_samples(self):
        offer = self.run_command("methods", env=os.environ | {"ORISPLINE_ISA": "?"}).stderr.splitlines()[0]
        plain = self.output_of("sample keys.csv --rate 100")
        for name in offer.split(" one of ")[1].split(", "):
            with self.subTest(name):
                forced = self.output_of("sample keys.csv --rate 100", env=os.environ | {"ORISPLINE_ISA": name})
                self.assertEqual(forced, plain)


if __name__ == "__main__":
    main()
