#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reference values of auto where its polynomial is guarded: step (2) of docs/families/auto.md.

The rates without the guard are those of auto_reference.py, which lies with the reference (by default ../shared/math beside
the checkout); the guard is computed here as it is defined, every key left out of its window in turn. Needs numpy.

    tools/make_auto_golden.py [--source FOLDER] [--check]
"""
import argparse
import importlib.util
import json
import pathlib

import numpy as np
from golden_files import write_or_check

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEAD = ("# Made by tools/make_auto_golden.py from auto_reference.py, computed in double precision.\n"
        "# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.\n")
LIMITS = "# Agreement to be reached, relative to max(1, |.|): q 1e-11, w 1e-09, a 1e-07.\n"


def loaded(folder):
    spec = importlib.util.spec_from_file_location("auto_reference", folder / "auto_reference.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def left_out(x, at, others):
    """The value at a time of the polynomial through other values, and of their natural cubic spline."""
    polynomial = sum(value * np.prod([(at - b) / (a - b) for k, b in enumerate(x) if k != j])
                     for j, (a, value) in enumerate(zip(x, others)))
    h, m = np.diff(x), len(x)
    matrix, right = np.eye(m), np.zeros((m, 3))
    secants = np.diff(others, axis=0) / h[:, None]
    for j in range(1, m - 1):
        matrix[j, j - 1:j + 2] = h[j - 1], 2 * (h[j - 1] + h[j]), h[j]
        right[j] = 6 * (secants[j] - secants[j - 1])
    second = np.linalg.solve(matrix, right)
    if not x[0] < at < x[-1]:  # beyond its keys the spline is a line
        end, near = (0, 1) if at < x[0] else (-1, -2)
        slope = secants[end] - np.sign(x[near] - x[end]) * h[end] * second[near] / 6
        return polynomial, others[end] + (at - x[end]) * slope
    k = np.searchsorted(x, at) - 1
    a, b = (x[k + 1] - at) / h[k], (at - x[k]) / h[k]
    return polynomial, (a * others[k] + b * others[k + 1]
                        + ((a**3 - a) * second[k] + (b**3 - b) * second[k + 1]) * h[k]**2 / 6)


def guard(auto, keys, times):
    """β of every key."""
    found = []
    for i in range(len(times)):
        first = min(max(0, i - 3), len(times) - 7)
        x, logs = times[first:first + 7] - times[i], auto.lg(auto.qm(auto.cj(keys[i]), keys[first:first + 7]))
        errors = np.array([[np.sum((logs[j] - value)**2) for value in left_out(x[rest], x[j], logs[rest])]
                           for j in range(7) for rest in [np.arange(7) != j]])
        polynomial, spline = errors[1:6].sum(axis=0)
        share = 1.0 - auto.S(np.log(polynomial / spline), np.log(0.3), 0.0)
        if i - first != 3:
            outer = errors[0] if i - first < 3 else errors[6]
            share *= 1.0 - auto.S(np.log(polynomial * outer[0] / (spline * outer[1])), np.log(4.0), np.log(20.0))
        found.append(share)
    return np.array(found)


def guarded_rates(auto, keys, times):
    steps = auto.nrm(auto.lg(auto.qm(auto.cj(keys[:-1]), keys[1:])))
    if np.convolve(steps, np.ones(6)).max() > auto.PA:
        raise SystemExit("make_auto_golden: these keys turn so far that the windows are narrower, where the guard is another")
    switches = auto.RA, auto.RB
    with_polynomial = np.array(auto.rates(keys, times))
    auto.RA, auto.RB = -2.0, -1.0  # no key is smooth
    without = np.array(auto.rates(keys, times))
    auto.RA, auto.RB = switches
    return tuple(without + guard(auto, keys, times)[:, None] * (with_polynomial - without))


def uneven_keys(auto, seed, wobble):
    """33 keys of a smooth motion whose intervals differ by a factor of up to 8."""
    dice = np.random.default_rng(seed)
    times = np.concatenate([[0.0], np.cumsum(0.25 * dice.choice([1, 2, 4, 8], 32))])
    turn = np.column_stack([0.2 * np.sin(0.31 * times), 0.25 * np.cos(0.23 * times), 0.02 * times])
    turn[:, 0] += wobble * np.sin(1.7 * times)
    return auto.ex(turn), times


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--source", type=pathlib.Path, default=ROOT.parent / "shared" / "math")
    parser.add_argument("--check", action="store_true")
    source = parser.parse_args().source
    auto = loaded(source)
    recorded = json.loads((source / "golden_auto.json").read_text())["cases"]["smooth25"]
    sequences = {"smooth25": (np.array(recorded["keys"], float), np.array(recorded["times"], float)),
                 **{f"uneven{n}": uneven_keys(auto, seed, wobble) for n, (seed, wobble) in enumerate(((2, 0.03), (3, 0.1), (4, 0.01), (6, 0.01), (131, 0.01)))}}
    key_lines, rows = [], []
    for name, (keys, times) in sequences.items():
        key_lines += [",".join([name, *(repr(float(x)) for x in (t, *q))]) for t, q in zip(times, keys)]
        at = np.sort(np.concatenate([times[:-1] + share * np.diff(times) for share in (0.0, 0.35, 0.8)]))
        motions = auto.evaluate(keys, times, at, guarded_rates(auto, keys, times), deriv=True)
        rows += [",".join([name, *(repr(float(x)) for x in np.concatenate([[t], *parts]))]) for t, *parts in zip(at, *motions)]
    write_or_check(ROOT / "tests/data/golden", {
        "auto_guard_keys.csv": HEAD + "sequence,t,qw,qx,qy,qz\n" + "\n".join(key_lines) + "\n",
        "auto_guard.csv": HEAD + LIMITS + "sequence,t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n" + "\n".join(rows) + "\n"})


if __name__ == "__main__":
    main()
