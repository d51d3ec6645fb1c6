# SPDX-License-Identifier: GPL-2.0-or-later
"""Links, graphs in space and curves: diagrams, exteriors, equivalence."""
from __future__ import annotations

import os
import tempfile
from typing import Any, List, Optional, TypeVar

from .commands import run
from .errors import InputError
from .inputs import is_text, text_of
from .manifold import Manifold
from .progress import Progress
from .results import Result

__all__ = ["Link", "SpatialGraph", "curve_exterior"]

_Graph = TypeVar("_Graph", bound="SpatialGraph")


def _rows_of_points(points: Any, what: str) -> List[List[float]]:
    try:
        rows = [[float(x) for x in row] for row in points]
    except (TypeError, ValueError):
        raise InputError("%s: rows of three numbers are expected" % what) from None
    for k, row in enumerate(rows):
        if len(row) != 3:
            raise InputError("%s: point %d has %d numbers (expected 3)" % (what, k, len(row)))
    return rows


def _curve_text(points: Any, segments: Any) -> str:
    """OBJ with lines where there are segments, else a list of points for each closed curve."""
    if segments is not None:
        rows = _rows_of_points(points, "points")
        lines = ["v %r %r %r" % tuple(row) for row in rows]
        for k, segment in enumerate(segments):
            ends = [int(end) for end in segment]
            if len(ends) != 2 or not all(0 <= end < len(rows) for end in ends):
                raise InputError("segment %d: two numbers of points from 0 to %d are expected" % (k, len(rows) - 1))
            lines.append("l %d %d" % (ends[0] + 1, ends[1] + 1))
        return "\n".join(lines) + "\n"
    curves = list(points)
    if curves and not isinstance(curves[0], (str, bytes)):
        first = curves[0]
        if len(first) > 0 and hasattr(first[0], "__len__"):
            return "\n".join(_curve_text(curve, None) for curve in curves)
    return "".join("%r %r %r\n" % tuple(row) for row in _rows_of_points(curves, "points"))


def _from_curve(points: Any, segments: Any, seed: int, progress: Progress) -> Result:
    handle, path = tempfile.mkstemp(suffix=".obj" if segments is not None else ".xyz", prefix="tetrarch_curve_")
    try:
        with os.fdopen(handle, "w") as file:
            file.write(_curve_text(points, segments))
        return run("diagram", path, seed=seed, progress=progress)  # type: ignore[no-any-return]
    finally:
        os.unlink(path)


def _planar_code(rows: Any) -> str:
    return "PD[%s]" % ", ".join("X[%s]" % ", ".join(str(int(x)) for x in row) for row in rows)


def _code_of(what: Any) -> str:
    """The text of a name, a path, a code, a list of crossings, or a link of SnapPy or Regina."""
    if is_text(what):
        return text_of(what)
    for name in ("PD_code", "pdData"):
        method = getattr(what, name, None)
        if callable(method):
            return _planar_code(method())
    if isinstance(what, (list, tuple)) and what and all(isinstance(row, (list, tuple)) and len(row) == 4 for row in what):
        return _planar_code(what)
    raise InputError("a %s stands where a diagram is expected (a name, a code, a path, a list of crossings, or an object with "
                     "PD_code() or pdData())" % type(what).__name__)


class SpatialGraph:
    """A graph or a link in space, given by a diagram. It never changes.

    `what` is a name ("hk5_3", "theta3_1", "L6a4", "4_1"), a code ("PD[X[...], V[...]]", "embedding:...", "braid 1 -2 1 -2"), a path
    of such a code or of a curve, a list of crossings, or a link of SnapPy or Regina. Instead of it, `points` and `segments` give a
    curve in space: without segments, one closed curve, or a list of such.

    >>> import tetrarch as tt
    >>> graph = tt.SpatialGraph("hk5_3")
    >>> graph, graph.exterior().identify().name
    (SpatialGraph(5 crossings, 2 vertices, 1 component), 'fmp2_8')
    """

    def __init__(self, what: Any = None, *, points: Any = None, segments: Any = None, seed: int = 1,
                 progress: Progress = None) -> None:
        if (what is None) == (points is None):
            raise InputError("either a diagram or points are expected")
        if points is not None:
            self._set(_from_curve(points, segments, seed, progress))
        elif isinstance(what, SpatialGraph):
            self._set(what._facts)
        else:
            self._set(run("diagram", _code_of(what), seed=seed, progress=progress))

    def _set(self, facts: Result) -> None:
        self._facts = facts

    @classmethod
    def _of(cls: "type[_Graph]", facts: Result) -> _Graph:
        made = cls.__new__(cls)
        made._set(facts)
        return made

    def __reduce__(self) -> Any:
        return type(self), (self.code,)

    def __eq__(self, other: Any) -> bool:
        return isinstance(other, SpatialGraph) and self.code == other.code

    def __hash__(self) -> int:
        return hash(self.code)

    def __repr__(self) -> str:
        counts = [(self.crossings, "crossing"), (self.vertices, "vertex"), (self.components, "component")]
        words = ["%d %s" % (n, word if n == 1 else "vertices" if word == "vertex" else word + "s") for n, word in counts
                 if n > 0 or word != "vertex"]
        return "%s(%s)" % (type(self).__name__, ", ".join(words))

    @property
    def code(self) -> str:
        """The planar diagram code.

        >>> import tetrarch as tt
        >>> tt.Link("DT[4,6,2]").code
        'PD[X[3, 6, 4, 1], X[1, 4, 2, 5], X[5, 2, 6, 3]]'
        """
        return str(self._facts.code)

    @property
    def crossings(self) -> int:
        """Number of crossings of this diagram.

        >>> import tetrarch as tt
        >>> tt.Link("L6a4").crossings
        6
        """
        return int(self._facts.crossings)

    @property
    def vertices(self) -> int:
        """Number of vertices whose valence is not 2.

        >>> import tetrarch as tt
        >>> tt.SpatialGraph("theta3_1").vertices
        2
        """
        return int(self._facts.vertices)

    @property
    def components(self) -> int:
        """Number of connected components.

        >>> import tetrarch as tt
        >>> tt.Link("L6a4").components
        3
        """
        return int(self._facts.components)

    @property
    def alternating(self) -> bool:
        """Whether the diagram alternates between over and under.

        >>> import tetrarch as tt
        >>> tt.Link("braid 1 -2 1 -2").alternating
        True
        """
        return bool(self._facts.alternating)

    def simplified(self: _Graph, progress: Progress = None) -> _Graph:
        """A diagram of the same with fewer crossings, if that is easy to see.

        >>> import tetrarch as tt
        >>> tt.Link("braid 1 2 -2 1 1").simplified().crossings
        3
        """
        return self._of(run("diagram", self.code, simplify=True, progress=progress))

    def mirror(self: _Graph) -> _Graph:
        """The mirror image.

        >>> import tetrarch as tt
        >>> K = tt.Link("3_1")
        >>> K.is_equivalent_to(K.mirror(), mirror=False) is False, tt.Link("4_1").is_equivalent_to(tt.Link("4_1").mirror(), mirror=False)
        (False, True)
        """
        return self._of(run("diagram", self.code, mirror=True))

    def save(self, path: Any, progress: Progress = None) -> None:
        """Writes a drawing (.svg), or the code.

        >>> import os, tempfile, tetrarch as tt
        >>> path = os.path.join(tempfile.mkdtemp(), "figure8.svg")
        >>> tt.Link("4_1").save(path)
        >>> open(path).read().startswith("<svg") or "<svg" in open(path).read()
        True
        """
        run("diagram", self.code, output=path, progress=progress)

    def exterior(self, seed: int = 1, progress: Progress = None) -> Manifold:
        """The 3-sphere minus a neighborhood: a cusp for each component of a link, a surface for each graph.

        >>> import tetrarch as tt
        >>> tt.Link("4_1").exterior().volume()                                    # doctest: +ELLIPSIS
        2.02988321281...
        """
        found = run("exterior", self.code, seed=seed, progress=progress)
        return Manifold._of(found.value._content)

    def compare(self, other: Any, seed: int = 1, progress: Progress = None) -> Result:
        """`tetrarch isometric --pair`: not the exteriors alone, but the neighborhoods in space are compared.

        >>> import tetrarch as tt
        >>> found = tt.SpatialGraph("hk5_3").compare("hk6_5")
        >>> found.equivalent, found.proof
        (False, 'cells')
        """
        there = other if isinstance(other, SpatialGraph) else SpatialGraph(other)
        return run("isometric", self.code, there.code, pair=True, seed=seed, progress=progress)  # type: ignore[no-any-return]

    def is_equivalent_to(self, other: Any, mirror: bool = True, seed: int = 1, progress: Progress = None) -> Optional[bool]:
        """Whether a homeomorphism of space takes a neighborhood of the one to one of the other; None: undecided.

        Handlebody-knots are compared so, and links without names for their components. `mirror=False` asks for a homeomorphism
        that keeps the orientation of space; then False is proved only where the exterior has a structure.

        >>> import tetrarch as tt
        >>> tt.Link("4_1").is_equivalent_to("braid 1 -2 1 -2")
        True
        """
        found = self.compare(other, seed, progress)
        if found.equivalent is not True or mirror or found.keeps_orientation:
            return found.equivalent  # type: ignore[no-any-return]
        return False if found.proof == "isometry" else None


class Link(SpatialGraph):
    """A knot or link: a SpatialGraph without vertices.

    >>> import tetrarch as tt
    >>> tt.Link("4_1")
    Link(4 crossings, 1 component)
    >>> tt.Link([(1, 4, 2, 5), (3, 6, 4, 1), (5, 2, 6, 3)]).exterior().homology()
    Z
    """

    def _set(self, facts: Result) -> None:
        if facts.vertices > 0:
            raise InputError("the diagram has %d vertices: it is no link, but a SpatialGraph" % facts.vertices)
        super()._set(facts)


def curve_exterior(points: Any, segments: Any = None, seed: int = 1, progress: Progress = None) -> Manifold:
    """The exterior of a closed curve in space, of several, or of a graph with straight segments.

    `points` is (n, 3), in order round a closed curve, or a list of such; with `segments`, pairs of numbers of points, any graph. The
    curve is looked at from a random place outside, exactly; a curve that meets itself is an InputError that says where.

    >>> import math, tetrarch as tt
    >>> turns = [2 * math.pi * k / 60 for k in range(60)]
    >>> figure_eight = [((2 + math.cos(2 * t)) * math.cos(3 * t), (2 + math.cos(2 * t)) * math.sin(3 * t), math.sin(4 * t))
    ...                 for t in turns]
    >>> tt.curve_exterior(figure_eight).identify().name
    'figure-eight knot complement (m004)'
    """
    return SpatialGraph(points=points, segments=segments, seed=seed, progress=progress).exterior(seed, progress)
