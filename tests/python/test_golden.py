# SPDX-License-Identifier: Apache-2.0
"""Rows of the references, computed with 60 digits, through the Python package."""
import collections
import math

import numpy as np
import orispline as ori
import pytest
from conftest import rows_of

GOLDEN, WIDER, HERMITE = (1e-12, 1e-11, 1e-9, 1e-7), (1e-12, 1e-11, 1e-10, 1e-9), (1e-11, 1e-10, 1e-9, 1e-8)
CASES = {"slerp": (16, GOLDEN), "squad": (32, GOLDEN), "quintic": (48, GOLDEN), "sextic": (64, GOLDEN), "timed-c2": (68, GOLDEN),
         "hermite-cumulative": (21, GOLDEN), "beta": (34, GOLDEN), "squad-timed": (19, WIDER), "tcb": (19, WIDER),
         "global-c2": (15, WIDER), "rotation-spline": (25, WIDER), "hermite-c2": (37, HERMITE)}


def vectors(text):
    return np.array([float(x) for x in text.split()]).reshape(-1, 3) if text else None


def curve_of(case):
    """The curve that a row of cases.csv tells."""
    rows = [row for row in rows_of("golden/keys.csv") if row["sequence"] == case["sequence"]]
    settings = {}
    for assignment in filter(None, case["parameters"].split(";") + case["choices"].split(";")):
        name, value = assignment.split("=")
        words = value.split()
        settings[name] = value if name in {c.split("=")[0] for c in case["choices"].split(";")} else \
            float(words[0]) if len(words) == 1 else [float(x) for x in words]
    ends = case["ends"].split()
    return ori.Curve(
        [float(row["t"]) for row in rows], [[float(row[x]) for x in ("qw", "qx", "qy", "qz")] for row in rows],
        case["family"], scalar_first=True, normalize=True, signs=case["signs"].replace("_", "-"),
        ends=None if not ends else ends[0] if len(ends) == 1 else tuple(ends),
        start_rate=None if not case["start_rate"] else vectors(case["start_rate"])[0],
        end_rate=None if not case["end_rate"] else vectors(case["end_rate"])[0],
        period=float(case["period"]) if case["period"] else None, angular_velocities=vectors(case["key_rates"]),
        angular_accelerations=vectors(case["key_accelerations"]), angular_jerks=vectors(case["key_jerks"]), **settings)


@pytest.mark.parametrize("family", CASES)
def test_rows_agree_with_the_reference(family):
    wanted_cases, tolerances = CASES[family]
    cases = {row["case"]: row for row in rows_of("golden/cases.csv") if row["family"] == family}
    assert len(cases) == wanted_cases
    rows = collections.defaultdict(list)
    for row in rows_of(f"golden/{family}.csv"):
        if row["side"] == "right":
            rows[row["case"]].append(row)
    for number, case in cases.items():
        curve = curve_of(case)
        t = [float(row["t"]) for row in rows[number]]
        growth = max(1, 1 / (math.pi - float(case["max_halfangle"])))
        got = curve(t), curve.angular_velocity(t), curve.angular_acceleration(t), curve.angular_jerk(t)
        for values, columns, tolerance in zip(got, ("qw qx qy qz", "wx wy wz", "ax ay az", "jx jy jz"), tolerances):
            wanted = np.array([[float(row[name]) for name in columns.split()] for row in rows[number]])
            error = np.linalg.norm(values - wanted, axis=1) / np.maximum(1, np.linalg.norm(wanted, axis=1))
            assert error.max() <= growth * tolerance, (number, columns)
