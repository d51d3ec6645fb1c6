#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Lets Regina change the triangulations of census manifolds by 5 to 60 random moves each, and records what comes out.

Usage: /usr/bin/python3 tests/oracle/record_retriangulated.py CENSUS.sqlite [COUNT [SEED]] > tests/oracle/regina_retriangulated.txt
(Debian's regina-normal; its module imports only in the system's own Python. CENSUS.sqlite: share/tetrarch of a build folder.)
Every other manifold is of the longest table, the rest are of the others alike.
"""
import random
import sqlite3
import sys

import regina


def moves(tri, rng):
    """The moves of one random kind, in random order."""
    kind = rng.choice(("2-3", "2-3", "2-3", "3-2", "3-2", "4-4", "2-0", "1-4", "4-1"))
    if kind == "2-3":
        places = [(lambda face=face: tri.pachner(face)) for face in tri.triangles()]
    elif kind == "3-2":
        places = [(lambda edge=edge: tri.pachner(edge)) for edge in tri.edges() if edge.degree() == 3]
    elif kind == "4-4":
        places = [(lambda edge=edge, axis=axis: tri.fourFourMove(edge, axis))
                  for edge in tri.edges() if edge.degree() == 4 for axis in (0, 1)]
    elif kind == "2-0":
        places = [(lambda edge=edge: tri.twoZeroMove(edge)) for edge in tri.edges() if edge.degree() == 2]
    elif kind == "1-4":
        places = [(lambda tet=tet: tri.pachner(tet)) for tet in tri.tetrahedra()]
    else:
        places = [(lambda vertex=vertex: tri.pachner(vertex)) for vertex in tri.vertices() if vertex.degree() == 4]
    rng.shuffle(places)
    return places


def changed(signature, count, rng):
    tri = regina.Triangulation3.fromIsoSig(signature)
    done = 0
    while done < count:
        # A move that is made, or one that is not possible: then the next place.
        done += any(move() for move in moves(tri, rng))
    return tri


def main():
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 1000
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    db = sqlite3.connect(f"file:{sys.argv[1]}?mode=ro", uri=True)
    tables = {}
    for name, n, signature in db.execute("select name, tetrahedra, signature from manifold order by id"):
        tables.setdefault(n, []).append((name, signature))
    longest = max(tables)
    print("# Regina", regina.versionString(), "changed triangulations of census manifolds by random moves (2-3, 3-2, 4-4, 2-0, 1-4, 4-1).")
    print("# name | moves | tetrahedra | signature")
    for k in range(count):
        name, signature = rng.choice(tables[longest if k % 2 else rng.choice(sorted(tables))])
        made = rng.randint(5, 60)
        tri = changed(signature, made, rng)
        print(name, made, tri.size(), tri.isoSig(), sep="|")


main()
