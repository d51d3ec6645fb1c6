#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes a small solid by the program gmsh (Debian package gmsh) and writes it in every format that both know.

    tests/format/record_gmsh.py

The files tests/data/mesh/gmsh_NAME.EXT all hold the same mesh: 10 points, 16 triangles, 11 tetrahedra.
"""
import pathlib
import subprocess
import tempfile

HERE = pathlib.Path(__file__).resolve().parent.parent / "data" / "mesh"
GEOMETRY = """
Point(11) = {0, 0, 0, 1}; Point(12) = {1, 0, 0, 1}; Point(15) = {0, 1, 0, 1}; Point(17) = {0, 0, 1, 0.7};
Line(1) = {11, 12}; Line(2) = {12, 15}; Line(3) = {15, 11}; Line(4) = {11, 17}; Line(5) = {12, 17}; Line(6) = {15, 17};
Line Loop(1) = {1, 2, 3}; Line Loop(2) = {1, 5, -4}; Line Loop(3) = {2, 6, -5}; Line Loop(4) = {3, 4, -6};
Plane Surface(1) = {1}; Plane Surface(2) = {2}; Plane Surface(3) = {3}; Plane Surface(4) = {4};
Surface Loop(1) = {1, 2, 3, 4}; Volume(1) = {1};
Physical Volume("solid") = {1}; Physical Surface("skin") = {1, 2, 3, 4};
"""
FORMATS = {"22.msh": ["msh22"], "22_binary.msh": ["msh22", "-bin"], "41.msh": ["msh41"],
           "41_binary.msh": ["msh41", "-bin"], "solid.mesh": ["mesh"], "solid.vtk": ["vtk"],
           "solid_binary.vtk": ["vtk", "-bin"]}


def main():
    with tempfile.TemporaryDirectory() as folder:
        geometry = pathlib.Path(folder) / "solid.geo"
        geometry.write_text(GEOMETRY)
        for name, options in FORMATS.items():
            subprocess.run(["gmsh", "-3", str(geometry), "-v", "0", "-o", str(HERE / ("gmsh_" + name)), "-format",
                            *options], check=True)


main()
