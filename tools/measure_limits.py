#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The table of time and memory per key in docs/limits.md, measured.

measure_limits.py COMMAND [MOST] runs COMMAND, the built orispline, on up to MOST keys (10^7) and rewrites the lines between
`<!-- measured: tools/measure_limits.py -->` and `<!-- end of what is measured -->`. A row ends where a run is refused, or takes
longer than LONGEST, or would do so if it took as long per key as the one before.
"""
import json
import math
import os
import pathlib
import random
import re
import resource
import signal
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).resolve().parents[1] / "docs/limits.md"
BLOCK = re.compile(r"(<!-- measured: tools/measure_limits.py -->\n).*?(<!-- end of what is measured -->)", re.S)
SIZES = (10**3, 10**4, 10**5, 10**6, 10**7)
LONGEST = 120  # [s] of processor time
SEED = 7

TASKS = (("inspect", "inspect {keys}"), ("convert", "convert {keys} --quiet -o out.csv"),
         ("sample, streaming", "sample {keys} --rate 100 --quiet -o out.csv"),
         ("sample --count", "sample {keys} --count 1000 --quiet -o out.csv"),
         ("plot", "plot {keys} -o out.svg"), ("smooth", "smooth {keys} --quiet -o out.csv"),
         ("reduce, auto", "reduce {keys} --tolerance 0.5deg --method auto --quiet -o out.csv"),
         ("reduce, slerp", "reduce {keys} --tolerance 0.5deg --method slerp --quiet -o out.csv"),
         ("tune", "tune {keys} --method timed-c2 --quiet -o out.csv"),
         ("retime", "retime {keys} --method timed-c2 --max-rate 90deg/s --quiet -o out.csv"),
         ("compare, five methods", "compare {keys} --keep-every 8 --methods auto,slerp,quintic,timed-c2,hermite-c1"))


def write_keys(path, count):
    """A body that turns about a slowly moving axis, with noise of 0.1°, at 100 Hz."""
    dice = random.Random(SEED)
    with open(path, "w", encoding="utf-8") as out:
        out.write("t,qw,qx,qy,qz\n")
        for k in range(count):
            t = 0.01 * k
            x, y, z = (math.sin(0.7 * t) + dice.gauss(0, 1e-3), math.sin(0.31 * t + 1) + dice.gauss(0, 1e-3), 0.3 + dice.gauss(0, 1e-3))
            norm = math.sqrt(1 + x * x + y * y + z * z)
            out.write(f"{t:.2f},{1 / norm:.17g},{x / norm:.17g},{y / norm:.17g},{z / norm:.17g}\n")


def run(arguments, folder):
    """(processor time [s], largest memory [bytes]) of a run; None where it is refused or takes too long."""
    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST))

    process = subprocess.Popen(arguments, cwd=folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, preexec_fn=limited)
    said = process.stderr.read().decode("utf-8", "replace")
    _, status, used = os.wait4(process.pid, 0)
    if status != 0:
        late = os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGKILL, signal.SIGXCPU)
        print(f"  {' '.join(map(str, arguments[1:]))}: {'too long' if late else said.strip()}", file=sys.stderr)
        return None
    return used.ru_utime + used.ru_stime, used.ru_maxrss * 1024


def methods_of(command):
    listed = json.loads(subprocess.run([command, "methods", "--json"], check=True, capture_output=True).stdout)
    return [method["name"] for method in listed]


def measured(arguments, sizes, folder):
    """size -> (time, memory), as far as it goes."""
    found = {}
    for size in sizes:
        if found and found[max(found)][0] * size / max(found) > LONGEST:
            break
        result = run([part.format(keys=f"keys{size}.csv") for part in arguments], folder)
        if result is None:
            break
        found[size] = result
    return found


def row(name, found, sizes):
    cells = [f"{1e6 * found[size][0] / size:.3g}" if size in found else "–" for size in sizes]
    last = max(found, default=0)
    before = last // 10
    room = f"{(found[last][1] - found[before][1]) / (last - before):.0f}" if before in found else "–"
    return f"| {name} | " + " | ".join([*cells, room]) + " |\n"


def table(title, runs, sizes, folder):
    head = [title, *(f"10^{round(math.log10(size))} keys [µs]" for size in sizes), "memory per key [bytes]"]
    text = "| " + " | ".join(head) + " |\n" + "|---" * len(head) + "|\n"
    for name, arguments in runs:
        print(name, file=sys.stderr)
        text += row(name, measured(arguments, sizes, folder), sizes)
    return text


def main(command, most=SIZES[-1]):
    command = str(pathlib.Path(command).resolve())
    sizes = [size for size in SIZES if size <= int(most)]
    with tempfile.TemporaryDirectory() as folder:
        for size in sizes:
            write_keys(pathlib.Path(folder) / f"keys{size}.csv", size)
        tasks = [(name, [command, *text.split()]) for name, text in TASKS]
        methods = [(f"`{name}`", [command, "sample", "{keys}", "--method", name, "--count", "2", "--quiet", "-o", "out.csv"])
                   for name in methods_of(command)]
        text = "\n" + table("command", tasks, sizes, folder) + "\n" + table("method", methods, sizes[2:] or sizes, folder) + "\n"
    PAGE.write_text(BLOCK.sub(lambda found: found[1] + text + found[2], PAGE.read_text("utf-8")), "utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
