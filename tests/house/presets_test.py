#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tests that CMakePresets.json leaves out by name are there: a name that nobody has any more would leave out nothing."""
import fnmatch
import json
import pathlib
import re
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
TEST = re.compile(r"^\s*TEST(?:_F)?\(\s*(\w+),\s*(\w+)", re.M)  # the others have numbers in their names


def names_of_tests():
    texts = [path.read_text("utf-8") for path in (ROOT / "tests").rglob("*.cpp")]
    return {f"{suite}.{name}" for text in texts for suite, name in TEST.findall(text)}


def left_out(preset):
    _, _, names = preset.get("environment", {}).get("GTEST_FILTER", "-").partition("-")
    return [name for name in names.split(":") if name]


class LeftOutTest(unittest.TestCase):
    def test_every_name_is_one_of_a_test(self):
        presets = json.loads((ROOT / "CMakePresets.json").read_text("utf-8"))["testPresets"]
        patterns = {preset["name"]: left_out(preset) for preset in presets}
        self.assertTrue(patterns["sanitizers"])
        names = names_of_tests()
        nobody = [f"{preset}: {pattern}" for preset, found in patterns.items() for pattern in found if not fnmatch.filter(names, pattern)]
        self.assertEqual(nobody, [])


if __name__ == "__main__":
    unittest.main()
