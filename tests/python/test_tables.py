# SPDX-License-Identifier: Apache-2.0
"""Tables resampled: every track has the samples of its own curve, wherever the rows come from."""
import decimal
import pathlib

import numpy as np
import orispline as ori
import pytest
from track_data import QUATERNION, RATES, columns, expect_samples_of_curves, rows_of, shuffled, table_like, table_of, tracks

pa = pytest.importorskip("pyarrow")
pytest.importorskip("duckdb")
import pyarrow.dataset as ds  # noqa: E402
import pyarrow.parquet as pq  # noqa: E402
from orispline import tables  # noqa: E402
from orispline.tables import _tracks  # noqa: E402


@pytest.fixture(scope="module")
def made():
    return tracks(300)


@pytest.fixture(scope="module")
def keys(made):
    return shuffled(table_of(made))


@pytest.mark.parametrize("threads", [1, 3])
@pytest.mark.parametrize(("method", "derivatives", "rate"), [("auto", 1, 100), ("timed-c2", 3, "30000/1001"), ("rotation-spline", 2, 7.5)])
def test_each_track_has_the_samples_of_its_curve(made, keys, method, derivatives, rate, threads):
    reader = tables.resample(keys, method=method, derivatives=derivatives, rate=rate, threads=threads)
    expect_samples_of_curves(reader.read_all(), made, rate=rate, derivatives=derivatives, method=method)


def parts(table, rows):
    return pa.RecordBatchReader.from_batches(table.schema, iter(table.to_batches(max_chunksize=rows)))


def test_it_does_not_matter_where_the_rows_come_from(made, keys, tmp_path):
    import pandas
    import polars
    expected = tables.resample(keys).read_all()
    pq.write_table(keys.slice(0, 4000), tmp_path / "a.parquet")
    pq.write_table(keys.slice(4000), tmp_path / "b.parquet", row_group_size=1000)
    sources = [str(tmp_path), tmp_path / "a.parquet", str(tmp_path / "*.parquet"), ds.dataset(tmp_path), parts(keys, 173),
               keys.to_batches(), keys.to_pandas(), polars.from_arrow(keys)]
    sources[1] = [tmp_path / "b.parquet", str(tmp_path / "a.parquet")]
    sources[5] = keys.combine_chunks().to_batches()[0]
    assert isinstance(sources[6], pandas.DataFrame)
    for source in sources:
        found = tables.resample(source)
        assert table_like(found, expected).equals(expected), type(source)


def test_rows_in_order_pass_as_they_are(made):
    table = table_of(made)
    expected = tables.resample(table).read_all()
    for rows in (1, 17, 4096):
        assert tables.resample(parts(table, rows), assume_sorted=True).read_all().equals(expected)


@pytest.mark.parametrize("rows", [50, 1000])
@pytest.mark.parametrize("method", ["auto", "rotation-spline", "slerp"])
def test_a_long_track_comes_in_pieces_with_the_same_bits(monkeypatch, rows, method):
    made = tracks(12, least=1, most=3000)
    monkeypatch.setattr(_tracks, "LONGEST_WHOLE_TRACK", 400)
    monkeypatch.setattr(_tracks.tracks_in, "__defaults__", (400,))
    reader = tables.resample(parts(table_of(made), rows), assume_sorted=True, rate=20, method=method)
    expect_samples_of_curves(reader.read_all(), made, rate=20, method=method)


@pytest.mark.parametrize("unit", ["s", "ms", "us", "ns"])
@pytest.mark.parametrize("zone", [None, "UTC", "Europe/Zurich"])
def test_timestamps_stay_what_they_are(unit, zone):
    stamps = np.datetime64("2026-02-03T04:05:06", unit) + np.arange(5) * np.timedelta64(2, "s") // np.timedelta64(1, unit)
    half = np.linspace(0, 1, 5)
    q = np.column_stack([0 * half, 0 * half, np.sin(half), np.cos(half)])
    kind = pa.timestamp(unit, zone)
    table = pa.table({"track": ["a"] * 5, "t": pa.array(stamps).cast(pa.int64()).cast(kind), **dict(zip(QUATERNION, q.T))})
    found = tables.resample(table, rate=1).read_all()
    expected = ori.Curve(stamps, q).sample(rate=1, derivatives=1)
    assert found.schema.field("t").type == kind
    assert np.array_equal(found["t"].cast(pa.int64()).to_numpy(), expected.times.astype(f"datetime64[{unit}]").astype(np.int64))
    assert np.array_equal(columns(found, QUATERNION), expected.orientations)
    reader = pa.RecordBatchReader.from_batches(table.schema, iter(table.to_batches()))
    assert tables.resample(reader, rate=1).read_all().equals(found), "by way of DuckDB"


@pytest.mark.parametrize("rate", [10, 12.5, "30000/1001"])
def test_aligned_tracks_share_their_times(made, keys, rate):
    numerator, denominator = (30000, 1001) if isinstance(rate, str) else (rate, 1)
    found = tables.resample(keys, rate=rate, align="epoch").read_all()
    t = found["t"].to_numpy()
    k = np.round(t * numerator / denominator)
    assert np.array_equal(t, k * denominator / numerator)
    track = rows_of(found, 17)
    times, q = made[17]
    assert times[0] <= track["t"][0].as_py() < times[0] + denominator / numerator
    assert np.array_equal(columns(track, QUATERNION), ori.Curve(times, q)(track["t"].to_numpy()))


def test_aligned_timestamps_are_multiples_since_1970():
    stamps = np.datetime64("2026-02-03T04:05:06.123456", "us") + np.array([0, 400_000, 900_000, 1_700_000])
    half = np.linspace(0, 1, 4)
    table = pa.table({"track": [1] * 4, "t": stamps, "qx": 0 * half, "qy": 0 * half, "qz": np.sin(half), "qw": np.cos(half)})
    t = tables.resample(table, rate="30", align="epoch").read_all()["t"].to_numpy().astype(np.int64)
    k = np.round(t * 30 / 1e6).astype(np.int64)
    assert np.array_equal(t, np.round(k % 30 * 1e6 / 30).astype(np.int64) + k // 30 * 10**6) and np.array_equal(np.diff(k), np.ones(len(k) - 1))
    assert stamps[0] <= t[0].astype("datetime64[us]") < stamps[0] + 33334 and len(t) == 51


@pytest.mark.parametrize("kind", [pa.string(), pa.large_string(), pa.int8(), pa.float64(), pa.dictionary(pa.int32(), pa.string()),
                                  pa.decimal128(10, 2), pa.timestamp("ns", "UTC"), pa.binary(), pa.date32()])
def test_ids_are_of_any_type(kind):
    made = tracks(20)
    strings = [f"{track:02}" for track in made]
    values = strings if pa.types.is_dictionary(kind) or kind in (pa.string(), pa.large_string()) else \
        [text.encode() for text in strings] if kind == pa.binary() else [decimal.Decimal(k) for k in made] if "decimal" in str(kind) \
        else list(made)
    table = table_of(made)
    ids = pa.array([values[k] for k in table["track"].to_pylist()])
    ids = ids.cast(pa.int32()).cast(kind) if kind == pa.date32() else ids.cast(kind)
    with_ids = table.set_column(0, "track", ids)
    found = [tables.resample(shuffled(with_ids)).read_all(), tables.resample(parts(shuffled(with_ids), 100)).read_all()]
    expected = tables.resample(table).read_all()
    for each in found:
        assert each.drop_columns("track").equals(expected.drop_columns("track"))
        assert each.schema.field("track").type == (kind.value_type if pa.types.is_dictionary(kind) else kind)


def test_several_columns_tell_tracks_apart(made):
    table = table_of(made)
    number = table["track"].to_numpy()
    two = table.drop_columns("track").append_column("day", pa.array([f"day{k // 7}" for k in number])).append_column("run", pa.array(number % 7))
    found = tables.resample(shuffled(two), by=["day", "run"]).read_all()
    assert found.column_names[:3] == ["day", "run", "t"]
    order = sorted({(f"day{k // 7}", k % 7) for k in made})
    expected = [ori.Curve(*made[int(day[3:]) * 7 + run]).sample(rate=100).orientations for day, run in order]
    assert np.array_equal(columns(found, QUATERNION), np.concatenate(expected))


def test_positions_and_the_world_frame(made):
    times, q = made[3]
    p = np.column_stack([np.sin(times), times, times**2])
    table = table_of({3: made[3]})
    for k, name in enumerate("xyz"):
        table = table.append_column(name, pa.array(p[:, k]))
    found = tables.resample(table, position=["x", "y", "z"], derivatives=3, frame="world", rate=50).read_all()
    expected = ori.Curve(times, q, positions=p).sample(rate=50, derivatives=3, frame="world")
    names = [f"{letter}{axis}_world" for letter in "waj" for axis in "xyz"]
    assert found.column_names == ["track", "t", *QUATERNION, "x", "y", "z", *names, "vx", "vy", "vz", "apx", "apy", "apz", "error"]
    rows = [expected.orientations, expected.positions, expected.angular_velocities, expected.angular_accelerations,
            expected.angular_jerks, expected.velocities, expected.accelerations]
    assert np.array_equal(columns(found, found.column_names[2:-1]), np.hstack(rows))


def test_a_gap_is_left_empty(made):
    times, q = made[5]
    later = times + np.where(np.arange(len(times)) >= 4, 30.0, 0.0)
    found = tables.resample(table_of({5: (later, q)}), gap=10, rate=50).read_all()
    t = found["t"].to_numpy()
    assert not ((t > later[3]) & (t < later[4])).any()
    assert np.array_equal(columns(found, QUATERNION)[t <= later[3]], ori.Curve(times[:4], q[:4])(t[t <= later[3]]))


def test_settings_go_to_the_method(made):
    times, q = made[9]
    found = tables.resample(table_of({9: (times, q)}), method="quintic", tension=0.6, ends="natural", rate=30).read_all()
    assert np.array_equal(columns(found, QUATERNION), ori.Curve(times, q, "quintic", tension=0.6, ends="natural").sample(rate=30).orientations)


def test_progress_goes_to_one(keys):
    shares = []
    tables.resample(keys, progress=shares.append).read_all()
    assert shares == sorted(shares) and shares[-1] == 1.0
    counts = []
    tables.resample(parts(keys, 1000), progress=counts.append).read_all()
    assert counts[-1] == keys.num_rows


def test_evaluation_keeps_the_rows_of_the_other_table(made, keys):
    dice = np.random.default_rng(5)
    track = dice.integers(0, 310, 5000)  # ten have no keys
    t = dice.uniform(0, 60, 5000)
    at = pa.table({"track": track, "t": t, "number": np.arange(5000), "word": [str(k) for k in range(5000)]})
    found = tables.evaluate(keys, at, derivatives=2).read_all().sort_by("number")
    assert found["number"].to_pylist() == list(range(5000)) and found["word"].to_pylist() == at["word"].to_pylist()
    assert np.array_equal(found["t"].to_numpy(), t) and np.array_equal(found["track"].to_numpy(), track)
    q, errors = columns(found, QUATERNION), found["error"].to_pylist()
    for k in range(5000):
        inside = track[k] in made and made[track[k]][0][0] <= t[k] <= made[track[k]][0][-1]
        assert inside == (errors[k] is None) == (not np.isnan(q[k, 0]))
        if inside and k % 20 == 0:
            curve = ori.Curve(*made[track[k]])
            assert np.array_equal(q[k], curve.sample(times=[t[k]], derivatives=2).orientations[0])
    held = tables.evaluate(keys, at, extrapolate="hold", errors="drop").read_all()
    assert held.num_rows == (track < 300).sum() and held["error"].null_count == held.num_rows


def test_stamps_of_centuries_apart_are_not_wrapped():
    """Nanoseconds in 64 bits reach 292 years: a difference of more was one of the other sign."""
    def keys_at(*dates):
        return pa.table({"track": ["a"] * 3, "t": pa.array(np.array(dates, "datetime64[ns]")), "qx": [0.0] * 3, "qy": [0.0] * 3,
                         "qz": [0.0, 0.6, 1.0], "qw": [1.0, 0.8, 0.0]})
    late = pa.table({"track": ["a"], "t": pa.array(np.array(["2250-01-01"], "datetime64[ns]"))})
    end, = tables.evaluate(keys_at("1700", "1701", "1702"), late, method="slerp", extrapolate="hold").read_all().to_pylist()
    assert (end["qz"], end["error"]) == (pytest.approx(1.0), None)
    middle, = tables.evaluate(keys_at("1700", "2250", "2260"), late, method="slerp").read_all().to_pylist()
    assert (middle["qz"], middle["error"]) == (pytest.approx(0.6, abs=1e-6), None)


def test_evaluation_of_timestamps_of_another_unit():
    stamps = np.datetime64("2026-02-03T04:05:06", "ms") + np.arange(4) * 1000
    half = np.linspace(0, 1, 4)
    q = np.column_stack([0 * half, 0 * half, np.sin(half), np.cos(half)])
    keys = pa.table({"track": [1] * 4, "t": stamps, **dict(zip(QUATERNION, q.T))})
    at = np.datetime64("2026-02-03T04:05:07.123456789", "ns") + np.arange(3)
    found = tables.evaluate(keys, pa.table({"track": [1] * 3, "t": at})).read_all()
    assert np.array_equal(found["t"].to_numpy(), at)
    assert np.array_equal(columns(found, QUATERNION), ori.Curve(stamps, q)(at))


def test_smoothing_reduction_and_comparison_are_those_of_each_track():
    made = tracks(6, least=30, most=60, seed=2)
    keys = shuffled(table_of(made))
    smooth = tables.smooth(keys, smoothing_time=0.2).read_all()
    reduced = tables.reduce(keys, "2deg").read_all()
    with_rates = tables.reduce(keys, "2deg", method="hermite-c1").read_all()
    compared = tables.compare(keys, ["slerp", "auto"], keep_every=4).read_all()
    even = tables.smooth(keys, smoothing_time=0.2, rate=20, derivatives=0).read_all()
    for track, (times, q) in made.items():
        own = ori.Keys(times, q)
        smoothing = ori.smooth(own, smoothing_time=0.2)
        assert np.array_equal(columns(rows_of(smooth, track), QUATERNION), smoothing.curve.sample(times=times, derivatives=1).orientations)
        assert np.array_equal(rows_of(smooth, track)["wz"].to_numpy(), smoothing.curve.sample(times=times, derivatives=1).angular_velocities[:, 2])
        assert np.array_equal(columns(rows_of(even, track), QUATERNION), smoothing.curve.sample(rate=20).orientations)
        reduction = ori.reduce(own, "2deg")
        here = rows_of(reduced, track)
        assert np.array_equal(here["t"].to_numpy(), reduction.keys.times) and set(here["method"].to_pylist()) == {reduction.method}
        assert np.array_equal(columns(here, QUATERNION), reduction.keys.rotations)
        kept, here = ori.reduce(own, "2deg", method="hermite-c1").keys, rows_of(with_rates, track)
        assert np.array_equal(columns(here, QUATERNION), kept.rotations) and np.array_equal(columns(here, RATES[:3]), kept.angular_velocities)
        for row, expected in zip(rows_of(compared, track).to_pylist(), ori.compare(own, ["slerp", "auto"], keep_every=4).table(), strict=True):
            assert {name: row[name] for name in row if name != "track"} == {name: expected[name] for name in row if name != "track"}


def test_keys_without_rates_have_none_beside_those_of_a_method_that_seeks_them():
    made = tracks(3, least=30, most=60, seed=5)
    made[9] = np.arange(40.0), np.column_stack([np.zeros((40, 3)), np.ones(40)])  # at rest: two keys of either method
    found = tables.reduce(shuffled(table_of(made)), "2deg", method=["slerp", "hermite-c1"]).read_all()
    assert set(found["method"].to_pylist()) == {"slerp", "hermite-c1"}
    for row in found.to_pylist():
        assert [row[name] is None for name in RATES[:3]] == [row["method"] == "slerp"] * 3


def test_warnings_come_once_with_the_number_of_tracks():
    times = np.linspace(0, 6, 601)
    half = np.sin(times)
    q = np.column_stack([0 * half, 0 * half, np.sin(half), np.cos(half)])
    keys = table_of({track: (times, q) for track in range(5)})
    with pytest.warns(ori.ShapeWarning) as found:
        tables.smooth(keys).read_all()
    assert len(found) == 1 and str(found[0].message).startswith("track 0 and 4 more: ") and found[0].filename == __file__


def test_the_folder_of_temporary_files_is_left_empty(keys, tmp_path, monkeypatch):
    import tempfile
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    reader = tables.resample(parts(keys, 1000), memory_limit="100MB")
    reader.read_next_batch()
    reader.close()
    del reader
    assert not list(pathlib.Path(tmp_path).iterdir())
