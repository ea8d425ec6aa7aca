# SPDX-License-Identifier: Apache-2.0
"""The part of a page that a program writes, between markers of its own."""


def fill_block(page, start, end, lines):
    """Puts lines between the markers, of which each stands in the page once."""
    before, rest = page.read_text("utf-8").split(start)
    page.write_text(before + start + "\n".join(lines) + end + rest.split(end)[1], "utf-8")
