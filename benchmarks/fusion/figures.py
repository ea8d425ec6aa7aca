# SPDX-License-Identifier: Apache-2.0
"""Figures whose motion is known: their joints in the world, their feet while they stand, and faults of a tracker."""
import pathlib
import re
import sys

import numpy as np
from scipy.spatial.transform import Rotation

from on_clips import Clip, noise

sys.path.insert(1, str(pathlib.Path(__file__).resolve().parents[2] / "tools"))
from motions import simulated  # noqa: E402

NEAR_GROUND, SLOW, HALF_WINDOW = 0.03, 0.3, 0.1  # of a foot that stands [m], [m/s], and of its speed [s]
RESTS = 1e-6                                     # [rad]


class Figure(Clip):
    """A clip with places of its joints in the world [m]. `unit`: metres in one unit of the file."""

    def __init__(self, path, unit, first=0, count=None):
        super().__init__(path, first, count)
        self.unit = unit
        self.names, self.parents, self.offsets = [], [], []
        open_joints, is_end = [], False
        for word in re.finditer(r"(?:ROOT|JOINT)\s+(\S+)|(End Site)|OFFSET\s+(\S+)\s+(\S+)\s+(\S+)|(\})", self.head):
            if word[1]:
                self.parents.append(open_joints[-1] if open_joints else None)
                open_joints.append(len(self.names))
                self.names.append(word[1])
            elif word[2]:
                is_end = True
            elif word[3] and not is_end:
                self.offsets.append(unit * np.array([float(word[i]) for i in (3, 4, 5)]))
            elif word[6] and is_end:
                is_end = False
            elif word[6]:
                open_joints.pop()

    @property
    def place(self):
        """Of the root [m]."""
        return self.unit * self.rows[:, :3]

    def world(self, rotations, place):
        """Places of all joints at all frames [m]."""
        turns, places = [], []
        for parent, offset, rotation in zip(self.parents, self.offsets, rotations):
            matrix = rotation.as_matrix()
            if parent is None:
                turns.append(matrix)
                places.append(place)
            else:
                turns.append(turns[parent] @ matrix)
                places.append(places[parent] + turns[parent] @ offset)
        return np.array(places)

    def feet(self):
        return [i for i, name in enumerate(self.names) if "Foot" in name or "Toe" in name]

    def below(self, name):
        """A joint and all below it."""
        found = [self.names.index(name)]
        for i, parent in enumerate(self.parents):
            if parent in found:
                found.append(i)
        return found

    def write_with(self, path, rotations, place):
        before, self.rows = self.rows, np.column_stack([place / self.unit, self.rows[:, 3:]])
        self.write(path, rotations)
        self.rows = before
        return path


class SimulatedWalk(Figure):
    """The bundled walk without the noise and the faults that were put into it."""

    def __init__(self, path):
        super().__init__(path, 0.01)
        self.rows = np.array([[*simulated.place(frame), *np.ravel([simulated.turns(frame / simulated.STRIDE)[name] for name, *_ in simulated.joints()])]
                              for frame in range(simulated.FRAMES)])


def disturbed(figure, rng, time, degrees, metres):
    """Rotations and the root's place with noise whose correlation falls to 1/e within `time` [s]; 0: white. Joints that rest have none."""
    kept = np.exp(-figure.interval / time) if time else 0.0
    turned = []
    for rotation in figure.rotations():
        moves = (rotation[0].inv() * rotation).magnitude().max() > RESTS
        turned.append(rotation * Rotation.from_rotvec(np.radians(degrees) * moves * noise(rng, len(rotation), kept)))
    return turned, figure.place + metres * noise(rng, len(figure.rows), kept)


def swapped(figure, rng, rotations, count):
    """The arms taken for each other in `count` runs of 8 to 12 frames."""
    frames, part = len(figure.rows), len(figure.rows) // count
    rotations = list(rotations)
    for run in range(count):
        length = rng.integers(8, 13)
        first = run * part + rng.integers(10, part - 22)
        which = np.arange(frames)
        which[first:first + length] += frames
        pairs = list(zip(figure.below("LeftArm"), figure.below("RightArm")))
        for left, right in pairs:
            both = Rotation.concatenate([rotations[left], rotations[right]])
            rotations[left], rotations[right] = both[which], both[(which + frames) % (2 * frames)]
    return rotations


def standing(figure, world):
    """Of each foot, the frames at which it stands: near the height that 5 % of its frames are below, and slow."""
    window = round(HALF_WINDOW / figure.interval)
    masks = {}
    for foot in figure.feet():
        places = world[foot]
        last = len(places) - 1
        behind, before = np.minimum(np.arange(last + 1) + window, last), np.maximum(np.arange(last + 1) - window, 0)
        speed = np.linalg.norm(places[behind] - places[before], axis=1) / ((behind - before) * figure.interval)
        masks[foot] = (places[:, 1] - np.quantile(places[:, 1], 0.05) < NEAR_GROUND) & (speed < SLOW)
    return masks


def slide(figure, world, masks):
    """Mean speed from frame to frame of feet that stand [mm/s]."""
    speeds = [1e3 * np.linalg.norm(np.diff(world[foot], axis=0), axis=1)[mask[1:] & mask[:-1]] / figure.interval for foot, mask in masks.items()]
    return np.mean(np.concatenate(speeds))
