"""Walls of layers, each layer a product of its own, with holes through all of them or some."""

from math import dist
from typing import NamedTuple


class Layer(NamedTuple):
    name: str
    thickness: float
    ifc_class: str
    material: str
    style: str
    kind: str = ""
    foot: float = 0.0


class Hole(NamedTuple):
    """In a wall's own frame: along it, and above its foot. Layers named in `uncut` close it."""

    along: float
    sill: float
    width: float
    height: float
    uncut: tuple = ()


CONCRETE = Layer("concrete", 0.2, "IFCWALL", "Concrete", "Concrete")
STUDS = Layer("studs", 0.075, "IFCWALL", "Metal studs", "Steel")
BOARD = Layer("board", 0.0125, "IFCCOVERING", "Plaster board", "Plaster", "CLADDING")
WOOL = Layer("insulation", 0.14, "IFCCOVERING", "Glass wool", "Insulation", "INSULATION", -0.28)
PANEL = Layer("cladding", 0.04, "IFCCOVERING", "Fibre cement", "Cladding", "CLADDING", -0.28)
TILES = Layer("tiles", 0.012, "IFCCOVERING", "Tiles", "Ceramic", "CLADDING")

PARTITION = [BOARD._replace(name="board right"), STUDS, BOARD._replace(name="board left")]


class Wall:
    """Of the layer that carries: the product, its placement, and the IFC openings of its holes."""

    product: str
    place: str
    openings: list


def wall(m, name, a, b, z, height, layers, y=0.0, holes=(), reach=None, carries=None, clips=()):
    """From a to b in plan; its layers one after the other to the left of this line, from `y` on, with holes in them.

    `reach` tells how much longer a layer is at start and end, by its two faces' y; `carries` is the layer whose holes
    are filled; `clips` are planes (point, normal) in the wall's frame, above which it ends.
    """
    length = dist(a, b)
    along, out = ((b[0] - a[0]) / length, (b[1] - a[1]) / length), Wall()
    for layer in layers:
        faces = (y, y + layer.thickness)
        start, end = reach(*faces) if reach else (0.0, 0.0)
        body = m.box_item((-start, faces[0], layer.foot), (length + end, faces[1], height))
        for point, normal in clips:
            body = m.clipped(body, point, normal)
        m.styled(body, layer.style)
        full, place = f"{name} {layer.name}", m.place((*a, z), along)
        tail = f"$,.{layer.kind}." if layer.kind else None
        e = m.piece(layer.ifc_class, full, place, body, material=layer.material, tail=tail)
        cut = holes_in(m, full, place, e, faces, holes, layer.name)
        if layer.name == (carries or layers[len(layers) // 2].name):
            out.product, out.place, out.openings = e, place, cut
        y = faces[1]
    return out


def holes_in(m, name, place, host, faces, holes, layer):
    out = []
    for i, hole in enumerate(holes):
        if layer in hole.uncut:
            continue
        lo = (hole.along, faces[0] - 0.05, hole.sill)
        hi = (hole.along + hole.width, faces[1] + 0.05, hole.sill + hole.height)
        seed = f"{name} opening {i + 1}"
        out.append(m.opening(seed, m.placement(place, (0, 0, 0)), m.shape(m.box_item(lo, hi)), host))
    return out
