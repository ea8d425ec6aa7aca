#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures COMMAND, the built orispline, anew for the tables of the documents.

    tools/measure.py limits COMMAND [--most N]            docs/limits.md: time and memory per key, up to N keys
    tools/measure.py retiming COMMAND                     docs/retime.md: durations within limits beside those of Ruckig
    tools/measure.py band COMMAND [--seeds N]             docs/smooth.md: how often the band of `smooth --sigma` holds the truth
    tools/measure.py smoothing COMMAND [--seeds N] [--golden]   docs/smooth.md: noise on recordings, smoothed
    tools/measure.py fidelity COMMAND                     docs/families/measured.md: recordings thinned to keys

tools/measures/README.md says what each needs. The tables of limits, retiming and fidelity are written into their pages; the others are printed.
"""
import argparse
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
sys.path.append(str(ROOT / "benchmarks"))


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    measures = parser.add_subparsers(dest="measure", required=True)
    for name in ("limits", "retiming", "band", "smoothing", "fidelity"):
        measure = measures.add_parser(name)
        measure.add_argument("command", type=lambda path: pathlib.Path(path).resolve())
        if name == "limits":
            measure.add_argument("--most", type=int, default=10**7, metavar="N")
        if name in ("band", "smoothing"):
            measure.add_argument("--seeds", type=int, default=1 if name == "band" else 3, metavar="N")
        if name in ("band", "smoothing", "fidelity"):
            measure.add_argument("--data", type=pathlib.Path, default=ROOT.parent / "shared" / "data", help="the recordings, which lie beside the checkout")
        if name in ("smoothing", "fidelity"):
            measure.add_argument("--reference", type=pathlib.Path, default=ROOT.parent / "shared" / "math", help="the folder of the reference")
        if name == "smoothing":
            measure.add_argument("--recordings", nargs="+", default=["BROAD", "PX4", "MRO"])
            measure.add_argument("--golden", action="store_true", help="writes the reference's figures to tests/data/golden/smooth_recordings.csv")
    return parser.parse_args()


def main():
    options = arguments()
    if options.measure == "fidelity":
        from measures.fidelity import fidelity as run
    elif options.measure in ("band", "smoothing"):
        import measures.smoothing
        run = getattr(measures.smoothing, options.measure)
    else:
        import measures.command
        run = getattr(measures.command, options.measure)
    run(options)


if __name__ == "__main__":
    main()
