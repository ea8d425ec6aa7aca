#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The documents beside the registry and each other: documents_test.py COMMAND, the built orispline."""
import json
import os
import pathlib
import re
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests/shown")]
import make_field_tables  # noqa: E402
from pages import FENCE, PAGES  # noqa: E402

DOCS = ROOT / "docs"
HEADINGS = ["Formula", "Continuity", "Picture", "When to use it", "Source", "Errata"]
ORDERS = "⁰¹²³"
STATED = re.compile(rf"(C[{ORDERS}](?:, C[{ORDERS}])*)(?: \([^)]*\))? / (the same|C[{ORDERS}](?:, C[{ORDERS}])*)")
SOURCES = ["benchmarks", "bindings", "cli", "examples", "papers", "src", "studio", "tools"]
SUFFIXES = {".c", ".cpp", ".h", ".hpp", ".ipynb", ".js", ".mjs", ".py", ".pyi", ".ts"}
LINK = re.compile(r"\]\(([^)\s]+)\)")


def registry():
    return json.loads(subprocess.run([sys.argv[1], "methods", "--json"], check=True, capture_output=True).stdout)


def text_of(page):
    return (DOCS / page).read_text("utf-8")


def rows(page, head):
    """The rows of all tables of a page whose first columns are named so, as lists of cells."""
    found, inside = [], False
    for line in text_of(page).splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if line.startswith("|") and not inside:
            inside = cells[:len(head)] == head
        elif not line.startswith("|"):
            inside = False
        elif inside and set(line) - set("|- "):
            found.append(cells)
    return found


def named(cell):
    """The methods of a cell; `-c2` behind `hermite-c1` is hermite-c2."""
    names = []
    for name in re.findall(r"`([a-z0-9-]+)`", cell):
        names.append(names[-1].rpartition("-")[0] + name if name.startswith("-") else name)
    return names


def anchors(page):
    headings = re.findall(r"^#+ (.*)$", re.sub(r"^```.*?^```", "", page.read_text("utf-8"), flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


class Documents(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.methods = {method["name"]: method for method in registry()}

    def test_the_changelog_says_nothing_twice(self):
        entries = re.findall(r"(?m)^- (.{28})", (ROOT / "CHANGELOG.md").read_text("utf-8"))
        self.assertEqual(sorted({entry for entry in entries if entries.count(entry) > 1}), [])

    def assert_continuity(self, names, cell):
        """A statement such as C² / C⁰ is the registry's; methods with an order of the user's choice state it in words."""
        stated = STATED.search(cell)
        names = [name for name in names if not {p["name"] for p in self.methods[name]["parameters"]} & {"order", "degree"}]
        if not stated or not names:
            return 0
        even = [ORDERS.index(c[1]) for c in stated[1].split(", ")]
        uneven = even if stated[2] == "the same" else [ORDERS.index(c[1]) for c in stated[2].split(", ")]
        for k, name in enumerate(names):
            method = self.methods[name]
            self.assertEqual((even[k % len(even)], uneven[k % len(uneven)]),
                             (method["continuity_uniform"], method["continuity_uneven"]), f"{name}: {cell}")
        return len(names)

    def test_every_method_has_a_page_with_all_headings_and_a_picture(self):
        for name in self.methods:
            page = text_of(f"families/{name}.md")
            self.assertTrue(page.startswith(f"# {name}\n"), name)
            for heading in HEADINGS:
                self.assertIn(f"\n## {heading}\n", page, name)
            self.assertIn(f"]({name}.svg)", page)
            self.assertTrue((DOCS / f"families/{name}.svg").is_file(), name)

    def test_every_page_states_the_support_and_the_closing_of_its_method(self):
        stated = 0
        for name, method in self.methods.items():
            page = " ".join(text_of(f"families/{name}.md").split())
            support = re.search(r"Support: (all|\d+) keys", page)
            closes = re.search(r"[Cc]losed curves: (yes|no)|[Nn]o end rules, no closed curves", page)
            if support:
                keys = method["support_keys"]
                self.assertEqual(support[1], "all" if keys is None else str(keys), name)
            if closes:
                self.assertEqual(closes[1] == "yes", method["closes"], name)
            stated += bool(support) + bool(closes)
        self.assertGreater(stated, 1.5 * len(self.methods))

    def test_the_index_lists_every_method_once_with_its_continuity(self):
        table = [(named(cells[0]), cells[1]) for cells in rows("index.md", ["method"])]
        self.assertEqual(sorted(name for names, _ in table for name in names), sorted(self.methods))
        for names, cell in table:
            self.assertTrue(self.assert_continuity(names, cell) or "order" in cell or "degree" in cell or "k" in cell, cell)

    def test_which_method_when_names_every_method_with_its_continuity(self):
        table = [(named(cells[0]), cells[1]) for cells in rows("choosing.md", ["method", "continuity"])]
        self.assertLessEqual(set(self.methods), {name for names, _ in table for name in names})
        checked = sum(self.assert_continuity([name for name in names if name in self.methods], cell) for names, cell in table)
        self.assertGreater(checked, len(self.methods))

    def test_which_method_when_states_the_keys_of_a_segment(self):
        for names, keys in ((named(cells[0]), cells[2]) for cells in rows("choosing.md", ["method", "continuity", "keys"])):
            self.assertEqual({self.methods[name]["support_keys"] for name in names}, {int(keys)}, names)

    def test_closed_curves_names_exactly_the_methods_that_close(self):
        paragraph = re.search(r"^The methods that can: .*?\. ", text_of("closed.md"), re.M | re.S)[0]
        self.assertEqual(sorted(named(paragraph)), sorted(name for name, m in self.methods.items() if m["closes"]))

    def test_the_table_of_rates_names_exactly_the_methods_that_read_them(self):
        read = {name: cells[1].count(",") + 1 for cells in rows("files.md", ["method", "reads"]) for name in named(cells[0])}
        self.assertEqual(read, {name: m["rate_orders"] for name, m in self.methods.items() if m["rate_orders"]})

    def test_the_table_of_tensions_names_exactly_the_methods_that_are_tuned(self):
        refused = [sys.argv[1], "tune", ROOT / "examples/data/flight_keys.csv", "--method", "slerp", "-o", os.devnull]
        line = subprocess.run(refused, capture_output=True, text=True, check=False).stderr.splitlines()[0]
        table = [name for cells in rows("tune.md", ["method", "tensions that are found"]) for name in named(cells[0])]
        self.assertEqual(sorted(table), sorted(line.partition(" wanted one of ")[2].split(", ")))

    def test_every_end_rule_is_explained(self):
        rules = {rule for method in self.methods.values() for rule in method["ends"]}
        pages = {name: text_of(f"families/{name}.md") + text_of("conventions.md") for name in self.methods}
        self.assertGreater(len(rules), 6)
        for name, method in self.methods.items():
            for rule in method["ends"]:
                self.assertIn(f"`{rule}`", pages[name], name)

    def test_the_positions_of_every_method_are_in_the_conventions(self):
        cells = [cell for cells in rows("conventions.md", ["methods", "path"]) for cell in named(cells[0])]
        self.assertEqual(sorted(cells), sorted(self.methods))

    def test_the_tables_of_options_and_results_are_those_of_the_library(self):
        tasks = make_field_tables.tasks_of(sys.argv[1])
        tables = {}
        for page in DOCS.glob("*.md"):
            text = page.read_text("utf-8")
            tables |= {(task, part): page.stem for _, task, part, _ in make_field_tables.BLOCK.findall(text)}
            self.assertEqual(make_field_tables.with_tables(text, tasks), text,
                             f"{page.name} differs, wanted: tools/make_field_tables.py COMMAND")
        wanted = {(name, part): {"difference": "skeletons"}.get(name, name) for name, task in tasks.items() for part in ("options", "results", "results_of_gyros") if task.get(part)}
        self.assertEqual(tables, wanted)

    def test_the_json_of_a_task_is_described_with_every_result(self):
        page = text_of("inspect-json.md")
        for task in make_field_tables.tasks_of(sys.argv[1]).values():
            for result in task["results"] + task.get("results_of_gyros", []):
                self.assertIn(f"`{result['name']}`", page, task["task"])

    def test_the_index_lists_every_public_header_and_pages_include_no_other(self):
        public = {path.name for path in (ROOT / "src/orispline").glob("*.hpp")}
        listed = [name for row in rows("index.md", ["`#include <orispline/…>`"])
                  for name in re.findall(r"`([a-z_]+\.hpp)`", row[0])]
        self.assertCountEqual(listed, public)
        for page in PAGES:
            included = re.findall(r"#include <orispline/(\w.*?)>", page.read_text("utf-8"))
            self.assertLessEqual(set(included), public, page)

    def test_no_page_counts_the_methods(self):
        for page in PAGES:
            found = re.search(r"\b(?:all|the|of) (?:the )?\d\d(?: methods|[.:](?:\s|$))", page.read_text("utf-8"))
            self.assertFalse(found, f"{page.name}: found {found and found[0]!r}, wanted no number that a new method makes wrong")

    def test_commands_name_the_example_data_as_they_are(self):
        for page in PAGES:
            for line in re.findall(r"^(?:\$ )?orispline .*", page.read_text("utf-8"), re.M):
                for name in re.findall(r"(?<= )\S*(?:(?:flight|robot|camera|five)\w*\.csv|walking\.bvh)", line.partition(" -o ")[0]):
                    self.assertTrue((ROOT / name).is_file(), f"{page.name}: {line}")

    def test_extras_of_the_python_package_that_pages_name_are_there(self):
        extras = re.search(r"^\[project\.optional-dependencies\]\n(.*?)^\[", (ROOT / "pyproject.toml").read_text("utf-8"), re.M | re.S)[1]
        for page in PAGES:
            for extra in re.findall(r"orispline\[(\w+)\]", page.read_text("utf-8")):
                self.assertRegex(extras, rf"(?m)^{extra} = ", page)

    def test_links_are_written_in_the_one_way_that_is_followed(self):
        for page in PAGES:
            text = re.sub(r"`[^`\n]*`", "", FENCE.sub("", page.read_text("utf-8")))
            self.assertEqual(text.count("]("), len(LINK.findall(text)), page)
            self.assertIsNone(re.search(r"^\[[^\]]+\]:|<(?:a|img|source)\b", text, re.M), page)

    def test_pages_that_sources_name_are_there(self):
        for place in SOURCES:
            for path in (path for path in (ROOT / place).rglob("*") if path.suffix in SUFFIXES and "node_modules" not in path.parts):
                for name in re.findall(r"\bdocs/[\w/-]+\.md", path.read_text("utf-8")):
                    self.assertTrue((ROOT / name).is_file(), f"{path}: {name}")

    def test_every_link_leads_somewhere(self):
        """Of those within the project; what is elsewhere would want a network."""
        for page in PAGES:
            for target in LINK.findall(page.read_text("utf-8")):
                path, _, anchor = target.partition("#")
                if "://" in target:
                    continue
                file = (page.parent / path).resolve() if path else page
                self.assertTrue(file.exists(), f"{page.name}: {target}")
                self.assertTrue(not anchor or anchor in anchors(file), f"{page.name}: {target}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
