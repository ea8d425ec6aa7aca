#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What tools/abi.py says of a small library and of what becomes of it."""
import contextlib
import io
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
import abi  # noqa: E402

NAME = "liborispline.so.0.2"
HEADER = "namespace orispline {{ struct Pose {{ double x; {more} }}; double length(const Pose& pose); {names} }}\n"
SOURCE = "#include <pose.hpp>\nnamespace orispline {{ double length(const Pose& pose) {{ return pose.x; }} {bodies} }}\n"


@unittest.skipUnless(shutil.which("abidw"), "skipped: abidw is not here (Debian's abigail-tools)")
class Interface(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.enterContext(mock.patch.object(abi, "KEPT", self.folder / "kept"))
        self.enterContext(contextlib.redirect_stdout(io.StringIO()))

    def built(self, more="", names="", bodies=""):
        """As `make deb` leaves a library."""
        deb = self.folder / "deb"
        shutil.rmtree(deb, ignore_errors=True)
        include, objects = deb / "orispline-1/debian/tmp/usr/include", deb / "orispline-1/obj-x/src"
        include.mkdir(parents=True)
        objects.mkdir(parents=True)
        (include / "pose.hpp").write_text(HEADER.format(more=more, names=names), "utf-8")
        subprocess.run(["c++", "-g", "-shared", "-fPIC", f"-Wl,-soname,{NAME}", "-I", include, "-x", "c++", "-", "-o", objects / NAME],
                       input=SOURCE.format(bodies=bodies), text=True, check=True)
        return deb

    def test_what_is_kept_is_named_after_the_shared_object_and_small(self):
        written, = abi.write(self.built(), self.folder / "kept")
        self.assertEqual(written.name, f"{NAME}.abi")
        text = written.read_text("utf-8")
        self.assertIn("Pose", text)
        self.assertNotIn(str(self.folder), text)

    def test_the_same_and_a_name_that_came_work(self):
        abi.write(self.built(), self.folder / "kept")
        self.assertTrue(abi.compare(self.built()))
        self.assertTrue(abi.compare(self.built(names="double width();", bodies="double width() { return 1; }")))

    def test_a_member_that_came_and_a_name_that_went_do_not(self):
        abi.write(self.built(names="double width();", bodies="double width() { return 1; }"), self.folder / "kept")
        self.assertFalse(abi.compare(self.built()))
        abi.write(self.built(), self.folder / "kept")
        self.assertFalse(abi.compare(self.built(more="double y;")))

    def test_a_first_one_has_nothing_to_be_compared_with(self):
        self.assertTrue(abi.compare(self.built()))

    def test_without_a_build_it_says_what_makes_one(self):
        with self.assertRaisesRegex(SystemExit, "run make deb"):
            abi.libraries(self.folder)


if __name__ == "__main__":
    unittest.main()
