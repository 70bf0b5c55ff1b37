"""The shapes of the shipped scenes, as OBJ texts.

The ground's colours hold ambient occlusion and the soft shadow of one light, computed for spheres that stand for the
objects.
"""

import math


def obj(lines, vertices, faces, colours=None, header=""):
    """An OBJ text; faces are lists of vertex numbers from 1, which may have a material before them as a string."""
    out = [f"# Written by scenes/make.py: {lines}", *([header] if header else [])]
    for i, (x, y, z) in enumerate(vertices):
        colour = "".join(f" {c:.3g}" for c in colours[i]) if colours else ""
        out.append(f"v {x:.4f} {y:.4f} {z:.4f}{colour}")
    out += [face if isinstance(face, str) else "f " + " ".join(map(str, face)) for face in faces]
    return "\n".join(out) + "\n"


def sphere(across=56, down=28):
    """A unit sphere whose normals are its vertices."""
    points = [(0, 1, 0)]
    for j in range(1, down):
        for i in range(across):
            a, b = 2 * math.pi * i / across, math.pi * j / down
            points.append((math.sin(b) * math.sin(a), math.cos(b), math.sin(b) * math.cos(a)))
    points.append((0, -1, 0))
    last = len(points)
    faces = []
    for i in range(across):
        n = (i + 1) % across
        faces.append((1, 2 + i, 2 + n))
        for j in range(down - 2):
            a, b = 2 + j * across, 2 + (j + 1) * across
            faces.append((a + i, b + i, b + n, a + n))
        a = 2 + (down - 2) * across
        faces.append((a + i, last, a + n))
    out = ["# Written by scenes/make.py: a unit sphere"]
    out += [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in points] + [f"vn {x:.5f} {y:.5f} {z:.5f}" for x, y, z in points]
    out += ["f " + " ".join(f"{v}//{v}" for v in face) for face in faces]
    return "\n".join(out) + "\n"


def spline(points, steps):
    """A Catmull-Rom curve through points of the plane; a point given twice is a corner."""
    out = []
    for k in range(len(points) - 1):
        p1, p2 = points[k], points[k + 1]
        if p1 == p2:
            continue
        p0 = points[k - 1] if k > 0 else p1
        p3 = points[k + 2] if k + 2 < len(points) else p2
        for s in range(steps):
            t = s / steps
            out.append(tuple(0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t +
                                    (3 * b - a - 3 * c + d) * t * t * t) for a, b, c, d in zip(p0, p1, p2, p3)))
    return out + [points[-1]]


def lathe(about, profile, across, colour=None, bend=None):
    """Turns a profile of (radius, height), from the bottom up, about the y axis."""
    vertices, colours, faces = [], [], []
    for j, (r, y) in enumerate(profile):
        for i in range(across):
            a = 2 * math.pi * i / across
            p = (r * math.sin(a), y, r * math.cos(a))
            vertices.append(bend(p, a) if bend else p)
            if colour:
                colours.append(colour(j / (len(profile) - 1), a))
        for i in range(across):
            n = (i + 1) % across
            if j > 0:
                a, b = 1 + (j - 1) * across, 1 + j * across
                if profile[j - 1][0] == 0:  # a pole: one corner
                    faces.append((a, b + n, b + i))
                elif r == 0:
                    faces.append((a + i, a + n, b))
                else:
                    faces.append((a + i, a + n, b + n, b + i))
    return obj(about, vertices, faces, colours or None)


def vase():
    outside = [(0, 0), (0.30, 0), (0.34, 0.02), (0.34, 0.02), (0.36, 0.10), (0.56, 0.45), (0.66, 0.80), (0.58, 1.15),
               (0.34, 1.42), (0.21, 1.62), (0.20, 1.80), (0.30, 1.98), (0.345, 2.02), (0.33, 2.045)]
    inside = [(0.27, 1.97), (0.165, 1.80), (0.17, 1.62), (0.28, 1.42)]
    return lathe("a vase", spline(outside + inside, 4), 64)


def bowl():
    outside = [(0, 0), (0.24, 0), (0.27, 0.02), (0.27, 0.02), (0.22, 0.07), (0.24, 0.12), (0.44, 0.22), (0.60, 0.40),
               (0.68, 0.60), (0.69, 0.63)]
    inside = [(0.665, 0.63), (0.575, 0.42), (0.42, 0.26), (0.22, 0.18), (0, 0.165)]
    return lathe("a bowl on a foot", spline(outside + inside, 5), 64)


def pot():
    """A pot with a lid: the wall is upright, the lid a flat cone, so both show how a highlight runs across grooves."""
    profile = [(0, 0), (0.54, 0), (0.60, 0.02), (0.63, 0.07), (0.64, 0.14), (0.64, 0.14), (0.64, 0.40), (0.64, 0.66),
               (0.64, 0.66), (0.675, 0.672), (0.69, 0.69), (0.675, 0.712), (0.655, 0.715), (0.655, 0.715), (0.40, 0.785),
               (0.16, 0.85), (0.16, 0.85), (0.075, 0.862), (0.06, 0.90), (0.10, 0.955), (0.135, 1.01), (0.115, 1.065),
               (0.05, 1.09), (0, 1.093)]
    return lathe("a pot with a lid", spline(profile, 3), 64)


def mix(a, b, t):
    t = min(1, max(0, t))
    return tuple(x + (y - x) * t for x, y in zip(a, b))


def apple():
    profile = spline([(0, 0.10), (0.05, 0.06), (0.14, 0.01), (0.26, 0.02), (0.40, 0.17), (0.46, 0.42), (0.41, 0.66),
                      (0.27, 0.77), (0.13, 0.75), (0.05, 0.67), (0.025, 0.64)], 3)
    stem = [(0.025, 0.64), (0.02, 0.72), (0.021, 0.80), (0.032, 0.86), (0, 0.87)]
    body = len(profile)
    total = body + len(stem) - 1

    def colour(t, a):
        if t * total > body:
            return (0.22, 0.13, 0.06)
        red = mix((0.62, 0.03, 0.03), (0.80, 0.10, 0.04), 0.5 + 0.5 * math.sin(11 * a + 3 * math.sin(2 * a)))
        blush = mix(red, (0.80, 0.52, 0.10), max(0, 1.9 * t - 0.92) + max(0, 0.5 - 6 * t))
        return mix(blush, (0.78, 0.62, 0.16), 0.35 * max(0, math.sin(a + 0.6)) ** 2)

    def bend(p, a):
        x, y, z = p
        lobed = 1 + 0.018 * math.cos(5 * a) * (1 - y)
        tilt = 0.12 * max(0, y - 0.70) if y > 0.7 else 0
        return (x * lobed + tilt, y, z * lobed)

    return lathe("an apple", profile + stem[1:], 48, colour, bend)


def pear():
    profile = spline([(0, 0.07), (0.06, 0.03), (0.16, 0.0), (0.32, 0.09), (0.42, 0.33), (0.36, 0.58), (0.22, 0.82),
                      (0.155, 1.00), (0.115, 1.12), (0.045, 1.17), (0.022, 1.15)], 3)
    stem = [(0.022, 1.15), (0.018, 1.24), (0.02, 1.33), (0.028, 1.40), (0, 1.41)]
    body = len(profile)
    total = body + len(stem) - 1

    def colour(t, a):
        if t * total > body:
            return (0.20, 0.12, 0.05)
        green = mix((0.50, 0.56, 0.10), (0.72, 0.62, 0.13), 0.5 + 0.5 * math.sin(a + 2.0))
        return mix(green, (0.76, 0.36, 0.10), 0.55 * max(0, math.sin(a - 0.5)) ** 2 * math.sin(math.pi * min(1, t)))

    def bend(p, a):
        x, y, z = p
        lean = 0.10 * max(0, y - 0.5) ** 2
        return (x + lean + (0.10 * max(0, y - 1.15)), y, z)

    return lathe("a pear", profile + stem[1:], 48, colour, bend)


def knot():
    """A (2, 3) torus knot: a tube around a curve that winds around a ring."""
    def ring(t):
        return (0.62 * math.cos(2 * t), 0.0, 0.62 * math.sin(2 * t))

    def outward(t):
        r = 0.26 * math.cos(3 * t)
        return (r * math.cos(2 * t), 0.34 * math.sin(3 * t), r * math.sin(2 * t))

    def centre(t):
        return tuple(a + b for a, b in zip(ring(t), outward(t)))

    def cross(a, b):
        return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])

    def unit(a):
        length = math.sqrt(sum(x * x for x in a))
        return tuple(x / length for x in a)

    along, around = 192, 20
    vertices, faces = [], []
    for i in range(along):
        t = 2 * math.pi * i / along
        p = centre(t)
        tangent = unit(tuple(a - b for a, b in zip(centre(t + 1e-3), centre(t - 1e-3))))
        side = unit(cross(tangent, outward(t)))
        up = cross(side, tangent)
        for j in range(around):
            a = 2 * math.pi * j / around
            vertices.append(tuple(c + 0.155 * (math.cos(a) * s + math.sin(a) * u) for c, s, u in zip(p, side, up)))
            k, m = (i + 1) % along, (j + 1) % around
            faces.append((1 + i * around + j, 1 + k * around + j, 1 + k * around + m, 1 + i * around + m))
    return obj("a torus knot", vertices, faces)


def light_left(x, y, z, normal, blockers):
    """What spheres (x, y, z, r) leave of the light from all around: 1 less the cosine-weighted solid angle of each."""
    left = 1.0
    for bx, by, bz, r in blockers:
        d = (bx - x, by - y, bz - z)
        distance = math.sqrt(sum(c * c for c in d))
        if distance <= r:
            return 0.0
        cosine = sum(c * n for c, n in zip(d, normal)) / distance
        left *= 1 - max(0.0, cosine) * (r / distance) ** 2
    return left


def shadow(x, y, z, light, blockers):
    """How much of a round light spheres hide, about: 0 .. 1."""
    to = [a - b for a, b in zip(light, (x, y, z))]
    far = math.sqrt(sum(c * c for c in to))
    half = 0.10  # the light's radius, as an angle
    seen = 1.0
    for bx, by, bz, r in blockers:
        d = (bx - x, by - y, bz - z)
        distance = math.sqrt(sum(c * c for c in d))
        if distance <= r:
            return 1.0
        angle = math.acos(max(-1.0, min(1.0, sum(a * b for a, b in zip(to, d)) / (far * distance))))
        t = min(1.0, max(0.0, (math.asin(r / distance) + half - angle) / (2 * half)))
        seen *= 1 - t * t * (3 - 2 * t)
    return 1 - seen


def ground(about, blockers, light, half_width, front, back, height, columns, rows):
    """A floor that bends up into a wall behind; columns are denser around the middle, rows in front."""
    radius = 1.4
    vertices, colours, faces = [], [], []
    arc = radius * math.pi / 2
    length = (front - back - radius) + arc + (height - radius)
    for j in range(rows + 1):
        s = length * (j / rows) ** 1.15
        if s < front - back - radius:
            y, z, normal = 0.0, front - s, (0, 1, 0)
        elif s < front - back - radius + arc:
            a = (s - (front - back - radius)) / radius
            y, z = radius * (1 - math.cos(a)), back + radius - radius * math.sin(a)
            normal = (0, math.cos(a), math.sin(a))
        else:
            y, z, normal = radius + s - (front - back - radius) - arc, back, (0, 0, 1)
        for i in range(columns + 1):
            u = 2 * i / columns - 1
            x = half_width * (0.45 * u + 0.55 * u ** 3)
            vertices.append((x, y, z))
            left = (0.15 + 0.85 * light_left(x, y, z, normal, blockers)) * (1 - 0.55 * shadow(x, y, z, light, blockers))
            colours.append((left, left, left))
    for j in range(rows):
        for i in range(columns):
            a = 1 + j * (columns + 1) + i
            faces.append((a, a + 1, a + columns + 2, a + columns + 1))
    return obj(about, vertices, faces, colours)
