#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Exact and semi-analytic references of the scenes in this folder.

    make_tables.py            write reference/*.csv beside this script
    make_tables.py --check    compare them with what would be written
    make_tables.py --series   print the series that stand in the scenes

Needs numpy and scipy. Sources of the formulas: README.md.
"""

import os
import sys

import numpy as np
from scipy.integrate import quad, solve_ivp
from scipy.special import wofz

HERE = os.path.dirname(os.path.abspath(__file__))
GRAVITY = 9.81


def drop(t, rate, force):
    """Semi-axes a, b of a drop that starts as the unit circle with u = (rate x,
    -rate y) in the field of force -force^2 (x, y), and its centre pressure over
    the density: a' = A a, b' = -A b, A' = (A^2 + force^2)(b^2 - a^2)/(a^2 + b^2)."""

    def derivative(_, state):
        a, b, strain = state
        return [strain * a, -strain * b,
                (strain**2 + force**2) * (b * b - a * a) / (a * a + b * b)]

    a, b, strain = solve_ivp(derivative, (0, t[-1]), [1, 1, rate], t_eval=t,
                             rtol=1e-12, atol=1e-13, method="DOP853").y
    assert np.abs(a * b - 1).max() < 1e-9
    energy = (strain**2 + force**2) * (a * a + b * b)
    assert np.abs(energy / energy[0] - 1).max() < 1e-9
    return a, b, (strain**2 + force**2) * a**2 * b**2 / (a**2 + b**2)


def column_top_and_base(t, height, speed):
    """Column at rest on a rigid bed, gravity from t = 0 on: displacement of
    the top [m] and pressure at the base over the density. Exact for p =
    -kappa (J - 1) at any strain, with heights in the undeformed column."""
    top = -GRAVITY * height**2 / (2 * speed**2) * np.ones_like(t)
    base = GRAVITY * height * np.ones_like(t)
    for n in range(4000):
        k = (2 * n + 1) * np.pi / (2 * height)
        amplitude = 2 * GRAVITY / (speed**2 * height * k**3)
        top += amplitude * (-1) ** n * np.cos(speed * k * t)
        base -= speed**2 * amplitude * k * np.cos(speed * k * t)
    return top, base


def viscous_wave(t, a0, rate0, k, nu, depth=1.0):
    """Elevation of a standing wave on deep water, a(0) = a0, a'(0) = rate0,
    irrotational at the start (Prosperetti 1981)."""
    e, w2 = nu * k * k, GRAVITY * k * depth
    z = np.roots([1, 0, 2 * e, 4 * e**1.5, e * e + w2])
    a = (4 * e * e / (8 * e * e + w2) * a0 * np.real(
        wofz(1j * np.sqrt(e * t)) * np.exp(-e * t))).astype(complex)
    for i in range(4):
        others = np.prod([z[j] - z[i] for j in range(4) if j != i])
        a += (z[i] / others * (w2 * a0 / (z[i] ** 2 - e) - rate0)
              * wofz(1j * z[i] * np.sqrt(t)) * np.exp(-e * t))
    return a.real


def wave_heights(t, eta):
    """Heights of the surface at crest and trough, to second order: the elevation of a standing wave, a sin(s t) cos(k x), has the
    second harmonic 1/2 k eta^2 cos(2 k x) (deep, inviscid, released from rest or
    flat)."""
    second = 0.5 * WAVE_K * eta**2
    return [t, eta + second, -eta + second]


def sway(t, length, depth, amplitude, omega):
    """Linear elevation at the left wall of a tank at rest that moves as amplitude
    cos(omega t) from t = 0 on, and the momentum along x over the density (by the
    motion of the centre of mass, rate of the integral of x eta)."""
    eta, momentum = np.zeros_like(t), np.zeros_like(t)
    for n in range(1, 120, 2):
        k = n * np.pi / length
        s2 = GRAVITY * k * np.tanh(k * depth)
        s = np.sqrt(s2)
        load = -4 / (n * np.pi) * np.tanh(k * depth) * amplitude * omega**2
        load /= s2 - omega**2
        eta += load * (np.cos(omega * t) - np.cos(s * t))
        momentum += -2 / k**2 * load * (s * np.sin(s * t) - omega * np.sin(omega * t))
    return eta, momentum


def wave_maker(t, x, length, depth, stroke, omega):
    """Linear elevation at x in a tank whose wall x = 0 moves as stroke/2 (1 -
    cos(omega t)) from t = 0 on, and the force over the density that the water puts
    on this wall (to positive x), at rest left out. Potential: the flow to uniform
    rise, d/dt displacement ((z + depth)^2 - (x - length)^2)/(2 length), and modes
    of the tank."""
    acceleration = stroke / 2 * omega**2 * np.cos(omega * t)
    rise = stroke / 2 * (1 - np.cos(omega * t)) * depth / length
    eta = rise.copy()
    # of -d(potential)/dt: flow of the rise less its mean at the surface, rise
    mean = depth**2 / (2 * length) - length / 6
    pressure = acceleration * (depth * mean + depth * length / 2 - depth**3
                               / (6 * length)) + GRAVITY * rise * depth
    for n in range(1, 800):
        k = n * np.pi / length
        s2 = GRAVITY * k * np.tanh(k * depth)
        load = s2 / (GRAVITY * length * k**2) * stroke * omega**2
        load /= s2 - omega**2
        mode = load * (np.cos(omega * t) - np.cos(np.sqrt(s2) * t))
        eta += mode * np.cos(k * x)
        # rate of the mode's potential: -g mode - coefficient * acceleration
        rate = -GRAVITY * mode + 2 / (length * k**2) * acceleration
        pressure -= rate * np.tanh(k * depth) / k
    return eta, -pressure


def channel(t, y, force, width, nu):
    """Speed between no-slip walls y = 0 and y = width, constant force from rest."""
    u = force / (2 * nu) * y * (width - y) * np.ones_like(t)
    for n in range(1, 400, 2):
        q = n * np.pi / width
        u -= (4 * force / (nu * width * q**3) * np.sin(q * y)
              * np.exp(-nu * q * q * t))
    return u


def power_law_speeds(t, places, half_width, force, n, gamma_0=1e-3, cells=800):
    """Speeds from rest at these distances from a no-slip wall, without shear at
    half_width: rho = K = 1, mu = (gamma^2 + gamma_0^2)^((n - 1)/2); finite volumes."""
    h = half_width / cells

    def derivative(_, u):
        shear = np.concatenate(([u[0] / (0.5 * h)], np.diff(u) / h, [0]))
        stress = (shear**2 + gamma_0**2) ** ((n - 1) / 2) * shear
        return force + np.diff(stress) / h

    u = solve_ivp(derivative, (0, t[-1]), np.zeros(cells), t_eval=t, method="LSODA",
                  rtol=1e-8, atol=1e-10, lband=1, uband=1).y
    middles = (np.arange(cells) + 0.5) * h
    return [np.array([np.interp(y, middles, u[:, k]) for k in range(len(t))])
            for y in places]


def huppert_factor():
    """eta_N of x_N = eta_N (g q^3/(3 nu))^(1/5) t^(1/5), and the integral of
    (1 - s^2)^(1/3)."""
    integral = quad(lambda s: (1 - s * s) ** (1 / 3), 0, 1)[0]
    return (1 / (0.3 ** (1 / 3) * integral)) ** 0.6, integral


WAVE_K, WAVE_NU = 2 * np.pi, 0.01 * np.sqrt(GRAVITY * 2 * np.pi) / (2 * np.pi) ** 2
WAVE_RATE = 0.016 * np.sqrt(GRAVITY * WAVE_K)


def tables():
    """Name of each file -> header, columns."""
    t = np.linspace(0, 2, 201)
    a, b, p = drop(t, 1.0, 0.0)
    yield "elliptic_drop", "t [s],a [m],b [m],p centre [Pa]", [t, a, b, 1000 * p]
    t = np.linspace(0, 5, 501)
    a, b, p = drop(t, 1.0, 1.0)
    yield "oscillating_drop", "t [s],a [m],b [m],p centre [Pa]", [t, a, b, 1000 * p]
    t = np.linspace(0, 0.26, 521)
    top, base = column_top_and_base(t, 1.0, np.sqrt(1000.0))
    yield "compressible_column", "t [s],top [m],p base [Pa]", [t, 1 + top, 1000 * base]
    t = np.linspace(0, 3, 301)
    eta = viscous_wave(np.maximum(t, 1e-12), 0.0, WAVE_RATE, WAVE_K, WAVE_NU)
    yield "standing_wave", "t [s],crest [m],trough [m]", wave_heights(t, eta)
    depth = np.tanh(WAVE_K * 0.5)  # corrects the frequency to first order
    eta = viscous_wave(np.maximum(t, 1e-12), 0.0, WAVE_RATE, WAVE_K, WAVE_NU, depth)
    yield "standing_wave_3d", "t [s],crest [m],trough [m]", wave_heights(t, eta)
    t = np.linspace(0, 6, 601)
    eta, momentum = sway(t, 1.73, 0.6, 0.002, 2 * np.pi / 1.8)
    yield ("sway_sloshing", "t [s],depth at the left wall [m],momentum [kg m/s]",
           [t, 0.6 + eta, 1000 * momentum])
    t = np.linspace(0, 6, 601)
    near, force = wave_maker(t, 1, 4, 0.5, 0.01, 2 * np.pi / 1.2)
    far, _ = wave_maker(t, 2, 4, 0.5, 0.01, 2 * np.pi / 1.2)
    yield ("wave_maker", "t [s],level x = 1 m [m],level x = 2 m [m],force [N]",
           [t, 0.5 + near, 0.5 + far, 1000 * force - 1226.25])
    t = np.linspace(0, 0.5, 101)
    yield ("poiseuille_startup", "t [s],speed y = 0.5 [m/s],speed y = 0.25 [m/s]",
           [t, channel(t, 0.5, 8.0, 1.0, 1.0), channel(t, 0.25, 8.0, 1.0, 1.0)])
    t = np.linspace(0, 1, 101)
    yield ("film_startup", "t [s],speed y = 0.9 [m/s],speed y = 0.5 [m/s]",
           [t, channel(t, 0.9, 2.0, 2.0, 1.0), channel(t, 0.5, 2.0, 2.0, 1.0)])
    t = np.linspace(0, 6, 201)
    yield ("channel_power_law", "t [s],speed y = 0.5 [m/s],speed y = 0.25 [m/s]",
           [t, *power_law_speeds(t, (0.5, 0.25), 0.5, 5.0, 0.5)])
    t = np.linspace(0, 6, 201)
    yield ("film_power_law", "t [s],speed y = 0.9 [m/s],speed y = 0.5 [m/s]",
           [t, *power_law_speeds(t, (0.9, 0.5), 1.0, 2.0, 1.5)])
    t = np.linspace(0, 7, 351)
    k = np.pi
    omega = np.sqrt(GRAVITY * k * 200 * np.tanh(0.5 * k) / 1800)
    yield ("internal_wave", "t [s],speed [m/s]",
           [t, -0.02 * omega * np.sin(omega * t)])


def series():
    """Series as muParser expressions, for "Exact" of the scenes."""
    terms = ["x^2-0.25"]
    for n in range(8):
        q = (2 * n + 1) * np.pi
        terms.append("%+.10g*cos(%.12g*x)*cosh(%.12g*y)"
                     % (8 * (-1) ** n / q**3 / np.cosh(q / 2), q, q))
    print("square patch, side 1, rho = omega = 1:\n" + "".join(terms))
    length, height = 1.2, 0.6
    terms = ["%g*(%g-y)" % (1000 * GRAVITY, height)]
    for n in range(8):
        k = (2 * n + 1) * np.pi / (2 * height)
        terms.append("-%.10g*cos(%.12g*y)*cosh(%.12g*x)"
                     % (2000 * GRAVITY / (height * k * k) / np.cosh(k * length), k, k))
    print("dam release, 1.2 m x 0.6 m, water:\n" + "".join(terms))
    print("Huppert: eta_N = %.6f, integral = %.6f" % huppert_factor())
    print("standing wave: nu = %.9g m^2/s, first speed = %.9g m/s" % (WAVE_NU, WAVE_RATE))


def main():
    if "--series" in sys.argv:
        series()
        return 0
    different = 0
    for name, header, columns in tables():
        path = os.path.join(HERE, "reference", name + ".csv")
        data = np.column_stack(columns)
        if "--check" in sys.argv:
            old = np.loadtxt(path, delimiter=",", skiprows=1)
            if old.shape != data.shape or not np.allclose(old, data, rtol=1e-6, atol=1e-8):
                print(path, "differs")
                different = 1
        else:
            np.savetxt(path, data, delimiter=",", header=header, comments="", fmt="%.8g")
    return different


if __name__ == "__main__":
    sys.exit(main())
