# SPDX-License-Identifier: LGPL-2.1-or-later
"""Views in three dimensions drawn by PyVista, for contrib/pictures --pyvista."""

import importlib.util
import os
import subprocess
import sys

import numpy

ENVIRONMENT = os.path.normpath(
    os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "build", "pyvista"))
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


def draw(stage, frame, filename):
    """One Frame of a Stage3D as a PNG file."""
    import pyvista

    from seiche_stage import BALL, COLOURS, FIELDS, WATER

    if frame.known:
        title = FIELDS[stage.name]
        colours = {
            "scalars": "value", "clim": stage.limits, "cmap": COLOURS[stage.name],
            "scalar_bar_args": {"title": title + "\n", "color": "black", "vertical": True,
                                "position_x": 0.9, "position_y": 0.2, "height": 0.6},
        }
    else:
        colours = {"color": WATER}
    plotter = pyvista.Plotter(off_screen=True, window_size=SIZE)
    corners, normals, values = frame.water.skin(frame.walls, stage.field_of(frame))
    count = len(corners)
    if count:
        faces = numpy.hstack([numpy.full((count, 1), 3), numpy.arange(3 * count).reshape(-1, 3)])
        skin = pyvista.PolyData(corners.reshape(-1, 3), faces.ravel())
        skin["value"] = values.ravel()
        skin.point_data.active_normals = normals.reshape(-1, 3)
        plotter.add_mesh(skin, smooth_shading=True, specular=0.3, specular_power=30, **colours)
    centres, radii, values = stage.drops(frame)
    if len(centres):
        cloud = pyvista.PolyData(centres)
        cloud["value"], cloud["size"] = values, BALL * radii
        ball = pyvista.Sphere(radius=1.0, theta_resolution=12, phi_resolution=8)
        plotter.add_mesh(cloud.glyph(geom=ball, scale="size", orient=False), **colours)
    for low, high in list(frame.walls.obstacles) + stage.pistons(frame.walls, stage.thickness):
        bounds = [v for pair in zip(low, high) for v in pair]
        plotter.add_mesh(pyvista.Box(bounds), color="lightgray", show_edges=True)
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
