#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline clip`: cuts, loops, joined takes and the way of a root, from file to file, and what it refuses."""
import json
import math
import os
import pathlib
import struct

from command import BAD_DATA, BAD_USAGE, CommandTest, main, with_pages

WALK = pathlib.Path(__file__).resolve().parents[2] / "examples/data/walking.bvh"
CASES = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data")).parent / "cases"

HEAD = """HIERARCHY
ROOT hips
{{
OFFSET 0 0 0
CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
JOINT {leg}
{{
OFFSET 0 {offset} 0
CHANNELS 3 Zrotation Xrotation Yrotation
End Site
{{
OFFSET 0 -0.5 0
}}
}}
}}
MOTION
Frames: {frames}
Frame Time: 0.05
"""


def bvh(frames, leg="leg", offset=-0.5, ahead=0.1):
    """A leg that swings once in 20 frames, below hips that go ahead."""
    rows = "".join(f"{ahead * i:.9g} 0.9 0 0 0 0 {30 * math.sin(math.tau * i / 20):.9g} 0 0\n" for i in range(frames))
    return HEAD.format(leg=leg, offset=offset, frames=frames) + rows


class ClipCommand(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("walk.bvh", bvh(41))

    def clipped(self, arguments):
        return json.loads(self.output_of(f"clip {arguments} --json"))

    def inspected(self, name):
        return json.loads(self.output_of(f"inspect {name} --json"))

    def test_a_cut_has_exact_ends_and_starts_where_it_is_told(self):
        found = self.clipped("walk.bvh --from 0.42 --to 1.61 --shift 0 -o step.glb")["clips"][0]
        self.assertEqual((found["from_s"], found["to_s"], found["start_s"]), (0.42, 1.61, 0))
        clip = self.inspected("step.glb")["clips"][0]
        self.assertEqual(clip["start_s"], 0)
        self.assertAlmostEqual(clip["end_s"], 1.19, delta=1e-7)
        whole = self.output_of("convert walk.bvh -o whole.glb --quiet")
        self.assertEqual(whole, "")
        self.output_of("clip whole.glb --from 0.42 --to 1.61 --quiet -o part.glb")
        apart = json.loads(self.output_of("difference part.glb whole.glb --rate 997 --json"))["clips"][0]
        for joint in apart["joints"]:
            self.assertLess(joint["angle_deg"]["largest"], 1e-4)

    def test_several_clips_are_cut_in_one_run(self):
        path = CASES / "animation/17_loop.glb"
        if not path.exists():
            self.skipTest("the case is not there")
        clips = self.clipped(f"{path} --to 0.5 -o both.glb")["clips"]
        self.assertEqual([clip["clip"] for clip in clips], ["run", "run_short"])
        self.assertEqual({clip["end_s"] for clip in self.inspected("both.glb")["clips"]}, {0.5})

    def test_a_clip_that_lacks_its_closing_key_gets_it_and_is_not_bent(self):
        path = CASES / "animation/17_loop.glb"
        if not path.exists():
            self.skipTest("the case is not there")
        found = self.clipped(f"{path} --clip run_short --loop --root hips -o loop.glb")["clips"][0]
        self.assertEqual(found["loop"]["closing"], "frame")
        self.assertLess(found["seam_deg"], 1e-4)
        self.output_of(f"clip {path} --clip run --quiet -o run.glb")
        apart = json.loads(self.output_of("difference loop.glb run.glb --rate 240 --json"))["clips"][0]
        for joint in apart["joints"]:
            self.assertLess(joint["angle_deg"]["largest"], 0.1)

    def test_a_loop_is_closed_in_the_file(self):
        found = self.clipped("walk.bvh --to 0.8 --loop --root hips -o loop.glb")["clips"][0]
        self.assertEqual(found["loop"]["closing"], "bent")
        self.assertEqual(found["loop"]["rotation_change_deg"]["joint"], "leg")
        self.assertAlmostEqual(found["loop"]["travel"], 1.6, delta=0.05)
        self.assertLess(self.inspected("loop.glb")["clips"][0]["seam_deg"], 1e-4)

    def test_the_best_period_is_found(self):
        found = self.clipped("walk.bvh --loop --root hips --period-from 0.8s --period-to 1.2s --shift 0 -o round.bvh")["clips"][0]
        self.assertAlmostEqual(found["end_s"], 1.0, delta=1e-9)
        self.assertEqual(self.read("round.bvh").split("Frames: ")[1].split()[0], "21")

    def test_takes_are_joined(self):
        self.write("more.bvh", bvh(31, ahead=0.12))
        found = self.clipped("walk.bvh --append more.bvh --blend 0.25s -o all.bvh")["clips"][0]
        self.assertAlmostEqual(found["end_s"], 2.0 + 1.5 - 0.25, delta=1e-9)
        self.assertAlmostEqual(found["blend"]["start_s"], 1.75, delta=1e-9)
        self.assertEqual(self.read("all.bvh").split("Frames: ")[1].split()[0], "66")

    def test_a_walk_stays_in_place(self):
        self.output_of("clip walk.bvh --in-place hips --quiet -o here.bvh")
        rows = [line.split() for line in self.read("here.bvh").split("Frame Time: 0.05\n")[1].splitlines()]
        self.assertEqual({(float(row[0]), float(row[1]), float(row[2])) for row in rows}, {(0.0, 0.9, 0.0)})
        self.assertAlmostEqual(float(rows[5][6]), 30, delta=1e-4)

    def test_a_root_is_made_where_none_lies_above_the_joint(self):
        self.output_of("convert walk.bvh --quiet -o walk.glb")
        for source, made in (("walk.bvh", "rooted.bvh"), ("walk.bvh", "rooted.glb"), ("walk.glb", "again.glb")):
            found = self.clipped(f"{source} --extract-root hips -o {made}")
            self.assertEqual(found["made_root"], "root")
            self.output_of(f"sample {source} --joint leg --space world --rate 20 --quiet -o before.csv")
            self.output_of(f"sample {made} --joint leg --space world --rate 20 --quiet -o after.csv")
            before, after = ([[float(cell) for cell in line.split(",")] for line in self.read(name).splitlines()[1:]]
                             for name in ("before.csv", "after.csv"))
            self.assertEqual(len(before), len(after))
            for one, other in zip(before, after):
                for a, b in zip(one[:8], other[:8]):
                    self.assertAlmostEqual(a, b, delta=1e-5)
            self.output_of(f"sample {made} --joint root --rate 20 --quiet -o root.csv")
            last = [float(cell) for cell in self.read("root.csv").splitlines()[-1].split(",")]
            header = self.read("root.csv").splitlines()[0].split(",")
            self.assertAlmostEqual(last[header.index("px")], 4.0, delta=1e-5)

    def test_a_cut_beside_a_frame_is_written_at_the_rate_of_the_file(self):
        self.output_of("clip walk.bvh --from 0.4001 --to 1.6 --shift 0 --quiet -o part.bvh")
        self.assertIn("Frame Time: 0.05\n", self.read("part.bvh"))

    def test_a_cut_between_frames_keeps_the_rate_of_a_bvh_file(self):
        done = self.run_command("clip walk.bvh --from 0.42 --to 1.61 --shift 0 --quiet -o part.bvh")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "orispline: warning: part.bvh: the clip ends at 1.19 s, between two frames, of which the last one is at 1.15 s\n")
        self.assertIn("Frame Time: 0.05\n", self.read("part.bvh"))

    def test_a_loop_ends_on_a_frame_of_a_bvh_file(self):
        for arguments, said in (("--to 0.83", "20.4819 Hz instead of 20 Hz"), ("--to 0.83 --rate 15", "14.4578 Hz instead of 15 Hz")):
            done = self.run_command(f"clip walk.bvh {arguments} --loop --root hips --quiet -o loop.bvh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(done.stderr, f"orispline: warning: loop.bvh: the loop has frames at {said}, so that it ends on one\n")
            clip = self.inspected("loop.bvh")["clips"][0]
            self.assertAlmostEqual(clip["end_s"], 0.83, delta=1e-6)
            self.assertLess(clip["seam_deg"], 1e-3)

    def test_frames_of_bvh_are_even_whatever_keys_an_edit_leaves(self):
        self.write("lean.bvh", HEAD.format(leg="leg", offset=-0.5, frames=21) +
                   "".join(f"{i} 0.9 0 0 {40 - 4 * i} {9 * i} 0 0 0\n" for i in range(21)))
        for arguments, frames in (("lean.bvh --in-place hips", 21), ("walk.bvh --to 1.0001 --append walk.bvh --blend 0.5", 51),
                                  ("walk.bvh --reverse --rate 40", 81)):
            done = self.run_command(f"clip {arguments} --quiet -o even.bvh")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertNotIn("between two frames", done.stderr)
            self.assertEqual(self.read("even.bvh").split("Frames: ")[1].split()[0], str(frames), arguments)

    def test_keys_at_an_even_rate_keep_the_end(self):
        for command in ("clip", "sample"):
            self.output_of(f"{command} walk.bvh --rate 7 --quiet -o even.glb")
            clip = self.inspected("even.glb")["clips"][0]
            self.assertEqual((clip["start_s"], clip["end_s"]), (0, 2))
            self.assertEqual(clip["translation_keys"], 15)
        self.output_of("sample walk.bvh --rate 40 --quiet -o even.bvh")
        self.assertIn("Frames: 81\nFrame Time: 0.025\n", self.read("even.bvh"))
        found = json.loads(self.output_of("sample walk.bvh --rate 7 --json -o even.glb"))
        self.assertEqual(found["clips"][0]["end_s"], 2)
        self.assertEqual((found["input"], found["output"], found["warnings"]), ("walk.bvh", "even.glb", []))
        self.assert_fails("sample walk.bvh --count 7 -o even.glb", BAD_USAGE,
                          "--count: found a skeleton as a whole, which takes --rate alone, wanted --joint NAME and an output of one track, such as CSV")
        self.assert_fails("sample walk.bvh -o even.glb", BAD_USAGE,
                          "--rate is missing for a skeleton as a whole; 'orispline convert' keeps its keys")

    def test_what_is_wrong_is_one_line_and_nothing_is_written(self):
        self.write("other.bvh", bvh(31, leg="shin"))
        self.write("longer.bvh", bvh(31, offset=-0.6))
        self.write("few.bvh", bvh(2))
        for arguments, code, message in (
                ("walk.bvh --clip run", BAD_DATA, "walk.bvh: found no clip 'run', wanted one of 'walk'"),
                ("walk.bvh --from 3", BAD_USAGE, "walk.bvh: --from: clip 'walk': found 3 s, wanted a time of the clip, which is from 0 s to 2 s"),
                ("walk.bvh --from 1 --to 0.5", BAD_USAGE, "walk.bvh: --to: clip 'walk': found a part from 1 s to 0.5 s, wanted one that ends later than it starts"),
                ("few.bvh --loop", BAD_DATA, "few.bvh: clip 'few': found keys at 2 times, wanted 3 at least for a loop"),
                ("walk.bvh --loop --root hip", BAD_USAGE, "walk.bvh: --root: found 'hip', wanted the name of a joint; did you mean 'hips'?"),
                ("walk.bvh --append other.bvh", BAD_DATA, "walk.bvh: joint 'leg': found no such joint in the second file, wanted the same skeleton in both files"),
                ("walk.bvh --append longer.bvh", BAD_DATA, "walk.bvh: joint 'leg': found rest poses that differ by 0° and 0.1 of length, wanted the same skeleton in both files"),
                ("walk.bvh --append walk.bvh --blend 3s", BAD_USAGE, "walk.bvh: --blend: found 3 s, wanted less than the shorter of both clips, which takes 2 s")):
            self.assert_fails(f"clip {arguments} -o out.glb", code, message)
            self.assertFalse((self.folder / "out.glb").exists(), arguments)
        self.assert_fails("clip walk.bvh -o out.csv", BAD_USAGE,
                          "-o: found 'out.csv', wanted a file of skeletons, whose name ends in .bvh, .glb, .gltf, .vrm or .vrma")

    def test_a_loop_that_takes_a_way_back_names_the_option_that_keeps_it(self):
        done = self.run_command("clip walk.bvh --to 0.8 --loop -o loop.glb")
        self.assertIn("warning: walk.bvh: clip 'walk': joint 'hips' comes 1.6 far, which the loop takes back; --root names the joint "
                      "whose way a loop keeps\n", done.stderr)
        self.assertEqual(self.run_command("clip walk.bvh --to 0.8 --loop --root hips --quiet -o loop.glb").stderr, "")

    def test_it_says_what_way_was_taken_out(self):
        self.assertIn("taken out       the way of joint 'hips', which comes 4 far and turns 0°\n",
                      self.run_command("clip walk.bvh --in-place hips -o here.glb").stderr)
        self.assertEqual(self.clipped("walk.bvh --in-place hips -o here.glb")["clips"][0]["taken"]["turn_deg"], 0)

    @with_pages
    def test_it_has_a_page(self):
        self.output_of("clip walk.bvh --loop --root hips --quiet -o loop.glb --report loop.html")
        self.assertIn("loop.glb", self.read("loop.html"))

    def test_the_bundled_walk_is_cut_and_closed(self):
        self.output_of(f"clip {WALK} --from 0.4 --to 1.6 --loop --root Hips --shift 0 --quiet -o loop.glb")
        self.assertEqual(struct.unpack("<4sII", (self.folder / "loop.glb").read_bytes()[:12])[0], b"glTF")


if __name__ == "__main__":
    main()
