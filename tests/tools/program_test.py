#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The program as its users meet it: exit statuses, one line of complaint, JSON fields, files.

Usage: program_test.py PROGRAM SOURCE_DIR [FILE_test[.CLASS[.TEST]] ...]
"""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import time
import unittest

from running import (PROGRAM, run, run_json, seconds_of_children, SLOWER, SOURCE, unseen_members, unused_options,
                     wait_until_it_listens)

# The other files, each of a family of commands. Two of them may give a class the same name.
FAMILIES = ("bundles", "census", "census_runs", "diagrams", "hex", "hostile", "inputs", "marked", "meshes", "options", "product", "schema",
            "slit", "solids", "structures")


def load_tests(loader, tests, _):
    tests.addTests(loader.loadTestsFromNames([name + "_test" for name in FAMILIES]))
    return tests


class Info(unittest.TestCase):
    def test_the_knotted_y(self):
        # Yin, section 4.2.3: two tetrahedra, one edge class, genus 2; H1 = Z^2 and a free group by Regina 7.3.
        status, info = run_json("info", "cPcbbbihq")
        self.assertEqual(status, 0)
        self.assertEqual((info["tetrahedra"], info["faces"], info["edges"], info["vertices"]), (2, 4, 1, 1))
        self.assertTrue(info["valid"] and info["orientable"] and info["connected"])
        self.assertEqual(info["signature"], "cPcbbbihq")
        self.assertEqual(info["homology"], "Z^2")
        self.assertEqual(info["boundary"], [{"kind": "ideal", "genus": 2, "orientable": True, "euler": -2}])
        self.assertEqual(len(info["group"]["generators"]), 2 + len(info["group"]["relators"]))

    def test_defects_are_named(self):
        # One tetrahedron, face 0 folded onto face 1 so that the edge 23 meets itself reversed (drawn by hand).
        text = json.dumps({"format": "tetrarch-triangulation", "version": 1, "tetrahedra": 1,
                           "gluings": [[[0, "1032"], [0, "1032"], None, None]]})
        done = run("info", "-", "--json", stdin=text)
        info = json.loads(done.stdout)
        self.assertFalse(info["valid"])
        self.assertIn("edge_reversed", [d["name"] for d in info["defects"]])
        self.assertIsNone(info["homology"])


class Convert(unittest.TestCase):
    def test_round_trips(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.json", "a.tri", "a.sig"):
                path = os.path.join(folder, name)
                self.assertEqual(run("convert", "cPcbbbiht", "-o", path).returncode, 0)
                self.assertEqual(run_json("info", path)[1]["signature"], "cPcbbbiht", name)
            first = os.path.join(folder, "a.json")
            again = os.path.join(folder, "b.json")
            run("convert", first, "-o", again)
            with open(first, "rb") as f, open(again, "rb") as g:
                self.assertEqual(f.read(), g.read())

    def test_a_file_that_snappy_refuses_is_announced(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("convert", "cPcbbbihq", "-o", os.path.join(folder, "y.tri"))
            self.assertEqual(done.returncode, 0)
            self.assertIn("warning", done.stderr)
            self.assertIn("genus 2", done.stderr)


class BadInput(unittest.TestCase):
    """Each: exit status 2, one line that names place and cause, nothing on standard output, nothing written."""

    def refuse(self, content, *wanted, name="bad.json"):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, name)
            with open(path, "wb") as f:
                f.write(content if isinstance(content, bytes) else content.encode())
            done = run("convert", name, "-o", "out.json", cwd=folder)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertEqual(done.stdout, "")
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
            self.assertLess(len(done.stderr), 400)
            for text in (name, *wanted):
                self.assertIn(text, done.stderr)
            self.assertEqual(os.listdir(folder), [name])

    def document(self, gluings, **changes):
        return json.dumps({"format": "tetrarch-triangulation", "version": 1, "tetrahedra": len(gluings),
                           "gluings": gluings, **changes}, indent=1)

    def test_an_empty_file(self):
        self.refuse("", "empty")

    def test_a_truncated_json(self):
        self.refuse(self.document([[None] * 4])[:60])

    def test_a_wrong_version(self):
        self.refuse(self.document([[None] * 4], version=99), "99")

    def test_a_face_glued_twice(self):
        self.refuse(self.document([[[1, "0123"], None, None, None],
                                   [[0, "0123"], [0, "1023"], None, None]]))

    def test_a_permutation_that_is_none(self):
        self.refuse(self.document([[[1, "0122"], None, None, None], [[0, "0122"], None, None, None]]), "0122")

    def test_a_tetrahedron_out_of_range(self):
        self.refuse(self.document([[[7, "0123"], None, None, None]]), "7")

    def test_a_wrong_letter_in_a_signature(self):
        self.refuse("cPcb!bihq\n", "'!'", name="bad.sig")
        done = run("info", "cPcbb*ihq")
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stderr.count("\n"), 1)

    def test_a_snappea_file_cut_in_the_middle(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "m.tri")
            run("convert", "cPcbbbiht", "-o", path)
            with open(path) as f:
                text = f.read()
        self.refuse(text[:len(text) // 2], name="bad.tri")

    def test_a_hundred_megabytes_of_zeros(self):
        for zero in (b"\0", b"0"):
            before = seconds_of_children()
            self.refuse(zero * 100_000_000)
            self.assertLess(seconds_of_children() - before, 20 * SLOWER)

    def test_no_such_file(self):
        done = run("info", "no/such.file")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))

    def test_bad_usage(self):
        for arguments in (["nonsense"], ["info"], ["census", "gluings", "--tetrahedra", "0"],
                          ["census", "gluings", "--tetrahedra", "2", "--links", "x"],
                          ["hyperbolize", "cPcbbbihq", "--method", "magic"], ["census", "show", "fmp9_1"],
                          ["hyperbolize", "cPcbbbihq", "--history", "h.csv"],
                          ["census", "validate", "--tetrahedra", "5"]):
            done = run(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(done.stderr.count("\n"), 1, done.stderr)

    def test_an_output_folder_that_does_not_exist(self):
        done = run("convert", "cPcbbbiht", "-o", "/no/such/folder/a.json")
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))


def listed_commands(text):
    return [re.split("  +", line.strip())[0] for line in text.splitlines() if line.startswith("  ")]


class Manners(unittest.TestCase):
    def test_no_file_of_tests_is_left_out(self):
        folder = os.path.join(SOURCE, "tests", "tools")
        parts = set()
        for name in os.listdir(folder):
            if name.endswith("_test.py"):
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    parts |= set() if "__main__" in file.read() else {name.removesuffix("_test.py")}
        self.assertEqual(parts, set(FAMILIES))

    def test_examples_work_as_typed(self):
        with tempfile.TemporaryDirectory() as folder:
            os.symlink(os.path.join(SOURCE, "tests"), os.path.join(folder, "tests"))  # examples read its data
            names = listed_commands(run("--help").stdout)
            self.assertIn("hyperbolize", names)
            self.assertIn("census gluings", names)
            for name in names:
                example = run(*name.split(), "--help").stdout.split("Example:")[1].split()
                self.assertEqual(example[0], "tetrarch")
                done = run(*example[1:], cwd=folder)
                self.assertIn(done.returncode, (0, 1), (example, done.stderr))

    def test_without_a_command_the_commands_are_listed_by_group(self):
        """`tetrarch`, `tetrarch help` and `tetrarch --help` alike; a group lists its own."""
        table = json.loads(run("help", "--json").stdout)["commands"]
        names = sorted(command["name"] for command in table)
        for arguments in ((), ("help",), ("--help",)):
            done = run(*arguments)
            self.assertEqual((done.returncode, sorted(listed_commands(done.stdout))), (0, names))
        text = run().stdout
        for group in {command["group"] for command in table}:
            self.assertEqual(text.count("\n" + group + "\n"), 1)
        for command in table:
            self.assertRegex(text, "(?m)^  " + command["name"] + " +" + re.escape(command["summary"]) + "$")
        for arguments in (("census",), ("help", "census"), ("census", "--help")):
            done = run(*arguments)
            self.assertEqual((done.returncode, sorted(listed_commands(done.stdout))),
                             (0, [name for name in names if name.startswith("census ")]))
        self.assertIn("unknown option '--jsno'", run("--jsno").stderr)
        self.assertEqual(run("census", "--version").returncode, 2)

    def test_version_names_the_libraries(self):
        done = run("--version")
        self.assertEqual(done.returncode, 0)
        for library in ("Boost", "Eigen", "GMP", "MPFR", "nlohmann-json", "CLI11", "pugixml", "zlib", "LZ4", "liblzma"):
            self.assertIn(library, done.stdout)
        linked = subprocess.run(["ldd", PROGRAM], capture_output=True, text=True).stdout
        for library in ("CHOLMOD", "libedit"):
            self.assertEqual(f", {library} " in done.stdout, f"lib{library.removeprefix('lib').lower()}.so" in linked)

    def test_an_interrupted_job_leaves_no_file(self):
        with tempfile.TemporaryDirectory() as folder:
            job = subprocess.Popen([PROGRAM, "census", "gluings", "--tetrahedra", "8", "-o", "out.txt"], cwd=folder,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
            wait_until_it_listens(job)
            time.sleep(0.5)
            job.send_signal(signal.SIGINT)
            job.communicate(timeout=60)
            self.assertEqual(job.returncode, 130)
            self.assertEqual(os.listdir(folder), [])

    def test_threads_and_locale_change_nothing(self):
        plain = run("hyperbolize", "fmp3_20", "--threads", "1").stdout
        german = run("hyperbolize", "fmp3_20", "--threads", "2", env={**os.environ, "LC_ALL": "de_DE.UTF-8"}).stdout
        self.assertEqual(plain, german)


class Errors(unittest.TestCase):
    def test_errors_are_json_where_results_are(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        path = os.path.join(folder.name, "bad.off")
        with open(path, "w", encoding="utf-8") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 zero\n0 1 0\n3 0 1 2\n")
        done = run("check", path, "--json")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        error = json.loads(done.stderr)["error"]
        self.assertEqual((error["code"], error["file"], error["line"]), ("bad_content", path, 4))
        self.assertIn("'zero'", error["message"])
        codes = {("info", "nonsense"): "unknown_name", ("info", "--bogus"): "bad_option", ("info", "m004", "--memory", "x"): "bad_option",
                 ("check", os.path.join(folder.name, "none.off")): "bad_file", ("check", "cPcbbbihq"): "bad_file", ("no_command",): "bad_option",
                 ("info", "L(6,2)"): "bad_value"}
        for words, code in codes.items():
            self.assertEqual(json.loads(run(*words, "--json").stderr)["error"]["code"], code, words)
        done = run("shell", stdin="G = group 4_1\nhyperbolize G --json\n")
        self.assertEqual(json.loads(done.stderr.splitlines()[-1])["error"]["code"], "wrong_kind", done.stderr)
        for words in (["info", "nonsense"], ["info", "--bogus"], ["no_command"]):
            done = run(*words, "--json")
            self.assertEqual((done.returncode, done.stdout), (2, ""), words)
            self.assertIsNone(json.loads(done.stderr)["error"]["file"])


if __name__ == "__main__":
    chosen = sys.argv[3:]
    well = unittest.main(None if chosen else "__main__", argv=[sys.argv[0], *chosen], exit=False).result.wasSuccessful()
    all_of_them = well and not chosen
    unused = unused_options() if all_of_them else []
    unseen = unseen_members() if all_of_them else []
    if unused:
        print("no test uses " + ", ".join(unused), file=sys.stderr)
    if unseen:
        print("no test shows " + ", ".join(unseen), file=sys.stderr)
    sys.exit(0 if well and not unused and not unseen else 1)
