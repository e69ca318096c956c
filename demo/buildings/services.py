"""Ducts, pipes, cable trays, stairs and railings."""

from .body import corners


def duct(m, name, a, b, size, ifc_class="IFCDUCTSEGMENT"):
    """Rectangular, of sheet metal, along x or y between the middles of its ends; size: across, high."""
    along_x = a[1] == b[1]
    z, x = ((1, 0, 0), (0, 1, 0)) if along_x else ((0, 1, 0), (-1, 0, 0))
    length = abs(b[0] - a[0]) + abs(b[1] - a[1])
    body = m.extruded(m.channel_profile(*size, 0.002), length, a, z, x, "Steel")
    return m.piece(ifc_class, name, m.place((0, 0, 0)), body, material="Galvanised steel")


def round_duct(m, name, a, length, r, z=(0, 1, 0), ifc_class="IFCDUCTSEGMENT"):
    """Spiral duct from `a` on, along `z`."""
    x = (0, 0, 1) if z[2] == 0 else (1, 0, 0)
    body = m.extruded(m.tube_profile(r, 0.001), length, a, z, x, "Steel")
    return m.piece(ifc_class, name, m.place((0, 0, 0)), body, material="Galvanised steel")


def pipe(m, name, path, r, ifc_class="IFCPIPESEGMENT"):
    body = m.rod(path, r, "Steel")
    return m.piece(ifc_class, name, m.place((0, 0, 0)), body, material="Copper")


def cable_tray(m, name, a, length, ifc_class="IFCCABLECARRIERSEGMENT"):
    """A channel of sheet metal along x, open above; `a` is the middle of its lower edge."""
    u = [(-0.1, 0), (0.1, 0), (0.1, 0.06), (0.098, 0.06), (0.098, 0.002), (-0.098, 0.002), (-0.098, 0.06), (-0.1, 0.06)]
    body = m.extruded(m.polygon(u), length, a, (1, 0, 0), (0, 1, 0), "Steel")
    return m.piece(ifc_class, name, m.place((0, 0, 0)), body, material="Galvanised steel")


def flight(m, name, place, width, steps, rise, tread, whole=None, look=("Concrete", "Concrete"), thickness=0.18):
    """Goes up along its y axis, x across; its last riser is the edge of the floor above. `look`:
    style and material."""
    treads = steps - 1
    outline = [(0, 0)]
    for i in range(treads):
        outline += [(i * tread, (i + 1) * rise), ((i + 1) * tread, (i + 1) * rise)]
    outline += [(treads * tread, treads * rise - thickness), (tread, 0)]
    # The profile lies in y and z; it is extruded along x.
    body = m.extruded(m.polygon(outline[::-1]), width, (0, 0, 0), (1, 0, 0), (0, 1, 0), look[0])
    return m.piece("IFCSTAIRFLIGHT", name, place, body, whole=whole, material=look[1])


def sloped_railing(m, name, place, x, steps, rise, tread, whole=None):
    """Thin rods on each tread of a flight, in its frame, and a handrail."""
    items, high = [], 0.9
    for i in range(steps - 1):
        y, foot = (i + 0.5) * tread, (i + 1) * rise
        items.append(m.rod([(x, y, foot), (x, y, foot + high)], 0.008, "Steel"))
    run = (steps - 2) * tread
    ends = [(x, 0.5 * tread, rise + high + 0.02), (x, 0.5 * tread + run, rise + high + 0.02 + (steps - 2) * rise)]
    items.append(m.rod(ends, 0.02, "Steel"))
    return m.piece("IFCRAILING", name, place, *items, whole=whole, material="Steel")


def railing(m, name, place, length, high=1.0, step=0.12, whole=None):
    """Level, along x: balusters of 12 mm, a bar at the foot, posts and a handrail."""
    items = [m.rod([(0, 0, 0.08), (length, 0, 0.08)], 0.01, "Steel")]
    items.append(m.rod([(0, 0, high - 0.02), (length, 0, high - 0.02)], 0.02, "Steel"))
    n = round(length / step)
    for i in range(1, n):
        x = length * i / n
        items.append(m.rod([(x, 0, 0.09), (x, 0, high - 0.04)], 0.006, "Steel"))
    for x in (0.02, length - 0.02):
        items.append(m.rod([(x, 0, 0), (x, 0, high - 0.04)], 0.015, "Steel"))
    return m.piece("IFCRAILING", name, place, *items, whole=whole, material="Steel")


def column(m, name, x, y, z0, z1, width):
    """Square."""
    body = m.extruded(m.polygon(corners(-width / 2, -width / 2, width / 2, width / 2)), z1 - z0, style="Concrete")
    return m.piece("IFCCOLUMN", name, m.place((x, y, z0)), body, material="Reinforced concrete")
