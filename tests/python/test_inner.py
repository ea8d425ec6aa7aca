# SPDX-License-Identifier: Apache-2.0
"""Inner quaternions of squad: in arrays, tables, files, streams and pickles."""
import pickle

import numpy as np
import orispline as ori
import pytest

T = np.array([0.0, 0.5, 1.5, 2.0, 3.0])
DICE = np.random.default_rng(39)


def unit(rows):
    return rows / np.linalg.norm(rows, axis=1, keepdims=True)


def walk():
    """Quaternions near each other, and inner ones near them."""
    q = unit(np.array([0.3, 0.1, -0.2, 0.9]) + 0.3 * DICE.normal(size=(5, 4)))
    return q, *(unit(q + 0.2 * DICE.normal(size=(5, 4))) for _ in range(2))


Q, A, B = walk()


def slerp(p, q, u):
    angle = np.arccos(p @ q)
    return (np.sin((1 - u) * angle) * p + np.sin(u * angle) * q) / np.sin(angle)


def test_squad_is_three_slerps_of_the_given_points():
    curve = ori.Curve(T, Q, "squad", inner_leaving=A, inner_arriving=B)
    for n in range(4):
        for u in (0.2, 0.5, 0.9):
            wanted = slerp(slerp(Q[n], Q[n + 1], u), slerp(A[n], B[n + 1], u), 2 * u * (1 - u))
            assert np.allclose(curve(T[n] + u * (T[n + 1] - T[n])), wanted, atol=1e-13, rtol=0)
    assert curve.continuity() == 0 and ori.Curve([0, 1, 2, 3, 4], Q, "squad").continuity() == 1


def test_rows_of_nan_are_chosen_and_negated_ones_are_the_same():
    free = np.full((5, 4), np.nan)
    t = np.linspace(0, 3, 31)
    assert np.array_equal(ori.Curve(T, Q, "squad", inner_leaving=free, inner_arriving=free)(t), ori.Curve(T, Q, "squad")(t))
    keys = ori.Keys(T, Q, inner_leaving=A, inner_arriving=B)
    assert keys == ori.Keys(T, Q, inner_leaving=-A, inner_arriving=B) != ori.Keys(T, Q, inner_arriving=B)
    assert np.allclose(keys.inner_leaving, A, atol=1e-15) and ori.Keys(T, Q).inner_leaving is None


def test_they_have_the_order_and_the_norms_of_the_orientations():
    wxyz = [rows[:, [3, 0, 1, 2]] for rows in (Q, A, B)]
    keys = ori.Keys(T, wxyz[0], inner_leaving=wxyz[1], inner_arriving=wxyz[2], scalar_first=True)
    assert np.allclose(keys.inner_arriving, wxyz[2], atol=1e-15)
    t = np.linspace(0, 3, 31)
    plain = ori.Curve(T, Q, "squad", inner_leaving=A, inner_arriving=B)(t)
    assert np.array_equal(keys.curve("squad")(t)[:, [1, 2, 3, 0]], plain)
    far = A.copy()
    far[2] = np.nan
    keys = ori.Keys(T, Q, inner_leaving=5.0 * far, normalize=True)
    assert np.allclose(keys.inner_leaving, far, atol=1e-15, equal_nan=True)
    assert keys.repairs == {"normalised": 4, "largest_norm_error": pytest.approx(4.0)}


def test_they_go_with_their_keys():
    keys = ori.Keys(T, Q, inner_leaving=A, inner_arriving=B)
    assert np.array_equal(keys[1:3].inner_arriving, keys.inner_arriving[1:3])
    assert np.array_equal(keys[[0, 3]].inner_leaving, keys.inner_leaving[[0, 3]])
    backwards = ori.Keys(T[::-1], Q[::-1], inner_leaving=A[::-1], inner_arriving=B[::-1], sort=True)
    assert backwards == keys and pickle.loads(pickle.dumps(keys)) == keys
    stack = ori.CurveStack(T, np.stack([Q, A], 1), "squad", inner_leaving=np.stack([A, B], 1))
    assert np.array_equal(stack[0].keys.inner_leaving, keys.inner_leaving) and stack[1].keys.inner_arriving is None


def test_tables_have_them():
    pandas = pytest.importorskip("pandas")
    keys = ori.Keys(T, Q, inner_leaving=A, inner_arriving=B)
    frame = keys.to_pandas()
    assert list(frame.columns) == ["t", "qw", "qx", "qy", "qz", "a_qw", "a_qx", "a_qy", "a_qz", "b_qw", "b_qx", "b_qy", "b_qz"]
    assert ori.Keys.from_pandas(frame) == keys and ori.Keys.from_pandas(frame, scalar_first=True).curve("squad")
    with pytest.raises(ori.ArgumentError, match="columns: found a_qw, a_qx, a_qz alone, wanted a_qw, a_qx, a_qy, a_qz"):
        ori.Keys.from_pandas(pandas.DataFrame(frame).drop(columns="a_qy"))


def test_files_have_them(tmp_path):
    free = B.copy()
    free[3] = np.nan
    keys = ori.Keys(T, Q, inner_leaving=A, inner_arriving=free)
    keys.write(tmp_path / "keys.csv")
    again = ori.read(tmp_path / "keys.csv")
    assert again == keys
    ori.write(keys.curve("squad"), tmp_path / "squad.csv")
    t = np.linspace(0, 3, 31)
    assert np.array_equal(ori.read(tmp_path / "squad.csv").curve()(t), keys.curve("squad")(t))
    with pytest.warns(ori.ShapeWarning, match="a TUM file has no columns for inner quaternions, which are left out"):
        keys.write(tmp_path / "keys.tum")


def test_streams_take_them():
    curve = ori.Curve(T, Q, "squad", inner_leaving=A, inner_arriving=B)
    online = ori.OnlineCurve("squad", capacity=8)
    for row in zip(T, Q, A, B):
        online.append(*row[:2], inner_leaving=row[2], inner_arriving=row[3])
    online.finish()
    t = np.linspace(0, 3, 31)
    assert np.array_equal(np.array([online(x) for x in t]), curve(t))
    with pytest.raises(ori.DataError, match="found no leaving inner quaternion"):
        fresh = ori.OnlineCurve("squad", capacity=8)
        fresh.append(0.0, Q[0], inner_leaving=A[0])
        fresh.append(1.0, Q[1])


def test_what_is_wrong_is_named():
    with pytest.raises(ori.ArgumentError, match=r"inner_leaving: found the shape \(5, 3\), wanted \(n, 4\)"):
        ori.Keys(T, Q, inner_leaving=A[:, :3])
    with pytest.raises(ori.DataError, match="inner_arriving: found 4, wanted one for each of the 5 times"):
        ori.Keys(T, Q, inner_arriving=B[:4])
    with pytest.raises(ori.DataError, match="key 2: the leaving inner quaternion has norm 2, wanted 1 within 0.001") as refused:
        ori.Keys(T, Q, inner_leaving=np.where(np.arange(5)[:, None] == 2, 2.0 * A, A))
    assert refused.value.key == 2
    with pytest.raises(ori.DataError, match="key 0: the arriving inner quaternion lacks 1 of its 4 components"):
        broken = B.copy()
        broken[0, 1] = np.nan
        ori.Keys(T, Q, inner_arriving=broken)
