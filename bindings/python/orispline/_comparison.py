# SPDX-License-Identifier: Apache-2.0
"""Methods beside each other, measured against a recording."""
from __future__ import annotations

import copy
import dataclasses
import importlib
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from ._checks import flag, wrong_type
from ._errors import ArgumentError
from ._html import table
from ._keys import Keys
from ._methods import method_words
from ._names import Named
from ._options import checked_keys, checked_threads, new_keys, of_keys, plain, reference_of
from ._request import Request
from ._results import Alignment
from ._view import Viewed, now

if TYPE_CHECKING:
    from ._curve import Curve
    from ._types import Method


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Comparison(Named, Viewed):
    """How near the curves of methods come to a recording, of `compare`.

    `measures` says what the columns of the table are: `id`, `label`, `unit`, `explanation`, and the `word` to sort by.
    """

    measures: tuple[dict[str, str], ...]
    _given: Keys
    _request: Request
    _reference: Keys | None
    _is_aligned: bool
    _rows: list[dict[str, Any]]
    _summary: str
    _core: Any

    def table(self) -> list[dict[str, Any]]:
        """A row for each method on each set of keys, the best first, with the members of `orispline compare --json`.

        A method that failed has None in the place of numbers, and the reason as `error`.
        """
        return copy.deepcopy(self._rows)

    def to_pandas(self) -> Any:
        """The same as a pandas DataFrame."""
        return importlib.import_module("pandas").DataFrame(self.table())

    @property
    def alignment(self) -> Alignment | None:
        """With `align=True` what brought the keys onto the reference; else None."""
        if not self._is_aligned or self._reference is None:
            return None
        request = Request("align", {"moved": self._given, "fixed": self._reference}, {})
        return Alignment._of(self._task().attributes()["alignment"], self._given, request)

    def keys(self, row: int = 0) -> Keys:
        """The keys that the method of a row was given; with `align=True` as they lie beside the reference."""
        return new_keys(self._task().keys_of(self._row(row)), self._given, self._reference if self._is_aligned else None)

    def curve(self, row: int = 0) -> Curve:
        """The curve of a row."""
        return self.keys(row).curve(self._task().attributes()["texts"][self._row(row)])

    def _page(self) -> bytes:
        return bytes(self._task().page(now()))

    def _row(self, row: int) -> int:
        if isinstance(row, (bool, np.bool_)) or not isinstance(row, (int, np.integer)):
            raise wrong_type("row", row, "the number of a row")
        if not -len(self._rows) <= row < len(self._rows):
            raise IndexError(f"row: found {row}, wanted one of {len(self._rows)} rows")
        return int(row) % len(self._rows)

    def _task(self) -> Any:
        if self._core is None:  # after pickling
            object.__setattr__(self, "_core", self._request.run()[0])
        return self._core

    def __len__(self) -> int:
        return len(self._rows)

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_core": None}

    def __str__(self) -> str:
        return self._summary.rstrip("\n")

    def _repr_html_(self) -> str:
        """The table that a notebook shows: a row for each method, the best first."""
        shown = [measure for measure in self.measures if any(row.get(measure["id"]) is not None for row in self._rows)]
        heads = ["method", "keys", *(f"{m['label']} [{m['unit']}]" if m["unit"] else m["label"] for m in shown), "error"]
        rows = [[row["method"], row["keys"], *(row.get(measure["id"]) for measure in shown), row["error"]] for row in self._rows]
        return table(repr(self), heads, rows)

    def __repr__(self) -> str:
        best = f", best {self._rows[0]['method']!r}" if self._rows else ""
        return f"Comparison({len(self)} row{'' if len(self) == 1 else 's'}{best})"


def _decimations(keep_every: Any, jitter: bool, random: int | None, reference: Keys | None) -> list[dict[str, Any]]:
    if reference is not None:
        if jitter or random is not None:
            raise ArgumentError("found reference and jitter or random, wanted a dense reference or samples of the keys for it")
        return []
    steps = list(keep_every) if isinstance(keep_every, (list, tuple)) else [keep_every]
    if not all(isinstance(step, (int, float, np.number)) for step in steps):
        raise wrong_type("keep_every", keep_every, "a whole number, or several")
    if not steps or len(set(steps)) < len(steps):
        raise ArgumentError(f"keep_every: found {keep_every!r}, wanted a whole number, or several that differ")
    spacing = "jittered" if jitter else "even" if random is None else "random"
    return [plain({"keep_every": step, "spacing": spacing, "seed": random}) for step in steps]


def _texts(methods: Sequence[Method] | Method | None) -> list[str]:
    if methods is None:
        return []
    given: Any = [methods] if isinstance(methods, str) or hasattr(methods, "method") else methods
    if not isinstance(given, Iterable):
        raise wrong_type("methods", methods, "a method, or a list of them")
    texts = [method_words(method) for method in given]
    if not texts or len(set(texts)) < len(texts):
        raise ArgumentError(f"methods: found {methods!r}, wanted one at least, and none twice")
    return texts


@of_keys
def compare(keys: Keys, /, methods: Sequence[Method] | Method | None = None, *, reference: Keys | tuple[Any, Any] | None = None,
            truth: Keys | tuple[Any, Any] | None = None, align: bool = False, keep_every: int | Sequence[int] = 8, jitter: bool = False,
            random: int | None = None, inertia: Any = None, leave_out: bool = False, least_energy: bool = True, tune: bool = False, sort: str = "rms",
            threads: int = 0) -> Comparison:
    """How near the curves of methods come to a recording, how smooth they are, and what they cost.

    Parameters
    ----------
    keys : Keys, or times and rotations
        As of `smooth`: a recording, of which some samples become keys; with `reference` the keys themselves.
    methods : str, Blending or Curve, or a list of them, optional
        Methods in their text form, such as `"quintic:tension=0.6"`, and of one's own. Without it all.
    reference, truth : Keys or (t, q), optional
        Both mean the same: a dense recording that curves through all of `keys` are compared with; `keep_every` then plays no part.
    align : bool
        Bring the keys onto the reference first: axes, clock, and scale and place of positions, as `orispline.align` does with a choice.
    keep_every : int or list of int
        Keep every N-th sample as a key; several make several sets of keys.
    jitter, random : bool, and int, optional
        Move those samples by up to 35 % of N. A seed for that, else for steps of N/4, N/2, N and 2N.
    inertia : (3,), (6,) or (3, 3) array, optional
        Of the body [kg m²]: principal moments, or xx, yy, zz, xy, xz, yz. With it torques are measured too.
    leave_out : bool
        Estimate the error from the keys alone as well, by leaving some of them out.
    least_energy : bool
        Tell how many times the least possible ∫|α|² dt each curve has, which takes a quarter of a millisecond a key.
    tune : bool
        Methods with tensions also with those of the least angular acceleration, as `"NAME:tuned"`.
    sort : str
        Word of a measure, best first.
    threads : int
        At most so many at work, 0 means one for each core; 1 for undisturbed times.

    Raises
    ------
    ArgumentError
        A method, a measure or an option that there is not.
    DataError
        Fewer than two keys, a reference without a time between them, or one that no alignment brings near.

    Warns
    -----
    ShapeWarning : A reference that is not denser than the keys, and the like.

    Examples
    --------
    >>> import numpy as np, orispline as ori
    >>> t = np.linspace(0, 6, 601)
    >>> half = np.sin(t)
    >>> q = np.outer(np.sin(half), [0, 0, 1, 0]) + np.outer(np.cos(half), [0, 0, 0, 1])
    >>> comparison = ori.compare(ori.Keys(t, q), ["slerp", "auto"], keep_every=50)
    >>> [row["method"] for row in comparison.table()]
    ['auto', 'slerp']
    """
    if truth is not None:
        if reference is not None:
            raise ArgumentError("truth: found it beside reference, wanted one of them: both mean the same")
        reference = truth
    if reference is not None:
        reference = checked_keys(reference, "reference")
    if not isinstance(sort, str):
        raise TypeError(f"sort: found {type(sort).__name__}, wanted a word")
    is_aligned = flag("align", align)
    decimations, texts = _decimations(keep_every, jitter, random, reference), _texts(methods)
    settings = {"align": is_aligned, "tune": flag("tune", tune), "sort": sort, "threads": checked_threads(threads)}
    options = plain({"inertia": inertia, "leave_out": leave_out, "least_energy": least_energy})
    beside = {"reference": reference} if reference is not None and is_aligned else reference_of(keys, reference)
    request = Request("compare", {"keys": keys, **beside}, options, settings, methods=texts, decimations=decimations)
    core, = request.told()
    measures = tuple(core.attributes()["measures"])
    return Comparison(measures, keys, request, reference, is_aligned, core.members(), core.summary(), core)
