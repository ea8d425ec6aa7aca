# SPDX-License-Identifier: Apache-2.0
"""What is stated for a task of the library."""
from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

from . import _core
from ._errors import tell


@dataclasses.dataclass(frozen=True, eq=False)
class Request:
    """A task by its name, with its inputs and its options, such that it can be pickled and run again.

    Inputs by their names are Keys, scenes, or what `_core.Gyro` is made of as a tuple; or lists of them. `settings` are what the task takes
    beside its own options.
    """

    task: str
    inputs: dict[str, Any]
    options: dict[str, Any]
    settings: dict[str, Any] = dataclasses.field(default_factory=dict)
    method: str | None = None
    methods: Sequence[str] = ()
    decimations: Sequence[dict[str, Any]] = ()

    def run(self) -> list[_core.TaskOutcome]:
        """What was found; of several recordings that are reduced of each."""
        inputs = [(name, _held(one)) for name, given in self.inputs.items() for one in (given if isinstance(given, list) else [given])]
        return _core.run(self.task, inputs, self.options, self.settings, self.method, self.methods, self.decimations)

    def told(self) -> list[_core.TaskOutcome]:
        """That, with the warnings told to the caller."""
        outcomes = self.run()
        for outcome in outcomes:
            tell(outcome.warnings)
        return outcomes


def _held(given: Any) -> Any:
    return _core.Gyro(*given) if isinstance(given, tuple) else getattr(given, "_core", given)
