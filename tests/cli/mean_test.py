#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""orispline mean: what it prints and writes, which rows it takes, and what it refuses."""
import json
import math

from command import BAD_DATA, BAD_USAGE, SUCCESS, CommandTest, main, table_of

# Turns of 1, 2 and 1.5 degrees both ways about the axes of a base pose, of either sign.
SHOTS = """t,qw,qx,qy,qz
0.0,0.07199462634203765,-0.17918840525745156,-0.061885319539664384,0.979223414969554
1.0,-0.06885639233433025,0.1804175934756339,0.07896569913670361,-0.9779942267513717
2.0,0.07164660588773555,-0.1968621892925602,-0.06918832305881269,0.9753589176523774
3.0,0.06918832305881265,-0.16270273083551742,-0.0716466058877356,0.9816351466791224
4.0,-0.0576120758176473,0.18071631776616376,0.06806851911035858,-0.9794841182577405
5.0,0.0832322387301739,-0.17887256469141072,-0.07277579543746271,0.9776403651829875
"""
BASE = (0.07042819102789424, -0.17980984597450927, -0.07042819102789428, 0.9786460847046291)
NAMES = ("qw", "qx", "qy", "qz")


def about_z(*degrees):
    return "".join(f"{math.cos(math.radians(a / 2))!r},0,0,{math.sin(math.radians(a / 2))!r}\n" for a in degrees)


class Mean(CommandTest):
    def found(self, arguments):
        return json.loads(self.output_of(f"mean {arguments} --json"))

    def expect_turn(self, found, degrees, delta=1e-15):
        self.assertAlmostEqual(found["qw"], math.cos(math.radians(degrees / 2)), delta=delta)
        self.assertAlmostEqual(found["qz"], math.sin(math.radians(degrees / 2)), delta=delta)

    def test_the_mean_and_the_median_of_shots_are_exactly_the_base_pose(self):
        self.write("shots.csv", SHOTS)
        for kind in ("mean", "median"):
            found = self.found(f"shots.csv --kind {kind}")
            for name, wanted in zip(NAMES, BASE, strict=True):
                self.assertAlmostEqual(found[name], wanted, delta=1e-15)
            self.assertTrue(found["certified"])
            self.assertLess(found["residual_rad"], 1e-15)
            self.assertAlmostEqual(found["largest_distance_rad"], math.radians(2), delta=1e-15)
            self.assertEqual((found["kind"], found["count"], found["others_within_rad"], found["warnings"]), (kind, 6, 0, []))

    def test_windows_have_their_times_in_full_however_late_they_are(self):
        self.write("late.csv", "t,qw,qx,qy,qz\n" + "".join(f"{1700000000 + i / 4},1,0,0,0\n" for i in range(8)))
        lines = self.output_of("mean late.csv --every 1s").splitlines()
        self.assertEqual([line.split()[:2] for line in lines[2:]], [["1700000000.5", "s"], ["1700000001.5", "s"]])

    def test_documents_have_the_times_that_files_have(self):
        self.write("late.csv", "t,qw,qx,qy,qz\n" + "".join(f"1700000000.123456789{i},1,0,0,0\n" for i in range(8)))
        self.output_of("mean late.csv --every 1s --quiet -o means.csv")
        found = self.found("late.csv --every 1s")["windows"]
        self.assertEqual([one["time_s"] for one in found], [table_of(self.read("means.csv"))[1].split(",")[0]])
        self.assertEqual(found[0]["time_s"], "1700000000.623456789")

    def test_rows_of_several_files_are_one_set(self):
        self.write("a.csv", "qw,qx,qy,qz\n" + about_z(0, 10))
        self.write("b.tum", "5 0 0 0 " + " ".join(about_z(50).strip().split(",")[1:] + about_z(50).split(",")[:1]) + "\n")
        self.write("whole.csv", "qw,qx,qy,qz\n" + about_z(0, 10, 50))
        found = json.loads(self.output_of("mean a.csv b.tum --no-positions --json"))
        self.assertEqual((found["inputs"], found["rows"]), (["a.csv", "b.tum"], 3))
        self.assertEqual(found["farthest"], {"file": "b.tum", "key": 0, "line": 1})
        self.expect_turn(found, 20)
        lines = self.output_of("mean a.csv b.tum --no-positions").splitlines()
        self.assertEqual(lines[0], "3 rows from 2 files")
        self.assertTrue(lines[4].endswith("(line 1 of b.tum)"), lines[4])
        self.output_of("mean a.csv b.tum --no-positions --quiet -o mean.csv")
        self.output_of("mean whole.csv --quiet -o wanted.csv")
        self.assertEqual(self.read("mean.csv"), self.read("wanted.csv"))
        told = self.run_command("mean a.csv b.tum --no-positions --json -o mean.csv")
        self.assertEqual(list(json.loads(told.stdout))[:2], ["inputs", "output"])

    def test_each_of_several_files_has_a_mean_in_a_folder(self):
        self.write("a.csv", "qw,qx,qy,qz\n" + about_z(0, 10))
        self.write("b.csv", "qw,qx,qy,qz\n" + about_z(50))
        each = json.loads(self.output_of("mean a.csv b.csv --output-folder means --json"))
        self.assertEqual([(one["input"], one["output"]) for one in each], [("a.csv", "means/a.csv"), ("b.csv", "means/b.csv")])
        self.expect_turn(each[0], 5)
        self.expect_turn(each[1], 50)
        self.assertEqual(len(table_of(self.read("means/a.csv"))), 2)

    def test_refuses_files_that_do_not_belong_together(self):
        self.write("a.csv", "qw,qx,qy,qz\n" + about_z(0, 10))
        self.write("heavy.csv", "qw,qx,qy,qz,weight\n" + about_z(0).strip() + ",2\n")
        self.write("poses.csv", "qw,qx,qy,qz,px,py,pz\n" + about_z(0).strip() + ",0,0,0\n")
        self.write("turned.csv", "qw,qx,qy,qz,weight\n" + about_z(5).strip() + ",-1\n")
        for arguments, code, words in (
                ("a.csv heavy.csv", BAD_DATA, "a.csv: found no weights, which heavy.csv has, wanted them in all or in none"),
                ("poses.csv a.csv", BAD_DATA, "a.csv: found no positions, which poses.csv has, wanted them in all or in none; "
                                              "--no-positions reads none"),
                ("heavy.csv turned.csv", BAD_DATA, "turned.csv:2: key 0: found the weight -1"),
                ("a.csv a.csv --every 1s", BAD_USAGE, "--every: found 2 inputs, each with a clock of its own, wanted one, or "
                                                      "--output-folder FOLDER for the means of each"),
                ("a.csv none.csv", 3, "none.csv: cannot open"),
                ("", BAD_USAGE, "INPUT is missing")):
            said = self.run_command(f"mean {arguments} -o out.csv")
            self.assertEqual(said.returncode, code, said.stderr)
            self.assertIn(words, said.stderr)
            self.assertFalse((self.folder / "out.csv").exists())

    def test_says_it_in_a_few_lines(self):
        self.write("shots.csv", SHOTS)
        lines = self.output_of("mean shots.csv").splitlines()
        self.assertEqual(lines[:2], ["6 rows from shots.csv", "orientation mean"])
        self.assertEqual(lines[3:6], ["  sigma          0.2582°, 0.5164°, 0.3873° along the axes of its body",
                                      "  distances      1.555° RMS, 2° at most (line 5)",
                                      "  only one       proved: no other orientation is as good; all are in a ball of 2°"])

    def test_rows_are_a_set_whose_times_do_not_count(self):
        self.write("set.csv", "qw,qx,qy,qz\n" + about_z(0, 10, 50))
        self.expect_turn(self.found("set.csv"), 20)
        self.write("times.csv", "t,qw,qx,qy,qz\n" + "".join("5," + line + "\n" for line in about_z(50, 0, 10).splitlines()))
        self.expect_turn(self.found("times.csv"), 20)
        self.write("plain.txt", about_z(0, 10, 50))
        self.expect_turn(self.found("plain.txt --input-format csv --order wxyz --kind median"), 10)
        self.expect_turn(json.loads(self.output_of("mean - --json", input="qw,qx,qy,qz\n1,0,0,0\n")), 0)

    def test_a_column_weighs_the_rows(self):
        rows = [f"{line},{weight}\n" for line, weight in zip(about_z(0, 40).splitlines(), (3, 1), strict=True)]
        self.write("weight.csv", "qw,qx,qy,qz,weight\n" + "".join(rows))
        self.write("confidence.csv", "qw,qx,qy,qz,confidence\n" + "".join(rows))
        found = self.found("weight.csv")
        self.expect_turn(found, 10)
        self.assertEqual((found["weight"], found["weighted"]), (4, True))
        self.expect_turn(self.found("confidence.csv"), 20)
        self.expect_turn(self.found("confidence.csv --columns weight=confidence"), 10)

    def test_positions_have_a_mean_and_a_median_too(self):
        rows = [f"{line},{p}\n" for line, p in zip(about_z(0, 10, 50).splitlines(), ("0,0,5", "0,0,5", "3,9,5"), strict=True)]
        self.write("poses.csv", "qw,qx,qy,qz,px,py,pz\n" + "".join(rows))
        found = self.found("poses.csv")
        self.assertEqual([round(found[name], 14) for name in ("px", "py", "pz")], [1, 3, 5])
        self.assertAlmostEqual(found["position_rms_distance_m"], math.sqrt(20))
        self.assertEqual(found["farthest_position"], {"key": 2, "line": 4})
        self.assertEqual([self.found("poses.csv --kind median")[name] for name in ("px", "py", "pz")], [0, 0, 5])

    def test_writes_the_mean_as_a_row_of_keys(self):
        self.write("set.csv", "qw,qx,qy,qz\n" + about_z(0, 10, 50))
        said = self.run_command("mean set.csv -o mean.csv")
        self.assertEqual((said.returncode, said.stdout), (SUCCESS, ""))
        self.assertTrue(said.stderr.endswith("mean written to mean.csv\n"), said.stderr)
        names, row = table_of(self.read("mean.csv"))
        self.assertEqual(names, "t,qw,qx,qy,qz")
        self.expect_turn(dict(zip(names.split(","), map(float, row.split(",")), strict=True)), 20)
        self.output_of("mean set.csv -o mean.tum --quiet")
        self.assertEqual(len(self.read("mean.tum").splitlines()[-1].split()), 8)

    def test_windows_have_a_mean_each(self):
        rows = [f"{t},{line}\n" for t, line in zip((10, 10.4, 12.1, 12.3), about_z(0, 20, 40, 50).splitlines(), strict=True)]
        self.write("motion.csv", "t,qw,qx,qy,qz\n" + "".join(rows))
        found = self.found("motion.csv --every 1s")
        self.assertEqual([one["time_s"] for one in found["windows"]], ["10.5", "12.5"])
        self.expect_turn(found["windows"][0], 10)
        self.expect_turn(found["windows"][1], 45)
        self.output_of("mean motion.csv --every 1s --quiet -o means.csv")
        self.assertEqual([line.split(",")[0] for line in table_of(self.read("means.csv"))[1:]], ["10.5", "12.5"])

    def test_bad_rows_hardly_move_the_median(self):
        self.write("bad.csv", "qw,qx,qy,qz\n" + about_z(0, 1, 2, 3, 4, 150, 160))
        self.expect_turn(self.found("bad.csv --kind median"), 3)
        self.assertGreater(self.found("bad.csv")["qz"], 0.35)

    def test_says_where_it_may_not_be_the_only_one(self):
        self.write("wide.csv", "qw,qx,qy,qz\n" + about_z(0, 119, -119))
        found = self.found("wide.csv")
        self.assertFalse(found["certified"])
        self.assertEqual([warning["code"] for warning in found["warnings"]], ["mean_not_certified"])
        self.write("two.csv", "qw,qx,qy,qz\n" + about_z(0, 50))
        found = self.found("two.csv --kind median")
        self.expect_turn(found, 25)
        self.assertEqual([warning["code"] for warning in found["warnings"]], ["median_of_a_range"])
        self.assertAlmostEqual(found["others_within_rad"], math.radians(25))

    def test_refuses_what_has_no_mean_in_one_line(self):
        self.write("two.csv", "qw,qx,qy,qz,w,n,z\n1,0,0,0,1,nan,0\n0,1,0,0,-1,1,0\n")
        self.write("none.csv", "qw,qx,qy,qz\n")
        for arguments, code, words in (
                ("two.csv", BAD_DATA, "two.csv: found orientations that cancel, such as two that are 180° apart"),
                ("two.csv --kind median", BAD_DATA, "several are their median alike"),
                ("two.csv --columns weight=w", BAD_DATA, "two.csv:3: key 1: found the weight -1, wanted 0 or a number above it"),
                ("two.csv --columns weight=n", BAD_DATA, "two.csv:2:6: key 0: found 'nan', wanted a finite number"),
                ("two.csv --columns weight=z", BAD_DATA, "found the weight 0 at every orientation, wanted one above 0 at least"),
                ("none.csv", BAD_DATA, "none.csv: empty: no keys"),
                ("two.csv --kind mode", BAD_USAGE, "--kind: found 'mode', wanted mean|median"),
                ("two.csv --every 0s", BAD_USAGE, "--every: found '0s'"),
                ("two.csv --every 1s", BAD_DATA, "no column t"),
                ("two.csv --quiet", BAD_USAGE, "--quiet: found no -o, wanted -o FILE for the mean")):
            said = self.run_command(f"mean {arguments} {'' if '--quiet' in arguments else '-o out.csv'}")
            self.assertEqual(said.returncode, code, said.stderr)
            self.assertEqual(said.stderr.count("\n"), 1, said.stderr)
            self.assertIn(words, said.stderr)
            self.assertFalse((self.folder / "out.csv").exists())


if __name__ == "__main__":
    main()
