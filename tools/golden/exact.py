# SPDX-License-Identifier: Apache-2.0
"""Vectors, quaternions (w, x, y, z) and equations over any number type with +, -, *, / and sqrt(), and what the tables of curves share."""
import csv
import pathlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
FOLDER = ROOT / "tests" / "data" / "golden"
AROUND = "# Quaternions: Hamilton, body to world; the sign is that of the curve. Rates: body frame, per unit of key time.\n"
NEAREST = "# Every number is the double nearest to a value computed with 60 digits.\n"
SIDES = "# side left is the limit at the right end of the segment, right the limit at its left end or a point inside.\n"
CASES_NOTE = "# A case, numbered within its family, builds `family` through `sequence` of keys.csv; columns as in cases.csv.\n"
CASES = "case,family,sequence,signs,ends,start_rate,end_rate,choices,parameters,period,key_rates,key_accelerations,key_jerks,max_halfangle"
MOTION = "qw,qx,qy,qz,wx,wy,wz,ax,ay,az,jx,jy,jz\n"
PLACES = ((0, "right"), ("0.25", "right"), ("0.6", "right"), (1, "left"))  # where a segment is tabled


def dot(a, b):
    return sum(x * y for x, y in zip(a, b, strict=True))


def norm(v):
    return dot(v, v).sqrt()


def unit(v):
    size = norm(v)
    return [x / size for x in v]


def combined(*terms):
    return [sum(f * v[k] for f, v in terms) for k in range(len(terms[0][1]))]


def signed(sign, q):
    return [sign * x for x in q]


def aligned(keys):
    """Each with the sign that is nearer to the key before it."""
    keys = [list(q) for q in keys]
    for i in range(1, len(keys)):
        if dot(keys[i], keys[i - 1]) < 0:
            keys[i] = signed(-1, keys[i])
    return keys


def product(p, q):
    (a, b, c, d), (w, x, y, z) = p, q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def solved(matrix, sides):
    """By elimination with the largest pivots; a row of right sides for each equation."""
    rows = [list(row) + list(side) for row, side in zip(matrix, sides, strict=True)]
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda i: abs(rows[i][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for i in range(k + 1, size):
            if rows[i][k]:
                factor = rows[i][k] / rows[k][k]
                rows[i] = [x - factor * y if y else x for x, y in zip(rows[i], rows[k])]
    values = [None] * size
    for k in reversed(range(size)):
        later = [(rows[k][j], values[j]) for j in range(k + 1, size) if rows[k][j]]
        values[k] = [(x - sum(a * value[c] for a, value in later)) / rows[k][k] for c, x in enumerate(rows[k][size:])]
    return values


def rows_of(name):
    """Of a table in the folder of golden files, by the names of its columns."""
    with open(FOLDER / name, encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def sequences(number):
    """Name -> times and keys of keys.csv in a type of numbers; the keys are normalised in it."""
    found = {}
    for row in rows_of("keys.csv"):
        times, keys = found.setdefault(row["sequence"], ([], []))
        times.append(number(float(row["t"])))
        keys.append(unit([number(float(row[c])) for c in ("qw", "qx", "qy", "qz")]))
    return found


def doubles(*parts):
    """The numbers of some lists as cells."""
    return [repr(float(x)) for part in parts for x in part]


def case_row(number, family, sequence, ends, rates=("", ""), period=None, more=()):
    return ",".join([str(number), family, sequence, "shortest", "" if period else ends, *rates, "", "",
                     repr(float(period)) if period else "", "", "", "", "0.0", *more])


def segment_times(start, end, number):
    """(time, side) of each place in a segment; a time is one that a double holds."""
    for share, side in PLACES:
        yield (end if share == 1 else number(float(start + (end - start) * number(share)))), side
