# SPDX-License-Identifier: Apache-2.0
"""Tasks: recordings and keys in, better keys out."""
from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Sequence
from typing import Any, overload

import numpy as np

from . import _core
from ._arrays import array_of
from ._checks import flag, wrong_type
from ._clock import SecondsSince
from ._errors import ArgumentError, DataError
from ._keys import Keys
from ._methods import method_words
from ._options import checked_cutoff, checked_keys, checked_threads, of_keys, plain, reference_of, takes
from ._rate_alignment import RateAlignment, aligned_by_rates
from ._rates import Rates
from ._request import Request
from ._results import Alignment, Reduction, Retiming, Smoothing, Tuning

Pair = tuple[Any, Any]  # times, and rotations or rates
SMOOTHNESS = ("noise", "smoothing_time", "position_noise")  # options of smoothing that reducing takes too


@of_keys
@takes("SmoothOptions")
def smooth(keys: Keys, /, *, gyro: bool | Rates | tuple[Any, Any] = False, cutoff: float | str | None = None, **options: Any) -> Smoothing:
    """A noisy recording as a smooth motion with rates.

    Numbers are in the units that stand here, texts have their unit: `noise=0.01` and `noise="0.57deg"`.

    Parameters
    ----------
    keys : Keys, or times and rotations
        The recording, or what `Curve` makes keys of: `smooth(times, rotations, normalize=True)`. With `gyro=True` its angular velocities
        are those of a gyro; with `gyro=(times, rates)`, `gyro=Rates(...)` or `gyro=read_rates(path)` the gyro has times of its own, at
        which the result has keys too.
    cutoff : float or str, optional
        Cut-off frequency 1/(2πτ) [Hz] in the place of the smoothing time τ: half of a motion at this frequency is left.
    {options}

    Returns
    -------
    Smoothing
        `.keys` are the smooth motion at the times of the recording, `.curve` is the curve through them.

    Raises
    ------
    ArgumentError
        An option that there is not, out of its range, or that contradicts another.
    DataError
        Too few samples, or samples that no smooth motion is near to.
    ConvergenceError
        No smooth motion was found.

    Warns
    -----
    ShapeWarning
        Hardly any noise, many outliers and the like.

    Examples
    --------
    >>> import numpy as np, orispline as ori
    >>> t = np.linspace(0, 2, 201)
    >>> noise = np.random.default_rng(1).normal(size=(201, 3)) * 0.005
    >>> half = 0.5 * np.sin(t)
    >>> q = np.column_stack([noise, np.cos(half)]) + np.outer(np.sin(half), [0, 0, 1, 0])
    >>> smoothing = ori.smooth(t, q, normalize=True)
    >>> bool(0.005 < smoothing.noise < 0.015)
    True
    >>> smoothing.curve.angular_velocity(1.0).shape
    (3,)
    """
    inputs: dict[str, Any] = {"recording": keys}
    if isinstance(gyro, tuple) and len(gyro) == 2:
        gyro = Rates(*gyro)
    if isinstance(gyro, Rates):
        inputs["gyro"], gyro = _finite_rates(keys, gyro), True
    elif gyro is not None and not np.isscalar(gyro):
        raise wrong_type("gyro", gyro, "True, False, Rates, or a pair of times and rates")
    settings = checked_cutoff(cutoff, options)
    return Smoothing._found(Request("smooth", inputs, plain({**options, "gyro": gyro}), settings), keys)


def _finite_rates(keys: Keys, gyro: Rates) -> tuple[Any, ...]:
    """Times [s] since those of the keys, and rates, of the rows that are whole; and what these times count from."""
    if isinstance(gyro.times, SecondsSince):
        seconds = np.asarray(gyro.times) + float(gyro.epoch - keys.epoch)
    else:
        seconds = keys._clock.seconds("gyro", gyro.times)
    whole = np.isfinite(seconds) & np.isfinite(gyro.rates).all(axis=1)
    seconds, rates = np.ascontiguousarray(seconds[whole], dtype=np.float64), np.ascontiguousarray(gyro.rates[whole], dtype=np.float64)
    if len(unordered := np.flatnonzero(np.diff(seconds) <= 0)):
        raise DataError(f"gyro: time {unordered[0] + 1} does not come after the one before it, wanted strictly increasing times")
    return seconds, rates, _core.epoch_of_keys(keys._core), False


def _reduced(tracks: Sequence[Keys], tolerance: Any, method: Any, smooth: bool, cutoff: Any, threads: int,
             options: dict[str, Any]) -> list[Reduction]:
    smoothing = {name: options.pop(name, None) for name in SMOOTHNESS}
    settings = {"smooth": flag("smooth", smooth), **plain(smoothing), **checked_cutoff(cutoff, smoothing)}
    several = method if isinstance(method, (list, tuple)) else [] if method is None else [method]
    methods = [method_words(one) for one in several]
    if method is not None and not methods:
        raise ArgumentError("method: found none, wanted one at least")
    stated = plain({"tolerance": tolerance, **options})
    request = Request("reduce", {"recording": list(tracks)}, stated, {**settings, "threads": checked_threads(threads)}, methods=methods)
    return [Reduction._of(core, keys, dataclasses.replace(request, inputs={"recording": keys}))
            for core, keys in zip(request.told(), tracks)]


@of_keys
@takes("ReduceOptions", also={"SmoothOptions": SMOOTHNESS})
def reduce(keys: Keys, /, tolerance: Any, *, method: Any = None, smooth: bool = False, cutoff: float | str | None = None,
           threads: int = 0, **options: Any) -> Reduction:
    """The fewest keys whose curve is within a tolerance of every sample of a recording.

    Parameters
    ----------
    keys : Keys
        The recording.
    method : str, Blending, Curve or a list of them, optional
        The method of the curve, in its text form: a local one through its keys. Of several the one with the fewest
        keys is taken. Without it `auto`, `timed-c2` and `slerp` are tried.
    smooth : bool
        Smooth the recording first, as `orispline.smooth` does, whose options `noise`, `smoothing_time`, `cutoff` and
        `position_noise` imply it. The tolerance is then about the smooth motion.
    cutoff : float or str, optional
        As of `orispline.smooth`.
    threads : int
        At most so many at work, 0 means one for each core. The result is the same on any.
    {options}

    Returns
    -------
    Reduction
        `.keys` are the keys that are kept, `.curve` is the curve through them.

    Raises
    ------
    ArgumentError
        An option or a method that there is not or that does not suit.
    DataError
        Fewer than two samples, or a position tolerance for a recording without positions.
    ConvergenceError
        No smooth motion was found.

    Warns
    -----
    ShapeWarning
        Positions without a tolerance, and what `orispline.smooth` warns of.

    Examples
    --------
    >>> import numpy as np, orispline as ori
    >>> half = np.linspace(0, 1, 101)
    >>> q = np.outer(np.sin(half), [0, 0, 1, 0]) + np.outer(np.cos(half), [0, 0, 0, 1])
    >>> reduction = ori.reduce(ori.Keys(half, q), "0.1deg", method="slerp")
    >>> len(reduction.keys), bool(reduction.error_max < np.radians(0.1))
    (2, True)
    """
    return _reduced([keys], tolerance, method, smooth, cutoff, threads, options)[0]


@takes("ReduceOptions", also={"SmoothOptions": SMOOTHNESS})
def reduce_tracks(tracks: Iterable[Keys | tuple[Any, Any]], tolerance: Any, *, method: Any = None, smooth: bool = False,
                  cutoff: float | str | None = None, threads: int = 0, **options: Any) -> list[Reduction]:
    """`reduce` for many recordings at once, in their order.

    Parameters
    ----------
    tracks : iterable of Keys or (t, q)
        The recordings.
    method, smooth, cutoff, threads
        As of `reduce`. The threads share the recordings.
    {options}

    Raises
    ------
    ArgumentError, DataError
        As of `reduce`, for the first recording that fails; its index is in the text, after `curve`.

    Examples
    --------
    >>> import orispline as ori
    >>> keys = ori.Keys([0, 1, 2], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 0.96, 0.28]])
    >>> [len(one.keys) for one in ori.reduce_tracks([keys, keys[:2]], "1deg")]
    [2, 2]
    """
    if not isinstance(tracks, Iterable):
        raise wrong_type("tracks", tracks, "Keys, one after the other")
    listed = [checked_keys(keys, f"tracks[{i}]") for i, keys in enumerate(tracks)]
    return _reduced(listed, tolerance, method, smooth, cutoff, threads, options) if listed else []


@of_keys
@takes("RetimeOptions")
def retime(keys: Keys, /, *, method: Any = None, per_interval: bool = False, fastest_keys: bool = False, **options: Any) -> Retiming:
    """The least slowing with which the curve stays within limits everywhere, certified by bounds.

    Limits are in the units that stand here, as one number for the length of the vector or three for its components;
    texts have their unit: `max_rate=1.5`, `max_rate="90deg/s"`, `max_rate=(1, 2, 1)`.

    Parameters
    ----------
    keys : Keys, or times and rotations
        Whose times are to change, as of `smooth`.
    method : str, Blending or Curve, optional
        The method of the curve, in its text form. Without it that of the keys' file, else `auto`, with the body at
        rest between equal keys.
    per_interval : bool
        Slow each interval between keys by itself; the same as `slowing="per-interval"`.
    fastest_keys : bool
        Let intervals get shorter too, so that the times that were typed do not matter; `slowing="fastest-keys"`.
    {options}

    Returns
    -------
    Retiming
        `.keys` are the keys at their new times, `.certificates` say what is known of each limited quantity.

    Raises
    ------
    ArgumentError
        Limits that are absent, not greater than 0 or cannot be met, or a method that cannot be slowed.
    DataError
        Fewer than two keys.

    Warns
    -----
    ShapeWarning
        Bounds that are loose, rests in which the body moves and the like.

    Examples
    --------
    >>> import orispline as ori
    >>> keys = ori.Keys([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
    >>> slow = ori.retime(keys, max_rate="45deg/s")
    >>> bool(slow.certificates["rate"].bound <= 0.7854), slow.time_scale > 1
    (True, True)
    """
    for name, given in (("per_interval", per_interval), ("fastest_keys", fastest_keys)):
        word = name.replace("_", "-")
        if not flag(name, given):
            continue
        if options.get("slowing", word) != word:
            raise ArgumentError(f"slowing: found {options['slowing']!r} with {name}=True, wanted one of them")
        options["slowing"] = word
    words = None if method is None else method_words(method)
    return Retiming._found(Request("retime", {"keys": keys}, plain(options), method=words), keys)


@of_keys
@takes("TuneOptions")
def tune(keys: Keys, /, method: Any, *, reference: Keys | tuple[Any, Any] | None = None, **options: Any) -> Tuning:
    """The tensions of a curve that make an integral over it least, such as that of the squared angular acceleration.

    Parameters
    ----------
    keys : Keys, or times and rotations
        What the curve goes through, as of `smooth`.
    method : str, Blending or Curve
        The method whose tensions to find, in its text form; they start from its settings.
    reference : Keys or (t, q), optional
        Dense recording that the curve comes near to, for the objective `"fit"`.
    {options}

    Returns
    -------
    Tuning
        `.curve` is the curve with the tensions that were found, `.parameters` are their values.

    Raises
    ------
    ArgumentError
        A method without tensions, options that contradict each other or that there are not.
    DataError
        Fewer than three keys, or a reference without a time between them.
    ConvergenceError
        No tensions were found that are better.

    Warns
    -----
    ShapeWarning
        Tensions that are not at rest, and the like.

    Examples
    --------
    >>> import orispline as ori
    >>> keys = ori.Keys([0, 1, 3, 4], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0.6, 0.8, 0], [0, 1, 0, 0]])
    >>> tuning = ori.tune(keys, "quintic", objective="jerk")
    >>> tuning.energy_after < tuning.energy_before, list(tuning.parameters)
    (True, ['tension'])
    """
    words = method_words(method)
    inputs = {"keys": keys, **reference_of(keys, reference)}
    return Tuning._found(Request("tune", inputs, plain(options), method=words), keys)


@overload
def align(a: Keys, b: Keys, **options: Any) -> Alignment: ...
@overload
def align(a: Rates, b: Keys | Rates | Pair, **options: Any) -> RateAlignment: ...
@overload
def align(a: Keys | Pair, b: Rates, **options: Any) -> RateAlignment: ...
@overload
def align(a: Keys | Pair, b: Keys | Pair, **options: Any) -> Any: ...
@takes("AlignOptions")
def align(a: Keys | Rates | Pair, b: Keys | Rates | Pair, **options: Any) -> Alignment | RateAlignment:
    """What brings a recording onto another one of the same motion: the constant rotations of the axes of world and body, the
    offset of the clocks, and where both have positions their scale and the place of the origin.

    R' = W R Bᵀ, p' = s W p + d, t' = t - offset. What is left out by an option is taken to be none. Up to a tenth of bad
    samples in either recording does no harm.

    Of a gyro and the orientations of the body that carries it, or of two gyros on one body, the rotation of the body, the offset and
    the bias: ω' = B (ω - bias).

    Parameters
    ----------
    a : Keys, Rates, (t, q) or (t, w)
        The recording that is moved. A pair with (n, 3) numbers is of rates.
    b : Keys, Rates, (t, q) or (t, w)
        The one that stays as it is. Either may have dates where the other has seconds.
    {options}

    Returns
    -------
    Alignment or RateAlignment
        `.world`, `.body`, `.offset`, `.scale`, `.translation` with their standard deviations, `.keys` are those of `a` beside `b`. With
        Rates `.body`, `.offset`, `.bias`, and `.aligned` is `a` beside `b`.

    Raises
    ------
    ArgumentError
        An option that there is not, or an offset with which the recordings do not overlap.
    DataError
        Fewer than eight samples, recordings that do not overlap, that no alignment brings near, or in which nothing turns.

    Warns
    -----
    ShapeWarning
        What the recordings cannot tell, as where all turns have one axis, and more between them than an alignment explains.

    Examples
    --------
    >>> import numpy as np, orispline as ori
    >>> t = np.linspace(0, 10, 501)
    >>> turns = np.column_stack([np.sin(t), np.cos(1.3 * t), 0.5 * np.sin(0.7 * t)])
    >>> half = np.linalg.norm(turns, axis=1, keepdims=True) / 2
    >>> q = np.hstack([turns / 2 * np.sinc(half / np.pi), np.cos(half)])
    >>> alignment = ori.align((t + 0.25, q), (t, q))
    >>> abs(alignment.offset - 0.25) < 1e-6, alignment.distance_max < 1e-4
    (True, True)
    >>> rates = np.column_stack([np.cos(t), -1.3 * np.sin(1.3 * t), 0.35 * np.cos(0.7 * t)])
    >>> found = ori.align(ori.Rates(t + 0.25, rates + [0.02, 0, 0]), ori.Rates(t, rates[:, [1, 2, 0]]))
    >>> abs(found.offset - 0.25) < 1e-6, found.body.round(6).tolist(), found.aligned
    (True, [-0.5, -0.5, -0.5, 0.5], Rates(501 rates))
    """
    moved, fixed = _recording("a", a), _recording("b", b)
    if isinstance(moved, Rates) or isinstance(fixed, Rates):
        return aligned_by_rates(moved, fixed, plain(options))
    return Alignment._found(Request("align", {"moved": moved, "fixed": fixed}, plain(options)), moved)


def _recording(name: str, given: Any) -> Keys | Rates:
    """Of a pair those of its second part."""
    if isinstance(given, Rates):
        return given
    is_pair = isinstance(given, tuple) and len(given) == 2
    if is_pair and not hasattr(given[1], "as_quat") and array_of(name, given[1]).shape[1:] == (3,):
        return Rates(*given)
    return checked_keys(given, name, "Keys or Rates")
