#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The layers of the studio: which folder may import which, and how large a file may be. Prints every breach; exits with 1 if there is one."""
import graphlib
import pathlib
import posixpath
import re
import sys

GROUND = {"data", "look", "motion", "store"}
VIEWS = {"controls", "plots", "scene", "tables"}
EDITED = {"document", "edits", "store", "engine"}
FLOORS = {  # package -> folder of its src -> what it may import besides itself; a file beside the folders may import all
    "viewer": {
        "data": set(), "look": set(), "motion": {"data"}, "store": {"data", "look", "motion"}, "quantities": GROUND,
        "plots": GROUND | {"quantities"}, "scene": GROUND, "tables": GROUND, "controls": GROUND, "layout": GROUND | VIEWS | {"quantities"}, "style": set()},
    "editor": {
        "document": set(), "engine": {"document"}, "edits": {"document"}, "store": {"document", "engine"}, "file": {"document", "engine"},
        "scene": EDITED, "timeline": EDITED, "panels": EDITED, "frame": EDITED | {"file", "scene", "timeline", "panels"}, "style": set()}}
PACKAGES = {"viewer": set(), "report": {"orispline-viewer", "orispline-widget"}, "widget": {"orispline-viewer"}, "editor": {"orispline-viewer", "orispline"}}  # package of the studio -> those that it may import
GUESTS = {"three": ("viewer/src/scene/", "editor/src/scene/"), "uplot": ("viewer/src/plots/",)}  # third party -> its only rooms
EXAMPLES = "../examples/data/"  # files that any source may take in as text
FILE_LINES = 600
SOURCES = {".ts", ".css", ".js", ".mjs"}
BUILT = {"node_modules", "dist"}
SPDX = re.compile(r"(// |/\* )SPDX-License-Identifier: Apache-2\.0( \*/)?\n")
IMPORT = re.compile(r"""^import\s+(?:[\w\s{},*]*?\bfrom\s*)?['"]([^'"]+)|^export\s+[\w\s{},*]*?\bfrom\s*['"]([^'"]+)|\bimport\(\s*['"]([^'"]+)""", re.M)


def floor_of(path):
    """The folder of a package's src that a file of it is in, where the package has floors; none beside the folders."""
    folder = re.match(r"([^/]+)/src/([^/]+)/", path)
    return folder and folder[1] in FLOORS and folder[2]


def import_breaches(path, names, targets):
    package, floor = path.partition("/")[0], floor_of(path)
    for name, target in zip(names, targets):
        if target.startswith(EXAMPLES) and target.endswith("?raw"):
            continue
        if target.startswith("../") or target.partition("/")[0] != package:
            yield f"{path}: wanted a package by its name, found {name}"
        elif floor and floor_of(target) != floor and floor_of(target) not in FLOORS[package].get(floor, set()):
            yield f"{path}: floor {floor} must not import {name}"


def guest_breaches(path, names):
    package = path.partition("/")[0]
    for name in names:
        guest = name.partition("/")[0]
        if guest in GUESTS and not path.startswith(GUESTS[guest]):
            yield f"{path}: {guest} is for {' and '.join(GUESTS[guest])} only"
        elif guest not in GUESTS and guest not in PACKAGES.get(package, set()):
            yield f"{path}: {package} must not import {name}"


def breaches(sources):
    graph = {}
    for path, text in sources.items():
        if not SPDX.match(text):
            yield f"{path}: the first line is not the SPDX line"
        if (lines := text.count("\n")) > FILE_LINES:
            yield f"{path}: {lines} lines, at most {FILE_LINES}"
        if "/src/" not in path or not path.endswith(".ts"):
            continue
        names = ["".join(found) for found in IMPORT.findall(text)]
        own = [name for name in names if name.startswith(".")]
        targets = [posixpath.normpath(posixpath.join(posixpath.dirname(path), name)) for name in own]
        yield from import_breaches(path, own, targets)
        yield from guest_breaches(path, [name for name in names if not name.startswith(".")])
        graph[path.removesuffix(".ts")] = set(targets)
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as circle:
        yield "import circle: " + " -> ".join(circle.args[1])


root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".") / "studio"
files = [f for f in sorted(root.rglob("*")) if f.suffix in SOURCES and not BUILT & set(f.relative_to(root).parts)]
sys.exit("\n".join(breaches({f.relative_to(root).as_posix(): f.read_text("utf-8") for f in files})) or 0)
