#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records what Regina says of the census gluings: signature, H1, vertex link Euler characteristics, automorphisms.

Usage: /usr/bin/python3 tests/oracle/record_census.py > tests/oracle/regina_census.txt
(Debian's regina-normal; its module imports only in the system's own Python.)
"""
import json
import os

import regina

here = os.path.dirname(os.path.abspath(__file__))
print("# Regina", regina.versionString(), "on the gluings of census/fmp2, fmp3, tetn2 and tetn3.json:")
print("# signature | H1 | Euler characteristics of the vertex links | automorphisms of the canonical triangulation")
for name in ("fmp2", "fmp3", "tetn2", "tetn3"):
    with open(f"{here}/../../census/{name}.json") as table:
        manifolds = json.load(table)["manifolds"]
    for m in manifolds:
        tri = regina.Triangulation3.fromIsoSig(m["signature"])
        canonical = regina.Triangulation3.fromIsoSig(m["canonical_signature"])
        links = sorted(v.linkEulerChar() for v in tri.vertices())
        symmetries = canonical.findAllIsomorphisms(canonical)
        assert tri.isOrientable() == name.startswith("fmp")
        print(tri.isoSig(), tri.homology().str().replace(" ", ""), ",".join(map(str, links)), len(symmetries), sep="|")
