#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records the SnapPea kernel's canonical decompositions of cusped manifolds, as Regina hands them out.

Usage: build/release/bin/tetrarch census gluings --tetrahedra N --orientable --links 1 --min-valence 3 (N = 2, 3, 4) |
       /usr/bin/python3 tests/oracle/record_canonical.py > tests/oracle/snappea_canonical.txt
(Debian's regina-normal; its module imports only in the system's own Python.)
"""
import sys

import regina

print("# Regina", regina.versionString(), "(SnapPea kernel): gluings with torus cusps that carry a structure")
print("# signature | volume | signature of the canonical triangulation, or 'flat' where cells are no tetrahedra")
for line in sys.stdin:
    tri = regina.Triangulation3.fromIsoSig(line.strip())
    solved = regina.SnapPeaTriangulation(tri)
    if solved.solutionType() != regina.SolutionType.geometric_solution:
        continue
    canonical = solved.canonize()
    if canonical is None:
        continue
    finite = any(v.linkEulerChar() == 2 for v in canonical.vertices())
    print(line.strip(), f"{solved.volume():.9f}", "flat" if finite else canonical.isoSig(), sep="|")
