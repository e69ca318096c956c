"""The house's measures, of its shell's faces and of its roof."""

# Inner faces of the walls' structure.
LENGTH, WIDTH = 9.6, 7.2
CLEAR, SLAB = 2.75, 0.2
UPPER = CLEAR + SLAB
# Screed and parquet: their upper faces.
SCREED, FLOOR = 0.12, 0.135
IN = 0.015
CHIMNEY = (6.2, 4.4, 6.7, 4.9)
STAIRS = (0.9, 6.185, 4.8, 7.185)
MIDDLE = (3.985, 4.13)
# How far the outer wall reaches beyond the structure's inner face.
FACE = 0.35

SLOPE = 0.75
# Thickness of the rafters, of the slab where they are inside it, and of the tiles.
RAFTER, SKIN, TILES = 0.2, 0.36, 0.04
# Heights above the upper floor at the structure's inner face: wall's top, plane below the rafters, plane on them.
EAVES = 1.0
UNDER_RAFTERS = EAVES + 0.12 + 0.12 * SLOPE
UNDER_SLAB = UNDER_RAFTERS + RAFTER / 0.8
OVERHANG, VERGE, RIDGE = 0.9, 0.75, WIDTH / 2
