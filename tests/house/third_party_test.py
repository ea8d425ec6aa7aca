#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The notices for the code of others: those of the table of dependencies, in the file that is shipped."""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
from make_third_party import shipped  # noqa: E402

NOT_SHIPPED = ("tests", "benchmarks")  # of the features of vcpkg.json


def plain(name):
    """A package by its letters: those who pack it write it in their own ways."""
    return re.sub(r"[^a-z]", "", name.lower())


class ThirdParty(unittest.TestCase):
    def check(self, root):
        return subprocess.run([sys.executable, ROOT / "tools/make_third_party.py", root, "--check"], capture_output=True, text=True, check=False)

    def test_the_file_is_what_the_tool_writes(self):
        done = self.check(ROOT)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_another_table_and_another_file_are_found(self):
        with tempfile.TemporaryDirectory() as place:
            root = pathlib.Path(place)
            shutil.copytree(ROOT / "tools/licences", root / "tools/licences")
            shutil.copy(ROOT / "THIRD_PARTY", root)
            page = (ROOT / "docs/building.md").read_text("utf-8")
            (root / "docs").mkdir()
            (root / "docs/building.md").write_text(page.replace("| NumPy | `bindings/python` | no |", "| NumPy | `bindings/python` | yes |"), "utf-8")
            self.assertIn("none for ['NumPy']", self.check(root).stderr)
            (root / "docs/building.md").write_text(page, "utf-8")
            (root / "THIRD_PARTY").write_text("nobody", "utf-8")
            self.assertIn("found another THIRD_PARTY", self.check(root).stderr)

    def test_what_vcpkg_builds_in_is_shipped(self):
        manifest = json.loads((ROOT / "vcpkg.json").read_text("utf-8"))
        built_in = list(manifest["dependencies"])
        for name, feature in manifest["features"].items():
            if name not in NOT_SHIPPED:
                built_in += [package for package in feature.get("dependencies", []) if isinstance(package, str)]
        known = {plain(name) for name in shipped((ROOT / "docs/building.md").read_text("utf-8"))}
        self.assertEqual({plain(name) for name in built_in} - known, set())
        self.assertGreaterEqual(len(built_in), 6)


if __name__ == "__main__":
    unittest.main()
