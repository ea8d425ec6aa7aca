# SPDX-License-Identifier: Apache-2.0
"""Bad input of measures has one line that says what was found and what was wanted."""
import numpy as np
import orispline as ori
import pytest

CURVE = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
Q = [[0, 0, 0, 1], [0, 0, 0.6, 0.8]]
BAD = [
    ("asymmetric inertia", lambda: CURVE.energies([[1, 2, 0], [0, 1, 0], [0, 0, 1]]), ori.ArgumentError, "not symmetric"),
    ("negative inertia", lambda: CURVE.peaks([1, 2, -3]), ori.ArgumentError, "wanted all of them greater than 0"),
    ("NaN in an inertia", lambda: CURVE.torque(1.0, [1, 2, np.nan]), ori.ArgumentError, "inertia"),
    ("shape of an inertia", lambda: CURVE.energies(np.ones((2, 2))), ori.ArgumentError,
     "inertia: found the shape (2, 2), wanted (3, 3)"),
    ("one moment", lambda: CURVE.energies(2.0), ori.ArgumentError, "inertia: found the shape ()"),
    ("inertia as text", lambda: CURVE.energies("abc"), ori.ArgumentError, "inertia"),
    ("angle as text", lambda: CURVE.time_at_angle("far"), ori.ArgumentError, "angle: found"),
    ("time as text", lambda: CURVE.angle_travelled("late"), ori.ArgumentError, "t: found"),
    ("fewer rotations", lambda: CURVE.distance([0, 1, 2], Q), ori.DataError,
     "rotations: found 2, wanted one for each of the 3"),
    ("decreasing times", lambda: CURVE.distance([1, 0], Q), ori.DataError, "wanted strictly increasing times"),
    ("zero quaternion", lambda: CURVE.distance([0, 1], np.zeros((2, 4))), ori.DataError, "norm 0"),
    ("times outside", lambda: CURVE.distance([4, 5], Q), ori.DataError, "found none from 0.0 to 3.0, where the curve is"),
    ("no times", lambda: CURVE.rate_error([], np.empty((0, 3))), ori.DataError, "found none from"),
    ("table of times", lambda: CURVE.distance([[0, 1]], Q), ori.ArgumentError, "times: found the shape (1, 2), wanted (n,)"),
    ("flat rates", lambda: CURVE.rate_error([0, 1], [1, 2]), ori.ArgumentError, "rates: found the shape (2,), wanted (n, 3)"),
    ("NaN in rates", lambda: CURVE.rate_error([0, 1], [[0, 0, 0], [0, np.nan, 0]]), ori.DataError,
     "at index 1, wanted finite numbers"),
    ("falling times", lambda: CURVE.rate_error([0, 2, 1], np.zeros((3, 3))), ori.DataError, "found 1 after 2 at index 2"),
    ("infinite times", lambda: CURVE.rate_error([0, np.inf], np.zeros((2, 3))), ori.DataError,
     "at index 1, wanted finite times"),
    ("dates on seconds", lambda: CURVE.angle_travelled(np.datetime64("2026-01-01")), ori.ArgumentError,
     "as the times of the keys are"),
    ("two keys to leave out", lambda: ori.Curve([0, 1], Q).leave_out(), ori.DataError, "3"),
    ("leave out per key", lambda: ori.Curve([0, 1, 3], CURVE.keys.rotations, "quintic", tension=[0.1, 0.2, 0.3]).leave_out(),
     ori.ArgumentError, "tension"),
]


@pytest.mark.parametrize(("ask", "error", "text"), [case[1:] for case in BAD], ids=[case[0] for case in BAD])
def test_bad_input(ask, error, text):
    with pytest.raises(error) as found:
        ask()
    assert text in str(found.value) and "\n" not in str(found.value)


def test_an_inertia_of_no_body_is_warned_of():
    with pytest.warns(ori.ShapeWarning, match="which no rigid body has") as found:
        CURVE.energies([1, 1, 5])
    assert found[0].filename == __file__ and found[0].message.code == "no_rigid_body"
