#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What others pack orispline by states the version and the dependencies of CMakeLists.txt, and no sum that nobody has counted."""
import ast
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from xml.etree import ElementTree

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
import recipes  # noqa: E402

SYSTEMS = ("debian", "vcpkg", "conan", "conda", "homebrew", "ros")
# A package of CMake, and what each system calls it.
NAMES = {
    "Eigen3": ("libeigen3-dev", "eigen3", "eigen", "eigen", "eigen", "eigen"),
    "tl-expected": ("libexpected-dev", "tl-expected", "tl-expected", "cpp-expected", "tl-expected", "libexpected-dev"),
    "fmt": ("libfmt-dev", "fmt", "fmt", "fmt", "fmt", "fmt"),
    "FastFloat": ("libfast-float-dev", "fast-float", "fast_float", "fast_float", "fast_float", "fast_float"),
    "nlohmann_json": ("nlohmann-json3-dev", "nlohmann-json", "nlohmann_json", "nlohmann_json", "nlohmann-json", "nlohmann-json-dev"),
    "CLI11": ("libcli11-dev", "cli11", "cli11", "cli11", "cli11", "cli11"),
}
INTERFACE = {"Eigen3", "tl-expected"}  # which users of the library need too, as the CMake package and orispline.pc say
NOT_PACKED = {"ORISPLINE_ASSIMP", "ORISPLINE_BENCHMARKS"}
TOOLS = {"cmake", "ninja", "ninja-build", "vcpkg-cmake", "vcpkg-cmake-config", "ccache", "g++"}
OPTIONAL = {"libmeshoptimizer-dev"}  # without it files that it compresses are refused
NOT_RUN = ("packaging/vcpkg/portfile.cmake", "packaging/vcpkg/vcpkg.json", "packaging/conan/conanfile.py", "packaging/conan/conandata.yml",
           "packaging/conan/test_package/conanfile.py", "packaging/conan/test_package/CMakeLists.txt", "packaging/conda/recipe.yaml",
           "packaging/homebrew/orispline.rb", "package.xml",
           *(str(path.relative_to(ROOT)) for path in sorted((ROOT / ".github/workflows").glob("*.yml"))))


def text_of(path):
    return (ROOT / path).read_text("utf-8")


def dependencies():
    """The packages of the `orispline_dependency` calls that are packed, with the options that want them."""
    calls = []
    for path in ("CMakeLists.txt", "cli/CMakeLists.txt"):
        calls += re.findall(r"(?m)^\s*orispline_dependency\((\S+?)(?: [\d.]+)?(?: OPTION (\w+))?\)", text_of(path))
    found = {}
    for package, option in calls:
        if option not in NOT_PACKED:
            found.setdefault(package, set()).add(option)
    return found


def called(system, packages):
    return {NAMES[package][SYSTEMS.index(system)] for package in packages}


def wanted_by(option):
    return {package for package, options in dependencies().items() if option in options}


def plain(dependencies_of_vcpkg):
    return {item for item in dependencies_of_vcpkg if isinstance(item, str)}


class Recipes(unittest.TestCase):
    def test_every_file_states_the_version_of_the_project(self):
        version = recipes.version_of(ROOT)
        self.assertEqual({path: recipes.stated_version(path, text_of(path)) for path in recipes.VERSIONED},
                         dict.fromkeys(recipes.VERSIONED, version))

    def test_another_version_is_written_everywhere_and_nothing_else(self):
        for path in recipes.VERSIONED:
            there = text_of(path)
            other = recipes.with_version(path, there, "12.34.56")
            self.assertEqual(recipes.stated_version(path, other), "12.34.56", path)
            self.assertEqual(recipes.with_version(path, other, recipes.version_of(ROOT)), there, path)

    def test_the_table_of_names_is_of_the_dependencies_of_cmake(self):
        self.assertEqual(set(dependencies()), set(NAMES))

    def test_setup_installs_all_of_them(self):
        listed = re.findall(r"(?m)^build (\S+)", text_of("tools/setup.sh"))
        self.assertEqual({name.rstrip("?") for name in listed} - TOOLS - OPTIONAL, called("debian", NAMES))

    def test_vcpkg_has_them_by_features(self):
        root, port = json.loads(text_of("vcpkg.json")), json.loads(text_of("packaging/vcpkg/vcpkg.json"))
        for manifest in (root, port):
            self.assertEqual(plain(manifest["dependencies"]), called("vcpkg", wanted_by("")))
            self.assertEqual(plain(manifest["features"]["io"]["dependencies"]), called("vcpkg", wanted_by("ORISPLINE_IO")))
            # the command's other dependency comes with the feature that it needs
            self.assertEqual(plain(manifest["features"]["cli"]["dependencies"]),
                             called("vcpkg", wanted_by("ORISPLINE_CLI") - wanted_by("ORISPLINE_IO")))
        for key in ("name", "description", "license", "default-features"):
            self.assertEqual(root[key], port[key])
        self.assertEqual({name: root["features"][name] for name in port["features"]}, port["features"])
        self.assertEqual(set(root["features"]) - set(port["features"]), {"tests", "benchmarks"})
        stated = re.search(r"FEATURES (.*)\)", text_of("packaging/vcpkg/portfile.cmake"))[1].split()
        self.assertEqual(dict(zip(stated[::2], stated[1::2])), {name: f"ORISPLINE_{name.upper()}" for name in port["features"]})

    def test_conan_requires_them_by_options(self):
        text = text_of("packaging/conan/conanfile.py")
        blocks = re.split(r"if self\.options\.(\w+):", re.search(r"def requirements.*?(?=\n    def )", text, re.S)[0])
        stated = {"": blocks[0], **dict(zip(blocks[1::2], blocks[2::2]))}
        required = {option: set(re.findall(r'requires\("([\w-]+)/', block)) for option, block in stated.items()}
        self.assertEqual(required, {"": called("conan", wanted_by("")), "io": called("conan", wanted_by("ORISPLINE_IO")),
                                    "cli": called("conan", wanted_by("ORISPLINE_CLI") - wanted_by("ORISPLINE_IO"))})
        self.assertEqual(set(re.findall(r'"([\w-]+)/[^"]*", transitive_headers=True', text)), called("conan", INTERFACE))

    def test_conda_lists_them(self):
        lists = dict(re.findall(r"(?m)^  (host|run):\n((?:    - .*\n)+)", text_of("packaging/conda/recipe.yaml")))
        names = {key: set(re.findall(r"- ([\w-]+)", block)) for key, block in lists.items()}
        self.assertEqual(names, {"host": called("conda", NAMES), "run": called("conda", INTERFACE)})

    def test_homebrew_depends_on_them(self):
        stated = dict(re.findall(r'(?m)^  depends_on "([\w-]+)"( => :build)?$', text_of("packaging/homebrew/orispline.rb")))
        self.assertEqual(set(stated) - TOOLS, called("homebrew", NAMES))
        self.assertEqual({name for name, build in stated.items() if not build}, called("homebrew", INTERFACE))

    def test_ros_depends_on_them(self):
        package = ElementTree.fromstring(text_of("package.xml"))
        both, build = ({item.text for item in package.findall(kind)} for kind in ("depend", "build_depend"))
        self.assertEqual((both, both | build), (called("ros", INTERFACE), called("ros", NAMES)))
        self.assertEqual((package.find("name").text, package.find("export/build_type").text), ("orispline", "cmake"))

    def test_all_ask_for_the_same_eigen_and_cmake(self):
        eigen = re.search(r"orispline_dependency\(Eigen3 ([\d.]+)\)", text_of("CMakeLists.txt"))[1]
        cmake = re.search(r"cmake_minimum_required\(VERSION ([\d.]+)\)", text_of("CMakeLists.txt"))[1]
        self.assertIn(f"eigen/[>={eigen} <4]", text_of("packaging/conan/conanfile.py"))
        self.assertIn(f"cmake/[>={cmake} <5]", text_of("packaging/conan/conanfile.py"))
        self.assertEqual(text_of("packaging/conda/recipe.yaml").count(f"- eigen >={eigen}\n"), 2)
        self.assertIn(f"- cmake >={cmake}\n", text_of("packaging/conda/recipe.yaml"))

    def test_every_file_says_first_what_was_not_run(self):
        for path in NOT_RUN:
            self.assertRegex("\n".join(text_of(path).splitlines()[:2]), r"(?i)\bnot (run|built)\b", path)
        self.assertGreaterEqual(len(NOT_RUN), 12)

    def test_there_is_no_sum_and_no_address_that_a_release_has_not_given(self):
        source = json.loads(text_of("packaging/source.json"))
        self.assertEqual(set(source), {"$comment", "repository", "archive"})
        for folder in recipes.SYSTEMS:
            for path in (ROOT / "packaging" / folder).rglob("*"):
                if path.is_file() and "__pycache__" not in path.parts:
                    text = path.read_text("utf-8")
                    self.assertIsNone(re.search(r"[0-9a-fA-F]{64}|https?://", text), path)
        self.assertIn("{version}", source["archive"] or "{version}")

    def test_the_sums_of_an_archive_are_filled_in(self):
        with tempfile.TemporaryDirectory() as place:
            root, folder, archive = pathlib.Path(place, "root"), pathlib.Path(place, "filled"), pathlib.Path(place, "a.tar.gz")
            shutil.copytree(ROOT / "packaging", root / "packaging")
            shutil.copy(ROOT / "CMakeLists.txt", root)
            archive.write_bytes(b"sources")
            address = "https://example.invalid/orispline-{version}.tar.gz"
            (root / "packaging/source.json").write_text(json.dumps({"repository": "https://example.invalid", "archive": address}), "utf-8")
            recipes.fill(root, archive, folder)
            texts = {path.name: path.read_text("utf-8") for path in folder.rglob("*") if path.is_file()}
        for name in ("conandata.yml", "recipe.yaml", "orispline.rb"):
            self.assertIn(hashlib.sha256(b"sources").hexdigest(), texts[name])
            self.assertIn(address.replace("{version}", recipes.version_of(ROOT)), texts[name])
        self.assertIn(hashlib.sha512(b"sources").hexdigest(), texts["portfile.cmake"])
        self.assertEqual([name for name, text in texts.items() if re.search(r"@[A-Z0-9]+@", text)], [])

    def test_an_address_that_is_not_known_keeps_its_place(self):
        with tempfile.TemporaryDirectory() as place:
            archive = pathlib.Path(place, "a.tar.gz")
            archive.write_bytes(b"sources")
            filled = recipes.places_for(archive, {"repository": None, "archive": None}, "1.2.3")
        self.assertEqual(set(filled), {"@SHA256@", "@SHA512@"})

    def test_no_archive_and_a_folder_that_is_there_are_refused(self):
        with tempfile.TemporaryDirectory() as place:
            for archive, folder, sentence in (("none.tar.gz", "new", "found no file none.tar.gz"), (__file__, place, f"found {place}, wanted a folder")):
                done = subprocess.run([sys.executable, ROOT / "tools/recipes.py", "fill", archive, folder], capture_output=True, text=True, check=False)
                self.assertEqual((done.returncode, done.stderr.count("\n")), (1, 1))
                self.assertIn(sentence, done.stderr)

    def test_the_recipe_of_conan_is_python_and_that_of_homebrew_is_ruby(self):
        for path in ("packaging/conan/conanfile.py", "packaging/conan/test_package/conanfile.py"):
            ast.parse(text_of(path))
        if not shutil.which("ruby"):
            self.skipTest("ruby is not here")
        subprocess.run(["ruby", "-c", ROOT / "packaging/homebrew/orispline.rb"], check=True, capture_output=True)


class Workflows(unittest.TestCase):
    FILES = sorted((ROOT / ".github/workflows").glob("*.yml"))

    def test_they_may_read_only(self):
        for path in self.FILES:
            self.assertEqual(re.findall(r"(?m)^ *permissions:\n((?:  \S.*\n)+)", path.read_text("utf-8")), ["  contents: read\n"], path.name)

    def test_actions_are_named_by_commit_with_their_tag(self):
        uses = [line.strip() for path in self.FILES for line in path.read_text("utf-8").splitlines() if "uses:" in line]
        self.assertGreaterEqual(len(uses), 6)
        for line in uses:
            self.assertRegex(line, r"^- uses: [\w-]+/[\w-]+@[0-9a-f]{40}  # v\d+\.\d+\.\d+$")

    def test_they_call_targets_of_the_makefile_that_there_are(self):
        targets = set(re.search(r"(?m)^\.PHONY: (.*)$", text_of("Makefile"))[1].split())
        called_by = {path.name: set(re.findall(r"(?m)^ *- run: make (\S+)$", path.read_text("utf-8"))) for path in self.FILES}
        self.assertEqual(called_by, {"site.yml": {"site"}, "tests.yml": {"test"}, "wheels.yml": set()})
        self.assertLessEqual(set().union(*called_by.values()), targets)


if __name__ == "__main__":
    unittest.main()
