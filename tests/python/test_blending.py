# SPDX-License-Identifier: Apache-2.0
"""Blending functions of one's own: what they are, and that every call which takes a method takes them."""
import copy
import fractions
import json
import pickle

import numpy as np
import orispline as ori
import pytest
from orispline import _core

TAN = [["1", "1+a/5", "1+7*a/20", "1", "1", "1"], ["0", "a/5", "9*a/20", "1-9*b/20", "1-b/5", "1"], ["0", "0", "0", "-7*b/20", "-b/5", "0"]]
XING = np.array([[8, 9, 8, 8, 8], [0, 1, 4, 7, 8], [0, 0, 0, -1, 0]]) / 8
MINE = ori.blending("mine", TAN, parameters={"tension": 0.5}, title="Tan's quintic, typed in")
OTHER = ori.blending("mine", [[0, 1]])


def walk(count=12, seed=7):
    """Keys at uneven times."""
    rng = np.random.default_rng(seed)
    q = np.cumsum(rng.normal(size=(count, 4)), axis=0) + [0, 0, 0, 4]
    return ori.Keys(np.cumsum(rng.uniform(0.4, 1.6, count)), q, normalize=True, positions=rng.normal(size=(count, 3)))


KEYS = walk()
RECORDING = KEYS.curve("quintic").sample(rate=20)
RECORDING = ori.Keys(RECORDING.times, RECORDING.orientations)


def expect_same(one, other, within=1e-14):
    """Two curves, with their rates."""
    t = np.linspace(*other.domain, 301)
    assert np.allclose(one(t), other(t), rtol=0, atol=within)
    assert np.allclose(one.angular_acceleration(t), other.angular_acceleration(t), rtol=0, atol=1e4 * within)


def test_rows_typed_in_are_the_built_in_method():
    expect_same(ori.Curve(KEYS.times, KEYS.rotations, MINE), ori.Curve(KEYS.times, KEYS.rotations, "quintic"))
    for settings in ({"tension": 0.3}, {"tension": np.linspace(0.2, 0.7, len(KEYS))}, {"ends": "natural"}):
        expect_same(KEYS.curve(MINE, **settings), KEYS.curve("quintic", **settings))
    per_key = ori.Keys(KEYS.times, KEYS.rotations, settings={"tension": np.linspace(0.2, 0.7, len(KEYS))})
    expect_same(per_key.curve(MINE), per_key.curve("quintic"))


@pytest.mark.parametrize("rows", [XING, XING.tolist(), [tuple(row) for row in XING],
                                  [[fractions.Fraction(entry) for entry in row] for row in XING]])
def test_fixed_rows_may_be_arrays_and_numbers(rows):
    expect_same(KEYS.curve(ori.blending("fixed", rows)), KEYS.curve("xing-quartic"))


def test_other_bases_are_the_same_curve():
    powers = ori.blending("powers", [[1, 0.5, -1.5, 1.5, -0.5], [0, 0.5, 1.5, -1, 0], [0, 0, 0, -0.5, 0.5]], basis="power")
    points = ori.blending("points", [[0, -1 / 8, 0, 0, 0], [1, 1, 0.5, 1 / 8, 0], [0, 1 / 8, 0.5, 1, 1], [0, 0, 0, -1 / 8, 0]], basis="bezier")
    for one in (powers, points):
        expect_same(KEYS.curve(one), KEYS.curve("xing-quartic"), 1e-13)


def test_what_it_is_is_found_and_told():
    assert (MINE.name, MINE.title, MINE.info["title"]) == ("mine", "Tan's quintic, typed in", "Tan's quintic, typed in")
    assert repr(MINE) == "Blending('mine', tension=0.5: C2 on even keys, C0 on uneven keys, G2)"
    found = {finding.promise: finding for finding in MINE.findings}
    assert found["interpolates"].order == 1 and found["continuity_uniform"].order == MINE.info["continuity_uniform"] == 2
    assert found["continuity_uneven"].order == 0 and found["continuity_uneven"].why
    assert str(MINE).splitlines()[0] == "mine: Tan's quintic, typed in"
    assert str(MINE).splitlines()[1:] == [finding.sentence for finding in MINE.findings if finding.sentence]
    short = ori.blending("short", [["0", "0.95"]])
    assert repr(short).startswith("Blending('short': not through its keys, ")
    assert "0.95" in next(finding for finding in short.findings if finding.promise == "interpolates").why


def test_the_same_data_is_the_same_wherever_it_is_kept(tmp_path):
    path = tmp_path / "mine.json"
    path.write_text(json.dumps({"name": "mine", "title": MINE.title, "parameters": {"tension": 0.5}, "rows": TAN}), "utf-8")
    again = [ori.read_blending(path), ori.read_blending(str(path)), pickle.loads(pickle.dumps(MINE)), copy.copy(MINE), copy.deepcopy(MINE)]
    path.write_text(MINE.to_json(), "utf-8")
    again.append(ori.read_blending(path))
    assert set(again) == {MINE} and MINE not in (OTHER, "mine") and len({MINE, OTHER}) == 2
    ranged = ori.blending("mine", TAN, parameters={"tension": {"default": 0.5, "min": 0, "max": np.float32(1)}}, first=-1, ends="natural")
    assert ranged != MINE and json.loads(ranged.to_json())["first"] == -1 and ranged.info["ends"][0] == "natural"
    with pytest.raises(ori.ArgumentError, match=r"tension is 1.5, wanted .*1"):
        KEYS.curve(ranged, tension=1.5)


def test_a_text_form_carries_the_rows():
    words = MINE.with_settings(tension=0.3, ends=("natural", "rest"))
    assert words == "mine:tension=0.3:ends=natural,rest" and isinstance(words, str)
    curve = KEYS.curve(words)
    assert curve.blending == MINE and curve.method == words and KEYS.curve("quintic").blending is None
    for again in (pickle.loads(pickle.dumps(curve)), copy.deepcopy(curve), KEYS.curve(curve), KEYS.curve(curve.method)):
        assert again.method == words and again.blending == MINE and np.array_equal(again(2.5), curve(2.5))
    assert pickle.loads(pickle.dumps(words)).blending == MINE
    with pytest.raises(ori.ArgumentError, match="unknown method 'mine'|'mine'"):
        KEYS.curve("mine")


def test_streams_and_stacks_take_it():
    online, curve = ori.OnlineCurve(MINE, tension=0.4), KEYS.curve(MINE, tension=0.4)
    for t, q in KEYS:
        online.append(t, q)
    online.finish()
    t = np.linspace(*curve.domain, 77)
    assert np.array_equal(online(t), curve(t)) and "'mine:tension=0.4'" in repr(online)
    stack = ori.CurveStack(KEYS.times, np.stack([KEYS.rotations] * 2, axis=1), MINE, tension=0.4)
    assert np.array_equal(stack(t)[:, 1], curve(t)) and stack.method == "mine:tension=0.4"
    assert np.array_equal(pickle.loads(pickle.dumps(stack))(t), stack(t))


def test_tasks_take_it_and_what_they_find_carries_it():
    tuning, built_in = ori.tune(KEYS, MINE), ori.tune(KEYS, "quintic")
    assert np.allclose(tuning.parameters["tension"], built_in.parameters["tension"], rtol=0, atol=1e-7)
    results = [tuning, ori.retime(KEYS, method=MINE, max_rate="40deg/s"), ori.reduce(RECORDING, "0.5deg", method=[MINE, "slerp"]),
               ori.reduce(RECORDING, "0.5deg", method=MINE.with_settings(tension=0.5))]
    for result in results:
        for each in (result, pickle.loads(pickle.dumps(result))):
            assert each.method.startswith("mine") and each.curve.blending == MINE and each.keys.curve().blending == MINE


def test_it_is_compared_beside_others():
    methods = [MINE, MINE.with_settings(tension=0.3), "quintic", KEYS.curve("auto")]
    comparison = ori.compare(RECORDING, methods, keep_every=20)
    rows = {row["method"]: row["rms_deg"] if "rms_deg" in row else row for row in comparison.table()}
    assert set(rows) == {"mine", "mine:tension=0.3", "quintic", "auto"}
    for each in (comparison, pickle.loads(pickle.dumps(comparison))):
        curves = {row["method"]: each.curve(i) for i, row in enumerate(each.table())}
        assert curves["mine:tension=0.3"].blending == MINE
        expect_same(curves["mine"], curves["quintic"])
    assert {row["method"] for row in ori.compare(RECORDING, MINE, keep_every=20, tune=True).table()} == {"mine", "mine:tuned"}
    with pytest.raises(ori.ArgumentError, match="none twice"):
        ori.compare(RECORDING, [MINE, OTHER])


def test_files_of_keys_carry_the_rows(tmp_path):
    path, curve = tmp_path / "keys.csv", KEYS.curve(MINE, tension=0.4)
    curve.keys.write(path)
    ori.write(curve, path)
    read = ori.read(path)
    for keys in (read, pickle.loads(pickle.dumps(read)), copy.deepcopy(read)):
        assert keys.curve().method == "mine:tension=0.4" and keys.curve().blending == MINE
        assert keys.curve(ends="natural").blending == MINE
    t = np.linspace(*read.curve().domain, 50)
    assert np.allclose(read.curve()(t), curve(t + curve.domain[0]), rtol=0, atol=1e-12)
    read.curve(MINE, tension=0.4)
    with pytest.warns(ori.ShapeWarning, match="its keys are for mine:tension=0.4, and they are used for mine$"):
        read.curve(MINE)
    ori.write(KEYS.curve(MINE), path)
    with pytest.warns(ori.ShapeWarning, match="its keys are for mine, and they are used for other blending functions of that name"):
        ori.read(path).curve(OTHER)


def test_settings_with_one_value_for_each_key_come_back_from_a_file(tmp_path):
    own = ori.blending("own", [["1", "1+a/5", "1+7*a/20", "1", "1", "1"], *TAN[1:]], parameters={"pull": 0.5})
    curve = KEYS.curve(own, pull=np.linspace(0.2, 0.7, len(KEYS)))
    ori.write(curve, tmp_path / "keys.csv")
    read = ori.read(tmp_path / "keys.csv")
    assert read.curve().blending == own and np.allclose(read.curve().settings["pull"], curve.settings["pull"], rtol=0, atol=1e-12)


def test_pictures_name_it(tmp_path):
    curve = KEYS.curve(MINE)
    assert "mine" in curve._repr_svg_()
    curve.report(tmp_path / "curve.html")
    assert "mine" in (tmp_path / "curve.html").read_text("utf-8")
    assert curve.bake(1e-9).largest_difference < 1e-9


def test_the_state_of_a_long_track_carries_it():
    sampler = _core.TrackSampler(MINE.with_settings(tension=0.4), "10", False, None)
    columns = [np.ascontiguousarray(column) for column in (KEYS.times, *KEYS.rotations.T)]
    sampler.append([column[:6] for column in columns])
    again = _core.TrackSampler.from_state(sampler.state)
    for each in (sampler, again):
        each.append([column[6:] for column in columns])
        each.finish()
    count = sampler.ready
    assert count > 20 and all(map(np.array_equal, sampler.take(count, 1, False, False, 1), again.take(count, 1, False, False, 1)))


BAD = [
    (ori.ArgumentError, "row 2, entry 1", lambda: ori.blending("mine", [["1", "1"], ["1+", "0"], ["0", "0"]])),
    (ori.ArgumentError, "row 1, entry 2", lambda: ori.blending("mine", [[0, np.nan]])),
    (ori.ArgumentError, "name", lambda: ori.blending("quintic", [[0, 1]])),
    (ori.ArgumentError, "name", lambda: ori.blending("Mine", [[0, 1]])),
    (ori.ArgumentError, "first", lambda: ori.blending("mine", [[0, 1], [0, 1]])),
    (ori.ArgumentError, "first", lambda: ori.blending("mine", [[0, 1]], first=10**9)),
    (ori.ArgumentError, "basis", lambda: ori.blending("mine", [[0, 1]], basis="hermite")),
    (ori.ArgumentError, "ends", lambda: ori.blending("mine", TAN, parameters={"tension": 1}, ends="never")),
    (ori.ArgumentError, "parameters", lambda: ori.blending("mine", [[0, 1]], parameters={"tension": np.inf})),
    (ori.ArgumentError, "parameters", lambda: ori.blending("mine", [[0, 1]], parameters={"tension": {"least": 1}})),
    (ori.ArgumentError, "title", lambda: ori.blending("mine", [[0, 1]], title="two\nlines")),
    (ori.ArgumentError, "UTF-8", lambda: ori.blending("mine", [[0, 1]], title="\udc80")),
    (ori.ArgumentError, "rows", lambda: ori.blending("mine", np.zeros((0, 4)))),
    (TypeError, "rows", lambda: ori.blending("mine", "rows")),
    (TypeError, "rows", lambda: ori.blending("mine", 3)),
    (TypeError, "rows: row 1", lambda: ori.blending("mine", ["0,1"])),
    (TypeError, "rows: row 1", lambda: ori.blending("mine", [0, 1])),
    (TypeError, "row 1, entry 1", lambda: ori.blending("mine", [[None, 1]])),
    (TypeError, "row 1, entry 1", lambda: ori.blending("mine", [[True, 1]])),
    (TypeError, "row 1, entry 1", lambda: ori.blending("mine", np.zeros((1, 2, 2)))),
    (TypeError, "name", lambda: ori.blending(3, [[0, 1]])),
    (TypeError, "parameters", lambda: ori.blending("mine", [[0, 1]], parameters=["tension"])),
    (TypeError, "first", lambda: ori.blending("mine", [[0, 1]], first="own")),
    (TypeError, "read_blending", lambda: ori.Blending()),
    (TypeError, "wanted method=", lambda: ori.Curve(KEYS, MINE)),
    (ori.ArgumentError, "unknown", lambda: KEYS.curve(MINE, bias=1)),
    (ori.ArgumentError, "tension", lambda: KEYS.curve(MINE, tension=1e9)),
    (ori.AccessError, "nowhere", lambda: ori.read_blending("nowhere.json")),
]


@pytest.mark.parametrize(("kind", "words", "ask"), BAD, ids=range(len(BAD)))
def test_what_cannot_be_is_said_in_a_line(kind, words, ask):
    with pytest.raises(kind) as found:
        ask()
    assert words in str(found.value) and "\n" not in str(found.value)


@pytest.mark.parametrize(("content", "words"), [('{"name": "mine",\n "rows": [}', "not valid JSON"), ('{"name": "mine", "rows": [[0, "1+"]]}', "row 1, entry 2"),
                                                ('{"name": "squad", "rows": [[0, 1]]}', "'squad'"), ("[]", "wanted an object")])
def test_a_file_that_is_none_is_bad_data(content, words, tmp_path):
    path = tmp_path / "bad.json"
    path.write_text(content, "utf-8")
    with pytest.raises(ori.DataError) as found:
        ori.read_blending(path)
    assert words in str(found.value) and str(path) in str(found.value) and found.value.file == str(path)


# Tables of many tracks.


@pytest.fixture(scope="module")
def tables():
    pytest.importorskip("pyarrow")
    return pytest.importorskip("orispline.tables")


def table(pa):
    """Three tracks."""
    rows = [(track, t, *q) for track in range(3) for t, q in walk(14, track)]
    return pa.table(dict(zip(("track", "t", "qx", "qy", "qz", "qw"), map(list, zip(*rows)))))


def columns_of(found, names=("qw", "wx")):
    return np.array([found[name].to_pylist() for name in names])


def test_jobs_of_tables_take_it(tables):
    pa = pytest.importorskip("pyarrow")
    keys, at = table(pa), pa.table({"track": [0, 1], "t": [5.0, 5.5]})
    for job in (lambda method: tables.resample(keys, rate=10, method=method, tension=0.4),
                lambda method: tables.evaluate(keys, at, method=method, derivatives=1, tension=0.4)):
        assert np.allclose(columns_of(job(MINE).read_all()), columns_of(job("quintic").read_all()), rtol=0, atol=1e-12)
    reduced = tables.reduce(keys, "1deg", method=MINE).read_all()
    assert reduced["error"].null_count == len(reduced) and set(reduced["method"].to_pylist()) == {"mine"}
    compared = tables.compare(keys, [MINE, MINE.with_settings(tension=0.3)], 2).read_all()
    assert set(compared["method"].to_pylist()) == {"mine", "mine:tension=0.3"}


def test_files_are_made_again_for_other_rows(tables, tmp_path):
    pa = pytest.importorskip("pyarrow")
    pytest.importorskip("duckdb")
    import pyarrow.parquet as pq
    pq.write_table(table(pa), tmp_path / "keys.parquet")
    out = tmp_path / "out"

    def made(method):
        tables.resample_files(tmp_path / "keys.parquet", out, method=method, rate=10)
        return (out / "keys.parquet").stat().st_mtime_ns

    first = made(MINE)
    assert made(pickle.loads(pickle.dumps(MINE))) == first
    second = made(OTHER)
    assert second != first and made(MINE) not in (first, second)


def test_the_command_of_tables_reads_files_of_it(tables, tmp_path, capsys):
    pa = pytest.importorskip("pyarrow")
    pytest.importorskip("duckdb")
    import pyarrow.parquet as pq
    from orispline.tables._command import main
    pq.write_table(table(pa), tmp_path / "keys.parquet")
    (tmp_path / "mine.json").write_text(MINE.to_json(), "utf-8")
    words = ["resample", str(tmp_path / "keys.parquet"), "-o", str(tmp_path / "motion.parquet"), "--rate", "10", "--method", "mine:tension=0.4"]
    assert main([*words, "--blending", str(tmp_path / "mine.json")]) == 0
    wanted = tables.resample(table(pa), rate=10, method="quintic", tension=0.4).read_all()
    assert np.allclose(columns_of(pq.read_table(tmp_path / "motion.parquet")), columns_of(wanted), rtol=0, atol=1e-12)
    assert main(words) == 2 and "'mine'" in capsys.readouterr().err
    assert main([*words, "--blending", str(tmp_path / "nowhere.json")]) == 3
    words = ["compare", str(tmp_path / "keys.parquet"), "-o", str(tmp_path / "table.parquet"), "--keep-every", "2", "--methods", "mine,slerp"]
    assert main([*words, "--blending", str(tmp_path / "mine.json")]) == 0


def test_a_job_for_other_machines_carries_it(tables):
    from orispline.tables._jobs import resampling_of
    job = resampling_of({"method": MINE, "rate": 10, "tension": 0.4})
    assert pickle.loads(pickle.dumps(job)) == job and pickle.loads(pickle.dumps(job)).method.blending == MINE
    assert job.stated["blending"] == MINE.to_json() and "blending" not in resampling_of({"method": "quintic"}).stated
