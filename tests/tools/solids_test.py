# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes of tetrahedra that become manifolds, and what is wrong with meshes. Part of program_test.py."""
import json
import os
import signal
import subprocess
import tempfile
import time
import unittest

from running import InFolder, medit, PROGRAM, run, run_json, SOURCE, wait_until_it_listens


KNOTTED_Y = os.path.join(SOURCE, "tests/data/knotted_y_8k.mesh")


def cubes(n):
    """A cube of n^3 cubes, each split along its diagonal into six tetrahedra."""
    def point(x, y, z):
        return (x * (n + 1) + y) * (n + 1) + z
    points = [(x, y, z) for x in range(n + 1) for y in range(n + 1) for z in range(n + 1)]
    steps = [((1, 0, 0), (1, 1, 0)), ((1, 0, 0), (1, 0, 1)), ((0, 1, 0), (1, 1, 0)), ((0, 1, 0), (0, 1, 1)),
             ((0, 0, 1), (1, 0, 1)), ((0, 0, 1), (0, 1, 1))]
    tetrahedra = [(point(x, y, z), point(x + a[0], y + a[1], z + a[2]), point(x + b[0], y + b[1], z + b[2]),
                   point(x + 1, y + 1, z + 1))
                  for x in range(n) for y in range(n) for z in range(n) for a, b in steps]
    return points, tetrahedra


class Meshes(unittest.TestCase):
    def test_the_knotted_y_from_its_mesh(self):
        # Yin, sections 4.2.3 and 4.3.4: two tetrahedra, all dihedral angles pi/6; the volume by Frigerio, Martelli and
        # Petronio (2004).
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "y.json")
            status, made = run_json("truncate", KNOTTED_Y, "-o", path)
            self.assertEqual((status, made["signature"], made["input_tetrahedra"]), (0, "cPcbbbihq", 7709))
            self.assertEqual(made["boundary"], [{"kind": "ideal", "genus": 2, "orientable": True, "euler": -2}])
            self.assertEqual([b["type"] for b in made["boundary_map"]], ["genus 2"])
            self.assertEqual([s["vertices"] for s in made["steps"]], [1916, 1916, 1917, 1])
            self.assertLess(made["seconds"], 10)
            for source in (path, KNOTTED_Y):
                status, found = run_json("hyperbolize", source)
                self.assertEqual((status, found["outcome"], found["signature"]), (0, "geometric", "cPcbbbihq"))
                self.assertAlmostEqual(found["volume"], 6.451990270835, delta=1e-11)

    def test_moves_are_written_and_audited(self):
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, "moves.txt")
            self.assertEqual(run("truncate", KNOTTED_Y, "--moves", log, "--audit").returncode, 0)
            with open(log, encoding="ascii") as file:
                kinds = [line.split()[0] for line in file]
            self.assertEqual(kinds.count("cone"), 1)
            # Every vertex of the file goes, by one of these.
            gone = sum(kinds.count(kind) for kind in ("merge", "pinch", "two_zero_vertex", "four_one"))
            self.assertEqual(gone - kinds.count("one_four") - kinds.count("zero_two_face"), 1916)

    def test_simplify(self):
        text = medit(*cubes(4))
        done = run("simplify", "-", "--json", stdin=text)
        info = json.loads(done.stdout)
        self.assertEqual((info["input_tetrahedra"], info["tetrahedra"], info["homology"]), (384, 1, "0"))
        kept = json.loads(run("simplify", "-", "--keep-boundary", "--json", stdin=text).stdout)
        self.assertGreater(kept["tetrahedra"], 4 * 4 * 6 * 2 // 4)

    def test_repair(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (9, 9, 9)]
        text = medit(points, [(0, 1, 2, 3), (1, 2, 3, 4), (3, 2, 1, 0), (4, 3, 2, 1)])
        refused = run("info", "-", stdin=text)
        self.assertEqual(refused.returncode, 2)
        self.assertIn("standard input:15:", refused.stderr)
        done = run("simplify", "-", "--repair", "--json", stdin=text)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(json.loads(done.stdout)["input_tetrahedra"], 2)
        for word in ("duplicate", "unused"):
            self.assertIn(word, done.stderr)

    def test_bad_meshes(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (-1, -1, -1), (2, 2, 0), (0, 2, 2)]
        cases = {
            "index out of range": ([(0, 1, 2, 8)], "15"),
            "repeated vertex": ([(0, 1, 2, 2)], "15"),
            "duplicate": ([(0, 1, 2, 3), (1, 0, 2, 3)], "16"),
            "face shared by three": ([(0, 1, 2, 3), (0, 1, 2, 4), (0, 1, 2, 5)], None),
            "edge in the middle of nothing": ([(0, 1, 2, 3), (0, 1, 4, 5)], None),
            "vertex in the middle of nothing": ([(0, 1, 2, 3), (0, 4, 5, 6)], None),
            "two components": ([(0, 1, 2, 3), (4, 5, 6, 7)], None),
            "no tetrahedra": ([], None),
        }
        for name, (tetrahedra, line) in cases.items():
            for command in ("info", "truncate", "hyperbolize"):
                if name == "two components" and command != "hyperbolize":
                    continue
                done = run(command, "-", stdin=medit(points, tetrahedra))
                self.assertEqual((done.returncode, done.stdout), (2, ""), (name, command, done.stderr))
                errors = [e for e in done.stderr.splitlines() if "warning" not in e]
                self.assertEqual(len(errors), 1, (name, done.stderr))
                if line:
                    self.assertIn("standard input:%s:" % line, errors[0], name)

    def test_check_tells_everything_by_element_and_line(self):
        points = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1), (9, 9, 9)]
        text = medit(points, [(0, 1, 2, 3), (1, 2, 3, 3), (3, 2, 1, 0), (1, 3, 2, 4), (0, 1, 2, 6)])
        done = run("check", "-", "--json", stdin=text)
        report = json.loads(done.stdout)
        self.assertEqual(done.returncode, 1)
        # By hand: tetrahedron 2 repeats a vertex, 3 is 1 again, 4 has negative volume, 5 names a vertex too many;
        # vertex 6 is used by nobody.
        self.assertEqual([(f["kind"], f["number"], f["line"]) for f in report["findings"]],
                         [("index_out_of_range", 5, 17), ("repeated_vertex", 2, 14), ("duplicate", 3, 15),
                          ("inverted", 4, 16), ("unused_vertex", 6, 10)])
        self.assertEqual(report["fatal"], 2)
        plain = run("check", "-", stdin=text)
        self.assertEqual(plain.stdout.count("standard input:"), 5)

    def test_meshes_become_meshes(self):
        with tempfile.TemporaryDirectory() as folder:
            before = KNOTTED_Y
            for name in ("a.msh", "b.vtk", "c.vtu", "d.node", "e.mesh"):
                path = os.path.join(folder, name)
                status, made = run_json("convert", before, "-o", path)
                self.assertEqual((status, made["tetrahedra"]), (0, 7709), name)
                before = path
            self.assertEqual(run_json("truncate", before)[1]["signature"], "cPcbbbihq")

    def test_what_would_be_lost_is_refused(self):
        with tempfile.TemporaryDirectory() as folder:
            for arguments, word in ((["truncate", KNOTTED_Y, "-o", "y.json", "--moves", "./y.json"], "two results"),
                                    (["truncate", KNOTTED_Y, "--moves", "none/y.txt"], "no such folder"),
                                    (["hyperbolize", "cPcbbbihq", "-o", "y.tri"], "only JSON"),
                                    (["convert", "cPcbbbihq", "-o", "y.mesh"], "coordinates")):
                done = run(*arguments, cwd=folder)
                self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), arguments)
                self.assertIn(word, done.stderr)
            with open(os.path.join(folder, "far.off"), "w", encoding="ascii") as file:
                file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 99\n")
            done = run("convert", "far.off", "-o", "far.stl", cwd=folder)
            self.assertEqual(done.returncode, 2)
            self.assertIn("far.off:6: triangle", done.stderr)
            self.assertEqual(os.listdir(folder), ["far.off"])

    def test_a_mesh_cut_anywhere_is_refused_or_whole(self):
        text = medit(*cubes(1)).replace("\nEnd\n", "")
        for end in range(0, len(text) - 2, 7):
            done = run("truncate", "-", stdin=text[:end])
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), end)

    def test_an_interrupted_conversion_leaves_no_file(self):
        with tempfile.TemporaryDirectory() as folder:
            mesh = os.path.join(folder, "cubes.mesh")
            with open(mesh, "w", encoding="ascii") as file:
                file.write(medit(*cubes(36)))
            job = subprocess.Popen([PROGRAM, "truncate", "cubes.mesh", "-o", "out.json", "--moves", "log.txt"],
                                   cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            wait_until_it_listens(job)
            time.sleep(0.15)
            job.send_signal(signal.SIGINT)
            self.assertEqual(job.wait(timeout=120), 130)
            job.communicate()
            self.assertEqual(os.listdir(folder), ["cubes.mesh"])


class WaysOn(InFolder):
    """What a command refuses names what leads on."""

    def refused(self, *arguments):
        done = run(*arguments)
        self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), arguments)
        return done.stderr

    def test_a_disk_and_a_sphere(self):
        disk = self.path("disk.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.5 .5 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")
        self.assertIn("; --domain circular maps it, --punch makes more holes", self.refused("slit", disk))
        sphere = self.path("sphere.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n")
        for domain in ("concentric", "circular"):
            message = self.refused("slit", sphere, "--domain", domain)
            self.assertIn("; --punch makes holes", message)
            self.assertNotIn("--domain circular", message)
        self.assertEqual(run("slit", disk, "--domain", "circular").returncode, 0)

    def test_a_surface_in_no_format(self):
        torus = os.path.join(SOURCE, "tests/data/mesh/torus.off")
        message = self.refused("convert", torus, "-o", self.path("torus.gltf"))
        for format in (".off", ".vtu", ".tri"):
            self.assertIn(format, message)


class CheckSurface(unittest.TestCase):
    # A square ring of eight squares: by hand, loops of length 12 around area 9 and of length 4 around area 1.
    POINTS = [(x, y, 0) for x in range(4) for y in range(4)]
    RING = [t for x in range(3) for y in range(3) if (x, y) != (1, 1)
            for t in ((4 * x + y, 4 * x + y + 4, 4 * x + y + 5), (4 * x + y, 4 * x + y + 5, 4 * x + y + 1))]

    def off(self, triangles, points=None):
        """Point v stands on line 3 + v, triangle t on line 3 + t + the number of points."""
        points = self.POINTS if points is None else points
        lines = ["OFF", "%d %d 0" % (len(points), len(triangles))]
        lines += ["%g %g %g" % p for p in points] + ["3 %d %d %d" % t for t in triangles]
        return "\n".join(lines) + "\n"

    def check(self, triangles, *options, points=None):
        done = run("check", "-", "--json", *options, stdin=self.off(triangles, points))
        self.assertEqual(done.stderr, "")
        return done.returncode, json.loads(done.stdout)

    def test_type_and_loops(self):
        status, info = self.check(self.RING)
        self.assertEqual((status, info["triangles"], info["vertices"], info["fatal"]), (0, 16, 16, 0))
        self.assertEqual((info["type"], info["components"], info["findings"]), ("sphere, 2 holes", 1, []))
        self.assertEqual([(b["index"], b["length"], b["area"]) for b in info["boundary_loops"]],
                         [(0, 12, 9), (1, 4, 1)])
        self.assertEqual(set(info["boundary_loops"][1]["vertices"]), {5, 6, 9, 10})
        plain = run("check", "-", stdin=self.off(self.RING)).stdout
        self.assertIn("boundary loop 1: 4 edges, length 4, area 1, through v", plain)

    def test_faults_by_element_and_line(self):
        triangles = self.RING + [(0, 5, 15), (1, 1, 2), (5, 4, 0)]
        triangles[2] = (1, 6, 5)
        status, info = self.check(triangles)
        # By hand: triangle 16 is the third at the edge 0-5, alone at vertex 15, and flat, as all three are on the
        # diagonal; 17 repeats vertex 1; 18 is 0 again; 2 is turned.
        self.assertEqual([(f["kind"], f["number"], f["line"]) for f in info["findings"]],
                         [("degenerate", 17, 36), ("duplicate", 18, 37), ("non_manifold_edge", 16, 35),
                          ("non_manifold_vertex", 15, 18), ("turned", 2, 21), ("flat", 16, 35)])
        self.assertEqual((status, info["fatal"], "type" in info), (1, 2, False))

    def test_repair(self):
        triangles = [(a, c, b) if k % 5 == 0 else (a, b, c) for k, (a, b, c) in enumerate(self.RING)]
        triangles = [(a + 1, b + 1, c + 1) for a, b, c in triangles + [(0, 0, 1), self.RING[3]]]
        points = [(9, 9, 9)] + self.POINTS
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mended.obj")
            status, info = self.check(triangles, "--repair", "-o", path, points=points)
            self.assertEqual((status, info["counts"], info["type"]), (0, {}, "sphere, 2 holes"))
            self.assertEqual(info["repairs"], ["removed 1 degenerate triangles", "removed 1 duplicate triangles",
                                               "turned round 4 triangles against their component",
                                               "removed 1 unused vertices"])
            # The vertices of loops are those of the file, where one stood before them.
            self.assertEqual(set(info["boundary_loops"][1]["vertices"]), {6, 7, 10, 11})
            again = run_json("check", path)[1]
            self.assertEqual((again["findings"], again["triangles"], again["vertices"]), ([], 16, 16))
            # In OBJ vertices are numbered from 1; loops are told from 0, as v17 asks for them.
            self.assertEqual(set(again["boundary_loops"][1]["vertices"]), {5, 6, 9, 10})

    def test_no_orientation_and_no_connection_are_remarks(self):
        strip = [(k, (k + 1) % 5, (k + 2) % 5) for k in range(5)]
        points = [(k, k * k, k ** 3) for k in range(8)]
        status, info = self.check(strip, points=points[:5])
        self.assertEqual((status, info["type"], info["counts"]), (0, "projective plane, 1 hole", {"not_orientable": 1}))
        status, info = self.check(strip + [(5, 6, 7)], points=points)
        self.assertEqual((status, info["type"], info["components"]), (0, None, 2))
        self.assertEqual(len(info["boundary_loops"]), 2)
