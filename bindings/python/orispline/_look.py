# SPDX-License-Identifier: Apache-2.0
"""Colours, widths of lines and words of all pictures of curves: look.json, which the page of the reports has too."""
from __future__ import annotations

import functools
import json
import pathlib
from typing import Any


@functools.cache
def look() -> dict[str, Any]:
    """The table. `quantities` have titles and units by their words; `widths` of lines are in points; `light` and `dark` have
    colours, and `further` those of the curves after the second one."""
    table: dict[str, Any] = json.loads((pathlib.Path(__file__).parent / "look.json").read_text("utf-8"))
    return table


def labels() -> dict[str, str]:
    """Title and unit of each quantity by its word."""
    return {word: f"{quantity['title']} [{quantity['unit']}]" for word, quantity in look()["quantities"].items()}


def colours() -> list[str]:
    """Of curves beside each other, on white paper."""
    light = look()["light"]
    return [light["first"], light["second"], *look()["further"]]
