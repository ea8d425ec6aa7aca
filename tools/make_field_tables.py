#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The tables of options and results in docs/, from the fields that the library states.

make_field_tables.py COMMAND rewrites them, COMMAND being the built orispline. A table stands between the lines
`<!-- fields: smooth options -->` and `<!-- end of fields -->`.
"""
import json
import pathlib
import re
import subprocess
import sys

DOCS = pathlib.Path(__file__).resolve().parents[1] / "docs"
BLOCK = re.compile(r"(<!-- fields: (\w+) (options_of_skeletons|options|results_of_gyros|results) -->\n).*?(<!-- end of fields -->)", re.S)


def tasks_of(command):
    listed = subprocess.run([command, "tasks", "--json"], check=True, capture_output=True).stdout
    return {task["task"]: task for task in json.loads(listed)}


def sentence(field):
    words = ", ".join(f"`{word['word']}` ({word['sentence']})" for word in field.get("words", ()))
    return field["sentence"] + (f": {words}" if words else "")


def standing(field):
    """What holds where nothing is stated."""
    if field["required"]:
        return "required"
    if field["absent"]:
        return field["absent"]
    default = field["default"]
    if default in (None, False, []) or field["type"] == "symmetric_matrix":
        return ""
    return "`true`" if default is True else f"`{default}`"


def table(task, part):
    head = {"options": ("option", "what", "unit", "range", "default"), "results": ("result", "what", "unit", "absent")}[part.partition("_")[0]]
    rows = [head]
    for field in task[part]:
        cells = [f"`{field['name']}`", sentence(field), field["unit"] or ""]
        cells += [field["range"], standing(field)] if part.startswith("options") else [field["absent"] or ""]
        rows.append([cell.replace("|", "\\|") for cell in cells])
    lines = ["".join(f"| {cell} " if cell else "| " for cell in row) + "|\n" for row in rows]
    return "".join([lines[0], "|---" * len(head) + "|\n", *lines[1:]])


def with_tables(text, tasks):
    return BLOCK.sub(lambda found: found[1] + table(tasks[found[2]], found[3]) + found[4], text)


def main(command):
    tasks = tasks_of(command)
    for page in DOCS.glob("*.md"):
        text = page.read_text("utf-8")
        if (new := with_tables(text, tasks)) != text:
            page.write_text(new, "utf-8")
            print(page.name)


if __name__ == "__main__":
    main(sys.argv[1])
