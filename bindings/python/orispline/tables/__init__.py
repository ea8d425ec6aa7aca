# SPDX-License-Identifier: Apache-2.0
"""Tables of many tracks: resampled, evaluated beside other tables, smoothed, reduced, averaged and compared, track by track.

One row is one key; a track is the rows with the same `by`. Everything is a stream of Arrow record batches, so that memory
does not grow with the data. Needs pyarrow, and DuckDB for the order of files: `pip install 'orispline[tables]'`.

>>> import orispline.tables as tables, pyarrow as pa
>>> keys = pa.table({"track": ["a", "a", "b", "b"], "t": [0.0, 1.0, 5.0, 5.5], "qx": [0.0] * 4, "qy": [0.0] * 4,
...                  "qz": [0.0, 0.6, 0.0, 0.6], "qw": [1.0, 0.8, 1.0, 0.8]})
>>> tables.resample(keys, by="track", rate=4).read_all().num_rows
8
"""
from __future__ import annotations

try:
    import pyarrow as _pyarrow  # noqa: F401
except ImportError:
    raise ImportError("orispline.tables: found no pyarrow, wanted it installed: pip install 'orispline[tables]'", name="pyarrow") from None

from ._files import resample_files, write
from ._jobs import compare, evaluate, mean, reduce, resample, smooth
from ._sealed import Summary

__all__ = ["Summary", "compare", "evaluate", "mean", "reduce", "resample", "resample_files", "smooth", "write"]
