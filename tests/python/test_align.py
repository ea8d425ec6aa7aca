# SPDX-License-Identifier: Apache-2.0
"""Recordings brought onto others: what is found beside the command, evo and the truth, and on which clocks."""
import copy
import os
import pathlib
import pickle

import numpy as np
import orispline as ori
import pytest
from conftest import DATA
from evo.core.trajectory import PoseTrajectory3D
from scipy.spatial.transform import Rotation
from task_files import json_of, run

SHARED = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", DATA.parents[2] / "shared/data"))
DESK = SHARED / "trajectory/tum_fr2_desk_groundtruth.txt"
WORLD, BODY = Rotation.from_rotvec([0.4, -1.1, 2.0]), Rotation.from_rotvec([1.0, 0.3, -0.5])
SCALE, SHIFT, LATE = 0.7, np.array([3.0, -2.0, 0.5]), 0.37
START = np.datetime64("2026-03-01T10:00:00", "ns")
T = np.arange(400) / 40


def true_motion(t):
    """Of a body that turns about changing axes and goes round a room: Rotation and positions."""
    first = np.column_stack([0.9 * np.sin(1.1 * t), 0.7 * np.sin(1.7 * t + 0.4), 1.2 * np.sin(0.6 * t)])
    second = np.column_stack([0.5 * np.cos(2.3 * t), np.zeros_like(t), 0.3 * np.sin(3.1 * t)])
    return (Rotation.from_rotvec(first) * Rotation.from_rotvec(second),
            np.column_stack([2 * np.sin(0.7 * t), 1.5 * np.cos(0.9 * t) + 0.3 * t, 0.5 * np.sin(1.9 * t)]))


def moved(rotations, positions):
    """As another system has them, which the alignment takes back."""
    return WORLD.inv() * rotations * BODY, WORLD.inv().apply(positions - SHIFT) / SCALE


def pair(times=lambda seconds: seconds, times_of_other=None, *, positions=True, **options):
    """The moved recording and the fixed one, with times of their own."""
    q, p = true_motion(T)
    there, where = moved(q, p)
    place = (lambda p: {"positions": p}) if positions else lambda p: {}
    return (ori.Keys(times(T + LATE), there, **place(where), **options), ori.Keys((times_of_other or times)(T), q, **place(p)))


def angle(q, rotation):
    """In rad, of a quaternion x, y, z, w."""
    return (Rotation.from_quat(q) * rotation.inv()).magnitude()


def expect_true(alignment, offset=LATE):
    assert angle(alignment.world, WORLD) < 1e-5 and angle(alignment.body, BODY) < 1e-5
    assert alignment.offset == pytest.approx(offset, abs=1e-5)


def test_everything_is_found_with_standard_deviations():
    alignment = ori.align(*pair())
    expect_true(alignment)
    assert alignment.scale == pytest.approx(SCALE, rel=1e-4) and np.allclose(alignment.translation, SHIFT, atol=1e-3)
    assert alignment.world_sigma.shape == alignment.body_sigma.shape == alignment.translation_sigma.shape == (3,)
    assert 0 < alignment.offset_sigma < 1e-5 and 0 < alignment.scale_sigma < 1e-4
    assert alignment.open == () and alignment.rejected.dtype == np.intp and alignment.compared > 380
    without = ori.align(*pair(positions=False))
    expect_true(without)
    assert without.scale is without.translation is without.scale_sigma is without.position_rms is None


def test_aligned_keys_lie_beside_the_others():
    a, b = pair()
    alignment = ori.align(a, b)
    for keys in (alignment.keys, alignment.apply(a)):
        assert keys.times == pytest.approx(b.times, abs=1e-5)
        assert (Rotation.from_quat(keys.rotations).inv() * Rotation.from_quat(b.rotations)).magnitude().max() < 1e-3
        assert np.abs(keys.positions - b.positions).max() < 1e-3
    rate = np.array([0.1, 0.2, 0.3])
    other = ori.Keys([5.0, 6.0], a.rotations[:2], angular_velocities=[rate, rate])
    there = alignment.apply(other)
    assert there.times == pytest.approx([5 - LATE, 6 - LATE], abs=1e-5) and there.positions is None
    assert np.allclose(there.angular_velocities, BODY.apply([rate, rate]), atol=1e-4)


def test_what_is_not_looked_for_is_none():
    alignment = ori.align(*pair(), offset=LATE, scale=False, translation=False)
    assert (alignment.offset, alignment.offset_sigma, alignment.scale, alignment.translation.tolist()) == (LATE, 0, 1, [0, 0, 0])
    assert ori.align(*pair(), offset="0.37s").offset == LATE
    with pytest.warns(ori.ShapeWarning) as caught:
        small = ori.align(ori.Keys(T, Rotation.from_rotvec([0.1, 0, 0]) * true_motion(T)[0]), pair(positions=False)[1], world_turn=False)
    assert small.world.tolist() == [0, 0, 0, 1]
    assert caught[0].message.code == "poor_alignment" and caught[0].filename == __file__


@pytest.mark.parametrize("times", [
    lambda s: START + np.round(s * 1e9).astype("m8[ns]"), lambda s: START.astype("M8[s]") + np.round(s * 1e6).astype("m8[us]"),
    lambda s: np.round((s + 1.7e9) * 1e6).astype("m8[us]"), lambda s: s - 1e4])
def test_clocks_may_be_of_any_kind_and_keys_are_on_that_of_the_other(times):
    a, b = pair(times)
    expect_true(ori.align(a, b))
    a, b = pair(times, lambda seconds: seconds)  # the clocks begin at other times, or one of them has dates
    mixed = ori.align(a, b)
    assert mixed.keys.times.dtype == np.float64 and mixed.keys.times == pytest.approx(b.times, abs=1e-5)
    back = ori.align(b, a)
    assert back.keys.times.dtype.kind == a.times.dtype.kind and repr(back.keys)[:20] == repr(a)[:20]
    assert np.abs((back.keys.times - a.times) / (np.timedelta64(1, "s") if a.times.dtype.kind in "mM" else 1)).astype(float).max() < 1e-4
    if a.times.dtype.kind == "M":
        with pytest.raises(ori.ArgumentError, match="keys: found an array of float64, wanted datetime64"):
            mixed.apply(b)


def test_whole_nanoseconds_stay_such():
    a, _ = pair()
    q, p = true_motion(T)
    b = ori.Keys(np.round((T + 1.7e9) * 1e9).astype(np.int64), q, positions=p, time_unit="ns")
    alignment = ori.align(a, b)
    assert alignment.keys.times.dtype == np.int64 and np.abs(alignment.keys.times - b.times).max() < 20_000


def test_rotations_have_the_order_of_the_keys():
    a, b = pair()
    first = ori.align(ori.Keys(a.times, a.rotations[:, [3, 0, 1, 2]], positions=a.positions, scalar_first=True), b)
    last = ori.align(a, b)
    assert np.array_equal(first.world, last.world[[3, 0, 1, 2]]) and np.array_equal(first.body, last.body[[3, 0, 1, 2]])
    assert np.array_equal(first.keys.rotations, last.keys.rotations[:, [3, 0, 1, 2]])


def test_results_are_objects_that_do_not_change():
    a, b = pair()
    alignment = ori.align(a, b)
    for again in (pickle.loads(pickle.dumps(alignment)), copy.deepcopy(alignment)):
        assert again.as_dict() == alignment.as_dict() and np.array_equal(again.world, alignment.world)
        assert again.keys == alignment.keys and again.apply(a[5:9]) == alignment.apply(a[5:9])
    with pytest.raises(AttributeError):
        alignment.offset = 0
    assert repr(alignment).startswith("Alignment(Keys(400 keys") and "offset=0.3" in repr(alignment)
    assert str(alignment).splitlines()[0] == "400 samples onto 400 samples" and "a turn of" in str(alignment)
    page = alignment._repr_html_()
    assert "world" in page and "offset_s" in page and "method" not in page


def test_the_result_is_that_of_the_command(tmp_path):
    for name, keys in zip("ab", pair()):
        keys.write(tmp_path / f"{name}.csv")
    files = tmp_path / "a.csv", tmp_path / "b.csv"
    told = json_of("align", *files, "-o", tmp_path / "out.csv")
    alignment = ori.align(*map(ori.read, files))
    assert {name: value for name, value in told.items() if name not in ("input", "reference", "output", "warnings")} == alignment.as_dict()
    alignment.keys.write(tmp_path / "mine.csv")
    assert (tmp_path / "mine.csv").read_bytes() == (tmp_path / "out.csv").read_bytes()
    assert run("align", *files)[0].rstrip("\n") == str(alignment)
    words = f"--reference {files[1]} --methods auto,slerp --no-least-energy"
    compared = ori.compare(ori.read(files[0]), ["auto", "slerp"], reference=ori.read(files[1]), align=True, least_energy=False)
    there = json_of("compare", files[0], *words.split(), "--align")
    for mine, its in zip(compared.table(), there, strict=True):
        assert mine["method"] == its["method"] and mine["samples"] == its["samples"]
        assert mine["rms_deg"] == pytest.approx(its["rms_deg"], abs=1e-6)  # of times of which the command has the nearest doubles


def test_methods_are_compared_where_the_keys_belong():
    dated = pair(lambda s: START + np.round(s * 1e9).astype("m8[ns]"))[0]
    a, b = pair()
    for keys in (a, dated):
        comparison = ori.compare(keys, ["auto", "slerp"], reference=b, align=True, least_energy=False)
        assert comparison.table()[0]["rms_deg"] < 0.05 and "400 samples aligned" in str(comparison)
        assert comparison.keys(0).times == pytest.approx(b.times, abs=1e-4)
        assert np.array_equal(pickle.loads(pickle.dumps(comparison)).curve(0)(3.0), comparison.curve(0)(3.0))
    assert ori.compare(a, "auto", reference=b, least_energy=False).table()[0]["rms_deg"] > 20
    with pytest.raises(ori.ArgumentError, match="align: found no recording to align the keys with, wanted `reference` as well"):
        ori.compare(a, "auto", align=True)


@pytest.mark.parametrize("side", ["moved", "fixed"])
@pytest.mark.parametrize("count", [5, 40])
def test_a_run_of_bad_samples_does_no_harm(side, count):
    """Up to a tenth of them, all turned alike, as where markers are swapped."""
    dice = np.random.default_rng(count)
    swapped = Rotation.from_rotvec(np.where((np.arange(400) - 150) // count == 0, 1.0, 0.0)[:, None] * [1.0, 2.0, 0.3])
    q, p = true_motion(T)
    here, there = (rotations * Rotation.from_rotvec(dice.normal(size=(400, 3)) * np.radians(0.5)) for rotations in (q, moved(q, p)[0]))
    a, b = (there * swapped, here) if side == "moved" else (there, here * swapped)
    alignment = ori.align(ori.Keys(T + LATE, a), ori.Keys(T, b))
    assert alignment.offset == pytest.approx(LATE, abs=1e-3)
    assert angle(alignment.world, WORLD) < np.radians(0.25) and angle(alignment.body, BODY) < np.radians(0.25)
    assert len(set(alignment.rejected) & set(range(150, 150 + count))) >= count - 3


def test_turns_about_one_axis_leave_a_direction_open():
    q = Rotation.from_rotvec(np.outer(1.5 * np.sin(T), [0, 0, 1]))
    with pytest.warns(ori.ShapeWarning, match="do not tell apart: a turn of the world") as caught:
        alignment = ori.align(ori.Keys(T, q), ori.Keys(T, q))
    assert caught[0].message.code == "open_alignment"
    one, = alignment.open
    assert isinstance(one, ori.OpenDirection) and abs(one.world[2]) == pytest.approx(np.sqrt(0.5), abs=0.01)


def trajectory(t, rotations, positions):
    return PoseTrajectory3D(positions_xyz=positions, orientations_quat_wxyz=rotations.as_quat()[:, [3, 0, 1, 2]], timestamps=t)


def found_by_both(t, there, here):
    """World, scale and place of ours and of evo's, which is told the delay; and our Alignment."""
    alignment = ori.align(ori.Keys(t + LATE, there[0], positions=there[1]), ori.Keys(t, here[0], positions=here[1]))
    matrix, place, scale = trajectory(t, *there).align(trajectory(t, *here), correct_scale=True)
    return ((Rotation.from_quat(alignment.world), alignment.scale, alignment.translation), (Rotation.from_matrix(matrix), scale, place)), alignment


@pytest.mark.skipif(not DESK.is_file(), reason="the shared recordings are not here")
def test_a_recorded_trajectory_is_aligned_as_well_as_by_evo():
    """Of every 16th row of the desk, moved, turned, scaled and late: evo is given the delay, and has positions alone."""
    rows = np.loadtxt(DESK)
    rows = rows[np.append(True, np.diff(rows[:, 0]) > 0)][::16]
    t, p, q = rows[:, 0] - rows[0, 0], rows[:, 1:4], Rotation.from_quat(rows[:, 4:])
    there = moved(q, p)

    def distance(found):
        world, scale, place = found
        return np.sqrt(np.mean(np.sum((scale * world.apply(there[1]) + place - p)**2, axis=1)))

    (ours, theirs), alignment = found_by_both(t, there, (q, p))
    assert distance(theirs) < 1e-12
    assert distance(ours) < 1e-5 and angle(alignment.world, WORLD) < 1e-5 and angle(alignment.body, BODY) < 1e-4  # the file has 1e-4 m
    assert alignment.offset == pytest.approx(LATE, abs=1e-4) and alignment.scale == pytest.approx(SCALE, rel=1e-5)
    errors = []
    for seed in range(6):
        dice = np.random.default_rng(seed)

        def noisy(rotations, positions, unit):
            return (rotations * Rotation.from_rotvec(dice.normal(size=p.shape) * np.radians(0.5)),
                    positions + dice.normal(size=p.shape) * 0.01 * unit)

        both, alignment = found_by_both(t, noisy(*there, 1 / SCALE), noisy(q, p, 1.0))
        assert alignment.offset == pytest.approx(LATE, abs=5e-3)
        errors.append([(distance(found), (found[0] * WORLD.inv()).magnitude()) for found in both])
    ours, theirs = np.sqrt(np.mean(np.square(errors), axis=0))
    assert (ours <= 1.05 * theirs).all(), f"ours {ours}, evo's {theirs}"


def test_a_comparison_has_the_alignment_of_its_keys():
    a, b = pair()
    comparison = ori.compare(a, ["slerp"], reference=b, align=True)
    wanted = ori.align(a, b)
    assert comparison.alignment.as_dict() == wanted.as_dict() and comparison.alignment.keys == comparison.keys()
    assert np.array_equal(pickle.loads(pickle.dumps(comparison)).alignment.world, wanted.world)
    assert ori.compare(wanted.keys, ["slerp"], reference=b).alignment is None
    assert np.array_equal(comparison.alignment.apply(a[:9]).rotations, wanted.keys[:9].rotations)
