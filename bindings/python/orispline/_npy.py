# SPDX-License-Identifier: Apache-2.0
"""Keys out of NumPy files, as they are written there: an array of doubles with the columns of a CSV file, which have no names."""
from __future__ import annotations

import decimal
from collections.abc import Sequence
from typing import Any

import numpy as np

from . import _core
from ._clock import Clock
from ._columns import names_in_order
from ._errors import AccessError, ArgumentError, DataError, Error, tell
from ._files import printable
from ._keys import Keys

AMBIGUOUS = 8  # columns: beside time and quaternion there may be a position or an angular velocity


def read_npy(path: str, columns: Any, **options: Any) -> Keys:
    """Keys of a file, whose times count from the first one; errors have its name. `columns` names its columns in their order."""
    table = _table(path)
    names = names_in_order(table.shape[1]) if columns is None else _names(columns, table.shape[1])
    if names is None:
        raise ArgumentError(f"{printable(path)}: found {table.shape[1]} columns, wanted 5, 8 or 17, or their names: columns=['t', 'qw', …]")
    if columns is None and len(names) == AMBIGUOUS:
        tell([(f"{printable(path)}: {AMBIGUOUS} columns without names are taken for {', '.join(names)}; `columns` says otherwise", "columns_without_names",
               {})])
    try:
        found = dict(zip(names, table.T))
        start = Keys._of_columns(found, **options).times[0]
        keys = Keys._of_columns({**found, "t": found["t"] - start}, **options)
    except Error as error:
        error.file, error.args = path, (f"{printable(path)}: {error}", *error.args[1:])
        raise
    since = _core.keys_since(keys._core, f"{decimal.Decimal(repr(float(start))):f}", False)
    made = Keys._of(since, Clock(), scalar_first=keys._scalar_first)
    made._source = keys._source
    return made


def _table(path: str) -> Any:
    try:
        table = np.load(path, allow_pickle=False)
    except OSError as error:
        refused = AccessError(f"{printable(path)}: cannot open: {error.strerror or error}")
        refused.file = path
        raise refused from None
    except (ValueError, EOFError) as error:
        raise _broken(path, f"found no NumPy file that holds an array of numbers ({str(error).splitlines()[0]})") from None
    if not isinstance(table, np.ndarray) or table.ndim != 2 or table.dtype.kind not in "fiu":
        raise _broken(path, f"found an array of {getattr(table, 'dtype', 'objects')} of the shape {getattr(table, 'shape', ())}, wanted "
                            "numbers in rows and columns")
    return table.astype(np.float64)


def _broken(path: str, message: str) -> DataError:
    error = DataError(f"{printable(path)}: {message}")
    error.file = path
    return error


def _names(columns: Sequence[str], width: int) -> list[str]:
    if isinstance(columns, str) or not isinstance(columns, Sequence) or not all(isinstance(name, str) for name in columns):
        raise ArgumentError(f"columns: found {columns!r}, wanted the names of the {width} columns in their order, such as ['t', 'qw', …]")
    if len(columns) != width or len(set(columns)) != width:
        raise ArgumentError(f"columns: found {len(columns)} names, wanted {width} that differ")
    return list(columns)
