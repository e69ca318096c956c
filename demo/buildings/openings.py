"""Windows, doors and glazing: opaque frames and clear panes."""

from .body import corners

DEPTH = 0.07


def upright(m, profile, depth, y=0.0, style=None):
    """A profile in x and z, as thick as `depth` about y."""
    return m.extruded(profile, depth, (0, y + depth / 2, 0), (0, -1, 0), (1, 0, 0), style)


def ring(m, outer, border, depth, style, inner=None):
    """A frame around one light, or around those of `inner`."""
    holes = inner or [shrunk(outer, border)]
    return upright(m, m.polygon(corners(*outer), [corners(*h)[::-1] for h in holes]), depth, style=style)


def shrunk(r, by):
    return (r[0] + by, r[1] + by, r[2] - by, r[3] - by)


def pane(m, light, thickness=0.024, style="Glass"):
    x, z = (light[0] + light[2]) / 2, (light[1] + light[3]) / 2
    return upright(m, m.rectangle(light[2] - light[0], light[3] - light[1], (x, z)), thickness, style=style)


def casement(m, width, height, sashes=1, frame="Frame"):
    """Frame, sashes and panes of a window, its lower left corner at the origin."""
    pitch = (width - 0.06) / sashes
    lights = [(0.06 + i * pitch, 0.06, i * pitch + pitch, height - 0.06) for i in range(sashes)]
    items = [ring(m, (0, 0, width, height), 0, DEPTH, frame, lights)]
    for light in lights:
        items += [ring(m, light, 0.05, 0.06, frame), pane(m, shrunk(light, 0.05))]
    return items


def in_hole(m, name, wall, number, hole, y, ifc_class, items, material=None):
    """Fills a wall's hole; y: where across the wall the middle of the frame stands."""
    place = m.placement(wall.place, (hole.along, y, hole.sill))
    e = m.piece(ifc_class, name, place, *items, material=material)
    m.related("IFCRELFILLSELEMENT", f"{name} fills", wall.openings[number], e)
    return e


def window(m, name, wall, number, hole, y, sashes=1, material="Aluminium"):
    items = casement(m, hole.width, hole.height, sashes)
    return in_hole(m, name, wall, number, hole, y, "IFCWINDOW", items, material)


def fixed_light(m, name, wall, number, hole, y, material):
    """A pane without frame that is glass by the name of its material alone."""
    whole = pane(m, (0, 0, hole.width, hole.height), 0.036, None)
    return in_hole(m, name, wall, number, hole, y, "IFCWINDOW", [whole], material)


def door_items(m, width, height, leaf="Timber", light=None, frame="Frame"):
    """Lining, leaf drawn shut, and handle; `light` is a pane in the leaf, or "all"."""
    d, w, h = 0.05, width, height
    lining = [(0, 0), (d, 0), (d, h - d), (w - d, h - d), (w - d, 0), (w, 0), (w, h), (0, h)]
    items = [upright(m, m.polygon(lining), 0.1, style=frame)]
    shut = (d, 0.005, w - d, h - d)
    if light == "all":
        items.append(pane(m, shut, 0.012))
    elif light:
        items += [ring(m, shut, 0, 0.04, leaf, [light]), pane(m, light, 0.012)]
    else:
        x, z = (shut[0] + shut[2]) / 2, (shut[1] + shut[3]) / 2
        profile = m.rectangle(shut[2] - shut[0], shut[3] - shut[1], (x, z))
        items.append(upright(m, profile, 0.04, style=leaf))
    face = 0.006 if light == "all" else 0.02
    for side in (-1, 1):
        path = [(w - d - 0.08, side * face, 1.05), (w - d - 0.08, side * 0.065, 1.05), (w - 0.24, side * 0.065, 1.05)]
        items.append(m.rod(path, 0.01, "Steel"))
    return items


def door(m, name, wall, number, hole, y, leaf="Timber", light=None):
    items = door_items(m, hole.width, hole.height, leaf, light)
    return in_hole(m, name, wall, number, hole, y, "IFCDOOR", items, "Steel" if leaf == "Frame" else "Timber")


def glazing(m, name, place, stops, levels, depth, whole=None, styled=True, door=None, blind=()):
    """Mullions at `stops`, rails between `levels` (pairs: from, to, of the rails), panes in all cells. A cell's door
    (number of the cell, height) stands on the lowest rail. Without style the panes are glass by their material. The
    rows of `blind` are opaque."""
    w, low, high, n = 0.05, levels[0][0], levels[-1][1], 0
    member = {"whole": whole, "material": "Aluminium"}
    for i, x in enumerate(stops):
        body = m.box_item((x - w / 2, -depth / 2, low), (x + w / 2, depth / 2, high), "Frame")
        m.piece("IFCMEMBER", f"{name} mullion {i + 1}", place, body, **member)
    for i, (x0, x1) in enumerate(zip(stops, stops[1:])):
        left, right = x0 + w / 2, x1 - w / 2
        for k, (z0, z1) in enumerate(levels):
            body = m.box_item((left, -depth / 2, z0), (right, depth / 2, z1), "Frame")
            m.piece("IFCMEMBER", f"{name} rail {i + 1}.{k + 1}", place, body, **member)
        for k, (below, above) in enumerate(zip(levels, levels[1:])):
            foot = below[1]
            if door and door[0] == i and k == 0:
                glass_door(m, f"{name} door", m.placement(place, (left, 0, foot)), right - left, door[1])
                foot += door[1]
            n += 1
            style = "Cladding" if k in blind else "Glass" if styled else None
            body = pane(m, (left, foot, right, above[0]), 0.028, style)
            material = "Aluminium" if k in blind else "Glass"
            m.piece("IFCPLATE", f"{name} pane {n}", place, body, whole=whole, material=material)


def glass_door(m, name, place, width, height):
    m.piece("IFCDOOR", name, place, *door_items(m, width, height, light="all"), material="Glass")
