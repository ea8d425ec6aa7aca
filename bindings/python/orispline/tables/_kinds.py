# SPDX-License-Identifier: Apache-2.0
"""Which types of Arrow a column may have, and as which it is read."""
from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from .._errors import ArgumentError, DataError

MOST_DIGITS = 38  # of decimal128, the widest decimals that DuckDB and Spark have


def plain_type(kind: Any) -> Any:
    """The type of the values themselves: without dictionaries, runs, views and the names of extensions."""
    if isinstance(kind, pa.BaseExtensionType):
        return plain_type(kind.storage_type)
    if pa.types.is_dictionary(kind) or pa.types.is_run_end_encoded(kind):
        return plain_type(kind.value_type)
    if pa.types.is_decimal(kind):
        return pa.decimal128(kind.precision, kind.scale) if kind.precision <= MOST_DIGITS else kind
    return {pa.string_view(): pa.large_string(), pa.binary_view(): pa.large_binary()}.get(kind, kind)


def plain(column: Any) -> Any:
    """A column of that type."""
    kind = column.type
    if isinstance(kind, pa.BaseExtensionType):
        return plain(column.storage)
    if pa.types.is_dictionary(kind):
        return plain(column.dictionary).take(column.indices)
    if pa.types.is_run_end_encoded(kind):
        rows = np.arange(column.offset, column.offset + len(column))
        return plain(column.values).take(pa.array(np.searchsorted(column.run_ends.to_numpy(), rows, "right")))
    wanted = plain_type(kind)
    try:
        return column if kind == wanted else column.cast(wanted)
    except pa.ArrowNotImplementedError:  # of views by pyarrow 17
        return pa.array(column.to_pylist(), wanted)


def id_type(what: str, name: str, found: Any) -> Any:
    """As which ids are read, which are compared and put in order. Raises ArgumentError where they cannot be."""
    kind, types = plain_type(found), pa.types
    texts = types.is_string(kind) or types.is_large_string(kind) or types.is_binary(kind) or types.is_large_binary(kind)
    numbers = types.is_integer(kind) or types.is_float32(kind) or types.is_float64(kind) or types.is_decimal128(kind)
    if texts or numbers or types.is_boolean(kind) or types.is_fixed_size_binary(kind) or types.is_temporal(kind) and not types.is_interval(kind):
        return kind
    raise ArgumentError(f"{what}: found {found} in the column {name!r}, wanted ids that can be put in order, such as numbers or strings")


def time_type(what: str, name: str, found: Any) -> Any:
    """As which times are read: dates as stamps, decimals as seconds. Raises ArgumentError for what is no time."""
    kind, types = plain_type(found), pa.types
    if types.is_date(kind):
        return pa.timestamp("s")
    if types.is_decimal128(kind):
        return pa.float64()
    if types.is_float64(kind) or types.is_float32(kind) or types.is_timestamp(kind) or types.is_duration(kind):
        return kind
    cure = "cast it to float64 if it counts seconds, else to a timestamp" if types.is_integer(kind) else "cast it"
    raise ArgumentError(f"{what}: found {found} in the column {name!r}, wanted float seconds, timestamps, dates or durations: {cure}")


def number_type(what: str, name: str, found: Any) -> Any:
    """As which numbers are read. Raises ArgumentError for what is none."""
    kind = plain_type(found)
    if pa.types.is_decimal128(kind):
        return pa.float64()
    if pa.types.is_floating(kind) or pa.types.is_integer(kind):
        return kind
    raise ArgumentError(f"{what}: found {found} in the column {name!r}, wanted numbers")


def part_type(what: str, name: str, found: Any, names: Sequence[str], k: int) -> Any:
    """The type of the k-th of several numbers in one column: a struct with their names or their last letters, or a list of their number."""
    kind = plain_type(found)
    if pa.types.is_fixed_size_list(kind) and kind.list_size == len(names):
        return kind.value_type
    if pa.types.is_struct(kind):
        member = struct_member(kind, names[k])
        if member is not None:
            return kind.field(member).type
    letters = ", ".join(each[-1] for each in names)
    raise ArgumentError(f"{what}: found {found} in the column {name!r}, wanted a struct of {letters}, a fixed-size list of {len(names)} numbers "
                        f"in this order, or the names of {len(names)} columns")


def part(column: Any, names: Sequence[str], k: int) -> Any:
    """Those numbers of such a column."""
    column = plain(column)
    if pa.types.is_struct(column.type):
        return pc.struct_field(column, [struct_member(column.type, names[k])])
    return pc.list_element(column, k)


def struct_member(kind: Any, name: str) -> int | None:
    """Of a struct's members the one of that name, or of its last letter."""
    found = [i for i in range(kind.num_fields) if kind.field(i).name in (name, name[-1])]
    return found[0] if len(found) == 1 else None


def read(column: Any, kind: Any, place: str, name: str) -> Any:
    """A column as the type that it is read as. Raises ArgumentError where pyarrow cannot."""
    try:
        values = plain(column)
    except pa.ArrowNotImplementedError:
        raise ArgumentError(f"{place}: found {column.type} in the column {name!r}, which pyarrow {pa.__version__} cannot read: cast it to "
                            f"{kind}, or install a later pyarrow") from None
    return converted(values, kind, place, name)


def converted(column: Any, kind: Any, place: str, name: str, first_row: int = 0) -> Any:
    """A column as another type, that of the same column elsewhere. Raises DataError for the first value which that has no room for,
    and ArgumentError where it has none like it; the column begins in that row of the place."""
    if column.type == kind:
        return column
    if pa.types.is_timestamp(kind) and pa.types.is_timestamp(column.type) and (kind.tz is None) != (column.type.tz is None):
        raise ArgumentError(f"{place}: found {column.type} in the column {name!r}, which is {kind} elsewhere, wanted stamps with a time zone "
                            "in both or in neither: give those without one the zone that they are of")
    try:
        return column.cast(kind)
    except pa.ArrowNotImplementedError:
        raise ArgumentError(f"{place}: found {column.type} in the column {name!r}, which is {kind} elsewhere, wanted one type for "
                            "both: cast one of them") from None
    except pa.ArrowInvalid:
        row = _first_without_room(column, kind)
    raise DataError(f"{place}: found {shown(column[row])} in row {first_row + row} of the column {name!r}, wanted what {kind} has room "
                    f"for, which is its type elsewhere: cast both columns to one type that has room for all, or leave the row out")


def _first_without_room(column: Any, kind: Any) -> int:
    """The row of the first value that cannot be of that type, by halves."""
    first, end = 0, len(column)
    while end - first > 1:
        middle = (first + end) // 2
        try:
            column.slice(first, middle - first).cast(kind)
            first = middle
        except pa.ArrowInvalid:
            end = middle
    return first


def shown(value: Any) -> str:
    """A value for people to read; stamps beyond the years of Python's dates as what they count."""
    try:
        return str(value.as_py())
    except (OverflowError, ValueError):
        return f"{value.value} {value.type.unit} since 1970"
