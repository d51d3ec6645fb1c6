# SPDX-License-Identifier: GPL-2.0-or-later
"""Diagrams, exteriors and drilling, as typed."""
import json
import math
import os
import xml.etree.ElementTree
import unittest

from running import InFolder, SOURCE, run, run_json

FIGURE_EIGHT = "braid 1 -2 1 -2"


class Exteriors(InFolder):
    def test_the_figure_eight_knot_is_m004(self):
        status, x = run_json("exterior", FIGURE_EIGHT)
        self.assertEqual(status, 0)
        self.assertEqual((x["signature"], x["homology"], x["crossings"], x["components"]), ("cPcbbbiht", "Z", 4, 1))
        self.assertEqual([b["genus"] for b in x["boundary"]], [1])
        self.assertEqual(len(x["meridians"]), 1)
        self.assertIn(x["meridians"][0], x["wirtinger"]["generators"])
        self.assertEqual(len(x["wirtinger"]["relators"]), 4)

    def test_handlebody_knots(self):
        # Volumes and the table: tests/data/handlebody_knots.txt.
        with open(os.path.join(SOURCE, "tests/data/handlebody_knots.txt"), encoding="utf-8") as file:
            lines = [line.strip().split("|") for line in file if not line.startswith("#")]
        for name, code, volume in lines:
            if volume == "-":
                continue
            with self.subTest(name):
                path = self.path("graph.pd", code + "\n")
                output = self.path("exterior.json")
                status, x = run_json("exterior", path, "-o", output)
                self.assertEqual((status, x["homology"], len(x["meridians"])), (0, "Z^2", 3))
                self.assertAlmostEqual(run_json("hyperbolize", output)[1]["volume"], float(volume), delta=1e-11)
                self.assertAlmostEqual(run_json("hyperbolize", path)[1]["volume"], float(volume), delta=1e-11)

    def test_a_code_stands_where_a_triangulation_does(self):
        self.assertEqual(run_json("census", "identify", FIGURE_EIGHT)[1]["name"], "figure-eight knot complement (m004)")
        self.assertEqual(run_json("isometric", FIGURE_EIGHT, "m004")[1]["isometric"], True)
        self.assertEqual(run_json("info", FIGURE_EIGHT)[1]["homology"], "Z")
        done = run("info", "-", stdin="PD[X[1, 4, 2, 5], X[3, 6, 4, 1], X[5, 2, 6, 3]]\n")
        self.assertIn("torus (ideal)", done.stdout)

    def test_trees_are_filled_in_and_said(self):
        done = run("exterior", "V[1, 2, 3] V[1] V[2] V[3]", "--json")
        self.assertEqual(json.loads(done.stdout)["filled_spheres"], 1)
        self.assertNotIn("filled_spheres", run_json("exterior", FIGURE_EIGHT)[1])
        self.assertIn("filled in again", run("exterior", "V[1, 2, 3] V[1] V[2] V[3]").stderr)
        self.assertIn("filled in again", run("drill", "fvPQccdedeegovcfb", "0").stderr)
        self.assertEqual(run_json("drill", "fvPQccdedeegovcfb", "0")[1]["filled_spheres"], 1)

    def test_knots_by_name(self):
        self.assertEqual(run_json("exterior", "4_1")[1]["signature"], "cPcbbbiht")
        self.assertAlmostEqual(run_json("hyperbolize", "5_2")[1]["volume"], 2.828122088330, delta=1e-11)
        self.assertEqual(run_json("diagram", "10_165")[1]["components"], 1)
        self.assertEqual(run("exterior", "10_166").returncode, 2)

    def test_links_and_graphs_by_name(self):
        self.assertEqual(run_json("diagram", "L6a4")[1]["components"], 3)
        self.assertEqual(run_json("census", "identify", "hk5_3")[1]["name"], "fmp2_8")
        self.assertIn("graphs hk5_3, theta5_1", run("census", "identify", "fmp2_8").stdout)
        # 5_1 and 6_4: one exterior, without a structure.
        for name in "hk5_1", "hk6_4":
            found = run_json("census", "identify", name)[1]
            self.assertEqual((found["name"], found["by"]), ("exterior of hk5_1, hk6_4, theta6_11, theta6_15, handcuff6_2", "triangulation"))
        self.assertEqual(run("exterior", "hk7_1").returncode, 2)

    def test_pairs(self):
        status, found = run_json("isometric", "hk5_3", "hk5_3", "--pair")
        self.assertEqual((status, found["equivalent"], found["proof"], found["extending"]), (0, True, "isometry", 6))
        self.assertEqual((found["keeps_orientation"], found["reverses_orientation"]), (True, False))
        self.assertEqual((found["x"]["group"], found["x"]["amphichiral"]), ("D3", False))
        status, found = run_json("isometric", "hk6_6", "hk6_7", "--pair")
        self.assertEqual((status, found["equivalent"], found["proof"]), (1, False, "volume"))
        self.assertTrue(found["x"]["amphichiral"] and found["y"]["amphichiral"])
        status, found = run_json("isometric", "hk5_1", "hk6_4", "--pair")
        self.assertEqual((status, found["equivalent"], found["proof"]), (1, False, "images"))
        self.assertTrue(found["exteriors_homeomorphic"])
        # The unknot with its braid axis, and twisted once along that.
        status, found = run_json("isometric", "braid 1 -2 3 2 1 1 2 3", "braid 1 -2 1 2 1 2 1 2 3 2 1 1 2 3", "--pair")
        self.assertEqual((status, found["equivalent"], found["proof"], found["extending"]), (1, False, "meridians", 0))
        self.assertTrue(found["exteriors_homeomorphic"])
        self.assertEqual(run("isometric", "4_1", "V[1, 2, 3] V[1] V[2] V[3]", "--pair").returncode, 2)
        self.assertIn("equivalent", run("isometric", "4_1", "4_1", "--pair").stdout)

    def test_mirror_and_seed(self):
        for more in (("--mirror",), ("--seed", "5")):
            self.assertEqual(run_json("exterior", FIGURE_EIGHT, *more)[1]["signature"], "cPcbbbiht")

    def test_a_curve(self):
        points = ((math.tau * k / 60 for k in range(60)))
        text = "".join(f"{(2 + math.cos(2 * t)) * math.cos(3 * t)} {(2 + math.cos(2 * t)) * math.sin(3 * t)} {math.sin(4 * t)}\n"
                       for t in points)
        path = self.path("curve.xyz", text)
        for seed in "1", "2", "3":
            self.assertEqual(run_json("exterior", path, "--seed", seed)[1]["signature"], "cPcbbbiht")

    def test_parabolic_meridians(self):
        # Twice a regular ideal octahedron, as Orb has it; a link's meridians are parabolic in its own structure.
        k4 = "V[1, 3, 2] V[4, 5, 1] V[2, 6, 4] V[3, 5, 6]"
        status, x = run_json("exterior", k4, "--parabolic")
        self.assertEqual((status, x["homology"]), (0, "Z^3"))
        self.assertAlmostEqual(x["parabolic_volume"], 7.327724753418, delta=1e-11)
        status, x = run_json("exterior", k4, "--double", "--parabolic")
        self.assertEqual((status, [b["genus"] for b in x["boundary"]]), (0, [1] * 6))
        self.assertAlmostEqual(x["parabolic_volume"], 7.327724753418, delta=1e-11)
        self.assertAlmostEqual(run_json("exterior", FIGURE_EIGHT, "--parabolic")[1]["parabolic_volume"], 2.029883212819,
                               delta=1e-11)
        self.assertEqual(run_json("exterior", "braid 1 1 1", "--parabolic")[0], 4)
        self.assertIn("no vertex", run("exterior", FIGURE_EIGHT, "--double").stderr)

    def test_bad_input(self):
        for code, words in (("braid 1 x", "found 'x'"), ("PD[X[1,2,3,4]]", "arc 1 has 1 end"),
                            ("[[1,2,3,4],[1,2,3,4]]", "genus 1"), ("no such thing", "no code of a diagram"),
                            ("DT[4, 6, 3]", "found 3"), ("Gauss[1,2,-1,-2]", "no plane diagram")):
            done = run("exterior", code)
            self.assertEqual((done.returncode, done.stdout), (2, ""), code)
            self.assertIn(words, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
        bow = self.path("bow.xyz", "0 0 0\n1 1 0\n1 0 0\n0 1 0\n")
        self.assertIn("meet", run("exterior", bow).stderr)
        self.assertIn("line", json.loads(run("exterior", self.path("bad", "braid 1\n2 y\n"), "--json").stderr)["error"])


def orb_file(orders, points, segments, crossings, drilled=0):
    """A file as Orb writes it: the complete graph on four vertices, its first curves with these orders, and a drawing."""
    cycles = ("1wx  2wu", "1vx  2wx", "1vw  2ux", "1ux  2wv", "1uw  2uv", "1uv  2xv")
    lines = [f"  {k + 1}  {k + 1 if k < len(orders) else 0} {orders[k] if k < len(orders) else 1}  {cycle}"
             for k, cycle in enumerate(cycles)]
    drawing = [f"{len(points)}", *(f"{k}\t{x}\t{y}" for k, (x, y) in enumerate(points)), "",
               f"{len(segments)}", *(f"{k}\t{a}\t{b}\t{drilled}" for k, (a, b) in enumerate(segments)), "",
               f"{len(crossings)}", *(f"{k}\t0\t0\t{a}\t{b}\t{u}\t{v}" for k, (a, b, u, v) in enumerate(crossings))]
    return "\n".join(("% orb", "own", "SolutionType geometric_solution", "", *lines, "", "  1  -1.0  1.0  1.0", "",
                      *drawing, ""))


def crossings_of(polygon):
    """Of a closed polygon in space, seen from far up the third axis."""
    n = len(polygon)
    found = []
    for s in range(n):
        for t in range(s + 2, n - (s == 0)):
            a, b, c, d = polygon[s], polygon[(s + 1) % n], polygon[t], polygon[(t + 1) % n]
            det = (b[0] - a[0]) * (d[1] - c[1]) - (b[1] - a[1]) * (d[0] - c[0])
            if det == 0:
                continue
            u = ((c[0] - a[0]) * (d[1] - c[1]) - (c[1] - a[1]) * (d[0] - c[0])) / det
            v = ((c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])) / det
            if 0 <= u <= 1 and 0 <= v <= 1:
                above = a[2] + u * (b[2] - a[2]) > c[2] + v * (d[2] - c[2])
                found.append((s, t, u, v) if above else (t, s, v, u))
    return found


class OrbDrawings(InFolder):
    K4 = ([(0, 0), (100, 60), (-100, 60), (0, -90)], [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)], [])

    def test_a_drawing_has_the_structure_of_the_triangulation_beside_it(self):
        for orders, volume in (((0,) * 6, 7.327724753418), ((2, 2, 3, 3, 6, 3), 0.923164366693)):
            path = self.path("k4.orb", orb_file(orders, *self.K4))
            output = self.path("x.json")
            status, x = run_json("exterior", path, "-o", output)
            self.assertEqual((status, x["orders"], len(x["marks"])), (0, list(orders), 6))
            self.assertAlmostEqual(run_json("hyperbolize", output)[1]["volume"], volume, delta=1e-11)
            self.assertAlmostEqual(run_json("hyperbolize", path)[1]["volume"], volume, delta=1e-11)
        text = run("exterior", path).stdout
        self.assertIn("edges of graph  order 2, order 2, order 3, order 3, order 6, order 3\n", text)
        status, x = run_json("exterior", path, "--drilled")
        self.assertEqual((status, x["homology"], "orders" in x), (0, "Z^3", False))
        status, x = run_json("diagram", path)
        self.assertEqual((status, x["crossings"], x["vertices"], x["edges"]), (0, 0, 4, 6))
        self.assertIn("all of whose edges are drilled", run("exterior", path, "--parabolic").stderr)

    def test_orders_on_the_command_line(self):
        output = self.path("x.json")
        self.assertEqual(run_json("exterior", "4_1", "--order", "0:5", "-o", output)[1]["orders"], [5])
        # Hilden, Lozano and Montesinos (1995): see tests/diagram/marked_test.cpp.
        self.assertAlmostEqual(run_json("hyperbolize", output)[1]["volume"], 0.937206854761, delta=1e-9)
        k4 = "V[1, 3, 2] V[4, 5, 1] V[2, 6, 4] V[3, 5, 6]"
        run_json("exterior", k4, "--order", "all:0", "-o", output)
        self.assertAlmostEqual(run_json("hyperbolize", output)[1]["volume"], 7.327724753418, delta=1e-11)
        x = run_json("exterior", k4, "--order", "all:3", "--order", "2:0", "--mirror")[1]
        self.assertEqual(x["orders"], [3, 3, 0, 3, 3, 3])
        for word in ("6:3", "0", "0:0.5", "x:3", "0:nan"):
            done = run("exterior", k4, "--order", word)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"--order: found '{word}' (expected an edge of the graph, 0 to 5 or all", done.stderr)

    def test_which_strand_is_above(self):
        # A Lissajous knot, 5_2: chiral, so that a picture with all crossings changed is another one.
        polygon = [(round(900 * math.cos(3 * t + 0.7)), round(900 * math.cos(2 * t + 0.2)), round(900 * math.cos(7 * t)))
                   for t in (math.tau * k / 120 for k in range(120))]
        curve = self.path("curve.xyz", "".join(f"{x} {y} {z}\n" for x, y, z in polygon))
        n = len(polygon)
        path = self.path("knot.orb", orb_file((), [(x, -y) for x, y, z in polygon], [(k, (k + 1) % n) for k in range(n)],
                                              crossings_of(polygon), 1))
        status, found = run_json("isometric", path, curve, "--pair")
        self.assertEqual((status, found["keeps_orientation"], found["reverses_orientation"]), (0, True, False))
        self.assertAlmostEqual(found["x"]["volume"], 2.828122088330, delta=1e-11)

    def orbifold(self, code, *orders):
        """The graph with orders of its edges in a file."""
        path = self.path(f"orbifold{len(os.listdir(self.path('.')))}.json")
        words = [word for k, n in enumerate(orders) for word in ("--order", f"{k}:{n}")]
        self.assertEqual(run("exterior", code, *words, "-o", path).returncode, 0)
        return path

    def test_isometries_respect_orders(self):
        theta = "V[1, 4, 9] V[3, 8, 13] X[10, 6, 11, 7] X[5, 2, 6, 3] X[1, 11, 2, 12] X[12, 5, 13, 4] X[7, 9, 8, 10]"
        trefoil = "X[1, 4, 2, 5] X[3, 6, 8, 7] X[5, 2, 6, 3] V[7, 9, 1] V[4, 9, 8]"  # with an arc, edge 2
        one = self.orbifold(theta, 2, 3, 4)
        arc = self.orbifold(trefoil, 2, 2, 3)
        for x, y, status, proof in ((one, self.orbifold(theta, 3, 2, 4), 0, "isomorphism"),
                                    (one, self.orbifold(theta, 2, 3, 5), 1, "marks"),
                                    (one, self.orbifold(trefoil, 2, 3, 4), 1, "structure"),
                                    (one, "hk5_3", 1, "boundary"),
                                    (arc, self.orbifold(trefoil, 2, 3, 2), 1, "covers"),
                                    (self.orbifold(trefoil, 3, 2, 2), self.orbifold(trefoil, 2, 3, 2), 0, "isomorphism"),
                                    (self.orbifold("4_1", 3), self.orbifold("5_2", 3), 1, "volume"),
                                    (self.orbifold("4_1", 3), self.orbifold("4_1", 4), 1, "marks")):
            found_status, found = run_json("isometric", x, y)
            self.assertEqual((found_status, found["isometric"], found["proof"]), (status, status == 0, proof), found["reason"])
            # And the other way round.
            self.assertEqual(run_json("isometric", y, x)[1]["proof"], proof)
        k4 = "V[1, 3, 2] V[4, 5, 1] V[2, 6, 4] V[3, 5, 6]"
        adjacent, opposite = self.orbifold(k4, 5, 5, 3, 3, 3, 3), self.orbifold(k4, 5, 3, 3, 3, 3, 5)
        found = run_json("isometric", adjacent, opposite)[1]
        self.assertEqual((found["isometric"], found["proof"]), (False, "marks"))
        self.assertIn("the orders at the vertices differ: sphere with 3, 3, 3; ", found["reason"])
        self.assertIn("isometric: the ", run("isometric", one, one).stdout)

    def test_colored_cells(self):
        k4 = self.orbifold("V[1, 3, 2] V[4, 5, 1] V[2, 6, 4] V[3, 5, 6]", *(3,) * 6)
        output = self.path("cells.json")
        status, found = run_json("canonize", k4, "-o", output)
        self.assertEqual((status, found["cells"], found["isometry_group_order"]), (0, ["tetrahedron"] * 2, 48))
        self.assertEqual((found["certified"], len(found["marks"])), (False, 6))
        self.assertIn("_0-01:3", found["isometry_signature"])
        self.assertEqual(run_json("isometric", output, k4)[1]["isometric"], True)
        self.assertIn("those of parabolic meridians", run("canonize", k4).stdout)
        done = run("canonize", self.orbifold("4_1", 5))
        self.assertEqual(done.returncode, 4)
        self.assertIn("joins two cusps", done.stdout)

    def test_bad_drawings(self):
        done = run("exterior", self.path("none.orb", orb_file((0,), [], [], [])))
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        self.assertIn("the file has a triangulation and no drawing of a graph", done.stderr)
        points, segments, _ = self.K4
        done = run("diagram", self.path("cross.orb", orb_file((0,) * 6, [(0, 200), *points[1:]], segments, [])))
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        self.assertIn("segments 2 and 3 cross, and no crossing says how", done.stderr)
        self.assertIn("their orders cannot be told", run("exterior", self.path("k4.orb", orb_file((0,) * 5, *self.K4))).stderr)


class Diagrams(InFolder):
    def test_a_handlebody_is_simplified_where_its_graph_is_knotted(self):
        arc = "X[1, 4, 2, 5] X[3, 6, 8, 7] X[5, 2, 6, 3] V[7, 9, 1] V[4, 9, 8]"  # an unknotting tunnel of the trefoil
        self.assertEqual(run_json("diagram", arc, "--simplify")[1]["crossings"], 3)
        status, found = run_json("diagram", arc, "--handlebody")
        self.assertEqual((status, found["crossings"], found["vertices"]), (0, 0, 2))
        output = self.path("slid.pd")
        self.assertEqual(run("diagram", "hk6_2", "--handlebody", "-o", output).returncode, 0)
        self.assertTrue(run_json("isometric", output, "hk6_2", "--pair")[1]["equivalent"])

    def test_facts(self):
        status, d = run_json("diagram", "V[1, 2, 3] V[3, 2, 1]")
        self.assertEqual(status, 0)
        self.assertEqual([d[k] for k in ("crossings", "vertices", "edges", "components", "parts", "regions", "alternating")],
                         [0, 2, 3, 1, 1, 3, True])

    def test_simplify_and_mirror(self):
        self.assertEqual(run_json("diagram", "braid 1 -1 2 1 -1", "--simplify")[1]["crossings"], 0)
        code = run_json("diagram", "braid 1 1 1")[1]["code"]
        self.assertNotEqual(run_json("diagram", "braid 1 1 1", "--mirror")[1]["code"], code)

    def test_files(self):
        svg = self.path("trefoil.svg")
        self.assertEqual(run("diagram", "braid 1 1 1", "-o", svg).returncode, 0)
        root = xml.etree.ElementTree.parse(svg).getroot()
        self.assertTrue(root.tag.endswith("svg"))
        # Three passages below: three strokes.
        self.assertEqual(sum(1 for e in root.iter() if e.tag.endswith(("polyline", "path", "polygon"))), 3)
        code = self.path("trefoil.pd")
        self.assertEqual(run("diagram", "braid 1 1 1", "-o", code).returncode, 0)
        self.assertEqual(run_json("diagram", code)[1]["crossings"], 3)


class Drill(InFolder):
    def test_edges_of_the_sphere(self):
        # The edge of valence 1 of the sphere of one tetrahedron is a trefoil, the other one an unknot.
        groups = {}
        for edge in "0", "1":
            status, x = run_json("drill", "bkaagj", edge)
            self.assertEqual((status, x["homology"], x["drilled"]), (0, "Z", [int(edge)]))
            groups[edge] = len(x["group"]["generators"])
        self.assertEqual(groups, {"0": 1, "1": 2})

    def test_by_tetrahedron_and_cut(self):
        output = self.path("drilled.json")
        status, x = run_json("drill", "bkaagj", "0:23", "--cut", "-o", output)
        self.assertEqual((status, x["drilled"], [b["kind"] for b in x["boundary"]]), (0, [1], ["real"]))
        self.assertEqual(len(x["meridians"]), 1)
        again = run_json("truncate", output)[1]
        self.assertEqual((again["homology"], len(again["group"]["generators"])), ("Z", 2))
        self.assertEqual(run_json("drill", "cMcabbgqw", "0,2")[1]["drilled"], [0, 2])

    def test_bad_edges(self):
        for word in "7", "x", "0:11", "0:1", "9:01", "-1", "0,,1":
            done = run("drill", "bkaagj", "--", word)
            self.assertEqual((done.returncode, done.stdout), (2, ""), word)
            self.assertIn("EDGES", done.stderr)
