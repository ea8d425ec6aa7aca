# SPDX-License-Identifier: Apache-2.0
"""What a curve is at one time, and at many."""
from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Array, same
from ._checks import rate_text, whole
from ._clock import Clock, clock_of_stamps
from ._columns import Columns, as_arrow, as_pandas, as_polars, columns_of
from ._errors import ArgumentError
from ._files import Options, Writable, write
from ._frames import as_xarray
from ._html import few_rows, table
from ._names import Named

if TYPE_CHECKING:
    import decimal

    from ._keys import Keys

COLUMNS = 8  # fields of samples: times, orientations and the vectors


class Moment:
    """Numbers at one time, which are equal where all of them are; NaN is as NaN."""

    orientation: NDArray[Any]

    def __eq__(self, other: object) -> bool:
        if type(other) is not type(self):
            return NotImplemented
        return all(same(one, another) for one, another in zip(vars(self).values(), vars(other).values()))

    def __hash__(self) -> int:
        return hash((self.orientation.astype(np.float64) + 0.0).tobytes())  # where -0 is 0


@dataclasses.dataclass(frozen=True, eq=False)
class Motion(Moment):
    """A curve at one time: an orientation with its rates, and where the keys have positions the position with its own."""

    orientation: NDArray[np.float64]
    angular_velocity: NDArray[np.float64]
    angular_acceleration: NDArray[np.float64]
    angular_jerk: NDArray[np.float64]
    position: NDArray[np.float64] | None = None
    velocity: NDArray[np.float64] | None = None
    acceleration: NDArray[np.float64] | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class Sample(Moment):
    """One of `Samples`: a time, and what they have there; None is what was not asked for. Of a `CurveStack` a row for each joint."""

    time: Any
    orientation: NDArray[Any]
    angular_velocity: NDArray[Any] | None = None
    angular_acceleration: NDArray[Any] | None = None
    angular_jerk: NDArray[Any] | None = None
    position: NDArray[Any] | None = None
    velocity: NDArray[Any] | None = None
    acceleration: NDArray[Any] | None = None


@dataclasses.dataclass(frozen=True, eq=False)
class Origin:
    """How samples came about, for files: what they count from, and the grid that they are on."""

    times: np.ndarray[Any, Any]  # of the samples that this belongs to
    seconds: Array  # since the epoch
    epoch: str = "0"
    grid: tuple[Any, ...] | None = None  # rate, count, start, end, include_end; the domain of the curve
    scalar_first: bool = False
    like: str = ""  # the format of the file that the keys were read from
    clock: Clock = Clock()


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Samples(Named, Writable):
    """Samples of a curve: (k,) times, (k, 4) orientations and (k, 3) of all else; None is what was not asked for. Those of a
    `CurveStack` of m joints have one axis more, (k, m, 4) and (k, m, 3).

    Angular rates are in the frame that `frame` names, positions and their rates in the world frame. They are gone through one by one,
    each a `Sample`, and taken by places, slices and masks as `Keys` are.

    >>> import orispline as ori
    >>> samples = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp").sample(rate="4 Hz", derivatives=1)
    >>> [round(float(sample.time + sample.angular_velocity[2]), 4) for sample in samples[:2]]
    [3.1416, 3.3916]
    >>> samples[0.5:], samples[-1].orientation.round(9).tolist()
    (Samples(3 samples, 0.5 … 1 s, orientations, angular_velocities), [0.0, 0.0, 1.0, 0.0])
    """

    __array_ufunc__: ClassVar[None] = None  # NumPy leaves `array == samples` to the samples
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

    def __iter__(self) -> Iterator[Sample]:
        """Each in its turn."""
        return (self._one(place) for place in range(len(self)))

    @overload
    def __getitem__(self, part: int | np.integer[Any]) -> Sample: ...
    @overload
    def __getitem__(self, part: slice | Sequence[int] | NDArray[Any]) -> Samples: ...
    def __getitem__(self, part: Any) -> Sample | Samples:
        """One of them by its place, or those of a slice, of a mask or of indices, as of `Keys`."""
        from ._places import Rows, is_place
        origin = self._from
        rows = Rows("samples", origin.seconds, origin.clock, origin.epoch)
        if is_place(part):
            return self._one(rows.place(part))
        places = rows.places(part, rising=False)
        times = self.times[places]
        some = [self.orientations[places], *(None if values is None else values[places] for values in self._vectors())]
        origin = dataclasses.replace(origin, times=times, seconds=origin.seconds[places], grid=None)
        return dataclasses.replace(Samples(times, *some), frame=self.frame, _origin=origin)  # type: ignore[arg-type]

    def _one(self, place: int) -> Sample:
        return Sample(self.times[place], self.orientations[place], *(None if rows is None else rows[place] for rows in self._vectors()))

    @property
    def epoch(self) -> decimal.Decimal:
        """What times count from, exact [s], of a file or since 1970-01-01; 0 where they are seconds of their own."""
        import decimal
        return decimal.Decimal(self._from.epoch)

    def write(self, path: Any, **options: Any) -> None:
        """Writes them into a file, complete or not at all: `orispline.write(samples, path, **options)`. A file holds one joint.

        Examples
        --------
        >>> import orispline as ori, pathlib, tempfile
        >>> path = pathlib.Path(tempfile.mkdtemp()) / "motion.csv"
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]], "slerp").sample(count=2).write(path)
        >>> path.read_text().splitlines()[0]
        't,qw,qx,qy,qz'
        """
        write(self, path, **options)

    def joint(self, joint: int) -> Samples:
        """Of the samples of a `CurveStack` those of one joint, by its number.

        >>> import orispline as ori
        >>> stack = ori.CurveStack([0, 1], [[[0, 0, 0, 1], [0, 0, 0.6, 0.8]], [[0, 0, 0.6, 0.8], [0, 0, 0, 1]]])
        >>> stack.sample(count=5).joint(1)
        Samples(5 samples, 0 … 1 s, orientations)
        """
        if self._joints is None:
            raise ArgumentError("joint: found samples of one curve, wanted those of a CurveStack")
        index = whole("joint", joint, -self._joints, self._joints - 1)
        each = [self.orientations, *self._vectors()]
        one = Samples(self.times, *(rows if rows is None else rows[:, index] for rows in each))  # type: ignore[arg-type]
        return dataclasses.replace(one, frame=self.frame, _origin=self._origin)

    def to_arrow(self) -> Any:
        """A pyarrow Table with the columns of a CSV file: t [s] or timestamps, qw, qx, qy, qz, px, …, wx, ….

        The times are those of `times`; the metadata of the schema has what they count from, `epoch`. Samples of many joints are
        joint by joint, with its number in the column `joint`, as `orispline.tables` takes them with `by="joint"`. Needs pyarrow.
        """
        return as_arrow(self._columns(), self.epoch)

    def to_pandas(self) -> Any:
        """A pandas DataFrame with the columns of `to_arrow()`; its `attrs` has the epoch. Needs pandas."""
        return as_pandas(self._columns(), self.epoch)

    def to_polars(self) -> Any:
        """A Polars DataFrame with the columns of `to_arrow()`, which has no place for the epoch. Needs Polars."""
        return as_polars(self._columns())

    def to_xarray(self) -> Any:
        """An xarray Dataset along `t`: orientation along `quaternion` too, in the order of `orientations`, and what else there is,
        angular_velocity and so on, along `axis`; of many joints along `joint`. Its attribute `epoch` is what the times count from. Needs
        xarray.

        >>> import orispline as ori
        >>> samples = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]).sample(rate=4, derivatives=1)
        >>> samples.to_xarray()["angular_velocity"].dims
        ('t', 'axis')
        """
        vectors = dict(zip((field.name for field in dataclasses.fields(Sample)[2:]), self._vectors()))
        return as_xarray(self.times, self.epoch, self.frame, "wxyz" if self._from.scalar_first else "xyzw",
                         {"orientation": self.orientations, **vectors})

    def __repr__(self) -> str:
        count, there = len(self), [field.name for field in dataclasses.fields(self)[1:COLUMNS] if getattr(self, field.name) is not None]
        joints = "" if self._joints is None else f" of {self._joints} joint{'' if self._joints == 1 else 's'}"
        origin = self._from
        span = f", {origin.clock.span(origin.seconds)}" if count else ""
        world = ", world frame" if self.frame == "world" else ""
        return f"Samples({count} sample{'' if count == 1 else 's'}{joints}{span}, {', '.join(there)}{world})"

    def _repr_html_(self) -> str:
        """The table that a notebook shows: the first rows and the last."""
        columns = self._columns()
        return table(repr(self), list(columns), few_rows(columns))

    @property
    def _joints(self) -> int | None:
        """How many, of a stack."""
        return self.orientations.shape[1] if np.ndim(self.orientations) == 3 else None

    @property
    def _from(self) -> Origin:
        """That of the curve; of samples that somebody made, their own times."""
        if self._origin is not None and self._origin.times is self.times:
            return self._origin
        times = np.asarray(self.times)
        if times.dtype.kind in "Mm":
            seconds, clock = clock_of_stamps(times)
            return Origin(times, seconds, clock.epoch, clock=clock)
        return Origin(times, np.ascontiguousarray(times, dtype=np.float64))

    def _write_as(self, path: str, in_memory: bool, options: Options, method: str | None = None) -> bytes:
        if self._joints is not None:
            raise ArgumentError(f"write: found samples of {self._joints} joints, wanted those of one, such as of samples.joint(0): tables of "
                                "all are written by orispline.tables.write(samples.to_arrow(), path)")
        origin = self._from
        q = np.asarray(self.orientations, dtype=np.float64)
        rows = [None if values is None else np.ascontiguousarray(values, dtype=np.float64) for values in self._vectors()]
        return _core.write_samples(path, in_memory, options, origin.like, origin.epoch, origin.grid, self.frame == "world", origin.seconds,
                                   np.ascontiguousarray(q[:, [1, 2, 3, 0]] if origin.scalar_first else q), *rows)

    def _vectors(self) -> list[NDArray[Any] | None]:
        return [self.angular_velocities, self.angular_accelerations, self.angular_jerks, self.positions, self.velocities,
                self.accelerations]

    def _columns(self) -> Columns:
        q = self.orientations if self._from.scalar_first else self.orientations[..., [3, 0, 1, 2]]
        vectors = self._vectors()
        return columns_of(self.times, q, vectors[:3], vectors[3:], self.frame, self._joints)


def samples_of(keys: Keys, seconds: Array, rows: list[Any], frame: str, grid: tuple[Any, ...] | None) -> Samples:
    """Samples of a curve through these keys, with what their file needs: the times of a grid are exact there."""
    stamps = keys._clock.back(seconds)
    if grid is not None:
        rate, count, *bounds = grid
        grid = (None if rate is None else rate_text(rate), None if count is None else int(count), *bounds)
    origin = Origin(stamps, seconds, _core.epoch_of_keys(keys._core), grid, keys._scalar_first, keys._read("format", ""), keys._clock)
    return dataclasses.replace(Samples(stamps, *rows), frame=frame, _origin=origin)
