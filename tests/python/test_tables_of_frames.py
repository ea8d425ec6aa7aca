# SPDX-License-Identifier: Apache-2.0
"""A frame goes in and comes out of its own kind, as it was but for what the work is."""
import io
import sys

import numpy as np
import orispline as ori
import pytest
from track_data import QUATERNION, shuffled, table_like, table_of, tracks

pa = pytest.importorskip("pyarrow")
pandas, polars = pytest.importorskip("pandas"), pytest.importorskip("polars")
pytest.importorskip("duckdb")
import pyarrow.parquet as pq  # noqa: E402
from orispline import tables  # noqa: E402
from orispline.tables import _progress  # noqa: E402

KEYS = shuffled(table_of(tracks(8, least=9, most=20))).rename_columns(["id", "t", *QUATERNION])
FRAME = KEYS.to_pandas()
ZONED = FRAME.assign(t=pandas.to_datetime(FRAME["t"], unit="s").dt.round("ms").dt.tz_localize("Europe/Zurich"))
JOBS = {"resample": lambda source: tables.resample(source, by="id", rate=20), "smooth": lambda source: tables.smooth(source, by="id", smoothing_time=0.1),
        "reduce": lambda source: tables.reduce(source, "1deg", by="id"), "mean": lambda source: tables.mean(source, by="id"),
        "mean of windows": lambda source: tables.mean(source, by="id", every="1s"),
        "compare": lambda source: tables.compare(source, ["slerp"], by="id", keep_every=4),
        "evaluate": lambda source: tables.evaluate(KEYS, type(source)(AT) if not hasattr(source, "lazy") else polars.from_pandas(AT), by="id")}
AT = FRAME[["id", "t"]].assign(t=FRAME["t"] + 0.01, what=np.arange(len(FRAME)))
KINDS = {"pandas": (FRAME, pandas.DataFrame), "polars": (polars.from_arrow(KEYS), polars.DataFrame), "lazy": (polars.from_arrow(KEYS).lazy(), polars.LazyFrame),
         "table": (KEYS, pa.RecordBatchReader), "reader": (None, pa.RecordBatchReader)}


@pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("job", [job for job in JOBS if job != "evaluate"])
def test_what_comes_out_is_of_the_kind_that_went_in(job, kind):
    source, wanted = KINDS[kind]
    expected = JOBS[job](KEYS).read_all()
    found = JOBS[job](KEYS.to_reader() if source is None else source)
    assert isinstance(found, wanted) and table_like(found, expected).equals(expected)


def test_frames_are_piped():
    expected = tables.resample(KEYS, by="id", rate=100).read_all()
    for frame in (FRAME, polars.from_arrow(KEYS), polars.from_arrow(KEYS).lazy()):
        assert table_like(frame.pipe(ori.tables.resample, by="id", rate="100 Hz"), expected).equals(expected)
    groups = polars.from_arrow(KEYS).group_by("id").map_groups(lambda group: tables.resample(group, by="id", rate=100))
    assert groups.sort("id", "t").to_arrow().cast(expected.schema).equals(expected)


def test_a_lazy_frame_is_made_when_it_is_collected():
    asked = []

    def watched(frame):
        asked.append(len(frame))
        return frame

    given = polars.from_arrow(KEYS).lazy()
    found = tables.resample(given.map_batches(watched, schema=given.collect_schema()), by="id", rate=20)
    assert not asked and found.collect_schema()["wx"] == polars.Float64
    some = found.filter(polars.col("id") == 3).select("t", "wx").head(5).collect()
    whole = tables.resample(given.collect(), by="id", rate=20)
    assert asked and some.equals(whole.filter(polars.col("id") == 3).select("t", "wx").head(5))
    twice = given.select(polars.all().repeat_by(2).explode())
    assert tables.resample(twice, by="id", errors="row").collect()["error"].is_not_null().all()
    with pytest.raises((ori.DataError, polars.exceptions.ComputeError), match="duplicate time"):
        tables.resample(twice, by="id", errors="raise").collect()


@pytest.mark.parametrize(("levels", "names"), [(["t"], ["t"]), (["id"], ["id"]), (["id", "t"], ["id", "t"]), (["t", "id"], ["t", "id"]), (["t"], [None])])
def test_an_index_of_pandas_stays_the_index(levels, names):
    given = FRAME.set_index(levels).rename_axis(index=names)
    given.attrs["made by"] = ["us"]
    found, expected = tables.resample(given, by="id", rate=20), tables.resample(FRAME, by="id", rate=20)
    assert list(found.index.names) == names and found.attrs == {"made by": ["us"]} and found.attrs["made by"] is not given.attrs["made by"]
    pandas.testing.assert_frame_equal(found.rename_axis(index=levels).reset_index()[list(expected.columns)], expected)
    assert given.attrs == {"made by": ["us"]} and list(given.columns) == [name for name in FRAME.columns if name not in levels]


@pytest.mark.parametrize("unit", ["ms", "us", "ns"])
def test_time_zones_of_pandas_stay(unit):
    if not hasattr(ZONED["t"].dt, "unit"):
        pytest.skip("found pandas before 2, whose stamps are all in nanoseconds")
    given = ZONED.assign(t=ZONED["t"].dt.as_unit(unit))
    for frame in (given, given.set_index("t")):
        found = tables.resample(frame, by="id", rate=20).reset_index()
        assert str(found["t"].dt.tz) == "Europe/Zurich" and found["t"].dtype == given["t"].dtype
    assert found["t"].min() == given["t"].min()


@pytest.mark.parametrize("kind", ["category", "string", "string[pyarrow]", "Int16", "int64[pyarrow]", "int8"])
def test_types_of_ids_stay(kind):
    given = FRAME.assign(id=FRAME["id"].astype(str).astype(kind) if "str" in kind else FRAME["id"].astype(kind))
    found = tables.resample(given, by="id", rate=20)
    assert found["id"].dtype == given["id"].dtype and len(found) == len(tables.resample(FRAME, by="id", rate=20))


@pytest.mark.parametrize("backend", ["numpy_nullable", "pyarrow"])
def test_new_columns_are_of_the_types_of_the_frame(backend):
    if not hasattr(pandas, "ArrowDtype") or "dtype_backend" not in pandas.DataFrame.convert_dtypes.__code__.co_varnames:
        pytest.skip("found pandas before 2")
    given = FRAME.convert_dtypes(dtype_backend=backend)
    stamps = pandas.to_datetime(FRAME["t"], unit="s").dt.as_unit("ms").astype("timestamp[ms][pyarrow]")
    dated = tables.resample(FRAME.assign(t=stamps), by="id", rate=20)
    assert str(dated["t"].dtype) == "timestamp[ms][pyarrow]" and dated["wx"].dtype == float
    found = tables.resample(given, by="id", rate=20)
    assert {str(found[name].dtype) for name in ("t", *QUATERNION, "wx")} == {"Float64" if backend == "numpy_nullable" else "double[pyarrow]"}
    assert found["id"].dtype == given["id"].dtype and np.array_equal(found["wx"].astype(float), tables.resample(FRAME, by="id", rate=20)["wx"])


def test_the_other_table_comes_back_as_it_was():
    at = pandas.DataFrame({"what": [object(), 2, "x"], "t": FRAME["t"][[0, 1, 2]].to_numpy() + [0.0, 1e9, 0.0], "id": FRAME["id"][[0, 1, 2]].to_numpy()},
                          index=pandas.Index([7, 5, 6], name="row"))
    at.attrs["made by"] = "us"
    found = tables.evaluate(FRAME, at, by="id")
    pandas.testing.assert_frame_equal(found[["what", "t", "id"]], at)
    assert found.attrs == at.attrs and list(found.columns) == ["what", "t", "id", *QUATERNION, "error"]
    assert found["error"].notna().tolist() == [False, True, False] and np.allclose(found[QUATERNION].loc[7], FRAME[QUATERNION].iloc[0])
    assert tables.evaluate(FRAME.set_index("t"), at, by="id").equals(found)
    kept = tables.evaluate(KEYS, at.set_index("t"), by="id", errors="drop")
    assert kept.index.name == "t" and len(kept) == 2 and "t" not in kept.columns
    for frame in (polars.from_pandas(AT), polars.from_pandas(AT).lazy()):
        both = tables.evaluate(FRAME, frame, by="id", derivatives=1)
        assert isinstance(both, type(frame)) and both.lazy().collect()[AT.columns.to_list()].equals(polars.from_pandas(AT))
    asked = []
    keys = polars.from_arrow(KEYS).lazy()
    watched = keys.map_batches(lambda frame: asked.append(len(frame)) or frame, schema=keys.collect_schema())
    both = tables.evaluate(watched, polars.from_pandas(AT).lazy(), by="id")
    assert not asked and len(both.collect()) == len(AT) and asked == [len(FRAME)]
    twice = at.set_axis([1, 1, 1])
    assert tables.evaluate(FRAME, twice, by="id").index.tolist() == [1, 1, 1]
    expected = tables.evaluate(KEYS, pa.Table.from_pandas(AT, preserve_index=False), by="id", derivatives=1).read_all().sort_by("what").to_pandas()
    found = tables.evaluate(KEYS, AT, by="id", derivatives=1).sort_values("what", ignore_index=True)
    pandas.testing.assert_frame_equal(found, expected[[*AT.columns, *expected.columns[3:]]])
    with pytest.raises(ori.ArgumentError, match="at: found the column 'qx', which the result has too: leave it out"):
        tables.evaluate(FRAME, at.assign(qx=1), by="id")


def test_fields_of_arrow_keep_their_metadata(tmp_path):
    schema = pa.schema([field.with_metadata({"said": field.name}) for field in KEYS.schema], {"from": "a tracker", "pandas": "{}"})
    given = pa.Table.from_batches(KEYS.to_batches(), schema)
    for job in ("resample", "smooth", "mean of windows"):
        reader = JOBS[job](given)
        for found in (reader.schema, reader.read_all().schema):
            assert found.metadata == {b"from": b"a tracker"}
            assert all(field.metadata == ({b"said": field.name.encode()} if field.name in KEYS.column_names else None) for field in found)
    beside = tables.evaluate(KEYS, given.select(["id", "t"]).append_column(pa.field("range", pa.float64(), metadata={"unit": "m"}), KEYS["t"]), by="id").schema
    assert beside.field("range").metadata == {b"unit": b"m"} and beside.field("t").metadata == {b"said": b"t"}
    tables.write(JOBS["resample"](given), tmp_path / "motion.arrow")
    with pa.ipc.open_file(tmp_path / "motion.arrow") as file:
        assert file.schema.field("t").metadata == {b"said": b"t"}
    tables.write(JOBS["resample"](given), tmp_path / "motion.parquet")
    assert tables.resample(tmp_path / "motion.parquet", by="id").schema.metadata is None


@pytest.mark.parametrize("name", ["timestamp", "Time [s]", "stamp", "t_s", "datetime"])
def test_a_column_that_looks_like_the_time_is_named(name):
    for frame in (FRAME, polars.from_arrow(KEYS), polars.from_arrow(KEYS).lazy(), KEYS):
        other = frame.rename(columns={"t": name}) if frame is FRAME else frame.rename({"t": name}) if frame is not KEYS else \
            KEYS.rename_columns(["id", name, *QUATERNION])
        with pytest.raises(ori.ArgumentError, match="^source: found the columns .* wanted 't' once: name the columns by .*, such as time=") as found:
            tables.resample(other, by="id")
        assert str(found.value).endswith(f"such as time={name!r}")
    with pytest.raises(ori.ArgumentError, match="^at: found the columns 'id', .* wanted 't' once: .*, such as time="):
        tables.evaluate(KEYS, AT[["id", "t"]].rename(columns={"t": name}), by="id")


def test_times_of_which_some_only_have_a_zone_are_refused():
    first, second, naive = pandas.Timestamp("2026-01-01", tz="Europe/Zurich"), pandas.Timestamp("2026-01-01T12:00", tz="UTC"), pandas.Timestamp("2026-01-02")
    frame = pandas.DataFrame({"id": 1, "t": pandas.Series([first, second, naive], dtype=object), **dict(zip(QUATERNION, FRAME[QUATERNION].to_numpy()[:3].T))})
    for job in (lambda given: tables.resample(given, by="id"), lambda given: tables.evaluate(given, AT, by="id"),
                lambda given: tables.resample(given.set_index("t"), by="id")):
        with pytest.raises(ori.ArgumentError, match="the column 't': found dates with a time zone and dates without one, wanted a time zone for all"):
            job(frame)
    zoned = frame.assign(t=pandas.Series([first, second, naive.tz_localize("Asia/Tokyo")], dtype=object))
    assert tables.resample(zoned, by="id", rate="1/43200")["t"].max() == first + pandas.Timedelta("12h")
    with pytest.raises(ori.ArgumentError, match="wanted timestamps with a time zone in both tables or in neither"):
        tables.evaluate(ZONED, AT.assign(t=naive), by="id")
    periods = frame.assign(t=pandas.period_range("2026", periods=3))
    with pytest.raises(ori.ArgumentError, match="period.* in the column 't', wanted float seconds, timestamps, dates or durations"):
        tables.resample(periods, by="id")


def test_frames_are_written_too(tmp_path):
    for frame in (FRAME, polars.from_arrow(KEYS), polars.from_arrow(KEYS).lazy()):
        tables.write(tables.resample(frame, by="id", rate=20), tmp_path / "motion.parquet")
        expected = tables.resample(KEYS, by="id", rate=20).read_all()
        assert pq.read_table(tmp_path / "motion.parquet").cast(expected.schema).equals(expected)


@pytest.mark.parametrize("word", ["normalize", "normalise"])
@pytest.mark.parametrize("job", ["resample", "smooth", "evaluate", "mean"])
def test_quaternions_of_any_norm_are_taken(job, word):
    longer = FRAME.assign(**{name: FRAME[name] * (1 + np.arange(len(FRAME)) % 3) for name in QUATERNION})
    work = {"resample": lambda frame, **how: tables.resample(frame, by="id", rate=20, **how), "mean": lambda frame, **how: tables.mean(frame, by="id", **how),
            "smooth": lambda frame, **how: tables.smooth(frame, by="id", smoothing_time=0.1, **how),
            "evaluate": lambda frame, **how: tables.evaluate(frame, AT, by="id", **how)}[job]
    found, expected = work(longer, **{word: True}), work(FRAME)
    for name in QUATERNION:
        assert np.allclose(found[name].astype(float), expected[name].astype(float), atol=1e-12, equal_nan=True)
    refused = work(longer)["error"]
    assert refused.str.contains("norm").any()
    zeros = FRAME.assign(**dict.fromkeys(QUATERNION, 0.0))
    assert work(zeros, **{word: True})["error"].notna().all()


@pytest.mark.parametrize("word", ["--normalize", "--normalise"])
def test_the_command_takes_any_norm_too(word, tmp_path):
    from orispline.tables._command import main
    longer = FRAME.assign(**{name: 3 * FRAME[name] for name in QUATERNION})
    tables.write(longer, tmp_path / "keys.parquet")
    words = ["resample", str(tmp_path / "keys.parquet"), "--by", "id", "--rate", "20", "--quiet", "-o", str(tmp_path / "motion.parquet")]
    assert main([*words, word]) == 0
    found = pq.read_table(tmp_path / "motion.parquet").to_pandas()
    assert np.allclose(found[QUATERNION], tables.resample(FRAME, by="id", rate=20)[QUATERNION], atol=1e-12) and found["error"].isna().all()
    assert main(words) == 0 and pq.read_table(tmp_path / "motion.parquet")["error"].null_count == 0


class Told(list):
    """A bar of tqdm, as far as it is asked."""

    def __init__(self, total=None, **_):
        self.total, self.n = total, 0
        Told.last = self

    def update(self, count):
        self.n += count

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.append("closed")


def test_progress_is_shown_by_tqdm_or_by_a_bar_of_ours(monkeypatch):
    tqdm = type(sys)("tqdm.auto")
    tqdm.tqdm = Told
    monkeypatch.setitem(sys.modules, "tqdm", type(sys)("tqdm"))
    monkeypatch.setitem(sys.modules, "tqdm.auto", tqdm)
    tables.resample(FRAME, by="id", progress=True)
    assert Told.last.total == Told.last.n == len(FRAME) and Told.last == ["closed"]
    monkeypatch.setitem(sys.modules, "tqdm.auto", None)
    monkeypatch.setattr(_progress, "BETWEEN_SHOWS", 0.0)
    monkeypatch.setattr(sys, "stderr", io.StringIO())
    tables.resample(KEYS, by="id", progress=True).read_all()
    assert "100%" in sys.stderr.getvalue() and sys.stderr.getvalue().endswith("\r")
    shares = []
    tables.resample(FRAME, by="id", progress=shares.append)
    assert shares[-1] == 1.0 and sorted(shares) == shares
    tables.resample(FRAME, by="id", progress=False)
    for wrong in (3, "yes", [1]):
        with pytest.raises(TypeError, match="progress: found .* wanted True for a bar, or a function"):
            tables.resample(FRAME, by="id", progress=wrong)


def test_an_empty_frame_has_no_tracks():
    """pandas says of a column of texts without rows only that it has objects."""
    empty = FRAME.assign(id=FRAME["id"].astype(str).astype(object))[:0]
    assert empty["id"].dtype == object
    for job, more in (("resample", {"rate": 10}), ("smooth", {}), ("mean", {}), ("reduce", {"tolerance": 0.1})):
        found = getattr(tables, job)(empty, by="id", **more)
        assert isinstance(found, pandas.DataFrame) and not len(found) and {"id", "qw", "error"} <= set(found.columns)
    assert not len(tables.evaluate(FRAME, empty[["id", "t"]], by="id"))
