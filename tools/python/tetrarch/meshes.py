# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of surfaces and solids, as arrays: slit maps, bundles, direct products, findings."""
from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional, Sequence, Tuple, Union

from . import _tetrarch
from .commands import run
from .errors import InputError
from .inputs import content_of, is_pair, is_text, mesh_of_pair, text_of
from .progress import Progress, reporting
from .results import Record, Result
from .triangulation import Triangulation

if TYPE_CHECKING:
    import numpy as np
    import numpy.typing as npt

__all__ = ["DirectProduct", "Field", "Mesh", "SlitMap", "direct_product", "slit_map"]


class Field(NamedTuple):
    """Numbers at the vertices, elements or corners of a mesh.

    >>> import tetrarch as tt
    >>> field = tt.slit_map("samples/ring_two_holes.off").mesh.fields["angle"]
    >>> field.on, field.values.ndim
    ('vertices', 1)
    """

    #: "vertices", "triangles", "tetrahedra", "hexahedra", "triangle corners", "tetrahedron corners"
    on: str
    #: one row for each
    values: "npt.NDArray[np.float64]"


class Mesh:
    """A mesh of triangles, tetrahedra or hexahedra with fields. It never changes, and its arrays look into it without a copy.

    `points` is (n, 3), or (n, 2) for a plane; `triangles` (m, 3) and `tetrahedra` (k, 4) are indices from 0; tags say to which
    patch or region each belongs. Any type of integers or reals, any order in memory, read-only or not; lists do, too. The numbers
    are copied once. Nothing is checked here: `tt.check` finds faults, and what needs a good mesh refuses a bad one.

    >>> import numpy as np, tetrarch as tt
    >>> mesh = tt.Mesh([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], tetrahedra=[[0, 1, 2, 3]])
    >>> mesh, mesh.tetrahedra.dtype
    (Mesh(4 points, 1 tetrahedron), dtype('int32'))
    >>> tt.Triangulation(mesh).homology()
    0
    """

    _content: _tetrarch.Content

    def __init__(self, points: Any, triangles: Any = None, tetrahedra: Any = None, *, triangle_tags: Any = None,
                 tetrahedron_tags: Any = None) -> None:
        self._content = _tetrarch.mesh_from_arrays(points, triangles, tetrahedra, triangle_tags, tetrahedron_tags, "<arrays>")

    @classmethod
    def _of(cls, content: _tetrarch.Content) -> "Mesh":
        made = cls.__new__(cls)
        made._content = content
        return made

    @classmethod
    def read(cls, what: Any, progress: Progress = None) -> "Mesh":
        """Of a file, of arrays (V, F) or (V, T), or of a mesh of meshio, PyVista or trimesh.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/cube.off")
        Mesh(8 points, 12 triangles)
        """
        if isinstance(what, Mesh):
            return what
        if not is_text(what):
            content = content_of(what, "<arrays>")
            if content.kind not in ("mesh", "surface"):
                raise InputError("a %s stands where a mesh is expected" % content.kind)
            return cls._of(content)
        with reporting(progress) as report:
            return cls._of(_tetrarch.open_mesh(text_of(what), report))

    @property
    def points(self) -> "npt.NDArray[np.float64]":
        """(n, 3). No copy.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/cube.off").points.shape
        (8, 3)
        """
        return self._content.array("points")

    @property
    def triangles(self) -> "npt.NDArray[np.int32]":
        """(m, 3), indices of points. No copy.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/cube.off").triangles.shape
        (12, 3)
        """
        return self._content.array("triangles")

    @property
    def tetrahedra(self) -> "npt.NDArray[np.int32]":
        """(k, 4), indices of points. No copy.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/knotted_y_8k.mesh").tetrahedra.shape
        (7709, 4)
        """
        return self._content.array("tetrahedra")

    @property
    def hexahedra(self) -> "npt.NDArray[np.int32]":
        """(k, 8), indices of points: the bottom, then the top, counter-clockwise from above. No copy.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/cube.off").hexahedra.shape
        (0, 8)
        """
        return self._content.array("hexahedra")

    @property
    def triangle_tags(self) -> "npt.NDArray[np.int32]":
        """The patch of each triangle; empty if there are none.

        >>> import tetrarch as tt
        >>> sorted(set(tt.Mesh.read("samples/genus4_ridges.mesh").triangle_tags.tolist()))
        [1, 2, 3, 4, 5, 6, 7]
        """
        return self._content.array("triangle_tags")

    @property
    def tetrahedron_tags(self) -> "npt.NDArray[np.int32]":
        """The region of each tetrahedron; empty if there are none.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/cube.off").tetrahedron_tags.size
        0
        """
        return self._content.array("tetrahedron_tags")

    @property
    def fields(self) -> Dict[str, Field]:
        """What is known at points and elements, by name. No copy.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/cube.off").fields
        {}
        """
        return {name: Field(on, values) for name, on, values in self._content.fields()}

    @property
    def cells(self) -> List[Tuple[str, "npt.NDArray[np.int32]"]]:
        """As meshio has them: `meshio.Mesh(mesh.points, mesh.cells)`.

        >>> import tetrarch as tt
        >>> [(kind, len(rows)) for kind, rows in tt.Mesh.read("samples/cube.off").cells]
        [('triangle', 12)]
        """
        kinds = {"triangle": self.triangles, "tetra": self.tetrahedra, "hexahedron": self.hexahedra}
        return [(kind, rows) for kind, rows in kinds.items() if len(rows)]

    @property
    def faces(self) -> "npt.NDArray[np.int64]":
        """The triangles as PyVista has them: `pyvista.PolyData(mesh.points, mesh.faces)`. A copy.

        >>> import tetrarch as tt
        >>> tt.Mesh.read("samples/cube.off").faces[:4].tolist()[0]
        3
        """
        import numpy as np

        triangles = self.triangles
        return np.column_stack([np.full(len(triangles), 3), triangles]).astype(np.int64).ravel()

    def save(self, path: Union[str, "os.PathLike[str]"]) -> None:
        """Writes a file, whose extension names the format: .json (with all fields), .obj, .off, .ply, .mesh, .vtu, ...

        >>> import tetrarch as tt, tempfile
        >>> with tempfile.TemporaryDirectory() as folder:
        ...     tt.Mesh.read("samples/cube.off").save(folder + "/cube.obj")
        ...     tt.Mesh.read(folder + "/cube.obj")
        Mesh(8 points, 12 triangles)
        """
        run("convert", self, output=path)

    def __getstate__(self) -> Any:
        return {"_content": self._content}

    def __setstate__(self, state: Any) -> None:
        self._content = state["_content"]

    def __copy__(self) -> "Mesh":
        return self

    def __deepcopy__(self, memo: Any) -> "Mesh":
        return self

    def __repr__(self) -> str:
        counts = [(len(self.points), "point", "points"), (len(self.triangles), "triangle", "triangles"),
                  (len(self.tetrahedra), "tetrahedron", "tetrahedra"), (len(self.hexahedra), "hexahedron", "hexahedra")]
        return "Mesh(%s)" % ", ".join("%d %s" % (n, one if n == 1 else many) for n, one, many in counts if n or one == "point")


def as_mesh(arguments: Tuple[Any, ...], extra: Optional[Dict[str, Any]] = None, progress: Progress = None) -> Mesh:
    """Of one argument whatever Mesh.read takes, of two points and elements."""
    if len(arguments) == 2:
        return Mesh._of(mesh_of_pair(arguments[0], arguments[1], "<arrays>", **(extra or {})))
    if len(arguments) != 1:
        raise TypeError("expected a mesh, or arrays of points and elements")
    if extra:
        if not is_pair(arguments[0]):
            raise InputError("%s stands beside no arrays" % ", ".join(extra))
        return Mesh._of(mesh_of_pair(arguments[0][0], arguments[0][1], "<arrays>", **extra))
    return Mesh.read(arguments[0], progress)


class _Made:
    """A result of a command and the mesh that came with it: the result's fields are attributes."""

    #: what the command found
    result: Result

    def __init__(self, result: Result, source: Mesh, options: Dict[str, Any]) -> None:
        self.result = result
        self._source = source
        self._options = options

    @property
    def mesh(self) -> Mesh:
        """The mesh with its coordinates as fields; without a result: PreconditionError.

        >>> import tetrarch as tt
        >>> sorted(tt.slit_map("samples/ring_two_holes.off", domain="circular").mesh.fields)[:2]
        ['log_factor', 'place']
        """
        from .errors import PreconditionError

        if self.result.value is None:
            raise PreconditionError("there is no map: " + "; ".join(self.result.warnings or [self.result.verdict]))
        made: Mesh = self.result.value
        return made

    @property
    def verdict(self) -> str:
        """"yes", "no" or "undecided".

        >>> import tetrarch as tt
        >>> tt.slit_map("samples/ring_two_holes.off").verdict
        'yes'
        """
        return self.result.verdict

    def __getattr__(self, name: str) -> Any:
        if name.startswith("_") or name == "result":
            raise AttributeError(name)
        return getattr(self.result, name)

    def __bool__(self) -> bool:
        return bool(self.result)

    def __str__(self) -> str:
        return str(self.result)


class SlitMap(_Made):
    """A conformal map of a surface with holes; the fields of `tetrarch slit --json` are attributes.

    >>> import tetrarch as tt
    >>> found = tt.slit_map("samples/ring_two_holes.off", domain="circular")
    >>> found.uv.shape[1], len(found.loops), found.flipped
    (2, 3, 0)
    """

    @property
    def uv(self) -> "npt.NDArray[np.float64]":
        """Of each vertex of `mesh` its place in the domain, (n, 2). A copy.

        The vertices are those that were given, unless one of the options punch, slice, open_handles, weld, component and repair made
        another surface.
        In the domains "cylindric" and "parallel" a vertex on the seam has two places, of which this is one; `corner_uv` has both.
        A vertex in no triangle has NaN.

        >>> import tetrarch as tt, numpy as np
        >>> uv = tt.slit_map("samples/ring_two_holes.off", domain="circular").uv
        >>> bool((np.hypot(*uv.T) <= 1 + 1e-9).all())
        True
        """
        places: "npt.NDArray[np.float64]" = self.mesh._content.at_vertices("place")
        return places

    @property
    def corner_uv(self) -> "npt.NDArray[np.float64]":
        """Of each triangle and corner its place in the domain, (m, 3, 2). No copy.

        >>> import tetrarch as tt
        >>> tt.slit_map("samples/ring_two_holes.off").corner_uv.shape[1:]
        (3, 2)
        """
        return self.mesh.fields["place"].values

    @property
    def loops(self) -> List[Record]:
        """The boundary loops, by decreasing length.

        >>> import tetrarch as tt
        >>> len(tt.slit_map("samples/ring_two_holes.off").loops)
        3
        """
        listed: List[Record] = self.result["boundaries"]
        return listed

    def fingerprint(self, progress: Progress = None) -> Result:
        """The conformal invariants with their errors: what `tetrarch slit --fingerprint` finds.

        >>> import tetrarch as tt
        >>> tt.slit_map("samples/ring_two_holes.off").fingerprint().verdict
        'yes'
        """
        kept = {name: value for name, value in self._options.items() if name in ("outer", "inner", *_CHANGING)}
        made: Result = run("slit", self._source, fingerprint=True, progress=progress, **kept)
        return made

    def __repr__(self) -> str:
        return "SlitMap(%s, %d loops)" % (self.result["domain"], len(self.loops))

    def _repr_html_(self) -> str:
        from .page import frame

        return frame("slit", self._source, **self._options)


#: Options by which the surface mapped is another one than that which was given.
_CHANGING = ("punch", "slice", "open_handles", "weld", "component", "repair")


def slit_map(*surface: Any, progress: Progress = None, **options: Any) -> SlitMap:
    """Maps a sphere with holes conformally to a domain with slits, or to a disk with round holes.

    `surface` is arrays V, F of points and triangles, or anything that Mesh.read takes; the options are those of `tetrarch slit`
    and of `tt.slit`: domain="concentric", outer, inner, method, unflip, ... V and F are copied once.

    >>> import tetrarch as tt
    >>> ring = tt.Mesh.read("samples/ring_two_holes.off")
    >>> found = tt.slit_map(ring.points, ring.triangles, domain="circular")
    >>> found, found.verdict
    (SlitMap(circular, 3 loops), 'yes')
    """
    for name in ("list_loops", "fingerprint", "distance"):
        if options.get(name):
            raise InputError("%s asks for no map (tt.slit has it)" % name)
    if len(surface) == 2 and not any(options.get(name) for name in _CHANGING):
        # The arrays are the caller's: no copy of them stays while the map is sought.
        found = run("slit", surface, progress=progress, **options)
        return SlitMap(found, found.value, options)
    mesh = as_mesh(surface, progress=progress)
    return SlitMap(run("slit", mesh, progress=progress, **options), mesh, options)


class DirectProduct(_Made):
    """Coordinates of a handlebody, or why it has none; the fields of `tetrarch product --json` are attributes.

    >>> import tetrarch as tt
    >>> made = tt.direct_product("samples/genus4_ridges.mesh", labels=(1, 2))
    >>> made.uvw.shape[1], made.holes, made.flipped
    (3, 4, 0)
    """

    @property
    def uvw(self) -> "npt.NDArray[np.float64]":
        """Of each vertex of `solid` its coordinates, (n, 3). The first are those given that are in a tetrahedron. No copy.

        >>> import tetrarch as tt
        >>> made = tt.direct_product("samples/genus4_ridges.mesh", labels=(1, 2))
        >>> len(made.uvw) == len(made.solid.points)
        True
        """
        return self.solid.fields["uvw"].values

    @property
    def solid(self) -> Mesh:
        """The solid, some of whose edges were split on the way.

        >>> import tetrarch as tt
        >>> "uvw" in tt.direct_product("samples/genus4_ridges.mesh", labels=(1, 2)).solid.fields
        True
        """
        if "uvw" in self.mesh.fields:
            return self.mesh
        plain = {name: value for name, value in self._options.items() if name not in ("hex", "layers", "smooth", "polycube", "cells")}
        if "hex" in self._options:
            plain["floor_map"] = "rectangle"
        return DirectProduct(run("product", self._source, **plain), self._source, plain).mesh

    @property
    def hexahedra(self) -> "npt.NDArray[np.int32]":
        """(k, 8), indices of `mesh.points`, if hex or polycube asked for them; else none. No copy.

        >>> import tetrarch as tt
        >>> tt.direct_product("samples/genus4_ridges.mesh", labels=(1, 2)).hexahedra.shape
        (0, 8)
        """
        return self.mesh.hexahedra

    @property
    def scaled_jacobian(self) -> "npt.NDArray[np.float64]":
        """Of each hexahedron its scaled Jacobian. No copy.

        >>> import tetrarch as tt
        >>> made = tt.direct_product("samples/genus4_ridges.mesh", labels=(1, 2), hex=8)
        >>> len(made.scaled_jacobian) == len(made.hexahedra) > 0
        True
        """
        import numpy as np

        field = self.mesh.fields.get("scaled_jacobian")
        return np.empty(0) if field is None else field.values

    def __repr__(self) -> str:
        return "DirectProduct(%s)" % self.verdict

    def _repr_html_(self) -> str:
        from .page import frame

        return frame("product", self._source, **self._options)


def direct_product(*solid: Any, triangles: Any = None, triangle_tags: Any = None, progress: Progress = None,
                   **options: Any) -> DirectProduct:
    """Coordinates of a handlebody in (a disk with holes) x (an interval), and hexahedra.

    `solid` is arrays V, T of points and tetrahedra, or anything that Mesh.read takes; the options are those of `tetrarch product`
    and of `tt.product`: labels=(floor, ceiling), hex, polycube, ... The labels are those of `triangle_tags` on boundary
    `triangles`, or of the file. Arrays are copied once.

    >>> import tetrarch as tt
    >>> mesh = tt.Mesh.read("samples/genus4_ridges.mesh")
    >>> made = tt.direct_product(mesh.points, mesh.tetrahedra, triangles=mesh.triangles, triangle_tags=mesh.triangle_tags,
    ...                          labels=(1, 2))
    >>> made.verdict
    'yes'
    """
    extra = {name: value for name, value in (("triangles", triangles), ("triangle_tags", triangle_tags)) if value is not None}
    mesh = as_mesh(solid, extra, progress)
    return DirectProduct(run("product", mesh, progress=progress, **options), mesh, options)
