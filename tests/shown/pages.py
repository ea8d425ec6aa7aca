# SPDX-License-Identifier: Apache-2.0
"""The pages for people, and the blocks that they show."""
import pathlib
import re
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGES = [*ROOT.glob("*.md"), *(page for folder in ("bindings", "docs", "studio") for page in sorted((ROOT / folder).rglob("*.md"))
                               if "node_modules" not in page.parts)]
PROMPT = "$ "
MATHEMATICS = re.compile(r"[^\x00-\x7f°±…²]| = |\[,")
FENCE = re.compile(r"^(?P<indent> *)```(?P<kind>[^\n`]*)\n(?P<text>.*?)^(?P=indent)```$", re.M | re.S)


class Block(NamedTuple):
    page: str  # from the root of the repository
    line: int  # of its first line of code, from 1
    kind: str
    text: str
    @property
    def place(self):
        return f"{self.page}:{self.line}"

    @property
    def use(self):
        """Its language; of text, what it is: a session, rows of a file, a formula, or else the output of what stands above it."""
        if self.kind != "text":
            return self.kind
        if self.text.startswith(PROMPT):
            return "session"
        if self.text.startswith(("#", "t,")) and "[," not in self.text:
            return "rows"
        return "formula" if all(MATHEMATICS.search(line) for line in self.text.splitlines() if line) else "output"


def name_of(page):
    return page.relative_to(ROOT).as_posix()


def blocks(page):
    """In order. A page is a path, or its name from the root of the repository."""
    text = (ROOT / page).read_text("utf-8")
    return [Block(name_of(ROOT / page), text.count("\n", 0, fence.start()) + 2, fence["kind"],
                  re.sub(f"^{fence['indent']}", "", fence["text"], flags=re.M)) for fence in FENCE.finditer(text)]


def all_blocks():
    return [block for page in PAGES for block in blocks(page)]


def outputs_of(page, kind):
    """What a page shows as the output of `sh`, of `python` or of an `example` in C++ or C: of what stands nearest above it and could print."""
    above, found = "", []
    for block in blocks(page):
        if block.use in ("sh", "session"):
            above = "sh"
        elif block.use in ("cpp", "c"):
            above = "example"
        elif block.use == "python" and "print(" in block.text:
            above = "python"
        elif block.use == "output" and above == kind:
            found.append(block)
    return found
