# SPDX-License-Identifier: Apache-2.0
"""Orientations of a curve in the forms that SciPy's `Rotation` has."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import array_of, as_given
from ._checks import flag
from ._forms import check_order

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation


class Orienting:
    """What has an orientation at every time."""

    __slots__ = ()

    def rotation(self, t: Any) -> Rotation:
        """A SciPy Rotation, of a time or of (k,) times. A NaN time gives NaN."""
        return _rotation(self._on_host(t))

    def as_matrix(self, t: Any) -> NDArray[np.float64]:
        """(..., 3, 3) rotation matrices, body to world.

        >>> import orispline as ori
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]).as_matrix([[0.0, 1.0]]).shape
        (1, 2, 3, 3)
        """
        return as_given(t, _formed(self._on_host(t), _core.matrices, 3, 3))  # type: ignore[no-any-return]

    def as_rotvec(self, t: Any, degrees: bool = False) -> NDArray[np.float64]:
        """(..., 3) rotation vectors [rad], or in degrees; up to half a turn long."""
        found = _formed(self._on_host(t), _core.rotation_vectors, 3)
        return as_given(t, np.degrees(found) if flag("degrees", degrees) else found)  # type: ignore[no-any-return]

    def as_euler(self, t: Any, order: str, degrees: bool = False) -> NDArray[np.float64]:
        """(..., 3) Euler angles [rad], or in degrees, in an order as SciPy, which this needs, has it: `"ZYX"` turns about the axes of
        the body, `"zyx"` about those of the world. They jump where they pass half a turn. Raises ArgumentError for an order that there is not.

        >>> import orispline as ori
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp").as_euler(0.5, "ZYX", degrees=True).round(9).tolist()
        [90.0, 0.0, 0.0]
        """
        check_order("order", order)
        q = self._on_host(t)
        found = np.asarray(_rotation(q.reshape(-1, 4)).as_euler(order, degrees=flag("degrees", degrees)))
        return as_given(t, found.reshape(*q.shape[:-1], 3))  # type: ignore[no-any-return]

    def _on_host(self, t: Any) -> NDArray[np.float64]:
        return self._quaternions(t if isinstance(t, float) else array_of("t", t))

    def _quaternions(self, t: Any) -> NDArray[np.float64]:
        """(..., 4), x, y, z, w."""
        raise NotImplementedError


def _formed(q: NDArray[np.float64], form: Any, *shape: int) -> NDArray[np.float64]:
    """What the library makes of quaternions of any shape, which is of this shape for each."""
    found = np.empty((*q.shape[:-1], *shape))
    form(q.reshape(-1, 4), found.reshape(-1, *shape))
    return found


def _rotation(q: NDArray[np.float64]) -> Rotation:
    from scipy.spatial.transform import Rotation
    return Rotation(q, normalize=bool(np.isfinite(q).all()))
