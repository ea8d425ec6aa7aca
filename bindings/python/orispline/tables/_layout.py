# SPDX-License-Identifier: Apache-2.0
"""What the columns of a table of keys mean, and how they come to the library and back."""
from __future__ import annotations

import dataclasses
import fractions
from collections.abc import Sequence
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc
from numpy.typing import NDArray

from .._checks import wrong_type
from .._errors import ArgumentError, DataError

Floats = NDArray[np.float64]
Whole = NDArray[np.int64]
NANOSECONDS = {"s": 10**9, "ms": 10**6, "us": 10**3, "ns": 1}
UNIT_QUATERNION = ("qx", "qy", "qz", "qw")


@dataclasses.dataclass(frozen=True)
class Layout:
    """The columns of keys by name: those that tell tracks apart, the time, and x, y, z, w of quaternions."""

    by: tuple[str, ...]
    time: str
    quaternion: tuple[str, ...]
    position: tuple[str, ...] = ()

    @property
    def names(self) -> list[str]:
        """All of them, in this order."""
        return [*self.by, self.time, *self.numbers]

    @property
    def numbers(self) -> list[str]:
        """Those of quaternions and positions."""
        return [*self.quaternion, *self.position]

    @property
    def order(self) -> list[str]:
        """Those that rows are put in order by."""
        return [*self.by, self.time]

    def check(self, schema: Any, what: str = "source") -> None:
        """Raises ArgumentError where a column is missing or of a type that it cannot have."""
        for name in self.names:
            if schema.names.count(name) != 1:
                found = ", ".join(map(repr, schema.names)) or "none"
                raise ArgumentError(f"{what}: found the columns {found}, wanted {name!r} once: name the columns by by=, time=, "
                                    "quaternion= and position=")
        for name in self.by:
            check_id_type(what, name, schema.field(name).type)
        if self.time:
            time_type(what, self.time, schema.field(self.time).type)
        for name in self.numbers:
            found = schema.field(name).type
            if not (pa.types.is_floating(found) or pa.types.is_integer(found)):
                raise ArgumentError(f"{what}: found {found} in the column {name!r}, wanted numbers")


@dataclasses.dataclass(frozen=True)
class SetLayout(Layout):
    """The columns of rows that are a set where `time` is empty, and may have a weight."""

    weight: tuple[str, ...] = ()

    @property
    def ids(self) -> list[str]:
        """Those of groups, and of times where they count."""
        return [*self.by, *([self.time] if self.time else [])]

    @property
    def names(self) -> list[str]:
        """All of them, in this order."""
        return [*self.ids, *self.numbers]

    @property
    def order(self) -> list[str]:
        """Those that rows are put in order by, so that a set has the same bits however its rows came."""
        return [*self.by, self.time or self.quaternion[0]]

    @property
    def numbers(self) -> list[str]:
        """Those of quaternions, positions and weights."""
        return [*self.quaternion, *self.position, *self.weight]


def layout(by: Any, time: Any, quaternion: Any, position: Any) -> Layout:
    """Of arguments. Raises TypeError and ArgumentError."""
    made = Layout(_names("by", by, None), _names("time", time, 1)[0], *_of_poses(quaternion, position))
    _check_named_once(made, "by, time, quaternion and position")
    return made


def set_layout(by: Any, time: Any, quaternion: Any, position: Any, weight: Any) -> SetLayout:
    """Of arguments, of which time and weight may be None. Raises TypeError and ArgumentError."""
    made = SetLayout(_names("by", by, None), "" if time is None else _names("time", time, 1)[0], *_of_poses(quaternion, position),
                     () if weight is None else _names("weight", weight, 1))
    _check_named_once(made, "by, time, quaternion, position and weight")
    return made


def _of_poses(quaternion: Any, position: Any) -> tuple[tuple[str, ...], tuple[str, ...]]:
    return _names("quaternion", quaternion, 4), () if position is None else _names("position", position, 3)


def _check_named_once(columns: Layout, arguments: str) -> None:
    twice = sorted({name for name in columns.names if columns.names.count(name) > 1})
    if twice:
        raise ArgumentError(f"found the column {twice[0]!r} named twice, wanted a column for each of {arguments}")


def _names(argument: str, names: Any, count: int | None) -> tuple[str, ...]:
    listed = (names,) if isinstance(names, str) else tuple(names) if isinstance(names, (list, tuple)) else ()
    if not listed or not all(isinstance(name, str) for name in listed):
        raise wrong_type(argument, names, "the name of a column" if count == 1 else "names of columns")
    if count is not None and len(listed) != count:
        raise ArgumentError(f"{argument}: found {len(listed)} names, wanted {count}" + (": x, y, z, w" if count == 4 else ""))
    return listed


def check_id_type(what: str, name: str, found: Any) -> None:
    """Ids are compared and put in order."""
    if pa.types.is_nested(found) or pa.types.is_null(found) or pa.types.is_float16(found):
        raise ArgumentError(f"{what}: found {found} in the column {name!r}, wanted ids that can be put in order, such as numbers "
                            "or strings")


def time_type(what: str, name: str, found: Any) -> Any:
    """The type of a column of times, if it is one."""
    if pa.types.is_float64(found) or pa.types.is_float32(found) or pa.types.is_timestamp(found):
        return found
    cure = "cast it to float64 if it counts seconds, else to a timestamp" if pa.types.is_integer(found) else "cast it"
    raise ArgumentError(f"{what}: found {found} in the column {name!r}, wanted float seconds or timestamps: {cure}")


def number_column(column: Any) -> Floats:
    """Numbers of a column, NaN where there are none."""
    if column.type != pa.float64():
        column = column.cast(pa.float64(), safe=False)  # whole numbers above 2^53 to the nearest
    if column.null_count:
        column = pc.fill_null(column, np.nan)
    return np.asarray(column.to_numpy(zero_copy_only=False))


def converted(column: Any, kind: Any, place: str, name: str, first_row: int = 0) -> Any:
    """A column as another type, that of the same column elsewhere. Raises DataError for the first value which that has no room for,
    and ArgumentError where it has none like it; the column begins in that row of the place."""
    if column.type == kind:
        return column
    try:
        return column.cast(kind)
    except pa.ArrowNotImplementedError:
        raise ArgumentError(f"{place}: found {column.type} in the column {name!r}, which is {kind} elsewhere, wanted one type for "
                            "both: cast one of them") from None
    except pa.ArrowInvalid:
        row = _first_without_room(column, kind)
    raise DataError(f"{place}: found {_shown(column[row])} in row {first_row + row} of the column {name!r}, wanted what {kind} has room "
                    f"for, which is its type elsewhere: cast both columns to one type that has room for all, or leave the row out")


def _first_without_room(column: Any, kind: Any) -> int:
    """The row of the first value that cannot be of that type, by halves."""
    first, end = 0, len(column)
    while end - first > 1:
        middle = (first + end) // 2
        try:
            column.slice(first, middle - first).cast(kind)
            first = middle
        except pa.ArrowInvalid:
            end = middle
    return first


def _shown(value: Any) -> str:
    """A value for people to read; stamps beyond the years of Python's dates as what they count."""
    try:
        return str(value.as_py())
    except (OverflowError, ValueError):
        return f"{value.value} {value.type.unit} since 1970"


def plain(column: Any) -> Any:
    """A column of the values themselves: dictionaries and runs written out."""
    if pa.types.is_dictionary(column.type):
        return column.dictionary_decode()
    return column


def plain_type(kind: Any) -> Any:
    """The type of such a column."""
    return kind.value_type if pa.types.is_dictionary(kind) else kind


@dataclasses.dataclass(frozen=True)
class Times:
    """A column of times: floats [s], or stamps, of which each track has an origin: differences are taken of integers.

    `period` is the shortest whole number of seconds with whole samples, where grids lie at multiples of 1/rate: origins
    are multiples of it then, so that a track has the same times wherever it begins.
    """

    kind: Any
    period: int = 0

    @property
    def is_calendar(self) -> bool:
        return bool(pa.types.is_timestamp(self.kind))

    def finer(self, other: Any) -> Any:
        """The type of times that can hold both. Raises ArgumentError where one counts seconds and the other has dates."""
        if self.is_calendar != bool(pa.types.is_timestamp(other)):
            raise ArgumentError(f"found times of type {self.kind} and {other}, wanted float seconds in both tables, or timestamps")
        if not self.is_calendar:
            return pa.float64()
        units = sorted((self.kind.unit, other.unit), key=NANOSECONDS.__getitem__)
        return pa.timestamp(units[0], self.kind.tz)

    def seconds(self, column: Any, starts: Whole, origins: Whole | None = None) -> tuple[Floats, Whole]:
        """The times of tracks that begin in these rows [s], and the origins of the tracks, all 0 of floats."""
        if not self.is_calendar:
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
        if not self.is_calendar:
            return pa.array(seconds, self.kind)
        return pa.array(self.units(seconds, origins)).cast(self.kind)

    def units(self, seconds: Floats, origins: Whole) -> Whole:
        """Stamps as whole numbers; an origin for each."""
        since = np.rint(seconds * (10**9 // NANOSECONDS[self.kind.unit]))
        since = np.where(since < 2.0**63, since, since - 2.0**64)  # what is added wraps round, as differences of centuries do
        return since.astype(np.int64) + origins


def period_of(rate: str) -> int:
    """The shortest whole number of seconds in which a rate has a whole number of samples."""
    return fractions.Fraction(rate).denominator


def text_of(row: Any, by: Sequence[str]) -> str:
    """The track of a batch's first row, in words."""
    values = [row.column(name)[0].as_py() for name in by]
    return ", ".join(f"{name} {value!r}" if name == "track" else f"track with {name} {value!r}" if i == 0 else f"{name} {value!r}"
                     for i, (name, value) in enumerate(zip(by, values)))
