# SPDX-License-Identifier: Apache-2.0
"""What every curve of orientations can do: what it is at times, what it is worth, and the curves that are made of it."""
from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, ClassVar, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Array, array_of, as_given, inertia_tensor, numbers, output, sample_rows
from ._baked import BakedCurve, baked
from ._checks import check_number, flag, in_world, index_of, rate_text, thread_count, whole, wrong_type
from ._clock import Clock
from ._columns import PARTS
from ._errors import ArgumentError, DataError
from ._forms import inverse_text, quaternions, rotation_text
from ._frames import QUANTITIES, bare, is_labelled, labelled
from ._keys import Keys
from ._names import Named
from ._orienting import Orienting
from ._samples import Motion, Samples, samples_of
from ._types import quantity, rate

if TYPE_CHECKING:
    from typing import Literal

    from numpy.typing import ArrayLike
    from typing_extensions import Self

    from ._measures import DistanceStatistics, Energies, Peaks
    from ._types import Extrapolate, Frame, Rate, Side, Time, Vector

BEYOND = tuple(_core.extrapolations())
LEAVE_OUT = "leave-out"
SIDES = ("right", "left")
ALONE = 1  # thread, of an int and not of what equals one
ORIENTATION, VELOCITY, ACCELERATION, JERK, POSITION, LINEAR_VELOCITY, LINEAR_ACCELERATION = range(7)


class OrientationCurve(Named, Orienting):
    """A curve of orientations over time, with exact angular velocity, acceleration and jerk.

    Functions of time take a time or an array of times of any shape, in any order; what they give has that shape and one
    axis more, and is a tensor or another library's array where the times are; of a DataArray of xarray one with its dimensions and
    coordinates, lazily where it is in chunks of dask. Angular rates are in the body frame unless `frame="world"`. A curve never
    changes, and threads may share it.
    """

    __slots__ = ("__weakref__", "_beyond", "_clock", "_core", "_keys", "_leaves_out", "_of_one_time", "_scalar_first")
    __array_ufunc__: ClassVar[None] = None  # NumPy leaves `array * curve` to the curve
    _inverse_of: ClassVar[Callable[[OrientationCurve], OrientationCurve]]  # both set by the module of such curves, which knows this one
    _product_of: ClassVar[Callable[[OrientationCurve, OrientationCurve, OrientationCurve], OrientationCurve]]
    _clock: Clock
    _keys: Keys  # whose clock it has
    _scalar_first: bool

    def _set(self, keys: Keys, core: Any, extrapolate: Extrapolate) -> None:
        way = index_of("extrapolate", extrapolate, (*BEYOND, LEAVE_OUT))
        self._leaves_out = extrapolate == LEAVE_OUT
        self._keys, self._core, self._beyond = keys, core, BEYOND.index("nan") if self._leaves_out else way
        self._clock, self._scalar_first = keys._clock, keys._scalar_first
        self._of_one_time = (core.one, self._beyond) if self._clock.unit == "s" and not self._scalar_first else None  # as the core has it

    @property
    def _extrapolate(self) -> Extrapolate:
        return LEAVE_OUT if self._leaves_out else BEYOND[self._beyond]  # type: ignore[return-value]

    @property
    def domain(self) -> tuple[Any, Any]:
        """The first and the last time."""
        return self._clock.ends(self._core.domain)

    def continuity(self) -> int:
        """The order to which it is continuous in time at its keys, measured: 2 is C², 3 the most that is looked for, and -1
        says that the orientation itself jumps between them. A loop is measured where it closes too.

        >>> import orispline as ori
        >>> ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp").continuity()
        0
        """
        return int(self._core.continuity())

    # What it is at times.

    @quantity
    def __call__(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., 4) unit quaternions, x, y, z, w, or w, x, y, z where the keys were given so."""
        if isinstance(t, float) and out is None and dtype is np.float64 and threads is ALONE and (found := self._of_one_time):
            one, beyond = found
            return one(ORIENTATION, t, False, beyond)  # type: ignore[no-any-return]
        if not self._scalar_first:
            return self._at(ORIENTATION, t, "body", out, dtype, threads)
        if is_labelled(t):
            return self._at(ORIENTATION, t, "body", out, dtype, threads)
        q = self._at(ORIENTATION, array_of("t", t), "body", None, dtype, threads)
        result = output("out", out, q.shape, q.dtype)
        result[...] = q[..., [3, 0, 1, 2]]
        return as_given(t, result)  # type: ignore[no-any-return]

    @quantity
    def at(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """The same by a name, for chains of calls: `curve.at(t)` is `curve(t)`.

        >>> import orispline as ori
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp").at([0.0, 1.0]).round(12).tolist()
        [[0.0, 0.0, 0.0, 1.0], [0.0, 0.0, 1.0, 0.0]]
        """
        return self(t, out=out, dtype=dtype, threads=threads)

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
        """All of these at one time; rates in that frame. Where rates jump at a key, or the motion itself does, `side="left"` has what
        is before it.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp")
        >>> [round(float(curve.motion(1.0, side=side).angular_velocity[2]), 4) for side in ("left", "right")]
        [1.287, 0.9273]
        """
        if np.asarray(t).ndim:
            raise ArgumentError("t: found an array, wanted one time")
        t = bare(t)
        world = in_world(frame)
        if index_of("side", side, SIDES) == 1:
            seconds = float(self._clock.seconds("t", t))
            first, last = self._core.domain
            if first < seconds <= last:
                q, *others = self._core.motion_before(seconds, world)
                return Motion(q[[3, 0, 1, 2]] if self._scalar_first else q, *others)
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

    def torque(self, t: Any, inertia: Any) -> NDArray[np.float64]:
        """(..., 3) J α + ω × J ω [N m], body frame: what turns a free rigid body so. Errors as of `energies`.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> curve.torque([0.5, 1.5], [1.0, 2.0, 2.5]).shape
        (2, 3)
        """
        tensor, times = inertia_tensor(inertia), array_of("t", bare(t))
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
        reference = _core.Keys(seconds, rows, **dict.fromkeys(PARTS), settings={}, signs="as-given", jumps=False)
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

    @property
    def _order(self) -> str:
        return "C" + str(self.continuity()).translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹"))

    # Curves of it.

    def rotated(self, rotation: Any) -> Self:
        """The curve in a world that is turned: R q(t). Its rates in the body frame stay, positions turn too.

        `rotation` is a SciPy Rotation, a quaternion in the order of this curve, a (3, 3) matrix or a text by names, as of
        `Keys.in_axes`. `R * curve` says the same from SciPy 1.17 on. Raises ArgumentError for what is no rotation.

        >>> import numpy as np, orispline as ori
        >>> from scipy.spatial.transform import Rotation
        >>> curve, R = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp"), Rotation.from_rotvec([0.3, 0, 0])
        >>> bool(np.allclose(curve.rotated(R).as_matrix(0.5), (R * curve.rotation(0.5)).as_matrix()))
        True
        """
        if rotation is None:
            raise wrong_type("rotation", rotation, "a SciPy Rotation, a quaternion, a matrix or a text by names")
        try:
            return self._turned(rotation_text("rotation", rotation, scalar_first=self._scalar_first), None)
        except ArgumentError as error:  # the library calls it as `Keys.in_axes` does
            error.args = (str(error).replace("world_rotation:", "rotation:", 1), *error.args[1:])
            raise

    def inv(self) -> OrientationCurve:
        """The curve q(t)⁻¹, such as that of the world as the body sees it: its rates are minus those of q in the world frame. It has
        no positions.

        >>> import numpy as np, orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> bool(np.allclose(curve.inv().angular_velocity(0.7), -curve.angular_velocity(0.7, frame="world")))
        True
        """
        return OrientationCurve._inverse_of(self)

    def relative_to(self, other: OrientationCurve) -> OrientationCurve:
        """The curve other(t)⁻¹ q(t): how this body turns as the other one sees it, where both curves are, with exact rates. The body
        frame is that of this curve, and so is its clock; it has no positions. `other.inv() * curve` is the same on the clock of the other.

        Raises ArgumentError for curves without a time in common, and where one has dates and the other has numbers.

        >>> import numpy as np, orispline as ori
        >>> turn = ori.Curve([0, 2], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
        >>> slow = ori.Curve([0, 4], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
        >>> relative = turn.relative_to(slow)
        >>> relative
        ComposedCurve(0 … 2 s, C³)
        >>> bool(np.allclose(relative.angular_velocity(1.0), [0, 0, np.pi / 4]))
        True
        """
        if not isinstance(other, OrientationCurve):
            raise wrong_type("other", other, "a curve")
        return OrientationCurve._product_of(other.inv(), self, self)

    def __mul__(self, other: Any) -> Any:
        """`curve * R` turns the body by a SciPy Rotation: q(t) R, with the rates in its new frame. `a * b` is the curve
        a(t) b(t) where both curves are, on the clock of a."""
        if isinstance(other, OrientationCurve):
            return OrientationCurve._product_of(self, other, self)
        return self._turned(None, inverse_text("rotation", other)) if hasattr(other, "as_quat") else NotImplemented

    def __rmul__(self, other: Any) -> Any:
        return self.rotated(other) if hasattr(other, "as_quat") else NotImplemented

    def _turned(self, world: str | None, body: str | None) -> Self:
        """W q(t) Bᵀ, of rotations by names."""
        raise NotImplementedError

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

    def __eq__(self, other: object) -> bool:
        """Whether both are the same curve: of equal keys, by the same method with its settings and ends, and the same outside; or
        composed of such curves in the same way."""
        return self._made_of() == other._made_of() if isinstance(other, OrientationCurve) else NotImplemented

    def __hash__(self) -> int:
        return hash(self._made_of())

    def _made_of(self) -> tuple[Any, ...]:
        """All that it depends on."""
        return tuple(self.__reduce__())

    def _quaternions(self, t: Any) -> NDArray[np.float64]:
        return self._at(ORIENTATION, bare(t), "body", None, np.float64, 1)

    def _quaternions_at(self, seconds: Array) -> Array:
        """The same at times of the library."""
        result = np.empty((*seconds.shape, 4))
        self._core.many(ORIENTATION, seconds.reshape(-1), result.reshape(-1, 4), False, self._beyond, 1)
        return result

    # How it reads its arguments. A `CurveStack` does so by its first curve.

    def _grid_wanted(self, rate: Any, count: int | None, times: Any, start: Any, end: Any, include_end: bool,
                     derivatives: int) -> Any:
        """The grid of the samples, None where their times are given."""
        if sum(given is not None for given in (rate, count, times)) != 1:
            raise ArgumentError("sample: wanted one of rate, count and times")
        if np.ndim(rate) > 0:
            raise ArgumentError("rate: found an array, wanted a number of samples per second, or times= for the times of the samples")
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
        if isinstance(t, float) and out is None and dtype is np.float64 and threads is ALONE and (found := self._of_one_time):
            one, beyond = found
            return one(what, t, world, beyond)  # type: ignore[no-any-return]
        if is_labelled(t):
            return self._labelled(what, t, frame, out, dtype, threads)  # type: ignore[no-any-return]
        seconds = self._asked("t", t)
        result = output("out", out, (*seconds.shape, 4 if what == ORIENTATION else 3), dtype, seconds)
        self._core.many(what, seconds.reshape(-1), result.reshape(-1, result.shape[-1]), world, self._beyond,
                        thread_count(threads))
        return as_given(t, result)  # type: ignore[no-any-return]

    def _labelled(self, what: int, t: Any, frame: str, out: Any, dtype: Any, threads: int) -> Any:
        """At the times of a DataArray, as one."""
        if out is not None:
            raise ArgumentError("out: found it with a DataArray of xarray, wanted none: the result is one")

        def values(times: Any) -> Any:
            rows = self._at(what, times, frame, None, dtype, threads)
            return rows[..., [3, 0, 1, 2]] if what == ORIENTATION and self._scalar_first else rows
        return labelled(QUANTITIES[what], t, values, "wxyz" if self._scalar_first else "xyzw", frame, dtype)

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
