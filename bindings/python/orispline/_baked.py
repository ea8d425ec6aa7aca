# SPDX-License-Identifier: Apache-2.0
"""Curves turned into polynomials."""
from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import array_of, as_given, output
from ._checks import in_world
from ._clock import Clock
from ._errors import ArgumentError
from ._orienting import Orienting
from ._types import baked_quantity, baked_rate


class BakedCurve(Orienting):
    """A curve turned into polynomials, to be stored and replayed: `Curve.bake` makes one.

    It takes times as its curve does, and gives orientations within the tolerance of the curve's own, faster than most
    curves do. Its rates are the exact ones of these orientations; they are farther from the curve's. Outside its domain it
    holds the end orientation, at rest. It never changes, threads may share it, and `pickle` stores it: what is loaded gives
    the same bits.

    Examples
    --------
    >>> import pickle, orispline as ori
    >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> baked = pickle.loads(pickle.dumps(curve.bake(1e-9)))
    >>> baked([0.5, 1.0]).round(6).tolist()[1]
    [0.0, 0.0, 0.6, 0.8]
    """

    __slots__ = ("_clock", "_core", "_dtype", "_scalar_first")
    _clock: Clock
    _core: Any
    _dtype: np.dtype[Any]
    _scalar_first: bool

    def __init__(self) -> None:
        raise TypeError("found BakedCurve(), wanted curve.bake(tolerance)")

    @property
    def domain(self) -> tuple[Any, Any]:
        """The first and the last time."""
        return self._clock.ends(self._core.domain)

    @property
    def dtype(self) -> np.dtype[Any]:
        """float64 or float32, of its polynomials and of what it gives."""
        return self._dtype

    @property
    def largest_difference(self) -> float:
        """The largest difference from the curve that was found while baking [rad]."""
        return float(self._core.largest_difference)

    @property
    def nbytes(self) -> int:
        """The size of its pieces in memory [bytes]."""
        return int(self._core.nbytes)

    def __len__(self) -> int:
        """The number of its pieces."""
        return len(self._core)

    @baked_quantity
    def __call__(self, t: Any, *, out: Any = None) -> NDArray[Any]:
        """(..., 4) orientations, in the order of the curve's keys."""
        if not self._scalar_first:
            return self._at(0, t, "body", out)
        q = self._at(0, array_of("t", t), "body", None)
        turned = output("out", out, q.shape, self._dtype)
        turned[...] = q[..., [3, 0, 1, 2]]
        return as_given(t, turned)  # type: ignore[no-any-return]

    @baked_rate
    def angular_velocity(self, t: Any, frame: str = "body", out: Any = None) -> NDArray[Any]:
        """(..., 3) [rad/s]."""
        return self._at(1, t, frame, out)

    @baked_rate
    def angular_acceleration(self, t: Any, frame: str = "body", out: Any = None) -> NDArray[Any]:
        """(..., 3) [rad/s²]."""
        return self._at(2, t, frame, out)

    @baked_rate
    def angular_jerk(self, t: Any, frame: str = "body", out: Any = None) -> NDArray[Any]:
        """(..., 3) [rad/s³]."""
        return self._at(3, t, frame, out)

    def _quaternions(self, t: Any) -> NDArray[np.float64]:
        return np.asarray(self._at(0, t, "body", None), np.float64)

    def _at(self, order: int, t: Any, frame: str, out: Any) -> NDArray[Any]:
        world = in_world(frame)
        seconds = self._clock.seconds("t", t)
        result = output("out", out, (*seconds.shape, 3 if order else 4), self._dtype, seconds)
        self._core.many(order, seconds.reshape(-1), result.reshape(-1, result.shape[-1]), world)
        return as_given(t, result)  # type: ignore[no-any-return]

    def __repr__(self) -> str:
        count = len(self)
        return (f"BakedCurve({self._clock.span(np.array(self._core.domain))}, {self._dtype}, "
                f"{count} piece{'' if count == 1 else 's'}, {self.largest_difference:.2g} rad off at most)")

    def __reduce__(self) -> Any:
        return _restored, (*self._core.parts, self._clock, self._scalar_first)


def baked(core: Any, clock: Clock, scalar_first: bool, tolerance: float, dtype: Any) -> BakedCurve:
    """The curve of a core."""
    kind = output("tolerance", None, (), dtype).dtype
    if np.ndim(tolerance) != 0 or np.asarray(tolerance).dtype.kind not in "fiu":
        raise ArgumentError(f"tolerance: found {tolerance!r}, wanted a number of radians")
    bake = core.bake64 if kind == np.float64 else core.bake32
    return _made(bake(float(tolerance)), kind, clock, scalar_first)


def _made(core: Any, dtype: np.dtype[Any], clock: Clock, scalar_first: bool) -> BakedCurve:
    curve = BakedCurve.__new__(BakedCurve)
    curve._core, curve._dtype, curve._clock, curve._scalar_first = core, dtype, clock, scalar_first
    return curve


def _restored(ends: Any, coefficients: NDArray[Any], scales: Any, largest_difference: float, clock: Clock,
              scalar_first: bool) -> BakedCurve:
    kind = _core.BakedCurve64 if coefficients.dtype == np.float64 else _core.BakedCurve32
    return _made(kind(ends, coefficients, scales, largest_difference), coefficients.dtype, clock, scalar_first)
