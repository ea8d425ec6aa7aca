# SPDX-License-Identifier: Apache-2.0
"""The forms in which people have keys, and in which they take orientations back."""
import pickle

import numpy as np
import orispline as ori
import pytest
import scipy.spatial.transform as scipy
from scipy.spatial.transform import Rotation

T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
KEYS = ori.Keys(T, Q)
RATES = np.array([[0, 0, 5.0], [0, 1, 0], [1, 0, 0]])
BESIDE = {"rotations": Q, "positions": np.eye(3), "angular_velocities": RATES, "angular_accelerations": RATES, "angular_jerks": RATES,
          "inner_leaving": Q, "inner_arriving": Q, "signs": "shortest", "scalar_first": False, "normalize": True, "normalise": False, "euler": "ZYX", "angle_unit": "deg",
          "drop_invalid": False, "drop_duplicates": True, "sort": False, "time_unit": "s"}


@pytest.mark.parametrize("name", BESIDE)
def test_no_argument_beside_keys_is_dropped(name):
    for make in (ori.Curve, KEYS.curve if name != "rotations" else lambda **options: ori.Curve(KEYS, **options)):
        given = {"times": KEYS} if make is ori.Curve else {}
        with pytest.raises(TypeError, match=f"^{name}: found {name} beside Keys, wanted them with the Keys: Keys\\(times, rotations, …\\)$"):
            make(**given, method="hermite-c1", **{name: BESIDE[name]})


def test_several_arguments_beside_keys_are_named_and_a_method_is_told_apart():
    with pytest.raises(TypeError, match="found positions, signs beside Keys"):
        KEYS.curve(positions=np.eye(3), signs="shortest")
    with pytest.raises(TypeError, match="found 'slerp' beside Keys, wanted method='slerp'"):
        ori.Curve(KEYS, "slerp")


def test_rates_of_stacks_are_those_of_their_joints():
    rotations, rates = np.stack([Q, Q[::-1]], axis=1), np.stack([RATES, -RATES], axis=1)
    stack = ori.CurveStack(T, rotations, "hermite-c1", angular_velocities=rates)
    for joint in range(2):
        assert np.allclose(stack[joint].angular_velocity(T), rates[:, joint], atol=1e-9)
    with pytest.raises(ori.ArgumentError, match=r"angular_jerks: found the shape \(3, 3\), wanted \(3, 2, 3\)"):
        ori.CurveStack(T, rotations, "hermite-c3", angular_jerks=RATES)
    for name in ("settings", "drop_invalid", "drop_duplicates", "sort"):
        with pytest.raises(ori.ArgumentError, match=f"^{name}: found it with a CurveStack, wanted it with a Curve of each joint"):
            ori.CurveStack(T, rotations, **{name: None})


@pytest.mark.parametrize("word", ["normalize", "normalise"])
def test_both_spellings_are_taken_everywhere(word, tmp_path):
    far = {"rotations": np.multiply(Q, 4.0), word: True}
    assert ori.Keys(T, **far) == KEYS and ori.Curve(T, **far).keys == KEYS
    assert ori.Keys(T, **far).repairs == {"normalised": 3, "largest_norm_error": 3.0} and KEYS.repairs == {}
    assert np.array_equal(ori.CurveStack(T, np.multiply(Q, 4.0)[:, None], **{word: True}).rotations[:, 0], KEYS.rotations)
    (tmp_path / "keys.csv").write_text("t,qw,qx,qy,qz\n0,4,0,0,0\n1,3.2,0,0,2.4\n3,0,0,0,4\n")
    assert ori.read(tmp_path / "keys.csv", **{word: True}) == KEYS
    with pytest.raises(TypeError, match=f"{word}: found 'yes' of type str, wanted True or False"):
        ori.Keys(T, Q, **{word: "yes"})


def test_arrays_are_mended_as_files_are(tmp_path):
    rows = [[3, 0, 0, 0, 1], [1, 0.8, 0, 0, 0.6], [1, 1, 0, 0, 0], [np.nan, 1, 0, 0, 0], [0, 1, 0, 0, 0], [2, 1, np.inf, 0, 0]]
    table = np.array(rows)
    (tmp_path / "keys.csv").write_text("t,qw,qx,qy,qz\n" + "".join(",".join(map(str, row)) + "\n" for row in rows))
    how = {"drop_invalid": True, "drop_duplicates": True, "sort": True}
    of_file, of_array = ori.read(tmp_path / "keys.csv", **how), ori.Keys(table[:, 0], table[:, 1:], scalar_first=True, **how)
    assert np.array_equal(of_array.rotations[:, [1, 2, 3, 0]], of_file.rotations) and np.array_equal(of_array.times, [0, 1, 3])
    for name in ("invalid_dropped", "rows_moved", "duplicates_dropped"):
        assert of_array.repairs[name] == of_file.repairs[name]
    stamps = np.array(["2026-01-02", "NaT", "2026-01-01"], "datetime64[D]")
    keys = ori.Keys(stamps, Q, positions=np.eye(3), angular_velocities=[[1, 0, 0], [0, 1, 0], [np.nan] * 3], settings={"tension": [1, 2, 3]},
                    sort=True, drop_invalid=True)
    assert np.array_equal(keys.positions, np.eye(3)[[2, 0]]) and keys.settings == {"tension": [3, 1]}
    assert np.isnan(keys.angular_velocities[0]).all() and keys.repairs["rows_moved"] == 1
    assert pickle.loads(pickle.dumps(keys, 5)) == keys
    half = [[1, 0, 0], [0, np.nan, 1], [0, 0, 1]]
    assert len(ori.Keys(T, Q, angular_velocities=half, drop_invalid=True)) == 2
    with pytest.raises(ori.DataError, match="no keys"):
        ori.Keys([np.nan], Q[:1], drop_invalid=True)
    with pytest.raises(ori.ArgumentError, match="found 2 values, wanted one per key, 3"):
        ori.Keys(T, Q, settings={"tension": [1, 2]}, sort=True)


def test_poses_have_positions():
    rotations, positions = Rotation.from_quat(Q), np.array([[1, 2, 3], [4, 5, 6], [7, 8, 10.0]])
    wanted = ori.Keys(T, rotations, positions=positions)
    matrices = np.tile(np.eye(4), (3, 1, 1))
    matrices[:, :3, :3], matrices[:, :3, 3] = rotations.as_matrix(), positions
    forms = [matrices]
    if hasattr(scipy, "RigidTransform"):  # SciPy 1.16
        forms.append(scipy.RigidTransform.from_components(positions, rotations))
    for form in forms:
        keys = ori.Keys(T, form)
        assert np.allclose(keys.rotations, wanted.rotations, atol=1e-15) and np.array_equal(keys.positions, positions)
        assert np.allclose(ori.Curve(T, form).position(1.0), positions[1])
        with pytest.raises(ori.ArgumentError, match="positions: found them beside poses"):
            ori.Keys(T, form, positions=positions)
        with pytest.raises(ori.ArgumentError, match="rotations: found poses, wanted orientations without positions"):
            wanted.curve().distance(T, form)
    matrices[1, 3, 0] = 0.5
    with pytest.raises(ori.DataError, match=r"found the last row \[0.5, 0.0, 0.0, 1.0\] of a pose, wanted 0, 0, 0, 1") as found:
        ori.Keys(T, matrices)
    assert found.value.key == 1


def test_lists_of_rotations_are_rotations():
    single, pair = [Rotation.from_quat(q) for q in Q], [Rotation.from_quat(Q[:2]), Rotation.from_quat(Q[2:])]
    for rotations in (single, tuple(single), pair):
        assert ori.Keys(T, rotations) == ori.Keys(T, rotations, scalar_first=False) == KEYS
    assert np.array_equal(ori.Keys(T, single, scalar_first=True).rotations, KEYS.rotations[:, [3, 0, 1, 2]])


@pytest.mark.parametrize("order", ["ZYX", "zyx", "XYZ", "XZX", "zxz", "YXZ"])
def test_euler_angles_are_scipys(order):
    angles = np.random.default_rng(5).uniform(-3, 3, (7, 3))
    rotations = Rotation.from_euler(order, angles)
    keys = ori.Keys(range(7), angles, euler=order)
    assert (Rotation.from_quat(keys.rotations) * rotations.inv()).magnitude().max() < 1e-15 * 8
    assert np.allclose(ori.Keys(range(7), np.degrees(angles), euler=order, angle_unit="deg").rotations, keys.rotations, atol=1e-15)
    curve = keys.curve()
    back = Rotation.from_euler(order, curve.as_euler(keys.times, order, degrees=True), degrees=True)
    assert (back * rotations.inv()).magnitude().max() < 1e-7
    stack = ori.CurveStack(range(7), np.stack([angles, angles[::-1]], axis=1), euler=order)
    assert np.array_equal(stack[0].keys.rotations, keys.rotations)


@pytest.mark.parametrize(("options", "text"), [
    ({"euler": "XXZ"}, "euler: found 'XXZ', wanted three letters"), ({"euler": "XyZ"}, "euler: found 'XyZ'"), ({"euler": "XY"}, "euler: found 'XY'"),
    ({"euler": "ZYX", "angle_unit": "turns"}, "angle_unit: found 'turns'"), ({"angle_unit": "deg"}, "angle_unit: found it without euler")])
def test_other_orders_are_refused(options, text):
    with pytest.raises(ori.ArgumentError, match=text):
        ori.Keys(T, np.zeros((3, 3)), **options)
    with pytest.raises(ori.ArgumentError, match="rotations: found the shape \\(3, 4\\), wanted \\(n, 3\\) angles, as euler= says"):
        ori.Keys(T, Q, euler="ZYX")


def test_orientations_come_in_the_forms_of_scipy():
    curve = ori.Curve(T, Q, "squad-timed", scalar_first=False)
    t = np.linspace(-1, 4, 12)
    wanted = curve.rotation(t)
    for thing in (curve, curve.bake(1e-12), ori.Curve(T, np.roll(Q, 1, axis=1), "squad-timed", scalar_first=True)):
        assert np.allclose(thing.as_matrix(t), wanted.as_matrix(), atol=1e-11) and thing.as_matrix(t[0]).shape == (3, 3)
        assert np.allclose(thing.as_matrix(t.reshape(3, 4)).reshape(12, 3, 3), wanted.as_matrix(), atol=1e-11)
        assert np.allclose(np.abs(thing.as_rotvec(t)), np.abs(wanted.as_rotvec()), atol=1e-10) and thing.as_rotvec(1.0).shape == (3,)
        assert np.allclose(thing.as_rotvec(1.0, degrees=True), [0, 0, np.degrees(2 * np.arccos(0.8))])
        assert thing.as_euler([[0.5]], "zyx").shape == (1, 1, 3)
        assert np.isnan(thing.as_matrix(np.nan)).all() and np.isnan(thing.rotation([0.5, np.nan])[1].as_quat()).all()
    with pytest.raises(ori.ArgumentError, match="order: found 'QQQ', wanted three letters"):
        curve.as_euler(1.0, "QQQ")


def test_derivatives_are_functions():
    curve = ori.Curve(T, Q)
    for order, name in ((1, "angular_velocity"), (2, "angular_acceleration"), (3, "angular_jerk")):
        for frame in ("body", "world"):
            assert np.array_equal(curve.derivative(order)(T, frame=frame), getattr(curve, name)(T, frame=frame))
    assert np.array_equal(curve.derivative()(0.5), curve.angular_velocity(0.5))
    for wrong in (0, 4):
        with pytest.raises(ori.ArgumentError, match=f"order: found {wrong}, wanted a whole number from 1 to 3"):
            curve.derivative(wrong)


def test_keys_are_taken_by_masks_and_indices_and_one_by_one():
    keys = ori.Keys(T, Q, positions=np.eye(3))
    for some in (keys[[True, False, True]], keys[keys.times != 1], keys[[0, 2]], keys[np.array([0, -1])], keys[::2]):
        assert some == keys[::2] and np.array_equal(some.positions, np.eye(3)[::2])
    pairs = list(keys)
    assert [time for time, _ in pairs] == T and np.array_equal([q for _, q in pairs], Q)
    online = ori.OnlineCurve("slerp")
    for time, q in keys:
        online.append(time, q)
    assert len(online) == 3
    for wrong, text in (([True, False], "found a mask of 2, wanted one of 3"), ([2, 0], "found indices that do not rise within the 3 keys"),
                        ([0, 3], "found indices that do not rise"), ([0, 0], "found indices that do not rise")):
        with pytest.raises(ori.ArgumentError, match=f"keys: {text}"):
            keys[wrong]
    for none in ([], (), np.array([])):
        with pytest.raises(ori.DataError, match="empty: no keys"):
            keys[none]
    for wrong in ([0.5], [[0, 1]], ["a"]):
        with pytest.raises(TypeError, match=r"keys: found .* wanted a place such as keys\[3\], a slice"):
            keys[wrong]


def test_keys_and_motions_are_equal_where_their_numbers_are():
    full = {"positions": np.eye(3), "angular_velocities": [[np.nan] * 3, [0, 1, 0], [1, 0, 0]], "settings": {"tension": [1, 2, 3]}}
    keys = ori.Keys(T, Q, **full)
    assert keys == ori.Keys(T, Q, **full) and hash(keys) == hash(ori.Keys(T, Q, **full)) and len({keys, ori.Keys(T, Q, **full), KEYS}) == 2
    assert keys != KEYS and keys != "keys" and KEYS != ori.Keys(np.array(T) + 1e-15, Q) and KEYS != KEYS[:2]
    assert KEYS != ori.Keys(T, np.roll(Q, 1, axis=1), scalar_first=True) and KEYS != ori.Keys(T, Q, signs="as-given")
    assert KEYS != ori.Keys([0, 1, 3], Q, time_unit="ms")
    curve = keys.curve("auto")
    assert curve.motion(0.5) == curve.motion(0.5) != curve.motion(0.6) and hash(curve.motion(0.5)) == hash(curve.motion(0.5))
    assert KEYS.curve().motion(0.5) != curve.motion(0.5) and curve.motion(0.5) != 3  # without positions


@pytest.mark.parametrize("scalar_first", [False, True])
def test_keys_go_through_pandas_and_come_back(scalar_first):
    pandas = pytest.importorskip("pandas")
    rotations = np.roll(Q, 1, axis=1) if scalar_first else Q
    stamps = np.array(["2026-01-01T00:00:00.000000007", "2026-01-02", "2026-01-04"], "datetime64[ns]")
    for times in (T, stamps):
        for more in ({}, {"positions": np.eye(3)}, {"positions": np.eye(3), "angular_velocities": RATES, "settings": {"tension": [1, 2, 3]}}):
            keys = ori.Keys(times, rotations, scalar_first=scalar_first, **more)
            frame = keys.to_pandas()
            assert ori.Keys.from_pandas(frame, scalar_first=scalar_first) == keys
            assert ori.Keys.from_pandas(frame.set_index("t"), scalar_first=scalar_first) == keys
            assert frame.attrs["epoch"] == f"{keys.epoch:f}" and list(frame.columns) == keys.to_arrow().column_names
    names = {"t": "stamp", "qw": "w"}
    renamed = KEYS.to_pandas().rename(columns=names).assign(temperature=20.0)
    assert ori.Keys.from_pandas(renamed.convert_dtypes(), columns=names) == KEYS
    for columns, text in (({"t": "time"}, "columns: found no 'time', wanted one of 'stamp'"), (None, "columns: found no t, qw, wanted t, qw"),):
        with pytest.raises(ori.ArgumentError, match=text):
            ori.Keys.from_pandas(renamed, columns=columns)
    with pytest.raises(ori.ArgumentError, match="columns: found px alone, wanted px, py, pz"):
        ori.Keys.from_pandas(KEYS.to_pandas().assign(px=1.0))
    with pytest.raises(TypeError, match="frame: found .* wanted a pandas DataFrame"):
        ori.Keys.from_pandas([1, 2])
    assert isinstance(pandas.DataFrame(), type(frame))
