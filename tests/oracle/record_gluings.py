#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records gluings_lists.txt and gluings_counts.txt beside itself: the closed gluings that Regina's tricensus
lists, for tests/enumeration/gluings_test.cpp. Needs Debian's regina-normal; takes about two minutes.

gluings_lists.txt: for 1, 2 and 3 tetrahedra and each set of options a line `TETRAHEDRA OPTIONS COUNT`, followed by
the signatures in ASCII order, one a line. OPTIONS is `-`, or letters of tricensus: o orientable, n non-orientable,
f all vertices finite, d at least one ideal vertex.
gluings_counts.txt: a line `TETRAHEDRA OPTIONS COUNT HASH` for lists too long to keep; the hash is 64-bit FNV-1a
over the sorted signatures, each with a newline after it.
"""
import pathlib
import subprocess
import tempfile

COMBINATIONS = ["-", "o", "n", "f", "d", "od", "nd", "of"]


def listed(tetrahedra, options):
    switches = ["-" + letter for letter in options if letter != "-"]
    with tempfile.NamedTemporaryFile() as file:
        subprocess.run(["tricensus", "-t", str(tetrahedra), "-i", *switches, "-s", file.name], check=True,
                       stdout=subprocess.DEVNULL)
        return sorted(pathlib.Path(file.name).read_text().split())


def fnv1a(text):
    value = 0xCBF29CE484222325
    for byte in text.encode():
        value = (value ^ byte) * 0x100000001B3 % 2**64
    return value


here = pathlib.Path(__file__).parent
with open(here / "gluings_lists.txt", "w") as out:
    for tetrahedra in (1, 2, 3):
        for options in COMBINATIONS:
            signatures = listed(tetrahedra, options)
            out.write(f"{tetrahedra} {options} {len(signatures)}\n")
            out.writelines(s + "\n" for s in signatures)
with open(here / "gluings_counts.txt", "w") as out:
    for tetrahedra, options in [(4, c) for c in COMBINATIONS] + [(5, "od"), (5, "of")]:
        signatures = listed(tetrahedra, options)
        digest = fnv1a("".join(s + "\n" for s in signatures))
        out.write(f"{tetrahedra} {options} {len(signatures)} {digest:016x}\n")
