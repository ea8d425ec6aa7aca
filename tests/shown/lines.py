# SPDX-License-Identifier: Apache-2.0
"""The lines of shell that a page shows, and what they print when they run one after the other."""
import os
import re
import shlex
import subprocess
from typing import NamedTuple

from pages import PROMPT, blocks

MARK = "\x1e"  # separates what one line prints from what the next does


class Line(NamedTuple):
    place: str
    text: str
    shown: str = ""  # what a session says it prints

    @property
    def fails(self):
        return self.shown.startswith("orispline: ")


def is_whole(text):
    """Whether a line of shell does not go on in the next: by a backslash, within quotes, or as a here-document."""
    here = re.search(r"<<'?(\w+)", text)
    if here:
        return text.endswith(f"\n{here[1]}")
    try:
        shlex.split(text, comments=True)
    except ValueError:
        return False
    return True


def lines_of(script):
    """Number and text of each line of shell, without those that are empty or a comment."""
    held, first = "", 0
    for number, line in enumerate(script.splitlines()):
        held, first = (f"{held}\n{line}", first) if held else (line, number)
        if is_whole(held):
            if held.strip() and not held.startswith("#"):
                yield first, held
            held = ""
    if held:
        raise ValueError(f"found a line of shell that does not end: {held}")


def session(block):
    """The lines behind prompts, each with what stands below it."""
    for part in re.split(rf"^{re.escape(PROMPT)}", block.text, flags=re.M)[1:]:
        text, _, shown = part.partition("\n")
        yield Line(block.place, text, shown)


def shell_of(page):
    """All lines of shell of a page, in order."""
    found = []
    for block in blocks(page):
        if block.use == "sh":
            found += [Line(f"{page}:{block.line + number}", text) for number, text in lines_of(block.text)]
        elif block.use == "session":
            found += session(block)
    return found


def run(lines, folder, path):
    """Runs lines in one shell in a folder, with the programs of `path` first: what each prints, up to the first that fails."""
    script = "".join(f"printf '{MARK}'\n{line.text}{' || [ $? = 1 ]' if line.fails else ''}\n" for line in lines)
    done = subprocess.run(["bash", "-e", "-c", f"{script}\nprintf '{MARK}'"], cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, env=os.environ | {"PATH": f"{path}:{os.environ['PATH']}", "TMPDIR": str(folder)}, check=False)
    return done.stdout.decode("utf-8").split(MARK)[1:]
