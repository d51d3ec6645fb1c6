#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/noted_tests: whatever a long test may depend on makes it run again, and nothing else does.

Usage: noted_tests_test.py BUILD_DIR SOURCE_DIR
"""
import importlib.machinery
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
BUILD = os.path.abspath(sys.argv[1])
SOURCE = os.path.abspath(sys.argv[2])


def load(path):
    loader = importlib.machinery.SourceFileLoader("noted_tests", path)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("noted_tests", loader))
    loader.exec_module(module)
    return module


notes = load(os.path.join(SOURCE, "tools/noted_tests"))

# A small house. By the table of src/CMakeLists.txt, bundle uses core and surface, which uses format, and algebra uses core alone.
HOUSE = {
    "CMakeLists.txt": "", "CMakePresets.json": "", "src/CMakeLists.txt": "", "src/rooms.cmake": "",
    "tests/CMakeLists.txt": "", "tools/package/tetrarch-libraries.cmake": "",
    "include/tetrarch/core/a.hpp": "", "src/core/a.cpp": "", "src/core/private.hpp": "",
    "include/tetrarch/algebra/b.hpp": "", "src/algebra/b.cpp": "",
    "include/tetrarch/format/f.hpp": "", "src/format/f.cpp": "",
    "include/tetrarch/surface/m.hpp": "", "src/surface/m.cpp": "",
    "include/tetrarch/bundle/c.hpp": "", "src/bundle/c.cpp": "",
    "include/tetrarch/slit/d.hpp": "", "src/slit/d.cpp": "",
    "include/tetrarch/scene/e.hpp": "", "src/scene/e.cpp": "",
    "tests/core/a_test.cpp": 'TEST_CASE("a", "[slow]")', "tests/core/naive.hpp": "",
    "tests/bundle/c_test.cpp": '#include "support/laws.hpp"\nTEST_CASE("c", "[slow]")', "tests/bundle/quick_test.cpp": "",
    "tests/algebra/b_test.cpp": '#include "slit/plain.hpp"\nTEST_CASE("b", "[bundle][slow]")',
    "tests/scene/e_test.cpp": "",
    "tests/slit/plain.hpp": '#include "deeper.hpp"\n', "tests/slit/deeper.hpp": "#include <tetrarch/slit/d.hpp>\n",
    "tests/support/laws.hpp": "", "tests/support/main.cpp": "", "tests/data/x.off": "", "tests/oracle/y.txt": "",
    "census/fmp2.json": "", "README.md": "", "tools/tetrarch/main.cpp": "",
    "tests/viewer/run": "", "tools/viewer/src/draw.js": "",
    "build/CMakeCache.txt": "CMAKE_CXX_COMPILER:FILEPATH=c++\nCMAKE_CXX_FLAGS_RELEASE:STRING=-O3\nTETRARCH_SANITIZE:BOOL=OFF\n",
}
PICTURES = {"pictures.slow"}
ALL = {"core.slow", "algebra.slow", "bundle.slow"} | PICTURES
# What each file must set off, by the table and by the includes above.
SETS_OFF = {
    "CMakeLists.txt": ALL, "CMakePresets.json": set(), "tests/CMakeLists.txt": ALL, "tools/package/tetrarch-libraries.cmake": ALL,
    "include/tetrarch/core/a.hpp": ALL, "src/core/a.cpp": ALL, "src/core/private.hpp": ALL,
    "src/CMakeLists.txt": ALL, "src/rooms.cmake": ALL,
    "include/tetrarch/algebra/b.hpp": {"algebra.slow"}, "src/algebra/b.cpp": {"algebra.slow"},
    "include/tetrarch/format/f.hpp": {"algebra.slow", "bundle.slow"}, "src/format/f.cpp": {"algebra.slow", "bundle.slow"},
    "include/tetrarch/surface/m.hpp": {"algebra.slow", "bundle.slow"}, "src/surface/m.cpp": {"algebra.slow", "bundle.slow"},
    "include/tetrarch/bundle/c.hpp": {"bundle.slow"}, "src/bundle/c.cpp": {"bundle.slow"},
    "include/tetrarch/slit/d.hpp": {"algebra.slow"}, "src/slit/d.cpp": {"algebra.slow"},
    "include/tetrarch/scene/e.hpp": set(), "src/scene/e.cpp": set(),
    "tests/core/a_test.cpp": {"core.slow"}, "tests/core/naive.hpp": {"core.slow"}, "tests/bundle/quick_test.cpp": {"bundle.slow"},
    "tests/slit/plain.hpp": {"algebra.slow"}, "tests/slit/deeper.hpp": {"algebra.slow"}, "tests/scene/e_test.cpp": set(),
    "tests/support/laws.hpp": ALL, "tests/support/main.cpp": ALL, "tests/data/x.off": ALL, "tests/oracle/y.txt": ALL,
    "census/fmp2.json": ALL, "README.md": set(), "tools/tetrarch/main.cpp": PICTURES, "build/CMakeCache.txt": ALL,
    "tests/viewer/run": PICTURES, "tools/viewer/src/draw.js": PICTURES,
}
# Everything that the library is made of shows in the pictures.
SETS_OFF = {name: tests | PICTURES if name.startswith(("include/", "src/")) else tests for name, tests in SETS_OFF.items()}


class Folder(unittest.TestCase):
    """The small house in a folder of its own."""

    FILES = HOUSE

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = folder.name
        for name, content in self.FILES.items():
            self.write(name, content)

    def build(self):
        return os.path.join(self.root, "build")

    def write(self, name, content):
        path = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content)


class Doubt(unittest.TestCase):
    """The room whose note is not believed."""

    def test_every_room_comes_up_and_dear_ones_seldom(self):
        sources = {"numeric": 20, "slit": 100, "checker": 200}
        drawn = [notes.draw(sources, f"{k:04x}8000{'0' * 32}") for k in range(1 << 16)]
        share = {room: drawn.count(room) / len(drawn) for room in sources}
        # 1/400, 1/10,000 and 1/40,000 are as 100 to 4 to 1.
        for room, part in {"numeric": 100, "slit": 4, "checker": 1}.items():
            self.assertAlmostEqual(share[room], part / 105, delta=1e-4)
        self.assertEqual(notes.draw(sources, "f" * 40), "checker")


class House(Folder):
    """All its slow tests have passed."""

    def setUp(self):
        super().setUp()
        self.assertEqual(self.selected(), ALL)  # nothing is noted yet
        notes.record(self.root, "slow", self.build(), [])
        self.assertEqual(self.selected(), set())

    def selected(self):
        must, left_out = notes.select(self.root, "slow", self.build())
        self.assertEqual(set(must) | set(left_out), ALL)
        self.assertEqual(set(must) & set(left_out), set())
        return set(must)

    def test_a_changed_file_sets_off_what_depends_on_it(self):
        for name, expected in SETS_OFF.items():
            self.write(name, HOUSE[name].replace("-O3", "-O2") if name.startswith("build/") else HOUSE[name] + "\n// more")
            self.assertEqual(self.selected(), expected, name)
            self.write(name, HOUSE[name])
            self.assertEqual(self.selected(), set(), name)

    def test_a_new_file_and_a_lost_one_set_off_the_same(self):
        self.write("src/surface/new.cpp", "")
        self.assertEqual(self.selected(), {"algebra.slow", "bundle.slow"} | PICTURES)
        os.remove(os.path.join(self.root, "src/surface/new.cpp"))
        os.remove(os.path.join(self.root, "src/bundle/c.cpp"))
        self.assertEqual(self.selected(), {"bundle.slow"} | PICTURES)

    def test_a_new_include_in_a_test_brings_its_room(self):
        self.write("tests/support/laws.hpp", "#include <tetrarch/scene/e.hpp>\n")
        notes.record(self.root, "slow", self.build(), [])
        self.write("src/scene/e.cpp", "int more;")
        self.assertEqual(self.selected(), {"bundle.slow"} | PICTURES)

    def test_another_compiler_sets_off_all(self):
        self.write("other", "#!/bin/sh\necho 'another 99.0'\n")
        os.chmod(os.path.join(self.root, "other"), 0o755)
        self.write("build/CMakeCache.txt", HOUSE["build/CMakeCache.txt"].replace("=c++", "=" + os.path.join(self.root, "other")))
        self.assertEqual(self.selected(), ALL)

    def test_notes_that_cannot_be_read_or_are_old_run_everything(self):
        for notes in ("", "{", '{"core.slow": "0"}', "[]", "null"):
            self.write("tests/slow_passed.json", notes)
            self.assertEqual(self.selected(), ALL, notes)

    def test_what_passed_alone_is_noted_alone(self):
        self.write("src/core/a.cpp", "int more;")
        notes.record(self.root, "slow", self.build(), ["core.slow"])
        self.assertEqual(self.selected(), ALL - {"core.slow"})


class UnderTheSanitizers(Folder):
    """With a test of its program."""

    FILES = {**HOUSE, "tests/tools/program_test.py": ""}
    ROOMS = {"core", "algebra", "bundle", "slit", "scene"}
    PROGRAM = {"program", "shell", "foreign", "schema"}

    def setUp(self):
        super().setUp()
        self.assertEqual(self.selected(), self.ROOMS | self.PROGRAM)
        notes.record(self.root, "sanitize", self.build(), [])
        self.assertEqual(self.selected(), set())

    def selected(self):
        return set(notes.select(self.root, "sanitize", self.build())[0])

    def test_a_changed_file_sets_off_its_rooms_and_the_program(self):
        for name, expected in {"src/slit/d.cpp": {"slit", "algebra"} | self.PROGRAM, "tests/scene/e_test.cpp": {"scene"},
                               "tests/tools/program_test.py": self.PROGRAM, "tools/tetrarch/main.cpp": self.PROGRAM,
                               "src/core/a.cpp": self.ROOMS | self.PROGRAM, "README.md": set()}.items():
            before = self.FILES[name]
            self.write(name, before + "\n// more")
            self.assertEqual(self.selected(), expected, name)
            self.write(name, before)

    def test_the_two_kinds_have_notes_of_their_own(self):
        self.assertEqual(len(notes.select(self.root, "slow", self.build())[0]), len(ALL))

    def test_each_commit_doubts_one_room_and_not_always_the_same(self):
        git = ["git", "-C", self.root, "-c", "user.name=a", "-c", "user.email=a@example.org"]
        subprocess.run([*git, "init", "--quiet"], check=True)
        seen = []
        for k in range(60):
            subprocess.run([*git, "commit", "--quiet", "--allow-empty", "-m", str(k)], check=True)
            seen.append(self.selected())
            self.assertEqual(len(seen[-1]), 1)
        self.assertLessEqual(set().union(*seen), self.ROOMS)
        self.assertGreater(len(set().union(*seen)), 1)  # not always the same one


class OurHouse(unittest.TestCase):
    def test_every_room_with_a_slow_test_is_in_the_build(self):
        with open(os.path.join(SOURCE, "tests/CMakeLists.txt"), encoding="utf-8") as file:
            listed = re.search(r"set\(rooms_with_slow_tests ([^)]*)\)", file.read()).group(1).split()
        self.assertEqual(sorted(listed), sorted(notes.rooms_with_slow_tests(SOURCE, notes.table())))

    def test_every_file_that_the_compiler_read_counts(self):
        """The second route: what Ninja noted when it built the tests of a room."""
        known = notes.table()
        told = subprocess.run(["ninja", "-C", BUILD, "-t", "deps"], capture_output=True, text=True, check=True).stdout
        for room in notes.rooms_with_slow_tests(SOURCE, known):
            count = {os.path.join(SOURCE, name) for name in notes.names(SOURCE, room, known)}
            parts = [part for part in told.split("\n\n") if part.startswith(f"tests/CMakeFiles/test_{room}.dir/")]
            was_read = {os.path.normpath(os.path.join(BUILD, line.strip())) for part in parts for line in part.splitlines()
                        if line.startswith("    ")}
            ours = {path for path in was_read if path.startswith(SOURCE + "/") and not path.startswith(BUILD + "/")}
            self.assertGreater(len(ours), 3, room)
            self.assertEqual(ours - count, set(), room)


if __name__ == "__main__":
    if not shutil.which("ninja") or not os.path.exists(os.path.join(BUILD, "build.ninja")):
        sys.exit("noted_tests_test.py: needs a build made by Ninja")
    unittest.main(argv=sys.argv[:1])
