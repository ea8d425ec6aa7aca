# SPDX-License-Identifier: Apache-2.0
"""The widget: what it shares with the page, and what it does with an edit."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import anywidget
import numpy as np
import traitlets

from .. import _core
from .._checks import text, whole, wrong_type
from .._errors import ArgumentError, Error
from .._keys import Keys
from .._view import HEIGHT, LEAST_HEIGHT, MOST_HEIGHT
from ._editing import edited

if TYPE_CHECKING:
    from .._curve import Curve

CURVE = Keys._curve_class  # its module knows this one
CLOSE = 1e-9  # [s] times nearer to each other are the same: dates have whole nanoseconds


class Page(anywidget.AnyWidget):
    """What Python and the page share. It is not the widget itself, since every widget of Jupyter has `keys` of another kind."""

    _esm, _css = _core.page_module()
    document = traitlets.Bytes().tag(sync=True)  # that the viewer shows, JSON
    rows = traitlets.Bytes().tag(sync=True)  # float64: of each key t, qw, qx, qy, qz, and px, py, pz where they have positions
    width = traitlets.Int(5).tag(sync=True)  # numbers in a row
    seconds = traitlets.Float().tag(sync=True)  # the time as the page has it
    version = traitlets.Int().tag(sync=True)  # of these rows: it counts their changes
    edit = traitlets.Dict().tag(sync=True)  # the last one of the page, as edited() takes it, with its number and the version it is of
    answered = traitlets.Int().tag(sync=True)  # the number of the last one that Python has looked at
    refusal = traitlets.Unicode().tag(sync=True)  # why that one was refused; empty: it was not
    height = traitlets.Int(HEIGHT).tag(sync=True)  # of the viewer [px]


class Widget(traitlets.HasTraits):
    """A curve with its keys in a table below it, where they are changed, added and taken away.

    Python hears of it: `widget.observe(f, names="keys")`, as of every widget of Jupyter, also for `"time"`. Both are shared: what
    Python sets is what the page shows. A bad edit, such as two keys at one time, is answered with a sentence, and the keys stay
    what they were.

    Parameters
    ----------
    keys : Curve or Keys
    method : str, Blending or Curve, optional
        Of the curve through keys; without it that of the file which they are from, if it names one, else `auto`.
    height : int
        Of the view above the table [px].
    title : str
        Above all.

    Attributes
    ----------
    keys
        As they are now, a `Keys`.
    time
        The moment that is shown, as the times of the keys are.
    page
        The widget of Jupyter, for boxes of ipywidgets.

    Examples
    --------
    >>> import orispline as ori
    >>> from orispline.notebook import Widget
    >>> widget = Widget(ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]))
    >>> widget.observe(lambda change: print(change.new), names="keys")
    >>> widget.keys = widget.keys[:2]
    Keys(2 keys, 0 … 1 s)
    >>> widget.time, widget.curve.keys is widget.keys
    (0.0, True)
    """

    keys = traitlets.Any()
    time = traitlets.Any()

    def __init__(self, keys: Curve | Keys, method: Any = None, *, height: int = HEIGHT, title: str = "") -> None:
        if not isinstance(keys, (CURVE, Keys)):
            raise wrong_type("keys", keys, "Keys or a Curve")
        self._curve: Curve = keys.curve(method) if isinstance(keys, Keys) else keys if method is None else keys.keys.curve(method)
        self._title = text("title", title)
        self.page = Page(height=whole("height", height, LEAST_HEIGHT, MOST_HEIGHT))
        super().__init__(keys=self._curve.keys, time=self._curve.domain[0])
        self.page.observe(self._hear, names="edit")
        self.page.observe(self._moved, names="seconds")

    @property
    def curve(self) -> Curve:
        """The curve through the keys. Keys that are set or edited get its method; set another curve for another one."""
        return self._curve

    @curve.setter
    def curve(self, curve: Curve) -> None:
        if not isinstance(curve, CURVE):
            raise wrong_type("curve", curve, "a Curve")
        self._curve, was = curve, self.keys
        self.keys = curve.keys
        if curve.keys == was:
            self._show()

    @traitlets.validate("keys")
    def _curve_through(self, proposal: Any) -> Keys:
        keys = proposal.value
        if not isinstance(keys, Keys):
            raise wrong_type("keys", keys, "Keys")
        if keys is not self._curve.keys:
            self._curve = self._curve._with(keys)
        return keys

    @traitlets.observe("keys")
    def _show(self, _: Any = None) -> None:
        core = self.keys._core
        rows = np.hstack([core.times[:, None], core.orientations[:, [3, 0, 1, 2]], *([] if core.positions is None else [core.positions])])
        with self.page.hold_sync():
            self.page.document = self._curve._core.page_data(*self._curve._head(self._title, None))
            self.page.rows, self.page.width = rows.astype("<f8").tobytes(), rows.shape[1]
            self.page.version += 1
            if self.time is not None:
                self.time = self._within(self.time)

    @traitlets.validate("time")
    def _time_within(self, proposal: Any) -> Any:
        return self._within(proposal.value)

    def _within(self, time: Any) -> Any:
        return self._curve._clock.time(self._second(time))

    def _second(self, time: Any) -> float:
        """A time as the page has it, within the curve."""
        first, last = self._curve._core.domain
        return float(np.clip(self._curve._clock.seconds("time", time), first, last))

    @traitlets.observe("time")
    def _move(self, change: Any) -> None:
        second = self._second(change.new)
        if abs(second - self.page.seconds) > CLOSE:
            self.page.seconds = second

    def _moved(self, change: Any) -> None:
        if abs(self._second(self.time) - change.new) > CLOSE:
            self.time = self._curve._clock.time(change.new)

    def _hear(self, change: Any) -> None:
        """An edit of the page, which changes the keys or is refused."""
        edit, refusal = change.new, ""
        with self.page.hold_sync():
            try:
                if edit.get("version") != self.page.version:
                    raise ArgumentError("found an edit of keys that have changed since, wanted it again")
                self.keys = edited(self._curve, edit)
            except Error as error:
                refusal = str(error)
            self.page.refusal, self.page.answered = refusal, edit.get("number", 0)

    def _repr_mimebundle_(self, **options: Any) -> Any:
        return self.page._repr_mimebundle_(**options)

    def __repr__(self) -> str:
        return f"Widget({self._curve!r})"
