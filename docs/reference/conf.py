"""Settings of Sphinx. ``scripts/docs`` writes the sources beside a copy of this file, into ``build/docs``."""

project = "RoboFrameNet"
author = "RoboFrameNet maintainers"
extensions = ["sphinx.ext.autodoc", "sphinx.ext.napoleon"]
html_theme = "alabaster"
html_theme_options = {"page_width": "1100px"}
html_copy_source = False
# What a module exports from another one is described there.
autodoc_default_options = {"members": True, "show-inheritance": True, "ignore-module-all": True}
# 'make agents' installs them; the reference is made without.
autodoc_mock_imports = ["anyio", "mcp", "mcp_types", "uvicorn"]
autodoc_typehints = "description"
autodoc_member_order = "bysource"
# Examples in docstrings are indented blocks of several languages.
highlight_language = "none"
# Nodes list their names in sections of their own; the fields of a NamedTuple are described once.
napoleon_custom_sections = ["Subscribes", "Publishes", "Services", "Actions", "Actions called"]
napoleon_use_ivar = True
