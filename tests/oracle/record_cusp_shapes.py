#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records shapes of cusps by the gluing equations that SnapPea's kernel writes down, as Regina 7.3 holds it.

Usage: /usr/bin/python3 tests/oracle/record_cusp_shapes.py > tests/oracle/snappea_cusp_shapes.txt
(Debian's regina-normal and python3-numpy; Regina's module imports only in the system's own Python.)

One manifold a line: name|signature|shape,shape,..., a shape as "real imaginary". The manifolds: every 30th of
census/cusped.txt on whose triangulation the kernel finds a geometric solution. A non-orientable manifold has the shapes
of its orientable double cover: of a Klein bottle one, of a torus two.

The way: logarithms of the tetrahedra's shapes move along the solutions of the edge equations such that the holonomy of
one meridian moves by 1 and those of the other meridians by 0. Then that of the longitude moves by longitude / meridian
(Neumann and Zagier, Volumes of hyperbolic three-manifolds, 1985, section 4). No cusp is unrolled. In 64-bit mantissas.
"""
import os
import sys

import numpy
import regina

REAL, COMPLEX = numpy.longdouble, numpy.clongdouble
CENSUS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "census", "cusped.txt")
STEP = 30


def solved(rows, right):
    """x with rows x = right; there may be more rows than columns, if they agree."""
    table = numpy.concatenate([rows, right.reshape(-1, 1)], axis=1)
    columns = rows.shape[1]
    for c in range(columns):
        pivot = c + int(numpy.argmax(abs(table[c:, c])))
        table[[c, pivot]] = table[[pivot, c]]
        assert abs(table[c, c]) > 1e-6
        table[c] = table[c] / table[c, c]
        for r in range(len(table)):
            if r != c:
                table[r] = table[r] - table[r, c] * table[c]
    assert len(table) == columns or abs(table[columns:, columns]).max() < 1e-9
    return table[:columns, columns]


def slopes(rows, z):
    """The derivatives of the equations' left sides by log z."""
    return rows[:, 0::3] + rows[:, 1::3] * (z / (1 - z)) + rows[:, 2::3] / (z - 1)


def refined(rows, goal, z):
    """Newton's method from the kernel's solution."""
    for _ in range(4):
        parts = numpy.stack([numpy.log(z), -numpy.log(1 - z), numpy.log((z - 1) / z)], axis=1).reshape(-1)
        step = solved(slopes(rows, z), goal - rows @ parts)
        z = z * numpy.exp(step)
    assert abs(step).max() < 1e-16
    return z


def shapes(triangulation):
    """longitude / meridian of each cusp, or nothing where the kernel's solution is not geometric."""
    kernel = regina.SnapPeaTriangulation(triangulation)
    if kernel.isNull() or kernel.solutionType() != regina.SnapPeaTriangulation.geometric_solution:
        return None
    matrix = kernel.gluingEquations()
    equations = numpy.array([[int(str(matrix.entry(r, c))) for c in range(matrix.columns())]
                             for r in range(matrix.rows())]).astype(COMPLEX)
    edges, tets = kernel.countEdges(), kernel.size()
    used = list(range(edges)) + list(range(edges, len(equations), 2))  # without longitudes
    pi = 4 * numpy.arctan(REAL(1))
    goal = numpy.array([2j * pi if k < edges else 0 for k in used], dtype=COMPLEX)
    z = numpy.array([kernel.shape(t) for t in range(tets)], dtype=COMPLEX)
    z = refined(equations[used], goal, z)
    slope = slopes(equations, z)
    found = []
    for row in range(edges, len(equations), 2):
        move = numpy.array([1 if k == row else 0 for k in used], dtype=COMPLEX)
        found.append(slope[row + 1] @ solved(slope[used], move))
    return found


def reduced(shape):
    """The same lattice's shape with |shape| >= 1 and |Re| <= 1/2, up to the half of the rim that is taken."""
    while True:
        shape = shape - numpy.round(shape.real)
        if abs(shape) > 1 - REAL(1e-12):
            return shape if shape.imag > 0 else -shape
        shape = 1 / shape


def text(x):
    return " ".join(numpy.format_float_positional(part, 18) for part in (x.real, x.imag))


def main():
    print("# Regina 7.3 (SnapPea kernel); record_cusp_shapes.py describes the format")
    with open(CENSUS, encoding="utf-8") as file:
        lines = [line.split() for line in file if not line.startswith("#")]
    for name, signature, *_ in lines[::STEP]:
        triangulation = regina.Triangulation3.fromIsoSig(signature)
        if not triangulation.isOrientable():
            triangulation.makeDoubleCover()
        found = shapes(triangulation)
        if found is None:
            print(name, "has no geometric solution", file=sys.stderr)
            continue
        print("|".join([name, signature, ",".join(text(reduced(x)) for x in found)]))


main()
