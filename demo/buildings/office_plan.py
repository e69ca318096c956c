"""The office's plan: measures, and what repeats in its bays.

South of the corridor: office, meeting room behind glass, office, office, and so on; north: stairs and toilets, lounge,
an open-plan office of two bays behind a curtain wall.
"""

from .layers import BOARD, CONCRETE, PANEL, PARTITION, WOOL

BAY, WIDTH = 6.0, 14.4
# The corridor's walls: faces from south to north.
SOUTH, NORTH = (5.4, 5.5), (7.7, 7.8)
STOREY, SLAB, CLEAR = 3.6, 0.28, 3.32
# Upper faces of raised floor and of suspended ceiling.
FLOOR, CEILING = 0.16, 2.92
IN = BOARD.thickness
OUTSIDE = PANEL.thickness + WOOL.thickness + CONCRETE.thickness
THICK = sum(layer.thickness for layer in PARTITION)
DOOR = (1.01, 2.135)


class Floor:
    """One storey; names begin with its number."""

    def __init__(self, m, number, bays, is_top):
        self.m, self.number, self.bays, self.length, self.is_top = m, number, bays, bays * BAY, is_top

    def name(self, *parts):
        return " ".join([str(self.number), *map(str, parts)])

    def columns(self):
        """Their places and heights; the open-plan office has beams on them."""
        for k in range(self.bays):
            yield k * BAY + 0.7, 4.9, CLEAR
            if k % 4 == 1:
                yield k * BAY + 3.0, 11.1, CLEAR
            elif k % 4 > 1:
                yield k * BAY + 3.0, 11.1, CLEAR - 0.35

    def open_plans(self):
        """Pairs of bays behind a curtain wall: first bay, last bay."""
        return [(k, min(k + 1, self.bays - 1)) for k in range(2, self.bays, 4)]

    def curtain(self, first, last):
        """Where the curtain wall of an open-plan office begins and ends; a pier stands at the building's corner."""
        return first * BAY + 0.05, self.length - 0.6 if last == self.bays - 1 else (last + 1) * BAY - 0.05
