#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""How curves look is stated once, studio/viewer/src/look/look.json; the Python package has the same table."""
import json
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TABLE = ROOT / "studio/viewer/src/look/look.json"
COPY = ROOT / "bindings/python/orispline/look.json"


class Look(unittest.TestCase):
    def test_the_package_has_the_table_of_the_viewer(self):
        self.assertEqual(TABLE.read_bytes(), COPY.read_bytes(), f"found another table, wanted: cp {TABLE.relative_to(ROOT)} {COPY.relative_to(ROOT)}")

    def test_both_themes_have_the_same_colours(self):
        look = json.loads(TABLE.read_text("utf-8"))
        self.assertEqual(list(look["light"]), list(look["dark"]))
        for colour in [*look["light"].values(), *look["dark"].values(), *look["further"]]:
            self.assertRegex(colour, r"^#[0-9a-f]{6}$")

    def test_the_charts_of_the_command_have_the_same_words(self):
        look = json.loads(TABLE.read_text("utf-8"))["quantities"]
        drawn = re.findall(r'^    \{"(\w+)", "(.*?) \[(.*?)\]"', (ROOT / "src/orispline/report/motion_drawing.cpp").read_text("utf-8"), re.M)
        self.assertEqual([word for word, _, _ in drawn], ["angle", "rate", "acceleration", "jerk"])
        for word, title, unit in drawn:
            self.assertEqual({"title": title, "unit": unit}, look[word])


if __name__ == "__main__":
    unittest.main()
