# SPDX-License-Identifier: Apache-2.0
"""The mean and the median of many orientations."""
from __future__ import annotations

import dataclasses
import functools
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, overload

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import numbers
from ._checks import flag
from ._errors import ArgumentError, DataError
from ._html import table
from ._keys import Keys, keys_of, orientations_of
from ._options import FIELDS, KEYS_ARGUMENTS, parted, plain, states, takes
from ._request import Request
from ._told import Told

if TYPE_CHECKING:
    from ._types import AngleUnit

Vector = NDArray[np.float64]
SCALAR_FIRST = [3, 0, 1, 2]
MATRICES = ("covariance", "spread", "position_covariance", "position_spread")
VECTORS = ("sigma", "position_sigma")


@states("Mean")
@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Mean(Told):
    """The middle of many orientations, of `mean`.

    Attributes
    ----------
    orientation
        (4,) unit quaternion, in the order of those that were given.
    position
        (3,) arithmetic mean or geometric median of the positions [m], world frame; None without any.
    kind
        `"mean"`, `"median"` or `"chordal"`.
    time
        Of a window in time its middle, as the times of the keys are; else None.
    farthest, farthest_position
        Indices of the orientation and the position at the largest distance.
    {fields}
    """

    orientation: Vector
    position: Vector | None
    kind: str
    time: Any
    count: int
    weight: float
    sigma: Vector | None
    covariance: Vector | None
    spread: Vector | None
    rms_distance: float
    largest_distance: float
    farthest: int
    certified: bool
    ball_radius: float
    others_within: float | None
    residual: float
    iterations: int
    position_sigma: Vector | None
    position_covariance: Vector | None
    position_spread: Vector | None
    position_rms_distance: float | None
    position_largest_distance: float | None
    farthest_position: int | None
    _members: dict[str, Any]
    _summary: str

    def __getattr__(self, name: str) -> Any:
        """Of a chordal mean what is found only when it is asked for: all but the orientation and the kind."""
        find = self.__dict__.get("_find")
        if find is not None:
            self.__dict__.update({**find().__dict__, **self.__dict__})
            self.__dict__.pop("_find", None)  # at last, for others may ask meanwhile
        return self.__dict__[name] if name in self.__dict__ else super().__getattr__(name)  # type: ignore[misc]

    def __getstate__(self) -> dict[str, Any]:
        _ = self.count  # which finds all
        return self.__dict__

    def __repr__(self) -> str:
        q = ", ".join(f"{x:.6g}" for x in self.orientation)
        return f"Mean([{q}], {self.kind} of {self.count}, rms_distance={self.rms_distance:.6g}, certified={self.certified})"

    def _repr_html_(self) -> str:
        """The table that a notebook shows: what was found, by name with unit, and what it means."""
        rows = [(field["member"], value, field["sentence"]) for field in FIELDS["Mean"]
                if isinstance(value := self._members.get(field["member"]), (bool, int, float, str))]
        return table(repr(self), ("", "", "meaning"), rows)


def _of_times(task: Callable[..., Any]) -> Callable[..., Any]:
    """Lets it take times before the rotations, and then the arguments of `Keys`."""
    @functools.wraps(task)
    def run(*given: Any, **stated: Any) -> Any:
        """With the keys that two arguments make."""
        if len(given) == 2:
            of_them, stated = parted(stated, KEYS_ARGUMENTS)
            given = (keys_of(given[0], {"rotations": given[1], **of_them}),)
        return task(*given, **stated)

    return run


@overload
def mean(rotations: Any, *, every: None = None, weights: Any = None, positions: Any = None, scalar_first: bool = False, normalize: bool = False,
         normalise: bool = False, euler: str | None = None, angle_unit: AngleUnit | None = None, **options: Any) -> Mean: ...
@overload
def mean(rotations: Keys, *, every: float | str, weights: Any = None, **options: Any) -> list[Mean]: ...
@overload
def mean(times: Any, rotations: Any, /, *, every: None = None, weights: Any = None, **options: Any) -> Mean: ...
@overload
def mean(times: Any, rotations: Any, /, *, every: float | str, weights: Any = None, **options: Any) -> list[Mean]: ...
@_of_times
@takes("MeanOptions")
def mean(rotations: Any, *, every: float | str | None = None, weights: Any = None, positions: Any = None, scalar_first: bool = False,
         normalize: bool = False, normalise: bool = False, euler: str | None = None, angle_unit: AngleUnit | None = None,
         **options: Any) -> Mean | list[Mean]:
    """The mean or the median of many orientations, with its covariance and whether it is the only one.

    Neither the order nor the signs of quaternions count. `kind="chordal"` is SciPy's `Rotation.mean`, in its time: what else
    there is of it is found when it is first asked for.

    Parameters
    ----------
    rotations : Keys, (n, 4) quaternions, (n, 3, 3) matrices, (n, 4, 4) poses, a SciPy Rotation or RigidTransform, or a list of Rotations
        Body to world, as of `Keys`. Keys and poses bring positions. A list of Keys is one set of all their rows, without times.
        With two arguments the first are the times, and the others those of `Keys`: `mean(times, rotations, every="1s")`.
    weights : (n,) array, optional
        0 or more; without them all weigh the same.
    positions : (n, 3) array, optional
        [m], world frame.
    scalar_first, normalize, normalise, euler, angle_unit
        As of `Keys`.
    {options}

    Returns
    -------
    Mean or list of Mean
        With `every` a list, of each window in time of the keys that has some with a weight; the first one begins at the first key.

    Raises
    ------
    ArgumentError
        Arrays of another shape, an option that there is not, `every` for orientations without times.
    DataError
        No orientations, weights below 0 or not finite or all 0, and orientations that cancel, such as two that are 180° apart.

    Warns
    -----
    ShapeWarning
        It may not be the only one, or a median is the middle of a range.

    Examples
    --------
    >>> import orispline as ori
    >>> found = ori.mean([[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, -0.6, -0.8]])
    >>> found.orientation.round(6).tolist(), found.count, found.certified
    ([0.0, 0.0, 0.415962, 0.909382], 3, True)
    >>> found
    Mean([0, 0, 0.415962, 0.909382], mean of 3, rms_distance=0.606699, certified=True)
    >>> ori.mean([[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 0.6, 0.8]], kind="median").orientation.tolist()
    [0.0, 0.0, 0.6, 0.8]
    """
    weights = None if weights is None else numbers("weights", weights, (None,))
    several = _several(rotations)
    if several:
        _check_none_beside_keys(positions=positions, scalar_first=scalar_first, normalize=normalize, normalise=normalise, euler=euler,
                                angle_unit=angle_unit)
        scalar_first = several[0]._scalar_first
    elif every is not None:
        raise ArgumentError("every: found orientations without times, wanted Keys, whose times make windows")
    else:
        orientations, positions = orientations_of(rotations, positions, flag("scalar_first", scalar_first), euler, angle_unit)
        if options == {"kind": "chordal"} and positions is None and not flag("normalize", normalize) and not flag("normalise", normalise):
            return _at_once(orientations, weights, scalar_first)
        several = [_set_of(orientations, positions, normalize=normalize, normalise=normalise)]
    return _found(several, weights, scalar_first, plain({"every": every, **options}))


def _at_once(orientations: Vector, weights: Vector | None, scalar_first: bool) -> Mean:
    """The chordal mean, with what it takes to find all else of it: that takes several times as long."""
    q = _core.chordal_mean(orientations, weights)
    rows, weights = orientations.copy(), None if weights is None else weights.copy()
    mean = Mean.__new__(Mean)
    mean.__dict__.update(orientation=q[SCALAR_FIRST] if scalar_first else q, kind="chordal",
                         _find=lambda: _found([_set_of(rows, None)], weights, scalar_first, {"kind": "chordal"}))
    return mean


def _found(several: list[Keys], weights: Vector | None, scalar_first: bool, options: dict[str, Any]) -> Mean | list[Mean]:
    """By the task of the library."""
    rows = several if weights is None else _weighted(several, weights)
    core, = Request("mean", {"rows": list(rows)}, options).told()
    members = core.members()
    found = core.attributes()["windows"]
    windows = members.get("windows", [members])
    kind, is_single = members["kind"], "windows" not in members
    made = [_made(one, scalar_first, kind, None if is_single else several[0]._clock.time(one["time"]), of_it,
                  core.summary() if is_single else "") for one, of_it in zip(found, windows)]
    return made[0] if is_single else made


def _several(rotations: Any) -> list[Keys]:
    """Those that are given, one or a list of them; none where it is something else."""
    if isinstance(rotations, Keys):
        return [rotations]
    is_list = isinstance(rotations, (list, tuple)) and len(rotations) > 0 and all(isinstance(one, Keys) for one in rotations)
    return list(rotations) if is_list else []


def _check_none_beside_keys(**stated: Any) -> None:
    for name, value in stated.items():
        if value is not None and value is not False:
            raise ArgumentError(f"{name}: found it beside Keys, which have their own, wanted one of them")


def _set_of(orientations: Vector, positions: Any, **norms: Any) -> Keys:
    """Orientations without times as keys, which are checked; the numbers of rows are their times."""
    if not len(orientations):
        raise DataError("rotations: found none, wanted one at least")
    if positions is not None and len(positions := numbers("positions", positions, (None, 3))) != len(orientations):
        raise DataError(f"positions: found {len(positions)}, wanted one for each of the {len(orientations)} rotations")
    return Keys(np.arange(float(len(orientations))), orientations, positions=positions, **norms)


def _weighted(several: list[Keys], weights: Vector) -> list[_core.Keys]:
    """Each with its part of the weights."""
    *ends, count = np.cumsum([len(keys) for keys in several])
    if ends and len(weights) != count:
        raise DataError(f"found {len(weights)} weights of {count} orientations, wanted one of each")
    return [_core.weighted(keys._core, part) for keys, part in zip(several, np.split(weights, ends))]


def _made(found: dict[str, Any], scalar_first: bool, kind: str, time: Any, members: dict[str, Any], summary: str) -> Mean:
    q = found["orientation"]
    values = {**found, "orientation": q[SCALAR_FIRST] if scalar_first else q, "kind": kind, "time": time}
    for name in MATRICES:
        values[name] = None if found[name] is None else _matrix(*found[name])
    for name in VECTORS:
        values[name] = None if found[name] is None else np.array(found[name])
    return Mean(**values, _members=members, _summary=summary)


def _matrix(xx: float, yy: float, zz: float, xy: float, xz: float, yz: float) -> Vector:
    return np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
