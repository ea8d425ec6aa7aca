# SPDX-License-Identifier: Apache-2.0
"""The modules of the package know each other in one direction, also where a function imports."""
import ast
import graphlib
import pathlib

import orispline as ori

PACKAGE = pathlib.Path(ori.__file__).parent


def name_of(path):
    parts = path.relative_to(PACKAGE).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


MODULES = {name_of(path): path for path in PACKAGE.rglob("*.py")}


def for_readers(node):
    """A block that runs for type checkers only."""
    return isinstance(node, ast.If) and ast.unparse(node.test) == "TYPE_CHECKING"


def imports(node):
    """All of the code, wherever they stand."""
    for child in ast.iter_child_nodes(node):
        if isinstance(child, ast.ImportFrom):
            yield child
        elif not for_readers(child):
            yield from imports(child)


def known(module):
    """What a module imports, as modules of the package; those of others have names that are none."""
    path = MODULES[module]
    package = ["orispline", *path.relative_to(PACKAGE).parent.parts]
    for found in imports(ast.parse(path.read_text("utf-8"))):
        base = [*(package[:len(package) + 1 - found.level] if found.level else []), *(found.module or "").split(".")]
        names = [".".join(filter(None, [*base, alias.name])).removeprefix("orispline.") for alias in found.names]
        yield from (name if name in MODULES else name.rpartition(".")[0] for name in names)


def test_no_module_knows_one_that_knows_it():
    """Modules that import each other are one, or one of them should be told what it needs."""
    graph = {module: {other for other in known(module) if other and other in MODULES} for module in MODULES}
    assert graph["_curve"] >= {"_keys", "_evaluation", "_measures"} and graph["tables._works"] >= {"_keys", "tables._layout"}
    assert "tables._jobs" in graph["tables._files"] and "spark._live" in graph["spark._stream"]
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as circle:
        raise AssertionError("a circle: " + " imports ".join(reversed(circle.args[1]))) from None
