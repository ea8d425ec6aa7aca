# SPDX-License-Identifier: Apache-2.0
"""What new users type first: nothing goes wrong without a word."""
import json
import math
import re

from command import BAD_DATA, BAD_USAGE, SUCCESS, CommandTest, main


def turning(count, times, columns="t,qw,qx,qy,qz", rest=lambda k: ""):
    """A turn about z at 1 rad/s."""
    rows = [f"{times(k)},{math.cos(k / 20)!r},0,0,{math.sin(k / 20)!r}{rest(k)}" for k in range(count)]
    return "\n".join([columns, *rows]) + "\n"


class FirstHour(CommandTest):
    def warning_of(self, arguments):
        done = self.run_command(arguments)
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        return [line for line in done.stderr.splitlines() if line.startswith("orispline: warning: ")]

    def test_a_time_column_by_another_name_has_its_unit_by_size(self):
        for name, start, step in (("%time", 1700000000000000000, 10**8), ("header.stamp", 1700000000000000, 10**5),
                                  ("clock", 1700000000000, 100)):
            self.write("ros.csv", turning(20, lambda k: start + k * step, f"{name},qw,qx,qy,qz"))
            columns = f"--columns t={name}"
            done = self.run_command(f"inspect ros.csv {columns} --json")
            self.assertAlmostEqual(json.loads(done.stdout)["span_s"], 1.9, delta=1e-6)
            self.assertIn("the times are taken as", done.stderr)
            self.assertIn("--time-scale if they are not", done.stderr)
            slow = self.output_of(f"retime ros.csv {columns} --max-rate 0.5rad/s -o slow.csv --json")
            self.assertAlmostEqual(json.loads(slow)["time_scale"], 2.0, delta=1e-3)
            stated = self.run_command(f"inspect ros.csv {columns} --time-scale 2 --json")
            self.assertEqual(json.loads(stated.stdout)["span_s"], 2 * 19 * step)
        self.write("us.csv", turning(20, lambda k: 1000 * k, "clock_us,qw,qx,qy,qz"))
        self.assertAlmostEqual(json.loads(self.output_of("inspect us.csv --columns t=clock_us --json"))["span_s"], 0.019)

    def test_contradicting_rates_are_told_in_pieces_too(self):
        self.write("rates.csv", turning(60, lambda k: k / 10, "t,qw,qx,qy,qz,wx,wy,wz", lambda k: ",0,0,57.3"))
        for times in ("--rate 20", "--count 20"):
            warning, = self.warning_of(f"sample rates.csv --method hermite-c1 {times} -o out.csv")
            self.assertIn("the rates of the keys contradict their orientations", warning)

    def test_rests_that_a_method_moves_in_are_told(self):
        turn = "0.9238795325112867,0,0,0.3826834323650898"
        self.write("robot.csv", f"t,qw,qx,qy,qz\n0,1,0,0,0\n1,{turn}\n2,{turn}\n3,0.7071067811865476,0,0,0.7071067811865476\n")
        for times in ("--rate 20", "--count 20"):
            self.assertEqual(self.warning_of(f"sample robot.csv {times} -o out.csv"),
                             ["orispline: warning: robot.csv:3: key 1: auto moves in 1 rest between equal keys; take the "
                              "method auto:hold=1, which stands still there"])
            for method in ("auto:hold=1", "slerp"):
                self.assertEqual(self.warning_of(f"sample robot.csv --method {method} {times} -o out.csv"), [])

    def test_a_reference_without_samples_between_keys_is_told(self):
        self.write("truth.csv", turning(40, lambda k: k / 10))
        self.write("few.csv", turning(10, lambda k: k / 10))
        warning, = self.warning_of("compare truth.csv --reference few.csv --methods auto")
        self.assertIn("few.csv: all samples that are compared are at the times of keys", warning)
        self.assertEqual(self.warning_of("compare few.csv --keep-every 3 --methods auto"), [])
        self.output_of("convert few.csv -o keys.csv")
        self.write("denser.csv", turning(80, lambda k: k / 80))
        self.assertEqual(self.warning_of("compare keys.csv --reference denser.csv --methods auto"), [])

    def test_an_option_is_not_the_value_of_the_one_before(self):
        for arguments, message in (
                ("retime keys.csv --max-rate -o x.csv", "--max-rate: found the option -o after it, wanted RATE"),
                ("sample keys.csv --rate -o x.csv", "--rate: found the option -o after it, wanted HZ"),
                ("reduce keys.csv --tolerance -o x.csv", "--tolerance: found the option -o after it, wanted ANGLE"),
                ("compare keys.csv --methods auto --report --csv", "--report: found the option --csv after it, wanted FILE"),
                ("sample keys.csv --rate 2 -o --quiet", "-o: found the option --quiet after it, wanted FILE"),
                ("sample keys.csv 60 120 9 --rate 2",
                 "found 4 inputs, 'keys.csv', '60', '120', …; wanted one, or --output-folder FOLDER for their samples"),
                ("retime keys.csv --max-acc 1", "retime: unknown option '--max-acc'; did you mean '--max-acceleration'?")):
            self.assert_fails(arguments, BAD_USAGE, message)
        self.assertEqual([path.name for path in self.folder.iterdir()], ["keys.csv"])
        self.output_of("sample keys.csv --rate 2 --from -1 --to +3 -o out.csv")  # a number is no option

    def test_files_that_are_read_are_not_written_over(self):
        (self.folder / "in").mkdir()
        self.write("in/keys.csv", "keys.csv\n")
        self.assert_fails("sample --inputs in/keys.csv --rate 2 --output-folder in", BAD_USAGE,
                          "--output-folder: found in, wanted a folder without the inputs and their list")
        with open(self.folder / "keys.csv", encoding="utf-8") as file:
            done = self.run_command("sample - --rate 2 -o keys.csv", stdin=file)
        self.assertEqual((done.returncode, done.stderr), (
            BAD_USAGE, "orispline: -o: found 'keys.csv', wanted another file than INPUT, which would be lost\n"))
        self.assertEqual(self.read("in/keys.csv"), "keys.csv\n")

    def test_numbers_may_have_their_unit(self):
        self.write("noisy.csv", turning(60, lambda k: k / 10))
        for command, plain, with_unit in (("sample keys.csv", "--rate 20 --from 1 --to +2", "--rate 20Hz --from 1s --to +2s"),
                                          ("smooth noisy.csv --loss l2", "--cutoff 2 --gap 0.5", "--cutoff 2Hz --gap 0.5s"),
                                          ("smooth noisy.csv --loss l2", "--smoothing-time 0.1", "--smoothing-time '0.1 s'"),
                                          ("reduce noisy.csv --method auto", "--tolerance 1deg", "--tolerance 1°")):
            words = [word.strip("'") for word in with_unit.replace("'0.1 s'", "0.1s").split()]
            self.output_of([*command.split(), *plain.split(), "-o", "plain.csv"])
            self.output_of([*command.split(), *words, "-o", "unit.csv"])
            self.assertEqual(self.read("unit.csv"), self.read("plain.csv"))
        self.assert_fails("sample keys.csv --rate 100kHz", BAD_USAGE,
                          "--rate: found '100kHz', wanted a number of samples per second greater than 0")

    def test_files_of_other_kinds_are_named(self):
        for name, text, kind in (("v.aem", "CCSDS_AEM_VERS = 1.0\nCREATION_DATE = 2024\n", "an attitude ephemeris (AEM) of CCSDS, which is not read; "),
                                 ("v.csv", "Trajectories\n250\n,,wand:wand,\nFrame,Sub Frame,RX\n", "an export of Vicon, whose rows stand below several "),
                                 ("v.ori", "Type OrientationsGalactic\nOG 1 0 0 90 0\n", "a file of orientations (.ori) of MEGAlib, which holds "),
                                 ("walk.txt", "HIERARCHY\nROOT Hips\n{\n", "a BVH file, which is not read as rows; it is read with --input-format bvh, or without that option under a name"),
                                 ("walk.json", '{\n  "asset": {}\n}\n', "a JSON file, which is not read as rows; "),
                                 ("ck.xc", "DAFETF NAIF DAF ENCODED TRANSFER FILE\n'DAF/CK'\n", "a transfer file of SPICE, which is not read; "),
                                 ("log.npz", "PK\x03\x04\x14\x00\x00\x00", "an archive, as .npz is, which is not read; save one array of rows as .npy, or in Python give ")):
            self.write(name, text)
            done = self.run_command(f"sample {name} --rate 2")
            self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
            self.assertTrue(done.stderr.startswith(f"orispline: {name}: found {kind}"), done.stderr)

    def test_the_cure_that_is_named_for_an_attitude_ephemeris_cures_it(self):
        rows = "".join(f"2026-01-01T00:00:0{k}.000  0.0  {k / 10}   0.0 {(1 - k * k / 100) ** 0.5}\n" for k in range(3))
        self.write("v.aem", f"CCSDS_AEM_VERS = 1.0\nMETA_START\nQUATERNION_TYPE = LAST\nMETA_STOP\n\nDATA_START\n{rows}DATA_STOP\n")
        header = re.search(r"below a header with blanks .* '(.*)'$", self.run_command("inspect v.aem").stderr)[1]
        self.write("rows.csv", f"{header}\n{rows}")
        self.assertIn("keys          3, 1767225600 to 1767225602 s", self.output_of("inspect rows.csv"))

    def test_smooth_writes_every_format(self):
        self.write("noisy.csv", turning(60, lambda k: k / 10))
        self.output_of("smooth noisy.csv --loss l2 --output-format tum -o keys.txt")
        self.assertEqual(len(self.read("keys.txt").splitlines()[-1].split()), 8)
        self.output_of("smooth noisy.csv --loss l2 --output-orientation euler -o euler.csv")
        self.assertIn("roll_deg,pitch_deg,yaw_deg", self.read("euler.csv"))

    def test_the_duration_that_is_asked_for_is_enough(self):
        done = self.run_command("retime keys.csv --max-rate 20deg/s --duration 1s -o out.csv")
        self.assertEqual(done.returncode, BAD_USAGE)
        least = done.stderr.split("wanted some ")[1].split(" s ")[0]
        self.output_of(f"retime keys.csv --max-rate 20deg/s --duration {least}s -o out.csv")


if __name__ == "__main__":
    main()
