# SPDX-License-Identifier: Apache-2.0
"""What goes wrong, as exceptions: each is an `orispline.Error` and the built-in one that fits."""
from __future__ import annotations


class Error(Exception):
    """Something that the library could not do. Its text says what was found and what was wanted.

    Attributes, None where there is no such place: `key` (0-based index of a keyframe), `time_index` (0-based, among the
    times that were asked for), `file`, `line` and `column` (1-based), `argument` (the name of the one at fault).
    """

    key: int | None = None
    time_index: int | None = None
    file: str | None = None
    line: int | None = None
    column: int | None = None
    argument: str | None = None


class DataError(Error, ValueError):
    """The keyframes, or the content of a file."""


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
