# SPDX-License-Identifier: Apache-2.0
"""Times of tables: seconds of the library and back, and the type that holds those of a result."""
from __future__ import annotations

import dataclasses
import fractions
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from .._errors import ArgumentError, tell
from ._kinds import plain_type, shown

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]
NANOSECONDS = {"s": 10**9, "ms": 10**6, "us": 10**3, "ns": 1}
MOST_ROUNDED = fractions.Fraction(1, 1000)  # of a step, where no unit holds it and microseconds do


def has_unit(kind: Any) -> bool:
    """Whether times count a unit: timestamps and durations."""
    return bool(pa.types.is_timestamp(kind) or pa.types.is_duration(kind))


def in_unit(kind: Any, unit: str) -> Any:
    """Such a type with another unit."""
    return pa.timestamp(unit, kind.tz) if pa.types.is_timestamp(kind) else pa.duration(unit)


def result_type(kind: Any, step: fractions.Fraction | None, finest: str = "ns") -> Any:
    """Of times that are whole numbers of steps [s] behind those of keys: never coarser than these, and as fine as the step needs.

    A step that no unit holds, such as 1/30 s, is rounded to microseconds, or to nanoseconds where it is short.
    """
    if step is None:
        return kind
    if not has_unit(kind):
        return pa.float64()
    units = [unit for unit, length in NANOSECONDS.items() if NANOSECONDS[finest] <= length <= NANOSECONDS[kind.unit]]
    for unit in units:
        length = fractions.Fraction(NANOSECONDS[unit], 10**9)
        if (step / length).denominator == 1 or unit == "us" and length / 2 <= step * MOST_ROUNDED:
            return in_unit(kind, unit)
    return in_unit(kind, units[-1] if units else kind.unit)


def tell_of_types(name: str, given: Any, read: Any, step: fractions.Fraction | None, finest: str = "ns") -> None:
    """Warns where the times of a result are of another type than those of the keys, or are rounded because there is none."""
    made = result_type(read, step, finest)
    if made != plain_type(given):
        why = "as which such times are read" if made == read else f"as {read} its times would be rounded"
        tell([(f"the column {name!r} of the result is {made}, that of the keys {given}: {why}", "time_type", {})])
    if made != result_type(read, step):
        tell([(f"the stamps in the column {name!r} are rounded to {made}, since Spark has none that are finer, wanted steps of whole "
               "microseconds or float seconds", "rounded_times", {})])


@dataclasses.dataclass(frozen=True)
class Times:
    """A column of times: floats [s], or stamps, of which each track has an origin: differences are taken of integers.

    `made` is the type of the times that come back. `period` is the shortest whole number of seconds with whole samples,
    where grids lie at multiples of 1/rate: origins are multiples of it then, so that a track has the same times wherever
    it begins.
    """

    kind: Any
    made: Any
    period: int = 0

    def seconds(self, column: Any, starts: Whole, origins: Whole | None = None) -> tuple[Floats, Whole]:
        """The times of tracks that begin in these rows [s], and the origins of the tracks, all 0 of floats."""
        if not has_unit(self.kind):
            return number_column(column), np.zeros(len(starts), np.int64)
        missing = column.is_null().to_numpy(zero_copy_only=False) if column.null_count else None
        stamps = pc.fill_null(column.cast(pa.int64()), 0).to_numpy(zero_copy_only=False)
        origins = self.origins(stamps[starts]) if origins is None else origins
        begun = np.repeat(origins, np.diff(np.append(starts, len(stamps))))
        seconds, far = self.seconds_of(stamps - begun), stamps.astype(np.float64) - begun
        has_room = np.abs(far) < 2.0**63  # for the difference; nanoseconds of centuries have none
        seconds[~has_room] = far[~has_room] * (NANOSECONDS[self.kind.unit] / 1e9)
        if missing is not None:
            seconds[missing] = np.nan
        return seconds, origins

    def origins(self, first: Whole) -> Whole:
        """Of tracks with these first stamps."""
        if not self.period:
            return first
        step = self.period * (10**9 // NANOSECONDS[self.kind.unit])
        return first // step * step

    def seconds_of(self, units: Whole) -> Floats:
        """Seconds of a difference: by way of nanoseconds, as `Keys` has them, so that the bits are the same."""
        scale = NANOSECONDS[self.kind.unit]
        if len(units) and max(abs(int(units.max())), abs(int(units.min()))) < 2**63 // scale:
            return (units * scale).astype(np.float64) / 1e9
        return units.astype(np.float64) / (10**9 // scale)

    def back(self, seconds: Floats, origins: Whole) -> Any:
        """A column of times; an origin for each."""
        if not has_unit(self.kind):
            return pa.array(seconds, self.made)
        return pa.array(self.units(seconds, origins)).cast(self.made)

    def units(self, seconds: Floats, origins: Whole) -> Whole:
        """Stamps as whole numbers in the unit of what comes back; an origin for each."""
        since = np.rint(seconds * (10**9 // NANOSECONDS[self.made.unit]))
        since = np.where(since < 2.0**63, since, since - 2.0**64)  # what is added wraps round, as differences of centuries do
        return since.astype(np.int64) + origins * self._finer

    def without_room(self, column: Any) -> Whole:
        """The rows whose stamps the type of the result cannot have."""
        if not has_unit(self.kind) or self._finer == 1:
            return np.zeros(0, np.int64)
        stamps, most = pc.fill_null(column.cast(pa.int64()), 0).to_numpy(zero_copy_only=False), (2**63 - 1) // self._finer
        return np.flatnonzero((stamps > most) | (stamps < -most))

    @property
    def _finer(self) -> int:
        return NANOSECONDS[self.kind.unit] // NANOSECONDS[self.made.unit]


def common_type(kind: Any, other: Any) -> Any:
    """The type of times that can hold those of both. Raises ArgumentError where one counts seconds and the other has dates, or one has a
    time zone and the other has none."""
    if not has_unit(kind) and not has_unit(other):
        return pa.float64()
    if pa.types.is_timestamp(kind) != pa.types.is_timestamp(other) or pa.types.is_duration(kind) != pa.types.is_duration(other):
        raise ArgumentError(f"found times of type {kind} and {other}, wanted float seconds in both tables, or timestamps, or durations")
    if pa.types.is_timestamp(kind) and (kind.tz is None) != (other.tz is None):
        raise ArgumentError(f"found times of type {kind} and {other}, wanted timestamps with a time zone in both tables or in neither: give "
                            "those without one the zone that they are of")
    return in_unit(kind, min(kind.unit, other.unit, key=NANOSECONDS.__getitem__))


def period_of(rate: str) -> int:
    """The shortest whole number of seconds in which a rate has a whole number of samples."""
    return fractions.Fraction(rate).denominator


def number_column(column: Any) -> Floats:
    """Numbers of a column, NaN where there are none."""
    if column.type != pa.float64():
        column = column.cast(pa.float64(), safe=False)  # whole numbers above 2^53 to the nearest
    if column.null_count:
        column = pc.fill_null(column, np.nan)
    return np.asarray(column.to_numpy(zero_copy_only=False))


def too_far(name: str, value: Any, made: Any) -> str:
    """What is said of a track with a time which the type of the result cannot have."""
    return (f"found {shown(value)} in the column {name!r}, wanted a time that {made} has room for, which these samples need: choose another "
            "rate, whose steps are whole in a longer unit")


def absent(name: str, numbers: dict[str, float], what: str = "null") -> str:
    """What is said of a track with a row that has no time, which is found by its other values."""
    row = ", ".join(f"{each} {value!r}" for each, value in numbers.items())
    return f"found {what} in the column {name!r}, wanted a time in every row: see the row with {row}"
