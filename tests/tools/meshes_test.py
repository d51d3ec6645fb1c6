# SPDX-License-Identifier: GPL-2.0-or-later
"""Meshes as others write them: what is passed over is told, and --weld, --component and --repair mend."""
import json
import os

from running import SOURCE, InFolder, medit, run, run_json

DATA = os.path.join(SOURCE, "tests/data/mesh")
CUBE = [(x, y, z) for z in (0, 1) for y in (0, 1) for x in (0, 1)]
QUADS = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (1, 3, 7, 5), (3, 2, 6, 7), (2, 0, 4, 6)]
SIX = [(0, 1, 3, 7), (0, 3, 2, 7), (0, 2, 6, 7), (0, 6, 4, 7), (0, 4, 5, 7), (0, 5, 1, 7)]


def off(points, faces):
    lines = ["OFF", "%d %d 0" % (len(points), len(faces))]
    lines += ["%r %r %r" % tuple(p) for p in points] + [" ".join(map(str, (len(f), *f))) for f in faces]
    return "\n".join(lines) + "\n"


def moved(points, x):
    return [(p[0] + x, p[1], p[2]) for p in points]


def shifted(elements, by):
    return [tuple(v + by for v in e) for e in elements]


def grid(n):
    """The unit cube in n^3 cubes of six tetrahedra: points and tetrahedra."""
    side = n + 1
    points = [(x / n, y / n, z / n) for z in range(side) for y in range(side) for x in range(side)]
    corner = [x + side * y + side * side * z for z in range(n) for y in range(n) for x in range(n)]
    step = [(k & 1) + side * (k >> 1 & 1) + side * side * (k >> 2) for k in range(8)]
    return points, [tuple(c + step[v] for v in six) for c in corner for six in SIX]


class Ledgers(InFolder):
    def test_polygons_are_cut_and_counted(self):
        path = self.path("cube.off", off(CUBE, QUADS))
        status, report = run_json("check", path)
        self.assertEqual((status, report["triangles"], report["type"], report["genus"]), (0, 12, "sphere", 0))
        self.assertEqual(report["passed_over"], [{"what": "quadrilateral, cut into triangles", "count": 6}])
        self.assertIn("passed over: quadrilateral, cut into triangles (6)", run("check", path).stderr)
        self.assertAlmostEqual(report["volume"], 1)
        self.assertAlmostEqual(report["area"], 6)
        # Whoever takes surfaces takes this one, and says so.
        for arguments in (("bundle", path, "--fiber", "2"), ("convert", path, "-o", self.path("cube.stl"))):
            self.assertIn("cut into triangles (6)", run(*arguments).stderr, arguments)

    def test_hexahedra_that_product_wrote_are_read_again(self):
        path = self.path("cube.mesh", medit(*grid(4)))
        hexes = self.path("hexes.mesh")
        _, made = run_json("product", path, "--hex", "2", "-o", hexes)
        status, report = run_json("check", hexes)
        count = made["hexahedra"]["count"] if isinstance(made["hexahedra"], dict) else made["hexahedra"]
        # A hexahedron is six tetrahedra from its vertex of the smallest number.
        self.assertEqual((status, report["tetrahedra"], report["findings"]), (0, 6 * count, []))
        self.assertEqual(report["passed_over"], [{"what": "hexahedron, cut into tetrahedra", "count": count}])
        self.assertAlmostEqual(report["volume"], 1, places=9)


class Doctors(InFolder):
    def test_check_measures_and_names_the_worst(self):
        path = self.path("cube.mesh", medit(CUBE + [(0.5, 0.5, 1.001)], SIX + [(4, 5, 7, 8)]))
        status, report = run_json("check", path)
        self.assertEqual((status, report["boundary"]), (0, [{"type": "sphere", "genus": 0}]))
        self.assertAlmostEqual(report["volume"], 1 + 0.001 / 6)
        self.assertEqual(report["box"], {"least": [0, 0, 0], "greatest": [1, 1, 1.001]})
        self.assertEqual([w["number"] for w in report["quality"]["worst"]][0], 7)
        self.assertLess(report["quality"]["least_angle"], 0.3)
        self.assertIn("worst tetrahedra (least angle in degrees): 7", run("check", path).stdout)

    def test_folded_tetrahedra_stay_found(self):
        points = CUBE[:3] + [CUBE[4], (0.2, 0.2, 0.5)]
        path = self.path("folded.mesh", medit(points, [(0, 1, 2, 3), (0, 2, 1, 4)]))
        mended = self.path("mended.mesh")
        self.assertEqual(run("check", path, "--repair", "-o", mended).returncode, 0)
        for name in (path, mended):
            self.assertEqual(run_json("check", name)[1]["counts"], {"folded": 1})

    def test_welding_with_and_without_a_tolerance(self):
        apart = self.path("apart.mesh", medit(CUBE + moved(CUBE, 1.0), SIX + shifted(SIX, 8)))
        self.assertEqual(run_json("check", apart)[1]["counts"]["coincident_vertex"], 4)
        for arguments in (("--weld",), ("--weld", "1e-9"), ("--weld=0",)):
            report = run_json("check", apart, *arguments)[1]
            self.assertEqual((report["vertices"], report["findings"], report["components"]), (12, [], 1), arguments)
        # An option or a file may follow; a number is the tolerance.
        self.assertEqual(run("check", "--weld", apart).returncode, 0)
        near = self.path("near.mesh", medit(CUBE + moved(CUBE, 1.0001), SIX + shifted(SIX, 8)))
        self.assertEqual(run_json("check", near, "--weld")[1]["components"], 2)
        self.assertEqual(run_json("check", near, "--weld", "0.001")[1]["components"], 1)
        for bad in ("-1", "nan"):
            self.assertEqual(run("check", near, "--weld=" + bad).returncode, 2, bad)

    def test_components_and_boundaries(self):
        two = self.path("two.mesh", medit(CUBE + moved(CUBE, 3.0), SIX + shifted(SIX[:1], 8)))
        self.assertEqual(run_json("check", two, "--component", "1")[1]["tetrahedra"], 1)
        self.assertIn("there is no component 2", run("check", two, "--component", "2").stderr)
        skin = self.path("skin.stl")
        status, made = run_json("convert", two, "--component", "0", "-o", skin)
        self.assertEqual((status, made["triangles"]), (0, 12))
        report = run_json("check", skin)[1]
        self.assertEqual((report["type"], report["counts"]), ("sphere", {}))
        self.assertAlmostEqual(report["volume"], 1)
        self.assertIn("the boundary of 6 tetrahedra was written", run("convert", two, "--component", "0", "-o", skin).stderr)

    def test_every_command_that_takes_meshes_mends_them(self):
        points = CUBE + moved(CUBE, 5)
        faces = QUADS + shifted(QUADS, 8)
        both = self.path("both.off", off(points, faces))
        fine, six = grid(4)
        solid = self.path("both.mesh", medit(fine + moved(fine, 5), six + shifted(six, len(fine))))
        ring = os.path.join(DATA, "ring_two_holes.off")
        mend = ("--weld", "--component", "0", "--repair")
        for arguments in (("bundle", both, "--fiber", "1"), ("product", solid), ("slit", ring), ("register", ring, ring),
                          ("truncate", solid), ("simplify", solid),
                          ("convert", both, "-o", self.path("one.ply"))):
            done = run(*arguments, *mend)
            self.assertEqual(done.returncode, 0, (arguments, done.stderr))
        self.assertIn("took component 0 of 2", run("bundle", both, "--fiber", "1", *mend).stderr)

    def test_unused_vertices_do_not_stop_a_product(self):
        fine, six = grid(4)
        path = self.path("cube.mesh", medit(fine + [(9.0, 9.0, 9.0)], six))
        done = run("product", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("passed over: 1 vertex in no tetrahedron", done.stderr)


class Structures(InFolder):
    def test_view_and_embed_find_the_structure_first(self):
        solid = os.path.join(SOURCE, "tests/data/knotted_y_8k.mesh")  # the exterior of a knotted Y: cPcbbbihq
        for arguments in (("view", solid, "-o", self.path("y.html")), ("embed", solid, "-o", self.path("y.glb"))):
            done = run(*arguments)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("found on another triangulation, of 2 tetrahedra: cPcbbbihq", done.stderr)
        self.assertEqual(run("embed", "cPcbbbihq").stderr, "")
        # Yin, section 4.2.3.
        self.assertIn("6.451990270835", run("embed", solid).stdout)
        # One tetrahedron, closed, simply connected: the sphere has none.
        done = run("view", "bkaagb", "-o", self.path("none.html"))
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        self.assertIn("there is no structure to embed", done.stderr)


class Bundles(InFolder):
    def test_what_a_bundle_has_no_use_for_is_refused(self):
        torus = os.path.join(DATA, "torus.off")
        ring = os.path.join(DATA, "ring_two_holes.off")
        square = self.path("square.off", off(CUBE[:4], [(0, 1, 3, 2)]))
        for arguments, word in (((ring, "--field", "0", "0", "1"), "closed"), ((torus, "--field", "nan", "0", "0"), "finite"),
                                ((torus, "--field", "0", "0", "0"), "no direction"),
                                ((torus, "--euler", "3", "--field", "1", "0", "0"), "Euler number 0"),
                                ((torus, "--obstruction", self.path("o.off")), "boundary"),
                                ((torus, "--show", "surface", "-o", self.path("s.svg")), "--show surface"),
                                ((square, "-o", self.path("s.svg")), "a disk is not cut")):
            done = run("bundle", *arguments)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), arguments)
            self.assertIn(word, done.stderr)
        self.assertEqual(os.listdir(self.folder.name), ["square.off"])
        self.assertIn("there is no obstruction", run("bundle", square, "--obstruction", self.path("o.off")).stderr)
        # A random tangent field is no section of another bundle.
        made = run_json("bundle", os.path.join(DATA, "cube.off"), "--euler", "8", "--fiber", "2")[1]
        self.assertIsNone(made["field"])

    def test_tetrahedra_with_coordinates_are_positive(self):
        square = self.path("square.off", off(CUBE[:4], [(0, 1, 3, 2)]))
        for fiber in ("1", "2", "3", "8"):
            path = self.path("b.vtu")
            self.assertEqual(run("bundle", square, "--fiber", fiber, "-o", path).returncode, 0)
            status, report = run_json("check", path)
            self.assertEqual((status, report["findings"]), (0, []), fiber)

    def test_infinite_lengths_end(self):
        far = [(1e308, 0, 0), (-1e308, 0, 0), (0, 1e308, 0), (0, 0, 1e308)]
        path = self.path("far.off", off(far, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]))
        self.assertEqual(run_json("bundle", path)[1]["homology"], "Z/2")  # the unit tangent bundle of a sphere
