#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the HTML that Doxygen made has every page and picture of the documents, and no link into the void.

usage: check_html.py ROOT HTML   ROOT has README.md and docs/, HTML is the folder that was made
"""
import html
import pathlib
import re
import sys
import urllib.parse

PICTURE = re.compile(r"!\[[^\]]*\]\(([^)\s]+)\)", re.S)
REFERENCE = re.compile(r'<(?:a|img|object|link|script)\b[^>]*?\b(?:href|src|data)="([^"]+)"')


def words(text):
    """A heading as people read it."""
    return re.sub(r"[^\w]+", " ", html.unescape(re.sub(r"<[^>]*>", "", text))).strip()


def title_of(document):
    return words(re.search(r"^# (.*)$", document.read_text("utf-8"), re.M)[1].replace("`", ""))


def titles_in(folder):
    """The pages by their titles."""
    pages = {}
    for page in folder.glob("*.html"):
        text = page.read_text("utf-8", errors="replace")
        heading = re.search(r'<div class="title">(.*?)</div>', text, re.S)
        if heading:
            pages.setdefault(words(heading[1]), []).append(text)
    return pages


def missing_pages(root, folder):
    titles = titles_in(folder)
    for document in [root / "README.md", *sorted((root / "docs").rglob("*.md"))]:
        name = document.relative_to(root)
        texts = [(folder / "index.html").read_text("utf-8")] if document.name == "README.md" else titles.get(title_of(document))
        if not texts:
            yield f"{name}: no page has its title, '{title_of(document)}'"
            continue
        for picture in PICTURE.findall(document.read_text("utf-8")):
            base = pathlib.PurePosixPath(picture).name
            if not any(urllib.parse.unquote(link) == base for text in texts for link in REFERENCE.findall(text)):
                yield f"{name}: its page does not show {picture}"
            if not (folder / base).is_file():
                yield f"{name}: {picture} is not in the HTML"


def spoilt_texts(folder):
    """Where a command of Doxygen or the marks of the text are shown instead of what they mean."""
    for page in [folder / "index.html", *sorted(folder.glob("md_*.html"))]:
        text = re.sub(r'<div class="fragment">.*?</div><!-- fragment -->', "", page.read_text("utf-8"), flags=re.S)
        for spoilt in re.findall(r"^@(?:image|code|endcode|ref)\b.*|<a [^>]*>`.*?</a>", text, re.M):
            yield f"{page.name}: shows '{spoilt[:80]}'"


def broken_links(folder):
    for page in sorted(folder.glob("*.html")):
        for link in set(REFERENCE.findall(page.read_text("utf-8", errors="replace"))):
            path = urllib.parse.unquote(html.unescape(link).partition("#")[0])
            if path and not re.match(r"[a-z]+:", path) and not (folder / path).exists():
                yield f"{page.name}: {link} is not in the HTML"


def main(root, folder):
    faults = [*missing_pages(root, folder), *broken_links(folder), *spoilt_texts(folder)]
    for fault in faults:
        print(f"check_html: {fault}", file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    sys.exit(main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
