#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The same command gives the same bytes: printed, complained and written, whatever the machine is set to.

Usage: same_bytes_test.py PROGRAM SOURCE_DIR [all [OTHER_PROGRAM]]

Each job runs as it is and once more under other settings of threads, locale, time zone, memory and addresses. Here some of the
jobs under one setting, each job with another one; with "all", every job under every setting, and by another build of the program.
"""
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCE = os.path.abspath(sys.argv[2])
ALL = sys.argv[3:4] == ["all"]
OTHER = os.path.abspath(sys.argv[4]) if len(sys.argv) > 4 else None
MESH = os.path.join(SOURCE, "tests/data/mesh")
RING = os.path.join(MESH, "ring_two_holes.off")
TORUS = os.path.join(MESH, "torus.off")
DOUBLE = os.path.join(MESH, "double_torus.off")
KNOTTED_Y = os.path.join(SOURCE, "tests/data/knotted_y_8k.mesh")
COARSE = os.path.join(SOURCE, "tests/data/knotted_y.json")
RIDGES = os.path.join(SOURCE, "tests/data/genus4_ridges.mesh")
# How a run differs from the first one: a prefix of the command, and variables.
SETTINGS = {
    "one thread": (("taskset", "-c", "0"), {"OPENBLAS_NUM_THREADS": "1", "OMP_NUM_THREADS": "1"}),
    "many threads": ((), {"OPENBLAS_NUM_THREADS": "7", "OMP_NUM_THREADS": "7"}),
    "another place": ((), {"LC_ALL": "de_DE.UTF-8", "LANG": "tr_TR.UTF-8", "TZ": "Asia/Kolkata"}),
    "fresh memory is no zero": ((), {"MALLOC_PERTURB_": "165"}),
    "fixed addresses": (("setarch", "-R"), {}),
    "memory from one arena": ((), {"MALLOC_ARENA_MAX": "1", "MALLOC_MMAP_THRESHOLD_": "4096"}),
}
JOBS = (
    ("info", "cPcbbbihq"),
    ("info", COARSE, "--json"),
    ("skeleton", "fmp3_17"),
    ("group", COARSE),
    ("convert", KNOTTED_Y, "-o", "OUT.json"),
    ("convert", RING, "-o", "OUT.vtu"),
    ("check", KNOTTED_Y, "--json"),
    ("simplify", KNOTTED_Y, "--seed", "3", "-o", "OUT.json"),
    ("truncate", KNOTTED_Y, "-o", "OUT.json"),
    ("move", "cPcbbbiht", "--list"),
    ("subdivide", "cPcbbbihq", "--finite", "--barycentric", "1", "-o", "OUT.json"),
    ("drill", "cMcabbgqs", "0"),
    ("diagram", "L6a4", "-o", "OUT.svg"),
    ("exterior", "hk5_3", "-o", "OUT.json"),
    ("exterior", "8_18", "--json"),
    ("hyperbolize", "cPcbbbihq", "--certify", "-o", "OUT.cert.json"),
    ("hyperbolize", "v1234", "--digits", "40"),
    ("hyperbolize", COARSE, "--json"),
    ("hyperbolize", "cMcabbgqs", "--cone", "0:5"),
    ("canonize", "s776", "-o", "OUT.json"),
    ("canonize", "fmp4_17"),
    ("isometric", "m125", "m129"),
    ("isometric", "hk5_3", "fmp2_8"),
    ("embed", "cPcbbbihq", "--copies", "60", "--model", "ball", "-o", "OUT.glb"),
    ("view", "m004", "-o", "OUT.html"),
    ("bundle", TORUS, "--fiber", "6", "-o", "OUT.json"),
    ("bundle", DOUBLE, "--euler", "3", "-o", "OUT.vtu"),
    ("slit", RING, "-o", "OUT.obj", "-o", "OUT.svg"),
    ("slit", RING, "--domain", "circular", "--json"),
    ("slit", RING, "--domain", "free", "--intrinsic", "-o", "OUT.ply"),
    ("register", RING, RING, "-o", "OUT.obj"),
    ("product", RIDGES, "--labels", "1,2", "--hex", "8", "-o", "OUT.vtu"),
    ("hex", DOUBLE, "--cells", "600", "-o", "OUT.mesh"),
    ("census", "gluings", "--tetrahedra", "2", "--orientable", "--ideal"),
    ("census", "enumerate", "--tetrahedra", "3", "--threads", "2", "-o", "OUT.json"),
    ("census", "validate", "--tetrahedra", "2"),
    ("census", "list", "--tetrahedra", "3", "--json"),
    ("census", "show", "fmp3_17"),
    ("census", "identify", COARSE),
    ("shell", os.path.join(SOURCE, "tests/data/moves.txt")),
)


# The one thing that may differ: how long it took, where a command says so.
TOOK = re.compile(rb'[0-9.e-]+ seconds|"seconds": \{[^}]*\}|"seconds": [0-9.e-]+')


def done_by(program, job, prefix=(), variables=None):
    """(status, standard output, standard error, {name of an output: its bytes})."""
    with tempfile.TemporaryDirectory() as folder:
        words = [word.replace("OUT", "out") if word.startswith("OUT.") else word for word in job]
        env = {"PATH": os.environ["PATH"], "HOME": folder, "LC_ALL": "C.UTF-8", **(variables or {})}
        done = subprocess.run([*prefix, program, *words], cwd=folder, env=env, capture_output=True, timeout=600,
                              check=False)
        written = {}
        for name in sorted(os.listdir(folder)):
            if os.path.isfile(os.path.join(folder, name)):
                with open(os.path.join(folder, name), "rb") as file:
                    written[name] = file.read()
        return done.returncode, TOOK.sub(b"", done.stdout), TOOK.sub(b"", done.stderr), written


class SameBytes(unittest.TestCase):
    def test_settings_change_nothing(self):
        settings = list(SETTINGS.items())
        runs = 0
        for k, job in enumerate(JOBS):
            if not ALL and k % 3 != 0:
                continue
            first = done_by(PROGRAM, job)
            self.assertIn(first[0], (0, 1, 4), (job, first[2]))
            outputs = sum(word.startswith("OUT.") for word in job)
            self.assertEqual(len(first[3]), outputs, job)
            for name, (prefix, variables) in settings if ALL else [settings[k // 3 % len(settings)]]:
                with self.subTest(job=job, setting=name):
                    self.assertTrue(done_by(PROGRAM, job, prefix, variables) == first)
                    runs += 1
            if OTHER:
                with self.subTest(job=job, setting="another build"):
                    self.assertTrue(done_by(OTHER, job) == first)
                    runs += 1
        print(f"{runs} runs compared", file=sys.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
