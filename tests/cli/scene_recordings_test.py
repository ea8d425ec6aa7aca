#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files of skeletons from elsewhere, which lie beside the project: the fewest keys, and nothing lost."""
import json
import os
import pathlib
import re
import struct
import subprocess
import unittest

from command import SUCCESS, CommandTest, main, rows_of
from small_scenes import angle_between, parts_of_glb, samplers_of, spline_at

SHARED = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data"))
ORACLES = pathlib.Path(os.environ["ORISPLINE_ORACLES"])  # filled by tests/scenes/oracles/prepare.sh


@unittest.skipUnless((SHARED / "gltf").is_dir(), f"the animations are not beside the project, in {SHARED / 'gltf'}")
class Animations(CommandTest):
    """KayKit's mage: 76 clips of 41 joints."""

    MAGE = SHARED / "gltf/kaykit_mage_76clips.glb"

    def json_of(self, *arguments):
        return json.loads(self.output_of([*map(str, arguments), "--json"]))

    def test_what_the_file_holds(self):
        report = self.json_of("inspect", self.MAGE)
        self.assertEqual((len(report["clips"]), report["rotation_tracks"], report["sign_flips"]), (76, 3116, 370))

    def test_the_fewest_keys_within_an_angle(self):
        report = self.json_of("reduce", self.MAGE, "--tolerance", "0.21deg", "--method", "cubicspline", "--keep-constant", "-o", "small.glb")
        self.assertEqual((report["rotation_tracks"], report["rotation_keys_before"]), (1367, 55868))
        self.assertLessEqual(report["rotation_keys"], 10905)
        self.assertLessEqual((self.folder / "small.glb").stat().st_size, 2.3e6)
        found = self.json_of("difference", self.MAGE, "small.glb")
        self.assertEqual(len(found["clips"]), 76)
        self.assertLessEqual(found["angle_max_deg"], 0.21)
        (before, bytes_before), (after, bytes_after) = parts_of_glb(self.MAGE), parts_of_glb(self.folder / "small.glb")
        self.check_keys(before, after, report)
        self.check_rest(before, after, bytes_before, bytes_after)

    def check_keys(self, before, after, report):
        """Counted in the files."""
        was, now = samplers_of(before, "rotation"), samplers_of(after, "rotation")
        self.assertEqual(set(was), set(now))
        long = [place for place, sampler in was.items() if before["accessors"][sampler["input"]]["count"] >= 3]
        self.assertEqual(len(long), report["rotation_tracks"])
        self.assertEqual(sum(after["accessors"][now[place]["input"]]["count"] for place in long), report["rotation_keys"])

    def check_rest(self, before, after, bytes_before, bytes_after):
        """All but animations, value for value, and the data of every image and mesh."""
        self.assertEqual(set(before) | {"animations"}, set(after) | {"animations"})
        for name in set(before) - {"animations", "accessors", "bufferViews", "buffers", "images"}:
            self.assertEqual(before[name], after[name], name)

        def data(document, content, view):
            view = document["bufferViews"][view]
            start = view.get("byteOffset", 0)
            return content[start:start + view["byteLength"]]

        for mesh in before["meshes"]:
            for primitive in mesh["primitives"]:
                for k in [primitive["indices"], *primitive["attributes"].values()]:
                    one, other = before["accessors"][k], after["accessors"][k]
                    self.assertEqual({**one, "bufferView": 0, "byteOffset": 0}, {**other, "bufferView": 0, "byteOffset": 0})
                    self.assertEqual(data(before, bytes_before, one["bufferView"]), data(after, bytes_after, other["bufferView"]))
        for one, other in zip(before["images"], after["images"], strict=True):
            self.assertEqual(data(before, bytes_before, one["bufferView"]), data(after, bytes_after, other["bufferView"]))

    @unittest.skipUnless((ORACLES / "node_modules/.installed").exists(), "the packages of npm could not be installed")
    def test_the_validator_of_Khronos_finds_no_more_than_in_the_input(self):
        self.output_of(["reduce", str(self.MAGE), "--tolerance", "0.21deg", "-o", "small.glb"])
        done = subprocess.run(["node", ORACLES / "validate.mjs", self.MAGE, "small.glb"], cwd=self.folder,
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, SUCCESS, done.stdout)
        counts = [re.search(rf"^{re.escape(str(file))}: (\d+) errors, (\d+) warnings", done.stdout, re.M).groups()
                  for file in (self.MAGE, "small.glb")]
        self.assertEqual(counts[1][0], "0")
        self.assertLessEqual(int(counts[1][1]), int(counts[0][1]))

    def test_the_fewest_keys_within_a_distance_in_the_world(self):
        report = self.json_of("reduce", self.MAGE, "--world-tolerance", "2mm", "-o", "w.glb")
        found = self.json_of("difference", self.MAGE, "w.glb")
        self.assertLessEqual(found["shell_distance_max"], 0.002)
        self.assertLessEqual(report["rotation_keys"], 14500)
        self.assertLess(report["translation_keys"], 0.28 * report["translation_keys_before"])

    def test_the_hand_goes_as_the_body_carries_it(self):
        choice = ["sample", str(self.MAGE), "--clip", "Walking_A", "--joint", "hand.r", "--rate", "240"]
        world, local = (rows_of(self.output_of([*choice, "--space", space])) for space in ("world", "local"))
        self.assertEqual(len(world), 257)
        self.assertTrue(all(0.4 < row[6] < 1.2 for row in world))
        self.assertGreater(max(angle_between(a[1:5], b[1:5]) for a, b in zip(world, local)), 10)

    def test_a_spline_equals_the_formula_of_the_specification(self):
        source = SHARED / "gltf/01_cs_rotate.gltf"
        numbers = struct.unpack("<39f", (SHARED / "gltf/01_cs_rotate.bin").read_bytes()[612:768])
        times, keys = numbers[:3], [numbers[3 + 4 * k:7 + 4 * k] for k in range(9)]
        self.output_of(["sample", str(source), "--rate", "30", "-o", "cs.csv"])
        rows = rows_of(self.read("cs.csv"))
        self.assertEqual(len(rows), 61)
        for row in rows:
            for found, wanted in zip(row[1:5], spline_at(times, keys, row[0])):
                self.assertAlmostEqual(found, wanted, delta=1e-7)


@unittest.skipUnless((SHARED / "mocap").is_dir(), f"the recordings are not beside the project, in {SHARED / 'mocap'}")
class Recordings(CommandTest):
    """CMU 01_01: 31 joints that turn, 2752 frames of which the first is a T-pose."""

    WALK = SHARED / "mocap/cmu_01_01_fairmotion.bvh"

    def test_a_recording_is_the_same_after_glTF(self):
        self.output_of(["convert", str(self.WALK), "-o", "a.glb"])
        self.output_of("convert a.glb -o b.bvh")
        report = json.loads(self.output_of(["difference", str(self.WALK), "b.bvh", "--json"]))
        self.assertEqual(report["clips"][0]["times"], 2752)
        self.assertLessEqual(report["angle_max_deg"], 1e-4)
        wanted = self.WALK.read_text("utf-8").partition("MOTION")[0]
        self.output_of(["convert", str(self.WALK), "-o", "same.bvh"])
        self.assertEqual(self.read("same.bvh").partition("MOTION")[0], wanted)

    def test_the_fewest_keys_within_half_a_degree(self):
        report = json.loads(self.output_of(["reduce", str(self.WALK), "--tolerance", "0.5deg", "--method", "cubicspline",
                                            "-o", "c.glb", "--json"]))
        self.assertEqual((report["rotation_tracks"], report["rotation_keys_before"]), (31, 31 * 2752))
        self.assertLessEqual(report["rotation_keys"], 6103)
        found = json.loads(self.output_of(["difference", str(self.WALK), "c.glb", "--json"]))
        self.assertLessEqual(found["angle_max_deg"], 0.5)


if __name__ == "__main__":
    main()
