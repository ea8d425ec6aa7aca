# SPDX-License-Identifier: Apache-2.0
"""What the columns of a table of keys mean, and how they come to the library and back."""
from __future__ import annotations

import dataclasses
import fractions
from collections.abc import Sequence
from typing import Any

import numpy as np
import pyarrow as pa

from .._checks import wrong_type
from .._columns import like_times
from .._errors import ArgumentError
from .._mending import one_spelling, scaled
from ._kinds import id_type, number_type, part_type, time_type
from ._times import Floats, Times, Whole, absent, number_column, result_type, tell_of_types, too_far

UNIT_QUATERNION = ("qx", "qy", "qz", "qw")
POSITION = ("px", "py", "pz")


@dataclasses.dataclass(frozen=True)
class Layout:
    """The columns of keys by name: those that tell tracks apart, the time, and x, y, z, w of quaternions.

    `packed`: columns of the source that hold several of these numbers in one, with the names of these. `finest`: the shortest
    unit that stamps of a result may have. `normalize`: quaternions may have any norm but 0.
    """

    by: tuple[str, ...]
    time: str
    quaternion: tuple[str, ...]
    position: tuple[str, ...] = ()
    packed: tuple[tuple[str, tuple[str, ...]], ...] = ()
    finest: str = "ns"
    normalize: bool = False

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

    @property
    def columns(self) -> list[str]:
        """Those of the source that all of them are read from."""
        return list(dict.fromkeys(self.place(name)[0] for name in self.names))

    def numbers_of(self, batch: Any) -> list[Floats]:
        """The columns of `numbers`, as doubles, the quaternions of norm 1 where any norm is taken."""
        return self.normalized([np.ascontiguousarray(number_column(batch.column(name))) for name in self.numbers])

    def normalized(self, columns: list[Floats]) -> list[Floats]:
        """The same columns with those of quaternions scaled, where that is wanted."""
        if not self.normalize:
            return columns
        return [*(np.ascontiguousarray(column) for column in scaled(np.column_stack(columns[:4]), {})[0].T), *columns[4:]]

    def place(self, name: str) -> tuple[str, tuple[str, ...], int]:
        """The column of the source that a column of that name is read from, and where it is among the names of those that are packed in
        it, if they are."""
        return next(((column, names, names.index(name)) for column, names in self.packed if name in names), (name, (), 0))

    def read(self, schema: Any, what: str = "source") -> Any:
        """The columns as they are read. Raises ArgumentError where one is missing or of a type that it cannot have."""
        for column in self.columns:
            check_once(what, schema.names, column, self.time)

        def kind(name: str) -> Any:
            column, names, k = self.place(name)
            found = schema.field(column).type
            return part_type(what, column, found, names, k) if names else found

        roles = {**dict.fromkeys(self.numbers, number_type), **dict.fromkeys(self.by, id_type), self.time: time_type}
        return pa.schema([pa.field(name, roles[name](what, self.place(name)[0], kind(name))) for name in self.names])

    def times(self, kind: Any, step: fractions.Fraction | None, period: int = 0) -> Times:
        """Of a column of that type, and of results at whole numbers of steps [s] behind its times."""
        return Times(kind, result_type(kind, step, self.finest), period)

    def tell_of_times(self, given: Any, step: fractions.Fraction | None) -> None:
        """Warns where those of the result are of another type than those of the keys, which are of this one."""
        if self.time:
            tell_of_types(self.time, given, time_type("source", self.time, given), step, self.finest)

    def faults(self, batch: Any, starts: Whole, times: Times) -> dict[int, str]:
        """What is wrong with times, of tracks by their numbers, that begin in these rows: what the library could not say."""
        column = batch.column(self.time)
        found = {int(track): too_far(self.time, column[row], times.made)
                 for track, row in _first_of_each(starts, times.without_room(column))}
        if column.null_count:
            rows = np.flatnonzero(column.is_null().to_numpy(zero_copy_only=False))
            numbers = np.column_stack([number_column(batch.column(name).take(pa.array(rows))) for name in self.numbers])
            order = np.lexsort(numbers.T[::-1])  # rows without a time are in no order: their first is the same everywhere
            for track, row in _first_of_each(starts, rows[order]):
                values = numbers[np.flatnonzero(rows == row)[0]].tolist()
                found[int(track)] = absent(self.time, dict(zip(self.numbers, values)))
        return found


def check_once(what: str, names: Sequence[str], column: str, time: str) -> None:
    """Raises ArgumentError where a column is not there once, which names one that may be it where the time is missing."""
    if names.count(column) != 1:
        found, meant = ", ".join(map(repr, names)) or "none", like_times(names) if column == time else []
        raise ArgumentError(f"{what}: found the columns {found}, wanted {column!r} once: name the columns by by=, time=, quaternion= and position="
                            + (f", such as time={meant[0]!r}" if meant else ""))


def _first_of_each(starts: Whole, rows: Whole) -> list[tuple[int, int]]:
    """The tracks that rows belong to, each with the first of its rows."""
    tracks, first = np.unique(np.searchsorted(starts, rows, "right") - 1, return_index=True)
    return list(zip(tracks.tolist(), rows[first].tolist()))


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


def layout(by: Any, time: Any, quaternion: Any, position: Any, normalize: bool = False, normalise: bool = False) -> Layout:
    """Of arguments. Raises TypeError and ArgumentError."""
    made = Layout(_names("by", by, None), _names("time", time, 1)[0], *_of_poses(quaternion, position),
                  normalize=one_spelling(normalize, normalise))
    _check_named_once(made, "by, time, quaternion and position")
    return made


def set_layout(by: Any, time: Any, quaternion: Any, position: Any, weight: Any, normalize: bool = False,
               normalise: bool = False) -> SetLayout:
    """Of arguments, of which time and weight may be None. Raises TypeError and ArgumentError."""
    made = SetLayout(_names("by", by, None), "" if time is None else _names("time", time, 1)[0], *_of_poses(quaternion, position),
                     weight=() if weight is None else _names("weight", weight, 1), normalize=one_spelling(normalize, normalise))
    _check_named_once(made, "by, time, quaternion, position and weight")
    return made


def _of_poses(quaternion: Any, position: Any) -> tuple[tuple[str, ...], tuple[str, ...], tuple[tuple[str, tuple[str, ...]], ...]]:
    """The columns of quaternions and of positions, and those that one column holds."""
    given = [_names("quaternion", quaternion, 4), () if position is None else _names("position", position, 3)]
    flat = [own if len(names) == 1 else names for names, own in zip(given, (UNIT_QUATERNION, POSITION))]
    return flat[0], flat[1], tuple((names[0], own) for names, own in zip(given, flat) if len(names) == 1)


def _check_named_once(columns: Layout, arguments: str) -> None:
    twice = sorted({name for name in columns.names if columns.names.count(name) > 1})
    if twice:
        raise ArgumentError(f"found the column {twice[0]!r} named twice, wanted a column for each of {arguments}")


def _names(argument: str, names: Any, count: int | None) -> tuple[str, ...]:
    listed = (names,) if isinstance(names, str) else tuple(names) if isinstance(names, (list, tuple)) else ()
    if not listed or not all(isinstance(name, str) for name in listed):
        raise wrong_type(argument, names, "the name of a column" if count == 1 else "names of columns")
    if count is not None and len(listed) not in (1, count):
        raise ArgumentError(f"{argument}: found {len(listed)} names, wanted {count}" + (": x, y, z, w" if count == 4 else ""))
    return listed


def text_of(row: Any, by: Sequence[str]) -> str:
    """The track of a batch's first row, in words."""
    values = [row.column(name)[0].as_py() for name in by]
    return ", ".join(f"{name} {value!r}" if name == "track" else f"track with {name} {value!r}" if i == 0 else f"{name} {value!r}"
                     for i, (name, value) in enumerate(zip(by, values)))
