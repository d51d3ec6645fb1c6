# SPDX-License-Identifier: GPL-2.0-or-later
"""What the program writes is opened by programs that are not ours, and what they write is read: Gmsh, VTK, TetGen, meshio and
Khronos' glTF validator.

Counts, labels, orientation and volume are compared. Whatever of these is not installed is left out; if all are missing, the
test is skipped.
"""
import json
import os
import shutil
import subprocess
import sys
import unittest

from running import SOURCE, InFolder, medit, run, run_json
from meshes_test import QUADS, CUBE, grid, off

try:
    import vtk
except ImportError:
    vtk = None
try:
    import meshio
except ImportError:
    meshio = None
GMSH = shutil.which("gmsh")
TETGEN = shutil.which("tetgen")


def folder_of_gltf_validator():
    """Where npm has put it: beside us, for everyone, or where NODE_PATH says; none if it is nowhere."""
    if not (shutil.which("node") and shutil.which("npm")):
        return None
    root = subprocess.run(["npm", "root", "-g"], capture_output=True, text=True, timeout=60, check=False).stdout.strip()
    places = [*os.environ.get("NODE_PATH", "").split(os.pathsep), os.path.join(SOURCE, "node_modules"), root]
    return next((p for p in places if p and os.path.isdir(os.path.join(p, "gltf-validator"))), None)


GLTF = folder_of_gltf_validator()
GENUS2 = os.path.join(SOURCE, "tests/data/mesh/double_torus.off")


def labelled(folder):
    """A cube of 2^3 cubes with its boundary as triangles of label 1 to 3 and tetrahedra of label 5 and 6, as MEDIT."""
    points, six = grid(2)
    faces = {}
    for a, b, c, d in six:
        for face in ((b, c, d), (a, d, c), (a, b, d), (a, c, b)):
            faces.setdefault(tuple(sorted(face)), []).append(face)
    skin = sorted(f[0] for f in faces.values() if len(f) == 1)
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += ["%r %r %r 0" % p for p in points]
    lines += ["Triangles", str(len(skin))] + ["%d %d %d %d" % (a + 1, b + 1, c + 1, 1 + k % 3) for k, (a, b, c) in enumerate(skin)]
    lines += ["Tetrahedra", str(len(six))] + ["%d %d %d %d %d" % (*(v + 1 for v in t), 5 + k % 2) for k, t in enumerate(six)]
    path = os.path.join(folder, "cube.mesh")
    with open(path, "w", encoding="ascii") as file:
        file.write("\n".join(lines + ["End", ""]))
    return path, len(skin), len(six)


def volume(points, tetrahedra):
    """Signed, and how many are not positive."""
    total, bad = 0, 0
    for t in tetrahedra:
        e = [[points[v][k] - points[t[0]][k] for k in range(3)] for v in t[1:]]
        det = sum(e[0][i] * (e[1][(i + 1) % 3] * e[2][(i + 2) % 3] - e[1][(i + 2) % 3] * e[2][(i + 1) % 3]) for i in range(3))
        total += det / 6
        bad += det <= 0
    return total, bad


@unittest.skipUnless(GMSH, "Gmsh is not installed")
class Gmsh(InFolder):
    def gmsh(self, *arguments):
        done = subprocess.run([GMSH, *arguments], capture_output=True, text=True, cwd=self.folder.name, timeout=120, check=False)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("Error", done.stdout + done.stderr)
        return done.stdout

    def test_our_msh_has_all_elements_and_groups(self):
        path, triangles, tetrahedra = labelled(self.folder.name)
        ours = self.path("ours.msh")
        self.assertEqual(run("convert", path, "-o", ours).returncode, 0)
        # Read and written again by Gmsh, in each of its versions, as text and bytes.
        for version in ("msh1", "msh2", "msh40", "msh4"):
            for flags in ((), ("-bin",)):
                if version in ("msh1", "msh40") and flags:  # Gmsh writes none of these
                    continue
                theirs = self.path(f"{version}{len(flags)}.msh")
                self.gmsh(ours, "-save", "-format", version, *flags, "-o", theirs)
                labels = self.labels_of(theirs)
                self.assertEqual(labels, self.labels_of(path), (version, flags))
                status, report = run_json("check", theirs)
                self.assertEqual((status, report["tetrahedra"], report["counts"]), (0, tetrahedra, {}), (version, flags))
                self.assertAlmostEqual(report["volume"], 1)
        self.assertEqual(sum(self.labels_of(path)[0].values()), triangles)

    def labels_of(self, path):
        """How many triangles and tetrahedra have each label."""
        text = run("convert", path, "--to", "mesh").stdout
        mesh = json.loads(text)
        return tuple({k: mesh[name].count(k) for k in sorted(set(mesh[name]))} for name in ("triangle_tags", "tetrahedron_tags"))

    def test_gmsh_writes_what_we_read(self):
        geo = self.path("part.geo", 'SetFactory("OpenCASCADE"); Box(1) = {0,0,0,1,1,1}; Physical Volume(10) = {1};\n'
                                    "Physical Surface(101) = {1,2}; Mesh.MeshSizeMax = 0.5;\n")
        plain = self.path("plain.msh")
        self.gmsh(geo, "-3", "-o", plain)
        whole = run_json("check", plain)[1]
        self.assertAlmostEqual(whole["volume"], 1)
        for name, flags in (("second.msh", ("-order", "2")), ("parts.msh", ("-part", "3")), ("old.msh", ("-format", "msh2", "-order", "2")),
                            ("m.mesh", ()), ("m.vtk", ()), ("b.vtk", ("-bin",)), ("parametric.msh", ("-format", "msh2", "-save_parametric"))):
            path = self.path(name)
            self.gmsh(geo, "-3", *flags, "-o", path)
            status, report = run_json("check", path)
            self.assertEqual((status, report["tetrahedra"], report["vertices"], report["fatal"]),
                             (0, whole["tetrahedra"], whole["vertices"], 0), name)
        for name in ("s.stl", "b.stl"):
            path = self.path(name)
            self.gmsh(geo, "-2", "-save_all", *(("-bin",) if name == "b.stl" else ()), "-format", name[2:], "-o", path)
            self.assertEqual(run_json("check", path)[1]["type"], "sphere", name)


@unittest.skipUnless(vtk, "VTK is not installed")
class Vtk(InFolder):
    def read(self, path):
        readers = {".vtk": vtk.vtkUnstructuredGridReader, ".vtu": vtk.vtkXMLUnstructuredGridReader, ".obj": vtk.vtkOBJReader,
                   ".ply": vtk.vtkPLYReader, ".stl": vtk.vtkSTLReader}
        reader = readers[os.path.splitext(path)[1]]()
        reader.SetFileName(path)
        reader.Update()
        return reader.GetOutput()

    def cells(self, data, size):
        return [[data.GetCell(k).GetPointId(c) for c in range(size)] for k in range(data.GetNumberOfCells())
                if data.GetCell(k).GetNumberOfPoints() == size]

    def test_our_grids(self):
        path, triangles, tetrahedra = labelled(self.folder.name)
        for name in ("c.vtk", "c.vtu"):
            ours = self.path(name)
            self.assertEqual(run("convert", path, "-o", ours).returncode, 0)
            data = self.read(ours)
            self.assertEqual(data.GetNumberOfCells(), triangles + tetrahedra, name)
            points = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
            total, bad = volume(points, self.cells(data, 4))
            self.assertEqual((round(total, 12), bad), (1, 0), name)
            label = data.GetCellData().GetArray("label")
            values = [label.GetValue(k) for k in range(label.GetNumberOfTuples())]
            self.assertEqual((values.count(5), values.count(6)), (tetrahedra // 2, tetrahedra // 2), name)

    def test_our_surfaces_and_pictures(self):
        for name in ("s.obj", "s.ply", "s.stl"):
            ours = self.path(name)
            self.assertEqual(run("convert", GENUS2, "-o", ours).returncode, 0)
            data = self.read(ours)
            count = run_json("check", GENUS2)[1]
            self.assertEqual(data.GetNumberOfPolys(), count["triangles"], name)
        solid = self.path("cube.mesh", medit(*grid(4)))
        for command in (("bundle", GENUS2, "--fiber", "3"), ("product", solid)):
            for name in ("p.obj", "p.ply", "p.vtu"):
                ours = self.path(name)
                self.assertEqual(run(*command, "-o", ours).returncode, 0, command)
                data = self.read(ours)
                if name == "p.obj":
                    with open(ours, encoding="ascii") as file:
                        faces = sum(line.startswith("f ") for line in file)
                    self.assertEqual(data.GetNumberOfPolys(), faces, command)
                elif name == "p.vtu":
                    points = [data.GetPoint(k) for k in range(data.GetNumberOfPoints())]
                    cells = self.cells(data, 4)
                    self.assertEqual(volume(points, cells)[1], 0, command)
                    self.assertGreater(len(cells), 100)
                else:
                    self.assertGreater(data.GetNumberOfPolys(), 100, command)

    def grid_of_all_shapes(self):
        """A cube of a hexahedron, beside it two wedges, above the cube a pyramid and a tetrahedron beside that."""
        points = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1), (2, 0, 0), (2, 1, 0),
                  (2, 0, 1), (2, 1, 1), (0.5, 0.5, 2), (1.5, 0.5, 2)]
        data = vtk.vtkUnstructuredGrid()
        places = vtk.vtkPoints()
        for p in points:
            places.InsertNextPoint(p)
        data.SetPoints(places)
        for kind, corners in ((vtk.VTK_HEXAHEDRON, range(8)), (vtk.VTK_WEDGE, (1, 9, 8, 5, 11, 10)), (vtk.VTK_WEDGE, (1, 2, 9, 5, 6, 11)),
                              (vtk.VTK_PYRAMID, (4, 5, 6, 7, 12)), (vtk.VTK_TETRA, (5, 6, 12, 13)), (vtk.VTK_LINE, (0, 1))):
            ids = vtk.vtkIdList()
            for v in corners:
                ids.InsertNextId(v)
            data.InsertNextCell(kind, ids)
        labels = vtk.vtkIntArray()
        labels.SetName("label")
        for k in range(6):
            labels.InsertNextValue(k + 1)
        data.GetCellData().AddArray(labels)
        words = vtk.vtkStringArray()
        words.SetName("words")
        words.InsertNextValue("two words")
        bits = vtk.vtkBitArray()
        bits.SetName("bits")
        ids = vtk.vtkIdTypeArray()
        ids.SetName("ids")
        for k in range(11):
            bits.InsertNextValue(k % 2)
            ids.InsertNextValue(k)
        for array in (words, bits, ids):
            data.GetFieldData().AddArray(array)
        return data

    def test_everything_that_vtk_writes_is_read(self):
        data = self.grid_of_all_shapes()
        files = []
        for binary in (False, True):
            for version in (42, 51):
                writer = vtk.vtkUnstructuredGridWriter()
                writer.SetFileName(self.path(f"g{binary}{version}.vtk"))
                writer.SetFileVersion(version)
                writer.SetFileTypeToBinary() if binary else writer.SetFileTypeToASCII()
                files.append(writer)
        for mode in ("Ascii", "Binary", "Appended"):
            for packing in ("None", "ZLib", "LZ4", "LZMA"):
                writer = vtk.vtkXMLUnstructuredGridWriter()
                writer.SetFileName(self.path(f"g{mode}{packing}.vtu"))
                getattr(writer, "SetDataModeTo" + mode)()
                getattr(writer, "SetCompressorTypeTo" + packing)()
                files.append(writer)
        raw = vtk.vtkXMLUnstructuredGridWriter()
        raw.SetFileName(self.path("raw.vtu"))
        raw.EncodeAppendedDataOff()
        raw.SetByteOrderToBigEndian()
        raw.SetHeaderTypeToUInt64()
        files.append(raw)
        for writer in files:
            writer.SetInputData(data)
            self.assertEqual(writer.Write(), 1)
            status, report = run_json("check", writer.GetFileName())
            # By hand: 6 + 3 + 3 + 2 + 1 tetrahedra; 1 + 1 + 1/3 in volume, and the tetrahedron's, a sixth of |det|.
            self.assertEqual((status, report["tetrahedra"], report["fatal"]), (0, 15, 0), writer.GetFileName())
            self.assertAlmostEqual(report["volume"], 2 + 1 / 3 + 1 / 6, places=6)
            self.assertEqual(report["counts"].get("folded", 0), 0, writer.GetFileName())

    def test_polydata_of_all_kinds_is_read(self):
        source = vtk.vtkCubeSource()
        strips = vtk.vtkStripper()
        triangles = vtk.vtkTriangleFilter()
        triangles.SetInputConnection(source.GetOutputPort())
        clean = vtk.vtkCleanPolyData()
        clean.SetInputConnection(triangles.GetOutputPort())
        strips.SetInputConnection(clean.GetOutputPort())
        for name, port in (("quads", source.GetOutputPort()), ("strips", strips.GetOutputPort())):
            for kind, extension in ((vtk.vtkXMLPolyDataWriter, "vtp"), (vtk.vtkPolyDataWriter, "vtk"), (vtk.vtkPLYWriter, "ply"),
                                    (vtk.vtkSTLWriter, "stl"), (vtk.vtkOBJWriter, "obj")):
                if name == "strips" and extension in ("ply", "obj"):
                    continue  # VTK writes none there
                writer = kind()
                path = self.path(f"{name}.{extension}")
                writer.SetFileName(path)
                writer.SetInputConnection(port)
                writer.Write()
                report = run_json("check", path, "--weld")[1]
                self.assertEqual((report["triangles"], report["type"]), (12, "sphere"), path)


    def grid_of_polyhedra(self, octree):
        """Two cubes side by side as polyhedra. In `octree` the second is eight small ones, so that the first has the four faces of these
        on its side."""
        data = vtk.vtkUnstructuredGrid()
        places, index = vtk.vtkPoints(), {}

        def point(p):
            if p not in index:
                index[p] = places.InsertNextPoint(p)
            return index[p]

        def box(x, y, z, size, parted=False):
            def quad(origin, u, v, step):
                return [tuple(origin[i] + a * step * u[i] + b * step * v[i] for i in range(3)) for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
            faces = []
            for axis in range(3):
                u, v = [tuple(int(i == (axis + k) % 3) for i in range(3)) for k in (1, 2)]
                for far in (0, 1):
                    origin = tuple((x, y, z)[i] + (far * size if i == axis else 0) for i in range(3))
                    steps = 2 if parted and axis == 0 and far else 1
                    step = size / steps
                    for a in range(steps):
                        for b in range(steps):
                            at = tuple(origin[i] + a * step * u[i] + b * step * v[i] for i in range(3))
                            face = quad(at, u, v, step)
                            if parted and axis != 0:  # the edges beside the parted face have a vertex in the middle
                                face = [q for k, p in enumerate(face) for q in ((p, tuple((s + t) / 2 for s, t in zip(p, face[(k + 1) % 4])))
                                        if p[0] == face[(k + 1) % 4][0] == x + size else (p,))]
                            faces.append([point(p) for p in (face if far else face[::-1])])
            stream = vtk.vtkIdList()
            stream.InsertNextId(len(faces))
            for face in faces:
                stream.InsertNextId(len(face))
                for v in face:
                    stream.InsertNextId(v)
            data.InsertNextCell(vtk.VTK_POLYHEDRON, stream)
        box(0.0, 0.0, 0.0, 1.0, octree)
        if octree:
            for k in range(8):
                box(1 + (k & 1) / 2, (k >> 1 & 1) / 2, (k >> 2) / 2, 0.5)
        else:
            box(1.0, 0.0, 0.0, 1.0)
        data.SetPoints(places)
        return data

    def test_polyhedra_are_cut(self):
        for octree in (False, True):
            data = self.grid_of_polyhedra(octree)
            writers = [vtk.vtkXMLUnstructuredGridWriter(), vtk.vtkXMLUnstructuredGridWriter()]
            writers[1].SetDataModeToAscii()
            for k, writer in enumerate(writers):
                writer.SetFileName(self.path(f"p{octree}{k}.vtu"))
            legacy = vtk.vtkUnstructuredGridWriter()
            legacy.SetFileName(self.path(f"p{octree}.vtk"))
            for writer in (*writers, legacy):
                writer.SetInputData(data)
                self.assertEqual(writer.Write(), 1)
                status, report = run_json("check", writer.GetFileName())
                # Conforming: one boundary, a sphere of area 10; nothing is turned over or flat.
                self.assertEqual((status, report["fatal"], report["boundary"]), (0, 0, [{"type": "sphere", "genus": 0}]), writer.GetFileName())
                self.assertEqual(report["counts"], {}, writer.GetFileName())
                self.assertAlmostEqual(report["volume"], 2)
                self.assertIn({"what": "polyhedron, cut into tetrahedra", "count": 9 if octree else 2}, report["passed_over"])


@unittest.skipUnless(meshio, "meshio is not installed")
class Meshio(InFolder):
    def test_labels_are_read_and_written(self):
        path, triangles, tetrahedra = labelled(self.folder.name)
        for name in ("m.msh", "m.vtk", "m.vtu", "m.mesh", "m.meshb"):
            ours = self.path(name)
            run("convert", path, "-o", ours)
            mesh = meshio.read(ours)
            self.assertEqual(sum(len(c.data) for c in mesh.cells if c.type == "tetra"), tetrahedra, name)
            self.assertEqual(sum(len(c.data) for c in mesh.cells if c.type == "triangle"), triangles, name)
            # And back, by a writer that is not ours.
            again = self.path("again_" + name)
            if name != "m.msh":
                mesh.write(again)
                report = run_json("check", again)[1]
                self.assertEqual((report["tetrahedra"], report["counts"]), (tetrahedra, {}), name)


@unittest.skipUnless(GLTF, "Khronos' glTF validator is not installed (npm install gltf-validator)")
class Gltf(InFolder):
    def test_the_validator_finds_nothing_in_what_we_write(self):
        cube, ring = self.path("cube.mesh", medit(*grid(4))), os.path.join(SOURCE, "tests/data/mesh/ring_two_holes.off")
        torus = os.path.join(SOURCE, "tests/data/mesh/torus.off")
        files = []
        for command in (("embed", "cPcbbbihq", "--copies", "20", "--model", "ball"), ("embed", "cPcbbbihq", "--model", "klein"),
                        ("embed", "cPcbbbihq", "--model", "half-space"), ("bundle", GENUS2, "--fiber", "3"),
                        ("bundle", GENUS2, "--fiber", "3", "--show", "surface"), ("bundle", torus, "--field", "0", "0", "1"),
                        ("product", cube), ("hex", cube), ("slit", ring), ("slit", ring, "--quads", "16"), ("register", ring, ring)):
            files.append(self.path(f"{len(files)}.glb"))
            done = run(*command, "-o", files[-1])
            self.assertEqual(done.returncode, 0, (command, done.stderr))
        script = self.path("validate.js", """
            const validator = require('gltf-validator'), fs = require('fs');
            Promise.all(process.argv.slice(2).map(f => validator.validateBytes(new Uint8Array(fs.readFileSync(f)))))
              .then(all => console.log(JSON.stringify(all)));""")
        done = subprocess.run(["node", script, *files], capture_output=True, text=True, timeout=120, check=True,
                              env={**os.environ, "NODE_PATH": GLTF})
        for path, report in zip(files, json.loads(done.stdout), strict=True):
            self.assertEqual((report["issues"]["numErrors"], report["issues"]["numWarnings"]), (0, 0), (path, report["issues"]["messages"]))
            self.assertGreater(report["info"]["totalTriangleCount"], 0, path)


@unittest.skipUnless(TETGEN, "TetGen is not installed")
class Tetgen(InFolder):
    def test_tetgen_refines_what_we_wrote_and_we_read_it(self):
        path, triangles, tetrahedra = labelled(self.folder.name)
        self.assertEqual(run("convert", path, "-o", self.path("t.node")).returncode, 0)
        done = subprocess.run([TETGEN, "-rq1.2a0.05A", self.path("t.ele")], capture_output=True, text=True, timeout=60, check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        report = run_json("check", self.path("t.1.node"))[1]
        self.assertAlmostEqual(report["volume"], 1)
        self.assertEqual(report["fatal"], 0)
        self.assertGreaterEqual(report["tetrahedra"], tetrahedra)
        # Of second order.
        done = subprocess.run([TETGEN, "-po2Q", self.path("cube.off", off(CUBE, QUADS))], capture_output=True, text=True, timeout=60,
                              check=False)
        self.assertEqual(done.returncode, 0, done.stdout)
        report = run_json("check", self.path("cube.1.ele"))[1]
        self.assertAlmostEqual(report["volume"], 1)
        self.assertIn("midside node", str(report["passed_over"]))


if __name__ == "__main__":
    if not (GMSH or TETGEN or vtk or meshio or GLTF):
        sys.exit(77)
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:])
