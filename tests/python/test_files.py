# SPDX-License-Identifier: Apache-2.0
"""Files of keys: what reading and writing keep."""
import decimal
import doctest
import fractions
import inspect
import io
import pickle
import subprocess
import warnings
import zipfile

import numpy as np
import orispline as ori
import pytest
from conftest import DATA
from orispline import _core
from orispline._command import COMMAND

EXAMPLES = DATA.parents[1] / "examples/data"
KEYS = sorted(EXAMPLES.glob("*_keys.csv"))
Q = "qw,qx,qy,qz"


@pytest.fixture
def file(tmp_path):
    """A file of these lines."""
    def made(*lines, name="keys.csv"):
        (tmp_path / name).write_text("".join(line + "\n" for line in lines))
        return tmp_path / name
    return made


def command(*words):
    done = subprocess.run([COMMAND, *map(str, words)], capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_options_are_those_of_the_library():
    assert list(inspect.signature(ori.read).parameters)[1:-1] and set(inspect.signature(ori.read).parameters) == {
        "path", "scalar_first", "normalize", *(option["name"] for option in _core.reading_options())}
    assert set(inspect.signature(ori.write).parameters) == {
        "what", "path", *(option["name"] for option in _core.writing_options())}
    helped = subprocess.run([COMMAND, "help", "sample", "--all"], capture_output=True, text=True, check=True).stdout
    for option in [*_core.reading_options(), *_core.writing_options()]:
        assert "--" + option["name"].replace("_", "-") in helped, option["name"]
    for function, options in ((ori.read, _core.reading_options()), (ori.write, _core.writing_options())):
        for option in options:
            words = option["argument"].split("|") if "|" in (option["argument"] or "") else []
            assert all(f'"{word}"' in function.__doc__ for word in words), option["name"]


@pytest.mark.parametrize("module", ["_files", "_keys", "_samples"])
def test_examples_of_the_docstrings(module):
    found = doctest.testmod(getattr(ori, module))
    assert found.attempted and not found.failed


def test_an_example_is_what_its_lines_say():
    keys = ori.read(EXAMPLES / "flight_keys.csv")
    rows = np.loadtxt((line for line in open(EXAMPLES / "flight_keys.csv") if line[0] not in "#t"), delimiter=",")
    assert np.allclose(keys.times + float(keys.epoch), rows[:, 0], atol=1e-15)
    assert np.allclose(keys.rotations[:, [3, 0, 1, 2]], rows[:, 1:5], atol=1e-9)
    assert np.array_equal(keys.positions, rows[:, 5:8]) and keys.angular_velocities is None
    assert keys.repairs == {"duplicates_dropped": 0, "invalid_dropped": 0, "rows_moved": 0, "normalised": 0,
                            "rates_left_free": 0, "largest_norm_error": 0.0, "rows_between": 0, "largest_matrix_distance": 0.0,
                            "largest_duplicate_turn": 0.0, "largest_duplicate_distance": 0.0}
    assert ori.Keys(rows[:, 0], rows[:, [2, 3, 4, 1]]).repairs == {}
    first = ori.read(EXAMPLES / "flight_keys.csv", scalar_first=True)
    assert np.array_equal(first.rotations, keys.rotations[:, [3, 0, 1, 2]])


def test_times_of_today_keep_their_nanoseconds(file):
    path = file(f"t,{Q}", "1700000000.123456789,1,0,0,0", "1700000000.123456790,0.8,0,0,0.6", "1700000001.5,0,0,0,1")
    keys = ori.read(path)
    assert keys.epoch == decimal.Decimal("1700000000.123456789")
    assert keys.times.tolist() == [0.0, 1e-9, 1.376543211]
    keys.write(path.with_name("again.csv"))
    assert [line.split(",")[0] for line in path.with_name("again.csv").read_text().splitlines()[1:]] == [
        "1700000000.123456789", "1700000000.12345679", "1700000001.5"]
    part = keys[1:]
    assert part.epoch == keys.epoch and part.times.tolist() == keys.times[1:].tolist()
    part.write(path.with_name("part.csv"))
    assert path.with_name("part.csv").read_text().splitlines()[1].startswith("1700000000.12345679,")


def test_options_of_reading(file):
    path = file("sclk,q0,q1,q2,q3", "2000,1,0,0,0", "1000,0.8,0,0,0.6", "1000,0,1,0,0", "3000,nan,0,0,0", "2500,3,0,0,4")
    columns = {"t": "sclk", "qw": "q0", "qx": "q1", "qy": "q2", "qz": "q3"}
    keys = ori.read(path, columns=columns, time_scale=fractions.Fraction(1, 1000), drop_duplicates=True, drop_invalid=True,
                    sort=True, normalise=True, conjugate=True)
    assert keys.epoch == 1 and keys.times.tolist() == [0, 1, 1.5]
    assert np.allclose(keys.rotations, [[0, 0, -0.6, 0.8], [0, 0, 0, 1], [0, 0, -0.8, 0.6]], atol=1e-15)
    assert keys.repairs == {"duplicates_dropped": 1, "invalid_dropped": 1, "rows_moved": 2, "normalised": 1,
                            "rates_left_free": 0, "largest_norm_error": 4.0, "rows_between": 0, "largest_matrix_distance": 0.0,
                            "largest_duplicate_turn": np.pi, "largest_duplicate_distance": 0.0}
    plain = file("0 0 0 0.6 0.8", "1 0 0 0 1", name="plain.csv")
    assert np.allclose(ori.read(plain, order="xyzw").rotations[0], [0, 0, 0.6, 0.8])
    angles = file("t,roll,pitch,yaw", "0,0,0,0", "1,0,0,90", name="angles.csv")
    half = np.sqrt(0.5)
    assert np.allclose(ori.read(angles, angle_unit="deg").rotations[1], [0, 0, half, half])
    dates = file(f"t,{Q}", "2024-02-29T12:00:00.000000001Z,1,0,0,0", "2024-02-29T12:00:01Z,0.8,0,0,0.6", name="dates.csv")
    for day in ("2024-02-29T12:00:00Z", np.datetime64("2024-02-29T12:00:00")):
        assert ori.read(dates, epoch=day).epoch == decimal.Decimal("0.000000001")
    frames = file(f"frame,{Q}", "24,1,0,0,0", "36,0.8,0,0,0.6", name="frames.csv")
    assert ori.read(frames, fps=24).times.tolist() == [0, 0.5]
    turned = file(f"t,{Q}", "0,1,0,0,0", "1,-0.8,0,0,-0.6", name="turned.csv")
    assert ori.read(turned).rotations[1, 3] == 0.8 and ori.read(turned, signs="as-given").rotations[1, 3] == -0.8


@pytest.mark.parametrize("path", KEYS, ids=lambda path: path.stem)
@pytest.mark.parametrize("name", ["keys.csv", "keys.tum", "keys.npy"])
def test_keys_are_written_as_the_command_converts_them(path, name, tmp_path):
    command("convert", path, "-o", tmp_path / name, "--quiet")
    ori.read(path, signs="as-given").write(tmp_path / f"ours-{name}")
    assert (tmp_path / f"ours-{name}").read_bytes() == (tmp_path / name).read_bytes()


@pytest.mark.parametrize(("options", "words"), [
    ({"output_format": "euroc"}, ["--output-format", "euroc"]),
    ({"output_orientation": "matrix"}, ["--output-orientation", "matrix"]),
    ({"output_euler": "XYZ", "output_angle_unit": "rad"}, ["--output-euler", "XYZ", "--output-angle-unit", "rad"]),
    ({"output_conjugate": True}, ["--output-conjugate"])])
def test_options_of_writing(options, words, tmp_path):
    path = EXAMPLES / "flight_keys.csv"
    command("convert", path, "-o", tmp_path / "keys.csv", "--quiet", *words)
    ori.write(ori.read(path, signs="as-given"), tmp_path / "ours.csv", **options)
    assert (tmp_path / "ours.csv").read_bytes() == (tmp_path / "keys.csv").read_bytes()


def test_files_name_the_method_of_their_keys(file, tmp_path):
    lines = [f"t,{Q},tension,bias", "0,1,0,0,0,0,0", "1,0.8,0,0,0.6,0.5,0", "3,0.6,0,0.8,0,0.25,0.125", "4,0,0,1,0,0,0"]
    path = file("# orispline: method=tcb:ends=natural", *lines)
    keys = ori.read(path)
    assert keys.curve().method == ori.Curve(keys).method == "tcb:bias=0,0,0.125,0:tension=0,0.5,0.25,0:ends=natural"
    assert "handle" in keys.curve(ends="handle").method and "tension=1:" in keys.curve(tension=1).method
    clamped = file("# orispline: method=timed-c2:start_rate=0,0,1", *lines, name="clamped.csv")
    assert ori.read(clamped).curve(ends=("clamped", "rest"), tension=0.4).method == (
        "timed-c2:tension=0.4:ends=clamped,rest:start_rate=0,0,1")
    assert ori.read(clamped).curve(start_rate=[0, 1, 0], closed=False, tension=0.4).method == (
        "timed-c2:tension=0.4:ends=clamped,none:start_rate=0,1,0")
    with pytest.warns(ori.ShapeWarning, match="says that its keys are for tcb:ends=natural, and they are used for auto"):
        assert keys.curve("auto").method == "auto"
    assert ori.read(path, ignore_recipe=True).curve().method == "auto"
    command("sample", path, "--rate", 10, "--quiet", "-o", tmp_path / "wanted.csv")
    keys.curve().sample(rate=10, derivatives=2).write(tmp_path / "motion.csv")
    assert (tmp_path / "motion.csv").read_bytes() == (tmp_path / "wanted.csv").read_bytes()
    keys.write(tmp_path / "again.csv")
    assert (tmp_path / "again.csv").read_text().startswith("# orispline: method=tcb:ends=natural\n")
    assert ori.read(tmp_path / "again.csv").curve().method == keys.curve().method
    for name, lost in (("npy", set()), ("tum", {"a TUM file has no columns for settings, which are left out"})):
        with pytest.warns(ori.ShapeWarning) as told:
            keys.write(tmp_path / f"keys.{name}")
        texts = [str(warning.message).removeprefix(f"{tmp_path}/keys.{name}: ") for warning in told]
        assert "so it does not say that its keys are for tcb:ends=natural" in texts[0] and set(texts[1:]) == lost
        assert all(warning.filename == __file__ for warning in told)


def test_a_curve_comes_back_from_its_file(keys, tmp_path):
    times, rotations = keys
    tension = np.linspace(0.1, 0.9, 40)
    t = np.linspace(times[0], times[-1], 200)
    for curve in (ori.Curve(times, rotations, "timed-c2", ends=("rest", "natural")),
                  ori.Curve(times, rotations, "quintic", tension=tension),
                  ori.Curve(times, -rotations[:, [3, 0, 1, 2]], "sextic", scalar_first=True, signs="as-given"),
                  ori.Curve(times, rotations, "hermite-c1", angular_velocities=rotations[:, :3])):
        ori.write(curve, tmp_path / "keys.csv")
        again = ori.read(tmp_path / "keys.csv").curve()
        assert again.method == curve.method
        since = t - float(again.keys.epoch)
        assert np.allclose(again.rotation(since).as_quat(), curve.rotation(t).as_quat(), atol=1e-12)
    with pytest.warns(ori.ShapeWarning, match="no columns for settings"):
        ori.write(ori.Curve(times, rotations, "quintic", tension=tension), tmp_path / "keys.tum")


def test_calendars_and_nanoseconds_are_exact_in_files(tmp_path):
    rotations = [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]
    stamps = np.array([1_700_000_000_123_456_789, 1_700_000_001_000_000_001])
    for keys in (ori.Keys(stamps, rotations, time_unit="ns"), ori.Keys(stamps.astype("datetime64[ns]"), rotations)):
        assert keys.epoch == decimal.Decimal("1700000000.123456789")
        keys.write(tmp_path / "keys.csv")
        text = (tmp_path / "keys.csv").read_text()
        assert "\n1700000000.123456789," in text and "\n1700000001.000000001," in text
        keys.curve("slerp").sample(count=2).write(tmp_path / "motion.csv")
        assert [line.split(",")[0] for line in (tmp_path / "motion.csv").read_text().splitlines()[1:]] == [
            "1700000000.123456789", "1700000001.000000001"]
    assert ori.Keys([5.0, 6.0], rotations).epoch == 0


def test_reading_warns_in_the_words_of_the_library(file):
    path = file(f"t,{Q}", "1700000000123,1,0,0,0", "1700000000223,0.8,0,0,0.6")
    with pytest.warns(ori.ShapeWarning) as told:
        keys = ori.read(path)
    assert len(told) == 1 and told[0].message.code == "time_unit_by_size"
    assert str(path) in str(told[0].message) and told[0].filename == __file__
    assert keys.times.tolist() == [0, 0.1] and issubclass(ori.ShapeWarning, UserWarning)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        ori.read(path, time_scale=1e-3)


def test_columns_that_no_key_has_are_left_out_with_a_warning(file, tmp_path):
    lines = [f"t,{Q},wx,wy,wz", "0,1,0,0,0,0,0,0", "1,0.8,0,0,0.6,nan,0,0", "2,0.6,0,0,0.8,0,0,0"]
    path = file(*lines)
    for options in ({}, {"drop_invalid": True}):
        with pytest.warns(ori.ShapeWarning, match="columns of rates, inner quaternions or settings are left out"):
            keys = ori.read(path, **options)
        assert len(keys) == 3 and keys.angular_velocities is None
    command("sample", path, "--rate", 10, "--quiet", "-o", tmp_path / "wanted.csv")
    keys.curve().sample(rate=10, derivatives=2).write(tmp_path / "motion.csv")
    assert (tmp_path / "motion.csv").read_bytes() == (tmp_path / "wanted.csv").read_bytes()
    path.write_text("\n".join(["# orispline: method=hermite-c1", *lines]))
    with pytest.raises(ori.DataError, match="key 1: found 'nan', wanted a finite number") as refused:
        ori.read(path)
    assert (refused.value.file, refused.value.line, refused.value.column, refused.value.key) == (str(path), 4, 6, 1)


def test_keys_of_files_survive_slices_and_pickling(file):
    path = file("# orispline: method=quintic", f"t,{Q},tension", "1.10,1.0000001,0,0,0,1", "2.20,0.8,0,0,0.6,2",
                "3.30,0.6,0,0,0.8,3")
    keys = ori.read(path, scalar_first=True)
    again = pickle.loads(pickle.dumps(keys, 5))
    assert again.curve().method == keys.curve().method and again.repairs == keys.repairs and again.epoch == keys.epoch
    assert np.array_equal(again.rotations, keys.rotations)
    for some in (keys, again):
        some.write(path.with_name("again.csv"))
        assert path.with_name("again.csv").read_text() == path.read_text().replace("1.10", "1.1").replace(
            "2.20", "2.2").replace("3.30", "3.3")
    assert keys[::2].settings == {"tension": [1, 3]} and keys[::2].curve().method == "auto"
    assert len(keys[-2:]) == 2 and keys[1:].rotations[0].tolist() == [0.8, 0, 0, 0.6]
    with pytest.raises(ori.ArgumentError, match="wanted one above 0"):
        keys[::-1]
    with pytest.raises(ori.DataError, match="no keys"):
        keys[2:2]


def test_statistics_are_those_that_inspect_tells(file):
    import json
    path = EXAMPLES / "flight_keys.csv"
    wanted = json.loads(command("inspect", path, "--json"))
    found = ori.read(path).statistics()
    assert found.span == wanted["span_s"] and found.spacing.median == wanted["spacing_median_s"]
    assert np.rad2deg(found.step.largest) == pytest.approx(wanted["step_max_deg"], rel=1e-14)
    assert found.step.largest_at == wanted["step_max_after_key"]
    assert list(found.near_half_turns) == wanted["near_180_after_keys"]
    one = ori.Keys([0], [[0, 0, 0, 1]]).statistics()
    assert one.spacing is None and one.span == 0
    half = ori.Keys([0, 1, 2], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 0.8, -0.6]]).statistics()
    assert half.near_half_turns == (1,)


@pytest.mark.parametrize("with_rates", [0, 3])
@pytest.mark.parametrize("with_positions", [False, True])
def test_numpy_files_are_read_as_they_are_written(with_rates, with_positions, tmp_path):
    """Their columns have no names: where their number does not tell them, the caller does."""
    names = ("angular_velocities", "angular_accelerations", "angular_jerks")[:with_rates]
    dice = np.random.default_rng(3)
    more = {name: dice.normal(size=(3, 3)) for name in (*names, *(["positions"] if with_positions else []))}
    keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], **more)
    path = tmp_path / "keys.npy"
    keys.write(path)
    columns = list(keys.to_arrow().column_names)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        found = ori.read(path, columns=None if len(columns) in (5, 17) else columns)
    assert found == keys and found.epoch == 0
    first = ori.read(path, columns=columns, scalar_first=True)
    assert np.array_equal(first.rotations, keys.rotations[:, [3, 0, 1, 2]])


def test_columns_of_numpy_files_that_may_be_others_are_warned_of(tmp_path):
    q = [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
    ori.Keys([5.5, 6, 7], q, positions=np.eye(3)).write(tmp_path / "keys.npy")
    with pytest.warns(ori.ShapeWarning, match="8 columns without names are taken for t, qw, qx, qy, qz, px, py, pz; `columns` says") as told:
        assert np.array_equal(ori.read(tmp_path / "keys.npy").positions, np.eye(3))
    assert told[0].filename == __file__ and told[0].message.code == "columns_without_names"
    ori.Keys([5.5, 6, 7], q, angular_velocities=np.eye(3)).write(tmp_path / "keys.npy")
    again = ori.read(tmp_path / "keys.npy", columns=["t", "qw", "qx", "qy", "qz", "wx", "wy", "wz"])
    assert again.epoch == decimal.Decimal("5.5") and again.times.tolist() == [0, 0.5, 1.5]
    assert np.array_equal(again.angular_velocities, np.eye(3))
    np.save(tmp_path / "mended.npy", [[1, 2, 0, 0, 0], [0, 1, 0, 0, 0], [np.nan, 1, 0, 0, 0], [1, 1, 0, 0, 0]])
    mended = ori.read(tmp_path / "mended.npy", normalise=True, sort=True, drop_invalid=True, drop_duplicates=True)
    assert len(mended) == 2 and mended.repairs["duplicates_dropped"] == mended.repairs["invalid_dropped"] == mended.repairs["normalised"] == 1


def test_file_objects_are_read_as_files(tmp_path):
    text = "t,qw,qx,qy,qz\n1700000000.000000001,1,0,0,0\n1700000000.5,0.8,0,0,0.6\n"
    path = tmp_path / "keys.csv"
    path.write_text(text, "utf-8")
    wanted = ori.read(path)
    with open(path, "rb") as in_bytes, open(path, encoding="utf-8") as in_text, zipfile.ZipFile(tmp_path / "keys.zip", "w") as archive:
        archive.writestr("of/keys.csv", text)
        with archive.open("of/keys.csv") as in_archive:
            for source in (in_bytes, in_text, in_archive, io.BytesIO(text.encode()), io.StringIO(text)):
                assert ori.read(source) == wanted and ori.read(path).epoch == wanted.epoch
    named = io.BytesIO(b"1 0 0 0 0 0 0 1\n2 0 0 0 0 0 1 0\n")
    named.name = "poses.tum"
    assert ori.read(named).positions.shape == (2, 3)
    array = io.BytesIO()
    array.name = "keys.npy"
    np.save(array, [[0, 1, 0, 0, 0], [1, 0.8, 0, 0, 0.6]])
    array.seek(0)
    assert len(ori.read(array)) == 2
    both = io.StringIO("t,qw,qx,qy,qz\n" + "".join(f"{t},1,0,0,0\n" for t in [*range(100, 130), *range(20)]))
    assert [len(keys) for keys in ori.read(both, session="all")] == [30, 20]
    rates = ori.read_rates(io.StringIO("t,wx,wy,wz\n0,1,2,3\n1,4,5,6\n"))
    assert rates.rates.tolist() == [[1, 2, 3], [4, 5, 6]]


CURVE = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]], "timed-c2", ends="rest")


@pytest.mark.parametrize("what", [CURVE, CURVE.keys, CURVE.sample(rate=10, derivatives=2)], ids=["curve", "keys", "samples"])
@pytest.mark.parametrize("form", ["csv", "tum", "euroc", "npy"])
@pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
def test_file_objects_are_written_as_files(tmp_path, what, form):
    options = {} if form == "csv" else {"output_format": form}
    try:
        ori.write(what, tmp_path / "file", **options)
    except ori.ArgumentError as error:  # rates, which the format has no room for
        found = io.BytesIO(b"old")
        with pytest.raises(ori.ArgumentError) as said:
            ori.write(what, found, **options)
        assert found.getvalue() == b"old" and str(said.value) == str(error)
        return
    wanted = (tmp_path / "file").read_bytes()
    in_bytes, named = io.BytesIO(), io.BytesIO()
    named.name = f"file.{'csv' if form == 'euroc' else form}"
    ori.write(what, in_bytes, **options)
    ori.write(what, named, **options if form == "euroc" else {})
    with zipfile.ZipFile(tmp_path / "all.zip", "w") as archive, archive.open("file", "w") as in_archive:
        ori.write(what, in_archive, **options)
    with open(tmp_path / "raw", "wb", buffering=0) as raw:
        ori.write(what, raw, **options)
    assert in_bytes.getvalue() == named.getvalue() == zipfile.ZipFile(tmp_path / "all.zip").read("file") == (tmp_path / "raw").read_bytes() == wanted
    in_text = io.StringIO("# mine\n")
    in_text.seek(0, io.SEEK_END)
    if form == "npy":
        with pytest.raises(TypeError, match="path: found a file object for text, wanted one for bytes, as this format is"):
            ori.write(what, in_text, **options)
        assert in_text.getvalue() == "# mine\n"
    else:
        ori.write(what, in_text, **options)
        assert in_text.getvalue() == "# mine\n" + wanted.decode() and not in_text.closed


def test_nothing_is_written_into_a_file_object_where_it_fails():
    samples, found = CURVE.sample(count=3), io.BytesIO()
    for write, kind in ((lambda: ori.write(samples, found, output_format="xyz"), ori.ArgumentError), (lambda: ori.write(3, found), TypeError),
                        (lambda: samples.write(found, output_angle_unit="turns"), ori.ArgumentError), (lambda: CURVE.report(found, title=3), TypeError)):
        with pytest.raises(kind):
            write()
    named = io.BytesIO()
    named.name = "motion.bvh"
    with pytest.raises(ori.ArgumentError, match="motion.bvh"):
        CURVE.keys.write(named)
    assert found.getvalue() == named.getvalue() == b""
    with pytest.raises(TypeError, match="path: found int, wanted a str, a path of str, or a file object"):
        CURVE.keys.write(3)


def test_pages_and_scenes_go_into_file_objects(tmp_path):
    in_text, in_bytes = io.StringIO(), io.BytesIO()
    CURVE.report(in_text)
    CURVE.view().write(in_bytes)
    CURVE.keys.curve("slerp").report(in_bytes, title="two")
    assert in_text.getvalue().startswith("<!doctype html>") and in_bytes.getvalue().count(b"<!doctype html>") == 2
    (tmp_path / "nod.bvh").write_text("HIERARCHY\nROOT head\n{\nOFFSET 0 1.5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\n"
                                      "OFFSET 0 0.2 0\n}\n}\nMOTION\nFrames: 3\nFrame Time: 0.5\n0 0 0\n0 20 0\n0 0 0\n")
    scene = ori.read_scene(tmp_path / "nod.bvh")
    for name in ("scene.glb", "scene.gltf", "scene.bvh"):
        scene.write(tmp_path / name)
        into = io.BytesIO()
        into.name = name
        scene.write(into)
        assert into.getvalue() == (tmp_path / name).read_bytes()
    with pytest.raises(ori.ArgumentError, match="the file object"):
        scene.write(io.BytesIO())
    with open(tmp_path / "text.glb", "w") as text, pytest.raises(TypeError, match="wanted one for bytes"):
        scene.write(text)
    assert (tmp_path / "text.glb").read_bytes() == b""
    with pytest.raises(ori.AccessError, match="nowhere"):
        scene.write(tmp_path / "nowhere" / "a.glb")


def test_what_is_wrong_in_a_file_object_is_said(tmp_path):
    with pytest.raises(ori.DataError, match="^the file object:3:2: key 1: found 'x'"):
        ori.read(io.StringIO("t,qw,qx,qy,qz\n0,1,0,0,0\n1,x,0,0,0\n"))
    with pytest.raises(ori.DataError, match="^the file object: .*empty"):
        ori.read(io.BytesIO())
    named = io.BytesIO(b"t,qw,qx,qy,qz\n0,1,0,0,0\n0,1,0,0,0\n")
    named.name = "mine.csv"
    with pytest.raises(ori.DataError, match="^mine.csv:3: ") as caught:
        ori.read(named)
    assert (caught.value.file, caught.value.line) == ("mine.csv", 3)
    class Odd:
        def read(self):
            return 3
    with pytest.raises(TypeError, match="path: found an object whose read.. gives int, wanted bytes or text"):
        ori.read(Odd())
    with pytest.raises(TypeError, match="path: found int, wanted a str, a path of str, or a file object"):
        ori.read(3)
    named.name = "keys.txt.gltf"
    with pytest.raises(ori.Error, match="keys.txt.gltf"):
        ori.read_scene(named)
