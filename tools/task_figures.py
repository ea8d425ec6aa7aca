# SPDX-License-Identifier: Apache-2.0
"""The figures of the pages of tasks, from the output of the command: smooth, reduce, retime, compare and online."""
import pathlib
import random
import subprocess
import tempfile

from band_figure import distances
from rotations import DEGREE, X, norm, times, turn, unit
from sampled_motion import Motion, sampled
from sphere_view import sphere
from svg_drawing import BLUE, GREEN, GREY, RED, Plot, document, legend, text

DATA = pathlib.Path(__file__).resolve().parents[1] / "examples/data"
DEGREES_PER_S = "angular velocity |ω| [°/s]"


def table(rows):
    return "t,qw,qx,qy,qz\n" + "".join(",".join(map(repr, (t, *q))) + "\n" for t, q in rows)


def written(command, task, keys, *options):
    """The file that a task of the command writes for the text of a file of keys."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = pathlib.Path(folder) / "keys.csv", pathlib.Path(folder) / "out.csv"
        source.write_text(keys)
        subprocess.run([command, task, source, "--quiet", "-o", out, *options], check=True, stderr=subprocess.DEVNULL)
        return out.read_text()


def degrees(values):
    return [value / DEGREE for value in values]


def over_time(box, label, start, end, curves, highest=None):
    """Values over time with marks at even seconds: (times, values, colour, width) each."""
    highest = highest or 1.05 * max(max(values) for _, values, _, _ in curves)
    plot = Plot(box, start, end, highest, label)
    step = next(step for step in (1, 2, 4, 8) if (end - start) / step <= 10)
    plot.parts += [text(plot.at(start + k * step, 0)[0], box[1] + box[3] + 16, f"{start + k * step:g} s") for k in range(int((end - start) / step) + 1)]
    for t, values, color, width in curves:
        plot.curve(t, [min(value, highest) for value in values], color, width)
    return plot


def smooth_figure(command, truth):
    """The rate of the flight with noise, as it is and smoothed."""
    dice = random.Random(4)
    errors = [tuple(dice.gauss(0.0, 0.3 * DEGREE) for _ in range(3)) for _ in truth.q]
    noisy = table([(t, times(q, turn(unit(e), norm(e)))) for t, q, e in list(zip(truth.t, truth.q, errors))[::5]])
    raw = sampled(command, noisy, 100, ["--method", "slerp"])
    smoothed = Motion(written(command, "smooth", noisy, "--rate", "100"))
    curves = [(motion.t, degrees(motion.sizes("wx")), color, width) for motion, color, width in ((raw, "#cccccc", 1), (truth, RED, 3), (smoothed, BLUE, 1.5))]
    plot = over_time((50, 52, 780, 230), DEGREES_PER_S, 12, 34, curves, 220)
    names = [("the noisy samples joined by arcs", "#999999"), ("truth", RED), ("smoothed", BLUE)]
    return document(860, 312, legend(50, 16, names) + plot.parts)


def reduce_figure(command, truth):
    """The keys that are left of the flight, on its path, and how far the curve through them is from every sample."""
    kept = written(command, "reduce", table(zip(truth.t, truth.q)), "--tolerance", "0.5deg", "--method", "auto")
    keys = Motion(kept)
    error = distances(sampled(command, kept, 100, ["--method", "auto"]), truth)
    plot = over_time((50, 52, 780, 120), "distance to each of the 4801 samples [°]", 0, 48, [(truth.t, error, BLUE, 1)], 0.55)
    plot.mark(keys.t, [])
    plot.curve([0, 48], [0.5, 0.5], RED, 1.5)
    return document(860, 200, legend(50, 16, [(f"the curve through the {len(keys.t)} keys that are kept", BLUE), ("tolerance", RED), ("times of keys", "#bbbbbb")]) + plot.parts)


def retime_figure(command, robot):
    """The robot's rate before and after, with its limit."""
    limits = ["--max-rate", "60deg/s", "--max-acceleration", "200deg/s2"]
    before = sampled(command, robot, 25, [])
    after = [(Motion(subprocess.run([command, "sample", "-", "--input-format", "csv", "--rate", "25"], input=written(command, "retime", robot, *limits, *more), check=True,
                                    capture_output=True, text=True).stdout), color) for more, color in (([], GREEN), (["--per-interval"], BLUE))]
    end = max(motion.t[-1] for motion, _ in after)
    curves = [(motion.t, degrees(motion.sizes("wx")), color, 1.6) for motion, color in ((before, GREY), *after)]
    plot = over_time((50, 52, 780, 190), DEGREES_PER_S, 0, end, curves)
    plot.curve([0, end], [60, 60], RED, 1)
    return document(860, 272, legend(50, 16, [("before", GREY), ("all slowed by one factor", GREEN), ("--per-interval", BLUE), ("limit", RED)]) + plot.parts)


def compare_figure(command, truth):
    """How far three methods are from the flight, of which every 80th sample is a key."""
    keys = table(list(zip(truth.t, truth.q))[::80])
    colored = [("slerp", GREY), ("timed-c2", GREEN), ("auto", BLUE)]
    curves = [(truth.t[::5], distances(sampled(command, keys, 100, ["--method", method]), truth)[::5], color, 1.5) for method, color in colored]
    plot = over_time((50, 52, 780, 190), "distance to the recording [°]", 0, 48, curves)
    return document(860, 272, legend(50, 16, colored) + plot.parts)


def online_figure(command, five):
    """What is known of a curve after each of three keys: final segments do not change, and wait for one key more."""
    rows = [row for row in five.splitlines(True) if not row.startswith("#")]
    parts = []
    for place, count in enumerate((3, 4, 5)):
        keys = Motion("".join(rows[:count + 1]))
        known = sampled(command, "".join(rows), 100, ["--method", "timed-c2"])
        final = keys.t[-2]
        known.q = [q for t, q in zip(known.t, known.q) if t <= final]
        center = (145 + 285 * place, 190)
        parts += sphere(center, 130, [(known, BLUE)], keys, X)
        parts.append(text(center[0], 44, f"key {count - 1} has come: final to key {count - 2}"))
    return document(860, 340, parts)


def task_figures(command):
    """The figures by their names in docs."""
    truth, robot, five = (DATA / name for name in ("flight_truth.csv", "robot_keys.csv", "five_keys.csv"))
    flight = Motion(truth.read_text())
    return {"smooth": smooth_figure(command, flight), "reduce": reduce_figure(command, flight), "retime": retime_figure(command, robot.read_text()),
            "compare": compare_figure(command, flight), "online": online_figure(command, five.read_text())}
