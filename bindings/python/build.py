#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Builds the Python package: build.py FOLDER [PREFIX] [--sdist].

The wheel goes into FOLDER/dist, by the tools in the virtual environment FOLDER/venv, where it is installed with what its tests
need. With PREFIX, where an orispline is installed, only the module is compiled, else the library too. What it prints last
begins with `skipped:` where Python's headers, its module venv or the package index are not there.
"""
import argparse
import pathlib
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import venv

ROOT = pathlib.Path(__file__).resolve().parents[2]


def skip(reason):
    sys.exit(print(f"skipped: {reason}"))


def run(*words, **options):
    subprocess.run([str(word) for word in words], check=True, **options)


def environment(folder):
    """Its Python; the environment is made where it is not there."""
    if sys.version_info < (3, 11):
        skip(f"found Python {sys.version.split()[0]}, wanted 3.11 for the tools")
    if not (pathlib.Path(sysconfig.get_path("include")) / "Python.h").exists():
        skip("Python's headers are not here (Debian's python3-dev)")
    python = folder / "bin/python"
    if not python.exists():
        try:
            venv.create(folder, with_pip=True, clear=True)
        except subprocess.CalledProcessError:
            skip("Python's module venv is not here (Debian's python3-venv)")
    project = tomllib.loads((ROOT / "pyproject.toml").read_text("utf-8"))
    wanted = [*project["build-system"]["requires"], *project["project"]["dependencies"],
              *project["dependency-groups"]["test"], "build", "ninja"]
    if subprocess.run([python, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", *wanted], check=False).returncode:
        skip("the packages that building needs cannot be installed")
    return python


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("prefix", type=pathlib.Path, nargs="?")
    parser.add_argument("--sdist", action="store_true")
    options = parser.parse_args()
    folder = options.folder.resolve()
    python = environment(folder / "venv")
    dist = folder / "dist"
    shutil.rmtree(dist, ignore_errors=True)
    words = ["--wheel", *(["--sdist"] if options.sdist else []), f"-Cbuild-dir={folder}/tree"]
    if options.prefix:
        words.append(f"-Ccmake.define.CMAKE_PREFIX_PATH={options.prefix.resolve()}")
    run(python, "-m", "build", "--no-isolation", "--skip-dependency-check", "--outdir", dist, *words, ROOT)
    wheel, = dist.glob("*.whl")
    run(python, "-m", "pip", "install", "--quiet", "--force-reinstall", "--no-deps", wheel)
    print(f"{wheel.name}: {wheel.stat().st_size / 1e6:.2f} MB, installed in {folder / 'venv'}")


if __name__ == "__main__":
    main()
