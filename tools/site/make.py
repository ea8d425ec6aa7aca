#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Makes the site: make.py PYTHON INCLUDE FOLDER [--or-skip]

PYTHON is that of an environment with Sphinx and the Python package, as bindings/python/build.py makes it, INCLUDE has the headers that are
installed. FOLDER gets the site when it is whole: no warning, no link into the void. FOLDER-work is what it is made from.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys

import headers
import markup
import pages

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
MODULES = "furo, myst_parser, orispline, sphinx"


class Missing(Exception):
    """What is not on this machine, without which there is no site."""


def check_tools(python):
    if not shutil.which("doxygen"):
        raise Missing("found no doxygen, wanted the packages that `tools/setup.sh site` installs (Debian's name: doxygen)")
    if not python.exists() or subprocess.run([python, "-c", f"import {MODULES}"], capture_output=True, check=False).returncode:
        raise Missing(f"found no environment with {MODULES} at {python}, wanted the Python package (make python)")


def write_headers(include, work, source, public):
    """The pages of the C++ library, from the XML that Doxygen writes on the way."""
    place = f'INPUT = "{include}/orispline"\nSTRIP_FROM_PATH = "{include}"\nSTRIP_FROM_INC_PATH = "{include}"\nOUTPUT_DIRECTORY = "{work}"\n'
    settings = (HERE / "Doxyfile").read_text("utf-8") + place
    subprocess.run(["doxygen", "-"], input=settings, text=True, check=True)
    for name, text in headers.pages(include, work / "xml", public).items():
        pages.Pages.put(source, f"cpp/{name}.md", text)


def make(python, include, folder):
    work = folder.with_name(folder.name + "-work")
    source, site = work / "source", work / "site"
    shutil.rmtree(work, ignore_errors=True)
    source.mkdir(parents=True)
    repository = pages.Pages(ROOT)
    repository.write(source)
    write_headers(include, work, source, repository.headers)
    shutil.copytree(ROOT / "bindings/python/reference", source / "python")
    subprocess.run([python, "-m", "sphinx", "-W", "--keep-going", "-q", "-c", HERE, "-d", work / "doctrees", source, site], check=True)
    for unwanted in ("objects.inv", ".buildinfo"):
        (site / unwanted).unlink(missing_ok=True)
    subprocess.run([sys.executable, ROOT / "tests/site/check_html.py", ROOT, site], check=True)
    shutil.rmtree(folder, ignore_errors=True)
    os.rename(site, folder)
    print(f"site: {folder}/index.html")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("python", type=pathlib.Path)
    parser.add_argument("include", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--or-skip", action="store_true", help="succeed where what it needs is not here, and say so")
    options = parser.parse_args()
    try:
        check_tools(options.python)
        make(options.python, options.include.resolve(), options.folder.resolve())
    except Missing as missing:
        shutil.rmtree(options.folder, ignore_errors=True)  # one of before would be taken for this one
        sys.exit(print(f"site: skipped: {missing}") if options.or_skip else f"site: {missing}")
    except markup.Fault as fault:
        sys.exit(f"site: {fault}")
    except subprocess.CalledProcessError as failure:
        sys.exit(f"site: {' '.join(map(str, failure.cmd))} ended with {failure.returncode}")


if __name__ == "__main__":
    main()
