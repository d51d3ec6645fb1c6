# SPDX-License-Identifier: GPL-2.0-or-later
"""Triangulations: gluings of tetrahedra, as values that never change."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Iterable, List, Optional, Sequence, Tuple, Type, TypeVar, Union

from . import _tetrarch
from .errors import InputError, shown
from .groups import AbelianGroup, FundamentalGroup
from .inputs import is_text, text_of, triangulation_of, warn
from .progress import Progress, reporting
from .results import Record, Result

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

__all__ = ["Gluing", "Move", "Skeleton", "Triangulation"]

#: Of a face: None on the boundary, else (the other tetrahedron, where the vertices 0, 1, 2, 3 go).
Gluing = Optional[Tuple[int, Tuple[int, int, int, int]]]

_Own = TypeVar("_Own", bound="Gluings")


class Gluings:
    """What Triangulation and Manifold have in common: tetrahedra, the gluings of their faces, and a name."""

    _content: _tetrarch.Content

    def __init__(self, content: _tetrarch.Content) -> None:
        self._content = content

    @classmethod
    def _of(cls: Type[_Own], content: _tetrarch.Content) -> _Own:
        made = cls.__new__(cls)
        Gluings.__init__(made, content)
        return made

    def name(self) -> str:
        """The name that its file or the tables give it; empty: none.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").name()
        'figure-eight knot complement (m004)'
        """
        return self._content.name

    def num_tetrahedra(self) -> int:
        """The number of tetrahedra, which is the length, too.

        >>> import tetrarch as tt
        >>> tt.Triangulation("cPcbbbihq").num_tetrahedra()
        2
        """
        return self._content.size

    def __len__(self) -> int:
        return self._content.size

    def isoSig(self) -> str:
        """The isomorphism signature, as Regina has it: two triangulations share it exactly if they are isomorphic.

        >>> import tetrarch as tt
        >>> tt.Manifold("fmp2_8").isoSig()
        'cPcbbbihq'
        """
        return self._content.signature()

    def snapPea(self) -> str:
        """The text of a SnapPea file, by which Regina and SnapPy take the triangulation over.

        A boundary of faces cannot be said in this format: InputError.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").snapPea().splitlines()[0]
        '% Triangulation'
        """
        return self._content.written("snappea")

    def _to_string(self) -> str:
        """SnapPy's name for the same."""
        return self.snapPea()

    def json(self) -> str:
        """The text of a file in Tetrarch's own format, which keeps labels, names and metrics.

        >>> import tetrarch as tt
        >>> tt.Triangulation("cPcbbbihq").json().split()[1:3]
        ['"format":', '"tetrarch-triangulation",']
        """
        return self._content.written("json")

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes a file, whose extension names the format: .json, .tri, .sig, .fmp.

        >>> import tetrarch as tt, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     tt.Manifold("m004").save(folder + "/m004.tri")
        ...     tt.Manifold(folder + "/m004.tri").num_tetrahedra()
        2
        """
        from .commands import run

        run("convert", self, output=path)

    def gluings(self) -> List[List[Gluing]]:
        """Of each tetrahedron and face i, opposite vertex i: the other tetrahedron and where the vertices go.

        >>> import tetrarch as tt
        >>> tt.Triangulation("cPcbbbihq").gluings()[0][3]
        (1, (2, 3, 0, 1))
        >>> tt.Triangulation(tt.Manifold("m004").gluings()).isoSig() == tt.Manifold("m004").isoSig()
        True
        """
        classes = _tetrarch.skeleton(self._content)
        permutations = classes["permutations"].reshape(-1, 4, 4).tolist()
        neighbors = classes["neighbors"].tolist()
        return [[None if other < 0 else (other, tuple(permutation)) for other, permutation in zip(*row)]  # type: ignore[misc]
                for row in zip(neighbors, permutations)]

    def skeleton(self) -> "Skeleton":
        """The classes of faces, edges and vertices.

        >>> import tetrarch as tt
        >>> skeleton = tt.Triangulation("cPcbbbihq").skeleton()
        >>> skeleton.num_edges, skeleton.num_vertices, skeleton.links
        (1, 1, ['genus 2'])
        """
        return Skeleton(_tetrarch.skeleton(self._content))

    def info(self, progress: Progress = None) -> Record:
        """What `tetrarch info` says: sizes, validity, boundary, homology, group, signature.

        >>> import tetrarch as tt
        >>> info = tt.Triangulation("cPcbbbihq").info()
        >>> info.edges, info.orientable, info.boundary[0].genus, info.homology
        (1, True, 2, 'Z^2')
        """
        with reporting(progress) as report:
            return Record(_tetrarch.info(self._content, False, report))

    def homology(self, k: int = 1, relative: bool = False) -> AbelianGroup:
        """H_k with integer coefficients, of the manifold with its ideal vertices truncated; relative: modulo its boundary.

        >>> import tetrarch as tt
        >>> tt.Manifold("m003").homology()
        Z + Z/5
        >>> tt.Manifold("m003").homology().torsion
        (5,)
        """
        return AbelianGroup(_tetrarch.homology(self._content, _integer(k, "k"), bool(relative)))

    def fundamental_groups(self, simplify: bool = True, progress: Progress = None) -> List[FundamentalGroup]:
        """The fundamental group of each component, in the order of their first tetrahedra.

        >>> import tetrarch as tt
        >>> tt.Triangulation("cPcbbbihq").fundamental_groups()
        [< a, b, c | abCaBcaCB >]
        """
        with reporting(progress) as report:
            return [FundamentalGroup(*group) for group in _tetrarch.fundamental_groups(self._content, not simplify, report)]

    def identify(self, attempts: int = 1000, seed: int = 1, progress: Progress = None) -> Result:
        """The name of the manifold, whatever its triangulation: `name`, `by`, `volume`, `tried`.

        The result is true if a name was found. That none was found proves nothing.

        >>> import tetrarch as tt
        >>> found = tt.Triangulation("cPcbbbihq").identify()
        >>> found.name, found.by
        ('fmp2_8', 'isometry signature')
        """
        with reporting(progress) as report:
            verdict, fields = _tetrarch.identify(self._content, _integer(attempts, "attempts"), _seed(seed), report)
        return Result(fields, verdict, fields["name"] or "no name found")

    def is_isomorphic_to(self, other: "Gluings") -> bool:
        """Whether the two have the same gluings up to labels.

        >>> import tetrarch as tt
        >>> tt.Triangulation("cPcbbbihq").is_isomorphic_to(tt.Triangulation("fmp2_8"))
        True
        """
        return self.isoSig() == other.isoSig()

    def copy(self: _Own) -> _Own:
        """The same object: it never changes.

        >>> import tetrarch as tt
        >>> M = tt.Manifold("m004")
        >>> M.copy() is M
        True
        """
        return self

    def __copy__(self: _Own) -> _Own:
        return self

    def __deepcopy__(self: _Own, memo: Any) -> _Own:
        return self

    def __eq__(self, other: object) -> bool:
        """The same gluings with the same labels."""
        if not isinstance(other, Gluings):
            return NotImplemented
        return type(self) is type(other) and _tetrarch.same_gluings(self._content, other._content)

    def __hash__(self) -> int:
        return hash((type(self), self.isoSig()))

    def __getstate__(self) -> Any:
        return {"_content": self._content}

    def __setstate__(self, state: Any) -> None:
        Gluings.__init__(self, state["_content"])

    def __repr__(self) -> str:
        called = self.name()
        if not called:
            called = self.isoSig() if len(self) <= 1000 else "%d tetrahedra" % len(self)
        return "%s(%r)" % (type(self).__name__, called if len(called) <= 60 else called[:57] + "...")


def _integer(value: Any, name: str) -> int:
    try:
        number = int(value.__index__())
    except (AttributeError, TypeError):
        raise InputError("%s is %s (expected an integer)" % (name, shown(value))) from None
    if not -2**31 <= number < 2**31:
        raise InputError("%s is %d, which is too large" % (name, number))
    return number


def _seed(value: Any) -> int:
    try:
        number = int(value.__index__())
    except (AttributeError, TypeError):
        raise InputError("seed is %s (expected an integer)" % shown(value)) from None
    if not 0 <= number < 2**64:
        raise InputError("seed is %d (expected 0 to 2^64 - 1)" % number)
    return number


class Skeleton:
    """The classes of faces, edges and vertices of a triangulation, numbered by their first simplex.

    >>> import tetrarch as tt
    >>> skeleton = tt.Manifold("m004").skeleton()
    >>> skeleton.edge_of.shape, skeleton.valences.tolist(), skeleton.links
    ((2, 6), [6, 6], ['torus'])
    """

    #: of each tetrahedron and face, the tetrahedron across it; -1: none
    neighbors: "npt.NDArray[np.int32]"
    #: of each tetrahedron and face, where the four vertices go; -1 on the boundary
    permutations: "npt.NDArray[np.int32]"
    #: of each tetrahedron, the classes of its faces 0 to 3
    face_of: "npt.NDArray[np.int32]"
    #: of each tetrahedron, the classes of its edges 01, 02, 03, 12, 13, 23
    edge_of: "npt.NDArray[np.int32]"
    #: of each tetrahedron, the classes of its vertices
    vertex_of: "npt.NDArray[np.int32]"
    #: of each edge, the number of tetrahedra around it
    valences: "npt.NDArray[np.int32]"
    #: of each vertex, the type of its link: "sphere", "torus", "genus 2", "disk"
    links: List[str]

    def __init__(self, classes: Any) -> None:
        self.neighbors = classes["neighbors"]
        self.permutations = classes["permutations"].reshape(-1, 4, 4)
        self.face_of = classes["face_of"]
        self.edge_of = classes["edge_of"]
        self.vertex_of = classes["vertex_of"]
        self.valences = classes["valences"]
        self.links = classes["links"]
        #: numbers of classes
        self.num_faces = int(classes["faces"])
        self.num_edges = int(classes["edges"])
        self.num_vertices = int(classes["vertices"])
        self.num_boundary_faces = int(classes["boundary_faces"])
        self.num_components = int(classes["components"])
        self.is_orientable = bool(classes["orientable"])

    def __repr__(self) -> str:
        return "Skeleton(%d faces, %d edges, %d vertices)" % (self.num_faces, self.num_edges, self.num_vertices)


class Move:
    """What became of a move: the new triangulation and how everything is called in it, or why the move is illegal.

    It is true if the move was made.

    >>> import tetrarch as tt
    >>> move = tt.Triangulation("cPcbbbiht").move("2-3", 0, 1)
    >>> bool(move), len(move.triangulation), move.tetrahedra, move.new_tetrahedra
    (True, 3, [-1, -1], [1, 0, 2])
    >>> move = tt.Triangulation("cPcbbbiht").move("3-2", 0, 0, 1)
    >>> bool(move), move.obstacle
    (False, 'another number of tetrahedra meets there')
    """

    #: why the move is illegal; None: it was made
    obstacle: Optional[str]
    #: after the move; where it was not made, as before
    triangulation: "Triangulation"
    #: the new number of each old tetrahedron; -1: it is gone
    tetrahedra: List[int]
    #: the new number of each old vertex class; merged ones share one; -1: it is gone
    vertices: List[int]
    #: the new number of each old edge class; likewise
    edges: List[int]
    #: the numbers of tetrahedra that were not there before
    new_tetrahedra: List[int]
    #: where a vertex class became two: (what `vertices` says, the other part), in new numbers
    split_vertices: List[Tuple[int, int]]
    #: likewise of edges
    split_edges: List[Tuple[int, int]]

    def __init__(self, made: Tuple[Any, ...]) -> None:
        self.obstacle = made[0]
        self.triangulation = Triangulation._of(made[1])
        if self.obstacle is None:
            self.tetrahedra, self.vertices, self.edges, self.new_tetrahedra = made[2:6]
            self.split_vertices, self.split_edges = made[6:]
            return
        skeleton = self.triangulation.skeleton()
        self.tetrahedra = list(range(len(self.triangulation)))
        self.vertices = list(range(skeleton.num_vertices))
        self.edges = list(range(skeleton.num_edges))
        self.new_tetrahedra, self.split_vertices, self.split_edges = [], [], []

    def __bool__(self) -> bool:
        return self.obstacle is None

    def __repr__(self) -> str:
        return "Move(%s)" % ("illegal: " + self.obstacle if self.obstacle else "%d tetrahedra" % len(self.triangulation))


class Triangulation(Gluings):
    """Tetrahedra and the gluings of their faces: a manifold or not, connected or not. It never changes.

    `what` is an isomorphism signature, the name of a manifold, the path of a file, a list of gluings (see `gluings`), arrays
    (V, T) of points and tetrahedra or (V, F) of a closed surface to be filled, another Triangulation or Manifold, an object of
    Regina or SnapPy (anything with `isoSig()` or `snapPea()`), or a mesh of meshio or PyVista. Arrays are copied. `weld`,
    `component` and `repair` mend a mesh first, as the options of `tetrarch truncate` do.

    >>> import tetrarch as tt
    >>> T = tt.Triangulation("cPcbbbihq")
    >>> T, len(T), T.info().valid
    (Triangulation('cPcbbbihq'), 2, True)
    >>> tt.Triangulation([[None] * 4]).homology()
    0
    """

    def __init__(self, what: Any, *, weld: Optional[float] = None, component: Optional[int] = None, repair: bool = False,
                 progress: Progress = None) -> None:
        if isinstance(what, list) and all(isinstance(row, (list, tuple)) and len(row) == 4 and not any(
                isinstance(face, (int, float)) for face in row) for row in what):
            super().__init__(_tetrarch.triangulation_from_gluings(what, ""))
            return
        with reporting(progress) as report:
            content, _ = triangulation_of(what, weld, component, repair, report)
        warn(content.warnings)
        super().__init__(content)

    def move(self, kind: str, *place: int) -> Move:
        """Makes one move, at a place given by numbers: the tetrahedron, then what the kind needs.

        "2-3" tetrahedron face; "3-2" tetrahedron from to; "1-4" tetrahedron; "4-1" tetrahedron vertex; "4-4" tetrahedron from to
        axis; "2-0", "0-2", "2-1", "merge", "open_book", "close_book", "shell", "pinch", "cone": see `tetrarch move --help`. An
        illegal move is a value with its `obstacle`; numbers that are out of range are an error.

        >>> import tetrarch as tt
        >>> move = tt.Triangulation("cPcbbbiht").move("1-4", 1)
        >>> move.tetrahedra, move.new_tetrahedra, move.vertices
        ([0, -1], [1, 2, 3, 4], [0])
        """
        words = [text_of(kind)] + [str(_integer(number, "place")) for number in place]
        return Move(_tetrarch.moved(self._content, " ".join(words)))

    def moves(self, *kinds: str) -> List[Tuple[str, Tuple[int, ...]]]:
        """All legal moves, of these kinds or of all, as arguments of `move`.

        >>> import tetrarch as tt
        >>> T = tt.Triangulation("cPcbbbiht")
        >>> len(T.moves("2-3")), T.moves("2-3")[0]
        (4, ('two_three', (0, 0)))
        >>> all(T.move(kind, *place) for kind, place in T.moves())
        True
        """
        from .commands import run

        listed = run("move", self, *kinds, list=True)
        split = [str(move).split() for move in listed.moves]
        return [(words[0], tuple(int(word) for word in words[1:])) for words in split]

    def simplify(self, keep_boundary: bool = False, seed: int = 1, progress: Progress = None) -> "Triangulation":
        """Fewer tetrahedra, the same manifold; no single move makes the result smaller.

        >>> import tetrarch as tt
        >>> len(tt.Triangulation("gvLQQedfedffrwawrhh").simplify()) <= 6
        True
        """
        from .commands import run

        made: Triangulation = run("simplify", self, keep_boundary=keep_boundary, seed=seed, progress=progress).value
        return made

    def truncate(self, keep_spheres: bool = False, seed: int = 1, progress: Progress = None) -> "Triangulation":
        """The solid as a few truncated tetrahedra: boundary coned, vertices merged away.

        Boundary spheres are filled with balls unless `keep_spheres` is true. `tt.truncate` tells the steps as well.

        >>> import tetrarch as tt
        >>> tt.Triangulation("samples/knotted_y_8k.mesh").truncate().isoSig()
        'cPcbbbihq'
        """
        from .commands import run

        made: Triangulation = run("truncate", self, keep_spheres=keep_spheres, seed=seed, progress=progress).value
        return made

    def components(self) -> List["Triangulation"]:
        """The connected components, in the order of their first tetrahedra.

        >>> import tetrarch as tt
        >>> len(tt.Triangulation([[None] * 4, [None] * 4]).components())
        2
        """
        return [Triangulation._of(content) for content in _tetrarch.components(self._content)]

    def is_valid(self) -> bool:
        """Whether it is a manifold, whose vertices may be ideal.

        >>> import tetrarch as tt
        >>> tt.Triangulation("cPcbbbihq").is_valid()
        True
        """
        return bool(_tetrarch.info(self._content, True, None)["valid"])

    def fundamental_group(self, simplify: bool = True, progress: Progress = None) -> FundamentalGroup:
        """The fundamental group of a connected triangulation.

        >>> import tetrarch as tt
        >>> tt.Triangulation("cPcbbbihq").fundamental_group()
        < a, b, c | abCaBcaCB >
        """
        groups = self.fundamental_groups(simplify, progress)
        if len(groups) != 1:
            raise InputError("the triangulation has %d components (fundamental_groups gives a group for each)" % len(groups))
        return groups[0]


def open_all(path: Union[str, "os.PathLike[str]"], progress: Progress = None) -> List[Triangulation]:
    """All triangulations of a file that holds several, such as a file of Regina.

    One that is bad is passed over with a warning. `tt.Triangulation("knots.rga#3")` is the third alone.

    >>> import tetrarch as tt, tempfile, os
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     path = os.path.join(folder, "two.sig")
    ...     with open(path, "w") as file:
    ...         _ = file.write("cPcbbbiht\\ncPcbbbihq\\n")
    ...     [len(T) for T in tt.open_all(path)]
    [2, 2]
    """
    if not is_text(path):
        raise InputError("a %s stands where a path is expected" % type(path).__name__)
    made: List[Triangulation] = []
    with reporting(progress) as report:
        for number, (name, content, error) in enumerate(_tetrarch.collection(text_of(path), report), 1):
            if content is None:
                warn(["%s#%d: %s" % (text_of(path), number, error)])
            else:
                made.append(Triangulation._of(content))
    return made
