#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""A copy installed into a folder of its own, and moved: the program, its samples, texts, pages and completions, the
library as another project uses it.

Usage: install_test.py BUILD_DIR SOURCE_DIR CXX_COMPILER
"""
import ctypes
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

BUILD, SOURCE = (pathlib.Path(path).resolve() for path in sys.argv[1:3])
COMPILER = sys.argv[3]
HERE = pathlib.Path(__file__).resolve().parent
FOLDER = tempfile.TemporaryDirectory()
WORK = pathlib.Path(FOLDER.name)
PREFIX = WORK / "elsewhere"

TYPES = "true or false|integer|number|text|a word|list|object|null"
# Yin, section 4.2.3, and Frigerio-Martelli-Petronio 2004: two regular truncated tetrahedra of angle pi/6.
KNOTTED_Y, VOLUME = "cPcbbbihq", "6.451990270835"


def run(*command, **options):
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, timeout=300, **options)
    if done.returncode != 0:
        raise AssertionError(f"{command}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


def setUpModule():
    run("cmake", "--install", BUILD, "--prefix", WORK / "first")
    # What names the folder it was installed into would now miss it.
    (WORK / "first").rename(PREFIX)


def tearDownModule():
    FOLDER.cleanup()


def program(*arguments):
    return run(PREFIX / "bin/tetrarch", *arguments, cwd=WORK)


def table():
    return json.loads(program("help", "--json"))


# In a mount namespace of its own the folders $1 and $2 are empty; the rest is the command. Without the right to make
# one, as in some containers, it says 99.
OUT_OF_REACH = """mount -t tmpfs none "$1" && mount -t tmpfs none "$2" || exit 99
shift 2
exec "$@"
"""


def with_nothing_else(*command, **options):
    """Runs a command to which the source tree and the build folder look empty; None where that cannot be had."""
    # The build folder first: it may lie in the source tree.
    hidden = ["unshare", "--map-root-user", "--mount", "sh", "-c", OUT_OF_REACH, "sh", BUILD, SOURCE, *command]
    done = subprocess.run([str(word) for word in hidden], capture_output=True, text=True, timeout=300, **options)
    return None if done.returncode == 99 or done.stderr.startswith("unshare:") else done


class Program(unittest.TestCase):
    def test_it_runs(self):
        self.assertIn(f"volume      {VOLUME}\n", program("hyperbolize", KNOTTED_Y))

    def test_it_names_no_place_of_the_source_tree(self):
        self.assertNotIn(str(SOURCE).encode() + b"/", (PREFIX / "bin/tetrarch").read_bytes())

    def test_it_brings_its_samples(self):
        for path in (PREFIX / "share/tetrarch/samples").iterdir():
            originals = [file.read_bytes() for file in (SOURCE / "tests/data").rglob(path.name)]
            self.assertIn(path.read_bytes(), originals, path)
        self.assertLess(sum(path.stat().st_size for path in (PREFIX / "share/tetrarch/samples").iterdir()), 2e6)

    def test_a_file_here_comes_before_a_sample_of_its_name(self):
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "samples").mkdir()
            shutil.copy(SOURCE / "tests/data/mesh/cube.off", pathlib.Path(folder) / "samples/torus.off")
            said = [run(PREFIX / "bin/tetrarch", "check", "samples/torus.off", cwd=place) for place in (folder, WORK)]
        self.assertIn("sphere", said[0])
        self.assertIn("torus", said[1])

    def test_a_sample_that_is_not_there(self):
        done = subprocess.run([PREFIX / "bin/tetrarch", "check", "samples/tours.off"], cwd=WORK, capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 2)
        self.assertRegex(done.stderr, r"^tetrarch: samples/tours.off: no such file, and no such sample \(.*torus.off.*\)\n$")

    def test_every_example_of_every_help_works_in_an_empty_folder(self):
        seen = set()
        for command in table()["commands"]:
            name = command["name"].split()
            example = program(*name, "--help").split("Example:")[1].strip().splitlines()[0].strip()
            self.assertEqual(example, command["example"])
            words = shlex.split(example)
            with tempfile.TemporaryDirectory() as folder:
                done = with_nothing_else(PREFIX / "bin/tetrarch", *words[1:], cwd=folder)
                if done is None:
                    done = subprocess.run([PREFIX / "bin/tetrarch", *words[1:]], cwd=folder, capture_output=True,
                                          text=True, timeout=300)
                # 1: proved not to be isometric, say
                self.assertIn(done.returncode, (0, 1), f"{example}: {done.stderr}")
                for k, word in enumerate(words):
                    if word == "-o":
                        self.assertGreater((pathlib.Path(folder) / words[k + 1]).stat().st_size, 0, example)
            seen.add(words[1])
        self.assertTrue({"check", "truncate", "bundle", "slit", "register", "product", "shell", "view"} <= seen)


class Texts(unittest.TestCase):
    share = PREFIX / "share"
    folder = PREFIX / "share/doc/tetrarch"

    def test_they_are_there(self):
        share = self.share
        for name in ("CHANGELOG.md", "LICENSE"):
            self.assertEqual((share / "doc/tetrarch" / name).read_bytes(), (SOURCE / name).read_bytes())
        census = [path.relative_to(SOURCE) for path in (SOURCE / "census").rglob("*.json")]
        self.assertTrue({"fmp2.json", "fmp3.json", "triangulation.schema.json"} <= {path.name for path in census})
        for path in census:
            self.assertEqual((share / "tetrarch" / path).read_bytes(), (SOURCE / path).read_bytes(), path)
        guide = {path.name for path in (SOURCE / "tools/guide").glob("*.*") if path.suffix in (".md", ".png", ".svg", ".ipynb")}
        self.assertEqual({path.name for path in (self.folder / "guide").iterdir()}, guide)

    def test_their_links_lead_somewhere(self):
        for page in self.folder.rglob("*.md"):
            text = page.read_text(encoding="utf-8")
            for link in re.findall(r'\]\(([^)#]+)[^)]*\)|src="([^"]+)"', text):
                (place,) = [part for part in link if part]
                if "://" not in place:
                    self.assertTrue((page.parent / place).exists(), f"{page}: {place}")

    def test_their_commands_name_samples_that_are_there(self):
        names = {path.name for path in (self.share / "tetrarch/samples").iterdir()}
        for page in self.folder.rglob("*.md"):
            for line in page.read_text(encoding="utf-8").splitlines():
                # One page shows what is said of a file that is not there.
                if re.match(r"    \$ tetrarch|    tetrarch> ", line) and "nothing.mesh" not in line:
                    self.assertNotIn("tests/data", line, page)
                    self.assertLessEqual(set(re.findall(r"samples/([\w.]+)", line)), names, f"{page}: {line}")


class Pages(unittest.TestCase):
    folder = PREFIX / "share/man/man1"

    def test_each_command_has_one_and_nothing_else_has(self):
        names = {"tetrarch"} | {"tetrarch-" + command["name"].replace(" ", "-") for command in table()["commands"]}
        self.assertEqual({page.stem for page in self.folder.iterdir()}, names)

    @unittest.skipUnless(shutil.which("groff"), "groff is missing")
    def test_groff_has_no_complaint(self):
        for page in self.folder.iterdir():
            done = subprocess.run(["groff", "-man", "-ww", "-b", "-Tutf8", "-z", page], capture_output=True, text=True)
            self.assertEqual((done.returncode, done.stderr), (0, ""), page)

    @unittest.skipUnless(shutil.which("groff"), "groff is missing")
    def test_what_they_say_is_the_table(self):
        for command in table()["commands"]:
            page = self.folder / f"tetrarch-{command['name'].replace(' ', '-')}.1"
            # One long line a paragraph, no hyphenation, no bold: the text as it stands in the table.
            text = run("groff", "-man", "-Tascii", "-P-cbou", "-rLL=9999n", page)
            for option in command["options"]:
                for name in option["names"]:
                    self.assertRegex(text, rf"(^|[ ,]){re.escape(name)}\b", page)
                self.assertIn(option["help"], text)
            for field in command.get("result", []):
                unit = f", {field['unit']}" if field["unit"] else ""
                self.assertRegex(text, rf"(?m)^ *{field['name']} \(({TYPES})( or ({TYPES}))*{re.escape(unit)}\)")
                self.assertIn(field["meaning"][1:], text)
            self.assertEqual("result" in command, "\nRESULT\n" in text, page)
            self.assertIn(command["example"], text)
            for title in ("NAME", "SYNOPSIS", "DESCRIPTION", "COMMON OPTIONS", "EXIT STATUS", "EXAMPLES", "SEE ALSO"):
                self.assertIn(f"\n{title}\n", text)


class Completions(unittest.TestCase):
    bash = PREFIX / "share/bash-completion/completions/tetrarch"
    zsh = PREFIX / "share/zsh/site-functions/_tetrarch"

    def offered(self, *words):
        """What bash offers for the last of the words that follow the program's name."""
        script = (f"set -u; . {self.bash}; COMP_WORDS=(tetrarch \"$@\"); COMP_CWORD=$#; _tetrarch\n"
                  "[ ${#COMPREPLY[@]} -eq 0 ] || printf '%s\\n' \"${COMPREPLY[@]}\"")
        return run("bash", "-c", script, "bash", *words, cwd=SOURCE).splitlines()

    def test_commands_by_one_word_or_two(self):
        commands = [command["name"] for command in table()["commands"]]
        self.assertEqual(set(self.offered("")), {name.split()[0] for name in commands} | {"--help", "--version"})
        self.assertEqual(self.offered("hyp"), ["hyperbolize"])
        self.assertEqual(self.offered("census", "s"), ["show"])
        self.assertEqual(self.offered("help", "census", "v"), ["validate"])
        self.assertEqual(self.offered("nosuch", ""), [])

    def test_options_of_the_command_and_common_ones(self):
        for command in table()["commands"]:
            names = {name for option in command["options"] + table()["common"] for name in option["names"]}
            self.assertEqual(set(self.offered(*command["name"].split(), "-")), names | {"-h", "--help"})

    def test_choices(self):
        self.assertEqual(self.offered("hyperbolize", "--method", ""), ["newton", "flow"])
        self.assertEqual(self.offered("hyperbolize", "--method", "=", "f"), ["flow"])
        self.assertEqual(self.offered("hyperbolize", "--attempts", ""), [])

    def test_names_and_files(self):
        self.assertEqual(self.offered("info", "fmp2_"), [f"fmp2_{n}" for n in range(1, 9)])
        self.assertEqual(self.offered("census", "show", "fmp3_15"), ["fmp3_15", "fmp3_150", "fmp3_151"])
        self.assertEqual(self.offered("isometric", "--seed", "2", "fmp2_1", "tests/data/knotted_y.j"),
                         ["tests/data/knotted_y.json"])
        self.assertEqual(self.offered("info", "fmp2_1", "fmp2_"), [], "info takes one argument")
        self.assertEqual(self.offered("slit", "fmp2_"), [], "a surface is a file")
        self.assertEqual(self.offered("convert", "fmp2_1", "-o", "CHANGE"), ["CHANGELOG.md"])

    @unittest.skipUnless(shutil.which("zsh"), "zsh is missing")
    def test_zsh_can_read_its_own(self):
        run("zsh", "-n", self.zsh)

    def test_zsh_is_offered_the_same(self):
        text = self.zsh.read_text(encoding="utf-8")
        for command in table()["commands"]:
            specifications = text.split(f"    '{command['name']}')\n", 1)[1].split(" ;;", 1)[0]
            for option in command["options"] + table()["common"]:
                for name in option["names"]:
                    self.assertRegex(specifications, rf"[)*]{re.escape(name)}[=+]?\[")


class Library(unittest.TestCase):
    def test_another_project_finds_and_uses_it(self):
        build = WORK / "build"
        run("cmake", "-S", HERE, "-B", build, f"-DCMAKE_PREFIX_PATH={PREFIX}", f"-DCMAKE_CXX_COMPILER={COMPILER}",
            "-DCMAKE_BUILD_TYPE=Release")
        run("cmake", "--build", build)
        self.assertEqual(run(build / "knotted_y", KNOTTED_Y), VOLUME + "\n")
        self.check_shared_object(build / "libvolume.so")
        # The knotted Y of the dissertation, section 4.2.3, from its mesh: 5_3's exterior, the eighth manifold of the table.
        told = run(build / "mesh_to_name", SOURCE / "tests/data/knotted_y_8k.mesh")
        self.assertIn(f"volume: {VOLUME}\n", told)
        self.assertIn("name: fmp2_8\n", told)

    def check_shared_object(self, file):
        """One of twenty lines, into which the static library went, as any other program may load it."""
        volume = ctypes.CDLL(file).volume_of
        volume.argtypes, volume.restype = [ctypes.c_char_p], ctypes.c_double
        self.assertAlmostEqual(volume(KNOTTED_Y.encode()), float(VOLUME), 12)
        self.assertEqual(volume(b"no signature"), -1)

    def test_a_later_version_is_refused(self):
        project = WORK / "later"
        project.mkdir()
        (project / "CMakeLists.txt").write_text("cmake_minimum_required(VERSION 3.25)\nproject(later NONE)\n"
                                                "find_package(tetrarch 1.0 REQUIRED)\n", encoding="utf-8")
        done = subprocess.run(["cmake", "-S", project, "-B", project / "build", f"-DCMAKE_PREFIX_PATH={PREFIX}"],
                              capture_output=True, text=True)
        self.assertNotEqual(done.returncode, 0)
        self.assertIn("compatible with requested version", done.stderr)

    def test_no_file_of_it_names_a_place(self):
        for file in PREFIX.glob("lib*/**/cmake/tetrarch/*.cmake"):
            text = file.read_text(encoding="utf-8")
            for place in (str(BUILD), str(SOURCE), str(WORK), "/usr/"):
                self.assertNotIn(place, text, file)

    def test_every_header_is_there(self):
        headers = [path.relative_to(SOURCE) for path in (SOURCE / "include").rglob("*.hpp")]
        self.assertGreater(len(headers), 0)
        for header in headers:
            self.assertTrue((PREFIX / header).is_file(), header)


if __name__ == "__main__":
    os.environ["LC_ALL"] = "C.UTF-8"
    unittest.main(argv=sys.argv[:1], verbosity=1)
