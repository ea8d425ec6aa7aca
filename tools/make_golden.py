#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Turns the 60-digit reference values into the compact tables that the family tests read.

Reads golden.json, golden_methods.json and golden_auto.json of the reference (by default ../shared/math beside the checkout) and writes
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

CONVENTIONS = """\
# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.
# Every number is the double nearest to a value computed with 60 digits."""
KEYS_NOTE = """\
# Key quaternions may be off unit norm: the reference normalises them with 60 digits before use.
# signs: as_given leaves them, shortest negates key i when its dot product with key i-1 is negative."""
CASES_NOTE = """\
# A case builds `family` through `sequence` of keys.csv. Lists are separated by blanks. parameters: name=value for all
# keys or one value per key, separated by semicolons. A clamped end has its body rate; key_rates are the body rates of
# all keys, one after the other; a period closes the curve. max_halfangle [rad] is the largest half rotation angle of
# any logarithm in the case: near pi the problem itself is ill-conditioned, in proportion to 1/(pi - max_halfangle)."""
ROWS_NOTE = """\
# side left is the limit at the right end of the segment, right the limit at its left end or a point inside."""


def tensions(values, *names):
    """Parameters by name, those that the family does not have left out."""
    return dict(zip(names, values))


def timed(params):
    """Family and parameters of one knot-aware case."""
    return {"family": TIMED[params["scheme"]], "parameters": tensions(params["tau"], "tension", "tension2", "tension3")}


def uneven(times):
    return any(abs((b - a) - (times[1] - times[0])) > 1e-12 for a, b in zip(times, times[1:]))


def settings(case):
    """What to build of a reference case, or None where there is no such family."""
    method, params = case["method"], case["params"]
    if method == "slerp":
        return {"family": "slerp"}
    if method == "squad":
        return {"family": "squad", "ends": params["end"]}
    if method == "squad_nonuniform" and params["variant"] == "geier":
        return {"family": "squad-timed", "ends": params["ends"]}
    if method == "tan":
        return {"family": "quintic", "ends": "repeat", "parameters": {"tension": params["alpha"]}}
    if method == "g3":
        return {"family": "sextic", "ends": "repeat", "parameters": {"tension": params["beta"]}}
    if method == "knotaware":
        return {**timed(params), "ends": ENDS[params["ends"]], "start_rate": params.get("omega_start"),
                "end_rate": params.get("omega_end")}
    if method == "knotaware_closed":
        *times, back = case["knots"]
        return {**timed(params), "times": times, "period": back - times[0]}
    if method == "family":
        orders = (f"tension{m + 1}" for m in range(params["k"]))
        per_key = [list(values) for values in zip(*params["tensions"])]
        return {"family": "family", "ends": "natural" if params["ends"] == "reflect" else params["ends"],
                "parameters": {"order": params["k"], **tensions(per_key, *orders)}}
    if method == "beta":  # control point i at time i: the curve starts at time 1, the reference's at 0
        return {"family": "beta", "times": [float(i) for i in range(len(params["beta1"]))], "shift": 1.0,
                "parameters": {"beta1": params["beta1"], "beta2": params["beta2"]}}
    if method == "hermite_catmull":
        return {"family": "hermite-cumulative"}
    if method == "hermite_given" and params["form"] == "cumulative" and params["degree"] == 3:
        return {"family": "hermite-cumulative", "key_rates": [x for key in params["rates"] for x in key[0]]}
    if method == "bspline3_approx" and not uneven(case["knots"]):  # on uneven knots the reference keeps even weights
        return {"family": "bspline", "parameters": {"degree": 3}}
    return None


def text(value):
    """A field: nothing, a number, or numbers separated by blanks."""
    if value is None:
        return ""
    if isinstance(value, list):
        return " ".join(repr(float(x)) for x in value)
    return repr(float(value))


def parameters_text(parameters):
    return ";".join(f"{name}={text(values)}" for name, values in parameters.items())


def origin(sources):
    names = ", ".join(f"{name} (format {g['format']}, seed {g['seed']})" for name, g in sources.items())
    return f"# Made by tools/make_golden.py from {names}."


def case_line(number, case, chosen, sequence):
    return ",".join([number, chosen["family"], sequence, SIGNS[case["sign"]], chosen.get("ends", ""),
                     text(chosen.get("start_rate")), text(chosen.get("end_rate")),
                     parameters_text(chosen.get("parameters", {})), text(chosen.get("period")),
                     text(chosen.get("key_rates")), text(case["max_halfangle"])])


def tables(sources):
    """File name -> text."""
    keys, cases, rows = [], [], {}
    for g in sources.values():
        used = {}
        for case in g["cases"]:
            chosen = settings(case)
            if chosen is None:
                continue
            times = chosen.get("times", case["knots"])
            own_times = g["sequences"][case["seq"]]["knots"]  # or in words: uniform
            name = f"{case['seq']}-even" if isinstance(own_times, list) and times != own_times else case["seq"]
            if used.setdefault(name, (case["seq"], times)) != (case["seq"], times):
                sys.exit(f"sequence {name} is used with two sets of key times, wanted one")
            number = str(len(cases))
            cases.append(case_line(number, case, chosen, name))
            for segment, t, side, *motion in case["rows"]:
                values = [text(x) for part in motion for x in part]
                rows.setdefault(chosen["family"], []).append(
                    ",".join([number, str(segment), text(t + chosen.get("shift", 0.0)), side, *values]))
        for name, (sequence, times) in used.items():
            for t, q in zip(times, g["sequences"][sequence]["keys"], strict=True):
                keys.append(",".join([name, text(t), *map(text, q)]))
    head = origin(sources) + "\n" + CONVENTIONS + "\n"
    out = {"keys.csv": head + KEYS_NOTE + "\nsequence,t,qw,qx,qy,qz\n" + "\n".join(keys) + "\n",
           "cases.csv": head + CASES_NOTE + "\ncase,family,sequence,signs,ends,start_rate,end_rate,parameters,period,"
           "key_rates,max_halfangle\n" + "\n".join(cases) + "\n"}
    for family, lines in rows.items():
        out[f"{family}.csv"] = (head + ROWS_NOTE + "\ncase,segment,t,side,qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n"
                                + "\n".join(lines) + "\n")
    return out


def auto_tables(g):
    """The same for golden_auto.json, which has keys and rows of its own and was computed in double precision."""
    head = (f"# Made by tools/make_golden.py from golden_auto.json (format {g['format']}), computed in double precision.\n"
            + CONVENTIONS.splitlines()[0] + "\n")
    limits = g["tolerance"]
    note = f"# Agreement to be reached, relative to max(1, |.|): q {limits['q']}, w {limits['omega']}, a {limits['alpha']}.\n"
    keys, rows = [], []
    for name, case in g["cases"].items():
        keys += [",".join([name, text(t), *map(text, q)]) for t, q in zip(case["times"], case["keys"], strict=True)]
        rows += [",".join([name, text(t), *(text(x) for part in motion for x in part)]) for t, *motion in case["rows"]]
    return {"auto_keys.csv": head + "sequence,t,qw,qx,qy,qz\n" + "\n".join(keys) + "\n",
            "auto.csv": head + note + "sequence,t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n" + "\n".join(rows) + "\n"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=pathlib.Path, default=ROOT.parent / "shared" / "math")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    sources = {name: json.loads((arguments.source / name).read_text()) for name in ("golden.json", "golden_methods.json")}
    folder = ROOT / "tests" / "data" / "golden"
    stale = []
    auto = json.loads((arguments.source / "golden_auto.json").read_text())
    for name, content in (tables(sources) | auto_tables(auto)).items():
        if not arguments.check:
            (folder / name).write_text(content)
        elif not (folder / name).is_file() or (folder / name).read_text() != content:
            stale.append(name)
    if stale:
        sys.exit(f"differ from what the reference gives: {', '.join(stale)}")


if __name__ == "__main__":
    main()
