# SPDX-License-Identifier: Apache-2.0
"""What figures are made of: motions as the command writes them; lines, words and plots over time as SVG, and paths on the unit sphere as
seen from one side."""
import math
import pathlib
import subprocess
import tempfile

from motions.rotations import DEGREE, conjugate, cross, norm, times, to_world, unit

DATA = pathlib.Path(__file__).resolve().parents[2] / "examples/data"


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


def sampled(command, keys, rate, options):
    """The motion that the command makes of the text of a key file."""
    call = [command, "sample", "-", "--input-format", "csv", "--rate", str(rate), *options]
    return Motion(subprocess.run(call, input=keys, check=True, capture_output=True, text=True).stdout)


def table(rows):
    return "t,qw,qx,qy,qz\n" + "".join(",".join(map(repr, (t, *q))) + "\n" for t, q in rows)


def written(command, task, keys, *options):
    """The file that a task of the command writes for the text of a file of keys."""
    with tempfile.TemporaryDirectory() as folder:
        source, out = pathlib.Path(folder) / "keys.csv", pathlib.Path(folder) / "out.csv"
        source.write_text(keys)
        subprocess.run([command, task, source, "--quiet", "-o", out, *options], check=True, stderr=subprocess.DEVNULL)
        return out.read_text()


def distances(motion, truth):
    """Angles between two motions sampled at the same times [degrees]."""
    return [2 * math.asin(min(1.0, norm(times(conjugate(p), q)[1:]))) / DEGREE for p, q in zip(motion.q, truth.q)]


# ---------------------------------------------------------------- lines, words and plots

GREY, BLUE, RED, GREEN, PURPLE, INK = "#9a9a9a", "#0072b2", "#d55e00", "#009e73", "#b0579a", "#333333"


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


# ---------------------------------------------------------------- the sphere

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


def sphere(center, radius, motions, keys, axis, handles=()):
    """Paths of a body axis on the unit sphere with numbered keys and nameless handles; the far side is not drawn."""
    def at(v):
        return center[0] + radius * dot(v, RIGHT), center[1] - radius * dot(v, UP)

    def drawn(points, color, width):
        return [line([at(v) for v in run], color, width) for run in visible_runs(points)]

    def beside(x, y):
        """Where the number of a key at x, y goes: outwards near the rim, else away from the middle's height."""
        right, down = (x - center[0]) / radius, (y - center[1]) / radius
        if norm((right, down)) < 0.85:
            right, down = 0, (1 if down > 0.1 else -1)
        return x + 12 * right, y + 12 * down + 4

    parts = [f'<circle cx="{center[0]}" cy="{center[1]}" r="{radius}" fill="#f7f9fb" stroke="#bbbbbb"/>']
    for circle in graticule():
        parts += drawn(circle, "#dde3e8", 1)
    for motion, color in motions:
        parts += drawn([to_world(q, axis) for q in motion.q], color, 2)
    for q in handles:
        x, y = at(to_world(q, axis))
        parts.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="white" stroke="{INK}"/>')
    for k, q in enumerate(keys.q):
        x, y = at(to_world(q, axis))
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{INK}"/>', text(*beside(x, y), str(k))]
    return parts
