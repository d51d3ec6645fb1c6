#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records volumes of closed hyperbolic manifolds: the census of Hodgson and Weeks, as Regina 7.3 holds it.

Usage: regina-python -q tests/oracle/record_closed_volumes.py > tests/oracle/closed_volumes.txt
(Debian's regina-normal.)

One manifold a line: signature|volume|name, the digits as in the census. Every 45th of the 3,000 orientable ones, and all 18
that are not orientable.
"""
import regina

print("# Regina 7.3 (census of Hodgson and Weeks); record_closed_volumes.py describes the format")
packet = tree = regina.open("/usr/share/regina-normal/examples/closed-hyp-census.rga")  # the tree lives as long as its name
count = 0
while packet is not None:
    if hasattr(packet, "isoSig"):
        if count % 45 == 0 or not packet.isOrientable():
            volume, name = packet.label().split(":")
            print(f"{packet.isoSig()}|{volume.strip()}|{name.strip().replace(' ', '')}")
        count += 1
    packet = packet.nextTreePacket()
