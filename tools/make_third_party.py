#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes THIRD_PARTY, the notices for the code of others in what is shipped: make_third_party.py [ROOT] [--check].

What is shipped stands in the table of dependencies of docs/building.md; each package in it has to be among `NOTICES`, and no
other. With --check the file is compared only. Texts of licences are in tools/licences. tools/release.py has the same packages from
here for the SPDX document of a release.
"""
import argparse
import dataclasses
import json
import pathlib
import re
import subprocess
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
    "meshoptimizer": Notice("https://github.com/zeux/meshoptimizer", "MIT", ("Copyright (c) 2016-2022 Arseny Kapoulkine",)),
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


# ---------------------------------------------------------------- the SPDX 2.3 document of a release: which code of others is compiled into what

LICENCES = {"Apache-2.0-LLVM": "Apache-2.0 WITH LLVM-exception"}  # the others are named in tools/licences as SPDX does
IN_THE_PAGE = {"three.js": "three", "uPlot": "uplot"}  # by their names for npm
OF_PYTHON = {"nanobind": "nanobind"}
OF_DEBIAN = {
    "CLI11": "libcli11-dev", "compiler-rt": "libclang-rt-22-dev-wasm32", "Eigen": "libeigen3-dev", "fast_float": "libfast-float-dev",
    "fmt": "libfmt-dev", "libc++": "libc++-22-dev-wasm32", "libc++abi": "libc++abi-22-dev-wasm32", "meshoptimizer": "libmeshoptimizer-dev", "nlohmann-json": "nlohmann-json3-dev",
    "SIMDe": "libsimde-dev", "tl::expected": "libexpected-dev", "wasi-libc": "wasi-libc"}
WITHIN = {"cloudlibc": "wasi-libc", "dlmalloc": "wasi-libc", "musl": "wasi-libc"}  # copies, which have no version of their own


def version_of_debian(package):
    done = subprocess.run(["dpkg-query", "-W", "-f", "${Version}", package], capture_output=True, text=True, check=False)
    return done.stdout or None


def version_of_npm(lock, package):
    return json.loads(lock.read_text("utf-8"))["packages"][f"node_modules/{package}"]["version"]


def version_of_python(environment, package):
    places = sorted(pathlib.Path(environment).glob(f"lib/python*/site-packages/{package}-*.dist-info"))
    return places[0].name.removeprefix(f"{package}-").removesuffix(".dist-info") if places else None


def versions(root):
    """Of each part, as it was compiled in on this machine; none where it cannot be told."""
    found = {name: version_of_debian(package) for name, package in OF_DEBIAN.items()}
    found |= {name: version_of_npm(root / "studio/package-lock.json", package) for name, package in IN_THE_PAGE.items()}
    found |= {name: version_of_python(root / "build/python/venv", package) for name, package in OF_PYTHON.items()}
    return found | dict.fromkeys(WITHIN)


def reference(name):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", name)


def entry(name, version, licence, copyright_text, homepage=None):
    stated = {"name": name, "SPDXID": reference(name), "downloadLocation": "NOASSERTION", "filesAnalyzed": False,
              "licenseConcluded": licence, "licenseDeclared": licence, "copyrightText": copyright_text}
    return stated | ({"versionInfo": version} if version else {}) | ({"homepage": homepage} if homepage else {})


def part(name, version):
    notice = NOTICES[name]
    return entry(name, version, LICENCES.get(notice.licence, notice.licence), "\n".join(notice.copyright), notice.source)


def spdx_document(version, commit, created, part_versions):
    """The document as an object; `created` is a time as ISO 8601 writes it, and `part_versions` has every part of NOTICES."""
    ours = ("Apache-2.0", "Copyright The orispline developers")
    packages = [entry("orispline", version, *ours), entry("studio.html", version, *ours)]
    packages += [part(name, part_versions[name]) for name in sorted(NOTICES, key=str.lower)]
    holders = {**dict.fromkeys(NOTICES, "orispline"), **WITHIN, **dict.fromkeys(IN_THE_PAGE, "studio.html"), "studio.html": "orispline"}
    relations = [("SPDXRef-DOCUMENT", "DESCRIBES", reference("orispline"))]
    relations += [(reference(holder), "CONTAINS", reference(name)) for name, holder in holders.items()]
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"orispline-{version}",
        "documentNamespace": f"https://spdx.org/spdxdocs/orispline-{version}-{commit}",
        "creationInfo": {"created": created, "creators": ["Organization: The orispline developers", "Tool: orispline-tools-spdx"]},
        "packages": packages,
        "relationships": [{"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other} for one, kind, other in relations],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("root", type=pathlib.Path, nargs="?", default=pathlib.Path(__file__).resolve().parents[1])
    parser.add_argument("--check", action="store_true", help="compare, and write nothing")
    options = parser.parse_args()
    wanted = shipped((options.root / "docs/building.md").read_text("utf-8"))
    if wanted != set(NOTICES):
        sys.exit(f"make_third_party.py: found notices for {sorted(set(NOTICES) - wanted)} that are not shipped, and none for "
                 f"{sorted(wanted - set(NOTICES))}, wanted those of the table in docs/building.md")
    place, made = options.root / "THIRD_PARTY", text(options.root / "tools/licences")
    if not options.check:
        place.write_text(made, "utf-8")
    elif not place.exists() or place.read_text("utf-8") != made:
        sys.exit("make_third_party.py: found another THIRD_PARTY, wanted the one that tools/make_third_party.py writes")


if __name__ == "__main__":
    main()
