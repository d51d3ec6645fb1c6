#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records what Regina says of some thousand triangulations, for tests/core/oracle_test.cpp.

Run with Debian's python3 (package regina-normal); it rewrites regina_core.txt beside itself, which takes about two
minutes. The triangulations: every isomorphism class of gluings of one and of two tetrahedra (disconnected and
invalid ones too), random ones of 3 to 70 tetrahedra, large ones around the sizes where a signature's numbers grow by
a letter (63 and 4096), Regina's ready-made examples and its censuses. Each is written in a random labelling.

One triangulation a line, fields separated by '|':
  gluings        for each face in the order (tetrahedron, face) that no earlier token has glued: '-' on the boundary,
                 else tetrahedron and the map of vertices as a letter ('a' + rank of the images, lexicographic)
  signature      isoSig()
  flags          v (isValid), o (isOrientable), c (isConnected)
  counts         vertices, edges, triangles, reversed edges (not isValid)
  boundary       real, ideal and invalid-vertex boundary components
  links          per kind of vertex link: how many, Euler characteristic, boundary curves, 'o' or 'n'
  automorphisms  findAllIsomorphisms(self), of connected ones below 40 tetrahedra, else '-'
The first line of the file names the version of Regina.
"""
import itertools
import os
import random
from collections import Counter

import regina

PERMS = [regina.Perm4(*p) for p in itertools.permutations(range(4))]
RANK = {p.str(): k for k, p in enumerate(PERMS)}


def gluing_text(tri):
    tokens = []
    for t in range(tri.size()):
        tet = tri.tetrahedron(t)
        for f in range(4):
            other = tet.adjacentTetrahedron(f)
            if other is None:
                tokens.append("-")
            elif (other.index(), tet.adjacentFace(f)) > (t, f):
                tokens.append("%d%s" % (other.index(), chr(97 + RANK[tet.adjacentGluing(f).str()])))
    return "%d: %s" % (tri.size(), " ".join(tokens))


def relabelled(tri, rng):
    iso = regina.Isomorphism3(tri.size())
    image = list(range(tri.size()))
    rng.shuffle(image)
    for t in range(tri.size()):
        iso.setSimpImage(t, image[t])
        iso.setFacetPerm(t, rng.choice(PERMS))
    return iso(tri)


def line(tri):
    links = Counter()
    for v in tri.vertices():
        link = v.buildLink()
        links[(link.eulerChar(), link.countBoundaryComponents(), "o" if link.isOrientable() else "n")] += 1
    kinds = [0, 0, 0]
    for b in tri.boundaryComponents():
        kinds[0 if b.isReal() else 1 if b.isIdeal() else 2] += 1
    automorphisms = "-"
    if tri.isConnected() and tri.size() < 40:
        automorphisms = str(len(list(tri.findAllIsomorphisms(tri))))
    return "|".join([
        gluing_text(tri), tri.isoSig(),
        ("v" if tri.isValid() else "") + ("o" if tri.isOrientable() else "") + ("c" if tri.isConnected() else ""),
        "%d %d %d %d" % (tri.countVertices(), tri.countEdges(), tri.countTriangles(),
                         sum(e.hasBadIdentification() for e in tri.edges())),
        "%d %d %d" % tuple(kinds),
        " ".join("%d:%d,%d,%s" % ((n,) + k) for k, n in sorted(links.items())),
        automorphisms])


def maps(f, g):
    return [p for p in PERMS if p[f] == g]


MAPS = [[maps(f, g) for g in range(4)] for f in range(4)]


def all_gluings(n):
    """Every labelled gluing of n tetrahedra as a list of (t, f, u, perm)."""
    def decide(at, used, joins):
        if at == 4 * n:
            yield list(joins)
            return
        yield from decide(at + 1, used, joins)
        if at in used:
            return
        for other in range(at + 1, 4 * n):
            if other in used:
                continue
            for p in MAPS[at % 4][other % 4]:
                joins.append((at // 4, at % 4, other // 4, p))
                yield from decide(at + 1, used | {at, other}, joins)
                joins.pop()
    yield from decide(0, frozenset(), [])


def build(n, joins):
    tri = regina.Triangulation3()
    for _ in range(n):
        tri.newTetrahedron()
    for t, f, u, p in joins:
        tri.tetrahedron(t).join(f, tri.tetrahedron(u), p)
    return tri


def random_joins(n, rng, boundary, orientable):
    """A random matching of the faces; one labelled gluing in two keeps every tetrahedron positively handed."""
    faces = [(t, f) for t in range(n) for f in range(4)]
    rng.shuffle(faces)
    joins = []
    while len(faces) >= boundary + 2:
        (t, f), (u, g) = faces.pop(), faces.pop()
        joins.append((t, f, u, rng.choice([p for p in MAPS[f][g] if not orientable or p.sign() < 0])))
    return joins


def randoms(rng):
    sizes = [3] * 500 + [n for n in range(4, 21) for _ in range(40)] + [n for n in range(21, 71) for _ in range(4)]
    sizes += [n for n in (61, 62, 63, 64, 65) for _ in range(15)] + [126, 127, 128, 200, 300]
    for n in sizes:
        boundary = rng.choice([0, 0, 1, 2, 4, n]) if rng.random() < 0.7 else rng.randrange(0, 4 * n + 1)
        yield build(n, random_joins(n, rng, boundary, rng.random() < 0.5))
    for n in (1000, 4095, 4096, 4097):
        yield build(n, random_joins(n, rng, 2, True))


def torus(size):
    """The 3-torus of size^3 cubes in 6 tetrahedra each."""
    orders = list(itertools.permutations(range(3)))
    tri = regina.Triangulation3()
    tets = {}
    for at in itertools.product(range(size), repeat=3):
        for order in orders:
            tets[at, order] = tri.newTetrahedron()
    for (at, (a, b, c)), tet in tets.items():
        if tet.adjacentTetrahedron(1) is None:
            tet.join(1, tets[at, (b, a, c)], regina.Perm4())
        if tet.adjacentTetrahedron(2) is None:
            tet.join(2, tets[at, (a, c, b)], regina.Perm4())
        ahead = tuple((x + (k == a)) % size for k, x in enumerate(at))
        tet.join(0, tets[ahead, (b, c, a)], regina.Perm4(3, 0, 1, 2))
    return tri


def examples():
    ex = regina.Example3
    for name in ("ball", "threeSphere", "bingsHouse", "simplicialSphere", "rp3rp3", "s2xs1", "rp2xs1", "poincare",
                 "weeks", "weberSeifert", "smallClosedOrblHyperbolic", "smallClosedNonOrblHyperbolic", "figureEight",
                 "gieseking", "whiteheadLink", "trefoil", "solidKleinBottle", "twistedSphereBundle",
                 "cuspedGenusTwoTorus", "ballBundle", "sphere600"):
        yield getattr(ex, name)()
    for n in range(1, 40, 3):
        yield ex.layeredLoop(n, False)
        yield ex.layeredLoop(n, True)
    for p, q in ((3, 1), (8, 3), (13, 5), (21, 8), (34, 13), (50, 1), (101, 7)):
        yield ex.lens(p, q)
    for g in range(1, 8):
        yield ex.handlebody(g)
    for size in (1, 2, 3):
        yield torus(size)
    for name in ("closed-or-census", "closed-nor-census", "cusped-hyp-or-census", "cusped-hyp-nor-census"):
        root = regina.open("/usr/share/regina-normal/examples/%s.rga" % name)  # the tree lives as long as its root
        packet = root
        left = 150
        while packet is not None and left > 0:
            if isinstance(packet, regina.PacketOfTriangulation3):
                yield regina.Triangulation3(packet)
                left -= 1
            packet = packet.nextTreePacket()


def main():
    rng = random.Random(20110707)
    lines = ["# Regina " + regina.versionString()]
    for n in (1, 2):
        classes = {}
        for joins in all_gluings(n):
            tri = build(n, joins)
            classes.setdefault(tri.isoSig(), tri)
        print(n, "tetrahedra:", len(classes), "classes", flush=True)
        lines += [line(relabelled(tri, rng)) for _, tri in sorted(classes.items())]
    lines += [line(relabelled(tri, rng)) for tri in examples()]
    print(len(lines), "with the examples", flush=True)
    lines += [line(tri) for tri in randoms(rng)]
    print(len(lines), "in all", flush=True)
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "regina_core.txt")
    with open(path, "w", encoding="ascii") as out:
        out.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
