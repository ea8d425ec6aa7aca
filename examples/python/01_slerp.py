# SPDX-License-Identifier: Apache-2.0
# Two orientations: how far apart they are, what lies between them, and which way round the motion goes.
import numpy as np
from scipy.spatial.transform import Rotation

import orispline as ori

level, banked = Rotation.identity(), Rotation.from_rotvec([60, 0, 0], degrees=True)
curve = ori.Curve([0, 1], Rotation.concatenate([level, banked]), "slerp")

print(f"apart {np.degrees(curve.angle_travelled()):.1f} deg")
for s in (0.0, 0.25, 0.5, 0.75, 1.0):
    x, _, _, w = curve(s)
    print(f"s {s:.2f}  w {w:.6f}  x {x:.6f}  bank {curve.rotation(s).as_rotvec(degrees=True)[0]:.1f} deg")

# q and -q are one orientation, but keys as given keep their signs: here the motion goes the long way round.
long_way = ori.Curve([0, 1], [level.as_quat(), -banked.as_quat()], "slerp", signs="as-given")
apart = np.degrees((long_way.rotation(0.0).inv() * long_way.rotation(1.0)).magnitude())
print(f"still {apart:.1f} deg apart, yet the long way is {-np.degrees(long_way.angular_velocity(0.5)[0]):.1f} deg about -x")
