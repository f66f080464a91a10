# SPDX-License-Identifier: LGPL-2.1-or-later
"""Views in three dimensions drawn by PyVista, for contrib/pictures --pyvista."""

import importlib.util
import os
import subprocess
import sys

import numpy

ENVIRONMENT = os.path.normpath(
    os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "build", "pyvista"))
CLEAR = 0.6  # opacity of a fluid with others inside
GLASS = 0.15  # opacity of solids that hold the fluid
SIZE = (1400, 800)  # [pixels]
REFUSED = """pictures: PyVista is missing, and nothing is downloaded unasked. Debian 13 has it
(apt-get install python3-pyvista); or start this on a terminal to be asked about a
download from PyPI; or leave out --pyvista."""


def enter_environment():
    """Begins the script anew with an interpreter that has PyVista, if this one has
    none; asks before anything is downloaded."""
    # A display that does not answer makes VTK stop; without one it draws in memory.
    os.environ.pop("DISPLAY", None)
    if importlib.util.find_spec("pyvista"):
        return
    python = os.path.join(ENVIRONMENT, "bin", "python")
    test = [python, "-c", "import pyvista, matplotlib"]
    if not os.path.exists(python) or subprocess.call(test, stderr=subprocess.DEVNULL):
        install(python)
    if "SEICHE_PYVISTA" in os.environ:
        sys.exit("pictures: PyVista in %s cannot be used; remove that folder" % ENVIRONMENT)
    os.environ["SEICHE_PYVISTA"] = "1"
    os.execv(python, [python] + sys.argv)


def install(python):
    """PyVista from PyPI into build/pyvista if the user says yes."""
    if not sys.stdin.isatty():
        sys.exit(REFUSED)
    answer = input("PyVista is missing. Download it with VTK from PyPI into %s (800 MB)? [y/N] "
                   % ENVIRONMENT)
    if answer.strip().lower() not in ("y", "yes"):
        sys.exit(REFUSED)
    for command in ([sys.executable, "-m", "venv", ENVIRONMENT],
                    [python, "-m", "pip", "install", "--quiet", "pyvista", "matplotlib"]):
        if subprocess.call(command):
            sys.exit("pictures: PyVista cannot be installed; leave out --pyvista")


def colours_of(stage, frame, fluid):
    """Options of a mesh: coloured by its values, or all of it as this fluid."""
    from seiche_stage import COLOURS, FIELDS, fluid_colour

    if not frame.known:
        return {"color": fluid_colour(fluid)}
    return {
        "scalars": "value", "clim": stage.limits, "cmap": COLOURS[stage.name],
        "scalar_bar_args": {"title": FIELDS[stage.name] + "\n", "color": "black", "vertical": True,
                            "position_x": 0.9, "position_y": 0.2, "height": 0.6},
    }


def add_triangles(plotter, corners, normals, values, **options):
    import pyvista

    count = len(corners)
    faces = numpy.hstack([numpy.full((count, 1), 3), numpy.arange(3 * count).reshape(-1, 3)])
    skin = pyvista.PolyData(corners.reshape(-1, 3), faces.ravel())
    skin["value"] = values.ravel()
    skin.point_data.active_normals = normals.reshape(-1, 3)
    plotter.add_mesh(skin, smooth_shading=True, specular=0.3, specular_power=30, **options)


def add_names(plotter, frame):
    """Of several fluids drawn in their own colours."""
    from seiche_stage import fluid_colour

    names = frame.fluids.names
    if len(names) > 1 and not frame.known:
        plotter.add_legend([[name, fluid_colour(n)] for n, name in enumerate(names)], bcolor=None,
                           face="rectangle", size=(0.14, 0.05 * len(names)), loc="upper right")


def draw(stage, frame, filename):
    """One Frame of a Stage3D as a PNG file."""
    import pyvista

    from seiche_scenery import Scenery
    from seiche_stage import BALL

    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    skin, inside, drops = stage.skin(frame), stage.bodies(frame), stage.drops(frame)
    for fluid in range(len(frame.fluids.names)):
        colours = colours_of(stage, frame, fluid)
        corners, normals, values = (part[skin[3] == fluid] for part in skin[:3])
        if len(corners):
            clear = CLEAR if (inside[2] > fluid).any() else 1.0
            add_triangles(plotter, corners, normals, values, opacity=clear, **colours)
        corners, normals = (part[inside[2] == fluid] for part in inside[:2])
        if len(corners):
            add_triangles(plotter, corners, normals, numpy.zeros(corners.shape[:2]), **colours)
        centres, radii, values = (part[drops[3] == fluid] for part in drops[:3])
        if len(centres):
            cloud = pyvista.PolyData(centres)
            cloud["value"], cloud["size"] = values, BALL * radii
            ball = pyvista.Sphere(radius=1.0, theta_resolution=12, phi_resolution=8)
            plotter.add_mesh(cloud.glyph(geom=ball, scale="size", orient=False), **colours)
    add_names(plotter, frame)
    for low, high in list(frame.walls.obstacles) + stage.pistons(frame.walls, stage.thickness):
        bounds = [v for pair in zip(low, high) for v in pair]
        plotter.add_mesh(pyvista.Box(bounds), color="lightgray", show_edges=True)
    if len(frame.walls.solids):
        scenery = Scenery(frame.walls, stage.low, stage.high, stage.eye)
        for (corners, normals), opacity in ((scenery.bodies, 1.0), (scenery.shells, GLASS)):
            if len(corners):
                add_triangles(plotter, corners, normals, numpy.zeros(corners.shape[:2]),
                              color="lightgray", opacity=opacity)
    tank = pyvista.Box([v for pair in zip(stage.low, stage.high) for v in pair])
    plotter.add_mesh(tank, style="wireframe", color="black", line_width=1)
    plotter.add_text("t = %.3f s" % frame.time, color="black", font_size=12)
    plotter.show_bounds(bounds=tank.bounds, color="black", xtitle="x [m]", ytitle="y [m]",
                        ztitle="z [m]", font_size=10, location="outer", ticks="outside")
    plotter.set_background("white")
    centre = 0.5 * (stage.low + stage.high)
    plotter.camera_position = [centre + stage.eye, centre, (0, 0, 1)]
    plotter.reset_camera()
    plotter.screenshot(filename)
    plotter.close()
