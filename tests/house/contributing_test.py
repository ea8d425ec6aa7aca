#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The recipes of CONTRIBUTING.md name all places: what was added by a recipe stands in each place that the recipe names, and in no other."""
import pathlib
import re
import unittest
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
SUFFIXES = {".c", ".cpp", ".h", ".hpp", ".json", ".md", ".py", ".sh", ".svg", ".ts", ".txt", ".xml"}
PLACEHOLDERS = re.compile(r"my_\w+|NAME")


class Model(NamedTuple):
    """Something that was added, to which a recipe has to fit."""
    named: dict  # what the recipe calls it -> its own name there
    words: str  # that each place of the recipe contains
    elsewhere: str = ""  # words that none but these places contain, of the files in `within`; empty: not looked for
    within: tuple = ("src", "cli", "bindings")
    without: tuple = ()  # places for some only, and tools that are called and do not name it


MODELS = {
    "Add a method": Model({"my_curve": "atbi", "NAME": "atbi"}, r"(?i)atbi", r"(?i)\batbi\b", without=("docs/files.md", "docs/tune.md")),
    "Add a format of keys": Model({"my_format": "euroc"}, r"(?i)euroc", r"euroc_format|formats/euroc"),
    "Add a format of skeletons": Model({"my_format": "bvh"}, r"(?i)bvh", r"scenes/bvh/bvh\b"),
    "Add an option": Model({}, r"\bpenalty\b", r"\bpenalty\b", ("cli", "bindings"), ("tools/make_field_tables.py", "bindings/npm/tasks.mjs")),
    "Add a result": Model({}, r"\bsamples_in_short_stretches\b", r"\bsamples_in_short_stretches\b", ("cli", "bindings"), ("tools/make_field_tables.py",)),
    "Add a task": Model({}, r"(?i)mean", r"\bmean_info\b|\brun_mean\b|\badd_mean\b|jobs/mean\.cpp|tasks_mean", without=("bindings/python/stub.py",)),
    "Add a measure": Model({}, r"\bmedian_deg\b", r"\bmedian_deg\b", without=("src/orispline/analysis/comparison.cpp",)),
    "Add an experiment of a paper": Model({"my_experiment": "sudden_turn"}, r"sudden_turn|003-figure7", r"\bsudden_turn\b", ("cli", "papers"), ("tools/make_papers.py",)),
}


def recipes():
    """The numbered steps of each recipe, by its heading."""
    section = (ROOT / "CONTRIBUTING.md").read_text("utf-8").partition("\n## Recipes\n")[2].partition("\n## ")[0]
    return {part.partition("\n")[0]: re.search(r"^1\. .*?(?=\n\n|\Z)", part, re.M | re.S)[0] for part in section.split("\n### ")[1:]}


def paths_in(text):
    """What stands as code and looks like a file or a folder from the root."""
    for code in re.findall(r"`([\w./-]+)`", text):
        if "/" in code and (pathlib.PurePath(code).suffix in SUFFIXES or (ROOT / code).is_dir()) and (ROOT / code.partition("/")[0]).exists():
            yield code


def places_of(title, model):
    """The places of a recipe, with the names of its model."""
    places = set(paths_in(recipes()[title]))
    for word, own in model.named.items():
        places = {place.replace(word, own) for place in places}
    return places


def contains(path, words):
    """A folder by what lies in it."""
    files = [path] if path.is_file() else [file for file in path.rglob("*") if file.suffix in SUFFIXES]
    return any(re.search(words, file.name) or re.search(words, file.read_text("utf-8")) for file in files)


class Contributing(unittest.TestCase):
    def test_every_place_that_is_named_is_there(self):
        for page in ("CONTRIBUTING.md", "docs/building.md"):
            places = [path for path in paths_in((ROOT / page).read_text("utf-8")) if not PLACEHOLDERS.search(path) and not path.startswith("build/")]
            self.assertGreater(len(places), 20, page)
            for path in places:
                self.assertTrue((ROOT / path).exists(), f"{page}: {path}")

    def test_every_recipe_of_what_is_in_a_list_has_a_model(self):
        self.assertLessEqual(set(MODELS), set(recipes()))

    def test_models_stand_in_every_place_of_their_recipes(self):
        for title, model in MODELS.items():
            places = places_of(title, model) - set(model.without)
            self.assertGreater(len(places), 2, title)
            for place in sorted(places):
                self.assertTrue((ROOT / place).exists() and contains(ROOT / place, model.words), f"{title}: {place} does not name its model")

    def test_models_stand_in_no_other_place(self):
        for title, model in MODELS.items():
            own = {pathlib.PurePath(place).with_suffix("") for place in places_of(title, model)}  # a source with its header
            for file in (file for folder in model.within for file in sorted((ROOT / folder).rglob("*")) if file.suffix in SUFFIXES - {".md"}):
                place = file.relative_to(ROOT)
                if model.elsewhere and place.with_suffix("") not in own and "node_modules" not in place.parts:
                    self.assertNotRegex(file.read_text("utf-8"), model.elsewhere, f"{place} is a place that the recipe '{title}' does not name")


if __name__ == "__main__":
    unittest.main()
