# SPDX-License-Identifier: GPL-2.0-or-later
"""Options that no other test of the program uses, each with what it changes. Part of program_test.py."""
import json
import math
import os
import re
import unittest

from running import INSTRUMENTED, SOURCE, InFolder, peak_memory, run, run_json

DATA = os.path.join(SOURCE, "tests/data")
RING = os.path.join(DATA, "mesh/ring_two_holes.off")
TORUS = os.path.join(DATA, "mesh/torus.off")
KNOTTED_Y = os.path.join(DATA, "knotted_y_8k.mesh")
PLATE = os.path.join(DATA, "genus4_ridges.mesh")


class Options(InFolder):
    def read(self, name):
        with open(self.path(name), encoding="utf-8") as file:
            return file.read()

    def good(self, *arguments):
        status, found = run_json(*arguments)
        self.assertEqual(status, 0, arguments)
        return found

    def off_lines(self, surface):
        """The lines of an OFF file without its comments, and where its points and its triangles begin."""
        with open(surface, encoding="utf-8") as file:
            lines = [line for line in file.read().split("\n") if not line.startswith("#")]
        return lines, 2, 2 + int(lines[1].split()[0])

    def with_points_moved(self, surface, name, move):
        lines, start, end = self.off_lines(surface)
        moved = [" ".join(map(repr, move(*map(float, line.split())))) for line in lines[start:end]]
        return self.path(name, "\n".join(lines[:start] + moved + lines[end:]))

    def with_a_triangle_turned(self, surface, name):
        """A copy of an OFF file whose first triangle has the other orientation."""
        lines, _, first = self.off_lines(surface)
        count, a, b, c = lines[first].split()[:4]
        lines[first] = f"{count} {b} {a} {c}"
        return self.path(name, "\n".join(lines))


class CommonOptions(Options):
    def test_quiet_keeps_warnings_back(self):
        path = self.path("y.tri")  # SnapPea's format cannot hold a boundary of genus 2
        self.assertIn("warning", run("convert", "cPcbbbihq", "-o", path).stderr)
        self.assertEqual(run("convert", "cPcbbbihq", "-o", path, "--quiet").stderr, "")

    def test_a_seed_means_the_same_field_of_directions(self):
        fields = [self.good("bundle", TORUS, "--seed", str(seed))["field"] for seed in (1, 1, 2, 3)]
        self.assertEqual(fields[0], fields[1])
        self.assertTrue(fields[0] != fields[2] or fields[0] != fields[3])


class Outputs(Options):
    # What writes lines for people or for itself takes any name: these options, and the outputs of these commands.
    ANY_NAME = {"--moves", "--history", "census gluings", "census table", "diagram"}
    INPUTS = {"--boundary", "--field-file", "--log", "--table", "--values"}

    def test_they_are_tried_before_anything_is_read(self):
        seen = set()
        for command in json.loads(run("help", "--json").stdout)["commands"]:
            words = command["name"].split()
            required = ["none"] * sum(1 for argument in command["arguments"] if argument["required"])
            for option in command["options"]:
                required += [option["names"][-1], "2"] if option["required"] and option["value"] != "FILE" else []
            for option in command["options"]:
                name = option["names"][-1]
                if option["value"] != "FILE" or name in self.INPUTS:
                    continue
                needs = ["--method", "flow"] if name == "--history" else ["info"] if words == ["move"] else []
                bad = ["no/such/folder.json"] + ([] if self.ANY_NAME & {name, command["name"]} else ["x.nothing"])
                for path in bad:
                    done = run(*words, *required, *needs, name, path)
                    self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), (words, name, path))
                    self.assertIn(path, done.stderr, (words, name))
                seen.add(command["name"])
        self.assertGreater(len(seen), 20)
        self.assertIn("hex", seen)


class Triangulations(Options):
    def test_a_presentation_as_it_is_read_off(self):
        # One generator for each face outside a spanning tree, one relator for each edge: 4 - 1 and 1.
        given = self.good("group", "cPcbbbihq", "--as-given")
        self.assertEqual((len(given["generators"]), len(given["relators"])), (3, 1))
        kept = self.good("group", "< a, b | aab, b >", "--as-given")
        self.assertEqual((kept["relators"], kept["abelianized"]), (["aab", "b"], "Z/2"))
        self.assertEqual(self.good("group", "< a, b | aab, b >")["presentation"], "< a | aa >")

    def test_links_of_vertices_as_they_are_told(self):
        told = {"cPcbbbihq": "link genus 2 (ideal)", "cMcabbgqw": "link sphere"}
        for signature, link in told.items():
            line = next(l for l in run("skeleton", signature).stdout.splitlines() if l.startswith("vertex 0"))
            self.assertRegex(line, rf"^vertex 0 +{re.escape(link)}: ")

    def test_a_script_that_keeps_going(self):
        script = self.path("script.txt", "info nothing_here\ninfo cPcbbbihq\n")
        for arguments, shown in (((), False), (("--keep-going",), True)):
            done = run("shell", script, *arguments)
            self.assertEqual((done.returncode, "cPcbbbihq" in done.stdout), (2, shown))
        good = self.path("good.txt", "info cPcbbbihq\n")
        self.assertEqual(run("shell", good, "--keep-going").returncode, 0)

    def test_a_presentation_saved_is_the_same_when_read(self):
        first, second = self.path("first.json"), self.path("second.json")
        made = self.good("group", "fmp3_77", "--as-given", "-o", first)
        read = self.good("group", first, "--as-given", "--output", second)
        self.assertEqual(len(made.pop("generator_faces")), len(made["generators"]))
        self.assertEqual(read.pop("generator_faces"), [])  # a presentation has no faces
        self.assertEqual(read, made)
        self.assertEqual(self.read("first.json"), self.read("second.json"))
        self.assertEqual(len(json.loads(self.read("first.json"))["relators"]), len(made["relators"]))
        self.assertEqual(self.good("group", first)["abelianized"], self.good("info", "fmp3_77")["homology"])

    def test_what_a_group_file_says_besides_stays(self):
        said = {"format": "tetrarch-group", "version": 1, "name": "Z/2 in two letters", "generators": 2,
                "relators": [[1, 1, 2], [2]], "provenance": {"by": "hand"}, "colour": ["red", 7]}
        with open(self.path("said.json"), "w", encoding="utf-8") as file:
            json.dump(said, file)
        self.good("group", self.path("said.json"), "--as-given", "-o", self.path("kept.json"))
        self.assertEqual(json.loads(self.read("kept.json")), said)
        # Simplified it is another presentation of the same group.
        self.good("group", self.path("said.json"), "-o", self.path("made.json"))
        made = json.loads(self.read("made.json"))
        self.assertEqual((made["name"], made["generators"], made["relators"]), (said["name"], 1, [[1, 1]]))
        self.assertNotIn("colour", made)

    def test_a_format_for_standard_output(self):
        self.assertEqual(run("convert", "cPcbbbihq", "--to", "sig").stdout, "cPcbbbihq\n")
        self.assertTrue(run("convert", "cPcbbbiht", "--to", "tri").stdout.startswith("% Triangulation"))
        refused = run("convert", "cPcbbbiht", "--to", "obj").stderr
        for choice in ("json", "tri", "sig", "fmp"):
            self.assertIn(choice, refused)

    def test_moves_written_down_and_made_again(self):
        small, log, again = self.path("small.json"), self.path("moves.txt"), self.path("again.json")
        self.good("simplify", "gvLQQedfedffrwawrhh", "--moves", log, "--output", small, "--audit")
        self.good("move", "gvLQQedfedffrwawrhh", "--log", log, "--output", again)
        self.assertEqual(self.read("small.json"), self.read("again.json"))

    def test_listed_moves(self):
        listed = self.good("move", "cPcbbbihq", "--list", "1-4")["moves"]
        self.assertEqual(listed, ["one_four 0", "one_four 1"])

    def test_spheres_kept(self):
        # A ball: its boundary sphere is filled in, or becomes the link of a finite vertex; S^3 against a ball.
        ball = os.path.join(DATA, "mesh/meshio_medit.mesh")
        filled = self.good("truncate", ball)
        kept = self.good("truncate", ball, "--keep-spheres")
        self.assertIsNone(filled["boundary_map"][0]["vertex"])
        self.assertIsNotNone(kept["boundary_map"][0]["vertex"])

    def test_several_components_truncated(self):
        # The figure-eight knot complement, and a tetrahedron, which becomes a 3-sphere.
        two = self.path("two.json", json.dumps({
            "format": "tetrarch-triangulation", "version": 1, "tetrahedra": 3,
            "gluings": [[[1, "0132"], [1, "1302"], [1, "1023"], [1, "2031"]],
                        [[0, "0132"], [0, "1302"], [0, "1023"], [0, "2031"]], [None] * 4]}))
        made = self.good("truncate", two)
        self.assertEqual((made["connected"], made["homology"], made["finite_vertices"]), (False, "Z", 1))
        self.assertEqual([b["type"] for b in made["boundary_map"]], ["sphere", "torus"])
        self.assertEqual([b["vertex"] is None for b in made["boundary_map"]], [True, False])

    def test_an_inverted_tetrahedron_mended(self):
        with open(KNOTTED_Y, encoding="utf-8") as file:
            lines = file.read().split("\n")
        first = lines.index("Tetrahedra") + 2
        a, b, *others = lines[first].split()
        lines[first] = " ".join([b, a, *others])
        bad = self.path("bad.mesh", "\n".join(lines))
        mended = self.good("truncate", bad, "--repair")
        self.assertEqual(mended["signature"], self.good("truncate", KNOTTED_Y)["signature"])

    def test_findings_listed(self):
        bad = self.path("bad.off", "OFF\n3 3 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n3 0 1 8\n3 0 1 9\n")
        for listed in (0, 1, 3):
            found = run_json("check", bad, "--listed", str(listed))[1]
            self.assertEqual(found["counts"], run_json("check", bad)[1]["counts"])
            self.assertEqual(sum("names vertex" in json.dumps(f) for f in found["findings"]), listed)


class Structures(Options):
    # The knotted Y after a 1-4 move has a finite vertex, and carries no structure as it is.
    def setUp(self):
        super().setUp()
        self.moved = self.path("moved.json")
        self.good("move", "cPcbbbihq", "1-4", "0", "-o", self.moved)

    def test_as_given_and_elsewhere(self):
        status, found = run_json("hyperbolize", self.moved, "--as-given")
        self.assertEqual((status, found["outcome"]), (4, "not found"))
        self.assertAlmostEqual(self.good("hyperbolize", self.moved)["volume"], 6.451990270835, delta=1e-11)

    def test_attempts_are_counted(self):
        found = run_json("hyperbolize", "dLQacccjcog", "--attempts", "7")[1]
        self.assertEqual((found["attempts"], found["outcome"]), (7, "not hyperbolic"))

    def test_the_canonical_triangulation_written(self):
        path = self.path("canonical.json")
        made = self.good("canonize", self.moved, "--output", path)
        self.assertEqual(self.good("info", path)["signature"], made["isometry_signature"])

    def size(self, *options):
        path = self.path("cover.ply")
        self.assertEqual(run("embed", "cPcbbbihq", "-o", path, *options).returncode, 0)
        return os.path.getsize(path)

    def test_pictures(self):
        usual = self.size("--copies", "5")
        self.assertGreater(self.size("--copies", "5", "--chord-error", "0.0005"), usual)
        self.assertLess(self.size("--copies", "5", "--tube-radius", "0"), usual)
        self.assertLess(self.size("--copies", "5", "--outside"), usual)
        colours = []
        for colour in ("face", "word-length"):
            self.size("--copies", "5", "--color", colour)
            with open(self.path("cover.ply"), "rb") as file:
                colours.append(file.read())
        self.assertNotEqual(*colours)

    def test_copies_by_word_length(self):
        # One step across each of the 6 gluable faces, and the domain itself.
        self.assertEqual(self.good("embed", "cPcbbbihq", "--word-length", "1")["copies"]["count"], 7)

    def test_cusps_are_cut_off_where_one_says(self):
        # Area 2 and area 0.5: corners at the horosphere are at distances of ratio 2 from each other.
        pictures = []
        for area in ("0.5", "2"):
            path = self.path("cusp.obj")
            self.assertEqual(run("embed", "cPcbbbiht", "--cusp-area", area, "-o", path).returncode, 0)
            pictures.append(self.read("cusp.obj"))
            page = self.path(f"cusp{area}.html")
            self.assertEqual(run("view", "cPcbbbiht", "--cusp-area", area, "-o", page).returncode, 0)
            pictures.append(self.read(f"cusp{area}.html"))
        self.assertNotEqual(pictures[0], pictures[2])
        self.assertNotEqual(pictures[1], pictures[3])

    def test_flips_are_not_passed_over(self):
        # A square with a hole; one of its triangles is split by a point 1e-12 from its long side.
        points = [(x, y, 0) for y in range(7) for x in range(7)] + [(4.5 + 1e-12, 4.5 - 1e-12, 0)]
        faces = [face for y in range(6) for x in range(6) if (x, y) != (2, 2)
                 for a in [7 * y + x] for face in ((a, a + 1, a + 8), (a, a + 8, a + 7))]
        a, b, c = corners = (32, 33, 40)
        faces.remove(corners)
        faces += [(a, b, 49), (b, c, 49), (c, a, 49)]
        text = f"OFF\n{len(points)} {len(faces)} 0\n" + "".join("%.17g %.17g %.17g\n" % p for p in points)
        path = self.path("needle.off", text + "".join("3 %d %d %d\n" % f for f in faces))
        status, made = run_json("slit", path)
        self.assertEqual((status, made["flipped"]), (4, 1))
        status, made = run_json("slit", path, "--allow-flips")
        self.assertEqual((status, made["flipped"]), (0, 1))

    def test_memory(self):
        self.assertEqual(run("embed", "cPcbbbihq", "--copies", "1000", "--memory", "0.0001").returncode, 2)
        self.assertEqual(run("embed", "cPcbbbihq", "--copies", "1000", "--memory", "1").returncode, 0)
        self.assertEqual(run("bundle", TORUS, "--fiber", "500", "--memory", "0.001").returncode, 2)
        self.assertEqual(run("bundle", TORUS, "--fiber", "50", "--memory", "1").returncode, 0)

    @unittest.skipIf(INSTRUMENTED, "AddressSanitizer's shadow counts as memory")
    def test_a_bundle_takes_the_memory_that_it_says(self):
        # Asked with too little, it says how much it takes; the kernel says how much it took, with the program itself.
        program, size = 14e6, 60
        number = lambda i, j: i % size * size + j % size  # noqa: E731
        turn = [(math.cos(2 * math.pi * i / size), math.sin(2 * math.pi * i / size)) for i in range(size)]
        points = "".join("%r %r %r\n" % ((3 + x) * c, (3 + x) * s, y) for c, s in turn for x, y in turn)
        squares = [[number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)] for i in range(size) for j in range(size)]
        faces = "".join("3 %d %d %d\n3 %d %d %d\n" % (a, b, c, a, c, d) for a, b, c, d in squares)
        torus = self.path("torus.off", "OFF\n%d %d 0\n" % (size**2, 2 * size**2) + points + faces)
        for options in ((), ("-o", self.path("torus.json"))):
            command = ("bundle", torus, "--fiber", "16", *options)
            told = run(*command, "--memory", "0.05").stderr
            promised = float(re.search(r"about (\d+) MB would be needed", told)[1]) * 1e6
            self.assertAlmostEqual((peak_memory(*command) - program) / promised, 1, delta=0.15)


class Surfaces(Options):
    def test_repair(self):
        torus = self.with_a_triangle_turned(TORUS, "torus.off")
        self.assertEqual(run("bundle", torus).returncode, 2)
        self.assertEqual(self.good("bundle", torus, "--repair")["euler_number"], 0)
        ring = self.with_a_triangle_turned(RING, "ring.off")
        self.assertEqual(run("slit", ring).returncode, 2)
        # Up to orientation: the repaired copy may be turned over as a whole.
        self.assertAlmostEqual(self.good("slit", ring, "--repair")["modulus"], self.good("slit", RING)["modulus"],
                               delta=1e-12)
        self.assertEqual(run("register", RING, ring).returncode, 2)
        self.assertIn("max_distance", self.good("register", RING, ring, "--repair"))

    def test_a_disk_has_the_centre_that_is_wanted(self):
        square = self.path("square.off", "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n.4 .5 0\n"
                                         "3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n")
        out = self.path("disk.ply")
        self.assertEqual(run("slit", square, "--domain", "circular", "--center", "v4", "-o", out).returncode, 0)

    def test_intrinsic_triangulations_come_nearer(self):
        obtuse = self.with_points_moved(RING, "obtuse.off", lambda x, y, z: (6 * x, y, z))
        plain, intrinsic = (self.good("slit", obtuse, "--allow-flips", *options)["modulus"] for options in ((), ("--intrinsic",)))
        # Both are lower bounds of the same modulus, and Delaunay's is the better one (Rippa 1990: it has the least energy).
        self.assertLess(plain + 1e-6, intrinsic)

    def test_registration_with_loops_matched_otherwise(self):
        plain = self.good("register", RING, RING)
        self.assertEqual(plain["matching"], [0, 1, 2])
        self.assertLess(plain["max_distance"], 1e-9)
        other = self.good("register", RING, RING, "--match", "0,2,1")
        self.assertEqual(other["matching"], [0, 2, 1])
        self.assertGreater(other["max_distance"], 0.01)
        turned = self.good("register", RING, RING, "--outer", "1", "--inner", "2", "--unflip")
        self.assertEqual(turned["flipped"], 0)
        self.assertLess(turned["max_distance"], 1e-9)

    def test_surfaces_compared_where_they_are(self):
        other = self.with_points_moved(RING, "moved.off", lambda x, y, z: (x + 5, y + 5, z + 5))
        self.assertLess(self.good("register", RING, other)["max_distance"], 1e-9)
        away = self.good("register", RING, other, "--as-placed")["max_distance"]
        self.assertAlmostEqual(away, 5 * 3**0.5, delta=1e-6)


class Gluings(Options):
    def count(self, *options):
        return self.good("census", "gluings", "--tetrahedra", "2", *options)["count"]

    def test_orientable_and_not_make_all(self):
        self.assertEqual(self.count(), self.count("--orientable") + self.count("--nonorientable"))

    def test_more_is_allowed_or_less(self):
        self.assertGreater(self.count("--allow-invalid"), self.count())
        # Frigerio, Martelli, Petronio: eight manifolds of two tetrahedra, genus 2, one gluing each.
        self.assertEqual(self.count("--orientable", "--links", "2"), 8)
        self.assertGreater(self.count("--min-valence", "2"), self.count("--min-valence", "3"))

    def test_a_list_in_a_file(self):
        path = self.path("gluings.txt")
        self.assertEqual(run("census", "gluings", "--tetrahedra", "2", "--ideal", "-o", path).returncode, 0)
        self.assertEqual(self.read("gluings.txt"), run("census", "gluings", "--tetrahedra", "2", "--ideal").stdout)


class Products(Options):
    def box(self):
        """The unit cube in six tetrahedra along a diagonal, three by three by three of them, MEDIT."""
        n = 3
        number = lambda x, y, z: 1 + x + (n + 1) * (y + (n + 1) * z)
        points = [f"{x} {y} {z} 0" for z in range(n + 1) for y in range(n + 1) for x in range(n + 1)]
        tets = []
        for x, y, z in ((x, y, z) for x in range(n) for y in range(n) for z in range(n)):
            for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)):
                corner, path = [x, y, z], [number(x, y, z)]
                for axis in order:
                    corner[axis] += 1
                    path.append(number(*corner))
                if order in ((0, 2, 1), (2, 1, 0), (1, 0, 2)):
                    path[0], path[1] = path[1], path[0]
                tets.append(" ".join(map(str, path)) + " 0")
        text = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points)), *points, "Tetrahedra",
                str(len(tets)), *tets, "End"]
        return self.path("box.mesh", "\n".join(text) + "\n")

    # Vertex numbers from 0: floor z = 0 has 5, the middle of the ceiling z = 3 is 53.
    SEEDS = ("--floor", "v5", "--ceiling", "v53")
    RIMS = ("--cycle", "0,1,2,3,7,11,15,14,13,12,8,4", "--cycle", "48,49,50,51,55,59,63,62,61,60,56,52")

    def test_three_ways_to_the_same_partition(self):
        box = self.box()
        by_seeds = self.good("product", box, *self.SEEDS, "--threshold", "0.5")
        by_rims = self.good("product", box, *self.RIMS)
        for found in (by_seeds, by_rims):
            self.assertEqual((found["flipped"], found["partition"]["floor"], found["partition"]["walls"]), (0, 18, [72]))
        # A loop around at height 1, extended by more than 1 to both sides: floor and ceiling are what is beyond.
        tunnel = ("--tunnel", "16,17,18,19,23,27,31,30,29,28,24,20")
        status, found = run_json("product", box, *tunnel, "--extend", "1.1", "--anyway")
        self.assertEqual((status, found["flipped"]), (4, 4))  # corners of the box fold over, which is said
        beyond = found["partition"]
        self.assertEqual(beyond["floor"] + beyond["ceiling"] + sum(beyond["walls"]), 108)  # 6 sides, 9 squares each
        self.assertEqual(run("product", box, *tunnel, "--extend", "0.5").returncode, 2)

    def test_the_domain_is_as_wanted(self):
        box = self.box()
        square = self.good("product", box, *self.SEEDS, "--floor-map", "rectangle", "--corners", "0,3,15,12", "--height",
                           "0.25", "--outer", "v20")
        self.assertAlmostEqual(square["height"], 0.25)
        self.assertAlmostEqual(square["rectangle"]["height"], 1, delta=1e-9)  # a square, by symmetry
        self.assertEqual(square["flipped"], 0)

    def test_what_fibres_follow_and_weights(self):
        box = self.box()
        for options in (("--follow", "gradient"), ("--weights", "clamped"), ("--weights", "cotangent"), ("--anyway",)):
            found = self.good("product", box, *self.SEEDS, *options)
            self.assertEqual((found["flipped"], found["stuck_fibers"]), (0, 0))  # a straight product, by all of them

    def test_layers_of_hexahedra(self):
        found = self.good("product", PLATE, "--labels", "1,2", "--hex", "20", "--layers", "2")
        twice = self.good("product", PLATE, "--labels", "1,2", "--hex", "20", "--layers", "4")
        self.assertEqual(2 * found["hexahedra"], twice["hexahedra"])

    def test_pictures(self):
        box = self.box()
        for name, more, options in (("solid.ply", None, ()), ("domain.ply", "solid.ply", ("--show", "domain")),
                                    ("bare.ply", "solid.ply", ("--fibers", "0"))):
            self.assertEqual(run("product", box, *self.SEEDS, "-o", self.path(name), *options).returncode, 0)
            if more:
                with open(self.path(name), "rb") as one, open(self.path(more), "rb") as other:
                    self.assertNotEqual(one.read(), other.read())
        self.assertLess(os.path.getsize(self.path("bare.ply")), os.path.getsize(self.path("solid.ply")))

    def test_repair(self):
        with open(self.box(), encoding="utf-8") as file:
            lines = file.read().split("\n")
        first = lines.index("Tetrahedra") + 2
        a, b, *others = lines[first].split()
        lines[first] = " ".join([b, a, *others])
        bad = self.path("bad.mesh", "\n".join(lines))
        self.assertEqual(run("product", bad, *self.SEEDS).returncode, 2)
        self.assertEqual(self.good("product", bad, *self.SEEDS, "--repair")["flipped"], 0)

    def test_the_lattice_of_a_polycube(self):
        # The box is its own polycube: three cubes each way at step 1, and two cells along each give 6^3 in all.
        box = self.box()
        found = self.good("product", box, *self.SEEDS, "--polycube", box, "--step", "3", "--cells", "6")
        self.assertEqual(found["hexahedra"], 216)
        self.assertEqual(self.good("product", box, *self.SEEDS, "--polycube", box, "--step", "1", "--cells", "2")["hexahedra"],
                         216)


class HelpTexts(unittest.TestCase):
    def setUp(self):
        self.table = run_json("help")[1]

    def helps(self):
        for command in self.table["commands"]:
            yield command["name"], command["summary"]
            for thing in command["arguments"] + command["options"]:
                yield f"{command['name']} {thing.get('name') or thing['names'][-1]}", thing["help"]
        for option in self.table["common"]:
            yield option["names"][-1], option["help"]

    def test_one_form(self):
        for where, text in self.helps():
            self.assertTrue(text and text == text.strip() and "  " not in text, where)
            self.assertFalse(text.endswith("."), f"{where}: a full stop at the end")
            first = re.match(r"[\w']+", text).group()
            self.assertTrue(first[0].islower() or first.isupper() or first[0].isdigit() or first in ("SECOND's",),
                            f"{where} begins with a capital: {text}")

    def test_values_have_names_that_say_what_they_are(self):
        kinds = {o["value"] for c in self.table["commands"] for o in c["options"] if not o["choices"]}
        self.assertEqual(kinds - {None}, {"FILE", "SURFACE", "MESH", "LIST", "HOLE", "VERTEX", "LOOP", "F,C", "INT", "FLOAT",
                                           "TOL", "K", "DIR", "I/K", "GROUP", "A..B", "EDGES", "EDGE:N"})
        for command in self.table["commands"]:
            for option in command["options"]:
                if "--output" in option["names"]:
                    self.assertEqual(option["value"], "FILE", command["name"])

    def test_the_same_words_for_the_same_option(self):
        for option in ("--tetrahedra", "--cusp-area"):
            texts = {o["help"] for c in self.table["commands"] for o in c["options"] if option in o["names"]}
            self.assertEqual(len(texts), 1, texts)

    def test_every_command_has_an_example(self):
        for command in self.table["commands"]:
            self.assertTrue(command["example"].startswith(f"tetrarch {command['name']}"), command)
