"""What stands in the office's rooms: floors, ceilings, furniture, sanitary ware, lamps, stairs, ducts and pipes."""

from math import cos, radians, sin

from . import furniture, sanitary
from .body import corners
from .layers import TILES
from .office_plan import BAY, CEILING, CLEAR, FLOOR, IN, NORTH, SOUTH, WIDTH
from .openings import door_items
from .services import cable_tray, duct, flight, pipe, railing, round_duct, sloped_railing

CLASSES = {
    "furniture": ("IFCFURNITURE", "Textile", "Composite"),
    "wood": ("IFCFURNITURE", "Timber", "Chipboard"),
    "sanitary": ("IFCSANITARYTERMINAL", "Ceramic", "Ceramic"),
    "heater": ("IFCSPACEHEATER", "Plaster", "Steel"),
    "lamp": ("IFCLIGHTFIXTURE", "Lamp shade", "Polycarbonate"),
    "safety": ("IFCBUILDINGELEMENTPROXY", "Brick", "Steel"),
}


def put(f, kind, name, maker, x, y, z=FLOOR, turn=0):
    """A piece of furniture or equipment; `turn` in degrees from facing north, anticlockwise."""
    ifc_class, style, material = CLASSES[kind]
    a = radians(turn)
    place = f.m.place((x, y, z), (round(cos(a), 6), round(sin(a), 6)))
    shape = f.m.repeated(maker, style, brep=maker in (sanitary.toilet, sanitary.urinal))
    f.m.product(ifc_class, f.name(name), place, shape, material=material)


def fit_out(f):
    corridor(f)
    for k in range(f.bays):
        x = k * BAY
        left, right = x + (IN if k == 0 else 0.05), x + BAY - (IN if k == f.bays - 1 else 0.05)
        south = meeting_room if k % 4 == 1 else office_room
        if k % 4 in (2, 3):
            # A glass partition is thinner than a wall of studs.
            left, right = (x + 0.04, right) if k % 4 == 3 else (left, right if k == f.bays - 1 else x + BAY - 0.04)
        south(f, k, (left, IN, right, SOUTH[0]))
        left, right = x + (IN if k == 0 else 0.05), x + BAY - (IN if k == f.bays - 1 else 0.05)
        if k % 4 == 0:
            stairs(f, k, (left, NORTH[1], x + 2.95, WIDTH - IN))
            toilets(f, k, (x + 3.05, NORTH[1], right, WIDTH - IN))
        elif k % 4 == 1:
            lounge(f, k, (left, NORTH[1], right, WIDTH - IN))
    for k, last in f.open_plans():
        right = (last + 1) * BAY - (IN if last == f.bays - 1 else 0.05)
        open_plan(f, k, last, (k * BAY + 0.05, NORTH[1], right, WIDTH))


def room(f, name, r, has_ceiling=True, floor=None):
    """Raised floor, suspended ceiling and space of a room: x0, y0, x1, y1; `floor` is another outline of the floor."""
    m, half = f.m, 0.175
    inside = [(x, y) for x, y, _ in f.columns() if r[0] < x < r[2] and r[1] < y < r[3]]
    holes = [(x - half, y - half, x + half, y + half) for x, y in inside]
    boards = {"material": "Calcium sulphate", "style": "Timber", "tail": "$,.FLOORING."}
    outline = floor or corners(*r)
    m.plate("IFCCOVERING", f.name("raised floor", name), outline, FLOOR - 0.038, FLOOR, holes, **boards)
    if has_ceiling:
        tiles = {"material": "Mineral fibre", "style": "Plaster", "tail": "$,.CEILING."}
        m.plate("IFCCOVERING", f.name("ceiling", name), corners(*r), CEILING - 0.02, CEILING, holes, **tiles)
    body = m.extruded(m.polygon(corners(*r)), CEILING - FLOOR, (0, 0, FLOOR))
    where = m.place((0, 0, 0))
    seed, shape = f.name("space", name), m.shape(body)
    space = m.add(f"IFCSPACE('{m.guid(seed)}',$,'{seed}',$,$,{where},{shape},'{name}',.ELEMENT.,.SPACE.,$)")
    m.wholes.setdefault(m.storey, []).append(space)


def office_room(f, k, r):
    name, x = f"office {k + 1}", k * BAY
    room(f, name, r)
    desk_pair(f, name, x + 3.2, 2.4)
    for i, y in enumerate((1.9, 3.2)):
        put(f, "wood", f"cabinet {name} {i + 1}", furniture.cabinet, r[0] + 0.226, y, turn=-90)
    for i, y in enumerate((1.5, 3.9)):
        put(f, "lamp", f"luminaire {name} {i + 1}", sanitary.luminaire, x + 3, y, CEILING - 0.02)
    for i, along in enumerate((1.7, 4.3)):
        put(f, "heater", f"radiator {name} {i + 1}", sanitary.radiator, x + along, IN + 0.05)
    put(f, "furniture", f"plant {name}", furniture.plant, x + 5.5, 0.6)


def desk_pair(f, name, x, y):
    """Two desks face to face, their chairs turned a little."""
    for i, (side, turn, askew) in enumerate(((-1, 0, 12), (1, 180, -20))):
        put(f, "wood", f"desk {name} {i + 1}", furniture.desk, x, y + side * 0.4, turn=turn)
        put(f, "furniture", f"chair {name} {i + 1}", furniture.swivel_chair, x, y + side * 1.15, turn=turn + askew)


def meeting_room(f, k, r):
    name, x = f"meeting room {k + 1}", k * BAY
    room(f, name, r)
    put(f, "wood", f"table {name}", furniture.table, x + 3, 2.6)
    for i in range(3):
        for side, turn in ((-1, 0), (1, 180)):
            where = (x + 2.2 + 0.8 * i, 2.6 + side * 0.75)
            put(f, "furniture", f"chair {name} {2 * i + (side + 3) // 2}", furniture.visitor_chair, *where, turn=turn)
    for i, along in enumerate((2.4, 3.6)):
        put(f, "lamp", f"pendant {name} {i + 1}", sanitary.pendant, x + along, 2.6, CEILING - 0.02)
    for i, along in enumerate((1.7, 4.3)):
        put(f, "heater", f"radiator {name} {i + 1}", sanitary.radiator, x + along, IN + 0.05)
    lo, hi = (r[2] - 0.025, 1.6, 1.0), (r[2], 3.6, 2.1)
    f.m.box("IFCFURNITURE", f.name("board", name), lo, hi, "Ceramic", material="Enamelled steel")


def lounge(f, k, r):
    name, x = f"lounge {k + 1}", k * BAY
    room(f, name, r)
    put(f, "furniture", f"sofa {name} 1", furniture.sofa, x + 4.6, 13.4, turn=180)
    put(f, "furniture", f"sofa {name} 2", furniture.sofa, r[2] - 0.5, 11.6, turn=90)
    put(f, "wood", f"counter {name}", furniture.counter, r[0] + 0.325, 10.0, turn=-90)
    put(f, "wood", f"tall cabinet {name}", tall_cabinet, r[0] + 0.325, 11.9, turn=-90)
    put(f, "wood", f"table {name}", furniture.table, x + 3.2, 9.3)
    for i, (dx, dy, turn) in enumerate(((-0.6, -0.75, 8), (0.6, -0.75, 0), (-0.6, 0.75, 180), (0.6, 0.75, 165))):
        where = (x + 3.2 + dx, 9.3 + dy)
        put(f, "furniture", f"chair {name} {i + 1}", furniture.visitor_chair, *where, turn=turn)
    put(f, "lamp", f"pendant {name}", sanitary.pendant, x + 3.2, 9.3, CEILING - 0.02)
    put(f, "lamp", f"luminaire {name}", sanitary.luminaire, x + 3.0, 12.6, CEILING - 0.02)
    for i, along in enumerate((1.7, 4.3)):
        put(f, "heater", f"radiator {name} {i + 1}", sanitary.radiator, x + along, WIDTH - IN - 0.05, turn=180)
    put(f, "furniture", f"plant {name}", furniture.plant, x + 2.6, 13.8)


def tall_cabinet():
    return furniture.cabinet(0.6, 0.6, 2.1, 1, 2)


def open_plan(f, k, last, r):
    name, m = f"open plan {k + 1}", f.m
    left, right = f.curtain(k, last)
    edge = [(r[2], WIDTH - IN), (right, WIDTH - IN), (right, WIDTH + 0.2), (left, WIDTH + 0.2)]
    floor = list(dict.fromkeys([(r[0], r[1]), (r[2], r[1]), *edge]))
    room(f, name, r, has_ceiling=False, floor=floor)
    for b in range(k, last + 1):
        for i, (dx, y) in enumerate(((1.4, 9.9), (4.6, 9.9), (1.4 if b % 2 else 4.6, 12.9))):
            desk_pair(f, f"{name} {b - k + 1}.{i + 1}", b * BAY + dx, y)
        for i, y in enumerate((9.9, 12.9)):
            put(f, "lamp", f"luminaire {name} {b - k + 1}.{i + 1}", sanitary.luminaire, b * BAY + 3, y, CLEAR)
        if b % 4 != 2:
            put(f, "wood", f"cabinet {name} {b - k + 1}", furniture.cabinet, b * BAY + 5.1, NORTH[1] + 0.226)
    start, length = r[0] + 0.3, r[2] - r[0] - 0.6
    round_duct(m, f.name("duct", name), (start, 10.4, 3.05), length, 0.15, (1, 0, 0))
    ends = ((start, 10.75, 3.2), (start + length, 10.75, 3.2))
    pipe(m, f.name("sprinkler pipe", name), ends, 0.02)


def corridor(f):
    m, far = f.m, f.length - IN
    room(f, "corridor", (IN, SOUTH[1], far, NORTH[0]), has_ceiling=False)
    duct(m, f.name("duct corridor"), (0.4, 6.2, 3.0), (far - 0.4, 6.2, 3.0), (0.4, 0.25))
    for i, y in enumerate((7.2, 7.35)):
        path = [(0.3, y, 0.16), (0.3, y, 2.95), (far - 0.3, y, 2.95), (far - 0.3, y, 0.16)]
        pipe(m, f.name("pipe corridor", i + 1), path, 0.027)
    cable_tray(m, f.name("cable tray corridor"), (0.5, 6.8, 2.75), far - 1.0)
    for k in range(f.bays):
        x = k * BAY
        round_duct(m, f.name("duct", k + 1), (x + 3.0, 6.0, 3.02), 1.7, 0.08, (0, -1, 0))
        put(f, "lamp", f"luminaire corridor {k + 1}", sanitary.luminaire, x + 3.0, 5.75, CLEAR)
    put(f, "safety", "extinguisher corridor", sanitary.extinguisher, 4.0, SOUTH[1])


def toilets(f, k, r):
    m, name, back = f.m, f"toilets {k + 1}", r[3]
    room(f, name, r)
    t, west, east = TILES.thickness, r[0] + TILES.thickness, r[2] - TILES.thickness
    tiles = {"style": "Ceramic", "material": "Tiles", "tail": "$,.CLADDING."}
    m.box("IFCCOVERING", f.name("tiles", name, "west"), (r[0], r[1], FLOOR), (west, back, 2.16), **tiles)
    m.box("IFCCOVERING", f.name("tiles", name, "east"), (east, r[1], FLOOR), (r[2], back, 2.16), **tiles)
    m.box("IFCCOVERING", f.name("tiles", name, "north"), (west, back - t, FLOOR), (east, back, 2.16), **tiles)
    middle, front = (west + east) / 2, 12.7
    panel = {"style": "Cladding", "material": "Laminate"}
    lo, hi = (middle - 0.015, front, 0.31), (middle + 0.015, back - t, 2.16)
    m.box("IFCWALL", f.name("cabin wall", name), lo, hi, **panel)
    stops = [west, west + 0.3, west + 1.1, middle + 0.3, middle + 1.1, east]
    for i in (0, 2, 4):
        lo, hi = (stops[i], front - 0.03, 0.31), (stops[i + 1], front, 2.16)
        m.box("IFCWALL", f.name("cabin front", name, i // 2 + 1), lo, hi, **panel)
    for i in (1, 3):
        place = m.place((stops[i], front - 0.05, FLOOR))
        leaf = door_items(m, 0.8, 2.0)
        m.piece("IFCDOOR", f.name("cabin door", name, (i + 1) // 2), place, *leaf, material="Laminate")
    for i, x in enumerate(((west + middle) / 2, (middle + east) / 2)):
        put(f, "sanitary", f"toilet {name} {i + 1}", sanitary.toilet, x, back - t, turn=180)
    for i, y in enumerate((9.4, 10.4)):
        put(f, "sanitary", f"basin {name} {i + 1}", sanitary.basin, west, y, turn=-90)
        lo, hi = (west, y - 0.3, 1.35), (west + 0.006, y + 0.3, 2.05)
        m.box("IFCFURNITURE", f.name("mirror", name, i + 1), lo, hi, "Steel", material="Mirror")
    put(f, "sanitary", f"urinal {name}", sanitary.urinal, east, 10.6, turn=90)
    put(f, "lamp", f"luminaire {name}", sanitary.luminaire, middle, 10.5, CEILING - 0.02)


def stairs(f, k, r):
    """Twenty steps in two flights, with a landing between them."""
    m, name, steps, rise, tread = f.m, f"stairs {k + 1}", 10, 0.18, 0.28
    room(f, name, r, has_ceiling=False, floor=corners(r[0], r[1], r[2], 10.6))
    far, width = 10.6 + (steps - 1) * tread, 1.3
    whole = m.product("IFCSTAIR", f.name(name), m.place((0, 0, 0)), "$")
    up = m.place((r[0], 10.6, FLOOR))
    flight(m, f.name(name, "flight 1"), up, width, steps, rise, tread, whole)
    sloped_railing(m, f.name(name, "railing 1"), up, width - 0.05, steps, rise, tread, whole)
    half = FLOOR + steps * rise
    lo, hi = (r[0], far, half - 0.2), (r[2], r[3], half)
    concrete = {"style": "Concrete", "material": "Reinforced concrete", "tail": "$,.LANDING."}
    m.box("IFCSLAB", f.name(name, "landing"), lo, hi, **concrete)
    back = m.place((r[2], far, half), (-1, 0))
    flight(m, f.name(name, "flight 2"), back, width, steps, rise, tread, whole)
    sloped_railing(m, f.name(name, "railing 2"), back, width - 0.05, steps, rise, tread, whole)
    if f.number > 1:
        at = m.place((r[0] + width, 10.57, FLOOR))
        railing(m, f.name(name, "railing 3"), at, r[2] - r[0] - 2 * width)
    path = [(r[2] - 0.12, r[1] + 0.12, FLOOR), (r[2] - 0.12, r[1] + 0.12, CLEAR)]
    pipe(m, f.name("soil pipe", name), path, 0.055)
