# SPDX-License-Identifier: Apache-2.0
# Many samples at once: a track resampled into NumPy's memory, on as many threads as wanted, with the same bits.
import numpy as np
from scipy.spatial.transform import Rotation

import orispline as ori

i = np.arange(1000)
curve = ori.Curve(0.1 * i, Rotation.from_rotvec(np.stack([0.3 * (i % 3), 0.01 * i, 0.2 * (i % 7)], axis=1)), "timed-c2")

count = 100_000
motion = curve.sample(times=0.001 * np.arange(count), derivatives=1, threads=2)
some = curve([70.0, 3.5, 99.9], dtype="float32")  # in any order

k = 70_000
print(f"sample {k} of {count}: w {motion.orientations[k, 3]:.6f}, rate {motion.angular_velocities[k, 0]:.6f} rad/s")
print(f"the same in float: w {some[0, 3]:.6f}")
m = curve.motion(0.001 * k)
print(f"one by one:        w {m.orientation[3]:.6f}, rate {m.angular_velocity[0]:.6f} rad/s")
