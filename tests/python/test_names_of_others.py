# SPDX-License-Identifier: Apache-2.0
"""What people type who know SciPy, pandas or Polars: it is there, or the answer says what is."""
import copy
import pickle
import re
import sys
import weakref

import numpy as np
import orispline as ori
import pytest
from orispline._names import ELSEWHERE

T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
KEYS = ori.Keys(T, Q)
CURVE = KEYS.curve("timed-c2", tension=0.4)
RECORDING = ori.Keys(np.linspace(0, 2, 61), np.column_stack([0 * np.arange(61), 0 * np.arange(61), np.sin(np.linspace(0, 1, 61)), np.cos(np.linspace(0, 1, 61))]))


@pytest.fixture(scope="module")
def things():
    """One of each kind that the table of names has."""
    gyro = ori.Rates(RECORDING.times, np.column_stack([np.cos(3 * RECORDING.times), np.sin(2 * RECORDING.times), np.ones(61)]))
    return {"orispline": ori, "OrientationCurve": CURVE, "Keys": KEYS, "Samples": CURVE.sample(rate=2), "Result": ori.tune(KEYS, "quintic"),
            "Smoothing": ori.smooth(RECORDING, smoothing_time=0.1), "Reduction": ori.reduce(RECORDING, "1deg"), "Retiming": ori.retime(KEYS, max_rate=1),
            "Tuning": ori.tune(KEYS, "quintic"), "Alignment": ori.align(RECORDING, RECORDING, body_turn=False),
            "RateAlignment": ori.align(gyro, gyro), "Mean": ori.mean(Q[:2]), "Comparison": ori.compare(RECORDING, ["slerp"])}


@pytest.mark.parametrize("kind", ELSEWHERE)
def test_a_name_that_others_use_leads_to_ours(kind, things):
    thing = things[kind]
    for name, cure in ELSEWHERE[kind].items():
        with pytest.raises(AttributeError) as found:
            getattr(thing, name)
        assert str(found.value).endswith(f"has no attribute {name!r}, wanted {cure}") and found.value.name == name
        first = re.match(r"(?:orispline\.)?(\w+)", cure)[1]
        there = ori if kind == "orispline" or cure.startswith("orispline.") else thing
        assert hasattr(there, first) or first in {"keys", "samples", "str", "the", "Keys"}, f"{kind}.{name}: {first}"


@pytest.mark.parametrize(("kind", "typed", "meant"), [("orispline", "smoth", "smooth"), ("OrientationCurve", "sampel", "sample"), ("Keys", "rotation", "rotations"),
                                                      ("Samples", "orientation", "orientations"), ("Smoothing", "cutof", "cutoff"),
                                                      ("Alignment", "ofset", "offset"), ("Mean", "certfied", "certified"), ("Comparison", "tabel", "table")])
def test_a_name_that_is_spelt_wrong_leads_to_the_right_one(kind, typed, meant, things):
    with pytest.raises(AttributeError, match=f"has no attribute {typed!r}; did you mean .*{meant!r}"):
        getattr(things[kind], typed)
    assert not hasattr(things[kind], "quite_another_thing") and not hasattr(things[kind], "_of_python")


def test_objects_are_copied_and_pickled_all_the_same(things):
    for thing in list(things.values())[1:]:
        copy.copy(thing), copy.deepcopy(thing), pickle.loads(pickle.dumps(thing))


def test_curves_are_equal_where_they_are_made_of_the_same():
    again = ori.Curve(T, Q, "timed-c2", tension=0.4)
    assert again == CURVE and hash(again) == hash(CURVE) and {CURVE: 1}[again] == 1 and pickle.loads(pickle.dumps(CURVE)) == CURVE
    own = ori.blending("mine", [["0", "1-a", "1"]], parameters={"lag": 0})
    assert KEYS.curve(own) == KEYS.curve(own) != KEYS.curve(ori.blending("mine", [["0", "1-a/2", "1-a/2", "1"]], parameters={"lag": 0}))
    others = [KEYS.curve("timed-c2"), KEYS[:2].curve("timed-c2", tension=0.4), KEYS.curve("timed-c2", tension=0.4, ends="rest"),
              KEYS.curve("timed-c2", tension=0.4, extrapolate="nan"), KEYS.curve("timed-c2", tension=0.4, extrapolate="leave-out"), KEYS, 3]
    assert all(other != CURVE for other in others) and others[3] != others[4]
    slow, slower = ori.Curve([0, 2, 3], Q), ori.Curve([0, 2.5, 3], Q)
    assert CURVE * slow == again * slow and hash(CURVE * slow) == hash(again * slow) and CURVE.inv() == again.inv() and CURVE.inv().inv() == CURVE
    assert len({CURVE * slow, slow * CURVE, CURVE * slower, CURVE.inv(), slow.inv(), CURVE}) == 6


def test_objects_may_be_referred_to_weakly():
    for thing in (ori.Keys(T, Q), ori.Curve(T, Q), ori.CurveStack(T, [[q] for q in Q]), CURVE.sample(rate=1), CURVE.inv()):
        assert weakref.ref(thing)() is thing


def test_a_curve_is_asked_by_a_name_too():
    t = np.linspace(-1, 4, 7)
    for curve in (CURVE, ori.Curve(T, np.roll(Q, 1, axis=1), scalar_first=True)):
        assert np.array_equal(curve.at(t), curve(t)) and np.array_equal(curve.at(0.5), curve(0.5))
        assert curve.at(t, out=np.empty((7, 4), np.float32), dtype="float32").dtype == "float32"


@pytest.mark.parametrize(("package", "needed"), [("tables", "pyarrow"), ("spark", "pyspark"), ("notebook", "anywidget")])
def test_packages_are_there_when_they_are_first_used(package, needed, monkeypatch):
    with monkeypatch.context() as without:
        without.delattr(ori, package, raising=False)
        for name in [name for name in sys.modules if name.startswith(f"orispline.{package}")]:
            without.delitem(sys.modules, name)
        without.setitem(sys.modules, needed, None)
        with pytest.raises(ImportError, match=f"^orispline.{package}: found no {needed}, wanted it installed: pip install 'orispline"):
            getattr(ori, package)
    pytest.importorskip(needed)
    assert getattr(ori, package).__name__ == f"orispline.{package}" and package in dir(ori)
