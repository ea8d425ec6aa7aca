# SPDX-License-Identifier: Apache-2.0
# A turn, a pull-up and a roll through five keys at uneven times: which methods are smooth in time?
import numpy as np
from scipy.spatial.transform import Rotation

import orispline as ori

times = [0.0, 1.0, 1.5, 3.5, 4.5]  # [s]
steps = Rotation.from_rotvec([[0, 0, 0], [0, 0, 40], [0, -30, 0], [110, 0, 0], [50, 0, 0]], degrees=True)
attitudes = [steps[0]]
for step in steps[1:]:
    attitudes.append(attitudes[-1] * step)  # body frame: the step stands on the right
keys = ori.Keys(times, Rotation.concatenate(attitudes))

print("method        turn rate before and after the key at 1.5 s")
for method in ("slerp", "squad", "quintic", "sextic", "timed-c2", "auto"):
    curve = keys.curve(method)
    before, after = curve.motion(1.5, side="left"), curve.motion(1.5)
    print(f"{method:<12}  {np.linalg.norm(before.angular_velocity):7.3f}  {np.linalg.norm(after.angular_velocity):7.3f} rad/s")
