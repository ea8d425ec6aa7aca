# SPDX-License-Identifier: Apache-2.0
"""Files of keyframes and of samples, as the command reads and writes them."""
from __future__ import annotations

import datetime
import os
from typing import TYPE_CHECKING, Any, Mapping, Union

import numpy as np

from . import _core
from ._clock import Clock
from ._errors import ArgumentError
from ._keys import Keys
from ._samples import Samples
from ._warnings import tell

if TYPE_CHECKING:
    import fractions

    from ._curve import Curve

    Number = Union[float, str, fractions.Fraction]

Path = Union[str, "os.PathLike[str]"]


def read(path: Path, *, input_format: str | None = None, columns: Mapping[str, str] | None = None, order: str | None = None,
         input_orientation: str | None = None, euler: str | None = None, angle_unit: str | None = None,
         time_scale: Number | None = None, fps: Number | None = None,
         epoch: str | datetime.date | np.datetime64 | None = None, clip: str | None = None, joint: str | None = None,
         space: str | None = None, conjugate: bool = False, signs: str | None = None,
         ignore_recipe: bool = False, normalise: bool = False, drop_duplicates: bool = False, drop_invalid: bool = False,
         sort: bool = False, scalar_first: bool = False) -> Keys:
    """The keyframes of a file: CSV, TUM or EuRoC, told by its name and its content; of a glTF or BVH file one joint.

    Times of the keys are seconds since the first one; `Keys.epoch` has the time of that, with all its digits. So
    nanoseconds survive in a time stamp of today. Files that are written have the times of the file again. Positions,
    rates [rad/s], [rad/s²], [rad/s³] and columns named as settings of methods are read where they are there. If the file
    names the method that its keys are for, `Keys.curve()` is the curve of that.

    The options are those of the command; `columns` is a mapping, such as `{"t": "sclk_ticks", "qw": "q0_w"}`.

    Parameters
    ----------
    path : str or path
        `-` is standard input.
    {options}
    scalar_first : bool
        The order of quaternions in all that the keys and their curves give back: w, x, y, z.

    Raises
    ------
    DataError
        What the file holds is no keys; with `file`, `line` and `column`. The message says which option would mend it.
    AccessError
        The file is not there or cannot be read.
    ArgumentError
        An option that is no such thing, or that contradicts the file.

    Warns
    -----
    ShapeWarning
        What was noticed in the file, such as a unit of times that was told by their size.

    Examples
    --------
    >>> import orispline as ori, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "keys.csv"
    >>> _ = path.write_text("t,qw,qx,qy,qz\\n1700000000.000000001,1,0,0,0\\n1700000000.5,0.8,0,0,0.6\\n")
    >>> keys = ori.read(path)
    >>> keys.epoch, keys.times.tolist()
    (Decimal('1700000000.000000001'), [0.0, 0.499999999])
    >>> keys.curve("slerp").sample(count=3).write(path)
    >>> len(ori.read(path))
    3
    """
    named = {"input_format": input_format, "order": order, "input_orientation": input_orientation, "euler": euler,
             "angle_unit": angle_unit, "time_scale": time_scale, "fps": fps, "epoch": epoch, "clip": clip, "joint": joint, "space": space, "signs": signs}
    flags = {"conjugate": conjugate, "ignore_recipe": ignore_recipe, "normalise": normalise,
             "drop_duplicates": drop_duplicates, "drop_invalid": drop_invalid, "sort": sort}
    found = _core.read(path_text(path), _stated(named) + _flags(flags), _names(columns))
    tell(found["warnings"])
    keys = Keys._of(found["keys"], Clock(), scalar_first=scalar_first)
    keys._source = {"format": found["format"], "repairs": found["repairs"], "ignored_columns": found["ignored_columns"]}
    return keys


def write(what: Keys | Curve | Samples, path: Path, *, output_format: str | None = None,
          output_orientation: str | None = None, output_euler: str | None = None, output_angle_unit: str | None = None,
          output_conjugate: bool = False) -> None:
    """Writes keys, the keys of a curve with the method that they are for, or samples.

    The file appears complete or not at all; one that was there stays as it is if writing fails. The format is that of
    the name: .csv, .tum, .npy, else CSV. Times are exact; EuRoC alone rounds them to whole nanoseconds.

    Parameters
    ----------
    what : Keys, Curve or Samples
        `read(path).curve()` of the file of a curve is that curve again.
    path : str or path
    {options}

    Raises
    ------
    AccessError
        A folder that is not there or may not be written to, a full disk.
    ArgumentError
        An option that is no such thing; a name that ends as files of other kinds do; rates in a format without them.
    DataError
        Samples that are not finite, or fall on the same time in the unit of the file.

    Warns
    -----
    ShapeWarning
        What the format has no room for, such as the method of the keys.

    Examples
    --------
    >>> import orispline as ori, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "keys.csv"
    >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "timed-c2", ends="rest")
    >>> ori.write(curve, path)
    >>> ori.read(path).curve()
    Curve('timed-c2:ends=rest', 3 keys, 0 … 3 s, C²)
    """
    options = _stated({"output_format": output_format, "output_orientation": output_orientation,
                       "output_euler": output_euler, "output_angle_unit": output_angle_unit})
    options += _flags({"output_conjugate": output_conjugate})
    if isinstance(what, Samples):
        _write_samples(what, path_text(path), options)
        return
    keys, method = (what, None) if isinstance(what, Keys) else (getattr(what, "keys", None), getattr(what, "method", None))
    if not isinstance(keys, Keys):
        raise TypeError(f"found {type(what).__name__}, wanted Keys, a Curve or Samples")
    tell(_core.write_keys(keys._core, path_text(path), options, keys._read("format", ""), method))


def _write_samples(samples: Samples, path: str, options: list[tuple[str, str]]) -> None:
    origin = samples._from
    q = np.asarray(samples.orientations, dtype=np.float64)
    rows = [None if values is None else np.ascontiguousarray(values, dtype=np.float64) for values in samples._vectors()]
    _core.write_samples(path, options, origin.like, origin.epoch, origin.grid, samples.frame == "world", origin.seconds,
                        np.ascontiguousarray(q[:, [1, 2, 3, 0]] if origin.scalar_first else q), *rows)


def path_text(path: Path) -> str:
    """A path as the library takes it."""
    text = os.fspath(path)
    if not isinstance(text, str):
        raise TypeError(f"path: found {type(path).__name__}, wanted a str or a path of str")
    if "\0" in text:
        raise ArgumentError("path: found a NUL character in it, wanted the name of a file")
    return text


def _stated(options: Mapping[str, Any]) -> list[tuple[str, str]]:
    return [(name, _text(name, value)) for name, value in options.items() if value is not None]


def _text(name: str, value: Any) -> str:
    import fractions
    if isinstance(value, fractions.Fraction):
        return f"{value.numerator}/{value.denominator}"
    if isinstance(value, (datetime.date, np.datetime64)):
        return value.isoformat() if isinstance(value, datetime.date) else str(value)
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool) or not isinstance(value, (str, int, float)):
        raise TypeError(f"{name}: found {value!r}, wanted a text or a number")
    return value if isinstance(value, str) else repr(value)


def _flags(options: Mapping[str, Any]) -> list[tuple[str, str]]:
    for name, value in options.items():
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{name}: found {value!r}, wanted True or False")
    return [(name, "") for name, value in options.items() if value]


def _names(columns: Mapping[str, str] | None) -> dict[str, str]:
    if columns is None:
        return {}
    if not isinstance(columns, Mapping) or not all(isinstance(x, str) for pair in columns.items() for x in pair):
        raise TypeError(f"columns: found {columns!r}, wanted names of columns by their meanings, such as {{'t': 'time'}}")
    return dict(columns)


def _explained(options: list[dict[str, str | None]]) -> str:
    """What the library says of options, as a docstring has it."""
    lines = []
    for option in options:
        argument = option["argument"]
        words = ", ".join(f'"{word}"' for word in (argument or "").split("|"))
        kind = "bool" if argument is None else f"{{{words}}}" if "|" in argument else ""
        lines += [f"{option['name']} : {kind or 'optional'}", f"    {option['sentence']}."]
    return "\n    ".join(lines)


for _function, _options in ((read, _core.reading_options()), (write, _core.writing_options())):
    _function.__doc__ = (_function.__doc__ or "").replace("{options}", _explained(_options))
