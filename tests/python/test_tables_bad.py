# SPDX-License-Identifier: Apache-2.0
"""Tables with faults: bad tracks do not hinder the others, and everything else is said in one line."""
import os
import re
import resource
import subprocess
import sys
import tempfile

import numpy as np
import orispline as ori
import pytest
from track_data import QUATERNION, expect_samples_of_curves, shuffled, table_of, tracks

pa = pytest.importorskip("pyarrow")
pytest.importorskip("duckdb")
import pyarrow.parquet as pq  # noqa: E402
from orispline import tables  # noqa: E402
from orispline.tables import _source, _tracks  # noqa: E402

FAULTS = {  # of track 3, 7, … of forty: what becomes of the rows, and what is said
    "a time twice": (lambda t, q: t.__setitem__(2, t[1]), "key 2: duplicate time"),
    "no number in a quaternion": (lambda t, q: q.__setitem__((1, 2), np.nan), "key 1: the quaternion has a component that is not finite"),
    "a far norm": (lambda t, q: q.__imul__(1.5), "key 0: the quaternion has norm 1.5"),
    "no number as a time": (lambda t, q: t.__setitem__(4, np.nan), "time"),
    "a time without end": (lambda t, q: t.__setitem__(4, np.inf), "time"),
    "a zero quaternion": (lambda t, q: q.__setitem__(3, 0.0), "key 3: "),
}


def with_faults(count=40):
    good = tracks(count, least=6)
    bad = {}
    for k, (fault, _) in enumerate(FAULTS.values()):
        times, q = (each.copy() for each in good.pop(4 * k + 3))
        fault(times, q)
        bad[4 * k + 3] = times, q
    return good, bad


@pytest.mark.parametrize("in_pieces", [False, True])
@pytest.mark.parametrize("from_memory", [True, False])
def test_a_bad_track_is_a_row_with_its_message(from_memory, in_pieces, monkeypatch):
    if in_pieces:
        monkeypatch.setattr(_tracks.tracks_in, "__defaults__", (5,))
    good, bad = with_faults()
    table = shuffled(table_of(good | bad))
    source = table if from_memory else pa.RecordBatchReader.from_batches(table.schema, iter(table.to_batches(max_chunksize=100)))
    found = tables.resample(source, derivatives=2).read_all()
    wrong = found.filter(found["error"].is_valid())
    assert wrong["track"].to_pylist() == list(bad)
    for row, (_, words) in zip(wrong.to_pylist(), FAULTS.values()):
        assert words in row["error"] and "\n" not in row["error"]
        assert all(row[name] is None for name in found.column_names if name not in ("track", "error"))
    if not in_pieces:  # the samples before the fault are out by then
        expect_samples_of_curves(found.filter(found["error"].is_null()), good, derivatives=2)
    else:
        rest = found.filter(pa.compute.and_(found["error"].is_null(), pa.compute.is_in(found["track"], pa.array(list(good)))))
        expect_samples_of_curves(rest, good, derivatives=2)


def test_bad_tracks_are_left_out_or_end_the_job():
    good, bad = with_faults()
    table = table_of(good | bad)
    expect_samples_of_curves(tables.resample(shuffled(table), errors="drop").read_all(), good)
    with pytest.raises(ori.DataError, match="^track 3: key 2: duplicate time"):
        tables.resample(table, errors="raise").read_all()
    for job in (lambda e: tables.smooth(table, smoothing_time=0.2, errors=e), lambda e: tables.reduce(table, 0.1, errors=e),
                lambda e: tables.compare(table, ["slerp"], 2, errors=e)):
        assert job("row").read_all()["error"].is_valid().to_pylist().count(True) == len(bad)
        assert not set(job("drop").read_all()["track"].to_pylist()) & set(bad)
        with pytest.raises(ori.DataError, match="^track 3: "):
            job("raise").read_all()


@pytest.mark.parametrize("ids", [pa.array([1, 1, None, None, 2]), pa.array([1.0, 1.0, float("nan"), float("nan"), 2.0])])
def test_rows_without_an_id_are_an_error(ids):
    t = pa.array([0.0, 1.0, 0.0, 1.0, 0.0])
    table = pa.table({"track": ids, "t": t, "qx": [0.0] * 5, "qy": [0.0] * 5, "qz": [0.0] * 5, "qw": [1.0] * 5})
    for job in (lambda: tables.resample(table, rate=1), lambda: tables.reduce(table, 0.1)):
        errors = [row["error"] for row in job().read_all().to_pylist() if row["track"] not in (1, 2)]
        assert len(errors) == 1 and errors[0].startswith("found no value in a column of by")


@pytest.mark.parametrize("kind", [pa.float64(), pa.timestamp("us"), pa.timestamp("ns", "UTC")])
def test_absent_values_are_bad_keys(kind):
    table = pa.table({"track": [1, 1, 1, 2, 2], "t": pa.array([0, 1, None, 0, 1]).cast(kind), "qx": [0.0] * 5, "qy": [0.0] * 5,
                      "qz": pa.array([0.0, 0.0, 0.0, None, 0.0]), "qw": [1.0] * 5})
    found = tables.resample(table, rate=1).read_all()
    assert [row["track"] for row in found.to_pylist() if row["error"]] == [1, 2]


def test_tables_without_rows():
    empty = table_of(tracks(2)).slice(0, 0)
    none = pa.RecordBatchReader.from_batches(empty.schema, iter([]))
    zero = pa.RecordBatchReader.from_batches(empty.schema, iter([pa.RecordBatch.from_pylist([], schema=empty.schema)]))
    for source in (empty, none, zero):
        found = tables.resample(source).read_all()
        assert found.num_rows == 0 and found.column_names[-1] == "error"
    assert tables.resample(empty, assume_sorted=True).read_all().num_rows == 0
    assert tables.reduce(empty, 0.1).read_all().num_rows == tables.evaluate(empty, empty.select(["track", "t"])).read_all().num_rows == 0


GOOD = table_of(tracks(2))


@pytest.mark.parametrize(("change", "message"), [
    (lambda: {"source": GOOD.drop_columns("qz")}, "wanted 'qz' once"),
    (lambda: {"source": GOOD, "by": "vehicle"}, "wanted 'vehicle' once"),
    (lambda: {"source": GOOD, "by": ["track", "t"]}, "'t' named twice"),
    (lambda: {"source": GOOD, "quaternion": ["qx", "qy", "qz"]}, "found 3 names, wanted 4: x, y, z, w"),
    (lambda: {"source": GOOD.append_column("t2", pa.array(range(GOOD.num_rows))), "time": "t2"}, "cast it to float64 if it counts seconds"),
    (lambda: {"source": GOOD.append_column("s", pa.array(["x"] * GOOD.num_rows)), "quaternion": ["qx", "qy", "qz", "s"]},
     "found string in the column 's', wanted numbers"),
    (lambda: {"source": GOOD.append_column("l", pa.array([[1]] * GOOD.num_rows)), "by": "l"}, "wanted ids that can be put in order"),
    (lambda: {"source": GOOD.append_column("h", pa.array(np.zeros(GOOD.num_rows, np.float16))), "by": "h"}, "wanted ids that can be put in order"),
    (lambda: {"source": GOOD, "rate": 0}, "rate: found 0, wanted"), (lambda: {"source": GOOD, "rate": float("nan")}, "rate: found nan"),
    (lambda: {"source": GOOD, "method": "squadd"}, "did you mean 'squad'"), (lambda: {"source": GOOD, "gap": -1.0}, "gap"),
    (lambda: {"source": GOOD, "align": "middle"}, "align: found 'middle', wanted 'start' or 'epoch'"),
    (lambda: {"source": GOOD, "errors": "ignore"}, "errors: found 'ignore'"), (lambda: {"source": GOOD, "frame": "camera"}, "frame: "),
    (lambda: {"source": GOOD, "derivatives": 4}, "derivatives: found 4, wanted a whole number from 0 to 3"),
    (lambda: {"source": GOOD, "tensoin": 0.4}, "tensoin"), (lambda: {"source": GOOD, "method": "timed-c2", "closed": True}, "loop"),
    (lambda: {"source": GOOD, "position": ["x", "y"]}, "found 2 names, wanted 3"),
    (lambda: {"source": GOOD, "threads": -1}, "threads: found -1"),
])
def test_arguments_that_make_no_job(change, message):
    with pytest.raises(ori.ArgumentError, match=re.escape(message)) as error:
        tables.resample(**change())
    assert "\n" not in str(error.value)


@pytest.mark.parametrize("change", [{"source": 7}, {"source": [GOOD]}, {"source": GOOD, "by": 7}, {"source": GOOD, "assume_sorted": 1},
                                    {"source": GOOD, "memory_limit": 10**9}, {"source": GOOD, "derivatives": 1.5}])
def test_arguments_of_another_type(change):
    with pytest.raises(TypeError, match="found .*wanted"):
        tables.resample(**change)


def test_rows_that_are_not_in_order_are_not_taken_for_sorted():
    table = table_of(tracks(5))
    turned = pa.concat_tables([table.filter(pa.compute.equal(table["track"], k)) for k in (0, 2, 1)])
    with pytest.raises(ori.DataError, match="found track 1 behind track 2, wanted rows in order of track: leave assume_sorted out"):
        tables.resample(turned, assume_sorted=True).read_all()
    again = pa.concat_tables([table, table.slice(0, 3)])
    with pytest.raises(ori.DataError, match="found track 0 behind track 4"):
        tables.resample(again, assume_sorted=True).read_all()


def test_columns_of_the_other_table():
    at = GOOD.select(["track", "t"])
    with pytest.raises(ori.ArgumentError, match="found the column 'qx', which the result has too"):
        tables.evaluate(GOOD, GOOD)
    with pytest.raises(ori.ArgumentError, match="at: .*wanted 'track' once"):
        tables.evaluate(GOOD, at.drop_columns("track"))
    with pytest.raises(ori.ArgumentError, match="wanted float seconds in both tables, or timestamps"):
        tables.evaluate(GOOD, at.set_column(1, "t", at["t"].cast(pa.int64(), safe=False).cast(pa.timestamp("s"))))


def test_files_that_cannot_be_read(tmp_path):
    pq.write_table(GOOD, tmp_path / "a.parquet")
    with pytest.raises(ori.AccessError, match="found no such file"):
        tables.resample(tmp_path / "none.parquet")
    with pytest.raises(ori.AccessError, match="found no such file"):
        tables.resample(str(tmp_path / "*.arrow"))
    (tmp_path / "empty").mkdir()
    with pytest.raises(ori.AccessError, match="found no Parquet file in it"):
        tables.resample(tmp_path / "empty")
    whole = (tmp_path / "a.parquet").read_bytes()
    bad = tmp_path / "b.parquet"
    for content in (b"", b"no Parquet at all", whole[:-100], whole[:50] + bytes(len(whole) - 400) + whole[-350:]):
        bad.write_bytes(content)
        with pytest.raises(ori.DataError, match="b.parquet: found no sound Parquet file") as error:
            tables.resample([tmp_path / "a.parquet", bad]).read_all()
        assert error.value.file and error.value.file.endswith("b.parquet") and "\n" not in str(error.value)


def damaged(path, whole):
    """The file with each of some of its bytes turned round, one at a time; nothing of it is said to be an end of the file."""
    for at in np.random.default_rng(5).integers(4, len(whole) - 8, 60):
        path.write_bytes(whole[:at] + bytes([whole[at] ^ 0x5A]) + whole[at + 1:])
        yield int(at)


@pytest.mark.parametrize("assume_sorted", [False, True])
def test_a_damaged_file_is_read_or_refused_in_a_line(tmp_path, assume_sorted):
    pq.write_table(GOOD, tmp_path / "keys.parquet")
    refused = 0
    for at in damaged(tmp_path / "keys.parquet", (tmp_path / "keys.parquet").read_bytes()):
        try:
            tables.resample(tmp_path / "keys.parquet", assume_sorted=assume_sorted).read_all()
        except ori.Error as error:
            assert "\n" not in str(error) and "Traceback" not in str(error), at
            refused += isinstance(error, ori.DataError) and "keys.parquet" in str(error)
    assert refused > 10


@pytest.mark.parametrize("assume_sorted", [False, True])
@pytest.mark.parametrize("kind", [pa.string(), pa.dictionary(pa.int32(), pa.string())], ids=str)
def test_ids_that_are_not_utf8_are_a_fault_of_their_file(tmp_path, kind, assume_sorted):
    latin = pa.compute.cast(pa.array([b"tr\xe4ck"] * 2), options=pa.compute.CastOptions(pa.string(), allow_invalid_utf8=True)).cast(kind)
    table = pa.table({"track": latin, "t": [0.0, 1.0], **{name: [0.5, 0.5] for name in QUATERNION}})
    pq.write_table(table, tmp_path / "keys.parquet")
    with pytest.raises(ori.DataError, match="keys.parquet: found no sound Parquet file .*UTF8"):
        tables.resample(tmp_path / "keys.parquet", assume_sorted=assume_sorted).read_all()


def test_an_error_of_a_stream_comes_through_as_it_is():
    def batches():
        yield from GOOD.to_batches()
        raise ZeroDivisionError("of a stranger")

    with pytest.raises(ZeroDivisionError, match="of a stranger"):
        tables.resample(pa.RecordBatchReader.from_batches(GOOD.schema, batches())).read_all()


def test_a_memory_limit_that_is_none():
    reader = pa.RecordBatchReader.from_batches(GOOD.schema, iter(GOOD.to_batches()))
    with pytest.raises(ori.ArgumentError, match="memory_limit: found 'plenty'"):
        tables.resample(reader, memory_limit="plenty").read_all()


def test_what_is_written_is_complete_or_not_there(tmp_path):
    place = tmp_path / "motion.parquet"
    place.write_bytes(b"old")
    good, bad = with_faults()
    with pytest.raises(ori.DataError):
        tables.write(tables.resample(table_of(good | bad), errors="raise"), place)
    assert place.read_bytes() == b"old" and os.listdir(tmp_path) == ["motion.parquet"]
    with pytest.raises(ori.AccessError, match="cannot be written"):
        tables.write(tables.resample(GOOD), tmp_path / "no folder" / "motion.parquet")
    with pytest.raises(ori.AccessError, match="cannot be written"):
        tables.write(tables.resample(GOOD), tmp_path)
    with pytest.raises(TypeError, match="reader: found int"):
        tables.write(7, place)
    with pytest.raises(ori.ArgumentError, match="partition_by: found 'vehicle'"):
        tables.write(tables.resample(GOOD), tmp_path / "parts", partition_by="vehicle")
    with pytest.raises(ori.AccessError, match="is there already"):
        tables.write(tables.resample(GOOD), place, partition_by="track")
    assert place.read_bytes() == b"old"
    assert tables.write(tables.resample(table_of(good | bad)), place).errors == len(bad)
    assert os.listdir(tmp_path) == ["motion.parquet"]


def test_a_link_stays_and_what_is_no_file_is_not_replaced(tmp_path):
    links = {"link": "there.parquet", "circle": "circle"}
    for link, target in links.items():
        os.symlink(target, tmp_path / link)
    for rows in (tables.resample(GOOD), tables.resample(GOOD, rate=10)):  # the file is not there at first
        summary = tables.write(rows, tmp_path / "link")
        assert pq.read_metadata(tmp_path / "there.parquet").num_rows == summary.rows
        os.chmod(tmp_path / "there.parquet", 0o640)
    assert (tmp_path / "there.parquet").stat().st_mode & 0o777 == 0o640
    os.mkfifo(tmp_path / "pipe")
    for name, reason in (("circle", "Too many levels of symbolic links"), ("pipe", "Invalid argument"), (".", "Is a directory")):
        with pytest.raises(ori.AccessError, match=f"cannot be written: {reason}"):
            tables.write(tables.resample(GOOD), tmp_path / name)
    assert {link: os.readlink(tmp_path / link) for link in links} == links
    assert (tmp_path / "pipe").is_fifo() and len(os.listdir(tmp_path)) == 4


def test_a_disk_that_fills_leaves_the_old_file(tmp_path):
    place = tmp_path / "motion.parquet"
    place.write_bytes(b"old")
    code = f"""
import resource, signal, sys
import orispline as ori, pyarrow.parquet as pq
from orispline import tables
signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
resource.setrlimit(resource.RLIMIT_FSIZE, (20000, 20000))
try:
    tables.write(tables.resample({str(tmp_path / 'keys')!r}), {str(place)!r})
except ori.AccessError as error:
    print(error)
"""
    (tmp_path / "keys").mkdir()
    pq.write_table(table_of(tracks(100)), tmp_path / "keys/a.parquet")
    said = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout
    assert said.startswith(f"{place}: cannot be written: ") and said.count("\n") == 1
    assert place.read_bytes() == b"old" and sorted(os.listdir(tmp_path)) == ["keys", "motion.parquet"]
    assert resource.getrlimit(resource.RLIMIT_FSIZE)[0] != 20000


@pytest.mark.parametrize("job", [lambda keys, progress: tables.resample(keys, progress=progress),
                                 lambda keys, progress: tables.smooth(keys, progress=progress),
                                 lambda keys, progress: tables.resample(keys, assume_sorted=True, progress=progress)],
                         ids=["resample", "smooth", "assume_sorted"])
def test_an_interrupted_job_does_no_more_and_leaves_nothing(job, tmp_path, monkeypatch):
    """Ctrl-C comes when the third batch of keys is done."""
    monkeypatch.setattr(_source, "ROWS_AT_A_TIME", 2048)
    monkeypatch.setattr(_source, "ROWS_OF_DUCKDB", 2048)
    keys, room = tmp_path / "keys.parquet", tmp_path / "room"
    pq.write_table(table_of(tracks(400)), keys)
    room.mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(room))
    shares = []

    def interrupt(share):
        shares.append(share)
        if len(shares) == 3:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        tables.write(job(keys, interrupt), tmp_path / "out.parquet")
    assert len(shares) == 3 and 0 < shares[-1] < 1
    assert sorted(os.listdir(tmp_path)) == ["keys.parquet", "room"] and not os.listdir(room)


def test_ids_and_names_are_printed_in_one_line():
    table = pa.table({"track": ["a\nb", "a\nb"], "t": [0.0, 0.0], **{name: [0.5, 0.5] for name in QUATERNION}})
    with pytest.raises(ori.DataError, match=r"^track 'a\\nb': key 1: duplicate time"):
        tables.resample(table, errors="raise").read_all()
