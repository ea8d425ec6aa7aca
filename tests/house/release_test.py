#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What `make release` refuses, in small repositories, and that what it packs has the same bytes every time."""
import contextlib
import gzip
import io
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import unittest
from unittest import mock

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
sys.dont_write_bytecode = True
import make_third_party as parts  # noqa: E402
import recipes  # noqa: E402
import release  # noqa: E402
from make_third_party import NOTICES  # noqa: E402

VERSION, DAY = "3.4.5", "2030-01-02"
CHANGELOG = f"# Changelog\n\n## Unreleased\n\n## {VERSION} ({DAY})\n\n### Added\n- Much.\n\n## 0.1.0 (2020-01-01)\n- Little.\n"


class Repository:
    """The files of the project that state a version, ready for a release."""

    def __init__(self, folder):
        self.root = pathlib.Path(folder) / "project"
        for path in ("CMakeLists.txt", *recipes.VERSIONED):
            self.write(path, (ROOT / path).read_text("utf-8"))
        self.replace("CMakeLists.txt", f"VERSION {recipes.version_of(ROOT)}", f"VERSION {VERSION}")
        recipes.set_versions(self.root)
        self.write("CITATION.cff", re.sub(r"(?m)^date-released: .*$", f"date-released: {DAY}", self.read("CITATION.cff")))
        self.write("CHANGELOG.md", CHANGELOG)
        self.write("tools/setup.sh", "#!/bin/sh\n")
        (self.root / "tools/setup.sh").chmod(0o755)
        self.git("init", "--quiet")
        self.commit()

    def read(self, path):
        return (self.root / path).read_text("utf-8")

    def write(self, path, text):
        (self.root / path).parent.mkdir(parents=True, exist_ok=True)
        (self.root / path).write_text(text, "utf-8")

    def replace(self, path, old, new):
        self.write(path, self.read(path).replace(old, new))

    def git(self, *words):
        who = ("-c", "user.name=x", "-c", "user.email=x@x.invalid", "-c", "commit.gpgsign=false")
        subprocess.run(["git", *who, *words], cwd=self.root, check=True, capture_output=True)

    def commit(self):
        self.git("add", "-A")
        self.git("commit", "--quiet", "-m", "All")


@unittest.skipUnless(shutil.which("git"), "git is not here")
class Release(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.repository = Repository(folder.name)
        self.root = self.repository.root
        self.out = pathlib.Path(folder.name) / "out"
        commands, release.COMMANDS = release.COMMANDS, {"git": "git"}
        self.addCleanup(setattr, release, "COMMANDS", commands)

    def refusal(self, version=VERSION, out=None):
        with self.assertRaises(release.Refused) as refused:
            release.check_all(self.root, version, out or self.out)
        sentence = str(refused.exception)
        self.assertNotIn("\n", sentence)
        self.assertRegex(sentence, "^found .*wanted ")
        self.assertFalse(self.out.exists())
        return sentence

    def test_all_in_order_is_taken(self):
        release.check_all(self.root, VERSION, self.out)

    def test_what_is_no_version_is_refused(self):
        for version in ("", "3.4", "v3.4.5", "3.4.05", "3.4.5-rc1", "../3.4.5", "3.4.5\n"):
            self.assertIn("wanted three numbers such as 0.2.0", self.refusal(version))

    def test_another_version_is_refused_by_the_file_that_states_it(self):
        self.assertIn(f"found version {VERSION} in CMakeLists.txt, wanted 3.5.0", self.refusal("3.5.0"))
        for path in recipes.VERSIONED:
            there = self.repository.read(path)
            self.repository.write(path, recipes.with_version(path, there, "9.9.9"))
            self.assertIn(f"found version 9.9.9 in {path}", self.refusal())
            self.repository.write(path, there)

    def test_changes_are_refused_but_for_releases(self):
        self.repository.write("earlier/SHA256SUMS", "")
        self.repository.write("packaging/abi/liborispline.so.3.4.abi", "")
        release.check_all(self.root, VERSION, self.out)
        self.repository.write("left behind.txt", "")
        self.assertIn("left behind.txt among them", self.refusal())

    def test_entries_that_are_not_released_are_refused(self):
        self.repository.replace("CHANGELOG.md", "## Unreleased\n", "## Unreleased\n\n### Fixed\n- A fault.\n")
        self.repository.commit()
        self.assertIn(f"found entries under Unreleased in CHANGELOG.md, wanted them under {VERSION}", self.refusal())

    def test_a_version_that_the_changelog_lacks_and_another_day_are_refused(self):
        for old, new in ((f"## {VERSION} ({DAY})", "## 3.4.51 (2030-01-02)"), (f"({DAY})", "(2030-01-03)")):
            self.repository.write("CHANGELOG.md", CHANGELOG.replace(old, new))
            self.repository.commit()
            self.assertIn(f'found no heading "## {VERSION} ({DAY})" in CHANGELOG.md', self.refusal())

    def test_a_folder_that_is_there_is_refused(self):
        self.assertIn(f"found {self.root}, wanted a folder that is not there yet", self.refusal(out=self.root))
        self.assertIn("wanted it to be there", self.refusal(out=self.out / "deeper/out"))

    def test_packages_that_are_missing_are_named(self):
        self.repository.write("tools/setup.sh", "#!/bin/sh\n[ \"$1\" = --missing ] && echo ccache debhelper\n")
        release.COMMANDS = {"no-such-command-here": "npm"}
        self.assertIn("found no debhelper, npm, wanted these packages of Debian", self.refusal())

    def stamp_all(self):
        for part in release.CHECKS:
            release.stamp(self.root, part)

    def test_a_stamp_is_of_a_part_of_the_commit_and_of_a_clean_tree(self):
        self.repository.write(".gitignore", "/build/\n")
        self.repository.commit()
        self.assertEqual(release.unchecked(self.root), list(release.CHECKS))
        release.stamp(self.root, "clang")
        self.assertEqual(release.unchecked(self.root), [part for part in release.CHECKS if part != "clang"])
        self.stamp_all()
        self.assertEqual(release.unchecked(self.root), [])
        self.repository.write("more.txt", "")
        self.assertEqual(release.unchecked(self.root), list(release.CHECKS))
        with contextlib.redirect_stdout(io.StringIO()) as said:
            self.stamp_all()
        self.assertIn("no stamp for test, for there are changes", said.getvalue())
        self.repository.commit()
        self.assertEqual(release.unchecked(self.root), list(release.CHECKS))

    def test_every_part_of_the_check_is_a_target(self):
        makefile = (ROOT / "Makefile").read_text("utf-8")
        targets = {name for line in re.findall(r"(?m)^([\w -]+):(?!=)", makefile) for name in line.split()}
        self.assertLessEqual(set(release.CHECKS), targets)

    def test_parts_that_were_not_built_are_refused_by_name(self):
        with self.assertRaisesRegex(release.Refused, r"found 0 files build/python/dist/orispline-3.4.5-\*.whl, wanted 1"):
            release.found_parts(self.root, VERSION)

    def test_a_build_that_fails_leaves_nothing(self):
        self.repository.write("Makefile", "check:\n\t@false\n")
        self.repository.commit()
        with self.assertRaisesRegex(release.Refused, "found that `make check` failed"), open(os.devnull, "w") as nowhere:
            standard = os.dup(2)
            os.dup2(nowhere.fileno(), 2)
            try:
                release.release(self.root, VERSION, self.out)
            finally:
                os.dup2(standard, 2)
                os.close(standard)
        self.assertEqual([path.name for path in self.out.parent.iterdir()], ["project"])

    def build_parts(self):
        """Stands for what `make release-parts` leaves."""
        self.repository.write(".gitignore", "/build/\n")
        for path in ("packaging/source.json", "studio/package-lock.json", "THIRD_PARTY"):
            self.repository.write(path, (ROOT / path).read_text("utf-8"))
        self.repository.commit()
        for path in (f"python/dist/orispline-{VERSION}-cp310-abi3-any.whl", f"python/dist/orispline-{VERSION}.tar.gz", "studio/studio.html", "npm/lite.wasm",
                     *(f"deb/{name}_{VERSION}-1_amd64.deb" for name in ("orispline", "liborispline-dev", "liborispline3.4"))):
            self.repository.write(f"build/{path}", path)
        self.stamp_all()

    def test_a_folder_is_complete_and_has_the_same_sums_twice(self):
        self.build_parts()
        self.enterContext(mock.patch.object(release, "make", side_effect=lambda *_: self.repository.write(release.PAGE, "page")))
        self.enterContext(mock.patch.object(release.abi, "write", return_value=[]))
        self.enterContext(mock.patch.object(release, "pack_npm", lambda root, part: (part / f"orispline-{VERSION}.tgz").touch()))
        self.enterContext(contextlib.redirect_stdout(io.StringIO()))
        outs = self.root / "a", self.root / "b"  # within the tree, as `make release OUT=a` has it
        for out in outs:
            release.release(self.root, VERSION, out)
        one, two = ((out / "SHA256SUMS").read_text("utf-8") for out in outs)
        self.assertEqual(one, two)
        self.assertCountEqual([line.split()[1] for line in one.splitlines()], [
            f"orispline-{VERSION}-source.tar.gz", f"orispline-{VERSION}-recipes.tar.gz", f"orispline-{VERSION}.spdx.json", f"orispline-{VERSION}.tgz",
            f"orispline-{VERSION}-cp310-abi3-any.whl", f"orispline-{VERSION}.tar.gz", "studio.html", "THIRD_PARTY",
            *(f"{name}_{VERSION}-1_amd64.deb" for name in ("orispline", "liborispline-dev", "liborispline3.4"))])
        self.assertEqual(release.make.call_args_list, 2 * [mock.call(self.root, "release-parts")])
        self.assertEqual(list(self.root.glob("*.part")), [])

    def test_a_page_that_is_not_made_anew_leaves_nothing(self):
        self.build_parts()
        self.enterContext(mock.patch.object(release, "make"))
        with self.assertRaisesRegex(release.Refused, "found no build/studio/studio.html"):
            release.release(self.root, VERSION, self.out)
        self.assertEqual([path.name for path in self.out.parent.iterdir()], ["project"])

    def test_the_sources_have_the_same_bytes_in_another_clone(self):
        clone = self.out.parent / "clone-elsewhere"
        subprocess.run(["git", "clone", "--quiet", self.root, clone], check=True)
        one, two = (release.source_archive(root, "HEAD", VERSION) for root in (self.root, clone))
        self.assertEqual(one, two)
        names = tarfile.open(fileobj=io.BytesIO(gzip.decompress(one))).getnames()
        self.assertIn(f"orispline-{VERSION}/CMakeLists.txt", names)

    def test_a_packed_folder_tells_nothing_of_the_machine(self):
        def pack(seconds):
            os.utime(self.root / "CMakeLists.txt", (seconds, seconds))
            return release.packed(self.root, "p", 5)
        self.assertEqual(pack(1000), pack(2000))
        entry = tarfile.open(fileobj=io.BytesIO(gzip.decompress(pack(1)))).getmember("p/CMakeLists.txt")
        self.assertEqual((entry.mtime, entry.uname, entry.uid), (5, "", 0))

    def test_sums_are_as_sha256sum_checks_them(self):
        self.out.mkdir()
        for name in ("b", "a"):
            (self.out / name).write_text(name, "utf-8")
        (self.out / "SHA256SUMS").write_text(release.sums(self.out), "utf-8")
        done = subprocess.run(["sha256sum", "--check", "SHA256SUMS"], cwd=self.out, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stdout), (0, "a: OK\nb: OK\n"))

    def test_files_that_differ_are_named(self):
        self.assertEqual(release.different("1  a\n2  b\n3  c\n", "1  a\n9  b\n4  d\n"), ["b", "c", "d"])


class Spdx(unittest.TestCase):
    def test_every_notice_has_a_version_or_is_within_a_part_that_has_one(self):
        self.assertEqual(set(parts.versions(ROOT)), set(NOTICES))
        self.assertEqual(set(parts.OF_DEBIAN) | set(parts.IN_THE_PAGE) | set(parts.OF_PYTHON) | set(parts.WITHIN), set(NOTICES))

    def test_the_document_has_every_part_once_and_within_something(self):
        made = parts.spdx_document("1.2.3", "0" * 40, "2030-01-02T00:00:00Z", {name: "7" for name in NOTICES})
        names = [package["name"] for package in made["packages"]]
        self.assertCountEqual(names, [*NOTICES, "orispline", "studio.html"])
        held = {relation["relatedSpdxElement"] for relation in made["relationships"]}
        self.assertEqual(held, {package["SPDXID"] for package in made["packages"]})
        page = [relation["relatedSpdxElement"] for relation in made["relationships"] if relation["spdxElementId"] == "SPDXRef-studio.html"]
        self.assertCountEqual(page, ["SPDXRef-three.js", "SPDXRef-uPlot"])


if __name__ == "__main__":
    unittest.main()
