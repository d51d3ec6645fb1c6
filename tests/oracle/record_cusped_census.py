#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records the SnapPea kernel's canonical triangulations of the cusped census, as Regina hands them out.

Usage: /usr/bin/python3 tests/oracle/record_cusped_census.py > tests/oracle/snappea_census.txt
(Debian's regina-normal and tokyocabinet-bin, which lists the census files that regina-normal ships; Regina's module
imports only in the system's own Python.)

One manifold a line: name|signature|canonical signature, the last one `flat` where cells are no tetrahedra. The
manifolds: all of the censuses m, s, x and y (up to six tetrahedra if orientable, seven if not), and every eighth one
of v (seven tetrahedra). The signature is that of the first minimal triangulation that the census lists.
"""
import subprocess

import regina

FILES = "/usr/share/regina-normal/data/census/cusped-hyp-%s-census-9.tdb"


def census(kind):
    listed = subprocess.run(["tcbmgr", "list", "-pv", FILES % kind], check=True, stdout=subprocess.PIPE, text=True)
    for line in listed.stdout.splitlines():
        signature, name = line.split("\t")[:2]
        if name.endswith(" : #1"):
            yield name[:-len(" : #1")], signature


def wanted(name):
    return name[0] in "msxy" or (name[0] == "v" and int(name[1:]) % 8 == 0)


def canonical(signature):
    result = regina.SnapPeaTriangulation(regina.Triangulation3.fromIsoSig(signature)).canonize()
    finite = any(v.linkEulerChar() == 2 for v in result.vertices())
    return "flat" if finite else result.isoSig()


print("# Regina", regina.versionString(), "(SnapPea kernel); record_cusped_census.py describes the format")
for name, signature in sorted({*census("or"), *census("nor")}):
    if wanted(name):
        print(name, signature, canonical(signature), sep="|")
