// SPDX-License-Identifier: LGPL-2.1-or-later
// Where the fluid ends after a step with a linear displacement: a layer whose
// surface lies between two grid lines and a drop above it, a box that is full,
// and the same points without a surface; the files of the surface.
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/fluid_extent.h>
#include <seiche/postprocess/moved_surface.h>
#include <seiche/postprocess/surface_output.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/xml_parser.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>

using namespace dealii;
using namespace seiche;

namespace
{
  constexpr unsigned int n_cells = 8;
  constexpr double       spacing = 0.5 / n_cells;
  constexpr double       depth   = 4.5 / n_cells;

  template <int dim>
  Tensor<1, dim>
  displacement(const Point<dim> &x)
  {
    Tensor<1, dim> u;
    u[0]       = -0.04 * x[0];
    u[dim - 1] = 0.02 * x[dim - 1];
    return u;
  }

  template <int dim>
  Point<dim>
  drop()
  {
    Point<dim> x;
    for (unsigned int d = 0; d < dim; ++d)
      x[d] = 0.5 * spacing + (d + 1 == dim ? 14 : 6) * spacing;
    return x;
  }

  /// Two points a direction in each cell, up to a height, and the drop.
  template <int dim>
  void
  fill_up_to(const double height, PointCloud<dim> &points)
  {
    for (unsigned int cell = 0; cell < points.locator.cells.n_owned(); ++cell)
      for (unsigned int k = 0; k < (1u << dim); ++k)
        {
          Point<dim> x = points.locator.cells.geometry(cell).lower;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] += ((k >> d & 1u) + 0.5) * spacing;
          if (x[dim - 1] < height || x.distance(drop<dim>()) < 1e-10)
            points.insert((points.locator.lattice.index(cell) << 26) + k,
                          x,
                          Tensor<1, dim>(),
                          std::pow(spacing, dim),
                          std::pow(spacing, dim));
        }
    points.locate();
  }

  /// Vertices in the first frame of the surface, all pieces of its file.
  unsigned int
  vertices_in_frame(const std::string &directory)
  {
    unsigned int result = 0;
    for (const auto &entry : std::filesystem::directory_iterator(directory))
      if (entry.path().extension() == ".vtu")
        {
          boost::property_tree::ptree tree;
          boost::property_tree::read_xml(entry.path().string(), tree);
          result += tree.get<unsigned int>(
            "VTKFile.UnstructuredGrid.Piece.<xmlattr>.NumberOfPoints");
        }
    return result;
  }

  struct Readings
  {
    double level, at_wall, left;
    double front, front_above, front_below, wet, spray, wet_spray;
    double surface_height, spray_at_lid;
    bool   all_in_file;
  };

  template <int dim>
  Readings
  read(const QuadratureRule rule, const double height)
  {
    const MPI_Comm    communicator = MPI_COMM_WORLD;
    const std::string name         = "extent" + std::to_string(dim) + "d.prm";
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      std::ofstream(name) << "set Dimension = " << dim
                          << "\nsubsection Grid\n  set Lower corner = 0, 0"
                          << (dim == 2 ? "" : ", 0")
                          << "\n  set Upper corner = 1, 1"
                          << (dim == 2 ? "" : ", 1")
                          << "\n  set Cell size = " << 1. / n_cells
                          << "\nend\n";
    MPI_Barrier(communicator);
    const InputFile     input(name, {});
    GridParameters<dim> parameters(input);
    ParameterHandler    prm;
    parameters.add_parameters(prm);
    input.parse_into(prm);
    parameters.check(input);

    const BackgroundGrid<dim> grid(parameters, communicator);
    const CellLocator<dim>    locator(grid);
    PointCloud<dim>           points(locator, {}, communicator);
    fill_up_to(height, points);
    Occupancy<dim> occupancy(locator, 1);
    occupancy.update(points);
    Fill<dim> fill(occupancy, rule);
    fill.update(points);
    GridState<dim> state;
    state.reinit(occupancy, /*has_pressure=*/true, false);
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      for (unsigned int d = 0; d < dim; ++d)
        state.displacement().local_element(dim * node + d) =
          displacement(occupancy.nodes.position(node))[d];
    state.solution.update_ghost_values();
    state.velocity_np1.update_ghost_values();
    StepView<dim> view(points, fill, state);
    view.step = 1;
    view.time = view.dt = view.pressure_time = 0.1;
    view.theta = view.pressure_theta = 1.;
    view.half_spacing                = 0.5 * spacing;

    const std::string directory = "surface" + std::to_string(dim) + "d";
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::filesystem::remove_all(directory);
        std::filesystem::create_directory(directory);
      }
    MPI_Barrier(communicator);
    StatisticsTable    statistics("");
    SurfaceOutput<dim> output({directory, 0.1, 1.}, communicator);
    output.execute(view, statistics);
    unsigned int n_vertices = 0;
    if (rule == QuadratureRule::cut_cells)
      n_vertices =
        dim * Utilities::MPI::sum(moved_surface(view).size(), communicator);
    MPI_Barrier(communicator);
    const bool all_in_file =
      vertices_in_frame(directory) == n_vertices &&
      std::filesystem::exists(directory + "/surface.pvd") == (n_vertices > 0);

    const FluidExtent<dim> extent(view);

    // a lid that has come down to a quarter of a spacing above the drop
    StepView<dim> under_lid = view;
    Point<dim> low_corner = locator.lines.domain().get_boundary_points().second;
    low_corner[dim - 1]   = drop<dim>()[dim - 1] + 0.25 * spacing;
    under_lid.box         = BoundingBox<dim>({Point<dim>(), low_corner});
    const FluidExtent<dim> extent_under_lid(under_lid);

    Point<dim> place, above_drop = drop<dim>();
    place[0]              = 0.87;
    place[dim - 2]        = 0.87;
    const auto over_ranks = [&](const double value) {
      return Utilities::MPI::max(value, communicator);
    };
    const auto   surface = extent.fluid->surface();
    const double area    = Utilities::MPI::sum(surface.area, communicator);
    Point<dim>   wall    = place; // which the fluid has left
    wall[0]              = 1.;
    return {over_ranks(extent.fluid->level(place, 0.1)),
            over_ranks(extent.fluid->level(wall, 0.1)),
            over_ranks(extent.fluid->level_left(wall)),
            over_ranks(extent.fluid->farthest(0, 1., Extent<dim>::none)),
            over_ranks(extent.fluid->farthest(0, -1., 0.5)),
            over_ranks(extent.fluid->farthest(dim - 1, -1., Extent<dim>::none)),
            over_ranks(extent.fluid->wet_height(1)),
            over_ranks(extent.spray->level(above_drop, 0.1)),
            over_ranks(extent.spray->wet_height(1)),
            Utilities::MPI::sum(surface.volume, communicator) /
              (area > 0. ? area : 1.),
            over_ranks(extent_under_lid.spray->level(above_drop, 0.1)),
            all_in_file};
  }

  bool
  is(const double value, const double expected)
  {
    return std::abs(value - expected) < 1e-9;
  }

  void
  say(const std::string &text, const bool right, const double value)
  {
    std::cout << text << ": ";
    if (right)
      std::cout << "yes\n";
    else
      std::cout << "NO, " << value << '\n';
  }

  template <int dim>
  void
  check()
  {
    const double   none  = Extent<dim>::none;
    const Readings layer = read<dim>(QuadratureRule::cut_cells, depth);
    const Readings box   = read<dim>(QuadratureRule::cut_cells, 1.);
    const Readings dots  = read<dim>(QuadratureRule::material_points, depth);
    const double   top   = 1.02 * depth;
    const double   plan  = 0.96;
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) != 0)
      return;
    const std::string in    = std::to_string(dim) + "D, ";
    const double      peak  = drop<dim>()[dim - 1] + 0.5 * spacing;
    const double      water = std::pow(spacing, dim);
    say(in + "level", is(layer.level, top), layer.level);
    say(in + "none at a wall that it has left",
        layer.at_wall == none,
        layer.at_wall);
    say(in + "what has left the wall", is(layer.left, top), layer.left);
    say(in + "front", is(layer.front, 0.96), layer.front);
    say(in + "front above a height",
        is(layer.front_above, 0.),
        layer.front_above);
    say(in + "lowest", is(layer.front_below, 0.), layer.front_below);
    say(in + "wet height", is(layer.wet, top), layer.wet);
    say(in + "spray", is(layer.spray, peak), layer.spray);
    say(in + "spray ends at the lid",
        is(layer.spray_at_lid, peak - 0.25 * spacing),
        layer.spray_at_lid);
    say(in + "no spray at the wall", layer.wet_spray == none, layer.wet_spray);
    say(in + "mean height with the drop",
        is(layer.surface_height, top + water / plan),
        layer.surface_height);
    say(in + "files of layer, full box and points",
        layer.all_in_file && box.all_in_file && dots.all_in_file,
        layer.all_in_file);
    say(in + "level of a full box", is(box.level, 1.), box.level);
    say(in + "mean height of a full box",
        is(box.surface_height, 1.),
        box.surface_height);
    say(in + "wet height of a full box", is(box.wet, 1.02), box.wet);
    say(in + "points: level", is(dots.level, depth), dots.level);
    say(in + "points: front", is(dots.front, 1.), dots.front);
    say(in + "points: wet height", is(dots.wet, depth), dots.wet);
    say(in + "points: no spray", dots.spray == none, dots.spray);
    say(in + "points: mean height",
        is(dots.surface_height, depth + water),
        dots.surface_height);
  }
} // namespace

int
main(int argc, char **argv)
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  check<2>();
  check<3>();
}
