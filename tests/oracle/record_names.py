#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records Regina's names of closed 3-manifolds and of handlebodies, for tests/identify/recognise_test.cpp.

Usage: /usr/bin/python3 tests/oracle/record_names.py > tests/oracle/regina_names.txt
(Debian's regina-normal; its module imports only in the system's own Python.)

One triangulation a line: signature|name, where the name is Regina's own. The triangulations: every closed one of up
to three tetrahedra, minimal or not (`tricensus -i -f`), and those of four and five that are not obviously non-minimal
or not prime (`-M`); layered lens spaces L(p,q) for p < 24, named as they were asked for; the same after a 1-4 move,
layered no longer; one with p near 2^61; handlebodies of genus 0 to 6, with real boundary and coned. Regina simplifies
a triangulation first; where it then has no name, there is no line.
"""
import math
import pathlib
import subprocess
import tempfile

import regina


def name(signature):
    tri = regina.Triangulation3.fromIsoSig(signature)
    tri.intelligentSimplify()
    known = regina.StandardTriangulation.recognise(tri)
    manifold = known.manifold() if known else None
    if manifold is None:
        hits = regina.Census.lookup(tri)
        return hits[0].name().split(" : ")[0] if len(hits) else None
    return manifold.name()


def closed(tetrahedra):
    options = ["-M"] if tetrahedra > 3 else []
    with tempfile.NamedTemporaryFile() as listed:
        subprocess.run(["tricensus", "-t", str(tetrahedra), "-i", "-f", "-s", *options, listed.name], check=True,
                       stdout=subprocess.DEVNULL)
        return sorted(pathlib.Path(listed.name).read_text().split())


print("# Regina", regina.versionString() + "; record_names.py describes the format")
for n in (1, 2, 3, 4, 5):
    for sig in closed(n):
        known = name(sig)
        if known:
            print(sig, known, sep="|")
for p in range(3, 24):
    for q in range(1, p):
        if math.gcd(p, q) > 1:
            continue
        lens = regina.Example3.lens(p, q)
        space = regina.LensSpace(p, q).name()
        print(lens.isoSig(), space, sep="|")
        lens.pachner(lens.tetrahedron(0))
        print(lens.isoSig(), space, sep="|")
fibonacci = [1, 1]
while len(fibonacci) < 90:
    fibonacci.append(fibonacci[-1] + fibonacci[-2])
print(regina.Example3.lens(*fibonacci[:-3:-1]).isoSig(), regina.LensSpace(*fibonacci[:-3:-1]).name(), sep="|")
for genus in range(7):
    body = regina.Example3.handlebody(genus)
    print(body.isoSig(), f"handlebody {genus}", sep="|")
    body.finiteToIdeal()  # a ball becomes a sphere
    print(body.isoSig(), f"handlebody {genus}" if genus else "S3", sep="|")
