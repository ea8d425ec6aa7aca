# SPDX-License-Identifier: Apache-2.0
"""Blending functions of one's own, which are a method."""
from __future__ import annotations

import dataclasses
import fractions
import json
import math
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from . import _core
from ._checks import real, text, whole, wrong_type
from ._errors import ArgumentError
from ._files import Path, path_text
from ._methods import OwnMethod, method_text

if TYPE_CHECKING:
    from ._types import Basis

FARTHEST = 1000  # increments from a segment: far more than there are


@dataclasses.dataclass(frozen=True)
class BlendingFinding:
    """What was found about one promise of blending functions, exactly, for all values of their parameters.

    Attributes
    ----------
    promise
        Such as `"interpolates"`, `"continuity_uniform"` (on evenly spaced keys) and `"continuity_of_shape"`.
    order
        Of a continuity; of the others 1 where the promise is kept, else 0.
    why
        What fails, such as `"β₂(1) = 0.95, wanted 1: the curve does not reach the key"`.
    where
        A condition on the parameters under which more is kept.
    sentence
        All of this for people; empty where there is nothing to say.
    provided
        What the promise wants of the parameters or the lengths at a key, such as `"1 − a ≠ 0"`; empty where it wants nothing.
    """

    promise: str
    order: int
    why: str
    where: str
    sentence: str
    provided: str = ""


class Blending:
    """Blending functions of one's own, of `blending` or `read_blending`: a method, taken wherever a method is named.

    It never changes. Two are equal whose data are the same.
    """

    __slots__ = ("_core",)
    _core: Any

    def __init__(self) -> None:
        raise TypeError("found a call of Blending, wanted one of blending or read_blending")

    @classmethod
    def _of(cls, core: Any) -> Blending:
        made = cls.__new__(cls)
        made._core = core
        return made

    @property
    def name(self) -> str:
        """That it is named by as a method."""
        return str(self._core.name)

    @property
    def title(self) -> str:
        """A line for people."""
        return str(self._core.title)

    @property
    def info(self) -> dict[str, Any]:
        """What `orispline.methods()` would say of it: what was found, its parameters and end rules."""
        return dict(self._core.info)

    @property
    def findings(self) -> tuple[BlendingFinding, ...]:
        """What it keeps of what may be promised, and why not the rest."""
        return tuple(BlendingFinding(*found) for found in self._core.findings)

    @property
    def method(self) -> str:
        """The text form of the method, which carries the rows."""
        return OwnMethod(self.name, self)

    def with_settings(self, *, ends: str | tuple[str, str] | None = None, start_rate: Any = None, end_rate: Any = None,
                      closed: bool = False, period: float | None = None, **settings: Any) -> str:
        """The method with settings, as of `Curve`, for lists of methods: its text form, which carries the rows.

        >>> import orispline as ori
        >>> line = ori.blending("line", [["1-a", "1"]], parameters={"lag": 0}, first=0)
        >>> line.with_settings(lag=0.25)
        'line:lag=0.25'
        """
        return method_text(self, ends, start_rate, end_rate, closed, period, settings)

    def to_json(self) -> str:
        """The text of a file that `read_blending` and the command's `--blending` read back as the same."""
        return str(self._core.json)

    def __eq__(self, other: object) -> bool:
        return self.to_json() == other.to_json() if isinstance(other, Blending) else NotImplemented

    def __hash__(self) -> int:
        return hash(self.to_json())

    def __str__(self) -> str:
        return "\n".join([f"{self.name}: {self.title}" if self.title else self.name,
                          *(found.sentence for found in self.findings if found.sentence)])

    def __repr__(self) -> str:
        info = self._core.info
        stated = [repr(self.name), *(f"{p['name']}={p['default']:g}" for p in info["parameters"])]
        keys = "" if info["interpolates"] else "not through its keys, "
        orders = [f"{kind}{order}{keys}" if order >= 0 else f"jumps{keys}" for kind, order, keys in
                  (("C", info["continuity_uniform"], " on even keys"), ("C", info["continuity_uneven"], " on uneven keys"),
                   ("G", info["continuity_of_shape"], ""))]
        return f"Blending({', '.join(stated)}: {keys}{', '.join(orders)})"

    def __reduce__(self) -> Any:
        return _restored, (self.to_json(),)


def blending(name: str, rows: Any, *, parameters: Mapping[str, Any] | None = None, title: str = "", first: int | None = None,
             ends: str | None = None, basis: Basis | None = None) -> Blending:
    """Blending functions of one's own as a method: q(u) = q₀ ∏ exp(β̃ₖ(u) φₖ), with u from 0 to 1 on each segment.

    What it is then is found, not claimed: exactly, from the coefficients.

    Parameters
    ----------
    name : str
        Small letters, digits and `-`, and no method that there is.
    rows : list of lists of str or numbers, or (m, n) array
        A polynomial for each increment, 1 to 5 in their order, of degree 9 at most. A coefficient is a number or an expression such as
        `"1+7*a/20"`: `a` and `b` are the first parameter at the keys before and behind the segment, `a2` and `b2` the second, `a_1`
        and `b1` those one key further out, `h`, `h_1` and `h1` the lengths of this interval, of the one before and behind [s]. There
        are + - * / ( ) and whole powers, such as `h^2`.
    parameters : mapping, optional
        Their defaults by name, or `{"default": 0.5, "min": -2, "max": 2}` each.
    title : str
        A line for people.
    first : int, optional
        Which increment the first row is of, 0 being the segment's own. Wanted where there are 2 or 4 of them.
    ends : str, optional
        The end rule that is used where none is named, else `"repeat"`.
    basis : {"bernstein", "power", "bezier"}, optional
        Cumulative functions in the Bernstein basis, or as coefficients of 1, u, u², …; or blending functions of the
        control points themselves, in the Bernstein basis.

    Raises
    ------
    ArgumentError
        Rows, entries, names and rules that cannot be, with row, entry and position.

    Examples
    --------
    >>> import orispline as ori
    >>> tan = ori.blending("mine", parameters={"tension": 0.5}, rows=[["1", "1+a/5", "1+7*a/20", "1", "1", "1"],
    ...     ["0", "a/5", "9*a/20", "1-9*b/20", "1-b/5", "1"], ["0", "0", "0", "-7*b/20", "-b/5", "0"]])
    >>> tan
    Blending('mine', tension=0.5: C2 on even keys, C0 on uneven keys, G2)
    >>> curve = ori.Curve([0, 1, 2], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], tan, tension=0.4)
    >>> curve.method, curve.blending == tan
    ('mine:tension=0.4', True)
    """
    data: dict[str, Any] = {"name": text("name", name), "title": text("title", title), "parameters": _parameters(parameters),
                            "rows": _rows(rows)}
    if first is not None:
        data["first"] = whole("first", first, -FARTHEST, FARTHEST)
    data.update((word, text(word, value)) for word, value in (("ends", ends), ("basis", basis)) if value is not None)
    return _restored(_json(data))


def read_blending(path: Path) -> Blending:
    """Blending functions that a JSON file states, which is what `orispline.blending` takes.

    Raises
    ------
    DataError
        A file that is none, with row, entry and position, or with line and column where it is no JSON.
    AccessError
        The file is not there or cannot be read.

    Examples
    --------
    >>> import orispline as ori, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "line.json"
    >>> _ = path.write_text(ori.blending("line", [[0, 1]]).to_json())
    >>> ori.read_blending(path)
    Blending('line': C0 on even keys, C0 on uneven keys, G0)
    """
    return Blending._of(_core.Blending.read(path_text(path)))


def _rows(rows: Any) -> list[list[Any]]:
    listed = rows.tolist() if isinstance(rows, np.ndarray) else rows
    if isinstance(listed, (str, Mapping)) or not isinstance(listed, Iterable):
        raise wrong_type("rows", rows, "rows of coefficients")
    made = []
    for number, row in enumerate(listed, 1):
        if isinstance(row, (str, Mapping)) or not isinstance(row, Iterable):
            raise wrong_type(f"rows: row {number}", row, "a list of coefficients")
        made.append([_number(f"rows: row {number}, entry {k}", entry) for k, entry in enumerate(row, 1)])
    return made


def _number(place: str, value: Any) -> Any:
    """A coefficient as JSON has it: an expression or a number."""
    if isinstance(value, str):
        return str(value)
    if isinstance(value, fractions.Fraction):
        return str(value)
    if isinstance(value, (int, np.integer)) and not isinstance(value, bool):
        return int(value)
    number = real(place, value)
    if not math.isfinite(number):
        raise ArgumentError(f"{place}: found {number}, wanted a finite number")
    return number


def _parameters(parameters: Any) -> dict[str, Any]:
    if parameters is None:
        return {}
    if not isinstance(parameters, Mapping) or not all(isinstance(name, str) for name in parameters):
        raise wrong_type("parameters", parameters, 'a mapping of defaults by names, such as {"tension": 0.5}')
    return {name: {str(word): _value(name, number) for word, number in value.items()} if isinstance(value, Mapping) else _value(name, value)
            for name, value in parameters.items()}


def _value(name: str, value: Any) -> float:
    number = real(f"parameters: {name}", value)
    if not math.isfinite(number):
        raise ArgumentError(f"parameters: {name}: found {number}, wanted a finite number")
    return number


def _json(data: dict[str, Any]) -> str:
    words = json.dumps(data, ensure_ascii=False)
    try:
        words.encode()
    except UnicodeEncodeError as error:
        raise ArgumentError(f"blending: found the character {words[error.start]!r}, wanted text that can be written as UTF-8") from None
    return words


def _restored(words: str) -> Blending:
    return Blending._of(_core.Blending(words))


def carried(words: str, core: Any) -> OwnMethod:
    """A text form with its blending functions, as the library gives it."""
    return OwnMethod(words, Blending._of(core))


def among(words: str, own: Sequence[Blending]) -> str:
    """A text form as the user types it, whose name may be that of one of these."""
    name = words.partition(":")[0]
    found = next((one for one in own if one.name == name), None)
    return words if found is None else OwnMethod(words, found)
