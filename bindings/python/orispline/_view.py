# SPDX-License-Identifier: Apache-2.0
"""Pages to look at: in a notebook, or as files for a browser."""
from __future__ import annotations

import datetime
import os

from . import _core
from ._checks import whole
from ._files import Target, target_of, write_bytes

HEIGHT = 640  # [px] of a page in a notebook, which is scrolled in its frame
LEAST_HEIGHT, MOST_HEIGHT = 100, 10_000


def now() -> str:
    """As a page says when it was made."""
    return datetime.datetime.now().strftime("%Y-%m-%d %H:%M")


class View:
    """A page to look at, of `view()` of a curve, a comparison and what other tasks find. A notebook shows it.

    The page is the one of `report`, in a frame of its own from which it can reach neither the notebook nor the network. It is a
    megabyte or so, which a notebook that is saved with its outputs holds for every view.

    >>> import orispline as ori
    >>> view = ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]).view(height=400)
    >>> view.height, view.html[:15]
    (400, '<!doctype html>')
    """

    __slots__ = ("_height", "_page")
    _height: int
    _page: bytes

    def __init__(self) -> None:
        raise TypeError("found a call of View, wanted one of view() of a curve or a result")

    @classmethod
    def _of(cls, page: bytes, height: int) -> View:
        view = cls.__new__(cls)
        view._page, view._height = page, whole("height", height, LEAST_HEIGHT, MOST_HEIGHT)
        return view

    @property
    def height(self) -> int:
        """Of the frame in a notebook [px]; it is as wide as there is room."""
        return self._height

    @property
    def html(self) -> str:
        """The whole page, which needs nothing else."""
        return self._page.decode("utf-8", "replace")

    def write(self, path: Target) -> None:
        """Writes the page as a file for a browser, which appears complete or not at all, or into a file object. AccessError: it
        cannot be written."""
        write_page(path, self._page)

    def _repr_html_(self) -> str:
        page = self.html.replace("&", "&amp;").replace('"', "&quot;")
        return (f'<iframe sandbox="allow-scripts" title="orispline" style="width: 100%; height: {self._height}px; border: 0" '
                f'srcdoc="{page}"></iframe>')

    def __repr__(self) -> str:
        return f"View({len(self._page) / 1e6:.1f} MB, {self._height} px high)"


class Viewed:
    """What has a page to look at."""

    __slots__ = ()

    def _page(self) -> bytes:
        raise NotImplementedError

    def report(self, path: Target) -> None:
        """Writes a page to look at, which needs nothing but a browser, as a file or into a file object. AccessError: the file
        cannot be written."""
        target_of(path)  # before the work
        write_page(path, self._page())

    def view(self, *, height: int = HEIGHT) -> View:
        """The page of `report` for a notebook, as high as that [px]."""
        return View._of(self._page(), height)


def write_page(path: Target, page: bytes) -> None:
    """As a file, whatever its name, `-` too, or into a file object."""
    name, file = target_of(path)
    write_bytes(os.path.join(os.curdir, name) if name == "-" else name, file, page)
