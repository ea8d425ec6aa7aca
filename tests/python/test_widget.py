# SPDX-License-Identifier: Apache-2.0
"""The widget of notebooks: what Python shares with the page, and what an edit does."""
import json

import numpy as np
import orispline as ori
import pytest

pytest.importorskip("anywidget", reason="no anywidget, which the widget is made with")
from orispline.notebook import Widget  # noqa: E402

T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
KEYS = ori.Keys(T, Q)


def edit(widget, number=1, **words):
    """As the page does it; what it is told."""
    widget.page.edit = {"number": number, "version": widget.page.version, **words}
    assert widget.page.answered == number
    return widget.page.refusal


def typed(widget, key):
    """The texts of a row."""
    rows = np.frombuffer(widget.page.rows, "<f8").reshape(-1, widget.page.width)
    t, *numbers = map(repr, rows[key].tolist())
    return {"key": key, "t": t, "q": numbers[:4], "p": numbers[4:]}


@pytest.fixture
def widget():
    made = Widget(KEYS)
    made.heard = []
    made.observe(lambda change: made.heard.append((change.old, change.new)), names="keys")
    return made


def test_the_page_has_the_document_of_the_curve_and_the_rows_of_the_keys(widget):
    document = json.loads(widget.page.document)
    assert [method["name"] for method in document["methods"]] == ["auto"] and document["title"] == "auto, 3 keys"
    assert np.array_equal(np.frombuffer(widget.page.rows).reshape(3, 5), [[t, q[3], *q[:3]] for t, q in zip(T, Q)])
    placed = Widget(ori.Keys(T, Q, positions=np.eye(3)), "slerp", title="Placed", height=300)
    assert placed.page.width == 8 and placed.page.height == 300 and json.loads(placed.page.document)["title"] == "Placed"
    assert placed.curve.method == "slerp" and repr(placed).startswith("Widget(Curve('slerp', 3 keys")


def test_an_edited_key_arrives(widget):
    assert edit(widget, **{**typed(widget, 1), "kind": "set", "t": "1.5", "q": ["2", "0", "0", "2"]}) == ""
    (old, new), = widget.heard
    assert old == KEYS and new is widget.keys and widget.curve.keys is new
    assert new.times.tolist() == [0, 1.5, 3] and np.allclose(new.rotations[1], [0, 0, 0.5**0.5, 0.5**0.5], atol=1e-15)
    assert np.array_equal(new.rotations[[0, 2]], KEYS.rotations[[0, 2]])
    assert json.loads(widget.page.document)["keys"]["t"] == [0, 1.5, 3]


def test_a_key_that_passes_another_one_stands_behind_it(widget):
    assert edit(widget, **{**typed(widget, 1), "kind": "set", "t": "4"}) == ""
    assert widget.keys.times.tolist() == [0, 3, 4] and np.array_equal(widget.keys.rotations, np.array(Q)[[0, 2, 1]])


def test_a_key_is_added_where_the_curve_is_and_deleted(widget):
    wanted = widget.curve(2.0)
    assert edit(widget, kind="add", t=2.0) == ""
    assert widget.keys.times.tolist() == [0, 1, 2, 3] and np.allclose(widget.keys.rotations[2], wanted, atol=1e-15)
    assert edit(widget, number=2, kind="delete", key=2) == "" and widget.keys == KEYS and len(widget.heard) == 2


@pytest.mark.parametrize("extrapolate", ["hold", "error", "nan", "rate"])
def test_a_key_is_added_beyond_the_end(extrapolate):
    beyond = Widget(ori.Curve(T, Q, extrapolate=extrapolate))
    assert edit(beyond, kind="add", t=5.0) == "" and beyond.keys.times.tolist() == [0, 1, 3, 5]
    assert np.allclose(beyond.keys.rotations[3], Q[2], atol=1e-15)


BAD = [({"kind": "set", "key": 1, "t": "nan", "q": ["1", "0", "0", "0"]}, "time"),
       ({"kind": "set", "key": 1, "t": "3", "q": ["1", "0", "0", "0"]}, "duplicate time 3"),
       ({"kind": "set", "key": 1, "t": "1", "q": ["0", "0", "0", "0"]}, "key 1: "),
       ({"kind": "set", "key": 1, "t": "1", "q": ["1", "nan", "0", "0"]}, "key 1: "),
       ({"kind": "set", "key": 1, "t": "1", "q": ["1", "inf", "0", "0"]}, "key 1: "),
       ({"kind": "set", "key": 1, "t": "soon", "q": ["1", "0", "0", "0"]}, "t: found 'soon', wanted a number"),
       ({"kind": "set", "key": 1, "t": "1", "q": ["1", "", "0", "0"]}, "qx: found '', wanted a number"),
       ({"kind": "set", "key": 1, "t": "1", "q": ["1", "0"]}, "qw, qx, qy, qz: found ['1', '0'], wanted 4 numbers"),
       ({"kind": "set", "key": 3, "t": "1", "q": ["1", "0", "0", "0"]}, "key: found 3, wanted a whole number from 0 to 2"),
       ({"kind": "add", "t": 1.0}, "duplicate time 1"), ({"kind": "add"}, "t: found None, wanted a number"),
       ({"kind": "delete", "key": -1}, "key: found -1"), ({"kind": "turn"}, "kind: found 'turn', wanted 'set', 'add' or 'delete'")]


@pytest.mark.parametrize(("words", "told"), BAD)
def test_a_bad_edit_is_told_and_leaves_all_as_it_was(widget, words, told):
    document = widget.page.document
    refusal = edit(widget, **words)
    assert told in refusal and "\n" not in refusal
    assert widget.heard == [] and widget.keys is KEYS and widget.page.document == document
    assert edit(widget, number=2, kind="delete", key=2) == ""


def test_an_edit_of_keys_that_have_changed_since_is_asked_for_again(widget):
    version = widget.page.version
    widget.keys = KEYS[:2]
    assert edit(widget, version=version, kind="delete", key=0) == "found an edit of keys that have changed since, wanted it again"
    assert len(widget.keys) == 2


def test_the_last_key_stays(widget):
    one = Widget(KEYS[:1])
    assert edit(one, kind="delete", key=0).startswith("found the only key, wanted another one") and len(one.keys) == 1


def test_what_keys_carry_goes_with_them():
    rates = np.arange(9.0).reshape(3, 3)
    keys = ori.Keys(T, Q, positions=np.eye(3), angular_velocities=rates, settings={"tension": [0.1, 0.2, 0.3]}, scalar_first=False)
    widget = Widget(keys, "hermite-c1")
    where = widget.curve.position(2.0)
    assert edit(widget, kind="add", t=2.0) == ""
    found = widget.keys
    assert np.array_equal(found.angular_velocities[[0, 1, 3]], rates) and np.isnan(found.angular_velocities[2]).all()
    assert found.settings == {"tension": [0.1, 0.2, 0.2, 0.3]} and np.allclose(found.positions[2], where)
    assert edit(widget, number=2, **{**typed(widget, 3), "kind": "set", "t": "0.5", "p": ["7", "8", "9"]}) == ""
    assert widget.keys.times.tolist() == [0, 0.5, 1, 2] and widget.keys.positions[1].tolist() == [7, 8, 9]
    assert np.array_equal(widget.keys.angular_velocities[1], rates[2])


def test_python_sets_keys_and_curves(widget):
    widget.keys = KEYS[:2]
    assert len(widget.curve.keys) == 2 and json.loads(widget.page.document)["keys"]["t"] == [0, 1]
    widget.curve = KEYS[:2].curve("slerp", extrapolate="nan")
    assert json.loads(widget.page.document)["methods"][0]["name"] == "slerp"
    assert edit(widget, kind="add", t=0.5) == "" and widget.curve.method == "slerp" and np.isnan(widget.curve(5.0)).all()
    for name, wrong, error, told in (("keys", 3, TypeError, "keys: found 3 of type int, wanted Keys"), ("curve", KEYS, TypeError, "wanted a Curve"),
                                     ("time", np.datetime64("2026-01-01"), ori.ArgumentError, "time: found")):
        with pytest.raises(error, match=told):
            setattr(widget, name, wrong)
    assert len(widget.keys) == 3


def test_the_time_is_shared(widget):
    heard = []
    widget.observe(lambda change: heard.append(change.new), names="time")
    widget.page.seconds = 2.5
    assert widget.time == 2.5 and heard == [2.5]
    widget.time = 99
    assert widget.page.seconds == widget.time == 3.0
    widget.keys = KEYS[:2]
    assert widget.time == 1.0


def test_times_that_are_dates():
    days = np.array(["2026-01-01T00:00:00", "2026-01-01T00:00:01", "2026-01-01T00:00:03"], "datetime64[s]")
    widget = Widget(ori.Keys(days, Q, scalar_first=False))
    assert widget.time == days[0]
    widget.page.seconds = 0.1 + 0.2
    assert widget.time == np.datetime64("2026-01-01T00:00:00.300000000") and widget.page.seconds == 0.1 + 0.2
    assert edit(widget, kind="add", t=2.0) == "" and widget.keys.times[2] == np.datetime64("2026-01-01T00:00:02")
    assert "2026-01-01T00:00:03" in edit(widget, number=2, **{**typed(widget, 1), "kind": "set", "t": "3"})


def test_what_is_no_curve_has_no_widget():
    for wrong in (3, [KEYS], None):
        with pytest.raises(TypeError, match="wanted Keys or a Curve"):
            Widget(wrong)
    with pytest.raises(ori.ArgumentError, match="height: found 5"):
        Widget(KEYS, height=5)
    with pytest.raises(ori.ArgumentError, match="nonsense"):
        Widget(KEYS, "nonsense")


def test_a_curve_gives_its_widget():
    curve = ori.Curve(T, Q, "slerp")
    widget = curve.widget(height=200, title="Here")
    assert isinstance(widget, Widget) and widget.curve is curve and widget.page.height == 200
    assert "application/vnd.jupyter.widget-view+json" in widget._repr_mimebundle_()[0]
