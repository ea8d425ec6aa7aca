#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Clips with noise that correlates beside the best low-pass: on_clips.py COMMAND CLIP.bvh[:FIRST:COUNT]... [--seeds FIRST COUNT] [--document PAGE]

Every joint gets first-order Markov noise. `orispline smooth`, with the time of the noise stated and without, stands beside Butterworth's
filter of the fourth order, run forth and back as biomechanics does, with the one cut-off for all joints that is the best for the truth.
Errors are root mean squares over joints. With PAGE the table between the markers there is filled.
"""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[1]))
import numpy as np  # noqa: E402
from scipy.signal import butter, sosfiltfilt  # noqa: E402
from scipy.spatial.transform import Rotation  # noqa: E402

from page_block import fill_block  # noqa: E402

TIMES = (0.0, 0.02, 0.05, 0.1, 0.2)  # of the noise [s]; 0: white
SIGMAS = (0.5, 1.0, 2.0)             # [°]
CUTOFFS = np.geomspace(0.5, 50.0, 30)


class Clip:
    """The rows of a BVH file, some of them, and its rotations."""

    def __init__(self, path, first=0, count=None):
        self.head, motion = pathlib.Path(path).read_text("utf-8").split("MOTION")
        rows = motion.strip().splitlines()
        self.interval = float(rows[1].split()[-1])
        self.rows = np.array([row.split() for row in rows[2:] if row.strip()], dtype=float)[first:][:count]
        self.joints = []  # columns and order of each
        column = 0
        for match in re.finditer(r"CHANNELS (\d+)([^\r\n]*)", self.head):
            names = match[2].split()
            turns = [i for i, name in enumerate(names) if name.endswith("rotation")]
            self.joints.append(([column + i for i in turns], "".join(names[i][0] for i in turns)))
            column += int(match[1])

    def rotations(self):
        return [Rotation.from_euler(order, self.rows[:, columns], degrees=True) for columns, order in self.joints]

    def write(self, path, rotations):
        rows = self.rows.copy()
        for (columns, order), rotation in zip(self.joints, rotations):
            rows[:, columns] = rotation.as_euler(order, degrees=True)
        lines = "\n".join(" ".join(f"{value:.6f}" for value in row) for row in rows)
        path.write_text(f"{self.head}MOTION\nFrames: {len(rows)}\nFrame Time: {self.interval}\n{lines}\n", "utf-8")
        return path


def noise(rng, count, kept):
    """Of unit variance."""
    values = rng.standard_normal((count, 3))
    for i in range(1, count):
        values[i] = kept * values[i - 1] + np.sqrt(1.0 - kept * kept) * values[i]
    return values


def error(rotations, truth):
    """[°], without frames in which a marker of the clip itself is a fault."""
    squares = [((a.inv() * b).magnitude() ** 2)[sound(b)] for a, b in zip(rotations, truth)]
    return np.degrees(np.sqrt(np.mean(np.concatenate(squares))))


def sound(truth):
    """Whether every frame is within 10° of both beside it, or of the one."""
    steps = np.r_[np.inf, (truth[:-1].inv() * truth[1:]).magnitude(), np.inf]
    return np.minimum(steps[:-1], steps[1:]) < np.radians(10.0)


def filtered(rotations, cutoff, interval):
    sos = butter(2, 2.0 * cutoff * interval, output="sos")
    turned = []
    for rotation in rotations:
        q = rotation.as_quat()
        q *= np.cumprod(np.where(np.r_[1.0, np.sum(q[1:] * q[:-1], axis=1)] < 0.0, -1.0, 1.0))[:, None]
        turned.append(Rotation.from_quat(sosfiltfilt(sos, q, axis=0)))
    return turned


def smoothed_file(command, folder, path, words):
    out = folder / "out.bvh"
    done = subprocess.run([command, "smooth", path, "-o", out, *words], capture_output=True, text=True, check=False)
    if done.returncode:
        raise SystemExit(f"orispline smooth {' '.join(words)}: {done.stderr}")
    return out


def smoothed(command, folder, path, words):
    return Clip(smoothed_file(command, folder, path, words)).rotations()


def measured(command, clip, time, sigma, seed):
    """Errors of the noisy clip, of the best low-pass, and of `smooth` without the time of the noise and with it [°]."""
    rng, truth = np.random.default_rng(seed), clip.rotations()
    kept = np.exp(-clip.interval / time) if time else 0.0
    noisy = [rotation * Rotation.from_rotvec(np.radians(sigma) * noise(rng, len(rotation), kept)) for rotation in truth]
    low_pass = min(error(filtered(noisy, cutoff, clip.interval), truth) for cutoff in CUTOFFS)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        path = clip.write(folder / "noisy.bvh", noisy)
        plain = error(smoothed(command, folder, path, []), truth)
        stated = error(smoothed(command, folder, path, [f"--noise-time={time:g}"]), truth) if time else plain
    return error(noisy, truth), low_pass, plain, stated


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("clips", nargs="+")
    parser.add_argument("--seeds", type=int, nargs=2, default=(100, 3), metavar=("FIRST", "COUNT"))
    parser.add_argument("--document", type=pathlib.Path)
    chosen = parser.parse_args()
    clips = []
    for word in chosen.clips:
        path, *part = word.split(":")
        clips.append(Clip(path, *map(int, part)))
    lines = ["", "| noise | low-pass, over the input | `smooth`, over the low-pass | `--noise-time`, over the low-pass | worst, over the input |",
             "|---|---|---|---|---|"]
    for time in TIMES:
        for sigma in SIGMAS:
            cells = np.array([measured(chosen.command.resolve(), clip, time, sigma, seed)
                              for clip in clips for seed in range(chosen.seeds[0], sum(chosen.seeds))])
            given, low_pass, plain, stated = cells.T
            name = f"{sigma:g}°, " + (f"{1e3 * time:g} ms" if time else "white")
            lines.append(f"| {name} | {np.mean(low_pass / given):.2f} | {np.mean(plain / low_pass):.2f} | {np.mean(stated / low_pass):.2f} "
                         f"| {np.max(stated / given):.2f} |")
            print(lines[-1], flush=True)
    if chosen.document:
        fill_block(chosen.document, "<!-- noise of clips -->\n", "<!-- end of noise -->", [*lines, "", ""])


if __name__ == "__main__":
    main()
