# SPDX-License-Identifier: Apache-2.0
"""Smooth orientation curves through keyframes, with exact angular velocity, acceleration and jerk.

>>> import orispline as ori
>>> curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
>>> curve.sample(rate=2, derivatives=1).angular_velocities.shape
(7, 3)
"""
from __future__ import annotations

from typing import Any

from . import _core
from ._comparison import Comparison, compare
from ._curve import Curve
from ._errors import AccessError, ArgumentError, ConvergenceError, DataError, Error, ShapeWarning
from ._keys import Keys
from ._results import Certificate, Reduction, Retiming, Smoothing, Tuning
from ._samples import Motion, Samples
from ._tasks import reduce, reduce_tracks, retime, smooth, tune

__all__ = ["AccessError", "ArgumentError", "ConvergenceError", "Curve", "DataError", "Error", "Keys", "Motion", "Samples",
           "methods"]
__all__ += ["Certificate", "Comparison", "Reduction", "Retiming", "ShapeWarning", "Smoothing", "Tuning", "compare", "reduce",
            "reduce_tracks", "retime", "smooth", "tune"]
__version__: str = _core.version


def methods() -> list[dict[str, Any]]:
    """All methods, as the registry has them: name, title, source, continuity, parameters, choices and end rules.

    >>> import orispline as ori
    >>> [m["name"] for m in ori.methods()][:2]
    ['auto', 'auto5']
    """
    return list(_core.methods())
