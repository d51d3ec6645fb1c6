#!/usr/bin/env python3
"""A smooth solid of genus 5: a thick disk with five holes, round everywhere, {z^2 < h(g(x, y))}.

    genus5_smooth.py 0.25 genus5_smooth.mesh     edges of about 0.25; needs tetgen (1.5.0)

g is a soft minimum of the distances to six circles, h(g) = H^2 tanh(g / W), so that the rims are round. The
surface is cut out of a grid of tetrahedra (grid points near it are put on it first), smoothed along itself, and
filled by tetgen, which keeps it.
"""
import itertools
import math
import os
import subprocess
import sys
import tempfile

H, W, SHARP = 0.38, 0.25, 10.0
CENTRES = [(1.25 * math.cos(2 * math.pi * k / 5 + 0.2), 1.25 * math.sin(2 * math.pi * k / 5 + 0.2)) for k in range(5)]
HOLE, OUTER = 0.42, 2.2


def f(p):
    x, y, z = p
    d = [OUTER - math.hypot(x, 1.08 * y)] + [math.hypot(x - a, y - b) - HOLE for a, b in CENTRES]
    g = -math.log(sum(math.exp(-SHARP * max(-3, min(9, s))) for s in d)) / SHARP
    return z * z - H * H * math.tanh(g / W)


def add(p, q, t=1.0):
    return (p[0] + t * q[0], p[1] + t * q[1], p[2] + t * q[2])


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1] + p[2] * q[2]


def cross(p, q):
    return (p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0])


def normal(p, q, r):
    return cross(add(q, p, -1), add(r, p, -1))


def gradient(p, e=1e-5):
    axes = ((e, 0, 0), (0, e, 0), (0, 0, e))
    return tuple((f(add(p, a)) - f(add(p, a, -1))) / (2 * e) for a in axes)


def project(p, steps=4):
    for _ in range(steps):
        n = gradient(p)
        t = -f(p) / max(dot(n, n), 1e-12)
        length = abs(t) * math.sqrt(dot(n, n))
        p = add(p, n, t * min(1, 0.1 / max(length, 1e-12)))
    return p


def cut_surface(size):
    shape = [int(math.ceil(2 * r / size)) + 3 for r in (OUTER, OUTER, H)]
    low = [-(n - 1) * size / 2 + 0.013 * size for n in shape]
    points, value = {}, {}
    for at in itertools.product(*map(range, shape)):
        p = tuple(low[i] + size * at[i] for i in range(3))
        points[at], value[at] = p, f(p)
        slope = math.sqrt(dot(gradient(p), gradient(p)))
        # Grid points that are nearly on the surface go there: no thin triangles.
        if abs(value[at]) < 0.3 * size * slope:
            q = project(p)
            if math.dist(p, q) < 0.45 * size:
                points[at], value[at] = q, 0.0
    vertex, place, triangles = {}, [], []

    def on(a, b):
        key = (a, a) if value[a] == 0 else (b, b) if value[b] == 0 else (min(a, b), max(a, b))
        if key not in vertex:
            vertex[key] = len(place)
            a, b = key
            t = 0 if a == b else value[a] / (value[a] - value[b])
            place.append(add(points[a], add(points[b], points[a], -1), t))
        return vertex[key]

    def put(polygon, inside):
        for i in range(1, len(polygon) - 1):
            t = [polygon[0], polygon[i], polygon[i + 1]]
            if len(set(t)) == 3:
                n = normal(*(place[v] for v in t))
                outward = dot(n, add(points[inside], place[t[0]], -1)) < 0
                triangles.append(t if outward else [t[0], t[2], t[1]])

    for at in itertools.product(*(range(n - 1) for n in shape)):
        for order in itertools.permutations(range(3)):
            corner = list(at)
            tet = [at]
            for axis in order:
                corner[axis] += 1
                tet.append(tuple(corner))
            inner = [v for v in tet if value[v] < 0]
            outer = [v for v in tet if value[v] >= 0]
            if len(inner) == 2:
                (a, b), (c, d) = inner, outer
                put([on(a, c), on(a, d), on(b, d), on(b, c)], a)
            elif len(inner) in (1, 3):
                put([on(v, w) for v in inner for w in outer], inner[0])
    return place, triangles


def smoothed(points, triangles, rounds):
    around = [[] for _ in points]
    for t in triangles:
        for i in range(3):
            around[t[i]].append(t[(i + 1) % 3])
    for _ in range(rounds):
        middles = [tuple(sum(points[w][k] for w in ring) / len(ring) for k in range(3)) for ring in around]
        points = [project(add(p, add(m, p, -1), 0.5), 2) for p, m in zip(points, middles)]
    return points


def flipped(points, triangles, rounds=6):
    """Edges flipped where that makes the valences more even."""
    triangles = [list(t) for t in triangles]
    for _ in range(rounds):
        valence = [0] * len(points)
        side = {}
        for t, tri in enumerate(triangles):
            for i in range(3):
                valence[tri[i]] += 1
                side[tri[i], tri[(i + 1) % 3]] = t
        changed = set()
        new = set()
        for (a, b), s in list(side.items()):
            t = side[b, a]
            if a > b or s in changed or t in changed:
                continue
            c = sum(triangles[s]) - a - b
            d = sum(triangles[t]) - a - b
            if (c, d) in side or (d, c) in side or (min(c, d), max(c, d)) in new:
                continue
            four = ((a, -1), (b, -1), (c, 1), (d, 1))
            gain = sum((valence[v] - 6) ** 2 - (valence[v] + k - 6) ** 2 for v, k in four)
            n = normal(points[a], points[b], points[c])
            halves = [normal(points[c], points[a], points[d]), normal(points[d], points[b], points[c])]
            if gain <= 0 or min(dot(n, h) for h in halves) <= 0.3 * dot(n, n):
                continue
            triangles[s], triangles[t] = [c, a, d], [d, b, c]
            for v, k in four:
                valence[v] += k
            changed |= {s, t}
            new.add((min(c, d), max(c, d)))
        if not changed:
            break
    return triangles


def filled(points, triangles, size):
    """The points and the tetrahedra, counted from 0, by tetgen."""
    with tempfile.TemporaryDirectory() as folder:
        base = os.path.join(folder, 's')
        with open(base + '.off', 'w') as file:
            print('OFF\n%d %d 0' % (len(points), len(triangles)), file=file)
            for p in points:
                print('%.9g %.9g %.9g' % p, file=file)
            for t in triangles:
                print(3, *t, file=file)
        subprocess.run(['tetgen', '-pYQq1.3/12a%g' % (size ** 3 * 0.25), base + '.off'], check=True, cwd=folder)
        rows = {}
        for kind in ('node', 'ele'):
            lines = [line.split() for line in open('%s.1.%s' % (base, kind)) if not line.startswith('#')]
            rows[kind] = [line for line in lines[1:] if line]
    first = int(rows['node'][0][0])
    return ([tuple(map(float, r[1:4])) for r in rows['node']],
            [[int(v) - first for v in r[1:5]] for r in rows['ele']])


def main():
    size, out = float(sys.argv[1]), sys.argv[2]
    digits = 4 if size > 0.2 else 7
    points, triangles = cut_surface(size)
    for rounds in (8, 8, 8, 10):
        points = smoothed(points, triangles, rounds)
        triangles = flipped(points, triangles)
    points, tets = filled(points, triangles, size)
    with open(out, 'w') as file:
        print('MeshVersionFormatted 2\nDimension 3\nVertices\n%d' % len(points), file=file)
        for p in points:
            print(*('%.*g' % (digits, x) for x in p), 0, file=file)
        print('Tetrahedra\n%d' % len(tets), file=file)
        for t in tets:
            print(*[v + 1 for v in t], 0, file=file)
        print('End', file=file)


main()
