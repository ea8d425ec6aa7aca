#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tools/check_html.py on small folders, and on what Doxygen makes of the documents where it is here."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
CHECK = ROOT / "tools/check_html.py"


def checked(root, folder):
    return subprocess.run([sys.executable, CHECK, root, folder], capture_output=True, text=True, check=False)


class CheckHtml(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name, text in {
            "README.md": "# Front\n\n![A picture](docs/front.svg)\n",
            "docs/page.md": "# The `page`\n\n![Two\nlines](page.svg)\n",
            "html/index.html": '<img src="front.svg"/><a href="md_page.html#part">code</a><a href="https://a.b/c">d</a>',
            "html/md_page.html": '<div class="title">The <code>page</code> </div><object data="page.svg"></object>',
            "html/front.svg": "", "html/page.svg": "",
        }.items():
            (self.root / name).parent.mkdir(exist_ok=True)
            (self.root / name).write_text(text, "utf-8")

    def assert_finds(self, *faults):
        done = checked(self.root, self.root / "html")
        self.assertEqual((done.returncode, done.stderr.splitlines()), (1, [f"check_html: {fault}" for fault in faults]))

    def change(self, name, before, after):
        path = self.root / name
        text = path.read_text("utf-8")
        self.assertIn(before, text)
        path.write_text(text.replace(before, after), "utf-8")

    def test_a_whole_folder_is_silent(self):
        done = checked(self.root, self.root / "html")
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_picture_that_was_not_copied(self):
        (self.root / "html/page.svg").unlink()
        self.assert_finds("docs/page.md: page.svg is not in the HTML", "md_page.html: page.svg is not in the HTML")

    def test_a_picture_that_is_not_shown(self):
        self.change("html/md_page.html", 'data="page.svg"', "")
        self.assert_finds("docs/page.md: its page does not show page.svg")

    def test_a_page_that_is_missing(self):
        (self.root / "html/md_page.html").unlink()
        self.assert_finds("docs/page.md: no page has its title, 'The page'", "index.html: md_page.html#part is not in the HTML")

    def test_text_that_is_shown_as_it_was_typed(self):
        self.change("html/index.html", ">code<", ">`code`<")
        self.change("html/md_page.html", "</object>", "</object>\n@image html other.svg")
        self.assert_finds("index.html: shows '<a href=\"md_page.html#part\">`code`</a>'", "md_page.html: shows '@image html other.svg'")

    @unittest.skipUnless(shutil.which("doxygen"), "Doxygen is not here")
    def test_the_documents_are_whole_in_html(self):
        (self.root / "docs/page.md").unlink()
        settings = (ROOT / "docs/Doxyfile").read_text("utf-8")
        settings += f"\nINPUT = README.md CHANGELOG.md CONTRIBUTING.md SECURITY.md CODE_OF_CONDUCT.md docs\nOUTPUT_DIRECTORY = {self.root}\nHTML_OUTPUT = made\nAUTOLINK_SUPPORT = NO\n"
        done = subprocess.run(["doxygen", "-"], input=settings, cwd=ROOT, capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        done = checked(ROOT, self.root / "made")
        self.assertEqual((done.returncode, done.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
