# SPDX-License-Identifier: Apache-2.0
"""The tables of docs/smooth.md: noise is added to recordings, which are taken for the truth, and smoothed."""
import csv
import pathlib
import subprocess
import sys
import tempfile

import numpy
from motions.noisy_recordings import GYRO_NOISE, NOISES, RECORDINGS, WAYS, options_of, recording, rms_degrees, with_noise
from motions.rotations import conjugate, times
from scipy.interpolate import make_smoothing_spline
from scipy.signal import savgol_filter

GOLDEN = pathlib.Path(__file__).resolve().parents[2] / "tests" / "data" / "golden" / "smooth_recordings.csv"


def smoothed_rows(command, motion, options, folder):
    """Of the file that the command writes for a motion."""
    motion.write(folder / "noisy.csv")
    subprocess.run([command, "smooth", "noisy.csv", *options, "--quiet", "-o", "smooth.csv"], cwd=folder, check=True)
    with open(folder / "smooth.csv", encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def orientation(row):
    return tuple(float(row[c]) for c in ("qw", "qx", "qy", "qz"))


# ---------------------------------------------------------------- how often the band holds the truth

WITHIN = 1.6448536269514722  # standard deviations
ROWS = {"nothing stated": "", "`--noise`": "--noise {}deg", "`--penalty jerk`": "--penalty jerk", "`--no-adapt`": "--no-adapt"}


def components(found, wanted):
    """Of the small turn from one orientation to the other [rad], body frame."""
    w, *v = times(conjugate(found), wanted)
    return [2 * x if w > 0 else -2 * x for x in v]


def held(command, clean, noise, seed, options, folder):
    """For each axis, the share of the samples within."""
    rows = smoothed_rows(command, with_noise(clean, noise, seed), ["--sigma", *options.format(noise).split()], folder)
    counts = [0, 0, 0]
    for row, wanted in zip(rows, clean.orientations, strict=True):
        turn = components(orientation(row), wanted)
        for axis, name in enumerate(("sigma_x", "sigma_y", "sigma_z")):
            counts[axis] += abs(turn[axis]) <= WITHIN * float(row[name])
    return [count / len(rows) for count in counts]


def cell(command, clean, noise, seeds, options, folder):
    shares = [held(command, clean, noise, seed, options, folder) for seed in range(seeds)]
    return " ".join(f"{100 * sum(axis) / seeds:.0f}" for axis in zip(*shares))


def band(options):
    """Counts components of the turn to the truth within 1.645 standard deviations, which nine in ten normal values are."""
    print("| | " + " | ".join(RECORDINGS) + " |\n|" + "---|" * (len(RECORDINGS) + 1))
    clean = {name: recording(name, options.data) for name in RECORDINGS}
    with tempfile.TemporaryDirectory() as folder:
        for title, words in ROWS.items():
            cells = (" / ".join(cell(options.command, clean[name], noise, options.seeds, words, pathlib.Path(folder))
                                for noise in NOISES) for name in RECORDINGS)
            print(f"| {title} | " + " | ".join(cells) + " |", flush=True)


# ---------------------------------------------------------------- how far what is smoothed is from the truth

OUTLIERS = 0.02
OWN_WAYS = ("robust", "outliers")  # without options, and not of the reference
SCAN = [0.5 * 1.3**k for k in range(28)]  # smoothing time over the median interval


class Cell:
    """One recording with noise of one size and seed."""

    def __init__(self, name, clean, noise, seed):
        self.name, self.clean, self.noise, self.seed = name, clean, noise, seed
        self.noisy = with_noise(clean, noise, seed)
        self.t, self.samples = numpy.array(clean.times), numpy.array(self.noisy.orientations)
        self.interval = numpy.median(numpy.diff(self.t))

    def error(self, orientations):
        return rms_degrees([tuple(q) for q in numpy.asarray(orientations).tolist()], self.clean.orientations)

    def continuous(self):
        """The samples without jumps of sign."""
        flips = numpy.sum(self.samples[:-1] * self.samples[1:], 1) < 0
        return self.samples * numpy.where(numpy.r_[False, numpy.cumsum(flips) % 2 == 1], -1, 1)[:, None]


def by_command(command, cell, way, folder):
    motion = with_noise(cell.clean, cell.noise, cell.seed, OUTLIERS) if way == "outliers" else cell.noisy
    options = [] if way in OWN_WAYS else options_of(way, cell.name, cell.noise)
    return cell.error([orientation(row) for row in smoothed_rows(command, motion, options, folder)])


class Reference:
    """The reference implementation with the choices of τ that its description states."""

    def __init__(self, folder):
        sys.path.insert(0, str(folder))
        import smooth_reference
        self.implementation = smooth_reference

    def fit(self, cell, way, time, tolerance=1e-6):
        order, sigma = 3 if way == "jerk" else 2, numpy.radians(cell.noise) if way in ("noise", "gyro") else 1.0
        strength = time ** (2 * order) / (sigma**2 * cell.interval)
        gyro = {}
        if way == "gyro":
            rate_noise = numpy.radians(GYRO_NOISE[cell.name])
            gyro = {"gyro": numpy.array(cell.clean.rates), "wg": 1 / rate_noise**2, "bias": True}
        found = self.implementation.smooth(cell.t, cell.samples, strength, w=1 / sigma**2, order=order, tol=tolerance, **gyro)
        return found, self.criterion(cell, way, found, strength, order, sigma)

    def criterion(self, cell, way, found, strength, order, sigma):
        n = len(cell.t)
        if way == "gyro":
            return self.implementation.reml(found, strength, n, n, order, n, bias=True, sigma_known=True)
        trace = self.trace(cell.t, 1 / sigma**2, strength, order)
        if way == "noise":
            return found["data"] + 6 * trace
        return numpy.log(self.implementation.gcv(found, trace, n))

    def trace(self, *arguments):
        """By the reference's QR: its Cholesky factor loses all digits where the jerk is much smoothed."""
        cholesky = self.implementation.cholesky_banded

        def refuse(_):
            raise numpy.linalg.LinAlgError

        self.implementation.cholesky_banded = refuse
        try:
            return self.implementation.trace_hat(*arguments)
        finally:
            self.implementation.cholesky_banded = cholesky

    def smoothed(self, cell, way):
        """Smoothing time and error where a parabola through the least values of the scan has its minimum."""
        values = []
        for step in SCAN:
            values.append(self.fit(cell, way, step * cell.interval)[1])
            least = int(numpy.argmin(values))
            if len(values) - 1 - least >= 4:
                break
        before, middle, after = values[least - 1 : least + 2]
        shift = 0.5 * (before - after) / (before - 2 * middle + after)
        time = SCAN[least] * 1.3**shift * cell.interval
        return time, cell.error(self.fit(cell, way, time, 1e-9)[0]["q"])

    def moving_average(self, cell):
        """The geodesic mean of the samples about each, of the window that suits the truth best."""
        log, exp, times = self.implementation.Log, self.implementation.Exp, self.implementation.qm
        n, errors = len(cell.t), []
        for half in [*range(1, 16), *range(16, 40, 3), *range(40, 161, 10)]:
            index = numpy.arange(n)[:, None] + numpy.arange(-half, half + 1)
            inside = ((index >= 0) & (index < n))[..., None]
            window = cell.samples[index.clip(0, n - 1)]
            mean = cell.samples.copy()
            for _ in range(3):
                turns = numpy.where(inside, log(times((mean * [1, -1, -1, -1])[:, None], window)), 0)
                mean = times(mean, exp(turns.sum(1) / inside.sum(1)))
            errors.append(cell.error(mean))
            if len(errors) - 1 - int(numpy.argmin(errors)) >= 3:
                break
        return min(errors)


def normalised(columns):
    q = numpy.stack(columns, -1)
    return q / numpy.linalg.norm(q, axis=1, keepdims=True)


def savitzky_golay(cell):
    """On the components, of the window and degree that suit the truth best."""
    q = cell.continuous()
    return min(cell.error(normalised(savgol_filter(q, 2 * half + 1, degree, axis=0).T))
               for degree in (2, 3, 4) for half in [*range(3, 30), *range(30, 300, 10)])


def component_spline(cell):
    """A cubic smoothing spline of each component, one λ for all, the one that suits the truth best."""
    q = cell.continuous()
    return min(cell.error(normalised([make_smoothing_spline(cell.t, x, lam=(s * cell.interval) ** 4 / cell.interval)(cell.t)
                                      for x in q.T])) for s in SCAN)


def cells_of(name, data, seeds):
    clean = recording(name, data)
    return {noise: [Cell(name, clean, noise, seed) for seed in range(seeds)] for noise in NOISES}


def print_row(name, title, cells, error):
    means = [numpy.mean([error(cell) for cell in cells[noise]]) for noise in NOISES]
    print(f"{name:6} {title:22} {' / '.join(f'{mean:.3g}' for mean in means)}", flush=True)


def print_table(name, cells, options, folder):
    reference = Reference(options.reference)
    rows = []
    for way in (*WAYS, *OWN_WAYS):
        if way == "gyro" and name not in GYRO_NOISE:
            continue
        print_row(name, way, cells, lambda cell: by_command(options.command, cell, way, folder))
        if way in OWN_WAYS:
            continue
        found = {cell: reference.smoothed(cell, way) for noise in NOISES for cell in cells[noise]}
        print_row(name, way + ", reference", cells, lambda cell: found[cell][1])
        rows += [(name, way, cell.noise, cell.seed, *found[cell]) for cell in found]
    print_row(name, "samples", cells, lambda cell: cell.error(cell.samples))
    print_row(name, "moving average*", cells, reference.moving_average)
    print_row(name, "Savitzky-Golay*", cells, savitzky_golay)
    print_row(name, "component spline*", cells, component_spline)
    return rows


def smoothing(options):
    """Noise on recordings, smoothed by the command, by the reference implementation and by what people use otherwise, against the recording.

    RMS angles in degrees at noise of 0.2 / 1 / 3° per axis.
    """
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in options.recordings:
            rows += print_table(name, cells_of(name, options.data, options.seeds), options, pathlib.Path(folder))
    if options.golden:
        text = "".join(",".join(str(value) for value in row) + "\n" for row in rows)
        GOLDEN.write_text("# The reference implementation on tools/noisy_recordings.py.\n"
                          "recording,way,noise_deg,seed,smoothing_time_s,error_deg\n" + text, "utf-8")
