#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The recipes by which others pack orispline, and the version that files state.

recipes.py version: writes the version of CMakeLists.txt into each file that states one.
recipes.py fill ARCHIVE FOLDER: the recipes in FOLDER, with the sums of the archive of sources, and with its address where
packaging/source.json has one. In the repository they keep their place: nobody invents a sum.
"""
import argparse
import hashlib
import json
import pathlib
import re
import shutil
import sys

ROOT = pathlib.Path(__file__).resolve().parents[1]
SYSTEMS = ("vcpkg", "conan", "conda", "homebrew")

# Where a file states the version: what stands before it and behind it, as patterns of lines.
VERSIONED = {
    "CITATION.cff": ("^version: ", "$"),
    "bindings/npm/package.json": ('^  "version": "', '",$'),
    "bindings/npm/package-lock.json": ('"name": "orispline",\n +"version": "', '",$'),
    "package.xml": ("<version>", "</version>"),
    "packaging/vcpkg/vcpkg.json": ('"version-semver": "', '"'),
    "packaging/conan/conanfile.py": ('^    version = "', '"$'),
    "packaging/conan/conandata.yml": ('^  "', '":$'),
    "packaging/conda/recipe.yaml": ('^  version: "', '"$'),
    "packaging/homebrew/orispline.rb": ('^  version "', '"$'),
}


def version_of(root):
    """That of the project: CMakeLists.txt states it."""
    return re.search(r"(?m)^  VERSION (\d+\.\d+\.\d+)$", (root / "CMakeLists.txt").read_text("utf-8"))[1]


def stated_version(path, text):
    """What the text of a file of VERSIONED says, or none where it says nothing or two things."""
    before, behind = VERSIONED[path]
    found = set(re.findall(rf"{before}(\d+\.\d+\.\d+){behind}", text, re.M))
    return found.pop() if len(found) == 1 else None


def with_version(path, text, version):
    before, behind = VERSIONED[path]
    return re.sub(rf"({before})\d+\.\d+\.\d+(?={behind})", rf"\g<1>{version}", text, flags=re.M)


def set_versions(root):
    version = version_of(root)
    for path in VERSIONED:
        place = root / path
        place.write_text(with_version(path, place.read_text("utf-8"), version), "utf-8")


def places_for(archive, source, version):
    """What the places in the recipes are filled with; an address that is not known yet keeps its place."""
    content = archive.read_bytes()
    filled = {"@SHA256@": hashlib.sha256(content).hexdigest(), "@SHA512@": hashlib.sha512(content).hexdigest()}
    if source["archive"]:
        filled["@ARCHIVE@"] = source["archive"].replace("{version}", version)
    if source["repository"]:
        filled["@REPOSITORY@"] = source["repository"]
    return filled


def fill(root, archive, folder):
    source = json.loads((root / "packaging/source.json").read_text("utf-8"))
    filled = places_for(archive, source, version_of(root))
    for system in SYSTEMS:
        shutil.copytree(root / "packaging" / system, folder / system, ignore=shutil.ignore_patterns("__pycache__"))
    for path in sorted(path for path in folder.rglob("*") if path.is_file()):
        text = path.read_text("utf-8")
        for place, value in filled.items():
            text = text.replace(place, value)
        path.write_text(text, "utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    orders = parser.add_subparsers(dest="order", required=True)
    orders.add_parser("version")
    filling = orders.add_parser("fill")
    filling.add_argument("archive", type=pathlib.Path)
    filling.add_argument("folder", type=pathlib.Path)
    options = parser.parse_args()
    if options.order == "version":
        return set_versions(ROOT)
    if not options.archive.is_file():
        sys.exit(f"recipes.py: found no file {options.archive}, wanted the archive of sources that `make release` writes")
    if options.folder.exists():
        sys.exit(f"recipes.py: found {options.folder}, wanted a folder that is not there yet")
    return fill(ROOT, options.archive, options.folder)


if __name__ == "__main__":
    main()
