# SPDX-License-Identifier: Apache-2.0
"""Commands that take several inputs: files, folders and lists, each with an output of its own."""
import json
import resource

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, KEYS, SUCCESS, CommandTest, main

BAD = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,nan,0,0,0\n"
NAN = "key 1: found 'nan', wanted a finite number (--drop-invalid drops such rows)"


def samples(count):
    """A turn at a constant rate, long enough for every command."""
    from math import cos, sin
    return "t,qw,qx,qy,qz\n" + "".join(f"{0.1 * k:.1f},{cos(0.02 * k)!r},{sin(0.02 * k)!r},0,0\n" for k in range(count))


class SeveralInputs(CommandTest):
    def setUp(self):
        super().setUp()
        for folder in ("in/deep", "in/.hidden"):
            (self.folder / folder).mkdir(parents=True)
        self.write("in/a.csv", samples(40))
        self.write("in/deep/b.csv", samples(60))
        self.write("in/.hidden/c.csv", BAD)
        self.write("in/.d.csv", BAD)

    def files_in(self, folder):
        there = self.folder / folder
        return sorted(str(path.relative_to(there)) for path in there.rglob("*") if path.is_file())

    def test_every_command_writes_what_it_writes_for_one(self):
        for command, options, extension in (("sample", "--rate 7", "csv"), ("smooth", "--loss l2", "csv"),
                                            ("smooth", "--rate 9", "csv"), ("reduce", "--tolerance 1deg", "csv"),
                                            ("retime", "--max-rate 5deg/s", "csv"), ("sample", "--count 5 --output-format tum", "tum")):
            with self.subTest(command + options):
                done = self.run_command(f"{command} in keys.csv {options} --output-folder out-{command} --threads 3")
                self.assertEqual(done.returncode, SUCCESS, done.stderr)
                for source, output in (("in/a.csv", "a"), ("in/deep/b.csv", "deep/b"), ("keys.csv", "keys")):
                    self.output_of(f"{command} {source} {options} -o one.{extension}")
                    self.assertEqual(self.read(f"out-{command}/{output}.{extension}"), self.read(f"one.{extension}"))
                    self.assertIn(f"out-{command}/{output}.{extension}: ", done.stderr)
                for path in (self.folder / f"out-{command}").rglob("*.csv"):
                    path.unlink()

    def test_compare_writes_a_table_for_each(self):
        options = "--methods auto,slerp --threads 1"
        self.output_of(f"compare in {options} --output-folder csv --csv")
        self.output_of(f"compare in {options} --output-folder json --json")
        self.assertEqual((self.files_in("csv"), self.files_in("json")), (["a.csv", "deep/b.csv"], ["a.json", "deep/b.json"]))
        alone = self.output_of(f"compare in/deep/b.csv {options} --csv")
        measured = lambda table: [row.split(",")[:12] for row in table.splitlines()]
        self.assertEqual(measured(self.read("csv/deep/b.csv")), measured(alone))
        methods = lambda document: [row["method"] for row in json.loads(document)]
        self.assertEqual(methods(self.read("json/a.json")), methods(self.output_of(f"compare in/a.csv {options} --json")))
        done = self.run_command(f"compare in {options} --output-folder lines")
        self.assertRegex(done.stderr.splitlines()[0], r"^lines/a\.csv: best by rms: (auto|slerp) at every 8th \(\S+ deg\)$")

    def test_a_bad_input_is_named_and_does_not_stop_the_others(self):
        self.write("bad.csv", BAD)
        done = self.run_command("sample in/a.csv bad.csv keys.csv --rate 2 --output-folder out")
        self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
        self.assertEqual(done.stderr.splitlines(),
                         ["out/a.csv: 8 samples with auto from 40 keys", f"orispline: bad.csv:3:2: {NAN}",
                          "out/keys.csv: 7 samples with auto from 3 keys",
                          "orispline: 1 of 3 inputs failed; 2 files were written and are complete"])
        self.assertEqual(self.files_in("out"), ["a.csv", "keys.csv"])
        done = self.run_command("sample bad.csv missing.csv keys.csv --rate 2 --output-folder out --quiet")
        self.assertEqual(done.returncode, BAD_ACCESS)  # the gravest
        self.assertIn("missing.csv: cannot open: No such file or directory", done.stderr)

    def test_the_summary_of_all_is_one_array_with_what_failed(self):
        self.write("bad.csv", BAD)
        done = self.run_command("sample keys.csv bad.csv in/a.csv --rate 2 --output-folder out --json")
        self.assertEqual(done.returncode, BAD_DATA)
        first, failed, last = json.loads(done.stdout)
        self.assertEqual(failed, {"input": "bad.csv", "error": f"bad.csv:3:2: {NAN}"})
        alone = json.loads(self.output_of("sample keys.csv --rate 2 -o one.csv --json"))
        self.assertEqual(first | {"output": "one.csv"}, alone)
        self.assertEqual(last["output"], "out/a.csv")

    def test_all_or_none_writes_nothing_unless_all_succeed(self):
        self.write("bad.csv", BAD)
        (self.folder / "out").mkdir()
        self.write("out/a.csv", "old")
        for command in ("sample --rate 2", "smooth", "reduce --tolerance 1deg", "retime --max-rate 5deg/s", "compare"):
            name, *options = command.split()
            done = self.run_command([name, "in", "bad.csv", *options, "--output-folder", "out", "--all-or-none"])
            self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""), command)
            self.assertEqual(done.stderr.splitlines()[-2:], [f"orispline: bad.csv:3:2: {NAN}",
                                                             "orispline: 1 of 3 inputs failed; nothing was written"])
            self.assertEqual((self.files_in("out"), self.read("out/a.csv")), (["a.csv"], "old"))
        self.output_of("sample in --rate 2 --output-folder out --all-or-none")
        self.assertEqual(self.files_in("out"), ["a.csv", "deep/b.csv"])
        self.assertNotEqual(self.read("out/a.csv"), "old")

    def test_lists_of_paths(self):
        self.write("list.txt", "in/a.csv\r\n\nin/deep\n")
        self.output_of("sample --inputs list.txt --rate 2 --output-folder out")
        self.assertEqual(self.files_in("out"), ["a.csv", "b.csv"])
        self.output_of("sample keys.csv --inputs - --rate 2 --output-folder piped", input="in/a.csv\n")
        self.assertEqual(self.files_in("piped"), ["a.csv", "keys.csv"])
        self.write("one.txt", "keys.csv\n")
        self.assertEqual(self.output_of("sample --inputs one.txt --rate 2"), self.output_of("sample keys.csv --rate 2"))
        self.write("empty.txt", "\n")
        self.assert_fails("sample --inputs empty.txt --rate 2 --output-folder out", BAD_DATA,
                          "empty.txt: found no line, wanted the path of a file in each")
        self.assert_fails("sample --inputs none.txt --rate 2 --output-folder out", BAD_ACCESS,
                          "none.txt: cannot open: No such file or directory")

    def test_folders(self):
        (self.folder / "empty").mkdir()
        self.write("empty/notes.md", "")
        self.assert_fails("sample empty --rate 2 --output-folder out", BAD_DATA,
                          "empty: found no file in this folder whose name ends as CSV, TUM, EuRoC, BVH or glTF files do")
        self.write("in/notes.md", "")
        done = self.run_command("sample in --rate 2 --output-folder in/out")
        self.assertIn("orispline: warning: in: 1 file of other kinds left out, such as notes.md; ", done.stderr)
        self.assertEqual(self.files_in("in/out"), ["a.csv", "deep/b.csv"])
        self.output_of("sample in --rate 2 --output-folder in/out")  # whose files are no inputs
        self.assertEqual(self.files_in("in/out"), ["a.csv", "deep/b.csv"])

    def test_refused(self):
        for arguments, message in (
                ("sample in --rate 2", "INPUT: found the folder 'in', wanted --output-folder FOLDER for the samples of its files"),
                ("compare in/a.csv keys.csv", 
                 "found 2 inputs, 'in/a.csv' and 'keys.csv'; wanted one, or --output-folder FOLDER for their tables"),
                ("sample in in/a.csv --rate 2 --output-folder out", "--output-folder: found in/a.csv twice, wanted each input once"),
                ("sample in --rate fast --output-folder out", "--rate: found 'fast', wanted a number of samples per second greater than 0"),
                ("smooth in --output-folder out -o keys.csv",
                 "found -o and --output-folder, wanted one of them: a file for the keys, or their folder"),
                ("smooth in --output-folder out --report page.html",
                 "--report: found 2 inputs, wanted one: a page shows one recording"),
                ("sample in --times - --output-folder out",
                 "--output-folder: found '-' for --times or --truth, wanted a file, which is read again for each input"),
                ("compare in --reference - --output-folder out",
                 "--output-folder: found '-' for --reference, wanted a file, which is read again for each input"),
                ("retime in --max-rate 9deg/s --output-folder out --output-format npy",
                 "--output-folder: a NumPy file rounds times, and the limits may not hold with rounded times; wanted CSV or TUM"),
                ("sample --inputs", "--inputs: found nothing after it, wanted FILE")):
            self.assert_fails(arguments, BAD_USAGE, message)
        self.assertFalse((self.folder / "out").exists())
        few = lambda: resource.setrlimit(resource.RLIMIT_NOFILE, (65, 65))
        self.assert_fails("sample in --rate 2 --output-folder out --all-or-none", BAD_USAGE,
                          "--all-or-none: found 2 inputs, wanted 1 at most, for all outputs stay open until the last one "
                          "is complete; 'ulimit -n' raises the limit of open files", preexec_fn=few)

    def test_warnings_alike_are_counted(self):
        for name in "abc":
            self.write(f"{name}.csv", samples(30).replace("\n1.", "\n1.0000"))
        done = self.run_command("sample a.csv b.csv c.csv --rate 2 --to 9 --output-folder out --quiet")
        self.assertEqual(done.returncode, SUCCESS)
        warnings = [line for line in done.stderr.splitlines() if "--to 9" in line]
        self.assertEqual(len(warnings), 2, done.stderr)
        self.assertTrue(warnings[0].startswith("orispline: warning: a.csv: "), warnings)
        self.assertTrue(warnings[1].startswith("orispline: warning: 2 more inputs: "), warnings)
        self.assertEqual(warnings[0].split(": ", 3)[3], warnings[1].split(": ", 3)[3])


if __name__ == "__main__":
    main()
