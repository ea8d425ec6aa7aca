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
from ..tables._jobs import resampling_of
from ._jobs import checked, resample


def resample_to(df: Any, path: str, rounds: int = 8, **options: Any) -> Any:
    """Resamples into a folder of Parquet files, `rounds` parts of the tracks one after the other, and reads the result.

    `options` are those of `resample`. Tracks go to rounds by the hash of `by`. The samples are in `path/samples`; what is
    done is noted in `path/done` when a round is written whole. Begun again after a crash with the same arguments, it makes
    what is missing: a round that was not whole is made anew. The keys are read once more before the rounds and behind
    them, for a checksum: that they are the same in all rounds.

    Raises ArgumentError where the folder holds rounds that were made with other arguments, or of other keys.
    """
    count = whole("rounds", rounds, 1, 100_000)
    if not isinstance(path, str) or not path:
        raise TypeError(f"path: found {path!r}, wanted the folder as text")
    found = resample(df, **options)  # what is wrong is said before anything is looked for
    job = resampling_of(options)
    _, keys = checked(job, df)
    spark = df.sparkSession
    done = _notes(spark, f"{path}/done")
    made_by = {"version": _core.version, "rounds": count, "job": job.stated, "keys": _contents(keys)}
    for before in done.values():
        _expect_the_same(path, before, made_by)
    missing = sorted(set(range(count)) - set(done))
    for k in missing:
        mine = functions.pmod(functions.xxhash64(*job.layout.by), functions.lit(count)) == k
        resample(keys.where(mine), **options).write.mode("overwrite").parquet(f"{path}/samples/round={k}")
        note = spark.createDataFrame([(json.dumps(made_by, sort_keys=True),)], "made_by string").coalesce(1)
        note.write.mode("overwrite").parquet(f"{path}/done/round={k}")
    if missing:
        _expect_the_same(path, made_by, {**made_by, "keys": _contents(keys)})
    return spark.read.schema(found.schema).parquet(*[f"{path}/samples/round={k}" for k in range(count)])


def _contents(keys: Any) -> dict[str, Any]:
    """The number of rows, and a checksum that does not depend on their order."""
    row = functions.xxhash64(*keys.columns).cast("decimal(20,0)")
    found = keys.agg(functions.count(functions.lit(1)).alias("rows"), functions.sum(row).alias("checksum")).first()
    return {"rows": found["rows"], "checksum": str(found["checksum"])}


def _expect_the_same(path: str, before: dict[str, Any], now: dict[str, Any]) -> None:
    cure = "name another folder, or remove this one"
    others = {name: (before.get(name), value) for name, value in now.items() if before.get(name) != value}
    if set(others) == {"keys"}:
        raise ArgumentError(f"df: found keys that have changed since rounds in {path} were made of them ({before['keys']['rows']} rows "
                            f"then, {now['keys']['rows']} now), wanted the same in all rounds: {cure}")
    if others:
        was, wanted = (json.dumps({name: pair[side] for name, pair in others.items()}, sort_keys=True) for side in (0, 1))
        raise ArgumentError(f"path: found rounds in {path} that were made with {was}, wanted {wanted}: {cure}")


def _notes(spark: Any, folder: str) -> dict[int, dict[str, Any]]:
    """What each round that is done was made by."""
    try:
        rows = spark.read.schema("made_by string, round int").option("basePath", folder).parquet(f"{folder}/round=*").collect()
    except AnalysisException:
        return {}
    return {row["round"]: json.loads(row["made_by"]) for row in rows}
