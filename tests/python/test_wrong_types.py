# SPDX-License-Identifier: Apache-2.0
"""Arguments of a wrong type have one line, which names the argument: no list of signatures."""
import numpy as np
import orispline as ori
import pytest

T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
CURVE = ori.Curve(T, Q)
TYPES = [
    ("threads", lambda x: CURVE(T, threads=x), ["two", 1.5, None, [1], True]),
    ("threads", lambda x: CURVE.angular_velocity(T, threads=x), ["two", 2.0]),
    ("threads", lambda x: CURVE.sample(rate=2, threads=x), ["two", 1.5, None]),
    ("include_end", lambda x: CURVE.sample(rate=2, include_end=x), ["yes", 1, None]),
    ("include_end", lambda x: CURVE.sample(count=2, include_end=x), ["yes", 2.5]),
    ("times", ori.Curve, [CURVE]),
    ("rotations", ori.Curve, [T, CURVE.sample(rate=1)]),
    ("closed", lambda x: ori.Curve(T, Q, "timed-c2", closed=x), ["yes", 1]),
    ("period", lambda x: ori.Curve(T, Q, "timed-c2", period=x), ["long", [1.0], True]),
    ("method", lambda x: ori.Curve(T, Q, x), [3, b"auto", ["auto"]]),
    ("ends", lambda x: ori.Curve(T, Q, "timed-c2", ends=x), [3, ("rest", 3), ("rest",), [["rest", "rest"]]]),
    ("scalar_first", lambda x: ori.Keys(T, Q, scalar_first=x), ["yes", 1, None]),
    ("normalize", lambda x: ori.Keys(T, Q, normalize=x), ["yes", 0]),
    ("settings", lambda x: ori.Keys(T, Q, settings=x), [3, [1, 2], {"tension": 3}, {"tension": "abc"}, {4: [1, 2, 3]}]),
    ("out", lambda x: CURVE(T, out=x), [[1.0], "here", 3]),
    ("keys", lambda x: ori.Keys(T, Q)[x], [1.0, "a", None]),
    ("gyro", lambda x: ori.smooth(ori.Keys(T, Q), gyro=x), [ori.Keys(T, Q), [1.0, 2.0], (T, T, T)]),
    ("noise", lambda x: ori.smooth(ori.Keys(T, Q), noise=x), [ori.Keys(T, Q), [[1.0], [1.0, 2.0]]]),
]
VALUES = [("threads", lambda x: CURVE(T, threads=x), [-1, 2**40]), ("threads", lambda x: CURVE.sample(rate=1, threads=x), [-3])]


@pytest.mark.parametrize(("name", "ask", "wrong"), [(name, ask, x) for name, ask, wrongs in TYPES for x in wrongs])
def test_a_wrong_type_is_named_in_one_line(name, ask, wrong):
    with pytest.raises(TypeError) as found:
        ask(wrong)
    text = str(found.value)
    assert text.startswith(f"{name}: found ") and ", wanted " in text and "\n" not in text


@pytest.mark.parametrize(("name", "ask", "wrong"), [(name, ask, x) for name, ask, wrongs in VALUES for x in wrongs])
def test_a_number_out_of_range_is_an_argument_error(name, ask, wrong):
    with pytest.raises(ori.ArgumentError) as found:
        ask(wrong)
    assert str(found.value).startswith(f"{name}: found {wrong}") and "\n" not in str(found.value)


def test_numbers_of_numpy_are_numbers():
    assert np.array_equal(CURVE(T, threads=np.int64(2)), CURVE(T))
    assert len(CURVE.sample(count=np.uint8(4), include_end=np.True_)) == 4
    assert ori.Curve(T, Q, "timed-c2", closed=np.False_, period=np.float32(4)).domain == (0.0, 4.0)


def test_names_of_arguments_are_asked_for_in_one_line():
    for ask in (lambda: ori.Curve(), lambda: ori.Keys(T), lambda: CURVE(), lambda: CURVE.motion(), lambda: CURVE(T, nonsense=1)):
        with pytest.raises(TypeError) as found:
            ask()
        assert "\n" not in str(found.value)
