# SPDX-License-Identifier: Apache-2.0
"""Keys and samples as columns by name, those of a CSV file: t, qw, qx, qy, qz, px, …, wx, …; and as tables of them."""
from __future__ import annotations

import importlib
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Array, numbers
from ._checks import wrong_type
from ._errors import ArgumentError

if TYPE_CHECKING:
    import decimal

Columns = dict[str, NDArray[Any]]
QUATERNION = ("qw", "qx", "qy", "qz")
VECTORS = {"positions": ("px", "py", "pz"), "angular_velocities": ("wx", "wy", "wz"), "angular_accelerations": ("ax", "ay", "az"),
           "angular_jerks": ("jx", "jy", "jz")}  # of keys, by the names of their arguments
INNER = {"inner_leaving": tuple(f"a_{name}" for name in QUATERNION), "inner_arriving": tuple(f"b_{name}" for name in QUATERNION)}
TIMES = r"(?i)t|ts|(.*[^a-z])?(time|times|timestamps?|stamps?|date|datetime|epoch|seconds?|secs?)([^a-z].*)?|t[_ ]?\(?\[?(s|ms|us|ns|sec|utc)\]?\)?"
PARTS = {**VECTORS, **INNER}  # all that keys may have beside times and orientations


def names_in_order(width: int) -> list[str] | None:
    """What columns without names are: time and quaternion, with 8 the position, with 17 all rates too; None of other numbers."""
    named = (list(_core.column_names(False, rates, path)) for rates, path in ((0, -1), (0, 0), (3, 0)))
    return next((names for names in named if len(names) == width), None)


def columns_of(times: NDArray[Any], quaternions: NDArray[Any], rates: Sequence[NDArray[Any] | None],
               path: Sequence[NDArray[Any] | None], frame: str, joints: int | None = None) -> Columns:
    """Quaternions w, x, y, z, three angular rates and three rows of the path, where None is what is not there. Those of many joints
    are joint by joint, behind a column `joint`."""
    there = [rows for rows in (path[0], *rates, *path[1:]) if rows is not None]
    names = _core.column_names(frame == "world", sum(rows is not None for rows in rates), sum(rows is not None for rows in path) - 1)
    tables = [quaternions, *there]
    columns = [times, *(np.ascontiguousarray(table[..., k].T).reshape(-1) for table in tables for k in range(table.shape[-1]))]
    if joints is None:
        return dict(zip(names, columns, strict=True))
    columns[0] = np.tile(times, joints)
    return {"joint": np.repeat(np.arange(joints), len(times)), **dict(zip(names, columns, strict=True))}


def as_arrow(columns: Columns, epoch: decimal.Decimal) -> Any:
    """A pyarrow Table; the metadata of its schema has the epoch."""
    return needed("to_arrow", "pyarrow", "'orispline[tables]'").table(columns, metadata={"epoch": f"{epoch:f}"})


def as_pandas(columns: Columns, epoch: decimal.Decimal) -> Any:
    """A pandas DataFrame; its `attrs` has the epoch, as a text, which Parquet and JSON take."""
    frame = needed("to_pandas", "pandas").DataFrame(columns)
    frame.attrs["epoch"] = f"{epoch:f}"
    return frame


def as_polars(columns: Columns) -> Any:
    """A Polars DataFrame, which has no place for an epoch."""
    return needed("to_polars", "polars").DataFrame(columns)


def needed(what: str, package: str, installed_by: str = "") -> Any:
    """A package that is imported where it is used. Raises ImportError for one that is not there."""
    try:
        return importlib.import_module(package)
    except ImportError:
        raise ImportError(f"{what}: found no {package}, wanted it installed: pip install {installed_by or package}", name=package) from None


def arguments_of(columns: Mapping[str, Any]) -> dict[str, Any]:
    """Arguments of `Keys` out of columns by name: times, rotations and inner quaternions w, x, y, z, and what else keys may have.
    Others are left alone."""
    missing = [name for name in ("t", *QUATERNION) if name not in columns]
    if missing:
        meaning, letter = missing[0], missing[0][-1]
        meant = like_times(columns) if meaning == "t" else [name for name in columns if str(name).lower().endswith(letter)]
        raise ArgumentError(f"columns: found no {', '.join(missing)}, wanted t, qw, qx, qy and qz: name yours by columns=, such as "
                            f"{{{meaning!r}: {(meant or ['stamp' if meaning == 't' else 'q' + letter.upper()])[0]!r}}}")
    stacked: dict[str, Array] = {}
    for argument, names in PARTS.items():
        found = [name for name in names if name in columns]
        if found and len(found) < len(names):
            raise ArgumentError(f"columns: found {', '.join(found)} alone, wanted {', '.join(names)}")
        if found:
            stacked[argument] = np.column_stack([_numbers(name, columns[name]) for name in names])
    parameters = {parameter["name"] for method in _core.methods() for parameter in method["parameters"]}
    settings = {name: _numbers(name, columns[name]) for name in columns if name in parameters}
    return {"times": columns["t"], "rotations": np.column_stack([_numbers(name, columns[name]) for name in QUATERNION]), **stacked,
            "settings": settings}


def like_times(names: Iterable[Any]) -> list[str]:
    """Those of these names that say that they are times."""
    return [name for name in names if isinstance(name, str) and re.fullmatch(TIMES, name.strip())]


def _numbers(name: str, values: Any) -> Array:
    return numbers(name, values, (None,))


def named(names: Iterable[str], columns: Any) -> dict[str, str]:
    """Columns by their meanings: those that a mapping names otherwise, and all others by their own names."""
    own = {name: name for name in names}
    if columns is None:
        return own
    if not isinstance(columns, Mapping) or not all(isinstance(word, str) for pair in columns.items() for word in pair):
        raise wrong_type("columns", columns, "names of columns by their meanings, such as {'t': 'time'}")
    absent = [column for column in columns.values() if column not in own]
    if absent:
        raise ArgumentError(f"columns: found no {absent[0]!r}, wanted one of {', '.join(map(repr, own)) or 'none'}")
    return {**own, **columns}
