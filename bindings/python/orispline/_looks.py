# SPDX-License-Identifier: Apache-2.0
"""How a curve looks: charts, the sphere, pages and what a notebook shows."""
from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from ._arrays import inertia_tensor
from ._charts import CHARTED, charts, sphere
from ._checks import text
from ._clock import Clock
from ._files import Target, target_of
from ._view import HEIGHT, View, now, write_page

if TYPE_CHECKING:
    import pathlib

    from ._keys import Keys
    from .notebook import Widget


class Looks:
    """What can be drawn."""

    __slots__ = ()
    _core: Any
    _clock: Clock
    _keys: Keys

    def plot(self, axes: Any = None, quantities: str | Sequence[str] | None = None, *, ghosts: int = 0, ax: Any = None) -> Any:
        """Charts over time by matplotlib: the angle from the start [deg], |ω| [rad/s], |α| [rad/s²] and |jerk| [rad/s³], the
        keys marked, and both sides of every jump. The peaks of a long curve are not missed.

        With `ghosts`, 2 to 60, the body itself stands below at so many even times from start to end, as `orispline plot
        --ghosts` draws it: that is one more chart.

        `axes`, or `ax`, are as many matplotlib Axes as charts, or one of them, or None for a new figure. Without `quantities` the first
        of these are drawn, as many as there are Axes: in one the angle. Returns an array of these Axes; nothing is shown. Raises
        ArgumentError for a quantity that there is not, for another number of axes and of ghosts.

        >>> import matplotlib, orispline as ori
        >>> matplotlib.use("Agg")
        >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
        >>> [axes.get_ylabel() for axes in curve.plot(quantities="rate")]
        ['angular velocity |ω|\\n[rad/s]']
        >>> len(curve.plot(ghosts=12))
        5
        """
        return charts({self._core.method: self}, None, axes, quantities, ghosts, CHARTED, ax)

    def plot_sphere(self, axis: Any = "x", axes: Any = None, *, ax: Any = None) -> Any:
        """The path of a body axis over the unit sphere, with the keys: `orispline.plot_sphere` of this curve."""
        return sphere({self._core.method: self}, axis, axes, ax)

    def report(self, path: Target, *, title: str = "", inertia: Any = None) -> None:
        """Writes a page to look at in a browser: the motion in space, on the sphere and over time, and its measures; with an
        inertia (as of `Curve.energies`) its torques too. One HTML file that needs nothing else; it appears complete or not
        at all. Raises AccessError where it cannot be written.

        >>> import os, tempfile, orispline as ori
        >>> page = os.path.join(tempfile.mkdtemp(), "motion.html")
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]).report(page)
        >>> os.path.exists(page)
        True
        """
        target_of(path)  # before the work
        write_page(path, self._core.page(*self._head(title, inertia)))

    def view(self, *, height: int = HEIGHT, title: str = "", inertia: Any = None) -> View:
        """The page of `report` for a notebook, as high as that [px]. Without it a notebook shows a small drawing of the curve."""
        return View._of(self._core.page(*self._head(title, inertia)), height)

    def widget(self, *, height: int = HEIGHT, title: str = "") -> Widget:
        """A `orispline.notebook.Widget` of this curve: the page, and below it a table in which its keys are edited, of which Python
        hears. Needs anywidget, `pip install 'orispline[notebook]'`."""
        from .notebook import Widget
        return Widget(self, height=height, title=title)  # type: ignore[arg-type]

    def _head(self, title: str, inertia: Any) -> tuple[Any, ...]:
        """What the core asks for a page."""
        return text("title", title), now(), self._clock.epoch, None if inertia is None else inertia_tensor(inertia)

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
        title = f"{count} key{'' if count == 1 else 's'}, {self._clock.span(self._keys._core.times)}"
        return str(self._core.svg(title))
