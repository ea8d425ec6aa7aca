# SPDX-License-Identifier: Apache-2.0
"""The data of a page with its lists of numbers as lists, whichever of the forms of studio/report/README.md they have."""
import base64
import json
import re
import struct

HALF_FLOAT = 2 ** -10  # the relative distance of two neighbours
CODES = {"f8": "d", "f4": "f", "f2": "e", "u4": "I"}


def typed_list(value):
    kind = next(iter(value))
    data = base64.b64decode(value[kind], validate=True)
    numbers = [number for number, in struct.iter_unpack("<" + CODES[kind], data)]
    if kind == "u4":
        return [value["start"] + number * value["step"] for number in numbers]
    return [None if number != number else number * value.get("unit", 1) for number in numbers]


def with_lists(value):
    if isinstance(value, list):
        return [with_lists(item) for item in value]
    if not isinstance(value, dict):
        return value
    if next(iter(value), None) in CODES:
        return typed_list(value)
    return {name: with_lists(item) for name, item in value.items()}


def decoded(data):
    """Times that several methods have stand once, in the first of them."""
    assert data["data"] == 2
    data = with_lists(data)
    for samples in [method["samples"] for method in data.get("methods", [])]:
        for name in ("t", "error_t"):
            if isinstance(samples[name], dict):
                samples[name] = data["methods"][samples[name]["like"]]["samples"][name]
    return data


def data_of(page):
    """Those in the text of a page."""
    return decoded(json.loads(re.search(r'id="report-data">(.*?)</script>', page, re.S)[1]))
