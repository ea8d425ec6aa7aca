# SPDX-License-Identifier: Apache-2.0
"""Times of callers, as seconds of the library and back."""
from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ._arrays import Array, array_of, found, numbers
from ._errors import ArgumentError, DataError

DIGITS = {"s": 0, "ms": 3, "us": 6, "ns": 9}
PER_SECOND = {unit: 10**digits for unit, digits in DIGITS.items()}
LARGEST_PLAIN_INTEGER = 10**14  # larger ones can hardly be seconds


@dataclasses.dataclass(frozen=True)
class Clock:
    """How a caller has times: as seconds, or counted in whole units from an origin, which may be a datetime64's."""

    unit: str = "s"
    origin: int = 0  # in the unit; differences are taken of integers, before anything becomes a double
    is_calendar: bool = False

    @property
    def epoch(self) -> str:
        """What seconds count from [s], exact: of a calendar since 1970-01-01."""
        import decimal
        return f"{decimal.Decimal(self.origin).scaleb(-DIGITS[self.unit]):f}"

    def seconds(self, name: str, times: Any) -> Array:
        """Times to ask for, of any shape. NaT becomes NaN."""
        array = array_of(name, times)
        if self.is_calendar != (array.dtype.kind == "M"):
            wanted = "datetime64" if self.is_calendar else "numbers"
            raise ArgumentError(f"{name}: found {found(array)}, wanted {wanted}, as the times of the keys are")
        if self.is_calendar:
            stamps = array.astype("datetime64[ns]")
            return np.where(np.isnat(stamps), np.nan, self._counted(stamps.astype(np.int64)))
        if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
            raise ArgumentError(f"{name}: found {found(array)}, wanted real numbers")
        return np.asarray(self._counted(array), order="C")

    def back(self, seconds: Array) -> np.ndarray[Any, Any]:
        """Seconds of the library as the caller has times: whole nanoseconds, else floats in the unit."""
        if self.unit == "s":
            return seconds
        units: np.ndarray[Any, Any] = seconds * PER_SECOND[self.unit]
        if self.unit == "ns":
            units = np.rint(units).astype(np.int64)
        return (units + self.origin).astype("datetime64[ns]") if self.is_calendar else units + self.origin

    def time(self, seconds: float) -> Any:
        """One time of the library as the caller has it, no array."""
        time = self.back(np.array([seconds]))[0]
        return time if self.is_calendar else time.item()

    def ends(self, domain: tuple[float, float]) -> tuple[Any, Any]:
        """The first and the last time."""
        first, last = self.back(np.array(domain))
        return (first, last) if self.is_calendar else (float(first), float(last))

    def span(self, seconds: Array) -> str:
        """From the first to the last of these times, for people to read."""
        first, last = self.back(seconds[[0, -1]])
        return f"{first} … {last}" if self.is_calendar else f"{first:g} … {last:g} {self.unit}"

    def check_inside(self, seconds: Array, domain: tuple[float, float]) -> None:
        """Raises an error about the first time outside, where times are not seconds: about those the library has one."""
        outside = np.flatnonzero((seconds < domain[0]) | (seconds > domain[1]))
        if self.unit != "s" and len(outside):
            time, first, last = self.back(np.array([seconds.reshape(-1)[outside[0]], *domain]))
            error = ArgumentError(f"time {outside[0]}: time {time} is outside the curve, wanted {first} to {last}")
            error.time_index = int(outside[0])
            raise error

    def _counted(self, array: np.ndarray[Any, Any]) -> Array:
        if self.unit == "s":
            return array.astype(np.float64, copy=False)
        since: np.ndarray[Any, Any] = array.astype(np.int64) - self.origin if array.dtype.kind in "iu" else array - float(self.origin)
        seconds: Array = since.astype(np.float64) / PER_SECOND[self.unit]
        return seconds


def times_of_keys(times: Any, unit: str | None) -> tuple[Array, Clock]:
    """The times of keys [s], and the clock by which the caller has them."""
    if unit is not None and unit not in PER_SECOND:
        raise ArgumentError(f"time_unit: found {unit!r}, wanted one of {', '.join(map(repr, PER_SECOND))}")
    array = array_of("times", times)
    if array.dtype.kind == "M":
        if unit is not None:
            raise ArgumentError("time_unit: found it with datetime64, which has a unit of its own")
        stamps = _stamps(array)
        clock = Clock("ns", int(stamps[0]) if len(stamps) else 0, is_calendar=True)
        return clock._counted(stamps), clock
    seconds = numbers("times", array, (None,))
    if array.dtype.kind not in "iu" or unit in (None, "s"):
        if unit not in (None, "s"):
            raise ArgumentError(f"time_unit: found {unit!r} with {array.dtype}, wanted integers, or seconds without a unit")
        if array.dtype.kind in "iu" and unit is None and len(array) and np.abs(seconds).max() > LARGEST_PLAIN_INTEGER:
            raise ArgumentError("times: found integers above 1e14, wanted time_unit='ns', 'us', 'ms' or 's' with them")
        return seconds, Clock()
    clock = Clock(str(unit), int(array[0]) if len(array) else 0)
    return clock._counted(array), clock


def _stamps(array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Nanoseconds of datetime64 in one dimension."""
    missing = np.isnat(array)
    stamps = array.astype("datetime64[ns]").astype(np.int64)
    numbers("times", stamps, (None,))
    if missing.any():
        error = DataError(f"key {int(missing.argmax())}: found NaT, wanted a time")
        error.key = int(missing.argmax())
        raise error
    return stamps
