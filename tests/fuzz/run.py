#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs every fuzz target for a time: run.py FOLDER SECONDS [--jobs N] [--only TARGET] [--slowest S].

FOLDER holds the targets, linked with libFuzzer. What they learn stays in FOLDER/grown, so that the next run goes on from
there; what breaks a claim lies in FOLDER/findings. Prints the executions of every target, and exits with 1 if there are
findings."""
import argparse
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
MOST_MEMORY = 4096  # [MB] of an input


def options_of(target):
    """Of the OSS-Fuzz project, so that both run alike."""
    text = (HERE / f"oss-fuzz/{target}.options").read_text("utf-8")
    return [f"-{line.replace(' ', '')}" for line in text.splitlines() if "=" in line and not line.startswith("dict")]


def fuzzed(program, seconds, slowest):
    """Its name, the executions and the findings of one target."""
    target, folder = program.name, program.parent
    grown, findings = folder / "grown" / target, folder / "findings"
    for place in (grown, findings):
        place.mkdir(parents=True, exist_ok=True)
    known = set(findings.glob(f"{target}-*"))
    memory = pathlib.Path("/dev/shm")  # where files cost nothing
    environment = os.environ | ({"TMPDIR": str(memory)} if memory.is_dir() else {})
    command = [program, f"-max_total_time={seconds}", f"-timeout={slowest}", f"-report_slow_units={slowest}",
               f"-rss_limit_mb={MOST_MEMORY}", f"-dict={HERE / 'orispline.dict'}",
               f"-artifact_prefix={findings}/{target}-", "-print_final_stats=1",
               *options_of(target), grown, HERE / "corpus" / target]
    with open(folder / f"{target}.log", "w", encoding="utf-8") as log:
        done = subprocess.run(command, stdout=log, stderr=log, env=environment, check=False)
    text = (folder / f"{target}.log").read_text("utf-8", "replace")
    counts = re.findall(r"^(?:#|stat::number_of_executed_units: *)(\d+)", text, re.M)
    new = sorted(set(findings.glob(f"{target}-*")) - known)
    if done.returncode and not new:
        new = [folder / f"{target}.log"]
    return target, max(map(int, counts), default=0), new


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("seconds", type=int)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", help="one target, such as fuzz_keys")
    parser.add_argument("--slowest", type=int, default=40, metavar="S",
                        help="so many seconds of an input are a finding (default %(default)s); more on a busy machine")
    arguments = parser.parse_args()
    programs = sorted(path for path in arguments.folder.resolve().glob("fuzz_*")
                      if path.is_file() and path.suffix == "" and arguments.only in (None, path.name))
    if not programs:
        sys.exit(f"no fuzz targets in {arguments.folder}")
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(lambda program: fuzzed(program, arguments.seconds, arguments.slowest), programs))
    for target, executions, findings in results:
        print(f"{target:15} {executions:12,} executions", *findings, sep="\n  " if findings else "")
    print(f"{'all':15} {sum(executions for _, executions, _ in results):12,} executions")
    return 1 if any(findings for _, _, findings in results) else 0


if __name__ == "__main__":
    sys.exit(main())
