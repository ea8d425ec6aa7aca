# SPDX-License-Identifier: Apache-2.0
"""Every public call with wrong values for each of its arguments: one line that names what was found, and never the signatures of the
binding."""
import importlib.util
import inspect
import os
import warnings

import matplotlib
import numpy as np
import orispline as ori
import pytest
from scipy.spatial.transform import Rotation

matplotlib.use("Agg")
T, Q = [0.0, 1.0, 3.0], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]]
WRONG = {"None": None, "text": "x", "not UTF-8": "\udce9", "half a pair": "\ud800", "bytes": b"x", "huge": 2**70, "complex": 1j,
         "object": object(), "mapping": {"a": 1}, "table": [["x"], [None]], "NaN": float("nan"), "set": {1}, "type": int}
BVH = """HIERARCHY\nROOT head\n{\nOFFSET 0 1.5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 0.2 0\n}\n}
MOTION\nFrames: 3\nFrame Time: 0.5\n0 0 0\n0 20 0\n0 0 0\n"""
NOT_CALLED = {"Curve.show"}  # opens a browser


class Calls:
    """Public calls by their names, with arguments that are right."""

    def __init__(self):
        open("nod.bvh", "w", encoding="utf-8").write(BVH)
        rotations = Rotation.from_quat(Q)
        times = np.linspace(0, 2, 61)
        recording = ori.Keys(times, Rotation.from_rotvec(np.outer(np.sin(times), [0, 0, 1])))
        keys, scene = ori.Keys(T, Q, positions=np.eye(3)), ori.read_scene("nod.bvh")
        keys.write("keys.csv")
        curve, online = keys.curve("timed-c2"), ori.OnlineCurve("slerp")
        stack = ori.CurveStack(T, [[q] for q in Q])
        own = ori.blending("mine", [["0", "1-a", "1"]], parameters={"lag": 0})
        open("mine.json", "w", encoding="utf-8").write(own.to_json())
        self.functions = {
            "Keys": (ori.Keys, {"times": T, "rotations": Q}), "Keys.from_pandas": (ori.Keys.from_pandas, {"frame": keys.to_pandas()}),
            "Keys.from_polars": (ori.Keys.from_polars, {"frame": keys.to_polars()}), "Keys.from_arrow": (ori.Keys.from_arrow, {"table": keys.to_arrow()}),
            "Keys.from_xarray": (ori.Keys.from_xarray, {"dataset": keys.to_xarray()}),
            "Curve": (ori.Curve, {"times": T, "rotations": Q}), "CurveStack": (ori.CurveStack, {"times": T, "rotations": [[q] for q in Q]}),
            "OnlineCurve": (ori.OnlineCurve, {}), "BakedCurve": (ori.BakedCurve, {}), "Scene": (ori.Scene, {}),
            "RotationSpline": (ori.RotationSpline, {"times": T, "rotations": rotations}),
            "Slerp": (ori.Slerp, {"times": T, "rotations": rotations}), "methods": (ori.methods, {}),
            "blending": (ori.blending, {"name": "mine", "rows": [[0, 1]]}), "read_blending": (ori.read_blending, {"path": "mine.json"}),
            "read_rates": (ori.read_rates, {"path": "gyro.csv"}),
            "Blending": (ori.Blending, {}), "read": (ori.read, {"path": "keys.csv"}), "write": (ori.write, {"what": keys, "path": "out.csv"}),
            "read_scene": (ori.read_scene, {"path": "nod.bvh"}), "reduce_scene": (ori.reduce_scene, {"scene": scene, "tolerance": "1deg"}),
            "smooth_scene": (ori.smooth_scene, {"scene": scene}), "clip_scene": (ori.clip_scene, {"scene": scene}), "retime_scene": (ori.retime_scene, {"scene": scene}), "shell_distance": (ori.shell_distance, {"a": scene, "b": scene}), "smooth": (ori.smooth, {"keys": recording}),
            "reduce": (ori.reduce, {"keys": recording, "tolerance": "1deg"}),
            "reduce_tracks": (ori.reduce_tracks, {"tracks": [recording], "tolerance": "1deg"}),
            "retime": (ori.retime, {"keys": keys, "max_rate": 1}), "tune": (ori.tune, {"keys": keys, "method": "quintic"}),
            "Rates": (ori.Rates, {"times": T, "rates": np.zeros((3, 3))}),
            "align": (ori.align, {"a": recording, "b": recording}), "angle_between": (ori.angle_between, {"a": curve, "b": curve.inv(), "t": 0.5}),
            "compare": (ori.compare, {"keys": recording, "methods": ["slerp"]}), "mean": (ori.mean, {"rotations": Q}), "plot_sphere": (ori.plot_sphere, {"curves": curve}),
            "plot_comparison": (ori.plot_comparison, {"curves": curve})}
        self.objects = {
            "Keys": keys, "Curve": curve, "ComposedCurve": curve.inv(), "Blending": own, "CurveStack": stack, "OnlineCurve": online, "BakedCurve": curve.bake(1e-6),
            "RotationSpline": ori.RotationSpline(T, rotations), "Slerp": ori.Slerp(T, rotations), "Samples": stack.sample(rate=2),
            "Scene": scene, "Smoothing": ori.smooth(recording, smoothing_time=0.1), "Reduction": ori.reduce(recording, "1deg"),
            "Retiming": ori.retime(keys, max_rate=1), "Tuning": ori.tune(keys, "quintic"), "Mean": ori.mean(Q[:2]), "Comparison": ori.compare(recording, ["slerp"]),
            "Rates": ori.Rates(T, np.zeros((3, 3))), "Alignment": ori.align(recording, recording, body_turn=False)}
        self.clock = 0.0

    def __iter__(self):
        yield from ((name, call, lambda right=right: dict(right)) for name, (call, right) in self.functions.items())
        for kind, thing in self.objects.items():
            for name in [name for name in dir(type(thing)) if not name.startswith("_") or name in ("__call__", "__getitem__")]:
                call = getattr(thing, name)
                if f"{kind}.{name}" not in {*self.functions, *NOT_CALLED} and callable(call) and not isinstance(call, ori.Curve):
                    yield f"{kind}.{name}", call, lambda name=name, call=call: self.right(name, call)

    def right(self, name, call):
        """Arguments that a method must have."""
        self.clock += 1
        known = {"t": self.clock if name == "append" else 0.5, "rate": 2, "path": "out.glb" if "bones" in parameters_of(call) else "out.csv",
                 "tolerance": 1e-6, "angle": 1.0, "inertia": [1, 2, 3], "times": T, "rotations": Q, "rates": np.zeros((3, 3)),
                 "q": [0, 0, 0, 1], "order": "ZYX"}
        more = {"count": 3} if name == "sample" else {}
        return more | {p.name: known.get(p.name, 0) for p in parameters_of(call).values() if p.default is p.empty and p.kind is not p.VAR_KEYWORD}


def parameters_of(call):
    return inspect.signature(call).parameters


@pytest.fixture(scope="module")
def calls(tmp_path_factory):
    folder = os.getcwd()
    os.chdir(tmp_path_factory.mktemp("wrong"))
    yield Calls()
    os.chdir(folder)


def complaint(call, right, name, value):
    """What is wrong with what a call says of a wrong value; nothing where it takes it, or says so."""
    arguments = {**right, name: value}
    positions = [arguments.pop(p.name) for p in parameters_of(call).values() if p.kind is p.POSITIONAL_ONLY]
    try:
        call(*positions, **arguments)
    except ImportError:
        return None
    except (ori.Error, TypeError, IndexError) as error:
        text = str(error)
        is_told = isinstance(error, ori.Error) or "found" in text or "unexpected keyword argument" in text
        return None if is_told and "\n" not in text and "incompatible function" not in text else f"{type(error).__name__}: {text[:200]}"
    except Exception as error:  # noqa: BLE001  what a user should not see
        return f"{type(error).__name__}: {str(error)[:200]}"
    finally:
        matplotlib.pyplot.close("all")
    return None


def test_no_wrong_value_reaches_the_binding(calls):
    import matplotlib.pyplot  # noqa: F401
    found = []
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for name, call, right in calls:
            for parameter in parameters_of(call).values():
                argument = "nonsense" if parameter.kind is parameter.VAR_KEYWORD else parameter.name
                found += [(name, argument, kind, told) for kind, value in WRONG.items()
                          if (told := complaint(call, right(), argument, value))]
    assert not found, "\n".join(map(str, found[:40]))


def test_all_public_calls_are_walked(calls):
    """A call that comes is walked too: it is in the table above, or it is a method of what stands there."""
    walked = {name for name, _, _ in calls} | NOT_CALLED
    values = {name for name in ori.__all__ if inspect.isclass(getattr(ori, name))} - {name.split(".")[0] for name in walked}
    assert values <= {"AccessError", "ArgumentError", "BlendingFinding", "BridgedRun", "Certificate", "Channel", "Clip", "ConvergenceError", "DataError", "DistanceStatistics",
                      "EditedClip", "Energies", "Error", "HandleTurn", "KeyStatistics", "Motion", "OpenDirection", "OpenRateDirection", "Peak", "Peaks", "RateAlignment", "Sample",
                      "RetimedClip", "SceneEdit", "SceneReduction", "SceneRetiming", "SceneSmoothing", "ShapeWarning", "Skeleton", "SmoothedJoint", "Spread", "View", "Worst"}  # which hold values that were found
    assert {name for name in ori.__all__ if not inspect.isclass(getattr(ori, name))} <= walked


@pytest.mark.skipif(not all(map(importlib.util.find_spec, ("pyarrow", "duckdb"))), reason="found no pyarrow and DuckDB")
def test_no_wrong_value_of_tables_reaches_the_binding(tmp_path, monkeypatch):
    from orispline import tables
    monkeypatch.chdir(tmp_path)
    import pyarrow as pa
    keys = pa.table({"track": ["a"] * 3, "t": T, **dict(zip(("qx", "qy", "qz", "qw"), np.transpose(Q)))})
    right = {"source": keys, "keys": keys, "at": keys.select(["track", "t"]), "tolerance": "1deg", "path": "out.parquet", "table": keys,
             "what": keys, "sources": keys, "folder": "out", "samples": keys}
    found = []
    for name in ("resample", "evaluate", "smooth", "reduce", "compare"):
        call = getattr(tables, name)
        needed = {p.name: right[p.name] for p in parameters_of(call).values() if p.default is p.empty and p.kind is not p.VAR_KEYWORD}
        for parameter in parameters_of(call).values():
            argument = "nonsense" if parameter.kind is parameter.VAR_KEYWORD else parameter.name
            for kind, value in WRONG.items():
                try:
                    call(**{**needed, argument: value})
                except Exception as error:  # noqa: BLE001  of other packages too
                    if "incompatible function" in str(error):
                        found.append((name, argument, kind))
    assert not found
