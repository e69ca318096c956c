#!/usr/bin/env python3
"""Writes the demo building, a small pavilion, as IFC4: python3 demo/make_model.py > demo/pavilion.ifc
(and with the word office a storey of 24 rooms, for benches).

Plain Python, no libraries; the same file every time. Metres.
"""
import hashlib
import sys

LINES = []


def add(text):
    LINES.append(text)
    return f"#{len(LINES)}"


def real(x):
    return f"{x:.4f}".rstrip("0") if x != int(x) else f"{int(x)}."


def refs(items):
    return "(" + ",".join(items) + ")"


def guid(name):
    """22 characters of the IFC alphabet, from the name."""
    digits = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$"
    n = int.from_bytes(hashlib.sha256(name.encode()).digest()[:16], "big")
    out = ""
    for _ in range(22):
        out, n = digits[n % 64] + out, n // 64
    return digits[int.from_bytes(name.encode()[:1], "big") % 4] + out[1:]


def point(*c):
    return add(f"IFCCARTESIANPOINT({refs([real(v) for v in c])})")


def direction(*c):
    return add(f"IFCDIRECTION({refs([real(v) for v in c])})")


def placement(parent, origin, x=(1, 0, 0)):
    axes = add(f"IFCAXIS2PLACEMENT3D({point(*origin)},{UP},{direction(*x)})")
    return add(f"IFCLOCALPLACEMENT({parent},{axes})")


def extrusion(profile, height, offset=(0, 0, 0)):
    at = add(f"IFCAXIS2PLACEMENT3D({point(*offset)},{UP},{EAST})")
    solid = add(f"IFCEXTRUDEDAREASOLID({profile},{at},{UP},{real(height)})")
    shape = add(f"IFCSHAPEREPRESENTATION({BODY},'Body','SweptSolid',({solid}))")
    return add(f"IFCPRODUCTDEFINITIONSHAPE($,$,({shape}))")


def rectangle(x, y):
    at = add(f"IFCAXIS2PLACEMENT2D({point(0, 0)},$)")
    return add(f"IFCRECTANGLEPROFILEDEF(.AREA.,$,{at},{real(x)},{real(y)})")


def circle(r):
    at = add(f"IFCAXIS2PLACEMENT2D({point(0, 0)},$)")
    return add(f"IFCCIRCLEPROFILEDEF(.AREA.,$,{at},{real(r)})")


def product(ifc_class, name, place, shape, loa=None, tail="$,$"):
    e = add(f"{ifc_class}('{guid(name)}',$,'{name}',$,$,{place},{shape},{tail})")
    PRODUCTS.append(e)
    if loa:
        value = add(f"IFCPROPERTYSINGLEVALUE('LevelOfAccuracy',$,IFCLABEL('{loa}'),$)")
        pset = add(f"IFCPROPERTYSET('{guid(name + ' pset')}',$,'Pset_Survey',$,({value}))")
        add(f"IFCRELDEFINESBYPROPERTIES('{guid(name + ' rel')}',$,$,$,({e}),{pset})")
    return e


def box(ifc_class, name, lo, hi, loa=None):
    centre = ((lo[0] + hi[0]) / 2, (lo[1] + hi[1]) / 2, lo[2])
    shape = extrusion(rectangle(hi[0] - lo[0], hi[1] - lo[1]), hi[2] - lo[2])
    product(ifc_class, name, placement(STOREY_AT, centre), shape, loa)


def wall(name, a, b, thickness, openings=(), height=2.8):
    dx, dy = b[0] - a[0], b[1] - a[1]
    length = (dx * dx + dy * dy) ** 0.5
    place = placement(STOREY_AT, (a[0], a[1], 0), (dx / length, dy / length, 0))
    e = product("IFCWALL", name, place, extrusion(rectangle(length, thickness), height, (length / 2, 0, 0)))
    for i, (along, width, high, sill) in enumerate(openings):
        hole = f"{name} opening {i + 1}"
        at = placement(place, (along + width / 2, 0, sill))
        o = add(
            f"IFCOPENINGELEMENT('{guid(hole)}',$,'{hole}',$,$,{at},{extrusion(rectangle(width, 3 * thickness), high)},$,.OPENING.)"
        )
        add(f"IFCRELVOIDSELEMENT('{guid(hole + ' rel')}',$,$,$,{e},{o})")


def column(name, centre, radius, height=2.8):
    place = placement(STOREY_AT, (centre[0], centre[1], 0))
    product("IFCCOLUMN", name, place, extrusion(circle(radius), height))


PRODUCTS = []
UP, EAST = direction(0, 0, 1), direction(1, 0, 0)
WORLD = add(f"IFCAXIS2PLACEMENT3D({point(0, 0, 0)},{UP},{EAST})")
CONTEXT = add(f"IFCGEOMETRICREPRESENTATIONCONTEXT($,'Model',3,1.E-05,{WORLD},$)")
BODY = add(f"IFCGEOMETRICREPRESENTATIONSUBCONTEXT('Body','Model',*,*,*,*,{CONTEXT},$,.MODEL_VIEW.,$)")
METRE, RADIAN = add("IFCSIUNIT(*,.LENGTHUNIT.,$,.METRE.)"), add("IFCSIUNIT(*,.PLANEANGLEUNIT.,$,.RADIAN.)")
UNITS = add(f"IFCUNITASSIGNMENT(({METRE},{RADIAN}))")
PROJECT = add(f"IFCPROJECT('{guid('project')}',$,'asbuilt demo',$,$,$,$,({CONTEXT}),{UNITS})")
SITE_AT = placement("$", (0, 0, 0))
SITE = add(f"IFCSITE('{guid('site')}',$,'Site',$,$,{SITE_AT},$,$,.ELEMENT.,$,$,$,$,$)")
BUILDING_AT = placement(SITE_AT, (0, 0, 0))
BUILDING = add(f"IFCBUILDING('{guid('building')}',$,'Pavilion',$,$,{BUILDING_AT},$,$,.ELEMENT.,$,$,$)")
STOREY_AT = placement(BUILDING_AT, (0, 0, 0))
STOREY = add(f"IFCBUILDINGSTOREY('{guid('storey')}',$,'Ground floor',$,$,{STOREY_AT},$,$,.ELEMENT.,0.)")
for whole, part in ((PROJECT, SITE), (SITE, BUILDING), (BUILDING, STOREY)):
    add(f"IFCRELAGGREGATES('{guid(whole + part)}',$,$,$,{whole},({part}))")


def pavilion():
    box("IFCSLAB", "floor", (-0.25, -0.25, -0.3), (10.25, 7.25, 0.0), "LOA20")
    box("IFCSLAB", "roof", (-0.25, -0.25, 2.8), (10.25, 7.25, 3.05), "LOA20")
    wall("wall south", (-0.25, -0.125), (10.25, -0.125), 0.25, [(1.5, 1.6, 1.3, 0.9), (6.0, 2.4, 1.3, 0.9)])
    wall("wall north", (-0.25, 7.125), (10.25, 7.125), 0.25)
    wall("wall west", (-0.125, 0), (-0.125, 7), 0.25, [(2.6, 1.0, 2.1, 0.0)])
    wall("wall east", (10.125, 0), (10.125, 7), 0.25)
    wall("partition", (5.5, 0), (5.5, 4.6), 0.12, [(2.2, 0.9, 2.1, 0.0)])
    wall("screen wall", (7.2, 5.2), (10.0, 5.2), 0.15)
    column("column A", (2.8, 5.0), 0.18)
    column("column B", (5.5, 5.6), 0.18)
    column("column C", (7.8, 2.2), 0.18)
    box("IFCBEAM", "beam", (0.0, 4.88, 2.45), (5.4, 5.12, 2.8))
    box("IFCBUILDINGELEMENTPROXY", "store behind the wall", (3.0, 7.6, 0.0), (6.0, 9.0, 2.4))


def office(nx=6, ny=4, width=3.6, depth=4.2):
    """Rooms in a grid, about 200 objects: for benches."""
    for i in range(nx):
        for j in range(ny):
            x, y, room = i * width, j * depth, f"{i + 1}.{j + 1}"
            box("IFCSLAB", f"floor {room}", (x, y, -0.25), (x + width, y + depth, 0.0))
            box("IFCSLAB", f"ceiling {room}", (x, y, 2.8), (x + width, y + depth, 3.05))
            column(f"column {room}", (x + 0.7, y + 0.7), 0.15)
            box("IFCBEAM", f"beam {room}", (x + 0.1, y + 2.0, 2.5), (x + width - 0.1, y + 2.25, 2.8))
            box("IFCFURNISHINGELEMENT", f"cupboard {room}", (x + 2.4, y + 3.4, 0.0), (x + 3.4, y + 3.9, 1.8))
    for i in range(nx + 1):
        for j in range(ny):
            hole = [(1.5, 1.0, 2.1, 0.0)] if 0 < i < nx else [(1.2, 1.6, 1.3, 0.9)]
            wall(f"wall x{i}.{j + 1}", (i * width, j * depth + 0.06), (i * width, (j + 1) * depth - 0.06), 0.12, hole)
    for i in range(nx):
        for j in range(ny + 1):
            hole = [(1.2, 1.0, 2.1, 0.0)] if 0 < j < ny else []
            wall(f"wall y{i + 1}.{j}", (i * width, j * depth), ((i + 1) * width, j * depth), 0.12, hole)


office() if sys.argv[1:] == ["office"] else pavilion()
add(f"IFCRELCONTAINEDINSPATIALSTRUCTURE('{guid('contained')}',$,$,$,{refs(PRODUCTS)},{STOREY})")

print("ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION(('ViewDefinition [ReferenceView_V1.2]'),'2;1');")
print("FILE_NAME('pavilion.ifc','2026-11-22T00:00:00',('asbuilt'),('asbuilt'),'demo/make_model.py','','');")
print("FILE_SCHEMA(('IFC4'));\nENDSEC;\nDATA;")
for i, line in enumerate(LINES):
    print(f"#{i + 1}={line};")
print("ENDSEC;\nEND-ISO-10303-21;")
