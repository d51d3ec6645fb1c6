# SPDX-License-Identifier: GPL-2.0-or-later
"""Files gone bad, and surfaces and solids that nobody should have made: each from a number, the same every time."""
import gzip
import math
import os
import random
import re

# What a number in a text is replaced by.
NUMBERS = ("0", "-1", "1", "2147483647", "2147483648", "-2147483649", "9223372036854775807", "18446744073709551616", "1e308", "1e309",
           "-1e-320", "nan", "inf", "-inf", "0x10", "1,5", "1.", "--1", "1e", "999999999999999999999999999999", "", "\u0663", "3.7")
BYTES = (b"\0", b"\xff", b"\n", b"\r", b"\x1b[2J", b"\x80", b"\"", b"{", b"[", b"<", b"&#0;", b"&lt;", b"\xef\xbb\xbf", b"#", b"%", b"\\")
NUMBER = re.compile(rb"-?\d+\.?\d*(?:[eE][-+]?\d+)?")


def files_in(folder):
    """The small files below a folder: [(name, bytes)], in the order of their paths."""
    found = []
    for place, folders, names in os.walk(folder):
        folders.sort()
        for name in sorted(names):
            path = os.path.join(place, name)
            if os.path.getsize(path) <= 40000 and not name.endswith((".md", ".py", ".geo")):
                with open(path, "rb") as file:
                    found.append((name if "." in name else f"{os.path.basename(place)}_{name}", file.read()))
    return found


def seeds(source):
    """Those of the tests and of the fuzzers' corpora."""
    return files_in(os.path.join(source, "tests/data")) + files_in(os.path.join(source, "tools/fuzz/corpus"))


def somewhere(rng, data):
    """A place in it: each beginning of a line or a word is as likely as any byte."""
    if rng.random() < 0.5 and data.count(b"\n") > 1:
        return rng.choice([m.end() for m in re.finditer(rb"\n", data)][:-1])
    return rng.randrange(len(data) + 1)


def other_number(rng, data):
    found = list(NUMBER.finditer(data))
    if not found:
        return data + rng.choice(BYTES)
    match = rng.choice(found)
    return data[:match.start()] + rng.choice(NUMBERS).encode() + data[match.end():]


def number_of_elsewhere(rng, data):
    """One number as another one of the file is, or one more: what can still be read, and means something else."""
    found = list(NUMBER.finditer(data))
    if not found:
        return data
    match, other = rng.choice(found), rng.choice(found)[0]
    if rng.random() < 0.3 and match[0].isdigit():
        other = str(int(match[0][:18]) + 1).encode()
    return data[:match.start()] + other + data[match.end():]


def other_byte(rng, data):
    k = rng.randrange(len(data) or 1)
    return data[:k] + bytes([rng.randrange(256)]) + data[k + 1:]


def other_bit(rng, data):
    if not data:
        return b"\0"
    k = rng.randrange(len(data))
    return data[:k] + bytes([data[k] ^ 1 << rng.randrange(8)]) + data[k + 1:]


def cut_off(rng, data):
    return data[:somewhere(rng, data)]


def cut_out(rng, data):
    a, b = sorted((somewhere(rng, data), somewhere(rng, data)))
    return data[:a] + data[b:]


def twice(rng, data):
    a, b = sorted((somewhere(rng, data), somewhere(rng, data)))
    return data[:b] + data[a:b] * rng.choice((1, 1, 1, 30)) + data[b:]


def strange(rng, data):
    k = somewhere(rng, data)
    return data[:k] + rng.choice(BYTES) * rng.choice((1, 1, 5000)) + data[k:]


def lines_in_disorder(rng, data):
    lines = data.split(b"\n")
    a, b = rng.randrange(len(lines)), rng.randrange(len(lines))
    lines[a], lines[b] = lines[b], lines[a]
    return b"\n".join(lines)


def carriage_returns(_, data):
    return data.replace(b"\n", b"\r\n")


CHANGES = (other_number, other_number, other_byte, other_bit, cut_off, cut_out, twice, strange, lines_in_disorder,
           carriage_returns)


def file_gone_bad(found, number):
    """(name, bytes) of the mutant with this number: up to four changes of a seed; now and then two seeds are joined, or packed."""
    rng = random.Random(f"file {number}")
    name, data = rng.choice(found)
    if data[:2] == b"\x1f\x8b" and rng.random() < 0.7:  # what is packed is changed inside
        data, name = gzip.decompress(data), name.removesuffix(".gz")
    if rng.random() < 0.05:
        other = rng.choice(found)[1]
        data = data[:somewhere(rng, data)] + other[somewhere(rng, other):]
    for _ in range(rng.choice((0, 1, 1, 1, 1, 2, 4))):
        data = (number_of_elsewhere if rng.random() < 0.5 else rng.choice(CHANGES))(rng, data)
    if rng.random() < 0.03:
        data, name = gzip.compress(data, mtime=0), name + ".gz"
    stem, end = os.path.splitext(name)
    return f"mutant{end if len(end) > 1 else '.' + stem}", data


def grid_surface(rng):
    """A square, a ring or a torus of squares cut in two: (points, triangles)."""
    n, m = rng.randint(2, 9), rng.randint(3, 9)
    kind = rng.choice(("square", "ring", "torus", "two holes"))
    if kind == "torus":
        n = max(n, 3)
    points, wide, high = [], kind in ("ring", "torus"), kind == "torus"
    rows, columns = n if high else n + 1, m if wide else m + 1
    for i in range(rows):
        for j in range(columns):
            t, s = 2 * math.pi * j / m, 2 * math.pi * i / n
            if kind == "torus":
                points.append([(3 + math.cos(s)) * math.cos(t), (3 + math.cos(s)) * math.sin(t), math.sin(s)])
            elif kind == "ring":
                points.append([(1 + i) * math.cos(t), (1 + i) * math.sin(t), 0.1 * i * i])
            else:
                points.append([float(i), float(j), 0.1 * i * j])
    triangles = []
    for i in range(n):
        for j in range(m):
            if kind == "two holes" and (i + 2, j + 2) in ((n, m), (3, 3)):
                continue
            a, b = i % rows * columns + j % columns, i % rows * columns + (j + 1) % columns
            c, d = (i + 1) % rows * columns + j % columns, (i + 1) % rows * columns + (j + 1) % columns
            triangles += [[a, c, d], [a, d, b]] if rng.random() < 0.7 else [[a, c, b], [c, d, b]]
    return points, triangles


def grid_solid(rng):
    """Some cubes of a grid, six tetrahedra each: (points, tetrahedra)."""
    n = [rng.randint(1, 4) for _ in range(3)]
    cubes = [(i, j, k) for i in range(n[0]) for j in range(n[1]) for k in range(n[2])]
    if rng.random() < 0.5:
        cubes = [cube for cube in cubes if rng.random() < 0.8] or cubes
    at, points, tetrahedra = {}, [], []
    for cube in cubes:
        for order in ((0, 1, 2), (1, 2, 0), (2, 0, 1), (0, 2, 1), (2, 1, 0), (1, 0, 2)):
            corner, path = list(cube), []
            for axis in (None,) + order:
                if axis is not None:
                    corner[axis] += 1
                if tuple(corner) not in at:
                    at[tuple(corner)] = len(points)
                    points.append([float(x) for x in corner])
                path.append(at[tuple(corner)])
            tetrahedra.append(path if order in ((0, 1, 2), (1, 2, 0), (2, 0, 1)) else [path[1], path[0], *path[2:]])
    return points, tetrahedra


def spoil(rng, points, elements):
    """One thing that should not be."""
    count, what = len(points), rng.randrange(18)
    k, e = rng.randrange(count), rng.randrange(len(elements))
    if what == 0:  # another size, as far as doubles go
        factor = 10.0 ** rng.choice((-300, -160, -30, -9, 9, 30, 150, 300))
        points[:] = [[x * factor for x in p] for p in points]
    elif what == 1:  # flat or nearly flat along an axis
        axis, factor = rng.randrange(3), rng.choice((0.0, 1e-300, 1e-16, 1e-8, 1e8))
        for p in points:
            p[axis] *= factor
    elif what == 2:  # two points at one place, or nearly
        points[k] = [x + rng.choice((0.0, 1e-300, 1e-16, 1e-12)) for x in points[rng.randrange(count)]]
    elif what == 3:  # all points in disorder
        size = rng.choice((1e-6, 0.3, 3.0, 1e6))
        points[:] = [[x + rng.uniform(-size, size) for x in p] for p in points]
    elif what == 4:  # one far away
        points[k][rng.randrange(3)] = rng.choice((1e6, -1e15, 1e150, 1.7e308, -1e-308))
    elif what == 5:  # an element twice, the second one perhaps turned over
        twin = list(elements[e])
        elements.append(twin if rng.random() < 0.5 else twin[::-1])
    elif what == 6:  # turned over
        elements[e][0], elements[e][1] = elements[e][1], elements[e][0]
    elif what == 7:  # missing elements
        for _ in range(rng.choice((1, 2, len(elements) // 2))):
            if len(elements) > 1:
                elements.pop(rng.randrange(len(elements)))
    elif what == 8:  # degenerate
        elements[e][0] = elements[e][1]
    elif what == 9:  # glued to any other vertex: pinches, edges with many sides
        elements[e][rng.randrange(len(elements[e]))] = k
    elif what == 10:  # a vertex that is not there
        elements[e][0] = rng.choice((count, -1, 10**9))
    elif what == 11:  # two vertices become one: a pinch, or a handle
        other = rng.randrange(count)
        elements[:] = [[other if v == k else v for v in element] for element in elements]
    elif what == 12:  # no number
        points[k][rng.randrange(3)] = rng.choice((math.nan, math.inf, -math.inf))
    elif what == 13:  # the whole twice, beside each other or in the same place
        shift = rng.choice((0.0, 0.5, 100.0))
        elements += [[v + count for v in element] for element in elements]
        points += [[p[0] + shift, *p[1:]] for p in points]
    elif what == 14:  # vertices in no element
        points += [[rng.uniform(-1, 1) for _ in range(3)] for _ in range(rng.choice((1, 50)))]
    elif what == 15:  # only a few elements
        del elements[rng.choice((1, 2, 3)):]
    elif what == 16:  # a needle: an element's point nearly on its edge
        a, b = points[elements[e][0]], points[elements[e][1]]
        if elements[e][2] < count:
            points[elements[e][2]] = [x + (y - x) * 0.5 + 10.0 ** -rng.choice((3, 9, 14, 17)) for x, y in zip(a, b)]
    else:  # all in one point
        points[:] = [list(points[0]) for _ in points]


def shape_gone_bad(number):
    """(name, text, whether a surface) of the hostile geometry with this number; one in eight is spoiled not at all."""
    rng = random.Random(f"shape {number}")
    is_surface = rng.random() < 0.7
    points, elements = grid_surface(rng) if is_surface else grid_solid(rng)
    if not elements:
        elements = [[0, 1, 2] if is_surface else [0, 1, 2, 3]]
    for _ in range(rng.choice((0, 1, 1, 1, 1, 1, 2, 3))):
        count = len(points)
        spoil(rng, points, elements)
        elements[:] = [[v if rng.random() < 0.98 or 0 <= v < count else 0 for v in element] for element in elements]
        if any(not 0 <= v < len(points) for element in elements for v in element):
            break
    if is_surface:
        lines = ["OFF", f"{len(points)} {len(elements)} 0", *(" ".join(map(repr, p)) for p in points)]
        lines += [" ".join(map(str, [3, *element])) for element in elements]
        return "shape.off", "\n".join(lines) + "\n", True
    lines = ["MeshVersionFormatted 2", "Dimension 3", "Vertices", str(len(points)), *(" ".join(map(repr, p)) + " 0" for p in points)]
    lines += ["Tetrahedra", str(len(elements)), *(" ".join(str(v + 1) for v in element) + " 0" for element in elements), "End"]
    return "shape.mesh", "\n".join(lines) + "\n", False
