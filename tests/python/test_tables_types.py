# SPDX-License-Identifier: Apache-2.0
"""Every type of column that pyarrow and Polars give: read as the same keys, or refused with the column and its type."""
import datetime
import decimal
import functools

import numpy as np
import orispline as ori
import pytest
from track_data import QUATERNION, columns, table_of

pa = pytest.importorskip("pyarrow")
pytest.importorskip("duckdb")
import pyarrow.compute as pc  # noqa: E402
from orispline import tables  # noqa: E402

HALF = np.array([0.0, 0.1, 0.3, 0.2, 0.5, 0.4])
Q = np.column_stack([0 * HALF, np.sin(HALF), 0 * HALF, np.cos(HALF)])
EIGHTHS = np.array([0, 8, 24, 32, 52, 60])  # times, which floats of 32 bits and milliseconds hold
KEYS = table_of({0: (EIGHTHS / 8, Q), 1: (EIGHTHS / 4, Q)})
TRACKS, TEXTS = KEYS["track"].to_pylist(), [f"t{track}" for track in KEYS["track"].to_pylist()]
MILLISECONDS = pa.array((KEYS["t"].to_numpy() * 1000).astype(np.int64))


def decimals(kind):
    return pa.array(map(decimal.Decimal, TRACKS), kind)


def coded(values, kind=pa.int32):
    return pa.DictionaryArray.from_arrays(pa.array(np.arange(len(values)), kind()), values)


def runs(values):
    return pa.RunEndEncodedArray.from_arrays(pa.array(np.arange(1, len(values) + 1), pa.int32()), values)


def forms(table):
    """A table in memory, and one that comes in parts and is put in order by DuckDB."""
    return table, table.to_reader(max_chunksize=5)


@functools.cache
def samples_of_keys():
    return tables.resample(KEYS, rate=10, errors="raise").read_all()


def expect(table, without=(), **options):
    """That a table of such columns has the samples of the keys."""
    expected = samples_of_keys()
    names = [name for name in expected.column_names if name not in without]
    for form in forms(table):
        found = tables.resample(form, rate=10, errors="raise", **options).read_all()
        assert found.select(names).equals(expected.select(names))
    return found


IDS = {
    **{str(kind): pa.array(TRACKS, kind) for kind in (pa.int8(), pa.uint8(), pa.int16(), pa.uint32(), pa.uint64(), pa.float32(), pa.float64(),
                                                      pa.date32(), pa.time32("s"), pa.time64("ns"), pa.duration("ns"), pa.timestamp("ms"),
                                                      pa.timestamp("ns", "UTC"))},
    **{str(kind): pa.array(TEXTS, kind) for kind in (pa.string(), pa.large_string(), pa.string_view(), pa.binary(), pa.large_binary(),
                                                     pa.binary_view(), pa.binary(2))},
    **{name: decimals(getattr(pa, name)(5, 2)) for name in ("decimal32", "decimal64", "decimal128", "decimal256") if hasattr(pa, name)},
    "bool": pa.array(TRACKS).cast(pa.bool_()), "date64": pa.array(TRACKS, pa.date32()).cast(pa.date64()),
    "dictionary": pa.array(TEXTS).dictionary_encode(), "dictionary of numbers": coded(pa.array(TRACKS), pa.uint8),
    "dictionary of views": coded(pa.array(TEXTS, pa.string_view()), pa.uint32), "runs": pc.run_end_encode(pa.array(TRACKS)),
    "runs of texts": runs(pa.array(TEXTS)), "runs of dictionaries": runs(pa.array(TEXTS).dictionary_encode()),
}
TIMES = {
    **{str(kind): pa.array(KEYS["t"].to_pylist(), kind) for kind in (pa.float32(), pa.float64())},
    "decimal": pa.array(map(decimal.Decimal, KEYS["t"].to_pylist()), pa.decimal128(20, 3)),
    "dictionary": coded(KEYS["t"].combine_chunks()), "runs": runs(KEYS["t"].combine_chunks()),
}
STAMPS = {
    **{str(kind): MILLISECONDS.cast(pa.timestamp("ms")).cast(kind) for kind in (pa.timestamp("ms"), pa.timestamp("us"), pa.timestamp("ns"))},
    "zoned": MILLISECONDS.cast(pa.timestamp("ms", "Europe/Zurich")), "duration[ms]": MILLISECONDS.cast(pa.duration("ms")),
    "duration[ns]": MILLISECONDS.cast(pa.duration("ms")).cast(pa.duration("ns")), "dictionary of stamps": coded(MILLISECONDS.cast(pa.timestamp("ms"))),
    "runs of stamps": runs(MILLISECONDS.cast(pa.timestamp("ms"))),
}
NUMBERS = {
    **{str(kind): kind for kind in (pa.float64(), pa.decimal128(20, 17))}, "dictionary": coded, "runs": runs,
}


@pytest.mark.parametrize("name", IDS)
def test_ids(name):
    found = expect(KEYS.set_column(0, "track", IDS[name]), ["track"])
    ids = found["track"].unique().to_pylist()
    assert len(ids) == 2 and set(ids) == set(IDS[name].to_pylist())


@pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
@pytest.mark.parametrize("name", TIMES)
def test_times(name):
    expect(KEYS.set_column(1, "t", TIMES[name]))


@pytest.mark.parametrize("name", STAMPS)
def test_stamps(name):
    found = expect(KEYS.set_column(1, "t", STAMPS[name]), ["t"])
    assert np.array_equal(found["t"].combine_chunks().cast(pa.int64()).to_numpy() / ori._stamps.PER_SECOND[found.schema.field("t").type.unit],
                          samples_of_keys()["t"].to_numpy().round(3))


@pytest.mark.parametrize("kind", [pa.date32(), pa.date64()], ids=str)
def test_dates(kind):
    """They become stamps, since there is no date between two days."""
    table = KEYS.set_column(1, "t", pa.array(EIGHTHS.tolist() * 2, pa.date32()).cast(kind))
    with pytest.warns(ori.ShapeWarning, match=rf"^the column 't' of the result is timestamp\[s\], that of the keys {kind}".replace("[day]", r"\[day\]")
                      .replace("[ms]", r"\[ms\]")):
        found = tables.resample(table, rate="1/43200").read_all()
    expected = ori.Curve(EIGHTHS * 86400.0, Q).sample(rate="1/43200")
    assert np.array_equal(columns(found, QUATERNION)[:len(expected)], expected.orientations)
    assert found["t"][1].as_py() == datetime.datetime(1970, 1, 1, 12)


@pytest.mark.parametrize("name", NUMBERS)
def test_numbers(name):
    kind, table = NUMBERS[name], KEYS.set_column(2, "qx", pa.array([0] * KEYS.num_rows, pa.uint16()))
    for k, column in enumerate(QUATERNION[1:]):
        values = KEYS[column].combine_chunks()
        table = table.set_column(3 + k, column, kind(values) if callable(kind) else pa.array([decimal.Decimal(f"{x:.17f}") for x in values.to_pylist()], kind)
                                 if pa.types.is_decimal(kind) else values)
    expect(table, QUATERNION + ["wx", "wy", "wz"] if name.startswith("decimal") else [])


def parts(names, values, *, as_list):
    if as_list:
        return pa.FixedSizeListArray.from_arrays(pa.array(np.column_stack(values).ravel()), len(names))
    return pa.StructArray.from_arrays([pa.array(each) for each in values][::-1], names[::-1])


@pytest.mark.parametrize("form", ["list", "letters", "names"])
def test_quaternions_and_positions_in_one_column(form, tmp_path):
    table = KEYS.select(["track", "t"])
    for name, letters, values in (("q", "xyzw", [KEYS[name].to_numpy() for name in QUATERNION]), ("p", "xyz", [KEYS["t"].to_numpy() * k for k in range(3)])):
        names = [name + letter if form == "names" else letter for letter in letters]
        table = table.append_column(name, parts(names, values, as_list=form == "list"))
    found = expect(table, quaternion="q", position=["p"])
    assert found.column_names[:9] == ["track", "t", *QUATERNION, "px", "py", "pz"]
    assert np.allclose(found["pz"].to_numpy(), 2 * found["t"].to_numpy())
    import pyarrow.parquet as pq
    pq.write_table(table, tmp_path / "keys.parquet")
    expect(pq.read_table(tmp_path / "keys.parquet"), quaternion="q")
    assert tables.resample(tmp_path / "keys.parquet", quaternion="q", position="p", rate=10).read_all().equals(found)
    beside = tables.evaluate(table, KEYS.select(["track", "t"]), quaternion="q").read_all()
    assert np.allclose(columns(beside, QUATERNION), columns(KEYS, QUATERNION), rtol=0, atol=1e-15)


@pytest.mark.parametrize("lazy", [False, True])
@pytest.mark.parametrize("kind", ["String", "Categorical", "Enum", "Binary", "Int16", "Date", "Time", "Decimal"])
def test_frames_of_polars(kind, lazy):
    import polars
    frame = polars.from_arrow(KEYS)
    values = {"Binary": [text.encode() for text in TEXTS], "Int16": TRACKS, "Date": [datetime.date(2026, 1, 1 + track) for track in TRACKS],
              "Time": [datetime.time(track) for track in TRACKS], "Decimal": [decimal.Decimal(track) for track in TRACKS]}.get(kind, TEXTS)
    ids = polars.Series("track", values, dtype=polars.Enum(["t0", "t1"]) if kind == "Enum" else getattr(polars, kind))
    frame = frame.with_columns(ids, (polars.col("t") * 1e6).cast(polars.Duration("us")))
    expected = samples_of_keys()
    found = tables.resample(frame.lazy() if lazy else frame, rate=10)
    assert isinstance(found, polars.LazyFrame if lazy else polars.DataFrame)
    found = found.lazy().collect()
    assert np.array_equal(found[QUATERNION].to_numpy(), columns(expected, QUATERNION)) and found.schema["t"] == polars.Duration("us")
    assert found["track"].unique(maintain_order=True).to_list() == list(dict.fromkeys(values)) and found.schema["track"] == frame.schema["track"]


REFUSED = [
    ("track", pa.array([[track] for track in TRACKS]), "wanted ids that can be put in order"), ("track", pa.nulls(len(TRACKS)), "wanted ids"),
    ("track", pa.array([{"a": track} for track in TRACKS]), "wanted ids"), ("track", pa.array(np.array(TRACKS, np.float16)), "wanted ids"),
    ("track", pa.array([(0, track, 0) for track in TRACKS], pa.month_day_nano_interval()), "wanted ids"),
    ("track", decimals(pa.decimal256(50, 2)), "wanted ids"),
    ("t", MILLISECONDS, "wanted float seconds, timestamps, dates or durations"), ("t", pa.array(TEXTS), "wanted float seconds"),
    ("t", pc.run_end_encode(MILLISECONDS), "cast it to float64 if it counts seconds"), ("t", pa.array(TRACKS, pa.time32("s")), "wanted float seconds"),
    ("t", pa.array(np.array(TRACKS, np.float16)), "wanted float seconds"),
    ("qx", pa.array(TEXTS), "wanted numbers"), ("qx", pa.array(TRACKS).cast(pa.bool_()), "wanted numbers"), ("qx", pa.nulls(len(TRACKS)), "wanted numbers"),
    ("qx", pa.array([[0.0]] * len(TRACKS)), "wanted numbers"), ("qx", coded(pa.array(TEXTS)), "wanted numbers"),
]


@pytest.mark.parametrize(("name", "column", "wanted"), REFUSED, ids=[f"{name} {column.type}" for name, column, _ in REFUSED])
def test_types_that_are_refused(name, column, wanted):
    table = KEYS.set_column(KEYS.schema.get_field_index(name), name, column)
    for form in forms(table):
        with pytest.raises(ori.ArgumentError) as error:
            tables.resample(form)
        assert str(error.value).startswith(f"source: found {column.type} in the column {name!r}, ") and wanted in str(error.value)


def test_one_column_that_is_no_quaternion():
    four = pa.array([[0.0, 0.0, 0.0, 1.0]] * len(TRACKS))
    for column in (four, pa.array([[0.0, 0.0, 1.0]] * len(TRACKS), pa.list_(pa.float64(), 3)), pa.array([{"x": 0.0, "y": 0.0, "z": 1.0}] * len(TRACKS)),
                   pa.array(TRACKS)):
        with pytest.raises(ori.ArgumentError) as error:
            tables.resample(KEYS.append_column("q", column), quaternion="q")
        assert str(error.value).startswith(f"source: found {column.type} in the column 'q', wanted a struct of x, y, z, w, a fixed-size list of 4 numbers")


def test_columns_that_are_none_of_arrow():
    polars, pandas = pytest.importorskip("polars"), pytest.importorskip("pandas")
    frame = polars.from_arrow(KEYS)
    with pytest.raises(ori.ArgumentError, match="found a ChunkedArray that is no table .*, wanted named columns"):
        tables.resample(pa.chunked_array([TRACKS]))
    with pytest.raises(ori.ArgumentError, match=r"found a data frame that is no table \(complex128 in the column 'qx': "):
        tables.resample(pandas.DataFrame({"track": TRACKS, "qx": np.array(TRACKS) * 1j}))
    if hasattr(polars, "Int128"):
        with pytest.raises(ori.ArgumentError, match=r"found a data frame that is no table \(Int128 in the column 'track': "):
            tables.resample(frame.with_columns(polars.col("track").cast(polars.Int128)).lazy())


def test_other_columns_of_the_other_table_come_back():
    at = KEYS.select(["track", "t"])
    beside = {"view": pa.array(TEXTS, pa.string_view()), "dictionary": coded(pa.array(TEXTS)), "runs": runs(pa.array(TRACKS)), "null": pa.nulls(len(TRACKS)),
              "list": pa.array([[track] for track in TRACKS]), "struct": pa.array([{"a": track} for track in TRACKS])}
    for name, column in beside.items():
        at = at.append_column(name, column)
    for keys, form in ((KEYS, at), (KEYS.to_reader(), at.to_reader())):
        found = tables.evaluate(keys, form).read_all()
        assert all(found[name].to_pylist() == column.to_pylist() for name, column in beside.items()) and found["error"].null_count == len(TRACKS)
