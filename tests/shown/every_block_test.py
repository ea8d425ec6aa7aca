#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""No block of a page is forgotten: each is of a kind that a test takes, and whoever adds one of another kind hears of it."""
import collections
import re
import unittest

from pages import PAGES, all_blocks, blocks, outputs_of

TAKEN = {  # the use of a block, and what takes it
    "sh": "lines_test.py",
    "session": "lines_test.py",
    "output": "lines_test.py; of examples compiled_test.py; of Python tests/python/test_documents.py",
    "rows": "lines_test.py",
    "formula": "nothing: it is for people",
    "cpp": "compiled_test.py",
    "c": "compiled_test.py",
    "cmake": "compiled_test.py",
    "python": "tests/python/test_documents.py",
    "js": "scripts_test.py",
    "ts": "studio/viewer/tests/viewer.test.mjs",
}


class EveryBlock(unittest.TestCase):
    def test_every_block_is_taken(self):
        found = collections.Counter(block.use for block in all_blocks())
        self.assertEqual(set(found), set(TAKEN))
        print("blocks of pages:", ", ".join(f"{count} {use}" for use, count in found.most_common()))

    def test_every_output_is_of_some_code(self):
        for page in PAGES:
            said = sum(block.use == "output" for block in blocks(page))
            self.assertEqual(said, sum(len(outputs_of(page, kind)) for kind in ("sh", "python", "example")), page)

    def test_every_fence_is_a_block(self):
        for page in PAGES:
            fences = re.findall(r"^ *(?:```|~~~)", page.read_text("utf-8"), re.M)
            self.assertEqual(len(fences), 2 * len(blocks(page)), page)


if __name__ == "__main__":
    unittest.main()
