# SPDX-License-Identifier: Apache-2.0
"""Filters that people clean motion capture with, for the columns of an array at even times: each takes the columns, the interval [s] and one setting."""
import itertools

import numpy as np
from scipy.ndimage import median_filter
from scipy.signal import butter, savgol_filter, sosfiltfilt
from scipy.spatial.transform import Rotation

HAMPEL = 3.0 * 1.4826  # of medians of the distance, for normal noise


def hampel(columns, half_window):
    """Values that lie farther from the median about them than three standard deviations become it."""
    size = (2 * half_window + 1, 1)
    middle = median_filter(columns, size, mode="nearest")
    spread = HAMPEL * median_filter(np.abs(columns - middle), size, mode="nearest")
    return np.where(np.abs(columns - middle) > spread, middle, columns)


def butterworth(columns, interval, cutoff):
    """Of the fourth order: the second, forth and back."""
    return sosfiltfilt(butter(2, 2.0 * cutoff * interval, output="sos"), columns, axis=0)


def savitzky_golay(columns, interval, setting):
    degree, half_window = setting
    return savgol_filter(columns, 2 * half_window + 1, degree, axis=0)


def one_euro(columns, interval, setting):
    """Casiez, Roussel and Vogel 2012, the speed of each column filtered at 1 Hz; forth and back, so that it does not lag."""
    least, by_speed = setting

    def share(cutoff):
        return 1.0 / (1.0 + 1.0 / (2.0 * np.pi * cutoff * interval))

    def forth(values):
        filtered, speed = np.empty_like(values), np.zeros(values.shape[1])
        filtered[0] = values[0]
        for i in range(1, len(values)):
            speed += share(1.0) * ((values[i] - filtered[i - 1]) / interval - speed)
            filtered[i] = filtered[i - 1] + share(least + by_speed * np.abs(speed)) * (values[i] - filtered[i - 1])
        return filtered

    return forth(forth(columns)[::-1])[::-1]


FILTERS = {
    "Butterworth": (butterworth, list(np.geomspace(1.0, 30.0, 20))),
    "Savitzky–Golay": (savitzky_golay, list(itertools.product((2, 3), (2, 3, 4, 5, 6, 8, 10, 12, 15, 18, 22, 27, 33, 40)))),
    "One-Euro": (one_euro, list(itertools.product(np.geomspace(1.0, 30.0, 9), (0.0, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0)))),
}
HALF_WINDOWS = (None, 5, 9, 13, 18)  # of the Hampel filter before; None: without it


def columns_of(rotations, place):
    """The components of quaternions whose signs run on, and the root's place [m]."""
    columns = []
    for rotation in rotations:
        q = rotation.as_quat()
        columns.append(q * np.cumprod(np.where(np.r_[1.0, np.sum(q[1:] * q[:-1], axis=1)] < 0.0, -1.0, 1.0))[:, None])
    return np.column_stack([*columns, place])


def motion_of(columns):
    return [Rotation.from_quat(columns[:, k:k + 4]) for k in range(0, columns.shape[1] - 3, 4)], columns[:, -3:]
