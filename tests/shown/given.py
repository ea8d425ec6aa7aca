# SPDX-License-Identifier: Apache-2.0
"""The files that the pages take as the reader's own: short ones that are made here, and recordings that lie beside the project.

They are of one motion, the first eleven seconds of the bundled flight.
"""
import functools
import json
import os
import pathlib
import random
import struct
import sys

from pages import ROOT, blocks

sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "tests/cli")]
from motions.rotations import DEGREE, X, Y, Z, conjugate, times, to_body, to_world, turn  # noqa: E402
from small_scenes import bvh_text, gltf_document  # noqa: E402

SHARED = pathlib.Path(os.environ.get("ORISPLINE_SHARED_DATA", "shared/data")).parent
SPAN = 11.0  # [s]


@functools.cache
def bundled(name):
    """The rows of the first eleven seconds of an example, as numbers by the names of columns."""
    lines = [line for line in (ROOT / "examples/data" / name).read_text("utf-8").splitlines() if not line.startswith("#")]
    names = lines[0].split(",")
    rows = [dict(zip(names, map(float, line.split(",")))) for line in lines[1:]]
    return [row for row in rows if row["t"] <= SPAN]


def truth():
    return bundled("flight_truth.csv")


def keys():
    return truth()[::50]


def part(row, names):
    return tuple(row[name] for name in names.split())


def changed(row, names, values):
    return row | dict(zip(names.split(), values, strict=True))


Q, P, W = "qw qx qy qz", "px py pz", "wx wy wz"


def noisy(rows, degrees=0.5, seed=1):
    """Each orientation turned by noise about three axes, and each position moved by centimetres."""
    dice = random.Random(seed)
    for row in rows:
        q = functools.reduce(times, [turn(axis, dice.gauss(0, degrees) * DEGREE) for axis in (X, Y, Z)], part(row, Q))
        row = changed(row, Q, q)
        yield changed(row, P, [x + dice.gauss(0, 0.02) for x in part(row, P)]) if "px" in row else row


def elsewhere(rows, late=0.15):
    """As another device has it that is mounted otherwise, in a world and on a clock of its own."""
    world, body = turn(Z, 0.7), turn(X, 0.3)
    for row in rows:
        q = times(times(world, part(row, Q)), conjugate(body))
        yield changed(changed(row, Q, q), P, to_world(world, part(row, P))) | {"t": row["t"] + late}


def of_gyro(rows, seed, mounted=turn(Y, 0.2)):
    dice = random.Random(seed)
    for row in rows:
        yield {"t": row["t"] + 0.03} | dict(zip(W.split(), [x + 0.01 + dice.gauss(0, 0.005) for x in to_body(mounted, part(row, W))]))


def csv(rows, columns=f"t {Q} {P}"):
    names = columns.split()
    return "\n".join([",".join(names), *(",".join(repr(row[name]) for name in names) for row in rows)]) + "\n"


def tum(rows):
    return "".join(" ".join(repr(row[name]) for name in "t px py pz qx qy qz qw".split()) + "\n" for row in rows)


def shots():
    """One pose that was taken six times, each time off about one axis [deg]."""
    pose = (0.070428191027894244, -0.17980984597450927, -0.070428191027894285, 0.9786460847046291)
    offs = [(axis, sign * angle) for axis, angle in ((X, 1), (Y, 2), (Z, 1.5)) for sign in (1, -1)]
    rows = [dict(zip(Q.split(), times(pose, turn(axis, angle * DEGREE)))) | {"confidence": 1.0} for axis, angle in offs]
    return csv(rows, f"{Q} confidence")


def loop():
    return csv([*keys(), keys()[0] | {"t": SPAN + 1.0}], f"t {Q}")


def character():
    """A binary glTF file with clips and a joint of the names that the pages have."""
    document = gltf_document()
    document["nodes"][0]["name"] = "hand.r"
    [clip] = document["animations"]
    document["animations"] = [clip | {"name": name} for name in ("Walking_A", "Walking_B", "Idle")]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    return struct.pack("<4sIII4s", b"glTF", 2, 20 + len(text), len(text), b"JSON") + text


def shown(page, first):
    """What a page shows as a file of its own."""
    return next(block.text for block in blocks(page) if block.text.startswith(first))


MADE = {
    **dict.fromkeys(("recording.csv", "truth.csv", "mocap.csv", "px4.csv", "cv.csv", "room.csv", "unity.csv", "colmap.csv"), lambda: csv(truth())),
    "keys.csv": lambda: csv(keys()),
    "my.csv": lambda: csv(bundled("five_keys.csv"), f"t {Q}"),
    "loop.csv": loop,
    "example1.csv": lambda: shown("docs/families/beta.md", "t,qw"),
    "noisy.csv": lambda: csv(noisy(truth())),
    "trajectory.tum": lambda: tum([*truth()[:500], *truth()[499:]]),
    "truth.tum": lambda: tum(truth()),
    "poses.tum": lambda: tum(noisy(truth())),
    "estimate.csv": lambda: csv(elsewhere(noisy(truth()))),
    "headset.csv": lambda: csv(elsewhere(truth(), late=0.0)),
    "camera.tum": lambda: tum(elsewhere(truth())),
    "imu.csv": lambda: csv(noisy(truth()), f"t {Q} {W}"),
    "poses.csv": lambda: csv(noisy(truth(), seed=2), f"t {Q}"),
    "gyro.csv": lambda: csv(of_gyro(truth(), seed=3), f"t {W}"),
    "other_gyro.csv": lambda: csv(of_gyro(truth(), seed=4, mounted=turn(Z, 0.4)), f"t {W}"),
    **dict.fromkeys(("shots.csv", "monday.csv", "tuesday.csv"), shots),
    "shots": {"left.csv": shots, "right.csv": shots},
    **dict.fromkeys(("hips.csv", "head.csv", "arm.csv"), lambda: csv(truth())),
    "joints": {"head.csv": lambda: csv(keys()), "left/hand.csv": lambda: csv(keys())},
    "mage.glb": character,
    "walk.bvh": bvh_text,
}


def recorded(name):
    return lambda: (SHARED / name).read_bytes()


def columns_of(name, count, first):
    """Time and `count` columns of a recording from `first` on."""
    def text():
        rows = (line.split(",") for line in (SHARED / name).read_text("utf-8").splitlines())
        return "".join(",".join([row[0], *row[first:first + count]]) + "\n" for row in rows)
    return text


# Of the recordings of which a page states what comes out. Without them its lines run on what is made.
GYRO = {"imu.csv": recorded("cases/recordings/04n_99ms.csv"), "poses.csv": columns_of("cases/recordings/04n_0ms.csv", 4, 1),
        "gyro.csv": columns_of("cases/recordings/04n_99ms.csv", 3, 5), "other_gyro.csv": columns_of("cases/recordings/04n_0ms.csv", 3, 5)}
MAGE = {"mage.glb": recorded("data/gltf/kaykit_mage_76clips.glb")}
RECORDED = {"docs/align.md": GYRO, "docs/gyro.md": GYRO, "docs/gltf.md": MAGE, "docs/skeletons.md": MAGE,
            "docs/bvh.md": {"walk.bvh": recorded("data/mocap/cmu_01_01_fairmotion.bvh")}}

# Of one page alone: what it says is wrong, and what it has by no name.
OF_PAGE = {"docs/conventions.md": {"keys.csv": lambda: csv([keys()[0] | {"t": t} for t in (0.0, 1.5, 1.5)], f"t {Q}")},
           "docs/files.md": {"here/scan.tum": lambda: tum(noisy(truth()))}}

# Recordings by their own names. Without them the lines that take them are not run.
NAMED = {name.rpartition("/")[2]: recorded(f"data/{name}") for name in (
    "flight/px4_quad_sample_attitude.csv", "imu/broad_06_undisturbed_fast_rotation_A_40s.csv", "spacecraft/mro_ck_sliced_-74000.csv",
    "trajectory/tum_fr2_desk_groundtruth.txt", "mocap/cmu_01_01_fairmotion.bvh")}


def has_recordings():
    return (SHARED / "cases/recordings").is_dir() and (SHARED / "data/gltf").is_dir()


def put(folder, files):
    for name, content in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if isinstance(content, dict):
            put(path, content)
        else:
            made = content()
            path.write_bytes(made if isinstance(made, bytes) else made.encode())


def give(folder, page, words):
    """Puts the files that `words` of the page name into the folder."""
    files = MADE | (RECORDED.get(page, {}) | NAMED if has_recordings() else {})
    put(folder, {name: content for name, content in files.items() if name in words} | OF_PAGE.get(page, {}))
    for place in ("examples", "tests/data"):
        (folder / place).parent.mkdir(exist_ok=True)
        (folder / place).symlink_to(ROOT / place)
