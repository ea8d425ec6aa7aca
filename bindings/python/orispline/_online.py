# SPDX-License-Identifier: Apache-2.0
"""Curves whose keys arrive one by one."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, overload

import numpy as np

from . import _core
from ._arrays import Array, array_of, as_given, numbers
from ._checks import flag, index_of, real
from ._clock import Clock, times_of_keys
from ._errors import ArgumentError
from ._forms import quaternions
from ._keys import SIGNS
from ._methods import method_text
from ._samples import Motion

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._types import Method, Signs, Time, TimeUnit, Vector


class OnlineCurve:
    """A curve whose keys arrive one by one, for loops that cannot wait for the last one.

    A segment is final once the keys that it depends on are here: `look_ahead` of them behind its end. Final segments
    never change, and between the ends of `available` orientations and rates are those of the `Curve` through all keys, bit
    for bit. Before and after it the end is held at rest; without keys, and at a NaN time, all is NaN.

    A lock is around every call: threads may append and ask at the same time.

    Parameters
    ----------
    method : str, Blending or Curve
        A local method, as of `Curve`.
    capacity : int
        How many ends of final segments stay available, the newest: 2 to 1000000.
    ends, start_rate, end_rate, **settings
        As of `Curve`. The rule of the start is used at the first key, that of the end by `finish()`. A setting `None` comes
        with the keys: `append(..., tension=0.4)`.
    signs, scalar_first, time_unit
        As of `Keys`.

    Raises
    ------
    ArgumentError
        A method that depends on all keys, a capacity out of range, a setting or rule that there is not.

    Examples
    --------
    >>> import orispline as ori
    >>> curve = ori.OnlineCurve("slerp", capacity=8)
    >>> for t, q in ((0, [0, 0, 0, 1]), (2, [0, 0, 0.6, 0.8])):
    ...     curve.append(t, q)
    >>> curve.available
    (0.0, 2.0)
    >>> curve.motion(1.0).angular_velocity.round(6).tolist()
    [0.0, 0.0, 0.643501]
    """

    __slots__ = ("_clock", "_core", "_last", "_lock", "_method", "_scalar_first", "_time_unit")

    def __init__(self, method: Method = "timed-c2", capacity: int = 64, *, ends: str | tuple[str, str] | None = None,
                 start_rate: Any = None, end_rate: Any = None, signs: Signs = "shortest", scalar_first: bool = False,
                 time_unit: TimeUnit | None = None, **settings: Any) -> None:
        index_of("signs", signs, SIGNS)
        if isinstance(capacity, bool) or not isinstance(capacity, (int, np.integer)) or not 0 <= capacity < 2**63:
            raise ArgumentError(f"capacity: found {capacity!r}, wanted a whole number of keys")
        with_keys = [name for name, value in settings.items() if value is None]
        stated = {name: value for name, value in settings.items() if value is not None}
        text = method_text(method, ends, start_rate, end_rate, False, None, stated)
        self._core = _core.OnlineCurve(text, with_keys, int(capacity), signs)
        import threading
        self._lock = threading.Lock()
        self._clock: Clock | None = None
        self._last = -np.inf  # [s], of the last key
        self._method, self._scalar_first, self._time_unit = text, flag("scalar_first", scalar_first), time_unit

    def append(self, t: Any, q: Any, position: Any = None, *, angular_velocity: Any = None, angular_acceleration: Any = None,
               angular_jerk: Any = None, inner_leaving: Any = None, inner_arriving: Any = None, **settings: float) -> None:
        """Takes the next key, at a time after the last one's: a quaternion, a matrix or a SciPy Rotation, body to world, its
        position [m] and its rates in the body frame, its inner quaternions, and the settings that come with the keys.

        Raises `DataError`, with `key`, for a key that `Keys` refuses, and leaves the curve as it was.
        """
        if np.ndim(t) != 0:
            raise ArgumentError("t: found an array, wanted the time of one key")
        if hasattr(q, "as_quat"):
            q = q.as_quat()
            first = False
        else:
            first = self._scalar_first
        row = quaternions("q", array_of("q", q)[None], scalar_first=first)[0]
        p, w, a, j = [None if vector is None else numbers(name, vector, (3,)) for name, vector in
                      (("position", position), ("angular_velocity", angular_velocity),
                       ("angular_acceleration", angular_acceleration), ("angular_jerk", angular_jerk))]
        leaving, arriving = [
            None if one is None else quaternions(name, array_of(name, one)[None], scalar_first=self._scalar_first)[0]
            for name, one in (("inner_leaving", inner_leaving), ("inner_arriving", inner_arriving))]
        stated = {name: real(name, value) for name, value in settings.items()}
        with self._lock:
            if self._clock is None:
                seconds, clock = times_of_keys(array_of("t", t)[None], self._time_unit)
                time = float(seconds[0])
            else:
                clock = self._clock
                time = float(clock.seconds("t", t))
                clock.check_after(len(self._core), time, self._last)
            self._core.append(time, row, p, w, a, j, leaving, arriving, stated)
            self._clock, self._last = clock, time

    def finish(self) -> None:
        """Says that the last key is the end: by the end rule the last segment becomes final too.

        Raises `DataError` without keys, or with fewer than the method takes, and leaves the curve as it was.
        """
        with self._lock:
            self._core.finish()

    def reset(self) -> None:
        """Forgets all keys, not the method: a new curve."""
        with self._lock:
            self._core.reset()
            self._clock = None

    @property
    def available(self) -> tuple[Any, Any] | None:
        """The first and the last time between which the curve is final and kept; None before the first key."""
        with self._lock:
            domain, clock = self._core.available(), self._clock
        if domain is None or clock is None:
            return None
        return clock.ends(domain)

    @property
    def look_ahead(self) -> int:
        """How many keys behind the end of a segment must have come before it is final."""
        return int(self._core.look_ahead)

    def __len__(self) -> int:
        """Keys taken since the beginning, or since `reset()`."""
        with self._lock:
            return len(self._core)

    @overload
    def __call__(self, t: Time) -> Vector: ...
    @overload
    def __call__(self, t: ArrayLike) -> Array: ...

    def __call__(self, t: Any) -> Any:
        """(..., 4) unit quaternions, x, y, z, w, or w, x, y, z with `scalar_first`."""
        with self._lock:
            seconds = self._seconds(t)
            q = np.empty((*seconds.shape, 4))
            self._core.fill(seconds.reshape(-1), q.reshape(-1, 4))
        return as_given(t, self._ordered(q))

    def motion(self, t: Time) -> Motion:
        """Orientation and position with their rates at one time; angular rates in the body frame."""
        if np.asarray(t).ndim:
            raise ArgumentError("t: found an array, wanted one time")
        q, again, rates, linear = np.empty((1, 4)), np.empty((1, 4)), np.empty((3, 1, 3)), np.empty((3, 1, 3))
        with self._lock:
            seconds = self._seconds(t).reshape(1)
            has_positions = self._core.has_positions
            self._core.fill(seconds, q)  # by itself: rates beside it may cost the last bit
            self._core.fill(seconds, again, *rates, *(linear if has_positions else ()))
        return Motion(self._ordered(q[0]), *rates[:, 0], *(linear[:, 0] if has_positions else ()))

    def _seconds(self, t: Any) -> Array:
        return (self._clock or Clock()).seconds("t", t)

    def _ordered(self, q: Array) -> Array:
        return q[..., [3, 0, 1, 2]] if self._scalar_first else q

    def __repr__(self) -> str:
        with self._lock:
            count, domain, clock = len(self._core), self._core.available(), self._clock
        final = f", final {clock.span(np.array(domain))}" if domain is not None and clock is not None else ""
        return f"OnlineCurve({self._method!r}, {count} key{'' if count == 1 else 's'}{final})"

    def __reduce__(self) -> Any:
        raise TypeError("an OnlineCurve cannot be pickled or copied; append the same keys to another one")
