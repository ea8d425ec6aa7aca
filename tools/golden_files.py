# SPDX-License-Identifier: Apache-2.0
"""Tables of golden values that a program makes: written, or with --check compared with those that are there."""
import pathlib
import sys


def write_or_check(folder, tables):
    """`tables`: the text of each file by its name. Ends the program where one that is there is another."""
    stale = []
    for name, text in tables.items():
        path = folder / name
        if "--check" not in sys.argv:
            path.write_text(text, "utf-8")
        elif not path.exists() or path.read_text("utf-8") != text:
            stale.append(name)
    if stale:
        sys.exit(f"{', '.join(stale)}: not what tools/{pathlib.Path(sys.argv[0]).name} makes; run it")
