# SPDX-License-Identifier: Apache-2.0
"""The figure of docs/skeletons.md: an arm before and after `reduce`, its keys, and how far the tip of its hand is off in the world."""
import math
import pathlib
import subprocess
import tempfile

from rotations import DEGREE, norm
from sampled_motion import Motion
from svg_drawing import BLUE, GREY, INK, RED, Plot, document, legend, text

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
