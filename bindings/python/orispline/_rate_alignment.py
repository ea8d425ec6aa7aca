# SPDX-License-Identifier: Apache-2.0
"""What brings a gyro onto another one, or onto the orientations of the body that carries it."""
from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._clock import Clock, SecondsSince, times_of_keys
from ._html import table
from ._keys import Keys
from ._options import FIELDS, states
from ._rates import Rates
from ._request import Request
from ._told import Told

Vector = NDArray[np.float64]
Indices = NDArray[np.intp]


@dataclasses.dataclass(frozen=True, eq=False)
class OpenRateDirection:
    """What two recordings cannot tell of their alignment by rates: so much of these together changes nothing that was measured.

    `body`: a turn about this axis [rad]. `offset` [s], `bias` [rad/s].
    """

    body: Vector
    offset: float
    bias: Vector


@states("RateAlignment")
@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class RateAlignment(Told):
    """What brings a recording `a` onto a recording `b`, of `align`, where one of them is of a gyro or both are: ω' = B (ω - bias),
    t' = t - offset. Where orientations are moved onto a gyro, R' = R Bᵀ.

    Angles are in rad, times in s.

    Attributes
    ----------
    aligned
        `a` as it lies beside `b`: Rates without their bias, or Keys.
    body
        The rotation B as a (4,) quaternion, in the order of the keys if there are some.
    open
        What the recordings cannot tell: an `OpenRateDirection` for each, none as a rule.
    {fields}
    """

    aligned: Rates | Keys
    body: Vector
    offset: float
    offset_sigma: float
    body_sigma: Vector
    bias: Vector
    bias_sigma: Vector
    open: tuple[OpenRateDirection, ...]
    compared: int
    rejected_moved: Indices
    rejected_fixed: Indices
    distance_rms: float | None
    distance_median: float | None
    distance_max: float | None
    rate_rms: float | None
    rate_median: float | None
    rate_max: float | None
    excess: float
    _members: dict[str, Any]
    _summary: str

    def __repr__(self) -> str:
        q, bias = (", ".join(f"{x:.6g}" for x in vector) for vector in (self.body, self.bias))
        return f"RateAlignment({self.aligned!r}, body=[{q}], offset={self.offset!r}, bias=[{bias}], excess={self.excess:.3g})"

    def _repr_html_(self) -> str:
        """The table that a notebook shows: what was found, by name with unit, and what it means."""
        rows = [(field["member"], value, field["sentence"]) for field in FIELDS["RateAlignment"]
                if isinstance(value := self._members.get(field["member"]), (int, float))]
        return table(repr(self), ("", "", "meaning"), rows)


def aligned_by_rates(a: Keys | Rates, b: Keys | Rates, stated: dict[str, Any]) -> RateAlignment:
    """One of them at least is of a gyro."""
    moved, fixed = _side("a", a), _side("b", b)
    core, = Request("align", {"moved": moved.core, "fixed": fixed.core}, stated).told()
    found, members = core.attributes(), core.members()
    values = found | {name: np.array(found[name]) for name in ("body_sigma", "bias", "bias_sigma")}
    for name, side in (("rejected_moved", moved), ("rejected_fixed", fixed)):
        values[name] = side.rows[np.array(found[name], dtype=np.intp)]
        members[name] = [{**row, "key": int(side.rows[row["key"]])} for row in members[name]]
    scalar_first = any(isinstance(one, Keys) and one._scalar_first for one in (a, b))
    values["body"] = np.array(found["body"])[[3, 0, 1, 2] if scalar_first else [0, 1, 2, 3]]
    values["open"] = tuple(OpenRateDirection(np.array(body), offset, np.array(bias)) for body, offset, bias in found["open"])
    rates = values.pop("rates")
    aligned = Keys._of(core.keys, fixed.clock, scalar_first=scalar_first) if rates is None else Rates(fixed.times(rates[0]), rates[1])
    return RateAlignment(aligned=aligned, _members=members, _summary=core.summary(), **values)


@dataclasses.dataclass(frozen=True)
class _Side:
    """A recording of the library, the clock of its caller, and the rows of the caller that it has."""

    core: Any
    clock: Clock
    epoch: str
    rows: Indices

    def times(self, seconds: Vector) -> np.ndarray[Any, Any]:
        """As the caller has those of this recording."""
        return SecondsSince.of(seconds, self.epoch) if self.clock == Clock() else self.clock.back(seconds)


def _side(name: str, one: Keys | Rates) -> _Side:
    if isinstance(one, Keys):
        return _Side(one._core, one._clock, _core.epoch_of_keys(one._core), np.arange(len(one)))
    whole = np.flatnonzero(np.isfinite(one.rates).all(axis=1))
    seconds, clock = times_of_keys(one.times[whole], None)
    epoch = clock.epoch if clock.origin else getattr(one.times, "epoch", "0")
    rates = np.ascontiguousarray(one.rates[whole], dtype=np.float64)
    return _Side(_core.Gyro(np.ascontiguousarray(seconds, dtype=np.float64), rates, epoch, clock.is_calendar), clock, epoch, whole)
