# SPDX-License-Identifier: Apache-2.0
"""Results and options of tasks as Python objects."""
import copy
import dataclasses
import inspect
import json
import pickle
import re
import warnings

import numpy as np
import orispline as ori
import pytest
from task_files import EXAMPLES, json_of, keys_in, run

FLIGHT = EXAMPLES / "flight_keys.csv"


def results():
    keys = keys_in(FLIGHT)
    recording = keys_in(EXAMPLES / "flight_truth.csv")[:600]
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ori.ShapeWarning)
        return [ori.smooth(recording), ori.reduce(recording, "1deg"), ori.tune(keys, "quintic"),
                ori.retime(keys, max_rate="60deg/s", max_acceleration=(2, 2, 2))]


@pytest.mark.parametrize("task, result", [("smooth", ori.Smoothing), ("reduce", ori.Reduction), ("retime", ori.Retiming),
                                          ("tune", ori.Tuning), ("align", ori.Alignment)])
def test_fields_are_those_of_the_library(task, result):
    told, = (entry for entry in json.loads(run("tasks", "--json")[0]) if entry["task"] == task)
    units = "(_(rad|s|hz|deg|m|rad_s|rad_s2))?$"
    names = {field.name.rstrip("_") for field in dataclasses.fields(result)}
    for field in told["results"]:
        name = field["name"]
        assert name in names | {"keys"} or re.sub(units, "", name) in names, name
        assert field["sentence"] in result.__doc__ or name == "keys"
    function = getattr(ori, task)
    for option in told["options"]:
        assert option["sentence"] in function.__doc__
        assert option["name"] in inspect.signature(function).parameters


def test_results_do_not_change():
    for result in results():
        with pytest.raises(dataclasses.FrozenInstanceError):
            result.keys = None
        with pytest.raises(dataclasses.FrozenInstanceError):
            del result.method
        result.as_dict().clear()
        assert result.as_dict()
        assert repr(result).startswith(f"{type(result).__name__}(Keys(")


def test_results_are_the_same_after_pickling():
    for result in results():
        for again in (pickle.loads(pickle.dumps(result, 5)), copy.copy(result), copy.deepcopy(result)):
            assert again.as_dict() == result.as_dict()
            assert again.method == result.method
            assert np.array_equal(again.keys.rotations, result.keys.rotations)
            assert again.curve(1.23).tolist() == result.curve(1.23).tolist()
    comparison = ori.compare(keys_in(FLIGHT), ["slerp", "auto"], keep_every=2)
    again = pickle.loads(pickle.dumps(comparison))
    assert again.table() == comparison.table()
    assert again.curve(0)(1.0).tolist() == comparison.curve(0)(1.0).tolist()


@pytest.mark.parametrize("text, number", [
    ({"max_rate": "90deg/s"}, {"max_rate": np.radians(90)}), ({"max_rate": "1.5rad/s"}, {"max_rate": 1.5}),
    ({"max_rate": "1,2,1.5rad/s"}, {"max_rate": np.array([1, 2, 1.5])}), ({"duration": "20min"}, {"duration": 1200}),
    ({"max_torque": "2Nm", "inertia": "1,2,3,0.1,0,0"},
     {"max_torque": np.float32(2), "inertia": [[1, 0.1, 0], [0.1, 2, 0], [0, 0, 3]]}),
    ({"max_rate": "1rad/s", "slowing": "per-interval"}, {"max_rate": 1, "per_interval": True})])
def test_texts_with_units_and_plain_numbers_say_the_same(text, number):
    keys = keys_in(FLIGHT)
    said, stated = ori.retime(keys, **text), ori.retime(keys, **number)
    assert said.keys.times == pytest.approx(stated.keys.times, rel=1e-12)


def test_times_and_orders_are_those_of_the_keys():
    seconds = keys_in(EXAMPLES / "flight_truth.csv")[:800]
    stamps = np.datetime64("2024-03-01T12:00:00", "ns") + (seconds.times * 1e9).round().astype("timedelta64[ns]")
    calendar = ori.Keys(stamps, seconds.rotations[:, [3, 0, 1, 2]], positions=seconds.positions, scalar_first=True)
    plain, dated = ori.reduce(seconds, "1deg"), ori.reduce(calendar, "1deg")
    assert dated.error_max_time == stamps[0] + np.timedelta64(round(plain.error_max_time * 1e9), "ns")
    assert np.array_equal(dated.keys.times, stamps[plain.samples])
    assert np.array_equal(dated.keys.rotations[:, 0], plain.keys.rotations[:, 3])
    # A reference with a calendar of its own, and another first time.
    tuned = ori.tune(calendar[::40], "tcb", objective="fit", reference=calendar[3:])
    bare = ori.tune(seconds[::40], "tcb", objective="fit", reference=seconds[3:])
    assert tuned.energy_after == pytest.approx(bare.energy_after, rel=1e-6)
    rows = ori.compare(calendar[::40], "auto", reference=calendar[3:]).table()
    assert rows[0]["rms_deg"] == pytest.approx(
        ori.compare(seconds[::40], "auto", reference=seconds[3:]).table()[0]["rms_deg"], rel=1e-6)
    with pytest.raises(ori.ArgumentError, match="reference: found an array of float64, wanted datetime64"):
        ori.tune(calendar[::40], "tcb", objective="fit", reference=seconds)


def test_warnings_are_the_librarys_and_of_the_callers_line():
    keys = keys_in(EXAMPLES / "robot_keys.csv")
    with pytest.warns(ori.ShapeWarning) as caught:
        ori.retime(keys, max_rate="90deg/s", method="timed-c2")
    assert caught[0].message.code == "moving_rests" and caught[0].message.numbers["rests"] > 0
    assert caught[0].filename == __file__
    said = run("retime", EXAMPLES / "robot_keys.csv", "--max-rate", "90deg/s", "--method", "timed-c2", "-o", "/dev/null")[1]
    assert re.sub(r"`\w+`", "", str(caught[0].message)).split(",")[0] in said


def data_of(page):
    """What a page shows, but for how and when it was made."""
    text = re.search(r'<script[^>]*type="application/json"[^>]*>(.*?)</script>', page, re.S)[1]
    data = json.loads(text)
    for name in ("command", "date", "title", "notes"):
        data.get("head", data).pop(name, None)
    return data


@pytest.mark.parametrize("words, make", [
    ("smooth {}", lambda keys: ori.smooth(keys)),
    ("reduce {} --tolerance 1deg", lambda keys: ori.reduce(keys, "1deg")),
    ("retime {} --max-rate 60deg/s", lambda keys: ori.retime(keys, max_rate="60deg/s"))])
@pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
def test_pages_are_those_of_the_command(words, make, tmp_path):
    mine, its = tmp_path / "mine.html", tmp_path / "its.html"
    pickle.loads(pickle.dumps(make(keys_in(FLIGHT)))).report(mine)
    run(*words.format(FLIGHT).split(), "--quiet", "-o", tmp_path / "out.csv", "--report", its)
    assert data_of(mine.read_text("utf-8")) == data_of(its.read_text("utf-8"))


def test_page_of_a_comparison_is_written_or_says_why_not(tmp_path):
    comparison = ori.compare(keys_in(FLIGHT), ["slerp", "auto"], keep_every=2)
    comparison.report(tmp_path / "page.html")
    page = (tmp_path / "page.html").read_text("utf-8")
    assert {method["name"] for method in data_of(page)["methods"]} == {"slerp", "auto"}
    with pytest.raises(ori.AccessError) as caught:
        comparison.report(tmp_path / "none" / "page.html")
    assert "none" in str(caught.value)


def test_members_of_a_comparison_with_the_command():
    assert set(ori.compare(keys_in(FLIGHT), "auto", keep_every=2).table()[0]) == \
        set(json_of("compare", FLIGHT, "--methods", "auto", "--keep-every", "2")[0])


def test_keys_of_a_task_know_their_method():
    tuning = ori.tune(ori.read(EXAMPLES / "flight_keys.csv"), "quintic")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        assert tuning.curve.method.startswith("quintic:tension=")
        assert tuning.keys.curve().method == tuning.curve.method
    with pytest.warns(ori.ShapeWarning, match="^these keys are for quintic, and they are used for auto$"):
        ori.Curve(tuning.keys, method="auto")
