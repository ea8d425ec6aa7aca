# SPDX-License-Identifier: Apache-2.0
# One tension per key: how fast the motion passes the key in the middle, while the others stay as they are.
from scipy.spatial.transform import Rotation

import orispline as ori

yaws = [0.0, 0.4, 0.8, 1.2, 1.6]  # [rad]: a steady pan
keys = ori.Keys([0.0, 1.0, 2.0, 3.0, 4.0], Rotation.from_rotvec([[0.0, 0.0, yaw] for yaw in yaws]))

times = [1.0, 1.5, 2.0, 2.5, 3.0]
print("tension   yaw rate [rad/s] at t = 1.0     1.5     2.0     2.5     3.0 s")
for tension in (1.0, 0.5, 0.0, -0.2):
    curve = keys.curve("timed-c2", tension=[0.5, 0.5, tension, 0.5, 0.5])  # one per key; a single number would serve for all
    rates = "".join(f" {rate:7.4f}" for rate in curve.angular_velocity(times)[:, 2])
    print(f"{tension:7.1f}                          {rates}")

try:
    keys.curve("timed-c2", tension=[0.5, 0.5])
except ori.Error as error:
    print(error)
