// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_point_kinematics_h
#define seiche_formulation_point_kinematics_h

#include <seiche/formulation/cell_data.h>

namespace seiche
{
  /**
   * @brief Shape functions and kinematics at one quadrature point.
   *
   * Configuration t: x_n + theta u (forces); configuration 1: x_n + u
   * (constraint). Notation of doc/theory.md: f_t = I + theta H, H = grad_n u,
   * grad_t N = f_t^-T grad_n N.
   */
  template <int dim>
  struct PointKinematics
  {
    static constexpr unsigned int n_nodes = CellData<dim>::n_nodes;

    alignas(64) double N[n_nodes];
    alignas(64) double gradient_n[dim][n_nodes]; ///< [1/m]
    alignas(64) double gradient_t[dim][n_nodes]; ///< [1/m]
    alignas(64) double gradient_1[dim][n_nodes]; ///< [1/m], if asked for
    double det_t = 1., det_1 = 1.;

    /// Value of a nodal field.
    double
    value(const double (&nodal)[n_nodes]) const
    {
      double sum = 0.;
      for (unsigned int a = 0; a < n_nodes; ++a)
        sum += N[a] * nodal[a];
      return sum;
    }

    dealii::Tensor<1, dim>
    value(const double (&nodal)[dim][n_nodes]) const
    {
      dealii::Tensor<1, dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = value(nodal[i]);
      return result;
    }

    /// Gradient of a nodal scalar with given gradients of the N.
    static dealii::Tensor<1, dim>
    gradient(const double (&nodal)[n_nodes], const double (&grad)[dim][n_nodes])
    {
      dealii::Tensor<1, dim> result;
      for (unsigned int j = 0; j < dim; ++j)
        {
          double sum = 0.;
          for (unsigned int a = 0; a < n_nodes; ++a)
            sum += grad[j][a] * nodal[a];
          result[j] = sum;
        }
      return result;
    }

    /// (grad v)_ij = dv_i/dx_j of a nodal vector.
    static dealii::Tensor<2, dim>
    gradient(const double (&nodal)[dim][n_nodes],
             const double (&grad)[dim][n_nodes])
    {
      dealii::Tensor<2, dim> result;
      for (unsigned int i = 0; i < dim; ++i)
        result[i] = gradient(nodal[i], grad);
      return result;
    }

    /// Evaluate at quadrature point q of the cell; gradient_1 only if
    /// @p with_end (tangents need it).
    void
    evaluate(const CellData<dim> &cell,
             const unsigned int   q,
             const bool           with_end)
    {
      shape(cell.quadrature.point(q), cell.extent);
      const dealii::Tensor<2, dim> H = gradient(cell.displacement, gradient_n);
      const double                 theta = cell.coefficients.theta;

      dealii::Tensor<2, dim> f_t = theta * H, f_1 = H;
      for (unsigned int i = 0; i < dim; ++i)
        {
          f_t[i][i] += 1.;
          f_1[i][i] += 1.;
        }
      det_t = dealii::determinant(f_t);
      det_1 = dealii::determinant(f_1);
      push_forward(dealii::invert(f_t), gradient_t);
      if (with_end)
        push_forward(dealii::invert(f_1), gradient_1);
    }

    /// N and gradient_n only.
    void
    shape(const dealii::Point<dim> &unit, const dealii::Tensor<1, dim> &extent)
    {
      // factor[d][0/1]: the one-dimensional shape functions
      double factor[dim][2];
      for (unsigned int d = 0; d < dim; ++d)
        {
          factor[d][1] = unit[d];
          factor[d][0] = 1. - factor[d][1];
        }
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          N[a] = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            N[a] *= factor[d][LinearShape<dim>::corner(a, d)];
          for (unsigned int d = 0; d < dim; ++d)
            {
              double slope =
                (LinearShape<dim>::corner(a, d) ? 1. : -1.) / extent[d];
              for (unsigned int e = 0; e < dim; ++e)
                if (e != d)
                  slope *= factor[e][LinearShape<dim>::corner(a, e)];
              gradient_n[d][a] = slope;
            }
        }
    }

  private:
    void
    push_forward(const dealii::Tensor<2, dim> &inverse,
                 double (&result)[dim][n_nodes]) const
    {
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            double sum = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              sum += gradient_n[j][a] * inverse[j][k];
            result[k][a] = sum;
          }
    }
  };
} // namespace seiche

#endif
