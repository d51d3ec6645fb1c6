#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Records what Regina makes of the SnapPea files in tests/data/format/tri, in tests/data/format/tri/regina.txt.

    /usr/bin/python3 tests/format/record_regina.py          # the system's own Python has the module

Per file: its name, the isomorphism signature that Regina's reader finds, and what the SnapPea kernel inside
Regina says: its volume to 10 decimals and number of cusps, or "refuses" (an error), or "fails" (the kernel
crashes, hence a process of its own). The files ours_*.tri are what Tetrarch writes (a test compares them byte
by byte); kernel_*.tri were written by the kernel, regina_*.tri by Regina:

    t = regina.SnapPeaTriangulation(regina.Example3.whiteheadLink().snapPea())     # gieseking() likewise
    open("kernel_whitehead.tri", "w").write(t.snapPea())
    t.fill(1, 2, 0)
    open("kernel_filled.tri", "w").write(t.snapPea())
    open("regina_weeks.tri", "w").write(regina.Example3.weeks().snapPea())
"""
import pathlib
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent.parent / "data" / "format" / "tri"


def kernel_answer(path):
    run = subprocess.run([sys.executable, __file__, str(path)], capture_output=True, text=True)
    if run.returncode < 0:
        return "fails"
    return run.stdout.strip() if run.returncode == 0 else "refuses"


def main():
    import regina

    if len(sys.argv) > 1:
        kernel = regina.SnapPeaTriangulation(pathlib.Path(sys.argv[1]).read_text())
        print(f"{kernel.volume():.10f} {kernel.countCusps()}")
        return
    lines = [f"# Regina {regina.versionString()}; see tests/format/record_regina.py"]
    for path in sorted(HERE.glob("*.tri")):
        signature = regina.Triangulation3.fromSnapPea(path.read_text()).isoSig()
        lines.append(f"{path.name} {signature} {kernel_answer(path)}")
    (HERE / "regina.txt").write_text("\n".join(lines) + "\n")


main()
