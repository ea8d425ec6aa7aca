# SPDX-License-Identifier: Apache-2.0
"""Keys in other axes and frames, as the command reads them."""
import pickle

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation

Q = "qw,qx,qy,qz"
TABLE = [  # world, body, quaternion w, x, y, z up to its sign, position, angular velocity
    ("NED:ENU", "FRD:FLU", [0.565685424949238, 0.593969696196700, -0.084852813742386, 0.565685424949238], [2, 1, -3], [0.1, -0.2, -0.3]),
    (None, "RDF:RUB", [0.36, -0.8, 0, 0.48], [1, 2, 3], [0.1, -0.2, -0.3]),
    ("RUB:RFU", None, [0.311126983722081, 0.820243866176395, 0.339411254969543, 0.339411254969543], [1, -3, 2], [0.1, 0.2, 0.3]),
    ("RUF:FLU", "RUF:FLU", [0.8, 0, 0.36, -0.48], [3, -1, 2], [-0.3, 0.1, -0.2])]


@pytest.fixture
def keys():
    return ori.Keys([0], [[0.8, 0.36, 0.48, 0]], positions=[[1, 2, 3]], angular_velocities=[[0.1, 0.2, 0.3]],
                    angular_accelerations=[[1, 2, 3]], angular_jerks=[[np.nan] * 3], scalar_first=True)


def assert_same(found, wanted):
    sign = np.sign(np.dot(found, wanted))
    assert np.abs(sign * np.asarray(found) - wanted).max() <= 1e-15


@pytest.mark.parametrize(("world", "body", "q", "p", "w"), TABLE)
def test_the_table(keys, tmp_path, world, body, q, p, w):
    turned = keys.in_axes(world, body)
    assert_same(turned.rotations[0], q)
    assert turned.positions.tolist() == [p] and turned.angular_velocities.tolist() == [w]
    assert (turned.angular_accelerations[0] == 10 * np.array(w)).all() and np.isnan(turned.angular_jerks).all()
    path = tmp_path / "keys.csv"
    path.write_text(f"t,{Q},px,py,pz,wx,wy,wz\n0,0.8,0.36,0.48,0,1,2,3,0.1,0.2,0.3\n")
    read = ori.read(path, world_axes=world, body_axes=body, scalar_first=True)
    assert_same(read.rotations[0], q)
    assert read.positions.tolist() == [p] and read.angular_velocities.tolist() == [w]


def test_rotations_in_every_form(keys, tmp_path):
    quarter = Rotation.from_euler("z", 90, degrees=True)
    mount = tmp_path / "mount.csv"
    mount.write_text("yaw_deg,pitch_deg,roll_deg\n90,0,0\n")
    for rotation in (quarter, quarter.as_matrix(), np.roll(quarter.as_quat(), 1), [np.roll(quarter.as_quat(), 1).tolist()], mount, str(mount),
                     "roll_deg=0,pitch_deg=0,yaw_deg=90"):
        world = keys.in_axes(world_rotation=rotation)
        assert np.allclose(world.positions, [[-2, 1, 3]], atol=1e-15) and world.angular_velocities.tolist() == [[0.1, 0.2, 0.3]]
        body = keys.in_axes(body_rotation=rotation)
        assert np.allclose(body.angular_velocities, [[-0.2, 0.1, 0.3]], atol=1e-15) and body.positions.tolist() == [[1, 2, 3]]
        both = Rotation.from_quat(np.roll(keys.in_axes(world_rotation=rotation, body_rotation=rotation).rotations[0], -1))
        wanted = quarter * Rotation.from_quat([0.36, 0.48, 0, 0.8]) * quarter.inv()
        assert (both * wanted.inv()).magnitude() < 1e-15
    path = tmp_path / "keys.csv"
    path.write_text(f"t,{Q},px,py,pz\n0,1,0,0,0,1,2,3\n")
    assert np.allclose(ori.read(path, world_rotation=quarter, world_axes="NED:ENU").positions, [[-1, 2, -3]], atol=1e-15)


def test_all_that_keys_carry_goes_along(tmp_path):
    path = tmp_path / "keys.csv"
    path.write_text(f"# orispline: method=rotation-spline:ends=clamped:start_rate=0.1,0.2,0.3:end_rate=0,0,1\nt,{Q}\n"
                    "100.25,1,0,0,0\n101.25,0.8,0.36,0.48,0\n102,0.8,0,0.6,0\n")
    keys = ori.read(path)
    turned = keys.in_axes("NED:ENU", "FRD:FLU")
    assert (turned.times == keys.times).all() and turned.epoch == keys.epoch
    assert turned.curve().angular_velocity(0.0).tolist() == pytest.approx([0.1, -0.2, -0.3], abs=1e-13)
    turned.write(tmp_path / "turned.csv")
    again = ori.read(tmp_path / "turned.csv")
    assert (again.rotations == turned.rotations).all()
    assert pickle.loads(pickle.dumps(turned)) == turned
    back = turned.in_axes("ENU:NED", "FLU:FRD")
    assert np.abs(back.rotations - keys.rotations).max() < 1e-15 or np.abs(back.rotations + keys.rotations).max() < 1e-15
    assert back.curve().method == keys.curve().method


def test_world_to_camera_poses(tmp_path):
    path = tmp_path / "colmap.csv"
    path.write_text(f"t,{Q},tx,ty,tz\n0.0,0.7071067811865476,0.7071067811865475,-0.0,-0.0,-3.0,1.0,-2.220446049250313e-16\n")
    assert np.abs(ori.read(path, inverse_poses=True).positions - [[3, 0, 1]]).max() <= 1e-15
    assert ori.read(path, conjugate=True).positions[0, 0] == -3
    with pytest.raises(ori.ArgumentError, match="inverse_poses: found `conjugate` as well"):
        ori.read(path, conjugate=True, inverse_poses=True)


@pytest.mark.parametrize(("arguments", "message"), [
    ({"world": "NEX:ENU"}, "world: found 'NEX', wanted N or S, E or W, U or D with a compass"),
    ({"body": "NED:FLU"}, "body: found 'NED', wanted R or L, F or B, U or D for the axes of a body"),
    ({"world": "NED:NEU"}, r'world: found axes of the world .* \(body="FROM:TO" changes it there too\)'),
    ({"world_rotation": [0, 0, 0, 2.0]}, "world_rotation: the quaternion has norm 2, wanted 1"),
    ({"body_rotation": [[0, 0, 0, 1.0], [0, 0, 0, 1.0]]}, "body_rotation: found 2 rotations, wanted one"),
    ({"body_rotation": "qw=1"}, "body_rotation: found 'qw', wanted qw, qx, qy, qz")])
def test_bad_input(arguments, message):
    keys = ori.Keys([0], [[0, 0, 0, 1.0]])
    with pytest.raises(ori.ArgumentError, match=message):
        keys.in_axes(**arguments)
