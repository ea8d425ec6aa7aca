# SPDX-License-Identifier: Apache-2.0
"""`orispline smooth` on a recording."""
import json
import subprocess

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from recordings import DEGREE

POSE, RATE = "qx,qy,qz,qw", "wx,wy,wz"


def written(path, header, *columns):
    np.savetxt(path, np.column_stack(columns), fmt="%.9f", delimiter=",", header=header, comments="")
    return path


def read(path):
    """Times, orientations and, where there are any, standard deviations along the axes of the body."""
    with open(path, encoding="utf-8") as file:
        names = next(line for line in file if not line.startswith("#")).strip().split(",")
        table = dict(zip(names, np.loadtxt(file, delimiter=",", ndmin=2).T))
    sigmas = np.column_stack([table[name] for name in ("sigma_x", "sigma_y", "sigma_z")]) if "sigma_x" in table else None
    return table["t"], Rotation.from_quat(np.column_stack([table[name] for name in POSE.split(",")])), sigmas


class Smoothed:
    """What came out, beside the truth: `error` [°] of all keys, `said` over the true error of the orientations, and `held`, the share of
    components that lie within 1.645 of their standard deviations."""

    def __init__(self, command, folder, recording, *words):
        out = folder / "keys.csv"
        done = subprocess.run([command, "smooth", *words, "-o", out, "--json", "--sigma"], capture_output=True, text=True, check=False)
        if done.returncode:
            raise SystemExit(f"orispline smooth {' '.join(map(str, words))}: {done.stderr}")
        self.document = json.loads(done.stdout)
        times, orientations, sigmas = read(out)
        inside = (times >= recording.times[0]) & (times <= recording.times[-1])
        off = (Slerp(recording.times, recording.truth)(times[inside]).inv() * orientations[inside]).as_rotvec()
        squares = (off**2).sum(1)
        at = np.isin(np.round(times[inside] * 1e6), np.round(recording.times[recording.at] * 1e6))
        self.error = np.sqrt(squares.mean()) / DEGREE
        self.error_at_poses = np.sqrt(squares[at].mean()) / DEGREE
        self.held = (np.abs(off) < 1.645 * sigmas[inside]).mean()
        self.used = bool(self.document.get("gyro_used"))
        expected = self.document["error_with_gyro_rad" if self.used else "error_without_gyro_rad"]
        self.said = expected / DEGREE / self.error_at_poses if expected else None


def poses(folder, recording):
    return written(folder / "poses.csv", "t," + POSE, recording.times[recording.at], recording.poses.as_quat())


def with_gyro(command, folder, recording):
    if recording.own_clock:
        rates = written(folder / "gyro.csv", "t," + RATE, recording.gyro_times, recording.gyro)
        return Smoothed(command, folder, recording, poses(folder, recording), "--gyro-file", rates)
    rows = written(folder / "rows.csv", f"t,{POSE},{RATE}", recording.times, recording.poses.as_quat(), recording.gyro)
    return Smoothed(command, folder, recording, rows, "--gyro")


def without_gyro(command, folder, recording):
    return Smoothed(command, folder, recording, poses(folder, recording))
