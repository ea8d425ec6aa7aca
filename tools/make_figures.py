#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Draws the figures of the documents from the output of the command itself.

  tools/make_figures.py COMMAND    COMMAND is the built orispline; writes docs/*.svg and docs/families/*.svg
"""

import sys
from pathlib import Path
from typing import NamedTuple

from figures.drawing import BLUE, DATA, GREEN, GREY, INK, PURPLE, RED, Motion, Plot, distances, document, legend, line, sampled, sphere
from figures.drawing import table, text
from figures.pages import concept_figures, page_figures
from figures.tasks import task_figures
from motions.rotations import X, norm, times, to_world, turn

DOCS = Path(__file__).resolve().parent.parent / "docs"
COLORS = [BLUE, RED, GREEN, PURPLE]


def text_of(name):
    return (DATA / name).read_text()


class Curve(NamedTuple):
    """One curve of a figure: what the legend says and what the command is told."""
    label: str
    options: list[str]
    keys: str  # the text of a key file


def curve(label, *options, method=None, keys=None):
    return Curve(label, ["--method", method or label, *options], keys or text_of("five_keys.csv"))


# ---------------------------------------------------------------- the figures of docs/families

TIMED = ("timed-c1", "timed-c2", "timed-c3", "timed-sextic")
JOINT_TIMES = Motion(text_of("five_keys.csv")).t


def with_handles(command):
    """The five keys as joints of a Bezier curve, its handles where the rates of hermite-cumulative put them."""
    motion = sampled(command, text_of("five_keys.csv"), 2, ["--method", "hermite-cumulative"])
    joints = [joint for joint in zip(motion.t, motion.q, motion.vectors("wx")) if joint[0] in JOINT_TIMES]

    def handle(q, rate, step):
        speed = norm(rate)
        return times(q, turn(tuple(x / speed for x in rate), speed * step / 3))

    rows = []
    for (t, q, leaving), (following, end, arriving) in zip(joints, joints[1:]):
        h = following - t
        rows += [(t, q), (t + h / 3, handle(q, leaving, h)), (t + 2 * h / 3, handle(end, arriving, -h))]
    return [*rows, joints[-1][:2]]


def families(command):
    """The curves of each page; the first is the grey one where there are several."""
    arcs, five = curve("slerp"), text_of("five_keys.csv").splitlines(True)
    return {
        "slerp": [arcs],
        **{name: [arcs, curve(name)] for name in ("squad", "quintic", "sextic", "xing-quartic", "xing-quintic",
                                                  "barry-goldman", "atbi", *TIMED)},
        "squad-timed": [arcs, curve("geier", method="squad-timed"),
                        curve("boyle", "--set", "variant=boyle", method="squad-timed")],
        "shoemake": [arcs, curve("in time", method="shoemake"),
                     curve("published", "--set", "timing=published", method="shoemake")],
        "tcb": [arcs, curve("tcb"), *(curve(f"{name} {value}".replace("-", "−"), "--set", f"{name}={value}", method="tcb")
                                      for name, value in (("tension", 0.5), ("continuity", -0.5), ("bias", 0.5)))],
        **{name: [arcs, *(curve(f"order {k}", "--set", f"order={k}", method=name) for k in (1, 2, 3))]
           for name in ("circular", "log-parabola")},
        "auto": [arcs, curve("auto"), curve("timed-c2")],
        "auto5": [arcs, curve("auto"), curve("auto5")],
        "timed": [arcs, *map(curve, TIMED)],
        "global-c2": [arcs, curve("global-c2"), curve("timed-c2")],
        "least": [arcs, curve("least"), curve("timed-c2")],
        "rational": [arcs, curve("rational"), curve("global-c2")],
        "biarcs": [arcs, curve("biarcs"), curve("timed-c1")],
        "monotone": [arcs, curve("monotone"), curve("timed-c1")],
        "nu-exact": [arcs, curve("ν = 0", method="nu-exact"),
                     curve("ν = 16/s at key 2", "--set", "nu=0,0,16,0,0", method="nu-exact"), curve("timed-c2")],
        "nu": [arcs, *(curve(f"ν = {x}" + "/s" * (x > 0), "--set", f"nu={x}", method="nu") for x in (0, 2, 8, 32))],
        "rotation-spline": [arcs, curve("rotation-spline"),
                            curve("with natural ends", "--ends", "natural", method="rotation-spline"), curve("timed-c2")],
        "bspline-through": [arcs, curve("bspline-through"), curve("bspline"), curve("timed-c2")],
        "uniform": [arcs, *(curve(f"order {k}", "--set", f"order={k}", method="uniform") for k in (1, 2, 3, 5))],
        **{f"hermite-c{k}": [arcs, curve(f"hermite-c{k}"), curve("3 keys", "--set", "stencil=3", method=f"hermite-c{k}"),
                             curve("cumulative", "--set", "form=cumulative", method=f"hermite-c{k}")]
           for k in (1, 2, 3)},
        "hermite": [arcs, *(curve(f"hermite-c{k}") for k in (1, 2, 3))],
        "hermite-cumulative": [arcs, *(curve(f"tension {x}", f"--tension={x}", method="hermite-cumulative")
                                       for x in (1, 0.5, 0))],
        "bezier": [arcs, curve("keys 0 to 4 with handles", method="bezier", keys=table(with_handles(command))),
                   curve("keys 0 to 3 as one polygon", method="bezier", keys="".join(five[:-1]))],
        "bspline": [arcs, *(curve(f"degree {d}", "--set", f"degree={d}", method="bspline") for d in (2, 3, 5))],
        "beta": [arcs, curve("β = (1, 0)", method="beta"), curve("β = (1, 8)", "--set", "beta2=8", method="beta")],
        "beta-through": [arcs, curve("β = (1, 0)", method="beta-through"),
                         curve("β = (1, 8)", "--set", "beta2=8", method="beta-through")],
        "beta-g2": [arcs, *(curve(form, "--set", f"form={form}", method="beta-g2") for form in ("local", "global"))],
        "averages": [arcs, *(curve(use, "--set", f"points={use}", method="averages") for use in ("through", "control"))],
    }


def drawn(command, curves, colors):
    """The motions of the curves with their colours."""
    return [(sampled(command, c.keys, 100, c.options), color) for c, color in zip(curves, colors)]


def rates_over_time(box, column, label, motions, keys):
    highest = 1.05 * max(max(max(motion.sizes(column)) for motion, _ in motions), 1.0)
    plot = Plot(box, keys.t[0], keys.t[-1], highest, label)
    plot.mark(keys.t, [f"{t:g} s" for t in keys.t])
    for motion, color in motions:
        plot.curve(motion.t, motion.sizes(column), color)
    return plot.parts


def family_figure(command, curves, handles=()):
    keys = Motion(text_of("five_keys.csv"))
    motions = drawn(command, curves, [GREY, *COLORS] if len(curves) > 1 else COLORS)
    parts = legend(50, 16, [(c.label, color) for c, (_, color) in zip(curves, motions)])
    parts += rates_over_time((50, 52, 480, 120), "wx", "angular velocity |ω| [rad/s]", motions, keys)
    parts += rates_over_time((50, 222, 480, 120), "ax", "angular acceleration |α| [rad/s²]", motions, keys)
    parts += sphere((700, 205), 145, motions, keys, X, handles)
    return document(860, 372, parts + [text(700, 44, "path of the body's x axis, keys 0 to 4")])


def beta_parameters_figure(command):
    """What β₁ and β₂ do to the curve near the five orientations, here at t = 0, 1, 2, 3, 4 s."""
    even = table([(float(k), q) for k, q in enumerate(Motion(text_of("five_keys.csv")).q)])
    keys, parts = Motion(even), []

    def with_value(symbol, parameter, value):
        return curve(f"{symbol} = {value}", "--set", f"{parameter}={value}", method="beta", keys=even)

    for left, symbol, parameter, values, rest in ((0, "β₂", "beta2", (0, 4, 32), "β₁ = 1"),
                                                  (430, "β₁", "beta1", (0.5, 1, 2), "β₂ = 0")):
        curves = [with_value(symbol, parameter, value) for value in values]
        motions = drawn(command, curves, COLORS)
        parts += legend(left + 50, 16, [(c.label, color) for c, (_, color) in zip(curves, motions)])
        parts += sphere((left + 215, 190), 145, motions, keys, X)
        parts += rates_over_time((left + 50, 382, 340, 120), "wx", f"angular velocity |ω| [rad/s] for {rest}", motions, keys)
    return document(860, 532, parts)


# ---------------------------------------------------------------- how near auto is to the truth of the flight

def auto_distance_figure(command):
    """The distance to the flight's truth: from the bundled keys, and from a key every half second."""
    truth = Motion(text_of("flight_truth.csv"))
    every_half_second = table(list(zip(truth.t, truth.q))[::50])
    colored = {"slerp": GREY, "timed-c2": RED, "auto": BLUE}
    parts = legend(50, 16, list(colored.items()))
    for top, label, keys, methods in (
            (52, "distance to the truth [degrees]: the 38 keys of the flight", text_of("flight_keys.csv"), colored),
            (252, "the same with a key every half second, without slerp", every_half_second, ("timed-c2", "auto"))):
        curves = [(distances(sampled(command, keys, 100, ["--method", method]), truth), colored[method])
                  for method in methods]
        plot = Plot((50, top, 780, 150), truth.t[0], truth.t[-1], 1.05 * max(max(c) for c, _ in curves), label)
        plot.parts += [text(plot.at(t, 0)[0], top + 166, f"{t} s") for t in range(0, 49, 8)]
        for values, color in curves:
            plot.curve(truth.t, values, color)
        parts += plot.parts
    return document(860, 432, parts)


# ---------------------------------------------------------------- the loop of docs/closed.md

SEAM = 17.0  # when the camera is back at its first key [s]


def plan_view(box, motions, keys):
    """Positions seen from above, in a world whose y points up."""
    points = [(p[0], p[2]) for motion, _ in motions for p in motion.vectors("px")]
    low, high = ([pick(point[i] for point in points) for i in (0, 1)] for pick in (min, max))
    scale = min(box[2] / (high[0] - low[0]), box[3] / (high[1] - low[1]))

    def at(p):
        return box[0] + scale * (p[0] - low[0]), box[1] + scale * (p[2] - low[1])

    parts = [line([at(p) for p in motion.vectors("px")], color, 2) for motion, color in motions]
    stops = [at(p) for p in keys.vectors("px")[:-1]]
    for k, (x, y) in enumerate(stops):
        (x0, y0), (x1, y1) = stops[k - 1], stops[(k + 1) % len(stops)]
        left = 15 / norm((x1 - x0, y1 - y0))  # of the way flown: outside the loop
        parts += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="4" fill="{INK}"/>',
                  text(x + left * (y1 - y0), y - left * (x1 - x0) + 4, str(k))]
    return parts


def closed_figure(command):
    """The camera sent back to its first key, as a loop and as a curve with two ends: half a lap on either side."""
    rows = text_of("camera_keys.csv").splitlines(True)
    first = next(row for row in rows if row[0].isdigit())
    lap = "".join(rows) + f"{SEAM}," + first.split(",", 1)[1]
    keys = Motion(lap)
    motions = [(sampled(command, lap, 50, ["--method", "timed-c2", *closed]), color)
               for closed, color in (([], GREY), (["--closed"], BLUE))]
    parts = legend(50, 16, [("timed-c2", GREY), ("timed-c2 --closed", BLUE)])
    plot = Plot((50, 52, 480, 260), -SEAM / 2, SEAM / 2, 1.05 * max(max(m.sizes("wx")) for m, _ in motions),
                "angular velocity |ω| [rad/s], before and after the seam")
    times = sorted({t - back for t in keys.t for back in (0, SEAM) if abs(t - back) <= SEAM / 2})
    plot.mark(times, ["seam" if t == 0 else "" for t in times])
    for motion, color in motions:
        plot.curve([t - SEAM for t in motion.t] + motion.t, 2 * motion.sizes("wx"), color, 2)
    parts += plot.parts + plan_view((590, 62, 220, 250), motions, keys)
    return document(860, 342, parts + [text(700, 30, "path of the camera from above, keys 0 to 11")])


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
    keys = Motion(text_of("flight_keys.csv"))
    truth = Motion(text_of("flight_truth.csv"))
    smooth, quintic, coarse = (sampled(command, text_of("flight_keys.csv"), rate, ["--method", method])
                              for method, rate in (("auto", 50), ("quintic", 50), ("auto", 12)))
    parts = flight_ribbon(coarse, keys, (40, 42, 780, 150))
    plot = Plot((50, 232, 780, 130), *SHOWN, 1.05 * max(quintic.sizes("wx")), "angular velocity |ω| [rad/s]")
    plot.mark([t for t in keys.t if SHOWN[0] <= t <= SHOWN[1]], [])
    for motion, color, width in ((truth, "#c8c8c8", 5), (quintic, RED, 1.5), (smooth, BLUE, 2)):
        plot.curve(motion.t, motion.sizes("wx"), color, width)
    plot.parts += [text(plot.at(t, 0)[0], 379, f"{t} s") for t in range(12, 35, 2)]
    parts += plot.parts + legend(420, 222, [("truth", "#a8a8a8"), ("quintic", RED), ("auto", BLUE)])
    parts.append(text(40, 24, "sparse keys (bars) become a smooth motion; orange: upside down", "start", size=13))
    return document(860, 392, parts)


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    command = str(Path(sys.argv[1]).resolve())
    handles = {"bezier": [q for t, q in with_handles(command) if t not in JOINT_TIMES]}
    figures = {f"families/{name}": family_figure(command, curves, handles.get(name, ()))
               for name, curves in families(command).items()}
    figures["families/beta-parameters"] = beta_parameters_figure(command)
    figures["families/auto-distance"] = auto_distance_figure(command)
    figures |= concept_figures(command, text_of("five_keys.csv")) | task_figures(command) | page_figures(command)
    figures["closed"] = closed_figure(command)
    figures["flight"] = flight_figure(command)
    for name, figure in figures.items():
        (DOCS / f"{name}.svg").write_text(figure)


if __name__ == "__main__":
    main()
