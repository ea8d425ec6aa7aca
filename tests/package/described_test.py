#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the command says of itself is installed where man and the shells look for it: described_test.py COMMAND MAN1 DATA."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

PLACES = {"bash": "bash-completion/completions/orispline", "zsh": "zsh/site-functions/_orispline",
          "fish": "fish/vendor_completions.d/orispline.fish"}


def pages_in(folder):
    return {path.name: path.read_bytes() for path in folder.iterdir()}


class Described(unittest.TestCase):
    def test_manual_pages(self):
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([COMMAND, "help", "--manual-pages", folder], check=True)
            self.assertEqual(pages_in(MAN1), pages_in(pathlib.Path(folder)))
        self.assertIn("orispline-sample.1", pages_in(MAN1))

    def test_completions(self):
        for shell, place in PLACES.items():
            script = subprocess.run([COMMAND, "completion", shell], check=True, capture_output=True).stdout
            self.assertEqual((DATA / place).read_bytes(), script)


if __name__ == "__main__":
    COMMAND, MAN1, DATA = (pathlib.Path(sys.argv.pop(1)) for _ in range(3))
    unittest.main()
