# SPDX-License-Identifier: Apache-2.0
"""The figures of the pages of tasks, from the output of the command: smooth, reduce, retime, compare, online, mean, gyro, skeletons and the
band of `measured`."""
import json
import math
import pathlib
import random
import subprocess
import tempfile

from figures.drawing import BLUE, DATA, EYE, GREEN, GREY, INK, RED, RIGHT, UP, Motion, Plot, distances, document, dot, legend, sampled
from figures.drawing import sphere, table, text, written
from motions.rotations import DEGREE, X, conjugate, norm, times, to_world, turn, unit

DEGREES_PER_S = "angular velocity |ω| [°/s]"


def noisy(q, noise, dice):
    """With that deviation on each axis of the body [rad]."""
    error = tuple(dice.gauss(0.0, noise) for _ in range(3))
    return times(q, turn(unit(error), norm(error)))


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
    rows = table([(t, noisy(q, 0.3 * DEGREE, dice)) for t, q in zip(truth.t, truth.q)][::5])
    raw = sampled(command, rows, 100, ["--method", "slerp"])
    smoothed = Motion(written(command, "smooth", rows, "--rate", "100"))
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


# ---------------------------------------------------------------- the band of measured

SHARE = 0.9


def band_figure(command, truth):
    """The distance of a curve to the truth, and its band."""
    dice = random.Random(1)
    rows = list(zip(truth.t, truth.q))
    parts = legend(50, 16, [("auto", RED), ("measured", BLUE), (f"its {100 * SHARE:.0f} % band", GREY)])
    for top, label, keys in (
            (52, "distance to the truth [degrees]: a key of the flight every second", rows[::100]),
            (252, "the same with a key every tenth of a second, and 1° of noise on each axis", [(t, noisy(q, DEGREE, dice)) for t, q in rows[::10]])):
        measured = sampled(command, table(keys), 100, ["--method", "measured", "--band", str(SHARE)])
        band = [radius / DEGREE for radius in measured.column("band")]
        curves = [(band, GREY), (distances(sampled(command, table(keys), 100, ["--method", "auto"]), truth), RED),
                  (distances(measured, truth), BLUE)]
        plot = Plot((50, top, 780, 150), truth.t[0], truth.t[-1], 1.05 * max(max(c) for c, _ in curves), label)
        plot.parts += [text(plot.at(t, 0)[0], top + 166, f"{t} s") for t in range(0, 49, 8)]
        for values, color in curves:
            plot.curve(truth.t[:len(values)], values, color)
        parts += plot.parts
    return document(860, 432, parts)


# ---------------------------------------------------------------- a gyro with a clock of its own

POSE_NOISE, GYRO_NOISE, BIAS, LATE = 1.0 * DEGREE, 0.3 * DEGREE, 0.5 * DEGREE, 6  # [rad], [rad/s], [rad/s], rows of 10 ms
EVERY, MISSING = 5, (20.0, 23.0)  # rows between orientations; where there are none [s]


def recorded(truth, dice):
    """The rows of poses, and those of the gyro."""
    poses, rates = ["t,qw,qx,qy,qz"], ["t,wx,wy,wz"]
    for k, (t, q, rate) in enumerate(zip(truth.t, truth.q, truth.vectors("wx"))):
        pose = noisy(q, POSE_NOISE, dice)
        if k % EVERY == 0:
            poses.append(",".join(map(repr, (t, *pose))))
        rates.append(",".join(map(repr, (t + 0.01 * LATE, *(x + BIAS + dice.gauss(0.0, GYRO_NOISE) for x in rate)))))
    return poses, rates


def smoothed(command, poses, rates):
    """At the times of the truth."""
    with tempfile.TemporaryDirectory() as folder:
        place = pathlib.Path(folder)
        (place / "poses.csv").write_text("\n".join(poses) + "\n")
        (place / "gyro.csv").write_text("\n".join(rates or []) + "\n")
        call = [command, "smooth", place / "poses.csv", "--quiet", "--rate", "100", "-o", place / "out.csv"]
        subprocess.run([*call, *(["--gyro-file", place / "gyro.csv"] if rates else [])], check=True, stderr=subprocess.DEVNULL)
        return Motion((place / "out.csv").read_text())


def gyro_figure(command, truth):
    """How far smoothed orientations are from the truth, with a gyro whose clock is late and without it."""
    poses, rates = recorded(truth, random.Random(2))
    gap = [row for row in poses if not (row[0].isdigit() and MISSING[0] <= float(row.split(",")[0]) <= MISSING[1])]
    parts = legend(50, 16, [("without the gyro", RED), ("with it", BLUE)])
    for top, label, rows in ((52, "distance to the truth [degrees]: orientations at 20 Hz with 1° of noise, a gyro at 100 Hz that is 60 ms late", poses),
                             (252, "the same without orientations from 20 s to 23 s", gap)):
        curves = [(distances(smoothed(command, rows, used), truth), color) for used, color in ((None, RED), (rates, BLUE))]
        highest = 1.05 * min(12.0, max(max(values) for values, _ in curves))
        plot = Plot((50, top, 780, 150), truth.t[0], truth.t[-1], highest, label)
        plot.parts += [text(plot.at(t, 0)[0], top + 166, f"{t} s") for t in range(0, 49, 8)]
        for values, color in curves:
            plot.curve(truth.t[:len(values)], [min(value, highest) for value in values], color)
        parts += plot.parts
    return document(860, 432, parts)


# ---------------------------------------------------------------- means of good and bad rows

TRUTH = times(turn((0.0, 0.0, 1.0), 12 * DEGREE), turn((0.0, 1.0, 0.0), -14 * DEGREE))
BAD = times(TRUTH, turn(unit((0.2, 0.5, 1.0)), 60 * DEGREE))  # where bad rows agree to be
KINDS = (("mean", RED), ("median", BLUE))
ROWS, ROW_NOISE, BAD_SHARES = 100, 2 * DEGREE, range(0, 61, 2)


class Rows:
    """Quaternions as sphere() takes keys."""

    def __init__(self, q):
        self.q = q


def middle(command, rows, kind):
    table = "qw,qx,qy,qz\n" + "".join(",".join(map(repr, q)) + "\n" for q in rows)
    call = [command, "mean", "-", "--input-format", "csv", "--kind", kind, "--json"]
    found = json.loads(subprocess.run(call, input=table, check=True, capture_output=True, text=True).stdout)
    return tuple(found[name] for name in ("qw", "qx", "qy", "qz"))


def angle(p, q):
    return 2 * math.asin(min(1.0, norm(times(conjugate(p), q)[1:]))) / DEGREE


def rows_on_the_sphere(command, center, radius):
    dice, axis = random.Random(5), X
    rows = [noisy(TRUTH, 5 * DEGREE, dice) for _ in range(5)] + [noisy(BAD, 8 * DEGREE, dice) for _ in range(4)]
    parts = sphere(center, radius, [], Rows(rows), axis)
    for kind, color in KINDS:
        v = to_world(middle(command, rows, kind), axis)
        assert dot(v, EYE) > 0
        x, y = center[0] + radius * dot(v, RIGHT), center[1] - radius * dot(v, UP)
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="6" fill="none" stroke="{color}" stroke-width="3"/>')
    return parts


def mean_figure(command):
    """Good and bad rows with their mean and their median, and how far both go astray the more rows are bad."""
    parts = rows_on_the_sphere(command, (190, 210), 160)
    parts.append(text(190, 392, "x axis of the body: five good rows, four bad ones", color=INK))
    plot = Plot((440, 60, 390, 290), 0, BAD_SHARES[-1], 65, "distance to the truth [degrees]")
    for kind, color in KINDS:
        dice, values = random.Random(7), []
        for bad in BAD_SHARES:
            rows = [noisy(TRUTH if k >= bad else BAD, ROW_NOISE, dice) for k in range(ROWS)]
            values.append(angle(TRUTH, middle(command, rows, kind)))
        plot.curve(list(BAD_SHARES), values, color, 2)
    plot.parts += [text(plot.at(share, 0)[0], 368, f"{share} %") for share in range(0, 61, 10)]
    plot.parts.append(text(635, 392, "bad rows, all of them alike", color=INK))
    return document(860, 410, parts + plot.parts + legend(440, 20, list(KINDS)))


# ---------------------------------------------------------------- an arm before and after reduce

RATE, SECONDS, LENGTH = 60, 4, 0.002  # frames per second; [s]; [m]
JOINTS = ("Shoulder", "Elbow", "Hand")
HIERARCHY = """HIERARCHY
ROOT Shoulder
{{
  OFFSET 0 0 0
  {channels}
  JOINT Elbow
  {{
    OFFSET 0.3 0 0
    {channels}
    JOINT Hand
    {{
      OFFSET 0.25 0 0
      {channels}
      End Site
      {{
        OFFSET 0.1 0 0
      }}
    }}
  }}
}}
"""


def angles_at(t):
    """Z, Y, X of each joint [degrees]: a wave with a stop."""
    wave, stop = math.sin(2 * math.pi * t), 1 / (1 + math.exp(-12 * (2.4 - t)))
    return (20 * math.sin(1.3 * t) + 15 * stop * wave, 10 * math.cos(0.9 * t), 8 * wave * stop,
            55 + 35 * stop * math.sin(2 * math.pi * t + 0.8), 12 * math.sin(3.1 * t), 0.0,
            25 * stop * math.sin(4 * math.pi * t), 10 * math.sin(2 * math.pi * t), 15 * math.cos(1.7 * t))


def recording():
    frames = [" ".join(f"{angle:.6f}" for angle in angles_at(k / RATE)) for k in range(RATE * SECONDS + 1)]
    head = HIERARCHY.format(channels="CHANNELS 3 Zrotation Yrotation Xrotation")
    return f"{head}MOTION\nFrames: {len(frames)}\nFrame Time: {1 / RATE:.9f}\n" + "\n".join(frames) + "\n"


class Arm:
    """The arm in a file."""

    def __init__(self, command, path):
        self.command, self.path = command, path

    def motion(self, *options):
        call = [self.command, *options, str(self.path), "-o", "-", "--quiet"]
        return Motion(subprocess.run(call, check=True, capture_output=True, text=True).stdout)

    def reduced(self, name, *options):
        path = self.path.with_name(name)
        subprocess.run([self.command, "reduce", str(self.path), *options, "-o", str(path), "--quiet"], check=True)
        return Arm(self.command, path)

    def tip(self):
        return self.motion("sample", "--joint", "Hand_End", "--space", "world", "--rate", "240", "--include-end")

    def turned(self, joint):
        """How far from its first orientation, over time [degrees]."""
        motion = self.motion("sample", "--joint", joint, "--rate", "240", "--include-end")
        first = motion.q[0]
        return motion.t, [2 * math.acos(min(1.0, abs(sum(a * b for a, b in zip(q, first))))) / DEGREE for q in motion.q]

    def keys(self, joint):
        return self.motion("convert", "--joint", joint).t


def marks(plot, times, values, keys, color):
    """A dot at each key, on the curve."""
    for t in keys:
        k = min(range(len(times)), key=lambda i: abs(times[i] - t))
        x, y = plot.at(t, values[k])
        plot.parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{color}"/>')


def skeleton_figure(command):
    """The arm, its keys, and how far the tip of its hand is off in the world."""
    with tempfile.TemporaryDirectory() as folder:
        before = Arm(command, pathlib.Path(folder) / "arm.bvh")
        before.path.write_text(recording())
        after = before.reduced("arm.glb", "--world-tolerance", f"{LENGTH}m", "--position-scale", "1")
        parts = legend(50, 16, [(f"the recording: {RATE * SECONDS + 1} keys a joint", GREY), ("after reduce, with its keys", BLUE)])
        top = 52
        for joint in JOINTS:
            times, values = before.turned(joint)
            plot = Plot((50, top, 780, 90), 0, SECONDS, 1.08 * max(values), f"{joint}: turn from its first frame [degrees]")
            plot.curve(times, values, GREY, 4)
            reduced_times, reduced = after.turned(joint)
            plot.curve(reduced_times, reduced, BLUE)
            marks(plot, reduced_times, reduced, after.keys(joint), BLUE)
            parts += plot.parts + [text(830, top - 7, f"{len(after.keys(joint))} keys", "end", BLUE)]
            top += 130
        one, other = before.tip(), after.tip()
        off = [1000 * norm([a - b for a, b in zip(p, q)]) for p, q in zip(one.vectors("px"), other.vectors("px"))]
        plot = Plot((50, top, 780, 90), 0, SECONDS, 1.1 * 1000 * LENGTH, "the tip of the hand in the world: distance between the two [mm]")
        plot.curve(one.t, off, RED)
        plot.parts += [text(plot.at(t, 0)[0], top + 106, f"{t} s", color=INK) for t in range(SECONDS + 1)]
        return document(860, top + 124, parts + plot.parts)


def task_figures(command):
    """The figures by their names in docs."""
    truth, robot, five = (DATA / name for name in ("flight_truth.csv", "robot_keys.csv", "five_keys.csv"))
    flight = Motion(truth.read_text())
    return {"smooth": smooth_figure(command, flight), "reduce": reduce_figure(command, flight), "retime": retime_figure(command, robot.read_text()),
            "compare": compare_figure(command, flight), "online": online_figure(command, five.read_text()), "mean": mean_figure(command),
            "skeletons": skeleton_figure(command), "families/measured": band_figure(command, flight), "gyro": gyro_figure(command, flight)}
