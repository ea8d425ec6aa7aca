# SPDX-License-Identifier: Apache-2.0
"""A long job in rounds, of which those that are done need not be done again."""
from __future__ import annotations

import json
from typing import Any

from pyspark.errors import AnalysisException
from pyspark.sql import functions

from .. import _core
from .._checks import whole
from .._errors import ArgumentError
from ._jobs import resample


def resample_to(df: Any, path: str, rounds: int = 8, **options: Any) -> Any:
    """Resamples into a folder of Parquet files, `rounds` parts of the tracks one after the other, and reads the result.

    `options` are those of `resample`. Tracks go to rounds by the hash of `by`. The samples are in `path/samples`; what is
    done is noted in `path/done` when a round is written whole. Begun again after a crash with the same arguments, it makes
    what is missing: a round that was not whole is made anew.

    Raises ArgumentError where the folder holds rounds that were made with other arguments.
    """
    count = whole("rounds", rounds, 1, 100_000)
    if not isinstance(path, str) or not path:
        raise TypeError(f"path: found {path!r}, wanted the folder as text")
    found = resample(df, **options)  # what is wrong is said before anything is looked for
    by = options.get("by", "track")
    ids = [functions.col(name) for name in ([by] if isinstance(by, str) else by)]
    made_by = json.dumps({"version": _core.version, "rounds": count, "options": options}, sort_keys=True, default=str)
    spark = df.sparkSession
    done = _notes(spark, f"{path}/done")
    other = next((before for before in done.values() if before != made_by), None)
    if other is not None:
        raise ArgumentError(f"path: found rounds in {path} that were made with {other}, wanted {made_by}: name another folder, or "
                            "remove this one")
    for k in sorted(set(range(count)) - set(done)):
        mine = functions.pmod(functions.xxhash64(*ids), functions.lit(count)) == k
        resample(df.where(mine), **options).write.mode("overwrite").parquet(f"{path}/samples/round={k}")
        note = spark.createDataFrame([(made_by,)], "made_by string").coalesce(1)
        note.write.mode("overwrite").parquet(f"{path}/done/round={k}")
    return spark.read.schema(found.schema).parquet(*[f"{path}/samples/round={k}" for k in range(count)])


def _notes(spark: Any, folder: str) -> dict[int, str]:
    """What each round that is done was made by."""
    try:
        rows = spark.read.schema("made_by string, round int").option("basePath", folder).parquet(f"{folder}/round=*").collect()
    except AnalysisException:
        return {}
    return {row["round"]: row["made_by"] for row in rows}
