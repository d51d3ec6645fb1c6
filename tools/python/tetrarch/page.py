# SPDX-License-Identifier: GPL-2.0-or-later
"""The page to look at, inside a notebook."""
from __future__ import annotations

import html
import os
import tempfile
from typing import Any


def text(command: str, *arguments: Any, **options: Any) -> str:
    """The page that `view`, `slit -o x.html` or `product -o x.html` writes."""
    from .commands import run

    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "page.html")
        options["output"] = path
        run(command, *arguments, progress=False, **options)
        with open(path, encoding="utf-8") as file:
            return file.read()


def frame(command: str, *arguments: Any, **options: Any) -> str:
    """The page in a frame of its own, so that it and the notebook do not meddle with each other."""
    return '<iframe style="width:100%%;height:560px;border:0" sandbox="allow-scripts allow-downloads" srcdoc="%s"></iframe>' % html.escape(
        text(command, *arguments, **options), quote=True)
