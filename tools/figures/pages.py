# SPDX-License-Identifier: Apache-2.0
"""The first pictures of the pages of align, bake, blending functions, BVH, frames and tune, and those of concepts, from the output of the
command."""
import json
import pathlib
import random
import subprocess
import tempfile

from figures.drawing import BLUE, DATA, GREEN, GREY, INK, RED, Motion, Plot, distances, document, legend, line, sampled, sphere, table
from figures.drawing import text, written
from figures.tasks import noisy, over_time
from motions.rotations import DEGREE, X, Y, Z, conjugate, norm, times, to_world, turn, unit
from motions.simulated import FRAMES, TRUNK, joints

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"


def tune_figure(command, five):
    """The acceleration of a curve before and after its tensions were tuned."""
    before, after = (sampled(command, keys, 200, ["--method", "timed-c2"]) for keys in (five, written(command, "tune", five, "--method", "timed-c2")))
    keys = Motion(five)
    plot = over_time((50, 52, 780, 190), "angular acceleration |α| [rad/s²]", 0, keys.t[-1], [(before.t, before.sizes("ax"), GREY, 1.6), (after.t, after.sizes("ax"), BLUE, 2)])
    plot.mark(keys.t, [])
    return document(860, 272, legend(50, 16, [("the default tensions", GREY), ("tuned", BLUE), ("times of keys", "#bbbbbb")]) + plot.parts)


def played(baked, t):
    """The orientation that a player shows at a time [s]: docs/bake.md."""
    ends, pieces = baked["ends"], baked["pieces"]
    k = next(k for k in range(len(pieces)) if t <= ends[k + 1] or k == len(pieces) - 1)
    s = 2 * (t - ends[k]) / (ends[k + 1] - ends[k]) - 1
    x, y, z, w = (sum(c * s**power for power, c in enumerate(pieces[k][6 * j:6 * j + 6])) for j in range(4))
    return unit((w, x, y, z))


def bake_figure(command, keys):
    """How far what is played of a baked curve is from the curve itself, with the ends of the pieces."""
    start, end = 12, 34
    with tempfile.TemporaryDirectory() as folder:
        source, out = pathlib.Path(folder) / "keys.csv", pathlib.Path(folder) / "motion.json"
        source.write_text(keys)
        subprocess.run([command, "bake", source, "--tolerance", "1e-4deg", "--quiet", "-o", out], check=True, stderr=subprocess.DEVNULL)
        baked = json.loads(out.read_text())
    curve = sampled(command, keys, 200, ["--from", str(start), "--to", str(end)])
    shown = Motion(table([(t, played(baked, t)) for t in curve.t]))
    off = [1e4 * x for x in distances(shown, curve)]
    plot = over_time((50, 52, 780, 120), "distance between what is played and the curve [1e-4 °]", start, end, [(curve.t, off, BLUE, 1)], 1.1)
    plot.mark([t for t in baked["ends"] if start <= t <= end], [])
    plot.curve([start, end], [1, 1], RED, 1.5)
    names = [("a baked curve of the flight", BLUE), ("tolerance", RED), ("ends of its pieces", "#bbbbbb")]
    return document(860, 200, legend(50, 16, names) + plot.parts)


# ---------------------------------------------------------------- one recording onto another

WORLD, BODY, SCALE, LATE = turn(Z, 55 * DEGREE), turn(X, 180 * DEGREE), 0.8, 0.35  # what lies between both; [s]


def estimate_of(truth):
    """The flight as another system would have recorded it: other axes, another scale and clock, noise."""
    dice, rows = random.Random(9), []
    for t, q, p in list(zip(truth.t, truth.q, truth.vectors("px")))[::5]:
        orientation = noisy(times(times(WORLD, q), BODY), 0.5 * DEGREE, dice)
        place = tuple(SCALE * x + dice.gauss(0, 2) for x in to_world(WORLD, p))
        rows.append((t + LATE, *orientation, *place))
    return "t,qw,qx,qy,qz,px,py,pz\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows)


def from_above(box, motions, low, scale):
    """Paths of positions in a plan view with one scale."""
    return [line([(box[0] + scale * (p[0] - low[0]), box[1] + box[3] - scale * (p[1] - low[1])) for p in motion.vectors("px")], color, width)
            for motion, color, width in motions]


def align_figure(command, truth_text):
    """Two recordings of the flight from above, before and after they were brought onto each other."""
    truth = Motion(truth_text)
    estimate = estimate_of(truth)
    with tempfile.TemporaryDirectory() as folder:
        paths = [pathlib.Path(folder) / name for name in ("estimate.csv", "truth.csv", "aligned.csv")]
        paths[0].write_text(estimate)
        paths[1].write_text(truth_text)
        subprocess.run([command, "align", *paths[:2], "--quiet", "-o", paths[2]], check=True, stderr=subprocess.DEVNULL)
        aligned = Motion(paths[2].read_text())
    views = [(Motion(estimate), 50, "as they were recorded"), (aligned, 450, "brought onto the truth")]
    places = [p for motion in (truth, views[0][0]) for p in motion.vectors("px")]
    low, high = ([pick(p[i] for p in places) for i in (0, 1)] for pick in (min, max))
    scale = min(360 / (high[0] - low[0]), 300 / (high[1] - low[1]))
    parts = legend(50, 16, [("truth", RED), ("estimate", BLUE)])
    for motion, left, label in views:
        parts += from_above((left, 60, 360, 300), [(truth, RED, 4), (motion, BLUE, 1.4)], low, scale)
        parts.append(text(left, 46, label, "start"))
    return document(860, 380, parts)


# ---------------------------------------------------------------- axes

SYSTEMS = [("ENU", "world of ROS"), ("NED", "world of PX4"), ("FLU", "body of ROS"), ("FRD", "body of PX4"), ("RDF", "camera of OpenCV"),
           ("RUB", "camera of OpenGL")]
ON_PAGE = {"E": (36, 14), "N": (31, -19), "R": (36, 14), "F": (31, -19), "U": (0, -45)}  # of one unit to the east or right, north or front, up [pixels]
OPPOSITE = {"W": "E", "S": "N", "L": "R", "B": "F", "D": "U"}


def towards(letter):
    if letter in ON_PAGE:
        return ON_PAGE[letter]
    x, y = ON_PAGE[OPPOSITE[letter]]
    return -x, -y


def frames_figure():
    """Where the axes of common systems point, all seen from the same side: from the south and above."""
    parts = []
    for k, (letters, who) in enumerate(SYSTEMS):
        x, y = 75 + 142 * k, 100
        for name, letter, color in zip("xyz", letters, (RED, GREEN, BLUE)):
            right, down = towards(letter)
            parts += [line([(x, y), (x + right, y + down)], color, 3), text(x + 1.35 * right, y + 1.35 * down + 4, name, "middle", color)]
        parts += [f'<circle cx="{x}" cy="{y}" r="4" fill="{INK}"/>', text(x, 24, letters, size=14), text(x, 182, who)]
    parts.append(text(430, 212, "north and front are up and to the right, away from you; east and right are down and to the right", color=GREY))
    return document(860, 226, parts)


# ---------------------------------------------------------------- the figure that walks

ENDS = [("Head_End", "Head"), *((f"{side}{name}_End", f"{side}{name}") for side in ("Left", "Right") for name in ("Hand", "Foot"))]
BONES = [(name, parent) for name, parent, _ in joints() if parent] + ENDS
FAULT = 214  # a frame in which markers of the right knee were swapped


def places(command, path):
    """The positions of all joints in the world at each frame [cm]."""
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([command, "sample", path, "--space", "world", "--rate", "120", "--quiet", "--output-folder", folder], check=True)
        return {file.stem: Motion(file.read_text()).vectors("px") for file in pathlib.Path(folder).rglob("*.csv")}


def walker(joint_places, frame, left, ground, color=None):
    """The figure from its left side at a frame, its hips at `left`."""
    at = {name: positions[frame] for name, positions in joint_places.items()}
    hips = at[TRUNK[0][0]][2]

    def seen(name):
        return left + 1.25 * (at[name][2] - hips), ground - 1.25 * at[name][1]

    return [line([seen(a), seen(b)], color or (BLUE if a.startswith("Left") else RED if a.startswith("Right") else INK), 2) for a, b in BONES]


def bvh_figure(command, path):
    """The walk from the side, with its false frame; below, the turn of the right knee before and after smooth."""
    with tempfile.TemporaryDirectory() as folder:
        clean = pathlib.Path(folder) / "clean.bvh"
        subprocess.run([command, "smooth", path, "--quiet", "-o", clean], check=True, stderr=subprocess.DEVNULL)
        recorded, smoothed = places(command, path), places(command, clean)
        knees = [Motion(subprocess.run([command, "sample", file, "--joint", "RightLeg", "--rate", "120", "--quiet", "-o", "-"], check=True, capture_output=True, text=True).stdout)
                 for file in (path, clean)]
    parts = legend(50, 16, [("as recorded", GREY), ("smoothed: left side", BLUE), ("right side", RED)])
    start, end, top = 1.2, (FRAMES - 1) / 120, 40
    shown = [FAULT + 16 * k for k in range(-4, 4)]
    for frame in shown:
        left = 50 + 780 * (frame / 120 - start) / (end - start)
        parts += [*walker(recorded, frame, left, top + 220, GREY), *walker(smoothed, frame, left, top + 220)]
    plot = Plot((50, top + 260, 780, 120), start, end, 75, "turn of the right knee [°]")
    for motion, color, width in zip(knees, (GREY, RED), (3, 1.6)):
        turned = [2 * norm(q[1:]) / DEGREE for q in motion.q]
        plot.curve(motion.t, turned, color, width)
    plot.parts += [text(plot.at(t / 10, 0)[0], top + 396, f"{t / 10:g} s") for t in range(12, 25, 2)]
    return document(860, top + 410, parts + plot.parts)


# ---------------------------------------------------------------- blending functions of one's own

def blending_figure(command, five, page):
    """The curve of the functions that the page types in beside that of auto."""
    typed = page.split("<<'J'\n", 1)[1].split("\nJ\n", 1)[0]
    with tempfile.TemporaryDirectory() as folder:
        mine = pathlib.Path(folder) / "mine.json"
        mine.write_text(typed)
        curve = sampled(command, five, 200, ["--blending", str(mine), "--method", "mine"])
    auto, keys = sampled(command, five, 200, ["--method", "auto"]), Motion(five)
    plot = over_time((50, 52, 480, 190), "angular velocity |ω| [rad/s]", 0, keys.t[-1], [(auto.t, auto.sizes("wx"), GREY, 1.6), (curve.t, curve.sizes("wx"), BLUE, 2)])
    plot.mark(keys.t, [])
    parts = legend(50, 16, [("mine", BLUE), ("auto", GREY), ("times of keys", "#bbbbbb")]) + plot.parts
    return document(860, 280, parts + sphere((700, 140), 120, [(auto, GREY), (curve, BLUE)], keys, X))


def page_figures(command):
    """The figures by their names in docs, which are those of their pages."""
    five, flight, truth = ((DATA / name).read_text() for name in ("five_keys.csv", "flight_keys.csv", "flight_truth.csv"))
    page = (DOCS / "own-blending.md").read_text("utf-8")
    return {"align": align_figure(command, truth), "bake": bake_figure(command, flight), "bvh": bvh_figure(command, str(DATA / "walking.bvh")),
            "frames": frames_figure(), "own-blending": blending_figure(command, five, page), "tune": tune_figure(command, five)}


# ---------------------------------------------------------------- concepts: turns of body and world, ways between two orientations, what C0, C1 and C2 are

STEPS = 240  # drawn for one turn
START = times(turn(Z, -25 * DEGREE), turn(Y, 30 * DEGREE))  # nose down, to the left of the viewer, who so sees its z axis too


class Path:
    """Orientations at even times from 0 to 1, as sphere() takes motions and keys."""

    def __init__(self, q):
        self.q = q

    @classmethod
    def of(cls, at):
        return cls([at(k / STEPS) for k in range(STEPS + 1)])

    def speeds(self):
        """Angular speed between neighbours, and the times in the middle of them; small angles are twice the vector part."""
        steps = [times(conjugate(p), q) for p, q in zip(self.q, self.q[1:])]
        return [(k + 0.5) / STEPS for k in range(STEPS)], [2 * norm(step[1:]) * STEPS for step in steps]


def body_and_world_figure():
    """The same turn by 100° about z: of the world as a factor on the left, of the body as one on the right."""
    ways = [("about the world's z: step · q", RED, lambda u: times(turn(Z, 100 * DEGREE * u), START)),
            ("about the body's z: q · step", BLUE, lambda u: times(START, turn(Z, 100 * DEGREE * u)))]
    motions = [(Path.of(at), color) for _, color, at in ways]
    parts = sphere((200, 200), 150, motions, Path([START]), X)
    parts += sphere((560, 200), 150, motions, Path([START]), Z)
    parts += [text(200, 376, "path of the body's x axis"), text(560, 376, "path of the body's z axis")]
    return document(760, 392, legend(40, 20, [(name, color) for name, color, _ in ways]) + parts)


def headed(heading, pitch, roll):
    """The orientation of three angles [degrees], turned about z, then the new y, then the new x."""
    return times(times(turn(Z, heading * DEGREE), turn(Y, -pitch * DEGREE)), turn(X, roll * DEGREE))


def between_figure(command):
    """Between two orientations by angles, by components, and by one turn."""
    ends = (-60.0, 0.0, -100.0), (90.0, 40.0, 120.0)
    first, last = (headed(*angles) for angles in ends)
    if sum(a * b for a, b in zip(first, last)) < 0:
        last = tuple(-x for x in last)
    keys = "t,qw,qx,qy,qz\n" + "".join(",".join(map(repr, (t, *q))) + "\n" for t, q in ((0.0, first), (1.0, last)))
    ways = [("angles one by one", RED, Path.of(lambda u: headed(*(a + u * (b - a) for a, b in zip(*ends))))),
            ("components, then normalised", GREEN, Path.of(lambda u: unit(tuple(a + u * (b - a) for a, b in zip(first, last))))),
            ("slerp", BLUE, Path(sampled(command, keys, STEPS, ["--method", "slerp"]).q))]
    speeds = [(way.speeds(), color) for _, color, way in ways]
    plot = Plot((440, 70, 390, 250), 0.0, 1.0, 1.05 * max(max(values) for (_, values), _ in speeds), "angular velocity |ω| [rad/s]")
    plot.mark([0.0, 1.0], ["0 s", "1 s"])
    for (t, values), color in speeds:
        plot.curve(t, values, color, 2)
    parts = sphere((190, 205), 150, [(way, color) for _, color, way in ways], Path([first, last]), X)
    parts.append(text(190, 376, "path of the body's x axis"))
    return document(860, 392, legend(40, 20, [(name, color) for name, color, _ in ways]) + parts + plot.parts)


def five_keys_figure(command, text_of_keys, curves):
    """Methods on the five keys: the path on the sphere, beside it |ω| and |α| over time; (label, options) each."""
    keys = Motion(text_of_keys)
    colored = [(sampled(command, text_of_keys, 100, options), color) for (_, options), color in zip(curves, (RED, GREEN, BLUE))]
    parts = legend(50, 16, [(label, color) for (label, _), color in zip(curves, (RED, GREEN, BLUE))])
    for top, column, label in ((52, "wx", "angular velocity |ω| [rad/s]"), (222, "ax", "angular acceleration |α| [rad/s²]")):
        plot = Plot((50, top, 480, 120), keys.t[0], keys.t[-1], 1.05 * max(max(motion.sizes(column)) for motion, _ in colored), label)
        plot.mark(keys.t, [f"{t:g} s" for t in keys.t])
        for motion, color in colored:
            plot.curve(motion.t, motion.sizes(column), color)
        parts += plot.parts
    parts += sphere((700, 205), 145, colored, keys, X)
    return document(860, 372, parts + [text(700, 44, "path of the body's x axis, keys 0 to 4")])


def concept_figures(command, text_of_keys):
    """The figures by their names in docs."""
    smooth = [("slerp, C⁰", ["--method", "slerp"]), ("timed-c1, C¹", ["--method", "timed-c1"]), ("timed-c2, C²", ["--method", "timed-c2"])]
    tense = [(f"tension {value}", ["--method", "timed-c2", f"--tension={value}"]) for value in (0, 0.5, 1)]
    return {"concepts-body": body_and_world_figure(), "concepts-between": between_figure(command),
            "concepts-smooth": five_keys_figure(command, text_of_keys, smooth), "concepts-tension": five_keys_figure(command, text_of_keys, tense)}
