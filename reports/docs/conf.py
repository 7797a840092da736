"""How Sphinx makes the site: Markdown, equations as MathML, and the theme beside."""

project = "Plumbline"
extensions = ["myst_parser", "mathml"]
myst_enable_extensions = ["dollarmath"]
myst_heading_anchors = 3
html_theme = "theme"
html_theme_path = ["."]
html_title = "Plumbline"
html_copy_source = False
html_use_index = False
html_show_search_summary = False  # it would be fetched, which pages opened from disk cannot do
html_permalinks_icon = "#"
highlight_language = "none"
suppress_warnings = ["myst.header"]
