#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Mutation tests: small faults in the library, and whether the tests find them. docs/testing.md tells how to read it.

All mutants are in one build, in build/mutation; the variable ORISPLINE_MUTANT chooses one. A run that was cut off goes
on with --continue.
"""
import argparse
import collections
import concurrent.futures
import dataclasses
import json
import pathlib
import queue
import random
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from mutation.build import ROOT, MutatedTree, candidates, sampled  # noqa: E402
from mutation.mutants import Mutant  # noqa: E402
from mutation.trial import programs, record, tried, untried  # noqa: E402

FOLDER = ROOT / "build" / "mutation"
RESERVE = 1.2  # of mutants, for those that do not compile


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--sample", type=int, default=300, metavar="N", help="so many mutants (default %(default)s)")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="which ones (default %(default)s)")
    parser.add_argument("--jobs", type=int, default=2, metavar="J", help="so many at a time (default %(default)s)")
    parser.add_argument("--folders", default="", metavar="F",
                        help="of these folders only, or of files that fit a pattern, such as clip,reduce/hermite_*")
    parser.add_argument("--targets", default="", help="builds and runs these only, such as math_tests,io_test")
    parser.add_argument("--tests", default="", metavar="REGEX", help="runs only the tests of ctest whose names match")
    parser.add_argument("--aim", type=float, default=0.9, metavar="SHARE",
                        help="exits with 1 where fewer are killed (default %(default)s)")
    parser.add_argument("--continue", action="store_true", dest="goes_on", help="the run before, from where it ended")
    parser.add_argument("--list", action="store_true", help="prints the sample and does nothing")
    return parser.parse_args()


def taken(options):
    """The sample, in a random order: a run that is cut off has tried mutants of everywhere."""
    generator = random.Random(options.seed)
    found = candidates(set(filter(None, options.folders.split(","))))
    if not found:
        sys.exit(f"there are no mutants in {options.folders}, wanted folders or files of src/orispline")
    chosen = sampled(found, round(RESERVE * options.sample), generator)
    print(f"{len(found)} mutants, {len(chosen)} taken", flush=True)
    generator.shuffle(chosen)
    return chosen


def save(name, data):
    partial = FOLDER / (name + ".part")
    partial.write_text(data if isinstance(data, str) else json.dumps(data), "utf-8")
    partial.replace(FOLDER / name)


def compile_all(options, saved):
    """Builds the tree, the library first: an error in a header of its own is found before the tests include it."""
    tree = MutatedTree(FOLDER, [Mutant(**m) for m in saved["mutants"]])
    if not options.goes_on:
        tree.copy()
        tree.configure()
    for targets in (tree.libraries(), options.targets.split(",") if options.targets else []):
        dropped = tree.compile(targets, options.jobs)
        saved["dropped"] += [dataclasses.asdict(m) for m in dropped]
        saved["mutants"] = [dataclasses.asdict(m) for m in tree.mutants]
        save("results.json", saved)


def recorded(options, saved):
    """The programs, each with what it reaches; those that are new are run once without a mutant."""
    known = programs(FOLDER / "build", FOLDER / "tree", options.tests)
    for program in known:
        entry = saved["programs"].get(program.name)
        if not entry:
            status = record(program, FOLDER, max(m["id"] for m in saved["mutants"]) + 1)
            print(f"{program.name}: {program.seconds:.1f} s, {len(program.reached)} mutants", flush=True)
            if status != 0:
                sys.exit(f"{program.name} fails without a mutant ({status}): {' '.join(map(str, program.command))}")
            saved["programs"][program.name] = {"seconds": program.seconds, "reached": sorted(program.reached)}
            save("results.json", saved)
        else:
            program.seconds, program.reached = entry["seconds"], set(entry["reached"])
    return known


def report(saved):
    """Per folder, and the survivors as a table."""
    folders = collections.defaultdict(collections.Counter)
    lines = ["| file | line | kind | original | mutant | |", "|---|---|---|---|---|---|"]
    for m in sorted(saved["mutants"], key=lambda m: (m["file"], m["line"])):
        status = saved["results"].get(str(m["id"]), {}).get("status")
        if not status:
            continue
        folders[m["file"].split("/")[0]][status] += 1
        if status != "killed":
            cells = (f"`{m[side]}`".replace("|", "\\|") for side in ("original", "mutated"))
            lines.append(" | ".join([f"| {m['file']}", str(m["line"]), m["kind"], *cells, f"{status} |"]))
    folders["all"] = sum(folders.values(), collections.Counter())
    table = ["| folder | mutants | killed | survived | not reached |", "|---|---|---|---|---|"]
    for folder, count in folders.items():
        table.append(f"| {folder} | {count.total()} | {count['killed']} | {count['survived']} | {count['not reached']} |")
    dropped = f"{share_killed(saved):.1%} killed; {len(saved['dropped'])} others did not compile."
    return "\n".join([*table, "", dropped, "", *lines, ""])


def share_killed(saved):
    results = [result["status"] for result in saved["results"].values()]
    return results.count("killed") / max(1, len(results))


def try_all(options, saved, known):
    """Tries what is left, and keeps each result at once."""
    folders = queue.SimpleQueue()
    for job in range(options.jobs):
        folders.put(FOLDER / f"job{job}")

    def trial(mutant):
        folder = folders.get()
        try:
            return mutant, tried(mutant, known, saved["results"].get(str(mutant.id)), folder)
        finally:
            folders.put(folder)

    def is_left(mutant):
        before = saved["results"].get(str(mutant.id))
        return not before or before["status"] != "killed" and untried(mutant, known, before)

    left = [m for m in (Mutant(**m) for m in saved["mutants"][:saved["wanted"]]) if is_left(m)]
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for done in concurrent.futures.as_completed([pool.submit(trial, mutant) for mutant in left]):
            mutant, result = done.result()
            saved["results"][str(mutant.id)] = result
            save("results.json", saved)
            save("survivors.md", report(saved))
            print(f"{len(saved['results'])}: {mutant.file}:{mutant.line}: {result['status']}, {result['seconds']} s",
                  flush=True)


def main():
    options = arguments()
    FOLDER.mkdir(parents=True, exist_ok=True)
    if options.goes_on:
        saved = json.loads((FOLDER / "results.json").read_text("utf-8"))
    else:
        chosen = taken(options)
        if options.list:
            for m in chosen:
                print(f"{m.file}:{m.line}: {m.kind}: {m.original}  ->  {m.mutated}")
            return
        saved = {"seed": options.seed, "wanted": options.sample, "dropped": [], "programs": {}, "results": {},
                 "mutants": [dataclasses.asdict(m) for m in chosen]}
    compile_all(options, saved)
    try_all(options, saved, recorded(options, saved))
    print(report(saved))
    sys.exit(share_killed(saved) < options.aim)


if __name__ == "__main__":
    main()
