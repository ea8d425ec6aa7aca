# SPDX-License-Identifier: Apache-2.0
"""Curves to look at: charts and spheres by matplotlib, drawings and pages by the library."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Iterable, Mapping, Sequence

import numpy as np

from . import _core
from ._arrays import Array, numbers
from ._clock import PER_SECOND, Clock
from ._curve_analysis import checked_inertia
from ._errors import ArgumentError, DataError
from ._ghosts import draw_ghosts, ghost_count
from ._keys import Keys, _span

if TYPE_CHECKING:
    import pathlib

    from ._curve import Curve

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
CHART = (8.0, 2.1)  # inches
GREY, INK = "0.75", "0.2"
Curves = Any  # a Curve, several, or a mapping from names to curves


class CurvePictures:
    """The methods of `Curve` that show it."""

    __slots__ = ()

    if TYPE_CHECKING:
        _core: Any
        _clock: Clock
        _keys: Keys

    def plot(self, axes: Any = None, quantities: str | Sequence[str] = ("angle", "rate", "acceleration", "jerk"), *,
             ghosts: int = 0) -> Any:
        """Charts over time by matplotlib: the angle from the start [deg], |ω| [rad/s], |α| [rad/s²] and |jerk| [rad/s³], the
        keys marked, and both sides of every jump. The peaks of a long curve are not missed.

        With `ghosts`, 2 to 60, the body itself stands below at so many even times from start to end, as `orispline plot
        --ghosts` draws it: that is one more chart.

        `axes` are as many matplotlib Axes as charts, or None for a new figure. Returns an array of these Axes; nothing is
        shown. Raises ArgumentError for a quantity that there is not, for another number of axes and of ghosts.

        >>> import matplotlib, orispline as ori
        >>> matplotlib.use("Agg")
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> [axes.get_ylabel() for axes in curve.plot(quantities="rate")]
        ['angular velocity |ω|\\n[rad/s]']
        >>> len(curve.plot(ghosts=12))
        5
        """
        return _charts(_named(self), None, axes, quantities, ghosts)

    def plot_sphere(self, axis: Any = "x", axes: Any = None) -> Any:
        """The path of a body axis over the unit sphere, with the keys: `orispline.plot_sphere` of this curve."""
        return plot_sphere(self, axis, axes)

    def report(self, path: str | os.PathLike[str], *, title: str = "", inertia: Any = None) -> None:
        """Writes a page to look at in a browser: the motion in space, on the sphere and over time, and its measures; with an
        inertia (as of `Curve.energies`) its torques too. One HTML file that needs nothing else; it appears complete or not
        at all. Raises AccessError where it cannot be written.

        >>> import os, tempfile, orispline as ori
        >>> page = os.path.join(tempfile.mkdtemp(), "motion.html")
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]).report(page)
        >>> os.path.exists(page)
        True
        """
        import datetime
        name = os.fsdecode(path)
        self._core.write_page(os.path.join(os.curdir, name) if name == "-" else name, str(title),
                              datetime.datetime.now().strftime("%Y-%m-%d %H:%M"), _start_text(self._clock),
                              None if inertia is None else checked_inertia(inertia))

    def show(self, *, title: str = "", inertia: Any = None) -> pathlib.Path:
        """Writes the page of `report` into a temporary file and opens it in the browser. Returns the path of the file, which
        stays there."""
        import pathlib
        import tempfile
        import webbrowser
        handle, name = tempfile.mkstemp(prefix="orispline-", suffix=".html")
        os.close(handle)
        self.report(name, title=title, inertia=inertia)
        path = pathlib.Path(name)
        webbrowser.open(path.as_uri())
        return path

    def _repr_svg_(self) -> str:
        """The drawing that a notebook shows: charts over time and the path of the x axis on the sphere, as `orispline plot`
        makes it."""
        count = len(self._keys)
        title = f"{count} key{'' if count == 1 else 's'}, {_span(self._clock, self._keys._core.times)}"
        return str(self._core.svg(title))


def plot_comparison(curves: Curves, reference: Curve | Keys | None = None, *, axes: Any = None,
                    quantities: str | Sequence[str] = ("angle", "rate", "acceleration"), ghosts: int = 0) -> Any:
    """Curves over time in the same charts: several, or a mapping from names to curves. With a reference, another curve or
    keys such as a recording, the first chart is of the angles to it [deg], where both have a time. With `ghosts` the last
    one has the bodies of every curve in a row, as `Curve.plot` has.

    `axes` are as many Axes as charts, or None for a new figure. Returns an array of these Axes; nothing is shown. Raises
    ArgumentError as `Curve.plot` does, and for curves whose times are of different kinds.

    >>> import matplotlib, orispline as ori
    >>> matplotlib.use("Agg")
    >>> keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> len(ori.plot_comparison([keys.curve("auto"), keys.curve("slerp")], keys.curve("timed-c2")))
    4
    """
    return _charts(_named(curves), reference, axes, quantities, ghosts)


def plot_sphere(curves: Curves, axis: Any = "x", axes: Any = None) -> Any:
    """The path of a body axis over the unit sphere, world frame, with the keys as dots: of a curve, of several, or of a
    mapping from names to curves. `axis` is "x", "y", "z" or (3,) of any length but 0.

    `axes` are matplotlib Axes of three dimensions, or None for a new figure. Returns these Axes; nothing is shown.

    >>> import matplotlib, orispline as ori
    >>> matplotlib.use("Agg")
    >>> ori.plot_sphere(ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]), "y").get_title()
    'body axis y on the unit sphere'
    """
    named = _named(curves)
    direction, name = _body_axis(axis)
    if axes is None:
        axes = _pyplot().figure(figsize=(6, 6), layout="constrained").add_subplot(projection="3d")
    elif getattr(axes, "name", "") != "3d":
        raise ArgumentError("axes: found flat ones, wanted Axes of three dimensions, projection='3d'")
    around, up = np.meshgrid(np.linspace(0, 2 * np.pi, 61), np.linspace(-np.pi / 2, np.pi / 2, 31))
    axes.plot_wireframe(np.cos(around) * np.cos(up), np.sin(around) * np.cos(up), np.sin(up), color=GREY, linewidth=0.4,
                        rstride=5, cstride=5)
    for label, curve in named.items():
        axes.plot(*_core.directions(curve._core.drawn()[1], direction).T, label=label)
    keys = [_core.directions(curve._keys._core.orientations, direction) for curve in named.values()]
    for dots in {rows.tobytes(): rows for rows in keys if len(rows) <= _core.most_marked_keys}.values():
        axes.scatter(*dots.T, color=INK, s=14, depthshade=False)
    middle = keys[0].mean(axis=0)
    axes.view_init(elev=25, azim=np.degrees(np.arctan2(middle[1], middle[0])) if np.hypot(*middle[:2]) > 1e-9 else -60)
    axes.set(xlabel="x", ylabel="y", zlabel="z", xticks=(-1, 0, 1), yticks=(-1, 0, 1), zticks=(-1, 0, 1),
             title=f"body axis {name} on the unit sphere")
    axes.set_box_aspect((1, 1, 1))
    if len(named) > 1:
        axes.legend()
    return axes


def _named(curves: Curves) -> dict[str, Any]:
    """Curves by their names; those of the same method are numbered."""
    if isinstance(curves, CurvePictures):
        return {curves._core.method: curves}
    if isinstance(curves, Mapping):
        named = {str(name): curve for name, curve in curves.items()}
    elif isinstance(curves, Iterable):
        named = {}
        for curve in curves:
            method = curve.method if isinstance(curve, CurvePictures) else ""  # type: ignore[attr-defined]
            named[method if method not in named else f"{method} ({len(named) + 1})"] = curve
    else:
        raise TypeError(f"curves: found {type(curves).__name__}, wanted curves")
    for curve in named.values():
        if not isinstance(curve, CurvePictures):
            raise TypeError(f"curves: found {type(curve).__name__} among them, wanted curves")
    if not named:
        raise ArgumentError("curves: found none, wanted one at least")
    kinds = {(curve._clock.unit, curve._clock.is_calendar) for curve in named.values()}
    if len(kinds) > 1:
        raise ArgumentError("curves: found times of different kinds, wanted the same for all")
    return named


def _charts(named: dict[str, Any], reference: Any, axes: Any, quantities: str | Sequence[str], ghosts: int) -> Any:
    if reference is not None:
        _check_reference(reference, next(iter(named.values()))._clock)
    words = [quantities] if isinstance(quantities, str) else list(quantities)
    titles = _core.titles_of_charts
    for word in words:
        if word not in titles:
            raise ArgumentError(f"quantities: found {word!r}, wanted some of {', '.join(map(repr, titles))}")
    if not words and reference is None:
        raise ArgumentError("quantities: found none, wanted one at least")
    count = ghost_count(ghosts)
    labels = [*(["angle to the reference [deg]"] if reference is not None else []), *(titles[word] for word in words)]
    axes = _axes(axes, len(labels) + (1 if count else 0))
    for label, chart in zip(labels, axes):
        chart.set_ylabel(label.replace(" [", "\n["))
    for chart in axes:
        _mark_keys(chart, named.values())
    for name, curve in named.items():
        seconds, orientations, values = curve._core.drawn()
        times = curve._clock.back(seconds)
        if reference is not None:
            axes[0].plot(*_errors(name, curve, times, orientations, reference), label=name)
        for word, chart in zip(words, axes[len(labels) - len(words):]):
            chart.plot(times, values[word], label=name)
    if count:
        draw_ghosts(axes[-1], list(named.values()), [line.get_color() for line in axes[0].get_lines()[-len(named):]], count)
    clock = next(iter(named.values()))._clock
    axes[-1].set_xlabel("time" if clock.is_calendar else f"time [{clock.unit}]")
    if clock.is_calendar:
        _date(axes)
    if len(named) > 1:
        axes[0].legend()
    return axes


def _date(axes: Any) -> None:
    """Dates on the axis of times, those of all marks once."""
    from matplotlib import dates
    formatter: Any = dates.ConciseDateFormatter
    for chart in axes:
        chart.xaxis.set_major_formatter(formatter(chart.xaxis.get_major_locator()))


def _check_reference(reference: Any, clock: Clock) -> None:
    if not isinstance(reference, (Keys, CurvePictures)):
        raise TypeError(f"reference: found {type(reference).__name__}, wanted a Curve or Keys")
    if (reference._clock.unit, reference._clock.is_calendar) != (clock.unit, clock.is_calendar):
        raise ArgumentError("reference: found times of another kind than those of the curves, wanted the same")


def _pyplot() -> Any:
    try:
        from matplotlib import pyplot
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError("found no matplotlib, wanted it for charts: pip install 'orispline[plot]'") from error
    return pyplot


def _axes(axes: Any, count: int) -> Any:
    if axes is None:
        _, axes = _pyplot().subplots(count, 1, sharex=True, squeeze=False, figsize=(CHART[0], CHART[1] * count + 0.4),
                                  layout="constrained")
    axes = np.atleast_1d(np.asarray(axes, dtype=object)).ravel()
    if len(axes) != count:
        raise ArgumentError(f"axes: found {len(axes)}, wanted one for each of the {count} charts")
    return axes


def _mark_keys(chart: Any, curves: Iterable[Any]) -> None:
    for times in {curve._keys._core.times.tobytes(): curve._keys.times for curve in curves}.values():
        if len(times) <= _core.most_marked_keys:
            chart.vlines(times, 0, 1, transform=chart.get_xaxis_transform(), color=GREY, linewidth=0.8, linestyle=(0, (3, 3)))


def _errors(name: str, curve: Any, times: Any, orientations: Array, reference: Any) -> tuple[Any, Array]:
    """Times and angles [deg], at those times of a curve or at those of a recording that both have."""
    first, last = (curve if isinstance(reference, Keys) else reference).domain
    if isinstance(reference, Keys):
        times, orientations = reference.times, reference._core.orientations
    inside = (times >= first) & (times <= last)
    if not inside.any():
        first, last = curve.domain
        raise DataError(f"reference: found none of its times from {first} to {last}, where {name!r} is, wanted one at least")
    times, one = times[inside], np.ascontiguousarray(orientations[inside])
    other = curve if isinstance(reference, Keys) else reference
    seconds, angles = _core.drawn_errors(curve._clock.seconds("reference", times), one, _in_order(other, other(times)))
    return curve._clock.back(seconds), angles


def _in_order(curve: Any, orientations: Array) -> Array:
    """x, y, z, w."""
    return np.ascontiguousarray(orientations[:, [1, 2, 3, 0]]) if curve._scalar_first else orientations


def _body_axis(axis: Any) -> tuple[Array, str]:
    if isinstance(axis, str):
        if axis not in AXES:
            raise ArgumentError(f"axis: found {axis!r}, wanted 'x', 'y', 'z' or three numbers")
        return np.array(AXES[axis]), axis
    direction = numbers("axis", axis, (3,))
    length = float(np.linalg.norm(direction))
    if not 0.0 < length < np.inf:
        raise ArgumentError(f"axis: found {direction.tolist()}, wanted a direction of finite length greater than 0")
    return direction / length, f"({', '.join(f'{x:g}' for x in direction)})"


def _start_text(clock: Clock) -> str:
    """The caller's own time at 0 s of the library [s], exactly."""
    import decimal
    digits = len(str(PER_SECOND[clock.unit])) - 1
    return format(decimal.Decimal(clock.origin).scaleb(-digits, decimal.Context(prec=40)), "f")
