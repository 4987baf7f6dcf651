"""How Sphinx builds the site: `python viz/site.py`."""

import re
import sys
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE))

project = "warpsample"
author = "the authors of warpsample"
version = release = re.search(r'^version = "(.*)"$', (HERE.parents[1] / "pyproject.toml").read_text(), re.MULTILINE)[1]
html_title = f"warpsample {release}"
language = "en"
smartquotes = False  # they would make dashes of options, and quotes that no one can paste

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
    "sphinx_copybutton",
    "extension",
]
exclude_patterns = ["extension"]
templates_path: list[str] = []

myst_heading_anchors = 3
myst_enable_extensions = ["colon_fence", "attrs_block"]

napoleon_numpy_docstring = False
napoleon_custom_sections = [("Source", "Source"), ("Sources", "Source")]
napoleon_use_ivar = True
napoleon_attr_annotations = False
autodoc_member_order = "bysource"
autodoc_default_options = {"members": True, "inherited-members": "object,int,tuple"}
autodoc_typehints_format = "short"
python_maximum_signature_line_length = 100
python_use_unqualified_type_names = True
python_display_short_literal_types = True
default_role = "py:obj"
toc_object_entries_show_parents = "hide"
viewcode_line_numbers = True
copybutton_prompt_text = ">>> "
copybutton_exclude = ".linenos, .go"

html_theme = "furo"
html_static_path = ["static"]
html_css_files = ["site.css"]
html_js_files = ["images.js"]
html_search_scorer = str(HERE / "search_scorer.js")
html_show_sphinx = False
html_show_copyright = False
html_copy_source = False
html_show_sourcelink = False
html_theme_options = {"navigation_with_keys": True}
pygments_style = "friendly"
pygments_dark_style = "monokai"
