// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_divided_simplex_h
#define seiche_space_divided_simplex_h

#include <seiche/space/cell_simplices.h>

#include <algorithm>

namespace seiche
{
  /// A simplex in two parts, where its function is negative (inside) and where
  /// it is not; vertices inside come first. @p simplex must outlive the object.
  template <int dim, int k = dim>
  struct DividedSimplex
  {
    using Vertices = std::array<dealii::Point<dim>, k + 1>;

    explicit DividedSimplex(const CellSimplex<dim, k> &simplex)
      : simplex(simplex)
    {
      for (unsigned int v = 0; v <= k; ++v)
        if (simplex.values[v] < 0.)
          order[n_inside++] = v;
        else
          order[k - n_outside++] = v;
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

    /// action(vertices) on simplices that make up the inside.
    template <typename Action>
    void
    for_each_inside(const Action &action) const
    {
      if (n_inside == k + 1)
        action(simplex.vertices);
      else if (n_inside == 1)
        action(corner_inside());
      else if (n_inside > 1)
        {
          const auto [lower, upper] = prism_inside();
          for (unsigned int i = 0; i < k; ++i)
            {
              Vertices piece; // from vertex i of one end to i of the other
              std::copy(lower.begin() + i, lower.end(), piece.begin());
              std::copy_n(upper.begin(), i + 1, piece.begin() + k - i);
              action(piece);
            }
        }
    }

    unsigned int n_inside = 0, n_outside = 0;

  private:
    /// The only vertex inside and the zeros next to it.
    Vertices
    corner_inside() const
    {
      Vertices result;
      result[0] = vertex(0);
      for (unsigned int v = 1; v <= k; ++v)
        result[v] = zero(0, v);
      return result;
    }

    /// With more vertices inside that part is a prism between two ends: at the
    /// vertices inside and opposite to them, in 3D with two of them one at
    /// each.
    std::array<std::array<dealii::Point<dim>, k>, 2>
    prism_inside() const
    {
      std::array<std::array<dealii::Point<dim>, k>, 2> ends;
      if (n_inside == k)
        for (unsigned int v = 0; v < k; ++v)
          {
            ends[0][v] = vertex(v);
            ends[1][v] = zero(v, k);
          }
      else
        for (unsigned int v = 0; v < 2; ++v)
          {
            ends[v][0] = vertex(v);
            for (unsigned int i = 1; i < k; ++i)
              ends[v][i] = zero(v, i + 1);
          }
      return ends;
    }

    const CellSimplex<dim, k>      &simplex;
    std::array<unsigned int, k + 1> order;
  };
} // namespace seiche

#endif
