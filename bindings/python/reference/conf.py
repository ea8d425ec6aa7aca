# SPDX-License-Identifier: Apache-2.0
# The reference of the Python package, from its docstrings; the package is the one that is installed.
import orispline

project = "orispline"
author = "the orispline authors"
release = orispline.__version__
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.viewcode"]
autodoc_default_options = {"members": True, "inherited-members": "BaseException", "member-order": "bysource"}
autodoc_typehints = "none"  # the docstrings say shapes and units, which types do not
napoleon_google_docstring = False
smartquotes = False  # texts have code in them
html_theme = "furo"
html_title = f"orispline {release}"
html_show_copyright = False


def setup(app):
    """Lets |ω| be what it is: reStructuredText would put something else in its place."""
    def escape(app, what, name, thing, options, lines):
        lines[:] = [line if line.lstrip().startswith((">>>", "...")) else line.replace("|", r"\|") for line in lines]
    app.connect("autodoc-process-docstring", escape)
