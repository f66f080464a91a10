#!/usr/bin/python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""The dam break of prm/benchmarks/dam_break_2d by PySPH of Debian (python3-pysph),
weakly compressible, with the settings of its own example dam_break_2d: Wendland's
quintic kernel, h = 1.3 dx, speed of sound 10 sqrt(2 g H), artificial viscosity 0.1,
adaptive steps. Writes curves.csv (t, front, height) and pysph.json.

    pysph_dam_break.py DX END FOLDER
"""

import glob
import json
import os
import shutil
import sys

import numpy as np
from pysph.base.kernels import WendlandQuintic
from pysph.base.utils import get_particle_array
from pysph.solver.application import Application
from pysph.solver.utils import load
from pysph.sph.integrator import PECIntegrator
from pysph.sph.scheme import WCSPHScheme

WIDTH, HEIGHT, TANK = 1.2, 0.6, (3.22, 3.0)
GRAVITY, DENSITY, SOUND, RATIO, VISCOSITY = 9.81, 1000.0, 10.0, 1.3, 0.1
LAYERS, FRONT_FROM, INTERVAL = 4, 0.025, 0.01


class DamBreak(Application):
    def __init__(self, dx, end, folder):
        self.dx, self.end = dx, end
        super().__init__(fname="dam", output_dir=folder)

    def create_particles(self):
        dx = self.dx
        columns, rows = (round(size / dx) + LAYERS for size in TANK)
        i, j = np.meshgrid(np.arange(-LAYERS, columns), np.arange(-LAYERS, rows))
        places = (np.stack([i.ravel(), j.ravel()]) + 0.5) * dx
        x, y = places
        inside = (x > 0) & (x < TANK[0]) & (y > 0)
        fluid = places[:, inside & (x < WIDTH) & (y < HEIGHT)]
        particles = [get_particle_array(name=name, x=at[0], y=at[1], h=RATIO * dx,
                                        m=DENSITY * dx * dx, rho=DENSITY)
                     for name, at in (("fluid", fluid), ("boundary", places[:, ~inside]))]
        self.scheme.setup_properties(particles)
        return particles

    def create_scheme(self):
        h, sound = RATIO * self.dx, SOUND * np.sqrt(2 * GRAVITY * HEIGHT)
        scheme = WCSPHScheme(["fluid"], ["boundary"], dim=2, rho0=DENSITY, c0=sound, h0=h,
                             hdx=RATIO, gy=-GRAVITY, alpha=VISCOSITY, beta=0.0, gamma=7.0,
                             hg_correction=True, update_h=True)
        scheme.configure_solver(kernel=WendlandQuintic(dim=2), integrator_cls=PECIntegrator,
                                dt=0.125 * h / sound, tf=self.end, adaptive_timestep=True,
                                n_damp=50, pfreq=10**9,
                                output_at_times=list(np.arange(0, self.end, INTERVAL)))
        return scheme


def curves(folder, dx):
    """(t, front, height) of each file."""
    rows = []
    for file in glob.glob(os.path.join(folder, "dam_*.hdf5")) + glob.glob(
            os.path.join(folder, "dam_*.npz")):
        data = load(file)
        fluid = data["arrays"]["fluid"]
        x, y = fluid.x, fluid.y
        high, left = y >= FRONT_FROM, x <= 2 * dx
        rows.append((float(data["solver_data"]["t"]),
                     float(x[high].max() + dx / 2) if high.any() else WIDTH,
                     float(y[left].max() + dx / 2) if left.any() else 0.0))
    return sorted(rows)


def main():
    dx, end, folder = float(sys.argv[1]), float(sys.argv[2]), sys.argv[3]
    output = os.path.join(folder, "pysph")
    shutil.rmtree(output, ignore_errors=True)
    program = DamBreak(dx, end, output)
    program.run(["--directory", output, "--detailed-output"])
    with open(os.path.join(folder, "curves.csv"), "w", encoding="utf-8") as file:
        file.write("t,front,height\n")
        for row in curves(output, dx):
            file.write(",".join("%.9g" % value for value in row) + "\n")
    particles = sum(len(array.x) for array in program.particles if array.name == "fluid")
    with open(os.path.join(folder, "pysph.json"), "w", encoding="utf-8") as file:
        json.dump({"steps": program.solver.count, "points": particles}, file)


if __name__ == "__main__":
    main()
