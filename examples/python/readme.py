# SPDX-License-Identifier: Apache-2.0
# The section on Python of the README, as printed there.
import orispline as ori

curve = ori.Curve([0, 1, 2.5], [[0, 0, 0, 1], [0.6, 0, 0, 0.8], [0, 0, 0.6, 0.8]])  # x, y, z, w, as in SciPy
q, w = curve([0.5, 1.3]), curve.angular_velocity([0.5, 1.3])    # (2, 4), and (2, 3) rad/s in the body frame
motion = curve.sample(rate=100, derivatives=2)                  # all of it as arrays
