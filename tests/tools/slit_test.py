# SPDX-License-Identifier: GPL-2.0-or-later
"""Conformal maps of surfaces with holes. Part of program_test.py."""
import math
import os

from running import InFolder, run, run_json, SOURCE


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
