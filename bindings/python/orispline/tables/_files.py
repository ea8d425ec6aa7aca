# SPDX-License-Identifier: Apache-2.0
"""Parquet files out of a stream: complete, or not at all."""
from __future__ import annotations

import concurrent.futures
import contextlib
import errno
import functools
import json
import os
import pathlib
import queue
import shutil
import tempfile
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import pyarrow as pa
import pyarrow.csv
import pyarrow.dataset as ds
import pyarrow.parquet as pq

from .. import _core
from .._errors import AccessError, ArgumentError, Error
from ._readers import taken
from ._sealed import Summary, close, seal, sealed
from ._source import files_named, is_frame, table_of

ROWS_OF_A_GROUP = 1 << 17
COMPRESSION = "zstd"
PARQUET, ARROW, CSV = (".parquet", ".pq"), (".arrow", ".feather"), (".csv",)


class _Counted:
    """Counts the rows of batches that pass."""

    def __init__(self) -> None:
        self.rows = self.errors = 0
        self.messages: list[str] = []

    def add(self, batch: Any) -> None:
        self.rows += batch.num_rows
        if "error" not in batch.schema.names:
            return
        column = batch.column("error")
        bad = len(column) - column.null_count
        self.errors += bad
        if bad and len(self.messages) < 3:
            rows = batch.filter(column.is_valid()).slice(0, 3 - len(self.messages)).to_pylist()
            self.messages += [_in_words(row) for row in rows]

    def summary(self, path: str) -> Summary:
        return Summary(path, self.rows, self.errors, tuple(self.messages))


def _in_words(row: dict[str, Any]) -> str:
    """The error of a row, and the track as far as its ids are there."""
    ids = ", ".join(f"{name} {value!r}" for name, value in row.items() if value is not None and name != "error")
    return f"{ids}: {row['error']}"


def write(reader: Any, path: Any, partition_by: str | Sequence[str] | None = None) -> Summary:
    """Writes a stream, such as `resample` gives, as a file: Parquet if it ends in `.parquet` or `.pq` or has no ending, Arrow if it
    ends in `.arrow` or `.feather`, CSV if it ends in `.csv`.

    With `partition_by`, one or several columns, as a folder of files such as `track=7/part-0.parquet`. It is written
    beside its place and renamed at the end: what was there stays until then, and for good if something goes wrong. A
    symbolic link stays, and the file that it leads to is written. A folder must not be there before.

    Raises ArgumentError for another ending and for a reader that has been read to its end, AccessError for what cannot be written,
    and whatever the stream raises.

    Examples
    --------
    >>> import orispline.tables as tables, pyarrow as pa, pathlib, tempfile
    >>> keys = pa.table({"track": [1, 1], "t": [0.0, 1.0], "qx": [0.0] * 2, "qy": [0.0] * 2, "qz": [0.0, 0.6], "qw": [1.0, 0.8]})
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "motion.parquet"
    >>> tables.write(tables.resample(keys, rate=10), path).rows
    11
    """
    return written(reader, path, partition_by)


def written(reader: Any, path: Any, partition_by: str | Sequence[str] | None = None, made_by: str | None = None,
            shown: Callable[[int], None] | None = None) -> Summary:
    """The same, with somebody who is told of the rows so far; a file that says by what it was made is sealed."""
    if is_frame(reader):
        reader = table_of(reader, "reader")
        messages = reader.schema.get_field_index("error")
        if messages >= 0 and pa.types.is_null(reader.schema.field(messages).type):  # as which Arrow has a column of pandas without any
            reader = reader.set_column(messages, "error", pa.nulls(len(reader), pa.string()))
    if not hasattr(reader, "__arrow_c_stream__"):
        raise TypeError(f"reader: found {type(reader).__name__}, wanted a pyarrow reader or table or a frame, such as resample() gives")
    place = os.fspath(path)
    ending = PARQUET[0] if partition_by is not None or made_by is not None else _ending(place)
    schema, stream = taken(reader, "reader")
    _check_types(ending, schema)
    counted = _Counted()

    def batches() -> Iterator[Any]:
        for batch in stream:
            counted.add(batch)
            if shown is not None:
                shown(counted.rows)
            yield batch

    if partition_by is None:
        with _beside(place) as part:
            with _writer(part, ending, schema) as writer:
                for group in _groups(batches()):
                    writer.write_table(pa.Table.from_batches(group, schema), ROWS_OF_A_GROUP)
                if made_by is not None:
                    writer.add_key_value_metadata(seal(made_by, counted.summary(place)))
            if made_by is not None:
                close(part)
    else:
        names = [partition_by] if isinstance(partition_by, str) else list(partition_by)
        for name in names:
            if name not in schema.names:
                raise ArgumentError(f"partition_by: found {name!r}, wanted one of {', '.join(map(repr, schema.names))}")
        if os.path.lexists(place):
            raise AccessError(f"{place}: is there already, wanted a folder that is not")
        with _beside(place) as part:
            kinds = pa.schema([schema.field(name) for name in names])
            write = functools.partial(
                ds.write_dataset, base_dir=part, format="parquet", partitioning=ds.partitioning(kinds, flavor="hive"),
                basename_template="part-{i}.parquet", max_partitions=1 << 20,
                file_options=ds.ParquetFileFormat().make_write_options(compression=COMPRESSION))
            _handed(schema, batches(), write)
    return counted.summary(place)


def _handed(schema: Any, batches: Iterator[Any], write: Callable[[Any], None]) -> None:
    """Batches of this thread, written by another: where pyarrow 17 asks for them in a thread of its own, DuckDB comes to a standstill."""
    waiting: queue.Queue[Any] = queue.Queue(4)
    with concurrent.futures.ThreadPoolExecutor(1) as pool:
        job = pool.submit(lambda: write(pa.RecordBatchReader.from_batches(schema, iter(waiting.get, None))))

        def hand(batch: Any) -> None:
            while not job.done():
                with contextlib.suppress(queue.Full):
                    waiting.put(batch, timeout=0.1)
                    return

        try:
            for batch in batches:
                hand(batch)
                if job.done():  # of an error
                    break
        finally:
            hand(None)
        job.result()


def _ending(place: str) -> str:
    """Which says what kind of file it is. Raises ArgumentError for one that says nothing known; without any it is Parquet."""
    ending = os.path.splitext(place)[1].lower()
    if ending and ending not in PARQUET + ARROW + CSV:
        raise ArgumentError(f"path: found {place}, wanted a name that ends in .parquet, .arrow or .csv: the ending says what is written")
    return ending


def _writer(part: str, ending: str, schema: Any) -> Any:
    """Of a file of that kind."""
    if ending in ARROW:
        return pa.ipc.new_file(part, schema)
    if ending in CSV:
        return pyarrow.csv.CSVWriter(part, schema)
    return pq.ParquetWriter(part, schema, compression=COMPRESSION, use_dictionary=_repeated(schema))


def _check_types(ending: str, schema: Any) -> None:
    """Raises ArgumentError for a column that such a file cannot have."""
    for field in schema:
        try:
            if ending in CSV and "binary" in str(field.type):
                raise pa.ArrowInvalid("bytes are no text")
            with _writer(pa.BufferOutputStream(), ending, pa.schema([field])) as writer:
                writer.write_table(pa.schema([field]).empty_table())
        except pa.ArrowException as error:
            raise ArgumentError(f"path: found {field.type} in the column {field.name!r}, which pyarrow cannot write to a file of this kind "
                                f"({str(error).splitlines()[0]}), wanted it cast, or another ending") from None


def _repeated(schema: Any) -> list[str]:
    """The columns in which values come again and again. Looking for such among samples costs time and memory."""
    return [field.name for field in schema if not pa.types.is_floating(field.type) and not pa.types.is_timestamp(field.type)]


def _groups(batches: Iterator[Any]) -> Iterator[list[Any]]:
    """Batches enough for a row group."""
    held: list[Any] = []
    rows = 0
    for batch in batches:
        held.append(batch)
        rows += batch.num_rows
        if rows >= ROWS_OF_A_GROUP:
            yield held
            held, rows = [], 0
    yield held


@contextlib.contextmanager
def _beside(place: str) -> Iterator[str]:
    """A place beside another, which it takes when all is done; else it is removed. Of a link, the place that it leads to."""
    target = os.path.realpath(place)
    refusal = _refusal(target)
    if refusal is not None:
        raise AccessError(f"{place}: cannot be written: {os.strerror(refusal)}")
    folder, name = os.path.split(target)
    try:
        scratch = tempfile.mkdtemp(prefix=f".{name}.", dir=folder)
    except OSError as error:
        raise AccessError(f"{place}: cannot be written: {error.strerror}") from None
    part = os.path.join(scratch, "part")
    try:
        yield part
        _sync(part)
        if os.path.exists(target):
            shutil.copymode(target, part)
        os.replace(part, target)
    except Error:
        raise
    except OSError as error:
        raise AccessError(f"{place}: cannot be written: {error.strerror or str(error).splitlines()[0]}") from None
    finally:
        shutil.rmtree(scratch, ignore_errors=True)


def _refusal(target: str) -> int | None:
    """Why what is there may not be replaced, if so."""
    if os.path.islink(target):  # behind all links there is none, unless they go in a circle
        return errno.ELOOP
    if not os.path.exists(target):
        return None
    if os.path.isdir(target):
        return errno.EISDIR
    if not os.path.isfile(target):  # a device or a pipe, whose place no file may take
        return errno.EINVAL
    return None if os.access(target, os.W_OK) else errno.EACCES


def _sync(part: str) -> None:
    """So that a complete name never holds half a file, whatever happens to the machine."""
    for path in [part] if os.path.isfile(part) else map(str, pathlib.Path(part).rglob("*.parquet")):
        handle = os.open(path, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)


def resample_files(paths: Any, folder: Any, **options: Any) -> list[Summary]:
    """Resamples files one by one: each becomes one of the same name in `folder`, which is made if need be.

    `options` are those of `resample`. A track must not be spread over several files. A file that is there already, was made
    of the same content with the same options, and has every byte that it had then is not made again: begun anew after an
    interruption, only what is missing or damaged is made. A file that cannot be read ends the work.

    Examples
    --------
    >>> import orispline.tables as tables, pyarrow as pa, pyarrow.parquet as pq, pathlib, tempfile
    >>> folder = pathlib.Path(tempfile.mkdtemp())
    >>> keys = pa.table({"track": [1, 1], "t": [0.0, 1.0], "qx": [0.0] * 2, "qy": [0.0] * 2, "qz": [0.0, 0.6], "qw": [1.0, 0.8]})
    >>> pq.write_table(keys, folder / "monday.parquet")
    >>> [summary.rows for summary in tables.resample_files(folder / "*.parquet", folder / "out", rate=10)]
    [11]
    """
    from ._jobs import resample, resampling_of
    listed = [paths] if isinstance(paths, (str, os.PathLike)) else list(paths)
    inputs = [path for each in listed for path in files_named(os.fspath(each))]
    names = [os.path.basename(path) for path in inputs]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ArgumentError(f"paths: found two files named {twice!r}, wanted different names: each gives its own to what is made of it")
    os.makedirs(folder, exist_ok=True)
    summaries = []
    for path in inputs:
        place = os.path.join(os.fspath(folder), os.path.basename(path))
        if os.path.exists(place) and os.path.samefile(path, place):
            raise ArgumentError(f"folder: found that of {path}, wanted another one: the keys would be lost")
        reader = resample(path, **options)
        made_by = _made_by(path, resampling_of(options))
        done = sealed(place, made_by)
        summaries.append(done if done is not None else written(reader, place, made_by=made_by))
    return summaries


def _made_by(path: str, job: Any) -> str:
    """Of what a file is made and how, as text that is the same whenever these are."""
    state = os.stat(path)
    return json.dumps({"version": _core.version, "bytes": state.st_size, "changed": state.st_mtime_ns, "job": job.stated},
                      sort_keys=True)
