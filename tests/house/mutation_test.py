#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tools/mutation finds the mutants of a source, leaves alone what the compiler must know, and picks a fair sample."""
import collections
import pathlib
import random
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.dont_write_bytecode = True
sys.path.insert(0, str(ROOT / "tools"))
from mutation.build import LIBRARY, candidates, equivalents, is_in, key_of, overlap, sampled  # noqa: E402
from mutation.mutants import mutants_of  # noqa: E402


def found(text):
    return [(m.kind, m.original, m.mutated) for m in mutants_of("curve/some.cpp", text)]


def body(statement):
    return found(f"void f() {{\n  {statement}\n}}\n")


class Equivalents(unittest.TestCase):
    def test_each_is_one_mutant_of_the_source_as_it_stands(self):
        known = equivalents()
        counts = collections.Counter()
        for file in {key[0] for key in known}:
            text = (ROOT / LIBRARY / file).read_text("utf-8")
            counts.update(key for key in (key_of(mutant, text) for mutant in mutants_of(file, text)) if key in known)
        self.assertEqual(counts, dict.fromkeys(known, 1))


class Folders(unittest.TestCase):
    def test_are_folders_or_patterns_of_files_and_without_any_all_but_a_few(self):
        def listed(folders):
            names = ("abi.hpp", "reduce/reduce.cpp", "reduce/hermite_keys.cpp", "scenes/gltf/json.cpp", "report/page.cpp",
                     "scenes/assimp.cpp")
            return [name for name in names if is_in(pathlib.PurePath(name), set(folders))]

        self.assertEqual(listed([]), ["reduce/reduce.cpp", "reduce/hermite_keys.cpp", "scenes/gltf/json.cpp"])
        self.assertEqual(listed(["report", "scenes"]), ["scenes/gltf/json.cpp", "report/page.cpp"])
        self.assertEqual(listed(["reduce/hermite_*", "gltf/*"]), ["reduce/hermite_keys.cpp", "scenes/gltf/json.cpp"])
        self.assertEqual(listed(["hermite_keys.cpp"]), [])

    def test_have_mutants_where_the_newest_code_is(self):
        for folder in ("clip", "scenes", "jobs", "reduce/hermite_*", "smooth/varying_*", "families/measured*", "least/*",
                     "families/biarcs*", "families/rational*"):
            self.assertGreater(len(candidates({folder})), 50, folder)


class Mutants(unittest.TestCase):
    def test_an_operator_is_swapped_in_all_that_it_binds(self):
        self.assertEqual(body("return a + b * c < d && e;"), [
            ("operator", "a + b * c", "a - b * c"), ("operator", "b * c", "b / c"),
            ("operator", "a + b * c < d", "a + b * c <= d"), ("operator", "a + b * c < d && e", "a + b * c < d || e")])

    def test_brackets_of_templates_are_no_operators(self):
        self.assertEqual(body("return f<2, double>(a) * std::vector<int>{b}.size();"),
                         [("operator", "f<2, double>(a) * std::vector<int>{b}.size()",
                           "f<2, double>(a) / std::vector<int>{b}.size()")])
        self.assertEqual(body("const T& a = b; T* c = &d; auto&& e = *f;"), [])

    def test_numbers_are_changed_as_their_kind_asks(self):
        self.assertEqual([mutated for _, _, mutated in body("f(0, 1u, 12, 0.0, 2.5, 1e-9, 0x10);")],
                         [";", "1", "0u", "1", "1.0", "2.5025", "1e-06"])

    def test_what_the_compiler_must_know_stays(self):
        for text in ("template <int N = 3>\nstruct A {};\n", "static_assert(1 + 1 == 2);\n", "enum class B { c = 1 };\n",
                     "// a + b\n#define C 1\nconst char* d = \"1 + 1\";\n", "constexpr std::array e{1, 2};\n",
                     "template <class T>\n  requires(sizeof(T) < 8)\nvoid g();\n", "class F {\n  F(int a);\n  void h();\n};\n"):
            self.assertEqual(found(text), [], text)
        self.assertEqual(body("if constexpr (N == 3) g<1>();"), [])

    def test_a_named_constant_becomes_a_variable(self):
        mutant, = mutants_of("curve/some.cpp", "constexpr double margin = 1e-9;\n")
        mutant.id = 7
        self.assertEqual(mutant.replacement(), "const double margin = (orispline_mutation::is_at_start(7) ? 1e-06 : 1e-9);")

    def test_conditions_are_negated_and_guards_are_never_met(self):
        self.assertEqual(body("if (auto a = f(); !a) return b;"),
                         [("negated", "!a", "!(!a)"), ("guard", "!a", "false")])
        self.assertEqual([kind for kind, _, _ in body("if (a) b = c;")], ["negated", "left out"])
        self.assertEqual(body("if (auto a = f()) return b;"), [])

    def test_statements_are_left_out_but_no_declarations(self):
        self.assertEqual(body("a.b[i] = c; double d = e; std::vector<T> h(k); ++n; f(g);"),
                         [("left out", text, ";") for text in ("a.b[i] = c;", "++n;", "f(g);")])
        self.assertIn(("operator", "a += b;", "a -= b;"), body("a += b;"))

    def test_lines_keep_their_numbers_and_a_sample_is_even(self):
        mutants = []
        for path in sorted((ROOT / LIBRARY / "base").glob("*.cpp")):
            text = path.read_text("utf-8")
            mutants += mutants_of(path.name, text)
            for m in mutants_of(path.name, text):
                self.assertEqual(m.replacement().count("\n"), text[m.start:m.end].count("\n"))
                self.assertEqual(text.count("\n", 0, m.start) + 1, m.line)
        self.assertGreater(len(mutants), 100)
        chosen = sampled(mutants, 40, random.Random(1))
        self.assertEqual([(m.file, m.start) for m in chosen],
                         [(m.file, m.start) for m in sampled(mutants, 40, random.Random(1))])
        self.assertFalse(any(overlap(a, b) for a in chosen for b in chosen if a is not b))
        lines = collections.Counter(file for file, _ in {(m.file, m.line) for m in mutants})
        for file, count in lines.items():
            share = 40 * count / sum(lines.values())
            self.assertLess(abs(sum(m.file == file for m in chosen) - share), 2.0, file)


if __name__ == "__main__":
    unittest.main()
