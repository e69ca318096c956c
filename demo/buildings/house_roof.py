"""The house's roof of 3 in 4. South: the slab lies on the rafters, whose upper faces lie in its underside. North: the
rafters are drawn inside a thicker slab, their lower faces in its underside. In both slopes' frames x runs along the
eaves, y up the slope, z out of the roof; the origin is above the wall's inner face, in the plane below the rafters.
"""

from .body import corners
from .house_plan import (
    CHIMNEY,
    FACE,
    IN,
    LENGTH,
    OVERHANG,
    RAFTER,
    RIDGE,
    SKIN,
    SLOPE,
    TILES,
    UNDER_RAFTERS,
    UNDER_SLAB,
    UPPER,
    VERGE,
    WIDTH,
)
from .openings import casement
from .services import pipe

TIMBER = {"style": "Timber", "material": "Holz"}


class Slope:
    def __init__(self, m, name, origin, turned):
        self.m, self.name, self.turned = m, name, turned
        z, x = ((0, 0.6, 0.8), (-1, 0, 0)) if turned else ((0, -0.6, 0.8), (1, 0, 0))
        self.frame = origin, z, x

    def place(self):
        return self.m.tilted(*self.frame)

    def sheet(self, x0, x1, z0, z1, style, foot=-OVERHANG):
        """From x0 to x1, between two planes, from its square foot to the upright joint at the ridge."""
        outline = [(foot, z0), (top(z0), z0), (top(z1), z1), (foot, z1)]
        return self.m.extruded(self.m.polygon(outline), x1 - x0, (x0, 0, 0), (1, 0, 0), (0, 1, 0), style)

    def hole(self, host, name, x0, y0, x1, y1):
        """At right angles to the slope."""
        m = self.m
        body = m.extruded(m.polygon(corners(x0, y0, x1, y1)), 0.6, (0, 0, 0.05))
        return m.opening(name, self.place(), m.shape(body), host)


def top(z):
    """How far up the slope the ridge is, at z."""
    return (RIDGE + 0.6 * z) / 0.8


def roof(m):
    whole = m.product("IFCROOF", "Dach", m.place((0, 0, 0)), "$")
    south = Slope(m, "Süd", (0, 0, UNDER_RAFTERS), False)
    north = Slope(m, "Nord", (LENGTH, WIDTH, UNDER_RAFTERS), True)
    for slope, under in ((south, RAFTER), (north, 0.0)):
        skin(slope, under, whole)
        for i in range(12):
            x = 0.4 + 0.8 * i
            n = 12 - i if slope.turned else i + 1
            body = slope.sheet(x - 0.04, x + 0.04, 0, RAFTER, "Timber")
            m.piece("IFCBEAM", f"Sparren {slope.name} {n}", slope.place(), body, material="Holz")
    purlins(m)
    for i in (1, 4, 7, 10):
        collar(m, i + 1, 0.4 + 0.8 * i + 0.04)
    body = m.box_item((*CHIMNEY[:2], -UPPER), (*CHIMNEY[2:], 5.2), "Brick")
    m.piece("IFCBUILDINGELEMENTPROXY", "Schornstein", m.place((0, 0, 0)), body, material="Ziegel")
    gutters(m)


def skin(slope, under, whole):
    """Slab and tiles, with holes for the chimney and for skylights."""
    m, windows = slope.m, []
    body, place = slope.sheet(-VERGE, LENGTH + VERGE, under, SKIN, "Timber"), slope.place()
    more = {"whole": whole, "tail": "$,.ROOF.", "material": "Dachaufbau"}
    slab = m.piece("IFCSLAB", f"Dachfläche {slope.name}", place, body, **more)
    body = slope.sheet(-VERGE, LENGTH + VERGE, SKIN, SKIN + TILES, "Brick")
    more = {"tail": "$,.ROOFING.", "material": "Ziegel"}
    tiles = m.piece("IFCCOVERING", f"Dachziegel {slope.name}", slope.place(), body, **more)
    for host, layer in ((slab, "Dachfläche"), (tiles, "Dachziegel")):
        if slope.turned:
            x0, y0, x1, y1 = CHIMNEY
            shaft = m.shape(m.box_item((x0, y0, 0.0), (x1, y1, 6.0)))
            m.opening(f"{layer} Schornstein", m.place((0, 0, 0)), shaft, host)
        else:
            for i, x in enumerate(SKYLIGHTS):
                windows.append(slope.hole(host, f"{layer} Öffnung {i + 1}", x, 1.6, x + 0.66, 2.8))
    for i, hole in enumerate(windows[: len(SKYLIGHTS)]):
        skylight(m, place, i + 1, SKYLIGHTS[i], hole)


SKYLIGHTS = (2.07, 5.27)


def skylight(m, slab, n, x, hole):
    """Frame, sash and pane in the plane of the slope."""
    # A casement's height runs up the slope.
    place = m.tilted((x, 1.6, SKIN - 0.05), (0, 1, 0), (1, 0, 0), slab)
    e = m.piece("IFCWINDOW", f"Dachfenster {n}", place, *casement(m, 0.66, 1.2, 1), material="Holz")
    m.related("IFCRELFILLSELEMENT", f"Dachfenster {n} fills", hole, e)


def purlins(m):
    """Ridge, middle and eaves purlins, each touching the rafters with its edges."""
    inside = (IN, LENGTH - IN)

    def purlin(name, y0, y1, high, touching):
        z = UNDER_RAFTERS + SLOPE * touching
        m.box("IFCBEAM", name, (inside[0], y0, z - high), (inside[1], y1, z), **TIMBER)

    purlin("Firstpfette", WIDTH / 2 - 0.07, WIDTH / 2 + 0.07, 0.24, WIDTH / 2 - 0.07)
    purlin("Mittelpfette Süd", 1.74, 1.86, 0.2, 1.74)
    purlin("Mittelpfette Nord", WIDTH - 1.86, WIDTH - 1.74, 0.2, 1.74)
    purlin("Fußpfette Süd", -0.12, 0.0, 0.12, -0.12)
    purlin("Fußpfette Nord", WIDTH, WIDTH + 0.12, 0.12, -0.12)


def collar(m, n, x):
    """A plank beside a pair of rafters, on the middle purlins, cut by both undersides of the roof."""
    z = UNDER_RAFTERS + SLOPE * 1.74
    body = m.box_item((x, 1.0, z), (x + 0.04, WIDTH - 1.0, z + 0.16))
    body = m.clipped(body, (0, 0, UNDER_SLAB), (0, -0.6, 0.8))
    body = m.styled(m.clipped(body, (0, WIDTH, UNDER_RAFTERS), (0, 0.6, 0.8)), "Timber")
    m.piece("IFCBEAM", f"Kehlbalken {n}", m.place((0, 0, 0)), body, material="Holz")


def gutters(m):
    """Gutters under the eaves and a bent downpipe each."""
    foot = -OVERHANG * 0.8 - 0.12
    z = UNDER_RAFTERS - OVERHANG * 0.6 - 0.05
    u = [(-0.06, 0), (0.06, 0), (0.06, 0.1), (0.055, 0.1), (0.055, 0.005), (-0.055, 0.005), (-0.055, 0.1), (-0.06, 0.1)]
    for name, y, side in (("Süd", foot, -1), ("Nord", WIDTH - foot, 1)):
        body = m.extruded(m.polygon(u), LENGTH + 1.4, (-0.7, y, z), (1, 0, 0), (0, 1, 0), "Steel")
        m.piece("IFCFLOWSEGMENT", f"Dachrinne {name}", m.place((0, 0, 0)), body, material="Zink")
        wall = (WIDTH if side > 0 else 0.0) + side * (FACE + 0.07)
        path = [(-0.25, y, z), (-0.25, y, z - 0.15), (-0.25, wall, z - 0.5), (-0.25, wall, -UPPER - 0.15)]
        pipe(m, f"Fallrohr {name}", path, 0.04, "IFCFLOWSEGMENT")
