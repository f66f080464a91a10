// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_point_kinematics_h
#define seiche_formulation_point_kinematics_h

#include <seiche/formulation/cell_data.h>

namespace seiche
{
  /**
   * @brief Shape functions and kinematics at one quadrature point, or at
   * several (Number = Lanes).
   *
   * Configuration t: x_n + theta u (forces); configuration 1: x_n + u
   * (constraint). Notation of doc/theory.md, section 4: f_t = I + theta H, H =
   * grad_n u, grad_t N = f_t^-T grad_n N.
   */
  template <int dim, int degree, typename Number = double>
  struct PointKinematics
  {
    using Shape                           = TensorShape<dim, degree>;
    static constexpr unsigned int n_nodes = Shape::n_nodes;

    alignas(64) Number N[n_nodes];
    alignas(64) Number gradient_n[dim][n_nodes]; ///< [1/m]
    alignas(64) Number gradient_t[dim][n_nodes]; ///< [1/m]
    alignas(64) Number gradient_1[dim][n_nodes]; ///< [1/m], if asked for
    Number det_t = 1., det_1 = 1.;

    /// Second derivatives of N in configuration t [1/m^2], if asked for with
    /// evaluate_second_derivatives().
    alignas(64) Number second[degree > 1 ? dim : 1][degree > 1 ? dim : 1]
                             [degree > 1 ? n_nodes : 1];

    /// Share of node a of a lumped mass: positive, as N of FE_Q(1) is.
    Number
    lumped(const unsigned int a) const
    {
      return degree == 1 ? N[a] : hat[a];
    }

    /// Value of a nodal field.
    Number
    value(const double (&nodal)[n_nodes]) const
    {
      Number sum = 0.;
      for (unsigned int a = 0; a < n_nodes; ++a)
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

    /// Evaluate at quadrature point q of the cell; gradient_1 only if
    /// @p with_end (tangents need it).
    void
    evaluate(const CellData<dim, degree> &cell,
             const unsigned int           q,
             const bool                   with_end)
    {
      shape(cell.quadrature.template point<Number>(q), cell.extent);
      const dealii::Tensor<2, dim, Number> H =
        gradient(cell.displacement, gradient_n);
      const double theta = cell.coefficients.theta;

      dealii::Tensor<2, dim, Number> f_t = theta * H, f_1 = H;
      for (unsigned int i = 0; i < dim; ++i)
        {
          f_t[i][i] += 1.;
          f_1[i][i] += 1.;
        }
      det_t     = dealii::determinant(f_t);
      det_1     = dealii::determinant(f_1);
      inverse_t = dealii::invert(f_t);
      push_forward(inverse_t, gradient_t);
      if (with_end)
        push_forward(dealii::invert(f_1), gradient_1);
    }

    /**
     * N_,jk = N_,PQ f^-1_Pj f^-1_Qk - theta N_,m u_m,PQ f^-1_Pj f^-1_Qk in the
     * configuration t, after evaluate() at the same point.
     */
    void
    evaluate_second_derivatives(const CellData<dim, degree> &cell,
                                const unsigned int           q)
    {
      static_assert(degree > 1, "left out for FE_Q(1): doc/theory.md");
      const dealii::Point<dim, Number> unit =
        cell.quadrature.template point<Number>(q);
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          dealii::Tensor<2, dim, Number> reference;
          for (unsigned int P = 0; P < dim; ++P)
            for (unsigned int Q = 0; Q < dim; ++Q)
              reference[P][Q] = Shape::second_derivative(unit, a, P, Q) /
                                (cell.extent[P] * cell.extent[Q]);
          const dealii::Tensor<2, dim, Number> pushed =
            transpose(inverse_t) * reference * inverse_t;
          for (unsigned int j = 0; j < dim; ++j)
            for (unsigned int k = 0; k < dim; ++k)
              second[j][k][a] = pushed[j][k];
        }
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int k = 0; k < dim; ++k)
          {
            const dealii::Tensor<1, dim, Number> curvature = // of u
              cell.coefficients.theta * sum(cell.displacement, second[j][k]);
            for (unsigned int a = 0; a < n_nodes; ++a)
              for (unsigned int m = 0; m < dim; ++m)
                second[j][k][a] -= gradient_t[m][a] * curvature[m];
          }
    }

    /// sum_a weights_a nodal_a of a nodal vector.
    static dealii::Tensor<1, dim, Number>
    sum(const double (&nodal)[dim][n_nodes], const Number (&weights)[n_nodes])
    {
      dealii::Tensor<1, dim, Number> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          result[i] += weights[a] * nodal[i][a];
      return result;
    }

    /// N and gradient_n only.
    void
    shape(const dealii::Point<dim, Number> &unit,
          const dealii::Tensor<1, dim>     &extent)
    {
      Number line[dim][Shape::n_line], slope[dim][Shape::n_line];
      for (unsigned int d = 0; d < dim; ++d)
        {
          Shape::line_values(unit[d], line[d]);
          Shape::line_slopes(unit[d], slope[d]);
          const double inverse = 1. / extent[d];
          for (Number &value : slope[d])
            value *= inverse;
        }
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          N[a] = 1.;
          for (unsigned int d = 0; d < dim; ++d)
            N[a] *= line[d][Shape::place(a, d)];
          for (unsigned int d = 0; d < dim; ++d)
            {
              Number derivative = slope[d][Shape::place(a, d)];
              for (unsigned int e = 0; e < dim; ++e)
                if (e != d)
                  derivative *= line[e][Shape::place(a, e)];
              gradient_n[d][a] = derivative;
            }
        }
      if constexpr (degree > 1)
        Shape::hats(unit, hat);
    }

  private:
    dealii::Tensor<2, dim, Number> inverse_t; ///< f_t^-1
    Number                         hat[degree > 1 ? n_nodes : 1];

    void
    push_forward(const dealii::Tensor<2, dim, Number> &inverse,
                 Number (&result)[dim][n_nodes]) const
    {
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Number sum = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              sum += gradient_n[j][a] * inverse[j][k];
            result[k][a] = sum;
          }
    }
  };
} // namespace seiche

#endif
