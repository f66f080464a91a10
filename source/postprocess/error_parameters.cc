// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/parameters/input_file.h>
#include <seiche/postprocess/error_parameters.h>
#include <seiche/scene/entry_values.h>

#include <deal.II/base/parameter_handler.h>

namespace seiche
{
  using namespace dealii;

  template <int dim>
  void
  ErrorParameters<dim>::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Quantity",
                      quantity,
                      "Field that is compared.",
                      Patterns::Selection("pressure|velocity"));
    prm.add_parameter("Exact",
                      exact,
                      std::string("Exact solution, a function of x, y") +
                        (dim == 3 ? ", z" : "") +
                        " and t; components of the velocity are separated by "
                        "\";\". In Pa or m/s.",
                      Patterns::Anything(),
                      /*has_to_be_set=*/true);
    prm.add_parameter(
      "Sample",
      sample,
      "Where it is compared: nodes of occupied cells (weighted by mass), Gauss "
      "points of occupied cells, or the material points.",
      Patterns::Selection("nodes|Gauss points|material points"));
    prm.add_parameter(
      "Norm",
      norm,
      "rms and maximum are divided by \"Scale\"; relative L2 by the same norm "
      "of the exact solution.",
      Patterns::Selection("rms|relative L2|maximum"));
    prm.add_parameter("Region lower",
                      region_lower,
                      "Lower corner of the box that counts; empty: that of "
                      "the domain. [m]");
    prm.add_parameter("Region upper",
                      region_upper,
                      "Upper corner of the box that counts; empty: that of "
                      "the domain. [m]");
    prm.add_parameter("Remove mean",
                      remove_mean,
                      "Subtract the mean from both solutions (pressure in a "
                      "closed chamber without free surface).");
    prm.add_parameter("Scale",
                      scale,
                      "rms and maximum are divided by this, in Pa or m/s.",
                      Patterns::Double());
  }

  template <int dim>
  void
  ErrorParameters<dim>::check(const InputFile           &input,
                              const GridParameters<dim> &grid) const
  {
    input.read_only_if(norm != "relative L2",
                       std::string(kind) + " " + name + "/Scale",
                       "Norm = rms or maximum");
    input.require(scale > 0.,
                  std::string(kind) + " " + name + "/Scale",
                  "the scale must be positive.");
    region(input, grid);
    exact_solution(input, grid);
  }

  template <int dim>
  std::vector<std::string>
  ErrorParameters<dim>::columns() const
  {
    return {"error " + name + " [-]"};
  }

  template <int dim>
  Expression<dim>
  ErrorParameters<dim>::exact_solution(const InputFile           &input,
                                       const GridParameters<dim> &grid) const
  {
    return Expression<dim>(input,
                           std::string(kind) + " " + name + "/Exact",
                           exact,
                           n_components(),
                           grid.lower_corner);
  }

  template <int dim>
  BoundingBox<dim>
  ErrorParameters<dim>::region(const InputFile           &input,
                               const GridParameters<dim> &grid) const
  {
    const std::string                 section = std::string(kind) + " " + name;
    std::pair<Point<dim>, Point<dim>> corners(grid.lower_corner,
                                              grid.upper_corner);
    if (!region_lower.empty())
      corners.first = entry_values::point<dim>(input,
                                               section + "/Region lower",
                                               region_lower);
    if (!region_upper.empty())
      corners.second = entry_values::point<dim>(input,
                                                section + "/Region upper",
                                                region_upper);
    for (unsigned int d = 0; d < dim; ++d)
      input.require(corners.first[d] < corners.second[d],
                    section + (region_lower.empty() ? "/Region upper" :
                                                      "/Region lower"),
                    "the lower corner of the region must lie below its upper "
                    "corner in each direction.");
    return BoundingBox<dim>(corners);
  }

  template struct ErrorParameters<2>;
  template struct ErrorParameters<3>;
} // namespace seiche
