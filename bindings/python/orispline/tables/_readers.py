# SPDX-License-Identifier: Apache-2.0
"""Readers of record batches, each of which can be read once: one that has been read to its end is told from one without rows."""
from __future__ import annotations

import weakref
from collections.abc import Callable, Iterable, Iterator
from typing import Any

import pyarrow as pa

from .._errors import ArgumentError

_spent: weakref.WeakSet[Any] = weakref.WeakSet()  # as far as they are ours, or were read here


def giving(schema: Any, batches: Callable[[], Iterable[Any]]) -> Any:
    """A reader of what the function gives, which is called when it is asked for; all with the metadata of this schema."""
    def watched() -> Iterator[Any]:
        for batch in batches():
            yield pa.RecordBatch.from_arrays(batch.columns, schema=schema)
        if (reader := own()) is not None:
            _spent.add(reader)

    made = pa.RecordBatchReader.from_batches(schema, watched())
    own = weakref.ref(made)
    return made


def taken(given: Any, what: str) -> tuple[Any, Iterable[Any]]:
    """The schema and the batches of a reader or of what else has `__arrow_c_stream__`. Raises ArgumentError for a reader that is spent."""
    _check(given, what)
    try:
        reader = given if isinstance(given, pa.RecordBatchReader) else pa.RecordBatchReader.from_stream(given)
    except pa.ArrowException as error:
        reason = str(error).splitlines()[0]
        raise ArgumentError(f"{what}: found a {type(given).__name__} that is no table ({reason}), wanted named columns of types that pyarrow "
                            "has") from None
    return reader.schema, _once(reader, what)


def _once(reader: Any, what: str) -> Iterator[Any]:
    _check(reader, what)
    yield from reader
    _spent.add(reader)


def _check(given: Any, what: str) -> None:
    if isinstance(given, pa.RecordBatchReader) and given in _spent:
        raise ArgumentError(f"{what}: found a reader that has been read to its end, wanted a new one: rows come out of it once")
