# SPDX-License-Identifier: Apache-2.0
"""Curves that are made of curves."""
from __future__ import annotations

from typing import Any

import numpy as np

from . import _core
from ._arrays import array_of, as_given
from ._checks import wrong_type
from ._errors import ArgumentError
from ._evaluation import OrientationCurve
from ._forms import product_of, quaternions


class ComposedCurve(OrientationCurve):
    """The inverse of a curve, or the product of two, with exact angular velocity, acceleration and jerk: what `curve.inv()`,
    `curve.relative_to(other)` and `a * b` give.

    It is where both curves are, and has the knots of both. It does all that a `Curve` does but for what keys and a method are
    needed for. `Keys(composed.times, composed(composed.times))` are keys of it.

    Examples
    --------
    >>> import numpy as np, orispline as ori
    >>> a = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> b = ori.Curve([0, 2, 4], [[0, 0, 0, 1], [0.6, 0, 0, 0.8], [1, 0, 0, 0]])
    >>> (a * b).times.tolist()
    [0.0, 1.0, 2.0, 3.0]
    >>> bool(np.allclose((a * b).as_matrix(0.5), a.as_matrix(0.5) @ b.as_matrix(0.5)))
    True
    """

    __slots__ = ("_factors",)
    _factors: tuple[OrientationCurve, ...]  # one, of which it is the inverse, or two

    def __init__(self, *given: Any, **options: Any) -> None:
        raise TypeError("ComposedCurve: wanted it made of curves, such as curve.inv(), curve.relative_to(other) or a * b")

    @classmethod
    def _of(cls, factors: tuple[OrientationCurve, ...], core: Any, like: OrientationCurve) -> ComposedCurve:
        curve = cls.__new__(cls)
        curve._factors = factors
        curve._set(like._keys, core, like._extrapolate)
        return curve

    @property
    def times(self) -> np.ndarray[Any, Any]:
        """The times of its knots, which are those of the curves that it is made of."""
        return self._clock.back(self._core.knots)

    def _turned(self, world: str | None, body: str | None) -> ComposedCurve:
        if len(self._factors) == 1:
            return inverse(self._factors[0]._turned(body, world))  # type: ignore[return-value]
        left, right = self._factors
        return product(left if world is None else left._turned(world, None), right if body is None else right._turned(None, body), self)

    def __repr__(self) -> str:
        return f"ComposedCurve({self._clock.span(np.array(self._core.domain))}, {self._order})"

    def __reduce__(self) -> Any:
        if len(self._factors) == 1:
            return inverse, self._factors
        return product, (*self._factors, self._factors[self._keys is not self._factors[0]._keys])


def inverse(curve: OrientationCurve) -> OrientationCurve:
    """The curve q(t)⁻¹: of an inverse what it is of, of a product the product of the inverses."""
    if not isinstance(curve, ComposedCurve):
        return ComposedCurve._of((curve,), _core.Curve(inverse_of=curve._core), curve)
    if len(curve._factors) == 1:
        return curve._factors[0]
    right, left = (factor.inv() for factor in curve._factors)
    return product(left, right, curve)


def product(left: OrientationCurve, right: OrientationCurve, like: OrientationCurve) -> ComposedCurve:
    """The curve left(t) right(t), on the clock of `like`."""
    _check_alike(left, right)
    if like._clock.is_calendar and max(side.domain[0] for side in (left, right)) > min(side.domain[1] for side in (left, right)):
        spans = [side._clock.span(np.array(side._core.domain)) for side in (left, right)]
        raise ArgumentError(f"found a curve of {spans[0]} and one of {spans[1]}, wanted two curves with a time in common")
    offsets = [_offset(like, side) for side in (left, right)]
    return ComposedCurve._of((left, right), _core.Curve(left._core, right._core, like._core, *offsets), like)


def _check_alike(left: OrientationCurve, right: OrientationCurve) -> None:
    """That both have a time in the same sense."""
    if left._clock.kind != right._clock.kind:
        raise ArgumentError(f"found a curve whose times are {left._clock.word} and one whose times are {right._clock.word}, wanted the same of both")


def _offset(like: OrientationCurve, side: OrientationCurve) -> float:
    """The time of one clock [s] at 0 of the other."""
    return float(like._keys.epoch - side._keys.epoch)


OrientationCurve._inverse_of, OrientationCurve._product_of = staticmethod(inverse), staticmethod(product)


def angle_between(a: Any, b: Any, t: Any) -> Any:
    """The angle [rad] of the turn from one orientation to the other over time, 0 to π: a float for one time, else an array of the
    shape of `t`.

    `a` is a curve, `b` another one or one fixed rotation (a SciPy Rotation, a quaternion in the order of `a`, or a matrix). Outside
    its domain each curve is what its `extrapolate` says. Times are those of the clock of `a`. Raises ArgumentError where one has dates
    and the other has numbers.

    >>> import numpy as np, orispline as ori
    >>> fast = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
    >>> slow = ori.Curve([0, 2], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp")
    >>> bool(np.allclose(ori.angle_between(fast, slow, [0.0, 0.5, 1.0]), [0, np.pi / 4, np.pi / 2]))
    True
    """
    if not isinstance(a, OrientationCurve):
        raise wrong_type("a", a, "a curve")
    times = array_of("t", t)
    if not isinstance(b, OrientationCurve):
        is_scipy = hasattr(b, "as_quat")
        given = np.asarray(b.as_quat() if is_scipy else b)
        q = quaternions("b", given[None] if given.shape in ((4,), (3, 3)) else given, scalar_first=a._scalar_first and not is_scipy)
        if len(q) != 1:
            raise ArgumentError(f"b: found {len(q)} rotations, wanted one, or a curve")
        return as_given(t, _angle(a._quaternions(times), q[0]))
    _check_alike(a, b)
    if a._clock.kind:
        return as_given(t, _angle(a._quaternions(times), b._quaternions(times)))
    seconds = a._asked("t", times)
    return as_given(t, _angle(a._quaternions_at(seconds), b._quaternions_at(seconds + _offset(a, b))))


def _angle(p: Any, q: Any) -> Any:
    """By both halves, so that it is right near 0 and near π."""
    turn = product_of(p * [-1.0, -1.0, -1.0, 1.0], q)
    angle = 2.0 * np.arctan2(np.linalg.norm(turn[..., :3], axis=-1), np.abs(turn[..., 3]))
    return angle if angle.ndim else float(angle)
