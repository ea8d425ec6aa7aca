# SPDX-License-Identifier: Apache-2.0
"""`RotationSpline` and `Slerp` as SciPy has them: the same calls, and the numbers that SciPy's iteration goes to."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

from ._arrays import Array, as_given, numbers
from ._curve import Curve
from ._evaluation import ACCELERATION, ALONE, JERK, ORIENTATION, VELOCITY
from ._errors import ArgumentError, DataError

if TYPE_CHECKING:
    from typing import Literal

    from numpy.typing import ArrayLike
    from scipy.spatial.transform import Rotation

    from ._types import Extrapolate, Time, Vector

ORDERS = (ORIENTATION, VELOCITY, ACCELERATION, JERK)


class _Twin:
    """A curve with the interface that SciPy gives its own."""

    __slots__ = ("_curve", "_rotation_of", "_rotations", "_times")

    def __init__(self, times: Any, rotations: Any, method: str, extrapolate: Extrapolate, **options: Any) -> None:
        from scipy.spatial.transform import Rotation
        if not isinstance(rotations, Rotation):
            raise TypeError(f"rotations: found {type(rotations).__name__}, wanted a SciPy Rotation")
        quaternions = rotations.as_quat()
        if quaternions.ndim != 2 or len(quaternions) < 2:
            raise ArgumentError(f"rotations: found the shape {quaternions.shape[:-1]}, wanted (n,) with two of them or more")
        self._times: Array = numbers("times", times, (None,)).copy()
        if len(self._times) != len(quaternions):
            raise DataError(f"rotations: found {len(quaternions)}, wanted one for each of the {len(self._times)} times")
        self._times.flags.writeable = False
        self._rotations = rotations
        self._rotation_of = Rotation
        self._curve = Curve(self._times, quaternions, method, extrapolate=extrapolate, **options)

    @property
    def times(self) -> Array:
        """(n,) times of the keys."""
        return self._times

    @property
    def rotations(self) -> Rotation:
        """The keys, a SciPy Rotation."""
        return self._rotations

    def __repr__(self) -> str:
        return f"{type(self).__name__}({len(self._times)} rotations, {self._curve._clock.span(self._times)})"

    @overload
    def __call__(self, times: ArrayLike, order: Literal[0] = 0) -> Rotation: ...
    @overload
    def __call__(self, times: Time, order: Literal[1, 2, 3]) -> Vector: ...
    @overload
    def __call__(self, times: ArrayLike, order: Literal[1, 2, 3]) -> Array: ...

    def __call__(self, times: Any, order: int = 0) -> Any:
        """At times (a scalar, or one dimension): of order 0 a SciPy Rotation, of 1, 2 and 3 the angular velocity [rad/s],
        acceleration [rad/s²] and jerk [rad/s³] in the body frame, (3,) or (k, 3). A NaN time gives NaN."""
        if isinstance(order, (bool, np.ndarray)) or order not in (0, 1, 2, 3):
            raise ArgumentError(f"order: found {order!r}, wanted 0, 1, 2 or 3")
        t = times
        if not isinstance(t, float):  # which needs no look
            t = self._curve._clock.seconds("times", times)
            if t.ndim > 1:
                raise ArgumentError(f"times: found the shape {t.shape}, wanted a time or (k,)")
            t = t if t.ndim else float(t)
        rows = self._curve._at(ORDERS[order], t, "body", None, np.float64, ALONE)
        return self._rotation_of(rows, normalize=False, copy=False) if order == 0 else as_given(times, rows)


class RotationSpline(_Twin):
    """SciPy's `RotationSpline`, faster: the same call, and the same numbers to within 1e-9 rad, 1e-9 rad/s and
    1e-8 rad/s² where SciPy's iteration converges. It ends after `MAX_ITER` = 10 rounds, which is too early where keys turn by a radian
    a step; here the equations are solved to 1e-12.

    The angular acceleration is continuous. Before the first and after the last key the cubic of the end segment goes
    on. The method is `rotation-spline` of `orispline.Curve`.

    Parameters
    ----------
    times : (n,) array
        Strictly increasing [s].
    rotations : SciPy Rotation
        n of them, two at least, body to world.
    ends : str or (str, str), optional
        End rule for both ends, or for each. SciPy's is `"secant"`: an end has the rate of its step.
    start_rate, end_rate : (3,) arrays, optional
        Angular velocity at an end [rad/s], body frame.
    extrapolate : {"segment", "rate", "hold", "nan", "error"}
        What a time outside gets, as of `orispline.Curve`.

    Raises
    ------
    TypeError
        Rotations that are no SciPy Rotation.
    ValueError
        Lengths that differ, times that do not increase, one rotation, another shape; as `DataError` or `ArgumentError`.
    ConvergenceError
        Keys so far apart that the equations of the spline have no solution that could be found.

    Examples
    --------
    >>> from scipy.spatial.transform import Rotation
    >>> import orispline as ori
    >>> spline = ori.RotationSpline([0, 1, 3], Rotation.from_rotvec([[0, 0, 0], [0, 0, 1], [0, 0, 1.5]]))
    >>> spline(1.0).as_rotvec().round(12).tolist()
    [0.0, 0.0, 1.0]
    >>> spline([0.5, 2], 1).shape
    (2, 3)
    """

    __slots__ = ()

    def __init__(self, times: Any, rotations: Any, *, ends: str | tuple[str, str] | None = None, start_rate: Any = None,
                 end_rate: Any = None, extrapolate: Extrapolate = "segment") -> None:
        super().__init__(times, rotations, "rotation-spline", extrapolate, ends=ends, start_rate=start_rate, end_rate=end_rate)


class Slerp(_Twin):
    """SciPy's `Slerp`, faster: from key to key about a fixed axis at a constant rate.

    A time outside is an error, as in SciPy, unless `extrapolate` says otherwise. Beyond SciPy it takes the `order` of a
    derivative. The method is `slerp` of `orispline.Curve`.

    Parameters
    ----------
    times : (n,) array
        Strictly increasing [s].
    rotations : SciPy Rotation
        n of them, two at least, body to world.
    extrapolate : {"error", "segment", "rate", "hold", "nan"}
        What a time outside gets, as of `orispline.Curve`.

    Raises
    ------
    TypeError
        Rotations that are no SciPy Rotation.
    ValueError
        Lengths that differ, times that do not increase, one rotation, another shape; as `DataError` or `ArgumentError`.

    Examples
    --------
    >>> from scipy.spatial.transform import Rotation
    >>> import orispline as ori
    >>> slerp = ori.Slerp([0, 2], Rotation.from_rotvec([[0, 0, 0], [0, 0, 1]]))
    >>> slerp(0.5).as_rotvec().round(12).tolist()
    [0.0, 0.0, 0.25]
    >>> slerp(0.5, 1).round(12).tolist()
    [0.0, 0.0, 0.5]
    """

    __slots__ = ()

    def __init__(self, times: Any, rotations: Any, *, extrapolate: Extrapolate = "error") -> None:
        super().__init__(times, rotations, "slerp", extrapolate)

    @property
    def rotations(self) -> Rotation:
        """Where the segments begin, at all keys but the last, as SciPy has it."""
        return self._rotations[:-1]
