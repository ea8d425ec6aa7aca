#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `orispline convert` carries over, and what it says about the rest."""
import json
import shutil

from command import BAD_ACCESS, BAD_DATA, EXPECTED, CommandTest, main, rows_of

EUROC = "#timestamp [ns],p_RS_R_x [m],p_RS_R_y [m],p_RS_R_z [m],q_RS_w [],q_RS_x [],q_RS_y [],q_RS_z []\n"
DATASET = ("#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z [], "
           "v_RS_R_x [m s^-1], v_RS_R_y [m s^-1], v_RS_R_z [m s^-1]\n")


class Formats(CommandTest):
    """The same two keys in every format; numbers that would show the loss of one digit."""

    def setUp(self):
        super().setUp()
        self.texts = {
            "keys.csv": "t,qw,qx,qy,qz,px,py,pz\n"
                        "1403636580.838555648,0.5,-0.5,0.5,-0.5,4.688319,-1.786938,0.1234567890123457\n"
                        "1403636580.843555329,-0.5,0.5,-0.5,0.5,1e-20,2,3\n",
            "keys.tum": "1403636580.838555648 4.688319 -1.786938 0.1234567890123457 -0.5 0.5 -0.5 0.5\n"
                        "1403636580.843555329 1e-20 2 3 0.5 -0.5 0.5 -0.5\n",
            "keys_euroc.csv": EUROC + "1403636580838555648,4.688319,-1.786938,0.1234567890123457,0.5,-0.5,0.5,-0.5\n"
                                      "1403636580843555329,1e-20,2,3,-0.5,0.5,-0.5,0.5\n"}
        for name, text in self.texts.items():
            self.write(name, text)

    def test_every_format_becomes_every_other_digit_by_digit(self):
        for source in self.texts:
            for target, text in self.texts.items():
                with self.subTest(source, target=target):
                    option = "--output-format euroc" if "euroc" in target else ""
                    out = "out.tum" if target.endswith("tum") else "out.csv"
                    self.assertEqual(self.output_of(f"convert {source} -o {out} {option}"), "")
                    self.assertEqual(self.read(out), text)

    def test_standard_input_and_output(self):
        self.assertEqual(self.output_of("convert -", input=self.texts["keys_euroc.csv"]), self.texts["keys.csv"])
        self.assertEqual(self.output_of("convert keys.csv --output-format tum"), self.texts["keys.tum"])

    def test_the_file_of_the_dataset_with_more_columns(self):
        self.write("data.csv", DATASET + "1403636580838555648,1,2,3,0.5,-0.5,0.5,-0.5,7,8,9\n")
        done = self.run_command("convert data.csv -o out.tum")
        self.assertEqual(self.read("out.tum"), "1403636580.838555648 1 2 3 -0.5 0.5 -0.5 0.5\n")
        self.assertEqual(done.stderr, "1 key from data.csv (EuRoC) written to out.tum (TUM)\n"
                                      "left out, having no place in the output: columns 9 to 11\n")

    def test_the_stored_samples_are_the_same_in_every_format(self):
        shutil.copy(EXPECTED / "slerp_euroc.csv", self.folder)
        text = self.output_of("convert slerp_euroc.csv --output-format tum")
        self.assert_same_table(text, (EXPECTED / "slerp.tum").read_text("utf-8"), separator=" ")


class Content(CommandTest):
    def test_times_that_no_double_holds_are_exact(self):
        self.write("keys.csv", "t_ns,qw,qx,qy,qz\n1,1,0,0,0\n98765432109876543211,1,0,0,0\n")
        self.assertEqual(self.output_of("convert keys.csv"),
                         "t,qw,qx,qy,qz\n0.000000001,1,0,0,0\n98765432109.876543211,1,0,0,0\n")

    def test_only_norms_that_are_off_are_made_1(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,0.9999999,0,0,0\n1,0,0.9995,0,0\n")
        done = self.run_command("convert keys.csv")
        self.assertEqual(done.stdout.splitlines()[1], "0,0.9999999,0,0,0")
        self.assertAlmostEqual(rows_of(done.stdout)[1][2], 1, delta=1e-15)
        self.assertIn("; 1 normalised\n", done.stderr)

    def test_norms_that_are_farther_off_want_an_option(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,0.7,0.7,0,0\n1,0,0.99,0,0\n")
        done = self.run_command("convert keys.csv")
        self.assertIn("\nmade 2 quaternions unit: norms up to 0.0101 off\n", done.stderr)
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,0.7,0.7,0,0.3\n1,0,2,0,0\n")
        self.assert_fails("convert keys.csv", BAD_DATA, "keys.csv:2: key 0: the quaternion has norm 1.03441, wanted 1 "
                                                        "within 0.02 (--normalise takes any norm but 0)")
        report = json.loads(self.output_of("convert keys.csv --normalise -o out.csv --json"))
        self.assertEqual(report["normalised"], 2)
        self.assertEqual(rows_of(self.read("out.csv"))[1], [1, 0, 1, 0, 0])

    def test_signs_are_kept_unless_asked_otherwise(self):
        text = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,-0.6,0,0,0.8\n"
        self.write("keys.csv", text)
        self.assertEqual(self.output_of("convert keys.csv"), text)
        self.assertEqual(self.output_of("convert keys.csv --signs shortest"), text.replace("-0.6,0,0,0.8", "0.6,-0,-0,-0.8"))

    def test_angular_velocities_are_kept_in_csv(self):
        text = "t,qw,qx,qy,qz,wx,wy,wz\n0,1,0,0,0,0.1,0.2,0.3\n"
        self.write("keys.csv", text)
        self.assertEqual(self.output_of("convert keys.csv"), text)
        done = self.run_command("convert keys.csv -o out.tum")
        self.assertEqual(done.stderr, "1 key from keys.csv (CSV) written to out.tum (TUM)\n"
                                      "left out, having no place in the output: angular velocities\nzeros are written "
                                      "as positions, for the input has none\n")

    def test_other_columns_are_named_and_left_out(self):
        self.write("keys.csv", "t,qw,qx,qy,qz,tension,mode\n0,1,0,0,0,0.5,auto\n")
        done = self.run_command("convert keys.csv")
        self.assertEqual(done.stdout, "t,qw,qx,qy,qz\n0,1,0,0,0\n")
        self.assertIn("left out, having no place in the output: tension, mode\n", done.stderr)
        self.assertEqual(self.run_command("convert keys.csv --quiet").stderr, "")

    def test_repairs_are_those_of_sample(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n2,1,0,0,0\n1,1,0,0,0\n1,0,1,0,0\n3,nan,0,0,0\n")
        self.assert_fails("convert keys.csv", BAD_DATA,
                          "keys.csv:3: key 1: time 1 comes after 2, wanted increasing times (--sort orders the rows)")
        done = self.run_command("convert keys.csv --sort --drop-duplicates --drop-invalid")
        self.assertEqual(done.stdout, "t,qw,qx,qy,qz\n1,1,0,0,0\n2,1,0,0,0\n")
        self.assertIn("dropped 1 row of duplicate time; dropped 1 row without valid numbers; sorted 2 rows\n",
                      done.stderr)

    def test_world_to_body_is_turned_round(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,0.5,-0.5,0.5,-0.5\n")
        self.assertEqual(self.output_of("convert keys.csv --conjugate"), "t,qw,qx,qy,qz\n0,0.5,0.5,-0.5,0.5\n")

    def test_times_nearer_than_a_nanosecond_do_not_go_into_euroc(self):
        self.write("keys.csv", "t,qw,qx,qy,qz\n0,1,0,0,0\n1.0000000001,1,0,0,0\n1.0000000002,1,0,0,0\n")
        self.write("out.csv", "precious")
        self.assert_fails("convert keys.csv -o out.csv --output-format euroc", BAD_DATA,
                          "keys.csv:4: key 2: two samples fall on the nanosecond 1000000000, wanted times that differ "
                          "in EuRoC")
        self.assertEqual(self.read("out.csv"), "precious")

    def test_a_target_that_cannot_be_written_is_named(self):
        self.assert_fails("convert keys.csv -o none/out.tum", BAD_ACCESS,
                          "none/out.tum: cannot write: No such file or directory")

    def test_json_is_one_document_with_the_summary(self):
        self.write("keys.csv", "t,qw,qx,qy,qz,mode\n0,1,0,0,0,a\n1.5,-1,0,0,0,b\n")
        self.assertEqual(json.loads(self.output_of("convert keys.csv -o out.tum --json")),
                         {"input": "keys.csv", "input_format": "csv", "output": "out.tum", "output_format": "tum",
                          "keys": 2, "start_s": "0", "end_s": "1.5", "sign_flips": 1, "non_unit_keys": 0,
                          "duplicates_dropped": 0, "invalid_dropped": 0, "rows_moved": 0, "normalised": 0, "rates_left_free": 0, "rows_between": 0,
                          "largest_matrix_distance": 0, "largest_duplicate_deg": 0, "largest_duplicate_m": 0, "dropped_columns": ["mode"], "warnings": []})


if __name__ == "__main__":
    main()
