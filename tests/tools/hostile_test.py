# SPDX-License-Identifier: GPL-2.0-or-later
"""Files, signals and surroundings that mean no good: one line of complaint, a right status, and nothing left behind."""
import json
import os
import random
import resource
import signal
import struct
import subprocess
import tempfile
import time
import unittest

from running import INSTRUMENTED, PROGRAM, SLOWER, InFolder, run, run_json, seconds_of_work, wait_until_it_listens

ODD = "0.84375"  # a coordinate that stands once in the file, exact as a float
TETRAHEDRON = f"OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 {ODD}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"


def triangulation(gluings, **more):
    return json.dumps({"format": "tetrarch-triangulation", "version": 1, "tetrahedra": len(gluings), "gluings": gluings,
                       **more})


def star(size):
    """Tetrahedra round one edge, 01 of each: a ball."""
    return triangulation([[None, None, [(t + 1) % size, "0132"], [(t - 1) % size, "0132"]] for t in range(size)])


def random_gluing(size, seed):
    """All faces glued in pairs by chance: few edges, each with thousands of tetrahedra around it."""
    chance = random.Random(seed)
    faces = [(t, f) for t in range(size) for f in range(4)]
    chance.shuffle(faces)
    gluings = [[None] * 4 for _ in range(size)]
    for (t, f), (u, g) in zip(faces[::2], faces[1::2]):
        corners, others = [c for c in range(4) if c != f], [c for c in range(4) if c != g]
        chance.shuffle(others)
        there = {f: g, **dict(zip(corners, others))}
        gluings[t][f] = [u, "".join(str(there[c]) for c in range(4))]
        back = {b: a for a, b in there.items()}
        gluings[u][g] = [t, "".join(str(back[c]) for c in range(4))]
    return triangulation(gluings)


class Refusals(InFolder):
    def refused(self, *arguments, **how):
        """The complaint, which is one line that obeys nobody."""
        done = run(*arguments, **how)
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), (arguments, done.stderr))
        self.assertNotRegex(done.stderr[:-1], "[\x00-\x1f\x7f-\x9f]")
        return done.stderr


class NotNumbers(Refusals):
    def test_coordinates_of_every_format_are_finite(self):
        surfaces = (".off", ".obj", ".ply", ".stl")
        good = self.path("good.off", TETRAHEDRON)
        medit = self.path("good.mesh", f"MeshVersionFormatted 2\nDimension 3\nVertices\n4\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                                       f"0 0 {ODD} 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n")
        for extension in (*surfaces, ".mesh", ".msh", ".vtk", ".node"):
            path = self.path("g" + extension)
            source = good if extension in surfaces else medit
            self.assertEqual(run("convert", source, "-o", path).returncode, 0, extension)
            with open(path, encoding="ascii") as file:
                text = file.read()
            at = text.rindex(ODD)  # before the points, Gmsh's files have a box
            place = 1 + text[:at].count("\n")
            for word in ("nan", "inf", "-inf"):
                with open(path, "w", encoding="ascii") as file:
                    file.write(text[:at] + word + text[at + len(ODD):])
                for arguments in (("convert", path, "-o", self.path("out.json")), ("check", path), ("info", path),
                                  ("convert", path, "-o", self.path("out.vtu"))):
                    said = self.refused(*arguments)
                    self.assertIn(word, said)
                    if extension != ".msh":  # which lists the numbers of vertices first: their line
                        self.assertIn(f"g{extension}:{place}: ", said)
                    self.assertRegex(said, f"g{extension}:\\d+: coordinate z of vertex ")
                    self.assertFalse({"out.json", "out.vtu"} & set(os.listdir(self.folder.name)))

    def test_a_binary_file(self):
        corners = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, float("nan"))]
        content = b"\0" * 80 + struct.pack("<I", 4)
        for face in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)):
            content += struct.pack("<12fH", 0, 0, 0, *[x for v in face for x in corners[v]], 0)
        with open(self.path("b.stl"), "wb") as file:
            file.write(content)
        self.assertIn("b.stl: coordinate z of vertex", self.refused("check", self.path("b.stl")))

    def test_json_has_no_such_numbers(self):
        for word in ("NaN", "Infinity", "1e999", "null"):
            text = ('{"format": "tetrarch-mesh", "version": 1, "vertices": [[0,0,0],[1,0,0],[0,1,0],[0,0,' + word +
                    ']],\n"tetrahedra": [[0,1,2,3]]}')
            self.refused("convert", self.path("m.json", text), "-o", self.path("out.mesh"))

    def test_options(self):
        for arguments in (("embed", "cPcbbbihq", "--radius", "nan"), ("embed", "cPcbbbihq", "--memory", "inf"),
                          ("bundle", self.path("t.off", TETRAHEDRON), "--field", "0", "0", "nan")):
            self.assertIn("is no finite number", self.refused(*arguments))


class Escapes(Refusals):
    NAME = "Würfel\nhomology    Z^7\x1b[2J\x07\x7f\x9b1m"

    def test_names_in_files(self):
        path = self.path("n.json", triangulation(
            [[[1, "0123"], [1, "1203"], [1, "1032"], [1, "3021"]], [[0, "0123"], [0, "1320"], [0, "2013"], [0, "1032"]]],
            name=self.NAME))
        for arguments in (("info", path), ("info", path + "#1"), ("info", path + "#*"), ("simplify", path)):
            done = run(*arguments)
            self.assertNotRegex(done.stdout + done.stderr, "[\x00-\x09\x0b-\x1f\x7f-\x9f]", arguments)
            self.assertNotRegex(done.stdout, "(?m)^homology +Z\\^7")
        self.assertIn("Würfel?homology    Z^7?[2J????1m", run("info", path).stdout)
        done = run("info", path, "--json")
        self.assertNotRegex(done.stdout, "[\x00-\x09\x0b-\x1f\x7f-\x9f]")
        self.assertEqual(json.loads(done.stdout)["name"], self.NAME)
        # A file keeps what it was given, in a pipe too.
        self.assertEqual(json.loads(run("convert", path).stdout)["name"], self.NAME)

    def test_names_of_files(self):
        bad = self.path("two\nlines\x1b[2J.off", "OFF\n1 0 0\n0 0 zero\n")
        said = self.refused("check", bad)
        self.assertIn("two?lines?[2J.off:3: found 'zero'", said)
        self.refused("info", bad)
        self.refused("info", self.path("no\nfile\x1b.tri"))
        self.assertIn("no?such?/x.json", self.refused("convert", "cPcbbbihq", "-o", self.path("no\nsuch\x1b/x.json")))
        good = self.path("not\nclosed\x1b.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 0\n1 0 0 0\n0 1 0 0\n"
                         "0 0 1 0\n7 7 7 0\nTetrahedra\n1\n1 2 3 4 0\nEnd\n")
        for arguments in (("info", good), ("check", good)):  # a vertex that nothing has: a warning
            done = run(*arguments)
            self.assertNotRegex(done.stdout + done.stderr, "[\x00-\x09\x0b-\x1f\x7f-\x9f]", arguments)


class Signals(InFolder):
    def ended(self, job, number, after=0.3):
        """Seconds from one signal to the end, status 130 and one line of complaint."""
        wait_until_it_listens(job)
        time.sleep(after)
        self.assertIsNone(job.poll())
        start = time.monotonic()
        job.send_signal(number)
        self.assertEqual(job.wait(timeout=60), 130)
        took = time.monotonic() - start
        said = job.stderr.read()
        for stream in (job.stdin, job.stdout, job.stderr):
            if stream is not None:
                stream.close()
        self.assertEqual(said, b"tetrarch: interrupted; nothing was written\n")
        return took

    def start(self, *arguments):
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder.name, stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)

    def test_one_signal_ends_what_waits(self):
        os.mkfifo(self.path("fifo"))
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for arguments in (("info", "fifo"), ("info", "-"), ("shell",), ("shell", "-"), ("shell", "fifo"),
                              ("shell", "--keep-going"), ("info", "fifo#*"), ("check", "-", "-o", "x.mesh")):
                self.assertLess(self.ended(self.start(*arguments), number), 2, (arguments, number))
        self.assertEqual(os.listdir(self.folder.name), ["fifo"])

    def test_one_signal_ends_what_works(self):
        self.path("random.json", random_gluing(3000, 5))
        for number, arguments in ((signal.SIGTERM, ("census", "gluings", "--tetrahedra", "8", "-o", "out.txt")),
                                  (signal.SIGHUP, ("info", "random.json")), (signal.SIGINT, ("canonize", "random.json"))):
            job = self.start(*arguments)
            wait_until_it_listens(job)
            time.sleep(0.3)
            if job.poll() is None:
                self.assertLess(self.ended(job, number, 0), 2, arguments)
            else:  # it was quick
                job.communicate()
        self.assertEqual(os.listdir(self.folder.name), ["random.json"])

    def test_one_signal_ends_what_nobody_reads(self):
        self.path("star.json", star(20000))
        job = self.start("convert", "star.json")  # more than a pipe holds
        self.assertLess(self.ended(job, signal.SIGTERM, 2), 2)

    def test_a_file_beyond_the_limit(self):
        self.path("star.json", star(2000))
        self.path("out.json", "old")

        def limit():
            resource.setrlimit(resource.RLIMIT_FSIZE, (10000, 10000))

        done = subprocess.run([PROGRAM, "convert", "star.json", "-o", "out.json"], cwd=self.folder.name, preexec_fn=limit,
                              capture_output=True, text=True, timeout=60)
        self.assertEqual((done.returncode, done.stderr), (2, "tetrarch: out.json: cannot be written: File too large\n"))
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["out.json", "star.json"])
        with open(self.path("out.json"), encoding="ascii") as file:
            self.assertEqual(file.read(), "old")


class Outputs(Refusals):
    LONG = ("census", "gluings", "--tetrahedra", "8")  # minutes

    def test_outputs_are_tried_first(self):
        os.mkdir(self.path("folder"))
        for path, cause in ((self.path("none/out.txt"), "there is no such folder"), (self.path("folder"), "is a directory"),
                            ("/sys/out.txt", "cannot be written"), (self.path("x" * 300), "cannot be written")):
            self.assertIn(cause, self.refused(*self.LONG, "-o", path))
        self.assertEqual(os.listdir(self.folder.name), ["folder"])
        for command in (("canonize", "cPcbbbiht"), ("hyperbolize", "cPcbbbiht"), ("simplify", "cPcbbbiht"),
                        ("group", "cPcbbbiht"), ("truncate", "cPcbbbihq"), ("check", self.path("t.off", TETRAHEDRON))):
            self.assertIn("there is no such folder", self.refused(*command, "-o", self.path("none/out.json")))

    def test_a_folder_that_is_gone(self):
        with tempfile.TemporaryDirectory() as outer:
            gone = os.path.join(outer, "gone")
            os.mkdir(gone)
            done = subprocess.run([PROGRAM, *self.LONG, "-o", "out.txt"], cwd=gone, preexec_fn=lambda: os.rmdir(gone),
                                  capture_output=True, text=True, timeout=60)
            self.assertEqual((done.returncode, done.stderr), (2, "tetrarch: out.txt: there is no such folder\n"))

    def test_no_folder_for_temporary_files(self):
        surface = self.path("t.off", TETRAHEDRON)
        said = self.refused("info", surface, env={**os.environ, "TMPDIR": self.path("none")})
        self.assertIn("TMPDIR", said)

    def test_a_full_disk(self):
        for arguments in (("--help",), ("--version",), ("help",), ("help", "info"), ("info", "--help"), (),
                          ("info", "cPcbbbiht"), ("help", "--json")):
            with open("/dev/full", "w", encoding="ascii") as full:
                done = subprocess.run([PROGRAM, *arguments], stdout=full, stderr=subprocess.PIPE, text=True, timeout=60)
            said = json.loads(done.stderr)["error"]["message"] if "--json" in arguments else done.stderr
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(said.removeprefix("tetrarch: ").strip(), "cannot write to standard output", arguments)


class Bounds(Refusals):
    def test_numbers_too_great(self):
        for copies in (2**63 - 1, 2**62, 10**17):
            self.assertIn("--memory", self.refused("embed", "cPcbbbihq", "--copies", str(copies)))
        for generators in (10**7, 2**31 - 1, 2**31, 2**64, -1):
            text = '{"format": "tetrarch-group", "version": 1, "generators": %d, "relators": []}' % generators
            done, work = seconds_of_work("group", self.path("g.json", text))
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), generators)
            self.assertIn("generators", done.stderr)
            self.assertLess(work, 2)

    @unittest.skipIf(INSTRUMENTED, "memory is not bounded there")
    @unittest.skipIf((os.cpu_count() or 1) > 4, "each processor adds a buffer of OpenBLAS to what is allowed")
    def test_memory_has_an_end(self):
        big = self.path("rings.sig", "cPcbbbihq\n" * 400_000)
        complaint = self.refused("info", big + "#1", "--memory", "0.01")
        self.assertIn("out of memory", complaint)
        self.assertIn(" 10 MB allowed (--memory)", complaint)
        self.assertEqual(run("info", "cPcbbbihq", "--memory", "0.01").returncode, 0)

    @unittest.skipIf(INSTRUMENTED, "the program does not start there")
    def test_a_small_address_space(self):
        for kilobytes in (150_000, 200_000, 400_000):  # OpenBLAS's threads would wait for their buffers for ever
            done = subprocess.run(f"ulimit -v {kilobytes}; exec '{PROGRAM}' info cPcbbbihq", shell=True, capture_output=True,
                                  text=True, timeout=20)
            self.assertEqual((done.returncode, done.stderr), (0, ""), kilobytes)


class Growth(InFolder):
    def test_moves_of_one_kind_are_listed_quickly(self):
        # Of 4n/2 faces between n tetrahedra, those with two different ones have a 2-3 move.
        size = 3000
        path = self.path("r.json", random_gluing(size, 7))
        with open(path, encoding="utf-8") as file:
            gluings = json.load(file)["gluings"]
        between = sum(g[0] != t for t, four in enumerate(gluings) for g in four) // 2
        done, work = seconds_of_work("move", path, "--list", "2-3", "--json")
        answer = json.loads(done.stdout)
        self.assertEqual((done.returncode, len(answer["moves"]), answer["complete"]), (0, between, True))
        self.assertLess(work, 5)
        done, work = seconds_of_work("move", path, "--list")
        self.assertEqual(done.returncode, 0)
        self.assertIn("there are more 0-2 moves at edges", done.stderr)
        self.assertLess(work, 10)

    def test_lines_that_are_passed_over_cost_no_more_than_themselves(self):
        corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"
        groups = self.path("groups.obj", corners + "g part\nusemtl paint\n" * 200_000 + "v 0 0 1\n" * 400_000)
        head = ("# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nCELLS 1 4\n"
                "3 0 1 2\nCELL_TYPES 1\n5\nCELL_DATA 1\n")
        arrays = self.path("arrays.vtk", head + "FIELD f 60000\n" + "".join(f"a{k} 1 1 int\n{k}\n" for k in range(60_000)))
        for path, told in ((groups, "name of a group (200000)"), (arrays, "and 59950 other kinds of things")):
            done, work = seconds_of_work("convert", path, "-o", self.path("out.off"))
            self.assertEqual(done.returncode, 0, path)
            self.assertIn(told, done.stderr)
            self.assertLess(len(done.stderr), 5000)
            self.assertLess(work, 3 * SLOWER)

    def test_a_hub_is_not_walked_round_for_every_tetrahedron(self):
        times = []
        for size in (10000, 40000):
            done, work = seconds_of_work("simplify", self.path("s.json", star(size)), "--json")
            self.assertEqual(done.returncode, 0)
            times.append(work)
        self.assertLess(times[1], 8 * max(times[0], 0.1))  # four times as much, were it linear; sixteen if quadratic
