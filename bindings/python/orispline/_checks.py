# SPDX-License-Identifier: Apache-2.0
"""Arguments that are one number, one word or one flag: what is of another type is named in one line."""
from __future__ import annotations

import re
import reprlib
from typing import Any

import numpy as np

from ._errors import ArgumentError

MOST_THREADS = 4096
MOST_SAMPLES = 10**9
FRAMES = ("body", "world")  # of angular rates
RATE = r"\s*(.*?)\s*(k?)Hz\s*"  # with its unit


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
    """A number, or a fraction such as `30000/1001`, of samples per second; texts may end in their unit, Hz or kHz."""
    import fractions
    if isinstance(rate, fractions.Fraction):
        rate = f"{rate.numerator}/{rate.denominator}"
    if isinstance(rate, str):
        with_unit = re.fullmatch(RATE, rate)
        text, thousands = with_unit.groups() if with_unit else (rate, "")
        try:
            if (number := fractions.Fraction(text)) > 0:
                return str(1000 * number) if thousands else text
        except (ValueError, ZeroDivisionError):
            pass
    elif not isinstance(rate, (bool, np.bool_)) and np.ndim(rate) == 0 and np.asarray(rate).dtype.kind in "fiu" \
            and np.isfinite(rate) and rate > 0:
        return repr(rate.item() if isinstance(rate, np.generic) else rate)
    found = reprlib.repr(rate).replace("\n", " ")
    raise ArgumentError(f"rate: found {found}, wanted a number of samples per second greater than 0, or a text such as '100 Hz'")
