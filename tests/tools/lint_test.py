#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""tools/lint: what changed is checked, what passed and did not change is not, and what is at fault is found each time.

Usage: lint_test.py BUILD_DIR SOURCE_DIR
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

SOURCE = os.path.abspath(sys.argv[2])
BUILD = """cmake_minimum_required(VERSION 3.25)
project(small LANGUAGES CXX)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
add_library(small src/core/a.cpp src/core/b.cpp)
target_include_directories(small PRIVATE include)
"""
HOUSE = {
    "CMakeLists.txt": BUILD, ".gitignore": "build/\n",
    "include/tetrarch/core/a.hpp": "#pragma once\n// A number.\nint a();\n",
    "src/core/a.cpp": '#include "tetrarch/core/a.hpp"\n\n// One.\nint a() {\n  return 1;\n}\n',
    "src/core/b.cpp": "int b(int x) {\n  return x + 1;\n}\n",
}
FAULT = "\ntypedef int Number;\n"  # modernize-use-using
# Lint in this house, whose only header is read by a.cpp: (what is changed, to what) and how many files are checked then.
CHANGES = [
    ("include/tetrarch/core/a.hpp", "#pragma once\n// The number.\n// It is one.\nint a();\n", 0),
    ("src/core/a.cpp", '#include "tetrarch/core/a.hpp"\n\nint a() {\n  return 1;\n}\n', 0),
    ("include/tetrarch/core/a.hpp", "#pragma once\n\nint a();\nint c();\n", 1),
    ("src/core/b.cpp", "int b(int x) {\n  return x + 2;\n}\n", 1),
    ("src/core/b.cpp", "// NOLINTNEXTLINE\nint b(int x) {\n  return x + 2;\n}\n", 1),
    ("src/core/b.cpp", "// NOLINTNEXTLINE\n// Now it stands above this line.\nint b(int x) {\n  return x + 2;\n}\n", 1),
    ("src/core/b.cpp", "/* Now\n// not */\nint b(int x) {\n  return x + 2;\n}\n", 1),
    ("CMakeLists.txt", BUILD + "target_compile_definitions(small PRIVATE MORE)\n", 2),
]


class Lint(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = os.path.join(folder.name, "house")
        self.env = dict(os.environ, XDG_CACHE_HOME=os.path.join(folder.name, "cache"))
        for name, content in HOUSE.items():
            self.write(name, content)
        for name in ("tools/lint", ".clang-tidy", ".clang-format"):
            os.makedirs(os.path.dirname(os.path.join(self.root, name)), exist_ok=True)
            shutil.copy(os.path.join(SOURCE, name), os.path.join(self.root, name))
        self.do("git", "init", "-q")
        self.do("cmake", "-G", "Ninja", "-B", "build")
        self.assertEqual(self.lint(), (0, 2, 0))

    def write(self, name, content):
        path = os.path.join(self.root, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(content)

    def do(self, *command):
        subprocess.run(command, cwd=self.root, env=self.env, check=True, capture_output=True)

    def lint(self, build=True, word=None):
        """Builds, and gives lint's exit status, how many files it checked, and how many it did not."""
        if build:
            self.do("cmake", "--build", "build")
        done = subprocess.run([os.path.join(self.root, "tools/lint"), "build", *([word] if word else [])], cwd=self.root,
                              env=self.env, text=True, capture_output=True, check=False)
        counts = re.search(r"lint: (\d+) files checked, (\d+) unchanged", done.stdout)
        self.assertTrue(counts, done.stdout + done.stderr)
        return done.returncode, int(counts[1]), int(counts[2])

    def test_what_changed_is_checked_and_no_more(self):
        self.assertEqual(self.lint(), (0, 0, 2))
        for name, content, checked in CHANGES:
            self.write(name, content)
            self.assertEqual(self.lint(), (0, checked, 2 - checked), content)
            self.assertEqual(self.lint(), (0, 0, 2), content)

    def test_a_fault_is_found_each_time_until_it_is_mended(self):
        for name, checked in (("src/core/b.cpp", 1), ("include/tetrarch/core/a.hpp", 1)):
            self.write(name, HOUSE[name] + FAULT)
            self.assertEqual(self.lint(), (1, checked, 2 - checked), name)
            self.assertEqual(self.lint(), (1, checked, 2 - checked), name)
            self.write(name, HOUSE[name])
            self.assertEqual(self.lint(), (0, 0, 2), name)

    def test_the_rules_count(self):
        with open(os.path.join(self.root, ".clang-tidy"), "a", encoding="utf-8") as file:
            file.write("# more\n")
        self.assertEqual(self.lint(), (0, 2, 0))

    def test_an_object_older_than_its_header_is_not_trusted(self):
        # a.hpp includes another header now, which no build has seen: a stamp would not know of it.
        self.write("include/tetrarch/core/more.hpp", "#pragma once\n")
        self.write("include/tetrarch/core/a.hpp", '#pragma once\n#include "tetrarch/core/more.hpp"\nint a();\n')
        self.assertEqual(self.lint(build=False), (0, 1, 1))
        self.write("include/tetrarch/core/more.hpp", "#pragma once\n" + FAULT)
        self.assertEqual(self.lint(build=False), (1, 1, 1))
        self.assertEqual(self.lint(), (1, 1, 1))

    def test_another_clone_knows_what_passed_here(self):
        other = self.root + "_too"
        shutil.copytree(self.root, other, ignore=shutil.ignore_patterns("build"))
        self.root = other
        self.do("cmake", "-G", "Ninja", "-B", "build")
        self.assertEqual(self.lint(), (0, 0, 2))

    def forget_the_cache(self):
        shutil.rmtree(self.env["XDG_CACHE_HOME"])

    def test_notes_serve_a_machine_that_has_no_stamps(self):
        self.assertEqual(self.lint(word="record"), (0, 0, 2))
        self.forget_the_cache()
        self.assertEqual(self.lint(), (0, 0, 2))
        self.write("src/core/b.cpp", HOUSE["src/core/b.cpp"] + FAULT)
        self.assertEqual(self.lint(), (1, 1, 1))
        notes = os.path.join(self.root, "tests/lint_passed.json")
        before = os.stat(notes).st_mtime_ns
        self.assertEqual(self.lint(word="record"), (1, 1, 1))  # a.cpp by its note
        self.assertEqual(os.stat(notes).st_mtime_ns, before)

    def test_a_false_note_comes_to_light(self):
        for k in range(40):
            self.write(f"src/core/c{k}.cpp", f"int c{k}() {{\n  return {k};\n}}\n" + FAULT)
        self.write("CMakeLists.txt", BUILD.replace("src/core/a.cpp", "src/core/a.cpp " + " ".join(
            f"src/core/c{k}.cpp" for k in range(40))))
        self.assertEqual(self.lint(), (1, 40, 2))
        loader = importlib.machinery.SourceFileLoader("lint", os.path.join(self.root, "tools/lint"))
        module = importlib.util.module_from_spec(importlib.util.spec_from_loader("lint", loader))
        loader.exec_module(module)
        tasks = module.tasks(os.path.join(self.root, "build"), "-clang-analyzer-*")
        module.record(tasks)
        # One of 42 is doubted; its name depends on the commit, so that each has its turn.
        status, checked, _ = self.lint()
        self.assertIn((status, checked), [(1, 1), (0, 0)])  # (0, 0): the doubted one was a.cpp or b.cpp, which have stamps
        found = set()
        for k in range(100):
            self.do("git", "-c", "user.name=a", "-c", "user.email=a@b.c", "commit", "-q", "--allow-empty", "-m", str(k))
            found.update(module.doubted([task.name for task in tasks]))
        self.assertGreater(len(found), 20)

    def test_a_file_of_wrong_form_is_a_fault(self):
        self.write("src/core/b.cpp", "int   b(int x){ return x + 1; }\n")
        done = subprocess.run([os.path.join(self.root, "tools/lint"), "build"], cwd=self.root, env=self.env, text=True,
                              capture_output=True, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertIn("b.cpp:1", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
