# SPDX-License-Identifier: GPL-2.0-or-later
"""Running the program in tests, and what was typed in all of them."""
import collections
import functools
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import time
import unittest

try:
    import jsonschema
except ImportError:
    jsonschema = None
    print("python3-jsonschema is missing: results are not held against their schemas", file=sys.stderr)

PROGRAM = os.path.abspath(sys.argv[1])
SOURCE = os.path.abspath(sys.argv[2])
with open(PROGRAM, "rb") as program:
    INSTRUMENTED = b"__asan_init" in program.read()  # AddressSanitizer's shadow takes terabytes of addresses
SLOWER = 5 if INSTRUMENTED else 1  # than Release, of processor time
TYPED = []  # (arguments, exit status) of every run
SEEN = collections.defaultdict(set)  # by the words of a command, the members of results that were held to its schema


def run(*arguments, stdin=None, cwd=None, env=None):
    done = subprocess.run([PROGRAM, *arguments], input=stdin, capture_output=True, text=True, cwd=cwd, timeout=300,
                          env=env)
    TYPED.append((arguments, done.returncode))
    if "--json" in arguments:
        hold_to_schemas(arguments, done)
    return done


@functools.cache
def validators():
    """By the words of a command, what its results satisfy; also by ("error",) and ("statement",). Draft 2020-12."""
    told = json.loads(subprocess.run([PROGRAM, "help", "--schema"], capture_output=True, text=True, check=True).stdout)
    schemas = {tuple(name.split()): schema for name, schema in told["commands"].items()}
    schemas |= {("error",): told["error"], ("statement",): told["statement"]}
    for schema in schemas.values():
        jsonschema.Draft202012Validator.check_schema(schema)
    return {words: jsonschema.Draft202012Validator(schema) for words, schema in schemas.items()}


def objects_in(text):
    """The objects that a run printed, one or one a line; none if that is no JSON, or a file of the program's own format."""
    for texts in ([text], text.splitlines()):
        try:
            values = [json.loads(one) for one in texts]
        except ValueError:
            continue
        return [value for value in values if isinstance(value, dict) and not str(value.get("format")).startswith("tetrarch-")]
    return []


def words_of(arguments):
    """The command: its words among the validators' names, or those of none."""
    return next((words for words in validators() if arguments[:len(words)] == words), None)


def hold_to_schemas(arguments, done):
    """What is printed with --json is what `help --schema` promises, by the judgment of another program."""
    if jsonschema is None:
        return
    words = ("statement",) if arguments[0] == "shell" else words_of(arguments)
    held = [(words, value) for value in objects_in(done.stdout)] if words else []
    held += [(("error",), value) for line in done.stderr.splitlines() if line.startswith('{"error"') for value in objects_in(line)]
    for validator, value in held:
        SEEN[validator] |= set(value)
        for wrong in validators()[validator].iter_errors(value):
            raise AssertionError("%s: %s is not what help --schema says: %s" % (arguments, wrong.json_path, wrong.message))


def run_json(*arguments):
    done = run(*arguments, "--json")
    return done.returncode, json.loads(done.stdout)


STARTER = """import os, sys
child = os.posix_spawn(sys.argv[1], sys.argv[1:], os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)])
_, status, used = os.wait4(child, 0)
print(status, used.ru_maxrss)"""


def peak_memory(*arguments):
    """In bytes, of a run whose output goes nowhere. The kernel makes it begin with what its parent has, which is a Python that
    has loaded next to nothing: some 10 MB."""
    done = subprocess.run([sys.executable, "-I", "-S", "-c", STARTER, PROGRAM, *arguments], capture_output=True, text=True, check=True)
    status, kilobytes = map(int, done.stdout.split())
    if status != 0:
        raise AssertionError("%s: status %d" % (arguments, status))
    return kilobytes * 1024


def seconds_of_children():
    """Processor seconds of all runs until now."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def seconds_of_work(*arguments):
    """What a run gave, and its processor seconds."""
    before = seconds_of_children()
    done = run(*arguments)
    return done, seconds_of_children() - before


def wait_until_it_listens(job):
    """Until a started program has asked for SIGINT, or has ended."""
    while job.poll() is None:
        with open(f"/proc/{job.pid}/status", encoding="ascii") as file:
            caught = re.search("^SigCgt:\\s*([0-9a-f]+)$", file.read(), re.M)
        if caught and int(caught[1], 16) >> (signal.SIGINT - 1) & 1:
            return
        time.sleep(0.005)


def medit(points, elements, keyword="Tetrahedra"):
    """The text of a MEDIT file, whose elements count from 0 here; element k is on line 7 + k + the number of points."""
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points))]
    lines += ["%r %r %r 0" % tuple(p) for p in points] + [keyword, str(len(elements))]
    lines += [" ".join(str(v + 1) for v in e) + " 0" for e in elements]
    return "\n".join(lines + ["End", ""])


class InFolder(unittest.TestCase):
    """A folder of its own for each test."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name, text=None):
        path = os.path.join(self.folder.name, name)
        if text is not None:
            with open(path, "w", encoding="utf-8") as file:
                file.write(text)
        return path


def unused_options():
    """The options of the table of commands that no run which went well had."""
    table = json.loads(subprocess.run([PROGRAM, "help", "--json"], capture_output=True, check=True).stdout)
    used = set()
    for arguments, status in TYPED:
        if status not in (0, 1, 4) or not arguments:
            continue
        words = 2 if arguments[0] == "census" else 1
        used |= {(" ".join(arguments[:words]), word.split("=")[0]) for word in arguments[words:]}
    everywhere = {option for _, option in used}
    unused = [f"{command['name']} {option['names'][-1]}" for command in table["commands"]
              for option in command["options"]
              if not any((command["name"], name) in used for name in option["names"])]
    unused += [option["names"][-1] for option in table["common"] if not everywhere & set(option["names"])]
    return unused


# Members of schemas that no test brings about.
NEVER_SEEN = {
    **{words: {"groups"} for words in (("exterior",), ("bundle",), ("drill",), ("move",))},  # what they make is connected
    ("slit",): {"mended"},  # the map of no surface here inverts triangles that moving vertices mends
}


def unseen_members():
    """Of each schema the members that no run had, so that their types were never held against anything."""
    if jsonschema is None:
        return []
    common = {"passed_over", "input", "name"}
    return [f"{' '.join(words)}: {member}" for words, validator in validators().items()
            for member in sorted(set(validator.schema["properties"]) - SEEN[words] - NEVER_SEEN.get(words, set()) - common)]
