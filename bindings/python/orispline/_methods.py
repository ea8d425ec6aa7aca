# SPDX-License-Identifier: Apache-2.0
"""A method as the caller gives it, and the text form in which the library reads it."""
from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np

from ._checks import flag, real, wrong_type
from ._errors import ArgumentError

if TYPE_CHECKING:
    from ._blending import Blending


class OwnMethod(str):
    """The text form of a method of one's own, which carries its blending functions: the library takes and gives such texts."""

    __slots__ = ("blending",)
    blending: Blending

    def __new__(cls, words: str, blending: Blending) -> OwnMethod:
        made = super().__new__(cls, words)
        made.blending = blending
        return made

    @property
    def _core(self) -> Any:
        return self.blending._core

    def __reduce__(self) -> Any:
        return OwnMethod, (str(self), self.blending)


def blending_of(words: str) -> Blending | None:
    """The blending functions that a text form carries."""
    return words.blending if isinstance(words, OwnMethod) else None


def method_words(method: Any) -> str:
    """The text form of a method: a text, or what has one, such as a curve and blending functions of one's own."""
    words = getattr(method, "method", method)
    if not isinstance(words, str):
        raise TypeError(f"method: found {type(method).__name__}, wanted a name such as 'auto', blending functions of one's own, or a curve")
    return words


def method_text(method: Any, ends: Any, start_rate: Any, end_rate: Any, closed: bool, period: float | None,
                settings: Mapping[str, Any]) -> str:
    """`NAME:SETTING=VALUE:…`, the one form in which the library reads methods."""
    words = method_words(method)
    pieces = [words, *(f"{name}={_value_text(name, value)}" for name, value in settings.items())]
    if ends is not None:
        pieces.append(f"ends={ends_text(ends)}")
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
    blending = blending_of(words)
    return ":".join(pieces) if blending is None else OwnMethod(":".join(pieces), blending)


def ends_text(ends: Any) -> str:
    """Rules as the library reads them."""
    rules = [ends] if isinstance(ends, str) else list(ends) if isinstance(ends, (tuple, list)) else []
    if not rules or (len(rules) != 2 and rules != [ends]) or not all(isinstance(rule, str) for rule in rules):
        raise wrong_type("ends", ends, "a rule, or a pair of rules for start and end")
    return ",".join(rules)


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
