# SPDX-License-Identifier: Apache-2.0
# The settings of Sphinx. The source is what pages.py and headers.py wrote, the Python package the one that is installed.
import re

import orispline
from sphinx import addnodes

project = "orispline"
author = "the orispline developers"
release = orispline.__version__
extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
root_doc = "index"

myst_enable_extensions = ["deflist", "colon_fence"]
myst_heading_anchors = 4  # as a code host gives them
smartquotes = False

autodoc_default_options = {"members": True, "inherited-members": "BaseException", "member-order": "bysource"}
autodoc_typehints = "none"  # the docstrings say shapes and units, which types do not
napoleon_google_docstring = False

html_theme = "furo"
html_title = f"orispline {release}"
html_show_copyright = False
html_copy_source = False
html_show_sourcelink = False
html_show_search_summary = False  # a browser reads no page beside one that lies on the disk
templates_path = ["templates"]
html_static_path = ["static"]
html_css_files = ["style.css"]
html_js_files = ["site.js"]


def with_titles_alone(toc):
    """What a page has in the side bar: its title, and the trees below it."""
    short = toc.deepcopy()
    for item in short.children:
        if len(item) > 1:
            item[1][:] = list(item.findall(addnodes.toctree))
    return short


def quicken_side_bar(app, pagename, templatename, context, doctree):
    """The side bar of each page is made from titles alone: Sphinx would copy all headings of all pages for each, half of its time."""
    env, toctree = app.env, context["toctree"]
    if not hasattr(app, "titles_alone"):
        app.titles_alone = {name: with_titles_alone(toc) for name, toc in env.tocs.items()}

    def from_titles(**options):
        whole, env.tocs = env.tocs, app.titles_alone
        try:
            return toctree(**options).replace('role="heading"', 'role="heading" aria-level="2"')
        finally:
            env.tocs = whole
    context["toctree"] = from_titles


def mend_tables(app, pagename, templatename, context, doctree):
    """A corner of a table that says nothing heads nothing."""
    if "body" in context:
        context["body"] = context["body"].replace('<th class="head"><p></p></th>', "<td></td>")


def escape(app, what, name, thing, options, lines):
    """Lets |ω| be what it is, where reStructuredText would put something else in its place."""
    lines[:] = [line if line.lstrip().startswith((">>>", "...")) else line.replace("|", r"\|") for line in lines]


def name_types(app, what, name, thing, options, signature, returned):
    """Writes types in signatures by their names."""
    return signature and re.sub(r"<class '([\w.]+)'>", r"\1", signature), returned


def setup(app):
    app.connect("html-page-context", quicken_side_bar, priority=100)  # before the theme asks for it
    app.connect("html-page-context", mend_tables)
    app.connect("autodoc-process-docstring", escape)
    app.connect("autodoc-process-signature", name_types)
