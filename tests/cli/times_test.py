#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Which times `orispline sample` takes, and what it says of those that can hardly be meant."""
import subprocess

from command import BAD_USAGE, COMMAND, KEYS, CommandTest, main, rows_of


class Times(CommandTest):
    def test_what_is_asked_for_outside_the_curve_is_warned_of(self):
        late = KEYS.replace("\n1,", "\n1700000001,").replace("\n0,", "\n1700000000,").replace("\n3,", "\n1700000003,")
        self.write("late.csv", late)
        begins = ("orispline: warning: --{} {} lies outside the curve, which begins at 1700000000 s; samples there hold "
                  "the first orientation; write +T for a time T seconds after the first key\n")
        ends = ("orispline: warning: --{} {} lies outside the curve, which ends at 1700000003 s; samples there hold the "
                "last orientation; write +T for a time T seconds after the first key\n")
        for options, warnings in (("--from 0 --to 3", begins.format("from", 0) + begins.format("to", 3)),
                                  ("--from 0", begins.format("from", 0)), ("--to 1700000004", ends.format("to", 1700000004)),
                                  ("--from 1700000004 --to 1700000005",
                                   ends.format("from", 1700000004) + ends.format("to", 1700000005)),
                                  ("--from +0 --to +3", ""), ("--from 1700000000 --to 1700000003", "")):
            for spacing in ("--count 4", "--rate 1e-6"):  # held, and in pieces
                with self.subTest(options=options, spacing=spacing):
                    done = self.run_command(f"sample late.csv {spacing} {options} --quiet")
                    self.assertEqual((done.returncode, done.stderr), (0, warnings))

    def test_times_since_the_first_key_are_those_of_the_file(self):
        self.write("late.csv", KEYS.replace("\n1,", "\n8,").replace("\n0,", "\n7,").replace("\n3,", "\n10,"))
        for spacing in ("--count 3", "--rate 4"):
            since, absolute = (self.output_of(f"sample late.csv {spacing} {ends} --quiet")
                               for ends in ("--from +0.5 --to +1.5", "--from 7.5 --to 8.5"))
            self.assertEqual(since, absolute)

    def test_more_samples_than_can_be_meant_want_a_yes(self):
        for options, number in (("--rate 1e9", "3e+09"), ("--count 1000000001", "1e+09"), ("--rate 1 --from=-2e9", "2e+09"),
                                ("--rate 1 --to 1e12", "1e+12")):
            done = self.run_command(f"sample keys.csv {options} -o out.csv")
            self.assertEqual((done.returncode, done.stderr.splitlines()[-1]), (
                BAD_USAGE, f"orispline: found a request for {number} samples, wanted 1e+09 at most: check the rate and the "
                           "unit of the times; 'orispline sample --yes' writes any number"))
            self.assertFalse((self.folder / "out.csv").exists())
        with subprocess.Popen([COMMAND, "sample", "keys.csv", "--rate", "1e9", "--yes", "--quiet"], cwd=self.folder,
                              stdout=subprocess.PIPE) as endless:
            self.assertTrue(endless.stdout.readline().startswith(b"t,qw"))
            endless.kill()

    def test_a_list_of_times_is_in_the_unit_of_its_size_as_keys_are(self):
        self.write("ms.csv", KEYS.replace("\n0,", "\n1700000000000,").replace("\n1,", "\n1700000001000,")
                   .replace("\n3,", "\n1700000003000,"))
        self.write("times.csv", "1700000000500\n1700000002000\n")
        listed = rows_of(self.output_of("sample ms.csv --times times.csv --derivatives 0"))
        self.assertEqual([row[0] for row in listed], [1700000000.5, 1700000002])
        self.assertEqual(len({tuple(row[1:]) for row in listed}), 2)
        for head in ("stamp_ms", "msec"):
            self.write("times.csv", f"{head}\n500\n")
            row = rows_of(self.output_of("sample keys.csv --times times.csv --derivatives 0"))[0]
            self.assertEqual(row[0], 0.5)


if __name__ == "__main__":
    main()
