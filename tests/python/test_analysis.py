# SPDX-License-Identifier: Apache-2.0
"""Measures of curves, beside closed forms, SciPy's quadrature and the command."""
import concurrent.futures
import csv
import json
import subprocess

import numpy as np
import orispline as ori
import pytest
from conftest import DATA, product
from orispline._command import COMMAND
from scipy.integrate import quad
from scipy.spatial.transform import Rotation

EXAMPLES = DATA.parents[1] / "examples/data"
INERTIA = np.array([[2.0, 0.1, 0.0], [0.1, 3.0, -0.2], [0.0, -0.2, 4.0]])
METHODS = [method["name"] for method in ori.methods()]


def told(*words):
    """What the command says of a file, as JSON."""
    return json.loads(subprocess.run([COMMAND, *map(str, words)], check=True, capture_output=True, text=True).stdout)


def columns(name, *wanted):
    with open(EXAMPLES / name, encoding="utf-8") as file:
        table = np.genfromtxt((line for line in file if not line.startswith("#")), delimiter=",", names=True)
    return np.stack([table[column] for column in wanted], axis=-1)


def example(name):
    return columns(name, "t")[:, 0], columns(name, "qx", "qy", "qz", "qw")


def about_z(angles):
    return np.stack([0 * angles, 0 * angles, np.sin(angles / 2), np.cos(angles / 2)], axis=-1)


@pytest.fixture
def curve(keys):
    return ori.Curve(*keys)


def integral(curve, f):
    """Of a function of time, segment by segment."""
    return sum(quad(f, a, b, epsabs=0, epsrel=1e-11, limit=200)[0] for a, b in zip(curve.times, curve.times[1:]))


def test_a_constant_rate_has_no_energy_and_travels_evenly():
    rate = 0.7
    curve = ori.Curve([1, 2, 4], about_z(rate * np.array([0.0, 1.0, 3.0])), "slerp")
    assert curve.energies().acceleration < 1e-24 and curve.energies().jerk < 1e-24 and curve.energies().torque is None
    peaks = curve.peaks()
    assert peaks.angular_velocity.value == pytest.approx(rate, rel=1e-14) and peaks.torque is None
    assert curve.angle_travelled() == pytest.approx(3 * rate, rel=1e-14) and isinstance(curve.angle_travelled(2.5), float)
    t = np.array([[1.0, 1.5], [3.0, 9.0]])
    assert np.allclose(curve.angle_travelled(t), rate * np.array([[0, 0.5], [2, 3]]), rtol=1e-14)
    assert np.allclose(curve.time_at_angle(rate * np.array([[0.0, 0.5, 2.0]])), [[1.0, 1.5, 3.0]], rtol=1e-13)
    assert curve.time_at_angle(-1.0) == 1.0 and curve.time_at_angle(99) == 4.0 and isinstance(curve.time_at_angle(1), float)
    assert np.isnan(curve.angle_travelled(np.nan)) and np.isnan(curve.time_at_angle([np.nan, 1.0])).tolist() == [True, False]
    w = np.array([0, 0, rate])
    assert np.allclose(curve.torque([1.5, 3.5], INERTIA), np.cross(w, INERTIA @ w), atol=1e-14)


def test_a_cubic_from_rest_to_rest_has_its_closed_forms():
    angle, time = 1.2, 2.5
    curve = ori.Curve([0, time], about_z(np.array([0.0, angle])), "global-c2", ends="rest")
    energies, peaks = curve.energies([1.0, 2.0, 3.0]), curve.peaks([1.0, 2.0, 3.0])
    assert energies.acceleration == pytest.approx(12 * angle**2 / time**3, rel=1e-10)
    assert energies.jerk == pytest.approx(144 * angle**2 / time**5, rel=1e-10)
    assert energies.torque == pytest.approx(9 * energies.acceleration, rel=1e-10)
    assert peaks.angular_velocity.value == pytest.approx(1.5 * angle / time, rel=1e-12)
    assert peaks.angular_velocity.time == pytest.approx(time / 2, rel=1e-6)
    assert peaks.angular_acceleration.value == pytest.approx(6 * angle / time**2, rel=1e-10)
    assert peaks.torque.value == pytest.approx(3 * peaks.angular_acceleration.value, rel=1e-12)
    assert curve.angle_travelled() == pytest.approx(angle, rel=1e-12)


def test_energies_and_angles_are_those_of_quadrature(curve):
    def torque(t):
        w, a = curve.angular_velocity(t), curve.angular_acceleration(t)
        return INERTIA @ a + np.cross(w, INERTIA @ w)

    def square(f):
        return lambda t: float(np.sum(f(t) ** 2))

    energies = curve.energies(INERTIA)
    for found, f in ((energies.acceleration, square(curve.angular_acceleration)), (energies.jerk, square(curve.angular_jerk)),
                     (energies.torque, square(torque))):
        assert found == pytest.approx(integral(curve, f), rel=1e-8)
    travelled = integral(curve, lambda t: np.linalg.norm(curve.angular_velocity(t)))
    assert curve.angle_travelled() == pytest.approx(travelled, rel=1e-8)
    t = np.random.default_rng(1).uniform(*curve.domain, 30)
    assert np.allclose(curve.time_at_angle(curve.angle_travelled(t)), t, atol=1e-9)
    even = curve.at_angle(np.linspace(0, curve.angle_travelled(), 7))
    assert np.array_equal(even, curve(curve.time_at_angle(np.linspace(0, curve.angle_travelled(), 7))))
    assert np.allclose(curve.torque(t.reshape(5, 6), INERTIA), np.array([torque(x) for x in t]).reshape(5, 6, 3), atol=1e-12)


def test_threads_share_what_is_measured(keys):
    angles = [ori.Curve(*keys).angle_travelled(t) for t in keys[0]]
    for _ in range(20):
        curve = ori.Curve(*keys)
        with concurrent.futures.ThreadPoolExecutor(8) as threads:
            assert list(threads.map(curve.angle_travelled, map(float, keys[0]))) == angles
            assert len(set(threads.map(lambda _: curve.energies(), range(8)))) == 1


def test_one_key_is_at_rest():
    curve = ori.Curve([5.0], [[0, 0, 0.6, 0.8]])
    assert curve.energies([1, 2, 2.5]) == ori.Energies(0.0, 0.0, 0.0) and curve.angle_travelled() == 0.0
    assert curve.peaks().angular_velocity == ori.Peak(0.0, 5.0, 0.0) and curve.time_at_angle([0.0, 1.0]).tolist() == [5.0, 5.0]
    assert curve.distance([5.0], [[0, 0, 0.6, 0.8]]).largest < 1e-15 and curve.overwound_tangent() is None


def test_torque_is_the_derivative_of_the_momentum(curve):
    t, h = np.random.default_rng(2).uniform(*curve.domain, 40), 1e-5
    t = t[np.abs(t[:, None] - curve.times).min(axis=1) > 10 * h]

    def momentum(t):
        return Rotation.from_quat(curve(t)).apply(curve.angular_velocity(t) @ INERTIA)

    wanted = (momentum(t + h) - momentum(t - h)) / (2 * h)
    assert np.allclose(Rotation.from_quat(curve(t)).apply(curve.torque(t, INERTIA)), wanted, atol=1e-6)


def test_peaks_are_above_all_samples_and_are_reached(curve):
    peaks = curve.peaks(INERTIA)
    t = np.linspace(*curve.domain, 20001)
    for name in ("angular_velocity", "angular_acceleration"):
        peak, at = getattr(peaks, name), getattr(curve, name)
        assert np.linalg.norm(at(t), axis=1).max() <= peak.value * (1 + 1e-12)
        assert np.linalg.norm(at(peak.time)) == pytest.approx(peak.value, rel=1e-9)
    assert np.linalg.norm(curve.torque(t, INERTIA), axis=1).max() <= peaks.torque.value * (1 + 1e-12)


@pytest.mark.parametrize("file", ["flight_keys.csv", "robot_keys.csv", "camera_keys.csv"])
def test_continuity_is_as_the_command_inspects_it(file):
    names = [name for name in METHODS if name != "bezier"]  # which takes 3k + 1 keys
    keys = ori.Keys(*example(file))
    curves = {}
    for name in names:
        try:
            curves[name] = keys.curve(name)
        except ori.Error:
            continue
    assert len(curves) > 20
    report = told("inspect", EXAMPLES / file, "--method", ",".join(curves), "--ignore-recipe", "--json")
    inspected = {entry["method"]: entry["continuity_order"] for entry in report["methods"]}
    found = {name: curve.continuity() for name, curve in curves.items() if not curve.info["rate_orders"]}
    assert found == {name: inspected[name] for name in found}


@pytest.mark.parametrize("method", ["timed-c1:period=50", "timed-c2:period=60", "global-c2:period=55"])
def test_a_loop_is_measured_where_it_closes(method):
    entry, = told("inspect", EXAMPLES / "flight_keys.csv", "--method", method, "--json")["methods"]
    assert ori.Curve(*example("flight_keys.csv"), method).continuity() == entry["continuity_order"]


def test_measures_are_those_of_compare():
    method = "timed-c2:tension=0.4"
    found, = told("compare", EXAMPLES / "flight_keys.csv", "--reference", EXAMPLES / "flight_truth.csv", "--methods", method,
                  "--inertia", "2,3,4,0.1,0,-0.2", "--leave-out", "--json")
    curve = ori.Curve(*example("flight_keys.csv"), method)
    truth = example("flight_truth.csv")
    energies, peaks, distance = curve.energies(INERTIA), curve.peaks(INERTIA), curve.distance(*truth)
    rates = curve.rate_error(truth[0], columns("flight_truth.csv", "wx", "wy", "wz"))
    values = {"energy": energies.acceleration, "jerk_energy": energies.jerk, "torque_energy": energies.torque,
              "peak_rate_rad_s": peaks.angular_velocity.value, "peak_rate_at_s": peaks.angular_velocity.time,
              "peak_acceleration_rad_s2": peaks.angular_acceleration.value,
              "peak_acceleration_at_s": peaks.angular_acceleration.time, "peak_torque_n_m": peaks.torque.value,
              "peak_torque_at_s": peaks.torque.time, "peak_rate_bound_rad_s": peaks.angular_velocity.bound,
              "peak_acceleration_bound_rad_s2": peaks.angular_acceleration.bound,
              "peak_torque_bound_n_m": peaks.torque.bound, "angle_travelled_deg": np.degrees(curve.angle_travelled()),
              "continuity": curve.continuity(), "rms_deg": np.degrees(distance.rms), "mean_deg": np.degrees(distance.mean),
              "median_deg": np.degrees(distance.median), "p95_deg": np.degrees(distance.percentile_95),
              "p99_deg": np.degrees(distance.percentile_99), "max_deg": np.degrees(distance.largest),
              "max_at_s": truth[0][distance.largest_at], "rate_rms_rad_s": rates.rms, "rate_max_rad_s": rates.largest,
              "leave_out_rms_deg": np.degrees(curve.leave_out().rms)}
    assert {name: found[name] for name in values} == pytest.approx(values, rel=1e-12)
    assert distance.count == found["samples"]


def test_bands_are_those_of_the_reference():
    def table(name):
        with open(DATA / "golden" / name, encoding="utf-8") as file:
            return list(csv.DictReader(line for line in file if not line.startswith("#")))

    keys, rows = table("measured_keys.csv"), table("measured.csv")
    name = next(row["sequence"] for row in rows if row["band90"])
    track, wanted = ([row for row in some if row["sequence"] == name] for some in (keys, rows))
    curve = ori.Curve([float(k["t"]) for k in track], [[float(k[c]) for c in ("qx", "qy", "qz", "qw")] for k in track], "measured")
    t = [float(row["t"]) for row in wanted]
    for share, column in ((0.9, "band90"), (0.5, "band50")):
        assert np.allclose(curve.band(t, share), [float(row[column]) for row in wanted], rtol=1e-9, atol=1e-13)
    assert isinstance(curve.band(t[1]), float) and curve.band(t[1]) == curve.band(t)[1] and np.isnan(curve.band(np.nan))


def test_bands_of_few_keys_are_infinite_and_other_methods_have_none(keys):
    assert ori.Curve([0, 1], [[0, 0, 0, 1], [0, 0, 1, 0]], "measured").band(0.5) == np.inf
    with pytest.raises(ori.ArgumentError):
        ori.Curve(*keys, "auto").band(0.5)
    with pytest.raises(ori.ArgumentError):
        ori.Curve(*keys, "measured").band(0.5, share=1.5)


def test_distances_are_those_of_scipy(curve):
    dice = np.random.default_rng(4)
    times = np.sort(dice.uniform(curve.domain[0] - 1, curve.domain[1] + 1, 500))
    rotations = Rotation.random(500, random_state=5)
    inside = (times >= curve.domain[0]) & (times <= curve.domain[1])
    angles = (curve.rotation(times[inside]).inv() * rotations[inside]).magnitude()
    for given in (rotations, rotations.as_quat(), rotations.as_matrix()):
        found = curve.distance(times, given)
        assert found.count == inside.sum() and found.largest_at == np.flatnonzero(inside)[angles.argmax()]
        assert [found.rms, found.mean, found.largest, found.median, found.percentile_95] == pytest.approx(
            [np.sqrt(np.mean(angles**2)), angles.mean(), angles.max(), np.median(angles), np.percentile(angles, 95)], abs=1e-9)
    rates = dice.normal(size=(500, 3))
    errors = np.linalg.norm(curve.angular_velocity(times[inside]) - rates[inside], axis=1)
    found = curve.rate_error(times, rates)
    assert [found.rms, found.largest, found.percentile_99] == pytest.approx(
        [np.sqrt(np.mean(errors**2)), errors.max(), np.percentile(errors, 99)], rel=1e-12)


def test_leaving_out_is_done_four_times(keys):
    times, rotations = keys
    angles = []
    for first in range(1, 5):
        left = np.arange(first, len(times) - 1, 4)
        rest = np.delete(np.arange(len(times)), left)
        curve = ori.Curve(times[rest], rotations[rest])
        angles += list((curve.rotation(times[left]).inv() * Rotation.from_quat(rotations[left])).magnitude())
    found = ori.Curve(times, rotations).leave_out()
    assert found.count == len(angles) == len(times) - 2
    assert [found.rms, found.largest, found.mean] == pytest.approx(
        [np.sqrt(np.mean(np.square(angles))), max(angles), np.mean(angles)], rel=1e-9)


def test_an_overwound_tangent_is_that_of_the_warning(tmp_path):
    times = np.array([0.0, 1.0, 1.05, 11.0, 12.0])
    rotations = [np.array([0, 0, 0, 1.0])]
    for axis, angle in (((0, 0, 1), 0.5), ((0, 1, 0), 1.5), ((1, 0, 0), 0.5), ((0, 0, 1), 0.5)):
        rotations.append(product(rotations[-1], np.append(np.sin(angle / 2) * np.array(axis), np.cos(angle / 2))))
    table = tmp_path / "keys.csv"
    rows = [",".join(repr(float(x)) for x in (t, q[3], *q[:3])) for t, q in zip(times, rotations)]
    table.write_text("\n".join(["t,qw,qx,qy,qz", *rows]) + "\n")
    summary = told("sample", table, "--method", "squad-timed", "--rate", "10", "-o", tmp_path / "out.csv", "--json")
    warning, = (w for w in summary["warnings"] if w["code"] == "overwound_tangent")
    found = ori.Curve(times, rotations, "squad-timed").overwound_tangent()
    assert found.key == warning["key"] and np.degrees(found.turn) == pytest.approx(warning["turn_deg"], rel=1e-12)
    assert found.turn >= 2 * np.pi and ori.Curve(times, rotations).overwound_tangent() is None


@pytest.mark.parametrize("method", METHODS)
def test_settings_make_the_same_curve_again(keys, method):
    times, rotations = (part[:10] for part in keys)
    curve = ori.Curve(times, rotations, method)
    info = curve.info
    assert set(curve.settings) == {p["name"] for p in info["parameters"]} | set(info["choices"])
    again = ori.Curve(curve.keys, method=info["name"], **curve.settings)
    t = np.linspace(*curve.domain, 50)
    assert np.array_equal(again(t), curve(t))


def test_settings_per_key_are_arrays(keys):
    tensions = np.linspace(0.1, 0.9, 40)
    curve = ori.Curve(*keys, "quintic", tension=tensions)
    assert np.array_equal(curve.settings["tension"], tensions)
    assert ori.Curve(*keys, "squad-timed", variant="boyle").settings["variant"] == "boyle"


def test_calendars_and_units_have_their_own_times(keys):
    times, rotations = keys
    nanoseconds = np.round((times - times[0]) * 1e9).astype(np.int64)
    dates = np.datetime64("2026-11-22T12:00:00") + nanoseconds.astype("timedelta64[ns]")
    dated, plain = ori.Curve(dates, rotations), ori.Curve(nanoseconds / 1e9, rotations)
    peak = dated.peaks().angular_velocity
    assert peak.value == plain.peaks().angular_velocity.value
    seconds = (peak.time - dates[0]) / np.timedelta64(1, "ns") / 1e9
    assert isinstance(peak.time, np.datetime64) and abs(seconds - plain.peaks().angular_velocity.time) < 1e-9
    assert np.array_equal(dated.angle_travelled(dates), plain.angle_travelled(nanoseconds / 1e9))
    assert dated.time_at_angle([1.0, 2.0]).dtype == "datetime64[ns]" and isinstance(dated.time_at_angle(1.0), np.datetime64)
    assert dated.distance(dates, rotations).largest < 1e-7 and np.allclose(
        dated.torque(dates[3], INERTIA), plain.torque(nanoseconds[3] / 1e9, INERTIA))
    milliseconds = np.arange(40) * 1000
    peak = ori.Curve(milliseconds, rotations, time_unit="ms").peaks().angular_velocity
    assert peak.time == pytest.approx(1000 * ori.Curve(milliseconds / 1000, rotations).peaks().angular_velocity.time)
