#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The pictures of docs/concepts.md are those that the command's output gives: concepts_test.py COMMAND."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import concept_figures  # noqa: E402


class Concepts(unittest.TestCase):
    def test_the_pictures_are_current(self):
        figures = concept_figures.concept_figures(sys.argv[1], (ROOT / "examples/data/five_keys.csv").read_text("utf-8"))
        page = (ROOT / "docs/concepts.md").read_text("utf-8")
        for name, figure in figures.items():
            self.assertIn(f"]({name}.svg)", page)
            self.assertEqual((ROOT / f"docs/{name}.svg").read_text("utf-8"), figure, f"{name}.svg differs, wanted: tools/make_figures.py COMMAND")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
