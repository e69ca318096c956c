#!/usr/bin/env python3
"""The loader's solids against IfcOpenShell's: boxes, areas, volumes, product by product.

    ifc_oracle.py ASBUILT MODEL.ifc …        (PGHOST, PGUSER, PGDATABASE: a scratch database)

Shares no code with the product. Circles are tessellated differently, so a product may differ by 0.5 % of its size.
Fails when nothing was compared.
"""
import csv
import io
import multiprocessing
import os
import subprocess
import sys

import ifcopenshell
import ifcopenshell.geom
import numpy as np

asbuilt, models = sys.argv[1], sys.argv[2:]
settings = ifcopenshell.geom.settings()
settings.set("use-world-coords", True)


def ours(source):
    query = f"""COPY (SELECT global_id, ifc_class, ab_min(ab_box(solid)), ab_max(ab_box(solid)), ab_area(solid),
        CASE WHEN ab_closedness(solid) <> 'open surface' THEN ab_volume(solid) END, properties ? 'part_of'
        FROM building_object WHERE source = '{source}' AND solid IS NOT NULL) TO STDOUT (FORMAT csv)"""
    text = subprocess.run(["psql", "-XAtqc", query], check=True, capture_output=True, text=True).stdout
    box = lambda t: np.array([float(v) for v in t.strip("{}").split(",")])
    return {r[0]: (r[1], box(r[2]), box(r[3]), float(r[4]), float(r[5]) if r[5] else None) for r in csv.reader(io.StringIO(text))}


def theirs(path):
    model = ifcopenshell.open(path)
    iterator = ifcopenshell.geom.iterator(settings, model, multiprocessing.cpu_count(), exclude=("IfcOpeningElement", "IfcSpace"))
    out = {}
    if not iterator.initialize():
        return out
    while True:
        shape = iterator.get()
        v = np.array(shape.geometry.verts).reshape(-1, 3)
        f = np.array(shape.geometry.faces).reshape(-1, 3)
        a, b, c = v[f[:, 0]], v[f[:, 1]], v[f[:, 2]]
        cross = np.cross(b - a, c - a)
        centre = v.mean(axis=0)
        volume = abs(np.einsum("ij,ij->i", a - centre, np.cross(b - centre, c - centre)).sum()) / 6
        area = np.linalg.norm(cross, axis=1).sum() / 2
        out[shape.guid] = (v.min(axis=0), v.max(axis=0), area, volume if balanced(v, f) else None)
        if not iterator.next():
            return out


def balanced(vertices, faces):
    """Whether every edge is matched by its reverse: only then is the other's volume one."""
    _, weld = np.unique(vertices.round(5), axis=0, return_inverse=True)
    f = weld.reshape(-1)[faces]
    edges = np.concatenate([f[:, [0, 1]], f[:, [1, 2]], f[:, [2, 0]]])
    edges = edges[edges[:, 0] != edges[:, 1]]
    forth = np.unique(edges, axis=0, return_counts=True)
    back = np.unique(edges[:, ::-1], axis=0, return_counts=True)
    return all(len(x) == len(y) and (x == y).all() for x, y in zip(forth, back))


total = worse = 0
for path in models:
    subprocess.run([asbuilt, "load", path], check=True, capture_output=True)
    mine, other = ours(os.path.basename(path)), theirs(path)
    both = mine.keys() & other.keys()
    bad = []
    for guid in both:
        ifc_class, lo, hi, area, volume = mine[guid]
        lo2, hi2, area2, volume2 = other[guid]
        size = np.linalg.norm(hi2 - lo2)
        off = max(np.abs(lo - lo2).max(), np.abs(hi - hi2).max())
        if off > 0.005 * size + 1e-4:
            bad.append(f"{ifc_class} {guid}: box off by {off:.4f} m")
        elif abs(area - area2) > 0.02 * area2 + 1e-4:
            bad.append(f"{ifc_class} {guid}: area {area:.4f}, IfcOpenShell {area2:.4f}")
        elif volume is not None and volume2 is not None and abs(volume - volume2) > 0.02 * volume2 + 1e-5:
            bad.append(f"{ifc_class} {guid}: volume {volume:.5f}, IfcOpenShell {volume2:.5f}")
    missing = other.keys() - mine.keys()
    print(f"{os.path.basename(path)}: {len(both)} compared, {len(bad)} differ, {len(missing)} only IfcOpenShell's")
    for line in bad[:10]:
        print("   ", line)
    total += len(both)
    worse += len(bad) + len(missing)
    if not both:
        sys.exit(f"{path}: nothing was compared")
print(f"{total} products compared, {worse} differ")
sys.exit(worse > 0.02 * total)
