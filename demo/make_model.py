#!/usr/bin/env python3
"""Writes the demo's buildings as IFC: plain Python without libraries, the same file every time.

    make_model.py > demo/pavilion.ifc           a small pavilion
    make_model.py office > FILE                 a storey of 24 equal rooms, for benches
    make_model.py office [--storeys N] [--bays N] [--stations FILE] OUT.ifc
    make_model.py house [--stations FILE] OUT.ifc

The office and the house of demo/models are written without options.
"""

import argparse
import sys
from pathlib import Path

from buildings import house, office, pavilion

STAMP = "2026-11-26T00:00:00"


def arguments():
    parser = argparse.ArgumentParser(description="The demo's buildings as IFC.")
    kinds = parser.add_subparsers(dest="kind")
    kinds.add_parser("pavilion")
    big = kinds.add_parser("office", help="rooms on a corridor; without OUT the bench's 24 equal rooms")
    big.add_argument("--storeys", type=int, default=1)
    big.add_argument("--bays", type=int, default=4, help="length of a storey in bays of 6 m")
    small = kinds.add_parser("house", help="a house with a raftered roof, IFC2X3 in millimetres")
    for one, nargs in ((big, "?"), (small, None)):
        one.add_argument("--stations", type=Path, help="write scanner positions to this file")
        one.add_argument("out", type=Path, nargs=nargs)
    return parser.parse_args()


def write(model, out, name):
    with open(out, "w", encoding="ascii", newline="\n") as file:
        model.write(file, name, STAMP)


def main():
    args = arguments()
    if args.kind == "house":
        write(house.house(), args.out, "house.ifc")
        places = house.stations()
    elif args.kind == "office" and args.out:
        write(office.office(args.storeys, args.bays), args.out, "office.ifc")
        places = office.stations(args.storeys, args.bays)
    else:
        model = pavilion.rooms() if args.kind == "office" else pavilion.pavilion()
        model.write(sys.stdout, "pavilion.ifc", "2026-11-22T00:00:00")
        return
    if args.stations:
        lines = [f"{x:.2f} {y:.2f} {z:.2f}\n" for x, y, z in places]
        args.stations.write_text("# Scanner positions, metres: x y z\n" + "".join(lines), encoding="ascii")


if __name__ == "__main__":
    main()
