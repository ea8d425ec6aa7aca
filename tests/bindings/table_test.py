# SPDX-License-Identifier: Apache-2.0
"""table_test.py COMMAND CPP_PROGRAM C_PROGRAM [NPM_PACKAGE [PYTHON]]: runs one table of requests, every task with every kind of input, through C++, C,
the command, the npm package and Python, and prints where one of them finds anything else than C++ does: documents, sentences, warnings, errors, or a bit of a number.
Exits with 1 if there is any."""
import json
import math
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).parent
DATA = HERE.parent.parent / "examples/data"
OPTION_INPUTS = {"gyro": "--gyro-file", "reference": "--reference"}  # which the command has as options; others are files in their order
SPELT = {("reduce", "methods"): "--method", ("inspect", "methods"): "--method"}  # where the command has another name for an option
DEFAULTS = {("adapt", "true"), ("world_turn", "true"), ("body_turn", "true")}  # flags that the command can only take away
NOT_TYPED = {"values", "slowing", "spacing"}  # options that the command spells by flags of its own
KEEPS_DIGITS = {"tune", "reduce", "retime"}  # tables of these have the digits of the input where the keys are the same
# What the command does otherwise by intent: it shows faulty files, reduces for one method or the smallest of all, and has no names of inputs.
BY_INTENT = {"inspect keys=bad.csv", "reduce recording=poses.csv tolerance=1deg methods=slerp,auto", "smooth recordng=poses.csv", "difference first=walk.glb second=walk.glb threads=1",
             "smooth recording=walk.bvh gyro=gyro.csv"}  # the last: it passes over the gyro
# `keep_every` of Python has a default, so it plays no part beside a reference.
BY_INTENT_OF_PYTHON = {"compare keys=few.csv reference=poses.csv keep_every=4 methods=auto"}


def turn(t):
    """The orientation at a time [s], wxyz: turns about two axes that do not commute."""
    half = 0.4 * math.sin(2.0 * t), 0.3 * math.sin(3.1 * t + 0.5)
    (c, s), (d, e) = ((math.cos(x), math.sin(x)) for x in half)
    return c * d, s * d, -s * e, c * e  # about x, then about the body's z


def noise(k, size):
    """What looks like noise and is the same everywhere."""
    return size * math.sin(12.9898 * (k + 1) ** 1.5)


def orientations(times, size):
    rows = ["t,qw,qx,qy,qz"]
    for k, t in enumerate(times):
        q = [x + noise(4 * k + i, size) for i, x in enumerate(turn(t))]
        norm = math.sqrt(sum(x * x for x in q))
        rows.append(",".join(f"{x:.12g}" for x in [t, *(x / norm for x in q)]))
    return "\n".join(rows) + "\n"


def jumping(times, size):
    """The motion to the half of the times, where it begins anew."""
    half = len(times) // 2
    rows = orientations(times, size).splitlines()[:half + 2]
    again = [f"{t:.12g}{row[row.index(','):]}" for t, row in zip(times[half:], rows[1:])]
    return "\n".join(["# orispline: jumps", *rows, *again]) + "\n"


def rates(times, late):
    """[rad/s], from differences of the motion."""
    rows, h = ["t,wx,wy,wz"], 1e-5
    for k, t in enumerate(times):
        (w, x, y, z), (dw, dx, dy, dz) = turn(t - late), [(b - a) / (2 * h) for a, b in zip(turn(t - late - h), turn(t - late + h))]
        omega = (2 * (w * dx - x * dw - y * dz + z * dy), 2 * (w * dy + x * dz - y * dw - z * dx), 2 * (w * dz - x * dy + y * dx - z * dw))
        rows.append(",".join(f"{v:.12g}" for v in [t, *(o + noise(3 * k + i, 0.01) for i, o in enumerate(omega))]))
    return "\n".join(rows) + "\n"


def write_files(folder, command):
    """The files that the table names."""
    shutil.copy(DATA / "five_keys.csv", folder / "five.csv")
    shutil.copy(DATA / "camera_keys.csv", folder / "camera.csv")
    shutil.copy(DATA / "walking.bvh", folder / "walk.bvh")
    every = [k / 50 for k in range(150)]
    texts = {"poses.csv": orientations(every, 0.004), "few.csv": orientations(every[::10], 0.0), "jump.csv": jumping(every, 0.004), "one.csv": orientations([0.0], 0.0),
             "bad.csv": "t,qw,qx,qy,qz\n0,1,0,0,0\n0,1,0,0,0\n", "bad.bvh": "HIERARCHY\nROOT\n",
             "gyro.csv": rates([k / 200 for k in range(600)], 0.0), "late.csv": rates([k / 200 for k in range(600)], 0.03), "short.csv": rates([0.0, 0.01], 0.0)}
    for name, text in texts.items():
        (folder / name).write_text(text)
    subprocess.run([command, "convert", "walk.bvh", "-o", "walk.glb"], cwd=folder, check=True, capture_output=True)


def found_by(program, folder):
    """What a program finds, a value for each request."""
    run = subprocess.run([*program, HERE / "requests.json", folder], stdout=subprocess.PIPE, text=True, check=True)
    return [json.loads(line) for line in run.stdout.splitlines()]


def differences(one, other, place=""):
    """Where two values of JSON differ; numbers have the same bits."""
    if isinstance(one, dict) and isinstance(other, dict):
        for name in sorted({*one, *other}):
            yield from differences(one.get(name), other.get(name), f"{place}.{name}")
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        for k, (a, b) in enumerate(zip(one, other)):
            yield from differences(a, b, f"{place}[{k}]")
    elif one != other:
        yield f"{place or 'the whole'}: found {str(other)[:200]}, wanted {str(one)[:200]}"


def without_times(found):
    """An answer without what a clock says of the computation, which `compare` has in its document and in the last column of its table."""
    if isinstance(found, list):
        return [without_times(one) for one in found]
    if not isinstance(found, dict):
        return found
    return {name: re.sub(r"\s+(\S+|time \[s\])$", "", re.sub(" +", " ", value), flags=re.M) if name == "summary" and "time [s]" in value else without_times(value)
            for name, value in found.items() if not name.endswith("seconds")}


def with_short_sigmas(found, is_sigma=False):
    """An answer with standard deviations of 12 digits: they come of dense matrices, whose sums Eigen takes in another order where vectors are
    shorter, as those of WebAssembly are."""
    if isinstance(found, dict):
        return {name: with_short_sigmas(value, is_sigma or "sigma" in name) for name, value in found.items()}
    if isinstance(found, list):
        return [with_short_sigmas(one, is_sigma) for one in found]
    return float(f"{found:.12g}") if is_sigma and isinstance(found, float) else found


def command_line(command, request, output):
    """The request as it is typed."""
    task, words = request["task"], []
    for name, file in request["inputs"]:
        words += [OPTION_INPUTS[name], file] if name in OPTION_INPUTS else [file]
    for name, text in request["options"].items():
        flag = SPELT.get((task, name), "--" + name.replace("_", "-"))
        if text in ("true", "false"):
            words += [] if (name, text) in DEFAULTS else [flag if text == "true" else flag.replace("--", "--no-")]
        else:
            words.append(f"{flag}={text}")
    return [command, task, *words, "--json", *(["-o", output] if task not in ("compare", "inspect", "difference") else [])]


def typed(command, request, folder):
    """What the command finds: the document, and of a table that it wrote the times and orientations; None where it takes no such request."""
    recordings = [file for name, file in request["inputs"] if name == "recording"]
    if len(recordings) > 1 or NOT_TYPED & set(request["options"]) or text_of(request) in BY_INTENT:
        return None
    files = json.loads((HERE / "requests.json").read_text())["files"]
    is_skeleton = any(files[file] == "skeleton" for _, file in request["inputs"])
    output = folder / ("made.glb" if is_skeleton else "made.json" if request["task"] == "bake" else "made.csv")
    output.unlink(missing_ok=True)
    run = subprocess.run(command_line(command, request, output), cwd=folder, capture_output=True, text=True, check=False)
    if run.returncode:
        return {"error": run.stderr}
    table = [row.split(",") for row in output.read_text().splitlines() if row[0] != "#"] if output.suffix == ".csv" and output.exists() else []
    return {"document": json.loads(run.stdout), "table": table}


def command_differences(wanted, found, keeps_digits):
    """A document of the command has more members, such as the names of files; a table has the decimals that read back as the same numbers."""
    if "error" in wanted or "error" in found:
        if ("error" in wanted) != ("error" in found):
            yield f"found {str(found)[:200]}, wanted {str(wanted)[:200]}"
        return
    one, other = wanted["document"], found["document"]
    yield from differences(one, {name: other[name] for name in one if name in other} if isinstance(one, dict) and isinstance(other, dict) else other)
    if found["table"] and wanted["made"] and "orientations" in wanted["made"][0]:
        header, *rows = found["table"]
        columns = [header.index(name) for name in ("qw", "qx", "qy", "qz")]
        numbers = [float(row[column]) for row in rows for column in columns]
        if not keeps_digits or any(abs(a - b) > 1e-9 for a, b in zip(wanted["made"][0]["orientations"], numbers)):
            yield from differences(wanted["made"][0]["orientations"], numbers, ".orientations")


def python_differences(wanted, found):
    """Exceptions have one text of argument, message and remedy; results have what is kept of a task."""
    if "error" in wanted or "error" in found:
        if ("error" in wanted) != ("error" in found):
            yield f"found {str(found)[:200]}, wanted {str(wanted)[:200]}"
        return
    one = dict(wanted, summary=wanted["summary"].rstrip("\n"))
    if isinstance(found["document"], dict) and set(found["document"]) < set(one["document"]):
        one["document"] = {name: one["document"][name] for name in found["document"]}
    yield from differences({name: one[name] for name in found}, found)


def text_of(request):
    return " ".join([request["task"], *("=".join(one) for one in request["inputs"]), *(f"{name}={text}" for name, text in request["options"].items())])


def compared(binding, wanted, found, requests):
    """How many of the requests that the binding can state it answers as C++ does, and how many these are. Prints the others."""
    if len(found) != len(requests):
        print(f"{binding}: found {len(found)} answers, wanted {len(requests)}")
    same = asked = 0
    for request, one, other in zip(requests, wanted, found):
        if other is None or (binding == "Python" and text_of(request) in BY_INTENT_OF_PYTHON):
            continue
        one, other = without_times(one), without_times(other)
        if binding == "the command":
            lines = list(command_differences(one, other, request["task"] in KEEPS_DIGITS))
        elif binding == "Python":
            lines = list(python_differences(one, other))
        elif binding == "npm":
            lines = list(differences(with_short_sigmas(one), with_short_sigmas(other)))
        else:
            lines = list(differences(one, other))
        asked += 1
        same += not lines
        for line in lines[:3]:
            print(f"{binding}: {text_of(request)}: {line}")
    return same, asked


def main(command, cpp, c, package="", python=""):
    requests = json.loads((HERE / "requests.json").read_text())["requests"]
    programs = {"C": [c]}
    if package and (pathlib.Path(package) / "full.wasm").exists():
        programs["npm"] = ["node", HERE / "table.mjs", package]
    if python and pathlib.Path(python).exists():
        programs["Python"] = [python, HERE / "table_of_python.py"]
    with tempfile.TemporaryDirectory() as place:
        folder = pathlib.Path(place)
        write_files(folder, command)
        wanted = found_by([cpp], folder)
        found = {binding: found_by(program, folder) for binding, program in programs.items()}
        found["the command"] = [typed(command, request, folder) for request in requests]
    counts = {binding: compared(binding, wanted, answers, requests) for binding, answers in found.items()}
    errors = sum("error" in one for one in wanted)
    print(f"{len(requests)} requests, of which {errors} are errors; as C++ answers: "
          + ", ".join(f"{same} of {asked} by {binding}" for binding, (same, asked) in counts.items()))
    return any(same != asked for same, asked in counts.values())


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
