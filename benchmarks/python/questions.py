# SPDX-License-Identifier: Apache-2.0
"""What is measured: the same job for orispline and for SciPy, on the same keys, with the results compared before."""
import dataclasses
import warnings
from collections.abc import Callable

import numpy as np
import orispline as ori
from scipy.spatial.transform import Rotation, RotationSpline, Slerp

SIZES = {"full": (1_000_000, 5, 1000), "quick": (100_000, 3, 100), "smoke": (100, 1, 2)}  # samples, rounds, calls of what is short
LARGEST_KEY_ERROR = 1e-10  # [rad]
LARGEST_DIFFERENCE = (1e-9, 1e-9, 1e-8)  # between the two rotation splines [rad], [rad/s], [rad/s²]


@dataclasses.dataclass
class Question:
    """One row: a job, its two contenders with the number of calls of each, and how many times as fast ours is wanted."""

    title: str
    wanted: float
    ours: Callable[[], object]
    theirs: Callable[[], object]
    calls: tuple[int, int] = (1, 1)


def keys_of(count: int) -> tuple[np.ndarray, Rotation]:
    """From 0 s on, steps of 0.5 to 1.5 s and of 0.4 rad about each axis (σ): SciPy's iteration ends before its goal where turns are much wider."""
    dice = np.random.default_rng(42)
    steps = Rotation.from_rotvec(dice.normal(scale=0.4, size=(count, 3)))
    orientations = [Rotation.identity()]
    for step in steps[1:]:
        orientations.append(orientations[-1] * step)
    times = np.concatenate([[0.0], np.cumsum(dice.uniform(0.5, 1.5, count - 1))])
    return times, Rotation.concatenate(orientations)


class Track:
    """Keys, the curves through them, and times to ask for. A contender that is wrong is not timed."""

    def __init__(self, count: int, samples: int) -> None:
        self.count = count
        self.times, self.rotations = keys_of(count)
        self.curves = {method: ori.Curve(self.times, self.rotations, method) for method in ("auto", "rotation-spline", "slerp")}
        self.spline, self.slerp = RotationSpline(self.times, self.rotations), Slerp(self.times, self.rotations)
        span = self.times[[0, -1]]
        self.even = np.linspace(*span, samples)
        self.no_order = np.random.default_rng(7).uniform(*span, samples)
        self.rising = np.sort(self.no_order)
        self._compare()

    def _compare(self) -> None:
        for name, curve in (*self.curves.items(), ("RotationSpline", self.spline), ("Slerp", self.slerp)):
            found = curve.rotation(self.times) if isinstance(curve, ori.Curve) else curve(self.times)
            _hold(f"{name} of {self.count} keys at its keys", (found.inv() * self.rotations).magnitude(), LARGEST_KEY_ERROR)
        ours = self.curves["rotation-spline"]
        for t in (self.rising[::997], self.no_order[::997], self.even[::997]):
            rates = [ours.angular_velocity(t) - self.spline(t, 1), ours.angular_acceleration(t) - self.spline(t, 2)]
            apart = [(ours.rotation(t).inv() * self.spline(t)).magnitude(), *rates]
            for difference, largest in zip(apart, LARGEST_DIFFERENCE):
                _hold(f"rotation-spline of {self.count} keys beside RotationSpline", difference, largest)
            turn = self.curves["slerp"].rotation(t).inv() * self.slerp(t)
            _hold(f"slerp of {self.count} keys beside Slerp", turn.magnitude(), LARGEST_DIFFERENCE[0])


def _hold(what: str, differences: np.ndarray, largest: float) -> None:
    found = np.abs(differences).max()
    if not found <= largest:
        raise SystemExit(f"benchmarks: {what} is off by {found:.3g}, wanted at most {largest:.3g}: not timed")


def sampling(track: Track, wanted: dict[str, float]) -> list[Question]:
    """Orientations at many times."""
    many, thousands = len(track.even), f"{track.count} keys"
    spline = track.spline
    rows = []
    for method in ("auto", "rotation-spline"):
        curve = track.curves[method]
        rows.append(Question(f"`curve(t)`, rising times, {thousands}, `{method}`", wanted["rising"],
                             lambda curve=curve: curve(track.rising), lambda: spline(track.rising).as_quat()))
        rows.append(Question(f"`sample`, even times, {thousands}, `{method}`", wanted["even"],
                             lambda curve=curve: curve.sample(count=many), lambda: spline(track.even).as_quat()))
    slerp = track.curves["slerp"]
    rows.append(Question(f"`curve(t)`, rising times, {thousands}, `slerp`", wanted["slerp"], lambda: slerp(track.rising),
                         lambda: track.slerp(track.rising).as_quat()))
    return rows


def single(track: Track, calls: int) -> list[Question]:
    """What is asked of a track of a thousand keys only."""
    curve, spline, many, t = track.curves["auto"], track.spline, len(track.even), float(track.rising[0])
    few, q = np.linspace(*track.times[[0, -1]], 1000), curve(t)
    twin = ori.RotationSpline(track.times, track.rotations)
    return [
        Question("q, ω and α, even times, 1000 keys, `auto`", 90, lambda: curve.sample(count=many, derivatives=2),
                 lambda: (spline(track.even).as_quat(), spline(track.even, 1), spline(track.even, 2))),
        Question("`curve(t)`, times in no order, 1000 keys, `auto`", 12, lambda: curve(track.no_order),
                 lambda: spline(track.no_order).as_quat()),
        Question("`RotationSpline` of ours, one time as a `Rotation`, 1000 keys", 3, lambda: twin(t), lambda: spline(t), (5 * calls, calls)),
        Question("… beside SciPy's making of that `Rotation` alone", 1 / 1.5, lambda: twin(t), lambda: Rotation.from_quat(q), (5 * calls, 5 * calls)),
        Question("`as_matrix(t)`, 1000 times, 1000 keys, `rotation-spline`", 15, lambda: track.curves["rotation-spline"].as_matrix(few),
                 lambda: spline(few).as_matrix(), (calls, max(1, calls // 5))),
        Question("`curve(t)`, one time, 1000 keys, `auto`", 50, lambda: curve(t), lambda: spline(t).as_quat(), (20 * calls, calls)),
    ]


def grids(track: Track) -> list[Question]:
    """Even times from a first one that has all digits, as NumPy's random numbers do."""
    many, times, spline = len(track.even), track.times + 0.8371612345678912, track.spline
    curve = ori.Curve(times, track.rotations, "rotation-spline")
    rate = max(1, round(many / (times[-1] - times[0])))
    return [
        Question(f"`sample(rate={rate})` from 0.83716… s, {track.count} keys, `rotation-spline`", 75, lambda: curve.sample(rate=rate),
                 lambda: spline(track.even).as_quat()),
        Question(f"`sample(count={many})` from 0.83716… s, {track.count} keys, `rotation-spline`", 75, lambda: curve.sample(count=many),
                 lambda: spline(track.even).as_quat()),
    ]


def sparse(count: int, calls: int) -> list[Question]:
    """A thousand times on as many keys or more: one a segment, or fewer."""
    times, rotations = keys_of(count)
    few = np.sort(np.random.default_rng(8).uniform(*times[[0, -1]], 1000))
    shuffled = np.random.default_rng(9).permutation(few)
    curve, theirs = ori.Curve(times, rotations, "slerp"), Slerp(times, rotations)
    _hold(f"slerp of {count} keys beside Slerp", (curve.rotation(few).inv() * theirs(few)).magnitude(), LARGEST_DIFFERENCE[0])
    return [Question(f"`curve(t)`, 1000 {order} times, {count} keys, `slerp`", 10, lambda t=t: curve(t), lambda t=t: theirs(t).as_quat(),
                     (calls, max(1, calls // 5))) for order, t in (("rising", few), ("shuffled", shuffled))]


def making(count: int, wanted: dict[str, float], calls: int) -> list[Question]:
    """Curves from times and a Rotation, against a RotationSpline."""
    times, rotations = keys_of(count)
    calls = max(1, calls // count)
    return [Question(f"making `{method}`, {count} keys", ratio, lambda method=method: ori.Curve(times, rotations, method),
                     lambda: RotationSpline(times, rotations), (calls, max(1, calls // 5))) for method, ratio in wanted.items()]


def twins(count: int, calls: int) -> list[Question]:
    """The twins made, against what they are twins of."""
    times, rotations = keys_of(count)
    calls = max(1, calls // count)
    return [Question(f"making `{ours.__name__}` of ours, {count} keys", ratio, lambda ours=ours: ours(times, rotations),
                     lambda theirs=theirs: theirs(times, rotations), (calls, max(1, calls // 5)))
            for ours, theirs, ratio in ((ori.RotationSpline, RotationSpline, 10), (ori.Slerp, Slerp, 15))]


def means(calls: int) -> list[Question]:
    """Of a thousand rotations, near to each other and all over, beside SciPy's, which is the chordal one."""
    dice = np.random.default_rng(10)
    near, wide = (Rotation.from_rotvec(dice.normal(scale=scale, size=(1000, 3))) for scale in (0.05, 1.0))
    calls = max(1, calls // 20)
    turn = Rotation.from_quat(ori.mean(wide, kind="chordal").orientation).inv() * wide.mean()
    _hold("the chordal mean beside Rotation.mean", np.array([turn.magnitude()]), LARGEST_KEY_ERROR)
    return [Question(title, ratio, lambda rows=rows, kind=kind: quiet_mean(rows, kind), lambda rows=rows: rows.mean(), (calls, calls))
            for title, ratio, rows, kind in (("`mean` of 1000 near rotations", 0.05, near, "mean"), ("`mean` of 1000 wide ones", 0.01, wide, "mean"),
                                             ("… `kind=\"chordal\"`", 1, wide, "chordal"))]


def quiet_mean(rows: Rotation, kind: str) -> ori.Mean:
    """Without the warning that it may not be the only one."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return ori.mean(rows, kind=kind)


def questions(sizes: str) -> tuple[list[Question], int]:
    """All rows, and the rounds in which they are measured."""
    samples, rounds, calls = SIZES[sizes]
    short, long = Track(1000, samples), Track(1000 if sizes == "smoke" else 10_000, samples)
    rows = [*sampling(short, {"rising": 80, "even": 110, "slerp": 55}), *sampling(long, {"rising": 60, "even": 75, "slerp": 35}),
            *grids(short), *sparse(1000, calls), *([] if sizes == "smoke" else [*sparse(10_000, calls), *sparse(100_000, calls)]),
            *single(short, calls), *making(10, {"rotation-spline": 20}, calls * 5),
            *making(1000, {"auto": 11, "timed-c2": 100, "rotation-spline": 3}, calls * 5), *twins(1000, calls * 5), *means(calls)]
    if sizes != "smoke":
        rows += making(10_000, {"rotation-spline": 3}, calls)
    return rows, rounds
