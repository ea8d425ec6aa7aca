#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files of skeletons as strangers make them: names that repeat, data in files beside them, and what is said of both."""
import base64
import json
import os
import pathlib
import struct

from command import BAD_DATA, main
from small_scenes import FRAMES, SceneTest, bvh_text, gltf_document

CASES = pathlib.Path(__file__).resolve().parents[2].parent / "shared/cases/animation"


def two_armatures(order=(0, 1, 2, 3, 4), shift=0.0):
    """Two armatures with bones of the same name that turn by 40° and 60°, their nodes in this order."""
    turns = [(0, 0, 0, 1, 0, 0, 0.342020143, 0.939692621), (0, 0, 0, 1, 0.5, 0, 0, 0.866025404)]
    data = struct.pack("<2f16f", 0, 1, *turns[0], *turns[1])
    names = [("scene", [1, 3]), ("Armature", [2]), ("Bone", []), ("Armature.001", [4]), ("Bone", [])]
    place = [order.index(node) for node in range(5)]
    nodes = [{"name": names[node][0], "children": [place[child] for child in names[node][1]]} for node in order]
    for node in nodes:
        if not node["children"]:
            del node["children"]
    nodes[place[4]]["translation"] = [0, 1 + shift, 0]
    return {"asset": {"version": "2.0"}, "nodes": nodes, "scenes": [{"nodes": [place[0]]}],
            "animations": [{"name": "Both",
                            "channels": [{"sampler": k, "target": {"node": place[node], "path": "rotation"}}
                                         for k, node in ((0, 2), (1, 4))],
                            "samplers": [{"input": 0, "output": 1}, {"input": 0, "output": 2}]}],
            "accessors": [{"bufferView": k, "componentType": 5126, "count": 2, "type": kind} | more for k, kind, more in (
                (0, "SCALAR", {"min": [0], "max": [1]}), (1, "VEC4", {}), (2, "VEC4", {}))],
            "bufferViews": [{"buffer": 0, "byteOffset": at, "byteLength": length} for at, length in ((0, 8), (8, 32), (40, 32))],
            "buffers": [{"byteLength": len(data),
                         "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}


class SceneFiles(SceneTest):
    def with_buffer_at(self, uri):
        """The swing with its data in another file, and these data."""
        document = gltf_document()
        data = base64.b64decode(document["buffers"][0]["uri"].partition(",")[2])
        document["buffers"][0]["uri"] = uri
        self.write("swing.gltf", json.dumps(document))
        return data

    def test_difference_finds_joints_by_their_path(self):
        self.write("a.gltf", json.dumps(two_armatures()))
        self.write("b.gltf", json.dumps(two_armatures((3, 4, 0, 2, 1))))
        report = self.json_of("difference a.gltf b.gltf")
        self.assertEqual((report["angle_max_deg"], report["shell_distance_max"]), (0, 0))
        self.assertEqual([joint["joint"] for joint in report["clips"][0]["joints"]],
                         ["scene", "Armature", "scene/Armature/Bone", "Armature.001", "scene/Armature.001/Bone"])
        self.assertEqual((report["joints_by_name"], report["joints_guessed"]), ([], []))
        self.assertEqual(self.run_command("difference a.gltf b.gltf").stderr, "")

    def test_difference_says_what_it_guesses_and_what_is_missing(self):
        document = two_armatures()
        document["nodes"][3]["name"] = "Armature"
        self.write("a.gltf", json.dumps(document))
        document["nodes"][3]["translation"] = document["nodes"][1]["translation"] = [1, 0, 0]
        self.write("b.gltf", json.dumps(document))
        done = self.run_command("difference a.gltf b.gltf")
        self.assertEqual(done.stderr, "orispline: warning: a.gltf: found 2 joints whose name others have too, such as "
                                      "'scene/Armature'; by their order it was guessed which they are in the second file\n")
        self.assertEqual(self.json_of("difference a.gltf b.gltf")["joints_guessed"], ["scene/Armature"] * 2)
        document["nodes"][3]["name"] = "Rig"
        document["nodes"][0]["children"] = [1]
        self.write("c.gltf", json.dumps(document))
        text = self.output_of("difference a.gltf c.gltf")
        self.assertIn("only in a.gltf: 1 joint, such as 'scene/Armature'\nonly in c.gltf: 1 joint, such as 'Rig'\n"
                      "by name alone, below other joints: 1 joint, such as 'scene/Armature/Bone'\n", text)

    def test_joints_of_one_name_get_files_of_their_own(self):
        self.write("a.gltf", json.dumps(two_armatures()))
        self.output_of("sample a.gltf --rate 10 --output-folder out")
        self.assertEqual({path.name for path in (self.folder / "out/Both").iterdir()}, {"Bone.csv", "Bone_2.csv"})
        document = two_armatures()
        document["nodes"][2]["name"], document["nodes"][4]["name"] = "Bone", "Bone_2"
        document["nodes"].append({"name": "Bone"})
        document["scenes"][0]["nodes"].append(5)
        document["animations"][0]["channels"].append({"sampler": 0, "target": {"node": 5, "path": "rotation"}})
        self.write("a.gltf", json.dumps(document))
        self.output_of("sample a.gltf --rate 10 --output-folder more")
        self.assertEqual({path.name for path in (self.folder / "more/Both").iterdir()},
                         {"Bone.csv", "Bone_2.csv", "Bone_3.csv"})

    def test_a_pipe_as_a_buffer_is_refused_at_once(self):
        self.with_buffer_at("pipe.bin")
        os.mkfifo(self.folder / "pipe.bin")
        for arguments in ("inspect swing.gltf", "convert swing.gltf -o x.glb", "reduce swing.gltf --tolerance 1deg -o x.glb",
                          "difference swing.gltf swing.gltf", "sample swing.gltf --rate 5"):
            self.assert_fails(arguments, BAD_DATA, "swing.gltf: buffer 0: found uri 'pipe.bin', which is a folder, a pipe or a "
                                                   "device, wanted a file")

    def test_a_link_to_another_folder_is_not_followed(self):
        secret = self.folder / "secret"
        secret.mkdir()
        here = self.folder / "here"
        here.mkdir()
        (secret / "keys.bin").write_bytes(self.with_buffer_at("keys.bin"))
        (self.folder / "swing.gltf").rename(here / "swing.gltf")
        (here / "keys.bin").symlink_to("../secret/keys.bin")
        self.assert_fails("convert here/swing.gltf -o x.glb", BAD_DATA,
                          "here/swing.gltf: buffer 0: found uri 'keys.bin', a link to another folder, wanted a file beside the "
                          "glTF file; copy it there")
        self.assertFalse((self.folder / "x.glb").exists())

    def test_the_size_of_a_file_counts_its_buffers(self):
        data = self.with_buffer_at("keys.bin")
        (self.folder / "keys.bin").write_bytes(data + bytes(1000))
        size = (self.folder / "swing.gltf").stat().st_size + len(data) + 1000
        self.assertEqual(self.json_of("reduce swing.gltf --tolerance 1deg -o x.glb")["bytes_before"], size)
        self.assertIn(f" of {size / 1e3:.3g} kB\n", self.run_command("reduce swing.gltf --tolerance 1deg -o x.glb").stderr)

    def test_a_clip_of_weights_lasts_as_long_as_they_do(self):
        document = gltf_document()
        document["animations"][0]["channels"] = [{"sampler": 0, "target": {"node": 0, "path": "weights"}}]
        self.write("swing.gltf", json.dumps(document))
        self.assertRegex(self.output_of("inspect swing.gltf"), r"\n  swing +2 s +0 +0 ")
        clip, = self.json_of("inspect swing.gltf")["clips"]
        self.assertEqual((clip["start_s"], clip["end_s"]), (0, 2))

    def test_convert_counts_the_keys_that_it_writes(self):
        done = self.run_command("convert arm.bvh --rate 30 -o x.bvh")
        frames = int(self.read("x.bvh").partition("Frames: ")[2].split()[0])
        self.assertLess(frames, FRAMES / 2)
        self.assertIn(f": {2 * frames} keys of rotations, {frames} keys of translations\n", done.stderr)
        report = self.json_of("convert arm.bvh --rate 30 -o x.bvh")
        self.assertEqual((report["rotation_keys"], report["rotation_keys_written"]), (2 * FRAMES, 2 * frames))
        self.assertEqual((report["translation_keys"], report["translation_keys_written"]), (FRAMES, frames))
        report = self.json_of("convert arm.bvh -o x.glb")
        written = self.json_of("inspect x.glb")
        self.assertEqual(report["rotation_keys_written"], written["rotation_keys"])
        self.assertEqual((report["translation_keys_written"], written["translation_keys"]), (1, 1))

    def test_a_column_too_many_is_left_out(self):
        head, _, rows = bvh_text().partition("Frame Time: .0083333\n")
        self.write("more.bvh", head + "Frame Time: .0083333\n" + "".join(f"{row} 0.5\n" for row in rows.splitlines()))
        done = self.run_command("difference arm.bvh more.bvh")
        self.assertEqual(done.stderr, "orispline: warning: more.bvh:19: found 10 numbers in every frame, read the first 9, one for "
                                      "each channel\n")
        self.assertIn("no difference in 3 joints", done.stdout)
        self.write("torn.bvh", bvh_text().replace("\n1.000000 2.500000", "\n1.000000\n2.500000", 1))
        self.assert_fails("inspect torn.bvh", BAD_DATA,
                          "torn.bvh:19: found 1 number in the line, wanted a frame of 9, one for each channel")

    def test_a_bound_that_is_given_holds(self):
        if not CASES.exists():
            self.skipTest("no cases")
        for name, bound, measure, most in (("21_micron", "--position-tolerance 1e-7m", "translation_max", 1e-7),
                                           ("19_smallturn", "--tolerance 0.0001deg", "angle_max_deg", 1e-4),
                                           ("04_tiny", "--world-tolerance 0.1mm", "shell_distance_max", 1e-4),
                                           ("04_tiny", "--tolerance 0.2deg", "shell_distance_max", 1e-6)):
            tolerance = "" if "--tolerance" in bound or "--world" in bound else "--tolerance 1deg"
            done = self.run_command(f"reduce {CASES}/{name}.glb {tolerance} {bound} -o x.glb")
            self.assertNotIn("warning", done.stderr)
            self.assertLessEqual(self.json_of(f"difference {CASES}/{name}.glb x.glb")[measure], most, name)


if __name__ == "__main__":
    main()
