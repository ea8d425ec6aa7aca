# SPDX-License-Identifier: Apache-2.0
"""What a task says of what it found."""
from __future__ import annotations

import copy
from typing import Any

from ._names import Named


class Told(Named):
    """What has a document and a summary."""

    _members: dict[str, Any]
    _summary: str

    def as_dict(self) -> dict[str, Any]:
        """By name with unit, as the JSON of the command has it. Samples have the lines of their file, None without one."""
        return copy.deepcopy(self._members)

    def __str__(self) -> str:
        return self._summary.rstrip("\n") or repr(self)
