# SPDX-License-Identifier: Apache-2.0
"""A track of a live stream, between one arrival of keys and the next."""
from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np
import pandas
import pyarrow as pa

from .. import _core
from .._errors import DataError, Error
from ..tables._times import absent
from ..tables._resampling import NO_ID, SAMPLES_AT_A_TIME, Resampling, sampled_names


class LiveTrack:
    """`unit`: of stamps that are whole numbers; None: times are seconds."""

    def __init__(self, job: Resampling, unit: str | None, key: tuple[Any, ...], state: tuple[Any, ...] | None) -> None:
        self._job, self._key, self._unit = job, key, unit
        self._times = job.times(pa.float64() if unit is None else pa.timestamp(unit))
        self._names = sampled_names(job.layout, job.derivatives, job.world)
        self._sampler: Any = job.sampler() if state is None else _core.TrackSampler.from_state(bytes(state[0]))
        self._origin: int | None = None if state is None else state[1]
        self._frames: list[Any] = []
        self._errors: list[tuple[Any, str]] = []  # times, as they came, and messages

    @property
    def state(self) -> tuple[bytes, int | None]:
        """All that is needed to go on."""
        return self._sampler.state, self._origin

    def add(self, frame: Any) -> None:
        """Keys that have come."""
        self._frames.append(frame)

    def samples(self) -> Iterator[Any]:
        """What is final now that they have come."""
        rows = pandas.concat(self._frames).sort_values(self._job.layout.time, kind="stable")
        given = rows[self._job.layout.time].to_numpy()
        if any(value is None or value != value for value in self._key):
            self._errors.append((None, NO_ID))
        else:
            numbers = [rows[name].to_numpy(np.float64, na_value=np.nan) for name in self._job.layout.numbers]
            self._append(given, self._job.layout.normalized(numbers))
        yield from self._ready()
        yield from self._failures()

    def ended(self) -> Iterator[Any]:
        """The rest, for no more keys will come."""
        try:
            self._sampler.finish()
        except Error as error:
            if self._sampler.keys:
                self._errors.append((None, str(error)))
        else:
            yield from self._ready()
        yield from self._failures()

    def _append(self, given: Any, numbers: list[Any]) -> None:
        """Key by key where some are refused: the others belong to the track all the same."""
        missing = pandas.isna(given)
        for row in np.flatnonzero(missing):
            values = dict(zip(self._job.layout.numbers, (float(column[row]) for column in numbers)))
            self._errors.append((None, absent(self._job.layout.time, values, "null" if self._unit else "null or nan")))
        columns = [self._seconds(given[~missing]), *(column[~missing] for column in numbers)]
        given, first = given[~missing], 0
        while first < len(given):
            before = self._sampler.keys
            try:
                self._sampler.append([np.ascontiguousarray(column[first:]) for column in columns])
                return
            except Error as error:
                refused = first + self._sampler.keys - before
                self._errors.append((given[refused], str(error)))
                first = refused + 1

    def _seconds(self, given: Any) -> Any:
        if self._unit is None:
            return given.astype(np.float64)
        stamps = given.astype(np.int64)
        if self._origin is None and len(stamps):
            self._origin = int(self._times.origins(stamps[:1])[0])
        return self._times.seconds_of(stamps - (self._origin or 0))

    def _ready(self) -> Iterator[Any]:
        while self._sampler.ready:
            count = min(self._sampler.ready, SAMPLES_AT_A_TIME)
            try:
                t, *rest = self._sampler.take(count, self._job.derivatives, bool(self._job.layout.position), self._job.world, 1)
            except Error as error:
                self._errors.append((None, str(error)))
                return
            yield self._frame([self._back(t), *rest], [None] * count)

    def _back(self, seconds: Any) -> Any:
        if self._unit is None:
            return seconds
        return self._times.units(seconds, np.array(self._origin or 0))

    def _failures(self) -> Iterator[Any]:
        if not self._errors or self._job.errors == "drop":
            return
        if self._job.errors == "raise":
            ids = ", ".join(f"{name} {value!r}" for name, value in zip(self._job.layout.by, self._key))
            raise DataError(f"{ids}: {self._errors[0][1]}")
        times = pandas.array([time for time, _ in self._errors], "Float64" if self._unit is None else "Int64")
        nothing = [np.full(len(self._errors), np.nan)] * (len(self._names) - len(self._key) - 1)
        yield self._frame([times, *nothing], [message for _, message in self._errors])

    def _frame(self, columns: list[Any], errors: list[str | None]) -> Any:
        ids = [[value] * len(errors) for value in self._key]
        values = [*ids, *columns, pandas.array(errors, "object")]
        return pandas.DataFrame(dict(zip([*self._names, "error"], values, strict=True)))
