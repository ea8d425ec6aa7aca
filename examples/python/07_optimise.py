# SPDX-License-Identifier: Apache-2.0
# From a noisy recording to a motion within limits: smooth, reduce, tune, retime.
import numpy as np
from scipy.spatial.transform import Rotation

import orispline as ori

# Six seconds at 50 Hz, with about half a degree of noise.
t = 0.02 * np.arange(301)
truth = Rotation.from_rotvec(np.stack([np.sin(t), 0.3 * t, np.cos(0.7 * t)], axis=1))
noise = np.stack([np.sin(997.0 * t * t), np.sin(877.0 * t * t), np.sin(761.0 * t * t)], axis=1)
recording = ori.Keys(t, truth * Rotation.from_rotvec(0.7 * noise, degrees=True))

smoothing = ori.smooth(recording, penalty="jerk")
print(f"smooth: noise of {np.degrees(smoothing.noise):.1f} degrees per axis")

reduction = ori.reduce(smoothing.keys, tolerance="0.5deg", method="timed-c2")
within = np.degrees(reduction.error_max) <= 0.5
print(f"reduce: {len(reduction.keys)} of {len(recording)} keys, {'within half a degree' if within else 'too far'}")

tuning = ori.tune(reduction.keys, "timed-c2", objective="acceleration")
lower = tuning.energy_after < tuning.energy_before
print(f"tune: {len(tuning.parameters)} tensions per key, {'less' if lower else 'the same'} energy")

retiming = ori.retime(tuning.keys, method="timed-c2", max_rate="20deg/s", max_acceleration="40deg/s^2")
print(f"retime: slowed by {retiming.time_scale:.1f}")
try:
    ori.retime(tuning.keys, method="slerp", max_acceleration=1.0)
except ori.Error as error:
    print(error)
