#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Scenes against independent programs: three.js for the places of joints in the world, the Khronos validator for glTF files,
gltfpack and gltf-transform for files that go through them.

They are in the folder that ORISPLINE_ORACLES names, as oracles/prepare.sh fills it; where it could not, the test is skipped.
"""
import csv
import io
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

COMMAND, DATA = os.environ["ORISPLINE_COMMAND"], pathlib.Path(os.environ["ORISPLINE_SHARED_DATA"])
ORACLES = pathlib.Path(os.environ["ORISPLINE_ORACLES"])
HERE = pathlib.Path(__file__).parent
MAGE, CMU = DATA / "gltf/kaykit_mage_76clips.glb", DATA / "mocap/cmu_01_01_fairmotion.bvh"


def skip(reason):
    print("skipped:", reason)
    sys.exit(77)


def node(script, *arguments):
    return subprocess.run(["node", ORACLES / script, *map(str, arguments)], capture_output=True, text=True)


def orispline(*arguments):
    done = subprocess.run([COMMAND, *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def poses_of_three(file, clip, times):
    """Joint and time to position and quaternion."""
    done = node("three_poses.mjs", file, clip, *times)
    assert done.returncode == 0, done.stderr
    rows = (line.split("\t") for line in done.stdout.splitlines())
    return {(row[0], float(row[1])): [float(cell) for cell in row[2:]] for row in rows}


def our_poses(file, clip, joint, times, folder):
    listed = folder / "times.csv"
    listed.write_text("t\n" + "".join(f"{t}\n" for t in times))
    text = orispline("sample", file, "--clip", clip, "--joint", joint, "--space", "world", "--times", listed,
                     "--derivatives", "0", "--quiet")
    return [[float(row[name]) for name in ("px", "py", "pz", "qw", "qx", "qy", "qz")]
            for row in csv.DictReader(io.StringIO(text))]


def check_places(file, clip, joints, times, within, folder):
    """`within`: of positions, in the unit of the file, and of quaternions."""
    theirs = poses_of_three(file, clip, times)
    worst = [0.0, 0.0]
    for joint in joints:
        for t, ours in zip(times, our_poses(file, clip, joint, times, folder)):
            other = theirs[joint, t]
            sign = math.copysign(1.0, sum(a * b for a, b in zip(ours[3:], other[3:])))
            worst[0] = max(worst[0], math.dist(ours[:3], other[:3]))
            worst[1] = max(worst[1], math.dist(ours[3:], [sign * x for x in other[3:]]))
    print(f"{pathlib.Path(file).name} {clip}: {worst[0]:.2g} in place, {worst[1]:.2g} in the quaternion")
    assert worst[0] <= within[0] and worst[1] <= within[1], (file, clip, worst)


def check_with_three(folder):
    small, walk = folder / "small.glb", folder / "walk.glb"
    orispline("reduce", MAGE, "--clip", "Walking_A", "--tolerance", "1deg", "-o", small, "--quiet")
    orispline("convert", CMU, "-o", walk, "--quiet")
    joints, times = ["hips", "hand.r", "handslot.l", "head", "toes.r"], [0.0, 0.1, 0.31, 0.7, 1.06]
    for clip in ("Walking_A", "2H_Melee_Attack_Chop", "Sit_Chair_Down"):
        check_places(MAGE, clip, joints, times, (2e-6, 2e-6), folder)
    check_places(small, "Walking_A", joints, times, (2e-6, 2e-6), folder)
    for file in (CMU, walk):  # three.js holds times and angles of BVH as float32
        check_places(file, CMU.stem, ["Hips", "LeftHand", "Head", "RightFoot"], [0.0, 5.0, 11.125, 22.9], (3.5e-5, 1e-5), folder)


def check_with_validator(folder):
    def found(file):
        done = node("validate.mjs", file)
        assert done.returncode in (0, 1), done.stderr
        return {line.split(": ", 1)[1] for line in done.stdout.splitlines() if line.startswith(f"{file}: ")
                and line.split(": ", 1)[1].startswith(("error", "warning"))}

    before = found(MAGE)
    for name, arguments in {
            "small.glb": ["reduce", MAGE, "--tolerance", "0.21deg"],
            "world.gltf": ["reduce", MAGE, "--world-tolerance", "2mm", "--clip", "Walking_A", "--clip", "Idle"],
            "linear.glb": ["reduce", MAGE, "--tolerance", "1deg", "--method", "slerp", "--clip", "Walking_A"],
            "walk.glb": ["convert", CMU],
            "flight.glb": ["sample", HERE.parents[1] / "examples/data/flight_keys.csv", "--tolerance", "0.03deg"],
            "even.gltf": ["sample", HERE.parents[1] / "examples/data/flight_keys.csv", "--rate", "10"]}.items():
        orispline(*arguments, "-o", folder / name, "--quiet")
        new = found(folder / name) - before
        print(f"{name}: {len(new)} errors and warnings that the input has not")
        assert not new, new


def apart(first, second):
    """The largest distance in the world [m], of nodes without a mesh: gltf-transform moves and scales those that have one."""
    content = first.read_bytes()
    document = json.loads(content[20:20 + int.from_bytes(content[12:16], "little")])
    meshes = {node.get("name") for node in document["nodes"] if "mesh" in node}
    report = json.loads(orispline("difference", first, second, "--json"))
    return max(joint["shell_distance"]["largest"] for clip in report["clips"] for joint in clip["joints"] if joint["joint"] not in meshes)


def check_with_packers(folder):
    """Files that they compressed are read, and ours come through them."""
    def tool(name, *arguments):
        subprocess.run([ORACLES / "node_modules/.bin" / name, *map(str, arguments)], check=True, capture_output=True)

    clips = ["--clip", "Walking_A", "--clip", "Idle"]
    plain, linear, small, theirs = (folder / f"{name}.glb" for name in ("plain", "linear", "small", "theirs"))
    orispline("convert", MAGE, *clips, "-o", plain, "--quiet")
    orispline("reduce", plain, "--world-tolerance", "2mm", "--for", "meshopt", "-o", linear, "--quiet")
    if "without meshoptimizer" in subprocess.run([COMMAND, "convert", plain, "--compress", "meshopt", "-o", small, "--quiet"],
                                                 capture_output=True, text=True).stderr:
        skip("this build is without meshoptimizer")
    summary = orispline("reduce", plain, "--world-tolerance", "2mm", "--compress", "meshopt", "-o", small, "--json")
    found = {"ours": apart(plain, small)}
    assert found["ours"] <= json.loads(summary)["shell_distance_m"]["largest"] * 1.01 <= 2.02e-3, found
    tool("gltf-transform", "copy", small, theirs)  # which decodes
    found["decoded by gltf-transform"] = apart(small, theirs)
    assert found["decoded by gltf-transform"] <= 1e-4, found
    tool("gltf-transform", "meshopt", linear, theirs)
    found["linear keys by gltf-transform"] = apart(linear, theirs)
    assert found["linear keys by gltf-transform"] <= 2e-3, found
    for name in (linear, small):
        tool("gltfpack", "-i", name, "-o", theirs, "-kn", "-cc", "-af", "0")
        found[f"{name.stem} by gltfpack"] = apart(name, theirs)
        assert found[f"{name.stem} by gltfpack"] <= 2e-3, found
    tool("gltfpack", "-i", plain, "-o", theirs, "-kn", "-cc", "-af", "0")
    orispline("reduce", theirs, "--world-tolerance", "2mm", "-o", small, "--quiet")  # theirs is read, with meshes that stay packed
    found["read from gltfpack"] = apart(theirs, small)
    assert found["read from gltfpack"] <= 2e-3, found
    print(found)


if not MAGE.exists():
    skip(f"no {MAGE}")
if not (ORACLES / "node_modules/.installed").exists():
    skip("the packages of npm could not be installed")
with tempfile.TemporaryDirectory() as made:
    {"three": check_with_three, "validator": check_with_validator, "packers": check_with_packers}[sys.argv[1]](pathlib.Path(made))
