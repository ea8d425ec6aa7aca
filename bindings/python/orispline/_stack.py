# SPDX-License-Identifier: Apache-2.0
"""Many curves in one call, such as those of the joints of a figure, or of tracks."""
from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import Array, array_of, as_given, numbers, output, sample_rows
from ._checks import flag, in_world, thread_count, wrong_type
from ._columns import PARTS
from ._curve import Curve
from ._errors import ArgumentError, DataError, Error, collected, tell
from ._evaluation import (ACCELERATION, JERK, LINEAR_ACCELERATION, LINEAR_VELOCITY, ORIENTATION, POSITION, VELOCITY)
from ._keys import Keys
from ._samples import Samples, samples_of
from ._types import stacked_quantity, stacked_rate

if TYPE_CHECKING:
    from ._types import AngleUnit, Extrapolate, Method, Number, Signs, TimeUnit


class CurveStack:
    """Many curves in one call: those of joints through keys at the same times, or of tracks whose clocks are their own.

    Each is the `Curve` through its own keys, bit for bit. Functions of time take a time or an array of times of any
    shape, in any order; what they give has that shape and two axes more, the curves and the components. Of n tracks they take
    (n, m) times too, a row for each, and give (n, m, 4) or (n, m, 3).

    Parameters
    ----------
    times : (n,) array, or a list of tracks
        Of all joints, as of `Keys`. Or, without rotations, tracks of any lengths: pairs `(times, rotations)`, Keys or Curves.
    rotations : (n, m, 4) quaternions or (n, m, 3, 3) matrices
        Body to world, of m joints. Quaternions are x, y, z, w; with `scalar_first` w, x, y, z. With `euler` (n, m, 3) angles.
        A SciPy Rotation of two dimensions too.
    positions : (n, m, 3) array, optional
        [m], world frame.
    angular_velocities, angular_accelerations, angular_jerks : (n, m, 3) arrays, optional
        Rates at the keys of all joints, as of `Keys`.
    inner_leaving, inner_arriving : (n, m, 4) arrays, optional
        Inner quaternions of all joints, as of `Keys`.
    method, extrapolate, **options
        As of `Curve`, the same for all.

    Raises
    ------
    DataError, ArgumentError, ConvergenceError
        As of `Curve`. The message begins with the joint or the track, which is also the attribute `joint`. Tracks of which some
        have dates and some have numbers.

    Examples
    --------
    >>> import orispline as ori
    >>> left, right = [0, 0, 0, 1], [0, 0, 0.6, 0.8]
    >>> stack = ori.CurveStack([0, 1, 2], [[left, right], [right, left], [left, left]])
    >>> stack
    CurveStack('auto', 2 joints, 3 keys, 0 … 2 s)
    >>> stack([0.5, 1.5, 1.7]).shape
    (3, 2, 4)
    >>> stack.sample(rate=10, derivatives=1).angular_velocities.shape
    (21, 2, 3)
    >>> tracks = ori.CurveStack([([0, 1, 2], [left, right, left]), ([5, 7], [right, left])], extrapolate="nan")
    >>> tracks, tracks([[0.5, 1.5, 1.7], [5.1, 5.2, 6.9]]).shape
    (CurveStack('auto', 2 tracks, 2 to 3 keys, 0 … 7 s), (2, 3, 4))
    """

    __slots__ = ("__weakref__", "_cores", "_curves", "_are_tracks", "_share_clock")
    __array_ufunc__: ClassVar[None] = None  # NumPy leaves `array == stack` to the stack

    def __init__(self, times: Any, rotations: Any = None, method: Method | None = None, *, extrapolate: Extrapolate = "hold",
                 positions: Any = None, angular_velocities: Any = None, angular_accelerations: Any = None, angular_jerks: Any = None,
                 inner_leaving: Any = None, inner_arriving: Any = None, signs: Signs = "shortest", scalar_first: bool = False,
                 normalize: bool = False, normalise: bool = False, euler: str | None = None,
                 angle_unit: AngleUnit | None = None, time_unit: TimeUnit | None = None, gap: Number | None = None,
                 jumps: bool = False, **options: Any) -> None:
        for name in ("settings", "drop_invalid", "drop_duplicates", "sort"):
            if name in options:
                raise ArgumentError(f"{name}: found it with a CurveStack, wanted it with a Curve of each joint")
        given = {"positions": positions, "angular_velocities": angular_velocities, "angular_accelerations": angular_accelerations,
                 "angular_jerks": angular_jerks, "inner_leaving": inner_leaving, "inner_arriving": inner_arriving}
        given = {name: rows for name, rows in given.items() if rows is not None}
        of_keys: dict[str, Any] = {"signs": signs, "scalar_first": scalar_first, "normalize": normalize, "normalise": normalise,
                                   "euler": euler, "angle_unit": angle_unit, "time_unit": time_unit, "gap": gap, "jumps": jumps}
        how = {"method": method, "extrapolate": extrapolate, **options}
        if rotations is None:
            if given:
                raise ArgumentError(f"{next(iter(given))}: found it beside tracks, wanted it in the Keys of each track")
            tracks = _listed(times)
            _check_taken(tracks, of_keys, how)
            self._set(_each("track", tracks, lambda track: _of_track(track, of_keys, how)), are_tracks=True)
            return
        if hasattr(rotations, "as_quat"):
            rotations = rotations.as_quat(scalar_first=flag("scalar_first", scalar_first))
        array = array_of("rotations", rotations)
        _check_shape(array, euler)
        if np.shape(times)[:1] != array.shape[:1]:
            raise DataError(f"rotations: found {len(array)}, wanted one row for each of the {np.size(times)} times")
        parts = {name: numbers(name, rows, (*array.shape[:2], len(PARTS[name]))) for name, rows in given.items()}

        def of_joint(joint: int) -> Curve:
            rows: dict[str, Any] = {name: rows[:, joint] for name, rows in parts.items()}
            return Curve(Keys(times, array[:, joint], **of_keys, **rows), **how)
        self._set(_each("joint", range(array.shape[1]), of_joint), are_tracks=False)

    def _set(self, curves: list[Curve], *, are_tracks: bool) -> None:
        self._curves, self._cores, self._are_tracks = tuple(curves), [curve._core for curve in curves], are_tracks
        first = curves[0]
        for number, curve in enumerate(curves if are_tracks else ()):
            _check_alike(f"track {number}", curve, first)
        self._share_clock = not are_tracks or all(curve._clock == first._clock for curve in curves)

    def __len__(self) -> int:
        """The number of joints or tracks."""
        return len(self._curves)

    def __getitem__(self, joint: int) -> Curve:
        """The curve of one joint or track."""
        if isinstance(joint, (bool, np.bool_)) or not isinstance(joint, (int, np.integer)):
            raise wrong_type("joint", joint, "the number of a joint")
        if not -len(self) <= joint < len(self):
            raise IndexError(f"joint: found {joint}, wanted one of {len(self)} joints")
        return self._curves[joint]

    @property
    def times(self) -> Any:
        """(n,) times of the keys; of tracks a tuple, those of each."""
        return tuple(curve.times for curve in self._curves) if self._are_tracks else self._curves[0].times

    @property
    def rotations(self) -> Any:
        """(n, m, 4) unit quaternions, with the signs that the curves follow; of tracks a tuple, those of each."""
        rotations = tuple(curve.keys.rotations for curve in self._curves)
        return rotations if self._are_tracks else np.stack(rotations, axis=1)

    @property
    def method(self) -> str:
        """The method in its text form; of tracks that of the first."""
        return self._curves[0].method

    @property
    def domain(self) -> tuple[Any, Any]:
        """The first and the last time, of tracks from the earliest to the latest."""
        starts, ends = zip(*(curve.domain for curve in self._curves))
        return min(starts), max(ends)

    @stacked_quantity
    def __call__(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., m, 4) unit quaternions."""
        return self._at(ORIENTATION, t, "body", out, dtype, threads)

    @stacked_rate
    def angular_velocity(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                         threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [rad/s]."""
        return self._at(VELOCITY, t, frame, out, dtype, threads)

    @stacked_rate
    def angular_acceleration(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                             threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [rad/s²]."""
        return self._at(ACCELERATION, t, frame, out, dtype, threads)

    @stacked_rate
    def angular_jerk(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                     threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [rad/s³]."""
        return self._at(JERK, t, frame, out, dtype, threads)

    @stacked_quantity
    def position(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [m], world frame."""
        return self._at(POSITION, t, "body", out, dtype, threads)

    @stacked_quantity
    def velocity(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [m/s], world frame."""
        return self._at(LINEAR_VELOCITY, t, "body", out, dtype, threads)

    @stacked_quantity
    def acceleration(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [m/s²], world frame."""
        return self._at(LINEAR_ACCELERATION, t, "body", out, dtype, threads)

    def sample(self, rate: Any = None, *, count: int | None = None, times: Any = None, start: Any = None, end: Any = None,
               include_end: bool = False, derivatives: int = 0, frame: str = "body", dtype: Any = np.float64,
               threads: int = 1, out: Any = None) -> Samples:
        """Samples at even times or at given ones, as of `Curve.sample`, the same times for all: (k,) times, (k, m, 4) orientations
        and (k, m, 3) rates. Of tracks they go from the earliest time to the latest."""
        first = self._curves[0]
        if self._are_tracks and times is None:
            start, end = (whole if given is None else given for given, whole in zip((start, end), self.domain))
        even = first._grid_wanted(rate, count, times, start, end, include_end, derivatives)
        seconds = np.empty(len(even)) if even is not None else first._given(times)
        if even is not None:
            even.fill(seconds)
        first._check_room(out)
        linear = min(derivatives, 2) + 1 if self._have_positions else 0
        rows = sample_rows(out, (len(seconds), len(self)), derivatives, linear, dtype, seconds)
        if self._share_clock:
            self._fill(seconds, rows, frame, threads, each=False)
        else:
            self._fill_by_clocks(first._clock.back(seconds), rows, frame, threads)
        if first._scalar_first:
            rows[0][...] = rows[0][..., [3, 0, 1, 2]]
        grid = None if even is None else first._grid_stated(rate, count, start, end, include_end)
        return samples_of(first.keys, *first._there(seconds, rows), frame, grid)

    @property
    def _have_positions(self) -> bool:
        return all(core.has_positions for core in self._cores)

    def _at(self, what: int, t: Any, frame: str, out: Any, dtype: Any, threads: int) -> NDArray[Any]:
        """One quantity, in the order of `Curve`."""
        if what >= POSITION and not self._have_positions:
            raise ArgumentError("these keys have no positions, wanted positions= of the stack, or of all its tracks")
        each = self._are_tracks and np.ndim(t) > 1
        seconds = self._of_each(t) if each else self._curves[0]._asked("t", t) if self._share_clock else None
        lead = np.shape(t) if each else (*np.shape(t), len(self))
        width = 3 if what else 4
        result = output("out", out, (*lead, width), dtype, seconds)
        reordered = what == ORIENTATION and self._curves[0]._scalar_first
        room = np.empty_like(result) if reordered else result
        rows = [*[None] * what, room.reshape(*((-1, len(self)) if not each else lead), width)]
        if seconds is None:
            self._fill_by_clocks(np.asarray(array_of("t", t)).reshape(-1), rows, frame, threads)
        else:
            self._fill(seconds, rows, frame, threads, each=each)
        if reordered:
            result[...] = room[..., [3, 0, 1, 2]]
        return as_given(t, result)  # type: ignore[no-any-return]

    def _of_each(self, t: Any) -> Array:
        """(n, m) times [s] of n tracks, each by its own clock."""
        times = array_of("t", t)
        if times.ndim != 2 or len(times) != len(self):
            raise ArgumentError(f"t: found the shape {times.shape}, wanted times for all tracks, (m,), or a row for each of them, ({len(self)}, m)")
        if self._share_clock and self._curves[0]._clock.unit == "s":
            return self._curves[0]._clock.seconds("t", times)
        return np.stack([curve._asked("t", row) for curve, row in zip(self._curves, times)])

    def _fill(self, seconds: Array, rows: list[Any], frame: str, threads: int, *, each: bool) -> None:
        _core.fill_stack(self._cores, seconds.reshape(-1), *rows, each=each, world=in_world(frame),
                         beyond=self._curves[0]._beyond, threads=thread_count(threads))

    def _fill_by_clocks(self, times: Array, rows: list[Any], frame: str, threads: int) -> None:
        """(m, n, …) of the same times for n tracks whose clocks count from different origins."""
        seconds = np.stack([curve._asked("t", times) for curve in self._curves])
        by_track = [None if room is None else np.empty((len(self), len(times), room.shape[-1]), room.dtype) for room in rows]
        self._fill(seconds, by_track, frame, threads, each=True)
        for room, found in zip(rows, by_track):
            if found is not None:
                room[...] = found.swapaxes(0, 1)

    def __repr__(self) -> str:
        word = "track" if self._are_tracks else "joint"
        counts = [len(curve.keys) for curve in self._curves]
        few, many = min(counts), max(counts)
        keys = f"{few} to {many} keys" if few < many else f"{few} key{'' if few == 1 else 's'}"
        first = self._curves[0]
        ends = np.array([float(first._clock.seconds("t", end)) for end in self.domain])
        return f"CurveStack({self.method!r}, {len(self)} {word}{'' if len(self) == 1 else 's'}, {keys}, {first._clock.span(ends)})"

    def __reduce__(self) -> Any:
        return _restored, (list(self._curves), self._are_tracks)


def _restored(curves: list[Curve], are_tracks: bool = False) -> CurveStack:
    stack = CurveStack.__new__(CurveStack)
    stack._set(curves, are_tracks=are_tracks)
    return stack


def _each(word: str, things: Iterable[Any], curve_of: Callable[[Any], Curve]) -> list[Curve]:
    """The curves of all, whose errors and warnings say which it is."""
    curves = []
    for number, thing in enumerate(things):
        try:
            with collected() as found:
                curves.append(curve_of(thing))
        except Error as error:
            error.joint, error._cure = number, ""
            error.args = (f"{word} {number}: {error}", *error.args[1:])
            raise
        tell((f"{word} {number}: {warning}", warning.code, warning.numbers) for warning in found)
    return curves


TRACKS = "a list of tracks, pairs such as (times, rotations), Keys or Curves"


def _listed(tracks: Any) -> list[Any]:
    if isinstance(tracks, (str, np.ndarray, Keys)) or not isinstance(tracks, Iterable):
        raise wrong_type("rotations", None, f"(n, m, 4) quaternions beside the times, or in the place of both {TRACKS}")
    listed = list(tracks)
    if not listed:
        raise ArgumentError(f"tracks: found none, wanted {TRACKS}")
    return listed


def _check_taken(tracks: list[Any], of_keys: dict[str, Any], how: dict[str, Any]) -> None:
    """That some track takes what is stated: Keys and Curves are made already."""
    if all(isinstance(track, Curve) and track._extrapolate == how["extrapolate"] for track in tracks):
        how = {**how, "extrapolate": None}
    for stated, made, which in ((of_keys, (Keys, Curve), "Keys"), (how, Curve, "Curves")):
        for name, value in stated.items():
            is_default = value is None or value is False or name == "signs" and value == "shortest" or name == "extrapolate" and value == "hold"
            if not is_default and all(isinstance(track, made) for track in tracks):
                raise ArgumentError(f"{name}: found it beside {which}, which have their own, wanted it where each of them is made")


def _of_track(track: Any, of_keys: dict[str, Any], how: dict[str, Any]) -> Curve:
    if isinstance(track, Curve):
        return track
    if isinstance(track, Keys):
        return Curve(track, **how)
    if not isinstance(track, (tuple, list)) or len(track) != 2:
        raise wrong_type("track", track, "a pair (times, rotations), Keys or a Curve")
    return Curve(Keys(*track, **of_keys), **how)


def _check_alike(name: str, curve: Curve, first: Curve) -> None:
    """That a track can be asked together with the first one."""
    if curve._clock.kind != first._clock.kind:
        raise ArgumentError(f"{name}: found times that are {curve._clock.word}, wanted {first._clock.word}, as those of track 0 are")
    if not curve._clock.kind and curve._clock.unit != first._clock.unit:
        raise ArgumentError(f"{name}: found times in {curve._clock.unit}, wanted {first._clock.unit}, as those of track 0 are")
    if not curve._clock.kind and curve._clock.unit == "s" and curve.keys.epoch != first.keys.epoch:
        raise ArgumentError(f"{name}: found times that count from {curve.keys.epoch} s, wanted {first.keys.epoch} s, as those of track 0 do")
    if curve._scalar_first != first._scalar_first:
        raise ArgumentError(f"{name}: found another order of quaternions than that of track 0, wanted one `scalar_first` for all")
    if curve._extrapolate != first._extrapolate:
        raise ArgumentError(f"{name}: found extrapolate={curve._extrapolate!r}, wanted {first._extrapolate!r}, as that of track 0 is")
    if curve._leaves_out:
        raise ArgumentError("extrapolate: found 'leave-out' with tracks, of which each has times of its own, wanted 'nan'")


def _check_shape(array: NDArray[Any], euler: Any) -> None:
    rows, wanted = (((3,),), "(n, m, 3)") if euler is not None else (((4,), (3, 3)), "(n, m, 4) or (n, m, 3, 3)")
    if array.shape[2:] not in rows:
        raise ArgumentError(f"rotations: found the shape {array.shape}, wanted {wanted}")
    if array.shape[1] == 0:
        raise ArgumentError(f"rotations: found the shape {array.shape}, wanted one joint at least")
