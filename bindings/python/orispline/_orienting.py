# SPDX-License-Identifier: Apache-2.0
"""Orientations of a curve in the forms of SciPy."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ._checks import flag
from ._forms import check_order

if TYPE_CHECKING:
    from scipy.spatial.transform import Rotation


class Orienting:
    """What has an orientation at every time."""

    __slots__ = ()

    def rotation(self, t: Any) -> Rotation:
        """A SciPy Rotation, of a time or of (k,) times. A NaN time gives NaN."""
        return _rotation(self._quaternions(t))

    def as_matrix(self, t: Any) -> NDArray[np.float64]:
        """(..., 3, 3) rotation matrices, body to world. Needs SciPy, as all of these forms.

        >>> import orispline as ori
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]).as_matrix([[0.0, 1.0]]).shape
        (1, 2, 3, 3)
        """
        return self._each(t, lambda rotation: rotation.as_matrix())

    def as_rotvec(self, t: Any, degrees: bool = False) -> NDArray[np.float64]:
        """(..., 3) rotation vectors [rad], or in degrees; up to half a turn long."""
        return self._each(t, lambda rotation: rotation.as_rotvec(degrees=flag("degrees", degrees)))

    def as_euler(self, t: Any, order: str, degrees: bool = False) -> NDArray[np.float64]:
        """(..., 3) Euler angles [rad], or in degrees, in an order as SciPy has it: `"ZYX"` turns about the axes of the body, `"zyx"`
        about those of the world. They jump where they pass half a turn. Raises ArgumentError for an order that there is not.

        >>> import orispline as ori
        >>> ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "slerp").as_euler(0.5, "ZYX", degrees=True).round(9).tolist()
        [90.0, 0.0, 0.0]
        """
        check_order("order", order)
        return self._each(t, lambda rotation: rotation.as_euler(order, degrees=flag("degrees", degrees)))

    def _each(self, t: Any, form: Any) -> NDArray[np.float64]:
        q = self._quaternions(t)
        found = np.asarray(form(_rotation(q.reshape(-1, 4))))
        return found.reshape(*q.shape[:-1], *found.shape[1:])

    def _quaternions(self, t: Any) -> NDArray[np.float64]:
        """(..., 4), x, y, z, w."""
        raise NotImplementedError


def _rotation(q: NDArray[np.float64]) -> Rotation:
    from scipy.spatial.transform import Rotation
    return Rotation(q, normalize=bool(np.isfinite(q).all()))
