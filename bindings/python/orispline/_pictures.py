# SPDX-License-Identifier: Apache-2.0
"""Several curves in the same pictures."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, Sequence

from ._charts import CHARTED, charts, sphere
from ._clock import Clock
from ._curve import Curve
from ._errors import ArgumentError
from ._evaluation import OrientationCurve
from ._keys import Keys

Curves = Any  # a Curve, several, or a mapping from names to curves


def plot_comparison(curves: Curves, reference: OrientationCurve | Keys | None = None, *, axes: Any = None,
                    quantities: str | Sequence[str] | None = None, ghosts: int = 0, ax: Any = None) -> Any:
    """Curves over time in the same charts: several, or a mapping from names to curves. With a reference, another curve or
    keys such as a recording, the first chart is of the angles to it [deg], where both have a time. With `ghosts` the last
    one has the bodies of every curve in a row, as `Curve.plot` has.

    The quantities are those of `Curve.plot`, without any the angle, the rate and the acceleration. `axes`, or `ax`, are as many Axes as
    charts, or None for a new figure. Returns an array of these Axes; nothing is shown. Raises
    ArgumentError as `Curve.plot` does, and for curves whose times are of different kinds.

    >>> import matplotlib, orispline as ori
    >>> matplotlib.use("Agg")
    >>> keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> len(ori.plot_comparison([keys.curve("auto"), keys.curve("slerp")], keys.curve("timed-c2")))
    4
    """
    named = _named(curves)
    if reference is not None:
        _check_reference(reference, next(iter(named.values()))._clock)
    return charts(named, reference, axes, quantities, ghosts, CHARTED[:3], ax)


def plot_sphere(curves: Curves, axis: Any = "x", axes: Any = None, *, ax: Any = None) -> Any:
    """The path of a body axis over the unit sphere, world frame, with the keys as dots: of a curve, of several, or of a
    mapping from names to curves. `axis` is "x", "y", "z" or (3,) of any length but 0.

    `axes`, or `ax`, are matplotlib Axes of three dimensions, or None for a new figure. Returns these Axes; nothing is shown.

    >>> import matplotlib, orispline as ori
    >>> matplotlib.use("Agg")
    >>> ori.plot_sphere(ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]), "y").get_title()
    'body axis y on the unit sphere'
    """
    return sphere(_named(curves), axis, axes, ax)


def _named(curves: Curves) -> dict[str, OrientationCurve]:
    """Curves by their names; those of the same method are numbered."""
    if isinstance(curves, OrientationCurve):
        return {_method(curves): curves}
    if isinstance(curves, Mapping):
        named = {str(name): curve for name, curve in curves.items()}
    elif isinstance(curves, Iterable):
        named = {}
        for curve in curves:
            method = _method(curve)
            named[method if method not in named else f"{method} ({len(named) + 1})"] = curve
    else:
        raise TypeError(f"curves: found {type(curves).__name__}, wanted curves")
    for curve in named.values():
        if not isinstance(curve, OrientationCurve):
            raise TypeError(f"curves: found {type(curve).__name__} among them, wanted curves")
    if not named:
        raise ArgumentError("curves: found none, wanted one at least")
    kinds = {_kind(curve._clock) for curve in named.values()}
    if len(kinds) > 1:
        raise ArgumentError("curves: found times of different kinds, wanted the same for all")
    return named


def _method(curve: Any) -> str:
    """What a curve is called that was given no name."""
    return curve.method if isinstance(curve, Curve) else "composed"


def _kind(clock: Clock) -> tuple[str, str]:
    return clock.kind, "" if clock.kind else clock.unit


def _check_reference(reference: Any, clock: Clock) -> None:
    if not isinstance(reference, (Keys, OrientationCurve)):
        raise TypeError(f"reference: found {type(reference).__name__}, wanted a Curve or Keys")
    if _kind(reference._clock) != _kind(clock):
        raise ArgumentError("reference: found times of another kind than those of the curves, wanted the same")
