# SPDX-License-Identifier: Apache-2.0
"""What is done with tables: each a stream of record batches in and out, one track after the other."""
from __future__ import annotations

import dataclasses
import inspect
from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa

from .._checks import FRAMES, flag, in_world, index_of, rate_text, real, text, thread_count, whole
from .._evaluation import BEYOND
from .._errors import ArgumentError
from .._methods import method_text
from ._frames import answered, beside, check_new, index_as_columns, kind_of
from ._kinds import converted, id_type, plain_type, time_type
from ._layout import UNIT_QUATERNION, Layout, check_once, layout, set_layout
from ._means import Means
from ._per_track import PerTrack
from ._progress import Progress, check, telling
from ._readers import giving
from ._resampling import Resampling, sampled_schema
from ._source import Source, ordered, selected, source_of, with_metadata
from ._times import tell_of_types
from ._works import SIDE, SIDES, Comparison, Evaluation, Reduction, Smoothing, united

if TYPE_CHECKING:
    from .._types import Extrapolate, Method

ALIGNMENTS = ("start", "epoch")
ERRORS = ("row", "raise", "drop")


def resample(source: Any, *, by: str | Sequence[str] = "track", time: str = "t",
             quaternion: Sequence[str] = UNIT_QUATERNION, position: Sequence[str] | None = None, rate: Any = 100.0,
             align: str = "start", method: Method = "auto", derivatives: int = 1, frame: str = "body", gap: float | None = None,
             errors: str = "row", normalize: bool = False, normalise: bool = False, assume_sorted: bool = False, threads: int = 0,
             memory_limit: str = "1GB", progress: Progress | bool | None = None, **settings: Any) -> Any:
    """Even samples of the curve of every track, with their rates.

    Parameters
    ----------
    source
        Paths of Parquet files (patterns and folders too), a pyarrow table, dataset or reader, or anything with
        `__arrow_c_stream__`, such as frames of pandas and Polars, lazy ones too, and relations of DuckDB. One row is one key. Rows
        may stand in any order.
    by : str or list of str
        The columns that tell tracks apart, of any type that can be put in order.
    time : str
        The column of times: float or decimal seconds, timestamps, durations, or dates. Stamps of the result have the longest
        unit that holds them, none longer than that of the keys; a warning says where the result has another type.
    quaternion : four str, or one
        The columns of x, y, z and w, body to world; or one column of structs with these members or of fixed-size lists in this
        order, of which the result has the columns `qx`, `qy`, `qz` and `qw`.
    position : three str, or one, optional
        The columns of x, y and z [m], or one, which becomes `px`, `py` and `pz`.
    rate : number or str
        Samples per second; a fraction such as `"30000/1001"` is exact.
    align : {"start", "epoch"}
        Whether a track's samples begin at its first key, or all tracks have samples at the same times: the multiples of
        1/rate, of timestamps since 1970-01-01.
    method, **settings
        As of `Curve`: a method with its settings and end rules, such as `tension=0.4, ends="natural"`.
    derivatives : int
        The highest order of the rates, 0 to 3.
    frame : {"body", "world"}
        Of angular rates.
    gap : float, optional
        A longer interval between two keys [s] is left empty: a new curve begins behind it.
    errors : {"row", "raise", "drop"}
        Whether a bad track is one row with its message in the column `error`, ends the job, or is left out.
    normalize, normalise : bool
        Take quaternions of any norm but 0. Both spellings mean the same.
    assume_sorted : bool
        The rows are in order of `by`, and of `time` within a track: nothing is put in order, and it is checked that it
        need not.
    threads : int
        At most so many at work, 0 means one for each core. The numbers are the same on any.
    memory_limit : str
        What DuckDB may take to put files and streams in order; beyond it the disk is used.
    progress : callable or bool, optional
        Is told from time to time which share of the keys is done, 0 to 1, where it is known how many there are, else how
        many keys are done. True shows a bar, that of tqdm where it is installed.

    Returns
    -------
    pandas or Polars DataFrame, Polars LazyFrame, or pyarrow.RecordBatchReader
        Of the kind that the source is; of files, Arrow and all else a reader. A DataFrame of pandas keeps its index where that has the
        times or the ids, its time zone, its `attrs` and the types of ids and times; a LazyFrame is made when it is collected; fields of
        Arrow keep their metadata.

        The columns of `by`, of time, quaternion and position, then `wx`, `wy`, `wz` [rad/s], `ax` … [rad/s²], `jx` …
        [rad/s³] and of positions `vx` … [m/s], `apx` … [m/s²], and `error`. Angular rates in the world frame have names
        that end in `_world`. Track by track in the order of `by`; rows with errors come behind the tracks beside them.
        Each track has the bits of `Curve.sample`.

        Memory stays small however long a track is where the method is local (`orispline.methods()` says which are); a
        track of more than 65536 keys gives its samples as soon as they are final, so that an error comes behind those
        before it.

    Raises
    ------
    ArgumentError
        Columns that are missing or of another type, an option or a method that there is not.
    AccessError, DataError
        A file that cannot be read; with `errors="raise"` the first bad track.

    Warns
    -----
    ShapeWarning
        The times of the result are of another type than those of the keys.

    Examples
    --------
    >>> import orispline.tables as tables, pyarrow as pa
    >>> keys = pa.table({"track": ["b", "a", "a"], "t": [0.0, 1.0, 0.0], "qx": [0.0] * 3, "qy": [0.0] * 3,
    ...                  "qz": [0.0, 0.6, 0.0], "qw": [1.0, 0.8, 1.0]})
    >>> tables.resample(keys, rate=2).read_all().select(["track", "t", "qw"]).to_pylist()[1]
    {'track': 'a', 't': 0.5, 'qw': 0.9486832980505138}
    """
    columns = layout(by, time, quaternion, position, normalize, normalise)
    job = resampling(columns, rate, align, method, derivatives, frame, gap, errors, threads, settings)
    return run(job, source, assume_sorted=assume_sorted, memory_limit=memory_limit, progress=progress)


def evaluate(keys: Any, at: Any, *, by: str | Sequence[str] = "track", time: str = "t",
             quaternion: Sequence[str] = UNIT_QUATERNION, position: Sequence[str] | None = None, method: Method = "auto",
             derivatives: int = 0, frame: str = "body", extrapolate: Extrapolate = "nan", errors: str = "row", normalize: bool = False,
             normalise: bool = False, threads: int = 0, memory_limit: str = "1GB", progress: Progress | bool | None = None,
             **settings: Any) -> Any:
    """The orientation of each track at the rows of another table, such as a camera's at the times of a sensor.

    `at` has the columns `by` and `time`, and any others: its rows come back, track by track in the order of time, each
    with all of its columns and with those of the orientation. Where `at` is a frame of pandas or Polars it is that frame which comes
    back, in its order, with the new columns behind its own. `keys` and the other arguments are those of `resample`. A
    time outside the keys of its track has no orientation and says so in `error`, and stamps with a time zone do not meet those
    without one; `extrapolate="hold"`, `"rate"` or
    `"segment"` give it one, as of `Curve`. `errors="drop"` leaves rows without an orientation out.

    A track is held as a whole, and its rows with it.

    Examples
    --------
    >>> import orispline.tables as tables, pyarrow as pa
    >>> keys = pa.table({"track": [7, 7], "t": [0.0, 1.0], "qx": [0.0] * 2, "qy": [0.0] * 2, "qz": [0.0, 0.6], "qw": [1.0, 0.8]})
    >>> at = pa.table({"track": [7, 7], "t": [0.5, 1.5], "range_m": [12.5, 12.0]})
    >>> tables.evaluate(keys, at).read_all().select(["t", "range_m", "qw", "error"]).to_pylist()
    [{'t': 0.5, 'range_m': 12.5, 'qw': 0.9486832980505138, 'error': None}, \
{'t': 1.5, 'range_m': 12.0, 'qw': None, 'error': 'found a time outside the keys of the track'}]
    """
    columns = layout(by, time, quaternion, position, normalize, normalise)
    check(progress)

    def work(other: Source, keys: Any) -> Any:
        kind = beside_schema(columns, other.schema)
        if not kind_of(at):
            tell_of_types(time, other.schema.field(time).type, kind.field(time).type, None)
        given = source_of(index_as_columns(keys, columns), "keys")
        given = selected(given, columns.read(given.schema, "keys"), columns, "keys")
        rows = selected(other, kind, Layout(columns.by, columns.time, ()), "at")
        schema, job = evaluation(columns, given.schema, rows.schema, method, derivatives, frame, extrapolate, errors, threads, dict(settings))
        count = None if given.rows is None or rows.rows is None else given.rows + rows.rows
        both = Source(schema, Both(given, rows, schema), given.in_memory and rows.in_memory, count)
        order = [*columns.by, SIDE, columns.time]
        made = counted(both, lambda: ordered(both, order, assume_sorted=False, threads=job.threads, memory_limit=memory_limit), progress)
        return reader(job, both, made, other)

    return beside(at, keys, columns, work)


def smooth(source: Any, *, by: str | Sequence[str] = "track", time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION,
           position: Sequence[str] | None = None, rate: Any = None, derivatives: int = 1, frame: str = "body",
           errors: str = "row", normalize: bool = False, normalise: bool = False, assume_sorted: bool = False, threads: int = 0,
           memory_limit: str = "1GB", progress: Progress | bool | None = None, **options: Any) -> Any:
    """Every track without its noise, with rates, at the times of its keys or at `rate` per second.

    `options` are those of `orispline.smooth`, the others those of `resample`. Warnings are given once for each kind, with
    the number of tracks. A track is held as a whole.
    """
    columns = layout(by, time, quaternion, position, normalize, normalise)
    job = smoothing(columns, rate, derivatives, frame, errors, threads, options)
    return run(job, source, assume_sorted=assume_sorted, memory_limit=memory_limit, progress=progress)


def reduce(source: Any, tolerance: Any, *, by: str | Sequence[str] = "track", time: str = "t",
           quaternion: Sequence[str] = UNIT_QUATERNION, position: Sequence[str] | None = None, errors: str = "row", normalize: bool = False,
           normalise: bool = False, assume_sorted: bool = False, threads: int = 0, memory_limit: str = "1GB",
           progress: Progress | bool | None = None, **options: Any) -> Any:
    """The fewest keys of every track whose curve stays within the tolerance: a number [rad], or a text such as `"0.1deg"`.

    The column `method` says which curve goes through them. `method="hermite-c1"` seeks the rates of the keys too and adds
    the columns `wx`, `wy`, `wz` [rad/s], body frame. `options` are those of `orispline.reduce`, the others those of
    `resample`. A track is held as a whole.
    """
    columns = layout(by, time, quaternion, position, normalize, normalise)
    job = reduction(columns, tolerance, errors, threads, options)
    return run(job, source, assume_sorted=assume_sorted, memory_limit=memory_limit, progress=progress)


def mean(source: Any, *, by: str | Sequence[str] = "track", every: Any = None, kind: str = "mean", weight: str | None = None,
         time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION, position: Sequence[str] | None = None, errors: str = "row",
         normalize: bool = False, normalise: bool = False, assume_sorted: bool = False, threads: int = 0, memory_limit: str = "1GB",
         progress: Progress | bool | None = None) -> Any:
    """The mean or the median of every group of rows, or of its windows in time, as of `orispline.mean`.

    Parameters
    ----------
    by : str or list of str
        The columns that tell groups apart.
    every : number or str, optional
        Length of windows in time, such as `"0.5s"`; the first one begins at the first row of its group. Without it each group has one
        mean, and a column of times is not needed.
    kind : {"mean", "median", "chordal"}
        Which middle.
    weight : str, optional
        The column of weights, 0 or more.
    others
        As of `resample`.

    Returns
    -------
    of the kind of the source, as of `resample`
        The columns of `by`, with `every` the middle of the window in the column of time, those of quaternion and position, then `count`,
        `weight_sum`, `rms_distance_rad`, `largest_distance_rad`, `sigma_x_rad` … (one standard deviation of the mean along the axes of its
        body), `certified`, whether it is proved to be the only one, and `error`.

    Examples
    --------
    >>> import orispline.tables as tables, pyarrow as pa
    >>> shots = pa.table({"camera": ["b", "a", "a"], "qx": [0.0] * 3, "qy": [0.0] * 3, "qz": [0.0, 0.6, 0.0], "qw": [1.0, 0.8, 1.0]})
    >>> tables.mean(shots, by="camera").read_all().select(["camera", "count", "certified"]).to_pylist()
    [{'camera': 'a', 'count': 2, 'certified': True}, {'camera': 'b', 'count': 1, 'certified': True}]
    """
    job = averaging(by, every, kind, weight, time, quaternion, position, errors, threads, normalize, normalise)
    return run(job, source, assume_sorted=assume_sorted, memory_limit=memory_limit, progress=progress)


def compare(source: Any, methods: Sequence[Method] | Method | None = None, keep_every: int | Sequence[int] = 8, *,
            by: str | Sequence[str] = "track", time: str = "t", quaternion: Sequence[str] = UNIT_QUATERNION, errors: str = "row",
            normalize: bool = False, normalise: bool = False, assume_sorted: bool = False, threads: int = 0, memory_limit: str = "1GB",
            progress: Progress | bool | None = None, **options: Any) -> Any:
    """How near the curves of methods come to every track, of which some samples become keys: a row for each track and method.

    The columns are the members of `orispline compare --json`, but for the times that it took. `options` are those of
    `orispline.compare`, the others those of `resample`. A track is held as a whole.
    """
    columns = layout(by, time, quaternion, None, normalize, normalise)
    job = comparison(columns, methods, keep_every, errors, threads, options)
    return run(job, source, assume_sorted=assume_sorted, memory_limit=memory_limit, progress=progress)


Job = Resampling | PerTrack


def resampling(columns: Layout, rate: Any, align: str, method: Method, derivatives: int, frame: str, gap: float | None, errors: str,
               threads: int, settings: dict[str, Any]) -> Resampling:
    """The job of these arguments."""
    job = Resampling(columns, _method(method, settings), rate_text(rate), index_of("align", align, ALIGNMENTS) == 1,
                     None if gap is None else real("gap", gap), _derivatives(derivatives), in_world(frame),
                     _errors(errors), thread_count(threads))
    return job


def resampling_of(options: dict[str, Any]) -> Resampling:
    """The job of `resample` with these options."""
    given = inspect.signature(resample).bind(None, **options)
    given.apply_defaults()
    a = given.arguments
    columns = layout(a["by"], a["time"], a["quaternion"], a["position"], a["normalize"], a["normalise"])
    return resampling(columns, a["rate"], a["align"], a["method"],
                      a["derivatives"], a["frame"], a["gap"], a["errors"], a["threads"], dict(a["settings"]))


def smoothing(columns: Layout, rate: Any, derivatives: int, frame: str, errors: str, threads: int, options: dict[str, Any]) -> PerTrack:
    """The job of these arguments."""
    if options.get("sigma"):
        raise ArgumentError("sigma: a table of tracks has no columns for it, wanted orispline.smooth for each track")
    work = Smoothing(None if rate is None else rate_text(rate), _derivatives(derivatives), FRAMES[index_of("frame", frame, FRAMES)],
                     options)
    return PerTrack(columns, work, _errors(errors), thread_count(threads))


def reduction(columns: Layout, tolerance: Any, errors: str, threads: int, options: dict[str, Any]) -> PerTrack:
    """The job of these arguments."""
    return PerTrack(columns, Reduction(tolerance, options), _errors(errors), thread_count(threads))


def averaging(by: Any, every: Any, kind: str, weight: Any, time: Any, quaternion: Any, position: Any, errors: str, threads: int,
              normalize: bool, normalise: bool) -> PerTrack:
    """The job of these arguments."""
    columns = set_layout(by, None if every is None else time, quaternion, position, weight, normalize, normalise)
    return PerTrack(columns, Means({"kind": kind, "every": every}), _errors(errors), thread_count(threads))


def comparison(columns: Layout, methods: Any, keep_every: Any, errors: str, threads: int, options: dict[str, Any]) -> PerTrack:
    """The job of these arguments."""
    work = Comparison({**options, "methods": methods, "keep_every": keep_every})
    return PerTrack(columns, work, _errors(errors), thread_count(threads))


def evaluation(columns: Layout, keys: Any, at: Any, method: Method, derivatives: int, frame: str, extrapolate: Extrapolate, errors: str,
               threads: int, settings: dict[str, Any]) -> tuple[Any, PerTrack]:
    """The schema of the rows of both tables together, of tables with these schemas, and the job for them."""
    beside = tuple(name for name in at.names if name not in (*columns.by, columns.time))
    work = Evaluation(_method(method, settings), _derivatives(derivatives), FRAMES[index_of("frame", frame, FRAMES)],
                      BEYOND[index_of("extrapolate", extrapolate, BEYOND)], at.field(columns.time).type, beside)
    names = [SIDE, *sampled_schema(columns, keys, work.derivatives, work.frame == "world").names]
    for name in beside:
        check_new(name, names)
    return united(columns, keys, at, beside), PerTrack(columns, work, _errors(errors), thread_count(threads))


def beside_schema(columns: Layout, at: Any) -> Any:
    """The columns of the other table as they are read. Raises ArgumentError where one is missing or of a type that it cannot have."""
    for name in columns.order:
        check_once("at", at.names, name, columns.time)
    roles = {**dict.fromkeys(columns.by, id_type), columns.time: time_type}
    return pa.schema([pa.field(field.name, roles[field.name]("at", field.name, field.type) if field.name in roles else plain_type(field.type))
                      for field in at])


@dataclasses.dataclass(frozen=True)
class Both:
    """The rows of keys, then those of another table, under one schema."""

    keys: Source
    at: Source
    schema: Any

    def __iter__(self) -> Iterator[Any]:
        for side, source in enumerate((self.keys, self.at)):
            row = 0
            for batch in source.batches:
                columns = [self._column(batch, field, side, row) for field in self.schema]
                yield pa.RecordBatch.from_arrays(columns, schema=self.schema)
                row += batch.num_rows

    @staticmethod
    def _column(batch: Any, field: Any, side: int, row: int) -> Any:
        if field.name == SIDE:
            return pa.array(np.full(batch.num_rows, side, np.int8))
        if field.name not in batch.schema.names:
            return pa.nulls(batch.num_rows, field.type)
        return converted(batch.column(field.name), field.type, SIDES[side], field.name, row)


def run(job: Job, given: Any, *, assume_sorted: bool, memory_limit: str, progress: Progress | bool | None) -> Any:
    """What a job makes of a source, in its kind of frame."""
    assume_sorted, memory_limit = flag("assume_sorted", assume_sorted), text("memory_limit", memory_limit)
    check(progress)

    def work(source: Source) -> Any:
        rows = selected(source, job.layout.read(source.schema), job.layout)
        made = reader(job, rows, counted(rows, lambda: ordered(rows, job.layout.order, assume_sorted=assume_sorted, threads=job.threads,
                                                               memory_limit=memory_limit), progress), source)
        if job.layout.time in made.schema.names:
            job.layout.tell_of_times(source.schema.field(job.layout.time).type, job.step)
        return made

    return answered(given, job.layout, work)


def reader(job: Job, source: Source, rows: Callable[[], Iterable[Any]], described: Source) -> Any:
    """The job's rows, made as they are asked for, with what the fields of that source say of themselves."""
    job.check()
    schema = with_metadata(job.answer(source.schema).schema, described)
    return giving(schema, lambda: job(rows(), source.schema))


def counted(source: Source, rows: Callable[[], Iterable[Any]], progress: Progress | bool | None) -> Callable[[], Iterable[Any]]:
    """The same rows, of which somebody is told how many have passed."""
    if progress is None or progress is False:
        return rows

    def watched() -> Iterator[Any]:
        done = 0
        with telling(progress, source.rows) as tell:
            for batch in rows():
                yield batch
                done += batch.num_rows
                tell(done)

    return watched


def _method(method: Method, settings: dict[str, Any]) -> str:
    shape = {name: settings.pop(name, None) for name in ("ends", "start_rate", "end_rate", "period")}
    return method_text(method, shape["ends"], shape["start_rate"], shape["end_rate"], settings.pop("closed", False), shape["period"],
                       settings)


def _derivatives(derivatives: Any) -> int:
    return whole("derivatives", derivatives, 0, 3)


def _errors(errors: str) -> str:
    return ERRORS[index_of("errors", errors, ERRORS)]
