#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The Python package beside the program, NumPy, meshio, Regina and itself.

    python_test.py PROGRAM SOURCE_DIR [unittest arguments]

The package is found by PYTHONPATH.
"""
import copy
import importlib.util
import inspect
import json
import math
import os
import pickle
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import threading
import time
import unittest
import warnings
from concurrent.futures import ThreadPoolExecutor

import numpy as np

import tetrarch as tt

PROGRAM, SOURCE = map(os.path.abspath, sys.argv[1:3])
DATA = os.path.join(SOURCE, "tests", "data")
RING = os.path.join(DATA, "mesh", "ring_two_holes.off")
SOLID = os.path.join(DATA, "knotted_y_8k.mesh")
RIDGES = os.path.join(DATA, "genus4_ridges.mesh")


def program(*words):
    """What the program prints with --json, and its status."""
    done = subprocess.run([PROGRAM, *words, "--json"], capture_output=True, text=True, check=False)
    return done.returncode, done.stdout


def sheet(n):
    """A square with two square holes, of about 2 n^2 triangles."""
    i, j = np.indices((n, n))
    kept = ~sum((abs(i - a * n) < n // 10) & (abs(j - b * n) < n // 10) for a, b in ((0.3, 0.3), (0.6, 0.7))).astype(bool)
    corner = (i * (n + 1) + j)[kept]
    triangles = np.concatenate([np.column_stack([corner, corner + n + 1, corner + n + 2]),
                                np.column_stack([corner, corner + n + 2, corner + 1])])
    points = np.column_stack([*(c.ravel() for c in np.indices((n + 1, n + 1))), np.zeros((n + 1) ** 2)])
    used, triangles = np.unique(triangles, return_inverse=True)
    return points[used], triangles.reshape(-1, 3)


class TheWishedForScript(unittest.TestCase):
    def test_ten_lines(self):
        M = tt.Manifold("m004")
        self.assertAlmostEqual(M.volume(), 2.0298832128193074, places=12)  # 2 Lobachevsky sums: Thurston's notes, 6.4
        self.assertEqual(str(tt.Manifold("m003").homology()), "Z + Z/5")   # SnapPea's census
        self.assertIn("m004", M.identify().name)
        self.assertTrue(M.is_isometric_to(tt.Manifold("4_1")))
        self.assertEqual(len([N for N in tt.census(3) if N.volume() < 11]), 151)  # Frigerio, Martelli, Petronio, table 1
        np.testing.assert_allclose(M.dihedral_angles(), math.pi / 3, atol=1e-12)  # regular ideal tetrahedra
        ring = tt.Mesh.read(RING)
        uv = tt.slit_map(ring.points, ring.triangles, domain="circular").uv
        self.assertTrue((np.hypot(*uv.T) < 1 + 1e-9).all())
        self.assertIn("<iframe", M._repr_html_())


class TheTables(unittest.TestCase):
    """A command, option or field without its Python twin fails here."""

    described = json.loads(program("help")[1])

    def test_every_command_is_a_function_with_its_options(self):
        common = [o for o in self.described["common"] if "--json" not in o["names"] and "--quiet" not in o["names"]]
        for command in self.described["commands"]:
            if command["name"] in tt.commands.NOT_IN_PYTHON:
                continue
            function = getattr(tt, command["name"].replace(" ", "_"))
            parameters = inspect.signature(function).parameters
            for argument in command["arguments"]:
                self.assertIn(argument["name"], parameters, command["name"])
                self.assertIn(argument["help"], function.__doc__)
            for option in command["options"] + common:
                name = tt.commands.keyword_name(option)
                self.assertIn(name, parameters, command["name"])
                self.assertIn(option["help"], function.__doc__)
                default = parameters[name].default
                if option["default"] is not None:
                    kind = {"FLOAT": float}.get(option["value"], str)
                    self.assertEqual(kind(default), kind(option["default"]))
                elif option["required"]:
                    self.assertIs(default, inspect.Parameter.empty)

    def test_only_the_shell_is_left_out(self):
        self.assertEqual(set(tt.commands.NOT_IN_PYTHON), {"shell"})
        with self.assertRaises(tt.PreconditionError):
            tt.run("shell")

    def test_every_field_is_an_attribute_with_its_meaning(self):
        listed = 0
        for command in self.described["commands"]:
            kind = tt.commands._result_class(command["name"])
            for field in command.get("result") or []:
                if field["name"] in tt.Result.__annotations__:
                    continue
                listed += 1
                self.assertIn(field["meaning"], getattr(kind, tt.commands.field_name(field)).__doc__)
        self.assertGreater(listed, 40)

    def test_what_the_stubs_say_of_a_field_is_so(self):
        """The annotations beside what calls give; those of the stubs, for at run time there are none."""
        with open(os.path.join(SOURCE, "tools", "python", "tetrarch", "commands.pyi"), encoding="utf-8") as file:
            stubs = file.read()
        is_of = {"int": int, "float": float, "str": str, "bool": bool, "Record": tt.Record, "None": type(None)}

        def fits(value, said):
            if said.startswith(("Optional[", "Union[")):
                inner = said.partition("[")[2][:-1]
                return value is None if said[0] == "O" and value is None else any(fits(value, one) for one in (
                    inner.split(", ") if said[0] == "U" else [inner]))
            if said.startswith("List["):
                return isinstance(value, list) and all(fits(item, said[5:-1]) for item in value)
            if said.startswith("Literal["):
                return '"%s"' % value in said[8:-1].split(", ")
            return said == "Any" or type(value) is is_of[said]

        told = set()
        ring = os.path.join(SOURCE, "tests/data/mesh/ring_two_holes.off")
        for found in (tt.info("m004"), tt.skeleton("m004"), tt.group("m004"), tt.hyperbolize("m004", certify=True), tt.canonize("m004"),
                      tt.hyperbolize("cMcabbgqw", attempts=1), tt.isometric("m003", "m004"), tt.slit(ring), tt.check(ring),
                      tt.exterior("4_1"), tt.census_list(tetrahedra=2), tt.census_show("fmp2_1"), tt.census_identify("m004")):
            body = stubs.split("class %s(Result):\n" % type(found).__name__)[1].split("\ndef ")[0].split("\nclass ")[0]
            for name, said in re.findall(r"def (\w+)\(self\) -> (.*): \.\.\.", body):
                if name in found:
                    self.assertTrue(fits(getattr(found, name), said), (type(found).__name__, name, said))
                    told.add((type(found).__name__, name))
        self.assertGreater(len(told), 100)

    def test_every_option_reaches_the_parser(self):
        plausible = {"INT": 3, "UINT": 3, "FLOAT": 0.5}
        for command in self.described["commands"]:
            if command["name"] in tt.commands.NOT_IN_PYTHON:
                continue
            arguments = ["no such thing"] * sum(a["required"] for a in command["arguments"])
            required = {tt.commands.keyword_name(o): 99 for o in command["options"] if o["required"] and o["value"] == "INT"}
            for option in command["options"]:
                value = True if option["value"] is None else option["choices"][0] if option["choices"] else plausible.get(
                    option["value"], "/tmp/none.json")
                value = [value] * option["words"] if option["words"] > 1 else value
                with self.subTest(command=command["name"], option=option["names"]):
                    try:
                        tt.run(command["name"], *arguments, **{**required, tt.commands.keyword_name(option): value})
                    except tt.InputError as error:
                        self.assertNotRegex(str(error), "(?i)unknown option|not expected|requires|arguments|could not convert")

    def test_the_stubs_are_those_of_the_table(self):
        made = subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "python", "make_stubs")], capture_output=True,
                              text=True, check=True).stdout
        with open(os.path.join(SOURCE, "tools", "python", "tetrarch", "commands.pyi"), encoding="utf-8") as file:
            self.assertEqual(file.read(), made, "tools/python/make_stubs --write was not done")
        with open(os.path.join(SOURCE, "tools", "python", "tetrarch", "__init__.py"), encoding="utf-8") as file:
            text = file.read()
        spelled = text.split("from .commands import (")[1].split(")")[0].replace(",", " ").split()
        self.assertEqual(spelled, sorted(tt.commands.functions()), "tools/python/make_stubs --write was not done")

    @unittest.skipUnless(importlib.util.find_spec("mypy"), "mypy is not installed")
    def test_types(self):
        for what in (os.path.join(SOURCE, "tools", "python", "tetrarch"), os.path.join(SOURCE, "tests", "python", "typed.py")):
            done = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--cache-dir", os.devnull, what], text=True,
                                  capture_output=True, check=False,
                                  env={**os.environ, "MYPYPATH": os.path.join(SOURCE, "tools", "python")})
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class BesideTheProgram(unittest.TestCase):
    """The same answers."""

    def same(self, words, found):
        status, text = program(*words)
        expected = json.loads(text)
        answer = found.as_dict()
        for volatile in ("seconds",):
            expected.pop(volatile, None), answer.pop(volatile, None)
        self.assertEqual(answer, expected)
        self.assertEqual({0: "yes", 1: "no", 4: "undecided"}[status], found.verdict)

    def test_examples(self):
        with tempfile.TemporaryDirectory() as folder:
            before = os.getcwd()
            os.chdir(folder)
            try:
                for command in tt.commands.table()["commands"]:
                    name = command["name"]
                    if name in tt.commands.NOT_IN_PYTHON or name in ("help", "convert", "census enumerate", "census gluings"):
                        continue
                    words = shlex.split(command["example"])[1:]
                    words = [os.path.join(os.path.dirname(tt.__file__), w) if w.startswith("samples/") else w for w in words]
                    with self.subTest(command=name):
                        found = eval(tt.commands.example_of(command), {"tt": tt})
                        if len(found):
                            self.same([w for w in words], found)
                        else:
                            self.assertTrue(found.text)
            finally:
                os.chdir(before)

    def test_lists(self):
        self.assertEqual(tt.census_gluings(tetrahedra=2, orientable=True).text,
                         subprocess.run([PROGRAM, "census", "gluings", "--tetrahedra", "2", "--orientable"], capture_output=True,
                                        text=True, check=True).stdout)
        self.assertEqual(len(tt.census_enumerate(2).records), 8)

    def test_no_and_undecided_are_values(self):
        self.assertIs(tt.Manifold("m003").is_isometric_to("m004"), False)
        self.assertEqual(tt.hyperbolize("S^3").verdict, "no")
        self.assertEqual(tt.hyperbolize("S^3", as_given=True).verdict, "undecided")
        move = tt.move("cPcbbbiht", "3-2", 0, 0, 1)
        self.assertEqual((move.verdict, bool(move)), ("no", False))

    def test_all_of_a_file(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "three.sig")
            with open(path, "w", encoding="utf-8") as file:
                file.write("cPcbbbiht\ncPcbbbihq\ndLQbcccdero\n")
            self.assertEqual([r.tetrahedra for r in tt.info(path + "#*")], [2, 2, 3])
            self.assertEqual(len(tt.Triangulation(path + "#3")), 3)
            self.assertEqual([len(T) for T in tt.open_all(path)], [2, 2, 3])

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "solved.json")
            self.assertEqual(tt.hyperbolize("m004", output=path).files, [path])
            self.assertEqual(program("info", path)[0], 0)
            with self.assertRaises(tt.InputError):
                tt.slit(RING, output=[path, path])


class Topology(unittest.TestCase):
    def test_census_agrees_with_its_entries(self):
        for tetrahedra in (2, 3):
            for M in tt.census(tetrahedra):
                self.assertAlmostEqual(M.volume(), float(M.entry.volume), places=10)
                self.assertEqual(M.homology(), M.entry.homology)
                self.assertEqual(M.isometry_signature(), M.entry.canonical_signature)
                self.assertEqual(M.symmetry_group().order(), M.entry.symmetries)

    def test_census_filters(self):
        table = tt.census(3)
        # Frigerio, Martelli, Petronio 2004: 74 of genus 3, 76 of genus 2 without a cusp, one of genus 2 with a cusp.
        self.assertEqual(len(table.filter(boundary=3)), 74)
        self.assertEqual(len(table.filter(boundary=2, cusps=0)), 76)
        self.assertEqual(len(table.filter(cusps=1)), 1)
        self.assertEqual(len(table[:10]), 10)
        self.assertEqual(table[-1].name(), table[150].name())
        self.assertEqual(len(table[7.0:8.0]), sum(7 <= float(entry.volume) <= 8 for entry in table.entries()))
        self.assertEqual(len(tt.census(3, homology=tt.AbelianGroup(3), boundary=3)), 74)
        with self.assertRaises(IndexError):
            table[151]
        with self.assertRaises(tt.InputError):
            tt.census(17)

    def test_angles_are_the_structures_own(self):
        M = tt.Manifold("fmp3_17")
        angles = M.dihedral_angles()
        self.assertFalse(angles.flags.owndata)
        self.assertFalse(angles.flags.writeable)
        self.assertEqual(angles.ctypes.data, M.structure().dihedral_angles.ctypes.data)
        with self.assertRaises(ValueError):
            angles[0, 0] = 1
        kept = angles.copy()
        del M
        np.testing.assert_array_equal(angles, kept)
        # Around each edge they add up to a full turn.
        T = tt.Manifold("fmp3_17").structure().triangulation
        sums = np.zeros(T.skeleton().num_edges)
        np.add.at(sums, T.skeleton().edge_of, kept)
        np.testing.assert_allclose(sums, 2 * math.pi, atol=1e-10)

    def test_holonomy_is_a_representation(self):
        form = np.diag([1.0, 1.0, 1.0, -1.0])
        for name in ("m004", "m003", "fmp2_1", "fmp3_25"):
            holonomy = tt.Manifold(name).holonomy()
            for matrix in holonomy.SO31:
                np.testing.assert_allclose(matrix.T @ form @ matrix, form, atol=1e-10)
            np.testing.assert_allclose(np.linalg.det(holonomy.SL2C), 1, atol=1e-10)
            for word in holonomy.group.words:
                np.testing.assert_allclose(holonomy(word), np.eye(4), atol=1e-9)
                product = np.eye(2)
                for letter in word:
                    matrix = holonomy.SL2C[abs(letter) - 1]
                    product = product @ (matrix if letter > 0 else np.linalg.inv(matrix))
                sign = np.sign(product[0, 0].real)
                np.testing.assert_allclose(sign * product, np.eye(2), atol=1e-9)

    def test_isometries_carry_gluings(self):
        M, N = tt.Manifold("m004"), tt.Manifold("4_1")
        there = N.canonical_cells().triangulation.gluings()
        for isometry in M.is_isometric_to(N, return_isometries=True):
            for t, faces in enumerate(M.canonical_cells().triangulation.gluings()):
                for f, (other, permutation) in enumerate(faces):
                    image, seen = there[isometry.tetrahedra[t]][isometry.vertices[t][f]]
                    self.assertEqual(image, isometry.tetrahedra[other])
                    self.assertEqual([seen[isometry.vertices[t][v]] for v in range(4)],
                                     [isometry.vertices[other][permutation[v]] for v in range(4)])

    def test_symmetry_groups_are_groups(self):
        for name in ("m003", "m004", "m129", "fmp2_8"):
            table = tt.Manifold(name).symmetry_group().multiplication_table()
            everyone = list(range(len(table)))
            for row in table + [list(column) for column in zip(*table)]:
                self.assertEqual(sorted(row), everyone)

    def test_moves_rename(self):
        """What a move says of names is true of the gluings: classes that stay keep their members."""
        for signature in ("cPcbbbiht", "cPcbbbihq", "dLQbcccdero", "gvLQQedfedffrwawrhh"):
            T = tt.Triangulation(signature)
            before = T.skeleton()
            for kind, place in T.moves():
                move = T.move(kind, *place)
                after = move.triangulation.skeleton()
                parts = {whole: {whole} for whole in move.edges}
                for whole, part in move.split_edges:
                    parts.setdefault(whole, {whole}).add(part)
                self.assertEqual(len(move.triangulation),
                                 sum(t >= 0 for t in move.tetrahedra) + len(move.new_tetrahedra))
                self.assertEqual(sorted([t for t in move.tetrahedra if t >= 0] + move.new_tetrahedra),
                                 list(range(len(move.triangulation))))
                for old, new in enumerate(move.tetrahedra):
                    if new < 0:
                        continue
                    for v in range(4):
                        self.assertEqual(after.vertex_of[new, v], move.vertices[before.vertex_of[old, v]], (signature, kind, place))
                    for e in range(6):
                        self.assertIn(after.edge_of[new, e], parts[move.edges[before.edge_of[old, e]]], (signature, kind, place))

    def test_truncate_and_simplify(self):
        solid = tt.Triangulation(SOLID)
        self.assertEqual(len(solid), 7709)
        self.assertEqual(solid.truncate().isoSig(), "cPcbbbihq")  # Yin, section 4.2.3
        self.assertEqual(tt.Manifold(SOLID).identify().name, "fmp2_8")
        mesh = tt.Mesh.read(SOLID)
        self.assertEqual(tt.Manifold((mesh.points, mesh.tetrahedra)).isometry_signature(), "cPcbbbihq")

    def test_groups(self):
        for name in ("m003", "m129", "fmp3_17", "L(7,2)", "T^3"):
            M = tt.Manifold(name)
            self.assertEqual(M.fundamental_group().abelianization(), M.homology())
            self.assertEqual(M.fundamental_group(simplify=False).abelianization(), M.homology())
        self.assertEqual(tt.AbelianGroup("Z/4 + Z/6"), tt.AbelianGroup(0, [2, 12]))
        self.assertNotEqual(tt.AbelianGroup("Z"), "nonsense")
        self.assertEqual(len({tt.AbelianGroup("Z/6"), tt.AbelianGroup("Z/2+Z/3")}), 1)

    def test_values_are_values(self):
        M = tt.Manifold("fmp3_17")
        for again in (pickle.loads(pickle.dumps(M)), copy.copy(M), copy.deepcopy(M)):
            self.assertEqual(again, M)
            self.assertEqual(again.name(), M.name())
            self.assertEqual(hash(again), hash(M))
        for value in (tt.census(3)[3], tt.Triangulation("cPcbbbihq"), tt.Manifold("m004").homology(), tt.hyperbolize("m004"),
                      M.fundamental_group(), tt.info("m004"), tt.Manifold("m004").symmetry_group().isometries[2]):
            again = pickle.loads(pickle.dumps(value))
            self.assertEqual(type(again), type(value))
            self.assertEqual(again, value)
        mesh = tt.slit_map(RING).mesh
        again = pickle.loads(pickle.dumps(mesh))
        np.testing.assert_array_equal(again.fields["place"].values, mesh.fields["place"].values)


class Arrays(unittest.TestCase):
    ring = tt.Mesh.read(RING)

    def maps(self, points, triangles):
        return tt.slit_map(points, triangles, domain="circular").uv

    def test_any_type_and_order(self):
        V, F = np.array(self.ring.points), np.array(self.ring.triangles)
        expected = self.maps(V, F)
        for other in (F.astype(np.int64), np.asfortranarray(F), F.astype(np.uint32), F.astype(np.uint64), F.astype(">i4"),
                      np.repeat(F, 2, axis=0)[::2], F.tolist()):
            np.testing.assert_array_equal(self.maps(V, np.asarray(other)), expected)
        for other in (np.asfortranarray(V), V.astype(">f8"), np.repeat(V, 2, axis=1)[:, ::2]):
            np.testing.assert_array_equal(self.maps(other, F), expected)
        for array in (V, F):
            array.flags.writeable = False
        np.testing.assert_array_equal(self.maps(V, F), expected)
        np.testing.assert_array_equal(tt.slit_map(V.tolist(), F.tolist(), domain="circular").uv, expected)
        np.testing.assert_allclose(self.maps(V.astype(np.float32), F), expected, atol=1e-4)

    def test_views(self):
        mesh = tt.Mesh(np.eye(3), [[0, 1, 2]])
        points = mesh.points
        self.assertFalse(points.flags.owndata or points.flags.writeable)
        self.assertEqual(points.ctypes.data, mesh.points.ctypes.data)
        del mesh
        np.testing.assert_array_equal(points, np.eye(3))

    def test_plane(self):
        self.assertEqual(tt.Mesh(np.zeros((4, 2))).points.shape, (4, 3))

    def test_findings_are_objects(self):
        V = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]])
        found = tt.check(V, np.array([[0, 2, 1, 3], [0, 1, 2, 9]]))
        kinds = {finding.kind for finding in found.findings}
        self.assertIn("index_out_of_range", kinds | {getattr(f, "name", "") for f in found.findings}, found.findings)

    def test_bundle(self):
        torus = tt.Mesh.read("samples/torus.off")
        made = tt.bundle(torus.points, torus.triangles, fiber=6)
        self.assertEqual((made.euler_number, made.fiber), (0, 6))
        self.assertEqual(made.value.homology(), "Z^3")  # the unit tangent bundle of a torus is the 3-torus

    def test_direct_product(self):
        mesh = tt.Mesh.read(RIDGES)
        made = tt.direct_product(mesh.points, mesh.tetrahedra, triangles=mesh.triangles, triangle_tags=mesh.triangle_tags,
                                 labels=(1, 2), hex=8)
        self.assertEqual(made.hexahedra.shape[1], 8)
        self.assertEqual(len(made.scaled_jacobian), len(made.hexahedra))
        self.assertAlmostEqual(float(made.scaled_jacobian.min()), made.min_scaled_jacobian, places=9)
        self.assertEqual(made.uvw.shape, made.solid.points.shape)

    def test_fingerprint(self):
        found = tt.slit_map(self.ring.points, self.ring.triangles)
        text = program("slit", RING, "--fingerprint")[1]
        self.assertEqual(found.fingerprint().as_dict(), json.loads(text))

    @unittest.skipUnless(importlib.util.find_spec("meshio"), "meshio is not installed")
    def test_meshio(self):
        import meshio

        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "solid.vtk")
            ours = tt.Mesh.read(RIDGES)
            meshio.Mesh(ours.points, ours.cells).write(path)
            theirs = meshio.read(path)
            again = tt.Mesh.read(theirs)
            np.testing.assert_array_equal(again.tetrahedra, ours.tetrahedra)
            np.testing.assert_array_equal(again.points, ours.points)
            self.assertEqual(tt.Triangulation(theirs).homology(), tt.Triangulation(RIDGES).homology())
            tagged = meshio.read(RIDGES)
            np.testing.assert_array_equal(tt.Mesh.read(tagged).triangle_tags, ours.triangle_tags)
            self.assertEqual(tt.direct_product(tagged, labels=(1, 2)).verdict, "yes")

    def test_pyvista_by_its_shape(self):
        class Grid:  # pyvista.UnstructuredGrid
            points = self.ring.points
            cells_dict = {5: np.array(self.ring.triangles)}

        class PolyData:  # pyvista.PolyData
            points = self.ring.points
            faces = self.ring.faces

        class Trimesh:
            vertices = np.array(self.ring.points)
            faces = np.array(self.ring.triangles)

        for kind in (Grid, PolyData, Trimesh):
            np.testing.assert_array_equal(tt.Mesh.read(kind()).triangles, self.ring.triangles)


class Errors(unittest.TestCase):
    def test_place(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bad.off")
            with open(path, "w", encoding="utf-8") as file:
                file.write("OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n")
            with self.assertRaises(tt.InputError) as caught:
                tt.Mesh.read(path)
            self.assertEqual((caught.exception.file, caught.exception.line, caught.exception.code), (path, 4, "bad_content"))
            self.assertIsInstance(caught.exception, ValueError)
            again = pickle.loads(pickle.dumps(caught.exception))
            self.assertEqual(str(again), str(caught.exception))
            os.remove(path)
            with self.assertRaises(tt.InputError):
                tt.Mesh.read(path)

    def test_options(self):
        for bad in (dict(attemps=3), dict(attempts="many"), dict(method="guess"), dict(as_given=3), dict(attempts=0)):
            with self.assertRaises((tt.InputError, TypeError)) as caught:
                tt.hyperbolize("m004", **bad)
            self.assertNotIn("\n", str(caught.exception))
        with self.assertRaisesRegex(TypeError, "did you mean 'attempts'"):
            tt.hyperbolize("m004", attemps=3)

    def test_not_a_manifold(self):
        with self.assertRaises(tt.InputError):
            tt.Manifold(tt.Triangulation([[None] * 4, [None] * 4]))  # two components
        with self.assertRaises(tt.PreconditionError):
            tt.Manifold("T^3").holonomy()

    def test_dashes_and_leading_blanks_are_no_options(self):
        for word in ("-x", "--json", "--", " m004x", ""):
            with self.assertRaises(tt.InputError):
                tt.info(word)

    def test_passed_over_is_a_warning(self):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            tt.Triangulation("m004(1,2)")
        self.assertTrue(issubclass(caught[0].category, tt.TetrarchWarning))
        self.assertEqual(caught[0].filename, __file__)


class Manners(unittest.TestCase):
    def interrupted(self, code):
        """Seconds from Ctrl-C to the end, where `code` says "working" before it begins."""
        child = subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        child.stdout.readline()
        time.sleep(1.5)
        start = time.monotonic()
        child.send_signal(signal.SIGINT)
        _, errors = child.communicate(timeout=60)
        self.assertIn("KeyboardInterrupt", errors)
        self.assertEqual(child.returncode, -signal.SIGINT)  # as Python ends, and no crash while it does
        return time.monotonic() - start

    def test_ctrl_c(self):
        start = "import tetrarch as tt, numpy as np\nprint('working', flush=True)\n"
        self.assertLess(self.interrupted(start + "tt.census_enumerate(5)"), 1.5)
        # In the midst of a factorization, which looks at nothing.
        self.assertLess(self.interrupted(inspect.getsource(sheet) + start + "tt.slit_map(*sheet(700))"), 1.5)

    def test_nothing_is_left_of_an_interrupted_call(self):
        code = ("import tetrarch as tt, signal, threading, time\n"
                "threading.Timer(0.5, lambda: signal.raise_signal(signal.SIGINT)).start()\n"
                "try:\n    tt.census_enumerate(5)\nexcept KeyboardInterrupt:\n    pass\n"
                "print(tt.Manifold('m004').identify().name)\n")
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60, check=True)
        self.assertIn("m004", done.stdout)

    def test_progress(self):
        seen = []
        tt.census_enumerate(3, progress=lambda stage, fraction: seen.append((stage, fraction)))
        self.assertTrue(all(isinstance(stage, str) and (fraction is None or 0 <= fraction <= 1) for stage, fraction in seen))

        class Enough(Exception):
            pass

        def stop(stage, fraction):
            raise Enough(stage)

        with self.assertRaises(Enough):
            tt.census_enumerate(5, progress=stop)
        with self.assertRaises(tt.InputError):
            tt.info("m004", progress=3)

    def test_the_lock_is_released(self):
        counted = []

        def count():
            end = time.monotonic() + 1.0
            n = 0
            while time.monotonic() < end:
                n += 1
                time.sleep(0.001)
            counted.append(n)

        with ThreadPoolExecutor(2) as pool:
            counting = pool.submit(count)
            pool.submit(tt.census_enumerate, 3)
            counting.result()
        self.assertGreater(counted[0], 100)

    def test_eight_threads_on_shared_manifolds(self):
        shared = [tt.Manifold(name) for name in ("m004", "m003", "m129", "fmp2_8", "fmp3_17")] + list(tt.census(2))
        expected = [(M.volume(), str(M.homology()), M.identify().name, M.isometry_signature()) for M in shared]
        shared = [tt.Manifold(M) for M in shared]  # nothing is found yet
        barrier = threading.Barrier(8)

        def ask(k):
            barrier.wait()
            answers = [None] * len(shared)
            for n in range(len(shared)):
                at = (n * (2 * k + 1) + k) % len(shared)
                M = shared[at]
                angles = M.dihedral_angles()
                assert angles.shape[1] == 6 and M.skeleton().num_edges > 0 and M.holonomy().SL2C.size
                answers[at] = (M.volume(), str(M.homology()), M.identify().name, M.isometry_signature())
            return answers

        for _ in range(3):
            with ThreadPoolExecutor(8) as pool:
                for answers in pool.map(ask, range(8)):
                    for answer, wanted in zip(answers, expected):
                        self.assertIn(answer, (None, wanted))

    def test_fork(self):
        tt.census_enumerate(2)  # there are workers now
        child = os.fork()
        if child == 0:
            good = len(tt.census_enumerate(2).records) == 8
            os._exit(0 if good else 1)
        self.assertEqual(os.waitpid(child, 0)[1], 0)

    def test_pools_of_processes(self):
        code = ("import multiprocessing as mp, tetrarch as tt\n"
                "if __name__ == '__main__':\n"
                "    with mp.get_context('spawn').Pool(2) as pool:\n"
                "        print(pool.map(tt.Manifold.volume, list(tt.census(2))[:4]))\n")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "pool.py")
            with open(path, "w", encoding="utf-8") as file:
                file.write(code)
            done = subprocess.run([sys.executable, path], capture_output=True, text=True, check=True, timeout=120)
        self.assertEqual(done.stdout.count("6.45199"), 4)

    def test_import_brings_little(self):
        code = ("import sys; before = set(sys.modules); import tetrarch; "
                "print(*{name.partition('.')[0] for name in set(sys.modules) - before})")
        brought = subprocess.run([sys.executable, "-S", "-c", code], capture_output=True, text=True, check=True,
                                 env={**os.environ, "PYTHONPATH": os.path.dirname(os.path.dirname(tt.__file__))}).stdout.split()
        self.assertIn("tetrarch", brought)
        for heavy in ("numpy", "asyncio", "ctypes", "subprocess", "unittest", "email", "urllib", "pydoc"):
            self.assertNotIn(heavy, brought)

    def test_eleven_manifolds(self):
        names = ["m003", "m004", "m015", "m129", "fmp2_1", "fmp2_8", "fmp3_1", "fmp3_17", "fmp3_100", "fmp3_151", "5_2"]
        # SnapPea's kernel; Frigerio, Martelli and Petronio; 5_2 and m015 are one manifold.
        volumes = [2.0298832128, 2.0298832128, 2.8281220883, 3.6638623767, 6.4519902708, 6.4519902708]
        found = [(tt.Manifold(name).volume(), tt.Manifold(name).identify().name) for name in names]
        for (volume, _), right in zip(found, volumes):
            self.assertAlmostEqual(volume, right, places=9)
        self.assertAlmostEqual(found[10][0], found[2][0], places=12)
        for (_, said), name in zip(found, [*names[:10], "m015"]):
            self.assertIn(name, said)


@unittest.skipUnless(importlib.util.find_spec("regina"), "Regina is not installed")
class BesideRegina(unittest.TestCase):
    def test_both_ways(self):
        import regina

        for M in [*tt.census(2), *tt.census(3), *(tt.Manifold(name) for name in ("m003", "m004", "m129", "L(7,2)"))]:
            T = M.triangulation()
            theirs = regina.Triangulation3.fromSnapPea(T.snapPea())
            self.assertEqual(theirs.isoSig(), T.isoSig())
            back = tt.Triangulation(theirs)
            self.assertEqual(back, T)  # with the same labels
            by_signature = regina.Triangulation3.fromIsoSig(T.isoSig())
            self.assertEqual(tt.Triangulation(by_signature).isoSig(), T.isoSig())
            self.assertEqual(theirs.countEdges(), T.skeleton().num_edges)
            self.assertEqual(M.homology().rank, theirs.homology().rank())
            self.assertEqual(list(M.homology().torsion), [int(str(theirs.homology().invariantFactor(k))) for k in
                                                          range(theirs.homology().countInvariantFactors())])

    def test_every_tenth_of_the_censuses(self):
        """Signatures, homology and, of cusped manifolds, the volumes of SnapPea's kernel; objects go both ways."""
        import regina

        compared = 0
        for census in ("cusped-hyp-or-census", "cusped-hyp-nor-census", "closed-or-census"):
            path = "/usr/share/regina-normal/examples/%s.rga" % census
            if not os.path.exists(path):
                self.skipTest("Regina's examples are not installed")
            packets = [p for p in regina.open(path).descendants() if isinstance(p, regina.PacketOfTriangulation3)]
            for theirs in packets[::10]:
                with self.subTest(census=census, manifold=theirs.label()):
                    M = tt.Manifold(theirs)
                    self.assertEqual(M.isoSig(), theirs.isoSig())
                    group = theirs.homology()
                    self.assertEqual((M.homology().rank, list(M.homology().torsion)), (group.rank(), [
                        int(str(group.invariantFactor(k))) for k in range(group.countInvariantFactors())]))
                    back = regina.Triangulation3.fromSnapPea(M.snapPea())
                    self.assertEqual(back.detail(), regina.Triangulation3(theirs).detail())
                    if census.startswith("cusped"):
                        self.assertAlmostEqual(M.volume(), regina.SnapPeaTriangulation(theirs.snapPea()).volume(), places=8)
                    compared += 1
        self.assertGreater(compared, 2800)

    def test_symmetries_of_the_canonical_triangulation(self):
        import regina

        for name in ("m003", "m004", "m015", "m129", "fmp2_8", "fmp3_17"):
            M = tt.Manifold(name)
            theirs = regina.Triangulation3.fromIsoSig(M.canonical_cells().triangulation.isoSig())
            self.assertEqual(len(list(theirs.findAllIsomorphisms(theirs))), M.symmetry_group().order())

    def test_volumes_of_the_kernel(self):
        import regina

        for name in ("m003", "m004", "m015", "m129", "4_1", "5_2"):
            M = tt.Manifold(name)
            theirs = regina.SnapPeaTriangulation(M.snapPea())
            self.assertAlmostEqual(theirs.volume(), M.volume(), places=8)
            self.assertAlmostEqual(tt.Manifold(theirs).volume(), M.volume(), places=10)

    def test_fillings(self):
        """A manifold is the filled one, or there is none."""
        import regina

        theirs = regina.SnapPeaTriangulation(tt.Manifold("m129").snapPea())
        theirs.fill(1, 4, 0)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ours = tt.Manifold(theirs)
        self.assertEqual(str(ours.homology()).replace("Z/", "Z_"), str(theirs.homologyFilled()).replace("1 ", ""))
        self.assertAlmostEqual(ours.volume(), theirs.volume(), places=8)
        with self.assertRaisesRegex(tt.InputError, "is not carried out"):
            tt.Manifold("m004(5,1)")
        with self.assertWarns(tt.TetrarchWarning):
            self.assertEqual(tt.Triangulation("m004(5,1)").num_tetrahedra(), 2)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
