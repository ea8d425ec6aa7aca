#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What commands refuse of files of skeletons, in which words, and that old files stay."""
import json
import shutil
import struct

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, main
from small_scenes import SceneTest, gltf_document


class Refused(SceneTest):
    def setUp(self):
        super().setUp()
        self.write("old.glb", "old")
        self.write("old.csv", "old")

    def assert_refused(self, arguments, code, *parts):
        """One line that has all the parts; nothing on standard output, and the old files as they were."""
        done = self.run_command(arguments)
        self.assertEqual((done.returncode, done.stdout), (code, ""), done.stderr)
        lines = done.stderr.splitlines()
        self.assertEqual(len(lines), 1, done.stderr)
        for part in parts:
            self.assertIn(part, lines[0])
        for name in ("old.glb", "old.csv"):
            self.assertEqual(self.read(name), "old", arguments)
        self.assertEqual([path.name for path in self.folder.iterdir() if ".part" in path.name], [])

    def test_bad_choices_leave_the_old_output(self):
        joints = "wanted one of 'Shoulder', 'Elbow'"
        for arguments, code, *parts in (
                ("reduce arm.bvh -o old.glb", BAD_USAGE, "--tolerance or --world-tolerance is missing"),
                ("reduce arm.bvh --tolerance 1deg -o arm2.bvh", BAD_USAGE, "-o: ", "wanted glTF"),
                ("reduce arm.bvh --tolerance 1deg -o old.csv", BAD_DATA, "found 2 joints", joints, "--joint NAME"),
                ("reduce arm.bvh --joint Elbow --world-tolerance 1mm -o old.csv", BAD_USAGE, "--world-tolerance", "glTF"),
                ("reduce arm.bvh --joint Elbow --tolerance 1deg -o old.glb", BAD_USAGE, "--joint: found"),
                ("reduce arm.bvh --joint Elbow --tolerance 1deg --method cubicspline -o old.csv", BAD_USAGE, "'cubicspline'"),
                ("reduce arm.bvh --tolerance 1deg --refit -o old.glb", BAD_USAGE, "--refit"),
                ("reduce arm.bvh --tolerance 1deg --method bspline -o old.glb", BAD_USAGE, "arm.bvh", "bspline"),
                ("reduce arm.bvh --tolerance 0deg -o old.glb", BAD_USAGE, "--tolerance: found '0deg'"),
                ("reduce arm.bvh --tolerance 1deg --shell -1cm -o old.glb", BAD_USAGE, "--shell: found '-1cm'"),
                ("reduce arm.bvh --tolerance 1deg --clip other -o old.glb", BAD_DATA, "found no clip 'other', wanted one of 'arm'"),
                ("reduce keys.csv --tolerance 1deg --joint Elbow -o old.csv", BAD_USAGE, "--joint: found a CSV file"),
                ("reduce arm.bvh --world-tolerance 1mm -o old.glb", BAD_USAGE, "no unit of length", "--position-scale"),
                ("reduce keys.csv --tolerance 1deg --position-scale 1 -o old.csv", BAD_USAGE, "--position-scale: found"),
                ("reduce arm.bvh --tolerance 1deg --fps 30 -o old.glb", BAD_USAGE, "--fps: found a BVH file, which is no table"),
                ("sample arm.bvh --joint Elbow --conjugate --rate 10 -o old.csv", BAD_USAGE, "--conjugate: found a BVH file"),
                ("convert arm.bvh --rate 30 -o old.glb", BAD_USAGE, "--rate: found an output that keeps"),
                ("convert arm.bvh -o arm.bvh", BAD_USAGE, "-o: found 'arm.bvh', wanted another file than INPUT"),
                ("convert arm.bvh --joint Elbow -o old.glb", BAD_USAGE, "--joint: found"),
                ("convert arm.bvh --joint Wrist -o old.csv", BAD_DATA, "found no joint 'Wrist'", joints),
                ("convert arm.bvh -o old.csv", BAD_DATA, "found 2 joints", joints, "--joint NAME"),
                ("convert arm.bvh --output-euler ZXZ -o old.glb", BAD_USAGE, "--output-euler: found 'ZXZ'"),
                ("sample arm.bvh --rate 10 -o old.csv", BAD_DATA, "clip 'arm': found 2 joints", joints, "--joint NAME"),
                ("sample arm.bvh --joint Elbow --rate 10 -o old.glb", BAD_USAGE, "--joint: found an output that holds all joints"),
                ("sample keys.csv --clip arm --rate 10 -o old.csv", BAD_USAGE, "--clip: found a CSV file"),
                ("sample keys.csv --space world --rate 10 -o old.csv", BAD_USAGE, "--space: found a CSV file"),
                ("sample keys.csv --tolerance 1deg --rate 10 -o old.glb", BAD_USAGE, "--tolerance: found --rate"),
                ("sample keys.csv --tolerance 1deg -o old.csv", BAD_USAGE, "--rate"),
                ("sample keys.csv --tolerance 1deg -o keys.bvh", BAD_USAGE, "-o: found", "wanted glTF"),
                ("difference arm.bvh swing.gltf --shell 0cm", BAD_USAGE, "--shell: found '0cm'"),
                ("difference arm.bvh swing.gltf --rate 0", BAD_USAGE, "--rate: found '0'"),
                ("difference arm.bvh keys.csv", BAD_USAGE, "keys.csv", ".bvh", ".glb, .gltf"),
                ("difference arm.bvh nothing.glb", BAD_ACCESS, "nothing.glb: cannot read"),
                ("inspect arm.bvh --joint Wrist", BAD_DATA, "found no joint 'Wrist'", joints)):
            with self.subTest(arguments):
                self.assert_refused(arguments, code, *parts)

    def test_files_of_other_things_are_named(self):
        (self.folder / "noise.glb").write_bytes(bytes(range(1, 200)))
        (self.folder / "empty.glb").write_bytes(b"")
        (self.folder / "cut.glb").write_bytes(b"glTF" + struct.pack("<II", 2, 4000) + struct.pack("<I4s", 3900, b"JSON") + b"{}")
        self.write("text.bvh", "not a hierarchy\n")
        self.write("three.gltf", json.dumps(gltf_document() | {"asset": {"version": "3.0"}}))
        for name in ("noise.glb", "empty.glb", "cut.glb", "text.bvh", "three.gltf"):
            for arguments in (f"inspect {name}", f"convert {name} -o old.glb", f"reduce {name} --tolerance 1deg -o old.glb",
                              f"difference arm.bvh {name}"):
                with self.subTest(arguments):
                    self.assert_refused(arguments, BAD_DATA, f"{name}")

    def test_an_unknown_extension_is_no_file_of_skeletons(self):
        shutil.copy(self.folder / "arm.bvh", self.folder / "arm.usd")
        self.assert_refused("difference arm.bvh arm.usd", BAD_USAGE, "arm.usd: ", ".bvh", ".glb, .gltf")
        self.assert_refused("convert arm.bvh -o arm.abc", BAD_USAGE, "-o: found 'arm.abc'")

    def test_a_place_that_is_not_there_is_told(self):
        self.assert_refused("convert arm.bvh -o nowhere/arm.glb", BAD_ACCESS, "nowhere/arm.glb")
        self.assert_refused("reduce arm.bvh --tolerance 1deg -o nowhere/arm.glb", BAD_ACCESS, "nowhere/arm.glb")


if __name__ == "__main__":
    main()
