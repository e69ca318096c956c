"""Sanitary ware, radiators and lamps: free forms as facets. Each about its own origin."""

from .mesh import box, cushion, loft, oval, tube, turned


def toilet():
    """Wall-hung or on its foot, the wall behind at y = 0, the floor at z = 0; bowl, seat and cistern."""
    bowl = [(0.1, 0.12, 0.0, 0.26), (0.11, 0.14, 0.12, 0.26), (0.16, 0.21, 0.3, 0.33), (0.18, 0.25, 0.4, 0.36)]
    inner = [(0.13, 0.19, 0.4, 0.37), (0.11, 0.15, 0.3, 0.36), (0.05, 0.06, 0.2, 0.32)]
    rings = [oval(a, b, z, 12, 2.3, (0, y)) for a, b, z, y in bowl + inner]
    seat_out = [oval(0.185, 0.255, z, 12, 2.3, (0, 0.36)) for z in (0.4, 0.42)]
    seat_in = [oval(0.12, 0.18, z, 12, 2.3, (0, 0.37)) for z in (0.42, 0.4)]
    seat = loft([*seat_out, *seat_in])
    seat.faces = seat.faces[1:-1] + [(j, 36 + j, 36 + (j + 1) % 12, (j + 1) % 12) for j in range(12)]
    cistern = cushion((-0.19, 0.0, 0.42), (0.19, 0.1, 0.8), 0.015, 8)
    return [loft(rings), seat, cistern]


def basin():
    """Wall-hung, the wall behind at y = 0, its rim 0.85 above the floor; with tap and trap."""
    at = (0, 0.23)
    out = [(0.1, 0.08, 0.7), (0.22, 0.17, 0.76), (0.27, 0.215, 0.82), (0.28, 0.225, 0.85)]
    inside = [(0.25, 0.19, 0.85), (0.22, 0.16, 0.8), (0.1, 0.07, 0.74)]
    bowl = loft([oval(a, b, z, 14, 3.0, at) for a, b, z in out + inside])
    tap = tube([(0, 0.03, 0.85), (0, 0.03, 0.98), (0, 0.15, 0.98), (0, 0.15, 0.95)], 0.013, 6)
    trap = tube([(0, 0.23, 0.7), (0, 0.23, 0.55), (0, 0.08, 0.55), (0, 0.0, 0.55)], 0.02, 8)
    return [bowl, tap, trap]


def urinal():
    out = [(0.08, 0.07, 0.45, 0.1), (0.15, 0.13, 0.6, 0.14), (0.17, 0.14, 0.75, 0.14), (0.16, 0.08, 1.0, 0.08)]
    return [loft([oval(a, b, z, 16, 2.5, (0, y)) for a, b, z, y in out])]


def bathtub(length=1.7, width=0.75):
    """Along x, its foot at z = 0, hollow."""
    x, y = length / 2, width / 2
    out = [(x - 0.02, y - 0.02, 0.0), (x, y, 0.05), (x, y, 0.56)]
    inside = [(x - 0.06, y - 0.06, 0.56), (x - 0.12, y - 0.1, 0.3), (x - 0.3, y - 0.18, 0.14)]
    return [loft([oval(a, b, z, 16, 8.0 if i < 4 else 3.5) for i, (a, b, z) in enumerate(out + inside)])]


def shower():
    """A tray and a rod with its head."""
    tray = [oval(a, a, z, 12, 12.0) for a, z in ((0.45, 0.0), (0.45, 0.06), (0.42, 0.06), (0.4, 0.03))]
    rod = tube([(0, -0.42, 1.0), (0, -0.42, 2.1), (0, -0.1, 2.15)], 0.012, 6)
    head = turned([(0.02, 2.13), (0.1, 2.1), (0.1, 2.09)][::-1], 12).moved(0, -0.1)
    return [loft(tray), rod, head]


def radiator(width=1.0, height=0.6):
    """Columns between two headers; the wall 0.05 behind y = 0, the floor 0.12 below."""
    n = round(width / 0.06)
    parts = []
    for i in range(n):
        x = -width / 2 + width * (i + 0.5) / n
        rings = [oval(0.02, 0.045, z, 6, 3.0, (x, 0.05)) for z in (0.17, height + 0.07)]
        parts.append(loft(rings))
    for z in (0.14, height + 0.09):
        parts.append(tube([(-width / 2, 0.05, z), (width / 2, 0.05, z)], 0.03, 8))
    return parts


def pendant(drop=0.8):
    """Hangs from z = 0: canopy, cord and a hollow shade."""
    shade = [(0.2, -drop - 0.18), (0.19, -drop - 0.1), (0.1, -drop), (0.03, -drop + 0.04)]
    inside = [(0.02, -drop + 0.03), (0.09, -drop - 0.01), (0.18, -drop - 0.1), (0.19, -drop - 0.18)]
    n = 10
    body = turned([*shade, *inside], n)
    last = len(body.points) - n
    body.faces = body.faces[1:-1] + [(j, last + j, last + (j + 1) % n, (j + 1) % n) for j in range(n)]
    cord = turned([(0.004, -drop + 0.03), (0.004, -0.02), (0.05, -0.02), (0.05, 0.0)], 8)
    return [body, cord]


def luminaire(length=1.2):
    """Under a ceiling at z = 0: housing and diffuser."""
    x = length / 2
    return [box((-x, -0.09, -0.05), (x, 0.09, 0)), box((-x + 0.02, -0.07, -0.06), (x - 0.02, 0.07, -0.05))]


def extinguisher():
    """Hangs at a wall at y = 0."""
    bottle = turned([(0.06, 0.9), (0.07, 0.92), (0.07, 1.3), (0.03, 1.36), (0.02, 1.36), (0.02, 1.42)], 12)
    return [bottle.moved(0, 0.08), box((-0.03, 0, 1.1), (0.03, 0.012, 1.2))]
