#!/usr/bin/env python3
"""M3C2 (Lague et al. 2013) by py4dgeo over a scan and the model sampled as a cloud: core points a second.

m3c2.py scan.xyz model.xyz CORE_POINTS     needs: py4dgeo numpy (PyPI)
"""
import sys
import time

import numpy as np
import py4dgeo

scan, model = (py4dgeo.Epoch(np.loadtxt(path)) for path in sys.argv[1:3])
every = max(1, len(model.cloud) // int(sys.argv[3]))
core = model.cloud[::every]
start = time.time()
m3c2 = py4dgeo.M3C2(epochs=(model, scan), corepoints=core, cyl_radius=0.05, max_distance=0.15, normal_radii=(0.1,))
distances, _ = m3c2.run()
seconds = time.time() - start
print(f"{len(scan.cloud)} points, {len(core)} core points, {np.isfinite(distances).sum()} with a distance: "
      f"{seconds:.1f} s, {len(core) / seconds:.0f} core points/s")
