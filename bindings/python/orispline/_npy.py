# SPDX-License-Identifier: Apache-2.0
"""Keys out of NumPy files, as they are written there: an array of doubles with the columns of a CSV file, which have no names."""
from __future__ import annotations

import decimal
import fractions
import io
from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from . import _core
from ._clock import Clock
from ._columns import VECTORS, names_in_order
from ._errors import AccessError, ArgumentError, DataError, Error, tell
from ._files import Options, printable, stated
from ._keys import Keys

AMBIGUOUS = 8  # columns: beside time and quaternion there may be a position or an angular velocity


#: Options that say nothing of numbers in rows, and what does in their place.
REFUSED = {"order": "columns=['t', 'qw', …], which names the columns in their order", "fps": "time_scale, such as '1/24'",
           **dict.fromkeys(("input_orientation", "euler", "angle_unit"), "Keys(times, rotations, euler=…) of the array of numpy.load"),
           **dict.fromkeys(("input_format", "epoch", "unwrap", "clip", "joint", "space", "ignore_recipe"), "it with files of text")}


def read_npy(path: str, columns: Any, content: bytes | None, *, session: int | str | None, time_scale: Any, no_positions: bool, frames: Options,
             **options: Any) -> Keys | list[Keys]:
    """Keys of a file, or of its content, whose times count from the first one, or of each of its recordings; errors have its name.
    `columns` names its columns in their order. `frames`: what is done with the keys."""
    _core.check_reading([*frames, *stated({"time_scale": time_scale, "session": session})])
    found = _columns(path, columns, content)
    if no_positions:
        found = {name: values for name, values in found.items() if name not in VECTORS["positions"]}
    if time_scale is not None and "t" in found:
        scale = fractions.Fraction(time_scale)
        found["t"] = found["t"] * scale.numerator / scale.denominator
    parts = _sessions(path, found, session, options["sort"])
    keys = [_keys(path, {name: values[part] for name, values in found.items()}, frames, options) for part in parts]
    return keys if session == "all" else keys[0]


def check_options(stated: Iterable[str]) -> None:
    """Raises an error about an option that says nothing of an array of numbers."""
    for option in stated:
        if option in REFUSED:
            raise ArgumentError(f"{option}: found it with a NumPy file, which holds numbers in columns without names, wanted {REFUSED[option]}")


def _columns(path: str, columns: Any, content: bytes | None) -> dict[str, Any]:
    """By their names."""
    table = _table(path, content)
    names = names_in_order(table.shape[1]) if columns is None else _names(columns, table.shape[1])
    if names is None:
        raise ArgumentError(f"{printable(path)}: found {table.shape[1]} columns, wanted 5, 8 or 17, or their names: columns=['t', 'qw', …]")
    if columns is None and len(names) == AMBIGUOUS:
        tell([(f"{printable(path)}: {AMBIGUOUS} columns without names are taken for {', '.join(names)}; `columns` says otherwise", "columns_without_names",
               {})])
    return dict(zip(names, table.T))


def _sessions(path: str, columns: dict[str, Any], session: int | str | None, sort: bool) -> list[slice]:
    """The rows of the recordings that are read."""
    count, everything = len(next(iter(columns.values()))), [slice(None)]
    whole = np.flatnonzero(np.isfinite(columns["t"])) if "t" in columns else np.array([], dtype=np.intp)
    if not len(whole):
        return everything
    begins, would_mix = _core.sessions_of(np.ascontiguousarray(columns["t"][whole]))
    starts = [0, *(int(whole[begin]) for begin in begins[1:]), count]
    parts = [slice(start, end) for start, end in zip(starts, starts[1:])]
    if session == "all":
        return parts
    if session is not None:
        if int(session) > len(parts):
            raise ArgumentError(f"session: found {session}, wanted 1{f' to {len(parts)}' if len(parts) > 1 else ''}, which the file has")
        return [parts[int(session) - 1]]
    if len(parts) > 1 and (would_mix or not sort):
        raise _broken(path, f"found {len(parts)} recordings one behind the other, the second from row {starts[1]} on, wanted one of them "
                            "(session=N|all reads one of them)")
    return everything


def _keys(path: str, columns: dict[str, Any], frames: Options, options: dict[str, Any]) -> Keys:
    try:
        start = Keys._of_columns(columns, **options).times[0]
        keys = Keys._of_columns({**columns, "t": columns["t"] - start}, **options)
    except Error as error:
        error.file, error.args = path, (f"{printable(path)}: {error}", *error.args[1:])
        raise
    since = _core.keys_since(keys._core, f"{decimal.Decimal(repr(float(start))):f}", False)
    made = Keys._of(_core.keys_as_read(since, frames), Clock(), scalar_first=keys._scalar_first)
    made._source = keys._source
    return made


def _table(path: str, content: bytes | None) -> Any:
    try:
        table = np.load(path if content is None else io.BytesIO(content), allow_pickle=False)
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
