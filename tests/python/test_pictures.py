# SPDX-License-Identifier: Apache-2.0
"""Pictures: what their lines hold, and that they can be drawn without a screen."""
import json
import os
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree as ElementTree

import numpy as np
import orispline as ori
import pytest
from page_data import data_of
from orispline._command import COMMAND
from scipy.spatial.transform import Rotation

matplotlib = pytest.importorskip("matplotlib")
matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

EXAMPLES = pathlib.Path(__file__).resolve().parents[2] / "examples/data"
QUANTITIES = ("angle", "rate", "acceleration", "jerk")


@pytest.fixture(autouse=True)
def _no_figures_are_left(tmp_path):
    """Every figure of a test can be rendered; PICTURES=FOLDER keeps them."""
    yield
    test = os.environ["PYTEST_CURRENT_TEST"].split("::")[1].split()[0]
    for number in pyplot.get_fignums():
        picture = pathlib.Path(os.environ.get("PICTURES", tmp_path)) / f"{test}-{number}.png"
        pyplot.figure(number).savefig(picture, dpi=70)
        assert picture.read_bytes().startswith(b"\x89PNG") and picture.stat().st_size > 5000
    pyplot.close("all")


@pytest.fixture
def curve(keys):
    return ori.Curve(*keys)


def line_of(axes, number=0):
    return axes.get_lines()[number].get_data()


def test_charts_hold_what_the_curve_is(curve):
    charts = curve.plot()
    assert [chart.get_ylabel().replace("\n", " ") for chart in charts] == [
        "angle from the start [deg]", "angular velocity |ω| [rad/s]", "angular acceleration |α| [rad/s²]",
        "angular jerk [rad/s³]"]
    assert charts[-1].get_xlabel() == "time [s]" and all(len(chart.get_lines()) == 1 for chart in charts)
    t, angles = line_of(charts[0])
    assert t[0] == curve.domain[0] and t[-1] == curve.domain[1] and len(t) > 2000
    wanted = (curve.rotation(curve.domain[0]).inv() * curve.rotation(t)).magnitude()
    assert np.allclose(angles, np.degrees(wanted), atol=1e-5)
    between = np.abs(t[:, None] - curve.times).min(axis=1) > 1e-9
    for chart, name in zip(charts[1:], ("angular_velocity", "angular_acceleration", "angular_jerk")):
        t, values = line_of(chart)
        assert np.allclose(values[between], np.linalg.norm(getattr(curve, name)(t[between]), axis=1), rtol=1e-9, atol=1e-9)
        marks, = chart.collections
        assert np.array_equal(np.array(marks.get_segments())[:, 0, 0], curve.times)


def test_lines_have_the_colours_and_widths_of_the_page(keys):
    table = json.loads((pathlib.Path(ori.__file__).parent / "look.json").read_text("utf-8"))
    curves = [ori.Curve(*keys, method) for method in ("auto", "slerp", "squad")]
    wanted = [(table["light"]["first"], table["widths"]["first"]), (table["light"]["second"], table["widths"]["second"]),
              (table["further"][0], table["widths"]["second"])]
    charts = ori.plot_comparison(curves, curves[0])
    for chart in [*charts, ori.plot_sphere(curves)]:
        assert [(line.get_color(), line.get_linewidth()) for line in chart.get_lines() if line.get_label()[0] != "_"] == wanted
    assert [chart.get_ylabel().replace("\n", " ") for chart in charts] == [
        f"{table['quantities'][word]['title']} [{table['quantities'][word]['unit']}]" for word in ("error", "angle", "rate", "acceleration")]
    svg = curves[0]._repr_svg_()
    assert all(f">{row['title']} [{row['unit']}]<" in svg for word, row in table["quantities"].items() if word in QUANTITIES)


def test_in_the_axes_of_others_are_as_many_charts_as_these():
    words = [chart.get_ylabel() for chart in CURVE.plot()]
    for names in ({"axes": pyplot.subplots()[1]}, {"ax": pyplot.subplots()[1]}, {"axes": pyplot.subplots(2)[1]}, {"ax": pyplot.subplots(1, 3)[1]}):
        given = np.atleast_1d(next(iter(names.values())))
        charts = CURVE.plot(**names)
        assert list(charts) == list(given) and [chart.get_ylabel() for chart in charts] == words[:len(given)]
    axes = pyplot.subplots(2)[1]
    assert [chart.get_ylabel() for chart in ori.plot_comparison([CURVE], CURVE.keys, ax=axes)][1] == words[0]
    assert len(CURVE.plot(axes, ghosts=3)) == 2 and CURVE.plot_sphere(ax=pyplot.figure().add_subplot(projection="3d")) is not None
    assert CURVE.plot(ax=axes[0], quantities="jerk")[0].get_ylabel() == words[3]


def test_axes_of_others_keep_their_colours(keys):
    own = pyplot.figure().add_subplot()
    own.set_prop_cycle(color=["#111111", "#222222"])
    for method in ("auto", "slerp"):
        ori.Curve(*keys, method).plot(own, "rate")
    assert [line.get_color() for line in own.get_lines()] == ["#111111", "#222222"]


def test_ghosts_are_the_bodies_of_the_command_below_the_charts(keys, curve):
    charts = curve.plot(ghosts=7)
    assert len(charts) == 5 and charts[-1].get_ylabel() == "the body at\n7 even times" and charts[-1].get_xlabel() == "time [s]"
    bodies, = (c for c in charts[-1].collections if type(c).__name__ == "PolyCollection")
    places = np.asarray(bodies.get_offsets())
    assert places.shape == (21, 2) and np.allclose(places[:, 0], np.repeat(np.linspace(*curve.domain, 7), 3), atol=1e-12)
    corners = np.array([path.vertices[:3] for path in bodies.get_paths()]).reshape(7, 9, 2)
    eye = np.array([1, -0.9, 0.8]) / np.linalg.norm([1, -0.9, 0.8])
    right = np.cross([0, 0, 1], eye) / np.linalg.norm(np.cross([0, 0, 1], eye))
    nose = curve.rotation(np.linspace(*curve.domain, 7)).apply([1, 0, 0]) @ np.stack([right, np.cross(eye, right)], axis=1)
    size = min(0.33, 0.55 * charts[-1].bbox.width / charts[-1].figure.dpi / 7)
    for body, tip in zip(corners, nose):
        assert np.abs(body / size - tip).max(axis=1).min() < 1e-12
    two = ori.plot_comparison([curve, ori.Curve(*keys, "slerp")], quantities="rate", ghosts=3)
    assert len(two) == 2 and two[-1].get_ylim() == (-1.5, 0.5)
    dates = ori.Curve(np.datetime64("2026-11-22T12:00") + (keys[0] * 1e9).astype("timedelta64[ns]"), keys[1], extrapolate="error")
    assert dates.plot(quantities="rate", ghosts=2)[-1].get_xlabel() == "time"
    for wrong, told in ((1, "ghosts: found 1, wanted a whole number from 2 to 60, or 0 for none"),
                        (61, "ghosts: found 61, wanted a whole number from 0 to 60")):
        with pytest.raises(ori.ArgumentError, match=told):
            curve.plot(ghosts=wrong)


def test_both_sides_of_a_jump_are_drawn(keys):
    curve = ori.Curve(*keys, "slerp")
    chart, = curve.plot(quantities="rate")
    t, rate = line_of(chart)
    steps = (Rotation.from_quat(keys[1][:-1]).inv() * Rotation.from_quat(keys[1][1:])).magnitude() / np.diff(keys[0])
    for k in range(1, len(keys[0]) - 1):
        both = rate[t == keys[0][k]]
        assert np.allclose(both, steps[k - 1 : k + 1], rtol=1e-9)


def test_charts_go_where_they_are_asked_to(curve):
    _, axes = pyplot.subplots(1, 2)
    charts = curve.plot(axes, quantities=["jerk", "angle"])
    assert charts[0] is axes[0] and charts[1] is axes[1] and axes[0].get_ylabel() == "angular jerk\n[rad/s³]"
    single = pyplot.figure().add_subplot()
    assert curve.plot(single, "rate")[0] is single


def test_very_many_keys_are_not_marked_and_no_peak_is_missed():
    times = np.arange(20000.0)
    rotations = Rotation.from_rotvec(np.outer(np.sin(times / 50), [0, 0, 1]))
    curve = ori.Curve(times, rotations.as_quat())
    chart, = curve.plot(quantities="acceleration")
    assert not chart.collections and len(line_of(chart)[0]) < 10000
    assert line_of(chart)[1].max() == pytest.approx(curve.peaks().angular_acceleration.value, rel=1e-3)


def test_calendars_have_dates_on_their_axis(keys):
    dates = np.datetime64("2026-11-22T12:00") + (keys[0] * 1e9).astype("timedelta64[ns]")
    chart, = ori.Curve(dates, keys[1]).plot(quantities="rate")
    assert chart.get_xlabel() == "time" and line_of(chart)[0].dtype == "datetime64[ns]"
    chart, = ori.Curve(np.arange(40), keys[1], time_unit="ms").plot(quantities="rate")
    assert chart.get_xlabel() == "time [ms]" and line_of(chart)[0][-1] == pytest.approx(39)


def test_a_comparison_with_a_curve_and_with_a_recording(keys):
    names = ("auto", "slerp", "squad")
    curves = {name: ori.Curve(*keys, name) for name in names}
    truth = ori.Curve(*keys, "timed-c2")
    charts = ori.plot_comparison(curves, truth)
    assert [chart.get_ylabel() for chart in charts][:2] == ["angle to the reference\n[deg]", "angle from the start\n[deg]"]
    assert [text.get_text() for text in charts[0].get_legend().get_texts()] == list(names) and len(charts[0].collections) == 1
    recorded = np.linspace(keys[0][0] - 1, keys[0][-1] + 1, 700)
    recording = ori.Keys(recorded, truth(recorded))
    for axes in (charts, ori.plot_comparison(list(curves.values()), recording)):
        for number, name in enumerate(names):
            t, errors = line_of(axes[0], number)
            wanted = (curves[name].rotation(t).inv() * truth.rotation(t)).magnitude()
            assert np.allclose(errors, np.degrees(wanted), atol=2e-6), name
            assert t[0] >= keys[0][0] and t[-1] <= keys[0][-1] and errors.max() > 0.1
    only, = ori.plot_comparison(curves["auto"], truth, quantities=())
    assert only.get_ylabel() == "angle to the reference\n[deg]" and only.get_legend() is None


def test_a_comparison_in_another_order_of_quaternions(keys):
    times, rotations = keys
    plain, first = ori.Curve(times, rotations), ori.Curve(times, rotations[:, [3, 0, 1, 2]], "slerp", scalar_first=True)
    for one, other in ((plain, first), (first, plain), (plain, first.keys), (first, plain.keys)):
        chart, = ori.plot_comparison(one, other, quantities=())
        t, errors = line_of(chart)
        same = first if one is plain else plain
        wanted = np.degrees((one.rotation(t).inv() * same.rotation(t)).magnitude())
        assert np.allclose(errors, wanted, atol=2e-6)


def test_a_sphere_has_the_path_and_the_keys(keys):
    curves = [ori.Curve(*keys), ori.Curve(*keys, "slerp"), ori.Curve(*keys, "slerp")]
    for axis, direction in (("x", [1, 0, 0]), ("z", [0, 0, 1]), ([1, 2, 2], [1 / 3, 2 / 3, 2 / 3])):
        axes = ori.plot_sphere(curves[:2], axis)
        paths = [np.array(line.get_data_3d()).T for line in axes.get_lines()]
        assert len(paths) == 2 and all(np.allclose(np.linalg.norm(path, axis=1), 1) for path in paths)
        dots = np.array(axes.collections[-1]._offsets3d).T
        assert np.allclose(dots, Rotation.from_quat(keys[1]).apply(direction), atol=1e-12)
        assert np.allclose(paths[0][0], dots[0]) and np.allclose(paths[0][-1], dots[-1])
    assert axes.get_title() == "body axis (1, 2, 2) on the unit sphere"
    assert [text.get_text() for text in ori.plot_sphere(curves).get_legend().get_texts()] == ["auto", "slerp", "slerp (3)"]
    own = pyplot.figure().add_subplot(projection="3d")
    assert curves[0].plot_sphere("y", own) is own


def test_the_drawing_of_a_notebook_is_that_of_the_command():
    words = [COMMAND, "plot", EXAMPLES / "five_keys.csv"]
    text = subprocess.run(words, check=True, capture_output=True, encoding="utf-8").stdout
    with open(EXAMPLES / "five_keys.csv", encoding="utf-8") as file:
        table = np.genfromtxt((line for line in file if not line.startswith("#")), delimiter=",", names=True)
    svg = ori.Curve(table["t"], np.stack([table[c] for c in ("qx", "qy", "qz", "qw")], axis=1))._repr_svg_()
    ElementTree.fromstring(svg)
    title = re.search(r">([^<]*5 keys[^<]*)<", svg)[1]
    assert title == f"5 keys, {table['t'][0]:g} … {table['t'][-1]:g} s"
    assert svg.replace(title, "") == text.replace(re.search(r">([^<]*5 keys[^<]*)<", text)[1], "")


def test_a_drawing_needs_no_matplotlib():
    program = ("import orispline as ori, sys; ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]])._repr_svg_(); "
               "assert not {'matplotlib', 'scipy', 'tempfile', 'webbrowser'} & set(sys.modules), sys.modules.keys()")
    subprocess.run([sys.executable, "-c", program], check=True)


def test_without_matplotlib_the_cure_is_named():
    program = ("import sys; sys.modules['matplotlib'] = None\nimport orispline as ori\n"
               "try: ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]]).plot()\n"
               "except ModuleNotFoundError as error: print(error)")
    told = subprocess.run([sys.executable, "-c", program], check=True, capture_output=True, text=True).stdout
    assert told == "found no matplotlib, wanted it for charts: pip install 'orispline[plot]'\n"


def test_one_key_has_pictures_too(tmp_path):
    curve = ori.Curve([5.0], [[0, 0, 0.6, 0.8]])
    assert line_of(curve.plot()[1])[1].tolist() == [0.0]
    assert len(curve.plot_sphere().get_lines()) == 1 and ">1 key, 5 … 5 s<" in curve._repr_svg_()
    curve.report(tmp_path / "page.html")
    assert '"auto, 1 key"' in (tmp_path / "page.html").read_text("utf-8")


def test_a_page_holds_the_motion_and_its_measures(curve, tmp_path, monkeypatch):
    path = tmp_path / "motion.html"
    curve.report(path, title="A <turn>", inertia=[1.0, 2.0, 2.5])
    page = path.read_text("utf-8")
    told = data_of(page)
    assert told["title"] == "A <turn>" and told["version"] == ori.__version__ and told["command"] == ""
    assert re.fullmatch(r"\d{4}-\d\d-\d\d \d\d:\d\d", told["date"]) and told["time_start"] == "0"
    method, = told["methods"]
    assert method["name"] == "auto" and method["continuity"] == "C2" and told["reference"] is None
    peaks = curve.peaks([1.0, 2.0, 2.5])
    assert method["measures"]["peak_rate_rad_s"] == pytest.approx(peaks.angular_velocity.value, rel=1e-6)
    assert method["measures"]["peak_torque_n_m"] == pytest.approx(peaks.torque.value, rel=1e-6)
    samples = method["samples"]
    t, rates = np.array(samples["t"]), np.reshape(samples["w"], (-1, 3))
    between = np.abs(t[:, None] - curve.times).min(axis=1) > 1e-5
    assert np.allclose(rates[between], curve.angular_velocity(t[between]), rtol=1e-3, atol=1e-4)
    assert len(samples["torque"]) == len(samples["w"])
    assert len(told["keys"]["t"]) == 40
    monkeypatch.chdir(tmp_path)
    curve.report("-")
    assert (tmp_path / "-").read_text("utf-8").startswith("<!")


def test_a_page_says_when_it_begins(keys, tmp_path):
    nanoseconds = np.round((keys[0] - keys[0][0]) * 1e9).astype(np.int64)
    dates = np.datetime64("2026-11-22T12:00:00.000000007") + nanoseconds.astype("timedelta64[ns]")
    for times, unit, start in ((dates, None, f"{dates[0].astype(np.int64) // 10**9}.000000007"),
                               (np.arange(40) + 1500, "ms", "1.5"), (np.arange(40) - 7, "us", "-0.000007")):
        ori.Curve(times, keys[1], time_unit=unit).report(tmp_path / "page.html")
        assert f'"time_start":"{start}"' in (tmp_path / "page.html").read_text("utf-8").replace(": ", ":")


def test_showing_opens_the_page_in_the_browser(curve, monkeypatch):
    opened = []
    monkeypatch.setattr("webbrowser.open", opened.append)
    path = curve.show(title="Look")
    assert opened == [path.as_uri()] and '"Look"' in path.read_text("utf-8")
    path.unlink()


CURVE = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
DATED = ori.Curve(np.array(["2026-01-01", "2026-01-02"], "datetime64[D]"), [[0, 0, 0, 1], [0, 0, 1, 0]])
BAD = [
    ("quantity", lambda: CURVE.plot(quantities="speed"), ori.ArgumentError,
     "quantities: found 'speed', wanted some of 'angle', 'rate'"),
    ("no quantities", lambda: CURVE.plot(quantities=()), ori.ArgumentError, "quantities: found none"),
    ("fewer axes", lambda: CURVE.plot([pyplot.figure().add_subplot()], ("rate", "jerk")), ori.ArgumentError,
     "axes: found 1, wanted one for each of the 2"),
    ("two names of axes", lambda: CURVE.plot(pyplot.figure().add_subplot(), ax=pyplot.figure().add_subplot()), ori.ArgumentError,
     "ax: found it beside axes, wanted one of them"),
    ("flat sphere", lambda: CURVE.plot_sphere(axes=pyplot.figure().add_subplot()), ori.ArgumentError,
     "wanted Axes of three dimensions"),
    ("axis", lambda: CURVE.plot_sphere("nose"), ori.ArgumentError, "axis: found 'nose', wanted 'x', 'y', 'z' or three numbers"),
    ("axis of no length", lambda: CURVE.plot_sphere([0, 0, 0]), ori.ArgumentError, "wanted a direction of finite length"),
    ("infinite axis", lambda: CURVE.plot_sphere([0, np.inf, 0]), ori.ArgumentError, "wanted a direction of finite length"),
    ("flat axis", lambda: CURVE.plot_sphere([1, 0]), ori.ArgumentError, "axis: found the shape (2,), wanted (3,)"),
    ("no curves", lambda: ori.plot_comparison([]), ori.ArgumentError, "curves: found none"),
    ("no curve", lambda: ori.plot_comparison(["auto"]), TypeError, "curves: found str among them, wanted curves"),
    ("a number", lambda: ori.plot_sphere(7), TypeError, "curves: found int, wanted curves"),
    ("keys", lambda: ori.plot_comparison({"keys": CURVE.keys}), TypeError, "curves: found Keys among them"),
    ("two kinds of times", lambda: ori.plot_comparison([CURVE, DATED]), ori.ArgumentError, "times of different kinds"),
    ("reference of another kind", lambda: ori.plot_comparison(CURVE, DATED), ori.ArgumentError,
     "reference: found times of another kind"),
    ("reference", lambda: ori.plot_comparison(CURVE, [1, 2]), TypeError, "reference: found list, wanted a Curve or Keys"),
    ("reference elsewhere", lambda: ori.plot_comparison(CURVE, ori.Curve([5, 6], [[0, 0, 0, 1]] * 2)), ori.DataError,
     "reference: found none of its times from 0.0 to 3.0, where 'auto' is"),
    ("no folder", lambda: CURVE.report("/no/such/folder/page.html"), ori.AccessError, "/no/such/folder/page.html"),
    ("a number as path", lambda: CURVE.report(3), TypeError, "int"),
    ("inertia", lambda: CURVE.report("page.html", inertia=[1, 1, -1]), ori.ArgumentError, "wanted all of them greater than 0"),
]


@pytest.mark.parametrize(("draw", "error", "text"), [case[1:] for case in BAD], ids=[case[0] for case in BAD])
def test_bad_input(draw, error, text):
    with pytest.raises(error) as found:
        draw()
    assert text in str(found.value) and "\n" not in str(found.value)
    pyplot.close("all")


def test_curves_that_are_made_of_curves_are_drawn():
    other = ori.Curve(CURVE.times + 0.25, CURVE.keys.rotations[::-1])
    relative = CURVE.relative_to(other)
    charts = ori.plot_comparison(relative, quantities="rate")
    seconds, rates = charts[0].lines[0].get_data()
    assert np.allclose(rates, np.linalg.norm(relative.angular_velocity(seconds), axis=1), atol=1e-9)
    marks = charts[0].collections[0].get_segments()
    assert np.allclose([line[0][0] for line in marks], relative.times) and relative.times[0] == other.times[0]
    charts = ori.plot_comparison([CURVE, relative, relative.inv()], relative)
    assert [text.get_text() for text in charts[0].get_legend().get_texts()] == ["auto", "composed", "composed (3)"]
    assert np.abs(charts[0].lines[1].get_ydata()).max() < 1e-6
    dots = ori.plot_sphere(relative).collections[-1]
    assert len(dots._offsets3d[0]) == len(relative.times)
    assert np.allclose(np.transpose(dots._offsets3d), relative.as_matrix(relative.times)[:, :, 0])
