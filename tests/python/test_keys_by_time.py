# SPDX-License-Identifier: Apache-2.0
"""Keys and samples taken by places and by times, one by one, and joined."""
import datetime
import pickle

import numpy as np
import orispline as ori
import pytest

T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
KEYS = ori.Keys(T, Q, positions=np.eye(3))
STAMPS = np.array(["2026-11-28T10:00:00.000000007", "2026-11-28T10:04:59", "2026-11-28T10:05"], "datetime64[ns]")
DATED = ori.Keys(STAMPS, Q)
DURING = ori.Keys(np.array([0, 1, 3], "timedelta64[s]"), Q)
PER_DAY = ori.Keys(np.datetime64("2026-11-27T23:50", "s") + np.arange(3) * np.timedelta64(10, "m"), Q)


@pytest.mark.parametrize("place", [0, 1, 2, -1, -3, np.int64(1), np.uint8(2)])
def test_a_number_is_a_place(place):
    row = KEYS[place]
    assert len(row) == 1 and row.times[0] == T[place] and np.array_equal(row.positions[0], np.eye(3)[place]) and row == KEYS[[place]]
    samples = KEYS.curve().sample(times=T, derivatives=2)
    assert samples[place].time == T[place] and np.array_equal(samples[place].angular_velocity, samples.angular_velocities[place])


@pytest.mark.parametrize(("keys", "part", "places"), [
    (KEYS, slice(0.5, 3.0), [1]), (KEYS, slice(None, 1.5), [0, 1]), (KEYS, slice(1.0, None), [1, 2]), (KEYS, slice(0, 2), [0, 1]),
    (KEYS, slice(0, 2.0), [0, 1]), (KEYS, slice(np.float32(0.5), None), [1, 2]), (KEYS, slice(-9.0, 1.0), [0]),
    (DATED, slice("2026-11-28T10:00", "10:05"), [0, 1]), (DATED, slice("2026-11-28 10:00:00.000000007", "2026-11-28T10:05:00.000000001"), [0, 1, 2]),
    (DATED, slice("2026-11-28T10:00:00.000000008", None), [1, 2]), (DATED, slice(None, "10:00:30"), [0]), (DATED, slice("10:04", "10:05"), [1]),
    (DATED, slice("2026-11-28T11:00+01:00", "2026-11-28T10:04:59Z"), [0]), (DATED, slice(STAMPS[1], None), [1, 2]),
    (DATED, slice(datetime.datetime(2026, 11, 28, 10, 1), STAMPS[2]), [1]), (DATED, slice("2026-11-28", "2026-11-29"), [0, 1, 2]),
    (DATED, slice(datetime.date(2026, 11, 28), None), [0, 1, 2]), (DURING, slice(np.timedelta64(500, "ms"), datetime.timedelta(seconds=3)), [1]),
    (PER_DAY, slice("2026-11-28", "0:05"), [1]), (PER_DAY, slice("23:50", "23:59:59,5"), [0])])
def test_a_slice_of_times_is_without_its_end(keys, part, places):
    assert keys[part] == keys[places]
    samples = keys.curve().sample(times=keys.times)
    assert np.array_equal(samples[part].orientations, samples.orientations[places])


def test_keys_of_files_are_taken_by_dates_too(tmp_path):
    (tmp_path / "keys.csv").write_text("t,qw,qx,qy,qz\n1795860000.000000007,1,0,0,0\n1795860299,0.8,0,0,0.6\n1795860300,0,0,0,1\n")
    keys = ori.read(tmp_path / "keys.csv")
    assert keys["2026-11-28T10:00":"10:05"] == keys[:2] == keys[:np.datetime64("2026-11-28T10:05")] and keys[0.5:] == keys[1:]
    assert len(keys.curve("slerp").sample(rate=1)["10:04":]) == 60


BAD = [(KEYS, slice(5.0, 6.0), ori.DataError, "keys: found none from 5.0 to 6.0, wanted times of theirs, 0 … 3 s"),
       (KEYS, slice(2.0, 1.0), ori.DataError, "keys: found none from 2.0 to 1.0"), (DATED, slice("9:00", "9:30"), ori.DataError, "keys: found none from 9:00 to 9:30"),
       (KEYS, slice("10:00", None), ori.ArgumentError, "keys: found the text '10:00' in a slice, wanted numbers, as the times are"),
       (DURING, slice("10:00", None), ori.ArgumentError, "wanted durations such as numpy.timedelta64"),
       (DATED, slice("noon", None), ori.ArgumentError, "keys: found the text 'noon' in a slice, wanted a date such as"),
       (DATED, slice(1.5, None), ori.ArgumentError, "keys: found an array of float64, wanted datetime64, as the times of the keys are"),
       (KEYS, slice(STAMPS[0], None), ori.ArgumentError, "wanted numbers, as the times of the keys are"),
       (KEYS, slice(np.nan, None), ori.ArgumentError, "keys: found nan in a slice, wanted a time"),
       (DATED, slice(np.datetime64("NaT"), None), ori.ArgumentError, "in a slice, wanted a time"),
       (KEYS, slice(np.array([0.0, 1.0]), None), ori.ArgumentError, "in a slice, wanted a time"),
       (KEYS, slice(0.5, 3.0, 2), ori.ArgumentError, r"keys: found the step 2 in a slice of times, wanted none"),
       (KEYS, slice(100, 200), ori.DataError, r"keys: found no keys at the places 100:200 of 3, wanted one at least: .* such as keys\[2.0:5.0\]"),
       (KEYS, slice(2, 0, -1), ori.ArgumentError, "keys: found the step -1, wanted one above 0, since times rise"),
       (KEYS, 3, IndexError, "keys: found the place 3, wanted one of 3, from -3 to 2"), (KEYS, -4, IndexError, "keys: found the place -4")]


@pytest.mark.parametrize(("keys", "part", "error", "text"), BAD)
def test_what_is_outside_or_no_time_is_told(keys, part, error, text):
    with pytest.raises(error, match=text):
        keys[part]
    if "step -1" not in text and "places" not in text:
        with pytest.raises(error, match=text.replace("keys: ", "samples: ")):
            keys.curve().sample(times=keys.times)[part]


def test_samples_are_gone_through_one_by_one(tmp_path):
    curve = KEYS.curve()
    samples = curve.sample(rate="100 Hz", derivatives=3, frame="world")
    for place, sample in enumerate(samples):
        assert sample == samples[place] and sample.time == samples.times[place] and np.array_equal(sample.orientation, curve(sample.time))
    assert place == 300 and samples[3] != samples[4] and hash(samples[3]) == hash(samples[3]) and samples[3] != curve.motion(0.03)
    assert np.array_equal(samples[-1].acceleration, samples.accelerations[-1]) and curve.sample(count=2)[0].angular_velocity is None
    some = samples[[5, 3]]
    assert np.array_equal(some.times, samples.times[[5, 3]]) and some.frame == "world" and len(samples[::-2]) == 151 and len(samples[:0]) == 0
    assert len(samples[samples.times > 2]) == 100 and pickle.loads(pickle.dumps(samples[:9]))[8] == samples[8]
    stack = ori.CurveStack(T, [[q, q] for q in Q]).sample(count=4, derivatives=1)
    assert stack[1].angular_velocity.shape == (2, 3) and stack[1:3].orientations.shape == (2, 2, 4)
    samples[10:20].write(tmp_path / "some.csv")
    samples.write(tmp_path / "all.csv")
    rows = (tmp_path / "all.csv").read_text().splitlines()
    assert (tmp_path / "some.csv").read_text().splitlines() == [rows[0], *rows[11:21]]
    dated = DATED[1:].curve("slerp").sample(rate=4)
    dated["10:04:59.5":].write(tmp_path / "late.csv")
    assert (tmp_path / "late.csv").read_text().splitlines()[1].split(",")[0] == "1795860299.5"


FULL = {"positions": np.eye(3), "angular_velocities": [[0, 0, 5.0], [0, 1, 0], [np.nan] * 3], "inner_leaving": Q, "settings": {"tension": [1, 2, 3]}}


@pytest.mark.parametrize("times", [T, STAMPS, np.array([0, 1, 3], "timedelta64[s]")], ids=["numbers", "stamps", "durations"])
@pytest.mark.parametrize("how", [{}, {"signs": "as-given"}, {"scalar_first": True}, {"gap": 1.5}, FULL])
def test_what_was_parted_is_joined_again(times, how):
    keys = ori.Keys(times, np.roll(Q, 1, axis=1) if how.get("scalar_first") else Q, **how)
    for place in (1, 2):
        joined = keys[:place] + keys[place:]
        assert joined == keys and joined.epoch == keys.epoch and joined.gap == keys.gap
    assert keys[0] + keys[1] + keys[2] == keys


def test_joined_keys_stand_where_they_are_in_time(tmp_path):
    nanoseconds = ori.Keys(np.array([7, 10**9]) + 10**18, Q[:2], time_unit="ns") + ori.Keys(np.array([3 * 10**9]) + 10**18, Q[2:], time_unit="ns")
    assert nanoseconds.times.tolist() == [10**18 + 7, 10**18 + 10**9, 10**18 + 3 * 10**9]
    assert (DATED[:1] + ori.Keys(STAMPS[1:].astype("datetime64[us]"), Q[1:])).times[1] == STAMPS[1]
    for name, first in (("a", "1700000000.000000001"), ("b", "1700000010.000000001")):
        (tmp_path / f"{name}.csv").write_text(f"t,qw,qx,qy,qz\n{first},1,0,0,0\n{first[:-1]}2,0.8,0,0,0.6\n")
    a, b = (ori.read(tmp_path / f"{name}.csv") for name in "ab")
    assert np.allclose((a + b).times, [0, 1e-9, 10, 10 + 1e-9], atol=1e-12, rtol=0) and (a + b).epoch == a.epoch
    rates = KEYS[:1] + ori.Keys([1.0], Q[1:2], positions=[[0, 0, 0]], angular_velocities=[[1, 2, 3]])
    assert np.isnan(rates.angular_velocities[0]).all() and rates.angular_velocities[1].tolist() == [1, 2, 3]


@pytest.mark.parametrize(("more", "error", "text"), [
    (KEYS, ori.DataError, "key 3: time 0.0 of the keys that are added does not come after 3.0"), (KEYS[2:], ori.DataError, "key 3: time 3.0 of the keys"),
    (ori.Keys([4], Q[:1]), ori.ArgumentError, "positions: found keys with positions and keys without them"),
    (ori.Keys([4], Q[:1], positions=[[0] * 3], gap=1), ori.ArgumentError, "gap: found None and 1.0, wanted keys that have the same"),
    (ori.Keys([4], Q[:1], positions=[[0] * 3], signs="as-given"), ori.ArgumentError, "signs: found shortest and as-given"),
    (ori.Keys([4], Q[:1], positions=[[0] * 3], settings={"tension": [1]}), ori.ArgumentError, r"settings: found \[\] and \['tension'\]"),
    (ori.Keys([4], Q[:1], positions=[[0] * 3], time_unit="ms"), ori.ArgumentError, "keys: found times in s and in ms, wanted one unit"),
    (ori.Keys(STAMPS[:1], Q[:1], positions=[[0] * 3]), ori.ArgumentError, "wanted numbers, as the times of the keys are")])
def test_what_does_not_go_together_is_not_joined(more, error, text):
    with pytest.raises(error, match=text) as found:
        KEYS + more
    assert found.value.key == (3 if error is ori.DataError else None)


def test_only_keys_are_joined_with_keys():
    with pytest.raises(TypeError):
        KEYS + [1]
    pairs = list(KEYS)
    assert [float(t) for t, _ in pairs] == T


@pytest.mark.parametrize(("rate", "count"), [("100 Hz", 301), ("100Hz", 301), (" 0.1 kHz ", 301), ("30000/1001 Hz", 90), ("100", 301)])
def test_rates_have_units(rate, count):
    samples = KEYS.curve().sample(rate=rate)
    assert len(samples) == count
    assert len(ori.CurveStack(T, [[q] for q in Q]).sample(rate=rate)) == count


@pytest.mark.parametrize("times", [T, np.array(T), [0.5]])
def test_times_in_the_place_of_a_rate_are_told(times):
    for thing in (KEYS.curve(), ori.CurveStack([KEYS])):
        with pytest.raises(ori.ArgumentError, match="^rate: found an array, wanted a number of samples per second, or times= for the times of the samples$"):
            thing.sample(times)


@pytest.mark.parametrize("rate", ["100 hertz", "Hz", "-1 Hz", "0 kHz", "10ms", "1/0 Hz"])
def test_other_units_of_rates_are_refused(rate):
    with pytest.raises(ori.ArgumentError, match=f"rate: found '{rate}', wanted a number of samples per second greater than 0, or a text such as '100 Hz'"):
        KEYS.curve().sample(rate=rate)
