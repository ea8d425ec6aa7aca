# SPDX-License-Identifier: Apache-2.0
"""What is measured of keys and of curves. The names are those of the library."""
from __future__ import annotations

import dataclasses
from typing import Any


@dataclasses.dataclass(frozen=True)
class Energies:
    """How much a curve accelerates, integrated inside its segments only: where ω jumps at a key the true `acceleration` is
    infinite, where α jumps the true `jerk` is (`Curve.continuity` tells).

    `acceleration` is ∫|α|² dt [rad²/s³], `jerk` ∫|dα/dt|² dt [rad²/s⁵], `torque` ∫|torque|² dt [N² m² s], None without an
    inertia.

    Examples
    --------
    >>> import orispline as ori
    >>> ori.Curve([0, 1, 2], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 0.96, 0.28]]).energies().acceleration < 1e-20
    True
    """

    acceleration: float
    jerk: float
    torque: float | None = None


@dataclasses.dataclass(frozen=True)
class Peak:
    """The largest length of a rate that was found, and a `time` when it is reached, as the caller has times. The rate is
    nowhere above `bound`, which is None where no bound is known."""

    value: float
    time: Any
    bound: float | None = None


@dataclasses.dataclass(frozen=True)
class Peaks:
    """The peaks of a whole curve: of `angular_velocity` [rad/s], of `angular_acceleration` [rad/s²] and of `torque` [N m],
    which is None without an inertia."""

    angular_velocity: Peak
    angular_acceleration: Peak
    torque: Peak | None = None


@dataclasses.dataclass(frozen=True)
class DistanceStatistics:
    """Distances between two motions: of orientations [rad], or of angular velocities [rad/s].

    `count` is the number of compared times; `rms`, `mean`, `largest`, `median`, `percentile_95` and `percentile_99` are in
    the unit of the distances; `largest_at` is the index of the largest one among the times that were given.
    """

    count: int
    rms: float
    mean: float
    largest: float
    largest_at: int
    median: float
    percentile_95: float
    percentile_99: float


@dataclasses.dataclass(frozen=True)
class HandleTurn:
    """How far the handle of a `key` (its index) turns away from it: `turn` [rad]."""

    key: int
    turn: float


@dataclasses.dataclass(frozen=True)
class Spread:
    """Smallest, median and largest of some figures, and the index of the largest."""

    smallest: float
    median: float
    largest: float
    largest_at: int


@dataclasses.dataclass(frozen=True)
class KeyStatistics:
    """What keys are like: `span`, last time minus first [s]; `spacing`, times between neighbours [s], and `step`, angles
    between them [rad], None for one key; `near_half_turns`, the keys from which a step is within 1° of 180°."""

    span: float
    spacing: Spread | None
    step: Spread | None
    near_half_turns: tuple[int, ...]
