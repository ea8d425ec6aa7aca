# SPDX-License-Identifier: Apache-2.0
"""The SPDX 2.3 document of a release: which code of others is compiled into what, in which version, under which licence."""
import json
import pathlib
import re
import subprocess

from make_third_party import NOTICES

LICENCES = {"Apache-2.0-LLVM": "Apache-2.0 WITH LLVM-exception"}  # the others are named in tools/licences as SPDX does
IN_THE_PAGE = {"three.js": "three", "uPlot": "uplot"}  # by their names for npm
OF_PYTHON = {"nanobind": "nanobind"}
OF_DEBIAN = {
    "CLI11": "libcli11-dev", "compiler-rt": "libclang-rt-22-dev-wasm32", "Eigen": "libeigen3-dev", "fast_float": "libfast-float-dev",
    "fmt": "libfmt-dev", "libc++": "libc++-22-dev-wasm32", "libc++abi": "libc++abi-22-dev-wasm32", "nlohmann-json": "nlohmann-json3-dev",
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


def document(version, commit, created, part_versions):
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
