# SPDX-License-Identifier: Apache-2.0
"""Files as the command reads and writes them: paths, options, and writing what knows how to be written."""
from __future__ import annotations

import datetime
import io
import os
from typing import IO, TYPE_CHECKING, Any, List, Mapping, Tuple, Union

import numpy as np

from . import _core
from ._errors import ArgumentError

if TYPE_CHECKING:
    from ._curve import Curve
    from ._keys import Keys
    from ._samples import Samples

Path = Union[str, "os.PathLike[str]"]
Source = Union[Path, "IO[bytes]", "IO[str]"]  # what is read
Target = Source  # what is written
UNNAMED = "the file object"  # in messages
Options = List[Tuple[str, str]]  # as the command has them


class Writable:
    """What `write` writes. This module need not know which kinds there are."""

    __slots__ = ()

    def _write_as(self, path: str, in_memory: bool, options: Options, method: str | None = None) -> bytes:
        """The bytes of the file where it is to be one in memory, of that name."""
        raise NotImplementedError


def write(what: Keys | Curve | Samples, path: Target, *, output_format: str | None = None,
          output_orientation: str | None = None, output_euler: str | None = None, output_angle_unit: str | None = None,
          continuous: bool = False, no_continuous: bool = False, output_conjugate: bool = False) -> None:
    """Writes keys, the keys of a curve with the method that they are for, or samples.

    The file appears complete or not at all; one that was there stays as it is if writing fails. The format is that of
    the name, if `output_format` does not say another: .csv, .tum, .npy, else CSV. Times are exact; EuRoC alone rounds them to whole nanoseconds.

    Parameters
    ----------
    what : Keys, Curve or Samples
        `read(path).curve()` of the file of a curve is that curve again.
    path : str, path or file object
        A file object, open for bytes or text, is written where it stands, once all is known to succeed, and stays open; its `name` tells
        the format where it has one. NumPy's format wants one for bytes.
    {options}

    Raises
    ------
    AccessError
        A folder that is not there or may not be written to, a full disk.
    ArgumentError
        An option that is no such thing; a name that ends as files of other kinds do; rates in a format without them.
    DataError
        Samples that are not finite, or fall on the same time in the unit of the file.

    Warns
    -----
    ShapeWarning
        What the format has no room for, such as the method of the keys.

    Examples
    --------
    >>> import orispline as ori, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "keys.csv"
    >>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "timed-c2", ends="rest")
    >>> ori.write(curve, path)
    >>> ori.read(path).curve()
    Curve('timed-c2:ends=rest', 3 keys, 0 … 3 s, C²)
    """
    options = stated({"output_format": output_format, "output_orientation": output_orientation,
                      "output_euler": output_euler, "output_angle_unit": output_angle_unit})
    options += flags({"continuous": continuous, "no_continuous": no_continuous, "output_conjugate": output_conjugate})
    keys = getattr(what, "keys", None)  # of a curve, and of what a task made
    name, file = target_of(path)
    if isinstance(what, Writable):
        content = what._write_as(name, file is not None, options)
    elif isinstance(keys, Writable):
        content = keys._write_as(name, file is not None, options, getattr(what, "method", None))
    else:
        raise TypeError(f"found {type(what).__name__}, wanted Keys, a Curve or Samples")
    if file is not None:
        write_bytes(name, file, content)


def path_text(path: Path) -> str:
    """A path as the library takes it; bytes that are not UTF-8 stand in it as `os.fsdecode` has them."""
    text = os.fspath(path) if isinstance(path, (str, os.PathLike)) else None
    if not isinstance(text, str):
        raise TypeError(f"path: found {type(path).__name__}, wanted a str or a path of str")
    if "\0" in text:
        raise ArgumentError("path: found a NUL character in it, wanted the name of a file")
    try:
        os.fsencode(text)
    except UnicodeEncodeError:
        raise ArgumentError(f"path: found {text!r}, wanted the name of a file, which has no such character") from None
    return text


def source_of(path: Source) -> tuple[str, bytes | None]:
    """A path as the library takes it, or the name and the content of a file object."""
    if isinstance(path, (str, os.PathLike)):
        return path_text(path), None
    if not callable(read := getattr(path, "read", None)):
        raise TypeError(f"path: found {type(path).__name__}, wanted a str, a path of str, or a file object")
    content = read()
    if not isinstance(content, (str, bytes, bytearray, memoryview)):
        raise TypeError(f"path: found an object whose read() gives {type(content).__name__}, wanted bytes or text")
    return _name_of(path), content.encode("utf-8", "surrogateescape") if isinstance(content, str) else bytes(content)


def target_of(path: Target) -> tuple[str, Any]:
    """A path as the library takes it, or the name of a file object and that itself."""
    if isinstance(path, (str, os.PathLike)):
        return path_text(path), None
    if not callable(getattr(path, "write", None)):
        raise TypeError(f"path: found {type(path).__name__}, wanted a str, a path of str, or a file object")
    return _name_of(path), path


def write_bytes(name: str, file: Any, content: bytes) -> None:
    """Writes what `target_of` gives: a file of that name, or a file object, which takes text where it has an encoding."""
    if file is None:
        _core.write_bytes(name, content)
        return
    if hasattr(file, "encoding"):
        try:
            text = None if b"\0" in content else content.decode("utf-8")
        except UnicodeDecodeError:
            text = None
        if text is None:
            raise TypeError("path: found a file object for text, wanted one for bytes, as this format is")
        file.write(text)
        return
    written = file.write(content)
    while isinstance(file, io.RawIOBase) and written != len(content):  # those without a buffer may take a part
        if not written:
            raise BlockingIOError("path: found a file object that takes no more now, wanted one that waits")
        content = content[written:]
        written = file.write(content)


def _name_of(file: Any) -> str:
    name = getattr(file, "name", None)
    return path_text(name) if isinstance(name, str) and name else UNNAMED


def printable(text: str) -> str:
    """A text in which bytes that are not UTF-8 are escapes, as in the messages of the library."""
    return text.encode("utf-8", "surrogateescape").decode("utf-8", "backslashreplace")


def stated(options: Mapping[str, Any]) -> Options:
    """Those with a value."""
    return [(name, _text(name, value)) for name, value in options.items() if value is not None]


def _text(name: str, value: Any) -> str:
    import fractions
    if isinstance(value, fractions.Fraction):
        return f"{value.numerator}/{value.denominator}"
    if isinstance(value, (datetime.date, np.datetime64)):
        return value.isoformat() if isinstance(value, datetime.date) else str(value)
    if isinstance(value, np.generic):
        value = value.item()
    if isinstance(value, bool) or not isinstance(value, (str, int, float)):
        raise TypeError(f"{name}: found {value!r}, wanted a text or a number")
    return value if isinstance(value, str) else repr(value)


def flags(options: Mapping[str, Any]) -> Options:
    """Those that are set."""
    for name, value in options.items():
        if not isinstance(value, (bool, np.bool_)):
            raise TypeError(f"{name}: found {value!r}, wanted True or False")
    return [(name, "") for name, value in options.items() if value]


def explained(options: list[dict[str, str | None]]) -> str:
    """What the library says of options, as a docstring has it."""
    lines = []
    for option in options:
        argument = option["argument"]
        words = ", ".join(f'"{word}"' for word in (argument or "").split("|"))
        kind = "bool" if argument is None else f"{{{words}}}" if "|" in argument else ""
        lines += [f"{option['name']} : {kind or 'optional'}", f"    {option['sentence']}."]
    return "\n    ".join(lines)


write.__doc__ = (write.__doc__ or "").replace("{options}", explained(_core.writing_options()))
