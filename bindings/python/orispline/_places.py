# SPDX-License-Identifier: Apache-2.0
"""Which of many rows in time are meant: by their places, by a mask, or from one time to another."""
from __future__ import annotations

import dataclasses
import re
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._arrays import Array, array_of
from ._checks import wrong_type
from ._clock import Clock
from ._errors import ArgumentError, DataError

Places = NDArray[np.intp]
TIME_OF_DAY = r"\d{1,2}:\d{2}(:\d{2}([.,]\d+)?)?"
ZONED = r"(.*[T ]\d{2}:?\d{2}.*?) ?(?:(Z)|([+-])(\d{2}):?(\d{2}))"


def is_place(part: Any) -> bool:
    """Whether it is one place, a whole number."""
    return isinstance(part, (int, np.integer)) and not isinstance(part, (bool, np.bool_, np.timedelta64))


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Rows:
    """Rows by their times [s], on a caller's clock, since an epoch. `what` they are called stands first in messages."""

    what: str
    seconds: Array
    clock: Clock
    epoch: str

    def place(self, part: Any) -> int:
        """Of a whole number, which counts from the end where it is below 0."""
        count = len(self.seconds)
        if not -count <= part < count:
            raise IndexError(f"{self.what}: found the place {part}, wanted one of {count}, from {-count} to {count - 1}")
        return int(part) % count

    def places(self, part: Any, *, rising: bool) -> Places:
        """Of a place, of a slice of places or of times, of a mask or of indices, which rise where they are to."""
        count = len(self.seconds)
        if is_place(part):
            return np.array([self.place(part)])
        if isinstance(part, slice):
            if not all(bound is None or is_place(bound) for bound in (part.start, part.stop)):
                return self._between(part)
            if rising and part.step is not None and part.step < 0:
                raise ArgumentError(f"{self.what}: found the step {part.step}, wanted one above 0, since times rise")
            found = np.arange(*part.indices(count))
            if rising and not len(found):
                shown = ":".join("" if bound is None else str(bound) for bound in (part.start, part.stop))
                raise DataError(f"{self.what}: found no {self.what} at the places {shown} of {count}, wanted one at least: "
                                f"whole numbers are places, times have a point, such as {self.what}[2.0:5.0]")
            return found
        array = array_of(self.what, part)
        if array.shape == (0,):
            return np.zeros(0, np.intp)
        if array.ndim != 1 or array.dtype.kind not in "biu":
            raise wrong_type(self.what, part, f"a place such as {self.what}[3], a slice such as {self.what}[2:5] or "
                             f"{self.what}['10:00':'10:05'], a mask, or {'rising ' * rising}indices")
        if array.dtype.kind == "b" and len(array) != count:
            raise ArgumentError(f"{self.what}: found a mask of {len(array)}, wanted one of {count}")
        indices: Places = np.flatnonzero(array) if array.dtype.kind == "b" else np.where(array < 0, array + count, array).astype(np.intp)
        if ((indices < 0) | (indices >= count)).any() or rising and (np.diff(indices) <= 0).any():
            raise ArgumentError(f"{self.what}: found indices that do not {'rise' if rising else 'lie'} within the {count} {self.what}, "
                                "wanted such as [0, 2, 5]")
        return indices

    def _between(self, part: slice) -> Places:
        """From one time to another, without that."""
        if part.step is not None:
            raise ArgumentError(f"{self.what}: found the step {part.step!r} in a slice of times, wanted none: a second slice "
                                f"such as {self.what}[…][::2] takes every second of them")
        if not len(self.seconds):
            raise DataError(f"{self.what}: found none from {part.start} to {part.stop}, since there are none at all, wanted some")
        start = -np.inf if part.start is None else self._seconds(part.start, float(self.seconds[0]))
        stop = np.inf if part.stop is None else self._seconds(part.stop, float(self.seconds[0]) if part.start is None else start)
        found = np.flatnonzero((self.seconds >= start) & (self.seconds < stop))
        if not len(found):
            raise DataError(f"{self.what}: found none from {part.start} to {part.stop}, wanted times of theirs, {self.clock.span(self.seconds)}: "
                            "the end of a slice is not in it")
        return found

    def _seconds(self, bound: Any, day: float) -> float:
        """A time as the library has it; a time of day alone is of the day of that time [s]."""
        if isinstance(bound, str):
            return self._of_stamp(self._stamp(bound, day))
        array = array_of(self.what, bound)
        if array.dtype.kind == "M" and self._counts_from_an_epoch:
            found = self._of_stamp(array[()])
        else:
            found = float(self.clock.seconds(self.what, bound)) if array.ndim == 0 else np.nan
        if not np.isfinite(found):
            raise ArgumentError(f"{self.what}: found {bound!r} in a slice, wanted a time")
        return found

    @property
    def _counts_from_an_epoch(self) -> bool:
        """Whether plain seconds are since a time that is known, such as that of the first key of a file."""
        return self.clock == Clock() and self.epoch != "0"

    def _stamp(self, text: str, day: float) -> np.datetime64:
        if not self.clock.is_calendar and not self._counts_from_an_epoch:
            kind = "durations such as numpy.timedelta64(5, 's')" if self.clock.kind else "numbers"
            raise ArgumentError(f"{self.what}: found the text {text!r} in a slice, wanted {kind}, as the times are")
        words, late = text.strip(), np.timedelta64(0, "m")
        if re.fullmatch(TIME_OF_DAY, words):
            import decimal
            whole = int((decimal.Decimal(self.epoch) + decimal.Decimal(day)).to_integral_value(decimal.ROUND_FLOOR))
            words = f"{np.datetime64(whole, 's').astype('M8[D]')}T{words.rjust(len(words) + 2 - words.index(':'), '0')}"
        zoned = re.fullmatch(ZONED, words)
        if zoned:
            words, utc, sign, hours, minutes = zoned.groups()
            late = np.timedelta64(0 if utc else int(sign + "1") * (60 * int(hours) + int(minutes)), "m")
        try:
            return np.datetime64(words.replace(",", ".")) - late
        except ValueError:
            raise ArgumentError(f"{self.what}: found the text {text!r} in a slice, wanted a date such as '2026-11-28T10:00', or a time of day "
                                "such as '10:05'") from None

    def _of_stamp(self, stamp: Any) -> float:
        """Exact until the last step: differences are taken of decimals."""
        import decimal
        if np.isnat(stamp):
            return np.nan
        whole = stamp.astype("M8[s]")
        rest = (stamp - whole).astype("m8[ns]").astype(np.int64)
        return float(int(whole.astype(np.int64)) + decimal.Decimal(int(rest)).scaleb(-9) - decimal.Decimal(self.epoch))
