# SPDX-License-Identifier: Apache-2.0
"""Tables as notebooks show them."""
from __future__ import annotations

import html
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

import numpy as np

ENDS = 5  # rows that are shown of a long table, at its start and at its end


def table(caption: str, heads: Sequence[str], rows: Iterable[Sequence[Any]]) -> str:
    """In HTML; numbers have six digits."""
    lines = [f"<table><caption>{html.escape(caption)}</caption>", _row("th", heads), *(_row("td", row) for row in rows), "</table>"]
    return "\n".join(lines)


def few_rows(columns: Mapping[str, Any]) -> list[list[Any]]:
    """The first rows and the last, with dots between."""
    count = len(next(iter(columns.values())))
    rows = [[column[i] for column in columns.values()] for i in sorted({*range(min(ENDS, count)), *range(max(count - ENDS, 0), count)})]
    return rows if count <= 2 * ENDS else [*rows[:ENDS], ["…"] * len(columns), *rows[ENDS:]]


def _row(tag: str, cells: Sequence[Any]) -> str:
    return "<tr>" + "".join(f"<{tag}>{html.escape(_text(cell))}</{tag}>" for cell in cells) + "</tr>"


def _text(cell: Any) -> str:
    if cell is None:
        return ""
    return f"{cell:.6g}" if isinstance(cell, (float, np.floating)) else str(cell)
