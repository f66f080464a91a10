// SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef seiche_formulation_formulation_h
#define seiche_formulation_formulation_h

#include <seiche/constitutive/newtonian_law.h>
#include <seiche/constitutive/volume_law.h>
#include <seiche/formulation/cell_data.h>
#include <seiche/formulation/stabilization.h>

#include <cmath>
#include <memory>
#include <string>

namespace seiche
{
  /// Constants of the fluid that the weak forms read.
  struct MaterialConstants
  {
    double       density      = 0.; ///< [kg/m^3]
    double       bulk_modulus = 0.; ///< [Pa], infinity in the mixed form only
    NewtonianLaw law;
    VolumeLaw    volume_law;

    bool
    is_incompressible() const
    {
      return std::isinf(bulk_modulus);
    }

    /// Tangent viscosity [Pa s] that acts in a step with these coefficients.
    double
    viscosity(const StepCoefficients &coefficients) const
    {
      return coefficients.viscous ? law.tangent_viscosity() : 0.;
    }
  };

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
  /// which the tangent leaves viscous terms out.
  constexpr double negligible_viscosity = 1e-4;

  /// Ratio of the subscale's share in a point's displacement to the cell,
  /// theta tau1 |r|/h, below which the tangent leaves out that the gradients in
  /// the subscale's term turn with u.
  constexpr double negligible_turn = 0.005;

  /**
   * @brief A weak form: residual and tangent of one cell.
   *
   * One virtual call a cell, for each element degree; the loops over
   * quadrature points and nodes are inside. Equations: doc/theory.md,
   * section 4.
   */
  template <int dim>
  class Formulation
  {
  public:
    Formulation(const MaterialConstants     &material_constants,
                const FormulationParameters &parameters)
      : material(material_constants)
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

    /// Viscosity [Pa s] of the tangent: none where it is so small beside
    /// inertia that Newton's iteration does not miss it (doc/theory.md, section
    /// 10).
    template <int degree>
    double
    tangent_viscosity(const CellData<dim, degree> &cell) const
    {
      const StepCoefficients &step      = cell.coefficients;
      const double            viscosity = material.viscosity(step);
      const double            h         = cell.shortest_edge() / degree;
      return viscosity * step.rate < negligible_viscosity * material.density *
                                       step.inertia * h * h ?
               0. :
               viscosity;
    }

    /// [N/m^dim] Pressure gradients and momentum residuals up to here turn
    /// with u without any need for the tangent to know (doc/theory.md, section
    /// 10).
    template <int degree>
    double
    negligible_force(const CellData<dim, degree> &cell, const Tau &tau) const
    {
      return negligible_turn * cell.shortest_edge() /
             (degree * cell.coefficients.theta * tau.momentum);
    }

    /// tau of a cell from its size, mean velocity and body force.
    template <int degree>
    Tau
    tau(const CellData<dim, degree> &cell) const
    {
      return stabilization.evaluate(tau_arguments(cell.coefficients,
                                                  cell.size,
                                                  degree,
                                                  cell.start_speed,
                                                  cell.largest_body_force()));
    }

    /// The same of a cell of size @p h [m] with a speed [m/s] in its centre and
    /// a body force [m/s^2].
    TauArguments
    tau_arguments(const StepCoefficients &step,
                  const double            h,
                  const unsigned int      degree,
                  const double            speed,
                  const double            force) const
    {
      return {step,
              material.density,
              material.bulk_modulus,
              material.viscosity(step),
              h,
              degree,
              speed,
              force};
    }

    const MaterialConstants material;
    const Stabilization     stabilization;
    const bool              lumps_inertia; ///< in all cells
  };

  /// The table of formulations.
  template <int dim>
  std::unique_ptr<Formulation<dim>>
  make_formulation(const FormulationParameters &parameters,
                   const MaterialConstants     &material);
} // namespace seiche

#endif
