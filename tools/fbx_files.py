# SPDX-License-Identifier: Apache-2.0
"""Small FBX and Collada files of a turning bone, for the corpus of the fuzz target that reads them."""
import struct

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


def scene_files():
    """By name, after a byte of options: 0 for FBX, 1 for Collada."""
    angles = [0, 40, 10, -80]
    yield "text", b"\0" + fbx_text(angles)
    yield "binary", b"\0" + fbx_binary(angles)
    yield "collada", b"\1" + collada(angles)
    yield "one_key", b"\0" + fbx_binary([30])
    yield "half_turns", b"\1" + collada([0, 180, 360, 540])
    yield "no_fbx", b"\0not an FBX file"
