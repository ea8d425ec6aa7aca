#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files that are refused: exit code 1 for their content, 3 where they cannot be read or written."""
import subprocess

from command import BAD_ACCESS, BAD_DATA, COMMAND, CommandTest, main

HEADER = "t,qw,qx,qy,qz\n"

CONTENT = (  # text of bad.csv, options, message
    ("", "", "bad.csv: empty: no keys"),
    (HEADER, "", "bad.csv: empty: no keys"),
    ("0,1,0,0,0\n1,1,0,0,0\n", "", "bad.csv:1: no header, wanted a first line such as t,qw,qx,qy,qz or the order of "
                                   "the columns (--order wxyz|xyzw)"),
    (HEADER + "0,1,0,0,0\n0,1,0,0,0\n", "", "bad.csv:3: key 1: duplicate time 0, as in line 2, wanted increasing times "
                                            "(--drop-duplicates keeps the first)"),
    (HEADER + "0,1,0,0,0\n1,2,0,0,0\n", "", "bad.csv:3: key 1: the quaternion has norm 2, wanted 1 within 0.02 (--normalise takes any norm but 0)"),
    ("# note\n" + HEADER + "0,1,0,0,0\n1,0,0,0,0\n", "",
     "bad.csv:4: key 1: the quaternion is zero, wanted a rotation (--drop-invalid drops such rows)"),
    (HEADER + "0,1,0,0,0\n1,1,0,0,0\n", "--method timed-c2 --ends quadratic",
     "bad.csv: timed-c2: ends 'quadratic' need 3 keys, found 2"),
    ("t,qw,qx,qy,qz,tension\n0,1,0,0,0,0.5\n1,1,0,0,0,101\n", "--method timed-c2",
     "bad.csv:3: key 1: timed-c2: tension is 101, wanted -100 to 100"),
)


class BadContent(CommandTest):
    def test_every_file_is_refused_in_these_words(self):
        for text, options, message in CONTENT:
            with self.subTest(message):
                self.write("bad.csv", text)
                self.assert_fails(f"sample bad.csv --rate 1 {options}", BAD_DATA, message)

    def test_a_clamped_end_at_a_tension_column_of_zero_is_the_fault_of_the_file(self):
        self.write("bad.csv", "t,qw,qx,qy,qz,tension\n0,1,0,0,0,0\n1,1,0,0,0,1\n")
        self.assert_fails("sample bad.csv --rate 1 --method timed-c2 --start-rate=0,0,1", BAD_DATA,
                          "bad.csv:2: key 0: a clamped end needs a non-zero tension at that key, found 0")

    def test_rates_matter_only_to_methods_that_take_them(self):
        self.write("rates.csv", "t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,nan,0,0\n1,1,0,0,0,0,0,0\n")
        self.output_of("sample rates.csv --method timed-c2 --count 2")
        self.assert_fails("sample rates.csv --method hermite-cumulative --count 2", BAD_DATA,
                          "rates.csv:2:6: key 0: found 'nan', wanted a finite number, or none in all three cells of the rate to leave "
                          "it free (--drop-invalid drops such rows)")

    def test_a_stray_time_is_the_fault_of_the_times_file(self):
        self.write("times.csv", "t\n1\n3.5\n")
        self.assert_fails("sample keys.csv --times times.csv --extrapolate error", BAD_DATA,
                          "times.csv:3: time 3.5 is outside the curve, wanted 0 to 3")

    def test_standard_input_is_named_as_it_was_given(self):
        self.assert_fails("inspect -", BAD_DATA, "-: empty: no keys", input="")

    def test_inspect_refuses_what_no_repair_can_mend(self):
        self.write("bad.csv", HEADER + "0,0,0,0,0\n")
        self.assert_fails("inspect bad.csv", BAD_DATA, "bad.csv: empty: no keys (all 1 rows were dropped as invalid)")
        self.write("bad.csv", HEADER + "0,1,0,0,0\n1,0,0,0,0\n")
        self.assertIn("defect        bad.csv:3: key 1: the quaternion is zero, wanted a rotation (--drop-invalid drops such rows)",
                      self.output_of("inspect bad.csv"))


class BadAccess(CommandTest):
    def test_a_missing_input(self):
        for command in ("sample none.csv --rate 1", "inspect none.csv", "sample keys.csv --times none.csv",
                        "sample keys.csv --rate 1 --truth none.csv -o out.csv"):
            with self.subTest(command):
                self.assert_fails(command, BAD_ACCESS, "none.csv: cannot open: No such file or directory")

    def test_a_folder_for_an_input(self):
        self.assert_fails("inspect .", BAD_ACCESS, ".: cannot read: Is a directory")

    def test_an_output_in_a_folder_that_does_not_exist(self):
        self.assert_fails("sample keys.csv --rate 1 -o none/out.csv", BAD_ACCESS,
                          "none/out.csv: cannot write: No such file or directory")

    def test_a_folder_for_an_output(self):
        self.assert_fails("sample keys.csv --rate 1 -o .", BAD_ACCESS, ".: cannot write: Is a directory")

    def test_a_standard_output_that_is_full(self):
        for words in ("methods", "methods slerp", "tasks", "completion bash", "reproduce", "--help", "--version", "help", "help sample",
                      "sample --help", "inspect keys.csv", "convert keys.csv", "sample keys.csv --rate 2 -o out.csv --json"):
            with self.subTest(words), open("/dev/full", "w", encoding="utf-8") as full:
                done = subprocess.run([COMMAND, *words.split()], cwd=self.folder, stdout=full, stderr=subprocess.PIPE, text=True, check=False)
                self.assertEqual((done.returncode, done.stderr),
                                 (BAD_ACCESS, "orispline: -: cannot write: No space left on device\n"))


if __name__ == "__main__":
    main()
