#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The Debian packages: what is in them, what they ask for, and that the program runs from one that is unpacked.

Usage: package_test.py BUILD_DIR CPACK   (status 77, skipped, where Debian's tools are missing)
"""
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, CPACK = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
FOLDER = tempfile.TemporaryDirectory()
WORK = pathlib.Path(FOLDER.name)


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


class Package:
    def __init__(self, name):
        (self.file,) = WORK.glob(f"{name}_*.deb")
        self.root = WORK / name
        run("dpkg-deb", "-x", self.file, self.root)
        listing = [line.split() for line in run("dpkg-deb", "-c", self.file).splitlines()]
        self.modes = {"/" + words[5].removeprefix("./"): (words[0], words[1]) for words in listing}

    def field(self, name):
        return run("dpkg-deb", "-f", self.file, name).strip()

    def needs(self):
        return {re.split(r"[ (:]", part.strip())[0] for part in self.field("Depends").split(",")}


def setUpModule():
    run(CPACK, "-G", "DEB", "-B", WORK, cwd=BUILD)
    global PROGRAM, LIBRARY
    PROGRAM, LIBRARY = Package("tetrarch"), Package("libtetrarch-dev")
    global PYTHON
    PYTHON = Package("python3-tetrarch") if list(WORK.glob("python3-tetrarch_*.deb")) else None


def tearDownModule():
    FOLDER.cleanup()


class Control(unittest.TestCase):
    def test_fields_that_debian_wants(self):
        architecture = run("dpkg", "--print-architecture").strip()
        for package, section in ((PROGRAM, "math"), (LIBRARY, "libdevel")):
            self.assertEqual(package.field("Architecture"), architecture)
            self.assertEqual(package.field("Section"), section)
            self.assertRegex(package.field("Version"), r"^\d+\.\d+\.\d+$")
            self.assertRegex(package.field("Maintainer"), r"^.+ <.+@.+>$")
            first, *rest = package.field("Description").splitlines()
            self.assertLess(len(first), 80)
            self.assertTrue(rest and all(line.startswith(" ") for line in rest))

    def test_the_program_needs_libraries_and_no_headers(self):
        needs = PROGRAM.needs()
        self.assertTrue({"libc6", "libstdc++6", "zlib1g"} <= needs, needs)
        self.assertFalse([name for name in needs if name.endswith("-dev")])

    def test_the_library_needs_the_headers_it_includes(self):
        self.assertTrue({"libboost-dev", "nlohmann-json3-dev", "libgmp-dev", "libmpfr-dev"} <= LIBRARY.needs())


class Contents(unittest.TestCase):
    def test_where_things_are(self):
        for file in ("bin/tetrarch", "share/man/man1/tetrarch.1.gz", "share/man/man1/tetrarch-census-list.1.gz",
                     "share/bash-completion/completions/tetrarch", "share/zsh/vendor-completions/_tetrarch",
                     "share/tetrarch/census/fmp2.json", "share/tetrarch/samples/torus.off",
                     "share/doc/tetrarch/guide/overview.md", "share/doc/tetrarch/copyright",
                     "share/doc/tetrarch/changelog.gz"):
            self.assertIn("/usr/" + file, PROGRAM.modes)
        for file in ("lib/libtetrarch.a", "lib/cmake/tetrarch/tetrarch-config.cmake", "include/tetrarch/core/error.hpp",
                     "share/doc/libtetrarch-dev/copyright", "share/doc/libtetrarch-dev/changelog.gz"):
            self.assertIn("/usr/" + file, LIBRARY.modes)

    def test_no_file_is_in_both(self):
        files = [{path for path in package.modes if not path.endswith("/")} for package in (PROGRAM, LIBRARY)]
        self.assertEqual(files[0] & files[1], set())

    def test_everything_is_root_s_and_everybody_can_read_it(self):
        for package in filter(None, (PROGRAM, LIBRARY, PYTHON)):
            for path, (mode, owner) in package.modes.items():
                self.assertEqual(owner, "root/root", path)
                executable = mode[0] == "d" or path == "/usr/bin/tetrarch"
                self.assertEqual(mode[1:], "rwxr-xr-x" if executable else "rw-r--r--", path)

    def test_the_python_package_runs(self):
        if PYTHON is None:
            self.skipTest("it was not built")
        self.assertTrue({"python3", "python3-numpy", "libc6"} <= PYTHON.needs(), PYTHON.needs())
        packages = PYTHON.root / "usr/lib/python3/dist-packages"
        self.assertTrue((packages / "tetrarch" / "py.typed").exists())
        code = "import tetrarch as tt; print(tt.Manifold('cPcbbbihq').volume(), len(tt.Mesh.read('samples/torus.off').points) > 0)"
        said = run("/usr/bin/python3", "-c", code, env={"PYTHONPATH": str(packages)}, cwd="/")
        self.assertRegex(said, r"^6\.45199027083.* True$")

    def test_the_program_runs(self):
        # Yin, section 4.2.3: two tetrahedra, a boundary of genus 2.
        said = run(PROGRAM.root / "usr/bin/tetrarch", "info", "cPcbbbihq")
        self.assertRegex(said, r"(?m)^tetrahedra +2$")
        self.assertRegex(said, r"(?m)^boundary +genus 2 \(ideal\)$")
        self.assertIn("torus", run(PROGRAM.root / "usr/bin/tetrarch", "check", "samples/torus.off"))


if __name__ == "__main__":
    if not all(shutil.which(tool) for tool in ("dpkg-deb", "dpkg-shlibdeps")):
        print("dpkg-deb or dpkg-shlibdeps is missing (Debian: dpkg-dev)")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1], verbosity=1)
