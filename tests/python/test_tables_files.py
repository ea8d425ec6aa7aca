# SPDX-License-Identifier: Apache-2.0
"""Tables in files: what is written, what is not made again, and the command."""
import json
import os
import subprocess
import sys
import urllib.parse

import numpy as np
import orispline as ori
import pytest
from track_data import expect_samples_of_curves, shuffled, table_of, tracks

pa = pytest.importorskip("pyarrow")
pytest.importorskip("duckdb")
import pyarrow.csv as csv  # noqa: E402
import pyarrow.feather as feather  # noqa: E402
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


def test_a_job_is_known_again_however_it_is_stated(tmp_path):
    pq.write_table(table_of({3: MADE[3]}), tmp_path / "day.parquet")
    out = tmp_path / "out"
    first = tables.resample_files(tmp_path / "day.parquet", out, rate=10, gap=2, by="track")
    made_at = (out / "day.parquet").stat().st_mtime_ns
    for options in ({"rate": 10.0, "gap": 2.0, "progress": lambda share: None}, {"rate": "10", "gap": 2, "by": ["track"], "method": "auto"},
                    {"rate": "20/2", "gap": 2, "quaternion": ("qx", "qy", "qz", "qw")},
                    {"rate": 10, "gap": 2, "memory_limit": "2GB", "assume_sorted": True, "threads": 1}):
        assert tables.resample_files([str(tmp_path / "day.parquet")], out, **options) == first
        assert (out / "day.parquet").stat().st_mtime_ns == made_at, options
    for options in ({"rate": 10}, {"rate": 10, "gap": 2, "derivatives": 2}, {"rate": 10, "gap": 2, "errors": "drop"}):
        tables.resample_files(tmp_path / "day.parquet", out, **options)
        assert (out / "day.parquet").stat().st_mtime_ns != made_at, options
        made_at = (out / "day.parquet").stat().st_mtime_ns
    tables.resample_files(tmp_path / "day.parquet", out, method="tcb", tension=0, bias=0.5)
    made_at = (out / "day.parquet").stat().st_mtime_ns
    tables.resample_files(tmp_path / "day.parquet", out, method="tcb:bias=0.50", tension=0.0)
    assert (out / "day.parquet").stat().st_mtime_ns == made_at


def test_a_damaged_output_is_made_again(keys, tmp_path):
    out = tmp_path / "out"
    first, = tables.resample_files(keys, out, rate=20)
    whole, place = (out / "keys.parquet").read_bytes(), out / "keys.parquet"
    assert first.errors == 1 and tables.resample_files(keys, out, rate=20) == [first]
    for at in np.linspace(0, len(whole) - 1, 40).astype(int):
        place.write_bytes(whole[:at] + bytes([whole[at] ^ 1]) + whole[at + 1:])
        assert tables.resample_files(keys, out, rate=20) == [first]
        assert place.read_bytes() == whole, f"byte {at}"
    for content in (b"", whole[:-1], whole + b"0", b"no Parquet"):
        place.write_bytes(content)
        assert tables.resample_files(keys, out, rate=20) == [first] and place.read_bytes() == whole


def test_a_name_with_brackets_is_a_name(tmp_path):
    pq.write_table(table_of({3: MADE[3]}), tmp_path / "keys[1].parquet")
    pq.write_table(table_of({4: MADE[4]}), tmp_path / "keys1.parquet")
    (tmp_path / "days[2]").mkdir()
    pq.write_table(table_of({5: MADE[5]}), tmp_path / "days[2]/a.parquet")
    for name, track in (("keys[1].parquet", 3), ("keys1.parquet", 4), ("days[2]", 5)):
        assert set(tables.resample(tmp_path / name).read_all()["track"].to_pylist()) == {track}
    assert set(tables.resample(tmp_path / "key[st]1.parquet").read_all()["track"].to_pylist()) == {4}
    summary, = tables.resample_files(tmp_path / "keys[1].parquet", tmp_path / "out")
    assert summary.rows and os.listdir(tmp_path / "out") == ["keys[1].parquet"]


@pytest.mark.parametrize("kind", [pa.float16(), pa.float32(), pa.int8()], ids=str)
def test_numbers_of_other_types_are_the_same_from_files(kind, tmp_path):
    table = table_of(MADE)
    for name in ("qx", "qy", "qz", "qw"):
        narrow = table[name].to_numpy() if kind != pa.int8() else np.where(name == "qw", 1.0, 0.0 * table[name].to_numpy())
        narrow = pa.array(narrow.astype(kind.to_pandas_dtype()), kind)
        table = table.set_column(table.schema.get_field_index(name), name, narrow)
    pq.write_table(table, tmp_path / "keys.parquet")
    found = tables.resample(tmp_path / "keys.parquet", rate=10).read_all()
    assert found.equals(tables.resample(table, rate=10).read_all()) and found["error"].null_count == len(found)


def test_ids_of_every_type_are_the_same_from_files(tmp_path):
    table = table_of({k: MADE[k] for k in range(4)})
    for kind in (pa.int8(), pa.uint64(), pa.float32(), pa.bool_(), pa.string(), pa.large_string(), pa.binary(), pa.date32(),
                 pa.timestamp("ns", "UTC"), pa.duration("us"), pa.decimal128(25, 3), pa.time64("us")):
        ids = [bool(k > 1) if kind == pa.bool_() else str(k) if kind in (pa.string(), pa.large_string()) else str(k).encode()
               if kind == pa.binary() else k for k in table["track"].to_pylist()]
        given = table.set_column(0, "track", pa.array(ids).cast(kind) if kind == pa.decimal128(25, 3) else pa.array(ids, kind))
        pq.write_table(given, tmp_path / "keys.parquet")
        assert tables.resample(tmp_path / "keys.parquet", rate=10).read_all().equals(tables.resample(given, rate=10).read_all()), kind


def test_nothing_but_the_summary_goes_to_standard_output(tmp_path):
    """DuckDB draws a bar there from two seconds on, where it is set to."""
    pq.write_table(table_of(MADE), tmp_path / "keys.parquet")
    code = f"""
import duckdb
from orispline import tables
from orispline.tables import _source
seen = []
connect = duckdb.connect

class Watched:
    def __init__(self):
        self._connection = connect()
        self._connection.execute("SET enable_progress_bar = true")
    def sql(self, text):
        seen.extend(self._connection.sql("SELECT current_setting('enable_progress_bar')").fetchall()[0])
        return self._connection.sql(text)
    def __getattr__(self, name): return getattr(self._connection, name)

duckdb.connect = Watched
tables.resample({str(tmp_path / 'keys.parquet')!r}).read_all()
print(seen)
"""
    assert subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout == "[False]\n"


def test_a_standard_output_that_is_full(keys, tmp_path):
    for words in (["--help"], ["resample", "--help"], ["resample", str(keys), "-o", str(tmp_path / "motion.parquet")]):
        code = "import sys; from orispline._command import tables; sys.exit(tables())"
        with open("/dev/full", "w", encoding="utf-8") as full:
            done = subprocess.run([sys.executable, "-c", code, *words], stdout=full, stderr=subprocess.PIPE, text=True, check=False)
        assert done.returncode == 3, done.stderr
        assert done.stderr.splitlines()[-1] == "orispline-tables: standard output: cannot be written: No space left on device"


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
                            (["mean", "--every", "1.5s", "--kind", "median"], tables.mean(keys, every=1.5, kind="median")),
                            (["compare", "--methods", "slerp,auto", "--keep-every", "4"], tables.compare(keys, ["slerp", "auto"], 4)),
                            (["compare", "--methods", "timed-c2:ends=natural,rest", "--methods", "slerp", "--keep-every", "4"],
                             tables.compare(keys, ["timed-c2:ends=natural,rest", "slerp"], 4)),
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
    (["resample", "keys.parquet", "-o", "x.txt"], 2, "found x.txt, wanted a name that ends in .parquet, .arrow or .csv"),
    (["resample", "keys.parquet", "--method", "squadd", "-o", "x.parquet"], 2, "did you mean 'squad'"),
    (["resample", "keys.parquet", "--by", "vehicle", "-o", "x.parquet"], 2,
     "wanted 'vehicle' once: name the columns by --by, --time, --quaternion and --position"),
    (["resample", "keys.parquet", "--errors", "raise", "-o", "x.parquet"], 1, "track 7: key 1: duplicate time"),
    (["resample", "keys.parquet"], 2, "the following arguments are required: -o/--output"),
    (["reduce", "keys.parquet", "-o", "x.parquet", "--tolerance", "2 apples"], 2, "2 apples"),
    (["smooth", "keys.parquet", "-o", "x.parquet", "--noise=-1deg"], 2, "noise: found '-1deg'"),
    (["compare", "keys.parquet", "-o", "x.parquet", "--methods", "slurp"], 2, "did you mean 'slerp'"),
    (["compare", "keys.parquet", "-o", "x.parquet", "--methods", "slerp,quintic:tension=1,2"], 2,
     "methods: found '2' between commas, wanted a method"),
    (["evaluate", "keys.parquet", "--at", "keys.parquet", "-o", "x.parquet"], 2, "at: found the column 'qx'"),
])
def test_the_command_says_what_is_wrong(keys, tmp_path, words, code, message, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert in_this_process(words) == code
    said = capsys.readouterr().err
    assert message in said.splitlines()[-1]
    assert os.listdir(tmp_path) == ["keys.parquet"] and keys.exists()


@pytest.mark.parametrize(("name", "table", "without"), [("smooth", "SmoothOptions", {"gyro", "gyro_noise", "gyro_offset", "gyro_bias", "sigma"}), ("reduce", "ReduceOptions", {"values"})])
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


def test_the_ending_says_what_is_written(tmp_path):
    expected = tables.resample(table_of(MADE), rate=1).read_all()
    for name, read in (("a.parquet", pq.read_table), ("b.PQ", pq.read_table), ("c", pq.read_table), ("d.arrow", feather.read_table),
                       ("e.feather", feather.read_table), ("f.csv", csv.read_csv)):
        assert tables.write(expected, tmp_path / name).rows == len(expected)
        found = read(tmp_path / name)
        assert found.column_names == expected.column_names and found.drop_columns("error").cast(expected.drop_columns("error").schema).equals(
            expected.drop_columns("error"))
    for name in ("g.txt", "h.json", "i.xlsx", "j.csv.gz", "k."):
        with pytest.raises(ori.ArgumentError, match=f"^path: found .*{name}, wanted a name that ends in .parquet, .arrow or .csv: the ending says"):
            tables.write(expected, tmp_path / name)
    for kind in (pa.list_(pa.int64()), pa.struct([("a", pa.int64())]), pa.binary()):
        with pytest.raises(ori.ArgumentError, match=r"^path: found (list|struct|binary).* in the column 'a', which pyarrow cannot write to a file of this kind"):
            tables.write(pa.table({"a": pa.nulls(1, kind)}), tmp_path / "l.csv")
    assert len(os.listdir(tmp_path)) == 6


def test_a_reader_that_is_spent_is_refused(keys, tmp_path):
    wanted = "^(reader|source|at): found a reader that has been read to its end, wanted a new one: rows come out of it once$"
    written, read = tables.resample(keys, rate=1), tables.resample(keys, rate=1)
    tables.write(written, tmp_path / "a.parquet")
    read.read_all()
    stranger = table_of(MADE).to_reader()
    assert tables.resample(stranger, rate=1).read_all().num_rows
    for spent in (written, read, stranger):
        for use in (lambda: tables.write(spent, tmp_path / "b.parquet"), lambda: tables.resample(spent), lambda: tables.evaluate(keys, spent)):
            with pytest.raises(ori.ArgumentError, match=wanted):
                use()
    assert not (tmp_path / "b.parquet").exists()
    assert tables.write(tables.resample(table_of(MADE).slice(0, 0)), tmp_path / "none.parquet").rows == 0
    again = table_of(MADE).to_reader()
    first, second = tables.resample(again), tables.resample(again)
    assert first.read_all().num_rows
    with pytest.raises(ori.ArgumentError, match=wanted):
        second.read_all()


def noted_by_spark(folder, name, *entries):
    """As its sink of files notes a batch: the folder may have been elsewhere then."""
    (folder / "_spark_metadata").mkdir(exist_ok=True)
    lines = [json.dumps({"path": f"file:///elsewhere/{urllib.parse.quote(file)}", "size": 1, "isDir": False, "modificationTime": 1, "blockReplication": 1,
                         "blockSize": 1, "action": action}) for file, action in entries]
    (folder / "_spark_metadata" / name).write_text("\n".join(["v1", *lines]), encoding="utf-8")


def test_files_that_no_batch_of_a_stream_has_noted_are_left_out(tmp_path):
    """As after a query that was killed: one is empty, one has no end, one is whole, and would give its keys twice."""
    live = tmp_path / "live"
    (live / "day=1").mkdir(parents=True)
    names = [f"part {k}.parquet" for k in range(6)]
    for track, name in enumerate(names):
        pq.write_table(table_of({track: MADE[track]}), live / ("day=1" if track == 5 else ".") / name)
    whole = (live / names[0]).read_bytes()
    for name, content in (("empty", b""), ("no end", whole[:-9]), ("again", whole)):
        (live / f"{name}.parquet").write_bytes(content)
    noted_by_spark(live, "0", ("no end.parquet", "add"), (names[0], "add"))
    noted_by_spark(live, "1.compact", *((name, "add") for name in names[:4]))
    noted_by_spark(live, "2", (names[1], "delete"), (names[5], "add"))
    (live / "_spark_metadata/.2.crc").write_bytes(b"crc")
    for source, noted in ((live, {0, 2, 3, 5}), (str(live / "*.parquet"), {0, 2, 3}), ([live / "day=1"], {5}), (str(tmp_path / "*"), {0, 2, 3, 5})):
        assert set(tables.resample(source, rate=1, errors="raise").read_all()["track"].to_pylist()) == noted, source
    assert set(tables.resample(live / names[4], rate=1).read_all()["track"].to_pylist()) == {4}, "a file that is named is read"
    (live / names[3]).unlink()
    with pytest.raises(ori.AccessError, match="live: found no part 3.parquet, which _spark_metadata says is part of it"):
        tables.resample(live)
    (live / "_spark_metadata/3").write_text("v1\n{", encoding="utf-8")
    with pytest.raises(ori.DataError, match="_spark_metadata/3: found no notes of a stream of Spark"):
        tables.resample(live)
