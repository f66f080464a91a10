// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_point_inertia_term_h
#define seiche_formulation_point_inertia_term_h

#include <seiche/formulation/term.h>

namespace seiche
{
  /**
   * @brief Inertia of the points' own extent (doc/theory.md (6.3)).
   *
   * A point stands for a box of fluid. The inertia of the box about its centre
   * is what sum m N_a N_b leaves out: m l_d^2/12 N_a,d N_b,d, the error of one
   * point as its quadrature. By cell mean,
   *
   *     R_u += c int grad a : grad w,
   *
   * integral and gradients over the unit cell, c = factor
   * CellData::extent_inertia. A node that all points are far from has hardly
   * any mass, but this inertia against its neighbours. Uniform accelerations do
   * not see it: momentum is conserved.
   */
  struct PointInertiaTerm : Term
  {
    double factor; ///< FreeSurfaceParameters::point_inertia [-]

    explicit PointInertiaTerm(const double factor)
      : factor(factor)
    {}

    template <int dim, int degree>
    void
    add_cell_residual(CellData<dim, degree> &cell) const;

    /// The derivative with respect to u.
    template <int dim, int degree>
    void
    add_cell_tangent(CellData<dim, degree> &cell) const;
  };
} // namespace seiche

#endif
