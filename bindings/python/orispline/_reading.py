# SPDX-License-Identifier: Apache-2.0
"""Keyframes out of files, as the command reads them."""
from __future__ import annotations

import datetime
from typing import TYPE_CHECKING, Any, Literal, Mapping, Sequence, overload

import numpy as np

from . import _core
from ._checks import flag
from ._clock import Clock
from ._errors import tell
from ._files import Options, Source, explained, flags, source_of, stated
from ._forms import rotation_text
from ._keys import Keys
from ._mending import one_spelling
from ._npy import check_options, read_npy

if TYPE_CHECKING:
    from ._types import Number


ALL = "all"  # recordings


@overload
def read(path: Source, *, session: Literal["all"], **options: Any) -> list[Keys]: ...
@overload
def read(path: Source, *, session: int | None = None, **options: Any) -> Keys: ...
def read(path: Source, *, input_format: str | None = None,  # type: ignore[misc]  # which of the options there are is said here only
         columns: Mapping[str, str] | Sequence[str] | None = None, order: str | None = None,
         input_orientation: str | None = None, euler: str | None = None, angle_unit: str | None = None,
         time_scale: Number | None = None, fps: Number | None = None,
         epoch: str | datetime.date | np.datetime64 | None = None, unwrap: str | None = None, clip: str | None = None, joint: str | None = None,
         space: str | None = None, conjugate: bool = False, inverse_poses: bool = False, world_axes: str | None = None,
         body_axes: str | None = None, world_rotation: Any = None, body_rotation: Any = None, signs: str | None = None,
         ignore_recipe: bool = False, normalise: bool = False, normalize: bool = False, drop_duplicates: bool = False, drop_invalid: bool = False,
         salvage: bool = False, rest_frame: int | None = None, sort: bool = False, session: int | str | None = None, gap: Number | None = None, jumps: bool = False, no_positions: bool = False,
         scalar_first: bool = False) -> Keys | list[Keys]:
    """The keyframes of a file: CSV, TUM or EuRoC, told by its name and its content; of a glTF or BVH file one joint.

    Times of the keys are seconds since the first one; `Keys.epoch` has the time of that, with all its digits. So
    nanoseconds survive in a time stamp of today. Files that are written have the times of the file again. Positions,
    rates [rad/s], [rad/s²], [rad/s³] and columns named as settings of methods are read where they are there. If the file
    names the method that its keys are for, `Keys.curve()` is the curve of that.

    The options are those of the command; `columns` is a mapping, such as `{"t": "sclk_ticks", "qw": "q0_w"}`, and `normalize` another
    spelling of `normalise`; a rotation may also be a quaternion x, y, z, w, a matrix or a SciPy Rotation. A NumPy file (.npy) is read as it is written; its columns have no names: 5 are time and quaternion, 17 the
    position and all rates too, 8 are taken for those with the position, which is warned of, and `columns` names all in their order.
    `session="all"` gives a list with the keys of each recording that the file holds, one behind the other.

    Parameters
    ----------
    path : str, path or file object
        `-` is standard input. A file object, open for bytes or text, is read from where it stands to its end; the extension of its
        `name` tells the format where it has one.
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
    (name, content), scalar_first = source_of(path), flag("scalar_first", scalar_first)
    normalise = one_spelling(normalize, normalise)
    named = {"input_format": input_format, "order": order, "input_orientation": input_orientation, "euler": euler,
             "angle_unit": angle_unit, "time_scale": time_scale, "fps": fps, "epoch": epoch, "unwrap": unwrap, "clip": clip, "joint": joint, "space": space,
             "world_axes": world_axes, "body_axes": body_axes, "world_rotation": rotation_text("world_rotation", world_rotation),
             "body_rotation": rotation_text("body_rotation", body_rotation), "signs": signs, "rest_frame": rest_frame, "session": session, "gap": gap}
    mending = {"normalise": normalise, "drop_duplicates": drop_duplicates, "drop_invalid": drop_invalid, "sort": sort}
    set_or_not = {"conjugate": conjugate, "inverse_poses": inverse_poses, "ignore_recipe": ignore_recipe, "jumps": jumps, "no_positions": no_positions,
                  "salvage": salvage}
    if name.lower().endswith(".npy") and input_format in (None, "npy"):
        frames = stated({**named, **dict.fromkeys(("input_format", "signs", "session", "time_scale"))}) + flags({**set_or_not, "jumps": False, "no_positions": False})
        check_options(option for option, _ in frames)
        return read_npy(name, columns, content, session=session, time_scale=time_scale, no_positions=no_positions, frames=frames,
                        signs="shortest" if signs is None else signs, scalar_first=scalar_first, jumps=jumps, **mending)
    options, names = stated(named) + flags({**set_or_not, **mending}), names_by_meaning(columns)
    if session != ALL:
        return _read(name, options, names, content, scalar_first)
    count = _core.sessions(name, options, names, content)
    each = [option for option in options if option[0] != "session"]
    return [_read(name, [*each, ("session", str(number))], names, content, scalar_first) for number in range(1, count + 1)]


def _read(name: str, options: Options, names: dict[str, str], content: bytes | None, scalar_first: bool) -> Keys:
    found = _core.read(name, options, names, content)
    tell(found["warnings"])
    keys = Keys._of(found["keys"], Clock(), scalar_first=scalar_first)
    keys._source = {"format": found["format"], "repairs": found["repairs"], "ignored_columns": found["ignored_columns"]}
    return keys


def names_by_meaning(columns: Any) -> dict[str, str]:
    """Columns as the library takes them."""
    if columns is None:
        return {}
    if not isinstance(columns, Mapping) or not all(isinstance(x, str) for pair in columns.items() for x in pair):
        raise TypeError(f"columns: found {columns!r}, wanted names of columns by their meanings, such as {{'t': 'time'}}")
    return dict(columns)


read.__doc__ = (read.__doc__ or "").replace("{options}", explained(_core.reading_options()))
