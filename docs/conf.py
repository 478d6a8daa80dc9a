"""The site: `sphinx-build -W -b html docs build/site` (see docs/decisions/0010-the-site.md)."""

import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).parent / "_ext"), str(Path(__file__).parents[1])]

import cadgen

project = "cadgen"
author = "the cadgen developers"
release = version = cadgen.__version__
copyright = author

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "command_pages", "python_pages", "mathml"]
exclude_patterns = ["tutorial/*"]

myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 4

default_role = "code"
autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_preserve_defaults = True
napoleon_google_docstring = True
napoleon_numpy_docstring = False
napoleon_use_ivar = True
napoleon_attr_annotations = False  # the signature has the types

html_theme = "furo"
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_title = f"cadgen {release}"
html_copy_source = False
html_show_sourcelink = False
