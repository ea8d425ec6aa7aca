#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What --compress meshopt and --for meshopt promise of clips in glTF: the same motion within the tolerances, and one line where not."""
import json
import unittest

from command import BAD_DATA, BAD_USAGE, SUCCESS, main
from small_scenes import SceneTest, parts_of_glb, samplers_of

EXTENSION = "EXT_meshopt_compression"
WITHIN = "--tolerance 0.1deg --position-tolerance 1mm"


class CompressTest(SceneTest):
    def setUp(self):
        super().setUp()
        self.output_of("convert arm.bvh -o arm.glb")

    def told(self, arguments):
        done = self.run_command(arguments)
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        return done.stderr


class Compressed(CompressTest):
    def setUp(self):
        super().setUp()
        done = self.run_command("convert arm.glb --compress meshopt -o lossless.glb")
        if "without meshoptimizer" in done.stderr:
            self.assertEqual(len(done.stderr.splitlines()), 1)
            self.assertIn("--compress: found meshopt", done.stderr)
            self.assertIn("gltf-transform copy", done.stderr)
            self.assertFalse((self.folder / "lossless.glb").exists())
            raise unittest.SkipTest("this build is without meshoptimizer")

    def test_nothing_is_rounded_without_a_tolerance(self):
        found = self.json_of("difference arm.glb lossless.glb")
        self.assertEqual((found["angle_max_deg"], found["translation_max"]), (0, 0))

    def test_what_reduce_states_is_what_the_file_holds(self):
        report = self.json_of(f"reduce arm.glb {WITHIN} --compress meshopt -o small.glb")
        self.assertEqual((report["method"], report["compress"]), ("smallest", "meshopt"))
        found = self.json_of("difference arm.glb small.glb")
        self.assertGreater(found["angle_max_deg"], 0)
        self.assertLessEqual(found["angle_max_deg"], report["angle_deg"]["largest"] * 1.001)
        self.assertLessEqual(report["angle_deg"]["largest"], 0.1)
        self.assertLessEqual(found["translation_max"], 1e-3)
        document, _ = parts_of_glb(self.folder / "small.glb")
        self.assertEqual(document["extensionsRequired"], [EXTENSION])
        self.output_of("convert small.glb -o decoded.glb")
        document, _ = parts_of_glb(self.folder / "decoded.glb")
        self.assertNotIn("extensionsRequired", document)
        found = self.json_of("difference small.glb decoded.glb")
        self.assertLess(found["angle_max_deg"], 1e-5)

    def test_every_method_may_be_compressed(self):
        for method in ("slerp", "cubicspline", "hermite-c1"):
            report = self.json_of(f"reduce arm.glb {WITHIN} --method {method} --compress meshopt -o small.glb")
            found = self.json_of("difference arm.glb small.glb")
            self.assertLessEqual(found["angle_max_deg"], 0.1, method)
            self.assertEqual(report["method"], method)

    def test_numbers_take_fewer_bytes(self):
        for name, options in (("plain", ""), ("small", "--compress meshopt")):
            self.output_of(f"reduce arm.glb --tolerance 0.02deg --method slerp {options} -o {name}.glb")
        data_of = {name: parts_of_glb(self.folder / f"{name}.glb")[1] for name in ("small", "plain")}
        self.assertLess(len(data_of["small"]), 0.7 * len(data_of["plain"]))

    def test_the_last_line_says_what_the_next_tool_breaks(self):
        line = f"next tool       the input names {EXTENSION}; "
        self.assertIn(line, self.told("reduce lossless.glb --tolerance 0.1deg -o small.glb"))
        self.assertNotIn("next tool", self.told("reduce lossless.glb --tolerance 0.1deg --for meshopt -o small.glb"))
        self.assertNotIn("next tool", self.told("reduce arm.glb --tolerance 0.1deg -o small.glb"))

    def test_files_that_are_cut_off_leave_the_output_alone(self):
        self.write("small.glb", "what was there")
        document, data = parts_of_glb(self.folder / "lossless.glb")
        document["bufferViews"][-1]["extensions"][EXTENSION]["byteLength"] -= 8
        text = json.dumps(document).encode()
        text += b" " * (-len(text) % 4)
        whole = (len(text).to_bytes(4, "little") + b"JSON" + text + len(data).to_bytes(4, "little") + b"BIN\0" + data)
        (self.folder / "cut.glb").write_bytes(b"glTF" + (2).to_bytes(4, "little") + (12 + len(whole)).to_bytes(4, "little") + whole)
        done = self.run_command("reduce cut.glb --tolerance 1deg -o small.glb")
        self.assertEqual(done.returncode, BAD_DATA)
        self.assertRegex(done.stderr, r"cut\.glb: EXT_meshopt_compression of bufferView \d+: found data that are damaged .*gltf-transform copy")
        self.assertEqual(len(done.stderr.splitlines()), 1)
        self.assertEqual((self.folder / "small.glb").read_text(), "what was there")


class Linear(CompressTest):
    def test_rotations_are_linear_for_gltf_transform(self):
        self.output_of("reduce arm.glb --tolerance 0.2deg -o cubic.glb")
        for name in ("arm", "cubic"):
            report = self.json_of(f"reduce {name}.glb --tolerance 0.1deg --for meshopt -o linear.glb")
            self.assertEqual(report["method"], "slerp")
            document, _ = parts_of_glb(self.folder / "linear.glb")
            kinds = {sampler.get("interpolation", "LINEAR") for sampler in samplers_of(document, "rotation").values()}
            self.assertEqual(kinds, {"LINEAR"}, name)
            self.assertLessEqual(self.json_of(f"difference {name}.glb linear.glb")["angle_max_deg"], 0.1)

    def test_splines_for_it_are_refused(self):
        self.assert_fails("reduce arm.glb --tolerance 1deg --method cubicspline --for meshopt -o small.glb", BAD_USAGE,
                          "--for: found the method cubicspline, whose splines of rotations gltf-transform's meshopt breaks, wanted slerp or smallest")


class Refused(CompressTest):
    def test_where_it_has_no_place(self):
        self.assert_fails("convert arm.glb --compress meshopt -o arm2.bvh", BAD_USAGE, "arm.glb: --compress: found an output that is a BVH file, wanted glTF")
        self.assert_fails("convert arm.glb --compress draco -o small.glb", BAD_USAGE, "--compress: found 'draco', wanted none|meshopt")


if __name__ == "__main__":
    main()
