"""An IFC file under construction: lines, identities, placements, storeys, relations. Lengths are metres everywhere."""

import hashlib

DIGITS = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$"

# What follows Representation in a product: Tag and what the class adds.
TAILS = {
    "IFC4": {
        "IFCFURNISHINGELEMENT": "$",
        "IFCSTAIRFLIGHT": "$,$,$,$,$,$",
        "IFCDOOR": "$,$,$,.DOOR.,$,$",
        "IFCWINDOW": "$,$,$,.WINDOW.,$,$",
        "": "$,$",
    },
    "IFC2X3": {
        "IFCSLAB": "$,$",
        "IFCCOVERING": "$,$",
        "IFCRAILING": "$,$",
        "IFCBUILDINGELEMENTPROXY": "$,$",
        "IFCROOF": "$,.GABLE_ROOF.",
        "IFCSTAIR": "$,.STRAIGHT_RUN_STAIR.",
        "IFCSTAIRFLIGHT": "$,$,$,$,$",
        "IFCDOOR": "$,$,$",
        "IFCWINDOW": "$,$,$",
        "": "$",
    },
}


def real(x):
    return f"{x:.4f}".rstrip("0") if x != int(x) else f"{int(x)}."


def refs(items):
    return "(" + ",".join(items) + ")"


def text(name):
    """A string as STEP writes it."""
    return "".join(c if c.isascii() else f"\\X2\\{ord(c):04X}\\X0\\" for c in name)


def guid(name):
    """22 characters of the IFC alphabet, from the name."""
    n = int.from_bytes(hashlib.sha256(name.encode()).digest()[:16], "big")
    out = ""
    for _ in range(22):
        out, n = DIGITS[n % 64] + out, n // 64
    return DIGITS[int.from_bytes(name.encode()[:1], "big") % 4] + out[1:]


class Step:
    """The lines of a file."""

    def __init__(self, schema="IFC4", millimetres=False, space="", shared=True):
        """Identities are unique within `space`; with `shared`, equal points, directions and so on are written once."""
        self.schema, self.millimetres, self.space, self.shared = schema, millimetres, space, shared
        self.lines, self.known, self.seeds = [], {}, set()

    def add(self, line):
        self.lines.append(line)
        return f"#{len(self.lines)}"

    def once(self, line):
        if not self.shared:
            return self.add(line)
        if line not in self.known:
            self.known[line] = self.add(line)
        return self.known[line]

    def guid(self, seed):
        assert seed not in self.seeds or not self.shared, f"two things are called {seed}"
        self.seeds.add(seed)
        return guid(self.space + seed)

    def length(self, x):
        x = round(x, 6) + 0.0
        return real(round(1000 * x, 4) if self.millimetres else x)

    def point(self, *c):
        return self.once(f"IFCCARTESIANPOINT({refs([self.length(v) for v in c])})")

    def direction(self, *c):
        return self.once(f"IFCDIRECTION({refs([real(v + 0.0) for v in c])})")

    def axes(self, origin, z=None, x=None):
        """A frame in space: z up and x east where nothing else is said."""
        at, z = self.point(*origin), self.direction(*z) if z else self.up
        return self.once(f"IFCAXIS2PLACEMENT3D({at},{z},{self.direction(*x) if x else self.east})")

    def write(self, file, name, stamp, tool="demo/make_model.py"):
        view = "CoordinationView" if self.schema == "IFC2X3" else "ReferenceView_V1.2"
        head = f"ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('ViewDefinition [{view}]'),'2;1');\n"
        head += f"FILE_NAME('{name}','{stamp}',('asbuilt'),('asbuilt'),'{tool}','','');\n"
        file.write(head + f"FILE_SCHEMA(('{self.schema}'));\nENDSEC;\nDATA;\n")
        file.writelines(f"#{i + 1}={line};\n" for i, line in enumerate(self.lines))
        file.write("ENDSEC;\nEND-ISO-10303-21;\n")


class Model(Step):
    """A project of one building with its storeys; products stand in the storey that was begun last."""

    def __init__(self, project, building, storeys, **options):
        """`storeys`: name and elevation of each."""
        super().__init__(**options)
        self.products, self.materials, self.wholes = {}, {}, {}
        self.up, self.east = self.direction(0, 0, 1), self.direction(1, 0, 0)
        self.history = self._history()
        self._context()
        self.project = self.add(
            f"IFCPROJECT('{self.guid('project')}',{self.history},'{project}',$,$,$,$,({self.context}),{self.units})"
        )
        site_at = self.placement("$", (0, 0, 0))
        site = self._root("IFCSITE", "site", "Site", site_at, "$,$,.ELEMENT.,$,$,$,$,$")
        building_at = self.placement(site_at, (0, 0, 0))
        house = self._root("IFCBUILDING", "building", building, building_at, "$,$,.ELEMENT.,$,$,$")
        self.storeys, wholes = [], [(self.project, [site]), (site, [house])]
        for i, (name, z) in enumerate(storeys):
            at = self.placement(building_at, (0, 0, z))
            seed = "storey" if i == 0 else f"storey {i + 1}"
            entity = self._root("IFCBUILDINGSTOREY", seed, name, at, f"$,$,.ELEMENT.,{self.length(z)}")
            self.storeys.append((at, entity))
        for whole, parts in [*wholes, (house, [entity for _, entity in self.storeys])]:
            name = self.guid(whole + "".join(parts))
            self.add(f"IFCRELAGGREGATES('{name}',{self.history},$,$,{whole},{refs(parts)})")
        self.begin(0)

    def _history(self):
        """IFC2X3 asks for an owner; the time is that of the demo."""
        if self.schema != "IFC2X3":
            return "$"
        person, firm = self.add("IFCPERSON($,'asbuilt',$,$,$,$,$,$)"), self.add("IFCORGANIZATION($,'asbuilt',$,$,$)")
        both = self.add(f"IFCPERSONANDORGANIZATION({person},{firm},$)")
        tool = self.add(f"IFCAPPLICATION({firm},'1','demo/make_model.py','asbuilt')")
        return self.add(f"IFCOWNERHISTORY({both},{tool},$,.ADDED.,$,$,$,1795305600)")

    def _context(self):
        world = self.add(f"IFCAXIS2PLACEMENT3D({self.point(0, 0, 0)},{self.up},{self.east})")
        precision = "1.E-05" if not self.shared else "1.E-01" if self.millimetres else "1.E-04"
        self.context = self.add(f"IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,{precision},{world},$)")
        self.body = self.add(
            f"IFCGEOMETRICREPRESENTATIONSUBCONTEXT('Body','Model',*,*,*,*,{self.context},$,.MODEL_VIEW.,$)"
        )
        prefix = ".MILLI." if self.millimetres else "$"
        metre = self.add(f"IFCSIUNIT(*,.LENGTHUNIT.,{prefix},.METRE.)")
        radian = self.add("IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)")
        self.units = self.add(f"IFCUNITASSIGNMENT(({metre},{radian}))")

    def _root(self, ifc_class, seed, name, at, tail):
        return self.add(f"{ifc_class}('{self.guid(seed)}',{self.history},'{text(name)}',$,$,{at},{tail})")

    def begin(self, storey):
        self.storey_at, self.storey = self.storeys[storey]

    def placement(self, parent, origin, x=(1, 0, 0)):
        axes = self.once(f"IFCAXIS2PLACEMENT3D({self.point(*origin)},{self.up},{self.direction(*x)})")
        return self.add(f"IFCLOCALPLACEMENT({parent},{axes})")

    def place(self, origin, x=(1, 0)):
        """In the storey: x is where the product's own x axis points in plan."""
        return self.placement(self.storey_at, origin, (*x, 0))

    def tilted(self, origin, z, x, parent=None):
        """In the storey or in another frame, with its own z axis."""
        return self.add(f"IFCLOCALPLACEMENT({parent or self.storey_at},{self.axes(origin, z, x)})")

    def product(self, ifc_class, name, place, shape, material=None, tail=None, whole=None):
        """In the storey, or as a part of `whole`."""
        tails = TAILS[self.schema]
        tail = tail or tails.get(ifc_class, tails[""])
        e = self.add(f"{ifc_class}('{self.guid(name)}',{self.history},'{text(name)}',$,$,{place},{shape},{tail})")
        if whole:
            self.wholes.setdefault(whole, []).append(e)
        else:
            self.products.setdefault(self.storey, []).append(e)
        if material:
            self.materials.setdefault(material, []).append(e)
        return e

    def related(self, ifc_class, seed, *what):
        """A relation; `what` are its last attributes."""
        return self.add(f"{ifc_class}('{self.guid(seed)}',{self.history},$,$,{','.join(what)})")

    def opening(self, name, place, shape, host):
        tail = "$" if self.schema == "IFC2X3" else "$,.OPENING."
        hole = f"IFCOPENINGELEMENT('{self.guid(name)}',{self.history},'{text(name)}',$,$,{place},{shape},{tail})"
        o = self.add(hole)
        self.related("IFCRELVOIDSELEMENT", name + " rel", host, o)
        return o

    def property(self, e, name, pset, key, value):
        """A property set of one value; `value` with its type."""
        one = self.add(f"IFCPROPERTYSINGLEVALUE('{key}',$,{value},$)")
        values = self.add(f"IFCPROPERTYSET('{self.guid(name + ' pset')}',{self.history},'{pset}',$,({one}))")
        self.related("IFCRELDEFINESBYPROPERTIES", name + " rel", f"({e})", values)

    def finish(self):
        for i, (_, storey) in enumerate(self.storeys):
            seed = "contained" if i == 0 else f"contained {i + 1}"
            self.related("IFCRELCONTAINEDINSPATIALSTRUCTURE", seed, refs(self.products[storey]), storey)
        for whole, parts in self.wholes.items():
            self.related("IFCRELAGGREGATES", f"parts of {whole}", whole, refs(parts))
        for name, products in self.materials.items():
            more = "" if self.schema == "IFC2X3" else ",$,$"
            made = self.add(f"IFCMATERIAL('{text(name)}'{more})")
            self.related("IFCRELASSOCIATESMATERIAL", f"material {name}", refs(products), made)
