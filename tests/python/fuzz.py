#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Bad input from Python: thousands of calls with whatever comes to mind. Nothing but ValueError and TypeError, of one clear line.

    fuzz.py [CALLS [SEED]]      default: 10000 calls, seed 1

A crash ends this process; whoever runs it sees that. Standard input should be empty.
"""
import os
import random
import sys
import tempfile
import time
import warnings

import numpy as np

import tetrarch as tt

CUBE = tt.Mesh.read("samples/cube.off")
TORUS = tt.Mesh.read("samples/torus.off")
RING = tt.Mesh.read("samples/ring_two_holes.off")
TETRAHEDRON = (np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1.0]]), np.array([[0, 1, 2, 3]]))


class Odd:
    """Has what nobody should rely on."""

    points = "points"
    cells_dict = {"triangle": None}

    def snapPea(self):
        return "% Triangulation\n" + chr(7)


class Raises:
    def isoSig(self):
        raise ValueError("no signature today")


class Sour:
    vertices = faces = 3


def scalar(r):
    return r.choice([None, True, False, 0, 1, -1, 2, 3, 7, 10**6, -10**9, 2**31, 2**63, 2**64, -2**70, 10**400, 0.5, -0.0, 1e308, -1e-300,
                     float("nan"), float("inf"), -float("inf"), 1j, "", "x", "m004", "fmp3_17", "cPcbbbihq", "cPcbbbihqq", "-",
                     "--", "-h", "--json", "0", "1,2", "v17", "nan", "inf", "1e999", "a" * 5000, "é", "\ud800", "\0", "\n", "\x1b[31m",
                     "%s%n", "/", ".", "/dev/null", "/nonexistent/x.json", "samples/none.off", "< a | >", "{", "{}", '{"format":1}',
                     b"m004", bytearray(b"x"), object(), Odd(), Raises(), Sour(), int, len, [], (), {}, set(), slice(1, 2), range(3),
                     np.float32(2), np.int8(-3), np.bool_(True), np.array(3), np.datetime64("2020-01-01"), Ellipsis,
                     "L(7,2)", "L(6,2)", "S^3", "m004(1,2)", "samples/cube.off#*", "x#1", "#", "#*", "the manifold"])


def array(r):
    kind = r.randrange(12)
    if kind == 0:
        return np.array([r.choice([None, "a", 1.5, [1]]) for _ in range(r.randrange(4))], dtype=object)
    shape = tuple(r.choice([0, 1, 2, 3, 4, 5, 8, 12]) for _ in range(r.choice([0, 1, 2, 2, 2, 2, 3])))
    made = np.random.default_rng(r.randrange(2**32)).integers(-3, r.choice([3, 8, 40]), shape)
    if kind <= 3:
        made = made.astype(r.choice([np.float64, np.float32, np.float16, np.complex128, np.longdouble]))
        if made.size and r.random() < 0.3:
            made.flat[r.randrange(made.size)] = r.choice([float("nan"), float("inf"), 1e300])
    elif kind <= 7:
        made = made.astype(r.choice([np.int8, np.uint8, np.int32, np.int64, np.uint64, ">i4", ">f8", bool, "U3", "S2"]))
    if made.size and made.dtype.kind in "iu" and r.random() < 0.2:
        made.flat[r.randrange(made.size)] = np.iinfo(made.dtype).max
    if r.random() < 0.3:
        made = np.asfortranarray(made)
    if r.random() < 0.2 and made.ndim:
        made = made[::-1]
    if r.random() < 0.2:
        made.flags.writeable = False
    if r.random() < 0.15:
        made = made.tolist()
    if r.random() < 0.05 and hasattr(made, "dtype"):
        made = np.ma.masked_array(made)
    return made


def good_mesh(r):
    """Almost a mesh."""
    mesh = r.choice([CUBE, TORUS, RING])
    points, triangles = np.array(mesh.points), np.array(mesh.triangles)
    for _ in range(r.randrange(3)):
        if r.random() < 0.5:
            triangles[r.randrange(len(triangles)), r.randrange(3)] = r.choice([-1, 0, 1, len(points), 2**31 - 1, -2**31])
        else:
            points[r.randrange(len(points)), r.randrange(3)] = r.choice([float("nan"), float("inf"), 0, 1e300, -1e-300])
    if r.random() < 0.2:
        triangles = triangles[:r.randrange(len(triangles))]
    return points, triangles


def thing(r):
    pick = r.random()
    if pick < 0.4:
        return scalar(r)
    if pick < 0.6:
        return array(r)
    if pick < 0.7:
        return (array(r), array(r))
    if pick < 0.8:
        return good_mesh(r)
    if pick < 0.85:
        return [scalar(r) for _ in range(r.randrange(5))]
    if pick < 0.9:
        return [[r.choice([None, (0, (0, 1, 2, 3)), (1, [3, 2, 1, 0]), (0, (0, 0, 1, 2)), (0,), "ab", (5, (1, 0, 2, 3)), 3])
                 for _ in range(4)] for _ in range(r.randrange(3))]
    return r.choice([tt.Manifold("m004"), tt.Triangulation("cPcbbbihq"), CUBE, RING, tt.Mesh(*TETRAHEDRON[:1]), TETRAHEDRON,
                     tt.FundamentalGroup(2, [(1, 2)]), tt.AbelianGroup(1), tt.hyperbolize("m004")])


# What would take long, or write where it should not.
SKIPPED = {"census enumerate", "census validate", "census gluings"}


def command_call(r):
    table = tt.commands._commands()
    name = r.choice([c for c in table if c not in SKIPPED and c not in tt.commands.NOT_IN_PYTHON])
    options = tt.commands._options(table[name])
    given = {}
    for _ in range(r.randrange(4)):
        option = r.choice(list(options))
        if option in ("output", "history", "moves", "obstruction", "average"):
            given[option] = r.choice(["/nonexistent/x.json", "x.json", "x.svg", "x.html", "x.tri", "", None, 3, "x", [], ["a.json", "a.json"]])
        elif option not in ("hex", "quads", "fiber", "copies", "cells", "fibers", "word_length", "barycentric", "levels", "attempts"):
            given[option] = scalar(r) if r.random() < 0.7 else thing(r)
    if "attempts" in options:
        given["attempts"] = r.choice([1, 2, 0, -1])
    if r.random() < 0.05:
        given[r.choice(["nonsense", "json", "quiet", "self"])] = 1
    return "%s(%s)" % (name, given), lambda: tt.run(name, *[thing(r) for _ in range(r.choice([0, 1, 1, 1, 2, 2, 3]))], **given)


def library_call(r):
    M, T = tt.Manifold("m004"), tt.Triangulation("cPcbbbiht")
    calls = {
        "Manifold": lambda: tt.Manifold(thing(r)),
        "Triangulation": lambda: tt.Triangulation(thing(r)),
        "Mesh": lambda: tt.Mesh(thing(r), thing(r), thing(r)),
        "Mesh tags": lambda: tt.Mesh(RING.points, RING.triangles, triangle_tags=thing(r)),
        "Mesh.read": lambda: tt.Mesh.read(thing(r)),
        "slit_map": lambda: tt.slit_map(*r.choice([(thing(r),), (thing(r), thing(r)), good_mesh(r)])).uv,
        "check": lambda: tt.check(*r.choice([(thing(r),), (array(r), array(r)), good_mesh(r)])),
        "bundle": lambda: tt.bundle(*r.choice([(thing(r),), good_mesh(r)])),
        "direct_product": lambda: tt.direct_product(thing(r), labels=scalar(r)),
        "move": lambda: T.move(scalar(r), *[scalar(r) for _ in range(r.randrange(4))]),
        "move 2-3": lambda: T.move(r.choice(["2-3", "3-2", "1-4", "4-4", "0-2", "merge", "pack", "cone"]),
                                   *[r.choice([-1, 0, 1, 2, 3, 4, 99, 2**31 - 1]) for _ in range(r.randrange(5))]),
        "moves": lambda: T.moves(scalar(r)),
        "homology": lambda: M.homology(scalar(r), scalar(r)),
        "structure": lambda: M.structure(method=scalar(r), attempts=r.choice([1, scalar(r)]), seed=scalar(r)),
        "is_isometric_to": lambda: M.is_isometric_to(thing(r)),
        "identify": lambda: M.identify(attempts=r.choice([1, -1, None, "x"]), seed=scalar(r)),
        "holonomy": lambda: M.holonomy()(scalar(r)),
        "census": lambda: tt.census(scalar(r)),
        "census filter": lambda: tt.census(2, volume=scalar(r), boundary=scalar(r), homology=scalar(r), cusps=scalar(r)),
        "census item": lambda: tt.census(2)[r.choice([0, 7, 1.0, "fmp2_1", None, (1,)])],
        "AbelianGroup": lambda: tt.AbelianGroup(scalar(r), r.choice([[scalar(r)], [2, 3]])),
        "FundamentalGroup": lambda: tt.FundamentalGroup(r.choice([2, 0, -1]), r.choice([[(1, 5)], [[1, -2]], [(0,)]])),
        "open_all": lambda: tt.open_all(scalar(r)),
        "save": lambda: T.save(r.choice(["/nonexistent/x.json", "x", "", "x.obj", 3, None])),
        "run": lambda: tt.run(scalar(r), thing(r)),
        "info": lambda: tt.info(thing(r), progress=r.choice([None, False, 3, "x"])),
        "deleted": deleted_file,
    }
    name = r.choice(list(calls))
    return name, calls[name]


def deleted_file():
    with tempfile.NamedTemporaryFile(suffix=".off", dir=".", delete=False) as file:
        file.write(b"OFF\n")
    os.remove(file.name)
    tt.Mesh.read(file.name)


#: What Python itself raises where a thing is asked for that is not in a sequence.
SEQUENCE = (IndexError, KeyError)


def main(calls=10000, seed=1):
    warnings.simplefilter("ignore")
    np.seterr(all="ignore")
    counts, bad, slowest = {}, [], (0.0, "")
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for k in range(calls):
            r = random.Random(seed * 1_000_003 + k)
            start = time.monotonic()
            name, call = (command_call if r.random() < 0.4 else library_call)(r)
            try:
                call()
                outcome = "done"
            except (ValueError, TypeError) as error:
                outcome = type(error).__name__
                if not str(error).strip() or "\n" in str(error) or len(str(error)) > 2000:
                    bad.append("%d %s: %s: %r" % (k, name, outcome, str(error)[:300]))
            except SEQUENCE as error:
                outcome = type(error).__name__
                if name != "census item":
                    bad.append("%d %s: %r" % (k, name, error))
            except Exception as error:  # what must not be
                outcome = type(error).__name__
                bad.append("%d %s: %s: %s" % (k, name, outcome, str(error)[:300]))
            counts[outcome] = counts.get(outcome, 0) + 1
            slowest = max(slowest, (time.monotonic() - start, "%d %s" % (k, name)))
        os.chdir("/")
    for line in bad[:50]:
        print(line)
    print(calls, "calls:", ", ".join("%s %d" % item for item in sorted(counts.items())), "; %d bad;" % len(bad),
          "slowest %.1f s: %s" % slowest)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main(*map(int, sys.argv[1:])))
