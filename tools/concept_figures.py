# SPDX-License-Identifier: Apache-2.0
"""The figures of docs/concepts.md: turns of body and world, three ways between two orientations, what C0, C1 and C2 are, and what tension does."""
from rotations import DEGREE, X, Y, Z, conjugate, norm, times, turn, unit
from sampled_motion import Motion, sampled
from sphere_view import sphere
from svg_drawing import BLUE, GREEN, RED, Plot, document, legend, text

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
