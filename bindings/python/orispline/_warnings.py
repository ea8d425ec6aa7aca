# SPDX-License-Identifier: Apache-2.0
"""What the library finds noteworthy, as warnings of Python."""
from __future__ import annotations

import contextlib
import contextvars
import sys
import warnings
from collections.abc import Iterable, Iterator
from typing import Any

from ._errors import ShapeWarning

_collection: contextvars.ContextVar[list[ShapeWarning] | None] = contextvars.ContextVar("collection", default=None)


def tell(found: Iterable[tuple[Any, ...]]) -> None:
    """Warns where the caller of the package stands: of messages, with their codes and numbers."""
    collection = _collection.get()
    if collection is not None:
        collection += [ShapeWarning(*warning) for warning in found]
        return
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and _is_ours(frame.f_globals.get("__package__")):
        level, frame = level + 1, frame.f_back
    for warning in found:
        warnings.warn(ShapeWarning(*warning), stacklevel=level)


@contextlib.contextmanager
def collected() -> Iterator[list[ShapeWarning]]:
    """Those of this thread, as a list instead of warnings."""
    found: list[ShapeWarning] = []
    before = _collection.set(found)
    try:
        yield found
    finally:
        _collection.reset(before)


def _is_ours(package: str | None) -> bool:
    return package is not None and (package == __package__ or package.startswith(f"{__package__}."))
