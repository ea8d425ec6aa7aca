# SPDX-License-Identifier: Apache-2.0
"""Arguments as the texts in which the library reads them: a number has one way of being read."""
from __future__ import annotations

from typing import Any, Mapping

import numpy as np

from ._checks import flag, real, text, wrong_type
from ._errors import ArgumentError


def rate_text(rate: Any) -> str:
    """A number, or a fraction such as `30000/1001`."""
    import fractions
    if isinstance(rate, fractions.Fraction):
        return f"{rate.numerator}/{rate.denominator}"
    if isinstance(rate, str):
        try:
            if fractions.Fraction(rate) > 0:
                return rate
        except (ValueError, ZeroDivisionError):
            pass
    elif not isinstance(rate, (bool, np.bool_)) and np.ndim(rate) == 0 and np.asarray(rate).dtype.kind in "fiu" \
            and np.isfinite(rate) and rate > 0:
        return repr(rate.item() if isinstance(rate, np.generic) else rate)
    raise ArgumentError(f"rate: found {rate!r}, wanted a number of samples per second greater than 0")


def _value_text(name: str, value: Any) -> str:
    if isinstance(value, str):
        return value
    if isinstance(value, (bool, np.bool_)):
        return str(int(value))
    try:
        array = np.asarray(value, dtype=np.float64)
    except (TypeError, ValueError):
        raise ArgumentError(f"{name}: found {value!r}, wanted a number, one for each key, or a word") from None
    if array.ndim > 1:
        raise ArgumentError(f"{name}: found the shape {array.shape}, wanted a number or one for each key")
    return ",".join(repr(float(x)) for x in np.atleast_1d(array))


def _ends_text(ends: Any) -> str:
    rules = [ends] if isinstance(ends, str) else list(ends) if isinstance(ends, (tuple, list)) else []
    if not rules or (len(rules) != 2 and rules != [ends]) or not all(isinstance(rule, str) for rule in rules):
        raise wrong_type("ends", ends, "a rule, or a pair of rules for start and end")
    return ",".join(rules)


def method_text(method: str, ends: Any, start_rate: Any, end_rate: Any, closed: bool, period: float | None,
                 settings: Mapping[str, Any]) -> str:
    """`NAME:SETTING=VALUE:…`, the one form in which the library reads methods."""
    pieces = [text("method", method)]
    pieces += [f"{name}={_value_text(name, value)}" for name, value in settings.items()]
    if ends is not None:
        pieces.append(f"ends={_ends_text(ends)}")
    for name, rate in (("start_rate", start_rate), ("end_rate", end_rate)):
        if rate is not None:
            if np.shape(rate) != (3,):
                raise ArgumentError(f"{name}: found the shape {np.shape(rate)}, wanted (3,)")
            if np.asarray(rate).dtype.kind not in "fiu" or not np.isfinite(rate).all():
                raise ArgumentError(f"{name}: found {np.asarray(rate).tolist()}, wanted three finite numbers")
            pieces.append(f"{name}={_value_text(name, rate)}")
    if flag("closed", closed):
        pieces.append("closed")
    if period is not None:
        pieces.append(f"period={real('period', period)!r}")
    return ":".join(pieces)
