# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, as exceptions: each is an `orispline.Error` and the built-in one that fits. What is noteworthy, as warnings."""
from __future__ import annotations

import contextlib
import contextvars
import sys
import warnings
from collections.abc import Iterable, Iterator
from typing import Any


class Error(Exception):
    """Something that the library could not do. Its text says what was found and what was wanted.

    Attributes, None where there is no such place: `key` (0-based index of a keyframe, or of the row that was given), `joint` (0-based, of a stack),
    `time_index` (0-based, among the times that were asked for), `file`, `line` and `column` (1-based), `argument` (the name
    of the one at fault).
    """

    key: int | None = None
    joint: int | None = None
    time_index: int | None = None
    file: str | None = None
    line: int | None = None
    column: int | None = None
    argument: str | None = None
    _cure: str = ""  # behind the text, where the call that failed has what mends it

    def __str__(self) -> str:
        return super().__str__() + self._cure


class DataError(Error, ValueError):
    """The keyframes, or the content of a file."""


def at_key(key: int, message: str) -> DataError:
    """About a key, to be raised."""
    error = DataError(f"key {key}: {message}")
    error.key = key
    return error


class ArgumentError(Error, ValueError):
    """A method, a setting, an end rule or another argument."""


class ConvergenceError(Error, ArithmeticError):
    """The equations of a method have no solution for these keys that could be found."""


class AccessError(Error, OSError):
    """A file that cannot be opened, read or written."""


class ShapeWarning(UserWarning):
    """Something noteworthy about a result. Its text is the library's.

    Attributes: `code`, what programs go by, such as `"loose_bounds"`; `numbers`, those of the text, by names with units.
    """

    def __init__(self, message: str, code: str = "", numbers: dict[str, float] | None = None) -> None:
        super().__init__(message)
        self.code = code
        self.numbers = numbers or {}


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
