#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What reduce promises of clips: between the keys, at cuts, at the seams of loops, and of files for avatars."""
import base64
import json
import math
import struct

from command import BAD_USAGE, SUCCESS, main
from small_scenes import FRAMES, SceneTest, bvh_text, gltf_document, parts_of_glb, samplers_of, turn_about

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


def shaking(angle, kind, unit):
    """A joint that shakes by that angle [rad] from frame to frame; its keys are numbers of that letter of struct, 1 being `unit`."""
    document = gltf_document()
    times = [k / 30 for k in range(61)]
    turns = [c for k in range(61) for c in (0.0, math.sin(angle * math.sin(2.6 * k)), 0.0, math.cos(angle * math.sin(2.6 * k)))]
    data = struct.pack("<61f", *times)
    data += struct.pack(f"<244{kind}", *(turns if unit == 1 else [round(unit * c) for c in turns]))
    document["buffers"] = [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]
    document["bufferViews"] = [{"buffer": 0, "byteOffset": at, "byteLength": length} for at, length in ((0, 244), (244, len(data) - 244))]
    document["accessors"] = [{"bufferView": 0, "componentType": 5126, "count": 61, "type": "SCALAR", "min": [0.0], "max": [times[-1]]},
                             {"bufferView": 1, "componentType": {"f": 5126, "h": 5122, "b": 5120}[kind], "count": 61, "type": "VEC4"} |
                             ({} if unit == 1 else {"normalized": True})]
    del document["meshes"], document["nodes"][0]["mesh"]
    document["animations"] = [{"name": "shake", "samplers": [{"input": 0, "output": 1}],
                               "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}]}]
    return json.dumps(document)


class Bytes(ReduceTest):
    def test_smallest_takes_fewer_bytes_than_either_method_alone(self):
        self.output_of("convert arm.bvh -o arm.glb")
        sizes = {}
        for method in ("smallest", "cubicspline", "slerp"):
            report = self.json_of(f"reduce arm.glb --tolerance 0.2deg --method {method} -o {method}.glb")
            sizes[method] = report["bytes"]
            self.assertEqual(report["method"], method)
            self.assertLessEqual(self.json_of(f"difference arm.glb {method}.glb")["angle_max_deg"], 0.2, method)
        self.assertLess(sizes["smallest"], min(sizes["cubicspline"], sizes["slerp"]))
        after, _ = parts_of_glb(self.folder / "smallest.glb")
        self.assertEqual([sampler.get("interpolation", "LINEAR") for sampler in after["animations"][0]["samplers"]],
                         ["CUBICSPLINE", "LINEAR"], "the elbow turns evenly; where the shoulder stays the rest pose says")
        self.assert_fails("reduce arm.glb --tolerance 0.2deg --method smallest --tension 0.5 -o no.glb", BAD_USAGE,
                          "--tension: found the method smallest, which has no such option, wanted another --method")

    def test_tracks_at_rest_are_left_out_unless_they_are_to_stay(self):
        self.output_of("convert arm.bvh -o arm.glb")
        channels = {}
        for options in ("", "--keep-constant"):
            report = self.json_of(f"reduce arm.glb --tolerance 0.2deg {options} -o small.glb")
            after, _ = parts_of_glb(self.folder / "small.glb")
            channels[options] = len(after["animations"][0]["channels"])
            self.assertEqual(report["tracks_before"] - report["tracks_left_out"], channels[options])
            self.assertLessEqual(self.json_of("difference arm.glb small.glb")["angle_max_deg"], 0.2)
        self.assertEqual(channels, {"": 2, "--keep-constant": 3})
        self.assertIn("at rest         1 of 3 tracks left out, for which the rest pose stands", self.told("reduce arm.glb --tolerance 0.2deg -o small.glb"))
        self.assert_fails("reduce arm.glb --joint Elbow --tolerance 0.2deg --keep-constant -o elbow.csv", BAD_USAGE,
                          "--keep-constant: found keys of one track, wanted a glTF output, such as small.glb")

    def test_channels_with_the_same_times_share_them(self):
        self.output_of("convert arm.bvh -o arm.glb")
        after, _ = parts_of_glb(self.folder / "arm.glb")
        inputs = [sampler["input"] for sampler in after["animations"][0]["samplers"]]
        counts = [after["accessors"][k]["count"] for k in inputs]
        self.assertEqual(len({k for k, count in zip(inputs, counts) if count == FRAMES}), 1)
        self.assertEqual(counts.count(FRAMES), 2)

    def test_rotations_that_were_integers_are_written_as_such_again(self):
        for kind, unit, component in (("h", 32767, 5122), ("b", 127, 5120)):
            self.write("shake.gltf", shaking(0.3, kind, unit))
            before = json.loads((self.folder / "shake.gltf").read_text())
            for line in ("convert shake.gltf", "reduce shake.gltf --tolerance 0.001deg --method slerp", "reduce shake.gltf --tolerance 1deg --method slerp"):
                report = self.json_of(f"{line} -o again.glb")
                self.assertEqual(report["warnings"], [], line)
                after, data = parts_of_glb(self.folder / "again.glb")
                accessor = after["accessors"][after["animations"][0]["samplers"][0]["output"]]
                self.assertEqual((accessor["componentType"], accessor["normalized"]), (component, True), line)
                view = after["bufferViews"][accessor["bufferView"]]
                found = data[view.get("byteOffset", 0) + accessor.get("byteOffset", 0):][:accessor["count"] * struct.calcsize(f"4{kind}")]
                all_keys = base64.b64decode(before["buffers"][0]["uri"].partition(",")[2])[244:]
                keys = [all_keys[k:k + struct.calcsize(f"4{kind}")] for k in range(0, len(all_keys), struct.calcsize(f"4{kind}"))]
                self.assertLessEqual({found[k:k + len(keys[0])] for k in range(0, len(found), len(keys[0]))}, set(keys), line)

    def test_a_file_that_became_larger_says_so_and_why(self):
        self.write("shake.gltf", shaking(0.02, "h", 32767))
        self.output_of("convert shake.gltf -o shake.glb")
        report = self.json_of("reduce shake.glb --tolerance 0.3deg -o larger.glb")
        self.assertGreater(report["bytes"], report["bytes_before"])
        warning, = report["warnings"]
        self.assertEqual((warning["code"], warning["bytes"], warning["bytes_before"]),
                         ("larger_file", report["bytes"], report["bytes_before"]))
        self.assertTrue(warning["message"].endswith("of the input, for keys of the input are integers, and cubics and new keys are floats; --method "
                                                    "smallest writes each track with the fewest bytes that were found for it"), warning["message"])
        smallest = self.json_of("reduce shake.glb --tolerance 0.3deg --method smallest -o smallest.glb")
        self.assertLessEqual(smallest["bytes"], smallest["bytes_before"])

    def test_cubics_that_are_larger_than_the_lines_they_replace_say_so(self):
        self.write("shake.gltf", shaking(0.02, "f", 1))
        self.output_of("convert shake.gltf -o shake.glb")
        report = self.json_of("reduce shake.glb --tolerance 0.3deg -o larger.glb")
        self.assertLess(report["rotation_keys"], 61)
        self.assertGreater(report["bytes"], report["bytes_before"])
        self.assertIn(", for a key of a cubic has 52 bytes, one of slerp 20; --method smallest", report["warnings"][0]["message"])
        smallest = self.json_of("reduce shake.glb --tolerance 0.3deg --method smallest -o smallest.glb")
        self.assertLessEqual(smallest["bytes"], smallest["bytes_before"])
        self.assertEqual(smallest["warnings"], [])


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


def step_motion():
    """Three turns of one node, between which it rests."""
    data = struct.pack("<3f", 0, 1, 2) + struct.pack("<12f", *(c for angle in (0, 40, 90) for w, x, y, z in [turn_about(2, angle)] for c in (x, y, z, w)))
    return {"asset": {"version": "2.0"}, "nodes": [{"name": "sign"}], "scenes": [{"nodes": [0]}],
            "animations": [{"name": "blink", "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}}],
                            "samplers": [{"input": 0, "output": 1, "interpolation": "STEP"}]}],
            "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "SCALAR", "min": [0.0], "max": [2.0]},
                          {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC4"}],
            "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 12}, {"buffer": 0, "byteOffset": 12, "byteLength": 48}],
            "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}


class Steps(ReduceTest):
    def test_a_clip_of_steps_alone_stays_as_it_is(self):
        self.write("blink.gltf", json.dumps(step_motion()))
        for options in ("--tolerance 1deg", "--tolerance 1deg --between smooth", "--world-tolerance 1mm --closed --cuts"):
            self.assertIn("rotations       3 of 3 keys", self.told(f"reduce blink.gltf {options} -o small.glb"), options)
            self.assertNotIn("from_stored_deg", self.json_of(f"reduce blink.gltf {options} -o small.glb"), options)
            self.assertEqual(self.json_of("difference blink.gltf small.glb")["angle_max_deg"], 0, options)


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


class Steps(SceneTest):
    def test_a_file_of_steps_alone_is_told_of(self):
        self.output_of("convert arm.bvh -o arm.glb")
        document, data = parts_of_glb(self.folder / "arm.glb")
        for animation in document["animations"]:
            for sampler in animation["samplers"]:
                sampler["interpolation"] = "STEP"
        document["buffers"][0]["uri"] = "data:;base64," + base64.b64encode(data).decode()
        self.write("steps.gltf", json.dumps(document))
        report = self.json_of("reduce steps.gltf --tolerance 1deg -o small.glb")
        self.assertEqual(report["rotation_keys"], report["rotation_keys_before"])
        self.assertNotIn("from_stored_deg", report)


if __name__ == "__main__":
    main()
