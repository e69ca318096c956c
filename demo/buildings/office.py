"""An office building: rooms on both sides of a corridor, in bays of 6 m; the shell of each floor.

office_plan.py has its measures, office_rooms.py what stands in the rooms.
"""

from .body import Modeller, corners
from .layers import BOARD, CONCRETE, PANEL, PARTITION, STUDS, WOOL, Hole, Layer, wall
from .office_plan import BAY, CEILING, CLEAR, DOOR, FLOOR, IN, NORTH, OUTSIDE, SLAB, SOUTH, STOREY, THICK, WIDTH, Floor
from .office_rooms import fit_out
from .openings import door, fixed_light, glazing, window
from .services import column

FACADE = [PANEL, WOOL, CONCRETE, BOARD]
BULKHEAD = Layer("bulkhead", THICK, "IFCWALL", "Plaster board", "Plaster")


def office(storeys=1, bays=4):
    names = [(f"Level {i + 1}", i * STOREY) for i in range(storeys)]
    m = Modeller("asbuilt office", "Office", names, space="office ")
    for i in range(storeys):
        m.begin(i)
        floor = Floor(m, i + 1, bays, i == storeys - 1)
        slabs(floor)
        facade(floor)
        curtain_walls(floor)
        partitions(floor)
        for n, (x, y, top) in enumerate(floor.columns()):
            column(m, floor.name("column", n + 1), x, y, 0, top, 0.35)
        fit_out(floor)
    grid(m, bays)
    m.finish()
    return m


def slabs(f):
    m, out = f.m, CONCRETE.thickness
    whole = corners(-out, -out, f.length + out, WIDTH + out)
    stairs = [(k * BAY + IN, 10.6, k * BAY + 2.95, 14.3875) for k in range(0, f.bays, 4)]
    holes = stairs if f.number > 1 else []
    concrete = {"style": "Concrete", "material": "Reinforced concrete"}
    m.plate("IFCSLAB", f.name("slab"), whole, -SLAB, 0, holes, **concrete)
    if f.is_top:
        m.plate("IFCSLAB", f.name("roof slab"), whole, CLEAR, STOREY, stairs, **concrete)
        more = {"style": "Insulation", "material": "Foam glass", "tail": "$,.ROOFING."}
        m.plate("IFCCOVERING", f.name("roof insulation"), whole, STOREY, STOREY + FLOOR, stairs, **more)
        for n, hole in enumerate(stairs):
            stair_head(f, f"stair head {n + 1}", hole)
    for k, last in f.open_plans():
        end = (last + 1) * BAY - (IN if last == f.bays - 1 else 0.05)
        lo, hi = (k * BAY + 0.05, 10.95, CLEAR - 0.35), (end, 11.25, CLEAR)
        m.box("IFCBEAM", f.name("beam", k + 1), lo, hi, **concrete)


def stair_head(f, name, hole, high=2.4):
    """Four walls and a lid over the stairs, and a door to the roof."""
    (x0, y0, x1, y1), t, z = hole, CONCRETE.thickness, STOREY + FLOOR
    leaf = Hole(x1 - 1.2 - x0 + t, 0.0, *DOOR)
    lines = [((x0 - t, y0), (x1 + t, y0)), ((x1, y0), (x1, y1)), ((x1 + t, y1), (x0 - t, y1)), ((x0, y1), (x0, y0))]
    for i, (a, b) in enumerate(lines):
        holes = [leaf] if i == 0 else []
        w = wall(f.m, f.name(name, "wall", i + 1), a, b, z, high, [CONCRETE], -t, holes)
        if holes:
            door(f.m, f.name(name, "door"), w, 0, leaf, -t / 2, "Frame")
    concrete = {"style": "Concrete", "material": "Reinforced concrete"}
    f.m.box("IFCSLAB", f.name(name, "lid"), (x0 - t, y0 - t, z + high), (x1 + t, y1 + t, z + high + t), **concrete)


def facade(f):
    south, west, east = [], [], []
    for k in range(f.bays):
        south += [Hole(k * BAY + 0.9, 1.0, 1.6, 1.5), Hole(k * BAY + 3.5, 1.0, 1.6, 1.5)]
    side(f, "facade south", (0, 0), (f.length, 0), south, True)
    east += [Hole(1.6, 1.0, 1.6, 1.5), Hole(6.0, FLOOR, 1.2, 2.3), Hole(9.0, 1.0, 1.6, 1.5), Hole(12.0, 1.0, 1.6, 1.5)]
    side(f, "facade east", (f.length, 0), (f.length, WIDTH), east, False)
    west += [Hole(WIDTH - 9.8, 1.0, 1.2, 1.5), Hole(WIDTH - 7.2, FLOOR, 1.2, 2.3), Hole(WIDTH - 3.2, 1.0, 1.6, 1.5)]
    side(f, "facade west", (0, WIDTH), (0, 0), west, False)
    edges = [0.0]
    for k, last in f.open_plans():
        edges += f.curtain(k, last)
    edges += [f.length]
    for n, (x0, x1) in enumerate(zip(edges[::2], edges[1::2])):
        ends = (x1 == f.length, x0 == 0.0)
        lounges = [k * BAY for k in range(1, f.bays, 4) if x0 <= k * BAY < x1]
        holes = [Hole(x1 - x - along - 1.6, 1.0, 1.6, 1.5) for x in lounges for along in (3.5, 0.9)]
        side(f, f"facade north {n + 1}", (x1, WIDTH), (x0, WIDTH), holes, True, ends)


def side(f, name, a, b, holes, is_long, ends=(True, True)):
    """One side of the facade; long sides run around the corners, the others between them."""

    def reach(outer, inner):
        more = -outer if is_long else -inner
        return tuple(more if e else 0.0 for e in ends)

    w = wall(f.m, f.name(name), a, b, 0, CLEAR, FACADE, -OUTSIDE, holes, reach, CONCRETE.name)
    f.m.property(w.product, f.name(name), "Pset_WallCommon", "IsExternal", "IFCBOOLEAN(.T.)")
    for i, hole in enumerate(holes):
        title = f.name("window", name.removeprefix("facade "), i + 1)
        if hole.sill == FLOOR:
            fixed_light(f.m, title, w, i, hole, -0.1, "Glas" if "west" in name else "Glass")
        else:
            window(f.m, title, w, i, hole, -0.1, 2)


def curtain_walls(f):
    m = f.m
    for k, last in f.open_plans():
        start, end = f.curtain(k, last)
        n = round((end - start) / 2.2)
        stops = [0.025 + (end - start - 0.05) * i / n for i in range(n + 1)]
        levels = [(-SLAB, -SLAB + 0.05), (FLOOR - 0.05, FLOOR), (CEILING, CEILING + 0.05), (CLEAR - 0.05, CLEAR)]
        place = m.place((start, WIDTH + CONCRETE.thickness + 0.075, 0))
        name = f.name("curtain wall", k + 1)
        whole = m.product("IFCCURTAINWALL", name, place, "$")
        glazing(m, name, place, stops, levels, 0.15, whole, blind=(0,))


def partitions(f):
    for k in range(f.bays):
        if k:
            cross_walls(f, k)
        corridor_south(f, k)
        corridor_north(f, k)
        if k % 4 == 0:
            x = k * BAY + 3
            solid(f, f"partition stairs {k + 1}", (x, NORTH[1]), (x, WIDTH - IN))


def solid(f, name, a, b, holes=()):
    """A partition about the line from a to b, from slab to slab."""
    return wall(f.m, f.name(name), a, b, 0, CLEAR, PARTITION, -THICK / 2, holes, carries=STUDS.name)


def cross_walls(f, k):
    x = k * BAY
    if k % 4 == 3:
        place = f.m.place((x, IN, 0), (0, 1))
        glass_front(f, f"partition south {k}", place, SOUTH[0] - IN, 3)
    else:
        solid(f, f"partition south {k}", (x, IN), (x, SOUTH[0]))
    if k % 4 != 3:
        solid(f, f"partition north {k}", (x, NORTH[1]), (x, WIDTH - IN))


def glass_front(f, name, place, length, cells, has_door=False, duct_at=None, by_style=True):
    """From slab to ceiling glass, a bulkhead above."""
    stops = [0.025 + (length - 0.05) * i / cells for i in range(cells + 1)]
    levels = [(0, FLOOR), (CEILING - 0.07, CEILING)]
    at = (cells - 1, 2.3) if has_door else None
    glazing(f.m, f.name("glass", name), place, stops, levels, 0.08, None, by_style, at)
    body = f.m.box_item((0, -THICK / 2, CEILING), (length, THICK / 2, CLEAR), BULKHEAD.style)
    e = f.m.piece("IFCWALL", f.name("bulkhead", name), place, body, material=BULKHEAD.material)
    if duct_at is not None:
        lo, hi = (duct_at, -0.1, CEILING), (duct_at + 0.2, 0.1, CEILING + 0.2)
        hole = f.m.shape(f.m.box_item(lo, hi))
        f.m.opening(f.name("bulkhead", name, "opening"), f.m.placement(place, (0, 0, 0)), hole, e)


def span(f, k, is_glass):
    """From where to where a corridor wall stands in a bay: glass between the cross walls, others to the next wall."""
    before = k and is_glass(k - 1)
    after = k + 1 < f.bays and is_glass(k + 1)
    start = k * BAY + (0.05 if is_glass(k) else -0.05 if before else 0.0)
    end = (k + 1) * BAY + (-0.05 if is_glass(k) else 0.05 if after else 0.0)
    return max(start, IN), min(end, f.length - IN)


def corridor_south(f, k):
    def is_glass(k):
        return k % 4 == 1

    (a, b), y, duct_at = span(f, k, is_glass), sum(SOUTH) / 2, k * BAY + 2.9
    if is_glass(k):
        place = f.m.place((a, y, 0))
        glass_front(f, f"corridor south {k + 1}", place, b - a, 4, True, duct_at - a, k % 8 == 1)
        return
    leaf = Hole(k * BAY + 4.6 - a, FLOOR, *DOOR)
    w = solid(f, f"corridor south {k + 1}", (a, y), (b, y), [leaf, Hole(duct_at - a, CEILING, 0.2, 0.2)])
    light = (0.65, 0.3, 0.85, 1.9) if k % 4 == 2 else None
    door(f.m, f.name("door south", k + 1), w, 0, leaf, 0.0, light=light)


def corridor_north(f, k):
    def is_glass(k):
        return k % 4 == 2

    (a, b), y = span(f, k, is_glass), sum(NORTH) / 2
    if is_glass(k):
        glass_front(f, f"corridor north {k + 1}", f.m.place((a, y, 0)), b - a, 4, True, None, False)
        return
    if k % 4 == 1:
        solid(f, f"corridor north {k + 1}", (a, y), (b, y), [Hole(k * BAY + 1.5 - a, FLOOR, 2.4, 2.4)])
        return
    at = [1.2, 4.0] if k % 4 == 0 else [2.5]
    holes = [Hole(k * BAY + x - a, FLOOR, *DOOR) for x in at]
    w = solid(f, f"corridor north {k + 1}", (a, y), (b, y), holes)
    for i, hole in enumerate(holes):
        # The stairs' door is of steel with a pane.
        is_stairs = k % 4 == 0 and i == 0
        light = (0.25, 0.9, 0.75, 1.9) if is_stairs else None
        name = f.name("door north", k + 1, i + 1)
        e = door(f.m, name, w, i, hole, 0.0, "Frame" if is_stairs else "Timber", light)
        if is_stairs:
            f.m.property(e, name, "Pset_DoorCommon", "FireRating", "IFCLABEL('T30')")


def grid(m, bays):
    """Axes of the columns and of the corridor's walls."""
    m.begin(0)
    far = bays * BAY
    across = [(f"{k + 1}", (k * BAY, -1), (k * BAY, WIDTH + 1)) for k in range(bays + 1)]
    along = [("ABCD"[i], (-1, y), (far + 1, y)) for i, y in enumerate((0.0, sum(SOUTH) / 2, sum(NORTH) / 2, WIDTH))]
    axes = []
    for lines in (across, along):
        made = [m.once(f"IFCPOLYLINE(({m.point(*a)},{m.point(*b)}))") for _, a, b in lines]
        axes.append([m.add(f"IFCGRIDAXIS('{tag}',{line},.T.)") for (tag, _, _), line in zip(lines, made)])
    u, v = (f"({','.join(a)})" for a in axes)
    m.product("IFCGRID", "grid", m.place((0, 0, 0)), "$", tail=f"{u},{v},$,$")


def stations(storeys=1, bays=4):
    """Where one would scan it from: every room, the corridor in each bay, both ends of the stairs, and outside."""
    out = []
    for i in range(storeys):
        z = i * STOREY + FLOOR + 1.55
        for k in range(bays):
            x = k * BAY
            rooms = {0: [(1.5, 9.0), (4.5, 11.7)], 1: [(2.0, 11.0), (4.6, 10.6)]}
            inside = [(4.9, 4.2), (4.4, 6.6), *rooms.get(k % 4, [(3.0, 8.4), (2.6, 11.9), (3.0, 14.0)])]
            out += [(x + dx, y, z) for dx, y in inside]
            if k % 4 == 0:
                out.append((x + 1.5, 13.75, z + 1.8))
    far = bays * BAY
    around = [(far * side, y) for side in (0.25, 0.75) for y in (-9.0, WIDTH + 9.0)]
    around += [(x, WIDTH / 2) for x in (-9.0, far + 9.0)]
    return out + [(x, y, 1.6) for x, y in around]
