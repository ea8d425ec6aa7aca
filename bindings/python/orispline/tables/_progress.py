# SPDX-License-Identifier: Apache-2.0
"""How far a job is: told to a function, or shown by a bar."""
from __future__ import annotations

import contextlib
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from typing import Any

from .._checks import wrong_type

Progress = Callable[[float], None]
WIDTH = 30  # of the bar
BETWEEN_SHOWS = 0.2  # s


@contextlib.contextmanager
def telling(progress: Progress | bool | None, total: int | None) -> Iterator[Callable[[int], None]]:
    """What to tell so many of the keys that are done: a function that wants their share, where it is known how many there are, or a
    bar, which is gone when all are."""
    if progress is None or progress is False:
        yield lambda done: None
    elif progress is not True:
        yield lambda done: progress(done / total if total else done)
    elif (tqdm := _tqdm()) is None:
        bar = Bar()
        try:
            yield lambda done: bar.keys(done / total if total else done)
        finally:
            bar.clear()
    else:
        with tqdm(total=total, unit=" keys", unit_scale=True) as shown:
            yield lambda done: shown.update(done - shown.n)


def check(progress: Progress | bool | None) -> None:
    """Raises TypeError for what nothing can be told."""
    if progress is not None and not isinstance(progress, bool) and not callable(progress):
        raise wrong_type("progress", progress, "True for a bar, or a function that is told which share is done")


def _tqdm() -> Callable[..., contextlib.AbstractContextManager[Any]] | None:
    """The bar of that package, where it is installed."""
    try:
        from tqdm.auto import tqdm
    except ImportError:
        return None
    return tqdm  # type: ignore[no-any-return]


class Bar:
    """A line on standard error that says how far a job is."""

    def __init__(self) -> None:
        self._began = self._last = time.monotonic()
        self._share, self._rows = 0.0, 0

    def keys(self, share: float) -> None:
        """So many of the keys are done: a share, or a number."""
        self._share = share
        self._show()

    def rows(self, count: int) -> None:
        """So many rows are written."""
        self._rows = count
        self._show()

    def _show(self) -> None:
        now = time.monotonic()
        if now - self._last < BETWEEN_SHOWS:
            return
        self._last = now
        done = f"{self._share:.0f} keys" if self._share > 1 else \
            f"[{'#' * round(WIDTH * self._share):<{WIDTH}}] {self._share:4.0%}"
        self._write(f"{done}{f'  {self._rows} rows' if self._rows else ''}  {now - self._began:.0f} s")

    def clear(self) -> None:
        """Takes the line away."""
        self._write("")

    @staticmethod
    def _write(text: str) -> None:
        columns = shutil.get_terminal_size().columns
        sys.stderr.write(f"\r{text[:columns - 1]:<{columns - 1}}\r{text[:columns - 1]}")
        sys.stderr.flush()
