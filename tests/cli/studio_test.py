#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`orispline studio`: what the page has in it, where it goes, who opens it, and what is refused. Without its page the command says so."""
import base64
import contextlib
import json
import os
import pathlib
import re
import stat
import subprocess
import tempfile
import time
import unittest

from command import BAD_ACCESS, BAD_DATA, BAD_USAGE, COMMAND, KEYS, SUCCESS, CommandTest, main
from small_scenes import gltf_document

WITHOUT = "studio: orispline was built without the page of the studio, wanted a build after 'make studio'"
HAS_PAGE = WITHOUT not in subprocess.run([COMMAND, "studio", "-o", "-"], capture_output=True, text=True, check=False).stderr
with_page = unittest.skipUnless(HAS_PAGE, "the command was built without the page of the studio")
DATA = re.compile(r'<script [^>]*id="studio-data">(.*?)</script>', re.S)
MARKER = "__ORISPLINE_STUDIO_DATA__"

SAME = {  # bytes of files that the page gets as they are
    "crlf.csv": KEYS.replace("\n", "\r\n").encode(),
    "bom.csv": b"\xef\xbb\xbf" + KEYS.encode(),
    "noted.csv": b"# </script><script>alert(1)</script> \xe2\x88\x9a\n" + KEYS.encode() + b"\n",
    "semicolons.csv": KEYS.replace(",", ";").encode(),
    "quoted \"and\" 'so'.csv": KEYS.encode().replace(b"t,qw", b'"t","qw"'),
    "plain <script>.csv": KEYS.encode().rstrip(b"\n"),
    "keys.tum": b"# t x y z qx qy qz qw\n0 1 2 3 0 0 0 1\n1.50 1 2 3 0.6 0 0 0.8\n",
    "told by content.txt": KEYS.encode(),
    "euroc.csv": b"#timestamp, p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y [], q_RS_z []\n"
                 b"1403636580838555648,1,2,3,1,0,0,0\n1403636580843555328,1,2,3,0.8,0.6,0,0\n",
    "extra.csv": b"t,qw,qx,qy,qz,note\n0,1.000,0,0,0,</script>\n1,0.8,0.6,0,0,\xff\n"}


class Studio(CommandTest):
    def data_of(self, page):
        """The document in a page; the rest is that of the page with its start screen."""
        start = self.output_of("studio -o -")
        self.assertEqual(DATA.sub("", page), DATA.sub("", start))
        return json.loads(DATA.search(page)[1])

    def page_of(self, words, **options):
        done = self.run_command(["studio", *words, "-o", "-"], **options)
        self.assertEqual((done.returncode, done.stderr), (SUCCESS, ""))
        return self.data_of(done.stdout)

    def content_of(self, data):
        return base64.b64decode(data["content"], validate=True)

    def files(self):
        return sorted(path.name for path in self.folder.iterdir())

    @unittest.skipIf(HAS_PAGE, "the command was built with the page of the studio")
    def test_says_that_it_has_no_page(self):
        self.assert_fails("studio keys.csv --no-open -o out.html", BAD_USAGE, WITHOUT)
        self.assertEqual(self.files(), ["keys.csv"])

    def test_says_what_save_does_and_is_completed(self):
        text = self.output_of("studio --help")
        self.assertIn("cannot write to INPUT", text)
        for option in ("--method", "--beside", "--output", "--no-open", "--columns"):
            self.assertIn(option, text)
        self.assertIn("studio", self.output_of("completion bash"))

    @with_page
    def test_the_page_has_the_bytes_of_the_file(self):
        for name, content in SAME.items():
            with self.subTest(name):
                (self.folder / name).write_bytes(content)
                data = self.page_of([name])
                self.assertEqual(self.content_of(data), content)
                self.assertEqual({**data, "content": ""}, {"studio": 1, "version": self.output_of("--version").split()[1],
                                                           "name": name, "content": "", "method": None, "beside": None})

    @with_page
    def test_begins_without_keys(self):
        self.assertEqual(DATA.search(self.output_of("studio -o -"))[1], MARKER)
        for option in ("--method auto", "--beside auto", "--sort", "--columns t=time"):
            self.assert_fails(f"studio {option} -o out.html", BAD_USAGE,
                              f"{option.split()[0]}: found no INPUT, wanted the file of keys that it is about")

    @with_page
    def test_has_the_methods_that_were_named(self):
        data = self.page_of(["keys.csv", "--method", "timed-c2:tension=0.6", "--beside", "squad"])
        self.assertEqual((data["method"], data["beside"]), ("timed-c2:tension=0.6", "squad"))
        data = self.page_of(["keys.csv", "--beside", "squad"])
        self.assertEqual((data["method"], data["beside"]), (None, "squad"))

    @with_page
    def test_standard_input_is_a_file_too(self):
        for text, name in ((KEYS, "keys.csv"), ("0 1 2 3 0 0 0 1\n1.50 1 2 3 0.6 0 0 0.8\n", "keys.tum")):
            data = self.page_of(["-"], input=text)
            self.assertEqual((data["name"], self.content_of(data).decode()), (name, text))

    @with_page
    def test_options_of_reading_make_a_csv_and_say_so(self):
        self.write("mine.csv", KEYS.replace("t,qw", "clock,qw") + KEYS.splitlines()[-1])
        done = self.run_command("studio mine.csv --columns t=clock --drop-duplicates -o -")
        self.assertEqual((done.returncode, done.stderr), (SUCCESS, "orispline: warning: mine.csv: the page has the keys as a CSV file, "
                                                                   "for --columns changes how they are read\n"))
        data = self.data_of(done.stdout)
        self.write("page.csv", self.content_of(data).decode())
        self.assertEqual(data["name"], "mine.csv")
        self.assertEqual(self.output_of("sample page.csv --count 9 --derivatives 3 --quiet"),
                         self.output_of("sample keys.csv --count 9 --derivatives 3 --quiet"))

    @with_page
    def test_a_joint_of_a_skeleton_becomes_a_csv(self):
        self.write("walk.gltf", json.dumps(gltf_document()))
        name = next(node["name"] for node in gltf_document()["nodes"])
        self.output_of(["convert", "walk.gltf", "--joint", name, "-o", "joint.csv"])
        done = self.run_command(["studio", "walk.gltf", "--joint", name, "-o", "-"])
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        self.assertIn("walk.gltf: the page has the keys as a CSV file, for --joint changes how they are read\n", done.stderr)
        data = self.data_of(done.stdout)
        self.write("page.csv", self.content_of(data).decode())
        self.assertEqual(data["name"], "walk.csv")
        self.assertEqual(self.output_of("sample page.csv --count 9 --quiet"),
                         self.output_of("sample joint.csv --count 9 --quiet"))

    @with_page
    def test_keeps_what_the_method_takes_in_a_csv_that_it_makes(self):
        self.write("own.csv", "t,qw,qx,qy,qz,tension,wx,wy,wz\n2,1,0,0,0,0.5,0,0,1\n1,0.8,0.6,0,0,0.25,0,0,2\n")
        done = self.run_command("studio own.csv --sort --method timed-c2 --beside hermite-cumulative -o -")
        self.assertEqual(done.returncode, SUCCESS, done.stderr)
        lines = self.content_of(self.data_of(done.stdout)).decode().splitlines()
        self.assertEqual(lines, ["t,qw,qx,qy,qz,wx,wy,wz,tension", "1,0.8,0.6,0,0,0,0,2,0.25", "2,1,0,0,0,0,0,1,0.5"])

    @with_page
    def test_warns_of_more_keys_than_the_page_edits(self):
        for count, warning in ((1000, ""), (1001, "orispline: warning: many.csv: found 1001 keys, wanted 1000 at most to edit: "
                                                  "the page will offer to reduce them\n")):
            self.write("many.csv", "t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,0,{t % 7 / 9e4}\n" for t in range(count)))
            done = self.run_command("studio many.csv -o -")
            self.assertEqual((done.returncode, done.stderr), (SUCCESS, warning))
            self.assertEqual(self.content_of(self.data_of(done.stdout)).decode(), self.read("many.csv"))

    @with_page
    def test_bad_files_leave_the_page_that_is_there(self):
        self.write("old.html", "old")
        for content, code, message in (
                (b"", BAD_DATA, "bad.csv: empty: no keys"),
                (KEYS.encode("utf-16"), BAD_DATA, "bad.csv:1: the file is UTF-16 text, wanted UTF-8"),
                (b"t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,0,0,0\n", BAD_DATA,
                 "bad.csv:3: key 1: the quaternion is zero, wanted a rotation (--drop-invalid drops such rows)"),
                (b"t,qw,qx,qy,qz\n0,1,0,0,0\n1,0,1/0,0,0\n", BAD_DATA, None),
                (b"t,qw,qx,qy,qz\n0,1,0,0,0\n0,1,0,0,0\n", BAD_DATA,
                 "bad.csv:3: key 1: duplicate time 0, as in line 2, wanted increasing times (--drop-duplicates keeps the first)"),
                (b"PK\x03\x04\x00\x00", BAD_DATA, None)):
            with self.subTest(content):
                (self.folder / "bad.csv").write_bytes(content)
                done = self.run_command("studio bad.csv --no-open -o old.html")
                self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (code, "", 1))
                self.assertTrue(done.stderr.startswith("orispline: bad.csv:"), done.stderr)
                if message:
                    self.assertEqual(done.stderr, f"orispline: {message}\n")
                self.assertEqual((self.read("old.html"), self.files()), ("old", ["bad.csv", "keys.csv", "old.html"]))

    @with_page
    def test_refuses_methods_that_do_not_fit(self):
        for options, code, message in (
                ("--method slrp", BAD_USAGE, "unknown method 'slrp'; did you mean 'slerp'?"),
                ("--beside slrp", BAD_USAGE, "unknown method 'slrp'; did you mean 'slerp'?"),
                ("--beside quintic:tension=a", BAD_USAGE, "--beside: found 'a', wanted numbers with commas between them"),
                ("--beside timed-c2:tension=1,2", BAD_USAGE, None)):
            with self.subTest(options):
                done = self.run_command(f"studio keys.csv {options} --no-open -o out.html")
                self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (code, "", 1), done.stderr)
                if message:
                    self.assertEqual(done.stderr, f"orispline: {message}\n")
        self.assertEqual(self.files(), ["keys.csv"])

    @with_page
    def test_refuses_places_where_no_page_can_be(self):
        (self.folder / "there.html").mkdir()
        for path in ("keys.csv", "./keys.csv"):
            self.assert_fails(f"studio keys.csv -o {path}", BAD_USAGE, f"-o: found '{path}', wanted another file than INPUT, which would be lost")
        self.assert_fails("studio keys.csv -o out.csv", BAD_USAGE, "-o: found 'out.csv', wanted a name that ends in .html or .htm")
        self.assert_fails(["studio", "keys.csv", "-o", ""], BAD_USAGE, "-o: found an empty name, wanted FILE or -")
        self.assert_fails("studio keys.csv -o there.html", BAD_ACCESS, "there.html: cannot write: Is a directory")
        self.assert_fails("studio keys.csv -o no/out.html", BAD_ACCESS, "no/out.html: cannot write: No such file or directory")
        self.assert_fails("studio no.csv --no-open", BAD_ACCESS, "no.csv: cannot open: No such file or directory")
        self.assert_fails("studio there.html -o out.html", BAD_ACCESS, "there.html: cannot read: Is a directory")
        done = self.run_command("studio keys.csv", env={**os.environ, "TMPDIR": str(self.folder / "nowhere")})
        self.assertEqual((done.returncode, done.stdout), (BAD_ACCESS, ""))
        self.assertRegex(done.stderr, rf"^orispline: {re.escape(str(self.folder))}/nowhere: cannot write: .* "
                                      r"\(TMPDIR names the folder for temporary files, -o FILE another place\)\n$")
        self.assertEqual((self.read("keys.csv"), self.files()), (KEYS, ["keys.csv", "there.html"]))

    @with_page
    @unittest.skipIf(hasattr(os, "geteuid") and os.geteuid() == 0, "root may write everywhere")
    def test_refuses_a_folder_for_temporary_files_that_is_not_writable(self):
        (self.folder / "closed").mkdir(mode=0o500)
        self.assert_fails("studio keys.csv", BAD_ACCESS, f"{self.folder / 'closed'}: cannot write: Permission denied "
                          "(TMPDIR names the folder for temporary files, -o FILE another place)",
                          env={**os.environ, "TMPDIR": str(self.folder / "closed")})

    @with_page
    def test_a_page_without_a_name_is_new_and_only_its_owner_can_read_it(self):
        (self.folder / "temporary").mkdir()
        environment = {**os.environ, "TMPDIR": str(self.folder / "temporary")}
        paths = [pathlib.Path(self.output_of("studio keys.csv --no-open", env=environment).removesuffix("\n")) for _ in range(3)]
        self.assertEqual(len(set(paths)), 3)
        self.assertEqual(sorted(paths), sorted((self.folder / "temporary").iterdir()))
        for path in paths:
            self.assertRegex(path.name, r"^orispline-studio-\w{6}\.html$")
            self.assertEqual(stat.S_IMODE(path.stat().st_mode), 0o600)
            self.assertEqual(self.content_of(self.data_of(path.read_text("utf-8"))).decode(), KEYS)
        relative = self.output_of("studio keys.csv --no-open", env={**os.environ, "TMPDIR": "temporary"})
        self.assertTrue(pathlib.Path(relative).is_absolute(), relative)

    @with_page
    def test_an_old_page_is_replaced(self):
        self.write("page.html", "old")
        self.assertEqual(self.output_of("studio keys.csv --no-open -o page.html"), "page.html\n")
        self.assertEqual(self.content_of(self.data_of(self.read("page.html"))).decode(), KEYS)
        self.assertEqual(self.files(), ["keys.csv", "page.html"])


class Opener(CommandTest):
    """A program in the place of the desktop's notes what it is asked for, then waits until the test has seen the command end."""

    def setUp(self):
        super().setUp()
        tools = self.enter(tempfile.TemporaryDirectory())
        for name in ("xdg-open", "open"):
            path = pathlib.Path(tools) / name
            path.write_text('#!/bin/sh\nprintf "%s|" "$#" "$1" > "$NOTES.part"\nmv "$NOTES.part" "$NOTES"\necho noise; echo noise >&2\n'
                            'until [ -e "$NOTES.end" ] || [ ! -e "$NOTES" ]; do sleep 0.05; done\n', "utf-8")
            path.chmod(0o755)
        self.notes = self.folder / "notes"
        self.environment = {**{name: value for name, value in os.environ.items() if name not in ("DISPLAY", "WAYLAND_DISPLAY")},
                            "PATH": f"{tools}:{os.environ['PATH']}", "NOTES": str(self.notes), "TMPDIR": str(self.folder)}
        self.addCleanup(lambda: (self.folder / "notes.end").touch() if self.folder.exists() else None)

    def enter(self, context):
        stack = contextlib.ExitStack()
        self.addCleanup(stack.close)
        return stack.enter_context(context)

    def asked(self):
        while not self.notes.exists():
            time.sleep(0.01)
        text = self.notes.read_text("utf-8")
        self.notes.unlink()
        return text

    @with_page
    def test_opens_the_page_and_does_not_wait(self):
        for display in ("DISPLAY", "WAYLAND_DISPLAY"):
            with self.subTest(display):
                done = self.run_command("studio keys.csv", env={**self.environment, display: ":0"})
                self.assertEqual((done.returncode, done.stderr), (SUCCESS, ""))
                self.assertEqual(self.asked(), f"1|{done.stdout.strip()}|")

    @with_page
    def test_no_shell_reads_the_name(self):
        name = "-n $(touch bad) 'b\".html"
        self.output_of(["studio", "keys.csv", f"--output={name}"], env={**self.environment, "DISPLAY": ":0"})
        self.assertEqual(self.asked(), f"1|{self.folder / name}|")
        self.assertFalse((self.folder / "bad").exists())

    @with_page
    def test_only_prints_where_nothing_can_or_shall_be_opened(self):
        shown = {**self.environment, "DISPLAY": ":0"}
        for options, environment in (("--no-open", shown), ("-o out.html --no-open", shown), ("-o -", shown), ("-o /dev/stdout", shown),
                                     ("", {**shown, "PATH": str(self.folder)}), *([("", {**self.environment, "DISPLAY": ""})]
                                                                                 if os.uname().sysname != "Darwin" else [])):
            with self.subTest(options):
                done = self.run_command(f"studio keys.csv {options}", env=environment)
                self.assertEqual((done.returncode, done.stderr), (SUCCESS, ""))
        time.sleep(0.2)  # where something was opened all the same
        self.assertFalse(self.notes.exists())


if __name__ == "__main__":
    main()
