# SPDX-License-Identifier: Apache-2.0
"""Tracks in a stream of record batches whose rows are in order: whole ones together, long ones piece by piece."""
from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from .._errors import DataError
from ._layout import text_of
from ._times import Whole

ROWS_AT_A_TIME = 1 << 16
LONGEST_WHOLE_TRACK = 1 << 16  # rows; what is longer comes in pieces


@dataclasses.dataclass(frozen=True)
class Tracks:
    """Whole tracks: the rows of the i-th begin at `starts[i]`."""

    batch: Any
    starts: Whole


class LongTrack:
    """One track in pieces, to be gone through once."""

    def __init__(self, held: list[Any], batches: Iterator[Any], by: Sequence[str]) -> None:
        self._held, self._batches, self._by = held, batches, by
        self.first_row = held[0].slice(0, 1)
        self.rest: Any = None  # of the batch in which the track has ended
        self._pieces = self._walk()

    def __iter__(self) -> Iterator[Any]:
        return self._pieces

    def _walk(self) -> Iterator[Any]:
        yield joined(self._held)
        self._held = []
        for batch in self._batches:
            if batch.num_rows == 0:
                continue
            if not is_one_track(self.first_row, batch, self._by):
                self.rest = batch
                return
            starts = run_starts(batch, self._by)
            if len(starts) > 1:
                yield batch.slice(0, int(starts[1]))
                self.rest = batch.slice(int(starts[1]))
                return
            yield batch


def joined(batches: list[Any]) -> Any:
    """One batch of several."""
    if len(batches) == 1:
        return batches[0]
    merged = pa.Table.from_batches(batches).combine_chunks().to_batches()
    return merged[0] if merged else batches[0]


def run_starts(batch: Any, by: Sequence[str]) -> Whole:
    """The rows in which another track begins."""
    changes = np.zeros(max(batch.num_rows - 1, 0), bool)
    for name in by:
        column = batch.column(name)
        absent = pc.is_null(column, nan_is_null=True).to_numpy(zero_copy_only=False)
        differs = pc.fill_null(pc.not_equal(column.slice(1), column.slice(0, max(len(column) - 1, 0))), False)
        changes |= np.where(absent[1:] & absent[:-1], False,
                            differs.to_numpy(zero_copy_only=False) | (absent[1:] ^ absent[:-1]))
    return np.concatenate([[0], np.nonzero(changes)[0] + 1]).astype(np.int64)[:batch.num_rows]


def is_one_track(row: Any, batch: Any, by: Sequence[str]) -> bool:
    """Whether a batch begins with the track of that row."""
    return len(run_starts(joined([row.select(by), batch.slice(0, 1).select(by)]), by)) == 1


def without_id(batch: Any, starts: Whole, by: Sequence[str]) -> Whole:
    """Those of the tracks that have no id."""
    rows = pa.array(starts)
    absent = np.zeros(len(starts), bool)
    for name in by:
        ids = batch.column(name).take(rows)
        absent |= pc.is_null(ids, nan_is_null=True).to_numpy(zero_copy_only=False)
    return np.nonzero(absent)[0]


def small(batches: Iterable[Any]) -> Iterator[Any]:
    """The same rows in batches that are not too large."""
    for batch in batches:
        for first in range(0, batch.num_rows, ROWS_AT_A_TIME):
            yield batch.slice(first, ROWS_AT_A_TIME)


def tracks_in(batches: Iterable[Any], by: Sequence[str], longest: int | None = LONGEST_WHOLE_TRACK) -> Iterator[Tracks | LongTrack]:
    """The tracks of a stream, in its order. A track of more rows than `longest` comes by itself, in pieces."""
    stream = small(batches)
    held: list[Any] = []  # of the track that the last batch ended in
    rows = 0
    rest: Any = None
    while (batch := rest if rest is not None else next(stream, None)) is not None:
        rest = None
        starts = run_starts(batch, by)
        if held and len(starts) == 1 and is_one_track(held[0], batch, by):
            held.append(batch)
            rows += batch.num_rows
        else:
            cut = int(starts[-1])
            if held or cut:
                whole = joined([*held, *([batch.slice(0, cut)] if cut else [])])
                yield Tracks(whole, run_starts(whole, by))
            held, rows = [batch.slice(cut)], batch.num_rows - cut
        if longest is not None and rows > longest:
            long = LongTrack(held, stream, by)
            yield long
            for _ in long:  # what nobody took
                pass
            rest, held, rows = long.rest, [], 0
    if held:
        yield Tracks(joined(held), np.zeros(1, np.int64))


def in_order(batches: Iterable[Any], by: Sequence[str]) -> Iterator[Any]:
    """The same batches. Raises DataError where a track comes behind one that it belongs before."""
    last: Any = None
    for batch in batches:
        if batch.num_rows == 0:
            continue
        ids = batch.select(by).take(pa.array(run_starts(batch, by)))
        ids = ids if last is None else joined([last, ids])
        late = _first_that_falls(ids, by)
        if late is not None:
            before, here = text_of(ids.slice(late - 1, 1), by), text_of(ids.slice(late, 1), by)
            raise DataError(f"found {here} behind {before}, wanted rows in order of {', '.join(by)}: leave assume_sorted out, and "
                            "they are put in order")
        last = ids.slice(ids.num_rows - 1, 1)
        yield batch


def _first_that_falls(ids: Any, by: Sequence[str]) -> int | None:
    """The first row that is less than the one before it, column by column; what is absent is the largest."""
    count = ids.num_rows - 1
    undecided = np.ones(max(count, 0), bool)
    falls = np.zeros(max(count, 0), bool)
    for name in by:
        column = ids.column(name)
        before, here = column.slice(0, max(count, 0)), column.slice(1)
        absent = pc.is_null(column, nan_is_null=True).to_numpy(zero_copy_only=False)
        less = pc.fill_null(pc.less(here, before), False).to_numpy(zero_copy_only=False)
        more = pc.fill_null(pc.greater(here, before), False).to_numpy(zero_copy_only=False)
        falls |= undecided & (less | (absent[:-1] & ~absent[1:]))
        undecided &= ~(less | more | (absent[:-1] ^ absent[1:]))
    rows = np.nonzero(falls)[0]
    return int(rows[0]) + 1 if len(rows) else None
