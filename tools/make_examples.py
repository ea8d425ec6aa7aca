#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the example data in examples/data: keyframes of a simulated flight with its dense truth, of a robot and of a camera,
the five keys of the figures, and the motion capture of a walking figure.

  tools/make_examples.py           writes the files
  tools/make_examples.py --check   makes them again in memory and compares them byte for byte

Every machine writes the same bytes: see rotations.py.
"""

import sys
from pathlib import Path

from motions.rotations import DEGREE, X, Y, Z, cross, ease, times, turn, unit
from motions.simulated import chosen_keys, fly, recording

DATA = Path(__file__).resolve().parent.parent / "examples" / "data"

# ---------------------------------------------------------------- the robot and the camera

# rest [s], then slew [s] about a body axis by an angle [deg] to a position [m]
ROBOT_MOVES = [(1.2, 1.6, (0, 0, 1), 90, (0.62, 0.35, 0.48)), (0.4, 0.9, (1, 0, 0), -55, (0.62, 0.35, 0.22)),
               (2.3, 1.1, (0, 1, 0), 40, (0.45, 0.52, 0.30)), (0.7, 2.4, (1, 1, 0), 135, (-0.10, 0.66, 0.55)),
               (1.5, 0.6, (0, 0, 1), -30, (-0.12, 0.66, 0.41)), (3.1, 1.8, (1, -1, 2), -120, (0.30, 0.40, 0.60)),
               (0.5, 2.0, (0, 1, 0), -75, (0.70, 0.00, 0.45))]
ROBOT_FINAL_REST = 1.4


def robot_keys():
    """Keys (t, q, position): both ends of every rest, and two or three inside a slew."""
    q, position, t, keys = turn(Y, 90 * DEGREE), (0.70, 0.00, 0.45), 0.0, []
    for rest, slew, axis, angle, goal in ROBOT_MOVES:
        keys += [(t, q, position), (t + rest, q, position)]
        t += rest
        for moment in ((0.22, 0.5, 0.71) if slew > 1.5 else (0.35, 0.64)):
            at = round(slew * moment, 2)
            part = ease(at / slew)[0]
            place = tuple(a + part * (b - a) for a, b in zip(position, goal))
            keys.append((t + at, times(q, turn(unit(axis), angle * DEGREE * part)), place))
        q, position, t = times(q, turn(unit(axis), angle * DEGREE)), goal, t + slew
    return keys + [(t, q, position), (t + ROBOT_FINAL_REST, q, position)]


# frame (25 per second), position [m], point looked at [m], roll [deg]: as an animator would key it
CAMERA_KEYS = [(0, (9.0, 1.6, 12.0), (0, 1.4, 0), 0), (22, (7.8, 1.7, 10.4), (0, 1.4, 0), 0),
               (60, (3.5, 2.4, 8.2), (0.3, 1.5, 0), -4), (84, (-1.2, 3.1, 7.0), (0.4, 1.5, 0.2), -9),
               (97, (-3.8, 3.3, 5.6), (0.2, 1.6, 0), -12), (141, (-7.5, 2.2, 0.5), (0, 1.7, 0), -3),
               (160, (-7.1, 1.1, -2.6), (0, 2.4, 0), 5), (210, (-2.0, 0.8, -6.4), (0, 3.6, 0.4), 8),
               (226, (0.4, 1.0, -6.9), (0.2, 3.2, 0.4), 5), (275, (5.6, 2.8, -4.1), (0, 1.8, 0), 0),
               (300, (6.9, 4.4, -1.0), (0, 1.2, 0), 0), (350, (7.4, 5.2, 2.5), (0, 1.0, 0), 0)]


def looking(position, target, roll):
    """Attitude of a camera that looks along its -z axis, y up, then rolls about its own z."""
    z = unit(tuple(p - c for p, c in zip(position, target)))
    x = unit(cross(Y, z))
    y = cross(z, x)
    # The column of q qᵀ with the largest diagonal entry (four times it), from the rotation matrix.
    columns = [(1 + x[0] + y[1] + z[2], y[2] - z[1], z[0] - x[2], x[1] - y[0]),
               (y[2] - z[1], 1 + x[0] - y[1] - z[2], y[0] + x[1], z[0] + x[2]),
               (z[0] - x[2], y[0] + x[1], 1 - x[0] + y[1] - z[2], z[1] + y[2]),
               (x[1] - y[0], z[0] + x[2], z[1] + y[2], 1 - x[0] - y[1] + z[2])]
    largest = max(range(4), key=lambda i: columns[i][i])
    return times(unit(columns[largest]), turn(Z, roll * DEGREE))


def camera_keys():
    return [(frame / 25, looking(position, target, roll), position) for frame, position, target, roll in CAMERA_KEYS]


# time [s], heading, pitch and roll [deg]: few keys, uneven times, steps of 60 to 72 degrees
FIVE_KEYS = [(0.0, -65, -15, 0), (1.0, -20, 30, 25), (1.5, 15, -20, 45), (3.5, 40, 35, 0), (4.5, 75, -10, -30)]


def five_keys():
    return [(t, times(times(turn(Z, heading * DEGREE), turn(Y, -pitch * DEGREE)), turn(X, roll * DEGREE)))
            for t, heading, pitch, roll in FIVE_KEYS]


# ---------------------------------------------------------------- files

UNITS = """# Units: s, m, rad/s. qw,qx,qy,qz: body to world, Hamilton, sign-continuous. px,py,pz: position in the world.
"""
FLIGHT = UNITS + """# World: x east, y north, z up. Body: x forward, y left, z up.
# Made by tools/make_examples.py: rigid-body dynamics (Euler's equations, full inertia tensor) under an autopilot in
# gusts; lift, drag, thrust and weight for the path; Runge-Kutta of order 4, step 2 ms.
"""
ABOUT = {
    "flight_keys.csv": """# Sparse keyframes of a simulated aerobatic flight: turn, loop, aileron roll, climbing turn.
""" + FLIGHT,
    "flight_truth.csv": """# The true motion of that flight at 100 Hz; the rows of flight_keys.csv are among these.
# wx,wy,wz: angular velocity, body frame.
""" + FLIGHT,
    "robot_keys.csv": """# Keyframes of a robot's tool, stop and go: rests of 0.4 to 3.1 s and smooth slews between.
""" + UNITS + """# World: the robot's base, z up. Body: the tool, its tip at the position.
# Made by tools/make_examples.py: each slew turns about one axis with a quintic profile.
""",
    "camera_keys.csv": """# Keyframes of a camera that circles a subject, timed at 25 frames per second.
""" + UNITS + """# World: y up. Body: the camera looks along its -z axis, y up.
# Made by tools/make_examples.py from positions, aims and rolls set by hand.
""",
    "five_keys.csv": """# Five keyframes at uneven times: those of the figures in docs/families.
# Units: s. qw,qx,qy,qz: body to world, Hamilton, sign-continuous. World and body: z up, x forward.
# Made by tools/make_examples.py from headings, pitches and rolls set by hand.
""",
}


def table(name, rows):
    """The file's text: rows of (t, q[, position[, ω]]), neighbouring quaternions on the same side."""
    lines, last = [], rows[0][1]
    for t, q, *vectors in rows:
        if sum(a * b for a, b in zip(q, last)) < 0:
            q = tuple(-x for x in q)
        last = q
        numbers = ["%.2f" % t, *("%.10f" % x for x in q)]
        for vector, digits in zip(vectors, ("%.6f", "%.9f")):
            numbers += [digits % x for x in vector]
        lines.append(",".join(numbers))
    header = "t,qw,qx,qy,qz" + "".join((",px,py,pz", ",wx,wy,wz")[: len(rows[0]) - 2])
    return ABOUT[name] + header + "\n" + "\n".join(lines) + "\n"


def files():
    samples = fly()
    truth = table("flight_truth.csv", samples)
    rows = truth[len(ABOUT["flight_truth.csv"]):].splitlines()
    header_and_keys = [rows[0], *(rows[1 + i] for i in chosen_keys(samples))]
    keys = [",".join(row.split(",")[:8]) for row in header_and_keys]
    return {"flight_truth.csv": truth,
            "flight_keys.csv": ABOUT["flight_keys.csv"] + "\n".join(keys) + "\n",
            "robot_keys.csv": table("robot_keys.csv", robot_keys()),
            "camera_keys.csv": table("camera_keys.csv", camera_keys()),
            "five_keys.csv": table("five_keys.csv", five_keys()),
            "walking.bvh": recording()}


def first_difference(name, wanted):
    path = DATA / name
    found = path.read_bytes().decode() if path.exists() else ""
    if found == wanted:
        return None
    pairs = zip(found.split("\n") + [""], wanted.split("\n") + [""])
    line = next((i for i, (a, b) in enumerate(pairs, 1) if a != b), 0)
    return f"{path}:{line}: differs from what tools/make_examples.py makes"


def main():
    if sys.argv[1:] not in ([], ["--check"]):
        sys.exit(__doc__)
    made = files()
    if sys.argv[1:] == ["--check"]:
        sys.exit("\n".join(filter(None, (first_difference(*item) for item in made.items()))) or 0)
    DATA.mkdir(parents=True, exist_ok=True)
    for name, text in made.items():
        (DATA / name).write_bytes(text.encode())
        print(f"{DATA / name}: {len(text.splitlines())} lines")


if __name__ == "__main__":
    main()
