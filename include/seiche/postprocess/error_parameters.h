// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_postprocess_error_parameters_h
#define seiche_postprocess_error_parameters_h

#include <seiche/scene/expression.h>
#include <seiche/scene/grid_parameters.h>

#include <deal.II/base/bounding_box.h>

#include <string>
#include <vector>

namespace dealii
{
  class ParameterHandler;
}

namespace seiche
{
  class InputFile;

  /// prm entries of "Error NAME".
  template <int dim>
  struct ErrorParameters
  {
    static constexpr const char *kind = "Error";

    std::string name;
    std::string quantity = "pressure";
    std::string exact;
    std::string sample = "Gauss points";
    std::string norm   = "relative L2";
    std::string region_lower, region_upper; // empty: the domain
    bool        remove_mean = false;
    double      scale       = 1.;

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input, const GridParameters<dim> &grid) const;
    std::vector<std::string>
    columns() const;

    unsigned int
    n_components() const
    {
      return quantity == "pressure" ? 1 : dim;
    }

    /// The exact solution; InputError if it does not parse.
    Expression<dim>
    exact_solution(const InputFile           &input,
                   const GridParameters<dim> &grid) const;

    /// Box outside which nothing counts; InputError if it is none.
    dealii::BoundingBox<dim>
    region(const InputFile &input, const GridParameters<dim> &grid) const;
  };
} // namespace seiche

#endif
