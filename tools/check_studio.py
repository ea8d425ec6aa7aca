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
LAYERS = {  # package -> folder of its src -> what it may import besides itself; a file beside the folders may import all
    "viewer": {
        "data": set(), "look": set(), "motion": {"data"}, "store": {"data", "look", "motion"}, "quantities": GROUND,
        "plots": GROUND | {"quantities"}, "scene": GROUND, "tables": GROUND, "controls": GROUND, "layout": GROUND | VIEWS | {"quantities"}, "style": set()},
    "editor": {
        "document": set(), "engine": {"document"}, "edits": {"document"}, "store": {"document", "engine"}, "file": {"document", "engine"},
        "scene": EDITED, "timeline": EDITED, "panels": EDITED, "frame": EDITED | {"file", "scene", "timeline", "panels"}, "style": set()}}
PACKAGES = {"viewer": set(), "report": {"orispline-viewer", "orispline-widget"}, "widget": {"orispline-viewer"}, "editor": {"orispline-viewer", "orispline"}}  # package of the studio -> those that it may import
THIRD_PARTY = {"three": ("viewer/src/scene/", "editor/src/scene/"), "uplot": ("viewer/src/plots/",)}  # third party -> the only folders that may import it
EXAMPLES = "../examples/data/"  # files that any source may take in as text
FILE_LINES = 600
SOURCES = {".ts", ".css", ".js", ".mjs"}
BUILT = {"node_modules", "dist"}
SPDX = re.compile(r"(// |/\* )SPDX-License-Identifier: Apache-2\.0( \*/)?\n")
IMPORT = re.compile(r"""^import\s+(?:[\w\s{},*]*?\bfrom\s*)?['"]([^'"]+)|^export\s+[\w\s{},*]*?\bfrom\s*['"]([^'"]+)|\bimport\(\s*['"]([^'"]+)""", re.M)


def layer_of(path):
    """The folder of a package's src that a file of it is in, where the package has layers; none beside the folders."""
    folder = re.match(r"([^/]+)/src/([^/]+)/", path)
    return folder and folder[1] in LAYERS and folder[2]


def import_breaches(path, names, targets):
    package, layer = path.partition("/")[0], layer_of(path)
    for name, target in zip(names, targets):
        if target.startswith(EXAMPLES) and target.endswith("?raw"):
            continue
        if target.startswith("../") or target.partition("/")[0] != package:
            yield f"{path}: wanted a package by its name, found {name}"
        elif layer and layer_of(target) != layer and layer_of(target) not in LAYERS[package].get(layer, set()):
            yield f"{path}: layer {layer} must not import {name}"


def third_party_breaches(path, names):
    package = path.partition("/")[0]
    for name in names:
        library = name.partition("/")[0]
        if library in THIRD_PARTY and not path.startswith(THIRD_PARTY[library]):
            yield f"{path}: {library} is for {' and '.join(THIRD_PARTY[library])} only"
        elif library not in THIRD_PARTY and library not in PACKAGES.get(package, set()):
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
        yield from third_party_breaches(path, [name for name in names if not name.startswith(".")])
        graph[path.removesuffix(".ts")] = set(targets)
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as circle:
        yield "import circle: " + " -> ".join(circle.args[1])


root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".") / "studio"
files = [f for f in sorted(root.rglob("*")) if f.suffix in SOURCES and not BUILT & set(f.relative_to(root).parts)]
sys.exit("\n".join(breaches({f.relative_to(root).as_posix(): f.read_text("utf-8") for f in files})) or 0)
