// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/parameters/nearest_name.h>
#include <seiche/postprocess/run_up.h>
#include <seiche/postprocess/wall_names.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  RunUpParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter(
      "Wall",
      wall,
      "Side of the domain, or name of an obstacle or solid, on which "
      "the highest wet place is read.",
      Patterns::Anything(),
      /*has_to_be_set=*/true);
  }

  template <int dim>
  void
  RunUpParameters<dim>::check(const InputFile           &input,
                              const GridParameters<dim> &grid) const
  {
    std::vector<std::string> known = wall_names(grid);
    const std::string        hint  = nearest_hint(wall, known);
    const std::string        path  = std::string(kind) + " " + name + "/Wall";
    const auto id = std::find(known.begin(), known.end(), wall) - known.begin();
    input.require(id < static_cast<std::ptrdiff_t>(known.size()),
                  path,
                  "there is no wall \"" + wall + "\"" +
                    (hint.empty() ? "." : hint) + " Walls are " +
                    quoted_list(known) + ".");
    input.require(id >= static_cast<std::ptrdiff_t>(grid.walls.size()) ||
                    !grid.walls[id].is_side() ||
                    grid.walls[id].side().direction() != dim - 1,
                  path,
                  "water runs up walls that stand upright: name another side, "
                  "or an obstacle.");
    require_no_seam(input, grid, path, wall);
  }

  template <int dim>
  std::vector<std::string>
  RunUpParameters<dim>::columns() const
  {
    return {"run-up " + name + " [m]", "run-up " + name + " spray [m]"};
  }

  template <int dim>
  RunUp<dim>::RunUp(const std::vector<Parameters>   &parameters,
                    const PostprocessorContext<dim> &context)
    : run_ups(parameters)
    , grid(context.grid)
    , extent(context.extent)
  {
    const std::vector<std::string> names = wall_names(grid.parameters);
    for (const RunUpParameters<dim> &run_up : run_ups)
      walls.push_back(std::find(names.begin(), names.end(), run_up.wall) -
                      names.begin());
  }

  template <int dim>
  void
  RunUp<dim>::execute(const StepView<dim> &view, StatisticsTable &statistics)
  {
    const FluidExtent<dim> &ends = extent->get(view);
    const double        bottom = view.box.get_boundary_points().first[dim - 1];
    std::vector<double> heights; // of the fluid, of spray
    for (const unsigned int wall : walls)
      {
        heights.push_back(std::max(bottom, ends.fluid->wet_height(wall)));
        heights.push_back(
          std::max(heights.back(), ends.spray->wet_height(wall)));
      }
    maximum_over_ranks(heights, view.points.communicator);
    for (unsigned int r = 0; r < run_ups.size(); ++r)
      for (unsigned int c = 0; c < 2; ++c)
        statistics.set(run_ups[r].columns()[c], heights[2 * r + c]);
  }

  template struct RunUpParameters<2>;
  template struct RunUpParameters<3>;
  template class RunUp<2>;
  template class RunUp<3>;
} // namespace seiche
