# SPDX-License-Identifier: Apache-2.0
"""Files that say of what they were made and what they hold, and have a checksum of all their bytes."""
from __future__ import annotations

import dataclasses
import hashlib
import json
import mmap
import re
from collections.abc import Sequence
from typing import Any

import pyarrow as pa
import pyarrow.parquet as pq

KEY = b"orispline"  # in the metadata of a file
NO_CHECKSUM = b"0" * 64  # which holds its place while the checksum is taken
PLACE = b'"sha256": "'  # in the metadata; in a text of ours these quotes would have backslashes


@dataclasses.dataclass(frozen=True)
class Summary:
    """What was written: rows in all, those of them that are errors, the first few messages, and the file or folder."""

    path: str
    rows: int
    errors: int
    first_errors: tuple[str, ...] = ()

    def __str__(self) -> str:
        bad = f", {self.errors} of them error{'s' if self.errors != 1 else ''}" if self.errors else ""
        return f"{self.path}: {self.rows} row{'s' if self.rows != 1 else ''}{bad}"


def seal(made_by: str, summary: Summary) -> dict[bytes, bytes]:
    """The metadata for a file, which `close` completes."""
    stated = {"made_by": made_by, "rows": summary.rows, "errors": summary.errors, "first_errors": summary.first_errors,
              "sha256": NO_CHECKSUM.decode()}
    return {KEY: json.dumps(stated).encode()}


def close(path: str) -> None:
    """Puts the checksum into a file with such metadata, which is written whole."""
    with open(path, "r+b") as file, mmap.mmap(file.fileno(), 0) as content:
        place = _place_in(content)
        content[place] = _checksum(content, place)


def sealed(path: str, made_by: str) -> Summary | None:
    """What a file holds that was made so and has every byte that it had then; None for any other."""
    try:
        stated = json.loads((pq.read_metadata(path).metadata or {})[KEY])
        with open(path, "rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as content:
            place = _place_in(content)
            if stated["made_by"] != made_by or content[place] != _checksum(content, place):
                return None
    except (OSError, pa.ArrowException, LookupError, ValueError):  # no Parquet, or a damaged one
        return None
    return Summary(path, stated["rows"], stated["errors"], tuple(stated["first_errors"]))


def _place_in(content: Any) -> slice:
    """Where the checksum stands, behind the columns. Raises ValueError where there is none."""
    first = content.rfind(PLACE) + len(PLACE)
    if first < len(PLACE) or not re.fullmatch(rb"[0-9a-f]{64}", content[first:first + len(NO_CHECKSUM)]):
        raise ValueError
    return slice(first, first + len(NO_CHECKSUM))


def _checksum(content: Any, place: slice) -> bytes:
    """Of all bytes, with nothing in that place."""
    parts: Sequence[Any] = (memoryview(content)[:place.start], NO_CHECKSUM, memoryview(content)[place.stop:])
    found = hashlib.sha256()
    for part in parts:
        found.update(part)
        if isinstance(part, memoryview):
            part.release()
    return found.hexdigest().encode()
