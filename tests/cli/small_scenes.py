# SPDX-License-Identifier: Apache-2.0
"""Small files of skeletons, and what they hold by formulas of our own; and a look into binary glTF."""
import base64
import json
import math
import struct

from command import CommandTest

FRAMES = 121

BVH_HIERARCHY = """HIERARCHY
ROOT Shoulder
{
\tOFFSET 1.0 2.50 3
\tCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
\tJOINT Elbow
\t{
\t\tOFFSET 0.30 0 0
\t\tCHANNELS 3 Zrotation Xrotation Yrotation
\t\tEnd Site
\t\t{
\t\t\tOFFSET 0.25 0 0
\t\t}
\t}
}
"""


def shoulder_angles(frame):
    """About z, x, y [deg]; the same at the first and the last frame."""
    turn = 2 * math.pi * frame / (FRAMES - 1)
    return 60 * math.sin(turn), 20 - 20 * math.cos(turn), 15 * math.sin(2 * turn)


def elbow_angle(frame):
    return 0.5 * frame


def bvh_text(frames=FRAMES):
    rows = "".join(" ".join(f"{number:.6f}" for number in (1, 2.5, 3, *shoulder_angles(k), elbow_angle(k), 0, 0)) + "\n"
                   for k in range(frames))
    return f"{BVH_HIERARCHY}MOTION\nFrames: {frames}\nFrame Time: .0083333\n{rows}"


def turn_about(axis, degrees):
    """As w, x, y, z."""
    half = math.radians(degrees) / 2
    return [math.cos(half), *(math.sin(half) if k == axis else 0.0 for k in range(3))]


def product(p, q):
    w, x, y, z = p
    a, b, c, d = q
    return [w * a - x * b - y * c - z * d, w * b + x * a + y * d - z * c,
            w * c - x * d + y * a + z * b, w * d + x * c - y * b + z * a]


def turned(q, vector):
    return product(product(q, [0.0, *vector]), [q[0], -q[1], -q[2], -q[3]])[1:]


def shoulder_turn(frame):
    z, x, y = (round(angle, 6) for angle in shoulder_angles(frame))
    return product(product(turn_about(2, z), turn_about(0, x)), turn_about(1, y))


def angle_between(p, q):
    """[deg]; by the chord, which small angles survive."""
    chord = min(math.dist(p, q), math.dist(p, [-c for c in q]))
    return math.degrees(4 * math.asin(chord / 2))


# Of the cubic spline: times, and in-tangent, value, out-tangent of each key as x, y, z, w.
SPLINE_TIMES = [0.0, 0.5, 2.0]
SPLINE = [[0, 0, 0, 0], [0, 0, 0, 1], [0.4, 0.1, 0, 0.2],
          [0.3, 0, -0.2, 0], [0.6, 0, 0, 0.8], [-0.5, 0.3, 0.1, 0],
          [0.1, 0.2, 0.3, 0.4], [0, 0.8, 0, -0.6], [0, 0, 0, 0]]


def gltf_document():
    """Two nodes, one clip with a spline of the first and steps of the second, and things that are none of our business."""
    data = struct.pack("<3f", *SPLINE_TIMES) + struct.pack("<36f", *(c for row in SPLINE for c in row))
    data += struct.pack("<2f", 0, 1) + struct.pack("<6f", 0, 0, 0, 0, 1, 0) + struct.pack("<9f", 0, 0, 0, 1, 0, 0, 0, 1, 0)
    views, accessors, at = [], [], 0
    for count, kind, numbers in ((3, "SCALAR", 1), (9, "VEC4", 4), (2, "SCALAR", 1), (2, "VEC3", 3), (3, "VEC3", 3)):
        length = 4 * count * numbers
        views.append({"buffer": 0, "byteOffset": at, "byteLength": length})
        accessors.append({"bufferView": len(accessors), "componentType": 5126, "count": count, "type": kind})
        at += length
    accessors[0] |= {"min": [0.0], "max": [2.0]}
    accessors[2] |= {"min": [0.0], "max": [1.0]}
    accessors[4] |= {"min": [0.0, 0.0, 0.0], "max": [1.0, 1.0, 0.0]}
    return {
        "asset": {"version": "2.0", "extras": {"by": "a test"}},
        "extensionsUsed": ["TEST_unknown"],
        "extensions": {"TEST_unknown": {"numbers": [0.1, 1e-30, 12345678901234567890]}},
        "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "base", "children": [1], "mesh": 0, "extras": {"kept": [True, None]}},
                  {"name": "tip", "translation": [0.0, 0.5, 0.0]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 4}}]}],
        "animations": [{"name": "swing", "channels": [{"sampler": 0, "target": {"node": 0, "path": "rotation"}},
                                                      {"sampler": 1, "target": {"node": 1, "path": "translation"}}],
                        "samplers": [{"input": 0, "output": 1, "interpolation": "CUBICSPLINE"},
                                     {"input": 2, "output": 3, "interpolation": "STEP"}]}],
        "accessors": accessors, "bufferViews": views,
        "buffers": [{"byteLength": at, "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}]}


def spline_at(times, keys, t):
    """glTF 2.0, appendix C.5, in double: w, x, y, z of the normalised polynomial. Keys as `SPLINE` has them."""
    if t >= times[-1]:
        x, y, z, w = keys[-2]
        return [w, x, y, z]
    k = max(i for i in range(len(times) - 1) if times[i] <= t)
    step = times[k + 1] - times[k]
    u = (t - times[k]) / step
    value, leaving, arriving, following = keys[3 * k + 1], keys[3 * k + 2], keys[3 * k + 3], keys[3 * k + 4]
    p = [(2 * u**3 - 3 * u**2 + 1) * value[c] + step * (u**3 - 2 * u**2 + u) * leaving[c]
         + (-2 * u**3 + 3 * u**2) * following[c] + step * (u**3 - u**2) * arriving[c] for c in range(4)]
    norm = math.hypot(*p)
    return [p[3] / norm, p[0] / norm, p[1] / norm, p[2] / norm]


def parts_of_glb(path):
    """The document and the bytes of a binary glTF file."""
    data = path.read_bytes()
    length = struct.unpack_from("<I", data, 12)[0]
    return json.loads(data[20:20 + length]), data[28 + length:]


def samplers_of(document, path):
    """(clip, node) -> its sampler, of the channels of that path."""
    return {(clip["name"], channel["target"]["node"]): clip["samplers"][channel["sampler"]]
            for clip in document["animations"] for channel in clip["channels"] if channel["target"]["path"] == path}


class SceneTest(CommandTest):
    def setUp(self):
        super().setUp()
        self.write("arm.bvh", bvh_text())
        self.write("swing.gltf", json.dumps(gltf_document()))

    def json_of(self, arguments):
        return json.loads(self.output_of(f"{arguments} --json"))
