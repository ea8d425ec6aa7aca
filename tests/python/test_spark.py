# SPDX-License-Identifier: Apache-2.0
"""Tables on a cluster: the rows of the same job on this machine, bit for bit."""
import os
import pathlib
import pickle
import re
import shutil
import signal
import subprocess
import sys

import numpy as np
import orispline as ori
import pytest
from spark_cluster import killing_in_the_sixth_task
from track_data import QUATERNION, expect_samples_of_curves, shuffled, table_of, tracks

pa = pytest.importorskip("pyarrow")
pytest.importorskip("pyspark", reason="Spark: found no pyspark, wanted the dependency group 'spark'")
import pyarrow.parquet as pq  # noqa: E402
from orispline import tables  # noqa: E402

MANY, BAD, FEW = 2000, 20, 400


@pytest.fixture(scope="module")
def made():
    """All tracks, of which every hundredth has two keys at the same time."""
    found = tracks(MANY, least=40)
    for track in range(7, MANY, MANY // BAD):
        found[track][0][30] = found[track][0][29]
    return found


@pytest.fixture(scope="module")
def keys(made):
    return shuffled(table_of(made))


@pytest.fixture
def frame(spark, tmp_path):
    """Data frames of tables, by way of files."""
    def of(table):
        place = tmp_path / f"{len(list(tmp_path.iterdir()))}.parquet"
        pq.write_table(table, place, row_group_size=100_000)
        return spark.read.parquet(str(place))
    return of


@pytest.fixture
def collected(tmp_path):
    """The rows of a data frame in order, by way of files: they hold instants, whatever the time zone of the session."""
    def of(df, *order):
        place = str(tmp_path / f"out{len(list(tmp_path.iterdir()))}")
        df.write.parquet(place)
        table = pq.read_table(place)
        return table.sort_by([(name, "ascending") for name in order or ("track", "t")]).combine_chunks()
    return of


def expect_equal(found, expected, *order):
    """That two tables have the same rows, whatever the words for their types of strings and stamps are."""
    expected = expected.sort_by([(name, "ascending") for name in order or ("track", "t")])
    assert found.column_names == expected.column_names
    assert found.cast(expected.schema).equals(expected.combine_chunks())


def expect_samples_and_bad_tracks(found, made, many=MANY):
    wrong = found.filter(found["error"].is_valid())
    bad = list(range(7, many, MANY // BAD))
    assert sorted(wrong["track"].to_pylist()) == bad
    assert all(message.startswith("key 30: duplicate time") for message in wrong["error"].to_pylist())
    expect_samples_of_curves(found.filter(found["error"].is_null()), {track: made[track] for track in range(many) if track not in bad})


def test_many_tracks_have_the_samples_of_their_curves(made, keys, frame, collected):
    from orispline import spark as distributed
    expect_samples_and_bad_tracks(collected(distributed.resample(frame(keys), by="track", rate=100)), made)


def test_an_executor_that_is_killed_costs_no_row(made, keys, frame, collected, tmp_path):
    """Killed when some of the tracks are done: their rows are on the disk by then, or are made again."""
    from orispline import spark as distributed
    df, mark = distributed.resample(frame(keys).repartition(3), by="track", rate=100), tmp_path / "killed"
    found = collected(df.mapInArrow(killing_in_the_sixth_task(str(mark)), df.schema))
    assert mark.exists()
    expect_samples_and_bad_tracks(found, made)


def with_ids(table, kind):
    texts = [f"{track:06}" for track in table["track"].to_pylist()]
    return table.set_column(0, "track", pa.array(texts)) if kind == pa.string() else table.set_column(0, "track", table["track"].cast(kind))


@pytest.mark.parametrize("kind", [pa.string(), pa.int16(), pa.float64(), pa.date32()], ids=str)
def test_ids_keep_their_type(kind, frame, collected):
    from orispline import spark as distributed
    table = with_ids(table_of(tracks(40)), kind) if kind != pa.date32() else with_ids(with_ids(table_of(tracks(40)), pa.int32()), kind)
    found = collected(distributed.resample(frame(shuffled(table)), derivatives=2, rate=30))
    assert found.schema.field("track").type == kind
    expect_equal(found, tables.resample(table, derivatives=2, rate=30).read_all())


@pytest.mark.parametrize("align", ["start", "epoch"])
@pytest.mark.parametrize("kind", [pa.timestamp("us", "UTC"), pa.timestamp("us")], ids=str)
def test_stamps_are_instants_whatever_the_time_zone(kind, align, frame, collected):
    from orispline import spark as distributed
    table = table_of(tracks(30))
    stamps = (table["t"].to_numpy() * 1e6).astype(np.int64) + 1_772_000_000_000_000
    table = table.set_column(1, "t", pa.array(stamps).cast(kind))
    found = collected(distributed.resample(frame(shuffled(table)), align=align, rate="30000/1001"))
    expect_equal(found, tables.resample(table, align=align, rate="30000/1001").read_all())


def test_one_track_of_a_million_keys(frame, collected):
    """It passes through a worker that has less memory than its samples would take beside one another."""
    from orispline import spark as distributed
    times = np.arange(1_000_000) * 0.05
    half = np.sin(0.3 * times) + 0.2 * np.sin(1.7 * times)
    q = np.column_stack([0 * half, np.sin(half), 0 * half, np.cos(half)])
    giant = table_of({1: (times, q), 2: (times[:500], q[:500])})
    found = collected(distributed.resample(frame(giant), rate=20, derivatives=2))
    expect_equal(found, tables.resample(giant, rate=20, derivatives=2, assume_sorted=True).read_all())


def test_evaluation_smoothing_reduction_means_and_comparison(frame, collected):
    from orispline import spark as distributed
    table = table_of(tracks(12, least=30, seed=2))
    dice = np.random.default_rng(5)
    at = pa.table({"track": dice.integers(0, 14, 500), "t": dice.uniform(0, 60, 500), "word": [str(k) for k in range(500)]})
    keys = frame(shuffled(table))
    expect_equal(collected(distributed.evaluate(keys, frame(at), derivatives=2), "word"),
                 tables.evaluate(table, at, derivatives=2).read_all(), "word")
    expect_equal(collected(distributed.smooth(keys, smoothing_time=0.2, rate=20)),
                 tables.smooth(table, smoothing_time=0.2, rate=20).read_all())
    expect_equal(collected(distributed.reduce(keys, "2deg")), tables.reduce(table, "2deg").read_all())
    expect_equal(collected(distributed.mean(keys, every=2)), tables.mean(table, every=2).read_all())
    expect_equal(collected(distributed.mean(keys, kind="median"), "track"), tables.mean(table, kind="median").read_all(), "track")
    order = ["track", "method", "keep_every"]
    expect_equal(collected(distributed.compare(keys, ["slerp", "auto"], keep_every=[2, 4]), *order),
                 tables.compare(table, ["slerp", "auto"], keep_every=[2, 4]).read_all(), *order)


def test_blending_functions_of_ones_own_go_to_the_workers(frame, collected, tmp_path):
    from orispline import spark as distributed
    table = table_of(tracks(12, least=30, seed=2))
    mine, other = (ori.blending("mine", [[0, middle, 1]]) for middle in (0.4, 0.6))
    keys = frame(shuffled(table))
    expect_equal(collected(distributed.resample(keys, rate=20, method=mine)), tables.resample(table, rate=20, method=mine).read_all())
    expect_equal(collected(distributed.reduce(keys, "2deg", method=mine)), tables.reduce(table, "2deg", method=mine).read_all())
    place = str(tmp_path / "rounds")
    distributed.resample_to(keys, place, rounds=1, rate=20, method=mine)
    with pytest.raises(ori.ArgumentError, match="made with .*0.4.*wanted .*0.6.*name another folder"):
        distributed.resample_to(keys, place, rounds=1, rate=20, method=other)


def test_rounds_that_are_done_are_not_done_again(frame, spark, tmp_path):
    """The job is killed behind some of its rounds."""
    from orispline import spark as distributed
    table = shuffled(table_of(tracks(400)))
    keys, place = frame(table), tmp_path / "long"
    distributed.resample_to(keys, str(place), rounds=4, rate=50)
    wholes = {k: place / f"samples/round={k}/_SUCCESS" for k in range(4)}
    made_at = {k: whole.stat().st_mtime_ns for k, whole in wholes.items()}
    for part in (place / "done/round=2").iterdir():  # as after a crash in the third round
        part.unlink()
    found = distributed.resample_to(keys, str(place), rounds=4, rate=50)
    made_again = {k for k, whole in wholes.items() if whole.stat().st_mtime_ns != made_at[k]}
    assert made_again == {2}
    expected = tables.resample(table, rate=50).read_all()
    rows = pa.Table.from_pandas(found.toPandas(), schema=expected.schema, preserve_index=False)
    expect_equal(rows.sort_by([("track", "ascending"), ("t", "ascending")]), expected)
    with pytest.raises(ori.ArgumentError, match="made with .*rate.*50.*wanted .*rate.*60.*name another folder"):
        distributed.resample_to(keys, str(place), rounds=4, rate=60)


def test_keys_that_change_between_rounds_are_noticed(spark, tmp_path, monkeypatch):
    """Between two calls, and while a call makes its rounds: the file has the same size, and another number in it."""
    from orispline import spark as distributed
    from orispline.spark import _rounds
    table = table_of(tracks(40))
    changed = table.set_column(2, "qx", pa.array([table["qx"][0].as_py() + 1e-6, *table["qx"].to_pylist()[1:]]))
    source, place = tmp_path / "keys.parquet", tmp_path / "rounds"

    def put(keys):
        pq.write_table(keys, source, use_dictionary=False, compression="none", write_statistics=False)

    put(table)
    distributed.resample_to(spark.read.parquet(str(source)), str(place), rounds=2, rate=50)
    shutil.rmtree(place / "done/round=1")
    for keys, count in ((changed, len(table)), (table.slice(1), len(table) - 1)):
        put(keys)
        with pytest.raises(ori.ArgumentError, match=f"found keys that have changed since .*{len(table)} rows then, {count} now.*name another folder"):
            distributed.resample_to(spark.read.parquet(str(source)), str(place), rounds=2, rate=50)
    put(pa.concat_tables([table.slice(30), table.slice(0, 30)]))  # the same rows in another order
    distributed.resample_to(spark.read.parquet(str(source)), str(place), rounds=2, rate=50.0)
    resample, calls = _rounds.resample, []

    def changing(df, **options):
        calls.append(df)
        if len(calls) == 3:  # the check of the arguments and a round
            put(changed)
        return resample(df, **options)

    put(table)
    monkeypatch.setattr(_rounds, "resample", changing)
    with pytest.raises(ori.ArgumentError, match="found keys that have changed"):
        distributed.resample_to(spark.read.parquet(str(source)), str(tmp_path / "other"), rounds=2, rate=50)


KILLED = """
import os, sys
sys.path.insert(0, {tests!r})
from spark_cluster import killing_in_the_sixth_task, started
spark = started("local[2]")
from orispline.spark import _rounds

resample, calls = _rounds.resample, []

def dying(df, **options):
    calls.append(df)
    found = resample(df, **options)
    if len(calls) < 4:  # the check of the arguments and two rounds
        return found
    return found.mapInArrow(killing_in_the_sixth_task({mark!r}, os.getpgrp()), found.schema)

_rounds.resample = dying
_rounds.resample_to(spark.read.parquet({keys!r}), {place!r}, rounds=4, rate=100)
"""


def test_a_killed_job_goes_on_where_it_was(made, keys, tmp_path, spark):
    """Killed in the third of four rounds."""
    from orispline import spark as distributed
    place, source, mark = tmp_path / "killed", tmp_path / "keys.parquet", tmp_path / "mark"
    pq.write_table(keys.filter(pa.compute.field("track") < FEW), source)
    code = KILLED.format(tests=os.path.dirname(__file__), keys=str(source), place=str(place), mark=str(mark))
    job = subprocess.run([sys.executable, "-c", code], start_new_session=True, capture_output=True, text=True, check=False)
    assert job.returncode == -signal.SIGKILL and mark.exists(), job.stderr
    done = {whole: whole.stat().st_mtime_ns for whole in place.glob("done/round=*/_SUCCESS")}
    assert len(done) == 2
    distributed.resample_to(spark.read.parquet(str(source)), str(place), rounds=4, rate=100)
    assert all(whole.stat().st_mtime_ns == at for whole, at in done.items())
    found = pq.read_table(place / "samples", partitioning=None).sort_by([("track", "ascending"), ("t", "ascending")])
    expect_samples_and_bad_tracks(found, made, FEW)


def test_what_is_wrong_is_said_before_a_job_begins(frame):
    from orispline import spark as distributed
    keys = frame(table_of(tracks(3)))
    for change, message in [({"by": "vehicle"}, "df: found the columns 'track', .*wanted 'vehicle' once"),
                            ({"rate": 0}, "rate: found 0"), ({"method": "squadd"}, "did you mean 'squad'"),
                            ({"errors": "ignore"}, "errors: found 'ignore'")]:
        with pytest.raises(ori.ArgumentError, match=message):
            distributed.resample(keys, **change)
    with pytest.raises(TypeError, match="path: found 7"):
        distributed.resample_to(keys, 7)
    with pytest.raises(ori.ArgumentError, match="rounds: found 0"):
        distributed.resample_to(keys, "nowhere", rounds=0)
    with pytest.raises(ori.ArgumentError, match="idle: found 'soon'"):
        distributed.resample_stream(keys, idle="soon")


def test_types_are_read_as_on_one_machine(frame, collected):
    """Times that are dates or decimals, and quaternions in one column."""
    from orispline import spark as distributed
    rows = 6
    half = np.linspace(0, 1, rows)
    q = pa.StructArray.from_arrays([pa.array(half * 0), pa.array(half * 0), pa.array(np.sin(half)), pa.array(np.cos(half))], ["x", "y", "z", "w"])
    for times, rate in ((pa.array(range(rows), pa.date32()), "1/43200"), (pa.array(range(rows)).cast(pa.decimal128(22, 3)), 4)):
        table = pa.table({"track": [1] * rows, "t": times, "q": q})
        with pytest.warns(ori.ShapeWarning, match="the column 't' of the result is .*, that of the keys"):
            found = collected(distributed.resample(frame(table), quaternion="q", rate=rate))
            expected = tables.resample(table, quaternion="q", rate=rate).read_all()
        assert found.drop_columns("t").equals(expected.drop_columns("t")) and found["t"].cast(expected["t"].type).equals(expected["t"])
    with pytest.raises(ori.ArgumentError, match="found list.* in the column 'q', wanted a struct of x, y, z, w"):
        distributed.resample(frame(pa.table({"track": [1], "t": [0.0], "q": [[0.0, 0.0, 0.0, 1.0]]})), quaternion="q")


def test_stamps_between_microseconds_are_said(frame, collected):
    from orispline import spark as distributed
    half = np.linspace(0, 1, 3)
    table = pa.table({"track": [1] * 3, "t": pa.array([0, 1000, 2000], pa.timestamp("us")), **dict(zip(QUATERNION, [half * 0, half * 0, np.sin(half), np.cos(half)]))})
    with pytest.warns(ori.ShapeWarning, match=r"the stamps in the column 't' are rounded to timestamp\[us\], since Spark has none that are finer"):
        assert len(set(collected(distributed.resample(frame(table), rate=7001))["t"].to_pylist())) == 15
    with pytest.raises(ori.ArgumentError, match="wanted timestamps with a time zone in both tables or in neither"):
        distributed.evaluate(frame(table), frame(table.select(["track", "t"]).set_column(1, "t", table["t"].cast(pa.timestamp("us", "UTC")))))


def test_a_null_time_is_said_as_on_one_machine(frame, collected):
    from orispline import spark as distributed
    table = table_of(tracks(3, least=9))
    times = [*table["t"].to_pylist()[:4], None, *table["t"].to_pylist()[5:]]
    table = table.set_column(1, "t", pa.array([t and int(1e6 * t) for t in times], pa.timestamp("us")))
    expected = tables.resample(shuffled(table), rate=30).read_all()
    assert expected["error"].drop_null()[0].as_py().startswith("found null in the column 't', wanted a time in every row: see the row with qx ")
    expect_equal(collected(distributed.resample(frame(shuffled(table)), rate=30)), expected)


def test_the_page_lists_the_functions():
    from orispline import spark as distributed
    page = (pathlib.Path(__file__).parents[2] / "docs/scale.md").read_text(encoding="utf-8")
    listed, = re.findall(r"^((?:`\w+`(?:, | and )?)+) take data frames", page, re.MULTILINE)
    assert sorted(re.findall(r"\w+(?=`)", listed)) == sorted(name for name in distributed.__all__ if not name.startswith("resample_"))


def test_a_bad_track_ends_the_job_where_that_is_wanted(frame):
    from orispline import spark as distributed
    made = tracks(5, least=6)
    made[3][0][2] = made[3][0][1]
    keys = frame(table_of(made))
    with pytest.raises(Exception, match="track 3: key 2: duplicate time"):
        distributed.resample(keys, errors="raise").collect()
    left = distributed.resample(keys, errors="drop").select("track").distinct().collect()
    assert sorted(row.track for row in left) == [0, 1, 2, 4]


def test_a_frame_without_rows(frame):
    from orispline import spark as distributed
    empty = frame(table_of(tracks(2)).slice(0, 0))
    assert distributed.resample(empty).count() == distributed.reduce(empty, "1deg").count() == 0


ON_A_WORKER = """
import sys

class Without:
    def find_spec(self, name, *rest):
        if name.split(".")[0] == sys.argv[1]:
            raise ModuleNotFoundError(f"No module named {name!r}", name=name)

sys.meta_path.insert(0, Without())
from pyspark import cloudpickle
list(cloudpickle.load(sys.stdin.buffer)(*([(1,)] if len(sys.argv) > 2 else []), iter([]), *([None] if len(sys.argv) > 2 else [])))
"""


@pytest.mark.parametrize("live", [False, True])
@pytest.mark.parametrize("module", ["orispline", "pyarrow"])
def test_a_worker_that_lacks_a_package_says_so_in_a_line(module, live):
    """The function as it is sent, in a process that cannot import the package."""
    from orispline.spark import _frames, _stream
    from orispline.tables import _jobs, _layout
    from pyspark import cloudpickle
    job = _jobs.resampling(_layout.layout("track", "t", QUATERNION, None), 100, "start", "auto", 1, "body", None, "row", 1, {})
    sent = _stream._on_a_worker(pickle.dumps((job, None)), 1) if live else _frames.on_a_worker(pickle.dumps((job,)))
    done = subprocess.run([sys.executable, "-c", ON_A_WORKER, module, *(["live"] if live else [])], input=cloudpickle.dumps(sent),
                          capture_output=True, check=False)
    assert done.stderr.decode().splitlines()[-1] == (
        f"ImportError: orispline.spark: a worker found no {module}, wanted orispline with its extra 'spark' installed on every executor: "
        "docs/scale.md says how")
