#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records the homology that Regina finds, for tests/algebra/oracle_test.cpp.

Run with Debian's python3 (package regina-normal); it rewrites regina_homology.txt beside itself in about a minute.
The triangulations: what `tricensus` lists of one tetrahedron, of two (closed or ideal, and with boundary) and of three
(with boundary; closed; and every fifth of all with internal faces only), Regina's ready-made examples, lens spaces with
a large group, some made larger by random moves, and a few with two components.

One triangulation a line, fields separated by '|':
  signature  isoSig()
  H1         homology(1), written as Tetrarch writes groups: "0", "Z^2 + Z/3"
  H1rel      homologyRel(): modulo the boundary, ideal vertices counted in
  H2         homology(2)
  covers     connected covers of 2, 3 and 4 sheets up to equivalence (fundamentalGroup().enumerateCovers), separated by
             blanks; '-' for two components, more than twelve tetrahedra, or more than three generators in Regina's
             presentation
Regina truncates ideal vertices, as Tetrarch does. The first line of the file names the version of Regina.
"""
import os
import subprocess
import tempfile

import regina


def census(*options):
    with tempfile.NamedTemporaryFile("r") as out:
        subprocess.run(["tricensus", *options, "-s", out.name], check=True, stdout=subprocess.DEVNULL,
                       stderr=subprocess.DEVNULL)
        return sorted(line.strip() for line in out if line.strip())


def group_text(group):
    parts = [] if group.rank() == 0 else ["Z" if group.rank() == 1 else f"Z^{group.rank()}"]
    parts += [f"Z/{group.invariantFactor(i)}" for i in range(group.countInvariantFactors())]
    return " + ".join(parts) or "0"


def grown(signature, moves):
    """More tetrahedra by 1-4 moves, then 2-3 moves on faces spread over the triangulation."""
    tri = regina.Triangulation3.fromIsoSig(signature)
    for k in range(moves):
        tri.pachner(tri.tetrahedron((7 * k) % tri.size()))
    for k in range(4 * moves):
        tri.pachner(tri.triangle((31 * k) % tri.countTriangles()))
    return tri.isoSig()


def examples():
    e = regina.Example3
    tris = [e.ball(), e.ballBundle(), e.bingsHouse(), e.cuspedGenusTwoTorus(), e.figureEight(), e.gieseking(),
            e.handlebody(2), e.handlebody(3), e.handlebody(5), e.poincare(), e.rp2xs1(), e.rp3rp3(), e.s2xs1(),
            e.simplicialSphere(), e.smallClosedNonOrblHyperbolic(), e.smallClosedOrblHyperbolic(), e.solidKleinBottle(),
            e.threeSphere(), e.trefoil(), e.twistedBallBundle(), e.twistedSphereBundle(), e.weberSeifert(), e.weeks(),
            e.whiteheadLink(), e.lst(3, 4), e.augTriSolidTorus(2, 1, 3, 1, 5, 2), e.layeredLoop(5, False),
            e.layeredLoop(6, True), e.sfsOverSphere(2, 1, 3, 1, 7, 1), e.sfsOverSphere(3, 1, 3, 1, 3, -2)]
    tris += [e.lens(p, q) for p, q in [(0, 1), (1, 0), (2, 1), (3, 1), (5, 1), (5, 2), (12, 5), (1000, 3),
                                       (1134903170, 701408733), (2147483647, 1234567891)]]
    return [tri.isoSig() for tri in tris]


def disjoint(a, b):
    tri = regina.Triangulation3.fromIsoSig(a)
    tri.insertTriangulation(regina.Triangulation3.fromIsoSig(b))
    return tri.isoSig()


def line(signature):
    tri = regina.Triangulation3.fromIsoSig(signature)
    covers = "-"
    if tri.isConnected() and tri.size() <= 12 and tri.fundamentalGroup().countGenerators() <= 3:
        group = tri.fundamentalGroup()
        covers = " ".join(str(len(group.enumerateCovers(k))) for k in (2, 3, 4))
    groups = [group_text(g) for g in (tri.homology(1), tri.homologyRel(), tri.homology(2))]
    return "|".join([signature, *groups, covers])


def main():
    signatures = census("-t", "1") + census("-t", "2", "-i") + census("-t", "2", "-b") + census("-t", "3", "-b")
    signatures += census("-t", "3", "-i", "-f") + census("-t", "3", "-i")[::5] + examples()
    signatures += [grown(s, k) for s, k in [("cMcabbjak", 5), ("cPcbbbiht", 10), ("bkaaid", 8), ("cPcbbbihq", 8),
                                            ("dLQbcccajqs", 10), ("gvLQQedfedffrwawrhh", 6), ("eLMkabcddbrrag", 12)]]
    signatures += [disjoint("cMcabbjak", "cPcbbbiht"), disjoint("bkaaid", "baa"), disjoint("cPcbbbajs", "dLQbcccajqs")]
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "regina_homology.txt")
    with open(path, "w", encoding="ascii") as out:
        out.write(f"# Regina {regina.versionString()}\n")
        for signature in dict.fromkeys(signatures):
            out.write(line(signature) + "\n")


if __name__ == "__main__":
    main()
