#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the Debian packages: make_deb.py [FOLDER] [--jobs N] [--tree].

FOLDER (build/deb) is made anew: a copy of what is compiled with the folder debian/ at its root, and beside it the packages.
What packaging/debian holds is for every version: the version, its numbers in the names of packages and the notices are put in
here, from where the project states them. With --tree only the copy is made. Nothing is fetched; ccache is used where it is.
"""
import argparse
import email.utils
import os
import pathlib
import re
import shutil
import subprocess
import sys
import textwrap

from make_third_party import NOTICES
from recipes import version_of

ROOT = pathlib.Path(__file__).resolve().parents[1]
PARTS = ("CMakeLists.txt", "LICENSE", "NOTICE", "THIRD_PARTY", "README.md", "CHANGELOG.md", "bindings/c", "cli", "cmake", "docs", "examples", "papers", "src")
TOOLS = {"dpkg-buildpackage": "dpkg-dev", "dh": "debhelper", "fakeroot": "fakeroot"}
COMPILED_IN = ("CLI11", "Eigen", "fast_float", "fmt", "nlohmann-json", "tl::expected")
PAGE, IN_PAGE = "src/orispline/report/page_template.html", ("three.js", "uPlot")
OURS = "2026 The orispline developers"


def words():
    """What stands between two @ in the files of packaging/debian."""
    version = version_of(ROOT)
    c_abi = re.search(r"#define ORISPLINE_C_ABI (\d+)", (ROOT / "bindings/c/orispline.h").read_text("utf-8"))[1]
    return {"VERSION": version, "SERIES": version.rpartition(".")[0], "C_ABI": c_abi,
            "DATE": email.utils.formatdate(source_time())}


def source_time():
    """When this source was made: SOURCE_DATE_EPOCH, else its commit, else the day of the archive that it came in."""
    if "SOURCE_DATE_EPOCH" in os.environ:
        return int(os.environ["SOURCE_DATE_EPOCH"])
    commit = subprocess.run(["git", "-C", ROOT, "log", "-1", "--format=%ct"], capture_output=True, text=True, check=False)
    return int(commit.stdout) if commit.returncode == 0 else int((ROOT / "CHANGELOG.md").stat().st_mtime)


def filled(text, values):
    return re.sub(r"@([A-Z_]+)@", lambda match: values[match[1]], text)


def indented(text):
    return "".join(f" {line or '.'}\n" for line in text.strip().splitlines())


def copyrights(name):
    return [re.sub(r"Copyright \(c\) ", "", line, flags=re.I) for line in NOTICES[name].copyright]


def copyright_file():
    """In the form DEP 5. What is compiled in has no files here; its notices are a comment."""
    compiled = "\n\n".join("\n".join([f"{name} ({NOTICES[name].source})", *NOTICES[name].copyright, f"Licence: {NOTICES[name].licence}"])
                           for name in COMPILED_IN)
    in_page = [line for name in IN_PAGE for line in copyrights(name)]
    mit = (ROOT / "tools/licences/MIT.txt").read_text("utf-8")
    apache = textwrap.fill('Licensed under the Apache License, Version 2.0; on Debian systems its text is in the file "/usr/share/common-licenses/Apache-2.0".')
    return "".join([
        "Format: https://www.debian.org/doc/packaging-manuals/copyright-format/1.0/\nUpstream-Name: orispline\n"
        "Upstream-Contact: The orispline developers\nSource: the archive of the release, made by the project itself\n"
        "Comment:\n", indented("The binary packages hold compiled code of the packages below, whose licences are in the file\nTHIRD_PARTY beside this one.\n\n" + compiled),
        f"\nFiles: *\nCopyright: {OURS}\nLicense: Apache-2.0\n",
        f"\nFiles: {PAGE}\nCopyright: {OURS}\n", indented("\n".join(in_page)), "License: Apache-2.0 and Expat\n"
        f"Comment: The page has {' and '.join(IN_PAGE)} in it, under the licence Expat.\n",
        "\nLicense: Apache-2.0\n", indented(apache), "\nLicense: Expat\n", indented(mit)])


def make_tree(folder):
    """The source with its folder debian/, as dpkg-buildpackage wants it."""
    values = words()
    tree = folder / f"orispline-{values['VERSION']}"
    for part in PARTS:
        (tree / part).parent.mkdir(parents=True, exist_ok=True)
        copy = shutil.copytree if (ROOT / part).is_dir() else shutil.copy2
        copy(ROOT / part, tree / part, **({"ignore": shutil.ignore_patterns("__pycache__", "node_modules")} if copy is shutil.copytree else {}))
    put_studio(tree)
    for file in sorted((ROOT / "packaging/debian").rglob("*")):
        if file.is_file():
            name = str(file.relative_to(ROOT / "packaging/debian")).removesuffix(".in")
            place = tree / "debian" / name.replace("SERIES", values["SERIES"]).replace("cABI", f"c{values['C_ABI']}")
            place.parent.mkdir(parents=True, exist_ok=True)
            place.write_text(filled(file.read_text("utf-8"), values), "utf-8")
            place.chmod(file.stat().st_mode)
    (tree / "debian/copyright").write_text(copyright_file(), "utf-8")
    return tree


def put_studio(tree):
    """The page that the command has in it, where it is built."""
    page = pathlib.Path("build/studio/studio.html")
    if not (ROOT / page).is_file():
        print("make_deb.py: the command in the packages will have no studio, for its page was not built; 'make studio' builds it", file=sys.stderr)
        return
    (tree / page.parent).mkdir(parents=True)
    shutil.copy2(ROOT / page, tree / page)


def check_tools():
    missing = {tool: package for tool, package in TOOLS.items() if not shutil.which(tool)}
    if missing:
        *others, last = missing
        sys.exit(f"make_deb.py: found no {' and '.join(filter(None, (', '.join(others), last)))}; install the packages {' '.join(missing.values())}")


def build(tree, jobs):
    environment = dict(os.environ)
    environment["DEB_BUILD_OPTIONS"] = f"parallel={jobs} {environment.get('DEB_BUILD_OPTIONS', '')}".strip()
    if shutil.which("ccache") and "CCACHE_DIR" not in environment:  # debhelper takes the home folder away
        environment["CCACHE_DIR"] = subprocess.run(["ccache", "--get-config", "cache_dir"], check=True, capture_output=True, text=True).stdout.strip()
    done = subprocess.run(["dpkg-buildpackage", "--no-sign", "--build=binary"], cwd=tree, env=environment, check=False)
    if done.returncode:
        sys.exit(f"make_deb.py: the packages could not be built in {tree}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path, nargs="?", default=ROOT / "build/deb")
    parser.add_argument("--jobs", type=int, default=1, help="compile so many files at once")
    parser.add_argument("--tree", action="store_true", help="make the copy of the source only")
    options = parser.parse_args()
    if not options.tree:
        check_tools()
    shutil.rmtree(options.folder, ignore_errors=True)
    tree = make_tree(options.folder)
    if not options.tree:
        build(tree, options.jobs)


if __name__ == "__main__":
    main()
