# SPDX-License-Identifier: Apache-2.0
"""Keys and more keys as one."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._arrays import Array
from ._clock import Clock
from ._columns import PARTS
from ._errors import ArgumentError, at_key
from ._files import stated

if TYPE_CHECKING:
    from ._keys import Keys


def joined(keys: Keys, more: Keys) -> Any:
    """The library's keys, with the times of the first on. Raises DataError where those of the others do not come after them, and
    ArgumentError where the two have what does not go together."""
    for name, one, other in (("gap", keys.gap, more.gap), ("signs", *("as-given" if k._signs_as_given else "shortest" for k in (keys, more))),
                             ("settings", sorted(keys.settings), sorted(more.settings))):
        if one != other:
            raise ArgumentError(f"{name}: found {one} and {other}, wanted keys that have the same to be joined")
    if (keys.positions is None) != (more.positions is None):
        raise ArgumentError("positions: found keys with positions and keys without them, wanted both with them or both without")
    before, after = keys._core.times, _on_the_clock(keys, more)
    jumps = any(_core.origin_of_keys(one._core)[-1] for one in (keys, more))
    if after[0] < before[-1] or (after[0] == before[-1] and not jumps):
        first, last = keys._clock.back(np.array([after[0], before[-1]]))
        raise at_key(len(keys), f"time {first} of the keys that are added does not come after {last}, the last one before them, wanted later "
                     "times: leave out the keys that overlap, such as by more[…]")
    counts = len(keys), len(more)
    parts = {name: _stacked(getattr(keys._core, name), getattr(more._core, name), counts) for name in PARTS}
    settings = {name: [*values, *more.settings[name]] for name, values in keys.settings.items()}
    core = _core.Keys(np.append(before, after), np.vstack([keys._core.orientations, more._core.orientations]), **parts, settings=settings,
                      signs="as-given" if keys._signs_as_given else "shortest",
                      jumps=jumps)
    core = _core.keys_since(core, _core.epoch_of_keys(keys._core), keys._is_dated)
    return core if keys.gap is None else _core.keys_as_read(core, stated({"gap": keys.gap}))


def _on_the_clock(keys: Keys, more: Keys) -> Array:
    """The times of the others [s] since those of the first."""
    one, other = keys._clock, more._clock
    if one.kind or other.kind:
        return one.seconds("keys", more.times)
    if one.unit != other.unit:
        raise ArgumentError(f"keys: found times in {one.unit} and in {other.unit}, wanted one unit for both")
    if one != Clock():
        return one.seconds("keys", more.times)
    import decimal
    epochs = [decimal.Decimal(_core.epoch_of_keys(each._core)) for each in (keys, more)]
    if (epochs[0] == 0) != (epochs[1] == 0):
        raise ArgumentError(f"keys: found seconds since {epochs[0]} and since {epochs[1]}, wanted both since a time that is known, or both "
                            "without: times such as those of keys.times remember it")
    since: Array = more._core.times + float(epochs[1] - epochs[0])
    return since


def _stacked(one: Array | None, other: Array | None, counts: tuple[int, int]) -> Array | None:
    """Rows that are not there are NaN, which leaves them free."""
    there = next((rows for rows in (one, other) if rows is not None), None)
    if there is None:
        return None
    return np.vstack([np.full((count, there.shape[1]), np.nan) if rows is None else rows for rows, count in zip((one, other), counts)])
