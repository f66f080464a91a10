#!/usr/bin/env python3
# SPDX-License-Identifier: LGPL-2.1-or-later
"""Pictures and films of short runs (contrib/plot_run, contrib/pictures), the water
that they draw, and the state for ParaView.

check_pictures.py SEICHE CASE
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

try:
    import matplotlib
    import numpy
    from PIL import Image
except ImportError:
    # The Debian packages belong to Debian's own interpreter.
    if "SEICHE_SYSTEM_PYTHON" in os.environ:
        raise
    os.environ["SEICHE_SYSTEM_PYTHON"] = "1"
    os.execv("/usr/bin/python3", ["/usr/bin/python3"] + sys.argv)

matplotlib.use("Agg")
ROOT = pathlib.Path(__file__).resolve().parents[2]
CONTRIB = ROOT / "contrib"
SCENES = ROOT / "tests" / "scene"
LAYERS = ROOT / "tests" / "pictures" / "layers.prm"
sys.path.insert(0, str(CONTRIB))
from seiche_output import Run, field, read_frame  # noqa: E402
from seiche_walls import Walls  # noqa: E402
import seiche_fluids  # noqa: E402
import seiche_lattice  # noqa: E402
import seiche_pyvista  # noqa: E402
import seiche_simplices  # noqa: E402
import seiche_snapshots  # noqa: E402
import seiche_solids  # noqa: E402
import seiche_stage  # noqa: E402
import seiche_water  # noqa: E402


def simulate(seiche, folder, scene, end, interval, *settings, ranks=1):
    """Run of a scene with frames, in folder."""
    sets = ["Time/End time = %g" % end, "Output/Interval = %g" % interval,
            "Output/Test log = false", *settings]
    command = [seiche, str(SCENES / scene), "--output", folder]
    command += [word for text in sets for word in ("--set", text)]
    if ranks > 1:
        command = ["mpirun", "-n", str(ranks)] + command
    done = subprocess.run(command, capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stdout + done.stderr
    return Run(folder)


def call(script, *arguments, code=0, warned=False, **options):
    done = subprocess.run([sys.executable, str(CONTRIB / script), *arguments], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=100, **options)
    assert done.returncode == code, f"exit code {done.returncode}:\n{done.stdout}"
    assert warned or "warning" not in done.stdout, done.stdout
    return done.stdout


def picture(path):
    """Pixels [rows, columns, 3] between 0 and 1."""
    pixels = numpy.asarray(Image.open(path).convert("RGB")) / 255.0
    assert min(pixels.shape[:2]) > 200, pixels.shape
    return pixels


def share_near(pixels, colour, width=0.12):
    """Share of the picture that has about this colour."""
    return float((abs(pixels - matplotlib.colors.to_rgb(colour)).max(axis=2) < width).mean())


def last_water(run, time=None):
    time, path = run.frames("points")[-1] if time is None else \
        min(run.frames("points"), key=lambda f: abs(f[0] - time))
    points = read_frame(path)
    return seiche_water.water_of(run, time, points), points, run.walls_at(time), time


def size_of_points(points, dim):
    return float(((2.0 * field(points, "radius").astype(float))**dim).sum())


def area(water):
    return area_of(water.triangles("speed")[0])


def area_of(corners):
    a, b = corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    return float(0.5 * abs(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]).sum())


def volume(water, walls):
    """Inside the skin by the divergence theorem: right only if it is closed."""
    parts = water.skin(walls, "speed"), water.on_solids(walls, "speed")
    corners, normals = (numpy.concatenate([part[i] for part in parts]) for i in (0, 1))
    across = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    outwards = numpy.sign(numpy.einsum("ij,ij->i", across, normals.sum(axis=1)))
    return float((corners.mean(axis=1) * across * outwards[:, None]).sum() / 6.0)


def geometry(seiche, folder):
    """Parts of triangles and tetrahedra, deposits, equal times."""
    random = numpy.random.default_rng(1)
    squares = numpy.array([[[0.0, 0], [1, 0], [0, 1], [1, 1]]]).repeat(200, axis=0)
    cuts = random.normal(size=(200, 2)), random.normal(size=200)
    level = numpy.einsum("nvd,nd->nv", squares, cuts[0]) + cuts[1][:, None]
    parts = seiche_simplices.clip_triangles(*seiche_simplices.fans(squares, level))
    opposite = seiche_simplices.clip_triangles(*seiche_simplices.fans(squares, -level))
    areas = [sum(0.5 * abs(numpy.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0]))) for t in (parts, opposite)]
    assert abs(sum(areas) - 200) < 1e-9 and 20 < areas[0] < 180, areas

    cube = numpy.array([[[v >> d & 1 for d in range(3)] for v in range(8)]], float)
    level = cube.sum(axis=2) - 1.5  # the plane through six edges: a hexagon
    weights = seiche_simplices.tetrahedra()
    triangles = seiche_simplices.surface_of_tetrahedra(
        numpy.einsum("tvc,nck->ntvk", weights, cube).reshape(-1, 4, 3),
        numpy.einsum("tvc,nc->ntv", weights, level).reshape(-1, 4))
    across = 0.5 * numpy.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    assert numpy.allclose(across.sum(axis=0), 0.75, atol=1e-12), across.sum(axis=0)
    assert numpy.isclose(numpy.linalg.norm(across, axis=1).sum(), 0.75 * 3**0.5)

    places = random.random((50, 2))
    lines = [numpy.linspace(0, 1, 9)] * 2
    sums = seiche_lattice.deposit(places, numpy.full(50, 0.1), lines, numpy.arange(50.0))
    assert numpy.isclose(sums.sum(), numpy.arange(50).sum())

    # a lattice that the flow has drawn to five times its length shows no stripes
    n, d = 60, 1 / 60
    lattice = numpy.stack(numpy.meshgrid(numpy.arange(n), numpy.arange(n)), axis=-1).reshape(-1, 2)
    lattice = (lattice + 0.5) * d * (5, 0.2)
    frame = {"points": lattice, "radius [m]": numpy.full(n * n, 0.5 * d)}
    box = Walls.without_solids([0.0, 0.0], [6.0, 1.0], [], frozenset())
    water = seiche_water.Water.of_points(frame, box, 2, wide=3.0)
    inside = random.random((500, 2)) * (4.8, 0.15)
    assert (water.sample(inside)[0] < 0).all(), water.sample(inside)[0].max()

    # each frame comes up to four tenths of an interval late, the last one in time
    for n, wanted in ((51, 6), (21, 6), (17, 6), (15, 4), (13, 4), (11, 6), (5, 5), (3, 3), (1, 1)):
        late = 0.04 * random.random(n)
        frames = [(0.1 * i + (late[i] if 0 < i < n - 1 else 0), "") for i in range(n)]
        times = [t for t, _ in seiche_snapshots.equally_spaced(frames, 6)]
        assert len(times) == wanted and times[0] == 0, (n, times)
        if n > 2:
            steps = numpy.diff(times)
            assert numpy.ptp(steps) < 0.1 and times[-1] >= 0.8 * frames[-1][0], (n, times)

    for ratio, number, wanted in ((7, 6, 6), (1, 6, 3), (1, 3, 3), (0.4, 6, 2), (0.05, 6, 1), (0.7, 4, 2)):
        across, width = seiche_snapshots.arrangement(number, ratio)
        assert across == wanted and width > 0.8, (ratio, number, across, width)


def flat(seiche, folder):
    """A dam break against a step: water, obstacle, pictures, one file, messages."""
    run = simulate(seiche, folder, "dam_break.prm", 0.5, 0.1)
    water, points, _, _ = last_water(run)
    assert abs(area(water) / size_of_points(points, 2) - 1) < 0.03, area(water)
    inside, speed = water.sample(numpy.array([[0.1, 0.1]]), "speed")
    assert inside[0] < -0.25 and 0 < speed[0] < 2, (inside, speed)
    made = call("plot_run", folder).split()
    names = {os.path.basename(path) for path in made if path.endswith(".png")}
    assert {"snapshots.png", "ledger.png", "solver.png"} <= names, made
    picture(f"{folder}/pictures/snapshots.png")

    single = f"{folder}/one.png"
    call("plot_run", folder, "-o", single, "--times", "0.3", "--field", "plain")
    pixels = picture(single)
    assert 0.1 < share_near(pixels, seiche_stage.WATER) < 0.6, share_near(pixels, seiche_stage.WATER)
    text = call("plot_run", folder, "-o", f"{folder}/film.avi", "--film", code=2)
    assert "a film is a .mp4 or a .gif" in text, text
    shutil.rmtree(f"{folder}/pictures")
    made = call("pictures", folder, "--times", "0.5")
    assert "view_0.500.png" in made and "no frame" not in made, made
    for script in ("pictures", "plot_run"):
        made = call(script, folder, "--times", "0.5,7", warned=True)
        assert "no frame near t = 7 s: the nearest one, of 0.5 s" in made, made


def space(seiche, folder):
    """An obstacle on an adaptive mesh and two ranks: closed skin, views, depth, section."""
    run = simulate(seiche, folder, "obstacle_3d_adaptive.prm", 0.1, 0.1, ranks=2)
    water, points, walls, _ = last_water(run)
    ratio = volume(water, walls) / size_of_points(points, 3)
    assert abs(ratio - 1) < 0.03, ratio
    assert walls.obstacles.shape == (1, 2, 3) and numpy.allclose(walls.obstacles[0, 0], (0.6, 0.1, 0))
    made = call("pictures", folder, "--times", "0.1", "--field", "plain").split()
    assert [os.path.basename(path) for path in made] == ["view_0.100.png", "depth.png", "section.png"]
    pixels = picture(made[0])
    blue = (pixels[:, :, 2] > pixels[:, :, 0] + 0.2).mean()
    grey = (numpy.ptp(pixels, axis=2) < 0.06) & (pixels.max(axis=2) < 0.7)
    assert 0.1 < blue < 0.6 and 0.01 < grey.mean() < 0.2, (blue, grey.mean())
    picture(made[1])
    picture(made[2])


def words_of(folder, *options):
    """Of the texts in the snapshots."""
    call("plot_run", folder, "-o", f"{folder}/words.svg", *options)
    return set(re.findall("<!-- (.*?) -->", pathlib.Path(folder, "words.svg").read_text(encoding="utf-8")))


def fluids(seiche, folder):
    """Oil on water: each fluid has its part, its colour and its name, in 2D and 3D; with one
    fluid nothing is named."""
    blue, amber = seiche_stage.FLUIDS[:2]
    assert blue == seiche_stage.WATER
    flat_run = simulate(seiche, f"{folder}/2d", LAYERS, 0.02, 0.02)
    assert flat_run.fluids() == {1: "water", 2: "oil"}, flat_run.fluids()
    water, cloud, there, _ = last_water(flat_run)
    held = seiche_fluids.Fluids(flat_run, cloud, there)
    corners, _ = water.triangles("speed")
    areas = [area_of(part) for _, part in held.divided(corners)]
    assert numpy.allclose(areas, (0.5 * 0.23, 0.5 * 0.12), rtol=0.03), areas
    border = held.borders(corners)
    assert numpy.ptp(border[:, :, 0]) > 0.49 and abs(border[:, :, 1] - 0.23).max() < 0.01, border
    call("plot_run", f"{folder}/2d", "-o", f"{folder}/plain.png", "--times", "0.02")
    pixels = picture(f"{folder}/plain.png")
    shares = [share_near(pixels, colour, 0.03) for colour in (blue, amber)]
    assert shares[1] > 0.1 and abs(shares[0] - 0.23 / 0.12 * shares[1]) < 0.02, shares
    for options in ((), ("--field", "speed")):
        assert {"water", "oil"} <= words_of(f"{folder}/2d", "--times", "0.02", *options), options

    solid = simulate(seiche, f"{folder}/3d", "materials_3d.prm", 0.3, 0.3)
    assert solid.fluids() == {0: "pool", 1: "oil"}, solid.fluids()
    made = call("pictures", f"{folder}/3d", "--times", "0.3").split()
    shares = [share_near(picture(made[0]), colour, 0.2) for colour in (blue, amber)]
    assert min(shares) > 0.02, shares
    # some of the oil is inside the water
    water, cloud, there, _ = last_water(solid)
    bodies, _, numbers = seiche_fluids.Fluids(solid, cloud, there).bodies(water)
    assert len(bodies) > 50 and set(numbers) == {1}, len(bodies)

    simulate(seiche, f"{folder}/one", "dam_break.prm", 0.02, 0.02)
    assert "column" not in words_of(f"{folder}/one", "--field", "plain")


def points(seiche, folder):
    """Without a level set the water is where points fill the space."""
    flat_run = simulate(seiche, f"{folder}/2d", "dam_break.prm", 0.3, 0.1,
                        "Quadrature/Rule = material points")
    water, cloud, _, _ = last_water(flat_run)
    assert abs(area(water) / size_of_points(cloud, 2) - 1) < 0.06, area(water)
    call("plot_run", f"{folder}/2d")
    assert share_near(picture(f"{folder}/2d/pictures/snapshots.png"), seiche_stage.WATER) > 0.01
    solid = simulate(seiche, f"{folder}/3d", "obstacle_3d.prm", 0.1, 0.1, "Output/Grid = false")
    water, cloud, walls, _ = last_water(solid)
    assert abs(volume(water, walls) / size_of_points(cloud, 3) - 1) < 0.15, volume(water, walls)


def walls(seiche, folder):
    """The walls of a piston's run at each frame; those that stand still once."""
    run = simulate(seiche, f"{folder}/piston", "piston_2d.prm", 1, 0.25)
    assert len(run.frames("walls")) == 5
    for time, _ in run.frames("points"):
        there = run.walls_at(time)
        place = 0.12 * 0.5 * (1 - numpy.cos(numpy.pi * time / 2.4))
        assert numpy.allclose(there.lower, (place, 0), atol=1e-6), (time, there)
        assert numpy.allclose(there.upper, (1.2, 0.5)) and not there.open_sides
        assert numpy.allclose(there.obstacles, [[(0.8, 0), (0.9, 0.1)]])
    # the water reaches the moved piston
    water, _, there, _ = last_water(run)
    corners, _ = water.triangles("speed")
    assert abs(corners[:, :, 0].min() - there.lower[0]) < 1e-4, corners[:, :, 0].min()
    call("plot_run", f"{folder}/piston", "-o", f"{folder}/piston.png", "--times", "1")
    assert share_near(picture(f"{folder}/piston.png"), "#b5651d", 0.03) > 0.003
    still = simulate(seiche, f"{folder}/still", "dam_break.prm", 0.05, 0.01, "Walls/Top = open")
    assert len(still.frames("walls")) == 1
    assert still.walls_at(0.05).open_sides == {(1, 1)}, still.walls_at(0.05)
    os.remove(f"{folder}/still/walls.pvd")  # then the entries say it
    unseen = Run(f"{folder}/still").walls_at(0.05)
    assert unseen.open_sides == {(1, 1)}, unseen


def solids(seiche, folder):
    """Distances from pieces; water closed at walls of solids; where a solid that moves is at
    the end of the step; a body, grey, and a tank of glass in the picture."""
    random = numpy.random.default_rng(1)
    ends = numpy.linspace(0, 2 * numpy.pi, 100)
    ring = 0.5 * numpy.stack([numpy.cos(ends), -numpy.sin(ends)], axis=1)
    pieces = numpy.stack([ring[1:], ring[:-1]], axis=1)  # the fluid, on their right, is outside
    measured = seiche_solids.Solids(pieces, numpy.full(2, -1.0), numpy.full(2, 1.0))
    places = random.uniform(-1, 1, (2000, 2))
    true = numpy.linalg.norm(places, axis=1) - 0.5
    found = measured.distance(places)
    near = abs(true) < 0.5 * measured.width
    assert near.any() and abs(found - true)[near].max() < 1e-3
    assert (numpy.sign(found) == numpy.sign(true))[abs(true) > 1e-3].all()

    run = simulate(seiche, f"{folder}/bowl", "solids_3d.prm", 0.04, 0.04)
    water, cloud, there, _ = last_water(run)
    assert 0.3 < there.shells.mean() < 0.9, there.shells.mean()  # the bowl; ball, slope
    assert abs(volume(water, there) / size_of_points(cloud, 3) - 1) < 0.02, volume(water, there)
    skin = water.skin(there, "speed")[0].reshape(-1, 3)
    assert there.distance(skin).min() > -0.01, there.distance(skin).min()  # a tenth of a cell
    call("plot_run", f"{folder}/bowl", "-o", f"{folder}/bowl.png", "--times", "0.04")
    pixels = picture(f"{folder}/bowl.png")
    blue = (pixels[:, :, 2] > pixels[:, :, 0] + 0.2).mean()
    grey = (numpy.ptp(pixels, axis=2) < 0.1) & (pixels.max(axis=2) < 0.85)
    assert 0.05 < blue < 0.5 and 0.05 < grey.mean() < 0.4, (blue, grey.mean())

    run = simulate(seiche, f"{folder}/free", "free_solids_3d.prm", 0.04, 0.02)
    assert len(run.frames("walls")) == 3
    for time, _ in run.frames("points")[1:]:
        there = run.walls_at(time)
        row = abs(run.statistics["time [s]"] - time).argmin()
        moved = [run.statistics["ball displacement %s [m]" % d][row] for d in "xyz"]
        # of the ball, which is turned about (0.7, 0.31, 0.27), not its middle
        pieces = there.solids[there.solids[:, :, 0].min(axis=1) > 0.5]
        middle = 0.5 * (pieces.min(axis=(0, 1)) + pieces.max(axis=(0, 1)))
        assert abs(middle - (0.7, 0.31, 0.25) - moved).max() < 0.005, (time, middle, moved)


def seams(seiche, folder):
    """Water that leaves at a periodic side is there at the other one, without a wall and
    without drops between; a pressure of round-off has no colours."""
    for dim, across in ((2, (0,)), (3, (0, 1))):
        run = simulate(seiche, f"{folder}/{dim}d", f"seam_current_{dim}d.prm", 0.1, 0.02)
        assert run.periodic() == list(across), run.periodic()
        water, cloud, there, _ = last_water(run, 0.06)
        assert {(d, side) for d in across for side in (0, 1)} <= there.open_sides
        assert not water.spray(cloud["points"]).any(), water.spray(cloud["points"]).sum()
        if dim == 2:
            beside = [[there.lower[0], 0.1], [there.upper[0], 0.1]]
            assert (water.sample(numpy.array(beside))[0] < 0).all()
            places = water.triangles("speed")[0][:, :, 0]
            assert places.min() <= there.lower[0] and places.max() >= there.upper[0]
            stage = seiche_stage.make_stage(run, run.frames("points"), "pressure")
            assert stage.name == "plain" and numpy.isclose(stage.low[0], there.lower[0])
        else:
            assert abs(volume(water, there) / size_of_points(cloud, 3) - 1) < 0.05
    call("plot_run", f"{folder}/2d", "-o", f"{folder}/seam.png", "--times", "0.06")


def film(seiche, folder):
    """A frame of the film for each frame of the run."""
    run = simulate(seiche, folder, "dam_break.prm", 0.3, 0.1)
    call("plot_run", folder, "--film", "-o", f"{folder}/film.gif")
    frames = len(run.frames("points"))
    gif = Image.open(f"{folder}/film.gif")
    assert gif.n_frames == frames, gif.n_frames
    seen = []
    for number in range(frames):
        gif.seek(number)
        seen.append(numpy.asarray(gif.convert("L"), float))
    assert all(abs(a - b).mean() > 0.1 for a, b in zip(seen, seen[1:])), "the film stands still"
    made = [path for path in call("plot_run", folder, "--film").split() if "film." in path]
    assert len(made) == 1 and os.path.getsize(made[0]) > 2000, made
    if shutil.which("ffprobe"):
        count = subprocess.run(
            ["ffprobe", "-v", "error", "-count_frames", "-show_entries", "stream=nb_read_frames",
             "-of", "csv=p=0", made[0]], capture_output=True, text=True).stdout
        assert made[0].endswith(".mp4") and int(count.strip(" ,\n")) == frames, count
    left = [name for name in os.listdir(folder) if "unfinished" in name]
    assert not left, left


def state(seiche, folder):
    """The fields that ParaView's state names are those of the frames."""
    run = simulate(seiche, folder, "dam_break.prm", 0.02, 0.01)
    text = pathlib.Path(folder, "paraview_state.py").read_text(encoding="utf-8")
    compile(text, "paraview_state.py", "exec")
    fields = set()
    for kind in ("points", "grid", "surface", "walls"):
        assert f'"{kind}"' in text, kind
        fields |= set(read_frame(run.frames(kind)[0][1]))
    assert field(read_frame(run.frames("points")[0][1]), "material") is None  # a single one
    named = set(re.findall(r'"([^"\n]*\[[^"\n]*\])"', text)) - {"speed [m/s]", "material [-]"}
    assert len(named) == 5 and named <= fields, (named, fields)


def refused(seiche, folder):
    """What cannot be drawn ends with code 2 and the reason."""
    for script in ("plot_run", "pictures"):
        assert "no directory" in call(script, folder + "/none", code=2)
    simulate(seiche, folder, "dam_break.prm", 0.02, 0)
    assert "Output/Interval" in call("pictures", folder, code=2)
    assert "Output/Interval" in call("plot_run", folder, "-o", folder + "/x.png", code=2)
    assert "Output/Interval" in call("plot_run", folder, "--film", code=2)
    call("plot_run", folder)
    assert "nothing to draw" in call("plot_run", tempfile.mkdtemp(dir=folder), code=2, warned=True)


def download(seiche, folder):
    """PyVista is not fetched unasked, nor with another answer than yes."""
    seiche_pyvista.ENVIRONMENT = os.path.join(folder, "pyvista")
    seiche_pyvista.importlib.util.find_spec = lambda name: None
    tried = []
    seiche_pyvista.subprocess.call = lambda command, **_: tried.append(command) or 1

    def refusal(answer):
        seiche_pyvista.input = lambda text: answer
        try:
            seiche_pyvista.enter_environment()
        except SystemExit as error:
            return str(error)
        raise AssertionError("went on")

    sys.stdin = open(os.devnull, encoding="ascii")
    assert "nothing is downloaded unasked" in refusal("y") and not tried
    sys.stdin.isatty = lambda: True
    assert "nothing is downloaded unasked" in refusal("") and not tried
    assert "cannot be installed" in refusal("yes") and len(tried) == 1, tried
    assert not os.listdir(folder)


def seen_by_paraview(folder):
    command = ["xvfb-run", "-a", "pvpython", f"{folder}/paraview_state.py", f"{folder}/seen.png"]
    for attempt in range(3):
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                              cwd=folder, timeout=60)
        if "bad X server connection" not in done.stdout:  # of xvfb-run beside others
            break
    assert done.returncode == 0 and "Traceback" not in done.stdout, done.stdout
    return picture(f"{folder}/seen.png")


def paraview(seiche, folder):
    """ParaView opens the state and draws water, obstacle and walls, and several fluids."""
    simulate(seiche, f"{folder}/piston", "piston_2d.prm", 0.5, 0.25)
    pixels = seen_by_paraview(f"{folder}/piston")
    coloured = (numpy.ptp(pixels, axis=2) > 0.25).mean()
    assert coloured > 0.05, coloured
    assert share_near(pixels, (0.55, 0.55, 0.55), 0.05) > 1e-4
    simulate(seiche, f"{folder}/layers", LAYERS, 0.02, 0.02)
    pixels = seen_by_paraview(f"{folder}/layers")
    shares = [share_near(pixels, seiche_stage.FLUIDS[n], 0.03) for n in (1, 2)]  # of the materials
    assert min(shares) > 0.03, shares


def main():
    seiche, case = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        globals()[case](seiche, folder)


if __name__ == "__main__":
    main()
