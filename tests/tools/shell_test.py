#!/usr/bin/python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The shell as its users meet it: at a terminal, from a script, at the end of a pipe.

Usage: shell_test.py PROGRAM SOURCE_DIR
"""
import itertools
import json
import os
import re
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import pexpect
except ImportError:
    print("skipped: python3-pexpect is not installed")
    sys.exit(77)

PROGRAM = os.path.abspath(sys.argv[1])
SOURCE = os.path.abspath(sys.argv[2])
PROMPT = "tetrarch> "


def pipe(*lines, arguments=(), cwd=SOURCE):
    return subprocess.run([PROGRAM, "shell", *arguments], input="".join(line + "\n" for line in lines),
                          capture_output=True, text=True, timeout=300, cwd=cwd)


class Terminal:
    """The shell in a terminal of its own; its history is kept in a folder."""

    def __init__(self, folder):
        env = dict(os.environ, XDG_STATE_HOME=folder, HOME=folder, TERM="xterm")
        self.child = pexpect.spawn(PROGRAM, ["shell"], cwd=SOURCE, env=env, encoding="utf-8", timeout=60,
                                   dimensions=(40, 160))
        self.child.expect_exact(PROMPT)

    def type(self, keys):
        self.child.send(keys)

    def line(self, text):
        """Types a line, and gives what is printed up to the next prompt."""
        self.type(text + "\r")
        self.child.expect_exact("\n")
        self.child.expect_exact(PROMPT)
        return self.child.before

    def shows(self, text):
        self.child.expect_exact(text)

    def quit(self):
        self.type("quit\r")
        self.child.expect(pexpect.EOF)
        self.child.close()
        return self.child.exitstatus


@unittest.skipUnless(b"edit" in subprocess.run(["ldd", PROGRAM], capture_output=True).stdout, "built without libedit")
class AtTheTerminal(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.terminal = Terminal(self.folder.name)

    def tearDown(self):
        self.terminal.child.close(force=True)
        self.folder.cleanup()

    def test_completion(self):
        t = self.terminal
        t.line("Y = cPcbbbihq")
        t.line("Yardstick = fmp2_1")
        for begun, rest in (("trunc", "ate "), ("census val", "idate "), ("help hyp", "erbolize "),
                            ("hyperbolize Y --met", "hod "), ("hyperbolize Y --method n", "ewton "),
                            ("info --se", "ed "), ("info Yar", "dstick "), ("census show fmp2_", ""), ("Z = tru", "ncate "),
                            ("check tests/data/mesh/double", "_torus.off "), ("info tests/da", "ta/"),
                            ("slit --distance tests/da", "ta/"), ("slit --distance Yar", "dstick "), ("slit --punch Yar", ""),
                            ("slit -o Yar", ""), ("slit --punch tests/da", ""),
                            ("move Yard", "stick "), ("move Y two_th", "ree "), ("move Y --list thr", "ee_two "),
                            ("move Y 1-4 0 clo", "se_book "), ("Y = move Y op", "en_book "), ("move Y Yard", "")):
            t.type(begun + "\t|")
            moves = r"(?:[\r\x07]|\x1b\[\d*[A-Z])*"  # of the cursor
            t.child.expect(re.escape(begun.split()[-1]) + moves + re.escape(rest) + moves + r"\|")
            t.type("\x03")  # Ctrl-C gives the line up
            t.shows(PROMPT)

    def test_what_is_not_decided_is_listed(self):
        t = self.terminal
        t.type("census \t")
        for verb in ("enumerate", "gluings", "identify", "list", "show", "validate"):
            t.shows(verb)
        t.shows(PROMPT + "census ")
        t.type("\x03")
        t.shows(PROMPT)
        t.type("canonize m41\t")  # names of the cusped census, too
        for name in ("m410", "m414"):
            t.shows(name)

    def test_history_of_this_session_and_the_last(self):
        t = self.terminal
        self.assertIn("signature   cPcbbbihq", t.line("info cPcbbbihq"))
        t.line("values")
        t.type("\x1b[A\x1b[A\r")  # up, up
        t.shows("signature   cPcbbbihq")
        t.shows(PROMPT)
        self.assertEqual(t.quit(), 0)
        self.terminal = t = Terminal(self.folder.name)
        t.type("\x1b[A\x1b[A\r")  # past `quit`
        t.shows("signature   cPcbbbihq")

    def test_interrupting_a_long_census_keeps_the_values(self):
        t = self.terminal
        t.line("Y = fmp2_8")
        t.type("census enumerate --tetrahedra 5\r")  # hours
        time.sleep(1.5)
        start = time.monotonic()
        t.child.sendintr()
        t.shows("interrupted; nothing was written")
        self.assertLess(time.monotonic() - start, 10)
        t.shows(PROMPT)
        self.assertIn("fmp2_8", t.line("values"))
        t.type("census enumerate --tetrahedra 5\r")  # and again
        time.sleep(0.5)
        t.child.sendintr()
        t.shows("interrupted")
        t.shows(PROMPT)
        self.assertIn("volume      6.451990270835", t.line("hyperbolize Y"))

    def test_every_job_is_asked_anew_to_stop(self):
        for _ in range(6):  # a job that did not listen would be given up after four times
            self.terminal.type("census enumerate --tetrahedra 5\r")
            time.sleep(0.3)
            self.terminal.child.sendintr()
            self.terminal.shows("interrupted; nothing was written")
            self.terminal.shows(PROMPT)
        self.assertEqual(self.terminal.quit(), 0)

    def test_a_line_given_up_does_nothing(self):
        t = self.terminal
        t.type("Y = cPcbbbihq\x03")
        t.shows("^C")
        t.shows(PROMPT)
        self.assertIn("no values yet", t.line("values"))

    def test_the_end_of_input_ends_the_session(self):
        self.terminal.type("\x04")
        self.terminal.child.expect(pexpect.EOF)
        self.terminal.child.close()
        self.assertEqual(self.terminal.child.exitstatus, 0)


class Scripts(unittest.TestCase):
    def test_an_error_names_its_line_and_ends_the_script(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "script.txt")
            with open(path, "w") as f:
                f.write("# two manifolds\nY = cPcbbbihq\nhyperbolise Y\ninfo Y\n")
            done = subprocess.run([PROGRAM, "shell", path], capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 2)
            self.assertEqual(done.stderr, f"{path}:3: unknown command 'hyperbolise' (did you mean 'hyperbolize'?)\n")
            self.assertEqual(done.stdout, "Y: triangulation of 2 tetrahedra\n")

    def test_a_pipe(self):
        done = pipe("Y = fmp2_8", "isometric Y cPcbbbihq", "isometric Y fmp2_1", "values")
        self.assertEqual((done.returncode, done.stderr), (0, ""))  # "not isometric" is an answer
        self.assertIn("not isometric", done.stdout)
        self.assertTrue(done.stdout.endswith("Y  fmp2_8, triangulation of 2 tetrahedra\n"))

    def test_what_is_undecided_does_not_end_a_script(self):
        done = pipe("hyperbolize cMcabbgqw --as-given", "Y = cPcbbbihq")  # RP^3
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("not found", done.stdout)
        self.assertTrue(done.stdout.endswith("Y: triangulation of 2 tetrahedra\n"))

    def test_interrupting_a_script_ends_it(self):
        child = subprocess.Popen([PROGRAM, "shell"], stdin=subprocess.PIPE, stdout=subprocess.PIPE,
                                 stderr=subprocess.PIPE, text=True)
        child.stdin.write("census enumerate --tetrahedra 5\nvalues\n")
        child.stdin.close()
        time.sleep(1)
        child.send_signal(2)
        self.assertEqual(child.wait(20), 130)
        self.assertEqual(child.stderr.read(), "standard input:1: interrupted; nothing was written\n")
        self.assertEqual(child.stdout.read(), "")
        child.stdout.close()
        child.stderr.close()

    def test_scripts_run_scripts_but_not_for_ever(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "again.txt")
            with open(path, "w") as f:
                f.write(f"run {path}\n")
            done = pipe(f"run {path}")
            self.assertEqual(done.returncode, 2)
            self.assertIn("does this file run itself?", done.stderr)
            with open(path, "w") as f:
                f.write("Y = cPcbbbihq\n")
            done = pipe(f"run {path}", "print Y")
            self.assertEqual(done.stdout.splitlines()[-1], "Y = cPcbbbihq")

    def test_values_without_files(self):
        """The kinds of values, each shown by its name alone."""
        done = pipe("Y = truncate tests/data/knotted_y_8k.mesh", "M = tests/data/knotted_y_8k.mesh",
                    "S = tests/data/mesh/torus.off", "G = group Y", "T = < x, y | x^3, x*y*X*Y >", "values", "T")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        tail = done.stdout[done.stdout.rindex("G  group"):]
        self.assertIn("M  mesh of 7709 tetrahedra, 1916 vertices", tail)
        self.assertIn("S  surface of ", tail)
        self.assertIn("abelianized  Z + Z/3", tail)  # by hand

    def test_a_mesh_is_given_to_every_verb_that_reads_one(self):
        done = pipe("M = tests/data/knotted_y_8k.mesh", "Y = truncate M", "census identify Y", "check M")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("name    fmp2_8", done.stdout)
        self.assertIn("7709 tetrahedra on 1916 vertices: a manifold", done.stdout)

    def test_refusals(self):
        for lines, message in (
                (["info = cPcbbbihq"], "'info' is a verb and can name no value"),
                (["Y = info cPcbbbihq"], "this verb makes no value that Y could name"),
                (["Y ="], "there is nothing after Y ="),
                (["G = < a | >", "info G"], "G is a group (expected a triangulation)"),
                (["Y = cPcbbbihq", "check Y"], "Y is a triangulation (expected a mesh: it has no coordinates)"),
                (["Yes = cPcbbbihq", "log Yess"], "no value is called 'Yess' (did you mean 'Yes'?)"),
                (["undo"], "there is nothing to undo"),
                (["info 'cPcbbbihq"], "a quote ' does not end"),
                (["G = < a, b | abc >"], "found 'c', expected a generator that is listed before the bar"),
                (["ifno cPcbbbihq"], "unknown command 'ifno' (did you mean 'info'?)"),
                (["hyper cPcbbbihq"], "unknown command 'hyper' (did you mean 'hyperbolize'?)"),
                (["hyperbolize cPcbbbihq --metohd flow"],
                 "unknown option '--metohd' of 'hyperbolize' (did you mean '--method'?)"),
                (["truncat tests"], "unknown command 'truncat' (did you mean 'truncate'?)"),
                (["truncate --outptu x"], "unknown option '--outptu' of 'truncate' (did you mean '--output'?)")):
            done = pipe(*lines)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1), (lines, done.stderr))
            self.assertIn(message, done.stderr)
            self.assertTrue(done.stderr.startswith(f"standard input:{len(lines)}: "), done.stderr)

    def test_what_convert_prints_is_taken(self):
        """A JSON object over many lines is one value, wherever it stands."""
        text = subprocess.run([PROGRAM, "convert", "fmp2_8"], capture_output=True, text=True, check=True).stdout
        self.assertGreater(text.count("\n"), 5)
        done = pipe("Y = " + text.rstrip(), text.rstrip(), "census identify Y")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("name    fmp2_8", done.stdout)
        done = pipe("Y = cPcbbbihq", "Z = {", '"format": "a } in a text"')
        self.assertEqual(done.returncode, 2)
        self.assertTrue(done.stderr.startswith("standard input:2: "), done.stderr)

    def test_a_long_signature_does_not_fill_the_screen(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "many.sig")
            subprocess.run([PROGRAM, "subdivide", "cPcbbbihq", "--finite", "--barycentric", "2", "-o", path], check=True,
                           capture_output=True)
            with open(path) as f:
                whole = f.read().strip()
            done = pipe("M = " + path, "M", "convert M --to sig")
        self.assertEqual(done.returncode, 0)
        shown = [line for line in done.stdout.splitlines() if line.startswith("signature")][0]
        self.assertLess(len(shown), 200)
        self.assertIn(f"{whole[:60]}... ({len(whole)} characters", shown)
        self.assertEqual(done.stdout.splitlines()[-1], whole)

    def test_json_is_an_object_a_line_with_the_name(self):
        lines = ("Y = truncate tests/data/knotted_y_8k.mesh", "Z = fmp2_8", "isometric Y Z", "info nothing_here", "Y",
                 "values")
        done = subprocess.run([PROGRAM, "shell", "--json", "--keep-going"], input="\n".join(lines), capture_output=True,
                              text=True, cwd=SOURCE)
        self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
        told = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([entry["line"] for entry in told], list(lines))
        self.assertEqual([entry["name"] for entry in told], ["Y", "Z", None, None, None, None])
        self.assertEqual([entry["status"] for entry in told], [0, 0, 0, 2, 0, 0])
        self.assertEqual(told[0]["result"]["signature"], "cPcbbbihq")
        self.assertIs(told[2]["result"]["isometric"], True)
        self.assertIn("nothing_here", told[3]["error"])
        self.assertEqual(sorted(told[5]["result"]), ["Y", "Z"])
        # Unless asked, the first error ends it.
        done = subprocess.run([PROGRAM, "shell", "--json"], input="\n".join(lines), capture_output=True, text=True, cwd=SOURCE)
        self.assertEqual((done.returncode, len(done.stdout.splitlines())), (2, 4))

    def test_options_for_the_whole_session(self):
        done = pipe("info cPcbbbihq", "Y = fmp2_8", arguments=("--json", "--quiet"))
        info, value = (json.loads(line) for line in done.stdout.splitlines())
        self.assertEqual((info["result"]["signature"], value["name"]), ("cPcbbbihq", "Y"))


class Moves(unittest.TestCase):
    def test_a_move_changes_its_value_and_undo_takes_it_back(self):
        done = pipe("Y = cPcbbbihq", "move Y 2-3 0 0", "undo", "print Y", "undo", "values")
        self.assertIn("\ntetrahedra  3\n", done.stdout)
        self.assertTrue(done.stdout.endswith("Y is what it was before: move Y 2-3 0 0\nY = cPcbbbihq\n"
                                             "Y is gone, as before: Y = cPcbbbihq\nno values yet\n"))

    def test_what_is_undone_is_not_in_the_log(self):
        done = pipe("Y = cPcbbbihq", "move Y 2-3 0 0", "undo", "log Y")
        self.assertTrue(done.stdout.endswith("\nY = cPcbbbihq\n"), done.stdout)

    def test_typed_moves_number_tetrahedra_anew(self):
        legal = pipe("Y = cPcbbbihq", "move Y 2-3 0 0", "move Y --list 3-2").stdout
        legal = [line for line in legal.splitlines() if line.startswith("three_two")]
        self.assertTrue(legal)
        for move in legal:  # of three tetrahedra two are left, 0 and 1
            for after in ("1-4 0", "1-4 1"):
                self.assertIn("\ntetrahedra  5\n", pipe("Y = cPcbbbihq", "move Y 2-3 0 0", f"move Y {move} {after}").stdout)

    def test_digits_name_the_same_moves(self):
        same = (("2-3 0 0", "two_three 0 0"), ("1-4 1", "one_four 1"), ("0-2 0 1", "zero_two_face 0 1"),
                ("0-2 0 0 1 1", "zero_two_edge 0 0 1 1"))
        for digits, name in same:
            a, b = (json.loads(pipe("Y = cPcbbbihq", f"move Y {move} --json").stdout.split("\n", 1)[1])["signature"]
                    for move in (digits, name))
            self.assertEqual(a, b)
        # Undone by what it is the inverse of: a pillow blown up over a face collapses around its inner vertex.
        done = pipe("Y = cPcbbbihq", "move Y 0-2 0 0", "move Y --list 2-0")
        for move in [line for line in done.stdout.splitlines() if line.startswith("two_zero")]:
            digits = re.sub("two_zero_[a-z]*", "2-0", move)
            self.assertIn("signature   cPcbbbihq", pipe("Y = cPcbbbihq", "move Y 0-2 0 0", f"move Y {digits}").stdout)
        self.assertIn("two_zero", done.stdout)

    def test_all_legal_moves_are_listed(self):
        """What can be made by any move with any numbers can be made by one that is listed."""
        kinds = {"one_four": 1, "shell": 1, "four_one": 2, "two_zero_vertex": 2, "two_three": 2, "zero_two_face": 2,
                 "open_book": 2, "three_two": 3, "two_zero_edge": 3, "close_book": 3, "merge": 3, "two_one": 3, "pinch": 3,
                 "four_four": 4, "zero_two_edge": 4, "cone": 2}
        ball = '{"format":"tetrarch-triangulation","version":1,"tetrahedra":1,"gluings":[[null,null,null,null]]}'
        book = ball.replace(":1,\"gluings\"", ":2,\"gluings\"").replace(
            "[[null,null,null,null]]", '[[null,null,[1,"0123"],[1,"0123"]],[null,null,[0,"0123"],[0,"0123"]]]')
        met = set()
        for made in (["Y = cPcbbbihq"], ["Y = cMcabbgqw"], [f"Y = {ball}"], [f"Y = {ball}", "move Y 1-4 0"],
                     [f"Y = {book}"], ["Y = cMcabbgqw", "move Y 1-4 0"], ["Y = cMcabbgqw", "move Y 1-4 0 pinch 0 0 1"],
                     [f"Y = {ball}", "move Y 1-4 0 0-2 0 1"]):
            decoder = json.JSONDecoder()
            value = pipe(*made, "print Y").stdout.splitlines()[-1].removeprefix("Y = ")
            text = pipe(f"info '{value}' --json", f"move '{value}' --list --json").stdout
            info, end = decoder.raw_decode(text)
            listed = decoder.raw_decode(text[end:].lstrip())[0]["moves"]
            met |= {move.split()[0] for move in listed}
            size = info["tetrahedra"]
            every = []
            for kind, numbers in kinds.items():
                places = [(t, *rest) for t in range(size)
                          for rest in itertools.product(*([range(4)] * min(numbers - 1, 2)))]
                if numbers == 4:
                    places = [(*place, last) for place in places for last in range(2 if kind == "four_four" else 12)]
                every += [" ".join(map(str, (kind, *place))) for place in places]

            def results(moves):
                text = pipe(*(f"move '{value}' {move} --json" for move in moves)).stdout
                found, answers = set(), 0
                while text:
                    result, end = decoder.raw_decode(text)
                    text = text[end:].lstrip()
                    answers += 1
                    if "obstacle" not in result:
                        found.add((result["signature"], result["tetrahedra"]))
                self.assertEqual(answers, len(moves))
                return found

            every = [move for move in every if len(set(move.split()[2:4])) == len(move.split()[2:4])]
            self.assertEqual(results(listed), results(every), made)
        self.assertEqual(set(kinds) - met, set())

    def test_unknown_moves_get_the_nearest_suggested(self):
        for line, message in (("move cPcbbbihq two_thre 0 1", "unknown move 'two_thre' (did you mean 'two_three'?)"),
                              ("move cPcbbbihq --list mrge", "unknown move 'mrge' (did you mean 'merge'?)"),
                              ("move cPcbbbihq 2-3 0", "found 1 after '2-3', expected 2 numbers"),
                              ("move cPcbbbihq 1-4", "found 0 after '1-4', expected 1 number"),
                              ("move cPcbbbihq 2-0 0", "found 1 after '2-0', expected 3 numbers")):
            self.assertIn(message, pipe(line).stderr)

    def test_a_move_under_another_name_leaves_the_value(self):
        done = pipe("Y = cPcbbbihq", "Z = move Y 1-4 0", "print Y")
        self.assertIn("tetrahedra  5", done.stdout)
        self.assertTrue(done.stdout.endswith("Y = cPcbbbihq\n"))

    def test_an_illegal_move_is_an_answer_and_changes_nothing(self):
        done = pipe("Y = cPcbbbihq", "move Y 3-2 0 0 1", "print Y")
        self.assertEqual(done.returncode, 0)
        self.assertIn("illegal", done.stdout)
        self.assertTrue(done.stdout.endswith("Y = cPcbbbihq\n"))

    def test_the_log_makes_the_value_again(self):
        made = ["Y = truncate tests/data/knotted_y_8k.mesh", "move Y 2-3 0 0", "move Y 2-3 1 1 1-4 0",
                "Z = move Y 2-3 0 1"]
        done = pipe(*made, "log Z")
        log = done.stdout.splitlines()[-len(made):]
        self.assertEqual(log, made)
        first = pipe(*made, "print Z").stdout.splitlines()[-1]
        self.assertEqual(pipe(*log, "print Z").stdout.splitlines()[-1], first)

    def test_listed_moves_are_legal_and_the_others_are_not(self):
        # All 2-3 moves of the eight manifolds of two tetrahedra: across each face between different tetrahedra.
        for k in range(1, 9):
            done = pipe(f"Y = fmp2_{k}", "skeleton Y --json", "move Y --list 2-3 --json")
            decoder = json.JSONDecoder()
            text = done.stdout[done.stdout.index("{"):]
            skeleton, end = decoder.raw_decode(text)
            listed = decoder.raw_decode(text[end:].lstrip())[0]["moves"]
            between = [f for f in skeleton["faces"] if len({side.split(":")[0] for side in f["preimages"]}) == 2]
            self.assertEqual(len(listed), len(between))
            for move in listed:
                self.assertIn("tetrahedra  3", pipe(f"Y = fmp2_{k}", f"move Y {move}").stdout)

    def test_the_log_of_a_simplification_replays(self):
        with tempfile.TemporaryDirectory() as folder:
            log = os.path.join(folder, "moves.log")
            done = pipe(f"A = simplify gvLQQedfedffrwawrhh --moves {log}", f"B = move gvLQQedfedffrwawrhh --log {log}",
                        "print A B")
            a, b = (line[4:] for line in done.stdout.splitlines()[-2:])
            self.assertEqual(a, b)


class Printing(unittest.TestCase):
    def test_what_is_printed_can_be_pasted(self):
        lines = ["Y = truncate tests/data/knotted_y_8k.mesh", "H = hyperbolize Y", "G = group Y", "S = cPcbbbihq",
                 "N = fmp3_100", "L = tests/data/frozen/1/group.json"]
        printed = [line for line in pipe(*lines, "print").stdout.splitlines() if re.match("[A-Z] = ", line)]
        self.assertEqual(len(printed), len(lines))
        again = [line for line in pipe(*printed, "print").stdout.splitlines() if re.match("[A-Z] = ", line)]
        self.assertEqual(again, printed)
        self.assertIn('"volume":6.4519902708', printed[1])
        with open(os.path.join(SOURCE, "tests/data/frozen/1/group.json"), encoding="utf-8") as file:
            said = json.load(file)
        self.assertEqual(json.loads(next(line[4:] for line in printed if line.startswith("L"))), said)

    def test_meshes_are_printed_with_their_fields(self):
        lines = ["S = slit tests/data/frozen/1/frustum.json", "N = tests/data/frozen/1/unknown_mesh_members.json"]
        done = pipe(*lines, "values", "print")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertRegex(done.stdout, r"\nS  surface of 72 triangles, 48 vertices, with place, texture, log_radius")
        printed = [line for line in done.stdout.splitlines() if re.match("[A-Z] = ", line)]
        self.assertEqual([line[0] for line in printed], ["N", "S"])
        again = [line for line in pipe(*printed, "print").stdout.splitlines() if re.match("[A-Z] = ", line)]
        self.assertEqual(again, printed)
        printed = {line[0]: json.loads(line[4:]) for line in printed}
        with open(os.path.join(SOURCE, "tests/data/frozen/1/unknown_mesh_members.json"), encoding="utf-8") as file:
            self.assertEqual(printed["N"], json.load(file))
        log_radius = next(f["values"] for f in printed["S"]["fields"] if f["name"] == "log_radius")
        self.assertAlmostEqual(max(log_radius), 0, places=12)  # the outer circle has radius 1

    def test_everything_saved_from_a_session_is_what_it_was(self):
        """Values made by the verbs, written by `convert` or the verb itself, and read again: the same print."""
        with tempfile.TemporaryDirectory() as folder:
            made = ["S = slit tests/data/frozen/1/frustum.json", "C = canonize fmp3_22", "B = bundle tests/data/mesh/cube.off",
                    "H = hyperbolize fmp2_3", "R = register tests/data/frozen/1/frustum.json tests/data/frozen/1/frustum.json"]
            saved = [f"convert {line[0]} -o {folder}/{line[0]}.json" for line in made]
            read = [f"{line[0]} = {folder}/{line[0]}.json" for line in made]
            first, again = pipe(*made, *saved, "print"), pipe(*read, "print")
            self.assertEqual((first.returncode, again.returncode), (0, 0), first.stderr + again.stderr)
            first, again = ([line for line in done.stdout.splitlines() if re.match("[A-Z] = ", line)]
                            for done in (first, again))
            self.assertEqual(len(first), len(made))
            self.assertEqual(again, first)
            self.assertIn('"cell_of":', pipe("C = canonize cPcbbbihq", "print C").stdout)
            self.assertIn('"cell_of":', first[1])
            self.assertIn('"levels":', first[0])

    def test_what_is_too_long_for_a_line_is_said_in_a_comment(self):
        done = pipe("M = tests/data/knotted_y_8k.mesh", "Y = cPcbbbihq", "print")
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertTrue(done.stdout.endswith("# M: mesh of 7709 tetrahedra, 1916 vertices, too long for a line\nY = cPcbbbihq\n"))
        self.assertEqual(pipe("M = tests/data/knotted_y_8k.mesh", "print M").returncode, 2)

    def test_words_are_quoted_as_in_other_shells(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "two words.json")
            done = pipe(f"convert cPcbbbihq -o '{path}'", f'info "{path}" # a comment',
                        "info " + path.replace(" ", "\\ "))
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            self.assertEqual(done.stdout.count("signature   cPcbbbihq"), 2)


class Table(unittest.TestCase):
    def table(self, *arguments):
        done = subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=True)
        return json.loads(done.stdout)

    def test_the_shell_has_every_command_with_the_same_options(self):
        program = {c["name"]: c for c in self.table("help", "--json")["commands"]}
        shell = {c["name"]: c for c in json.loads(pipe("help --json").stdout)["commands"]}
        for name, command in program.items():
            if name == "shell":
                continue
            self.assertEqual(command["example"], "tetrarch " + shell[name]["example"])
            self.assertEqual(command["options"], shell[name]["options"])
            self.assertEqual(command["summary"], shell[name]["summary"])
        self.assertEqual(sorted(set(shell) - set(program)),
                         ["forget", "log", "print", "quit", "run", "undo", "values"])

    def test_help_gives_an_example_that_works_as_typed(self):
        for command in json.loads(pipe("help --json").stdout)["commands"]:
            page = pipe(f"help {command['name']}").stdout
            self.assertIn(command["example"], page)
            with tempfile.TemporaryDirectory() as folder:
                os.symlink(os.path.join(SOURCE, "tests"), os.path.join(folder, "tests"))
                with open(os.path.join(folder, "moves.txt"), "w") as f:
                    f.write("Z = fmp2_8\n")
                done = pipe("Y = cPcbbbihq", command["example"], cwd=folder)
                self.assertEqual((done.returncode, [l for l in done.stderr.splitlines() if "warning" not in l]), (0, []),
                                 command["example"])


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0]] + sys.argv[3:], verbosity=1)
