# SPDX-License-Identifier: Apache-2.0
"""Skeletons with their clips: read, reduced, compared and written."""
import base64
import json
import math

import numpy as np
import orispline as ori
import pytest
from page_data import data_of
from task_files import json_of, run

HALF = math.radians(10)


def bvh(path, turns, offset="0 0.3 0"):
    """A file of an arm that turns about z by these angles [deg] at 30 Hz, its elbow by half of them about x."""
    rows = "\n".join(f"0 1 0 {turn:.9g} 0 0 0 {turn / 2:.9g} 0" for turn in turns)
    path.write_text("HIERARCHY\nROOT shoulder\n{\nOFFSET 0 1 0\nCHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation "
                    f"Yrotation\nJOINT elbow\n{{\nOFFSET {offset}\nCHANNELS 3 Zrotation Xrotation Yrotation\n"
                    "End Site\n{\nOFFSET 0 0.25 0\n}\n}\n}\n"
                    f"MOTION\nFrames: {len(turns)}\nFrame Time: 0.0333333\n{rows}\n", "utf-8")
    return path


@pytest.fixture
def arm(tmp_path):
    return ori.read_scene(bvh(tmp_path / "arm.bvh", 50 * np.sin(np.linspace(0, 6, 121))))


def channel(scene, joint, kind="rotation"):
    found, = (one for one in scene.clips[0].channels if (one.joint, one.property) == (joint, kind))
    return found


def angles(a, b):
    return 2 * np.arccos(np.clip(np.abs(np.sum(a * b, axis=-1)), 0, 1))


def test_a_scene_tells_its_joints_and_clips(arm):
    skeleton = arm.skeleton
    assert skeleton.names[:2] == ("shoulder", "elbow") and len(skeleton) == len(skeleton.parents)
    assert skeleton.parents[:2].tolist() == [-1, 0]
    assert skeleton.translations[1].tolist() == [0, 0.3, 0] and skeleton.rotations[1].tolist() == [0, 0, 0, 1]
    assert skeleton.scales.tolist() == [[1, 1, 1]] * len(skeleton)
    clip, = arm.clips
    assert clip.start == 0 and clip.end == pytest.approx(120 * 0.0333333)
    turn = channel(arm, "shoulder")
    assert turn.interpolation == "linear" and turn.in_tangents is None and turn.values.shape == (121, 4)
    half = np.radians(50 * np.sin(np.linspace(0, 6, 121))) / 2
    assert np.abs(np.abs(turn.values) - np.abs(np.column_stack([0 * half, 0 * half, np.sin(half), np.cos(half)]))).max() < 1e-9
    assert repr(arm).startswith("Scene('") and repr(turn) == "Channel('shoulder', 'rotation', 'linear', 121 keys)"


def test_quaternions_have_their_scalar_where_it_is_asked_for(arm, tmp_path):
    first = ori.read_scene(tmp_path / "arm.bvh", scalar_first=True)
    assert np.array_equal(channel(first, "elbow").values[:, [1, 2, 3, 0]], channel(arm, "elbow").values)
    assert first.skeleton.rotations[0].tolist() == [1, 0, 0, 0]
    small, _ = ori.reduce_scene(first, "1deg")
    assert channel(small, "elbow").values[0, 0] > 0.9 and channel(small, "elbow").in_tangents.shape[1] == 4


def test_a_reduced_scene_is_within_the_tolerance_and_survives_a_file(arm, tmp_path):
    small, report = ori.reduce_scene(arm, tolerance=math.radians(0.1))
    assert report.rotation_keys_before == 242 and report.rotation_tracks == 2
    assert 4 <= report.rotation_keys < 60
    assert report.rotation_keys == sum(len(one) for one in small.clips[0].channels if one.property == "rotation")
    assert 0 < report.angle.value <= math.radians(0.1)
    assert report.angle.joint in ("shoulder", "elbow") and report.angle.clip == arm.clips[0].name
    assert channel(small, "elbow").interpolation == "cubicspline"
    small.write(tmp_path / "small.glb")
    again = ori.read_scene(tmp_path / "small.glb")
    assert np.array_equal(channel(again, "elbow").times.astype("float32"), channel(small, "elbow").times.astype("float32"))
    assert angles(channel(again, "elbow").values, channel(small, "elbow").values).max() < 1e-6
    assert len(channel(arm, "elbow")) == 121, "the scene that was given has not changed"


def test_methods_and_threads(arm):
    linear, report = ori.reduce_scene(arm, "0.1deg", method="slerp", threads=2)
    cubic, cubics = ori.reduce_scene(arm, "0.1deg", threads=1)
    assert channel(linear, "elbow").interpolation == "linear" and report.rotation_keys > cubics.rotation_keys
    same, _ = ori.reduce_scene(arm, "0.1deg", threads=2)
    assert np.array_equal(channel(cubic, "elbow").out_tangents, channel(same, "elbow").out_tangents)


def test_the_world_tolerance_holds_the_shell_distance(arm):
    small, report = ori.reduce_scene(arm, world_tolerance=0.002, shell=0.05, position_scale=1)
    distances = ori.shell_distance(arm, small, shell=0.05)
    clip, = distances
    assert set(distances[clip]) >= {"shoulder", "elbow"}
    # The report looks between the keys too, where both move on.
    assert 0.99 * report.distance.value <= max(distances[clip].values()) <= report.distance.value <= 0.002
    assert report.rotation_keys < 60


def test_lengths_of_a_file_without_a_unit_want_a_scale(arm):
    for name in ("world_tolerance", "position_tolerance"):
        with pytest.raises(ori.ArgumentError, match=f"^{name}: found a BVH file, which has no unit of length, wanted `position_scale`"):
            ori.reduce_scene(arm, "1deg", **{name: "2mm"})
    with pytest.raises(ori.ArgumentError, match="position_scale: found 0"):
        ori.reduce_scene(arm, "1deg", position_scale=0)
    in_metres, report = ori.reduce_scene(arm, world_tolerance="2mm", shell=0.005, position_scale=0.1)
    in_units, other = ori.reduce_scene(arm, world_tolerance=0.02, shell=0.05, position_scale=1)
    assert report.rotation_keys == other.rotation_keys and report.as_dict()["world_tolerance_m"] == pytest.approx(0.002)
    assert report.distance.value == pytest.approx(0.1 * other.distance.value) and report.distance.joint == other.distance.joint
    assert np.array_equal(channel(in_metres, "elbow").values, channel(in_units, "elbow").values)


def test_single_precision_that_cannot_hold_the_tolerance_is_warned_of(arm):
    with pytest.warns(ori.ShapeWarning, match="^tolerance: found .*single precision") as caught:
        ori.reduce_scene(arm, 1e-9)
    assert caught[0].message.code == "single_precision" and caught[0].filename == __file__


def test_what_was_done_is_said_as_by_the_command(arm, tmp_path):
    source, out = tmp_path / "arm.bvh", tmp_path / "small.glb"
    words = ["reduce", source, "--tolerance", "0.1deg", "--world-tolerance", "2mm", "--position-scale", "0.1", "-o", out]
    *told, _ = [line for line in run(*words)[1].splitlines() if "warning: " not in line]  # the last: where it was written
    _, report = ori.reduce_scene(arm, "0.1deg", world_tolerance="2mm", position_scale=0.1)
    assert str(report).splitlines() == told
    document = json_of(*words)
    assert report.as_dict() == {name: document[name] for name in report.as_dict()}
    assert set(document) - set(report.as_dict()) == {"input", "output", "bytes_before", "bytes", "warnings"}
    assert document["shell_distance_m"] == {"largest": report.distance.value, "clip": report.distance.clip,
                                            "joint": report.distance.joint, "time_s": report.distance.time}


def test_shell_distance_is_the_chord_of_the_farthest_point(tmp_path):
    a = ori.read_scene(bvh(tmp_path / "a.bvh", [0, 0, 0]))
    (tmp_path / "b").mkdir()
    b = ori.read_scene(bvh(tmp_path / "b/a.bvh", [0, 20, 0]))
    found = ori.shell_distance(a, b, shell=0.1)[a.clips[0].name]
    assert found["shoulder"] == pytest.approx(2 * 0.1 * math.sin(HALF))


def test_the_only_clips_are_compared_whatever_their_names(tmp_path):
    a, b = (ori.read_scene(bvh(tmp_path / f"{name}.bvh", [0, 20, 0])) for name in "ab")
    assert set(ori.shell_distance(a, b)) == {a.clips[0].name} != {b.clips[0].name}


def test_keys_of_a_joint_are_read_as_those_of_a_table(arm, tmp_path):
    arm.write(tmp_path / "arm.glb")
    for name in ("arm.bvh", "arm.glb"):
        keys = ori.read(tmp_path / name, joint="elbow")
        assert len(keys) == 121 and angles(keys.rotations, channel(arm, "elbow").values).max() < 1e-6
    world = ori.read(tmp_path / "arm.bvh", joint="elbow", space="world", clip=arm.clips[0].name)
    assert world.positions.shape == (121, 3) and np.abs(world.positions[0] - [0, 1.3, 0]).max() < 1e-9
    with pytest.raises(ori.DataError, match=r"joint=.* chooses one"):
        ori.read(tmp_path / "arm.bvh")


def test_bvh_has_the_order_of_angles_that_is_asked_for(arm, tmp_path):
    arm.write(tmp_path / "zyx.bvh", output_euler="ZYX")
    assert "CHANNELS 3 Zrotation Yrotation Xrotation" in (tmp_path / "zyx.bvh").read_text("utf-8")
    with pytest.raises(ori.ArgumentError, match="wanted three different axes"):
        arm.write(tmp_path / "no.bvh", output_euler="ZZZ")
    assert not (tmp_path / "no.bvh").exists()


def gltf(path, nodes=(), animations=(), **more):
    """A file of glTF with these parts, and keys of scalars at 0.5, 1 and 2 s as accessor 0."""
    data = np.array([0.5, 1, 2, 0, 1, 0], "<f4").tobytes()
    document = {"asset": {"version": "2.0"}, "buffers": [{"byteLength": len(data), "uri": "data:;base64," + base64.b64encode(data).decode()}],
                "bufferViews": [{"buffer": 0, "byteLength": 12}, {"buffer": 0, "byteOffset": 12, "byteLength": 12}],
                "accessors": [{"bufferView": k, "componentType": 5126, "count": 3, "type": "SCALAR"} for k in (0, 1)],
                "nodes": list(nodes), "animations": list(animations), **more}
    path.write_text(json.dumps({name: part for name, part in document.items() if part}), "utf-8")
    return path


def animation(*targets):
    return {"name": "act", "channels": [{"sampler": 0, "target": target} for target in targets],
            "samplers": [{"input": 0, "output": 1}]}


@pytest.mark.parametrize(("nodes", "animations", "end"), [
    ([], [], None), ([{"name": "a"}], [], None), ([], [animation()], 0), ([{"name": "a"}], [animation()], 0),
    ([], [animation({"path": "pointer"})], 2), ([{"name": "a"}], [animation({"path": "weights", "node": 0})], 2)])
def test_scenes_in_which_nothing_moves_have_their_answers(tmp_path, nodes, animations, end):
    scene = ori.read_scene(gltf(tmp_path / "a.gltf", nodes, animations))
    assert len(scene.skeleton) == len(nodes) and scene.skeleton.translations.shape == (len(nodes), 3)
    assert [(clip.name, clip.end, clip.channels) for clip in scene.clips] == ([] if end is None else [("act", end, ())])
    for options in ({"tolerance": "1deg"}, {"world_tolerance": "1mm", "closed": True}, {"position_tolerance": "1mm"}):
        small, report = ori.reduce_scene(scene, **options)
        assert report.rotation_keys == 0 and report.angle == report.distance == report.translation == type(report.angle)(0, "", "", 0)
        assert not {"angle_deg", "translation_m", "shell_distance_m"} & set(report.as_dict()) and str(report).startswith(str(len(scene.clips)))
        small.write(tmp_path / "b.glb")
        assert len(ori.read_scene(tmp_path / "b.glb").clips) == len(scene.clips)
    assert ori.shell_distance(scene, scene) == ({} if end is None else {"act": {"a": 0.0} if nodes else {}})
    with pytest.raises(ori.DataError, match="found no clip, wanted one" if end is None else "found no rotation, wanted one"):
        ori.read(tmp_path / "a.gltf")


def test_joints_of_one_name_are_found_by_their_place(tmp_path):
    def file(name, order):
        nodes = [{"name": "left", "children": [order.index(2)]}, {"name": "right", "children": [order.index(3)]},
                 {"name": "bone", "translation": [1, 0, 0]}, {"name": "bone", "translation": [2, 0, 0]}]
        return ori.read_scene(gltf(tmp_path / name, [nodes[k] for k in order], [animation()]))

    first, other = file("a.gltf", (0, 1, 2, 3)), file("b.gltf", (3, 1, 0, 2))
    assert max(ori.shell_distance(first, other)["act"].values()) == 0
    twins = ori.read_scene(gltf(tmp_path / "twins.gltf", [{"name": "bone"}, {"name": "bone"}], [animation()]))
    with pytest.warns(ori.ShapeWarning, match="found 2 joints whose name others have too, such as 'bone'") as caught:
        ori.shell_distance(twins, twins)
    assert caught[0].message.code == "joints_guessed" and caught[0].filename == __file__


def test_a_bound_that_is_given_holds_for_what_nearly_rests(tmp_path):
    scene = ori.read_scene(bvh(tmp_path / "still.bvh", 2e-4 * np.sin(np.linspace(0, 6, 121))))
    _, report = ori.reduce_scene(scene, "1e-5deg", method="slerp")
    assert 0 < report.angle.value <= math.radians(1e-5)


@pytest.fixture
def noisy(tmp_path):
    """An arm of the file noisy.bvh, whose shoulder is recorded with noise of 0.3°; and how it truly turns [deg]."""
    truth = 50 * np.sin(np.linspace(0, 6, 121))
    return ori.read_scene(bvh(tmp_path / "noisy.bvh", truth + 0.3 * np.random.default_rng(3).normal(size=121))), truth


def test_a_scene_is_smoothed_as_by_the_command(noisy, tmp_path):
    scene, truth = noisy
    smooth, found = ori.smooth_scene(scene)
    *told, _ = run("smooth", tmp_path / "noisy.bvh", "-o", tmp_path / "by_command.bvh")[1].splitlines()  # where it was written
    assert str(found).splitlines() == told
    document = json_of("smooth", tmp_path / "noisy.bvh", "-o", tmp_path / "again.bvh")
    assert found.as_dict()["clips"] == document["clips"]
    smooth.write(tmp_path / "mine.bvh")
    assert (tmp_path / "mine.bvh").read_bytes() == (tmp_path / "by_command.bvh").read_bytes()
    turn = lambda of: np.degrees(2 * np.arctan2(channel(of, "shoulder").values[:, 2], channel(of, "shoulder").values[:, 3]))
    rms = lambda of: np.sqrt(np.mean((turn(of) - truth) ** 2))
    assert rms(smooth) < 0.6 * rms(scene), "the shoulder turns about z alone"
    shoulder, elbow = found.joints
    assert (shoulder.joint, elbow.joint, shoulder.clip) == ("shoulder", "elbow", scene.clips[0].name)
    assert 0.2 < math.degrees(shoulder.change) < 2 and (found.left, found.refused) == (0, 0)
    assert len(channel(scene, "elbow")) == len(channel(smooth, "elbow")) == 121


def test_smoothing_of_a_scene_takes_the_options_of_smoothing(noisy):
    scene, _ = noisy
    one, two = (ori.smooth_scene(scene, cutoff=2, threads=threads)[0] for threads in (1, 2))
    assert np.array_equal(channel(one, "shoulder").values, channel(two, "shoulder").values)
    by_time, found = ori.smooth_scene(scene, smoothing_time=1 / (4 * math.pi))
    assert np.array_equal(channel(one, "shoulder").values, channel(by_time, "shoulder").values)
    assert {joint.smoothing_time for joint in found.joints} == {1 / (4 * math.pi)}
    with pytest.raises(ori.ArgumentError, match="cutoff: found it beside noise"):
        ori.smooth_scene(scene, cutoff=2, noise=0.1)
    for option, says in [("gyro", "no angular velocities"), ("sigma", "no room for standard deviations")]:
        with pytest.raises(ori.ArgumentError, match=f"{option}: found clips, which have {says}"):
            ori.smooth_scene(scene, **{option: True})
    assert not {"gyro", "gyro_offset", "sigma"} & set(ori.smooth_scene.__signature__.parameters)
    with pytest.raises(TypeError, match="scene: found str, wanted a Scene"):
        ori.smooth_scene("noisy.bvh")


def test_a_scene_is_edited_as_by_the_command(noisy, tmp_path):
    scene, _ = noisy
    start, end = scene.clips[0].start, scene.clips[0].end
    cut, found = ori.clip_scene(scene, from_=start + 0.25 * (end - start), to=end, shift=0)
    assert (cut.clips[0].start, found.clips[0].end) == (0, end)
    document = json_of("clip", tmp_path / "noisy.bvh", "--from", start + 0.25 * (end - start), "--to", end, "--shift", "0", "-o", tmp_path / "cut.glb")
    assert found.as_dict()["clips"] == document["clips"]
    twice, joined = ori.clip_scene(scene, append=scene, blend=0.2)
    assert twice.clips[0].end == pytest.approx(2 * end - start - 0.2) and joined.clips[0].closing is None
    loop, closed = ori.clip_scene(scene, loop=True)
    shoulder = channel(loop, "shoulder").values
    assert np.allclose(shoulder[0], shoulder[-1]) or np.allclose(shoulder[0], -shoulder[-1])
    assert closed.clips[0].closing == "bent" and closed.clips[0].rotation_change.joint == "shoulder"
    with pytest.raises(ori.ArgumentError, match="root: found 'hip', wanted the name of a joint"):
        ori.clip_scene(scene, loop=True, root="hip")
    with pytest.raises(TypeError, match="root: found 1, wanted a name"):
        ori.clip_scene(scene, loop=True, root=1)
    with pytest.raises(TypeError, match="append: found str, wanted a Scene"):
        ori.clip_scene(scene, append="more.bvh")


def shown(path):
    return data_of(path.read_text("utf-8"))


def test_the_page_of_a_scene_is_that_of_inspect(arm, tmp_path):
    arm.report(tmp_path / "mine.html")
    run("inspect", tmp_path / "arm.bvh", "--report", tmp_path / "by_command.html")
    mine, other = shown(tmp_path / "mine.html"), shown(tmp_path / "by_command.html")
    assert mine["title"] == "arm.bvh: 3 joints, 1 clip"
    assert mine["skeleton"] == other["skeleton"] and mine["skeleton"]["after"] == "" and mine["notes"] == other["notes"]
    arm.clips[0].report(tmp_path / "clip.html")
    assert shown(tmp_path / "clip.html")["skeleton"] == mine["skeleton"], "it is the only clip"
    small, reduction = ori.reduce_scene(arm, "1deg")
    reduction.report(tmp_path / "reduced.html")
    assert shown(tmp_path / "reduced.html")["skeleton"]["after"] == "reduced"
    small.report(tmp_path / "small.html")
    kept = [len(one) for one in small.clips[0].channels if one.property == "rotation"]
    shown_keys = [joint["keys"] for joint in shown(tmp_path / "small.html")["skeleton"]["clips"][0]["joints"]]
    assert shown_keys == [[keys, 0] for keys in [*kept, 0]]
    with pytest.raises(ori.AccessError, match="none"):
        arm.report(tmp_path / "none" / "page.html")


def test_the_page_of_a_clip_has_no_other(tmp_path):
    nodes = [{"name": "bone"}]
    scene = ori.read_scene(gltf(tmp_path / "two.gltf", nodes, [animation(), animation()]))
    scene.clips[1].report(tmp_path / "second.html")
    scene.report(tmp_path / "both.html")
    one, both = (shown(tmp_path / name)["skeleton"]["clips"] for name in ("second.html", "both.html"))
    assert (len(one), len(both)) == (1, 2) and one[0]["joints"] == both[1]["joints"]


def test_what_is_wrong_is_named(arm, tmp_path):
    with pytest.raises(ori.ArgumentError, match="wanted one of tolerance, position_tolerance, world_tolerance"):
        ori.reduce_scene(arm)
    for tolerance in (0, -1, math.nan, "0deg"):
        with pytest.raises(ori.ArgumentError, match="tolerance"):
            ori.reduce_scene(arm, tolerance)
    with pytest.raises(ori.ArgumentError, match="shell"):
        ori.shell_distance(arm, arm, shell=0)
    with pytest.raises(ori.ArgumentError, match="closed"):
        ori.reduce_scene(arm, "1deg", method="slerp", closed=True)
    with pytest.raises(TypeError, match="scene: found str, wanted a Scene"):
        ori.reduce_scene("arm.bvh", "1deg")
    with pytest.raises(ori.AccessError):
        ori.read_scene(tmp_path / "absent.glb")
    with pytest.raises(ori.ArgumentError):
        ori.read_scene(tmp_path / "absent.txt")
    torn = tmp_path / "torn.glb"
    torn.write_bytes(b"glTF\2\0\0\0")
    with pytest.raises(ori.DataError, match="torn.glb"):
        ori.read_scene(torn)
    with pytest.raises(TypeError):
        ori.Scene()
