# SPDX-License-Identifier: Apache-2.0
"""What Python writes of samples is what the command writes of the same file, byte for byte."""
import decimal
import os
import pathlib
import subprocess

import numpy as np
import orispline as ori
import pytest
from conftest import DATA
from orispline._command import COMMAND

EXAMPLES = DATA.parents[1] / "examples/data"
SHARED = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", DATA.parents[2] / "shared/data"))
KEYS = sorted(EXAMPLES.glob("*.csv"))
NAMES = ("motion.csv", "motion.npy", "motion.tum")
METHODS = [method["name"] for method in ori.methods() if method["name"] not in ("bezier", "nu-exact")]


def by_command(path, output, *words):
    done = subprocess.run([COMMAND, "sample", path, *map(str, words), "-o", output, "--quiet"], capture_output=True, text=True,
                          check=False)
    assert done.returncode == 0, done.stderr
    return output.read_bytes()


def by_python(path, output, method, reading=None, options=None, **sampling):
    ori.read(path, **reading or {}).curve(method).sample(**sampling).write(output, **options or {})
    return output.read_bytes()


@pytest.fixture
def outputs(tmp_path):
    def made(name):
        return tmp_path / f"wanted-{name}", tmp_path / f"ours-{name}"
    return made


@pytest.fixture(scope="module")
def today(tmp_path_factory):
    """Keys at times of today, whose nanoseconds no double has."""
    dice = np.random.default_rng(4)
    path = tmp_path_factory.mktemp("today") / "keys.csv"
    stamps = 1_700_000_000_123_456_789 + np.cumsum(dice.integers(50_000_000, 900_000_001, 60))
    rows = dice.normal(size=(60, 4)).cumsum(axis=0)
    rows /= np.linalg.norm(rows, axis=1, keepdims=True)
    lines = [f"{t // 10**9}.{t % 10**9:09d},{','.join(map(repr, row.tolist()))}" for t, row in zip(stamps, rows)]
    path.write_text("\n".join(["t,qw,qx,qy,qz", *lines]) + "\n")
    return path


@pytest.mark.parametrize("name", NAMES)
@pytest.mark.parametrize("path", KEYS, ids=lambda path: path.stem)
def test_files_of_the_house(path, name, outputs):
    wanted, ours = outputs(name)
    derivatives = 0 if name.endswith("tum") else 2
    assert by_python(path, ours, "auto", rate=100, derivatives=derivatives) == by_command(path, wanted, "--method", "auto",
                                                                                        "--rate", 100)


@pytest.mark.parametrize("method", METHODS)
def test_every_method(method, outputs):
    wanted, ours = outputs("motion.csv")
    path = EXAMPLES / "flight_keys.csv"
    assert by_python(path, ours, method, rate=25, derivatives=3) == by_command(path, wanted, "--method", method, "--rate", 25,
                                                                             "--derivatives", 3)


@pytest.mark.parametrize("rate", [10, 29.97, "30000/1001", 3, "1/7"])
@pytest.mark.parametrize("name", NAMES)
def test_nanoseconds_of_today(today, name, rate, outputs):
    wanted, ours = outputs(name)
    derivatives = 0 if name.endswith("tum") else 1
    words = ["--method", "timed-c2", "--rate", rate, "--derivatives", derivatives]
    assert by_python(today, ours, "timed-c2", rate=rate, derivatives=derivatives) == by_command(today, wanted, *words)


def test_nanoseconds_of_today_in_a_file_of_whole_ones(today, outputs):
    wanted, ours = outputs("motion.csv")
    for rate in (10, "30000/1001"):
        words = ["--rate", rate, "--output-format", "euroc"]
        written = by_python(today, ours, "auto", rate=rate, options={"output_format": "euroc"})
        assert written == by_command(today, wanted, *words)
    assert ours.read_text().splitlines()[1].startswith("17000")


@pytest.mark.parametrize(("sampling", "words"), [
    ({"count": 37}, ["--count", 37]), ({"rate": 7, "include_end": True}, ["--rate", 7, "--include-end"]),
    ({"rate": 3, "start": 0.1, "end": 7.7}, ["--rate", 3, "--from=+0.1", "--to=+7.7"]),
    ({"count": 11, "start": 1 / 3}, ["--count", 11, "--from=+0.3333333333333333"]),
    ({"rate": 9, "derivatives": 2, "frame": "world"}, ["--rate", 9, "--derivatives", 2, "--frame", "world"]),
    ({"rate": 9, "threads": 0, "derivatives": 3, "frame": "world"}, ["--rate", 9, "--derivatives", 3, "--frame", "world"]),
])
def test_grids_and_frames(today, sampling, words, outputs):
    for path in (today, EXAMPLES / "camera_keys.csv"):
        wanted, ours = outputs("motion.csv")
        if "derivatives" not in sampling:
            sampling, words = {**sampling, "derivatives": 0}, [*words, "--derivatives", 0]
        assert by_python(path, ours, "auto", **sampling) == by_command(path, wanted, *words)


@pytest.mark.parametrize(("options", "words"), [
    ({"output_euler": "zyx"}, ["--output-euler", "zyx"]),
    ({"output_orientation": "rotvec"}, ["--output-orientation", "rotvec"]),
    ({"output_conjugate": True}, ["--output-conjugate"]), ({"output_angle_unit": "mrad"}, ["--output-angle-unit", "mrad"])])
def test_forms_of_orientations(options, words, outputs):
    wanted, ours = outputs("motion.csv")
    path = EXAMPLES / "robot_keys.csv"
    written = by_python(path, ours, "auto", rate=10, derivatives=2, options=options)
    assert written == by_command(path, wanted, "--rate", 10, *words)


def test_loops_and_orders(outputs):
    wanted, ours = outputs("motion.csv")
    path = EXAMPLES / "five_keys.csv"
    keys = ori.read(path, scalar_first=True)
    keys.curve("timed-c2", period=9).sample(rate=10, derivatives=2).write(ours)
    assert ours.read_bytes() == by_command(path, wanted, "--method", "timed-c2", "--period", 9, "--rate", 10)


def test_times_of_a_list(today, outputs):
    wanted, ours = outputs("motion.csv")
    keys = ori.read(today)
    times = [0.25, 3.5, 3.5, 1.125]
    listed = wanted.with_name("times.txt")
    listed.write_text("".join(f"{keys.epoch + decimal.Decimal(t)}\n" for t in times))
    keys.curve().sample(times=times, derivatives=2).write(ours)
    assert ours.read_bytes() == by_command(today, wanted, "--times", listed)


@pytest.mark.skipif(not SHARED.is_dir(), reason="the shared recordings are not here")
@pytest.mark.parametrize(("name", "reading", "words"), [
    ("trajectory/tum_fr2_desk_groundtruth.txt", {"drop_duplicates": True}, ["--drop-duplicates"]),
    ("spacecraft/mro_ck_sliced_-74000.csv", {}, []), ("flight/px4_quad_sample_attitude.csv", {}, []),
    ("imu/broad_06_undisturbed_fast_rotation_A_40s.csv", {"drop_invalid": True}, ["--drop-invalid"])])
@pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
def test_recordings_of_others(name, reading, words, outputs):
    path = SHARED / name
    wanted, ours = outputs("motion.csv")
    tried = subprocess.run([COMMAND, "sample", path, "--rate", "20", "-o", wanted, "--quiet", *words], capture_output=True,
                           text=True, check=False)
    if tried.returncode != 0:
        with pytest.raises(ori.DataError):
            ori.read(path, **reading)
        return
    assert by_python(path, ours, "auto", reading=reading, rate=20, derivatives=2) == wanted.read_bytes()
