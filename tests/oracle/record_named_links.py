#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records what Regina 7.3 (with SnapPea's kernel) says of the links by name: regina_named_links.txt.

    record_named_links.py PROGRAM

The program writes the planar diagram code of each name. Each line: the name, the number of components, the hyperbolic volume of
the complement (or "-", if twelve triangulations carried no geometric solution).
"""
import json
import re
import subprocess
import sys

import regina

PER_CROSSINGS = [("L2a", 1), ("L4a", 1), ("L5a", 1), ("L6a", 5), ("L6n", 1), ("L7a", 7), ("L7n", 2), ("L8a", 21), ("L8n", 8),
                 ("L9a", 55), ("L9n", 28)]


def volume(link):
    triangulation = regina.SnapPeaTriangulation(link.complement())
    for _ in range(12):
        if triangulation.solutionType() == regina.SnapPeaTriangulation.geometric_solution:
            return f"{triangulation.volume():.12f}"
        triangulation.randomise()
    return "-"


def main():
    print("# Regina", regina.versionString())
    for prefix, count in PER_CROSSINGS:
        for number in range(1, count + 1):
            name = prefix + str(number)
            done = subprocess.run([sys.argv[1], "diagram", name, "--json"], capture_output=True, text=True, check=True)
            rows = [[int(x) for x in row.split(",")] for row in re.findall(r"X\[([^\]]*)\]", json.loads(done.stdout)["code"])]
            link = regina.Link.fromPD(rows)
            print("|".join([name, str(link.countComponents()), volume(link)]), flush=True)


if __name__ == "__main__":
    main()
