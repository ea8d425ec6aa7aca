# SPDX-License-Identifier: Apache-2.0
"""Jobs of tables, run on the partitions of a data frame."""
from __future__ import annotations

import inspect
import pickle
from collections.abc import Callable, Iterator, Sequence
from typing import Any

import pyarrow as pa
from pyspark.sql import functions
from pyspark.sql.pandas.types import from_arrow_type, to_arrow_schema
from pyspark.sql.types import StructField, StructType

from ..tables._kinds import struct_member


def arrow_schema(df: Any) -> Any:
    """Of a data frame's columns; stamps are instants, whatever the time zone of the session."""
    zone: dict[str, Any] = {"timezone": "UTC"} if "timezone" in inspect.signature(to_arrow_schema).parameters else {}  # since PySpark 4.1
    return to_arrow_schema(df.schema, **zone)


def readable(df: Any, schema: Any, layout: Any) -> Any:
    """The columns of that schema, each as the type that it is read as, out of those that the layout reads them from."""
    given = arrow_schema(df)

    def column(field: Any) -> Any:
        name, names, k = layout.place(field.name)
        value, kind = functions.col(name), given.field(name).type
        if names:
            member = kind.field(struct_member(kind, names[k]))
            value, kind = value.getField(member.name), member.type
        if pa.types.is_date(kind) and pa.types.is_timestamp(field.type):
            value = value.cast("timestamp_ntz")
        if pa.types.is_decimal(kind) and pa.types.is_floating(field.type):
            value = value.cast("double")
        return value.alias(field.name)

    return df.select(*map(column, schema))


def spark_schema(arrow: Any, known: dict[str, Any], given: Any) -> StructType:
    """Of what a job gives: the columns that the data frame has keep their types, where Arrow has one for both."""
    def kind(field: Any) -> Any:
        keeps = field.name in known and (field.name not in given.names or field.type == given.field(field.name).type)
        return known[field.name] if keeps else from_arrow_type(field.type)

    return StructType([StructField(field.name, kind(field)) for field in arrow])


def types_of(*frames: Any) -> dict[str, Any]:
    """The types of columns by name."""
    return {field.name: field.dataType for df in frames for field in df.schema.fields}


def mapped(job: Any, df: Any, by: Sequence[str], order: Sequence[str], schema: StructType) -> Any:
    """What a job makes of every partition, in which each track is whole and its rows are in order."""
    rows = df.repartition(*by).sortWithinPartitions(*(functions.col(name).asc_nulls_last() for name in order))
    return rows.mapInArrow(on_a_worker(pickle.dumps((job,))), schema)


def on_a_worker(job: bytes) -> Callable[[Iterator[Any]], Iterator[Any]]:
    """The job as a function of batches."""
    unpack = unpacking()

    def work(batches: Iterator[Any]) -> Iterator[Any]:
        import itertools
        made, = unpack(job, "orispline.tables")
        first = next(batches, None)
        if first is not None:
            yield from made(itertools.chain([first], batches), first.schema)

    return work


def unpacking() -> Callable[..., tuple[Any, ...]]:
    """A function that gives what was packed, where it is called.

    It refers to nothing outside, so that it comes to a worker as a whole, and can say there what is missing.
    """
    def unpack(packed: bytes, module: str) -> tuple[Any, ...]:
        import importlib
        import pickle
        try:
            importlib.import_module(module)
            return tuple(pickle.loads(packed))
        except ImportError as error:
            raise ImportError(f"orispline.spark: a worker found no {error.name}, wanted orispline with its extra 'spark' installed on "
                              "every executor: docs/scale.md says how") from None

    return unpack
