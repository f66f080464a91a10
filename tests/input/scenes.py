# SPDX-License-Identifier: LGPL-2.1-or-later
"""The scene that tests of the input vary: a body in a box."""


def box_scene(upper="1.0, 0.5", cell="0.1", water="0.4, 0.3", end="0.02", step="0.01",
              shape=None, gravity=None, more=""):
    """As many dimensions as `upper` has coordinates; the body: a box from the origin, or
    the entries `shape`, then without gravity. `more`: lines after those of the body."""
    dim = upper.count(",") + 1
    lower = ", ".join("0" * dim)
    gravity = gravity or "; ".join(["0"] * (dim - 1) +
                                   ["-9.81" if shape is None else "0"])
    if shape is None:
        shape = f"set Lower corner = {lower}\nset Upper corner = {water}"
    shape = "\n".join(f"  {line}" for line in shape.splitlines())
    return f"""\
set Dimension = {dim}
subsection Grid
  set Lower corner = {lower}
  set Upper corner = {upper}
  set Cell size    = {cell}
end
subsection Body force
  set Acceleration = {gravity}
end
subsection Fluid
  set Density           = 1000
  set Dynamic viscosity = 0.001
  set Bulk modulus      = infinite
end
subsection Fluid body column
{shape}
{more}end
subsection Time
  set End time = {end}
  set Step     = {step}
end
"""
