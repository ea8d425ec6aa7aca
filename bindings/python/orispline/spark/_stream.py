# SPDX-License-Identifier: Apache-2.0
"""Live streams: samples come out as soon as they are final, once."""
from __future__ import annotations

import pickle
import re
from collections.abc import Callable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

from pyspark.sql import functions
from pyspark.sql.streaming.state import GroupStateTimeout
from pyspark.sql.types import BinaryType, FractionalType, LongType, StructField, StructType, TimestampNTZType, TimestampType

from .._errors import ArgumentError
from ..tables import _jobs as jobs
from ..tables._layout import UNIT_QUATERNION, layout
from ._frames import arrow_schema, spark_schema, types_of, unpacking
from ._jobs import ONE_THREAD, checked

if TYPE_CHECKING:
    from .._types import Method

SECONDS = {"second": 1, "minute": 60, "hour": 3600, "day": 86400}
STATE = StructType([StructField("sampler", BinaryType()), StructField("origin", LongType())])


def resample_stream(df: Any, *, by: str | Sequence[str] = "track", time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION,
                    position: Sequence[str] | None = None, rate: Any = 100.0, align: str = "start", method: Method = "auto",
                    derivatives: int = 1, frame: str = "body", gap: float | None = None, errors: str = "row",
                    normalize: bool = False, normalise: bool = False, idle: Any = "10 minutes", **settings: Any) -> Any:
    """Even samples of tracks whose keys keep coming: `resample` of a streaming data frame, for the output mode append.

    A sample comes out when the keys have come that it depends on, once, with the bits of the batch job; of a method that
    solves equations over all keys when the track has ended. A track ends when it had no keys for `idle`: a number of
    seconds, or a text such as `"10 minutes"`, by the clock of the cluster; with None it never ends. Keys that belong
    before those that came already are rows with an error, and the track goes on without them.

    Spark looks for idle tracks in triggers without rows too, when the query had one with rows. So a query with the trigger
    `availableNow` does not end by itself unless `idle` is None, or `spark.sql.streaming.noDataMicroBatches.enabled` is
    false: tracks end in the next trigger with rows then.

    The state of a track is the keys that coming samples depend on. It needs pandas on the executors. Latency is that of
    triggers, seconds: a control loop takes `orispline.OnlineCurve`.
    """
    columns = layout(by, time, quaternion, position, normalize, normalise)
    job = jobs.resampling(columns, rate, align, method, derivatives, frame, gap, errors, ONE_THREAD, settings)
    job, rows = checked(job, df)
    known, given = types_of(rows), arrow_schema(rows)
    answer = job.answer(given).schema
    kind = known[job.layout.time]
    is_calendar = isinstance(kind, (TimestampType, TimestampNTZType))
    if not is_calendar and not isinstance(kind, FractionalType):
        raise ArgumentError(f"df: found {kind.simpleString()} in the column {job.layout.time!r}, wanted float seconds or timestamps in a stream: "
                            "cast it")
    unit = "us" if is_calendar else None
    out = spark_schema(answer, {**known, **({job.layout.time: LongType()} if is_calendar else {})}, given)
    patience = None if idle is None else _milliseconds(idle)
    work = _on_a_worker(pickle.dumps((job, unit)), patience)
    counted = rows.withColumn(job.layout.time, _microseconds(job.layout.time, kind)) if is_calendar else rows
    timeout = GroupStateTimeout.NoTimeout if patience is None else GroupStateTimeout.ProcessingTimeTimeout
    samples = counted.groupBy(*job.layout.by).applyInPandasWithState(work, out, STATE, "append", timeout)
    return samples.withColumn(job.layout.time, _stamps(job.layout.time, kind)) if is_calendar else samples


def _microseconds(name: str, kind: Any) -> Any:
    """Stamps as whole numbers: pandas would turn them into the local time of the session."""
    if isinstance(kind, TimestampType):
        return functions.unix_micros(functions.col(name))
    return functions.expr(f"timestampdiff(MICROSECOND, timestamp_ntz'1970-01-01 00:00:00', `{name}`)")


def _stamps(name: str, kind: Any) -> Any:
    if isinstance(kind, TimestampType):
        return functions.timestamp_micros(functions.col(name))
    return functions.expr(f"timestamp_ntz'1970-01-01 00:00:00' + make_dt_interval(0, 0, 0, `{name}` / decimal('1000000.000000'))")


def _milliseconds(idle: Any) -> int:
    seconds: Any = idle
    if isinstance(idle, str):
        words = re.fullmatch(r"\s*(\d+(?:\.\d+)?)\s*(second|minute|hour|day)s?\s*", idle)
        seconds = float(words[1]) * SECONDS[words[2]] if words else None
    if isinstance(seconds, bool) or not isinstance(seconds, (int, float)) or not 0.001 <= seconds < 1e9:
        raise ArgumentError(f"idle: found {idle!r}, wanted seconds, a text such as '10 minutes', or None")
    return round(seconds * 1000)


def _on_a_worker(job: bytes, idle: int | None) -> Callable[..., Iterator[Any]]:
    """The job as a function of a track's new rows."""
    unpack = unpacking()

    def work(key: tuple[Any, ...], frames: Iterator[Any], state: Any) -> Iterator[Any]:
        made, unit = unpack(job, "orispline.spark._live")
        from orispline.spark._live import LiveTrack
        track = LiveTrack(made, unit, key, state.get if state.exists else None)
        if state.hasTimedOut:
            yield from track.ended()
            state.remove()
            return
        for frame in frames:
            track.add(frame)
        yield from track.samples()
        state.update(track.state)
        if idle is not None:
            state.setTimeoutDuration(idle)

    return work
