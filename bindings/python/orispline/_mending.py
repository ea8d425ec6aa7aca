# SPDX-License-Identifier: Apache-2.0
"""Rows of arrays mended before they become keys, as the options of reading mend those of a file."""
from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ._arrays import Array
from ._checks import flag

Indices = NDArray[np.intp]
Column = np.ndarray[Any, Any]


@dataclasses.dataclass(frozen=True)
class Mending:
    """What is to be mended: options that `Keys` and `read` have alike."""

    normalize: bool
    drop_invalid: bool
    drop_duplicates: bool
    sort: bool

    @classmethod
    def of(cls, normalize: Any, normalise: Any, drop_invalid: Any, drop_duplicates: Any, sort: Any) -> Mending:
        """Of flags, two of which are spellings of the same one."""
        return cls(one_spelling(normalize, normalise), flag("drop_invalid", drop_invalid), flag("drop_duplicates", drop_duplicates),
                   flag("sort", sort))

    def rows(self, stamps: Column, orientations: Array, positions: Array | None,
             free: list[Array | None]) -> tuple[Indices | None, dict[str, float]]:
        """Indices of the rows that are kept, in their order, None for all as they are; and what was done.

        A quaternion of zeros is none; of `free` columns a row of NaN is.
        """
        if not (self.drop_invalid or self.drop_duplicates or self.sort):
            return None, {}
        kept: Indices = np.flatnonzero(_valid(stamps, [orientations, positions], free) & orientations.any(axis=1)) if self.drop_invalid else np.arange(len(stamps))
        repairs: dict[str, float] = {"invalid_dropped": len(stamps) - len(kept), "rows_moved": 0, "duplicates_dropped": 0}
        if self.sort and len(kept):
            repairs["rows_moved"] = int((stamps[kept] < np.maximum.accumulate(stamps[kept])).sum())
            kept = kept[np.argsort(stamps[kept], kind="stable")]
        if self.drop_duplicates and len(kept):
            first = np.append(True, stamps[kept][1:] != stamps[kept][:-1])
            repairs["duplicates_dropped"] = len(kept) - int(first.sum())
            kept = kept[first]
        return kept, repairs


def one_spelling(normalize: Any, normalise: Any) -> bool:
    """Both are the same option."""
    return flag("normalize", normalize) or flag("normalise", normalise)


def _valid(stamps: Column, needed: list[Array | None], free: list[Array | None]) -> NDArray[np.bool_]:
    valid = ~np.isnat(stamps) if stamps.dtype.kind in "Mm" else np.isfinite(stamps) if stamps.dtype.kind == "f" else np.full(len(stamps), True)
    for rows in needed:
        valid &= True if rows is None else np.isfinite(rows).all(axis=1)
    for rows in free:
        valid &= True if rows is None else np.isfinite(rows).all(axis=1) | np.isnan(rows).all(axis=1)
    return valid


def scaled(orientations: Array, inner: Mapping[str, Array | None]) -> tuple[Array, dict[str, Array | None], dict[str, float]]:
    """Quaternions of any norm but 0 scaled to 1, with the inner ones of the same keys, and what was done; rows of NaN stay what
    they are."""
    there = {name: rows for name, rows in inner.items() if rows is not None}
    every, done = _of_norm_one(np.vstack([orientations, *there.values()]))
    first, *others = np.split(every, 1 + len(there))
    return first, {**inner, **dict(zip(there, others))}, done


def _of_norm_one(orientations: Array) -> tuple[Array, dict[str, float]]:
    norms = np.linalg.norm(orientations, axis=1, keepdims=True)
    with np.errstate(invalid="ignore", divide="ignore"):
        unit = (np.abs(norms - 1) <= 1e-12) | (norms == 0)  # one of norm 1 but for rounding keeps its digits
        far = np.abs(norms - 1)[~unit & np.isfinite(norms)]
        return (np.where(unit, orientations, orientations / norms),
                {"normalised": int((far > 1e-6).sum()), "largest_norm_error": float(far.max(initial=0.0))})
