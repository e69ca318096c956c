"""The demo building, a small pavilion; and a storey of 24 equal rooms, for benches."""

from .step import Model, refs


class Simple(Model):
    """Boxes, walls with holes, and round columns."""

    def __init__(self):
        super().__init__("asbuilt demo", "Pavilion", [("Ground floor", 0)], shared=False)

    def extrusion(self, profile, height, offset=(0, 0, 0)):
        at = self.add(f"IFCAXIS2PLACEMENT3D({self.point(*offset)},{self.up},{self.east})")
        solid = self.add(f"IFCEXTRUDEDAREASOLID({profile},{at},{self.up},{self.length(height)})")
        shape = self.add(f"IFCSHAPEREPRESENTATION({self.body},'Body','SweptSolid',({solid}))")
        return self.add(f"IFCPRODUCTDEFINITIONSHAPE($,$,{refs([shape])})")

    def rectangle(self, x, y):
        at = self.add(f"IFCAXIS2PLACEMENT2D({self.point(0, 0)},$)")
        return self.add(f"IFCRECTANGLEPROFILEDEF(.AREA.,$,{at},{self.length(x)},{self.length(y)})")

    def circle(self, r):
        at = self.add(f"IFCAXIS2PLACEMENT2D({self.point(0, 0)},$)")
        return self.add(f"IFCCIRCLEPROFILEDEF(.AREA.,$,{at},{self.length(r)})")

    def box(self, ifc_class, name, lo, hi, loa=None):
        centre = ((lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2, lo[2])
        shape = self.extrusion(self.rectangle(hi[0] - lo[0], hi[1] - lo[1]), hi[2] - lo[2])
        e = self.product(ifc_class, name, self.place(centre), shape)
        if loa:
            self.property(e, name, "Pset_Survey", "LevelOfAccuracy", f"IFCLABEL('{loa}')")

    def wall(self, name, a, b, thickness, openings=(), height=2.8):
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = (dx * dx + dy * dy) ** 0.5
        place = self.place((a[0], a[1], 0), (dx / length, dy / length))
        shape = self.extrusion(self.rectangle(length, thickness), height, (length / 2, 0, 0))
        e = self.product("IFCWALL", name, place, shape)
        for i, (along, width, high, sill) in enumerate(openings):
            at = self.placement(place, (along + width / 2, 0, sill))
            hole = self.extrusion(self.rectangle(width, 3 * thickness), high)
            self.opening(f"{name} opening {i + 1}", at, hole, e)

    def column(self, name, centre, radius, height=2.8):
        place = self.place((centre[0], centre[1], 0))
        self.product("IFCCOLUMN", name, place, self.extrusion(self.circle(radius), height))


def pavilion():
    m = Simple()
    m.box("IFCSLAB", "floor", (-0.25, -0.25, -0.3), (10.25, 7.25, 0.0), "LOA20")
    m.box("IFCSLAB", "roof", (-0.25, -0.25, 2.8), (10.25, 7.25, 3.05), "LOA20")
    m.wall("wall south", (-0.25, -0.125), (10.25, -0.125), 0.25, [(1.5, 1.6, 1.3, 0.9), (6.0, 2.4, 1.3, 0.9)])
    m.wall("wall north", (-0.25, 7.125), (10.25, 7.125), 0.25)
    m.wall("wall west", (-0.125, 0), (-0.125, 7), 0.25, [(2.6, 1.0, 2.1, 0.0)])
    m.wall("wall east", (10.125, 0), (10.125, 7), 0.25)
    m.wall("partition", (5.5, 0), (5.5, 4.6), 0.12, [(2.2, 0.9, 2.1, 0.0)])
    m.wall("screen wall", (7.2, 5.2), (10.0, 5.2), 0.15)
    m.column("column A", (2.8, 5.0), 0.18)
    m.column("column B", (5.5, 5.6), 0.18)
    m.column("column C", (7.8, 2.2), 0.18)
    m.box("IFCBEAM", "beam", (0.0, 4.88, 2.45), (5.4, 5.12, 2.8))
    m.box("IFCBUILDINGELEMENTPROXY", "store behind the wall", (3.0, 7.6, 0.0), (6.0, 9.0, 2.4))
    m.finish()
    return m


def rooms(nx=6, ny=4, width=3.6, depth=4.2):
    """Rooms in a grid, about 200 objects."""
    m = Simple()
    for i in range(nx):
        for j in range(ny):
            x, y, room = i * width, j * depth, f"{i + 1}.{j + 1}"
            m.box("IFCSLAB", f"floor {room}", (x, y, -0.25), (x + width, y + depth, 0.0))
            m.box("IFCSLAB", f"ceiling {room}", (x, y, 2.8), (x + width, y + depth, 3.05))
            m.column(f"column {room}", (x + 0.7, y + 0.7), 0.15)
            m.box("IFCBEAM", f"beam {room}", (x + 0.1, y + 2.0, 2.5), (x + width - 0.1, y + 2.25, 2.8))
            m.box("IFCFURNISHINGELEMENT", f"cupboard {room}", (x + 2.4, y + 3.4, 0.0), (x + 3.4, y + 3.9, 1.8))
    for i in range(nx + 1):
        for j in range(ny):
            hole = [(1.5, 1.0, 2.1, 0.0)] if 0 < i < nx else [(1.2, 1.6, 1.3, 0.9)]
            m.wall(f"wall x{i}.{j + 1}", (i * width, j * depth + 0.06), (i * width, (j + 1) * depth - 0.06), 0.12, hole)
    for i in range(nx):
        for j in range(ny + 1):
            hole = [(1.2, 1.0, 2.1, 0.0)] if 0 < j < ny else []
            m.wall(f"wall y{i + 1}.{j}", (i * width, j * depth), ((i + 1) * width, j * depth), 0.12, hole)
    m.finish()
    return m
