#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the benchmarks: run.py PROGRAM FOLDER [--sizes full|quick|smoke] [--document PAGE]

With full sizes also for the smaller instruction sets that the processor has, and SciPy where Python has it.
"""
import argparse
import json
import os
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
REPETITIONS = {"full": ("9", "0.05"), "quick": ("5", "0.01"), "smoke": ("1", "0.001")}  # and least seconds of each
SMALLER_SETS = {"v4": ("v3", "v2"), "v3": ("v2",)}
SHORT = "^(limit/fma|one_curve/(ours|Eigen product)/(double|float)/1000000)"  # what is measured with the smaller ones


def bench(program, folder, name, sizes, isa=None, only="."):
    repetitions, seconds = REPETITIONS[sizes]
    file = folder / f"{name}.json"
    environment = os.environ | ({"ORISPLINE_ISA": isa} if isa else {})
    subprocess.run([program, f"--sizes={sizes}", f"--benchmark_repetitions={repetitions}",
                    f"--benchmark_min_time={seconds}", "--benchmark_enable_random_interleaving",
                    "--benchmark_report_aggregates_only", f"--benchmark_filter={only}",
                    f"--benchmark_out={file}", "--benchmark_out_format=json"],
                   env=environment, check=True, stdout=subprocess.DEVNULL if sizes == "smoke" else None)
    return file.name, json.loads(file.read_text("utf-8"))["context"]["isa"]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--sizes", choices=REPETITIONS, default="quick")
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    chosen.folder.mkdir(parents=True, exist_ok=True)
    (chosen.folder / "scipy.json").unlink(missing_ok=True)
    name, isa = bench(chosen.program, chosen.folder, "measured", chosen.sizes)
    names = [name]
    if chosen.sizes == "full":
        if "ORISPLINE_ISA" not in os.environ:
            names += [bench(chosen.program, chosen.folder, f"measured_{smaller}", "quick", smaller, SHORT)[0]
                      for smaller in SMALLER_SETS.get(isa, ())]
        subprocess.run([sys.executable, HERE / "scipy_peer.py", chosen.folder / "scipy.json"], check=True)
    (chosen.folder / "runs.json").write_text(json.dumps(names), "utf-8")
    document = ["--document", chosen.document] if chosen.document else []
    subprocess.run([sys.executable, HERE / "ratios.py", chosen.folder, *document], check=True)


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as failure:
        sys.exit(f"benchmarks: {failure.cmd[0]} ended with {failure.returncode}")
