// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_point_kinematics_h
#define seiche_formulation_point_kinematics_h

#include <seiche/formulation/cell_data.h>

namespace seiche
{
  /**
   * @brief Kinematics at several quadrature points.
   *
   * Configuration t: x_n + theta u (forces); configuration 1: x_n + u
   * (constraint). Notation of doc/theory.md, section 2: f_t = I + theta H, H =
   * grad_n u, grad_t N = f_t^-T grad_n N.
   */
  template <int dim, int degree>
  struct PointKinematics : PointBatch<dim, degree>
  {
    using Base = PointBatch<dim, degree>;
    using Base::gradient;
    using Base::gradient_n;
    using Base::n_nodes;
    using Shape = typename Base::Shape;

    alignas(64) Lanes gradient_t[dim][n_nodes]; ///< [1/m]
    Lanes                         det_t = 1.;
    dealii::Tensor<2, dim, Lanes> H; ///< grad_n u [-]

    /// [1/m], if asked for with evaluate_gradient_1().
    alignas(64) Lanes gradient_1[dim][n_nodes];

    /// Second derivatives of N in configuration t [1/m^2], if asked for with
    /// evaluate_second_derivatives().
    alignas(64) Lanes second[degree > 1 ? dim : 1][degree > 1 ? dim : 1]
                            [degree > 1 ? n_nodes : 1];

    /// Evaluate at quadrature point q of the cell.
    void
    evaluate(const CellData<dim, degree> &cell, const unsigned int q)
    {
      const auto unit = cell.quadrature.template point<Lanes>(q);
      this->reinit(cell.geometry, unit);
      this->add_weights(unit);
      H              = gradient(cell.displacement);
      const auto f_t = identity_plus<dim, Lanes>(cell.coefficients.theta * H);
      det_t          = dealii::determinant(f_t);
      inverse_t      = dealii::invert(f_t);
      push_forward(inverse_t, gradient_t);
    }

    /// det f_1
    Lanes
    det_1() const
    {
      return dealii::determinant(identity_plus<dim, Lanes>(H));
    }

    void
    evaluate_gradient_1()
    {
      push_forward(dealii::invert(identity_plus<dim, Lanes>(H)), gradient_1);
    }

    /**
     * N_,jk = N_,PQ f^-1_Pj f^-1_Qk - theta N_,m u_m,PQ f^-1_Pj f^-1_Qk in the
     * configuration t (doc/theory.md (4.4a)), after evaluate() at the same
     * point.
     */
    void
    evaluate_second_derivatives(const CellData<dim, degree> &cell,
                                const unsigned int           q)
    {
      static_assert(degree > 1, "left out for FE_Q(1): doc/theory.md");
      const dealii::Point<dim, Lanes> unit =
        cell.quadrature.template point<Lanes>(q);
      for (unsigned int a = 0; a < n_nodes; ++a)
        {
          dealii::Tensor<2, dim, Lanes> reference;
          for (unsigned int P = 0; P < dim; ++P)
            for (unsigned int Q = 0; Q < dim; ++Q)
              reference[P][Q] =
                Shape::second_derivative(unit, a, P, Q) /
                (cell.geometry.edges[P] * cell.geometry.edges[Q]);
          const dealii::Tensor<2, dim, Lanes> pushed =
            transpose(inverse_t) * reference * inverse_t;
          for (unsigned int j = 0; j < dim; ++j)
            for (unsigned int k = 0; k < dim; ++k)
              second[j][k][a] = pushed[j][k];
        }
      for (unsigned int j = 0; j < dim; ++j)
        for (unsigned int k = 0; k < dim; ++k)
          {
            const dealii::Tensor<1, dim, Lanes> curvature = // of u
              cell.coefficients.theta * sum(cell.displacement, second[j][k]);
            for (unsigned int a = 0; a < n_nodes; ++a)
              for (unsigned int m = 0; m < dim; ++m)
                second[j][k][a] -= gradient_t[m][a] * curvature[m];
          }
    }

    /// sum_a weights_a nodal_a of a nodal vector.
    static dealii::Tensor<1, dim, Lanes>
    sum(const double (&nodal)[dim][n_nodes], const Lanes (&weights)[n_nodes])
    {
      dealii::Tensor<1, dim, Lanes> result;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int a = 0; a < n_nodes; ++a)
          result[i] += weights[a] * nodal[i][a];
      return result;
    }

  private:
    dealii::Tensor<2, dim, Lanes> inverse_t; ///< f_t^-1

    void
    push_forward(const dealii::Tensor<2, dim, Lanes> &inverse,
                 Lanes (&result)[dim][n_nodes]) const
    {
      for (unsigned int k = 0; k < dim; ++k)
        for (unsigned int a = 0; a < n_nodes; ++a)
          {
            Lanes sum = 0.;
            for (unsigned int j = 0; j < dim; ++j)
              sum += gradient_n[j][a] * inverse[j][k];
            result[k][a] = sum;
          }
    }
  };
} // namespace seiche

#endif
