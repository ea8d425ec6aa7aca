# SPDX-License-Identifier: Apache-2.0
"""Keys out of every kind of frame and back, and of numbers that are no doubles."""
import decimal
import fractions

import numpy as np
import orispline as ori
import pytest

pandas, polars, pyarrow, xarray = (pytest.importorskip(name) for name in ("pandas", "polars", "pyarrow", "xarray"))
T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
KEYS = ori.Keys(T, Q)
STAMPS = np.array(["2026-01-01T00:00:00.000000007", "2026-01-02", "2026-01-04"], "datetime64[ns]")
RATES = np.array([[0, 0, 5.0], [0, 1, 0], [1, 0, 0]])
FRAMES = {"from_pandas": [ori.Keys.to_pandas], "from_polars": [ori.Keys.to_polars, lambda keys: keys.to_polars().lazy()],
          "from_arrow": [ori.Keys.to_arrow, lambda keys: keys.to_arrow().to_reader(2), lambda keys: keys.to_arrow().to_batches()[0], ori.Keys.to_polars],
          "from_xarray": [ori.Keys.to_xarray, lambda keys: xarray.Dataset({name: ("t", values) for name, values in keys.to_pandas().items()})]}
ALL = [(name, make) for name, makes in FRAMES.items() for make in makes]


@pytest.mark.parametrize(("name", "make"), ALL)
@pytest.mark.parametrize("scalar_first", [False, True])
@pytest.mark.parametrize("times", [T, STAMPS, STAMPS - STAMPS[0]], ids=["numbers", "stamps", "durations"])
def test_keys_go_into_a_frame_and_come_back(name, make, scalar_first, times):
    rotations = np.roll(Q, 1, axis=1) if scalar_first else Q
    for more in ({}, {"positions": np.eye(3)}, {"positions": np.eye(3), "angular_velocities": RATES, "inner_arriving": rotations, "settings": {"tension": [1, 2, 3]}}):
        keys = ori.Keys(times, rotations, scalar_first=scalar_first, **more)
        assert getattr(ori.Keys, name)(make(keys), scalar_first=scalar_first) == keys


@pytest.mark.parametrize(("name", "make"), [pair for pair in ALL if pair[1] is not ori.Keys.to_polars and pair[0] != "from_polars"][:-1])
def test_frames_remember_the_epoch_of_a_file(name, make, tmp_path):
    (tmp_path / "keys.csv").write_text("t,qw,qx,qy,qz\n1700000000.000000001,1,0,0,0\n1700000000.5,0.8,0,0,0.6\n")
    keys = ori.read(tmp_path / "keys.csv")
    found = getattr(ori.Keys, name)(make(keys))
    assert found == keys and found.epoch == keys.epoch == decimal.Decimal("1700000000.000000001")


@pytest.mark.parametrize("word", ["J2000", None, 0, "0.0", float("nan"), "inf"])
def test_an_epoch_that_is_no_number_is_somebody_elses_word(word):
    frame = KEYS.to_pandas()
    frame.attrs["epoch"] = word
    assert ori.Keys.from_pandas(frame).epoch == 0 and ori.Keys.from_pandas(frame) == KEYS
    frame.attrs["epoch"] = "1e9"
    assert ori.Keys.from_pandas(frame).epoch == 10**9


def test_names_and_types_of_frames_may_be_others():
    names = {"t": "stamp", "qw": "w"}
    frame = KEYS.to_pandas().rename(columns=names).assign(temperature=20.0, place="here")
    categories = pyarrow.table({name: pyarrow.array(frame[name]).dictionary_encode() for name in frame})
    decimals = polars.from_pandas(frame).with_columns(polars.col("stamp").cast(polars.Decimal(20, 6)))
    for found in (ori.Keys.from_polars(polars.from_pandas(frame), columns=names), ori.Keys.from_arrow(pyarrow.table(frame), columns=names),
                  ori.Keys.from_arrow(categories, columns=names), ori.Keys.from_polars(decimals, columns=names),
                  ori.Keys.from_pandas(frame.astype({"stamp": "double[pyarrow]", "w": "Float64"}), columns=names),
                  ori.Keys.from_xarray(frame.set_index("stamp").to_xarray(), columns=names),
                  ori.Keys.from_xarray(KEYS.to_xarray().rename(t="stamp", orientation="attitude"), columns={"t": "stamp", "orientation": "attitude"}),
                  ori.Keys.from_xarray(KEYS.to_xarray().isel(quaternion=[3, 1, 0, 2]).transpose())):
        assert found == KEYS


def test_chunks_of_dask_are_read():
    pytest.importorskip("dask")
    assert ori.Keys.from_xarray(KEYS.to_xarray().chunk({"t": 1})) == KEYS


@pytest.mark.parametrize("chunks", [None, {"track": 1}])
@pytest.mark.parametrize("scalar_first", [False, True])
def test_a_curve_at_the_times_of_a_data_array_is_one_with_its_dims_and_coordinates(scalar_first, chunks):
    if chunks:
        pytest.importorskip("dask")
    curve = ori.Curve(T, np.roll(Q, 1, axis=1) if scalar_first else Q, positions=np.eye(3), scalar_first=scalar_first)
    values = np.linspace(-1, 4, 12).reshape(3, 4)
    times = xarray.DataArray(values, dims=("track", "sample"), coords={"track": ("track", ["a", "b", "c"], {"of": "a log"})}, attrs={"units": "s"})
    given = times.chunk(chunks) if chunks else times
    for name, function, more, attrs in (("orientation", curve, {}, {}), ("orientation", curve.at, {"dtype": "float32"}, {}),
                                        ("angular_velocity", curve.angular_velocity, {"frame": "world"}, {"units": "rad/s", "frame": "world"}),
                                        ("angular_jerk", curve.derivative(3), {}, {"units": "rad/s3", "frame": "body"}),
                                        ("position", curve.position, {}, {"units": "m"}), ("acceleration", curve.acceleration, {"threads": 2}, {"units": "m/s2"})):
        found, last = function(given, **more), "quaternion" if name == "orientation" else "axis"
        assert (found.name, found.dims, found.attrs, found["track"].attrs) == (name, ("track", "sample", last), attrs, {"of": "a log"})
        assert "".join(found[last].values) == (("wxyz" if scalar_first else "xyzw") if name == "orientation" else "xyz")
        assert (found.chunks is not None) == bool(chunks) and np.array_equal(found, function(values, **more)) and found.dtype == function(values, **more).dtype
    assert np.array_equal(curve.as_matrix(given), curve.as_matrix(values)) and np.array_equal(curve.torque(given, [1, 2, 2.5]), curve.torque(values, [1, 2, 2.5]))
    assert curve.motion(given[0, 0]) == curve.motion(-1.0) and ori.Keys(times[0] + 1, curve(times[0])) == ori.Keys(values[0] + 1, curve(values[0]), scalar_first=False)
    with pytest.raises(ori.ArgumentError, match="out: found it with a DataArray of xarray, wanted none"):
        curve(given, out=np.empty((3, 4, 4)))


def test_stamps_of_xarray_stay_coordinates():
    stamps = xarray.DataArray(STAMPS, dims="time", coords={"time": STAMPS})
    found = ori.Curve(STAMPS, Q).angular_velocity(stamps)
    assert found.dims == ("time", "axis") and np.array_equal(found["time"], STAMPS)
    with pytest.raises(ori.ArgumentError, match="t: found an array of datetime64.*, wanted numbers"):
        ori.Curve(T, Q)(stamps)


@pytest.mark.parametrize(("make", "error", "text"), [
    (lambda: ori.Keys.from_polars(KEYS.to_pandas()), TypeError, "frame: found .* wanted a Polars DataFrame or LazyFrame"),
    (lambda: ori.Keys.from_arrow([1]), TypeError, "table: found .* wanted a pyarrow Table"),
    (lambda: ori.Keys.from_xarray(KEYS.to_xarray()["orientation"]), TypeError, "dataset: found .* wanted an xarray Dataset"),
    (lambda: ori.Keys.from_xarray(KEYS.to_xarray().drop_vars("quaternion")), ori.ArgumentError,
     "dataset: found 'orientation' with the dimensions 't', 'quaternion', wanted one of them with the coordinate w, x, y, z"),
    (lambda: ori.Keys.from_polars(KEYS.to_polars().rename({"t": "timestamp"})), ori.ArgumentError, "columns: found no t, wanted .* such as {'t': 'timestamp'}"),
    (lambda: ori.Keys.from_arrow(KEYS.to_arrow().rename_columns(["Time (s)", "qw", "qx", "qy", "qz"])), ori.ArgumentError, r"such as {'t': 'Time \(s\)'}"),
    (lambda: ori.Keys.from_polars(KEYS.to_polars().rename({"t": "where"})), ori.ArgumentError, "such as {'t': 'stamp'}"),
    (lambda: ori.Keys.from_arrow(KEYS.to_arrow(), columns={"t": "time"}), ori.ArgumentError, "columns: found no 'time', wanted one of 't', 'qw'")])
def test_other_frames_are_refused(make, error, text):
    with pytest.raises(error, match=text):
        make()


@pytest.mark.parametrize(("make", "reader"), [(ori.Keys.to_pandas, "from_pandas"), (ori.Keys.to_polars, "from_polars"), (lambda k: k.to_polars().lazy(), "from_polars"),
                                              (ori.Keys.to_arrow, "from_arrow"), (ori.Keys.to_xarray, "from_xarray")])
def test_a_frame_in_the_place_of_keys_is_told_how_it_is_read(make, reader):
    frame = make(KEYS)
    for use in (ori.Keys, ori.Curve, ori.smooth, ori.retime, lambda given: ori.reduce(given, "1deg"), lambda given: ori.align(given, KEYS), lambda given: ori.Keys(given, Q)):
        with pytest.raises(ori.ArgumentError, match=rf"found a \w+ of {reader[5:].replace('arrow', 'pyarrow')}, wanted times and rotations, or Keys.{reader}\(frame\)"):
            use(frame)


def test_samples_go_into_every_frame():
    curve = ori.Curve(T, Q, positions=np.eye(3))
    for samples in (curve.sample(rate=4, derivatives=2), ori.Curve(STAMPS, np.roll(Q, 1, axis=1), scalar_first=True).sample(count=5)):
        frame, table, arrow = samples.to_pandas(), samples.to_polars(), samples.to_arrow()
        assert table.columns == list(frame.columns) == arrow.column_names
        assert all(np.array_equal(table[name].to_numpy(), frame[name].to_numpy()) for name in frame)
        dataset = samples.to_xarray()
        assert np.array_equal(dataset["orientation"], samples.orientations) and "".join(dataset["quaternion"].values) in ("xyzw", "wxyz")
        assert np.array_equal(dataset["t"], samples.times) and decimal.Decimal(dataset.attrs["epoch"]) == samples.epoch
        assert samples.angular_velocities is None or dataset["angular_velocity"].attrs == {"units": "rad/s", "frame": "body"}
        assert ori.Keys.from_xarray(dataset) == ori.Keys.from_polars(table) == ori.Keys.from_arrow(arrow)
    stack = ori.CurveStack(T, [[q, q] for q in Q]).sample(count=4, derivatives=1)
    assert dict(stack.to_xarray().sizes) == {"t": 4, "joint": 2, "quaternion": 4, "axis": 3}


def test_other_numbers_are_read_as_doubles():
    halves = [decimal.Decimal("0.0"), fractions.Fraction(1), 3]
    for times in (halves, tuple(halves), np.array(T, np.longdouble), np.array(T, object), pandas.Series(halves), pandas.Index(halves, dtype=object)):
        assert ori.Keys(times, Q) == KEYS
    for rotations in (np.array(Q, object), np.array(Q, np.longdouble), [[decimal.Decimal(str(x)) for x in row] for row in Q]):
        assert ori.Keys(T, rotations) == KEYS
    whole = ori.Keys(np.array([1700000000000000001, 1700000000000000002, 1700000000000000004], object), Q, time_unit="ns")
    assert whole.times.tolist() == [1700000000000000001, 1700000000000000002, 1700000000000000004]
    curve = KEYS.curve()
    assert np.array_equal(curve([decimal.Decimal("0.5"), fractions.Fraction(1, 3)]), curve([0.5, 1 / 3]))


@pytest.mark.parametrize(("times", "text"), [
    ([decimal.Decimal("1700000000.0000001"), 1700000001, 1700000002], "times: found Decimal that would be rounded by 1e-07 s, wanted seconds that doubles hold"),
    (np.array([1700000000, 1700000001, 1700000002], np.longdouble) + np.longdouble(1) / 10**7, "times: found longdouble that would be rounded"),
    (pandas.period_range("2026-01", periods=3), r"times: found periods, wanted times: .to_timestamp\(\) has those at which they begin"),
    (pandas.Series(pandas.period_range("2026-01", periods=3)), "times: found periods"),
    ([0, 1, 10**400], "times: found numbers that no double is near to"), (np.array([0, 1, None]), "times: found objects of type NoneType, int, wanted real numbers"),
    (np.array([True, 1, 2], object), "times: found objects of type bool, int"), ([0, 1, decimal.Decimal("sNaN")], "times: found numbers that no double"),
    ([pandas.Timestamp("2026-01-01"), pandas.Timestamp("2026-01-02", tz="UTC"), pandas.Timestamp("2026-01-03")], "times: found dates with a time zone and dates without")])
def test_what_would_lose_digits_or_is_no_time_is_refused(times, text):
    with pytest.raises(ori.ArgumentError, match=text):
        ori.Keys(times, Q)


@pytest.mark.parametrize(("times", "key", "cure"), [([0, 1, 1], 2, "drop_duplicates=True keeps the first"), ([0, 2, 1], 2, "sort=True puts them in order"),
                                                    (STAMPS[[0, 0, 1]], 1, "drop_duplicates=True keeps the first"), (STAMPS[::-1], 1, "sort=True puts them in order")])
def test_a_clock_that_does_not_rise_is_told_what_mends_it(times, key, cure):
    for make in (ori.Keys, ori.Curve, lambda t, q: ori.Keys.from_pandas(KEYS.to_pandas().assign(t=t)), ori.smooth, lambda t, q: ori.reduce(t, q, "1deg")):
        with pytest.raises(ori.DataError, match=rf"^key {key}: .*, wanted strictly increasing times \({cure}\)$") as found:
            make(times, Q)
        assert found.value.key == key
        option = cure.partition("=")[0]
    assert len(ori.Keys(times, Q, **{option: True})) == (2 if "drop" in option else 3)
    with pytest.raises(ori.DataError, match="^joint 0: key .* wanted strictly increasing times$"):
        ori.CurveStack(times, np.array(Q)[:, None])


def test_frames_go_through_parquet(tmp_path):
    for thing in (ori.Keys(STAMPS, Q), ori.Curve(STAMPS, Q).sample(count=3, derivatives=1)):
        thing.to_pandas().to_parquet(tmp_path / "frame.parquet")
        found = ori.Keys.from_pandas(pandas.read_parquet(tmp_path / "frame.parquet"))
        assert found.epoch == thing.epoch and np.array_equal(found.times, thing.times)


def test_an_index_that_counts_rows_has_no_times():
    bare = KEYS.to_pandas().drop(columns="t")
    filtered = pandas.concat([bare, bare]).reset_index(drop=True)[::2].assign(time=T)
    for frame, named in ((bare, "stamp"), (bare.set_index(STAMPS).reset_index(names="timestamp"), "timestamp"), (filtered.loc[[0, 2, 4]], "time"),
                         (filtered.set_index(pandas.Index([0, 1, 5])), "time")):
        with pytest.raises(ori.ArgumentError, match=f"columns: found no t, wanted .*: name yours by columns=, such as {{'t': '{named}'}}"):
            ori.Keys.from_pandas(frame)
    for index in (pandas.Index([0, 1, 3]), pandas.RangeIndex(3, name="time"), pandas.Index(T), STAMPS):
        assert len(ori.Keys.from_pandas(bare.set_index(index))) == 3


def test_columns_that_are_missing_or_twice_there_are_told():
    for name in ("rot_w", "W"):
        with pytest.raises(ori.ArgumentError, match=f"found no qw, wanted .* such as {{'qw': '{name}'}}"):
            ori.Keys.from_pandas(KEYS.to_pandas().rename(columns={"qw": name}))
    frame = KEYS.to_pandas()
    with pytest.raises(ori.ArgumentError, match="columns: found 't' twice, wanted it once"):
        ori.Keys.from_pandas(pandas.concat([frame["t"], frame], axis=1))


def test_quaternions_in_a_frame_stand_in_the_order_in_which_they_are_read():
    frame = KEYS.to_pandas()
    for given in (frame, polars.from_pandas(frame)):
        w_first, w_last = given[["qw", "qx", "qy", "qz"]], given[["qx", "qy", "qz", "qw"]]
        assert ori.Keys(T, w_last) == KEYS and np.array_equal(ori.Keys(T, w_first, scalar_first=True).rotations, np.roll(Q, 1, axis=1))
        for work in (lambda q: ori.Keys(T, q), lambda q: ori.Curve(T, q), ori.mean, lambda q: ori.CurveStack([(T, q)]), lambda q: ori.reduce(T, q, 0.1)):
            with pytest.raises(ori.ArgumentError, match="rotations: found the columns qw, qx, qy, qz, wanted qx, qy, qz, qw, or scalar_first=True"):
                work(w_first)
        with pytest.raises(ori.ArgumentError, match="found the columns qx, qy, qz, qw, wanted qw, qx, qy, qz, or scalar_first=False"):
            ori.Curve(T, w_last, scalar_first=True)
