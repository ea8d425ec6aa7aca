# SPDX-License-Identifier: Apache-2.0
"""The mean or the median of the rows of a group, or of its windows in time."""
from __future__ import annotations

import dataclasses
import fractions
import functools
from typing import Any

import numpy as np
import pyarrow as pa

from .._mean import Mean, mean
from ._layout import Layout, SetLayout
from ._per_track import Result, columns_of, track_of
from ._works import tried, turning_keys

AXES = "xyz"


@dataclasses.dataclass(frozen=True)
class Means:
    """A row for each group, or for each of its windows."""

    options: dict[str, Any]

    @functools.cached_property
    def step(self) -> fractions.Fraction | None:
        """Half a window, in the middle of which its time is; None without windows."""
        if self.options["every"] is None:
            return None
        return fractions.Fraction(repr(mean(turning_keys(2), every=self.options["every"])[0].time))

    def check(self, layout: Layout) -> None:
        """Raises what the options are refused by."""
        tried(layout, lambda keys: mean(keys, **self.options))

    def schema(self, layout: Layout, given: Any) -> Any:
        """The ids, the time of a window, the middle, and what is known of it."""
        assert isinstance(layout, SetLayout)
        found = {"count": pa.int64(), "weight_sum": pa.float64(), "rms_distance_rad": pa.float64(), "largest_distance_rad": pa.float64(),
                 **{f"sigma_{axis}_rad": pa.float64() for axis in AXES}, "certified": pa.bool_(), "error": pa.string()}
        times = [pa.field(layout.time, layout.times(given.field(layout.time).type, self.step).made)] if layout.time else []
        return pa.schema([*(given.field(name) for name in layout.by), *times,
                          *(pa.field(name, pa.float64()) for name in (*layout.quaternion, *layout.position)),
                          *(pa.field(name, kind) for name, kind in found.items())])

    def of_track(self, layout: Layout, rows: Any, given: Any) -> Result:
        """Rows without a time of their own are a set."""
        assert isinstance(layout, SetLayout)
        if layout.time:
            track = track_of(layout, rows, self.step)
            columns = np.column_stack(track.numbers)
            found = mean(track.keys(), weights=_weights(layout, columns), **self.options)
            times = [track.back(np.array([one.time for one in found]))]
        else:
            columns = np.column_stack(layout.numbers_of(rows))
            found = [mean(columns[:, :4], positions=columns[:, 4:7] if layout.position else None, weights=_weights(layout, columns),
                          **self.options)]
            times = []
        return Result(rows, np.zeros(len(found), np.int64), [*times, *_columns(found)])


def _weights(layout: SetLayout, columns: Any) -> Any:
    return columns[:, -1] if layout.weight else None


def _columns(found: list[Mean]) -> list[Any]:
    middles = columns_of(np.array([one.orientation for one in found]),
                         None if found[0].position is None else np.array([one.position for one in found]))
    sigmas = [pa.array([None if one.sigma is None else float(one.sigma[i]) for one in found], pa.float64()) for i in range(len(AXES))]
    return [*middles, pa.array([one.count for one in found], pa.int64()),
            *(pa.array([getattr(one, name) for one in found], pa.float64()) for name in ("weight", "rms_distance", "largest_distance")),
            *sigmas, pa.array([one.certified for one in found], pa.bool_())]
