#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The seeds of the fuzz targets that read bytes of their own, and those of text: tests/fuzz/make_corpus.py.

Writes tests/fuzz/corpus/fuzz_*/seed_*; files of other names, which fuzzing found, stay as they are. The layouts are those
of tests/fuzz/fuzzed_keys.hpp, fuzzed_method.hpp and of each target."""
import base64
import json
import math
import pathlib
import random
import re
import struct

CORPUS = pathlib.Path(__file__).resolve().parent / "corpus"
WHOLE, EVEN, MODERATE, WILD = range(4)  # Steps
NONE, FULL, HALF, TINY, ORDINARY, WIDE, BACK, OFF_NORM = range(8)  # Turn
ZERO, TODAY, BEFORE, LATER = range(4)  # the first time
SECOND = 20  # the byte of a step of 2^0 s

# How many families and methods of streams there are; seeds name them by number, and too large a number starts over.
FAMILIES, ONLINE = 35, 25
# In this order each has the seeds that it had before monotone, the last here, came among them.
NUMBERS = [*range(16), *range(17, FAMILIES + 1), 16]

# What a key asks for behind its turn.
TURN_BYTES = {NONE: b"", FULL: b"", HALF: b"\x02", TINY: bytes([8, 90, 200, 30]), ORDINARY: bytes([60, 220, 30]),
              WIDE: bytes([100, 90, 200]), BACK: b"", OFF_NORM: bytes([1, 60, 40, 200, 10])}


def keys(turns, steps=WHOLE, start=ZERO, as_given=False, half_quaternion=False, even_step=SECOND, step_bytes=(),
         positions=False):
    """The bytes of fuzzed_keys(): a key more than there are turns."""
    how = steps + 4 * start + 16 * as_given + 32 * half_quaternion
    text = bytes([len(turns), how, int(positions)]) + (bytes([even_step]) if steps == EVEN else b"")
    place = bytes([50, 200, 10]) if positions else b""
    text += place
    for i, turn in enumerate(turns):
        step = bytes([step_bytes[i % len(step_bytes)]]) if steps in (MODERATE, WILD) else b""
        text += step + bytes([turn]) + TURN_BYTES[turn] + place
    return text


KEY_SEEDS = {
    "walk": keys([ORDINARY] * 6),
    "uneven": keys([ORDINARY, WIDE] * 3, MODERATE, step_bytes=(3, 15, 0, 7)),
    "wild": keys([ORDINARY, TINY] * 3, WILD, step_bytes=(0, 40, 20, 10)),
    "today": keys([ORDINARY] * 5, EVEN, TODAY, even_step=10),
    "repeated": keys([NONE, ORDINARY, NONE, NONE, BACK]),
    "half": keys([HALF, ORDINARY, HALF, TINY], as_given=True),
    "antipodal": keys([FULL, FULL, NONE], as_given=True, half_quaternion=True),  # q, -q, q, q
    "poses": keys([ORDINARY, OFF_NORM, BACK, ORDINARY], MODERATE, step_bytes=(1, 9), positions=True),
    "one": keys([]),
}
PLAIN = bytes(32)
# Parameters per key, choices and ends; or a loop.
SETTINGS = bytes([0b1111]) + bytes(range(7, 38))
LOOP = bytes([0b10000, 5]) + bytes(30)


def curve_seeds():
    for family, number in enumerate(NUMBERS):
        for name in ("walk", "uneven"):
            yield f"{family:02}_{name}", bytes([number]) + PLAIN + KEY_SEEDS[name]
        name = list(KEY_SEEDS)[family % len(KEY_SEEDS)]
        yield f"{family:02}_{name}_settings", bytes([number]) + (LOOP if family % 3 == 0 else SETTINGS) + KEY_SEEDS[name]


def online_seeds():
    for method in range(ONLINE):
        name = list(KEY_SEEDS)[method % len(KEY_SEEDS)]
        stream = bytes([method, 0, 1, 2, 1, 4, 1, 5]) + bytes(24)
        yield f"{method:02}_{name}", bytes([method]) + (SETTINGS if method % 2 else PLAIN) + stream + KEY_SEEDS[name]


def state_seeds():
    for family in range(FAMILIES):
        name = list(KEY_SEEDS)[family % len(KEY_SEEDS)]
        track = bytes([family % 8, family % 6, family % 8, family % 4, 1 + family % 5, family % 2]) + bytes(10)
        change = bytes([1, 8 * (family % 32), 0, family % 6, family % 20, 7]) if family % 2 else b""
        settings = SETTINGS if family % 3 == 1 else PLAIN
        yield f"{family:02}_{name}", bytes([family]) + settings + track + change.ljust(32, b"\0") + KEY_SEEDS[name]


def recording(count, noise, outliers=False, gyro=False, still=False):
    """The bytes of fuzzed_recording()."""
    return bytes([1 + 2 * outliers + 4 * gyro + 8 * still, 2 * (count - 20), 7, noise])


def recorded_seeds():
    """Of the tasks on recordings, each with bytes of its own behind the keys."""
    walk, poses = KEY_SEEDS["walk"], KEY_SEEDS["poses"]
    head = {task: bytes([task]) + bytes(32) for task in range(6)}
    yield "0_recording", bytes([0, 2]) + bytes([0, 3]) + bytes(29) + walk + recording(120, 3) + bytes([5])
    yield "0_smoothed", bytes([0, 1]) + bytes([2, 0]) + bytes(29) + poses + recording(60, 2, still=True) + bytes([3])
    yield "1_axes", bytes([1, 0, 3, 1]) + bytes(29) + poses + recording(40, 8) + bytes([0b100011])
    yield "1_torque", bytes([1, 0, 3, 1]) + bytes(29) + walk + bytes(4) + bytes([0b1100])
    yield "1_rests", bytes([1, 1, 3, 0]) + bytes(29) + KEY_SEEDS["repeated"] + bytes(4) + bytes([0b110000, 1])
    for name, flags in (("adapt", 0), ("sigma", 2), ("gyro", 4), ("gap", 8)):
        yield f"2_{name}", head[2] + walk + recording(140, 2, True, name == "gyro", True) + bytes([flags, 6])
    yield "2_tukey_jerk", bytes([2, 0b111]) + bytes(31) + poses + recording(90, 1, True) + bytes([32, 4])
    for other in (1, 2, 3):
        yield f"3_other_{other}", head[3] + walk + bytes(4) + bytes([other, other % 2])
    for family in range(0, FAMILIES, 4):
        yield f"5_inspect_{family:02}", bytes([5, family]) + bytes(31) + poses
    turned = bytes([6, 40, 80, 200, 20, 250, 60, 3, 4, 7]).ljust(33, b"\0")
    for name, flags in (("both", 0), ("world", 2), ("body", 1), ("offset", 16)):
        yield f"6_align_{name}", turned + walk + recording(140, 4, True) + bytes([flags, 3])
    yield "6_align_poses", turned + poses + recording(140, 4, still=True) + bytes([0])
    yield "6_align_keys", turned + walk + bytes(4) + bytes([0])


def optimise_seeds():
    yield from recorded_seeds()
    for task in range(5):
        for name in ("walk", "uneven", "repeated", "poses"):
            yield f"{task}_{name}", bytes([task]) + bytes([3, 3, 1] + [0] * 29) + KEY_SEEDS[name]
    yield "4_jittered_47", bytes([4, 1, 1, 47]) + bytes(29) + KEY_SEEDS["walk"]
    steady = bytes([7, 0, 0]) + bytes([ORDINARY, 0, 0, 64]) * 7
    for objective in range(2):
        yield f"3_steady_{objective}", bytes([3, objective]) + bytes(31) + steady


def key_files():
    """Texts of keyframe files with the options that read them: format, flags, more, then what `more` asks for."""
    header = "t,qw,qx,qy,qz\n"
    rows = "0,1,0,0,0\n1,0.9,0.43588989435,0,0\n2,0.8,0.6,0,0\n3.5,0.9,0.1,0.3,0.3\n"
    table = bytes([0, 0b11100000, 1])
    yield "plain", table + (header + rows).encode()
    yield "comma_at_the_end", table + b"t,qw,qx,qy,qz,\n0,1,0,0,0,\n1,0.9,0.43588989435,0,0,\n2,0.8,0.6,0,0,\n"
    yield "more_commas", table + b"t,qw,qx,qy,qz,,\n0,1,0,0,0,,\n1,0.9,0.43588989435,0,0,,\n"
    yield "escape", table + b"t,qw,qx,qy,qz,\x1b[2J\n0,1,0,0,0,1\n1,0.8,0.6,0,0,2\n"
    yield "repairs", bytes([0, 0b10111100, 1]) + (header + "2,1,0,0,0\n0,1,0,0,0\n0,1,0,0,0\n1,nan,0,0,0\n").encode()
    yield "semicolons", table + (header + rows).replace(",", ";").encode()
    yield "quotes", table + b'"t",qw,qx,qy,qz,"a ""b"", c"\n0,1,0,0,0,"x,y"\n1,0.8,0.6,0,0,#\n'
    yield "tum", bytes([0, 0b01000000, 1]) + b"# timestamp tx ty tz qx qy qz qw\n1 0 0 0 0 0 0 1\n2 1 2 3 0.6 0 0 0.8\n"
    yield "euroc", bytes([0, 0, 1]) + (b"#timestamp [ns],p_x,p_y,p_z,q_w,q_x,q_y,q_z\n1403636580838555648,1,2,3,1,0,0,0\n"
                                       b"1403636580843555328,1,2,3,0.8,0.6,0,0\n")
    yield "order", bytes([0, 0b10000000, 0b0101]) + rows.encode()
    yield "xyzw_order", bytes([0, 0b10000000, 0b1101]) + b"0,0,0,0,1\n1,0.6,0,0,0.8\n"
    yield "euler", bytes([0, 0, 0b10001, 2, 1, 1, 0, 0, 0]) + b"t,roll,pitch,yaw\n0,0,0,0\n1,10,20,30\n"
    yield "matrix", table + b"t,r11,r12,r13,r21,r22,r23,r31,r32,r33\n0,1,0,0,0,1,0,0,0,1\n1,1,0,0,0,0,-1,0,1,0\n"
    yield "vector", table + b"time_ns,rx,ry,rz\n1700000000000000000,0,0,0\n1700000000000000001,0.1,0,3\n"
    yield "rates", bytes([0, 0b10000010, 3]) + (b"t_ms,qw,qx,qy,qz,wx_world,wy_world,wz_world,px_mm,py_mm,pz_mm\n"
                                               b"0,1,0,0,0,1,2,3,4,5,6\n10,0.8,0.6,0,0,1,2,3,4,5,6\n")
    yield "bom_crlf", table + b"\xef\xbb\xbf" + (header + rows).replace("\n", "\r\n").encode()
    yield "nul", table + b"t,qw,qx,qy,qz\n0,1,0,\x00,0\n"
    yield "empty", table
    npy = b"{'descr': '<f8', 'fortran_order': False, 'shape': (1, 5), }"
    yield "npy", bytes([0, 0, 1]) + b"\x93NUMPY\x01\x00" + bytes([len(npy) + 1, 0]) + npy + b"\n" + bytes(40)


def times_files():
    yield "plain", b"\x00t\n0\n0.5\n1e-3\n"
    yield "today", b"\x01t_ns\n1700000000123456789\n1700000000123456790\n"
    yield "no_header", b"\x00# times\n3\n\n2\n"
    yield "wrong", b"\x001,2\nx\n"


def blending_files():
    quintic = [["1", "1+a/5", "1+7*a/20", "1", "1", "1"], ["0", "a/5", "9*a/20", "1-9*b/20", "1-b/5", "1"],
               ["0", "0", "0", "-7*b/20", "-b/5", "0"]]
    for name, members in (
            ("quintic", {"title": "Tan's", "parameters": {"tension": 0.5}, "rows": quintic, "ends": "natural"}),
            ("points", {"rows": [[1, 0.5, 0], [0, 0.5, 0.5], [0, 0, 0.5]], "first": -1, "basis": "bezier"}),
            ("powers", {"rows": [[0, 0, 3, -2]], "basis": "power"}),
            ("lengths", {"parameters": {"t": {"default": 1, "min": 0, "max": 2}, "u": 0},
                         "rows": [["1", "1+a2_1*h^2/(h_1*(h_1+h))", "1"], ["0", "-(b_1)**2*(h1+h)/h", "1"],
                                  ["0", "1e-3*(-a)", "0"]]}),
            ("misses", {"rows": [["0", "0.95"]]}), ("division", {"rows": [["0", "1/(h-h)"]]}),
            ("unknown", {"rows": [["0", "c"]]}), ("ragged", {"rows": [["0", "1"], ["0"]]})):
        yield name, json.dumps({"name": "mine", **members}).encode()
    yield "no_json", b'{"name": "mine", "rows": [[0, 1]'


def decimal_files():
    for name, text in (("plain", "1311868163.8697\n0.1"), ("exponents", "1e-150\n-.5e+150"), ("zeros", "-0.000\n0e99"),
                       ("long", "1234567890123456789012345678901234567\n9007199254740993"), ("huge", "1e999\n1e-999"),
                       ("words", "nan\n-inf"), ("wrong", "1e\n--1"), ("halves", "0.5\n-2.5"),
                       ("subnormal", "5e-324\n2.2250738585072014e-308")):
        yield name, text.encode()


def command_files():
    keys_file = "t,qw,qx,qy,qz\n0,1,0,0,0\n1,0.9,0.43588989435,0,0\n2,0.8,0.6,0,0\n3.5,0.9,0.1,0.3,0.3\n"
    comma = "t,qw,qx,qy,qz,\n0,1,0,0,0,\n1,0.9,0.43588989435,0,0,\n2,0.8,0.6,0,0,\n3.5,0.9,0.1,0.3,0.3,\n"
    steady = "t,qw,qx,qy,qz\n" + "".join(f"{t},{c},0,0,{s}\n" for t, c, s in (
        (0, 1, 0), (1, 0.9689124217106447, 0.24740395925452294), (2, 0.8775825618903728, 0.479425538604203),
        (3, 0.7316888688738209, 0.6816387600233341), (4, 0.5403023058681398, 0.8414709848078965)))
    lines = {
        "tune_comma": ("tune keys.csv --method timed-c2", comma), "tune_steady": ("tune keys.csv --method timed-c2", steady),
        "sample": ("sample keys.csv --rate 10 -o out.csv --json", keys_file), "over_old": ("sample - --count 5 -o old.csv", keys_file),
        "npy": ("sample keys.csv --count 7 -o out.npy", keys_file), "loop": ("sample keys.csv --method timed-c2 --period 5 --rate 3", keys_file),
        "inspect": ("inspect keys.csv --json --method auto,quintic", keys_file), "methods": ("methods --json", ""),
        "compare": ("compare keys.csv --keep-every 1 --json", keys_file), "jitter": ("compare keys.csv --keep-every 2 --jitter --random 47", keys_file),
        "smooth": ("smooth keys.csv --json -o out.csv", keys_file), "reduce": ("reduce keys.csv --tolerance 1deg -o out.csv --json", keys_file),
        "retime": ("retime keys.csv --max-rate 10deg/s -o out.tum --json", keys_file), "plot": ("plot keys.csv -o out.svg", keys_file),
        "convert": ("convert keys.csv -o out.tum", keys_file), "studio": ("studio keys.csv --method auto -o out.html", keys_file), "usage": ("sample keys.csv --rat 3", keys_file), "missing": ("inspect none.csv", ""),
        "escape": ("inspect keys.csv", "t,qw,qx,qy,qz,\x1b[2J\n0,1,0,0,0,1\n1,0.8,0.6,0,0,2\n"), "help": ("tune --help", ""),
        "duplicate": ("sample keys.csv --rate 1", "t,qw,qx,qy,qz\n0,1,0,0,0\n0,1,0,0,0\n"),
        "truth": ("sample keys.csv --rate 4 --truth old.csv -o out.csv --json", keys_file)}
    for name, (line, text) in lines.items():
        yield name, f"{line}\n{text}".encode()


def quaternions_of(angles):
    return [(0.0, 0.6 * math.sin(a / 2), 0.8 * math.sin(a / 2), math.cos(a / 2)) for a in angles]


def gltf_of(tracks, joints=3):
    """A chain of joints; a track is (joint, path, interpolation, times, values)."""
    binary, views, accessors, samplers, channels = b"", [], [], [], []
    for joint, path, interpolation, times, values in tracks:
        for kind, rows in (("SCALAR", [(t,) for t in times]), (f"VEC{len(values[0])}", values)):
            data = b"".join(struct.pack(f"<{len(row)}f", *row) for row in rows)
            views.append({"buffer": 0, "byteOffset": len(binary), "byteLength": len(data)})
            accessors.append({"bufferView": len(views) - 1, "componentType": 5126, "count": len(rows), "type": kind})
            binary += data
        channels.append({"sampler": len(samplers), "target": {"node": joint, "path": path}})
        samplers.append({"input": len(accessors) - 2, "output": len(accessors) - 1, "interpolation": interpolation})
    nodes = [{"name": f"joint{i}", "translation": [0, i, 0.5]} | ({"children": [i + 1]} if i + 1 < joints else {})
             for i in range(joints)]
    uri = "data:;base64," + base64.b64encode(binary).decode()
    return json.dumps({"asset": {"version": "2.0"}, "nodes": nodes, "bufferViews": views, "accessors": accessors,
                       "animations": [{"name": "walk", "samplers": samplers, "channels": channels}] if tracks else [],
                       "buffers": [{"byteLength": len(binary), "uri": uri}] if tracks else []}, separators=(",", ":")).encode()


def clip_files():
    """A scene with the job and its options before it."""
    times = [k / 8 for k in range(24)]
    swing = quaternions_of([math.sin(1.3 * t) + 0.3 * t for t in times])
    rough = quaternions_of([math.sin(t) + (0.02 if k % 2 else -0.02) for k, t in enumerate(times)])
    path = [(t, 0.1 * t * t, math.sin(t)) for t in times]
    moves = gltf_of([(0, "rotation", "LINEAR", times, swing), (1, "rotation", "LINEAR", times, rough),
                     (0, "translation", "LINEAR", times, path), (2, "rotation", "STEP", times[:4], swing[:4])])
    spline = [value for row in quaternions_of([0.0, 1.0, 0.4]) for value in ((0.0,) * 4, row, (0.0,) * 4)]
    splines = gltf_of([(1, "rotation", "CUBICSPLINE", [0.0, 0.5, 2.0], spline), (0, "scale", "LINEAR", [0.0, 1.0], [(1, 1, 1)] * 2)])
    rests = gltf_of([(0, "rotation", "LINEAR", times[:6], quaternions_of([0, 0, 1e-7, 1e-6, 0, 0])),
                     (1, "translation", "LINEAR", times[:6], [(0, 0, 1e-7 * k) for k in range(6)])])
    for method in range(6):
        yield f"reduce_{method}", bytes([0, method, 2, 2 * (method % 2)]) + moves
    yield "reduce_world", bytes([1, 1, 2, 0b0101]) + moves
    yield "reduce_closed", bytes([0, 0, 3, 0b1000]) + moves
    yield "reduce_positions", bytes([0, 1, 1, 0b0011]) + moves
    yield "reduce_splines", bytes([0, 1, 2, 0]) + splines
    yield "reduce_rests", bytes([0, 0, 4, 0]) + rests
    for loss in range(4):
        yield f"smooth_{loss}", bytes([2, loss, loss % 2, loss]) + moves
    yield "difference", bytes([3, 1, 0, 0]) + moves
    yield "difference_splines", bytes([3, 0, 0, 0]) + splines
    yield "smooth_nothing", bytes([2, 0, 0, 0]) + gltf_of([])


# ---------------------------------------------------------------- small FBX and Collada files of a turning bone

TICKS = 46186158000  # of FBX in a second


class Id(int):
    """Of an object: eight bytes, however small."""


class Node:
    """A record of FBX: a name, properties and records inside."""

    def __init__(self, name, *properties, inside=()):
        self.name, self.properties, self.inside = name, properties, tuple(inside)

    def as_text(self, indent=""):
        words = ", ".join(f'"{word}"' if isinstance(word, str) else self.list_as_text(word, indent) for word in self.properties)
        inside = "".join(node.as_text(indent + "\t") for node in self.inside)
        return f"{indent}{self.name}: {words}" + (f" {{\n{inside}{indent}}}\n" if self.inside else "\n")

    @staticmethod
    def list_as_text(value, indent):
        if not isinstance(value, (list, tuple)):
            return str(value)
        return f"*{len(value)} {{\n{indent}\ta: {','.join(map(str, value))}\n{indent}}}"

    def as_bytes(self, start):
        properties = b"".join(map(property_bytes, self.properties))
        head = 13 + len(self.name)
        at, inside = start + head + len(properties), b""
        for node in self.inside:
            inside += node.as_bytes(at + len(inside))
        if self.inside:
            inside += bytes(13)
        end = at + len(inside)
        return struct.pack("<IIIB", end, len(self.properties), len(properties), len(self.name)) + self.name.encode() + properties + inside


def property_bytes(value):
    if isinstance(value, str):
        text = value.encode()
        if "::" in value:  # the class behind the name, in the binary form
            kind, name = value.split("::")
            text = name.encode() + b"\0\x01" + kind.encode()
        return b"S" + struct.pack("<I", len(text)) + text
    if isinstance(value, float):
        return b"D" + struct.pack("<d", value)
    if isinstance(value, (list, tuple)):
        form, word = ("f", "f") if isinstance(value[0], float) else ("l", "q")
        return form.encode() + struct.pack("<III", len(value), 0, struct.calcsize(f"<{len(value)}{word}")) + struct.pack(f"<{len(value)}{word}", *value)
    return b"L" + struct.pack("<q", value) if isinstance(value, Id) or abs(value) >= 2**31 else b"I" + struct.pack("<i", value)


def records(angles):
    """Of a bone that turns about x through these angles [deg], one a second."""
    times = [TICKS * k for k in range(len(angles))]
    curve = Node("AnimationCurve", Id(40), "AnimCurve::", "", inside=[
        Node("Default", 0.0), Node("KeyVer", 4008), Node("KeyTime", times), Node("KeyValueFloat", [float(angle) for angle in angles])])
    objects = [
        Node("Model", Id(10), "Model::bone", "LimbNode", inside=[Node("Version", 232)]),
        Node("AnimationStack", Id(20), "AnimStack::turn", "", inside=[Node("Properties70", inside=[Node("P", "LocalStop", "KTime", "Time", "", times[-1])])]),
        Node("AnimationLayer", Id(21), "AnimLayer::Base", "", inside=[Node("Version", 100)]),
        Node("AnimationCurveNode", Id(30), "AnimCurveNode::R", "", inside=[Node("Properties70", inside=[Node("P", "d|X", "Number", "", "A", 0.0)])]),
        curve]
    links = [("OO", 10, 0), ("OO", 21, 20), ("OO", 30, 21), ("OP", 30, 10, "Lcl Rotation"), ("OP", 40, 30, "d|X")]
    connections = [Node("C", kind, Id(child), Id(parent), *what) for kind, child, parent, *what in links]
    return [Node("FBXHeaderExtension", inside=[Node("FBXHeaderVersion", 1003), Node("FBXVersion", 7400)]),
            Node("GlobalSettings", inside=[Node("Version", 1000), Node("Properties70", inside=[Node("P", "TimeMode", "enum", "", "", 6)])]),
            Node("Objects", inside=objects), Node("Connections", inside=connections)]


def fbx_text(angles):
    return ("; FBX 7.4.0 project file\n" + "".join(node.as_text() for node in records(angles))).encode()


def fbx_binary(angles):
    data = b"Kaydara FBX Binary  \0\x1a\0" + struct.pack("<I", 7400)
    for node in records(angles):
        data += node.as_bytes(len(data))
    return data + bytes(13) + bytes(160)


def collada(angles):
    times = " ".join(str(k) for k in range(len(angles)))
    values = " ".join(map(str, angles))

    def source(name, words, count, kind="float"):
        return (f'<source id="{name}"><{kind if kind == "Name_array" else "float_array"} id="{name}-array" count="{count}">{words}'
                f'</{kind if kind == "Name_array" else "float_array"}><technique_common><accessor source="#{name}-array" count="{count}" stride="1">'
                f'<param name="X" type="{"name" if kind == "Name_array" else "float"}"/></accessor></technique_common></source>')

    sources = source("t", times, len(angles)) + source("v", values, len(angles))
    sources += source("i", " ".join(["LINEAR"] * len(angles)), len(angles), "Name_array")
    return ('<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1"><asset><unit meter="1"/><up_axis>Y_UP</up_axis>'
            f'</asset><library_animations><animation id="turn">{sources}<sampler id="s"><input semantic="INPUT" source="#t"/>'
            '<input semantic="OUTPUT" source="#v"/><input semantic="INTERPOLATION" source="#i"/></sampler><channel source="#s" target="bone/rx.ANGLE"/>'
            '</animation></library_animations><library_visual_scenes><visual_scene id="scene"><node id="bone" name="bone" type="JOINT">'
            '<translate sid="t">0 1 0</translate><rotate sid="rx">1 0 0 0</rotate></node></visual_scene></library_visual_scenes>'
            '<scene><instance_visual_scene url="#scene"/></scene></COLLADA>').encode()


def fbx_files():
    """By name, after a byte of options: 0 for FBX, 1 for Collada."""
    angles = [0, 40, 10, -80]
    yield "text", b"\0" + fbx_text(angles)
    yield "binary", b"\0" + fbx_binary(angles)
    yield "collada", b"\1" + collada(angles)
    yield "one_key", b"\0" + fbx_binary([30])
    yield "half_turns", b"\1" + collada([0, 180, 360, 540])
    yield "no_fbx", b"\0not an FBX file"


def c_words(array):
    """The numbers of the texts of an array of fuzz_c.cpp."""
    source = (CORPUS.parent / "fuzz_c.cpp").read_text("utf-8")
    words = re.findall(r'"([^"]*)"', re.search(rf"std::array {array}\{{(.*?)\}};", source, re.S)[1])
    return {word: number for number, word in enumerate(words)}


WALK = (b"HIERARCHY ROOT a { OFFSET 0 0 0 CHANNELS 3 Zrotation Xrotation Yrotation JOINT b { OFFSET 1 0 0 CHANNELS 3 Zrotation "
        b"Xrotation Yrotation End Site { OFFSET 1 0 0 } } }\nMOTION\nFrames: 4\nFrame Time: 0.1\n"
        b"0 0 0 0 0 0\n9 0 5 0 20 0\n10 0 0 3 2 1\n0 1 9 9 2 0\n")


def c_tasks(five_keys):
    """Tasks by name and with values, and what becomes of their outcomes."""
    names, options, tasks = c_words("names"), c_words("options"), c_words("tasks")
    walk = WALK.ljust((len(WALK) + 7) // 8 * 8)
    skeletons = (bytes([17, len(walk) // 8 - 1]) + walk + bytes([names["walk.bvh"], options[""], 0])) * 2
    look = bytes([22, 1, 0]) + bytes([18, 1, 1, 1, 1]) + bytes([19, names["walk.glb"], options[""], 0, 1, 1])
    for task, first, second, option in (("smooth", "recording", "gyro", None), ("reduce", "recording", "x", "tolerance=0.1deg"),
                                        ("inspect", "keys", "x", None), ("difference", "first", "second", "rate=30")):
        yield f"skeletons_{task}", skeletons + bytes([21, names[first], 1, names[second], 2, tasks[task], options[option or ""],
                                                      option is not None, task == "difference"]) + look
    for task, first, second, option in (
            ("smooth", "recording", "gyro", None), ("tune", "keys", "reference", "method=slerp"), ("reduce", "recording", "x", "tolerance=0.1deg"),
            ("retime", "keys", "x", "angular_velocity=10deg/s"), ("bake", "keys", "x", "method=slerp"), ("mean", "rows", "x", None),
            ("align", "moved", "fixed", None), ("compare", "keys", "reference", "methods=auto,slerp"), ("inspect", "keys", "x", None)):
        yield f"task_{task}", five_keys + bytes([20, 1, names[first], 1, names[second], 1, options[option or ""], options[""], tasks[task],
                                                 second != "x", option is not None, 0]) + look


def c_programs():
    """Calls by their numbers in fuzz_c.cpp: make_keys 25, make_curve 4, bake 11, rebake 12, sample_baked 13, …"""
    turned = b"".join(bytes([x, 20, 200, 60, 1]) for x in (5, 30, 60, 90, 120))
    five_keys = bytes([25, 5, 4, 0]) + bytes([1, 99] * 5) + turned + bytes([1, 0, 0, 0, 1, 1, 1, 1, 0, 1])
    curve = bytes([4, 1, 0])
    yield "lists", bytes([14, 15, 1, 3, 24])
    for call, name in enumerate(("read_keys", "look_at_keys", "write_keys", "make_curve", "make_curves", "look_at_curve",
                                 "move", "sample", "samples", "judge", "bake", "rebake", "sample_baked"), 1):
        yield name, five_keys + curve + b"".join(bytes([call, 1]) + bytes(range(k, k + 40)) for k in (1, 90, 170))
    yield from c_tasks(five_keys)
    for k in range(12):
        calls = random.Random(k)
        yield f"random_{k:02}", five_keys + curve + b"".join(
            bytes([calls.randrange(1, 25)]) + calls.randbytes(calls.randrange(4, 40)) for _ in range(24))


TARGETS = {"curve": curve_seeds, "online": online_seeds, "optimise": optimise_seeds, "state": state_seeds,
           "clips": clip_files, "keys": key_files, "times": times_files, "blending": blending_files,
           "decimal": decimal_files, "command": command_files, "fbx": fbx_files, "c": c_programs}


def main():
    for target, seeds in TARGETS.items():
        folder = CORPUS / f"fuzz_{target}"
        folder.mkdir(parents=True, exist_ok=True)
        for old in folder.glob("seed_*"):
            old.unlink()
        for name, content in seeds():
            (folder / f"seed_{name}").write_bytes(content)


if __name__ == "__main__":
    main()
