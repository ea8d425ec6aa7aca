#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Debian packages as they are described: version, dependencies and notices are those that the project states elsewhere."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
from make_deb import COMPILED_IN, IN_PAGE, PAGE, PARTS  # noqa: E402

TOOL = ROOT / "tools/make_deb.py"
BUILD_TOOLS = {"debhelper-compat", "cmake", "ninja-build"}
OPTIONAL = {"assimp"}  # of a build that the packages are not


def read(path):
    return (ROOT / path).read_text("utf-8")


def plain(name):
    """A package by its letters: Debian and CMake write it in their own ways."""
    return re.sub(r"^lib|^tl|-dev$|[^a-z]|\d", "", re.sub(r"-dev$|\d+-dev$", "", name.lower()))


def names(field):
    return {re.sub(r" .*", "", entry.strip()) for entry in field.split(",") if entry.strip()}


class Described(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        subprocess.run([sys.executable, TOOL, cls.folder / "deb", "--tree"], check=True, env=os.environ | {"SOURCE_DATE_EPOCH": "1700000000"})
        cls.tree, = (cls.folder / "deb").iterdir()
        cls.files = {path.name: path.read_text("utf-8") for path in (cls.tree / "debian").iterdir() if path.is_file()}
        cls.version = re.search(r"VERSION (\S+)", read("CMakeLists.txt").partition("project(")[2])[1]

    def fields(self, package):
        """Of the paragraph of control that begins so."""
        part, = (part for part in self.files["control"].split("\n\n") if part.startswith(package + "\n"))
        return {name: " ".join(text.split()) for name, text in re.findall(r"^([\w-]+):((?:.*\n)(?:[ \t].*\n)*)", part + "\n", re.M)}

    def test_the_version_is_that_of_the_project(self):
        self.assertEqual(self.tree.name, f"orispline-{self.version}")
        self.assertTrue(self.files["changelog"].startswith(f"orispline ({self.version}-1) "))
        self.assertIn("  Tue, 14 Nov 2023 22:13:20 -0000\n", self.files["changelog"])

    def test_packages_are_named_after_the_shared_objects(self):
        series, abi = self.version.rpartition(".")[0], re.search(r"#define ORISPLINE_C_ABI (\d+)", read("bindings/c/orispline.h"))[1]
        libraries = {f"liborispline{series}", f"liborispline-c{abi}"}
        self.assertEqual(set(re.findall(r"^Package: (.*)", self.files["control"], re.M)), libraries | {"orispline", "liborispline-dev"})
        self.assertEqual({name.removesuffix(".install") for name in self.files if name.endswith(".install") and name.startswith("lib")}, libraries | {"liborispline-dev"})
        self.assertEqual(names(self.fields("Package: liborispline-dev")["Recommends"]), libraries)

    def test_nothing_is_left_to_fill_in(self):
        for name, text in self.files.items():
            self.assertIsNone(re.search(r"@[A-Z_]+@|SERIES|cABI", name + text), name)

    def test_what_the_build_needs_is_what_cmake_and_the_set_up_name(self):
        wanted = {plain(name) for file in ("CMakeLists.txt", "cli/CMakeLists.txt") for name in re.findall(r"orispline_dependency\((\S+?)[ )]", read(file))} - OPTIONAL
        built = names(self.fields("Source: orispline")["Build-Depends"]) - BUILD_TOOLS
        self.assertEqual({plain(name) for name in built}, wanted)
        self.assertEqual(built, set(re.findall(r"^build (\S+-dev) ", read("tools/setup.sh"), re.M)))

    def test_what_headers_include_comes_with_them(self):
        found = set(re.findall(r"^find_dependency\((\S+?)[ )]", read("cmake/orisplineConfig.cmake.in"), re.M)) - {"Threads"}
        self.assertEqual({plain(name) for name in names(self.fields("Package: liborispline-dev")["Depends"]) if "$" not in name}, {plain(name) for name in found})

    def test_the_notices_are_those_of_all_that_is_compiled_in(self):
        dependencies = names(self.fields("Source: orispline")["Build-Depends"]) - BUILD_TOOLS
        self.assertEqual({plain(name) for name in COMPILED_IN}, {plain(name) for name in dependencies})
        for name in (*COMPILED_IN, *IN_PAGE):
            self.assertIn(name, self.files["copyright"])
        self.assertIn(f"Files: {PAGE}\n", self.files["copyright"])
        self.assertTrue((ROOT / PAGE).is_file())

    def test_every_paragraph_of_the_licences_is_used_and_each_is_there(self):
        used = {word for line in re.findall(r"^Files:.*\n(?:.*\n)*?License: (.*)", self.files["copyright"], re.M) for word in line.split(" and ")}
        self.assertEqual(set(re.findall(r"^\nLicense: (.*)", self.files["copyright"], re.M)), used)

    def test_the_copy_has_all_that_cmake_reads(self):
        added = re.findall(r"add_subdirectory\(([\w/]+)\)|include\((cmake/[\w.]+)\)", read("CMakeLists.txt"))
        for path in {folder or file for folder, file in added} - {"tests", "tests/fuzz", "benchmarks", "bindings/npm"}:
            self.assertTrue((self.tree / path).exists(), path)
        self.assertEqual([part for part in PARTS if not (self.tree / part).exists()], [])


class Refused(unittest.TestCase):
    def test_tools_that_are_missing_are_named(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, TOOL, pathlib.Path(folder, "deb")], capture_output=True, text=True, check=False,
                                  env={"PATH": folder, "SOURCE_DATE_EPOCH": "1700000000"})
            self.assertEqual((done.returncode, done.stderr),
                             (1, "make_deb.py: found no dpkg-buildpackage, dh and fakeroot; install the packages dpkg-dev debhelper fakeroot\n"))
            self.assertEqual(list(pathlib.Path(folder).iterdir()), [])


if __name__ == "__main__":
    unittest.main()
