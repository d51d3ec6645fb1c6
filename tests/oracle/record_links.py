#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records what Regina 7.3 (with SnapPea's kernel) says of random links: regina_links.txt.

Each line: the braid, its planar diagram code, the number of components, the hyperbolic volume of the complement (or "-",
if ten triangulations carried no geometric solution), and of knots the Jones polynomial of the diagram.
"""
import random

import regina


def planar_diagram(strands, word):
    """Of the closure. Strands run upwards; a positive letter takes the strand from the left over the other."""
    start = list(range(strands))
    ends, count, crossings = start[:], strands, []
    for letter in word:
        s = abs(letter) - 1
        southwest, southeast = ends[s:s + 2]
        northwest, northeast = count, count + 1
        count += 2
        crossings.append([southeast, northeast, northwest, southwest] if letter > 0 else
                         [southwest, southeast, northeast, northwest])
        ends[s:s + 2] = northwest, northeast
    closed = dict(zip(ends, start))
    crossings = [[closed.get(arc, arc) for arc in x] for x in crossings]
    number = {arc: n + 1 for n, arc in enumerate(sorted({arc for x in crossings for arc in x}))}
    return [[number[arc] for arc in x] for x in crossings]


def volume(link):
    triangulation = regina.SnapPeaTriangulation(link.complement())
    for _ in range(10):
        if triangulation.solutionType() == regina.SnapPeaTriangulation.geometric_solution:
            return f"{triangulation.volume():.12f}"
        triangulation.randomise()
    return "-"


def main():
    random.seed(26)
    print("# Regina", regina.versionString())
    for _ in range(400):
        strands = random.randint(3, 6)
        length = random.randint(2 * strands - 2, 20)
        word = []
        for _ in range(length):
            generator = random.randint(1, strands - 1)
            word.append(generator * (1 if generator % 2 else -1) * (-1 if random.random() < 0.15 else 1))
        if len({abs(letter) for letter in word}) < strands - 1:
            continue
        crossings = planar_diagram(strands, word)
        link = regina.Link.fromPD(crossings)
        code = "PD[" + ", ".join(f"X[{', '.join(map(str, x))}]" for x in crossings) + "]"
        jones = str(link.jones()) if link.countComponents() == 1 and length <= 16 else "-"
        print("|".join([" ".join(map(str, word)), code, str(link.countComponents()), volume(link), jones]), flush=True)


if __name__ == "__main__":
    main()
