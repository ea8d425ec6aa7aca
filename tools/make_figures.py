#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of the documents from the output of the command itself.

  tools/make_figures.py COMMAND    COMMAND is the built orispline; writes docs/flight.svg and docs/families/*.svg
"""

import math
import subprocess
import sys
from pathlib import Path

from rotations import cross, norm, to_world, unit

ROOT = Path(__file__).resolve().parent.parent
DATA, DOCS = ROOT / "examples" / "data", ROOT / "docs"
GREY, BLUE, RED, GREEN, PURPLE, INK = "#9a9a9a", "#0072b2", "#d55e00", "#009e73", "#b0579a", "#333333"
FAMILIES = {"slerp": ["slerp"], "squad": ["slerp", "squad", "squad-timed"], "quintic": ["slerp", "quintic"],
            "sextic": ["slerp", "sextic"], "timed": ["slerp", "timed-c1", "timed-c2", "timed-c3", "timed-sextic"]}


class Motion:
    """The columns of a file of samples."""

    def __init__(self, text):
        lines = [line for line in text.splitlines() if not line.startswith("#")]
        self.names = lines[0].split(",")
        self.rows = [[float(x) for x in line.split(",")] for line in lines[1:]]
        self.t = self.column("t")
        self.q = self.vectors("qw", 4)

    def column(self, name):
        i = self.names.index(name)
        return [row[i] for row in self.rows]

    def vectors(self, name, size=3):
        i = self.names.index(name)
        return [tuple(row[i:i + size]) for row in self.rows]

    def sizes(self, name):
        return [norm(v) for v in self.vectors(name)]


def sampled(command, keys, method, rate):
    call = [command, "sample", str(DATA / keys), "--method", method, "--rate", str(rate)]
    return Motion(subprocess.run(call, check=True, capture_output=True, text=True).stdout)


# ---------------------------------------------------------------- drawing


def line(points, color, width=1.5, extra=""):
    path = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    return f'<polyline points="{path}" fill="none" stroke="{color}" stroke-width="{width}" {extra}/>'


def text(x, y, words, anchor="middle", color=INK, size=12):
    return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}" font-size="{size}">{words}</text>'


def document(width, height, parts):
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" width="{width}" height="{height}" '
            'font-family="sans-serif" stroke-linejoin="round">\n'
            f'<rect width="{width}" height="{height}" fill="white"/>\n' + "\n".join(parts) + "\n</svg>\n")


def round_step(span):
    """A step of 1, 2 or 5 times a power of ten that cuts the span into 3 to 7 parts."""
    power = 10.0 ** math.floor(math.log10(span / 3))
    return next(k * power for k in (5, 2, 1) if span / (k * power) >= 3)


class Plot:
    """Curves over time in a box: left, top, width, height in pixels."""

    def __init__(self, box, start, end, highest, label):
        self.box, self.start, self.end, self.highest = box, start, end, highest
        left, top, width, height = box
        self.parts = [text(left, top - 7, label, "start")]
        step = round_step(highest)
        for k in range(int(highest / step + 1e-9) + 1):
            y = self.at(start, k * step)[1]
            self.parts += [line([(left, y), (left + width, y)], "#e4e4e4", 1),
                           text(left - 6, y + 4, f"{k * step:g}", "end")]

    def at(self, t, value):
        left, top, width, height = self.box
        return left + width * (t - self.start) / (self.end - self.start), top + height * (1 - value / self.highest)

    def mark(self, times, labels):
        _, top, _, height = self.box
        for k, t in enumerate(times):
            x = self.at(t, 0)[0]
            self.parts.append(line([(x, top), (x, top + height)], "#bbbbbb", 1, 'stroke-dasharray="3 3"'))
            if labels:
                self.parts.append(text(x, top + height + 16, labels[k]))

    def curve(self, times, values, color, width=1.6):
        points = [self.at(t, v) for t, v in zip(times, values) if self.start <= t <= self.end]
        self.parts.append(line(points, color, width))


def legend(x, y, entries):
    parts = []
    for name, color in entries:
        parts += [line([(x, y), (x + 22, y)], color, 3), text(x + 28, y + 4, name, "start", color)]
        x += 50 + 7.2 * len(name)
    return parts


# ---------------------------------------------------------------- one figure per page of docs/families

EYE = unit((1.0, 0.12, 0.22))  # the direction from which the sphere is seen
RIGHT = unit(cross((0.0, 0.0, 1.0), EYE))
UP = cross(EYE, RIGHT)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def visible_runs(points):
    """The pieces of a path on the unit sphere that face the viewer."""
    runs = [[]]
    for v in points:
        if dot(v, EYE) >= 0:
            runs[-1].append(v)
        elif runs[-1]:
            runs.append([])
    return [run for run in runs if len(run) > 1]


def graticule():
    def point(longitude, latitude):
        c = math.cos(math.radians(latitude))
        return (c * math.cos(math.radians(longitude)), c * math.sin(math.radians(longitude)),
                math.sin(math.radians(latitude)))

    parallels = [[point(a, b) for a in range(-180, 181, 4)] for b in (-60, -30, 0, 30, 60)]
    return parallels + [[point(a, b) for b in range(-90, 91, 4)] for a in range(0, 360, 30)]


def sphere(center, radius, motions, keys, axis):
    """Paths of a body axis on the unit sphere; the far side is not drawn."""
    def at(v):
        return center[0] + radius * dot(v, RIGHT), center[1] - radius * dot(v, UP)

    def drawn(points, color, width):
        return [line([at(v) for v in run], color, width) for run in visible_runs(points)]

    parts = [f'<circle cx="{center[0]}" cy="{center[1]}" r="{radius}" fill="#f7f9fb" stroke="#bbbbbb"/>']
    for circle in graticule():
        parts += drawn(circle, "#dde3e8", 1)
    for motion, color in motions:
        parts += drawn([to_world(q, axis) for q in motion.q], color, 2)
    for k, q in enumerate(keys.q):
        x, y = at(to_world(q, axis))
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{INK}"/>', text(x, y - 8, str(k))]
    return parts


def family_figure(command, methods):
    keys = Motion((DATA / "five_keys.csv").read_text())
    colors = [GREY, BLUE, RED, GREEN, PURPLE] if len(methods) > 1 else [BLUE]
    motions = [(sampled(command, "five_keys.csv", method, 100), color) for method, color in zip(methods, colors)]
    parts = legend(50, 16, zip(methods, colors))
    for top, column, label in ((52, "wx", "angular velocity |ω| [rad/s]"),
                               (222, "ax", "angular acceleration |α| [rad/s²]")):
        highest = 1.05 * max(max(max(motion.sizes(column)) for motion, _ in motions), 1.0)
        plot = Plot((50, top, 480, 120), keys.t[0], keys.t[-1], highest, label)
        plot.mark(keys.t, [f"{t:g} s" for t in keys.t])
        for motion, color in motions:
            plot.curve(motion.t, motion.sizes(column), color)
        parts += plot.parts
    parts += sphere((700, 205), 145, motions, keys, (1.0, 0.0, 0.0))
    return document(860, 372, parts + [text(700, 44, "path of the body's x axis, keys 0 to 4")])


# ---------------------------------------------------------------- the flight of the first page

SHOWN = (12.0, 34.0)  # loop, roll and the turn that follows [s]


def within(motion, vectors):
    return [(q, v) for t, q, v in zip(motion.t, motion.q, vectors) if SHOWN[0] <= t <= SHOWN[1]]


def wing(q, p, half_span):
    """Both wing tips in the picture [m]: seen from the right of the way flown, behind and above."""
    tip = to_world(q, (0.0, half_span, 0.0))

    def seen(x, y, z):
        along, across = 0.62 * x + 0.78 * y, 0.62 * y - 0.78 * x
        return along - 0.35 * across, -(0.9 * z + 0.55 * across)

    return [seen(*(a + sign * b for a, b in zip(p, tip))) for sign in (1, -1)]


def flight_ribbon(motion, keys, box):
    """The trace of the wings, with a bar at every key."""
    poses = within(motion, motion.vectors("px"))
    bars = [wing(q, p, 18.0) for q, p in poses]
    low, high = ([pick(point[i] for bar in bars for point in bar) for i in (0, 1)] for pick in (min, max))
    scale = min(box[2] / (high[0] - low[0]), box[3] / (high[1] - low[1]))

    def fit(bar):
        return [(box[0] + scale * (x - low[0]), box[1] + scale * (y - low[1])) for x, y in bar]

    parts = []
    for (q, _), bar, following in zip(poses, bars, bars[1:]):
        color = "#8ec1e3" if to_world(q, (0.0, 0.0, 1.0))[2] >= 0 else "#f2b38a"
        corners = " ".join(f"{x:.1f},{y:.1f}" for x, y in fit([*bar, *following[::-1]]))
        parts.append(f'<polygon points="{corners}" fill="{color}" stroke="white" stroke-width="0.4" opacity="0.8"/>')
    return parts + [line(fit(wing(q, p, 24.0)), INK, 2.2) for q, p in within(keys, keys.vectors("px"))]


def flight_figure(command):
    keys = Motion((DATA / "flight_keys.csv").read_text())
    truth = Motion((DATA / "flight_truth.csv").read_text())
    timed, quintic, coarse = (sampled(command, "flight_keys.csv", method, rate)
                              for method, rate in (("timed-c2", 50), ("quintic", 50), ("timed-c2", 12)))
    parts = flight_ribbon(coarse, keys, (40, 42, 780, 150))
    plot = Plot((50, 232, 780, 130), *SHOWN, 1.05 * max(quintic.sizes("wx")), "angular velocity |ω| [rad/s]")
    plot.mark([t for t in keys.t if SHOWN[0] <= t <= SHOWN[1]], [])
    for motion, color, width in ((truth, "#c8c8c8", 5), (quintic, RED, 1.5), (timed, BLUE, 2)):
        plot.curve(motion.t, motion.sizes("wx"), color, width)
    plot.parts += [text(plot.at(t, 0)[0], 379, f"{t} s") for t in range(12, 35, 2)]
    parts += plot.parts + legend(420, 222, [("truth", "#a8a8a8"), ("quintic", RED), ("timed-c2", BLUE)])
    parts.append(text(40, 24, "sparse keys (bars) become a smooth motion; orange: upside down", "start", size=13))
    return document(860, 392, parts)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    command = str(Path(sys.argv[1]).resolve())
    for name, methods in FAMILIES.items():
        (DOCS / "families" / f"{name}.svg").write_text(family_figure(command, methods))
    (DOCS / "flight.svg").write_text(flight_figure(command))


if __name__ == "__main__":
    main()
