#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""liborispline_c exports the functions of its header and no other name, and the fuzzer calls each: exports_test.py NM LIBRARY HEADER FUZZER."""
import pathlib
import re
import subprocess
import sys

nm, library, header, fuzzer = sys.argv[1:]
lines = subprocess.run([nm, "-D", "--defined-only", library], capture_output=True, text=True, check=True).stdout.splitlines()
found = {line.split()[-1] for line in lines}
text = re.sub(r"//[^\n]*", "", pathlib.Path(header).read_text("utf-8"))
wanted = {re.search(r"(\w+)\($|(\w+)\(", declaration)[0].rstrip("(")
          for declaration in re.findall(r"^ORISPLINE_C_API [^(]*\(", text, re.M)}
assert len(wanted) > 40, wanted
called = set(re.findall(r"\borispline_\w+", pathlib.Path(fuzzer).read_text("utf-8")))
sys.exit("\n".join([f"{name} is exported and not in the header" for name in sorted(found - wanted)]
                   + [f"{name} is in the header and not exported" for name in sorted(wanted - found)]
                   + [f"{name} is in the header and not called by {fuzzer}" for name in sorted(wanted - called)]) or 0)
