#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files of keys that earlier versions wrote are read for ever: tests/data/written/VERSION has them, with samples by that version.

A version that writes something new adds its folder; what is there stays as it is.
"""
import csv
import pathlib

from command import CommandTest, main

WRITTEN = pathlib.Path(__file__).resolve().parents[1] / "data/written"
FILES = sorted(path for path in WRITTEN.glob("*/*") if not path.stem.endswith("_samples"))
NEAR = {"q": 1e-12, "w": 1e-11}  # of one; of everything else:
RELATIVE = 1e-9


def table(text):
    rows = csv.DictReader(line for line in text.splitlines() if not line.startswith("#"))
    return [{name: float(value) for name, value in row.items()} for row in rows]


class WrittenEarlier(CommandTest):
    def assert_near(self, now, then):
        self.assertEqual([list(row) for row in now], [list(row) for row in then])
        for here, there in zip(now, then):
            for name, value in there.items():
                self.assertAlmostEqual(here[name], value, delta=NEAR.get(name[0], RELATIVE) * max(1, abs(value)), msg=f"{name} at {there['t']}")

    def test_their_recipe_names_the_same_curve(self):
        self.assertGreaterEqual(len(FILES), 5)
        for path in FILES:
            with self.subTest(path=path.name):
                self.assertTrue(path.read_text("utf-8").startswith("# orispline: method="))
                now = self.output_of(f"sample {path} --count 9 --quiet")
                self.assert_near(table(now), table(path.with_name(f"{path.stem}_samples.csv").read_text("utf-8")))


if __name__ == "__main__":
    main()
