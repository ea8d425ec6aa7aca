# SPDX-License-Identifier: Apache-2.0
"""Options and results of tasks as the library's tables of fields state them."""
from __future__ import annotations

import functools
import inspect
from typing import Any, Callable, Concatenate, Mapping, ParamSpec, Protocol, Sequence, TypeVar, overload

import numpy as np

from . import _core
from ._checks import real, wrong_type
from ._errors import ArgumentError
from ._frames import refuse_frame
from ._keys import Keys, keys_of

Task = TypeVar("Task", bound=Callable[..., Any])
Class = TypeVar("Class", bound=type)
P = ParamSpec("P")
Found = TypeVar("Found", covariant=True)
KEYS_ARGUMENTS = list(inspect.signature(Keys).parameters)
FIELDS: dict[str, list[dict[str, Any]]] = _core.fields()
OPTIONS = {field["name"] for table, fields in FIELDS.items() if table.endswith("Options") or table in ("ClipEdits", "Decimation") for field in fields}


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
    """Options as the binding takes them. About a name that no task has the library says so, whatever its value is."""
    return {name: _plain(name, value) if name in OPTIONS else 0 for name, value in options.items()}


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


def checked_keys(given: Any, name: str = "keys", wanted: str = "Keys") -> Keys:
    """Keys, or those of a pair of times and rotations; or a TypeError that says so."""
    if isinstance(given, tuple) and len(given) == 2:
        return Keys(*given)
    if not isinstance(given, Keys):
        refuse_frame(name, given)
        cure = ", such as its .keys" if isinstance(getattr(given, "keys", None), Keys) else ", or times and rotations"
        raise TypeError(f"{name}: found {type(given).__name__}, wanted {wanted}{cure}")
    return given


class OfKeys(Protocol[P, Found]):
    """A task of Keys, or of the times and rotations that these are made of."""

    @overload
    def __call__(self, keys: Keys | tuple[Any, Any], /, *args: P.args, **options: P.kwargs) -> Found: ...
    @overload
    def __call__(self, times: Any, rotations: Any, /, *args: P.args, **options: P.kwargs) -> Found: ...


def of_keys(task: Callable[Concatenate[Keys, P], Found]) -> OfKeys[P, Found]:
    """Lets a task, whose first argument are keys, take what `Curve` takes instead: times and rotations, and the arguments of `Keys` by
    their names, but for those that the task itself has."""
    signature = inspect.signature(task)
    first, *own = signature.parameters
    names = [name for name in KEYS_ARGUMENTS if name not in own]

    @functools.wraps(task)
    def run(*given: Any, **stated: Any) -> Any:
        """With the keys that were given, or those of what was given."""
        of_them, stated = parted(stated, names)
        if first in stated or "times" in of_them:
            given = (stated.pop(first) if first in stated else of_them.pop("times"), *given)
        if not given:
            raise TypeError(f"{task.__name__}: found no keys, wanted Keys, or times and rotations")
        keys, *rest = given
        if isinstance(keys, tuple) and len(keys) == 2 and "rotations" not in of_them and not (rest and _is_rows(rest[0])):
            keys, of_them["rotations"] = keys
        elif rest and _is_rows(rest[0]):
            of_them["rotations"], *rest = rest
        elif "rotations" not in of_them:
            keys = checked_keys(keys, first)
        return task(keys_of(keys, of_them), *rest, **stated)

    run.__signature__ = signature  # type: ignore[attr-defined]
    return run


def parted(stated: dict[str, Any], names: Sequence[str]) -> tuple[dict[str, Any], dict[str, Any]]:
    """Arguments of these names, and the others."""
    return {name: stated[name] for name in names if name in stated}, {name: value for name, value in stated.items() if name not in names}


def _is_rows(given: Any) -> bool:
    """Whether it may be rotations, and is no method, tolerance or list of methods."""
    if isinstance(given, (list, tuple)):
        return bool(given) and (hasattr(given[0], "as_quat") or np.ndim(given[0]) > 0)
    return hasattr(given, "as_quat") or hasattr(given, "as_components") or np.ndim(given) > 1


def checked_threads(threads: Any) -> int:
    """A number of threads; 0 is one for each core."""
    if isinstance(threads, bool) or not isinstance(threads, (int, np.integer)) or not 0 <= threads <= 1024:
        raise ArgumentError(f"threads: found {threads!r}, wanted a whole number from 0, which means all cores, to 1024")
    return int(threads)


def reference_of(keys: Keys, reference: Keys | tuple[Any, Any] | None) -> dict[str, Any]:
    """A reference as an input beside the keys, where there is one. The library brings their times together by their epochs."""
    if reference is None:
        return {}
    reference = checked_keys(reference, "reference")
    times = reference.times
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
