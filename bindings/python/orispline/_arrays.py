# SPDX-License-Identifier: Apache-2.0
"""Arguments as the arrays that the library takes: C-contiguous float64, without a copy where they are that already."""
from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import ArgumentError, DataError, tell

Array = NDArray[np.float64]


def array_of(name: str, values: Any) -> np.ndarray[Any, Any]:
    """What NumPy makes of them, of datetimes and pandas' timestamps datetime64; nothing of what is masked or of no shape."""
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ArgumentError(f"{name}: found masked values, wanted a value everywhere, such as of .filled(numpy.nan)")
    try:
        array = np.asarray(values)
    except ValueError:
        raise ArgumentError(f"{name}: found rows of different lengths, wanted an array") from None
    return _dates(name, array) if array.dtype.kind == "O" else array


def _dates(name: str, array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    import datetime
    dates = array.reshape(-1)
    if not len(dates) or not all(isinstance(date, datetime.datetime) for date in dates):
        return array
    if any(date.tzinfo is not None for date in dates):
        raise ArgumentError(f"{name}: found dates with a time zone, wanted dates without one: pandas' .tz_convert(None) has those of UTC")
    stamps = [date.to_datetime64() if hasattr(date, "to_datetime64") else date for date in dates]  # pandas' have nanoseconds
    return np.array(stamps, "datetime64[ns]").reshape(array.shape)


def found(array: np.ndarray[Any, Any]) -> str:
    """What an array of another kind is."""
    if array.dtype.kind != "O":
        return f"an array of {array.dtype}"
    kinds = sorted({type(thing).__name__ for thing in array.reshape(-1)})
    return f"{'an object' if array.ndim == 0 else 'objects'} of type {', '.join(kinds)}" if kinds else "no objects"


def numbers(name: str, values: Any, shape: tuple[int | None, ...], wanted: str | None = None) -> Array:
    """Real numbers of that shape; None is any length."""
    array = array_of(name, values)
    if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
        raise ArgumentError(f"{name}: found {found(array)}, wanted real numbers")
    if array.ndim != len(shape) or any(want is not None and got != want for got, want in zip(array.shape, shape)):
        sizes = ", ".join("n" if want is None else str(want) for want in shape)
        sizes = f"({sizes},)" if len(shape) == 1 else f"({sizes})"
        raise ArgumentError(f"{name}: found the shape {array.shape}, wanted {wanted or sizes}")
    return np.ascontiguousarray(array, dtype=np.float64)


def quaternions(name: str, rotations: Any, *, scalar_first: bool) -> Array:
    """(n, 4) quaternions x, y, z, w of quaternions, of (n, 3, 3) matrices or of a SciPy Rotation."""
    if hasattr(rotations, "as_quat"):
        rotations, scalar_first = rotations.as_quat(), False
    array = array_of(name, rotations)
    if array.ndim == 3 and array.shape[1:] == (3, 3):
        return _of_matrices(name, numbers(name, array, (None, 3, 3)))
    array = numbers(name, array, (None, 4), "(n, 4) quaternions, (n, 3, 3) matrices or a SciPy Rotation")
    return np.ascontiguousarray(array[:, [1, 2, 3, 0]]) if scalar_first else array


def _of_matrices(name: str, matrices: Array) -> Array:
    """Shepperd's way: by the largest of the four squares 4 w², 4 x², 4 y², 4 z²."""
    far = np.abs(matrices @ matrices.transpose(0, 2, 1) - np.eye(3)).max(axis=(1, 2), initial=0.0)
    bad = ~(far < 1e-3) | (np.linalg.det(matrices) < 0)
    if bad.any():
        error = DataError(f"key {int(bad.argmax())}: {name}: found a matrix that is no rotation, wanted an orthonormal one of "
                          "determinant 1")
        error.key = int(bad.argmax())
        raise error
    x, y, z = (matrices[:, i, i] for i in range(3))
    squares = np.stack([1 + x - y - z, 1 - x + y - z, 1 - x - y + z, 1 + x + y + z], axis=1)
    largest = squares.argmax(axis=1)
    m = matrices
    sums = np.empty((len(m), 4, 4))
    for i in range(4):
        sums[:, i, i] = squares[:, i]
    for (i, j), value in {(0, 1): m[:, 1, 0] + m[:, 0, 1], (0, 2): m[:, 0, 2] + m[:, 2, 0],
                          (1, 2): m[:, 2, 1] + m[:, 1, 2], (0, 3): m[:, 2, 1] - m[:, 1, 2],
                          (1, 3): m[:, 0, 2] - m[:, 2, 0], (2, 3): m[:, 1, 0] - m[:, 0, 1]}.items():
        sums[:, i, j] = sums[:, j, i] = value
    rows = sums[np.arange(len(m)), largest]
    return np.ascontiguousarray(rows / np.linalg.norm(rows, axis=1, keepdims=True))


def output(name: str, out: Any, shape: tuple[int, ...], dtype: Any, times: Array | None = None) -> NDArray[Any]:
    """The array to fill: `out` if it fits and has none of the memory of `times`, else a new one."""
    dtype = np.dtype(dtype)
    if dtype not in (np.dtype("float64"), np.dtype("float32")):
        raise ArgumentError(f"dtype: found {dtype}, wanted float64 or float32")
    if out is None:
        return np.empty(shape, dtype)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"{name}: found {type(out).__name__}, wanted a NumPy array")
    if out.shape != shape or out.dtype != dtype:
        raise ArgumentError(f"{name}: found an array {out.shape} of {out.dtype}, wanted {shape} of {dtype}")
    if not out.flags.c_contiguous or not out.flags.writeable:
        raise ArgumentError(f"{name}: wanted a C-contiguous array that may be written to")
    if times is not None and np.may_share_memory(out, times):
        raise ArgumentError(f"{name}: found the memory of the times, wanted an array of its own")
    return out


def sample_rows(out: Any, lead: tuple[int, ...], derivatives: int, linear: int, dtype: Any, times: Array) -> list[Any]:
    """The arrays of samples to fill, those of `out` or new ones: orientations, three rates and three of the path, where None
    is what was not asked for."""
    shapes = [(*lead, 4), *[(*lead, 3)] * (derivatives + linear)]
    given = [None] * len(shapes) if out is None else [out] if isinstance(out, np.ndarray) else list(out)
    if len(given) != len(shapes):
        raise ArgumentError(f"out: found {len(given)}, wanted {len(shapes)}: an array for the orientations, and one for each rate "
                            "and each row of the path")
    rows: list[Any] = [output("out", array, shape, dtype, times) for array, shape in zip(given, shapes)]
    if out is not None and any(np.may_share_memory(a, b) for k, a in enumerate(rows) for b in rows[:k]):
        raise ArgumentError("out: found arrays that share memory, wanted each apart")
    return [*rows[:derivatives + 1], *[None] * (3 - derivatives), *rows[derivatives + 1:], *[None] * (3 - linear)]


def inertia_tensor(inertia: Any) -> Array:
    """(3, 3) tensor of a tensor or of three principal moments [kg m²]."""
    shape = np.shape(inertia)
    matrix = numbers("inertia", inertia, (3,) if len(shape) == 1 else (3, 3))
    matrix = np.diag(matrix) if matrix.ndim == 1 else matrix
    tell(_core.check_inertia(matrix))
    return matrix
