#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The pictures of concepts, of tasks and of other pages are those that the command's output gives: figures_test.py COMMAND."""
import pathlib
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
from figures.pages import concept_figures, page_figures  # noqa: E402
from figures.tasks import task_figures  # noqa: E402


class Figures(unittest.TestCase):
    def assert_current(self, figures, page_of):
        for name, figure in figures.items():
            self.assertIn(f"]({name.rpartition('/')[2]}.svg)", (ROOT / f"docs/{page_of(name)}.md").read_text("utf-8"))
            self.assertEqual((ROOT / f"docs/{name}.svg").read_text("utf-8"), figure, f"{name}.svg differs, wanted: tools/make_figures.py COMMAND")

    def test_the_pictures_of_concepts_are_current(self):
        self.assert_current(concept_figures(sys.argv[1], (ROOT / "examples/data/five_keys.csv").read_text("utf-8")), lambda name: "concepts")

    def test_the_pictures_of_tasks_are_current(self):
        self.assert_current(task_figures(sys.argv[1]), lambda name: name)

    def test_the_first_pictures_of_pages_are_current(self):
        self.assert_current(page_figures(sys.argv[1]), lambda name: name)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
