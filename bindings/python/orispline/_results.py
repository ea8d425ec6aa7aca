# SPDX-License-Identifier: Apache-2.0
"""What tasks find: objects that never change."""
from __future__ import annotations

import dataclasses
import functools
import keyword
from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

import numpy as np
from numpy.typing import NDArray

from ._core import TaskOutcome
from ._html import table
from ._keys import Keys
from ._options import FIELDS, checked_keys, new_keys, states
from ._request import Request
from ._told import Told
from ._view import Viewed, now

if TYPE_CHECKING:
    from ._curve import Curve

Indices = NDArray[np.intp]
Found = TypeVar("Found", bound="Result")


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Result(Told):
    """What results of tasks have alike."""

    keys: Keys
    _given: Keys
    _request: Request
    _members: dict[str, Any]
    _summary: str
    _core: TaskOutcome | None
    _table: ClassVar[str]

    def _task(self) -> TaskOutcome:
        """The library's own result; after pickling the work is done again, with the same numbers."""
        core = self._core
        if core is None:
            object.__setattr__(self, "_core", core := self._request.run()[0])
        return core

    @classmethod
    def _found(cls: type[Found], request: Request, given: Keys) -> Found:
        """What a task finds of keys."""
        return cls._of(request.told()[0], given, request)

    @classmethod
    def _of(cls: type[Found], core: TaskOutcome, given: Keys, request: Request) -> Found:
        kinds = {field["name"]: field["type"] for field in FIELDS[cls._table]} | {"samples": "samples"}
        values = {name + "_" * keyword.iskeyword(name): _as_python(kinds.get(name, ""), value, given)
                  for name, value in core.attributes().items() if name != "keys"}
        return cls(keys=new_keys(core.keys, given, clock_of=request.inputs.get("fixed")), _given=given, _request=request,
                   _members=core.members(), _summary=core.summary(), _core=core, **values)

    def __getstate__(self) -> dict[str, Any]:
        return {name: None if name == "_core" else value for name, value in self.__dict__.items() if name != "curve"}

    def _repr_html_(self) -> str:
        """The table that a notebook shows: what was found, by name with unit, and what it means."""
        return table(f"{type(self).__name__} of {len(self._given)} keys: {self._title()}", ("", "", "meaning"), self._rows())

    def _rows(self) -> list[tuple[str, Any, str]]:
        return [(field["member"], value, field["sentence"]) for field in FIELDS[self._table]
                if isinstance(value := self._members.get(field["member"]), (bool, int, float, str))]

    def _title(self) -> str:
        return repr(self.keys)

    def __repr__(self) -> str:
        shown = ", ".join(f"{f.name}={getattr(self, f.name)!r}" for f in dataclasses.fields(self)
                          if not f.name.startswith("_") and f.name not in ("keys", "method")
                          and isinstance(getattr(self, f.name), (int, float, str)))
        return f"{type(self).__name__}({self._title()}, {shown})"


def _as_python(kind: str, value: Any, given: Keys) -> Any:
    if value is None:
        return None
    if kind == "sample":
        return given._clock.time(given._core.times[value])
    if kind == "samples":
        return np.array(value, dtype=np.intp)
    if kind == "vector":
        return np.array(value)
    return tuple(value) if kind == "runs" else value


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class CurveResult(Result):
    """One whose keys are for a curve."""

    method: str

    @functools.cached_property
    def curve(self) -> Curve:
        """The curve of `method` through `keys`, for which the result holds."""
        return self.keys.curve(self.method)

    def _title(self) -> str:
        return f"{self.keys!r}, {self.method!r}"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Reported(CurveResult, Viewed):
    """One that has a page to look at."""

    def _page(self) -> bytes:
        return bytes(self._task().page(now()))


@states("Smoothing")
@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Smoothing(Reported):
    """A smoothed recording, of `smooth`.

    Attributes
    ----------
    keys
        The smooth motion at the times of the recording, with angular velocities and accelerations.
    method
        The method whose curve through the keys is the smooth motion.
    {fields}
    """

    smoothing_time: float
    shortest_smoothing_time: float | None
    longest_smoothing_time: float | None
    cutoff: float
    lambda_: float
    criterion: str | None
    chosen_on: int
    noise: float
    local_noise: float
    least_noise: float | None
    largest_noise: float | None
    degrees_of_freedom: float | None
    rms_sigma: float | None
    rms_sigma_of_rates: float | None
    gyro_used: bool | None
    gyro_noise: float | None
    gyro_correction: NDArray[np.float64] | None
    gyro_offset: float | None
    gyro_offset_sigma: float | None
    gyro_drift: float | None
    gyro_scale: NDArray[np.float64] | None
    gyro_scale_sigma: NDArray[np.float64] | None
    gyro_mount: NDArray[np.float64] | None
    gyro_mount_sigma: NDArray[np.float64] | None
    gyro_trend: NDArray[np.float64] | None
    gyro_trend_sigma: NDArray[np.float64] | None
    gyro_clock_rate: float | None
    gyro_clock_rate_sigma: float | None
    correlated_noise: float | None
    correlation_time: float | None
    hidden_noise: float | None
    hidden_noise_time: float | None
    error_with_gyro: float | None
    error_without_gyro: float | None
    rms_distance: float
    largest_distance: float
    accepted_rms_distance: float
    accepted_largest_distance: float
    rejected: Indices
    rejected_gyro: Indices
    retained_outlier_runs: Indices
    samples_in_short_stretches: Indices
    stretches: tuple[tuple[int, int], ...]
    iterations: int
    last_step: float
    position_smoothing_time: float | None
    position_cutoff: float | None
    position_criterion: str | None
    position_noise: float | None
    position_local_noise: float | None
    position_rms_distance: float | None
    position_largest_distance: float | None
    position_accepted_rms: float | None
    position_accepted_largest: float | None
    rejected_positions: Indices | None
    retained_position_runs: Indices | None
    _table: ClassVar[str] = "Smoothing"

    @property
    def sigma(self) -> NDArray[np.float64] | None:
        """One standard deviation of every orientation along the axes of the body [rad], of the shape (n, 3); with the option."""
        sigmas = self._task().sigmas()
        return None if sigmas is None else sigmas[0]

    @property
    def sigma_of_rates(self) -> NDArray[np.float64] | None:
        """One standard deviation of every angular velocity along the axes of the body [rad/s], of the shape (n, 3); with the option."""
        sigmas = self._task().sigmas()
        return None if sigmas is None else sigmas[1]

    def covers(self, t: Any) -> NDArray[np.bool_]:
        """Whether the curve stands for the recording at times of any shape: neither over a gap nor beside it."""
        seconds = self._given._clock.seconds("t", t)
        return np.array([self._task().covers(float(x)) for x in seconds.reshape(-1)], dtype=bool).reshape(seconds.shape)


@states("Reduction")
@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Reduction(Reported):
    """The fewest keys found, of `reduce`.

    Attributes
    ----------
    keys
        Those keys, with what they carry.
    method
        The method whose curve through the keys is within the tolerance.
    samples
        Indices of the samples at whose times the keys stand.
    {fields}
    smoothing
        What was done to the recording before, with `smooth=True`, a `Smoothing`; else None, as all that follows.
    raw_error_rms, raw_error_max
        How far the curve is from the samples as they were, rejected ones apart [rad].
    raw_position_error_rms, raw_position_error_max
        How far its path is from their positions [m]; None without any.
    """

    samples: Indices
    error_max: float
    error_max_time: Any
    position_error_max: float | None
    position_error_max_time: Any
    raw_error_rms: float | None
    raw_error_max: float | None
    raw_position_error_rms: float | None
    raw_position_error_max: float | None
    smoothing: Smoothing | None = None
    _table: ClassVar[str] = "Reduction"

    def __post_init__(self) -> None:
        if self.smoothing is not None:
            stated = {name: value for name, value in self._request.settings.items() if name not in ("smooth", "threads")}
            request = Request("smooth", self._request.inputs, {}, stated)
            object.__setattr__(self, "smoothing", Smoothing._of(self.smoothing, self._given, request))  # type: ignore[arg-type]


@dataclasses.dataclass(frozen=True)
class Certificate:
    """What is known of a limited quantity: all in SI units, angles in rad.

    `limit`: as asked for. `bound`: nowhere is it above this. `found`: the largest value that was found, at `time`
    [s] after the start. `segment`: the index of the segment with the bound.
    """

    limit: float
    bound: float
    found: float
    time: float
    segment: int


@states("Retiming")
@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Retiming(Reported):
    """Keys at later times, of `retime`.

    Attributes
    ----------
    keys
        The keys at their new times.
    method
        The method whose curve through the keys stays within the limits.
    certificates
        Of each limited quantity by name, such as `"rate"` and `"torque_x"`: a `Certificate`.
    duration_before
        Duration of the keys that were given [s].
    {fields}
    """

    slowing: str
    duration_before: float
    duration_after: float
    time_scale: float
    inserted: int
    rests: int
    slack: float
    unevenness: float | None
    path_turn: float | None
    path_shift: float | None
    typed_longer: float | None
    stops: int | None
    largest_rate: float | None
    largest_acceleration: float | None
    certificates: dict[str, Certificate]
    _table: ClassVar[str] = "Retiming"

    def __post_init__(self) -> None:
        named = {name: Certificate(*row) for name, row in self.certificates.items()}  # type: ignore[misc]
        object.__setattr__(self, "certificates", named)


@states("Tuning")
@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Tuning(CurveResult):
    """The best tensions, of `tune`.

    Attributes
    ----------
    keys
        The keys, with the tensions as their settings.
    method
        The method with these tensions, in its text form.
    parameters
        The (n,) values of each tension that was varied, by name.
    objective, unit
        What was made least, and the unit of the energies.
    {fields}
    """

    objective: str
    unit: str
    parameters: dict[str, NDArray[np.float64]]
    energy_before: float
    energy_after: float
    iterations: int
    stationarity: float
    _table: ClassVar[str] = "Tuning"


@dataclasses.dataclass(frozen=True, eq=False)
class OpenDirection:
    """What two recordings cannot tell of their alignment: so much of these together changes nothing that was measured.

    `world`, `body`: turns about these axes [rad]. `offset` [s], `scale` of 1, `translation` [m].
    """

    world: NDArray[np.float64]
    body: NDArray[np.float64]
    offset: float
    scale: float
    translation: NDArray[np.float64]

    @classmethod
    def _of(cls, row: tuple[Any, ...]) -> OpenDirection:
        world, body, offset, scale, translation = row
        return cls(np.array(world), np.array(body), offset, scale, np.array(translation))


@states("Alignment")
@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Alignment(Result):
    """What brings a recording `a` onto a recording `b`, of `align`: R' = W R Bᵀ, p' = s W p + d, t' = t - offset.

    Angles are in rad, times in s and lengths in m.

    Attributes
    ----------
    keys
        `a` as it lies beside `b`, with times on the clock of `b`.
    world, body
        The rotations W and B as (4,) quaternions in the order of those of `a`.
    open
        What the recordings cannot tell: an `OpenDirection` for each, none as a rule.
    {fields}
    """

    world: NDArray[np.float64]
    body: NDArray[np.float64]
    offset: float
    offset_sigma: float
    world_sigma: NDArray[np.float64]
    body_sigma: NDArray[np.float64]
    scale: float | None
    scale_sigma: float | None
    translation: NDArray[np.float64] | None
    translation_sigma: NDArray[np.float64] | None
    open: tuple[OpenDirection, ...]
    compared: int
    rejected: Indices
    distance_rms: float
    distance_median: float
    distance_max: float
    noise: float
    position_rms: float | None
    position_median: float | None
    position_max: float | None
    position_noise: float | None
    _table: ClassVar[str] = "Alignment"

    def __post_init__(self) -> None:
        order = [3, 0, 1, 2] if self._given._scalar_first else [0, 1, 2, 3]
        for side in ("world", "body"):
            object.__setattr__(self, side, np.array(getattr(self, side))[order])
        object.__setattr__(self, "open", tuple(OpenDirection._of(row) for row in self.open))  # type: ignore[arg-type]

    def apply(self, keys: Keys | tuple[Any, Any]) -> Keys:
        """Other keys of the clock and the axes of `a` as they lie beside `b`, with all that they carry.

        Raises ArgumentError for keys that have dates where those of `a` have none, and the other way round.
        """
        keys = checked_keys(keys)
        self._given._clock.seconds("keys", keys.times[:1])
        return new_keys(self._task().aligned(keys._core), keys, clock_of=self._request.inputs["fixed"])

    def _rows(self) -> list[tuple[str, Any, str]]:
        rotations = [(side, " ".join(f"{value:.6g}" for value in self._members[side].values()),
                      f"Rotation of the {side} of a, as qw qx qy qz") for side in ("world", "body")]
        return rotations + super()._rows()
