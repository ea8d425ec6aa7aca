# SPDX-License-Identifier: Apache-2.0
"""Bad files, places and options have one line each, and an old file stays as it is."""
import contextlib
import os
import pathlib
import subprocess
import tempfile

import numpy as np
import orispline as ori
import pytest

NOBODY = 65534
Q = "t,qw,qx,qy,qz\n"
KEYS = ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]])
CURVE = KEYS.curve("slerp")
FILES = [
    ("empty", b"", "empty", None, None),
    ("a header alone", Q.encode(), "no keys", None, None),
    ("NUL bytes", b"t,qw,qx,qy,qz\n0,1,0,0,0\n1,1,0,\0,0\n", "found a NUL byte, wanted a text file", 3, None),
    ("NUL bytes alone", bytes(64), "found", None, None),
    ("a cell that is no number", f"{Q}0,1,0,0,0\n1,one,0,0,0\n".encode(), "found 'one', wanted a number", 3, 2),
    ("a row too short", f"{Q}0,1,0,0,0\n1,1,0\n".encode(), "found 3", 3, None),
    ("equal times", f"{Q}0,1,0,0,0\n0,1,0,0,0\n".encode(), "(drop_duplicates=True keeps the first)", 3, None),
    ("falling times", f"{Q}1,1,0,0,0\n0,1,0,0,0\n".encode(), "(sort=True orders the rows)", 3, None),
    ("NaN", f"{Q}0,1,0,0,0\n1,nan,0,0,0\n".encode(), "(drop_invalid=True drops such rows)", 3, 2),
    ("norms off", f"{Q}0,1,0,0,0\n1,2,0,0,0\n".encode(), "(normalise=True takes any norm but 0)", 3, None),
    ("zero quaternion", f"{Q}0,1,0,0,0\n1,0,0,0,0\n".encode(), "the quaternion is zero, wanted a rotation", 3, None),
    ("no header", b"0,1,0,0,0\n1,1,0,0,0\n", "(order=wxyz|xyzw)", 1, None),
    ("columns of other names", b"when,a,b,c,d\n0,1,0,0,0\n", "(columns=... says which is which)", 1, None),
    ("frames without a rate", b"frame,qw,qx,qy,qz\n0,1,0,0,0\n", "(fps=N)", None, None),
    ("angles without a unit", b"t,roll,pitch,yaw\n0,0,0,90\n", "(angle_unit=deg|rad|mrad|arcsec)", 1, None),
    ("an unknown method", f"# orispline: method=squadd\n{Q}0,1,0,0,0\n".encode(),
     "(ignore_recipe=True reads the keys without it)", 1, None),
]
OPTIONS = [
    ({"order": "wzyx"}, ori.ArgumentError, "order: found 'wzyx', wanted wxyz|xyzw"),
    ({"input_format": "parquet"}, ori.ArgumentError, "input_format: found 'parquet', wanted csv|tum|euroc"),
    ({"euler": "XXZ"}, ori.ArgumentError, "euler: found 'XXZ', wanted three axes"),
    ({"angle_unit": "turns"}, ori.ArgumentError, "angle_unit: found 'turns'"),
    ({"time_scale": 0}, ori.ArgumentError, "time_scale: found '0', wanted a number greater than 0"),
    ({"time_scale": float("nan")}, ori.ArgumentError, "time_scale: found 'nan'"),
    ({"fps": -24}, ori.ArgumentError, "fps: found '-24'"),
    ({"epoch": "yesterday"}, ori.ArgumentError, "epoch: found 'yesterday', wanted a time of ISO 8601"),
    ({"epoch": 5}, ori.ArgumentError, "epoch: found '5'"),
    ({"signs": "long"}, ori.ArgumentError, "signs: found 'long', wanted shortest|as-given|as-typed"),
    ({"columns": {"t": "clock"}}, ori.DataError, "clock"),
    ({"columns": {"time": "t"}}, ori.ArgumentError, "time"),
    ({"columns": "t=clock"}, TypeError, "columns: found 't=clock', wanted names of columns"),
    ({"sort": "yes"}, TypeError, "sort: found 'yes', wanted True or False"),
    ({"order": ["w"]}, TypeError, "order: found ['w'], wanted a text or a number"),
    ({"sorted": True}, TypeError, "sorted"),
]


def one_line(error):
    assert "\n" not in str(error.value) and str(error.value)
    return str(error.value)


@pytest.mark.parametrize(("content", "text", "line", "column"), [case[1:] for case in FILES], ids=[case[0] for case in FILES])
def test_files_that_hold_no_keys(content, text, line, column, tmp_path):
    path = tmp_path / "keys.csv"
    path.write_bytes(content)
    with pytest.raises(ori.DataError) as error:
        ori.read(path)
    assert text in one_line(error) and one_line(error).startswith(str(path))
    assert error.value.file == str(path) and isinstance(error.value, ValueError)
    if line is not None:
        assert error.value.line == line
    if column is not None:
        assert error.value.column == column


@pytest.mark.parametrize(("options", "kind", "text"), OPTIONS, ids=[repr(case[0]) for case in OPTIONS])
def test_options_that_are_none(options, kind, text, tmp_path):
    (tmp_path / "keys.csv").write_text(Q + "0,1,0,0,0\n")
    with pytest.raises(kind) as error:
        ori.read(tmp_path / "keys.csv", **options)
    assert text in one_line(error)


def test_numpy_files_that_hold_no_keys(tmp_path):
    path = tmp_path / "keys.npy"
    path.write_bytes(b"t,qw,qx,qy,qz")
    faults = [(ori.DataError, "found no NumPy file that holds an array of numbers", None, {})]
    table = np.array([[0, 1, 0, 0, 0], [1, 0.8, 0, 0, 0.6]])
    faults += [(ori.DataError, "found an array of <U1 of the shape (2,)", np.array(["a", "b"]), {}),
               (ori.DataError, "found an array of float64 of the shape (5,)", table[0], {}),
               (ori.DataError, "found no NumPy file that holds an array of numbers", np.array([{}], object), {}),
               (ori.ArgumentError, "found 4 columns, wanted 5, 8 or 17, or their names", table[:, :4], {}),
               (ori.ArgumentError, "columns: found no qz, wanted t, qw, qx, qy and qz", table[:, :4], {"columns": ["t", "qw", "qx", "qy"]}),
               (ori.ArgumentError, "columns: found 2 names, wanted 5 that differ", table, {"columns": ["t", "qw"]}),
               (ori.ArgumentError, "columns: found 't', wanted the names of the 5 columns", table, {"columns": "t"}),
               (ori.ArgumentError, "epoch: found it with a NumPy file", table, {"epoch": "2026-01-01"}),
               (ori.ArgumentError, "fps: found it with a NumPy file", table, {"fps": 24}),
               (ori.DataError, "key 1: time 0 comes after 1", table[::-1], {}), (ori.DataError, "no keys", table[:0], {})]
    for kind, text, array, options in faults:
        if array is not None:
            np.save(path, array)
        with pytest.raises(kind) as error:
            ori.read(path, **options)
        assert text in one_line(error)
        assert error.value.file == str(path) or kind is ori.ArgumentError
    with pytest.raises(ori.AccessError, match="none.npy: cannot open: No such file"):
        ori.read(tmp_path / "none.npy")


def test_places_where_no_file_can_be(tmp_path):
    for path in (tmp_path / "none.csv", tmp_path, tmp_path / "none/keys.csv"):
        with pytest.raises(ori.AccessError) as error:
            ori.read(path)
        assert str(path) in one_line(error) and isinstance(error.value, OSError) and error.value.file == str(path)
    for write in (KEYS.write, CURVE.sample(count=3).write):
        for path in (tmp_path, tmp_path / "none/motion.csv", pathlib.Path("/proc/motion.csv")):
            with pytest.raises(ori.AccessError) as error:
                write(path)
            assert str(path) in one_line(error)
        for path, text in ((b"motion.csv", "wanted a str"), (3, "int")):
            with pytest.raises(TypeError, match=text):
                write(path)
        with pytest.raises(ori.ArgumentError, match="NUL"):
            write(str(tmp_path / "mo\0tion.csv"))
        with pytest.raises(ori.ArgumentError, match="empty name"):
            write("")
    assert list(tmp_path.iterdir()) == []


@contextlib.contextmanager
def no_root():
    """Root may write everywhere: meanwhile it is nobody."""
    own = os.geteuid()
    if own == 0:
        os.seteuid(NOBODY)
    try:
        yield
    finally:
        os.seteuid(own)


def test_a_folder_that_may_not_be_written_to():
    with tempfile.TemporaryDirectory() as place:  # whose folders, unlike those of tmp_path, everybody may enter
        folder = pathlib.Path(place)
        old, samples = folder / "motion.csv", CURVE.sample(count=3)
        samples.write(folder / "new.csv")
        old.write_text("old")
        folder.chmod(0o555)
        try:
            with no_root(), pytest.raises(ori.AccessError, match=f"{old}.*ermission"):
                samples.write(old)
        finally:
            folder.chmod(0o700)
        assert old.read_text() == "old"


@pytest.fixture
def small_disk(tmp_path):
    """A disk of 64 KiB."""
    place = tmp_path / "disk"
    place.mkdir()
    mounted = subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64k", "tmpfs", place], capture_output=True, check=False)
    if mounted.returncode != 0:
        pytest.skip("a disk can be mounted by root only")
    yield place
    subprocess.run(["umount", place], check=True)


def test_on_a_full_disk_the_old_file_stays(small_disk):
    for name in ("motion.csv", "motion.npy", "motion.tum"):
        old = small_disk / name
        CURVE.sample(count=3).write(old)
        before = old.read_bytes()
        for many in (CURVE.sample(count=100_000), ori.Keys(np.arange(20_000), np.tile([0, 0, 0, 1], (20_000, 1)))):
            with pytest.raises(ori.AccessError) as error:
                many.write(old)
            assert str(old) in one_line(error)
            assert old.read_bytes() == before and [file.name for file in small_disk.iterdir()] == [name]
        old.unlink()


@pytest.mark.skipif(not os.path.exists("/dev/full"), reason="/dev/full is not here")
def test_a_device_that_is_full():
    with pytest.raises(ori.AccessError, match="/dev/full"):
        CURVE.sample(count=1000).write("/dev/full")
    with pytest.raises(ori.AccessError, match="/dev/full"):
        KEYS.write("/dev/full")


def test_what_a_file_cannot_hold_leaves_the_old_one(tmp_path):
    old = tmp_path / "motion.tum"
    old.write_text("old")
    nan = ori.Curve(KEYS, method="slerp", extrapolate="nan").sample(times=[0, 2])
    for samples, options, kind, text in (
            (CURVE.sample(count=3, derivatives=1), {}, ori.ArgumentError, "1 derivatives were asked for, and TUM holds 0"),
            (CURVE.sample(count=3), {"output_orientation": "matrix"}, ori.ArgumentError, "quaternions only"),
            (CURVE.sample(count=3), {"output_format": "bag"}, ori.ArgumentError, "output_format: found 'bag'"),
            (nan, {}, ori.DataError, "not finite"),
            (CURVE.sample(times=[0, 1e-10]), {"output_format": "euroc"}, ori.DataError, "fall on the nanosecond"),
            (ori.Samples(np.array([0, np.nan]), np.eye(4)[:2]), {}, ori.DataError, "time 1: found a time that is not finite")):
        with pytest.raises(kind) as error:
            samples.write(old, **options)
        assert text in one_line(error)
        assert old.read_text() == "old" and list(tmp_path.iterdir()) == [old]


def test_names_of_other_kinds_of_files(tmp_path):
    for write in (KEYS.write, CURVE.sample(count=3).write, lambda path, **o: ori.write(CURVE, path, **o)):
        with pytest.raises(ori.ArgumentError) as error:
            write(tmp_path / "motion.parquet")
        assert "wanted a name that ends in .csv, .tum, .npy or .txt" in one_line(error)
        write(tmp_path / "motion.parquet", output_format="tum")
        assert (tmp_path / "motion.parquet").read_text().splitlines()[1] == "1 0 0 0 0 0 0.6 0.8" or \
            len((tmp_path / "motion.parquet").read_text().splitlines()) == 3
    with pytest.raises(TypeError, match="found str, wanted Keys, a Curve or Samples"):
        ori.write("keys", tmp_path / "keys.csv")


def test_a_value_in_a_file_is_blamed_with_its_place(tmp_path):
    path = tmp_path / "keys.csv"
    path.write_text("t,qw,qx,qy,qz,tension\n0,1,0,0,0,0.5\n1,0.8,0,0,0.6,-700\n2,0.6,0,0,0.8,0.5\n3,0,0,0,1,0.5\n")
    keys = ori.read(path)
    with pytest.raises(ori.DataError) as error:
        keys.curve("quintic")
    assert one_line(error).startswith(f"{path}:3: key 1: ") and (error.value.line, error.value.key) == (3, 1)
    with pytest.raises(ori.ArgumentError) as error:
        keys.curve("quintic", tension=-700)
    assert str(path) not in one_line(error) and error.value.file is None
