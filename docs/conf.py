"""Sphinx's settings. docs/build.py passes all paths by environment variables."""

from __future__ import annotations

import os
import sys
from pathlib import Path

DOCS = Path(__file__).resolve().parent
sys.path[:0] = [str(DOCS / "_ext"), str(DOCS.parent / "grading" / "book")]

contact_root = os.environ.get("CONTACT_BOOK_ROOT", str(DOCS.parent))
_build = Path(os.environ.get("CONTACT_BOOK_BUILD", str(DOCS.parent / "build")))
contact_products = str(_build / "docs-data")
contact_web = os.environ.get("CONTACT_BOOK_WEB", str(_build / "web"))
# Small faces that were made before, by what they were made from.
contact_fonts = os.environ.get("CONTACT_BOOK_FONTS", str(_build / "fonts"))
contact_node = str(DOCS.parent / "page")
contact_plotter = os.environ.get(
    "CONTACT_BOOK_PLOTTER", str(DOCS.parent / "page" / "web" / "ladder_picture.mjs")
)
contact_ebook = os.environ.get("CONTACT_BOOK_EBOOK", "1") == "1"
contact_api = os.environ.get("CONTACT_BOOK_API", "1") == "1"
contact_complete = os.environ.get("CONTACT_BOOK_COMPLETE") == "1"
contact_some_figures = os.environ.get("CONTACT_BOOK_SOME_FIGURES") == "1"

project = "Contact Hours"
author = "the authors of Contact Hours"
language = "en"
version = release = "0.1.0"
project_copyright = f"2026, {author}"
extensions = ["myst_parser", "breathe", "sphinx_copybutton", "contact_book"]
exclude_patterns: list[str] = []

myst_enable_extensions = [
    "amsmath",
    "attrs_block",
    "attrs_inline",
    "colon_fence",
    "deflist",
    "dollarmath",
    "smartquotes",
]
myst_heading_anchors = 3
suppress_warnings: list[str] = []

primary_domain = "cpp"
highlight_language = "cpp"
toc_object_entries_show_parents = "hide"
html_math_renderer = "katex"
numfig = False

breathe_projects = {"contact": str(_build / "doxygen" / "xml")}
breathe_default_project = "contact"
breathe_default_members = ("members", "undoc-members")
breathe_show_include = False

nitpicky = True
# Other libraries, template parameters and what headers keep to themselves have no page here.
nitpick_ignore_regex = [
    (r"cpp:identifier", r"Eigen(::.*)?|nlohmann(::.*)?|std(::.*)?|S|T|Value|u?int\d+_t|size_t"),
    (r"cpp:identifier", r".*<(S|double|Exact|E\.dimension)>::.*"),
    (
        r"cpp:identifier",
        r"(contact::)?(detail|internal)(::.*)?|contact(::(tolerance|cost|scenes))?",
    ),
]
if not contact_api:
    # What lessons name of the code has no page yet; it is linked when the API pages are built.
    nitpick_ignore_regex.append((r"cpp:.*", r"contact::.*"))

epub_basename = "contact-hours"
epub_title = project
epub_description = "A book of collision detection and response that you can run, in C++."
epub_contributor = author
epub_publisher = author
epub_copyright = project_copyright
# Sphinx writes the one where the other is wanted.
epub_identifier = epub_uid = "contact-hours.book"
epub_tocscope = "includehidden"
epub_tocdepth = 2
epub_tocdup = False
epub_show_urls = "no"
epub_css_files = ["ebook.css"]

html_theme = "furo"
html_title = "Contact Hours"
html_favicon = "_static/favicon.svg"
templates_path = ["_templates"]
html_static_path = ["_static"]
html_css_files = ["book.css"]
html_js_files = [("book.js", {"defer": "defer"})]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_show_copyright = False
html_permalinks_icon = "#"
html_theme_options = {
    "sidebar_hide_name": False,
    "navigation_with_keys": True,
    "top_of_page_buttons": [],
}
pygments_style = "github-light-high-contrast"
pygments_dark_style = "github-dark"
copybutton_selector = ".commands div.highlight pre, .example div.highlight-cpp pre, div.copy pre"
copybutton_prompt_text = "$ "
