#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What commands say of files of skeletons: the option that was typed, what was found, and the cure."""
import base64
import json

from command import BAD_DATA, BAD_USAGE, SUCCESS, main, rows_of
from small_scenes import SceneTest, gltf_document, parts_of_glb


class Formats(SceneTest):
    def test_a_format_of_skeletons_is_asked_for_by_the_name(self):
        rows = "wanted csv|tum|euroc|npy"
        for command, endings in (("convert arm.bvh", ".bvh, .glb, .gltf, .vrm or .vrma"), ("smooth arm.bvh", ".bvh, .glb, .gltf, .vrm or .vrma"),
                                 ("reduce arm.bvh --tolerance 1deg", ".glb, .gltf, .vrm or .vrma"),
                                 ("sample keys.csv --tolerance 1deg", ".glb, .gltf, .vrm or .vrma"), ("sample arm.bvh --rate 5", ".glb, .gltf, .vrm or .vrma")):
            for word in ("glb", "gltf", "bvh"):
                for output in ("", "-o -", "-o out", "-o out.csv"):
                    self.assert_fails(f"{command} --output-format {word} {output}", BAD_USAGE,
                                      f"--output-format: found '{word}', {rows}; a file of skeletons goes by its name, which ends "
                                      f"in {endings}")
        self.assert_fails("reduce arm.bvh swing.gltf --tolerance 1deg --output-folder out --output-format glb", BAD_USAGE,
                          f"--output-format: found 'glb', {rows}; a file of skeletons goes by its name, which ends in .glb, .gltf, .vrm or .vrma")
        self.assert_fails("retime keys.csv --max-rate 1deg/s --output-format glb -o out", BAD_USAGE,
                          f"--output-format: found 'glb', {rows}; a file of skeletons goes by its name, which ends in .bvh, .glb, .gltf, .vrm or .vrma")

    def test_a_format_that_the_name_says_too_is_welcome_and_another_one_is_not(self):
        for word in ("gltf", "glb"):
            self.output_of(f"convert arm.bvh --output-format {word} -o arm.glb")
        for word in ("csv", "bvh"):
            self.assert_fails(f"convert arm.bvh --output-format {word} -o other.glb", BAD_USAGE,
                              f"--output-format: found '{word}', wanted another name than 'other.glb', which is that of a glTF file")

    def test_a_skeleton_in_the_place_of_rows_is_told_how_to_go_on(self):
        joints = "arm.bvh: clip 'arm': found 2 joints, wanted one of 'Shoulder', 'Elbow'"
        for command in ("convert arm.bvh", "reduce arm.bvh --tolerance 1deg -o -", "smooth arm.bvh -o x.csv"):
            self.assert_fails(command, BAD_DATA, f"{joints}; an output such as all.glb takes all of them (--joint NAME chooses one)")
        self.assert_fails("sample arm.bvh --method auto --rate 5", BAD_DATA,
                          f"{joints}; --output-folder without --method takes all of them (--joint NAME chooses one)")
        self.assert_fails("sample arm.bvh --rate 5", BAD_DATA,
                          f"{joints}; --output-folder FOLDER takes all of them (--joint NAME chooses one)")

    def test_a_file_of_skeletons_is_not_read_as_rows(self):
        self.output_of("convert arm.bvh -o arm.glb")
        for name, kind, cure in (("arm.bvh", "BVH", "bvh"), ("arm.glb", "glTF", "glb")):
            word = cure.replace("glb", "gltf")
            for command in (f"convert {name} -o x.csv", f"convert {name} -o x.glb", f"sample {name} --rate 5"):
                self.assert_fails(f"{command} --input-format csv", BAD_DATA,
                                  f"{name}: found a {kind} file, which is not read as rows; it is read with --input-format {word}, "
                                  f"or without that option under a name that ends in .{cure}")
        self.assertIn("glTF is read with --input-format gltf", self.run_command("convert swing.gltf --input-format csv").stderr)


class Parts(SceneTest):
    def test_a_buffer_of_the_input_is_not_replaced(self):
        document = gltf_document()
        data = base64.b64decode(document["buffers"][0]["uri"].partition(",")[2])
        document["buffers"][0]["uri"] = "swing.bin"
        self.write("swing.gltf", json.dumps(document))
        (self.folder / "swing.bin").write_bytes(data)
        for command in ("reduce swing.gltf --tolerance 1deg -o small.glb", "smooth swing.gltf -o clean.glb", "inspect swing.gltf"):
            self.assert_fails(f"{command} --report swing.bin", BAD_USAGE,
                              "--report: found 'swing.bin', wanted another file than a part of INPUT")
        self.assert_fails("convert swing.gltf --joint base --output-format csv -o swing.bin", BAD_USAGE,
                          "-o: found 'swing.bin', wanted another file than a part of INPUT, which would be lost")
        self.assertEqual((self.folder / "swing.bin").read_bytes(), data)
        self.output_of("reduce swing.gltf --tolerance 1deg -o small.glb")

    def test_a_clip_that_is_not_there_is_not_compared(self):
        self.output_of("convert arm.bvh -o other.glb")
        done = self.run_command("difference arm.bvh other.glb --clip walk")
        self.assertEqual((done.returncode, done.stdout), (BAD_DATA, ""))
        self.assertIn("'walk'", done.stderr)


class Options(SceneTest):
    def test_the_option_that_was_typed_is_named(self):
        reduce = "reduce arm.bvh --tolerance 1deg -o x.glb"
        for option in ("--smooth", "--noise 0.2deg", "--cutoff 5", "--smoothing-time 0.1", "--position-noise 1mm"):
            self.assert_fails(f"{reduce} {option}", BAD_USAGE,
                              f"{option.split()[0]}: found a file of skeletons, wanted keys of one track as the output, or "
                              "'orispline smooth' first")
        for option in ("--tension=0.3", "--set hold=1", "--ends rest", "--start-rate=0,0,1"):
            name = option.replace("=", " ").split()[0]
            self.assert_fails(f"{reduce} {option}", BAD_USAGE,
                              f"{name}: found the method cubicspline, which has no such option, wanted another --method")
            self.assert_fails(f"sample arm.bvh --joint Elbow --rate 5 {option}", BAD_USAGE,
                              f"{name}: found the motion that the file says, which has its shape, wanted --method as well")
        for option in ("--rate 5", "--include-end"):
            self.assert_fails(f"smooth arm.bvh {option} -o x.bvh", BAD_USAGE,
                              f"{option.split()[0]}: found a file of skeletons, whose keys are smoothed, wanted samples of one track")

    def test_a_tolerance_is_an_angle_up_to_half_a_turn(self):
        for text in ("0", "0deg", "-1deg", "nan", "inf", "1"):
            for command in ("reduce arm.bvh", "sample keys.csv"):
                self.assert_fails(f"{command} --tolerance={text} -o x.glb", BAD_USAGE,
                                  f"--tolerance: found '{text}', wanted a number greater than 0 with its unit, deg, rad, mrad or arcsec, "
                                  "such as 1deg")
        self.assert_fails("reduce arm.bvh --tolerance 200deg -o x.glb", BAD_USAGE,
                          "--tolerance: found 200°, wanted 180° at most, which is as far as rotations can be apart")
        self.assert_fails("sample keys.csv --tolerance 200deg -o x.glb", BAD_USAGE,
                          "--tolerance: found '200deg', wanted 180deg at most, which is as far as orientations can be apart")
        self.assertFalse((self.folder / "x.glb").exists())
        for command in ("reduce arm.bvh", "sample keys.csv"):
            self.output_of(f"{command} --tolerance 180deg -o x.glb")


class Times(SceneTest):
    def test_a_time_that_cannot_be_a_key_is_named_with_its_line(self):
        self.write("late.csv", "t,qw,qx,qy,qz\n100,1,0,0,0\n101,0.8,0.6,0,0\n102,1,0,0,0\n")
        for times, line, found in (("100\n101\n100.5\n", 3, "100.5 after 101, wanted increasing times"),
                                   ("100\n\n101\n101\n", 4, "101 after 101, wanted increasing times"),
                                   ("t,a\n100,1\n101,1\n100,1\n", 4, "100 after 101, wanted increasing times"),
                                   ("101\n101.00000000001\n", 2,
                                    "101.00000000001 after 101, wanted increasing times that single precision tells apart")):
            self.write("times.csv", times)
            self.assert_fails("sample late.csv --times times.csv -o x.glb", BAD_DATA,
                              f"times.csv:{line}: found time {found}: they are the keys of a file of skeletons")
            if ".0000" not in times:
                self.output_of("sample late.csv --times times.csv -o x.csv")
        self.write("times.csv", "99\n100\n")
        first = "before the first key at 100, where a file of skeletons begins; wanted a time from there on"
        self.assert_fails("sample late.csv --times times.csv -o x.glb", BAD_DATA, f"times.csv:1: found time 99 {first}")
        done = self.run_command("sample late.csv --from 99 --rate 2 -o x.glb")
        self.assertEqual((done.returncode, done.stderr.splitlines()[-1]), (BAD_USAGE, f"orispline: --from: found 99 {first}"))
        self.assertFalse((self.folder / "x.glb").exists())


class Equal(SceneTest):
    def test_two_files_that_are_the_same_have_no_difference(self):
        self.assertEqual(self.output_of("difference arm.bvh arm.bvh"),
                         "arm.bvh and arm.bvh: 1 clip compared\nno difference in 3 joints at 121 times\n")
        self.assertEqual(self.json_of("difference arm.bvh arm.bvh")["angle_max_deg"], 0)
        document = gltf_document()
        document["animations"].append(document["animations"][0] | {"name": "again"})
        self.write("two.gltf", json.dumps(document))
        self.assertEqual(self.output_of("difference two.gltf two.gltf"),
                         "two.gltf and two.gltf: 2 clips compared\nno difference in 2 joints at 8 times\n")
        document["nodes"].append({"name": "more"})
        document["animations"].append(document["animations"][0] | {"name": "third"})
        self.write("more.gltf", json.dumps(document))
        self.assertEqual(self.output_of("difference more.gltf two.gltf"),
                         "more.gltf and two.gltf: 2 clips compared\nonly in more.gltf: 1 clip, such as 'third'\n"
                         "only in more.gltf: 1 joint, such as 'more'\nno difference in 2 joints at 8 times\n")


class SinglePrecision(SceneTest):
    def test_what_is_certified_is_what_the_file_holds(self):
        for options in ("", "--method slerp", "--method auto"):
            for tolerance in (1e-6, 1e-5, 1e-3):
                done = self.run_command(f"reduce arm.bvh --tolerance {tolerance}deg {options} -o small.glb --json")
                self.assertEqual(done.returncode, SUCCESS, done.stderr)
                report = json.loads(done.stdout)
                found = self.json_of("difference arm.bvh small.glb")
                for anywhere, at_frames, rounding in (
                        (report["angle_deg"]["largest"], found["angle_max_deg"], 1e-7),
                        (report["shell_distance_m"]["largest"], found["shell_distance_max"], 2e-9)):
                    self.assertGreaterEqual(anywhere, at_frames - rounding)
                    self.assertLessEqual(anywhere, 1.3 * at_frames + rounding)
                told = done.stderr.splitlines()
                if found["angle_max_deg"] <= tolerance:
                    self.assertEqual(told, [])
                    continue
                self.assertLess(tolerance, 1e-4)
                self.assertEqual(len(told), 1, done.stderr)
                self.assertIn("single precision, and keys that were to be nearer stay as they are", told[0])
                self.assertEqual(report["warnings"][0]["message"], told[0].partition("warning: ")[2])

    def test_keys_of_glTF_stay_bit_for_bit(self):
        report = self.json_of("reduce swing.gltf --tolerance 1e-9deg -o small.gltf")
        self.assertEqual(report["angle_deg"]["largest"], 0)
        warning, = report["warnings"]
        self.assertEqual(warning["code"], "larger_file")
        self.assertIn(" of the input, for what describes nodes and tracks beside the keys takes more room", warning["message"])
        self.assertEqual(self.json_of("difference swing.gltf small.gltf --rate 240")["angle_max_deg"], 0)

    def test_cubics_of_a_curve_are_measured_as_they_are_read_again(self):
        rows = "".join(f"{1000 + k},{q},{90 * k},0,0\n" for k, q in enumerate(("1,0,0,0", "0.8,0.6,0,0", "0.6,0,0.8,0", "1,0,0,0")))
        self.write("far.csv", "t,qw,qx,qy,qz,px,py,pz\n0,1,0,0,0,0,0,0\n" + rows)
        report = self.json_of("sample far.csv --position-tolerance 10mm -o far.glb")
        self.assertLessEqual(report["error_max_deg"], 0.01)
        self.assertLessEqual(report["position_error_max_m"], 0.01)
        _, data = parts_of_glb(self.folder / "far.glb")
        self.assertGreater(len(data), 4 * report["keys_written"])
        wanted, found = (rows_of(self.output_of(f"sample {name} --from 1000 --to 1003 --count 301 --derivatives 0"))
                         for name in ("far.csv", "far.glb"))
        self.assertLessEqual(max(abs(p - q) for a, b in zip(wanted, found) for p, q in zip(a[5:8], b[5:8])), 0.0101)
        done = self.run_command("sample far.csv --tolerance 1e-9deg -o far.glb --quiet")
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        self.assertRegex(done.stderr, r"warning: --tolerance: found \S+° in the file, more than 1e-09°: ")


if __name__ == "__main__":
    main()
