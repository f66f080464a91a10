// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_formulation_h
#define seiche_formulation_formulation_h

#include <seiche/formulation/cell_data.h>
#include <seiche/formulation/stabilization.h>
#include <seiche/materials/volume_law.h>

#include <cmath>
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

  /// Ratio of viscous forces to inertia in a cell, mu c_r/(rho C_a h^2), below
  /// which the tangent leaves viscous terms out (doc/theory.md (10.3)).
  constexpr double negligible_viscosity = 1e-4;

  /// Ratio of the subscale's share in a point's displacement to the cell,
  /// theta tau1 |r|/h, below which the tangent leaves out that the gradients in
  /// the subscale's term turn with u (the same).
  constexpr double negligible_turn = 0.005;

  /**
   * @brief A weak form: residual and tangent of one cell.
   *
   * One virtual call a cell, for each element degree; the loops over
   * quadrature points and nodes are inside. Equations: doc/theory.md (4.1) to
   * (4.7); tangents (4.7a) to (4.7e).
   */
  template <int dim>
  class Formulation
  {
  public:
    Formulation(const VolumeLaw &law, const FormulationParameters &parameters)
      : volume_law(law)
      , stabilization(parameters.stabilization)
      , lumps_inertia(parameters.lumps_inertia())
    {}

    virtual ~Formulation() = default;

    /// True if the pressure is an unknown.
    virtual bool
    has_pressure() const = 0;

    /// Add to residual_u (and residual_p) of the cell; clears them first.
    virtual void
    residual(CellData<dim, 1> &cell) const = 0;
    virtual void
    residual(CellData<dim, 2> &cell) const = 0;

    /// The blocks uu (up, pu, pp): derivative of residual(); clears first.
    virtual void
    tangent(CellData<dim, 1> &cell) const = 0;
    virtual void
    tangent(CellData<dim, 2> &cell) const = 0;

    /// What orthogonal subscales project: sums over the quadrature points of
    /// V r N (residual_u [N]) and V g N (residual_p [m^dim]). Only of
    /// formulations with subscales.
    virtual void
    projected_terms(CellData<dim, 1> &cell) const
    {
      (void)cell;
      AssertThrow(false, dealii::ExcNotImplemented());
    }
    virtual void
    projected_terms(CellData<dim, 2> &cell) const
    {
      (void)cell;
      AssertThrow(false, dealii::ExcNotImplemented());
    }

    /// Columns of the points that others define: the pressure by the volume
    /// ratio, where it is no unknown; else the volume ratio by the pressure, if
    /// @p volume_from_pressure. Local.
    virtual void
    update_points(PointCloud<dim> &points,
                  const bool       volume_from_pressure) const = 0;

    /// True if the tangent has viscous terms: not where they are so small
    /// beside inertia that Newton's iteration does not miss them
    /// (doc/theory.md (10.3)).
    template <int degree>
    static bool
    tangent_is_viscous(const CellData<dim, degree> &cell)
    {
      const StepCoefficients &step = cell.coefficients;
      const double            h    = cell.geometry.shortest_edge() / degree;
      return cell.viscosity > 0. &&
             cell.viscosity * step.rate >=
               negligible_viscosity * cell.density * step.inertia * h * h;
    }

    /// [N/m^dim] Pressure gradients and momentum residuals up to here turn
    /// with u without any need for the tangent to know (doc/theory.md
    /// (10.3)).
    template <int degree>
    double
    negligible_force(const CellData<dim, degree> &cell, const Tau &tau) const
    {
      return negligible_turn * cell.geometry.shortest_edge() /
             (degree * cell.coefficients.theta * tau.momentum);
    }

    /// tau of a cell from its size, mean velocity and body force.
    template <int degree>
    Tau
    tau(const CellData<dim, degree> &cell) const
    {
      return stabilization.evaluate({cell.coefficients,
                                     cell.density,
                                     volume_law.bulk_modulus,
                                     cell.viscosity,
                                     cell.geometry.size(),
                                     degree,
                                     cell.start_speed,
                                     cell.largest_body_force()});
    }

    const VolumeLaw     volume_law; ///< of all materials
    const Stabilization stabilization;
    const bool          lumps_inertia; ///< in all cells
  };

  /// The table of formulations.
  template <int dim>
  std::unique_ptr<Formulation<dim>>
  make_formulation(const FormulationParameters &parameters,
                   const VolumeLaw             &volume_law);
} // namespace seiche

#endif
