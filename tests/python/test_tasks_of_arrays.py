# SPDX-License-Identifier: Apache-2.0
"""Tasks take what curves take: times and rotations with all that belongs to keys, or Keys."""
import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation

pytestmark = pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
T = np.linspace(0, 4, 201)
TURNS = np.column_stack([np.sin(T), np.cos(1.3 * T), 0.5 * np.sin(0.7 * T)])
R = Rotation.from_rotvec(TURNS + np.random.default_rng(1).normal(0, 0.005, (201, 3)))
Q = R.as_quat()
RECORDING, FEW = ori.Keys(T, R), ori.Keys(T[::20], R[::20])
RATES = np.gradient(TURNS, T, axis=0)
TASKS = {"smooth": (ori.smooth, (), {"smoothing_time": 0.05}), "reduce": (ori.reduce, ("1deg",), {"method": "slerp"}), "retime": (ori.retime, (), {"max_rate": 1.0}),
         "tune": (ori.tune, ("quintic",), {}), "compare": (ori.compare, (["slerp", "auto"],), {"threads": 1})}
FORMS = {"rotations": ((T, R), {}), "arrays": ((T, Q), {}), "lists": ((T.tolist(), Q.tolist()), {}), "list of Rotations": ((T, list(R)), {}),
         "matrices": ((T, R.as_matrix()), {}), "a pair": (((T, Q),), {}), "by names": ((), {"times": T, "rotations": Q}), "one by its name": ((T,), {"rotations": Q}),
         "any norm": ((T, 3 * Q), {"normalize": True}), "scalar first": ((T, np.roll(Q, 1, axis=1)), {"scalar_first": True}),
         "Euler angles": ((T, R.as_euler("ZYX", degrees=True)), {"euler": "ZYX", "angle_unit": "deg"}), "in any order": ((T[::-1], Q[::-1]), {"sort": True}),
         "keys by their name": ((), {"keys": RECORDING})}


def found_by(result):
    """What does not depend on the order of the components, nor on the time that it took."""
    if isinstance(result, ori.Comparison):
        return [row["rms_deg"] for row in result.table()]
    rotations = np.roll(result.keys.rotations, -1, axis=1) if result.keys._scalar_first else result.keys.rotations
    return np.column_stack([result.keys.times, Rotation.from_quat(rotations).as_matrix().reshape(-1, 9)])


@pytest.mark.parametrize("form", FORMS)
@pytest.mark.parametrize("name", TASKS)
def test_every_form_gives_what_the_keys_give(name, form):
    task, more, options = TASKS[name]
    given, stated = FORMS[form]
    if name == "compare" and "sort" in stated:
        pytest.skip("here sort is the word of a measure")
    if "keys" in stated or not given or len(given) == 1 and not isinstance(given[0], tuple):
        stated, more = {**stated, **dict(zip({"reduce": ["tolerance"], "tune": ["method"], "compare": ["methods"]}.get(name, []), more))}, ()
    found, expected = task(*given, *more, **stated, **options), task(RECORDING, *TASKS[name][1], **options)
    assert type(found) is type(expected) and np.allclose(found_by(found), found_by(expected), atol=1e-6)


def test_several_tracks_and_two_recordings_are_pairs():
    assert [one.keys for one in ori.reduce_tracks([(T, R), RECORDING], "1deg")] == [ori.reduce(RECORDING, "1deg").keys] * 2
    by_keys = ori.align(ori.Keys(T + 0.25, R), RECORDING)
    for a, b in (((T + 0.25, Q), (T, Q)), ((T + 0.25, R), RECORDING)):
        found = ori.align(a, b)
        assert found.offset == by_keys.offset and found.apply((T + 0.25, R)) == found.keys
    gyro = ori.align((T + 0.25, RATES), (T, RATES))
    assert isinstance(gyro, ori.RateAlignment) and abs(gyro.offset - 0.25) < 1e-3 and isinstance(ori.align((T, RATES), (T, Q)), ori.RateAlignment)
    assert ori.tune(FEW, "quintic", objective="fit", reference=(T, R)).energy_after == ori.tune(FEW, "quintic", objective="fit", reference=RECORDING).energy_after
    rows = [ori.compare(FEW, ["slerp"], **how).table()[0] for how in ({"truth": (T, R)}, {"truth": RECORDING}, {"reference": (T, Q)}, {"reference": RECORDING})]
    assert len({(row["samples"], row["rms_deg"]) for row in rows}) == 1 and rows[0]["samples"] == len(RECORDING)


def test_a_gyro_is_a_pair():
    for gyro in ((T, RATES), (T.tolist(), RATES.tolist())):
        assert ori.smooth(T, R, gyro=gyro).noise == ori.smooth(RECORDING, gyro=ori.Rates(T, RATES)).noise


def test_a_mean_has_windows_of_times():
    for made in (ori.mean(T, R, every="1s"), ori.mean(T, np.roll(Q, 1, axis=1) * 2, every="1s", scalar_first=True, normalize=True)):
        assert [one.time for one in made] == [one.time for one in ori.mean(RECORDING, every="1s")] and len(made) == 5
    assert np.array_equal(ori.mean(T, R).orientation, ori.mean(R).orientation)


@pytest.mark.parametrize(("ask", "error", "text"), [
    (lambda: ori.smooth(RECORDING, positions=TURNS), TypeError, "positions: found positions beside Keys, wanted them with the Keys"),
    (lambda: ori.smooth(RECORDING, Q), TypeError, "rotations: found rotations beside Keys"),
    (lambda: ori.mean(RECORDING, Q), TypeError, "rotations: found rotations beside Keys"),
    (lambda: ori.smooth(T), TypeError, "keys: found ndarray, wanted Keys, or times and rotations"),
    (lambda: ori.smooth(), TypeError, "smooth: found no keys, wanted Keys"),
    (lambda: ori.smooth(RECORDING.curve()), TypeError, "keys: found Curve, wanted Keys, such as its .keys"),
    (lambda: ori.tune(T, "quintic"), TypeError, "keys: found ndarray, wanted Keys, or times"),
    (lambda: ori.retime(T, Q[:5], max_rate=1), ori.DataError, "rotations: found 5, wanted one for each of the 201 times"),
    (lambda: ori.align((T, Q), 3), TypeError, "b: found int, wanted Keys or Rates"),
    (lambda: ori.align((T, Q[:5]), (T, Q)), ori.DataError, "rotations: found 5"),
    (lambda: ori.reduce_tracks([(T, Q), T], "1deg"), TypeError, r"tracks\[1\]: found ndarray, wanted Keys"),
    (lambda: ori.compare(FEW, truth=RECORDING, reference=RECORDING), ori.ArgumentError, "truth: found it beside reference, wanted one of them"),
    (lambda: ori.smooth(T, Q, gyro=(T, RATES[:5])), ori.DataError, "rates: found 5 rows"),
    (lambda: ori.smooth(T[::-1], Q), ori.DataError, r"key 1: .*\(sort=True puts them in order\)"),
    (lambda: ori.smooth(T, 3 * Q), ori.DataError, "the quaternion has norm 3"),
    (lambda: ori.smooth(T, Q, nonsense=1), ori.Error, "nonsense")])
def test_what_makes_no_keys_is_told(ask, error, text):
    with pytest.raises(error, match=text):
        ask()
