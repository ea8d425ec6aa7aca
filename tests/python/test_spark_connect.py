# SPDX-License-Identifier: Apache-2.0
"""The jobs through Spark Connect, whose client has no Java of its own."""
import os
import shutil
import subprocess
import sys

import pytest

pytest.importorskip("pyarrow")
pytest.importorskip("pyspark", reason="Spark: found no pyspark, wanted the dependency group 'spark'")
pytest.importorskip("grpc", reason="Spark Connect: found no grpc, wanted the dependency group 'spark'")

CLIENT = """
import pyarrow as pa
from pyspark.sql import SparkSession
from track_data import shuffled, table_of, tracks

spark = SparkSession.builder.remote("local[1]").config("spark.sql.shuffle.partitions", "2").getOrCreate()
assert "connect" in type(spark).__module__
import orispline.spark as distributed
from orispline import tables

def expect_rows(df, expected, *order):
    by = [(name, "ascending") for name in order]
    assert df.toArrow().sort_by(by).cast(expected.schema).combine_chunks().equals(expected.sort_by(by).combine_chunks())

keys = table_of(tracks(20, seed=3))
df = spark.createDataFrame(shuffled(keys))
samples = tables.resample(keys, rate=30).read_all()
expect_rows(distributed.resample(df, rate=30), samples, "track", "t")
for _ in range(2):  # the second time nothing is left to do
    expect_rows(distributed.resample_to(df, "rounds", rounds=2, rate=30), samples, "track", "t")
at = pa.table({"track": [1, 2, 50], "t": [0.5, 0.75, 1.0]})
expect_rows(distributed.evaluate(df, spark.createDataFrame(at)), tables.evaluate(keys, at).read_all(), "track", "t")
expect_rows(distributed.reduce(df, "2deg"), tables.reduce(keys, "2deg").read_all(), "track", "t")

df.write.parquet("keys")
spark.conf.set("spark.sql.streaming.noDataMicroBatches.enabled", "false")
live = distributed.resample_stream(spark.readStream.schema(df.schema).parquet("keys"), rate=30)
query = live.writeStream.format("parquet").option("checkpointLocation", "notes").trigger(availableNow=True).start("live")
query.awaitTermination()
assert 0 < spark.read.parquet("live").count() < samples.num_rows  # the last samples of each track wait for keys
print("done")
"""


def test_a_client_of_spark_connect_has_the_rows_of_tables(tmp_path):
    if not shutil.which("java"):
        pytest.skip("Spark: found no Java, wanted 17 or later (Debian's openjdk-17-jre-headless)")
    done = subprocess.run([sys.executable, "-c", CLIENT], cwd=tmp_path, capture_output=True, text=True, check=False,
                          env=os.environ | {"SPARK_LOCAL_IP": "127.0.0.1", "PYSPARK_PYTHON": sys.executable,
                                            "PYTHONPATH": os.path.dirname(__file__)})
    assert "done" in done.stdout, done.stderr
