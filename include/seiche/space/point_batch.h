// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_space_point_batch_h
#define seiche_space_point_batch_h

#include <seiche/mesh/cell_geometry.h>
#include <seiche/space/basis.h>
#include <seiche/utilities/lanes.h>

namespace seiche
{
  /**
   * @brief Shape functions, and nodal fields of a cell, at points in it: at one
   * (Number = double) or at several (Lanes).
   *
   * Whatever the points are: material points, Gauss points, sensors. Nodal
   * fields are arrays [n_nodes] or [dim][n_nodes].
   */
  template <int dim, int degree, typename Number = Lanes>
  struct PointBatch
  {
    using Shape                           = Basis<dim, degree>;
    static constexpr unsigned int n_nodes = Shape::n_nodes;

    alignas(64) Number N[n_nodes];
    alignas(64) Number gradient_n[dim][n_nodes]; ///< of N at t_n [1/m]

    /// Values only, at @p unit in the unit cell.
    void
    reinit_values(const dealii::Point<dim, Number> &unit)
    {
      Shape::values(unit, N);
    }

    /// Values and gradients.
    void
    reinit(const CellGeometry<dim>          &geometry,
           const dealii::Point<dim, Number> &unit)
    {
      Number line[dim][Shape::n_line], slope[dim][Shape::n_line];
      for (unsigned int d = 0; d < dim; ++d)
        {
          Shape::line_values(unit[d], line[d]);
          Shape::line_slopes(unit[d], slope[d]);
          const double inverse = 1. / geometry.edges[d];
          for (Number &value : slope[d])
            value *= inverse;
        }
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          N[a] = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            N[a] *= line[d][Shape::line_index(a, d)];
          for (unsigned int d = 0; d < dim; ++d)
            {
              Number derivative = slope[d][Shape::line_index(a, d)];
              for (unsigned int e = 0; e < dim; ++e)
                if (e != d)
                  derivative *= line[e][Shape::line_index(a, e)];
              gradient_n[d][a] = derivative;
            }
        }
    }

    /// The weights of weight() beside the values, which are there already.
    void
    add_weights(const dealii::Point<dim, Number> &unit)
    {
      if constexpr (degree > 1)
        Shape::bilinear_weights(unit, bilinear);
    }

    /// The weights only.
    void
    reinit_weights(const dealii::Point<dim, Number> &unit)
    {
      if constexpr (degree == 1)
        reinit_values(unit);
      add_weights(unit);
    }

    /// Share of node a in a lumped mass: positive, as N of FE_Q(1) is.
    Number
    weight(const unsigned int a) const
    {
      return degree == 1 ? N[a] : bilinear[a];
    }

    Number
    value(const double (&nodal)[n_nodes]) const
    {
      Number sum = N[0] * nodal[0];
      for (unsigned int a = 1; a < n_nodes; ++a)
        sum += N[a] * nodal[a];
      return sum;
    }

    dealii::Tensor<1, dim, Number>
    value(const double (&nodal)[dim][n_nodes]) const
    {
      dealii::Tensor<1, dim, Number> result;
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = value(nodal[i]);
      return result;
    }

    /// Gradient of a nodal scalar with given gradients of the N.
    static dealii::Tensor<1, dim, Number>
    gradient(const double (&nodal)[n_nodes], const Number (&grad)[dim][n_nodes])
    {
      dealii::Tensor<1, dim, Number> result;
      for (unsigned int j = 0; j < dim; ++j)
        {
          Number sum = 0.;
          for (unsigned int a = 0; a < n_nodes; ++a)
            sum += grad[j][a] * nodal[a];
          result[j] = sum;
        }
      return result;
    }

    /// (grad v)_ij = dv_i/dx_j of a nodal vector.
    static dealii::Tensor<2, dim, Number>
    gradient(const double (&nodal)[dim][n_nodes],
             const Number (&grad)[dim][n_nodes])
    {
      dealii::Tensor<2, dim, Number> result;
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = gradient(nodal[i], grad);
      return result;
    }

    /// grad_n of a nodal field.
    dealii::Tensor<1, dim, Number>
    gradient(const double (&nodal)[n_nodes]) const
    {
      return gradient(nodal, gradient_n);
    }
    dealii::Tensor<2, dim, Number>
    gradient(const double (&nodal)[dim][n_nodes]) const
    {
      return gradient(nodal, gradient_n);
    }

  private:
    Number bilinear[degree > 1 ? n_nodes : 1];
  };

  /// The unit tensor plus @p H.
  template <int dim, typename Number>
  dealii::Tensor<2, dim, Number>
  identity_plus(dealii::Tensor<2, dim, Number> H)
  {
    for (unsigned int d = 0; d < dim; ++d)
      H[d][d] += 1.;
    return H;
  }
} // namespace seiche

#endif
