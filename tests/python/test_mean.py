# SPDX-License-Identifier: Apache-2.0
"""The mean and the median of orientations: of arrays, of keys and of tables."""
import math
import pickle
import warnings

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation
from task_files import json_of, keys_in

DEGREE = math.pi / 180
BASE = Rotation.from_quat([0.3, -0.5, 0.7, 0.4])


def about(base, *degrees, axis=(0, 0, 1)):
    return base * Rotation.from_rotvec(np.outer(np.array(degrees) * DEGREE, axis))


def distance(q, rotation):
    return (rotation.inv() * Rotation.from_quat(q)).magnitude()


SHOTS = BASE * Rotation.from_rotvec(DEGREE * np.array([[1, 0, 0], [-1, 0, 0], [0, 2, 0], [0, -2, 0], [0, 0, 1.5], [0, 0, -1.5]]))


@pytest.mark.parametrize("kind", ["mean", "median"])
def test_all_forms_of_orientations_have_the_same_mean(kind):
    q = SHOTS.as_quat() * [[1], [-1], [1], [1], [-1], [1]]
    found = ori.mean(q, kind=kind)
    assert distance(found.orientation, BASE) < 1e-15
    for form in (SHOTS, list(SHOTS), SHOTS.as_matrix(), ori.Keys(np.arange(6), q)):
        assert distance(ori.mean(form, kind=kind).orientation, BASE) < 2e-15
    first = ori.mean(q[:, [3, 0, 1, 2]], kind=kind, scalar_first=True).orientation
    assert np.array_equal(first, found.orientation[[3, 0, 1, 2]])
    angles = ori.mean([[10, 0, 0], [30, 0, 0], [50, 0, 0]], euler="ZYX", angle_unit="deg", kind=kind)
    assert distance(angles.orientation, Rotation.from_euler("Z", 30, degrees=True)) < 1e-15


def test_the_result_says_what_the_command_says(tmp_path):
    file = tmp_path / "shots.csv"
    keys = ori.Keys(np.arange(6), SHOTS, positions=np.arange(18.0).reshape(6, 3))
    keys.write(file)
    for kind in ("mean", "median"):
        told, found = json_of("mean", file, "--kind", kind), ori.mean(keys_in(file), kind=kind)
        mine = found.as_dict()
        assert mine.keys() == told.keys() - {"input", "warnings"}
        for name, value in mine.items():
            if name not in ("farthest", "farthest_position", "kind"):
                assert value == told[name], name
        assert str(found).startswith(f"6 rows\norientation {kind}\n")


def test_the_result_has_arrays_and_shows_itself():
    found = ori.mean(ori.Keys(np.arange(6), SHOTS, positions=np.eye(3)[[0, 1, 2, 0, 1, 2]]))
    assert found.covariance.shape == found.spread.shape == found.position_covariance.shape == (3, 3)
    assert np.allclose(found.sigma, np.sqrt(np.diag(found.covariance)), rtol=1e-12)
    assert np.allclose(found.spread, np.diag([2, 8, 4.5]) / 5 * DEGREE**2, atol=1e-15)
    assert np.allclose(found.position, 1 / 3) and found.position_sigma.shape == (3,)
    assert (found.kind, found.count, found.weight, found.certified, found.others_within, found.time) == ("mean", 6, 6, True, 0, None)
    assert found.residual < 1e-15 and found.farthest in (2, 3)
    assert repr(found).startswith("Mean([") and "mean of 6" in repr(found)
    assert "<table>" in found._repr_html_() and "rms_distance_rad" in found._repr_html_()
    assert pickle.loads(pickle.dumps(found)).as_dict() == found.as_dict()


def test_weights_are_as_repetitions():
    q = about(BASE, 0, 10, 40)
    found = ori.mean(q, weights=[3, 0, 1])
    assert distance(found.orientation, about(BASE, 10)[0]) < 1e-15
    assert (found.count, found.weight, found.farthest) == (2, 4, 2)
    assert distance(ori.mean(q, weights=[1, 1, 3], kind="median").orientation, q[2]) < 1e-15


def test_a_list_of_keys_is_one_set(tmp_path):
    parts = [ori.Keys([0, 1, 5], about(BASE, 0, 10, 20), positions=np.eye(3)), ori.Keys([3], about(BASE, 90), positions=[[4, 4, 4]])]
    whole = ori.mean(about(BASE, 0, 10, 20, 90), positions=[[1, 0, 0], [0, 1, 0], [0, 0, 1], [4, 4, 4]])
    found = ori.mean(parts)
    assert np.array_equal(found.orientation, whole.orientation) and np.array_equal(found.position, whole.position) and found.farthest == 3
    assert str(found).startswith("4 rows from 2 sets\n") and ori.mean(parts[:1]).count == 3
    assert distance(ori.mean(parts, weights=[0, 0, 1, 0]).orientation, about(BASE, 20)[0]) < 1e-15
    for number, keys in enumerate(parts):
        keys.write(tmp_path / f"{number}.csv")
    told = json_of("mean", tmp_path / "0.csv", tmp_path / "1.csv")
    mine = ori.mean([ori.read(tmp_path / f"{number}.csv") for number in range(2)]).as_dict()
    assert mine == {name: value for name, value in told.items() if name not in ("inputs", "warnings")}
    with pytest.raises(ori.DataError, match="found no positions, which another set has, wanted them in all or in none"):
        ori.mean([parts[0], ori.Keys([0], BASE.as_quat()[None])])
    with pytest.raises(ori.ArgumentError, match="every: found 2 sets of rows, each with a clock of its own, wanted one"):
        ori.mean(parts, every=1)


def test_one_orientation_has_no_covariance():
    found = ori.mean([[0, 0, 0, 1]])
    assert found.sigma is found.covariance is found.spread is found.position is None
    assert found.certified and found.largest_distance == 0


def test_windows_of_keys_have_a_mean_each():
    keys = ori.Keys([10, 10.4, 12.1, 12.3], about(BASE, 0, 20, 40, 50))
    first, second = ori.mean(keys, every="1s")
    assert (first.time, second.time) == (10.5, 12.5)
    assert distance(first.orientation, about(BASE, 10)[0]) < 1e-15
    assert distance(second.orientation, about(BASE, 45)[0]) < 1e-15
    assert second.farthest in (2, 3) and "Mean([" in str(first)
    stamps = np.datetime64("2024-05-01T00:00:00", "ms") + np.array([0, 400, 2100, 2300])
    dated = ori.mean(ori.Keys(stamps, about(BASE, 0, 20, 40, 50)), every=1)
    assert dated[1].time == np.datetime64("2024-05-01T00:00:02.500")


def test_half_of_the_rows_being_bad_hardly_moves_the_median():
    random = np.random.default_rng(2)
    good = BASE * Rotation.from_rotvec(random.normal(0, 0.01, (51, 3)))
    q = np.vstack([good.as_quat(), Rotation.random(49, random_state=3).as_quat()])
    with pytest.warns(ori.ShapeWarning) as told:
        median = ori.mean(q, kind="median")
    assert told[0].message.code == "mean_not_certified"
    assert distance(median.orientation, BASE) < 0.6 * DEGREE


def test_warns_where_it_may_not_be_the_only_one():
    with pytest.warns(ori.ShapeWarning, match="there may be another that is as good or better"):
        assert not ori.mean(about(BASE, 0, 119, -119)).certified
    with pytest.warns(ori.ShapeWarning, match="the middle of them is given") as told:
        two = ori.mean(about(BASE, 0, 50), kind="median")
    assert told[0].message.code == "median_of_a_range"
    assert distance(two.orientation, about(BASE, 25)[0]) < 1e-15 and two.others_within == pytest.approx(25 * DEGREE)


@pytest.mark.parametrize(("call", "error", "words"), [
    (lambda: ori.mean(about(BASE, 0, 180)), ori.DataError, "found orientations that cancel, such as two that are 180° apart"),
    (lambda: ori.mean(about(BASE, 0, 180), kind="median"), ori.DataError, "several are their median alike"),
    (lambda: ori.mean(np.empty((0, 4))), ori.DataError, "rotations: found none, wanted one at least"),
    (lambda: ori.mean(SHOTS, weights=np.zeros(6)), ori.DataError, "found the weight 0 at every orientation"),
    (lambda: ori.mean(SHOTS, weights=[1, 1, -1, 1, 1, 1]), ori.DataError, "key 2: found the weight -1, wanted 0 or a number above it"),
    (lambda: ori.mean(SHOTS, weights=[1, 1, np.nan, 1, 1, 1]), ori.DataError, "found the weight nan"),
    (lambda: ori.mean(SHOTS, weights=[1, 1]), ori.DataError, "found 2 weights of 6 orientations, wanted one of each"),
    (lambda: ori.mean(SHOTS, weights="heavy"), ori.ArgumentError, "weights: found"),
    (lambda: ori.mean(SHOTS, positions=[[1, 2, 3]]), ori.DataError, "positions: found 1, wanted one for each of the 6 rotations"),
    (lambda: ori.mean([[0, 0, 0, 2]]), ori.DataError, "norm"),
    (lambda: ori.mean(SHOTS, every="1s"), ori.ArgumentError, "every: found orientations without times, wanted Keys"),
    (lambda: ori.mean(ori.Keys([0, 1], SHOTS[:2]), every=0), ori.ArgumentError, "every: found 0"),
    (lambda: ori.mean(ori.Keys([0, 1], SHOTS[:2]), positions=np.zeros((2, 3))), ori.ArgumentError, "positions: found it beside Keys"),
    (lambda: ori.mean(SHOTS, kind="mode"), ori.ArgumentError, "kind: found 'mode', wanted mean|median|chordal"),
    (lambda: ori.mean(SHOTS, sort=True), ori.ArgumentError, "sort"),
])
def test_bad_input_is_said_in_one_line(call, error, words):
    with pytest.raises(error) as told:
        call()
    assert words in str(told.value) and "\n" not in str(told.value)


def test_norms_are_made_1_where_that_is_wanted():
    assert np.array_equal(ori.mean([[0, 0, 0, 2]], normalize=True).orientation, [0, 0, 0, 1])


pa = pytest.importorskip("pyarrow")


def table_of(groups, times=None):
    rows = [(name, *q) for name, rotations in groups.items() for q in rotations.as_quat()]
    columns = dict(zip(["camera", "qx", "qy", "qz", "qw"], map(list, zip(*rows))))
    return pa.table(columns if times is None else {**columns, "t": times})


def test_tables_have_a_mean_for_each_group():
    import orispline.tables as tables
    table = table_of({"b": about(BASE, 0, 10), "a": SHOTS})
    found = tables.mean(table, by="camera").read_all()
    assert found["camera"].to_pylist() == ["a", "b"] and "t" not in found.column_names
    assert found["count"].to_pylist() == [6, 2] and found["certified"].to_pylist() == [True, True]
    q = np.column_stack([found[name] for name in ("qx", "qy", "qz", "qw")])
    assert distance(q[0], BASE) < 1e-15 and distance(q[1], about(BASE, 5)[0]) < 1e-15
    one = ori.mean(SHOTS)
    assert found["sigma_y_rad"][0].as_py() == pytest.approx(one.sigma[1], rel=1e-9)
    assert found["rms_distance_rad"][0].as_py() == pytest.approx(one.rms_distance, rel=1e-12)


def test_tables_have_windows_weights_and_positions():
    import orispline.tables as tables
    table = table_of({"a": about(BASE, 0, 20, 40, 50), "b": about(BASE, 7)}, [10, 10.4, 12.1, 12.3, 3.0])
    table = table.append_column("w", pa.array([3, 1, 1, 0, 2.0])).append_column("x", pa.array([0.0, 4, 1, 1, 1]))
    table = table.append_column("y", table["x"]).append_column("z", table["x"])
    found = tables.mean(table, by="camera", every="1s", weight="w", position=["x", "y", "z"]).read_all()
    assert found.column_names[:9] == ["camera", "t", "qx", "qy", "qz", "qw", "x", "y", "z"]
    assert list(zip(found["camera"].to_pylist(), found["t"].to_pylist())) == [("a", 10.5), ("a", 12.5), ("b", 3.5)]
    assert found["x"].to_pylist() == [1, 1, 1] and found["weight_sum"].to_pylist() == [4, 1, 2] and found["count"].to_pylist() == [2, 1, 1]
    q = np.column_stack([found[name] for name in ("qx", "qy", "qz", "qw")])
    for row, degrees in zip(q, (5, 40, 7)):
        assert distance(row, about(BASE, degrees)[0]) < 1e-15
    assert found["sigma_x_rad"].to_pylist()[1:] == [None, None]


def test_a_bad_group_of_a_table_says_so():
    import orispline.tables as tables
    table = table_of({"a": about(BASE, 0, 180), "b": SHOTS})
    found = tables.mean(table, by="camera").read_all()
    assert "found orientations that cancel" in found["error"][0].as_py() and found["error"][1].as_py() is None
    assert found["qw"][0].as_py() is None
    assert tables.mean(table, by="camera", errors="drop").read_all().num_rows == 1
    with pytest.raises(ori.DataError, match="camera 'a'"):
        tables.mean(table, by="camera", errors="raise").read_all()
    for options, words in (({"kind": "mode"}, "kind: found 'mode'"), ({"weight": "qx"}, "named twice"), ({"weight": "v"}, "wanted 'v' once"),
                           ({"every": "1s"}, "wanted 't' once"), ({"every": "x", "time": "qx"}, "'qx' named twice")):
        with pytest.raises(ori.ArgumentError, match=words):
            tables.mean(table, by="camera", **options)
    with pytest.raises(ori.ArgumentError, match="every: found 'x'"):
        tables.mean(table.append_column("t", pa.array(np.arange(8.0))), by="camera", every="x")


def test_rows_of_a_table_may_be_in_order_already():
    import orispline.tables as tables
    table = table_of({"a": SHOTS, "b": about(BASE, 3)})
    assert tables.mean(table, by="camera", assume_sorted=True).read_all()["count"].to_pylist() == [6, 1]
    assert tables.mean(table.to_reader(), by="camera").read_all()["count"].to_pylist() == [6, 1]


def test_the_chordal_mean_is_scipys():
    dice = np.random.default_rng(5)
    for scale in (0.05, 0.5, 1.5):
        rotations = BASE * Rotation.from_rotvec(dice.normal(0, scale, (200, 3)))
        weights = dice.uniform(0.5, 2, 200)
        found = ori.mean(rotations, kind="chordal")
        assert distance(found.orientation, rotations.mean()) < 1e-14
        assert distance(ori.mean(rotations, weights=weights, kind="chordal").orientation, rotations.mean(weights)) < 1e-14
        first = ori.mean(rotations.as_quat()[:, [3, 0, 1, 2]], kind="chordal", scalar_first=True)
        assert np.array_equal(first.orientation[[1, 2, 3, 0]], found.orientation)
        assert found.certified and found.count == 200 and found.kind == "chordal" and found.residual < 1e-14
        of_keys = ori.mean(ori.Keys(np.arange(200), rotations), kind="chordal")
        assert distance(found.orientation, Rotation.from_quat(of_keys.orientation)) < 1e-14 and found.as_dict().keys() == of_keys.as_dict().keys()
        assert found.rms_distance == pytest.approx(of_keys.rms_distance, rel=1e-12)


def test_what_else_there_is_of_a_chordal_mean_is_found_later():
    q = SHOTS.as_quat()
    found, weighted = ori.mean(q, kind="chordal"), ori.mean(q, kind="chordal", weights=[1, 2, 1, 1, 0, 1])
    assert set(vars(found)) == {"orientation", "kind", "_find"}
    orientation, q[:] = found.orientation.copy(), [0, 0, 0, 1]  # what becomes of the caller's array is no matter
    assert found.largest_distance == pytest.approx(2 * DEGREE) and np.array_equal(found.orientation, orientation)
    assert "_find" not in vars(found) and weighted.weight == 6 and weighted.count == 5
    assert "chordal of 6" in repr(found) and str(found).startswith("6 rows\norientation chordal\n")
    stopped = ori.mean(SHOTS, kind="chordal")
    find = vars(stopped)["_find"]
    vars(stopped)["_find"] = lambda: 1 / 0
    for _ in range(2):  # what failed is tried again when it is asked for again
        with pytest.raises(ZeroDivisionError):
            _ = stopped.count
    vars(stopped)["_find"] = find
    assert stopped.count == 6 and "_find" not in vars(stopped)
    again = pickle.loads(pickle.dumps(ori.mean(SHOTS, kind="chordal")))
    assert again.count == 6 and not hasattr(again, "nothing_of_the_kind")
    assert ori.mean(SHOTS, kind="chordal", positions=np.zeros((6, 3))).position.tolist() == [0, 0, 0]
    assert ori.mean(2 * SHOTS.as_quat(), kind="chordal", normalize=True).count == 6
    with pytest.raises(ori.DataError, match="found orientations that cancel"):
        ori.mean(about(BASE, 0, 180), kind="chordal")
    with pytest.raises(ori.DataError, match="found no orientations, wanted one at least"):
        ori.mean(np.empty((0, 4)), kind="chordal")
    with pytest.raises(ori.DataError, match="key 1: the quaternion has norm 2, wanted 1 within 0.001"):
        ori.mean([[0, 0, 0, 1], [0, 0, 0, 2]], kind="chordal")


def test_a_wide_mean_is_proved_the_only_one():
    dice = np.random.default_rng(6)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = ori.mean(BASE * Rotation.from_rotvec(dice.normal(0, 0.6, (1000, 3))))
    assert found.certified and found.ball_radius > math.pi / 2
