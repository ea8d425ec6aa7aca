#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts the output of the papers' experiments into docs/papers.md, and their pictures into docs/papers.

  papers/make_page.py COMMAND    COMMAND is the built orispline
"""

import re
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parents[1] / "docs"
BLOCK = re.compile(r"```text\n\$ orispline reproduce (\S+)\n.*?```", re.S)


def block(experiment, output):
    """What the page shows of the output: without its head and the names of files."""
    tables = output.split("\n\npicture: ")[0].split("\n", 2)[2].rstrip()
    return f"```text\n$ orispline reproduce {experiment}\n{tables}\n```"


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    command = str(Path(sys.argv[1]).resolve())

    def new_block(match):
        arguments = [command, "reproduce", match[1], "--pictures", str(DOCS / "papers")]
        return block(match[1], subprocess.run(arguments, check=True, capture_output=True, encoding="utf-8").stdout)

    page = DOCS / "papers.md"
    page.write_text(BLOCK.sub(new_block, page.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main()
