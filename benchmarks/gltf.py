#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Clips beside what gltfpack and gltf-transform make of them: gltf.py COMMAND FOLDER FILE... [--tolerance 2mm]

FOLDER has the packages of tests/scenes/oracles, as its prepare.sh fills it. Of each file, which is glTF, each program
makes a smaller one; the table says how many keys that has, the bytes of its animations with their JSON, alone and by
gzip, how far it is from the file in the world, and how long it took. Meshes are left out on both sides."""
import argparse
import gzip
import json
import pathlib
import struct
import subprocess
import sys
import tempfile
import time

EXTENSIONS = ("EXT_meshopt_compression", "KHR_meshopt_compression")


def parts_of(path):
    content = path.read_bytes()
    length, = struct.unpack_from("<I", content, 12)
    return json.loads(content[20:20 + length]), content[28 + length:]


def compression_of(view):
    return next((view["extensions"][name] for name in EXTENSIONS if name in view.get("extensions", {})), None)


def animations_alone(path):
    """The bytes of a GLB of nothing but the animations, without its header, and how many keys these have."""
    document, binary = parts_of(path)
    samplers = [sampler for animation in document["animations"] for sampler in animation["samplers"]]
    accessors = sorted({sampler[key] for sampler in samplers for key in ("input", "output")})
    keys = sum(document["accessors"][sampler["input"]]["count"] for sampler in samplers)
    views = sorted({document["accessors"][i]["bufferView"] for i in accessors if "bufferView" in document["accessors"][i]})
    kept, data, decoded = [], bytearray(), 0
    for view in (document["bufferViews"][i] for i in views):
        place = compression_of(view) or view
        data += bytes(-len(data) % 4)
        start = place.get("byteOffset", 0)
        place["buffer"], place["byteOffset"], start, end = 0, len(data), start, start + place["byteLength"]
        data += binary[start:end]
        if place is not view:
            view["buffer"], view["byteOffset"] = 1, decoded
            decoded += view["byteLength"]
        kept.append(view)
    for sampler in samplers:
        for key in ("input", "output"):
            sampler[key] = accessors.index(sampler[key])
    for i in accessors:
        if "bufferView" in (accessor := document["accessors"][i]):
            accessor["bufferView"] = views.index(accessor["bufferView"])
    alone = {"asset": {"version": "2.0"}, "animations": document["animations"], "accessors": [document["accessors"][i] for i in accessors],
             "bufferViews": kept, "buffers": [{"byteLength": len(data)}] + ([{"byteLength": decoded}] if decoded else [])}
    return json.dumps(alone, separators=(",", ":")).encode() + data, keys


class Table:
    def __init__(self, command, tools, folder):
        self.command, self.tools, self.folder = command, tools / "node_modules/.bin", folder

    def orispline(self, *words):
        done = subprocess.run([self.command, *map(str, words)], capture_output=True, text=True, check=False)
        if done.returncode:
            sys.exit(done.stderr)
        return done.stdout

    def tool(self, name, *words):
        subprocess.run([self.tools / name, *map(str, words)], check=True, capture_output=True)

    def error(self, file, made):
        """The largest distance in the world [m], of nodes without a mesh: gltf-transform moves and scales those that have one."""
        meshes = {node.get("name") for node in parts_of(file)[0]["nodes"] if "mesh" in node}
        report = json.loads(self.orispline("difference", file, made, "--json"))
        return max(joint["shell_distance"]["largest"] for clip in report["clips"] for joint in clip["joints"] if joint["joint"] not in meshes)

    def row(self, file, name, make):
        made = self.folder / "made.glb"
        made.unlink(missing_ok=True)
        start = time.perf_counter()
        make(made)
        took = time.perf_counter() - start
        alone, keys = animations_alone(made)
        error = self.error(file, made)
        print(f"| {name} | {keys} | {len(alone) / 1000:.1f} | {len(gzip.compress(alone, 9)) / 1000:.1f} | {1000 * error:.3f} | {took:.1f} |", flush=True)
        return error

    def of(self, file, tolerance):
        print(f"\n{file.name}, tolerance {tolerance}\n\n| program | keys | kB | gzip kB | error mm | s |\n|---|---|---|---|---|---|", flush=True)
        reduce = ("reduce", file, "--quiet", "-o")
        within = ("--world-tolerance", tolerance)
        packed = self.row(file, "`gltfpack -kn -cc -af 0`", lambda made: self.tool("gltfpack", "-i", file, "-o", made, "-kn", "-cc", "-af", "0"))
        self.row(file, "`gltf-transform meshopt`", lambda made: self.tool("gltf-transform", "meshopt", file, made))
        self.row(file, "`reduce`", lambda made: self.orispline(*reduce, made, *within))
        self.row(file, "`reduce --method smallest`", lambda made: self.orispline(*reduce, made, *within, "--method", "smallest"))
        self.row(file, "`reduce --compress meshopt`", lambda made: self.orispline(*reduce, made, *within, "--compress", "meshopt"))
        self.row(file, "the same at gltfpack's error", lambda made: self.orispline(*reduce, made, "--world-tolerance", f"{packed}m", "--compress", "meshopt"))
        linear = self.folder / "linear.glb"
        self.orispline(*reduce, linear, *within, "--for", "meshopt")
        self.row(file, "`reduce --for meshopt`, then `gltf-transform meshopt`", lambda made: self.tool("gltf-transform", "meshopt", linear, made))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", type=pathlib.Path)
    parser.add_argument("tools", type=pathlib.Path)
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    parser.add_argument("--tolerance", default="2mm")
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        table = Table(options.command.resolve(), options.tools.resolve(), pathlib.Path(folder))
        for file in options.files:
            table.of(file, options.tolerance)


if __name__ == "__main__":
    main()
