# SPDX-License-Identifier: Apache-2.0
"""Curves through keyframes: what they are at times, what they are worth, and how they look."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Array, array_of, as_given, inertia_tensor, numbers, output, sample_rows
from ._baked import BakedCurve, baked
from ._blending import Blending
from ._checks import check_number, flag, in_world, index_of, rate_text, real, thread_count, whole
from ._columns import PARTS
from ._errors import ArgumentError, DataError, tell
from ._forms import quaternions
from ._keys import Keys
from ._looks import Looks
from ._methods import blending_of
from ._orienting import Orienting
from ._samples import Motion, Samples, samples_of
from ._types import quantity, rate

if TYPE_CHECKING:
    from typing import Literal

    from numpy.typing import ArrayLike

    from ._measures import DistanceStatistics, Energies, HandleTurn, Peaks
    from ._types import AngleUnit, Extrapolate, Frame, Method, Number, Rate, Side, Signs, Time, TimeUnit, Vector

BEYOND = tuple(_core.extrapolations())
LEAVE_OUT = "leave-out"
SIDES = ("right", "left")
ALONE = 1  # thread, of an int and not of what equals one
ORIENTATION, VELOCITY, ACCELERATION, JERK, POSITION, LINEAR_VELOCITY, LINEAR_ACCELERATION = range(7)


class Curve(Looks, Orienting):
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

    __slots__ = ("_beyond", "_clock", "_core", "_keys", "_leaves_out", "_plain", "_scalar_first")

    def __init__(self, times: Any, rotations: Any = None, method: Method | None = None, *,
                 ends: str | tuple[str, str] | None = None, start_rate: Any = None, end_rate: Any = None,
                 closed: bool = False, period: float | None = None, extrapolate: Extrapolate = "hold",
                 positions: Any = None, angular_velocities: Any = None, angular_accelerations: Any = None,
                 angular_jerks: Any = None, inner_leaving: Any = None, inner_arriving: Any = None,
                 signs: Signs | None = None, scalar_first: bool | None = None,
                 normalize: bool | None = None, normalise: bool | None = None, euler: str | None = None,
                 angle_unit: AngleUnit | None = None, drop_invalid: bool | None = None, drop_duplicates: bool | None = None,
                 sort: bool | None = None, time_unit: TimeUnit | None = None, gap: Number | None = None, **settings: Any) -> None:
        of_keys = {"rotations": rotations, "positions": positions, "angular_velocities": angular_velocities,
                   "angular_accelerations": angular_accelerations, "angular_jerks": angular_jerks,
                   "inner_leaving": inner_leaving, "inner_arriving": inner_arriving, "signs": signs,
                   "scalar_first": scalar_first, "normalize": normalize, "normalise": normalise, "euler": euler,
                   "angle_unit": angle_unit, "drop_invalid": drop_invalid, "drop_duplicates": drop_duplicates, "sort": sort,
                   "time_unit": time_unit, "gap": gap}
        given = {name: value for name, value in of_keys.items() if value is not None}
        if isinstance(times, Keys) and isinstance(rotations, (str, Blending)):
            raise TypeError(f"rotations: found {rotations!r} beside Keys, wanted method={rotations!r}")
        if isinstance(times, Keys) and given:
            raise TypeError(f"{next(iter(given))}: found {', '.join(given)} beside Keys, wanted them with the Keys: Keys(times, rotations, …)")
        keys = times if isinstance(times, Keys) else Keys(times, **{"rotations": None, **given})
        text = keys._method_text(method, ends, start_rate, end_rate, closed, period, settings)
        self._set(keys, _core.Curve(keys._core, text), extrapolate)
        tell(self._core.warnings)

    def _set(self, keys: Keys, core: Any, extrapolate: Extrapolate) -> None:
        way = index_of("extrapolate", extrapolate, (*BEYOND, LEAVE_OUT))
        self._leaves_out = extrapolate == LEAVE_OUT
        self._keys, self._core, self._beyond = keys, core, BEYOND.index("nan") if self._leaves_out else way
        self._clock, self._scalar_first = keys._clock, keys._scalar_first
        self._plain = self._clock.unit == "s" and not self._scalar_first

    # What it is.

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
    def domain(self) -> tuple[Any, Any]:
        """The first and the last time."""
        return self._clock.ends(self._core.domain)

    @property
    def settings(self) -> dict[str, Any]:
        """The parameters and choices of the method that shape the curve, defaults too, each a number, an array with one for each
        key, or a word. `Curve(keys, curve.info["name"], **curve.settings)` has the same.

        >>> import orispline as ori
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "quintic", tension=0.4).settings
        {'tension': 0.4}
        """
        return dict(self._core.settings)

    def continuity(self) -> int:
        """The order to which it is continuous in time at its keys, measured: 2 is C², 3 the most that is looked for, and -1
        says that the orientation itself jumps between them. A loop is measured where it closes too.

        >>> import orispline as ori
        >>> ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp").continuity()
        0
        """
        return int(self._core.continuity())

    def _with(self, keys: Keys) -> Curve:
        """The curve of the same method through other keys."""
        return _restored(keys, *self.__reduce__()[1][1:])

    # What it is at times.

    @quantity
    def __call__(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., 4) unit quaternions, x, y, z, w, or w, x, y, z where the keys were given so."""
        if isinstance(t, float) and self._plain and out is None and dtype is np.float64 and threads is ALONE:
            return self._core.one(ORIENTATION, t, False, self._beyond)  # type: ignore[no-any-return]
        if not self._scalar_first:
            return self._at(ORIENTATION, t, "body", out, dtype, threads)
        q = self._at(ORIENTATION, array_of("t", t), "body", None, dtype, threads)
        result = output("out", out, q.shape, q.dtype)
        result[...] = q[..., [3, 0, 1, 2]]
        return as_given(t, result)  # type: ignore[no-any-return]

    @rate
    def angular_velocity(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                         threads: int = 1) -> NDArray[Any]:
        """(..., 3) [rad/s]."""
        return self._at(VELOCITY, t, frame, out, dtype, threads)

    @rate
    def angular_acceleration(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                             threads: int = 1) -> NDArray[Any]:
        """(..., 3) [rad/s²]."""
        return self._at(ACCELERATION, t, frame, out, dtype, threads)

    @rate
    def angular_jerk(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                     threads: int = 1) -> NDArray[Any]:
        """(..., 3) [rad/s³]."""
        return self._at(JERK, t, frame, out, dtype, threads)

    def derivative(self, order: Literal[1, 2, 3] = 1) -> Rate[Vector]:
        """The function of time that its first derivative is, `angular_velocity`, or the next ones: `angular_acceleration` and
        `angular_jerk`.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 2], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
        >>> curve.derivative()([0.5, 1.0]).round(4).tolist()
        [[0.0, 0.0, 1.5708], [0.0, 0.0, 1.5708]]
        """
        return (self.angular_velocity, self.angular_acceleration, self.angular_jerk)[whole("order", order, 1, 3) - 1]

    @quantity
    def position(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., 3) [m], world frame."""
        return self._at(POSITION, t, "body", out, dtype, threads)

    @quantity
    def velocity(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., 3) [m/s], world frame."""
        return self._at(LINEAR_VELOCITY, t, "body", out, dtype, threads)

    @quantity
    def acceleration(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., 3) [m/s²], world frame."""
        return self._at(LINEAR_ACCELERATION, t, "body", out, dtype, threads)

    def motion(self, t: Time, side: Side = "right", *, frame: Frame = "body") -> Motion:
        """All of these at one time; rates in that frame. Where rates jump at a key, `side="left"` has those before it.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp")
        >>> [round(float(curve.motion(1.0, side=side).angular_velocity[2]), 4) for side in ("left", "right")]
        [1.287, 0.9273]
        """
        if np.asarray(t).ndim:
            raise ArgumentError("t: found an array, wanted one time")
        if index_of("side", side, SIDES) == 1:
            q = self(t)  # with what a time outside gets
            seconds = float(self._clock.seconds("t", t))
            first, last = self._core.domain
            if first < seconds <= last:
                return Motion(q, *self._core.rates_before(seconds, in_world(frame)))
        rates = [self._at(what, t, frame, None, np.float64, 1) for what in (VELOCITY, ACCELERATION, JERK)]
        linear = [self._at(what, t, "body", None, np.float64, 1)
                  for what in (POSITION, LINEAR_VELOCITY, LINEAR_ACCELERATION)] if self._core.has_positions else []
        return Motion(self(t), *rates, *linear)

    def sample(self, rate: Any = None, *, count: int | None = None, times: Any = None, start: Any = None, end: Any = None,
               include_end: bool = False, derivatives: int = 0, frame: str = "body", dtype: Any = np.float64,
               threads: int = 1, out: Any = None) -> Samples:
        """Samples at even times, or at given ones: at `rate` per second (a number, or a fraction such as `"30000/1001"`),
        `count` of them with both ends, or at `times`.

        `derivatives` is the highest order of the rates, 0 to 3. `start` and `end` are times of the curve's own kind.
        `include_end` makes the end a sample too where a rate does not meet it. `threads=0` uses all cores; the numbers
        are the same on any. `out` is filled: an array for the orientations, or a list of all that is asked for, in the order
        of `Samples`.
        """
        world = in_world(frame)
        even = self._grid_wanted(rate, count, times, start, end, include_end, derivatives)
        seconds = np.empty(len(even)) if even is not None else self._given(times)
        linear = min(derivatives, 2) + 1 if self._core.has_positions else 0
        self._check_room(out)
        rows = sample_rows(out, (len(seconds),), derivatives, linear, dtype, seconds)
        how = {"world": world, "beyond": self._beyond, "threads": thread_count(threads)}
        if even is None:
            self._core.fill(seconds, *rows, **how)
        else:
            self._core.fill_even(even, seconds, *rows, **how)
        if self._scalar_first:
            rows[0][...] = rows[0][:, [3, 0, 1, 2]]
        grid = None if even is None else self._grid_stated(rate, count, start, end, include_end)
        return samples_of(self._keys, *self._there(seconds, rows), frame, grid)

    # What it is worth. An `inertia` is a body's tensor about its centre of mass [kg m²], body frame: (3, 3), symmetric and positive
    # definite, or its three principal moments.

    def energies(self, inertia: Any = None) -> Energies:
        """∫|α|² dt, ∫|jerk|² dt and, with an inertia, ∫|torque|² dt, to 1e-10 of each segment's.

        Raises ArgumentError for an inertia that is not symmetric and positive definite, and warns (`ShapeWarning`) of one
        that no rigid body has.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> round(curve.energies().acceleration, 4)
        0.1294
        """
        from ._measures import Energies
        return Energies(**self._core.energies(None if inertia is None else inertia_tensor(inertia)))

    def peaks(self, inertia: Any = None) -> Peaks:
        """The largest |ω|, |α| and, with an inertia, |torque| that were found, the times when they are reached, and what
        they are nowhere above, as far as `Peak` has that. Errors as of `energies`.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp")
        >>> peak = curve.peaks().angular_velocity
        >>> round(peak.value, 12), peak.time
        (1.287002217587, 0.0)
        """
        from ._measures import Peak, Peaks
        found = self._core.peaks(None if inertia is None else inertia_tensor(inertia))
        return Peaks(**{name: Peak(value, self._clock.time(time), bound) for name, (value, time, bound) in found.items()})

    @overload
    def angle_travelled(self, t: Time | None = None) -> float: ...
    @overload
    def angle_travelled(self, t: ArrayLike) -> Array: ...

    def angle_travelled(self, t: Any = None) -> Any:
        """∫|ω| dt [rad]: of the whole curve, or from its start to the times `t`, which are held to its domain: a float for
        one time, else an array of their shape.

        >>> import numpy as np, orispline as ori
        >>> curve = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
        >>> bool(np.allclose([curve.angle_travelled(), curve.angle_travelled(0.5)], [np.pi, np.pi / 2]))
        True
        """
        if t is None:
            return float(self._core.whole_angle())
        seconds = self._clock.seconds("t", t)
        angles = np.empty(seconds.shape)
        self._core.angles_at(seconds.reshape(-1), angles.reshape(-1))
        return as_given(t, angles) if angles.ndim else float(angles)

    @overload
    def time_at_angle(self, angle: float) -> Any: ...
    @overload
    def time_at_angle(self, angle: ArrayLike) -> NDArray[Any]: ...

    def time_at_angle(self, angle: Any) -> Any:
        """The first times at which the curve has travelled these angles [rad], which are held to 0 and `angle_travelled()`:
        of their shape, as the caller has times.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
        >>> round(curve.time_at_angle(1.5707963267948966), 12)
        0.5
        """
        angles = numbers("angle", angle, (None,) * np.ndim(angle))
        seconds = np.empty(np.shape(angle))
        self._core.times_at(angles.reshape(-1), seconds.reshape(-1))
        return as_given(angle, self._clock.back(seconds)) if seconds.ndim else self._clock.time(float(seconds))

    def at_angle(self, angle: ArrayLike) -> Array:
        """(..., 4) unit quaternions where the curve has travelled these angles [rad], as of `time_at_angle`: at even angles
        they are evenly spaced along its path, whatever its rate.

        >>> import numpy as np, orispline as ori
        >>> curve = ori.Curve([0, 1, 9], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp")
        >>> q = curve.at_angle(np.linspace(0, curve.angle_travelled(), 5))
        >>> np.degrees(2 * np.arctan2(q[:, 2], q[:, 3])).round(9).tolist()
        [0.0, 45.0, 90.0, 135.0, 180.0]
        """
        return self(self.time_at_angle(angle))

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

    def torque(self, t: Any, inertia: Any) -> NDArray[np.float64]:
        """(..., 3) J α + ω × J ω [N m], body frame: what turns a free rigid body so. Errors as of `energies`.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> curve.torque([0.5, 1.5], [1.0, 2.0, 2.5]).shape
        (2, 3)
        """
        tensor, times = inertia_tensor(inertia), array_of("t", t)
        rates = self.angular_velocity(times)
        result = np.empty(rates.shape)
        _core.torques(rates.reshape(-1, 3), self.angular_acceleration(times).reshape(-1, 3), tensor, result.reshape(-1, 3))
        return as_given(t, result)  # type: ignore[no-any-return]

    def distance(self, times: Any, rotations: Any) -> DistanceStatistics:
        """How far the curve is from orientations at times: the full angle from one to the other [rad], at those times that
        lie in its domain.

        `times` and `rotations` are as of `Keys`: (n,) strictly increasing, (n, 4) in the order of this curve, (n, 3, 3) or a
        SciPy Rotation. Raises DataError for such as `Keys` refuses, and where no time lies on the curve.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]])
        >>> round(curve.distance([0.5], [[0, 0, 0, 1]]).rms, 12)
        1.570796326795
        """
        seconds, rows = self._series(times, quaternions("rotations", rotations, scalar_first=self._scalar_first), "rotations")
        self._clock.check_rising(seconds)
        reference = _core.Keys(seconds, rows, **dict.fromkeys(PARTS), settings={}, signs="as-given")
        return self._statistics(self._core.distance(reference))

    def rate_error(self, times: Any, rates: Any) -> DistanceStatistics:
        """How far ω of the curve is from logged angular velocities, (n, 3) [rad/s], body frame, at those of the (n,) times
        that lie in its domain. The times do not decrease. Where ω jumps at a key, the mean of both sides counts.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]])
        >>> round(curve.rate_error([0.5], [[0, 0, 3]]).largest, 12)
        0.14159265359
        """
        seconds, rows = self._series(times, numbers("rates", rates, (None, 3)), "rates")
        self._clock.check_series(seconds)
        bad = ~np.isfinite(rows).all(axis=1)
        if bad.any():
            raise DataError(f"rates: found {rows[bad][0].tolist()} at index {int(bad.argmax())}, wanted finite numbers")
        return self._statistics(self._core.rate_error(seconds, rows))

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

    # How it is kept.

    def bake(self, tolerance: float, *, dtype: Any = np.float64) -> BakedCurve:
        """The curve turned into polynomials, to be stored and replayed: no orientation is farther from the curve's own than
        `tolerance` [rad]. float32 is smaller, for tolerances from 1e-6 on. Ctrl-C stops it.

        Raises ArgumentError for a tolerance below 1e-13 (1e-6), for one that cannot be reached, with the key, and for gaps.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> curve.bake(1e-9).largest_difference < 1e-9
        True
        """
        return baked(self._core, self._clock, self._scalar_first, tolerance, dtype)

    def __repr__(self) -> str:
        order = str(self.continuity()).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))
        count = len(self._keys)
        return (f"Curve({self.method!r}, {count} key{'' if count == 1 else 's'}, "
                f"{self._clock.span(np.array(self._core.domain))}, C{order})")

    def __reduce__(self) -> Any:
        return _restored, (self._keys, self.method, LEAVE_OUT if self._leaves_out else BEYOND[self._beyond])

    def _quaternions(self, t: Any) -> NDArray[np.float64]:
        return self._at(ORIENTATION, t, "body", None, np.float64, 1)

    # How it reads its arguments. A `CurveStack` does so by its first curve.

    def _grid_wanted(self, rate: Any, count: int | None, times: Any, start: Any, end: Any, include_end: bool,
                     derivatives: int) -> Any:
        """The grid of the samples, None where their times are given."""
        if sum(given is not None for given in (rate, count, times)) != 1:
            raise ArgumentError("sample: wanted one of rate, count and times")
        if isinstance(derivatives, (bool, np.ndarray)) or derivatives not in (0, 1, 2, 3):
            raise ArgumentError(f"derivatives: found {derivatives!r}, wanted 0, 1, 2 or 3")
        include_end = flag("include_end", include_end)
        if times is not None:
            if start is not None or end is not None or include_end:
                raise ArgumentError("times: found start, end or include_end beside times, wanted them with a rate or a count")
            return None
        bounds = self._bounds(start, end)
        if count is not None and (isinstance(count, bool) or not isinstance(count, (int, np.integer)) or count < 1):
            raise ArgumentError(f"count: found {count!r}, wanted a whole number from 1 on")
        if count is not None:
            check_number(count)
        text, number = (rate_text(rate), None) if count is None else (None, int(count))
        grid = self._core.grid(text, number, *bounds, include_end)
        check_number(len(grid))
        return grid

    def _check_room(self, out: Any) -> None:
        if self._leaves_out and out is not None:
            raise ArgumentError("out: found it with extrapolate='leave-out', wanted none: how many samples there are shows in the end")

    def _there(self, seconds: NDArray[np.float64], rows: list[Any]) -> tuple[NDArray[np.float64], list[Any]]:
        """Times and rows, without those where the curve is not if they are to be left out."""
        if not self._leaves_out:
            return seconds, rows
        there = ~np.isnan(rows[0]).reshape(len(seconds), -1).any(axis=1)
        return seconds[there], [None if values is None else values[there] for values in rows]

    def _grid_stated(self, rate: Any, count: int | None, start: Any, end: Any, include_end: bool) -> tuple[Any, ...]:
        """A grid as files take it, whose times are exact."""
        return (rate, count, *self._bounds(start, end), include_end, *self._core.domain)

    def _given(self, times: Any) -> NDArray[np.float64]:
        seconds = self._asked("times", times)
        if seconds.ndim != 1:
            raise ArgumentError(f"times: found the shape {seconds.shape}, wanted (k,)")
        return seconds

    def _asked(self, name: str, times: Any) -> NDArray[np.float64]:
        """Times to ask for [s]. Those outside are named as the caller has times, where that is an error."""
        seconds = self._clock.seconds(name, times)
        if BEYOND[self._beyond] == "error":
            self._clock.check_inside(seconds, self._core.domain)
        return seconds

    def _bounds(self, start: Any, end: Any) -> list[str | None]:
        return [None if t is None else repr(float(self._clock.seconds(name, t))) for name, t in
                (("start", start), ("end", end))]

    def _at(self, what: int, t: Any, frame: str, out: Any, dtype: Any, threads: int) -> NDArray[Any]:
        world = in_world(frame)
        if isinstance(t, float) and self._plain and out is None and dtype is np.float64 and threads is ALONE:
            return self._core.one(what, t, world, self._beyond)  # type: ignore[no-any-return]
        seconds = self._asked("t", t)
        result = output("out", out, (*seconds.shape, 4 if what == ORIENTATION else 3), dtype, seconds)
        self._core.many(what, seconds.reshape(-1), result.reshape(-1, result.shape[-1]), world, self._beyond,
                        thread_count(threads))
        return as_given(t, result)  # type: ignore[no-any-return]

    def _as_key(self, seconds: float) -> dict[str, Any]:
        """What a key has at a time of the library, beyond the ends what they have."""
        parts = {"orientations": ORIENTATION, **({} if self._keys.positions is None else {"positions": POSITION})}
        return {"times": seconds, **{name: self._core.one(what, seconds, False, BEYOND.index("hold")) for name, what in parts.items()}}

    def _series(self, times: Any, rows: Array, name: str) -> tuple[Array, Array]:
        seconds = self._clock.seconds("times", times)
        if seconds.ndim != 1:
            raise ArgumentError(f"times: found the shape {seconds.shape}, wanted (n,)")
        if len(rows) != len(seconds):
            raise DataError(f"{name}: found {len(rows)}, wanted one for each of the {len(seconds)} times")
        return seconds, rows

    def _statistics(self, found: dict[str, Any]) -> DistanceStatistics:
        from ._measures import DistanceStatistics
        if found["count"] == 0:
            first, last = self._clock.back(np.array(self._core.domain))
            raise DataError(f"times: found none from {first} to {last}, where the curve is, wanted one at least")
        return DistanceStatistics(**found)


Keys._curve_class = Curve


def _restored(keys: Keys, method: str, extrapolate: Extrapolate) -> Curve:
    curve = Curve.__new__(Curve)
    curve._set(keys, _core.Curve(keys._core, method), extrapolate)
    return curve
