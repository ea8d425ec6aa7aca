#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Puts the output of the papers' experiments into docs/papers.md, and their pictures into docs/papers.

  tools/make_papers.py COMMAND    COMMAND is the built orispline
"""

import re
import subprocess
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent.parent / "docs"
BLOCK = re.compile(r"```text\n\$ orispline reproduce (\S+)\n.*?```", re.S)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    command = str(Path(sys.argv[1]).resolve())

    def output_of(experiment, *options):
        return subprocess.run([command, "reproduce", experiment, *options], check=True, capture_output=True,
                              encoding="utf-8").stdout

    def block(match):
        output = output_of(match[1], "--pictures", str(DOCS / "papers"))
        tables = output.split("\n\npicture: ")[0].split("\n", 2)[2].rstrip()  # without the head and the names of files
        return f"```text\n$ orispline reproduce {match[1]}\n{tables}\n```"

    page = DOCS / "papers.md"
    page.write_text(BLOCK.sub(block, page.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main()
