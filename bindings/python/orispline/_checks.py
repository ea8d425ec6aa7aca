# SPDX-License-Identifier: Apache-2.0
"""Arguments that are one number, one word or one flag, and the texts in which the library reads them: what is of another type is
named in one line."""
from __future__ import annotations

import reprlib
from collections.abc import Mapping
from typing import Any

import numpy as np

from ._errors import ArgumentError

MOST_THREADS = 4096
MOST_SAMPLES = 10**9
FRAMES = ("body", "world")  # of angular rates


def wrong_type(name: str, value: Any, wanted: str) -> TypeError:
    """The exception, to be raised."""
    return TypeError(f"{name}: found {reprlib.repr(value)} of type {type(value).__name__}, wanted {wanted}".replace("\n", " "))


def flag(name: str, value: Any) -> bool:
    """True or False, and nothing that only counts as such."""
    if not isinstance(value, (bool, np.bool_)):
        raise wrong_type(name, value, "True or False")
    return bool(value)


def text(name: str, value: Any) -> str:
    """A string."""
    if not isinstance(value, str):
        raise wrong_type(name, value, "a string")
    return value


def real(name: str, value: Any) -> float:
    """One real number."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, float, np.integer, np.floating)):
        raise wrong_type(name, value, "a number")
    return float(value)


def whole(name: str, value: Any, least: int, most: int) -> int:
    """One whole number, both bounds included."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, (int, np.integer)):
        raise wrong_type(name, value, "a whole number")
    if not least <= value <= most:
        raise ArgumentError(f"{name}: found {value}, wanted a whole number from {least} to {most}")
    return int(value)


def index_of(name: str, word: str, words: tuple[str, ...]) -> int:
    """Where a word is among those that there are."""
    if not isinstance(word, str) or word not in words:
        raise ArgumentError(f"{name}: found {word!r}, wanted {', '.join(repr(w) for w in words[:-1])} or {words[-1]!r}")
    return words.index(word)


def in_world(frame: str) -> bool:
    """Which of the frames."""
    return index_of("frame", frame, FRAMES) == 1


def thread_count(threads: Any) -> int:
    """Of the library: 0 is one for each core."""
    return whole("threads", threads, 0, MOST_THREADS)


def check_number(samples: int) -> None:
    """Before memory is asked for."""
    if samples > MOST_SAMPLES:
        raise ArgumentError(f"found {samples} samples, wanted 1e9 at most: sample the curve in parts, by start and end")


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


def ends_text(ends: Any) -> str:
    """Rules as the library reads them."""
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
    return ":".join(pieces)
