#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The papers' experiments: the numbers that the papers print come out, and the pictures are whole."""
import json
import math
import os
import pathlib
import re
import unittest
import xml.etree.ElementTree as xml

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, CommandTest, main

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
PARTS = ["000-figure1", "000-figure2", "000-figure3", "000-table1", "001-example1", "001-example2", "002-identities",
         "002-example", "003-table1", "003-figure7"]
TAKING_KEYS = ["000-figure3", "000-table1", "003-figure7"]
AUTHORS = {"000": "tan", "001": "he", "002": "eberly", "003": "sextic"}


class Reproduced(CommandTest):
    def tables_of(self, experiment):
        """The tables of one experiment; a row is a dictionary by column."""
        [report] = json.loads(self.output_of(f"reproduce {experiment} --json"))
        for table in report["tables"]:
            table["rows"] = [dict(zip(table["columns"], row)) for row in table["rows"]]
        return report["tables"]

    def rows_of(self, experiment, table=0):
        return self.tables_of(experiment)[table]["rows"]


class Quintic(Reproduced):
    """Tan et al. 2018."""

    def test_the_blending_functions_sum_to_one_and_interpolate(self):
        for table in self.tables_of("000-figure1"):
            for row in table["rows"]:
                self.assertAlmostEqual(row["sum"], 1, delta=1e-14)
            ends = [[table["rows"][k][name] for name in ("C0", "C1", "C2", "C3")] for k in (0, -1)]
            self.assertEqual(ends, [[0, 1, 0, 0], [0, 0, 1, 0]])

    def test_a_blending_function_has_the_value_of_its_formula(self):
        # (3.2) at t = 1/4 with the tension 0.35: C0 = -0.07 B1 - 0.1225 B2, C3 = -0.1225 B3 - 0.07 B4.
        b1, b2, b3, b4 = 5 * 3**4 / 4**5, 10 * 3**3 / 4**5, 10 * 3**2 / 4**5, 5 * 3 / 4**5
        row = self.rows_of("000-figure1")[1]
        self.assertAlmostEqual(row["C0"], -0.07 * b1 - 0.1225 * b2, delta=1e-15)
        self.assertAlmostEqual(row["C3"], -0.1225 * b3 - 0.07 * b4, delta=1e-15)

    def test_one_tension_touches_two_segments(self):
        base, *changed = self.rows_of("000-figure2")
        self.assertEqual([base[f"segment {i}"] for i in (1, 2, 3, 4)], [0] * 4)
        for row in changed:
            self.assertEqual([row["segment 1"], row["segment 4"]], [0, 0])
            self.assertGreater(min(row["segment 2"], row["segment 3"]), 1)
            tension = float(row["tensions"].split(",")[2])
            self.assertAlmostEqual(row["|ω| at key 3 [rad/s]"], abs(tension) / 0.35 * base["|ω| at key 3 [rad/s]"],
                                   delta=1e-12)

    def test_tension_zero_stops_at_every_key(self):
        rows = {row["curve"]: row for row in self.rows_of("000-figure3")}
        self.assertEqual(len(rows), 9)
        self.assertLess(rows["α = 0"]["|ω| at key 3 [rad/s]"], 1e-14)
        self.assertEqual(rows["α = 0.35"]["continuity"], "C2")

    def test_table_1_holds_every_scheme_with_both_numbers_of_frames(self):
        rows = self.rows_of("000-table1")
        self.assertEqual([(row["method"], row["frames"]) for row in rows],
                         [(name, frames) for name in ("bspline-through", "nu", "atbi", "quintic") for frames in (401, 17)])
        for row in rows:
            self.assertLess(row["error [rad]"], 1e-11)  # the paper's schemes stop at 1e-6


class Beta(Reproduced):
    """He et al. 2022."""

    def test_the_seven_control_points_come_out_as_printed(self):
        rows = self.rows_of("001-example1")
        self.assertEqual(len(rows), 7)
        for row in rows:
            self.assertLess(row["largest difference"], 0.5e-4)
            self.assertEqual(row["printed"], "({:.4f}, {:.4f}, {:.4f}, {:.4f})".format(*(row[f"q{c}"] for c in "wxyz")))
        self.assertEqual(rows[0]["printed"], "(-0.3796, 0.4589, 0.1106, 0.7956)")
        self.assertEqual(rows[6]["printed"], "(-0.3509, -0.7065, -0.5548, -0.2642)")

    def test_the_curves_are_g1_and_not_g2(self):
        for experiment, table, residuals in (("001-example1", 1, (0.0664, 0.0469)), ("001-example2", 0, (1.28, 0.0031))):
            rows = self.rows_of(experiment, table)
            self.assertEqual([row["signs"] for row in rows], ["as given", "shortest"])
            for row, residual in zip(rows, residuals):
                self.assertLess(row["G1"], 1e-14)
                self.assertAlmostEqual(row["G2"], residual, delta=0.006 * residual)
                self.assertAlmostEqual(row["times 6/gamma"], row["G2"], delta=1e-12)
                self.assertGreater(row["G2 with it"], 1e-3)

    def test_example_1_violates_the_condition_it_is_said_to_fulfil(self):
        row = self.rows_of("001-example1", 1)[0]
        self.assertAlmostEqual(row["(10) printed"], 1.01, delta=0.005)
        self.assertAlmostEqual(row["(10) corrected"], 0.00983, delta=0.5e-5)
        self.assertAlmostEqual(row["best delta"], 0.4685, delta=0.5e-4)
        self.assertAlmostEqual(row["G2 with it"], 0.0536, delta=0.5e-4)

    def test_a_larger_beta2_draws_the_joint_to_its_point(self):
        rows = self.rows_of("001-example2", 1)
        self.assertEqual([row["beta2"] for row in rows], [0.5, 2, 4] * 2)
        for variant in (rows[:3], rows[3:]):
            distances = [row["first joint to point 1 [degrees]"] for row in variant]
            self.assertEqual(distances, sorted(distances, reverse=True))
            self.assertLess(max(row["at the last joint"] for row in variant), 1e-12)


class Eberly(Reproduced):
    def test_every_identity_holds(self):
        rows = self.rows_of("002-identities")
        self.assertEqual(len(rows), 22)
        for row in rows:
            self.assertLess(row["largest error"], 1e-13, row["statement"])

    def test_the_misprints_are_wrong_and_their_corrections_right(self):
        rows = self.rows_of("002-identities", 1)
        self.assertEqual(len(rows), 3)
        for row in rows:
            self.assertGreater(row["error"], 0.01, row["printed"])
            self.assertLess(row["its error"], 1e-13, row["right"])

    def test_the_angular_cubic_has_the_stated_ends(self):
        rows = {row["quantity"]: row for row in self.rows_of("002-example")}
        for quantity, value in (("phi(0)", 0.2), ("phi(1)", 1), ("phi'(0)", 0.65), ("phi'(1)", 0.25)):
            for column in ("its value", "phi", "squad"):
                self.assertAlmostEqual(rows[quantity][column], value, delta=1e-14)

    def test_squad_in_the_plane_is_the_cubic_of_catmull_and_rom(self):
        for row in self.rows_of("002-example", 1):
            self.assertLess(max(row["angle"], row["first derivative"], row["second derivative"]), 1e-12)


class Sextic(Reproduced):
    def test_the_continuity_is_that_of_theory(self):
        even, uneven = self.tables_of("003-table1")
        continuity = {row["method"]: row["continuity"] for row in even["rows"]}
        self.assertEqual({name: continuity[name] for name in ("xing-quartic", "xing-quintic", "quintic", "sextic")},
                         {"xing-quartic": "C2", "xing-quintic": "C3", "quintic": "C2", "sextic": "C3"})
        continuity = {row["method"]: row["continuity"] for row in uneven["rows"]}
        self.assertEqual((continuity["sextic"], continuity["timed-c3"]), ("C0", "C3"))

    def test_xing_is_the_case_of_five_96ths(self):
        for table in self.tables_of("003-table1"):
            rows = {row["curve"]: row for row in table["rows"]}
            for column in ("MSE [rad²]", "maximum [rad]"):
                self.assertAlmostEqual(rows["Xing, quintic"][column], rows["6th degree, β = 5/96"][column], delta=1e-12)

    def test_the_figures_of_the_paper_stand_beside_ours(self):
        rows = {row["curve"]: row for row in self.rows_of("003-table1")}
        self.assertEqual([rows[name]["paper: MSE"] for name in ("Xing, quartic", "Tan, α = 0.45", "6th degree, β = 0.025")],
                         ["0.012979", "0.011337", "0.001130"])

    def test_the_speed_jumps_by_the_ratio_of_the_steps_unless_the_method_is_timed(self):
        knots = {0.5: 2, 1.5: 0.75, 2.25: 7 / 3}
        for row in self.rows_of("003-figure7"):
            if row["curve"].startswith("6th"):
                self.assertAlmostEqual(row["before/after"], knots[row["knot [s]"]], delta=1e-12)
                self.assertEqual(row["continuity"], "C0")
            else:
                self.assertLess(row["|jump of ω|"], 1e-13)
                self.assertEqual(row["continuity"], "C3")


class OwnKeys(Reproduced):
    """Keys of the user's in the place of ours."""

    def setUp(self):
        super().setUp()
        rows = [(t, math.cos(angle), math.sin(angle)) for t, angle in ((5, 0), (6, 0.2), (8, 0.5), (8.5, 0.9), (11, 1), (12, 1.3))]
        self.write("six.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},{w},0,{z},0\n" for t, w, z in rows))

    def test_the_five_keys_of_ours_give_what_stands_in_the_documents(self):
        rows = (DOCS.parent / "examples/data/five_keys.csv").read_text("utf-8").splitlines()
        keys = [row.partition(",")[2] for row in rows if row[:1].isdigit()]
        self.write("five.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},{row}\n" for t, row in enumerate(keys)))
        for experiment in ("000-figure3", "000-table1"):
            ours = json.loads(self.output_of(f"reproduce {experiment} --json"))
            again = json.loads(self.output_of(f"reproduce {experiment} --json --keys five.csv"))
            for table, other in zip(ours[0]["tables"], again[0]["tables"]):
                self.assertEqual(other["notes"], table["notes"][:-1] + ["The keys are those of five.csv."])
                timed = [i for i, name in enumerate(table["columns"]) if "time [ms]" in name]
                for row, same in zip(table["rows"], other["rows"]):
                    for cell, other_cell in ((c, d) for i, (c, d) in enumerate(zip(row, same)) if i not in timed):
                        if isinstance(cell, float):
                            self.assertAlmostEqual(other_cell, cell, delta=1e-6 * max(1, abs(cell)))
                        else:
                            self.assertEqual(other_cell, cell)

    def test_every_experiment_that_takes_keys_takes_six_uneven_ones(self):
        rows = self.rows_of("000-figure3 --keys six.csv")
        self.assertEqual(len(rows), 8)  # without the tensions that are for five keys
        rows = self.rows_of("tan-table1 --keys six.csv")
        self.assertLess(max(row["error [rad]"] for row in rows), 1e-11)
        rows = self.rows_of("003-figure7 --keys six.csv")
        self.assertEqual({row["knot [s]"] for row in rows}, {1, 3, 3.5, 6})
        ratios = [row for row in rows if row["curve"].startswith("6th")]
        for row in ratios:
            self.assertAlmostEqual(row["before/after"], row["steps after/before"], delta=1e-9)
        self.output_of("reproduce sextic-figure7 --keys six.csv --pictures drawn")
        self.assertNotRegex(self.read("drawn/003-figure7.svg"), r"\b(nan|inf)\b")

    def test_a_paper_runs_those_that_take_keys(self):
        reports = json.loads(self.output_of("reproduce 000 --keys six.csv --json"))
        self.assertEqual([report["experiment"] for report in reports], ["000-figure3", "000-table1"])

    def test_what_cannot_be_is_refused(self):
        self.assert_fails("reproduce 001 --keys six.csv", BAD_USAGE,
                          "--keys: found 'six.csv', wanted it with one of " + ", ".join(TAKING_KEYS) +
                          ": the others have keys of their own")
        self.assert_fails("reproduce --keys six.csv", BAD_USAGE, "--keys: found 'six.csv', wanted an EXPERIMENT as well")
        self.assert_fails("reproduce tan-table1 --keys keys.csv", BAD_DATA, "keys.csv: found 3 keys, wanted 4 at least")
        self.assert_fails("reproduce tan-table1 --keys none.csv", BAD_ACCESS,
                          "none.csv: cannot open: No such file or directory")


class Command(CommandTest):
    def test_the_list_names_every_experiment(self):
        page = self.output_of("reproduce")
        self.assertEqual([line.split()[0] for line in page.splitlines() if line[:1].isdigit()], PARTS)
        entries = json.loads(self.output_of("reproduce --json"))
        self.assertEqual([entry["experiment"] for entry in entries], PARTS)
        self.assertEqual([entry["experiment"] for entry in entries if entry["takes_keys"]], TAKING_KEYS)
        for entry in entries:
            self.assertRegex(page, rf"(?m)^{entry['experiment']} +{entry['name']} ")

    def test_the_author_of_a_paper_is_as_good_as_its_number(self):
        for number, author in AUTHORS.items():
            by_number, by_author = (json.loads(self.output_of(f"reproduce {word} --json")) for word in (number, author))
            self.assertEqual([report["experiment"] for report in by_author], [report["experiment"] for report in by_number])
        self.assertEqual(self.output_of("reproduce he-example2"), self.output_of("reproduce 001-example2"))

    def test_the_number_of_a_paper_runs_all_its_parts(self):
        page = self.output_of("reproduce 001")
        self.assertIn("\n001-example2  He et al. 2022", page)
        self.assertEqual([report["experiment"] for report in json.loads(self.output_of("reproduce 001 --json"))],
                         ["001-example1", "001-example2"])

    def test_an_unknown_experiment_gets_one_clear_line(self):
        self.assert_fails("reproduce 004", BAD_USAGE,
                          "unknown experiment '004'; did you mean '000'?")
        papers = [word for paper in AUTHORS.items() for word in paper]
        parts = [word for part in PARTS for word in (part, AUTHORS[part[:3]] + part[3:])]
        self.assert_fails("reproduce mine", BAD_USAGE, "unknown experiment 'mine', wanted one of " + ", ".join(papers + parts))

    def test_pictures_want_an_experiment_and_a_folder(self):
        self.assert_fails("reproduce --pictures here", BAD_USAGE, "--pictures: found 'here', wanted an EXPERIMENT as well")
        self.assert_fails(["reproduce", "002", "--pictures", ""], BAD_USAGE, "--pictures: found '', wanted a folder")
        self.assertFalse((self.folder / "here").exists())

    def test_every_picture_is_an_svg_without_a_number_that_is_none(self):
        for paper in ("000", "001", "002", "003"):
            page = self.output_of(f"reproduce {paper} --pictures new/folder")
            for picture in sorted((self.folder / "new/folder").glob(f"{paper}-*")):
                self.assertIn(f"picture: new/folder/{picture.name}\n", page)
                text = picture.read_text("utf-8")
                self.assertEqual(xml.fromstring(text).tag, "{http://www.w3.org/2000/svg}svg")
                self.assertNotRegex(text, r"\b(nan|inf)\b")
        self.assertEqual(len(list((self.folder / "new/folder").iterdir())), 10)  # and no parts

    def test_the_page_shows_what_the_command_prints(self):
        page = (DOCS / "papers.md").read_text("utf-8")
        blocks = re.findall(r"```text\n\$ orispline reproduce (\S+)\n(.*?)\n```", page, re.S)
        self.assertEqual([name for name, _ in blocks], PARTS)
        for name, block in blocks:
            [report] = json.loads(self.output_of(f"reproduce {name} --json --pictures drawn"))
            for table in report["tables"]:
                for words in [table["title"], *table["notes"], *(row[0] for row in table["rows"])]:
                    self.assertIn(str(words), block)
            for picture in report["pictures"]:
                self.assertIn(f"(papers/{pathlib.Path(picture).name})", page)
                self.assertTrue((DOCS / "papers" / pathlib.Path(picture).name).is_file())

    def test_the_same_pictures_come_out_twice(self):
        for folder in ("a", "b"):
            self.output_of(f"reproduce 001-example2 --pictures {folder}")
        self.assertEqual(self.read("a/001-example2.svg"), self.read("b/001-example2.svg"))

    def test_a_folder_that_is_a_file_is_refused(self):
        self.assert_fails("reproduce 002-example --pictures keys.csv", BAD_ACCESS,
                          "keys.csv: cannot make this folder: Not a directory")

    @unittest.skipIf(os.geteuid() == 0, "root may write everywhere")
    def test_a_folder_without_permission_gets_no_half_picture(self):
        (self.folder / "closed").mkdir(mode=0o500)
        self.assert_fails("reproduce 002-example --pictures closed", BAD_ACCESS,
                          "closed/002-example.svg: cannot write: Permission denied")
        self.assertEqual(list((self.folder / "closed").iterdir()), [])

    def test_a_picture_in_the_way_that_is_a_folder_is_refused(self):
        (self.folder / "here" / "002-example.svg").mkdir(parents=True)
        self.assert_fails("reproduce 002-example --pictures here", BAD_ACCESS,
                          "here/002-example.svg: cannot write: Is a directory")


if __name__ == "__main__":
    main()
