# SPDX-License-Identifier: Apache-2.0
"""Options and results of tasks as the library's tables of fields state them."""
from __future__ import annotations

import inspect
from typing import Any, Callable, Mapping, Sequence, TypeVar

import numpy as np

from . import _core
from ._checks import real, wrong_type
from ._errors import ArgumentError
from ._keys import Keys

Task = TypeVar("Task", bound=Callable[..., Any])
Class = TypeVar("Class", bound=type)
FIELDS: dict[str, list[dict[str, Any]]] = _core.fields()


def _plain(name: str, value: Any) -> Any:
    """A text, a number or a list of one of them, as the library takes options."""
    if isinstance(value, (np.generic, np.ndarray)) and np.ndim(value) == 0:
        value = value.item()
    if value is None or isinstance(value, (str, bool, int, float)):
        return value
    if isinstance(value, (list, tuple)) and value and all(isinstance(word, str) for word in value):
        return list(value)
    try:
        array = np.asarray(value)
    except (TypeError, ValueError):  # rows of different lengths, or what is no array at all
        raise wrong_type(name, value, "a number, a few numbers or a text") from None
    if array.dtype.kind not in "fiu":
        raise ArgumentError(f"{name}: found an array of {array.dtype}, wanted numbers, or a text such as on the command line")
    if array.shape == (3, 3):
        return _six(name, array.astype(np.float64))
    if array.ndim > 1:
        raise ArgumentError(f"{name}: found the shape {array.shape}, wanted a number or a few")
    return [float(x) for x in array]


def _six(name: str, matrix: np.ndarray[Any, Any]) -> list[float]:
    """The elements xx, yy, zz, xy, xz, yz of a symmetric matrix."""
    if not np.allclose(matrix, matrix.T, rtol=1e-12, atol=0):
        raise ArgumentError(f"{name}: found a matrix that is not symmetric, wanted a symmetric one")
    return [float(matrix[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]


def plain(options: Mapping[str, Any]) -> dict[str, Any]:
    """Options as the binding takes them."""
    return {name: _plain(name, value) for name, value in options.items()}


def checked_cutoff(cutoff: Any, options: Mapping[str, Any]) -> dict[str, Any]:
    """A cut-off frequency [Hz] as a setting, beside the options of smoothing; none where it is None."""
    if cutoff is None:
        return {}
    beside = [name for name in ("noise", "smoothing_time") if options.get(name) is not None]
    if beside:
        raise ArgumentError(f"cutoff: found it beside {beside[0]}, wanted one of them: each says how smooth")
    hertz = cutoff
    if isinstance(cutoff, str):
        try:
            hertz = float(cutoff.removesuffix("Hz")) if cutoff.endswith("Hz") else None
        except ValueError:
            hertz = None
    if hertz is None or not 1e-300 < real("cutoff", hertz) < 1e300:
        raise ArgumentError(f"cutoff: found {cutoff!r}, wanted a number greater than 0, or a text with its unit such as '8Hz'")
    return {"cutoff": float(hertz)}


def checked_keys(keys: Any, name: str = "keys") -> Keys:
    """Keys, or a TypeError that says so."""
    if not isinstance(keys, Keys):
        raise TypeError(f"{name}: found {type(keys).__name__}, wanted Keys")
    return keys


def checked_threads(threads: Any) -> int:
    """A number of threads; 0 is one for each core."""
    if isinstance(threads, bool) or not isinstance(threads, (int, np.integer)) or not 0 <= threads <= 1024:
        raise ArgumentError(f"threads: found {threads!r}, wanted a whole number from 0, which means all cores, to 1024")
    return int(threads)


def reference_of(keys: Keys, reference: Keys | None) -> dict[str, Any]:
    """A reference as an input beside the keys, where there is one. The library brings their times together by their epochs."""
    if reference is None:
        return {}
    times = checked_keys(reference, "reference").times
    if reference._clock.kind != keys._clock.kind or keys._clock.kind:  # else the library says what is to be said
        keys._clock.check_met(keys._clock.seconds("reference", times), tuple(keys._core.times[[0, -1]]))
    return {"reference": reference}


def new_keys(core: Any, like: Keys, clock_of: Keys | None = None) -> Keys:
    """Keys of the library, with times and quaternions as those others have them, or with the times of yet others."""
    return Keys._of(core, (like if clock_of is None else clock_of)._clock, scalar_first=like._scalar_first)


def _unit(field: dict[str, Any]) -> str:
    return f" [{field['unit']}]" if field["unit"] else ""


def _option_lines(fields: list[dict[str, Any]]) -> str:
    lines = []
    for field in fields:
        if field["words"]:
            kind = "{" + ", ".join(f'"{word}"' for word in field["words"]) + "}"
        else:
            kind = field["wanted"]
        lines += [f"    {field['name']} : {kind}", f"        {field['sentence']}."]
        if field["absent"]:
            lines.append(f"        Without it: {field['absent']}.")
        lines += [f'        "{word}": {sentence}.' for word, sentence in field["words"].items() if sentence]
    return "\n".join(lines).strip()


def takes(table: str, *, without: Sequence[str] = (), also: Mapping[str, Sequence[str]] | None = None) -> Callable[[Task], Task]:
    """Lets a function's help and signature state the options of a table, but for some of them and with some of other tables, in
    the place of `{options}`."""
    fields = [field for field in FIELDS[table] if field["name"] not in without]
    fields += [field for more, names in (also or {}).items() for field in FIELDS[more] if field["name"] in names]

    def documented(task: Task) -> Task:
        task.__doc__ = (task.__doc__ or "").replace("{options}", _option_lines(fields))
        signature = inspect.signature(task)
        stated = [p for p in signature.parameters.values() if p.kind is not p.VAR_KEYWORD]
        names = {p.name for p in stated}
        stated += [inspect.Parameter(field["name"], inspect.Parameter.KEYWORD_ONLY, default=field["default"])
                   for field in fields if field["name"] not in names]
        task.__signature__ = signature.replace(parameters=stated)  # type: ignore[attr-defined]
        return task
    return documented


def states(table: str) -> Callable[[Class], Class]:
    """Lets a class's help state the results of a table in the place of `{fields}`."""
    def documented(result: Class) -> Class:
        lines = [f"    {field['name']}\n        {field['sentence']}{_unit(field)}."
                 + (f" None: {field['absent']}." if field["absent"] else "")
                 for field in FIELDS[table] if field["name"] != "keys"]
        result.__doc__ = (result.__doc__ or "").replace("{fields}", "\n".join(lines).strip())
        return result
    return documented
