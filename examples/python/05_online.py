# SPDX-License-Identifier: Apache-2.0
# Keys that arrive one by one at 10 Hz, a control loop at 1 kHz one key behind them: smooth across every arrival.
import numpy as np
from scipy.spatial.transform import Rotation

import orispline as ori


def measured(t):
    return Rotation.from_rotvec([0.4 * t, 0.3 * t * t, 0.0]).as_quat()


curve = ori.OnlineCurve("timed-c2", capacity=16)  # a ring of 16 keys
delay = 0.2  # a segment is final one key behind its end: two steps of 0.1 s behind the newest
speeds = []
for millisecond in range(1001):
    now = 0.001 * millisecond
    if millisecond % 100 == 0:
        curve.append(now, measured(now))
    available = curve.available
    if available is not None and available[0] <= now - delay <= available[1]:
        speeds.append(np.linalg.norm(curve.motion(now - delay).angular_velocity))
print(f"available: {curve.available[0]:.1f} s to {curve.available[1]:.1f} s")
print(f"largest change of the speed in a millisecond: {np.abs(np.diff(speeds)).max():.4f} rad/s")
try:
    curve.append(0.5, measured(0.5))
except ori.Error as error:
    print(error)
curve.finish()
print(f"finished: {curve.available[0]:.1f} s to {curve.available[1]:.1f} s")
