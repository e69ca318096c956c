"""What stands in the house's rooms, and outside."""

from math import cos, radians, sin

from . import furniture, sanitary
from .body import corners
from .house_plan import CLEAR, FACE, FLOOR, IN, LENGTH, MIDDLE, WIDTH

TILES = 0.012

CLASSES = {
    "furniture": ("IFCFURNISHINGELEMENT", "Textile", "Stoff"),
    "wood": ("IFCFURNISHINGELEMENT", "Timber", "Holz"),
    "sanitary": ("IFCFLOWTERMINAL", "Ceramic", "Keramik"),
    "heater": ("IFCENERGYCONVERSIONDEVICE", "Plaster", "Stahl"),
    "lamp": ("IFCFLOWTERMINAL", "Lamp shade", "Kunststoff"),
}


def put(m, kind, name, maker, x, y, z=FLOOR, turn=0):
    """`turn` in degrees from facing north, anticlockwise."""
    ifc_class, style, material = CLASSES[kind]
    a = radians(turn)
    place = m.place((x, y, z), (round(cos(a), 6), round(sin(a), 6)))
    m.product(ifc_class, name, place, m.repeated(maker, style), material=material)


def fit_out(m, storey):
    if storey == 0:
        living(m)
        kitchen(m)
        bath(m)
        outside(m)
    else:
        upper(m)


def living(m):
    put(m, "furniture", "Sofa", furniture.sofa, 2.2, 0.75)
    put(m, "wood", "Couchtisch", low_table, 2.2, 2.0)
    put(m, "wood", "Esstisch", furniture.plain_table, 7.2, 1.9)
    for i, (dx, dy, turn) in enumerate(((-0.5, -0.75, 5), (0.5, -0.75, -10), (-0.5, 0.75, 180), (0.5, 0.75, 170))):
        put(m, "furniture", f"Stuhl {i + 1}", furniture.visitor_chair, 7.2 + dx, 1.9 + dy, turn=turn)
    put(m, "wood", "Anrichte", sideboard, 3.6, MIDDLE[0] - 0.225 - 0.022, turn=180)
    put(m, "lamp", "Leuchte Wohnen", sanitary.pendant, 7.2, 1.9, CLEAR)
    for i, x in enumerate((1.75, 7.75)):
        put(m, "heater", f"Heizkörper {i + 1}", sanitary.radiator, x, IN + 0.05)


def low_table():
    return furniture.cabinet(1.0, 0.6, 0.4, 1, 1)


def sideboard():
    return furniture.cabinet(1.8, 0.45, 0.8, 3, 1)


def kitchen(m):
    put(m, "wood", "Küchenzeile", furniture.counter, 3.6, MIDDLE[1] + 0.3)
    put(m, "wood", "Hochschrank", tall_cabinet, 5.42 - 0.01, MIDDLE[1] + 0.3)
    put(m, "lamp", "Leuchte Küche", sanitary.pendant, 3.6, 5.2, CLEAR)
    put(m, "heater", "Heizkörper 3", sanitary.radiator, IN + 0.05, 5.0, turn=-90)


def tall_cabinet():
    return furniture.cabinet(0.6, 0.6, 2.1, 1, 2)


def bath(m):
    north, east = WIDTH - IN, LENGTH - IN
    put(m, "sanitary", "WC", sanitary.toilet, 7.45, north - TILES, turn=180)
    put(m, "sanitary", "Waschtisch", sanitary.basin, east - TILES, 4.7, turn=90)
    put(m, "sanitary", "Badewanne", sanitary.bathtub, east - 0.375, 6.3, turn=90)
    put(m, "sanitary", "Dusche", sanitary.shower, 7.0725 + 0.46, MIDDLE[1] + 0.46)
    lo, hi = (east - TILES - 0.006, 4.4, 1.25), (east - TILES, 5.0, 1.95)
    m.box("IFCFURNISHINGELEMENT", "Spiegel", lo, hi, "Steel", material="Spiegel")


def outside(m):
    """Terrace, and a canopy of glass by its material over the front door."""
    outline = corners(2.0, -3.2, 8.0, -FACE)
    m.plate("IFCSLAB", "Terrasse", outline, -0.15, 0.0, style="Concrete", material="Stahlbeton", tail="$,.FLOOR.")
    face = WIDTH + FACE
    lo, hi = (4.9, face, 2.5), (6.5, face + 1.0, 2.52)
    m.box("IFCPLATE", "Vordach", lo, hi, None, material="Glas")
    for i, x in enumerate((5.1, 6.3)):
        body = m.rod([(x, face, 2.9), (x, face + 0.8, 2.53)], 0.01, "Steel")
        m.piece("IFCMEMBER", f"Zugstab {i + 1}", m.place((0, 0, 0)), body, material="Stahl")


def upper(m):
    east = LENGTH - IN
    put(m, "furniture", "Bett", furniture.bed, east - 0.06, 3.6, turn=90)
    put(m, "wood", "Kleiderschrank", furniture.cabinet, 5.05 + 0.226, 2.15, turn=-90)
    put(m, "wood", "Schreibtisch", furniture.desk, IN + 0.4, 3.6, turn=90)
    put(m, "furniture", "Stuhl 5", furniture.visitor_chair, 1.15, 3.6, turn=80)
    for i, x in enumerate((2.4, 7.6)):
        put(m, "heater", f"Heizkörper {i + 4}", sanitary.radiator, x, IN + 0.05)
    for i, x in enumerate((3.66, 6.06)):
        put(m, "lamp", f"Leuchte Dach {i + 1}", sanitary.pendant, x, 3.6, 2.515)
