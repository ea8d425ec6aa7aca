# SPDX-License-Identifier: Apache-2.0
"""Results in the kind of frame that went in: pandas and Polars, eager and lazy. All else gives record batches."""
from __future__ import annotations

import copy
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pyarrow as pa

from .._arrays import array_of
from .._errors import ArgumentError, collected, tell
from .._frames import library_of
from ._layout import Layout, check_once
from ._source import Source, source_of, table_of

ROW = "row of the frame"  # a column of ours: where each row of the other table was
TOLD_BEFORE = ("time_type", "rounded_times")  # warnings of a LazyFrame's schema, which its rows would repeat
Work = Callable[[Source], Any]


def kind_of(given: Any) -> str:
    """pandas, polars or lazy; else nothing."""
    name = type(given).__name__
    return {("pandas", "DataFrame"): "pandas", ("polars", "DataFrame"): "polars", ("polars", "LazyFrame"): "lazy"}.get((library_of(given), name), "")


def answered(given: Any, layout: Layout, work: Work) -> Any:
    """What the work makes of the rows of a source, in the kind of frame that this is."""
    kind = kind_of(given)
    if kind == "lazy":
        return _lazily(given, lambda frame, _: answered(frame, layout, work))
    if kind == "polars":
        return _polars_of(work(source_of(given)).read_all(), given.schema, layout.by)
    if kind == "pandas":
        frame, moved = _checked(given, layout)
        there = [name for name in layout.columns if name in frame.columns]
        needed = frame[there].reset_index(drop=True) if len(there) == len(layout.columns) else frame
        table = work(source_of(needed)).read_all()
        return _pandas_of(table, given, frame, moved, layout)
    return work(source_of(given))


def beside(at: Any, keys: Any, layout: Layout, work: Callable[[Source, Any], Any]) -> Any:
    """The rows of the other table with the columns that the work makes for them of keys. Frames keep their columns, their index and the
    order of their rows."""
    kind = kind_of(at)
    if kind == "lazy":
        return _lazily(at, lambda frame, first: beside(frame, _without_rows(keys) if first else keys, layout, work))
    if not kind:
        return work(source_of(at, "at"), keys)
    frame = index_as_columns(at, layout)
    for name in layout.order:
        check_once("at", [str(each) for each in frame.columns], name, layout.time)
    needed = frame[layout.order]
    numbered = table_of(needed.reset_index(drop=True) if kind == "pandas" else needed, "at").append_column(ROW, pa.array(np.arange(len(frame))))
    found = work(source_of(numbered, "at"), keys).read_all().sort_by(ROW)
    rows, made = found[ROW].to_numpy(), found.drop_columns([*layout.order, ROW])
    for name in made.column_names:
        check_new(name, at.columns)
    if kind == "polars":
        return at[rows].hstack(_polars_of(made, {}, ()).get_columns())
    return at.take(rows).assign(**{name: column.array for name, column in made.to_pandas().items()})


def check_new(name: str, there: Sequence[Any]) -> None:
    """Raises ArgumentError for a column of the other table that the result has too."""
    if name in there:
        raise ArgumentError(f"at: found the column {name!r}, which the result has too: leave it out or give it another name")


def _without_rows(frame: Any) -> Any:
    """Of a LazyFrame the columns alone."""
    if kind_of(frame) != "lazy":
        return frame
    import polars
    return polars.DataFrame(schema=frame.collect_schema())


def _lazily(frame: Any, work: Callable[[Any, bool], Any]) -> Any:
    """A LazyFrame that does the work when it is collected. What is wrong with columns and options is said at once, by a first time
    without rows."""
    made = work(_without_rows(frame), True)

    def rows(whole: Any) -> Any:
        with collected() as warnings:
            found = work(whole, False)
        tell((str(warning), warning.code, warning.numbers) for warning in warnings if warning.code not in TOLD_BEFORE)
        return found

    return frame.map_batches(rows, predicate_pushdown=False, projection_pushdown=False, slice_pushdown=False, schema=made.schema)


def _polars_of(table: Any, schema: Any, ids: Sequence[str]) -> Any:
    """With ids of the type that they had, such as Categorical and Enum."""
    import polars
    made: Any = polars.from_arrow(table)
    return made.with_columns(polars.col(name).cast(schema[name]) for name in ids if schema[name] != made.schema[name])


def index_as_columns(frame: Any, layout: Layout) -> Any:
    """Of pandas a frame with all ids and times in columns; any other source as it is."""
    return _checked(frame, layout)[0] if kind_of(frame) == "pandas" else frame


def _checked(frame: Any, layout: Layout) -> tuple[Any, list[Any]]:
    """The same with the names of the levels. Raises ArgumentError for times as objects of which some only have a time zone."""
    made, moved = _with_index_as_columns(frame, layout)
    if layout.time in made.columns and made[layout.time].dtype == object:
        array_of(f"the column {layout.time!r}", made[layout.time])
    return made, moved


def _with_index_as_columns(frame: Any, layout: Layout) -> tuple[Any, list[Any]]:
    """A frame of pandas with the ids and times of its index as columns, and the names of these levels. An index without a name has the
    times where no column has them."""
    levels = list(frame.index.names)
    if levels == [None] and layout.time and layout.time not in frame.columns and type(frame.index).__name__ != "RangeIndex":
        return frame.rename_axis(layout.time).reset_index(), [None]
    moved = [name for name in levels if name in layout.order and name not in frame.columns]
    return (frame.reset_index(), moved) if moved else (frame, moved)


def _pandas_of(table: Any, given: Any, frame: Any, moved: list[Any], layout: Layout) -> Any:
    """With the index, the time zone and the types of what was given."""
    import pandas
    numbers = [frame[name].dtype for name in layout.numbers if name in frame.columns]
    made = table.to_pandas(types_mapper=_types_like(numbers[0], pandas) if numbers else None)
    for name in layout.order:
        if name in made.columns and name in frame.columns:
            made[name] = _typed_like(made[name], frame[name].dtype, table.schema.field(name).type)
    if moved:
        made = made.set_index([layout.time if name is None else name for name in moved]).rename_axis(index=moved)
    made.columns.name, made.attrs = given.columns.name, copy.deepcopy(given.attrs)
    return made


def _types_like(kind: Any, pandas: Any) -> Callable[[Any], Any] | None:
    """Types of columns that are new: Arrow's or nullable ones where the numbers of the frame are of such."""
    if isinstance(kind, getattr(pandas, "ArrowDtype", ())):
        return lambda arrow: pandas.ArrowDtype(arrow)
    if isinstance(kind, np.dtype):
        return None
    known = {pa.float64(): pandas.Float64Dtype(), pa.int64(): pandas.Int64Dtype(), pa.bool_(): pandas.BooleanDtype(), pa.string(): pandas.StringDtype()}
    return known.get


def _typed_like(column: Any, kind: Any, arrow: Any) -> Any:
    """Ids and times of the type that they had; stamps of the result may have another unit, and keep that."""
    if column.dtype == kind or isinstance(kind, np.dtype):
        return column
    if getattr(kind, "tz", None) is not None:
        return column.dt.tz_convert(kind.tz)
    return column.astype(type(kind)(arrow) if type(kind).__name__ == "ArrowDtype" else kind)
