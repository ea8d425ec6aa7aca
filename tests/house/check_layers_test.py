#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""check_layers.py finds each kind of breach in a small tree that is sound otherwise."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "check_layers.py"
SPDX = "// SPDX-License-Identifier: Apache-2.0\n"
HEADER = SPDX + "#pragma once\n"
SOUND = {
    "src/orispline/math/so3.hpp": HEADER,
    "src/orispline/curve/knots.hpp": HEADER + "#include <orispline/math/so3.hpp>\n",
    "src/orispline/families/slerp.hpp": HEADER + "#include <orispline/curve/knots.hpp>\n",
    "src/orispline/io/csv.cpp": SPDX + "#include <fast_float/fast_float.h>\n#include <orispline/curve/knots.hpp>\n",
    "src/orispline/orispline.hpp": HEADER + "#include <orispline/families/slerp.hpp>\n",
    "src/orispline/sampling.hpp": HEADER + "#include <orispline/batch/sample.hpp>\n",
    "src/orispline/pages/page.hpp": HEADER + "#include <orispline/curve/knots.hpp>\n",
    "cli/options/text.hpp": HEADER + "#include <orispline/orispline.hpp>\n",
    "cli/output/summary.hpp": HEADER + '#include "options/text.hpp"\n',
    "cli/commands/smooth/smooth.hpp": HEADER + '#include "options/text.hpp"\n#include "output/summary.hpp"\n',
    "cli/commands/smooth/smooth.cpp": SPDX + '#include "commands/smooth/smooth.hpp"\n',
    "papers/table.cpp": SPDX + '#include "output/summary.hpp"\n',
    "cli/main.cpp": SPDX + '#include <orispline/orispline.hpp>\n#include "commands/smooth/smooth.hpp"\n',
    "tools/simulate.py": "#!/usr/bin/env python3\n" + SPDX.replace("//", "#"),
}


def report(**changes):
    """What the script says about the sound tree with some files replaced or added; exit code 0 gives None."""
    with tempfile.TemporaryDirectory() as tree:
        for path, text in (SOUND | changes.get("files", {})).items():
            file = pathlib.Path(tree, path)
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, "utf-8")
        run = subprocess.run([sys.executable, SCRIPT, tree], capture_output=True, text=True, check=False)
        return run.stderr if run.returncode else None


def function_of(lines, head="int f(int a) {"):
    return head + "\n" + "  a += 1;\n" * (lines - 2) + "}\n"


class CheckLayers(unittest.TestCase):
    def assert_breach(self, path, text, message):
        self.assertIn(message, report(files={path: text}) or "no breach")

    def assert_sound(self, path, text):
        self.assertIsNone(report(files={path: text}))

    def test_accepts_a_sound_tree(self):
        self.assertIsNone(report())

    def test_finds_an_include_upwards(self):
        self.assert_breach("src/orispline/math/so3.hpp", HEADER + "#include <orispline/curve/keyframe.hpp>\n",
                           "math/so3.hpp: layer math must not include orispline/curve/keyframe.hpp")

    def test_finds_a_part_of_the_interface_to_c_that_needs_more_than_it_may(self):
        text = SPDX + "#include <orispline/batch/sample.hpp>\n"
        self.assert_breach("bindings/c/curve.cpp", text,
                           "bindings/c/curve.cpp: this part of the interface must not include orispline/batch/sample.hpp")
        self.assert_sound("bindings/c/bake.cpp", text)
        self.assert_breach("bindings/c/orispline.h", "int f(void);\n", "bindings/c/orispline.h: the first line is not the SPDX line")

    def test_finds_an_example_that_includes_a_private_header(self):
        self.assert_breach("examples/story.cpp", SPDX + "#include <orispline/curve/knots.hpp>\n",
                           "examples/story.cpp: wanted a public header")

    def test_finds_an_include_of_a_neighbouring_folder(self):
        self.assert_breach("src/orispline/io/csv.cpp", SPDX + "#include <orispline/families/slerp.hpp>\n",
                           "layer io must not include orispline/families/slerp.hpp")

    def test_finds_the_umbrella_header_inside_the_library(self):
        self.assert_breach("src/orispline/io/csv.cpp", SPDX + "#include <orispline/orispline.hpp>\n", "layer io must not")

    def test_finds_a_folder_that_is_no_layer(self):
        self.assert_breach("src/orispline/unknown/box.cpp", SPDX + "#include <orispline/math/so3.hpp>\n", "layer unknown")

    def test_finds_a_page_that_reads_files(self):
        self.assert_breach("src/orispline/pages/page.hpp", HEADER + "#include <orispline/io/csv.hpp>\n",
                           "layer pages must not include orispline/io/csv.hpp")

    def test_finds_a_task_that_draws_pages(self):
        self.assert_breach("src/orispline/smooth/smooth.cpp", SPDX + "#include <orispline/pages/page.hpp>\n",
                           "layer smooth must not include orispline/pages/page.hpp")

    def test_finds_a_job_that_opens_files(self):
        self.assert_breach("src/orispline/jobs/retime.cpp", SPDX + "#include <orispline/io/csv.hpp>\n",
                           "layer jobs must not include orispline/io/csv.hpp")

    def test_finds_a_binding_that_composes(self):
        for path in ("cli/commands/retime/retime.cpp", "bindings/python/core/tasks.cpp"):
            for name in ("retime/retime.hpp", "online/online_curve.hpp"):
                self.assert_breach(path, SPDX + f"#include <orispline/{name}>\n", f"{path}: the command and the bindings must not include orispline/{name}")
            for name in ("jobs/retime.hpp", "io/formats/csv.hpp", "retime.hpp", "base/formatted.hpp", "families/registry.hpp", "families/slerp.hpp"):
                self.assert_sound(path, SPDX + f"#include <orispline/{name}>\n")
        self.assert_sound("papers/table.cpp", SPDX + "#include <orispline/retime/retime.hpp>\n")

    def test_finds_includes_upwards_in_the_command(self):
        for path, name in (("options/text.hpp", "output/summary.hpp"), ("output/summary.hpp", "commands/smooth/smooth.hpp"),
                           ("options/text.hpp", "commands/smooth/smooth.hpp"), ("papers/table.cpp", "commands/smooth/smooth.hpp")):
            self.assert_breach(f"cli/{path}", HEADER + f'#include "{name}"\n',
                               f"cli/{path}: layer {path.partition('/')[0]} of the command must not include {name}")

    def test_finds_a_command_that_knows_another(self):
        self.assert_breach("cli/commands/reduce/reduce.cpp", SPDX + '#include "commands/smooth/smooth.hpp"\n',
                           "reduce.cpp: layer commands/reduce of the command must not include commands/smooth/smooth.hpp")

    def test_finds_a_folder_of_the_command_that_is_no_layer(self):
        self.assert_breach("cli/unknown/box.cpp", SPDX + '#include "options/text.hpp"\n', "layer unknown of the command must not include")

    def test_finds_a_circle_in_the_command(self):
        circle = {"cli/options/a.hpp": HEADER + '#include "options/b.hpp"\n', "cli/options/b.hpp": HEADER + '#include "options/a.hpp"\n'}
        self.assertIn("include circle: cli/options/", report(files=circle) or "no breach")

    def test_finds_a_circle_in_one_layer(self):
        circle = {"src/orispline/math/a.hpp": HEADER + "#include <orispline/math/b.hpp>\n",
                  "src/orispline/math/b.hpp": HEADER + "#include <orispline/math/a.hpp>\n"}
        self.assertIn("include circle: src/orispline/math/", report(files=circle) or "no breach")

    def test_finds_third_party_code_in_the_wrong_place(self):
        self.assert_breach("src/orispline/math/so3.hpp", HEADER + "#include <nlohmann/json.hpp>\n",
                           "nlohmann/json.hpp is for cli/output/json_document.cpp or src/orispline/io/blending_file.cpp or src/orispline/scenes/gltf/ or tests/c/ or tests/bindings/ only")

    def test_finds_an_include_with_quotes(self):
        self.assert_breach("src/orispline/io/csv.cpp", SPDX + '#include "csv.hpp"\n', "found one with quotes")

    def test_finds_a_flag_of_the_command_in_the_library(self):
        for literal in ('"wanted --sort-rows"', '"(--euler ORDER)"', 'R"x(by --ends\n)x"'):
            self.assert_breach("src/orispline/io/csv.cpp", SPDX + f"f({literal});\n", "is a word of the command")
            self.assert_sound("cli/main.cpp", SPDX + f"f({literal});\n")
        self.assert_sound("src/orispline/io/csv.cpp", SPDX + 'int b = --a;  // "--sort"\nf("a--b", "--", "---c");\n')

    def test_finds_functions_whose_bits_are_not_the_same_everywhere(self):
        for path in ("src/orispline/curve/knots.cpp", "cli/main.cpp", "bindings/python/core/curve.cpp"):
            for call in ("std::exp(a)", "std::atan2(a, b)", "::hypot(a, b)", "std::powf(a, b)", "std::log10(a)", "std::cosh(a)"):
                self.assert_breach(path, SPDX + f"double f(double a, double b) {{ return {call}; }}\n", "has other bits elsewhere")
            for sound in ("std::sqrt(a)", "std::expected(a)", "std::abs(a)", "exp<double>(a)", "elementary::exponential(a)", "other::log(a)"):
                self.assert_sound(path, SPDX + f"double f(double a) {{ return {sound}; }}  // not std::hypot(a, b)\n")
        self.assert_sound("papers/table.cpp", SPDX + "double f(double a) { return std::exp(a); }\n")

    def test_finds_a_result_that_may_be_dropped(self):
        for declaration in ("Expected<void> append(int key);", "  static Expected<Key> make(int a,\n int b);"):
            self.assert_breach("src/orispline/io/csv.hpp", SPDX + "#pragma once\n" + declaration, "wanted [[nodiscard]]")
        for sound in ("[[nodiscard]] Expected<void> append(int key);", "Expected<void> (*tracks)(int);",
                      "friend Expected<int> made(int);", "/// Expected<void> f(int) in words"):
            self.assert_sound("src/orispline/io/csv.hpp", SPDX + "#pragma once\n" + sound)

    def test_finds_two_classes_of_one_name(self):
        text = SPDX + "namespace orispline { inline namespace V1 {\n%s\nstruct Stretch final : Base {\n};\n%s}}\n"
        plain, hidden = text % ("", ""), text % ("namespace {", "}  // namespace\n")
        again = {"src/orispline/curve/a.cpp": plain, "src/orispline/io/b.cpp": plain}
        self.assertIn("src/orispline/io/b.cpp: line 4: orispline::V1::Stretch is the name of another class, in "
                      "src/orispline/curve/a.cpp: line 4", report(files=again))
        self.assertIsNone(report(files=again | {"src/orispline/io/b.cpp": hidden}))
        inner = plain.replace("struct", "struct Outer {\nstruct")
        self.assertIsNone(report(files=again | {"src/orispline/io/b.cpp": inner.replace("};", "};};")}))

    def test_finds_a_file_of_601_lines(self):
        self.assert_sound("cli/main.cpp", SPDX + "int a;\n" * 599)
        self.assert_breach("cli/main.cpp", SPDX + "int a;\n" * 600, "cli/main.cpp: 601 lines, at most 600")

    def test_finds_a_function_of_61_lines(self):
        for head in ("int f(int a) {", "template <class T>\nint f(T a)\n    requires(true) {", "TEST(Csv, Reads) {",
                     "namespace n {\nstruct S {\nint a;\nS(int b) : a(b) {"):
            tail = "};\n}\n" if "struct" in head else ""
            extra = head.count("\n") if "template" in head else 0
            self.assert_sound("cli/main.cpp", SPDX + function_of(60 - extra, head) + tail)
            self.assert_breach("cli/main.cpp", SPDX + function_of(61 - extra, head) + tail, "function of 61 lines at line")

    def test_looks_behind_the_lines_of_the_preprocessor(self):
        includes = "#include <string>\n\n#define TWO \\\n  2\n"
        self.assert_breach("cli/main.cpp", SPDX + includes + function_of(61, "int f(int a) {"), "function of 61 lines at line")

    def test_does_not_take_a_class_or_namespace_for_a_function(self):
        for head in ("namespace n {", "struct S {", "class S final : public T<f(1)> {", "template <class T> struct S {"):
            self.assert_sound("cli/main.cpp", SPDX + head + "\n" + "int a = f('{', \"{\");  // }\n" * 70 + "};\n")

    def test_finds_a_long_python_function(self):
        body = SOUND["tools/simulate.py"] + "def f(a):\n" + "    a += 1\n" * 59
        self.assert_sound("tools/simulate.py", body)
        self.assert_breach("tools/simulate.py", body + "    a += 1\n", "function of 61 lines at line 3")

    def test_finds_a_median_of_200_lines(self):
        self.assertIn("the median file has 201", report(files={p: t + "\n" * (201 - t.count("\n")) for p, t in SOUND.items()}))

    def test_finds_a_missing_licence_line(self):
        self.assert_breach("cli/main.cpp", "int a;\n", "cli/main.cpp: the first line is not the SPDX line")

    def test_finds_a_header_without_pragma_once(self):
        self.assert_breach("src/orispline/math/so3.hpp", SPDX, "so3.hpp: no #pragma once")

    def test_finds_a_name_that_says_nothing(self):
        self.assert_breach("src/orispline/math/utils.hpp", HEADER, "utils.hpp: this name does not say what is in it")
        self.assert_breach("cli/detail/print.cpp", SPDX, "detail/print.cpp: this name does not say what is in it")


if __name__ == "__main__":
    unittest.main()
