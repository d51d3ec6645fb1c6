# SPDX-License-Identifier: GPL-2.0-or-later
"""Hyperbolic structures: found, proved, their cells, placed in space, and looked at. Part of program_test.py."""
import hashlib
import json
import os
import re
import tempfile
import unittest
from fractions import Fraction

from running import InFolder, run, run_json, SOURCE


class Hyperbolize(unittest.TestCase):
    def test_the_knotted_y_by_both_methods(self):
        # Yin, 4.3.4: all dihedral angles 0.523599; the volume is that of two regular truncated tetrahedra (FMP 2004).
        for method in ("newton", "flow"):
            status, found = run_json("hyperbolize", "cPcbbbihq", "--method", method)
            self.assertEqual((status, found["outcome"]), (0, "geometric"))
            self.assertAlmostEqual(found["volume"], 6.451990270835, delta=1e-11)
            for angles in found["dihedral_angles"]:
                for angle in angles:
                    self.assertAlmostEqual(angle, 0.5235987756, delta=1e-9)
            self.assertLess(found["residual"], 1e-10)

    def test_the_knotted_y_typed_in_from_the_dissertation(self):
        path = f"{SOURCE}/tests/data/knotted_y.json"
        self.assertEqual(run_json("info", path)[1]["signature"], "cPcbbbihq")
        found = run_json("hyperbolize", path)[1]
        self.assertAlmostEqual(found["volume"], 6.451990270835, delta=1e-11)
        with open(path) as f:
            self.assertEqual(run("convert", path).stdout, f.read())

    def test_the_history_is_a_table_that_decreases(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "history.csv")
            self.assertEqual(run("hyperbolize", "fmp3_100", "--method", "flow", "--history", path).returncode, 0)
            with open(path) as lines:
                header = lines.readline().strip().split(",")
                column = header.index("squared_curvature")
                values = [float(line.split(",")[column]) for line in lines]
            self.assertGreater(len(values), 10)
            self.assertTrue(all(a > b for a, b in zip(values, values[1:])))

    def test_cusps_have_shapes_and_lengths_into_them_are_marked(self):
        # The Whitehead link: a regular octahedron, so that both cusps are squares, glued into rectangles of 1 by 2.
        found = run_json("hyperbolize", "m129")[1]
        self.assertEqual([cusp["type"] for cusp in found["cusps"]], ["torus", "torus"])
        for cusp in found["cusps"]:
            self.assertAlmostEqual(cusp["shape"][0], 0, delta=1e-12)
            self.assertAlmostEqual(cusp["shape"][1], 2, delta=1e-12)
        self.assertEqual(found["into_cusps"], [0, 1, 2, 3])
        text = run("hyperbolize", "m129").stdout
        self.assertEqual(len(re.findall(r"^edge \d .* to the horosphere, valence", text, re.M)), 4)
        self.assertEqual(len(re.findall(r"^cusp \d +torus, shape -?0\.0000000000 \+ 2\.0000000000 i$", text, re.M)), 2)
        closed = run_json("hyperbolize", "cPcbbbihq")[1]
        self.assertEqual((closed["cusps"], closed["into_cusps"]), ([], []))

    def test_certified_shapes_of_cusps_are_enclosed_to_many_digits(self):
        for name, real, square in (("m129", 0, 4), ("m004", 0, 12), ("m003", Fraction(1, 2), Fraction(3, 4))):
            for cusp in run_json("hyperbolize", name, "--certify")[1]["cusps"]:
                (a, b), (c, d) = ([Fraction(end) for end in ends] for ends in cusp["shape_interval"])
                self.assertTrue(a <= real <= b and c * c <= square <= d * d, (name, cusp))
                self.assertLess(max(b - a, d - c), 1e-25)

    def test_false_convergence_is_not_found(self):
        status, found = run_json("hyperbolize", "dLQacccjcog", "--as-given")
        self.assertEqual((status, found["outcome"]), (4, "not found"))

    def test_what_is_not_hyperbolic_is_told_with_its_proof(self):
        # One of the three gluings of three tetrahedra without a structure: the group splits (a generator in powers only).
        status, found = run_json("hyperbolize", "dLQacccjcog")
        self.assertEqual((status, found["outcome"], found["reason"]), (1, "not hyperbolic", "root"))
        group = found["why"]["group"]
        self.assertEqual(group["triangulation"], found["signature"])
        self.assertGreater(group["exponents"][0], 1)
        text = run("hyperbolize", "dLQacccjcog").stdout
        self.assertIn(group["shown"], text)
        self.assertRegex(text, "(?m)^theorem ")
        status, cells = run_json("canonize", "dLQacccjcog")
        self.assertEqual((status, cells["outcome"], cells["why"]["kind"]), (1, "not hyperbolic", "root"))
        # Two trefoils (Regina: the essential torus swallows one and follows the other).
        status, found = run_json("hyperbolize", "eLMkbcddddlihu")
        self.assertEqual((status, found["outcome"]), (1, "not hyperbolic"))

    def test_a_metric_file_keeps_its_structure(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "y.json")
            self.assertEqual(run("hyperbolize", "cPcbbbihq", "-o", path).returncode, 0)
            with open(path) as f:
                self.assertAlmostEqual(json.load(f)["metric"]["volume"], 6.451990270835, delta=1e-11)


class Proofs(InFolder):
    def certificate(self, name, *options):
        path = self.path("x.cert.json")
        status, found = run_json("hyperbolize", name, "-o", path, *options)
        self.assertEqual((status, found["certified"]), (0, True))
        return path, found

    def test_a_structure_is_certified_and_verified(self):
        # 30 digits of the tables (census/fmp2.json); the figure eight knot's volume is OEIS A091518.
        for name, volume in (("fmp2_8", "6.45199027083503286529820913559"),
                             ("m004", "2.02988321281930725004240510854")):
            path, found = self.certificate(name, "--certify")
            low, high = map(Fraction, found["volume_interval"])
            self.assertTrue(low <= Fraction(volume) + Fraction(1, 10**28) and Fraction(volume) <= high)
            self.assertLess(high - low, Fraction(1, 10**15))
            with open(path, "rb") as file:
                self.assertEqual(found["certificate"], hashlib.sha256(file.read()).hexdigest())
            status, report = run_json("verify", path)
            self.assertEqual((status, report["accepted"]), (0, True))
            self.assertEqual(report["volume_interval"], found["volume_interval"])
        self.assertNotIn("certified", run_json("hyperbolize", "fmp2_8")[1])

    def test_digits(self):
        # 2 Cl(pi/3) by mpmath, whose first digits are OEIS A091518.
        path, found = self.certificate("m004", "--digits", "100")
        self.assertEqual(found["volume_digits"], "2.0298832128193072500424051085490405718833786150605995840349"
                                                 "78213553194952516488044272940708456513390")
        self.assertEqual(run("verify", path).returncode, 0)

    def test_what_is_damaged_is_refused(self):
        path, _ = self.certificate("fmp3_17")
        with open(path) as file:
            text = file.read()
        status, report = run_json("verify", self.path("links.cert.json", text.replace("[-2]", "[-4]")))
        self.assertEqual((status, report["accepted"]), (1, False))
        self.assertIn("links", report["reason"])
        self.assertEqual(run("verify", self.path("half.cert.json", text[:300])).returncode, 2)
        self.assertEqual(run("verify", self.path("none.cert.json", "")).returncode, 2)
        self.assertEqual(run("verify", self.path("no.cert.json")).returncode, 2)
        self.assertEqual(run("verify", f"{SOURCE}/tests/data/knotted_y.json").returncode, 2)

    def test_cells_are_certified_and_verified(self):
        path = self.path("cells.cert.json")
        status, found = run_json("canonize", "m004", "-o", path)
        self.assertEqual((status, found["certified"]), (0, True))
        with open(path, "rb") as file:
            self.assertEqual(found["certificate"], hashlib.sha256(file.read()).hexdigest())
        status, report = run_json("verify", path)
        # Two tetrahedra have four faces between them.
        self.assertEqual((status, report["walls"], report["unchecked"], report["cusp_area"]), (0, 4, {}, "0.05"))
        # An octahedron: what symmetry proves flat is not checked, and that is said.
        self.assertEqual(run("canonize", "eLAkbccddemoen", "-o", path).returncode, 0)
        status, report = run_json("verify", path)
        self.assertEqual((status, report["walls"], report["unchecked"]), (0, 4, {"R": 4}))
        self.assertIn("not checked: 4 faces", run("verify", path).stdout)
        with open(path) as file:
            text = file.read()
        wrong = self.path("wrong.cert.json", text.replace('"flat":"R"', '"flat":null'))
        status, report = run_json("verify", wrong)
        self.assertEqual(status, 1)
        self.assertIn("is not proved to be convex", report["reason"])

    def test_what_has_no_structure_is_not_certified(self):
        path = self.path("none.cert.json")
        status, found = run_json("hyperbolize", "dLQacccjcog", "--as-given", "--certify", "-o", path)
        self.assertEqual((status, found["outcome"]), (4, "not found"))
        self.assertEqual(found["certified"], False)
        self.assertFalse(os.path.exists(path))


class Canonize(unittest.TestCase):
    def test_cells_are_proved(self):
        status, answer = run_json("canonize", "fmp3_1")
        self.assertEqual((status, answer["certified"], answer["criteria"]), (0, True, ["tetrahedron"] * 3))
        status, answer = run_json("canonize", "eLAkbccddemoen", "--isometries")
        self.assertEqual((status, answer["certified"], answer["criteria"]), (0, True, ["R"]))
        self.assertEqual((answer["isometry_group"], answer["amphichiral"]), ("D3", False))
        self.assertEqual(len(answer["isometries"]), answer["isometry_group_order"])
        # The figure eight knot: Henry and Weeks 1992.
        answer = run_json("canonize", "m004")[1]
        self.assertEqual((answer["isometry_group"], answer["amphichiral"]), ("D4", True))

    def test_proofs_that_manifolds_differ(self):
        # Volumes by the census; the two of fmp3_1 and fmp3_2 are equal, and so are boundary and homology.
        for x, y, proof in (("fmp3_1", "fmp3_10", "volume"), ("fmp3_1", "fmp3_2", "cells"),
                            ("fmp3_1", "fmp3_100", "boundary")):
            status, answer = run_json("isometric", x, y)
            self.assertEqual((status, answer["isometric"], answer["proof"]), (1, False, proof))

    def test_boundary_spheres_count(self):
        # The first is the second with a ball taken out (Regina: boundary components of Euler characteristic -2,
        # ideal, and 2, of two faces).
        status, answer = run_json("isometric", "hHvOwQaceegggbbbbgfw", "cPcbbbihq")
        self.assertEqual((status, answer["isometric"], answer["proof"]), (1, False, "boundary"))
        self.assertIn("sphere", answer["reason"])
        status, answer = run_json("isometric", "hHvOwQaceegggbbbbgfw", "hHvOwQaceegggbbbbgfw")
        self.assertEqual((status, answer["isometric"], answer["filled_spheres"]), (0, True, 1))
        status, answer = run_json("canonize", "hHvOwQaceegggbbbbgfw")
        self.assertEqual((status, answer["filled_spheres"]), (0, 1))
        self.assertEqual(answer["isometry_signature"], "cPcbbbihq")
        self.assertIn("filled spheres", run("canonize", "hHvOwQaceegggbbbbgfw").stdout)
        self.assertEqual(run_json("canonize", "cPcbbbihq")[1]["filled_spheres"], 0)
        self.assertNotIn("filled", run("canonize", "cPcbbbihq").stdout)

    def test_isometric_where_a_face_is_flat(self):
        # An octahedron (FMP 2004, section 4); the second triangulation is a 2-3 move away (Regina's).
        status, answer = run_json("isometric", "eLAkbccddemoen", "eLAkbccddemoen")
        self.assertEqual((status, answer["isometric"], answer["proof"]), (0, True, "isomorphism"))
        self.assertEqual(answer["between"], "triangulations given")
        status, answer = run_json("isometric", "eLAkbccddemoen", "fLLQcacdeeenkxigw")
        self.assertEqual((status, answer["isometric"], answer["proof"]), (0, True, "isomorphism"))
        self.assertEqual(answer["between"], "canonical triangulations")

    def test_different_homology_is_a_no_although_a_face_is_flat(self):
        # H1 of the two octahedra by Regina 7.3.
        status, answer = run_json("isometric", "eLAkbccddemoen", "eLAkbccddemwij")
        self.assertEqual((status, answer["isometric"], answer["proof"]), (1, False, "homology"))
        self.assertEqual(answer["reason"], "the first homology differs: Z^2 + Z/3 against Z^2")

    def test_canonize_attempts(self):
        # A minimal triangulation of the cusped census without a structure of its own: one attempt is too few. The
        # canonical signature is SnapPea's (Regina 7.3).
        status, answer = run_json("canonize", "gLLAQaedefffjxdhwnw", "--attempts", "1")
        self.assertEqual((status, answer["outcome"]), (4, "not found"))
        status, answer = run_json("canonize", "gLLAQaedefffjxdhwnw")
        self.assertEqual((status, answer["isometry_signature"]), (0, "gLLAQbcedefftoaotsw"))

    def test_isometric_to_itself_in_another_triangulation(self):
        status, answer = run_json("isometric", "fmp3_17", "fmp3_17")
        self.assertEqual((status, answer["isometric"]), (0, True))
        self.assertIn("isometry", answer)

    def test_different_manifolds_are_told_apart(self):
        status, answer = run_json("isometric", "fmp2_1", "fmp2_2")
        self.assertEqual((status, answer["isometric"]), (1, False))

    def test_one_without_a_structure_is_another_manifold(self):
        status, answer = run_json("isometric", "fmp2_1", "dLQacccjcog")
        self.assertEqual(status, 1)
        self.assertIn(answer["proof"], ("homology", "boundary", "structure"))

    def test_covers_tell_apart_what_has_no_structure(self):
        # Trefoil and torus knot T(2,5): H1 = Z, one torus. The trefoil's group maps onto S3 and T(2,5)'s does not.
        status, answer = run_json("isometric", "3_1", "5_1")
        self.assertEqual((status, answer["isometric"], answer["proof"]), (1, False, "covers"))
        self.assertIn("covers of", answer["reason"])
        # Homeomorphic, and said so without a structure.
        status, answer = run_json("isometric", "cPcbbbadu", "cPcbbbadu")
        self.assertEqual((status, answer["isometric"], answer["proof"]), (0, True, "isomorphism"))


class Embed(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def complaint(self, *arguments):
        done = run(*arguments)
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        self.assertEqual(os.listdir(self.folder.name), [])
        return done.stderr

    def test_the_knotted_y(self):
        status, made = run_json("embed", "cPcbbbihq", "--copies", "100")
        self.assertEqual(status, 0)
        for name, value in made["residuals"].items():
            self.assertLess(value, 1e-10, name)
        # By hand: eight faces, one pair of them inside the domain.
        self.assertEqual(len(made["domain"]["gluable_faces"]), 6)
        self.assertEqual(made["copies"]["count"], 100)

    def test_generators_satisfy_the_relators(self):
        # A second route to the holonomy: the printed matrices, multiplied here along the printed words.
        made = run_json("embed", "dLQacccjjkg")[1]["domain"]

        def product(a, b):
            return [[sum(x * y for x, y in zip(row, column)) for column in zip(*b)] for row in a]

        def inverse(m):
            return [[m[j][i] * (1 if (i == 3) == (j == 3) else -1) for j in range(4)] for i in range(4)]

        identity = [[float(i == j) for j in range(4)] for i in range(4)]
        for word in made["relators"]:
            m = identity
            for letter in word:
                g = made["generators"][ord(letter.lower()) - ord("a")]["so31"]
                m = product(m, g if letter.islower() else inverse(g))
            self.assertLess(max(abs(m[i][j] - identity[i][j]) for i in range(4) for j in range(4)), 1e-9, word)
        for g in made["generators"]:
            a, b, c, d = (complex(*z) for z in g["sl2c"]["matrix"])
            self.assertLess(abs(a * d - b * c - 1), 1e-12)

    def test_pictures_of_every_kind(self):
        beginnings = {"a.glb": b"glTF", "a.ply": b"ply\n", "a.obj": b"o ", "a.vtu": b"<?xml", "a.svg": b"<"}
        for name, beginning in beginnings.items():
            for options in ([], ["--boundary", "0"]):
                done = run("embed", "cPcbbbihq", "--copies", "5", *options, "-o", self.path(name))
                self.assertEqual(done.returncode, 0, done.stderr)
                with open(self.path(name), "rb") as file:
                    self.assertTrue(file.read().startswith(beginning), name)

    def test_several_files_at_once(self):
        names = ("several.glb", "several.svg", "several.vtu")
        done = run("embed", "cPcbbbihq", "--copies", "5", *(word for name in names for word in ("-o", self.path(name))))
        self.assertEqual(done.returncode, 0, done.stderr)
        for name in names:
            alone = self.path("alone" + name[name.index("."):])
            run("embed", "cPcbbbihq", "--copies", "5", "-o", alone)
            with open(self.path(name), "rb") as one, open(alone, "rb") as other:
                self.assertEqual(one.read(), other.read(), name)

    def test_the_same_bytes_again(self):
        for name in ("a.glb", "b.glb"):
            run("embed", "dLQacccjjkg", "--radius", "2", "--model", "klein", "-o", self.path(name))
        with open(self.path("a.glb"), "rb") as a, open(self.path("b.glb"), "rb") as b:
            self.assertEqual(a.read(), b.read())

    def test_no_structure_says_what_was_tried(self):
        # The trefoil's complement by Regina (Example3.trefoil), a Seifert space, and a ball with real boundary.
        self.assertIn("no structure found on 1000 triangulations", self.complaint("embed", "cPcbbbadu"))
        self.assertIn("there is no structure to embed", self.complaint("embed", "baa", "-o", self.path("a.glb")))

    def test_copies_that_do_not_fit_or_are_none(self):
        self.assertIn("expected at least 1", self.complaint("embed", "cPcbbbihq", "--copies", "0"))
        message = self.complaint("embed", "cPcbbbihq", "--copies", "1000000000", "-o", self.path("a.glb"))
        self.assertRegex(message, r"about \d+ GB would be needed, and 4.0 GB are allowed \(--memory\)")
        message = self.complaint("embed", "cPcbbbihq", "--copies", "1000", "--memory", "0.05", "-o", self.path("a.glb"))
        self.assertIn("1000 copies in", message)
        self.assertIn("--memory", self.complaint("embed", "cPcbbbihq", "--radius", "30", "--memory", "0.01"))
        self.assertIn("counted from 0", self.complaint("embed", "cPcbbbihq", "--boundary", "1"))

    def test_places_that_cannot_be_written(self):
        self.assertIn("no such folder", self.complaint("embed", "cPcbbbihq", "-o", self.path("x/a.glb")))
        self.assertIn(".glb", self.complaint("embed", "cPcbbbihq", "-o", self.path("a.png")))
        self.assertIn("no such folder", self.complaint("view", "cPcbbbihq", "-o", self.path("x/a.html")))
        self.complaint("view", "cPcbbbihq", "-o", self.folder.name)


class View(unittest.TestCase):
    def test_the_page_holds_the_scene_and_asks_for_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "y.html")
            done = run("view", "cPcbbbihq", "-o", path, "--copies", "20")
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(path, encoding="utf-8") as file:
                page = file.read()
        begin = page.index(">", page.index('id="tetrarch-scene"')) + 1
        scene = json.loads(page[begin:page.index("</script>", begin)])
        self.assertEqual([b["name"] for b in scene["bodies"]], ["fundamental domain", "boundary 0 (genus 2)"])
        self.assertIn(["volume", "6.451990270835"], scene["tables"][0]["rows"])
        self.assertNotRegex(page, r'(src|href)="(?!data:|#)')

    def test_too_many_copies_for_a_page(self):
        done = run("view", "cPcbbbihq", "-o", "/tmp/never.html", "--copies", "100000")
        self.assertEqual(done.returncode, 2)
        self.assertIn("tetrarch embed", done.stderr)
