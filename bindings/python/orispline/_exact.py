# SPDX-License-Identifier: Apache-2.0
"""Numbers that are no doubles: objects, decimals, fractions and long doubles."""
from __future__ import annotations

import numbers
from typing import TYPE_CHECKING, Any

import numpy as np

from ._errors import ArgumentError

if TYPE_CHECKING:
    import fractions

MOST_LOST = 1e-9  # [s] of a time


def plain_numbers(name: str, array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """The nearest doubles of objects that are numbers and of long doubles, and integers where all are whole; other objects as they
    are. Raises ArgumentError for times that would lose digits which count, and for periods, which are none."""
    if array.dtype.kind != "O":
        return _checked(name, array, array.astype(np.float64))
    import decimal
    objects = list(array.reshape(-1))
    if objects and all(type(thing).__name__ == "Period" for thing in objects):
        raise ArgumentError(f"{name}: found periods, wanted times: .to_timestamp() has those at which they begin")
    if not objects or any(isinstance(thing, bool) or not isinstance(thing, (numbers.Real, decimal.Decimal)) for thing in objects):
        return array
    whole = all(isinstance(thing, numbers.Integral) for thing in objects)
    try:
        doubles = array.astype(np.int64 if whole else np.float64)
    except (OverflowError, ValueError):  # beyond 64 bits, or a decimal that signals
        raise ArgumentError(f"{name}: found numbers that no double is near to, wanted finite ones below 1e308") from None
    return doubles if whole else _checked(name, array, doubles)


def _checked(name: str, exact: np.ndarray[Any, Any], doubles: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    if name == "times":
        lost = max((float(abs(_fraction(one) - _fraction(other))) for one, other in zip(exact.reshape(-1), doubles.reshape(-1)) if np.isfinite(other)),
                   default=0.0)
        if lost > MOST_LOST:
            raise ArgumentError(f"times: found {type(exact.reshape(-1)[0]).__name__} that would be rounded by {lost:.2g} s, wanted seconds that "
                                "doubles hold: take the first one from all of them, or give datetime64")
    return doubles


def _fraction(number: Any) -> fractions.Fraction:
    import fractions
    return fractions.Fraction(*number.as_integer_ratio())
