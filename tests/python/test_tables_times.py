# SPDX-License-Identifier: Apache-2.0
"""Times of tables that are too far away: for the type of the other table, for the number of samples, for the difference of two."""
import datetime
import fractions
import re
import warnings

import numpy as np
import orispline as ori
import pytest
from track_data import QUATERNION, columns, table_of, tracks

pa = pytest.importorskip("pyarrow")
pytest.importorskip("duckdb")
import pyarrow.parquet as pq  # noqa: E402
from orispline import tables  # noqa: E402
from orispline.tables import _tracks  # noqa: E402

FAR = datetime.datetime(2584, 1, 1)  # nanoseconds reach to 2262
NOW = datetime.datetime(2026, 3, 1)


def keys_at(times, kind, track=1):
    half = np.linspace(0, 0.5, len(times))
    q = [0 * half, 0 * half, np.sin(half), np.cos(half)]
    return pa.table({"track": [track] * len(times), "t": pa.array(times, kind), **dict(zip(QUATERNION, q))})


def at(times, kind):
    return pa.table({"track": [1] * len(times), "t": pa.array(times, kind)})


def test_a_time_without_room_in_the_type_of_the_other_table_is_named():
    seconds = [NOW + datetime.timedelta(seconds=k) for k in range(3)]
    wanted = ("found 2584-01-01 00:00:00 in row 2 of the column 't', wanted what timestamp[ns] has room for, which is its type elsewhere: "
              "cast both columns")
    with pytest.raises(ori.DataError, match="^at: " + re.escape(wanted)):
        tables.evaluate(keys_at(seconds, pa.timestamp("ns")), at([NOW, NOW, FAR, FAR], pa.timestamp("us"))).read_all()
    with pytest.raises(ori.DataError, match="^keys: " + re.escape(wanted)):
        tables.evaluate(keys_at([*seconds[:2], FAR], pa.timestamp("us")), at([NOW], pa.timestamp("ns"))).read_all()
    with pytest.raises(ori.DataError, match=r"^at: found 9000000000000000000 us since 1970 in row 0 of"):
        tables.evaluate(keys_at(seconds, pa.timestamp("ns")), at([9 * 10**18], pa.timestamp("us"))).read_all()
    found = tables.evaluate(keys_at(seconds, pa.timestamp("us")), at([NOW, FAR], pa.timestamp("ms"))).read_all()
    assert found["error"].to_pylist() == [None, "found a time outside the keys of the track"]


def test_ids_without_room_are_named_too():
    keys = keys_at([0.0, 1.0], pa.float64(), track=2**40)
    with pytest.raises(ori.DataError, match=r"^keys: found 1099511627776 in row 0 of the column 'track', wanted what int32 has room for"):
        tables.evaluate(keys, at([0.5], pa.float64()).set_column(0, "track", pa.array([1], pa.int32()))).read_all()
    with pytest.raises(ori.ArgumentError, match=r"^keys: found int64 in the column 'track', which is date32\[day\] elsewhere, wanted one type"):
        tables.evaluate(keys, at([0.5], pa.float64()).set_column(0, "track", pa.array([1], pa.date32()))).read_all()


@pytest.mark.parametrize("assume_sorted", [False, True])
def test_files_of_other_types_say_which_row_has_no_room(tmp_path, assume_sorted):
    pq.write_table(keys_at([NOW], pa.timestamp("ms"), track=0), tmp_path / "a.parquet")
    pq.write_table(keys_at([NOW, NOW + datetime.timedelta(microseconds=7)], pa.timestamp("us")), tmp_path / "b.parquet")
    with pytest.raises(ori.DataError, match=r"b.parquet: found 2026-03-01 00:00:00.000007 in row 1 of the column 't', wanted what timestamp\[ms\]"):
        tables.resample([tmp_path / "a.parquet", tmp_path / "b.parquet"], assume_sorted=assume_sorted).read_all()


def test_large_whole_numbers_become_the_nearest_doubles():
    keys = keys_at([0.0, 1.0], pa.float64())
    for k, name in enumerate(("x", "y", "z")):
        keys = keys.append_column(name, pa.array([2**53 + 1, k]))
    found = tables.resample(keys, position=["x", "y", "z"], rate=1).read_all()
    assert found["x"].to_pylist() == [2.0**53, 0.0]


def test_a_frame_that_is_no_table():
    pandas = pytest.importorskip("pandas")
    with pytest.raises(ori.ArgumentError, match="^source: found a data frame that is no table .*, wanted columns of one type each"):
        tables.resample(pandas.DataFrame({"track": [1, 1], "t": [0.0, "x"]}))


def test_stamps_of_centuries_apart_come_back():
    """Nanoseconds of 500 years are more than 2^63."""
    ends = [datetime.datetime(1700, 1, 1), datetime.datetime(2200, 1, 1)]
    found = tables.resample(keys_at(ends, pa.timestamp("ns")), rate="1/1000000000", derivatives=0, method="slerp").read_all()
    first, last = (pa.scalar(time, pa.timestamp("ns")).value for time in ends)
    stamps = found["t"].cast(pa.int64()).to_pylist()
    assert len(stamps) == (last - first) // 10**18 + 1 and np.abs(np.diff([s / 1e18 for s in stamps]) - 1).max() < 1e-6


FLIPPED = "found a request for 1e+14 samples since the key before, wanted 1e+09 at most: check the rate and the unit of the times, or set `gap`"


@pytest.mark.parametrize("align", ["start", "epoch"])
@pytest.mark.parametrize("in_pieces", [False, True])
def test_a_flipped_time_asks_for_no_endless_rows(in_pieces, align, monkeypatch):
    if in_pieces:
        monkeypatch.setattr(_tracks.tracks_in, "__defaults__", (5,))
    made = tracks(3, least=9)
    good = table_of(made)
    made[1][0][-1] = 1e12
    flipped = table_of(made)
    found = tables.resample(flipped, align=align).read_all()
    failed, = found.filter(found["error"].is_valid()).to_pylist()
    assert failed["track"] == 1 and failed["error"] == f"key {len(made[1][0]) - 1}: {FLIPPED}"
    others = tables.resample(good, align=align).read_all()
    for track in (0, 2):
        assert np.array_equal(*(columns(t.filter(pa.compute.equal(t["track"], track)), ["t", *QUATERNION]) for t in (found, others)))
    apart = tables.resample(flipped, gap=1000.0, align=align).read_all()
    assert apart["error"].null_count == len(apart) < 10**6


def test_a_live_track_goes_on_without_a_flipped_time():
    pytest.importorskip("pyspark")
    pandas = pytest.importorskip("pandas")
    from orispline.spark._live import LiveTrack
    from orispline.tables._jobs import resampling_of
    live = LiveTrack(resampling_of({"rate": 100.0, "method": "slerp", "derivatives": 0}), "us", (1,), None)
    for times in ([0, 1, 10**12], [2, 3]):  # [s]
        frame = pandas.DataFrame({"track": 1, "t": [t * 10**6 for t in times], **dict(zip(QUATERNION, [0.0, 0.0, 0.0, 1.0]))})
        live.add(frame)
        rows = pandas.concat(list(live.samples()))
        live = LiveTrack(resampling_of({"rate": 100.0, "method": "slerp", "derivatives": 0}), "us", (1,), live.state)
        assert rows["error"].dropna().tolist() == (["key 2: " + FLIPPED] if 10**12 in times else [])
    assert rows["t"].max() == 2_990_000  # the sample at 3 s waits for the next key


SPAN = 4  # s
TURN = np.column_stack([0 * (half := np.sin(np.arange(SPAN + 1.0))), 0 * half, np.sin(half), np.cos(half)])
UNITS = ["s", "ms", "us", "ns"]
JOBS = {
    "resample": lambda keys, rate: tables.resample(keys, rate=rate), "epoch": lambda keys, rate: tables.resample(keys, rate=rate, align="epoch"),
    "in pieces": lambda keys, rate: tables.resample(keys, rate=rate), "smooth": lambda keys, rate: tables.smooth(keys, rate=rate),
}


def stamped(unit, kind=pa.timestamp):
    stamps = np.datetime64("2026-02-03T04:05:06", unit) + np.arange(SPAN + 1) * np.timedelta64(1, "s")
    return stamps, keys_at(stamps.astype(np.int64), kind(unit)).drop_columns(QUATERNION).append_column("qx", pa.array(TURN[:, 0])).append_column(
        "qy", pa.array(TURN[:, 1])).append_column("qz", pa.array(TURN[:, 2])).append_column("qw", pa.array(TURN[:, 3]))


@pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
@pytest.mark.parametrize("rate", ["1", "20", "30000/1001", "240", "1/3", "7001"])
@pytest.mark.parametrize("job", JOBS)
def test_the_orientation_of_a_row_is_that_at_its_stamp(job, rate, monkeypatch):
    if job == "in pieces":
        monkeypatch.setattr(_tracks.tracks_in, "__defaults__", (3,))
    step = 1 / fractions.Fraction(rate)
    for unit in UNITS:
        stamps, keys = stamped(unit)
        found = JOBS[job](keys, rate).read_all()
        times = found["t"].to_numpy()
        assert found["error"].null_count == len(times) == len(set(times.tolist()))
        kind = found.schema.field("t").type
        exact = (step * 10**ori._stamps.DIGITS[kind.unit]).denominator == 1
        assert UNITS.index(kind.unit) >= UNITS.index(unit) and (exact or kind.unit in ("us", "ns"))
        curve = ori.smooth(ori.Keys(stamps, TURN)).curve if job == "smooth" else ori.Curve(stamps, TURN)
        assert np.abs(curve(times) - columns(found, QUATERNION)).max() < (1e-12 if exact else 1e-6), (unit, kind)


@pytest.mark.parametrize("kind", [pa.timestamp, pa.duration])
def test_another_type_of_times_is_said(kind):
    _, keys = stamped("s", kind)
    wanted = rf"^the column 't' of the result is {kind('ms')}, that of the keys {kind('s')}: as {kind('s')} its times would be rounded".replace("[", r"\[").replace("]", r"\]")
    for job in (lambda: tables.resample(keys, rate=20), lambda: tables.smooth(keys, rate=20), lambda: tables.mean(keys, every="500ms")):
        with pytest.warns(ori.ShapeWarning, match=wanted) as said:
            assert job().schema.field("t").type == kind("ms")
        assert said[0].message.code == "time_type" and said[0].filename == __file__
    with warnings.catch_warnings():
        warnings.simplefilter("error", ori.ShapeWarning)
        for job in (tables.resample(keys, rate=1), tables.reduce(keys, 0.1), tables.smooth(keys), tables.mean(keys, every=2)):
            assert job.schema.field("t").type == kind("s")
    with pytest.warns(ori.ShapeWarning, match="of the result is double, that of the keys float"):
        tables.resample(keys.set_column(1, "t", pa.array(np.arange(SPAN + 1.0), pa.float32())), rate=3)


def test_windows_have_the_times_of_their_middles():
    _, keys = stamped("s")
    with pytest.warns(ori.ShapeWarning, match="the column 't' of the result is"):
        found = tables.mean(keys, every=1).read_all()
    assert (found["t"].to_numpy() - np.datetime64("2026-02-03T04:05:06")).astype("m8[ms]").astype(int).tolist() == [500, 1500, 2500, 3500, 4500]


def test_a_stamp_without_room_in_the_type_of_the_result_is_named():
    keys = pa.concat_tables([keys_at([NOW, NOW + datetime.timedelta(seconds=1)], pa.timestamp("s"), k) for k in range(2)] +
                            [keys_at([FAR, FAR + datetime.timedelta(seconds=1)], pa.timestamp("s"), 2)])
    with pytest.warns(ori.ShapeWarning):
        found = tables.resample(keys, rate=7001).read_all()
    bad, = found.filter(found["error"].is_valid()).to_pylist()
    assert bad["track"] == 2 and bad["error"].startswith("found 2584-01-01 00:00:00 in the column 't', wanted a time that timestamp[ns] has room for")
    assert len(found) == 2 * 7002 + 1


def test_stamps_with_a_zone_and_without_one_do_not_meet(tmp_path):
    naive, zoned = (keys_at([NOW, NOW + datetime.timedelta(seconds=1)], kind) for kind in (pa.timestamp("us"), pa.timestamp("ms", "UTC")))
    for keys, other in ((naive, zoned), (zoned, naive)):
        with pytest.raises(ori.ArgumentError, match="^found times of type timestamp.*wanted timestamps with a time zone in both tables or in neither"):
            tables.evaluate(keys, other.select(["track", "t"]))
    assert tables.evaluate(zoned, zoned.select(["track", "t"])).read_all()["error"].null_count == 2
    for name, table in (("a", naive), ("b", zoned)):
        pq.write_table(table, tmp_path / f"{name}.parquet")
    with pytest.raises(ori.ArgumentError, match="b.parquet: found timestamp.*wanted stamps with a time zone in both or in neither"):
        tables.resample(tmp_path).read_all()


def null_at(table, row, name="t"):
    values = table[name].to_pylist()
    return table.set_column(table.schema.get_field_index(name), name, pa.array([*values[:row], None, *values[row + 1:]], table.schema.field(name).type))


@pytest.mark.parametrize("kind", [pa.float64(), pa.timestamp("us")], ids=str)
@pytest.mark.parametrize("in_pieces", [False, True])
def test_a_null_time_is_said_with_its_row(kind, in_pieces, monkeypatch):
    if in_pieces:
        monkeypatch.setattr(_tracks.tracks_in, "__defaults__", (3,))
    table = table_of(tracks(2, least=9))
    table = table.set_column(1, "t", pa.array((table["t"].to_numpy() * 1e6).astype(np.int64) if pa.types.is_timestamp(kind) else table["t"], kind))
    row = {name: table[name][4].as_py() for name in QUATERNION}
    words = f"found null in the column 't', wanted a time in every row: see the row with {', '.join(f'{name} {value!r}' for name, value in row.items())}"
    for form in (null_at(table, 4), null_at(table, 4).to_reader(max_chunksize=4)):
        found = tables.resample(form).read_all()
        assert found.filter(found["error"].is_valid()).select(["track", "error"]).to_pylist() == [{"track": 0, "error": words}]
    for job in (lambda keys: tables.smooth(keys, smoothing_time=0.1), lambda keys: tables.reduce(keys, 0.1), lambda keys: tables.compare(keys, ["slerp"], 2)):
        assert words in job(null_at(table, 4)).read_all()["error"].to_pylist()


def test_a_time_that_is_wanted_may_be_missing():
    keys = keys_at([0.0, 1.0], pa.float64())
    wanted = pa.table({"track": [1] * 4, "t": pa.array([0.5, 2.0, None, float("nan")], from_pandas=False), "row": range(4)})
    for options in ({}, {"extrapolate": "hold"}):
        found = tables.evaluate(keys, wanted, **options).read_all().sort_by("row")["error"].to_pylist()
        assert found == [None, None if options else "found a time outside the keys of the track", "found null in the column 't', wanted a time",
                         "found nan in the column 't', wanted a time"]


@pytest.mark.parametrize("unit", [None, "us"])
def test_a_live_track_goes_on_without_a_null_time(unit):
    pytest.importorskip("pyspark")
    pandas = pytest.importorskip("pandas")
    from orispline.spark._live import LiveTrack
    from orispline.tables._jobs import resampling_of
    job = resampling_of({"rate": 4, "derivatives": 0, "method": "slerp"})
    live = LiveTrack(job, unit, (1,), None)
    times = [None, 0.0, 1.0, None, 2.0] if unit is None else [None, 0, 10**6, None, 2 * 10**6]
    live.add(pandas.DataFrame({"track": 1, "t": pandas.array(times, "float64" if unit is None else "Int64"), "qx": 0.0, "qy": 0.0,
                               "qz": [0.0, 0.0, 0.6, 0.28, 0.8], "qw": [1.0, 1.0, 0.8, 0.96, 0.6]}))
    rows = pandas.concat([*live.samples(), *LiveTrack(job, unit, (1,), live.state).ended()])
    what = "null" if unit else "null or nan"  # which pandas does not tell apart
    assert rows["error"].dropna().tolist() == [f"found {what} in the column 't', wanted a time in every row: see the row with qx 0.0, qy 0.0, {rest}"
                                               for rest in ("qz 0.0, qw 1.0", "qz 0.28, qw 0.96")]
    assert rows["qw"].dropna().tolist() == ori.Curve([0.0, 1.0, 2.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 0.8, 0.6]], "slerp").sample(
        rate=4).orientations[:, 3].tolist()
