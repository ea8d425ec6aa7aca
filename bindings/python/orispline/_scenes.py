# SPDX-License-Identifier: Apache-2.0
"""Files of skeletons read, reduced, smoothed and compared."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

from . import _core
from ._checks import flag, index_of, whole
from ._errors import ArgumentError, DataError, tell
from ._files import Source, source_of
from ._keys import SIGNS
from ._methods import method_words
from ._options import checked_cutoff, checked_threads, plain, takes
from ._request import Request
from ._scene import Scene, SceneEdit, SceneReduction, SceneRetiming, SceneSmoothing, positive

if TYPE_CHECKING:
    from ._types import Signs

TOLERANCES = ("tolerance", "position_tolerance", "world_tolerance")


def read_scene(path: Source, *, drop_duplicates: bool = False, signs: Signs | None = None, salvage: bool = False,
               rest_frame: int | None = None, scalar_first: bool = False) -> Scene:
    """The skeleton and the clips of a glTF or BVH file, in the format of its extension.

    Parameters
    ----------
    path : str, path or file object
        A file object is read to its end; its `name` tells the format. A .gltf may refer to no other file then.
    drop_duplicates : bool
        Of keys of a channel at equal times keep the first.
    signs : {"shortest", "as-given"}, optional
        Whether cubic rotations whose signs flip from key to key go the short way, or the long way as their signs say. Without it they do that, with a
        warning.
    salvage : bool
        Read the whole frames of a BVH file that was cut off.
    rest_frame : int, optional
        Frame of a BVH file, from 0, whose pose is the rest pose [that of its offsets, with no turns].
    scalar_first : bool
        The order of quaternions in all that the scene gives back: w, x, y, z.

    Raises
    ------
    DataError
        A file that is broken, with the clip, the joint and the key in the text.
    AccessError
        The file is not there or cannot be read.
    ArgumentError
        An extension of no format.

    Warns
    -----
    ShapeWarning
        What was noticed in the file.

    Examples
    --------
    >>> import orispline as ori, pathlib, tempfile
    >>> path = pathlib.Path(tempfile.mkdtemp()) / "nod.bvh"
    >>> _ = path.write_text("HIERARCHY\\nROOT head\\n{\\nOFFSET 0 1.5 0\\nCHANNELS 3 Zrotation Xrotation Yrotation\\n"
    ...                     "End Site\\n{\\nOFFSET 0 0.2 0\\n}\\n}\\nMOTION\\nFrames: 3\\nFrame Time: 0.5\\n0 0 0\\n0 20 0\\n0 0 0\\n")
    >>> scene = ori.read_scene(path)
    >>> scene.clips[0].channels
    (Channel('head', 'rotation', 'linear', 3 keys),)
    >>> scene.write(path.with_suffix(".glb"))
    """
    if signs is not None:
        index_of("signs", signs, SIGNS)
    name, content = source_of(path)
    core, warnings = _core.read_scene(name, flag("drop_duplicates", drop_duplicates), signs, flag("salvage", salvage),
                                      None if rest_frame is None else whole("rest_frame", rest_frame, 0, 10**9), content)
    tell(warnings)
    return Scene._of(core, flag("scalar_first", scalar_first))


@takes("ClipReduceOptions", without=("for",))
def reduce_scene(scene: Scene, tolerance: Any = None, *, method: Any = None, closed: bool = False,
                 position_scale: float | None = None, for_: Any = None, threads: int = 0, **options: Any) -> tuple[Scene, SceneReduction]:
    """A scene with the fewest keys found that look the same, and what was done to it.

    One of `tolerance`, `position_tolerance` and `world_tolerance` is required. Angles are in radians and lengths in
    metres; texts have their unit, such as "0.1deg" and "2mm".

    Parameters
    ----------
    scene : Scene
    method : str, Blending or Curve, optional
        "cubicspline", which is glTF's and taken without one; "smallest", taken with `compress`, which writes each channel by that or by "slerp", or leaves it as it was,
        whichever has the fewest bytes; "hermite-c1", whose keys have one rate each; "slerp", which makes linear channels; or
        another one that `reduce` takes, written as cubics within the tolerance.
    closed : bool
        With "cubicspline" and "hermite-c1", channels that end as they begin have the same tangents at both ends.
    position_scale : float, optional
        Metres in one unit of length of the file, such as 0.01 [1 for glTF]. A BVH file has no unit: tolerances of lengths
        want it.
    for_ : {"any", "meshopt"}, optional
        What the file goes through next. For gltf-transform's "meshopt", which breaks splines of rotations, rotations are linear.
    threads : int
        At most so many at work, 0 means one for each core. The result is the same on any.
    {options}

    Returns
    -------
    (Scene, SceneReduction)
        With `compress` the file that you write wants it too: `Scene.write(path, compress="meshopt")`.
        The numbers of the keys fit into the float32 of glTF.

    Raises
    ------
    ArgumentError
        No tolerance, an option out of its range, a method that does not suit, or a length for a file without a unit.

    Warns
    -----
    ShapeWarning
        Keys that single precision does not hold within the tolerance.

    Examples
    --------
    >>> import orispline as ori
    >>> scene = ori.read_scene("mage.glb")  # doctest: +SKIP
    >>> small, report = ori.reduce_scene(scene, world_tolerance=0.002)  # doctest: +SKIP
    >>> small.write("small.glb")  # doctest: +SKIP
    """
    _checked(scene)
    stated = plain({"tolerance": tolerance, "for": for_, **options})
    if all(stated.get(name) is None for name in TOLERANCES):
        raise ArgumentError(f"tolerance: found none, wanted one of {', '.join(TOLERANCES)}")
    words = None if method is None else method_words(method)
    scale = None if position_scale is None else positive("position_scale", position_scale)
    is_of_scenes_alone = words in ("cubicspline", "smallest")
    settings = {"closed": flag("closed", closed), "position_scale": scale, "threads": checked_threads(threads),
                "methods": words if is_of_scenes_alone else None}
    methods = [] if is_of_scenes_alone or words is None else [words]
    found, = Request("reduce", {"recording": scene}, stated, settings, methods=methods).told()
    return Scene._of(found.scene(scene._core), scene._scalar_first), SceneReduction._of(found)


@takes("SmoothOptions", without=("gyro", "gyro_noise", "gyro_offset", "gyro_bias", "sigma"))
def smooth_scene(scene: Scene, *, cutoff: float | str | None = None, threads: int = 0, **options: Any) -> tuple[Scene, SceneSmoothing]:
    """A scene whose joints move smoothly, and what was found of them.

    The rotations of every joint are smoothed by themselves, as `smooth` does it; with the translation of a joint that has the
    same key times and moves, that too. The keys stay at their times. Rotations that rest, that are steps or splines, or that
    have fewer than 20 keys are left as they are.

    Parameters
    ----------
    scene : Scene
    cutoff : float or str, optional
        Cut-off frequency 1/(2πτ) [Hz] in the place of the smoothing time τ: half of a motion at this frequency is left.
    threads : int
        At most so many at work, 0 means one for each core. The result is the same on any.
    {options}

    Returns
    -------
    (Scene, SceneSmoothing)

    Raises
    ------
    ArgumentError
        An option that there is not, out of its range, that contradicts another, or that clips have no room for, such as `gyro`.
    ConvergenceError
        No smooth motion was found.

    Warns
    -----
    ShapeWarning
        Rotations that cannot be smoothed.

    Examples
    --------
    >>> import orispline as ori
    >>> scene = ori.read_scene("walk.bvh")  # doctest: +SKIP
    >>> smooth, found = ori.smooth_scene(scene)  # doctest: +SKIP
    >>> max(found.joints, key=lambda joint: joint.noise).joint  # doctest: +SKIP
    'LeftHand'
    >>> smooth.write("smooth.bvh")  # doctest: +SKIP
    """
    settings = {**checked_cutoff(cutoff, options), "threads": checked_threads(threads)}
    found, = Request("smooth", {"recording": _checked(scene)}, plain(options), settings).told()
    return Scene._of(found.scene(scene._core), scene._scalar_first), SceneSmoothing._of(found)


@takes("ClipEdits", without=("from",))
def clip_scene(scene: Scene, *, from_: float | None = None, append: Scene | None = None, append_clip: str | None = None, root: str | None = None,
               extract_root: str | None = None, root_node: str | None = None, in_place: str | None = None, threads: int = 0,
               **options: Any) -> tuple[Scene, SceneEdit]:
    """A scene with its clips cut, turned round, joined, closed into loops, or without the way of a root, and what was done to them.

    Parameters
    ----------
    scene : Scene
    from_ : float, optional
        Keep the clips from this time on [s].
    append : Scene, optional
        The same skeleton with the clip that comes behind the only one of `scene`.
    append_clip : str, optional
        The name of that clip, where `append` has several.
    root : str, optional
        The joint whose way a loop keeps, and goes on in the appended clip.
    extract_root : str, optional
        The joint whose way across and heading about up go into a node above it.
    root_node : str, optional
        That node, in the place of the topmost one.
    in_place : str, optional
        The joint whose way across and heading about up are taken out.
    threads : int
        At most so many at work, 0 means one for each core. The result is the same on any.
    {options}

    Returns
    -------
    (Scene, SceneEdit)

    Raises
    ------
    ArgumentError
        A time outside of a clip, an option that contradicts another, a joint that is not there.
    DataError
        Skeletons that differ, with the joint; a loop of fewer than three keys.

    Warns
    -----
    ShapeWarning
        Clips with weights, which stay as they are.

    Examples
    --------
    >>> import orispline as ori
    >>> scene = ori.read_scene("walk.bvh")  # doctest: +SKIP
    >>> cycle, found = ori.clip_scene(scene, from_=0.4, to=1.6, loop=True, root="Hips", shift=0)  # doctest: +SKIP
    >>> found.clips[0].closing  # doctest: +SKIP
    'bent'
    """
    names = {"append_clip": append_clip, "root": root, "extract_root": extract_root, "root_node": root_node, "in_place": in_place}
    for name, value in names.items():
        if value is not None and not isinstance(value, str):
            raise TypeError(f"{name}: found {value!r}, wanted a name")
    stated = plain({"from": from_, **options})
    settings = {name: value for name, value in names.items() if value is not None} | {"threads": checked_threads(threads)}
    inputs = {"scene": _checked(scene)} | ({} if append is None else {"append": _checked(append, "append")})
    found, = Request("clip", inputs, stated, settings).told()
    return Scene._of(found.scene(scene._core), scene._scalar_first), SceneEdit._of(found)


@takes("RetimeOptions", without=("max_torque", "inertia", "insert_keys", "constant_rate", "constant_speed", "path_times", "ease"))
def retime_scene(scene: Scene, *, method: Any = None, **options: Any) -> tuple[Scene, SceneRetiming]:
    """A scene whose clips are slowed until every joint is within limits, each clip by one clock for all its joints.

    Rates are those of a joint as seen from its parent, speeds those of its translation. The motion of linear channels is the method's curve
    through their keys, that of cubics the cubic.

    Parameters
    ----------
    scene : Scene
    method : str, Blending or Curve, optional
        The method of the curve through linear keys [auto].
    {options}

    Returns
    -------
    (Scene, SceneRetiming)

    Raises
    ------
    ArgumentError
        Limits that are absent, not greater than 0 or cannot be met, a limit of lengths for a file without a unit.
    DataError
        A clip that has no duration.

    Warns
    -----
    ShapeWarning
        Bounds that are loose, cubics whose peaks are measured and the like.

    Examples
    --------
    >>> import orispline as ori
    >>> scene = ori.read_scene("walk.bvh")  # doctest: +SKIP
    >>> slow, found = ori.retime_scene(scene, max_rate="400deg/s")  # doctest: +SKIP
    >>> found.clips[0].time_scale  # doctest: +SKIP
    1.24
    """
    settings = {} if method is None else {"method": method_words(method)}
    found, = Request("retime", {"keys": _checked(scene)}, plain(options), settings).told()
    return Scene._of(found.scene(scene._core), scene._scalar_first), SceneRetiming._of(found)


def shell_distance(a: Scene, b: Scene, shell: float = 0.03) -> dict[str, dict[str, float]]:
    """How far apart two scenes of one skeleton are in the world: of every clip and joint the largest shell distance.

    That is the largest distance between the same points of both: the joint, and those that are `shell` off it along each
    of its axes. It tells how far a skin that hangs on the joint is off.

    Parameters
    ----------
    a, b : Scene
        Clips that have the same name are the same, and so is the only clip of both; all of `a` are compared, at the times of
        its keys. Joints are the same at the same place in the tree, else by their names.
    shell : float
        In the unit of the file: 3 cm where that is the metre.

    Returns
    -------
    dict
        By the names of clips and joints of `a`; joints that `b` has not are left out. Of equal names the largest.

    Raises
    ------
    DataError
        A clip that `b` has not.

    Warns
    -----
    ShapeWarning
        Clips or joints of one name that only their order tells apart.
    """
    first, second = _checked(a, "a"), _checked(b, "b")
    request = Request("difference", {"first": first, "second": second}, {"shell": positive("shell", shell)})
    distances: dict[str, dict[str, float]] = {}
    if not first.clips:
        return distances
    outcome, = request.run()
    found = outcome.attributes()
    for name in found["only_in_first"]:
        error = DataError(f"b: found no clip '{name}', wanted every clip of a")
        error.argument = "b"
        raise error
    tell(outcome.warnings)
    for clip, joints in found["clips"]:
        of_clip = distances.setdefault(clip, {})
        for joint, distance in joints:
            of_clip[joint] = max(of_clip.get(joint, 0.0), distance)
    return distances


def _checked(scene: Any, name: str = "scene") -> Scene:
    if not isinstance(scene, Scene):
        raise TypeError(f"{name}: found {type(scene).__name__}, wanted a Scene")
    return scene
