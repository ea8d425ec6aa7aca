# SPDX-License-Identifier: Apache-2.0
"""Tables of many tracks."""
import numpy as np
import orispline as ori
import pyarrow as pa

QUATERNION = ["qx", "qy", "qz", "qw"]
RATES = ["wx", "wy", "wz", "ax", "ay", "az", "jx", "jy", "jz"]


def tracks(count, *, least=2, most=60, seed=7):
    """So many tracks of random length: {id: (times, quaternions)}, each a random walk that begins at a time of its own."""
    dice = np.random.default_rng(seed)
    made = {}
    for track in range(count):
        n = int(dice.integers(least, most + 1))
        turns = np.cumsum(dice.normal(size=(n, 3)) * 0.1, axis=0)
        angle = np.linalg.norm(turns, axis=1, keepdims=True)
        q = np.hstack([np.sin(angle / 2) * turns / angle, np.cos(angle / 2)])
        made[track] = dice.uniform(0, 50) + np.cumsum(dice.uniform(0.05, 0.15, n)), q
    return made


def table_of(made, kind=None):
    """One row is one key. `kind`: the type of the ids."""
    ids = pa.array(np.repeat(list(made), [len(times) for times, _ in made.values()]))
    if kind is not None:
        ids = ids.cast(kind)
    times = np.concatenate([times for times, _ in made.values()])
    q = np.concatenate([q for _, q in made.values()])
    return pa.table({"track": ids, "t": times, **{name: q[:, k] for k, name in enumerate(QUATERNION)}})


def shuffled(table, seed=1):
    """Rows in no order."""
    return table.take(np.random.default_rng(seed).permutation(table.num_rows))


def columns(table, names):
    """(n, k) of columns."""
    return np.column_stack([table[name].to_numpy() for name in names])


def rows_of(table, track):
    """Those of a track."""
    return table.filter([each == track for each in table["track"].to_pylist()])


def expect_samples_of_curves(found, made, *, rate=100, derivatives=1, method="auto"):
    """That a table in order of the tracks has the samples of their curves, bit for bit."""
    samples = [ori.Curve(*keys, method).sample(rate=rate, derivatives=derivatives) for keys in made.values()]
    assert found["track"].to_pylist() == np.repeat(list(made), [len(s) for s in samples]).tolist()
    assert np.array_equal(found["t"].to_numpy(), np.concatenate([s.times for s in samples]))
    assert np.array_equal(columns(found, QUATERNION), np.concatenate([s.orientations for s in samples]))
    for order, rates in enumerate(("angular_velocities", "angular_accelerations", "angular_jerks")[:derivatives]):
        assert np.array_equal(columns(found, RATES[3 * order:3 * order + 3]), np.concatenate([getattr(s, rates) for s in samples]))
    assert found["error"].null_count == len(found)


def table_like(found, expected):
    """What a function of tables gives, of whatever kind, as a table with the schema of another."""
    if hasattr(found, "read_all"):
        return found.read_all()
    frame = found.collect() if hasattr(found, "collect") else found
    table = frame.to_arrow() if hasattr(frame, "to_arrow") else pa.Table.from_pandas(frame, preserve_index=False)
    return table.cast(expected.schema)
