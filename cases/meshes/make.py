#!/usr/bin/env python3
"""Writes the models and images of this folder. Python's own library is enough; the same bytes come out each time.

cases/meshes/make.py [FOLDER]
"""
import math
import os
import struct
import sys
import zlib

FOLDER = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))


def number(value):
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text


def write_obj(name, comment, lines):
    with open(os.path.join(FOLDER, name + ".obj"), "w", newline="\n") as file:
        file.write(f"# {comment}\n# Written by make.py.\n")
        file.write("\n".join(lines) + "\n")


def line(keyword, values):
    return keyword + " " + " ".join(number(value) for value in values)


def cube():
    """Quads, with texture coordinates and normals of each face."""
    lines = [line("v", (x, y, z)) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    lines += [line("vt", uv) for uv in ((0, 0), (1, 0), (1, 1), (0, 1))]
    faces = [("right", (1, 0, 0), (6, 5, 7, 8)), ("left", (-1, 0, 0), (1, 2, 4, 3)), ("top", (0, 1, 0), (4, 8, 7, 3)),
             ("bottom", (0, -1, 0), (1, 5, 6, 2)), ("front", (0, 0, 1), (2, 6, 8, 4)), ("back", (0, 0, -1), (5, 1, 3, 7))]
    for number_of_face, (name, normal, corners) in enumerate(faces, 1):
        lines += [f"g {name}", line("vn", normal)]
        lines.append("f " + " ".join(f"{v}/{vt}/{number_of_face}" for vt, v in enumerate(corners, 1)))
    write_obj("cube", "A cube from -1 to 1: quads, each face a group of its own.", lines)


def surface(name, comment, columns, rows, point, closed_rows=False):
    """Quads over a grid: point(s, t) gives position and normal for s and t in [0, 1]."""
    lines = []
    for j in range(rows + 1):
        for i in range(columns + 1):
            position, normal = point(i / columns, j / rows)
            lines += [line("v", position), line("vt", (i / columns, j / rows)), line("vn", normal)]
    # Ends that meet share positions, so that no crack can open.
    def position_of(i, j):
        return (j % rows if closed_rows else j) * (columns + 1) + i % columns + 1

    def corner(i, j):
        return f"{position_of(i, j)}/{j * (columns + 1) + i + 1}/{j * (columns + 1) + i + 1}"

    for j in range(rows):
        for i in range(columns):
            lines.append("f " + " ".join((corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1))))
    write_obj(name, comment, lines)


def torus():
    def point(s, t):
        a, b = 2 * math.pi * s, 2 * math.pi * t
        normal = (math.cos(a) * math.cos(b), math.sin(b), -math.sin(a) * math.cos(b))
        position = (math.cos(a) * (1 + 0.4 * math.cos(b)), 0.4 * math.sin(b), -math.sin(a) * (1 + 0.4 * math.cos(b)))
        return position, normal

    surface("torus", "A torus around y: radii 1 and 0.4.", 24, 12, point, closed_rows=True)


def uv_sphere():
    def point(s, t):
        a, b = 2 * math.pi * s, math.pi * (t - 0.5)
        position = (math.cos(a) * math.cos(b), math.sin(b), -math.sin(a) * math.cos(b))
        return position, position

    surface("uv_sphere", "A sphere of radius 1 by longitude and latitude; the poles are degenerate quads.", 24, 12, point)


def icosphere():
    """Without normals, with a smoothing group and negative indices."""
    golden = (1 + math.sqrt(5)) / 2
    points = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden),
              (0, -1, -golden), (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]

    def normalized(p):
        length = math.sqrt(sum(x * x for x in p))
        return tuple(x / length for x in p)

    points = [normalized(p) for p in points]
    for _ in range(2):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(normalized([(points[a][i] + points[b][i]) / 2 for i in range(3)]))
            return middles[key]

        finer = []
        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    lines = [line("v", p) for p in points] + ["s 1"]
    lines += ["f " + " ".join(str(i - len(points)) for i in face) for face in faces]
    write_obj("icosphere", "An icosahedron subdivided twice: no normals, negative indices.", lines)


def plane():
    lines = [line("v", p) for p in ((-1, 0, 1), (1, 0, 1), (1, 0, -1), (-1, 0, -1))]
    lines += [line("vt", uv) for uv in ((0, 0), (4, 0), (4, 4), (0, 4))]
    lines += ["vn 0 1 0", "f 1/1/1 2/2/1 3/3/1 4/4/1"]
    write_obj("plane", "A plane from -1 to 1, facing up; its texture repeats four times each way.", lines)


def quad():
    lines = [line("v", p) for p in ((-1, -1, 0), (1, -1, 0), (1, 1, 0), (-1, 1, 0))]
    lines += [line("vt", uv) for uv in ((0, 0), (1, 0), (1, 1), (0, 1))]
    lines += ["vn 0 0 1", "f 1/1/1 2/2/1 3/3/1 4/4/1"]
    write_obj("quad", "A square from -1 to 1, facing +z.", lines)


def triangle():
    write_obj("triangle", "One triangle, facing +z.", ["v 1 0 0", "v 0 1 0", "v -1 0 0", "f 1 2 3"])


def beam():
    lines = [line("v", p) for p in ((-1.6, -0.25, 0.3), (1.6, -0.25, -0.3), (1.6, 0.25, -0.3), (-1.6, 0.25, 0.3))]
    lines.append("f 1 2 3 4")
    write_obj("beam", "A long rectangle, its left end nearer: three of them, turned by 120 degrees, overlap in a cycle.",
              lines)


# A jug of bicubic Bezier patches. Each patch is 4 rows of 4 control points; the data is our own.
KAPPA = 0.5522847498  # of a quarter circle's control points


def quarter_rings(profile):
    """Patches of a surface of revolution about y; `profile` is four (radius, height) control points."""
    patches = []
    for quarter in range(4):
        a = quarter * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        ring = [(1, 0), (1, KAPPA), (KAPPA, 1), (0, 1)]
        patches.append([[(radius * (x * c - y * s), height, -radius * (x * s + y * c)) for x, y in ring]
                        for radius, height in profile])
    return patches


def tube(spine, radius):
    """Patches around a spine of four control points in the plane z = 0."""
    patches = []
    for quarter in range(4):
        a = quarter * math.pi / 2
        c, s = math.cos(a), math.sin(a)
        ring = [(1, 0), (1, KAPPA), (KAPPA, 1), (0, 1)]
        rows = []
        for i, (x, y) in enumerate(spine):
            before, after = spine[max(i - 1, 0)], spine[min(i + 1, 3)]
            dx, dy = after[0] - before[0], after[1] - before[1]
            length = math.hypot(dx, dy)
            nx, ny = -dy / length, dx / length  # across the spine, in its plane
            rows.append([(x + radius * (u * c - v * s) * nx, y + radius * (u * c - v * s) * ny, radius * (u * s + v * c))
                         for u, v in ring])
        patches.append(rows)
    return patches


def bezier(p, t):
    b = ((1 - t) ** 3, 3 * t * (1 - t) ** 2, 3 * t * t * (1 - t), t ** 3)
    d = (-3 * (1 - t) ** 2, 3 * (1 - t) * (1 - 3 * t), 3 * t * (2 - 3 * t), 3 * t * t)
    return (tuple(sum(b[i] * p[i][k] for i in range(4)) for k in range(3)),
            tuple(sum(d[i] * p[i][k] for i in range(4)) for k in range(3)))


def jug():
    patches = quarter_rings([(0.0001, -1), (0.35, -1), (0.6, -1), (0.62, -0.97)])
    patches += quarter_rings([(0.62, -0.97), (1.15, -0.75), (1.1, 0.1), (0.6, 0.45)])
    patches += quarter_rings([(0.6, 0.45), (0.35, 0.63), (0.4, 0.85), (0.62, 1)])
    patches += tube([(0.62, 0.4), (1.2, 0.75), (1.75, 0.3), (1.4, -0.15)], 0.09)
    patches += tube([(1.4, -0.15), (1.25, -0.35), (1.1, -0.45), (0.9, -0.45)], 0.09)
    steps = 6
    lines = []
    positions, normals, faces = {}, [], []

    def position_number(p):
        key = tuple(round(x, 6) + 0.0 for x in p)
        return positions.setdefault(key, len(positions) + 1)

    for patch in patches:
        first = len(normals)
        numbers = []
        for j in range(steps + 1):
            for i in range(steps + 1):
                rows = [bezier(row, i / steps) for row in patch]
                p, dt = bezier([row[0] for row in rows], j / steps)
                ds, _ = bezier([row[1] for row in rows], j / steps)
                n = (ds[1] * dt[2] - ds[2] * dt[1], ds[2] * dt[0] - ds[0] * dt[2], ds[0] * dt[1] - ds[1] * dt[0])
                length = math.sqrt(sum(x * x for x in n)) or 1
                numbers.append(position_number(p))
                normals.append((tuple(x / length for x in n), (i / steps, j / steps)))
        for j in range(steps):
            for i in range(steps):
                k = [j * (steps + 1) + i, j * (steps + 1) + i + 1, (j + 1) * (steps + 1) + i + 1,
                     (j + 1) * (steps + 1) + i]
                faces.append("f " + " ".join(f"{numbers[x]}/{first + x + 1}/{first + x + 1}" for x in k))
    lines += [line("v", p) for p in positions]
    for normal, uv in normals:
        lines += [line("vt", uv), line("vn", normal)]
    write_obj("jug", "A jug with a handle, of 20 bicubic Bezier patches.", lines + faces)


def write_png(name, width, height, pixel):
    rows = b"".join(b"\0" + b"".join(bytes(pixel(x, y)) for x in range(width)) for y in range(height))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                   chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


def write_bmp(name, width, height, pixel):
    padding = b"\0" * (-3 * width % 4)
    rows = b"".join(b"".join(bytes(reversed(pixel(x, y))) for x in range(width)) + padding
                    for y in reversed(range(height)))
    with open(os.path.join(FOLDER, name), "wb") as file:
        file.write(struct.pack("<2sIHHI", b"BM", 54 + len(rows), 0, 0, 54) +
                   struct.pack("<IiiHHIIiiII", 40, width, height, 1, 24, 0, len(rows), 2835, 2835, 0, 0) + rows)


def images():
    def checker(x, y):
        if x < 4 and y < 4:
            return (224, 64, 48)  # the top left square tells which way up it is
        return (232, 232, 224) if (x // 4 + y // 4) % 2 == 0 else (40, 56, 80)

    def grid(x, y):
        if x % 16 in (0, 15) or y % 16 in (0, 15):
            return (24, 24, 24)
        return (40 + 3 * x, 215 - 3 * y, 128 + (x * y) % 64)

    write_png("checker.png", 16, 16, checker)
    write_png("grid.png", 64, 64, grid)
    write_bmp("grid.bmp", 64, 64, grid)
    write_png("odd.png", 13, 7, lambda x, y: (20 * x, 36 * y, 255 if (x + y) % 2 else 0))


for make in (cube, torus, uv_sphere, icosphere, plane, quad, triangle, beam, jug, images):
    make()
