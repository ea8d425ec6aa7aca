# SPDX-License-Identifier: Apache-2.0
"""The folders that streams of Spark write: which of their files belong to them is noted in `_spark_metadata`."""
from __future__ import annotations

import functools
import json
import os
import urllib.parse
from collections.abc import Iterable

from .._errors import AccessError, DataError

NOTES = "_spark_metadata"
COMPACT = ".compact"  # of a batch whose notes have all those of the batches before it


def noted(paths: Iterable[str]) -> list[str]:
    """Those of the files that belong to the output of a stream, where they lie in one: a query that was killed leaves others, which no
    batch has noted. Raises AccessError where a noted one is not there, and DataError for notes that cannot be read."""
    folder_of = functools.cache(_folder_with_notes)
    files: dict[str, set[str]] = {}
    kept = []
    for path in paths:
        folder = folder_of(os.path.dirname(os.path.abspath(path)))
        if folder is not None and folder not in files:
            files[folder] = _files_in(folder)
        if folder is None or os.path.basename(path) in files[folder]:
            kept.append(path)
    return kept


def _folder_with_notes(folder: str) -> str | None:
    """The folder, or the one around it, that a stream writes to; partitions lie in folders of their own."""
    while not os.path.isdir(os.path.join(folder, NOTES)):
        folder, here = os.path.dirname(folder), folder
        if folder == here:
            return None
    return folder


def _files_in(folder: str) -> set[str]:
    """The names of those that are noted. Spark gives each a name of its own, and the notes hold where the folder was at first."""
    notes = os.path.join(folder, NOTES)
    batches = {int(name.removesuffix(COMPACT)): name for name in sorted(os.listdir(notes)) if name.removesuffix(COMPACT).isdigit()}
    begin = max((batch for batch, name in batches.items() if name.endswith(COMPACT)), default=0)
    found: set[str] = set()
    for batch in sorted(batch for batch in batches if batch >= begin):
        place = os.path.join(notes, batches[batch])
        try:
            with open(place, encoding="utf-8") as file:
                entries = [json.loads(line) for line in file.read().splitlines()[1:]]  # below the version
            for entry in entries:
                name = os.path.basename(urllib.parse.unquote(entry["path"]))
                (found.discard if entry["action"] == "delete" else found.add)(name)
        except (ValueError, LookupError, TypeError):
            raise DataError(f"{place}: found no notes of a stream of Spark, wanted a line of JSON for each file") from None
        except OSError as error:
            raise AccessError(f"{place}: cannot be read: {error.strerror}") from None
    there = {name for _, _, names in os.walk(folder) for name in names}
    for name in sorted(found - there):
        raise AccessError(f"{folder}: found no {name}, which {NOTES} says is part of it, wanted all files of the stream")
    return found
