# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings for the site, which Utilities/site.sh builds of the pages as they are."""

import os
import re

project = "WideFoV for VTK"
author = "the WideFoV maintainers"
copyright = author  # pylint: disable=redefined-builtin
extensions = ["myst_parser"]
exclude_patterns = ["Examples", "Module", "Plugin", "Programs", "Testing", "Utilities", "Documentation/site"]
suppress_warnings = ["myst.header"]  # pages begin where their subject does
myst_heading_anchors = 4
highlight_language = "none"
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2}
html_copy_source = False
html_show_sphinx = False


def unlink_folders(app, page, source):
    """A link to a folder of the checkout is its words: the site has files alone."""
    here = os.path.dirname(app.env.doc2path(page))

    def words(link):
        return link[1] if os.path.isdir(os.path.join(here, link[2])) else link[0]

    source[0] = re.sub(r"\[([^\]]*)\]\(([^)#]+)\)", words, source[0])


def setup(app):
    app.connect("source-read", unlink_folders)
