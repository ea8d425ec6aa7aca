# SPDX-License-Identifier: Apache-2.0
"""What matplotlib draws of curves: charts over time, the sphere, and the body at even times."""
from __future__ import annotations

from typing import Any, Iterable, Mapping, Sequence

import numpy as np

from . import _core
from ._arrays import Array, numbers
from ._checks import whole, wrong_type
from ._errors import ArgumentError, DataError
from ._keys import Keys
from ._look import colours, labels, look

AXES = {"x": (1.0, 0.0, 0.0), "y": (0.0, 1.0, 0.0), "z": (0.0, 0.0, 1.0)}
CHART = (8.0, 2.1)  # inches
GHOST = 0.33  # inches, of a body where there is room for it
CHARTED = ("angle", "rate", "acceleration", "jerk")


def charts(named: Mapping[str, Any], reference: Any, axes: Any, quantities: str | Sequence[str] | None, ghosts: int, usual: Sequence[str],
           ax: Any) -> Any:
    """Charts over time of curves by their names, with those of the errors to a reference, and the bodies. Without quantities the usual
    ones, as many as there are axes for."""
    axes = one_of_axes(axes, ax)
    if quantities is None:
        others = (reference is not None) + bool(ghosts)
        quantities = usual if axes is None else usual[:max(np.size(axes) - others, 0)]
    if not isinstance(quantities, (str, list, tuple)):
        raise wrong_type("quantities", quantities, "a word, or a list of them")
    words = [quantities] if isinstance(quantities, str) else list(quantities)
    for word in words:
        if not isinstance(word, str) or word not in CHARTED:
            raise ArgumentError(f"quantities: found {word!r}, wanted some of {', '.join(map(repr, CHARTED))}")
    if not words and reference is None:
        raise ArgumentError("quantities: found none, wanted one at least")
    count = _ghost_count(ghosts)
    shown = ["error", *words] if reference is not None else words
    axes = _axes(axes, len(shown) + (1 if count else 0))
    for word, chart in zip(shown, axes):
        chart.set_ylabel(labels()[word].replace(" [", "\n["))
    for chart in axes:
        _mark_keys(chart, named.values())
    for name, curve in named.items():
        seconds, orientations, values = curve._core.drawn()
        times = curve._clock.charted(seconds)
        if reference is not None:
            axes[0].plot(*_errors(name, curve, curve._clock.back(seconds), orientations, reference), label=name)
        for word, chart in zip(words, axes[len(shown) - len(words):]):
            chart.plot(times, values[word], label=name)
    if count:
        _draw_ghosts(axes[-1], list(named.values()), [line.get_color() for line in axes[0].get_lines()[-len(named):]], count)
    clock = next(iter(named.values()))._clock
    axes[-1].set_xlabel(clock.axis)
    if clock.is_calendar:
        _date(axes)
    if len(named) > 1:
        axes[0].legend()
    return axes


def one_of_axes(axes: Any, ax: Any) -> Any:
    """The one of two names of axes that is given."""
    if axes is not None and ax is not None:
        raise ArgumentError("ax: found it beside axes, wanted one of them: both mean the same")
    return axes if ax is None else ax


def sphere(named: Mapping[str, Any], axis: Any, axes: Any, ax: Any = None) -> Any:
    """The paths of a body axis over the unit sphere, of curves by their names."""
    axes = one_of_axes(axes, ax)
    direction, name = _body_axis(axis)
    if axes is None:
        axes = _pyplot().figure(figsize=(6, 6), layout="constrained").add_subplot(projection="3d")
        _take_turns(axes)
    elif getattr(axes, "name", "") != "3d":
        raise ArgumentError("axes: found flat ones, wanted Axes of three dimensions, projection='3d'")
    around, up = np.meshgrid(np.linspace(0, 2 * np.pi, 61), np.linspace(-np.pi / 2, np.pi / 2, 31))
    axes.plot_wireframe(np.cos(around) * np.cos(up), np.sin(around) * np.cos(up), np.sin(up), color=look()["light"]["grid"],
                        linewidth=0.6, rstride=5, cstride=5)
    for label, curve in named.items():
        axes.plot(*_core.directions(curve._core.drawn()[1], direction).T, label=label)
    keys = [_core.directions(_marked(curve)[1], direction) for curve in named.values()]
    for dots in {rows.tobytes(): rows for rows in keys if len(rows) <= _core.most_marked_keys}.values():
        axes.scatter(*dots.T, color=look()["light"]["ink"], s=14, depthshade=False)
    middle = keys[0].mean(axis=0)
    axes.view_init(elev=25, azim=np.degrees(np.arctan2(middle[1], middle[0])) if np.hypot(*middle[:2]) > 1e-9 else -60)
    axes.set(xlabel="x", ylabel="y", zlabel="z", xticks=(-1, 0, 1), yticks=(-1, 0, 1), zticks=(-1, 0, 1),
             title=f"body axis {name} on the unit sphere")
    axes.set_box_aspect((1, 1, 1))
    if len(named) > 1:
        axes.legend()
    return axes


def _date(axes: Any) -> None:
    """Dates on the axis of times, those of all marks once."""
    from matplotlib import dates
    formatter: Any = dates.ConciseDateFormatter
    for chart in axes:
        chart.xaxis.set_major_formatter(formatter(chart.xaxis.get_major_locator()))


def _pyplot() -> Any:
    try:
        from matplotlib import pyplot
    except ModuleNotFoundError as error:
        raise ModuleNotFoundError("found no matplotlib, wanted it for charts: pip install 'orispline[plot]'") from error
    return pyplot


def _take_turns(axes: Any) -> None:
    """The colours and widths of the curves that will be drawn, in axes of our own; those of others have a cycle of theirs."""
    widths = look()["widths"]
    axes.set_prop_cycle(color=colours(), linewidth=[widths["first"], *[widths["second"]] * (len(colours()) - 1)])


def _axes(axes: Any, count: int) -> Any:
    if axes is None:
        _, axes = _pyplot().subplots(count, 1, sharex=True, squeeze=False, figsize=(CHART[0], CHART[1] * count + 0.4),
                                  layout="constrained")
        for chart in axes.flat:
            _take_turns(chart)
    given, axes = axes, np.atleast_1d(np.asarray(axes, dtype=object)).ravel()
    if not all(hasattr(chart, "set_ylabel") for chart in axes):
        raise wrong_type("axes", given, "matplotlib Axes, one or several")
    if len(axes) != count:
        raise ArgumentError(f"axes: found {len(axes)}, wanted one for each of the {count} charts")
    return axes


def _mark_keys(chart: Any, curves: Iterable[Any]) -> None:
    marked = [(curve._clock, _marked(curve)[0]) for curve in curves]
    for times in {seconds.tobytes(): clock.charted(seconds) for clock, seconds in marked}.values():
        if len(times) <= _core.most_marked_keys:
            chart.vlines(times, 0, 1, transform=chart.get_xaxis_transform(), color=look()["light"]["reference"], linewidth=0.6,
                         linestyle=(0, (3, 3)))


def _marked(curve: Any) -> tuple[Array, Array]:
    """Times [s] and orientations of its keys, or of the knots of a curve that is made of curves."""
    keys = getattr(curve, "keys", None)
    return (keys._core.times, keys._core.orientations) if isinstance(keys, Keys) else (curve._core.knots, curve._quaternions(curve.times))


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
    return curve._clock.charted(seconds), angles


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


def _ghost_count(ghosts: int) -> int:
    """As many bodies per curve; none, or from 2 on."""
    count = whole("ghosts", ghosts, 0, _core.most_ghosts)
    if count == 1:
        raise ArgumentError(f"ghosts: found 1, wanted a whole number from 2 to {_core.most_ghosts}, or 0 for none")
    return count


def _draw_ghosts(chart: Any, curves: Sequence[Any], colors: Sequence[Any], count: int) -> None:
    """The body of each curve at even times, a row per curve, all of one size whatever the scales of the chart."""
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import to_rgba
    size = min(GHOST, 0.55 * chart.bbox.width / chart.figure.dpi / count)
    for row, (curve, color) in enumerate(zip(curves, colors)):
        seconds, faces, opacities = curve._core.ghosts(count)
        times = curve._clock.charted(seconds)
        chart.xaxis.update_units(times)
        places = np.column_stack([chart.convert_xunits(times), np.full(len(times), -float(row))])
        bodies = PolyCollection(faces.reshape(-1, 3, 2) * (size, -size), facecolors=[to_rgba(color, o) for o in opacities],
                                edgecolors=color, linewidths=0.6, offsets=places, offset_transform=chart.transData,
                                clip_on=False, zorder=2)
        bodies.set_transform(chart.figure.dpi_scale_trans)
        chart.add_collection(bodies, autolim=False)
        chart.update_datalim(places)
    chart.autoscale_view(scaley=False)
    chart.set(yticks=[], ylim=(0.5 - len(curves), 0.5), ylabel=f"the body at\n{count} even times")
