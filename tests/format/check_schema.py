#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks documents against the schemas in census/schema.

    tests/format/check_schema.py [--program TETRARCH] [FILE.json ...]

Without files: the schemas themselves, then the fixtures in tests/data/format/good, the frozen files and the census
tables (that Tetrarch writes exactly these bytes is tested elsewhere), then variants of some of them that must be
refused. With a program: also a file of each kind that it writes now, which must come out of `convert` with the same
bytes. Exit status 77, which CTest can be told to count as skipped, where Debian's python3-jsonschema is missing.
"""
import argparse
import copy
import json
import pathlib
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FROZEN = ROOT / "tests/data/frozen/1"
KINDS = ("triangulation", "mesh", "group", "census", "certificate", "graphs")


def validators():
    """By the member "format" of a document."""
    found = {}
    for kind in KINDS:
        schema = json.loads((ROOT / f"census/schema/{kind}.schema.json").read_text())
        validator = jsonschema.validators.validator_for(schema)
        validator.check_schema(schema)
        found["tetrarch-" + kind] = validator(schema)
    return found


def changed(document, path, value):
    """A copy of the document with the value at a path replaced, or removed where the value is `...`."""
    result = copy.deepcopy(document)
    at = result
    for step in path[:-1]:
        at = at[step]
    if value is ...:
        del at[path[-1]]
    else:
        at[path[-1]] = value
    return result


FACE = ["gluings", 0, 1]
BAD = {
    ROOT / "tests/data/format/good/unknown_members.json": [
        (["format"], "other"), (["version"], 2), (["version"], ...), (["tetrahedra"], -1), (["tetrahedra"], "2"),
        (["gluings"], None), (["gluings", 0], [None, None, None]), (["name"], 3), (["provenance"], []),
        (FACE, 7), (FACE, [1]), (FACE, [-1, "0123"]), (FACE, [1, "0122"]), (FACE, [1, "0124"]), (FACE, [1, "012"]),
        (FACE, [1, "0123", 1]), (["metric", "volume"], "6,45"), (["metric", "volume"], None),
        (["metric", "edge_lengths", 0], [1, 2, 3]), (["metric", "dihedral_angles", 0, 0], None),
    ],
    FROZEN / "octahedron.json": [
        (["canonical"], []), (["canonical", "cells"], ...), (["canonical", "cells", 0], 8),
        (["canonical", "cell_of", 0], -1), (["canonical", "flat_faces", 0], [4]),
        (["canonical", "flat_faces", 0], [1, 1]), (["canonical", "isometry_signature"], 1),
    ],
    FROZEN / "bundle.json": [
        (["bundle", "fiber"], ...), (["bundle", "fiber"], 0), (["bundle", "euler_number"], "2"),
        (["bundle", "base_vertices", 0], [0, 0]), (["bundle", "base_triangles", 0], [0, 1, -1]),
        (["bundle", "triangle_of", 0], -1), (["bundle", "levels", 0], [0, 0, 0]), (["bundle", "vertices", 0], 1),
    ],
    FROZEN / "unknown_mesh_members.json": [
        (["format"], "other"), (["version"], 2), (["vertices"], ...), (["vertices", 0], [0, 0]),
        (["vertices", 0, 0], None), (["triangles", 0], [0, 1]), (["triangles", 0, 0], -1),
        (["triangle_tags", 0], 0.5), (["tetrahedra"], [[0, 1, 2]]), (["hexahedra"], [[0, 1, 2, 0]]),
        (["fields", 0, "name"], ...), (["fields", 0, "on"], "edges"), (["fields", 0, "values"], ...),
        (["fields", 0, "values", 0], "290.5"), (["fields", 0, "values", 0], [290.5]),
        (["fields", 1, "values", 0], [0, 0, 0, 0]), (["name"], 3), (["provenance"], []),
    ],
    FROZEN / "group.json": [
        (["format"], "other"), (["version"], "1"), (["generators"], -1), (["generators"], ...), (["relators"], ...),
        (["relators", 0], 1), (["relators", 0, 0], 0), (["relators", 0, 0], "a"),
    ],
    ROOT / "census/fmp2.json": [
        (["format"], "other"), (["version"], 2), (["tetrahedra"], 0), (["manifolds", 0, "name"], "m003"),
        (["manifolds", 0, "volume"], 6.45), (["manifolds", 0, "boundary"], []), (["manifolds", 0, "boundary"], [1]),
        (["manifolds", 0, "dihedral_angles", 0], ["0.5"]), (["manifolds", 0, "signature"], ...),
    ],
    ROOT / "tests/data/knotted_y.cert.json": [
        (["format"], "other"), (["version"], 2), (["gluings", 0, 0], None), (["gluings", 0, 0], [1, "0122"]),
        (["radius"], "1e-10"), (["radius"], 1e-10), (["bits"], 0), (["edges", 0, "length"], "0.596"), (["claims"], ...),
        (["edges", 0, "fixed"], 0), (["edges", 0, "edge"], 6), (["claims", "volume"], ["6.45"]), (["proof"], True),
    ],
}

FRUSTUM, BOX = str(FROZEN / "frustum.json"), str(FROZEN / "box.json")
WRITTEN = [  # all but `-o FILE`
    ["convert", "cPcbbbiht"], ["convert", "fmp3_17"], ["convert", str(ROOT / "tests/data/knotted_y.json")],
    ["convert", str(ROOT / "tests/data/mesh/ring_two_holes.off")], ["convert", FRUSTUM],
    ["convert", str(ROOT / "tests/data/mesh/gmsh_solid.mesh"), "--to", "mesh"], ["convert", BOX, "--to", "json"],
    ["simplify", BOX], ["truncate", BOX], ["subdivide", "fmp2_1", "--finite"],
    ["hyperbolize", "fmp2_1"], ["hyperbolize", "cPcbbbiht"], ["canonize", "fmp2_8"], ["canonize", "eLAkbccddemoen"],
    ["bundle", str(ROOT / "tests/data/mesh/cube.off")], ["bundle", FRUSTUM, "--fiber", "2"],
    ["slit", FRUSTUM], ["slit", FRUSTUM, "--domain", "circular"], ["slit", FRUSTUM, "--domain", "cylindric"],
    ["slit", FRUSTUM, "--domain", "parallel", "--basis", "1"],
    ["register", FRUSTUM, str(FROZEN / "wide_frustum.json")],
    ["product", BOX, "--labels", "1,2"], ["product", BOX, "--labels", "1,2", "--hex", "2"],
]


def check_written(program, command, folder):
    """What is wrong with the file that a command writes, read back by the program; the file."""
    path, again = folder / "written.json", folder / "again.json"
    for arguments in ([*command, "-o", str(path)], ["convert", str(path), "-o", str(again)]):
        done = subprocess.run([program, *arguments, "--quiet"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            return f"{' '.join(arguments)}: {done.returncode}: {done.stderr}", None
    same = path.read_bytes() == again.read_bytes()
    return "" if same else f"{' '.join(command)}: read and written, the file is another one", path


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program")
    parser.add_argument("files", nargs="*", type=pathlib.Path)
    options = parser.parse_args()
    schemas = validators()
    failures = []

    def check(file, name):
        document = json.loads(file.read_text())
        schema = schemas.get(document.get("format"))
        if schema is None:
            failures.append(f"{name}: no schema for the format {document.get('format')!r}")
            return
        for error in schema.iter_errors(document):
            failures.append(f"{name}: {error.json_path}: {error.message[:200]}")

    files = options.files or [*sorted((ROOT / "tests/data/format/good").glob("*.json")),
                              *sorted((ROOT / "tests/data/frozen").glob("*/*.json")),
                              *sorted((ROOT / "tests/data").glob("*.cert.json")),
                              *sorted((ROOT / "census").glob("fmp*.json")), ROOT / "census/graphs.json"]
    for file in files:
        check(file, file)
    written = 0
    if options.program:
        with tempfile.TemporaryDirectory() as folder:
            for command in WRITTEN:
                failure, path = check_written(options.program, command, pathlib.Path(folder))
                if failure:
                    failures.append(failure)
                if path:
                    check(path, " ".join(command))
                    written += 1
    refused = 0
    for file, changes in BAD.items() if not options.files else ():
        document = json.loads(file.read_text())
        for path, value in changes:
            if schemas[document["format"]].is_valid(changed(document, path, value)):
                failures.append(f"the schema accepts {file.name} with {path} = {value!r}")
            refused += 1
    print("\n".join(failures) or f"{len(files)} documents conform and {written} new ones, {refused} bad ones are refused")
    return 1 if failures else 0


sys.exit(main())
