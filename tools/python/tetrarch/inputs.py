# SPDX-License-Identifier: GPL-2.0-or-later
"""Whatever may stand for a manifold or a mesh, made into what the library holds."""
from __future__ import annotations

import os
import sys
import warnings
from typing import TYPE_CHECKING, Any, List, Optional, Tuple, Union

from . import _tetrarch
from .errors import InputError

if TYPE_CHECKING:
    #: What stands for a text: a name, a number in one, a path.
    Text = Union[str, int, float, "os.PathLike[str]"]

# VTK's numbers of cells.
_TRIANGLE, _TETRAHEDRON = 5, 10


class TetrarchWarning(UserWarning):
    """What a read passed over, and what else is to be known of an input.

    >>> import tetrarch as tt
    >>> issubclass(tt.TetrarchWarning, UserWarning)
    True
    """


def text_of(given: Any) -> str:
    """A name, a signature, or a path; one that begins with samples/ is a file of the package, if it is none here."""
    text = os.fspath(given)
    if not isinstance(text, str):
        raise InputError("a path is a %s (expected a text)" % type(text).__name__)
    if "\0" in text:
        raise InputError("a name has a zero byte in it")
    try:
        text.encode()
    except UnicodeEncodeError:
        raise InputError("a name has a character in it that is none") from None
    if text.startswith("samples/") and not os.path.exists(text):
        there = os.path.join(os.path.dirname(__file__), text)
        if os.path.exists(there):
            return there
    return text


def is_text(given: Any) -> bool:
    return isinstance(given, (str, os.PathLike))


def held(given: Any) -> Optional[_tetrarch.Content]:
    """What one of our own objects holds."""
    content = getattr(given, "_content", None)
    return content if isinstance(content, _tetrarch.Content) else None


def _is_array(given: Any) -> bool:
    return hasattr(given, "shape") and hasattr(given, "dtype")


def _is_rows(given: Any) -> bool:
    return _is_array(given) or (isinstance(given, (list, tuple)) and all(isinstance(row, (list, tuple)) or _is_array(row) for row in given))


def is_pair(given: Any) -> bool:
    """Points and elements, as arrays or as lists of rows."""
    return isinstance(given, (tuple, list)) and len(given) == 2 and _is_rows(given[0]) and _is_rows(given[1])


def _width(elements: Any) -> int:
    if _is_array(elements):
        return int(elements.shape[1]) if len(elements.shape) == 2 else -1
    widths = {len(row) for row in elements}
    return widths.pop() if len(widths) == 1 else 3 if not widths else -1


def mesh_of_pair(points: Any, elements: Any, source: str = "<arrays>", triangles: Any = None, triangle_tags: Any = None,
                 tetrahedron_tags: Any = None) -> _tetrarch.Content:
    """Rows of three are triangles, rows of four are tetrahedra."""
    if elements is None:
        raise InputError("None stands where an array of elements is expected")
    if not _is_rows(elements):
        raise InputError("a %s stands where an array of elements is expected" % type(elements).__name__)
    width = _width(elements)
    if width == 3 and triangles is None:
        return _tetrarch.mesh_from_arrays(points, elements, None, triangle_tags, None, source)
    if width == 4:
        return _tetrarch.mesh_from_arrays(points, triangles, elements, triangle_tags, tetrahedron_tags, source)
    shape = getattr(elements, "shape", None)
    raise InputError("elements: %s (expected rows of three or four numbers of points)" % (
        "an array of shape %s" % (tuple(shape),) if shape is not None else "rows of other lengths"))


def _tags(given: Any, kind: str, count: int) -> Any:
    """What meshio knows of the patches or regions of a kind of cell."""
    data = getattr(given, "cell_data_dict", None)
    if isinstance(data, dict):
        for name in ("medit:ref", "gmsh:physical"):
            tags = data.get(name, {}).get(kind)
            if tags is not None and len(tags) == count:
                return tags
    return None


def _flat_triangles(faces: Any) -> Any:
    """PyVista's faces: 3 a b c 3 d e f ..., or rows."""
    import numpy as np

    faces = np.asarray(faces)
    if faces.ndim == 2:
        return faces
    if faces.size % 4 or (faces.size and (faces[::4] != 3).any()):
        raise InputError("the faces are not all triangles")
    return faces.reshape(-1, 4)[:, 1:]


def mesh_of_object(given: Any, source: str) -> Optional[_tetrarch.Content]:
    """Of an object with `points` and cells (meshio, PyVista), or with `vertices` and `faces` (trimesh); None: it is no such thing."""
    points = getattr(given, "points", None)
    cells = getattr(given, "cells_dict", None)
    if points is not None and isinstance(cells, dict):
        triangles = cells.get("triangle", cells.get(_TRIANGLE))
        tetrahedra = cells.get("tetra", cells.get(_TETRAHEDRON))
        if triangles is None and tetrahedra is None:
            raise InputError("the mesh has neither triangles nor tetrahedra (it has: %s)" % ", ".join(map(str, cells)))
        return _tetrarch.mesh_from_arrays(
            points, triangles, tetrahedra,
            None if triangles is None else _tags(given, "triangle", len(triangles)),
            None if tetrahedra is None else _tags(given, "tetra", len(tetrahedra)), source)
    if points is None:
        points = getattr(given, "vertices", None)
    faces = getattr(given, "faces", None)
    if points is not None and faces is not None and not callable(points) and not callable(faces):
        return _tetrarch.mesh_from_arrays(points, _flat_triangles(faces), None, None, None, source)
    return None


def triangulation_text(given: Any) -> Optional[str]:
    """The text by which another program's triangulation is handed over: its SnapPea file, else its signature."""
    for name in ("snapPea", "isoSig"):
        method = getattr(given, name, None)
        if callable(method):
            text = method()
            if isinstance(text, str) and text:
                return text
    return None


def content_of(given: Any, source: str = "<value>", report: Any = None) -> _tetrarch.Content:
    """A triangulation or a mesh, from anything but a text."""
    content = held(given)
    if content is not None:
        return content
    if given is None:
        raise InputError("None stands where a manifold or a mesh is expected")
    if is_pair(given):
        return mesh_of_pair(given[0], given[1], source)
    text = triangulation_text(given)
    if text is not None:
        return _tetrarch.content_from(text)
    mesh = mesh_of_object(given, source)
    if mesh is not None:
        return mesh
    raise InputError("a %s stands where a manifold or a mesh is expected (a name, a signature, a path, arrays (V, T), or an object "
                     "with isoSig() or snapPea())" % type(given).__name__)


def triangulation_of(given: Any, weld: Optional[float], component: Optional[int], repair: bool,
                     report: Any) -> Tuple[_tetrarch.Content, str]:
    """A triangulation from whatever may stand for one, and what errors call it."""
    if is_text(given):
        text = text_of(given)
        return _tetrarch.open_triangulation(text, weld, component, repair, report), text
    content = content_of(given, report=report)
    if content.kind in ("mesh", "surface"):
        content = _tetrarch.triangulated(content, weld, component, repair, "<arrays>", report)
    return content, content.name or "<value>"


def warn(messages: List[str]) -> None:
    """Warns at the line outside of the package that led here."""
    if not messages:
        return
    frame, level = sys._getframe(1), 2
    while frame.f_back is not None and frame.f_globals.get("__name__", "").split(".")[0] == __package__:
        frame, level = frame.f_back, level + 1
    for message in messages:
        warnings.warn(message, TetrarchWarning, stacklevel=level)
