#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The floor law: who may include whom, and how large a room may be. Prints every breach; exits with 1 if there is one."""
import ast
import graphlib
import pathlib
import re
import statistics
import sys

GROUND = {"base", "math", "curve"}
FLOORS = {  # folder of src/orispline -> what it may include besides itself
    "base": set(), "math": {"base"}, "curve": GROUND, "families": GROUND, "io": GROUND, "report": GROUND,
    "batch/kernel": {"base"}, "batch": GROUND | {"families", "batch/kernel"}, "online": GROUND | {"families", "batch"},
    "analysis": GROUND | {"families", "batch"}, "smooth": GROUND | {"families", "analysis"}, "tune": GROUND | {"families", "analysis"},
    "reduce": GROUND | {"families", "batch", "analysis"}, "retime": GROUND | {"families", "batch", "analysis"}}
GUESTS = {"fast_float/": "src/orispline/io/", "CLI/": "cli/", "nlohmann/": "cli/",
          "benchmark/": "benchmarks/", "glm/": "benchmarks/",
          "smooth/so3": "benchmarks/", "smooth/spline/": "benchmarks/", "sophus/": "benchmarks/", "basalt/": "benchmarks/"}  # third party -> its only room
ROOMS = ("src", "cli", "tests", "examples", "tools", "bindings", "benchmarks")
FILE_LINES, FUNCTION_LINES, MEDIAN_LINES = 300, 60, 200
EXCEPTIONS = {}  # path -> the reason why it may be larger
SPDX = re.compile(r"(#!.*\n# |# |// )SPDX-License-Identifier: Apache-2\.0\n")
NO_ROOM = re.compile(r"(.*/)?(utils?|helpers?|common|misc|detail|impl)[/.]")
SILENT = re.compile(r'R"(\w*)\(.*?\)\1"|"(\\.|[^"\\\n])*"|\'(\\.|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/|^#(.*\\\n)*.*', re.M | re.S)


def floor_of(include):
    """The innermost folder that the table names, of a file of the library."""
    folder = re.match(r"(?:orispline/(.*))?", include)[1]
    while folder and folder not in FLOORS:
        folder = folder.rpartition("/")[0]
    return folder or None


def include_breaches(sources):
    graph = {}
    for path, text in sources.items():
        names, floor = re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)', text, re.M), floor_of(path.removeprefix("src/"))
        graph[path] = {f"src/{name}" for name in names if name.startswith("orispline/")}
        if path.startswith("src/") and re.search(r'#\s*include\s*"', text):
            yield f"{path}: wanted #include <orispline/...>, found one with quotes"
        for name in names:
            if floor and name.startswith("orispline/") and floor_of(name) not in FLOORS.get(floor, set()) | {floor}:
                yield f"{path}: floor {floor} must not include {name}"
            yield from (f"{path}: {name} is for {room} only" for guest, room in GUESTS.items()
                        if name.startswith(guest) and not path.startswith(room))
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as circle:
        yield "include circle: " + " -> ".join(circle.args[1])


def functions(path, text):
    """(first line, last line) of every function; in C++ of every block that follows a parameter list or a condition."""
    if path.endswith(".py"):
        return [(f.lineno, f.end_lineno) for f in ast.walk(ast.parse(text)) if isinstance(f, ast.FunctionDef)]
    text = SILENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)
    found, starts, head = [], [], 0
    for mark in re.finditer(r"[{};]", text):
        before, line = text[head : mark.start()].lstrip(), text.count("\n", 0, mark.start()) + 1
        if mark[0] == "{":
            scope = ")" not in before or re.search(r"(^|[>)\]] )(struct|class|union|enum|namespace)\b", before)
            starts.append(None if scope else line - before.count("\n"))
        elif mark[0] == "}" and starts and (start := starts.pop()):
            found.append((start, line))
        head = mark.end()
    return found


def file_breaches(path, text):
    lines, longest = text.count("\n"), max((b - a + 1, a) for a, b in [(1, 1), *functions(path, text)])
    laws = ((path not in EXCEPTIONS and lines > FILE_LINES, f"{lines} lines, at most {FILE_LINES}"),
            (path not in EXCEPTIONS and longest[0] > FUNCTION_LINES, "function of {} lines at line {}".format(*longest)),
            (not SPDX.match(text), "the first line is not the SPDX line"),
            (path.endswith(".hpp") and "#pragma once" not in text, "no #pragma once"),
            (NO_ROOM.match(path), "this name is not a room"))
    return [f"{path}: {breach}" for broken, breach in laws if broken]


root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
files = [f for room in ROOMS for f in sorted((root / room).rglob("*")) if f.suffix in {".hpp", ".cpp", ".py"}]
sources = {f.relative_to(root).as_posix(): f.read_text("utf-8") for f in files}
breaches = [*include_breaches(sources), *(b for path, text in sources.items() for b in file_breaches(path, text))]
if (median := statistics.median(text.count("\n") for text in sources.values())) >= MEDIAN_LINES:
    breaches.append(f"the median file has {median} lines, wanted below {MEDIAN_LINES}")
sys.exit("\n".join(breaches) or 0)
