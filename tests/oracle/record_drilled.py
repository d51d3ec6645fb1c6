#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records what Regina says of triangulations with pinched edges, for tests/moves/drill_test.cpp.

    record_drilled.py TETRARCH

Run with Debian's python3 (package regina-normal); it rewrites regina_drilled.txt beside itself in seconds.
Regina's pinchEdge() shrinks an edge to a point, which leaves an ideal vertex where a loop was: another way to the
exterior of a graph than cutting or crushing, one edge after the other. The triangulations: all closed ones of
one to three tetrahedra, each with every set of its edges, and of four with one set in forty. (Gluings as TETRARCH lists
them, whose lists are compared with Regina's in tests/enumeration.)

One set of edges a line, fields separated by '|':
  signature
  edges     as 'tetrahedron:ij' of the triangulation made from the signature
  exterior  first homology, and the vertex links that are no spheres, in alphabetical order
The first line of the file names the version of Regina.
"""
import itertools
import pathlib
import subprocess
import sys

import regina

EVERY = {1: 1, 2: 1, 3: 1, 4: 40}  # one set of so many


def homology(tri):
    group = tri.homology()
    factors = ["Z" if group.rank() == 1 else f"Z^{group.rank()}"] if group.rank() else []
    return " + ".join(factors + [f"Z/{group.invariantFactor(k)}" for k in range(group.countInvariantFactors())]) or "0"


def link(vertex):
    euler = vertex.linkEulerChar()
    if vertex.isLinkOrientable():
        return {2: "sphere", 0: "torus"}.get(euler, f"genus {(2 - euler) // 2}")
    return {1: "projective plane", 0: "Klein bottle"}.get(euler, f"{2 - euler} crosscaps")


def pinched(tri, edges):
    """Tetrahedra keep their numbers while those that pinch are added."""
    result = regina.Triangulation3(tri)
    for tet, i, j in edges:
        result.pinchEdge(result.simplex(tet).edge(i, j))
    return result


def edge_classes(tri):
    for edge in tri.edges():
        place = edge.front()
        yield (place.simplex().index(), *sorted((place.vertices()[0], place.vertices()[1])))


def lines(program):
    number = 0
    for size, every in EVERY.items():
        gluings = subprocess.run([program, "census", "gluings", "--tetrahedra", str(size), "--links", "0"],
                                 capture_output=True, text=True, check=True).stdout.split()
        for signature in gluings:
            tri = regina.Triangulation3.fromIsoSig(signature)
            classes = list(edge_classes(tri))
            for count in range(1, len(classes) + 1):
                for edges in itertools.combinations(classes, count):
                    number += 1
                    if number % every:
                        continue
                    exterior = pinched(tri, edges)
                    links = sorted(kind for kind in map(link, exterior.vertices()) if kind != "sphere")
                    names = ",".join("%d:%d%d" % edge for edge in edges)
                    yield f"{signature}|{names}|{', '.join([homology(exterior), *links])}\n"


if __name__ == "__main__":
    path = pathlib.Path(__file__).with_name("regina_drilled.txt")
    path.write_text("# Regina " + regina.versionString() + "\n" + "".join(lines(sys.argv[1])))
