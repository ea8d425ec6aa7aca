# SPDX-License-Identifier: Apache-2.0
"""The least error that orientations and rates allow: a Rauch-Tung-Striebel smoother of many recordings at once, which knows all noise.

It is linearised about the truth, to which a smoother that iterates comes by itself where errors are small. So its states are errors,
and where it is off zero is where the best estimate would be off the truth.
"""
import numpy as np

from recordings import DEGREE

OPEN = 1e4  # variance of what is not known; of a rate [rad²/s²] that is no measurement


def smoothed(covariance, step, seen, count):
    """The states of a linear system in all its `count` steps.

    `covariance`: of the first state, whose mean is 0, of each recording. `step(k)`: the matrix, the shift and the covariance by which the
    state comes to step k. `seen(k)`: pairs (matrix, covariance, values).
    """
    state = np.zeros(covariance.shape[:2])
    after = []
    for k in range(count):
        if k:
            matrix, shift, noise = step(k)
            state = np.einsum("bij,bj->bi", matrix, state) + shift
            covariance = matrix @ covariance @ matrix.swapaxes(1, 2) + noise
        before = state, covariance
        for sees, noise, values in seen(k):
            cross = covariance @ sees.swapaxes(1, 2)
            gain = np.linalg.solve(sees @ cross + noise, cross.swapaxes(1, 2)).swapaxes(1, 2)
            state = state + np.einsum("bij,bj->bi", gain, values - np.einsum("bij,bj->bi", sees, state))
            covariance = covariance - gain @ cross.swapaxes(1, 2)
            covariance = 0.5 * (covariance + covariance.swapaxes(1, 2))
        after.append((*before, state, covariance))
    result = np.empty((count, *state.shape))
    result[-1] = state
    for k in range(count - 2, -1, -1):
        predicted, spread = after[k + 1][:2]
        known, certain = after[k][2:]
        gain = np.linalg.solve(spread, step(k + 1)[0] @ certain).swapaxes(1, 2)
        result[k] = known + np.einsum("bij,bj->bi", gain, result[k + 1] - predicted)
    return result


def middles(values):
    return 0.5 * (values[:, 1:] + values[:, :-1])


def stacked(recordings, of):
    return np.array([of(recording) for recording in recordings])


def error(setting, recordings):
    """RMS angle [°] of each one, from the rates as the gyro would have them without its fault."""
    interval, count, many = 1.0 / setting.rate, len(recordings[0].times), len(recordings)
    size = 12 if setting.correlation else 9  # turn of the gyro's path in the world, bias, scale, noise of the orientations that keeps
    to_world = stacked(recordings, lambda one: one.truth.as_matrix())
    turns, rates = middles(to_world) * interval, middles(stacked(recordings, lambda one: one.turning))
    path = np.zeros((many, count, 3))
    path[:, 1:] = np.cumsum(np.einsum("bkij,bkj->bki", turns, middles(stacked(recordings, lambda one: one.gyro_errors))), 1)
    values = -path[:, recordings[0].at] + np.einsum("bkij,bkj->bki", to_world[:, recordings[0].at], stacked(recordings, lambda one: one.pose_errors))
    variance = (setting.pose_noise * DEGREE) ** 2
    white = np.eye(3) * (1e-12 if setting.correlation else variance)
    stays = np.exp(-interval / setting.correlation) if setting.correlation else 0.0
    noise = np.zeros((size, size))
    noise[:3, :3] = np.eye(3) * (setting.rate_noise * DEGREE * interval) ** 2
    noise[3:6, 3:6] = np.eye(3) * (setting.walk * DEGREE) ** 2 * interval
    noise[9:, 9:] = np.eye(size - 9) * variance * (1.0 - stays**2)
    first = np.diag([OPEN] * 3 + [(setting.bias * DEGREE) ** 2] * 3 + [setting.scale**2 + 1e-12] * 3 + [variance] * (size - 9))

    def step(k):
        matrix = np.tile(np.eye(size), (many, 1, 1))
        matrix[:, :3, 3:6] = turns[:, k - 1]
        matrix[:, :3, 6:9] = turns[:, k - 1] * rates[:, k - 1, None, :]
        matrix[:, 9:, 9:] *= stays
        return matrix, 0.0, noise

    def seen(k):
        if k % setting.every:
            return
        sees = np.zeros((many, 3, size))
        sees[:, :, :3] = -np.eye(3)
        if setting.correlation:
            sees[:, :, 9:] = to_world[:, k]
        yield sees, white, values[:, k // setting.every]

    off = smoothed(np.tile(first, (many, 1, 1)), step, seen, count)[:, :, :3].swapaxes(0, 1) - path
    return np.sqrt((off**2).sum(2).mean(1)) / DEGREE


def error_of_missing(setting, recordings):
    """The same where the smoother is told which rates are missing. Beside the gyro the body's rate is an integrated random walk; its size is about
    the best one for these motions."""
    size = 10.0  # [rad²/s⁵]
    interval, count, many = 1.0 / setting.rate, len(recordings[0].times), len(recordings)
    to_world = stacked(recordings, lambda one: one.truth.as_matrix())
    turning = stacked(recordings, lambda one: one.turning)
    turns, shifts = middles(to_world) * interval, middles(turning)
    gyro = turning + stacked(recordings, lambda one: one.gyro_errors)
    spreads = np.where(stacked(recordings, lambda one: one.measures), (setting.rate_noise * DEGREE) ** 2, OPEN)
    off = np.einsum("bkij,bkj->bki", to_world[:, recordings[0].at], stacked(recordings, lambda one: one.pose_errors))
    noise = np.zeros((12, 12))  # turn of the estimate in the world, rate, acceleration, bias
    for i, j, power, divisor in ((3, 3, 3, 3), (3, 6, 2, 2), (6, 3, 2, 2), (6, 6, 1, 1)):
        noise[i : i + 3, j : j + 3] = np.eye(3) * size * interval**power / divisor
    first = np.diag([OPEN] * 9 + [(setting.bias * DEGREE) ** 2] * 3)
    sees_rate, sees_turn = np.zeros((2, many, 3, 12))
    sees_rate[:, :, 3:6] = sees_rate[:, :, 9:] = sees_turn[:, :, :3] = np.eye(3)

    def step(k):
        matrix = np.tile(np.eye(12), (many, 1, 1))
        matrix[:, :3, 3:6] = turns[:, k - 1]
        matrix[:, :3, 6:9] = 0.5 * interval * turns[:, k - 1]
        matrix[:, 3:6, 6:9] = interval * np.eye(3)
        shift = np.zeros((many, 12))
        shift[:, :3] = -np.einsum("bij,bj->bi", turns[:, k - 1], shifts[:, k - 1])
        return matrix, shift, noise

    def seen(k):
        yield sees_rate, np.eye(3) * spreads[:, k, None, :], gyro[:, k]
        if k % setting.every == 0:
            yield sees_turn, np.eye(3) * (setting.pose_noise * DEGREE) ** 2, off[:, k // setting.every]

    found = smoothed(np.tile(first, (many, 1, 1)), step, seen, count)[:, :, :3]
    return np.sqrt((found**2).sum(2).mean(0)) / DEGREE
