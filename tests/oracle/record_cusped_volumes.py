#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records volumes of cusped manifolds by SnapPea's kernel, as Regina 7.3 holds it.

Usage: /usr/bin/python3 tests/oracle/record_cusped_volumes.py > tests/oracle/snappea_volumes.txt
(Debian's regina-normal; Regina's module imports only in the system's own Python.)

One manifold a line: signature|volume. The manifolds: every 45th of Regina's cusped hyperbolic censuses, orientable and
not, on whose triangulation the kernel finds a geometric solution.
"""
import regina

FOLDER = "/usr/share/regina-normal/examples/"

print("# Regina 7.3 (SnapPea kernel); record_cusped_volumes.py describes the format")
count = 0
for name in ("cusped-hyp-or-census.rga", "cusped-hyp-nor-census.rga"):
    packet = tree = regina.open(FOLDER + name)  # the tree lives as long as its name
    while packet is not None:
        if hasattr(packet, "isoSig"):
            triangulation = regina.Triangulation3(packet)
            kernel = regina.SnapPeaTriangulation(triangulation)
            if not kernel.isNull() and kernel.solutionType() == regina.SnapPeaTriangulation.geometric_solution:
                if count % 45 == 0:
                    print(f"{triangulation.isoSig()}|{kernel.volume()!r}")
                count += 1
        packet = packet.nextTreePacket()
