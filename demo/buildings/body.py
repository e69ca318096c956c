"""Bodies as IFC writes them: extruded profiles, swept rods, facets, bodies cut by half-spaces, repeated bodies."""

from .step import Model, real, refs

# Colour, and transparency where it is not opaque.
STYLES = {
    "Glass": ((0.75, 0.88, 0.92), 0.75),
    "Lamp shade": ((1.0, 0.98, 0.9), 0.2),
    "Concrete": ((0.7, 0.7, 0.68), 0),
    "Plaster": ((0.95, 0.95, 0.93), 0),
    "Insulation": ((0.95, 0.85, 0.45), 0),
    "Cladding": ((0.45, 0.5, 0.52), 0),
    "Frame": ((0.25, 0.27, 0.29), 0),
    "Timber": ((0.72, 0.55, 0.36), 0),
    "Ceramic": ((0.97, 0.97, 0.97), 0),
    "Steel": ((0.6, 0.62, 0.64), 0),
    "Textile": ((0.25, 0.33, 0.5), 0),
    "Brick": ((0.6, 0.25, 0.18), 0),
}


class Modeller(Model):
    """A model under construction that knows bodies. Items are told by their line numbers."""

    def __init__(self, *names, **options):
        super().__init__(*names, **options)
        self.kinds, self.styles, self.patterns = {}, {}, {}

    # Profiles, in their own plane.

    def rectangle(self, x, y, at=(0, 0)):
        place = self.once(f"IFCAXIS2PLACEMENT2D({self.point(*at)},$)")
        return self.once(f"IFCRECTANGLEPROFILEDEF(.AREA.,$,{place},{self.length(x)},{self.length(y)})")

    def circle(self, r, at=(0, 0)):
        place = self.once(f"IFCAXIS2PLACEMENT2D({self.point(*at)},$)")
        return self.once(f"IFCCIRCLEPROFILEDEF(.AREA.,$,{place},{self.length(r)})")

    def tube_profile(self, r, thickness):
        place = self.once(f"IFCAXIS2PLACEMENT2D({self.point(0, 0)},$)")
        size = f"{self.length(r)},{self.length(thickness)}"
        return self.once(f"IFCCIRCLEHOLLOWPROFILEDEF(.AREA.,$,{place},{size})")

    def channel_profile(self, x, y, thickness):
        """A rectangular duct."""
        place = self.once(f"IFCAXIS2PLACEMENT2D({self.point(0, 0)},$)")
        size = f"{self.length(x)},{self.length(y)},{self.length(thickness)}"
        return self.once(f"IFCRECTANGLEHOLLOWPROFILEDEF(.AREA.,$,{place},{size},$,$)")

    def closed_line(self, outline):
        points = [self.point(*p) for p in outline]
        return self.once(f"IFCPOLYLINE({refs([*points, points[0]])})")

    def polygon(self, outline, holes=()):
        if not holes:
            return self.once(f"IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,{self.closed_line(outline)})")
        inner = refs([self.closed_line(hole) for hole in holes])
        return self.once(f"IFCARBITRARYPROFILEDEFWITHVOIDS(.AREA.,$,{self.closed_line(outline)},{inner})")

    # Items.

    def item(self, kind, line):
        ref = self.add(line)
        self.kinds[ref] = kind
        return ref

    def extruded(self, profile, height, at=(0, 0, 0), z=None, x=None, style=None):
        """Along the z axis of the frame `at`, `z`, `x`."""
        solid = f"IFCEXTRUDEDAREASOLID({profile},{self.axes(at, z, x)},{self.up},{self.length(height)})"
        return self.styled(self.item("SweptSolid", solid), style)

    def box_item(self, lo, hi, style=None):
        profile = self.rectangle(hi[0] - lo[0], hi[1] - lo[1])
        at = ((lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2, lo[2])
        return self.extruded(profile, hi[2] - lo[2], at, style=style)

    def rod(self, path, r, style=None):
        """A round rod along straight pieces."""
        line = self.once(f"IFCPOLYLINE({refs([self.point(*p) for p in path])})")
        ends = f"0.,{len(path) - 1}." if self.schema == "IFC2X3" else "$,$"
        solid = f"IFCSWEPTDISKSOLID({line},{self.length(r)},$,{ends})"
        return self.styled(self.item("AdvancedSweptSolid", solid), style)

    def clipped(self, solid, point, normal):
        """The solid without what lies on the side that the normal points to."""
        plane = self.once(f"IFCPLANE({self.axes(point, normal, crosswise(normal))})")
        half = self.once(f"IFCHALFSPACESOLID({plane},.F.)")
        return self.item("Clipping", f"IFCBOOLEANCLIPPINGRESULT(.DIFFERENCE.,{solid},{half})")

    def facets(self, parts, style=None, brep=False):
        """Items of meshes: one table of triangles, or a brep each, which IFC2X3 always writes but for boxes."""
        if brep or self.schema == "IFC2X3":
            made = [self.box_item(*mesh.box) if mesh.box else self.brep(mesh) for mesh in parts]
            return [self.styled(item, style) for item in made]
        points, triangles = [], []
        for mesh in parts:
            triangles += [refs([str(len(points) + i + 1) for i in t]) for t in mesh.triangles()]
            points += [refs([self.length(c) for c in p]) for p in mesh.points]
        table = self.add(f"IFCCARTESIANPOINTLIST3D({refs(points)})")
        item = self.item("Tessellation", f"IFCTRIANGULATEDFACESET({table},$,.T.,{refs(triangles)},$)")
        return [self.styled(item, style)]

    def brep(self, mesh):
        at, faces = [self.point(*p) for p in mesh.points], []
        for face in mesh.flat_faces():
            corners = list(dict.fromkeys(at[i] for i in face))
            if len(corners) > 2:
                loop = self.add(f"IFCPOLYLOOP({refs(corners)})")
                faces.append(self.add(f"IFCFACE(({self.add(f'IFCFACEOUTERBOUND({loop},.T.)')}))"))
        return self.item("Brep", f"IFCFACETEDBREP({self.add(f'IFCCLOSEDSHELL({refs(faces)})')})")

    # Shapes.

    def styled(self, item, style):
        if style:
            if style not in self.styles:
                self.styles[style] = self.style(style)
            self.add(f"IFCSTYLEDITEM({item},({self.styles[style]}),$)")
        return item

    def style(self, name):
        colour, clear = STYLES[name]
        rgb = self.add(f"IFCCOLOURRGB($,{','.join(map(real, colour))})")
        look = self.add(f"IFCSURFACESTYLERENDERING({rgb},{real(clear)},$,$,$,$,$,$,.NOTDEFINED.)")
        style = self.add(f"IFCSURFACESTYLE('{name}',.BOTH.,({look}))")
        return self.add(f"IFCPRESENTATIONSTYLEASSIGNMENT(({style}))") if self.schema == "IFC2X3" else style

    def representation(self, items):
        kinds = {self.kinds[i] for i in items}
        kind = kinds.pop() if len(kinds) == 1 else "SolidModel"
        return self.add(f"IFCSHAPEREPRESENTATION({self.body},'Body','{kind}',{refs(items)})")

    def shape(self, *items):
        return self.add(f"IFCPRODUCTDEFINITIONSHAPE($,$,({self.representation(items)}))")

    def pattern(self, *items):
        """A body that many products repeat."""
        return self.add(f"IFCREPRESENTATIONMAP({self.axes((0, 0, 0))},{self.representation(items)})")

    def repeated(self, maker, style, brep=False):
        """The shape of a product of facets; what `maker` makes is written once."""
        if maker not in self.patterns:
            self.patterns[maker] = self.pattern(*self.facets(maker(), style, brep))
        return self.copy(self.patterns[maker])

    def copy(self, pattern):
        """The shape of a product that repeats it."""
        unmoved = self.once(f"IFCCARTESIANTRANSFORMATIONOPERATOR3D($,$,{self.point(0, 0, 0)},$,$)")
        return self.shape(self.item("MappedRepresentation", f"IFCMAPPEDITEM({pattern},{unmoved})"))

    def piece(self, ifc_class, name, place, *items, **more):
        return self.product(ifc_class, name, place, self.shape(*items), **more)

    def box(self, ifc_class, name, lo, hi, style=None, **more):
        return self.piece(ifc_class, name, self.place((0, 0, 0)), self.box_item(lo, hi, style), **more)

    def plate(self, ifc_class, name, outline, z0, z1, holes=(), style=None, **more):
        """A level plate with rectangular holes (x0, y0, x1, y1)."""
        profile = self.polygon(outline, [corners(*hole)[::-1] for hole in holes])
        body = self.extruded(profile, z1 - z0, (0, 0, z0), style=style)
        return self.piece(ifc_class, name, self.place((0, 0, 0)), body, **more)


def corners(x0, y0, x1, y1):
    return [(x0, y0), (x1, y0), (x1, y1), (x0, y1)]


def crosswise(z):
    """A horizontal direction at right angles to a slanted one."""
    return (1, 0, 0) if z[0] == 0 else (0, 1, 0)
