# SPDX-License-Identifier: Apache-2.0
"""Live streams: what comes out of several triggers is what the batch job gives, once."""
import os
import signal
import subprocess
import sys

import numpy as np
import orispline as ori
import pytest
from track_data import QUATERNION, columns, rows_of, table_of, tracks

pa = pytest.importorskip("pyarrow")
pytest.importorskip("pyspark", reason="Spark: found no pyspark, wanted the dependency group 'spark'")
import pyarrow.parquet as pq  # noqa: E402
from orispline import tables  # noqa: E402


MOST_BATCHES = 100  # for rows that wait until their track is idle


class Stream:
    """A folder in which files arrive. Each trigger begins anew from what the one before noted on the disk."""

    def __init__(self, spark, folder, schema, **options):
        self._spark, self._folder, self._schema, self._options = spark, folder, schema, options
        self._files = 0
        (folder / "in").mkdir()

    def arrived(self):
        """One more file has come without a trigger."""
        self._files += 1

    def trigger(self, table=None, least=0, **options):
        """All rows so far in order, when these keys have come, and there are so many rows or there have been many batches."""
        from orispline import spark as distributed
        if table is not None:
            pq.write_table(table, self._folder / f"in/{self._files}.parquet")
            self._files += 1
        keys = self._spark.readStream.schema(self._schema).parquet(str(self._folder / "in"))
        samples = distributed.resample_stream(keys, **{**self._options, **options})
        self._spark.conf.set("spark.sql.streaming.noDataMicroBatches.enabled", least > 0)  # they never end, and end idle tracks
        wanted = {"processingTime": "200 milliseconds"} if least else {"availableNow": True}
        query = samples.writeStream.format("parquet").option("checkpointLocation", str(self._folder / "notes")).trigger(**wanted).start(
            str(self._folder / "out"))
        try:
            while not query.awaitTermination(0.2):
                if least and (self._rows(samples.schema).num_rows >= least or len(query.recentProgress) >= MOST_BATCHES):
                    break
        finally:
            query.stop()
        return self._rows(samples.schema)

    def _rows(self, schema):
        if not (self._folder / "out/_spark_metadata").exists():
            return pa.table({})
        files = self._spark.read.schema(schema).parquet(str(self._folder / "out")).inputFiles()
        parts = [pq.read_table(name.removeprefix("file://")) for name in files]
        return pa.concat_tables(parts).sort_by([("track", "ascending"), ("t", "ascending")]) if parts else pa.table({})


@pytest.fixture
def stream(spark, tmp_path):
    def of(table, **options):
        spark.conf.set("spark.sql.shuffle.partitions", "2")
        pq.write_table(table, tmp_path / "like.parquet")
        return Stream(spark, tmp_path, spark.read.parquet(str(tmp_path / "like.parquet")).schema, **options)
    yield of
    spark.conf.set("spark.sql.shuffle.partitions", "8")


def thirds(table):
    """Its rows in three parts by time, so that most tracks are in all of them."""
    rank = np.zeros(table.num_rows)
    ids = np.array(table["track"].to_pylist())
    for track in set(ids.tolist()):
        here = np.nonzero(ids == track)[0]
        rank[here] = np.arange(len(here)) * 3 // max(len(here), 1)
    return [table.filter(pa.array(rank == k)) for k in range(3)]


def as_stamps(table, kind):
    return table.set_column(1, "t", pa.array((table["t"].to_numpy() * 1e6).astype(np.int64) + 1_772_000_000_000_000).cast(kind))


@pytest.mark.parametrize("kind", [pa.float64(), pa.timestamp("us", "UTC"), pa.timestamp("us")], ids=str)
def test_three_triggers_give_the_samples_of_the_batch_job(kind, stream):
    table = table_of(tracks(60, least=3))
    table = table if kind == pa.float64() else as_stamps(table, kind)
    options = {"rate": 50, "derivatives": 2, "align": "epoch" if kind == pa.timestamp("us") else "start"}
    expected = tables.resample(table, **options).read_all()
    live = stream(table, **options)
    first, second, third = thirds(table)
    counts = [live.trigger(part).num_rows for part in (first, second)]
    found = live.trigger(third, expected.num_rows, idle=0.01)
    assert 0 < counts[0] < counts[1] < found.num_rows
    assert found.cast(expected.schema).equals(expected)


def test_the_state_of_a_track_carries_blending_functions_of_ones_own(stream):
    table = table_of(tracks(12, least=9))
    options = {"rate": 50, "method": ori.blending("mine", [[0, "1-a", 1]], parameters={"lag": 0.4}), "lag": 0.3}
    expected = tables.resample(table, **options).read_all()
    live = stream(table, **options)
    for part in thirds(table)[:2]:
        live.trigger(part)
    assert live.trigger(thirds(table)[2], expected.num_rows, idle=0.01).cast(expected.schema).equals(expected)


def test_keys_that_come_late_are_rows_with_an_error(stream):
    made = tracks(20, least=9)
    table = table_of(made)
    live = stream(table, rate=50, idle=0.01)
    live.trigger(table)
    late = table.slice(0, 0)
    for track in (3, 7):
        times, q = made[track]
        late = pa.concat_tables([late, table_of({track: (times[[2, 4]] + 0.001, q[[2, 4]])})])
    on_time = table_of({3: (made[3][0][-1:] + 0.1, made[3][1][:1])})
    expected = tables.resample(pa.concat_tables([table, on_time]), rate=50).read_all()
    found = live.trigger(pa.concat_tables([late, on_time]), expected.num_rows + 4, idle=0.01)
    wrong = found.filter(found["error"].is_valid())
    assert wrong["track"].to_pylist() == [3, 3, 7, 7] and np.array_equal(wrong["t"].to_numpy(), late["t"].to_numpy())
    assert all("wanted" in message for message in wrong["error"].to_pylist())
    rows = found.filter(found["error"].is_null())
    assert rows.cast(expected.schema).equals(expected)


KILLED = """
import os, sys
sys.path.insert(0, {tests!r})
from spark_cluster import killing_in_the_sixth_task, started
spark = started("local[2]", **{{"spark.sql.streaming.noDataMicroBatches.enabled": "false"}})
from orispline import spark as distributed
keys = spark.readStream.schema(spark.read.parquet({like!r}).schema).parquet({folder!r} + "/in")
samples = distributed.resample_stream(keys, rate=50, idle=0.01)
samples = samples.mapInArrow(killing_in_the_sixth_task({mark!r}, os.getpgrp()), samples.schema)
samples.writeStream.format("parquet").option("checkpointLocation", {folder!r} + "/notes").trigger(availableNow=True).start(
    {folder!r} + "/out").awaitTermination()
"""


def test_a_killed_query_goes_on_where_it_was(stream, spark, tmp_path):
    """All its processes, within the second trigger: some partitions are done then. Each sample is there once."""
    table = table_of(tracks(60, least=3))
    expected = tables.resample(table, rate=50).read_all()
    live, mark = stream(table, rate=50), tmp_path / "mark"
    spark.conf.set("spark.sql.shuffle.partitions", "8")  # as in the process that is killed: the notes keep it
    first, second, third = thirds(table)
    count = live.trigger(first).num_rows
    pq.write_table(second, tmp_path / "in/1.parquet")
    code = KILLED.format(tests=os.path.dirname(__file__), like=str(tmp_path / "like.parquet"), folder=str(tmp_path), mark=str(mark))
    query = subprocess.run([sys.executable, "-c", code], start_new_session=True, capture_output=True, text=True, check=False)
    assert query.returncode == -signal.SIGKILL and mark.exists(), query.stderr
    live.arrived()
    found = live.trigger(third, expected.num_rows, idle=0.01)
    assert 0 < count < found.num_rows
    assert found.cast(expected.schema).equals(expected)
    files = set(map(str, (tmp_path / "out").glob("*.parquet")))
    left = files - {name.removeprefix("file://") for name in spark.read.parquet(str(tmp_path / "out")).inputFiles()}
    assert left, "files of the trigger that was killed"
    for source in (tmp_path / "out", str(tmp_path / "out/*.parquet")):
        assert sum(tables.mean(source, errors="raise").read_all()["count"].to_pylist()) == found.num_rows, "tables leave them out"


@pytest.mark.parametrize("errors", ["row", "drop"])
def test_bad_keys_are_left_out(errors, stream):
    made = tracks(5, least=9)
    table = table_of(made)
    row = int(np.nonzero(table["track"].to_numpy() == 2)[0][4])
    qx, ids = table["qx"].to_numpy().copy(), table["track"].to_pylist()
    qx[row] = np.nan
    bad = table.set_column(2, "qx", pa.array(qx))
    nameless = table.slice(0, 1).set_column(0, "track", pa.array([None], pa.int64()))
    good = tables.resample(table.filter(pa.array([k != row for k in range(len(ids))])), rate=50).read_all()
    arrived, least = pa.concat_tables([bad, nameless]), good.num_rows + (2 if errors == "row" else 0)
    found = stream(table, rate=50, errors=errors).trigger(arrived, least, idle=0.01)
    wrong = found.filter(found["error"].is_valid())
    if errors == "row":
        assert sorted(wrong["track"].to_pylist(), key=lambda each: each is None) == [2, None]
        assert "not finite" in rows_of(wrong, 2)["error"][0].as_py() and rows_of(wrong, 2)["t"][0] == table["t"][row]
        assert rows_of(wrong, None)["error"][0].as_py().startswith("found no value in a column of by")
    else:
        assert len(wrong) == 0
    assert np.array_equal(columns(found.filter(found["error"].is_null()), QUATERNION), columns(good, QUATERNION))


def test_a_method_that_solves_over_all_keys_waits_for_the_end(stream):
    table = table_of(tracks(8, least=3))
    live = stream(table, rate=50, method="rotation-spline", idle=0.01)
    assert live.trigger(table).num_rows == 0
    later = table_of({8: tracks(1, least=9)[0]})
    expected = tables.resample(pa.concat_tables([table, later]), rate=50, method="rotation-spline").read_all()
    assert live.trigger(later, expected.num_rows).cast(expected.schema).equals(expected)
