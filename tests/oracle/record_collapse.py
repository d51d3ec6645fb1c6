#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records which local moves Regina allows on some thousand small triangulations: regina_moves.txt.

Run with Debian's python3 (package regina-normal); it rewrites the file beside itself, in half a minute. The
triangulations: every connected gluing of one and of two tetrahedra up to isomorphism, boundary allowed (invalid ones
too), and random ones of 3 to 8 tetrahedra of seven kinds, equally many of each. These come from ready-made examples by
random moves, and by taking single tetrahedra out, which opens closed triangulations.

One triangulation a line, four fields after the signature, separated by '|'. A move is asked for at every local simplex
of the triangulation that the signature names, so that nothing depends on how classes are numbered:
  signature   isoSig()
  edges       a digit for each t-edge, in the order (tetrahedron, 01 02 03 12 13 23), the sum of
                1  collapseEdge
                2  the move that fits the edge: closeBook on the boundary; by degree, 2-1 at the end with the smaller
                   local number (1), 2-0 (2), 3-2 (3), 4-4 (4). Where the degree does not fit, Regina refuses the move;
                   the script checks that.
                4  2-1 at the other end
  vertices    a digit for each t-vertex: 1 for 4-1, 2 for 2-0 at a vertex
  faces       a digit for each t-face: 1 for 2-3, 2 for openBook
  tetrahedra  a digit for each tetrahedron: 1 for shellBoundary
(1-4 is always allowed, 0-2 at every valid edge.) The first line names the version of Regina.
"""
import itertools
import os
import random

import regina

from record_core import PERMS, all_gluings, build

PAIRS = list(itertools.combinations(range(4), 2))
KIND_QUOTA = 420


def edge_digit(tri, edge):
    """(digit without 2-1, whether 2-1 is allowed at ends 0 and 1 of the class)"""
    can = {"book": tri.closeBook(edge, True, False), 2: tri.twoZeroMove(edge, True, False),
           3: tri.pachner(edge, True, False), 4: tri.fourFourMove(edge, 0, True, False)}
    assert can[4] == tri.fourFourMove(edge, 1, True, False)
    fits = "book" if edge.isBoundary() else edge.degree()
    assert not any(allowed for kind, allowed in can.items() if kind != fits)
    ends = [tri.twoOneMove(edge, end, True, False) for end in (0, 1)]
    assert fits == 1 or not any(ends)
    return tri.collapseEdge(edge, True, False) + 2 * can.get(fits, False), ends


def line(signature):
    tri = regina.Triangulation3.fromIsoSig(signature)
    edge = [edge_digit(tri, e) for e in tri.edges()]
    vertex = [tri.pachner(v, True, False) + 2 * tri.twoZeroMove(v, True, False) for v in tri.vertices()]
    face = [tri.pachner(f, True, False) + 2 * tri.openBook(f, True, False) for f in tri.triangles()]
    fields = ["", "", "", ""]
    for tet in tri.tetrahedra():
        for k, pair in enumerate(PAIRS):
            assert tuple(sorted(tet.edgeMapping(k)[i] for i in (0, 1))) == pair
            digit, ends = edge[tet.edge(k).index()]
            along = tet.edgeMapping(k)[0] < tet.edgeMapping(k)[1]
            smaller, larger = ends if along else reversed(ends)
            fields[0] += str(digit + 2 * smaller + 4 * larger)
        fields[1] += "".join(str(vertex[tet.vertex(k).index()]) for k in range(4))
        fields[2] += "".join(str(face[tet.triangle(k).index()]) for k in range(4))
        fields[3] += str(int(tri.shellBoundary(tet, True, False)))
    return "|".join([signature] + fields)


def kind(tri):
    if not tri.isValid():
        return "invalid"
    real = any(b.isReal() for b in tri.boundaryComponents())
    side = "mixed" if real and tri.isIdeal() else "bounded" if real else "ideal" if tri.isIdeal() else "closed"
    return side if side in ("mixed", "ideal") else side + (" orientable" if tri.isOrientable() else " non-orientable")


def seeds():
    example = regina.Example3
    made = [example.ball(), example.threeSphere(), example.simplicialSphere(), example.bingsHouse(), example.lens(5, 2),
            example.lens(7, 2), example.rp3rp3(), example.s2xs1(), example.twistedSphereBundle(), example.rp2xs1(),
            example.poincare(), example.layeredLoop(2, True), example.gieseking(), example.figureEight(),
            example.trefoil(), example.whiteheadLink(), example.ballBundle(), example.twistedBallBundle(),
            example.lst(3, 4), example.solidKleinBottle(), example.handlebody(2)]
    # The knotted Y, the figure eight's sister, and the 3-torus.
    return [t.isoSig() for t in made] + ["cPcbbbihq", "cPcbbbdxm", "gvLQQedfedffrwawrhh"]


def random_move(tri, rng):
    """Changes tri by one random move; nothing happens where it is not allowed."""
    move = rng.randrange(10)
    edge = tri.edge(rng.randrange(tri.countEdges()))
    face = tri.triangle(rng.randrange(tri.countTriangles()))
    if move < 2:
        tri.pachner(face)
    elif move == 2:
        tri.pachner(edge) or tri.fourFourMove(edge, rng.randrange(2))
    elif move == 3:
        tri.pachner(tri.tetrahedron(rng.randrange(tri.size())))
    elif move == 4:
        tri.openBook(face) or tri.closeBook(edge)
        sides = [(t, t.edge(i)) for t in tri.triangles() if t.isBoundary() for i in range(3)]
        ready = [e for e in tri.edges() if len({t.index() for t, side in sides if side == e}) == 2]
        if ready and rng.randrange(2) == 0:
            tri.layerOn(rng.choice(ready))
    elif move == 5:
        tri.shellBoundary(tri.tetrahedron(rng.randrange(tri.size()))) or tri.twoZeroMove(edge)
    elif move == 6:
        tri.removeTetrahedronAt(rng.randrange(tri.size()))
    elif move == 7:
        tri.collapseEdge(edge)
    elif edge.isValid():
        first, second = (edge.embedding(rng.randrange(edge.degree())) for _ in range(2))
        tri.zeroTwoMove(first, rng.randrange(2, 4), second, rng.randrange(2, 4))


def random_joins(n, rng):
    faces = [(t, f) for t in range(n) for f in range(4)]
    rng.shuffle(faces)
    joins = []
    for _ in range(rng.randint(n, 2 * n)):
        (t, f), (u, g) = faces.pop(), faces.pop()
        joins.append((t, f, u, rng.choice([p for p in PERMS if p[f] == g])))
    return joins


def random_signatures(small, rng):
    """KIND_QUOTA different ones of each kind. Moves hardly ever mix real with ideal boundary: that must be sown."""
    mixed = [s for s in sorted(small) if kind(regina.Triangulation3.fromIsoSig(s)) == "mixed"]
    start = seeds() + 5 * mixed
    kinds = ["closed orientable", "closed non-orientable", "ideal", "bounded orientable", "bounded non-orientable",
             "mixed", "invalid"]
    found = {k: set() for k in kinds}
    while any(len(signatures) < KIND_QUOTA for signatures in found.values()):
        tri = build(4, random_joins(4, rng)) if rng.randrange(8) == 0 else \
            regina.Triangulation3.fromIsoSig(rng.choice(start))
        for _ in range(rng.randint(1, 12)):
            backup = regina.Triangulation3(tri)
            random_move(tri, rng)
            if tri.isEmpty() or not tri.isConnected() or tri.size() > 8:
                tri = backup
        signatures = found[kind(tri)]
        if tri.isConnected() and tri.size() >= 3 and len(signatures) < KIND_QUOTA:
            signatures.add(tri.isoSig())
    return set().union(*found.values())


def main():
    small = {tri.isoSig() for n in (1, 2) for tri in (build(n, joins) for joins in all_gluings(n)) if tri.isConnected()}
    chosen = sorted(small | random_signatures(small, random.Random(20)), key=lambda s: (len(s), s))
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "regina_moves.txt")
    with open(path, "w") as out:
        out.write("# Regina %s; record_collapse.py describes the format\n" % regina.versionString())
        for signature in chosen:
            out.write(line(signature) + "\n")
    print(len(small), "small,", len(chosen), "in all,", os.path.getsize(path), "bytes")


main()
