# SPDX-License-Identifier: Apache-2.0
"""The pages of the repository as the source of the site: the same texts at the same places, README.md as the first page.

docs/index.md is the one list of the pages. Its headings and the links that its rows and items begin with are the side bar; a
link to a page that is not in it is an error.
"""
import pathlib
import posixpath
import re
import shutil

import markup

FOLDED = {"Methods": "methods", "Headers of the C++ library": "cpp/index", "Examples": "examples/index"}  # sections that are pages, with theirs below
REFERENCE = [("Methods", "methods"), ("Python", "python/index"), ("C++", "cpp/index"), ("C", "bindings/c/orispline.h"), ("Examples", "examples/index")]
SHOWN = {".cpp": "cpp", ".c": "c", ".h": "c"}  # sources that become pages, by their language


def document(path):
    """The page of the site, without an ending, that a file of the repository becomes."""
    if path == "README.md":
        return "index"
    return path.removesuffix(".md") if path.endswith(".md") else path


class Pages:
    """What the site has of the repository in `root`; write() puts it into a folder."""

    def __init__(self, root):
        self.root = pathlib.Path(root)
        self.index = (self.root / "docs/index.md").read_text("utf-8")
        self.sections = markup.sections(self.index)
        self.listed = {heading: [(title, self.path_of("docs/index.md", target)) for title, target in markup.entries(text)] for heading, text in self.sections}
        self.all = {"README.md", "docs/index.md", "bindings/c/orispline.h", *(path for entries in self.listed.values() for _, path in entries)}
        self.headers = self.public_headers()

    @staticmethod
    def path_of(page, target):
        """The file of the repository that a link on a page leads to."""
        return posixpath.normpath(posixpath.join(posixpath.dirname(page), target.partition("#")[0]))

    def public_headers(self):
        """The public headers in the order of their table, with what it says of each."""
        rows = markup.rows(dict(self.sections)["Headers of the C++ library"])[1:]
        return {name: f"{cells[1][:1].upper()}{cells[1][1:]}." for cells in rows for name in re.findall(r"`([a-z_]+\.hpp)`", cells[0])}

    def target_on_site(self, page, place, target):
        """What a link of a page of the repository becomes on the page of the site `place`."""
        if "://" in target or target.startswith("#"):
            return target
        path, hash_, anchor = self.path_of(page, target), *target.partition("#")[1:]
        if not (self.root / path).is_file():
            raise markup.Fault(f"{page}: found a link to {target}, wanted a file of the repository")
        if path not in self.all and path.endswith((".md", *SHOWN)):
            raise markup.Fault(f"{page}: found a link to {target}, wanted a page that docs/index.md lists")
        name = f"{document(path)}.md" if path in self.all else path
        return posixpath.relpath(name, posixpath.dirname(place) or ".") + hash_ + anchor

    def text_for(self, page, place, text):
        return markup.with_targets(text, lambda target: self.target_on_site(page, place, target))

    def write(self, folder):
        """Everything but the references, which others write."""
        for page in sorted(self.all):
            text = (self.root / page).read_text("utf-8")
            place = f"{document(page)}.md"
            if pathlib.PurePath(page).suffix in SHOWN:
                text = f"# {pathlib.PurePath(page).name}\n\n" + markup.block(SHOWN[pathlib.PurePath(page).suffix], text)
            else:
                self.copy_files(folder, page, text)
                text = self.text_for(page, place, text)
            self.put(folder, place, text + (self.side_bar() if page == "README.md" else ""))
        for heading, place in FOLDED.items():
            self.put(folder, f"{place}.md", self.folded(heading, place))

    def copy_files(self, folder, page, text):
        """The pictures of a page, and what else it leads to that is no page."""
        for target in {match[2] for match in markup.TARGET.finditer(text)}:
            path = self.path_of(page, target)
            if "://" not in target and (self.root / path).is_file() and path not in self.all:
                (folder / path).parent.mkdir(parents=True, exist_ok=True)
                shutil.copyfile(self.root / path, folder / path)

    @staticmethod
    def put(folder, name, text):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / name).write_text(text, "utf-8")

    def folded(self, heading, place):
        """A section of docs/index.md as a page; the methods have their pictures on it, each leading to its page."""
        text = self.text_for("docs/index.md", f"{place}.md", dict(self.sections)[heading])
        below = [(title, document(path)) for title, path in self.listed[heading]]
        if heading == "Methods":
            text += self.gallery(below)
        if heading == "Headers of the C++ library":
            text = re.sub(r"`([a-z_]+\.hpp)`", lambda name: f"[{name[0]}]({name[1]}.md)" if name[1] in self.headers else name[0], text)
            below = [(name, f"cpp/{name}") for name in self.headers]
        return f"# {heading}\n{text}\n{markup.tree(below)}"

    def gallery(self, below):
        """The pictures of pages, each leading to its page."""
        cards = [f"[![Curves by {title}]({page}.svg) {title}]({page}.md)" for title, page in below if (self.root / f"{page}.svg").is_file()]
        return "\n## Pictures\n\n" + markup.container("gallery", "\n\n".join(cards)) + "\n"

    def side_bar(self):
        """The trees behind the first page: one for each section of docs/index.md, in its order, and one for those that are folded."""
        trees = {"": [("All pages", "docs/index")]}
        for heading, entries in self.listed.items():
            if heading in FOLDED:
                trees["Reference"] = REFERENCE
            else:
                trees[heading] = [(title, document(path)) for title, path in entries]
        return "\n" + "\n".join(markup.tree(entries, *([f":caption: {caption}"] if caption else [])) for caption, entries in trees.items())
