# SPDX-License-Identifier: Apache-2.0
"""Bad input of tasks has one line that says what was found and what was wanted."""
import numpy as np
import orispline as ori
import pytest

KEYS = ori.Keys([0, 1, 3, 4], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0.6, 0.8, 0], [0, 1, 0, 0]])
ONE = KEYS[:1]
MANY = ori.Keys(np.arange(20) / 20, [[0, 0, np.sin(x / 20), np.cos(x / 20)] for x in range(20)])
OTHER = ori.Keys(np.arange(20) / 20, [[np.sin(x * x / 20), 0, 0, np.cos(x * x / 20)] for x in range(20)])
ARGUMENTS = [
    (lambda: ori.smooth(KEYS, nois=1), "unknown option 'nois'; did you mean 'noise'?"),
    (lambda: ori.smooth(KEYS, speed=1), "unknown option 'speed', wanted one of penalty, noise"),
    (lambda: ori.smooth(KEYS, noise=True), "noise: found True, wanted a number [rad]"),
    (lambda: ori.smooth(KEYS, noise=[1, 2]), "noise: found [1.0, 2.0], wanted a number [rad]"),
    (lambda: ori.smooth(KEYS, noise="0.5"), "noise: found '0.5', wanted a number greater than 0 with its unit"),
    (lambda: ori.smooth(KEYS, noise="0.5Hz"), "noise: found '0.5Hz'"),
    (lambda: ori.smooth(KEYS, noise=-1), "noise: found -1 rad, wanted 1e-07 to 0.5 rad"),
    (lambda: ori.smooth(KEYS, noise=np.nan), "noise: found nan rad"),
    (lambda: ori.smooth(KEYS, noise=1j), "noise: found an array of complex128"),
    (lambda: ori.smooth(KEYS, progress=print), "unknown option 'progress', wanted one of penalty, noise"),
    (lambda: ori.smooth(KEYS, rates=([0], [[0, 0, 1]])), "unknown option 'rates', wanted one of penalty, noise"),
    (lambda: ori.reduce(KEYS, 0.1, progress=True), "unknown option 'progress', wanted one of tolerance"),
    (lambda: ori.smooth(KEYS, noise={}), "noise: found an array of object"),
    (lambda: ori.smooth(KEYS, penalty="acc"), "penalty: found 'acc', wanted acceleration|jerk"),
    (lambda: ori.smooth(KEYS, penalty=2), "penalty: found 2, wanted acceleration or jerk"),
    (lambda: ori.smooth(KEYS, gyro="yes"), "gyro: found 'yes', wanted true or false"),
    (lambda: ori.smooth(KEYS, gyro=1), "gyro: found 1, wanted true or false"),
    (lambda: ori.smooth(KEYS, gyro=ori.Rates([0, 1, 2], np.zeros((3, 3))), gyro_offset=np.nan), "gyro_offset: found nan s, wanted a finite number"),
    (lambda: ori.smooth(KEYS, noise=0.1, smoothing_time=1), "smoothing_time"),
    (lambda: ori.smooth(KEYS, cutoff="8"), "cutoff: found '8', wanted a number greater than 0, or a text with its unit such as '8Hz'"),
    (lambda: ori.smooth(KEYS, cutoff=-1), "cutoff: found -1, wanted a number greater than 0"),
    (lambda: ori.smooth(KEYS, cutoff=np.nan), "cutoff: found nan"),
    (lambda: ori.smooth(KEYS, cutoff=1, noise=0.1), "cutoff: found it beside noise, wanted one of them"),
    (lambda: ori.reduce(KEYS, 0.1, cutoff=1, smoothing_time=1), "cutoff: found it beside smoothing_time"),
    (lambda: ori.reduce(KEYS, "1"), "tolerance: found '1', wanted"),
    (lambda: ori.reduce(KEYS, 0), "tolerance: found 0 rad, wanted 1e-12 rad at least"),
    (lambda: ori.reduce(KEYS, None), "tolerance"),
    (lambda: ori.reduce(KEYS, 0.1, method="slurp"), "did you mean 'slerp'?"),
    (lambda: ori.reduce(KEYS, 0.1, method=[]), "method: found none"),
    (lambda: ori.reduce(KEYS, 0.1, method="global-c2"), "global-c2"),
    (lambda: ori.reduce(KEYS, 0.1, values="fit"), "values: found 'fit', wanted sampled|refit"),
    (lambda: ori.reduce(KEYS, 0.1, threads=-1), "threads: found -1"),
    (lambda: ori.reduce(KEYS, 0.1, threads=1.5), "threads: found 1.5"),
    (lambda: ori.retime(KEYS), "wanted"),
    (lambda: ori.retime(KEYS, max_rate=(1, 2)), "max_rate: found [1.0, 2.0], wanted a number or three [rad/s]"),
    (lambda: ori.retime(KEYS, max_rate=0), "max_rate: found 0 rad/s, wanted more than 0 rad/s"),
    (lambda: ori.retime(KEYS, max_rate=np.inf), "max_rate: found inf"),
    (lambda: ori.retime(KEYS, max_rte=1), "did you mean 'max_rate'?"),
    (lambda: ori.retime(KEYS, max_torque=1), "inertia"),
    (lambda: ori.retime(KEYS, max_torque=1, inertia=np.array([[1, 2, 0], [0, 1, 0], [0, 0, 1]])), "not symmetric"),
    (lambda: ori.retime(KEYS, max_torque=1, inertia=[1, 2]), "inertia: found [1.0, 2.0], wanted three principal moments"),
    (lambda: ori.retime(KEYS, max_rate=1, per_interval=True, slowing="uniform"), "slowing: found 'uniform'"),
    (lambda: ori.tune(KEYS, "slerp"), "slerp"),
    (lambda: ori.tune(KEYS, "quintic", objective="jerks"), "objective: found 'jerks', wanted linearised|acceleration"),
    (lambda: ori.tune(KEYS, "quintic", objective="fit"), "reference"),
    (lambda: ori.tune(KEYS, "quintic", bounds=[1, 2, 3]), "bounds: found [1.0, 2.0, 3.0], wanted two numbers"),
    (lambda: ori.tune(KEYS, "quintic", free="tensoin"), "free: found 'tensoin'"),
    (lambda: ori.compare(KEYS, "auot"), "did you mean 'auto'?"),
    (lambda: ori.compare(KEYS, []), "methods: found []"),
    (lambda: ori.compare(KEYS, ["auto", "auto"]), "none twice"),
    (lambda: ori.compare(KEYS, "auto", keep_every=0), "keep_every: found 0, wanted 1 or more"),
    (lambda: ori.compare(KEYS, "auto", keep_every=[2, 2]), "keep_every: found [2, 2]"),
    (lambda: ori.compare(KEYS, "auto", keep_every=1.5), "keep_every: found 1.5, wanted a whole number from 1 on"),
    (lambda: ori.compare(KEYS, "auto", random=-1), "seed: found -1"),
    (lambda: ori.compare(KEYS, "auto", sort="rsm", keep_every=2), "sort: unknown measure 'rsm'; did you mean 'rms'?"),
    (lambda: ori.compare(KEYS, "auto", sort="torque", keep_every=2), "sort: found 'torque', wanted `inertia` as well"),
    (lambda: ori.compare(KEYS, "auto", sort="rate", keep_every=2), "sort: found 'rate', wanted angular velocities"),
    (lambda: ori.compare(KEYS, "auto", reference=KEYS, jitter=True), "found reference and jitter or random"),
    (lambda: ori.align(MANY, MANY, ofset=1), "unknown option 'ofset'; did you mean 'offset'?"),
    (lambda: ori.align(MANY, MANY, offset="soon"), "offset: found 'soon', wanted a number"),
    (lambda: ori.align(MANY, MANY, offset=np.nan), "offset: found nan"),
    (lambda: ori.align(MANY, MANY, offset=100), "offset: found recordings from 0 to 0.95 s and from 0 to 0.95 s, of which fewer than 8 samples"),
    (lambda: ori.align(MANY, MANY, scale=1), "scale: found 1, wanted true or false"),
    (lambda: ori.compare(MANY, "auto", align=True, keep_every=2), "align: found no recording to align the keys with"),
    (lambda: ori.compare(KEYS, "auto", inertia=[-1, 1, 1], keep_every=2), "inertia"),
]
DATA = [
    (lambda: ori.smooth(KEYS[:2]), "2"),
    (lambda: ori.smooth(KEYS, gyro=True), "angular velocit"),
    (lambda: ori.reduce(ONE, 0.1), "2"),
    (lambda: ori.reduce(KEYS, 0.1, position_tolerance="1mm"), "position_tolerance: found no positions, wanted some"),
    (lambda: ori.retime(ONE, max_rate=1), "key"),
    (lambda: ori.tune(KEYS[:2], "quintic"), "3"),
    (lambda: ori.align(KEYS, MANY), "found 4 orientations, wanted 8 at least"),
    (lambda: ori.align(MANY, KEYS), "found 4 orientations, wanted 8 at least"),
    (lambda: ori.align(MANY, OTHER), "wanted two recordings of one motion"),
    (lambda: ori.compare(KEYS, "auto"), "`keep_every` 8 leaves 1 of the 4 samples"),
    (lambda: ori.compare(ONE, "auto"), "found 1 key, wanted 2 at least to compare curves"),
    (lambda: ori.compare(KEYS, "auto", reference=ori.Keys(KEYS.times + 50, KEYS.rotations)),
     "none of the 4 times, 50 to 54 s, lies between the keys, 0 to 4 s"),
]
TYPES = [
    (lambda: ori.smooth([0, 1]), "keys: found list, wanted Keys"),
    (lambda: ori.reduce(None, 0.1), "keys: found NoneType, wanted Keys"),
    (lambda: ori.reduce_tracks([KEYS, 1], 0.1), "tracks[1]: found int, wanted Keys"),
    (lambda: ori.retime(KEYS, max_rate=1, method=3), "method: found int, wanted a name"),
    (lambda: ori.tune(KEYS, "quintic", reference=[1]), "reference: found list, wanted Keys"),
    (lambda: ori.align(3, KEYS), "a: found int, wanted Keys"),
    (lambda: ori.align(MANY, [KEYS]), "b: found list, wanted Keys"),
    (lambda: ori.compare(MANY, "auto", reference=MANY, align=1), "align: found 1 of type int, wanted True or False"),
    (lambda: ori.compare(KEYS, [1]), "method: found int"),
    (lambda: ori.compare(KEYS, "auto", sort=1), "sort: found int, wanted a word"),
]


@pytest.mark.parametrize("error, work, text", [(ori.ArgumentError, *case) for case in ARGUMENTS]
                         + [(ori.DataError, *case) for case in DATA] + [(TypeError, *case) for case in TYPES],
                         ids=[case[1] for case in ARGUMENTS + DATA + TYPES])
def test_bad_input_has_one_line(error, work, text):
    with pytest.raises(error) as caught:
        work()
    assert text in str(caught.value)
    assert "\n" not in str(caught.value)


def test_the_argument_at_fault_is_named():
    with pytest.raises(ori.ArgumentError) as caught:
        ori.smooth(KEYS, noise="fast")
    assert caught.value.argument == "noise"
