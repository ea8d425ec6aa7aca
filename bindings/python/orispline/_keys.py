# SPDX-License-Identifier: Apache-2.0
"""Keyframes."""
from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from . import _core
from ._arrays import Array, array_of, numbers, same
from ._checks import flag, index_of, wrong_type
from ._clock import Clock, SecondsSince, times_of_keys
from ._columns import INNER, PARTS, Columns, arguments_of, as_arrow, as_pandas, as_polars, columns_of
from ._errors import ArgumentError, DataError, tell
from ._files import Options, Writable, stated, write
from ._forms import of_euler, poses, rotation_text
from ._frames import as_xarray, of_arrow, of_pandas, of_polars, of_xarray, refuse_frame
from ._mending import Indices, Mending, scaled
from ._methods import ends_text, method_text
from ._names import Named

if TYPE_CHECKING:
    import decimal

    from ._curve import Curve
    from ._measures import KeyStatistics
    from ._types import AngleUnit, Method, Number, Signs, TimeUnit

SIGNS = ("shortest", "as-given")
CURES = {"duplicate time": "drop_duplicates=True keeps the first", "comes after": "sort=True puts them in order"}  # by words of an error
THREE = "a jump has two keys of one time, and this is a third"
SIGNS_AS_GIVEN, IS_DATED, JUMPS = 6, 8, 13  # of origin_of_keys()


class Keys(Named, Writable):
    """Orientations at times, checked: what curves are made of. They never change.

    Parameters
    ----------
    times : (n,) array
        Strictly increasing: seconds, datetime64 or timedelta64, also as objects and as columns of pandas. Dates with a time zone
        come back as those of UTC. Integers of another unit want `time_unit`.
    rotations : (n, 4) quaternions, (n, 3, 3) matrices, (n, 4, 4) poses, a SciPy Rotation or RigidTransform, or a list of Rotations
        Body to world. Quaternions are x, y, z, w, as SciPy has them; with `scalar_first` w, x, y, z. Poses bring positions.
        With `euler` (n, 3) angles.
    positions : (n, 3) array, optional
        [m], world frame.
    angular_velocities, angular_accelerations, angular_jerks : (n, 3) arrays, optional
        Rates at the keys [rad/s], [rad/s²], [rad/s³], body frame, for methods that take them. A row of NaN leaves the
        rate of its key free: `least` chooses it, the others estimate it.
    inner_leaving, inner_arriving : (n, 4) arrays, optional
        Inner quaternions of `squad`, body to world, in the order of `rotations`: the control points a_n of the segment that leaves
        each key, and b_n of the one that arrives at it. On the segment from key n to n+1 the curve is
        Slerp(2t(1-t); Slerp(t; q_n, q_n+1), Slerp(t; a_n, b_n+1)). A row of NaN leaves one free: `squad` chooses it. Of the two
        signs the one that is nearer to the key is taken. The first b and the last a are not used.
    settings : mapping of (n,) arrays, optional
        Values of a method's parameters with one for each key, such as `{"tension": ...}`.
    signs : {"shortest", "as-given"}
        Whether quaternions are negated for the shortest way, or their signs say how many turns a step makes.
    scalar_first : bool
        The order of quaternions, here and in all that these keys and their curves give back.
    normalize, normalise : bool
        Take quaternions of any norm but 0. Without it norms may be off by 1e-3. Both spellings mean the same.
    euler : str, optional
        The order of Euler angles, as SciPy has it: `"ZYX"` turns about the axes of the body, `"zyx"` about those of the world.
    angle_unit : {"rad", "deg", "mrad", "arcsec"}, optional
        Of these angles; without it rad.
    drop_invalid : bool
        Drop keys with NaN or infinite numbers, but whole rows of rates and inner quaternions, with NaT, and with a
        quaternion of zeros.
    drop_duplicates : bool
        Of keys at equal times keep the first.
    sort : bool
        Bring the keys into the order of their times.
    time_unit : {"s", "ms", "us", "ns"}, optional
        The unit of integer times.
    gap : float, str or Fraction, optional
        Intervals between keys longer than this [s] are gaps, which no curve bridges: there it is NaN.
    jumps : bool
        Two keys may have one time, where the motion jumps: no curve leads from one to the other, and from that time on the
        second one counts. Not with `drop_duplicates`.

    Raises
    ------
    DataError
        Times that do not increase, numbers that are not finite (but whole rows of rates and inner quaternions), norms too far from
        1, lengths that differ; with `key`.
    ArgumentError
        Arrays of another shape or kind.

    Examples
    --------
    >>> import orispline as ori
    >>> keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> keys
    Keys(3 keys, 0 … 3 s)
    >>> len(keys[:2]), len(keys[keys.times > 0.5])
    (2, 2)
    >>> [(float(t), q.tolist()) for t, q in keys][1]
    (1.0, [0.0, 0.0, 0.6, 0.8])
    >>> ori.Keys([0, 1], [[90, 0, 0], [0, 0, 90]], euler="ZYX", angle_unit="deg").rotations.round(4).tolist()
    [[0.0, 0.0, 0.7071, 0.7071], [0.7071, 0.0, 0.0, 0.7071]]
    """

    __slots__ = ("__weakref__", "_clock", "_core", "_scalar_first", "_source")
    __array_ufunc__: ClassVar[None] = None  # NumPy leaves `array == keys` to the keys
    _source: dict[str, Any]  # what is known of the file that they are from
    _curve_class: ClassVar[type[Curve]]  # set by the module of curves, which knows this one

    def __init__(self, times: Any, rotations: Any = ..., *, positions: Any = None, angular_velocities: Any = None,
                 angular_accelerations: Any = None, angular_jerks: Any = None, inner_leaving: Any = None, inner_arriving: Any = None,
                 settings: Mapping[str, Any] | None = None, signs: Signs = "shortest", scalar_first: bool = False,
                 normalize: bool = False, normalise: bool = False, euler: str | None = None, angle_unit: AngleUnit | None = None,
                 drop_invalid: bool = False, drop_duplicates: bool = False, sort: bool = False,
                 time_unit: TimeUnit | None = None, gap: Number | None = None, jumps: bool = False) -> None:
        refuse_frame("times", times)
        if rotations is ...:
            raise TypeError("rotations: found none beside the times, wanted them: Keys(times, rotations)")
        index_of("signs", signs, SIGNS)
        scalar_first = flag("scalar_first", scalar_first)
        mending = Mending.of(normalize, normalise, drop_invalid, drop_duplicates, sort)
        if flag("jumps", jumps) and mending.drop_duplicates:
            raise ArgumentError("jumps: wanted no drop_duplicates, which drops the second key of a jump")
        orientations, positions = orientations_of(rotations, positions, scalar_first, euler, angle_unit)
        given = {"positions": positions, "angular_velocities": angular_velocities, "angular_accelerations": angular_accelerations,
                 "angular_jerks": angular_jerks, "inner_leaving": inner_leaving, "inner_arriving": inner_arriving}
        parts = {name: None if rows is None else numbers(name, rows, (None, len(PARTS[name]))) for name, rows in given.items()}
        if scalar_first:
            parts |= {name: None if parts[name] is None else _xyzw(parts[name]) for name in INNER}
        epoch = times.epoch if isinstance(times, SecondsSince) else "0"
        times = array_of("times", times)
        count = _check_lengths(times, {"rotations": orientations, **parts})
        kept, repairs = mending.rows(times, orientations, parts["positions"], [parts[name] for name in parts if name != "positions"])
        if kept is not None:
            times, orientations = times[kept], orientations[kept]
            parts = {name: None if rows is None else rows[kept] for name, rows in parts.items()}
        if mending.normalize:
            orientations, inner, norms = scaled(orientations, {name: parts[name] for name in INNER})
            parts, repairs = {**parts, **inner}, {**repairs, **norms}
        self._scalar_first, self._source = scalar_first, {"repairs": repairs}
        values = {} if settings is None else _values_per_key(settings, kept, count)
        try:
            seconds, self._clock = times_of_keys(times, time_unit, jumps=jumps)
            self._core = _core.Keys(seconds, orientations, **parts, settings=values, signs=signs, jumps=jumps)
        except DataError as error:
            cures = {**CURES, "duplicate time": THREE} if jumps else CURES
            error._cure = next((f" ({cure})" for found, cure in cures.items() if found in str(error)), "")
            raise error if kept is None or error.key is None else _at_row(error, int(kept[error.key])) from None
        if self._clock.origin:
            self._core = _core.keys_since(self._core, self._clock.epoch, self._clock.is_calendar)
        elif epoch != "0" and self._clock == Clock():
            self._core = _core.keys_since(self._core, epoch, False)
        if gap is not None:
            self._core = _core.keys_as_read(self._core, stated({"gap": gap}))

    @classmethod
    def from_pandas(cls, frame: Any, *, columns: Mapping[str, str] | None = None, **options: Any) -> Keys:
        """Of a DataFrame with the columns of `to_pandas()`: t, qw, qx, qy, qz, and where they are there px, py, pz [m], wx, wy, wz,
        ax, ay, az and jx, jy, jz (rates in the body frame, in rad and s), a_qw, …, b_qw, … (inner quaternions), and parameters of
        methods. Without t the index has the times, but for one that only counts the rows. Seconds count from the epoch in its `attrs`,
        where that has one, as `to_pandas` notes it.

        `columns` names yours, such as `{"t": "stamp", "qw": "q0"}`; other columns are left alone. The options are those of `Keys`
        that are not in the frame. Raises ArgumentError for columns that are not there.

        >>> import orispline as ori, pandas
        >>> frame = pandas.DataFrame({"w": [1, 0.8], "qx": [0, 0], "qy": [0, 0], "qz": [0, 0.6]}, index=[0.0, 2.0])
        >>> ori.Keys.from_pandas(frame, columns={"qw": "w"})
        Keys(2 keys, 0 … 2 s)
        """
        return cls._of_columns(of_pandas(frame, columns), **options)

    @classmethod
    def from_polars(cls, frame: Any, *, columns: Mapping[str, str] | None = None, **options: Any) -> Keys:
        """Of a Polars DataFrame or LazyFrame, as of `from_pandas`.

        >>> import orispline as ori, polars
        >>> frame = polars.DataFrame({"stamp": [0.0, 2.0], "qw": [1.0, 0.8], "qx": [0, 0], "qy": [0, 0], "qz": [0.0, 0.6]})
        >>> ori.Keys.from_polars(frame, columns={"t": "stamp"})
        Keys(2 keys, 0 … 2 s)
        """
        return cls._of_columns(of_polars(frame, columns), **options)

    @classmethod
    def from_arrow(cls, table: Any, *, columns: Mapping[str, str] | None = None, **options: Any) -> Keys:
        """Of a pyarrow Table, batch or reader, or of what has `__arrow_c_stream__`, such as a relation of DuckDB, as of `from_pandas`.

        >>> import orispline as ori
        >>> keys = ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]])
        >>> ori.Keys.from_arrow(keys.to_arrow()) == keys
        True
        """
        return cls._of_columns(of_arrow(table, columns), **options)

    @classmethod
    def from_xarray(cls, dataset: Any, *, columns: Mapping[str, str] | None = None, **options: Any) -> Keys:
        """Of an xarray Dataset with the variables of `to_xarray()`: t, orientation, and where they are there position, angular_velocity,
        and so on, of which a coordinate such as `["x", "y", "z", "w"]` says what the components are; or with the columns of `from_pandas`
        as variables. `columns` names yours, such as `{"t": "time", "orientation": "attitude"}`.

        >>> import orispline as ori
        >>> keys = ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]])
        >>> ori.Keys.from_xarray(keys.to_xarray()) == keys
        True
        """
        return cls._of_columns(of_xarray(dataset, columns), **options)

    @classmethod
    def _of_columns(cls, columns: Mapping[str, Any], *, scalar_first: bool = False, **options: Any) -> Keys:
        """Of columns by the names of a CSV file."""
        arguments = arguments_of(columns)
        if not flag("scalar_first", scalar_first):
            arguments |= {name: _xyzw(arguments[name]) for name in ("rotations", *INNER) if name in arguments}
        return cls(**arguments, scalar_first=scalar_first, **options)

    @classmethod
    def _of(cls, core: Any, clock: Clock, *, scalar_first: bool) -> Keys:
        keys = cls.__new__(cls)
        keys._core, keys._clock, keys._scalar_first = core, clock, scalar_first
        return keys

    def __len__(self) -> int:
        return len(self._core)

    def __getitem__(self, part: Any) -> Keys:
        """The keys of a place, of a slice, of a mask or of rising indices, with all that belongs to them.

        Whole numbers are places. A slice of other numbers, of stamps or of texts is of times, from the first one to the last, which
        is not in it. A time of day alone is of the day on which the slice starts.

        >>> import orispline as ori
        >>> keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> keys[-1], keys[0.5:3.0]
        (Keys(1 key, 3 … 3 s), Keys(1 key, 1 … 1 s))
        """
        from ._places import Rows
        rows = Rows("keys", self._core.times, self._clock, _core.epoch_of_keys(self._core))
        return Keys._of(_core.part_of_keys(self._core, rows.places(part, rising=True).tolist()), self._clock, scalar_first=self._scalar_first)

    def __add__(self, more: Keys) -> Keys:
        """Both, in their order, with all that they carry: rates and inner quaternions that one of them does not have are free there.
        Of keys that may jump the second may begin at the time at which the first end.

        Raises DataError, with `key`, for times that do not come after these, and ArgumentError for what cannot be joined.

        >>> import orispline as ori
        >>> ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]) + ori.Keys([3], [[0, 0, 1, 0]])
        Keys(3 keys, 0 … 3 s)
        """
        if not isinstance(more, Keys):
            return NotImplemented
        from ._joining import joined
        return Keys._of(joined(self, more), self._clock, scalar_first=self._scalar_first)

    def __iter__(self) -> Iterator[tuple[Any, Array]]:
        """Each key's time and quaternion."""
        return zip(self.times, self.rotations)

    def __eq__(self, other: object) -> bool:
        """Whether both have the same times, quaternions and all else that keys carry, gaps too; NaN is as NaN."""
        if not isinstance(other, Keys):
            return NotImplemented
        return (self._clock, self._scalar_first, self._signs_as_given, self.gap) == (other._clock, other._scalar_first, other._signs_as_given, other.gap) \
            and self.settings == other.settings \
            and all(same(getattr(self._core, name), getattr(other._core, name)) for name in ("times", "orientations", *PARTS))

    def __hash__(self) -> int:
        return hash((len(self), self._clock, self._core.times[-1].item()))

    @property
    def times(self) -> np.ndarray[Any, Any]:
        """(n,) as they were given, in seconds, in another unit or as datetime64. Seconds since the `epoch` of a file remember it:
        keys that are made of them have it too."""
        times = self._clock.back(self._core.times)
        return SecondsSince.of(times, _core.epoch_of_keys(self._core)) if self._clock == Clock() else times

    @property
    def rotations(self) -> Array:
        """(n, 4) unit quaternions, with the signs that curves follow."""
        q: Array = self._core.orientations
        return _wxyz(q) if self._scalar_first else q

    @property
    def positions(self) -> Array | None:
        """(n, 3) [m], or None."""
        return self._core.positions

    @property
    def angular_velocities(self) -> Array | None:
        """(n, 3) [rad/s], body frame, or None."""
        return self._core.angular_velocities

    @property
    def angular_accelerations(self) -> Array | None:
        """(n, 3) [rad/s²], body frame, or None."""
        return self._core.angular_accelerations

    @property
    def angular_jerks(self) -> Array | None:
        """(n, 3) [rad/s³], body frame, or None."""
        return self._core.angular_jerks

    @property
    def inner_leaving(self) -> Array | None:
        """(n, 4) unit quaternions in the order of `rotations`, NaN where they are free, or None."""
        q = self._core.inner_leaving
        return _wxyz(q) if self._scalar_first and q is not None else q

    @property
    def inner_arriving(self) -> Array | None:
        """(n, 4) unit quaternions in the order of `rotations`, NaN where they are free, or None."""
        q = self._core.inner_arriving
        return _wxyz(q) if self._scalar_first and q is not None else q

    @property
    def settings(self) -> dict[str, list[float]]:
        """Values of parameters, one for each key, by name."""
        return dict(self._core.settings)

    @property
    def gap(self) -> float | None:
        """Intervals longer than this [s] are gaps, which no curve bridges; None where there are none."""
        found: float | None = _core.gap_of_keys(self._core)
        return found

    @property
    def report(self) -> dict[str, float]:
        """What was noticed, `sign_flips`, `non_unit_keys`, `largest_norm_error`, `near_half_turns`."""
        return dict(self._core.report)

    @property
    def epoch(self) -> decimal.Decimal:
        """What the times count from, exact [s]. Of keys from a file the time of its first key, of dates the seconds
        since 1970-01-01; 0 where times are seconds of their own."""
        import decimal
        return decimal.Decimal(_core.epoch_of_keys(self._core))

    @property
    def repairs(self) -> dict[str, Any]:
        """What reading a file, and the options for mending arrays, touched. `duplicates_dropped`, `invalid_dropped`, `rows_moved` and
        `normalised` count rows, `rates_left_free` keys; `largest_norm_error` is that of the quaternions that were scaled to 1.
        Empty where nothing was to be mended."""
        return dict(self._read("repairs", {}))

    def statistics(self) -> KeyStatistics:
        """What the keys are like, before any curve is drawn through them.

        Examples
        --------
        >>> import orispline as ori
        >>> keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> keys.statistics().spacing
        Spread(smallest=1.0, median=1.5, largest=2.0, largest_at=1)
        """
        from ._measures import KeyStatistics, Spread
        span, spacing, step, near_half_turns = _core.key_statistics(self._core)
        return KeyStatistics(span, Spread(*spacing) if spacing else None, Spread(*step) if step else None,
                             tuple(near_half_turns))

    def curve(self, method: Method | None = None, **options: Any) -> Curve:
        """The curve of a method through these keys: `Curve(keys, method=method, **options)`. Without a method that of
        the file which the keys are from, if it names one, else `auto`."""
        return self._curve_class(self, method=method, **options)

    def in_axes(self, world: str | None = None, body: str | None = None, *, world_rotation: Any = None, body_rotation: Any = None) -> Keys:
        """These keys with other axes for the world, for the body, or for both, with all that they carry.

        Parameters
        ----------
        world, body : str, optional
            The axes that they have and those wanted, such as `"NED:ENU"`. Three letters say where +x, +y and +z point: North, South,
            East, West, Up, Down in a world with a compass; Right, Left, Front, Back, Up, Down in one without, and of bodies. No digit
            of a vector changes. Handedness changes on both sides or on none.
        world_rotation, body_rotation : quaternion, matrix, SciPy Rotation, str or path, optional
            What takes coordinates along these axes into those wanted: any rotation, also by names (`"roll_deg=0,pitch_deg=0,yaw_deg=90"`)
            or in a file of one row.

        Raises
        ------
        ArgumentError
            Letters that are no axes, handedness that changes on one side only, what is no rotation.

        Examples
        --------
        >>> import orispline as ori
        >>> keys = ori.Keys([0], [[0.36, 0.48, 0, 0.8]], positions=[[1, 2, 3]], angular_velocities=[[0.1, 0.2, 0.3]])
        >>> ros = keys.in_axes("NED:ENU", "FRD:FLU")
        >>> ros.rotations.round(6).tolist(), ros.positions.tolist(), ros.angular_velocities.tolist()
        ([[0.59397, -0.084853, 0.565685, 0.565685]], [[2.0, 1.0, -3.0]], [[0.1, -0.2, -0.3]])
        """
        core = _core.keys_in_axes(self._core, axes_stated(world, body, world_rotation, body_rotation, self._scalar_first))
        return Keys._of(core, self._clock, scalar_first=self._scalar_first)

    def write(self, path: Any, **options: Any) -> None:
        """Writes them into a file, complete or not at all: `orispline.write(keys, path, **options)`.

        Examples
        --------
        >>> import orispline as ori, pathlib, tempfile
        >>> path = pathlib.Path(tempfile.mkdtemp()) / "keys.tum"
        >>> ori.Keys([0, 1.5], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]).write(path)
        >>> path.read_text().splitlines()[1]
        '1.5 0 0 0 0 0 0.6 0.8'
        """
        write(self, path, **options)

    def to_arrow(self) -> Any:
        """A pyarrow Table with the columns of their CSV file: t, qw, qx, qy, qz, and where they have them px, …, wx, …, ax, …, jx, …,
        a_qw, …, b_qw, … and settings. The times are those of `times`; the metadata of the schema has what they count from, `epoch`.
        Needs pyarrow."""
        return as_arrow(self._columns(), self.epoch)

    def to_pandas(self) -> Any:
        """A pandas DataFrame with the columns of `to_arrow()`, of which `from_pandas` makes them again; its `attrs` has the epoch.
        Needs pandas.

        >>> import orispline as ori
        >>> list(ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]).to_pandas().columns)
        ['t', 'qw', 'qx', 'qy', 'qz']
        """
        return as_pandas(self._columns(), self.epoch)

    def to_polars(self) -> Any:
        """A Polars DataFrame with the columns of `to_arrow()`, which has no place for the epoch. Needs Polars."""
        return as_polars(self._columns())

    def to_xarray(self) -> Any:
        """An xarray Dataset along `t`: orientation along `quaternion` too, in the order of `rotations`, and where they have them position,
        angular_velocity, angular_acceleration and angular_jerk along `axis`, inner_leaving, inner_arriving and settings. Its attribute
        `epoch` is what the times count from. Needs xarray.

        >>> import orispline as ori
        >>> dict(ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]).to_xarray()["orientation"].sizes)
        {'t': 2, 'quaternion': 4}
        """
        return as_xarray(self.times, self.epoch, "body", "wxyz" if self._scalar_first else "xyzw",
                         {"orientation": self.rotations, "position": self.positions, "angular_velocity": self.angular_velocities,
                          "angular_acceleration": self.angular_accelerations, "angular_jerk": self.angular_jerks,
                          "inner_leaving": self.inner_leaving, "inner_arriving": self.inner_arriving,
                          **{name: np.array(values) for name, values in self.settings.items()}})

    def _columns(self) -> Columns:
        columns = columns_of(self.times, _wxyz(self._core.orientations),
                             [self.angular_velocities, self.angular_accelerations, self.angular_jerks], [self.positions, None, None], "body")
        for name, names in INNER.items():
            if (rows := getattr(self._core, name)) is not None:
                columns |= dict(zip(names, _wxyz(rows).T.copy()))
        return {**columns, **{name: np.array(values) for name, values in self.settings.items()}}

    @property
    def _is_dated(self) -> bool:
        """Whether the epoch is since 1970."""
        return bool(_core.origin_of_keys(self._core)[IS_DATED])

    @property
    def _signs_as_given(self) -> bool:
        return bool(_core.origin_of_keys(self._core)[SIGNS_AS_GIVEN])

    def _write_as(self, path: str, in_memory: bool, options: Options, method: str | None = None) -> bytes:
        content: bytes
        content, warnings = _core.write_keys(self._core, path, in_memory, options, self._read("format", ""), method)
        tell(warnings)
        return content

    def _method_text(self, method: Method | None, ends: Any, start_rate: Any, end_rate: Any, closed: bool,
                     period: float | None, settings: Mapping[str, Any]) -> str:
        """The method's text form; without one that of the file, as far as nothing else is said."""
        shape = {"ends": ends, "start_rate": start_rate, "end_rate": end_rate, "closed": closed or None, "period": period}
        said = [*settings, *(name for name, value in shape.items() if value is not None)]
        if method is None:
            named = _core.method_for_keys(self._core, said, "auto", None if ends is None else ends_text(ends))
            return method_text(named, None, start_rate, end_rate, closed, period, settings)
        text = method_text(method, ends, start_rate, end_rate, closed, period, settings)
        tell(_core.recipe_set_aside(self._core, text))
        return text

    def _read(self, name: str, otherwise: Any) -> Any:
        """What is known of the file that the keys are from."""
        return getattr(self, "_source", {}).get(name, otherwise)

    def __repr__(self) -> str:
        count = len(self)
        return f"Keys({count} key{'' if count == 1 else 's'}, {self._clock.span(self._core.times)})"

    def __reduce__(self) -> Any:
        c = self._core
        rows = {name: getattr(c, name) for name in PARTS}
        return _restored, (c.times, c.orientations, rows, c.settings, self._clock, self._scalar_first,
                           _core.origin_of_keys(c), getattr(self, "_source", {}))


def axes_stated(world: str | None, body: str | None, world_rotation: Any, body_rotation: Any, scalar_first: bool) -> Options:
    """Other axes, as options of reading state them."""
    for side, axes in (("world", world), ("body", body)):
        if axes is not None and not isinstance(axes, str):
            raise wrong_type(side, axes, f"letters such as 'NED:ENU'; {side}_rotation= takes a rotation")
    rotations = {f"{side}_rotation": rotation_text(f"{side}_rotation", given, scalar_first=scalar_first)
                 for side, given in (("world", world_rotation), ("body", body_rotation))}
    return stated({"world_axes": world, "body_axes": body, **rotations})


def keys_of(times: Any, given: dict[str, Any]) -> Keys:
    """Of the times and what else is given for keys, or Keys themselves, beside which nothing may be given."""
    if not isinstance(times, Keys):
        if "rotations" not in given and isinstance(getattr(times, "keys", None), Keys):
            raise TypeError(f"times: found {type(times).__name__}, wanted times and rotations, or Keys, such as its .keys")
        return Keys(times, **given)
    if given:
        raise TypeError(f"{next(iter(given))}: found {', '.join(given)} beside Keys, wanted them with the Keys: Keys(times, rotations, …)")
    return times


def orientations_of(rotations: Any, positions: Any, scalar_first: bool, euler: Any, angle_unit: Any) -> tuple[Array, Any]:
    """Quaternions x, y, z, w, and positions, which may stand in poses."""
    if euler is not None:
        return of_euler("rotations", rotations, euler, "rad" if angle_unit is None else angle_unit), positions
    if angle_unit is not None:
        raise ArgumentError("angle_unit: found it without euler, wanted the order of angles with it, such as euler='ZYX'")
    orientations, found = poses("rotations", rotations, scalar_first=scalar_first)
    if found is not None and positions is not None:
        raise ArgumentError("positions: found them beside poses, which have their own, wanted one of them")
    return orientations, positions if found is None else found


def _wxyz(quaternions: Any) -> Array:
    return np.ascontiguousarray(quaternions[:, [3, 0, 1, 2]])


def _xyzw(quaternions: Any) -> Array:
    return np.ascontiguousarray(quaternions[:, [1, 2, 3, 0]])


def _check_lengths(times: np.ndarray[Any, Any], columns: Mapping[str, Array | None]) -> int:
    """The number of keys."""
    if times.ndim != 1:
        raise ArgumentError(f"times: found the shape {times.shape}, wanted (n,)")
    for name, rows in columns.items():
        if rows is not None and len(rows) != len(times):
            raise DataError(f"{name}: found {len(rows)}, wanted one for each of the {len(times)} times")
    return len(times)


def _at_row(error: DataError, row: int) -> DataError:
    """About the row that was given, where rows were dropped or sorted since."""
    told = DataError(error.args[0].replace(f"key {error.key}:", f"row {row}:", 1))
    told.key, told._cure = row, error._cure
    return told


def _values_per_key(settings: Any, kept: Indices | None, count: int) -> dict[str, list[float]]:
    """Those of the keys that are kept of so many."""
    wanted = 'a mapping of arrays by names of parameters, such as {"tension": values}'
    if not isinstance(settings, Mapping) or not all(isinstance(name, str) for name in settings):
        raise wrong_type("settings", settings, wanted)
    arrays = {name: np.asarray(values) for name, values in settings.items()}
    if any(array.ndim != 1 or array.dtype.kind not in "fiu" for array in arrays.values()):
        raise wrong_type("settings", settings, wanted)
    if kept is not None:
        arrays = {name: array[kept] if len(array) == count else array for name, array in arrays.items()}
    return {name: array.astype(np.float64).tolist() for name, array in arrays.items()}


def _restored(times: Array, orientations: Array, rows: dict[str, Array | None], settings: dict[str, list[float]],
              clock: Clock, scalar_first: bool, origin: tuple[Any, ...], source: dict[str, Any]) -> Keys:
    as_given, jumps = origin[SIGNS_AS_GIVEN], any(origin[JUMPS:])  # which older pickles do not have
    made = _core.Keys(times, orientations, **rows, settings=settings, signs="as-given" if as_given else "shortest", jumps=jumps)
    keys = Keys._of(_core.keys_from(made, *origin), clock, scalar_first=scalar_first)
    keys._source = source
    return keys
