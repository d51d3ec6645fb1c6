# SPDX-License-Identifier: GPL-2.0-or-later
"""Schemas of what --json prints. That all runs of all tests satisfy them is asked in running.py, of python3-jsonschema."""
import copy
import json
import os
import unittest

from running import SOURCE, InFolder, jsonschema, run, run_json, validators

RING = os.path.join(SOURCE, "tests/data/mesh/ring_two_holes.off")
SOLID = os.path.join(SOURCE, "tests/data/mesh/gmsh_solid.mesh")


def places(value, path=()):
    """All values inside, by the steps that lead to them."""
    items = value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ()
    for step, inner in items:
        yield (*path, step)
        yield from places(inner, (*path, step))


def changed(value, path, to):
    """A copy with another value at a path; with `...`, without what is there."""
    made = copy.deepcopy(value)
    at = made
    for step in path[:-1]:
        at = at[step]
    if to is ...:
        del at[path[-1]]
    else:
        at[path[-1]] = to
    return made


@unittest.skipUnless(jsonschema, "python3-jsonschema is missing")
class Schemas(InFolder):
    def refuses(self, words, value, because):
        self.assertFalse(validators()[words].is_valid(value), because)

    def test_every_command_has_one_but_those_that_print_no_object(self):
        told = json.loads(run("help", "--json").stdout)
        without = {command["name"] for command in told["commands"] if tuple(command["name"].split()) not in validators()}
        self.assertEqual(without, {"shell", "help"})
        common = {field["name"] for field in told["common_result"]}
        self.assertEqual(common, {"passed_over", "input", "name"})
        for command in told["commands"]:
            if command["name"] in without:
                self.assertNotIn("result", command)
                continue
            schema = validators()[tuple(command["name"].split())].schema
            self.assertEqual(set(schema["properties"]), {field["name"] for field in command["result"]} | common)
            self.assertEqual(set(schema["required"]), {field["name"] for field in command["result"] if field["always"]})
            self.assertIs(schema["additionalProperties"], False)
            self.assertIn(command["summary"], schema["description"])
            for field in command["result"]:
                self.assertTrue(field["schema"], (command["name"], field["name"]))  # an empty one would allow anything
                said = schema["properties"][field["name"]]
                self.assertEqual(said["description"], field["meaning"])
                self.assertEqual(said.get("unit", ""), field["unit"])

    def test_one_alone_is_that_of_all(self):
        for name in ("slit", "census list"):
            alone = json.loads(run("help", "--schema", *name.split()).stdout)
            self.assertEqual(alone, validators()[tuple(name.split())].schema)
            self.assertEqual(alone["$schema"], "https://json-schema.org/draft/2020-12/schema")
        for words, said in ((("census",), "group of commands"), (("shell",), "no object"), (("nothing",), "unknown command")):
            done = run("help", "--schema", *words)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1))
            self.assertIn(said, done.stderr)

    def test_whatever_is_changed_is_refused(self):
        """No value can be an object of a strange kind, no member that is always there can go, none can come."""
        tried = 0
        for words, *options in ((("info",), "cPcbbbihq"), (("skeleton",), "cPcbbbiht"), (("group",), "m004"), (("check",), RING),
                                (("check",), SOLID), (("hyperbolize",), "m004", "--certify"), (("canonize",), "m004", "--isometries"),
                                (("isometric",), "m003", "m004"), (("embed",), "m004", "--copies", "3", "-o", self.path("e.obj")),
                                (("slit",), RING), (("slit",), RING, "--domain", "circular"), (("exterior",), "4_1"),
                                (("diagram",), "4_1"), (("register",), RING, RING), (("census", "show"), "fmp2_1"),
                                (("census", "list"), "--tetrahedra", "2"), (("census", "identify"), "m004")):
            _, value = run_json(*words, *options)
            required = validators()[words].schema["required"]
            self.refuses(words, {**value, "never": 1}, words)
            for path in places(value):
                with self.subTest(words=words, path=path):
                    self.refuses(words, changed(value, path, {"never": ["", []]}), "a strange object")
                    if len(path) == 1:
                        self.assertEqual(validators()[words].is_valid(changed(value, path, ...)), path[0] not in required)
                tried += 1
        self.assertGreater(tried, 1000)

    def test_errors_too(self):
        error = json.loads(run("info", "nonsense", "--json").stderr)
        self.assertTrue(validators()[("error",)].is_valid(error))
        for path in places(error):
            for to in ({}, ..., "" if path[-1] == "code" else {}):
                self.refuses(("error",), changed(error, path, to), path)
        self.refuses(("error",), {**error, "more": 1}, "more")

    def test_lines_of_sessions(self):
        done = run("shell", "--json", "--keep-going", stdin="Y = fmp2_8\ninfo Y\ninfo nonsense\n")
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(len(lines), 3)
        for line in lines:
            self.assertTrue(validators()[("statement",)].is_valid(line), line)
            self.refuses(("statement",), changed(line, ("line",), 1), line)
        self.assertTrue(validators()[("info",)].is_valid(lines[1]["result"]))

    def test_lines_and_summary_of_an_enumeration(self):
        lines = [json.loads(line) for line in run("census", "enumerate", "--tetrahedra", "2", "--json").stdout.splitlines()]
        self.assertEqual(len(lines), 8)
        self.assertTrue(all(map(validators()[("census", "enumerate")].is_valid, lines)))
        status, summary = run_json("census", "enumerate", "--tetrahedra", "2", "-o", self.path("table.jsonl"))
        self.assertEqual((status, summary["manifolds"]), (0, 8))
        for share in ("1/2", "2/2"):
            status, left = run_json("census", "enumerate", "--tetrahedra", "2", "--shard", share, "--work", self.path("w" + share[0]))
            self.assertEqual((status, list(left)), (0, ["missing_units"]))
        merged = run_json("census", "merge", self.path("w1"), self.path("w2"), "--tetrahedra", "2", "-o", self.path("merged.jsonl"))
        self.assertEqual(merged, (0, summary))
        # Of three tetrahedra that are not orientable, some have a cusp that is a Klein bottle.
        table = ("--tetrahedra", "3", "--nonorientable")
        done = run("census", "enumerate", *table, "--work", self.path("w"), "--json")
        self.assertEqual(run("census", "merge", self.path("w"), *table, "--json").stdout, done.stdout)
        cusped = [json.loads(line)["name"] for line in done.stdout.splitlines() if "klein_cusps" in line]
        stored = [entry["name"] for entry in run_json("census", "list", *table)[1]["manifolds"] if "klein_cusps" in entry]
        self.assertEqual((cusped, len(cusped)), (stored, 8))

    def test_a_page(self):
        page = self.path("y.html")
        status, said = run_json("view", "cPcbbbihq", "--copies", "5", "-o", page)
        self.assertEqual((status, said["page"], said["bytes"]), (0, page, os.path.getsize(page)))
        self.assertEqual(max(body["copies"] for body in said["bodies"]), 5)

    def test_an_illegal_move(self):
        status, said = run_json("move", "cPcbbbihq", "4-1", "0", "0")
        self.assertEqual((status, set(said) - {"passed_over"}), (1, {"move", "obstacle"}))
