#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes, by Regina, the files in tests/data/format/rga, and what Regina says of each in regina.txt there.

    /usr/bin/python3 tests/format/record_rga.py          # the system's own Python has the module

Per file of one triangulation: its name, the label, the isomorphism signature. The same packets are written in
both XML generations, plain and (NAME.gz.rga) compressed; several.rga holds two triangulations and a text.
"""
import pathlib

import regina

HERE = pathlib.Path(__file__).resolve().parent.parent / "data" / "format" / "rga"


def open_pair():
    tri = regina.Triangulation3()
    first, second = tri.newTetrahedron(), tri.newTetrahedron()
    first.join(0, second, regina.Perm4(0, 2, 1, 3))
    first.join(2, first, regina.Perm4(0, 1, 3, 2))
    return tri


def packet(tri, label):
    made = regina.make_packet(tri)
    made.setLabel(label)
    return made


def main():
    samples = {
        "figure_eight": (regina.Example3.figureEight(), "figure eight"),
        "open": (open_pair(), "open & <odd> \"label\""),
        "kernel": (regina.SnapPeaTriangulation(regina.Example3.whiteheadLink().snapPea()), "Whitehead"),
    }
    generations = {2: regina.FileFormat.REGINA_XML_GEN_2, 3: regina.FileFormat.REGINA_XML_GEN_3}
    lines = [f"# Regina {regina.versionString()}; see tests/format/record_rga.py"]
    for name, (tri, label) in samples.items():
        for number, generation in generations.items():
            root = regina.Container()
            root.append(packet(tri, label))
            file = f"{name}_{number}.rga"
            root.save(str(HERE / file), False, generation)
            lines.append(f"{file}\t{label}\t{tri.isoSig()}")
    root = regina.Container()
    root.append(packet(samples["figure_eight"][0], "figure eight"))
    root.save(str(HERE / "figure_eight_3.gz.rga"), True, generations[3])
    lines.append(f"figure_eight_3.gz.rga\tfigure eight\t{samples['figure_eight'][0].isoSig()}")
    (HERE / "regina.txt").write_text("\n".join(lines) + "\n")
    root.append(regina.Text("no triangulation"))
    root.append(packet(samples["open"][0], "open"))
    root.save(str(HERE / "several.rga"), False)


main()
