# SPDX-License-Identifier: Apache-2.0
"""VQF, the filter of Laidig and Seel (2023), in its offline form: orientations as directions of gravity and of north."""
import numpy as np
import vqf
from scipy.spatial.transform import Rotation, Slerp

from recordings import DEGREE

TIMES = (0.02, 0.05, 0.1, 0.3, 1.0, 3.0)  # [s], of which the best for the truth is taken


def even_rates(recording):
    """One at each time; the stamps of a batch say no more than how many there are."""
    if np.median(np.diff(recording.gyro_times)) < 0.5 * np.median(np.diff(recording.times)):
        return recording.gyro.copy()
    return np.column_stack([np.interp(recording.times, recording.gyro_times, axis) for axis in recording.gyro.T])


def error(recording):
    """RMS angle [°]."""
    at = recording.times[recording.at]
    inside = recording.times <= at[-1]
    seen = Slerp(at, recording.poses)(np.minimum(recording.times, at[-1])).inv()
    directions = [np.ascontiguousarray(seen.apply(direction)) for direction in ([0.0, 0.0, 9.81], [0.0, 1.0, -1.0])]
    rates = even_rates(recording)

    def of(time):
        settings = dict(tauAcc=time, tauMag=time, magDistRejectionEnabled=False, restBiasEstEnabled=False, biasSigmaInit=1.0)
        found = vqf.offlineVQF(rates, *directions, 1.0 / round(1.0 / np.median(np.diff(recording.times))), settings)
        off = recording.truth.inv() * Rotation.from_quat(found["quat9D"][:, [1, 2, 3, 0]])
        return np.sqrt((off.magnitude()[inside] ** 2).mean()) / DEGREE

    return min(of(time) for time in TIMES)
