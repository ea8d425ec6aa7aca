#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Debian packages as users have them: debian_test.py FOLDER [--built].

They are built into FOLDER (with --built they lie there), judged by lintian and installed into a root of their own: by dpkg, and
by mmdebstrap where there is one, as a system in which nothing else is. There the command runs, man shows its pages, and
programs in C++ and C are built against the packages.
"""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
JOBS = os.environ.get("JOBS", "1")
ALLOWED = "initial-upload-closes-no-bugs"  # there is no bug of Debian's that asks for the package
TOOLS_IN_ROOT = ("cmake", "g++", "man-db", "ninja-build", "pkg-config")
USER = """cmake_minimum_required(VERSION 3.22)
project(user LANGUAGES CXX)
find_package(orispline REQUIRED COMPONENTS core io jobs shared)
foreach(kind orispline shared)
  add_executable(user_of_${kind} main.cpp)
  target_link_libraries(user_of_${kind} PRIVATE orispline::${kind})
endforeach()
"""


def ran(*words, **options):
    done = subprocess.run([str(word) for word in words], capture_output=True, text=True, check=False, **options)
    if done.returncode:
        raise AssertionError(f"{words} failed:\n{done.stdout[-4000:]}{done.stderr[-4000:]}")
    return done.stdout


def packages():
    return sorted(package for package in FOLDER.glob("*.deb") if "-dbgsym_" not in package.name)


class Judged(unittest.TestCase):
    def test_lintian_finds_nothing(self):
        if not shutil.which("lintian"):
            self.skipTest("no lintian here")
        for changes in FOLDER.glob("*.changes"):
            self.assertEqual(ran("lintian", "--allow-root", "--fail-on", "error,warning", "--suppress-tags", ALLOWED, changes), "")

    def test_everything_belongs_to_one_package(self):
        files = [line.split()[-1] for package in packages() for line in ran("dpkg-deb", "--contents", package).splitlines()
                 if not line.startswith("d")]
        self.assertEqual(len(files), len(set(files)))
        for name in ("usr/bin/orispline", "include/orispline/orispline.hpp", "include/orispline.h", "liborispline_core.a",
                     "vendor-completions/_orispline", "man1/orispline-sample.1.gz"):
            self.assertTrue(any(file.endswith(name) for file in files), name)

    def test_programs_depend_on_the_shared_libraries_by_name(self):
        for name in ("liborispline0", "liborispline-c"):
            package = next(package for package in packages() if package.name.startswith(name))
            with tempfile.TemporaryDirectory() as control:
                ran("dpkg-deb", "--control", package, control)
                self.assertIn(f" {package.name.partition('_')[0]} (>= ", pathlib.Path(control, "shlibs").read_text("utf-8"))


class Installed:
    """What is done in a root with the packages; `inside` begins a command there, `usr` is its folder for those commands."""

    inside: tuple = ()

    def copied(self, *sources):
        """A folder of the root with these files, as commands there name it."""
        folder = pathlib.Path(tempfile.mkdtemp(dir=self.root / "tmp"))
        for source in sources:
            (shutil.copytree if source.is_dir() else shutil.copy)(source, folder / source.name)
        return pathlib.Path("/") / folder.relative_to(self.root) if self.inside else folder

    def there(self, *words, **environment):
        settings = [f"{name}={value}" for name, value in ({"LC_ALL": "C.UTF-8"} | environment).items()]
        return ran(*self.inside, "env", *settings, *words)

    def libraries(self):
        here = next((self.root / "usr/lib").glob("*/liborispline_core.a")).parent
        return self.usr / here.relative_to(self.root / "usr")

    def test_the_command_runs(self):
        command, folder = self.usr / "bin/orispline", self.copied(ROOT / "examples/data/five_keys.csv")
        self.assertIn("orispline 0.", self.there(command, "--version"))
        samples = self.there(command, "sample", folder / "five_keys.csv", "--count", "11")
        self.assertEqual(len([line for line in samples.splitlines() if line[0].isdigit()]), 11)

    def test_man_shows_the_pages(self):
        for command in ("sample", "reduce"):
            page = self.there("man", "-l", self.usr / f"share/man/man1/orispline-{command}.1.gz", MANWIDTH="80", MAN_KEEP_FORMATTING="")
            self.assertIn(f"orispline {command} [OPTION]...", page)
        self.assertIn("--tolerance", page)

    def test_bash_reads_the_completions(self):
        self.there("bash", "-c", f". {self.usr}/share/bash-completion/completions/orispline && declare -F _orispline")

    def test_programs_find_the_archives_by_cmake(self):
        self.built_consumer("cmake", f"-DCMAKE_PREFIX_PATH={self.usr}", "-DCONSUMER_PARTS=ON")

    def test_programs_find_the_archives_by_pkg_config(self):
        self.built_consumer("pkg_config", f"-DPKG_CONFIG_FOLDER={self.libraries()}/pkgconfig")

    def built_consumer(self, tree, *options):
        folder = self.copied(ROOT / "tests/package/consumer")
        self.there("cmake", "-S", folder / "consumer", "-B", folder / tree, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Debug", "-DCMAKE_CXX_FLAGS_DEBUG=-O0", *options)
        self.there("cmake", "--build", folder / tree, "-j", JOBS)
        self.there("ctest", "--test-dir", folder / tree, "--output-on-failure")

    def test_a_program_may_link_the_shared_library(self):
        folder = self.copied(ROOT / "tests/package/consumer/main.cpp")
        place = self.root / folder.relative_to("/") if self.inside else folder
        (place / "CMakeLists.txt").write_text(USER, "utf-8")
        self.there("cmake", "-S", folder, "-B", folder / "tree", "-G", "Ninja", f"-DCMAKE_PREFIX_PATH={self.usr}")
        self.there("cmake", "--build", folder / "tree", "-j", JOBS)
        for kind, is_linked in (("orispline", False), ("shared", True)):
            program = folder / f"tree/user_of_{kind}"
            self.there(program)
            self.assertEqual("liborispline.so.0" in self.there("ldd", program), is_linked)
        self.assertIn(" -lorispline ", self.there("pkg-config", "--libs", "orispline_shared", PKG_CONFIG_PATH=self.libraries() / "pkgconfig"))

    def test_a_program_in_c(self):
        folder = self.copied(ROOT / "examples/11_in_c.c")
        settings = {"PKG_CONFIG_PATH": self.libraries() / "pkgconfig", "LD_LIBRARY_PATH": self.libraries()}
        options = self.there("pkg-config", "--cflags", "--libs", "orispline_c", **settings).split()
        self.there("cc", folder / "11_in_c.c", *options, "-o", folder / "program", **settings)
        self.assertEqual(self.there(folder / "program", **settings), (ROOT / "examples/expected/11_in_c.txt").read_text("utf-8"))


class ByDpkg(Installed, unittest.TestCase):
    """Beside the programs of this machine: what the packages depend on is here."""

    @classmethod
    def setUpClass(cls):
        cls.root = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory()))
        cls.usr = cls.root / "usr"
        for folder in ("info", "updates", "triggers"):
            (cls.root / "var/lib/dpkg" / folder).mkdir(parents=True)
        for file in ("status", "available"):
            (cls.root / "var/lib/dpkg" / file).touch()
        (cls.root / "tmp").mkdir()
        as_root = [] if os.geteuid() == 0 else ["fakeroot"]
        ran(*as_root, "dpkg", f"--root={cls.root}", "--force-depends", "--force-not-root", "--force-script-chrootless",
            "--path-include=/usr/share/man/*", f"--log={cls.root}/log", "--install", *packages())


@unittest.skipUnless(shutil.which("mmdebstrap"), "no mmdebstrap here")
class ByMmdebstrap(Installed, unittest.TestCase):
    """As a system in which nothing is but the packages, what they depend on, and compilers."""

    @classmethod
    def setUpClass(cls):
        if os.geteuid() != 0:
            raise unittest.SkipTest("only root may enter the root of another system")
        cls.root = pathlib.Path(cls.enterClassContext(tempfile.TemporaryDirectory())) / "system"
        cls.usr, cls.inside = pathlib.Path("/usr"), ("chroot", cls.root)
        release = dict(line.split("=", 1) for line in pathlib.Path("/etc/os-release").read_text("utf-8").splitlines() if "=" in line)
        files = ",".join(str(package.resolve()) for package in packages())
        made = subprocess.run(["mmdebstrap", "--variant=apt", "--mode=root", f"--include={','.join(TOOLS_IN_ROOT)}",
                               "--setup-hook=mkdir -p \"$1/tmp\"", f"--customize-hook=cp {files.replace(',', ' ')} \"$1/tmp\"",
                               "--customize-hook=chroot \"$1\" sh -c 'apt-get install --yes --no-install-recommends /tmp/*.deb'",
                               release["VERSION_CODENAME"], cls.root], capture_output=True, text=True, check=False)
        if made.returncode and not (cls.root / "usr/bin/cmake").exists():
            raise unittest.SkipTest(f"no system could be fetched: {made.stderr[-300:]}")
        if made.returncode:
            raise AssertionError(made.stderr[-4000:])


if __name__ == "__main__":
    FOLDER = pathlib.Path(sys.argv.pop(1)).resolve()
    if "--built" in sys.argv:
        sys.argv.remove("--built")
    else:
        ran(ROOT / "tools/make_deb.py", FOLDER, "--jobs", JOBS)
    unittest.main()
