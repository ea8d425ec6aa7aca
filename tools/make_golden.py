#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes tables of true values in tests/data, and the constants that the library takes from the same computations.

    tools/make_golden.py NAME... [--source FOLDER] [--into FOLDER] [--check]

tools/golden/README.md says which NAME makes which files and what it needs. --source is the reference, by default ../shared/math
beside the checkout; --into writes below another folder; --check compares with what is there and writes nothing.
"""
import argparse
import importlib
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
MAKERS = {"golden": "reference", "smooth": "reference", "rational": "splines", "positions": "splines", "biarcs": "curves", "inner": "curves",
          "monotone": "curves", "pchip": "by_scipy", "auto": "windows", "measured": "windows", "mean": "estimates", "sigma": "estimates", "least": "least", "least_hard": "least",
          "tuned": "by_scipy", "rotation_spline": "by_scipy", "euler": "by_scipy", "so3": "functions", "elementary": "functions",
          "kernel": "functions"}  # name -> module of tools/golden with a function of that name: the folder of the reference -> {path: text}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("names", nargs="+", choices=MAKERS, metavar="NAME")
    parser.add_argument("--source", type=pathlib.Path, default=ROOT.parent / "shared" / "math")
    parser.add_argument("--into", type=pathlib.Path, default=ROOT)
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    stale = []
    for name in options.names:
        for place, text in getattr(importlib.import_module(f"golden.{MAKERS[name]}"), name)(options.source).items():
            path = options.into / place
            if options.check:
                stale += [] if path.is_file() and path.read_text("utf-8") == text else [place]
                continue
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(text, "utf-8")
    if stale:
        sys.exit(f"{', '.join(stale)}: not what tools/make_golden.py {' '.join(options.names)} makes; run it")


if __name__ == "__main__":
    main()
