# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of manifolds, and names found in them. Part of program_test.py."""
import contextlib
import json
import lzma
import os
import sqlite3
import subprocess
import tempfile
import unittest
import unittest.mock
from fractions import Fraction

from running import INSTRUMENTED, PROGRAM, run, run_json, SOURCE


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
