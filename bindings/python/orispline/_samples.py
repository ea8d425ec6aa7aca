# SPDX-License-Identifier: Apache-2.0
"""What a curve is at one time, and at many."""
from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray


@dataclasses.dataclass(frozen=True)
class Motion:
    """A curve at one time: an orientation with its rates, and where the keys have positions the position with its own."""

    orientation: NDArray[np.float64]
    angular_velocity: NDArray[np.float64]
    angular_acceleration: NDArray[np.float64]
    angular_jerk: NDArray[np.float64]
    position: NDArray[np.float64] | None = None
    velocity: NDArray[np.float64] | None = None
    acceleration: NDArray[np.float64] | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class Samples:
    """Samples of a curve: (k,) times, (k, 4) orientations and (k, 3) of all else; None is what was not asked for."""

    times: np.ndarray[Any, Any]
    orientations: NDArray[Any]
    angular_velocities: NDArray[Any] | None = None
    angular_accelerations: NDArray[Any] | None = None
    angular_jerks: NDArray[Any] | None = None
    positions: NDArray[Any] | None = None
    velocities: NDArray[Any] | None = None
    accelerations: NDArray[Any] | None = None

    def __len__(self) -> int:
        return len(self.times)
