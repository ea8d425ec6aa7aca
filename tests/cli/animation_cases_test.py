#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Faults that people meet in files of animations, which lie beside the project: wrong frames, angles that jump, signs that flip."""
import json
import os
import pathlib
import unittest

from command import BAD_DATA, BAD_USAGE, CommandTest, main

CASES = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data")).parent / "cases/clips"
RECORDINGS = CASES.parent / "animation"


def frames_of(text):
    return [[float(word) for word in line.split()] for line in text.partition("Frame Time:")[2].splitlines()[1:]]


def largest_step(frames, columns):
    return max(abs(after[c] - before[c]) for before, after in zip(frames, frames[1:]) for c in columns)


@unittest.skipUnless(CASES.is_dir(), f"the animations are not beside the project, in {CASES}")
class AnimationCases(CommandTest):
    def json_of(self, command):
        return json.loads(self.output_of(f"{command} --json"))

    def test_a_run_of_wrong_frames_is_named_and_bridged(self):
        jump = CASES / "07_jump12.bvh"
        self.assertIn("\nbridged         frames 100 to 111, ", self.run_command(f"smooth {jump} -o clean.bvh").stderr)
        run, = self.json_of(f"smooth {jump} -o clean.bvh")["clips"][0]["runs"]
        self.assertEqual((run["joints"], run["first_frame"], run["frames"]), (["Hand"], 100, 12))
        self.assertAlmostEqual(run["jump_max_deg"], 60, delta=2)
        hand = range(9, 12)
        self.assertGreater(largest_step(frames_of(jump.read_text()), hand), 55)
        self.assertLess(largest_step(frames_of(self.read("clean.bvh")), hand), 2)

    def test_files_that_were_cut_off_are_salvaged_where_that_is_asked_for(self):
        for name, stated, whole in (("b10_framesmore", 25, 20), ("b27_truncated", 20, 19)):
            file = RECORDINGS / f"{name}.bvh"
            self.assert_fails(f"convert {file} -o cut.glb", BAD_DATA,
                              f"{file}:53: found {whole} whole frames, wanted {stated}, the number in line 31 (--salvage reads those that are whole)")
            self.assertFalse((self.folder / "cut.glb").exists())
            for command in ("convert {} --salvage -o cut.bvh", "smooth {} --salvage --smoothing-time 0.05 -o cut.bvh",
                            "sample {} --salvage --rate 30 -o cut.bvh", "clip {} --salvage --reverse -o cut.bvh"):
                told = self.run_command(command.format(file))
                self.assertEqual(told.returncode, 0, told.stderr)
                self.assertIn(f"{file}:53: found {whole} whole frames of the {stated} that the file states, read them", told.stderr)
            self.output_of(f"convert {file} --salvage -o cut.bvh")
            self.assertEqual(frames_of(self.read("cut.bvh")), frames_of(file.read_text())[:whole])
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n")
        self.assert_fails("convert keys.csv --salvage -o cut.csv", BAD_USAGE,
                          "--salvage: found a CSV file, which has no skeleton, wanted a file of skeletons")

    def test_a_run_is_kept_where_that_is_asked_for(self):
        kept = self.json_of(f"smooth {CASES / '07_jump12.bvh'} --no-runs -o kept.bvh")
        self.assertEqual(kept["clips"][0]["runs"], [])
        self.assertGreater(largest_step(frames_of(self.read("kept.bvh")), range(9, 12)), 10)

    def test_clean_clips_have_no_runs(self):
        runs = self.json_of(f"smooth {CASES / '20_mocap_true.bvh'} --smoothing-time 0.01 -o clean.bvh")["clips"][0]["runs"]
        self.assertEqual(runs, [])

    def test_feet_are_held_where_they_stand(self):
        walk = CASES / "20_mocap_jitter50ms.bvh"
        held = self.run_command(f"smooth {walk} --smoothing-time 0.05 --keep-contacts auto -o held.bvh")
        self.assertRegex(held.stderr, r"\ncontacts        \d+ contacts of 4 joints held; meanwhile they go ")
        contacts = self.json_of(f"smooth {walk} --smoothing-time 0.05 --keep-contacts LeftFoot,RightFoot -o held.bvh")["clips"][0]["contacts"]
        self.assertEqual({contact["joint"] for contact in contacts}, {"LeftFoot", "RightFoot"})
        for contact in contacts:
            self.assertLess(contact["slide"], 0.5 * contact["slide_before"])
        self.assert_fails(f"smooth {walk} --smoothing-time 0.05 --keep-contacts Hoof -o no.bvh", BAD_USAGE,
                          f"{walk}: --keep-contacts: found no joint 'Hoof', wanted names of the skeleton or auto")
        self.assertFalse((self.folder / "no.bvh").exists())

    def test_euler_angles_run_on_in_any_order_and_back(self):
        wraps = CASES / "06_gimbal_wraps.bvh"
        angles = [*range(3, 6), *range(6, 9), *range(9, 12)]
        self.assertGreater(largest_step(frames_of(wraps.read_text()), angles), 350)
        self.output_of(f"convert {wraps} --output-euler ZXY -o same.bvh")
        for order in ("ZYX", "XYZ", "XZY", "YXZ", "YZX"):
            self.output_of(f"convert {wraps} --output-euler {order} -o there.bvh")
            self.output_of("convert there.bvh --output-euler ZXY -o back.bvh")
            for name in ("there.bvh", "back.bvh"):
                self.assertLess(largest_step(frames_of(self.read(name)), angles), 60, (order, name))
            for found, wanted in zip(frames_of(self.read("back.bvh")), frames_of(self.read("same.bvh"))):
                for x, y in zip(found, wanted):
                    self.assertAlmostEqual((x - y + 180) % 360, 180, delta=1e-9)
        self.output_of(f"convert {wraps} --joint Arm --output-euler ZXY -o arm.csv")
        rows = [[float(cell) for cell in line.split(",")[1:4]] for line in self.read("arm.csv").splitlines() if line[0].isdigit()]
        self.assertLess(largest_step(rows, range(3)), 10)

    def test_signs_that_flip_between_cubic_keys_are_named_and_mended(self):
        flips, clean = CASES / "05_cubic_signflips.glb", CASES / "05_cubic_clean.glb"
        self.assertRegex(self.run_command(f"inspect {flips}").stderr, r"clip '.*', joint '.*': \d+ steps? of cubic rotations, .*--signs to shortest")
        self.assertGreater(self.json_of(f"difference {flips} {clean} --rate 60")["angle_max_deg"], 160)
        mended = self.run_command(f"convert {flips} --signs shortest -o mended.glb")
        self.assertEqual(mended.returncode, 0)
        self.assertNotIn("warning", mended.stderr)
        self.assertLess(self.json_of(f"difference mended.glb {clean} --rate 60")["angle_max_deg"], 1e-4)


if __name__ == "__main__":
    main()
