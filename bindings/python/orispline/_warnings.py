# SPDX-License-Identifier: Apache-2.0
"""What the library finds noteworthy, as warnings of Python."""
from __future__ import annotations

import sys
import warnings
from collections.abc import Iterable
from typing import Any

from ._errors import ShapeWarning


def tell(found: Iterable[tuple[Any, ...]]) -> None:
    """Warns where the caller of the package stands: of messages, with their codes and numbers."""
    level, frame = 1, sys._getframe()
    while frame.f_back is not None and frame.f_globals.get("__package__") == __package__:
        level, frame = level + 1, frame.f_back
    for warning in found:
        warnings.warn(ShapeWarning(*warning), stacklevel=level)
