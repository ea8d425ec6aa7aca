# SPDX-License-Identifier: Apache-2.0
"""What a curve is at one time, and at many."""
from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Array
from ._checks import rate_text
from ._clock import Clock
from ._files import Options, Writable, write

if TYPE_CHECKING:
    import decimal

    from ._keys import Keys


@dataclasses.dataclass(frozen=True)
class Motion:
    """A curve at one time: an orientation with its rates, and where the keys have positions the position with its own."""

    orientation: NDArray[np.float64]
    angular_velocity: NDArray[np.float64]
    angular_acceleration: NDArray[np.float64]
    angular_jerk: NDArray[np.float64]
    position: NDArray[np.float64] | None = None
    velocity: NDArray[np.float64] | None = None
    acceleration: NDArray[np.float64] | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class Origin:
    """How samples came about, for files: what they count from, and the grid that they are on."""

    times: np.ndarray[Any, Any]  # of the samples that this belongs to
    seconds: Array  # since the epoch
    epoch: str = "0"
    grid: tuple[Any, ...] | None = None  # rate, count, start, end, include_end; the domain of the curve
    scalar_first: bool = False
    like: str = ""  # the format of the file that the keys were read from


@dataclasses.dataclass(frozen=True, eq=False)
class Samples(Writable):
    """Samples of a curve: (k,) times, (k, 4) orientations and (k, 3) of all else; None is what was not asked for.

    Angular rates are in the frame that `frame` names, positions and their rates in the world frame.
    """

    times: np.ndarray[Any, Any]
    orientations: NDArray[Any]
    angular_velocities: NDArray[Any] | None = None
    angular_accelerations: NDArray[Any] | None = None
    angular_jerks: NDArray[Any] | None = None
    positions: NDArray[Any] | None = None
    velocities: NDArray[Any] | None = None
    accelerations: NDArray[Any] | None = None
    frame: str = "body"
    _origin: Origin | None = dataclasses.field(default=None, repr=False)

    def __len__(self) -> int:
        return len(self.times)

    @property
    def epoch(self) -> decimal.Decimal:
        """What times count from, exact [s], of a file or since 1970-01-01; 0 where they are seconds of their own."""
        import decimal
        return decimal.Decimal(self._from.epoch)

    def write(self, path: Any, **options: Any) -> None:
        """Writes them into a file, complete or not at all: `orispline.write(samples, path, **options)`.

        Examples
        --------
        >>> import orispline as ori, pathlib, tempfile
        >>> path = pathlib.Path(tempfile.mkdtemp()) / "motion.csv"
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]], "slerp").sample(count=2).write(path)
        >>> path.read_text().splitlines()[0]
        't,qw,qx,qy,qz'
        """
        write(self, path, **options)

    def to_arrow(self) -> Any:
        """A pyarrow Table with the columns of a CSV file: t [s] or timestamps, qw, qx, qy, qz, px, …, wx, ….

        The times are those of `times`; the metadata of the schema has what they count from, `epoch`. Needs pyarrow.
        """
        try:
            import pyarrow  # type: ignore[import-untyped, unused-ignore]
        except ImportError:
            raise ImportError("to_arrow: found no pyarrow, wanted it installed: pip install 'orispline[tables]'") from None
        return pyarrow.table(self._columns(), metadata={"epoch": f"{self.epoch:f}"})

    def to_pandas(self) -> Any:
        """A pandas DataFrame with the columns of `to_arrow()`; its `attrs` has the epoch. Needs pandas."""
        try:
            import pandas  # type: ignore[import-untyped, unused-ignore]
        except ImportError:
            raise ImportError("to_pandas: found no pandas, wanted it installed: pip install pandas") from None
        frame = pandas.DataFrame(self._columns())
        frame.attrs["epoch"] = self.epoch
        return frame

    @property
    def _from(self) -> Origin:
        """That of the curve; of samples that somebody made, their own times."""
        if self._origin is not None and self._origin.times is self.times:
            return self._origin
        times = np.asarray(self.times)
        if times.dtype.kind == "M":
            clock = Clock("ns", int(times[0].astype("datetime64[ns]").astype(np.int64)) if len(times) else 0, True)
            return Origin(times, clock.seconds("times", times), clock.epoch)
        return Origin(times, np.ascontiguousarray(times, dtype=np.float64))

    def _write_as(self, path: str, options: Options, method: str | None = None) -> None:
        origin = self._from
        q = np.asarray(self.orientations, dtype=np.float64)
        rows = [None if values is None else np.ascontiguousarray(values, dtype=np.float64) for values in self._vectors()]
        _core.write_samples(path, options, origin.like, origin.epoch, origin.grid, self.frame == "world", origin.seconds,
                            np.ascontiguousarray(q[:, [1, 2, 3, 0]] if origin.scalar_first else q), *rows)

    def _vectors(self) -> list[NDArray[Any] | None]:
        return [self.angular_velocities, self.angular_accelerations, self.angular_jerks, self.positions, self.velocities,
                self.accelerations]

    def _columns(self) -> dict[str, NDArray[Any]]:
        rates, linear = self._vectors()[:3], self._vectors()[3:]
        names = _core.column_names(self.frame == "world", sum(rows is not None for rows in rates),
                                   sum(rows is not None for rows in linear) - 1)
        q = self.orientations if self._from.scalar_first else self.orientations[:, [3, 0, 1, 2]]
        rows = [q, *(rows for rows in (linear[0], *rates, *linear[1:]) if rows is not None)]
        columns = [np.ascontiguousarray(table[:, k]) for table in rows for k in range(table.shape[1])]
        return dict(zip(names, [self.times, *columns], strict=True))


def samples_of(keys: Keys, seconds: Array, rows: list[Any], frame: str, grid: tuple[Any, ...] | None) -> Samples:
    """Samples of a curve through these keys, with what their file needs: the times of a grid are exact there."""
    stamps = keys._clock.back(seconds)
    if grid is not None:
        rate, count, *bounds = grid
        grid = (None if rate is None else rate_text(rate), None if count is None else int(count), *bounds)
    origin = Origin(stamps, seconds, _core.epoch_of_keys(keys._core), grid, keys._scalar_first, keys._read("format", ""))
    return dataclasses.replace(Samples(stamps, *rows), frame=frame, _origin=origin)
