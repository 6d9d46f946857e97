"""The only imgui_bundle: the window."""

import argparse


def run(options: argparse.Namespace) -> int:
    """Open the window at a state, or at the first picture; without a display on GLFW's null platform."""
    from app import locale_alias
    from app.viewer.parameters import open_window, parameters
    from app.viewer.window import Window

    formulas = locale_alias.ensure()
    window = Window(
        getattr(options, "state", "") or "",
        getattr(options, "mesh", None),
        getattr(options, "theme", "") or "",
        getattr(options, "size", None) or (1280, 720),
        ies=getattr(options, "ies", None),
        maps=tuple(getattr(options, "map", None) or ()),
    )
    if formulas == "missing":
        window.message = "Formulas cannot be typeset here: run `halfway doctor`, it prints the command that mends it."
    open_window(*parameters(window))
    return 0
