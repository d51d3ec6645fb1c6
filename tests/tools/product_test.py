# SPDX-License-Identifier: GPL-2.0-or-later
"""Coordinates of a handlebody in a domain times an interval, and hexahedra by them. Part of program_test.py."""
import json
import math
import os

from running import InFolder, medit, run, run_json, SOURCE


class Product(InFolder):
    def setUp(self):
        super().setUp()
        self.ridges = os.path.join(SOURCE, "tests/data/genus4_ridges.mesh")
        self.smooth = os.path.join(SOURCE, "tests/data/genus5_smooth.mesh")

    def refused(self, *arguments):
        """The one line on standard error of a command that must fail with 2 and write nothing."""
        before = sorted(os.listdir(self.folder.name))
        done = run("product", *arguments, "-o", self.path("never.vtu"))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual((done.stderr.count("\n"), done.stdout), (1, ""), done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder.name)), before)
        return done.stderr

    def write(self, name, points, tetrahedra):
        return self.path(name, medit(points, tetrahedra))

    def read(self, path):
        """Points, tetrahedra and labelled triangles of a MEDIT file."""
        with open(path, encoding="utf-8") as file:
            words = iter(file.read().split())
        found = {}
        for word in words:
            if word in ("Vertices", "Triangles", "Tetrahedra", "Hexahedra"):
                width = {"Vertices": 4, "Triangles": 4, "Tetrahedra": 5, "Hexahedra": 9}[word]
                number = float if word == "Vertices" else int
                found[word] = [[number(next(words)) for _ in range(width)] for _ in range(int(next(words)))]
        return found

    def test_labels_and_no_help_agree_between_ridges(self):
        status, labelled = run_json("product", self.ridges, "--labels", "1,2")
        self.assertEqual(status, 0)
        _, found = run_json("product", self.ridges)
        sizes = [{k: v for k, v in made["partition"].items() if k in ("floor", "ceiling", "walls")} for made in (labelled, found)]
        # Which of two equal plates is the floor nobody has said.
        self.assertEqual(sizes[0], sizes[1])
        for made in (labelled, found):
            self.assertEqual((made["holes"], made["stuck_fibers"], made["floor_flipped"]), (4, 0, 0))
            self.assertEqual(made["critical"], {"flat_tetrahedra": [], "vertices": []})
            self.assertLess(made["opposite_way"]["max_distance"], 0.05)
            self.assertEqual(made["opposite_way"]["not_arrived"], 0)

    def test_a_smooth_solid_without_help(self):
        status, made = run_json("product", self.smooth)
        self.assertEqual((made["holes"], made["stuck_fibers"]), (5, 0))
        self.assertEqual(made["critical"], {"flat_tetrahedra": [], "vertices": []})
        # A field without critical points is not yet a map without folds: what is flipped is counted, named, and no product.
        self.assertGreater(made["flipped"], 0)
        self.assertEqual(status, 4)
        self.assertEqual(made["product"]["verdict"], "undecided")
        self.assertIn("%d tetrahedra flipped" % made["flipped"], made["product"]["doubts"])
        self.assertEqual(len(made["flipped_tetrahedra"]), made["flipped"])
        self.assertEqual(len({t["tetrahedron"] for t in made["flipped_tetrahedra"]}), made["flipped"])

    def test_flipped_tetrahedra_are_those_of_the_file(self):
        path = self.path("out.json")
        status, made = run_json("product", self.smooth, "-o", path)
        self.assertEqual(status, 4)
        with open(path, encoding="utf-8") as file:
            written = json.load(file)
        uvw = next(f["values"] for f in written["fields"] if f["name"] == "uvw")

        def volume(p):
            e = [[p[k][i] - p[0][i] for i in range(3)] for k in (1, 2, 3)]
            return (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0])
                    + e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]))

        sizes = [volume([uvw[v] for v in t]) for t in written["tetrahedra"]]
        flipped = {t["tetrahedron"] for t in made["flipped_tetrahedra"]}
        for t, size in enumerate(sizes):
            if abs(size) > 1e-15:
                self.assertEqual(size < 0, t in flipped)

    def test_hexahedra_of_another_solid_are_no_success(self):
        # A comb: a bar of 8 x 1 x 1 with four teeth of 1 x 1 x 2, which no rectangle's grid gets into: 16 by hand.
        cells = {(x, 0, 0) for x in range(8)} | {(x, y, 0) for x in (0, 2, 4, 6) for y in (1, 2)}
        index, points, tetrahedra = {}, [], []
        six = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]]
        for x, y, z in sorted((2 * x + i, 2 * y + j, 2 * z + k) for x, y, z in cells for i in (0, 1) for j in (0, 1) for k in (0, 1)):
            corner = [(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2)) for k in range(8)]
            for p in corner:
                if p not in index:
                    index[p] = len(points)
                    points.append([c / 2 for c in p])
            tetrahedra += [[index[corner[v]] for v in t] for t in six]
        comb = self.write("comb.mesh", points, tetrahedra)
        path = self.path("hex.mesh")
        status, made = run_json("product", comb, "--hex", "10", "-o", path)
        self.assertAlmostEqual(made["volume"]["solid"], 16, delta=1e-9)
        error = abs(made["volume"]["hexahedra"] - 16) / 16
        self.assertAlmostEqual(made["volume"]["relative_error"], error, delta=1e-9)
        self.assertEqual(len(self.read(path)["Hexahedra"]), made["hexahedra"])
        if error > 0.02 or made["inverted"] or made["flipped"]:
            self.assertEqual(status, 4)
        self.assertEqual(made["filling"]["verdict"] == "undecided", error > 0.02 or made["inverted"] > 0)

    def test_the_tolerance_of_volumes(self):
        status, made = run_json("product", self.ridges, "--labels", "1,2", "--hex", "20")
        error = made["volume"]["relative_error"]
        self.assertEqual((status, made["filling"]), (0, {"verdict": "yes", "doubts": []}))
        status, made = run_json("product", self.ridges, "--labels", "1,2", "--hex", "20", "--volume-tolerance", repr(0.9 * error))
        self.assertEqual((status, made["filling"]["verdict"], made["product"]["verdict"]), (4, "undecided", "yes"))
        self.assertIn("the volume is", made["filling"]["doubts"][0])
        self.assertEqual([len(made["worst"]), made["worst"][0]["scaled_jacobian"]], [10, made["min_scaled_jacobian"]])

    def test_hexahedra(self):
        path = self.path("hex.mesh")
        status, made = run_json("product", self.ridges, "--labels", "1,2", "--hex", "20", "-o", path, "-o", self.path("hex.vtu"), "-o", self.path("hex.glb"))
        self.assertEqual(status, 0)
        self.assertEqual(made["hexahedra"], made["grid"]["cells"] * (made["hexahedra"] // made["grid"]["cells"]))
        self.assertGreater(made["min_scaled_jacobian"], 0)
        self.assertEqual(sum(made["histogram"]["counts"]), made["hexahedra"])
        written = self.read(path)
        self.assertEqual(len(written["Hexahedra"]), made["hexahedra"])
        # The hexahedra fill the plate: by hand, 0.8 times the plan's area (an L of 12 less 1/8, less two octagonal
        # approximations of disks of radius 0.45, a square of 0.6 and a hexagon of side 0.4, all cut by the grid).
        volume = 0.0
        for *corners, _ in written["Hexahedra"]:
            p = [written["Vertices"][v - 1][:3] for v in corners]
            for a, b, c, d in ((0, 1, 2, 6), (0, 2, 3, 6), (0, 3, 7, 6), (0, 7, 4, 6), (0, 4, 5, 6), (0, 5, 1, 6)):
                e = [[p[k][i] - p[a][i] for i in range(3)] for k in (b, c, d)]
                volume += (e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) - e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0])
                           + e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0])) / 6
        plan = 12 - 0.125 - 2 * math.pi * 0.45 ** 2 - 0.36 - 1.5 * math.sqrt(3) * 0.16
        self.assertAlmostEqual(volume, 0.8 * plan, delta=0.03 * plan)
        _, smoothed = run_json("product", self.ridges, "--labels", "1,2", "--hex", "20", "--smooth")
        self.assertGreaterEqual(smoothed["min_scaled_jacobian"], made["min_scaled_jacobian"])
        self.assertNotIn("untangling", smoothed)  # nothing to untangle
        _, tangled = run_json("product", self.smooth, "--hex", "16", "--layers", "2", "--smooth")
        untangling = tangled["untangling"]
        self.assertGreater(untangling["bad_before"], 0)
        self.assertLessEqual(untangling["bad_after"], untangling["bad_before"])
        self.assertLessEqual(tangled["inverted"], untangling["bad_after"])
        self.assertGreaterEqual(tangled["min_scaled_jacobian"], untangling["min_scaled_jacobian_before"])

    def test_what_is_written_is_read_again(self):
        path = self.path("labels.mesh")
        _, made = run_json("product", self.ridges, "-o", path)
        labels = [t[3] for t in self.read(path)["Triangles"]]
        counts = [labels.count(k) for k in range(1, 8)]
        self.assertEqual(counts, [made["partition"]["floor"], made["partition"]["ceiling"], *made["partition"]["walls"]])
        _, again = run_json("product", path, "--labels", "1,2")
        self.assertEqual([again[k] for k in ("height", "flipped", "orthogonality_error")],
                         [made[k] for k in ("height", "flipped", "orthogonality_error")])

    def test_pictures(self):
        names = {e: self.path("product." + e) for e in ("vtu", "glb", "ply", "obj", "html")}
        done = run("product", self.ridges, *(a for path in names.values() for a in ("-o", path)))
        self.assertEqual(done.returncode, 0, done.stderr)
        for path in names.values():
            self.assertGreater(os.path.getsize(path), 10_000)
        with open(names["vtu"], "rb") as file:
            text = file.read()
        for word in (b'"w"', b'"patch"', b'"texture"', b'"fiber"'):
            self.assertIn(word, text)
        again = self.path("again.glb")
        run("product", self.ridges, "-o", again, "--threads", "1")
        with open(names["glb"], "rb") as one, open(again, "rb") as two:
            self.assertEqual(one.read(), two.read())

    def test_bad_solids(self):
        cube = [[x, y, z] for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)]
        six = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]]
        inverted = [six[0][:2] + [six[0][3], six[0][2]]] + six[1:]
        self.assertIn("inverted", self.refused(self.write("inverted.mesh", cube, inverted)))
        flat = [p[:2] + [0.0] for p in cube]
        self.assertIn("flat", self.refused(self.write("flat.mesh", flat, six)))
        # Two cubes apart, and two that share a vertex only.
        apart = cube + [[p[0] + 5, p[1], p[2]] for p in cube]
        self.assertIn("2 pieces", self.refused(self.write("apart.mesh", apart, six + [[v + 8 for v in t] for t in six])))
        # A shell: 26 of 27 cubes.
        grid = [[float(x), float(y), float(z)] for z in range(4) for y in range(4) for x in range(4)]
        shell = []
        for x, y, z in ((x, y, z) for x in range(3) for y in range(3) for z in range(3) if (x, y, z) != (1, 1, 1)):
            corner = [(x + (k & 1)) + 4 * (y + (k >> 1 & 1)) + 16 * (z + (k >> 2)) for k in range(8)]
            shell += [[corner[v] for v in t] for t in six]
        self.assertIn("boundary of the solid has 2 components", self.refused(self.write("shell.mesh", grid, shell)))

    def test_a_polycube(self):
        # A frame of eight cubes around one that is missing, twice as high as it should be, and its image: the cubes.
        cube = [(x, y) for x in range(3) for y in range(3) if (x, y) != (1, 1)]
        n = 2
        index, points, tetrahedra = {}, [], []
        six = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]]
        for x, y, z in ((x, y, z) for x in range(3 * n) for y in range(3 * n) for z in range(n) if (x // n, y // n) in cube):
            corner = [(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2)) for k in range(8)]
            for p in corner:
                if p not in index:
                    index[p] = len(points)
                    points.append([p[0] / n, p[1] / n, p[2] / n])
            tetrahedra += [[index[corner[v]] for v in t] for t in six]
        image = self.write("cubes.mesh", points, tetrahedra)
        frame = self.write("frame.mesh", [[x, y, 2 * z] for x, y, z in points], tetrahedra)
        seeds = ["--floor", "v%d" % index[(1, 1, 0)], "--ceiling", "v%d" % index[(1, 1, n)]]
        path = self.path("hex.mesh")
        status, made = run_json("product", frame, *seeds, "--polycube", image, "--cells", "3", "-o", path)
        # By hand: 8 cubes of 27 cells; stretched cuboids have right angles.
        self.assertEqual((status, made["hexahedra"], made["left_out"]), (0, 216, 0))
        self.assertGreater(made["min_scaled_jacobian"], 1 - 1e-6)
        self.assertEqual(len(self.read(path)["Hexahedra"]), 216)
        self.assertIn("one of them", self.refused(frame, *seeds, "--polycube", image, "--hex", "4"))
        self.assertIn("no image of vertex", self.refused(frame, *seeds, "--polycube", os.path.join(SOURCE, "tests/data/mesh/cube.off")))
        self.assertNotEqual(self.refused(frame, *seeds, "--polycube", frame, "--step", "0.7"), "")

    def test_a_solid_that_is_its_own_polycube(self):
        # Seven of the eight cubes of a block, six tetrahedra each. Nobody says what is floor.
        six = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]]
        points = [[float(x), float(y), float(z)] for z in range(3) for y in range(3) for x in range(3)]
        cubes = [(x, y, z) for z in range(2) for y in range(2) for x in range(2) if (x, y, z) != (0, 0, 1)]
        tetrahedra = [[(x + (t & 1)) + 3 * (y + (t >> 1 & 1)) + 9 * (z + (t >> 2)) for t in tet] for x, y, z in cubes for tet in six]
        seven = self.write("seven.mesh", points, tetrahedra)  # with a point that belongs to nothing: (0, 0, 2)
        path = self.path("hex.mesh")
        status, made = run_json("product", seven, "--polycube", seven, "--cells", "2", "-o", path)
        self.assertEqual((status, made["hexahedra"], made["inverted"], made["left_out"]), (0, 56, 0, 0))
        self.assertEqual((made["min_scaled_jacobian"], made["mean_scaled_jacobian"]), (1, 1))
        self.assertEqual(made["volume"], {"hexahedra": 7, "solid": 7, "relative_error": 0})
        written = self.read(path)
        self.assertEqual(sorted(p[:3] for p in written["Vertices"]),
                         sorted([x / 2, y / 2, z / 2] for x in range(5) for y in range(5) for z in range(5) if not (x < 2 and y < 2 and z > 2)))
        # Images inside that fold the map are passed over: (1, 1, 1) is the only point inside of the whole block.
        block = self.write("block.mesh", points, [[(x + (t & 1)) + 3 * (y + (t >> 1 & 1)) + 9 * (z + (t >> 2)) for t in tet]
                                                  for z in range(2) for y in range(2) for x in range(2) for tet in six])
        for far in (7.0, 1e300):
            points[13] = [far, 1.0, 1.0]
            wild = self.write("wild.mesh", points, tetrahedra)
            status, made = run_json("product", block, "--polycube", wild, "--cells", "2")
            self.assertEqual((status, made["hexahedra"], made["carried_by"]), (0, 64, "a harmonic map"))
            self.assertGreater(made["min_scaled_jacobian"], 1 - 1e-9)
        for far in (math.inf, math.nan):
            points[13] = [far, 1.0, 1.0]
            self.assertIn("finite", self.refused(block, "--polycube", self.write("nowhere.mesh", points, tetrahedra)))

    def test_a_point_that_belongs_to_nothing(self):
        n = 3
        points = [[x / n, y / n, z / n] for z in range(n + 1) for y in range(n + 1) for x in range(n + 1)]
        six = [[0, 1, 3, 7], [0, 3, 2, 7], [0, 2, 6, 7], [0, 6, 4, 7], [0, 4, 5, 7], [0, 5, 1, 7]]
        tetrahedra = [[(x + (t & 1)) + (n + 1) * (y + (t >> 1 & 1)) + (n + 1) ** 2 * (z + (t >> 2)) for t in tet]
                      for z in range(n) for y in range(n) for x in range(n) for tet in six]
        results = []
        for name, more in (("cube.mesh", []), ("orphan.mesh", [[0.1, 0.2, 0.3]])):
            status, made = run_json("product", self.write(name, points + more, tetrahedra), "--hex", "4")
            self.assertEqual((status, made["product"]["verdict"]), (0, "yes"))
            results.append({k: v for k, v in made.items() if k not in ("seconds", "input")})
        self.assertEqual(*results)

    def test_bad_partitions(self):
        self.assertIn("label 9", self.refused(self.ridges, "--labels", "1,9"))
        # Floor and hole's wall: they touch.
        self.assertNotEqual(self.refused(self.ridges, "--labels", "1,3"), "")
        self.assertIn("v99999", self.refused(self.ridges, "--floor", "v99999", "--ceiling", "v2"))
        self.assertIn("--floor and --ceiling", self.refused(self.ridges, "--floor", "v1"))
        self.assertIn("--labels", self.refused(self.ridges, "--labels", "1"))
        self.assertIn("no triangles with labels", self.refused(self.smooth, "--labels", "1,2"))

    def test_bad_options(self):
        self.assertIn("--layers", self.refused(self.ridges, "--layers", "3"))
        self.assertIn("--corners", self.refused(self.ridges, "--corners", "1,2,3,4"))
        self.assertIn("four vertices", self.refused(self.ridges, "--floor-map", "rectangle", "--corners", "1,2,3"))
        self.assertIn("extension", self.refused(self.ridges, "-o", self.path("never.tri")))
