# SPDX-License-Identifier: Apache-2.0
# The reference of the Python package, from its docstrings; the package is the one that is installed.
import re

import orispline

project = "orispline"
author = "the orispline authors"
release = orispline.__version__
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.viewcode"]
autodoc_default_options = {"members": True, "inherited-members": "BaseException", "member-order": "bysource"}
autodoc_typehints = "none"  # the docstrings say shapes and units, which types do not
napoleon_google_docstring = False
smartquotes_action = "D"  # of dashes alone: texts have code with quotes in them
html_theme = "furo"
html_title = f"orispline {release}"
html_show_copyright = False


def setup(app):
    """Lets |ω| be what it is, where reStructuredText would put something else in its place, and writes types by their names."""
    def escape(app, what, name, thing, options, lines):
        lines[:] = [line if line.lstrip().startswith((">>>", "...")) else line.replace("|", r"\|") for line in lines]
    app.connect("autodoc-process-docstring", escape)

    def named(app, what, name, thing, options, signature, returned):
        return signature and re.sub(r"<class '([\w.]+)'>", r"\1", signature), returned
    app.connect("autodoc-process-signature", named)
