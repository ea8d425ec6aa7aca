#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""All joints of files of skeletons into a folder, whatever they are called."""
import json
import os
import pathlib

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, SUCCESS, main
from small_scenes import FRAMES, SceneTest, gltf_document


class Folders(SceneTest):
    def files_in(self, folder):
        return sorted(str(path.relative_to(self.folder / folder)) for path in (self.folder / folder).rglob("*") if path.is_file())

    def test_one_file_has_a_folder_for_each_clip(self):
        self.output_of("sample arm.bvh --rate 5 --output-folder out")
        self.assertEqual(self.files_in("out"), ["arm/Elbow.csv", "arm/Shoulder.csv"])
        for joint in ("Elbow", "Shoulder"):
            self.assertEqual(self.read(f"out/arm/{joint}.csv"), self.output_of(f"sample arm.bvh --joint {joint} --rate 5"))

    def test_a_file_that_is_too_large_is_refused_before_it_is_read(self):
        for name in ("large.bvh", "large.glb"):
            with open(self.folder / name, "wb") as file:
                file.truncate(2**31 + 1)  # holds no blocks of the disk
            self.assert_fails(f"inspect {name}", BAD_ACCESS, f"{name}: found more than 2 GiB, wanted a smaller file")

    def test_several_files_have_a_folder_each(self):
        (self.folder / "in/deep").mkdir(parents=True)
        os.rename(self.folder / "arm.bvh", self.folder / "in/deep/arm.1.bvh")
        os.rename(self.folder / "swing.gltf", self.folder / "in/swing.gltf")
        for inputs in ("in keys.csv", "in --inputs list.txt"):
            self.write("list.txt", "keys.csv\n")
            out = f"out{len(inputs)}"
            self.output_of(f"sample {inputs} --rate 5 --output-folder {out} --output-format tum")
            self.assertEqual(self.files_in(out), ["deep/arm.1/arm.1/Elbow.tum", "deep/arm.1/arm.1/Shoulder.tum", "keys.tum",
                                                  "swing/swing/base.tum", "swing/swing/tip.tum"])

    def test_the_summary_is_an_array_as_of_all_folders(self):
        report = self.json_of("sample arm.bvh --rate 5 --output-folder out")
        self.assertEqual(report, [{"input": "arm.bvh", "output": "out", "files": 2, "samples": 10, "warnings": []}])
        report = self.json_of("sample arm.bvh swing.gltf --method stored --rate 5 --output-folder out --all-or-none")
        self.assertEqual([(one["output"], one["files"]) for one in report], [("out/arm", 2), ("out/swing", 2)])

    def test_a_bad_file_is_named_and_the_others_are_written(self):
        self.write("bad.glb", "glTF, but no more")
        arguments = "sample bad.glb arm.bvh --rate 5 --output-folder out"
        done = self.run_command(arguments)
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertIn("orispline: bad.glb: ", done.stderr)
        self.assertEqual(self.files_in("out"), ["arm/arm/Elbow.csv", "arm/arm/Shoulder.csv"])
        self.assertEqual(self.run_command(f"{arguments}2 --all-or-none").returncode, BAD_DATA)
        self.assertEqual(self.files_in("out2"), [])

    def test_a_joint_that_cannot_be_sampled_leaves_nothing_behind(self):
        document = gltf_document()
        document["nodes"][0]["scale"] = [1, 2, 1]
        self.write("skew.gltf", json.dumps(document))
        self.assert_fails("sample skew.gltf --space world --rate 5 --output-folder out", BAD_DATA,
                          "skew.gltf: clip 'swing', joint 'base': found a scale that is zero, negative or not the same along all "
                          "axes, wanted another one for the world\norispline: 1 of 1 input failed; nothing was written")
        self.assertFalse((self.folder / "out").exists())

    def test_an_output_that_cannot_be_written_is_named_with_the_count_of_those_that_were(self):
        (self.folder / "out/arm/Elbow.csv").mkdir(parents=True)
        self.assert_fails("sample arm.bvh --rate 5 --output-folder out", BAD_ACCESS,
                          "out/arm/Elbow.csv: cannot write: Is a directory\norispline: 1 of 1 input failed; 1 file was written and is complete")
        self.assertEqual(self.files_in("out"), ["arm/Shoulder.csv"])

    def test_a_joint_that_is_named_is_taken_of_each_file(self):
        done = self.run_command("sample arm.bvh swing.gltf --joint Elbow --rate 5 --output-folder out")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertIn("swing.gltf: found no joint 'Elbow', wanted one of 'base'", done.stderr)
        self.assertEqual(self.files_in("out"), ["arm/arm/Elbow.csv"])

    def test_a_warning_of_many_joints_is_one_line(self):
        done = self.run_command("sample arm.bvh --from -1 --rate 5 --output-folder out --quiet")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (SUCCESS, 1), done.stderr)
        self.assertIn("--from -1 lies outside the curve", done.stderr)
        self.assertIn("so it is with 1 other joint\n", done.stderr)

    def test_names_become_names_of_files_and_no_two_are_the_same(self):
        document = gltf_document()
        swing = document["animations"][0]
        for name in ("", "", "x", "x", "..", "a/b", "a\nb\x1b[2J", "c" * 300, "c" * 299 + "d"):
            document["animations"].append(swing | {"name": name})
        document["nodes"][0]["name"], document["nodes"][1]["name"] = "ä" * 200, "ä" * 199 + "b"
        self.write("names.gltf", json.dumps(document))
        report, = self.json_of("sample names.gltf --rate 2 --output-folder out")
        files = self.files_in("out")
        self.assertEqual((len(files), report["files"]), (20, 20))
        self.assertEqual({pathlib.Path(path).parent.name for path in files},
                         {"swing", "animation 1", "animation 2", "x", "x_2", "_..", "a_b", "a_b_[2J", "c" * 200, "c" * 200 + "_2"})
        self.assertEqual({pathlib.Path(path).name for path in files}, {"ä" * 100 + ".csv", "ä" * 100 + "_2.csv"})

    def test_names_that_are_not_unique_cannot_choose(self):
        document = gltf_document()
        document["animations"] *= 2
        self.write("clips.gltf", json.dumps(document))
        document["animations"], document["nodes"][1]["name"] = document["animations"][:1], "base"
        self.write("joints.gltf", json.dumps(document))
        self.assert_fails("sample clips.gltf --clip swing --rate 2", BAD_DATA,
                          "clips.gltf: found 2 clips named 'swing', wanted a name of its own for each")
        self.assert_fails("sample joints.gltf --joint base --rate 2", BAD_DATA,
                          "joints.gltf: found 2 joints named 'base', wanted a name of its own for each")
        self.output_of("sample joints.gltf --joint base --rate 2 --output-folder out")
        self.assertEqual(self.files_in("out"), ["swing/base.csv", "swing/base_2.csv"])
        self.assertEqual(len(self.json_of("inspect swing.gltf --clip swing --clip swing")["clips"]), 1)

    def test_a_folder_that_cannot_be_is_told_before_the_work(self):
        self.write("file", "")
        for inputs in ("arm.bvh", "arm.bvh swing.gltf"):
            self.assert_fails(f"sample {inputs} --rate 5 --output-folder file/out", BAD_ACCESS,
                              "file/out: cannot make this folder: Not a directory")
        self.assert_fails("sample arm.bvh --rate 5 --output-folder out -o x.csv", BAD_USAGE,
                          "found -o and --output-folder, wanted one of them: a file for the samples, or their folder")

    def test_the_format_that_is_stated_makes_a_file_of_skeletons(self):
        os.rename(self.folder / "arm.bvh", self.folder / "arm.dat")
        self.output_of("sample arm.dat --input-format bvh --rate 5 --output-folder out")
        self.assertEqual(self.files_in("out"), ["arm/Elbow.csv", "arm/Shoulder.csv"])
        self.assertEqual(self.json_of("reduce arm.dat --input-format bvh --tolerance 1deg -o x.glb")["rotation_keys_before"],
                         2 * FRAMES)


if __name__ == "__main__":
    main()
