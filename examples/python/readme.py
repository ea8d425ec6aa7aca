# SPDX-License-Identifier: Apache-2.0
# The section on Python of the README, as printed there.
import numpy as np
from scipy.spatial.transform import Rotation
import orispline as ori

times, rotations = [0.0, 1.0, 2.5], Rotation.from_rotvec([[0, 0, 0], [0, 0, 1], [0.5, 0, 2]])
t = np.linspace(0.0, 2.5, 1000)

curve = ori.Curve(times, rotations)               # seconds or datetime64; x, y, z, w, matrices or a SciPy Rotation
q = curve(t)                                      # (1000, 4)
w = curve.angular_velocity(t)                     # (1000, 3) rad/s, body frame; exact, like all rates
motion = curve.sample(rate=100, derivatives=2)    # times, orientations, ω, α as arrays
spline = ori.RotationSpline(times, rotations)     # SciPy's call, faster; SciPy's numbers where SciPy converges
