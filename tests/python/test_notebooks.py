# SPDX-License-Identifier: Apache-2.0
"""What a session or a notebook shows of objects: one line, a table, a small picture."""
import html.parser

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation

T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
CURVE = ori.Curve(T, Q)
TIMES = np.linspace(0, 4, 81)
RECORDING = ori.Keys(TIMES, Rotation.from_rotvec(np.outer(np.sin(TIMES), [0, 0, 1]) + np.random.default_rng(1).normal(0, 0.01, (81, 3))))


class Table(html.parser.HTMLParser):
    """The rows of a table, each a list of texts."""

    def __init__(self, text):
        super().__init__()
        self.rows, self.open = [], []
        self.feed(text)
        assert not self.open

    def handle_starttag(self, tag, attrs):
        self.open.append(tag)
        if tag == "tr":
            self.rows.append([])
        elif tag in ("td", "th"):
            self.rows[-1].append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag

    def handle_data(self, data):
        if self.open[-1:] in (["td"], ["th"]):
            self.rows[-1][-1] += data


def test_samples_are_said_in_a_line():
    stack = ori.CurveStack(T, np.stack([Q, Q], axis=1))
    dated = ori.Curve(np.array(["2026-01-01", "2026-01-02", "2026-01-04"], "datetime64[D]"), Q)
    assert repr(CURVE.sample(rate=2, derivatives=1, frame="world")) == "Samples(7 samples, 0 … 3 s, orientations, angular_velocities, world frame)"
    assert repr(stack.sample(count=1)) == "Samples(1 sample of 2 joints, 0 … 0 s, orientations)"
    assert repr(dated.sample(count=2)) == "Samples(2 samples, 2026-01-01T00:00:00.000000000 … 2026-01-04T00:00:00.000000000, orientations)"
    assert repr(CURVE.sample(times=[])) == "Samples(0 samples, orientations)"
    assert repr(ori.Samples(np.array([0.5, 2]), np.array(Q[:2]))) == "Samples(2 samples, 0.5 … 2 s, orientations)"


def test_twins_and_streams_are_said_in_a_line():
    rotations = Rotation.from_quat(Q)
    assert repr(ori.RotationSpline(T, rotations)) == "RotationSpline(3 rotations, 0 … 3 s)"
    assert repr(ori.Slerp(T, rotations)) == "Slerp(3 rotations, 0 … 3 s)"
    online = ori.OnlineCurve("timed-c2", ends="rest")
    assert repr(online) == "OnlineCurve('timed-c2:ends=rest', 0 keys)"
    for t, q in zip(T, Q):
        online.append(t, q)
    assert repr(online) == "OnlineCurve('timed-c2:ends=rest', 3 keys, final 0 … 1 s)"


def test_samples_are_a_table_of_their_ends():
    for samples, joints in ((CURVE.sample(count=100, derivatives=1), False), (ori.CurveStack(T, np.stack([Q, Q], axis=1)).sample(count=50), True)):
        rows = Table(samples._repr_html_()).rows
        assert rows[0][:2] == (["joint", "t"] if joints else ["t", "qw"]) and len(rows) == 12 and set(rows[6]) == {"…"}
        assert [float(cell) for cell in rows[-1][joints:2]] == ([3.0] if joints else [3.0, pytest.approx(0.0, abs=1e-9)])
    assert len(Table(CURVE.sample(count=3)._repr_html_()).rows) == 4
    assert len(Table(CURVE.sample(times=[])._repr_html_()).rows) == 1


def test_results_are_tables_that_say_what_they_mean():
    smoothing, reduction = ori.smooth(RECORDING), ori.reduce(RECORDING, "2deg")
    for result, name in ((smoothing, "noise_rad"), (reduction, "error_max_deg"), (ori.retime(CURVE.keys, max_rate=1), "time_scale"),
                         (ori.tune(CURVE.keys, "quintic"), "iterations")):
        rows = {row[0]: row for row in Table(result._repr_html_()).rows}
        assert float(rows[name][1]) == pytest.approx(result.as_dict()[name], rel=1e-5) and rows[name][2]
    comparison = ori.compare(RECORDING, ["slerp", "auto"])
    rows = Table(comparison._repr_html_()).rows
    assert rows[0][:3] == ["method", "keys", "RMS [deg]"] and [row[0] for row in rows[1:]] == [row["method"] for row in comparison.table()]
    assert float(rows[1][2]) == pytest.approx(comparison.table()[0]["rms_deg"], rel=1e-5)


def test_names_in_tables_are_escaped():
    from orispline._html import table
    assert Table(table("<b>", ["<i>"], [["a & b"], [None], [1.5]])).rows == [["<i>"], ["a & b"], [""], ["1.5"]]


@pytest.mark.parametrize("method", ["auto", "slerp", "quintic"])
def test_the_picture_of_a_few_keys_is_small(method):
    """It was 376 kB of points that nobody can tell from the line through fewer."""
    curve = ori.Curve([0.0, 1.0, 1.5, 3.5], [*Q, [0, 0.6, 0.8, 0]], method)
    assert len(curve._repr_svg_()) < 60_000


def test_one_time_is_asked_as_strictly_as_many():
    for threads in ("x", True, 1.0, None):
        for ask in (CURVE, CURVE.angular_velocity, CURVE.angular_jerk):
            with pytest.raises(TypeError, match=f"threads: found {threads!r} of type"):
                ask(1.0, threads=threads)
    with pytest.raises(ori.ArgumentError, match="threads: found -1"):
        CURVE(1.0, threads=-1)
    assert np.array_equal(CURVE(1.0, threads=2), CURVE(1.0))
