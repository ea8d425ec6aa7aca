# SPDX-License-Identifier: Apache-2.0
"""The pages of docs/tutorials: their lines run as they stand, print what they say, and draw their pictures."""
import pathlib
import re

from command import SUCCESS, CommandTest, main, with_pages

ROOT = pathlib.Path(__file__).resolve().parents[2]
TUTORIALS = ROOT / "docs/tutorials"
BLOCK = re.compile(r"^```(sh|text)\n(.*?)^```", re.M | re.S)


class Tutorials(CommandTest):
    @with_pages
    def test_what_they_show_is_so(self):
        pages = sorted(TUTORIALS.glob("*.md"))
        self.assertGreater(len(pages), 3)
        (self.folder / "examples").symlink_to(ROOT / "examples")
        for page in pages:
            text, printed = page.read_text("utf-8"), ""
            for kind, block in BLOCK.findall(text):
                for line in block.splitlines():
                    if kind == "text":
                        self.assertIn(line, printed, page.name)
                        continue
                    done = self.run_command(line.removeprefix("orispline "))
                    self.assertEqual(done.returncode, SUCCESS, f"{page.name}: {line}: {done.stderr}")
                    printed += done.stdout + done.stderr
            for picture in re.findall(r"\]\((\w+\.svg)\)", text):
                drawn = self.read(picture)
                self.assertEqual((TUTORIALS / picture).read_text("utf-8"), drawn, f"{picture} differs, wanted: the line of {page.name} that draws it")


if __name__ == "__main__":
    main()
