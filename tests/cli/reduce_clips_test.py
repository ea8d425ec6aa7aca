#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What reduce promises of clips: between the keys, at cuts, at the seams of loops, and of files for avatars."""
import base64
import json
import math
import struct

from command import BAD_USAGE, SUCCESS, main
from small_scenes import FRAMES, SceneTest, bvh_text, gltf_document, parts_of_glb, samplers_of

CUT = 70  # the frame where the second shot begins


def with_cut(text):
    """The shoulder jumps by 150° and 4 m, where it goes on to move."""
    head, _, rows = text.partition("Frame Time: .0083333\n")
    numbers = [[float(number) for number in row.split()] for row in rows.splitlines()]
    for row in numbers[CUT:]:
        row[0] += 4
        row[3] += 150
    return head + "Frame Time: .0083333\n" + "".join(" ".join(f"{number:.6f}" for number in row) + "\n" for row in numbers)


class ReduceTest(SceneTest):
    def told(self, arguments):
        done = self.run_command(arguments)
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        return done.stderr


class Cuts(ReduceTest):
    def setUp(self):
        super().setUp()
        self.write("cut.bvh", with_cut(bvh_text()))

    def test_in_BVH_a_step_that_neither_side_foretells_is_one(self):
        report = self.json_of("reduce cut.bvh --tolerance 0.2deg --position-tolerance 1mm --position-scale 1 -o small.glb")
        self.assertEqual((report["between"], report["cuts"]), ("smooth", 1))
        self.assertLess(report["rotation_keys"], FRAMES / 2)
        self.assertLessEqual(report["angle_deg"]["largest"], 0.2)
        whole = self.json_of("reduce arm.bvh --tolerance 0.2deg -o whole.glb")
        self.assertEqual(whole["cuts"], 0)
        self.assertLess(report["rotation_keys"], whole["rotation_keys"] + 8, "nothing swings that has to be held")
        self.assertLessEqual(self.json_of("difference cut.bvh small.glb")["angle_max_deg"], 0.2)
        without = self.json_of("reduce cut.bvh --tolerance 0.2deg --no-cuts -o swings.glb")
        self.assertEqual(without["cuts"], 0)
        self.assertGreater(without["from_stored_deg"]["largest"], report["from_stored_deg"]["largest"])

    def test_in_glTF_a_ramp_of_one_frame_stays_one_unless_it_is_called_a_cut(self):
        self.output_of("convert cut.bvh -o cut.glb")
        for options, between, cuts in (("", "stored", 0), ("--cuts", "stored", 1), ("--between smooth", "smooth", 1),
                                       ("--between smooth --no-cuts", "smooth", 0)):
            report = self.json_of(f"reduce cut.glb --tolerance 0.2deg {options} -o small.glb")
            self.assertEqual((report["between"], report["cuts"]), (between, cuts), options)
            found = self.json_of("difference cut.glb small.glb")
            self.assertLessEqual(found["angle_max_deg"], 0.2, options)
        self.assertIn("\nbetween keys    1 cut; holds between keys", self.told("reduce cut.glb --tolerance 1deg --cuts -o small.glb"))

    def test_what_the_file_says_is_held_between_its_keys(self):
        self.output_of("convert cut.bvh -o cut.glb")
        for method in ("cubicspline", "hermite-c1", "slerp", "auto"):
            report = self.json_of(f"reduce cut.glb --tolerance 0.3deg --method {method} -o small.glb")
            self.assertLessEqual(report["angle_deg"]["largest"], 0.3, method)
            found = self.json_of("difference cut.glb small.glb --rate 3000")
            self.assertLessEqual(found["angle_max_deg"], report["angle_deg"]["largest"] * 1.00001, method)


class Loops(ReduceTest):
    def test_ends_nearer_than_the_tolerance_are_closed_and_others_are_named(self):
        for tolerance, is_closed in (("0.01deg", False), ("70deg", True)):
            text = self.told(f"reduce arm.bvh --tolerance {tolerance} --closed -o small.glb")
            line = next(line for line in text.splitlines() if line.startswith("closed"))
            self.assertEqual("joint 'Elbow' (60°)" in line, not is_closed, line)
        report = self.json_of("reduce arm.bvh --tolerance 0.1deg --closed -o small.glb")
        self.assertEqual(report["open_tracks"], 1)
        self.assertEqual([(track["clip"], track["joint"]) for track in report["open"]], [("arm", "Elbow")])
        self.assertAlmostEqual(report["open"][0]["angle_deg"], 60, places=4)


def avatar_motion():
    """An expression whose weight goes from 0 to 1 and back, as the translation of a node, and a joint that turns."""
    document = gltf_document()
    times = [k / 30 for k in range(61)]
    weights = [max(0.0, math.sin(math.pi * t)) for t in times]
    turns = [(0.0, 0.0, math.sin(0.2 * t), math.cos(0.2 * t)) for t in times]
    data = struct.pack("<61f", *times) + struct.pack("<183f", *(c for w in weights for c in (w, 0.0, 0.0)))
    data += struct.pack("<244f", *(c for turn in turns for c in turn))
    document["buffers"] = [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]
    document["bufferViews"] = [{"buffer": 0, "byteOffset": at, "byteLength": length}
                               for at, length in ((0, 244), (244, 732), (976, 976))]
    document["accessors"] = [{"bufferView": k, "componentType": 5126, "count": 61, "type": kind}
                             for k, kind in enumerate(("SCALAR", "VEC3", "VEC4"))]
    document["accessors"][0] |= {"min": [0.0], "max": [times[-1]]}
    del document["meshes"], document["nodes"][0]["mesh"]
    document["nodes"].append({"name": "happy"})
    document["scenes"] = [{"nodes": [0, 2]}]
    document["extensions"] = {"VRMC_vrm_animation": {
        "specVersion": "1.0", "humanoid": {"humanBones": {"hips": {"node": 0}}}, "expressions": {"preset": {"happy": {"node": 2}}}}}
    document["extensionsUsed"] = ["VRMC_vrm_animation"]
    document["animations"] = [{"name": "smile", "samplers": [{"input": 0, "output": 1}, {"input": 0, "output": 2}],
                               "channels": [{"sampler": 0, "target": {"node": 2, "path": "translation"}},
                                            {"sampler": 1, "target": {"node": 0, "path": "rotation"}}]}]
    return document, weights


class Avatars(SceneTest):
    def test_motions_of_avatars_are_glTF_whose_weights_stay_as_they_are(self):
        document, weights = avatar_motion()
        self.write("smile.gltf", json.dumps(document))
        self.output_of("convert smile.gltf -o smile.vrma")
        report = self.json_of("reduce smile.vrma --world-tolerance 1mm -o small.vrma")
        self.assertLess(report["rotation_keys"], 10)
        after, data = parts_of_glb(self.folder / "small.vrma")
        self.assertEqual(after["extensions"], document["extensions"])
        sampler = samplers_of(after, "translation")[("smile", 2)]
        accessor = after["accessors"][sampler["output"]]
        view = after["bufferViews"][accessor["bufferView"]]
        self.assertEqual(accessor["count"], 61)
        found = struct.unpack_from("<183f", data, view.get("byteOffset", 0) + accessor.get("byteOffset", 0))
        self.assertEqual(found, struct.unpack("<183f", struct.pack("<183f", *(c for w in weights for c in (w, 0.0, 0.0)))))

    def test_files_of_avatars_are_not_made_of_others(self):
        for name, what in (("arm.vrm", "avatar"), ("arm.vrma", "animation")):
            self.assert_fails(f"convert arm.bvh -o {name}", BAD_USAGE,
                              f"{name}: found no VRM {what} for a .{name[4:]} file, wanted a name that ends in .glb")
            self.assertFalse((self.folder / name).exists())
        self.assertEqual(self.run_command("convert arm.bvh -o arm.glb").returncode, SUCCESS)


if __name__ == "__main__":
    main()
