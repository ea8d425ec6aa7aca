# SPDX-License-Identifier: Apache-2.0
"""The rates of a gyro, at times of their own."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Mapping

from . import _core
from ._arrays import Array, array_of, numbers
from ._clock import SecondsSince
from ._errors import DataError, tell
from ._files import Source, flags, source_of, stated
from ._forms import rotation_text
from ._reading import names_by_meaning

if TYPE_CHECKING:
    import datetime
    import decimal

    import numpy as np

    from ._types import Number


class Rates:
    """What a gyro measured, for `smooth` and `align`: body rates at times that need not be those of any orientation.

    Parameters
    ----------
    times : (n,) array
        Strictly increasing, as the times of the keys are: numbers, or stamps of NumPy or pandas. Their clock may differ by an offset, which
        `smooth` finds.
    rates : (n, 3) array
        [rad/s], body frame. Rows with NaN are left out.

    Raises
    ------
    ArgumentError, DataError
        Arrays of another shape or kind; lengths that differ.

    Examples
    --------
    >>> import orispline as ori
    >>> ori.Rates([0.0, 0.1, 0.2], [[0, 0, 1], [0, 0, 1.1], [0, 0, 1.2]])
    Rates(3 rates)
    """

    __slots__ = ("rates", "times")

    def __init__(self, times: Any, rates: Any) -> None:
        epoch = times.epoch if isinstance(times, SecondsSince) else "0"
        self.times = SecondsSince.of(array_of("times", times), epoch)
        self.rates: Array = numbers("rates", rates, (None, 3))
        if self.times.shape != self.rates.shape[:1]:
            raise DataError(f"rates: found {len(self.rates)} rows and times of shape {self.times.shape}, wanted one rate for each time")

    @property
    def epoch(self) -> decimal.Decimal:
        """What the times count from, exact [s]: of rates from a file the time of the first; 0 where times are seconds of their own."""
        import decimal
        return decimal.Decimal(getattr(self.times, "epoch", "0"))

    def __len__(self) -> int:
        return len(self.rates)

    def __repr__(self) -> str:
        return f"Rates({len(self)} rates)"


def read_rates(path: Source, *, columns: Mapping[str, str] | None = None, time_scale: Number | None = None, fps: Number | None = None,
               epoch: str | datetime.date | np.datetime64 | None = None, world_axes: str | None = None, body_axes: str | None = None,
               world_rotation: Any = None, body_rotation: Any = None, drop_duplicates: bool = False, sort: bool = False,
               session: int | None = None, unwrap: str | None = None) -> Rates:
    """The rates of a gyro in a file of their own, as the command's `--gyro-file` reads them: a table with a header, the columns `t` and
    `wx`, `wy`, `wz` of the body, in any of their units.

    Times are seconds since the first rate, and `epoch` has the time of that. Rows without a number in one of the three are none.

    Parameters
    ----------
    path : str, path or file object
        `-` is standard input.
    columns, time_scale, fps, epoch, world_axes, body_axes, world_rotation, body_rotation, drop_duplicates, sort, unwrap
        As of `read`.
    session : int
        Which of several recordings in the file; one that is alone is read whole.

    Raises
    ------
    DataError
        Columns that are missing, times that do not increase, no rates; with `file`, `line` and `column`.
    AccessError
        The file is not there or cannot be read.
    ArgumentError
        An option that is no such thing.

    Warns
    -----
    ShapeWarning
        A unit of times that was told by their size.

    Examples
    --------
    >>> import orispline as ori, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "gyro.csv"
    >>> _ = path.write_text("t,wx_deg_s,wy_deg_s,wz_deg_s\\n1700000000.25,0,0,90\\n1700000000.5,0,0,180\\n")
    >>> rates = ori.read_rates(path)
    >>> rates.epoch, rates.times.tolist(), rates.rates.round(4).tolist()
    (Decimal('1700000000.25'), [0.0, 0.25], [[0.0, 0.0, 1.5708], [0.0, 0.0, 3.1416]])
    """
    rotations = {"world_rotation": rotation_text("world_rotation", world_rotation), "body_rotation": rotation_text("body_rotation", body_rotation)}
    options = stated({"time_scale": time_scale, "fps": fps, "epoch": epoch, "world_axes": world_axes, "body_axes": body_axes, "session": session,
                      "unwrap": unwrap, **rotations}) + flags({"drop_duplicates": drop_duplicates, "sort": sort})
    name, content = source_of(path)
    seconds, rates, first, warnings = _core.read_rates(name, options, names_by_meaning(columns), content)
    tell(warnings)
    return Rates(SecondsSince.of(seconds, first), rates)
