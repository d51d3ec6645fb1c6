#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What the program does when memory or the system fails it: each time one line of complaint, status 2, old files whole, none left over.

Usage: fault_test.py PROGRAM SOURCE_DIR [all]

A library of ours (fault.c) is loaded before the program and makes the n-th allocation or system call fail. For each job some n are
tried, evenly spread and all of the first; with "all", every one.
"""
import errno
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCE = os.path.abspath(sys.argv[2])
ALL = len(sys.argv) > 3 and sys.argv[3] == "all"
MESH = os.path.join(SOURCE, "tests/data/mesh")
RING = os.path.join(MESH, "ring_two_holes.off")
KNOTTED_Y = os.path.join(SOURCE, "tests/data/knotted_y_8k.mesh")
JOBS = (
    ("info", "cPcbbbihq"),
    ("info", os.path.join(SOURCE, "tests/data/knotted_y.json"), "--json"),
    ("convert", "m004", "-o", "OUT.tri"),
    ("convert", RING, "-o", "OUT.vtu"),
    ("check", RING),
    ("simplify", os.path.join(SOURCE, "tests/data/knotted_y.json"), "-o", "OUT.json"),
    ("hyperbolize", "cPcbbbihq", "-o", "OUT.json"),
    ("hyperbolize", "m004", "--json"),
    ("canonize", "fmp3_17"),
    ("isometric", "m004", "m003"),
    ("embed", "cPcbbbihq", "--copies", "5", "-o", "OUT.glb"),
    ("bundle", os.path.join(MESH, "torus.off"), "--fiber", "3", "-o", "OUT.json"),
    ("slit", RING, "-o", "OUT.obj", "-o", "OUT.svg"),
    ("slit", RING, "--domain", "circular", "--json"),
    ("census", "gluings", "--tetrahedra", "1"),
    ("census", "enumerate", "--tetrahedra", "2"),
    ("census", "identify", "cPcbbbihq"),
    ("skeleton", "m004"),
    ("group", "m004"),
    ("move", "m004", "--list"),
)
OLD = "what was there before\n"


class Faults(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.shim = os.path.join(folder.name, "fault.so")
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", os.path.join(SOURCE, "tests/fault/fault.c"), "-o", cls.shim, "-ldl"],
                       check=True)

    def run_job(self, job, **fault):
        """Runs it in a folder where its outputs exist already; gives what it did, and what the files hold then."""
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        outputs = [word for word in job if word.startswith("OUT")]
        for name in outputs:
            with open(os.path.join(self.folder.name, name), "w", encoding="utf-8") as file:
                file.write(OLD)
        env = {**os.environ, "LD_PRELOAD": self.shim, "FAULT_COUNT": os.path.join(self.folder.name, "count"),
               **{f"FAULT_{name.upper()}": str(value) for name, value in fault.items()}}
        done = subprocess.run([PROGRAM, *job, "--threads", "1"], capture_output=True, cwd=self.folder.name, env=env, timeout=60)
        held = {}
        for name in outputs:
            with open(os.path.join(self.folder.name, name), "rb") as file:
                held[name] = file.read()
        self.assertGreaterEqual(done.returncode, 0, (job, fault, done.stderr))
        counts = os.path.join(self.folder.name, "count")
        if os.path.exists(counts) or done.returncode != 2:  # want of memory may end the program before the library can count
            with open(counts, encoding="utf-8") as file:
                self.count, self.peak = map(int, file.read().split())
        left = set(os.listdir(self.folder.name)) - set(outputs) - {"count"}
        self.folder.cleanup()
        self.assertEqual(left, set(), (job, fault, "left behind"))
        return done, held

    def counted(self, job, calls):
        """How it ends when nothing fails; the number of calls, and the greatest number of bytes held."""
        done, held = self.run_job(job, calls=calls)
        self.assertIn(done.returncode, (0, 1), (job, done.stderr))
        return done, held, self.count, self.peak

    def judge(self, job, fault, whole, calls):
        """Either all is as if nothing had failed, or a complaint and every output as it was."""
        done, held = self.run_job(job, calls=calls, **fault)
        shown = (job, calls, fault, done.returncode, done.stderr)
        normal, made = whole
        if done.returncode == normal.returncode:
            self.assertEqual(done.stdout.count(b"\n"), normal.stdout.count(b"\n"), shown)
            self.assertEqual({name: len(content) for name, content in held.items()},
                             {name: len(content) for name, content in made.items()}, shown)
            return 0
        self.assertEqual(done.returncode, 2, shown)
        self.assertEqual(done.stderr.count(b"\n"), 1, shown)
        self.assertTrue(done.stderr.startswith((b"tetrarch: ", b'{"error"')), shown)
        for name, content in held.items():
            self.assertEqual(content, OLD.encode(), (shown, name))
        return 1

    def places(self, count, sample):
        if ALL or count <= sample:
            return range(1, count + 1)
        first = sample // 3
        step = (count - first) / (sample - first)
        return [*range(1, first + 1), *(first + 1 + int(k * step) for k in range(sample - first))]

    def test_an_allocation_fails(self):
        for job in JOBS:
            done, made, count, _ = self.counted(job, "memory")
            self.assertGreater(count, 300, job)
            for n in self.places(count, 30):
                self.judge(job, {"at": n}, (done, made), "memory")

    def test_memory_ends(self):
        for job in JOBS:
            done, made, _, peak = self.counted(job, "")
            failed = sum(self.judge(job, {"bytes": peak * k // 24}, (done, made), "") for k in range(1, 24))
            self.assertGreater(failed, 10, job)  # else nothing was made to fail

    def test_a_system_call_fails(self):
        failed = 0
        for job in JOBS:
            for calls, reported in (("open", errno.EMFILE), ("read", errno.EIO), ("write", errno.ENOSPC), ("fsync", errno.EIO),
                                    ("close", errno.EIO), ("rename", errno.EACCES), ("stat", errno.EIO)):
                done, made, count, _ = self.counted(job, calls)
                for n in self.places(count, 12):
                    failed += self.judge(job, {"at": n, "errno": int(reported)}, (done, made), calls)
        self.assertGreater(failed, 50)


if __name__ == "__main__":
    if not shutil.which("cc"):
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
