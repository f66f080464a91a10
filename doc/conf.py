# SPDX-License-Identifier: LGPL-2.1-or-later
"""The manual as a book: `contrib/manual` builds it with Sphinx and MyST.

The source folder is the root of the project, so that pages link to scenes,
scripts and each other as they do on a plain git host; this file says which
texts are pages.
"""

import pathlib
import re

from docutils import nodes

root = pathlib.Path(__file__).resolve().parent.parent

project = "Seiche"
author = "The Seiche authors"
release = re.search(r"^version: *(\S+)", (root / "CITATION.cff").read_text(), re.M).group(1)

extensions = ["myst_parser"]
root_doc = "doc/index"
include_patterns = ["doc/**.md", "prm/**/README.md", "README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
source_suffix = {".md": "markdown"}
myst_heading_anchors = 4  # the anchors of a git host
suppress_warnings = ["myst.header"]  # parameters.md and journals skip levels

html_theme = "furo"
html_title = "Seiche " + release
html_copy_source = False
html_show_sourcelink = False
pygments_style = "friendly"
highlight_language = "none"

# A number at the end of a line of a formula: "u = v dt   (3.1)".
EQUATION = re.compile(r" {2,}\((\d+\.\d+[a-z]?)\)$", re.M)


def mark_equations(app, doctree):
    """Gives the formulas of theory.md the anchors eq-3-1, ... ."""
    if app.env.docname != "doc/theory":
        return
    for block in doctree.findall(nodes.literal_block):
        for number in EQUATION.findall(block.astext()):
            block["ids"].append("eq-" + number.replace(".", "-"))


# A list item of a page of contents that begins with a link: "- [Start](start.md): ...".
ENTRY = re.compile(r"^- \[[^]]+\]\(([^)#]+)\.md\)", re.M)
CONTENTS = ("doc/index", "doc/lessons/index", "doc/journal/index", "doc/scenes")


def read_contents(app, docname, source):
    """Makes the lists of links on the pages of contents the tables of contents, so
    that these pages read well on a git host."""
    if docname not in CONTENTS:
        return
    for part in re.split(r"^## ", source[0], flags=re.M):
        entries = ENTRY.findall(part)
        if entries:
            caption = ":caption: %s\n" % part.split("\n", 1)[0] if docname == root_doc else ""
            source[0] += "\n```{toctree}\n:hidden:\n%s\n%s\n```\n" % (
                caption, "\n".join(entries))


def setup(app):
    app.connect("source-read", read_contents)
    app.connect("doctree-read", mark_equations)
    return {"parallel_read_safe": True}

