# SPDX-License-Identifier: Apache-2.0
"""Recordings and simulated motion thinned to keys, and the curves through these beside what was left out."""
import importlib
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy
from motions.noisy_recordings import RECORDINGS, recording
from page_block import fill_block
from scipy.spatial.transform import Rotation, RotationSpline

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "families" / "measured.md"
SEED, MOST = 20260805, 3000
JOINTS = ("Head", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightLeg", "RightFoot", "LeftArm", "LeftForeArm", "RightForeArm",
          "RightHand")
STEPS = {"PX4": (4, 8, 16), "BROAD": (4, 8, 16), "MRO": (4, 8, 16), "fr2": (4, 8, 16), "joint": (4, 8, 16),
         "simulated": (8, 16, 32)}
PATTERNS = ("every", "jittered", "random")
SHARE = 0.9


def of_recording(name, data):
    motion = recording(name, data)
    return numpy.array(motion.times), numpy.array(motion.orientations)


def of_tum(data):
    rows = numpy.loadtxt(data / "trajectory" / "tum_fr2_desk_groundtruth.txt")
    rows = rows[numpy.r_[True, numpy.diff(rows[:, 0]) > 0]][:MOST]
    return rows[:, 0] - rows[0, 0], rows[:, [7, 4, 5, 6]]


def of_joints(data):
    """Name -> local orientations of joints of a BVH file, whose channels are rotations about Z, Y, X [deg]."""
    lines = (data / "mocap" / "cmu_01_01_fairmotion.bvh").read_text().split("\n")
    column, joint, found = 0, "", {}
    for number, line in enumerate(lines):
        words = line.split()
        if words[:1] in (["ROOT"], ["JOINT"]):
            joint = words[1]
        if words[:1] == ["CHANNELS"]:
            found[joint] = column + int(words[1]) - 3
            column += int(words[1])
        if words[:2] == ["Frame", "Time:"]:
            frames = numpy.array([list(map(float, row.split())) for row in lines[number + 1:] if row.strip()])[:MOST]
            break
    times = numpy.arange(len(frames)) / 120.0
    return {name: (times, Rotation.from_euler("ZYX", frames[:, found[name]:found[name] + 3], degrees=True)
                   .as_quat()[:, [3, 0, 1, 2]]) for name in JOINTS}


def simulated():
    """Free bodies, which tumble: Euler's equations by small steps of Runge and Kutta."""
    found = {}
    for name, inertia, rate in (("tumble", (1.0, 2.0, 3.5), (0.6, 1.1, 0.3)), ("flip", (1.0, 2.0, 3.0), (0.01, 2.0, 0.01)),
                                ("spin", (1.0, 1.05, 2.0), (0.2, 0.1, 1.5))):
        j, h = numpy.array(inertia), 0.01
        state = numpy.r_[1.0, 0, 0, 0, rate]

        def change(s, j=j):
            w, x, y, z = s[:4]
            a, b, c = s[4:]
            spin = 0.5 * numpy.array([-x * a - y * b - z * c, w * a + y * c - z * b, w * b + z * a - x * c, w * c + x * b - y * a])
            return numpy.r_[spin, numpy.cross(j * s[4:], s[4:]) / j]
        rows = []
        for _ in range(2000):
            rows.append(state[:4])
            for _ in range(2):
                k1 = change(state)
                k2 = change(state + h / 4 * k1)
                k3 = change(state + h / 4 * k2)
                state = state + h / 12 * (k1 + 2 * k2 + 2 * k3 + change(state + h / 2 * k3))
            state[:4] /= numpy.linalg.norm(state[:4])
        found[name] = (h * numpy.arange(len(rows)), numpy.array(rows))
    return found


def aligned(q):
    q = q / numpy.linalg.norm(q, axis=1)[:, None]
    return q * numpy.cumprod(numpy.r_[1.0, numpy.where(numpy.sum(q[1:] * q[:-1], 1) < 0, -1.0, 1.0)])[:, None]


def kept(count, step, pattern, rng):
    if pattern == "every":
        return numpy.arange(0, count, step)
    if pattern == "jittered":
        base = numpy.arange(0, count, step)
        at = base + numpy.round(rng.uniform(-0.35, 0.35, len(base)) * step).astype(int)
        return numpy.unique(numpy.clip(at, 0, count - 1))
    at = numpy.cumsum(numpy.r_[0, rng.choice([max(step // 4, 1), max(step // 2, 1), step, 2 * step], count)])
    return at[at < count]


def angles(a, b):
    return 2 * numpy.arctan2(numpy.linalg.norm(numpy.cross(a[:, 1:], b[:, 1:]) + a[:, :1] * b[:, 1:] - b[:, :1] * a[:, 1:], axis=1),
                             numpy.abs(numpy.sum(a * b, 1)))


def sampled(command, folder, method, *options):
    out = folder / "out.npy"
    subprocess.run([command, "sample", folder / "keys.csv", "--method", method, "--times", folder / "times.txt", "--derivatives",
                    "0", "--quiet", "-o", out, *options], check=True)
    return numpy.load(out)[:, 1:]


def measured_case(command, folder, t, q, at, reference):
    """The RMS distances by method, the share inside the band, the largest distance to the reference's curve."""
    keys = aligned(q[at])
    dense = numpy.setdiff1d(numpy.arange(at[0], at[-1] + 1), at)
    (folder / "keys.csv").write_text("t,qw,qx,qy,qz\n" + "".join(
        ",".join(repr(float(x)) for x in (s, *k)) + "\n" for s, k in zip(t[at], keys)))
    (folder / "times.txt").write_text("".join(f"{float(s)!r}\n" for s in t[dense]))
    rms = {}
    for method in ("auto", "slerp", "measured"):
        rows = sampled(command, folder, method, *(["--band", str(SHARE)] if method == "measured" else []))
        off = angles(rows[:, :4], q[dense])
        rms[method] = math.sqrt(numpy.mean(off**2))
        if method == "measured":
            inside, curve = numpy.mean(off <= rows[:, 4]), rows[:, :4]
    spline = RotationSpline(t[at], Rotation.from_quat(keys[:, [1, 2, 3, 0]]))(t[dense]).as_quat()[:, [3, 0, 1, 2]]
    rms["rotation-spline"] = math.sqrt(numpy.mean(angles(spline, q[dense])**2))
    return rms, inside, angles(curve, reference.evaluate(keys, t[at], t[dense])).max()


def cases(data):
    tracks = {name: of_recording(name, data) for name in RECORDINGS} | {"fr2": of_tum(data)}
    for group, members in ((None, tracks), ("joint", of_joints(data)), ("simulated", simulated())):
        for name, (t, q) in members.items():
            q = q / numpy.linalg.norm(q, axis=1)[:, None]
            for step in STEPS[group or name]:
                for pattern in PATTERNS:
                    rng = numpy.random.default_rng([SEED, step, PATTERNS.index(pattern), *name.encode()])
                    yield group or "recording", name, step, pattern, t, q, kept(len(t), step, pattern, rng)


def mean(ratios):
    return math.exp(numpy.mean(numpy.log(ratios)))


def line(label, results):
    """A row of the table."""
    cells = [label, str(len(results))]
    for method in ("slerp", "auto", "measured"):
        ratios = [r[method] / r["rotation-spline"] for r, *_ in results]
        cells.append(f"{mean(ratios):.3g}, {max(ratios):.3g}")
    for method in ("auto", "measured"):
        cells.append(str(sum(r[method] > 1.03 * min(r["slerp"], r["rotation-spline"]) for r, *_ in results)))
    inside = [share for _, share, _ in results]
    cells.append(f"{100 * numpy.mean(inside):.1f} %, {100 * min(inside):.0f} %")
    return "| " + " | ".join(cells) + " |"


def fidelity(options):
    """The table of docs/families/measured.md anew.

    Says of each case the RMS distances over that of RotationSpline, the share inside the 90 % band and how far the curve is from the
    reference's.
    """
    sys.path.insert(0, str(options.reference))
    sys.modules["auto"] = importlib.import_module("auto_reference")
    reference = importlib.import_module("measured_reference")
    results = {}
    with tempfile.TemporaryDirectory() as folder:
        for group, name, step, pattern, t, q, at in cases(options.data):
            result = measured_case(options.command, pathlib.Path(folder), t, q, at, reference)
            results.setdefault(group, {})[name, step, pattern] = result
            rms, inside, off = result
            print(f"{name:14} {step:3} {pattern:9} {len(at):4} keys " + " ".join(
                f"{m} {rms[m] / rms['rotation-spline']:.4f}" for m in ("slerp", "auto", "measured")),
                f"inside {inside:.3f} reference {off:.1e}", flush=True)
    real = [*results["recording"].values(), *results["joint"].values()]
    over = sum(r["measured"] > 1.10 * r["rotation-spline"] for r, *_ in real)
    print(f"{over} of {len(real)} above 1.10; largest distance to the reference "
          f"{max(off for group in results.values() for *_, off in group.values()):.1e} rad")
    lines = ["", "| keys from | cases | `slerp` | `auto` | `measured` | misses of `auto` | of `measured` | inside the 90 % band |",
             "|---|---|---|---|---|---|---|---|",
             *(line(label, list(results[group].values())) for label, group in (
                 ("PX4, BROAD, MRO, TUM fr2", "recording"), ("ten joints of a walk", "joint"), ("simulated", "simulated"))), ""]
    fill_block(PAGE, "<!-- measured by tools/measure.py fidelity: begin -->\n", "\n<!-- measured by tools/measure.py fidelity: end -->", lines)
