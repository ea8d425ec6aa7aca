#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The npm package beside the native library and three.js, and the studio: run.py PACKAGE TOOLS NATIVE STUDIO SCRIPT [--document PAGE]

PACKAGE is the built package, TOOLS the node_modules of its tools, NATIVE the program of native.cpp, STUDIO the built page of the studio,
SCRIPT studio.mjs beside the sources of the studio and its tools. It prints tables, and with PAGE fills the block of that page between
its own markers.
"""
import argparse
import datetime
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(1, str(HERE.parent))
from page_block import fill_block  # noqa: E402
from ratios import machine  # noqa: E402

START, END = "<!-- web: written by benchmarks/web/run.py -->\n", "<!-- end of web -->"


def verdict(found, most):
    return "met" if found <= most else "**missed**"


def ratios_table(ratios):
    yield from ("| what | times the other | wanted | |", "|---|---|---|---|")
    for row in ratios:
        most = row.get("most")
        wanted = f"≤ {most:g} × | {verdict(row['ratio'], most)}" if most else "stated |"
        yield f"| {row['what']} | {row['ratio']:.2f} × | {wanted} |"


def sizes_table(sizes):
    yield from ("| import | script | WebAssembly | together | wanted | |", "|---|---|---|---|---|---|")
    for part in sizes:
        name = "orispline" if part["name"] == "orispline" else f"orispline/{part['name']}"
        script, module, most = part["script"], part["module"], part["most"]
        yield (f"| `{name}` | {script / 1e3:.2f} kB | {f'{module / 1e3:.1f} kB' if module else 'none'} | {(script + module) / 1e3:.2f} kB "
               f"| ≤ {most / 1e3:g} kB | {verdict(script + module, most)} |")


def text(found, load):
    yield f"{machine()}; {datetime.date.today().isoformat()}; {found['versions']}; load {load:.1f} at the start and"
    yield f"{os.getloadavg()[0]:.1f} at the end, of other programs too; the studio in Chromium {found['studio']['version']}."
    yield from ("", *ratios_table(found["ratios"]), "", *ratios_table(found["studio"]["ratios"]), "", *sizes_table(found["sizes"]), "")


def measured(*words):
    run = subprocess.run(["node", *words], stdout=subprocess.PIPE, check=False)
    if run.returncode:
        sys.exit(run.returncode)  # it has said why
    return json.loads(run.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for name in ("package", "tools", "native", "studio", "script"):
        parser.add_argument(name, type=lambda path: pathlib.Path(path).resolve())
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    load = os.getloadavg()[0]
    found = measured(HERE / "package.mjs", chosen.package, chosen.tools, chosen.native)
    found["studio"] = measured(chosen.script, chosen.studio, chosen.native)
    lines = list(text(found, load))
    print("\n".join(lines))
    if chosen.document:
        fill_block(chosen.document, START, END, lines)


if __name__ == "__main__":
    main()
