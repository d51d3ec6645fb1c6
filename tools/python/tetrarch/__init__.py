# SPDX-License-Identifier: GPL-2.0-or-later
"""Tetrarch: triangulated 3-manifolds and meshes, for topologists and engineers.

    import tetrarch as tt
    M = tt.Manifold("m004")                     # a name, a signature, a file, arrays (V, T), an object of Regina or SnapPy
    M.volume(), M.homology(), M.identify().name
    tt.census(3, boundary=2)[7.0:7.5]          # manifolds of the tables
    tt.slit_map(V, F, domain="circular").uv     # a surface with holes laid flat

Every command of the program is a function, too: `tt.hyperbolize("cPcbbbihq", attempts=10)`. Values never change and may be shared
among threads. Long calls let other threads run and stop at Ctrl-C.
"""
from __future__ import annotations

from typing import TYPE_CHECKING, Any, List

from . import commands
from .census import Census, CensusManifold, census, census_tables
from .commands import run
from .errors import InputError, PreconditionError, TetrarchError
from .groups import AbelianGroup, FundamentalGroup
from .inputs import TetrarchWarning
from .links import Link, SpatialGraph, curve_exterior
from .manifold import (Cells, Cusp, FundamentalDomain, Holonomy, Isometry, Manifold, Structure, SymmetryGroup)
from .meshes import DirectProduct, Field, Mesh, SlitMap, direct_product, slit_map
from .results import Record, Result
from .triangulation import Move, Skeleton, Triangulation, open_all

__all__ = ["AbelianGroup", "Cells", "Census", "CensusManifold", "Cusp", "DirectProduct", "Field", "FundamentalDomain",
           "FundamentalGroup", "Holonomy", "InputError", "Isometry", "Link", "Manifold", "Mesh", "Move", "PreconditionError",
           "Record", "Result", "Skeleton", "SlitMap", "SpatialGraph", "Structure", "SymmetryGroup", "TetrarchError",
           "TetrarchWarning", "Triangulation", "census", "census_tables", "commands", "curve_exterior", "direct_product",
           "open_all", "run", "slit_map"]

if TYPE_CHECKING:  # otherwise they are made when they are first asked for
    # Made by make_stubs.
    from .commands import (bundle, canonize, census_enumerate, census_gluings, census_identify, census_list, census_merge,
                           census_show, census_table, census_validate, check, convert, diagram, drill, embed, exterior, group,
                           help, hex, hyperbolize, info, isometric, move, product, register, simplify, skeleton, slit,
                           subdivide, truncate, verify, view)

    __all__ += ["bundle", "canonize", "census_enumerate", "census_gluings", "census_identify", "census_list", "census_merge",
                "census_show", "census_table", "census_validate", "check", "convert", "diagram", "drill", "embed", "exterior",
                "group", "help", "hex", "hyperbolize", "info", "isometric", "move", "product", "register", "simplify",
                "skeleton", "slit", "subdivide", "truncate", "verify", "view"]


def __getattr__(name: str) -> Any:
    if name == "__version__":
        return commands.table()["version"]
    if not name.startswith("_") and name in commands.functions():
        return commands.function(commands.functions()[name])
    raise AttributeError("module 'tetrarch' has no attribute %r" % name)


def __dir__() -> List[str]:
    return sorted({*globals(), *commands.functions()})
