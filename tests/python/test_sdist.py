# SPDX-License-Identifier: Apache-2.0
"""The source package has what it is built from, and nothing else that lies in its folder."""
import pathlib
import shutil
import subprocess
import sys
import tarfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
TOP = ["CHANGELOG.md", "CITATION.cff", "CMakeLists.txt", "LICENSE", "NOTICE", "README.md", "THIRD_PARTY", "pyproject.toml"]
SHIPPED = ["bindings/python/CMakeLists.txt", "cli/main.cpp", "cmake/units.cmake", "examples/data/keys.csv", "papers/one.cpp", "src/orispline/one.hpp"]
NOT_SHIPPED = ["0.3.0/SHA256SUMS", "build/release/one.o", "docs/README.md", "notes.txt", "packaging/abi/one.abi", "src/orispline/__pycache__/one.pyc", "tests/python/test_sdist.py"]


def test_only_what_is_stated_is_shipped(tmp_path):
    tree, out = tmp_path / "tree", tmp_path / "out"
    for path in [*SHIPPED, *NOT_SHIPPED]:
        (tree / path).parent.mkdir(parents=True, exist_ok=True)
        (tree / path).touch()
    for path in TOP:
        shutil.copy(ROOT / path, tree)
    subprocess.run([sys.executable, "-m", "build", "--no-isolation", "--skip-dependency-check", "--sdist", tree, "--outdir", out], check=True, capture_output=True)
    made, = out.glob("*.tar.gz")
    with tarfile.open(made) as archive:
        names = [name.partition("/")[2] for name in archive.getnames()]
    assert sorted(names) == sorted(["PKG-INFO", *TOP, *SHIPPED])
