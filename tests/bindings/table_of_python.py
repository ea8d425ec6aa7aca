# SPDX-License-Identifier: Apache-2.0
"""table_of_python.py TABLE FOLDER: what the Python package finds for every request of the table by the functions that its users call, a line of JSON
each; null where it has no such function, or takes what is stated by another type."""
import base64
import io
import json
import os
import pathlib
import re
import sys
import warnings

import numpy as np
import orispline as ori

NUMBERS = {"threads", "keep_every", "position_scale"}
FLAGS = {"true": True, "false": False}
# The inputs of the tasks that have a document in Python, and which of them are lists there.
INPUTS = {"smooth": {"recording", "gyro"}, "reduce": {"recording"}, "tune": {"keys", "reference"}, "retime": {"keys"}, "mean": {"rows"},
          "align": {"moved", "fixed"}, "compare": {"keys", "reference"}}
SEVERAL = {"reduce", "mean"}


def is_python(request, files):
    """Whether it can be written down in Python: other tasks have no document there, one recording is no list, and some options have other names."""
    task, options, names = request["task"], request["options"], [name for name, _ in request["inputs"]]
    is_scene = any(files[file] == "skeleton" for _, file in request["inputs"])
    if task not in INPUTS or not names or set(names) - INPUTS[task] or (len(set(names)) < len(names) and task not in SEVERAL):
        return False
    if is_scene and len(names) > 1:
        return False
    return not ("spacing" in options or (task == "smooth" and "threads" in options and not is_scene))


def value_of(name, text):
    return FLAGS[text] if text in FLAGS else float(text) if name == "position_scale" else int(text) if name in NUMBERS else text


def input_of(kind, file):
    if kind == "rates":
        table = np.loadtxt(file, delimiter=",", skiprows=1, ndmin=2)
        return ori.Rates(table[:, 0], table[:, 1:])
    return (ori.read_scene if kind == "skeleton" else ori.read)(file)


def result_of(task, inputs, options):
    """What the function of a task gives; None where Python has none."""
    methods = options.pop("methods").split(",") if "methods" in options else None
    if task == "mean":
        return ori.mean(inputs["rows"] if len(inputs["rows"]) > 1 else inputs["rows"][0], **options)
    if task == "align":
        return ori.align(*(one for name in ("moved", "fixed") for one in inputs.get(name, [])), **options)
    if task == "compare":
        reference = inputs.get("reference", [None])[0]
        return ori.compare(inputs["keys"][0], methods, reference=reference, **options)
    first, *others = inputs.get("recording") or inputs["keys"]
    if task == "smooth":
        if isinstance(first, ori.Scene):
            return ori.smooth_scene(first, **options)
        return ori.smooth(first, **({"gyro": inputs["gyro"][0]} if "gyro" in inputs else {}), **options)
    method = options.pop("method", methods if methods is None or len(methods) > 1 else methods[0])
    if task == "reduce" and isinstance(first, ori.Scene):
        return ori.reduce_scene(first, **({"method": method} if method else {}), **options)
    if task == "reduce":
        return ori.reduce_tracks([first, *others], method=method, **options) if others else ori.reduce(first, method=method, **options)
    if task == "tune":
        return ori.tune(first, method or "timed-c2", **({"reference": inputs["reference"][0]} if "reference" in inputs else {}), **options)
    return ori.retime(first, method=method, **options)


def document_of(report):
    return report.table() if isinstance(report, ori.Comparison) else report.as_dict()


def made_of(result):
    """The keys, rates and skeletons that a result holds, as the table has them."""
    if isinstance(result, tuple):
        file = io.BytesIO()
        file.name = "made.glb"
        result[0].write(file)
        return [{"skeleton": base64.b64encode(file.getvalue()).decode()}]
    keys = getattr(result, "keys", None)
    keys = result.aligned if isinstance(result, ori.RateAlignment) else keys
    if isinstance(keys, ori.Keys):
        return [{"times": keys.times.tolist(), "orientations": keys.rotations[:, [3, 0, 1, 2]].ravel().tolist()}]
    return [{"times": keys.times.tolist(), "rates": keys.rates.ravel().tolist()}] if isinstance(keys, ori.Rates) else []


def told_of(warning):
    """As documents have it: Python's text begins with the place."""
    placed = re.fullmatch(r"\S+:(\d+): key (\d+): (.*)", str(warning), re.S)
    place = {"line": int(placed[1]), "key": int(placed[2])} if placed else {}
    return {"code": warning.code, "message": placed[3] if placed else str(warning), **place, **warning.numbers}


def found(files, request):
    task, options = request["task"], {name: value_of(name, text) for name, text in request["options"].items()}
    if not is_python(request, files):
        return None
    inputs = {}
    with warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        try:
            for name, file in request["inputs"]:
                inputs.setdefault(name, []).append(input_of(files[file], file))
            result = result_of(task, inputs, options)
        except (ori.Error, TypeError) as error:
            return {"error": str(error)}
    report = result[-1] if isinstance(result, tuple) else result
    told = [told_of(one.message) for one in caught]
    if isinstance(report, list):
        documents = [one.as_dict() for one in report]
        return {"document": {"windows": documents} if task == "mean" else documents, "warnings": told}
    return {"document": document_of(report), "summary": str(report), "warnings": told, **({} if task == "mean" else {"made": made_of(result)})}


def main(table, folder):
    stated = json.loads(pathlib.Path(table).read_text())
    os.chdir(folder)  # so that summaries name the files as the table does
    for request in stated["requests"]:
        print(json.dumps(found(stated["files"], request)))


if __name__ == "__main__":
    main(*sys.argv[1:])
