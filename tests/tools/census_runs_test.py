# SPDX-License-Identifier: GPL-2.0-or-later
"""A census where the disk is full, on several processes at once, and asked for manifolds that others have changed."""
import json
import os
import shutil
import signal
import subprocess
import time
import unittest

from running import PROGRAM, SOURCE, InFolder

MPI_PROGRAM = PROGRAM + "-mpi"
# Open MPI refuses root and more ranks than cores unless it is told.
MPIRUN = ["mpirun", "--allow-run-as-root", "--oversubscribe", "--bind-to", "none"]

# In a mount namespace of its own $1 is a disk of 64 kB; the rest is the command, first there and then with room enough. Without the
# right to make one, as in some containers, it says 99.
SMALL_DISK = """mount -t tmpfs -o size=64k none "$1" || exit 99
disk=$1
shift
"$@"
echo "status $?" >&2
ls "$disk/work" >&2
mount -o remount,size=64m "$disk" || exit 99
"$@" --resume
echo "status $?" >&2
"""


def three():
    with open(f"{SOURCE}/census/fmp3.json", "rb") as file:
        return file.read()


class CensusRuns(InFolder):
    def test_a_full_disk_loses_nothing(self):
        disk, table = self.path("disk"), self.path("table.json")
        os.mkdir(disk)
        command = [PROGRAM, "census", "enumerate", "--tetrahedra", "3", "--work", os.path.join(disk, "work"), "-o", table]
        done = subprocess.run(["unshare", "--map-root-user", "--mount", "sh", "-c", SMALL_DISK, "sh", disk, *command],
                              capture_output=True, text=True, timeout=300, check=False)
        if done.returncode == 99 or done.stderr.startswith("unshare:"):
            self.skipTest("no mount namespaces here")
        lines = done.stderr.splitlines()
        self.assertIn("work/records: cannot be written: No space left on device", lines[0])
        self.assertEqual(lines[1:], ["status 2", "records", "status 0"], done.stderr)
        self.assertNotIn("damaged", done.stderr)
        with open(table, "rb") as file:
            self.assertEqual(file.read(), three())

    def test_names_survive_what_regina_does(self):
        # Recorded: Regina 7.3, 5 to 60 random moves on each of 1,000 manifolds (tests/oracle/record_retriangulated.py).
        with open(f"{SOURCE}/tests/oracle/regina_retriangulated.txt", encoding="ascii") as file:
            records = [line.split("|") for line in file.read().splitlines() if not line.startswith("#")]
        listed = subprocess.run([PROGRAM, "census", "list", "--tetrahedra", "5", "--count"], capture_output=True, check=False)
        if listed.returncode != 0:  # this build has no table of five
            records = [record for record in records if not record[0].startswith("tet5")]
        self.assertGreater(len(records), 390)
        path = self.path("changed.sig", "".join(record[3] + "\n" for record in records))
        done = subprocess.run([PROGRAM, "census", "identify", path + "#*", "--json"], capture_output=True, text=True, timeout=600,
                              check=False)
        found = [json.loads(line)["name"] for line in done.stdout.splitlines()]
        self.assertEqual([(record[0], name) for record, name in zip(records, found) if record[0] != name], [])
        self.assertEqual((len(found), done.returncode), (len(records), 0))


@unittest.skipUnless(os.path.exists(MPI_PROGRAM) and shutil.which("mpirun"), "there is no tetrarch-mpi")
class Mpi(InFolder):
    def enumerate(self, ranks, *more, options=(), **how):
        return subprocess.run([*MPIRUN, *options, "-n", str(ranks), MPI_PROGRAM, "census", "enumerate", "--tetrahedra", "3", *more],
                              capture_output=True, text=True, timeout=300, check=False, **how)

    def test_the_table_is_that_of_one_process(self):
        for ranks in (1, 2, 4):
            table = self.path(f"table{ranks}.json")
            done = self.enumerate(ranks, "-o", table, "--work", self.path(f"work{ranks}"))
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(table, "rb") as file:
                self.assertEqual(file.read(), three(), ranks)
        # One program goes on with what the other has done, and has nothing left to do.
        done = subprocess.run([PROGRAM, "census", "merge", self.path("work4"), "--tetrahedra", "3", "-o", self.path("merged.json")],
                              capture_output=True, text=True, check=False)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = self.enumerate(2, "--resume", "--work", self.path("work1"), "-o", self.path("again.json"))
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in ("merged.json", "again.json"):
            with open(self.path(name), "rb") as file:
                self.assertEqual(file.read(), three(), name)

    def test_mistakes_are_told_once_and_everybody_leaves(self):
        for bad in (("--shard", "1/2", "--work", self.path("work")), ("--nonsense",), ("--work", "/proc/none")):
            done = self.enumerate(3, *bad)
            self.assertEqual((done.returncode, done.stderr.count("tetrarch-mpi: ")), (2, 1), done.stderr)

    def test_a_worker_that_is_killed_costs_its_unit(self):
        # Where Open MPI is told to let the others live; else it ends all, and the next run goes on.
        for options in (("--enable-recovery",), ()):
            work, table = self.path("work" + "".join(options)), self.path("table.json")
            job = subprocess.Popen([*MPIRUN, *options, "-n", "3", MPI_PROGRAM, "census", "enumerate", "--tetrahedra", "3", "--work",
                                    work, "-o", table], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
            records = os.path.join(work, "records")
            while job.poll() is None and not (os.path.exists(records) and os.path.getsize(records) > 2000):
                time.sleep(0.01)
            ranks = [int(pid) for pid in subprocess.run(["ps", "-o", "pid=", "--ppid", str(job.pid)], capture_output=True, text=True,
                                                        check=False).stdout.split()]
            if ranks:
                os.kill(max(ranks), signal.SIGKILL)
            _, said = job.communicate(timeout=120)
            if not options:
                self.assertNotEqual(job.returncode, 0)
                done = self.enumerate(2, "--resume", "--work", work, "-o", table)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertNotIn("damaged", done.stderr)
            with open(table, "rb") as file:
                self.assertEqual(file.read(), three(), said)
            os.remove(table)
