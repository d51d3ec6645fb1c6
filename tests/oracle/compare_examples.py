#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Reads every data file that Regina ships and compares each triangulation with what Regina says of it.

Usage: /usr/bin/python3 tests/oracle/compare_examples.py PROGRAM [FILE.rga ...]
(Debian's regina-normal; its module imports only in the system's own Python. Without files: all examples.)

For each file `PROGRAM info FILE#* --json` is run once; its lines are compared, in order, with the packets that hold
triangulations of 3-manifolds (SnapPea's among them): label, tetrahedra, vertices, validity, orientability, homology.
The homology of an ideal triangulation is that of the truncated one in both. Then some packets are asked for by number
and by name. One line a file; the exit status is 1 if anything differs. About 36,000 triangulations.
"""
import glob
import json
import re
import subprocess
import sys

import regina

PROGRAM = sys.argv[1]


def homology(tri):
    """Regina's "2 Z + Z_3 + 2 Z_5" as "Z^2 + Z/3 + Z/5 + Z/5"."""
    text = tri.homology().str()
    parts = []
    for part in text.split(" + ") if text != "0" else []:
        count, group = re.fullmatch(r"(?:(\d+) )?(Z(?:_\d+)?)", part).groups()
        if group == "Z":
            parts.append("Z" if not count else "Z^" + count)
        else:
            parts += [group.replace("_", "/")] * int(count or 1)
    return " + ".join(parts) or "0"


def triangulations(root):
    packet = root  # the tree lives as long as its root is held
    while packet:
        if packet.typeName() in ("3-D triangulation", "SnapPea triangulation"):
            yield packet
        packet = packet.nextTreePacket()


def facts(packet):
    tri = regina.Triangulation3(packet)
    return (packet.label().strip(), tri.size(), tri.countVertices(), tri.isValid(), tri.isOrientable(),
            homology(tri) if tri.isValid() else None)


def compare(path):
    done = subprocess.run([PROGRAM, "info", path + "#*", "--json"], capture_output=True, text=True)
    lines = [json.loads(line) for line in done.stdout.splitlines()]
    expected = [facts(packet) for packet in triangulations(regina.open(path))]
    read = [(l.get("name", ""), l["tetrahedra"], l["vertices"], l["valid"], l["orientable"], l["homology"]) for l in lines]
    wrong = sum(a != b for a, b in zip(read, expected)) + abs(len(read) - len(expected))
    for a, b in zip(read, expected):
        if a != b:
            print("  differs: %s, Regina says %s" % (a, b))
            break
    for k in range(0, len(expected), max(1, len(expected) // 5)):
        for element in (str(k + 1), expected[k][0]):
            one = subprocess.run([PROGRAM, "info", path + "#" + element, "--json"], capture_output=True, text=True)
            several = sum(e[0] == element for e in expected) > 1
            if not several and (one.returncode or json.loads(one.stdout)["tetrahedra"] != expected[k][1]):
                wrong += 1
                print("  by element %s: %s" % (element, one.stderr.strip()))
    print("%s: %d of %d triangulations, %d differ, status %d; %s" % (
        path, len(read), len(expected), wrong, done.returncode, done.stderr.strip().splitlines()[:2]))
    return wrong


if __name__ == "__main__":
    examples = sys.argv[2:] or sorted(glob.glob("/usr/share/regina-normal/examples/*.rga"))
    sys.exit(1 if sum(map(compare, examples)) else 0)
