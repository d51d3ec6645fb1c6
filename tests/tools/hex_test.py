# SPDX-License-Identifier: GPL-2.0-or-later
"""Hexahedra that fill a solid: what the program says of them, and what is in the files."""
import json
import math
import os
import signal
import subprocess
import time

from running import InFolder, PROGRAM, SLOWER, SOURCE, medit, run, run_json

SIX = ((0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7))
# Of each corner of a hexahedron the three that it is joined to, right-handed.
BESIDE = ((1, 3, 4), (2, 0, 5), (3, 1, 6), (0, 2, 7), (7, 5, 0), (4, 6, 1), (5, 7, 2), (6, 4, 3))


def cubes(places):
    """Points and tetrahedra (from 0) of unit cubes at these places."""
    index, tetrahedra = {}, []
    for x, y, z in places:
        corners = [(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2)) for k in range(8)]
        for p in corners:
            index.setdefault(p, len(index))
        tetrahedra += [[index[corners[v]] for v in t] for t in SIX]
    return [list(map(float, p)) for p in index], tetrahedra


def determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]))


def minus(p, q):
    return [x - y for x, y in zip(p, q)]


class Hex(InFolder):
    def solid(self, name, points, tetrahedra):
        return self.path(name, medit(points, tetrahedra))

    def read(self, path):
        with open(path, encoding="utf-8") as file:
            words = iter(file.read().split())
        points, hexahedra = [], []
        for word in words:
            if word == "Vertices":
                points = [[float(next(words)) for _ in range(4)][:3] for _ in range(int(next(words)))]
            if word == "Hexahedra":
                hexahedra = [[int(next(words)) - 1 for _ in range(9)][:8] for _ in range(int(next(words)))]
        return points, hexahedra

    def least_at_corners(self, points, hexahedra):
        """The least scaled Jacobian at corners, counted here."""
        least = 1.0
        for h in hexahedra:
            for corner, beside in enumerate(BESIDE):
                edges = [minus(points[h[n]], points[h[corner]]) for n in beside]
                least = min(least, determinant(*edges) / math.prod(math.hypot(*e) for e in edges))
        return least

    def test_boxes_are_filled_with_boxes(self):
        """An L of three cubes: planes lie in its sides, so that all angles are right."""
        ell = self.solid("ell.mesh", *cubes([(0, 0, 0), (1, 0, 0), (0, 1, 0)]))
        path = self.path("ell_hex.mesh")
        status, made = run_json("hex", ell, "--edge", "0.25", "-o", path, "-o", self.path("ell.vtu"), "-o", self.path("ell.json"),
                                "-o", self.path("ell.glb"))
        self.assertEqual(status, 0, made)
        # By hand: 3 * 4^3 cells.
        self.assertEqual([made["hexahedra"], made["inverted"], made["below_0.2"], made["ridges"]], [192, 0, 0, 18])
        for name, value in (("min_scaled_jacobian", 1), ("mean_scaled_jacobian", 1), ("volume_ratio", 1), ("hausdorff", 0)):
            self.assertAlmostEqual(made[name], value, delta=1e-9, msg=name)
        points, hexahedra = self.read(path)
        self.assertEqual(len(hexahedra), 192)
        self.assertAlmostEqual(self.least_at_corners(points, hexahedra), 1, delta=1e-9)
        self.assertEqual(sum(made["histogram"]), 192)
        self.assertEqual(len(made["worst"]), 10)

    def test_a_smooth_solid_with_handles(self):
        """Five handles; of the file all is counted again."""
        torus = os.path.join(SOURCE, "tests/data/genus5_smooth.mesh")
        path = self.path("torus.mesh")
        status, made = run_json("hex", torus, "--cells", "1500", "--hausdorff-tolerance", "0.05", "-o", path)
        points, hexahedra = self.read(path)
        self.assertEqual(len(hexahedra), made["hexahedra"])
        least = self.least_at_corners(points, hexahedra)
        self.assertLessEqual(made["min_scaled_jacobian"], least + 1e-6)
        self.assertEqual(made["inverted"] == 0, made["min_scaled_jacobian"] > 0)
        good = made["inverted"] == 0 and abs(made["volume_ratio"] - 1) <= 0.01 and made["hausdorff"] <= 0.05
        self.assertEqual((status, made["doubts"] == []), (0 if good else 4, good))
        self.assertEqual(made["inverted"], 0)
        # Vertices - edges + squares of the surface of genus 5.
        squares = {}
        sides = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
        for h in hexahedra:
            for side in sides:
                square = tuple(h[c] for c in side)
                squares.setdefault(tuple(sorted(square)), []).append(square)
        outer = [found[0] for found in squares.values() if len(found) == 1]
        edges = {tuple(sorted((s[k], s[(k + 1) % 4]))) for s in outer for k in range(4)}
        self.assertEqual(len({v for s in outer for v in s}) - len(edges) + len(outer), -8)

    def test_what_is_beyond_a_tolerance_is_told(self):
        torus = os.path.join(SOURCE, "tests/data/mesh/double_torus.off")
        status, made = run_json("hex", torus, "--cells", "300", "--sharp", "180", "--volume-tolerance", "0",
                                "--hausdorff-tolerance", "1e-9", "--memory", "2", "-o", self.path("torus.vtu"))
        self.assertEqual(status, 4)
        self.assertEqual(made["ridges_of_solid"], 0)
        self.assertIn("the volume is", " ".join(made["doubts"]))
        self.assertIn("of the diagonal away at", " ".join(made["doubts"]))
        # Nothing is good enough: grids get finer, to a third of the first one's edges.
        self.assertEqual(made["ended_by"], "finest")
        self.assertEqual(made["grids"], 3)
        self.assertIn("3 grids tried", made["doubts"][-1])
        self.assertIn("shorter than a third of the first grid's", made["doubts"][-1])
        self.assertTrue(os.path.exists(self.path("torus.vtu")))

    def test_bad_solids(self):
        """Each is refused in a line, and nothing is written."""
        shell = [(x, y, z) for x in range(3) for y in range(3) for z in range(3) if (x, y, z) != (1, 1, 1)]
        one = cubes([(0, 0, 0)])
        for name, mesh, complaint in (("two.mesh", cubes([(0, 0, 0), (3, 0, 0)]), "2 pieces"),
                                      ("cavity.mesh", cubes(shell), "2 components"),
                                      ("pinch.mesh", cubes([(0, 0, 0), (1, 1, 1)]), "vertex"),
                                      ("edge.mesh", cubes([(0, 0, 0), (1, 1, 0)]), "edge")):
            done = run("hex", self.solid(name, *mesh), "-o", self.path("never.vtu"))
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), name + done.stderr)
            self.assertIn(complaint, done.stderr)
            self.assertFalse(os.path.exists(self.path("never.vtu")))
        cube = self.solid("cube.mesh", *one)
        done = run("hex", cube, "--cells", "1000000000")
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"--cells 1000000000: about \d+ GB would be needed, and 4\.0 GB are allowed")
        done = run("hex", cube, "--edge", "1e-200")
        self.assertEqual((done.returncode, "would be needed" in done.stderr), (2, True), done.stderr)
        for arguments, complaint in ((("--edge", "0.1", "--cells", "9"), "exclude"), (("-o", "x.stl"), "no known format"),
                                     (("--edge", "0"), "--edge"), (("--cells", "0"), "--cells")):
            done = run("hex", cube, *arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertIn(complaint, done.stderr)

    def test_a_thin_sheet(self):
        """Where planes can lie in its sides it is filled; slanted it is thinner than cells, and the program says so."""
        points, tetrahedra = cubes([(x, y, 0) for x in range(3) for y in range(3)])
        flat = self.solid("flat.mesh", [[p[0], p[1], 0.01 * p[2]] for p in points], tetrahedra)
        status, made = run_json("hex", flat, "--edge", "0.5", "--component", "0", "--repair", "--weld")
        self.assertEqual((status, made["inverted"]), (0, 0), made)
        slanted = [[p[0], p[1], 0.001 * p[2] + 0.3 * p[0] + 0.2 * p[1]] for p in points]
        status, made = run_json("hex", self.solid("slanted.mesh", slanted, tetrahedra), "--edge", "0.5", "-o", self.path("none.vtu"))
        self.assertEqual((status, made["hexahedra"]), (4, 0))
        self.assertIn("genus 0: parts or gaps of it are thinner than the cells", made["doubts"][0])
        self.assertIn("grids tried", made["doubts"][1])
        self.assertFalse(os.path.exists(self.path("none.vtu")))

    def test_few_tetrahedra(self):
        """A cube of six tetrahedra, turned, so that no plane of the grid lies in its sides."""
        points, tetrahedra = cubes([(0, 0, 0)])
        turned = [[0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2]] for p in points]
        status, made = run_json("hex", self.solid("turned.mesh", turned, tetrahedra), "--cells", "400")
        self.assertEqual((status, made["inverted"], made["ridges"]), (0, 0, 12), made)
        self.assertAlmostEqual(made["volume_ratio"], 1, delta=1e-3)

    def test_one_signal_ends_it(self):
        """In whatever stage it is: within a second of the processor's time; the sanitizers make that several."""
        torus = os.path.join(SOURCE, "tests/data/genus5_smooth.mesh")
        grid, polycube = ["--cells", "40000"], ["--cells", "3000", "--start", "polycube"]
        for number, after, wish in ((signal.SIGINT, 0.2, grid), (signal.SIGTERM, 1, grid), (signal.SIGINT, 2.5, grid),
                                    (signal.SIGTERM, 5, grid), (signal.SIGINT, 0.3, polycube), (signal.SIGTERM, 2, polycube)):
            job = subprocess.Popen([PROGRAM, "hex", torus, *wish, "-o", self.path("never.vtu")],
                                   stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
            while self.seconds(job) < after * SLOWER:
                self.assertIsNone(job.poll())
                time.sleep(0.02)
            before = self.seconds(job)
            job.send_signal(number)
            said = job.stderr.read()
            job.stderr.close()
            _, status, used = os.wait4(job.pid, 0)
            job.returncode = os.waitstatus_to_exitcode(status)
            self.assertEqual((job.returncode, said), (130, b"tetrarch: interrupted; nothing was written\n"))
            self.assertLess(used.ru_utime + used.ru_stime - before, SLOWER, (number, after))
            self.assertFalse(os.path.exists(self.path("never.vtu")))

    @staticmethod
    def seconds(job):
        """Of the processor, so far."""
        with open("/proc/%d/stat" % job.pid, encoding="ascii") as file:
            words = file.read().rpartition(")")[2].split()
        return (int(words[11]) + int(words[12])) / os.sysconf("SC_CLK_TCK")

    def test_a_thin_limb(self):
        """A cube of side 3 with a rod 0.2 thick and 3 long, turned; cells are three times as thick as the rod."""
        places = [(x, y, z) for x in range(3) for y in range(3) for z in range(3)] + [(x, 1, 1) for x in range(3, 6)]
        points, tetrahedra = cubes(places)
        thin = {0: 0, 1: 1.4, 2: 1.6, 3: 3}
        points = [[p[0], thin[p[1]], thin[p[2]]] for p in points]
        turned = [[0.8 * p[0] - 0.6 * p[1], 0.6 * p[0] + 0.8 * p[1], p[2]] for p in points]
        status, made = run_json("hex", self.solid("rod.mesh", turned, tetrahedra), "--edge", "0.6")
        self.assertEqual(made["inverted"], 0)
        # Without the rod it would be 3 over the diagonal.
        self.assertLess(made["hausdorff"], 0.1 * 3 / math.hypot(5.4, 4.6, 3), made)
        self.assertEqual(status == 0, made["doubts"] == [])

    def test_a_polycube_of_a_solid(self):
        """A frame of eight cubes, its outside rounded a little: its polycube, and hexahedra that begin there."""
        places = [(x, y, 0) for x in range(3) for y in range(3) if (x, y) != (1, 1)]
        points, tetrahedra = cubes(places)
        rounded = [[p[0] + 0.1 * math.sin(p[1]), p[1], p[2] + 0.05 * p[0]] for p in points]
        frame = self.solid("frame.mesh", rounded, tetrahedra)
        made_at, polycube_at = self.path("frame_hex.mesh"), self.path("polycube.json")
        status, made = run_json("hex", frame, "--start", "polycube", "--edge", "0.25", "--sharp", "30", "-o", made_at,
                                "--polycube-output", polycube_at)
        self.assertEqual((status, made["doubts"]), (0, []), made)
        # By hand: outside 4 sides, inside 4, top and bottom; 8 corners outside and 8 inside.
        self.assertEqual(made["labels"], {"charts": 10, "corners": 16, "turning_points": 0, "other_faults": 0})
        self.assertEqual((made["flipped"], made["inverted"]), (0, 0))
        points, hexahedra = self.read(made_at)
        self.assertEqual(len(hexahedra), made["hexahedra"])
        self.assertLessEqual(made["min_scaled_jacobian"], self.least_at_corners(points, hexahedra) + 1e-6)
        with open(polycube_at, encoding="utf-8") as file:
            polycube = json.load(file)
        # No tetrahedron is turned over, neither in the solid nor on the polycube; the volume is a number of cubes.
        solid = next(f["values"] for f in polycube["fields"] if f["name"] == "solid")
        for at in (polycube["vertices"], solid):
            volumes = [determinant(*(minus(at[v], at[t[0]]) for v in t[1:])) / 6 for t in polycube["tetrahedra"]]
            self.assertGreater(min(volumes), 0)
        cubes_of_it = sum(determinant(*(minus(polycube["vertices"][v], polycube["vertices"][t[0]]) for v in t[1:])) / 6
                          for t in polycube["tetrahedra"])
        self.assertAlmostEqual(cubes_of_it, round(cubes_of_it), delta=1e-6)
        # Without a layer there is a hexahedron for each; a layer below all of the surface adds some.
        self.assertGreaterEqual(made["hexahedra"], round(cubes_of_it))
        # Triangles with the tag 2 a + 1 lie in a plane across axis a and face along it, those with 2 a + 2 against it.
        for triangle, tag in zip(polycube["triangles"], polycube["triangle_tags"]):
            axis = (tag - 1) // 2
            p, q, r = (polycube["vertices"][v] for v in triangle)
            self.assertEqual([q[axis], r[axis]], [round(p[axis])] * 2)
            b, c = [(axis + 1) % 3, (axis + 2) % 3]
            area = (q[b] - p[b]) * (r[c] - p[c]) - (q[c] - p[c]) * (r[b] - p[b])
            self.assertGreater(area if tag % 2 == 1 else -area, 0)
        done = run("hex", frame, "--polycube-output", self.path("never.json"))
        self.assertEqual((done.returncode, "needs --start polycube" in done.stderr), (2, True), done.stderr)

    def test_a_solid_without_a_polycube(self):
        """A slanted needle of one tetrahedron faces no axis well: what is wrong with its labels is told, with places."""
        points = [[0, 0, 0], [10, 9, 8], [10, 9.5, 8], [10.2, 9, 8.3]]
        status, made = run_json("hex", self.solid("needle.mesh", points, [[0, 1, 2, 3]]), "--start", "polycube", "--cells", "50",
                                "-o", self.path("never.vtu"))
        self.assertEqual((status, made["hexahedra"]), (4, 0))
        self.assertGreater(made["labels"]["other_faults"], 0)
        self.assertRegex(made["doubts"][0], r"^no valid labeling: .* at \(")
        self.assertFalse(os.path.exists(self.path("never.vtu")))
