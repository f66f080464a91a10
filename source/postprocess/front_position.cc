// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/front_position.h>
#include <seiche/utilities/over_ranks.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  FrontParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Direction",
                      direction,
                      "Axis along which the front moves.",
                      Patterns::Selection(dim == 2 ? "x|y" : "x|y|z"));
    prm.add_parameter("Sense",
                      sense,
                      "End of the fluid: the one of the largest or of the "
                      "smallest coordinate.",
                      Patterns::Selection("upper|lower"));
    prm.add_parameter("Least height",
                      least_height,
                      "Only fluid from this height on counts, above the "
                      "bottom of the domain at the start; 0: all. [m]",
                      Patterns::Double(0.));
  }

  template <int dim>
  void
  FrontParameters<dim>::check(const InputFile           &input,
                              const GridParameters<dim> &box) const
  {
    input.require(least_height <=
                    box.upper_corner[dim - 1] - box.lower_corner[dim - 1],
                  std::string(kind) + " " + name + "/Least height",
                  "no fluid can be higher than the domain.");
    input.require(!box.is_periodic(axis()),
                  std::string(kind) + " " + name + "/Direction",
                  "the sides across it are periodic: fluid has no end along "
                  "it.");
  }

  template <int dim>
  std::vector<std::string>
  FrontParameters<dim>::columns() const
  {
    return {"front " + name + " [m]"};
  }

  template <int dim>
  unsigned int
  FrontParameters<dim>::axis() const
  {
    return direction[0] - 'x';
  }

  template <int dim>
  double
  FrontParameters<dim>::sign() const
  {
    return sense == "upper" ? 1. : -1.;
  }

  template <int dim>
  FrontPosition<dim>::FrontPosition(const std::vector<Parameters>   &parameters,
                                    const PostprocessorContext<dim> &context)
    : fronts(parameters)
    , box(context.grid.parameters)
    , extent(context.extent)
  {}

  template <int dim>
  void
  FrontPosition<dim>::execute(const StepView<dim> &view,
                              StatisticsTable     &statistics)
  {
    const FluidExtent<dim> &ends = extent->get(view);
    constexpr double        none = Extent<dim>::none;
    std::vector<double>     reached; // by the fluid, by spray
    for (const FrontParameters<dim> &front : fronts)
      {
        const double lowest = // a bottom that moves may sink below its start
          front.least_height > 0. ?
            box.lower_corner[dim - 1] + front.least_height :
            none;
        reached.push_back(
          ends.fluid->farthest(front.axis(), front.sign(), lowest));
        reached.push_back(
          ends.spray->farthest(front.axis(), front.sign(), lowest));
      }
    maximum_over_ranks(reached, view.points.communicator);
    for (unsigned int f = 0; f < fronts.size(); ++f)
      {
        const FrontParameters<dim> &front = fronts[f];
        const Point<dim>           &start =
          front.sign() > 0. ? box.lower_corner : box.upper_corner;
        const double farthest =
          reached[2 * f] == none ? reached[2 * f + 1] : reached[2 * f];
        statistics.set(front.columns()[0],
                       farthest == none ? start[front.axis()] :
                                          front.sign() * farthest);
      }
  }

  template struct FrontParameters<2>;
  template struct FrontParameters<3>;
  template class FrontPosition<2>;
  template class FrontPosition<3>;
} // namespace seiche
