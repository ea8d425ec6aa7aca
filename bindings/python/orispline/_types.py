# SPDX-License-Identifier: Apache-2.0
"""Types of functions of time, for readers of type hints: one time gives one vector, an array of times an array of them."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Callable

if TYPE_CHECKING:
    import datetime
    import fractions
    from typing import Literal, Protocol, TypeVar, Union, overload

    import numpy as np
    from numpy.typing import ArrayLike, DTypeLike, NDArray

    Time = Union[float, np.floating[Any], np.integer[Any], np.datetime64, np.timedelta64, datetime.date, datetime.timedelta]  # one
    Number = Union[float, str, fractions.Fraction]
    Frame = Literal["body", "world"]
    Signs = Literal["shortest", "as-given"]
    Basis = Literal["bernstein", "power", "bezier"]
    TimeUnit = Literal["s", "ms", "us", "ns"]
    AngleUnit = Literal["rad", "deg", "mrad", "arcsec"]
    Extrapolate = Literal["hold", "error", "nan", "rate", "segment", "leave-out"]
    Side = Literal["right", "left"]
    Vector = np.ndarray[tuple[int], np.dtype[np.float64]]  # (3,) or (4,)
    Vectors = np.ndarray[tuple[int, int], np.dtype[np.float64]]  # one for each joint
    Real = TypeVar("Real", bound=np.floating[Any])
    One = TypeVar("One", covariant=True)
    Out = TypeVar("Out", bound=NDArray[Any])

    class HasMethod(Protocol):
        """A curve, blending functions of one's own, and what tasks find."""

        @property
        def method(self) -> str: ...

    Method = Union[str, HasMethod]

    class Quantity(Protocol[One]):
        """Of scalar or array times, at which it is `One` or an array of one axis more."""

        @overload
        def __call__(self, t: Time, *, out: None = None, threads: int = ...) -> One: ...
        @overload
        def __call__(self, t: ArrayLike, *, out: None = None, threads: int = ...) -> NDArray[np.float64]: ...
        @overload
        def __call__(self, t: ArrayLike, *, out: None = None, dtype: type[Real] | np.dtype[Real], threads: int = ...) -> NDArray[Real]: ...
        @overload
        def __call__(self, t: ArrayLike, *, out: None = None, dtype: DTypeLike, threads: int = ...) -> NDArray[Any]: ...
        @overload
        def __call__(self, t: ArrayLike, *, out: Out, dtype: DTypeLike = ..., threads: int = ...) -> Out: ...

    class Rate(Protocol[One]):
        """The same of a rate, in the body or the world frame."""

        @overload
        def __call__(self, t: Time, frame: Frame = ..., out: None = None, *, threads: int = ...) -> One: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame = ..., out: None = None, *, threads: int = ...) -> NDArray[np.float64]: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame = ..., out: None = None, *, dtype: type[Real] | np.dtype[Real],
                     threads: int = ...) -> NDArray[Real]: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame = ..., out: None = None, *, dtype: DTypeLike,
                     threads: int = ...) -> NDArray[Any]: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame = ..., *, out: Out, dtype: DTypeLike = ..., threads: int = ...) -> Out: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame, out: Out, *, dtype: DTypeLike = ..., threads: int = ...) -> Out: ...

    class BakedQuantity(Protocol):
        """Of a baked curve, which has a dtype of its own."""

        @overload
        def __call__(self, t: Time, *, out: None = None) -> np.ndarray[tuple[int], np.dtype[Any]]: ...
        @overload
        def __call__(self, t: ArrayLike, *, out: None = None) -> NDArray[Any]: ...
        @overload
        def __call__(self, t: ArrayLike, *, out: Out) -> Out: ...

    class BakedRate(Protocol):
        """The same of a rate, in the body or the world frame."""

        @overload
        def __call__(self, t: Time, frame: Frame = ..., out: None = None) -> np.ndarray[tuple[int], np.dtype[Any]]: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame = ..., out: None = None) -> NDArray[Any]: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame = ..., *, out: Out) -> Out: ...
        @overload
        def __call__(self, t: ArrayLike, frame: Frame, out: Out) -> Out: ...


def quantity(method: Callable[..., Any]) -> Quantity[Vector]:
    """Says to type checkers that a method is a quantity of a curve."""
    return method


def rate(method: Callable[..., Any]) -> Rate[Vector]:
    """Says to them that a method is a rate of a curve."""
    return method


def stacked_quantity(method: Callable[..., Any]) -> Quantity[Vectors]:
    """Says to them that a method is a quantity of a stack of curves."""
    return method


def stacked_rate(method: Callable[..., Any]) -> Rate[Vectors]:
    """Says to them that a method is a rate of a stack of curves."""
    return method


def baked_quantity(method: Callable[..., Any]) -> BakedQuantity:
    """Says to them that a method is a quantity of a baked curve."""
    return method


def baked_rate(method: Callable[..., Any]) -> BakedRate:
    """Says to them that a method is a rate of a baked curve."""
    return method
