// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/postprocess/paraview_state.h>
#include <seiche/utilities/checked_file.h>
#include <seiche/utilities/first_rank.h>
#include <seiche/utilities/result_names.h>

namespace seiche
{
  namespace
  {
    // The names of fields are those of the classes PointOutput, GridOutput and
    // WallsOutput. ParaView's own Python state, not its XML: a .pvsm holds
    // every default of one version, and absolute paths.
    constexpr char state[] =
      R"PYTHON(# The frames of this folder in ParaView (5.9 or newer): File > Load State and this file, or
#     paraview --script=paraview_state.py
#     pvpython paraview_state.py PICTURE.png
import os
import sys

from paraview.simple import *

FOLDER = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
VELOCITY, LEVEL = "velocity [m/s]", "level set [cells]"
DISPLACEMENT, RADIUS = "displacement of the step [m]", "radius [m]"
MATERIAL = "material [-]"  # of the points, with several fluids: 0 is the Fluid
FLUIDS = ([0.29, 0.61, 0.83], [0.88, 0.63, 0.19], [0.31, 0.62, 0.41], [0.60, 0.40, 0.68],
          [0.78, 0.37, 0.27], [0.52, 0.52, 0.35])
DARK, GREY = [0.04, 0.16, 0.27], [0.55, 0.55, 0.55]


def series(name):
    """The frames NAME.pvd at their last time, or None."""
    path = os.path.join(FOLDER, name + ".pvd")
    if not os.path.isfile(path):
        return None
    reader = PVDReader(registrationName=name, FileName=path)
    reader.UpdatePipeline(max(reader.TimestepValues))
    return reader


def show_grey(part, view):
    shown = Show(part, view)
    shown.ColorArrayName = ["POINTS", ""]
    shown.AmbientColor = shown.DiffuseColor = GREY


def show_walls(walls, view):
    """The tank as lines, obstacles and solids as bodies."""
    tank = Show(walls, view)
    tank.SetRepresentationType("Wireframe")
    tank.LineWidth = 2.0
    tank.ColorArrayName = ["POINTS", ""]
    tank.AmbientColor = tank.DiffuseColor = [0.3, 0.3, 0.3]
    if walls.PointData["part [-]"].GetRange()[1] > 0:
        obstacles = Threshold(registrationName="obstacles", Input=walls,
                              Scalars=["POINTS", "part [-]"])
        obstacles.LowerThreshold, obstacles.UpperThreshold = 0.5, 1e9
        show_grey(obstacles, view)
    if walls.PointData["part [-]"].GetRange()[0] < 0:
        solids = Threshold(registrationName="solids", Input=walls,
                           Scalars=["POINTS", "part [-]"])
        solids.LowerThreshold, solids.UpperThreshold = -1e9, -0.5
        show_grey(solids, view)


def moved_cells(grid):
    """The cells at the end of the step, neighbours joined."""
    joined = CleantoGrid(registrationName="joined cells", Input=grid)
    return WarpByVector(registrationName="moved cells", Input=joined,
                        Vectors=["POINTS", DISPLACEMENT])


def body_of_water(cells):
    """The skin of the part inside the free surface, smooth in three dimensions."""
    inside = Clip(registrationName="water", Input=cells, ClipType="Scalar",
                  Scalars=["POINTS", LEVEL], Value=0.0, Invert=1)
    if IS_FLAT:
        return inside
    skin = ExtractSurface(registrationName="skin", Input=inside)
    return GenerateSurfaceNormals(registrationName="smooth skin", Input=skin, FeatureAngle=50.0)


def spray(points, cells):
    """The points outside the water by more than a quarter of a cell."""
    at_points = ResampleWithDataset(registrationName="level at points", SourceDataArrays=cells,
                                    DestinationMesh=points, PassPointArrays=1)
    outside = Calculator(registrationName="outside", Input=at_points, ResultArrayName="outside",
                         Function='"%s" + 9*(1 - vtkValidPointMask)' % LEVEL)
    result = Threshold(registrationName="spray", Input=outside, Scalars=["POINTS", "outside"])
    result.LowerThreshold, result.UpperThreshold = 0.25, 1e9
    return result


def show_points(points, view):
    """As balls of their size."""
    balls = Show(points, view)
    balls.SetRepresentationType("Point Gaussian")
    balls.ScaleByArray, balls.UseScaleFunction = 1, 0
    balls.SetScaleArray = ["POINTS", RADIUS]
    balls.GaussianRadius = 1.25
    if IS_FLAT:
        balls.ShaderPreset = "Plain circle"
    if has_fluids:
        colour_by_material(points, balls, view)
    else:
        colour_by_speed(balls, view)
    return balls


def colour_by_material(points, shown, view):
    ColorBy(shown, ("POINTS", MATERIAL))
    number = int(points.PointData[MATERIAL].GetRange()[1]) + 1
    colours = GetColorTransferFunction(MATERIAL)
    colours.InterpretValuesAsCategories = 1
    colours.Annotations = [text for n in range(number) for text in (str(n), "material %d" % n)]
    colours.IndexedColors = [v for n in range(number) for v in FLUIDS[n % len(FLUIDS)]]
    bar = GetScalarBar(colours, view)
    bar.Title, bar.ComponentTitle = "fluids", ""
    shown.SetScalarBarVisibility(view, True)


def colour_by_speed(shown, view):
    ColorBy(shown, ("POINTS", VELOCITY, "Magnitude"))
    shown.SetScalarBarVisibility(view, True)


LoadPalette("WhiteBackground")
view = GetActiveViewOrCreate("RenderView")
walls, grid, surface, points = (series(n) for n in ("walls", "grid", "surface", "points"))
frames = [reader for reader in (points, grid, surface, walls) if reader]
if not frames:
    raise SystemExit("there are no frames beside " + __file__)
BOUNDS = frames[-1].GetDataInformation().GetBounds()
IS_FLAT = BOUNDS[5] - BOUNDS[4] == 0
has_level = grid is not None and LEVEL in grid.PointData.keys()
has_fluids = points is not None and MATERIAL in points.PointData.keys()

if walls:
    show_walls(walls, view)
if has_level:
    cells = moved_cells(grid)
    water = Show(body_of_water(cells), view)
    water.Specular, water.SpecularPower = 0.3, 30.0
    colour_by_speed(water, view)
    if has_fluids:  # the cells do not know them
        water.SetScalarBarVisibility(view, False)
        water.Visibility = 0
    elif points:
        show_points(spray(points, cells), view)
if surface:
    line = Show(surface, view)
    line.ColorArrayName = ["POINTS", ""]
    line.AmbientColor = line.DiffuseColor = DARK
    line.LineWidth = 2.0
    line.Visibility = int(IS_FLAT or not has_level)  # in 3D the water's skin shows it
if points:
    show_points(points, view).Visibility = int(has_fluids or not has_level)
time = AnnotateTimeFilter(registrationName="time", Input=frames[0])
time.Format = "t = {time:.3f} s"
Show(time, view).FontSize = 18

colours = GetColorTransferFunction(VELOCITY)
colours.ApplyPreset("Viridis (matplotlib)", True)
scene = GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
scene.GoToLast()
if has_level:
    water.RescaleTransferFunctionToDataRangeOverTime()
elif points:
    GetDisplayProperties(points, view).RescaleTransferFunctionToDataRangeOverTime()
bar = GetScalarBar(colours, view)
bar.Title, bar.ComponentTitle = "speed [m/s]", ""
bar.RangeLabelFormat = "%.3g"
if IS_FLAT:
    view.InteractionMode = "2D"
else:
    view.CameraPosition, view.CameraFocalPoint = [-0.8, -1.6, 1.0], [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
ResetCamera(view)
Render(view)
if sys.argv[-1].endswith(".png"):
    view.ViewSize = [1400, 800]
    SaveScreenshot(sys.argv[-1], view, ImageResolution=view.ViewSize)
)PYTHON";
  } // namespace

  template <int dim>
  ParaViewState<dim>::ParaViewState(const std::string &output_directory,
                                    const MPI_Comm     mpi_communicator)
    : directory(output_directory)
    , communicator(mpi_communicator)
  {}

  template <int dim>
  void
  ParaViewState<dim>::execute(const StepView<dim> &view,
                              StatisticsTable & /*statistics*/)
  {
    if (view.step > 0)
      return;
    on_first_rank(communicator, [&]() {
      checked_file::write(directory + "/" + result_names::paraview,
                          [](std::ostream &out) { out << state; });
    });
  }

  template class ParaViewState<2>;
  template class ParaViewState<3>;
} // namespace seiche
