# SPDX-License-Identifier: Apache-2.0
"""What the pages of the repository say of their links and pictures, and how a text becomes a part of a page."""
import re

FENCE = re.compile(r"(^```.*?^```[^\n]*$)", re.M | re.S)
TARGET = re.compile(r"(\]\()([^)\s]+)(\))")
ENTRY = re.compile(r"^(?:\| *|\d+\. |- )\[((?:[^\]`]|`[^`]*`)+)\]\(([^)\s]+)\)", re.M)


class Fault(Exception):
    """What keeps the pages from being a site."""


def outside_code(text, change):
    """The text with all that is not in a block of code changed."""
    parts = FENCE.split(text)
    return "".join(part if number % 2 else change(part) for number, part in enumerate(parts))


def with_targets(text, where):
    """The text with each target of a link or a picture as where(target) says."""
    return outside_code(text, lambda part: TARGET.sub(lambda link: link[1] + where(link[2]) + link[3], part))


def entries(text):
    """The links that rows of tables and items of lists begin with: their titles and targets."""
    return [(title.replace("`", ""), target) for title, target in ENTRY.findall(FENCE.sub("", text))]


def sections(text):
    """The headings of the second level, each with what is under it."""
    parts = re.split(r"^## (.*)$", text, flags=re.M)
    return list(zip(parts[1::2], parts[2::2]))


def rows(text):
    """The rows of the tables, as lists of cells; those of their heads too."""
    lines = (line for line in text.splitlines() if line.startswith("|") and set(line) - set("|- "))
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line.strip("|"))] for line in lines]


def escaped(text):
    """A text in which no sign means anything."""
    return re.sub(r"([\\`*_{}\[\]<>#|~$])", r"\\\1", text)


def code(text):
    """A text as code in a line, whatever ticks it has."""
    ticks = "`" * (1 + max((len(run) for run in re.findall("`+", text)), default=0))
    space = " " if text.startswith("`") or text.endswith("`") else ""
    return f"{ticks}{space}{text}{space}{ticks}"


def block(language, text):
    fence = "`" * max(3, 1 + max((len(run) for run in re.findall("`+", text)), default=0))
    return f"{fence}{language}\n{text.rstrip()}\n{fence}"


def container(name, text):
    """A part of a page that the style sheet knows by its name."""
    return f"::::{{container}} {name}\n{text}\n::::"


def tree(entries_of_it, *options):
    """The directive that puts pages into the side bar: (title, page) each."""
    lines = [f"{title} </{page}>" if title else f"/{page}" for title, page in entries_of_it]
    return "\n".join(["```{toctree}", ":hidden:", *options, "", *lines, "```", ""])
