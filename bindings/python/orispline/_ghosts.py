# SPDX-License-Identifier: Apache-2.0
"""The body at even times, below the charts of a curve."""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np

from . import _core
from ._checks import whole
from ._errors import ArgumentError

GHOST = 0.33  # inches, of a body where there is room for it


def ghost_count(ghosts: int) -> int:
    """As many bodies per curve; none, or from 2 on."""
    count = whole("ghosts", ghosts, 0, _core.most_ghosts)
    if count == 1:
        raise ArgumentError(f"ghosts: found 1, wanted a whole number from 2 to {_core.most_ghosts}, or 0 for none")
    return count


def draw_ghosts(chart: Any, curves: Sequence[Any], colors: Sequence[Any], count: int) -> None:
    """The body of each curve at even times, a row per curve, all of one size whatever the scales of the chart."""
    from matplotlib.collections import PolyCollection
    from matplotlib.colors import to_rgba
    size = min(GHOST, 0.55 * chart.bbox.width / chart.figure.dpi / count)
    for row, (curve, color) in enumerate(zip(curves, colors)):
        seconds, faces, opacities = curve._core.ghosts(count)
        times = curve._clock.back(seconds)
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
