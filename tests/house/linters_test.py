#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Linters of others on recipes, workflows, the citation and the SPDX document: linters_test.py FOLDER, where they are installed from a package index.
Skipped (77) where none is to be had."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest
import venv

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
import make_third_party  # noqa: E402

LINTERS = ("check-jsonschema>=0.30", "catkin_pkg>=1", "conan>=2", "spdx-tools>=0.8")
SCHEMAS = ("cffconvert==2.0.0",)  # installed for its schemas alone: it wants an old jsonschema
PARSE_PACKAGE = "import sys; from catkin_pkg.package import parse_package; p = parse_package(sys.argv[1]); p.validate(); print(p.name, p.version, p.get_build_type())"


def pip(folder, *words):
    quick = ["--quiet", "--disable-pip-version-check", "--retries", "0", "--timeout", "20"]
    return subprocess.run([folder / "bin/python", "-m", "pip", "install", *quick, *words], capture_output=True, text=True, check=False)


def install(folder):
    """The linters, once for each list of them; where that fails, why."""
    stamp, wanted = folder / "complete", "\n".join(LINTERS + SCHEMAS)
    if stamp.exists() and stamp.read_text("utf-8") == wanted:
        return None
    try:
        venv.create(folder, with_pip=True, clear=True)
    except subprocess.CalledProcessError:
        return "Python's module venv is not here (Debian's python3-venv)"
    for done in (pip(folder, *LINTERS), pip(folder, "--no-deps", *SCHEMAS)):
        if done.returncode:
            return "no package index has " + ", ".join(LINTERS + SCHEMAS) + "\n" + done.stderr
    stamp.write_text(wanted, "utf-8")
    return None


class Linters(unittest.TestCase):
    def run_linter(self, *words, **environment):
        done = subprocess.run([FOLDER / "bin" / words[0], *words[1:]], env={**os.environ, **environment}, capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_workflows_are_as_their_schema_says(self):
        files = sorted((ROOT / ".github/workflows").glob("*.yml"))
        self.assertEqual(len(files), 3)
        self.run_linter("check-jsonschema", "--builtin-schema", "vendor.github-workflows", *files)

    def test_the_citation_is_as_its_schema_says(self):
        [schema] = FOLDER.glob("lib/python*/site-packages/cffconvert/schemas/1.2.0/schema.json")
        self.run_linter("check-jsonschema", "--schemafile", schema, ROOT / "CITATION.cff")

    def test_ros_reads_the_package(self):
        self.assertRegex(self.run_linter("python", "-c", PARSE_PACKAGE, ROOT / "package.xml"), r"^orispline \d+\.\d+\.\d+ cmake\n$")

    def test_conan_takes_the_recipe(self):
        with tempfile.TemporaryDirectory() as home:
            self.run_linter("conan", "export", ROOT / "packaging/conan", CONAN_HOME=home)
            self.assertIn("orispline/", self.run_linter("conan", "list", "orispline/*", CONAN_HOME=home))

    def test_the_spdx_document_is_valid(self):
        with tempfile.TemporaryDirectory() as place:
            path = pathlib.Path(place, "orispline.spdx.json")
            path.write_text(json.dumps(make_third_party.spdx_document("1.2.3", "0" * 40, "2030-01-02T00:00:00Z", make_third_party.versions(ROOT))), "utf-8")
            self.run_linter("pyspdxtools", "-i", path)


if __name__ == "__main__":
    FOLDER = pathlib.Path(sys.argv.pop(1))
    absent = install(FOLDER)
    if absent:
        print(f"skipped: {absent}")
        sys.exit(77)
    unittest.main()
