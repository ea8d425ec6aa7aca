# SPDX-License-Identifier: Apache-2.0
"""One wheel for every Python from 3.10 on: it is imported by each that this machine has."""
import functools
import pathlib
import shutil
import subprocess
import sys

import pytest
from conftest import wheel

USE = """
import orispline as ori
curve = ori.Curve([0, 1, 3], [[0, 0, 0, 1], [0, 0, 0.6, 0.8], [0, 0, 1, 0]])
print(curve, curve.sample(rate=2, derivatives=3).angular_jerks.shape)
"""


def answers(python, *words, **options):
    return subprocess.run([python, *words], capture_output=True, text=True, check=False, **options)


@functools.cache
def pythons():
    """Version -> program, of those that are not this one."""
    places = [shutil.which(f"python3.{minor}") for minor in range(10, 16)]
    places += sorted(pathlib.Path.home().glob(".pyenv/versions/3.*/bin/python"))
    found = {}
    for place in filter(None, places):
        done = answers(place, "-c", "import sys; print(*sys.version_info[:2], sep='.') if sys.implementation.name == 'cpython' else 0")
        version = done.stdout.strip()
        if done.returncode == 0 and "." in version and (3, 10) <= tuple(map(int, version.split("."))) != sys.version_info[:2]:
            found.setdefault(version, place)
    return found


@pytest.mark.skipif(not wheel(), reason="no wheel beside the tests")
@pytest.mark.parametrize("version", [f"3.{minor}" for minor in range(10, 15) if minor != sys.version_info.minor])
def test_the_wheel_is_for(version, tmp_path):
    python = pythons().get(version)
    if not python:
        pytest.skip(f"found no Python {version}, wanted python{version} on the path or among the versions of pyenv")
    install = answers(sys.executable, "-m", "pip", "install", "--quiet", "--disable-pip-version-check", "--python-version", version,
                      "--only-binary=:all:", "--no-compile", "--target", tmp_path, wheel())
    if "No matching distribution found for" in install.stderr or "Could not fetch" in install.stderr:
        pytest.skip("what it needs cannot be had: " + install.stderr.splitlines()[-1])
    assert install.returncode == 0, install.stderr
    done = answers(python, "-I", "-B", "-c", f"import sys; sys.path.insert(0, {str(tmp_path)!r}){USE}")
    assert done.stdout == "Curve('auto', 3 keys, 0 … 3 s, C²) (7, 3)\n", done.stderr
