# SPDX-License-Identifier: Apache-2.0
"""Smooth orientation curves through keyframes, with exact angular velocity, acceleration and jerk.

>>> import orispline as ori
>>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
>>> curve.sample(rate=2, derivatives=1).angular_velocities.shape
(7, 3)
"""
from __future__ import annotations

import importlib
from typing import TYPE_CHECKING, Any

from . import _core
from ._baked import BakedCurve
from ._blending import Blending, BlendingFinding, blending, read_blending
from ._composed import ComposedCurve, angle_between
from ._curve import Curve
from ._errors import AccessError, ArgumentError, ConvergenceError, DataError, Error, ShapeWarning
from ._files import write
from ._keys import Keys
from ._names import no_such_name as _no_such_name
from ._reading import read
from ._samples import Motion, Sample, Samples
from ._scipy_twins import RotationSpline, Slerp
from ._stack import CurveStack
from ._view import View

if TYPE_CHECKING:
    from . import notebook as notebook
    from . import spark as spark
    from . import tables as tables
    from ._comparison import Comparison, compare
    from ._mean import Mean, mean
    from ._measures import DistanceStatistics, Energies, HandleTurn, KeyStatistics, Peak, Peaks, Spread
    from ._online import OnlineCurve
    from ._pictures import plot_comparison, plot_sphere
    from ._rate_alignment import OpenRateDirection, RateAlignment
    from ._rates import Rates, read_rates
    from ._results import Alignment, Certificate, OpenDirection, Reduction, Retiming, Smoothing, Tuning
    from ._scene import BridgedRun, Channel, Clip, EditedClip, RetimedClip, Scene, SceneEdit, SceneReduction, SceneRetiming, SceneSmoothing, Skeleton, SmoothedJoint, Worst
    from ._scenes import clip_scene, read_scene, reduce_scene, retime_scene, shell_distance, smooth_scene
    from ._tasks import align, reduce, reduce_tracks, retime, smooth, tune

__all__ = ["AccessError", "Alignment", "ArgumentError", "BakedCurve", "Blending", "BlendingFinding", "BridgedRun", "Certificate", "Channel", "Clip", "Comparison", "ComposedCurve", "ConvergenceError", "Curve",
           "CurveStack", "DataError", "DistanceStatistics", "EditedClip", "Energies", "Error", "HandleTurn", "KeyStatistics", "Keys", "Mean", "Motion", "OnlineCurve", "OpenDirection", "OpenRateDirection",
           "Peak", "Peaks", "RateAlignment", "Rates", "Reduction", "RetimedClip", "Retiming", "RotationSpline", "Sample", "Samples", "Scene", "SceneEdit", "SceneReduction", "SceneRetiming", "SceneSmoothing",
           "ShapeWarning", "Skeleton", "Slerp", "SmoothedJoint", "Smoothing", "Spread", "Tuning", "View", "Worst", "align", "angle_between", "blending", "clip_scene", "compare", "mean", "methods", "plot_comparison", "plot_sphere",
           "read", "read_blending", "read_rates", "read_scene", "reduce", "reduce_scene", "reduce_tracks", "retime", "retime_scene", "shell_distance", "smooth", "smooth_scene",
           "tune", "write"]
__version__: str = _core.version

# Tasks and measures are imported when they are first asked for, so that a curve does not wait for them.
_LATER = {"_comparison": ("Comparison", "compare"),
          "_mean": ("Mean", "mean"),
          "_measures": ("DistanceStatistics", "Energies", "HandleTurn", "KeyStatistics", "Peak", "Peaks", "Spread"),
          "_online": ("OnlineCurve",),
          "_pictures": ("plot_comparison", "plot_sphere"),
          "_rate_alignment": ("OpenRateDirection", "RateAlignment"),
          "_rates": ("Rates", "read_rates"),
          "_results": ("Alignment", "Certificate", "OpenDirection", "Reduction", "Retiming", "Smoothing", "Tuning"),
          "_scene": ("BridgedRun", "Channel", "Clip", "EditedClip", "RetimedClip", "Scene", "SceneEdit", "SceneReduction", "SceneRetiming", "SceneSmoothing", "Skeleton", "SmoothedJoint", "Worst"),
          "_scenes": ("clip_scene", "read_scene", "reduce_scene", "retime_scene", "shell_distance", "smooth_scene"),
          "_tasks": ("align", "reduce", "reduce_tracks", "retime", "smooth", "tune")}
_PACKAGES = {"notebook": ("anywidget",), "spark": ("pyspark", "pyarrow"), "tables": ("pyarrow",)}  # with what they need


def __getattr__(name: str) -> Any:
    if name in _PACKAGES:
        return importlib.import_module(f"{__name__}.{name}")
    for module, names in _LATER.items():
        if name in names:
            found = globals()[name] = getattr(importlib.import_module(f"{__name__}.{module}"), name)
            return found
    if name.startswith("_"):
        raise AttributeError(f"module 'orispline' has no attribute {name!r}", name=name)
    raise _no_such_name("module 'orispline'", ["orispline"], name, __dir__())


def __dir__() -> list[str]:
    import importlib.util
    there = [package for package, needed in _PACKAGES.items() if all(map(importlib.util.find_spec, needed))]
    return sorted({*globals(), *__all__, *there})


def methods() -> list[dict[str, Any]]:
    """All methods, as the registry has them: name, title, source, continuity, parameters, choices and end rules.

    >>> import orispline as ori
    >>> [m["name"] for m in ori.methods()][:2]
    ['auto', 'auto5']
    """
    return list(_core.methods())
