#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns the 60-digit reference values into the compact tables that the family tests read.

Reads golden.json and golden_methods.json of the reference (by default ../shared/math beside the checkout) and writes
tests/data/golden/: keys.csv (the sequences), cases.csv (what to build from them) and one table of expected motions per
family. Every double is written by repr, so it reads back exactly; the output depends on the input only.

    tools/make_golden.py [--source FOLDER]            write the tables
    tools/make_golden.py [--source FOLDER] --check    compare with the committed tables, write nothing
"""
import argparse
import json
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIGNS = {"asgiven": "as_given", "shortest": "shortest", "both": "shortest"}
TIMED = {"C1": "timed-c1", "C2": "timed-c2", "C3": "timed-c3", "C3s": "timed-sextic"}
ENDS = {"repeat": "repeat", "linear": "natural", "quadratic": "quadratic", "omega": "clamped"}
TENSIONS = ("tension", "tension2", "tension3")

CONVENTIONS = """\
# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.
# Every number is the double nearest to a value computed with 60 digits."""
KEYS_NOTE = """\
# Key quaternions may be off unit norm: the reference normalises them with 60 digits before use.
# signs: as_given leaves them, shortest negates key i when its dot product with key i-1 is negative."""
CASES_NOTE = """\
# A case builds `family` through `sequence` of keys.csv. Lists are separated by blanks; a tension has one value for all
# keys or one per key; a clamped end has its body rate. max_halfangle [rad] is the largest half rotation angle of any
# logarithm in the case: near pi the problem itself is ill-conditioned, in proportion to 1/(pi - max_halfangle)."""
ROWS_NOTE = """\
# side left is the limit at the right end of the segment, right the limit at its left end or a point inside."""


def described(params):
    """End rule, end rates and tensions of one knot-aware case."""
    rates = params.get("omega_start"), params.get("omega_end")
    return TIMED[params["scheme"]], ENDS[params["ends"]], rates, params["tau"]


def settings(case):
    """(family, ends, (start rate, end rate), tensions) of a reference case, or None where there is no such family."""
    method, params = case["method"], case["params"]
    none = None, None
    if method == "slerp":
        return "slerp", "", none, []
    if method == "squad":
        return "squad", params["end"], none, []
    if method == "squad_nonuniform" and params["variant"] == "geier":
        return "squad-timed", params["ends"], none, []
    if method == "tan":
        return "quintic", "repeat", none, [params["alpha"]]
    if method == "g3":
        return "sextic", "repeat", none, [params["beta"]]
    if method == "knotaware":
        return described(params)
    return None


def text(value):
    """A field: nothing, a number, or numbers separated by blanks."""
    if value is None:
        return ""
    if isinstance(value, list):
        return " ".join(repr(float(x)) for x in value)
    return repr(float(value))


def origin(sources):
    names = ", ".join(f"{name} (format {g['format']}, seed {g['seed']})" for name, g in sources.items())
    return f"# Made by tools/make_golden.py from {names}."


def tables(sources):
    """File name -> text."""
    keys, cases, rows = [], [], {}
    for g in sources.values():
        used = {}
        for case in g["cases"]:
            chosen = settings(case)
            if chosen is None:
                continue
            family, ends, rates, tensions = chosen
            name = case["seq"]
            if used.setdefault(name, case["knots"]) != case["knots"]:
                sys.exit(f"sequence {name} is used with two sets of key times, wanted one")
            number = str(len(cases))
            padded = list(tensions) + [None] * (len(TENSIONS) - len(tensions))
            cases.append(",".join([number, family, name, SIGNS[case["sign"]], ends, *map(text, rates), *map(text, padded),
                                   text(case["max_halfangle"])]))
            for segment, t, side, *motion in case["rows"]:
                values = [text(x) for part in motion for x in part]
                rows.setdefault(family, []).append(",".join([number, str(segment), text(t), side, *values]))
        for name, times in used.items():
            for t, q in zip(times, g["sequences"][name]["keys"], strict=True):
                keys.append(",".join([name, text(t), *map(text, q)]))
    head = origin(sources) + "\n" + CONVENTIONS + "\n"
    out = {"keys.csv": head + KEYS_NOTE + "\nsequence,t,qw,qx,qy,qz\n" + "\n".join(keys) + "\n",
           "cases.csv": head + CASES_NOTE + "\ncase,family,sequence,signs,ends,start_rate,end_rate," + ",".join(TENSIONS)
           + ",max_halfangle\n" + "\n".join(cases) + "\n"}
    for family, lines in rows.items():
        out[f"{family}.csv"] = (head + ROWS_NOTE + "\ncase,segment,t,side,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n"
                                + "\n".join(lines) + "\n")
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=pathlib.Path, default=ROOT.parent / "shared" / "math")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    sources = {name: json.loads((arguments.source / name).read_text()) for name in ("golden.json", "golden_methods.json")}
    folder = ROOT / "tests" / "data" / "golden"
    stale = []
    for name, content in tables(sources).items():
        if not arguments.check:
            (folder / name).write_text(content)
        elif not (folder / name).is_file() or (folder / name).read_text() != content:
            stale.append(name)
    if stale:
        sys.exit(f"differ from what the reference gives: {', '.join(stale)}")


if __name__ == "__main__":
    main()
