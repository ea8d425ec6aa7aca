#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The pages of `reduce`, `smooth`, `difference` and `inspect` for files of skeletons: what they hold, and when they are written."""
import math

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, main, with_pages, without_pages
from small_scenes import (FRAMES, SceneTest, bvh_text, elbow_angle, parts_of_glb, product, samplers_of, shoulder_turn,
                          turn_about, turned)

TIMES = [frame * 0.0083333 for frame in range(FRAMES)]


def positions_of(poses, joints):
    """Of each time the places of all joints, in both motions."""
    width, steps, before = 3 * joints, [], []
    for i, number in enumerate(poses["before"]):
        steps.append(number + (steps[i - width] if i >= width else 0))
        before.append(steps[i] * poses["step"])
    after = [place + offset * poses["offset_step"] for place, offset in zip(before, poses["after"])]
    return [[row[k:k + width] for k in range(0, len(row), width)] for row in (before, after)]


@with_pages
class SceneReports(SceneTest):
    def reduced(self, options="--tolerance 0.5deg"):
        """The summary, and what the page shows."""
        report = self.json_of(f"reduce arm.bvh {options} -o small.glb --report page.html")
        return report, self.page("page.html")

    def test_the_page_of_reduce_says_what_the_summary_says(self):
        report, page = self.reduced()
        self.assertEqual(page["command"], "orispline reduce arm.bvh --tolerance 0.5deg -o small.glb --report page.html --json")
        keys = report["rotation_keys"]
        self.assertEqual(page["title"], f"arm.bvh within 0.5°: {keys} of {2 * FRAMES} keys of rotations")
        skeleton = page["skeleton"]
        self.assertEqual((skeleton["before"], skeleton["after"], skeleton["unit"]), ("arm.bvh", "small.glb", ""))
        self.assertEqual((skeleton["angle_limit"], skeleton["distance_limit"]), (0.5, None))
        self.assertEqual([(joint["name"], joint["parent"]) for joint in skeleton["joints"]],
                         [("Shoulder", None), ("Elbow", 0), ("Elbow_End", 1)])
        clip = skeleton["clips"][0]
        self.assertEqual((clip["name"], clip["rotation_keys"]), ("arm", [2 * FRAMES, keys]))
        for of_joint, of_report, step in (("angle_deg", "angle_deg", "angle_step"),
                                          ("distance", "shell_distance_m", "distance_step")):
            at_frames, anywhere = max(joint[of_joint][0] for joint in clip["joints"]), report[of_report]["largest"]
            self.assertLessEqual(at_frames, anywhere + 0.51 * clip["errors"][step])
            self.assertGreater(at_frames, 0.9 * anywhere)

    def test_the_page_has_the_joints_in_the_world_in_both_motions(self):
        _, page = self.reduced()
        clip = page["skeleton"]["clips"][0]
        before, after = positions_of(clip["poses"], 3)
        self.assertEqual(len(before), FRAMES)
        worst = max(joint["distance"][0] for joint in clip["joints"])
        for frame in range(FRAMES):
            shoulder = shoulder_turn(frame)
            elbow = [a + b for a, b in zip((1, 2.5, 3), turned(shoulder, (0.3, 0, 0)))]
            tip = turned(product(shoulder, turn_about(2, elbow_angle(frame))), (0.25, 0, 0))
            wanted = [1, 2.5, 3, *elbow, *(a + b for a, b in zip(elbow, tip))]
            for found, place in zip(before[frame], wanted):
                self.assertAlmostEqual(found, place, delta=clip["poses"]["step"])
            self.assertLessEqual(math.dist(before[frame][6:], after[frame][6:]), worst + 2 * clip["poses"]["offset_step"])

    def test_the_page_has_the_keys_and_the_errors_of_every_joint(self):
        _, page = self.reduced()
        clip = page["skeleton"]["clips"][0]
        document, _ = parts_of_glb(self.folder / "small.glb")
        counts = [document["accessors"][sampler["input"]]["count"] for sampler in samplers_of(document, "rotation").values()]
        self.assertEqual(sorted(len(joint["key_t"]) for joint in clip["joints"]), sorted([0, *counts]))
        errors = clip["errors"]
        for time, frame in zip(errors["t"], TIMES):
            self.assertAlmostEqual(time, frame, delta=1e-6)
        self.assertEqual((errors["angle_deg"][2], len(errors["distance"][2])), ([], FRAMES))
        for joint, steps in enumerate(errors["angle_deg"][:2]):
            largest, time = clip["joints"][joint]["angle_deg"]
            self.assertAlmostEqual(max(steps) * errors["angle_step"], largest, delta=errors["angle_step"])
            at = max(i for i in range(FRAMES) if errors["t"][i] <= time + 1e-6)
            self.assertLessEqual(max(steps) - steps[at], 1)

    def test_a_tolerance_in_the_world_is_shown_in_its_unit(self):
        _, page = self.reduced("--world-tolerance 2mm --position-scale 0.5")
        skeleton = page["skeleton"]
        self.assertEqual((skeleton["unit"], skeleton["angle_limit"], skeleton["distance_limit"], skeleton["shell"]),
                         ("mm", None, 2, 30))
        self.assertEqual(page["title"].partition(":")[0], "arm.bvh within 0.002 m in the world")
        self.assertAlmostEqual(skeleton["clips"][0]["poses"]["before"][0] * skeleton["clips"][0]["poses"]["step"], 500, delta=1)

    def test_difference_shows_both_files(self):
        self.output_of("reduce arm.bvh --tolerance 0.5deg -o small.glb")
        report = self.json_of("difference arm.bvh small.glb --rate 500 --report page.html")
        self.assertEqual(self.json_of("difference arm.bvh small.glb --rate 500"), report)
        page = self.page("page.html")
        self.assertEqual((page["title"], page["notes"][0]),
                         ("arm.bvh and small.glb", "Both motions are compared at every key of arm.bvh, 500 times per second, and where they differ most between these times."))
        clip = page["skeleton"]["clips"][0]
        self.assertEqual(len(clip["errors"]["t"]), 600)
        self.assertAlmostEqual(max(joint["distance"][0] for joint in clip["joints"]), report["shell_distance_max"],
                               delta=0.51 * clip["errors"]["distance_step"])
        found = max((joint["angle_deg"] for joint in report["clips"][0]["joints"]), key=lambda angle: angle["largest"])
        shown = max(joint["angle_deg"] for joint in clip["joints"])
        self.assertAlmostEqual(shown[1], found["time_s"], delta=1e-6)
        self.assertNotAlmostEqual(shown[1] * 500, round(shown[1] * 500), delta=1e-3)

    def test_difference_says_what_only_one_file_has(self):
        self.write("other.bvh", bvh_text().replace("JOINT Elbow", "JOINT Knee"))
        self.output_of("difference arm.bvh other.bvh --report page.html")
        page = self.page("page.html")
        self.assertIn("Only arm.bvh has 2 joints that are shown in grey and not compared.", page["notes"])
        self.assertEqual([joint["is_compared"] for joint in page["skeleton"]["joints"]], [True, False, False])

    def test_glTF_is_shown_in_millimetres(self):
        self.output_of("difference swing.gltf swing.gltf --report page.html")
        skeleton = self.page("page.html")["skeleton"]
        self.assertEqual((skeleton["unit"], skeleton["shell"]), ("mm", 30))
        self.assertGreater(len(skeleton["clips"][0]["poses"]["t"]), 50)  # of two keys, which are far apart

    def test_smooth_shows_the_clips_before_and_after(self):
        report = self.json_of("smooth arm.bvh --smoothing-time 0.02 -o clean.bvh --report page.html")
        self.assertEqual(self.json_of("smooth arm.bvh --smoothing-time 0.02 -o clean.bvh"), report)
        page = self.page("page.html")
        self.assertEqual(page["command"], "orispline smooth arm.bvh --smoothing-time 0.02 -o clean.bvh --report page.html --json")
        found, = report["clips"]
        rejected = sum(joint["rejected"] for joint in found["joints"])
        self.assertEqual(page["title"], f"arm.bvh smoothed: 2 rotations of 1 clip, {rejected} samples rejected")
        self.assertEqual((page["notes"][0], page["notes"][-1]),
                         ("The smoothing time is 0.02 s.", "Both motions are compared at every key of the input."))
        skeleton = page["skeleton"]
        self.assertEqual((skeleton["before"], skeleton["after"], skeleton["unit"]), ("arm.bvh", "clean.bvh", ""))
        clip = skeleton["clips"][0]
        self.assertEqual(clip["rotation_keys"], [2 * FRAMES, 2 * FRAMES])
        self.assertEqual([joint["name"] for joint in skeleton["joints"][:2]], [joint["joint"] for joint in found["joints"]])
        for shown, joint in zip(clip["joints"], found["joints"]):
            self.assertAlmostEqual(shown["angle_deg"][0], joint["change_max_deg"], delta=0.51 * clip["errors"]["angle_step"])
            self.assertEqual(len(shown["key_t"]), joint["rejected"])
        before, after = positions_of(clip["poses"], 3)
        self.assertGreater(max(math.dist(a[6:], b[6:]) for a, b in zip(before, after)), 0)

    def test_smooth_says_what_it_left_and_warns_of(self):
        self.write("short.bvh", bvh_text(frames=10))
        self.output_of("smooth short.bvh -o clean.bvh --report page.html")
        notes = self.page("page.html")["notes"]
        self.assertIn("Rotations that rest, are steps or splines, or have too few keys are left as they are: 2.", notes)

    def test_inspect_shows_the_motion_of_the_file(self):
        plain = self.output_of("inspect arm.bvh")
        self.assertEqual(self.output_of("inspect arm.bvh --report page.html"), plain)
        page = self.page("page.html")
        self.assertEqual((page["title"], page["command"]), ("arm.bvh: 3 joints, 1 clip", "orispline inspect arm.bvh --report page.html"))
        skeleton = page["skeleton"]
        self.assertEqual((skeleton["before"], skeleton["after"], skeleton["unit"]), ("arm.bvh", "", ""))
        clip = skeleton["clips"][0]
        self.assertEqual((clip["rotation_keys"], clip["poses"]["after"]), ([2 * FRAMES, 0], []))
        self.assertEqual([len(joint["key_t"]) for joint in clip["joints"]], [FRAMES, FRAMES, 0])
        elbows = [abs(elbow_angle(frame) - elbow_angle(0)) for frame in range(FRAMES)]
        self.assertAlmostEqual(clip["joints"][1]["angle_deg"][0], max(elbows), delta=1e-4)

    def test_inspect_shows_the_chosen_clips_or_the_curve_of_a_joint(self):
        self.output_of("inspect swing.gltf --clip swing --report page.html")
        self.assertEqual([clip["name"] for clip in self.page("page.html")["skeleton"]["clips"]], ["swing"])
        self.output_of("inspect arm.bvh --joint Elbow --report page.html")
        page = self.page("page.html")
        self.assertEqual([method["name"] for method in page["methods"]], ["auto"])
        self.assertEqual(len(page["keys"]["t"]), FRAMES)

    def test_the_page_is_another_file_than_those_of_the_command(self):
        reduce = "reduce arm.bvh --tolerance 1deg -o small.glb --report"
        for name, other in (("small.glb", "that of -o"), ("./arm.bvh", "INPUT")):
            self.assert_fails(f"{reduce} {name}", BAD_USAGE, f"--report: found '{name}', wanted another file than {other}")
        smooth = "smooth arm.bvh -o clean.bvh --report"
        for name, other in (("clean.bvh", "that of -o"), ("./arm.bvh", "INPUT")):
            self.assert_fails(f"{smooth} {name}", BAD_USAGE, f"--report: found '{name}', wanted another file than {other}")
        self.assert_fails("inspect swing.gltf --report ./swing.gltf", BAD_USAGE,
                          "--report: found './swing.gltf', wanted another file than INPUT")
        for command in (smooth.removesuffix(" --report"), "inspect arm.bvh"):
            self.assert_fails(f"{command} --report -", BAD_USAGE, "--report: found '-', wanted the name of a file")
        self.assertFalse((self.folder / "clean.bvh").exists())
        self.assert_fails(f"{reduce} -", BAD_USAGE, "--report: found '-', wanted the name of a file")
        for name, other in (("arm.bvh", "FIRST"), ("swing.gltf", "SECOND")):
            self.assert_fails(f"difference arm.bvh swing.gltf --report {name}", BAD_USAGE,
                              f"--report: found '{name}', wanted another file than {other}")
        self.assertFalse((self.folder / "small.glb").exists())

    def test_an_older_page_stays_where_something_fails(self):
        self.write("old.html", "old")
        self.write("bad.bvh", "HIERARCHY\n")
        for arguments, code in (("reduce bad.bvh --tolerance 1deg -o small.glb", BAD_DATA),
                                ("reduce arm.bvh --tolerance 1deg -o nowhere/small.glb", BAD_ACCESS),
                                ("smooth bad.bvh -o clean.bvh", BAD_DATA),
                                ("smooth arm.bvh -o nowhere/clean.bvh", BAD_ACCESS),
                                ("smooth arm.bvh --sigma -o clean.bvh", BAD_USAGE),
                                ("inspect bad.bvh", BAD_DATA),
                                ("inspect arm.bvh --clip nod", BAD_DATA),
                                ("difference arm.bvh bad.bvh", BAD_DATA),
                                ("difference arm.bvh arm.bvh --rate 0", BAD_USAGE)):
            done = self.run_command(f"{arguments} --report old.html")
            self.assertEqual((done.returncode, self.read("old.html")), (code, "old"), arguments)
        for arguments in ("reduce arm.bvh --tolerance 1deg -o small.glb", "smooth arm.bvh -o clean.bvh", "inspect arm.bvh"):
            done = self.run_command(f"{arguments} --report nowhere/page.html")
            self.assertEqual((done.returncode, done.stdout), (BAD_ACCESS, ""))
            self.assertIn("nowhere/page.html", done.stderr)
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name.startswith(("small", "clean"))], [])
        self.assertEqual([path.name for path in self.folder.iterdir() if "part" in path.name], [])


@without_pages
class NoReports(SceneTest):
    def test_a_build_without_pages_says_so_at_once(self):
        for command in ("smooth arm.bvh -o clean.bvh", "inspect arm.bvh", "inspect arm.bvh --joint Elbow"):
            self.assert_fails(f"{command} --report page.html", BAD_USAGE,
                              "--report: orispline was built without pages, wanted a build with ORISPLINE_PAGE")
        self.assertEqual([path.name for path in self.folder.iterdir() if path.name.startswith(("clean", "page"))], [])


if __name__ == "__main__":
    main()
