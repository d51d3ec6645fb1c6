#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Public headers stay light: each, included alone, compiles, and preprocesses to no more lines than its ceiling.

    header_test.py COMPILER SOURCE_TREE [FLAG ...]      the flags are those of the build: -I, -isystem, -std

A header of the standard library such as <functional> or <complex> brings 30,000 to 90,000 lines; GMP's for C++ brings 190,000, the JSON library's
133,000. HEAVY lists the headers that are about such numbers and may bring them; all others stay below CEILING.
"""
import os
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

CEILING = 100_000
HEAVY_CEILING = 300_000
HEAVY = {
    "tetrarch.hpp",  # all of them
    "algebra/integer_matrix.hpp",  # integers of any size
    "algebra/smith.hpp",
    "algebra/torsion.hpp",
    "numeric/instantiate.hpp",  # sixty digits
    "numeric/real50.hpp",
}


def public_headers(source):
    folder = os.path.join(source, "include", "tetrarch")
    for path, _, names in os.walk(folder):
        for name in names:
            if name.endswith(".hpp"):
                yield os.path.relpath(os.path.join(path, name), folder)


def lines(compiler, flags, header):
    """The preprocessed lines of a file that includes nothing but this header, or the compiler's complaint."""
    done = subprocess.run([compiler, *flags, "-E", "-x", "c++", "-"], input="#include <tetrarch/%s>\n" % header,
                          capture_output=True, text=True, check=False)
    return done.stdout.count("\n") if done.returncode == 0 else done.stderr


def main(compiler, source, *flags):
    headers = sorted(public_headers(source))
    assert len(headers) > 100, "public headers are missing"
    wrong = ["%s: there is no such header" % name for name in sorted(HEAVY - set(headers))]
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        counts = dict(zip(headers, pool.map(lambda header: lines(compiler, flags, header), headers)))
    for header, count in counts.items():
        ceiling = HEAVY_CEILING if header in HEAVY else CEILING
        if isinstance(count, str):
            wrong.append("%s: %s" % (header, count.strip()))
        elif count > ceiling:
            wrong.append("%s: %d preprocessed lines, allowed are %d" % (header, count, ceiling))
    light = [count for header, count in counts.items() if isinstance(count, int) and header not in HEAVY]
    print("%d headers, the heaviest of the light ones has %d lines" % (len(headers), max(light)))
    print("\n".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
