# SPDX-License-Identifier: Apache-2.0
"""Times as callers have them: dates of any century, durations, time zones and integers, which are never wrapped or rounded in silence."""
import datetime
import decimal
import pickle

import numpy as np
import orispline as ori
import pytest

Q = [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
DAYS = np.array(["2000-01-01", "2000-01-02", "2000-01-03"], "datetime64[D]")
DATED = ori.Curve(DAYS, Q)


@pytest.mark.parametrize("stamps", [
    np.array(["2500-01-01", "2500-01-02", "2500-01-04"], "datetime64[D]"), np.array(["1600", "1700", "1800"], "datetime64[Y]"),
    np.array(["-8000", "0001", "9999"], "datetime64[Y]"), np.array(["1700", "2000", "2250"], "datetime64[ns]"),
    np.array([-90_000_000, 0, 90_000_000], "datetime64[Y]"),
    [datetime.datetime(2500, 1, 1), datetime.datetime(2500, 1, 2, 3, 4, 5, 6), datetime.datetime(9999, 1, 1)],
    [datetime.date(1000, 1, 1), datetime.date(2000, 1, 1), datetime.date(3000, 1, 1)]])
def test_dates_of_any_century_come_back(stamps):
    """Nanoseconds in 64 bits reach from 1677 to 2262, and no farther apart than 292 years."""
    keys = ori.Keys(stamps, Q)
    wanted = np.array(stamps, "datetime64[s]" if np.asarray(stamps).dtype.kind == "M" else "datetime64[us]")
    assert (np.abs((keys.times - wanted) / np.timedelta64(1, "us")) <= 1).all() and (np.diff(keys.times) > np.timedelta64(0)).all()
    curve = keys.curve("slerp", extrapolate="error")
    assert curve.domain == (keys.times[0], keys.times[-1])
    assert np.allclose(curve(keys.times), Q, atol=1e-6)
    assert np.array_equal(pickle.loads(pickle.dumps(curve, 5)).times, keys.times)


def test_times_of_centuries_apart_are_outside():
    strict, held = (DATED.keys.curve("slerp", extrapolate=how) for how in ("error", "hold"))
    for far in ("2584-01-01", "1400-01-01", "9999-01-01", "-9999-01-01"):
        with pytest.raises(ori.ArgumentError, match=f"time {far}T00:00:00.* is outside the curve, wanted 2000-01-01T") as found:
            strict(np.array(["2000-01-01", far], "datetime64[D]"))
        assert found.value.time_index == 1
        assert np.array_equal(held(np.datetime64(far)), held(DAYS[2] if far > "2000" else DAYS[0]))
    quarters = np.arange(3) * np.pi / 4  # half the angles of a quarter turn a day
    daily = ori.Curve(DAYS, [[0, 0, np.sin(a), np.cos(a)] for a in quarters], "slerp", extrapolate="rate")
    days = int((np.datetime64("2584-01-01") - DAYS[0]) / np.timedelta64(1, "D"))
    turned = daily(np.datetime64("2584-01-01"))
    assert abs(np.sin(0.5 * (2 * np.arctan2(turned[2], turned[3]) - days * np.pi / 2))) < 1e-5
    samples = held.sample(times=np.array(["1000", "2584"], "datetime64[Y]"))
    assert samples.times.tolist() == [datetime.datetime(1000, 1, 1), datetime.datetime(2584, 1, 1)]
    loop = ori.Curve(DAYS, Q, "timed-c2", period=2e10)
    assert loop.domain[1] - loop.domain[0] == np.timedelta64(20_000_000_000, "s")


def test_stamps_that_no_unit_has_room_for_are_refused():
    with pytest.raises(ori.ArgumentError, match="times: found stamps more than 292 million years apart, wanted less"):
        ori.Keys(np.array([-400_000_000, 0, 400_000_000], "datetime64[Y]"), Q)
    with pytest.raises(ori.ArgumentError, match=r"times: found timedelta64\[M\], wanted a unit of fixed length"):
        ori.Keys(np.array([0, 1, 2], "timedelta64[M]"), Q)


def test_errors_about_dates_have_stamps():
    for days, what in (([0, 0, 1], "duplicate time 2000-01-01T00:00:00.000000000"),
                       ([1, 0, 2], "time 2000-01-01T00:00:00.000000000 comes after 2000-01-02T00:00:00.000000000")):
        with pytest.raises(ori.DataError, match=f"^key 1: {what}, wanted strictly increasing times \\(") as found:
            ori.Keys(DAYS[days], Q)
        assert found.value.key == 1
        with pytest.raises(ori.DataError, match=what):
            DATED.distance(DAYS[days], Q)
    online = ori.OnlineCurve("slerp")
    online.append(DAYS[1], Q[0])
    with pytest.raises(ori.DataError, match="key 1: time 2000-01-01T00:00:00.000000000 comes after 2000-01-02T") as found:
        online.append(DAYS[0], Q[1])
    assert found.value.key == 1 and len(online) == 1
    with pytest.raises(ori.DataError, match="found 2000-01-01T00:00:00.000000000 after 2000-01-03T00:00:00.000000000 at index 1"):
        DATED.rate_error(DAYS[[2, 0]], np.zeros((2, 3)))
    with pytest.raises(ori.DataError, match="key 2: time 1700000000000000001 comes after 1700000000000000002"):
        ori.Keys(np.array([0, 2, 1]) + 1_700_000_000_000_000_000, Q, time_unit="ns")


def test_durations_are_times():
    seconds = ori.Curve([1.0, 2.0, 3.5], Q)
    spans = np.array([1000, 2000, 3500], "timedelta64[ms]")
    for times in (spans, list(spans.tolist()), spans.astype("timedelta64[us]")):
        curve = ori.Curve(times, Q)
        assert repr(curve) == repr(seconds) and curve.times.dtype == "timedelta64[ns]" and np.array_equal(curve.times, spans)
        assert np.array_equal(curve(np.timedelta64(1500, "ms")), seconds(1.5))
        assert np.array_equal(curve(datetime.timedelta(seconds=1.5)), seconds(1.5))
        assert np.isnan(curve(np.timedelta64("NaT"))).all()
        samples = curve.sample(rate=2, derivatives=1, start=np.timedelta64(1500, "ms"))
        assert np.array_equal(samples.times, np.array([1500, 2000, 2500, 3000, 3500], "timedelta64[ms]"))
        assert samples.epoch == decimal.Decimal(1) and curve.domain == (spans[0], spans[-1])
        assert curve.peaks().angular_velocity.time.dtype == "timedelta64[ns]"
    with pytest.raises(ori.ArgumentError, match="t: found an array of float64, wanted timedelta64, as the times of the keys are"):
        curve(1.5)
    with pytest.raises(ori.ArgumentError, match="t: found an array of timedelta64.*, wanted numbers"):
        seconds(np.timedelta64(1, "s"))
    online = ori.OnlineCurve("slerp")
    for t, q in curve.keys:
        online.append(t, q)
    assert online.available == (spans[0], spans[-1])


def test_durations_are_written_and_drawn(tmp_path):
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    curve = ori.Curve(np.array([1000, 2000, 3500], "timedelta64[ms]"), Q)
    curve.sample(count=2).write(tmp_path / "motion.csv")
    assert [line.split(",")[0] for line in (tmp_path / "motion.csv").read_text().splitlines()] == ["t", "1", "3.5"]
    chart, = curve.plot(quantities="rate")
    assert chart.get_xlabel() == "time [s]" and chart.get_lines()[0].get_xdata()[[0, -1]].tolist() == [1.0, 3.5]
    made = ori.Samples(np.array([500, 2000], "timedelta64[ms]"), np.array([[0, 0, 0, 1], [0.6, 0, 0, 0.8]]))
    made.write(tmp_path / "made.csv")
    assert (tmp_path / "made.csv").read_text() == "t,qw,qx,qy,qz\n0.5,1,0,0,0\n2,0.8,0.6,0,0\n"


def test_stamps_of_several_units_in_a_list_are_never_wrapped():
    """As NumPy wraps those that the finest of the units has no room for."""
    now, far = np.datetime64("2026-03-01", "ns"), np.datetime64("2584-01-01", "us")
    held = ori.Curve(np.array(["2026-02-01", "2026-03-01", "2026-04-01"], "datetime64[ns]"), Q)
    assert np.allclose(held([now, far]), Q[1:]) and np.allclose(held([[now], [far]])[:, 0], Q[1:])
    for times in ([now, far, np.datetime64("9999", "Y")], [datetime.datetime(2026, 3, 1), far, datetime.date(9999, 1, 1)]):
        assert ori.Keys(times, Q).times.tolist() == [datetime.datetime(2026, 3, 1), datetime.datetime(2584, 1, 1), datetime.datetime(9999, 1, 1)]
    spans = ori.Keys([np.timedelta64(0, "ns"), datetime.timedelta(seconds=1), np.timedelta64(10**12, "s")], Q).times
    assert (spans / np.timedelta64(1, "s")).tolist() == [0.0, 1.0, 1e12]
    with pytest.raises(ori.ArgumentError, match="times: found timedelta64.Y., wanted a unit of fixed length"):
        ori.Keys([np.timedelta64(0, "s"), np.timedelta64(1, "Y"), np.timedelta64(9, "s")], Q)


def test_dates_with_a_time_zone_are_those_of_utc():
    pandas = pytest.importorskip("pandas")
    stamps = pandas.date_range("2026-03-29T00:30:00.000000007", periods=3, freq="h", tz="Europe/Berlin")  # past a change of clocks
    utc = stamps.tz_convert(None).to_numpy()
    for times in (stamps, list(stamps), pandas.Series(stamps), pandas.Series(stamps).dt.as_unit("ns").astype("timestamp[ns, tz=UTC][pyarrow]")):
        assert np.array_equal(ori.Curve(times, Q).times, utc)
    curve = ori.Curve(stamps, Q)
    assert np.array_equal(curve(stamps[1]), curve(utc[1]))
    east = datetime.timezone(datetime.timedelta(hours=5))
    assert np.array_equal(DATED(datetime.datetime(2000, 1, 2, 5, tzinfo=east)), DATED(DAYS[1]))
    assert np.isnan(DATED(pandas.NaT)).all() and len(curve(pandas.Series([stamps[0], pandas.NaT]))) == 2
    with pytest.raises(ori.ArgumentError, match="t: found dates with a time zone and dates without one, wanted a time zone for all or for none"):
        DATED([datetime.datetime(2000, 1, 2, tzinfo=east), datetime.datetime(2000, 1, 2)])


@pytest.mark.parametrize("kind", ["Float64", "Int64", "double[pyarrow]", "int64[pyarrow]"])
def test_columns_of_pandas_own_types_are_numbers(kind):
    pandas = pytest.importorskip("pandas")
    times, plain = pandas.Series([0, 1, 3], dtype=kind), ori.Curve([0, 1, 3], Q)
    frame = pandas.DataFrame(np.multiply(Q, 5).astype(int), dtype=kind)
    curve = ori.Curve(times, frame, normalize=True, positions=pandas.DataFrame(np.eye(3, dtype=int), dtype=kind))
    assert np.allclose(curve.keys.rotations, plain.keys.rotations) and np.array_equal(curve.times, plain.times)
    assert np.allclose(curve(pandas.Series([1, 2], dtype=kind)), plain([1, 2])) and np.array_equal(curve.keys.positions, np.eye(3))
    with pytest.raises(ori.DataError, match="key 1: time is nan, wanted a finite number") as found:
        ori.Keys(pandas.Series([0, None, 3], dtype=kind), Q)
    assert found.value.key == 1
    if "nt64" in kind:
        stamps = pandas.Series([0, 1, 3], dtype=kind) * 10**9 + 1_700_000_000_000_000_007
        assert ori.Keys(stamps, Q, time_unit="ns").times.tolist() == stamps.tolist()


def test_integers_and_epochs_are_seen_in_reprs():
    start = 1_700_000_000
    assert repr(ori.Keys(np.array([0, 1, 3]) * 10**9 + start * 10**9, Q, time_unit="ns")) == (
        "Keys(3 keys, 1700000000000000000 … 1700000003000000000 ns)")
    assert repr(ori.Keys(np.array([0, 1, 3]) + start, Q, time_unit="ms")) == "Keys(3 keys, 1700000000 … 1700000003 ms)"
    assert repr(ori.Keys(np.array([0, 1, 3.0]) + start, Q)) == "Keys(3 keys, 1700000000 … 1700000003 s)"
    assert repr(ori.Keys([0, 1, 3], Q)) == "Keys(3 keys, 0 … 3 s)" and repr(ori.Keys([2.5], Q[:1])) == "Keys(1 key, 2.5 … 2.5 s)"
    curve = ori.Curve(np.array([0, 1, 3]) * 10**9 + start * 10**9, Q, time_unit="ns")
    assert curve.domain == (start * 10**9, start * 10**9 + 3 * 10**9)
