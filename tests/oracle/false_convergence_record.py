#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records false_convergence_3.txt and false_convergence_4.txt: the gluings on which hyperbolic structures are
looked for, listed by Regina (7.3; run with the system's own Python, whose module it is).

Both files hold, sorted, the closed orientable gluings of 3 and 4 tetrahedra (`tricensus -t N -i -o -d -s`)
of which Regina says that no vertex link is a sphere, some vertex link has genus at least two, and no edge has
degree below three. Nothing about their geometry is recorded: finding that is the test.

Usage: tests/oracle/false_convergence_record.py   (writes beside itself)
"""
import pathlib
import subprocess
import tempfile

import regina


def wanted(signature):
    tri = regina.Triangulation3.fromIsoSig(signature)
    euler = [v.linkEulerChar() for v in tri.vertices()]
    return max(euler) <= 0 and min(euler) < 0 and min(e.degree() for e in tri.edges()) >= 3


here = pathlib.Path(__file__).parent
for tetrahedra in (3, 4):
    with tempfile.NamedTemporaryFile() as listed:
        subprocess.run(["tricensus", "-t", str(tetrahedra), "-i", "-o", "-d", "-s", listed.name], check=True,
                       stdout=subprocess.DEVNULL)
        signatures = pathlib.Path(listed.name).read_text().split()
    chosen = sorted(s for s in signatures if wanted(s))
    path = here / f"false_convergence_{tetrahedra}.txt"
    path.write_text("".join(s + "\n" for s in chosen))
    print(path.name, len(chosen), "of", len(signatures))
