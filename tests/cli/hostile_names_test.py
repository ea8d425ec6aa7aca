#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Names of files and columns that would steer a terminal are shown without their control characters, and as UTF-8."""
import json
import os
import subprocess
import unicodedata

from command import BAD_ACCESS, COMMAND, SUCCESS, CommandTest, main, with_pages
from small_scenes import gltf_document

OUT = "b\x1b[2J\u009b31m.csv"
NAME = "a\x1b[2J\u009b31mb\nc\r.csv"  # clears the terminal, colours it, ends the line
SHOWN = "a?[2J?31mb?c?.csv"
ROWS = "t,qw,qx,qy,qz,\x1b[5m\x07\n" + "".join(f"{t},1,0,0,{t * t / 2000},x\n" for t in range(9))
KEYS = ROWS.replace("\x1b[5m\x07", "note\u009b2J")

COMMANDS = (("sample", "--rate", "2", "-o", OUT), ("convert", "-o", OUT, "--output-format", "tum"),
            ("sample", "--rate", "2", "--truth", NAME, "-o", OUT),
            ("inspect",), ("compare", "--keep-every", "2", "--methods", "auto,slerp"), ("smooth", "-o", OUT),
            ("reduce", "--tolerance", "1deg", "-o", OUT), ("tune", "--method", "timed-c2", "-o", OUT),
            ("retime", "--max-rate", "1deg/s", "-o", OUT), ("plot", "-o", "plot.svg"))


class HostileNames(CommandTest):
    def setUp(self):
        super().setUp()
        (self.folder / NAME).write_text(ROWS, "utf-8", newline="")

    def assert_printable(self, text):
        strange = {character for character in text if unicodedata.category(character) == "Cc"} - {"\n"}
        self.assertEqual(strange, set(), repr(text))

    def test_every_command_shows_them_without_control_characters(self):
        for command, *options in COMMANDS:
            with self.subTest(command=command, options=options):
                done = self.run_command([command, NAME, *options])
                self.assertEqual(done.returncode, SUCCESS, done.stderr)
                self.assert_printable(done.stdout + done.stderr)
                if command != "plot":
                    self.assertIn(SHOWN, done.stdout + done.stderr)

    def test_errors_show_them_so_too(self):
        for command, *options in COMMANDS:
            with self.subTest(command=command):
                done = self.run_command([command, "no\n" + NAME, *options])
                self.assertEqual((done.returncode, done.stdout), (BAD_ACCESS, ""))
                self.assertEqual(done.stderr, f"orispline: no?{SHOWN}: cannot open: No such file or directory\n")

    def test_usage_errors_show_them_so_too(self):
        for arguments in (["sample", NAME, "--rate", NAME], ["sample", NAME, "--" + NAME], [NAME],
                          ["sample", "keys.csv", "--rate", "1", "--method", NAME]):
            with self.subTest(arguments=arguments):
                done = self.run_command(arguments)
                self.assertNotEqual(done.returncode, SUCCESS)
                self.assert_printable(done.stdout + done.stderr)

    def test_bytes_that_are_no_utf8_are_shown_as_question_marks(self):
        folder, name = b"d\xff\x9b2J", b"k\xe9\xc2\x9b\xf4\x90\x80\x80.csv"  # C1 as a byte, Latin-1, C1, behind the last character
        os.mkdir(os.fsencode(self.folder) + b"/" + folder)
        path = folder + b"/" + name
        with open(os.fsencode(self.folder) + b"/" + path, "wb") as file:
            file.write(ROWS.encode().replace(b"\x07", b"\xb0\x9b"))
        runs = [(command, path, *(word.encode() for word in options)) for command, *options in COMMANDS]
        runs += [("sample", folder, b"--rate", b"2", b"--output-folder", folder + b"O"), ("sample", folder, b"--rate", b"2"),
                 ("sample", path, b"--rate", path), ("sample", path, b"--" + folder), ("convert", path, b"-o", folder), (path,)]
        for run in runs:
            with self.subTest(run):
                done = subprocess.run([COMMAND, *run], cwd=self.folder, capture_output=True, check=False)
                said = (done.stdout + done.stderr).decode("utf-8")  # which raises where it is not
                self.assert_printable(said)
                if run[0] != "plot":
                    self.assertRegex(said, r"k\?{6}\.csv|d\?\?2J")

    @with_pages
    def test_pages_have_a_replacement_for_bytes_that_are_no_utf8(self):
        for command, *options in (("inspect", "--report", "page.html"), ("compare", "--keep-every", "2", "--methods", "auto,slerp", "--report", "page.html"),
                                  ("smooth", "-o", "out.csv", "--report", "page.html"), ("studio", "-o", "page.html")):
            name = b"k\xe9\xf4\x90.csv"
            with open(os.fsencode(self.folder) + b"/" + name, "wb") as file:
                file.write(ROWS.encode())
            with self.subTest(command):
                done = subprocess.run([COMMAND, command, name, *options], cwd=self.folder, capture_output=True, check=False)
                if done.returncode != SUCCESS and b"without the page of the studio" in done.stderr:
                    continue
                self.assertEqual(done.returncode, SUCCESS, done.stderr)
                self.assertIn("k\ufffd\ufffd\ufffd.csv", (self.folder / "page.html").read_text("utf-8"))

    def test_joints_become_files_whose_names_are_printable(self):
        scene = gltf_document()
        for node, name in zip(scene["nodes"], ("é\u009b2Jb", "c\x7f/\u0085d")):
            node["name"] = name
        scene["animations"][0]["name"] = "clip\u009b2J"
        self.write("scene.gltf", json.dumps(scene))
        self.output_of("sample scene.gltf --method stored --rate 2 --output-folder out --quiet")
        self.assertEqual(os.listdir(self.folder / "out"), ["clip_2J"])
        self.assertEqual(sorted(os.listdir(self.folder / "out/clip_2J")), ["c___d.csv", "é_2Jb.csv"])

    def test_json_has_them_as_they_are(self):
        text = self.output_of(["sample", NAME, "--rate", "2", "--json", "-o", "out.csv"])
        self.assertEqual(json.loads(text)["input"], NAME)
        self.assert_printable(text)

    def test_columns_that_are_not_carried_over(self):
        self.write("keys.csv", KEYS)
        done = self.run_command("convert keys.csv --output-format tum -o keys.tum")
        self.assertIn("left out, having no place in the output: note?2J\n", done.stderr)
        self.assert_printable(done.stderr)


if __name__ == "__main__":
    main()
