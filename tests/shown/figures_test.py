#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Figures that pages state in their own words are those that the commands beside them print anew.

They stand between `<!-- figures: COMMANDS -->` and `<!-- end of figures -->`. Commands may name recordings; where these do not lie beside the project they
are not run. Each number with a decimal point there is one that the commands print,
rounded; in a row of a table whose first cell holds names as code, one in a line that begins with such a name.
"""
import re
import sys
import unittest
from typing import NamedTuple

from given import NAMED, has_recordings, put
from lines import Line, run
from pages import PAGES, ROOT, name_of

sys.path.insert(0, str(ROOT / "tests/cli"))
from command import COMMAND, CommandTest, main  # noqa: E402

BLOCK = re.compile(r"<!-- figures:(?P<commands>.+?)-->\n(?P<text>.*?)<!-- end of figures -->", re.S)
FIGURE = re.compile(r"(?<![\w.,])-?\d+\.\d+(?:e[-+]?\d+)?(?!\w|\.\d)")
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
FIRST_CELL = re.compile(r"^\| \[?`[^|]*")


class Figures(NamedTuple):
    place: str
    commands: list
    text: str


def blocks_of(page):
    text = page.read_text("utf-8")
    for block in BLOCK.finditer(text):
        yield Figures(f"{name_of(page)}:{text.count(chr(10), 0, block.start()) + 1}", block["commands"].strip().splitlines(), block["text"])


def is_printed(figure, printed):
    """Whether a number that is printed rounds to the figure: half a unit of its last digit, or what a double adds to that."""
    digits, _, exponent = figure.partition("e")
    half = 0.5 * 10.0 ** (int(exponent or 0) - len(digits.partition(".")[2]))
    return any(abs(float(number) - float(figure)) <= half * (1 + 1e-9) for number in printed)


def not_printed(text, lines):
    """The figures of a text that no line has."""
    everything = [number for line in lines for number in NUMBER.findall(line)]
    for line in text.splitlines():
        cell = FIRST_CELL.match(line)
        printed = everything
        if cell:
            begins = re.compile(r'\s*"?(?:' + "|".join(map(re.escape, re.findall("`([^`]+)`", cell[0]))) + r')(?=[\s",])')
            printed = [number for one in lines if begins.match(one) for number in NUMBER.findall(one)]
        for figure in FIGURE.findall(line):
            if not is_printed(figure, printed):
                yield f"{figure} in: {line.strip()[:100]}"


class Stated(CommandTest):
    def test_figures_are_those_that_their_commands_print(self):
        programs = self.folder / "programs"
        programs.mkdir()
        (programs / "orispline").symlink_to(COMMAND)
        (self.folder / "examples").symlink_to(ROOT / "examples")
        count = 0
        for figures in (block for page in PAGES for block in blocks_of(page)):
            with self.subTest(figures.place):
                recordings = {name: content for name, content in NAMED.items() if any(name in command for command in figures.commands)}
                if recordings and not has_recordings():
                    self.skipTest(f"{figures.place}: there are no recordings beside the project")
                put(self.folder, recordings)
                lines = [Line(figures.place, command) for command in figures.commands]
                printed = run(lines, self.folder, programs)
                if len(printed) <= len(lines):
                    self.fail(f"{lines[len(printed) - 1].text}\nprints: {printed[-1]}")
                self.assertEqual(list(not_printed(figures.text, "".join(printed).splitlines())), [])
                count += 1
        self.assertGreater(count, 0)


class Rules(unittest.TestCase):
    def test_a_figure_is_found_where_it_is_a_rounded_number_of_the_line_of_its_row(self):
        lines = ["slerp,1.2345,2.5", '"auto",7.125e-05']
        self.assertEqual(list(not_printed("It is 1.23 and 1.235, or 0.00007.", lines)), [])
        self.assertEqual(len(list(not_printed("It is 1.24.", lines))), 1)
        self.assertEqual(list(not_printed("| `slerp` | 1.2, 2.5 |", lines)), [])
        self.assertEqual(len(list(not_printed("| `auto` | 1.2 |", lines))), 1)


if __name__ == "__main__":
    main()
