# SPDX-License-Identifier: Apache-2.0
"""Tables in files: what is written, what is not made again, and the command."""
import os
import subprocess
import sys

import pytest
from track_data import expect_samples_of_curves, shuffled, table_of, tracks

pa = pytest.importorskip("pyarrow")
pytest.importorskip("duckdb")
import pyarrow.parquet as pq  # noqa: E402
from orispline import tables  # noqa: E402
from orispline._options import FIELDS  # noqa: E402
from orispline.tables._command import main  # noqa: E402

MADE = tracks(40)


@pytest.fixture
def keys(tmp_path):
    """A file of keys, with a bad track."""
    times, q = (each.copy() for each in MADE[7])
    times[1] = times[0]
    pq.write_table(shuffled(table_of(MADE | {7: (times, q)})), tmp_path / "keys.parquet")
    return tmp_path / "keys.parquet"


def good(table):
    return table.filter(table["error"].is_null())


def expect_the_good(found):
    expect_samples_of_curves(good(found).sort_by([("track", "ascending"), ("t", "ascending")]), {k: v for k, v in MADE.items() if k != 7})


def test_a_summary_counts_and_quotes(keys, tmp_path):
    summary = tables.write(tables.resample(keys), tmp_path / "motion.parquet")
    found = pq.read_table(tmp_path / "motion.parquet")
    expect_the_good(found)
    assert (summary.rows, summary.errors) == (len(found), 1) and summary.first_errors[0].startswith("track 7: key 1: duplicate time")
    assert str(summary) == f"{tmp_path / 'motion.parquet'}: {len(found)} rows, 1 of them error"


def test_a_folder_with_a_file_for_each_value(keys, tmp_path):
    summary = tables.write(tables.resample(keys, errors="drop"), tmp_path / "motion", partition_by="track")
    assert sorted(path.name for path in (tmp_path / "motion").iterdir()) == sorted(f"track={k}" for k in MADE if k != 7)
    found = pq.read_table(tmp_path / "motion/track=5")
    assert len(found) and summary.errors == 0
    again = tables.resample(tmp_path / "motion", quaternion=["qx", "qy", "qz", "qw"], rate=10, errors="raise").read_all()
    assert set(again["track"].to_pylist()) == set(MADE) - {7}, "the folder is a source"


def test_files_are_made_once(tmp_path):
    for k in range(3):
        pq.write_table(table_of({track: MADE[track] for track in range(10 * k, 10 * k + 10)}), tmp_path / f"day{k}.parquet")
    pattern, out = tmp_path / "day*.parquet", tmp_path / "out"
    first = tables.resample_files(pattern, out)
    times = [path.stat().st_mtime_ns for path in sorted(out.iterdir())]
    assert tables.resample_files(pattern, out, threads=2) == first
    assert [path.stat().st_mtime_ns for path in sorted(out.iterdir())] == times, "nothing was made again"
    (out / "day1.parquet").write_bytes(b"half a file")
    pq.write_table(table_of({3: MADE[3]}), tmp_path / "day2.parquet")
    assert [summary.rows for summary in tables.resample_files(pattern, out)][:2] == [summary.rows for summary in first][:2]
    assert [path.stat().st_mtime_ns == before for path, before in zip(sorted(out.iterdir()), times)] == [True, False, False]
    assert tables.resample_files(pattern, out, rate=10)[0].rows < first[0].rows, "another rate is another content"
    expect_samples_of_curves(pq.read_table(out / "day1.parquet"), {k: MADE[k] for k in range(10, 20)}, rate=10)


def test_files_that_would_meet_are_refused(tmp_path):
    for folder in ("a", "b"):
        (tmp_path / folder).mkdir()
        pq.write_table(table_of({3: MADE[3]}), tmp_path / folder / "day.parquet")
    with pytest.raises(ValueError, match="two files named 'day.parquet'"):
        tables.resample_files(tmp_path / "*/day.parquet", tmp_path / "out")
    with pytest.raises(ValueError, match="the keys would be lost"):
        tables.resample_files(tmp_path / "a/day.parquet", tmp_path / "a")


def command(*words, folder):
    code = "import sys; from orispline._command import tables; sys.exit(tables())"
    return subprocess.run([sys.executable, "-c", code, *map(str, words)], capture_output=True, text=True, cwd=folder, check=False)


def test_the_command_does_the_same(keys, tmp_path):
    done = command("resample", "*.parquet", "--by", "track", "--rate", "100", "-o", "motion.parquet", folder=tmp_path)
    assert done.returncode == 0 and done.stdout.startswith("motion.parquet: ") and "1 of them error" in done.stdout
    assert done.stderr.splitlines() == ["  track 7: " + done.stderr.split("track 7: ")[1].strip()]
    expect_the_good(pq.read_table(tmp_path / "motion.parquet"))
    (tmp_path / "motion.parquet").unlink()
    pq.write_table(table_of(MADE).select(["track", "t"]), tmp_path / "at.parquet")
    for words, expected in ((["smooth", "--smoothing-time", "0.2", "--errors", "drop"], tables.smooth(keys, smoothing_time=0.2, errors="drop")),
                            (["reduce", "--tolerance", "2deg"], tables.reduce(keys, "2deg")),
                            (["compare", "--methods", "slerp,auto", "--keep-every", "4"], tables.compare(keys, ["slerp", "auto"], 4)),
                            (["evaluate", "--at", str(tmp_path / "at.parquet"), "--extrapolate", "hold"],
                             tables.evaluate(keys, tmp_path / "at.parquet", extrapolate="hold"))):
        done = command(words[0], keys, *words[1:], "--output", tmp_path / "made.parquet", folder="/")
        assert done.returncode == 0, done.stderr
        assert pq.read_table(tmp_path / "made.parquet").equals(expected.read_all()), words
    done = command("resample", keys, "--partition-by", "track", "--errors", "drop", "-o", "folder", folder=tmp_path)
    assert done.returncode == 0 and len(list((tmp_path / "folder").iterdir())) == len(MADE) - 1


def test_the_command_warns_in_a_line(tmp_path):
    pq.write_table(table_of(MADE), tmp_path / "keys.parquet")
    done = command("smooth", "keys.parquet", "--noise", "0.1deg", "-o", "smooth.parquet", folder=tmp_path)
    assert done.returncode == 0 and any(line.startswith("orispline-tables: track ") for line in done.stderr.splitlines()), done.stderr


def in_this_process(words):
    """What the command ends with."""
    try:
        return main(words)
    except SystemExit as ended:
        return ended.code


@pytest.mark.parametrize(("words", "code", "message"), [
    (["resample", "none.parquet", "-o", "x.parquet"], 3, "none.parquet: found no such file"),
    (["resample", "keys.parquet", "-o", "no/folder.parquet"], 3, "no/folder.parquet: cannot be written"),
    (["resample", "keys.parquet", "-o", "."], 2, "found the folder"),
    (["resample", "keys.parquet", "--method", "squadd", "-o", "x.parquet"], 2, "did you mean 'squad'"),
    (["resample", "keys.parquet", "--by", "vehicle", "-o", "x.parquet"], 2,
     "wanted 'vehicle' once: name the columns by --by, --time, --quaternion and --position"),
    (["resample", "keys.parquet", "--errors", "raise", "-o", "x.parquet"], 1, "track 7: key 1: duplicate time"),
    (["resample", "keys.parquet"], 2, "the following arguments are required: -o/--output"),
    (["reduce", "keys.parquet", "-o", "x.parquet", "--tolerance", "2 apples"], 2, "2 apples"),
    (["smooth", "keys.parquet", "-o", "x.parquet", "--noise=-1deg"], 2, "noise: found '-1deg'"),
    (["compare", "keys.parquet", "-o", "x.parquet", "--methods", "slurp"], 2, "did you mean 'slerp'"),
    (["evaluate", "keys.parquet", "--at", "keys.parquet", "-o", "x.parquet"], 2, "at: found the column 'qx'"),
])
def test_the_command_says_what_is_wrong(keys, tmp_path, words, code, message, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert in_this_process(words) == code
    said = capsys.readouterr().err
    assert message in said.splitlines()[-1]
    assert os.listdir(tmp_path) == ["keys.parquet"] and keys.exists()


@pytest.mark.parametrize(("name", "table", "without"), [("smooth", "SmoothOptions", {"gyro", "gyro_noise", "sigma"}), ("reduce", "ReduceOptions", {"values"})])
def test_the_command_has_every_option_of_the_tasks(name, table, without, capsys):
    assert in_this_process([name, "--help"]) == 0
    said = capsys.readouterr().out
    assert all("--" + field["name"].replace("_", "-") in said for field in FIELDS[table] if field["name"] not in without)


def test_without_pyarrow_it_says_what_to_install(tmp_path):
    code = "import sys; sys.modules['pyarrow'] = None; from orispline._command import tables; sys.exit(tables())"
    done = subprocess.run([sys.executable, "-c", code, "resample", "x", "-o", "y"], capture_output=True, text=True, check=False)
    assert done.returncode == 3
    assert done.stderr == "orispline-tables: found no pyarrow, wanted it installed: pip install 'orispline[tables]'\n"
    code = "import sys; sys.modules['duckdb'] = None; from orispline import tables; list(tables.resample(sys.argv[1]))"
    pq.write_table(table_of(MADE), tmp_path / "keys.parquet")
    done = subprocess.run([sys.executable, "-c", code, str(tmp_path / "keys.parquet")], capture_output=True, text=True, check=False)
    assert "ImportError: orispline.tables: found no duckdb, which puts files and streams in order" in done.stderr


def test_tables_are_not_imported_before_they_are_asked_for():
    code = "import sys, orispline; print(sorted({'orispline.tables', 'pyarrow'} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.strip() == "[]"
