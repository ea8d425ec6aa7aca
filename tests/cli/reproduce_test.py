#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline reproduce`: its keys, pictures and pages, and that the document shows what it prints."""
import json
import math
import os
import pathlib
import re
import sys
import unittest
import xml.etree.ElementTree as xml

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, main, with_pages
from reproduced import AUTHORS, PARTS, TAKING_KEYS, TAKING_REFERENCE, Reproduced

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
sys.path.insert(0, str(DOCS.parent / "papers"))
import make_page  # noqa: E402

NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")


def cells_of(line):
    """The cells of a line of a printed table."""
    return re.split(r" {2,}", line.strip())


def is_rounding(cell):
    """A number that is only a rounding error, and depends on the compiler."""
    return bool(re.fullmatch(r"\d\.\de[+-]\d\d", cell)) and float(cell) < 1e-11


def untimed(text):
    return re.sub(r" +\d\.\d{3}\b(?= |$)", "", text, flags=re.M)


class OwnKeys(Reproduced):
    """Keys of the user's in the place of ours."""

    def setUp(self):
        super().setUp()
        rows = [(t, math.cos(angle), math.sin(angle)) for t, angle in ((5, 0), (6, 0.2), (8, 0.5), (8.5, 0.9), (11, 1), (12, 1.3))]
        self.write("six.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},{w},0,{z},0\n" for t, w, z in rows))

    def test_equal_keys_are_left_in_no_direction(self):
        self.write("rest.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n3,0.8,0.6,0,0\n4,0.8,0,0.6,0\n")
        (report,) = json.loads(self.output_of("reproduce 000-theorem1 --json --keys rest.csv"))
        table = report["tables"][0]
        corner = dict(zip(table["columns"], table["rows"][1]))
        self.assertEqual([corner[name] for name in ("order before", "behind", "corner [degrees]", "of ω at ±1e-5 s")],
                         ["none", 3, "none", "none"])

    def test_the_five_keys_of_ours_give_what_stands_in_the_documents(self):
        rows = (DOCS.parent / "examples/data/five_keys.csv").read_text("utf-8").splitlines()
        keys = [row.partition(",")[2] for row in rows if row[:1].isdigit()]
        self.write("five.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},{row}\n" for t, row in enumerate(keys)))
        for experiment in ("000-figure2", "000-figure3", "000-figure4", "000-theorem1", "000-claims", "003-theorem1"):
            ours = json.loads(self.output_of(f"reproduce {experiment} --json"))
            again = json.loads(self.output_of(f"reproduce {experiment} --json --keys five.csv"))
            notes = [[table["notes"] for table in report[0]["tables"]] for report in (ours, again)]
            self.assertEqual(json.dumps(notes[1], ensure_ascii=False),
                             re.sub(r"The paper's keys are not published[^\"]*", "The keys are those of five.csv.",
                                    json.dumps(notes[0], ensure_ascii=False)))
            for table, other in zip(ours[0]["tables"], again[0]["tables"]):
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
        self.assertEqual([report["experiment"] for report in reports], [part for part in TAKING_KEYS if part[:3] == "000"])
        reports = json.loads(self.output_of("reproduce all --keys six.csv --json"))  # without those that want a truth too
        self.assertEqual([report["experiment"] for report in reports],
                         [part for part in TAKING_KEYS if part not in TAKING_REFERENCE])

    def test_beta_curves_are_through_points_with_the_signs_of_their_file(self):
        """Example 1 as printed, as keys of one's own at other times."""
        points = ((-0.2011, -0.7478, 0.0791, 0.6278), (-0.1603, 0.6073, 0.3653, 0.6871), (-0.4696, 0.0554, -0.8480, -0.2394),
                  (-0.5268, -0.5665, -0.4194, -0.4751), (0.6921, -0.2551, 0.1314, 0.6623))
        self.write("points.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t * t},{','.join(map(str, q))}\n" for t, q in enumerate(points)))
        own, printed = self.rows_of("001-example1 --keys points.csv"), self.rows_of("001-example1")
        self.assertEqual([row["point"] for row in own], ["q10", "q11", "q12", "q20", "q21", "q22", "q23"])
        for row, wanted in zip(own, printed):
            for component in ("qw", "qx", "qy", "qz"):
                self.assertAlmostEqual(row[component], wanted[component], delta=1e-9)
        [given, shortest] = self.rows_of("001-example1 --keys points.csv", 1)
        self.assertEqual((given["joint"], shortest["joint"]), ("q20", "q20"))
        self.assertAlmostEqual(given["G2"], 0.0664, delta=0.5e-4)
        self.assertAlmostEqual(shortest["G2"], 0.0469, delta=0.5e-4)

    def test_a_flight_of_ones_own_runs_the_figures_and_the_table_of_003(self):
        data = DOCS.parent / "examples/data"
        keys, truth = data / "flight_keys.csv", data / "flight_truth.csv"
        words = ["reproduce", "003", "--keys", str(keys), "--reference", str(truth), "--pictures", "drawn", "--json"]
        reports = {report["experiment"]: report for report in json.loads(self.output_of(words))}
        self.assertEqual(list(reports), [part for part in TAKING_KEYS if part[:3] == "003"])
        own, ours = reports["003-table1"]["tables"][0], self.tables_of("003-table1")[2]
        self.assertEqual(own["title"], "The curves of table 1, 38 keys of flight_keys.csv")
        self.assertIn(f"The keys are those of {keys}. The truth is that of {truth}.", own["notes"])
        for row, wanted in zip(own["rows"], ours["rows"]):
            for name, cell in zip(own["columns"], row):
                if isinstance(cell, str):
                    self.assertEqual(cell, wanted[name])
                elif name != "time [ms]":
                    self.assertAlmostEqual(cell, wanted[name], delta=1e-9)
        pictures = {path.name for path in (self.folder / "drawn").iterdir()}
        self.assertEqual(pictures, {path.name for path in (DOCS / "papers").glob("003-*")})
        for name in pictures:
            self.assertNotRegex(self.read(f"drawn/{name}"), r"\b(nan|inf)\b")

    def test_a_truth_without_rates_gets_them_from_a_curve_through_it(self):
        data = DOCS.parent / "examples/data"
        rows = (data / "flight_truth.csv").read_text("utf-8").splitlines()
        self.write("truth.csv", "\n".join(",".join(row.split(",")[:5]) for row in rows if not row.startswith("#")) + "\n")
        words = ["reproduce", "003-table1", "--keys", str(data / "flight_keys.csv"), "--json", "--reference"]
        [told], [found] = (json.loads(self.output_of([*words, truth])) for truth in (str(data / "flight_truth.csv"), "truth.csv"))
        self.assertIn("truth.csv; its rates are those of `auto` through it.", found["tables"][0]["notes"][-1])
        speeds = [report["drawn"][2]["charts"][3]["series"][0] for report in (told, found)]
        self.assertEqual([series["label"] for series in speeds], ["truth", "truth"])
        for speed, other in zip(*(series["y"] for series in speeds)):
            self.assertAlmostEqual(speed, other, delta=0.02)


    def test_keys_at_rest_give_tables_and_pictures_without_a_number_that_is_none(self):
        for name, times in (("still.csv", range(5)), ("truth.csv", [t / 10 for t in range(41)])):
            self.write(name, "t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,0,0\n" for t in times))
        text = self.output_of("reproduce all --keys still.csv --reference truth.csv --pictures drawn")
        self.assertNotRegex(text, r"\b(nan|inf)\b")
        for picture in (self.folder / "drawn").iterdir():
            self.assertNotRegex(picture.read_text("utf-8"), r"\b(nan|inf)\b", picture.name)

    def test_what_cannot_be_is_refused(self):
        self.assert_fails("reproduce 002 --keys six.csv", BAD_USAGE,
                          "--keys: found 'six.csv', wanted it with one of " + ", ".join(TAKING_KEYS) +
                          ": the others have keys of their own")
        self.assert_fails("reproduce --keys six.csv", BAD_USAGE, "--keys: found 'six.csv', wanted an EXPERIMENT as well")
        self.assert_fails("reproduce 003-table1 --keys six.csv", BAD_USAGE,
                          "--keys: found 'six.csv', wanted --reference as well, which is the true motion")
        self.assert_fails("reproduce 003-table1 --reference six.csv", BAD_USAGE,
                          "--reference: found 'six.csv', wanted --keys as well")
        self.assert_fails("reproduce 000 --keys six.csv --reference six.csv", BAD_USAGE,
                          "--reference: found 'six.csv', wanted it with one of " + ", ".join(TAKING_REFERENCE) +
                          ": the others need no truth")
        self.assert_fails("reproduce 003-table1 --keys six.csv --reference none.csv", BAD_ACCESS,
                          "none.csv: cannot open: No such file or directory")
        self.assert_fails("reproduce tan-table1 --keys keys.csv", BAD_DATA, "keys.csv: found 3 keys, wanted 4 at least")
        self.assert_fails("reproduce tan-table1 --keys none.csv", BAD_ACCESS,
                          "none.csv: cannot open: No such file or directory")


class Command(Reproduced):
    def test_the_list_names_every_experiment(self):
        page = self.output_of("reproduce")
        self.assertEqual([line.split()[0] for line in page.splitlines() if line[:1].isdigit()], PARTS)
        entries = json.loads(self.output_of("reproduce --json"))
        self.assertEqual([entry["experiment"] for entry in entries], PARTS)
        self.assertEqual([entry["experiment"] for entry in entries if entry["takes_keys"]], TAKING_KEYS)
        self.assertEqual([entry["experiment"] for entry in entries if entry["takes_reference"]], TAKING_REFERENCE)
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
                         ["001-example1", "001-example2", "001-local", "001-shapes"])

    def test_the_curves_of_a_picture_are_in_the_json(self):
        [report] = json.loads(self.output_of("reproduce 003-figure7 --json"))
        body, rates = report["drawn"]
        self.assertEqual([body["picture"], rates["picture"]], ["003-figure7-body", "003-figure7"])
        self.assertEqual([row["label"] for row in body["bodies"]], ["6th degree, β = 1/12", "6th degree, β = 0.025"])
        for row in body["bodies"]:
            self.assertEqual((len(row["t"]), len(row["q"])), (17, 17))
            for q in row["q"]:
                self.assertAlmostEqual(math.hypot(*q), 1, delta=1e-12)
        point, whole, _ = rates["charts"]
        self.assertEqual(whole["marks"], [0, 0.5, 1.5, 2.25, 4])
        for along, all_of_it in zip(point["series"], whole["series"]):
            self.assertEqual(along["label"], all_of_it["label"])
            self.assertEqual(len(along["x"]), len(along["y"]))
            self.assertEqual(along["y"].count(None), 4)  # the curve breaks where a segment ends
            for speed, rate in zip(along["y"], all_of_it["y"]):
                if rate is not None:
                    self.assertLessEqual(speed, rate + 1e-12)
        [sphere, _] = json.loads(self.output_of("reproduce 000-figure2 --json"))[0]["drawn"][0]["spheres"]
        self.assertEqual([path["label"] for path in sphere["paths"]],
                         ["α₃ = 0.35", "α₃ = 0", "α₃ = 0.7", "α₃ = 1", "α₃ = 2", "α = 0"])
        self.assertEqual([dot["label"] for dot in sphere["dots"]], ["1", "2", "3", "4", "5"])

    def test_every_picture_has_its_curves_in_the_json(self):
        for paper in AUTHORS:
            for report in json.loads(self.output_of(f"reproduce {paper} --json --pictures drawn")):
                self.assertEqual([f"drawn/{drawn['picture']}.svg" for drawn in report["drawn"]], report["pictures"])
                for drawn in report["drawn"]:
                    self.assertTrue(drawn["charts"] or drawn["spheres"] or drawn["bodies"], drawn["picture"])

    def test_all_experiments_go_into_a_folder(self):
        listed = self.output_of("reproduce all --output-folder papers")
        names = {path.name for path in (self.folder / "papers").iterdir()}
        tables = {f"{part}.{extension}" for part in PARTS for extension in ("txt", "json")}
        self.assertEqual(names, tables | {path.name for path in (DOCS / "papers").iterdir()})
        self.assertEqual({line.strip() for line in listed.splitlines() if line.startswith("  ")}, {f"papers/{name}" for name in names})
        self.assertEqual(self.read("papers/002-example.txt"), self.output_of("reproduce 002-example --pictures papers"))
        self.assertEqual(self.read("papers/002-example.json"), self.output_of("reproduce 002-example --json --pictures papers"))
        [files] = json.loads(self.output_of("reproduce 002-example --output-folder papers --json"))
        self.assertEqual((files["tables"], files["pictures"]),
                         (["papers/002-example.txt", "papers/002-example.json"], ["papers/002-example.svg"]))
        (self.folder / "torn/002-example.json").mkdir(parents=True)
        self.assert_fails("reproduce 002-example --output-folder torn", BAD_ACCESS,
                          "torn/002-example.json: cannot write: Is a directory; 2 files were written and are complete")
        self.assert_fails("reproduce --output-folder here", BAD_USAGE,
                          "--output-folder: found 'here', wanted an EXPERIMENT as well")
        self.assert_fails("reproduce 002 --output-folder here --pictures there", BAD_USAGE,
                          "--pictures: found 'there', wanted it without --output-folder, where the pictures are too")

    def test_an_unknown_experiment_gets_one_clear_line(self):
        self.assert_fails("reproduce 004", BAD_USAGE,
                          "unknown experiment '004'; did you mean '000'?")
        papers = [word for paper in AUTHORS.items() for word in paper]
        parts = [word for part in PARTS for word in (part, AUTHORS[part[:3]] + part[3:])]
        self.assert_fails("reproduce mine", BAD_USAGE, "unknown experiment 'mine', wanted one of " + ", ".join(["all"] + papers + parts))

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
        self.assertEqual({path.name for path in (self.folder / "new/folder").iterdir()},
                         {path.name for path in (DOCS / "papers").iterdir()})  # and no parts

    def test_the_page_shows_what_the_command_prints(self):
        page = (DOCS / "papers.md").read_text("utf-8")
        blocks = make_page.BLOCK.findall(page)
        self.assertEqual(blocks, PARTS)
        for name, shown in zip(blocks, (match[0] for match in make_page.BLOCK.finditer(page))):
            [report] = json.loads(self.output_of(f"reproduce {name} --json --pictures drawn"))
            self.assert_shown(report, shown)
            for picture in report["pictures"]:
                self.assertIn(f"(papers/{pathlib.Path(picture).name})", page)

    def assert_shown(self, report, block):
        """The lines of a block are those of a new run, but for times and the size of rounding errors."""
        lines = make_page.block(report["experiment"], self.output_of(f"reproduce {report['experiment']}")).splitlines()
        shown = block.splitlines()
        self.assertEqual(len(shown), len(lines), report["experiment"])
        heads = [next(i for i, line in enumerate(lines) if line == table["title"]) + 1 for table in report["tables"]]
        for i, (line, other) in enumerate(zip(lines, shown)):
            head = max((h for h in heads if h <= i), default=None)
            timed = [] if head is None else [k for k, cell in enumerate(cells_of(lines[head])) if "time [ms]" in cell]
            for k, (cell, other_cell) in enumerate(zip(cells_of(line), cells_of(other), strict=True)):
                if k not in timed and not (is_rounding(cell) and is_rounding(other_cell)):
                    self.assertEqual(other_cell, cell, f"{report['experiment']} differs, wanted: papers/make_page.py COMMAND")

    def test_every_picture_of_the_page_is_the_one_that_the_command_draws(self):
        """Line by line, and so much alike that no eye sees a difference: a tenth of a pixel."""
        for paper in AUTHORS:
            self.output_of(f"reproduce {paper} --pictures drawn")
        for picture in (DOCS / "papers").iterdir():
            drawn, shown = self.read(f"drawn/{picture.name}").splitlines(), picture.read_text("utf-8").splitlines()
            self.assertEqual(len(drawn), len(shown), picture.name)
            for line, other in zip(drawn, shown):
                self.assertEqual(NUMBER.sub("", line), NUMBER.sub("", other), picture.name)
                for a, b in zip(NUMBER.findall(line), NUMBER.findall(other)):
                    self.assertAlmostEqual(float(a), float(b), delta=0.101, msg=picture.name)

    def test_the_same_pictures_come_out_twice(self):
        for folder in ("a", "b"):
            self.output_of(f"reproduce 001-example2 --pictures {folder}")
        self.assertEqual(self.read("a/001-example2.svg"), self.read("b/001-example2.svg"))

    @with_pages
    def test_the_report_shows_the_motions_of_an_experiment_with_the_truth(self):
        plain = self.output_of("reproduce 003-table1")
        self.assertEqual(untimed(self.output_of("reproduce 003-table1 --report out.html")), untimed(plain))
        page = self.page("out.html")
        self.assertEqual(page["command"], "orispline reproduce 003-table1 --report out.html")
        self.assertEqual(page["title"], "The 6th degree, table 1 and figures 1 to 6: a flight interpolated")
        names = [method["name"] for method in page["methods"]]
        self.assertEqual(names, ["Xing, quartic", "Tan, α = 0.45", "6th degree, β = 0.025", "6th degree, β = 0.05",
                                 "6th degree, β = 5/96", "6th degree, β = 1/12"])
        self.assertEqual(len(page["reference"]["t"]), 961)
        rms = {row["curve"]: math.degrees(math.sqrt(row["angle: MSE [rad²]"])) for row in self.rows_of("003-table1")}
        for method in page["methods"]:
            self.assertAlmostEqual(method["measures"]["rms_deg"], rms[method["name"]], delta=1e-5)

    @with_pages
    def test_the_report_of_a_paper_has_the_motions_of_all_its_experiments_on_their_own_keys(self):
        self.output_of("reproduce 001 --report out.html")
        page = self.page("out.html")
        self.assertEqual([method["name"].split(":")[0] for method in page["methods"]],
                         ["001-example1"] + ["001-example2"] * 6)
        self.assertIsNone(page["reference"])
        one, two = page["methods"][0]["keys"], page["methods"][1]["keys"]
        self.assertEqual(one["t"], two["t"])
        self.assertNotEqual(one["q"], two["q"])

    @with_pages
    def test_the_report_of_a_paper_keeps_the_truth_for_the_curves_that_have_one(self):
        self.output_of("reproduce 003 --report out.html")
        page = self.page("out.html")
        self.assertEqual(len(page["reference"]["t"]), 961)
        for method in page["methods"]:
            is_flight = method["name"].startswith("003-table1: ")
            self.assertEqual(method["measures"].get("rms_deg") is not None, is_flight, method["name"])
            self.assertEqual(len(method["samples"]["error_deg"]), 961 if is_flight else 0)
        self.assertIn("003-figure7: timed-c3", [method["name"] for method in page["methods"]])

    @with_pages
    def test_a_report_wants_an_experiment_with_motions(self):
        self.assert_fails("reproduce --report out.html", BAD_USAGE,
                          "--report: found 'out.html', wanted an EXPERIMENT as well")
        self.assert_fails("reproduce 002 --report out.html", BAD_USAGE,
                          "--report: found 'out.html', wanted it with an experiment that has motions, such as 000-figure3")
        self.assert_fails("reproduce 001 --report -", BAD_USAGE, "--report: found '-', wanted the name of a file")
        self.assert_fails("reproduce 001 --report nowhere/out.html", BAD_ACCESS,
                          "nowhere/out.html: cannot write: No such file or directory")
        self.assertEqual(list(self.folder.glob("out*")), [])

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
                          "here/002-example.svg: cannot write: Is a directory; nothing was written")


if __name__ == "__main__":
    main()
