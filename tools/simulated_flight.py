# SPDX-License-Identifier: Apache-2.0
"""An aerobatic flight: Euler's equations of a rigid body under an autopilot in gusts, with a believable path.

World: x east, y north, z up. Body: x forward, y left, z up.
"""

import random

from rotations import (DEGREE, PI, X, Y, Z, conjugate, cosine, cross, ease, norm, sine, times, to_body, to_world, turn,
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
