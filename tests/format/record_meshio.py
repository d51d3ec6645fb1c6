#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes one small mesh, by meshio (Debian package python3-meshio), in every format that meshio and Tetrarch share.

    /usr/bin/python3 tests/format/record_meshio.py

The files tests/data/mesh/meshio_NAME.EXT hold the mesh below: two tetrahedra on five points and one of their
boundary triangles; those of surface formats hold the boundary of the first tetrahedron.
"""
import pathlib

import meshio
import numpy

HERE = pathlib.Path(__file__).resolve().parent.parent / "data" / "mesh"
POINTS = numpy.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.5], [0.1, 0.2, -1e-3]])
SOLID = meshio.Mesh(POINTS, [("triangle", numpy.array([[1, 2, 3]])),
                             ("tetra", numpy.array([[0, 1, 2, 3], [0, 2, 1, 4]]))])
SURFACE = meshio.Mesh(POINTS[:4], [("triangle", numpy.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]))])

SOLIDS = {
    "medit.mesh": ("medit", {}),
    "gmsh22.msh": ("gmsh22", {"binary": False}),
    "gmsh22_binary.msh": ("gmsh22", {"binary": True}),
    "tetgen.node": ("tetgen", {}),
    "vtk42.vtk": ("vtk42", {"binary": False}),
    "vtk42_binary.vtk": ("vtk42", {"binary": True}),
    "vtk51.vtk": ("vtk51", {"binary": False}),
    "vtk51_binary.vtk": ("vtk51", {"binary": True}),
    "text.vtu": ("vtu", {"binary": False}),
    "base64.vtu": ("vtu", {"binary": True, "compression": None}),
    "zlib.vtu": ("vtu", {"binary": True, "compression": "zlib"}),
    "lzma.vtu": ("vtu", {"binary": True, "compression": "lzma"}),
}
SURFACES = {
    "surface.obj": ("obj", {}),
    "surface.off": ("off", {}),
    "surface.stl": ("stl", {"binary": False}),
    "surface_binary.stl": ("stl", {"binary": True}),
    "surface.ply": ("ply", {"binary": False}),
    "surface_binary.ply": ("ply", {"binary": True}),
}


def main():
    HERE.mkdir(parents=True, exist_ok=True)
    for mesh, files in ((SOLID, SOLIDS), (SURFACE, SURFACES)):
        for name, (form, options) in files.items():
            meshio.write(HERE / ("meshio_" + name), mesh, file_format=form, **options)


main()
