#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Files of skeletons through the command, on small ones whose motion is known."""
import json
import math
import pathlib
import shutil
import struct

from command import BAD_DATA, BAD_USAGE, main, rows_of
from small_scenes import (BVH_HIERARCHY, FRAMES, SPLINE, SPLINE_TIMES, SceneTest, angle_between, elbow_angle,
                          gltf_document, parts_of_glb, product, samplers_of, shoulder_turn, spline_at, turn_about,
                          turned)

ROOT = pathlib.Path(__file__).resolve().parents[2]


class SmallScenes(SceneTest):
    def test_inspect_counts_what_the_file_holds(self):
        report = self.json_of("inspect arm.bvh")
        self.assertEqual((report["input_format"], report["joints"]), ("bvh", ["Shoulder", "Elbow", "Elbow_End"]))
        self.assertEqual((report["rotation_tracks"], report["rotation_keys"]), (2, 2 * FRAMES))
        self.assertEqual((report["translation_tracks"], report["translation_keys"]), (1, FRAMES))
        self.assertEqual([clip["name"] for clip in report["clips"]], ["arm"])
        self.assertEqual(report["clips"][0]["end_s"], 120 * 0.0083333)
        text = self.output_of("inspect swing.gltf")
        self.assertIn("\nrotations     1 track with 3 keys, 0 of them constant\n", text)
        self.assertIn("\ntranslations  1 track with 2 keys\n", text)
        self.assertRegex(text, r"\n  swing +2 s +1 +3 ")

    def test_a_recording_is_the_same_after_glTF(self):
        self.output_of("convert arm.bvh -o arm.glb")
        self.output_of("convert arm.glb -o back.bvh")
        report = self.json_of("difference arm.bvh back.bvh")
        self.assertLess(report["angle_max_deg"], 1e-4)
        self.assertLess(report["shell_distance_max"], 1e-6)
        self.assertEqual(report["clips"][0]["times"], FRAMES)
        self.assertIn("\nFrame Time: 0.0083333\n", self.read("back.bvh"))

    def test_gltf_is_in_metres_where_the_unit_of_a_recording_is_stated(self):
        for command in ("convert arm.bvh", "smooth arm.bvh", "sample arm.bvh --rate 30", "clip arm.bvh --reverse", "retime arm.bvh --duration 3s",
                        "reduce arm.bvh --tolerance 0.001deg"):
            self.output_of(f"{command} -o as_it_is.glb")
            self.output_of(f"{command} --position-scale 0.01 -o metres.glb")
            ways = []
            for name, scale in (("as_it_is", 1.0), ("metres", 0.01)):
                elbow, = (node for node in parts_of_glb(self.folder / f"{name}.glb")[0]["nodes"] if node["name"] == "Elbow")
                self.assertLess(math.dist(elbow["translation"], (0.3 * scale, 0, 0)), 1e-8)
                self.output_of(f"convert {name}.glb --joint Shoulder -o way.csv")
                ways.append([row[5:8] for row in rows_of(self.read("way.csv"))])
            self.assertEqual(len(ways[0]), len(ways[1]))
            for place, scaled in zip(*ways):
                self.assertLess(math.dist([0.01 * x for x in place], scaled), 1e-7)

    def test_a_height_that_no_person_has_is_warned_of_with_the_scale_that_gives_one(self):
        self.write("tall.bvh", self.read("arm.bvh").replace("OFFSET 0.30 0 0", "OFFSET 60 0 0"))
        for command in ("convert", "smooth", "clip", "reduce --tolerance 0.1deg"):
            self.assertIn("x.glb: the skeleton is 60", self.run_command(f"{command} tall.bvh -o x.glb").stderr)
        done = self.run_command("convert tall.bvh -o x.glb")
        self.assertRegex(done.stderr, r"m large at rest; the --position-scale 0\.0254 makes it 1\.5\d m, as it is if the file is in inches\n")
        self.assertNotIn("large at rest", self.run_command("convert tall.bvh --position-scale 0.0254 -o x.glb").stderr)
        self.assertNotIn("large at rest", self.run_command("convert tall.bvh --output-euler XYZ -o x.bvh").stderr)

    def test_a_frame_is_taken_as_the_rest_pose(self):
        self.output_of("convert arm.bvh -o arm.glb")
        self.output_of("convert arm.bvh --rest-frame 40 -o posed.glb")
        self.assertLess(self.json_of("difference arm.glb posed.glb")["angle_max_deg"], 1e-4)
        self.output_of("convert arm.bvh --joint Elbow -o elbow.csv")
        w, *vector = rows_of(self.read("elbow.csv"))[40][1:5]
        elbow, = (node for node in parts_of_glb(self.folder / "posed.glb")[0]["nodes"] if node["name"] == "Elbow")
        self.assertAlmostEqual(abs(sum(a * b for a, b in zip(elbow["rotation"], (*vector, w)))), 1, delta=1e-7)
        for arguments, found in (("arm.bvh --rest-frame 121", "arm.bvh: --rest-frame: found 121, wanted a frame of the file, from 0 to 120"),
                                 ("arm.bvh --rest-frame first", "--rest-frame: found 'first', wanted the number of a frame, from 0"),
                                 ("arm.glb --rest-frame 0", "--rest-frame: found a glTF file, which states its rest pose, wanted BVH")):
            self.assertIn(found, self.run_command(f"convert {arguments} -o x.glb").stderr)

    def test_a_unit_of_what_has_or_keeps_one_is_refused(self):
        self.output_of("convert arm.bvh -o arm.glb")
        for arguments, code, found in (
                ("convert arm.bvh --position-scale 0 -o x.glb", BAD_USAGE, "--position-scale: found '0', wanted a number greater than 0"),
                ("smooth arm.bvh --position-scale cm -o x.glb", BAD_USAGE, "--position-scale: found 'cm', wanted a number greater than 0"),
                ("convert arm.bvh --joint Elbow --position-scale 0.01 -o x.csv", BAD_USAGE,
                 "--position-scale: found an output of one track, wanted a skeleton in .glb, .gltf, .vrm or .vrma"),
                ("sample arm.bvh --joint Elbow --rate 30 --position-scale 0.01 -o x.csv", BAD_USAGE,
                 "--position-scale: found an output of one track, wanted a skeleton in .glb, .gltf, .vrm or .vrma"),
                ("clip arm.bvh --position-scale 0.01 -o x.bvh", BAD_USAGE,
                 "--position-scale: found an output that is a BVH file, which has no unit of length and keeps that of the input, wanted glTF"),
                ("convert arm.glb --position-scale 0.01 -o x.glb", BAD_USAGE,
                 "--position-scale: found a glTF file, whose lengths are in metres, wanted a file without a unit, such as BVH")):
            done = self.run_command(arguments)
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(found, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertFalse((self.folder / arguments.split()[-1]).exists())

    def test_a_joint_is_the_same_after_CSV(self):
        self.output_of("convert arm.bvh -o arm.glb")
        for joint in ("Shoulder", "Elbow"):
            self.output_of(f"convert arm.glb --joint {joint} -o joint.csv")
            self.output_of("convert joint.csv -o joint.glb")
            self.output_of("convert joint.glb -o back.csv")
            rows, back = rows_of(self.read("joint.csv")), rows_of(self.read("back.csv"))
            self.assertEqual([row[0] for row in back], [row[0] for row in rows])
            self.assertEqual(len(rows), FRAMES)
            self.assertLess(max(angle_between(p[1:5], q[1:5]) for p, q in zip(rows, back)), 1e-4)
            self.assertLess(max(math.dist(p[5:], q[5:]) for p, q in zip(rows, back)), 1e-6)

    def test_a_recording_written_as_BVH_keeps_its_hierarchy_and_its_angles(self):
        self.output_of("convert arm.bvh -o back.bvh")
        self.assertEqual(self.read("back.bvh").partition("MOTION")[0], BVH_HIERARCHY)
        report = self.json_of("difference arm.bvh back.bvh")
        self.assertEqual((report["angle_max_deg"], report["translation_max"]), (0, 0))

    def test_what_is_no_animation_passes_through_reduce(self):
        self.output_of("reduce swing.gltf --tolerance 1deg -o small.gltf")
        before, after = gltf_document(), json.loads(self.read("small.gltf"))
        for name in ("asset", "extensionsUsed", "extensions", "scenes", "nodes", "meshes"):
            self.assertEqual(after[name], before[name], name)
        self.assertEqual(after["accessors"][4], before["accessors"][4] | {"bufferView": after["accessors"][4]["bufferView"]})

    def test_reduce_holds_its_tolerance_at_every_frame(self):
        for tolerance in (0.05, 0.5):
            report = self.json_of(f"reduce arm.bvh --tolerance {tolerance}deg -o small.glb")
            self.assertEqual((report["method"], report["rotation_tracks"]), ("cubicspline", 2))
            self.assertEqual(report["rotation_keys_before"], 2 * FRAMES)
            self.assertLess(report["rotation_keys"], 2 * FRAMES / 5)
            self.assertEqual(report["bytes"], (self.folder / "small.glb").stat().st_size)
            found = self.json_of("difference arm.bvh small.glb")
            self.assertLessEqual(found["angle_max_deg"], tolerance)
            self.assertLessEqual(report["angle_deg"]["largest"], tolerance, "between the frames as well")
            for at_frames, anywhere in ((found["angle_max_deg"], report["angle_deg"]["largest"]),
                                        (found["shell_distance_max"], report["shell_distance_m"]["largest"])):
                self.assertLessEqual(at_frames, anywhere * 1.00001)
                self.assertGreater(at_frames, 0.9 * anywhere)
            document, _ = parts_of_glb(self.folder / "small.glb")
            samplers = samplers_of(document, "rotation").values()
            self.assertEqual(sum(document["accessors"][s["input"]]["count"] for s in samplers), report["rotation_keys"])
            self.assertEqual({s["interpolation"] for s in samplers}, {"CUBICSPLINE"})

    def test_geodesics_are_written_as_linear(self):
        report = self.json_of("reduce arm.bvh --tolerance 0.5deg --method slerp -o small.glb")
        document, _ = parts_of_glb(self.folder / "small.glb")
        self.assertEqual({s.get("interpolation", "LINEAR") for s in samplers_of(document, "rotation").values()}, {"LINEAR"})
        self.assertLessEqual(self.json_of("difference arm.bvh small.glb")["angle_max_deg"], 0.5)
        self.assertLess(report["rotation_keys"], FRAMES)

    def test_a_tolerance_in_the_world_holds_for_the_shell(self):
        report = self.json_of("reduce arm.bvh --world-tolerance 2mm --shell 10cm --position-scale 1 -o small.glb")
        found = self.json_of("difference arm.bvh small.glb --shell 10cm")
        self.assertLessEqual(found["shell_distance_max"], 0.002)
        self.assertLessEqual(found["shell_distance_max"], report["shell_distance_m"]["largest"] * 1.00001)
        self.assertLessEqual(report["shell_distance_m"]["largest"], 0.002, "between the frames as well")
        self.assertLess(report["rotation_keys"], FRAMES / 4)

    def test_closed_tracks_have_the_same_tangents_at_both_ends(self):
        report = self.json_of("reduce arm.bvh --tolerance 0.2deg --closed -o small.glb")
        self.assertEqual(report["open_tracks"], 1)
        document, data = parts_of_glb(self.folder / "small.glb")
        shoulder = samplers_of(document, "rotation")["arm", 0]
        accessor = document["accessors"][shoulder["output"]]
        view = document["bufferViews"][accessor["bufferView"]]
        at = view.get("byteOffset", 0) + accessor.get("byteOffset", 0)
        rows = [struct.unpack_from("<4f", data, at + 16 * k) for k in range(accessor["count"])]
        sign = math.copysign(1, sum(p * q for p, q in zip(rows[1], rows[-2])))
        self.assertEqual(rows[0], tuple(sign * c for c in rows[-3]))
        self.assertEqual(rows[-1], tuple(sign * c for c in rows[2]))

    def test_the_distance_of_the_shell_is_that_of_its_farthest_point(self):
        document = gltf_document()
        other = math.radians(2)
        document["animations"] = []
        self.write("still.gltf", json.dumps(document))
        document["nodes"][0]["rotation"] = [0, 0, math.sin(other / 2), math.cos(other / 2)]
        self.write("turned.gltf", json.dumps(document))
        # Without a clip in both there is nothing to compare; with one key each they are compared at its time.
        for name in ("still", "turned"):
            self.assert_fails(f"difference {name}.gltf {name}.gltf", BAD_DATA,
                              f"{name}.gltf: found no clip of the same name, wanted one at least")
        self.write("a.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,0,0\n2,1,0,0,0\n")
        w, z = math.cos(other / 2), math.sin(other / 2)
        self.write("b.csv", f"t,qw,qx,qy,qz\n0,1,0,0,0\n1,{w!r},0,0,{z!r}\n2,1,0,0,0\n")
        for name in "ab":
            self.output_of(f"convert {name}.csv -o {name}.glb")
        report = self.json_of("difference a.glb b.glb --shell 10cm --rate 1")
        self.assertAlmostEqual(report["angle_max_deg"], 2, delta=1e-5)
        self.assertAlmostEqual(report["shell_distance_max"], 2 * 0.1 * math.sin(other / 2), delta=1e-8)
        self.assertEqual(report["clips"][0]["joints"][0]["shell_distance"]["time_s"], 1)

    def test_clips_are_chosen_by_name_and_repeatedly(self):
        document = gltf_document()
        swing = document["animations"][0]
        document["animations"] += [swing | {"name": "again"}, swing | {"name": "third"}]
        self.write("three.gltf", json.dumps(document))
        report = self.json_of("inspect three.gltf --clip third --clip swing")
        self.assertCountEqual([clip["name"] for clip in report["clips"]], ["swing", "third"])
        self.output_of("convert three.gltf --clip again -o one.glb")
        self.assertEqual([clip["name"] for clip in self.json_of("inspect one.glb")["clips"]], ["again"])
        clips = "wanted one of 'swing', 'again', 'third'"
        for command, cure in (("sample three.gltf --rate 5", "; --output-folder FOLDER takes all of them"),
                              ("plot three.gltf -o x.svg", ""),
                              ("convert three.gltf -o x.csv", "; an output such as all.glb takes all of them")):
            self.assert_fails(command, BAD_DATA, f"three.gltf: found 3 clips, {clips}{cure} (--clip NAME chooses one)")
        for command in ("inspect three.gltf", "reduce three.gltf --tolerance 1deg -o x.glb", "difference three.gltf swing.gltf"):
            self.assert_fails(f"{command} --clip fourth", BAD_DATA, f"three.gltf: found no clip 'fourth', {clips}")


class OneJoint(SceneTest):
    def test_a_spline_is_sampled_by_the_formula_of_the_specification(self):
        rows = rows_of(self.output_of("sample swing.gltf --rate 24 --include-end"))
        self.assertEqual(len(rows), 49)
        for row in rows:
            wanted = spline_at(SPLINE_TIMES, SPLINE, row[0])
            for found, component in zip(row[1:5], wanted):
                self.assertAlmostEqual(found, component, delta=1e-7)

    def test_a_joint_in_the_world_is_that_of_the_chain_above_it(self):
        self.output_of("convert arm.bvh --joint Elbow --space world -o elbow.csv")
        rows = rows_of(self.read("elbow.csv"))
        self.assertEqual(len(rows), FRAMES)
        for frame, row in enumerate(rows):
            shoulder = shoulder_turn(frame)
            self.assertLess(angle_between(row[1:5], product(shoulder, turn_about(2, elbow_angle(frame)))), 1e-9)
            place = [a + b for a, b in zip((1, 2.5, 3), turned(shoulder, (0.3, 0, 0)))]
            for found, wanted in zip(row[5:8], place):
                self.assertAlmostEqual(found, wanted, delta=1e-12)

    def test_the_only_joint_that_turns_needs_no_name(self):
        self.assertEqual(self.output_of("sample swing.gltf --rate 10"), self.output_of("sample swing.gltf --joint base --rate 10"))

    def test_stored_motion_has_the_rates_of_the_file(self):
        rows = rows_of(self.output_of("sample arm.bvh --joint Elbow --rate 50 --derivatives 1"))
        for row in rows[:-1]:
            self.assertAlmostEqual(row[10], math.radians(0.5) / 0.0083333, delta=1e-6)

    def test_commands_of_one_track_take_a_joint(self):
        report = self.json_of("inspect arm.bvh --joint Elbow --method auto,slerp")
        self.assertEqual([method["method"] for method in report["methods"]], ["auto", "slerp"])
        self.assertEqual(report["keys"], FRAMES)
        self.assertEqual(len(self.json_of("compare arm.bvh --joint Shoulder --keep-every 8 --methods auto,slerp")), 2)
        self.output_of("plot arm.bvh --joint Elbow --space world --method auto -o arm.svg")
        self.assertIn("<svg", self.read("arm.svg"))
        self.output_of("retime arm.bvh --joint Elbow --max-rate 30deg/s -o slow.csv")
        self.assertGreater(rows_of(self.read("slow.csv"))[-1][0], 1.9)
        self.output_of("tune arm.bvh --joint Shoulder --method timed-c2 -o tuned.csv")
        self.assertIn("method=timed-c2", self.read("tuned.csv"))
        self.output_of("reduce arm.bvh --joint Shoulder --tolerance 0.5deg -o keys.csv")
        self.assertLess(len(rows_of(self.read("keys.csv"))), FRAMES / 2)

    def test_keys_of_a_joint_come_back_as_they_were(self):
        self.output_of("convert swing.gltf -o swing.csv")
        rows = rows_of(self.read("swing.csv"))
        self.assertEqual([row[0] for row in rows], SPLINE_TIMES)
        for row, (x, y, z, w) in zip(rows, SPLINE[1::3]):
            for found, wanted in zip(row[1:5], (w, x, y, z)):
                self.assertAlmostEqual(found, wanted, delta=1e-7)

    def test_positions_are_kept_though_they_rest(self):
        for command in ("convert swing.gltf --joint base", "sample swing.gltf --joint base --method auto --rate 2"):
            self.output_of(f"{command} -o out.csv")
            self.assertEqual(self.read("out.csv").split("qz", 1)[1].split("\n")[0].partition("px")[1], "", command)
        for options in ("", "--method auto"):
            rows = rows_of(self.output_of(f"sample arm.bvh --joint Elbow {options} --rate 4 --derivatives 0"))
            self.assertEqual({tuple(round(p, 12) for p in row[5:8]) for row in rows}, {(0.3, 0, 0)}, options)
        self.output_of("sample arm.bvh --joint Elbow --method auto -o elbow.glb")
        rows = rows_of(self.output_of("sample elbow.glb --rate 4 --derivatives 0"))
        self.assertEqual({tuple(round(p, 6) for p in row[5:8]) for row in rows}, {(0.3, 0, 0)})
        self.output_of("convert arm.bvh --joint Shoulder -o shoulder.csv")  # which has a channel that rests
        self.assertEqual({tuple(row[5:8]) for row in rows_of(self.read("shoulder.csv"))}, {(1, 2.5, 3)})

    def test_images_that_stay_behind_are_told(self):
        document = gltf_document()
        document["images"] = [{"uri": "skin.png"}, {"uri": "data:image/png;base64,AAAA"}]
        self.write("skin.gltf", json.dumps(document))
        (self.folder / "other").mkdir()
        self.assertEqual(self.run_command("convert skin.gltf -o same.glb").stderr.count("warning"), 0)
        told = self.run_command("convert skin.gltf -o other/skin.glb").stderr
        self.assertIn("found 1 image in files beside the input, which the output looks for in its own folder; copy them there", told)

    def test_any_curve_becomes_cubics_with_the_error_that_is_stated(self):
        shutil.copy(ROOT / "examples/data/flight_keys.csv", self.folder / "flight.csv")
        report = self.json_of("sample flight.csv --tolerance 0.03deg -o flight.glb")
        self.assertLessEqual(report["keys_written"], 61)
        self.assertLessEqual(report["error_max_deg"], 0.03)
        self.assertRegex(self.run_command("sample flight.csv --tolerance 0.03deg -o flight.glb").stderr,
                         r"at most 0\.0296° from the curve \(tolerance 0\.03°\)")
        true, found = (rows_of(self.output_of(f"sample {name} --rate 50 --derivatives 0")) for name in ("flight.csv", "flight.glb"))
        worst = max(angle_between(p[1:5], q[1:5]) for p, q in zip(true, found))
        self.assertLessEqual(worst, 0.03)
        self.assertGreater(worst, 0.02)
        self.output_of("sample flight.csv --rate 20 -o linear.glb")
        document, _ = parts_of_glb(self.folder / "linear.glb")
        self.assertEqual({s.get("interpolation", "LINEAR") for s in samplers_of(document, "rotation").values()}, {"LINEAR"})
        self.assertEqual(self.json_of("inspect linear.glb")["rotation_keys"], 961)


if __name__ == "__main__":
    main()
