// SPDX-License-Identifier: LGPL-2.1-or-later
#include <seiche/mesh/periods.h>
#include <seiche/scene/wrapped.h>

#include <cmath>

namespace seiche
{
  template <int dim>
  Periods<dim>::Periods(const GridLines<dim> &grid_lines)
    : lines(grid_lines)
    , exist(grid_lines.grid.parameters.any_periodic())
  {
    for (unsigned int d = 0; d < dim; ++d)
      periodic[d] = lines.grid.parameters.is_periodic(d);
  }



  template <int dim>
  dealii::Point<dim>
  Periods<dim>::wrapped_at_seam(const dealii::Point<dim> &x) const
  {
    dealii::Point<dim> result = x;
    for (unsigned int d = 0; d < dim; ++d)
      if (periodic[d])
        result[d] = seiche::wrapped(x[d], lines.front(d), lines.back(d));
    return result;
  }



  template <int dim>
  dealii::Tensor<1, dim>
  Periods<dim>::shortest_at_seam(const dealii::Tensor<1, dim> &x) const
  {
    dealii::Tensor<1, dim> result = x;
    for (unsigned int d = 0; d < dim; ++d)
      if (periodic[d])
        {
          const double length = lines.back(d) - lines.front(d);
          result[d] -= length * std::round(x[d] / length);
        }
    return result;
  }



  template <int dim>
  dealii::Point<dim>
  Periods<dim>::image_at_seam(const dealii::Point<dim> &x,
                              const CellGeometry<dim>  &cell) const
  {
    dealii::Point<dim> result = x;
    for (unsigned int d = 0; d < dim; ++d)
      if (periodic[d])
        {
          const double length = lines.back(d) - lines.front(d);
          const double centre = 0.5 * (cell.lower[d] + cell.upper[d]);
          result[d] -= length * std::round((x[d] - centre) / length);
        }
    return result;
  }



  template class Periods<2>;
  template class Periods<3>;
} // namespace seiche
