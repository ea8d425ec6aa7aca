# SPDX-License-Identifier: Apache-2.0
"""What a curve is worth: the part of `Curve` that measures it."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Array, numbers, quaternions
from ._checks import real
from ._errors import ArgumentError, DataError
from ._warnings import tell

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._baked import BakedCurve
    from ._clock import Clock
    from ._measures import DistanceStatistics, Energies, HandleTurn, Peaks
    from ._types import Rate, Time, Vector


def checked_inertia(inertia: Any) -> Array:
    """(3, 3) tensor of a tensor or of three principal moments [kg m²]."""
    shape = np.shape(inertia)
    matrix = numbers("inertia", inertia, (3,) if len(shape) == 1 else (3, 3))
    matrix = np.diag(matrix) if matrix.ndim == 1 else matrix
    tell(_core.check_inertia(matrix))
    return matrix


class CurveAnalysis:
    """The methods of `Curve` that measure it. An `inertia` is a body's tensor about its centre of mass [kg m²], body frame:
    (3, 3), symmetric and positive definite, or its three principal moments."""

    __slots__ = ()

    if TYPE_CHECKING:
        _core: Any
        _clock: Clock
        _scalar_first: bool

        def angular_velocity(self, t: Any) -> NDArray[Any]: ...

        def angular_acceleration(self, t: Any) -> NDArray[Any]: ...

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
        """The order to which it is continuous in time at its keys, measured: 2 is C², 3 the most that is looked for. A loop
        is measured where it closes too.

        >>> import orispline as ori
        >>> ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp").continuity()
        0
        """
        return int(self._core.continuity())

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
        return Energies(**self._core.energies(None if inertia is None else checked_inertia(inertia)))

    def peaks(self, inertia: Any = None) -> Peaks:
        """The largest |ω|, |α| and, with an inertia, |torque|, and the first times when they are reached. Errors as of
        `energies`.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "slerp")
        >>> peak = curve.peaks().angular_velocity
        >>> round(peak.value, 12), peak.time
        (1.287002217587, 0.0)
        """
        from ._measures import Peak, Peaks
        found = self._core.peaks(None if inertia is None else checked_inertia(inertia))
        return Peaks(**{name: Peak(value, self._time(time)) for name, (value, time) in found.items()})

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
        return angles if angles.ndim else float(angles)

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
        return self._clock.back(seconds) if seconds.ndim else self._time(float(seconds))

    @overload
    def band(self, t: Time, share: float = ...) -> float: ...
    @overload
    def band(self, t: ArrayLike, share: float = ...) -> Array: ...

    def band(self, t: Any, share: float = 0.9) -> Any:
        """The angle [rad] about a curve of the method `measured` that is meant to hold this share of the true motion, at times
        which are held to the curve's domain: a float for one time, else an array of their shape. Infinite where the keys say
        nothing. It takes as long as making the curve.

        Raises ArgumentError for the curve of another method and for a share that is not between 0 and 1.

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
        return bands if bands.ndim else float(bands)

    def torque(self, t: Any, inertia: Any) -> NDArray[np.float64]:
        """(..., 3) J α + ω × J ω [N m], body frame: what turns a free rigid body so. Errors as of `energies`.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> curve.torque([0.5, 1.5], [1.0, 2.0, 2.5]).shape
        (2, 3)
        """
        tensor = checked_inertia(inertia)
        rates = self.angular_velocity(t)
        result = np.empty(rates.shape)
        _core.torques(rates.reshape(-1, 3), self.angular_acceleration(t).reshape(-1, 3), tensor, result.reshape(-1, 3))
        return result

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
        reference = _core.Keys(seconds, rows, None, None, None, None, settings={}, signs="as-given")
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
        _check_rising(seconds)
        bad = ~np.isfinite(rows).all(axis=1)
        if bad.any():
            raise DataError(f"rates: found {rows[bad][0].tolist()} at index {int(bad.argmax())}, wanted finite numbers")
        return self._statistics(self._core.rate_error(seconds, rows))

    def leave_out(self) -> DistanceStatistics:
        """How far the method misses keys that it is not given [rad]: each inner key is left out once, with every 4th. It
        estimates the error where nothing denser is known, and is not fit for choosing a method.

        Raises DataError for fewer than 3 keys, and ArgumentError for a setting with a value for each key.

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

    def bake(self, tolerance: float, *, dtype: Any = np.float64) -> BakedCurve:
        """The curve turned into polynomials, to be stored and replayed: no orientation is farther from the curve's own than
        `tolerance` [rad]. float32 is smaller, for tolerances from 1e-6 on. Ctrl-C stops it.

        Raises ArgumentError for a tolerance below 1e-13 (1e-6), and for one that cannot be reached, with the key.

        >>> import orispline as ori
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> curve.bake(1e-9).largest_difference < 1e-9
        True
        """
        from ._baked import baked
        return baked(self._core, self._clock, self._scalar_first, tolerance, dtype)

    def _time(self, seconds: float) -> Any:
        time = self._clock.back(np.array([seconds]))[0]
        return time if self._clock.is_calendar else time.item()

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


def _check_rising(seconds: Array) -> None:
    bad = ~np.isfinite(seconds)
    if bad.any():
        raise DataError(f"times: found {seconds[bad][0]} at index {int(bad.argmax())}, wanted finite times")
    falls = np.diff(seconds) < 0
    if falls.any():
        at = int(falls.argmax())
        raise DataError(f"times: found {seconds[at + 1]:.17g} after {seconds[at]:.17g} at index {at + 1}, wanted times that do "
                        "not decrease")
