# SPDX-License-Identifier: Apache-2.0
"""Frames of pandas, Polars, Arrow and xarray, as the columns of keys by name."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._checks import wrong_type
from ._clock import SecondsSince
from ._columns import INNER, QUATERNION, VECTORS, like_times, named, needed
from ._errors import ArgumentError

if TYPE_CHECKING:
    import decimal

    from numpy.typing import NDArray

FRAMES = {("pandas", "DataFrame"): "from_pandas", ("polars", "DataFrame"): "from_polars", ("polars", "LazyFrame"): "from_polars",
          ("pyarrow", "Table"): "from_arrow", ("pyarrow", "RecordBatch"): "from_arrow", ("pyarrow", "RecordBatchReader"): "from_arrow",
          ("xarray", "Dataset"): "from_xarray", ("duckdb", "DuckDBPyRelation"): "from_arrow"}  # by library and type, what reads them
AXES = ("x", "y", "z")
QUANTITIES = ("orientation", "angular_velocity", "angular_acceleration", "angular_jerk", "position", "velocity", "acceleration")
UNITS = {"angular_velocity": "rad/s", "angular_acceleration": "rad/s2", "angular_jerk": "rad/s3", "position": "m", "velocity": "m/s",
         "acceleration": "m/s2"}
# The variables of a Dataset with a dimension more, and their columns without the letters of the components.
PREFIXES = {"orientation": "q", **dict(zip(("position", "angular_velocity", "angular_acceleration", "angular_jerk"),
                                           (names[0][:-1] for names in VECTORS.values()))),
            **{argument: names[0][:-1] for argument, names in INNER.items()}}


def library_of(thing: Any) -> str:
    """The package that its type is from."""
    return type(thing).__module__.partition(".")[0].lstrip("_")


def reader_of(thing: Any) -> str | None:
    """Which of the functions of `Keys` reads it, if it is a frame."""
    return FRAMES.get((library_of(thing), type(thing).__name__))


def refuse_frame(name: str, thing: Any) -> None:
    """Raises ArgumentError, which says how it is read, for a frame."""
    reader = reader_of(thing)
    if reader is not None:
        raise ArgumentError(f"{name}: found a {type(thing).__name__} of {library_of(thing)}, wanted times and rotations, or Keys.{reader}(frame), "
                            "which reads its columns t, qw, qx, qy and qz, or those that columns= names")


def of_pandas(frame: Any, columns: Any) -> dict[str, Any]:
    """Without t the index has the times, but for one that only counts the rows."""
    if not hasattr(frame, "columns") or not hasattr(frame, "index"):
        raise wrong_type("frame", frame, "a pandas DataFrame")
    found = {meaning: frame[name] for meaning, name in named(frame.columns, columns).items()}
    for name in ("t", *QUATERNION):
        if name in found and hasattr(found[name], "columns"):
            raise ArgumentError(f"columns: found {name!r} twice, wanted it once")
    if "t" not in found and not _counts_rows(frame):
        found["t"] = frame.index
    return _since(found, frame.attrs.get("epoch"))


def _counts_rows(frame: Any) -> bool:
    """Whether its index has no times: whole numbers as pandas itself gives them, or beside a column that says that it has the times."""
    index = frame.index
    if like_times([index.name]) or getattr(index.dtype, "kind", "") not in "iu":
        return False
    return type(index).__name__ == "RangeIndex" or bool(like_times(frame.columns))


def of_polars(frame: Any, columns: Any) -> dict[str, Any]:
    """A LazyFrame is made first."""
    if reader_of(frame) != "from_polars":
        raise wrong_type("frame", frame, "a Polars DataFrame or LazyFrame")
    made = frame.collect() if hasattr(frame, "collect") else frame
    return {meaning: made[name].to_numpy() for meaning, name in named(made.columns, columns).items()}


def of_arrow(table: Any, columns: Any) -> dict[str, Any]:
    """Of a table, a batch, a reader and of whatever has `__arrow_c_stream__`; the epoch is that of its metadata."""
    pyarrow = needed("from_arrow", "pyarrow", "'orispline[tables]'")
    if isinstance(table, pyarrow.RecordBatchReader):
        table = table.read_all()
    elif isinstance(table, pyarrow.RecordBatch) or hasattr(table, "__arrow_c_stream__") and not isinstance(table, pyarrow.Table):
        table = pyarrow.table(table)
    if not isinstance(table, pyarrow.Table):
        raise wrong_type("table", table, "a pyarrow Table, or what has __arrow_c_stream__")
    found = {}
    for meaning, name in named(table.column_names, columns).items():
        column = table[name]
        if pyarrow.types.is_dictionary(column.type):
            column = column.cast(column.type.value_type)
        found[meaning] = column.to_numpy()
    return _since(found, ((table.schema.metadata or {}).get(b"epoch") or b"0").decode())


def of_xarray(dataset: Any, columns: Any) -> dict[str, Any]:
    """Variables in one dimension by their names, and those with a second one, whose coordinate has the letters of the components."""
    if reader_of(dataset) != "from_xarray":
        raise wrong_type("dataset", dataset, "an xarray Dataset")
    found: dict[str, Any] = {}
    for meaning, name in named([str(name) for name in dataset.variables], columns).items():
        variable = dataset[name]
        if variable.ndim == 1:
            found[meaning] = variable.values
        elif variable.ndim == 2 and meaning in PREFIXES:
            found.update(_components(meaning, variable))
    return _since(found, dataset.attrs.get("epoch"))


def _components(meaning: str, variable: Any) -> dict[str, Any]:
    """The columns of a variable with two dimensions."""
    letters = ("w", *AXES) if PREFIXES[meaning].endswith("q") else AXES
    for dimension in variable.dims:
        labels = [str(label) for label in variable[dimension].values] if dimension in variable.coords else []
        if sorted(labels) == sorted(letters):
            return {PREFIXES[meaning] + label: variable.isel({dimension: k}).values for k, label in enumerate(labels)}
    raise ArgumentError(f"dataset: found {meaning!r} with the dimensions {', '.join(map(repr, variable.dims))}, wanted one of them with the coordinate "
                        f"{', '.join(letters)}, which says which component is which")


def _since(columns: dict[str, Any], epoch: Any) -> dict[str, Any]:
    """With seconds that remember what they count from, where a frame says so by a number; stamps know it."""
    import decimal
    times = columns.get("t")
    try:
        since = decimal.Decimal(0 if epoch is None else str(epoch))
    except decimal.InvalidOperation:  # somebody else's word
        return columns
    if since and since.is_finite() and getattr(getattr(times, "dtype", None), "kind", "") == "f":
        columns["t"] = SecondsSince.of(np.asarray(times, dtype=np.float64), f"{since:f}")
    return columns


def as_xarray(times: NDArray[Any], epoch: decimal.Decimal, frame: str, order: str, variables: Mapping[str, Any]) -> Any:
    """A Dataset along `t`: the components of orientations are along `quaternion`, in that order, those of vectors along `axis`, and the
    joints of a stack along `joint`. Variables that are None are left out."""
    xarray = needed("to_xarray", "xarray")
    made, joints = {}, None
    for name, rows in variables.items():
        if rows is None:
            continue
        last = [] if rows.ndim == 1 else ["quaternion" if rows.shape[-1] == len(order) else "axis"]
        joints = rows.shape[1] if rows.ndim == 3 else joints
        made[name] = (["t", *["joint"] * (rows.ndim - 1 - len(last)), *last], rows, _said_of(name, frame))
    coordinates = {"t": times, "quaternion": list(order), **({"axis": list(AXES)} if any("axis" in each[0] for each in made.values()) else {}),
                   **({} if joints is None else {"joint": np.arange(joints)})}
    return xarray.Dataset(made, coordinates, {"epoch": f"{epoch:f}"})


def _said_of(name: str, frame: str) -> dict[str, str]:
    """The attributes of a variable."""
    return {**({"units": UNITS[name]} if name in UNITS else {}), **({"frame": frame} if name.startswith("angular_") else {})}


def is_labelled(times: Any) -> bool:
    """Whether it is a DataArray of xarray."""
    return type(times).__name__ == "DataArray" and library_of(times) == "xarray"


def bare(times: Any) -> Any:
    """The values of a DataArray; all else as it is."""
    return np.asarray(times)[()] if is_labelled(times) else times


def labelled(name: str, times: Any, values: Callable[[Any], Any], order: str, frame: str, dtype: Any) -> Any:
    """The values at the times of a DataArray as one with its dimensions and coordinates and those of the components; made when they are
    asked for where the times are chunks of dask."""
    last, labels = ("quaternion", list(order)) if name == "orientation" else ("axis", list(AXES))
    found = needed("xarray", "xarray").apply_ufunc(values, times, output_core_dims=[[last]], dask="parallelized", output_dtypes=[np.dtype(dtype)],
                                                   dask_gufunc_kwargs={"output_sizes": {last: len(labels)}}, keep_attrs=True)
    found = found.assign_coords({last: labels}).rename(name)
    found.attrs = _said_of(name, frame)
    return found
