# SPDX-License-Identifier: Apache-2.0
"""Jobs that have a whole track at a time: smoothing, reduction, comparison, and orientations beside another table."""
from __future__ import annotations

import collections
import concurrent.futures
import dataclasses
import fractions
import os
from collections.abc import Callable, Iterable, Iterator
from typing import Any, Protocol

import numpy as np

from .._errors import DataError, Error, ShapeWarning, collected, tell
from .._keys import Keys
from ._layout import Layout, text_of
from ._resampling import NO_ID, Answer
from ._times import Floats, Times, Whole
from ._tracks import LongTrack, tracks_in, without_id

START = np.zeros(1, np.int64)


@dataclasses.dataclass(frozen=True)
class Track:
    """The keys of one track, and what brings times back."""

    times: Times
    origin: Any
    seconds: Floats
    numbers: list[Floats]

    def keys(self) -> Keys:
        """Raises the errors of Keys."""
        columns = np.column_stack(self.numbers)
        try:
            return Keys(self.seconds, columns[:, :4], positions=columns[:, 4:7] if columns.shape[1] > 6 else None)
        except DataError as error:
            error._cure = ""  # which a table has not
            raise

    def back(self, seconds: Floats) -> Any:
        """Times as the table has them."""
        return self.times.back(seconds, self.origin[0])


@dataclasses.dataclass(frozen=True)
class Result:
    """Rows that come of a track: their ids are those of these rows of the source. `failures` says why some have nothing."""

    source: Any
    rows: Whole
    columns: list[Any]
    failures: Any = None


class Work(Protocol):
    """What is done on every track."""

    @property
    def step(self) -> fractions.Fraction | None:
        """Times of the result are whole numbers of steps behind those of keys [s]; None where they are those of keys."""

    def check(self, layout: Layout) -> None:
        """Raises ArgumentError for options that no track can have."""

    def schema(self, layout: Layout, given: Any) -> Any:
        """Of the rows that come of it."""

    def of_track(self, layout: Layout, rows: Any, given: Any) -> Result:
        """What comes of the rows of a track. Raises the library's errors."""


@dataclasses.dataclass(frozen=True)
class PerTrack:
    """A job, with all that it needs wherever it runs: `work` is done on every track."""

    layout: Layout
    work: Work
    errors: str
    threads: int

    @property
    def step(self) -> fractions.Fraction | None:
        """That of the work."""
        return self.work.step

    def check(self) -> None:
        """Raises what the options of the work are refused by."""
        self.work.check(self.layout)

    def answer(self, given: Any) -> Answer:
        """For rows of such columns."""
        return Answer(self.layout, self.work.schema(self.layout, given), self.errors)

    def __call__(self, batches: Iterable[Any], given: Any) -> Iterator[Any]:
        """What the work makes of the tracks of a stream in order, whose schema is `given`."""
        answer = self.answer(given)
        noticed = Noticed(self.layout)

        def done(rows: Any) -> tuple[Any, Result | str, list[ShapeWarning]]:
            with collected() as warnings:
                try:
                    if len(without_id(rows, START, self.layout.by)):
                        raise DataError(NO_ID)
                    return rows, self.work.of_track(self.layout, rows, given), warnings
                except Error as error:
                    return rows, str(error), warnings

        for rows, result, warnings in in_threads(done, one_by_one(batches, self.layout.by), self.threads):
            noticed.add(rows, warnings)
            if isinstance(result, str):
                yield from answer.without_result(rows, START, [result])
            else:
                yield from answer.filled(result.source, result.rows, result.columns, result.failures)
        noticed.tell()


class Noticed:
    """Warnings of many tracks: of each kind one is given out, with its count."""

    def __init__(self, layout: Layout) -> None:
        self._by = layout.by
        self._kinds: dict[str, tuple[ShapeWarning, str, int]] = {}

    def add(self, rows: Any, warnings: list[ShapeWarning]) -> None:
        """Those of one track."""
        for warning in warnings:
            first, where, count = self._kinds.get(warning.code, (warning, "", 0))
            self._kinds[warning.code] = first, where or text_of(rows, self._by), count + 1

    def tell(self) -> None:
        """At the end of a job."""
        tell((f"{where}{f' and {count - 1} more' if count > 1 else ''}: {first}", first.code, first.numbers)
             for first, where, count in self._kinds.values())


def one_by_one(batches: Iterable[Any], by: tuple[str, ...]) -> Iterator[Any]:
    """The rows of each track."""
    for part in tracks_in(batches, by, longest=None):
        assert not isinstance(part, LongTrack)
        ends = np.append(part.starts[1:], part.batch.num_rows)
        for start, end in zip(part.starts, ends):
            yield part.batch.slice(int(start), int(end - start))


def in_threads(work: Callable[[Any], Any], items: Iterable[Any], threads: int) -> Iterator[Any]:
    """What becomes of the items, in their order, while a few more are worked on."""
    count = threads or os.cpu_count() or 1
    if count == 1:
        yield from map(work, items)
        return
    with concurrent.futures.ThreadPoolExecutor(count) as pool:
        waiting: collections.deque[concurrent.futures.Future[Any]] = collections.deque()
        try:
            for item in items:
                waiting.append(pool.submit(work, item))
                if len(waiting) > 4 * count:
                    yield waiting.popleft().result()
            while waiting:
                yield waiting.popleft().result()
        finally:
            for future in waiting:
                future.cancel()


def track_of(layout: Layout, rows: Any, step: fractions.Fraction | None = None) -> Track:
    """The keys among the rows of one track, for results at whole numbers of steps behind their times. Raises DataError for times that
    are not there."""
    times = layout.times(rows.schema.field(layout.time).type, step)
    for fault in layout.faults(rows, START, times).values():
        raise DataError(fault)
    seconds, origin = times.seconds(rows.column(layout.time), START)
    return Track(times, origin, np.ascontiguousarray(seconds), layout.numbers_of(rows))


def columns_of(*tables: Any) -> list[Any]:
    """Column by column, of arrays of rows; None has none."""
    return [np.ascontiguousarray(table[:, k]) for table in tables if table is not None for k in range(table.shape[1])]
