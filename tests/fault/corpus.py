#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The whole program over files gone bad, hostile geometries and hostile options, best in the sanitizers' build.

Usage: corpus.py PROGRAM SOURCE_DIR [--files N] [--shapes N] [--options N] [--first K] [--jobs N] [--more DIR]

Each run must end by itself with status 0, 1, 2 or 4, without a word of a sanitizer. With status 2 it says one line, and nothing is
written: an old output is as it was. With another status no output and no JSON holds what is no number, and what `convert` wrote can
be read again. Nothing else stays in the folder. A fault is a line with the number that makes it again (--first N --files 1); the
exit status is 1 if there is any. Those that broke the program once are always among them.
"""
import argparse
import collections
import concurrent.futures
import json
import math
import os
import random
import re
import subprocess
import sys
import tempfile
import time

import mutants

OLD = b"what was there before\n"
LIMIT = 300  # seconds of a run
REPORTS = re.compile(rb"AddressSanitizer|LeakSanitizer|runtime error|UndefinedBehavior|(?<!')terminate called|Assertion")
BINARY = re.compile(rb'format="binary"[^>]*>[^<]*<|<AppendedData.*|format binary_little_endian.*', re.DOTALL)
NO_NUMBER = re.compile(rb"(?<![\w.\"#/-])-?(?:nan|inf)(?:inity)?(?![\w.\"])", re.IGNORECASE)
# Commands for a file of which nobody knows what it is; OUT is a name without its extension.
ON_FILES = (
    ("info", "X", "--json"), ("info", "X"), ("group", "X"), ("skeleton", "X"), ("check", "X", "--json"),
    ("check", "X", "--repair", "-o", "OUT.off"), ("convert", "X", "-o", "OUT.json"), ("convert", "X", "-o", "OUT.obj"),
    ("convert", "X", "-o", "OUT.vtu"), ("convert", "X", "-o", "OUT.tri"), ("convert", "X", "-o", "OUT.mesh"),
    ("simplify", "X", "-o", "OUT.json"), ("truncate", "X", "-o", "OUT.json"), ("hyperbolize", "X", "--json", "--attempts", "2"),
    ("canonize", "X", "--json"), ("census", "identify", "X"), ("isometric", "X", "m004"), ("move", "X", "--list", "--json"),
    ("bundle", "X", "-o", "OUT.json"), ("slit", "X", "-o", "OUT.obj"), ("product", "X", "-o", "OUT.vtu"), ("verify", "X"),
    ("embed", "X", "-o", "OUT.obj"), ("view", "X", "-o", "OUT.html"), ("diagram", "X", "-o", "OUT.svg"), ("drill", "X", "0"),
    ("subdivide", "X", "-o", "OUT.json"), ("exterior", "X", "--json"), ("hex", "X", "--cells", "30", "-o", "OUT.mesh"),
)
ON_SURFACES = (
    ("slit", "X", "-o", "OUT.obj", "--json"), ("slit", "X", "--domain", "circular", "-o", "OUT.obj", "--json"),
    ("slit", "X", "--domain", "cylindric", "-o", "OUT.vtu", "--json"), ("slit", "X", "--domain", "free", "-o", "OUT.obj", "--json"),
    ("slit", "X", "--domain", "parallel", "-o", "OUT.svg", "--json"), ("slit", "X", "--intrinsic", "-o", "OUT.obj", "--json"),
    ("slit", "X", "--balance", "-o", "OUT.obj", "--json"), ("slit", "X", "--fingerprint", "--json"),
    ("bundle", "X", "-o", "OUT.json", "--json"), ("bundle", "X", "--fiber", "5", "-o", "OUT.tri", "--json"),
    ("check", "X", "--json"), ("check", "X", "--repair", "-o", "OUT.ply", "--json"), ("convert", "X", "-o", "OUT.stl"),
    ("register", "X", "X", "--json"), ("hex", "X", "--cells", "30", "-o", "OUT.vtu", "--json"), ("view", "X", "-o", "OUT.html"),
)
ON_SOLIDS = (
    ("product", "X", "-o", "OUT.vtu", "--json"), ("product", "X", "--hex", "3", "-o", "OUT.vtu", "--json"),
    ("product", "X", "--hex", "2", "--smooth", "-o", "OUT.mesh", "--json"), ("check", "X", "--json"),
    ("check", "X", "--repair", "-o", "OUT.mesh", "--json"), ("hex", "X", "--cells", "30", "-o", "OUT.mesh", "--json"),
    ("info", "X", "--json"), ("truncate", "X", "-o", "OUT.json", "--json"), ("convert", "X", "-o", "OUT.vtk"),
    ("hyperbolize", "X", "--attempts", "1", "--json"), ("view", "X", "-o", "OUT.html"),
)
MENDING = ("slit", "bundle", "hex", "product", "truncate", "register")
ON_MESHES = ON_SURFACES + ON_SOLIDS
MESHES = (".off", ".obj", ".ply", ".stl", ".vtk", ".vtu", ".msh", ".mesh", ".node", ".ele")
ON_TRIANGULATIONS = tuple(words for words in ON_FILES if words[0] not in ("slit", "hex", "product", "diagram", "check", "verify"))
VALUES = ("0", "-1", "1", "2", "3.5", "7", "1e9", "-1e300", "1e-300", "nan", "inf", "", " ", "x", "0,0", "0,1,2", "1..2", "9" * 40, "2147483648",
          "auto", "all", "--", "-", ".", "OUT.json", "OUT", "/dev/null", "/nowhere/x.json", "\u00e9", "a:b", "0:3", "1/0", "m004", "4_1")
INPUTS = ("m004", "fmp2_8", "cPcbbbihq", "4_1", "hk5_3", "gmsh_solid.mesh", "meshio_surface.off", "octahedron.json", "metric.json", "group.json")


# Those that broke the program once. Numbers lose their meaning when mutants.py changes.
ONCE = {"files": (18,), "shapes": (796, 6493, 6692, 7090, 11265, 12390, 13020), "options": ()}


def of_file(found, number):
    name, data = mutants.file_gone_bad(found, number)
    rng = random.Random(f"command for file {number}")
    fits = ON_MESHES if name.removesuffix(".gz").endswith(MESHES) else ON_TRIANGULATIONS
    return name, data, rng.choice(fits if rng.random() < 0.8 else ON_FILES)


def of_shape(_, number):
    name, text, is_surface = mutants.shape_gone_bad(number)
    rng = random.Random(f"command for shape {number}")
    words = rng.choice(ON_SURFACES if is_surface else ON_SOLIDS)
    if rng.random() < 0.5 and words[0] in MENDING and "--repair" not in words:  # what is mended goes further
        words += ("--repair",)
    return name, text.encode(), words


def value_for(rng, option):
    """What the option may have, or what it does not expect."""
    if option["choices"] and rng.random() < 0.6:
        return rng.choice(option["choices"])
    if rng.random() < 0.5:
        return rng.choice({"INT": ("1", "2", "3", "5", "17"), "K": ("1", "2", "3"), "FLOAT": ("0.5", "1", "30"), "TOL": ("1e-6", "0.3"), "LOOP": "012",
                           "VERTEX": ("0", "5", "40"), "LIST": ("0", "0,1", "1,2,3"), "FILE": ("OUT.json", "OUT.obj", "OUT.vtu", "OUT.csv")}.get(
                               option["value"], VALUES))
    return rng.choice(VALUES)


def of_options(table, number):
    """An example of the help pages with any of the command's options, each with a value that it may not expect."""
    rng = random.Random(f"options {number}")
    command = rng.choice(table)
    words = [word.strip("'") for word in command["example"].split()[1:]]
    if rng.random() < 0.3:  # other inputs
        first = len(command["name"].split())
        words[first:] = rng.choices(INPUTS, k=max(1, len(command["arguments"])))
    for option in rng.choices(command["options"], k=rng.choice((1, 1, 2, 3))) if command["options"] else ():
        words.append(rng.choice(option["names"]))
        if option["value"] and not rng.random() < 0.05:
            words.append(value_for(rng, option))
    if rng.random() < 0.1:
        words.insert(rng.randrange(len(words)), rng.choice(VALUES))
    if rng.random() < 0.5:
        words.append("--json")
    return None, b"", tuple(words)


def finite(value):
    if isinstance(value, float):
        return math.isfinite(value)
    return all(map(finite, value.values() if isinstance(value, dict) else value)) if isinstance(value, (dict, list)) else True


def no_constant(name):
    raise ValueError(f"{name} in JSON")


def objects(text):
    """The JSON objects of a text, one after the other: a census prints many."""
    decoder, at = json.JSONDecoder(parse_constant=no_constant), 0
    while at < len(text):
        value, at = decoder.raw_decode(text, at)
        yield value
        at += len(text[at:]) - len(text[at:].lstrip())


class Corpus:
    def __init__(self, program, source):
        self.program, self.source = program, source
        self.samples = {name: data for name, data in mutants.seeds(source) if name in INPUTS}
        self.environment = {**os.environ, "ASAN_OPTIONS": "detect_leaks=1:abort_on_error=0:exitcode=99", "UBSAN_OPTIONS": "print_stacktrace=1",
                            "OMP_NUM_THREADS": "1", "OPENBLAS_NUM_THREADS": "1", "TMPDIR": ""}

    def start(self, folder, words):
        """(exit status, standard output, standard error), None as status of what did not end."""
        try:
            done = subprocess.run([self.program, *words], cwd=folder, capture_output=True, stdin=subprocess.DEVNULL, timeout=LIMIT,
                                  env={**self.environment, "TMPDIR": os.path.join(folder, "tmp")}, check=False)
        except subprocess.TimeoutExpired as late:
            return None, late.stdout or b"", late.stderr or b""
        except ValueError:  # a zero in a word
            return 2, b"", b"tetrarch: \n"
        return done.returncode, done.stdout, done.stderr

    def run(self, make, what, number):
        """(fault or nothing, exit status, seconds, the command)."""
        name, data, words = make(what, number)
        with tempfile.TemporaryDirectory() as folder:
            os.mkdir(os.path.join(folder, "tmp"))
            given = dict(self.samples) if name is None else {name: data}
            for file, content in given.items():
                with open(os.path.join(folder, file), "wb") as opened:
                    opened.write(content)
            words = [name if word == "X" else word for word in words]
            outputs = {word for word in words if word.startswith("OUT.")}
            for out in outputs:
                with open(os.path.join(folder, out), "wb") as opened:
                    opened.write(OLD)
            began = time.monotonic()
            status, said, complained = self.start(folder, words)
            seconds = time.monotonic() - began
            return self.fault_of(folder, given, outputs, words, status, said, complained), status, seconds, words

    def fault_of(self, folder, given, outputs, words, status, said, complained):
        if status is None:
            return f"did not end in {LIMIT} s"
        if REPORTS.search(complained):
            return complained[:3000].decode(errors="replace")
        if status not in (0, 1, 2, 4):
            return f"status {status}: {complained[-300:]!r}"
        if re.search(rb"[\x00-\x08\x0b-\x1f\x7f]", complained):
            return f"control characters: {complained[:300]!r}"
        left = set(os.listdir(folder)) - set(given) - outputs - {"tmp"}
        if os.listdir(os.path.join(folder, "tmp")) or (left and not self.may_write(words, left)):
            return f"left over: {sorted(left)} {os.listdir(os.path.join(folder, 'tmp'))}"
        written = {}
        for out in outputs:
            with open(os.path.join(folder, out), "rb") as opened:
                written[out] = opened.read()
        if status == 2:
            errors = [line for line in complained.splitlines() if not line.startswith(b"tetrarch: warning: ")]
            if len(errors) != 1 or not errors[0].startswith((b"tetrarch: ", b"{")):
                return f"status 2 says {complained[:500]!r}"
            if any(content != OLD for content in written.values()):
                return "status 2, and the old output is gone"
            return None
        for out, content in written.items():
            found = NO_NUMBER.search(BINARY.sub(b"", content))
            if content != OLD and not out.endswith(".html") and found:
                return f"no number in {out}: {found}"
        if "--json" in words and not said.startswith(b"{"):
            return f"no JSON: {said[:200]!r}"
        if "--json" in words:
            try:
                if not all(map(finite, objects(said.decode()))):
                    return "JSON holds an infinite number"
            except ValueError as wrong:
                return f"bad JSON: {wrong}"
        if words[0] == "convert" and status == 0:
            for out in outputs:
                again = self.start(folder, ("convert", out, "-o", out.replace("OUT", "again")))
                if again[0] != 0 or REPORTS.search(again[2]):
                    return f"what was written to {out} is refused: {again[2][:300]!r}"
        return None

    @staticmethod
    def may_write(words, left):
        """Hostile options may name any output, and what belongs to one begins with its name."""
        stems = {os.path.splitext(word)[0] for word in words if word} | ({"records"} if "--work" in words else set())
        return all(any(name.startswith(stem) for stem in stems) for name in left)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("program")
    parser.add_argument("source")
    parser.add_argument("--files", type=int, default=3000)
    parser.add_argument("--shapes", type=int, default=11000)
    parser.add_argument("--options", type=int, default=2000)
    parser.add_argument("--first", type=int, default=0)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--more", help="a folder with more seeds for files")
    options = parser.parse_args()
    corpus = Corpus(os.path.abspath(options.program), os.path.abspath(options.source))
    found = mutants.seeds(corpus.source) + (mutants.files_in(options.more) if options.more else [])
    told = json.loads(subprocess.run([corpus.program, "help", "--json"], capture_output=True, check=True).stdout)
    table = [command for command in told["commands"] if command["name"] not in ("shell", "help")]
    faults = 0
    for kind, make, what, count in (("files", of_file, found, options.files), ("shapes", of_shape, found, options.shapes),
                                    ("options", of_options, table, options.options)):
        statuses, slowest = collections.Counter(), (0.0, 0, "")
        with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
            numbers = [*ONCE[kind], *range(options.first, options.first + count)] if count > 0 else []
            for number, (fault, status, seconds, words) in zip(numbers, pool.map(lambda k: corpus.run(make, what, k), numbers)):
                statuses[status] += 1
                slowest = max(slowest, (seconds, number, " ".join(words)))
                if fault:
                    faults += 1
                    print(f"{kind} {number}, {' '.join(words)!r}: {fault}", flush=True)
        print(f"{kind}: {len(numbers)} runs; status " + ", ".join(f"{s}: {n}" for s, n in sorted(statuses.items(), key=str)) +
              f"; slowest {slowest[0]:.1f} s (number {slowest[1]}, {slowest[2]!r})", flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
