#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Readers of code that are no compilers find the names of the library: names_test.py ROOT; skipped (77) without universal ctags."""
import pathlib
import re
import shutil
import subprocess
import sys

root = pathlib.Path(sys.argv[1])
ctags = shutil.which("ctags")
if not ctags or "Universal" not in subprocess.run([ctags, "--version"], capture_output=True, text=True).stdout:
    print("names: skipped, universal ctags is not here")
    sys.exit(77)

sources = sorted((root / "src/orispline").rglob("*.cpp"))
found = subprocess.run([ctags, "-x", "--_xformat=%F\t%N\t%K", *map(str, sources)], capture_output=True, text=True, check=True).stdout
names = {}
for line in found.splitlines():
    path, name, kind = line.split("\t")
    if kind == "function":
        names.setdefault(path, set()).add(name.rpartition("::")[2])

DEFINED = re.compile(r"^(?!return\b|static_assert\b|using\b|template\b|#)[A-Za-z][\w:<>,&* \[\]]* (\w+)\([^;{}]*\)(?: const)?(?: noexcept)? \{", re.M)
hidden = [f"{path.relative_to(root)}: ctags finds nothing of {', '.join(sorted(defined))}" for path in sources
          if (defined := set(DEFINED.findall(path.read_text("utf-8")))) and not names.get(str(path))]
sys.exit("\n".join(hidden) or 0)
