#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What a room does not declare does not compile; the table is checked, and what it permits is used.

Usage: rooms_test.py BUILD_DIR SOURCE_DIR

The first half asks the compiler, with the flags of a file of that room: it reads a file that includes one header of each room.
The second half runs tools/check_layers in copies of the house that were spoiled.
"""
import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest
from concurrent.futures import ThreadPoolExecutor

BUILD = os.path.abspath(sys.argv[1])
SOURCE = os.path.abspath(sys.argv[2])


def files(folder, ending):
    return sorted(name for name in os.listdir(os.path.join(SOURCE, folder)) if name.endswith(ending))


def rooms():
    return [name for name in os.listdir(os.path.join(SOURCE, "src")) if os.path.isdir(os.path.join(SOURCE, "src", name))]


def command(room):
    """How the build compiles the files of a room, without a file and without its object."""
    with open(os.path.join(BUILD, "compile_commands.json"), encoding="utf-8") as file:
        words = next(shlex.split(entry["command"]) for entry in json.load(file) if "/tetrarch_%s.dir/" % room in entry["command"])
    words = words[:words.index("-o")]
    while any(word.endswith(("ccache", "cmake")) for word in words[:5]):  # cmake -E env A=B ccache c++ ...
        words = words[1:]
    return words


def compiles(room, include):
    """Whether a file in src/ROOM that says #include "..." would pass the preprocessor."""
    done = subprocess.run([*command(room), "-E", "-o", os.devnull, "-x", "c++", "-"], input='#include "%s"\n' % include,
                          cwd=os.path.join(SOURCE, "src", room), capture_output=True, text=True, check=False)
    if done.returncode != 0 and "No such file or directory" not in done.stderr:
        raise AssertionError(done.stderr)
    return done.returncode == 0


def seen(room):
    """The rooms of which this one can include a public header."""
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        others = sorted(rooms())
        headers = ["tetrarch/%s/%s" % (other, files("include/tetrarch/" + other, ".hpp")[0]) for other in others]
        return {other for other, good in zip(others, pool.map(lambda header: compiles(room, header), headers)) if good}


class Compiler(unittest.TestCase):
    def test_a_room_of_each_floor_sees_what_it_declares_and_no_more(self):
        # Copied by hand from src/CMakeLists.txt: a slip in reading that table must not hide one in obeying it.
        self.assertEqual(seen("numeric"), {"numeric"})
        self.assertEqual(seen("core"), {"numeric", "core"})
        self.assertEqual(seen("moves"), {"numeric", "core", "moves"})
        self.assertEqual(seen("surface"), {"numeric", "core", "format", "surface"})
        self.assertEqual(seen("solid"), {"numeric", "core", "solid"})
        self.assertEqual(seen("doctor"), {"numeric", "core", "format", "surface", "solid", "doctor"})
        self.assertEqual(seen("tetgen"), {"core", "format", "doctor", "tetgen"})
        self.assertEqual(seen("scene"), {"numeric", "core", "format", "scene"})
        self.assertEqual(seen("reasons"), {"core", "algebra", "moves", "reasons"})
        self.assertEqual(seen("enumeration"), {"numeric", "core", "enumeration"})
        self.assertEqual(seen("bundle"), {"numeric", "core", "surface", "bundle"})
        # Headers of doctor include headers of format, which product does not see for all that.
        self.assertEqual(seen("product"), {"numeric", "core", "algebra", "surface", "solid", "doctor", "slit", "unfold", "product"})
        # Headers of embed include headers of algebra and hyperbolic.
        self.assertEqual(seen("show"), {"numeric", "core", "bundle", "diagram", "embed", "format", "product", "scene", "show", "slit", "surface"})

    def test_the_header_of_headers_is_for_others(self):
        for room in ("core", "show"):
            self.assertFalse(compiles(room, "tetrarch/tetrarch.hpp"))

    def test_private_headers_are_private(self):
        self.assertTrue(compiles("enumeration", "gluings_partial.hpp"))
        self.assertFalse(compiles("scene", "gluings_partial.hpp"))
        self.assertFalse(compiles("enumeration", "full_turn.hpp"))


class Names(unittest.TestCase):
    """tools/check_names on a copy of the house."""

    def test_a_name_that_stands_twice(self):
        with tempfile.TemporaryDirectory() as root:
            for name in ("src", "tests/CMakeLists.txt", "tools/tetrarch", "tools/python"):
                copy = shutil.copytree if os.path.isdir(os.path.join(SOURCE, name)) else shutil.copy
                os.makedirs(os.path.dirname(os.path.join(root, name)), exist_ok=True)
                copy(os.path.join(SOURCE, name), os.path.join(root, name))
            check = [os.path.join(SOURCE, "tools/check_names"), root]
            self.assertEqual(subprocess.run(check, capture_output=True, text=True, check=False).stdout, "")
            for name in ("newton", "flow"):  # the second is chosen for double, be it meant or not
                with open(os.path.join(root, "src/hyperbolic", name + ".cpp"), "a", encoding="utf-8") as file:
                    file.write("namespace {\n\n%sbool met(%s x) {\n  return x > 0;\n}\n\n} // namespace\n" % (
                        ("template <class Scalar>\n", "Scalar") if name == "newton" else ("", "double")))
            done = subprocess.run(check, capture_output=True, text=True, check=False)
            self.assertEqual((done.returncode, done.stdout), (1, "met: the same name in unnamed namespaces of "
                                                              "src/hyperbolic/flow.cpp and src/hyperbolic/newton.cpp\n"))


class Layers(unittest.TestCase):
    """tools/check_layers on a copy of the house."""

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        for name in ("src", "include", "README.md", "CMakeLists.txt"):
            copy = shutil.copytree if os.path.isdir(os.path.join(SOURCE, name)) else shutil.copy
            copy(os.path.join(SOURCE, name), os.path.join(self.root, name))
        self.assertEqual(self.found(), "")

    def found(self):
        return subprocess.run([os.path.join(SOURCE, "tools/check_layers"), self.root], capture_output=True, text=True,
                              check=False).stdout

    def change(self, name, old, new):
        path = os.path.join(self.root, name)
        with open(path, encoding="utf-8") as file:
            text = file.read()
        self.assertIn(old, text)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text.replace(old, new, 1))

    def test_an_include_that_is_not_declared(self):
        self.change("src/slit/banks.cpp", "#include", '#include "tetrarch/hyperbolic/metric.hpp"\n#include')
        self.assertIn("slit (floor 3) may not use hyperbolic (floor 2)", self.found())

    def test_a_private_room_in_a_public_header(self):
        self.change("include/tetrarch/product/field.hpp", "#include", '#include "tetrarch/slit/one_form.hpp"\n#include')
        self.assertIn("product (floor 4) may not use slit (floor 3) in a public header", self.found())

    def test_a_private_header_by_a_path(self):
        self.change("src/scene/obj.cpp", "#include", '#include "../enumeration/gluings_partial.hpp"\n#include')
        self.assertIn("'../enumeration/gluings_partial.hpp' is private to another room", self.found())

    def test_a_declaration_that_nothing_uses(self):
        self.change("src/CMakeLists.txt", "tetrarch_room(slit FLOOR 3 PUBLIC", "tetrarch_room(slit FLOOR 3 PRIVATE algebra PUBLIC")
        self.assertIn("slit does not use algebra", self.found())

    def test_a_room_that_is_public_for_nothing(self):
        self.change("src/CMakeLists.txt", "PUBLIC numeric core PRIVATE moves", "PUBLIC numeric core moves")
        self.assertIn("no public header of hyperbolic uses moves", self.found())

    def test_a_table_that_climbs(self):
        self.change("src/CMakeLists.txt", "tetrarch_room(embed FLOOR 3", "tetrarch_room(embed FLOOR 2")
        found = self.found()
        self.assertIn("embed (floor 2) may not use hyperbolic (floor 2)", found)
        self.assertIn("README.md: embed stands on floor 3", found)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
