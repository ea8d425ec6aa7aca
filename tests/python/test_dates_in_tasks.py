# SPDX-License-Identifier: Apache-2.0
"""What tasks say of keys that have dates is said in dates, and a reference is taken at its own dates, wherever it begins."""
import pickle

import numpy as np
import orispline as ori
import pytest

START = np.datetime64("2026-03-01T10:00:00", "ns")
SECONDS = np.arange(400) * 0.01


def dated(seconds):
    return START + np.round(seconds * 1e9).astype("m8[ns]")


def turns(seconds, noise=0.0):
    half = 0.5 * np.sin(2 * seconds)
    q = np.column_stack([np.zeros((len(half), 2)), np.sin(half), np.cos(half)])
    return q + noise * np.random.default_rng(2).normal(size=q.shape)


def keys_of(times, q):
    return ori.Keys(times, q, normalize=True)


@pytest.mark.parametrize("later", [0.0, 1.0])
def test_a_reference_counts_by_its_own_dates(later):
    """A reference that begins later than the keys is as far from them as the same seconds are."""
    some, dense = SECONDS[::10], SECONDS[SECONDS >= later]
    plain, with_dates = ((keys_of(of(some), turns(some)), keys_of(of(dense), turns(dense))) for of in (np.array, dated))
    tables = [ori.compare(keys, ["slerp", "auto"], reference=reference, least_energy=False).table() for keys, reference in (plain, with_dates)]
    assert np.allclose([row["rms_deg"] for row in tables[0]], [row["rms_deg"] for row in tables[1]], rtol=1e-5, atol=1e-12)
    tunings = [ori.tune(keys, "quintic", objective="fit", reference=reference) for keys, reference in (plain, with_dates)]
    assert np.isclose(tunings[0].energy_after, tunings[1].energy_after, rtol=1e-5)
    whole = np.round(dense * 1e9).astype(np.int64)
    counted = ori.compare(plain[0], ["slerp", "auto"], reference=ori.Keys(whole, turns(dense), time_unit="ns"), least_energy=False).table()
    assert np.allclose([row["rms_deg"] for row in tables[0]], [row["rms_deg"] for row in counted], rtol=1e-5, atol=1e-12)


def test_a_reference_of_other_times_is_refused():
    some = SECONDS[::10]
    for work in (lambda keys, reference: ori.compare(keys, "slerp", reference=reference),
                 lambda keys, reference: ori.tune(keys, "quintic", objective="fit", reference=reference)):
        with pytest.raises(ori.ArgumentError, match="reference: found an array of float64, wanted datetime64, as the times of the keys are"):
            work(keys_of(dated(some), turns(some)), keys_of(some, turns(some)))


def test_errors_of_tasks_have_the_dates_of_the_keys():
    some = SECONDS[::10]
    keys, far = keys_of(dated(some), turns(some)), keys_of(dated(some) + np.timedelta64(400, "D"), turns(some))
    wanted = ("reference: none of the 40 times, 2027-04-05T10:00:00.000000000 to 2027-04-05T10:00:03.900000000, lies between the keys, "
              "2026-03-01T10:00:00.000000000 to 2026-03-01T10:00:03.900000000")
    for each in (keys, pickle.loads(pickle.dumps(keys)), keys[:40]):
        for work in (lambda: ori.compare(each, "slerp", reference=far), lambda: ori.tune(each, "quintic", objective="fit", reference=far)):
            with pytest.raises(ori.DataError) as found:
                work()
            assert str(found.value) == wanted


def test_the_time_of_an_error_is_a_date_or_a_plain_number():
    noisy = turns(SECONDS, 0.003)
    assert type(ori.reduce(keys_of(SECONDS, noisy), 0.02).error_max_time) is float
    assert type(ori.reduce(keys_of(dated(SECONDS), noisy), 0.02).error_max_time) is np.datetime64
    assert "np.float64" not in repr(ori.reduce(keys_of(SECONDS, noisy), 0.02))


@pytest.mark.parametrize("keys_of_dates", [lambda keys: keys, lambda keys: pickle.loads(pickle.dumps(keys)), lambda keys: keys[:200]])
def test_results_are_printed_with_dates(keys_of_dates):
    """No result of dated keys has a time in seconds since 1970, 1772359200 here."""
    keys = keys_of_dates(keys_of(dated(SECONDS), turns(SECONDS, noise=1e-3)))
    results = [ori.compare(keys, ["slerp", "auto"], keep_every=4, least_energy=False), ori.smooth(keys), ori.reduce(keys, tolerance="1deg"),
               ori.reduce(keys, tolerance="1deg", smooth=True)]
    for text in map(str, results):
        assert "17723592" not in text
    for text in (str(results[i]) for i in (0, 2, 3)):
        assert "2026-03-01T10:00:0" in text
