# SPDX-License-Identifier: Apache-2.0
"""What is done on a whole track: smoothing, reduction, comparison, and orientations at the times of another table."""
from __future__ import annotations

import dataclasses
import fractions
import functools
from typing import TYPE_CHECKING, Any

import numpy as np
import pyarrow as pa
import pyarrow.compute as pc

from .._comparison import compare
from .._curve import Curve
from .._errors import ArgumentError, DataError, Error, collected
from .._keys import Keys
from .._tasks import reduce, smooth
from ._layout import Layout
from ._per_track import START, Result, columns_of, track_of
from ._resampling import sampled_schema
from ._times import Whole, common_type

if TYPE_CHECKING:
    from .._types import Extrapolate

SIDE = "side"  # of rows of two tables: 0 of keys, 1 of those that orientations are wanted for
SIDES = ("keys", "at")
OF_THIS_MACHINE = ("build_seconds", "seconds")  # measures that another run does not repeat
OUTSIDE = "found a time outside the keys of the track"
NO_TIME = "found {} in the column {!r}, wanted a time"
NO_KEYS = "found no keys of this track"


def turning_keys(count: int, *, positions: bool = False) -> Keys:
    """A slow turn that trembles: something to try options on."""
    half = np.linspace(0.0, 1.0, count) + 1e-3 * np.cos(7.0 * np.arange(count))
    turning = np.column_stack([0 * half, 0 * half, np.sin(half), np.cos(half)])
    return Keys(np.arange(float(count)), turning, positions=turning[:, :3] if positions else None)


def tried(layout: Layout, work: Any) -> None:
    """Raises what options are refused by; what else becomes of the keys does not matter."""
    with collected():
        try:
            work(turning_keys(33, positions=bool(layout.position)))
        except ArgumentError:
            raise
        except Error:
            pass


def _same_row(count: int) -> Whole:
    return np.zeros(count, np.int64)


@dataclasses.dataclass(frozen=True)
class Smoothing:
    """Motion without the noise, with its rates, at the times of the keys or at even ones."""

    rate: Any
    derivatives: int
    frame: str
    options: dict[str, Any]

    @property
    def step(self) -> fractions.Fraction | None:
        """From one sample to the next [s]; None at the times of the keys."""
        return None if self.rate is None else 1 / fractions.Fraction(self.rate)

    def check(self, layout: Layout) -> None:
        """Raises what the options are refused by."""
        tried(layout, lambda keys: smooth(keys, **self.options))

    def schema(self, layout: Layout, given: Any) -> Any:
        """The columns of samples."""
        return sampled_schema(layout, given, self.derivatives, self.frame == "world", self.step)

    def of_track(self, layout: Layout, rows: Any, given: Any) -> Result:
        """Even samples leave out the gaps that were not smoothed across."""
        track = track_of(layout, rows, self.step)
        keys = track.keys()
        smoothing = smooth(keys, **self.options)
        wanted = {"times": keys.times} if self.rate is None else {"rate": self.rate}
        motion = smoothing.curve.sample(**wanted, derivatives=self.derivatives, frame=self.frame)
        there = np.ones(len(motion), bool) if self.rate is None else smoothing.covers(motion.times)
        tables = [motion.orientations, motion.positions, motion.angular_velocities, motion.angular_accelerations,
                  motion.angular_jerks, motion.velocities, motion.accelerations]
        columns = columns_of(*(None if table is None else table[there] for table in tables))
        return Result(rows, _same_row(int(there.sum())), [track.back(motion.times[there]), *columns])


@dataclasses.dataclass(frozen=True)
class Reduction:
    """The fewest keys whose curve stays within a tolerance, and the method of that curve."""

    tolerance: Any
    options: dict[str, Any]
    step = None

    def check(self, layout: Layout) -> None:
        """Raises what the options are refused by."""
        tried(layout, lambda keys: reduce(keys, self.tolerance, threads=1, **self.options))

    def schema(self, layout: Layout, given: Any) -> Any:
        """Those of the keys with the rates that are part of them, and the method."""
        fields = list(sampled_schema(layout, given, self._orders, world=False))
        return pa.schema([*fields[:-1], pa.field("method", pa.string()), fields[-1]])

    @functools.cached_property
    def _orders(self) -> int:
        """1 where a method seeks the rates of its keys as well, else 0."""
        methods = self.options.get("method")
        options = {name: self.options[name] for name in ("values", "position_tolerance") if name in self.options}
        recording = turning_keys(9, positions="position_tolerance" in options)
        with collected():
            kept = [reduce(recording, 1.0, method=method, threads=1, **options).keys
                    for method in (methods if isinstance(methods, (list, tuple)) else [methods]) if method is not None]
        return max((0 if keys.angular_velocities is None else 1 for keys in kept), default=0)

    def of_track(self, layout: Layout, rows: Any, given: Any) -> Result:
        """A row for each key that is kept."""
        track = track_of(layout, rows)
        reduction = reduce(track.keys(), self.tolerance, threads=1, **self.options)
        kept = reduction.keys
        columns = columns_of(kept.rotations, kept.positions, kept.angular_velocities)
        if kept.angular_velocities is None:
            columns += [pa.nulls(len(kept), pa.float64())] * (3 * self._orders)
        method = pa.array([str(reduction.method)] * len(kept), pa.string())
        return Result(rows, _same_row(len(kept)), [track.back(kept.times), *columns, method])


@dataclasses.dataclass(frozen=True)
class Comparison:
    """How near methods come to each track, in the words of `orispline.compare`, but for what was the time of this machine."""

    options: dict[str, Any]
    step = None

    def members(self) -> dict[str, Any]:
        """The columns with their types, of a comparison of little work that has the same options."""
        steps = self.options["keep_every"]
        count = 4 * max(steps if isinstance(steps, (list, tuple)) else [steps]) + 1
        with collected():
            row = compare(turning_keys(count), threads=1, **{**self.options, "methods": ["slerp"]}).table()[0]
        kinds = {"method": pa.string(), "keep_every": pa.int64(), "keys": pa.int64(), "samples": pa.int64(), "continuity": pa.int64(), "shape": pa.int64()}
        return {name: kinds.get(name, pa.float64()) for name in row if name not in (*OF_THIS_MACHINE, "error")}

    def check(self, layout: Layout) -> None:
        """Raises what the options are refused by."""
        self.members()
        tried(layout, lambda keys: compare(keys, threads=1, **{**self.options, "keep_every": 2}))

    def schema(self, layout: Layout, given: Any) -> Any:
        """The ids, and a column for each measure."""
        return pa.schema([*(pa.field(name, given.field(name).type) for name in layout.by),
                          *(pa.field(name, kind) for name, kind in self.members().items()), pa.field("error", pa.string())])

    def of_track(self, layout: Layout, rows: Any, given: Any) -> Result:
        """A row for each method, the best first."""
        table = compare(track_of(layout, rows).keys(), threads=1, **self.options).table()
        columns = [pa.array([row[name] for row in table], kind) for name, kind in self.members().items()]
        failures = pa.array([row["error"] for row in table], pa.string())
        return Result(rows, _same_row(len(table)), columns, failures)


@dataclasses.dataclass(frozen=True)
class Evaluation:
    """Orientations at the rows of another table, each of which stays a row, with all of its columns."""

    method: str
    derivatives: int
    frame: str
    extrapolate: Extrapolate
    kind: Any  # of the times of that table
    beside: tuple[str, ...]  # its other columns
    step = None

    def check(self, layout: Layout) -> None:
        """Raises what the method is refused by."""
        tried(layout, lambda keys: Curve(keys, method=self.method, extrapolate=self.extrapolate))

    def schema(self, layout: Layout, given: Any) -> Any:
        """The other table's columns, then those of samples."""
        fields = list(sampled_schema(layout, given, self.derivatives, self.frame == "world"))
        ids = len(layout.by)
        return pa.schema([*fields[:ids], pa.field(layout.time, self.kind), *(given.field(name) for name in self.beside),
                          *fields[ids + 1:]])

    def of_track(self, layout: Layout, rows: Any, given: Any) -> Result:
        """Rows that lie outside the keys, or have none, say so."""
        is_beside = pc.equal(rows.column(SIDE), 1)
        at, keys = rows.filter(is_beside), rows.filter(pc.invert(is_beside))
        own = [at.column(layout.time).cast(self.kind), *(at.column(name) for name in self.beside)]
        everyone = np.arange(at.num_rows)
        if not at.num_rows:
            return Result(at, everyone, [*own, *self._nothing(layout, given, 0)], pa.nulls(0, pa.string()))
        try:
            columns, outside = self._at(layout, keys, at)
        except Error as error:
            return Result(at, everyone, [*own, *self._nothing(layout, given, at.num_rows)],
                          pa.array([str(error)] * at.num_rows, pa.string()))
        failures = pa.array(self._reasons(layout, at.column(layout.time)), pa.string(), mask=~outside)
        return Result(at, everyone, [*own, *(pa.array(column, mask=outside) for column in columns)], failures)

    @staticmethod
    def _reasons(layout: Layout, times: Any) -> Any:
        """Why there is no orientation at each of these times, where there is none."""
        absent, no_time = (pc.is_null(times, nan_is_null=nan).to_numpy(zero_copy_only=False) for nan in (False, True))
        null, nan = (NO_TIME.format(what, layout.time) for what in ("null", "nan"))
        return np.select([absent, no_time], [null, nan], OUTSIDE)

    def _nothing(self, layout: Layout, given: Any, count: int) -> list[Any]:
        fields = list(self.schema(layout, given))[len(layout.by) + 1 + len(self.beside):-1]
        return [pa.nulls(count, field.type) for field in fields]

    def _at(self, layout: Layout, keys: Any, at: Any) -> tuple[list[Any], Any]:
        """The columns of samples, and which of them lie outside or at no time."""
        if not keys.num_rows:
            raise DataError(NO_KEYS)
        track = track_of(layout, keys)
        seconds, _ = track.times.seconds(at.column(layout.time), START, track.origin)
        curve = Curve(track.keys(), method=self.method, extrapolate=self.extrapolate)
        motion = curve.sample(times=seconds, derivatives=self.derivatives, frame=self.frame)
        columns = columns_of(motion.orientations, motion.positions, motion.angular_velocities, motion.angular_accelerations,
                             motion.angular_jerks, motion.velocities, motion.accelerations)
        return columns, np.isnan(motion.orientations[:, 0])


def united(layout: Layout, keys: Any, at: Any, beside: tuple[str, ...]) -> Any:
    """The schema of rows of both: all columns, the finer of two units of time, and the side."""
    kind = common_type(at.field(layout.time).type, keys.field(layout.time).type)
    return pa.schema([*(at.field(name) for name in layout.by), pa.field(layout.time, kind),
                      *(keys.field(name) for name in layout.numbers), *(at.field(name) for name in beside),
                      pa.field(SIDE, pa.int8())])


