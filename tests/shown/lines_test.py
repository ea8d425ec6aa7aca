#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The lines of shell in the pages run as they stand, and print what stands below them."""
import pathlib
import re
import sys

from lines import run, shell_of
from pages import FENCE, PAGES, ROOT, blocks, name_of, outputs_of

sys.path.insert(0, str(ROOT / "tests/cli"))
from command import COMMAND, CommandTest, main, with_pages  # noqa: E402
from given import NAMED, RECORDED, give, has_recordings  # noqa: E402

BUILDS = "builds; its target is in the Makefile"
INSTALLS = "installs packages from elsewhere"
TESTS = "is a run of tests itself"
NOT_RUN = {  # how a line begins, and why it is not run here
    r"make ": BUILDS,
    r"((uv )?pip|npm) install |pipx run ": INSTALLS,
    r"spark-submit ": "wants a cluster; tests/python/test_spark.py has one of its own",
    r"orispline-tables ": "is in the Python package; tests/python/test_documents.py runs it",
    r"cmake |export PKG_CONFIG_PATH|cc program\.c ": "builds and installs; tests/package/c_program_test.py builds a program so",
    r"gpg ": "wants the key of who releases",
    r"ctest |RC_PARAMS=\S+.* ctest ": TESTS,
    r"tests/fuzz/run\.py |build/release/tests/fuzz/": TESTS,
    r"tools/mutate\.py": "builds the library with mutants",
    r"ORISPLINE_STUDIO_WASM=|node editor/": "wants the packages of the studio, in its folder; tests/studio builds the page",
    r"orispline sample keys\.csv .*--count 10000000 ": "writes 2 GB",
}
OF_OTHERS = {"--prefix"}  # options of other programs, where no name stands before them
TIME = re.compile(r"time \[m?s\]")


def why_not_run(line, has_studio):
    for start, reason in NOT_RUN.items():
        if re.match(start, line.text):
            return reason
    if line.text.startswith("orispline studio") and not has_studio:
        return "the command was built without the page of the studio"
    if not has_recordings() and any(name in line.text for name in NAMED):
        return "its recording is not beside the project"
    return None


def without_times(text):
    """The lines, in tables without the column of times, which every run has its own of."""
    timed, columns = None, 0
    for line in text.splitlines():
        cells = re.split(r"  +", line.strip())
        found = [index for index, cell in enumerate(cells) if TIME.fullmatch(cell)]
        if found:
            timed, columns = found[0], len(cells)
        if len(cells) != columns:
            timed = None
        yield line if timed is None else [cell for index, cell in enumerate(cells) if index != timed]


def in_order(wanted, lines):
    """Whether all wanted lines are among the others, in their order."""
    rest = iter(lines)
    return all(line in rest for line in wanted)


def options_in(text):
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text))


class Lines(CommandTest):
    def setUp(self):
        super().setUp()
        self.programs = self.folder / "programs"
        self.programs.mkdir()
        (self.programs / "orispline").symlink_to(COMMAND)
        (self.programs / "xdg-open").write_text("#!/bin/sh\n", "utf-8")
        (self.programs / "xdg-open").chmod(0o755)
        self.has_studio = "without the page of the studio" not in self.run_command("studio -o -").stderr

    def printed_by(self, page, lines):
        """What each line prints; all of them run."""
        folder = self.folder / page.replace("/", "_")
        folder.mkdir()
        give(folder, page, {word for line in lines for word in re.findall(r"[\w.-]+", line.text)})
        printed = run(lines, folder, self.programs)
        if len(printed) <= len(lines):
            self.fail(f"{lines[len(printed) - 1].place}: {lines[len(printed) - 1].text}\nprints: {printed[-1]}")
        for line, text in zip(lines, printed):
            if not line.fails:  # the exit code of a pipe is that of its last program
                self.assertNotRegex(text, r"(?m)^orispline: (?!warning: )", f"{line.place}: {line.text}")
        return printed, folder

    def assert_shown(self, page, lines, printed):
        for line, text in zip(lines, printed):
            if line.shown:
                shown, found = list(without_times(line.shown)), list(without_times(text))
                self.assertEqual(found[-len(shown):], shown, f"{line.place}: {line.text}")
        everything = list(without_times("".join(printed)))
        for block in outputs_of(page, "sh"):
            self.assertTrue(in_order(without_times(block.text), everything), f"{block.place}: not what the page's lines print")

    @with_pages
    def test_every_line_runs_and_prints_what_it_says(self):
        count, reasons = 0, {}
        for page in map(name_of, PAGES):
            lines = shell_of(page)
            count += len(lines)
            why = {line: why_not_run(line, self.has_studio) for line in lines}
            lines = [line for line in lines if why[line] is None]
            for reason in filter(None, why.values()):
                reasons[reason] = reasons.get(reason, 0) + 1
            if not lines:
                continue
            with self.subTest(page):
                printed, folder = self.printed_by(page, lines)
                if has_recordings() or page not in RECORDED:
                    self.assert_shown(page, lines, printed)
                self.assert_draws(page, folder)
        print(f"{count} lines, {count - sum(reasons.values())} are run; not run:", *(f"  {n} {reason}" for reason, n in reasons.items()), sep="\n")
        self.assertEqual({*NOT_RUN.values()} - {*reasons}, set(), "wanted no reason for lines that are gone")

    def assert_draws(self, page, folder):
        """The pictures of a tutorial are those that its lines draw."""
        if pathlib.Path(page).parent.name == "tutorials":
            for name in re.findall(r"\]\((\w+\.svg)\)", (ROOT / page).read_text("utf-8")):
                self.assertEqual((ROOT / page).with_name(name).read_text("utf-8"), (folder / name).read_text("utf-8"), f"{name}, wanted: the line of {page} that draws it")

    def test_rows_are_read(self):
        for block in (block for page in PAGES for block in blocks(page) if block.use == "rows"):
            self.write("rows.csv", block.text)
            with self.subTest(block.place):
                self.output_of("inspect rows.csv")

    def test_options_within_sentences_are_there(self):
        commands = re.findall(r"^  ([a-z]+)  ", self.output_of("help"), re.M)
        helps = {command: options_in(self.output_of(f"help {command} --all")) for command in commands} | {"": options_in(self.output_of("help"))}
        anywhere = set().union(*helps.values()) | OF_OTHERS
        for page in (page for page in PAGES if page.name != "CHANGELOG.md"):
            for code in re.findall(r"`([^`]+)`", FENCE.sub("", page.read_text("utf-8"))):
                words = code.split()
                taken = helps.get(words[1] if len(words) > 1 else "", anywhere) if words[:1] == ["orispline"] else anywhere
                if words and (words[0] == "orispline" or words[0].startswith("--")):
                    self.assertEqual(options_in(code) - taken, set(), f"{page.name}: {code}")

    def test_what_is_made_is_a_target_of_the_makefile(self):
        targets = re.search(r"^\.PHONY: (.*)", (ROOT / "Makefile").read_text("utf-8"), re.M)[1].split()
        for path in (path for path in PAGES if path.name != "CHANGELOG.md"):
            text = path.read_text("utf-8")
            said = re.findall(r"`make ([a-z-]+)", text) + re.findall(r"(?:^|&& )make ([a-z-]+)", "\n".join(block.text for block in blocks(path) if block.kind == "sh"), re.M)
            self.assertEqual(set(said) - set(targets), set(), path.name)

    def test_scripts_have_the_options_that_lines_take(self):
        for line in (line for path in PAGES for line in shell_of(name_of(path))):
            script = re.match(r"((?:tools|tests)/\S+\.py) ([^#]*)", line.text)
            for option in re.findall(r"--[a-z-]+", script[2]) if script else []:
                self.assertIn(f'"{option}"', (ROOT / script[1]).read_text("utf-8"), line.place)


if __name__ == "__main__":
    main()
