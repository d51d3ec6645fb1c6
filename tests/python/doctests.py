#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Every public name of the Python package has a docstring with an example, and every example runs.

    doctests.py [NAME ...]      those of all names, or of the given ones

The package is found by PYTHONPATH. Examples run in an empty folder, as some write files.
"""
import doctest
import inspect
import os
import sys
import tempfile

import tetrarch as tt

NOT_BY_EXAMPLE = {"__getattr__", "__dir__"}  # what Python calls


def public_members(owner, name):
    """What the class itself says in public."""
    for member, value in sorted(vars(owner).items()):
        if member.startswith("_") or not (inspect.isfunction(value) or isinstance(value, (property, classmethod))):
            continue
        yield "%s.%s" % (name, member), getattr(value, "__func__", value)


def everything():
    yield "tetrarch", tt
    for name in sorted(set(tt.__all__) - {"commands"}):
        value = getattr(tt, name)
        yield name, value
        if inspect.isclass(value):
            for owner in value.__mro__:
                if owner.__module__.startswith("tetrarch"):
                    yield from public_members(owner, name)
    for name in tt.commands.functions():
        yield name, getattr(tt, name)
    for name in ("table", "function_name"):
        yield "commands." + name, getattr(tt.commands, name)


GUIDE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "tools", "guide", "python.md")


def guide():
    """The page, which is one session."""
    with open(GUIDE, encoding="utf-8") as file:
        return file.read()


def main(wanted):
    finder, runner = doctest.DocTestFinder(recurse=False), doctest.DocTestRunner()
    seen, failures, count = set(), [], 0
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for name, value in everything():
            if (wanted and name not in wanted) or name in seen:
                continue
            seen.add(name)
            text = inspect.getdoc(value) or ""
            if not text:
                failures.append("%s has no docstring" % name)
                continue
            if ">>>" not in text:
                if name != "tetrarch":
                    failures.append("%s has no example" % name)
                continue
            test = doctest.DocTestParser().get_doctest(text, {"__name__": "__main__"}, name, None, 0)
            count += len(test.examples)
            if runner.run(test).failed:
                failures.append("%s: an example fails" % name)
        if not wanted:
            test = doctest.DocTestParser().get_doctest(guide(), {"__name__": "__main__"}, "guide", GUIDE, 0)
            count += len(test.examples)
            if runner.run(test).failed:
                failures.append("python.md: an example fails")
        os.chdir("/")
    for failure in failures:
        print(failure)
    print("%d names, %d examples, %d failures" % (len(seen), count, len(failures)))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
