#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes tests/c/cases.json, what every binding of the C interface must give bit for bit: tests/c/make_cases.py LIBORISPLINE_C.

The tests hold the interface to the library; this file holds other languages to the interface.
"""
import ctypes
import json
import math
import pathlib
import random
import sys

CASES = pathlib.Path(__file__).with_name("cases.json")
WXYZ, DOUBLE = 1, 0
QUANTITIES = {"orientation": 0, "angular_velocity": 1, "angular_acceleration": 2, "angular_jerk": 3, "angular_velocity_world": 4,
              "angular_acceleration_world": 5, "angular_jerk_world": 6, "position": 7, "velocity": 8, "acceleration": 9}


class Column(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("numbers", ctypes.c_void_p), ("count", ctypes.c_size_t)]


class Output(ctypes.Structure):
    _fields_ = [("quantity", ctypes.c_int32), ("type", ctypes.c_int32), ("numbers", ctypes.c_void_p), ("stride", ctypes.c_size_t)]


def doubles(numbers):
    return (ctypes.c_double * len(numbers))(*[math.nan if x is None else x for x in numbers])


def plain(numbers):
    return [None if math.isnan(x) else x for x in numbers]


class Interface:
    def __init__(self, library):
        self.c = ctypes.CDLL(library)
        for name in ("message", "option", "remedy"):
            getattr(self.c, f"orispline_error_{name}").restype = ctypes.c_char_p
        self.c.orispline_error_key.restype = ctypes.c_int64

    def fault(self, code, error):
        found = {"code": code, "key": self.c.orispline_error_key(error)}
        found |= {name: getattr(self.c, f"orispline_error_{name}")(error).decode() for name in ("message", "option", "remedy")}
        self.c.orispline_error_free(error)
        return found

    def keys(self, times, orientations, columns):
        arrays = [doubles(numbers) for numbers in columns.values()]
        stated = (Column * len(columns))(*[(name.encode(), ctypes.addressof(array), len(array)) for name, array in zip(columns, arrays)])
        keys, error = ctypes.c_void_p(), ctypes.c_void_p()
        code = self.c.orispline_keys_make(doubles(times), doubles(orientations), ctypes.c_size_t(len(times)), WXYZ, 0, stated,
                                          ctypes.c_size_t(len(columns)), ctypes.byref(keys), ctypes.byref(error))
        return keys, self.fault(code, error) if code else None

    def curve(self, keys, method):
        curve, error = ctypes.c_void_p(), ctypes.c_void_p()
        code = self.c.orispline_curve_make(keys, method.encode(), ctypes.byref(curve), ctypes.byref(error))
        return curve, self.fault(code, error) if code else None

    def motion(self, curve, time, side):
        numbers = (ctypes.c_double * 25)()
        assert not self.c.orispline_curve_motion(curve, ctypes.c_double(time), side, WXYZ, numbers, None)
        return plain(numbers)

    def samples(self, curve, times):
        """Every quantity, all of which are asked for at once."""
        arrays = {name: (ctypes.c_double * ((4 if name == "orientation" else 3) * len(times)))() for name in QUANTITIES}
        outputs = (Output * len(arrays))(*[(QUANTITIES[name], DOUBLE, ctypes.addressof(array), 0) for name, array in arrays.items()])
        assert not self.c.orispline_sample_at(curve, doubles(times), ctypes.c_size_t(len(times)), WXYZ, None, ctypes.c_uint32(1), outputs,
                                              ctypes.c_size_t(len(arrays)), None)
        return {name: plain(array) for name, array in arrays.items()}


def walk(count):
    """Keys at uneven times about ever new axes."""
    dice = random.Random(42)
    times, rows, positions, t, q = [], [], [], 0.0, [1.0, 0.0, 0.0, 0.0]
    for _ in range(count):
        times.append(round(t, 3))
        rows += q
        positions += [round(dice.uniform(-3, 3), 3) for _ in range(3)]
        t += dice.choice([0.1, 0.4, 1.0])
        q = [x + 0.4 * dice.uniform(-1, 1) for x in q]
        size = math.sqrt(sum(x * x for x in q))
        q = [x / size for x in q]
    return {"times": times, "orientations": rows, "columns": {"positions": positions, "tension": [0.25 * (1 + i % 4) for i in range(count)]}}


def methods_of(interface):
    text, error = ctypes.c_char_p(), ctypes.c_void_p()
    assert not interface.c.orispline_methods_json(ctypes.byref(text), ctypes.byref(error))
    return [method["name"] for method in json.loads(text.value)]


def faults(interface, keys):
    """What is refused, and why."""
    made, _ = interface.keys(**keys)
    bad_keys = [{"times": [0, 0]}, {"times": [0, None]}, {"orientations": [1, 0, 0, 0, 0, 0, 0, 0]}, {"orientations": [None, 0, 0, 0, 1, 0, 0, 0]},
                {"times": [], "orientations": []}, {"columns": {"positions": [1, 2, 3]}}, {"columns": {"tension": [1]}}]
    for change in bad_keys:
        stated = {"times": [0, 1], "orientations": [1, 0, 0, 0, 0, 1, 0, 0], "columns": {}} | change
        yield {"keys": stated, "error": interface.keys(**stated)[1]}
    for method in ("squadd", "timed-c2:tensoin=1", "timed-c2:tension=-1e9", "timed-c2:tension=1,2", "quintic:ends=natrual", "bspline:degree=2.5"):
        yield {"method": method, "error": interface.curve(made, method)[1]}


def main():
    interface, keys = Interface(sys.argv[1]), walk(10)
    made, error = interface.keys(**keys)
    assert not error, error
    inner, end = keys["times"][3], keys["times"][-1]
    times = [inner, inner + 0.03, end - 0.01, -1.0, end + 1.0]
    curves = []
    for method in [*methods_of(interface), "timed-c2:ends=rest", "tcb:bias=0.5"]:
        curve, error = interface.curve(made, method)
        assert not error, error
        curves.append({"method": method, "motions": [interface.motion(curve, t, 0) for t in times], "left": interface.motion(curve, inner, 1),
                       "samples": interface.samples(curve, times)})
    text = json.dumps({"keys": keys, "times": times, "curves": curves, "faults": list(faults(interface, keys))}, indent=0, ensure_ascii=False)
    CASES.write_text(text.replace(",\n", ",").replace("[\n", "[").replace("\n]", "]").replace('},"', '},\n"').replace('{"method', '\n{"method') + "\n", "utf-8")


main()
