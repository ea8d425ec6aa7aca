#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes a release: release.py make VERSION [OUT], whose folder is build/release-VERSION unless OUT names another.

The folder is there complete or not at all. It has the sources, the packages of Python, Debian and npm, the studio's page, notices,
an SPDX document, the recipes with the sum of the sources, and SHA256SUMS. Everything is counted from the commit, its time too.
release.py unchecked: prints the parts of `make check` that have not passed for this commit, all of them where the tree has changes.
release.py stamp PART: notes that a part has passed for this commit, if the tree is clean.
release.py twice FOLDER: makes the files of a release in two clones in FOLDER, and tells which of them differ.
"""
import argparse
import datetime
import gzip
import hashlib
import io
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile

import abi
import make_third_party
import recipes

ROOT = pathlib.Path(__file__).resolve().parents[1]
CHECKS = ("test", "clang", "sanitizers", "tsan")  # the parts of `make check`
STAMPS = "build/checked"  # the folder of the commits that they passed for
NOT_NEEDED = {"ccache"}
GROUPS = ("build", "python", "wasm", "deb")  # of tools/setup.sh: without one of their packages a part of the release would be missing
COMMANDS = {"git": "git", "npm": "npm"}  # and their packages
# What `make release-parts` leaves, and how many of each there are at least.
PARTS = {"build/python/dist/orispline-{version}-*.whl": 1, "build/python/dist/orispline-{version}.tar.gz": 1, "build/deb/*_{version}-*.deb": 3}
PAGE = "build/studio/studio.html"
COPIED = (PAGE, "THIRD_PARTY")


class Refused(Exception):
    """Why there is no release: what was found, what was wanted, and the cure."""


def git(root, *words):
    return subprocess.run(["git", "-C", root, *words], capture_output=True, text=True, check=True).stdout.strip()


def check_version(root, version):
    """VERSION is one, and the one that every file states."""
    if not re.fullmatch(r"(0|[1-9]\d*)(\.(0|[1-9]\d*)){2}", version):
        raise Refused(f"found the version {version!r}, wanted three numbers such as 0.2.0: make release VERSION=0.2.0")
    stated = {"CMakeLists.txt": recipes.version_of(root)}
    stated |= {path: recipes.stated_version(path, (root / path).read_text("utf-8")) for path in recipes.VERSIONED}
    for path, found in stated.items():
        if found != version:
            raise Refused(f"found version {found} in {path}, wanted {version}: write it in CMakeLists.txt, then run tools/recipes.py version")


def section(changelog, heading):
    """The text below a heading of the changelog up to the next one, and what stands behind the heading; none where it is not there."""
    found = re.search(rf"(?ms)^## {re.escape(heading)}\b([^\n]*)\n(.*?)(?=^## |\Z)", changelog)
    return found and (found[1].strip(), found[2])


def check_changelog(root, version):
    """Nothing is unreleased, and the version has a section with the day of the citation."""
    changelog = (root / "CHANGELOG.md").read_text("utf-8")
    unreleased = section(changelog, "Unreleased")
    if unreleased and re.search(r"(?m)^- ", unreleased[1]):
        raise Refused(f"found entries under Unreleased in CHANGELOG.md, wanted them under {version}")
    found = section(changelog, version)
    day = re.search(r"(?m)^date-released: (\S+)$", (root / "CITATION.cff").read_text("utf-8"))
    if not found or not day or found[0] != f"({day[1]})":
        raise Refused(f"found no heading \"## {version} ({day[1] if day else 'YYYY-MM-DD'})\" in CHANGELOG.md, wanted it with the day that "
                      "date-released of CITATION.cff has")


def changes(root):
    """Paths that are not as in the commit, but for folders of releases and what a release has written beside them."""
    lines = git(root, "status", "--porcelain", "-z").split("\0")
    paths = [line.split(maxsplit=1)[1] for line in lines if len(line.split(maxsplit=1)) > 1]
    return [path for path in paths if not (root / path / "SHA256SUMS").is_file() and not path.startswith(f"{abi.FOLDER}/")]


def check_tree(root):
    changed = changes(root)
    if changed:
        raise Refused(f"found changes that are not committed, {changed[0]} among them, wanted a clean tree")


def check_out(out):
    for place in (out, part_of(out)):
        if place.exists():
            raise Refused(f"found {place}, wanted a folder that is not there yet: remove it, or name another one with OUT=")
    if not out.parent.is_dir():
        raise Refused(f"found no folder {out.parent}, wanted it to be there")


def check_tools(root):
    """Every package by its name, before anything is built."""
    listed = subprocess.run([root / "tools/setup.sh", "--missing", *GROUPS], capture_output=True, text=True, check=False).stdout.split()
    absent = sorted((set(listed) - NOT_NEEDED) | {package for command, package in COMMANDS.items() if not shutil.which(command)})
    if absent:
        raise Refused(f"found no {', '.join(absent)}, wanted these packages of Debian: run tools/setup.sh {' '.join(GROUPS)}")


def part_of(out):
    """The folder that becomes OUT when it is complete."""
    return out.with_name(out.name + ".part")


def source_archive(root, commit, version):
    """The bytes of the archive of sources: the same wherever and whenever they are made."""
    tar = subprocess.run(["git", "-C", root, "archive", "--format=tar", f"--prefix=orispline-{version}/", commit], capture_output=True, check=True).stdout
    return compressed(tar)


def compressed(content):
    """As `gzip -n` does: without a name and without a time."""
    return gzip.compress(content, compresslevel=9, mtime=0)


def packed(folder, prefix, time):
    """A folder as the bytes of a .tar.gz in which nothing tells of the machine."""
    buffer = io.BytesIO()
    with tarfile.open(fileobj=buffer, mode="w", format=tarfile.PAX_FORMAT) as archive:
        for path in sorted(path for path in folder.rglob("*") if path.is_file()):
            entry = tarfile.TarInfo(f"{prefix}/{path.relative_to(folder).as_posix()}")
            entry.size, entry.mtime, entry.mode = path.stat().st_size, time, 0o644
            with path.open("rb") as content:
                archive.addfile(entry, content)
    return compressed(buffer.getvalue())


def filled_recipes(root, archive, version, time):
    with tempfile.TemporaryDirectory() as place:
        recipes.fill(root, archive, pathlib.Path(place, "recipes"))
        return packed(pathlib.Path(place, "recipes"), f"orispline-{version}-recipes", time)


def found_parts(root, version):
    """The packages that were built, none of them missing."""
    found = []
    for pattern, least in PARTS.items():
        here = sorted(root.glob(pattern.format(version=version)))
        if len(here) < least:
            raise Refused(f"found {len(here)} files {pattern.format(version=version)}, wanted {least}: see what `make release-parts` says")
        found += here
    for path in COPIED:
        if not (root / path).is_file():
            raise Refused(f"found no {path}, wanted it: see what `make release-parts` says")
    return [*found, *(root / path for path in COPIED)]


def pack_npm(root, part):
    """npm gives each file of a package the same time."""
    if not list((root / "build/npm").glob("*.wasm")):
        raise Refused("found no modules in build/npm, wanted those of WebAssembly: run tools/setup.sh wasm")
    subprocess.run(["npm", "pack", "--silent", "--ignore-scripts", "--pack-destination", part], cwd=root / "build/npm", check=True, stdout=subprocess.DEVNULL)


def sums(folder):
    """SHA256SUMS, as sha256sum checks it."""
    files = sorted(path for path in folder.iterdir() if path.name != "SHA256SUMS")
    return "".join(f"{hashlib.sha256(path.read_bytes()).hexdigest()}  {path.name}\n" for path in files)


def spdx_text(root, version, commit, time):
    created = datetime.datetime.fromtimestamp(time, datetime.timezone.utc).strftime("%Y-%m-%dT%H:%M:%SZ")
    return json.dumps(make_third_party.spdx_document(version, commit, created, make_third_party.versions(root)), indent=2) + "\n"


def write(root, part, version):
    """All files of the release."""
    commit, time = git(root, "rev-parse", "HEAD"), int(git(root, "log", "-1", "--format=%ct"))
    archive = part / f"orispline-{version}-source.tar.gz"  # not the name of the source of the Python package
    archive.write_bytes(source_archive(root, commit, version))
    (part / f"orispline-{version}-recipes.tar.gz").write_bytes(filled_recipes(root, archive, version, time))
    for path in found_parts(root, version):
        shutil.copy(path, part)
    pack_npm(root, part)
    (part / f"orispline-{version}.spdx.json").write_text(spdx_text(root, version, commit, time), "utf-8")
    (part / "SHA256SUMS").write_text(sums(part), "utf-8")


def make(root, *words):
    """A target of the Makefile by its own rules, not by the options of the one that called us."""
    environment = {name: value for name, value in os.environ.items() if name not in ("MAKEFLAGS", "MAKELEVEL", "VERSION", "OUT")}
    environment["SOURCE_DATE_EPOCH"] = git(root, "log", "-1", "--format=%ct")
    environment["DEB_BUILD_OPTIONS"] = "noautodbgsym"  # what debuggers read is thirty times as long as all else
    done = subprocess.run(["make", *words], cwd=root, env=environment, check=False)
    if done.returncode:
        raise Refused(f"found that `make {' '.join(words)}` failed, wanted it to pass; nothing was written")


def unchecked(root):
    commit = None if changes(root) else git(root, "rev-parse", "HEAD")
    stamps = {part: root / STAMPS / part for part in CHECKS}
    return [part for part, stamp in stamps.items() if not stamp.is_file() or stamp.read_text("utf-8").strip() != commit]


def stamp(root, part):
    if changes(root):
        return print(f"release.py: no stamp for {part}, for there are changes that are not committed")
    (root / STAMPS).mkdir(parents=True, exist_ok=True)
    return (root / STAMPS / part).write_text(git(root, "rev-parse", "HEAD") + "\n", "utf-8")


def check_all(root, version, out):
    check_version(root, version)
    check_tools(root)
    check_tree(root)
    check_changelog(root, version)
    check_out(out)


def release(root, version, out):
    check_all(root, version, out)
    if unchecked(root):
        make(root, "check")
    (root / PAGE).unlink(missing_ok=True)  # where the studio cannot be built its rule keeps the earlier page
    make(root, "release-parts")
    check_tree(root)
    part = part_of(out)
    part.mkdir()
    try:
        write(root, part, version)
        part.rename(out)
    finally:
        shutil.rmtree(part, ignore_errors=True)
    print(f"{out}/SHA256SUMS")
    for path in abi.write(root / "build/deb", root / abi.FOLDER):
        print(f"{path}: commit it")


def different(one, two):
    """The names of files whose sums differ, or that one of both has not; each argument is a text of SHA256SUMS."""
    lines = set(one.splitlines()) ^ set(two.splitlines())
    return sorted({line.split("  ", 1)[1] for line in lines})


def twice(root, folder):
    """What a release of this commit would have, made in two folders whose names have not the same length."""
    check_tools(root)
    names = ("one", "another")
    for name in names:  # both before anything is built, which takes long enough for another commit
        subprocess.run(["git", "clone", "--quiet", root, folder / name], check=True)
    texts = []
    for name in names:
        tree, out = folder / name, folder / f"{name}-files"
        make(tree, "release-parts")
        out.mkdir()
        write(tree, out, recipes.version_of(tree))
        texts.append((out / "SHA256SUMS").read_text("utf-8"))
    others = different(*texts)
    if others:
        raise Refused(f"found other bytes the second time in {', '.join(others)}, wanted the same ones")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    orders = parser.add_subparsers(dest="order", required=True)
    orders.add_parser("unchecked")
    orders.add_parser("stamp").add_argument("part", choices=CHECKS)
    making = orders.add_parser("make")
    making.add_argument("version")
    making.add_argument("out", type=pathlib.Path, nargs="?")
    doubling = orders.add_parser("twice")
    doubling.add_argument("folder", type=pathlib.Path)
    options = parser.parse_args()
    if options.order == "unchecked":
        return print(*unchecked(ROOT))
    if options.order == "stamp":
        return stamp(ROOT, options.part)
    try:
        if options.order == "twice":
            return twice(ROOT, options.folder.absolute())
        return release(ROOT, options.version, (options.out or ROOT / f"build/release-{options.version}").absolute())
    except Refused as refusal:
        return sys.exit(f"release.py: {refusal}")


if __name__ == "__main__":
    main()
