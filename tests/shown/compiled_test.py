#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The blocks of C++ and C in the pages are parts of examples, which are compiled and run, or compile themselves. Those of CMake are in
projects that the package tests build.

compiled_test.py COMPILE_COMMANDS, where CMake says how the examples are compiled
"""
import json
import pathlib
import re
import shlex
import subprocess
import sys
import unittest

from pages import PAGES, ROOT, all_blocks, name_of, outputs_of

OF_EXAMPLE = {  # a page, of which example its first blocks are, and how many
    "docs/c.md": ("11_in_c.c", 2),
    "docs/files-in-cpp.md": ("08_files.cpp", 2),
    "docs/optimise.md": ("07_optimise.cpp", 5),
    "docs/own-blending.md": ("10_own_family.cpp", 1),
    "docs/performance.md": ("06_batch.cpp", 1),
}
PROJECTS = ["tests/package/consumer/CMakeLists.txt", "packaging/conan/test_package/CMakeLists.txt"]
GIVEN = pathlib.Path(__file__).resolve().with_name("given.hpp")
INCLUDE = re.compile(r"^#include <(.*)>$", re.M)
UNIT = """namespace {name} {{
int shown();
int shown() {{
#line {block.line} "{block.page}"
{code}
return 0;
}}
}}  // namespace {name}
"""


def shown():
    """Page -> its blocks, of those that have some."""
    pages = {}
    for block in all_blocks():
        if block.use in ("cpp", "c"):
            pages.setdefault(block.page, []).append(block)
    return pages


def of_no_example():
    """The namespace of given.hpp and the block, of each that is no part of an example."""
    for page, found in shown().items():
        stem = pathlib.Path(page).stem.lower().replace("-", "_")
        for number, block in enumerate(found[OF_EXAMPLE.get(page, ("", 0))[1]:], 1):
            yield f"{stem}_{number}", block


def unit():
    """One source with all of them, each as the body of a function."""
    found = list(of_no_example())
    includes = {include[0] for _, block in found for include in INCLUDE.finditer(block.text)}
    return "\n".join([f'#include "{GIVEN}"', *sorted(includes),
                      *(UNIT.format(name=name, block=block, code=INCLUDE.sub("", block.text)) for name, block in found)])


def words(text):
    return " ".join(text.split())


class Compiled(unittest.TestCase):
    def test_blocks_of_examples_are_parts_of_them(self):
        pages = shown()
        for page, (example, count) in OF_EXAMPLE.items():
            code = (ROOT / "examples" / example).read_text("utf-8")
            self.assertGreaterEqual(len(pages[page]), count, page)
            for block in pages[page][:count]:
                self.assertIn(words(INCLUDE.sub("", block.text)), words(code), block.place)
                self.assertLessEqual(set(INCLUDE.findall(block.text)), set(INCLUDE.findall(code)), block.place)

    def test_examples_print_what_pages_say(self):
        for page in map(name_of, PAGES):
            for block in outputs_of(page, "example"):
                self.assertIn(page, OF_EXAMPLE, block.place)
                expected = ROOT / "examples/expected" / pathlib.Path(OF_EXAMPLE[page][0]).with_suffix(".txt")
                self.assertIn(block.text, expected.read_text("utf-8"), block.place)

    def test_the_others_compile(self):
        commands = json.loads(pathlib.Path(sys.argv[1]).read_text("utf-8"))
        command = next(entry for entry in commands if entry["file"].endswith("examples/06_batch.cpp"))
        options = shlex.split(command["command"])
        done = subprocess.run([*options[:options.index("-o")], "-Wno-unused-variable", "-Wno-unused-but-set-variable", "-fsyntax-only", "-x", "c++", "-"],
                              cwd=command["directory"], input=unit(), capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_lines_of_cmake_are_those_of_projects_that_are_built(self):
        built = "".join((ROOT / project).read_text("utf-8") for project in PROJECTS)
        for block in (block for block in all_blocks() if block.use == "cmake"):
            for line in block.text.replace("your_target", "user").splitlines():
                self.assertIn(line.partition("#")[0].strip(), re.sub(r"\$\{\w+\} ", "", built), block.place)

    def test_nothing_is_given_to_blocks_that_are_gone(self):
        given = set(re.findall(r"^namespace (\w+) {", GIVEN.read_text("utf-8"), re.M)) - {"own"}
        self.assertEqual(given - {name for name, _ in of_no_example()}, set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
