# SPDX-License-Identifier: Apache-2.0
"""Curves through keyframes, and their samples."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import output, sample_rows
from ._checks import check_number, flag, thread_count
from ._curve_analysis import CurveAnalysis
from ._errors import ArgumentError
from ._keys import Keys, _span
from ._pictures import CurvePictures
from ._samples import Motion, Samples, samples_of
from ._texts import rate_text
from ._types import quantity, rate

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation

    from ._types import Frame, Side, Time

BEYOND = tuple(_core.extrapolations())
FRAMES = ("body", "world")
SIDES = ("right", "left")
ORIENTATION, VELOCITY, ACCELERATION, JERK, POSITION, LINEAR_VELOCITY, LINEAR_ACCELERATION = range(7)


class Curve(CurveAnalysis, CurvePictures):
    """A smooth curve through keyframes, with exact angular velocity, acceleration and jerk.

    Functions of time take a time or an array of times of any shape, in any order; what they give has that shape and one
    axis more. Angular rates are in the body frame unless `frame="world"`. A curve never changes, and threads may share
    it.

    Parameters
    ----------
    times, rotations
        As of `Keys`, which also says what the other arguments for keys mean. Or the first is a `Keys`.
    method : str, optional
        A method by name (`orispline.methods()` lists them), or by its text form, `"quintic:tension=0.6"`. Without it
        that of the file which the keys are from, if it names one, else `auto`.
    ends : str or (str, str), optional
        End rule for both ends, or for each.
    start_rate, end_rate : (3,) arrays, optional
        Angular velocity at an end [rad/s], body frame; the rule of that end is then `clamped`.
    closed : bool
        A loop: the last key is the first one again.
    period : float, optional
        A loop whose first key returns so many seconds after it.
    extrapolate : {"hold", "error", "nan", "rate", "segment"}
        What a time outside the curve gets: the end orientation at rest, an error, NaN, the motion at the end's rate, or
        what the formula of the end segment gives there.
    **settings
        Parameters of the method: a number, or one for each key, or a word. `tension=0.4`, `variant="boyle"`.

    Raises
    ------
    ArgumentError
        A method, setting, rule or rate that there is not.
    DataError
        Keys that `Keys` refuses, or too few of them.

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

    __slots__ = ("_beyond", "_clock", "_core", "_keys", "_plain", "_scalar_first")

    def __init__(self, times: Any, rotations: Any = None, method: str | None = None, *,
                 ends: str | tuple[str, str] | None = None, start_rate: Any = None, end_rate: Any = None,
                 closed: bool = False, period: float | None = None, extrapolate: str = "hold",
                 positions: Any = None, angular_velocities: Any = None,
                 angular_accelerations: Any = None, angular_jerks: Any = None, signs: str = "shortest",
                 scalar_first: bool = False, normalize: bool = False, time_unit: str | None = None,
                 **settings: Any) -> None:
        if isinstance(times, Keys):
            if rotations is not None:
                raise TypeError("found Keys and rotations, wanted one of them")
            keys = times
        else:
            keys = Keys(times, rotations, positions=positions, angular_velocities=angular_velocities,
                        angular_accelerations=angular_accelerations, angular_jerks=angular_jerks, signs=signs,
                        scalar_first=scalar_first, normalize=normalize, time_unit=time_unit)
        text = keys._method_text(method, ends, start_rate, end_rate, closed, period, settings)
        self._set(keys, _core.Curve(keys._core, text), _index("extrapolate", extrapolate, BEYOND))

    def _set(self, keys: Keys, core: Any, beyond: int) -> None:
        self._keys, self._core, self._beyond = keys, core, beyond
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
        return str(self._core.method)

    @property
    def info(self) -> dict[str, Any]:
        """What the registry says of the method."""
        return dict(_core.method_info(self._core.name))

    @property
    def domain(self) -> tuple[Any, Any]:
        """The first and the last time."""
        first, last = self._clock.back(np.array(self._core.domain))
        return (first, last) if self._clock.is_calendar else (float(first), float(last))

    # What it is at times.

    @quantity
    def __call__(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., 4) unit quaternions, x, y, z, w, or w, x, y, z where the keys were given so."""
        if isinstance(t, float) and self._plain and out is None and dtype is np.float64:
            return self._core.one(ORIENTATION, t, False, self._beyond)  # type: ignore[no-any-return]
        if not self._scalar_first:
            return self._at(ORIENTATION, t, "body", out, dtype, threads)
        q = self._at(ORIENTATION, t, "body", None, dtype, threads)
        result = output("out", out, q.shape, q.dtype)
        result[...] = q[..., [3, 0, 1, 2]]
        return result

    def rotation(self, t: Any) -> Rotation:
        """A SciPy Rotation, of a time or of (k,) times."""
        from scipy.spatial.transform import Rotation
        return Rotation.from_quat(self._at(ORIENTATION, t, "body", None, np.float64, 1))

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
        if _index("side", side, SIDES) == 1:
            q = self(t)  # with what a time outside gets
            seconds = float(self._clock.seconds("t", t))
            first, last = self._core.domain
            if first < seconds <= last:
                return Motion(q, *self._core.rates_before(seconds, _index("frame", frame, FRAMES) == 1))
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
        world = _index("frame", frame, FRAMES) == 1
        even = self._grid_wanted(rate, count, times, start, end, include_end, derivatives)
        seconds = np.empty(len(even)) if even is not None else self._given(times)
        linear = min(derivatives, 2) + 1 if self._core.has_positions else 0
        rows = sample_rows(out, (len(seconds),), derivatives, linear, dtype, seconds)
        how = {"world": world, "beyond": self._beyond, "threads": thread_count(threads)}
        if even is None:
            self._core.fill(seconds, *rows, **how)
        else:
            self._core.fill_even(even, seconds, *rows, **how)
        if self._scalar_first:
            rows[0][...] = rows[0][:, [3, 0, 1, 2]]
        grid = None if even is None else (rate, count, *self._bounds(start, end), include_end, *self._core.domain)
        return samples_of(self._keys, seconds, rows, frame, grid)

    def _grid_wanted(self, rate: Any, count: int | None, times: Any, start: Any, end: Any, include_end: bool,
                     derivatives: int) -> Any:
        """The grid of the samples, None where their times are given."""
        if sum(given is not None for given in (rate, count, times)) != 1:
            raise ArgumentError("sample: wanted one of rate, count and times")
        if derivatives not in (0, 1, 2, 3):
            raise ArgumentError(f"derivatives: found {derivatives!r}, wanted 0, 1, 2 or 3")
        if times is not None:
            return None
        include_end = flag("include_end", include_end)
        bounds = self._bounds(start, end)
        if count is not None and (isinstance(count, bool) or not isinstance(count, (int, np.integer)) or count < 1):
            raise ArgumentError(f"count: found {count!r}, wanted a whole number from 1 on")
        if count is not None:
            check_number(count)
        text, number = (rate_text(rate), None) if count is None else (None, int(count))
        grid = self._core.grid(text, number, *bounds, include_end)
        check_number(len(grid))
        return grid

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
        world = _index("frame", frame, FRAMES) == 1
        if isinstance(t, float) and self._plain and out is None and dtype is np.float64:
            return self._core.one(what, t, world, self._beyond)  # type: ignore[no-any-return]
        seconds = self._asked("t", t)
        result = output("out", out, (*seconds.shape, 4 if what == ORIENTATION else 3), dtype, seconds)
        self._core.many(what, seconds.reshape(-1), result.reshape(-1, result.shape[-1]), world, self._beyond,
                        thread_count(threads))
        return result

    def __repr__(self) -> str:
        order = "".join("⁰¹²³⁴⁵⁶⁷⁸⁹"[int(digit)] for digit in str(self.continuity()))
        count = len(self._keys)
        return (f"Curve({self.method!r}, {count} key{'' if count == 1 else 's'}, "
                f"{_span(self._clock, np.array(self._core.domain))}, C{order})")

    def __reduce__(self) -> Any:
        return _restored, (self._keys, self.method, self._beyond)


def _restored(keys: Keys, method: str, beyond: int) -> Curve:
    curve = Curve.__new__(Curve)
    curve._set(keys, _core.Curve(keys._core, method), beyond)
    return curve


def _index(name: str, word: str, words: tuple[str, ...]) -> int:
    if word not in words:
        raise ArgumentError(f"{name}: found {word!r}, wanted {', '.join(repr(w) for w in words[:-1])} or {words[-1]!r}")
    return words.index(word)
