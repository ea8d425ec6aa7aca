#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes THIRD_PARTY, the notices for the code of others in what is shipped: make_third_party.py [ROOT] [--check].

What is shipped stands in the table of dependencies of CONTRIBUTING.md; each package in it has to be among `NOTICES`, and no
other. With --check the file is compared only. Texts of licences are in tools/licences.
"""
import argparse
import dataclasses
import pathlib
import re
import sys

HEAD = """The library, the command and the Python package of orispline hold compiled code of the packages below. The
library's page of the reports, which is the package's widget of notebooks too, and the command's page of the studio hold that of three.js and uPlot. The
WebAssembly of the npm package and of the studio holds that of Eigen, fmt, tl::expected, SIMDe, libc++, libc++abi, compiler-rt, wasi-libc, musl, cloudlibc and dlmalloc; where it has files, of
fast_float and nlohmann-json too. The licences stand once, behind all packages.
Written by tools/make_third_party.py.
"""


@dataclasses.dataclass(frozen=True)
class Notice:
    """Who made a package, where its source is, and under which of tools/licences it is used."""

    source: str
    licence: str
    copyright: tuple[str, ...]


NOTICES = {
    "CLI11": Notice("https://github.com/CLIUtils/CLI11", "BSD-3-Clause", (
        "Copyright (c) 2017-2022 University of Cincinnati, developed by Henry Schreiner under NSF AWARD 1414736. All rights reserved.",)),
    "cloudlibc": Notice("https://github.com/NuxiNL/cloudlibc", "BSD-2-Clause", ("Copyright (c) 2015-2017 Nuxi (https://nuxi.nl/) and contributors",)),
    "compiler-rt": Notice("https://compiler-rt.llvm.org", "Apache-2.0-LLVM", ("Copyright (c) 2009-2019 the LLVM project's contributors",)),
    "dlmalloc": Notice("https://gee.cs.oswego.edu/dl/html/malloc.html", "CC0-1.0", ("Written by Doug Lea",)),
    "Eigen": Notice("https://gitlab.com/libeigen/eigen", "MPL-2.0", (
        "Copyright (C) 2006-2013 Benoit Jacob", "Copyright (C) 2008-2013 Gael Guennebaud", "and other authors, named in its source",)),
    "fast_float": Notice("https://github.com/fastfloat/fast_float", "MIT", ("Copyright (c) 2021 The fast_float authors",)),
    "fmt": Notice("https://github.com/fmtlib/fmt", "MIT", ("Copyright (c) 2012 - present, Victor Zverovich and {fmt} contributors",)),
    "libc++": Notice("https://libcxx.llvm.org", "Apache-2.0-LLVM", ("Copyright (c) 2009-2019 the LLVM project's contributors",)),
    "libc++abi": Notice("https://libcxxabi.llvm.org", "Apache-2.0-LLVM", ("Copyright (c) 2009-2019 the LLVM project's contributors",)),
    "musl": Notice("https://musl.libc.org", "MIT", ("Copyright (c) 2005-2020 Rich Felker, et al.",)),
    "nanobind": Notice("https://github.com/wjakob/nanobind", "BSD-3-Clause", (
        "Copyright (c) 2022 Wenzel Jakob <wenzel.jakob@epfl.ch>, All rights reserved.",)),
    "nlohmann-json": Notice("https://github.com/nlohmann/json", "MIT", (
        "Copyright (c) 2013-2022 Niels Lohmann", "Copyright (c) 2009 Florian Loitsch (its Grisu2)",
        "Copyright (c) 2008-2009 Bjoern Hoehrmann (its decoder of UTF-8)")),
    "SIMDe": Notice("https://github.com/simd-everywhere/simde", "MIT", (
        "Copyright (c) 2013-2021 Evan Nemerson <evan@nemerson.com>", "Copyright (c) 2015-2017 John W. Ratcliff <jratcliffscarab@gmail.com>",
        "Copyright (c) 2015 Brandon Rowlett <browlett@nvidia.com>", "Copyright (c) 2015 Ken Fast <kfast@gdeb.com>",
        "Copyright (c) 2017 Hasindu Gamaarachchi <hasindu@unsw.edu.au>", "Copyright (c) 2018 Jeff Daily <jeff.daily@amd.com>")),
    "three.js": Notice("https://threejs.org", "MIT", ("Copyright (c) 2010-2026 three.js authors",)),
    "tl::expected": Notice("https://github.com/TartanLlama/expected", "CC0-1.0", ("Written in 2017 by Simon Brand",)),
    "uPlot": Notice("https://github.com/leeoniya/uPlot", "MIT", ("Copyright (c) 2022 Leon Sorokin",)),
    "wasi-libc": Notice("https://github.com/WebAssembly/wasi-libc", "Apache-2.0-LLVM", ("Copyright (c) 2018-2020 Dan Gohman <sunfish@mozilla.com>", "and its contributors")),
}


def shipped(table):
    """The packages with `yes` in the column "shipped" of the table of dependencies in a document."""
    rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines() if line.startswith("|")]
    head = next(row for row in rows if row[0] == "package" and "shipped" in row)
    dependencies = rows[rows.index(head) + 2:]
    return {re.sub(r" ≥.*", "", name) for row in dependencies if row[head.index("shipped")] == "yes" for name in row[0].split(", ")}


def text(licences):
    parts = [HEAD]
    for name, notice in sorted(NOTICES.items(), key=lambda item: item[0].lower()):
        parts.append("\n".join([f"{name} ({notice.source})", *notice.copyright, f"Licence: {notice.licence}, below", ""]))
    for licence in sorted({notice.licence for notice in NOTICES.values()}):
        parts.append(f"{'-' * 80}\nLicence: {licence}\n\n" + (licences / f"{licence}.txt").read_text("utf-8"))
    return "\n".join(parts)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path, nargs="?", default=pathlib.Path(__file__).resolve().parents[1])
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    options = parser.parse_args()
    wanted = shipped((options.root / "CONTRIBUTING.md").read_text("utf-8"))
    if wanted != set(NOTICES):
        sys.exit(f"make_third_party.py: found notices for {sorted(set(NOTICES) - wanted)} that are not shipped, and none for "
                 f"{sorted(wanted - set(NOTICES))}, wanted those of the table in CONTRIBUTING.md")
    place, made = options.root / "THIRD_PARTY", text(options.root / "tools/licences")
    if not options.check:
        place.write_text(made, "utf-8")
    elif not place.exists() or place.read_text("utf-8") != made:
        sys.exit("make_third_party.py: found another THIRD_PARTY, wanted the one that tools/make_third_party.py writes")


if __name__ == "__main__":
    main()
