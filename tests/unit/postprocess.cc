// SPDX-License-Identifier: LGPL-2.1-or-later
// All postprocessors on a state whose fields are linear, so that probes and
// error norms are exact, and whose forces can be counted by hand.
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/postprocessor_list.h>
#include <seiche/utilities/exceptions.h>

#include <deal.II/base/parameter_handler.h>

#include <boost/property_tree/xml_parser.hpp>

#include <filesystem>
#include <fstream>
#include <iostream>

#include "half_full_box.h"
#include "verdict.h"

using namespace dealii;
using namespace seiche;

namespace
{
  /// Grid and postprocessors of a scene, parsed and checked.
  template <int dim>
  struct Parsed
  {
    GridParameters<dim>    grid;
    PostprocessorList<dim> postprocessors;

    explicit Parsed(const InputFile &input)
      : grid(input)
      , postprocessors(input)
    {
      ParameterHandler prm;
      double           end_time = 0.;
      grid.add_parameters(prm);
      postprocessors.add_parameters(prm);
      prm.enter_subsection("Time");
      prm.add_parameter("End time", end_time);
      prm.leave_subsection();
      input.parse_into(prm);
      grid.check(input);
    }
  };

  template <int dim>
  void
  fill_with_points(PointCloud<dim> &points)
  {
    const CellLocator<dim> &locator = points.locator;
    for (unsigned int cell = 0; cell < locator.cells.n_owned(); ++cell)
      for (unsigned int k = 0; k < (1u << dim); ++k)
        {
          Point<dim> x = locator.cells.geometry(cell).lower;
          for (unsigned int d = 0; d < dim; ++d)
            x[d] += ((k >> d & 1u) ? 0.75 : 0.25) *
                    locator.cells.geometry(cell).edges[d];
          if (x[dim - 1] < 0.5)
            points.insert((locator.lattice.index(cell) << 26) + k,
                          x,
                          exact_velocity(x),
                          point_mass,
                          locator.cells.geometry(cell).measure / (1u << dim));
        }
    points.locate();
  }

  /// Nodal fields, exact at the moved nodes; unit reactions where there is
  /// mass.
  template <int dim>
  void
  set_state(const Occupancy<dim> &occupancy,
            const double          motion,
            GridState<dim>       &state)
  {
    for (const unsigned int cell : occupancy.cells.occupied())
      for (unsigned int a = 0; a < occupancy.nodes_per_cell(); ++a)
        {
          const unsigned int node = occupancy.nodes.of_cell(cell)[a];
          if (node < occupancy.nodes.n_own())
            state.mass.local_element(node) = 1.;
        }
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      {
        const Point<dim>     x = occupancy.nodes.position(node);
        const Tensor<1, dim> u = motion * displacement(x);
        const Tensor<1, dim> v = exact_velocity(Point<dim>(x + u));
        if (state.has_pressure())
          state.pressure().local_element(node) =
            exact_pressure(Point<dim>(x + theta * u));
        for (unsigned int d = 0; d < dim; ++d)
          {
            state.displacement().local_element(dim * node + d) = u[d];
            state.velocity_np1.local_element(dim * node + d)   = v[d];
          }
      }
    // a node of an occupied cell may be owned by a rank that has none there
    state.mass.compress(VectorOperation::max);
    for (unsigned int node = 0; node < occupancy.nodes.n_own(); ++node)
      for (unsigned int d = 0; d < dim; ++d)
        state.reaction.local_element(dim * node + d) =
          state.mass.local_element(node);
    state.solution.update_ghost_values();
    state.velocity_np1.update_ghost_values();
  }

  template <int dim>
  void
  move_points(PointCloud<dim> &points)
  {
    for (std::size_t i = 0; i < points.size(); ++i)
      {
        const Point<dim>     x = points.position(i);
        const Tensor<1, dim> u = displacement(x);
        const Tensor<1, dim> v = exact_velocity(Point<dim>(x + u));
        for (unsigned int d = 0; d < dim; ++d)
          {
            points.data(PointColumn::position, d)[i] += u[d];
            points.data(PointColumn::velocity, d)[i] = v[d];
          }
        points.data(PointColumn::pressure)[i] =
          exact_pressure(Point<dim>(x + theta * u));
        points.data(PointColumn::volume_ratio)[i] = 0.96 * 1.02;
      }
  }

  /// Number of points of a VTU file; throws if it is no XML or lacks the list
  /// of its cells.
  unsigned int
  points_in_vtu(const std::string &filename)
  {
    boost::property_tree::ptree tree;
    boost::property_tree::read_xml(filename, tree);
    for (const auto &array :
         tree.get_child("VTKFile.UnstructuredGrid.Piece.Cells"))
      AssertThrow(array.first != "DataArray" || array.second.data().size() > 16,
                  ExcMessage("an empty list of cells"));
    return tree.get<unsigned int>(
      "VTKFile.UnstructuredGrid.Piece.<xmlattr>.NumberOfPoints");
  }

  /// What the program found: columns, ledger and scores.
  Numbers
  all_numbers(const StatisticsTable        &statistics,
              const nlohmann::ordered_json &summary)
  {
    Numbers numbers;
    for (const std::string &column : statistics.names())
      numbers[column] = statistics.last(column);
    for (const auto &[key, value] : summary["ledger"].items())
      if (value.is_array())
        for (unsigned int d = 0; d < value.size(); ++d)
          numbers["ledger " + key + " " + axes[d]] =
            value[d].template get<double>();
      else
        numbers["ledger " + key] =
          value.is_null() ? NAN : value.template get<double>();
    for (const auto &[key, value] : summary["errors"].items())
      numbers["errors " + key] = value.template get<double>();
    return numbers;
  }



  /// The postprocessor that a number is of.
  std::string
  kind(const std::string &name)
  {
    const std::string first = name.substr(0, name.find(' '));
    for (const char *kind : {"front",
                             "gauge",
                             "depth",
                             "probe",
                             "point",
                             "force",
                             "moment",
                             "error",
                             "errors",
                             "ledger"})
      if (first == kind)
        return first;
    return "totals";
  }



  void
  compare(const Numbers &found, const Numbers &expected)
  {
    std::map<std::string, unsigned int> n_right, n_all;
    for (const auto &[name, value] : found)
      if (expected.count(name) == 0)
        std::cout << "  without an exact value: " << name << " about "
                  << std::round(1000. * value) / 1000. << '\n';
    for (const auto &[name, value] : expected)
      {
        const bool is_there = found.count(name) > 0;
        const bool right = is_there && std::abs(found.at(name) - value) < 1e-10;
        ++n_all[kind(name)];
        n_right[kind(name)] += right;
        if (!right)
          std::cout << "  NOT " << name << " = " << value << ", but "
                    << (is_there ? std::to_string(found.at(name)) : "none")
                    << '\n';
      }
    std::cout << "  as counted by hand:";
    for (const auto &[kind, n] : n_all)
      std::cout << ' ' << kind << ' ' << n_right[kind] << " of " << n << ';';
    std::cout << '\n';
  }



  template <int dim>
  void
  run(const bool with_pressure)
  {
    const MPI_Comm communicator = MPI_COMM_WORLD;
    const bool     first = Utilities::MPI::this_mpi_process(communicator) == 0;
    const std::string name = "scene" + std::to_string(dim) + "d";
    if (first)
      {
        std::ofstream(name + ".prm") << scene<dim>();
        std::filesystem::create_directory(name);
      }
    MPI_Barrier(communicator);

    const InputFile           input(name + ".prm", {});
    Parsed<dim>               parsed(input);
    auto                     &postprocessors = parsed.postprocessors;
    const BackgroundGrid<dim> grid(parsed.grid, communicator);
    postprocessors.check(parsed.grid, /*end_time=*/1., {"time [s]"}, {});
    postprocessors.make(name, grid, communicator);

    const CellLocator<dim> locator(grid);
    PointCloud<dim>        points(locator, {}, communicator);
    fill_with_points(points);
    Occupancy<dim> occupancy(locator, 1);
    occupancy.update(points);
    Fill<dim> fill(occupancy, QuadratureRule::cut_cells);
    fill.update(points);

    GridState<dim>  state;
    StatisticsTable statistics("");
    postprocessors.request_columns(statistics);
    for (unsigned int step = 0; step < 3; ++step)
      {
        // the second step is a repetition of the first, from the same start
        if (step == 1)
          move_points(points);
        state.reinit(occupancy, with_pressure, false);
        set_state(occupancy, step == 0 ? 0. : 1., state);
        StepView<dim> view(points, fill, state);
        view.step             = step;
        view.time             = time_step * step;
        view.dt               = step == 0 ? 0. : time_step;
        view.pressure_time    = step == 0     ? 0. :
                                with_pressure ? time_step * (step - 0.5) :
                                                time_step * step;
        view.gravity[dim - 1] = -gravity;
        view.theta            = theta;
        view.pressure_theta   = with_pressure ? theta : 1.;
        view.half_spacing     = 0.0625;
        statistics.set("time [s]", view.time);
        statistics.set("dt [s]", view.dt);
        statistics.set("pressure_time [s]", view.pressure_time);
        postprocessors.execute(view, statistics);
        statistics.end_row();
      }
    nlohmann::ordered_json summary;
    postprocessors.finish(statistics, summary);
    if (!first)
      return;

    std::cout << (with_pressure ? "mixed " : "irreducible ") << dim << "D\n";
    compare(all_numbers(statistics, summary), by_hand<dim>(with_pressure));

    unsigned int n_points = 0, n_corners = 0, n_frames = 0;
    for (const auto &entry : std::filesystem::directory_iterator(name))
      {
        const std::string file = entry.path().filename().string();
        if (file.find("points_000002") == 0 &&
            entry.path().extension() == ".vtu")
          n_points += points_in_vtu(entry.path().string());
        if (file.find("grid_000002") == 0 && entry.path().extension() == ".vtu")
          n_corners += points_in_vtu(entry.path().string());
        n_frames += entry.path().extension() == ".h5";
      }
    // four corners of each cell that is wet, as many points as there are
    const unsigned int n = Totals<dim>(0.).n_points;
    std::cout << "  last frame: all points " << verdict(n_points == n)
              << ", corners of wet cells " << verdict(n_corners == n)
              << "; HDF5 frames " << n_frames << '\n'
              << std::endl;
    std::filesystem::remove_all(name);
  }



  /// What is said about an entry that makes no sense.
  void
  show_message(const std::string &override_entry)
  {
    std::string text = "accepted";
    try
      {
        const InputFile input("scene2d.prm", {override_entry});
        Parsed<2>       parsed(input);
        parsed.postprocessors.check(parsed.grid,
                                    /*end_time=*/1.,
                                    {"time [s]"},
                                    {});
      }
    catch (const InputError &error)
      {
        text = error.what();
      }
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::cout << override_entry << " -> " << text << std::endl;
  }
} // namespace

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  run<2>(true);
  run<3>(true);
  run<2>(false);
  for (const char *entry : {"Force box/Walls = left, bottem",
                            "Force box/Walls = left, left",
                            "Force box/Face = top",
                            "Probe inside/Position = 2, 0.3",
                            "Probe inside/Position = 0.9, 0.9",
                            "Probe sensor/Diameter = 0.8",
                            "Gauge middle/Position = -1, 0",
                            "Error p nodes/Scale = 0",
                            "Error p off/Region upper = 0, 0.5",
                            "Score inside/Column = probe inside presure [Pa]",
                            "Front right/Direction = z"})
    show_message(entry);
}
