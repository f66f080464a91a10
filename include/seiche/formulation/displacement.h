// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_displacement_h
#define seiche_formulation_displacement_h

#include <seiche/formulation/formulation.h>

namespace seiche
{
  /**
   * @brief The irreducible form: displacement alone, p = -kappa (J - 1).
   *
   * doc/theory.md (4.1); founding paper, section 4.2, with the
   * sign of the pressure put right.
   */
  template <int dim>
  class Displacement : public Formulation<dim>
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

    /// p = -kappa (J - 1).
    void
    update_points(PointCloud<dim> &points,
                  const bool       volume_from_pressure) const override;

  private:
    template <int degree>
    void
    add_residual(CellData<dim, degree> &cell) const;
    template <int degree>
    void
    add_tangent(CellData<dim, degree> &cell) const;
  };
} // namespace seiche

#endif
