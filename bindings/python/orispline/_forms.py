# SPDX-License-Identifier: Apache-2.0
"""The forms in which callers have orientations, as the quaternions x, y, z, w that the library takes."""
from __future__ import annotations

import os
import re
from typing import Any

import numpy as np

from ._arrays import Array, array_of, numbers
from ._checks import index_of, text
from ._errors import ArgumentError, at_key
from ._files import path_text

FORMS = "(n, 4) quaternions, (n, 3, 3) matrices or a SciPy Rotation, (n, 4, 4) poses, or (n, 3) angles with euler='ZYX'"
ANGLES = {"rad": 1.0, "deg": np.pi / 180, "mrad": 1e-3, "arcsec": np.pi / 648_000}  # [rad]


def poses(name: str, rotations: Any, *, scalar_first: bool) -> tuple[Array, Array | None]:
    """(n, 4) of quaternions, of (n, 3, 3) matrices, of a SciPy Rotation or a list of them; with (n, 3) positions those of (n, 4, 4)
    matrices and of a SciPy RigidTransform."""
    if isinstance(rotations, (list, tuple)) and rotations and all(hasattr(one, "as_quat") for one in rotations):
        return np.vstack([one.as_quat() for one in rotations]), None
    if hasattr(rotations, "as_components"):
        positions, rotations = rotations.as_components()
        return quaternions(name, rotations, scalar_first=False), np.array(positions, ndmin=2)
    if hasattr(rotations, "as_quat"):
        rotations, scalar_first = rotations.as_quat(), False
    _check_columns(name, rotations, "wxyz" if scalar_first else "xyzw")
    array = array_of(name, rotations)
    if array.ndim == 3 and array.shape[1:] == (4, 4):
        return _of_poses(name, numbers(name, array, (None, 4, 4)))
    if array.ndim == 3 and array.shape[1:] == (3, 3):
        return _of_matrices(name, numbers(name, array, (None, 3, 3))), None
    array = numbers(name, array, (None, 4), FORMS)
    return np.ascontiguousarray(array[:, [1, 2, 3, 0]]) if scalar_first else array, None


def _check_columns(name: str, frame: Any, order: str) -> None:
    """That the columns of a frame whose names end in w, x, y and z stand in that order, in which they are read."""
    columns = {str(column)[-1:].lower(): column for column in getattr(frame, "columns", ()) if isinstance(column, str)}
    if sorted(columns) == sorted(order) and "".join(columns) != order:
        raise ArgumentError(f"{name}: found the columns {', '.join(columns.values())}, wanted {', '.join(columns[letter] for letter in order)}, "
                            f"or scalar_first={order[0] != 'w'}")


def quaternions(name: str, rotations: Any, *, scalar_first: bool) -> Array:
    """Of orientations alone."""
    found, positions = poses(name, rotations, scalar_first=scalar_first)
    if positions is not None:
        raise ArgumentError(f"{name}: found poses, wanted orientations without positions")
    return found


def rotation_text(name: str, rotation: Any, *, scalar_first: bool = False) -> str | None:
    """One rotation as the library reads it, by names; a text and the path of a file are left as they are."""
    if rotation is None or isinstance(rotation, str):
        return rotation
    if isinstance(rotation, os.PathLike):
        return path_text(rotation)
    if hasattr(rotation, "as_quat"):
        rotation, scalar_first = rotation.as_quat(), False
    array = array_of(name, rotation)
    found = quaternions(name, array[None] if array.shape in ((4,), (3, 3)) else array, scalar_first=scalar_first)
    if len(found) != 1:
        raise ArgumentError(f"{name}: found {len(found)} rotations, wanted one")
    return ",".join(f"{component}={float(value)!r}" for component, value in zip(("qx", "qy", "qz", "qw"), found[0]))


def inverse_text(name: str, rotation: Any) -> str | None:
    """The inverse of a SciPy Rotation, by names."""
    return rotation_text(name, rotation.inv())


def of_euler(name: str, angles: Any, order: Any, unit: Any) -> Array:
    """(n, 4) quaternions of (n, 3) angles: capitals are turns about the axes of the body, small letters about those of the world."""
    check_order("euler", order)
    factor = list(ANGLES.values())[index_of("angle_unit", unit, tuple(ANGLES))]
    half = 0.5 * factor * numbers(name, angles, (None, 3), "(n, 3) angles, as euler= says")
    turns = []
    for letter, column in zip(order, half.T):
        turn = np.zeros((len(half), 4))
        turn[:, "xyz".index(letter.lower())], turn[:, 3] = np.sin(column), np.cos(column)
        turns.append(turn)
    first, second, third = turns if order.isupper() else reversed(turns)
    return product_of(product_of(first, second), third)


def check_order(name: str, order: Any) -> None:
    """Of Euler angles."""
    if not re.fullmatch(r"([XYZ])(?!\1)([XYZ])(?!\2)[XYZ]|([xyz])(?!\3)([xyz])(?!\4)[xyz]", text(name, order)):
        raise ArgumentError(f"{name}: found {order!r}, wanted three letters such as 'ZYX' or 'zyx', no two neighbours the same")


def product_of(p: Array, q: Array) -> Array:
    """Hamilton's, row by row."""
    vector = p[..., 3:] * q[..., :3] + q[..., 3:] * p[..., :3] + np.cross(p[..., :3], q[..., :3])
    scalar = p[..., 3:] * q[..., 3:] - (p[..., :3] * q[..., :3]).sum(axis=-1, keepdims=True)
    return np.concatenate([vector, scalar], axis=-1)


def _of_poses(name: str, matrices: Array) -> tuple[Array, Array]:
    bad = np.isfinite(matrices).all(axis=(1, 2)) & (np.abs(matrices[:, 3] - [0, 0, 0, 1]) > 1e-9).any(axis=1)
    if bad.any():
        raise at_key(int(bad.argmax()), f"{name}: found the last row {matrices[bad][0, 3].tolist()} of a pose, wanted 0, 0, 0, 1")
    return _of_matrices(name, matrices[:, :3, :3]), np.ascontiguousarray(matrices[:, :3, 3])


def _of_matrices(name: str, matrices: Array) -> Array:
    """Shepperd's way: by the largest of the four squares 4 w², 4 x², 4 y², 4 z². NaN stays NaN."""
    far = np.abs(matrices @ matrices.transpose(0, 2, 1) - np.eye(3)).max(axis=(1, 2), initial=0.0)
    bad = np.isfinite(matrices).all(axis=(1, 2)) & (~(far < 1e-3) | (np.linalg.det(matrices) < 0))
    if bad.any():
        raise at_key(int(bad.argmax()), f"{name}: found a matrix that is no rotation, wanted an orthonormal one of determinant 1")
    x, y, z = (matrices[:, i, i] for i in range(3))
    squares = np.stack([1 + x - y - z, 1 - x + y - z, 1 - x - y + z, 1 + x + y + z], axis=1)
    largest = squares.argmax(axis=1)
    m = matrices
    sums = np.empty((len(m), 4, 4))
    for i in range(4):
        sums[:, i, i] = squares[:, i]
    for (i, j), value in {(0, 1): m[:, 1, 0] + m[:, 0, 1], (0, 2): m[:, 0, 2] + m[:, 2, 0],
                          (1, 2): m[:, 2, 1] + m[:, 1, 2], (0, 3): m[:, 2, 1] - m[:, 1, 2],
                          (1, 3): m[:, 0, 2] - m[:, 2, 0], (2, 3): m[:, 1, 0] - m[:, 0, 1]}.items():
        sums[:, i, j] = sums[:, j, i] = value
    rows = sums[np.arange(len(m)), largest]
    return np.ascontiguousarray(rows / np.linalg.norm(rows, axis=1, keepdims=True))
