#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline retime` of whole skeletons: one clock for all joints, and what it refuses."""
import json
import math

from command import BAD_USAGE, CommandTest, main, with_pages

HEAD = """HIERARCHY
ROOT hips
{{
OFFSET 0 0 0
CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
JOINT leg
{{
OFFSET 0 -0.5 0
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


class RetimeClips(CommandTest):
    def setUp(self):
        super().setUp()
        rows = "".join(f"{0.1 * i:.9g} 0.9 0 {5 * math.sin(math.tau * i / 20):.9g} 0 0 {30 * math.sin(math.tau * i / 20):.9g} 0 0\n" for i in range(41))
        self.write("walk.bvh", HEAD.format(frames=41) + rows)

    def retimed(self, arguments):
        return json.loads(self.output_of(f"retime {arguments} --json"))

    def test_all_joints_are_slowed_by_the_fastest_one(self):
        fastest = 30 * math.tau
        found = self.retimed(f"walk.bvh --max-rate {fastest / 2}deg/s -o slow.glb")["clips"][0]
        self.assertAlmostEqual(found["time_scale"], 2, delta=0.01)
        self.assertEqual(found["rate_joint"], "leg")
        self.assertLessEqual(found["rate_bound_deg_s"], fastest / 2)
        clip = json.loads(self.output_of("inspect slow.glb --json"))["clips"][0]
        self.assertAlmostEqual(clip["end_s"], found["duration_after_s"], delta=1e-6)
        self.output_of("sample slow.glb --joint hips --rate 20 --quiet -o hips.csv")

    def test_a_duration_is_kept_in_bvh(self):
        self.output_of("retime walk.bvh --duration 4s --quiet -o slow.bvh")
        self.assertIn("Frames: 41\nFrame Time: 0.1\n", self.read("slow.bvh"))

    def test_intervals_have_times_of_their_own(self):
        alike = self.retimed("walk.bvh --max-rate 100deg/s -o alike.glb")["clips"][0]
        own = self.retimed("walk.bvh --max-rate 100deg/s --per-interval -o own.glb")["clips"][0]
        self.assertEqual(own["slowing"], "per-interval")
        self.assertLess(own["duration_after_s"], 0.9 * alike["duration_after_s"])

    def test_what_is_wrong_is_one_line(self):
        for arguments, code, message in (
                ("--constant-rate 10deg/s", BAD_USAGE, "--constant-rate: found a skeleton, wanted the keys of one track"),
                ("--max-speed 1m/s", BAD_USAGE, "--max-speed: found a BVH file, which has no unit of length, wanted glTF, as the conversion with "
                                                "--position-scale writes it"),
                ("--duration 1s --max-rate 100deg/s", BAD_USAGE, None)):
            done = self.run_command(f"retime walk.bvh {arguments} -o out.glb")
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            if message:
                self.assertIn(message, done.stderr)
            self.assertFalse((self.folder / "out.glb").exists())

    @with_pages
    def test_it_has_a_page(self):
        self.output_of("retime walk.bvh --duration 4s --quiet -o slow.glb --report slow.html")
        self.assertIn("slow.glb", self.read("slow.html"))


if __name__ == "__main__":
    main()
