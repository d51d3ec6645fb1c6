# SPDX-License-Identifier: GPL-2.0-or-later
"""What may stand for a triangulation: names, signatures of any kind, one of several in a file, all of them."""
import json
import os

from running import SOURCE, InFolder, run, run_json

DATA = os.path.join(SOURCE, "tests/data/format")


def signature_of_a_ring(size):
    """A punctured torus bundle (Floyd and Hatcher 1982), given as JSON and named by the program."""
    gluings = []
    for t in range(size):
        after, before = (t + 1) % size, (t - 1) % size
        # Faces 3 and 1 lie on the tetrahedron before, by 0132 and 1023; faces 2 and 0 below the one after.
        gluings.append([[after, "1023"], [before, "1023"], [after, "0132"], [before, "0132"]])
    text = json.dumps({"format": "tetrarch-triangulation", "version": 1, "tetrahedra": size, "gluings": gluings})
    return json.loads(run("info", "-", "--json", stdin=text).stdout)["signature"]


class Names(InFolder):
    def test_what_identify_names_is_taken(self):
        for text, signature in (("m004", "cPcbbbiht"), ("figure-eight knot complement (m004)", "cPcbbbiht"),
                                ("m129", "eLPkbdcddhgggb"), ("S^3", "bkaagj"), ("L(7,2)", "cMcabbjqw")):
            status, info = run_json("info", text)
            self.assertEqual((status, info["signature"]), (0, signature), text)
        # Named, and the name taken again.
        name = run_json("census", "identify", "dLQbcccdero")[1]["name"]
        self.assertEqual(run_json("info", name)[1]["signature"], "dLQbcccdero")

    def test_what_is_no_name_gets_one_line_with_near_names(self):
        for text, near in (("m0", "m000"), ("m0005", "m005"), ("fmp3_152", "fmp3_15"), ("T3", "T^3")):
            done = run("info", text)
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), text)
            self.assertIn("no file, no name of a manifold and no isomorphism signature", done.stderr)
            self.assertIn("'%s'" % near, done.stderr)
            self.assertNotIn("ends too early", done.stderr)
        self.assertIn("as a signature", run("info", "gLLQPacdedffnsxanxR").stderr)  # x, not R, is right

    def test_fillings_of_names_are_passed_over_aloud(self):
        done = run("info", "m004(5,1)", "--json")
        self.assertEqual(json.loads(done.stdout)["passed_over"],
                         [{"what": "Dehn filling (5,1) of cusp 0, which is open here", "count": 1}])
        self.assertIn("warning: passed over: Dehn filling (5,1)", done.stderr)


    def test_a_filled_manifold_is_not_answered_about_unfilled(self):
        for command in ("hyperbolize", "canonize"):
            done = run(command, "m004(5,1)")
            self.assertEqual((done.returncode, done.stdout, done.stderr.count("\n")), (2, "", 1), command)
            self.assertIn("Dehn filling (5,1) of cusp 0 is not carried out", done.stderr)
        self.assertEqual(run("isometric", "m004", "m004(5,1)").returncode, 2)
        self.assertEqual(run("census", "identify", "m004(5,1)").returncode, 2)
        self.assertEqual(run("hyperbolize", "m004(0,0)").returncode, 0)


class Fillings(InFolder):
    FILLED = os.path.join(DATA, "tri/kernel_filled.tri")

    def with_slope(self, slope):
        with open(self.FILLED, encoding="utf-8") as file:
            text = file.read()
        return self.path("filled.tri", text.replace("torus   1.000000000000   2.000000000000", "torus " + slope))

    def test_a_cusp_of_a_snappea_file_is_filled(self):
        # The kernel's volume stands in the file, and it knows the manifold (Regina 7.3): m007.
        status, found = run_json("hyperbolize", self.FILLED)
        self.assertEqual(status, 0)
        self.assertAlmostEqual(found["volume"], 2.56897060, 8)
        self.assertEqual(run("isometric", self.FILLED, "m007").returncode, 0)
        done = run("info", self.FILLED, "--json")
        self.assertEqual(json.loads(done.stdout)["homology"], "Z + Z/3")
        self.assertIn("Dehn filling (1,2) of cusp 0: carried out", done.stderr)
        self.assertEqual([b["genus"] for b in json.loads(done.stdout)["boundary"]], [1])

    def test_slopes_that_make_no_manifold_are_refused(self):
        for slope in ("2 4", "1.5 1", "0 3"):
            path = self.with_slope(slope)
            self.assertEqual(run("hyperbolize", path).returncode, 2, slope)
            self.assertEqual(run_json("info", path)[1]["passed_over"][0]["count"], 1)
        self.assertEqual(run("hyperbolize", self.with_slope("0 0")).returncode, 0)

    def test_klein_bottles_and_elements_are_not_filled(self):
        gieseking = os.path.join(DATA, "tri/kernel_gieseking.tri")
        with open(gieseking, encoding="utf-8") as file:
            text = file.read().replace("Klein   0.0", "Klein   1.0")
        done = run("hyperbolize", self.path("klein.tri", text))
        self.assertEqual(done.returncode, 2)
        self.assertIn("Dehn filling (1,0) of cusp 0 cannot be carried out: there is no torus", done.stderr)
        with open(self.FILLED, encoding="utf-8") as file:
            text = file.read()
        packet = self.path("packet.rga", '<?xml version="1.0"?>\n<regina engine="7.3"><snappeadata label="W">' + text +
                           "</snappeadata></regina>")
        self.assertEqual(run_json("info", packet + "#W")[1]["passed_over"][0]["what"],
                         "Dehn filling (1,2) of cusp 0, which is open here")
        self.assertEqual(run("hyperbolize", packet + "#W").returncode, 2)


class Signatures(InFolder):
    def test_decorations_are_passed_over_aloud(self):
        for text in ("cPcbbbiht_BaCB", "cPcbbbiht_12"):
            status, info = run_json("info", text)
            self.assertEqual((status, info["signature"]), (0, "cPcbbbiht"))
            self.assertEqual(info["passed_over"], [{"what": "decoration " + text[9:], "count": 1}])
        self.assertEqual(run_json("info", "cPcbbbiht")[1]["passed_over"], [])

    def test_a_leading_dash(self):
        text = signature_of_a_ring(64)
        self.assertTrue(text.startswith("-"))
        for arguments in (("info", text), ("info", text + "_abBA"), ("info", "--", text), ("skeleton", text),
                          ("group", text), ("convert", text, "-o", self.path("long.sig"))):
            done = run(*arguments, "--json") if "--" not in arguments else run(*arguments)
            self.assertIn(done.returncode, (0, 1, 4), (arguments[0], done.stderr))
        # Options are still options, and what is neither is told.
        for word in ("-x", "-ba", text[:-1]):
            self.assertIn("unknown option", run("info", word, text).stderr)
        self.assertEqual(run("info", text, "-o", "x").returncode, 2)
        done = run("shell", stdin="R = %s\ninfo %s\n%s\n" % (text, text, text))
        self.assertEqual((done.returncode, done.stdout.count("signature")), (0, 2), done.stderr)


class Elements(InFolder):
    def test_a_list_of_names(self):
        path = self.path("names.txt", "# some\nm004\r\n4_1\n\ncPcbbbihq the Y\nL(7,2) a lens space\nm0005\n")
        lines = run("info", path + "#*", "--json").stdout.splitlines()
        self.assertEqual([json.loads(line)["name"] for line in lines], ["figure-eight knot complement (m004)", "4_1", "the Y", "L(7,2)"])
        self.assertEqual(run("isometric", path + "#1", path + "#2").returncode, 0)
        for name, text in (("plain", "m004\nm015\n"), ("one.txt", "m004\n")):
            self.assertEqual(run_json("info", self.path(name, text) + "#1")[1]["signature"], "cPcbbbiht")
        self.assertEqual(run("info", "-", stdin="m015\n").returncode, 0)
        self.assertIn("expected one: say which", run("info", self.path("plain", "m004\nm015\n")).stderr)
        self.assertIn("m005", run("info", path + "#5").stderr)  # no such name

    def list(self):
        return self.path("two.sig", "cPcbbbiht the knot\ncPcbbbihq\n")

    def test_by_number_and_name(self):
        path = self.list()
        for element, signature in (("1", "cPcbbbiht"), ("2", "cPcbbbihq"), ("the knot", "cPcbbbiht"),
                                   ("the", "cPcbbbiht")):
            status, info = run_json("info", path + "#" + element)
            self.assertEqual((status, info["signature"]), (0, signature), element)
        several = os.path.join(DATA, "rga/several.rga")
        self.assertEqual(run_json("info", several + "#figure eight")[1]["signature"], "cPcbbbiht")
        with open(path, encoding="utf-8") as file:
            self.assertIn("cPcbbbihq", run("info", "-#2", stdin=file.read()).stdout)
        # A file with such a name is meant before an element.
        self.path("two.sig#1", "bkaaid\n")
        self.assertEqual(run_json("info", path + "#1")[1]["signature"], "bkaaid")

    def test_what_is_not_there(self):
        path = self.list()
        for element, words in (("3", "holds 2 triangulations"), ("0", "holds 2"), ("9" * 30, "holds 2"),
                               ("knot", "none of its 2 triangulations is called 'knot'"), ("", "which of its 2 triangulations? (#1 is the first")):
            done = run("info", path + "#" + element)
            self.assertEqual((done.returncode, done.stderr.count("\n")), (2, 1))
            self.assertIn(words, done.stderr)
        self.assertIn("say which by FILE#1", run("info", path).stderr)
        done = run("isometric", "-", "-", stdin="cPcbbbihq")
        self.assertEqual((done.returncode, done.stderr), (2, "tetrarch: standard input: was read already, and it can be read once\n"))
        twice = self.path("twice.sig", "cPcbbbiht a\ncPcbbbihq a\n")
        self.assertIn("this names 2 triangulations: #1, #2", run("info", twice + "#a").stderr)

    def test_one_of_each_as_lines_of_json(self):
        path = self.path("three.sig", "cPcbbbiht a\nnonsense!\ncPcbbbihq\n")
        done = run("info", path + "#*", "--json")
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([(l["input"], l["signature"]) for l in lines],
                         [(path + "#1", "cPcbbbiht"), (path + "#3", "cPcbbbihq")])
        self.assertEqual((lines[0]["name"], done.returncode, done.stderr.count("\n")), ("a", 2, 1))
        error = json.loads(done.stderr)["error"]
        self.assertEqual((error["file"], error["line"], error["code"]), (path + "#2", 2, "bad_content"))
        alone = json.loads(run("info", path + "#2", "--json").stderr)["error"]
        self.assertEqual((alone["file"], alone["line"], alone["code"]), (path, 2, "bad_content"))
        self.assertIn("signature 'nonsense!'", error["message"])
        self.assertIn(path + "#2: " + path + ":2: signature 'nonsense!'", run("info", path + "#*").stderr)
        self.assertEqual(run("isometric", path + "#*", "cPcbbbihq").returncode, 2)
        self.assertEqual(run("isometric", self.list() + "#*", "cPcbbbihq").returncode, 1)  # one is no
        text = run("info", self.list() + "#*").stdout
        self.assertEqual(text.count("two.sig#"), 2)
        self.assertIn("only one argument", run("isometric", path + "#*", path + "#*").stderr)
        # A file of one, and a file of none.
        one = self.path("one.sig", "cPcbbbiht\n")
        self.assertEqual(len(run("info", one + "#*", "--json").stdout.splitlines()), 1)
        done = run("info", self.path("no.sig", "# none\n") + "#*", "--json")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("found no triangulations", json.loads(done.stderr)["error"]["message"])

    def test_outputs_are_numbered(self):
        path = self.list()
        pattern = os.path.join(self.folder.name, "knot_*.tri")
        self.assertEqual(run("convert", path + "#*", "-o", pattern).returncode, 0)
        for number, signature in (("1", "cPcbbbiht"), ("2", "cPcbbbihq")):
            self.assertEqual(run_json("info", pattern.replace("*", number))[1]["signature"], signature)
        done = run("convert", path + "#*", "-o", os.path.join(self.folder.name, "one.tri"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("one file cannot hold 2 results", done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder.name, "one.tri")))
        # The same in a way that no option shows.
        done = run("simplify", path + "#*", "--moves", os.path.join(self.folder.name, "log"))
        self.assertEqual(done.returncode, 2)
        self.assertIn("two results have this file name", done.stderr)

    def test_in_the_shell(self):
        path = self.list()
        done = run("shell", stdin="K = %s#1\ninfo K\ninfo %s#*\n%s#*\nL = %s#*\n" % ((path,) * 4))
        self.assertEqual(done.returncode, 2)
        self.assertEqual(done.stdout.count("signature "), 5)
        self.assertIn("a name is for one value", done.stderr)

    def test_packets_passed_over_are_told_once(self):
        path = self.path("packets.rga", """<?xml version="1.0"?>
<regina engine="7.3"><container label="">
<textdata label="words">words</textdata>
<tri dim="3" size="2" perm="index" label="caf\u00e9"><simplex> 1 11 1 13 1 5 1 15 </simplex>
<simplex> 0 11 0 13 0 5 0 15 </simplex></tri>
<tri dim="3" size="2" perm="index" label="two"><simplex> 1 11 1 13 1 5 1 15 </simplex>
<simplex> 0 11 0 13 0 5 0 15 </simplex></tri>
</container></regina>
""")
        done = run("info", path + "#*", "--json")
        lines = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([l["passed_over"] for l in lines], [[{"what": "text packet", "count": 1}], []])
        self.assertEqual(done.stderr.count("\n"), 1)
        self.assertEqual(lines[0]["name"], "caf\u00e9")
        self.assertIn("('caf\u00e9', 'two')", run("info", path).stderr)


class Components(InFolder):
    TWO = "cPcbbbihtcPcbbbihq"

    def test_simplify(self):
        # Each component grown by a 1-4 move; signatures of the parts stand one after the other.
        big = self.path("big.json")
        run("subdivide", self.TWO, "--one-four", "-o", big)
        status, info = run_json("simplify", big)
        self.assertEqual((status, info["input_tetrahedra"], info["connected"]), (0, 16, False))
        self.assertEqual(info["signature"], "cPcbbbihqcPcbbbiht")

    def test_group(self):
        status, found = run_json("group", self.TWO)
        self.assertEqual(status, 0)
        self.assertEqual([c["abelianized"] for c in found["components"]], ["Z", "Z^2"])
        for number, component in enumerate(found["components"]):  # of two tetrahedra each
            self.assertEqual({f["tetrahedron"] // 2 for f in component["generator_faces"]}, {number})
            self.assertEqual([f["generator"] for f in component["generator_faces"]], component["generators"])
        self.assertEqual(run("group", self.TWO, "-o", self.path("g.json")).returncode, 2)
        self.assertIn("group 2", run("info", self.TWO).stdout)
        self.assertEqual(len(run_json("info", self.TWO)[1]["groups"]), 2)

    def test_generators_and_faces(self):
        # Two tetrahedra, four faces: one is in the tree, and the others have a generator each.
        found = run_json("group", "cPcbbbiht", "--as-given")[1]
        self.assertEqual(len(found["generator_faces"]), 3)
        self.assertEqual(len({(f["tetrahedron"], f["face"]) for f in found["generator_faces"]}), 3)
        kept = run_json("group", "cPcbbbiht")[1]
        self.assertEqual([f["generator"] for f in kept["generator_faces"]], kept["generators"])
        for face in kept["generator_faces"]:
            self.assertIn((face["tetrahedron"], face["face"]),
                          {(f["tetrahedron"], f["face"]) for f in found["generator_faces"]})
