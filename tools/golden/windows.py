# SPDX-License-Identifier: Apache-2.0
"""What `auto` and `measured` find in their windows of keys."""
import importlib.util
import json

import numpy as np
from golden.exact import conjugate, doubles, norm, product, solved
from mpmath import atan2, exp, log, mp, mpf, pi, sqrt

mp.dps = 40

# ---------------------------------------------------------------- the guard of auto

def loaded(folder):
    spec = importlib.util.spec_from_file_location("auto_reference", folder / "auto_reference.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def left_out(x, at, others):
    """The value at a time of the polynomial through other values, and of their natural cubic spline."""
    polynomial = sum(value * np.prod([(at - b) / (a - b) for k, b in enumerate(x) if k != j])
                     for j, (a, value) in enumerate(zip(x, others)))
    h, m = np.diff(x), len(x)
    matrix, right = np.eye(m), np.zeros((m, 3))
    secants = np.diff(others, axis=0) / h[:, None]
    for j in range(1, m - 1):
        matrix[j, j - 1:j + 2] = h[j - 1], 2 * (h[j - 1] + h[j]), h[j]
        right[j] = 6 * (secants[j] - secants[j - 1])
    second = np.linalg.solve(matrix, right)
    if not x[0] < at < x[-1]:  # beyond its keys the spline is a line
        end, near = (0, 1) if at < x[0] else (-1, -2)
        slope = secants[end] - np.sign(x[near] - x[end]) * h[end] * second[near] / 6
        return polynomial, others[end] + (at - x[end]) * slope
    k = np.searchsorted(x, at) - 1
    a, b = (x[k + 1] - at) / h[k], (at - x[k]) / h[k]
    return polynomial, (a * others[k] + b * others[k + 1]
                        + ((a**3 - a) * second[k] + (b**3 - b) * second[k + 1]) * h[k]**2 / 6)


def guard(auto, keys, times):
    """β of every key."""
    found = []
    for i in range(len(times)):
        first = min(max(0, i - 3), len(times) - 7)
        x, logs = times[first:first + 7] - times[i], auto.lg(auto.qm(auto.cj(keys[i]), keys[first:first + 7]))
        errors = np.array([[np.sum((logs[j] - value)**2) for value in left_out(x[rest], x[j], logs[rest])]
                           for j in range(7) for rest in [np.arange(7) != j]])
        polynomial, spline = errors[1:6].sum(axis=0)
        share = 1.0 - auto.S(np.log(polynomial / spline), np.log(0.3), 0.0)
        if i - first != 3:
            outer = errors[0] if i - first < 3 else errors[6]
            share *= 1.0 - auto.S(np.log(polynomial * outer[0] / (spline * outer[1])), np.log(4.0), np.log(20.0))
        found.append(share)
    return np.array(found)


def guarded_rates(auto, keys, times):
    steps = auto.nrm(auto.lg(auto.qm(auto.cj(keys[:-1]), keys[1:])))
    if np.convolve(steps, np.ones(6)).max() > auto.PA:
        raise SystemExit("make_auto_golden: these keys turn so far that the windows are narrower, where the guard is another")
    switches = auto.RA, auto.RB
    with_polynomial = np.array(auto.rates(keys, times))
    auto.RA, auto.RB = -2.0, -1.0  # no key is smooth
    without = np.array(auto.rates(keys, times))
    auto.RA, auto.RB = switches
    return tuple(without + guard(auto, keys, times)[:, None] * (with_polynomial - without))


def uneven_keys(auto, seed, wobble):
    """33 keys of a smooth motion whose intervals differ by a factor of up to 8."""
    dice = np.random.default_rng(seed)
    times = np.concatenate([[0.0], np.cumsum(0.25 * dice.choice([1, 2, 4, 8], 32))])
    turn = np.column_stack([0.2 * np.sin(0.31 * times), 0.25 * np.cos(0.23 * times), 0.02 * times])
    turn[:, 0] += wobble * np.sin(1.7 * times)
    return auto.ex(turn), times


def auto(source):
    """Reference values of auto where its polynomial is guarded: step (2) of docs/families/auto.md.

    The rates without the guard are those of auto_reference.py, which lies with the reference; the guard is computed here as it is
    defined, every key left out of its window in turn.
    """
    reference = loaded(source)
    recorded = json.loads((source / "golden_auto.json").read_text())["cases"]["smooth25"]
    uneven = ((2, 0.03), (3, 0.1), (4, 0.01), (6, 0.01), (131, 0.01))  # seed, wobble
    sequences = {"smooth25": (np.array(recorded["keys"], float), np.array(recorded["times"], float)),
                 **{f"uneven{n}": uneven_keys(reference, *how) for n, how in enumerate(uneven)}}
    key_lines, rows = [], []
    for name, (keys, times) in sequences.items():
        key_lines += [",".join([name, *doubles([t], q)]) for t, q in zip(times, keys)]
        at = np.sort(np.concatenate([times[:-1] + share * np.diff(times) for share in (0.0, 0.35, 0.8)]))
        motions = reference.evaluate(keys, times, at, guarded_rates(reference, keys, times), deriv=True)
        rows += [",".join([name, *doubles([t], *parts)]) for t, *parts in zip(at, *motions)]
    head = ("# Made by tools/make_auto_golden.py from auto_reference.py, computed in double precision.\n"
            "# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.\n")
    limits = "# Agreement to be reached, relative to max(1, |.|): q 1e-11, w 1e-09, a 1e-07.\n"
    return {"tests/data/golden/auto_guard_keys.csv": head + "sequence,t,qw,qx,qy,qz\n" + "\n".join(key_lines) + "\n",
            "tests/data/golden/auto_guard.csv": head + limits + "sequence,t,qw,qx,qy,qz,wx,wy,wz,ax,ay,az\n" + "\n".join(rows) + "\n"}


# ---------------------------------------------------------------- the models of measured

NOISE = (".03", ".1", ".2", ".35", ".5", ".65", ".8")
VELOCITY = ((1, ".7"), (1, "1.5"), (3, ".7"), (3, "1.2"))
KEYS, DRAWS, BLOCK, HOLD, POWER, FLOOR = 9, 32, 8, mpf(1.08), 30, mpf(1e-24)


def switched(x, low, high):
    t = min(max((x - low) / (high - low), mpf(0)), mpf(1))
    return t * t * (3 - 2 * t)


def half_increment(p, q):
    """log of p⁻¹ q, half angle."""
    w, *v = product(conjugate(p), q)
    n = norm(v)
    return [x * atan2(n, w) / n for x in v] if n > 0 else [mpf(0)] * 3


def kernel(smoothness, length):
    a = 1 / mpf(length) if smoothness == 1 else sqrt(mpf(3)) / mpf(length)

    def c(y):
        return y - 1 + exp(-y) if smoothness == 1 else 2 * y - 3 + (y + 3) * exp(-y)
    scale = 8 * c(a) - 2 * c(2 * a)
    return lambda d: -c(a * d) / scale


MODELS = ([(lambda d: d ** 3 / 8, mpf(f)) for f in ("0", *NOISE)] + [(kernel(*shape), mpf(0)) for shape in VELOCITY])


def model_miss(model, x, p, increments):
    """The squared miss of key p of a window by a model."""
    g, f = model
    n = len(x)
    matrix = [[(1 - f) * g(abs(x[a] - x[b])) + (f / 6 if a == b else 0) for b in range(n)] + [mpf(1), x[a]] for a in range(n)]
    matrix += [[mpf(1)] * n + [mpf(0)] * 2, list(x) + [mpf(0)] * 2]
    row = solved(matrix, [[*v, mpf(j == p)] for j, v in enumerate(increments)] + [[mpf(0)] * 4] * 2)[p]
    return sum((part / row[3]) ** 2 for part in row[:3])


def exponentials(blocks):
    """The draws and their mirror images."""
    mask, numbers = (1 << 64) - 1, []
    for counter in range(1, DRAWS * blocks + 1):
        z = counter * 0x9E3779B97F4A7C15 & mask
        z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9 & mask
        z = (z ^ z >> 27) * 0x94D049BB133111EB & mask
        z ^= z >> 31
        numbers.append(-log((mpf(z >> 11) + mpf(".5")) / 2 ** 53))
    rows = [numbers[d * blocks:(d + 1) * blocks] for d in range(DRAWS)]
    return rows + [row[::-1] for row in rows]


def drawn_sums(misses, weights):
    """Of each guess, one sum per draw."""
    n = len(weights) - 2
    k = 2 * (n // (2 * BLOCK)) + 1
    cut = [i * n // k if 2 * i < k else n - (k - i) * n // k for i in range(k + 1)]
    heeded = [[(e + FLOOR) * u for e, u in zip(row[1:-1], weights[1:-1])] for row in misses]
    blocks = [[sum(row[a:b], mpf(0)) for a, b in zip(cut, cut[1:])] for row in heeded]
    return [[sum(d * b for d, b in zip(draw, row)) for draw in exponentials(k)] for row in blocks]


def shares(sums):
    mean = [mpf(0)] * len(sums)
    for draw in zip(*sums):
        powers = [(min(draw) / s) ** POWER if s > 0 else mpf(1) for s in draw]
        mean = [m + z / sum(powers) / len(sums[0]) for m, z in zip(mean, powers)]
    return mean


def model_shares(misses, trust):
    sums = drawn_sums(misses, trust)
    if max(sums[0]) == 0:
        return [1.0] + [0.0] * (len(MODELS) - 1)
    for draw, plain in enumerate(sums[0]):
        ratios = [row[draw] / plain if plain > 0 else row[draw] for row in sums[:len(NOISE)]]
        for m in range(1, len(MODELS)):
            sums[m][draw] *= HOLD * (max(ratios[:m]) ** 2 if m <= len(NOISE) else 1)
    return shares(sums)


def roughness(t, q, i):
    window = range(i - 2, i + 3)
    v, x = [half_increment(q[i], q[j]) for j in window], [t[j] for j in window]
    d = [[(b - a) / (x[k + 1] - x[k]) for a, b in zip(v[k], v[k + 1])] for k in range(4)]
    bend = [[2 * (b - a) / (x[k + 2] - x[k]) for a, b in zip(d[k], d[k + 1])] for k in range(3)]
    at = [(x[k] + x[k + 1] + x[k + 2]) / 3 for k in range(3)]
    w = (at[2] - at[1]) / (at[2] - at[0])
    size = norm(bend[1]) + w * norm(bend[0]) + (1 - w) * norm(bend[2])
    return norm([b - w * a - (1 - w) * c for a, b, c in zip(*bend)]) / size if size > 0 else mpf(0)


def polynomial_miss(t, q, i, count):
    first = min(max(i - count // 2, 0), len(t) - count)
    others = [j for j in range(first, first + count) if j != i]
    total = [mpf(0)] * 3
    for a in others:
        factor = mpf(1)
        for b in others:
            factor *= (t[b] - t[i]) / (t[b] - t[a]) if b != a else 1
        total = [s + factor * v for s, v in zip(total, half_increment(q[i], q[a]))]
    return sum(x * x for x in total)


def numbers_of(case):
    """The shares of the models, and how far the polynomials through seven and nine keys are believed."""
    t = [mpf(x) for x in case["t"]]
    q = [[mpf(x) for x in key] for key in case["q"]]
    q = [[x / norm(key) for x in key] for key in q]
    n = len(t)
    steps = sorted(b - a for a, b in zip(t, t[1:]))
    interval = (steps[(n - 1) // 2] + steps[(n - 2) // 2]) / 2
    turns = [norm(half_increment(a, b)) for a, b in zip(q, q[1:])]
    rough = {i: roughness(t, q, i) for i in range(2, n - 2)}

    def smooth(i, side):
        c = min(max(i, side + 2), n - 3 - side)
        return 1 - switched(max(rough[k] for k in range(c - side, c + side + 1)), mpf(".15"), mpf(".4"))
    trust, misses = [], [[] for _ in MODELS]
    for i in range(n):
        first = min(max(i - KEYS // 2, 0), n - KEYS)
        window = range(first, first + KEYS)
        turn = max(sum(turns[first:i], mpf(0)), sum(turns[i:window[-1]], mpf(0)))
        widest = max(t[j + 1] - t[j] for j in window[:-1]) / interval
        trust.append((1 - switched(turn, mpf(".6") * pi, mpf(".8") * pi)) * (1 - switched(log(widest), log(mpf(5)), log(mpf(15)))))
        increments, x = [half_increment(q[i], q[j]) for j in window], [(t[j] - t[i]) / interval for j in window]
        for m, model in enumerate(MODELS):
            misses[m].append(model_miss(model, x, i - first, increments))
    seven, nine = ([polynomial_miss(t, q, i, count) for i in range(n)] for count in (7, 9))
    heeds7 = [u * smooth(i, 1) for i, u in enumerate(trust)]
    heeds9 = [u * smooth(i, 2) if smooth(i, 1) > 0 else mpf(0) for i, u in enumerate(trust)]
    seventh = shares(drawn_sums([misses[0], seven], heeds7))[1] if any(heeds7[1:-1]) else 1.0
    ninth = shares(drawn_sums([seven, nine], heeds9))[1] if any(heeds9[1:-1]) else 0.0
    return (model_shares(misses, trust) if n >= 20 else [1.0] + [0.0] * (len(MODELS) - 1)), seventh, ninth


def text(number):
    return "" if number is None else repr(float(number))


def measured(source):
    """Golden values of `measured`.

    Keys, their rates, samples and bands are those of golden_measured.json, which its reference computed in double precision. What is
    found of the keys is computed here with 40 digits, by solving the models' eleven equations of docs/families/measured.md as they
    stand: five minutes.
    """
    mp.dps = 40
    keys, rows, numbers = [], [], []
    for case in json.loads((source / "golden_measured.json").read_text())["cases"]:
        name = case["name"].replace(",", "")
        rates = [[[2 * x for x in v] for v in case[half]] for half in ("v", "s")]
        keys += [",".join([name, *doubles([t], q, v, s)]) for t, q, v, s in zip(case["t"], case["q"], *rates, strict=True)]
        bands = [case.get(b, [None] * len(case["times"])) for b in ("band50", "band90")]
        rows += [",".join([name, *doubles([t], q, w, a), *map(text, band)])
                 for t, q, w, a, *band in zip(*(case[c] for c in ("times", "out", "omega", "alpha")), *bands, strict=True)]
        if case["weights"]:
            models, seven, nine = numbers_of(case)
            numbers.append(",".join([name, " ".join(doubles(models)), text(seven), text(nine)]))
    rates = "wx,wy,wz,ax,ay,az"
    tables = {"measured_keys.csv": [f"sequence,t,qw,qx,qy,qz,{rates}", *keys],
              "measured.csv": ["# band50, band90: radii [rad] that hold that share; empty: none.",
                               f"sequence,t,qw,qx,qy,qz,{rates},band50,band90", *rows],
              "measured_numbers.csv": ["sequence,models,polynomial,polynomial9", *numbers]}
    head = "# Made by tools/make_measured_golden.py: see there. Quaternions: Hamilton, body to world. Rates: body frame.\n"
    return {f"tests/data/golden/{name}": head + "\n".join(lines) + "\n" for name, lines in tables.items()}
