#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The program as its users meet it: exit statuses, one line of complaint, JSON fields, files.

Usage: program_test.py PROGRAM SOURCE_DIR
"""
import contextlib
import hashlib
import json
import lzma
import math
import os
import re
import signal
import sqlite3
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock
from fractions import Fraction

from census_runs_test import *  # noqa: F401,F403: a census on a full disk, under MPI, and of changed triangulations
from diagrams_test import *  # noqa: F401,F403: knots, links and graphs in space
from hex_test import *  # noqa: F401,F403: hexahedra of solids
from hostile_test import *  # noqa: F401,F403: files and surroundings that mean no good
from inputs_test import *  # noqa: F401,F403: what stands for a triangulation
from meshes_test import *  # noqa: F401,F403: meshes from elsewhere, and mending them
from marked_test import *  # noqa: F401,F403: cone angles, parabolic meridians, closed manifolds
from options_test import *  # noqa: F401,F403: the tests of options that stand nowhere else
from schema_test import *  # noqa: F401,F403: schemas of what --json prints
from running import (INSTRUMENTED, PROGRAM, InFolder, SLOWER, SOURCE, medit, run, run_json, seconds_of_children, unseen_members, unused_options,
                     wait_until_it_listens)


class Info(unittest.TestCase):
    def test_the_knotted_y(self):
        # Yin, section 4.2.3: two tetrahedra, one edge class, genus 2; H1 = Z^2 and a free group by Regina 7.3.
        status, info = run_json("info", "cPcbbbihq")
        self.assertEqual(status, 0)
        self.assertEqual((info["tetrahedra"], info["faces"], info["edges"], info["vertices"]), (2, 4, 1, 1))
        self.assertTrue(info["valid"] and info["orientable"] and info["connected"])
        self.assertEqual(info["signature"], "cPcbbbihq")
        self.assertEqual(info["homology"], "Z^2")
        self.assertEqual(info["boundary"], [{"kind": "ideal", "genus": 2, "orientable": True, "euler": -2}])
        self.assertEqual(len(info["group"]["generators"]), 2 + len(info["group"]["relators"]))

    def test_defects_are_named(self):
        # One tetrahedron, face 0 folded onto face 1 so that the edge 23 meets itself reversed (drawn by hand).
        text = json.dumps({"format": "tetrarch-triangulation", "version": 1, "tetrahedra": 1,
                           "gluings": [[[0, "1032"], [0, "1032"], None, None]]})
        done = run("info", "-", "--json", stdin=text)
        info = json.loads(done.stdout)
        self.assertFalse(info["valid"])
        self.assertIn("edge_reversed", [d["name"] for d in info["defects"]])
        self.assertIsNone(info["homology"])


class Convert(unittest.TestCase):
    def test_round_trips(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.json", "a.tri", "a.sig"):
                path = os.path.join(folder, name)
                self.assertEqual(run("convert", "cPcbbbiht", "-o", path).returncode, 0)
                self.assertEqual(run_json("info", path)[1]["signature"], "cPcbbbiht", name)
            first = os.path.join(folder, "a.json")
            again = os.path.join(folder, "b.json")
            run("convert", first, "-o", again)
            with open(first, "rb") as f, open(again, "rb") as g:
                self.assertEqual(f.read(), g.read())

    def test_a_file_that_snappy_refuses_is_announced(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("convert", "cPcbbbihq", "-o", os.path.join(folder, "y.tri"))
            self.assertEqual(done.returncode, 0)
            self.assertIn("warning", done.stderr)
            self.assertIn("genus 2", done.stderr)


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


class Census(unittest.TestCase):
    def test_validation(self):
        # Frigerio-Martelli-Petronio 2004: 8 manifolds of one volume, 151 of 18 volumes, one of them with a cusp.
        for tetrahedra, manifolds, volumes in ((2, 8, 1), (3, 151, 18)):
            status, found = run_json("census", "validate", "--tetrahedra", str(tetrahedra))
            self.assertEqual(status, 0)
            self.assertEqual((found["manifolds"], found["distinct_volumes"]), (manifolds, volumes))
            self.assertTrue(found["rebuilt"])
            self.assertEqual(found["failures"], [])
            self.assertLess(found["max_angle_error"], 1e-10)
            self.assertLess(found["max_angle_error_flow"], 1e-9)
            self.assertLess(found["max_volume_error"], 1e-9)

    def test_rebuilt_tables_are_the_stored_files(self):
        with tempfile.TemporaryDirectory() as folder:
            for tetrahedra in (2, 3):
                path = os.path.join(folder, "table.json")
                run("census", "enumerate", "--tetrahedra", str(tetrahedra), "-o", path, "--threads", "1")
                with open(path, "rb") as new, open(f"{SOURCE}/census/fmp{tetrahedra}.json", "rb") as old:
                    self.assertEqual(new.read(), old.read())

    def test_gluings_are_those_of_regina(self):
        # Recorded: tricensus -t 3 -i -o -d -s (Regina 7.3), 378 signatures.
        done = run("census", "gluings", "--tetrahedra", "3", "--orientable", "--ideal")
        self.assertEqual(len(done.stdout.split()), 378)
        one = run("census", "gluings", "--tetrahedra", "3", "--threads", "1")
        two = run("census", "gluings", "--tetrahedra", "3", "--threads", "2")
        self.assertEqual(one.stdout, two.stdout)

    def test_enumerate_writes_an_object_a_line(self):
        lines = run("census", "enumerate", "--tetrahedra", "2").stdout.splitlines()
        self.assertEqual(len(lines), 8)
        for line in lines:
            entry = json.loads(line)
            for field in ("signature", "volume", "boundary", "cusps", "homology", "cells", "name"):
                self.assertIn(field, entry)

    def test_show_and_list(self):
        self.assertEqual(run_json("census", "show", "fmp3_151")[1]["name"], "fmp3_151")
        self.assertEqual(len(run_json("census", "list")[1]["manifolds"]), 151)



# Five tetrahedra round one edge: census gluings --tetrahedra 5 --orientable --links 5 --min-valence 30, the first.
FIVE = "fLAMcabcdeejjbdds"


class Identify(unittest.TestCase):
    def test_manifolds_are_chosen_by_what_they_are(self):
        # Frigerio, Martelli, Petronio 2004, tables of the compact manifolds and of those with cusps.
        for tetrahedra, options, count in ((4, ("--boundary", "4"), 2340), (4, ("--boundary", "3", "--cusps", "0"), 2034),
                                           (4, ("--boundary", "2", "--cusps", "0"), 628), (4, ("--cusps", "1"), 30),
                                           (4, ("--cusps", "2"), 1), (4, (), 5033), (2, (), 8), (3, ("--boundary", "3"), 74),
                                           (3, ("--volume", "10.42..10.43"), 74), (3, ("--volume", "..9"), 77),
                                           (3, ("--volume", "9.."), 74), (2, ("--homology", "Z^2"), 8),
                                           (2, ("--homology", "Z^2+Z/3"), 0), (4, ("--boundary", "2,2"), 0)):
            status, found = run_json("census", "list", "--tetrahedra", str(tetrahedra), "--count", *options)
            self.assertEqual((status, found["count"]), (0, count), options)
            every = run_json("census", "list", "--tetrahedra", str(tetrahedra), *options)[1]
            self.assertEqual((every["count"], len(every["manifolds"])), (count, count))
        for options in (("--volume", "9"), ("--volume", ".."), ("--volume", "a..b"), ("--boundary", "1"), ("--boundary", "x"),
                        ("--boundary", "2,"), ("--cusps", "-1")):
            self.assertEqual(run("census", "list", *options).returncode, 2, options)
        self.assertEqual(run_json("census", "identify", "eLAkbcbdddhjhk")[1]["name"], "fmp4_1")

    def test_tables_in_one_file(self):
        with tempfile.TemporaryDirectory() as folder:
            file, lines = os.path.join(folder, "census.sqlite"), os.path.join(folder, "three.jsonl")
            self.assertEqual(run("census", "enumerate", "--tetrahedra", "3", "--brief", "-o", lines).returncode, 0)
            packed = os.path.join(folder, "three.jsonl.xz")
            with open(lines, "rb") as plain, lzma.open(packed, "wb") as xz:
                xz.write(plain.read())
            status, made = run_json("census", "table", packed, f"{SOURCE}/census/fmp4.json", "-o", file)
            self.assertEqual((status, made["manifolds"]), (0, 151 + 5033))
            # Others read it: Python's own SQLite counts as Frigerio, Martelli and Petronio do.
            with contextlib.closing(sqlite3.connect(file)) as db:
                rows = db.execute("select boundary, count(*) from manifold where tetrahedra = 4 and cusps = 0 group by boundary")
                self.assertEqual(dict(rows), {"[2]": 628, "[3]": 2034, "[4]": 2340})
                self.assertEqual(db.execute("pragma integrity_check").fetchall(), [("ok",)])
            # A file holds what it holds; only what is asked for is left out.
            for options, count in ((("--tetrahedra", "4", "--boundary", "2", "--cusps", "0"), 628), (("--tetrahedra", "3"), 151),
                                   ((), 151 + 5033)):
                self.assertEqual(run_json("census", "list", "--table", file, "--count", *options)[1]["count"], count, options)
            for table, options in ((file, ("--tetrahedra", "3")), (packed, ()), (lines, ())):
                self.assertEqual(run_json("census", "list", "--table", table, "--count", "--volume", "10.42..", *options)[1]["count"], 74)
            brief = run_json("census", "list", "--table", file, "--tetrahedra", "3")[1]["manifolds"]
            for entry, stored in zip(brief, run_json("census", "list")[1]["manifolds"]):
                del stored["dihedral_angles"]
                self.assertEqual(entry, stored)
            # One entry tells more than a list: what canonize says of the same manifold.
            canonized = run_json("canonize", "fmp3_17")[1]
            more = {key: canonized[key] for key in ("isometry_group", "amphichiral")}
            more["structure"] = run_json("census", "show", "fmp3_17")[1]["structure"]
            for table in (file, packed):
                self.assertEqual(run_json("census", "show", "fmp3_17", "--table", table)[1], {**brief[16], **more})
            with contextlib.closing(sqlite3.connect(file)) as db:
                self.assertEqual(db.execute("select symmetry_group, amphichiral from manifold where name = 'fmp3_17'").fetchall(),
                                 [(more["isometry_group"], int(more["amphichiral"]))])
                # An isometry that reverses orientation has an even order.
                self.assertEqual(db.execute("select count(*) from manifold where amphichiral and symmetries % 2").fetchall(), [(0,)])
            self.assertEqual(run("census", "show", "fmp2_1", "--table", file).returncode, 2)
            self.assertEqual(run_json("census", "identify", "fmp3_17", "--table", file)[1]["name"], "fmp3_17")
            for bad in (("census", "table", lines, lines, "-o", os.path.join(folder, "x")), ("census", "table", file, "-o", file),
                        ("census", "list", "--table", os.path.join(folder, "none")),
                        ("census", "table", lines, "-o", os.path.join(folder, "none", "x"))):
                done = run(*bad)
                self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), bad)
            self.assertEqual(sorted(os.listdir(folder)), ["census.sqlite", "three.jsonl", "three.jsonl.xz"])

    def test_an_entry_is_shown_with_its_certified_structure(self):
        # fmp3_25 has the one cusp of three tetrahedra, a torus of equilateral triangles: shape (1 + i sqrt 3) / 2.
        entry = run_json("census", "show", "fmp3_25")[1]
        structure = entry["structure"]
        self.assertTrue(structure["certified"])
        self.assertTrue(float(structure["volume_interval"][0]) <= float(entry["volume"]) <= float(structure["volume_interval"][1]))
        (real, imaginary), = (cusp["shape_interval"] for cusp in structure["cusps"])
        self.assertTrue(Fraction(real[0]) <= Fraction(1, 2) <= Fraction(real[1]))
        self.assertTrue(Fraction(imaginary[0]) ** 2 <= Fraction(3, 4) <= Fraction(imaginary[1]) ** 2)
        # The certificate is the one that anybody can make and check.
        with tempfile.TemporaryDirectory() as folder:
            made = os.path.join(folder, "made.cert.json")
            self.assertEqual(run_json("hyperbolize", "fmp3_25", "--certify", "-o", made)[1]["certificate"], structure["certificate"])
            self.assertEqual(run("verify", made).returncode, 0)
        # A cusp with the section of a Klein bottle.
        shown = run_json("census", "show", "tetn3_43")[1]
        self.assertEqual(([c["type"] for c in shown["structure"]["cusps"]], shown["cusps"], shown["klein_cusps"]),
                         (["Klein bottle"], 1, 1))
        self.assertEqual(run_json("census", "show", "tetn3_1")[1]["structure"]["cusps"], [])

    def test_manifolds_that_are_not_orientable(self):
        with tempfile.TemporaryDirectory() as folder:
            work, made, merged = (os.path.join(folder, name) for name in ("work", "made.json", "merged.json"))
            job = ("--tetrahedra", "2", "--nonorientable", "-o")
            self.assertEqual(run("census", "enumerate", "--work", work, *job, made).returncode, 0)
            self.assertEqual(run("census", "merge", work, *job, merged).returncode, 0)
            tables = []
            for path in (made, merged, f"{SOURCE}/census/tetn2.json"):
                with open(path, "rb") as file:
                    tables.append(file.read())
            self.assertEqual(tables[0], tables[1])
            self.assertEqual(tables[0], tables[2])
            # What was done for one table is no work for the other.
            done = run("census", "merge", work, "--tetrahedra", "2", "-o", merged)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        status, valid = run_json("census", "validate", "--nonorientable", "--tetrahedra", "2")
        self.assertEqual((status, valid["rebuilt"], valid["manifolds"]), (0, True, 14))
        listed = run_json("census", "list", "--nonorientable", "--boundary", "4k", "--cusps", "1")[1]
        # Regina says of nine of the gluings that the links are a surface of Euler characteristic -2 and one of 0.
        self.assertEqual((listed["count"], {m["orientable"] for m in listed["manifolds"]}), (9, {False}))
        self.assertEqual(run_json("census", "list", "--boundary", "4k")[1]["count"], 0)
        for options in ((), ("--nonorientable",)):
            count = run_json("census", "list", "--table", f"{SOURCE}/census/tetn2.json", *options)[1]["count"]
            self.assertEqual(count, 14, options)
        self.assertEqual(run_json("census", "identify", listed["manifolds"][3]["signature"])[1]["name"], "tetn3_46")
        self.assertFalse(run_json("info", "tetn3_46")[1]["orientable"])
        for bad in ("2k", "k", "3kk", "-3"):
            self.assertEqual(run("census", "list", "--boundary", bad).returncode, 2, bad)

    def test_a_table_is_what_its_name_says(self):
        work = ("census", "merge", f"{SOURCE}/tests/data/census_work.records", "--tetrahedra", "2")
        with tempfile.TemporaryDirectory() as folder:
            for job in (("census", "enumerate", "--tetrahedra", "2"), work):
                texts = []
                for name in ("two.json", "two.jsonl", "two.json.xz", "two.JSONL.XZ"):
                    path = os.path.join(folder, name)
                    self.assertEqual(run(*job, "-o", path).returncode, 0, name)
                    with open(path, "rb") as file:
                        texts.append(file.read())
                    for options, count in (((), 8), (("--tetrahedra", "2"), 8), (("--tetrahedra", "3"), 0), (("--nonorientable",), 0)):
                        self.assertEqual(run_json("census", "list", "--table", path, "--count", *options)[1]["count"], count, options)
                self.assertEqual([lzma.decompress(text) for text in texts[2:]], texts[:2])
                self.assertEqual(len(texts[1].splitlines()), 9)  # a heading and a line each
                self.assertEqual(len(json.loads(texts[0])["manifolds"]), 8)
        # Refused before the work: five tetrahedra take minutes, and nobody asked whether there is such a folder of records.
        for job in (("census", "enumerate", "--tetrahedra", "5"), ("census", "merge", "none", "--tetrahedra", "5")):
            for path, word in (("x.xz", "extension"), ("x.csv", "extension"), ("x", "extension"), ("no/x.json", "no/x.json")):
                done = run(*job, "-o", path)
                self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), path)
                self.assertIn(word, done.stderr)

    def test_gluings_come_as_they_are_found(self):
        job = subprocess.Popen([PROGRAM, "census", "gluings", "--tetrahedra", "7"], stdout=subprocess.PIPE)  # hours
        self.assertEqual([job.stdout.readline()[:1] for _ in range(100)], [b"h"] * 100)
        with open(f"/proc/{job.pid}/status", encoding="ascii") as status:
            peak = next(int(line.split()[1]) for line in status if line.startswith("VmHWM"))
        job.kill()
        job.communicate()
        if not INSTRUMENTED:
            self.assertLess(peak, 400_000)  # kB

    def test_ones_own_table(self):
        with tempfile.TemporaryDirectory() as folder:
            table = os.path.join(folder, "own.json")
            with open(f"{SOURCE}/census/fmp3.json", encoding="utf-8") as file:
                text = json.load(file)
            # A manifold of five tetrahedra that no table holds: one's own file is the only one.
            small = os.path.join(folder, "small.sqlite")
            self.assertEqual(run("census", "table", f"{SOURCE}/census/fmp3.json", "-o", small).returncode, 0)
            self.enterContext(unittest.mock.patch.dict(os.environ, TETRARCH_CENSUS=small))
            found = run_json("census", "identify", FIVE)[1]
            self.assertIsNone(found["name"])
            entry = {**text["manifolds"][0], "name": "mine", "signature": found["signature"],
                     "canonical_signature": found["isometry_signature"]}
            del entry["dihedral_angles"]
            with open(table, "w", encoding="utf-8") as file:
                json.dump({**text, "tetrahedra": 5, "manifolds": [entry]}, file)
            self.assertEqual(run_json("census", "identify", FIVE, "--table", table)[1]["name"], "mine")
            with open(table, "a", encoding="utf-8") as file:
                file.write("more")
            self.assertEqual(run("census", "identify", FIVE, "--table", table).returncode, 2)

    def test_a_census_that_is_killed_goes_on(self):
        with tempfile.TemporaryDirectory() as folder:
            def enumerate_in(work, *more):
                return (PROGRAM, "census", "enumerate", "--tetrahedra", "3", "--work", os.path.join(folder, work), *more)

            def count(work):
                with open(os.path.join(folder, work, "records"), "rb") as file:
                    return file.read().count(b"\n")

            table = os.path.join(folder, "table.json")
            killed = 0
            for delay in [0.02 * k for k in range(1, 40)]:
                job = subprocess.Popen([*enumerate_in("a", "--resume"), "-o", table], stderr=subprocess.DEVNULL,
                                       stdout=subprocess.DEVNULL)
                try:
                    job.wait(delay)
                    break
                except subprocess.TimeoutExpired:
                    job.kill()
                    job.wait()
                    killed += 1
            self.assertGreater(killed, 0)
            self.assertEqual(run(*enumerate_in("a", "--resume")[1:], "-o", table).returncode, 0)  # where all were killed
            with open(table, "rb") as new, open(f"{SOURCE}/census/fmp3.json", "rb") as old:
                expected = old.read()
                self.assertEqual(new.read(), expected)
            done = count("a")
            self.assertEqual(run(*enumerate_in("a", "--resume")[1:]).returncode, 0)
            self.assertEqual(count("a"), done)  # nothing was done twice
            self.assertIn("holds records already", run(*enumerate_in("a")[1:]).stderr)
            for k in (1, 2, 3):
                self.assertEqual(run(*enumerate_in(f"s{k}", "--shard", f"{k}/3")[1:]).returncode, 0)
            folders = [os.path.join(folder, f"s{k}") for k in (3, 1, 2)]
            self.assertEqual(run("census", "merge", *folders, "--tetrahedra", "3", "-o", table).returncode, 0)
            with open(table, "rb") as new:
                self.assertEqual(new.read(), expected)
            self.assertIn("missing from these folders", run("census", "merge", *folders[1:], "--tetrahedra", "3").stderr)
            # Records without angles are others: they are merged as such alone.
            self.assertEqual(run(*enumerate_in("brief", "--brief")[1:]).returncode, 0)
            self.assertEqual(run("census", "merge", os.path.join(folder, "brief"), "--tetrahedra", "3").returncode, 2)
            merged = run("census", "merge", os.path.join(folder, "brief"), "--tetrahedra", "3", "--brief").stdout
            self.assertEqual(len(merged.splitlines()), 151)
            self.assertNotIn("angles", merged)
            brief = run("census", "enumerate", "--tetrahedra", "2", "--brief").stdout
            self.assertNotIn("angles", brief)
            for bad in (("--shard", "0/3", "--work", folder), ("--shard", "4/3", "--work", folder), ("--shard", "1", "--work", folder),
                        ("--shard", "1/2"), ("--resume",), ("--work", table), ("--work", "/proc/none")):
                self.assertEqual(run("census", "enumerate", "--tetrahedra", "2", *bad).returncode, 2, bad)

    def test_a_census_manifold_comes_back_from_a_mesh(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "large.json")
            status, made = run_json("subdivide", "fmp3_17", "--finite", "--barycentric", "1", "--one-four", "-o", path)
            # By hand: 28 pieces of each truncated tetrahedron, four triangles; times 24 and 6; times 4.
            self.assertEqual(status, 0)
            self.assertEqual((made["input_tetrahedra"], made["tetrahedra"], made["boundary_faces"]),
                             (3, 3 * 28 * 24 * 4, 3 * 4 * 6))
            status, found = run_json("census", "identify", path)
            shown = run_json("census", "show", "fmp3_17")[1]
            self.assertEqual((status, found["name"], found["by"]), (0, "fmp3_17", "isometry signature"))
            self.assertEqual(found["isometry_signature"], shown["canonical_signature"])
            self.assertAlmostEqual(found["volume"], float(shown["volume"]), delta=1e-10)
            self.assertIn("simplified from 8,064 to 3 tetrahedra", found["tried"])
            solved = run_json("hyperbolize", found["signature"])[1]
            self.assertAlmostEqual(found["volume"], solved["volume"], delta=1e-10)

    def test_without_a_structure(self):
        # S^3 as the boundary of a 4-simplex (Regina's example).
        status, found = run_json("census", "identify", "fvPQccdedeegovcfb")
        self.assertEqual((status, found["name"], found["volume"], found["isometry_signature"]), (0, "S^3", None, None))

    def test_nothing_found_says_what_was_tried(self):
        # The trefoil complement (Regina's example): Seifert fibred.
        status, found = run_json("census", "identify", "cPcbbbadu", "--attempts", "20")
        self.assertEqual((status, found["name"], found["by"]), (4, None, None))
        self.assertIn("no structure found on 20 triangulations", " ".join(found["tried"]))

    def test_bad_input(self):
        with tempfile.TemporaryDirectory() as folder:
            for arguments in (["subdivide", "cPcbbbihq", "-o", "a.xyz"],
                              ["subdivide", "cPcbbbihq", "--barycentric", "5", "-o", "a.json"],
                              ["census", "identify", "baa", "--attempts", "0"], ["census", "identify", "nothing.json"]):
                done = run(*arguments, cwd=folder)
                self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), arguments)
            self.assertEqual(os.listdir(folder), [])


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


class BadInput(unittest.TestCase):
    """Each: exit status 2, one line that names place and cause, nothing on standard output, nothing written."""

    def refuse(self, content, *wanted, name="bad.json"):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, name)
            with open(path, "wb") as f:
                f.write(content if isinstance(content, bytes) else content.encode())
            done = run("convert", name, "-o", "out.json", cwd=folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertLess(len(done.stderr), 400)
            for text in (name, *wanted):
                self.assertIn(text, done.stderr)
            self.assertEqual(os.listdir(folder), [name])

    def document(self, gluings, **changes):
        return json.dumps({"format": "tetrarch-triangulation", "version": 1, "tetrahedra": len(gluings),
                           "gluings": gluings, **changes}, indent=1)

    def test_an_empty_file(self):
        self.refuse("", "empty")

    def test_a_truncated_json(self):
        self.refuse(self.document([[None] * 4])[:60])

    def test_a_wrong_version(self):
        self.refuse(self.document([[None] * 4], version=99), "99")

    def test_a_face_glued_twice(self):
        self.refuse(self.document([[[1, "0123"], None, None, None],
                                   [[0, "0123"], [0, "1023"], None, None]]))

    def test_a_permutation_that_is_none(self):
        self.refuse(self.document([[[1, "0122"], None, None, None], [[0, "0122"], None, None, None]]), "0122")

    def test_a_tetrahedron_out_of_range(self):
        self.refuse(self.document([[[7, "0123"], None, None, None]]), "7")

    def test_a_wrong_letter_in_a_signature(self):
        self.refuse("cPcb!bihq\n", "'!'", name="bad.sig")
        done = run("info", "cPcbb*ihq")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("\n"), 1)

    def test_a_snappea_file_cut_in_the_middle(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "m.tri")
            run("convert", "cPcbbbiht", "-o", path)
            with open(path) as f:
                text = f.read()
        self.refuse(text[:len(text) // 2], name="bad.tri")

    def test_a_hundred_megabytes_of_zeros(self):
        for zero in (b"\0", b"0"):
            before = seconds_of_children()
            self.refuse(zero * 100_000_000)
            self.assertLess(seconds_of_children() - before, 20 * SLOWER)

    def test_no_such_file(self):
        done = run("info", "no/such.file")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))

    def test_bad_usage(self):
        for arguments in (["nonsense"], ["info"], ["census", "gluings", "--tetrahedra", "0"],
                          ["census", "gluings", "--tetrahedra", "2", "--links", "x"],
                          ["hyperbolize", "cPcbbbihq", "--method", "magic"], ["census", "show", "fmp9_1"],
                          ["hyperbolize", "cPcbbbihq", "--history", "h.csv"],
                          ["census", "validate", "--tetrahedra", "5"]):
            done = run(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_an_output_folder_that_does_not_exist(self):
        done = run("convert", "cPcbbbiht", "-o", "/no/such/folder/a.json")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))


def listed_commands(text):
    return [re.split("  +", line.strip())[0] for line in text.splitlines() if line.startswith("  ")]


class Manners(unittest.TestCase):
    def test_examples_work_as_typed(self):
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(os.path.join(SOURCE, "tests"), os.path.join(folder, "tests"))  # examples read its data
            names = listed_commands(run("--help").stdout)
            self.assertIn("hyperbolize", names)
            self.assertIn("census gluings", names)
            for name in names:
                example = run(*name.split(), "--help").stdout.split("Example:")[1].split()
                self.assertEqual(example[0], "tetrarch")
                done = run(*example[1:], cwd=folder)
                self.assertIn(done.returncode, (0, 1), (example, done.stderr))

    def test_without_a_command_the_commands_are_listed_by_group(self):
        """`tetrarch`, `tetrarch help` and `tetrarch --help` alike; a group lists its own."""
        table = json.loads(run("help", "--json").stdout)["commands"]
        names = sorted(command["name"] for command in table)
        for arguments in ((), ("help",), ("--help",)):
            done = run(*arguments)
            self.assertEqual((done.returncode, sorted(listed_commands(done.stdout))), (0, names))
        text = run().stdout
        for group in {command["group"] for command in table}:
            self.assertEqual(text.count("\n" + group + "\n"), 1)
        for command in table:
            self.assertRegex(text, "(?m)^  " + command["name"] + " +" + re.escape(command["summary"]) + "$")
        for arguments in (("census",), ("help", "census"), ("census", "--help")):
            done = run(*arguments)
            self.assertEqual((done.returncode, sorted(listed_commands(done.stdout))),
                             (0, [name for name in names if name.startswith("census ")]))
        self.assertIn("unknown option '--jsno'", run("--jsno").stderr)
        self.assertEqual(run("census", "--version").returncode, 2)

    def test_version_names_the_libraries(self):
        done = run("--version")
        self.assertEqual(done.returncode, 0)
        for library in ("Boost", "Eigen", "GMP", "MPFR", "nlohmann-json", "CLI11", "pugixml", "zlib", "LZ4", "liblzma"):
            self.assertIn(library, done.stdout)
        linked = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True).stdout
        for library in ("CHOLMOD", "libedit"):
            self.assertEqual(f", {library} " in done.stdout, f"lib{library.removeprefix('lib').lower()}.so" in linked)

    def test_an_interrupted_job_leaves_no_file(self):
        with tempfile.TemporaryDirectory() as folder:
            job = subprocess.Popen([PROGRAM, "census", "gluings", "--tetrahedra", "8", "-o", "out.txt"], cwd=folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            wait_until_it_listens(job)
            time.sleep(0.5)
            job.send_signal(signal.SIGINT)
            job.communicate(timeout=60)
            self.assertEqual(job.returncode, 130)
            self.assertEqual(os.listdir(folder), [])

    def test_threads_and_locale_change_nothing(self):
        plain = run("hyperbolize", "fmp3_20", "--threads", "1").stdout
        german = run("hyperbolize", "fmp3_20", "--threads", "2", env={**os.environ, "LC_ALL": "de_DE.UTF-8"}).stdout
        self.assertEqual(plain, german)


class Errors(unittest.TestCase):
    def test_errors_are_json_where_results_are(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "bad.off")
        with open(path, "w", encoding="utf-8") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n")
        done = run("check", path, "--json")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        error = json.loads(done.stderr)["error"]
        self.assertEqual((error["code"], error["file"], error["line"]), ("bad_content", path, 4))
        self.assertIn("'zero'", error["message"])
        codes = {("info", "nonsense"): "unknown_name", ("info", "--bogus"): "bad_option", ("info", "m004", "--memory", "x"): "bad_option",
                 ("check", os.path.join(folder.name, "none.off")): "bad_file", ("check", "cPcbbbihq"): "bad_file", ("no_command",): "bad_option",
                 ("info", "L(6,2)"): "bad_value"}
        for words, code in codes.items():
            self.assertEqual(json.loads(run(*words, "--json").stderr)["error"]["code"], code, words)
        done = run("shell", stdin="G = group 4_1\nhyperbolize G --json\n")
        self.assertEqual(json.loads(done.stderr.splitlines()[-1])["error"]["code"], "wrong_kind", done.stderr)
        for words in (["info", "nonsense"], ["info", "--bogus"], ["no_command"]):
            done = run(*words, "--json")
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIsNone(json.loads(done.stderr)["error"]["file"])


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


class Slit(InFolder):
    def setUp(self):
        super().setUp()
        self.ring = os.path.join(SOURCE, "tests/data/mesh/ring_two_holes.off")

    def refused(self, *arguments):
        """The one line on standard error of a command that must fail with 2 and write nothing."""
        before = sorted(os.listdir(self.folder.name))
        done = run("slit", *arguments, "-o", self.path("never.obj"))
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual((done.stderr.count("\n"), done.stdout), (1, ""), done.stderr)
        self.assertEqual(sorted(os.listdir(self.folder.name)), before)
        return done.stderr

    def test_three_domains_of_one_map(self):
        found = {d: run_json("slit", self.ring, "--domain", d)[1] for d in ("cylindric", "parallel", "concentric")}
        ring = found["concentric"]
        self.assertEqual([b["edges"] for b in ring["boundaries"]], [41, 14, 11])  # as the file was made
        self.assertEqual(run("slit", self.ring).stderr, "")
        self.assertAlmostEqual(ring["radii"]["inner"], math.exp(-ring["modulus"]), delta=1e-15)
        for domain, made in found.items():
            self.assertEqual((made["domain"], made["outer"], made["inner"], made["flipped"]), (domain, 0, 1, 0))
            self.assertEqual(made["modulus"], ring["modulus"])
            self.assertLessEqual(made["modulus_bounds"][0], made["modulus_bounds"][1])
            self.assertLess(max(made["residuals"].values()), 1e-10)
            (slit,), (other,) = made["slits"], ring["slits"]
            self.assertEqual([slit[k] for k in ("loop", "start", "end")], [other[k] for k in ("loop", "start", "end")])
            if domain != "concentric":
                self.assertAlmostEqual(slit["height"], -math.log(other["radius"]), delta=1e-14)

    def test_loops_by_number_and_by_vertex(self):
        _, listed = run_json("slit", self.ring, "--list-loops")
        first = ["v%d" % b["vertex"] for b in listed["boundaries"]]
        self.assertEqual([b["length"] for b in listed["boundaries"]],
                         [b["length"] for b in run_json("check", self.ring)[1]["boundary_loops"]])
        _, by_vertex = run_json("slit", self.ring, "--outer", first[2], "--inner", first[0])
        _, by_number = run_json("slit", self.ring, "--outer", "2", "--inner", "0")
        _, back = run_json("slit", self.ring, "--outer", "0", "--inner", "2")
        self.assertEqual(by_vertex["slits"], by_number["slits"])
        self.assertEqual((by_vertex["outer"], by_vertex["inner"]), (2, 0))
        # Turned inside out, a ring has the same modulus.
        self.assertAlmostEqual(back["modulus"], by_number["modulus"], delta=1e-12)
        # A surface of any type has its loops listed.
        self.assertEqual(run("slit", os.path.join(SOURCE, "tests/data/mesh/torus.off"), "--list-loops").stdout, "no boundary\n")

    def test_files(self):
        with open(self.ring, encoding="utf-8") as file:
            vertices, triangles, _ = (int(x) for x in file.read().split()[1:4])
        for domain in ("cylindric", "parallel", "concentric"):
            names = {e: self.path(domain + "." + e) for e in ("obj", "vtu", "svg", "glb", "ply")}
            done = run("slit", self.ring, "--domain", domain, *(a for path in names.values() for a in ("-o", path)))
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(names["obj"], encoding="utf-8") as file:
                lines = [line.split() for line in file]
            self.assertEqual([sum(w[0] == k for w in lines) for k in ("v", "f")], [vertices, triangles])
            textures = [[float(x) for x in w[1:]] for w in lines if w[0] == "vt"]
            self.assertEqual(len(textures) > vertices, domain != "concentric")
            self.assertTrue(all(-1e-12 <= v <= 1 + 1e-12 for _, v in textures))
            self.assertEqual(run_json("check", names["obj"])[1]["type"], run_json("check", self.ring)[1]["type"])
            with open(names["svg"], encoding="utf-8") as file:
                self.assertIn("<svg", file.read())
            for extension, magic in (("glb", b"glTF"), ("ply", b"ply\n"), ("vtu", b"<?xml")):
                with open(names[extension], "rb") as file:
                    self.assertTrue(file.read().startswith(magic))

    def test_bad_input(self):
        for option, value, complaint in (("--outer", "3", "no such loop"), ("--inner", "-1", "expected the number"),
                                         ("--inner", "0", "differ"), ("--outer", "v100000", "no boundary loop"),
                                         ("--outer", "v", "expected the number"), ("--outer", "1x", "expected the number"),
                                         ("--outer", "99999999999", "no such loop"), ("--domain", "spherical", "not in"),
                                         ("-o", self.path("a.xyz"), "extension"), ("-o", "/nowhere/a.obj", "no such folder")):
            self.assertIn(complaint, self.refused(self.ring, option, value))
        # In this file, vertices of the boundary come first; 174 is the last of all.
        self.assertIn("no boundary loop", self.refused(self.ring, "--outer", "v174"))

    def test_circular_domain(self):
        names = [self.path("round." + e) for e in ("obj", "svg", "html")]
        _, made = run_json("slit", self.ring, "--domain", "circular", *(a for path in names for a in ("-o", path)))
        self.assertEqual([c["loop"] for c in made["circles"]], [0, 1, 2])
        outer, inner, third = made["circles"]
        self.assertEqual((outer["center"], inner["center"]), ([0, 0], [0, 0]))
        self.assertAlmostEqual(outer["radius"], 1, delta=1e-14)
        self.assertEqual(third["center"][1], 0)
        self.assertGreater(third["center"][0] - third["radius"], inner["radius"])
        self.assertLess(made["circularity"], 1e-9)
        self.assertEqual((made["flipped"], made["converged"]), (0, True))
        with open(names[0], encoding="utf-8") as file:
            textures = [[float(x) for x in line.split()[1:]] for line in file if line.startswith("vt")]
        # The loop's circle has as many vertices as the loop, at its radius.
        on_third = [math.hypot(2 * u - 1 - third["center"][0], 2 * v - 1) for u, v in textures]
        self.assertEqual(sum(abs(r - third["radius"]) < 1e-9 for r in on_third), made["boundaries"][2]["edges"])
        with open(names[2], encoding="utf-8") as file:
            self.assertIn("tetrarch texture", file.read())

    def test_the_second_route_to_the_circular_domain(self):
        _, first = run_json("slit", self.ring, "--domain", "circular")
        _, second = run_json("slit", self.ring, "--domain", "circular", "--method", "ricci")
        self.assertEqual((second["outer"], second["inner"], second["converged"], second["flipped"]), (0, 1, True, 0))
        for a, b in zip(first["circles"], second["circles"]):
            # 286 triangles: both are a few percent off, one below and one above.
            self.assertAlmostEqual(a["radius"], b["radius"], delta=0.01)
            self.assertAlmostEqual(a["center"][0], b["center"][0], delta=0.01)
        self.assertIn("circular", self.refused(self.ring, "--method", "ricci"))

    def test_stages_and_basis(self):
        _, ring = run_json("slit", self.ring)
        files = {}
        for name, options in (("ring", []), ("0", ["--domain", "circular", "--stage", "0"]), ("1", ["--domain", "circular", "--stage", "1"])):
            path = self.path(name + ".obj")
            self.assertEqual(run("slit", self.ring, *options, "-o", path).returncode, 0)
            with open(path, encoding="utf-8") as file:
                files[name] = [[2 * float(x) - 1 for x in line.split()[1:]] for line in file if line.startswith("vt")]
        radius = ring["slits"][0]["radius"]
        on_slit = [k for k, (x, y) in enumerate(files["ring"]) if abs(math.hypot(x, y) - radius) < 1e-12]
        self.assertEqual(len(on_slit), 11)
        # Before the first opening the slit is where it was; then its vertices are on a circle.
        self.assertTrue(all(abs(math.hypot(*files["0"][k]) - radius) < 1e-9 for k in on_slit))
        self.assertFalse(any(abs(math.hypot(*files["1"][k]) - radius) < 1e-9 for k in on_slit))
        self.assertIn("the last stage is 1", self.refused(self.ring, "--domain", "circular", "--stage", "2"))
        self.assertIn("circular", self.refused(self.ring, "--stage", "0"))
        self.assertEqual(run("slit", self.ring, "--basis", "2", "-o", self.path("basis.vtu")).returncode, 0)
        self.assertIn("the last loop is 2", self.refused(self.ring, "--basis", "3"))

    def test_fingerprints(self):
        _, made = run_json("slit", self.ring, "--fingerprint", "--distance", self.ring)
        found = made["fingerprint"]
        self.assertLess(made["distance"], 1e-12)
        self.assertEqual((made["matching"], made["mirrored"]), ([0, 1, 2], False))
        self.assertEqual(sorted([found["outer"], found["inner"], found["ring"]["slits"][0]["loop"]]), [0, 1, 2])
        self.assertEqual(found["triangles"], [286 * 4 ** k for k in range(6)])
        numbers = [found["ring"]["inner_radius"], found["disk"]["inner_radius"]]
        numbers += [found["ring"]["slits"][0][k] for k in ("radius", "start", "end")]
        numbers += [found["disk"]["circles"][0][k] for k in ("x", "y", "radius")]
        self.assertTrue(all(n["error"] < 5e-4 for n in numbers), numbers)
        torus = os.path.join(SOURCE, "tests/data/mesh/double_torus.off")
        self.assertIn("two holes", self.refused(self.ring, "--distance", torus))
        # Seen from behind: the mirror image, which any three circles are equal to.
        with open(self.ring, encoding="utf-8") as file:
            lines = file.read().splitlines()
        n = int(lines[1].split()[0])
        turned = [" ".join(["3"] + line.split()[:0:-1]) for line in lines[2 + n:] if line.split()]
        behind = self.path("behind.off", "\n".join(lines[:2 + n] + turned) + "\n")
        _, mirrored = run_json("slit", self.ring, "--distance", behind, "--mirror")
        self.assertLess(mirrored["distance"], 1e-3)

    def test_long_surfaces(self):
        """Tubes of n triangles round: inverted, or NaN, when z itself was extended."""
        def tube(rings):
            points, triangles = [], []
            for i in range(rings + 1):
                points += ["%r %r %d" % (math.cos(2 * math.pi * j / 5), math.sin(2 * math.pi * j / 5), i) for j in range(5)]
            for i in range(rings):
                for j in range(5):
                    a, b = 5 * i + j, 5 * i + (j + 1) % 5
                    triangles += ["3 %d %d %d" % (a, b, b + 5), "3 %d %d %d" % (a, b + 5, a + 5)]
            return self.path("tube.off", "OFF\n%d %d 0\n" % (len(points), len(triangles)) + "\n".join(points + triangles) + "\n")
        # Linear in height: the modulus of the prism of this polygon is 2 pi height / circumference, exactly.
        around = 10 * math.sin(math.pi / 5)
        for rings in (3, 40, 600):
            code, made = run_json("slit", tube(rings), "--domain", "circular", "-o", self.path("tube.obj"))
            self.assertEqual((code, made["flipped"], made["converged"]), (0, 0, True))
            self.assertAlmostEqual(made["modulus"] / (2 * math.pi * rings / around), 1, delta=1e-9)
            self.assertAlmostEqual(math.log(made["circles"][1]["radius"]) / -made["modulus"], 1, delta=1e-9)
        self.assertEqual(made["texture"], {"scale": 0.5, "shift": 0.0})
        self.assertIn("too small for a double", self.refused(tube(700), "--domain", "circular"))
        code, made = run_json("slit", tube(700), "--domain", "parallel")
        self.assertEqual((code, made["flipped"], made["texture"]["scale"]), (0, 0, 1 / (2 * math.pi)))

    def test_needles_leave_no_nan(self):
        """A flat ring squashed to a thousand millionth: lengths of its edges leave triangles no area."""
        rows = ["%r %r 0" % (r * math.cos(j * math.pi / 4), 1e-9 * r * math.sin(j * math.pi / 4)) for r in (2, 1) for j in range(8)]
        faces = ["3 %d %d %d\n3 %d %d %d" % (j, (j + 1) % 8, 8 + j, (j + 1) % 8, 8 + (j + 1) % 8, 8 + j) for j in range(8)]
        path = self.path("squashed.off", "OFF\n16 16 0\n" + "\n".join(rows + faces) + "\n")
        self.assertIn("no area", self.refused(path, "--intrinsic", "--domain", "cylindric"))

    def test_surfaces_are_opened_first(self):
        torus = os.path.join(SOURCE, "tests/data/mesh/double_torus.off")
        _, listed = run_json("slit", torus, "--open-handles", "--list-loops")
        self.assertEqual(len(listed["boundaries"]), 4)
        lengths = [b["length"] for b in listed["boundaries"]]
        self.assertAlmostEqual(lengths[0], lengths[1], delta=1e-12)  # two banks of one cut
        code, made = run_json("slit", torus, "--open-handles", "--domain", "circular", "--unflip")
        self.assertEqual((code, made["flipped"], len(made["circles"])), (0, 0, 4))
        self.assertIn("--open-handles", self.refused(torus))
        # Vertex 147 lies inside the ring.
        _, punched = run_json("slit", self.ring, "--punch", "v147:0.2", "--list-loops")
        self.assertEqual(len(punched["boundaries"]), 4)
        _, sliced = run_json("slit", self.ring, "--slice", "150,170", "--list-loops")
        self.assertEqual(len(sliced["boundaries"]), 4)
        for option, word in (("--punch", "150"), ("--punch", "v150:-1"), ("--punch", "v150:x"), ("--slice", "a,b"), ("--slice", "1,,2")):
            self.assertIn("expected", self.refused(self.ring, option, word))
        self.assertIn("147", self.refused(self.ring, "--punch", "v147:5"))

    def test_disk(self):
        disk = self.path("fan.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 2 3\n3 0 3 4\n3 0 4 1\n")
        _, made = run_json("slit", disk, "--domain", "circular", "-o", self.path("fan.obj"))
        self.assertEqual((made["center"], made["flipped"]), (0, 0))
        self.assertIn("interior vertex", self.refused(disk, "--domain", "circular", "--center", "v1"))

    def test_quads(self):
        path = self.path("quads.obj")
        _, made = run_json("slit", self.ring, "--quads", "24", "-o", path)
        with open(path, encoding="utf-8") as file:
            lines = [line.split() for line in file]
        faces = [[int(x) for x in w[1:]] for w in lines if w[0] == "f"]
        self.assertEqual((len(faces), sum(w[0] == "v" for w in lines)), (made["quads"]["count"], made["quads"]["vertices"]))
        edges = {frozenset(e) for f in faces for e in zip(f, f[1:] + f[:1])}
        # Euler characteristic of a sphere with three holes.
        self.assertEqual(made["quads"]["vertices"] - len(edges) + len(faces), -1)
        self.assertIn("quads are written as", self.refused(self.ring, "--quads", "24", "-o", self.path("q.svg")))

    def test_quads_of_a_wanted_edge(self):
        for edge in (0.2, 0.05):
            _, made = run_json("slit", self.ring, "--quad-edge", str(edge), "-o", self.path("quads.obj"))
            # Squares of this edge would have the area of the surface: fewer quads are larger.
            area = made["quads"]["count"] * edge ** 2
            self.assertAlmostEqual(area / self.area(), 1, delta=0.15)
            self.assertLess(abs(math.log(made["quads"]["mean_edge"] / edge)), 0.3)
        self.assertIn("--quad-edge", self.refused(self.ring, "--quad-edge", "100"))
        self.assertIn("not both", self.refused(self.ring, "--quads", "24", "--quad-edge", "0.1"))

    def area(self):
        with open(self.ring, encoding="utf-8") as file:
            words = file.read().split()[1:]
        n, m = int(words[0]), int(words[1])
        points = [[float(x) for x in words[3 + 3 * k:6 + 3 * k]] for k in range(n)]
        faces = [[int(x) for x in words[3 + 3 * n + 4 * k + 1:3 + 3 * n + 4 * k + 4]] for k in range(m)]
        total = 0
        for a, b, c in ([points[v] for v in f] for f in faces):
            u, v = ([q - p for p, q in zip(a, x)] for x in (b, c))
            total += math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]) / 2
        return total

    def test_areas_for_angles(self):
        for domain in ("parallel", "concentric", "circular"):
            _, plain = run_json("slit", self.ring, "--domain", domain)
            code, made = run_json("slit", self.ring, "--domain", domain, "--balance")
            self.assertEqual((code, made["flipped"], made["balanced"]["settled"]), (0, 0, True))
            self.assertEqual(made["balanced"]["mean_area_error_before"], plain["mean_area_error"])
            self.assertLess(made["mean_area_error"], 0.8 * plain["mean_area_error"])
            self.assertGreater(made["mean_angle_error"], plain["mean_angle_error"])
            self.assertLess(made["balanced"]["energy"], made["balanced"]["energy_before"])
        # The surface is bent but a little, so that it may lie in the plane nearly as it is: its own area, all edges as long.
        path = self.path("free.obj")
        code, made = run_json("slit", self.ring, "--domain", "free", "-o", path)
        self.assertEqual((code, made["flipped"], made["crossings"]), (0, 0, 0))
        with open(path, encoding="utf-8") as file:
            lines = [line.split() for line in file]
        flat = [[float(x) / made["texture"]["scale"] for x in w[1:3]] for w in lines if w[0] == "vt"]
        faces = [[int(x.split("/")[1]) - 1 for x in w[1:]] for w in lines if w[0] == "f"]
        area = sum((flat[b][0] - flat[a][0]) * (flat[c][1] - flat[a][1]) - (flat[b][1] - flat[a][1]) * (flat[c][0] - flat[a][0])
                   for a, b, c in faces) / 2
        self.assertAlmostEqual(area / self.area(), 1, delta=0.03)
        self.assertIn("--balance", self.refused(self.ring, "--domain", "free", "--balance"))

    def test_needles_at_slit_ends(self):
        for domain in ("parallel", "concentric"):
            _, made = run_json("slit", self.ring, "--domain", domain)
            ends = made["slit_ends"]
            self.assertGreater(ends["max_quasiconformal_before"], 10)
            self.assertLess(ends["max_quasiconformal"], 5)
            self.assertLess(made["max_quasiconformal"], ends["max_quasiconformal_before"])
            self.assertEqual(made["flipped"], 0)

    def test_rectangles(self):
        path = self.path("floor.svg")
        code, made = run_json("slit", self.ring, "--domain", "rectangle", "-o", path)
        self.assertEqual((code, made["flipped"], made["converged"], len(made["holes"])), (0, 0, True, 2))
        self.assertLess(made["holonomy"], 1e-8)
        for hole in made["holes"]:
            self.assertTrue(0 < hole["left"] < hole["right"] < 1 and 0 < hole["bottom"] < hole["top"] < made["height"])
        # The same corners named, from another one on: the rectangle turned by a quarter, so that its height is inverted.
        corners = made["corners"][1:] + made["corners"][:1]
        _, turned = run_json("slit", self.ring, "--domain", "rectangle", "--corners", ",".join(map(str, corners)))
        self.assertAlmostEqual(turned["height"] * made["height"], 1, delta=0.02)
        self.assertIn("four vertices", self.refused(self.ring, "--domain", "rectangle", "--corners", "1,2,3"))
        self.assertIn("--domain rectangle", self.refused(self.ring, "--corners", "1,2,3,4"))

    def sheet(self, name, holes, parted=()):
        """A sheet of 12 by 12 squares in space without those in `holes`; vertices in `parted` are two, one for each fan."""
        index, points, triangles = {}, [], []

        def vertex(i, j, square):
            key = (i, j, square[0] >= i and square[1] < j) if (i, j) in parted else (i, j)
            if key not in index:
                index[key] = len(points)
                points.append(f"{i} {j} {(i * 7 + j * 3) % 5 * 0.05}")
            return index[key]
        for i in range(12):
            for j in range(12):
                if not any(a <= i < b and c <= j < d for a, b, c, d in holes):
                    a, b, c, d = (vertex(x, y, (i, j)) for x, y in ((i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)))
                    triangles += [f"3 {a} {b} {c}", f"3 {a} {c} {d}"]
        return self.path(name, "\n".join([f"OFF\n{len(points)} {len(triangles)} 0", *points, *triangles, ""]))

    def test_options_without_use_are_refused(self):
        disk = self.path("disk.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.4 .5 0\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")
        circular = ("--domain", "circular")
        for surface, options, word in ((self.ring, ("--mirror",), "--distance"), (self.ring, (*circular, "--center", "v3"), "--center"),
                                       (self.ring, (*circular, "--method", "ricci", "--basis", "1"), "--basis"),
                                       (self.ring, ("--domain", "rectangle", "--basis", "1"), "--basis"),
                                       (disk, (*circular, "--method", "ricci", "--center", "v4"), "--center"),
                                       (disk, (*circular, "--outer", "1"), "--outer"), (disk, (*circular, "--inner", "0"), "--inner"),
                                       (disk, (*circular, "--basis", "0"), "--basis"), (disk, (*circular, "--stage", "0"), "--stage")):
            self.assertIn(word, self.refused(surface, *options))
        # Of two surfaces the one that is wrong is named; a type takes two loops, whatever the domain.
        torus = os.path.join(SOURCE, "tests/data/mesh/torus.off")
        self.assertIn("torus.off:", self.refused(self.ring, "--distance", torus))
        self.assertIn("two holes", self.refused(disk, "--distance", self.ring, *circular))

    def test_holes_that_meet_in_a_vertex_are_one(self):
        holes = [(3, 6, 3, 6), (6, 9, 6, 9)]
        touching, apart = self.sheet("touching.off", holes), self.sheet("apart.off", holes, [(6, 6)])
        done = run("slit", touching)
        self.assertIn("split off 1 vertices", done.stderr)
        found, by_hand = (run_json("slit", path)[1] for path in (touching, apart))
        self.assertEqual([b["edges"] for b in found["boundaries"]], [48, 24])
        self.assertAlmostEqual(found["modulus"], by_hand["modulus"], delta=1e-13)
        # Elsewhere nothing is split without being asked.
        self.assertIn("--repair splits it", run("bundle", touching).stderr)

    def test_a_needle_is_named_and_mended(self):
        path = self.sheet("sheet.off", [(3, 6, 3, 6)])
        with open(path, encoding="utf-8") as file:
            lines = file.read().split("\n")
        at = {line[:4]: k for k, line in enumerate(lines)}
        lines[at["1 1 "]] = "0.000000000001 1 " + lines[at["0 1 "]][4:]  # a millionth of a millionth beside its neighbor
        needle = self.path("needle.off", "\n".join(lines))
        self.assertGreater(run_json("check", needle)[1]["counts"].get("thin", 0), 0)
        self.assertIn("repair mends it", self.refused(needle))
        status, found = run_json("slit", needle, "--repair")
        self.assertEqual((status, found["flipped"]), (0, 0))
        self.assertAlmostEqual(found["modulus"], run_json("slit", path)[1]["modulus"], delta=0.02)

    def test_bad_surfaces(self):
        self.assertIn("torus", self.refused(os.path.join(SOURCE, "tests/data/mesh/torus.off")))
        self.assertIn("disk", self.refused(self.path("disk.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")))
        two = "OFF\n6 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n3 3 4 5\n"
        self.assertIn("2 components", self.refused(self.path("two.off", two)))
        bow_tie = "OFF\n5 2 0\n0 0 0\n1 0 0\n0 1 0\n-1 0 0\n0 -1 0\n3 0 1 2\n3 0 3 4\n"
        self.assertIn("2 components", self.refused(self.path("tie.off", bow_tie)))
        with open(self.ring, encoding="utf-8") as file:
            lines = file.read().splitlines()
        vertices = int(lines[1].split()[0])
        flat, wild = list(lines), list(lines)
        # The first triangle with a vertex inside, which is moved to the middle of its other two.
        a, b, c = next(t for t in ([int(x) for x in line.split()[1:]] for line in lines[2 + vertices:]) if t[2] == max(t) and t[2] > 70)
        p, q = ([float(x) for x in lines[2 + v].split()] for v in (a, b))
        flat[2 + c] = " ".join(repr((x + y) / 2) for x, y in zip(p, q))
        self.assertIn("flat.off: triangle", self.refused(self.path("flat.off", "\n".join(flat) + "\n")))
        wild[2 + c] = "nan 0 0"
        self.assertIn("nan", self.refused(self.path("wild.off", "\n".join(wild) + "\n")))


if __name__ == "__main__":
    well = unittest.main(argv=[sys.argv[0], *sys.argv[3:]], exit=False).result.wasSuccessful()
    all_of_them = well and len(sys.argv) == 3  # more arguments: some tests only
    unused = unused_options() if all_of_them else []
    unseen = unseen_members() if all_of_them else []
    if unused:
        print("no test uses " + ", ".join(unused), file=sys.stderr)
    if unseen:
        print("no test shows " + ", ".join(unseen), file=sys.stderr)
    sys.exit(0 if well and not unused and not unseen else 1)
