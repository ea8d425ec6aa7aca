# SPDX-License-Identifier: Apache-2.0
"""Keyframes."""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np

from . import _core
from ._arrays import Array, numbers, quaternions
from ._checks import flag, method_text, wrong_type
from ._clock import Clock, times_of_keys
from ._errors import ArgumentError, DataError, tell
from ._files import Options, Writable, write

if TYPE_CHECKING:
    import decimal

    from ._curve import Curve
    from ._measures import KeyStatistics

SIGNS = ("shortest", "as-given")
SIGNS_AS_GIVEN = 6  # of origin_of_keys()


class Keys(Writable):
    """Orientations at times, checked: what curves are made of. They never change.

    Parameters
    ----------
    times : (n,) array
        Strictly increasing: seconds, or datetime64. Integers of another unit want `time_unit`.
    rotations : (n, 4) quaternions, (n, 3, 3) matrices or a SciPy Rotation
        Body to world. Quaternions are x, y, z, w, as SciPy has them; with `scalar_first` w, x, y, z.
    positions : (n, 3) array, optional
        [m], world frame.
    angular_velocities, angular_accelerations, angular_jerks : (n, 3) arrays, optional
        Rates at the keys [rad/s], [rad/s²], [rad/s³], body frame, for methods that take them. A row of NaN leaves the
        rate of its key free: `least` chooses it, the others estimate it.
    settings : mapping of (n,) arrays, optional
        Values of a method's parameters with one for each key, such as `{"tension": ...}`.
    signs : {"shortest", "as-given"}
        Whether quaternions are negated for the shortest way, or their signs say how many turns a step makes.
    scalar_first : bool
        The order of quaternions, here and in all that these keys and their curves give back.
    normalize : bool
        Take quaternions of any norm but 0. Without it norms may be off by 1e-3.
    time_unit : {"s", "ms", "us", "ns"}, optional
        The unit of integer times.

    Raises
    ------
    DataError
        Times that do not increase, numbers that are not finite (but whole rows of rates), norms too far from 1, lengths that differ; with `key`.
    ArgumentError
        Arrays of another shape or kind.

    Examples
    --------
    >>> import orispline as ori
    >>> keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> keys
    Keys(3 keys, 0 … 3 s)
    >>> len(keys[:2])
    2
    """

    __slots__ = ("_clock", "_core", "_scalar_first", "_source")
    _source: dict[str, Any]  # what is known of the file that they are from
    _curve_class: ClassVar[type[Curve]]  # set by the module of curves, which knows this one

    def __init__(self, times: Any, rotations: Any, *, positions: Any = None, angular_velocities: Any = None,
                 angular_accelerations: Any = None, angular_jerks: Any = None, settings: Mapping[str, Any] | None = None,
                 signs: str = "shortest", scalar_first: bool = False, normalize: bool = False,
                 time_unit: str | None = None) -> None:
        if signs not in SIGNS:
            raise ArgumentError(f"signs: found {signs!r}, wanted 'shortest' or 'as-given'")
        scalar_first = flag("scalar_first", scalar_first)
        seconds, self._clock = times_of_keys(times, time_unit)
        orientations = quaternions("rotations", rotations, scalar_first=scalar_first)
        if flag("normalize", normalize):
            orientations = _normalized(orientations)
        vectors = {"positions": positions, "angular_velocities": angular_velocities,
                   "angular_accelerations": angular_accelerations, "angular_jerks": angular_jerks}
        for name, rows in (("rotations", orientations), *vectors.items()):
            if rows is not None and len(rows) != len(seconds):
                raise DataError(f"{name}: found {len(rows)}, wanted one for each of the {len(seconds)} times")
        self._scalar_first = scalar_first
        self._core = _core.Keys(
            seconds, orientations,
            **{name: None if rows is None else numbers(name, rows, (None, 3)) for name, rows in vectors.items()},
            settings=_values_per_key({} if settings is None else settings), signs=signs)
        if self._clock.origin:
            self._core = _core.keys_since(self._core, self._clock.epoch)

    @classmethod
    def _of(cls, core: Any, clock: Clock, *, scalar_first: bool) -> Keys:
        keys = cls.__new__(cls)
        keys._core, keys._clock, keys._scalar_first = core, clock, scalar_first
        return keys

    def __len__(self) -> int:
        return len(self._core)

    def __getitem__(self, part: slice) -> Keys:
        """The keys of a slice, with all that belongs to them."""
        if not isinstance(part, slice):
            raise TypeError(f"keys: found the index {part!r}, wanted a slice such as keys[2:5]")
        first, last, step = part.indices(len(self))
        if step < 0:
            raise ArgumentError(f"keys: found the step {part.step}, wanted one above 0, since times rise")
        return Keys._of(_core.part_of_keys(self._core, list(range(first, last, step))), self._clock,
                        scalar_first=self._scalar_first)

    @property
    def times(self) -> np.ndarray[Any, Any]:
        """(n,) as they were given, in seconds, in another unit or as datetime64."""
        return self._clock.back(self._core.times)

    @property
    def rotations(self) -> Array:
        """(n, 4) unit quaternions, with the signs that curves follow."""
        q: Array = self._core.orientations
        return q[:, [3, 0, 1, 2]] if self._scalar_first else q

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
    def settings(self) -> dict[str, list[float]]:
        """Values of parameters, one for each key, by name."""
        return dict(self._core.settings)

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
        """What reading touched. `duplicates_dropped`, `invalid_dropped`, `rows_moved` and `normalised` count rows,
        `rates_left_free` keys; `largest_norm_error` is that of the quaternions that were scaled to 1. Empty for keys that are not from a file."""
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

    def curve(self, method: str | None = None, **options: Any) -> Curve:
        """The curve of a method through these keys: `Curve(keys, method=method, **options)`. Without a method that of
        the file which the keys are from, if it names one, else `auto`."""
        return self._curve_class(self, method=method, **options)

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

    def _write_as(self, path: str, options: Options, method: str | None = None) -> None:
        tell(_core.write_keys(self._core, path, options, self._read("format", ""), method))

    def _method_text(self, method: str | None, ends: Any, start_rate: Any, end_rate: Any, closed: bool,
                     period: float | None, settings: Mapping[str, Any]) -> str:
        """The method's text form; without one that of the file, as far as nothing else is said."""
        shape = {"ends": ends, "start_rate": start_rate, "end_rate": end_rate, "closed": closed or None, "period": period}
        said = [*settings, *(name for name, value in shape.items() if value is not None)]
        if method is None:
            rules = ends if ends is None or isinstance(ends, str) else ",".join(ends)
            named = _core.method_for_keys(self._core, said, "auto", rules)
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
        rows = {"positions": c.positions, "angular_velocities": c.angular_velocities,
                "angular_accelerations": c.angular_accelerations, "angular_jerks": c.angular_jerks}
        return _restored, (c.times, c.orientations, rows, c.settings, self._clock, self._scalar_first,
                           _core.origin_of_keys(c), getattr(self, "_source", {}))


def _values_per_key(settings: Any) -> dict[str, list[float]]:
    wanted = 'a mapping of arrays by names of parameters, such as {"tension": values}'
    if not isinstance(settings, Mapping) or not all(isinstance(name, str) for name in settings):
        raise wrong_type("settings", settings, wanted)
    arrays = {name: np.asarray(values) for name, values in settings.items()}
    if any(array.ndim != 1 or array.dtype.kind not in "fiu" for array in arrays.values()):
        raise wrong_type("settings", settings, wanted)
    return {name: array.astype(np.float64).tolist() for name, array in arrays.items()}


def _normalized(orientations: Array) -> Array:
    norms = np.linalg.norm(orientations, axis=1, keepdims=True)
    with np.errstate(invalid="ignore", divide="ignore"):
        # A quaternion of norm 1 but for rounding keeps its digits.
        return np.where((np.abs(norms - 1) <= 1e-12) | (norms == 0), orientations, orientations / norms)


def _restored(times: Array, orientations: Array, rows: dict[str, Array | None], settings: dict[str, list[float]],
              clock: Clock, scalar_first: bool, origin: tuple[Any, ...], source: dict[str, Any]) -> Keys:
    as_given = origin[SIGNS_AS_GIVEN]
    made = _core.Keys(times, orientations, **rows, settings=settings, signs="as-given" if as_given else "shortest")
    keys = Keys._of(_core.keys_from(made, *origin), clock, scalar_first=scalar_first)
    keys._source = source
    return keys
