#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact solution of the ellipsoidal drop; writes reference/ellipsoid.csv.

A drop of an inviscid fluid without gravity, x^2/a^2 + y^2/b^2 + z^2/c^2 < 1,
whose velocity is (A x, B y, C z) with A + B + C = 0 keeps that form, because a
pressure pc (1 - x^2/a^2 - y^2/b^2 - z^2/c^2) vanishes on the surface and has a
linear gradient. The equations of motion give for each axis

    a' = A a,    A' = -A^2 + 2 pc/(rho a^2),

and A' + B' + C' = 0 the pressure in the centre

    pc = rho/2 (A^2 + B^2 + C^2)/(1/a^2 + 1/b^2 + 1/c^2).

Volume (abc) and kinetic energy, proportional to (A a)^2 + (B b)^2 + (C c)^2,
are constant, which is checked.
"""

import os

import numpy

RADIUS = 1.0
DENSITY = 1000.0
RATES = numpy.array([1.0, 0.0, -1.0])  # [1/s]
END, STEPS, WRITTEN = 1.0, 4000, 40


def centre_pressure(axes, rates):
    return 0.5 * DENSITY * numpy.sum(rates**2) / numpy.sum(axes**-2)


def derivative(y):
    axes, rates = y[:3], y[3:]
    p = centre_pressure(axes, rates)
    return numpy.concatenate([rates * axes, -(rates**2) + 2 * p / (DENSITY * axes**2)])


def solve():
    """Rows of t, a, b, c, pc by the classical Runge-Kutta method."""
    y = numpy.concatenate([numpy.full(3, RADIUS), RATES])
    dt, rows = END / STEPS, []
    energy = numpy.sum((y[:3] * y[3:]) ** 2)
    for i in range(STEPS + 1):
        if i % (STEPS // WRITTEN) == 0:
            rows.append([i * dt, *y[:3], centre_pressure(y[:3], y[3:])])
        k1 = derivative(y)
        k2 = derivative(y + 0.5 * dt * k1)
        k3 = derivative(y + 0.5 * dt * k2)
        k4 = derivative(y + dt * k3)
        y = y + dt / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
        assert abs(numpy.prod(y[:3]) - RADIUS**3) < 1e-11
        assert abs(numpy.sum((y[:3] * y[3:]) ** 2) - energy) < 1e-11
        assert abs(numpy.sum(y[3:])) < 1e-11
    return rows


if __name__ == "__main__":
    here = os.path.dirname(os.path.abspath(__file__))
    with open(os.path.join(here, "reference", "ellipsoid.csv"), "w") as file:
        file.write("t [s],a [m],b [m],c [m],centre pressure [Pa]\n")
        for row in solve():
            file.write(",".join("%.9g" % value for value in row) + "\n")
