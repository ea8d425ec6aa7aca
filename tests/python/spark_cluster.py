# SPDX-License-Identifier: Apache-2.0
"""A small cluster on this machine: two workers with a core each, processes of their own."""
import os
import pathlib
import shutil
import sys

import pytest

HERE = "127.0.0.1"
MEMORY = 2048  # MB of a worker


def started(**settings):
    """A session on a cluster, or the test is skipped, which says so."""
    pytest.importorskip("pyspark", reason="Spark: found no pyspark, wanted the dependency group 'spark'")
    if not shutil.which("java"):
        pytest.skip("Spark: found no Java, wanted 17 or later (Debian's openjdk-17-jre-headless)")
    os.environ |= {"SPARK_LOCAL_IP": HERE, "PYSPARK_PYTHON": sys.executable, "PYSPARK_DRIVER_PYTHON": sys.executable}
    from pyspark.sql import SparkSession
    builder = SparkSession.builder.master(f"local-cluster[2,1,{MEMORY}]")
    chosen = {"spark.driver.host": HERE, "spark.driver.bindAddress": HERE, "spark.ui.enabled": "false",
              "spark.sql.shuffle.partitions": "8", "spark.sql.adaptive.coalescePartitions.enabled": "false",
              "spark.sql.session.timeZone": "America/New_York", "spark.log.level": "ERROR",
              **settings}
    for name, value in chosen.items():
        builder = builder.config(name, value)
    return builder.getOrCreate()


def processes(words):
    """Those whose command has these words."""
    found = []
    for process in pathlib.Path("/proc").glob("[0-9]*"):
        try:
            if words in (process / "cmdline").read_text():
                found.append(int(process.name))
        except OSError:
            continue
    return found
