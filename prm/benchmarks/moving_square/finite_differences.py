#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Drag of the moving square by another method (numpy, scipy).

finite_differences.py > reference/finite_differences.csv

Staggered finite differences, second order, explicit in time, on a grid that goes with the
square; upper half. Until 0.6 s (the square goes 0.13) the walls of the box go with it
too, from 1.5 s on (a second run) the box is long instead, with its ends 4 behind and 8 ahead.
"""
import math
import sys

import numpy as np
import scipy.sparse as sp
from scipy.sparse.linalg import splu

START = 0.5256521770


def speed(t):
    return 0.5 * (math.erf(5 * (t - START)) + math.erf(5 * START))


def laplacian(fluid, index):
    """Of the cells with fluid, times the square of their edge."""
    number = fluid.sum()
    rows, columns, diagonal = [], [], np.zeros(number)
    for a, b in ((index[:-1], index[1:]), (index[:, :-1], index[:, 1:])):
        both = (a >= 0) & (b >= 0)
        p, q = a[both], b[both]
        rows += [p, q]
        columns += [q, p]
        np.add.at(diagonal, p, 1)
        np.add.at(diagonal, q, 1)
    diagonal[0] += 1  # the level of the pressure
    ones = np.ones(sum(map(len, rows)))
    everything = np.arange(number)
    return sp.csc_matrix((np.concatenate([ones, -diagonal]), (
        np.concatenate([*rows, everything]), np.concatenate([*columns, everything]))))


def drag(n, dt, left, right, times, viscosity=0.01):
    """Drag of pressure and of friction at the times, in rho U^2 D/2; n cells a side."""
    h = 1 / n
    i0, i1, top = left * n, (left + 1) * n, n // 2
    nx, ny = (left + 1 + right) * n, 5 * n // 2
    fluid = np.ones((nx, ny), bool)
    fluid[i0:i1, :top] = False
    index = -np.ones((nx, ny), int)
    index[fluid] = np.arange(fluid.sum())
    solver = splu(laplacian(fluid, index), permc_spec="MMD_AT_PLUS_A")
    u, v = np.zeros((nx + 1, ny)), np.zeros((nx, ny + 1))
    u_solid, v_solid = np.zeros_like(u, bool), np.zeros_like(v, bool)
    u_solid[i0:i1 + 1, :top] = True
    v_solid[i0:i1, :top + 1] = True
    for step in range(1, round(times[-1] / dt) + 1):
        w = speed((step - 1) * dt)
        # values beyond walls and the plane of symmetry y = 0
        a = np.pad(u, ((0, 0), (1, 1)))
        a[:, 0], a[:, -1] = u[:, 0], -u[:, -1]
        a[i0 + 1:i1, top] = 2 * w - a[i0 + 1:i1, top + 1]
        b = np.pad(v, ((1, 1), (0, 0)))
        b[0], b[-1] = -v[0], -v[-1]
        ahead, behind = b[2:].copy(), b[:-2].copy()
        ahead[i0 - 1, :top] = -v[i0 - 1, :top]
        behind[i1, :top] = -v[i1, :top]
        # momentum without pressure, seen from the square
        du, dv = np.zeros_like(u), np.zeros_like(v)
        mean = 0.25 * (v[1:, 1:] + v[:-1, 1:] + v[1:, :-1] + v[:-1, :-1])
        du[1:-1] = (
            viscosity * (u[2:] + u[:-2] + a[1:-1, 2:] + a[1:-1, :-2] - 4 * u[1:-1]) / h**2
            - (u[1:-1] - w) * (u[2:] - u[:-2]) / (2 * h) - mean * (a[1:-1, 2:] - a[1:-1, :-2]) / (2 * h))
        mean = 0.25 * (u[1:, 1:] + u[:-1, 1:] + u[1:, :-1] + u[:-1, :-1])
        dv[:, 1:-1] = (
            viscosity * ((ahead + behind)[:, 1:-1] + v[:, 2:] + v[:, :-2] - 4 * v[:, 1:-1]) / h**2
            - (mean - w) * (ahead - behind)[:, 1:-1] / (2 * h) - v[:, 1:-1] * (v[:, 2:] - v[:, :-2]) / (2 * h))
        shear = viscosity * (w - u[i0:i1 + 1, top]) / (h / 2)
        friction = 2 * 2 * h * (shear.sum() - 0.5 * (shear[0] + shear[-1]))
        u, v, w = u + dt * du, v + dt * dv, speed(step * dt)
        u[u_solid], v[v_solid] = w, 0
        u[0] = u[-1] = 0
        v[:, 0] = v[:, -1] = 0
        pressure = np.zeros((nx, ny))
        pressure[fluid] = solver.solve(((u[1:] - u[:-1] + v[:, 1:] - v[:, :-1]) * h / dt)[fluid])
        u[1:-1] -= dt * (pressure[1:] - pressure[:-1]) / h * ~u_solid[1:-1]
        v[:, 1:-1] -= dt * (pressure[:, 1:] - pressure[:, :-1]) / h * ~v_solid[:, 1:-1]
        if np.isclose(step * dt, times).any():
            faces = (1.5 * (pressure[i1, :top] - pressure[i0 - 1, :top])
                     - 0.5 * (pressure[i1 + 1, :top] - pressure[i0 - 2, :top]))
            yield (step - 0.5) * dt, 2 * 2 * h * faces.sum(), friction


def main():
    print("t [-],drag of pressure [-],drag of friction [-],drag [-]")
    for run in ((64, 0.001, 1, 8, np.arange(1, 25) * 0.025), (32, 0.004, 4, 8, np.arange(6, 16) * 0.2 + 0.4)):
        for t, pressure, friction in drag(*run):
            print("%.4f,%.3f,%.3f,%.3f" % (t, pressure, friction, pressure + friction))
            sys.stdout.flush()


if __name__ == "__main__":
    main()
