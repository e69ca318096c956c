"""Closed bodies of flat facets, seen from outside anticlockwise: boxes, lofts, turned bodies, tubes."""

from math import cos, dist, pi, sin

# Points are written to this, metres: flat is what is flat within it.
PRECISION = 1e-4


class Mesh:
    """`box`: its corners, where it is a box along the axes."""

    def __init__(self, points, faces):
        self.points, self.faces, self.box = points, faces, None

    def moved(self, dx=0.0, dy=0.0, dz=0.0):
        return Mesh([(x + dx, y + dy, z + dz) for x, y, z in self.points], self.faces)

    def turned(self, angle):
        """About the z axis."""
        c, s = cos(angle), sin(angle)
        return Mesh([(c * x - s * y, s * x + c * y, z) for x, y, z in self.points], self.faces)

    def flat_faces(self):
        """Its faces; those that are not flat once written as triangles."""
        points = [tuple(round(c, 4) for c in p) for p in self.points]
        for face in self.faces:
            if is_flat([points[i] for i in face]):
                yield face
            else:
                yield from fan(face)

    def triangles(self):
        return [t for face in self.faces for t in fan(face)]


def fan(face):
    return [(face[0], face[i], face[i + 1]) for i in range(1, len(face) - 1)]


def is_flat(corners):
    normal = [0.0, 0.0, 0.0]
    for p, q in zip(corners, corners[1:] + corners[:1]):
        for k in range(3):
            normal[k] += (p[k - 2] - q[k - 2]) * (p[k - 1] + q[k - 1])
    from_first = [[p[k] - corners[0][k] for k in range(3)] for p in corners]
    off = [abs(sum(n * d for n, d in zip(normal, p))) for p in from_first]
    return max(off) <= PRECISION * dist(normal, (0, 0, 0))


def box(lo, hi):
    (x0, y0, _), (x1, y1, _) = lo, hi
    rings = [[(x, y, z) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))] for z in (lo[2], hi[2])]
    out = loft(rings)
    out.box = lo, hi
    return out


def loft(rings):
    """Through rings of equally many points, anticlockwise as seen from where it goes to; closed at both ends."""
    n = len(rings[0])
    points = [p for ring in rings for p in ring]
    faces = [tuple(reversed(range(n)))]
    for i in range(len(rings) - 1):
        for j in range(n):
            a, b = i * n + j, i * n + (j + 1) % n
            faces.append((a, b, b + n, a + n))
    faces.append(tuple(range(len(points) - n, len(points))))
    return Mesh(points, faces)


def turned(profile, n=12):
    """Turned about the z axis: (radius, z) from below; where it goes down again it is hollow."""
    angles = [2 * pi * j / n for j in range(n)]
    return loft([[(r * cos(a), r * sin(a), z) for a in angles] for r, z in profile])


def ball(r, n=8, rings=3):
    """A ball's poles are cut off flat."""
    angles = [pi * (i + 0.4) / (rings + 0.8) for i in range(rings + 1)]
    return turned([(r * sin(a), -r * cos(a)) for a in angles], n)


def oval(a, b, z, n=16, square=2.0, at=(0.0, 0.0)):
    """A ring in plan between ellipse (2) and rectangle (large): half axes a and b."""
    out = []
    for j in range(n):
        c, s = cos(2 * pi * (j + 0.5) / n), sin(2 * pi * (j + 0.5) / n)
        k = 2 / square
        x, y = abs(c) ** k * (1 if c > 0 else -1), abs(s) ** k * (1 if s > 0 else -1)
        out.append((at[0] + a * x, at[1] + b * y, z))
    return out


def cushion(lo, hi, bulge=0.03, n=8):
    """A box with soft edges."""
    (x0, y0, z0), (x1, y1, z1) = lo, hi
    at, a, b = ((x0 + x1) / 2, (y0 + y1) / 2), (x1 - x0) / 2, (y1 - y0) / 2
    heights = [(z0, bulge), (z0 + bulge, 0), (z1 - bulge, 0), (z1, bulge)]
    return loft([oval(a - d, b - d, z, n, 6.0, at) for z, d in heights])


def tube(path, r, n=6):
    """A rod along a path in space, its ends cut square."""
    rings, u = [], None
    for i, p in enumerate(path):
        before, after = path[max(i - 1, 0)], path[min(i + 1, len(path) - 1)]
        t = unit([after[k] - before[k] for k in range(3)])
        # The first ring begins anywhere, the others where the one before them does: the rod is not twisted.
        u = unit(cross(cross(t, u), t) if u else cross(t, (0, 0, 1) if abs(t[2]) < 0.9 else (0, 1, 0)))
        v = cross(t, u)
        angles = [2 * pi * j / n for j in range(n)]
        rings.append([tuple(p[k] + r * (cos(a) * u[k] + sin(a) * v[k]) for k in range(3)) for a in angles])
    return loft(rings)


def unit(v):
    return [c / dist(v, (0, 0, 0)) for c in v]


def cross(a, b):
    return [a[k - 2] * b[k - 1] - a[k - 1] * b[k - 2] for k in range(3)]
