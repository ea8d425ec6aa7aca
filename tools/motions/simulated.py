# SPDX-License-Identifier: Apache-2.0
"""The simulated motions of examples/data: an aerobatic flight and a walking figure.

The flight: Euler's equations of a rigid body under an autopilot in gusts, with a believable path. World: x east, y north, z up. Body: x
forward, y left, z up.

The figure walks as motion capture records it: two strides of sums of sines, with the noise of markers and two faults. World: y up, it
walks along z, its left is along x. Lengths are centimetres. The rest pose stands upright with hanging arms.
"""
import random

from motions.rotations import (DEGREE, PI, X, Y, Z, conjugate, cosine, cross, ease, norm, sine, times, to_body, to_world, turn,
                       unit)

GRAVITY = 9.81             # [m/s²]
MASS = 800.0               # [kg]
WING = 10.0                # area [m²]
LIFT_SLOPE = 5.0           # lift coefficient per radian of angle of attack
INERTIA = ((850.0, 0.0, -60.0), (0.0, 1500.0, 0.0), (-60.0, 0.0, 2150.0))  # [kg m²], body frame
CRUISE = 75.0              # speed that the throttle seeks [m/s]
DURATION, SAMPLE, SUBSTEPS = 48.0, 0.01, 5  # [s], [s], Runge–Kutta steps per sample
STIFFNESS, DAMPING = 36.0, 9.0  # autopilot: [1/s²], [1/s]


def inverse_inertia():
    (a, _, c), (_, b, _), (_, _, d) = INERTIA
    determinant = a * d - c * c
    return ((d / determinant, 0.0, -c / determinant), (0.0, 1.0 / b, 0.0), (-c / determinant, 0.0, a / determinant))


INVERSE_INERTIA = inverse_inertia()


def apply(matrix, v):
    return tuple(row[0] * v[0] + row[1] * v[1] + row[2] * v[2] for row in matrix)


def gusts():
    """Disturbing torque [N m] per axis: five sines of frequency 0.2 to 1 Hz with random phases."""
    rng = random.Random(20180301)
    return [[(rng.uniform(1.2, 6.3), rng.uniform(0, 2 * PI), rng.uniform(0.03, 0.10) * INERTIA[axis][axis])
             for _ in range(5)] for axis in range(3)]


GUSTS = gusts()

# (start [s], duration [s], total [deg]) of each smooth change
TURN_BANKS = [(2.5, 3.2, -48.0), (9.0, 3.2, 48.0), (32.0, 3.4, 38.0), (40.0, 3.2, -38.0)]
AILERON_ROLL = [(27.0, 3.6, 360.0)]
CLIMBS = [(33.0, 3.0, 11.0), (39.5, 3.0, -11.0)]
LOOP = (14.0, 11.0, 1.8)  # start, duration, time to build up the pitch rate [s]


def summed(changes, t):
    """Angle [rad] and rate [rad/s] of a sum of smooth changes."""
    angle = rate = 0.0
    for start, duration, total in changes:
        value, slope = ease((t - start) / duration)
        angle += total * DEGREE * value
        rate += total * DEGREE * slope / duration
    return angle, rate


def loop_pitch(t):
    """Angle and rate of the loop: the rate rises smoothly, stays, falls smoothly."""
    start, duration, rise = LOOP
    peak = 2 * PI / (duration - rise)

    def built_up(s):  # integral of the smooth rise of the rate from 0 to 1
        x = min(max(s / rise, 0.0), 1.0)
        return rise * (x * x * x * x * (2.5 + x * (x - 3.0))) + max(s - rise, 0.0)

    left, right = t - start, t - start - duration + rise
    return peak * (built_up(left) - built_up(right)), peak * (ease(left / rise)[0] - ease(right / rise)[0])


def guidance(t, heading, airspeed):
    """Wanted attitude, wanted body rates [rad/s] and heading rate [rad/s]."""
    bank_in_turn, bank_rate = summed(TURN_BANKS, t)
    roll, roll_rate = summed(AILERON_ROLL, t)
    climb, climb_rate = (a + b for a, b in zip(summed(CLIMBS, t), loop_pitch(t)))
    heading_rate = -GRAVITY / CRUISE * sine(bank_in_turn) / cosine(bank_in_turn)
    pitched, banked = turn(Y, -climb), turn(X, bank_in_turn + roll)
    path = times(times(turn(Z, heading), pitched), banked)
    spun = to_body(banked, to_body(pitched, (0.0, 0.0, heading_rate)))
    lifted = to_body(banked, (0.0, -climb_rate, 0.0))
    rates = (spun[0] + lifted[0] + bank_rate + roll_rate, spun[1] + lifted[1], spun[2] + lifted[2])
    upward = -rates[1] * airspeed + to_body(path, (0.0, 0.0, GRAVITY))[2]
    attack = MASS * upward / (0.5 * 1.2 * airspeed * airspeed * WING * LIFT_SLOPE)
    return times(path, turn(Y, -min(max(attack, -0.3), 0.3))), rates, heading_rate


def acceleration(q, velocity):
    """Acceleration [m/s²] by lift, side force, drag, thrust and weight."""
    u, v, w = to_body(q, velocity)
    airspeed = norm((u, v, w))
    pressure_area = 0.5 * 1.2 * airspeed * airspeed * WING
    lift = LIFT_SLOPE * -w / u
    side = -0.8 * v / u
    drag = 0.03 + 0.05 * lift * lift
    thrust = min(max(950.0 + 700.0 * (CRUISE - airspeed), 0.0), 7500.0)
    body = (thrust - pressure_area * drag * u / airspeed, pressure_area * side, pressure_area * lift)
    ax, ay, az = to_world(q, body)
    return (ax / MASS, ay / MASS, az / MASS - GRAVITY)


def derivative(t, state):
    """State: position, velocity (world), q (body to world), ω (body), heading of the guidance."""
    velocity, q, omega, heading = state[3:6], state[6:10], state[10:13], state[13]
    wanted, rates, heading_rate = guidance(t, heading, norm(velocity))
    error = times(conjugate(q), wanted)
    side = 2.0 if error[0] >= 0 else -2.0
    push = tuple(STIFFNESS * side * error[1 + i] + DAMPING * (rates[i] - omega[i]) for i in range(3))
    gust = tuple(sum(a * sine(f * t + phase) for f, phase, a in waves) for waves in GUSTS)
    gyroscopic = cross(omega, apply(INERTIA, omega))
    torque = tuple(p + g - c for p, g, c in zip(apply(INERTIA, push), gust, gyroscopic))
    q_rate = tuple(0.5 * x for x in times(q, (0.0, *omega)))
    return (*velocity, *acceleration(q, velocity), *q_rate, *apply(INVERSE_INERTIA, torque), heading_rate)


def runge_kutta(t, state, h):
    def ahead(slope, step):
        return tuple(x + step * k for x, k in zip(state, slope))

    k1 = derivative(t, state)
    k2 = derivative(t + h / 2, ahead(k1, h / 2))
    k3 = derivative(t + h / 2, ahead(k2, h / 2))
    k4 = derivative(t + h, ahead(k3, h))
    state = tuple(x + h / 6 * (a + 2 * (b + c) + d) for x, a, b, c, d in zip(state, k1, k2, k3, k4))
    return (*state[:6], *unit(state[6:10]), *state[10:])


def fly(substeps=SUBSTEPS):
    """Samples (t, q, position, ω) at 100 Hz."""
    attitude, _, _ = guidance(0.0, 0.0, CRUISE)
    state = (0.0, 0.0, 300.0, CRUISE, 0.0, 0.0, *attitude, 0.0, 0.0, 0.0, 0.0)
    samples = []
    for i in range(round(DURATION / SAMPLE) + 1):
        samples.append((i * SAMPLE, state[6:10], state[0:3], state[10:13]))
        for k in range(substeps):
            state = runge_kutta(i * SAMPLE + k * SAMPLE / substeps, state, SAMPLE / substeps)
    return samples


def chosen_keys(samples):
    """Indices of the keyframes: every 1.0 to 1.8 s, sooner when the aircraft has turned by 60 to 90 degrees."""
    rng = random.Random(33)
    last = len(samples) - 1
    chosen, turned, wait, limit = [0], 0.0, rng.uniform(1.0, 1.8), rng.uniform(60.0, 90.0) * DEGREE
    for i in range(1, last - 50):
        turned += norm(samples[i][3]) * SAMPLE
        if (i - chosen[-1]) * SAMPLE >= wait or turned >= limit:
            chosen.append(i)
            turned, wait, limit = 0.0, rng.uniform(1.0, 1.8), rng.uniform(60.0, 90.0) * DEGREE
    return chosen + [last]


# ---------------------------------------------------------------- the walking figure

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
