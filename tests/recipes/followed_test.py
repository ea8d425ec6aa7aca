#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The recipes of CONTRIBUTING.md, followed in a copy of the tree: followed_test.py FOLDER, where the copy is built.

What each recipe promises has to be in the command that is built there. The sources that a recipe names, and no others, are changed for it.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests/house"))
from contributing_test import paths_in, recipes  # noqa: E402

FOLDER = pathlib.Path(sys.argv[1])
COPIED = ("CMakeLists.txt", "LICENSE", "NOTICE", "THIRD_PARTY", "README.md", "CHANGELOG.md", "cli", "cmake", "docs", "examples", "papers", "src")
FAMILIES, FORMATS, SOURCES = "src/orispline/families", "src/orispline/io", "src/orispline/CMakeLists.txt"
SCENE_FORMAT = """// SPDX-License-Identifier: Apache-2.0
#include <orispline/scenes/scene_file.hpp>

namespace orispline { inline namespace ORISPLINE_ABI { namespace scenes {

namespace {
constexpr std::array<std::string_view, 1> my_extensions{".moves"};
Expected<Scene> read_moves(std::string_view bytes, const io::Input& from, const SceneReading& reading) {
  return bvh_format.read(bytes, from, reading);
}
}  // namespace

const SceneFormat my_format{
    .id = "moves", .title = "Moves", .file = "a file of moves", .summary = "BVH by another name", .extensions = my_extensions, .read = read_moves};

}}}  // namespace orispline::scenes
"""
EXPERIMENT = """// SPDX-License-Identifier: Apache-2.0
#include "papers/experiment.hpp"

namespace orispline::cli {
Expected<Findings> experiment::my_experiment() { return sudden_turn(); }
}  // namespace orispline::cli
"""


def behind(anchor, text):
    """Puts a text behind what stands in a file once."""
    def edit(old):
        assert old.count(anchor) == 1, f"found {old.count(anchor)} times {anchor!r}, wanted it once"
        return old.replace(anchor, anchor + text)
    return edit


def all_of(*edits):
    def edit(old):
        for one in edits:
            old = one(old)
        return old
    return edit


def copy_of(path, **words):
    """A new file that is another one with other words."""
    def edit(_):
        text = (ROOT / path).read_text("utf-8")
        for old, new in words.items():
            text = text.replace(old, new)
        return text
    return edit


FOLLOWED = {  # recipe -> source -> its change
    "Add a method": {
        f"{FAMILIES}/my_curve.hpp": copy_of(f"{FAMILIES}/slerp.hpp", Slerp="MyCurve", **{'"slerp"': '"my-curve"'}),
        f"{FAMILIES}/families.hpp": all_of(behind("#include <orispline/families/measured.hpp>\n", "#include <orispline/families/my_curve.hpp>\n"),
                                           behind("families::Measured", ", families::MyCurve"))},
    "Add a format of keys": {
        f"{FORMATS}/formats/my_format.cpp": copy_of(f"{FORMATS}/formats/tum.cpp", tum="mine", TUM="Mine"),
        f"{FORMATS}/file_format.hpp": all_of(behind("npy_format;", "\nextern const FormatInfo mine_format;"), behind("&npy_format", ", &mine_format")),
        SOURCES: behind("  io/formats/euroc.cpp\n", "  io/formats/my_format.cpp\n")},
    "Add a format of skeletons": {
        "src/orispline/scenes/my_format/my_format.cpp": lambda _: SCENE_FORMAT,
        "src/orispline/scenes/scene_file.hpp": behind("bvh_format, gltf_format", ", my_format"),
        "src/orispline/scenes/scene_format.cpp": behind("&gltf_format", ", &my_format"),
        SOURCES: behind("  scenes/gltf/skeleton.cpp\n", "  scenes/my_format/my_format.cpp\n")},
    "Add an option": {
        "src/orispline/smooth/smooth.hpp": behind("struct SmoothOptions {\n", "  double my_share = 0.5;  ///< 0 to 1\n"),
        "src/orispline/smooth/smooth_fields.cpp": behind(
            "span<const FieldInfo> fields_of<SmoothOptions>() noexcept {\n  static constexpr std::array fields{\n",
            '      field<&SmoothOptions::my_share>({.name = "my_share", .sentence = "A share that changes nothing", .range = {0.0, 1.0}}),\n')},
    "Add a measure": {
        "src/orispline/analysis/measure_list.cpp": behind(
            "to_array<MeasureInfo>({\n",
            '    {.group = MeasureGroup::distance, .id = "half_deg", .word = "half", .label = "half", .unit = "deg", .explanation = "The median once more", '
            ".value = measure_value::angle<&D::median>},\n")},
    "Add an experiment of a paper": {
        "papers/my_experiment.cpp": lambda _: EXPERIMENT,
        "papers/experiment.hpp": behind("Expected<Findings> sudden_turn();\n", "[[nodiscard]] Expected<Findings> my_experiment();\n"),
        "papers/experiments.cpp": behind("std::array list{\n", '    Experiment{"000-mine", "Mine", experiment::my_experiment},\n'),
        "cli/CMakeLists.txt": behind("  ../papers/sudden_turn.cpp\n", "  ../papers/my_experiment.cpp\n")},
}


def follow(tree):
    for edits in FOLLOWED.values():
        for name, edit in edits.items():
            path = tree / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(edit(path.read_text("utf-8") if path.is_file() else ""), "utf-8")


def build(tree):
    """The command, without optimisation, which takes minutes all the same."""
    shutil.rmtree(tree, ignore_errors=True)
    tree.mkdir(parents=True)
    for name in COPIED:
        copied = shutil.copytree if (ROOT / name).is_dir() else shutil.copy
        copied(ROOT / name, tree / name)
    follow(tree)
    options = ["-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0", "-DORISPLINE_C=OFF", "-DORISPLINE_PAGE=OFF", "-DORISPLINE_INSTALL=OFF"]
    subprocess.run(["cmake", "-S", tree, "-B", tree / "build", "-G", "Ninja", *options], check=True)
    subprocess.run(["cmake", "--build", tree / "build", "-j", "2", "--target", "orispline-cli"], check=True)
    return next(tree.joinpath("build").rglob("orispline"))


class Followed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.command = build(FOLDER / "tree")

    def printed(self, *words):
        return subprocess.run([self.command, *words], cwd=ROOT, check=True, capture_output=True, text=True).stdout

    def test_recipes_name_the_sources_that_are_changed(self):
        for title, edits in FOLLOWED.items():
            named = {path for path in paths_in(recipes()[title]) if path.startswith(("src/", "cli/", "papers/")) and not path.endswith("sudden_turn.cpp")}
            self.assertLessEqual(set(edits), named, title)

    def test_a_method_is_where_methods_are(self):
        self.assertIn("my-curve", [method["name"] for method in json.loads(self.printed("methods", "--json"))])
        rows = [self.printed("sample", "examples/data/five_keys.csv", "--method", name, "--count", "9") for name in ("slerp", "my-curve")]
        self.assertEqual(*rows)

    def test_a_format_is_written_and_read_by_its_name(self):
        keys = FOLDER / "keys.mine"
        self.printed("convert", "examples/data/five_keys.csv", "-o", keys)
        self.assertIn("5, 0 to", self.printed("inspect", keys))
        self.assertRegex(self.printed("help", "convert"), r"tum\|euroc\|npy\|mine|csv\|.*mine")

    def test_a_format_of_skeletons_is_read_by_its_name(self):
        walk = FOLDER / "walk.moves"
        shutil.copy(ROOT / "examples/data/walking.bvh", walk)
        self.assertIn("walk.moves (Moves)", self.printed("inspect", walk))

    def test_an_option_is_in_the_command_and_in_the_list_of_tasks(self):
        self.assertIn("--my-share", self.printed("help", "smooth"))
        smooth = next(task for task in json.loads(self.printed("tasks", "--json")) if task["task"] == "smooth")
        self.assertEqual([(option["default"], option["highest"]) for option in smooth["options"] if option["name"] == "my_share"], [(0.5, 1.0)])
        done = subprocess.run([self.command, "smooth", "examples/data/five_keys.csv", "--my-share", "2"], cwd=ROOT, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 2)
        self.assertIn("--my-share", done.stderr)

    def test_a_measure_is_in_the_document_and_sorts(self):
        rows = json.loads(self.printed("compare", "examples/data/flight_truth.csv", "--keep-every", "400", "--methods", "slerp,auto", "--sort", "half", "--json"))
        for row in rows:
            self.assertEqual(row["half_deg"], row["median_deg"])

    def test_an_experiment_is_run_by_its_name(self):
        self.assertIn("000-mine", self.printed("reproduce"))
        self.assertIn("inner knot", self.printed("reproduce", "000-mine"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
