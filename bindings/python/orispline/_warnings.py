# SPDX-License-Identifier: Apache-2.0
"""What the library finds noteworthy, as warnings of Python."""
from __future__ import annotations

import sys
import warnings

from ._errors import ShapeWarning


def tell(found: list[tuple[str, str, dict[str, float]]]) -> None:
    """Warns where the caller of the package stands."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    for message, code, numbers in found:
        warnings.warn(ShapeWarning(message, code, numbers), stacklevel=level)
