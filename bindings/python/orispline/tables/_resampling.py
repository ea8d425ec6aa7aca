# SPDX-License-Identifier: Apache-2.0
"""Even samples of tracks: the function of a stream that runs here and on every machine of a cluster."""
from __future__ import annotations

import dataclasses
import fractions
import json
from collections.abc import Callable, Generator, Iterable, Iterator
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from .. import _core
from .._errors import DataError, Error
from .._methods import blending_of
from ._layout import Layout, text_of
from ._times import Times, Whole, period_of
from ._tracks import LongTrack, Tracks, tracks_in, without_id

SAMPLES_AT_A_TIME = 1 << 17
NO_ID = "found no value in a column of by, wanted one that says which track the row belongs to"


@dataclasses.dataclass(frozen=True)
class Answer:
    """What a job's rows look like, and what becomes of tracks that have no result."""

    layout: Layout
    schema: Any
    errors: str  # "row", "raise" or "drop"

    def rows(self, source: Any, rows: Whole, columns: list[Any], failures: Any = None) -> Any:
        """A batch: the ids of those rows of the source, then the columns, and why they are empty where they are."""
        ids = source.select(list(self.layout.by)).take(pa.array(rows)).columns
        fields = list(self.schema)[len(ids):-1]
        values = [column if isinstance(column, pa.Array) else pa.array(column, field.type) for column, field in
                  zip(columns, fields)]
        why = pa.nulls(len(rows), pa.string()) if failures is None else failures
        return pa.RecordBatch.from_arrays([*ids, *values, why], schema=self.schema)

    def filled(self, source: Any, rows: Whole, columns: list[Any], failures: Any = None) -> Iterator[Any]:
        """The same batch, and what is wanted instead of rows that failed."""
        batch = self.rows(source, rows, columns, failures)
        if failures is not None and failures.null_count < len(failures) and self.errors != "row":
            if self.errors == "raise":
                row = int(pc.index(failures.is_valid(), True).as_py())
                raise DataError(f"{text_of(batch.slice(row, 1), self.layout.by)}: {failures[row].as_py()}")
            batch = batch.filter(failures.is_null())
        yield batch

    def without_result(self, source: Any, rows: Whole, messages: list[str]) -> Iterator[Any]:
        """A row with its message for each of these tracks, if that is what they get."""
        if not messages or self.errors == "drop":
            return
        if self.errors == "raise":
            raise DataError(f"{text_of(source.slice(int(rows[0]), 1), self.layout.by)}: {messages[0]}")
        ids = source.select(list(self.layout.by)).take(pa.array(rows)).columns
        nothing = [pa.nulls(len(rows), field.type) for field in list(self.schema)[len(ids):-1]]
        yield pa.RecordBatch.from_arrays([*ids, *nothing, pa.array(messages, pa.string())], schema=self.schema)


@dataclasses.dataclass(frozen=True)
class Resampling:
    """A job, with all that it needs wherever it runs."""

    layout: Layout
    method: str
    rate: str
    at_multiples: bool
    gap: float | None
    derivatives: int
    world: bool
    errors: str
    threads: int

    @property
    def stated(self) -> dict[str, Any]:
        """All that the samples depend on, as JSON has it: the same for all ways to state the same."""
        all_members = {**dataclasses.asdict(self), "rate": str(fractions.Fraction(self.rate)), "method": _plain_method(self.method)}
        members = {name: value for name, value in all_members.items() if name != "threads"}
        if (blending := blending_of(self.method)) is not None:
            members["blending"] = blending.to_json()
        return dict(json.loads(json.dumps(members)))

    def check(self) -> None:
        """Raises what a method, a rate or a gap is refused by."""
        self.sampler()

    @property
    def step(self) -> fractions.Fraction:
        """From one sample to the next [s]."""
        return 1 / fractions.Fraction(self.rate)

    def times(self, kind: Any) -> Times:
        """Of a column of that type."""
        return self.layout.times(kind, self.step, period_of(self.rate) if self.at_multiples else 0)

    def answer(self, given: Any) -> Answer:
        """For rows of such columns."""
        return Answer(self.layout, sampled_schema(self.layout, given, self.derivatives, self.world, self.step), self.errors)

    def __call__(self, batches: Iterable[Any], given: Any) -> Iterator[Any]:
        """Samples of the tracks of a stream in order, whose schema is `given`."""
        answer = self.answer(given)
        times = self.times(given.field(self.layout.time).type)
        for part in tracks_in(batches, self.layout.by):
            yield from self._of_long(part, times, answer) if isinstance(part, LongTrack) else self._of_whole(part, times, answer)

    def _of_whole(self, tracks: Tracks, times: Times, answer: Answer) -> Iterator[Any]:
        batch, starts = tracks.batch, tracks.starts
        seconds, origins = times.seconds(batch.column(self.layout.time), starts)
        faults = {**self.layout.faults(batch, starts, times), **dict.fromkeys(without_id(batch, starts, self.layout.by).tolist(), NO_ID)}
        if faults:
            seconds = seconds.copy()
            seconds[starts[list(faults)]] = np.nan  # so that nothing comes of them
        columns = [np.ascontiguousarray(seconds), *self.layout.numbers_of(batch)]
        core = _core.TrackBatch(self.method, np.append(starts, batch.num_rows), columns, self.rate, self.at_multiples, self.gap,
                                self.threads)
        counts, errors = core.counts_and_errors
        ends = np.cumsum(counts)
        taken = 0
        while core.left:
            count = min(core.left, SAMPLES_AT_A_TIME)
            t, *rest = core.take(count, self.derivatives, bool(self.layout.position), self.world, self.threads)
            here = np.diff(np.clip(ends, taken, taken + count), prepend=taken)
            yield answer.rows(batch, np.repeat(starts, here), [times.back(t, np.repeat(origins, here)), *rest])
            taken += count
        yield from answer.without_result(batch, starts[[track for track, _ in errors]],
                                         [faults.get(track, message) for track, message in errors])

    def _of_long(self, track: LongTrack, times: Times, answer: Answer) -> Iterator[Any]:
        """Samples that are final are given out and forgotten, so that an error comes behind those before it."""
        sampler = self.sampler()
        start, origin = np.zeros(1, np.int64), None
        refused = NO_ID if len(without_id(track.first_row, start, self.layout.by)) else None
        for piece in track:
            refused = refused or self.layout.faults(piece, start, times).get(0)
            if refused is None:
                seconds, origin = times.seconds(piece.column(self.layout.time), start, origin)
                refused = _refusal(sampler.append, [np.ascontiguousarray(seconds), *self.layout.numbers_of(piece)])
            if refused is None:
                refused = yield from self._ready(sampler, track.first_row, times, origin, answer)
            if refused is not None:
                break
        if refused is None:
            refused = _refusal(sampler.finish)
        if refused is None:
            refused = yield from self._ready(sampler, track.first_row, times, origin, answer)
        if refused is not None:
            yield from answer.without_result(track.first_row, start, [refused])

    def _ready(self, sampler: Any, row: Any, times: Times, origin: Any, answer: Answer) -> Generator[Any, None, str | None]:
        """The samples that are final. What is returned says why there are no more of them."""
        while sampler.ready:
            count = min(sampler.ready, SAMPLES_AT_A_TIME)
            try:
                t, *rest = sampler.take(count, self.derivatives, bool(self.layout.position), self.world, self.threads)
            except Error as error:
                return str(error)
            yield answer.rows(row, np.zeros(count, np.int64), [times.back(t, origin[0]), *rest])
        return None

    def sampler(self) -> Any:
        """For one track whose keys come in pieces."""
        return _core.TrackSampler(self.method, self.rate, self.at_multiples, self.gap)


def sampled_schema(layout: Layout, given: Any, derivatives: int, world: bool, step: fractions.Fraction | None = None) -> Any:
    """Of samples: the columns of the keys, then the rates of the rotation and those of the position, then the error. Samples that are
    not at the times of the keys are at whole numbers of steps [s]."""
    names = sampled_names(layout, derivatives, world)
    known = len(layout.order)
    return pa.schema([*(pa.field(name, given.field(name).type) for name in layout.by),
                      pa.field(layout.time, layout.times(given.field(layout.time).type, step).made),
                      *(pa.field(name, pa.float64()) for name in names[known:]), pa.field("error", pa.string())])


def sampled_names(layout: Layout, derivatives: int, world: bool) -> list[str]:
    """Of the same columns, without the error."""
    linear = min(derivatives, 2) if layout.position else -1
    rates = _core.column_names(world, derivatives, linear)[5 + len(layout.position):]
    return [*layout.names, *rates]


def _plain_method(text: str) -> str:
    """`NAME:SETTING=VALUE:…` with the settings in one order, and each number in one way of writing it."""
    def plain_number(word: str) -> str:
        try:
            return repr(float(word))
        except ValueError:
            return word

    name, *settings = text.split(":")
    stated = [setting.partition("=") for setting in settings]
    return ":".join([name, *sorted(what + equals + ",".join(map(plain_number, value.split(","))) for what, equals, value in stated)])


def _refusal(work: Callable[..., Any], *arguments: Any) -> str | None:
    """Why the library does not take a track any further, if so."""
    try:
        work(*arguments)
    except Error as error:
        return str(error)
    return None
