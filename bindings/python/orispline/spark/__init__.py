# SPDX-License-Identifier: Apache-2.0
"""The jobs of `orispline.tables` on Spark's data frames, with the same bits.

One row is one key; a track is the rows with the same `by`. Each function takes a data frame and gives one, which Spark makes
when it is asked for. Needs PySpark 3.5 or later and pyarrow, here and on the executors: `pip install 'orispline[spark]'`;
docs/scale.md says how executors get the package.
"""
from __future__ import annotations

try:
    import pyarrow as _pyarrow  # noqa: F401
    import pyspark as _pyspark  # noqa: F401
except ImportError as error:
    raise ImportError(f"orispline.spark: found no {error.name}, wanted it installed: pip install 'orispline[spark]'",
                      name=error.name) from None

from ._jobs import compare, evaluate, mean, reduce, resample, smooth
from ._rounds import resample_to
from ._stream import resample_stream

__all__ = ["compare", "evaluate", "mean", "reduce", "resample", "resample_stream", "resample_to", "smooth"]
