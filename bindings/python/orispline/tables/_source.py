# SPDX-License-Identifier: Apache-2.0
"""Where keys come from: files, tables and streams, as record batches whose rows are in order."""
from __future__ import annotations

import contextlib
import dataclasses
import glob
import os
import pathlib
import shutil
import tempfile
from collections.abc import Iterable, Iterator, Sequence
from typing import Any

import pyarrow as pa
import pyarrow.dataset as ds
import pyarrow.parquet as pq
from pyarrow.fs import LocalFileSystem

from .._errors import AccessError, ArgumentError, DataError, Error
from ._kinds import converted, part, plain, plain_type, read
from ._layout import Layout
from ._readers import taken
from ._spark_files import noted
from ._tracks import ROWS_AT_A_TIME, in_order

ROWS_OF_DUCKDB = 1 << 14  # in a batch: what it holds of them lies beyond its memory_limit
WANTED = "Parquet files, a pyarrow table, dataset or reader, or what has __arrow_c_stream__"


@dataclasses.dataclass(frozen=True)
class Source:
    """Rows of some columns, not read yet. `schema` is that of the columns, dictionaries written out."""

    schema: Any
    batches: Iterable[Any]
    in_memory: bool = False
    rows: int | None = None  # as far as that is known


def source_of(given: Any, what: str = "source") -> Source:
    """Of files, tables and streams. Raises TypeError for anything else, AccessError for files that cannot be read."""
    if isinstance(given, (str, os.PathLike)) or isinstance(given, (list, tuple)) and given and all(
            isinstance(path, (str, os.PathLike)) for path in given):
        return _files(given, what)
    if isinstance(given, pa.RecordBatch):
        given = pa.Table.from_batches([given])
    if isinstance(given, pa.Table) or is_frame(given):
        table = given if isinstance(given, pa.Table) else table_of(given, what)
        return Source(table.schema, table.to_batches(max_chunksize=ROWS_AT_A_TIME), True, table.num_rows)
    if isinstance(given, ds.Dataset):
        return _of_dataset(given)
    if isinstance(given, pa.RecordBatchReader) or hasattr(given, "__arrow_c_stream__"):
        return Source(*taken(given, what))
    raise TypeError(f"{what}: found {type(given).__name__}, wanted {WANTED}")


def table_of(frame: Any, what: str) -> Any:
    """A frame of pandas or Polars as a table. Raises ArgumentError, with the column, where it is none."""
    frame = frame.collect() if hasattr(frame, "collect") else frame
    try:
        return _arrow_of(frame)
    except (pa.ArrowException, TypeError) as error:  # such as a column of numbers and texts, or 128 bits
        reason = str(error.args[0] if error.args else error).splitlines()[0]
        raise ArgumentError(f"{what}: found a data frame that is no table ({_column_at_fault(frame)}{reason}), wanted columns of one type "
                            "each that pyarrow has") from None


def _arrow_of(frame: Any) -> Any:
    if hasattr(frame, "to_arrow"):
        return frame.to_arrow()
    table = pa.table(frame)
    if table.num_rows:
        return table
    of_texts = [field.with_type(pa.string()) if pa.types.is_null(field.type) else field for field in table.schema]
    return table.cast(pa.schema(of_texts, table.schema.metadata))  # pandas says of texts without rows only that they are objects


def _column_at_fault(frame: Any) -> str:
    """The first column that is none of a table, with its type, in words."""
    for name in frame.columns:
        try:
            _arrow_of(frame[[name]])
        except (pa.ArrowException, TypeError):
            return f"{frame[name].dtype} in the column {name!r}: "
    return ""


def is_frame(given: Any) -> bool:
    """One of pandas or Polars, which is in memory or is made there."""
    library, _, _ = type(given).__module__.partition(".")
    return library in ("pandas", "polars") and type(given).__name__ in ("DataFrame", "LazyFrame")


def files_named(path: str) -> list[str]:
    """Those that a path or a pattern names; the name of a file that is there is no pattern. Raises AccessError for none."""
    if os.path.lexists(path) or not glob.has_magic(path):
        return [path]
    found = sorted(glob.glob(path, recursive=True))
    if not found:
        raise AccessError(f"{path}: found no such file")
    return found


def _files(given: Any, what: str) -> Source:
    """Paths, patterns and folders as one source. Every file is looked at before anything is read."""
    found: list[str] = []
    listed = [given] if isinstance(given, (str, os.PathLike)) else given
    for path in map(os.fspath, listed):
        if "://" in path and not os.path.lexists(path):
            if len(listed) > 1:
                raise ArgumentError(f"{what}: found {path!r} among several, wanted one address, or files of this machine")
            return _of_dataset(ds.dataset(path, format="parquet", partitioning="hive"))
        named = files_named(path)
        inside = [file for each in named for file in (sorted(map(str, pathlib.Path(each).rglob("*.parquet"))) if os.path.isdir(each) else [each])]
        found += inside if inside == [path] else noted(inside)
    if not found:
        raise AccessError(f"{os.fspath(listed[0])}: found no Parquet file in it")
    rows = 0
    for path in found:
        with telling_of(path):
            rows += pq.read_metadata(path).num_rows
    base = os.path.commonpath([os.path.dirname(os.path.abspath(path)) for path in found])
    return _of_dataset(ds.dataset([os.path.abspath(path) for path in found], format="parquet",
                                  partitioning=ds.partitioning(flavor="hive"), partition_base_dir=base), rows)


@contextlib.contextmanager
def telling_of(path: str) -> Iterator[None]:
    """What pyarrow finds wrong with a file, in one line."""
    try:
        yield
    except FileNotFoundError:
        found: Error = AccessError(f"{path}: found no such file")
    except (pa.ArrowInvalid, pa.ArrowNotImplementedError, OSError) as error:
        reason = str(error).splitlines()[0] if str(error) else type(error).__name__
        if isinstance(error, OSError) and error.errno is not None:
            found = AccessError(f"{path}: cannot be read: {error.strerror or reason}")
        else:
            found = DataError(f"{path}: found no sound Parquet file ({reason}), wanted one that is whole")
    else:
        return
    found.file = path
    raise found from None


def _of_dataset(dataset: Any, rows: int | None = None) -> Source:
    return Source(dataset.schema, _Scanned(dataset), rows=rows)


@dataclasses.dataclass(frozen=True)
class _Scanned:
    """The batches of a dataset, file by file in their order; `columns` only, if they are named."""

    dataset: Any
    columns: tuple[str, ...] | None = None

    def __iter__(self) -> Iterator[Any]:
        names = list(self.columns or self.dataset.schema.names)
        for fragment in self.dataset.get_fragments():
            path, row = getattr(fragment, "path", "source"), 0
            with telling_of(path):
                for batch in self._of(fragment, names):
                    for column in batch.columns:
                        if not pa.types.is_primitive(column.type):  # texts that are not UTF-8: pyarrow does not look
                            column.validate(full=True)
                    yield self._in_types(batch, path, row)
                    row += batch.num_rows

    def _in_types(self, batch: Any, path: str, row: int) -> Any:
        """A batch of a file with the types of the dataset, dictionaries written out."""
        names = batch.schema.names
        kinds = [plain_type(self.dataset.schema.field(name).type) for name in names]
        return pa.RecordBatch.from_arrays([converted(plain(column), kind, path, name, row)
                                           for column, kind, name in zip(batch.columns, kinds, names)], names)

    def _of(self, fragment: Any, names: list[str]) -> Iterator[Any]:
        if isinstance(fragment, ds.ParquetFileFragment) and isinstance(fragment.filesystem, LocalFileSystem) \
                and set(names) <= set(fragment.physical_schema.names):
            yield from _bit_by_bit(fragment.path, names)
        else:
            yield from fragment.to_batches(schema=self.dataset.schema, columns=names, batch_size=ROWS_AT_A_TIME, batch_readahead=1)


def _bit_by_bit(path: str, names: list[str]) -> Iterator[Any]:
    """A file without ever holding a whole row group of it, as datasets do."""
    with pq.ParquetFile(path, buffer_size=1 << 20, pre_buffer=False) as file:
        yield from file.iter_batches(ROWS_AT_A_TIME, columns=names, use_threads=False)


def with_metadata(schema: Any, source: Source) -> Any:
    """A schema whose fields have what those of the same names say of themselves in the source; of one that is no file the schema too."""
    names = source.schema.names
    fields = [field.with_metadata(_own(source.schema.field(field.name).metadata)) if names.count(field.name) == 1 else field for field in schema]
    return pa.schema(fields, None if isinstance(source.batches, _Scanned) else _own(source.schema.metadata))


def _own(metadata: Any) -> dict[bytes, bytes] | None:
    """Without what pandas, Arrow and Parquet say there of types and places that the result has not."""
    return {key: value for key, value in (metadata or {}).items() if key != b"pandas" and not key.startswith((b"ARROW:", b"PARQUET:"))} or None


def selected(source: Source, schema: Any, layout: Layout, what: str = "source") -> Source:
    """Of the columns of that schema only, as that says, out of those that the layout reads them from."""
    batches = source.batches
    if isinstance(batches, _Scanned):
        batches = dataclasses.replace(batches, columns=tuple(dict.fromkeys(layout.place(name)[0] for name in schema.names)))
    return Source(schema, _Selected(batches, schema, layout, what), source.in_memory, source.rows)


@dataclasses.dataclass(frozen=True)
class _Selected:
    batches: Iterable[Any]
    schema: Any
    layout: Layout
    what: str

    def __iter__(self) -> Iterator[Any]:
        for batch in self.batches:
            yield pa.RecordBatch.from_arrays([self._column(batch, field) for field in self.schema], schema=self.schema)

    def _column(self, batch: Any, field: Any) -> Any:
        name, names, k = self.layout.place(field.name)
        column = batch.column(name)
        return read(part(column, names, k) if names else column, field.type, self.what, name)


def ordered(source: Source, order: Sequence[str], *, assume_sorted: bool, threads: int, memory_limit: str) -> Iterator[Any]:
    """Its batches with the rows in order of those columns, the last of which is the time."""
    if assume_sorted:
        return in_order(source.batches, order[:-1])
    if source.in_memory:
        table = pa.Table.from_batches(list(source.batches), source.schema)
        return iter(table.sort_by([(name, "ascending") for name in order]).to_batches(max_chunksize=ROWS_AT_A_TIME))
    return _by_duckdb(source, order, threads, memory_limit)


def _by_duckdb(source: Source, order: Sequence[str], threads: int, memory_limit: str) -> Iterator[Any]:
    """DuckDB has stamps to the microsecond only where they have a time zone: here they pass as the integers that they are."""
    try:
        import duckdb
    except ImportError:
        raise ImportError("orispline.tables: found no duckdb, which puts files and streams in order, wanted it installed: "
                          "pip install 'orispline[tables]'") from None
    schema = pa.schema([pa.field(f"c{i}", _carrier(field.type)) for i, field in enumerate(source.schema)])
    failures: list[BaseException] = []
    reader = pa.RecordBatchReader.from_batches(schema, _carried(source.batches, schema, failures))
    folder = tempfile.mkdtemp(prefix="orispline-")
    connection = duckdb.connect()
    try:
        try:
            connection.execute(f"SET memory_limit = {_quoted(memory_limit)}")
        except duckdb.Error:
            raise ArgumentError(f"memory_limit: found {memory_limit!r}, wanted a size such as '1GB'") from None
        connection.execute(f"SET temp_directory = {_quoted(folder)}")
        connection.execute("SET preserve_insertion_order = false")
        connection.execute("SET enable_progress_bar = false")  # it would go to standard output
        if threads:
            connection.execute(f"SET threads = {threads}")
        connection.register("given", reader)
        keys = ", ".join(f"c{source.schema.names.index(name)} ASC NULLS LAST" for name in order)
        result = connection.sql(f"SELECT * FROM given ORDER BY {keys}")
        read = result.to_arrow_reader if hasattr(result, "to_arrow_reader") else result.fetch_arrow_reader  # its name until 1.4
        for batch in read(ROWS_OF_DUCKDB):
            yield pa.RecordBatch.from_arrays([_uncarried(column, field.type) for column, field in zip(batch.columns, source.schema)],
                                             schema=source.schema)
    except Exception as error:
        if failures:
            raise failures[0] from None
        if isinstance(error, duckdb.OutOfMemoryException):
            raise ArgumentError(f"memory_limit: found {memory_limit!r}, which does not do to put these rows in order, wanted "
                                "more") from None
        if isinstance(error, duckdb.Error):  # such as a disk that is full
            raise AccessError(f"{folder}: cannot put the rows in order there: {str(error).splitlines()[0]}") from None
        raise
    finally:
        connection.close()
        shutil.rmtree(folder, ignore_errors=True)


def _quoted(text: str) -> str:
    """As SQL has it: version 1.0 takes no parameters of settings."""
    return "'" + text.replace("'", "''") + "'"


def _carrier(kind: Any) -> Any:
    """The type as which DuckDB takes a column: the same wherever it can hold and order it."""
    types = pa.types
    if types.is_timestamp(kind) or types.is_duration(kind) or types.is_time64(kind) or types.is_date64(kind):
        return pa.int64()
    if types.is_time32(kind):
        return pa.int32()
    if types.is_fixed_size_binary(kind):
        return pa.binary()
    if types.is_null(kind) or types.is_boolean(kind):  # whose bits version 1.0 mistakes in a slice of a batch
        return pa.int8()
    return pa.float32() if types.is_float16(kind) else kind


def _uncarried(column: Any, kind: Any) -> Any:
    return pa.nulls(len(column)) if pa.types.is_null(kind) else column.cast(kind)


def _carried(batches: Iterable[Any], schema: Any, failures: list[BaseException]) -> Iterator[Any]:
    """For DuckDB, which makes a text of an exception: it is kept in `failures`."""
    try:
        for batch in batches:
            yield pa.RecordBatch.from_arrays([column.cast(field.type) for column, field in zip(batch.columns, schema)], schema=schema)
    except BaseException as failure:
        failures.append(failure)
        raise
