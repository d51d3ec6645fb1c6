# SPDX-License-Identifier: GPL-2.0-or-later
"""Running the program in tests, and what was typed in all of them."""
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

PROGRAM = os.path.abspath(sys.argv[1])
SOURCE = os.path.abspath(sys.argv[2])
with open(PROGRAM, "rb") as program:
    INSTRUMENTED = b"__asan_init" in program.read()  # AddressSanitizer's shadow takes terabytes of addresses
SLOWER = 5 if INSTRUMENTED else 1  # than Release, of processor time
TYPED = []  # (arguments, exit status) of every run


def run(*arguments, stdin=None, cwd=None, env=None):
    done = subprocess.run([PROGRAM, *arguments], input=stdin, capture_output=True, text=True, cwd=cwd, timeout=300,
                          env=env)
    TYPED.append((arguments, done.returncode))
    return done


@functools.cache
def listed_fields():
    """Of each command that lists the fields of its result: their names."""
    told = json.loads(subprocess.run([PROGRAM, "help", "--json"], capture_output=True, text=True, check=True).stdout)
    return {tuple(command["name"].split()): {field["name"] for field in command["result"] + told["common_result"]}
            for command in told["commands"] if "result" in command}


def run_json(*arguments):
    done = run(*arguments, "--json")
    result = json.loads(done.stdout)
    fields = next((names for command, names in listed_fields().items() if arguments[:len(command)] == command), None)
    unlisted = set(result) - fields if fields is not None and isinstance(result, dict) else set()
    if unlisted:
        raise AssertionError("%s: members that help --json does not list: %s" % (arguments, ", ".join(sorted(unlisted))))
    return done.returncode, result


def peak_memory(*arguments):
    """In bytes, of a run whose output goes nowhere; at least what Python has itself, of which the kernel makes it begin."""
    child = os.posix_spawn(PROGRAM, [PROGRAM, *arguments], os.environ,
                           file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)])
    _, status, used = os.wait4(child, 0)
    if status != 0:
        raise AssertionError("%s: status %d" % (arguments, status))
    return used.ru_maxrss * 1024


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
