#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Manufactured solutions of the scenes manufactured_*.prm.

    manufactured.py           check the solutions, write reference/manufactured_*.inc
    manufactured.py --check   check them, and that the files are up to date

The body force that makes a chosen flow a solution is derived with sympy. It is
then checked at random points: volume, walls (no normal velocity, no shear
stress) and the balance of momentum by finite differences that know nothing of
the derivation. Needs numpy and sympy.
"""

import os
import sys

import numpy as np
import sympy as sp

HERE = os.path.dirname(os.path.abspath(__file__))
x, y, z, t, pi = *sp.symbols("x y z t"), sp.pi
COORDINATES = [x, y, z]


def text(expression):
    """As muParser wants it."""
    return str(expression).replace("**", "^").replace(" ", "")


def force(velocity, pressure, density, viscosity):
    """Body force of Dv/Dt = b + div(sigma)/density; the deviator is that of
    plane strain in 2D."""
    axes = COORDINATES[:len(velocity)]
    div = sum(sp.diff(v, c) for v, c in zip(velocity, axes))
    result = []
    for v, c in zip(velocity, axes):
        acceleration = sp.diff(v, t) + sum(
            w * sp.diff(v, d) for w, d in zip(velocity, axes))
        friction = viscosity * (sum(sp.diff(v, d, 2) for d in axes)
                                + sp.diff(div, c) / 3)
        result.append(acceleration + (sp.diff(pressure, c) - friction) / density)
    return result


def flow_2d():
    """Stream function that vanishes on the walls together with its second
    derivatives: no normal velocity, no shear stress."""
    psi = (sp.sin(pi * x) * sp.sin(pi * y) + sp.sin(2 * pi * x) * sp.sin(pi * y) / 2)
    psi *= (1 + sp.sin(2 * t) / 2) / (2 * pi)
    v = [sp.diff(psi, y), -sp.diff(psi, x)]
    p = sp.cos(pi * x) * sp.cos(2 * pi * y) * sp.cos(t)
    factor = [sp.factor_terms(sp.trigsimp(b)) for b in force(v, p, 1, sp.Rational(1, 100))]
    return v, p, factor, 1, 0.01, True


def flow_3d():
    """v = curl A, A = (sin y sin z cos x, -sin x sin z cos y, 0)/pi (arguments
    times pi): each component vanishes on its own walls."""
    s, c = [[f(pi * d) for d in COORDINATES] for f in (sp.sin, sp.cos)]
    time = (1 + sp.sin(2 * t) / 2) / 2
    potential = [s[1] * s[2] * c[0] / pi, -s[0] * s[2] * c[1] / pi, 0]
    v = [sp.diff(potential[2], y) - sp.diff(potential[1], z),
         sp.diff(potential[0], z) - sp.diff(potential[2], x),
         sp.diff(potential[1], x) - sp.diff(potential[0], y)]
    v = [time * sp.simplify(component) for component in v]
    p = c[0] * c[1] * c[2] * sp.cos(t)
    b = [sp.factor_terms(sp.trigsimp(b)) for b in force(v, p, 1, sp.Rational(1, 100))]
    return v, p, b, 1, 0.01, True


def flow_compressible():
    """x = X + a X (1 - X), y = Y + b Y (1 - Y): J is the product of two factors
    and p = -kappa (J - 1), kappa = 4. With the inverse map X(x, t)."""
    kappa, mu = 4, sp.Rational(1, 100)
    motions = [sp.sin(2 * t) / 10, -sp.sin(3 * t) / 10]
    inverse, stretch = [], []
    for c, a in zip((x, y), motions):
        q = sp.sqrt((1 + a) ** 2 - 4 * a * c)  # the derivative of x by X
        inverse.append(2 * c / (1 + a + q))
        stretch.append(q)
    v = [sp.diff(a, t) * c * (1 - c) for a, c in zip(motions, inverse)]
    jacobian = stretch[0] * stretch[1]
    p = -kappa * (jacobian - 1)
    return v, p, force(v, p, 1 / jacobian, mu), 1 / jacobian, 0.01, False


def check(flow):
    velocity, pressure, b, density, viscosity, solenoidal = flow
    dim = len(velocity)
    axes = COORDINATES[:dim]
    functions = [sp.lambdify(axes + [t], f, "numpy")
                 for f in [*velocity, pressure, sp.sympify(density), *b]]
    evaluate = lambda X: [f(*X) * np.ones(X.shape[1]) for f in functions]  # noqa: E731
    random = np.random.default_rng(1)
    X = random.uniform(0.1, 0.9, (dim + 1, 200))
    h = 1e-4

    def at(*shifts):
        return evaluate(X + h * sum(s * np.eye(dim + 1)[i][:, None] for s, i in shifts))

    here = at((0, 0))
    v = np.array(here[:dim])
    plus, minus = ([at((s, i)) for i in range(dim + 1)] for s in (1, -1))
    D = lambda i, c: (plus[i][c] - minus[i][c]) / (2 * h)  # noqa: E731
    rho = here[dim + 1]
    mass = D(dim, dim + 1) + sum(v[i] * D(i, dim + 1) for i in range(dim)) + rho * sum(
        D(i, i) for i in range(dim))
    assert np.abs(mass).max() < 1e-5, "mass"
    if solenoidal:
        assert np.abs(sum(D(i, i) for i in range(dim))).max() < 1e-5, "divergence"
    for c in range(dim):
        acceleration = D(dim, c) + sum(v[i] * D(i, c) for i in range(dim))
        laplace = sum(plus[i][c] + minus[i][c] - 2 * v[c] for i in range(dim)) / h**2
        grad_div = 0
        for i in range(dim):
            if i == c:
                grad_div = grad_div + (plus[c][c] + minus[c][c] - 2 * v[c]) / h**2
            else:
                grad_div = grad_div + (at((1, i), (1, c))[i] - at((1, i), (-1, c))[i]
                                       - at((-1, i), (1, c))[i] + at((-1, i), (-1, c))[i]) / (4 * h * h)
        residual = rho * (acceleration - here[dim + 2 + c]) + D(c, dim) - viscosity * (
            laplace + grad_div / 3)
        assert np.abs(residual).max() < 1e-4, f"momentum {c}: {np.abs(residual).max()}"
    for wall in range(dim):
        for place in (0.0, 1.0):
            X[:dim] = random.uniform(0.1, 0.9, (dim, 200))
            X[wall] = place
            assert np.abs(at((0, 0))[wall]).max() < 1e-12, "normal velocity"
            for c in range(dim):  # symmetric continuation: no shear stress
                if c != wall and place == 0.0:
                    f = sp.lambdify(axes + [t], sp.diff(velocity[c], axes[wall]), "numpy")
                    assert np.abs(f(*X) * np.ones(200)).max() < 1e-12, "shear stress"


def write(flow):
    velocity, pressure, b, *_ = flow
    v, p, b = ["; ".join(text(f) for f in part) for part in (velocity, [pressure], b)]
    start = "; ".join(text(f.subs(t, 0)) for f in velocity)
    return f"""# SPDX-License-Identifier: LGPL-2.1-or-later
# Written by ../manufactured.py.

subsection Body force
  set Acceleration = {b}
end

subsection Fluid body all
  set Velocity = {start}
end

subsection Error velocity
  set Exact = {v}
end

subsection Error pressure
  set Exact = {p}
end
"""


def main():
    for name, flow in (("2d", flow_2d()), ("compressible", flow_compressible()),
                       ("3d", flow_3d())):
        check(flow)
        content = write(flow)
        path = os.path.join(HERE, "reference", f"manufactured_{name}.inc")
        if "--check" in sys.argv:
            with open(path, encoding="utf-8") as file:
                assert file.read() == content, f"{path} is not up to date"
        else:
            with open(path, "w", encoding="utf-8") as file:
                file.write(content)
        print(f"{name}: checked, {len(content)} characters")


if __name__ == "__main__":
    main()
