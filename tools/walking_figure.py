# SPDX-License-Identifier: Apache-2.0
"""A walking figure as motion capture records it: two strides of sums of sines, with the noise of markers and two faults.

World: y up, the figure walks along z, its left is along x. Lengths are centimetres. The rest pose stands upright with hanging arms.
"""

import random

from rotations import PI, cosine, sine

FRAMES, FRAME_TIME = 289, "0.00833333"  # 120 a second
STRIDE = 144                            # frames from one step of the left heel to its next
SPEED = 113.0                           # along z [cm/s]
ANGLE_NOISE, PLACE_NOISE = 0.25, 0.05   # standard deviations [degrees], [cm]: half a millimetre of markers 12 cm apart

# joint, parent, offset in the frame of the parent [cm]; the x of a limb is turned for the right side
TRUNK = [("Hips", None, (0, 0, 0)), ("Spine", "Hips", (0, 10, -1)), ("Chest", "Spine", (0, 18, 0)), ("Head", "Chest", (0, 26, 2))]
LIMBS = [("Chest", [("Arm", (18, 20, 0)), ("ForeArm", (0, -29, 0)), ("Hand", (0, -25, 0))]),
         ("Hips", [("UpLeg", (9, -4, 0)), ("Leg", (0, -43, 0)), ("Foot", (0, -41, 0))])]
ENDS = {"Head": (0, 18, 0), "Hand": (0, -17, 0), "Foot": (0, -6, 18)}  # by the end of the name

# frames of the faults: what is added to the joint's turns about z, x and y [degrees]
FAULTS = {("LeftForeArm", 101): (0, 0, 155),                              # the two markers of the wrist swapped
          ("RightLeg", 214): (24, -31, 8), ("RightLeg", 215): (21, -35, 11)}  # a marker taken for another


def joints():
    """(name, parent, offset), each joint before those below it and these before the next one beside it."""
    rows = list(TRUNK)
    for root, limb in LIMBS:
        for side, sign in (("Left", 1), ("Right", -1)):
            parent = root
            for name, (x, y, z) in limb:
                rows.append((side + name, parent, (sign * x, y, z)))
                parent = side + name
    return rows


def wave(phase, *terms):
    """A sum of cosines: (harmonic, size, the part of a stride at which it is largest) each."""
    return sum(size * cosine(2 * PI * harmonic * (phase - at)) for harmonic, size, at in terms)


def leg(phase):
    """Flexion of hip and knee and rise of the toes [degrees]; at phase 0 the heel touches the ground. Fitted to feet that do not slip."""
    return (8.5 + wave(phase, (1, 22.8, 0.92), (2, 4.8, 0.28)), 27.4 + wave(phase, (1, 27.3, 0.73), (2, 11.9, 0.22)),
            4.7 + wave(phase, (1, 5.7, 0.31), (2, 9.6, 0.41), (3, 2.7, 0.2)))


def turns(phase):
    """Turns of each joint about z, x and y [degrees]; about x a positive one swings what hangs down backwards."""
    angles = {"Hips": (wave(phase, (1, 4, 0.12)), wave(phase, (2, 1, 0.1)), wave(phase, (1, 5, 0.5))),
              "Spine": (wave(phase, (1, 3, 0.62)), 3 + wave(phase, (2, 1, 0.3)), wave(phase, (1, 4, 0.0))),
              "Chest": (wave(phase, (1, 2, 0.6)), wave(phase, (2, 1, 0.4)), wave(phase, (1, 6, 0.02))),
              "Head": (wave(phase, (1, 1.5, 0.15)), -4 + wave(phase, (2, 1.5, 0.05)), wave(phase, (1, 4, 0.5)))}
    for side, sign, at in (("Left", 1, phase), ("Right", -1, phase - 0.5)):
        hip, knee, toes = leg(at)
        swing = wave(at, (1, 24, 0.5), (2, 2, 0.3))  # forwards with the other leg
        angles |= {side + "UpLeg": (sign * (1 + wave(at, (1, 4, 0.65))), -hip, sign * wave(at, (1, 4, 0.3))),
                   side + "Leg": (0, knee, 0), side + "Foot": (sign * wave(at, (1, 2, 0.4)), -toes, sign * 5),
                   side + "Arm": (sign * (8 + wave(at, (2, 1.5, 0.1))), 4 - swing, sign * wave(at, (1, 8, 0.55))),
                   side + "ForeArm": (0, -28 - wave(at, (1, 13, 0.52)), sign * (12 + wave(at, (1, 5, 0.4)))),
                   side + "Hand": (sign * wave(at, (1, 4, 0.6)), -5 + wave(at, (1, 6, 0.58)), 0)}
    return angles


def place(frame):
    """Of the hips [cm]."""
    phase = frame / STRIDE
    return (wave(phase, (1, 2.4, 0.3)), 92.4 + wave(phase, (2, 1.5, 0.22)), SPEED * frame / 120 + wave(phase, (2, 0.6, 0.1)))


def noise(dice):
    """Of mean 0 and deviation 1, nearly normal, without a logarithm that machines compute with other bits."""
    return sum(dice.random() for _ in range(12)) - 6


def numbers_of(frame, dice):
    measured = [x + PLACE_NOISE * noise(dice) for x in place(frame)]
    angles = turns(frame / STRIDE)
    for name, *_ in joints():
        added = FAULTS.get((name, frame), (0, 0, 0))
        measured += [angle + ANGLE_NOISE * noise(dice) + fault for angle, fault in zip(angles[name], added)]
    return measured


def hierarchy(name, parent, offset):
    """The lines of a joint and of those below it."""
    kind, places = ("JOINT", "3") if parent else ("ROOT", "6 Xposition Yposition Zposition")
    inner = [f"OFFSET {' '.join(map(str, offset))}", f"CHANNELS {places} Zrotation Xrotation Yrotation"]
    lines = [f"{kind} {name}", "{", *("  " + line for line in inner)]
    for below in joints():
        if below[1] == name:
            lines += ["  " + line for line in hierarchy(*below)]
    for end, (x, y, z) in ENDS.items():
        if name.endswith(end):
            lines += ["  End Site", "  {", f"    OFFSET {x} {y} {z}", "  }"]
    return [*lines, "}"]


def recording():
    """The text of the file."""
    dice = random.Random(20180817)
    frames = [" ".join(f"{number:.4f}" for number in numbers_of(frame, dice)) for frame in range(FRAMES)]
    return "\n".join(["HIERARCHY", *hierarchy(*TRUNK[0]), "MOTION", f"Frames: {FRAMES}", f"Frame Time: {FRAME_TIME}", *frames]) + "\n"
