#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tests/site/check_html.py on a small site."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CHECK = pathlib.Path(__file__).resolve().parents[2] / "tests/site/check_html.py"
FRONT = '<div class="sidebar-tree"><div><a href="docs/page.html">A page</a></div></div><img src="front.svg"><a href="docs/page.html#part">b</a>'


class CheckHtml(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        for name, text in {
            "docs/page.md": "# A page\n",
            "site/index.html": FRONT,
            "site/docs/page.html": '<h2 id="part">Part</h2><a href="../index.html?v=1">a</a><a href="https://a.b/c">c</a><a href="#part">d</a>',
            "site/front.svg": "", "site/style.css": "a { background: url('front.svg') }",
        }.items():
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            (self.root / name).write_text(text, "utf-8")

    def assert_finds(self, *faults):
        done = subprocess.run([sys.executable, CHECK, self.root, self.root / "site"], capture_output=True, text=True, check=False)
        self.assertEqual((done.returncode, done.stderr.splitlines()), (1 if faults else 0, [f"check_html: {fault}" for fault in faults]))

    def change(self, name, before, after):
        path = self.root / name
        text = path.read_text("utf-8")
        self.assertIn(before, text)
        path.write_text(text.replace(before, after), "utf-8")

    def test_a_whole_site_is_silent(self):
        self.assert_finds()

    def test_a_picture_that_was_not_copied(self):
        (self.root / "site/front.svg").unlink()
        self.assert_finds("index.html: front.svg is not in the site")

    def test_a_link_and_an_anchor_into_the_void(self):
        self.change("site/docs/page.html", "../index.html", "../gone.html")
        self.change("site/docs/page.html", 'id="part"', 'id="other"')
        self.assert_finds("docs/page.html: #part has no such anchor", "docs/page.html: ../gone.html?v=1 is not in the site",
                          "index.html: docs/page.html#part has no such anchor")

    def test_a_page_that_is_not_in_the_side_bar(self):
        self.change("site/index.html", 'class="sidebar-tree"', 'class="text"')
        self.assert_finds("docs/page.md: is not in the side bar")

    def test_what_comes_from_elsewhere(self):
        self.change("site/index.html", "front.svg", "//a.b/front.svg")
        self.change("site/docs/page.html", "<h2", '<script src="https://a.b/count.js"></script><h2')
        self.change("site/style.css", "front.svg", "https://a.b/font.woff2")
        self.assert_finds("docs/page.html: loads https://a.b/count.js", "index.html: loads //a.b/front.svg", "style.css: loads https://a.b/font.woff2")


if __name__ == "__main__":
    unittest.main()
