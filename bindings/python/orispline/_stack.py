# SPDX-License-Identifier: Apache-2.0
"""Many curves on the same times, such as the joints of a figure."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import array_of, as_given, numbers, output, sample_rows
from ._checks import flag, in_world, thread_count, wrong_type
from ._columns import PARTS
from ._curve import Curve
from ._errors import ArgumentError, DataError, Error, collected, tell
from ._keys import Keys
from ._samples import Samples, samples_of
from ._types import stacked_quantity, stacked_rate

if TYPE_CHECKING:
    from ._types import AngleUnit, Extrapolate, Method, Number, Signs, TimeUnit


class CurveStack:
    """Curves of one method through keys at the same times, such as the joints of a figure.

    Each joint is the `Curve` through its own keys, bit for bit. Functions of time take a time or an array of times of any
    shape, in any order; what they give has that shape and two axes more, the joints and the components.

    Parameters
    ----------
    times : (n,) array
        Of all joints, as of `Keys`.
    rotations : (n, m, 4) quaternions or (n, m, 3, 3) matrices
        Body to world, of m joints. Quaternions are x, y, z, w; with `scalar_first` w, x, y, z. With `euler` (n, m, 3) angles.
    angular_velocities, angular_accelerations, angular_jerks : (n, m, 3) arrays, optional
        Rates at the keys of all joints, as of `Keys`.
    inner_leaving, inner_arriving : (n, m, 4) arrays, optional
        Inner quaternions of all joints, as of `Keys`.
    method, extrapolate, **options
        As of `Curve`, the same for all joints.

    Raises
    ------
    DataError, ArgumentError, ConvergenceError
        As of `Curve`. The message begins with the joint, which is also the attribute `joint`.

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
    """

    __slots__ = ("_cores", "_curves")

    def __init__(self, times: Any, rotations: Any, method: Method = "auto", *, extrapolate: Extrapolate = "hold",
                 angular_velocities: Any = None, angular_accelerations: Any = None, angular_jerks: Any = None,
                 inner_leaving: Any = None, inner_arriving: Any = None, signs: Signs = "shortest", scalar_first: bool = False,
                 normalize: bool = False, normalise: bool = False, euler: str | None = None,
                 angle_unit: AngleUnit | None = None, time_unit: TimeUnit | None = None, gap: Number | None = None,
                 **options: Any) -> None:
        for name in ("positions", "settings", "drop_invalid", "drop_duplicates", "sort"):
            if name in options:
                raise ArgumentError(f"{name}: found it with a CurveStack, wanted it with a Curve of each joint")
        if hasattr(rotations, "as_quat"):
            rotations = rotations.as_quat(scalar_first=flag("scalar_first", scalar_first))
        array = array_of("rotations", rotations)
        _check_shape(array, euler)
        if np.shape(times)[:1] != array.shape[:1]:
            raise DataError(f"rotations: found {len(array)}, wanted one row for each of the {np.size(times)} times")
        given = {"angular_velocities": angular_velocities, "angular_accelerations": angular_accelerations,
                 "angular_jerks": angular_jerks, "inner_leaving": inner_leaving, "inner_arriving": inner_arriving}
        parts = {name: numbers(name, rows, (*array.shape[:2], len(PARTS[name])))
                 for name, rows in given.items() if rows is not None}
        how: dict[str, Any] = {"signs": signs, "scalar_first": scalar_first, "normalize": normalize, "normalise": normalise,
                               "euler": euler, "angle_unit": angle_unit, "time_unit": time_unit, "gap": gap}
        curves = []
        for joint in range(array.shape[1]):
            try:
                keys = Keys(times, array[:, joint], **how, **{name: rows[:, joint] for name, rows in parts.items()})  # type: ignore[arg-type]
                with collected() as found:
                    curves.append(Curve(keys, method=method, extrapolate=extrapolate, **options))
            except Error as error:
                error.joint = joint
                error.args = (f"joint {joint}: {error}", *error.args[1:])
                raise
            tell((f"joint {joint}: {warning}", warning.code, warning.numbers) for warning in found)
        self._set(curves)

    def _set(self, curves: list[Curve]) -> None:
        self._curves, self._cores = tuple(curves), [curve._core for curve in curves]

    def __len__(self) -> int:
        """The number of joints."""
        return len(self._curves)

    def __getitem__(self, joint: int) -> Curve:
        """The curve of one joint."""
        if isinstance(joint, (bool, np.bool_)) or not isinstance(joint, (int, np.integer)):
            raise wrong_type("joint", joint, "the number of a joint")
        if not -len(self) <= joint < len(self):
            raise IndexError(f"joint: found {joint}, wanted one of {len(self)} joints")
        return self._curves[joint]

    @property
    def times(self) -> np.ndarray[Any, Any]:
        """(n,) times of the keys."""
        return self._curves[0].times

    @property
    def rotations(self) -> NDArray[np.float64]:
        """(n, m, 4) unit quaternions, with the signs that the curves follow."""
        return np.stack([curve.keys.rotations for curve in self._curves], axis=1)

    @property
    def method(self) -> str:
        """The method in its text form."""
        return self._curves[0].method

    @property
    def domain(self) -> tuple[Any, Any]:
        """The first and the last time."""
        return self._curves[0].domain

    @stacked_quantity
    def __call__(self, t: Any, *, out: Any = None, dtype: Any = np.float64, threads: int = 1) -> NDArray[Any]:
        """(..., m, 4) unit quaternions."""
        return self._at(0, t, "body", out, dtype, threads)

    @stacked_rate
    def angular_velocity(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                         threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [rad/s]."""
        return self._at(1, t, frame, out, dtype, threads)

    @stacked_rate
    def angular_acceleration(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                             threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [rad/s²]."""
        return self._at(2, t, frame, out, dtype, threads)

    @stacked_rate
    def angular_jerk(self, t: Any, frame: str = "body", out: Any = None, *, dtype: Any = np.float64,
                     threads: int = 1) -> NDArray[Any]:
        """(..., m, 3) [rad/s³]."""
        return self._at(3, t, frame, out, dtype, threads)

    def sample(self, rate: Any = None, *, count: int | None = None, times: Any = None, start: Any = None, end: Any = None,
               include_end: bool = False, derivatives: int = 0, frame: str = "body", dtype: Any = np.float64,
               threads: int = 1, out: Any = None) -> Samples:
        """Samples at even times or at given ones, as of `Curve.sample`: (k,) times, (k, m, 4) orientations and (k, m, 3)
        rates."""
        first = self._curves[0]
        even = first._grid_wanted(rate, count, times, start, end, include_end, derivatives)
        seconds = np.empty(len(even)) if even is not None else first._given(times)
        if even is not None:
            even.fill(seconds)
        first._check_room(out)
        rows = sample_rows(out, (len(seconds), len(self)), derivatives, 0, dtype, seconds)
        self._fill(seconds, rows[:derivatives + 1], frame, threads)
        if first._scalar_first:
            rows[0][...] = rows[0][..., [3, 0, 1, 2]]
        grid = None if even is None else first._grid_stated(rate, count, start, end, include_end)
        return samples_of(first.keys, *first._there(seconds, rows), frame, grid)

    def _at(self, order: int, t: Any, frame: str, out: Any, dtype: Any, threads: int) -> NDArray[Any]:
        """Orientations, or rates of that order."""
        seconds = self._curves[0]._asked("t", t)
        width = 3 if order else 4
        result = output("out", out, (*seconds.shape, len(self), width), dtype, seconds)
        reordered = order == 0 and self._curves[0]._scalar_first
        room = np.empty_like(result) if reordered else result
        self._fill(seconds.reshape(-1), [*[None] * order, room.reshape(-1, len(self), width)], frame, threads)
        if reordered:
            result[...] = room[..., [3, 0, 1, 2]]
        return as_given(t, result)  # type: ignore[no-any-return]

    def _fill(self, seconds: NDArray[np.float64], rows: list[Any], frame: str, threads: int) -> None:
        _core.fill_stack(self._cores, seconds, *rows, world=in_world(frame),
                         beyond=self._curves[0]._beyond, threads=thread_count(threads))

    def __repr__(self) -> str:
        keys = self._curves[0].keys
        return (f"CurveStack({self.method!r}, {len(self)} joint{'' if len(self) == 1 else 's'}, {len(keys)} "
                f"key{'' if len(keys) == 1 else 's'}, {keys._clock.span(np.array(self._cores[0].domain))})")

    def __reduce__(self) -> Any:
        return _restored, (list(self._curves),)


def _restored(curves: list[Curve]) -> CurveStack:
    stack = CurveStack.__new__(CurveStack)
    stack._set(curves)
    return stack


def _check_shape(array: NDArray[Any], euler: Any) -> None:
    rows, wanted = (((3,),), "(n, m, 3)") if euler is not None else (((4,), (3, 3)), "(n, m, 4) or (n, m, 3, 3)")
    if array.shape[2:] not in rows:
        raise ArgumentError(f"rotations: found the shape {array.shape}, wanted {wanted}")
    if array.shape[1] == 0:
        raise ArgumentError(f"rotations: found the shape {array.shape}, wanted one joint at least")
