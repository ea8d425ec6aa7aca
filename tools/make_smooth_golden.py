#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns the reference values of smoothing into the tables that its tests read.

Reads golden_smooth.json of the reference (by default ../shared/math beside the checkout) and writes
tests/data/golden/smooth_cases.csv and smooth_nodes.csv. Every double is written by repr, so it reads back exactly.

    tools/make_smooth_golden.py [--source FOLDER] [--check]
"""
import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
NOTE = "# Quaternions: Hamilton, body to world, sign of no meaning. Rates: body frame, rad and s. The minimiser and its costs.\n"
FIGURES = ("cost", "data", "penalty", "logdet", "reml_sigma_known", "trace_hat_per_axis")


def numbers(values):
    return ",".join(repr(float(value)) for value in values)


def case_row(number, case):
    texts = [str(number), case["name"].replace(",", ""), str(case["order"]), case["loss"], case["start"], str(int(case["bias"]))]
    return ",".join(texts) + "," + numbers([case["lam"], case["c"], *(case[figure] for figure in FIGURES), *case["b"]])


def node_rows(number, case):
    gyro, weight = case["gyro"] or [[0, 0, 0]] * len(case["t"]), case["wg"] or 0
    for i, t in enumerate(case["t"]):
        yield f"{number}," + numbers([t, *case["keys"][i], case["w"][i], *gyro[i], weight, *case["q"][i], *case["omega"][i],
                                      *case["alpha"][i]])


def tables(cases):
    head = "case,name,order,loss,start,bias,lambda,threshold,cost,data,penalty,log_determinant,reml,trace,bx,by,bz\n"
    yield "smooth_cases.csv", NOTE + head + "".join(case_row(i, c) + "\n" for i, c in enumerate(cases))
    head = ("case,t,qw,qx,qy,qz,weight,gx,gy,gz,gyro_weight,"
            "found_qw,found_qx,found_qy,found_qz,wx,wy,wz,ax,ay,az\n")
    yield "smooth_nodes.csv", NOTE + head + "".join(row + "\n" for i, c in enumerate(cases) for row in node_rows(i, c))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=pathlib.Path, default=ROOT.parent / "shared" / "math")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    cases = json.loads((options.source / "golden_smooth.json").read_text("utf-8"))["cases"]
    for name, text in tables(cases):
        path = ROOT / "tests" / "data" / "golden" / name
        if not options.check:
            path.write_text(text, "utf-8")
        elif path.read_text("utf-8") != text:
            sys.exit(f"{path} is not what the reference gives")


main()
