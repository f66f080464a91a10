// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_formulation_h
#define seiche_formulation_formulation_h

#include <seiche/formulation/free_surface_parameters.h>
#include <seiche/formulation/weak_form.h>
#include <seiche/materials/volume_law.h>

#include <memory>
#include <string>

namespace seiche
{
  /// prm entries of the subsection "Formulation" beside the stabilization's.
  struct FormulationParameters
  {
    std::string             name    = "displacement-pressure";
    unsigned int            degree  = 1;
    std::string             inertia = "consistent";
    StabilizationParameters stabilization;

    void
    add_parameters(dealii::ParameterHandler &prm);
    void
    check(const InputFile &input) const;

    bool
    lumps_inertia() const
    {
      return inertia == "lumped";
    }

    bool
    is_mixed() const
    {
      return name == "displacement-pressure";
    }
  };

  /**
   * @brief The equations of a scene as sums of terms, one for each system that
   * a step solves (doc/theory.md, sections 3 and 4).
   */
  template <int dim>
  struct Formulation
  {
    VolumeLaw volume_law; ///< of all materials
    bool      lumps_inertia = false;

    /// Null where the pressure is no unknown.
    std::shared_ptr<const Stabilization> subscales;

    std::shared_ptr<const WeakForm<dim>> step;
    /// Of the start velocity; null where the pressure is no unknown.
    std::shared_ptr<const WeakForm<dim>> projection;
    std::shared_ptr<const WeakForm<dim>> consistent_start;
    /// What orthogonal subscales project, as a residual; null without them.
    std::shared_ptr<const WeakForm<dim>> residual_moments;

    /// True if the pressure is an unknown.
    bool
    has_pressure() const
    {
      return subscales != nullptr;
    }

    /// The cell's stabilization parameters, from what else it has.
    template <int degree>
    void
    set_subscales(CellData<dim, degree> &cell) const
    {
      if (!has_pressure())
        return;
      cell.tau            = subscales->evaluate({cell.coefficients,
                                                 cell.fluid,
                                                 volume_law.bulk_modulus,
                                                 cell.geometry.size(),
                                                 degree,
                                                 cell.start_speed,
                                                 cell.largest_body_force()});
      cell.residual_parts = subscales->residual_parts(cell.orthogonal);
    }

    /// Pressures of the points by their volume ratios. Local.
    void
    update_pressures(PointCloud<dim> &points) const;

    /// Volume ratios of the points by their pressures. Local.
    void
    update_volume_ratios(PointCloud<dim> &points) const;
  };

  /// A row of the table of formulations, chosen by its name.
  template <int dim>
  Formulation<dim>
  make_formulation(const FormulationParameters &parameters,
                   const FreeSurfaceParameters &free_surface,
                   const VolumeLaw             &volume_law,
                   const VolumeFactors         &factors);

  /// Displacement alone, p = -kappa phi(J): doc/theory.md (4.1); founding
  /// paper, section 4.2, with the sign of the pressure put right.
  template <int dim>
  Formulation<dim>
  make_displacement(const FormulationParameters &parameters,
                    const FreeSurfaceParameters &free_surface,
                    const VolumeLaw             &volume_law,
                    const VolumeFactors         &factors);

  /// Equal-order pressure and algebraic subscales: doc/theory.md (4.2) to (4.4)
  /// (Codina 2000-2008; Badia and Codina 2009). The pressure equation is
  /// multiplied by -1 against the papers', so that its diagonal block is
  /// positive.
  template <int dim>
  Formulation<dim>
  make_displacement_pressure(const FormulationParameters &parameters,
                             const FreeSurfaceParameters &free_surface,
                             const VolumeLaw             &volume_law,
                             const VolumeFactors         &factors);
} // namespace seiche

#endif
