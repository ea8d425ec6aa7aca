#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files as people have them, and what every command says of them."""
from command import CommandTest, main, rows_of

MICROSECONDS = ("timestamp,x,y,z,qx,qy,qz,qw\n1700000000000000,1,2,3,0,0,0,1\n1700000000500000,1,2,3,0,0,0.6,0.8\n"
                "1700000001000000,1,2,3,0,0,0.8,0.6\n")
TAKEN = ("orispline: warning: clock.csv: the times are taken as microseconds, for the first one is 1700000000000000; state "
         "--time-scale if they are not\n")
COMMANDS = ("sample clock.csv --rate 2", "sample clock.csv --count 2", "convert clock.csv", "plot clock.csv",
            "tune clock.csv --method timed-c2", "retime clock.csv --max-rate 1deg/s", "smooth clock.csv --smoothing-time 1",
            "reduce clock.csv --tolerance 1deg", "inspect clock.csv", "compare clock.csv --keep-every 2 --methods slerp")


class Clocks(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("clock.csv", MICROSECONDS)

    def test_every_command_says_which_unit_it_takes(self):
        for command in COMMANDS:
            with self.subTest(command=command):
                done = self.run_command(command)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(done.stderr.count(TAKEN), 1, done.stderr)

    def test_other_files_are_read_likewise(self):
        self.output_of("convert clock.csv -o keys.csv --quiet")
        for command in ("sample keys.csv --rate 2 --truth clock.csv", "compare keys.csv --reference clock.csv --methods slerp",
                        "tune keys.csv --method timed-c2 --objective fit --reference clock.csv"):
            done = self.run_command(command)
            self.assertEqual((done.returncode, done.stderr.count(TAKEN)), (0, 1), done.stderr)

    def test_nothing_is_said_where_the_unit_is_stated(self):
        rows = MICROSECONDS.split("\n", 1)[1]
        for head, options in (("timestamp (us)", ""), ("stamp_us", ""), ("t", "--time-scale 1e-6")):
            self.write("clock.csv", f"{head},x,y,z,qx,qy,qz,qw\n{rows}")
            done = self.run_command(f"convert clock.csv {options} --quiet")
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual([row[0] for row in rows_of(done.stdout)], [1700000000, 1700000000.5, 1700000001])
            self.assertEqual(rows_of(done.stdout)[0][5:], [1, 2, 3])


if __name__ == "__main__":
    main()
