# SPDX-License-Identifier: Apache-2.0
"""What is said of a name that there is not: the one by which the package has it, or those that are spelt like it."""
from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

# By the class or the module that is asked, names of other libraries, and what does the same here.
ELSEWHERE: dict[str, dict[str, str]] = {
    "orispline": {
        **dict.fromkeys(("load", "open", "read_csv", "from_csv", "loadtxt"), "read(path)"),
        **dict.fromkeys(("save", "to_csv", "savetxt"), "write(what, path)"),
        **dict.fromkeys(("resample", "sample", "interp", "interpolate", "evaluate"),
                        "Curve(times, rotations).sample(rate=…), or tables.resample(frame, …) for many tracks"),
        **dict.fromkeys(("CubicSpline", "make_interp_spline", "interp1d", "Spline", "Interpolator"), "Curve(times, rotations), or RotationSpline as in SciPy"),
        **dict.fromkeys(("slerp", "squad", "quintic"), "Curve(times, rotations, method), where method is such a name"),
        **dict.fromkeys(("plot", "show", "figure"), "Curve(times, rotations).plot(), or plot_comparison(curves) for several"),
        **dict.fromkeys(("average", "median", "mean_rotations"), "mean(rotations), with kind='median' for the median"),
        **dict.fromkeys(("filter", "lowpass", "savgol_filter", "filtfilt", "denoise"), "smooth(times, rotations), with cutoff= for a frequency"),
        **dict.fromkeys(("decimate", "simplify", "compress"), "reduce(times, rotations, tolerance)"),
        **dict.fromkeys(("optimize", "optimise", "fit"), "tune(times, rotations, method)"),
        **dict.fromkeys(("register", "calibrate", "align_vectors", "umeyama"), "align(a, b)"),
        **dict.fromkeys(("Rotation", "Quaternion", "quaternion"), "Keys(times, rotations), which take arrays and SciPy's Rotation"),
        "Trajectory": "Keys(times, rotations)", "Gyro": "Rates(times, rates)"},
    "OrientationCurve": {
        **dict.fromkeys(("as_quat", "quaternions", "rotations", "orientation", "evaluate", "interpolate", "interp"), "at(t), quaternions at times t"),
        **dict.fromkeys(("omega", "rates", "angular_rate", "angular_rates"), "angular_velocity(t)"),
        **dict.fromkeys(("alpha", "jerk"), "angular_acceleration(t) and angular_jerk(t)"),
        **dict.fromkeys(("resample", "to_pandas", "to_polars", "to_arrow", "to_xarray", "to_csv", "to_numpy"),
                        "sample(rate=…), whose samples go to every frame and file"),
        **dict.fromkeys(("t", "x", "knots", "index"), "times, of its keys"),
        **dict.fromkeys(("integrate", "antiderivative"), "angle_travelled(t): rotations have no antiderivative"), "length": "angle_travelled()",
        **dict.fromkeys(("start", "end", "duration", "bounds"), "domain, its first and last time"),
        **dict.fromkeys(("interpolator", "kind"), "method")},
    "Keys": {
        **dict.fromkeys(("as_quat", "quaternions", "orientations", "q", "values", "to_numpy"), "rotations"),
        **dict.fromkeys(("t", "time", "timestamps", "index"), "times"),
        **dict.fromkeys(("iloc", "loc", "head", "tail", "between", "truncate"), "keys[3], keys[:5] and keys['10:00':'10:05']"),
        **dict.fromkeys(("append", "concat", "extend"), "keys + more"),
        **dict.fromkeys(("resample", "interpolate", "evaluate"), "curve().sample(rate=…)"),
        **dict.fromkeys(("omega", "rates", "gyro"), "angular_velocities"),
        **dict.fromkeys(("plot", "show"), "curve().plot()"),
        **dict.fromkeys(("to_csv", "save"), "write(path)"),
        **dict.fromkeys(("drop_duplicates", "dropna", "sort_values", "sort_index"), "Keys(…, drop_duplicates=True, drop_invalid=True, sort=True)"),
        **{task: f"orispline.{task}(keys, …)" for task in ("smooth", "reduce", "retime", "tune", "mean", "compare", "align")}},
    "Samples": {
        **dict.fromkeys(("as_quat", "quaternions", "rotations", "q", "values", "to_numpy"), "orientations"),
        **dict.fromkeys(("t", "time", "timestamps", "index"), "times"),
        **dict.fromkeys(("omega", "rates", "gyro"), "angular_velocities"),
        **dict.fromkeys(("iloc", "loc", "head", "tail"), "samples[3], samples[:5] and samples['10:00':'10:05']"),
        **dict.fromkeys(("to_csv", "to_parquet", "save"), "write(path)"),
        **dict.fromkeys(("plot", "show"), "the plot() of the curve that they are of")},
    "Result": {
        **dict.fromkeys(("rotations", "times", "smoothed", "result", "trajectory"), "keys, which are what was found"),
        **dict.fromkeys(("message", "summary", "status"), "str(result)"), "success": "the result itself: what fails raises an error",
        **dict.fromkeys(("to_dict", "to_json"), "as_dict()")},
    "Smoothing": {
        **dict.fromkeys(("outliers", "inliers", "mask"), "rejected, the indices of the samples that did not count"),
        **dict.fromkeys(("std", "stderr"), "noise, and sigma with sigma=True"), "bias": "gyro_correction",
        **dict.fromkeys(("resample", "sample"), "curve.sample(rate=…)")},
    "Reduction": {**dict.fromkeys(("indices", "index"), "samples, the indices of the samples that are kept"), "error": "error_max"},
    "Retiming": {**dict.fromkeys(("scale", "factor"), "time_scale"), "duration": "duration_after", "limits": "certificates"},
    "Tuning": {**dict.fromkeys(("x", "tension", "tensions", "params"), "parameters"), **dict.fromkeys(("fun", "cost", "energy"), "energy_after"),
               "nit": "iterations"},
    "Alignment": {**dict.fromkeys(("R", "rotation", "matrix"), "world and body"), "t": "translation", "s": "scale",
                  **dict.fromkeys(("aligned", "transformed"), "keys"), **dict.fromkeys(("rmse", "rms", "rssd"), "distance_rms")},
    "RateAlignment": {**dict.fromkeys(("R", "rotation", "matrix"), "body"), "keys": "aligned", **dict.fromkeys(("rmse", "rms"), "rate_rms")},
    "Mean": {**dict.fromkeys(("rotation", "quaternion", "value", "as_quat"), "orientation"), **dict.fromkeys(("std", "stderr"), "sigma"),
             "cov": "covariance"},
    "Comparison": {**dict.fromkeys(("rows", "to_dict", "as_dict", "results"), "table()"), "best": "table()[0]",
                   **dict.fromkeys(("to_csv", "to_polars", "to_arrow"), "to_pandas(), or table() for a list of dictionaries"),
                   "plot": "report(path) and view()"},
}


def no_such_name(who: str, owners: Iterable[str], name: str, there: Iterable[str]) -> AttributeError:
    """The exception, to be raised, about something whose names are those, and which is one of these owners."""
    said = f"{who} has no attribute {name!r}"
    known = next((ELSEWHERE[owner][name] for owner in owners if name in ELSEWHERE.get(owner, ())), None)
    if known is not None:
        return AttributeError(f"{said}, wanted {known}", name=name)
    import difflib
    alike = difflib.get_close_matches(name, [other for other in there if not other.startswith("_")], 3, 0.7)
    return AttributeError(said + (f"; did you mean {' or '.join(map(repr, alike))}?" if alike else ""), name=name)


class Named:
    """What says of a name that it does not have by which one it has that."""

    __slots__ = ()

    if not TYPE_CHECKING:  # or else every name would be one for type checkers

        def __getattr__(self, name: str) -> Any:
            kind = type(self)
            if name.startswith("_"):  # asked for by Python and by others that look what a thing can do
                raise AttributeError(f"{kind.__name__!r} object has no attribute {name!r}", name=name)
            raise no_such_name(f"{kind.__name__!r} object", (base.__name__ for base in kind.__mro__), name, dir(self))
