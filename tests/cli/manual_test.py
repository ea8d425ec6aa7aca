#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The manual pages: what the help says is in them, and those who read pages find nothing wrong."""
import re
import shutil
import subprocess

from command import BAD_ACCESS, BAD_USAGE, COMMAND, CommandTest, main

TYPED = {"\\-": "-", "\\(aq": "'", "\\(rs": "\\", "\\(dq": '"', "\\(ga": "`", "\\(ha": "^", "\\(ti": "~", "\\:": ""}
NO_DATE = 'WARNING: missing date, using "": TH'  # pages have none: two builds are alike on any day


def plain(page):
    """The text of a page without what is for man alone."""
    page = re.sub(r"\\f[BIR]", "", page)
    page = re.sub(r"\\\[u([0-9A-F]{4})\]", lambda match: chr(int(match[1], 16)), page)
    return re.sub("|".join(map(re.escape, TYPED)), lambda match: TYPED[match[0]], page)


class Manual(CommandTest):
    def setUp(self):
        super().setUp()
        self.output_of("help --manual-pages man")
        self.pages = {path.name: path.read_text("ascii") for path in (self.folder / "man").iterdir()}
        self.commands = re.findall(r"^  ([a-z]+)  +", self.output_of("help").partition("\nSubcommands:\n")[2], re.M)

    def page(self, command):
        return plain(self.pages[f"orispline-{command}.1"])

    def options_of(self, said):
        """Options of a help with what it says of them: in its column, or below a term that reaches into it."""
        options = re.findall(r"^  (?=-)(?:(.{27}) (\S.*)|(.*)\n {30}(\S.*))$", said, re.M)
        self.assertEqual(len(options), len(re.findall(r"^  -", said, re.M)))
        return [((short or long).strip(), beside or below) for short, beside, long, below in options]

    def test_every_command_has_a_page_that_says_what_it_does(self):
        self.assertEqual(set(self.pages), {"orispline.1"} | {f"orispline-{name}.1" for name in self.commands})
        self.assertIn("reduce", self.commands)
        for command in self.commands:
            said = self.output_of(["help", command]).splitlines()[0]
            self.assertIn(f"\norispline-{command} - {said[0].lower()}{said[1:]}\n", self.page(command))
            self.assertIn(f"orispline-{command}(1)\n{said}\n", plain(self.pages["orispline.1"]))

    def test_every_option_and_argument_of_the_help_is_explained_in_the_same_words(self):
        for command in self.commands:
            said, page = self.output_of(["help", command, "--all"]), self.page(command)
            for term, sentence in self.options_of(said):
                names, _, argument = term.removesuffix(" REQUIRED").partition(" ")
                wanted = " ".join(filter(None, (names.replace(",", ", "), argument)))
                if names != "-h,--help":
                    self.assertRegex(page, rf"\n\.TP\n{re.escape(wanted)}\n{re.escape(sentence)}{re.escape(' (required)') if 'REQUIRED' in term else ''}\n")
            self.assertIn(".TP\n-h, --help\n", page)
            for argument in re.findall(r"^  ([A-Z]+) \S", said.partition("\nOptions:")[0], re.M):
                self.assertRegex(page, rf"\.SH \"ARGUMENTS\"\n(.*\n)*\.TP\n{argument}\b")

    def test_the_help_shows_what_most_people_use_and_how_to_see_the_rest(self):
        for command in self.commands:
            short, whole = (self.output_of(["help", command, *all_]) for all_ in ([], ["--all"]))
            shown, all_ = self.options_of(short), self.options_of(whole)
            self.assertLessEqual(set(shown), set(all_), command)
            self.assertLessEqual(len(shown), 19, command)
            hidden = re.findall(rf"^'orispline help {command} --all' shows (\d+) more options\.$", short, re.M)
            self.assertEqual(hidden, [str(len(all_) - len(shown))] if len(all_) > len(shown) else [], command)
            self.assertNotIn("--all'", whole)
        self.assertEqual(self.output_of("sample -h --all"), self.output_of("help sample --all"))
        self.assert_fails("sample keys.csv --all", BAD_USAGE, "sample: unknown option '--all'; did you mean '--all-or-none'?")

    def test_examples_remarks_and_exit_codes_are_there(self):
        for command in self.commands:
            footer, page = self.output_of(["help", command]).partition("\nExamples:\n")[2], self.page(command)
            for line in filter(None, footer.splitlines()):
                self.assertIn(f"\n{line.strip()}\n", page)
            for code in range(4):
                self.assertRegex(page, rf"\.SH \"EXIT STATUS\"\n(.*\n)*\.TP\n{code}\n\w")
            self.assertRegex(page, r'\.SH "SEE ALSO"\norispline\(1\)')

    def test_the_page_of_the_program_lists_methods_and_formats(self):
        page = plain(self.pages["orispline.1"])
        for word in ("timed-c2", "measured", "csv", "npy", "bvh"):
            self.assertIn(f"\n.TP\n{word}\n", page)
        self.assertIn(f'"{self.output_of("--version").strip()}"', page)

    def test_the_version_is_in_every_foot_and_no_date(self):
        version = self.output_of("--version").strip()
        for name, page in self.pages.items():
            self.assertEqual(plain(page).splitlines()[0], f'.TH {name.removesuffix(".1").upper()} 1 "" "{version}" "User Commands"')

    def test_groff_warns_of_nothing(self):
        if not shutil.which("groff"):
            self.skipTest("no groff here")
        for name, page in self.pages.items():
            done = subprocess.run(["groff", "-man", "-ww", "-z"], input=page, capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""), name)

    def test_mandoc_warns_of_the_missing_date_alone(self):
        if not shutil.which("mandoc"):
            self.skipTest("no mandoc here")
        for name in self.pages:
            done = subprocess.run(["mandoc", "-T", "lint", "-W", "warning", f"man/{name}"], cwd=self.folder, capture_output=True, text=True, check=False)
            self.assertEqual([line for line in done.stdout.splitlines() if NO_DATE not in line], [], name)

    def test_whatis_finds_the_line_of_each(self):
        if not shutil.which("lexgrog"):
            self.skipTest("no lexgrog here")
        done = subprocess.run(["lexgrog", *(f"man/{name}" for name in self.pages)], cwd=self.folder, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout.count(" - ")), (0, len(self.pages)), done.stdout + done.stderr)

    def test_what_lies_beside_the_command_is_what_it_writes_now(self):
        if not (COMMAND.parent / "man").is_dir():
            self.skipTest("a build for another machine writes no pages")
        built = {path.name: path.read_text("ascii") for path in (COMMAND.parent / "man").iterdir()}
        self.assertEqual(built, self.pages)
        for shell, name in (("bash", "orispline"), ("zsh", "_orispline"), ("fish", "orispline.fish")):
            self.assertEqual((COMMAND.parent / "completions" / name).read_text("utf-8"), self.output_of(f"completion {shell}"))


class Refused(CommandTest):
    def test_a_command_beside_the_folder(self):
        self.assert_fails("help --manual-pages man sample", BAD_USAGE,
                          "help: found the command 'sample' and --manual-pages, which writes those of all commands; wanted one of both")
        self.assertFalse((self.folder / "man").exists())

    def test_no_folder_and_no_command(self):
        self.assert_fails("help --", BAD_USAGE, "help: wanted a command, such as 'orispline help sample', or --manual-pages")

    def test_a_file_in_the_place_of_the_folder(self):
        self.assert_fails("help --manual-pages keys.csv", BAD_ACCESS, "keys.csv: cannot make this folder: Not a directory")


if __name__ == "__main__":
    main()
