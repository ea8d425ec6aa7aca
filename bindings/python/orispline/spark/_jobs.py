# SPDX-License-Identifier: Apache-2.0
"""What is done with data frames: the functions of `orispline.tables`, with their arguments."""
from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from pyspark.sql import functions

from ..tables import _jobs as jobs
from ..tables._layout import UNIT_QUATERNION, Layout, layout
from ..tables._times import tell_of_types
from ..tables._works import SIDE
from ._frames import arrow_schema, mapped, readable, spark_schema, types_of

if TYPE_CHECKING:
    from .._types import Extrapolate, Method

ONE_THREAD = 1  # a task of Spark has a core
FINEST = "us"  # unit of Spark's stamps


def resample(df: Any, *, by: str | Sequence[str] = "track", time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION,
             position: Sequence[str] | None = None, rate: Any = 100.0, align: str = "start", method: Method = "auto",
             derivatives: int = 1, frame: str = "body", gap: float | None = None, errors: str = "row", normalize: bool = False,
             normalise: bool = False, **settings: Any) -> Any:
    """Even samples of the curve of every track, with their rates: `orispline.tables.resample` of a data frame.

    The rows are shuffled once, by track. Within a track they come out in order of time. Memory stays small however long a
    track is, where the method is local.
    """
    columns = layout(by, time, quaternion, position, normalize, normalise)
    return _run(jobs.resampling(columns, rate, align, method, derivatives, frame, gap, errors, ONE_THREAD, settings), df)


def evaluate(keys: Any, at: Any, *, by: str | Sequence[str] = "track", time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION,
             position: Sequence[str] | None = None, method: Method = "auto", derivatives: int = 0, frame: str = "body",
             extrapolate: Extrapolate = "nan", errors: str = "row", normalize: bool = False,
             normalise: bool = False, **settings: Any) -> Any:
    """The orientation of each track at the rows of another data frame: `orispline.tables.evaluate`."""
    columns = layout(by, time, quaternion, position, normalize, normalise)
    read, beside = columns.read(arrow_schema(keys), "keys"), jobs.beside_schema(columns, arrow_schema(at))
    tell_of_types(time, arrow_schema(at).field(time).type, beside.field(time).type, None)
    keys, at = readable(keys, read, columns), readable(at, beside, Layout(columns.by, columns.time, ()))
    schema, job = jobs.evaluation(columns, arrow_schema(keys), arrow_schema(at), method, derivatives, frame, extrapolate, errors,
                                  ONE_THREAD, settings)
    job.check()
    known = types_of(keys, at)
    both = _with_all(keys, schema.names, known, 0).unionByName(_with_all(at, schema.names, known, 1))
    answer = job.answer(schema).schema
    return mapped(job, both, columns.by, [*columns.by, SIDE, columns.time], spark_schema(answer, known, schema))


def smooth(df: Any, *, by: str | Sequence[str] = "track", time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION,
           position: Sequence[str] | None = None, rate: Any = None, derivatives: int = 1, frame: str = "body", errors: str = "row",
           normalize: bool = False, normalise: bool = False, **options: Any) -> Any:
    """Every track without its noise, with rates: `orispline.tables.smooth`. Warnings are in the logs of the workers."""
    columns = layout(by, time, quaternion, position, normalize, normalise)
    return _run(jobs.smoothing(columns, rate, derivatives, frame, errors, ONE_THREAD, options), df)


def reduce(df: Any, tolerance: Any, *, by: str | Sequence[str] = "track", time: str = "t",
           quaternion: Sequence[str] = UNIT_QUATERNION, position: Sequence[str] | None = None, errors: str = "row",
           normalize: bool = False, normalise: bool = False, **options: Any) -> Any:
    """The fewest keys of every track within a tolerance: `orispline.tables.reduce`."""
    return _run(jobs.reduction(layout(by, time, quaternion, position, normalize, normalise), tolerance, errors, ONE_THREAD, options), df)


def mean(df: Any, *, by: str | Sequence[str] = "track", every: Any = None, kind: str = "mean", weight: str | None = None,
         time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION, position: Sequence[str] | None = None, errors: str = "row",
         normalize: bool = False, normalise: bool = False) -> Any:
    """The mean or the median of every group of rows, or of its windows in time: `orispline.tables.mean`."""
    return _run(jobs.averaging(by, every, kind, weight, time, quaternion, position, errors, ONE_THREAD, normalize, normalise), df)


def compare(df: Any, methods: Sequence[Method] | Method | None = None, keep_every: int | Sequence[int] = 8, *,
            by: str | Sequence[str] = "track", time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION, errors: str = "row",
            normalize: bool = False, normalise: bool = False, **options: Any) -> Any:
    """How near the curves of methods come to every track: `orispline.tables.compare`."""
    return _run(jobs.comparison(layout(by, time, quaternion, None, normalize, normalise), methods, keep_every, errors, ONE_THREAD, options), df)


def checked(job: Any, df: Any) -> tuple[Any, Any]:
    """The job for the stamps of Spark, and the columns of a data frame that it takes, when both are found to be sound."""
    columns: Layout = dataclasses.replace(job.layout, finest=FINEST)
    given = arrow_schema(df)
    read = columns.read(given, "df")
    job.check()
    job = dataclasses.replace(job, layout=columns)
    rows = readable(df, read, columns)
    if columns.time in job.answer(arrow_schema(rows)).schema.names:
        columns.tell_of_times(given.field(columns.time).type, job.step)
    return job, rows


def _run(job: Any, df: Any) -> Any:
    job, rows = checked(job, df)
    given = arrow_schema(rows)
    return mapped(job, rows, job.layout.by, job.layout.order, spark_schema(job.answer(given).schema, types_of(rows), given))


def _with_all(df: Any, names: Sequence[str], known: dict[str, Any], side: int) -> Any:
    """The rows of one of two data frames with the columns of both."""
    def column(name: str) -> Any:
        if name == SIDE:
            return functions.lit(side).cast("tinyint").alias(SIDE)
        value = functions.col(name) if name in df.columns else functions.lit(None)
        return value.cast(known[name]).alias(name)

    return df.select(*map(column, names))
