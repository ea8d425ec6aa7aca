#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether a site is whole: every page of the repository in its side bar, no link or anchor into the void, and nothing of it from elsewhere.

usage: check_html.py ROOT SITE   ROOT has docs/, SITE is the folder that was made from it
"""
import html.parser
import pathlib
import re
import sys
import urllib.parse

LOADS = {"script": "src", "img": "src", "link": "href", "object": "data", "iframe": "src", "source": "src"}  # tag -> what a browser fetches by itself
STYLE_LOADS = re.compile(r"(?:url\(|@import)\s*[\"']?((?:[a-z]+:)?//[^\"')\s]+)")


class Page(html.parser.HTMLParser):
    """The anchors of a page, its links, what it loads, and the links of its side bar."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loaded, self.side_bar = {"", "top"}, set(), set(), set()
        self.depth = 0  # of elements within the side bar
        self.feed(path.read_text("utf-8"))

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.anchors |= {values[name] for name in ("id", "name") if values.get(name)}
        if tag in LOADS and values.get(LOADS[tag]):
            self.loaded.add(values[LOADS[tag]])
        if tag == "a" and values.get("href"):
            self.links.add(values["href"])
            if self.depth:
                self.side_bar.add(values["href"])
        if tag == "div" and (self.depth or "sidebar-tree" in values.get("class", "")):
            self.depth += 1

    def handle_endtag(self, tag):
        if tag == "div" and self.depth:
            self.depth -= 1


def is_elsewhere(link):
    return bool(re.match(r"[a-z]+:|//", link))


def broken_links(site, pages):
    for path, page in pages.items():
        for link in sorted(page.links | page.loaded):
            if is_elsewhere(link):
                continue
            file, _, anchor = link.partition("#")
            target = (path.parent / urllib.parse.unquote(file.partition("?")[0])).resolve() if file else path
            if not target.is_file():
                yield f"{path.relative_to(site)}: {link} is not in the site"
            elif target in pages and urllib.parse.unquote(anchor) not in pages[target].anchors:
                yield f"{path.relative_to(site)}: {link} has no such anchor"


def loads_from_elsewhere(site, pages):
    for path, page in pages.items():
        yield from (f"{path.relative_to(site)}: loads {link}" for link in sorted(page.loaded) if is_elsewhere(link) and not link.startswith("data:"))
    for path in sorted(site.rglob("*.css")):
        yield from (f"{path.relative_to(site)}: loads {link}" for link in STYLE_LOADS.findall(path.read_text("utf-8")))


def pages_without_a_place(root, pages, front):
    """The documents to which no link of the side bar leads."""
    for document in sorted((root / "docs").rglob("*.md")):
        name = document.relative_to(root).with_suffix(".html").as_posix()
        if name not in pages[front].side_bar:
            yield f"{document.relative_to(root)}: is not in the side bar"


def main(root, site):
    site = site.resolve()
    pages = {path: Page(path) for path in sorted(site.rglob("*.html"))}
    faults = [*pages_without_a_place(root, pages, site / "index.html"), *broken_links(site, pages), *loads_from_elsewhere(site, pages)]
    for fault in faults:
        print(f"check_html: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
