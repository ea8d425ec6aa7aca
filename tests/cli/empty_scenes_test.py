#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Every command on files of skeletons without nodes, clips, channels or channels of ours: each has its answer."""
import base64
import json
import struct

from command import BAD_DATA, main, with_pages
from small_scenes import SceneTest

WEIGHTS = struct.pack("<3f", 0.5, 1, 2) + struct.pack("<6f", 0, 1, 0, 1, 0, 0)
KEYS = {
    "buffers": [{"byteLength": len(WEIGHTS),
                 "uri": "data:application/octet-stream;base64," + base64.b64encode(WEIGHTS).decode()}],
    "bufferViews": [{"buffer": 0, "byteLength": 12}, {"buffer": 0, "byteOffset": 12, "byteLength": 24}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "SCALAR", "min": [0.5], "max": [2]},
                  {"bufferView": 1, "componentType": 5126, "count": 6, "type": "SCALAR"}]}
NODES = {"nodes": [{"name": "base", "children": [1]}, {"name": "tip"}]}
POINTER = {"path": "pointer", "extensions": {"KHR_animation_pointer": {"pointer": "/materials/0/alphaCutoff"}}}


def animated(*targets):
    return {"animations": [{"name": "act", "channels": [{"sampler": 0, "target": target} for target in targets],
                            "samplers": [{"input": 0, "output": 1}] if targets else []}]}


# Of each: what the document has beside its version, how many joints and clips.
SCENES = {
    "bare": ({}, 0, 0),
    "still": (NODES, 2, 0),
    "no_nodes": (animated(), 0, 1),
    "no_channels": (NODES | animated(), 2, 1),
    "pointer": (KEYS | animated(POINTER), 0, 1),
    "no_target": (KEYS | animated({"path": "rotation"}), 0, 1),
    "weights": (KEYS | NODES | animated({"node": 0, "path": "weights"}), 2, 1),
}

FILES = [(f"{name}.gltf", joints, clips) for name, (_, joints, clips) in SCENES.items()]

OF_ONE_TRACK = ("convert {} -o x.csv", "reduce {} --tolerance 1deg -o x.csv", "smooth {} -o x.csv", "sample {} --rate 10",
                "sample {} --rate 10 --method slerp", "retime {} --max-rate 90deg/s", "plot {} -o x.svg", "compare {}",
                "tune {}", "inspect {} --method slerp", "inspect {} --method slerp --clip act")


class EmptyScenes(SceneTest):
    def setUp(self):
        super().setUp()
        for name, (document, _, _) in SCENES.items():
            self.write(f"{name}.gltf", json.dumps({"asset": {"version": "2.0"}} | document))

    def test_inspect_counts_nothing(self):
        for file, joints, clips in FILES:
            with self.subTest(file):
                report = self.json_of(f"inspect {file}")
                self.assertEqual((len(report["joints"]), len(report["clips"])), (joints, clips))
                self.assertEqual((report["rotation_keys"], report["translation_keys"], report["scale_keys"]), (0, 0, 0))
                self.assertIn("\nrotations     none\n", self.output_of(f"inspect {file}"))

    def test_reduce_and_smooth_write_the_file_again(self):
        for file, _, clips in FILES:
            with self.subTest(file):
                before = json.loads(self.read(file))
                for arguments in ("reduce {} --tolerance 1deg", "reduce {} --world-tolerance 1mm --closed", "smooth {}"):
                    report = self.json_of(f"{arguments.format(file)} -o x.gltf")
                    self.assertEqual(report["warnings"], [])
                    after = json.loads(self.read("x.gltf"))
                    self.assertEqual(after.get("nodes"), before.get("nodes"))
                    self.assertEqual([clip["channels"] for clip in after.get("animations", [])],
                                     [clip["channels"] for clip in before.get("animations", [])])
                report = self.json_of(f"reduce {file} --tolerance 1deg -o x.glb --method slerp")
                self.assertEqual((report["clips"], report["rotation_keys"]), (clips, 0))
                for name in ("angle_deg", "translation_m", "shell_distance_m", "from_smooth_deg", "from_stored_deg"):
                    self.assertNotIn(name, report)
                self.assertEqual(self.run_command(f"reduce {file} --tolerance 1deg -o x.glb").stderr.splitlines()[0],
                                 f"{clips} {'clip' if clips == 1 else 'clips'} from {file}, tolerance 1°, method cubicspline")

    def test_several_inputs_go_on(self):
        files = " ".join(f"{name}.gltf" for name in SCENES)
        for command in ("reduce --tolerance 1deg", "smooth"):
            done = self.run_command(f"{command} {files} --output-folder out")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(len(list((self.folder / "out").iterdir())), len(SCENES))

    def test_convert_keeps_what_there_is(self):
        for file, joints, clips in FILES:
            with self.subTest(file):
                report = self.json_of(f"convert {file} -o x.glb")
                self.assertEqual((report["joints"], report["clips"]), (joints, clips))
                wanted = "found no clip, wanted one" if clips == 0 else "found no joint, wanted one at least"
                if joints == 0 or clips == 0:
                    self.assert_fails(f"convert {file} -o x.bvh", BAD_DATA, f"{file}: {wanted}")
                else:
                    self.output_of(f"convert {file} -o x.bvh")

    def test_difference_of_a_file_from_itself_and_from_others(self):
        for file, joints, clips in FILES:
            with self.subTest(file):
                if clips == 0:
                    for pair in (f"{file} {file}", f"{file} swing.gltf"):
                        self.assert_fails(f"difference {pair}", BAD_DATA,
                                          f"{pair.split()[1]}: found no clip of the same name, wanted one at least")
                    continue
                same = "no joint is in both of them" if joints == 0 else "no difference in 2 joints at 1 time"
                self.assertEqual(self.output_of(f"difference {file} {file}"), f"{file} and {file}: 1 clip compared\n{same}\n")
                self.assertEqual("angle_max_deg" in self.json_of(f"difference {file} {file}"), joints > 0)
                self.output_of(f"difference {file} swing.gltf")
                self.output_of(f"difference swing.gltf {file} --rate 5")

    @with_pages
    def test_pages_are_written(self):
        for file, joints, clips in FILES:
            with self.subTest(file):
                self.output_of(f"reduce {file} --world-tolerance 1mm -o x.glb --report x.html")
                self.output_of(f"smooth {file} -o x.glb --report x.html")
                self.assertIn("0 rotations", self.page("x.html")["title"])
                self.output_of(f"inspect {file} --report x.html")
                notes = ["There is no joint to show."] if joints == 0 else \
                    ["No clip moves the skeleton: it is shown in its rest pose."] if clips == 0 else []
                self.assertEqual(self.page("x.html")["notes"], notes)
                if clips > 0:
                    self.output_of(f"difference {file} {file} --report y.html")

    def test_one_track_is_told_that_there_is_none(self):
        for file, _, clips in FILES:
            with self.subTest(file):
                for arguments in OF_ONE_TRACK:
                    if clips == 0 and "--clip" in arguments:
                        continue
                    found = "clip 'act': found no rotation, wanted one" if clips else "found no clip, wanted one"
                    self.assert_fails(arguments.format(file), BAD_DATA, f"{file}: {found}")
                done = self.run_command(f"sample {file} --rate 10 --output-folder joints")
                self.assertEqual(done.returncode, BAD_DATA)
                self.assertIn(f"{file}: found no joint that moves, wanted one at least", done.stderr)

    def test_a_recording_without_frames_or_channels_is_refused(self):
        hierarchy = "HIERARCHY\nROOT a\n{{\nOFFSET 0 0 0\nCHANNELS {}\n}}\nMOTION\nFrames: {}\nFrame Time: 0.1\n{}\n"
        for name, text, found in (("none", hierarchy.format("0", 1, ""), "7: found no channels, wanted one at least"),
                                  ("zero", hierarchy.format("1 Xrotation", 0, ""), "8: found 0 frames, wanted one at least"),
                                  ("cut", hierarchy.format("1 Xrotation", 2, "1"),
                                   "11: found 1 whole frame, wanted 2, the number in line 8 (--salvage reads those that are whole)")):
            self.write(f"{name}.bvh", text)
            for arguments in (*OF_ONE_TRACK, "inspect {}", "reduce {} --tolerance 1deg -o x.glb", "difference {} arm.bvh",
                              "difference arm.bvh {}", "convert {} -o x.glb", "smooth {} -o x.bvh"):
                self.assert_fails(arguments.format(f"{name}.bvh"), BAD_DATA, f"{name}.bvh:{found}")

    def test_a_recording_of_one_frame_has_one_key(self):
        self.write("one.bvh", "HIERARCHY\nROOT a\n{\nOFFSET 0 0 0\nCHANNELS 1 Xrotation\n}\nMOTION\nFrames: 1\nFrame Time: 0.1\n1\n")
        self.assertEqual(self.json_of("inspect one.bvh")["rotation_keys"], 1)
        for arguments in ("reduce one.bvh --tolerance 1deg -o x.glb", "convert one.bvh -o x.bvh", "smooth one.bvh -o x.bvh",
                          "sample one.bvh --rate 10 -o x.csv", "difference one.bvh one.bvh"):
            self.output_of(arguments)


if __name__ == "__main__":
    main()
