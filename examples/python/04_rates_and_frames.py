# SPDX-License-Identifier: Apache-2.0
# Exact angular velocity and acceleration, in the body frame and in the world, with chosen rates at both ends.
import numpy as np
from scipy.spatial.transform import Rotation

import orispline as ori

attitudes = Rotation.from_rotvec([[0.0, 0.0, 0.3], [0.5, 0.2, 0.6], [1.1, -0.1, 0.9], [1.2, -0.4, 1.0]])
keys = ori.Keys([10.0, 10.8, 12.0, 12.5], attitudes)
curve = keys.curve("timed-c2", start_rate=[0.2, 0.1, 0.4], ends=("clamped", "rest"))

for t in (10.0, 11.5):
    print(f"t = {t:.1f} s")
    for what, rate in (("velocity, body [rad/s]", curve.angular_velocity(t)),
                       ("velocity, world [rad/s]", curve.angular_velocity(t, frame="world")),
                       ("acceleration, body", curve.angular_acceleration(t)),
                       ("acceleration, world", curve.angular_acceleration(t, frame="world"))):
        print(f"  {what:<26} {rate[0]:8.4f} {rate[1]:8.4f} {rate[2]:8.4f}")
print(f"it comes to rest: {np.linalg.norm(curve.angular_velocity(12.5)):.4f} rad/s")
print(f"before 10 s it holds still: {np.linalg.norm(curve.angular_velocity(9.0)):.4f} rad/s, or says so:")
try:
    keys.curve("timed-c2", extrapolate="error")(9.0)
except ori.Error as error:
    print(error)
