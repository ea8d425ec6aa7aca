# SPDX-License-Identifier: Apache-2.0
"""Keys with one of them changed, added or taken away, as an editor asks for it."""
from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from .. import _core
from .._checks import whole
from .._columns import PARTS, QUATERNION, VECTORS
from .._errors import ArgumentError
from .._keys import Keys, _restored
from .._mending import scaled

if TYPE_CHECKING:
    from .._curve import Curve

PER_KEY = slice(2, 5)  # of origin_of_keys(): the lines of a file, its times and its quaternions as they stood there


@dataclasses.dataclass(frozen=True)
class Typed:
    """A key as somebody typed it: the time [s] on the clock of the page, w, x, y, z of any norm but 0, and a position [m]."""

    time: float
    orientation: list[float]
    position: list[float] | None

    @classmethod
    def of(cls, edit: Mapping[str, Any], has_positions: bool) -> Typed:
        time, = _numbers(("t",), [edit.get("t")])
        return cls(time, _numbers(QUATERNION, edit.get("q")), _numbers(VECTORS["positions"], edit.get("p")) if has_positions else None)


def edited(curve: Curve, edit: Mapping[str, Any]) -> Keys:
    """The keys of a curve after an edit, whose `kind` says what it is:

    - "set": a `key` by its index has another time `t`, quaternion `q` and position `p`, which are texts as they were typed;
    - "add": a key at the time `t` [s], where the curve is then, beyond it where it ends;
    - "delete": without a `key`.

    They are in the order of their times. Raises the library's errors for what can be no keys.
    """
    keys = curve.keys
    kind = edit.get("kind")
    if kind == "set":
        return _with_typed(keys, _index(keys, edit), Typed.of(edit, keys.positions is not None))
    if kind == "add":
        return _with_new(curve, *_numbers(("t",), [edit.get("t")]))
    if kind == "delete":
        others = np.arange(len(keys)) != _index(keys, edit)
        if not others.any():
            raise ArgumentError("found the only key, wanted another one before it is deleted, since a curve has one at least")
        return keys[others]
    raise ArgumentError(f"kind: found {kind!r}, wanted 'set', 'add' or 'delete'")


def _index(keys: Keys, edit: Mapping[str, Any]) -> int:
    return whole("key", edit.get("key"), 0, len(keys) - 1)


def _numbers(names: Sequence[str], texts: Any) -> list[float]:
    """Of texts with these names."""
    if not isinstance(texts, Sequence) or len(texts) != len(names):
        raise ArgumentError(f"{', '.join(names)}: found {texts!r}, wanted {len(names)} numbers")
    return [_number(name, text) for name, text in zip(names, texts)]


def _number(name: str, text: Any) -> float:
    try:
        return float(text)
    except (TypeError, ValueError):
        raise ArgumentError(f"{name}: found {text!r}, wanted a number") from None


def _with_typed(keys: Keys, key: int, typed: Typed) -> Keys:
    table = _table(keys, np.arange(len(keys)))
    w, x, y, z = typed.orientation
    table["times"][key], table["orientations"][key] = typed.time, [x, y, z, w]
    table["orientations"] = scaled(table["orientations"], {})[0]
    if typed.position is not None:
        table["positions"][key] = typed.position
    return _made(keys, table)


def _with_new(curve: Curve, time: float) -> Keys:
    """All that keys may carry is left free at the new one, but its settings are those of the key before it."""
    keys = curve.keys
    place = int(np.searchsorted(keys._core.times, time))
    table = _table(keys, np.insert(np.arange(len(keys)), place, max(place - 1, 0)))
    there = curve._as_key(time)
    for name in ("times", "orientations", *PARTS):
        if name in table:
            table[name][place] = there.get(name, np.nan)
    return _made(keys, table)


def _table(keys: Keys, rows: NDArray[np.intp]) -> dict[str, Any]:
    """What the keys carry, in copies of these rows."""
    found = {name: getattr(keys._core, name) for name in ("times", "orientations", *PARTS)}
    found |= {name: np.array(values) for name, values in keys.settings.items()}
    return {name: values[rows] for name, values in found.items() if values is not None}


def _made(like: Keys, table: dict[str, Any]) -> Keys:
    """Keys of this table, which are else as those others."""
    order = np.argsort(table["times"], kind="stable")
    rows = {name: np.ascontiguousarray(values[order]) for name, values in table.items()}
    like._clock.check_rising(rows["times"])
    settings = {name: rows[name].tolist() for name in like.settings}
    origin = list(_core.origin_of_keys(like._core))
    origin[PER_KEY] = [], "", None
    return _restored(rows["times"], rows["orientations"], {name: rows.get(name) for name in PARTS}, settings, like._clock,
                     like._scalar_first, tuple(origin), getattr(like, "_source", {}))
