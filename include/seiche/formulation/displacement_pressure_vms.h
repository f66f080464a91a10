// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_displacement_pressure_vms_h
#define seiche_formulation_displacement_pressure_vms_h

#include <seiche/formulation/formulation.h>

namespace seiche
{
  /**
   * @brief The mixed form with equal-order pressure and algebraic subscales.
   *
   * doc/theory.md (4.2) to (4.4) (Codina 2000-2008; Badia and Codina 2009). The
   * pressure equation is multiplied by -1 against the paper's, so that its
   * diagonal block is positive. FE_Q(1) leaves second derivatives of the
   * velocity out: for mu c_r << rho C_a h^2 they do not change the order.
   */
  template <int dim>
  class DisplacementPressureVMS : public Formulation<dim>
  {
  public:
    using Formulation<dim>::Formulation;

    bool
    has_pressure() const override;
    void
    residual(CellData<dim, 1> &cell) const override;
    void
    residual(CellData<dim, 2> &cell) const override;
    void
    tangent(CellData<dim, 1> &cell) const override;
    void
    tangent(CellData<dim, 2> &cell) const override;
    void
    projected_terms(CellData<dim, 1> &cell) const override;
    void
    projected_terms(CellData<dim, 2> &cell) const override;
    void
    update_points(PointCloud<dim> &points,
                  const bool       volume_from_pressure) const override;

  private:
    template <int degree>
    void
    add_projected_terms(CellData<dim, degree> &cell) const;
    template <int degree>
    void
    add_residual(CellData<dim, degree> &cell) const;
    template <int degree>
    void
    add_tangent(CellData<dim, degree> &cell) const;
  };
} // namespace seiche

#endif
