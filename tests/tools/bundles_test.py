# SPDX-License-Identifier: GPL-2.0-or-later
"""Circle bundles over surfaces, and one surface laid on another. Part of program_test.py."""
import json
import math
import os

from running import InFolder, run, run_json, SOURCE


class Bundle(InFolder):
    def surface(self, name):
        return os.path.join(SOURCE, "tests/data/mesh", name)

    def refused(self, *arguments):
        """The one line on standard error of a command that must fail with 2 and write nothing."""
        before = sorted(os.listdir(self.folder.name))
        done = run("bundle", *arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder.name)), before)
        return done.stderr

    def test_sphere_torus_and_genus_two(self):
        # H1 of the unit tangent bundle of genus g: Z^2g + Z/(2g-2); Z/2 for the sphere, Z^3 for the torus.
        for name, homology, euler, along in (("cube.off", "Z/2", 2, "an equator"), ("torus.off", "Z^3", 0, "canonical loops"),
                                             ("double_torus.off", "Z^4 + Z/2", -2, "canonical loops")):
            _, made = run_json("bundle", self.surface(name), "--fiber", "4")
            self.assertEqual((made["homology"], made["euler_number"], made["fiber"], made["closed"]), (homology, euler, 4, True))
            self.assertEqual((made["boundary"], made["cut"]["along"]), ([], along))
            self.assertEqual(made["field"]["index_sum"], euler)
            self.assertEqual(made["section"]["index_sum"], euler)
            self.assertEqual(made["tetrahedra"], 3 * 4 * made["refined"]["triangles"])

    def test_a_projected_field(self):
        # Along a plate with two holes the long way: few singular triangles, unlike a random field's.
        _, made = run_json("bundle", self.surface("double_torus.off"), "--fiber", "2", "--field", "0.9", "0.2", "0.3")
        self.assertEqual(made["field"]["index_sum"], -2)
        self.assertLess(made["field"]["singular_triangles"], 20)
        self.assertIn("--field", self.refused(self.surface("cube.off"), "--field", "1", "2"))

    def test_other_euler_numbers(self):
        for name, euler, homology in (("cube.off", 5, "Z/5"), ("cube.off", 1, "0"), ("torus.off", 3, "Z^2 + Z/3"), ("double_torus.off", 0, "Z^5")):
            for cut in ("dissertation", "any"):
                _, made = run_json("bundle", self.surface(name), "--fiber", "3", "--euler", str(euler), "--cut", cut)
                self.assertEqual((made["homology"], made["euler_number"]), (homology, euler))
        _, made = run_json("bundle", self.surface("torus.off"), "--fiber", "3", "--twist", "-6")
        self.assertEqual(made["euler_number"], -2)

    def test_what_is_written_is_read_again(self):
        triangulation, mesh, bands, tori, shown = (self.path(n) for n in ("b.json", "b.vtu", "b.svg", "b.glb", "s.ply"))
        done = run("bundle", self.surface("torus.off"), "--fiber", "3", "-o", triangulation, "-o", mesh, "-o", bands, "-o", tori)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(run_json("info", triangulation)[1]["homology"], "Z^3")
        # The mesh is the bundle cut open: a solid torus.
        _, solid = run_json("info", mesh)
        self.assertEqual((solid["tetrahedra"], solid["homology"], len(solid["boundary"])), (432, "Z", 1))
        with open(bands, encoding="utf-8") as file:
            self.assertIn("<svg", file.read())
        with open(tori, "rb") as file:
            self.assertEqual(file.read(4), b"glTF")
        done = run("bundle", self.surface("torus.off"), "--show", "surface", "-o", shown)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_a_disk_with_and_without_solution(self):
        # By hand: two triangles have no vertex inside, so four equal values have no solution.
        square = self.path("square.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n")
        good = self.path("good.txt", "# an edge a line\n0 1 +1\n1 2 1\n2 3 +1\n0 3 +1\n")
        _, made = run_json("bundle", square, "--fiber", "5", "--boundary", good)
        self.assertEqual((made["homology"], made["closed"], made["euler_number"]), ("Z", False, None))
        self.assertEqual(made["boundary"][0]["genus"], 1)
        bad, part = self.path("bad.txt", "0 1 +1\n1 2 +1\n2 3 +1\n3 0 +1\n"), self.path("part.off")
        done = run("bundle", square, "--boundary", bad, "--obstruction", part, "-o", self.path("never.json"), "--json")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertEqual(json.loads(done.stdout)["obstruction"], {"triangles": [0, 1], "forbidding": 1})
        self.assertFalse(os.path.exists(self.path("never.json")))
        self.assertEqual(run_json("check", part)[1]["fatal"], 0)
        for text, complaint in (("0 1 1\n1 2 1\n2 3 1\n", "vertices 3 and 0 has no value"), ("0 1 2\n", "1: found '2', expected a value"),
                                ("0 1 1\n0 2 1\n", "2: the edge on vertices 0 and 2 is no boundary edge"),
                                ("0 1 1\n1 0 1\n", "2: the edge on vertices 1 and 0 has a value already"), ("0 1 x", "found 'x'"),
                                ("0 one 1\n", "found 'one'"), ("0 1", "the text ends")):
            self.assertIn(complaint, self.refused(square, "--boundary", self.path("b.txt", text)))

    def test_bad_input(self):
        cube, torus = self.surface("cube.off"), self.surface("torus.off")
        self.assertIn("least that works", run("bundle", "--help").stdout)
        self.assertIn("expected 1 to", self.refused(cube, "--fiber", "0"))
        self.assertIn("multiple of the fiber's 4 edges", self.refused(torus, "--fiber", "4", "--twist", "6"))
        self.assertIn("{dissertation,any}", self.refused(cube, "--cut", "some"))
        self.assertIn("closed", self.refused(cube, "--boundary", self.path("b.txt", "")))
        self.assertIn("are allowed (--memory)", self.refused(cube, "--fiber", "1000000"))
        self.assertIn("no such folder", self.refused(cube, "-o", "/nowhere/b.json"))
        self.assertIn("extension", self.refused(cube, "-o", self.path("b.xyz")))
        self.assertIn("Euler number", self.refused(self.path("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "--euler", "1"))
        fan = "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n3 0 1 2\n3 0 1 3\n3 0 1 4\n"
        self.assertIn("edge", self.refused(self.path("fan.off", fan)))
        two = "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n3 3 4 5\n"
        self.assertIn("2 components", self.refused(self.path("two.off", two)))
        self.assertIn("no triangles", self.refused(self.path("none.off", "OFF\n1 0 0\n0 0 0\n")))

    def test_a_surface_without_orientation(self):
        # RP^2 with six vertices; its unit tangent bundle is L(4,1), as Regina names it.
        triangles = ((0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5), (0, 5, 1), (1, 2, 4), (2, 3, 5), (3, 4, 1), (4, 5, 2), (5, 1, 3))
        text = "OFF\n6 10 0\n" + "".join("%d %d %d\n" % (i, i * i, i ** 3) for i in range(6))
        text += "".join("3 %d %d %d\n" % t for t in triangles)
        _, made = run_json("bundle", self.path("rp2.off", text), "--fiber", "3")
        self.assertEqual((made["homology"], made["euler_number"], made["surface"]["type"]), ("Z/4", 1, "projective plane"))


class Register(InFolder):
    def test_a_surface_with_itself_moved(self):
        ring = os.path.join(SOURCE, "tests/data/mesh/ring_two_holes.off")
        with open(ring, encoding="utf-8") as file:
            lines = file.read().splitlines()
        vertices = int(lines[1].split()[0])
        points = [[float(x) for x in line.split()] for line in lines[2:2 + vertices]]
        moved = [[5 - y, x, z + 1] for x, y, z in points]
        text = [" ".join(repr(x) for x in p) for p in moved]
        other = self.path("moved.off", "\n".join(lines[:2] + text + lines[2 + vertices:]) + "\n")
        resampled, average = self.path("resampled.obj"), self.path("average.obj")
        code, made = run_json("register", ring, other, "-o", resampled, "--average", average)
        self.assertEqual((code, made["matching"], made["flipped"]), (0, [0, 1, 2], 0))
        self.assertLess(made["max_distance"], 1e-9)
        self.assertAlmostEqual(made["mean_quasiconformal"], 1, delta=1e-6)
        for path, expected in ((resampled, moved), (average, points)):
            with open(path, encoding="utf-8") as file:
                found = [[float(x) for x in line.split()[1:]] for line in file if line.startswith("v ")]
            self.assertLess(max(math.dist(p, q) for p, q in zip(found, expected)), 1e-9)
            self.assertEqual(len(found), vertices)

    def test_bad_input(self):
        ring = os.path.join(SOURCE, "tests/data/mesh/ring_two_holes.off")
        torus = os.path.join(SOURCE, "tests/data/mesh/torus.off")
        for other, options, complaint in ((torus, [], "has 0 boundary loops"), (ring, ["--match", "0,1"], "for each"),
                                          (ring, ["--match", "0,1,1"], ""), (ring, ["--match", "0,1,x"], "expected the number"),
                                          (ring, ["--inner", "0"], "differ"), (ring, ["-o", self.path("a.stl")], "extension")):
            done = run("register", ring, other, *options)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), done.stderr)
            self.assertIn(complaint, done.stderr)
