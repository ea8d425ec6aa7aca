# SPDX-License-Identifier: Apache-2.0
"""Arguments as the arrays that the library takes: C-contiguous float64, without a copy where they are that already."""
from __future__ import annotations

import sys
from collections.abc import Iterable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._errors import ArgumentError, tell
from ._exact import plain_numbers
from ._stamps import of_objects

Array = NDArray[np.float64]
OURS = frozenset([np.ndarray, np.float64, float, int, list, tuple])  # no arrays of other libraries: what is asked with most


def array_of(name: str, values: Any) -> np.ndarray[Any, Any]:
    """What NumPy makes of them, of dates and durations datetime64 and timedelta64, of pandas' own types plain ones, of other numbers
    doubles; nothing of what is masked or of no shape. Arrays of other libraries come through DLPack, from the host without a copy."""
    if type(values) is np.ndarray and values.dtype.char not in "Og":
        return values
    if _library_of(values) is not None:
        return _on_host(name, values)
    if isinstance(values, np.ma.MaskedArray) and np.ma.is_masked(values):
        raise ArgumentError(f"{name}: found masked values, wanted a value everywhere, such as of .filled(numpy.nan)")
    try:
        array = np.asarray(_without_extensions(values))
        if array.dtype.kind in "mM" and isinstance(values, (list, tuple)):
            array = np.asarray(values, dtype=object)
    except TypeError:  # durations that NumPy finds no common unit for
        array = np.asarray(values, dtype=object)
    except ValueError:
        raise ArgumentError(f"{name}: found rows of different lengths, wanted an array") from None
    array = of_objects(name, array) if array.dtype.kind == "O" else array
    return plain_numbers(name, array) if array.dtype.char in "Og" else array


def as_given(given: Any, result: Any) -> Any:
    """A result as an array of the library that `given` is of, on its device; NumPy's as it is."""
    library = _library_of(given)
    return result if library is None else library.asarray(result, device=getattr(given, "device", None))


def _library_of(values: Any) -> Any:
    """The other library whose array it is, by the standard of the array API or PyTorch's; None for all else."""
    if type(values) in OURS or isinstance(values, (np.ndarray, np.generic)):
        return None
    if hasattr(values, "__array_namespace__"):
        return values.__array_namespace__()
    torch = sys.modules.get("torch")
    return torch if torch is not None and isinstance(values, torch.Tensor) else None


def _on_host(name: str, values: Any) -> np.ndarray[Any, Any]:
    """An array of another library as one of NumPy, a copy where it is on a device."""
    for read in (np.from_dlpack, lambda array: np.from_dlpack(array, device="cpu"), np.asarray):
        try:
            return np.asarray(read(values))
        except (AttributeError, BufferError, RuntimeError, TypeError, ValueError):  # each library has its own
            pass
    raise ArgumentError(f"{name}: found an array of type {type(values).__name__} on {getattr(values, 'device', 'a device')} that cannot be "
                        "copied to the host, wanted one there: t.detach().cpu() of PyTorch, t.get() of CuPy, jax.device_get(t)")


def _without_extensions(values: Any) -> Any:
    """Columns of pandas' nullable types, of Arrow's and with a time zone, of which NumPy would make objects: missing is NaN or NaT."""
    if not type(values).__module__.startswith("pandas."):
        return values
    types = getattr(values, "dtypes", getattr(values, "dtype", None))
    types = list(types) if isinstance(types, Iterable) else [types]
    if any(kind is None for kind in types) or all(isinstance(kind, np.dtype) for kind in types):
        return values
    kinds = {kind.kind for kind in types}
    if kinds <= {"i", "u"} and not np.any(values.isna()):
        return values.to_numpy(dtype=np.int64)
    if kinds <= {"f", "i", "u"}:
        return values.to_numpy(dtype=np.float64, na_value=np.nan)
    if len(types) == 1 and kinds <= {"M", "m"}:
        unit = getattr(types[0], "unit", None) or types[0].pyarrow_dtype.unit
        return values.to_numpy(dtype=f"{types[0].kind}8[{unit}]")
    return values


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


def output(name: str, out: Any, shape: tuple[int, ...], dtype: Any, times: Array | None = None) -> NDArray[Any]:
    """The array to fill: `out` if it fits and has none of the memory of `times`, else a new one."""
    dtype = _dtype_of(dtype)
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


def _dtype_of(dtype: Any) -> np.dtype[Any]:
    """NumPy's, of other libraries too, whose `torch.float32` and the like NumPy does not know."""
    try:
        kind: np.dtype[Any] = np.dtype(dtype)
        return kind
    except (TypeError, ValueError):
        name = str(dtype).rpartition(".")[2]
        if name in ("float64", "float32"):
            return np.dtype(name)
        raise TypeError(f"dtype: found {dtype!r} of type {type(dtype).__name__}, wanted float64 or float32") from None


def sample_rows(out: Any, lead: tuple[int, ...], derivatives: int, linear: int, dtype: Any, times: Array) -> list[Any]:
    """The arrays of samples to fill, those of `out` or new ones: orientations, three rates and three of the path, where None
    is what was not asked for."""
    shapes = [(*lead, 4), *[(*lead, 3)] * (derivatives + linear)]
    if out is not None and not isinstance(out, (np.ndarray, list, tuple)):
        raise TypeError(f"out: found {type(out).__name__}, wanted a NumPy array, or a list of them")
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


def same(one: Any, other: Any) -> bool:
    """Whether two arrays, or None, have the same numbers; NaN is as NaN."""
    if one is None or other is None:
        return one is other
    return np.array_equal(one, other, equal_nan=np.asarray(one).dtype.kind == "f")
