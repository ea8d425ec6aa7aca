#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What an installed tree promises without being compiled: interface_test.py PREFIX."""
import pathlib
import re
import sys
import unittest

SILENT = re.compile(r'R"(\w*)\(.*?\)\1"|"(\\.|[^"\\\n])*"|\'(\\.|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/|^#([^\n]*\\\n)*[^\n]*', re.M | re.S)
CLASS = re.compile(r"(template <.*> )?(class|struct|union|enum) ")
NO_FUNCTION = re.compile(r"using|friend|static_assert|[^(]*[^(]=[^=]|.*(= (default|delete|0)$|\b(inline|constexpr|concept)\b|\(\*)")
EXTERNAL = {"Eigen/Core", "Eigen/Geometry", "tl/expected.hpp"}


def statements(text):
    """(heads of the blocks around it, statement) of all that ends by a semicolon, outside bodies of functions."""
    text = SILENT.sub(" ", text)
    blocks, head, depth = [], 0, 0
    for mark in re.finditer(r"[(){};]|\b(public|private|protected):", text):
        depth += {"(": 1, ")": -1}.get(mark[0], 0)
        if mark[0] in "()" or depth:
            continue
        before = " ".join(text[head:mark.start()].split())
        if mark[0] == "{":
            blocks.append(before)
        elif mark[0] == "}":
            blocks.pop()
        elif before and all(block.startswith("namespace") or CLASS.match(block) for block in blocks):
            yield blocks[:], before
        head = mark.end()


def is_defined_below(statement, text):
    """Of a template: its header has its definition too, so that every caller makes its own."""
    name = re.search(r"(\w+)\(", statement)
    return name and statement.startswith("template") and re.search(rf"\b{name[1]}\([^;{{]*\)[^;{{]*{{", text)


def unmarked(text):
    """Declarations of functions that are defined elsewhere, where neither they nor their class are exported."""
    for blocks, statement in statements(text):
        words = re.sub(r"^template <[^>]*>+|\[\[\w+\]\]", "", statement).strip()
        classes = [block for block in blocks if not block.startswith("namespace")]
        is_member_template = classes and statement.startswith("template")
        if not re.match(r"([^[(]|operator\[)*\(", words) or NO_FUNCTION.match(words) or is_member_template:
            continue
        if is_defined_below(statement, text):
            continue
        if "ORISPLINE_EXPORT" not in (classes or [statement])[0]:
            yield statement


class Interface(unittest.TestCase):
    def setUp(self):
        self.include = PREFIX / "include"
        self.headers = {file.relative_to(self.include).as_posix(): file.read_text("utf-8")
                        for file in self.include.rglob("*.hpp")}
        self.includes = {name: set(re.findall(r"^#include <(\w[^>]*)>", text, re.M)) for name, text in self.headers.items()}
        self.public = [name for name in self.headers if name.count("/") == 1]

    def behind(self, name):
        found, unread = set(), {name}
        while unread:
            found |= unread
            unread = {each for one in unread for each in self.includes[one] if each in self.headers} - found
        return found

    def test_unmarked_declarations_are_seen(self):
        text = "#pragma once\nnamespace a {\nstruct X { int f() { return g({1}); } int h(int x = {}) const; };\nvoid g(X);\n" \
               "template <class T>\n[[nodiscard]] ORISPLINE_EXPORT T k(T);\nbool (*p)(int) = nullptr;\nint i() = delete;\n" \
               "template <class T> T l(T);\ntemplate <class T> T m(T x) { return l(x); }\ntemplate <class T> T l(T x) { return x; }\n" \
               "template <class T> T n(T);\n}\n"
        self.assertEqual(list(unmarked(text)), ["int h(int x = {}) const", "void g(X)", "template <class T> T n(T)"])

    def test_what_is_defined_elsewhere_is_exported(self):
        for name, text in self.headers.items():
            self.assertEqual(list(unmarked(text)), [], name)

    def test_headers_include_nothing_that_the_package_does_not_find(self):
        for name, includes in self.includes.items():
            others = {one for one in includes if "/" in one} - set(self.headers)
            self.assertLessEqual(others, EXTERNAL, name)

    def test_public_headers_hold_callers_to_the_alignment(self):
        self.assertTrue(self.public)
        for name in self.public:
            self.assertIn("orispline/math/eigen.hpp", self.behind(name), name)

    def test_cmake_older_than_file_sets_gets_the_include_folder(self):
        (targets,) = PREFIX.rglob("orisplineTargets.cmake")
        text = targets.read_text("utf-8")
        plain = re.search(r"set_target_properties\(orispline::headers PROPERTIES\s(.*?)\n\)", text, re.S)[1]
        self.assertIn('INTERFACE_INCLUDE_DIRECTORIES "${_IMPORT_PREFIX}/include"', plain)

    def test_licence_and_notice_are_there(self):
        self.assertEqual({file.name for file in (PREFIX / "share/doc/orispline").iterdir()}, {"LICENSE", "NOTICE", "THIRD_PARTY"})


if __name__ == "__main__":
    PREFIX = pathlib.Path(sys.argv.pop(1))
    unittest.main()
