"""A house of two storeys, the upper one under a raftered roof; IFC2X3 in millimetres, its names German.

Walls and floors here; house_plan.py has its measures, house_roof.py the roof, house_rooms.py what stands in the rooms.
"""

from .body import Modeller, corners
from .house_plan import (
    CHIMNEY,
    CLEAR,
    EAVES,
    FACE,
    FLOOR,
    IN,
    LENGTH,
    MIDDLE,
    SCREED,
    SLAB,
    SLOPE,
    STAIRS,
    UNDER_RAFTERS,
    UNDER_SLAB,
    UPPER,
    WIDTH,
)
from .house_roof import roof
from .house_rooms import fit_out
from .layers import Hole, Layer, wall
from .openings import door, fixed_light, window
from .services import flight, railing, sloped_railing

RENDER = Layer("Außenputz", 0.015, "IFCCOVERING", "Putz", "Plaster", "CLADDING", -SLAB)
WOOL = Layer("Dämmung", 0.16, "IFCCOVERING", "Glaswolle", "Insulation", "INSULATION", -SLAB)
BRICK = Layer("Kalksandstein", 0.175, "IFCWALL", "Kalksandstein", "Concrete")
PLASTER = Layer("Innenputz", IN, "IFCCOVERING", "Gipsputz", "Plaster", "CLADDING")
INNER = Layer("Mauerwerk", 0.115, "IFCWALL", "Kalksandstein", "Concrete")
OUTER = [RENDER, WOOL, BRICK, PLASTER]
BETWEEN = [PLASTER._replace(name="Putz rechts"), INNER, PLASTER._replace(name="Putz links")]
BOARD = Layer("Platte", 0.0125, "IFCCOVERING", "Gipskarton", "Plaster", "CLADDING")
STUDS = Layer("Ständer", 0.075, "IFCWALL", "Holz", "Timber")
LIGHT = [BOARD._replace(name="Platte rechts"), STUDS, BOARD._replace(name="Platte links")]


def house():
    storeys = [("Erdgeschoss", 0), ("Dachgeschoss", UPPER)]
    m = Modeller("asbuilt house", "Haus", storeys, space="house ", schema="IFC2X3", millimetres=True)
    whole = {"style": "Concrete", "material": "Stahlbeton"}
    out = corners(-BRICK.thickness, -BRICK.thickness, LENGTH + BRICK.thickness, WIDTH + BRICK.thickness)
    m.plate("IFCSLAB", "Bodenplatte", out, -0.25, 0, tail="$,.BASESLAB.", **whole)
    ground_walls(m)
    inner_walls(m)
    ground_floors(m)
    m.plate("IFCSLAB", "Decke", out, CLEAR, UPPER, [CHIMNEY, STAIRS], tail="$,.FLOOR.", **whole)
    stairs(m)
    fit_out(m, 0)
    m.begin(1)
    knee_walls(m)
    gables(m)
    upper_floors(m)
    upper_wall(m)
    roof(m)
    fit_out(m, 1)
    m.finish()
    return m


def side(m, name, a, b, holes, is_long, height=CLEAR, layers=OUTER, clips=(), start=-FACE):
    """One side of the outer wall; long sides run around the corners."""

    def reach(outer, inner):
        return (-outer, -outer) if is_long else (-inner, -inner)

    w = wall(m, name, a, b, 0, height, layers, start, holes, reach, BRICK.name, clips)
    if BRICK in layers:
        m.property(w.product, name, "Pset_WallCommon", "IsExternal", "IFCBOOLEAN(.T.)")
    return w


def ground_walls(m):
    south = [Hole(1.0, 1.0, 1.5, 1.35), Hole(3.9, FLOOR, 1.8, 2.2), Hole(7.0, 1.0, 1.5, 1.35)]
    w = side(m, "Wand Süd", (0, 0), (LENGTH, 0), south, True)
    for i in (0, 2):
        window(m, f"Fenster Süd {i + 1}", w, i, south[i], -0.1, 2, "Holz")
    door(m, "Terrassentür", w, 1, south[1], -0.1, "Frame", (0.15, 0.15, 1.65, 2.05))
    # The render closes the window of the bath: a mistake of the drawing, as models have them.
    east = [Hole(1.2, 1.0, 1.2, 1.35), Hole(5.2, 1.3, 0.9, 0.9, (RENDER.name,))]
    w = side(m, "Wand Ost", (LENGTH, 0), (LENGTH, WIDTH), east, False)
    window(m, "Fenster Ost", w, 0, east[0], -0.1, 1, "Holz")
    window(m, "Fenster Bad", w, 1, east[1], -0.1, 1, "Holz")
    north = [Hole(0.8, 1.6, 0.9, 0.7), Hole(3.35, FLOOR, 1.1, 2.2), Hole(8.9, 1.2, 0.5, 1.1)]
    w = side(m, "Wand Nord", (LENGTH, WIDTH), (0, WIDTH), north, True)
    window(m, "Fenster Nord", w, 0, north[0], -0.1, 1, "Holz")
    door(m, "Haustür", w, 1, north[1], -0.1, "Timber", (0.3, 1.4, 0.8, 1.9))
    fixed_light(m, "Lichtband Treppe", w, 2, north[2], -0.1, "Glas")
    west = [Hole(1.6, 1.1, 1.2, 1.2), Hole(5.0, 1.0, 1.2, 1.35)]
    w = side(m, "Wand West", (0, WIDTH), (0, 0), west, False)
    for i, hole in enumerate(west):
        window(m, f"Fenster West {i + 1}", w, i, hole, -0.1, 1, "Holz")


def inner_walls(m):
    holes = [Hole(0.8, FLOOR, 1.01, 2.135), Hole(5.2, FLOOR, 1.01, 2.135)]
    w = wall(m, "Mittelwand", (IN, MIDDLE[0]), (LENGTH - IN, MIDDLE[0]), 0, CLEAR, BETWEEN, 0.0, holes)
    door(m, "Tür Wohnen 1", w, 0, holes[0], 0.0725, "Timber", (0.25, 0.3, 0.76, 1.9))
    door(m, "Tür Wohnen 2", w, 1, holes[1], 0.0725)
    holes = [Hole(1.2, FLOOR, 0.885, 2.135)]
    w = wall(m, "Badwand", (7.0, MIDDLE[1]), (7.0, WIDTH - IN), 0, CLEAR, BETWEEN, -0.0725, holes)
    door(m, "Tür Bad", w, 0, holes[0], 0.0)
    tiles = {"style": "Ceramic", "material": "Fliesen", "tail": "$,.CLADDING."}
    lo, hi = (7.0725, WIDTH - IN - 0.012, FLOOR), (7.9, WIDTH - IN, 2.1)
    m.box("IFCCOVERING", "Fliesen Bad Nord", lo, hi, **tiles)
    lo, hi = (LENGTH - IN - 0.012, MIDDLE[1], FLOOR), (LENGTH - IN, 5.2, 2.1)
    m.box("IFCCOVERING", "Fliesen Bad Ost", lo, hi, **tiles)


def floor(m, room, outline, holes=()):
    screed = {"style": "Concrete", "material": "Estrich", "tail": "$,.FLOORING."}
    m.plate("IFCCOVERING", f"Estrich {room}", outline, 0, SCREED, holes, **screed)
    top = {"style": "Ceramic", "material": "Fliesen"} if room == "Bad" else {"style": "Timber", "material": "Parkett"}
    m.plate("IFCCOVERING", f"Belag {room}", outline, SCREED, FLOOR, holes, tail="$,.FLOORING.", **top)


def ground_floors(m):
    floor(m, "Wohnen", corners(IN, IN, LENGTH - IN, MIDDLE[0]))
    floor(m, "Küche", corners(IN, MIDDLE[1], 6.9275, WIDTH - IN), [CHIMNEY])
    floor(m, "Bad", corners(7.0725, MIDDLE[1], LENGTH - IN, WIDTH - IN))


def upper_floors(m):
    x0, y0, x1, _ = STAIRS
    far = WIDTH - IN
    around = [(IN, IN), (4.95, IN), (4.95, far), (x1, far), (x1, y0), (x0, y0), (x0, far), (IN, far)]
    floor(m, "Flur", around)
    floor(m, "Schlafen", corners(5.05, IN, LENGTH - IN, far), [CHIMNEY])


def stairs(m):
    """Sixteen steps of timber along the north wall, and railings above."""
    x0, y0, x1, y1 = STAIRS
    steps, tread = 16, (x1 - x0) / 15
    whole = m.product("IFCSTAIR", "Treppe", m.place((0, 0, 0)), "$")

    def foot():
        return m.place((x1, y0, FLOOR), (0, 1))

    flight(m, "Treppenlauf", foot(), y1 - y0, steps, UPPER / steps, tread, whole, ("Timber", "Holz"))
    sloped_railing(m, "Treppengeländer", foot(), 0.05, steps, UPPER / steps, tread, whole)
    m.begin(1)
    railing(m, "Geländer 1", m.place((x0, y0 - 0.04, FLOOR)), x1 - x0 + 0.05)
    railing(m, "Geländer 2", m.place((x1 + 0.05, y0 + 0.03, FLOOR), (0, 1)), y1 - y0 - 0.06)
    m.begin(0)


def knee_walls(m):
    """Under the eaves; their outer layers end at the rafters."""
    lines = [("Süd", (0, 0), (LENGTH, 0)), ("Nord", (LENGTH, WIDTH), (0, WIDTH))]
    for name, a, b in lines:
        side(m, f"Drempel {name}", a, b, [], True, EAVES, OUTER[2:], start=-BRICK.thickness)
        side(m, f"Drempel {name}", a, b, [], True, 1.3, OUTER[:2], [((0, 0, UNDER_RAFTERS), (0, -0.6, 0.8))])


def gables(m):
    """Clipped by the roof: to the south between the rafters by the slab on them, to the north by the thicker slab."""
    south, north = UNDER_SLAB, UNDER_RAFTERS
    holes = [Hole(3.0, 1.0, 1.2, 1.3)]
    clips = [((0, 0, north), (-0.6, 0, 0.8)), ((WIDTH, 0, south), (0.6, 0, 0.8))]
    w = side(m, "Giebel West", (0, WIDTH), (0, 0), holes, False, 5.0, OUTER, clips)
    window(m, "Fenster Giebel West", w, 0, holes[0], -0.1, 2, "Holz")
    clips = [((0, 0, south), (-0.6, 0, 0.8)), ((WIDTH, 0, north), (0.6, 0, 0.8))]
    w = side(m, "Giebel Ost", (LENGTH, 0), (LENGTH, WIDTH), holes, False, 5.0, OUTER, clips)
    window(m, "Fenster Giebel Ost", w, 0, holes[0], -0.1, 2, "Holz")


def upper_wall(m):
    """A light partition below the purlins."""
    y0 = IN
    clips = [((0, 0, UNDER_RAFTERS + SLOPE * y0), (-0.6, 0, 0.8))]
    clips.append(((WIDTH - y0, 0, UNDER_RAFTERS), (0.6, 0, 0.8)))
    holes = [Hole(3.0, FLOOR, 0.885, 2.0)]
    w = wall(m, "Trennwand", (5.0, y0), (5.0, WIDTH - IN), 0, 2.25, LIGHT, -0.05, holes, clips=clips)
    door(m, "Tür Schlafen", w, 0, holes[0], 0.0)


def stations():
    """Where one would scan it from: every room, the stairs' head, and around it."""
    inside = [(2.4, 2.6), (7.4, 3.3), (2.6, 5.2), (5.4, 5.6), (8.2, 5.6)]
    upper = [(2.2, 3.2), (3.9, 1.6), (6.6, 3.6), (8.6, 3.0)]
    out = [(x, y, FLOOR + 1.55) for x, y in inside] + [(x, y, UPPER + FLOOR + 1.55) for x, y in upper]
    return out + [(x, y, 1.6) for x in (-4.0, LENGTH / 2, LENGTH + 4.0) for y in (-8.0, WIDTH + 8.0)]
