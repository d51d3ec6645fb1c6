# SPDX-License-Identifier: GPL-2.0-or-later
"""Manifolds and their hyperbolic structures."""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple, Union, overload

from . import _tetrarch
from .errors import InputError, PreconditionError, shown
from .groups import FundamentalGroup
from .inputs import triangulation_of, warn
from .progress import Progress, reporting
from .results import Record, Result
from .triangulation import Gluings, Triangulation, _integer, _seed

if TYPE_CHECKING:
    from typing import Literal

    import numpy as np
    import numpy.typing as npt

__all__ = ["Cells", "Cusp", "FundamentalDomain", "Holonomy", "Isometry", "Manifold", "Structure", "SymmetryGroup"]

_ATTEMPTS = 1000


class Cusp:
    """A cusp of a structure: its vertex, whether it is a torus, its shape, and the area of its cross-section.

    >>> import tetrarch as tt
    >>> cusp, = tt.Manifold("m004").structure().cusps
    >>> cusp.is_torus, round(abs(cusp.shape), 6)
    (True, 3.464102)
    """

    #: the number of its vertex class
    vertex: int
    #: a torus, or else a Klein bottle
    is_torus: bool
    #: the quotient of its two shortest translations; of a Klein bottle that of the torus which covers it twice
    shape: complex
    #: of the cross-section that lengths are measured to
    area: float

    def __init__(self, vertex: int, is_torus: bool, shape: complex, area: float) -> None:
        self.vertex, self.is_torus, self.shape, self.area = vertex, is_torus, shape, area

    def __repr__(self) -> str:
        return "Cusp(%s at vertex %d, shape %.10g%+.10gi)" % (
            "torus" if self.is_torus else "Klein bottle", self.vertex, self.shape.real, self.shape.imag)


class _Told:
    """What the library found, with all that the command of the same name tells: its fields are attributes. True on "yes"."""

    _found: Any

    def __init__(self, found: Any) -> None:
        self._found = found
        self._fields: Optional[Record] = None

    @property
    def verdict(self) -> str:
        """"yes", "no" (proved) or "undecided" (none was found).

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").structure().verdict, tt.Manifold("m004").canonical_cells().verdict
        ('yes', 'yes')
        """
        verdict: str = self._found.verdict
        return verdict

    def as_dict(self) -> Dict[str, Any]:
        """All fields of the command's `--json`.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").structure().as_dict()["outcome"]
        'geometric'
        >>> tt.Manifold("fmp2_8").canonical_cells().as_dict()["outcome"]
        'canonical'
        """
        return self._record().as_dict()

    def _record(self) -> Record:
        if self._fields is None:
            self._fields = Record(self._found.tree())
        return self._fields

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_"):
            raise AttributeError(name)
        return getattr(self._record(), name)

    def __bool__(self) -> bool:
        return self.verdict == "yes"


class Structure(_Told):
    """A hyperbolic structure, or why none was found; true if there is one.

    The fields of `tetrarch hyperbolize --json` are attributes, too: `outcome`, `reason`, `residual`, `volume_error`, ...

    >>> import tetrarch as tt
    >>> structure = tt.Manifold("cPcbbbihq").structure()
    >>> bool(structure), structure.outcome, structure.triangulation
    (True, 'geometric', Triangulation('cPcbbbihq'))
    >>> structure.dihedral_angles.shape, structure.edge_lengths.shape
    ((2, 6), (1,))
    """

    _found: _tetrarch.Solved

    @property
    def volume(self) -> Optional[float]:
        """The volume in curvature -1; None without a structure.

        >>> import tetrarch as tt
        >>> round(tt.Manifold("m004").structure().volume, 9)
        2.029883213
        """
        return self._found.volume

    @property
    def dihedral_angles(self) -> "npt.NDArray[np.float64]":
        """Radians, of each tetrahedron at its edges 01, 02, 03, 12, 13, 23; an array that looks into the structure, no copy.

        >>> import tetrarch as tt
        >>> tt.Manifold("cPcbbbihq").structure().dihedral_angles.flags.writeable
        False
        """
        return self._found.dihedral_angles

    @property
    def edge_lengths(self) -> "npt.NDArray[np.float64]":
        """The length of each edge class; of one into a cusp, to the horosphere there. No copy.

        >>> import tetrarch as tt
        >>> round(float(tt.Manifold("cPcbbbihq").structure().edge_lengths[0]), 6)
        0.596134
        """
        return self._found.edge_lengths

    @property
    def cusps(self) -> List[Cusp]:
        """The cusps and their shapes.

        >>> import tetrarch as tt
        >>> len(tt.Manifold("m129").structure().cusps)
        2
        """
        return [Cusp(*cusp) for cusp in self._found.cusps]

    @property
    def triangulation(self) -> Triangulation:
        """What carries the structure, with its metric: its tetrahedra and edges are those of the arrays.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").structure().triangulation.num_tetrahedra()
        2
        """
        return Triangulation._of(self._found.document())

    def __repr__(self) -> str:
        volume = self.volume
        return "Structure(%s)" % (self.outcome if volume is None else "geometric, volume %.12f" % volume)


class Isometry:
    """A map of canonical triangulations: tetrahedron t goes to `tetrahedra[t]`, its vertex v to `vertices[t][v]`.

    >>> import tetrarch as tt
    >>> isometry = tt.Manifold("m004").symmetry_group().isometries[0]
    >>> isometry.tetrahedra, isometry.vertices[0]
    ((0, 1), (0, 1, 2, 3))
    """

    __slots__ = ("tetrahedra", "vertices")

    tetrahedra: Tuple[int, ...]
    vertices: Tuple[Tuple[int, int, int, int], ...]

    def __init__(self, tetrahedra: Sequence[int], vertices: Sequence[Sequence[int]]) -> None:
        self.tetrahedra = tuple(tetrahedra)
        self.vertices = tuple((v[0], v[1], v[2], v[3]) for v in vertices)

    def __matmul__(self, first: "Isometry") -> "Isometry":
        """This after `first`."""
        vertices = [[self.vertices[image][v] for v in corners] for image, corners in zip(first.tetrahedra, first.vertices)]
        return Isometry([self.tetrahedra[image] for image in first.tetrahedra], vertices)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Isometry) and (self.tetrahedra, self.vertices) == (other.tetrahedra, other.vertices)

    def __hash__(self) -> int:
        return hash((self.tetrahedra, self.vertices))

    def __repr__(self) -> str:
        return "Isometry(%s)" % ", ".join("%d -> %d %s" % (t, image, "".join(map(str, corners))) for t, (image, corners) in
                                          enumerate(zip(self.tetrahedra, self.vertices)))


def _sign(permutation: Sequence[int]) -> int:
    return -1 if sum(permutation[i] > permutation[j] for i in range(4) for j in range(i + 1, 4)) % 2 else 1


class SymmetryGroup:
    """The isometries of a manifold to itself.

    >>> import tetrarch as tt
    >>> group = tt.Manifold("m004").symmetry_group()
    >>> group.order(), group.is_abelian(), group.is_amphicheiral()
    (8, False, True)
    """

    #: the isometries; the identity is the first
    isometries: List[Isometry]

    def __init__(self, isometries: List[Isometry], orientation: Optional[List[int]]) -> None:
        self.isometries = sorted(isometries, key=lambda m: any(v != (0, 1, 2, 3) for v in m.vertices) or
                                 m.tetrahedra != tuple(range(len(m.tetrahedra))))
        self._orientation = orientation

    def order(self) -> int:
        """How many there are.

        >>> import tetrarch as tt
        >>> tt.Manifold("m003").symmetry_group().order()
        8
        """
        return len(self.isometries)

    def is_trivial(self) -> bool:
        """Whether the identity is the only one.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").symmetry_group().is_trivial()
        False
        """
        return self.order() == 1

    def is_abelian(self) -> bool:
        """Whether any two commute.

        >>> import tetrarch as tt
        >>> tt.Manifold("m003").symmetry_group().is_abelian()
        True
        """
        return all(a @ b == b @ a for a in self.isometries for b in self.isometries)

    def is_amphicheiral(self) -> bool:
        """Whether some isometry reverses the orientation; of a non-orientable manifold False.

        >>> import tetrarch as tt
        >>> tt.Manifold("m003").symmetry_group().is_amphicheiral()
        True
        """
        signs = self._orientation
        return signs is not None and any(
            signs[0] * signs[m.tetrahedra[0]] * _sign(m.vertices[0]) < 0 for m in self.isometries)

    def multiplication_table(self) -> List[List[int]]:
        """Row a, column b: the number of a after b.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").symmetry_group().multiplication_table()[0]
        [0, 1, 2, 3, 4, 5, 6, 7]
        """
        number = {isometry: k for k, isometry in enumerate(self.isometries)}
        return [[number[a @ b] for b in self.isometries] for a in self.isometries]

    def __len__(self) -> int:
        return self.order()

    def __repr__(self) -> str:
        return "SymmetryGroup(order %d)" % self.order()


class Cells(_Told):
    """The canonical cells, or why there are none; true if there are. The fields of `tetrarch canonize --json` are attributes.

    >>> import tetrarch as tt
    >>> cells = tt.Manifold("m004").canonical_cells()
    >>> cells.cells, cells.isometry_group_order, len(cells.triangulation)
    (['tetrahedron', 'tetrahedron'], 8, 2)
    """

    _found: _tetrarch.Canonized

    @property
    def triangulation(self) -> Triangulation:
        """The canonical triangulation: the cells, coned where they are no tetrahedra.

        >>> import tetrarch as tt
        >>> tt.Manifold("fmp2_8").canonical_cells().triangulation
        Triangulation('cPcbbbihq')
        """
        return Triangulation._of(self._found.triangulation())

    def __repr__(self) -> str:
        return "Cells(%s)" % (", ".join(self.cells) if self else self.reason)


class Holonomy:
    """The representation of the fundamental group by isometries of hyperbolic space.

    >>> import tetrarch as tt
    >>> holonomy = tt.Manifold("m004").holonomy()
    >>> holonomy.group.num_generators(), holonomy.SL2C.shape, holonomy.SO31.shape
    (3, (3, 2, 2), (3, 4, 4))
    >>> import numpy as np
    >>> bool(np.allclose(np.linalg.det(holonomy.SL2C), 1))
    True
    >>> all(np.allclose(holonomy(word), np.eye(4)) for word in holonomy.group.words)
    True
    """

    #: the presentation, not simplified: a generator for each face outside a spanning tree
    group: FundamentalGroup
    #: of each generator its matrix in SO(3,1), for the form x^2 + y^2 + z^2 - t^2
    SO31: "npt.NDArray[np.float64]"
    #: of each generator its matrix in SL(2,C), up to sign; of one that reverses the orientation, acting after conjugation
    SL2C: "npt.NDArray[np.complex128]"
    #: of each generator, whether it reverses the orientation
    reverses: List[bool]

    def __init__(self, domain: Any) -> None:
        self.group = FundamentalGroup(domain["generators"], domain["relators"])
        self.SO31 = domain["holonomy"]
        self.SL2C = domain["sl2c"]
        self.reverses = domain["reverses"]

    def __call__(self, word: Union[str, Sequence[int]]) -> "npt.NDArray[np.float64]":
        """The matrix in SO(3,1) of a word, such as "abA" or (1, 2, -1)."""
        import numpy as np

        letters = {letter: k + 1 for k, letter in enumerate(self.group.generators())} if isinstance(word, str) else {}
        product: "npt.NDArray[np.float64]" = np.eye(4)
        form = np.diag([1.0, 1.0, 1.0, -1.0])
        for letter in word:
            if isinstance(letter, str):
                letter = letters.get(letter, -letters.get(letter.lower(), 0))
            if not 1 <= abs(letter) <= self.group.num_generators():
                raise InputError("%s is no word in the %d generators" % (shown(word), self.group.num_generators()))
            matrix = self.SO31[abs(letter) - 1]
            product = product @ (matrix if letter > 0 else form @ matrix.T @ form)
        return product

    def __repr__(self) -> str:
        return "Holonomy(%d generators)" % self.group.num_generators()


class FundamentalDomain:
    """The tetrahedra of a manifold put down in hyperbolic space, and the isometries that pair the open faces.

    A vector (x, y, z, t) of the hyperboloid model stands for each vertex: a point of the sheet if the vertex is finite, a vector
    of the light cone if it is a cusp, the unit normal of its plane if it is truncated.

    >>> import tetrarch as tt
    >>> domain = tt.Manifold("cPcbbbihq").fundamental_domain()
    >>> domain.vertices.shape, len(domain.faces), domain.pairings.shape
    ((2, 4, 4), 6, (6, 4, 4))
    """

    #: of each tetrahedron and vertex a vector
    vertices: "npt.NDArray[np.float64]"
    #: of each gluable face its triangles, as (tetrahedron, face), and the number of its partner
    faces: List[Tuple[List[Tuple[int, int]], int]]
    #: of each gluable face the matrix in SO(3,1) that takes the domain to the copy behind it
    pairings: "npt.NDArray[np.float64]"
    #: the representation of the fundamental group
    holonomy: Holonomy

    def __init__(self, domain: Any, triangulation: Triangulation) -> None:
        self.vertices = domain["vertices"]
        self.faces = domain["faces"]
        self.pairings = domain["pairings"]
        self.holonomy = Holonomy(domain)
        #: what was put down
        self.triangulation = triangulation

    def __repr__(self) -> str:
        return "FundamentalDomain(%d tetrahedra, %d gluable faces)" % (len(self.vertices), len(self.faces))

    def _repr_html_(self) -> str:
        from .page import frame

        return frame("view", self.triangulation)


class Manifold(Gluings):
    """A connected 3-manifold, given by any triangulation, with its hyperbolic structure. It never changes.

    `what` is anything that a Triangulation is made of: a name ("m004", "fmp3_17", "L(7,2)"), a signature, a path, arrays (V, T),
    an object of Regina or SnapPy. The answers are about this manifold, whatever triangulation carries them; where a boundary
    sphere was filled with a ball on the way, the result says so. Structures are sought once and kept.

    Manifolds may be shared among threads.

    >>> import tetrarch as tt
    >>> M = tt.Manifold("m004")
    >>> round(M.volume(), 9), M.homology(), M.is_isometric_to(tt.Manifold("4_1"))
    (2.029883213, Z, True)
    """

    def __init__(self, what: Any, *, weld: Optional[float] = None, component: Optional[int] = None, repair: bool = False,
                 progress: Progress = None) -> None:
        with reporting(progress) as report:
            content, source = triangulation_of(what, weld, component, repair, report)
        if content.warnings:
            warn(content.warnings)
        _tetrarch.require_manifold(content, source)
        super().__init__(content)
        self._structure: Optional[Structure] = None
        self._cells: Optional[Cells] = None

    @classmethod
    def _of(cls, content: _tetrarch.Content) -> "Manifold":
        _tetrarch.require_manifold(content, content.name or "<value>")
        made = cls.__new__(cls)
        made.__setstate__({"_content": content})
        return made

    def __setstate__(self, state: Any) -> None:
        super().__setstate__(state)
        self._structure = None
        self._cells = None

    def triangulation(self) -> Triangulation:
        """The triangulation that was given.

        >>> import tetrarch as tt
        >>> tt.Manifold("cPcbbbihq").triangulation()
        Triangulation('cPcbbbihq')
        """
        return Triangulation._of(self._content)

    def structure(self, method: "Literal['newton', 'flow']" = "newton", as_given: bool = False, attempts: int = _ATTEMPTS,
                  seed: int = 1, progress: Progress = None) -> Structure:
        """The hyperbolic structure with geodesic boundary and cusps, or why none was found.

        The arguments are the options of `tetrarch hyperbolize`.

        >>> import tetrarch as tt
        >>> tt.Manifold("cPcbbbihq").structure()
        Structure(geometric, volume 6.451990270835)
        >>> tt.Manifold("L(7,2)").structure().verdict
        'no'
        """
        usual = method == "newton" and not as_given and attempts == _ATTEMPTS and seed == 1
        if usual and self._structure is not None:
            return self._structure
        if method not in ("newton", "flow"):
            raise InputError("method is %s (expected newton or flow)" % shown(method))
        count = _integer(attempts, "attempts")
        if count < 1:
            raise InputError("attempts is %d (expected 1 at least)" % count)
        with reporting(progress) as report:
            found = Structure(_tetrarch.structure(self._content, method == "flow", bool(as_given), count, _seed(seed), report))
        if usual:
            self._structure = found
        return found

    def volume(self) -> Optional[float]:
        """The volume in curvature -1; None if no structure was found (`structure` says why).

        >>> import tetrarch as tt
        >>> round(tt.Manifold("fmp2_8").volume(), 12)
        6.451990270835
        >>> tt.Manifold("S^3").volume() is None
        True
        """
        return (self._structure or self.structure()).volume

    def dihedral_angles(self) -> "npt.NDArray[np.float64]":
        """Radians, of each tetrahedron of `structure().triangulation`, at its edges 01, 02, 03, 12, 13, 23. No copy.

        >>> import tetrarch as tt, math
        >>> angles = tt.Manifold("cPcbbbihq").dihedral_angles()
        >>> angles.shape, round(float(angles[0, 0] / math.pi), 6)
        ((2, 6), 0.166667)
        """
        return self._found().dihedral_angles

    def edge_lengths(self) -> "npt.NDArray[np.float64]":
        """The length of each edge class of `structure().triangulation`. No copy.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").edge_lengths().shape
        (2,)
        """
        return self._found().edge_lengths

    def num_cusps(self) -> int:
        """The number of vertices whose link is a torus or a Klein bottle.

        >>> import tetrarch as tt
        >>> tt.Manifold("m129").num_cusps(), tt.Manifold("fmp2_8").num_cusps()
        (2, 0)
        """
        return sum(link in ("torus", "Klein bottle") for link in self.skeleton().links)

    def is_orientable(self) -> bool:
        """Whether it is orientable.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").is_orientable()
        True
        """
        return self.skeleton().is_orientable

    def fundamental_group(self, simplify: bool = True, progress: Progress = None) -> FundamentalGroup:
        """A presentation of the fundamental group.

        >>> import tetrarch as tt
        >>> tt.Manifold("cPcbbbihq").fundamental_group()
        < a, b, c | abCaBcaCB >
        """
        return self.fundamental_groups(simplify, progress)[0]

    def canonical_cells(self, attempts: int = _ATTEMPTS, seed: int = 1, progress: Progress = None) -> Cells:
        """The canonical (Epstein-Penner-Kojima) cells, or why there are none.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").canonical_cells()
        Cells(tetrahedron, tetrahedron)
        """
        usual = attempts == _ATTEMPTS and seed == 1
        if usual and self._cells is not None:
            return self._cells
        with reporting(progress) as report:
            found = Cells(_tetrarch.cells(self._content, _integer(attempts, "attempts"), _seed(seed), report))
        if usual:
            self._cells = found
        return found

    def isometry_signature(self) -> Optional[str]:
        """A text that two manifolds share if and only if they are isometric; None if no canonical cells were found.

        >>> import tetrarch as tt
        >>> tt.Manifold("fmp2_8").isometry_signature()
        'cPcbbbihq'
        """
        signature: Optional[str] = self.canonical_cells()._record().get("isometry_signature")
        return signature

    def symmetry_group(self) -> SymmetryGroup:
        """The isometries to itself, as maps of the canonical triangulation. Without canonical cells: PreconditionError.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").symmetry_group()
        SymmetryGroup(order 8)
        """
        cells = self._found_cells()._found
        return SymmetryGroup([Isometry(*images) for images in cells.isometries_to(cells)], cells.orientation())

    @overload
    def is_isometric_to(self, other: Any) -> Optional[bool]: ...
    @overload
    def is_isometric_to(self, other: Any, return_isometries: "Literal[False]", attempts: int = ..., seed: int = ...,
                        progress: Progress = ...) -> Optional[bool]: ...
    @overload
    def is_isometric_to(self, other: Any, return_isometries: "Literal[True]", attempts: int = ..., seed: int = ...,
                        progress: Progress = ...) -> Optional[List[Isometry]]: ...

    def is_isometric_to(self, other: Any, return_isometries: bool = False, attempts: int = _ATTEMPTS, seed: int = 1,
                        progress: Progress = None) -> Union[None, bool, List[Isometry]]:
        """Whether two manifolds are isometric: True and False are proved, None is undecided.

        With `return_isometries`, all isometries, as maps between the canonical triangulations (`canonical_cells`): an empty list
        if there are none. `why_isometric_to` tells the reason.

        >>> import tetrarch as tt
        >>> M = tt.Manifold("m004")
        >>> M.is_isometric_to(tt.Manifold("m003"))
        False
        >>> len(M.is_isometric_to(tt.Manifold("4_1"), return_isometries=True))
        8
        """
        found = self.why_isometric_to(other, attempts, seed, progress)
        if not return_isometries:
            return found.get("isometric")  # type: ignore[no-any-return]
        if found.verdict != "yes":
            return None if found.verdict == "undecided" else []
        there = _as_manifold(other)._found_cells()._found
        return [Isometry(*images) for images in self._found_cells()._found.isometries_to(there)]

    def why_isometric_to(self, other: Any, attempts: int = _ATTEMPTS, seed: int = 1, progress: Progress = None) -> Result:
        """The same with its reason: `isometric`, `reason`, `proof`, `isometry` as `tetrarch isometric` has them.

        >>> import tetrarch as tt
        >>> found = tt.Manifold("m004").why_isometric_to("m003")
        >>> found.proof, found.reason
        ('homology', 'the first homology differs: Z against Z + Z/5')
        """
        manifold = _as_manifold(other)
        with reporting(progress) as report:
            made = _tetrarch.isometry(self._content, manifold._content, self._spoken(), manifold._spoken(),
                                      _integer(attempts, "attempts"), _seed(seed), report)
        verdict, fields, text = made
        return Result(fields, verdict, text)

    def fundamental_domain(self, progress: Progress = None) -> FundamentalDomain:
        """The tetrahedra put down in hyperbolic space. Without a structure: PreconditionError.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").fundamental_domain()
        FundamentalDomain(2 tetrahedra, 6 gluable faces)
        """
        structure = self._found()
        with reporting(progress) as report:
            return FundamentalDomain(structure._found.domain(report), structure.triangulation)

    def holonomy(self, progress: Progress = None) -> Holonomy:
        """The representation of the fundamental group that the structure gives.

        >>> import tetrarch as tt
        >>> tt.Manifold("m004").holonomy()
        Holonomy(3 generators)
        """
        return self.fundamental_domain(progress).holonomy

    def _spoken(self) -> str:
        return self.name() or (self.isoSig() if len(self) < 100 else "%d tetrahedra" % len(self))

    def _found(self) -> Structure:
        structure = self.structure()
        if not structure:
            raise PreconditionError("%s: no hyperbolic structure was found (structure() says why)" % self._spoken())
        return structure

    def _found_cells(self) -> Cells:
        cells = self.canonical_cells()
        if not cells:
            raise PreconditionError("%s: no canonical cells were found (canonical_cells() says why)" % self._spoken())
        return cells

    def _repr_html_(self) -> Optional[str]:
        from .page import frame

        return frame("view", self) if self.structure() else None


def _as_manifold(given: Any) -> Manifold:
    return given if isinstance(given, Manifold) else Manifold(given)
