# SPDX-License-Identifier: Apache-2.0
"""Tasks find what the command finds, bit for bit."""
import decimal
import json
import pickle
import re

import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation
from task_files import EXAMPLES, columns_of, group, json_of, keys_in, noisy_file, run


def without_lines(members):
    """Keys that were not read from a file have no lines."""
    return json.loads(re.sub(r'"line": \d+', '"line": null', json.dumps(members)))


def expect_members(result, told, *only_told):
    """All of the result's members, and all but those few that are about files."""
    members = result.as_dict()
    assert members == {name: value for name, value in without_lines(told).items() if name in members}
    assert set(told) - set(members) - {"input", "output", "warnings"} == set(only_told)


def expect_keys(keys, path, rates=()):
    columns = columns_of(path)
    assert keys.times.tolist() == columns["t"].tolist()
    assert np.array_equal(keys.rotations, keys_in(path).rotations)  # the file may keep digits of another norm
    if "px" in columns:
        assert np.array_equal(keys.positions, group(columns, "px py pz"))
    for name, names in rates:
        assert np.array_equal(getattr(keys, name), group(columns, names))


SMOOTHINGS = {"": {}, "--noise 0.5deg --penalty jerk": {"noise": "0.5deg", "penalty": "jerk"},
              "--smoothing-time 0.05 --loss l2": {"smoothing_time": 0.05, "loss": "l2"}, "--no-adapt": {"adapt": False}, "--cutoff 8": {"cutoff": 8},
              "--cutoff 2.5 --penalty jerk": {"cutoff": "2.5Hz", "penalty": "jerk"}}


@pytest.mark.parametrize("words", SMOOTHINGS)
def test_smoothing_is_that_of_the_command(words, tmp_path):
    noisy = noisy_file(tmp_path / "noisy.csv", outliers=[50, 51, 140])
    out = tmp_path / "keys.csv"
    told = json_of("smooth", noisy, *words.split(), "-o", out)
    smoothing = ori.smooth(keys_in(noisy), **SMOOTHINGS[words])
    expect_members(smoothing, told)
    expect_keys(smoothing.keys, out, [("angular_velocities", "wx wy wz"), ("angular_accelerations", "ax ay az")])
    assert smoothing.method == "hermite-c2"
    assert smoothing.smoothing_time == told["smoothing_time_s"]
    assert smoothing.rejected.tolist() == [place["key"] for place in told["rejected"]]


def test_smoothing_of_positions_and_with_a_gyro_is_that_of_the_command(tmp_path):
    truth, out = EXAMPLES / "flight_truth.csv", tmp_path / "keys.csv"
    told = json_of("smooth", truth, "--gyro", "--penalty=acceleration", "--quiet", "-o", out)
    with pytest.warns(ori.ShapeWarning) as caught:
        smoothing = ori.smooth(keys_in(truth, "angular_velocities"), gyro=True, penalty="acceleration")
    expect_members(smoothing, told)
    expect_keys(smoothing.keys, out)
    assert smoothing.gyro_correction.tolist() == told["gyro_correction_rad_s"]
    assert caught[0].message.code == "least_smoothing"
    flagged = re.sub("`(.*?)`", lambda name: "--" + name[1].replace("_", "-"), str(caught[0].message))
    assert f"warning: {flagged}\n" in run("smooth", truth, "--gyro", "--penalty=acceleration", "-o", out)[1]
    assert caught[0].filename == __file__


def test_standard_deviations_are_those_of_the_command(tmp_path):
    noisy, out = noisy_file(tmp_path / "noisy.csv"), tmp_path / "keys.csv"
    told = json_of("smooth", noisy, "--sigma", "-o", out)
    smoothing = ori.smooth(keys_in(noisy), sigma=True)
    expect_members(smoothing, told)
    columns = columns_of(out)
    for found, names in ((smoothing.sigma, "sigma_x sigma_y sigma_z"), (smoothing.sigma_of_rates, "sigma_wx sigma_wy sigma_wz")):
        assert found is not None and np.array_equal(found, group(columns, names))
    assert pickle.loads(pickle.dumps(smoothing)).sigma.tolist() == smoothing.sigma.tolist()
    without = ori.smooth(keys_in(noisy))
    assert without.sigma is None and without.sigma_of_rates is None and without.rms_sigma is None


def test_smoothed_keys_carry_the_band_of_their_curve(tmp_path):
    noisy, out, samples = noisy_file(tmp_path / "noisy.csv"), tmp_path / "keys.csv", tmp_path / "motion.csv"
    smoothing = ori.smooth(keys_in(noisy), sigma=True)
    smoothing.keys.write(out)
    json_of("sample", out, "--band", "0.9", "--rate", "77", "-o", samples)
    columns = columns_of(samples)
    t, band = np.array(columns["t"], float), np.array(columns["band"], float)
    assert np.allclose(smoothing.curve.band(t), band, rtol=1e-12) and (band > 0).all()
    assert np.allclose(ori.read(out).curve("hermite-c2").band(t, 0.9), band, rtol=1e-12)
    assert (smoothing.curve.band(t, 0.99) > band).all()
    for curve in (ori.smooth(keys_in(noisy)).curve, smoothing.keys.curve("auto")):
        with pytest.raises(ori.ArgumentError, match="has no band, wanted 'measured', or keys that smooth wrote with `sigma`"):
            curve.band(t)


def test_smooth_motion_is_near_to_the_truth(tmp_path):
    noisy = keys_in(noisy_file(tmp_path / "noisy.csv"))
    smoothing = ori.smooth(noisy)
    t = noisy.times
    half = np.column_stack([0.3 * np.sin(2 * t), 0.4 * np.sin(3 * t), 0.2 * t])
    angle = np.linalg.norm(half, axis=1, keepdims=True)
    truth = np.column_stack([half * np.sinc(angle / np.pi), np.cos(angle)])
    error = 2 * np.arccos(np.minimum(1, np.abs(np.sum(truth * smoothing.curve(t), axis=1))))
    assert np.sqrt(np.mean(error**2)) < 0.4 * 0.0088 * np.sqrt(3)
    assert smoothing.noise == pytest.approx(0.0088, rel=0.1)
    assert smoothing.covers([[0, 1], [2.99, 3]]).tolist() == [[True, True], [True, False]]


@pytest.mark.parametrize("words, options", [
    ("--tolerance 0.5deg", {"tolerance": "0.5deg"}),
    ("--tolerance 0.5deg --position-tolerance 10cm --method auto", {"tolerance": "0.5deg", "position_tolerance": "10cm",
                                                                     "method": "auto"}),
    ("--tolerance 1deg --method timed-c2 --tension 0.2 --refit", {"tolerance": np.radians(1), "values": "refit",
                                                                  "method": "timed-c2:tension=0.2"}),
    ("--tolerance 0.1deg --method hermite-c1", {"tolerance": "0.1deg", "method": "hermite-c1"})])
def test_reduction_is_that_of_the_command(words, options, tmp_path):
    truth, out = EXAMPLES / "flight_truth.csv", tmp_path / "keys.csv"
    told = json_of("reduce", truth, *words.split(), "--quiet", "-o", out)
    recording = keys_in(truth)
    reduction = ori.reduce(recording, **options)
    expect_members(reduction, told)
    expect_keys(reduction.keys, out, [("angular_velocities", "wx wy wz")] if reduction.method == "hermite-c1" else ())
    assert len(reduction.keys) == told["keys"] and reduction.samples.shape == (told["keys"],)
    assert reduction.error_max == pytest.approx(np.radians(told["error_max_deg"]), rel=1e-15)
    assert reduction.error_max_time == float(told["error_max_time_s"])
    q, p = recording.rotations, reduction.curve(recording.times)
    chords = np.linalg.norm(q - np.sign(np.sum(p * q, axis=1, keepdims=True)) * p, axis=1)
    assert 4 * np.arcsin(chords.max() / 2) == pytest.approx(reduction.error_max, abs=1e-12)


SMOOTHED = {"--smooth": {"smooth": True}, "--noise 0.5deg --method auto --refit": {"noise": "0.5deg", "method": "auto", "values": "refit"},
            "--smoothing-time 0.05": {"smoothing_time": 0.05}, "--cutoff 3": {"cutoff": 3}}


@pytest.mark.parametrize("words", SMOOTHED)
def test_reduction_of_what_was_smoothed_first_is_that_of_the_command(words, tmp_path):
    noisy, out = noisy_file(tmp_path / "noisy.csv", outliers=[50, 140]), tmp_path / "keys.csv"
    told = json_of("reduce", noisy, "--tolerance", "1deg", *words.split(), "--quiet", "-o", out)
    recording = keys_in(noisy)
    reduction = ori.reduce(recording, "1deg", **SMOOTHED[words])
    expect_members(reduction, told)
    expect_keys(reduction.keys, out)
    options = {name: value for name, value in SMOOTHED[words].items() if name in ("noise", "smoothing_time", "cutoff")}
    alone = ori.smooth(recording, **options)
    assert reduction.smoothing.as_dict() == alone.as_dict()
    assert np.array_equal(reduction.smoothing.keys.rotations, alone.keys.rotations)
    assert reduction.raw_error_rms == pytest.approx(np.radians(told["smoothing"]["raw_error_rms_deg"]), rel=1e-15)
    assert reduction.raw_error_max > reduction.error_max and reduction.raw_position_error_max is None
    again = pickle.loads(pickle.dumps(reduction))
    assert again.as_dict() == reduction.as_dict() and again.smoothing.noise == alone.noise


def test_positions_are_smoothed_before_a_reduction_as_by_the_command(tmp_path):
    truth, out = EXAMPLES / "flight_truth.csv", tmp_path / "keys.csv"
    told = json_of("reduce", truth, "--tolerance", "1deg", "--position-tolerance", "1m", "--position-noise", "2cm", "--quiet", "-o", out)
    with pytest.warns(ori.ShapeWarning) as caught:
        reduction = ori.reduce(keys_in(truth), "1deg", position_tolerance=1, position_noise="2cm")
    assert caught[0].filename == __file__
    expect_members(reduction, told)
    expect_keys(reduction.keys, out)
    assert reduction.raw_position_error_max == told["smoothing"]["raw_position_error_max_m"]


def test_the_keys_file_and_the_page_of_a_smoothed_reduction_are_those_of_the_command(tmp_path):
    noisy, out = noisy_file(tmp_path / "noisy.csv"), tmp_path / "keys.csv"
    run("reduce", noisy, "--tolerance", "1deg", "--smooth", "-o", out, "--report", tmp_path / "by_command.html")
    reduction = ori.reduce(ori.read(noisy), "1deg", smooth=True)
    reduction.keys.write(tmp_path / "by_python.csv")
    assert (tmp_path / "by_python.csv").read_bytes() == out.read_bytes()
    reduction.report(tmp_path / "by_python.html")
    pages = [(tmp_path / name).read_text("utf-8") for name in ("by_command.html", "by_python.html")]
    assert all("smoothing time" in page for page in pages) and abs(len(pages[0]) - len(pages[1])) < 1000


def test_tracks_are_smoothed_each_before_they_are_reduced(tmp_path):
    recording = keys_in(noisy_file(tmp_path / "noisy.csv"))
    parts = [recording[:150], recording[150:]]
    for part, reduction in zip(parts, ori.reduce_tracks(parts, "1deg", smooth=True)):
        assert reduction.as_dict() == ori.reduce(part, "1deg", smooth=True, threads=1).as_dict()
    with pytest.raises(ori.DataError, match="curve 1: "):
        ori.reduce_tracks([parts[0], recording[:2]], "1deg", smooth=True)


def test_many_tracks_are_each_reduced(tmp_path):
    recording = keys_in(EXAMPLES / "flight_truth.csv")
    parts = [recording[a:a + 800] for a in (0, 1000, 2000)]
    for threads in (1, 2):
        together = ori.reduce_tracks(iter(parts), "0.5deg", threads=threads)
        for part, reduction in zip(parts, together):
            alone = ori.reduce(part, "0.5deg")
            assert reduction.as_dict() == alone.as_dict()
            assert np.array_equal(reduction.keys.rotations, alone.keys.rotations)
    assert ori.reduce_tracks([], 0.1) == []
    with pytest.raises(ori.DataError, match="curve 1: .*2"):
        ori.reduce_tracks([parts[0], recording[:1]], 0.1)


@pytest.mark.parametrize("words, options", [
    ("--max-rate 60deg/s", {"max_rate": "60deg/s"}),
    ("--max-rate 60,50,40deg/s --max-acceleration 90deg/s2 --per-interval --method timed-c2",
     {"max_rate": "60,50,40deg/s", "max_acceleration": "90deg/s2", "per_interval": True, "method": "timed-c2"}),
    ("--max-torque 0.5Nm --inertia=1,2,2.5", {"max_torque": 0.5, "inertia": np.diag([1, 2, 2.5])}),
    ("--duration 3min --max-speed 30m/s", {"duration": 180, "max_speed": "30m/s"})])
def test_retiming_is_that_of_the_command(words, options, tmp_path):
    given, out = EXAMPLES / "flight_keys.csv", tmp_path / "slow.csv"
    told = json_of("retime", given, *words.split(), "--quiet", "-o", out)
    retiming = ori.retime(keys_in(given), **options)
    expect_members(retiming, told)
    expect_keys(retiming.keys, out)
    assert retiming.time_scale == told["time_scale"]
    for name, certificate in retiming.certificates.items():
        assert certificate.found <= certificate.bound <= certificate.limit
        assert told[f"{name}_max_after_s"] == certificate.time


def test_rests_of_a_robot_are_kept_as_by_the_command(tmp_path):
    given, out = EXAMPLES / "robot_keys.csv", tmp_path / "slow.csv"
    told = json_of("retime", given, "--max-rate", "30deg/s", "--quiet", "-o", out)
    retiming = ori.retime(keys_in(given), max_rate="30deg/s")
    expect_members(retiming, told)
    assert retiming.rests == told["rests"] > 0
    slowest = np.linalg.norm(retiming.curve.sample(rate=1000, derivatives=1).angular_velocities, axis=1).max()
    assert 0.999 * np.radians(30) < slowest <= np.radians(30)


@pytest.mark.parametrize("words, options", [
    ("--method quintic", {"method": "quintic"}),
    ("--method timed-c2 --objective torque --inertia=1,2,2.5,0,0,0 --bounds=0,3",
     {"method": "timed-c2", "objective": "torque", "inertia": [1, 2, 2.5], "bounds": (0, 3)}),
    ("--method timed-c3 --objective jerk --free tension2", {"method": "timed-c3", "objective": "jerk", "free": ["tension2"]})])
def test_tuning_is_that_of_the_command(words, options, tmp_path):
    given, out = EXAMPLES / "flight_keys.csv", tmp_path / "tuned.csv"
    told = json_of("tune", given, *words.split(), "--quiet", "-o", out)
    tuning = ori.tune(keys_in(given), **options)
    expect_members(tuning, told)
    columns = columns_of(out)
    assert tuning.parameters.keys() == tuning.keys.settings.keys()
    for name, values in tuning.parameters.items():
        assert np.array_equal(values, columns[name])
    assert tuning.energy_after < tuning.energy_before


def test_tuning_to_a_reference_is_that_of_the_command(tmp_path):
    given, truth, out = EXAMPLES / "flight_keys.csv", EXAMPLES / "flight_truth.csv", tmp_path / "tuned.csv"
    told = json_of("tune", given, *"--method tcb --objective fit --quiet --reference".split(), truth, "-o", out)
    tuning = ori.tune(keys_in(given), "tcb", objective="fit", reference=keys_in(truth))
    expect_members(tuning, told)
    # The mean square of the angles, by hand.
    recording = keys_in(truth)
    dots = np.abs(np.sum(recording.rotations * tuning.curve(recording.times), axis=1))
    assert np.mean((2 * np.arccos(np.minimum(1, dots)))**2) == pytest.approx(tuning.energy_after, rel=1e-3)


@pytest.mark.filterwarnings("ignore::orispline.ShapeWarning")
@pytest.mark.parametrize("task, words, options", [
    ("retime", "--max-rate 30deg/s --max-acceleration 2rad/s2", {"max_rate": "30deg/s", "max_acceleration": "2rad/s2"}),
    ("tune", "--method quintic", {"method": "quintic"}),
    ("smooth", "--smoothing-time 0.5 --loss l2", {"smoothing_time": 0.5, "loss": "l2"}),
    ("reduce", "--tolerance 1deg", {"tolerance": "1deg"}),
    ("reduce", "--tolerance 1deg --smooth", {"tolerance": "1deg", "smooth": True})])
def test_results_say_what_the_command_says(task, words, options, tmp_path):
    given = EXAMPLES / "camera_keys.csv"
    lines = run(task, given, *words.split(), "-o", tmp_path / "out.csv")[1].splitlines()
    *told, _ = (line for line in lines if not line.startswith("orispline: warning: "))  # the last: where they were written
    assert str(getattr(ori, task)(ori.read(given), **options)).splitlines() == told
    assert str(getattr(ori, task)(keys_in(given), **options)).splitlines() == [told[0].replace(f" from {given}", ""), *told[1:]]


def test_keys_for_another_method_are_warned_of(tmp_path):
    tuned = tmp_path / "tuned.csv"
    run("tune", EXAMPLES / "flight_keys.csv", "--method", "quintic", "-o", tuned)
    keys = ori.read(tuned)
    with pytest.warns(ori.ShapeWarning, match="its keys are for quintic, and they are used for slerp") as found:
        ori.retime(keys, max_rate="60deg/s", method="slerp")
    assert found[0].message.code == "recipe_set_aside"
    ori.retime(keys, max_rate="60deg/s")
    ori.retime(keys, max_rate="60deg/s", method=keys.curve())


def late_gyro(late, count=800):
    """Keys of a turn to and fro at 100 Hz with noise of 0.5°, and the rates of a gyro whose stamps are late [s]."""
    dice = np.random.default_rng(5)
    t = np.arange(count) * 0.01

    def turn(at):
        return 0.8 * np.sin(3 * at) + 0.3 * np.sin(7 * at + 1)

    noise = Rotation.from_rotvec(dice.normal(size=(count, 3)) * np.radians(0.5))
    keys = ori.Keys(t, (Rotation.from_rotvec(np.outer(turn(t), [0, 0.6, 0.8])) * noise).as_quat())
    rate = 2.4 * np.cos(3 * t) + 2.1 * np.cos(7 * t + 1)
    return keys, ori.Rates(t + late, np.outer(rate, [0, 0.6, 0.8]) + 0.01 + dice.normal(size=(count, 3)) * 0.01)


def test_a_gyro_may_have_times_of_its_own():
    keys, rates = late_gyro(0.0432)
    smoothing = ori.smooth(keys, gyro=rates)
    assert smoothing.gyro_used
    assert abs(smoothing.gyro_offset - 0.0432) < 5 * smoothing.gyro_offset_sigma < 0.005
    assert len(smoothing.keys) > len(keys)  # the rates have keys too
    assert np.abs(smoothing.gyro_correction + 0.01).max() < 0.003
    assert "late" in str(smoothing)
    assert len(rates) == 800 and repr(rates) == "Rates(800 rates)"
    stated = ori.smooth(keys, gyro=rates, gyro_offset=0.0432)
    assert stated.gyro_offset == 0.0432 and stated.gyro_offset_sigma is None
    holes = rates.rates.copy()
    holes[100:103, 1] = np.nan
    assert ori.smooth(keys, gyro=ori.Rates(rates.times, holes)).gyro_used


def test_rates_are_read_from_a_file_of_their_own(tmp_path):
    keys, rates = late_gyro(0.0432)
    poses, gyro = tmp_path / "poses.csv", tmp_path / "gyro.csv"
    np.savetxt(poses, np.column_stack([keys.times + 1.7e9, keys.rotations[:, [3, 0, 1, 2]]])[::4], delimiter=",", header="t,qw,qx,qy,qz", comments="",
               fmt=["%.4f", *["%.17g"] * 4])
    np.savetxt(gyro, np.column_stack([rates.times + 1.7e9, np.degrees(rates.rates)]), delimiter=",", header="t,wx_deg_s,wy_deg_s,wz_deg_s",
               comments="", fmt=["%.4f", *["%.17g"] * 3])
    read, recording = ori.read_rates(gyro), ori.read(poses)
    assert read.epoch == decimal.Decimal("1700000000.0432") and read.times[0] == 0 and ori.Rates([0, 1], np.zeros((2, 3))).epoch == 0
    assert np.allclose(read.rates, rates.rates, rtol=1e-14, atol=0)
    assert np.array_equal(ori.read_rates(gyro, body_axes="FRD:FLU").rates, read.rates * [1, -1, -1])
    smoothing, told = ori.smooth(recording, gyro=read), json_of("smooth", poses, "--gyro-file", gyro, "-o", tmp_path / "out.csv")
    assert smoothing.gyro_used and abs(smoothing.gyro_offset - 0.0432) < 5 * smoothing.gyro_offset_sigma < 0.005
    assert smoothing.gyro_offset == pytest.approx(told["gyro_offset_s"], abs=1e-9) and len(smoothing.keys) == told["rows_written"]
    since = np.asarray(read.times) + float(read.epoch - recording.epoch)
    assert ori.smooth(recording, gyro=ori.Rates(since, read.rates)).gyro_offset == pytest.approx(smoothing.gyro_offset, abs=1e-9)


TWO_GYROS = "t,wx,wy,wz\n0,1,0,0\n1,2,0,0\n2,3,0,0\n0.5,4,0,0\n1,5,0,0\n1.5,6,0,0\n"


def test_rates_in_a_file_are_mended_as_rows_are(tmp_path):
    path = tmp_path / "gyro.csv"
    path.write_text("t,wx,wy,wz\n0,1,0,0\n2,3,0,0\n1,2,0,0\n1,9,0,0\n")
    assert ori.read_rates(path, sort=True, drop_duplicates=True).rates[:, 0].tolist() == [1, 2, 3]
    path.write_text(TWO_GYROS)
    assert [ori.read_rates(path, session=number).rates[:, 0].tolist() for number in (1, 2)] == [[1, 2, 3], [4, 5, 6]]
    path.write_text("t,wx,wy,wz\n0,1,0,0\n1,2,0,0\n")
    assert len(ori.read_rates(path, session=2)) == 2


def test_files_that_hold_no_rates_are_refused(tmp_path):
    path = tmp_path / "gyro.csv"
    for text, kind, message, options in (
            ("t,a\n0,1\n", ori.DataError, "gyro.csv:1: found 't,a', wanted the rates of the body wx, wy and wz", {}),
            ("t,wx,wy,wz\n0,1,2,3\n0,1,2,3\n", ori.DataError,
             "gyro.csv:3: duplicate time 0, as in line 2, wanted increasing times (drop_duplicates=True keeps the first)", {}),
            ("t,wx,wy,wz\n1,1,2,3\n0,1,2,3\n", ori.DataError, "gyro.csv:3: time 0 comes after 1, wanted increasing times (sort=True orders the rows)", {}),
            (TWO_GYROS, ori.DataError, "gyro.csv:5: time 0.5 comes after 2, and the rows go on from there: a second recording begins, wanted one", {}),
            (TWO_GYROS, ori.ArgumentError, "session: found 3, wanted 1 to 2, which the file has", {"session": 3}),
            ("t,wx,wy,wz\n", ori.DataError, "gyro.csv: empty: no rates", {}),
            ("t,wx,wy,wz\n0,1,2,3\n", ori.ArgumentError, "time_scale: found '0', wanted a number greater than 0", {"time_scale": 0}),
            ("t,wx,wy,wz\n0,1,2,3\n", ori.ArgumentError, "body_axes: found axes of the body of which one system is right-handed", {"body_axes": "RUB:RUF"})):
        path.write_text(text)
        with pytest.raises(kind, match=re.escape(message)):
            ori.read_rates(path, **options)
    with pytest.raises(ori.AccessError, match="none.csv: cannot open"):
        ori.read_rates(tmp_path / "none.csv")


def test_bad_rates_are_refused():
    keys, rates = late_gyro(0.0, 50)
    for times, values, error, message in (
            (rates.times[:-1], rates.rates, ori.DataError, "rates: found 50 rows and times of shape"),
            (rates.times, rates.rates[:, :2], ori.ArgumentError, "rates: found the shape"),
            (rates.times[::-1], rates.rates, ori.DataError, "gyro: time 1 does not come after the one before it"),
            (rates.times + 100, rates.rates, ori.DataError, "do not overlap the recording")):
        with pytest.raises(error, match=message):
            ori.smooth(keys, gyro=ori.Rates(times, values))
    with pytest.raises(ori.ArgumentError, match="gyro_offset: found 30"):
        ori.smooth(keys, gyro=rates, gyro_offset=30)


def test_settings_state_the_noise_of_samples():
    keys, _ = late_gyro(0.0, 200)
    weighed = ori.Keys(keys.times, keys.rotations, settings={"sigma": np.where(np.arange(200) < 100, 0.01, 0.02)})
    smoothing = ori.smooth(weighed)
    assert (smoothing.least_noise, smoothing.largest_noise) == (0.01, 0.02)
    with pytest.raises(ori.DataError, match="sigma: found -1"):
        ori.smooth(ori.Keys(keys.times, keys.rotations, settings={"sigma": np.full(200, -1.0)}))
