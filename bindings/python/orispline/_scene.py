# SPDX-License-Identifier: Apache-2.0
"""A skeleton with its clips, and what was done to it."""
from __future__ import annotations

import dataclasses
import functools
from typing import Any, ClassVar

import numpy as np
from numpy.typing import NDArray

from ._checks import flag, real
from ._errors import ArgumentError, tell
from ._files import Target, target_of, write_bytes
from ._request import Request
from ._told import Told
from ._view import Viewed, now

Array = NDArray[np.float64]


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Skeleton:
    """The joints of a scene, in an order in which parents come first, and where they are without a clip.

    A point p of a joint is at translation + rotation (scale * p) in the frame of its parent.

    Attributes
    ----------
    names
        Of the joints, or of what else is placed by a parent.
    parents
        (n,) indices of joints; -1 where there is no parent.
    translations
        (n, 3) of the rest pose, in the unit of the file, in the frame of the parent.
    rotations
        (n, 4) quaternions of the rest pose, joint to parent.
    scales
        (n, 3) of the rest pose, along the axes of the joint.
    """

    names: tuple[str, ...]
    parents: NDArray[np.intp]
    translations: Array
    rotations: Array
    scales: Array

    def __len__(self) -> int:
        return len(self.names)

    def __repr__(self) -> str:
        return f"Skeleton({len(self)} joints)"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Channel:
    """The rotation, translation or scale of a joint over time.

    Attributes
    ----------
    joint
        Its name.
    index
        Its place in the skeleton.
    property
        "rotation", "translation" or "scale".
    interpolation
        "step", "linear" or "cubicspline", as glTF defines them.
    times
        (n,) of the keys [s].
    values
        (n, 4) quaternions, joint to parent, or (n, 3) vectors in the frame of the parent.
    in_tangents, out_tangents
        Time derivatives of the components before and after each key [1/s], of "cubicspline"; else None.
    """

    joint: str
    index: int
    property: str
    interpolation: str
    times: Array
    values: Array
    in_tangents: Array | None
    out_tangents: Array | None

    def __len__(self) -> int:
        return len(self.times)

    def __repr__(self) -> str:
        return f"Channel({self.joint!r}, {self.property!r}, {self.interpolation!r}, {len(self)} keys)"


@dataclasses.dataclass(frozen=True, eq=False, repr=False)
class Clip(Viewed):
    """One animation of a skeleton. Its page shows the skeleton as it moves.

    Attributes
    ----------
    name
        As the file has it.
    start, end
        Times of its first and its last key [s], of what else the file moves in it, such as weights, too.
    """

    name: str
    start: float
    end: float
    _core: Any
    _index: int
    _names: tuple[str, ...]
    _scalar_first: bool

    @functools.cached_property
    def channels(self) -> tuple[Channel, ...]:
        """The rotations, then the translations, then the scales."""
        return tuple(Channel(self._names[joint], joint, kind, interpolation, times, *(
            _ordered(rows, kind == "rotation" and self._scalar_first) for rows in arrays))
            for joint, kind, interpolation, times, *arrays in self._core.channels(self._index))

    def _page(self) -> bytes:
        """The skeleton as this clip moves it."""
        return page_of_scene(self._core.with_clip(self._index))

    def __repr__(self) -> str:
        return f"Clip({self.name!r}, {self.start:g} … {self.end:g} s)"


class Scene(Viewed):
    """A skeleton with its clips, of `read_scene`. It never changes.

    What else the file holds, such as meshes and materials, is kept, and written again in the same format. Its page shows the
    skeleton as the clips move it.
    """

    def __init__(self) -> None:
        raise TypeError("found a call of Scene, wanted one of read_scene")

    _core: Any
    _scalar_first: bool

    @classmethod
    def _of(cls, core: Any, scalar_first: bool) -> Scene:
        scene = cls.__new__(cls)
        scene._core, scene._scalar_first = core, scalar_first
        return scene

    @property
    def name(self) -> str:
        """That of the file."""
        return str(self._core.name)

    @functools.cached_property
    def skeleton(self) -> Skeleton:
        """The joints."""
        names, parents, translations, rotations, scales = self._core.skeleton
        return Skeleton(tuple(names), np.array(parents, np.intp), translations, _ordered(rotations, self._scalar_first), scales)

    @functools.cached_property
    def clips(self) -> tuple[Clip, ...]:
        """The animations, in the order of the file."""
        return tuple(Clip(name, start, end, self._core, i, self.skeleton.names, self._scalar_first)
                     for i, (name, start, end) in enumerate(self._core.clips))

    def _page(self) -> bytes:
        """The skeleton as the clips move it."""
        return page_of_scene(self._core)

    def write(self, path: Target, *, output_euler: str | None = None, rate: float | None = None, position_scale: float | None = None,
              compress: str | None = None, bones: bool = True) -> None:
        """Writes the scene in the format of the path's extension: .glb, .gltf or .bvh.

        The file appears complete or not at all.

        Parameters
        ----------
        path : str, path or file object
            A file object, whose `name` tells the format, is written where it stands, once all is known to succeed, and stays open.
            A .glb wants one for bytes.
        output_euler : str, optional
            Order of the angles in BVH, such as "ZYX". Without it that of the file that was read, else ZYX.
        rate : float, optional
            Frames per second in BVH [Hz]. Without it that of the keys, which must be even.
        position_scale : float, optional
            Metres in one unit of length of a BVH file that was read, such as 0.01: glTF gets its lengths in metres. Without it they are kept.
        compress : {"none", "meshopt"}, optional
            Compress the keys of glTF by EXT_meshopt_compression, without rounding them; `reduce_scene` rounds them within its tolerances.
        bones : bool
            Give a skeleton without a mesh a few triangles for each joint in glTF, so that viewers show something.

        Raises
        ------
        AccessError
            The file cannot be written.
        ArgumentError
            An extension of no format, or an order of angles that there is not.
        DataError
            What the format cannot hold, such as uneven keys in BVH.

        Warns
        -----
        ShapeWarning
            What the format has no room for.
        """
        if output_euler is not None and not isinstance(output_euler, str):
            raise TypeError(f"output_euler: found {output_euler!r}, wanted a text such as 'ZYX'")
        hertz = None if rate is None else positive("rate", rate)
        name, file = target_of(path)
        metres = None if position_scale is None else positive("position_scale", position_scale)
        if compress is not None and not isinstance(compress, str):
            raise TypeError(f"compress: found {compress!r}, wanted a text such as 'meshopt'")
        content, warnings = self._core.written(name, output_euler, hertz, metres, compress, flag("bones", bones))
        write_bytes(name, file, content)
        tell(warnings)

    def __repr__(self) -> str:
        return f"Scene({self.name!r}, {len(self.skeleton)} joints, {len(self._core.clips)} clips)"


@dataclasses.dataclass(frozen=True)
class Worst:
    """The largest of some distances, and where it is.

    Attributes
    ----------
    value
        The distance: an angle [rad] or a length.
    clip, joint
        Their names; empty where all distances are 0.
    time
        [s].
    """

    value: float
    clip: str
    joint: str
    time: float


class _DoneToScene(Told, Viewed):
    """What a task did to a scene: its document, its summary and its page."""

    _core: Any
    _task: ClassVar[tuple[str, str, str]]  # what it is, the function that gives it, and what its page calls the clips afterwards

    def _page(self) -> bytes:
        """Both skeletons, before and after."""
        if self._core is None:
            what, task, _ = self._task
            raise ArgumentError(f"found a {what} that was copied or pickled, wanted the one that {task} gave: it alone has the clips of its page")
        return bytes(self._core.page(now(), self._task[2]))

    def __getstate__(self) -> dict[str, Any]:
        return {**self.__dict__, "_core": None}


@dataclasses.dataclass(frozen=True)
class SceneReduction(_DoneToScene):
    """What `reduce_scene` did to the clips of a scene.

    Attributes
    ----------
    rotation_keys, rotation_keys_before
        Keys of rotations that had three or more.
    rotation_tracks
        How many rotations had so many.
    open_tracks
        Those of them that do not end as they begin.
    translation_keys, translation_keys_before
        Keys of translations.
    angle
        The largest angle between a joint and its motion before, at any time, in the frame of its parent [rad].
    translation
        The largest distance from its motion before there; its unit is that of `distance`.
    distance
        The largest shell distance in the world [m]; in the unit of the file where nobody says what it is.
    from_smooth, from_stored
        The largest angles from the curve `auto` through the keys before, and from what the file says [rad].
    cuts
        Jumps that were taken as no motion.
    tracks_before, tracks_left_out
        Tracks of rotations, translations and scales before, and those of them that the rest pose stands for.
    """

    rotation_keys: int
    rotation_keys_before: int
    rotation_tracks: int
    open_tracks: int
    translation_keys: int
    translation_keys_before: int
    angle: Worst
    translation: Worst
    distance: Worst
    from_smooth: Worst
    from_stored: Worst
    cuts: int
    tracks_before: int
    tracks_left_out: int
    _members: dict[str, Any] = dataclasses.field(repr=False, compare=False)
    _summary: str = dataclasses.field(repr=False, compare=False)
    _core: Any = dataclasses.field(repr=False, compare=False)
    _task: ClassVar[tuple[str, str, str]] = "reduction", "reduce_scene", "reduced"

    @classmethod
    def _of(cls, core: Any) -> SceneReduction:
        found: dict[str, Any] = {name: Worst(*value) if isinstance(value, tuple) else value
                                 for name, value in core.attributes().items()}
        return cls(**found, _members=core.members(), _summary=core.summary(), _core=core)


@dataclasses.dataclass(frozen=True)
class SmoothedJoint:
    """What `smooth_scene` found of the rotations of a joint in a clip.

    Attributes
    ----------
    clip, joint
        Their names.
    smoothing_time
        [s].
    noise
        Of a key, about each axis [rad].
    rejected
        How many keys count as outliers.
    change
        The largest angle between a key before and after [rad].
    change_time
        Where that is [s].
    """

    clip: str
    joint: str
    smoothing_time: float
    noise: float
    rejected: int
    change: float
    change_time: float


@dataclasses.dataclass(frozen=True)
class BridgedRun:
    """Frames in a row in which joints jump away and back while the others go on, which `smooth_scene` bridged.

    Attributes
    ----------
    clip, joints
        Their names.
    first_frame
        Counted from 0.
    frames
        How many they are.
    start, end
        Times of the first and the last of them [s].
    jump
        The largest turn by which one of the joints goes away or back [rad].
    """

    clip: str
    joints: tuple[str, ...]
    first_frame: int
    frames: int
    start: float
    end: float
    jump: float


@dataclasses.dataclass(frozen=True)
class SceneSmoothing(_DoneToScene):
    """What `smooth_scene` did to the clips of a scene.

    Attributes
    ----------
    joints
        Of every rotation that was smoothed, clip after clip.
    left
        How many rotations are as they were: they rest, are steps or splines, have too few keys, or cannot be smoothed.
    refused
        How many of them cannot be smoothed, of which a warning tells.
    runs
        Frames that were bridged, clip after clip.
    """

    joints: tuple[SmoothedJoint, ...]
    left: int
    refused: int
    runs: tuple[BridgedRun, ...]
    _members: dict[str, Any] = dataclasses.field(repr=False, compare=False)
    _summary: str = dataclasses.field(repr=False, compare=False)
    _core: Any = dataclasses.field(repr=False, compare=False)
    _task: ClassVar[tuple[str, str, str]] = "smoothing", "smooth_scene", "smooth"

    @classmethod
    def _of(cls, core: Any) -> SceneSmoothing:
        found = core.attributes()
        return cls(tuple(SmoothedJoint(*joint) for joint in found["joints"]), found["left"], found["refused"],
                   tuple(BridgedRun(*run) for run in found["runs"]), core.members(), core.summary(), core)


@dataclasses.dataclass(frozen=True)
class EditedClip:
    """What `clip_scene` did to a clip.

    Attributes
    ----------
    clip
        Its name.
    start, end
        Which part of it was kept, in its times before [s].
    closing
        How a loop was closed: "none", it went round already; "frame", it got its closing key; "bent", the difference of its ends was
        spread over it. None without a loop.
    rotation_change, translation_change
        The largest change of a joint that the loop made.
    travel, turn
        How far the root of a loop goes in one round, and by which angle it turns [rad].
    seam, seam_rate
        The largest angle from a last rotation to the first one [rad], and the largest change of an angular velocity there [rad/s].
    """

    clip: str
    start: float
    end: float
    closing: str | None
    rotation_change: Worst
    translation_change: Worst
    travel: float
    turn: float
    seam: float
    seam_rate: float


@dataclasses.dataclass(frozen=True)
class SceneEdit(_DoneToScene):
    """What `clip_scene` did to the clips of a scene.

    Attributes
    ----------
    clips
        Of each what was done.
    """

    clips: tuple[EditedClip, ...]
    _members: dict[str, Any] = dataclasses.field(repr=False, compare=False)
    _summary: str = dataclasses.field(repr=False, compare=False)
    _core: Any = dataclasses.field(repr=False, compare=False)
    _task: ClassVar[tuple[str, str, str]] = "edit", "clip_scene", "edited"

    @classmethod
    def _of(cls, core: Any) -> SceneEdit:
        clips = []
        for clip in core.attributes()["clips"]:
            values: list[Any] = [Worst(*value) if isinstance(value, tuple) else value for value in clip]
            clips.append(EditedClip(*values))
        return cls(tuple(clips), core.members(), core.summary(), core)


@dataclasses.dataclass(frozen=True)
class RetimedClip:
    """How `retime_scene` slowed a clip.

    Attributes
    ----------
    clip
        Its name.
    slowing
        "uniform", "per-interval" or "fastest-keys"; the first also where intervals by themselves save no time.
    duration_before, duration
        From its first key to its last [s], as it was and as it is.
    time_scale
        The new duration divided by the one before.
    rests
        Intervals in which all joints rest.
    slack
        Share by which less slowing might be enough.
    """

    clip: str
    slowing: str
    duration_before: float
    duration: float
    time_scale: float
    rests: int
    slack: float


@dataclasses.dataclass(frozen=True)
class SceneRetiming(_DoneToScene):
    """What `retime_scene` did to the clips of a scene.

    Attributes
    ----------
    clips
        Of each how it was slowed.
    """

    clips: tuple[RetimedClip, ...]
    _members: dict[str, Any] = dataclasses.field(repr=False, compare=False)
    _summary: str = dataclasses.field(repr=False, compare=False)
    _core: Any = dataclasses.field(repr=False, compare=False)
    _task: ClassVar[tuple[str, str, str]] = "retiming", "retime_scene", "retimed"

    @classmethod
    def _of(cls, core: Any) -> SceneRetiming:
        clips = tuple(RetimedClip(*clip) for clip in core.attributes()["clips"])
        return cls(clips, core.members(), core.summary(), core)


def page_of_scene(core: Any) -> bytes:
    """The skeleton as the clips of a scene of the library move it."""
    outcome, = Request("inspect", {"keys": core}, {}).run()
    return outcome.page(now())


def _ordered(rows: Array | None, scalar_first: bool) -> Any:
    return np.ascontiguousarray(rows[:, [3, 0, 1, 2]]) if scalar_first and rows is not None else rows


def positive(name: str, value: Any) -> float:
    """A finite number greater than 0."""
    number = real(name, value)
    if not (0 < number < np.inf):
        raise ArgumentError(f"{name}: found {number:g}, wanted a finite number greater than 0")
    return number
