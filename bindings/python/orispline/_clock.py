# SPDX-License-Identifier: Apache-2.0
"""Times of callers, as seconds of the library and back."""
from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from ._arrays import Array, array_of, found, numbers
from ._errors import ArgumentError, DataError, at_key
from ._stamps import DIGITS, PER_SECOND, ROOM, UNITS_OF_STAMPS, about

STAMPS = {"M": "datetime64", "m": "timedelta64"}  # by NumPy's kinds
LARGEST_PLAIN_INTEGER = 10**14  # larger ones can hardly be seconds


class SecondsSince(np.ndarray[Any, Any]):
    """Seconds that remember what they count from, exact, so that keys of them stand where those were which they are from."""

    epoch: str

    @classmethod
    def of(cls, seconds: Array, epoch: str) -> np.ndarray[Any, Any]:
        """Plain seconds where they count from 0."""
        if epoch == "0":
            return seconds
        times = seconds.view(cls)
        times.epoch = epoch
        return times

    def __array_finalize__(self, other: Any) -> None:
        self.epoch = getattr(other, "epoch", "0")

    def __array_wrap__(self, array: Any, context: Any = None, return_scalar: bool = False) -> Any:
        if array.ndim == 0:
            return array[()]
        return SecondsSince.of(array, self.epoch) if array.dtype.kind == "f" else np.asarray(array)

    def __repr__(self) -> str:
        return repr(np.asarray(self))

    def __reduce__(self) -> Any:
        return SecondsSince.of, (np.asarray(self), self.epoch)


@dataclasses.dataclass(frozen=True)
class Clock:
    """How a caller has times: as seconds, or counted in whole units from an origin, which may be those of NumPy's stamps."""

    unit: str = "s"
    origin: int = 0  # in the unit; differences are taken of integers, before anything becomes a double
    kind: str = ""  # "M" of datetime64, "m" of timedelta64, empty of numbers

    @property
    def is_calendar(self) -> bool:
        """Whether times are dates."""
        return self.kind == "M"

    @property
    def word(self) -> str:
        """What its times are, for messages."""
        return {"M": "dates", "m": "durations"}.get(self.kind, "numbers")

    @property
    def epoch(self) -> str:
        """What seconds count from [s], exact: of a calendar since 1970-01-01."""
        import decimal
        return f"{decimal.Decimal(self.origin).scaleb(-DIGITS[self.unit]):f}"

    def seconds(self, name: str, times: Any) -> Array:
        """Times to ask for, of any shape. NaT becomes NaN."""
        array = array_of(name, times)
        if self.kind != (array.dtype.kind if array.dtype.kind in STAMPS else ""):
            raise ArgumentError(f"{name}: found {found(array)}, wanted {STAMPS.get(self.kind, 'numbers')}, as the times of the keys are")
        if self.kind:
            return self._since(name, array)
        if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
            raise ArgumentError(f"{name}: found {found(array)}, wanted real numbers")
        return np.asarray(self._counted(array), order="C")

    def back(self, seconds: Array) -> np.ndarray[Any, Any]:
        """Seconds of the library as the caller has times: stamps, whole nanoseconds, else floats in the unit."""
        if self.unit == "s":
            return seconds
        if self.kind:
            return self._stamps(seconds)
        units: np.ndarray[Any, Any] = seconds * PER_SECOND[self.unit]
        if self.unit != "ns" or not (np.abs(units + float(self.origin)) < ROOM).all():
            return units + self.origin
        whole: np.ndarray[Any, Any] = np.rint(units).astype(np.int64)
        return whole + self.origin

    def time(self, seconds: float) -> Any:
        """One time of the library as the caller has it, no array."""
        time = self.back(np.array([seconds]))[0]
        return time if self.kind else time.item()

    def ends(self, domain: tuple[float, float]) -> tuple[Any, Any]:
        """The first and the last time."""
        return self.time(domain[0]), self.time(domain[1])

    def charted(self, seconds: Array) -> np.ndarray[Any, Any]:
        """Times for the axis of a chart, which has no durations: these are seconds there."""
        return seconds + self.origin / PER_SECOND[self.unit] if self.kind == "m" else self.back(seconds)

    @property
    def axis(self) -> str:
        """What such an axis is called."""
        return "time" if self.is_calendar else f"time [{'s' if self.kind else self.unit}]"

    def span(self, seconds: Array) -> str:
        """From the first to the last of these times, for people to read."""
        ends = seconds[[0, -1]]
        if self.is_calendar:
            return " … ".join(str(time) for time in self.back(ends))
        first, last = _told_apart(*(time.item() for time in (self.charted(ends) if self.kind else self.back(ends))))
        return f"{first} … {last} {'s' if self.kind else self.unit}"

    def check_series(self, seconds: Array) -> None:
        """Raises DataError where such times of a series [s] are not finite, or decrease."""
        bad = ~np.isfinite(seconds)
        if bad.any():
            raise DataError(f"times: found {seconds[bad][0]} at index {int(bad.argmax())}, wanted finite times")
        falls = np.diff(seconds) < 0
        if falls.any():
            at = int(falls.argmax())
            before, after = self.back(seconds[at:at + 2])
            shown = [f"{time:.17g}" if isinstance(time, float) else str(time) for time in (after, before)]
            raise DataError(f"times: found {shown[0]} after {shown[1]} at index {at + 1}, wanted times that do not decrease")

    def check_inside(self, seconds: Array, domain: tuple[float, float]) -> None:
        """Raises an error about the first time outside, where times are not seconds: about those the library has one."""
        outside = np.flatnonzero((seconds < domain[0]) | (seconds > domain[1]))
        if self.unit != "s" and len(outside):
            time, first, last = self.back(np.array([seconds.reshape(-1)[outside[0]], *domain]))
            error = ArgumentError(f"time {outside[0]}: time {time} is outside the curve, wanted {first} to {last}")
            error.time_index = int(outside[0])
            raise error

    def check_met(self, seconds: Array, domain: tuple[float, float]) -> None:
        """Raises an error where no time of a reference is inside, where times are not seconds: about those the library has one."""
        if self.unit != "s" and not ((seconds >= domain[0]) & (seconds <= domain[1])).any():
            start, end, first, last = self.back(np.array([*seconds[[0, -1]], *domain]))
            raise DataError(f"reference: none of the {len(seconds)} times, {start} to {end}, lies between the keys, {first} to {last}")

    def check_rising(self, seconds: Array) -> None:
        """Raises an error about the first time that does not come after the one before it, where times are not seconds: about those
        the library has one."""
        if self.unit == "s":
            return
        for key in np.flatnonzero(np.diff(seconds) <= 0)[:1] + 1:
            self.check_after(int(key), float(seconds[key]), float(seconds[key - 1]))

    def check_after(self, key: int, time: float, before: float) -> None:
        """Raises it about a key and the one before it."""
        if self.unit == "s" or time > before:
            return
        this, last = self.back(np.array([time, before]))
        what = f"duplicate time {this}" if time == before else f"time {this} comes after {last}"
        raise at_key(key, f"{what}, wanted strictly increasing times")

    def _counted(self, array: np.ndarray[Any, Any]) -> Array:
        if self.unit == "s":
            return array.astype(np.float64, copy=False)
        since: np.ndarray[Any, Any] = array.astype(np.int64) - self.origin if array.dtype.kind in "iu" else array - float(self.origin)
        seconds: Array = since.astype(np.float64) / PER_SECOND[self.unit]
        return seconds

    def _since(self, name: str, stamps: np.ndarray[Any, Any]) -> Array:
        """Seconds of stamps: by whole units where there is room for them, else by floats. NaT becomes NaN."""
        if self.origin >= 0 and stamps.dtype == f"{self.kind}8[{self.unit}]":
            whole = stamps.astype(np.int64)
            if not (whole < self.origin - (2**63 - 1)).any():  # as NaT is, and all that is too far before
                return np.asarray(self._counted(whole), order="C")
        roughly, per_second = about(name, stamps), PER_SECOND[self.unit]
        since = roughly - self.origin / per_second
        has_room = np.maximum(np.abs(roughly), np.abs(since)) < ROOM / per_second
        if not has_room.all():
            stamps = np.where(has_room, stamps, np.zeros((), stamps.dtype))
        counted = self._counted(stamps.astype(f"{self.kind}8[{self.unit}]").astype(np.int64))
        return np.asarray(counted if has_room.all() else np.where(has_room, counted, since), order="C")

    def _stamps(self, seconds: Array) -> np.ndarray[Any, Any]:
        """In the unit of the clock, or in the first longer one that has room for all."""
        largest = np.nanmax(np.abs(seconds), initial=0.0) + abs(self.origin) / PER_SECOND[self.unit]
        units = UNITS_OF_STAMPS[UNITS_OF_STAMPS.index(self.unit):]
        unit = next((unit for unit in units if largest * PER_SECOND[unit] < ROOM), units[-1])
        missing = np.isnan(seconds)
        whole: np.ndarray[Any, Any] = np.rint(np.where(missing, 0.0, seconds) * PER_SECOND[unit]).astype(np.int64)
        whole += self.origin // (PER_SECOND[self.unit] // PER_SECOND[unit])
        stamps: np.ndarray[Any, Any] = whole.astype(f"{self.kind}8[{unit}]")
        stamps[missing] = np.array("NaT", stamps.dtype)
        return stamps


def times_of_keys(times: Any, unit: str | None, *, jumps: bool = False) -> tuple[Array, Clock]:
    """The times of keys [s], and the clock by which the caller has them."""
    if unit is not None and (not isinstance(unit, str) or unit not in PER_SECOND):
        raise ArgumentError(f"time_unit: found {unit!r}, wanted one of {', '.join(map(repr, PER_SECOND))}")
    array = array_of("times", times)
    if array.dtype.kind in STAMPS and unit is not None:
        raise ArgumentError(f"time_unit: found it with {STAMPS[array.dtype.kind]}, which has a unit of its own")
    seconds, clock = clock_of_stamps(array) if array.dtype.kind in STAMPS else _of_numbers(array, unit)
    if not jumps:
        clock.check_rising(seconds)
    return seconds, clock


def _of_numbers(array: np.ndarray[Any, Any], unit: str | None) -> tuple[Array, Clock]:
    seconds = numbers("times", array, (None,))
    if array.dtype.kind in "iu" and unit not in (None, "s"):
        clock = Clock(str(unit), int(array[0]) if len(array) else 0)
        return clock._counted(array), clock
    if unit not in (None, "s"):
        raise ArgumentError(f"time_unit: found {unit!r} with {array.dtype}, wanted integers, or seconds without a unit")
    if array.dtype.kind in "iu" and unit is None and len(array) and np.abs(seconds).max() > LARGEST_PLAIN_INTEGER:
        raise ArgumentError("times: found integers above 1e14, wanted time_unit='ns', 'us', 'ms' or 's' with them")
    return seconds, Clock()


def clock_of_stamps(stamps: np.ndarray[Any, Any]) -> tuple[Array, Clock]:
    """Stamps in one dimension as seconds since the first, and the clock that counts so."""
    roughly = about("times", stamps)
    numbers("times", roughly, (None,))
    if np.isnan(roughly).any():
        raise at_key(int(np.isnan(roughly).argmax()), "found NaT, wanted a time")
    largest = max(np.abs(roughly).max(initial=0.0), np.ptp(roughly) if len(roughly) else 0.0)
    units = [unit for unit in UNITS_OF_STAMPS if largest * PER_SECOND[unit] < ROOM]
    if not units:
        raise ArgumentError("times: found stamps more than 292 million years apart, wanted less")
    first = stamps[:1].astype(f"{stamps.dtype.kind}8[{units[0]}]").astype(np.int64)
    clock = Clock(units[0], int(first[0]) if len(first) else 0, stamps.dtype.kind)
    return clock._since("times", stamps), clock


def _told_apart(first: Any, last: Any) -> tuple[str, str]:
    """Two numbers with as few digits as tell them apart, six at least."""
    if isinstance(first, int):
        return str(first), str(last)
    texts = [(f"{first:.{digits}g}", f"{last:.{digits}g}") for digits in (6, 9, 12, 15, 17)]
    return next((pair for pair in texts if first == last or pair[0] != pair[1]), texts[-1])
