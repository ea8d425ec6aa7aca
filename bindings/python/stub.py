#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The stub of the module orispline._core that is installed, by nanobind's stubgen: stub.py FILE writes it there."""
import pathlib
import re
import sys

UNTOLD = {"object": "Any", "dict": "dict[str, Any]", "list": "list[Any]", "tuple": "tuple[Any, ...]"}  # what a binding leaves open


def stub():
    """Its text, in which no type is left open to an error of mypy."""
    import orispline._core
    from nanobind.stubgen import StubGen
    made = StubGen(orispline._core, include_docstrings=False, quiet=True)
    made.put(orispline._core)
    text = re.sub(r"(-> |: )(object|dict|list|tuple)(?=[:,)]| [|=])", lambda found: found[1] + UNTOLD[found[2]], made.get())
    text = re.sub(r"^(version: str) = .*$", r"\1", text, flags=re.M)
    if "Any" in re.findall(r"\w+", text) and not re.search(r"^from typing import .*\bAny\b", text, re.M):
        text = re.sub(r"^from typing import (.*)$", lambda found: "from typing import " + ", ".join(sorted({"Any", *found[1].split(", ")})),
                      text, count=1, flags=re.M)
    return "# SPDX-License-Identifier: Apache-2.0\n" + text


if __name__ == "__main__":
    pathlib.Path(sys.argv[1]).write_text(stub(), "utf-8")
