// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_utilities_shape_functions_h
#define seiche_utilities_shape_functions_h

#include <deal.II/base/point.h>

namespace seiche
{
  /**
   * @brief The multilinear shape functions of FE_Q(1) in closed form.
   *
   * Node i of the unit cell sits at the corner whose coordinate d is bit d of
   * i: lexicographic, which for degree one is also deal.II's order. All loops
   * have fixed bounds, so that a caller's loop over points vectorises.
   */
  template <int dim>
  struct LinearShape
  {
    static constexpr unsigned int n_nodes = 1u << dim;

    /// Coordinate d (0 or 1) of node i in the unit cell.
    static constexpr unsigned int
    corner(const unsigned int i, const unsigned int d)
    {
      return (i >> d) & 1u;
    }

    /// Values N [n_nodes] at @p unit in the unit cell.
    static void
    values(const dealii::Point<dim> &unit, double N[])
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        {
          N[i] = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            N[i] *= corner(i, d) ? unit[d] : 1. - unit[d];
        }
    }

    /// Values N [n_nodes] and derivatives dN [n_nodes][dim] with respect to
    /// the coordinates of the unit cell; divide by the cell's extent for
    /// gradients in [1/m].
    static void
    evaluate(const dealii::Point<dim> &unit, double N[], double dN[][dim])
    {
      values(unit, N);
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int d = 0; d < dim; ++d)
          {
            dN[i][d] = corner(i, d) ? 1. : -1.;
            for (unsigned int e = 0; e < dim; ++e)
              if (e != d)
                dN[i][d] *= corner(i, e) ? unit[e] : 1. - unit[e];
          }
    }

    /// The same for @p n_lanes points at once: unit [dim][n_lanes] ->
    /// N [n_nodes][n_lanes], dN [n_nodes][dim][n_lanes].
    template <unsigned int n_lanes>
    static void
    evaluate_lanes(const double unit[][n_lanes],
                   double       N[][n_lanes],
                   double       dN[][dim][n_lanes])
    {
      for (unsigned int i = 0; i < n_nodes; ++i)
        for (unsigned int l = 0; l < n_lanes; ++l)
          {
            double factor[dim];
            double value = 1.;
            for (unsigned int d = 0; d < dim; ++d)
              {
                factor[d] = corner(i, d) ? unit[d][l] : 1. - unit[d][l];
                value *= factor[d];
              }
            N[i][l] = value;
            for (unsigned int d = 0; d < dim; ++d)
              {
                double slope = corner(i, d) ? 1. : -1.;
                for (unsigned int e = 0; e < dim; ++e)
                  if (e != d)
                    slope *= factor[e];
                dN[i][d][l] = slope;
              }
          }
    }
  };
} // namespace seiche

#endif
