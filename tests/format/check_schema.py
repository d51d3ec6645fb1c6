#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks documents against census/schema/triangulation.schema.json.

    tests/format/check_schema.py [FILE.json ...]

Without arguments: the schema itself, then the fixtures in tests/data/format/good (canonical documents; that
Tetrarch writes exactly these bytes is tested elsewhere), then variants of one of them that must be refused. Exit
status 77, which CTest can be told to count as skipped, where Debian's python3-jsonschema is missing.
"""
import copy
import json
import pathlib
import sys

try:
    import jsonschema
except ImportError:
    print("skipped: python3-jsonschema is not installed")
    sys.exit(77)

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
SCHEMA = json.loads((ROOT / "census/schema/triangulation.schema.json").read_text())


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


def bad_documents(sound):
    face = ["gluings", 0, 1]
    for path, value in [
        (["format"], "other"), (["version"], 2), (["version"], ...), (["tetrahedra"], -1), (["tetrahedra"], "2"),
        (["gluings"], None), (["gluings", 0], [None, None, None]), (["name"], 3), (["provenance"], []),
        (face, 7), (face, [1]), (face, [-1, "0123"]), (face, [1, "0122"]), (face, [1, "0124"]), (face, [1, "012"]),
        (face, [1, "0123", 1]), (["metric", "volume"], "6,45"), (["metric", "volume"], None),
        (["metric", "edge_lengths", 0], [1, 2, 3]), (["metric", "dihedral_angles", 0, 0], None),
    ]:
        yield path, value, changed(sound, path, value)


def main():
    validator = jsonschema.validators.validator_for(SCHEMA)
    validator.check_schema(SCHEMA)
    schema = validator(SCHEMA)
    fixtures = ROOT / "tests/data/format/good"
    files = [pathlib.Path(f) for f in sys.argv[1:]] or sorted(fixtures.glob("*.json"))
    failures = []
    for file in files:
        for error in schema.iter_errors(json.loads(file.read_text())):
            failures.append(f"{file}: {error.json_path}: {error.message[:200]}")
    refused = 0
    if not sys.argv[1:]:
        for path, value, document in bad_documents(json.loads((fixtures / "unknown_members.json").read_text())):
            if schema.is_valid(document):
                failures.append(f"the schema accepts {path} = {value!r}")
            refused += 1
    print("\n".join(failures) or f"{len(files)} documents conform, {refused} bad ones are refused")
    return 1 if failures else 0


sys.exit(main())
