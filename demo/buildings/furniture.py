"""Furniture of many small faces, each about its own origin on the floor, facing +y."""

from math import cos, pi, sin

from .mesh import ball, box, cushion, loft, oval, tube, turned


def swivel_chair():
    parts = []
    for k in range(5):
        a = 2 * pi * k / 5 + 0.3
        c, s = cos(a), sin(a)
        parts.append(tube([(0.03 * c, 0.03 * s, 0.085), (0.28 * c, 0.28 * s, 0.065)], 0.014, 5))
        parts.append(ball(0.025, 6, 2).moved(0.28 * c, 0.28 * s, 0.025))
    parts.append(turned([(0.028, 0.06), (0.028, 0.12), (0.018, 0.12), (0.018, 0.43)], 8))
    seat = [(0.16, 0.43), (0.23, 0.44), (0.245, 0.47), (0.235, 0.495), (0.19, 0.505)]
    parts.append(loft([oval(a, a, z, 16, 3.5) for a, z in seat]))
    parts.append(tube([(0, -0.2, 0.44), (0, -0.31, 0.5), (0, -0.3, 0.62)], 0.018, 6))
    parts.append(back_rest())
    for side in (-1, 1):
        x = side * 0.27
        parts.append(tube([(side * 0.235, 0, 0.46), (x, 0, 0.5), (x, 0, 0.66)], 0.014, 6))
        parts.append(box((x - 0.035, -0.13, 0.66), (x + 0.035, 0.13, 0.685)))
    return parts


def back_rest():
    """Curved in plan and in height."""
    heights = [(0.62, 0.17, 0), (0.68, 0.21, 0.01), (0.8, 0.22, 0.0), (0.95, 0.21, -0.03), (1.02, 0.16, -0.05)]
    rings = []
    for z, half, lean in heights:
        flat = oval(half, 0.018, z, 12, 4.0)
        rings.append([(x, y - 0.27 + lean + 1.2 * x * x, z) for x, y, z in flat])
    return loft(rings)


def visitor_chair():
    """A shell on four thin legs."""
    parts = []
    for sx in (-1, 1):
        for sy in (-1, 1):
            parts.append(tube([(sx * 0.24, sy * 0.24, 0), (sx * 0.17, sy * 0.17, 0.43)], 0.01, 6))
    seat = [(0.17, 0.43), (0.22, 0.435), (0.225, 0.45), (0.18, 0.455)]
    parts.append(loft([oval(a, a, z, 12, 4.0) for a, z in seat]))
    rings = []
    for z, half, lean in ((0.46, 0.19, 0.0), (0.6, 0.21, -0.02), (0.78, 0.2, -0.05), (0.84, 0.15, -0.06)):
        rings.append([(x, y - 0.2 + lean + 1.0 * x * x, z) for x, y, z in oval(half, 0.008, z, 10, 4.0)])
    return [*parts, loft(rings)]


def desk(width=1.6, depth=0.8):
    """Top, two frames of square tube, a modesty panel, a cable tray."""
    x, y = width / 2, depth / 2
    parts = [box((-x, -y, 0.715), (x, y, 0.74))]
    for side in (-1, 1):
        a, b = sorted((side * (x - 0.05), side * (x - 0.1)))
        parts.append(box((a, -y + 0.05, 0), (b, y - 0.05, 0.03)))
        parts.append(box((a, -0.04, 0.03), (b, 0.04, 0.685)))
        parts.append(box((a, -y + 0.05, 0.685), (b, y - 0.05, 0.715)))
    parts.append(box((-x + 0.1, 0.012, 0.35), (x - 0.1, 0.03, 0.685)))
    parts.append(box((-0.5, 0.1, 0.6), (0.5, 0.25, 0.61)))
    return parts


def table(length=2.4, width=1.1):
    """A meeting table on two turned legs."""
    foot = [(0.3, 0), (0.3, 0.015), (0.06, 0.04), (0.05, 0.06), (0.05, 0.68), (0.16, 0.7), (0.16, 0.715)]
    legs = [turned(foot, 10).moved(side * length / 4) for side in (-1, 1)]
    top = loft([oval(length / 2 - d, width / 2 - d, z, 16, 5.0) for z, d in ((0.715, 0.02), (0.725, 0), (0.74, 0))])
    return [*legs, top]


def plain_table(length=1.8, width=0.9):
    """On four square legs."""
    x, y = length / 2, width / 2
    parts = [box((-x, -y, 0.71), (x, y, 0.74))]
    for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1)):
        u, v = sx * (x - 0.08), sy * (y - 0.08)
        parts.append(box((u - 0.035, v - 0.035, 0), (u + 0.035, v + 0.035, 0.71)))
    return parts


def cabinet(width=1.2, depth=0.45, height=1.98, doors=2, shelves=1):
    """A body on a plinth with doors of 18 mm that stand 3 mm apart, and handles."""
    x, y, pitch, rise = width / 2, depth / 2, width / doors, (height - 0.08) / shelves
    parts = [box((-x + 0.02, -y, 0), (x - 0.02, y - 0.04, 0.08)), box((-x, -y, 0.08), (x, y - 0.018, height))]
    for i in range(doors):
        for k in range(shelves):
            left, foot = -x + i * pitch, 0.08 + k * rise
            lo = (left + 0.0015, y - 0.018, foot + 0.0015)
            parts.append(box(lo, (left + pitch - 0.0015, y, foot + rise - 0.0015)))
            grip = left + (pitch - 0.06 if i % 2 == 0 else 0.045)
            middle = foot + rise / 2
            parts.append(box((grip, y, middle - 0.08), (grip + 0.015, y + 0.022, middle + 0.08)))
    return parts


def sofa(seats=2):
    width = 0.7 * seats + 0.4
    x = width / 2
    parts = [box((-x + 0.05, -0.4, 0.1), (x - 0.05, 0.4, 0.25))]
    parts += [cushion((side * (x - 0.1) - 0.1, -0.45, 0.1), (side * (x - 0.1) + 0.1, 0.42, 0.62)) for side in (-1, 1)]
    parts.append(cushion((-x + 0.2, -0.45, 0.25), (x - 0.2, -0.22, 0.82), 0.04))
    for i in range(seats):
        left = -x + 0.2 + 0.7 * i
        parts.append(cushion((left + 0.005, -0.22, 0.25), (left + 0.695, 0.43, 0.44), 0.03))
    feet = [turned([(0.02, 0), (0.03, 0.1)], 8) for _ in range(4)]
    for foot, (sx, sy) in zip(feet, ((-1, -1), (1, -1), (-1, 1), (1, 1))):
        parts.append(foot.moved(sx * (x - 0.2), sy * 0.3))
    return parts


def bed(width=1.8, length=2.0):
    x = width / 2
    feet = [(side * x, y) for side in (-0.9, 0.9) for y in (0.1, length - 0.1)]
    legs = [box((u - 0.04, v, 0), (u + 0.04, v + 0.08, 0.2)) for u, v in feet]
    frame = [box((-x, 0, 0.2), (x, length + 0.05, 0.32)), box((-x, -0.06, 0.0), (x, 0, 1.0))]
    mattress = cushion((-x + 0.03, 0.02, 0.32), (x - 0.03, length + 0.02, 0.52), 0.04)
    pillows = [cushion((sx * 0.45 - 0.35, 0.05, 0.52), (sx * 0.45 + 0.35, 0.5, 0.64), 0.05) for sx in (-1, 1)]
    return [*legs, *frame, mattress, *pillows]


def counter(width=3.0):
    """Kitchen base units, worktop and tap."""
    n = round(width / 0.6)
    parts = cabinet(width, 0.6, 0.86, n, 1)
    parts.append(box((-width / 2, -0.3, 0.86), (width / 2, 0.32, 0.9)))
    parts.append(tube([(0.3, -0.22, 0.9), (0.3, -0.22, 1.15), (0.3, -0.02, 1.15), (0.3, -0.02, 1.1)], 0.012, 6))
    return parts


def plant():
    """A pot with leaves."""
    parts = [turned([(0.14, 0), (0.18, 0.35), (0.16, 0.35), (0.15, 0.3)], 10)]
    for k in range(9):
        a, high = 2.4 * k, 0.75 + 0.05 * k
        x, y = 0.25 * cos(a), 0.25 * sin(a)
        outline = [(-0.02, -0.004), (0.02, -0.004), (0.02, 0.004), (-0.02, 0.004)]
        stem, tip = [(0.05 * cos(a) + u, 0.05 * sin(a) + v, 0.3) for u, v in outline], []
        tip = [(x + 0.3 * u, y + v, high) for u, v in outline]
        broad = [(0.6 * x + 3 * u, 0.6 * y + v, 0.3 + 0.6 * (high - 0.3)) for u, v in outline]
        parts.append(loft([stem, broad, tip]))
    return parts
