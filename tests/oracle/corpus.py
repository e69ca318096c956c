#!/usr/bin/env python3
"""Every file of a folder, read by asbuilt and by readers that share no code with it; prints the differences.

    corpus.py ASBUILT DIR        (the program; a folder, read with all below it)

E57 by pye57, LAS and LAZ by laspy, IFC by IfcOpenShell and, where node has it, web-ifc: each is skipped, loudly, where it
is not installed. Files that both refuse agree. No database. Ends with 1 where something differs.
"""
import importlib.util
import json
import multiprocessing
import os
import subprocess
import sys

import numpy as np

asbuilt, folder = sys.argv[1], sys.argv[2]
HAS = {name: importlib.util.find_spec(name) is not None for name in ("pye57", "laspy", "ifcopenshell")}
SECONDS = 300
# asbuilt keeps a coordinate to 0.05 mm.
BOX_M = 1e-3


def ours_scan(path):
    said = subprocess.run([asbuilt, "inspect", "--format", "json", "--min-range", "0", "--keep-noise", path], capture_output=True, text=True)
    found = json.loads(said.stdout)[0]
    if found["error"]:
        return found["error"]
    scans = [s for s in found["scans"] if s["box"]]
    notes = [n for s in scans for n in s["notes"]]
    dropped = any("dropped" in n for n in notes)
    boxes = np.array([s["box"] for s in scans])
    return sum(s["returns"] for s in scans), boxes[:, 0].min(axis=0), boxes[:, 1].max(axis=0), dropped, notes


def pye57_scan(path):
    import pye57

    file, points = pye57.E57(path), []
    for i in range(file.scan_count):
        scan = file.read_scan(i, transform=True, ignore_missing_fields=True)
        points.append(np.c_[scan["cartesianX"], scan["cartesianY"], scan["cartesianZ"]])
    return box(np.concatenate(points))


def laspy_scan(path):
    import laspy

    with laspy.open(path) as file:
        las = file.read()
    # Units are asbuilt's to convert; what is compared then is the number of points.
    return box(np.c_[np.asarray(las.x), np.asarray(las.y), np.asarray(las.z)])


def box(points):
    points = points[np.isfinite(points).all(axis=1)]
    return len(points), points.min(axis=0), points.max(axis=0)


def ours_model(path):
    said = subprocess.run([asbuilt, "mesh-ifc", "--table", path], capture_output=True, text=True)
    if said.returncode:
        return said.stderr.strip()
    rows = [json.loads(line) for line in said.stdout.splitlines()]
    return {r["global_id"]: (np.array(r["box"][:3]), np.array(r["box"][3:]), r["class"]) for r in rows if r.get("box")}


def ifcopenshell_model(path):
    import ifcopenshell
    import ifcopenshell.geom

    settings = ifcopenshell.geom.settings()
    settings.set("use-world-coords", True)
    skipped = ("IfcOpeningElement", "IfcSpace")
    # The iterator does not keep the model alive.
    model = ifcopenshell.open(path)
    iterator = ifcopenshell.geom.iterator(settings, model, multiprocessing.cpu_count(), exclude=skipped)
    out = {}
    if iterator.initialize():
        while True:
            shape = iterator.get()
            vertices = np.array(shape.geometry.verts).reshape(-1, 3)
            if len(vertices):
                out[shape.guid] = (vertices.min(axis=0), vertices.max(axis=0), shape.type)
            if not iterator.next():
                break
    return out


def attempt(read, path):
    """What a reader gives, or why it gives nothing."""
    try:
        return read(path)
    except Exception as error:  # whatever a reader of others raises is an answer
        return f"{type(error).__name__}: {error}"


def apart(read, path):
    """The same in a process of its own: what kills or hangs a reader of others is an answer too."""
    here, there = multiprocessing.Pipe(duplex=False)
    worker = multiprocessing.Process(target=lambda: there.send(attempt(read, path)))
    worker.start()
    there.close()
    try:
        return here.recv() if here.poll(SECONDS) else f"no answer in {SECONDS} s"
    except EOFError:
        return "its process died"
    finally:
        worker.kill()
        worker.join()


def compare_scans(mine, other):
    if isinstance(mine, str) or isinstance(other, str):
        return both_refuse(mine, other)
    count, low, high, dropped, notes = mine
    if count != other[0] and not (dropped and count < other[0]):
        return [f"{count} points, the other {other[0]}"]
    converted = any("converted" in n for n in notes)
    off = max(np.abs(low - other[1]).max(), np.abs(high - other[2]).max())
    if off > BOX_M and not converted and not dropped:
        return [f"box off by {off:.4f} m"]
    return []


def compare_models(mine, other):
    if isinstance(mine, str) or isinstance(other, str):
        return both_refuse(mine, other)
    out = [f"{other[g][2]} {g}: only the other's" for g in other.keys() - mine.keys()]
    for guid in mine.keys() & other.keys():
        size = np.linalg.norm(other[guid][1] - other[guid][0])
        off = max(np.abs(mine[guid][0] - other[guid][0]).max(), np.abs(mine[guid][1] - other[guid][1]).max())
        # Circles are cut into other corners.
        if off > 0.005 * size + BOX_M:
            out.append(f"{mine[guid][2]} {guid}: box off by {off:.4f} m")
    return out


def both_refuse(mine, other):
    if isinstance(mine, str) and isinstance(other, str):
        return []
    if isinstance(mine, str):
        return [f"refused ({mine.splitlines()[0][:160]}), the other reads it"]
    return [f"read, the other refuses it ({other.splitlines()[0][:160]})"]


READERS = {
    ".e57": ("pye57", ours_scan, pye57_scan, compare_scans),
    ".las": ("laspy", ours_scan, laspy_scan, compare_scans),
    ".laz": ("laspy", ours_scan, laspy_scan, compare_scans),
    ".ifc": ("ifcopenshell", ours_model, ifcopenshell_model, compare_models),
}


def main():
    for name, there in HAS.items():
        if not there:
            print(f"SKIPPED: {name} is not installed; its files are not compared")
    print("SKIPPED: web-ifc (npm) is not compared yet")
    files = sorted(os.path.join(at, name) for at, _, names in os.walk(folder) for name in names)
    compared = differing = 0
    for path in files:
        reader = READERS.get(os.path.splitext(path)[1].lower())
        if reader is None or not HAS[reader[0]]:
            continue
        name, ours, theirs, compare = reader
        compared += 1
        found = compare(attempt(ours, path), apart(theirs, path))
        differing += bool(found)
        for line in found[:10]:
            print(f"{os.path.relpath(path, folder)} [{name}]: {line}")
        if len(found) > 10:
            print(f"{os.path.relpath(path, folder)} [{name}]: … and {len(found) - 10} more")
    print(f"{compared} files compared, {differing} differ")
    return 1 if differing or not compared else 0


sys.exit(main())
