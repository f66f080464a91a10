// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_grid_divided_simplex_h
#define seiche_grid_divided_simplex_h

#include <seiche/grid/cell_simplices.h>

namespace seiche
{
  /// A simplex in two parts, where its function is negative (inside) and where
  /// it is not; vertices inside come first. @p simplex must outlive the object.
  template <int dim>
  struct DividedSimplex
  {
    explicit DividedSimplex(const CellSimplex<dim> &simplex)
      : simplex(simplex)
    {
      for (unsigned int v = 0; v <= dim; ++v)
        if (simplex.values[v] < 0.)
          order[n_inside++] = v;
        else
          order[dim - n_outside++] = v;
    }

    const dealii::Point<dim> &
    vertex(const unsigned int i) const
    {
      return simplex.vertices[order[i]];
    }

    /// Where the function vanishes between two vertices.
    dealii::Point<dim>
    zero(const unsigned int inside, const unsigned int outside) const
    {
      const double a = simplex.values[order[inside]],
                   b = simplex.values[order[outside]];
      return vertex(inside) + a / (a - b) * (vertex(outside) - vertex(inside));
    }

    unsigned int n_inside = 0, n_outside = 0;

  private:
    const CellSimplex<dim>           &simplex;
    std::array<unsigned int, dim + 1> order;
  };
} // namespace seiche

#endif
