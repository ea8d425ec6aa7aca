# SPDX-License-Identifier: Apache-2.0
"""Lines, words and plots over time as SVG."""

import math

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
