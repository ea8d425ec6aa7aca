#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""setup.sh on machines of our own making: a search path with few commands, and an apt that writes down its orders."""
import pathlib
import shutil
import subprocess
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "tools" / "setup.sh"
APT = """#!/bin/sh
echo "$@" >> "{log}"
case "$*" in *install*) {on_install} ;; esac
"""


class Machine:
    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        self.log = self.folder / "apt.log"
        self.bin = self.folder / "bin"
        self.bin.mkdir()
        for command in ("cat", "chmod", "env", "grep", "id", "tr"):
            (self.bin / command).symlink_to(shutil.which(command))

    def add_command(self, name, text="#!/bin/sh\n"):
        (self.bin / name).write_text(text, "utf-8")
        (self.bin / name).chmod(0o755)

    def add_header(self, name):
        header = self.folder / "include" / name
        header.parent.mkdir(parents=True, exist_ok=True)
        header.touch()

    def add_apt(self, on_install):
        self.add_command("sudo", '#!/bin/sh\nexec "$@"\n')
        self.add_command("apt-cache")
        self.add_command("apt-get", APT.format(log=self.log, on_install=on_install.format(bin=self.bin)))

    def setup(self, *groups):
        environment = {"PATH": str(self.bin), "CMAKE_PREFIX_PATH": str(self.folder)}
        return subprocess.run(["/bin/sh", SCRIPT, *groups], env=environment, capture_output=True, text=True, check=False)

    def orders(self):
        return self.log.read_text("utf-8").splitlines() if self.log.exists() else []


class Setup(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.machine = Machine(folder.name)

    def test_asks_nothing_of_apt_when_all_is_there(self):
        self.machine.add_command("doxygen")
        self.machine.add_apt("exit 1")
        run = self.machine.setup("site")
        self.assertEqual((run.returncode, run.stdout, run.stderr, self.machine.orders()), (0, "", "", []))

    def test_installs_only_what_is_missing(self):
        self.machine.add_command("gcovr")
        self.machine.add_header("fuzzer/FuzzedDataProvider.h")
        self.machine.add_apt("echo > {bin}/clang++; chmod +x {bin}/clang++")
        run = self.machine.setup("check")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        options = "-qq -o DPkg::Lock::Timeout=600"
        self.assertEqual(self.machine.orders(),
                         [f"{options} update", f"{options} install -y --no-install-recommends clang"])

    def test_fails_and_names_the_package_when_apt_fails(self):
        self.machine.add_command("clang++")
        self.machine.add_apt("exit 100")
        run = self.machine.setup("tidy")
        self.assertEqual(run.returncode, 1)
        self.assertIn("not here (Debian's names of the packages): clang-tidy-22\n", run.stderr)

    def test_fails_and_names_the_packages_without_apt(self):
        self.machine.add_header("fuzzer/FuzzedDataProvider.h")
        run = self.machine.setup("check", "tidy")
        self.assertEqual(run.returncode, 1)
        self.assertIn("clang gcovr clang clang-tidy-22\nsetup: install them, then try again\n", run.stderr)

    def test_finds_the_headers_of_the_compiler_itself(self):
        for command in ("clang++", "gcovr"):
            self.machine.add_command(command)
        header = self.machine.folder / "lib/llvm-19/lib/clang/19/include/fuzzer/FuzzedDataProvider.h"
        header.parent.mkdir(parents=True)
        header.touch()
        run = self.machine.setup("check")
        self.assertEqual((run.returncode, run.stderr), (0, ""))

    def test_goes_on_without_what_is_only_welcome(self):
        for header in ("gtest/gtest.h", "rapidcheck.h"):
            self.machine.add_header(header)
        for command in ("clang++", "python3"):
            self.machine.add_command(command)
        run = self.machine.setup("test")
        self.assertEqual((run.returncode, run.stderr),
                         (0, "setup: not here (Debian's names of the packages): pkg-config clang-format-14 universal-ctags nodejs npm chromium chromium-headless-shell\n"))

    def test_only_names_what_is_missing_where_that_is_asked_for(self):
        self.machine.add_apt("exit 1")
        self.machine.add_command("clang++")
        header = self.machine.folder / "lib/llvm-19/lib/clang/19/include/fuzzer/FuzzedDataProvider.h"
        header.parent.mkdir(parents=True)
        header.touch()
        run = self.machine.setup("--missing", "check", "tidy")
        self.assertEqual((run.returncode, run.stdout, run.stderr, self.machine.orders()), (0, "gcovr clang-tidy-22\n", "", []))
        self.machine.add_command("run-clang-tidy-22")
        self.assertEqual(self.machine.setup("--missing", "tidy").stdout, "")

    def test_asks_python_for_its_modules(self):
        self.machine.add_command("python3-config")
        self.machine.add_command("python3", '#!/bin/sh\n[ "$2" = "import ensurepip" ]\n')
        run = self.machine.setup("python")
        self.assertEqual((run.returncode, run.stderr), (0, ""))
        self.machine.add_command("python3", "#!/bin/sh\nexit 1\n")
        run = self.machine.setup("python")
        self.assertEqual((run.returncode, run.stderr), (0, "setup: not here (Debian's names of the packages): python3-venv\n"))


if __name__ == "__main__":
    unittest.main()
