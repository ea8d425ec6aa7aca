# SPDX-License-Identifier: Apache-2.0
"""NumPy's stamps and durations: their units, and arrays of those that callers have as objects."""
from __future__ import annotations

import datetime
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._errors import ArgumentError

DIGITS = {"s": 0, "ms": 3, "us": 6, "ns": 9}
PER_SECOND = {unit: 10**digits for unit, digits in DIGITS.items()}
UNITS_OF_STAMPS = ("ns", "us", "ms")  # the first one that has room for all of them
SECONDS_IN = {"W": 604800.0, "D": 86400.0, "h": 3600.0, "m": 60.0, "s": 1.0, "ms": 1e-3, "us": 1e-6, "ns": 1e-9, "ps": 1e-12, "fs": 1e-15,
              "as": 1e-18}
ROOM = 2.0**63 * (1 - 1e-12)  # of a whole number in 64 bits


def about(name: str, stamps: np.ndarray[Any, Any]) -> NDArray[np.float64]:
    """Stamps as floats [s], which cannot overflow."""
    unit, count = np.datetime_data(stamps.dtype)
    if unit in ("Y", "M") and stamps.dtype.kind == "M":  # of no fixed length
        stamps, (unit, count) = stamps.astype("M8[D]"), ("D", 1)
    if unit == "generic" and np.isnat(stamps).all():
        return np.full(stamps.shape, np.nan)
    if unit not in SECONDS_IN:
        raise ArgumentError(f"{name}: found {stamps.dtype}, wanted a unit of fixed length, such as timedelta64[s]")
    return np.where(np.isnat(stamps), np.nan, stamps.astype(np.int64).astype(np.float64) * (SECONDS_IN[unit] * count))


def of_objects(name: str, array: np.ndarray[Any, Any]) -> np.ndarray[Any, Any]:
    """Of objects that are dates, UTC where they have a time zone, or durations; all others as they are."""
    objects = list(array.reshape(-1))
    if objects and all(isinstance(thing, (datetime.timedelta, np.timedelta64)) for thing in objects):
        return _in_one_unit(name, objects, "timedelta64").reshape(array.shape)
    if not objects or not all(isinstance(thing, (datetime.date, np.datetime64)) for thing in objects):
        return array
    zoned = {getattr(thing, "tzinfo", None) is not None for thing in objects if thing == thing}  # but NaT
    if len(zoned) > 1:
        raise ArgumentError(f"{name}: found dates with a time zone and dates without one, wanted a time zone for all or for none")
    if True in zoned:
        objects = [thing.astimezone(datetime.timezone.utc).replace(tzinfo=None) if thing == thing else thing for thing in objects]
    return _in_one_unit(name, objects, "datetime64").reshape(array.shape)


def _in_one_unit(name: str, objects: list[Any], kind: str) -> np.ndarray[Any, Any]:
    """In the first unit that has room for all; where NumPy itself has them in one unit, in that one. In a list of several units NumPy
    would wrap those round that the finest has no room for."""
    convert, scalar = f"to_{kind}", getattr(np, kind)
    stamps = [getattr(thing, convert)() if hasattr(thing, convert) else scalar(thing) for thing in objects]
    if len({stamp.dtype for stamp in stamps}) == 1 and all(isinstance(thing, np.generic) for thing in objects):
        return np.array(stamps)
    largest = max((abs(float(about(name, stamp))) for stamp in stamps if not np.isnat(stamp)), default=0.0)
    unit = next((unit for unit in UNITS_OF_STAMPS if largest * PER_SECOND[unit] < ROOM), "s")
    return np.array([stamp.astype(f"{kind}[{unit}]") for stamp in stamps])
