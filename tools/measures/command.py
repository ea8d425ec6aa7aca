# SPDX-License-Identifier: Apache-2.0
"""What the command takes for many keys, and how long its retimed motions last."""
import csv
import json
import math
import os
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile

from page_block import fill_block

ROOT = pathlib.Path(__file__).resolve().parents[2]
END = "<!-- end of what is measured -->"

# ---------------------------------------------------------------- limits

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


def limits(options):
    """The table of time and memory per key in docs/limits.md.

    A row ends where a run is refused, or takes longer than LONGEST, or would do so if it took as long per key as the one before.
    """
    command = str(options.command)
    sizes = [size for size in SIZES if size <= options.most]
    with tempfile.TemporaryDirectory() as folder:
        for size in sizes:
            write_keys(pathlib.Path(folder) / f"keys{size}.csv", size)
        tasks = [(name, [command, *text.split()]) for name, text in TASKS]
        methods = [(f"`{name}`", [command, "sample", "{keys}", "--method", name, "--count", "2", "--quiet", "-o", "out.csv"])
                   for name in methods_of(command)]
        lines = ["", table("command", tasks, sizes, folder), table("method", methods, sizes[2:] or sizes, folder), ""]
    fill_block(ROOT / "docs/limits.md", "<!-- measured: tools/measure.py limits -->\n", END, lines)


# ---------------------------------------------------------------- durations beside those of Ruckig

ROBOT = ROOT / "examples/data/robot_keys.csv"
RATE, ACCELERATION, JERK = 90, 200, 2000  # deg/s and so on
REST = 1e-5  # rad: a smaller step is a rest
LIMITS = ["--max-rate", f"{RATE}deg/s", "--max-acceleration", f"{ACCELERATION}deg/s2", "--max-jerk", f"{JERK}deg/s3"]


def turn_by(ruckig, angle):
    """The least duration of a turn by so many radians about one axis, from rest to rest."""
    wanted = ruckig.InputParameter(1)
    wanted.target_position = [angle]
    wanted.max_velocity, wanted.max_acceleration, wanted.max_jerk = (
        [math.radians(limit)] for limit in (RATE, ACCELERATION, JERK))
    found = ruckig.Trajectory(1)
    if ruckig.Ruckig(1).calculate(wanted, found) != ruckig.Result.Working:
        sys.exit("Ruckig found no trajectory")
    return found.duration


def steps_of(path):
    """The angle and the duration of each step between keys."""
    with open(path, encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    keys = [(float(row["t"]), [float(row[name]) for name in ("qw", "qx", "qy", "qz")]) for row in rows]
    for (start, p), (end, q) in zip(keys, keys[1:]):
        near = math.dist(p, q) if math.dist(p, q) < 1 else math.dist(p, [-x for x in q])
        yield 4 * math.asin(min(near / 2, 1)), end - start


def duration_by_us(command, keys, *options):
    with tempfile.TemporaryDirectory() as folder:
        return json.loads(subprocess.run([command, "retime", keys, *LIMITS, *options, "-o", f"{folder}/out.csv", "--json"],
                                         capture_output=True, check=True).stdout)["duration_after_s"]


def retiming(options):
    """Durations within limits beside those of Ruckig, in docs/retime.md."""
    import ruckig
    command = options.command
    with tempfile.TemporaryDirectory() as folder:
        turn = pathlib.Path(folder) / "turn.csv"
        turn.write_text(f"t,qw,qx,qy,qz\n0,1,0,0,0\n1,{math.sqrt(0.5)!r},{math.sqrt(0.5)!r},0,0\n", "utf-8")
        ours = {method: duration_by_us(command, turn, "--method", method, "--ends", "rest")
                for method in ("timed-c2", "timed-c3")}
    steps = list(steps_of(ROBOT))
    stops = sum(turn_by(ruckig, angle) if angle > REST else duration for angle, duration in steps)
    rows = [("a quarter turn, rest to rest", f"{turn_by(ruckig, math.pi / 2):.2f} s",
             ", ".join(f"{duration:.2f} s with `{method}`" for method, duration in ours.items())),
            (f"the robot's {len(steps) + 1} keys", f"{stops:.1f} s, with a stop at every key",
             f"{duration_by_us(command, ROBOT):.1f} s uniformly, {duration_by_us(command, ROBOT, '--per-interval'):.1f} s "
             "with `--per-interval`, with stops at the rests only")]
    lines = [f"Within {RATE}°/s, {ACCELERATION}°/s² and {JERK}°/s³:", "", f"| motion | Ruckig {ruckig.__version__} | orispline |", "|---|---|---|"]
    lines += [f"| {' | '.join(row)} |" for row in rows]
    fill_block(ROOT / "docs/retime.md", "<!-- measured: tools/measure.py retiming -->\n", END, [*lines, ""])
