# SPDX-License-Identifier: Apache-2.0
"""Text and names of files that are not UTF-8: bytes pass as Python has them in names, and in messages every terminal can print them."""
import os
import pathlib
import pickle
import sys

import orispline as ori
import pytest

ROWS = b"0,1,0,0,0,20\n1,0.8,0,0,0.6,21\n"
LATIN = "caf\udce9"  # café in Latin-1, as os.fsdecode has it
KEYS = ori.Keys([0, 1], [[0, 0, 0, 1], [0, 0, 0.6, 0.8]])


def test_columns_that_are_not_utf_8_are_left_alone(tmp_path):
    path = tmp_path / "keys.csv"
    path.write_bytes(b"t,qw,qx,qy,qz,temp_\xb0C\n" + ROWS)
    assert ori.read(path) == KEYS
    path.write_bytes(b"zeit_\xb0,qw,qx,qy,qz,temp\n" + ROWS)
    assert ori.read(path, columns={"t": os.fsdecode(b"zeit_\xb0")}) == KEYS


@pytest.mark.parametrize("rows", [ROWS.replace(b"0.6", b"0.6\xb0"), ROWS.replace(b"1,0.8", b"\xfe,0.8"),
                                  "t,qw".encode("utf-16")])
def test_cells_that_are_not_utf_8_are_errors_of_the_data(rows, tmp_path):
    path = tmp_path / "keys.csv"
    path.write_bytes(b"t,qw,qx,qy,qz,range\n" + rows)
    with pytest.raises(ori.DataError) as found:
        ori.read(path)
    str(found.value).encode("utf-8")  # can be printed
    assert "\n" not in str(found.value) and found.value.file == str(path)


@pytest.mark.skipif(sys.platform != "linux", reason="names of files are bytes on Linux")
def test_names_of_files_that_are_not_utf_8(tmp_path):
    for name in (LATIN, pathlib.Path(LATIN)):
        path = tmp_path / f"{name}.csv"
        KEYS.write(path)
        assert os.fsencode(path) in {os.path.join(os.fsencode(tmp_path), each) for each in os.listdir(os.fsencode(tmp_path))}
        found = ori.read(path)
        assert found == KEYS and pickle.loads(pickle.dumps(found, 5)) == KEYS
    KEYS.curve().report(tmp_path / f"{LATIN}.html", title=LATIN)
    KEYS.curve().sample(count=3).write(tmp_path / f"motion {LATIN}.csv")
    KEYS.write(tmp_path / f"{LATIN}.npy")
    assert ori.read(tmp_path / f"{LATIN}.npy") == KEYS
    (tmp_path / f"{LATIN}.npy").write_bytes(b"no array")
    for kind, name in ((ori.DataError, f"{LATIN}.npy"), (ori.AccessError, f"no {LATIN}.npy")):
        with pytest.raises(kind, match=r"caf\\xe9.npy: ") as found:
            ori.read(tmp_path / name)
        assert found.value.file == str(tmp_path / name)
    ori.tune(ori.read(tmp_path / f"motion {LATIN}.csv"), "quintic")
    with pytest.raises(ori.AccessError) as missing:
        ori.read(tmp_path / f"no {LATIN}.csv")
    assert missing.value.file == str(tmp_path / f"no {LATIN}.csv") and "caf?.csv: cannot open" in str(missing.value)
    (tmp_path / f"{LATIN} broken.csv").write_bytes(b"t,qw,qx,qy,qz\n0,1,0,0\n")
    with pytest.raises(ori.DataError, match=r"caf\? broken.csv") as broken:
        ori.read(tmp_path / f"{LATIN} broken.csv")
    assert broken.value.file == str(tmp_path / f"{LATIN} broken.csv")


def test_names_of_joints_that_are_not_utf_8_can_be_printed(tmp_path):
    text = ("HIERARCHY\nROOT caf\udce9\n{\nOFFSET 0 1.5 0\nCHANNELS 3 Zrotation Xrotation Yrotation\nEnd Site\n{\nOFFSET 0 0.2 0\n}\n}\n"
            "MOTION\nFrames: 3\nFrame Time: 0.5\n0 0 0\n0 20 0\n0 0 0\n")
    path = tmp_path / "nod.bvh"
    path.write_bytes(os.fsencode(text))
    scene = ori.read_scene(path)
    name = scene.skeleton.names[0]
    assert name == scene.clips[0].channels[0].joint == "caf\ufffd" and len(ori.read(path, joint=name)) == 3
    small, report = ori.reduce_scene(scene, "1deg")
    str(report).encode("utf-8")
    assert set(*ori.shell_distance(scene, small).values()) == set(scene.skeleton.names)
    with pytest.raises(ori.Error) as found:
        ori.read(path, joint=LATIN)
    str(found.value).encode("utf-8")


@pytest.mark.parametrize("name", ["\ud800.csv", "\ud800.npy", "\ud800.glb"])
def test_names_that_no_file_can_have_are_refused(name):
    for ask in (ori.read, ori.read_scene, KEYS.write, KEYS.curve().report, KEYS.curve().sample(count=2).write):
        with pytest.raises(ori.ArgumentError, match=r"path: found '\\ud800.* wanted the name of a file"):
            ask(name)


def test_words_that_are_no_unicode_are_unknown_words():
    for word in (LATIN, "\ud800", "\udfff"):
        for ask in (lambda word: KEYS.curve(word), lambda word: KEYS.curve("quintic", tension=word), lambda word: ori.smooth(KEYS, noise=word),
                    lambda word: ori.compare(KEYS, word), lambda word: KEYS.curve("timed-c2", ends=word)):
            with pytest.raises(ori.ArgumentError) as found:
                ask(word)
            str(found.value).encode("utf-8")
