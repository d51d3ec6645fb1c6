# SPDX-License-Identifier: GPL-2.0-or-later
"""Marked edges and closed manifolds, as typed."""
import json
import os
import unittest

from running import SOURCE, InFolder, run, run_json

# Lines of edges of Orb's example files. Graphs2_0: a graph in S^3 with three edges, all of them parabolic.
with open(f"{SOURCE}/tests/data/format/graphs2_0.orb", encoding="utf-8") as orb:
    GRAPH = orb.read()
# And of 1_1^2.1, which Orb calls partially flat; the volume is that of 1_1^2.20, another orbifold, on four positive
# tetrahedra (tests/hyperbolic/orbifold_test.cpp).
FLAT = """% orb
1_1^2.1
SolutionType partially_flat_solution
vertices_known

  1  2 3.000  1  2  1vu
  2  1 2.000  2  1  2wv
  3  3 4.000  2  1  2vu  2uw  1vx  1xu
  4  0 1.000  2  2  2xv  1vw  1wu  2ux  1wx  2wx
"""
# S^3 with the complete graph on four vertices.
K4 = json.dumps({"format": "tetrarch-triangulation", "version": 1, "tetrahedra": 2,
                 "gluings": [[[1, "1302"]] * 4, [[0, "2031"]] * 4]})
OCTAHEDRON = 3.663862376709  # the regular ideal one


class MarkedEdges(InFolder):
    def test_an_orb_file_keeps_its_marks(self):
        path = self.path("graph.orb", GRAPH)
        status, found = run_json("hyperbolize", path)
        self.assertEqual((status, found["outcome"], found["solved_by"]), (0, "geometric", "newton"))
        self.assertAlmostEqual(found["volume"], 5.333489566898, delta=1e-11)
        self.assertEqual(found["marks"], [[0, "13", 0], [0, "01", 0], [1, "23", 0]])
        self.assertEqual({v["type"] for v in found["vertices"]}, {"hyperideal"})
        self.assertEqual(found["orientation"], [1, 1])
        text = run("hyperbolize", path).stdout
        self.assertIn("solved by   Newton's method from lengths 1\n", text)
        self.assertRegex(text, r"vertex 0 +hyperideal, link sphere, orders null, null, null\n")
        self.assertRegex(text, r"edge 0 +length 0\.0000000000, valence 1, null\n")
        # Through JSON and back, and with the metric.
        other = self.path("graph.json")
        self.assertEqual(run("convert", path, "-o", other).returncode, 0)
        solved = self.path("solved.json")
        self.assertEqual(run("hyperbolize", other, "-o", solved).returncode, 0)
        with open(solved, encoding="utf-8") as file:
            document = json.load(file)
        self.assertEqual(len(document["marks"]), 3)
        self.assertAlmostEqual(document["metric"]["volume"], 5.333489566898, delta=1e-11)
        self.assertAlmostEqual(run_json("hyperbolize", solved)[1]["volume"], 5.333489566898, delta=1e-11)

    def test_who_does_not_know_marks_says_so(self):
        path = self.path("graph.orb", GRAPH)
        done = run("info", path)
        self.assertEqual(done.returncode, 0)
        self.assertIn("passed over: order of an edge, of which the underlying manifold has none (3)", done.stderr)
        done = run("convert", path, "-o", self.path("graph.sig"))
        self.assertIn("the orders of 3 edges are left out: only JSON holds them", done.stderr)

    def test_marks_on_the_command_line(self):
        path = self.path("k4.json", K4)
        for options, volume in ((["--parabolic", "all"], 2 * OCTAHEDRON),
                                (["--parabolic", "0,1,2", "--parabolic", "0:12,0:13,5"], 2 * OCTAHEDRON),
                                (["--parabolic", "1,2,4,5", "--cone", "0:2", "--cone", "0:12:2"], OCTAHEDRON),
                                ([word for k, n in enumerate((2, 2, 3, 3, 6, 3)) for word in ("--cone", f"{k}:{n}")],
                                 0.923164366693)):
            status, found = run_json("hyperbolize", path, *options)
            self.assertEqual((status, found["outcome"]), (0, "geometric"), options)
            self.assertAlmostEqual(found["volume"], volume, delta=1e-11)
        # Marks of the file stay where the command line says nothing.
        status, found = run_json("hyperbolize", self.path("graph.orb", GRAPH), "--cone", "0:50")
        self.assertEqual([mark[2] for mark in found["marks"]], [50, 0, 0])
        self.assertLess(found["volume"], 5.333489566898)
        self.assertGreater(found["volume"], 5.32)

    def test_bad_marks(self):
        path = self.path("k4.json", K4)
        for options, message in ((["--cone", "7:3"], "--cone: found '7' (expected the number of an edge, 0 to 5"),
                                 (["--cone", "0:0.5"], "--cone: found '0:0.5' (expected an edge and a number n"),
                                 (["--cone", "0"], "--cone: found '0' (expected an edge and a number n"),
                                 (["--cone", "0:nan"], "--cone: found '0:nan'"),
                                 (["--cone", "x:3"], "--cone: found 'x'"),
                                 (["--parabolic", "0,9"], "--parabolic: found '9'"),
                                 (["--parabolic", "all", "--method", "flow"], "the flow knows no marked edges")):
            done = run("hyperbolize", path, *options)
            self.assertEqual(done.returncode, 2, options)
            self.assertIn(message, done.stderr)
            self.assertEqual(done.stderr.count("\n"), 1)
        # One cone point on a sphere: a proved no.
        status, found = run_json("hyperbolize", path, "--cone", "0:3")
        self.assertEqual((status, found["outcome"], found["reason"]), (1, "not hyperbolic", "bad_vertex"))
        status, found = run_json("hyperbolize", path, "--parabolic", "all", "--certify")
        self.assertEqual((status, found["certified"]), (4, False))
        # Cells with marks are not proved, and no certificate says that they are.
        out = self.path("cells.cert.json")
        done = run("canonize", self.path("graph.orb", GRAPH), "-o", out)
        self.assertEqual(done.returncode, 4)
        self.assertIn("cells.cert.json was not written: the cells are not proved", done.stderr)
        self.assertFalse(os.path.exists(out))

    def test_tetrahedra_turned_over_are_no_structure(self):
        path = self.path("flat.orb", FLAT)
        out = self.path("out.json")
        status, found = run_json("hyperbolize", path, "--as-given", "-o", out)
        self.assertEqual((status, found["outcome"], found["solved_by"]), (4, "turned over", "homotopy"))
        self.assertAlmostEqual(found["volume"], 0.132387219942, delta=1e-9)
        self.assertIn(0, found["orientation"])
        self.assertTrue(os.path.exists(out))
        self.assertIn("flat: no proof of a structure", run("hyperbolize", path, "--as-given").stdout)


class ClosedManifolds(InFolder):
    def test_the_smallest_ones(self):
        # Weeks' manifold and Meyerhoff's: Regina's census of closed hyperbolic manifolds.
        for name, volume in (("jLvMLQQbfefgihhiixiptvvvgof", 0.9427073627769277),
                             ("jLvvQQQbghighigihduqugksnof", 0.9813688288922321)):
            status, found = run_json("hyperbolize", name)
            self.assertEqual((status, found["outcome"]), (0, "geometric"))
            self.assertAlmostEqual(found["volume"], volume, delta=1e-11)
            self.assertEqual([v["type"] for v in found["vertices"]], ["finite"])
            self.assertNotIn("cusps", found)

    def test_they_are_certified(self):
        path = self.path("weeks.cert.json")
        status, found = run_json("hyperbolize", "jLvMLQQbfefgihhiixiptvvvgof", "--digits", "40", "-o", path)
        self.assertEqual((status, found["certified"]), (0, True))
        # 3 * 23^(3/2) zeta_K(2) / (4 pi^4), by mpmath: see tests/verified/closed_test.cpp.
        self.assertEqual(found["volume_digits"], "0.9427073627769277209212996030922116475903")
        status, report = run_json("verify", path)
        self.assertEqual((status, report["accepted"], report["links"]), (0, True, [2]))

    def test_others_have_none(self):
        for name in ("cMcabbgqw", "cMcabbjak"):  # RP^3 and L(3,1)
            status, found = run_json("hyperbolize", name)
            self.assertEqual((status, found["volume"], found["outcome"]), (1, None, "not hyperbolic"))
            self.assertIn("cyclic", found["explanation"])
