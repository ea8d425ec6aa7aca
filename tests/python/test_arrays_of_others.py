# SPDX-License-Identifier: Apache-2.0
"""Arrays of other libraries: they come in as they are, and results are of the library and on the device of the times."""
import pickle
import sys
import types

import numpy as np
import orispline as ori
import pytest

TIMES = [0.0, 1.0, 2.0, 3.5]
ROTATIONS = np.array([[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0], [0, 0.6, 0.8, 0]])
CURVE = ori.Curve(TIMES, ROTATIONS, "timed-c2", positions=np.eye(4)[:, :3])
FIRST = ori.Curve(TIMES, ROTATIONS[:, [3, 0, 1, 2]], "timed-c2", scalar_first=True)
STACK = ori.CurveStack(TIMES, ROTATIONS[:, None], "timed-c2", scalar_first=True)
BAKED = CURVE.bake(1e-9)
ONLINE = ori.OnlineCurve("timed-c2", scalar_first=True)
for key in zip(TIMES, ROTATIONS[:, [3, 0, 1, 2]]):
    ONLINE.append(*key)
ONLINE.finish()
FUNCTIONS = {
    "curve": CURVE, "scalar first": FIRST, "rate": CURVE.angular_velocity, "acceleration": CURVE.angular_acceleration,
    "jerk": CURVE.angular_jerk, "world": lambda t: CURVE.angular_velocity(t, "world"), "position": CURVE.position,
    "velocity": CURVE.velocity, "linear acceleration": CURVE.acceleration, "torque": lambda t: CURVE.torque(t, [1, 2, 2.5]),
    "angle travelled": CURVE.angle_travelled, "time at angle": CURVE.time_at_angle, "at angle": CURVE.at_angle, "derivative": CURVE.derivative(2),
    "matrix": CURVE.as_matrix, "rotation vector": CURVE.as_rotvec, "Euler": lambda t: CURVE.as_euler(t, "ZYX"),
    "stack": STACK, "stack's rate": STACK.angular_velocity, "baked": BAKED, "baked, scalar first": FIRST.bake(1e-9), "baked rate": BAKED.angular_velocity,
    "online": ONLINE, "composed": CURVE.inv(), "angle between": lambda t: ori.angle_between(CURVE, FIRST, t),
    "twin's rate": lambda t: ori.RotationSpline(TIMES, CURVE.rotation(TIMES))(t, 1),
}


def strict(values, dtype="float64"):
    xp = pytest.importorskip("array_api_strict")
    return xp.asarray(values, dtype=getattr(xp, dtype))


def on_another_device(values, dtype="float64"):
    xp = pytest.importorskip("array_api_strict")
    return xp.asarray(values, dtype=getattr(xp, dtype), device=xp.Device("device1"))


def of_jax(values, dtype="float64"):
    return pytest.importorskip("jax.numpy").asarray(values, dtype="float32")  # the widest that JAX has unless it is told


def of_torch(values, dtype="float64"):
    torch = pytest.importorskip("torch")
    return torch.tensor(values, dtype=getattr(torch, dtype))


LIBRARIES = pytest.mark.parametrize("made", [strict, on_another_device, of_jax, of_torch])


class Elsewhere:
    """An array on a device that nothing can be copied from."""

    device = "gpu:0"
    shape = (3,)

    def __array_namespace__(self):
        return sys.modules[__name__]

    def __dlpack__(self, **_):
        raise BufferError("not here")

    def __array__(self, *_, **__):
        raise TypeError("implicit copies are not allowed")


@LIBRARIES
@pytest.mark.parametrize("what", FUNCTIONS)
def test_functions_of_time_give_what_they_get(what, made):
    function, t = FUNCTIONS[what], made([0.5, 1.25, 3.0])
    found, wanted = function(t), np.asarray(function(np.array([0.5, 1.25, 3.0])))
    assert type(found) is type(t) and found.device == t.device and tuple(found.shape) == wanted.shape
    assert np.allclose(np.from_dlpack(found, device="cpu") if made is on_another_device else np.asarray(found), wanted,
                       atol=1e-5 if made is of_jax else 0, rtol=0)


@LIBRARIES
def test_any_shape_and_integers_too(made):
    assert tuple(CURVE(made([[0.5, 1.0], [2.0, 3.0]])).shape) == (2, 2, 4)
    assert tuple(CURVE(made(1.5)).shape) == (4,)


def test_float32_comes_out_where_it_is_asked_for():
    xp = pytest.importorskip("array_api_strict")
    t = strict([0.5, 1.5], "float32")
    assert CURVE(t).dtype == xp.float64
    for dtype in (xp.float32, np.float32, "float32"):
        assert CURVE(t, dtype=dtype).dtype == FIRST(t, dtype=dtype).dtype == STACK.angular_velocity(t, dtype=dtype).dtype == xp.float32
    assert CURVE(t, dtype=xp.float64).dtype == xp.float64 and CURVE.bake(1e-5, dtype=xp.float32)(t).dtype == xp.float32
    with pytest.raises(ori.ArgumentError, match="dtype: found int32, wanted float64 or float32"):
        CURVE(t, dtype=np.int32)
    with pytest.raises(TypeError, match="dtype: found array_api_strict.int32 of type"):
        CURVE(t, dtype=xp.int32)


@LIBRARIES
def test_keys_and_samples_take_them(made):
    keys = ori.Keys(made(TIMES), made(ROTATIONS.tolist()), positions=made(np.eye(4)[:, :3].tolist()))
    assert type(keys.rotations) is np.ndarray and np.allclose(keys.rotations, ROTATIONS, atol=1e-7)
    assert pickle.loads(pickle.dumps(keys)) == keys
    assert ori.Curve(made(TIMES), made(ROTATIONS.tolist()))(0.0).shape == (4,)
    samples = CURVE.sample(times=made([0.5, 1.5]))
    assert type(samples.times) is type(samples.orientations) is np.ndarray
    assert ori.mean(made(ROTATIONS[:2].tolist())).count == 2
    assert ori.CurveStack(made(TIMES), made(ROTATIONS[:, None].tolist()))(1.0).shape == (1, 4)


def test_what_stays_on_its_device_is_said_with_its_cure():
    for call in (CURVE, FIRST, STACK, BAKED, CURVE.as_matrix, CURVE.torque):
        with pytest.raises(ori.ArgumentError, match=r"^t: found an array of type Elsewhere on gpu:0 that cannot be copied to the host, wanted one "
                                                    r"there: t.detach\(\).cpu\(\) of PyTorch, t.get\(\) of CuPy, jax.device_get\(t\)$"):
            call(Elsewhere(), *([[1, 1, 1]] if call == CURVE.torque else []))
    with pytest.raises(ori.ArgumentError, match="^times: found an array of type Elsewhere"):
        ori.Keys(Elsewhere(), ROTATIONS)
    with pytest.raises(ori.ArgumentError, match="^rotations: found an array of type Elsewhere"):
        ori.Keys(TIMES, Elsewhere())


class Tensor:
    """As PyTorch has it: no array API, but DLPack, a device and a function of the module that makes one."""

    def __init__(self, array, device="cpu"):
        self.array, self.device = np.asarray(array), device
        self.shape = self.array.shape

    def __dlpack__(self, **options):
        return self.array.__dlpack__(**options)

    def __dlpack_device__(self):
        return self.array.__dlpack_device__()


def test_a_tensor_goes_in_and_a_tensor_comes_out(monkeypatch):
    monkeypatch.setitem(sys.modules, "torch", types.SimpleNamespace(Tensor=Tensor, asarray=Tensor, float32="torch.float32"))
    t = Tensor([0.5, 1.5])
    found = CURVE(t)
    assert type(found) is Tensor and np.array_equal(found.array, CURVE(t.array))
    assert CURVE.angular_velocity(t, dtype="torch.float32").array.dtype == np.float32


def test_a_tensor_that_wants_a_gradient_is_refused():
    torch = pytest.importorskip("torch")
    with pytest.raises(ori.ArgumentError, match="wanted one there: t.detach"):
        CURVE(torch.tensor([0.5], requires_grad=True))


def test_arrays_of_numpy_stay_plain():
    t = np.array([0.5, 1.5])
    assert type(CURVE(t)) is type(CURVE([0.5, 1.5])) is type(CURVE(0.5)) is type(CURVE(np.float32(0.5))) is np.ndarray
    assert isinstance(CURVE.angle_travelled(0.5), float)
