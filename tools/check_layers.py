#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The layers: which folder may include which, and how large a file may be. Prints every breach; exits with 1 if there is one."""
import ast
import graphlib
import pathlib
import re
import statistics
import sys

GROUND = {"base", "math", "fields", "curve"}
TASKS = {"smooth", "reduce", "tune", "retime", "mean", "align", "edit"}
LAYERS = {  # folder of src/orispline -> what it may include besides itself
    "base": set(), "math": {"base"}, "fields": {"base", "math"}, "curve": GROUND, "families": GROUND, "io": GROUND, "report": GROUND, "clip": GROUND, "scenes": GROUND | {"clip", "io"},
    "batch/kernel": {"base"}, "batch": GROUND | {"families", "batch/kernel"}, "online": GROUND | {"families", "batch"},
    "analysis": GROUND | {"families", "batch"}, "smooth": GROUND | {"families", "analysis", "clip"}, "tune": GROUND | {"families", "analysis"}, "mean": GROUND,
    "align": GROUND | {"families", "analysis", "smooth", "mean"},
    "reduce": GROUND | {"families", "batch", "analysis", "clip"}, "edit": GROUND | {"families", "clip"}, "retime": GROUND | {"families", "batch", "analysis", "clip"},
    "pages": GROUND | TASKS | {"families", "batch", "analysis", "report", "clip"},
    "jobs": GROUND | TASKS | {"families", "batch", "online", "analysis", "report", "clip", "pages"}}
CLI_LAYERS = {"options": set(), "output": {"options"}, "papers": {"options", "output"},
              "commands": {"options", "output"}}  # folder of cli -> what it may include besides itself; each folder of commands is one for itself
# The command and the bindings, which compose nothing: what they may include besides the public headers and what these name.
BINDINGS, BINDING_LAYERS = ("cli/", "bindings/"), GROUND | {"report", "jobs", "io", "scenes"}
METHOD_LISTS = {"families/registry.hpp", "families/method_text.hpp", "families/method_json.hpp", "families/setting_quantity.hpp"}  # the list of methods, their texts, and both as data
C_LEAST = {"base/", "batch/pose_sampler.hpp", "curve/", "families/method_text.hpp", "jobs/curve_of_keys.hpp"}  # what any source of bindings/c may include of the library
C_PARTS = {  # and those beside, of which a package for the web takes as many as it needs: source -> what it may include besides those
    "bake": {"batch/"}, "json_text": {"fields/"}, "lists": {"families/", "fields/"},
    "analysis": {"analysis.hpp", "families/", "fields/"}, "tasks": {"fields/", "jobs/"},
    "files": {"families/", "fields/", "files.hpp", "scenes/"}, "written": {"fields/"},
    "skeletons": {"fields/", "files.hpp", "math/euler.hpp", "scenes/"}, "values": {"fields/", "jobs/", "scenes/scene_file.hpp"}}
THIRD_PARTY = {"fast_float/": "src/orispline/io/", "CLI/": "cli/options/command.cpp", "nlohmann/": ("cli/output/json_document.cpp", "src/orispline/io/blending_file.cpp", "src/orispline/scenes/gltf/", "tests/c/", "tests/bindings/"),
               "meshoptimizer.h": "src/orispline/scenes/gltf/meshopt.cpp", "assimp/": "src/orispline/scenes/assimp.cpp", "benchmark/": "benchmarks/", "glm/": "benchmarks/",
               "smooth/so3": "benchmarks/", "smooth/spline/": "benchmarks/", "sophus/": "benchmarks/", "basalt/": "benchmarks/"}  # third party -> the only places that may include it
FOLDERS = ("src", "cli", "papers", "tests", "examples", "tools", "bindings", "benchmarks")
FILE_LINES, FUNCTION_LINES, MEDIAN_LINES = 600, 60, 200
EXCEPTIONS = {}  # path -> the reason why it may be larger
SPDX = re.compile(r"(#!.*\n# |# |// )SPDX-License-Identifier: Apache-2\.0\n")
EMPTY_NAME = re.compile(r"(.*/)?(utils?|helpers?|common|misc|detail|impl)[/.]")
SYSTEM_MATH = re.compile(r"(?<!\w)(std)?::(a?(cos|sin|tan)h?|atan2|exp2?|expm1|log(2|10|1p)?|pow|cbrt|hypot|erfc?|[lt]gamma)[fl]?(?=\()")
SILENT = re.compile(r'R"(\w*)\(.*?\)\1"|"(\\.|[^"\\\n])*"|\'(\\.|[^\'\\\n])\'|//[^\n]*|/\*.*?\*/|^#([^\n]*\\\n)*[^\n]*', re.M | re.S)


def layer_of(include):
    """The innermost folder that the table names, of a file of the library; else its first one, that no table allows."""
    if not (folders := re.match(r"orispline/(.+)/", include)):
        return None
    folder = folders[1]
    while "/" in folder and folder not in LAYERS:
        folder = folder.rpartition("/")[0]
    return folder


def public_headers(sources):
    """Those beside the folders of the library, and what they include."""
    public = {path: text for path, text in sources.items() if re.fullmatch(r"src/orispline/\w+\.hpp", path)}
    named = {name for text in public.values() for name in re.findall(r"#include <(orispline/[^>]+)>", text)}
    return named | {path.removeprefix("src/") for path in public}


def binding_breaches(path, names, public):
    """The command and the bindings include what is composed."""
    if path.startswith(BINDINGS):
        yield from (f"{path}: the command and the bindings must not include {name}, wanted jobs, io, scenes or a public header" for name in names
                    if (layer := layer_of(name)) and name not in public and layer.partition("/")[0] not in BINDING_LAYERS
                    and name.removeprefix("orispline/") not in METHOD_LISTS)


def c_breaches(path, names):
    """A package that leaves out a part of the interface to C needs nothing of the library for it."""
    if path.startswith("bindings/c/"):
        allowed = C_LEAST | C_PARTS.get(pathlib.PurePath(path).stem, set())
        yield from (f"{path}: this part of the interface must not include {name}" for name in names
                    if name.startswith("orispline/") and not any(name.removeprefix("orispline/").startswith(entry) for entry in allowed))


def cli_layer_of(path):
    """`options`, or `commands/smooth`; none for a file of cli itself."""
    folder = re.match(r"(commands/[^/]+|[^/]+)/", path)
    return folder and folder[1]


def library_breaches(path, names):
    layer = layer_of(path.removeprefix("src/"))
    for name in names:
        if layer and name.startswith("orispline/") and layer_of(name) not in LAYERS.get(layer, set()) | {layer}:
            yield f"{path}: layer {layer} must not include {name}"


def cli_breaches(path, names):
    """In cli, names in quotes begin with a folder of cli; `papers`, which lies beside it, is a layer of the same program."""
    layer = cli_layer_of(path.removeprefix("cli/"))
    allowed = CLI_LAYERS.get(layer and layer.partition("/")[0], set()) | {layer}
    for name in names:
        if layer and cli_layer_of(name) not in allowed:
            yield f"{path}: layer {layer} of the command must not include {name}"


def include_breaches(sources):
    graph, public = {}, public_headers(sources)
    for path, text in sources.items():
        names = re.findall(r'^\s*#\s*include\s*[<"]([^>"]+)', text, re.M)
        quoted = re.findall(r'^\s*#\s*include\s*"([^"]+)', text, re.M)
        graph[path] = {f"src/{name}" for name in names if name.startswith("orispline/")}
        if path.startswith("src/"):
            yield from library_breaches(path, names)
            if quoted:
                yield f"{path}: wanted #include <orispline/...>, found one with quotes"
        if path.startswith(("cli/", "papers/")):
            graph[path] |= {name if name.startswith("papers/") else f"cli/{name}" for name in quoted}
            yield from cli_breaches(path, quoted)
        yield from binding_breaches(path, names, public)
        yield from c_breaches(path, names)
        if path.startswith("examples/"):
            yield from (f"{path}: wanted a public header, <orispline/NAME.hpp>, found {name}" for name in names
                        if re.match(r"orispline/.+/", name))
        yield from (f"{path}: {name} is for {place if isinstance(place, str) else ' or '.join(place)} only" for name in names for library, place in THIRD_PARTY.items()
                    if name.startswith(library) and not path.startswith(place))
    try:
        graphlib.TopologicalSorter(graph).prepare()
    except graphlib.CycleError as circle:
        yield "include circle: " + " -> ".join(circle.args[1])


def quiet(text):
    """With blanks for texts, comments and the preprocessor's lines, of the same places."""
    return SILENT.sub(lambda found: re.sub(r"[^\n]", " ", found[0]), text)


def functions(path, text):
    """(first line, last line) of every function; in C++ of every block that follows a parameter list or a condition. The
    lines of a docstring do not count."""
    if path.endswith(".py"):
        return [(f.lineno, f.end_lineno - len((ast.get_docstring(f, clean=False) or "").splitlines()))
                for f in ast.walk(ast.parse(text)) if isinstance(f, ast.FunctionDef)]
    text = quiet(text)
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


def shared_classes(text):
    """(name with its namespaces, line) of each class that other files could define too: not of those in a namespace without
    a name, in a class or in a function."""
    text = quiet(text)
    scopes, head = [], 0
    for mark in re.finditer(r"[{};]", text):
        before = text[head : mark.start()].strip()
        if mark[0] == "{":
            space = re.search(r"\bnamespace(?: (\w+(?:::\w+)*))?$", before)
            name = re.search(r"(?<!enum )\b(?:struct|class)(?: ORISPLINE_EXPORT)? (\w+)(?: final)?(?:\s*:(?!:).*)?$", before, re.S)
            if name and None not in scopes:
                yield "::".join([*scopes, name[1]]), text.count("\n", 0, mark.start()) + 1
            scopes.append(space[1] if space else None)  # None, too, of a namespace without a name
        elif mark[0] == "}" and scopes:
            scopes.pop()
        head = mark.end()


def class_breaches(sources):
    """Two classes of one name are one to the linker, which takes the functions of either for both."""
    places = {}
    for path, text in sources.items():
        if path.startswith(("src/", "cli/")):
            for name, line in shared_classes(text):
                places.setdefault(name, []).append(f"{path}: line {line}")
    yield from (f"{where[1]}: {name} is the name of another class, in {where[0]}" for name, where in places.items() if len(where) > 1)


def flag_breaches(path, text):
    """The library speaks to callers in C++ and other languages: the options of the command are for `cli`."""
    if not path.startswith("src/orispline/"):
        return
    for literal in SILENT.finditer(text):
        if literal[0].startswith(('"', 'R"')) and (flag := re.search(r"(?<![\w-])--[a-z][a-z-]*", literal[0])):
            yield f"{path}: line {text.count(chr(10), 0, literal.start()) + 1}: {flag[0]} is a word of the command"


def dropped_result_breaches(path, text):
    """What can fail must not be overlooked: a header declares it [[nodiscard]]."""
    if path.startswith("src/orispline/") and path.endswith(".hpp"):
        for found in re.finditer(r"^ *(?:(?:static|virtual|inline|constexpr) )*Expected<.*> \w+\(", text, re.M):
            yield f"{path}: line {text.count(chr(10), 0, found.start()) + 1}: wanted [[nodiscard]] before Expected"


def bits_breaches(path, text):
    """What the system's library rounds in one way on one processor and in another way on the next."""
    if path.startswith(("src/", *BINDINGS)) and not path.endswith(".py"):
        code = quiet(text)
        for found in SYSTEM_MATH.finditer(code):
            yield f"{path}: line {code.count(chr(10), 0, found.start()) + 1}: {found[0]}() has other bits elsewhere, wanted that of math/number.hpp"


def file_breaches(path, text):
    lines, longest = text.count("\n"), max((b - a + 1, a) for a, b in [(1, 1), *functions(path, text)])
    rules = ((path not in EXCEPTIONS and lines > FILE_LINES, f"{lines} lines, at most {FILE_LINES}"),
             (path not in EXCEPTIONS and longest[0] > FUNCTION_LINES, "function of {} lines at line {}".format(*longest)),
             (not SPDX.match(text), "the first line is not the SPDX line"),
             (path.endswith(".hpp") and "#pragma once" not in text, "no #pragma once"),
             (EMPTY_NAME.match(path), "this name does not say what is in it"))
    return [f"{path}: {breach}" for broken, breach in rules if broken]


root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else ".")
files = [f for folder in FOLDERS for f in sorted((root / folder).rglob("*")) if f.suffix in {".hpp", ".cpp", ".py", ".h", ".c"}]
sources = {f.relative_to(root).as_posix(): f.read_text("utf-8") for f in files}
breaches = [*include_breaches(sources), *class_breaches(sources), *(b for path, text in sources.items() for b in (*file_breaches(path, text), *flag_breaches(path, text), *bits_breaches(path, text),
                                                                                             *dropped_result_breaches(path, text)))]
if (median := statistics.median(text.count("\n") for text in sources.values())) >= MEDIAN_LINES:
    breaches.append(f"the median file has {median} lines, wanted below {MEDIAN_LINES}")
sys.exit("\n".join(breaches) or 0)
