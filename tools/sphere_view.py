# SPDX-License-Identifier: Apache-2.0
"""Paths on the unit sphere as seen from one side."""

import math

from rotations import cross, norm, to_world, unit
from svg_drawing import INK, line, text

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
