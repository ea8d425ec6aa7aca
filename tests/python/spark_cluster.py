# SPDX-License-Identifier: Apache-2.0
"""A small cluster on this machine: two workers with a core each, processes of their own."""
import os
import pathlib
import shutil
import signal
import sys

import pytest

HERE = "127.0.0.1"
MEMORY = 2048  # MB of a worker


def started(master=f"local-cluster[2,1,{MEMORY}]", **settings):
    """A session on a cluster of processes, or what else the master is. The test is skipped where there is none, which says so."""
    pytest.importorskip("pyspark", reason="Spark: found no pyspark, wanted the dependency group 'spark'")
    if not shutil.which("java"):
        pytest.skip("Spark: found no Java, wanted 17 or later (Debian's openjdk-17-jre-headless)")
    os.environ |= {"SPARK_LOCAL_IP": HERE, "PYSPARK_PYTHON": sys.executable, "PYSPARK_DRIVER_PYTHON": sys.executable}
    from pyspark.sql import SparkSession
    builder = SparkSession.builder.master(master)
    chosen = {"spark.driver.host": HERE, "spark.driver.bindAddress": HERE, "spark.ui.enabled": "false",
              "spark.sql.shuffle.partitions": "8", "spark.sql.adaptive.coalescePartitions.enabled": "false",
              "spark.sql.session.timeZone": "America/New_York", "spark.log.level": "ERROR",
              **settings}
    for name, value in chosen.items():
        builder = builder.config(name, value)
    return builder.getOrCreate()


def killing_in_the_sixth_task(mark, group=None):
    """For `mapInArrow`, which passes the rows on: of eight tasks on two cores, some are done and some are not when the process
    group is killed, or without one the executor of the task. That happens once: then the file `mark` is there."""
    def passed(batches):
        from pyspark import TaskContext
        for batch in batches:
            if TaskContext.get().partitionId() == 5 and not os.path.exists(mark):
                pathlib.Path(mark).touch()
                if group is None:
                    daemon = pathlib.Path(f"/proc/{os.getppid()}/stat").read_text(encoding="ascii")
                    os.kill(int(daemon.rpartition(")")[2].split()[1]), signal.SIGKILL)
                else:
                    os.killpg(group, signal.SIGKILL)
            yield batch
    return passed
