# SPDX-License-Identifier: Apache-2.0
"""Curves through keyframes: what they are made of, and how they look."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

from . import _core
from ._arrays import Array, as_given
from ._blending import Blending
from ._checks import real
from ._errors import tell
from ._evaluation import BEYOND, ORIENTATION, POSITION, OrientationCurve
from ._keys import Keys, axes_stated, keys_of
from ._looks import Looks
from ._methods import blending_of

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._measures import DistanceStatistics, HandleTurn
    from ._types import AngleUnit, Extrapolate, Method, Number, Signs, Time, TimeUnit


class Curve(Looks, OrientationCurve):
    """A smooth curve through keyframes, with exact angular velocity, acceleration and jerk.

    Functions of time take a time or an array of times of any shape, in any order; what they give has that shape and one
    axis more, and is a tensor or another library's array where the times are. Angular rates are in the body frame unless
    `frame="world"`. A curve never changes, and threads may share it.

    Parameters
    ----------
    times, rotations
        As of `Keys`, which also says what the other arguments for keys mean. Or the first is a `Keys`, which has had them all.
    method : str, Blending or Curve, optional
        A method by name (`orispline.methods()` lists them), or by its text form, `"quintic:tension=0.6"`; blending functions
        of one's own (`orispline.blending`); or a curve, whose method it is. Without it that of the file which the keys are
        from, if it names one, else `auto`.
    ends : str or (str, str), optional
        End rule for both ends, or for each.
    start_rate, end_rate : (3,) arrays, optional
        Angular velocity at an end [rad/s], body frame; the rule of that end is then `clamped`.
    closed : bool
        A loop: the last key is the first one again.
    period : float, optional
        A loop whose first key returns so many seconds after it.
    extrapolate : {"hold", "error", "nan", "rate", "segment", "leave-out"}
        What a time outside the curve gets: the end orientation at rest, an error, NaN, the motion at the end's rate, or
        what the formula of the end segment gives there. With `"leave-out"` `sample` has no sample outside the curve and in its
        gaps; functions of time, which have a row for each, give NaN.
    **settings
        Parameters of the method: a number, or one for each key, or a word. `tension=0.4`, `variant="boyle"`.

    Raises
    ------
    ArgumentError
        A method, setting, rule or rate that there is not.
    DataError
        Keys that `Keys` refuses, or too few of them.
    TypeError
        Arguments for keys beside a `Keys`.

    Warns
    -----
    ShapeWarning
        What is noteworthy about the curve, as the command's `sample` says it, such as `overturned_span`: it turns much farther
        than its keys.

    Examples
    --------
    >>> import orispline as ori
    >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> curve
    Curve('auto', 3 keys, 0 … 3 s, C²)
    >>> curve(1.0).round(12).tolist()
    [0.0, 0.0, 0.6, 0.8]
    >>> curve.angular_velocity([[0.5, 1.5]]).shape
    (1, 2, 3)
    """

    __slots__ = ()

    def __init__(self, times: Any, rotations: Any = None, method: Method | None = None, *,
                 ends: str | tuple[str, str] | None = None, start_rate: Any = None, end_rate: Any = None,
                 closed: bool = False, period: float | None = None, extrapolate: Extrapolate = "hold",
                 positions: Any = None, angular_velocities: Any = None, angular_accelerations: Any = None,
                 angular_jerks: Any = None, inner_leaving: Any = None, inner_arriving: Any = None,
                 signs: Signs | None = None, scalar_first: bool | None = None,
                 normalize: bool | None = None, normalise: bool | None = None, euler: str | None = None,
                 angle_unit: AngleUnit | None = None, drop_invalid: bool | None = None, drop_duplicates: bool | None = None,
                 sort: bool | None = None, time_unit: TimeUnit | None = None, gap: Number | None = None, jumps: bool | None = None,
                 **settings: Any) -> None:
        of_keys = {"rotations": rotations, "positions": positions, "angular_velocities": angular_velocities,
                   "angular_accelerations": angular_accelerations, "angular_jerks": angular_jerks,
                   "inner_leaving": inner_leaving, "inner_arriving": inner_arriving, "signs": signs,
                   "scalar_first": scalar_first, "normalize": normalize, "normalise": normalise, "euler": euler,
                   "angle_unit": angle_unit, "drop_invalid": drop_invalid, "drop_duplicates": drop_duplicates, "sort": sort,
                   "time_unit": time_unit, "gap": gap, "jumps": jumps}
        if isinstance(times, Keys) and isinstance(rotations, (str, Blending)):
            raise TypeError(f"rotations: found {rotations!r} beside Keys, wanted method={rotations!r}")
        keys = keys_of(times, {name: value for name, value in of_keys.items() if value is not None})
        text = keys._method_text(method, ends, start_rate, end_rate, closed, period, settings)
        self._set(keys, _core.Curve(keys._core, text), extrapolate)
        tell(self._core.warnings)

    @property
    def keys(self) -> Keys:
        """The keys that it was made of."""
        return self._keys

    @property
    def times(self) -> np.ndarray[Any, Any]:
        """(n,) times of the keys."""
        return self._keys.times

    @property
    def method(self) -> str:
        """The method in its text form, with the settings that are not its defaults."""
        method: str = self._core.method
        return method

    @property
    def info(self) -> dict[str, Any]:
        """What the registry says of the method."""
        return dict(self._core.info)

    @property
    def blending(self) -> Blending | None:
        """The blending functions of one's own that the method is of; None for a method that `orispline.methods()` lists."""
        return blending_of(self._core.method)

    @property
    def settings(self) -> dict[str, Any]:
        """The parameters and choices of the method that shape the curve, defaults too, each a number, an array with one for each
        key, or a word. `Curve(keys, curve.info["name"], **curve.settings)` has the same.

        >>> import orispline as ori
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "quintic", tension=0.4).settings
        {'tension': 0.4}
        """
        return dict(self._core.settings)

    def _with(self, keys: Keys) -> Curve:
        """The curve of the same method through other keys."""
        return _restored(keys, *self.__reduce__()[1][1:])

    def in_frame(self, world: str | None = None, body: str | None = None, *, world_rotation: Any = None, body_rotation: Any = None) -> Curve:
        """This curve with other axes for the world, for the body, or for both: the curve of its method through
        `keys.in_axes(...)`, whose arguments and errors these are. Rates of clamped ends turn as the keys do.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
        >>> curve.in_frame("NED:ENU", "FRD:FLU").angular_velocity(0.5).round(4).tolist()
        [0.0, 0.0, -3.1416]
        """
        stated = axes_stated(world, body, world_rotation, body_rotation, self._scalar_first)
        method = _core.method_in_axes(self._core.method, stated)
        return _restored(self._keys.in_axes(world, body, world_rotation=world_rotation, body_rotation=body_rotation), method, self._extrapolate)

    def _turned(self, world: str | None, body: str | None) -> Curve:
        return self.in_frame(world_rotation=world, body_rotation=body)

    @overload
    def band(self, t: Time, share: float = ...) -> float: ...
    @overload
    def band(self, t: ArrayLike, share: float = ...) -> Array: ...

    def band(self, t: Any, share: float = 0.9) -> Any:
        """The angle [rad] about a curve that is meant to hold this share of the true motion, at times which are held to the
        curve's domain: a float for one time, else an array of their shape. It is known of curves of the method `measured`, and of
        `hermite-c2` through keys that `smooth(..., sigma=True)` made. Infinite where the keys say nothing, NaN in gaps. It takes
        as long as making the curve.

        Raises ArgumentError for another curve and for a share that is not between 0 and 1.

        >>> import numpy as np, orispline as ori
        >>> times = np.arange(40.0)
        >>> half = 0.3 * np.sin(times) + 0.01 * np.sin(7.3 * times)
        >>> curve = ori.Curve(times, np.column_stack([0 * half, 0 * half, np.sin(half), np.cos(half)]), "measured")
        >>> bool(0 < curve.band(20.5) < curve.band(20.5, 0.99))
        True
        """
        seconds = self._clock.seconds("t", t)
        bands = np.empty(seconds.shape)
        self._core.bands_at(real("share", share), seconds.reshape(-1), bands.reshape(-1))
        return as_given(t, bands) if bands.ndim else float(bands)

    def leave_out(self) -> DistanceStatistics:
        """How far the method misses keys that it is not given [rad]: each inner key is left out once, with every 4th. It
        estimates the error where nothing denser is known, and is not fit for choosing a method.

        Raises DataError for fewer than 3 keys, and ArgumentError for a setting with a value for each key and for gaps.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> curve.leave_out().count
        1
        """
        from ._measures import DistanceStatistics
        return DistanceStatistics(**self._core.leave_out())

    def overwound_tangent(self) -> HandleTurn | None:
        """The handle that turns farthest away from its key, where that is a full turn or more: there a curve of slerps
        (`squad-timed`, `shoemake`, `tcb`) loses its continuity. None where there is no such handle.

        >>> import orispline as ori
        >>> ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "tcb").overwound_tangent()
        """
        from ._measures import HandleTurn
        found = self._core.overwound_tangent()
        return None if found is None else HandleTurn(*found)

    def __repr__(self) -> str:
        count = len(self._keys)
        return (f"Curve({self.method!r}, {count} key{'' if count == 1 else 's'}, "
                f"{self._clock.span(np.array(self._core.domain))}, {self._order})")

    def _made_of(self) -> tuple[Any, ...]:
        return *super()._made_of(), self.blending

    def __reduce__(self) -> Any:
        return _restored, (self._keys, self.method, self._extrapolate)

    def _as_key(self, seconds: float) -> dict[str, Any]:
        """What a key has at a time of the library, beyond the ends what they have."""
        parts = {"orientations": ORIENTATION, **({} if self._keys.positions is None else {"positions": POSITION})}
        return {"times": seconds, **{name: self._core.one(what, seconds, False, BEYOND.index("hold")) for name, what in parts.items()}}


Keys._curve_class = Curve


def _restored(keys: Keys, method: str, extrapolate: Extrapolate) -> Curve:
    curve = Curve.__new__(Curve)
    curve._set(keys, _core.Curve(keys._core, method), extrapolate)
    return curve
